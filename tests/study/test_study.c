// Studies: closed forms, the same bits on any number of threads, a status for every design, extents.
#include <yoke/move.h>
#include "study_check.h"

enum { DESIGNS = 700, POSES = 37 };
static double a[DESIGNS], b[DESIGNS], c[DESIGNS], theta[DESIGNS * POSES], out[3][DESIGNS * POSES];
static signed char status[DESIGNS * POSES];

static void draw(double spread, uint64_t seed)
{
    for (size_t k = 0; k < DESIGNS; k++) {
        a[k] = 0.04 * (1 + check_uniform(&seed, -spread, spread));
        b[k] = 0.12 * (1 + check_uniform(&seed, -spread, spread));
        c[k] = 0.08 * (1 + check_uniform(&seed, -spread, spread));
    }
    for (size_t k = 0; k < DESIGNS * POSES; k++) theta[k] = check_uniform(&seed, 0, 6.28);
}

// examples/four-bar.yaml (ground 100 mm) by the cosine theorem: the rocker's angle and the coupler's point.
static bool four_bar(double crank, double coupler, double rocker, double at, double *angle, YkVec *P)
{
    YkVec A = yk_scale(crank, yk_unit(at)), d = yk_sub(A, yk_vec(0.1, 0));
    double L = yk_norm(d), x = (L * L + rocker * rocker - coupler * coupler) / (2 * rocker * L);
    if (!(fabs(x) <= 1)) return false;
    *angle = atan2(d.y, d.x) - acos(x);
    YkVec B = yk_add(yk_vec(0.1, 0), yk_scale(rocker, yk_unit(*angle)));
    YkVec u = yk_scale(1 / coupler, yk_sub(B, A));
    *P = yk_add(A, yk_mul(u, yk_vec(coupler / 2, coupler / 4)));
    return true;
}

// Where the four-bar comes from its start at 40 deg, straight: it closes as long as the diagonal from A to O4 does,
// which grows from 0 to 180 deg and shrinks from there.
static YkStatus reach(double crank, double coupler, double rocker, double at)
{
    double start = 40 * YK_PI / 180, ends[] = {start, at, at > YK_PI ? YK_PI : at}, low = INFINITY, high = 0;
    for (int k = 0; k < 3; k++) {
        double L = yk_norm(yk_sub(yk_scale(crank, yk_unit(ends[k])), yk_vec(0.1, 0)));
        if (k == 0 && !(L <= coupler + rocker && L >= fabs(coupler - rocker))) return YK_NO_ASSEMBLY;
        low = fmin(low, L), high = fmax(high, L);
    }
    return high <= coupler + rocker && low >= fabs(coupler - rocker) ? YK_OK : YK_LIMIT;
}

static const char *const LENGTHS[] = {"a", "b", "c"}, *const OF[] = {"theta4", "coupler.P.x", "coupler.P.y"};

static YkStudyCase ask(const double *const *parameters, const double *const *inputs, size_t poses, bool per_design)
{
    return (YkStudyCase){parameters, DESIGNS, inputs, poses, per_design};
}

static void test_every_pose_with_its_own_lengths_is_the_closed_form(void **unused)
{
    (void)unused;
    Machine m = machine_load("four-bar");
    YkStudy *study = study_of(&m, LENGTHS, 3, OF, 3, 2);
    const double *parameters[] = {a, b, c}, *inputs[] = {theta, NULL, NULL};
    double *outputs[] = {out[0], out[1], out[2]};
    draw(0.05, 1);
    YkStudyCase asked = ask(parameters, inputs, POSES, true);
    assert_int_equal(yk_study_run(study, &asked, outputs, status), YK_OK);
    for (size_t k = 0; k < DESIGNS * POSES; k++) {
        double angle;
        YkVec P;
        size_t d = k / POSES;
        assert_true(four_bar(a[d], b[d], c[d], theta[k], &angle, &P));
        CHECK_NEAR(remainder(out[0][k] - angle, 2 * YK_PI), 0, 1e-12);
        CHECK_NEAR(out[1][k], P.x, 1e-14);
        CHECK_NEAR(out[2][k], P.y, 1e-14);
    }
    yk_study_free(study);
    machine_free(&m);
}

