// Certificates of motions: what is proved is what small steps find, and a jump to another configuration is refused.
#include <yoke/certificate.h>
#include <yoke/move.h>
#include "configurations/truss.h"
#include "solve/gap.h"
#include "solve/state.h"

enum { ALL_MAX = 64, RANDOM_TRIES = 12 };

// A crank with a triad; with a triad on a dyad; a crank that drives a group of three loops. The crank is the second
// link.
static const char *const links[] = {"hbc ha ad be cf def", "hgbc ha aid ig dk be cf kef",
                                    "hbc ha ade bfg cij df gi je"};

static Machine truss_of(const char *words, uint64_t seed)
{
    Truss truss = {.links = words};
    truss_scatter(&truss, seed);
    Machine m = truss_machine(&truss);
    char crank[16];
    snprintf(crank, sizeof crank, "h%d.angle", (int)strcspn(words, " "));
    yk_state_free(m.state);
    yk_mechanism_free(m.mech);
    machine_compile(&m, crank);
    assert_true(m.mech->has_groups && yk_input_count(m.mech) == 1);
    assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
    return m;
}

static double input_of(const YkState *s)
{
    return yk_state_input(s, 0).position;
}

// Returns how far two poses of a machine are apart; whole turns do not count.
static double apart(const YkState *a, const YkState *b)
{
    double most = 0;
    for (size_t c = 0; c < a->mech->coordinate_count; c++) {
        double off = yk_state_coordinate(a, c).position - yk_state_coordinate(b, c).position;
        most = fmax(most, yk_gap(a->mech, a->mech->coordinates[c].is_distance, off));
    }
    return most;
}

static YkStatus move_by(YkState *s, double way, double turn_max)
{
    YkMotion goal = {input_of(s) + way, 0, 0};
    YkMoveOptions options = yk_default_move_options();
    options.turn_max = turn_max;
    return yk_state_move_to(s, &goal, &options, NULL);
}

// Proves a single step between two poses.
static YkMotionCertificate step_between(const YkState *from, const YkState *to)
{
    YkCertifier *c = yk_certifier_new(from->mech);
    YkState *watched = yk_state_new(from->mech);
    assert_true(c && watched && yk_state_set_certifier(watched, c) == YK_OK);
    watched->witness->begin(watched->witness, from);
    watched->witness->step(watched->witness, to, YK_WITNESS_STEP);
    YkMotionCertificate found = yk_certifier_report(c);
    yk_state_free(watched);
    yk_certifier_free(c);
    assert_true(found.steps == 1 && found.is_needed);
    return found;
}

// --- sweeps

static void check_sweep(const char *words, uint64_t seed, size_t *steps, size_t *proved)
{
    Machine m = truss_of(words, seed);
    YkState *fine = yk_state_new(m.mech);
    YkCertifier *c = yk_certifier_new(m.mech);
    assert_true(fine && c && yk_state_copy(fine, m.state) == YK_OK);
    assert_int_equal(yk_state_set_certifier(m.state, c), YK_OK);
    YkSweepOptions options = yk_default_sweep_options();
    options.coordinate = (int)yk_input_coordinate(m.mech, 0);
    options.from = input_of(m.state);
    options.to = options.from + 0.6;
    options.steps = 9;
    YkSweep *sweep = yk_sweep_run(m.state, &options, NULL, 0, m.problems);
    assert_non_null(sweep);
    YkMotionCertificate found = yk_certifier_report(c);
    if (yk_sweep_status(sweep) == YK_OK && found.is_certified) {
        assert_true(found.steps >= 17); // a step is 2 degrees at most
        assert_true(move_by(fine, 0.6, 0.002) >= 0);
        assert_true(apart(m.state, fine) < 1e-9);
    }
    assert_false(found.is_refuted);
    assert_int_equal(found.is_certified, found.steps == found.proved);
    assert_int_equal(found.input, found.is_certified ? -1 : 0);
    *steps += found.steps;
    *proved += found.proved;
    yk_sweep_free(sweep);
    yk_certifier_free(c);
    yk_state_free(fine);
    machine_free(&m);
}

static void test_sweeps_of_random_groups_are_certified(void **unused)
{
    (void)unused;
    size_t steps = 0, proved = 0;
    for (size_t k = 0; k < sizeof links / sizeof *links; k++)
        for (uint64_t seed = 1; seed <= check_cases(RANDOM_TRIES); seed++) check_sweep(links[k], seed, &steps, &proved);
    print_message("%zu of %zu steps proved\n", proved, steps);
    assert_true(steps > 3 * 12 * check_cases(RANDOM_TRIES) / 2);
    assert_true(proved * 100 >= steps * 98); // the others are next to limits
}

// --- planted jumps

typedef struct All {
    YkState *states[ALL_MAX];
    size_t count;
} All;

static bool keep(void *context, YkState *state)
{
    All *all = context;
    YkState *copy = yk_state_new(state->mech);
    assert_true(copy && yk_state_copy(copy, state) == YK_OK && all->count < ALL_MAX);
    all->states[all->count++] = copy;
    return true;
}

