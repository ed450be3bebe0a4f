// Values that can be asked of a pose: coordinates and points with their rates.
#include "program/program.h"

// --- coordinates

YkRef yk_program_coordinate(YkProgram *p, size_t coordinate)
{
    YkGraph *g = &p->graph;
    const YkTreeCoordinate *c = &p->mech->coordinates[coordinate];
    if (c->input != YK_NONE) return p->input[c->input].position;
    if (c->is_distance) return p->distance[c->distance];
    YkRefVec a = p->unit[c->angle.a], b = p->unit[c->angle.b];
    YkRefVec e = yk_graph_vec_multiply(g, b, yk_graph_vec_conjugate(g, a));
    YkRef turned = yk_graph_binary(g, YK_VALUE_ANGLE, e.y, e.x);
    YkRef angle = yk_graph_add(g, turned, yk_program_joint_offset(p, c->joint));
    YkRef near =
        yk_graph_leaf(g, YK_LEAF_POSE, yk_graph_text(&p->graph, "c->%s", p->names.near_coordinate[coordinate]));
    return yk_graph_binary(g, YK_VALUE_NEAREST, angle, near);
}

YkRef yk_program_joint_rate(YkProgram *p, int32_t joint, bool is_distance, const YkRates *rates)
{
    if (is_distance) return rates->slide[p->mech->joint_distance[joint]];
    YkJointAngle angle = yk_joint_angle(p->mech, joint);
    return yk_graph_subtract(&p->graph, rates->turn[angle.b], rates->turn[angle.a]);
}

YkRef yk_program_coordinate_rate(YkProgram *p, size_t coordinate, const YkRates *rates)
{
    const YkTreeCoordinate *c = &p->mech->coordinates[coordinate];
    return yk_program_joint_rate(p, c->joint, c->is_distance, rates);
}

// --- points

static YkRefVec arm_of(YkProgram *p, int32_t body, YkRefVec at)
{
    YkRefVec v = yk_graph_vec_multiply(&p->graph, p->turn_unit[body], at);
    return yk_graph_vec_multiply(&p->graph, p->unit[p->mech->bodies[body].orientation], v);
}

YkRefVec yk_program_at(YkProgram *p, int32_t body, YkRefVec at)
{
    YkRefVec origin = yk_program_sum(p, &p->mech->bodies[body].origin);
    return yk_graph_vec_add(&p->graph, origin, arm_of(p, body, at));
}

YkRefVec yk_program_at_rate(YkProgram *p, int32_t body, YkRefVec at, const YkRates *r)
{
    YkGraph *g = &p->graph;
    YkRefVec across = yk_graph_vec_quarter(g, arm_of(p, body, at));
    YkRefVec origin = yk_program_sum_rate(p, &p->mech->bodies[body].origin, r);
    return yk_graph_vec_add(g, origin, yk_graph_vec_scale(g, r->turn[p->mech->bodies[body].orientation], across));
}

YkRefVec yk_program_at_accel(YkProgram *p, int32_t body, YkRefVec at, const YkRates *r, const YkRates *s)
{
    YkGraph *g = &p->graph;
    YkRefVec arm = arm_of(p, body, at);
    YkRef w = r->turn[p->mech->bodies[body].orientation], a = s->turn[p->mech->bodies[body].orientation];
    YkRefVec across = yk_graph_vec_scale(g, a, yk_graph_vec_quarter(g, arm));
    YkRefVec own = yk_graph_vec_subtract(g, across, yk_graph_vec_scale(g, yk_graph_multiply(g, w, w), arm));
    return yk_graph_vec_add(g, yk_program_sum_accel(p, &p->mech->bodies[body].origin, r, s), own);
}
