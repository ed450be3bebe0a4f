// Relations in the plan: once all but one of its angles and distances are known, a relation gives the last.
//
// A sum of inputs is kept as such (a *form*), so that trains of gears and racks stay exact over any number of turns; an
// angle that loops place is taken nearest to a reference that follows the motion.
#include "base/memory.h"
#include "compile/plan.h"
#include "compile/relations.h"

static bool is_known(const YkPlan *plan, YkRelationTerm term)
{
    return term.is_distance ? plan->distance_known[term.index] : plan->root_known[plan->mech->group_root[term.index]];
}

static YkRelationTerm root_of(const YkPlan *plan, YkRelationTerm term)
{
    if (!term.is_distance) term.index = plan->mech->group_root[term.index];
    return term;
}

// Returns the factor of a column in some of a relation's terms.
static double factor_in(const YkPlan *plan, uint32_t first, uint32_t count, YkRelationTerm root)
{
    double sum = 0;
    for (uint32_t k = 0; k < count; k++) {
        YkRelationTerm other = root_of(plan, plan->mech->relation_terms[first + k]);
        if (other.is_distance == root.is_distance && other.index == root.index) sum += other.factor;
    }
    return sum;
}

// Returns whether a term is an unknown. One that cancels in all terms is not: a belt round equal pulleys does not
// involve its carrier.
static bool counts(const YkPlan *plan, const YkRelation *r, YkRelationTerm root)
{
    return fabs(factor_in(plan, r->first_term, r->term_count, root)) > 1e-12 ||
           fabs(factor_in(plan, r->first_argument, r->argument_count, root)) > 1e-12;
}

// Finds the one unknown of a relation and its factor; returns how many unknowns there are (2 for more).
static size_t find_unknown(const YkPlan *plan, const YkRelation *r, YkRelationTerm *unknown)
{
    const YkRelationTerm *terms = plan->mech->relation_terms;
    size_t count = 0;
    for (uint32_t k = 0; k < r->term_count + r->argument_count; k++) { // those of the argument follow
        YkRelationTerm root = root_of(plan, terms[r->first_term + k]);
        if (is_known(plan, terms[r->first_term + k]) || !counts(plan, r, root)) continue;
        if (count == 1 && root.is_distance == unknown->is_distance && root.index == unknown->index) continue;
        if (count == 1 || k >= r->term_count) return 2; // a law is not solved for its argument
        *unknown = root;
        unknown->factor = factor_in(plan, r->first_term, r->term_count, root);
        count = 1;
    }
    bool in_law = count == 1 && fabs(factor_in(plan, r->first_argument, r->argument_count, *unknown)) > 1e-12;
    return in_law || (count == 1 && fabs(unknown->factor) < 1e-12) ? 2 : count;
}

static void add_source(YkPlan *plan, YkRelationSource source, uint32_t first)
{
    YkMechanism *mech = plan->mech;
    for (size_t k = first; k < mech->source_count; k++) {
        if (mech->sources[k].kind != source.kind || mech->sources[k].index != source.index) continue;
        mech->sources[k].factor = yk_plan_add(mech->sources[k].factor, source.factor);
        return;
    }
    if (!YK_ROOM(mech->sources, mech->source_count, mech->source_capacity)) {
        plan->failed = true;
        return;
    }
    if (source.kind == YK_SOURCE_SLOT) source.reference = (int32_t)mech->reference_count++;
    mech->sources[mech->source_count++] = source;
}

// Adds the value of a known term, times its factor, as sources since `first`; returns its constant part.
static double add_term(YkPlan *plan, YkRelationTerm term, double factor, uint32_t first, int32_t skip_root)
{
    YkMechanism *mech = plan->mech;
    if (factor == 0) return 0;
    // Takes only the part beyond the target's group.
    if (!term.is_distance && skip_root >= 0 && mech->group_root[term.index] == skip_root)
        term.index = mech->relative_slot[term.index];
    const YkInputSum *form = yk_plan_sum_of(plan, term);
    if (!form->is_known) {
        YkSourceKind kind = term.is_distance ? YK_SOURCE_DISTANCE : YK_SOURCE_SLOT;
        add_source(plan, (YkRelationSource){kind, term.index, YK_NONE, factor}, first);
        return 0;
    }
    for (size_t k = 0; k < form->count; k++)
        add_source(
            plan,
            (YkRelationSource){YK_SOURCE_INPUT, form->sources[k].index, YK_NONE, factor * form->sources[k].factor},
            first);
    return factor * form->constant;
}

