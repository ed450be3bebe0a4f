// Groups without closed form: their solutions close, are followed without a jump, stop at limits and return; and what
// dyads guarantee in the same machine holds there too.
#include "machine.h"

enum { SOLUTIONS_MAX = 64, COORDINATES_MAX = 16 };
typedef struct Solutions {
    double q[SOLUTIONS_MAX][COORDINATES_MAX];
    int sign[SOLUTIONS_MAX];
    size_t count;
} Solutions;

static bool gather(void *context, YkState *state)
{
    Solutions *s = context;
    YkResiduals r = yk_state_residuals(state);
    assert_true(s->count < SOLUTIONS_MAX);
    assert_true(r.position <= 1e-12 && r.velocity <= 1e-9 && r.acceleration <= 1e-7);
    for (size_t k = 0; k < yk_coordinate_count(yk_state_mechanism(state)); k++)
        s->q[s->count][k] = yk_state_coordinate(state, k).position;
    s->sign[s->count++] = yk_state_branch(state, 0);
    return true;
}

static double off_by(const Machine *m, const double *a, const double *b)
{
    double worst = 0;
    for (size_t k = 0; k < yk_coordinate_count(m->mech); k++) worst = fmax(worst, fabs(angle_between(a[k], b[k])));
    return worst;
}

static void read(const Machine *m, double *q)
{
    for (size_t k = 0; k < yk_coordinate_count(m->mech); k++) q[k] = yk_state_coordinate(m->state, k).position;
}

// Solutions of a polynomial system meet and part in pairs of opposite sign, so as many have one sign as the other.
static void test_solutions_of_a_triad_are_at_most_six_and_come_in_pairs(void **unused)
{
    (void)unused;
    Machine m = machine_load("stephenson-awkward");
    for (double theta = 0; theta < 6.3; theta += 0.37) {
        Solutions s = {.count = 0};
        bool complete = true;
        yk_state_set_input(m.state, 0, (YkMotion){theta, 1, 0});
        yk_state_each(m.state, gather, &s, &complete);
        assert_false(complete); // searched, not enumerated
        assert_true(s.count <= 6);
        int sum = 0;
        for (size_t k = 0; k < s.count; k++) {
            sum += s.sign[k];
            for (size_t j = 0; j < k; j++) assert_true(off_by(&m, s.q[j], s.q[k]) > 1e-6);
        }
        if (sum != 0) print_error("at %g: %zu solutions, signs sum up to %d\n", theta, s.count, sum);
        assert_int_equal(sum, 0);
    }
    machine_free(&m);
}

static void test_a_butterfly_has_at_most_eighteen_solutions(void **unused)
{
    (void)unused;
    Machine m = machine_load("double-butterfly");
    Solutions s = {.count = 0};
    yk_state_each(m.state, gather, &s, NULL);
    assert_true(s.count >= 2 && s.count <= 18);
    machine_free(&m);
}

// The same rows from coarse and fine steps, forward and back again.
static void check_steps(const char *file, double from, double to)
{
    static const size_t counts[] = {1, 3, 16, 200};
    double due[COORDINATES_MAX] = {0}, home[COORDINATES_MAX], q[COORDINATES_MAX];
    for (size_t k = 4; k-- > 0;) {
        Machine m = machine_load(file);
        assert_true(machine_solve(&m, from, 1, 0) >= 0);
        read(&m, home);
        for (size_t step = 1; step <= counts[k]; step++)
            assert_true(machine_solve(&m, from + (to - from) * (double)step / (double)counts[k], 1, 0) >= 0);
        read(&m, q);
        if (k == 3) memcpy(due, q, sizeof q);
        CHECK_NEAR(off_by(&m, q, due), 0, 1e-10);
        for (size_t c = 0; c < yk_coordinate_count(m.mech); c++) CHECK_NEAR(q[c], due[c], 1e-10); // the same turn
        assert_true(machine_solve(&m, from, 1, 0) >= 0);
        read(&m, q);
        for (size_t c = 0; c < yk_coordinate_count(m.mech); c++) CHECK_NEAR(q[c], home[c], 1e-10);
        machine_free(&m);
    }
}

