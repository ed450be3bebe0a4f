// Derivatives of the misses of a machine task: against complex steps and motions beside it, and what they cost.
#include "synthesis/machines/machine_fit.h"
#include <complex.h>
#include <stdio.h>
#include <stdlib.h>
#include "batch/batch.h"
#include "batch/pose_forces.h"
#include "program/program.h"
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

// The height of the point of Hoeken's linkage: the isosceles triangle over the crank's pin and the rocker's pivot,
// twice.
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

// A task whose machine is thirty.yaml, with its first `count` parameters free.
static Fit fit_of_thirty(size_t count, const char *goals)
{
    static const char *const name[30] = {"a",  "b",  "c",  "g",  "tilt", "px", "py", "m",    "J",  "m2",
                                         "J2", "x2", "y2", "m1", "J1",   "x1", "y1", "k",    "l0", "sx",
                                         "sy", "qx", "qy", "k2", "l2",   "tx", "ty", "damp", "fx", "fy"};
    char text[6000];
    int length =
        snprintf(text, sizeof text, "synthesis: machine\nmachine: %s/tests/synthesis/thirty.yaml\nfree: {", YOKE_ROOT);
    for (size_t k = 0; k < count; k++)
        length +=
            snprintf(text + length, sizeof text - (size_t)length, "%s%s: [-500, 500]", k > 0 ? ", " : "", name[k]);
    snprintf(text + length, sizeof text - (size_t)length, "}\n%s", goals);
    YkProblems *problems = yk_problems_new();
    Fit f = {.task = yk_task_parse(text, strlen(text), "test.yaml", problems), .arena = yk_arena_new()};
    if (!f.task) print_error("%s\n%s", text, yk_problems_text(problems, 0));
    assert_true(f.task && f.arena && yk_machine_fit_new(f.task, f.arena, &f.fit, problems));
    f.fit.weight = 100;
    for (size_t j = 0; j < count; j++) f.at.value[j] = yk_model_parameter(f.task->machine.model, name[j]);
    yk_problems_free(problems);
    return f;
}

#define ALL_KINDS                                                                                                      \
    "over: {input: theta, range: [0 deg, 360 deg], steps: 24}\n"                                                       \
    "goals: [{value: theta.effort, equals: 5}, {point: rod.P, through: [[0.1, 0.5], [0.3, 0.7]]}]\n"                   \
    "require: ['max(A.force) < 10 N', 'min(B.transmission) > 85 deg', 'max(abs(psi.accel)) < 1', 'max(rod.P.speed) < " \
    "1']\n"

static void forces_and_rates_have_the_slopes_of_motions(void **state)
{
    (void)state;
    Fit f = fit_of_thirty(30, ALL_KINDS);
    compare_with_motions(&f, 1e-7);
    assert_int_equal(f.fit.differenced, 0);
    fit_free(&f);
}

// Returns the operations of a pose with its rates and accelerations.
static size_t operations_of(const YkMechanism *mech)
{
    YkProgram p = {0};
    YkArena *arena = yk_arena_new();
    assert_true(arena && yk_program_start(&p, mech, NULL, arena, NULL));
    const char **names = YK_NEW(arena, const char *, mech->coordinate_count + mech->slot_count + mech->block_count + 1);
    for (size_t k = 0; k < mech->coordinate_count + mech->slot_count + mech->block_count; k++)
        names[k] = yk_graph_text(&p.graph, "n%d", (int)k);
    p.names.coordinate = p.names.near_coordinate = names;
    p.names.near_slot = names + mech->coordinate_count;
    p.names.block = names + mech->coordinate_count + mech->slot_count;
    for (size_t k = 0; k < p.model->parameter_count; k++) p.is_fixed[k] = true;
    p.names.parameter = names;
    yk_program_constants(&p);
    yk_program_pose(&p);
    YkRates v = yk_program_velocities(&p, (YkRef[]){p.input[0].velocity}),
            a = yk_program_accelerations(&p, &v, (YkRef[]){p.input[0].acceleration});
    YkRef roots[64];
    size_t count = 0;
    for (size_t k = 1; k < mech->slot_count; k++) {
        const YkRef own[] = {p.unit[k].x, p.unit[k].y, v.turn[k], a.turn[k]};
        for (size_t i = 0; i < 4; i++) roots[count++] = own[i];
    }
    size_t cost = yk_graph_cost(&p.graph, roots, count);
    yk_program_end(&p);
    yk_arena_free(arena);
    return cost;
}

// Returns what one gradient takes, in motions with forces: its poses, placed and linearised, and the operations of its
// runs backwards over those of a pose.
static double cost_of(Fit f)
{
    assert_true(yk_machine_measure(&f.fit, f.fit.miss, &f.at));
    size_t before = f.fit.poses;
    assert_true(yk_machine_differentiate(&f.fit, &f.at));
    double poses = (double)(f.fit.poses - before);
    const YkPoseForces *plain = yk_batch_forces(f.fit.batch);
    if (f.fit.backwards > 0) {
        double pose =
            (double)(operations_of(yk_variant_mechanism(f.fit.variant)) + yk_lane_forces_length(plain->lanes));
        poses += (double)f.fit.backwards * (double)yk_lane_forces_length(f.fit.forces) / pose;
    }
    poses /= (double)f.fit.rows;
    fit_free(&f);
    return poses;
}

static double cost(const char *machine, const char *goals)
{
    return cost_of(fit_of(machine, goals));
}

static void a_gradient_costs_the_same_whatever_the_number_of_parameters(void **state)
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

// At most five motions, with a goal of forces at every row, for 3 parameters as for 30.
static void a_gradient_of_forces_costs_at_most_five_motions(void **state)
{
    (void)state;
    static const char effort[] = "over: {input: theta, range: [0 deg, 360 deg], steps: 72}\n"
                                 "goals: [{value: theta.effort, equals: 5}]\n";
    assert_true(cost_of(fit_of_thirty(3, effort)) <= 5);
    assert_true(cost_of(fit_of_thirty(30, effort)) <= 5);
    assert_true(cost_of(fit_of_thirty(3, ALL_KINDS)) <= 5);
    assert_true(cost_of(fit_of_thirty(30, ALL_KINDS)) <= 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(misses_have_the_slopes_of_a_complex_step),
        cmocka_unit_test(points_and_claims_have_the_slopes_of_motions),
        cmocka_unit_test(forces_and_rates_have_the_slopes_of_motions),
        cmocka_unit_test(a_gradient_costs_the_same_whatever_the_number_of_parameters),
        cmocka_unit_test(a_gradient_of_forces_costs_at_most_five_motions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
