// No answer is NaN or infinite without a status that says so: random machines of every dyad, of every size, often
// degenerate: 2,000 of them, 6,000 with YOKE_FULL=1, as many as YOKE_TEST_RANDOM=1000000 says.
#include "machine.h"

static uint64_t machines(void)
{
    return getenv("YOKE_FULL") ? 6000 : check_cases(2000);
}

// Lengths from a few values, so that links are often equal, in line or of no length; or over six decades.
static double draw_length(uint64_t *seed)
{
    static const double few[] = {1, 1, 2, 0.5, 1 + 1e-9, 1 - 1e-13, 1e-9, 3};
    if (check_random(seed) % 2) return few[check_random(seed) % 8];
    return pow(10, check_uniform(seed, -3, 3));
}

static double draw_angle(uint64_t *seed)
{
    static const double few[] = {0, YK_PI, YK_PI / 2, -YK_PI / 2, 2 * YK_PI, YK_PI / 3, 1e-9, 1e5};
    return check_random(seed) % 2 ? few[check_random(seed) % 8] : check_uniform(seed, -10, 10);
}

static const char *const bodies[] = {
    // RRR
    "bodies: {ground: {points: {O: [0, 0], Q: [d, 0]}}, crank: {points: {O: [0, 0], A: [a, 0]}}, coupler: {points: {A: "
    "[0, 0], "
    "B: [b, 0], P: [e, b]}}, rocker: {points: {Q: [0, 0], B: [c, 0]}}}\n"
    "joints: {O: {pin: [ground, crank], angle: theta}, A: {pin: [crank, coupler], angle: u}, Q: {pin: [ground, "
    "rocker], angle: v}, "
    "B: {pin: [coupler, rocker]}}\n",
    // RRP
    "bodies: {ground: {points: {O: [0, 0], G: [0, e]}}, crank: {points: {O: [0, 0], A: [a, 0]}}, rod: {points: {A: [0, "
    "0], B: [b, 0], "
    "P: [c, d]}}, piston: {points: {B: [0, 0]}}}\n"
    "joints: {O: {pin: [ground, crank], angle: theta}, A: {pin: [crank, rod], angle: u}, B: {pin: [rod, piston]}, "
    "R: {slide: [ground, piston], along: 0.3, from: G, distance: v}}\n",
    // RPR
    "bodies: {ground: {points: {O: [0, 0], Q: [d, 0]}}, crank: {points: {O: [0, 0], A: [a, 0]}}, lever: {points: {Q: "
    "[0, 0], P: [b, c]}}, "
    "block: {points: {A: [0, 0]}}}\n"
    "joints: {O: {pin: [ground, crank], angle: theta}, Q: {pin: [ground, lever], angle: u}, S: {slide: [lever, block], "
    "along: x, distance: v}, "
    "A: {pin: [crank, block]}}\n",
    // PP, two slots that may be parallel
    "bodies: {ground: {points: {O: [0, 0]}}, crank: {points: {O: [0, 0], A: [a, 0], P: [b, c]}}, cross: {points: {A: "
    "[0, 0]}}, "
    "table: {points: {T: [0, 0]}}}\n"
    "joints: {O: {pin: [ground, crank], angle: theta}, R: {slide: [ground, table], along: x, distance: u}, V: {slide: "
    "[table, cross], "
    "along: e / (1 m), distance: v}, A: {pin: [crank, cross]}}\n"};
enum { KINDS = sizeof bodies / sizeof bodies[0] };

// The largest distance over the machine's size, at least 1: guides that are all but parallel meet far away.
static double reach_of(const Machine *m)
{
    double reach = 1;
    for (size_t k = 0; k < yk_coordinate_count(m->mech); k++)
        if (yk_coordinate_info(m->mech, k).is_distance)
            reach = fmax(reach, fabs(yk_state_coordinate(m->state, k).position) / yk_mechanism_size(m->mech));
    return reach;
}

static void check_finite(const Machine *m)
{
    for (size_t k = 0; k < yk_coordinate_count(m->mech); k++) {
        YkMotion q = yk_state_coordinate(m->state, k);
        assert_true(isfinite(q.position) && isfinite(q.velocity) && isfinite(q.acceleration));
    }
    for (size_t k = 0; k < yk_model_body_count(m->model); k++) {
        YkMotion q = yk_state_body(m->state, k);
        assert_true(isfinite(q.position) && isfinite(q.velocity) && isfinite(q.acceleration));
    }
    for (size_t k = 0; k < yk_model_point_count(m->model); k++) {
        YkPointMotion p = yk_state_point(m->state, k);
        for (int axis = 0; axis < 2; axis++)
            assert_true(isfinite(p.position[axis]) && isfinite(p.velocity[axis]) && isfinite(p.acceleration[axis]));
    }
    YkResiduals r = yk_state_residuals(m->state);
    assert_true(isfinite(r.velocity) && isfinite(r.acceleration));
    CHECK_NEAR(r.position, 0, 1e-12 * reach_of(m));
    for (size_t b = 0; b < yk_block_count(m->mech); b++) assert_true(isfinite(yk_state_transmission(m->state, b)));
}

