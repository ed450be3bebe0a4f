// The watch over branches, on margins and turns made up for it: a zero between two poses is never passed over, poses
// well away from one are clear, a swing is reported at its pose, and all of it wherever the lanes are divided.
#include "machine.h"
#include "solve/watch.h"

enum { POSES = 48 };
static double margin[POSES], angle[2][POSES]; // of the path
static size_t moving;                         // the dyad that goes so; the other stands still

static Machine machine;
static YkSpace space;

static int start(void **unused)
{
    (void)unused;
    machine = machine_load("stephenson-six-bar");
    assert_int_equal(machine.mech->block_count, 2);
    return yk_space_start(&space, machine.mech, POSES, true) ? 0 : -1;
}

static int end(void **unused)
{
    (void)unused;
    yk_space_end(&space);
    machine_free(&machine);
    return 0;
}

// Lays poses from `at` into the lanes.
static void fill(size_t at, size_t n)
{
    for (size_t b = 0; b < 2; b++)
        for (size_t k = 0; k < n; k++) {
            space.block_margin[b * space.stride + k] = b == moving ? margin[at + k] : 0.5;
            for (int e = 0; e < 2; e++) {
                YkTurn turn = yk_space_turn(&space, machine.mech->blocks[b].column[e].index);
                turn.c[k] = b == moving ? cos(angle[e][at + k]) : 1;
                turn.s[k] = b == moving ? sin(angle[e][at + k]) : 0;
            }
        }
}

// How many poses of the path are clear, in lanes of the given widths (the last for the rest).
static size_t watched(size_t first, size_t width)
{
    YkBranchWatch watch;
    moving = (first + width) % 2;
    assert_true(yk_watch_start(&watch, machine.mech));
    size_t at = 0;
    while (at < POSES) {
        size_t n = at == 0 ? first : width;
        if (n > POSES - at) n = POSES - at;
        fill(at, n);
        size_t clear = yk_watch_lanes(&watch, &space, n);
        assert_true(clear <= n);
        at += clear;
        if (clear < n) break;
    }
    yk_watch_end(&watch);
    return at;
}

static void stand_still(void)
{
    for (int k = 0; k < POSES; k++) margin[k] = 0.5, angle[0][k] = 1, angle[1][k] = -2;
}

// The first pose that is not clear is `doubt`; the start of its lanes where lanes begin between the three poses that
// show it, of which two are clear already.
static void check_clear(size_t doubt)
{
    for (size_t first = 1; first <= POSES; first++)
        for (size_t width = 1; width <= 9; width++) {
            size_t found = watched(first, width), begins = 0;
            for (size_t at = 0; at <= doubt + 1; at = at == 0 ? first : at + width) begins = at;
            size_t wanted = begins == doubt + 1 && doubt < POSES ? doubt + 1 : doubt;
            if (found != wanted) print_error("lanes %zu, %zu: %zu clear, not %zu\n", first, width, found, wanted);
            assert_int_equal(found, wanted);
        }
}

static void poses_well_away_from_a_limit_are_clear(void **unused)
{
    (void)unused;
    stand_still();
    check_clear(POSES);
    for (int k = 0; k < POSES; k++) margin[k] = 0.5 + 0.19 * (k % 2 ? 1 : -1), angle[0][k] = 0.14 * k;
    check_clear(POSES); // they differ by 0.38, and no body turns by 8.1 deg
}

// sin^2 of an angle that passes 0 between two poses, at any fraction of the step.
static void a_zero_between_two_poses_is_never_passed_over(void **unused)
{
    (void)unused;
    uint64_t seed = 41;
    stand_still();
    for (int k = 0; k < 300; k++) {
        double step = check_uniform(&seed, 0.01, 0.12), zero = check_uniform(&seed, 1, POSES - 3);
        for (int i = 0; i < POSES; i++) margin[i] = fmin(1, pow(sin(fmin(1.5, step * fabs(i - zero))), 2));
        for (size_t width = 1; width <= POSES; width += 3) // poses 0 ... floor(zero) lie before it
            assert_true((double)watched(width, width) <= zero + 1);
    }
}

static void the_first_two_poses_and_the_last_count(void **unused)
{
    (void)unused;
    for (size_t at = 2; at < POSES; at++) { // the third pose of a dip
        stand_still();
        margin[at] = 0;
        check_clear(at - 1);
        stand_still();
        margin[at] = 0.95; // too far from the two before it
        check_clear(at - 1);
    }
}

// Turns by more than 8.1 degrees, of either body; the first pose has none before it.
static void a_swing_is_told_at_its_pose(void **unused)
{
    (void)unused;
    for (int body = 0; body < 2; body++)
        for (size_t at = 0; at < POSES; at += 5) {
            stand_still();
            for (size_t k = at; k < POSES; k++) angle[body][k] += 0.142; // cos 0.142 = 0.9899
            for (size_t first = 1; first <= POSES; first += 3)
                for (size_t width = 1; width <= 9; width++)
                    assert_int_equal(watched(first, width), at == 0 ? POSES : at);
            for (size_t k = at; k < POSES; k++) angle[body][k] -= 0.002; // cos 0.14 = 0.9902
            assert_int_equal(watched(7, 5), POSES);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(poses_well_away_from_a_limit_are_clear),
        cmocka_unit_test(a_zero_between_two_poses_is_never_passed_over),
        cmocka_unit_test(the_first_two_poses_and_the_last_count),
        cmocka_unit_test(a_swing_is_told_at_its_pose),
    };
    return cmocka_run_group_tests(tests, start, end);
}
