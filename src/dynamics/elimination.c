#include "dynamics/elimination.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "dynamics/gradient.h"

// What is known while the order is being found.
typedef struct Order {
    YkElimination *e;
    const YkMechanism *mech;
    const bool *is_free, *is_loaded;
    YkColumns columns;
    // operations as the steps give them, before they are put in order
    YkOperation *raw;
    int32_t *raw_columns; // unknowns of each, U then W
    size_t raw_count, raw_column_count, raw_column_capacity;
    uint32_t *raw_first;
    int32_t *defined_by; // per unknown: raw operation, YK_NONE
    bool *is_needed;     // per raw operation
    int32_t *place;      // per raw operation: its place in forward order, YK_NONE
    int32_t *element_columns;
    size_t element_column_count, element_column_capacity;
    uint32_t *element_first;
    int32_t *element_place;
    // the fill: per unknown its entries with others that are eliminated after it
    int32_t *head;
    struct Link {
        int32_t next, unknown, entry;
    } * links;
    size_t link_count, link_capacity;
    bool failed;
} Order;

static bool keep(int32_t **items, size_t *count, size_t *capacity, int32_t value)
{
    if (!yk_grow((void **)items, *count, capacity, sizeof **items)) return false;
    (*items)[(*count)++] = value;
    return true;
}

// --- operations, as the steps give them
// --------------------------------------------------------------------------------

static void start_columns(Order *o)
{
    o->columns.count = 0;
}

static YkOperation *add_raw(Order *o, YkOperationKind kind, size_t own, YkGradient gradient)
{
    YkOperation *op = &o->raw[o->raw_count];
    *op = (YkOperation){.kind = kind, .input = YK_NONE, .own = (uint32_t)own, .gradient = gradient};
    op->given = (uint32_t)(o->columns.count - own);
    o->raw_first[o->raw_count] = (uint32_t)o->raw_column_count;
    for (size_t k = 0; k < o->columns.count; k++) {
        if (!keep(&o->raw_columns, &o->raw_column_count, &o->raw_column_capacity, o->columns.unknown[k]))
            o->failed = true;
        if (k < own) o->defined_by[o->columns.unknown[k]] = (int32_t)o->raw_count;
    }
    if (o->columns.failed) o->failed = true;
    o->raw_count++;
    return op;
}

static void add_copy(Order *o, int32_t target, int32_t a, int32_t b, int32_t input)
{
    start_columns(o);
    yk_column(&o->columns, target);
    yk_column(&o->columns, a);
    yk_column(&o->columns, b);
    YkGradient none = {.columns = (uint32_t)o->columns.count};
    YkOperation *op = add_raw(o, o->columns.count > 1 ? YK_OP_COPY : YK_OP_KNOWN, 1, none);
    op->input = input;
    if (input != YK_NONE) o->e->operation_of_input[input] = (int32_t)o->raw_count - 1;
}

static void add_free(Order *o, int32_t target, int32_t input)
{
    start_columns(o);
    yk_column(&o->columns, target);
    YkOperation *op = add_raw(o, YK_OP_FREE, 1, (YkGradient){.columns = 1});
    op->input = input;
    o->e->operation_of_input[input] = (int32_t)o->raw_count - 1;
}

static void add_turn(Order *o, const YkStep *step)
{
    o->e->parent_of_input[step->input] = step->parent;
    o->e->sign_of_input[step->input] = step->sign;
    if (o->is_free[step->input])
        add_free(o, yk_unknown_of_slot(step->target), step->input);
    else
        add_copy(o, yk_unknown_of_slot(step->target), step->parent, 0, step->input);
}

static void add_distance(Order *o, const YkStep *step)
{
    int32_t unknown = yk_unknown_of_distance(o->mech, step->target);
    o->e->sign_of_input[step->input] = 1;
    if (o->is_free[step->input])
        add_free(o, unknown, step->input);
    else
        add_copy(o, unknown, 0, 0, step->input);
}

