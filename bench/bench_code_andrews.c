// Andrews' squeezing mechanism by the C that `yoke code` prints and DOP853, against the reduced equations in closed
// form written by hand and the same DOP853: one right-hand side; the motion to 0.03 s at equal error.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "squeezer.c"
#include "reference/common/bench.h"
#include "reference/d4.h"
#include "reference/dop853.h"
#include "rows.h"

enum { ROUNDS = 11, EVALUATIONS = 100000, RUNS = 10, TOLERANCES = 6 };
static const double MOST = 1.2, ERROR = 1e-8; // rad

static squeezer_machine machine;
static squeezer_configuration configuration;

static __attribute__((noinline)) void right_hand_side(const double *y, double *dy)
{
    squeezer_inputs in = {.beta = y[0], .beta_rate = y[1]};
    squeezer_accelerations out;
    if (squeezer_accelerations_of(&machine, &configuration, &in, &out) != squeezer_OK) exit(1);
    dy[0] = y[1];
    dy[1] = out.beta_accel;
}

static long run(double tolerance, double *angles)
{
    double y[2] = {d4_start[0], 0};
    long evaluations = dop853(2, right_hand_side, y, 0.03, tolerance);
    const squeezer_inputs in = {.beta = y[0], .beta_rate = y[1]};
    squeezer_configuration end = configuration;
    squeezer_motion out;
    end.near_Theta = d4_end[D4_THETA];
    if (squeezer_find_motion(&machine, &end, &in, &out) != squeezer_OK) exit(1);
    const double found[] = {y[0], out.Theta, out.gamma, out.Phi, out.delta, out.Omega, out.epsilon};
    memcpy(angles, found, sizeof found);
    return evaluations;
}

static double error_of(const double *angles)
{
    double worst = 0;
    for (int i = 0; i < D4_ANGLES; i++) worst = fmax(worst, fabs(angles[i] - d4_end[i]));
    return worst;
}

static double time_side(void (*side)(const double *y, double *dy), double *acceleration)
{
    double y[2] = {d4_start[0], 100}, dy[2] = {0}, start = bench_now();
    for (size_t k = 0; k < EVALUATIONS; k++) {
        side(y, dy);
        y[0] += 1e-20 * dy[1];
    }
    *acceleration = dy[1];
    return (bench_now() - start) * 1e9 / EVALUATIONS;
}

typedef struct Runs {
    double ms[TOLERANCES][ROUNDS], error[TOLERANCES];
} Runs;

static void time_run(long (*way)(double, double *), Runs *runs, int k, int round)
{
    double angles[D4_ANGLES], start = bench_now();
    for (int i = 0; i < RUNS; i++) way(pow(10, -7 - k), angles);
    runs->ms[k][round] = (bench_now() - start) * 1e3 / RUNS;
    runs->error[k] = error_of(angles);
}

static double cheapest(Runs *runs)
{
    double best = INFINITY;
    for (int k = 0; k < TOLERANCES; k++)
        if (runs->error[k] <= ERROR) best = fmin(best, median(runs->ms[k], ROUNDS));
    return best;
}

// Of the tolerance that was taken.
static double least_error(const Runs *runs)
{
    for (int k = 0; k < TOLERANCES; k++)
        if (runs->error[k] <= ERROR) return runs->error[k];
    return INFINITY;
}

int main(void)
{
    static Runs hand, code;
    double a[ROUNDS], b[ROUNDS], exact, own;
    const squeezer_parameters p = squeezer_defaults();
    machine = squeezer_prepare(&p);
    configuration = squeezer_start();
    for (int r = 0; r < ROUNDS; r++) {
        a[r] = time_side(d4_rhs, &exact);
        b[r] = time_side(right_hand_side, &own);
        for (int k = 0; k < TOLERANCES; k++) {
            time_run(d4_run, &hand, k, r);
            time_run(run, &code, k, r);
        }
    }
    row("`yoke code`: Andrews' mechanism, one right-hand side", median(a, ROUNDS), median(b, ROUNDS), "ns", 0,
        fabs(own - exact) / fabs(exact));
    return row("`yoke code`: Andrews' mechanism to 0.03 s at an error of at most 1e-8", cheapest(&hand),
               cheapest(&code), "ms", MOST, least_error(&code))
               ? 0
               : 2;
}
