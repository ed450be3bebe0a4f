// Designs that are machines of their own - other teeth, cams, laws, constant angles - against the file with these
// values.
#include "study_check.h"
#include "compile/mechanism.h"

enum { DESIGNS = 4, POSES = 50, CHANNELS = 4 };
static double out[CHANNELS][DESIGNS * POSES], again[CHANNELS][DESIGNS * POSES];
static signed char status[DESIGNS * POSES];

#define CAM                                                                                                            \
    "parameters: {h: 20 cm, b: 60 mm}\n"                                                                               \
    "laws: {lift: {period: 2*pi, segments: ["                                                                          \
    "{polynomial: [{at: 0, s: 0, v: 0, a: 0}, {at: 2*pi/3, s: h}, {at: 4*pi/3, s: 0, v: 0, a: 0}]},"                   \
    "{dwell: {to: 2*pi}}]}}\n"                                                                                         \
    "cams: {valve: {cam: shaft, follower: tappet, law: lift, roller: 10 mm, base: b, offset: 0 mm}}\n"                 \
    "bodies: {shaft: {}, tappet: {mass: 0.2 kg}}\n"                                                                    \
    "joints: {K: {pin: [ground, shaft], angle: theta}, T: {slide: [ground, tappet], along: y, distance: s}}\n"         \
    "drives: {theta: 60 rpm * t}\n"

#define BENT                                                                                                           \
    "parameters: {bend: 30 deg}\n"                                                                                     \
    "bodies: {ground: {points: {O: [0, 0]}}, arm: {points: {O: [0, 0], A: [1 m, 0]}},"                                 \
    " tip: {points: {A: [0, 0], T: [0.5 m, 0]}, mass: 2 kg}}\n"                                                        \
    "joints: {O: {pin: [ground, arm], angle: q}, A: {weld: [arm, tip], turned: bend}}\n"                               \
    "gravity: [0, -9.81 m/s^2]\ndrives: {q: 1 rad/s * t}\n"

static void point_at(double (*rows)[DESIGNS * POSES], double **outputs)
{
    for (size_t c = 0; c < CHANNELS; c++) outputs[c] = rows[c];
}

static void fill_poses(double *at, double from, double step)
{
    for (size_t k = 0; k < POSES; k++) at[k] = from + step * (double)k;
}

// A design of the study, pose by pose, against the text loaded with the value, moved to the same poses.
static void check_design(const char *text, const char *name, const char *value, const char *const *of, size_t count,
                         size_t design, const double *at)
{
    const YkOverride overrides[] = {{name, value}};
    Machine m = machine_parse_with(text, overrides, 1);
    YkDynamics *d = yk_dynamics_new(m.mech, m.problems);
    yk_dynamics_prescribe(d, 0, true);
    assert_true(yk_state_assemble(m.state) >= 0);
    for (size_t k = 0; k < POSES; k++) {
        YkMotion goal = yk_state_input(m.state, 0);
        goal.position = at[k];
        assert_true(yk_state_move_to(m.state, &goal, NULL, NULL) >= 0);
        assert_true(yk_dynamics_solve(d, m.state, YK_METHOD_NEWTON_EULER) >= 0);
        assert_int_equal(status[design * POSES + k], YK_OK);
        for (size_t c = 0; c < count; c++) {
            double due = yk_dynamics_channel(d, m.state, machine_channel(&m, of[c]));
            CHECK_NEAR(out[c][design * POSES + k], due, 1e-10 * (1 + fabs(due)));
        }
    }
    yk_dynamics_free(d);
    machine_free(&m);
}

static void check_study(const char *text, const char *name, const double *values, const char *const *texts,
                        const char *const *of, size_t count)
{
    double at[POSES], *outputs[CHANNELS];
    Machine m = machine_parse(text, true);
    YkStudy *study = study_of(&m, &name, 1, of, count, 2);
    const double *parameters[] = {values}, *inputs[] = {at, NULL, NULL};
    YkStudyCase asked = {parameters, DESIGNS, inputs, POSES, false};
    fill_poses(at, 0.1, 0.15);
    point_at(out, outputs);
    assert_int_equal(yk_study_run(study, &asked, outputs, status), YK_OK);
    for (size_t k = 0; k < DESIGNS; k++) check_design(text, name, texts[k], of, count, k, at);
    yk_study_free(study);
    machine_free(&m);
}

static void test_numbers_of_teeth(void **unused)
{
    (void)unused;
    static const double values[] = {30, 36, 40, 47};
    static const char *const texts[] = {"30", "36", "40", "47"};
    static const char *const of[] = {"x", "theta.rate", "q.effort", "g.force"};
    check_study(GEARED, "z2", values, texts, of, 4);
}

