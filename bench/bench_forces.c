// Forces: input torque and all reactions of the quick-return with masses, in batches and one pose a call, against
// Newton and Euler by hand; a study of a million slider-cranks.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "machine.h"
#include "reference/common/bench.h"
#include "reference/forces.h"

enum { CHUNK = 1024, CHUNKS = 100, ROUNDS = 5, OUTS = QUICK_RETURN_FORCES };
static const double RATE = -0.5, ACCEL = 0.1;

// Rows are apart by no multiple of 4096 bytes, which would compete for the same cache lines.
typedef struct Bench {
    Machine machine;
    YkBatch *batch;
    YkChannel channels[OUTS];
    double *theta, rate[CHUNK], accel[CHUNK], by_hand[OUTS][CHUNK + 8], ours[OUTS][CHUNK + 8];
} Bench;

static bool start(Bench *b)
{
    static const char *const names[OUTS] = {"O1.force.x", "O1.force.y", "O2.force.x", "O2.force.y", "S.force.x",
                                            "S.force.y",  "S.moment",   "A.force.x",  "A.force.y",  "B.force.x",
                                            "B.force.y",  "C.force.x",  "C.force.y",  "R.force.y",  "theta1.effort"};
    if (!machine_load(&b->machine, YOKE_ROOT "/bench/machines/quick-return-forces.yaml")) return false;
    for (size_t k = 0; k < OUTS; k++)
        if (yk_channel_parse(b->machine.mech, names[k], &b->channels[k], b->machine.problems) != YK_OK) return false;
    b->batch = yk_batch_new(b->machine.state, b->channels, OUTS);
    b->theta = malloc(CHUNK * CHUNKS * sizeof *b->theta);
    if (!b->batch || !b->theta) return false;
    for (size_t k = 0; k < CHUNK * CHUNKS; k++) b->theta[k] = 3.141592653589793 * (double)k / (CHUNK * CHUNKS - 1);
    for (size_t k = 0; k < CHUNK; k++) b->rate[k] = RATE, b->accel[k] = ACCEL;
    yk_dynamics_prescribe(b->machine.dynamics, 0, true);
    return true;
}

static void by_hand(Bench *b, const double *theta)
{
    double *out[OUTS];
    for (size_t k = 0; k < OUTS; k++) out[k] = b->by_hand[k];
    quick_return_forces(theta, b->rate, b->accel, out, CHUNK);
}

static void by_batch(Bench *b, const double *theta)
{
    const double *inputs[] = {theta, b->rate, b->accel};
    double *out[OUTS];
    for (size_t k = 0; k < OUTS; k++) out[k] = b->ours[k];
    if (yk_batch_run(b->batch, inputs, out, NULL, CHUNK) != YK_OK) exit(1);
}

static void by_scalar(Bench *b, const double *theta)
{
    for (size_t i = 0; i < CHUNK; i++) {
        double one[OUTS];
        quick_return_forces_one(theta[i], RATE, ACCEL, one);
        for (size_t k = 0; k < OUTS; k++) b->by_hand[k][i] = one[k];
    }
}

static void by_dynamics(Bench *b, const double *theta)
{
    Machine *m = &b->machine;
    for (size_t i = 0; i < CHUNK; i++) {
        yk_state_set_input_to(m->state, 0, theta[i], RATE, ACCEL);
        if (yk_dynamics_solve(m->dynamics, m->state, YK_METHOD_REDUCED) != YK_OK) exit(1);
        for (size_t k = 0; k < OUTS; k++) b->ours[k][i] = yk_dynamics_channel(m->dynamics, m->state, b->channels[k]);
    }
}

static void one_by_one(Bench *b, const double *theta)
{
    for (size_t i = 0; i < CHUNK; i++) {
        const double *inputs[] = {theta + i, b->rate, b->accel};
        double *out[OUTS];
        for (size_t k = 0; k < OUTS; k++) out[k] = &b->ours[k][i];
        if (yk_batch_run(b->batch, inputs, out, NULL, 1) != YK_OK) exit(1);
    }
}

static double time_of(Bench *b, void (*run)(Bench *, const double *), size_t chunks)
{
    double from = bench_now();
    for (size_t c = 0; c < chunks; c++) run(b, b->theta + c * (CHUNKS / chunks) * CHUNK);
    return (bench_now() - from) * 1e9 / (double)(chunks * CHUNK);
}

// The largest difference over the poses, relative to the largest force.
static double difference(Bench *b)
{
    double most = 0, largest = 0;
    for (size_t c = 0; c < CHUNKS; c++) {
        by_hand(b, b->theta + c * CHUNK);
        by_batch(b, b->theta + c * CHUNK);
        for (size_t k = 0; k < OUTS; k++)
            for (size_t i = 0; i < CHUNK; i++) {
                most = fmax(most, fabs(b->ours[k][i] - b->by_hand[k][i]));
                largest = fmax(largest, fabs(b->by_hand[k][i]));
            }
    }
    return most / largest;
}