static void add_node(Order *o, const YkStep *step)
{
    YkElimination *e = o->e;
    int32_t x = yk_unknown_of_node(o->mech, step->target);
    start_columns(o);
    yk_column(&o->columns, x);
    yk_column(&o->columns, x + 1);
    YkGradient gradient = yk_gradient_begin(e);
    if (!yk_gradient_add_sum(e, &o->columns, &step->sum, 0, YK_NONE, 0)) o->failed = true;
    yk_gradient_end(e, &o->columns, &gradient);
    add_raw(o, YK_OP_NODE, 2, gradient);
}

static int32_t unknown_of_column(const Order *o, YkColumn column)
{
    return column.is_distance ? yk_unknown_of_distance(o->mech, column.index) : yk_unknown_of_slot(column.index);
}

// The arms and lines of a dyad, each turned by its unknown orientation where it has one.
static bool add_arms(Order *o, const YkBlock *b)
{
    YkElimination *e = o->e;
    YkColumns *c = &o->columns;
    int32_t root = b->column[0].index, root2 = b->column[1].index;
    YkTerm line[2];
    for (int k = 0; k < 2; k++) line[k] = (YkTerm){b->line_slot[k], b->column[k].index, b->line[k]};
    switch (b->kind) {
    case YK_BLOCK_RRR:
        return yk_gradient_add_sum(e, c, &b->arm[0], root, 0, 0) && yk_gradient_add_sum(e, c, &b->arm[1], root2, 1, 0);
    case YK_BLOCK_RRP:
    case YK_BLOCK_RPR:
        line[0].distance = b->column[1].index;
        return yk_gradient_add_sum(e, c, &b->arm[0], root, 0, 0) &&
               yk_gradient_add_term(e, c, line[0], b->kind == YK_BLOCK_RPR ? root : 0,
                                    b->kind == YK_BLOCK_RPR ? 0 : YK_NONE, 0);
    case YK_BLOCK_PP:
        return yk_gradient_add_term(e, c, line[0], 0, YK_NONE, 0) && yk_gradient_add_term(e, c, line[1], 0, YK_NONE, 0);
    case YK_BLOCK_LINK:
        if (b->column[0].is_distance) return yk_gradient_add_term(e, c, line[0], 0, YK_NONE, 0);
        return yk_gradient_add_sum(e, c, &b->arm[0], root, 0, 0);
    default:
        return true;
    }
}

static void add_dyad(Order *o, const YkBlock *b)
{
    YkElimination *e = o->e;
    start_columns(o);
    for (uint32_t k = 0; k < b->column_count; k++) yk_column(&o->columns, unknown_of_column(o, b->column[k]));
    YkGradient gradient = yk_gradient_begin(e);
    if (!add_arms(o, b) || !yk_gradient_add_sum(e, &o->columns, &b->known, 0, YK_NONE, 0)) o->failed = true;
    yk_gradient_end(e, &o->columns, &gradient);
    add_raw(o, b->column_count == 2 ? YK_OP_PAIR : YK_OP_SINGLE, b->column_count, gradient);
}

// --- relations
// -------------------------------------------------------------------------------------------------------------

// What a term of a relation depends on, in unknown[]; returns how many. Where its orientation turns with a root that
// the operation solves for, these are the root and the relative angle; where that root is not known yet, it cancels,
// and the relative angle is left.
static size_t unknowns_of_term(const Order *o, YkRelationTerm term, size_t own, int32_t unknown[2])
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
static void add_relation_columns(Order *o, const YkRelation *r, size_t own)
{
    int32_t unknown[2];
    for (uint32_t k = 0; k < r->term_count + r->argument_count; k++) { // the argument's terms stand behind
        size_t count = unknowns_of_term(o, o->mech->relation_terms[r->first_term + k], own, unknown);
        for (size_t i = 0; i < count; i++) yk_column(&o->columns, unknown[i]);
    }
}

// A row of factors, two for every column: constant, and times the law's slope.
static void add_relation_factors(Order *o, const YkRelation *r, size_t own, double times)
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
// ------------------------------------------------------------------------------------------------------------

// A term of a group's loop: its orientation is known, or turns with an unknown root.
static bool add_group_term(Order *o, YkTerm term, int32_t row, size_t own)
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

