// Certificates of simulations: what is proved is what small moves find, and planted jumps to other configurations are
// refuted.
#include <yoke/certificate.h>
#include <yoke/move.h>
#include "configurations/truss.h"
#include "simulate/run.h"
#include "simulate/simulation.h"
#include "solve/gap.h"

enum { RANDOM_TRIES = 12 };

// A crank with a triad; with a triad on a dyad; a crank that drives a group of three loops. The crank is the second
// link.
static const char *const links[] = {"hbc ha ad be cf def", "hgbc ha aid ig dk be cf kef",
                                    "hbc ha ade bfg cij df gi je"};
enum { KINDS = sizeof links / sizeof *links };

typedef struct Fall { // of a truss under its weight
    Machine m;
    YkSimulation *sim;
    YkCertifier *certifier;
    char crank[16];
    const char *names[1];
    YkCompileOptions compile;
} Fall;

static void fall_begin(Fall *f, const char *words, uint64_t seed, YkSimulationOptions options)
{
    Truss truss = {.links = words, .mass = 1};
    truss_scatter(&truss, seed);
    *f = (Fall){.m = truss_machine(&truss)};
    snprintf(f->crank, sizeof f->crank, "h%d.angle", (int)strcspn(words, " "));
    f->names[0] = f->crank;
    f->compile = (YkCompileOptions){.inputs = f->names, .input_count = 1};
    options.compile = &f->compile;
    f->sim = yk_simulation_new(f->m.model, &options, f->m.problems);
    if (!f->sim) print_error("%s", yk_problems_text(f->m.problems, 0));
    assert_non_null(f->sim);
    assert_true(f->sim->mech->has_groups);
}

static void fall_watch(Fall *f)
{
    f->certifier = yk_certifier_new(f->m.mech);
    assert_non_null(f->certifier);
    yk_simulation_set_certifier(f->sim, f->certifier);
}

static void fall_end(Fall *f)
{
    yk_simulation_free(f->sim);
    yk_certifier_free(f->certifier);
    machine_free(&f->m);
}

// Returns how far two poses are apart; whole turns do not count.
static double apart(const YkState *a, const YkState *b)
{
    double most = 0;
    for (size_t c = 0; c < a->mech->coordinate_count; c++) {
        double off = yk_state_coordinate(a, c).position - yk_state_coordinate(b, c).position;
        most = fmax(most, yk_gap(a->mech, a->mech->coordinates[c].is_distance, off));
    }
    return most;
}

// --- what is proved

// Follows the crank through the rows by small moves, as long as the simulation keeps its coordinates and the crank goes
// one way.
typedef struct Shadow {
    YkState *state;
    const YkMechanism *mech;
    size_t rows;
} Shadow;

static void follow(Shadow *shadow, YkSimulation *sim)
{
    YkMoveOptions options = yk_default_move_options();
    options.turn_max = 0.002;
    if (!shadow->state || sim->mech != shadow->mech) return;
    YkMotion goal = {yk_state_input(sim->state, 0).position, 0, 0};
    if (yk_state_move_to(shadow->state, &goal, &options, NULL) < 0) {
        shadow->mech = NULL; // the crank has been at its limit between two rows
        return;
    }
    assert_true(apart(shadow->state, sim->state) < 1e-8);
    shadow->rows++;
}

static void check_fall(const char *words, uint64_t seed, size_t *steps, size_t *proved, size_t *followed)
{
    Fall with, without;
    fall_begin(&with, words, seed, run_options(1e-9));
    fall_begin(&without, words, seed, run_options(1e-9));
    fall_watch(&with);
    Shadow shadow = {yk_state_new(with.sim->mech), with.sim->mech, 0};
    assert_true(shadow.state && yk_state_copy(shadow.state, with.sim->state) == YK_OK);
    for (int row = 1; row <= 15; row++) {
        YkStatus one = yk_simulation_advance(with.sim, 0.03 * row),
                 two = yk_simulation_advance(without.sim, 0.03 * row);
        assert_int_equal(one, two);
        if (one != YK_OK) break;
        assert_int_equal(with.sim->mech->coordinate_count, without.sim->mech->coordinate_count);
        for (size_t c = 0; c < with.sim->mech->coordinate_count; c++) // the same bits
            assert_true(yk_state_coordinate(with.sim->state, c).position ==
                        yk_state_coordinate(without.sim->state, c).position);
        if (yk_certifier_report(with.certifier).is_certified) follow(&shadow, with.sim);
        if (with.sim->mech != shadow.mech) yk_state_free(shadow.state), shadow.state = NULL;
    }
    YkMotionCertificate found = yk_certifier_report(with.certifier);
    assert_false(found.is_refuted);
    assert_int_equal(found.is_certified, found.steps == found.proved);
    assert_int_equal(found.is_certified, found.why[0] == 0);
    if (!found.is_certified) assert_true(found.joint[0] != 0 && found.coordinate[0] != 0);
    *steps += found.steps;
    *proved += found.proved;
    *followed += shadow.rows;
    yk_state_free(shadow.state);
    fall_end(&with);
    fall_end(&without);
}