// Notes the target's own form if all its sources are inputs.
static void note_form(YkPlan *plan, const YkRelation *r)
{
    if (r->law) return;
    YkInputSum form = {true, r->offset, yk_from(plan->mech->sources, r->first_source), r->source_count};
    for (uint32_t k = 0; k < r->source_count; k++)
        if (form.sources[k].kind != YK_SOURCE_INPUT) return;
    YkInputSum *target = yk_plan_sum_of(plan, r->target);
    yk_plan_add_sum(plan, target, &form, 1);
    target->is_known = true;
}

typedef struct Columns { // of the group in which a relation is solved
    const YkColumn *items;
    size_t count;
} Columns;

static void add_column(YkPlan *plan, const Columns *columns, YkRelationTerm root, double factor, uint32_t first)
{
    for (size_t c = 0; c < columns->count; c++)
        if (columns->items[c].is_distance == root.is_distance && columns->items[c].index == root.index)
            add_source(plan, (YkRelationSource){YK_SOURCE_COLUMN, (int32_t)c, YK_NONE, factor}, first);
}

// Adds a term to the sources since `first`: an unknown as a column (the target not at all), and known parts as they
// are. Returns the constant part.
static double add_any_term(YkPlan *plan, YkRelationTerm term, double factor, uint32_t first, const Columns *columns)
{
    if (is_known(plan, term)) return add_term(plan, term, factor, first, YK_NONE);
    YkRelationTerm root = root_of(plan, term);
    add_column(plan, columns, root, factor, first);
    return term.is_distance ? 0 : add_term(plan, term, factor, first, root.index);
}

// Writes sources such that offset + sources + gain law(argument) = times (terms - law(argument) - constant), with the
// terms of `from`: the relation itself, or its sum with others.
static void write_sources(YkPlan *plan, YkRelation *r, const YkRelation *from, double times, const Columns *columns)
{
    YkMechanism *mech = plan->mech;
    r->gain = -times;
    r->offset = -times * from->constant;
    r->first_source = (uint32_t)mech->source_count;
    for (uint32_t k = 0; k < from->term_count; k++) {
        YkRelationTerm term = mech->relation_terms[from->first_term + k];
        r->offset += add_any_term(plan, term, times * term.factor, r->first_source, columns);
    }
    r->source_count = (uint32_t)mech->source_count - r->first_source;
    r->first_argument_source = (uint32_t)mech->source_count;
    r->argument_offset = r->argument_constant;
    for (uint32_t k = 0; k < r->argument_count; k++) {
        YkRelationTerm term = mech->relation_terms[r->first_argument + k];
        r->argument_offset += add_any_term(plan, term, term.factor, r->first_argument_source, columns);
    }
    r->argument_source_count = (uint32_t)mech->source_count - r->first_argument_source;
}

static void solve(YkPlan *plan, size_t index, YkRelationTerm unknown)
{
    YkRelation *r = &plan->mech->relations[index];
    r->is_solved = true;
    r->target = unknown;
    write_sources(plan, r, r, -1 / unknown.factor, &(Columns){0});
    note_form(plan, r);
    yk_plan_step(plan, (YkStep){.kind = YK_STEP_RELATION, .target = (int32_t)index});
    yk_plan_learn(plan, (YkColumn){unknown.is_distance, unknown.index});
}

// Makes a check of a relation that repeats others: the pose has to fit it, or its sum with them. Factors that are
// rounding would turn hundreds of turns of an input into a miss.
static void check(YkPlan *plan, size_t index, const YkRelation *from)
{
    YkRelation *r = &plan->mech->relations[index];
    r->is_redundant = true;
    r->weight = yk_relation_weight(plan->mech, r);
    write_sources(plan, r, from, r->weight, &(Columns){0});
    for (size_t k = r->first_source; k < plan->mech->source_count; k++)
        if (fabs(plan->mech->sources[k].factor) < 1e-12 * plan->mech->size) plan->mech->sources[k].factor = 0;
    yk_plan_step(plan, (YkStep){.kind = YK_STEP_CHECK, .target = (int32_t)index});
    plan->mech->redundant_relation_count++;
}

// --- in a group

size_t yk_plan_relation_columns(const YkPlan *plan, size_t relation, YkColumn *columns)
{
    const YkRelation *r = &plan->mech->relations[relation];
    size_t count = 0;
    for (uint32_t k = 0; k < r->term_count + r->argument_count; k++) {
        YkRelationTerm term = plan->mech->relation_terms[r->first_term + k]; // those of the argument follow
        if (is_known(plan, term)) continue;
        YkRelationTerm root = root_of(plan, term);
        size_t at = 0;
        while (at < count && (columns[at].is_distance != root.is_distance || columns[at].index != root.index)) at++;
        if (at == count && counts(plan, r, root)) columns[count++] = (YkColumn){root.is_distance, root.index};
    }
    return count;
}