static void add_group(Order *o, const YkBlock *b)
{
    YkElimination *e = o->e;
    start_columns(o);
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
    const int32_t *relation = o->mech->group_relations + b->first_relation;
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

static void add_block(Order *o, int32_t index)
{
    const YkBlock *b = &o->mech->blocks[index];
    if (b->kind == YK_BLOCK_CHECK) return;
    if (b->kind == YK_BLOCK_GROUP)
        add_group(o, b);
    else
        add_dyad(o, b);
    o->raw[o->raw_count - 1].block = (uint32_t)index;
}

static void add_relation(Order *o, int32_t index)
{
    const YkMechanism *mech = o->mech;
    const YkRelation *r = &mech->relations[index];
    start_columns(o);
    yk_column(&o->columns, r->target.is_distance ? yk_unknown_of_distance(mech, r->target.index)
                                                 : yk_unknown_of_slot(r->target.index));
    add_relation_columns(o, r, 1);
    YkGradient none = {.columns = (uint32_t)o->columns.count};
    YkOperation *op = add_raw(o, o->columns.count > 1 ? YK_OP_RELATION : YK_OP_KNOWN, 1, none);
    op->block = (uint32_t)index;
    op->first_factor = (uint32_t)o->e->factor_count;
    add_relation_factors(o, r, 1, -r->gain); // the slope has the gain in it
}

static void add_steps(Order *o)
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

// --- bodies
// ------------------------------------------------------------------------------------------------------------

// The reference point from the origin: joins the piece of the body's own orientation where the origin has one.
static bool add_reference(Order *o, YkTerm term, uint32_t first)
{
    YkElimination *e = o->e;
    if (term.slot == 0 || (term.v.x == 0 && term.v.y == 0)) return true;
    for (size_t k = first; k < e->piece_count; k++) {
        YkGradientPiece *piece = &e->pieces[k];
        if (piece->slot != term.slot || piece->distance != YK_NONE) continue;
        piece->v = yk_add(piece->v, term.v);
        return true;
    }
    return yk_gradient_add_term(e, &o->columns, term, 0, YK_NONE, 0);
}

static void add_element(Order *o, int32_t body)
{
    YkElimination *e = o->e;
    const YkBody *b = &o->mech->model->bodies[body];
    const YkPlacing *placing = &o->mech->bodies[body];
    YkElement element = {.body = body, .mass = b->mass, .inertia = b->inertia, .gradient = yk_gradient_begin(e)};
    start_columns(o);
    YkTerm reference = yk_body_term(o->mech, body, b->mass > 0 ? b->center : yk_vec(0, 0));
    if (!yk_gradient_add_sum(e, &o->columns, &placing->origin, 0, YK_NONE, 0)) o->failed = true;
    element.rotation = yk_column(&o->columns, yk_unknown_of_slot(placing->orientation));
    if (!add_reference(o, reference, element.gradient.first_piece)) o->failed = true;
    yk_gradient_end(e, &o->columns, &element.gradient);
    if (o->columns.count == 0) return; // it never moves
    o->element_first[e->element_count] = (uint32_t)o->element_column_count;
    for (size_t k = 0; k < o->columns.count; k++)
        if (!keep(&o->element_columns, &o->element_column_count, &o->element_column_capacity, o->columns.unknown[k]))
            o->failed = true;
    e->elements[e->element_count++] = element;
}

static void add_elements(Order *o)
{
    const YkModel *model = o->mech->model;
    for (size_t b = 1; b < model->body_count && !o->failed; b++)
        if (model->bodies[b].has_mass || o->is_loaded[b]) add_element(o, (int32_t)b);
    o->element_first[o->e->element_count] = (uint32_t)o->element_column_count;
}

// --- order
// -------------------------------------------------------------------------------------------------------------

static void need(Order *o, int32_t unknown)
{
    if (o->defined_by[unknown] != YK_NONE) o->is_needed[o->defined_by[unknown]] = true;
}

static void mark_needed(Order *o)
{
    for (size_t k = 0; k < o->element_column_count; k++) need(o, o->element_columns[k]);
    for (size_t r = o->raw_count; r-- > 0;) {
        if (o->raw[r].input != YK_NONE) o->is_needed[r] = true;
        if (!o->is_needed[r]) continue;
        for (uint32_t k = 0; k < o->raw[r].own + o->raw[r].given; k++) need(o, o->raw_columns[o->raw_first[r] + k]);
    }
}

static void emit(Order *o, size_t raw, size_t *place)
{
    if (o->place[raw] != YK_NONE) return;
    o->place[raw] = (int32_t)*place;
    o->e->operations[*place] = o->raw[raw];
    o->e->operations[(*place)++].first_index = (uint32_t)raw; // until the fill is found
}

// Free inputs come as late as possible: just before the first operation that needs them.
static void put_in_order(Order *o)
{
    size_t place = 0;
    for (size_t r = 0; r < o->raw_count; r++) {
        if (!o->is_needed[r] || o->raw[r].kind == YK_OP_FREE) continue;
        for (uint32_t k = o->raw[r].own; k < o->raw[r].own + o->raw[r].given; k++) {
            int32_t by = o->defined_by[o->raw_columns[o->raw_first[r] + k]];
            if (by != YK_NONE) emit(o, (size_t)by, &place);
        }
        emit(o, r, &place);
    }
    for (size_t r = 0; r < o->raw_count; r++)
        if (o->is_needed[r]) emit(o, r, &place);
    o->e->operation_count = place;
    for (size_t i = 0; i < o->mech->input_count; i++)
        if (o->e->operation_of_input[i] != YK_NONE) o->e->operation_of_input[i] = o->place[o->e->operation_of_input[i]];
}

static int32_t place_of(const Order *o, int32_t unknown)
{
    return o->place[o->defined_by[unknown]];
}

// Elements sorted by the operation that defines their latest unknown (counting sort).
static bool sort_elements(Order *o)
{
    YkElimination *e = o->e;
    uint32_t *start = calloc(e->operation_count + 2, sizeof *start);
    YkElement *sorted = calloc(e->element_count + 1, sizeof *sorted);
    uint32_t *first = calloc(e->element_count + 1, sizeof *first);
    bool ok = start && sorted && first;
    for (size_t k = 0; ok && k < e->element_count; k++) {
        int32_t latest = 0;
        for (uint32_t c = o->element_first[k]; c < o->element_first[k + 1]; c++) {
            int32_t p = place_of(o, o->element_columns[c]);
            if (p > latest) latest = p;
        }
        o->element_place[k] = latest;
        start[latest + 1]++;
    }
    for (size_t p = 0; ok && p < e->operation_count; p++) {
        e->operations[p].first_element = start[p];
        e->operations[p].element_count = start[p + 1];
        start[p + 1] += start[p];
    }
    for (size_t k = 0; ok && k < e->element_count; k++) {
        uint32_t at = start[o->element_place[k]]++;
        sorted[at] = e->elements[k];
        first[at] = o->element_first[k];
    }
    if (ok) {
        memcpy(e->elements, sorted, e->element_count * sizeof *sorted);
        memcpy(o->element_first, first, e->element_count * sizeof *first);
    }
    free(start);
    free(sorted);
    free(first);
    return ok;
}

// --- fill
// --------------------------------------------------------------------------------------------------------------

static bool is_before(const Order *o, int32_t a, int32_t b) // is a eliminated before b? Within one operation: by number
{
    int32_t pa = place_of(o, a), pb = place_of(o, b);
    return pa > pb || (pa == pb && a < b);
}

// The entry of a pair, in the row of the one eliminated first.
static int32_t entry_of(Order *o, int32_t a, int32_t b)
{
    int32_t row = is_before(o, a, b) ? a : b, other = row == a ? b : a;
    for (int32_t k = o->head[row]; k != YK_NONE; k = o->links[k].next)
        if (o->links[k].unknown == other) return o->links[k].entry;
    if (!YK_ROOM(o->links, o->link_count, o->link_capacity)) {
        o->failed = true;
        return 0;
    }
    o->links[o->link_count].next = o->head[row];
    o->links[o->link_count].unknown = other;
    o->links[o->link_count].entry = (int32_t)o->e->entry_count++;
    o->head[row] = (int32_t)o->link_count++;
    return o->links[o->head[row]].entry;
}

static void put_index(Order *o, int32_t value)
{
    if (!keep(&o->e->index, &o->e->index_count, &o->e->index_capacity, value)) o->failed = true;
}

static void fill_element(Order *o, size_t index)
{
    YkElement *element = &o->e->elements[index];
    const int32_t *columns = o->element_columns + o->element_first[index];
    uint32_t n = element->gradient.columns;
    element->first_index = (uint32_t)o->e->index_count;
    for (uint32_t k = 0; k < n; k++) put_index(o, columns[k]);
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = i; j < n; j++) put_index(o, entry_of(o, columns[i], columns[j]));
}