static void falls_of_random_groups_are_certified(void **unused)
{
    (void)unused;
    size_t steps = 0, proved = 0, followed = 0;
    for (size_t k = 0; k < KINDS; k++)
        for (uint64_t seed = 3; seed < 3 + check_cases(RANDOM_TRIES); seed++) // the first two keep no coordinates
            check_fall(links[k], seed, &steps, &proved, &followed);
    print_message("%zu of %zu steps proved, %zu rows followed by small moves\n", proved, steps, followed);
    assert_true(followed > 10 * check_cases(RANDOM_TRIES));
    assert_true(proved * 100 >= steps * 97); // the others are next to dead points
}

// --- planted jumps

typedef struct Planter { // a witness that spoils the state before it passes on what it is told
    YkWitness witness;
    YkWitness *real;
    YkSimulation *sim;
    YkWitnessed kind; // at which it plants
    size_t steps, from, until, planted;
    YkState *other;
    double most;
} Planter;

static bool choose(void *context, YkState *state)
{
    Planter *p = context;
    double off = apart(state, p->sim->state);
    if (off <= p->most) return true;
    p->most = off;
    return yk_state_copy(p->other, state) == YK_OK;
}

// Puts the simulation's state on another configuration at its inputs, if there is one.
static void plant(Planter *p)
{
    YkState *probe = yk_state_new(p->sim->mech);
    YkConfigurations *all = yk_configurations_new(p->sim->mech);
    p->other = yk_state_new(p->sim->mech);
    assert_true(probe && all && p->other && yk_state_copy(probe, p->sim->state) == YK_OK);
    double time = p->sim->state->time;
    p->most = p->sim->mech->has_groups ? 0.05 : INFINITY; // other coordinates may make dyads of all
    yk_configurations_each(all, probe, NULL, choose, p, NULL);
    if (p->most > 0.05 && p->most < INFINITY) {
        yk_state_take(p->sim->state, p->other);
        p->sim->state->time = time;
        p->planted++;
    }
    yk_configurations_free(all);
    yk_state_free(probe);
    yk_state_free(p->other);
}

static void planter_begin(YkWitness *witness, const YkState *state)
{
    Planter *p = (Planter *)witness;
    p->real->begin(p->real, state);
}

static bool planter_step(YkWitness *witness, const YkState *state, YkWitnessed kind)
{
    Planter *p = (Planter *)witness;
    p->steps += kind == p->kind;
    if (kind == p->kind && p->steps > p->from && p->steps <= p->until) plant(p);
    return p->real->step(p->real, state, kind);
}

static void planter_change(YkWitness *witness, const YkState *from, const YkState *to)
{
    Planter *p = (Planter *)witness;
    p->real->change(p->real, from, to);
}

static Planter planter_of(const Fall *f, YkWitnessed kind, size_t from, size_t until)
{
    Planter p = {.witness = {.begin = planter_begin, .step = planter_step, .change = planter_change},
                 .real = (YkWitness *)f->certifier,
                 .sim = f->sim,
                 .kind = kind,
                 .from = from,
                 .until = until};
    return p;
}

static YkStatus run_to(Fall *f, double time)
{
    YkStatus status = YK_OK;
    for (int row = 1; row <= 8 && status == YK_OK; row++) status = yk_simulation_advance(f->sim, time * row / 8);
    return status;
}

// A jump within a step, the first one too, is taken back, and the motion goes on as if nothing had been.
static void check_taken_back(const char *words, uint64_t seed, size_t from, size_t *taken, size_t *same)
{
    Fall plain, jumpy;
    fall_begin(&plain, words, seed, run_options(1e-10));
    fall_begin(&jumpy, words, seed, run_options(1e-10));
    fall_watch(&plain);
    fall_watch(&jumpy);
    Planter p = planter_of(&jumpy, YK_WITNESS_TRY, from, from + 1);
    jumpy.sim->witness = &p.witness;
    YkStatus one = run_to(&plain, 0.2), two = run_to(&jumpy, 0.2);
    YkMotionCertificate first = yk_certifier_report(plain.certifier), second = yk_certifier_report(jumpy.certifier);
    *taken += p.planted;
    if (one == YK_OK && first.is_certified && p.planted > 0) {
        assert_int_equal(two, YK_OK);
        assert_false(second.is_refuted);
        assert_true(apart(plain.sim->state, jumpy.sim->state) < 1e-6);
        *same += second.is_certified;
    }
    jumpy.sim->witness = NULL;
    fall_end(&plain);
    fall_end(&jumpy);
}

