// Values of the file as exact elements.
#include "derive_check.h"

// Parameter p of a machine whose file defines it as `text`; a is a length, alpha an angle.
static const YkPoisson *element_of(Machine *m, const char *text)
{
    char file[600];
    snprintf(file, sizeof file,
             "parameters: {a: 2 m, b: 3 m, alpha: 0.3 rad}\n"
             "bodies: {arm: {points: {P: [%s, b], Q: [a*cos(alpha), 0]}}}\n"
             "joints: {O: {pin: [ground, arm], angle: q}}\n",
             text);
    *m = machine_of(file);
    return yk_ring_real(m->d->ring, yk_derive_at(m->d, (int32_t)yk_model_find_point(m->model, "arm.P")));
}

static void check_value(const char *text, const char *expected)
{
    Machine m;
    const YkPoisson *a = element_of(&m, text);
    if (!a) print_error("%s\n", text);
    assert_non_null(a);
    check_element(&m, a, expected);
    machine_end(&m);
}

static void decimals_and_units_are_exact(void **state)
{
    (void)state;
    check_value("0.3", "3/10");
    check_value("0.1 + 0.2", "3/10");
    check_value("3/4 m", "3/4");
    check_value("750 mm", "3/4");
    check_value("1e-3", "1/1000");
    check_value("2 in", "0.0508");
    check_value("-0.25 m", "-1/4");
}

static void parameters_stay_symbols(void **state)
{
    (void)state;
    check_value("a + b", "a + b");
    check_value("a*b/(2*a)", "b/2");
    check_value("(a + b)^2/a", "a + 2*b + b^2/a");
    check_value("a*cos(alpha)", "a*cos(alpha)");
    check_value("a*sin(2*alpha + 30 deg)", "a*sin(2*alpha + pi/6)");
    check_value("a*cos(60 deg)", "a/2");
    check_value("a*sqrt(2)", "a*sqrt(2)");
    check_value("a*sqrt(1/4)", "a/2");
}

static void what_is_no_polynomial_becomes_a_constant_with_its_value(void **state)
{
    (void)state;
    Machine m;
    const YkPoisson *a = element_of(&m, "a*b/(a + b)");
    assert_non_null(a);
    assert_int_equal(m.d->constant_count, 1);
    CHECK_NEAR(m.d->constants[0].value, 6.0 / 5, 1e-15);
    assert_int_equal(yk_ring_terms(a), 1);
    machine_end(&m);
    a = element_of(&m, "a*cos(alpha/2)");
    assert_non_null(a);
    assert_int_equal(m.d->constant_count, 1);
    CHECK_NEAR(m.d->constants[0].value, 0.15, 1e-15);
    machine_end(&m);
}

// An inertia in kg*mm^2 to the last digit of a double has a name; the centre is nothing that loops ask for.
static void numbers_that_the_ring_cannot_hold_fail_where_they_are_needed(void **state)
{
    (void)state;
    Machine m =
        machine_of("bodies: {arm: {points: {P: [1, 0]}, mass: 2 kg, center: [sqrt(2)*1.2345678901234567 mm, 0],\n"
                   "               inertia: 1.234567890123456 kg*mm^2}}\n"
                   "joints: {O: {pin: [ground, arm], angle: q}}\n");
    const YkPoisson *inertia = yk_derive_inertia(m.d, 1);
    assert_non_null(inertia);
    take_values(&m);
    CHECK_NEAR(yk_ring_value(m.d->ring, inertia, m.values).x, 1.234567890123456e-6, 1e-21);
    check_element(&m, yk_ring_real(m.d->ring, yk_derive_at(m.d, 0)), "1");
    assert_int_equal(yk_ring_status(m.d->ring), YK_RING_OK);
    assert_null(yk_derive_center(m.d, 1));
    assert_int_equal(yk_ring_status(m.d->ring), YK_RING_OVERFLOW);
    machine_end(&m);
}

static void units_of_the_file_count(void **state)
{
    (void)state;
    Machine m = machine_of("units: {length: mm, angle: deg}\n"
                           "bodies: {ground: {points: {Z: [10, 0]}}, arm: {points: {P: [0, 0]}}}\n"
                           "joints: {S: {slide: [ground, arm], along: 60, turned: 45, distance: s}}\n");
    check_element(&m, yk_ring_real(m.d->ring, yk_derive_at(m.d, 0)), "1/100");
    check_element(&m, yk_ring_real(m.d->ring, yk_derive_along(m.d, 0)), "1/2");
    check_element(&m, yk_ring_imaginary(m.d->ring, m.d->bodies[1].unit), "sqrt(2)/2");
    machine_end(&m);
}

