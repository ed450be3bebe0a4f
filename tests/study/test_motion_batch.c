// Forward dynamics in batches: the double pendulum's textbook equations with its own parameters in every state; trees
// and loops against the file with these values; the same bits on any threads; a status where there is no answer.
#include "study_check.h"

enum { STATES = 3000, ROWS = 8 };
static double value[ROWS][STATES], q[3][STATES], v[3][STATES], a[3][STATES], again[3][STATES];
static signed char status[STATES];
static double *const out[] = {a[0], a[1], a[2]};
static const double *const positions[] = {q[0], q[1], q[2]}, *const rates[] = {v[0], v[1], v[2]};

static void draw(const Machine *m, const char *const *names, size_t count, double spread, uint64_t seed)
{
    for (size_t k = 0; k < STATES; k++) {
        for (size_t p = 0; p < count; p++)
            value[p][k] = yk_model_parameter(m->model, names[p]) * (1 + check_uniform(&seed, -spread, spread));
        for (int i = 0; i < 3; i++) q[i][k] = check_uniform(&seed, -20, 20), v[i][k] = check_uniform(&seed, -3, 3);
    }
}

static YkMotionCase ask(const double *const *values)
{
    return (YkMotionCase){values, positions, rates, NULL, STATES};
}

static const char *const PENDULUM[] = {"l1", "lc1", "lc2", "m1", "m2", "I1", "I2", "tau1"};
static const double *const VALUES[] = {value[0], value[1], value[2], value[3], value[4], value[5], value[6], value[7]};

static void test_the_double_pendulum_is_its_textbook_equation(void **unused)
{
    (void)unused;
    Machine m = machine_load("double-pendulum");
    YkMotionBatch *batch = yk_motion_batch_new(m.state, PENDULUM, 8, 2, m.problems);
    assert_non_null(batch);
    draw(&m, PENDULUM, 8, 0.4, 1);
    for (size_t k = 7; k < STATES; k += 500) q[0][k] += 3e6; // beyond the quick reduction of angles
    YkMotionCase asked = ask(VALUES);
    assert_int_equal(yk_motion_batch_run(batch, &asked, out, status), YK_OK);
    for (size_t k = 0; k < STATES; k++) {
        double l1 = value[0][k], c1 = value[1][k], c2 = value[2][k], m1 = value[3][k], m2 = value[4][k], g = 9.81;
        double I1 = value[5][k], I2 = value[6][k], w1 = v[0][k], w2 = v[1][k], t1 = q[0][k], t2 = q[1][k];
        double A = I1 + I2 + m1 * c1 * c1 + m2 * (l1 * l1 + c2 * c2), B = m2 * l1 * c2, D = I2 + m2 * c2 * c2;
        double s12 = sin(t1) * cos(t2) + cos(t1) * sin(t2); // the sum of the angles has lost digits where one is large
        double m11 = A + 2 * B * cos(t2), m12 = D + B * cos(t2), h = B * sin(t2);
        double r1 = value[7][k] + h * w2 * (2 * w1 + w2) - g * (m1 * c1 + m2 * l1) * sin(t1) - g * m2 * c2 * s12;
        double r2 = -0.2 - h * w1 * w1 - g * m2 * c2 * s12, over = 1 / (m11 * D - m12 * m12);
        double scale = 1e-12 * (1 + fabs(a[0][k]) + fabs(a[1][k]));
        CHECK_NEAR(a[0][k], (D * r1 - m12 * r2) * over, scale);
        CHECK_NEAR(a[1][k], (m11 * r2 - m12 * r1) * over, scale);
        assert_int_equal(status[k], YK_OK);
    }
    yk_motion_batch_free(batch);
    machine_free(&m);
}

