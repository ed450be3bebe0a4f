// Makes operations from the steps of solution.
#include "equations/elimination_order.h"

static YkOperation *add_raw(YkEliminationOrder *o, YkOperationKind kind, size_t own, YkGradient gradient)
{
    YkOperation *op = &o->raw[o->raw_count];
    *op = (YkOperation){.kind = kind, .input = YK_NONE, .own = (uint32_t)own, .gradient = gradient};
    op->given = (uint32_t)(o->columns.count - own);
    o->raw_first[o->raw_count] = (uint32_t)o->raw_column_count;
    for (size_t k = 0; k < o->columns.count; k++) {
        if (!yk_order_keep(&o->raw_columns, &o->raw_column_count, &o->raw_column_capacity, o->columns.unknown[k]))
            o->failed = true;
        if (k < own) o->defined_by[o->columns.unknown[k]] = (int32_t)o->raw_count;
    }
    if (o->columns.failed) o->failed = true;
    o->raw_count++;
    return op;
}

static void add_copy(YkEliminationOrder *o, int32_t target, int32_t a, int32_t b, int32_t input)
{
    yk_order_start_columns(o);
    yk_column(&o->columns, target);
    yk_column(&o->columns, a);
    yk_column(&o->columns, b);
    YkGradient none = {.columns = (uint32_t)o->columns.count};
    YkOperation *op = add_raw(o, o->columns.count > 1 ? YK_OP_COPY : YK_OP_KNOWN, 1, none);
    op->input = input;
    if (input != YK_NONE) o->e->operation_of_input[input] = (int32_t)o->raw_count - 1;
}

static void add_free(YkEliminationOrder *o, int32_t target, int32_t input)
{
    yk_order_start_columns(o);
    yk_column(&o->columns, target);
    YkOperation *op = add_raw(o, YK_OP_FREE, 1, (YkGradient){.columns = 1});
    op->input = input;
    o->e->operation_of_input[input] = (int32_t)o->raw_count - 1;
}

static void add_turn(YkEliminationOrder *o, const YkStep *step)
{
    o->e->parent_of_input[step->input] = step->parent;
    o->e->sign_of_input[step->input] = step->sign;
    if (o->is_free[step->input])
        add_free(o, yk_unknown_of_slot(step->target), step->input);
    else
        add_copy(o, yk_unknown_of_slot(step->target), step->parent, 0, step->input);
}

static void add_distance(YkEliminationOrder *o, const YkStep *step)
{
    int32_t unknown = yk_unknown_of_distance(o->mech, step->target);
    o->e->sign_of_input[step->input] = 1;
    if (o->is_free[step->input])
        add_free(o, unknown, step->input);
    else
        add_copy(o, unknown, 0, 0, step->input);
}

static void add_node(YkEliminationOrder *o, const YkStep *step)
{
    YkElimination *e = o->e;
    int32_t x = yk_unknown_of_node(o->mech, step->target);
    yk_order_start_columns(o);
    yk_column(&o->columns, x);
    yk_column(&o->columns, x + 1);
    YkGradient gradient = yk_gradient_begin(e);
    if (!yk_gradient_add_sum(e, &o->columns, &o->mech->node_sums[step->target], 0, YK_NONE, 0)) o->failed = true;
    yk_gradient_end(e, &o->columns, &gradient);
    add_raw(o, YK_OP_NODE, 2, gradient);
}

static int32_t unknown_of_column(const YkEliminationOrder *o, YkColumn column)
{
    return column.is_distance ? yk_unknown_of_distance(o->mech, column.index) : yk_unknown_of_slot(column.index);
}

