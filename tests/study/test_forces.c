// Forces in studies and batches of variants, against the dynamics of the same machine made anew: time, friction that
// varies, forces without a value, values set later.
#include "study_check.h"
#include "parallelogram.h"

enum { POSES = 60, DESIGNS = 3 };
static double out[4][DESIGNS * POSES];
static signed char status[DESIGNS * POSES];

#define CRANK                                                                                                          \
    "parameters: {r: 100 mm, m: 2 kg, c: 2, mu: 0}\n"                                                                  \
    "bodies:\n"                                                                                                        \
    "  ground: {points: {O: [0, 0]}}\n"                                                                                \
    "  crank: {points: {O: [0, 0], A: [r, 0]}, mass: 1 kg, inertia: 0.01 kg*m^2}\n"                                    \
    "  rod: {points: {A: [0, 0], B: [300 mm, 0]}, mass: m, center: [100 mm, 0], inertia: 0.02 kg*m^2}\n"               \
    "  piston: {points: {B: [0, 0]}, mass: m}\n"                                                                       \
    "joints:\n"                                                                                                        \
    "  O: {pin: [ground, crank], angle: theta}\n"                                                                      \
    "  A: {pin: [crank, rod], angle: phi}\n"                                                                           \
    "  B: {pin: [rod, piston]}\n"                                                                                      \
    "  S: {slide: [ground, piston], along: x, distance: x, friction: {coulomb: mu}}\n"                                 \
    "efforts: {x: c * 5 N * cos(3 * t / (1 s))}\n"                                                                     \
    "gravity: [0, -9.81 m/s^2]\n"                                                                                      \
    "drives: {theta: 40 deg + 3 rad/s * t}\nstart: {phi: -55 deg, x: 350 mm}\n"

static const char *const of[] = {"theta.effort", "A.force", "x.effort", "t"};
static const char *file = CRANK, *const *columns = of;

// Asks the dynamics of the file loaded with a value, at a pose and time.
static void ask_alone(const char *name, double value, double theta, double time, double *values)
{
    char text[40];
    snprintf(text, sizeof text, "%.17g", value);
    const YkOverride overrides[] = {{name, text}};
    Machine m = machine_parse_with(file, overrides, 1);
    YkDynamics *d = yk_dynamics_new(m.mech, m.problems);
    assert_true(yk_state_assemble(m.state) >= 0);
    assert_true(yk_state_set_time(m.state, time, m.problems) >= 0);
    yk_state_set_input(m.state, 0, (YkMotion){theta, 3, 0});
    assert_true(yk_dynamics_solve(d, m.state, YK_METHOD_NEWTON_EULER) >= 0);
    for (size_t c = 0; c < 4; c++) values[c] = yk_dynamics_channel(d, m.state, machine_channel(&m, columns[c]));
    yk_dynamics_free(d);
    machine_free(&m);
}

static void check_study(const char *name, const double *values, const double *times, double own_time)
{
    double theta[POSES], due[4], *outputs[4];
    Machine m = machine_parse(file, true);
    assert_true(yk_state_set_time(m.state, own_time, m.problems) >= 0);
    YkStudy *study = study_of(&m, &name, 1, columns, 4, 1);
    const double *parameters[] = {values}, *inputs[] = {theta, NULL, NULL};
    YkStudyCase asked = {parameters, DESIGNS, inputs, POSES, false, times};
    for (size_t c = 0; c < 4; c++) outputs[c] = out[c];
    for (size_t k = 0; k < POSES; k++) theta[k] = 0.7 + 0.1 * (double)k;
    assert_int_equal(yk_study_run(study, &asked, outputs, status), YK_OK);
    for (size_t k = 0; k < DESIGNS * POSES; k += 7) {
        size_t pose = k % POSES;
        ask_alone(name, values[k / POSES], theta[pose], times ? times[pose] : own_time, due);
        for (size_t c = 0; c < 4; c++) CHECK_NEAR(out[c][k], due[c], 1e-10 * (1 + fabs(due[c])));
    }
    yk_study_free(study);
    machine_free(&m);
}

static void test_loads_that_depend_on_time(void **unused)
{
    (void)unused;
    static const double c[] = {1, 2, 3};
    double times[POSES];
    for (size_t k = 0; k < POSES; k++) times[k] = 0.05 * (double)k;
    check_study("c", c, NULL, 0);
    check_study("c", c, NULL, 0.3);
    check_study("c", c, times, 0.3);
}