static void test_designs_that_do_not_close_have_a_status_and_no_nan(void **unused)
{
    (void)unused;
    Machine m = machine_load("four-bar");
    YkStudy *study = study_of(&m, LENGTHS, 3, OF, 3, 3);
    const double *parameters[] = {a, b, c}, *inputs[] = {theta, NULL, NULL};
    double *outputs[] = {out[0], out[1], out[2]};
    draw(0.6, 2);
    a[3] = NAN;
    YkStudyCase asked = ask(parameters, inputs, POSES, true);
    assert_int_equal(yk_study_run(study, &asked, outputs, status), YK_BAD_MODEL);
    size_t count[3] = {0, 0, 0}, beyond = 0;
    for (size_t k = 0; k < DESIGNS * POSES; k++) {
        double angle;
        YkVec P;
        size_t d = k / POSES;
        YkStatus reached = d == 3 ? YK_BAD_MODEL : reach(a[d], b[d], c[d], theta[k]);
        bool closes = four_bar(a[d], b[d], c[d], theta[k], &angle, &P);
        assert_int_equal(status[k], reached);
        if (reached < 0) assert_true(out[0][k] == 0 && out[1][k] == 0 && out[2][k] == 0);
        if (reached == YK_OK) CHECK_NEAR(out[1][k], P.x, 1e-10);
        if (reached > YK_BAD_MODEL) count[-reached]++;
        beyond += reached == YK_LIMIT && closes;
    }
    assert_true(count[0] > 1000 && count[1] > 1000 && count[2] > 1000 && beyond > 100);
    yk_study_free(study);
    machine_free(&m);
}

// All designs have the same poses, whose lanes stay from design to design where they are few; or each has its own.
static void test_poses_of_all_designs_give_the_bits_of_poses_of_each(void **unused)
{
    (void)unused;
    // close together; lanes between; too many of them; back; and far from the start, so that many lanes lead to the
    // first
    static const double steps[] = {0.02, 0.15, 0.5, -0.15, 0.05}, from[] = {0.7, 0.7, 0.7, 0.7, 15.2};
    static double shared[3][DESIGNS * POSES], pose[POSES];
    static signed char shared_status[DESIGNS * POSES];
    Machine m = machine_load("four-bar");
    YkStudy *study = study_of(&m, LENGTHS, 3, OF, 3, 2);
    const double *parameters[] = {a, b, c}, *own[] = {theta, NULL, NULL}, *same[] = {pose, NULL, NULL};
    double *outputs[] = {out[0], out[1], out[2]}, *others[] = {shared[0], shared[1], shared[2]};
    draw(0.6, 5);
    for (int k = 0; k < 5; k++) {
        for (size_t i = 0; i < DESIGNS * POSES; i++) theta[i] = from[k] + steps[k] * (double)(i % POSES);
        memcpy(pose, theta, sizeof pose);
        YkStudyCase each = ask(parameters, own, POSES, true), all = ask(parameters, same, POSES, false);
        YkStatus worst = yk_study_run(study, &each, outputs, status);
        assert_int_equal(yk_study_run(study, &all, others, shared_status), worst);
        assert_memory_equal(status, shared_status, sizeof status);
        assert_memory_equal(out, shared, sizeof out);
    }
    yk_study_free(study);
    machine_free(&m);
}

static void check_threads(const char *file, const char *const *parameters, size_t count, const double *const *values,
                          const char *const *of)
{
    static double first[3][DESIGNS];
    static YkExtent extent[2][DESIGNS];
    Machine m = machine_load(file);
    for (size_t threads = 1; threads <= 3; threads++) {
        YkStudy *study = study_of(&m, parameters, count, of, 1, threads);
        double *outputs[] = {out[0]};
        const double *inputs[] = {theta, NULL, NULL};
        YkStudyCase single = ask(values, inputs, 1, true), cycle = ask(values, inputs, 50, false);
        yk_study_run(study, &single, outputs, status);
        yk_study_reduce(study, &cycle, extent[threads > 1], NULL, NULL);
        if (threads == 1) memcpy(first[0], out[0], sizeof first[0]);
        assert_memory_equal(first[0], out[0], sizeof first[0]);
        assert_memory_equal(extent[0], extent[threads > 1], sizeof extent[0]);
        yk_study_free(study);
    }
    machine_free(&m);
}

