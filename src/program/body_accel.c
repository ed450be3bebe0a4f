// The acceleration of a body's point, with few operations: arms that turn together are added before they turn, and
// share what their turning does to a unit length.
#include "program/program.h"

// Arms of one orientation: their sum in its axes.
typedef struct Arm {
    int32_t slot;
    YkRefVec along;
} Arm;

typedef struct Arms {
    Arm *arm;
    size_t count;
} Arms;

static void add_arm(YkProgram *p, Arms *arms, int32_t slot, YkRefVec v)
{
    for (Arm *arm = arms->arm; arm < arms->arm + arms->count; arm++)
        if (arm->slot == slot) {
            arm->along = yk_graph_vec_add(&p->graph, arm->along, v);
            return;
        }
    arms->arm[arms->count++] = (Arm){slot, v};
}

// Returns the second derivative of e^(i phi): i a e - w^2 e.
static YkRefVec unit_accel(YkProgram *p, int32_t slot, const YkRates *r, const YkRates *s)
{
    YkGraph *g = &p->graph;
    YkRefVec e = p->unit[slot];
    YkRef a = s->turn[slot], square = yk_graph_multiply(g, r->turn[slot], r->turn[slot]);
    YkRefVec rates = {square, a};
    YkRef toward = yk_graph_dot(g, rates, e), across = yk_graph_cross(g, e, rates);
    return (YkRefVec){yk_graph_minus(g, toward), across};
}

// Returns the acceleration of a distance along a turning line, without d e'': d'' e + 2 d' w i e, times the line.
static YkRefVec sliding_accel(YkProgram *p, const YkTerm *term, YkRefVec line, const YkRates *r, const YkRates *s)
{
    YkGraph *g = &p->graph;
    YkRefVec u = yk_graph_vec_multiply(g, p->unit[term->slot], line);
    YkRef speed = yk_graph_multiply(g, r->slide[term->distance], r->turn[term->slot]);
    YkRef twice = yk_graph_multiply(g, yk_graph_number(g, 2), speed);
    YkRefVec across = yk_graph_vec_scale(g, twice, yk_graph_vec_quarter(g, u));
    YkRefVec along = yk_graph_vec_scale(g, s->slide[term->distance], u);
    return yk_graph_vec_add(g, along, across);
}

YkRefVec yk_program_body_accel(YkProgram *p, int32_t body, YkRefVec at, const YkRates *r, const YkRates *s)
{
    YkGraph *g = &p->graph;
    const YkSum *sum = &p->mech->bodies[body].origin;
    Arms arms = {YK_NEW(p->arena, Arm, sum->count + 2), 0};
    YkRefVec total = yk_graph_vec_number(g, 0, 0);
    if (!arms.arm) {
        p->failed = true;
        return total;
    }
    if (sum->plus != YK_NONE) total = yk_graph_vec_add(g, total, s->node[sum->plus]);
    if (sum->minus != YK_NONE) total = yk_graph_vec_subtract(g, total, s->node[sum->minus]);
    for (uint32_t k = 0; k < sum->count; k++) {
        const YkTerm *term = &p->mech->terms[sum->first + k];
        YkRefVec v = yk_program_term(p, sum->first + k);
        if (term->distance != YK_NONE) {
            total = yk_graph_vec_add(g, total, sliding_accel(p, term, v, r, s));
            v = yk_graph_vec_scale(g, p->distance[term->distance], v);
        }
        add_arm(p, &arms, term->slot, v);
    }
    add_arm(p, &arms, p->mech->bodies[body].orientation, yk_graph_vec_multiply(g, p->turn_unit[body], at));
    for (size_t k = 0; k < arms.count; k++) {
        YkRefVec turning = unit_accel(p, arms.arm[k].slot, r, s);
        total = yk_graph_vec_add(g, total, yk_graph_vec_multiply(g, arms.arm[k].along, turning));
    }
    return total;
}
