// Computes one block's velocities and accelerations from the determinant of its position: the formulas of
// solve/kernels*.
#include "program/program.h"

// A sum that turns with an unknown: its rate and acceleration in the unknown's axes.
typedef struct Arm {
    YkRefVec rate, accel;
} Arm;

static Arm arm_of(YkProgram *p, const YkSum *sum, const YkRates *r, const YkRates *s)
{
    Arm arm = {.rate = yk_program_sum_rate(p, sum, r)};
    arm.accel = s ? yk_program_sum_accel(p, sum, r, s) : yk_graph_vec_number(&p->graph, 0, 0);
    return arm;
}

// Returns (U'' + 2 w i U') e.
static YkRefVec swing(YkGraph *g, Arm arm, YkRefVec e, YkRef w)
{
    YkRef twice = yk_graph_multiply(g, yk_graph_number(g, 2), w);
    YkRefVec coriolis = yk_graph_vec_scale(g, twice, yk_graph_vec_quarter(g, arm.rate));
    return yk_graph_vec_multiply(g, yk_graph_vec_add(g, arm.accel, coriolis), e);
}

// Returns (d e)'' without d'': the part of the acceleration that comes from the turning of the line.
static YkRefVec drift(YkGraph *g, YkRefVec e, YkRef d, YkRef v, YkRef spin, YkRef spin_rate)
{
    YkRef two = yk_graph_number(g, 2), twice = yk_graph_multiply(g, two, yk_graph_multiply(g, v, spin));
    YkRef across = yk_graph_add(g, yk_graph_multiply(g, d, spin_rate), twice);
    YkRef inward = yk_graph_multiply(g, d, yk_graph_multiply(g, spin, spin));
    YkRefVec sideways = yk_graph_vec_scale(g, across, yk_graph_vec_quarter(g, e));
    return yk_graph_vec_subtract(g, sideways, yk_graph_vec_scale(g, inward, e));
}

static void rates_rrr(YkProgram *p, const YkBlock *b, const YkPlaced *at, YkRates *r, YkRates *s)
{
    YkGraph *g = &p->graph;
    int32_t o1 = b->column[0].index, o2 = b->column[1].index;
    Arm U = arm_of(p, &b->aside->arm[0], r, s), W = arm_of(p, &b->aside->arm[1], r, s);
    YkRates *target = s ? s : r;
    YkRefVec G;
    if (!s) {
        G = yk_program_sum_rate(p, &b->known, r);
        G = yk_graph_vec_add(g, G, yk_graph_vec_multiply(g, U.rate, at->e[0]));
        G = yk_graph_vec_add(g, G, yk_graph_vec_multiply(g, W.rate, at->e[1]));
    } else {
        YkRef w1 = r->turn[o1], w2 = r->turn[o2];
        G = yk_program_sum_accel(p, &b->known, r, s);
        G = yk_graph_vec_subtract(g, G, yk_graph_vec_scale(g, yk_graph_multiply(g, w1, w1), at->p));
        G = yk_graph_vec_subtract(g, G, yk_graph_vec_scale(g, yk_graph_multiply(g, w2, w2), at->q));
        G = yk_graph_vec_add(g, G, swing(g, U, at->e[0], w1));
        G = yk_graph_vec_add(g, G, swing(g, W, at->e[1], w2));
    }
    target->turn[o1] = yk_graph_minus(g, yk_graph_multiply(g, yk_graph_dot(g, G, at->q), at->inverse));
    target->turn[o2] = yk_graph_multiply(g, yk_graph_dot(g, G, at->p), at->inverse);
}

static void rates_rrp(YkProgram *p, const YkBlock *b, const YkPlaced *at, YkRates *r, YkRates *s)
{
    YkGraph *g = &p->graph;
    int32_t o = b->column[0].index, slide = b->column[1].index, line = b->line_slot[0];
    YkRef d = p->distance[slide], spin = r->turn[line];
    Arm W = arm_of(p, &b->aside->arm[0], r, s);
    YkRefVec e = at->e[0], G;
    YkRates *target = s ? s : r;
    if (!s) {
        G = yk_program_sum_rate(p, &b->known, r);
        G = yk_graph_vec_add(g, G, yk_graph_vec_multiply(g, W.rate, at->e[1]));
        YkRef speed = yk_graph_multiply(g, d, spin);
        G = yk_graph_vec_add(g, G, yk_graph_vec_scale(g, speed, yk_graph_vec_quarter(g, e)));
    } else {
        YkRef w = r->turn[o];
        G = yk_program_sum_accel(p, &b->known, r, s);
        G = yk_graph_vec_subtract(g, G, yk_graph_vec_scale(g, yk_graph_multiply(g, w, w), at->q));
        G = yk_graph_vec_add(g, G, swing(g, W, at->e[1], w));
        G = yk_graph_vec_add(g, G, drift(g, e, d, r->slide[slide], spin, s->turn[line]));
    }
    target->turn[o] = yk_graph_multiply(g, yk_graph_cross(g, e, G), at->inverse);
    target->slide[slide] = yk_graph_multiply(g, yk_graph_dot(g, at->q, G), at->inverse);
}

