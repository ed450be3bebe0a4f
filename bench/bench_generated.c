// C written by `yoke derive --format c` for a chain of eight links: M and h in joint angles, each call at another pose.
// The file is made during the build (CMakeLists.txt).
#include <stdio.h>
#include <stdlib.h>
#include "generated_chain.c"
#include "reference/common/bench.h"

enum { ROUNDS = 5, CALLS = 500000 };
static const double MOST = 300; // ns

static double times[ROUNDS];

static int by_size(const void *left, const void *right)
{
    const double *a = left, *b = right;
    return (*a > *b) - (*a < *b);
}

int main(void)
{
    void (*volatile call)(const Machine *restrict, double[8][8], double[8]) = machine_lagrange; // not to be inlined
    Machine m = {.q1 = 0.1, .q2 = 0.2, .q3 = 0.3, .q4 = 0.4, .q5 = 0.5, .q6 = 0.6, .q7 = 0.7, .q8 = 0.8, .q1_rate = 1};
    double M[8][8], h[8], sum = 0;
    machine_constants(&m);
    for (int r = 0; r < ROUNDS; r++) {
        double start = bench_now();
        for (int k = 0; k < CALLS; k++) {
            m.q1 += 1e-6, m.q5 -= 1e-6, m.q8_rate += 1e-6;
            call(&m, M, h);
            sum += M[0][0] + h[0];
        }
        times[r] = 1e9 * (bench_now() - start) / CALLS;
    }
    qsort(times, ROUNDS, sizeof *times, by_size);
    printf("M and h of 8 links in joint angles: %.0f ns (%.0f - %.0f), asked %.0f (sum %g)\n", times[ROUNDS / 2],
           times[0], times[ROUNDS - 1], MOST, sum);
    return times[ROUNDS / 2] <= MOST ? 0 : 2;
}
