// Angles after very many turns: against whole-number arithmetic, against digits of pi, and against themselves.
#include <math.h>
#include <string.h>
#include <yoke/yoke.h>
#include "check.h"
#include "base/mix.h"
#include "base/vec.h"
#include "model/model.h"

// A pendulum with one drive.
static YkModel *driven(const char *drive, const char *parameters)
{
    char text[512];
    snprintf(text, sizeof text,
             "parameters: {%s}\nbodies: {ground: {points: {O: [0, 0]}}, arm: {points: {O: [0, 0]}}}\n"
             "joints: {O: {pin: [ground, arm], angle: q}}\ndrives: {q: %s}\n",
             parameters, drive);
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "test.yaml", NULL, problems);
    if (!model) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(model);
    yk_problems_free(problems);
    return model;
}

static double off(double a, double b)
{
    return fabs(remainder(a - b, 2 * YK_PI));
}

static double phase_of(const char *drive, double t)
{
    YkModel *model = driven(drive, "w: 60 rpm");
    double phase = NAN;
    assert_true(yk_model_drive_phase(model, 0, t, &phase));
    assert_true(fabs(phase) <= YK_PI);
    yk_model_free(model);
    return phase;
}

// After whole seconds at whole turns a second it stands where it began.
static void whole_turns_are_nothing(void **unused)
{
    (void)unused;
    const double times[] = {1e6, 1e12, 1e15, 123456789012345678., 1e90, -1e15};
    for (size_t k = 0; k < sizeof times / sizeof *times; k++) {
        CHECK_NEAR(phase_of("30 deg + w*t", times[k]), YK_PI / 6, 1e-15);
        CHECK_NEAR(phase_of("3000 rpm * t - pi/2", times[k]), -YK_PI / 2, 1e-15);
        assert_true(off(phase_of("90 deg/s * (t + 2 s)", 4 * times[k]), YK_PI) < 1e-15);
    }
}

// A third of a turn a second: by the remainder of whole numbers.
static void parts_of_turns_follow_whole_numbers(void **unused)
{
    (void)unused;
    uint64_t seed = 11;
    for (int k = 0; k < 1000; k++) {
        int64_t t = (int64_t)(yk_mix_unit(&seed) * 9e15), quarters = k % 4;
        double expected = 2 * YK_PI * ((double)(t % 3) / 3 + (double)quarters / 12);
        assert_true(off(phase_of("20 rpm * t", (double)t), 2 * YK_PI * (double)(t % 3) / 3) < 4e-15);
        if (t > INT64_C(1) << 50) continue; // so that a quarter of a second is kept
        assert_true(off(phase_of("20 rpm * t", (double)t + (double)quarters / 4), expected) < 4e-15);
    }
}

// pi/3 + 2 t less its turns, from 120 digits of pi.
static void radians_follow_the_digits_of_pi(void **unused)
{
    (void)unused;
    CHECK_NEAR(phase_of("60 deg + 2 rad/s * t", 1e12), -0.26805196707697519, 1e-15);
    CHECK_NEAR(phase_of("60 deg + 2 rad/s * t", 1e15), -1.0165915218427635, 1e-15);
}

// Where a double still holds the angle, both ways meet; and a phase after two times is the sum of both.
static void phases_add_up(void **unused)
{
    (void)unused;
    uint64_t seed = 5;
    for (int k = 0; k < 1000; k++) {
        double a = rint(yk_mix_unit(&seed) * 1e12), b = rint(yk_mix_unit(&seed) * 1e12), c = yk_mix_unit(&seed);
        const char *drive = k % 2 ? "0.3 rad/s * t" : "7/13 deg/s * t";
        double rate = k % 2 ? 0.3 : 7 * YK_PI / 180 / 13;
        assert_true(off(phase_of(drive, a + b), phase_of(drive, a) + phase_of(drive, b)) < 3e-15);
        assert_true(off(phase_of(drive, c), rate * c) < 1e-15);
    }
}

// Forty parameters, each the sum of the one before and itself: 2^40 numbers stand in the last. It is given up, not
// counted out.
static void parameters_that_double_are_given_up(void **unused)
{
    (void)unused;
    char parameters[1024];
    int at = snprintf(parameters, sizeof parameters, "p0: 1");
    for (int k = 1; k < 40; k++)
        at += snprintf(parameters + at, sizeof parameters - (size_t)at, ", p%d: p%d + p%d", k, k - 1, k - 1);
    char text[1500];
    snprintf(text, sizeof text,
             "parameters: {%s}\nbodies: {ground: {points: {O: [0, 0]}}, arm: {points: {O: [0, 0]}}}\n"
             "joints: {O: {pin: [ground, arm], angle: q}}\ndrives: {q: p39/p39 * t * 1 rad/s}\n",
             parameters);
    YkModel *model = yk_model_parse(text, strlen(text), "test.yaml", NULL, NULL);
    assert_non_null(model);
    double phase;
    assert_false(yk_model_drive_phase(model, 0, 1e3, &phase));
    yk_model_free(model);
}

static void other_drives_have_none(void **unused)
{
    (void)unused;
    const char *const drives[] = {"sin(1e9 rad/s * t)", "1 rad/s^2 * t^2", "w*t*sqrt(2)", "1e17 rad/s * t"};
    for (size_t k = 0; k < sizeof drives / sizeof *drives; k++) {
        YkModel *model = driven(drives[k], "w: 60 rpm");
        double phase;
        assert_false(yk_model_drive_phase(model, 0, 1e3, &phase));
        yk_model_free(model);
    }
}

// The sine of a large argument, by the phase of that argument: the rounding that is told is not less than what there
// is, and not a thousand times more.
static void rounding_is_told_as_it_is(void **unused)
{
    (void)unused;
    uint64_t seed = 3;
    double worst = 0;
    YkModel *sine = driven("sin(0.7 rad/s * t)", "w: 60 rpm");
    for (int k = 0; k < 1000; k++) {
        double t = ldexp(1 + yk_mix_unit(&seed), k % 50), truth = sin(phase_of("0.7 rad/s * t", t));
        YkJet jet;
        assert_int_equal(yk_model_drive(sine, 0, t, &jet, NULL), YK_OK);
        double told = yk_model_drive_rounding(sine, 0, t), is = fabs(jet.d[0] - truth);
        assert_true(is <= told + 4e-16);
        if (told < 0.1) worst = fmax(worst, is / told);
    }
    assert_true(worst > 0.01);
    yk_model_free(sine);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole_turns_are_nothing),
        cmocka_unit_test(parts_of_turns_follow_whole_numbers),
        cmocka_unit_test(radians_follow_the_digits_of_pi),
        cmocka_unit_test(phases_add_up),
        cmocka_unit_test(parameters_that_double_are_given_up),
        cmocka_unit_test(other_drives_have_none),
        cmocka_unit_test(rounding_is_told_as_it_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