static void test_any_number_of_threads_gives_the_same_bits(void **unused)
{
    (void)unused;
    draw(0.3, 3);
    const double *values[] = {a, b, c};
    check_threads("four-bar", LENGTHS, 3, values, OF);
    const char *group[] = {"a1"};
    static double base[DESIGNS];
    Machine m = machine_load("quick-return");
    double own = yk_model_parameter(m.model, "a1");
    for (size_t k = 0; k < DESIGNS; k++) base[k] = own * (1 + 0.1 * (double)k / DESIGNS);
    machine_free(&m);
    check_threads("quick-return", group, 1, (const double *const[]){base}, (const char *const[]){"d5"});
}

static void test_extents_are_those_of_the_poses(void **unused)
{
    (void)unused;
    static YkExtent extent[3 * DESIGNS];
    static signed char worst[DESIGNS];
    static size_t standing[DESIGNS];
    Machine m = machine_load("four-bar");
    YkStudy *study = study_of(&m, LENGTHS, 3, OF, 3, 2);
    const double *parameters[] = {a, b, c}, *inputs[] = {theta, NULL, NULL};
    double *outputs[] = {out[0], out[1], out[2]};
    draw(0.5, 4);
    YkStudyCase asked = ask(parameters, inputs, POSES, false);
    yk_study_run(study, &asked, outputs, status);
    yk_study_reduce(study, &asked, extent, worst, standing);
    for (size_t d = 0; d < DESIGNS; d++) {
        size_t stand = 0;
        double least = INFINITY, largest = -INFINITY, sum = 0;
        for (size_t k = d * POSES; k < (d + 1) * POSES; k++) {
            if (status[k] < 0) continue;
            stand++, sum += out[1][k];
            least = fmin(least, out[1][k]), largest = fmax(largest, out[1][k]);
        }
        YkExtent e = extent[DESIGNS + d];
        assert_int_equal(standing[d], stand);
        assert_int_equal(worst[d], stand == POSES                        ? YK_OK
                                   : status[d * POSES] == YK_NO_ASSEMBLY ? YK_NO_ASSEMBLY
                                                                         : YK_LIMIT);
        if (stand == 0) assert_true(e.least == 0 && e.largest == 0 && e.mean == 0);
        if (stand == 0) continue;
        assert_true(e.least == least && e.largest == largest);
        CHECK_NEAR(e.mean, sum / (double)stand, 1e-15);
    }
    yk_study_free(study);
    machine_free(&m);
}

// A pendulum of length l and mass m under gravity needs the torque m g l cos(q) to be held.
static void test_forces_follow_masses_and_lengths(void **unused)
{
    (void)unused;
    Machine m = machine_parse("parameters: {l: 1 m, m: 2 kg}\n"
                              "gravity: [0, -9.81]\n"
                              "bodies:\n"
                              "  ground: {points: {O: [0, 0]}}\n"
                              "  arm: {points: {O: [0, 0]}, mass: m, center: [l, 0]}\n"
                              "joints: {O: {pin: [ground, arm], angle: q}}\n"
                              "drives: {q: 0.3 rad + 0 rad/s * t}\n",
                              true);
    const char *names[] = {"l", "m"}, *of[] = {"q.effort"};
    YkStudy *study = study_of(&m, names, 2, of, 1, 2);
    const double *parameters[] = {a, b}, *inputs[] = {theta, NULL, NULL};
    double *outputs[] = {out[0]};
    draw(0.5, 5);
    YkStudyCase asked = ask(parameters, inputs, 3, true);
    assert_int_equal(yk_study_run(study, &asked, outputs, status), YK_OK);
    for (size_t k = 0; k < 3 * DESIGNS; k++) CHECK_NEAR(out[0][k], b[k / 3] * 9.81 * a[k / 3] * cos(theta[k]), 1e-14);
    yk_study_free(study);
    machine_free(&m);
}

