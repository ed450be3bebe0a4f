// The reduced equations against the free bodies: two formulations that share nothing but the pose.
#include "dynamics/rig.h"
#include "light_tree.h"

static double scale_of(const Rig *rig, const double *a)
{
    double most = 1;
    for (size_t i = 0; i < rig->mech->input_count; i++) most = fmax(most, fabs(a[i]));
    return most;
}

static void same_accelerations(const char *name, uint64_t seed)
{
    Rig rig = rig_of_example(name);
    for (int k = 0; k < 20; k++) {
        if (!rig_shake(&rig, &seed)) continue;
        double reduced[64], bodies[64];
        assert_true(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED) >= 0);
        for (size_t i = 0; i < rig.mech->input_count; i++) reduced[i] = yk_state_input(rig.state, i).acceleration;
        double effort = yk_dynamics_effort(rig.dynamics, (size_t)rig.mech->inputs[0]);
        YkReaction first = yk_dynamics_reaction(rig.dynamics, 0);
        assert_true(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_NEWTON_EULER) >= 0);
        for (size_t i = 0; i < rig.mech->input_count; i++) bodies[i] = yk_state_input(rig.state, i).acceleration;
        double scale = scale_of(&rig, reduced), force = fmax(1, rig.dynamics->largest_force);
        for (size_t i = 0; i < rig.mech->input_count; i++) CHECK_NEAR(reduced[i], bodies[i], 1e-11 * scale);
        CHECK_NEAR(yk_dynamics_effort(rig.dynamics, (size_t)rig.mech->inputs[0]), effort, 1e-10 * force);
        YkReaction second = yk_dynamics_reaction(rig.dynamics, 0);
        for (int axis = 0; axis < 2; axis++) CHECK_NEAR(first.force[axis], second.force[axis], 1e-10 * force);
    }
    rig_free(&rig);
}

static void reduced_equations_equal_the_free_bodies(void **unused)
{
    (void)unused;
    for (size_t k = 0; k < RIG_EXAMPLES; k++) same_accelerations(rig_examples[k], 40 + k);
}

// Efforts of drives by the elimination's own rows equal those of the free bodies.
static void efforts_of_drives_come_from_the_rows_as_well(void **unused)
{
    (void)unused;
    uint64_t seed = 3;
    for (size_t k = 0; k < RIG_EXAMPLES; k++) {
        Rig rig = rig_of_example(rig_examples[k]);
        for (size_t i = 0; i < rig.mech->input_count; i++) yk_dynamics_prescribe(rig.dynamics, i, true);
        if (rig_shake(&rig, &seed)) {
            double a[64];
            assert_true(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_REDUCED) >= 0);
            double force = fmax(1, rig.dynamics->largest_force * rig.mech->size);
            assert_true(yk_dynamics_reduce(rig.dynamics, rig.state) >= 0);
            yk_reduced_solve(rig.dynamics->reduced, a, true);
            for (size_t i = 0; i < rig.mech->input_count; i++)
                CHECK_NEAR(yk_reduced_effort(rig.dynamics->reduced, i), rig.dynamics->drive[i], 1e-10 * force);
        }
        rig_free(&rig);
    }
}

// Where one input is driven and the others are free, its row has the accelerations of these as well.
static void efforts_of_one_drive_beside_free_inputs_come_from_its_row(void **unused)
{
    (void)unused;
    uint64_t seed = 12;
    size_t compared = 0;
    for (size_t k = 0; k < RIG_EXAMPLES; k++) {
        Rig rig = rig_of_example(rig_examples[k]);
        size_t n = rig.mech->input_count;
        for (size_t driven = 0; n > 1 && driven < n; driven++) {
            double a[64];
            for (size_t i = 0; i < n; i++) yk_dynamics_prescribe(rig.dynamics, i, i == driven);
            if (!rig_shake(&rig, &seed)) continue;
            if (yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_NEWTON_EULER) != YK_OK) continue;
            double due = rig.dynamics->drive[driven];
            double force = fmax(1, rig.dynamics->largest_force * rig.mech->size);
            assert_true(yk_dynamics_reduce(rig.dynamics, rig.state) >= 0);
            yk_reduced_solve(rig.dynamics->reduced, a, true);
            CHECK_NEAR(yk_reduced_effort(rig.dynamics->reduced, driven), due, 1e-10 * force);
            compared++;
        }
        rig_free(&rig);
    }
    assert_true(compared > 8);
}

// Machines with few free inputs: their accelerations by influence coefficients, moving and at rest, against the
// elimination.
static void influence_coefficients_equal_the_elimination(void **unused)
{
    (void)unused;
    uint64_t seed = 9;
    size_t compared = 0;
    for (size_t k = 0; k < RIG_EXAMPLES; k++) {
        Rig rig = rig_of_example(rig_examples[k]);
        double quick[64], slow[64];
        for (int pose = 0; pose < 20; pose++) {
            if (!rig_shake(&rig, &seed)) continue;
            for (size_t i = 0; i < rig.mech->input_count && pose % 2 == 1; i++) { // at rest: another way
                YkMotion m = {.position = yk_state_input(rig.state, i).position};
                yk_state_set_input(rig.state, i, m);
            }
            assert_true(yk_dynamics_accelerate(rig.dynamics, rig.state, quick) >= 0);
            if (!rig.dynamics->influence) break;
            assert_true(yk_dynamics_reduce(rig.dynamics, rig.state) >= 0);
            memcpy(slow, rig.dynamics->acceleration, rig.mech->input_count * sizeof *slow);
            for (size_t i = 0; i < rig.mech->input_count; i++)
                CHECK_NEAR(quick[i], slow[i], 1e-12 * scale_of(&rig, slow));
            compared++;
        }
        rig_free(&rig);
    }
    assert_true(compared > 100);
}