// The neighbours of the operation's unknowns that are eliminated later, W first.
static void gather_neighbours(Order *o, const YkOperation *op, const int32_t *columns)
{
    start_columns(o);
    for (uint32_t k = op->own; k < op->own + op->given; k++) yk_column(&o->columns, columns[k]);
    for (uint32_t u = 0; u < op->own; u++)
        for (int32_t k = o->head[columns[u]]; k != YK_NONE; k = o->links[k].next) {
            bool is_own = false;
            for (uint32_t j = 0; j < op->own; j++) is_own = is_own || columns[j] == o->links[k].unknown;
            if (!is_own) yk_column(&o->columns, o->links[k].unknown);
        }
    if (o->columns.failed) o->failed = true;
}

static int32_t existing_entry(const Order *o, int32_t row, int32_t other)
{
    for (int32_t k = o->head[row]; k != YK_NONE; k = o->links[k].next)
        if (o->links[k].unknown == other) return o->links[k].entry;
    return YK_NONE;
}

static void fill_operation(Order *o, YkOperation *op)
{
    YkElimination *e = o->e;
    const int32_t *columns = o->raw_columns + o->raw_first[op->first_index];
    gather_neighbours(o, op, columns);
    uint32_t n = (uint32_t)o->columns.count;
    op->neighbours = n;
    op->first_index = (uint32_t)e->index_count;
    op->first_coefficient = (uint32_t)e->coefficient_count;
    e->coefficient_count += (size_t)op->own * op->given;
    for (uint32_t k = 0; k < op->own; k++) put_index(o, columns[k]);
    for (uint32_t k = 0; k < n; k++) put_index(o, o->columns.unknown[k]);
    for (uint32_t i = 0; i < op->own; i++)
        for (uint32_t j = i; j < op->own; j++) put_index(o, entry_of(o, columns[i], columns[j]));
    for (uint32_t i = 0; i < op->own; i++)
        for (uint32_t j = 0; j < n; j++) put_index(o, existing_entry(o, columns[i], o->columns.unknown[j]));
    uint32_t rows = op->kind == YK_OP_FREE ? n : op->given;
    for (uint32_t i = 0; i < rows && op->kind != YK_OP_KNOWN; i++)
        for (uint32_t j = i; j < n; j++) put_index(o, entry_of(o, o->columns.unknown[i], o->columns.unknown[j]));
    size_t wide = n + op->own > op->gradient.columns ? n + op->own : op->gradient.columns;
    if (wide > e->widest) e->widest = wide;
}