static void check_jumps(const char *words, uint64_t seed, size_t *jumps, size_t *stays)
{
    Machine m = truss_of(words, seed);
    YkConfigurations *configurations = yk_configurations_new(m.mech);
    All all = {.count = 0};
    yk_configurations_each(configurations, m.state, NULL, keep, &all, NULL);
    for (size_t i = 0; i < all.count; i++) {
        YkState *moved = yk_state_new(m.mech);
        assert_true(moved && yk_state_copy(moved, all.states[i]) == YK_OK);
        bool moves = move_by(moved, 0.01, 0.001) == YK_OK;
        for (size_t k = 0; moves && k < all.count; k++) {
            YkMotionCertificate found = step_between(all.states[k], moved);
            if (k != i) assert_int_equal(found.proved, 0);
            if (k == i) assert_false(found.is_refuted);
            *jumps += k != i && found.is_refuted;
            *stays += k == i && found.is_certified;
        }
        yk_state_free(moved);
    }
    for (size_t k = 0; k < all.count; k++) yk_state_free(all.states[k]);
    yk_configurations_free(configurations);
    machine_free(&m);
}

static void test_a_jump_to_another_configuration_is_refused(void **unused)
{
    (void)unused;
    size_t jumps = 0, stays = 0;
    for (size_t k = 0; k < sizeof links / sizeof *links; k++)
        for (uint64_t seed = 1; seed <= check_cases(RANDOM_TRIES); seed++) check_jumps(links[k], seed, &jumps, &stays);
    print_message("%zu jumps refuted, %zu steps proved\n", jumps, stays);
    assert_true(jumps > 2 * check_cases(RANDOM_TRIES) && stays > 4 * check_cases(RANDOM_TRIES));
}

// --- steps so large that the nearest configuration is another one

static void check_large_step(const char *words, uint64_t seed, size_t *gone, size_t *proved)
{
    Machine m = truss_of(words, seed);
    double way = check_uniform(&seed, -1, 1);
    YkState *naive = yk_state_new(m.mech), *truth = yk_state_new(m.mech);
    assert_true(naive && truth && yk_state_copy(truth, m.state) == YK_OK);
    assert_true(yk_state_guess(naive, m.state) >= 0);
    yk_state_set_input(naive, 0, (YkMotion){input_of(m.state) + way, 0, 0});
    if (yk_state_assemble(naive) == YK_OK) {
        bool arrives = move_by(truth, way, 0.002) >= 0, is_other = !arrives || apart(naive, truth) > 1e-6;
        YkMotionCertificate found = step_between(m.state, naive);
        if (is_other) assert_int_equal(found.proved, 0);
        if (found.is_refuted) assert_true(is_other);
        *gone += is_other;
        *proved += found.proved;
    }
    yk_state_free(naive);
    yk_state_free(truth);
    machine_free(&m);
}

static void test_large_steps_are_proved_or_refused(void **unused)
{
    (void)unused;
    size_t gone = 0, proved = 0;
    for (size_t k = 0; k < sizeof links / sizeof *links; k++)
        for (uint64_t seed = 1; seed <= 2 * check_cases(RANDOM_TRIES); seed++)
            check_large_step(links[k], seed, &gone, &proved);
    print_message("%zu went over to others, %zu are proved\n", gone, proved);
    assert_true(gone > check_cases(RANDOM_TRIES) / 2 && proved > check_cases(RANDOM_TRIES) / 2);
}

// --- ways round a limit

// Two cranks and the ground carry a triad. A move that goes round a limit is proved along the way that it found,
// however many it has tried; ways with finer checks lead to the same pose.
static void check_detour(uint64_t seed, size_t *detours, size_t *certified)
{
    Truss truss = {.links = "hgc ha gb ad be cf def"};
    truss_scatter(&truss, seed);
    Machine m = truss_machine(&truss);
    const char *names[] = {"h3.angle", "g5.angle"};
    YkMechanism *mech = yk_mechanism_compile(m.model, &(YkCompileOptions){names, 2}, m.problems);
    assert_true(mech && mech->has_groups && yk_input_count(mech) == 2);
    YkState *s = yk_state_new(mech), *fine = yk_state_new(mech);
    YkCertifier *c = yk_certifier_new(mech);
    assert_true(s && fine && c && yk_state_assemble(s) >= 0 && yk_state_copy(fine, s) == YK_OK);
    assert_int_equal(yk_state_set_certifier(s, c), YK_OK);
    YkMotion goal[2] = {{0}};
    for (size_t i = 0; i < 2; i++) goal[i].position = yk_state_input(s, i).position + check_uniform(&seed, -2, 2);
    YkMoveOptions options = yk_default_move_options();
    options.detours = 25;
    YkMove move;
    YkStatus status = yk_state_move_to(s, goal, &options, &move);
    YkMotionCertificate found = yk_certifier_report(c);
    assert_false(found.is_refuted);
    if (status >= 0 && move.is_detour) {
        *detours += 1;
        *certified += found.is_certified;
        assert_true(found.steps > 1);
        options.turn_max *= 0.25;
        if (found.is_certified && yk_state_move_to(fine, goal, &options, &move) >= 0 && move.is_detour)
            assert_true(apart(s, fine) < 1e-9);
    } else if (status == YK_LIMIT) {
        assert_true(found.steps == 0 || found.input >= 0 || found.is_certified); // the straight way alone
    }
    yk_state_free(s);
    yk_state_free(fine);
    yk_mechanism_free(mech);
    yk_certifier_free(c);
    machine_free(&m);
}

