// Machines derived by hand in the ring, for its tests and timings: bodies with mass, inertia, centre and rate of
// turning.
#ifndef TESTS_RING_MACHINES_H
#define TESTS_RING_MACHINES_H
#include <stdio.h>
#include "ring/ring_check.h"

enum { COORDINATES_MAX = 24, BODIES_MAX = 24, LOOPS_MAX = 2 };

typedef struct Body {
    Element mass, inertia, centre, rate; // inertia NULL: it does not turn
} Body;

typedef struct Machine {
    YkRing *ring;
    int count, bodies, loops;
    int32_t q[COORDINATES_MAX], u[COORDINATES_MAX]; // coordinates and rates; the acceleration is u + 1
    Body body[BODIES_MAX];
    Element loop[LOOPS_MAX];
    Element gravity; // g, downwards along -y
} Machine;

static inline Element machine_symbol(YkRing *ring, const char *letters, int index, YkRingClass kind)
{
    char name[40];
    snprintf(name, sizeof name, "%s%d", letters, index);
    int32_t found = yk_ring_find(ring, name);
    return yk_ring_of(ring, found >= 0 ? found : yk_ring_symbol(ring, name, kind));
}

static inline void machine_coordinate(Machine *m, const char *name, bool angle)
{
    m->q[m->count] = angle ? yk_ring_angle(m->ring, name) : yk_ring_symbol(m->ring, name, YK_RING_COORDINATE);
    m->count++;
}

static inline void machine_rates(Machine *m)
{
    for (int i = 0; i < m->count; i++) m->u[i] = yk_ring_rates(m->ring, m->q[i]);
    m->gravity = yk_ring_of(m->ring, yk_ring_symbol(m->ring, "g", YK_RING_GRAVITY));
}

// A chain of n links hanging from the ground, as the books draw a double pendulum: theta = 0 points down. In joint
// angles or in body angles.
static inline Machine chain(int n, bool joint_angles)
{
    Machine m = {.ring = yk_ring_new()};
    YkRing *r = m.ring;
    char name[40];
    for (int i = 1; i <= n; i++) {
        machine_symbol(r, "m", i, YK_RING_MASS);
        machine_symbol(r, "I", i, YK_RING_INERTIA);
        machine_symbol(r, "l", i, YK_RING_CONSTANT);
        machine_symbol(r, "lc", i, YK_RING_CONSTANT);
    }
    for (int i = 1; i <= n; i++) {
        snprintf(name, sizeof name, "theta%d", i);
        machine_coordinate(&m, name, true);
    }
    machine_rates(&m);
    Element down = yk_ring_negate(r, yk_ring_i(r)), direction = down, pin = yk_ring_rational(r, 0, 1), rate = pin;
    for (int i = 0; i < n; i++) {
        Element unit = yk_ring_unit(r, m.q[i]), turning = yk_ring_of(r, m.u[i]);
        direction = yk_ring_multiply(r, joint_angles ? direction : down, unit);
        rate = joint_angles ? yk_ring_add(r, rate, turning) : turning;
        Element to_centre = yk_ring_multiply(r, machine_symbol(r, "lc", i + 1, YK_RING_CONSTANT), direction);
        m.body[m.bodies++] =
            (Body){machine_symbol(r, "m", i + 1, YK_RING_MASS), machine_symbol(r, "I", i + 1, YK_RING_INERTIA),
                   yk_ring_add(r, pin, to_centre), rate};
        pin = yk_ring_add(r, pin, yk_ring_multiply(r, machine_symbol(r, "l", i + 1, YK_RING_CONSTANT), direction));
    }
    return m;
}

// A uniform rod number k from `start` along `direction`.
static inline void add_rod(Machine *m, int k, Element start, Element direction, Element rate)
{
    YkRing *r = m->ring;
    Element mass = machine_symbol(r, "m", k, YK_RING_MASS), l = machine_symbol(r, "l", k, YK_RING_CONSTANT);
    Element inertia = yk_ring_scale(r, yk_ring_multiply(r, mass, yk_ring_multiply(r, l, l)), 1, 12);
    Element half = yk_ring_scale(r, yk_ring_multiply(r, l, direction), 1, 2);
    m->body[m->bodies++] = (Body){mass, inertia, yk_ring_add(r, start, half), rate};
}

