// The positions and velocities of points on which loads pull, in lane 0 of a space, directly from the sums.
#ifndef LOADS_POINT_H
#define LOADS_POINT_H
#include "loads/loads.h"

typedef struct YkLoadPoint {
    YkVec arm; // from the body's reference point
    YkVec at, velocity;
    YkVec turn; // of the body's orientation, and its rate
    double w;
} YkLoadPoint;

// Adds (d) v e^(i slot) and its rate.
static inline void yk_load_point_add_term(YkLoadPoint *p, const YkSpace *space, const YkTerm *term)
{
    YkVec u = term->v;
    double w = 0;
    if (term->slot != 0) {
        YkTurn t = yk_space_turn(space, term->slot);
        u = yk_mul(yk_vec(t.c[0], t.s[0]), u);
        w = t.w[0];
    }
    if (term->distance != YK_NONE) {
        YkSlide s = yk_space_slide(space, term->distance);
        p->velocity = yk_add(p->velocity, yk_scale(s.v[0], u));
        u = yk_scale(s.d[0], u);
    }
    p->at = yk_add(p->at, u);
    p->velocity = yk_add(p->velocity, yk_scale(w, yk_quarter(u)));
}

static inline void yk_load_point_add_node(YkLoadPoint *p, const YkSpace *space, int32_t node, double sign)
{
    if (node == YK_NONE) return;
    YkPlane plane = yk_space_plane(space, node);
    p->at = yk_add(p->at, yk_scale(sign, yk_vec(plane.x[0], plane.y[0])));
    p->velocity = yk_add(p->velocity, yk_scale(sign, yk_vec(plane.vx[0], plane.vy[0])));
}

// Prepares the point `at`, given in the body's axes.
static inline YkLoadEnd yk_load_end(const YkMechanism *mech, int32_t body, YkVec at)
{
    YkVec turn = mech->bodies[body].turn_unit, reference = yk_reference_point(mech->model, (size_t)body);
    return (YkLoadEnd){body, yk_mul(turn, at), yk_mul(turn, yk_sub(at, reference))};
}

static inline YkLoadPoint yk_load_point(const YkMechanism *mech, const YkSpace *space, const YkLoadEnd *end)
{
    const YkPlacing *placing = &mech->bodies[end->body];
    const YkSum *origin = &placing->origin;
    YkLoadPoint p = {.at = origin->constant, .turn = {1, 0}};
    yk_load_point_add_node(&p, space, origin->plus, 1);
    yk_load_point_add_node(&p, space, origin->minus, -1);
    for (uint32_t k = 0; k < origin->count; k++) yk_load_point_add_term(&p, space, &mech->terms[origin->first + k]);
    if (placing->orientation != 0) {
        YkTurn t = yk_space_turn(space, placing->orientation);
        p.turn = yk_vec(t.c[0], t.s[0]);
        p.w = t.w[0];
    }
    YkVec out = yk_mul(p.turn, end->from_origin);
    p.at = yk_add(p.at, out);
    p.velocity = yk_add(p.velocity, yk_scale(p.w, yk_quarter(out)));
    p.arm = yk_mul(p.turn, end->arm);
    return p;
}

#endif
