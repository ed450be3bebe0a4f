// Kernels: the arithmetic of the compiled steps over lanes (one lane = one pose), branch-free, in structure of arrays.
// The same source runs one pose (n = 1) and blocks of poses, with identical bits. No allocation, no status: a lane that
// cannot close gets a negative margin, and holds garbage (possibly NaN) that the caller masks.
//
// Every loop of a planar machine is a sum of vectors v e^(i Phi), v d e^(i Phi). A kernel reads the known part K of a
// loop and solves its two unknowns. Source of the dyads: Assur groups of class II, e.g. Nikravesh 1988 ch. 2; Waldron &
// Kinzel 2004 ch. 5.
#ifndef SOLVE_KERNELS_KERNELS_H
#define SOLVE_KERNELS_KERNELS_H
#include <stdbool.h>
#include <stddef.h>
#include "base/vec.h"

// Lanes of an orientation: unit vector, rate, acceleration. c == NULL means the ground: (1, 0), 0, 0.
typedef struct YkTurn {
    double *c, *s, *w, *a;
} YkTurn;
// Lanes of a distance and its derivatives.
typedef struct YkSlide {
    double *d, *v, *a;
} YkSlide;
// Lanes of a vector and its derivatives.
typedef struct YkPlane {
    double *x, *y, *vx, *vy, *ax, *ay;
} YkPlane;
// Lanes of a scalar and its derivatives.
typedef struct YkScalar {
    double *x, *v, *a;
} YkScalar;
// The arm of a dyad, in the axes of its unknown orientation: constant, or (lanes.x != NULL) varying with its inputs.
typedef struct YkArm {
    YkVec constant;
    YkPlane lanes;
    // 1 / the square of the length from which the arm (RPR: the base) is long enough: shorter ones reduce margins by
    // the square of their ratio to it. 0: any length is long enough.
    double per_enough2;
} YkArm;

// Sets margin = 1; -1 if an input is not a number. is_first: whether this input is the first. Rates beyond 1e100 and
// accelerations beyond 1e200 count as not numbers: their squares and products would overflow on the way. Multiplied by
// these guards, they do.
#define YK_RATE_GUARD 0x1p+691
#define YK_ACCELERATION_GUARD 0x1p+359
void yk_lanes_begin(double *margin, const double *x, const double *rate, const double *accel, bool is_first, size_t n);
// Sets *are_numbers to whether an input is a number in all lanes.
void yk_lanes_numbers(bool *are_numbers, const double *x, const double *rate, const double *accel, size_t n);

// constant + along e^(i turn); turn must not be the ground.
typedef struct YkTurned {
    YkVec constant;
    double along;
    YkTurn turn;
} YkTurned;

// Computes out = parent turned by sign * (theta + offset). rate, accel NULL: zero; they may be those of out. sign is +1
// or -1. out.c NULL: the rates alone.
void yk_lanes_turn(YkTurn out, YkTurn parent, const double *theta, const double *rate, const double *accel,
                   double offset, double sign, size_t n);
// Computes out = a turned by b (rates add).
void yk_lanes_compose(YkTurn out, YkTurn a, YkTurn b, size_t n);

// Sums of vectors: out = constant (+ plus) (- minus); x == NULL means absent.
void yk_lanes_start(YkPlane out, YkVec constant, YkPlane plus, YkPlane minus, size_t n);
// Computes out = constant + v e^(i turn): the most common sum in one pass.
void yk_lanes_start_turn(YkPlane out, YkVec constant, YkTurn turn, YkVec v, size_t n);
void yk_lanes_add_turn(YkPlane out, YkTurn turn, YkVec v, size_t n); // out += v e^(i turn); turn must not be the ground
void yk_lanes_add_slide(YkPlane out, YkTurn turn, YkVec v, YkSlide slide,
                        size_t n); // out += d v e^(i turn); turn may be the ground

// Dyads: positions and, of RRR, RRP and RPR in the same pass, rates. branch = +1 or -1 is the sign of the determinant
// of the block's columns, in the order stated.
// margin[lane] = min(margin[lane], m), where m = (determinant / product of the column lengths)^2 = sin^2 of the angle
// between the columns; negative if the loop does not close (the root is then taken of 0). block_margin (may be NULL)
// gets m itself.
//
// RRR: K + U e^(i Phi1) + W e^(i Phi2) = 0; columns iU e^(i Phi1), iW e^(i Phi2):
// determinant = cross(U e^(i Phi1), W e^(i Phi2)),
// m = ((U+W)^2 - K^2) (K^2 - (U-W)^2) / (4 U^2 W^2) (factored: no cancellation). Writes c, s of both.
void yk_lanes_rrr(YkPlane K, YkArm U, YkArm W, double branch, YkTurn out1, YkTurn out2, double *margin,
                  double *block_margin, size_t n);
// RRP: K + W e^(i Phi) + d e = 0, e = u e^(i line), u a constant unit vector, line a known orientation (may be ground);
// columns in the order e, iW e^(i Phi):
// determinant = cross(e, iW e^(i Phi)) = dot(e, W e^(i Phi)). Writes c, s and d.
void yk_lanes_rrp(YkPlane K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out, YkSlide d, double *margin,
                  double *block_margin, size_t n);