// A four-bar driven at its rocker turns back and forth between 54.9 and 128.7 deg, or, assembled on the other side,
// between -128.7 and -54.9 deg; the labels are the same there.
static void test_a_pose_in_another_range_of_the_same_label_is_a_limit(void **unused)
{
    (void)unused;
    enum { COUNT = 5 };
    Machine m = machine_parse("units: {length: mm, angle: deg}\n"
                              "parameters: {a: 40, b: 120, c: 80, d: 100}\n"
                              "bodies:\n"
                              "  ground:  {points: {O2: [0, 0], O4: [d, 0]}}\n"
                              "  crank:   {points: {O2: [0, 0], A: [a, 0]}}\n"
                              "  coupler: {points: {A: [0, 0], B: [b, 0]}}\n"
                              "  rocker:  {points: {O4: [0, 0], B: [c, 0]}}\n"
                              "joints:\n"
                              "  O4: {pin: [ground, rocker], angle: theta4}\n"
                              "  O2: {pin: [ground, crank], angle: theta2}\n"
                              "  A:  {pin: [crank, coupler], angle: gamma}\n"
                              "  B:  {pin: [coupler, rocker]}\n"
                              "drives: {theta4: 90 + 1 rad/s * t}\n"
                              "start: {theta2: 60, gamma: -40}\n",
                              true);
    const char *name = "a", *of = "theta2";
    double length[] = {0.039, 0.04, 0.041}, degrees[COUNT] = {60, -90, 120, 140, 57}, at[COUNT], *outputs[] = {out[0]};
    for (int k = 0; k < COUNT; k++) at[k] = degrees[k] * YK_PI / 180;
    const double *parameters[] = {length}, *inputs[] = {at, NULL, NULL};
    YkStudy *study = study_of(&m, &name, 1, &of, 1, 1);
    YkStudyCase asked = {parameters, 3, inputs, COUNT, false};
    assert_int_equal(yk_study_run(study, &asked, outputs, status), YK_LIMIT);
    for (int k = 0; k < 3 * COUNT; k++) {
        assert_int_equal(status[k], k % COUNT == 1 || k % COUNT == 3 ? YK_LIMIT : YK_OK);
        if (status[k] < 0) continue;
        YkVec B = yk_add(yk_vec(0.1, 0), yk_scale(0.08, yk_unit(at[k % COUNT]))),
              A = yk_scale(length[k / COUNT], yk_unit(out[0][k]));
        CHECK_NEAR(yk_norm(yk_sub(B, A)), 0.12, 1e-15); // it closes,
        assert_true(yk_cross(A, yk_sub(B, A)) < 0);     // on the side of the start
    }
    yk_study_free(study);
    machine_free(&m);
}

// Two cranks of 0.5 on pins 1 apart, joined by links of 0.6: they close while their ends are at most 1.2 apart, which
// ends for the first one near 150.6 and -90.6 deg if the other is at 120. Where one ended blocks no pose before that
// place, nor the other crank.
static void test_a_known_limit_blocks_what_lies_beyond_it_alone(void **unused)
{
    (void)unused;
    static const double degrees[][2] = {{60, 120}, {170, 120},  {149, 120}, {153, 120}, {60, 120}, {60, 160},
                                        {60, 120}, {-100, 120}, {-88, 120}, {-93, 120}, {0, 120},  {150, 120}};
    enum { COUNT = sizeof degrees / sizeof *degrees };
    Machine m = machine_parse("parameters: {l: 0.6}\n"
                              "bodies:\n"
                              "  ground: {points: {O: [0, 0], C: [1, 0]}}\n"
                              "  one:    {points: {O: [0, 0], A: [0.5, 0]}}\n"
                              "  other:  {points: {C: [0, 0], B: [0.5, 0]}}\n"
                              "  left:   {points: {A: [0, 0], D: [l, 0]}}\n"
                              "  right:  {points: {B: [0, 0], D: [0.6, 0]}}\n"
                              "joints:\n"
                              "  O: {pin: [ground, one], angle: p}\n"
                              "  C: {pin: [ground, other], angle: q}\n"
                              "  A: {pin: [one, left], angle: u}\n"
                              "  B: {pin: [other, right], angle: v}\n"
                              "  D: {pin: [left, right]}\n"
                              "drives: {p: 1 + 1 rad/s * t, q: 2 + 1 rad/s * t}\nstart: {u: 0, v: 0}\n",
                              true);
    const char *name = "l", *of[] = {"left.D.x", "left.D.y"};
    double length[] = {0.6}, p[COUNT], q[COUNT], *outputs[] = {out[0], out[1]};
    const double *parameters[] = {length}, *inputs[] = {p, NULL, NULL, q, NULL, NULL};
    for (int k = 0; k < COUNT; k++) p[k] = degrees[k][0] * YK_PI / 180, q[k] = degrees[k][1] * YK_PI / 180;
    YkStudy *study = study_of(&m, &name, 1, of, 2, 1);
    YkStudyCase asked = {parameters, 1, inputs, COUNT, false};
    assert_int_equal(yk_study_run(study, &asked, outputs, status), YK_LIMIT);
    for (int k = 0; k < COUNT; k++) {
        YkVec A = yk_scale(0.5, yk_unit(p[k])), B = yk_add(yk_vec(1, 0), yk_scale(0.5, yk_unit(q[k])));
        assert_int_equal(status[k], yk_norm(yk_sub(A, B)) <= 1.2 ? YK_OK : YK_LIMIT);
        if (status[k] < 0) continue;
        CHECK_NEAR(yk_norm(yk_sub(yk_vec(out[0][k], out[1][k]), A)), 0.6, 1e-14);
        CHECK_NEAR(yk_norm(yk_sub(yk_vec(out[0][k], out[1][k]), B)), 0.6, 1e-14);
    }
    yk_study_free(study);
    machine_free(&m);
}

