// Geared five-bars for tests: a chain of four links with wheels on the second and the fourth, and how many of its poses
// a fine walk along the five-bar without its gear finds, by closed form.
#ifndef TESTS_CONFIGURATIONS_GEARED_CHAIN_H
#define TESTS_CONFIGURATIONS_GEARED_CHAIN_H
#include "check.h"
#include "solve/machine.h"

enum { A, B, C, D, LINKS, STEPS = 20000 };

// Links of a chain from (0, 0), with their lengths and angles, and the teeth of the wheels on the second and the
// fourth.
typedef struct Chain {
    double length[LINKS], angle[LINKS];
    int teeth[2];
    double turned; // of the first link, from its angle
} Chain;

static YkVec end_of(const Chain *c)
{
    YkVec end = {0, 0};
    for (int k = 0; k < LINKS; k++) end = yk_add(end, yk_scale(c->length[k], yk_unit(c->angle[k])));
    return end;
}

static Machine machine_of(const Chain *c)
{
    char text[2000];
    YkVec end = end_of(c);
    snprintf(text, sizeof text,
             "bodies:\n  ground: {points: {A: [0, 0], E: [%.17g, %.17g]}}\n  a: {points: {A: [0, 0], B: [%.17g, 0]}}\n"
             "  b: {points: {C: [0, 0], B: [-%.17g, 0]}}\n  c: {points: {C: [0, 0], D: [%.17g, 0]}}\n"
             "  d: {points: {D: [0, 0], E: [%.17g, 0]}}\njoints:\n  A: {pin: [ground, a], angle: t1}\n"
             "  B: {pin: [a, b], angle: t2}\n  C: {pin: [b, c], angle: t3}\n  D: {pin: [c, d], angle: t4}\n"
             "  E: {pin: [ground, d]}\ngears: {g: {mesh: [b, d], teeth: [%d, %d], carrier: c}}\n"
             "drives: {t1: %.17g}\nstart: {t2: %.17g, t3: %.17g, t4: %.17g}\n",
             end.x, end.y, c->length[A], c->length[B], c->length[C], c->length[D], c->teeth[0], c->teeth[1],
             c->angle[A], c->angle[B] - c->angle[A], c->angle[C] - c->angle[B], c->angle[D] - c->angle[C]);
    return machine_parse_with(text, NULL, 0);
}

// Returns by how much the wheels have rolled off on each other since the chain's own pose, in the least common turn.
static double roll(const Chain *c, double b, double middle, double d)
{
    int divisor = c->teeth[0], other = c->teeth[1];
    while (other != 0) {
        int rest = divisor % other;
        divisor = other;
        other = rest;
    }
    double p = c->teeth[0] / divisor, q = c->teeth[1] / divisor;
    return p * (b - c->angle[B]) + q * (d - c->angle[D]) - (p + q) * (middle - c->angle[C]);
}

// Returns the roll where the third link has an angle, on a branch of the two links beside it; false where they do not
// close.
static bool roll_at(const Chain *c, double middle, int branch, double *rolled)
{
    YkVec crank = yk_scale(c->length[A], yk_unit(c->angle[A] + c->turned)),
          link = yk_scale(c->length[C], yk_unit(middle));
    YkVec way = yk_sub(yk_sub(end_of(c), crank), link);
    double far = hypot(way.x, way.y), b = c->length[B], d = c->length[D];
    double cosine = (far * far + b * b - d * d) / (2 * far * b);
    if (!(fabs(cosine) <= 1)) return false;
    double angle = atan2(way.y, way.x) + branch * acos(cosine);
    YkVec rest = yk_sub(way, yk_scale(b, yk_unit(angle)));
    *rolled = roll(c, angle, middle, atan2(rest.y, rest.x));
    return true;
}

static size_t meets_between(double from, double to) // a whole turn of the wheels, less than half of one apart
{
    return cos(from) > 0 && cos(to) > 0 && (sin(from) > 0) != (sin(to) > 0);
}

static size_t count_along(const Chain *c)
{
    size_t count = 0;
    for (int k = 0; k < STEPS; k++) {
        double from[2], to[2], at = 2 * YK_PI * k / STEPS, next = 2 * YK_PI * (k + 1) / STEPS;
        bool here = roll_at(c, at, 1, &from[0]) && roll_at(c, at, -1, &from[1]);
        bool there = roll_at(c, next, 1, &to[0]) && roll_at(c, next, -1, &to[1]);
        if (here && there) count += meets_between(from[0], to[0]) + meets_between(from[1], to[1]);
        if (here && !there) count += meets_between(from[0], from[1]); // the branches meet between
        if (!here && there) count += meets_between(to[0], to[1]);
    }
    return count;
}

#endif
