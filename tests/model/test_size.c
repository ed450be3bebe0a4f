// The size of a machine is the largest distance within one body, however many points it has.
#include "base/text.h"
#include "../check_vec.h"
#include "model/fixture.h"

static double largest_distance(const YkVec *points, size_t count) // of all pairs
{
    double largest = 0;
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < i; k++) {
            largest = fmax(largest, hypot(points[i].x - points[k].x, points[i].y - points[k].y));
        }
    }
    return largest;
}

static double size_of(const YkVec *points, size_t count)
{
    YkText text = {0};
    yk_text_puts(&text, "bodies: {ground: {points: {P0: [0, 0]}}, b: {points: {");
    for (size_t i = 0; i < count; i++) {
        char point[100];
        snprintf(point, sizeof point, "P%zu: [%.17g, %.17g], ", i, points[i].x, points[i].y);
        yk_text_puts(&text, point);
    }
    yk_text_puts(&text, "}}}\njoints: {J: {weld: [ground, b], at: P0}}\n");
    YkModel *model = fixture_load(yk_text_get(&text));
    double size = model->size;
    yk_model_free(model);
    yk_text_free(&text);
    return size;
}

static void hull_and_calipers_equal_all_pairs_on_random_points(void **state)
{
    (void)state;
    uint64_t seed = 42;
    YkVec points[60];
    for (int round = 0; round < 300; round++) {
        size_t count = 2 + check_random(&seed) % 58;
        double flat = round % 3 == 0 ? 0 : round % 3 == 1 ? 1 : 1e-9; // also on a line, and nearly so
        for (size_t i = 0; i < count; i++) {
            points[i] = check_vec(&seed, -1, 1, -1, 1);
            points[i].y *= flat;
        }
        CHECK_NEAR(size_of(points, count), largest_distance(points, count), 1e-15);
    }
}

static YkVec grid_place(uint64_t *seed)
{
    double y = (double)(check_random(seed) % 4), x = (double)(check_random(seed) % 4);
    return yk_vec(x, y);
}

static void hull_and_calipers_equal_all_pairs_on_a_grid_and_a_circle(void **state)
{
    (void)state;
    uint64_t seed = 5;
    YkVec points[60];
    for (int round = 0; round < 200; round++) {
        size_t count = 3 + check_random(&seed) % 57;
        for (size_t i = 0; i < count; i++) {
            points[i] = round % 2 ? grid_place(&seed) : yk_unit(2 * YK_PI * (double)i / (double)count);
        }
        double expected = largest_distance(points, count);
        if (expected > 0) CHECK_NEAR(size_of(points, count), expected, 1e-15);
    }
}

static double size_of_text(const char *text)
{
    YkModel *model = fixture_load(text);
    double size = model->size;
    yk_model_free(model);
    return size;
}

static void the_origin_counts_where_a_joint_uses_it(void **state)
{
    (void)state;
    CHECK_NEAR(size_of_text("bodies: {b: {points: {A: [3, 4], B: [3, 3]}}}\njoints: {O: {pin: [ground, b]}}\n"), 5, 0);
    CHECK_NEAR(size_of_text("bodies: {ground: {points: {A: [0, 0]}}, b: {points: {A: [3, 4], B: [3, 3]}}}\n"
                            "joints: {A: {pin: [ground, b]}}\n"),
               1, 0);
}

static void a_longer_start_distance_counts_and_nothing_at_all_is_one(void **state)
{
    (void)state;
    const char *machine = "bodies: {b: {}}\njoints: {S: {slide: [ground, b], distance: s}}\n";
    char text[200];
    CHECK_NEAR(size_of_text(machine), 1, 0);
    snprintf(text, sizeof text, "%sstart: {s: -7 mm}\n", machine);
    CHECK_NEAR(size_of_text(text), 0.007, 1e-18);
    snprintf(text, sizeof text, "%sstart: {s.rate: 7 m/s}\n", machine);
    CHECK_NEAR(size_of_text(text), 1, 0);
    CHECK_NEAR(size_of_text("bodies: {b: {}}\njoints: {O: {pin: [ground, b], angle: q}}\nstart: {q: 9}\n"), 1, 0);
}

static void size_grows_with_the_machine(void **state)
{
    (void)state;
    uint64_t seed = 3;
    YkVec points[20], scaled[20];
    for (size_t i = 0; i < 20; i++) {
        points[i] = check_vec(&seed, -1, 1, -1, 1);
        scaled[i] = yk_mul(yk_scale(8, yk_unit(0.7)), points[i]); // turned and eight times as large
    }
    CHECK_NEAR(size_of(scaled, 20), 8 * size_of(points, 20), 1e-14);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hull_and_calipers_equal_all_pairs_on_random_points),
        cmocka_unit_test(hull_and_calipers_equal_all_pairs_on_a_grid_and_a_circle),
        cmocka_unit_test(the_origin_counts_where_a_joint_uses_it),
        cmocka_unit_test(a_longer_start_distance_counts_and_nothing_at_all_is_one),
        cmocka_unit_test(size_grows_with_the_machine),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
