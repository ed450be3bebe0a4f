// One block's position, in closed form or by a call of Newton's method: the formulas of solve/kernels*, where they are
// derived.
#include "code/program.h"
#include "base/problems.h"

static YkRef one(YkDag *g)
{
    return yk_dag_number(g, 1);
}

static YkRef inverse(YkDag *g, YkRef a)
{
    return yk_dag_divide(g, one(g), a);
}

// 1 / a, as a complex number.
static YkRefVec vec_inverse(YkDag *g, YkRefVec a)
{
    if (yk_dag_is_number(g, a.y, 0)) return (YkRefVec){inverse(g, a.x), a.y};
    return yk_dag_vec_scale(g, inverse(g, yk_dag_dot(g, a, a)), yk_dag_vec_conjugate(g, a));
}

static YkRef branch_of(YkProgram *p, size_t block)
{
    return yk_dag_leaf(&p->graph, YK_LEAF_POSE, yk_program_text(p, "c->%s", yk_program_block_name(p, block)));
}

static YkRef not_negative(YkDag *g, YkRef a)
{
    return yk_dag_binary(g, YK_VALUE_LARGEST, a, yk_dag_number(g, 0));
}

// Keeps the least margin. It is no number once a block did not come out finite.
static void keep_margin(YkProgram *p, YkRef margin, YkRef result)
{
    YkDag *g = &p->graph;
    bool is_first = yk_dag_is_number(g, p->margin, 1);
    YkRef least = is_first ? margin : yk_dag_binary(g, YK_VALUE_LEAST, margin, p->margin);
    p->margin = yk_dag_add(g, least, yk_dag_unary(g, YK_VALUE_WITNESS, result));
}

static void set_unit(YkProgram *p, int32_t slot, YkRefVec e)
{
    const char *name = yk_program_slot_name(p, slot);
    p->unit[slot] = e;
    yk_dag_name(&p->graph, e.x, "%s_c", name);
    yk_dag_name(&p->graph, e.y, "%s_s", name);
}

static void set_distance(YkProgram *p, int32_t distance, YkRef d)
{
    p->distance[distance] = yk_dag_name(&p->graph, d, "%s", yk_program_distance_name(p, distance));
}

static void name_vec(YkProgram *p, YkRefVec v, const char *block, const char *what)
{
    yk_dag_name(&p->graph, v.x, "%s_%s_x", block, what);
    yk_dag_name(&p->graph, v.y, "%s_%s_y", block, what);
}

// RRR: two circles meet.
static void place_rrr(YkProgram *p, size_t index, YkPlaced *placed)
{
    YkDag *g = &p->graph;
    const YkBlock *b = &p->mech->blocks[index];
    YkRefVec K = placed->known, U = yk_program_sum(p, &b->arm[0]), W = yk_program_sum(p, &b->arm[1]);
    YkRef U2 = yk_dag_dot(g, U, U), W2 = yk_dag_dot(g, W, W), L2 = yk_dag_dot(g, K, K);
    YkRef u = yk_dag_function(g, YK_SQRT, U2, -1), w = yk_dag_function(g, YK_SQRT, W2, -1);
    YkRef sum = yk_dag_add(g, u, w), difference = yk_dag_subtract(g, u, w);
    YkRef outer = yk_dag_multiply(g, sum, sum), inner = yk_dag_multiply(g, difference, difference);
    YkRef product = yk_dag_multiply(g, sum, difference);
    yk_dag_name(g, L2, "%s_L2", placed->name);
    yk_dag_name(g, outer, "%s_outer", placed->name);
    yk_dag_name(g, inner, "%s_inner", placed->name);
    yk_dag_name(g, product, "%s_product", placed->name);
    YkRef square = yk_dag_multiply(g, yk_dag_subtract(g, outer, L2), yk_dag_subtract(g, L2, inner));
    yk_dag_name(g, square, "%s_square", placed->name);
    YkRef per_root = yk_dag_multiply(g, branch_of(p, index), yk_dag_unary(g, YK_VALUE_PER_ROOT, square));
    YkRef per_L2 = inverse(g, L2), half = yk_dag_multiply(g, yk_dag_number(g, 0.5), per_L2);
    YkRef root = yk_dag_multiply(g, not_negative(g, square), per_root);
    YkRef slope = yk_dag_multiply(g, root, half);
    YkRef first = yk_dag_minus(g, yk_dag_multiply(g, yk_dag_add(g, L2, product), half));
    YkRef second = yk_dag_minus(g, yk_dag_multiply(g, yk_dag_subtract(g, L2, product), half));
    placed->p = yk_dag_vec_multiply(g, K, (YkRefVec){first, slope});
    placed->q = yk_dag_vec_multiply(g, K, (YkRefVec){second, yk_dag_minus(g, slope)});
    name_vec(p, placed->p, placed->name, "p");
    name_vec(p, placed->q, placed->name, "q");
    placed->inverse = yk_dag_multiply(g, yk_dag_number(g, 2), per_root); // 1 / D
    yk_dag_name(g, placed->inverse, "%s_per_D", placed->name);
    placed->e[0] = yk_dag_vec_multiply(g, placed->p, vec_inverse(g, U));
    placed->e[1] = yk_dag_vec_multiply(g, placed->q, vec_inverse(g, W));
    set_unit(p, b->column[0].index, placed->e[0]);
    set_unit(p, b->column[1].index, placed->e[1]);
    YkRef margin =
        yk_dag_multiply(g, square, inverse(g, yk_dag_multiply(g, yk_dag_number(g, 4), yk_dag_multiply(g, U2, W2))));
    YkRef shortness = yk_dag_multiply(g, yk_dag_multiply(g, u, w), per_L2);
    YkRef longer = yk_dag_binary(g, YK_VALUE_LARGEST, shortness, one(g));
    keep_margin(p, yk_dag_choose(g, margin, yk_dag_multiply(g, margin, longer), margin), placed->e[0].x);
}

