// The quick-return as a chain of kernels, without the engine's step runner.
#include "chain.h"
#include "solve/kernels/kernels.h"

// Rows lie a little further apart than they are long: rows that start a multiple of 4096 bytes apart get in each
// other's way.
#define ROW (CHAIN_BLOCK + 8)

// Everything one block needs between its kernels.
typedef struct Block {
    double crank[4][ROW], K1[6][ROW], K2[6][ROW], lever[2][ROW];
    double coupler[4][ROW], margin[ROW], rate[ROW], accel[ROW];
} Block;

static YkTurn turn_of(double (*row)[ROW])
{
    return (YkTurn){row[0], row[1], row[2], row[3]};
}
static YkPlane plane_of(double (*row)[ROW])
{
    return (YkPlane){row[0], row[1], row[2], row[3], row[4], row[5]};
}

// The loops A: O1 + crank - lever's slide = 0, and C: lever - ram's slide = 0.
static void solve_block(Block *b, const double *theta1, double *const *out, size_t at, size_t n)
{
    const double a1 = 1, a2 = 1, l1 = 0.75, l2 = 1.75, l4 = 2.0 / 3, reference2 = 1.1, reference4 = -0.4;
    YkTurn ground = {0}, crank = turn_of(b->crank), coupler = turn_of(b->coupler);
    YkTurn lever = {b->lever[0], b->lever[1], out[4] + at, out[8] + at}; // what is asked goes straight to its row
    YkPlane K1 = plane_of(b->K1), K2 = plane_of(b->K2);
    YkSlide d3 = {out[1] + at, out[5] + at, out[9] + at}, d5 = {out[3] + at, out[7] + at, out[11] + at};
    YkArm none = {0}, rod = {.constant = {l4, 0}};
    for (size_t i = 0; i < n; i++) b->margin[i] = 1;
    yk_lanes_turn(crank, ground, theta1, b->rate, b->accel, 0, 1, n);
    yk_lanes_start_turn(K1, yk_vec(0, a1), crank, yk_vec(l1, 0), n);
    yk_lanes_rpr(K1, none, ground, yk_vec(-1, 0), 1, lever, d3, b->margin, NULL, n);
    yk_lanes_start_turn(K2, yk_vec(0, -(a1 + a2)), lever, yk_vec(l2, 0), n);
    yk_lanes_rrp(K2, rod, ground, yk_vec(-1, 0), -1, coupler, d5, b->margin, NULL, n);
    yk_lanes_angle(out[0] + at, ground, lever, 0, reference2, n);
    yk_lanes_angle(out[2] + at, lever, coupler, 0, reference4, n);
    yk_lanes_difference(out[6] + at, coupler.w, lever.w, n);
    yk_lanes_difference(out[10] + at, coupler.a, lever.a, n);
}

static void run(Block *b, const double *theta1, double w, double al, double *const *out, size_t count, size_t step)
{
    for (size_t i = 0; i < ROW; i++) {
        b->rate[i] = w;
        b->accel[i] = al;
    }
    for (size_t at = 0; at < count; at += step)
        solve_block(b, theta1 + at, out, at, count - at < step ? count - at : step);
}

void chain_run(const double *theta1, double w, double al, double *const *out, size_t count)
{
    _Alignas(64) Block b;
    run(&b, theta1, w, al, out, count, CHAIN_BLOCK);
}

void chain_run_singly(const double *theta1, double w, double al, double *const *out, size_t count)
{
    _Alignas(64) Block b;
    run(&b, theta1, w, al, out, count, 1);
}
