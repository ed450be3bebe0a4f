// Dimension inference over a whole file: names, uses, and the order in which they are visited.
//
// Every parameter and every use is a constraint on one expression. A constraint is visited again only when a name in it
// has got its dimension, which happens once for every name. The cost is therefore the sum over expressions of their
// size times the number of open parameters in them: linear for files whose expressions are short.
#include "expr/dimension.h"
#include <string.h>

YkDimensions *yk_dimensions_new(YkArena *arena, const YkUnits *units)
{
    YkDimensions *dims = YK_NEW(arena, YkDimensions, 1);
    if (!dims) return NULL;
    dims->arena = arena;
    dims->units = *units;
    return dims;
}

static void add_name(YkDimensions *dims, YkDimName name)
{
    if (!dims) return;
    if (YK_ROOM_IN(dims->arena, dims->names, dims->name_count, dims->name_capacity))
        dims->names[dims->name_count++] = name;
    else
        dims->failed = true;
}

static void add_constraint(YkDimensions *dims, YkConstraint constraint)
{
    if (!dims) return;
    if (YK_ROOM_IN(dims->arena, dims->constraints, dims->constraint_count, dims->constraint_capacity))
        dims->constraints[dims->constraint_count++] = constraint;
    else
        dims->failed = true;
}

void yk_dimensions_fix(YkDimensions *dims, const char *name, YkDimension dimension)
{
    add_name(dims, (YkDimName){.name = name, .dimension = dimension, .is_known = true});
}

void yk_dimensions_parameter(YkDimensions *dims, const char *name, YkExpr *expr)
{
    add_name(dims, (YkDimName){.name = name, .expr = expr});
}

void yk_dimensions_use(YkDimensions *dims, YkExpr *expr, YkDimension expected, const char *what)
{
    if (expr) add_constraint(dims, (YkConstraint){.expr = expr, .expected = expected, .what = what, .parameter = -1});
}

// Hashes by FNV-1a, with a final mix so that the low bits depend on all.
static size_t hash(const char *name)
{
    uint64_t h = 0xcbf29ce484222325u;
    for (; *name; name++) h = (h ^ (unsigned char)*name) * 0x100000001b3u;
    return (size_t)(h ^ h >> 29);
}

// Returns the slot of a name: where it is, or the empty slot where it belongs.
static int32_t *slot_of(const YkDimensions *dims, const char *name)
{
    size_t mask = dims->slot_count - 1, i = hash(name) & mask;
    while (dims->slots[i] != 0 && strcmp(dims->names[dims->slots[i] - 1].name, name) != 0) i = (i + 1) & mask;
    return &dims->slots[i];
}

// Returns the index of a name, or -1.
static int32_t find(const YkDimensions *dims, const char *name)
{
    return dims->slot_count > 0 ? *slot_of(dims, name) - 1 : -1;
}

static bool index_names(YkDimensions *dims)
{
    size_t count = 16;
    while (count < 2 * dims->name_count) count *= 2;
    dims->slots = YK_NEW(dims->arena, int32_t, count);
    if (!dims->slots) return false;
    dims->slot_count = count;
    for (size_t i = 0; i < dims->name_count; i++) {
        int32_t *slot = slot_of(dims, dims->names[i].name);
        if (*slot == 0) *slot = (int32_t)i + 1; // the first of a repeated name counts
    }
    return true;
}

// Adds the parameters as constraints too, before the uses.
static bool add_parameters(YkDimensions *dims)
{
    YkConstraint *uses = dims->constraints;
    size_t use_count = dims->constraint_count;
    dims->constraints = NULL;
    dims->constraint_count = dims->constraint_capacity = 0;
    for (size_t i = 0; i < dims->name_count; i++)
        if (dims->names[i].expr)
            add_constraint(dims, (YkConstraint){.expr = dims->names[i].expr, .parameter = (int32_t)i});
    for (size_t i = 0; i < use_count; i++) add_constraint(dims, uses[i]);
    return !dims->failed;
}

static void resolve(void *context, const YkExpr *name)
{
    YkDimensions *dims = context;
    int32_t index = find(dims, name->name);
    ((YkExpr *)name)->parameter = index;
    if (index >= 0) dims->first_dependent[index + 1]++;
}

static void note_dependent(void *context, const YkExpr *name)
{
    YkDimensions *dims = context;
    if (name->parameter < 0) return;
    size_t *at = &dims->first_dependent[name->parameter];
    dims->dependents[(*at)++] = (int32_t)(dims->current - dims->constraints);
}

