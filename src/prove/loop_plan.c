// Prepares the linear equations of all random points once: which symbols they determine, and in each row the slopes of
// these and the rest. A point only inserts its values.
#include "derive/inside.h"
#include "prove/loop_point.h"

typedef struct Filling {
    YkDerivation *d;
    YkLoopSystem *system;
    size_t entry_count, entry_capacity;
    const YkPoisson **slopes; // [unknowns], of one row
} Filling;

static bool add_entry(Filling *f, size_t unknown, const YkPoisson *slope)
{
    if (!slope || yk_ring_is_zero(slope)) return true;
    if (!YK_ROOM_IN(f->d->arena, f->system->entries, f->entry_count, f->entry_capacity)) return false;
    f->system->entries[f->entry_count++] = (YkLoopEntry){(int32_t)unknown, slope};
    return true;
}

// A row that contains products of unknowns is linearised at the point.
static const YkPoisson *split(Filling *f, const YkPoisson *zero, bool *is_split)
{
    YkRing *ring = f->d->ring;
    const YkLoopSystem *s = f->system;
    bool was_well = yk_ring_status(ring) == YK_RING_OK;
    const YkPoisson *rest = yk_ring_split(ring, zero, s->unknowns, s->unknown_count, f->slopes, s->unknown_count);
    *is_split = rest != NULL;
    if (rest || !zero) return rest;
    if (was_well) yk_ring_clear(ring);
    for (size_t k = 0; k < s->unknown_count; k++) f->slopes[k] = yk_ring_coefficient(ring, zero, s->unknowns[k], 1);
    return zero;
}

static bool fill_row(Filling *f, size_t row, const YkPoisson *zero)
{
    bool well = true;
    for (size_t k = 0; k < f->system->unknown_count; k++) f->slopes[k] = NULL;
    f->system->rows[row].rest = split(f, zero, &f->system->rows[row].is_split);
    f->system->rows[row].first = f->entry_count;
    for (size_t k = 0; k < f->system->unknown_count && well; k++) well = add_entry(f, k, f->slopes[k]);
    f->system->rows[row + 1].first = f->entry_count;
    return well;
}

static bool fill(YkDerivation *d, YkLoopSystem *system, const YkPoisson *const *zeros)
{
    Filling f = {.d = d, .system = system};
    f.slopes = YK_NEW(d->arena, const YkPoisson *, system->unknown_count + 1);
    system->rows = YK_NEW(d->arena, YkLoopRow, system->row_count + 1);
    bool well = f.slopes && system->rows;
    for (size_t r = 0; r < system->row_count && well; r++) well = fill_row(&f, r, zeros[r]);
    return well;
}

// --- The three systems

static bool plan_closing(YkDerivation *d, const YkDeriveBlocks *blocks, YkLoopSystem *system)
{
    const YkPoisson **zeros = YK_NEW(d->arena, const YkPoisson *, blocks->row_count + 1);
    int32_t *unknowns = YK_NEW(d->arena, int32_t, d->coordinate_count + d->model->parameter_count + 1);
    if (!zeros || !unknowns) return false;
    for (size_t r = 0; r < blocks->row_count; r++) zeros[r] = blocks->rows[r].value;
    *system = (YkLoopSystem){.unknowns = unknowns, .row_count = blocks->row_count};
    system->unknown_count = yk_loop_linear(d, blocks, unknowns);
    return fill(d, system, zeros);
}

// Relations contain bodies' own accelerations, which become unknowns, each from its parent's and the joint's.
static size_t add_bodies(const YkDerivation *d, int32_t *unknowns, const YkPoisson **zeros)
{
    YkRing *ring = d->ring;
    size_t count = 0;
    for (size_t b = 1; b < d->model->body_count; b++) {
        const YkDeriveBody *body = &d->bodies[b];
        int32_t c = body->joint == YK_NONE ? YK_NONE : d->joint_angle[body->joint];
        if (c == YK_NONE || body->acceleration == d->coordinates[c].acceleration) continue;
        const YkPoisson *step = yk_ring_of(ring, d->coordinates[c].acceleration),
                        *more = yk_ring_subtract(ring, body->spin_rate, d->bodies[body->parent].spin_rate);
        bool is_second = d->model->joints[body->joint].body[1] == (int32_t)b;
        unknowns[count] = body->acceleration;
        zeros[count++] = is_second ? yk_ring_subtract(ring, more, step) : yk_ring_add(ring, more, step);
    }
    return count;
}

