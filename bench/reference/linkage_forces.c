// Newton and Euler for two linkages of dyads, as closed forms that the compiler specialises for each: from the last
// dyad, which carries nothing, back to the crank's torque.
#include "linkage_forces.h"
#include <math.h>
#include <string.h>
#include "lanes.h"

#define G 9.81
enum { WIDE = 8, BLOCK = 64 }; // poses in a vector, and in a block; the number of poses is a multiple of a block
typedef double Lanes __attribute__((vector_size(8 * WIDE)));

typedef struct V {
    Lanes x, y;
} V;

ALWAYS Lanes lanes(double k)
{
    return (Lanes){0} + k;
}
ALWAYS Lanes root(Lanes a)
{
    Lanes r;
    for (int k = 0; k < WIDE; k++) r[k] = sqrt(a[k]);
    return r;
}
ALWAYS V vec(Lanes x, Lanes y)
{
    return (V){x, y};
}
ALWAYS V at_rest(double x, double y)
{
    return (V){lanes(x), lanes(y)};
}
ALWAYS V add(V a, V b)
{
    return (V){a.x + b.x, a.y + b.y};
}
ALWAYS V sub(V a, V b)
{
    return (V){a.x - b.x, a.y - b.y};
}
ALWAYS V scale(Lanes k, V a)
{
    return (V){k * a.x, k * a.y};
}
ALWAYS V times(double k, V a)
{
    return (V){k * a.x, k * a.y};
}
ALWAYS V turn(V e, V a)
{
    return (V){e.x * a.x - e.y * a.y, e.x * a.y + e.y * a.x};
}
ALWAYS V turn_back(V e, V a)
{
    return (V){e.x * a.x + e.y * a.y, e.x * a.y - e.y * a.x};
}
ALWAYS Lanes dot(V a, V b)
{
    return a.x * b.x + a.y * b.y;
}
ALWAYS Lanes cross(V a, V b)
{
    return a.x * b.y - a.y * b.x;
}

typedef struct Point { // place, velocity, acceleration
    V p, v, a;
} Point;

typedef struct Link { // unit vector, rate and acceleration of its angle
    V e;
    Lanes w, al;
} Link;

// A point at an arm (world axes) from a point of the same link.
ALWAYS Point at(Point from, Link l, V r)
{
    Lanes w2 = l.w * l.w;
    return (Point){add(from.p, r), add(from.v, scale(l.w, vec(-r.y, r.x))),
                   add(from.a, vec(-l.al * r.y - w2 * r.x, l.al * r.x - w2 * r.y))};
}

typedef struct Dyad {
    Link one, two;
    V arm, other; // of both links, from their outer pins to the pin between them
    Lanes per;    // 1 / their cross product
} Dyad;

// Two links from A and C, whose arms in their own axes are a and c.
ALWAYS Dyad dyad(Point A, V a, Point C, V c, double branch)
{
    Dyad d;
    Lanes a2 = a.x * a.x + a.y * a.y, c2 = c.x * c.x + c.y * c.y;
    V k = sub(C.p, A.p);
    Lanes square = dot(k, k), along = 0.5 * (square + a2 - c2), across = branch * root(square * a2 - along * along);
    Lanes over = 1 / square;
    d.arm = scale(over, vec(k.x * along - k.y * across, k.y * along + k.x * across));
    d.other = sub(d.arm, k);
    d.one.e = scale(1 / a2, turn_back(a, d.arm));
    d.two.e = scale(1 / c2, turn_back(c, d.other));
    d.per = 1 / across; // k x arm = across, and arm x other = arm x (arm - k) = k x arm
    V q = sub(C.v, A.v);
    d.one.w = dot(q, d.other) * d.per, d.two.w = dot(q, d.arm) * d.per;
    q = sub(add(sub(C.a, A.a), scale(d.one.w * d.one.w, d.arm)), scale(d.two.w * d.two.w, d.other));
    d.one.al = dot(q, d.other) * d.per, d.two.al = dot(q, d.arm) * d.per;
    return d;
}

typedef struct Need { // what pins must supply to a link: a force, and a moment about its outer pin
    V force;
    Lanes moment;
} Need;

// For inertia and weight; r: from the outer pin to the centre of mass.
ALWAYS Need inertia(Point pin, Link l, V r, double mass, double about_center, double gravity)
{
    V a = at(pin, l, r).a, force = times(mass, vec(a.x, a.y + gravity));
    return (Need){force, about_center * l.al + cross(r, force)};
}

