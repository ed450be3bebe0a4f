// Forces of larger machines - Watt's six-bar, Andrews' mechanism, a planetary gear, a cam with its spring -: torque and
// all reactions in batches, against Newton and Euler by hand.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "machine.h"
#include "reference/common/bench.h"
#include "reference/linkage_forces.h"
#include "reference/train_forces.h"

enum { CHUNK = 1024, CHUNKS = 40, ROUNDS = 5, MOST = 32 };

typedef struct Task {
    const char *name, *file, *channels[MOST];
    size_t count;
    double from, to, rate, accel, tolerance; // of the crank: its angles, rad
    void (*by_hand)(const double *, const double *, const double *, double *const *, size_t);
} Task;

// Rows are apart by no multiple of 4096 bytes, which would compete for the same cache lines.
typedef struct Bench {
    const Task *task;
    Machine machine;
    YkBatch *batch;
    double crank[CHUNK * CHUNKS], rate[CHUNK], accel[CHUNK], by_hand[MOST][CHUNK + 8], ours[MOST][CHUNK + 8];
} Bench;

static void start(Bench *b, const Task *task)
{
    char path[400];
    YkChannel channels[MOST];
    b->task = task;
    snprintf(path, sizeof path, "%s/%s", YOKE_ROOT, task->file);
    if (!machine_load(&b->machine, path)) exit(1);
    for (size_t k = 0; k < task->count; k++)
        if (yk_channel_parse(b->machine.mech, task->channels[k], &channels[k], b->machine.problems) != YK_OK) exit(1);
    b->batch = yk_batch_new(b->machine.state, channels, task->count);
    if (!b->batch) exit(1);
    for (size_t k = 0; k < CHUNK * CHUNKS; k++)
        b->crank[k] = task->from + (task->to - task->from) * (double)k / (CHUNK * CHUNKS - 1);
    for (size_t k = 0; k < CHUNK; k++) b->rate[k] = task->rate, b->accel[k] = task->accel;
}

static void by_hand(Bench *b, const double *crank)
{
    double *out[MOST];
    for (size_t k = 0; k < b->task->count; k++) out[k] = b->by_hand[k];
    b->task->by_hand(crank, b->rate, b->accel, out, CHUNK);
}

static void by_batch(Bench *b, const double *crank)
{
    const double *inputs[] = {crank, b->rate, b->accel};
    double *out[MOST];
    for (size_t k = 0; k < b->task->count; k++) out[k] = b->ours[k];
    if (yk_batch_run(b->batch, inputs, out, NULL, CHUNK) != YK_OK) exit(1);
}

static double time_of(Bench *b, void (*run)(Bench *, const double *))
{
    double from = bench_now();
    for (size_t c = 0; c < CHUNKS; c++) run(b, b->crank + c * CHUNK);
    return (bench_now() - from) * 1e9 / (CHUNKS * CHUNK);
}

// The largest difference of a channel over the poses, relative to the largest of its values.
static double difference(Bench *b)
{
    double worst = 0;
    for (size_t k = 0; k < b->task->count; k++) {
        double most = 0, largest = 0;
        for (size_t c = 0; c < CHUNKS; c++) {
            by_hand(b, b->crank + c * CHUNK);
            by_batch(b, b->crank + c * CHUNK);
            for (size_t i = 0; i < CHUNK; i++) {
                double off = fabs(b->ours[k][i] - b->by_hand[k][i]);
                most = off <= most ? most : off;
                largest = fmax(largest, fabs(b->by_hand[k][i]));
            }
        }
        if (largest == 0) largest = 1; // what cancels: newtons
        if (getenv("SHOW")) printf("%s %g %g\n", b->task->channels[k], most, largest);
        if (!(most / largest <= worst)) worst = most / largest;
    }
    return worst;
}

static bool compare(const Task *task)
{
    static Bench b;
    double ns[2][ROUNDS];
    start(&b, task);
    double off = difference(&b);
    for (size_t r = 0; r < ROUNDS; r++) {
        ns[0][r] = time_of(&b, by_hand);
        ns[1][r] = time_of(&b, by_batch);
    }
    bool keeps = row(task->name, median(ns[0], ROUNDS), median(ns[1], ROUNDS), "ns", 2.5, off);
    yk_batch_free(b.batch);
    machine_end(&b.machine);
    return keeps && off <= task->tolerance;
}

int main(void)
{
    static const Task tasks[] = {
        {"Watt's six-bar with masses: torque and all reactions, in batches, a pose",
         "examples/watt-with-masses.yaml",
         {"A.force.x", "A.force.y", "B.force.x", "B.force.y", "C.force.x", "C.force.y", "D.force.x", "D.force.y",
          "E.force.x", "E.force.y", "F.force.x", "F.force.y", "G.force.x", "G.force.y", "alpha.effort"},
         WATT_FORCES,
         -0.08,
         0.08,
         1.0,
         0.2,
         1e-11,
         watt_forces},
        {"Andrews' mechanism: torque and all reactions, in batches, a pose",
         "examples/andrews.yaml",
         {"O.force.x",  "O.force.y",  "F.force.x",  "F.force.y",  "B.force.x",  "B.force.y",  "A5.force.x",
          "A5.force.y", "G.force.x",  "G.force.y",  "A7.force.x", "A7.force.y", "H.force.x",  "H.force.y",
          "E2.force.x", "E2.force.y", "E4.force.x", "E4.force.y", "E6.force.x", "E6.force.y", "beta.effort"},
         ANDREWS_FORCES,
         0,
         6.283185307179586,
         100.0,
         2000.0,
         1e-11,
         andrews_forces},
        {"planetary gear with loads: torque and all reactions, in batches, a pose",
         "examples/planetary-gear.yaml",
         {"S.force.x", "S.force.y", "C.force.x", "C.force.y", "P.force.x", "P.force.y", "R.force.x", "R.force.y",
          "R.moment", "theta.effort"},
         PLANETARY_FORCES,
         0,
         22.0,
         150.0,
         80.0,
         1e-11,
         planetary_forces},
        {"cam with follower and spring: torque and all reactions, in batches, a pose",
         "examples/valve-cam.yaml",
         {"C.force.x", "C.force.y", "V.force.x", "V.moment", "theta.effort"},
         VALVE_FORCES,
         0.05,
         2.0,
         314.0,
         10.0,
         1e-11,
         valve_forces},
    };
    bool keeps = true;
    for (size_t k = 0; k < sizeof tasks / sizeof *tasks; k++) keeps &= compare(&tasks[k]);
    return keeps ? 0 : 2;
}
