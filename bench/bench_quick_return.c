// The quick-return's kinematics - position, velocity and acceleration of its four unknowns - by hand-written closed
// forms, by Yoke's kernels, and through the public calls from the model file. Interleaved in one run; the median of the
// rounds counts.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <yoke/yoke.h>
#include "chain.h"
#include "machine.h"
#include "reference/common/bench.h"
#include "reference/k1/closed.h"

enum { CHUNK = 1024, CHUNKS = 977, POSES = CHUNK * CHUNKS, ROUNDS = 5 };

// Shared by all ways: crank angles over half a turn, and rows of 12 outputs that stay in cache.
typedef struct Bench {
    double *theta1;
    double *out[NOUT];
    double rate[CHUNK], accel[CHUNK];
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
    YkBatch *batch;
    YkChannel channels[NOUT];
} Bench;

static const double W = -0.5, AL = 0; // rad/s, rad/s^2

static void by_simd(Bench *b, const double *theta1)
{
    simd_own(theta1, W, AL, b->out, CHUNK);
}
static void by_kernels(Bench *b, const double *theta1)
{
    chain_run(theta1, W, AL, b->out, CHUNK);
}
static void by_single_kernels(Bench *b, const double *theta1)
{
    chain_run_singly(theta1, W, AL, b->out, CHUNK);
}

static void by_scalar(Bench *b, const double *theta1)
{
    for (size_t i = 0; i < CHUNK; i++) {
        double o[NOUT];
        closed_scalar(theta1[i], W, AL, o);
        for (size_t k = 0; k < NOUT; k++) b->out[k][i] = o[k];
    }
}

static void by_batch(Bench *b, const double *theta1)
{
    const double *inputs[] = {theta1, b->rate, b->accel};
    if (yk_batch_run(b->batch, inputs, b->out, NULL, CHUNK) != YK_OK) exit(1);
}

static void by_state(Bench *b, const double *theta1)
{
    for (size_t i = 0; i < CHUNK; i++) {
        yk_state_set_input_to(b->state, 0, theta1[i], W, AL);
        if (yk_state_solve(b->state) != YK_OK) exit(1);
        for (size_t k = 0; k < 4; k++) {
            YkMotion m = yk_state_coordinate(b->state, (size_t)b->channels[k].index);
            b->out[k][i] = m.position, b->out[4 + k][i] = m.velocity, b->out[8 + k][i] = m.acceleration;
        }
    }
}

typedef struct Way {
    const char *name;
    void (*run)(Bench *b, const double *theta1);
    size_t chunks; // how many of the poses it runs: the slow ones fewer
    double limit;  // what it must keep: times the SIMD closed form, or (singly) ns a pose; 0: none
    bool is_singly;
    double ns[ROUNDS], error;
} Way;

static bool open_model(Bench *b, const char *path)
{
    static const char *const names[NOUT] = {"theta2",       "d3",       "theta4",       "d5",
                                            "theta2.rate",  "d3.rate",  "theta4.rate",  "d5.rate",
                                            "theta2.accel", "d3.accel", "theta4.accel", "d5.accel"};
    YkProblems *problems = yk_problems_new();
    if (!problems) return false;
    b->model = yk_model_load(path, NULL, problems);
    b->mech = b->model ? yk_mechanism_compile(b->model, NULL, problems) : NULL;
    b->state = b->mech ? yk_state_new(b->mech) : NULL;
    bool stands = b->state && yk_state_set_time(b->state, 0, problems) >= 0 && yk_state_assemble(b->state) >= 0;
    for (size_t k = 0; stands && k < NOUT; k++)
        stands = yk_channel_parse(b->mech, names[k], &b->channels[k], problems) == YK_OK;
    b->batch = stands ? yk_batch_new(b->state, b->channels, NOUT) : NULL;
    if (!b->batch) fprintf(stderr, "%s", yk_problems_text(problems, 0));
    yk_problems_free(problems);
    return b->batch != NULL;
}

static void close_model(Bench *b)
{
    yk_batch_free(b->batch);
    yk_state_free(b->state);
    yk_mechanism_free(b->mech);
    yk_model_free(b->model);
}

