// Derivatives of the misses of a machine task: against complex steps and motions beside it, and what they cost.
#include "synthesis/machines/machine_fit.h"
#include <complex.h>
#include "synthesis/answer.h"

typedef struct Fit {
    YkTask *task;
    YkArena *arena;
    YkMachineFit fit;
    YkMachineTry at;
} Fit;

static Fit fit_of(const char *machine, const char *goals)
{
    char text[2000];
    snprintf(text, sizeof text, "synthesis: machine\nmachine: %s/examples/%s.yaml\n%s", YOKE_ROOT, machine, goals);
    YkProblems *problems = yk_problems_new();
    Fit f = {.task = yk_task_parse(text, strlen(text), "test.yaml", problems), .arena = yk_arena_new()};
    if (!f.task) print_error("%s\n%s", text, yk_problems_text(problems, 0));
    assert_true(f.task && f.arena && yk_machine_fit_new(f.task, f.arena, &f.fit, problems));
    f.fit.weight = 100;
    for (size_t j = 0; j < f.task->machine.free_count; j++)
        f.at.value[j] = yk_model_parameter(f.task->machine.model, f.task->machine.name[j]);
    yk_problems_free(problems);
    return f;
}

static void fit_free(Fit *f)
{
    yk_machine_fit_free(&f->fit);
    yk_arena_free(f->arena);
    yk_task_free(f->task);
}

static void differentiate(Fit *f)
{
    assert_true(yk_machine_measure(&f->fit, f->fit.miss, &f->at));
    assert_true(yk_machine_differentiate(&f->fit, &f->at));
}

// Every derivative is that of two motions beside the machine, extrapolated.
static void compare_with_motions(Fit *f, double tolerance)
{
    size_t n = f->task->machine.free_count, misses = f->fit.misses;
    double *miss[4], largest = 0;
    for (int k = 0; k < 4; k++) assert_non_null(miss[k] = calloc(misses, sizeof(double)));
    differentiate(f);
    for (size_t k = 0; k < misses * n; k++) largest = fmax(largest, fabs(f->fit.row[k]));
    assert_true(largest > 0);
    for (size_t j = 0; j < n; j++) {
        static const double way[4] = {-1, 1, -2, 2};
        double h = 1e-5 * fabs(f->at.value[j]);
        for (int k = 0; k < 4; k++) {
            YkMachineTry beside = f->at;
            beside.value[j] += way[k] * h;
            assert_true(yk_machine_measure(&f->fit, miss[k], &beside));
        }
        for (size_t r = 0; r < misses; r++) {
            double by = (8 * (miss[1][r] - miss[0][r]) - (miss[3][r] - miss[2][r])) / (12 * h);
            CHECK_NEAR(f->fit.row[r * n + j], by, tolerance * largest);
        }
    }
    for (int k = 0; k < 4; k++) free(miss[k]);
}

// The height of the point of Hoeken's linkage: the isosceles triangle over the crank's pin and the rocker's pivot, twice.
static double complex height(double complex ground, double complex arm, double theta)
{
    double complex dx = ground - cos(theta), dy = -sin(theta), dd = dx * dx + dy * dy;
    return sin(theta) + dy + 2 * dx * csqrt(arm * arm / dd - 0.25);
}

static void misses_have_the_slopes_of_a_complex_step(void **state)
{
    (void)state;
    Fit f = fit_of("hoeken", "free: {l1: [1.5, 3.5], l3: [2, 5]}\n"
                             "over: {input: theta, range: [90 deg, 270 deg], steps: 40}\n"
                             "goals: [{value: coupler.P.y, equals: 5, weight: 4}]\n");
    f.at.value[0] = 2.6;
    f.at.value[1] = 3.1;
    differentiate(&f);
    for (size_t r = 0; r < f.fit.rows; r++) {
        double theta = YK_PI / 2 + YK_PI * (double)r / 40;
        CHECK_NEAR(f.fit.miss[r], 2 * (creal(height(2.6, 3.1, theta)) - 5), 1e-13);
        CHECK_NEAR(f.fit.row[2 * r], 2e30 * cimag(height(2.6 + 1e-30 * I, 3.1, theta)), 1e-12);
        CHECK_NEAR(f.fit.row[2 * r + 1], 2e30 * cimag(height(2.6, 3.1 + 1e-30 * I, theta)), 1e-12);
    }
    fit_free(&f);
}

#define STRIDE                                                                                                         \
    "over: {input: theta, range: [0 deg, 360 deg], steps: 90}\n"                                                       \
    "goals: [{point: leg.foot, through: [[-65 mm, -90 mm], [-45 mm, -91 mm], [-25 mm, -90 mm], [-34 mm, -70 mm]]}]\n"

static void points_and_claims_have_the_slopes_of_motions(void **state)
{
    (void)state;
    Fit f = fit_of("jansen", "free: {b: [35, 48], e: [50, 60], g: [32, 42], m: [12, 18]}\n" STRIDE
                             "require: ['min(N.transmission) > 80 deg', 'max(leg.foot.y) < -80 mm']\n"
                             "units: {length: mm}\n");
    compare_with_motions(&f, 1e-7);
    fit_free(&f);
    f = fit_of("hoeken", "free: {l1: [1.5, 3.5], l3: [2, 5]}\n"
                         "over: {input: theta, range: [90 deg, 270 deg], steps: 30}\n"
                         "goals: [{least: max(abs(coupler.angle.rate))}, {value: coupler.P.x.rate, equals: 1},\n"
                         "        {value: coupler.angle, equals: 0, where: [100 deg, 120 deg]}]\n"
                         "require: ['max(abs(coupler.P.y)) < 1']\n");
    compare_with_motions(&f, 1e-6);
    fit_free(&f);
}

// Returns the poses that one gradient takes, over those of a motion.
static double cost(const char *machine, const char *goals)
{
    Fit f = fit_of(machine, goals);
    assert_true(yk_machine_measure(&f.fit, f.fit.miss, &f.at));
    size_t before = f.fit.poses;
    assert_true(yk_machine_differentiate(&f.fit, &f.at));
    double poses = (double)(f.fit.poses - before) / (double)f.fit.rows;
    fit_free(&f);
    return poses;
}

static void a_gradient_costs_two_motions_whatever_the_number_of_parameters(void **state)
{
    (void)state;
    double one = cost("jansen", "free: {b: [35, 48]}\n" STRIDE "units: {length: mm}\n");
    double all = cost("jansen", "free: {b: [35, 48], c: [34, 45], d: [36, 44], e: [50, 60], f: [34, 45], g: [32, 42],\n"
                                "       h: [60, 70], i: [45, 53], j: [45, 55], k: [57, 66], m: [12, 18]}\n" STRIDE
                                "units: {length: mm}\n");
    assert_true(one == all);
    assert_true(all <= 1);
    one =
        cost("hoeken", "free: {l1: [1.5, 3.5], l3: [2, 5]}\nover: {input: theta, range: [0 deg, 360 deg], steps: 200}\n"
                       "goals: [{value: coupler.P.y, equals: 5}]\nrequire: ['min(B.transmission) > 80 deg']\n");
    assert_true(one <= 2.03);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(misses_have_the_slopes_of_a_complex_step),
        cmocka_unit_test(points_and_claims_have_the_slopes_of_motions),
        cmocka_unit_test(a_gradient_costs_two_motions_whatever_the_number_of_parameters),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