// A parallelogram stays one through its change points at 0 and 180 deg, its cranks parallel for turn after turn; fine
// poses and far ones, forth and back.
static void test_a_parallelogram_stays_one_through_its_change_points(void **unused)
{
    (void)unused;
    enum { COUNT = 400 };
    Machine m = machine_parse("units: {length: mm, angle: deg}\n"
                              "parameters: {a: 40, d: 100}\n"
                              "bodies:\n"
                              "  ground:  {points: {O2: [0, 0], O4: [d, 0]}}\n"
                              "  crank:   {points: {O2: [0, 0], A: [a, 0]}}\n"
                              "  coupler: {points: {A: [0, 0], B: [d, 0]}}\n"
                              "  rocker:  {points: {O4: [0, 0], B: [a, 0]}}\n"
                              "joints:\n"
                              "  O2: {pin: [ground, crank], angle: theta2}\n"
                              "  A:  {pin: [crank, coupler], angle: gamma}\n"
                              "  O4: {pin: [ground, rocker], angle: theta4}\n"
                              "  B:  {pin: [coupler, rocker]}\n"
                              "drives: {theta2: 60 + 1 rad/s * t}\n"
                              "start: {gamma: -60, theta4: 60}\n",
                              true);
    const char *names[] = {"a", "d"}, *of[] = {"theta4", "theta4.rate"};
    double first[] = {0.03, 0.04, 0.07}, second[] = {0.1, 0.11, 0.08}, at[COUNT], one[COUNT];
    double *outputs[] = {out[0], out[1]};
    const double *parameters[] = {first, second}, *inputs[] = {at, one, NULL};
    YkStudy *study = study_of(&m, names, 2, of, 2, 2);
    for (int way = 0; way < 3; way++) {
        for (int k = 0; k < COUNT; k++) {
            double step = way == 1 ? 0.5 : 0.03;
            at[k] = 1.1 + (way == 2 ? -1 : 1) * step * k, one[k] = 1;
        }
        YkStudyCase asked = {parameters, 3, inputs, COUNT, false};
        assert_int_equal(yk_study_run(study, &asked, outputs, status), YK_OK);
        for (int k = 0; k < 3 * COUNT; k++) {
            CHECK_NEAR(out[0][k], at[k % COUNT], 1e-9);
            CHECK_NEAR(out[1][k], 1, 1e-6);
        }
    }
    yk_study_free(study);
    machine_free(&m);
}

// Angles that turn with the crank are counted, on lanes as on states.
static void test_turns_are_counted_along_the_poses(void **unused)
{
    (void)unused;
    enum { COUNT = 300 };
    Machine m = machine_load("drag-link");
    YkChannel channels[] = {machine_channel(&m, "theta4"), machine_channel(&m, "B.transmission")};
    double at[COUNT], *outputs[] = {out[0], out[1]}, *again[] = {out[2], out[1]};
    for (int k = 0; k < COUNT; k++) at[k] = 2 + 0.1 * k;
    const double *inputs[] = {at, NULL, NULL};
    YkStudyCase asked = {NULL, 1, inputs, COUNT, false};
    for (int by_state = 0; by_state < 2; by_state++) {
        YkStudyOptions options = {NULL, 0, channels, by_state ? 2 : 1, 1, NULL};
        YkStudy *study = yk_study_new(m.state, &options, m.problems);
        assert_non_null(study);
        assert_int_equal(yk_study_run(study, &asked, by_state ? again : outputs, status), YK_OK);
        yk_study_free(study);
    }
    assert_memory_equal(out[0], out[2], COUNT * sizeof(double));
    double turned = out[0][COUNT - 1] - out[0][0];
    CHECK_NEAR(turned, at[COUNT - 1] - at[0], 2); // it goes round with the crank, faster and slower
    for (int k = 1; k < COUNT; k++) assert_true(fabs(out[0][k] - out[0][k - 1]) < 0.5);
    machine_free(&m);
}