static void test_coarse_steps_lead_where_fine_ones_do(void **unused)
{
    (void)unused;
    check_steps("stephenson-awkward", 2.0, 2.7);
    check_steps("stephenson-awkward", 2.6, 1.85);
    check_steps("double-butterfly", 0, 0.5);
    check_steps("double-butterfly", 0, -0.15);
}

// The awkward input is the other end of a machine of two dyads: driven from its crank, the same poses.
static void test_the_awkward_input_moves_as_the_easy_one(void **unused)
{
    (void)unused;
    Machine easy = machine_load("stephenson-six-bar"), awkward = machine_load("stephenson-awkward");
    static const char *const names[] = {"crank.angle", "coupler.angle", "rocker.angle", "link.angle"};
    double start = machine_ask(&awkward, "crank.angle");
    assert_true(machine_solve(&easy, start, 1, 0) >= 0);
    for (int b = 0; b < 4; b++) { // on its branch
        for (size_t k = 0; k < 2; k++) yk_state_set_branch(easy.state, k, (b >> k) & 1 ? 1 : -1);
        if (machine_solve(&easy, start, 1, 0) < 0) continue;
        if (fabs(angle_between(machine_ask(&easy, "output.angle"), machine_ask(&awkward, "theta6"))) < 1e-6 &&
            fabs(angle_between(machine_ask(&easy, "link.angle"), machine_ask(&awkward, "link.angle"))) < 1e-6)
            break;
    }
    for (int k = 0; k <= 100; k++) {
        double theta = start + 0.3 * k / 100;
        assert_int_equal(machine_solve(&easy, theta, 1.5, 0.5), YK_OK);
        double w6 = machine_ask(&easy, "output.rate"), a6 = machine_ask(&easy, "output.accel");
        double due = machine_ask(&awkward, "theta6") +
                     angle_between(machine_ask(&easy, "output.angle"), machine_ask(&awkward, "theta6"));
        if (fabs(w6) < 1e-2) break; // the awkward input's dead point
        assert_int_equal(machine_solve(&awkward, due, w6, a6), YK_OK);
        for (size_t n = 0; n < 4; n++) {
            char rate[64];
            CHECK_NEAR(angle_between(machine_ask(&awkward, names[n]), machine_ask(&easy, names[n])), 0, 1e-10);
            snprintf(rate, sizeof rate, "%s.rate", names[n]);
            CHECK_NEAR(machine_ask(&awkward, rate), machine_ask(&easy, rate), 1e-9);
            snprintf(rate, sizeof rate, "%s.accel", names[n]);
            CHECK_NEAR(machine_ask(&awkward, rate), machine_ask(&easy, rate), 1e-6);
        }
    }
    machine_free(&easy);
    machine_free(&awkward);
}