// The file itself with the values of state k.
static void check_state(const char *text, const char *const *names, size_t count, size_t k)
{
    char word[ROWS][40];
    YkOverride overrides[ROWS];
    double fresh[3];
    for (size_t p = 0; p < count; p++) {
        snprintf(word[p], sizeof word[p], "%.17g", value[p][k]);
        overrides[p] = (YkOverride){names[p], word[p]};
    }
    Machine m = machine_parse_with(text, overrides, count);
    assert_true(yk_state_assemble(m.state) >= 0);
    size_t inputs = yk_input_count(m.mech);
    for (size_t i = 0; i < inputs; i++) yk_state_set_input(m.state, i, (YkMotion){q[i][k], v[i][k], 0});
    YkDynamics *d = yk_dynamics_new(m.mech, m.problems);
    YkStatus alone = yk_dynamics_accelerate(d, m.state, fresh);
    assert_int_equal(status[k], alone == YK_REDUNDANT ? YK_OK : alone);
    double scale = 1;
    for (size_t i = 0; i < inputs && alone >= 0; i++) scale = fmax(scale, fabs(fresh[i]));
    for (size_t i = 0; i < inputs && alone >= 0; i++) CHECK_NEAR(a[i][k], fresh[i], 1e-11 * scale);
    yk_dynamics_free(d);
    machine_free(&m);
}

static void check_text(const char *text, const char *const *names, size_t count, double reach)
{
    Machine m = machine_parse(text, true);
    draw(&m, names, count, 0.1, 2);
    for (size_t k = 0; k < STATES; k++)
        for (int i = 0; i < 3; i++) q[i][k] *= reach;
    for (size_t threads = 1; threads <= 3; threads++) {
        YkMotionBatch *batch = yk_motion_batch_new(m.state, names, count, threads, m.problems);
        if (!batch) print_error("%s", yk_problems_text(m.problems, 0));
        assert_non_null(batch);
        YkMotionCase asked = ask(VALUES);
        yk_motion_batch_run(batch, &asked, out, status);
        if (threads == 1) memcpy(again, a, sizeof a);
        for (size_t i = 0; i < yk_input_count(m.mech); i++) assert_memory_equal(a[i], again[i], sizeof a[i]);
        yk_motion_batch_free(batch);
    }
    machine_free(&m);
    for (size_t k = 0; k < STATES; k += 97) check_state(text, names, count, k);
}

// A fork with a rod, a reversed pin, points that are no body's origin, a body without mass.
static const char *const FORK =
    "parameters: {l: 1, m: 2, c: 0.3, e: 0.1, g: 9.81}\n"
    "gravity: [1, -g]\n"
    "bodies:\n"
    "  ground: {points: {O: [e, 0.2]}}\n"
    "  trunk: {points: {O: [c, e], A: [l, 0], B: [l - e, c]}, mass: m, center: [l/2, e], inertia: 0.1}\n"
    "  left: {points: {A: [0.1, 0], P: [l, c]}, mass: m/2, rod: [A, P]}\n"
    "  right: {points: {B: [e, 0], T: [0.2, 0.3]}, mass: 3, center: [c, -l], inertia: 0.5}\n"
    "joints:\n"
    "  O: {pin: [ground, trunk], angle: q1}\n"
    "  A: {pin: [left, trunk], angle: q2}\n"
    "  B: {pin: [trunk, right], angle: q3}\n"
    "efforts: {q2: 0.3 N*m}\n";

// Short chains: straight ones along each axis, one with a rod, a reversed pin and vectors of any direction.
static const char *const ALONG_X =
    "parameters: {l: 0.4, m: 2, c: 0.3, e: 0.1, g: 9.81}\n"
    "gravity: [1, -g]\n"
    "bodies:\n"
    "  ground: {points: {O: [e, 0.2]}}\n"
    "  upper: {points: {O: [-c, 0], A: [l, 0]}, mass: m, center: [l/2, 0], inertia: 0.05}\n"
    "  lower: {points: {A: [0, 0], P: [l + e, 0]}, mass: m/2, rod: [A, P]}\n"
    "joints:\n"
    "  O: {pin: [ground, upper], angle: q1}\n"
    "  A: {pin: [lower, upper], angle: q2}\n"
    "efforts: {q2: 0.3 N*m}\n";