static void check_report(const Machine *m, YkStatus status)
{
    const YkReport *r = yk_state_report(m->state);
    assert_int_equal(r->status, status);
    assert_true(isfinite(r->gap) && isfinite(r->determinant) && r->gap >= 0);
    assert_true((status == YK_OK || status == YK_REDUNDANT) == (r->message[0] == 0));
}

static void check_one(uint64_t seed)
{
    char text[2048];
    double l[5];
    for (int k = 0; k < 5; k++) l[k] = draw_length(&seed);
    double v = draw_angle(&seed), u = draw_angle(&seed), theta = draw_angle(&seed);
    snprintf(
        text, sizeof text,
        "parameters: {a: %.17g, b: %.17g, c: %.17g, d: %.17g, e: %.17g}\n%sstart: {theta: %.17g, u: %.17g, v: %.17g}\n",
        l[0], l[1], l[2], l[3], l[4], bodies[check_random(&seed) % KINDS], theta, u, v);
    Machine m = machine_parse(text, false);
    YkStatus status = yk_state_assemble(m.state);
    check_report(&m, status);
    if (status >= 0) check_finite(&m);
    for (int k = 0; status >= 0 && k < 6; k++) {
        YkMotion in = {draw_angle(&seed), check_uniform(&seed, -2, 2), check_uniform(&seed, -2, 2)};
        yk_state_set_input(m.state, 0, in);
        check_report(&m, yk_state_solve(m.state));
        check_finite(&m); // the last pose that closed stays
    }
    machine_free(&m);
}

static void test_random_machines_answer_with_numbers_or_a_status(void **unused)
{
    (void)unused;
    const char *wish = getenv("YOKE_TEST_RANDOM");
    long count = wish ? atol(wish) : (long)machines();
    for (long k = 0; k < count; k++) {
        uint64_t seed = 7919u * (uint64_t)k + 3;
        check_one(seed);
    }
}

// Sweeps of the same machines end with a status, and their rows hold numbers.
static void test_random_sweeps_hold_numbers(void **unused)
{
    (void)unused;
    for (uint64_t k = 0; k < machines() / 6; k++) {
        uint64_t seed = 104729u * k + 11;
        char text[2048];
        double l[5];
        for (int i = 0; i < 5; i++) l[i] = draw_length(&seed);
        snprintf(text, sizeof text,
                 "parameters: {a: %.17g, b: %.17g, c: %.17g, d: %.17g, e: %.17g}\n%sstart: {theta: 1}\n", l[0], l[1],
                 l[2], l[3], l[4], bodies[check_random(&seed) % KINDS]);
        Machine m = machine_parse(text, false);
        static const char *const of[] = {"theta", "u", "v", "u.rate", "v.accel"};
        if (yk_state_assemble(m.state) >= 0) {
            YkSweep *sweep = machine_sweep(&m, "theta", 0, 2 * YK_PI, 12, of, 5);
            YkStatus status = yk_sweep_status(sweep);
            size_t rows = yk_sweep_row_count(sweep);
            assert_true(status >= 0 ? rows == 13 : status == YK_LIMIT && rows <= 13);
            double reach = 1;
            for (size_t row = 0; row < rows; row++) {
                for (size_t c = 0; c < 5; c++) assert_true(isfinite(yk_sweep_value(sweep, row, c)));
                reach = fmax(reach, fabs(yk_sweep_value(sweep, row, 2)) / yk_mechanism_size(m.mech));
            }
            for (size_t e = 0; e < yk_sweep_event_count(sweep); e++) {
                YkEvent event = yk_sweep_event(sweep, e);
                assert_true(isfinite(event.at) && isfinite(event.value));
            }
            assert_true(yk_sweep_worst_residual(sweep) <= 1e-12 * reach);
            check_finite(&m);
            yk_sweep_free(sweep);
        }
        machine_free(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_machines_answer_with_numbers_or_a_status),
        cmocka_unit_test(test_random_sweeps_hold_numbers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