// Indexes which constraints mention a name, by counting and filling: first_dependent[i] becomes the start of i's
// dependents.
static bool index_dependents(YkDimensions *dims)
{
    size_t names = dims->name_count;
    dims->first_dependent = YK_NEW(dims->arena, size_t, names + 2);
    if (!dims->first_dependent) return false;
    for (size_t i = 0; i < dims->constraint_count; i++) yk_expr_names(dims->constraints[i].expr, resolve, dims);
    for (size_t i = 0; i < names; i++) dims->first_dependent[i + 1] += dims->first_dependent[i];
    dims->dependents = YK_NEW(dims->arena, int32_t, dims->first_dependent[names]);
    dims->queue = YK_NEW(dims->arena, int32_t, dims->constraint_count);
    if (!dims->dependents || !dims->queue) return false;
    for (size_t i = 0; i < dims->constraint_count; i++) {
        dims->current = &dims->constraints[i];
        yk_expr_names(dims->current->expr, note_dependent, dims);
    }
    for (size_t i = names; i > 0; i--) dims->first_dependent[i] = dims->first_dependent[i - 1]; // filling advanced them
    dims->first_dependent[0] = 0;
    return true;
}

// Visits a constraint once under the rules of the phase.
static void visit(YkDimensions *dims, YkConstraint *constraint)
{
    YkExpr *expr = constraint->expr;
    dims->current = constraint;
    yk_dim_up(dims, expr);
    YkDimension wanted = constraint->expected;
    bool has_wanted = true;
    if (constraint->parameter >= 0) {
        const YkDimName *name = &dims->names[constraint->parameter];
        if (!name->is_known && expr->state == YK_DIM_KNOWN)
            yk_dim_set(dims, constraint->parameter, expr->dimension, NULL, expr->place);
        wanted = name->dimension;
        has_wanted = name->is_known;
    }
    if (dims->phase == YK_PHASE_OWN) return;
    if (has_wanted && expr->state == YK_DIM_KNOWN && !yk_dimension_equal(expr->dimension, wanted))
        yk_dim_report_use(dims, expr, wanted);
    yk_dim_down(dims, expr, has_wanted ? &wanted : NULL, true);
}

static void drain(YkDimensions *dims)
{
    while (dims->queue_count > 0) {
        YkConstraint *constraint = &dims->constraints[dims->queue[dims->queue_first]];
        dims->queue_first = (dims->queue_first + 1) % dims->constraint_count;
        dims->queue_count--;
        constraint->is_queued = false;
        visit(dims, constraint);
    }
}

static void run_phase(YkDimensions *dims, YkDimPhase phase)
{
    dims->phase = phase;
    for (size_t i = 0; i < dims->constraint_count; i++) yk_dim_queue(dims, (int32_t)i);
    drain(dims);
}

// Returns whether the value comes from functions of literals, as that of cos(15 deg) does.
static bool is_computed(const YkExpr *expr)
{
    if (!expr || !expr->is_literal || expr->kind == YK_EXPR_NUMBER) return false;
    return expr->kind == YK_EXPR_CALL || is_computed(expr->a) || is_computed(expr->b);
}

// Makes what nothing decides a plain number, one parameter at a time, since each may decide the next: of two in a
// product one counts as the number. Sines and cosines become numbers first.
static void settle_open(YkDimensions *dims, bool only_computed)
{
    for (size_t i = 0; i < dims->name_count; i++) {
        if (dims->names[i].is_known || (only_computed && !is_computed(dims->names[i].expr))) continue;
        dims->names[i].is_default = true;
        yk_dim_set(dims, (int32_t)i, YK_DIM_NONE, NULL, (YkPlace){0, 0, 0});
        drain(dims);
    }
}

bool yk_dimensions_run(YkDimensions *dims, YkProblems *problems)
{
    if (!dims || dims->failed || !add_parameters(dims) || !index_names(dims) || !index_dependents(dims)) {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0, 0, 0}, "out of memory");
        return false;
    }
    run_phase(dims, YK_PHASE_OWN);
    run_phase(dims, YK_PHASE_DIRECT);
    run_phase(dims, YK_PHASE_SOLVE);
    settle_open(dims, true);
    settle_open(dims, false);
    dims->problems = problems;
    run_phase(dims, YK_PHASE_FINAL);
    if (dims->failed) yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0, 0, 0}, "out of memory");
    return !dims->has_errors && !dims->failed;
}

bool yk_dimensions_of(const YkDimensions *dims, const char *name, YkDimension *dimension)
{
    int32_t index = dims ? find(dims, name) : -1;
    *dimension = YK_DIM_NONE;
    if (index < 0 || !dims->names[index].is_known || dims->names[index].is_default) return false;
    *dimension = dims->names[index].dimension;
    return true;
}