// RPR: K + (C + d u e^(i inner)) e^(i Phi) = 0, u a constant unit vector, inner an orientation relative to Phi (usually
// ground = none); columns in the order e = u e^(i inner) e^(i Phi), i p with p = (C + d u..) e^(i Phi) = -K:
// determinant = cross(e, i p) = dot(e, p), m = dot(e, p)^2 / |p|^2. Writes c, s and d.
void yk_lanes_rpr(YkPlane K, YkArm C, YkTurn inner, YkVec u, double branch, YkTurn out, YkSlide d, double *margin,
                  double *block_margin, size_t n);
// PP: K + d1 e1 + d2 e2 = 0 with known directions; m = cross(e1, e2)^2; no branch. Writes d of both.
void yk_lanes_pp(YkPlane K, YkTurn line1, YkVec u1, YkTurn line2, YkVec u2, YkSlide d1, YkSlide d2, double *margin,
                 double *block_margin, size_t n);
// LINK: K + U e^(i Phi) = 0 with only Phi unknown: Phi = arg(-K / U). Writes c, s; gap[lane] = max(gap, | |K| - |U| |).
void yk_lanes_link(YkPlane K, YkArm U, YkTurn out, double *gap, size_t n);
// GUIDE: K + d e = 0 with only d unknown: d = -dot(K, e); gap[lane] = max(gap, |cross(K, e)|). Writes d.
void yk_lanes_guide(YkPlane K, YkTurn line, YkVec u, YkSlide d, double *gap, size_t n);
// CHECK: gap[lane] = max(gap, |K|).
void yk_lanes_gap(YkPlane K, double *gap, size_t n);

// Velocities and accelerations of the other blocks, after their positions, from one determinant. All write w, a of the
// orientations and v, a of the distances. K's rates, and the rates of varying arms and of turning lines (with their
// Coriolis terms), are known.
void yk_lanes_pp_rates(YkPlane K, YkTurn line1, YkVec u1, YkTurn line2, YkVec u2, YkSlide d1, YkSlide d2, size_t n);
void yk_lanes_link_rates(YkPlane K, YkArm U, YkTurn out, size_t n); // least squares: component along the column
void yk_lanes_guide_rates(YkPlane K, YkTurn line, YkVec u, YkSlide d, size_t n);
// RRR, RRP and RPR for constant arms, with the known part as a turned vector: same bits as yk_lanes_start_turn and then
// those above.
void yk_lanes_rrp_turned(const YkTurned *K, YkArm W, YkTurn line, YkVec u, double branch, YkTurn out, YkSlide d,
                         double *margin, double *block_margin, size_t n);
void yk_lanes_rpr_turned(const YkTurned *K, YkArm C, YkVec u, double branch, YkTurn out, YkSlide d, double *margin,
                         double *block_margin, size_t n);
void yk_lanes_rrr_turned(const YkTurned *K, YkArm U, YkArm W, double branch, YkTurn out1, YkTurn out2, double *margin,
                         double *block_margin, size_t n);

// Relations: out += factor x, with the rates; out = offset + factor x if it is the first.
void yk_lanes_multiple(YkScalar out, double offset, bool is_first, double factor, YkScalar x, size_t n);
// Computes out += gain f(x), with its rates; out = offset + gain f(x) if it is the first. law: f(x), f'(x), f''(x).
// slope = gain f'(x).
void yk_lanes_add_law(YkScalar out, double offset, bool is_first, double gain, const double *const *law, YkScalar x,
                      double *slope, size_t n);

// Answers. angle = arg(e_b conj(e_a)) + offset, nearest to `reference` modulo a turn.
void yk_lanes_angle(double *out, YkTurn a, YkTurn b, double offset, double reference, size_t n);
void yk_lanes_difference(double *out, const double *b, const double *a, size_t n); // b - a; either may be NULL (zero)
// Computes value = margin >= least ? value : 0 (NaN never passes).
void yk_lanes_mask(double *value, const double *margin, double least, size_t n);
// Sets *dips if, for any lane's margin and the two after it, the least is at most `zero`, they differ by more than
// `most`, or they could reach zero in between (yk_margin_may_vanish). margin has n + 2 lanes.
void yk_lanes_dip(bool *dips, const double *margin, double zero, double most, size_t n);
// Sets *swings if from any lane to the next the unit vectors' product is less than `least`. They have n + 1 lanes.
void yk_lanes_swing(bool *swings, const double *c, const double *s, double least, size_t n);
// Sets *well if every lane has margin > least and gap <= most (NaN has not): the usual case, in which no lane needs a
// mask. gap NULL: all are 0, where loops are compiled for blocks.
void yk_lanes_well(bool *well, const double *margin, const double *gap, double least, double most, size_t n);
// Sets *finite if every lane of all rows is finite. It stays false as well where numbers beyond 2e307 are, whose sums
// are not: the caller looks at each lane then.
void yk_lanes_finite(bool *finite, double *const *rows, size_t count, size_t n);

#endif