static void a_jump_within_a_step_is_taken_back(void **unused)
{
    (void)unused;
    for (size_t from = 0; from <= 2; from += 2) {
        size_t taken = 0, same = 0;
        for (size_t k = 0; k < KINDS; k++)
            for (uint64_t seed = 1; seed <= check_cases(RANDOM_TRIES); seed++)
                check_taken_back(links[k], seed, from, &taken, &same);
        print_message("%zu jumps planted in steps, %zu motions go on, certified\n", taken, same);
        assert_true(taken > check_cases(RANDOM_TRIES) && same * 10 > taken * 7);
    }
}

// Jumps at every trial, at the end of a step, or at a row: the motion ends there, and says so.
static void check_refuted(const char *words, uint64_t seed, YkWitnessed kind, size_t *planted, size_t *refuted)
{
    Fall f;
    fall_begin(&f, words, seed, run_options(1e-9));
    fall_watch(&f);
    Planter p = planter_of(&f, kind, 2, SIZE_MAX);
    f.sim->witness = &p.witness;
    YkStatus status = run_to(&f, 0.2);
    YkMotionCertificate found = yk_certifier_report(f.certifier);
    if (p.planted > 0) {
        *planted += 1;
        *refuted += found.is_refuted;
        if (found.is_refuted) {
            assert_int_equal(status, YK_NOT_CONVERGED);
            assert_non_null(strstr(yk_simulation_report(f.sim)->message, "another configuration"));
            assert_non_null(strstr(found.message, "refuted"));
        }
    }
    f.sim->witness = NULL;
    fall_end(&f);
}

static void jumps_that_stay_end_the_motion(void **unused)
{
    (void)unused;
    static const YkWitnessed kinds[] = {YK_WITNESS_STEP, YK_WITNESS_TRY, YK_WITNESS_ASIDE};
    for (size_t j = 0; j < 3; j++) {
        size_t planted = 0, refuted = 0;
        for (size_t k = 0; k < KINDS; k++)
            for (uint64_t seed = 1; seed <= check_cases(RANDOM_TRIES); seed++)
                check_refuted(links[k], seed, kinds[j], &planted, &refuted);
        print_message("%zu motions with jumps, %zu refuted\n", planted, refuted);
        assert_true(planted > check_cases(RANDOM_TRIES) && refuted * 10 > planted * 9);
    }
}

// --- the door

static const char *const triad = "bodies:\n"
                                 "  ground:  {points: {O2: [0, 0], O4: [4, 0], O6: [6, 2.5]}}\n"
                                 "  crank:   {points: {O2: [0, 0], A: [1, 0]}, mass: 1, inertia: 0.1}\n"
                                 "  coupler: {points: {A: [0, 0], B: [3.5, 0], C: [2, 1.5]}, mass: 1, inertia: 0.2}\n"
                                 "  rocker:  {points: {O4: [0, 0], B: [3, 0]}, mass: 1, inertia: 0.2}\n"
                                 "  link:    {points: {C: [0, 0], D: [4.5, 0]}, mass: 1, inertia: 0.2}\n"
                                 "  output:  {points: {O6: [0, 0], D: [2.5, 0]}, mass: 1, inertia: 0.2}\n"
                                 "joints:\n"
                                 "  O6: {pin: [ground, output], angle: theta6}\n"
                                 "  D:  {pin: [output, link], angle: theta5}\n"
                                 "  O2: {pin: [ground, crank], angle: theta2}\n"
                                 "  A:  {pin: [crank, coupler], angle: theta3}\n"
                                 "  O4: {pin: [ground, rocker], angle: theta4}\n"
                                 "  B:  {pin: [coupler, rocker]}\n"
                                 "  C:  {pin: [coupler, link]}\n"
                                 "%s"
                                 "start: {theta6: 120 deg, theta6.rate: 1 rad/s, theta2: 120 deg, theta3: -90 deg,\n"
                                 "  theta4: 119 deg, theta5: -101 deg}\n";