void yk_plan_group_relation(YkPlan *plan, size_t relation, const YkColumn *columns, size_t count)
{
    YkMechanism *mech = plan->mech;
    YkRelation *r = &mech->relations[relation];
    if (!YK_ROOM(mech->group_relations, mech->group_relation_count, mech->group_relation_capacity)) {
        plan->failed = true;
        return;
    }
    mech->group_relations[mech->group_relation_count++] = (int32_t)relation;
    r->is_solved = true;
    r->weight = yk_relation_weight(mech, r);
    write_sources(plan, r, r, r->weight, &(Columns){columns, count});
}

// --- several at once

// Relations that need each other (the meshes of a planetary set): rows of factors over their unknowns, reduced until
// each row that can have a single unknown has it. Each row remembers the relations of which it is the sum.
typedef struct Rows {
    size_t count, columns;
    int32_t *relation;       // [share]
    int32_t *own;            // [row]: the relation that it was at first
    YkRelationTerm *unknown; // [column]
    double *cell;            // [row][share, then column]
} Rows;

enum { ROWS_MAX = 400 };

static double *shares_of(const Rows *rows, size_t row)
{
    return rows->cell + row * (rows->count + rows->columns);
}

static double *factors_of(const Rows *rows, size_t row)
{
    return shares_of(rows, row) + rows->count;
}

static size_t column_of(Rows *rows, YkRelationTerm root)
{
    for (size_t c = 0; c < rows->columns; c++)
        if (rows->unknown[c].is_distance == root.is_distance && rows->unknown[c].index == root.index) return c;
    rows->unknown[rows->columns] = root;
    return rows->columns++;
}

static bool has_known_argument(const YkPlan *plan, const YkRelation *r)
{
    for (uint32_t k = 0; k < r->argument_count; k++)
        if (!is_known(plan, plan->mech->relation_terms[r->first_argument + k])) return false;
    return true;
}

static bool gather(YkPlan *plan, Rows *rows)
{
    const YkMechanism *mech = plan->mech;
    size_t unknowns = 0;
    rows->relation = YK_NEW(plan->arena, int32_t, mech->relation_count + 1);
    if (!rows->relation) return false;
    for (size_t k = 0; k < mech->relation_count; k++) {
        const YkRelation *r = &mech->relations[k];
        if (r->is_solved || r->is_redundant || r->law || !has_known_argument(plan, r)) continue;
        rows->relation[rows->count++] = (int32_t)k;
        unknowns += r->term_count;
    }
    if (rows->count < 2 || rows->count > ROWS_MAX) return false;
    rows->unknown = YK_NEW(plan->arena, YkRelationTerm, unknowns + 1);
    rows->cell = YK_NEW(plan->arena, double, rows->count *(rows->count + unknowns + 1));
    rows->own = YK_NEW(plan->arena, int32_t, rows->count);
    if (yk_arena_failed(plan->arena)) return false;
    for (int pass = 0; pass < 2; pass++) // first the columns, then, once their number is known, the factors
        for (size_t i = 0; i < rows->count; i++) {
            const YkRelation *r = &mech->relations[rows->relation[i]];
            rows->own[i] = rows->relation[i];
            if (pass == 1) shares_of(rows, i)[i] = 1;
            for (uint32_t k = 0; k < r->term_count; k++) {
                YkRelationTerm term = mech->relation_terms[r->first_term + k];
                if (is_known(plan, term)) continue;
                size_t c = column_of(rows, root_of(plan, term));
                if (pass == 1) factors_of(rows, i)[c] += term.factor;
            }
        }
    return true;
}

static void subtract_row(Rows *rows, size_t i, size_t from, double times)
{
    double *x = shares_of(rows, i), *y = shares_of(rows, from);
    for (size_t k = 0; k < rows->count + rows->columns; k++) x[k] = yk_plan_add(x[k], -times * y[k]);
}

static void swap_rows(Rows *rows, size_t i, size_t j)
{
    int32_t own = rows->own[i];
    rows->own[i] = rows->own[j];
    rows->own[j] = own;
    double *x = shares_of(rows, i), *y = shares_of(rows, j);
    for (size_t k = 0; k < rows->count + rows->columns; k++) {
        double kept = x[k];
        x[k] = y[k];
        y[k] = kept;
    }
}

// Reduces by Gauss and Jordan, with the largest pivot of each column.
static void reduce(Rows *rows)
{
    size_t rank = 0;
    for (size_t c = 0; c < rows->columns && rank < rows->count; c++) {
        size_t best = rank;
        for (size_t i = rank; i < rows->count; i++)
            if (fabs(factors_of(rows, i)[c]) > fabs(factors_of(rows, best)[c])) best = i;
        double pivot = factors_of(rows, best)[c];
        if (fabs(pivot) < 1e-12) continue;
        if (best != rank) swap_rows(rows, best, rank);
        for (size_t i = 0; i < rows->count; i++) {
            double x = factors_of(rows, i)[c];
            if (i != rank && x != 0) subtract_row(rows, i, rank, x / pivot);
        }
        rank++;
    }
}