// Adds the arms and lines of a dyad, each turned by its unknown orientation if it has one.
static bool add_arms(YkEliminationOrder *o, const YkBlock *b)
{
    YkElimination *e = o->e;
    YkGradientColumns *c = &o->columns;
    int32_t root = b->column[0].index, root2 = b->column[1].index;
    YkTerm line[2];
    for (int k = 0; k < 2; k++) line[k] = (YkTerm){b->line_slot[k], b->column[k].index, b->line[k]};
    switch (b->kind) {
    case YK_BLOCK_RRR:
        return yk_gradient_add_sum(e, c, &b->aside->arm[0], root, 0, 0) &&
               yk_gradient_add_sum(e, c, &b->aside->arm[1], root2, 1, 0);
    case YK_BLOCK_RRP:
    case YK_BLOCK_RPR:
        line[0].distance = b->column[1].index;
        return yk_gradient_add_sum(e, c, &b->aside->arm[0], root, 0, 0) &&
               yk_gradient_add_term(e, c, line[0], b->kind == YK_BLOCK_RPR ? root : 0,
                                    b->kind == YK_BLOCK_RPR ? 0 : YK_NONE, 0);
    case YK_BLOCK_PP:
        return yk_gradient_add_term(e, c, line[0], 0, YK_NONE, 0) && yk_gradient_add_term(e, c, line[1], 0, YK_NONE, 0);
    case YK_BLOCK_LINK:
        if (b->column[0].is_distance) return yk_gradient_add_term(e, c, line[0], 0, YK_NONE, 0);
        return yk_gradient_add_sum(e, c, &b->aside->arm[0], root, 0, 0);
    default:
        return true;
    }
}

static void add_dyad(YkEliminationOrder *o, const YkBlock *b)
{
    YkElimination *e = o->e;
    yk_order_start_columns(o);
    for (uint32_t k = 0; k < b->column_count; k++) yk_column(&o->columns, unknown_of_column(o, b->column[k]));
    YkGradient gradient = yk_gradient_begin(e);
    if (!add_arms(o, b) || !yk_gradient_add_sum(e, &o->columns, &b->known, 0, YK_NONE, 0)) o->failed = true;
    yk_gradient_end(e, &o->columns, &gradient);
    add_raw(o, b->column_count == 2 ? YK_OP_PAIR : YK_OP_SINGLE, b->column_count, gradient);
}

// --- relations

// Finds the unknowns on which a term of a relation depends, in unknown[]; returns how many. If its orientation turns
// with a root for which the operation solves, these are the root and the relative angle; if that root is not known yet,
// it cancels, and the relative angle is left.
static size_t unknowns_of_term(const YkEliminationOrder *o, YkRelationTerm term, size_t own, int32_t unknown[2])
{
    const YkMechanism *mech = o->mech;
    if (term.is_distance) {
        unknown[0] = yk_unknown_of_distance(mech, term.index);
        return 1;
    }
    int32_t root = yk_unknown_of_slot(mech->group_root[term.index]);
    unknown[0] = yk_unknown_of_slot(term.index);
    unknown[1] = yk_unknown_of_slot(mech->relative_slot[term.index]);
    if (o->defined_by[unknown[0]] != YK_NONE) return 1;
    for (size_t k = 0; k < own; k++)
        if (o->columns.unknown[k] == root) {
            unknown[0] = root;
            return unknown[1] == 0 ? 1 : 2;
        }
    unknown[0] = unknown[1];
    return 1;
}

// Adds the columns of a relation.
static void add_relation_columns(YkEliminationOrder *o, const YkRelation *r, size_t own)
{
    int32_t unknown[2];
    for (uint32_t k = 0; k < r->term_count + r->argument_count; k++) { // those of the argument follow
        size_t count = unknowns_of_term(o, o->mech->relation_terms[r->first_term + k], own, unknown);
        for (size_t i = 0; i < count; i++) yk_column(&o->columns, unknown[i]);
    }
}

// Adds a row of factors, two for every column: constant, and times the law's slope.
static void add_relation_factors(YkEliminationOrder *o, const YkRelation *r, size_t own, double times)
{
    YkElimination *e = o->e;
    size_t first = e->factor_count, width = 2 * o->columns.count;
    int32_t unknown[2];
    while (e->factor_count < first + width) {
        if (!YK_ROOM(e->factors, e->factor_count, e->factor_capacity)) {
            o->failed = true;
            return;
        }
        e->factors[e->factor_count++] = 0;
    }
    for (uint32_t k = 0; k < r->term_count + r->argument_count; k++) {
        YkRelationTerm term = o->mech->relation_terms[r->first_term + k];
        bool in_law = k >= r->term_count;
        size_t count = unknowns_of_term(o, term, own, unknown);
        for (size_t i = 0; i < count; i++) {
            int32_t column = yk_column(&o->columns, unknown[i]);
            if (column >= 0)
                e->factors[first + 2 * (size_t)column + in_law] += in_law ? term.factor : times * term.factor;
        }
    }
}

// --- groups