// The motion passes dead points of its first coordinate, where others become independent, bounces at a stop, and is
// certified all along; the certifier has watched a move to the start before, and goes on after a reset.
static void the_certificate_passes_dead_points_and_stops(void **unused)
{
    (void)unused;
    char text[2000];
    snprintf(text, sizeof text, triad, "stops: {theta4: {between: [60 deg, 130 deg], restitution: 0.9}}\n");
    Run run = run_of_text(text, run_options(1e-9));
    YkCertifier *c = yk_certifier_new(yk_state_mechanism(yk_simulation_state(run.sim)));
    yk_simulation_set_certifier(run.sim, c);
    for (int row = 1; row <= 100; row++) assert_int_equal(yk_simulation_advance(run.sim, 0.03 * row), YK_OK);
    YkMotionCertificate found = yk_certifier_report(c);
    size_t stopped = 0;
    for (size_t k = 0; k < yk_simulation_happening_count(run.sim); k++)
        stopped += yk_simulation_happening(run.sim, k).kind == YK_HAPPENING_STOP;
    print_message("%zu of %zu steps, %zu impacts, %zu changes of coordinates\n", found.proved, found.steps, stopped,
                  yk_simulation_summary(run.sim).recoordinations);
    assert_true(stopped > 0 && yk_simulation_summary(run.sim).recoordinations > 0);
    assert_true(found.is_needed && found.is_certified && found.steps >= 20);
    assert_int_equal(yk_simulation_reset(run.sim), YK_OK);
    assert_int_equal(yk_simulation_advance(run.sim, 0.5), YK_OK);
    YkMotionCertificate again = yk_certifier_report(c);
    assert_true(again.is_certified && again.steps > found.steps);
    run_free(&run);
    assert_true(yk_certifier_report(c).is_certified);
    yk_certifier_free(c);
}

// --- other coordinates

// Makes a mechanism of the triad with an input of its own, and a state of it at its guesses.
static YkState *state_with(const Machine *m, const char *input, YkMechanism **mech)
{
    YkCompileOptions options = {.inputs = &input, .input_count = 1};
    *mech = yk_mechanism_compile(m->model, &options, m->problems);
    YkState *state = *mech ? yk_state_new(*mech) : NULL;
    assert_true(state && yk_state_assemble(state) == YK_OK);
    return state;
}

typedef struct Others {
    const YkState *home;
    YkState *state;
    size_t kept;
} Others;

static bool keep_other(void *context, YkState *state)
{
    Others *others = context;
    if (others->kept > 0 || apart(state, others->home) < 0.05) return true;
    others->kept++;
    return yk_state_copy(others->state, state) == YK_OK;
}

// With the crank as input all is in closed form; with the output there is a group. A change of inputs is certified if
// the pose stays, and not if another configuration takes its place, whichever of the two comes first.
static void other_inputs_have_the_same_pose(void **unused)
{
    (void)unused;
    char text[2000];
    snprintf(text, sizeof text, triad, "");
    Machine m = machine_parse(text, true);
    YkMechanism *dyads, *group;
    YkState *by_crank = state_with(&m, "theta2", &dyads), *by_output = state_with(&m, "theta6", &group);
    assert_true(!dyads->has_groups && group->has_groups);
    yk_state_set_input(by_output, 0,
                       (YkMotion){yk_state_coordinate(by_crank, yk_coordinate_find(dyads, "theta6")).position, 0, 0});
    assert_int_equal(yk_state_solve(by_output), YK_OK);
    YkState *probe = yk_state_new(group);
    Others others = {by_output, yk_state_new(group), 0};
    YkConfigurations *all = yk_configurations_new(group);
    assert_true(probe && others.state && all && yk_state_copy(probe, by_output) == YK_OK);
    yk_configurations_each(all, probe, NULL, keep_other, &others, NULL);
    assert_int_equal(others.kept, 1);
    const YkState *const ways[4][2] = {
        {by_crank, by_output}, {by_output, by_crank}, {by_crank, others.state}, {others.state, by_crank}};
    for (size_t k = 0; k < 4; k++) {
        YkCertifier *c = yk_certifier_new(ways[k][0]->mech);
        assert_non_null(c);
        YkWitness *witness = (YkWitness *)c;
        witness->begin(witness, ways[k][0]);
        witness->change(witness, ways[k][0], ways[k][1]);
        YkMotionCertificate found = yk_certifier_report(c);
        assert_int_equal(found.is_certified, k < 2);
        assert_int_equal(strstr(found.why, "other inputs") != NULL, k >= 2);
        yk_certifier_free(c);
    }
    yk_configurations_free(all);
    yk_state_free(probe);
    yk_state_free(others.state);
    yk_state_free(by_crank);
    yk_state_free(by_output);
    yk_mechanism_free(dyads);
    yk_mechanism_free(group);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(falls_of_random_groups_are_certified),
        cmocka_unit_test(a_jump_within_a_step_is_taken_back),
        cmocka_unit_test(jumps_that_stay_end_the_motion),
        cmocka_unit_test(the_certificate_passes_dead_points_and_stops),
        cmocka_unit_test(other_inputs_have_the_same_pose),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
