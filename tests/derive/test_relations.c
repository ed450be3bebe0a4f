// Gears, racks, belts, cams in the equations.
#include "derive_check.h"
#include "derive/relations.h"

static void a_planetary_train_prints_williss_equations(void **state)
{
    (void)state;
    Machine m = example("epicyclic");
    const YkDeriveRelation *ties = yk_derive_ties(m.d);
    assert_int_equal(m.d->tie_count, 2);
    check_element(&m, ties[0].value, "N1*(theta1 - thetaC) + N2*theta2");
    check_element(&m, ties[1].value, "N3*theta2 - N4*(theta4 - thetaC)"); // internal: both turn the same way
    machine_end(&m);
}

static void its_rates_follow_for_all_numbers_of_teeth(void **state)
{
    (void)state;
    Machine m = example("epicyclic");
    assert_int_equal(verdict_on(&m, "theta2' = -N1/N2*(theta1' - thetaC')").kind, YK_CHECK_TRUE);
    assert_int_equal(verdict_on(&m, "theta4' - thetaC' = -N1*N3/(N2*N4)*(theta1' - thetaC')").kind, YK_CHECK_TRUE);
    assert_int_equal(verdict_on(&m, "theta4' - thetaC' = N1*N3/(N2*N4)*(theta1' - thetaC')").kind, YK_CHECK_FALSE);
    assert_int_equal(verdict_on(&m, "planet.rate = thetaC' + theta2'").kind, YK_CHECK_TRUE);
    machine_end(&m);
}

static void a_rack_moves_as_its_pinion_rolls(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {r: 40 mm}\n"
                           "bodies: {ground: {points: {G: [0, 40 mm]}}, wheel: {}, bar: {}}\n"
                           "joints:\n"
                           "  O: {pin: [ground, wheel], angle: theta}\n"
                           "  R: {slide: [ground, bar], along: x, from: G, distance: d}\n"
                           "racks: {k: {pinion: wheel, rack: bar, radius: r}}\n"
                           "start: {theta: 0.3}\n");
    const YkDeriveRelation *ties = yk_derive_ties(m.d);
    assert_int_equal(m.d->tie_count, 1);
    const YkPoisson *rate = yk_ring_time_derivative(m.d->ring, ties[0].value);
    const YkPoisson *left = read_in(&m, "d' + r*theta'"), *right = read_in(&m, "d' - r*theta'");
    bool above = yk_ring_is_same(rate, left);
    assert_true(above || yk_ring_is_same(rate, right));
    assert_int_equal(verdict_on(&m, above ? "d' = -r*theta'" : "d' = r*theta'").kind, YK_CHECK_TRUE);
    assert_int_equal(verdict_on(&m, above ? "d' = r*theta'" : "d' = -r*theta'").kind, YK_CHECK_FALSE);
    machine_end(&m);
}

static void a_cam_is_a_function_with_derivatives(void **state)
{
    (void)state;
    Machine m = example("cep-cam");
    assert_non_null(yk_derive_ties(m.d));
    assert_int_equal(verdict_on(&m, "s' = lift_v*theta'").kind, YK_CHECK_TRUE);
    assert_int_equal(verdict_on(&m, "s'' = lift_v*theta'' + lift_a*theta'^2").kind, YK_CHECK_TRUE);
    assert_int_not_equal(verdict_on(&m, "s'' = lift_v*theta''").kind, YK_CHECK_TRUE);
    machine_end(&m);
}

static size_t seen;

static void visit(Machine *m, const char *name)
{
    if (!yk_derive_ties(m->d)) return;
    for (int k = 0; k < 3; k++) {
        if (!random_pose(m, k == 0)) continue;
        for (size_t t = 0; t < m->d->tie_count; t++) {
            if (!m->d->ties[t].value) continue;
            double value = yk_ring_value(m->d->ring, m->d->ties[t].value, m->values).x;
            const YkPoisson *rate = yk_ring_time_derivative(m->d->ring, m->d->ties[t].value);
            double slope = yk_ring_value(m->d->ring, rate, m->values).x;
            if (fabs(value) > 1e-9 || fabs(slope) > 1e-9) print_error("%s: %s\n", name, m->d->ties[t].name);
            CHECK_NEAR(value, 0, 1e-9);
            CHECK_NEAR(slope, 0, 1e-9);
            seen++;
        }
    }
}

static void relations_hold_at_poses_of_the_engine(void **state)
{
    (void)state;
    assert_true(each_example(visit) > 30);
    assert_true(seen > 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_planetary_train_prints_williss_equations),
        cmocka_unit_test(its_rates_follow_for_all_numbers_of_teeth),
        cmocka_unit_test(a_rack_moves_as_its_pinion_rolls),
        cmocka_unit_test(a_cam_is_a_function_with_derivatives),
        cmocka_unit_test(relations_hold_at_poses_of_the_engine),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