// What a unit effort at i accelerates at j equals what one at j accelerates at i.
static void responses_are_symmetric(void **unused)
{
    (void)unused;
    uint64_t seed = 5;
    Rig rig = rig_of_example("five-bar-motors");
    double a[2][64];
    assert_true(rig_shake(&rig, &seed));
    double base[64];
    assert_true(rig.mech->input_count == 2);
    for (int i = 0; i < 2; i++) yk_dynamics_set_effort(rig.dynamics, (size_t)rig.mech->inputs[i], 0); // not its own
    assert_true(yk_dynamics_accelerate(rig.dynamics, rig.state, base) >= 0);
    for (int i = 0; i < 2; i++) {
        size_t coordinate = (size_t)rig.mech->inputs[i];
        yk_dynamics_set_effort(rig.dynamics, coordinate, 1);
        assert_true(yk_dynamics_accelerate(rig.dynamics, rig.state, a[i]) >= 0);
        yk_dynamics_set_effort(rig.dynamics, coordinate, 0);
    }
    CHECK_NEAR(a[0][1] - base[1], a[1][0] - base[0], 1e-12 * (fabs(a[0][1]) + fabs(base[1])));
    assert_true(a[0][0] > base[0] && a[1][1] > base[1]);
    rig_free(&rig);
}

static void the_published_double_pendulum(void **unused)
{
    (void)unused;
    Rig rig = rig_of_example("double-pendulum");
    double reduced[2], bodies[2];
    assert_true(yk_dynamics_accelerate(rig.dynamics, rig.state, reduced) >= 0);
    assert_true(yk_dynamics_solve(rig.dynamics, rig.state, YK_METHOD_NEWTON_EULER) >= 0);
    for (size_t i = 0; i < 2; i++) bodies[i] = yk_state_input(rig.state, i).acceleration;
    CHECK_NEAR(reduced[0], -9.55276, 5e-6);
    CHECK_NEAR(reduced[1], -7.09408, 5e-6);
    for (size_t i = 0; i < 2; i++) CHECK_NEAR(reduced[i], bodies[i], 1e-13 * fabs(reduced[i]));
    rig_free(&rig);
}

static void a_freedom_without_inertia_is_named(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text("bodies:\n  ground: {points: {O: [0, 0]}}\n  a: {points: {O: [0, 0], P: [1, 0]}}\n  b: "
                          "{points: {P: [0, 0], Q: [1, 0]}, mass: 1}\n"
                          "joints:\n  O: {pin: [ground, a], angle: x}\n  P: {pin: [b, a], angle: y}\n");
    double a[2];
    assert_int_equal(yk_dynamics_accelerate(rig.dynamics, rig.state, a), YK_SINGULAR);
    assert_non_null(strstr(yk_dynamics_report(rig.dynamics)->message, "no inertia resists"));
    rig_free(&rig);
}

// Moves to a random pose, in which no method may find accelerations. Returns false where the loop does not close.
static bool check_singular(Rig *rig, uint64_t *seed)
{
    double a[64];
    rig_move(rig, seed, 3, 2, 0);
    if (yk_state_solve(rig->state) != YK_OK) {
        assert_true(yk_state_assemble(rig->state) >= 0);
        return false;
    }
    assert_int_equal(yk_dynamics_accelerate(rig->dynamics, rig->state, a), YK_SINGULAR);
    assert_int_equal(yk_dynamics_reduce(rig->dynamics, rig->state), YK_SINGULAR);
    assert_int_equal(yk_dynamics_solve(rig->dynamics, rig->state, YK_METHOD_NEWTON_EULER), YK_SINGULAR);
    return true;
}

// A spring keeps the programs for open trees away; so does a weightless four-bar that carries the tree.
static void freedoms_that_no_mass_shows_are_never_inertia(void **unused)
{
    (void)unused;
    size_t tried = 0;
    for (uint64_t seed = 13000; seed < 13000 + check_cases(300); seed++) {
        uint64_t s = seed;
        Text text = {0};
        LightTree light = light_tree(&s, &text, seed % 2);
        if (lacks_mass(light)) {
            add(&text, "springs: {S: {between: [ground.own, b1.own], stiffness: 100, length: 0.2}}\nstart: {%s}\n",
                seed % 2 ? "q: 1" : "");
            Rig rig = rig_of_text(text.at);
            for (size_t pose = 0; pose < 10; pose++) tried += check_singular(&rig, &s);
            rig_free(&rig);
        }
        free(text.at);
    }
    assert_true(tried >= check_cases(300));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reduced_equations_equal_the_free_bodies),
        cmocka_unit_test(efforts_of_drives_come_from_the_rows_as_well),
        cmocka_unit_test(efforts_of_one_drive_beside_free_inputs_come_from_its_row),
        cmocka_unit_test(influence_coefficients_equal_the_elimination),
        cmocka_unit_test(responses_are_symmetric),
        cmocka_unit_test(the_published_double_pendulum),
        cmocka_unit_test(a_freedom_without_inertia_is_named),
        cmocka_unit_test(freedoms_that_no_mass_shows_are_never_inertia),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