// All vectors are positive multiples of parameters, and gravity is along y: what is left out then.
static const char *const PLAIN = "parameters: {l: 0.4, m: 2, c: 0.3, e: 0.1, g: 9.81}\n"
                                 "gravity: [0, -g]\n"
                                 "bodies:\n"
                                 "  ground: {points: {O: [e, 0.2]}}\n"
                                 "  upper: {points: {O: [0, 0], A: [l, 0]}, mass: m, center: [c, 0], inertia: 0.05}\n"
                                 "  lower: {points: {A: [0, 0]}, mass: m/2, center: [e, 0], inertia: 0.01}\n"
                                 "joints:\n"
                                 "  O: {pin: [ground, upper], angle: q1}\n"
                                 "  A: {pin: [upper, lower], angle: q2}\n"
                                 "efforts: {q2: 0.3 N*m}\n";

static const char *const SKEW = "parameters: {l: 0.4, m: 2, c: 0.3, e: 0.1, g: 9.81}\n"
                                "gravity: [1, -g]\n"
                                "bodies:\n"
                                "  ground: {points: {O: [e, 0.2]}}\n"
                                "  first: {points: {O: [c, e], A: [l, c]}, mass: m, center: [l/2, e], inertia: 0.1}\n"
                                "  second: {points: {A: [0.1, -c], B: [e, l]}, mass: m/2, rod: [A, B]}\n"
                                "  third: {points: {B: [e, 0]}, mass: 3, center: [c, -l], inertia: 0.5}\n"
                                "joints:\n"
                                "  O: {pin: [ground, first], angle: q1}\n"
                                "  A: {pin: [second, first], angle: q2}\n"
                                "  B: {pin: [second, third], angle: q3}\n"
                                "efforts: {q2: 0.3 N*m}\n";

static const char *const SINGLE = "parameters: {l: 0.4, m: 2, c: 0.3, e: 0.1, g: 9.81}\n"
                                  "gravity: [1, -g]\n"
                                  "bodies:\n"
                                  "  ground: {points: {O: [e, 0.2]}}\n"
                                  "  only: {points: {O: [c, e]}, mass: m, center: [l/2, e], inertia: 0.1}\n"
                                  "joints:\n"
                                  "  O: {pin: [only, ground], angle: q1}\n"
                                  "efforts: {q1: 0.3 N*m}\n";

static const char *const FOUR_BAR = "parameters: {r: 0.2, l: 0.6, m: 2, k: 5 N*m}\n"
                                    "gravity: [0, -9.81]\n"
                                    "bodies:\n"
                                    "  ground: {points: {O: [0, 0], C: [0.7, 0]}}\n"
                                    "  crank: {points: {O: [0, 0], A: [r, 0]}, mass: 1, rod: [O, A]}\n"
                                    "  coupler: {points: {A: [0, 0], B: [l, 0]}, mass: m, rod: [A, B]}\n"
                                    "  rocker: {points: {C: [0, 0], B: [0.5, 0]}, mass: 2, rod: [C, B]}\n"
                                    "joints:\n"
                                    "  O: {pin: [ground, crank], angle: theta}\n"
                                    "  A: {pin: [crank, coupler], angle: phi}\n"
                                    "  C: {pin: [ground, rocker], angle: psi}\n"
                                    "  B: {pin: [coupler, rocker]}\n"
                                    "efforts: {theta: k}\n"
                                    "start: {theta: 60 deg, phi: -20 deg, psi: 100 deg}\n";

static void test_trees_and_loops_are_the_file_with_these_values(void **unused)
{
    (void)unused;
    const char *const fork[] = {"l", "m", "c", "e", "g"}, *const bar[] = {"r", "l", "m", "k"};
    check_text(FORK, fork, 5, 1);
    check_text(FOUR_BAR, bar, 4, 0.1);
}

static void test_short_chains_are_the_file_with_these_values(void **unused)
{
    (void)unused;
    const char *const names[] = {"l", "m", "c", "e", "g"};
    check_text(SINGLE, names, 5, 1);
    check_text(ALONG_X, names, 5, 1);
    check_text(PLAIN, names, 5, 1);
    check_text(SKEW, names, 5, 1);
}

