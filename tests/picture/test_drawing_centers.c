// Instant centres on a drawing: marks where they are, lines that meet there, and words for those that are not on the
// page.
#include "check.h"
#include <math.h>
#include <stdlib.h>
#include <yoke/yoke.h>
#include "base/vec.h"

typedef struct Drawn {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
    YkCenters *centers;
    YkDrawing *drawing;
} Drawn;

static Drawn draw(const char *name)
{
    char path[300];
    snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, name);
    Drawn d = {.model = yk_model_load(path, NULL, NULL)};
    d.mech = yk_mechanism_compile(d.model, NULL, NULL);
    d.state = yk_state_new(d.mech);
    assert_true(yk_state_set_time(d.state, 0, NULL) >= 0 && yk_state_assemble(d.state) >= 0);
    d.centers = yk_centers_new(d.state, NULL);
    d.drawing = yk_drawing_new(d.mech, NULL);
    assert_true(d.centers && d.drawing);
    assert_int_equal(yk_drawing_pose(d.drawing, d.state), YK_OK);
    assert_int_equal(yk_drawing_centers(d.drawing, d.centers), YK_OK);
    return d;
}

static void drawn_free(Drawn *d)
{
    yk_drawing_free(d->drawing);
    yk_centers_free(d->centers);
    yk_state_free(d->state);
    yk_mechanism_free(d->mech);
    yk_model_free(d->model);
}

static size_t count(const char *text, const char *part)
{
    size_t found = 0;
    for (const char *at = text; (at = strstr(at, part)) != NULL; at++) found++;
    return found;
}

static void six_centres_of_a_four_bar_are_marked_where_lines_meet(void **state)
{
    (void)state;
    Drawn d = draw("four-bar");
    const char *svg = yk_drawing_svg(d.drawing);
    assert_int_equal(count(svg, "class=\"center\""), 6);
    assert_int_equal(count(svg, "class=\"kennedy\""), 8); // two centres, two lines each, through two others
    assert_int_equal(count(svg, "class=\"center-note\""), 0);
    assert_int_equal(count(svg, ">ground/coupler<"), 1);
    assert_int_equal(count(svg, ">crank/rocker<"), 1);
    // Lines that end at one centre go through it from two others on one straight line.
    double ends[8][4];
    const char *at = svg;
    for (size_t k = 0; k < 8; k++) {
        at = strstr(at, "class=\"kennedy\"");
        const char *line = at++;
        while (strncmp(line, "<line", 5) != 0) line--;
        assert_int_equal(sscanf(line, "<line x1=\"%lf\" y1=\"%lf\" x2=\"%lf\" y2=\"%lf\"", &ends[k][0], &ends[k][1],
                                &ends[k][2], &ends[k][3]),
                         4);
    }
    for (size_t k = 0; k < 8; k += 2) {
        double ax = ends[k][0] - ends[k][2], ay = ends[k][1] - ends[k][3];
        double bx = ends[k + 1][0] - ends[k + 1][2], by = ends[k + 1][1] - ends[k + 1][3];
        CHECK_NEAR(ends[k][2], ends[k + 1][2], 0);
        CHECK_NEAR((ax * by - ay * bx) / (hypot(ax, ay) * hypot(bx, by)), 0, 1e-3);
    }
    drawn_free(&d);
}

static void centres_at_infinity_are_told(void **state)
{
    (void)state;
    Drawn d = draw("slider-crank");
    const char *svg = yk_drawing_svg(d.drawing);
    assert_int_equal(count(svg, "class=\"center\"") + count(svg, "class=\"center-note\""), 6);
    assert_int_equal(count(svg, "ground/piston: at infinity towards 90 deg"), 1);
    assert_int_equal(yk_drawing_centers(d.drawing, NULL), YK_OK);
    assert_int_equal(count(yk_drawing_svg(d.drawing), "center"), 0);
    assert_int_equal(yk_drawing_centers(NULL, d.centers), YK_BAD_ARGUMENT);
    drawn_free(&d);
}

// All round: a centre is marked if it is no farther from the machine than that is large, else told in words, and the
// page holds all marks.
static void near_centres_are_marked_and_far_ones_told(void **state)
{
    (void)state;
    static const char *const names[] = {"four-bar", "drag-link"};
    size_t told = 0;
    for (int trial = 0; trial < 60; trial++) {
        Drawn d = draw(names[trial % 2]);
        yk_drawing_free(d.drawing);
        yk_centers_free(d.centers);
        YkMotion input = yk_state_input(d.state, 0);
        input.position += trial * YK_PI / 30;
        yk_state_set_input(d.state, 0, input);
        assert_true(yk_state_solve(d.state) >= 0);
        d.centers = yk_centers_new(d.state, NULL);
        d.drawing = yk_drawing_new(d.mech, NULL);
        assert_int_equal(yk_drawing_pose(d.drawing, d.state), YK_OK);
        assert_int_equal(yk_drawing_centers(d.drawing, d.centers), YK_OK);
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (size_t p = 0; p < yk_model_point_count(d.model); p++)
            for (int k = 0; k < 2; k++) {
                low[k] = fmin(low[k], yk_state_point(d.state, p).position[k]);
                high[k] = fmax(high[k], yk_state_point(d.state, p).position[k]);
            }
        double reach = fmax(high[0] - low[0], high[1] - low[1]);
        size_t near = 0, all = yk_centers_count(d.centers);
        for (size_t c = 0; c < all; c++) {
            YkCenter center = yk_centers_at(d.centers, c);
            bool is_near = center.kind == YK_CENTER_POINT;
            for (int k = 0; k < 2; k++)
                is_near = is_near && center.at[k] >= low[k] - reach && center.at[k] <= high[k] + reach;
            near += is_near;
        }
        const char *svg = yk_drawing_svg(d.drawing);
        assert_true(count(svg, "class=\"center\"") <= near); // one mark for what coincides
        assert_int_equal(count(svg, "class=\"center-note\""), all - near);
        told += all - near;
        drawn_free(&d);
    }
    assert_true(told > 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(six_centres_of_a_four_bar_are_marked_where_lines_meet),
        cmocka_unit_test(near_centres_are_marked_and_far_ones_told),
        cmocka_unit_test(centres_at_infinity_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