#define CAM(f, cam, follower, joint)                                                                                   \
    "parameters: {f: " f " mm, h: 10 mm, al: 1.4}\n"                                                                   \
    "laws: {l: {period: 2*pi, segments: [{rise: {to: 3 rad, by: " cam ", law: 3-4-5}}, {fall: {to: 2*pi, by: " cam     \
    ", law: cycloidal}}]}}\n"                                                                                          \
    "cams: {rc: {cam: shaft, follower: f, law: l, base: 40 mm, " follower "}}\n"                                       \
    "bodies:\n  ground: {points: {O: [0, 0], Q: [f, h]}}\n"                                                            \
    "  shaft: {points: {O: [1 mm, 2 mm]}, mass: 1 kg, inertia: 5e-4 kg*m^2}\n"                                         \
    "  f: {points: {Q: [0, 0]}, mass: 0.6 kg, center: [30 mm, 10 mm], inertia: 7e-4 kg*m^2}\n"                         \
    "joints:\n  O: {pin: [ground, shaft], angle: theta}\n  Q: {" joint "}\n"                                           \
    "gravity: [0, -9.81 m/s^2]\ndrives: {theta: 40 deg + 3 rad/s * t}\n"

// Where the cam touches its follower depends on the pins between them, and on the follower's guide.
static void test_places_of_cams_vary(void **unused)
{
    (void)unused;
    static const char *const texts[] = {
        CAM("95", "0.3 rad", "roller: 9 mm, arm: 80 mm", "pin: [ground, f], angle: phi"),
        CAM("95", "0.3 rad", "face: flat, offset: 3 mm", "pin: [f, ground], angle: phi"),
        CAM("12", "20 mm", "roller: 9 mm", "slide: [ground, f], along: al, from: Q, to: Q, distance: s"),
        CAM("12", "20 mm", "face: flat", "slide: [ground, f], along: al, from: O, to: Q, distance: s")};
    static const char *const cam[] = {"theta.effort", "rc.force.x", "O.force.y", "t"};
    static const double values[2][DESIGNS] = {{0.09, 0.1, 0.11}, {-0.5, 0.2, 1}},
                        little[DESIGNS] = {0.002, 0.012, 0.02};
    for (size_t k = 0; k < 4; k++) {
        file = texts[k];
        columns = cam;
        if (k < 2) check_study("f", values[0], NULL, 0);
        if (k == 2) check_study("f", little, NULL, 0);
        if (k > 1) check_study("al", values[1], NULL, 0);
        if (k != 2) check_study("h", little, NULL, 0);
    }
    file = CRANK;
    columns = of;
}

static void test_friction_that_is_none_in_the_file(void **unused)
{
    (void)unused;
    static const double mu[] = {0, 0.1, 0.2};
    check_study("mu", mu, NULL, 0.2);
}

// Where a load has no value a pose has none, and angles go on being counted.
static void test_turns_are_counted_past_forces_without_a_value(void **unused)
{
    (void)unused;
    enum { MANY = 541 };
    static double theta[MANY], angle[MANY], effort[MANY];
    static signed char how[MANY];
    Machine m = machine_parse("parameters: {k: 1}\n"
                              "bodies:\n"
                              "  ground: {points: {O2: [0, 0], O4: [1, 0]}}\n"
                              "  input: {points: {O2: [0, 0], A: [2, 0]}, mass: 1 kg, inertia: 1 kg*m^2}\n"
                              "  coupler: {points: {A: [0, 0], B: [1.8, 0]}}\n"
                              "  output: {points: {O4: [0, 0], B: [2.4, 0]}, mass: k * 1 kg, inertia: 1 kg*m^2}\n"
                              "joints:\n"
                              "  O2: {pin: [ground, input], angle: theta2}\n"
                              "  A: {pin: [input, coupler], angle: theta3}\n"
                              "  O4: {pin: [ground, output], angle: theta4}\n"
                              "  B: {pin: [coupler, output]}\n"
                              "efforts: {theta4: 1 N*m * sqrt((theta2 - 280 deg) * (theta2 - 283 deg))}\n"
                              "drives: {theta2: 90 deg + 1 rad/s * t}\nstart: {theta3: -80 deg, theta4: 60 deg}\n",
                              true);
    static const char *const asked_of[] = {"theta4", "theta2.effort"};
    YkStudy *study = study_of(&m, NULL, 0, asked_of, 2, 1);
    double *outputs[] = {angle, effort};
    const double *inputs[] = {theta, NULL, NULL};
    YkStudyCase asked = {NULL, 1, inputs, MANY, false, NULL};
    for (size_t k = 0; k < MANY; k++) theta[k] = YK_PI / 180 * (90 + 2 * (double)k);
    yk_study_run(study, &asked, outputs, how);
    for (size_t k = 1; k < MANY; k++) {
        bool has_value = !(theta[k] > 280 * YK_PI / 180 && theta[k] < 283 * YK_PI / 180);
        assert_int_equal(how[k] == YK_OK, has_value);
        if (how[k] == YK_OK && how[k - 1] == YK_OK) assert_true(fabs(angle[k] - angle[k - 1]) < 0.5);
    }
    CHECK_NEAR(angle[MANY - 1] - angle[0], 6 * YK_PI, 1e-9);
    yk_study_free(study);
    machine_free(&m);
}