// RRP: a circle meets a line.
static void place_rrp(YkProgram *p, size_t index, YkPlaced *placed)
{
    YkDag *g = &p->graph;
    const YkBlock *b = &p->mech->blocks[index];
    YkRefVec K = placed->known, W = yk_program_sum(p, &b->arm[0]),
             u = yk_program_line(p, b->column[1].index, b->line[0]);
    YkRefVec e = yk_dag_vec_multiply(g, p->unit[b->line_slot[0]], u);
    YkRef W2 = yk_dag_dot(g, W, W), radius = yk_dag_function(g, YK_SQRT, W2, -1);
    YkRef h = yk_dag_minus(g, yk_dag_cross(g, e, K)), along = yk_dag_dot(g, e, K);
    yk_dag_name(g, h, "%s_h", placed->name);
    YkRef g2 = yk_dag_multiply(g, yk_dag_subtract(g, radius, h), yk_dag_add(g, radius, h));
    yk_dag_name(g, g2, "%s_g2", placed->name);
    YkRef per_root = yk_dag_minus(g, yk_dag_multiply(g, branch_of(p, index), yk_dag_unary(g, YK_VALUE_PER_ROOT, g2)));
    YkRef minus_g = yk_dag_multiply(g, not_negative(g, g2), per_root);
    YkRef d = yk_dag_subtract(g, minus_g, along);
    placed->q = yk_dag_vec_multiply(g, (YkRefVec){yk_dag_minus(g, minus_g), h}, e);
    placed->e[0] = e;
    placed->e[1] = yk_dag_vec_multiply(g, placed->q, vec_inverse(g, W));
    placed->inverse = yk_dag_name(g, per_root, "%s_per_g", placed->name);
    set_distance(p, b->column[1].index, d);
    set_unit(p, b->column[0].index, placed->e[1]);
    YkRef margin = yk_dag_multiply(g, g2, inverse(g, W2));
    keep_margin(p, margin, margin);
}

// RPR through the pin: where the point comes to the pin any angle would do, and the engine has no number there.
static YkRef singular_where_tiny(YkProgram *p, YkRef K2)
{
    YkDag *g = &p->graph;
    double size = yk_program_size(p);
    YkRef of_size = yk_dag_multiply(g, yk_dag_number(g, 1 / (size * size)), K2);
    return yk_dag_subtract(g, yk_dag_multiply(g, yk_dag_number(g, 1e34), of_size), one(g));
}