// Adds a term of a group's loop: its orientation is known, or turns with an unknown root.
static bool add_group_term(YkEliminationOrder *o, YkTerm term, int32_t row, size_t own)
{
    const YkMechanism *mech = o->mech;
    YkElimination *e = o->e;
    int32_t root = mech->group_root[term.slot], column = YK_NONE;
    for (size_t k = 0; k < own; k++)
        if (root != 0 && o->columns.unknown[k] == yk_unknown_of_slot(root)) column = (int32_t)k;
    if (column == YK_NONE || root == term.slot) return yk_gradient_add_term(e, &o->columns, term, 0, YK_NONE, row);
    YkTerm inner = {mech->relative_slot[term.slot], term.distance, term.v};
    return yk_gradient_add_term(e, &o->columns, inner, root, column, row);
}

static void add_group(YkEliminationOrder *o, const YkBlock *b)
{
    YkElimination *e = o->e;
    yk_order_start_columns(o);
    for (uint32_t k = 0; k < b->column_count; k++)
        yk_column(&o->columns, unknown_of_column(o, o->mech->group_columns[b->first_column + k]));
    YkGradient gradient = yk_gradient_begin(e);
    for (uint32_t l = 0; l < b->loop_count && !o->failed; l++) {
        YkSum sum = o->mech->group_loops[b->first_loop + l];
        uint32_t first = sum.first, count = sum.count;
        sum.count = 0;
        if (!yk_gradient_add_sum(e, &o->columns, &sum, 0, YK_NONE, (int32_t)l)) o->failed = true;
        for (uint32_t k = 0; k < count; k++)
            if (!add_group_term(o, o->mech->terms[first + k], (int32_t)l, b->column_count)) o->failed = true;
    }
    const int32_t *relation = yk_from(o->mech->group_relations, b->first_relation);
    for (uint32_t k = 0; k < b->relation_count; k++)
        add_relation_columns(o, &o->mech->relations[relation[k]], b->column_count);
    yk_gradient_end(e, &o->columns, &gradient);
    YkOperation *op = add_raw(o, YK_OP_GROUP, b->column_count, gradient);
    op->first_factor = (uint32_t)e->factor_count;
    for (uint32_t k = 0; k < b->relation_count; k++) {
        const YkRelation *r = &o->mech->relations[relation[k]];
        add_relation_factors(o, r, b->column_count, -r->gain);
    }
    size_t most = b->column_count > yk_block_rows(b) ? b->column_count : yk_block_rows(b);
    if (most > e->largest_group) e->largest_group = most;
}

static void add_block(YkEliminationOrder *o, int32_t index)
{
    const YkBlock *b = &o->mech->blocks[index];
    if (b->kind == YK_BLOCK_CHECK) return;
    if (b->kind == YK_BLOCK_GROUP)
        add_group(o, b);
    else
        add_dyad(o, b);
    o->raw[o->raw_count - 1].block = (uint32_t)index;
}

static void add_relation(YkEliminationOrder *o, int32_t index)
{
    const YkMechanism *mech = o->mech;
    const YkRelation *r = &mech->relations[index];
    yk_order_start_columns(o);
    yk_column(&o->columns, r->target.is_distance ? yk_unknown_of_distance(mech, r->target.index)
                                                 : yk_unknown_of_slot(r->target.index));
    add_relation_columns(o, r, 1);
    YkGradient none = {.columns = (uint32_t)o->columns.count};
    YkOperation *op = add_raw(o, o->columns.count > 1 ? YK_OP_RELATION : YK_OP_KNOWN, 1, none);
    op->block = (uint32_t)index;
    op->first_factor = (uint32_t)o->e->factor_count;
    add_relation_factors(o, r, 1, -r->gain); // the slope includes the gain
}

void yk_order_add_steps(YkEliminationOrder *o)
{
    for (size_t k = 0; k < o->mech->step_count && !o->failed; k++) {
        const YkStep *step = &o->mech->steps[k];
        switch (step->kind) {
        case YK_STEP_TURN:
            add_turn(o, step);
            break;
        case YK_STEP_COMPOSE:
            add_copy(o, step->target, step->parent, step->other, YK_NONE);
            break;
        case YK_STEP_DISTANCE:
            add_distance(o, step);
            break;
        case YK_STEP_NODE:
            add_node(o, step);
            break;
        case YK_STEP_BLOCK:
            add_block(o, step->target);
            break;
        case YK_STEP_RELATION:
            add_relation(o, step->target);
            break;
        case YK_STEP_CHECK:
            break;
        }
    }
}
