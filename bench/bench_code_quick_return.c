// The quick-return's position, velocity and acceleration by the C that `yoke code` prints, against closed forms written
// by hand: over arrays in cache, and one pose a call.
#include <math.h>
#include <stdbool.h>
#define quick_DECLARATIONS_ONLY
#include "quick.c"
#include "reference/common/bench.h"
#include "reference/k1/closed.h"
#include "rows.h"

enum { CHUNK = 1024, ROUNDS = 21 };
static const double W = -0.5, AL = 0.1, MOST = 1.1;

typedef struct Bench {
    double theta[CHUNK], rate[CHUNK], accel[CHUNK], rows[NOUT][CHUNK + 24], own[NOUT][CHUNK + 24];
    double *out[NOUT];
    signed char status[CHUNK];
} Bench;

static void by_simd(Bench *b)
{
    simd_own(b->theta, W, AL, b->out, CHUNK);
}

static void by_batch(Bench *b)
{
    const quick_parameters p = quick_defaults();
    const quick_machine m = quick_prepare(&p);
    const quick_configuration c = quick_start();
    const quick_inputs_arrays in = {b->theta, b->theta, b->rate, b->accel};
    double(*o)[CHUNK + 24] = b->own; // in the order of the references: positions, rates, accelerations
    const quick_motion_arrays out = {o[0], o[4], o[8], o[1], o[5], o[9], o[2], o[6], o[10], o[3], o[7], o[11]};
    quick_find_motion_batch(CHUNK, &m, &c, &in, &out, b->status);
}

static void by_scalar(Bench *b)
{
    for (size_t i = 0; i < CHUNK; i++) {
        double o[NOUT];
        closed_scalar(b->theta[i], W, AL, o);
        for (size_t k = 0; k < NOUT; k++) b->rows[k][i] = o[k];
    }
}

static void by_call(Bench *b)
{
    const quick_parameters p = quick_defaults();
    const quick_machine m = quick_prepare(&p);
    const quick_configuration c = quick_start();
    quick_inputs in = {.theta1_rate = W, .theta1_accel = AL};
    for (size_t i = 0; i < CHUNK; i++) {
        quick_motion o;
        in.theta1 = b->theta[i];
        b->status[i] = (signed char)quick_find_motion(&m, &c, &in, &o);
        b->own[0][i] = o.theta2, b->own[4][i] = o.theta2_rate, b->own[8][i] = o.theta2_accel;
        b->own[1][i] = o.d3, b->own[5][i] = o.d3_rate, b->own[9][i] = o.d3_accel;
        b->own[2][i] = o.theta4, b->own[6][i] = o.theta4_rate, b->own[10][i] = o.theta4_accel;
        b->own[3][i] = o.d5, b->own[7][i] = o.d5_rate, b->own[11][i] = o.d5_accel;
    }
}

static double time_of(Bench *b, void (*run)(Bench *))
{
    enum { REPEATS = 30 };
    double start = bench_now();
    for (int k = 0; k < REPEATS; k++) run(b);
    return (bench_now() - start) * 1e9 / (REPEATS * (double)CHUNK);
}

// The largest error of our outputs against long double.
static double error_of(Bench *b, void (*run)(Bench *))
{
    double worst = 0;
    run(b);
    for (size_t i = 0; i < CHUNK; i++) {
        long double exact[NOUT];
        closed_long(b->theta[i], W, AL, exact);
        if (b->status[i] != 0) return INFINITY;
        for (size_t k = 0; k < NOUT; k++) worst = fmax(worst, fabs((double)(b->own[k][i] - exact[k])));
    }
    return worst;
}

static bool compare(Bench *b, const char *task, void (*hand)(Bench *), void (*code)(Bench *))
{
    double theirs[ROUNDS], ours[ROUNDS];
    for (int r = 0; r < ROUNDS; r++) {
        theirs[r] = time_of(b, hand);
        ours[r] = time_of(b, code);
    }
    double error = error_of(b, code);
    return row(task, median(theirs, ROUNDS), median(ours, ROUNDS), "ns", MOST, error) && error <= 1e-12;
}

int main(void)
{
    static Bench b;
    for (size_t k = 0; k < NOUT; k++) b.out[k] = b.rows[k];
    for (size_t i = 0; i < CHUNK; i++) {
        b.theta[i] = 3.141592653589793 * (double)i / (CHUNK - 1);
        b.rate[i] = W, b.accel[i] = AL;
    }
    bool keeps = compare(&b, "`yoke code`: quick-return, position, velocity, acceleration, in batches, a pose", by_simd,
                         by_batch);
    keeps &= compare(&b, "`yoke code`: the same, one pose a call", by_scalar, by_call);
    return keeps ? 0 : 2;
}