// A drag link's output, which has turned by more than half a turn where a parallelogram on the same crank comes to its
// change point: counted before it and beyond.
static void test_turns_are_counted_up_to_a_change_point(void **unused)
{
    (void)unused;
    enum { COUNT = 500 };
    Machine m = machine_parse("bodies:\n"
                              "  ground: {points: {O2: [0, 0], O4: [1, 0], Q: [5, 0]}}\n"
                              "  input: {points: {O2: [0, 0], A: [2, 0]}}\n"
                              "  coupler: {points: {A: [0, 0], B: [1.8, 0]}}\n"
                              "  output: {points: {O4: [0, 0], B: [2.4, 0]}}\n"
                              "  bar: {points: {A: [0, 0], D: [5, 0]}}\n"
                              "  follower: {points: {Q: [0, 0], D: [2, 0]}}\n"
                              "joints:\n"
                              "  O2: {pin: [ground, input], angle: theta2}\n"
                              "  A: {pin: [input, coupler], angle: theta3}\n"
                              "  O4: {pin: [ground, output], angle: theta4}\n"
                              "  B: {pin: [coupler, output]}\n"
                              "  C: {pin: [input, bar], at: A, angle: gamma}\n"
                              "  Q: {pin: [ground, follower], angle: phi}\n"
                              "  D: {pin: [bar, follower]}\n"
                              "drives: {theta2: 90 deg + 1 rad/s * t}\n"
                              "start: {theta3: -80 deg, theta4: 60 deg, gamma: -90 deg, phi: 90 deg}\n",
                              true);
    YkChannel channels[] = {machine_channel(&m, "theta4"), machine_channel(&m, "phi"),
                            machine_channel(&m, "B.transmission")};
    static double first[2][COUNT], second[3][COUNT], at[COUNT];
    double farthest = 0;
    double *outputs[] = {first[0], first[1]}, *again[] = {second[0], second[1], second[2]};
    const double *inputs[] = {at, NULL, NULL};
    for (int start = 0; start < 4; start++) { // from both sides of both change points, and away from each
        bool is_back = start % 2;
        for (int k = 0; k < COUNT; k++) at[k] = (start / 2 * 180 + (is_back ? -1 - k : 1 + k)) * YK_PI / 180;
        assert_true(yk_state_move_to(m.state, &(YkMotion){at[0], 1, 0}, NULL, NULL) >= 0);
        YkStudyCase asked = {NULL, 1, inputs, COUNT, false};
        for (int by_state = 0; by_state < 2; by_state++) {
            YkStudyOptions options = {NULL, 0, channels, by_state ? 3 : 2, 1, NULL};
            YkStudy *study = yk_study_new(m.state, &options, m.problems);
            assert_non_null(study);
            assert_true(yk_study_run(study, &asked, by_state ? again : outputs, status) >= 0);
            yk_study_free(study);
        }
        farthest = fmax(farthest, fabs(first[0][178] - first[0][0]));
        for (int k = 0; k < COUNT; k++) {
            CHECK_NEAR(first[0][k], second[0][k], 1e-12);
            CHECK_NEAR(first[1][k], at[k], 1e-6);
        }
    }
    assert_true(farthest > YK_PI);
    machine_free(&m);
}

static void test_a_machine_with_a_group_is_assembled_for_every_design(void **unused)
{
    (void)unused;
    Machine m = machine_parse(TRIAD, true);
    const char *name = "l", *of = "theta2";
    YkStudy *study = study_of(&m, &name, 1, &of, 1, 2);
    double own = yk_model_parameter(m.model, name), values[5], *outputs[] = {out[0]};
    for (int k = 0; k < 5; k++) values[k] = own * (1 + 0.002 * (k - 2));
    const double *parameters[] = {values};
    YkStudyCase asked = {parameters, 5, NULL, 1, false};
    assert_int_equal(yk_study_run(study, &asked, outputs, status), YK_OK);
    CHECK_NEAR(out[0][2], machine_ask(&m, of), 1e-10);
    double second = out[0][1] - 2 * out[0][2] + out[0][3];
    assert_true(fabs(second) < 0.05 * fabs(out[0][3] - out[0][1]) + 1e-12); // smooth: one branch
    yk_study_free(study);
    machine_free(&m);
}

