// Shared by the tests of the kernels: motions in long double, built by the product rule from chosen solutions, so that
// every kernel has an answer that is known beforehand; and lanes to put them in.
#ifndef TESTS_LANES_CHECK_H
#define TESTS_LANES_CHECK_H
#include <complex.h>
#include <stdbool.h>
#include "check.h"
#include "solve/kernels/kernels.h"

#define LANES 257 // not a multiple of any vector's width
typedef long double complex Complex;

// A vector (or, real, a distance) with its rate and acceleration.
typedef struct Motion {
    Complex value, rate, accel;
} Motion;

static inline Motion motion_add(Motion a, Motion b)
{
    return (Motion){a.value + b.value, a.rate + b.rate, a.accel + b.accel};
}
static inline Motion motion_minus(Motion a)
{
    return (Motion){-a.value, -a.rate, -a.accel};
}
static inline Motion motion_times(Motion a, Motion b)
{
    return (Motion){a.value * b.value, a.rate * b.value + a.value * b.rate,
                    a.accel * b.value + 2 * a.rate * b.rate + a.value * b.accel};
}
// The unit vector at an angle that moves: value, rate and acceleration of the angle are real.
static inline Motion motion_turn(Motion angle)
{
    long double phi = creall(angle.value), w = creall(angle.rate), a = creall(angle.accel);
    Complex e = cosl(phi) + I * sinl(phi);
    return (Motion){e, I * w * e, (I * a - w * w) * e};
}
static inline Motion motion_constant(Complex value)
{
    return (Motion){value, 0, 0};
}

// Random motions, their numbers doubles.
static inline Motion random_real(uint64_t *seed, double low, double high)
{
    double value = check_uniform(seed, low, high), rate = check_uniform(seed, -2, 2),
           accel = check_uniform(seed, -2, 2);
    return (Motion){value, rate, accel};
}
static inline Motion random_plane(uint64_t *seed, double size)
{
    Motion x = random_real(seed, -size, size), y = random_real(seed, -size, size);
    return (Motion){x.value + I * y.value, x.rate + I * y.rate, x.accel + I * y.accel};
}
static inline Motion random_angle(uint64_t *seed)
{
    return random_real(seed, -3.14, 3.14);
}

// Rows of lanes, taken one after another.
typedef struct Pool {
    double rows[96][LANES];
    size_t used;
} Pool;

static inline double *pool_row(Pool *pool)
{
    if (pool->used == sizeof pool->rows / sizeof *pool->rows) fail_msg("the pool has no row left");
    return pool->rows[pool->used++];
}
static inline double *pool_full(Pool *pool, double value)
{
    double *row = pool_row(pool);
    for (size_t i = 0; i < LANES; i++) row[i] = value;
    return row;
}
static inline YkTurn pool_turn(Pool *pool)
{
    return (YkTurn){pool_row(pool), pool_row(pool), pool_row(pool), pool_row(pool)};
}
static inline YkSlide pool_slide(Pool *pool)
{
    return (YkSlide){pool_row(pool), pool_row(pool), pool_row(pool)};
}
static inline YkPlane pool_plane(Pool *pool)
{
    return (YkPlane){pool_row(pool), pool_row(pool), pool_row(pool), pool_row(pool), pool_row(pool), pool_row(pool)};
}

// Motions into lanes; of an orientation the angle's motion.
static inline void put_plane(YkPlane p, size_t i, Motion m)
{
    p.x[i] = (double)creall(m.value), p.y[i] = (double)cimagl(m.value);
    p.vx[i] = (double)creall(m.rate), p.vy[i] = (double)cimagl(m.rate);
    p.ax[i] = (double)creall(m.accel), p.ay[i] = (double)cimagl(m.accel);
}
static inline void put_turn(YkTurn t, size_t i, Motion angle)
{
    t.c[i] = (double)cosl(creall(angle.value)), t.s[i] = (double)sinl(creall(angle.value));
    t.w[i] = (double)creall(angle.rate), t.a[i] = (double)creall(angle.accel);
}
static inline void put_slide(YkSlide d, size_t i, Motion m)
{
    d.d[i] = (double)creall(m.value), d.v[i] = (double)creall(m.rate), d.a[i] = (double)creall(m.accel);
}

