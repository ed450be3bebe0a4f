// Limits of coordinates, at which a motion ends: exactly there, a rounding error before, and where the machine closes
// again on the other side of a narrow gap.
#include "../solve/machine.h"
#include <yoke/move.h>

// A four-bar; `ph` at the crank's pin turns from the crank to the coupler.
static Machine four_bar(const double *l, const char *start)
{
    char text[1200];
    snprintf(text, sizeof text,
             "bodies:\n"
             "  ground:  {points: {O: [0, 0], C: [%.17g, 0]}}\n"
             "  crank:   {points: {O: [0, 0], A: [%.17g, 0]}}\n"
             "  coupler: {points: {A: [0, 0], B: [%.17g, 0]}}\n"
             "  rocker:  {points: {C: [0, 0], B: [%.17g, 0]}}\n"
             "joints:\n"
             "  O: {pin: [ground, crank], angle: th}\n"
             "  A: {pin: [crank, coupler], angle: ph}\n"
             "  C: {pin: [ground, rocker], angle: ps}\n"
             "  B: {pin: [coupler, rocker]}\n"
             "start: {%s}\n",
             l[0], l[1], l[2], l[3], start);
    return machine_parse(text, false);
}

// Within 1e-12 rad of its limit the crank's angle is a double zero of the margin for all that samples tell: the rocker
// still stands on the side where it started, with the sign of its rate.
static void just_before_a_limit_the_branch_stays(void **unused)
{
    (void)unused;
    const double l[] = {6, 4, 2, 3}, limit = acos(27.0 / 48);
    for (int k = 8; k <= 15; k++) {
        Machine m = four_bar(l, "th: 0.5, ph: -1, ps: 1");
        assert_true(yk_state_assemble(m.state) >= 0);
        YkMotion goal = {limit - pow(10, -k), 1, 0};
        YkMove move = {0};
        assert_true(yk_state_move_to(m.state, &goal, NULL, &move) >= 0);
        assert_int_equal(move.pass_count, 0);
        // The rocker comes to the limit from below; at the limit itself, to rounding, its rate is not determined.
        if (yk_state_has_rates(m.state)) assert_true(machine_ask(&m, "ps.rate") > 0);
        machine_free(&m);
    }
}

// With ph at 180 deg crank and coupler reach C by less than coupler and rocker differ: ph stops 1.3 deg before, and
// goes on 1.3 deg behind, on another circuit. |A B| is then c - d or d - c.
static void a_gap_is_not_jumped_from_its_edge(void **unused)
{
    (void)unused;
    const double l[] = {0.268, 0.965, 0.958, 0.245};
    double reach = l[0] - l[3]; // from O to B
    double edge = acos((reach * reach - l[1] * l[1] - l[2] * l[2]) / (2 * l[1] * l[2]));
    Machine m = four_bar(l, "th: -1.089, ph: 3.118, ps: 3.126");
    yk_mechanism_free(m.mech);
    yk_state_free(m.state);
    machine_compile(&m, "ph");
    assert_true(yk_state_assemble(m.state) >= 0);
    for (int k = 0; k < 20; k++) { // to the edge as near as k allows, and across
        YkMotion goal = {edge - (k == 0 ? 0 : pow(10, -1 - k)), 0, 0};
        YkStatus status = yk_state_move_to(m.state, &goal, NULL, NULL);
        if (status < 0 && k > 0 && k < 12) print_error("k %d: %s\n", k, yk_state_report(m.state)->message);
        assert_true(status >= 0 || k == 0 || k >= 12);
        static const double beyond[] = {0.01, 0.047, 0.06, 0.1, 0.3, 0.5};
        for (size_t b = 0; b < sizeof beyond / sizeof *beyond; b++) {
            goal.position = edge + beyond[b];
            assert_int_equal(yk_state_move_to(m.state, &goal, NULL, NULL), YK_LIMIT);
            CHECK_NEAR(machine_ask(&m, "ph"), edge, 1e-9);
        }
    }
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(just_before_a_limit_the_branch_stays),
        cmocka_unit_test(a_gap_is_not_jumped_from_its_edge),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
