// Studies: closed forms, the same bits on any number of threads, a status for every design, extents.
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
    size_t good = 0, bad = 0;
    for (size_t k = 0; k < DESIGNS * POSES; k++) {
        double angle;
        YkVec P;
        size_t d = k / POSES;
        bool closes = four_bar(a[d], b[d], c[d], theta[k], &angle, &P);
        assert_int_equal(status[k], d == 3 ? YK_BAD_MODEL : closes ? YK_OK : YK_LIMIT);
        if (!closes) assert_true(out[0][k] == 0 && out[1][k] == 0 && out[2][k] == 0);
        if (closes) CHECK_NEAR(out[1][k], P.x, 1e-10);
        *(closes ? &good : &bad) += 1;
    }
    assert_true(good > 1000 && bad > 1000);
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
        assert_int_equal(worst[d], stand == POSES ? YK_OK : YK_LIMIT);
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_pose_with_its_own_lengths_is_the_closed_form),
        cmocka_unit_test(test_designs_that_do_not_close_have_a_status_and_no_nan),
        cmocka_unit_test(test_any_number_of_threads_gives_the_same_bits),
        cmocka_unit_test(test_extents_are_those_of_the_poses),
        cmocka_unit_test(test_forces_follow_masses_and_lengths),
        cmocka_unit_test(test_a_machine_with_a_group_is_assembled_for_every_design),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