// A line through the pin that is fixed in the turning axes: K = -d e.
static void rates_radial(YkProgram *p, const YkBlock *b, const YkPlaced *at, YkRates *r, YkRates *s)
{
    YkGraph *g = &p->graph;
    int32_t o = b->column[0].index, slide = b->column[1].index;
    YkRates *target = s ? s : r;
    YkRefVec G = s ? yk_program_sum_accel(p, &b->known, r, s) : yk_program_sum_rate(p, &b->known, r);
    YkRef across = yk_graph_cross(g, G, at->e[0]), inward = yk_graph_minus(g, yk_graph_dot(g, G, at->e[0]));
    if (s) {
        YkRef w = r->turn[o], v = r->slide[slide];
        YkRef two = yk_graph_number(g, 2), coriolis = yk_graph_multiply(g, two, yk_graph_multiply(g, w, v));
        across = yk_graph_subtract(g, across, coriolis);
        inward = yk_graph_add(g, inward, yk_graph_multiply(g, p->distance[slide], yk_graph_multiply(g, w, w)));
    }
    target->turn[o] = yk_graph_multiply(g, across, at->inverse);
    target->slide[slide] = inward;
}

static void rates_rpr(YkProgram *p, const YkBlock *b, const YkPlaced *at, YkRates *r, YkRates *s)
{
    YkGraph *g = &p->graph;
    int32_t o = b->column[0].index, slide = b->column[1].index, inner = b->line_slot[0];
    if (at->passes_pin && inner == 0 && b->aside->arm[0].count == 0) {
        rates_radial(p, b, at, r, s);
        return;
    }
    YkRef d = p->distance[slide], spin = r->turn[inner];
    Arm C = arm_of(p, &b->aside->arm[0], r, s);
    YkRefVec e = at->e[0], ie = yk_graph_vec_quarter(g, e), K = at->known, G;
    YkRefVec known = yk_graph_vec_multiply(g, C.rate, at->e[1]); // of the turning axes' (C + d f)', all but d' e
    known = yk_graph_vec_add(g, known, yk_graph_vec_scale(g, yk_graph_multiply(g, d, spin), ie));
    YkRates *target = s ? s : r;
    if (!s) {
        G = yk_graph_vec_add(g, yk_program_sum_rate(p, &b->known, r), known);
    } else {
        YkRef w = r->turn[o], v = r->slide[slide], two = yk_graph_number(g, 2);
        G = yk_program_sum_accel(p, &b->known, r, s);
        G = yk_graph_vec_add(g, G, yk_graph_vec_scale(g, yk_graph_multiply(g, two, yk_graph_multiply(g, w, v)), ie));
        G = yk_graph_vec_add(g, G, yk_graph_vec_scale(g, yk_graph_multiply(g, w, w), K));
        YkRef twice = yk_graph_multiply(g, two, w);
        G = yk_graph_vec_add(g, G, yk_graph_vec_scale(g, twice, yk_graph_vec_quarter(g, known)));
        G = yk_graph_vec_add(g, G, yk_graph_vec_multiply(g, C.accel, at->e[1]));
        G = yk_graph_vec_add(g, G, drift(g, e, d, v, spin, s->turn[inner]));
    }
    target->turn[o] = yk_graph_multiply(g, yk_graph_cross(g, G, e), at->inverse);
    target->slide[slide] = yk_graph_multiply(g, yk_graph_dot(g, G, K), at->inverse);
}

static void rates_pp(YkProgram *p, const YkBlock *b, const YkPlaced *at, YkRates *r, YkRates *s)
{
    YkGraph *g = &p->graph;
    YkRates *target = s ? s : r;
    YkRefVec G = s ? yk_program_sum_accel(p, &b->known, r, s) : yk_program_sum_rate(p, &b->known, r);
    for (int k = 0; k < 2; k++) {
        int32_t slide = b->column[k].index, line = b->line_slot[k];
        YkRef d = p->distance[slide], spin = r->turn[line];
        YkRef speed = yk_graph_multiply(g, d, spin);
        YkRefVec across = yk_graph_vec_scale(g, speed, yk_graph_vec_quarter(g, at->e[k]));
        G = yk_graph_vec_add(g, G, s ? drift(g, at->e[k], d, r->slide[slide], spin, s->turn[line]) : across);
    }
    YkRef first = yk_graph_multiply(g, yk_graph_cross(g, G, at->e[1]), at->inverse);
    target->slide[b->column[0].index] = yk_graph_minus(g, first);
    target->slide[b->column[1].index] = yk_graph_multiply(g, yk_graph_cross(g, G, at->e[0]), at->inverse);
}