// At its limit the awkward input is where the easy machine's output turns round.
static void check_limit(const char *file, double way)
{
    Machine m = machine_load(file);
    const char *input = yk_coordinate_info(m.mech, yk_input_coordinate(m.mech, 0)).name;
    double start = yk_state_input(m.state, 0).position, home[COORDINATES_MAX], q[COORDINATES_MAX];
    read(&m, home);
    int sign = yk_state_branch(m.state, 0);
    YkSweep *sweep = machine_sweep(&m, input, start, start + 3 * way, 60, NULL, 0);
    assert_int_equal(yk_sweep_status(sweep), YK_LIMIT);
    assert_true(yk_sweep_row_count(sweep) > 1);
    assert_true(yk_state_residuals(m.state).position <= 1e-12); // stands at the limit
    YkEvent e = yk_sweep_event(sweep, yk_sweep_event_count(sweep) - 1);
    assert_int_equal(e.kind, YK_EVENT_LIMIT);
    CHECK_NEAR(yk_state_input(m.state, 0).position, e.at, 1e-12);
    assert_true(yk_state_transmission(m.state, 0) < 1e-4); // the determinant vanishes there
    // beyond: refused, and kept; back: the same solution
    assert_true(machine_solve(&m, e.at + way * 1e-6, 1, 0) < 0);
    const char *message = yk_state_report(m.state)->message;
    assert_non_null(strstr(message, yk_block_info(m.mech, 0).label));
    assert_null(strstr(message, "misses by")); // there is no telling by how much
    assert_true(machine_solve(&m, start, 1, 0) >= 0);
    read(&m, q);
    CHECK_NEAR(off_by(&m, q, home), 0, 1e-9);
    assert_int_equal(yk_state_branch(m.state, 0), sign);
    yk_sweep_free(sweep);
    machine_free(&m);
}

static void test_a_group_stops_at_its_limit_and_comes_back(void **unused)
{
    (void)unused;
    check_limit("stephenson-awkward", 1);
    check_limit("stephenson-awkward", -1);
    check_limit("double-butterfly", 1);
    check_limit("double-butterfly", -1);
}

static void test_the_awkward_limit_is_the_easy_outputs_extreme(void **unused)
{
    (void)unused;
    Machine easy = machine_load("stephenson-six-bar"), awkward = machine_load("stephenson-awkward");
    static const char *const of[] = {"output.angle"};
    double start = machine_ask(&awkward, "theta6"), crank = machine_ask(&awkward, "crank.angle");
    double link = machine_ask(&awkward, "link.angle");
    YkSweep *limit = machine_sweep(&awkward, "theta6", start, start + 3, 60, NULL, 0);
    double at = yk_sweep_event(limit, yk_sweep_event_count(limit) - 1).at;
    bool met = false;
    for (int b = 0; b < 4; b++) {
        for (size_t k = 0; k < 2; k++) yk_state_set_branch(easy.state, k, (b >> k) & 1 ? 1 : -1);
        if (machine_solve(&easy, crank, 1, 0) < 0 || fabs(angle_between(machine_ask(&easy, "link.angle"), link)) > 1e-6)
            continue;
        YkSweep *turn = machine_sweep(&easy, "theta2", crank, crank + 2 * YK_PI, 100, of, 1);
        for (size_t k = 0; k < yk_sweep_event_count(turn); k++) {
            YkEvent e = yk_sweep_event(turn, k);
            met |= e.kind == YK_EVENT_EXTREME && fabs(angle_between(e.value, at)) <= 1e-8;
        }
        yk_sweep_free(turn);
        break;
    }
    assert_true(met);
    yk_sweep_free(limit);
    machine_free(&easy);
    machine_free(&awkward);
}

// --- dyads beside a group
// -------------------------------------------------------------------------------------------------------

// The awkward machine with a four-bar on its output: crank 1, coupler b, rocker c on a frame of 3, in line at 2.25 rad.
static const char with_four_bar[] =
    "parameters: {b: 3, c: 1, line: 2.25}\n"
    "bodies:\n"
    "  ground:  {points: {O2: [0, 0], O4: [4, 0], O6: [6, 2.5], F: [9, 2.5]}}\n"
    "  crank:   {points: {O2: [0, 0], A: [1, 0]}}\n"
    "  coupler: {points: {A: [0, 0], B: [3.5, 0], C: [2, 1.5]}}\n"
    "  rocker:  {points: {O4: [0, 0], B: [3, 0]}}\n"
    "  link:    {points: {C: [0, 0], D: [4.5, 0]}}\n"
    "  output:  {points: {O6: [0, 0], D: [2.5, 0], E: [1 m * cos(line), -1 m * sin(line)]}}\n"
    "  bar:     {points: {E: [0, 0], G: [b, 0]}}\n"
    "  side:    {points: {F: [0, 0], G: [c, 0]}}\n"
    "joints:\n"
    "  O6: {pin: [ground, output], angle: theta6}\n"
    "  D:  {pin: [output, link], angle: theta5}\n"
    "  O2: {pin: [ground, crank], angle: theta2}\n"
    "  A:  {pin: [crank, coupler], angle: theta3}\n"
    "  O4: {pin: [ground, rocker], angle: theta4}\n"
    "  E:  {pin: [output, bar], angle: epsilon}\n"
    "  F:  {pin: [ground, side], angle: phi}\n"
    "  B:  {pin: [coupler, rocker]}\n"
    "  C:  {pin: [coupler, link]}\n"
    "  G:  {pin: [bar, side]}\n"
    "drives: {theta6: 120 deg}\n"
    "start: {theta2: 120 deg, theta3: -90 deg, theta4: 119 deg, theta5: -101 deg, epsilon: -2.094, phi: -0.155}\n";