// Something else pushes on the link.
ALWAYS Need less(Need need, V r, V push)
{
    return (Need){sub(need.force, push), need.moment - cross(r, push)};
}

typedef struct Forces { // on the first link at A, of the second on the first, on the second at C
    V first, between, second;
} Forces;

ALWAYS Forces balance(const Dyad *d, Need one, Need two)
{
    V between = scale(d->per, add(scale(one.moment, d->other), scale(two.moment, d->arm)));
    return (Forces){sub(one.force, between), between, add(two.force, between)};
}

typedef struct Pins { // what the pins transmit, in the order of the header
    V p0, p1, p2, p3, p4, p5, p6, p7, p8, p9;
    Lanes torque;
} Pins;

ALWAYS Lanes lanes_at(const double *from)
{
    Lanes l;
    memcpy(&l, from, sizeof l);
    return l;
}
ALWAYS void put(double *to, Lanes l)
{
    memcpy(to, &l, sizeof l);
}
#define PUT(k, v) put(&out[2 * (k)][i], (v).x), put(&out[2 * (k) + 1][i], (v).y)

static void turns(const double *angle, double *c, double *s)
{
#pragma omp simd
    for (size_t i = 0; i < BLOCK; i++) lane_sincos(angle[i], &s[i], &c[i]);
}

// --- Watt's six-bar

ALWAYS Pins watt(V e, Lanes w, Lanes al)
{
    const V A = at_rest(-3.74, -2.41), B = at_rest(-2.72, 0.91), C = at_rest(1.58, 0.43), D = at_rest(-0.24, 4.01),
            E = at_rest(5.08, 5.31);
    const V F = at_rest(8.14, 3.35), Q = at_rest(7.32, -3.51), c2 = at_rest(-1.38 / 3, 5.35 / 3),
            c5 = at_rest(17.04 / 3, 0.09);
    Pins p = {0};
    Point a = {.p = A}, g = {.p = Q};
    Link crank = {e, w, al};
    V ab = turn(e, sub(B, A));
    Point b = at(a, crank, ab);
    Dyad first = dyad(b, sub(C, B), g, sub(C, Q), 1);
    V bd = turn(first.one.e, sub(D, B)), gf = turn(first.two.e, sub(F, Q));
    Point d = at(b, first.one, bd), f = at(g, first.two, gf);
    Dyad second = dyad(d, sub(E, D), f, sub(E, F), 1);
    Need de = inertia(d, second.one, turn(second.one.e, sub(at_rest(2.42, 4.66), D)), 5, 0.1, G);
    Need ef = inertia(f, second.two, turn(second.two.e, sub(at_rest(6.61, 4.33), F)), 10, 0.2, G);
    Forces outer = balance(&second, de, ef);
    V gp = turn(first.two.e, sub(c5, Q));
    Need bcd = less(inertia(b, first.one, turn(first.one.e, sub(c2, B)), 10, 0.2, G), bd, times(-1, outer.first));
    Need cfg = less(less(inertia(g, first.two, gp, 5, 0.1, G), gp, at_rest(50, 25)), gf, times(-1, outer.second));
    Forces inner = balance(&first, bcd, cfg);
    Need own = less(inertia(a, crank, turn(e, sub(at_rest(-3.23, -0.75), A)), 5, 0.1, G), ab, times(-1, inner.first));
    p.p0 = own.force, p.p1 = inner.first, p.p2 = times(-1, inner.between), p.p3 = outer.first;
    p.p4 = times(-1, outer.between), p.p5 = times(-1, outer.second), p.p6 = inner.second;
    p.torque = own.moment;
    return p;
}

static void watt_block(const double *alpha, const double *rate, const double *accel, double (*out)[BLOCK])
{
    double c[BLOCK], s[BLOCK];
    turns(alpha, c, s);
    for (size_t i = 0; i < BLOCK; i += WIDE) {
        Pins f = watt(vec(lanes_at(c + i), lanes_at(s + i)), lanes_at(rate + i), lanes_at(accel + i));
        PUT(0, f.p0);
        PUT(1, f.p1);
        PUT(2, f.p2);
        PUT(3, f.p3);
        PUT(4, f.p4);
        PUT(5, f.p5);
        PUT(6, f.p6);
        put(&out[WATT_FORCES - 1][i], f.torque);
    }
}

