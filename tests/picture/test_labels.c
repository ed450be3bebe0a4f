// Places of names: what they cover is counted in another way, they stay on the page, and they go where there is room.
#include "check.h"
#include <stdbool.h>
#include "picture/labels.h"

static bool is_in(YkBox box, YkVec at)
{
    return at.x > box.left && at.x < box.right && at.y > box.top && at.y < box.bottom;
}

// What a box covers, by many points: areas of boxes, lengths of lines within half a line's width, and what leaves the
// page.
static double counted(const YkLabels *labels, YkBox box)
{
    enum { SIDE = 200, ALONG = 4000 };
    double sum = 0, width = box.right - box.left, height = box.bottom - box.top, area = width * height / (SIDE * SIDE);
    for (size_t k = 0; k < labels->count; k++)
        for (int i = 0; i < SIDE; i++)
            for (int j = 0; j < SIDE; j++) {
                YkVec at = {box.left + (i + 0.5) * width / SIDE, box.top + (j + 0.5) * height / SIDE};
                sum += is_in(labels->boxes[k], at) ? 4 * area : 0;
            }
    YkBox wide = {box.left - labels->half, box.top - labels->half, box.right + labels->half, box.bottom + labels->half};
    for (size_t k = 0; k < labels->line_count; k++) {
        YkVec from = labels->lines[k][0], way = yk_sub(labels->lines[k][1], from);
        for (int i = 0; i < ALONG; i++)
            sum += is_in(wide, yk_add(from, yk_scale((i + 0.5) / ALONG, way))) ? 10 * yk_norm(way) / ALONG : 0;
    }
    double off[4] = {4 - box.left, box.right - labels->width + 4, 4 - box.top, box.bottom - labels->height + 4};
    for (int k = 0; k < 4; k++) sum += off[k] > 0 ? 100 * off[k] : 0;
    return sum;
}

// The distance of a box from a point; how many steps of 9 px it is further away than it has to be is part of the price.
static int ring_of(YkBox box, YkVec at, double reach)
{
    YkVec middle = {(box.left + box.right) / 2, (box.top + box.bottom) / 2}, off = yk_sub(middle, at);
    double half[2] = {(box.right - box.left) / 2, (box.bottom - box.top) / 2}, best = INFINITY;
    int ring = -1;
    for (int k = 0; k < 4; k++) { // on the ellipse of this distance
        double far = reach + 2 + 9.0 * k, miss = fabs(hypot(off.x / (far + half[0]), off.y / (far + half[1])) - 1);
        if (miss < best) best = miss, ring = k;
    }
    CHECK_NEAR(best, 0, 1e-12);
    return ring;
}

static void the_price_is_what_is_covered(void **state)
{
    (void)state;
    uint64_t seed = 31;
    static YkLabels labels;
    YkVec lines[6][2];
    size_t free_places = 0;
    for (size_t trial = 0; trial < check_cases(60); trial++) {
        labels = (YkLabels){.lines = lines, .line_count = trial % 7, .half = 1.5, .width = 300, .height = 200};
        for (size_t k = 0; k < labels.line_count; k++)
            for (int end = 0; end < 2; end++)
                lines[k][end] = yk_vec(check_uniform(&seed, 0, 300), check_uniform(&seed, 0, 200));
        if (trial % 5 == 1) lines[0][1].x = lines[0][0].x; // upright
        for (size_t k = 0; k < trial % 9; k++) {
            YkVec middle = {check_uniform(&seed, 0, 300), check_uniform(&seed, 0, 200)};
            yk_labels_take(&labels, yk_box_at(middle, check_uniform(&seed, 10, 90), check_uniform(&seed, 10, 60)));
        }
        YkVec at = {check_uniform(&seed, 0, 300), check_uniform(&seed, 0, 200)};
        double price, reach = check_uniform(&seed, 0, 10);
        YkBox box = yk_labels_find(&labels, at, reach, 40, 14, &price);
        CHECK_NEAR(box.right - box.left, 40, 1e-12);
        CHECK_NEAR(box.bottom - box.top, 14, 1e-12);

        double expected = counted(&labels, box) + 12 * ring_of(box, at, reach);
        CHECK_NEAR(price, expected, 1 + 0.03 * expected);
        free_places += price == 0;
        for (int k = 0; k < 12; k++) { // no dearer than others at its distances
            double far = reach + 2 + 9.0 * (k % 4), way = -YK_PI / 4 + YK_PI / 2 * (k / 4);
            YkVec middle = {at.x + cos(way) * (far + 20), at.y + sin(way) * (far + 7)};
            assert_true(price <= counted(&labels, yk_box_at(middle, 40, 14)) * 1.03 + 1 + 12 * (k % 4));
        }
    }
    assert_true(free_places > check_cases(60) / 5);
}

static void names_round_one_point_do_not_cover_each_other(void **state)
{
    (void)state;
    static YkLabels labels;
    labels = (YkLabels){.half = 1, .width = 400, .height = 400};
    for (int k = 0; k < 6; k++) {
        double price;
        YkBox box = yk_labels_find(&labels, yk_vec(200, 200), 4, 30, 12, &price);
        if (k == 0)
            assert_true(price == 0 && box.left + box.right > 400 &&
                        box.bottom < 200); // the first place is above, to the right
        for (size_t i = 0; i < labels.count; i++) {
            YkBox other = labels.boxes[i];
            assert_true(box.left >= other.right || box.right <= other.left || box.top >= other.bottom ||
                        box.bottom <= other.top);
        }
        yk_labels_take(&labels, box);
    }
    assert_int_equal(labels.count, 6);
    for (int k = 0; k < YK_LABELS_MAX; k++) yk_labels_take(&labels, yk_box_at(yk_vec(0, 0), 1, 1));
    assert_int_equal(labels.count, YK_LABELS_MAX);
}

// Where everything is covered a little, a hair more of it costs a hair more: no overlap is too thin to count.
static void the_price_has_no_steps(void **state)
{
    (void)state;
    uint64_t seed = 8;
    static YkLabels labels;
    const double hair = 0.01;
    for (size_t trial = 0; trial < check_cases(40); trial++) {
        labels = (YkLabels){.half = 1, .width = 120, .height = 90};
        for (int k = 0; k < 40; k++) {
            YkVec middle = {check_uniform(&seed, 0, 120), check_uniform(&seed, 0, 90)};
            yk_labels_take(&labels, yk_box_at(middle, 30, 20));
        }
        double before, price;
        yk_labels_find(&labels, yk_vec(60, 45), 5, 40, 14, &before);
        for (int step = 0; step < 30; step++, before = price) {
            for (size_t k = 0; k < labels.count; k++) labels.boxes[k].left += hair, labels.boxes[k].right += hair;
            yk_labels_find(&labels, yk_vec(60, 45), 5, 40, 14, &price);
            CHECK_NEAR(price, before, 40 * 4 * 14 * hair);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_price_is_what_is_covered),
        cmocka_unit_test(the_price_has_no_steps),
        cmocka_unit_test(names_round_one_point_do_not_cover_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