static void find_fill(Order *o)
{
    YkElimination *e = o->e;
    for (size_t p = e->operation_count; p-- > 0 && !o->failed;) {
        YkOperation *op = &e->operations[p];
        for (uint32_t k = 0; k < op->element_count; k++) fill_element(o, op->first_element + k);
        fill_operation(o, op);
    }
    for (size_t k = 0; k < e->element_count; k++)
        if (e->elements[k].gradient.columns > e->widest) e->widest = e->elements[k].gradient.columns;
}

// Back substitution is needed as far as a free input's acceleration reaches.
static void mark_back_needed(Order *o)
{
    YkElimination *e = o->e;
    for (size_t i = 0; i < o->mech->input_count; i++) {
        int32_t parent = e->parent_of_input[i];
        if (o->is_free[i] && parent > 0 && o->defined_by[parent] != YK_NONE)
            e->is_back_needed[place_of(o, parent)] = true;
    }
    for (size_t p = e->operation_count; p-- > 0;) {
        const YkOperation *op = &e->operations[p];
        if (op->kind == YK_OP_FREE) e->is_back_needed[p] = true;
        if (!e->is_back_needed[p]) continue;
        const int32_t *unknown = e->index + op->first_index + op->own;
        uint32_t n = op->kind == YK_OP_FREE ? op->neighbours : op->given;
        for (uint32_t k = 0; k < n; k++) e->is_back_needed[place_of(o, unknown[k])] = true;
    }
}