static void test_ways_round_a_limit_are_certified(void **unused)
{
    (void)unused;
    check_without_sanitizers();
    size_t detours = 0, certified = 0;
    uint64_t tries = getenv("YOKE_FULL") ? 36 : 10; // 3 of 36 go round, 2 of 10
    for (uint64_t seed = 1; seed <= tries; seed++) check_detour(seed, &detours, &certified);
    print_message("%zu of %zu ways round are certified\n", certified, detours);
    assert_true(detours > 1 && certified * 10 >= detours * 8);
}

// --- examples and the door

static void test_dyads_need_no_certificate(void **unused)
{
    (void)unused;
    Machine m = machine_load("four-bar"), other = machine_load("double-butterfly");
    YkCertifier *c = yk_certifier_new(m.mech);
    assert_int_equal(yk_state_set_certifier(m.state, c), YK_OK);
    assert_int_equal(yk_state_set_certifier(other.state, c), YK_BAD_ARGUMENT);
    assert_true(move_by(m.state, 0.3, 0.03) >= 0);
    YkMotionCertificate found = yk_certifier_report(c);
    assert_true(!found.is_needed && found.is_certified && found.steps == 0);
    yk_state_set_certifier(m.state, NULL);
    yk_certifier_free(c);
    assert_true(move_by(m.state, 0.3, 0.03) >= 0);
    yk_certifier_free(NULL);
    machine_free(&m);
    machine_free(&other);
}

// Many whole turns are left out of a long move, and the rest is proved.
static void test_moves_of_many_turns_are_certified(void **unused)
{
    (void)unused;
    Machine m = machine_load("stephenson-awkward");
    YkState *there = yk_state_new(m.mech);
    YkCertifier *c = yk_certifier_new(m.mech);
    assert_true(there && c && yk_state_set_certifier(m.state, c) == YK_OK && yk_state_copy(there, m.state) == YK_OK);
    YkStatus status = move_by(m.state, 1e5 * 2 * YK_PI + 0.1, 0.03);
    YkMotionCertificate found = yk_certifier_report(c);
    assert_true(found.steps > 0 && found.steps < 100000);
    if (status >= 0) assert_true(found.is_certified);
    yk_state_free(there);
    machine_free(&m);
    yk_certifier_free(c);
}

// A motion that begins at no pose proves nothing, whatever the certifier has seen before.
static void test_a_motion_from_nowhere_is_not_certified(void **unused)
{
    (void)unused;
    Machine m = machine_load("double-butterfly");
    YkState *next = yk_state_new(m.mech), *fresh = yk_state_new(m.mech);
    YkCertifier *c = yk_certifier_new(m.mech);
    assert_true(next && fresh && c && yk_state_copy(next, m.state) == YK_OK && move_by(next, 0.01, 0.03) >= 0);
    assert_int_equal(yk_state_set_certifier(m.state, c), YK_OK);
    YkWitness *witness = m.state->witness;
    witness->begin(witness, m.state);
    witness->step(witness, next, YK_WITNESS_STEP);
    assert_int_equal(yk_certifier_report(c).proved, 1);
    assert_false(fresh->has_pose);
    witness->begin(witness, fresh);
    witness->step(witness, m.state, YK_WITNESS_STEP);
    YkMotionCertificate found = yk_certifier_report(c);
    assert_true(found.steps == 2 && found.proved == 1 && !found.is_certified);
    yk_state_free(next);
    yk_state_free(fresh);
    machine_free(&m);
    yk_certifier_free(c);
}

// Two loops tied by gears are outside of what is proved: it says so and proves nothing.
static void test_gears_in_a_group_are_not_certified(void **unused)
{
    (void)unused;
    Machine m = machine_load("geared-five-bar");
    YkCertifier *c = yk_certifier_new(m.mech);
    assert_int_equal(yk_state_set_certifier(m.state, c), YK_OK);
    move_by(m.state, 0.1, 0.03);
    YkMotionCertificate found = yk_certifier_report(c);
    assert_true(found.is_needed && !found.is_certified && found.input == -1);
    assert_true(found.steps > 0 && found.proved == 0);
    assert_non_null(strstr(found.message, "gears"));
    machine_free(&m);
    yk_certifier_free(c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sweeps_of_random_groups_are_certified),
        cmocka_unit_test(test_a_jump_to_another_configuration_is_refused),
        cmocka_unit_test(test_large_steps_are_proved_or_refused),
        cmocka_unit_test(test_ways_round_a_limit_are_certified),
        cmocka_unit_test(test_dyads_need_no_certificate),
        cmocka_unit_test(test_moves_of_many_turns_are_certified),
        cmocka_unit_test(test_a_motion_from_nowhere_is_not_certified),
        cmocka_unit_test(test_gears_in_a_group_are_not_certified),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