static double time_way(Bench *b, const Way *way)
{
    double start = bench_now();
    for (size_t c = 0; c < way->chunks; c++) way->run(b, b->theta1 + c * (CHUNKS / way->chunks) * CHUNK);
    return (bench_now() - start) * 1e9 / (double)(way->chunks * CHUNK);
}

// The largest absolute error of the 12 outputs against long double.
static double error_of(Bench *b, const Way *way)
{
    double worst = 0;
    for (size_t c = 0; c < CHUNKS; c += 3) {
        way->run(b, b->theta1 + c * CHUNK);
        for (size_t i = 0; i < CHUNK; i += 7) {
            long double exact[NOUT];
            closed_long(b->theta1[c * CHUNK + i], W, AL, exact);
            for (size_t k = 0; k < NOUT; k++) {
                double off = fabs((double)(b->out[k][i] - exact[k]));
                if (!(off <= worst)) worst = off;
            }
        }
    }
    return worst;
}

static double middle(Way *way)
{
    return median(way->ns, ROUNDS);
}

static bool print_way(Way *way, double simd)
{
    double ns = middle(way), against = way->is_singly ? ns : ns / simd;
    bool keeps = (way->limit == 0 || against <= way->limit) && way->error <= 1e-13;
    printf("%-44s %8.2f %8.2f %8.2f %10.2f %10.1e", way->name, ns, way->ns[0], way->ns[ROUNDS - 1], ns / simd,
           way->error);
    if (way->limit > 0)
        printf("   %s <= %g%s", keeps ? "keeps" : "MISSES", way->limit, way->is_singly ? " ns" : " times");
    printf("\n");
    return keeps;
}

int main(int argc, char **argv)
{
    static Bench b;
    Way ways[] = {
        {.name = "hand-written SIMD (fast-math, native)", .run = by_simd, .chunks = CHUNKS},
        {.name = "hand-written scalar", .run = by_scalar, .chunks = CHUNKS / 8},
        {.name = "our kernels, in blocks", .run = by_kernels, .chunks = CHUNKS, .limit = 1.8},
        {.name = "our kernels, one pose a call",
         .run = by_single_kernels,
         .chunks = CHUNKS / 8,
         .limit = 150,
         .is_singly = true},
        {.name = "yk_batch_run", .run = by_batch, .chunks = CHUNKS, .limit = 1.8},
        {.name = "yk_state_solve, one pose a call",
         .run = by_state,
         .chunks = CHUNKS / 8,
         .limit = 150,
         .is_singly = true},
    };
    const size_t count = sizeof ways / sizeof *ways;
    if (!open_model(&b, argc > 1 ? argv[1] : YOKE_ROOT "/examples/quick-return.yaml")) return 1;
    b.theta1 = malloc(POSES * sizeof *b.theta1);
    double *rows = malloc(NOUT * (CHUNK + 24) * sizeof *rows);
    if (!b.theta1 || !rows) return 1;
    for (size_t k = 0; k < NOUT; k++) b.out[k] = rows + k * (CHUNK + 24);
    for (size_t i = 0; i < POSES; i++) b.theta1[i] = 3.141592653589793 * (double)i / (POSES - 1);
    for (size_t i = 0; i < CHUNK; i++) b.rate[i] = W, b.accel[i] = AL;

    for (size_t k = 0; k < count; k++) ways[k].error = error_of(&b, &ways[k]);
    for (size_t r = 0; r < ROUNDS; r++)
        for (size_t k = 0; k < count; k++) ways[k].ns[r] = time_way(&b, &ways[k]);
    printf("%-44s %8s %8s %8s %10s %10s\n", "position, velocity, acceleration; 12 outputs", "ns/pose", "least", "most",
           "times SIMD", "max error");
    bool keeps = true;
    for (size_t k = 0; k < count; k++) keeps &= print_way(&ways[k], middle(&ways[0]));
    keeps &= row("quick-return, position, velocity, acceleration, in batches, a pose", middle(&ways[0]),
                 middle(&ways[4]), "ns", 1.6, ways[4].error);
    keeps &= row("the same, one pose a call", middle(&ways[1]), middle(&ways[5]), "ns", 1.8, ways[5].error);
    free(b.theta1);
    free(rows);
    close_model(&b);
    return keeps ? 0 : 2;
}