// A parallel drive of two freedoms, with a driven slide, a spring and a damper.
static const char *const FIVE_BAR =
    "parameters: {r: 0.3, m: 0.7}\n"
    "gravity: [0.2, -9.81]\n"
    "bodies:\n"
    "  ground: {points: {O: [0, 0], P: [0.6, 0.1]}}\n"
    "  a: {points: {O: [0, 0], A: [r, 0]}, mass: m, rod: [O, A]}\n"
    "  b: {points: {A: [0, 0], C: [0.6, 0]}, mass: 1.3, center: [0.2, 0.1], inertia: 0.05}\n"
    "  c: {points: {P: [0, 0], B: [0.3, 0]}, mass: 0.4, rod: [P, B]}\n"
    "  d: {points: {B: [0, 0], C: [0.7, 0]}, mass: 0.9, rod: [B, C]}\n"
    "  e: {points: {A: [0, 0]}, mass: 0.3, inertia: 0.01}\n"
    "joints:\n"
    "  O: {pin: [ground, a], angle: p}\n"
    "  P: {pin: [ground, c], angle: q}\n"
    "  A: {pin: [a, b], angle: u}\n"
    "  B: {pin: [c, d], angle: w}\n"
    "  C: {pin: [b, d]}\n"
    "  E: {slide: [a, e], along: 0.3 rad, distance: x}\n"
    "drives: {x: 0.1 m + 0.2 m/s * t + 3 m/s^2 * t^2}\n"
    "springs: {s: {between: [ground.O, b.C], stiffness: 300 N/m, length: 0.3, damping: 4 N*s/m}}\n"
    "efforts: {p: 2 N*m, q: -1 N*m}\n"
    "start: {p: 100 deg, q: 80 deg, u: -60 deg, w: 50 deg}\n";

static void test_loops_alone_are_solved_in_lanes(void **unused)
{
    (void)unused;
    check_text(FOUR_BAR, NULL, 0, 0.1);
}

// One state, all of them, and odd numbers of them have the same bits; poses beyond reach have a status and zeros.
static void test_lanes_do_not_depend_on_their_number(void **unused)
{
    (void)unused;
    Machine m = machine_parse(FIVE_BAR, true);
    draw(&m, NULL, 0, 0, 5);
    size_t n = yk_input_count(m.mech), at[3], beyond = 0;
    assert_int_equal(n, 3);
    for (size_t i = 0; i < n; i++)
        at[i] = (size_t)yk_coordinate_info(m.mech, yk_input_coordinate(m.mech, i)).is_distance;
    for (size_t k = 0; k < STATES; k++)
        for (size_t i = 0; i < n; i++) q[i][k] = at[i] ? 0.1 + 0.01 * q[i][k] : 1.5 + q[i][k] / 8;
    YkMotionBatch *batch = yk_motion_batch_new(m.state, NULL, 0, 1, m.problems);
    YkMotionCase asked = ask(NULL);
    yk_motion_batch_run(batch, &asked, out, status);
    YkDynamics *d = yk_dynamics_new(m.mech, m.problems);
    for (size_t k = 0; k < STATES; k += k < 300 ? 1 : 61) {
        const double *one_q[3], *one_v[3];
        double one[3], alone[3], scale = 1;
        signed char own;
        for (size_t i = 0; i < n; i++) one_q[i] = &q[i][k], one_v[i] = &v[i][k];
        YkMotionCase single = {NULL, one_q, one_v, NULL, 1};
        yk_motion_batch_run(batch, &single, (double *const[]){&one[0], &one[1], &one[2]}, &own);
        assert_int_equal(own, status[k]);
        for (size_t i = 0; i < n; i++) assert_true(one[i] == a[i][k]);
        beyond += own != YK_OK;
        if (own != YK_OK) {
            for (size_t i = 0; i < n; i++) assert_true(one[i] == 0);
            continue;
        }
        YkMotion x = yk_state_input(m.state, at[0] ? 0 : at[1] ? 1 : 2);
        for (size_t i = 0; i < n; i++)
            yk_state_set_input(m.state, i, (YkMotion){q[i][k], v[i][k], at[i] ? x.acceleration : 0});
        assert_int_equal(yk_dynamics_accelerate(d, m.state, alone), YK_OK);
        for (size_t i = 0; i < n; i++) scale = fmax(scale, fabs(alone[i]));
        for (size_t i = 0; i < n; i++) CHECK_NEAR(one[i], alone[i], 1e-10 * scale);
    }
    assert_true(beyond > 5 && beyond < 200);
    yk_dynamics_free(d);
    yk_motion_batch_free(batch);
    machine_free(&m);
}