static void test_a_parallelogram_beside_a_group_stays_parallel(void **unused)
{
    (void)unused;
    static const char *const of[] = {"bar.angle", "phi"};
    for (size_t steps = 1; steps < 200; steps = 3 * steps + 1) {
        Machine m = machine_parse(with_four_bar, true);
        double start = yk_state_input(m.state, 0).position;
        CHECK_NEAR(machine_ask(&m, "bar.angle"), 0, 1e-12);
        YkSweep *sweep = machine_sweep(&m, "theta6", start, 2.6, steps, of, 2);
        assert_true(yk_sweep_status(sweep) >= 0);
        for (size_t row = 0; row <= steps; row++) {
            CHECK_NEAR(yk_sweep_value(sweep, row, 0), 0, 1e-7);
            CHECK_NEAR(yk_sweep_value(sweep, row, 1), yk_sweep_at(sweep, row) - 2.25, 1e-7);
        }
        assert_int_equal(count_events(sweep, YK_EVENT_CHANGE_POINT), 1);
        yk_sweep_free(sweep);
        machine_free(&m);
    }
}

static void test_a_narrow_gap_beside_a_group_is_not_jumped(void **unused)
{
    (void)unused;
    for (double gap = 1e-2; gap > 1e-7; gap *= 0.1) { // b - c > 2 by the gap: does not close about the line
        char b[40];
        snprintf(b, sizeof b, "%.17g", 3 + gap);
        YkOverride change = {"b", b};
        Machine m = machine_parse_with(with_four_bar, &change, 1);
        assert_true(yk_state_assemble(m.state) >= 0);
        double start = yk_state_input(m.state, 0).position;
        double limit = 2.25 - acos((1 + 9 - (2 + gap) * (2 + gap)) / 6);
        if (limit < start) {
            machine_free(&m);
            continue;
        }
        YkSweep *sweep = machine_sweep(&m, "theta6", start, 2.6, 3, NULL, 0);
        assert_int_equal(yk_sweep_status(sweep), YK_LIMIT);
        CHECK_NEAR(yk_sweep_event(sweep, yk_sweep_event_count(sweep) - 1).at, limit, 1e-8);
        yk_sweep_free(sweep);
        machine_free(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_solutions_of_a_triad_are_at_most_six_and_come_in_pairs),
        cmocka_unit_test(test_a_butterfly_has_at_most_eighteen_solutions),
        cmocka_unit_test(test_coarse_steps_lead_where_fine_ones_do),
        cmocka_unit_test(test_the_awkward_input_moves_as_the_easy_one),
        cmocka_unit_test(test_a_group_stops_at_its_limit_and_comes_back),
        cmocka_unit_test(test_the_awkward_limit_is_the_easy_outputs_extreme),
        cmocka_unit_test(test_a_parallelogram_beside_a_group_stays_parallel),
        cmocka_unit_test(test_a_narrow_gap_beside_a_group_is_not_jumped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