// --- the whole
// ---------------------------------------------------------------------------------------------------------

static bool allocate(Order *o)
{
    YkElimination *e = o->e;
    const YkMechanism *mech = o->mech;
    size_t steps = mech->step_count + 1, bodies = mech->model->body_count + 1, inputs = mech->input_count + 1;
    e->unknown_count = mech->slot_count + mech->distance_count + 2 * mech->node_count;
    e->operations = calloc(steps, sizeof *e->operations);
    e->elements = calloc(bodies, sizeof *e->elements);
    e->operation_of_input = calloc(inputs, sizeof *e->operation_of_input);
    e->parent_of_input = calloc(inputs, sizeof *e->parent_of_input);
    e->sign_of_input = calloc(inputs, sizeof *e->sign_of_input);
    e->is_back_needed = calloc(steps, sizeof *e->is_back_needed);
    o->raw = calloc(steps, sizeof *o->raw);
    o->raw_first = calloc(steps, sizeof *o->raw_first);
    o->is_needed = calloc(steps, sizeof *o->is_needed);
    o->place = calloc(steps, sizeof *o->place);
    o->defined_by = calloc(e->unknown_count + 1, sizeof *o->defined_by);
    o->head = calloc(e->unknown_count + 1, sizeof *o->head);
    o->element_first = calloc(bodies + 1, sizeof *o->element_first);
    o->element_place = calloc(bodies, sizeof *o->element_place);
    bool ok = e->operations && e->elements && e->operation_of_input && e->parent_of_input && e->sign_of_input &&
              e->is_back_needed && o->raw && o->raw_first && o->is_needed && o->place && o->defined_by && o->head &&
              o->element_first && o->element_place;
    if (!ok) return false;
    for (size_t k = 0; k < inputs; k++) e->operation_of_input[k] = YK_NONE;
    for (size_t k = 0; k < steps; k++) o->place[k] = YK_NONE;
    for (size_t k = 0; k < e->unknown_count + 1; k++) o->defined_by[k] = o->head[k] = YK_NONE;
    return true;
}

static void free_order(Order *o)
{
    free(o->columns.unknown);
    free(o->raw);
    free(o->raw_columns);
    free(o->raw_first);
    free(o->is_needed);
    free(o->place);
    free(o->defined_by);
    free(o->head);
    free(o->links);
    free(o->element_columns);
    free(o->element_first);
    free(o->element_place);
}

YkElimination *yk_elimination_new(const YkMechanism *mech, const bool *is_free, const bool *is_loaded)
{
    YkElimination *e = calloc(1, sizeof *e);
    if (!e) return NULL;
    e->mech = mech;
    Order o = {.e = e, .mech = mech, .is_free = is_free, .is_loaded = is_loaded};
    bool ok = allocate(&o);
    if (ok) {
        add_steps(&o);
        if (!o.failed) add_elements(&o);
        if (!o.failed) { // else lists have gaps
            mark_needed(&o);
            put_in_order(&o);
        }
        ok = !o.failed && sort_elements(&o);
        if (ok) find_fill(&o);
        if (ok) mark_back_needed(&o);
    }
    if (!ok || o.failed) {
        yk_elimination_free(e);
        e = NULL;
    }
    free_order(&o);
    return e;
}

void yk_elimination_free(YkElimination *e)
{
    if (!e) return;
    free(e->operations);
    free(e->elements);
    free(e->pieces);
    free(e->nodes);
    free(e->index);
    free(e->factors);
    free(e->operation_of_input);
    free(e->parent_of_input);
    free(e->sign_of_input);
    free(e->is_back_needed);
    free(e);
}
