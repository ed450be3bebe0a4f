// Random linkages with gears, belts, racks, cams and laws between links that one loop places: they close, with rates
// that are derivatives, forces on which two formulations agree, energy that is conserved. YOKE_TEST_RANDOM=100000 in
// the environment runs so many.
#include <stdlib.h>
#include "random_geared.h"
#include "rig.h"

enum { MACHINES = 400 };
static Geared machine;
static uint64_t machine_number; // for messages

static uint64_t machine_count(void)
{
    const char *wish = getenv("YOKE_TEST_RANDOM");
    return wish ? strtoull(wish, NULL, 10) : check_cases(MACHINES);
}

static bool make(Rig *rig, uint64_t number)
{
    machine_number = number;
    geared_machine(&machine, number);
    *rig = (Rig){.problems = yk_problems_new()};
    rig->model = yk_model_parse(machine.text, strlen(machine.text), "geared.yaml", NULL, rig->problems);
    if (rig->model) rig->mech = yk_mechanism_compile(rig->model, NULL, rig->problems);
    if (!rig->mech)
        fprintf(stderr, "machine %lu\n%s%s", (unsigned long)number, machine.text, yk_problems_text(rig->problems, 0));
    assert_non_null(rig->mech);
    rig->state = yk_state_new(rig->mech);
    rig->dynamics = yk_dynamics_new(rig->mech, rig->problems);
    assert_non_null(rig->dynamics);
    if (yk_state_assemble(rig->state) >= 0) return true;
    rig_free(rig);
    return false;
}

static bool is_calm(const Rig *rig, double margin)
{
    return yk_state_has_rates(rig->state) && rig->state->space.margin[0] > margin;
}

// Draws a motion of the inputs near the start and goes there; false where it does not close or comes to a dead point.
static bool move(Rig *rig, uint64_t *seed)
{
    for (size_t i = 0; i < rig->mech->input_count; i++) {
        YkMotion m = yk_state_input(rig->state, i);
        m.position += check_uniform(seed, -0.2, 0.2);
        m.velocity = check_uniform(seed, -1, 1);
        m.acceleration = check_uniform(seed, -1, 1);
        yk_state_set_input(rig->state, i, m);
    }
    return yk_state_solve(rig->state) >= 0 && is_calm(rig, 1e-4);
}

static void the_freedom_is_as_counted(void **unused)
{
    (void)unused;
    size_t grouped = 0, closed = 0;
    for (uint64_t k = 0; k < machine_count(); k++) {
        Rig rig;
        if (!make(&rig, k)) continue;
        closed++;
        YkFreedom freedom = yk_mechanism_freedom(rig.mech);
        assert_int_equal(freedom.gruebler, machine.freedom);
        assert_int_equal(freedom.by_rank, machine.freedom);
        for (size_t b = 0; b < rig.mech->block_count; b++) grouped += rig.mech->blocks[b].relation_count;
        rig_free(&rig);
    }
    assert_true(closed > machine_count() * 9 / 10);
    assert_true(grouped > machine_count() / 2); // it is these that the test is about
}

// Rates by differences of poses along the motion, in all bodies' angles and all distances.
static double worst_difference(Rig *rig)
{
    enum { MOST = 16 };
    double at[5][MOST], worst = 0, fastest = 1;
    size_t n = rig->mech->coordinate_count;
    YkMotion start[MOST], here[MOST], input[MOST];
    for (size_t i = 0; i < rig->mech->input_count; i++) input[i] = yk_state_input(rig->state, i);
    for (size_t c = 0; c < n; c++) here[c] = yk_state_coordinate(rig->state, c);
    for (size_t c = 0; c < n; c++) fastest = fmax(fastest, fabs(here[c].velocity));
    double h = 1e-3 / fastest;
    for (int k = 0; k < 5; k++) {
        double t = (k - 2) * h;
        for (size_t i = 0; i < rig->mech->input_count; i++) {
            start[i] = input[i];
            start[i].position += t * (input[i].velocity + 0.5 * t * input[i].acceleration);
            yk_state_set_input(rig->state, i, start[i]);
        }
        if (yk_state_solve(rig->state) < 0) return 0;
        for (size_t c = 0; c < n; c++) at[k][c] = yk_state_coordinate(rig->state, c).position;
    }
    for (size_t c = 0; c < n; c++) {
        double v = (at[0][c] - 8 * at[1][c] + 8 * at[3][c] - at[4][c]) / (12 * h);
        double a = (-at[0][c] + 16 * at[1][c] - 30 * at[2][c] + 16 * at[3][c] - at[4][c]) / (12 * h * h);
        double size = 1 + fabs(here[c].velocity) + fabs(here[c].acceleration);
        worst = fmax(worst, fabs(v - here[c].velocity) / size + 1e-3 * fabs(a - here[c].acceleration) / size);
    }
    return worst;
}