static void test_a_module_moves_the_axes_as_well(void **unused)
{
    (void)unused;
    static const double values[] = {0.0015, 0.002, 0.0025, 0.003};
    static const char *const texts[] = {"1.5 mm", "2 mm", "2.5 mm", "3 mm"};
    static const char *const of[] = {"x", "x.accel", "P.force"};
    check_study(GEARED, "m", values, texts, of, 3);
}

static void test_laws_of_cams(void **unused)
{
    (void)unused;
    static const double lifts[] = {0.01, 0.02, 0.025, 0.03};
    static const char *const texts[] = {"10 mm", "20 mm", "25 mm", "30 mm"};
    static const char *const of[] = {"s", "s.accel", "theta.effort", "valve.force"};
    check_study(CAM, "h", lifts, texts, of, 4);
    check_study(CAM, "b", lifts, texts, of, 4);
}

static void test_constant_angles(void **unused)
{
    (void)unused;
    static const double values[] = {-1, 0, 0.5, 2};
    static const char *const texts[] = {"-1 rad", "0 rad", "0.5 rad", "2 rad"};
    static const char *const of[] = {"tip.T.x", "q.effort", "A.moment"};
    check_study(BENT, "bend", values, texts, of, 3);
}

// Rows of a single thread, and extents, have the same bits.
static void test_threads_and_extents(void **unused)
{
    (void)unused;
    static const double values[] = {24, 30, 40, 50};
    static const char *const of[] = {"x", "q.effort"};
    const char *name = "z2";
    double at[POSES], *outputs[CHANNELS];
    Machine m = machine_parse(GEARED, true);
    const double *parameters[] = {values}, *inputs[] = {at, NULL, NULL};
    YkStudyCase asked = {parameters, DESIGNS, inputs, POSES, false};
    YkExtent extents[2 * DESIGNS];
    size_t standing[DESIGNS];
    fill_poses(at, -2, 0.1);
    memset(out, 0, sizeof out);
    memset(again, 0, sizeof again);
    for (int threads = 1; threads <= 2; threads++) {
        YkStudy *study = study_of(&m, &name, 1, of, 2, (size_t)threads);
        point_at(threads == 1 ? out : again, outputs);
        assert_int_equal(yk_study_run(study, &asked, outputs, NULL), YK_OK);
        assert_int_equal(yk_study_reduce(study, &asked, extents, NULL, standing), YK_OK);
        yk_study_free(study);
    }
    assert_memory_equal(out, again, sizeof out);
    for (size_t d = 0; d < DESIGNS; d++) {
        double least = INFINITY, largest = -INFINITY;
        for (size_t k = 0; k < POSES; k++) {
            least = fmin(least, out[0][d * POSES + k]);
            largest = fmax(largest, out[0][d * POSES + k]);
        }
        assert_true(extents[d].least == least && extents[d].largest == largest && standing[d] == POSES);
    }
    machine_free(&m);
}

static void test_values_that_make_no_machine_are_rows_with_a_status(void **unused)
{
    (void)unused;
    static const double values[] = {30.5, -4, 40, 1e9};
    static const char *const of[] = {"x"};
    const char *name = "z2";
    double *outputs[CHANNELS];
    Machine m = machine_parse(GEARED, true);
    const double *parameters[] = {values};
    YkStudyCase asked = {parameters, DESIGNS, NULL, 1, false};
    YkStudy *study = study_of(&m, &name, 1, of, 1, 1);
    point_at(out, outputs);
    assert_int_equal(yk_study_run(study, &asked, outputs, status), YK_BAD_MODEL);
    assert_int_equal(status[0], YK_BAD_MODEL);
    assert_int_equal(status[1], YK_BAD_MODEL);
    assert_int_equal(status[2], YK_OK);
    assert_true(out[0][0] == 0 && out[0][1] == 0 && out[0][2] > 0);
    yk_study_free(study);
    machine_free(&m);
}

// The piston's place at the module's value: the crank's axis lies (z1 + z2) m / 2 from the pinion's.
static void test_sensitivities(void **unused)
{
    (void)unused;
    static const char *const of[] = {"x"};
    const char *name = "m";
    double derivative, difference;
    Machine m = machine_parse(GEARED, true);
    YkStudy *study = study_of(&m, &name, 1, of, 1, 1);
    assert_int_equal(yk_study_sensitivities(study, NULL, &derivative, &difference), YK_OK);
    CHECK_NEAR(difference, 30, 1e-8);
    assert_true(isnan(derivative)); // the machine is another one for every number of teeth
    yk_study_free(study);
    machine_free(&m);
}