// The toggle linkage: crank and coupler in joint angles, rocker, rod, slider; two loops.
static inline Machine toggle(void)
{
    Machine m = {.ring = yk_ring_new()};
    YkRing *r = m.ring;
    for (int i = 1; i <= 5; i++) machine_symbol(r, "m", i, YK_RING_MASS);
    for (int i = 1; i <= 4; i++) machine_symbol(r, "l", i, YK_RING_CONSTANT);
    Element x = yk_ring_of(r, yk_ring_symbol(r, "a0x", YK_RING_CONSTANT)),
            y = yk_ring_of(r, yk_ring_symbol(r, "a0y", YK_RING_CONSTANT));
    for (int i = 1; i <= 4; i++)
        machine_coordinate(&m, (const char *[]){"theta1", "theta2", "theta3", "theta4"}[i - 1], true);
    machine_coordinate(&m, "d5", false);
    machine_rates(&m);
    Element e1 = yk_ring_unit(r, m.q[0]), e2 = yk_ring_multiply(r, e1, yk_ring_unit(r, m.q[1])),
            e3 = yk_ring_unit(r, m.q[2]);
    Element e4 = yk_ring_multiply(r, e3, yk_ring_unit(r, m.q[3])), u1 = yk_ring_of(r, m.u[0]),
            u3 = yk_ring_of(r, m.u[2]);
    Element zero = yk_ring_rational(r, 0, 1), d5 = yk_ring_of(r, m.q[4]);
    Element A0 = yk_ring_subtract(r, yk_ring_multiply(r, yk_ring_i(r), y), x);
    Element A = yk_ring_add(r, A0, yk_ring_multiply(r, machine_symbol(r, "l", 1, YK_RING_CONSTANT), e1));
    Element J = yk_ring_multiply(r, machine_symbol(r, "l", 3, YK_RING_CONSTANT), e3);
    add_rod(&m, 1, A0, e1, u1);
    add_rod(&m, 2, A, e2, yk_ring_add(r, u1, yk_ring_of(r, m.u[1])));
    add_rod(&m, 3, zero, e3, u3);
    add_rod(&m, 4, J, e4, yk_ring_add(r, u3, yk_ring_of(r, m.u[3])));
    m.body[m.bodies++] = (Body){machine_symbol(r, "m", 5, YK_RING_MASS), NULL, d5, NULL};
    Element J2 = yk_ring_add(r, A, yk_ring_multiply(r, machine_symbol(r, "l", 2, YK_RING_CONSTANT), e2));
    Element B = yk_ring_add(r, J, yk_ring_multiply(r, machine_symbol(r, "l", 4, YK_RING_CONSTANT), e4));
    m.loop[0] = yk_ring_subtract(r, J2, J);
    m.loop[1] = yk_ring_subtract(r, B, d5);
    m.loops = 2;
    return m;
}

// T and V.
static inline void energies(const Machine *m, Element *kinetic, Element *potential)
{
    YkRing *r = m->ring;
    Element T[2 * BODIES_MAX], V[BODIES_MAX];
    size_t count = 0;
    for (int i = 0; i < m->bodies; i++) {
        const Body *b = &m->body[i];
        Element v = yk_ring_time_derivative(r, b->centre);
        T[count++] = yk_ring_multiply(r, b->mass, yk_ring_dot(r, v, v));
        if (b->inertia) T[count++] = yk_ring_multiply(r, b->inertia, yk_ring_multiply(r, b->rate, b->rate));
        V[i] = yk_ring_product(r, (Element[]){b->mass, m->gravity, yk_ring_imaginary(r, b->centre)}, 3);
    }
    *kinetic = yk_ring_scale(r, yk_ring_sum(r, T, count), 1, 2);
    *potential = yk_ring_sum(r, V, (size_t)m->bodies);
}

// d/dt dT/du - dT/dq + dV/dq
static inline Element lagrange(const Machine *m, Element T, Element V, int i)
{
    YkRing *r = m->ring;
    Element momentum = yk_ring_time_derivative(r, yk_ring_partial(r, T, m->u[i]));
    return yk_ring_add(r, yk_ring_subtract(r, momentum, yk_ring_partial(r, T, m->q[i])),
                       yk_ring_partial(r, V, m->q[i]));
}

// Newton and Euler, projected on the partial velocities: sum of (m a - weight) . dc/dq + I alpha dw/du. Never forms T.
static inline Element newton_euler(const Machine *m, int i)
{
    YkRing *r = m->ring;
    Element sum = yk_ring_rational(r, 0, 1), up = yk_ring_i(r);
    for (int k = 0; k < m->bodies; k++) {
        const Body *b = &m->body[k];
        Element c_q = yk_ring_partial(r, b->centre, m->q[i]);
        Element a = yk_ring_time_derivative(r, yk_ring_time_derivative(r, b->centre));
        Element force = yk_ring_multiply(r, b->mass, yk_ring_add(r, a, yk_ring_multiply(r, up, m->gravity)));
        sum = yk_ring_add(r, sum, yk_ring_dot(r, c_q, force));
        if (!b->inertia) continue;
        Element moment = yk_ring_multiply(r, b->inertia, yk_ring_time_derivative(r, b->rate));
        sum = yk_ring_add(r, sum, yk_ring_multiply(r, yk_ring_partial(r, b->rate, m->u[i]), moment));
    }
    return sum;
}
#endif