// RPR: a line that turns about a pin passes a point.
static void place_rpr(YkProgram *p, size_t index, YkPlaced *placed)
{
    YkDag *g = &p->graph;
    const YkBlock *b = &p->mech->blocks[index];
    YkRefVec K = placed->known, C = yk_program_sum(p, &b->arm[0]),
             u = yk_program_line(p, b->column[1].index, b->line[0]);
    YkRefVec f = yk_dag_vec_multiply(g, p->unit[b->line_slot[0]], u);
    YkRef h = yk_dag_cross(g, f, C), along = yk_dag_dot(g, f, C), K2 = yk_dag_dot(g, K, K);
    YkRef r2 = yk_dag_subtract(g, K2, yk_dag_multiply(g, h, h));
    yk_dag_name(g, K2, "%s_K2", placed->name);
    placed->passes_pin = yk_dag_is_number(g, h, 0) && yk_dag_is_number(g, along, 0);
    YkRef per_root = yk_dag_multiply(g, branch_of(p, index), yk_dag_unary(g, YK_VALUE_PER_ROOT, r2));
    YkRef r = yk_dag_name(g, yk_dag_multiply(g, not_negative(g, r2), per_root), "%s_r", placed->name);
    placed->inverse = yk_dag_name(g, per_root, "%s_per_r", placed->name);
    YkRef per_K2 = placed->passes_pin ? -1 : inverse(g, K2);
    YkRef across = placed->passes_pin ? h : yk_dag_multiply(g, h, per_K2);
    YkRef down = yk_dag_minus(g, placed->passes_pin ? per_root : yk_dag_multiply(g, r, per_K2));
    YkRefVec e = yk_dag_vec_multiply(g, K, (YkRefVec){down, across});
    placed->e[0] = e;
    placed->e[1] = yk_dag_vec_multiply(g, e, yk_dag_vec_conjugate(g, f));
    set_unit(p, b->column[0].index, placed->e[1]);
    set_distance(p, b->column[1].index, yk_dag_subtract(g, r, along));
    keep_margin(p, placed->passes_pin ? singular_where_tiny(p, K2) : yk_dag_multiply(g, r2, per_K2), e.x);
}

// PP: two lines meet.
static void place_pp(YkProgram *p, size_t index, YkPlaced *placed)
{
    YkDag *g = &p->graph;
    const YkBlock *b = &p->mech->blocks[index];
    for (int k = 0; k < 2; k++) {
        YkRefVec u = yk_program_line(p, b->column[k].index, b->line[k]);
        placed->e[k] = yk_dag_vec_multiply(g, p->unit[b->line_slot[k]], u);
    }
    YkRef D = yk_dag_cross(g, placed->e[0], placed->e[1]);
    placed->inverse = inverse(g, D);
    YkRef d1 = yk_dag_minus(g, yk_dag_multiply(g, yk_dag_cross(g, placed->known, placed->e[1]), placed->inverse));
    YkRef d2 = yk_dag_multiply(g, yk_dag_cross(g, placed->known, placed->e[0]), placed->inverse);
    set_distance(p, b->column[0].index, d1);
    set_distance(p, b->column[1].index, d2);
    keep_margin(p, yk_dag_multiply(g, D, D), d1);
}

void yk_program_keep_gap(YkProgram *p, YkRef gap)
{
    YkDag *g = &p->graph;
    p->gap = yk_dag_add(g, yk_dag_binary(g, YK_VALUE_LARGEST, gap, p->gap), yk_dag_unary(g, YK_VALUE_WITNESS, gap));
}

static void place_redundant(YkProgram *p, size_t index, YkPlaced *placed)
{
    YkDag *g = &p->graph;
    const YkBlock *b = &p->mech->blocks[index];
    YkRefVec K = placed->known;
    YkRef length = yk_dag_function(g, YK_SQRT, yk_dag_dot(g, K, K), -1);
    if (b->kind == YK_BLOCK_CHECK) {
        yk_program_keep_gap(p, length);
    } else if (b->column[0].is_distance) { // GUIDE
        YkRefVec u = yk_program_line(p, b->column[0].index, b->line[0]);
        placed->e[0] = yk_dag_vec_multiply(g, p->unit[b->line_slot[0]], u);
        set_distance(p, b->column[0].index, yk_dag_minus(g, yk_dag_dot(g, K, placed->e[0])));
        yk_program_keep_gap(p, yk_dag_unary(g, YK_VALUE_SIZE, yk_dag_cross(g, K, placed->e[0])));
    } else { // LINK
        YkRefVec U = yk_program_sum(p, &b->arm[0]), z = yk_dag_vec_multiply(g, K, yk_dag_vec_conjugate(g, U));
        YkRef per = yk_dag_minus(g, inverse(g, yk_dag_function(g, YK_SQRT, yk_dag_dot(g, z, z), -1)));
        YkRef arm = yk_dag_function(g, YK_SQRT, yk_dag_dot(g, U, U), -1);
        placed->e[0] = yk_dag_vec_scale(g, per, z);
        set_unit(p, b->column[0].index, placed->e[0]);
        placed->p = yk_dag_vec_multiply(g, U, placed->e[0]);
        yk_program_keep_gap(p, yk_dag_unary(g, YK_VALUE_SIZE, yk_dag_subtract(g, length, arm)));
    }
}