// A parallelogram behind a gear: the module moves both axes together, so the rocker's angle stays and its point moves
// with them, 30 times as far. At its change points positions are known, and rates are not.
#define GEARED_PARALLELOGRAM                                                                                           \
    "parameters: {m: 2 mm}\n"                                                                                          \
    "bodies:\n"                                                                                                        \
    "  ground:  {points: {O: [0, 0], P: [30*m, 0], R: [30*m + 100 mm, 0]}}\n"                                          \
    "  pinion:  {points: {O: [0, 0]}}\n"                                                                               \
    "  wheel:   {points: {P: [0, 0], A: [40 mm, 0]}}\n"                                                                \
    "  coupler: {points: {A: [0, 0], B: [100 mm, 0]}}\n"                                                               \
    "  rocker:  {points: {R: [0, 0], B: [40 mm, 0]}}\n"                                                                \
    "joints:\n"                                                                                                        \
    "  O: {pin: [ground, pinion], angle: q}\n"                                                                         \
    "  P: {pin: [ground, wheel], angle: theta}\n"                                                                      \
    "  A: {pin: [wheel, coupler], angle: gamma}\n"                                                                     \
    "  R: {pin: [ground, rocker], angle: psi}\n"                                                                       \
    "  B: {pin: [coupler, rocker]}\n"                                                                                  \
    "gears: {g: {mesh: [pinion, wheel], teeth: [20, 40], module: m}}\n"                                                \
    "drives: {q: 10 rad/s * t}\n"                                                                                      \
    "start: {theta: 60 deg, gamma: -60 deg, psi: 60 deg}\n"

static void test_sensitivities_at_a_change_point(void **unused)
{
    (void)unused;
    static const char *const of[] = {"psi", "rocker.B.x", "rocker.B.y", "B.force"};
    const char *name = "m";
    double derivative[4], difference[4];
    Machine m = machine_parse(GEARED_PARALLELOGRAM, true);
    YkStudy *study = study_of(&m, &name, 1, of, 4, 1);
    for (int turn = 0; turn < 2; turn++) { // the wheel turns back half as fast: at 20 deg, at 0
        double at = (turn == 0 ? 80 : 120) * YK_PI / 180;
        const double *inputs[] = {&at, NULL, NULL};
        memset(difference, 0x55, sizeof difference);
        assert_int_equal(yk_study_sensitivities(study, inputs, derivative, difference), YK_OK);
        double angle = turn == 0 ? 1e-6 : 0.01; // where branches meet it is known to the root of rounding
        CHECK_NEAR(difference[0], 0, angle);
        CHECK_NEAR(difference[1], 30, 1e-6);
        CHECK_NEAR(difference[2], 0, 0.04 * angle);
        if (turn == 0) CHECK_NEAR(difference[3], 0, 1e-9); // without mass
        if (turn == 1) assert_true(isnan(difference[3]));  // undefined
        for (int c = 0; c < 4; c++) assert_true(isnan(derivative[c]));
    }
    yk_study_free(study);
    machine_free(&m);
}

// A triad whose coupler is bent by a constant angle: a group has no labels, so each design is assembled nearest to the
// file's configuration. At 1 rad that has vanished: the machine closes, but with its rocker 1.7 rad away.
#define BENT_TRIAD                                                                                                     \
    "parameters: {bend: 37 deg}\n"                                                                                     \
    "bodies:\n"                                                                                                        \
    "  ground: {points: {O2: [0, 0], O4: [4, 0], O6: [6, 2.5]}}\n"                                                     \
    "  crank: {points: {O2: [0, 0], A: [1, 0]}}\n"                                                                     \
    "  coupler: {points: {A: [0, 0], B: [3.5, 0]}}\n"                                                                  \
    "  wing: {points: {A: [0, 0], C: [2.5, 0]}}\n"                                                                     \
    "  rocker: {points: {O4: [0, 0], B: [3, 0]}}\n"                                                                    \
    "  link: {points: {C: [0, 0], D: [4.5, 0]}}\n"                                                                     \
    "  output: {points: {O6: [0, 0], D: [2.5, 0]}}\n"                                                                  \
    "joints:\n"                                                                                                        \
    "  O6: {pin: [ground, output], angle: theta6}\n"                                                                   \
    "  D: {pin: [output, link], angle: theta5}\n"                                                                      \
    "  O2: {pin: [ground, crank], angle: theta2}\n"                                                                    \
    "  A: {pin: [crank, coupler], angle: theta3}\n"                                                                    \
    "  W: {weld: [coupler, wing], at: A, turned: bend}\n"                                                              \
    "  O4: {pin: [ground, rocker], angle: theta4}\n"                                                                   \
    "  B: {pin: [coupler, rocker]}\n"                                                                                  \
    "  C: {pin: [wing, link]}\n"                                                                                       \
    "drives: {theta6: 120 deg + 0.1 rad/s * t}\n"                                                                      \
    "start: {theta2: 120 deg, theta3: -90 deg, theta4: 119 deg, theta5: -101 deg}\n"

