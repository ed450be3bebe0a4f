// The accelerations of double pendulums, 1e5 states each with its own parameters, in blocks that stay in the first
// cache (39 KB with all arrays; the hand-written takes six of them as constants): the C that `yoke code` prints against
// a loop written by hand, both compiled with the same flags but for fast-math, which only the hand-written has.
#include <math.h>
#define pendulum_DECLARATIONS_ONLY
#include "pendulum.c"
#include "reference/common/bench.h"
#include "reference/d1.h"
#include "rows.h"

enum { CHUNK = 256, REPEATS = 400, ROUNDS = 21 };
static const double MOST = 1.3;

typedef struct Bench {
    double p[11][CHUNK], in[9][CHUNK], a[2][CHUNK], b[2][CHUNK];
    signed char status[CHUNK];
} Bench;

static void fill(Bench *b)
{
    const double file[11] = {0.5, 0.5, 0.35, 0.3, 0.5, 0.4, 0.025, 0.02, 0.5, -0.2, 9.81};
    for (int i = 0; i < CHUNK; i++) {
        for (int k = 0; k < 11; k++) b->p[k][i] = file[k] * (k < 8 ? 1 + 0.1 * sin(3.1 * i + k) : 1);
        for (int k = 0; k < 9; k++) b->in[k][i] = k == 4 || k == 8 || k == 0 ? 0 : 3 * sin(1.7 * i + k);
    }
}

static void by_hand(Bench *b)
{
    const D1States states = {b->in[1], b->in[5], b->in[2], b->in[6], b->p[0], b->p[2],
                             b->p[3],  b->p[4],  b->p[5],  b->p[6],  b->p[7]};
    d1_simd(&states, b->a[0], b->a[1], CHUNK);
}

static void by_code(Bench *b)
{
    const pendulum_parameters_arrays p = {b->p[0], b->p[1], b->p[2], b->p[3], b->p[4], b->p[5],
                                          b->p[6], b->p[7], b->p[8], b->p[9], b->p[10]};
    const pendulum_inputs_arrays in = {b->in[0], b->in[1], b->in[2], b->in[3], b->in[4],
                                       b->in[5], b->in[6], b->in[7], b->in[8]};
    const pendulum_accelerations_arrays out = {b->b[0], b->b[1]};
    const pendulum_configuration c = pendulum_start();
    pendulum_find_accelerations_designs(CHUNK, &p, &c, &in, &out, b->status);
}

static double time_of(Bench *b, void (*run)(Bench *))
{
    double start = bench_now();
    for (int k = 0; k < REPEATS; k++) run(b);
    return (bench_now() - start) * 1e9 / (REPEATS * (double)CHUNK);
}

int main(void)
{
    static Bench b;
    double hand[ROUNDS], code[ROUNDS], worst = 0, largest = 0;
    fill(&b);
    for (int r = 0; r < ROUNDS; r++) {
        hand[r] = time_of(&b, by_hand);
        code[r] = time_of(&b, by_code);
    }
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < CHUNK; i++) {
            worst = fmax(worst, fabs(b.a[k][i] - b.b[k][i]));
            largest = fmax(largest, fabs(b.a[k][i]));
            if (b.status[i] != 0) return 1;
        }
    bool keeps = row("`yoke code`: double pendulums, each with its own parameters, a state", median(hand, ROUNDS),
                     median(code, ROUNDS), "ns", MOST, worst / largest);
    return keeps && worst <= 1e-12 * largest ? 0 : 2;
}