// Loops with one unknown: takes the component along its column.
static void rates_redundant(YkProgram *p, const YkBlock *b, const YkPlaced *at, YkRates *r, YkRates *s)
{
    YkGraph *g = &p->graph;
    if (b->kind == YK_BLOCK_CHECK) return;
    int32_t index = b->column[0].index;
    YkRates *target = s ? s : r;
    YkRefVec G = s ? yk_program_sum_accel(p, &b->known, r, s) : yk_program_sum_rate(p, &b->known, r);
    if (b->column[0].is_distance) { // e is a unit vector: dot(e, e') = 0, dot(e, e'') = -w^2
        YkRef spin = r->turn[b->line_slot[0]], rate = yk_graph_minus(g, yk_graph_dot(g, G, at->e[0]));
        YkRef inward = yk_graph_multiply(g, p->distance[index], yk_graph_multiply(g, spin, spin));
        target->slide[index] = s ? yk_graph_add(g, inward, rate) : rate;
        return;
    }
    Arm U = arm_of(p, &b->aside->arm[0], r, s);
    YkRefVec own = s ? swing(g, U, at->e[0], r->turn[index]) : yk_graph_vec_multiply(g, U.rate, at->e[0]);
    G = yk_graph_vec_add(g, G, own);
    YkRef top = yk_graph_cross(g, at->p, G);
    target->turn[index] = yk_graph_minus(g, yk_graph_divide(g, top, yk_graph_dot(g, at->p, at->p)));
}

// Returns J rates = -(rate of the loops' known parts); s: with the unknowns' velocities, for second derivatives.
static YkRefVec loop_rate(YkProgram *p, const YkSum *sum, const YkRates *r, const YkRates *s)
{
    return s ? yk_program_sum_accel(p, sum, r, s) : yk_program_sum_rate(p, sum, r);
}

static void rates_group(YkProgram *p, const YkBlock *b, const YkPlaced *at, YkRates *r, YkRates *s)
{
    YkGraph *g = &p->graph;
    size_t n = b->column_count;
    const YkColumn *columns = p->mech->group_columns + b->first_column;
    YkRates *target = s ? s : r;
    YkRef *system = YK_NEW(p->arena, YkRef, n * (n + 1));
    if (!system) {
        p->failed = true;
        return;
    }
    // While the unknowns' rates are 0, an orientation tied to them turns as relative to its root.
    for (size_t o = 1; o < p->mech->orientation_count; o++) {
        int32_t root = p->mech->group_root[o], relative = p->mech->relative_slot[o];
        for (size_t k = 0; k < n; k++) {
            if (columns[k].is_distance || columns[k].index != root || relative == 0) continue;
            YkRef own = target->turn[relative];
            target->turn[o] = own;
            p->unit[o] = yk_graph_vec_multiply(g, p->unit[root], p->unit[relative]);
            if (s) r->turn[o] = yk_graph_add(g, r->turn[root], r->turn[relative]);
        }
    }
    for (uint32_t l = 0; l < b->loop_count; l++) {
        YkRefVec known = loop_rate(p, &p->mech->group_loops[b->first_loop + l], r, s);
        for (size_t k = 0; k < n; k++) {
            system[2 * l * (n + 1) + k] = at->at[2 * l * n + k];
            system[(2 * l + 1) * (n + 1) + k] = at->at[(2 * l + 1) * n + k];
        }
        system[2 * l * (n + 1) + n] = yk_graph_minus(g, known.x);
        system[(2 * l + 1) * (n + 1) + n] = yk_graph_minus(g, known.y);
    }
    for (size_t row = 2 * (size_t)b->loop_count; row < n; row++) { // gears, racks, belts
        int32_t relation = p->mech->group_relations[b->first_relation + row - 2 * (size_t)b->loop_count];
        for (size_t k = 0; k < n; k++) system[row * (n + 1) + k] = at->at[row * n + k];
        system[row * (n + 1) + n] = yk_graph_minus(g, yk_program_relation_rate(p, (size_t)relation, r, s));
    }
    int32_t call = yk_graph_call(g, (YkCall){.kind = YK_CALL_SOLVE,
                                             .n = (int32_t)n,
                                             .m = 1,
                                             .arguments = system,
                                             .argument_count = n * (n + 1),
                                             .result_count = n * (n + 1) + 1,
                                             .name = at->name});
    for (size_t k = 0; k < n; k++) {
        YkRef rate = yk_graph_result(g, call, k * (n + 1) + n);
        *(columns[k].is_distance ? &target->slide[columns[k].index] : &target->turn[columns[k].index]) = rate;
    }
    if (!s) yk_program_group_arguments(p, b, r);
}

void yk_program_block_rates(YkProgram *p, size_t index, YkRates *r, YkRates *s)
{
    const YkBlock *b = &p->mech->blocks[index];
    const YkPlaced *at = &p->placed[index];
    switch (b->kind) {
    case YK_BLOCK_RRR:
        rates_rrr(p, b, at, r, s);
        break;
    case YK_BLOCK_RRP:
        rates_rrp(p, b, at, r, s);
        break;
    case YK_BLOCK_RPR:
        rates_rpr(p, b, at, r, s);
        break;
    case YK_BLOCK_PP:
        rates_pp(p, b, at, r, s);
        break;
    case YK_BLOCK_GROUP:
        rates_group(p, b, at, r, s);
        break;
    default:
        rates_redundant(p, b, at, r, s);
        break;
    }
}