static void test_what_has_no_answer_has_a_status_and_zeros(void **unused)
{
    (void)unused;
    Machine m = machine_load("double-pendulum");
    YkMotionBatch *batch = yk_motion_batch_new(m.state, PENDULUM, 7, 1, m.problems);
    draw(&m, PENDULUM, 7, 0.1, 3);
    value[3][5] = -1, value[5][6] = -0.1, value[0][7] = NAN, q[0][8] = INFINITY;
    value[6][9] = value[2][9] = 0; // a point mass at its pin: nothing resists theta2
    YkMotionCase asked = ask(VALUES);
    assert_int_equal(yk_motion_batch_run(batch, &asked, out, status), YK_BAD_MODEL);
    for (size_t k = 0; k < STATES; k++) {
        bool bad = k >= 5 && k <= 9;
        assert_int_equal(status[k] == YK_OK, !bad);
        assert_true(isfinite(a[0][k]) && isfinite(a[1][k]));
        if (bad) assert_true(a[0][k] == 0 && a[1][k] == 0);
    }
    assert_int_equal(status[5], YK_BAD_MODEL);
    assert_int_equal(status[6], YK_BAD_MODEL);
    assert_int_equal(status[7], YK_BAD_MODEL);
    assert_int_equal(status[9], YK_SINGULAR);
    yk_motion_batch_free(batch);
    machine_free(&m);
}

// Some pendulums are so light, or so heavy and long, that the product of their inertias underflows or overflows. They
// stand beside ordinary ones.
static void test_pendulums_of_any_size_fall_the_same(void **unused)
{
    (void)unused;
    const int mass[] = {0, -500, -520, -600, 300, 0, -600}, length[] = {0, 0, 0, 0, 200, -300, 0};
    const double none[STATES] = {0}, *const still[] = {none, none};
    Machine m = machine_load("double-pendulum");
    YkMotionBatch *batch = yk_motion_batch_new(m.state, PENDULUM, 7, 1, m.problems);
    for (size_t k = 0; k < 7; k++) {
        for (int p = 0; p < 3; p++) value[p][k] = ldexp(0.5 - 0.1 * p, length[k]);
        value[3][k] = ldexp(0.5, mass[k]), value[4][k] = ldexp(0.4, mass[k]), value[5][k] = value[6][k] = 0;
        q[0][k] = 1, q[1][k] = 0.5;
    }
    q[0][6] += 2e6 * YK_PI; // beyond the quick reduction of angles, too, with an angle of 16 digits
    YkMotionCase asked = {VALUES, positions, still, still, 7};
    assert_int_equal(yk_motion_batch_run(batch, &asked, out, status), YK_OK);
    for (size_t k = 0; k < 7; k++)
        for (int i = 0; i < 2; i++)
            CHECK_NEAR(ldexp(a[i][k], length[k]), a[i][0], (k < 6 ? 1e-13 : 1e-7) * fabs(a[i][0]));
    yk_motion_batch_free(batch);
    machine_free(&m);
}