// --- groups
// ---------------------------------------------------------------------------------------------------------------

static int find_column(const YkProgram *p, const YkBlock *b, bool is_distance, int32_t index)
{
    for (uint32_t k = 0; k < b->column_count; k++) {
        const YkColumn *c = &p->mech->group_columns[b->first_column + k];
        if (c->is_distance == is_distance && c->index == index) return (int)k;
    }
    return -1;
}

// What the unknowns among some sources add to a row of the Jacobian, times a factor.
static void enter_sources(YkProgram *p, uint32_t first, uint32_t count, YkRef factor, YkRef *row)
{
    YkDag *g = &p->graph;
    for (uint32_t i = first; i < first + count; i++) {
        const YkSource *source = &p->mech->sources[i];
        if (source->kind != YK_SOURCE_COLUMN) continue;
        YkRef part = yk_dag_multiply(g, yk_dag_number(g, source->factor), factor);
        row[source->index] = yk_dag_add(g, row[source->index], part);
    }
}

// The rows of gears, racks, belts, cams and laws, behind those of the loops.
static void evaluate_relations(YkProgram *p, const YkBlock *b, const YkRef *x, YkRef *residual, YkRef *jacobian)
{
    for (uint32_t k = 0; k < b->relation_count; k++) {
        size_t row = 2 * (size_t)b->loop_count + k, index = (size_t)p->mech->group_relations[b->first_relation + k];
        const YkRelation *r = &p->mech->relations[index];
        YkRef *entries = &jacobian[row * b->column_count];
        residual[row] = yk_program_relation(p, index, x);
        enter_sources(p, r->first_source, r->source_count, one(&p->graph), entries);
        if (r->law) enter_sources(p, r->first_argument_source, r->argument_source_count, p->slope[2 * index], entries);
    }
}

// Residual and Jacobian of all loops of the group at unknowns x[column], as solve/group has them.
static void evaluate(YkProgram *p, const YkBlock *b, const YkRef *x, YkRef *residual, YkRef *jacobian)
{
    YkDag *g = &p->graph;
    size_t n = b->column_count;
    for (size_t k = 0; k < yk_block_rows(b) * n; k++) jacobian[k] = yk_dag_number(g, 0);
    evaluate_relations(p, b, x, residual, jacobian);
    for (uint32_t l = 0; l < b->loop_count; l++) {
        const YkSum *sum = &p->mech->group_loops[b->first_loop + l];
        YkRefVec total = yk_program_constant(p, sum);
        YkRef *rows = jacobian + 2 * l * n;
        if (sum->plus != YK_NONE) total = yk_dag_vec_add(g, total, p->node[sum->plus]);
        if (sum->minus != YK_NONE) total = yk_dag_vec_subtract(g, total, p->node[sum->minus]);
        for (uint32_t k = 0; k < sum->count; k++) {
            const YkTerm *term = &p->mech->terms[sum->first + k];
            int turn = find_column(p, b, false, p->mech->group_root[term->slot]), slide = -1;
            if (term->slot == 0) turn = -1;
            YkRefVec e = p->unit[turn < 0 ? term->slot : p->mech->relative_slot[term->slot]];
            if (turn >= 0) e = yk_dag_vec_multiply(g, e, yk_dag_unit(g, x[turn]));
            YkRefVec v = yk_dag_vec_multiply(g, e, yk_program_term(p, sum->first + k));
            if (term->distance != YK_NONE) {
                slide = find_column(p, b, true, term->distance);
                if (slide >= 0) {
                    rows[slide] = yk_dag_add(g, rows[slide], v.x);
                    rows[n + (size_t)slide] = yk_dag_add(g, rows[n + (size_t)slide], v.y);
                }
                v = yk_dag_vec_scale(g, slide >= 0 ? x[slide] : p->distance[term->distance], v);
            }
            total = yk_dag_vec_add(g, total, v);
            if (turn >= 0) {
                rows[turn] = yk_dag_subtract(g, rows[turn], v.y);
                rows[n + (size_t)turn] = yk_dag_add(g, rows[n + (size_t)turn], v.x);
            }
        }
        residual[2 * l] = total.x;
        residual[2 * l + 1] = total.y;
    }
}

