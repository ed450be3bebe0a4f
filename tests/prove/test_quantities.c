// Quantities in equations with the names of `solve` have the numbers of `solve`.
#include "prove/quantities.h"
#include "derive/forces/free_bodies.h"
#include "derive/inside.h"
#include "derive/derive_check.h"

static size_t compared;

// NAME, with - as _, and its ending: by symbols and by the engine.
static void compare(Machine *m, YkDynamics *dynamics, const char *file, const char *name, const char *ending,
                    double scale)
{
    char asked[256], written[256];
    YkChannel channel;
    snprintf(asked, sizeof asked, "%s%s", name, ending);
    for (size_t k = 0; k == 0 || asked[k - 1] != '\0'; k++) written[k] = asked[k] == '-' ? '_' : asked[k];
    if (yk_channel_parse(m->mech, asked, &channel, NULL) != YK_OK) return;
    const YkPoisson *a = yk_derive_quantity(m->d, written);
    if (!a) print_error("%s: %s is not known\n", file, written);
    assert_non_null(a);
    double expected = yk_dynamics_channel(dynamics, m->state, channel),
           value = yk_ring_value(m->d->ring, a, m->values).x;
    if (isnan(expected)) return;
    if (!(fabs(value - expected) <= 1e-8 * scale))
        print_error("%s: %s = %.17g, not %.17g\n", file, asked, value, expected);
    assert_true(fabs(value - expected) <= 1e-8 * scale);
    compared++;
}

static double largest_force(Machine *m, const YkDynamics *dynamics)
{
    double most = 1;
    for (size_t j = 0; j < m->model->joint_count; j++) {
        YkReaction r = yk_dynamics_reaction(dynamics, j);
        most = fmax(most, fmax(fmax(fabs(r.force[0]), fabs(r.force[1])), fabs(r.moment)));
    }
    for (size_t k = 0; k < yk_dynamics_contact_count(dynamics); k++) {
        YkReaction r = yk_dynamics_contact(dynamics, k);
        most = fmax(most, fmax(fmax(fabs(r.force[0]), fabs(r.force[1])), fabs(r.moment)));
    }
    return most;
}

static void compare_all(Machine *m, YkDynamics *dynamics, const char *file)
{
    static const char *const parts[] = {".force.x", ".force.y", ".moment"}, *const sums[] = {".x", ".y", ".moment"};
    double scale = largest_force(m, dynamics);
    for (size_t p = 0; p < 3; p++) {
        for (size_t j = 0; j < m->model->joint_count; j++)
            compare(m, dynamics, file, m->model->joints[j].name, parts[p], scale);
        for (size_t k = 0; k < yk_dynamics_contact_count(dynamics); k++)
            compare(m, dynamics, file, yk_dynamics_contact_name(dynamics, k), parts[p], scale);
        compare(m, dynamics, file, "shaking", sums[p], scale * fmax(1, yk_mechanism_size(m->mech)));
    }
    for (size_t c = 0; c < yk_coordinate_count(m->mech); c++)
        if (yk_dynamics_has_effort(dynamics, c))
            compare(m, dynamics, file, yk_coordinate_info(m->mech, c).name, ".effort", scale);
    compare(m, dynamics, file, "energy", "", scale);
    compare(m, dynamics, file, "kinetic", "", scale);
}

static void visit(Machine *m, const char *file)
{
    YkDynamics *dynamics = yk_dynamics_new(m->mech, m->problems);
    assert_non_null(dynamics);
    for (int pose = 0; pose < 3 && yk_derive_forces(m->d); pose++) {
        if (!random_pose(m, pose == 0)) continue;
        if (yk_dynamics_solve(dynamics, m->state, YK_METHOD_REDUCED) < 0 || !yk_state_has_rates(m->state)) continue;
        free(m->values);
        m->value_count = yk_ring_symbol_count(m->d->ring) + 64;
        m->values = calloc(m->value_count, sizeof *m->values);
        yk_derive_values(m->d, m->state, dynamics, m->values);
        compare_all(m, dynamics, file);
    }
    yk_dynamics_free(dynamics);
}

static void names_of_solve_have_its_numbers(void **state)
{
    (void)state;
    assert_true(each_example(visit) > 30);
    assert_true(compared > 1500);
}

static const char train[] =
    "parameters: {z1: 18, z2: 54, mod: 2 mm, J1: 0.01, J2: 0.3, M: 4 N*m, rb: 30 mm, mb: 2 kg}\n"
    "gravity: [0, -9.81]\n"
    "bodies:\n"
    "  ground: {points: {A: [0, 0], B: [mod*(z1 + z2)/2, 0], Q: [mod*(z1 + z2)/2, -rb]}}\n"
    "  p: {inertia: J1}\n"
    "  g: {inertia: J2}\n"
    "  bar: {mass: mb}\n"
    "joints:\n"
    "  A: {pin: [ground, p], angle: q1}\n"
    "  B: {pin: [ground, g], angle: q2}\n"
    "  S: {slide: [ground, bar], along: x, from: Q, distance: s}\n"
    "gears: {first-pair: {mesh: [p, g], teeth: [z1, z2], module: mod, pressure_angle: 20 deg}}\n"
    "racks: {r: {pinion: g, rack: bar, radius: rb}}\n"
    "efforts: {q1: M}\n";

static void meshes_have_the_forces_of_newton(void **state)
{
    (void)state;
    static const struct {
        const char *equation;
        YkCheckKind kind;
    } cases[] = {{"r.force.x = mb s''", YK_CHECK_TRUE},
                 {"r.force.x = -mb s''", YK_CHECK_FALSE},
                 {"r.force.y = 0", YK_CHECK_TRUE},
                 {"M + mod z1/2 first_pair.force.y = J1 q1''", YK_CHECK_FALSE},
                 {"M - mod z1/2 first_pair.force.y = J1 q1''", YK_CHECK_TRUE},
                 {"first_pair.moment = 0", YK_CHECK_TRUE},
                 {"shaking.x = -mb s''", YK_CHECK_TRUE},
                 {"shaking.y = -9.81 mb", YK_CHECK_TRUE},
                 {"shaking.x = -A.force.x - B.force.x - S.force.x", YK_CHECK_TRUE},
                 {"A.force = 0", YK_CHECK_UNREADABLE}};
    Machine m = machine_of(train);
    YkDynamics *dynamics = yk_dynamics_new(m.mech, m.problems);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        yk_state_set_time(m.state, 0, NULL);
        assert_true(yk_state_assemble(m.state) >= 0);
        YkCheckVerdict verdict = yk_derive_check(m.d, m.state, dynamics, cases[k].equation, strlen(cases[k].equation),
                                                 (YkPlace){1, 1, 0}, m.problems);
        if (verdict.kind != cases[k].kind) print_error("%s: %d\n", cases[k].equation, (int)verdict.kind);
        assert_int_equal(verdict.kind, cases[k].kind);
    }
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_of_solve_have_its_numbers),
        cmocka_unit_test(meshes_have_the_forces_of_newton),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