// Removes definitions, which may follow from unknowns.
static const YkPoisson *without_definitions(YkDerivation *d, const YkPoisson *zero)
{
    for (size_t k = d->change_count - d->definition_count; k < d->change_count; k++)
        if (yk_ring_mentions(d->ring, zero, d->changes[k].symbol)) return yk_derive_in_joints(d, zero);
    return zero;
}

// Lists unknowns before given ones, so that given ones keep their values.
static void list_unknowns(const YkDerivation *d, const YkDeriveBlocks *blocks, bool accelerations, int32_t *unknowns)
{
    size_t n = d->coordinate_count;
    for (size_t k = 0; k < n; k++) {
        const YkDeriveCoordinate *c = &d->coordinates[blocks->column_order[n - 1 - k]];
        unknowns[k] = accelerations ? c->acceleration : c->rate;
    }
    for (size_t k = 0; accelerations && k < d->unknown_count; k++) unknowns[n + k] = d->unknowns[k];
}

// Adds rows for what a lock holds: it neither moves nor starts to move.
static size_t hold(const YkDerivation *d, bool accelerations, const YkPoisson **zeros)
{
    size_t count = 0;
    for (size_t k = 0; k < d->coordinate_count; k++)
        if (d->coordinates[k].is_held)
            zeros[count++] =
                yk_ring_of(d->ring, accelerations ? d->coordinates[k].acceleration : d->coordinates[k].rate);
    return count;
}

static bool plan_motion(YkDerivation *d, const YkDeriveBlocks *blocks, bool accelerations, YkLoopSystem *system)
{
    size_t own = blocks->row_count, more = accelerations ? d->relation_count : 0,
           n = d->coordinate_count + (accelerations ? d->unknown_count : 0);
    yk_derive_body_angle(d, 0); // makes the changes
    const YkPoisson **zeros =
        YK_NEW(d->arena, const YkPoisson *, own + more + d->coordinate_count + d->model->body_count + 1);
    int32_t *unknowns = YK_NEW(d->arena, int32_t, n + d->model->body_count + 1);
    if (!zeros || !unknowns) return false;
    size_t bodies = accelerations ? add_bodies(d, unknowns, zeros) : 0;
    for (size_t r = 0; r < own; r++) {
        const YkPoisson *row = yk_ring_time_derivative(d->ring, blocks->rows[r].value);
        zeros[bodies + r] = accelerations ? yk_ring_time_derivative(d->ring, row) : row;
    }
    for (size_t r = 0; r < more; r++) zeros[bodies + own + r] = without_definitions(d, d->relations[r]);
    list_unknowns(d, blocks, accelerations, unknowns + bodies);
    size_t held = hold(d, accelerations, zeros + bodies + own + more);
    *system = (YkLoopSystem){
        .unknowns = unknowns, .unknown_count = bodies + n, .row_count = bodies + own + more + held, .held = held};
    return fill(d, system, zeros);
}

// Returns whether the plan is up to date: sections add relations and unknowns.
static bool is_of_today(const YkDerivation *d, const YkLoopPlan *plan)
{
    return plan && plan->relations == d->relation_count && plan->unknowns == d->unknown_count;
}

bool yk_loop_is_large(const YkDerivation *d)
{
    enum { UNKNOWNS_MAX = 2000 };
    return d->coordinate_count + d->unknown_count + d->model->body_count > UNKNOWNS_MAX || yk_derive_is_long(d);
}

const YkLoopPlan *yk_loop_plan(YkDerivation *d)
{
    const YkDeriveBlocks *blocks = yk_derive_blocks(d);
    YkLoopPlan *plan = d->loop_plan;
    if (is_of_today(d, plan)) return plan;
    bool has_loops = plan != NULL; // these stay
    if (!plan) plan = YK_NEW(d->arena, YkLoopPlan, 1);
    if (!blocks || !plan) return NULL;
    if (!has_loops && !(plan_closing(d, blocks, &plan->closing) && plan_motion(d, blocks, false, &plan->rates)))
        return NULL;
    if (!plan_motion(d, blocks, true, &plan->accelerations)) return NULL;
    plan->relations = d->relation_count;
    plan->unknowns = d->unknown_count;
    return d->loop_plan = plan;
}