// A point mass on three links of which two weigh nothing can be moved in two ways: however the links stand, the third
// meets no inertia, and what is left of it is rounding that grew where two links nearly lie in line.
static void test_two_weightless_links_are_singular(void **unused)
{
    (void)unused;
    Machine m = machine_parse("parameters: {l: 1}\n"
                              "bodies:\n"
                              "  ground: {points: {O: [0, 0]}}\n"
                              "  first: {points: {O: [0, 0], A: [l, 0]}}\n"
                              "  second: {points: {A: [0, 0], B: [0.7, 0.3]}}\n"
                              "  third: {points: {B: [0, 0]}, mass: 3, center: [0.3, 0.2], inertia: 0}\n"
                              "joints:\n"
                              "  O: {pin: [ground, first], angle: q1}\n"
                              "  A: {pin: [first, second], angle: q2}\n"
                              "  B: {pin: [second, third], angle: q3}\n",
                              true);
    const char *const names[] = {"l"};
    YkMotionBatch *batch = yk_motion_batch_new(m.state, names, 1, 1, m.problems);
    YkDynamics *d = yk_dynamics_new(m.mech, m.problems);
    draw(&m, names, 1, 0, 4);
    YkMotionCase asked = ask(VALUES);
    assert_int_equal(yk_motion_batch_run(batch, &asked, out, status), YK_SINGULAR);
    for (size_t k = 0; k < STATES; k++) {
        double alone[3];
        for (size_t i = 0; i < 3; i++) yk_state_set_input(m.state, i, (YkMotion){q[i][k], v[i][k], 0});
        assert_int_equal(status[k], YK_SINGULAR);
        assert_int_equal(yk_dynamics_accelerate(d, m.state, alone), YK_SINGULAR);
    }
    yk_dynamics_free(d);
    yk_motion_batch_free(batch);
    machine_free(&m);
}

// The largest number that a parameter may be: as alone (yk_variant_set), on both sides of it.
static void test_a_value_beyond_all_measure_is_none(void **unused)
{
    (void)unused;
    const double more = nextafter(1e100, INFINITY), tried[] = {1e100, more, -1e100, -more, 1, 1e200, -INFINITY};
    const size_t count = sizeof tried / sizeof *tried;
    Machine m = machine_load("double-pendulum");
    const char *const name = "tau1", *const *names = &name;
    YkVariant *variant = yk_variant_new(m.mech, names, 1, m.problems);
    YkMotionBatch *batch = yk_motion_batch_new(m.state, names, 1, 1, m.problems);
    for (size_t k = 0; k < count; k++) q[0][k] = q[1][k] = v[0][k] = v[1][k] = 0.3;
    YkMotionCase asked = {(const double *const[]){tried}, positions, rates, NULL, count};
    assert_int_equal(yk_motion_batch_run(batch, &asked, out, status), YK_BAD_MODEL);
    for (size_t k = 0; k < count; k++) {
        assert_int_equal(status[k], yk_variant_set(variant, &tried[k]));
        assert_int_equal(status[k] == YK_OK, fabs(tried[k]) <= 1e100);
        assert_true((a[0][k] != 0) == (status[k] == YK_OK));
        YkMotionCase one = {(const double *const[]){&tried[k]}, positions, rates, NULL, 1}; // beside no worse ones
        assert_int_equal(yk_motion_batch_run(batch, &one, (double *const[]){again[0], again[1]}, NULL), status[k]);
    }
    yk_motion_batch_free(batch);
    yk_variant_free(variant);
    machine_free(&m);
}

// All links lie on a line, and the point masses at the ends of the last three show nothing across it: what resists the
// hub is its own inertia alone. The rounding of 3 kg at 1 m, less 3 kg at 1 m, hides it below 1e-15; above 1e-12 it
// counts.
static const char *const LINE = "parameters: {I: 1}\n"
                                "gravity: [1, 0]\n"
                                "bodies:\n"
                                "  ground: {points: {O: [0, 0]}}\n"
                                "  hub: {points: {O: [0, 0], A: [1, 0]}, mass: 1, inertia: I}\n"
                                "  arm: {points: {A: [0, 0], B: [1, 0]}, mass: 1e-16, inertia: 1}\n"
                                "  one: {points: {B: [0, 0]}, mass: 1, center: [1, 0], inertia: 0}\n"
                                "  two: {points: {B: [0, 0]}, mass: 1, center: [1, 0], inertia: 0}\n"
                                "  three: {points: {A: [0, 0]}, mass: 1, center: [1, 0], inertia: 0}\n"
                                "joints:\n"
                                "  O: {pin: [ground, hub], angle: p}\n"
                                "  A: {pin: [hub, arm], angle: q}\n"
                                "  B: {pin: [arm, one], angle: r}\n"
                                "  C: {pin: [arm, two], at: B, angle: s}\n"
                                "  D: {pin: [hub, three], at: A, angle: u}\n";