// Appends the sum of relations that a row stands for as a relation of its own.
static size_t derive(YkPlan *plan, const Rows *rows, size_t row)
{
    YkMechanism *mech = plan->mech;
    size_t index = mech->relation_count + mech->derived_count++;
    YkRelation *sum = &mech->relations[index];
    *sum = (YkRelation){.kind = YK_RELATION_GEAR, .first_term = (uint32_t)mech->relation_term_count};
    for (size_t k = 0; k < rows->count; k++) {
        double share = shares_of(rows, row)[k];
        const YkRelation *r = &mech->relations[rows->relation[k]];
        if (share == 0) continue;
        sum->name = r->name;
        sum->constant += share * r->constant;
        for (uint32_t t = 0; t < r->term_count; t++) {
            YkRelationTerm term = mech->relation_terms[r->first_term + t];
            term.factor *= share;
            if (!yk_relation_add_term(mech, sum->first_term, term)) plan->failed = true;
        }
    }
    sum->term_count = (uint32_t)mech->relation_term_count - sum->first_term;
    return index;
}

// Handles a row without unknowns: the relation that it was at first repeats others. In their sum all that they tie
// cancels, so that it does not matter how often a wheel has turned.
static void check_row(YkPlan *plan, const Rows *rows, size_t row)
{
    size_t sum = derive(plan, rows, row);
    check(plan, (size_t)rows->own[row], &plan->mech->relations[sum]);
}

// Solves what the relations determine together; returns whether there was anything.
static bool solve_together(YkPlan *plan)
{
    Rows rows = {0};
    bool solved = false;
    if (!gather(plan, &rows)) return false;
    reduce(&rows);
    for (size_t i = 0; i < rows.count && !plan->failed; i++) {
        if (plan->mech->derived_count == plan->mech->relation_count) break; // each derived relation uses one up
        size_t single = rows.columns, count = 0;
        for (size_t c = 0; c < rows.columns; c++)
            if (factors_of(&rows, i)[c] != 0) {
                single = c;
                count++;
            }
        if (count == 0) check_row(plan, &rows, i);
        if (count != 1 || is_known(plan, rows.unknown[single])) continue;
        size_t index = derive(plan, &rows, i);
        YkRelationTerm unknown = rows.unknown[single];
        unknown.factor = factors_of(&rows, i)[single];
        solve(plan, index, unknown);
        solved = true;
    }
    for (size_t k = 0; k < rows.count && solved; k++) { // the relations that are used up
        YkRelation *r = &plan->mech->relations[rows.relation[k]];
        YkRelationTerm unknown;
        if (!r->is_redundant && find_unknown(plan, r, &unknown) == 0) r->is_solved = true;
    }
    return solved;
}

bool yk_plan_relations(YkPlan *plan)
{
    YkMechanism *mech = plan->mech;
    bool solved = false;
    if (mech->relation_count == 0 || !yk_plan_sums(plan)) return false;
    for (size_t k = 0; k < mech->relation_count && !plan->failed; k++) {
        YkRelation *r = &mech->relations[k];
        YkRelationTerm unknown = {0};
        if (r->is_solved || r->is_redundant) continue;
        size_t count = find_unknown(plan, r, &unknown);
        if (count == 0) check(plan, k, r);
        if (count != 1) continue;
        solve(plan, k, unknown);
        solved = true;
    }
    return solved || solve_together(plan);
}

void yk_plan_coordinate_sums(YkPlan *plan)
{
    YkMechanism *mech = plan->mech;
    for (size_t k = 0; k < mech->coordinate_count; k++) {
        YkTreeCoordinate *c = &mech->coordinates[k];
        c->is_sum = mech->relation_count > 0 && plan->forms && !c->is_distance && plan->forms[c->angle.a].is_known &&
                    plan->forms[c->angle.b].is_known;
        if (!c->is_sum) continue;
        c->first_source = (uint32_t)mech->source_count;
        c->sum_offset = c->angle.offset;
        c->sum_offset += add_term(plan, (YkRelationTerm){false, c->angle.b, 1}, 1, c->first_source, YK_NONE);
        c->sum_offset += add_term(plan, (YkRelationTerm){false, c->angle.a, -1}, -1, c->first_source, YK_NONE);
        c->source_count = (uint32_t)mech->source_count - c->first_source;
    }
}