void watt_forces(const double *alpha, const double *rate, const double *accel, double *const *out, size_t n)
{
    double block[WATT_FORCES][BLOCK];
    for (size_t from = 0; from < n; from += BLOCK) {
        watt_block(alpha + from, rate + from, accel + from, block);
        for (size_t k = 0; k < WATT_FORCES; k++) memcpy(out[k] + from, block[k], sizeof block[k]);
    }
}

// --- Andrews' mechanism: no gravity, a spring at K3

ALWAYS Pins andrews(V e, Lanes w, Lanes al)
{
    const V a = at_rest(-.06934, -.00227), b = at_rest(-.03635, .03273), c = at_rest(.014, .072);
    Pins p = {0};
    Point o = {.p = at_rest(0, 0)}, A = {.p = a}, B = {.p = b};
    Link crank = {e, w, al};
    V of = times(.007, e);
    Point f = at(o, crank, of);
    Dyad first = dyad(f, at_rest(-.028, 0), B, at_rest(0, -.035), 1);
    Point E = at(f, first.one, first.arm);
    Dyad second = dyad(A, at_rest(.04, 0), E, at_rest(0, .02), 1),
         third = dyad(A, at_rest(0, -.04), E, at_rest(-.02, 0), -1);
    Need k5 = inertia(A, second.one, turn(second.one.e, at_rest(.02308, .00916)), .0705, 1.169e-5, 0);
    Need k4 = inertia(E, second.two, turn(second.two.e, at_rest(0, .01421)), .00706, 5.667e-7, 0);
    Forces left = balance(&second, k5, k4);
    Need k7 = inertia(A, third.one, turn(third.one.e, at_rest(.00449, -.01228)), .05498, 1.912e-5, 0);
    Need k6 = inertia(E, third.two, turn(third.two.e, at_rest(-.01421, 0)), .00706, 5.667e-7, 0);
    Forces right = balance(&third, k7, k6);
    V bd = turn(first.two.e, at_rest(.02, -.018)), line = sub(c, add(b, bd));
    Lanes length2 = dot(line, line);
    V spring = scale(4530 * (1 - .07785 / root(length2)), line);
    Need k2 = inertia(f, first.one, turn(first.one.e, at_rest(-.0115, 0)), .00365, 4.41e-7, 0);
    Need k3 = inertia(B, first.two, turn(first.two.e, at_rest(.01043, -.01874)), .02373, 5.255e-6, 0);
    k3 = less(less(k3, bd, spring), first.other, times(-1, add(left.second, right.second)));
    Forces inner = balance(&first, k2, k3);
    Need own = less(inertia(o, crank, times(.00092, e), .04325, 2.194e-6, 0), of, times(-1, inner.first));
    p.p0 = own.force, p.p1 = inner.first, p.p2 = inner.second, p.p3 = left.first;
    p.p4 = times(-1, left.between), p.p5 = right.first, p.p6 = times(-1, right.between);
    p.p7 = times(-1, inner.between), p.p8 = times(-1, left.second), p.p9 = times(-1, right.second);
    p.torque = own.moment - .033;
    return p;
}

static void andrews_block(const double *beta, const double *rate, const double *accel, double (*out)[BLOCK])
{
    double c[BLOCK], s[BLOCK];
    turns(beta, c, s);
    for (size_t i = 0; i < BLOCK; i += WIDE) {
        Pins f = andrews(vec(lanes_at(c + i), lanes_at(s + i)), lanes_at(rate + i), lanes_at(accel + i));
        PUT(0, f.p0);
        PUT(1, f.p1);
        PUT(2, f.p2);
        PUT(3, f.p3);
        PUT(4, f.p4);
        PUT(5, f.p5);
        PUT(6, f.p6);
        PUT(7, f.p7);
        PUT(8, f.p8);
        PUT(9, f.p9);
        put(&out[ANDREWS_FORCES - 1][i], f.torque);
    }
}

void andrews_forces(const double *beta, const double *rate, const double *accel, double *const *out, size_t n)
{
    double block[ANDREWS_FORCES][BLOCK];
    for (size_t from = 0; from < n; from += BLOCK) {
        andrews_block(beta + from, rate + from, accel + from, block);
        for (size_t k = 0; k < ANDREWS_FORCES; k++) memcpy(out[k] + from, block[k], sizeof block[k]);
    }
}