static void place_group(YkProgram *p, size_t index, YkPlaced *placed)
{
    YkDag *g = &p->graph;
    const YkBlock *b = &p->mech->blocks[index];
    size_t n = b->column_count, m = yk_block_rows(b);
    if (n != m) {
        yk_problem(p->problems, YK_CODE_NOT_PRINTABLE, (YkPlace){0},
                   "the group of %q repeats constraints: its position is found by least squares, which is not printed",
                   b->label);
        p->failed = true;
        return;
    }
    placed->unknown = YK_NEW(p->arena, YkRef, n);
    placed->residual = YK_NEW(p->arena, YkRef, m);
    placed->jacobian = YK_NEW(p->arena, YkRef, m * n);
    placed->solution = YK_NEW(p->arena, YkRef, n);
    placed->at = YK_NEW(p->arena, YkRef, m * n);
    YkRef *guess = YK_NEW(p->arena, YkRef, n), *unused = YK_NEW(p->arena, YkRef, m);
    if (yk_arena_failed(p->arena)) {
        g->failed = p->failed = true;
        return;
    }
    for (size_t k = 0; k < n; k++) {
        placed->unknown[k] = yk_dag_leaf(g, YK_LEAF_UNKNOWN, yk_program_text(p, "x_%s[%d]", placed->name, (int)k));
        guess[k] = yk_dag_leaf(g, YK_LEAF_POSE, yk_program_text(p, "c->%s_guess[%d]", placed->name, (int)k));
    }
    evaluate(p, b, placed->unknown, placed->residual, placed->jacobian);
    for (size_t k = 0; k < m; k++) yk_dag_minus(g, placed->residual[k]); // as Newton's method takes it
    yk_dag_section(g, yk_program_text(p, "%s: a group of %d loops, by Newton's method.", b->label, (int)b->loop_count));
    placed->call = yk_dag_call(g, (YkCall){.kind = YK_CALL_GROUP,
                                           .index = (int32_t)index,
                                           .n = (int32_t)n,
                                           .arguments = guess,
                                           .argument_count = n,
                                           .result_count = n + 2,
                                           .name = placed->name});
    for (size_t k = 0; k < n; k++) {
        const YkColumn *c = &p->mech->group_columns[b->first_column + k];
        placed->solution[k] = yk_dag_result(g, placed->call, k);
        if (c->is_distance)
            set_distance(p, c->index, placed->solution[k]);
        else
            set_unit(p, c->index, yk_dag_unit(g, placed->solution[k]));
    }
    evaluate(p, b, placed->solution, unused, placed->at);
    // the sign of the determinant is the branch; its square the margin
    YkRef miss = yk_dag_result(g, placed->call, n), det = yk_dag_result(g, placed->call, n + 1);
    YkRef on_branch = yk_dag_multiply(g, det, branch_of(p, index));
    p->missed = yk_dag_binary(g, YK_VALUE_LARGEST, p->missed, miss);
    keep_margin(p, yk_dag_choose(g, on_branch, yk_dag_number(g, -1), yk_dag_multiply(g, det, det)), miss);
}

void yk_program_place(YkProgram *p, size_t index)
{
    static const char *const what[] = {"two circles meet",
                                       "a circle meets a line",
                                       "a line turns about a pin through a point",
                                       "two lines meet",
                                       "one unknown, checked",
                                       "checked",
                                       ""};
    const YkBlock *b = &p->mech->blocks[index];
    YkPlaced *placed = &p->placed[index];
    placed->name = yk_program_block_name(p, index);
    if (b->kind == YK_BLOCK_GROUP) {
        place_group(p, index, placed);
        return;
    }
    yk_dag_section(&p->graph, yk_program_text(p, "%s: %s, %s. K: the known part of its loop.", b->label,
                                              yk_block_kind_name(b->kind), what[b->kind]));
    placed->known = yk_program_sum(p, &b->known);
    name_vec(p, placed->known, placed->name, "K");
    switch (b->kind) {
    case YK_BLOCK_RRR:
        place_rrr(p, index, placed);
        break;
    case YK_BLOCK_RRP:
        place_rrp(p, index, placed);
        break;
    case YK_BLOCK_RPR:
        place_rpr(p, index, placed);
        break;
    case YK_BLOCK_PP:
        place_pp(p, index, placed);
        break;
    default:
        place_redundant(p, index, placed);
        break;
    }
}