static void test_inertia_below_the_rounding_of_all_that_stands_behind_is_none(void **unused)
{
    (void)unused;
    enum { COUNT = 40 };
    double inertia[COUNT], found[5][COUNT], alone[5];
    const char *const name = "I", *const *names = &name;
    Machine m = machine_parse(LINE, true);
    YkMotionBatch *batch = yk_motion_batch_new(m.state, names, 1, 1, m.problems);
    YkVariant *variant = yk_variant_new(m.mech, names, 1, m.problems);
    YkState *state = yk_state_new(yk_variant_mechanism(variant));
    assert_true(yk_state_assemble(state) >= 0);
    for (size_t k = 0; k < COUNT; k++) inertia[k] = 1e-16 * pow(10, (double)k / 6);
    YkMotionCase asked = {.parameters = (const double *const[]){inertia}, .count = COUNT};
    yk_motion_batch_run(batch, &asked, (double *const[]){found[0], found[1], found[2], found[3], found[4]}, status);
    for (size_t k = 0; k < COUNT; k++) {
        if (inertia[k] < 1e-15) assert_int_equal(status[k], YK_SINGULAR);
        if (inertia[k] > 1e-11) assert_int_equal(status[k], YK_OK);
        if (k > 0 && status[k - 1] == YK_OK) assert_int_equal(status[k], YK_OK); // there is one threshold
        assert_int_equal(yk_variant_set(variant, &inertia[k]), YK_OK);
        YkDynamics *d = yk_dynamics_new(yk_variant_mechanism(variant), m.problems);
        assert_int_equal(yk_dynamics_accelerate(d, state, alone), status[k]); // one by one: another program
        yk_dynamics_free(d);
        for (int i = 0; i < 5; i++) assert_true(found[i][k] == 0); // on the line nothing turns
    }
    yk_state_free(state);
    yk_variant_free(variant);
    yk_motion_batch_free(batch);
    machine_free(&m);
}

static void test_what_is_left_out_is_the_files_own(void **unused)
{
    (void)unused;
    Machine m = machine_load("double-pendulum");
    YkMotionBatch *batch = yk_motion_batch_new(m.state, PENDULUM, 1, 1, m.problems);
    YkDynamics *d = yk_dynamics_new(m.mech, m.problems);
    double alone[2];
    assert_int_equal(yk_dynamics_accelerate(d, m.state, alone), YK_OK);
    YkMotionCase asked = {.count = 3};
    assert_int_equal(yk_motion_batch_run(batch, &asked, out, status), YK_OK);
    for (int i = 0; i < 2; i++) CHECK_NEAR(a[i][2], alone[i], 1e-13 * fabs(alone[i]));
    const double none[STATES] = {0}, *const efforts[] = {none, none};
    asked.efforts = efforts;
    double before = a[0][2];
    assert_int_equal(yk_motion_batch_run(batch, &asked, out, status), YK_OK);
    assert_true(fabs(a[0][2] - before) > 0.1);
    yk_dynamics_free(d);
    yk_motion_batch_free(batch);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_double_pendulum_is_its_textbook_equation),
        cmocka_unit_test(test_trees_and_loops_are_the_file_with_these_values),
        cmocka_unit_test(test_short_chains_are_the_file_with_these_values),
        cmocka_unit_test(test_loops_alone_are_solved_in_lanes),
        cmocka_unit_test(test_lanes_do_not_depend_on_their_number),
        cmocka_unit_test(test_what_has_no_answer_has_a_status_and_zeros),
        cmocka_unit_test(test_pendulums_of_any_size_fall_the_same),
        cmocka_unit_test(test_two_weightless_links_are_singular),
        cmocka_unit_test(test_a_value_beyond_all_measure_is_none),
        cmocka_unit_test(test_inertia_below_the_rounding_of_all_that_stands_behind_is_none),
        cmocka_unit_test(test_what_is_left_out_is_the_files_own),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