// A study over `input`, whose designs start where the machine's own inputs put them.
static YkStudy *study_from(const Machine *m, const char *input, const char *const *parameters, size_t count,
                           const char *of, Machine *over)
{
    *over = (Machine){.problems = m->problems, .model = m->model};
    machine_compile(over, input);
    assert_true(yk_state_adopt(over->state, m->state) >= 0);
    YkChannel channel = machine_channel(over, of);
    YkStudyOptions options = {.parameters = parameters,
                              .parameter_count = count,
                              .channels = &channel,
                              .channel_count = 1,
                              .start = m->state};
    YkStudy *study = yk_study_new(over->state, &options, m->problems);
    assert_non_null(study);
    return study;
}

static void end_from(YkStudy *study, Machine *over)
{
    yk_study_free(study);
    yk_state_free(over->state);
    yk_mechanism_free(over->mech);
}

// The four-bar is assembled by its crank at 40 deg, then moved by its rocker, which gives the crank's angle back from
// there to the next dead point. A crank that cannot stand at 40 deg makes no design, wherever the rocker is.
static void test_designs_start_at_the_inputs_of_the_start(void **unused)
{
    (void)unused;
    enum { COUNT = 40 };
    static double crank[COUNT * POSES], rocker[COUNT * POSES];
    Machine m = machine_load("four-bar"), over;
    YkStudy *study = study_from(&m, "theta4", LENGTHS, 3, "theta2", &over);
    uint64_t seed = 8;
    draw(0.05, 7);
    a[0] = 0.9;
    for (size_t k = 0; k < COUNT * POSES; k++) {
        YkVec P;
        rocker[k] = 2;
        crank[k] = check_uniform(&seed, 0.8, 3.1);
        if (k >= POSES) assert_true(four_bar(a[k / POSES], b[k / POSES], c[k / POSES], crank[k], &rocker[k], &P));
    }
    const double *parameters[] = {a, b, c}, *inputs[] = {rocker, NULL, NULL};
    double *outputs[] = {out[0]};
    YkStudyCase asked = {parameters, COUNT, inputs, POSES, true};
    assert_int_equal(yk_study_run(study, &asked, outputs, status), YK_NO_ASSEMBLY);
    for (size_t k = 0; k < COUNT * POSES; k++) {
        assert_int_equal(status[k], k < POSES ? YK_NO_ASSEMBLY : YK_OK);
        CHECK_NEAR(out[0][k], k < POSES ? 0 : crank[k], 1e-10);
    }
    end_from(study, &over);
    machine_free(&m);
}

// There and back: the crank's angles of a triad that its output drives, then the output's angles that they give.
static void test_groups_start_at_the_inputs_of_the_start(void **unused)
{
    (void)unused;
    enum { COUNT = 5 };
    static const char *const name = "l", *const crank = "theta2";
    Machine m = machine_parse(TRIAD, true), over;
    double own = yk_model_parameter(m.model, name), values[COUNT], at[POSES], *outputs[] = {out[0]}, *back[] = {out[1]};
    for (int k = 0; k < COUNT; k++) values[k] = own * (1 + 0.002 * (k - 2));
    for (int k = 0; k < POSES; k++) at[k] = 120 * YK_PI / 180 + 0.002 * k;
    const double *parameters[] = {values}, *inputs[] = {at, NULL, NULL}, *cranks[] = {out[0], NULL, NULL};
    YkStudy *there = study_of(&m, &name, 1, &crank, 1, 1);
    YkStudyCase asked = {parameters, COUNT, inputs, POSES, false};
    assert_int_equal(yk_study_run(there, &asked, outputs, status), YK_OK);
    YkStudy *study = study_from(&m, crank, &name, 1, "theta6", &over);
    asked = (YkStudyCase){parameters, COUNT, cranks, POSES, true};
    assert_int_equal(yk_study_run(study, &asked, back, status), YK_OK);
    for (size_t k = 0; k < COUNT * POSES; k++) CHECK_NEAR(out[1][k], at[k % POSES], 1e-9);
    values[0] = 40; // a link that reaches nothing
    assert_int_equal(yk_study_run(study, &asked, back, status), YK_NO_ASSEMBLY);
    assert_true(status[0] == YK_NO_ASSEMBLY && status[POSES] == YK_OK && out[1][0] == 0);
    end_from(study, &over);
    yk_study_free(there);
    machine_free(&m);
}