static void poses_close_and_rates_are_derivatives(void **unused)
{
    (void)unused;
    size_t checked = 0;
    for (uint64_t k = 0; k < machine_count(); k++) {
        Rig rig;
        if (!make(&rig, k)) continue;
        for (uint64_t pose = 0, seed = 5 * k; pose < 3; pose++) {
            if (!move(&rig, &seed)) break;
            double loose = 1 / rig.state->space.margin[0];
            YkResiduals r = yk_state_residuals(rig.state);
            CHECK_NEAR(r.position, 0, 1e-12);
            CHECK_NEAR(r.velocity, 0, 1e-13 * loose);
            CHECK_NEAR(r.acceleration, 0, 1e-12 * loose);
            if (!is_calm(&rig, 1e-2)) continue;
            double off = worst_difference(&rig);
            if (!(off < 1e-6)) print_error("machine %lu: %g\n", (unsigned long)k, off);
            assert_true(off < 1e-6);
            checked++;
        }
        rig_free(&rig);
    }
    assert_true(checked > machine_count());
}

// What a solution says, to be compared.
typedef struct Answer {
    double acceleration[16], effort[16];
    YkReaction reaction[16];
} Answer;

static bool solve(Rig *rig, YkMethod method, Answer *answer)
{
    if (yk_dynamics_solve(rig->dynamics, rig->state, method) != YK_OK) return false;
    for (size_t i = 0; i < rig->mech->input_count; i++) {
        answer->acceleration[i] = yk_state_input(rig->state, i).acceleration;
        answer->effort[i] = rig->dynamics->drive[i];
    }
    for (size_t j = 0; j < yk_model_joint_count(rig->model); j++)
        answer->reaction[j] = yk_dynamics_reaction(rig->dynamics, j);
    return true;
}

static void forces_by_both_formulations_and_by_power(void **unused)
{
    (void)unused;
    size_t compared = 0;
    static Answer reduced, bodies;
    for (uint64_t k = 0; k < machine_count(); k++) {
        Rig rig;
        if (!make(&rig, k)) continue;
        for (size_t i = 1; i < rig.mech->input_count; i++) yk_dynamics_prescribe(rig.dynamics, i, k % 2); // mixed
        for (uint64_t pose = 0, seed = 11 * k; pose < 3; pose++) {
            if (!move(&rig, &seed)) break;
            double loose = 1 / rig.state->space.margin[0], most = 1;
            if (!solve(&rig, YK_METHOD_REDUCED, &reduced)) continue;
            rig_check_balance(&rig, 1e-11, loose, machine_number);
            assert_true(solve(&rig, YK_METHOD_NEWTON_EULER, &bodies));
            rig_check_balance(&rig, 1e-11, loose, machine_number);
            double force = rig.dynamics->largest_force + 1, moment = force * rig.mech->size;
            for (size_t i = 0; i < rig.mech->input_count; i++) most = fmax(most, fabs(bodies.acceleration[i]));
            for (size_t i = 0; i < rig.mech->input_count; i++) {
                CHECK_NEAR(reduced.acceleration[i], bodies.acceleration[i], 1e-11 * loose * most);
                CHECK_NEAR(reduced.effort[i], bodies.effort[i], 1e-11 * loose * moment);
            }
            for (size_t j = 0; j < yk_model_joint_count(rig.model); j++) {
                CHECK_NEAR(reduced.reaction[j].force[0], bodies.reaction[j].force[0], 1e-11 * loose * force);
                CHECK_NEAR(reduced.reaction[j].force[1], bodies.reaction[j].force[1], 1e-11 * loose * force);
                CHECK_NEAR(reduced.reaction[j].moment, bodies.reaction[j].moment, 1e-11 * loose * moment);
            }
            compared++;
        }
        rig_free(&rig);
    }
    assert_true(compared > machine_count());
}

static void motions_keep_their_energy(void **unused)
{
    (void)unused;
    size_t ran = 0, count = machine_count() / 8;
    for (uint64_t k = 0; k < count; k++) {
        Rig rig;
        if (!make(&rig, k)) continue;
        YkSimulationOptions options = yk_default_simulation_options();
        options.tolerance = 1e-10;
        options.steps_max = 3000;
        YkSimulation *sim = yk_simulation_new(rig.model, &options, rig.problems);
        if (sim && yk_simulation_advance(sim, 0.3) == YK_OK) {
            YkSimulationSummary s = yk_simulation_summary(sim);
            if (!(s.energy_error < 1e-6 && s.worst_residual < 1e-11))
                print_error("machine %lu: energy %g, residual %g\n", (unsigned long)k, s.energy_error,
                            s.worst_residual);
            assert_true(s.energy_error < 1e-6 && s.worst_residual < 1e-11);
            ran++;
        }
        yk_simulation_free(sim);
        rig_free(&rig);
    }
    assert_true(ran > count / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_freedom_is_as_counted),
        cmocka_unit_test(poses_close_and_rates_are_derivatives),
        cmocka_unit_test(forces_by_both_formulations_and_by_power),
        cmocka_unit_test(motions_keep_their_energy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
