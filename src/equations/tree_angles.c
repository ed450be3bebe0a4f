// Finds the absolute angles of links, with their sines and cosines.
#include "equations/tree_angles.h"
#include "elementary/elementary.h"
#include "elementary/turn.h"
#include "solve/kernels/kernels.h"

// BLOCK: angles whose sines are found together, in the first-level cache. Lanes come in groups of WIDTH: a block of at
// least one group is filled up to whole groups.
enum { BLOCK = 128, WIDTH = 8, FEW = 4 }; // FEW: links whose sines are found without a call

static size_t number_forks(YkLinkTurn *turn, size_t count)
{
    size_t forks = 0;
    for (size_t k = 1; k < count; k++) {
        YkLinkTurn *parent = &turn[turn[k].parent];
        if (turn[k].parent != (int32_t)k - 1 && parent->fork == YK_NONE) parent->fork = (int32_t)forks++;
    }
    return forks;
}

bool yk_tree_angles_start(YkTreeAngles *angles, const YkTreeLinks *links, YkArena *arena)
{
    size_t n = links->count;
    *angles = (YkTreeAngles){.turn = YK_NEW(arena, YkLinkTurn, n), .count = n};
    angles->c = YK_NEW(arena, double, n + WIDTH);
    angles->s = YK_NEW(arena, double, n + WIDTH);
    angles->w = YK_NEW(arena, double, n);
    if (yk_arena_failed(arena)) return false;
    for (size_t k = 0; k < n; k++) {
        const YkTreeLink *link = &links->link[k];
        angles->turn[k] = (YkLinkTurn){link->parent, link->angle, YK_NONE, (float)link->sense};
    }
    angles->fork_count = number_forks(angles->turn, n);
    angles->fork_angle = YK_NEW(arena, double, angles->fork_count + 1);
    angles->c[0] = 1;
    return !yk_arena_failed(arena);
}

// Removes a whole number of turns, as exactly as 2 pi is known in three parts: Cody & Waite 1980, ch. 8; parts of 37
// bits, so that products with up to 16 bits are exact. Larger angles stay.
static inline double without_turns(double angle)
{
    const double most = 16;
    if (!(fabs(angle) > most) || fabs(angle) > 1e5) return angle;
    double k = rint(angle * (1 / (2 * YK_PI)));
    return ((angle - k * 0x1.921fb5444p+2) - k * 0x1.68c234c4cp-37) - k * 0x1.98a2e03707345p-75;
}

// Finds the absolute angle of link k and its rate from those of the previous link.
static inline void step_out(const YkTreeAngles *angles, size_t k, const double *q, const double *v, double *angle,
                            double *rate)
{
    const YkLinkTurn *turn = angles->turn;
    YkLinkTurn t = turn[k];
    if (t.parent != (int32_t)k - 1) {
        *angle = angles->fork_angle[turn[t.parent].fork];
        *rate = angles->w[t.parent];
    }
    if (t.input != YK_NONE) {
        *angle = without_turns(*angle + (double)t.sense * q[t.input]);
        *rate += (double)t.sense * v[t.input];
    }
    angles->w[k] = *rate;
    if (t.fork != YK_NONE) angles->fork_angle[t.fork] = *angle;
}

static void find_sines(double *block, size_t n, double *s, double *c)
{
    size_t lanes = n < WIDTH ? n : (n + WIDTH - 1) / WIDTH * WIDTH;
    for (size_t k = n; k < lanes; k++) block[k] = 0;
    yk_sincos_lanes(block, s, c, lanes);
}

// Finds the angles of few links, and their sines one by one: a call for all of them would cost more.
static void find_few(const YkTreeAngles *angles, const double *q, const double *v)
{
    double block[FEW] = {0}, angle = 0, rate = 0; // of the previous link
    uint64_t far = 0;
    size_t n = angles->count - 1;
    for (size_t k = 0; k < n; k++) {
        step_out(angles, k + 1, q, v, &angle, &rate);
        block[k] = angle;
        far |= sincos_far_bits(angle);
    }
    double *s = angles->s + 1, *c = angles->c + 1;
    if (sincos_is_far(far))
        for (size_t k = 0; k < n; k++) yk_sincos(block[k], &s[k], &c[k]);
    else
        for (size_t k = 0; k < n; k++) sincos_near(block[k], &s[k], &c[k]);
}

void yk_tree_angles_find(const YkTreeAngles *angles, const double *q, const double *v)
{
    if (angles->count - 1 <= FEW) {
        find_few(angles, q, v);
        return;
    }
    double block[BLOCK], angle = 0, rate = 0; // of the previous link
    for (size_t from = 1; from < angles->count; from += BLOCK) {
        size_t n = angles->count - from < BLOCK ? angles->count - from : BLOCK;
        for (size_t k = from; k < from + n; k++) {
            step_out(angles, k, q, v, &angle, &rate);
            block[k - from] = angle;
        }
        find_sines(block, n, angles->s + from, angles->c + from);
    }
}