static void test_groups_are_assembled_near_the_files_configuration(void **unused)
{
    (void)unused;
    static const double values[DESIGNS] = {0.64, 37 * YK_PI / 180, 0.65, 1};
    static const char *const texts[] = {"0.64 rad", "37 deg", "0.65 rad"}, *const of[] = {"theta2", "theta4",
                                                                                          "wing.C.y"};
    const char *name = "bend";
    double at[POSES], *outputs[CHANNELS];
    Machine m = machine_parse(BENT_TRIAD, true);
    assert_true(m.mech->has_groups);
    YkStudy *study = study_of(&m, &name, 1, of, 3, 2);
    const double *parameters[] = {values}, *inputs[] = {at, NULL, NULL};
    YkStudyCase asked = {parameters, DESIGNS, inputs, POSES, false};
    fill_poses(at, 120 * YK_PI / 180, 0.001);
    point_at(out, outputs);
    assert_int_equal(yk_study_run(study, &asked, outputs, status), YK_NO_ASSEMBLY);
    for (size_t k = 0; k < 3; k++) check_design(BENT_TRIAD, name, texts[k], of, 3, k, at);
    for (size_t k = 3 * POSES; k < 4 * POSES; k++)
        assert_true(status[k] == YK_NO_ASSEMBLY && out[0][k] == 0 && out[1][k] == 0 && out[2][k] == 0);
    yk_study_free(study);
    machine_free(&m);
}

// Assembled where the pinion is at 0, then driven at the piston: the wheel stands at 30 deg at first, so the pinion's
// angle follows from the piston's place by the cosine theorem and the teeth.
static void test_designs_start_at_the_inputs_of_the_start(void **unused)
{
    (void)unused;
    static const double modules[DESIGNS] = {0.0019, 0.00195, 0.002, 0.0021};
    static const char *const of[] = {"theta", "q"};
    const char *name = "m";
    double at[POSES], *outputs[CHANNELS], r = 0.02, l = 0.08;
    Machine m = machine_parse(GEARED, true), by_piston = {.problems = m.problems, .model = m.model};
    machine_compile(&by_piston, "x");
    assert_true(yk_state_adopt(by_piston.state, m.state) >= 0);
    YkChannel channels[] = {machine_channel(&by_piston, of[0]), machine_channel(&by_piston, of[1])};
    YkStudyOptions options = {&name, 1, channels, 2, 1, m.state};
    YkStudy *study = yk_study_new(by_piston.state, &options, m.problems);
    assert_non_null(study);
    const double *parameters[] = {modules}, *inputs[] = {at, NULL, NULL};
    YkStudyCase asked = {parameters, DESIGNS, inputs, POSES, false};
    fill_poses(at, 0.14, 0.0002);
    point_at(out, outputs);
    assert_int_equal(yk_study_run(study, &asked, outputs, status), YK_OK);
    for (size_t k = 0; k < DESIGNS * POSES; k++) {
        double X = at[k % POSES] - 30 * modules[k / POSES], theta = acos((X * X + r * r - l * l) / (2 * r * X));
        CHECK_NEAR(out[0][k], theta, 1e-10);
        CHECK_NEAR(out[1][k], -2 * (theta - YK_PI / 6), 1e-10);
    }
    yk_study_free(study);
    yk_state_free(by_piston.state);
    yk_mechanism_free(by_piston.mech);
    machine_free(&m);
}

static void test_a_drive_is_still_refused(void **unused)
{
    (void)unused;
    Machine m = machine_parse("parameters: {z: 20, w: z*1 rad/s}\n"
                              "bodies: {ground: {points: {O: [0, 0], P: [60 mm, 0]}}, a: {}, b: {}}\n"
                              "joints: {O: {pin: [ground, a], angle: q}, P: {pin: [ground, b]}}\n"
                              "gears: {g: {mesh: [a, b], teeth: [z, 40]}}\ndrives: {q: w*t}\n",
                              true);
    const char *name = "z";
    YkChannel channel = machine_channel(&m, "q");
    YkStudyOptions options = {&name, 1, &channel, 1, 1, NULL};
    assert_null(yk_study_new(m.state, &options, m.problems));
    assert_non_null(strstr(yk_problems_text(m.problems, 0), "enters the drive or start of `q`"));
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_numbers_of_teeth),
        cmocka_unit_test(test_a_module_moves_the_axes_as_well),
        cmocka_unit_test(test_laws_of_cams),
        cmocka_unit_test(test_constant_angles),
        cmocka_unit_test(test_threads_and_extents),
        cmocka_unit_test(test_values_that_make_no_machine_are_rows_with_a_status),
        cmocka_unit_test(test_sensitivities),
        cmocka_unit_test(test_sensitivities_at_a_change_point),
        cmocka_unit_test(test_groups_are_assembled_near_the_files_configuration),
        cmocka_unit_test(test_designs_start_at_the_inputs_of_the_start),
        cmocka_unit_test(test_a_drive_is_still_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