// Lanes as motions; orientations as unit vectors.
static inline Motion get_plane(YkPlane p, size_t i)
{
    return (Motion){p.x[i] + I * p.y[i], p.vx[i] + I * p.vy[i], p.ax[i] + I * p.ay[i]};
}
static inline Motion get_turn(YkTurn t, size_t i)
{
    Complex e = t.c ? t.c[i] + I * t.s[i] : 1;
    long double w = t.c ? t.w[i] : 0, a = t.c ? t.a[i] : 0;
    return (Motion){e, I * w * e, (I * a - w * w) * e};
}
static inline Motion get_slide(YkSlide d, size_t i)
{
    return (Motion){d.d[i], d.v[i], d.a[i]};
}
static inline Motion get_arm(YkArm arm, size_t i)
{
    return arm.lanes.x ? get_plane(arm.lanes, i) : motion_constant(arm.constant.x + I * arm.constant.y);
}
static inline Motion vec_motion(YkVec v)
{
    return motion_constant(v.x + I * v.y);
}

static inline void check_plane(YkPlane p, size_t i, Motion m, double tolerance)
{
    Motion got = get_plane(p, i);
    CHECK_NEAR((double)cabsl(got.value - m.value), 0, tolerance);
    CHECK_NEAR((double)cabsl(got.rate - m.rate), 0, tolerance);
    CHECK_NEAR((double)cabsl(got.accel - m.accel), 0, tolerance);
}

static inline void check_turn_place(YkTurn t, size_t i, Motion angle, double tolerance)
{
    CHECK_NEAR(t.c[i], (double)cosl(creall(angle.value)), tolerance);
    CHECK_NEAR(t.s[i], (double)sinl(creall(angle.value)), tolerance);
}
static inline void check_turn_rates(YkTurn t, size_t i, Motion angle, double tolerance)
{
    CHECK_NEAR(t.w[i], (double)creall(angle.rate), tolerance);
    CHECK_NEAR(t.a[i], (double)creall(angle.accel), tolerance);
}
static inline void check_slide_rates(YkSlide d, size_t i, Motion m, double tolerance)
{
    CHECK_NEAR(d.v[i], (double)creall(m.rate), tolerance);
    CHECK_NEAR(d.a[i], (double)creall(m.accel), tolerance);
}

static inline double cross_of(Complex a, Complex b)
{
    return (double)cimagl(conjl(a) * b);
}
static inline double dot_of(Complex a, Complex b)
{
    return (double)creall(conjl(a) * b);
}

// A random arm: constant for all lanes, or with lanes of its own. Longer than 0.3.
static inline YkArm random_arm(Pool *pool, uint64_t *seed, bool varies)
{
    YkArm arm = {.constant = {check_uniform(seed, 0.3, 2), check_uniform(seed, -1, 1)}};
    if (varies) {
        arm.lanes = pool_plane(pool);
        for (size_t i = 0; i < LANES; i++) {
            Motion grow = random_plane(seed, 0.2);
            grow.value += arm.constant.x + 0.3L + I * arm.constant.y;
            put_plane(arm.lanes, i, grow);
        }
    }
    return arm;
}

// A random line: the ground's axes, or lanes of turning ones; and a unit vector in it.
static inline YkTurn random_line(Pool *pool, uint64_t *seed, bool turns)
{
    if (!turns) return (YkTurn){0};
    YkTurn line = pool_turn(pool);
    for (size_t i = 0; i < LANES; i++) put_turn(line, i, random_angle(seed));
    return line;
}
static inline YkVec random_unit(uint64_t *seed)
{
    double angle = check_uniform(seed, -3.14, 3.14);
    return yk_unit(angle);
}

// Runs a test of one seed and two choices for some seeds and all four choices.
static inline void for_all_choices(void (*test)(uint64_t seed, bool first, bool second), int seeds)
{
    for (int s = 0; s < seeds; s++)
        for (int choice = 0; choice < 4; choice++) test(1000 + (uint64_t)s, choice & 1, choice & 2);
}
#endif
