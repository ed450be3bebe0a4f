// Examples in other units (tests/similar.h): similar counterweights, flywheels, strokes and instant centres.
#include <yoke/balancing.h>
#include <yoke/centers.h>
#include <yoke/design.h>
#include "../similar.h"

static void check_order(const Similar *a, YkShakingOrder o, YkShakingOrder p)
{
    similar_check(o.with, p.with, YK_QUANTITY_FORCE, a->file, "force that turns with the input");
    similar_check(o.against, p.against, YK_QUANTITY_FORCE, a->file, "force that turns against it");
    similar_check(o.direction, p.direction, YK_QUANTITY_ANGLE, a->file, "direction of a force");
}

static void check_peaks(const Similar *a, YkShakingPeaks p, YkShakingPeaks q)
{
    bool turns = !yk_coordinate_info(a->mech, yk_input_coordinate(a->mech, 0)).is_distance;
    similar_check(p.force, q.force, YK_QUANTITY_FORCE, a->file, "shaking force");
    similar_check(p.moment, q.moment, YK_QUANTITY_TORQUE, a->file, "shaking moment");
    similar_check(p.torque, q.torque, turns ? YK_QUANTITY_TORQUE : YK_QUANTITY_FORCE, a->file, "effort");
}

static void check_balancing(const Similar *a, const Similar *b, const double weight[3])
{
    YkBalancingOptions options = yk_default_balancing_options();
    options.steps = 48;
    memcpy(options.weight, weight, sizeof options.weight);
    YkBalancing *one = yk_balancing_new(a->state, &options, a->problems);
    YkBalancing *two = yk_balancing_new(b->state, &options, b->problems);
    if (!one) print_error("%s", yk_problems_text(a->problems, 0));
    assert_true(one && two);
    SIMILAR_EQUAL(a->file, yk_balancing_is_full(one), yk_balancing_is_full(two));
    SIMILAR_EQUAL(a->file, yk_balancing_turns(one), yk_balancing_turns(two));
    SIMILAR_EQUAL(a->file, yk_balancing_count(one), yk_balancing_count(two));
    for (size_t k = 0; k < yk_balancing_count(one); k++) {
        YkCounterweight v = yk_balancing_at(one, k), w = yk_balancing_at(two, k);
        SIMILAR_EQUAL(a->file, v.body, w.body);
        similar_check(v.product, w.product, YK_QUANTITY_UNBALANCE, a->file, "product of a counterweight");
        similar_check(v.angle, w.angle, YK_QUANTITY_ANGLE, a->file, "angle of a counterweight");
        similar_check(v.mass, w.mass, YK_QUANTITY_MASS, a->file, "mass of a counterweight");
        similar_check(v.radius, w.radius, YK_QUANTITY_LENGTH, a->file, "radius of a counterweight");
    }
    check_peaks(a, yk_balancing_before(one), yk_balancing_before(two));
    for (size_t n = 1; n <= YK_SHAKING_ORDERS; n++)
        check_order(a, yk_balancing_order(one, n, false), yk_balancing_order(two, n, false));
    similar_check(yk_balancing_flywheel(one), yk_balancing_flywheel(two), YK_QUANTITY_INERTIA, a->file, "flywheel");
    yk_balancing_free(one);
    yk_balancing_free(two);
}

static void check_centers(const Similar *a, const Similar *b)
{
    YkCenters *one = yk_centers_new(a->state, a->problems), *two = yk_centers_new(b->state, b->problems);
    assert_int_equal(one == NULL, two == NULL);
    SIMILAR_EQUAL(a->file, yk_centers_count(one), yk_centers_count(two));
    for (size_t k = 0; k < yk_centers_count(one); k++) {
        YkCenter c = yk_centers_at(one, k), d = yk_centers_at(two, k);
        SIMILAR_EQUAL(a->file, c.kind, d.kind);
        SIMILAR_EQUAL(a->file, c.source, d.source);
        assert_memory_equal(c.body, d.body, sizeof c.body);
        for (int i = 0; i < 2 && c.kind == YK_CENTER_POINT; i++)
            similar_check(c.at[i], d.at[i], YK_QUANTITY_LENGTH, a->file, "place of a centre");
        if (c.kind == YK_CENTER_AT_INFINITY)
            similar_check(c.direction, d.direction, YK_QUANTITY_ANGLE, a->file, "direction of a centre");
    }
    yk_centers_free(one);
    yk_centers_free(two);
}

static void check_strokes(const Similar *a, const Similar *b)
{
    for (size_t c = 0; c < yk_coordinate_count(a->mech); c++) {
        YkStroke s, t;
        YkQuantity of = similar_quantity(a->mech, c);
        YkChannel channel = {YK_CHANNEL_COORDINATE, (int)c, 0, of};
        YkStatus status = yk_stroke(a->state, 0, channel, &s);
        SIMILAR_EQUAL(a->file, status, yk_stroke(b->state, 0, channel, &t));
        if (status != YK_OK) continue;
        similar_check(s.low, t.low, of, a->file, "low end of a stroke");
        similar_check(s.high, t.high, of, a->file, "high end of a stroke");
        similar_check(s.low_at, t.low_at, YK_QUANTITY_ANGLE, a->file, "place of the low end");
        similar_check(s.high_at, t.high_at, YK_QUANTITY_ANGLE, a->file, "place of the high end");
        similar_check(s.ratio, t.ratio, YK_QUANTITY_NUMBER, a->file, "time ratio");
    }
}

static void test_designs_in_other_units(void **unused)
{
    (void)unused;
    static const char *const files[] = {"examples/gas-engine.yaml", "examples/watt-with-masses.yaml",
                                        "examples/steam-engine.yaml", "examples/geared-five-bar.yaml"};
    static const double weights[][3] = {{0, 0, 0}, {1, 0.5, 0.25}};
    for (size_t k = 0; k < check_cases(sizeof files / sizeof *files); k++) {
        static const int units[][3] = {{-35, 24, -33}, {33, -26, 25}};
        Similar m[2];
        similar_load_both(&m[0], &m[1], files[k], units[k % 2]);
        for (int i = 0; i < 2; i++)
            assert_true(yk_state_set_time(m[i].state, 0, m[i].problems) >= 0 && yk_state_assemble(m[i].state) >= 0);
        check_centers(&m[0], &m[1]);
        for (size_t w = 0; w < 2; w++) check_balancing(&m[0], &m[1], weights[w]);
        check_strokes(&m[0], &m[1]);
        similar_free(&m[0]);
        similar_free(&m[1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_designs_in_other_units)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
