// Sums of arms, and their first and second derivatives.
#include "program/program.h"

// Returns a term's vector in the world without its distance, and that distance (-1: none).
static YkRefVec turned(YkProgram *p, size_t index)
{
    const YkTerm *term = &p->mech->terms[index];
    return yk_graph_vec_multiply(&p->graph, p->unit[term->slot], yk_program_term(p, index));
}

YkRefVec yk_program_sum(YkProgram *p, const YkSum *sum)
{
    YkGraph *g = &p->graph;
    YkRefVec total = yk_program_constant(p, sum); // the constant comes after the terms
    if (sum->plus != YK_NONE) total = yk_graph_vec_add(g, total, p->node[sum->plus]);
    if (sum->minus != YK_NONE) total = yk_graph_vec_subtract(g, total, p->node[sum->minus]);
    for (uint32_t k = 0; k < sum->count; k++) {
        int32_t distance = p->mech->terms[sum->first + k].distance;
        YkRefVec u = turned(p, sum->first + k);
        total = yk_graph_vec_add(g, total, distance == YK_NONE ? u : yk_graph_vec_scale(g, p->distance[distance], u));
    }
    return total;
}

static YkRefVec add_nodes(YkProgram *p, const YkSum *sum, const YkRates *r)
{
    YkGraph *g = &p->graph;
    YkRefVec total = yk_graph_vec_number(g, 0, 0);
    if (sum->plus != YK_NONE) total = yk_graph_vec_add(g, total, r->node[sum->plus]);
    if (sum->minus != YK_NONE) total = yk_graph_vec_subtract(g, total, r->node[sum->minus]);
    return total;
}

// (d u)' = d' u + d w i u
YkRefVec yk_program_sum_rate(YkProgram *p, const YkSum *sum, const YkRates *r)
{
    YkGraph *g = &p->graph;
    YkRefVec total = add_nodes(p, sum, r);
    for (uint32_t k = 0; k < sum->count; k++) {
        const YkTerm *term = &p->mech->terms[sum->first + k];
        YkRefVec u = turned(p, sum->first + k);
        YkRef across = r->turn[term->slot];
        if (term->distance != YK_NONE) {
            total = yk_graph_vec_add(g, total, yk_graph_vec_scale(g, r->slide[term->distance], u));
            u = yk_graph_vec_scale(g, p->distance[term->distance], u);
        }
        total = yk_graph_vec_add(g, total, yk_graph_vec_scale(g, across, yk_graph_vec_quarter(g, u)));
    }
    return total;
}

// (d u)'' = d'' u + 2 d' w i u + d (a i u - w^2 u)
YkRefVec yk_program_sum_accel(YkProgram *p, const YkSum *sum, const YkRates *r, const YkRates *s)
{
    YkGraph *g = &p->graph;
    YkRefVec total = add_nodes(p, sum, s);
    for (uint32_t k = 0; k < sum->count; k++) {
        const YkTerm *term = &p->mech->terms[sum->first + k];
        YkRefVec u = turned(p, sum->first + k);
        YkRef w = r->turn[term->slot], a = s->turn[term->slot];
        if (term->distance != YK_NONE) {
            YkRef two = yk_graph_number(g, 2), speed = yk_graph_multiply(g, r->slide[term->distance], w),
                  twice = yk_graph_multiply(g, two, speed);
            total = yk_graph_vec_add(g, total, yk_graph_vec_scale(g, s->slide[term->distance], u));
            total = yk_graph_vec_add(g, total, yk_graph_vec_scale(g, twice, yk_graph_vec_quarter(g, u)));
            u = yk_graph_vec_scale(g, p->distance[term->distance], u);
        }
        total = yk_graph_vec_add(g, total, yk_graph_vec_scale(g, a, yk_graph_vec_quarter(g, u)));
        total = yk_graph_vec_subtract(g, total, yk_graph_vec_scale(g, yk_graph_multiply(g, w, w), u));
    }
    return total;
}