static void parameters_have_the_class_of_their_dimension(void **state)
{
    (void)state;
    Machine m = example("double-pendulum");
    static const struct {
        const char *name;
        YkRingClass kind;
    } cases[] = {{"m1", YK_RING_MASS},     {"I1", YK_RING_INERTIA}, {"l1", YK_RING_CONSTANT},
                 {"g", YK_RING_GRAVITY},   {"tau1", YK_RING_FORCE}, {"theta1", YK_RING_COORDINATE},
                 {"theta1'", YK_RING_RATE}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
        assert_int_equal(yk_ring_symbol_class(m.d->ring, yk_ring_find(m.d->ring, cases[k].name)), cases[k].kind);
    machine_end(&m);
}

// Positions, spins and their rates of every body, against the numeric engine.
static void visit_bodies(Machine *m, const char *name)
{
    YkRing *ring = m->d->ring;
    if (!random_pose(m, true) && !random_pose(m, false)) return;
    double size = yk_mechanism_size(m->mech);
    for (size_t p = 0; p < m->model->point_count; p++) {
        int32_t body = m->model->points[p].body;
        const YkPoisson *at = yk_derive_position(m->d, body, yk_derive_at(m->d, (int32_t)p));
        const YkPoisson *forms[2] = {at, yk_derive_in_joints(m->d, at)};
        YkPointMotion motion = yk_state_point(m->state, p);
        take_values(m);
        for (int form = 0; form < 2; form++) {
            const YkPoisson *v = yk_ring_time_derivative(ring, forms[form]), *a = yk_ring_time_derivative(ring, v);
            YkVec x = yk_ring_value(ring, forms[form], m->values), dx = yk_ring_value(ring, v, m->values);
            YkVec ddx = yk_ring_value(ring, a, m->values);
            if (fabs(x.x - motion.position[0]) > 1e-11 * size) print_error("%s: %s\n", name, m->model->points[p].name);
            CHECK_NEAR(x.x, motion.position[0], 1e-11 * size);
            CHECK_NEAR(x.y, motion.position[1], 1e-11 * size);
            double speed = hypot(motion.velocity[0], motion.velocity[1]);
            double push = hypot(motion.acceleration[0], motion.acceleration[1]);
            CHECK_NEAR(dx.x, motion.velocity[0], 1e-10 * (size + speed));
            CHECK_NEAR(dx.y, motion.velocity[1], 1e-10 * (size + speed));
            CHECK_NEAR(ddx.x, motion.acceleration[0], 1e-9 * (size + speed + push));
            CHECK_NEAR(ddx.y, motion.acceleration[1], 1e-9 * (size + speed + push));
        }
    }
    for (size_t b = 0; b < m->model->body_count; b++) {
        YkMotion motion = yk_state_body(m->state, b);
        YkVec unit = yk_ring_value(ring, yk_derive_in_joints(m->d, m->d->bodies[b].unit), m->values);
        CHECK_NEAR(unit.x, cos(motion.position), 1e-12);
        CHECK_NEAR(unit.y, sin(motion.position), 1e-12);
        double spin = yk_ring_value(ring, yk_derive_in_joints(m->d, m->d->bodies[b].spin), m->values).x;
        CHECK_NEAR(spin, motion.velocity, 1e-11 * (1 + fabs(motion.velocity)));
    }
}

static void bodies_and_points_are_where_the_engine_has_them(void **state)
{
    (void)state;
    assert_true(each_example(visit_bodies) > 30);
}

static void names_that_equations_cannot_hold_are_made_fit(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {pi_2: 1 m}\n"
                           "bodies:\n"
                           "  ground: {points: {O: [0, 0]}}\n"
                           "  link-1: {points: {O: [0, 0], A: [pi_2, 0]}}\n"
                           "  link_1: {points: {A: [0, 0], B: [1, 0]}}\n"
                           "joints:\n"
                           "  j-1: {pin: [ground, link-1], at: O}\n"
                           "  j-2: {pin: [link-1, link_1], at: A}\n");
    assert_true(yk_ring_find(m.d->ring, "j_1.angle") >= 0);
    assert_true(yk_ring_find(m.d->ring, "link_1.angle") >= 0);
    assert_string_equal(yk_ring_symbol_name(m.d->ring, m.d->parameters[0]), "pi_2_");
    machine_end(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(decimals_and_units_are_exact),
        cmocka_unit_test(parameters_stay_symbols),
        cmocka_unit_test(what_is_no_polynomial_becomes_a_constant_with_its_value),
        cmocka_unit_test(numbers_that_the_ring_cannot_hold_fail_where_they_are_needed),
        cmocka_unit_test(units_of_the_file_count),
        cmocka_unit_test(parameters_have_the_class_of_their_dimension),
        cmocka_unit_test(bodies_and_points_are_where_the_engine_has_them),
        cmocka_unit_test(names_that_equations_cannot_hold_are_made_fit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