// A piston driven over its full stroke turns back just at its limits and takes its crank round, if it is moved in time.
static void test_a_drive_that_turns_back_at_limits_is_followed_in_time(void **unused)
{
    (void)unused;
    enum { COUNT = 60 };
    Machine m = machine_parse("parameters: {m: 1 kg}\n"
                              "bodies:\n"
                              "  ground: {points: {O: [0, 0]}}\n"
                              "  crank: {points: {O: [0, 0], A: [30 mm, 0]}, mass: m}\n"
                              "  coupler: {points: {A: [0, 0], B: [80 mm, 0]}}\n"
                              "  piston: {points: {B: [0, 0]}, mass: 0.3 kg}\n"
                              "joints:\n"
                              "  O: {pin: [ground, crank], angle: theta}\n"
                              "  A: {pin: [crank, coupler]}\n"
                              "  B: {pin: [coupler, piston]}\n"
                              "  S: {slide: [ground, piston], along: x, from: O, to: B, distance: s}\n"
                              "drives: {s: 80 mm + 30 mm * cos(1 rad/s * t + 1 rad)}\n"
                              "start: {theta: 60 deg, A.angle: -90 deg}\n",
                              true);
    const char *name = "m";
    double masses[] = {0.5, 2}, time[COUNT], motion[3][COUNT], *outputs[] = {out[0], out[1]};
    for (int k = 0; k < COUNT; k++) {
        time[k] = 0.31 * k;
        motion[0][k] = 0.08 + 0.03 * cos(time[k] + 1);
        motion[1][k] = -0.03 * sin(time[k] + 1);
        motion[2][k] = -0.03 * cos(time[k] + 1);
    }
    YkChannel channels[] = {machine_channel(&m, "theta"), machine_channel(&m, "theta.rate")};
    YkStudyOptions options = {
        .parameters = &name, .parameter_count = 1, .channels = channels, .channel_count = 2, .follows_time = true};
    YkStudy *study = yk_study_new(m.state, &options, m.problems);
    assert_non_null(study);
    const double *parameters[] = {masses}, *inputs[] = {motion[0], motion[1], motion[2]};
    YkStudyCase asked = {parameters, 2, inputs, COUNT, false, time};
    assert_int_equal(yk_study_run(study, &asked, outputs, status), YK_OK);
    for (int k = 0; k < 2 * COUNT; k++) {
        double phase = time[k % COUNT] + 1, turns = floor(phase / (2 * YK_PI)), s = 0.08 + 0.03 * cos(phase);
        double half = acos((s * s + 0.03 * 0.03 - 0.08 * 0.08) / (2 * 0.03 * s));
        double theta = 2 * YK_PI * turns + (sin(phase) > 0 ? half : 2 * YK_PI - half);
        double x = 0.03 * cos(theta), y = 0.03 * sin(theta), rate = -0.03 * sin(phase) / (-y - x * y / (s - x));
        CHECK_NEAR(out[0][k], theta, 1e-9);
        CHECK_NEAR(out[1][k], rate, 1e-7);
    }
    yk_study_free(study);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_pose_with_its_own_lengths_is_the_closed_form),
        cmocka_unit_test(test_designs_that_do_not_close_have_a_status_and_no_nan),
        cmocka_unit_test(test_poses_of_all_designs_give_the_bits_of_poses_of_each),
        cmocka_unit_test(test_any_number_of_threads_gives_the_same_bits),
        cmocka_unit_test(test_extents_are_those_of_the_poses),
        cmocka_unit_test(test_forces_follow_masses_and_lengths),
        cmocka_unit_test(test_a_pose_in_another_range_of_the_same_label_is_a_limit),
        cmocka_unit_test(test_a_known_limit_blocks_what_lies_beyond_it_alone),
        cmocka_unit_test(test_a_parallelogram_stays_one_through_its_change_points),
        cmocka_unit_test(test_turns_are_counted_along_the_poses),
        cmocka_unit_test(test_turns_are_counted_up_to_a_change_point),
        cmocka_unit_test(test_a_machine_with_a_group_is_assembled_for_every_design),
        cmocka_unit_test(test_designs_start_at_the_inputs_of_the_start),
        cmocka_unit_test(test_groups_start_at_the_inputs_of_the_start),
        cmocka_unit_test(test_a_drive_that_turns_back_at_limits_is_followed_in_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