// --- a study -----------------------------------------------------------------------------------------

enum { DESIGNS = 1000000, POSES = 36, VARIED = 3 };

static double run_study(const Machine *m, size_t threads, double *const *values, const double *const *inputs,
                        YkExtent *extents)
{
    static const char *const names[VARIED] = {"r", "l", "m_piston"}, *const of[] = {"theta.effort", "A.force"};
    YkChannel channels[2];
    for (int c = 0; c < 2; c++) yk_channel_parse(m->mech, of[c], &channels[c], m->problems);
    YkStudyOptions options = {names, VARIED, channels, 2, threads, NULL};
    YkStudy *study = yk_study_new(m->state, &options, m->problems);
    YkStudyCase asked = {(const double *const *)values, DESIGNS, inputs, POSES, false};
    double from = bench_wall();
    if (!study || yk_study_reduce(study, &asked, extents, NULL, NULL) != YK_OK) exit(1);
    double seconds = bench_wall() - from;
    yk_study_free(study);
    return seconds;
}

// Peak torque and peak pin force of a slider-crank with gas force, on the clock of the wall, the best of three.
static bool compare_study(void)
{
    static const char *const names[VARIED] = {"r", "l", "m_piston"};
    static double theta[POSES], rate[POSES], accel[POSES];
    const double *inputs[] = {theta, rate, accel};
    double *values[VARIED], least[3] = {0, INFINITY, INFINITY};
    YkExtent *extents = malloc(2 * DESIGNS * sizeof *extents), *again = malloc(2 * DESIGNS * sizeof *extents);
    Machine m;
    if (!extents || !again || !machine_load(&m, YOKE_ROOT "/bench/machines/gas-slider-crank.yaml")) exit(1);
    for (size_t p = 0; p < VARIED; p++) {
        double own = yk_model_parameter(m.model, names[p]);
        YkDistribution d = {YK_DISTRIBUTION_UNIFORM, own * 0.9, own * 1.1, own, 0};
        values[p] = malloc(DESIGNS * sizeof *values[p]);
        if (!values[p]) exit(1);
        for (size_t k = 0; k < DESIGNS; k++) values[p][k] = yk_distribution_draw(&d, 1, k, p);
    }
    for (size_t k = 0; k < POSES; k++) theta[k] = 6.283185307179586 * (double)k / POSES, rate[k] = 300;
    for (int r = 0; r < 3; r++)
        for (size_t threads = 1; threads <= 2; threads++)
            least[threads] =
                fmin(least[threads], run_study(&m, threads, values, inputs, threads == 1 ? extents : again));
    bool same = memcmp(extents, again, 2 * DESIGNS * sizeof *extents) == 0, keeps = least[2] <= 3 && same;
    printf("row\tslider-crank with gas force, 1e6 designs of 36 poses, peak torque and pin force: two threads; against "
           "one\t%.3g s (one thread)\t%.3g s\t%.2f\t%s3 s\t%.0e\n",
           least[1], least[2], least[2] / least[1], keeps ? "" : "missed: ", same ? 0.0 : 1.0);
    for (size_t p = 0; p < VARIED; p++) free(values[p]);
    free(extents);
    free(again);
    machine_end(&m);
    return keeps;
}

int main(void)
{
    static Bench b;
    if (!start(&b)) return 1;
    double off = difference(&b), ns[5][ROUNDS];
    for (size_t r = 0; r < ROUNDS; r++) {
        ns[0][r] = time_of(&b, by_hand, CHUNKS);
        ns[1][r] = time_of(&b, by_batch, CHUNKS);
        ns[2][r] = time_of(&b, by_scalar, CHUNKS / 4);
        ns[3][r] = time_of(&b, by_dynamics, CHUNKS / 20);
        ns[4][r] = time_of(&b, one_by_one, CHUNKS / 4);
    }
    bool keeps = row("quick-return with masses: torque and all reactions, in batches, a pose", median(ns[0], ROUNDS),
                     median(ns[1], ROUNDS), "ns", 2, off);
    keeps &=
        row("the same, one pose a call of `yk_batch_run`", median(ns[2], ROUNDS), median(ns[4], ROUNDS), "ns", 2, off);
    row("the same by `yk_dynamics_solve`", median(ns[2], ROUNDS), median(ns[3], ROUNDS), "ns", 0, off);
    keeps &= compare_study();
    yk_batch_free(b.batch);
    free(b.theta);
    machine_end(&b.machine);
    return keeps ? 0 : 2;
}