// At a change point the rates are limits, but the forces have no value, and do not count: theta2.effort stays as large
// as beside it, where the machine's weight asks for it.
static void test_forces_do_not_count_at_change_points(void **unused)
{
    (void)unused;
    static const char *const name = "r", *const asked_for[] = {"theta2.effort", "theta4.rate"};
    Machine m =
        machine_parse("parameters: {r: 2 m}\n"
                      "bodies:\n"
                      "  ground: {points: {O2: [0, 0], O4: [4, 0]}}\n"
                      "  crank: {points: {O2: [0, 0], A: [r, 0]}, mass: 1, center: [1, 0]}\n"
                      "  coupler: {points: {A: [0, 0], B: [4, 0]}, mass: 2, center: [2, 0]}\n"
                      "  rocker: {points: {O4: [0, 0], B: [r, 0]}, mass: 1, center: [1, 0]}\n" PARALLELOGRAM_JOINTS
                      "gravity: [0, -10]\n"
                      "drives: {theta2: 2.5 + 0.2/(1 s) * t}\nstart: {theta3: -2.5, theta4: 2.5}\n",
                      true);
    enum { AT = 4, ALL = 9 };
    double theta[ALL], rate[ALL], r = 2;
    for (int k = 0; k < ALL; k++) theta[k] = YK_PI + 0.1 * (k - AT), rate[k] = 0.2;
    YkStudy *study = study_of(&m, &name, 1, asked_for, 2, 1);
    const double *parameters[] = {&r}, *inputs[] = {theta, rate, NULL};
    YkStudyCase asked = {parameters, 1, inputs, ALL, false, NULL};
    YkExtent extents[2];
    size_t standing;
    assert_true(yk_study_reduce(study, &asked, extents, status, &standing) >= 0);
    assert_int_equal(standing, ALL);
    // Weights at the cranks' middles and on the coupler: (1/2 + 2 + 1/2) m g r cos(theta2); the cranks turn evenly.
    CHECK_NEAR(extents[0].largest, 60 * yk_cos(theta[0]), 1e-6);
    CHECK_NEAR(extents[0].least, 60 * yk_cos(theta[AT - 1]), 1e-6);
    CHECK_NEAR(extents[1].least, 0.2, 1e-9);
    CHECK_NEAR(extents[1].largest, 0.2, 1e-9);
    yk_study_free(study);
    machine_free(&m);
}

// A batch of a variant's mechanism follows every change, its forces too.
static void test_batches_of_variants_follow(void **unused)
{
    (void)unused;
    static const char *const names[] = {"r", "m"};
    static const double designs[][2] = {{0.1, 2}, {0.12, 3}, {0.08, 1}};
    Machine m = machine_parse(CRANK, true);
    YkVariant *v = yk_variant_new(m.mech, names, 2, m.problems);
    YkState *state = yk_state_new(yk_variant_mechanism(v));
    assert_true(yk_state_assemble(state) >= 0);
    YkChannel channels[] = {machine_channel(&m, "theta.effort"), machine_channel(&m, "A.force")};
    YkBatch *batch = yk_batch_new(state, channels, 2);
    for (size_t k = 0; k < 3; k++) {
        double theta = 1, rate = 3, accel = 0.5, found[2], *outputs[] = {&found[0], &found[1]};
        const double *inputs[] = {&theta, &rate, &accel};
        assert_int_equal(yk_variant_set(v, designs[k]), YK_OK);
        assert_int_equal(yk_batch_run(batch, inputs, outputs, NULL, 1), YK_OK);
        YkDynamics *d = yk_dynamics_new(yk_variant_mechanism(v), m.problems);
        yk_state_set_input(state, 0, (YkMotion){theta, rate, accel});
        assert_true(yk_dynamics_solve(d, state, YK_METHOD_NEWTON_EULER) >= 0);
        for (size_t c = 0; c < 2; c++) CHECK_NEAR(found[c], yk_dynamics_channel(d, state, channels[c]), 1e-10);
        yk_dynamics_free(d);
    }
    yk_batch_free(batch);
    yk_state_free(state);
    yk_variant_free(v);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_loads_that_depend_on_time),
        cmocka_unit_test(test_places_of_cams_vary),
        cmocka_unit_test(test_friction_that_is_none_in_the_file),
        cmocka_unit_test(test_turns_are_counted_past_forces_without_a_value),
        cmocka_unit_test(test_forces_do_not_count_at_change_points),
        cmocka_unit_test(test_batches_of_variants_follow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
