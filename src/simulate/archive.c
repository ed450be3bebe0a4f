// A simulation as bytes, piece by piece: the same function writes and reads.
#include <string.h>
#include "base/memory.h"
#include "num/bounded.h"
#include "simulate/archive.h"

#define NUMBERS(archive, ...) walk_list(archive, (double *const[]){__VA_ARGS__, NULL})

static void walk_list(YkArchive *a, double *const *numbers)
{
    for (; *numbers; numbers++) yk_archive_numbers(a, *numbers, 1);
}

static size_t walk_index(YkArchive *a, size_t index, size_t count)
{
    int64_t value = (int64_t)index;
    yk_archive_choice(a, &value, 0, count > 0 ? (int64_t)count - 1 : 0);
    return (size_t)value;
}

// Writes or reads how many of something follow that take at least `size` bytes each.
static size_t walk_count(YkArchive *a, size_t count, size_t size)
{
    int64_t value = (int64_t)count, most = a->is_reading ? (int64_t)((a->capacity - a->at) / size) : INT64_MAX;
    yk_archive_choice(a, &value, 0, most);
    return a->failed ? 0 : (size_t)value;
}

// --- how it is made -------------------------------------------------------------------------------

void yk_simulation_archive_options(YkSimulation *sim, YkArchive *a)
{
    YkSimulationOptions *o = &sim->options;
    int64_t integrator = o->integrator;
    yk_archive_choice(a, &integrator, YK_INTEGRATOR_DOP853, YK_INTEGRATOR_RK4);
    o->integrator = (YkIntegrator)integrator;
    NUMBERS(a, &o->tolerance, &o->step, &o->start, &o->horizon);
    yk_archive_sizes(a, (size_t *const[]){&o->steps_max}, 1);
    o->pulls = walk_count(a, o->pulls, 1);
    double size = o->integrator == YK_INTEGRATOR_RK4 ? o->step : o->tolerance;
    if (a->is_reading && !(size > 0 && isfinite(size) && isfinite(o->start))) a->failed = true;
}

void yk_simulation_archive_flights(YkSimulation *sim, YkArchive *a)
{
    yk_archive_flags(a, sim->open, sim->model->cam_count);
    for (size_t k = 0; k < sim->model->cam_count; k++) {
        YkFlight *flight = &sim->flights[k];
        NUMBERS(a, &flight->way);
        yk_archive_flags(a, &flight->is_held, 1);
        if (flight->way != 1 && flight->way != -1 && (flight->way != 0 || sim->open[k])) a->failed = true;
    }
}

void yk_simulation_archive_choice(YkArchive *a, int32_t *chosen, size_t count, size_t coordinate_count)
{
    for (size_t k = 0; k < count; k++) chosen[k] = (int32_t)walk_index(a, (size_t)chosen[k], coordinate_count);
}

// --- names ----------------------------------------------------------------------------------------

static const char *walk_name(YkSimulation *sim, YkArchive *a, const char *name)
{
    size_t length = walk_count(a, a->is_reading ? 0 : strlen(name), 1);
    if (!a->is_reading) {
        if (a->bytes && a->capacity - a->at >= length) memcpy(a->bytes + a->at, name, length);
        a->at += length;
        return name;
    }
    const char *copy = a->failed ? NULL : yk_arena_copy(sim->arena, (const char *)a->bytes + a->at, length);
    if (copy) a->at += length;
    return copy ? copy : "";
}

// Returns how many indices a channel of this kind may have.
static size_t channels_of(const YkSimulation *sim, YkChannelKind kind)
{
    switch (kind) {
    case YK_CHANNEL_COORDINATE:
    case YK_CHANNEL_EFFORT:
    case YK_CHANNEL_EFFORT_FROM:
    case YK_CHANNEL_EFFORT_TO:
        return sim->mech->coordinate_count;
    case YK_CHANNEL_JOINT_ANGLE:
    case YK_CHANNEL_JOINT_DISTANCE:
        return sim->model->joint_count;
    case YK_CHANNEL_BODY:
        return sim->model->body_count;
    case YK_CHANNEL_POINT_X:
    case YK_CHANNEL_POINT_Y:
    case YK_CHANNEL_POINT_SPEED:
        return sim->model->point_count;
    case YK_CHANNEL_FORCE_X:
    case YK_CHANNEL_FORCE_Y:
    case YK_CHANNEL_FORCE:
    case YK_CHANNEL_MOMENT:
        return sim->model->joint_count + yk_dynamics_contact_count(sim->dynamics);
    default:
        return INT32_MAX; // also for blocks that no longer exist, and where the index is meaningless
    }
}

static void walk_channel(const YkSimulation *sim, YkArchive *a, YkChannel *c)
{
    int64_t kind = c->kind, index = c->index, order = c->order, quantity = c->quantity;
    yk_archive_choice(a, &kind, YK_CHANNEL_TIME, YK_CHANNEL_EFFORT_TO);
    yk_archive_choice(a, &index, 0, (int64_t)channels_of(sim, (YkChannelKind)kind) - 1);
    yk_archive_choice(a, &order, 0, 2);
    yk_archive_choice(a, &quantity, 0, YK_QUANTITY_COUNT - 1);
    *c = (YkChannel){(YkChannelKind)kind, (int)index, (int)order, (YkQuantity)quantity};
}

static void walk_watches(YkSimulation *sim, YkArchive *a)
{
    size_t count = walk_count(a, sim->watch_count, 8);
    for (size_t k = 0; k < count && !a->failed; k++) {
        if (a->is_reading && !YK_ROOM(sim->watches, sim->watch_count, sim->watch_capacity)) yk_arena_fail(sim->arena);
        if (yk_arena_failed(sim->arena)) return;
        YkEventWatch *w = &sim->watches[k];
        if (a->is_reading) *w = (YkEventWatch){.name = ""};
        int64_t direction = w->direction;
        w->name = walk_name(sim, a, w->name);
        walk_channel(sim, a, &w->channel);
        yk_archive_choice(a, &direction, INT32_MIN, INT32_MAX);
        w->direction = (int)direction;
        NUMBERS(a, &w->level, &w->last);
        sim->watch_count = k + 1 > sim->watch_count ? k + 1 : sim->watch_count;
    }
}

static void walk_happenings(YkSimulation *sim, YkArchive *a)
{
    size_t count = walk_count(a, sim->happening_count, 8);
    for (size_t k = 0; k < count && !a->failed; k++) {
        if (a->is_reading && !YK_ROOM(sim->happenings, sim->happening_count, sim->happening_capacity))
            yk_arena_fail(sim->arena);
        if (yk_arena_failed(sim->arena)) return;
        YkHappening *h = &sim->happenings[k];
        if (a->is_reading) *h = (YkHappening){.name = ""};
        int64_t kind = h->kind;
        yk_archive_choice(a, &kind, YK_HAPPENING_STOP, YK_HAPPENING_PULL);
        h->kind = (YkHappeningKind)kind;
        NUMBERS(a, &h->time, &h->value);
        h->name = walk_name(sim, a, h->name);
        sim->happening_count = k + 1 > sim->happening_count ? k + 1 : sim->happening_count;
    }
}

// --- what acts ------------------------------------------------------------------------------------

static void walk_commands(YkSimulation *sim, YkArchive *a)
{
    for (size_t k = 0; sim->commands && k < sim->mech->coordinate_count; k++) {
        YkCommand *c = &sim->commands[k];
        yk_archive_flags(a, &c->is_set, 1);
        NUMBERS(a, &c->time, &c->position, &c->rate, &c->acceleration);
    }
}

static void walk_loads(YkSimulation *sim, YkArchive *a)
{
    YkLoads *loads = sim->dynamics->loads;
    for (size_t k = 0; k < loads->item_count; k++) {
        YkLoadItem *item = &loads->items[k];
        NUMBERS(a, &item->direction, &item->last, &item->dry);
        yk_archive_flags(a, &item->is_held, 1);
    }
    for (size_t k = 0; k < loads->handle_count; k++) {
        YkHandle *h = &loads->handles[k];
        yk_archive_flags(a, &h->is_on, 1);
        h->end.body = (int32_t)walk_index(a, (size_t)h->end.body, sim->model->body_count);
        NUMBERS(a, &h->end.from_origin.x, &h->end.from_origin.y, &h->end.arm.x, &h->end.arm.y, &h->target.x,
                &h->target.y, &h->force.x, &h->force.y, &h->stiffness, &h->damping);
    }
    NUMBERS(a, &loads->handle_power);
}

static bool is_contact_kind(const YkLoadItem *item)
{
    return item->kind == YK_LOAD_COULOMB || item->kind == YK_LOAD_STOP;
}

static void walk_contacts(YkSimulation *sim, YkArchive *a)
{
    size_t items = sim->item_count, inputs = sim->mech->input_count;
    sim->contact_count = walk_index(a, sim->contact_count, items + 1);
    for (size_t k = 0; k < sim->contact_count; k++) {
        YkContact *c = &sim->contacts[k];
        c->item = walk_index(a, c->item, items);
        c->cam = YK_NONE;
        NUMBERS(a, &c->low, &c->high);
        if (!is_contact_kind(&sim->dynamics->loads->items[c->item])) a->failed = true;
    }
    size_t most = yk_simulation_contacts_max(sim);
    yk_archive_numbers(a, sim->response, (most + 1) * (inputs + most + 5) + YK_BOUNDED_WORK(most));
    sim->pending_item = walk_index(a, sim->pending_item, most);
    int64_t pending = sim->pending;
    yk_archive_choice(a, &pending, YK_PENDING_NONE, YK_PENDING_LANDING);
    sim->pending = (YkPendingKind)pending;
    bool is_of_item = sim->pending == YK_PENDING_STOP || sim->pending == YK_PENDING_STICK;
    if (is_of_item && (sim->pending_item >= items || !is_contact_kind(&sim->dynamics->loads->items[sim->pending_item])))
        a->failed = true;
    bool is_of_cam = sim->pending == YK_PENDING_LIFT_OFF || sim->pending == YK_PENDING_LANDING;
    if (is_of_cam && sim->pending_item >= sim->model->cam_count) a->failed = true;
}

static void walk_near(YkSimulation *sim, YkArchive *a)
{
    size_t blocks = sim->mech->block_count;
    sim->near_count = walk_index(a, sim->near_count, blocks + 1);
    for (size_t k = 0; k < sim->near_count; k++) {
        YkNear *near = &sim->near[k];
        near->block = walk_index(a, near->block, blocks);
        NUMBERS(a, &near->angle, &near->rate, &near->acceleration);
    }
}

// The guide stands at the last evaluation, which may be ahead of the simulation, and knows from where it came.
static void walk_guide(YkSimulation *sim, YkArchive *a)
{
    bool has_guide = sim->guide != NULL;
    yk_archive_flags(a, &has_guide, 1);
    if (has_guide && (sim->free_count > 0 || sim->mech->block_count == 0)) a->failed = true;
    if (!has_guide || a->failed) return;
    if (!sim->guide) sim->guide = yk_state_new(sim->mech);
    if (sim->guide)
        yk_state_archive(sim->guide, a);
    else
        yk_arena_fail(sim->arena);
}

// --- the rest -------------------------------------------------------------------------------------

static void walk_scalars(YkSimulation *sim, YkArchive *a)
{
    YkSimulationSummary *s = &sim->summary;
    NUMBERS(a, &sim->time, &sim->near_time, &sim->flat_slope, &sim->flat_kinetic, &sim->fastest, &sim->pending_time,
            &sim->last_event, &sim->first_rate, &sim->energy_low, &sim->energy_high, &sim->kinetic_high,
            &sim->energy_off, &sim->target, &sim->sampling.from, &sim->sampling.period, &s->worst_residual,
            &s->energy_start, &s->energy_end);
    bool *const flags[] = {&sim->has_acted, &sim->is_flat,     &sim->is_testing,   &sim->has_energy,
                           &sim->has_begun, &sim->is_new_step, &sim->is_elsewhere, &sim->keeps_apart};
    for (size_t k = 0; k < sizeof flags / sizeof *flags; k++) yk_archive_flags(a, flags[k], 1);
    size_t *const sizes[] = {
        &sim->stalled,      &sim->events,          &sim->sampling.count,     &s->recoordinations,
        &sim->counts.steps, &sim->counts.rejected, &sim->counts.evaluations, &sim->counts.jacobians};
    yk_archive_sizes(a, sizes, sizeof sizes / sizeof *sizes);
    int64_t first = sim->first, status = sim->status;
    yk_archive_choice(a, &first, YK_NONE, (int64_t)sim->mech->coordinate_count - 1);
    yk_archive_choice(a, &status, YK_STOPPED, YK_SINGULAR);
    sim->first = (int32_t)first;
    sim->status = (YkStatus)status;
    yk_report_archive(&sim->report, sim->mech, a);
    yk_report_archive(&sim->dynamics->report, sim->mech, a);
}

void yk_simulation_archive_rest(YkSimulation *sim, YkArchive *a)
{
    size_t all = 2 * sim->free_count + sim->work_count;
    walk_scalars(sim, a);
    yk_state_archive(sim->state, a);
    walk_guide(sim, a);
    yk_ode_archive(sim->ode, a);
    yk_archive_numbers(a, sim->y, 7 * (all + 1));
    yk_archive_numbers(a, sim->dynamics->q, 5 * (sim->mech->input_count + 1));
    walk_commands(sim, a);
    walk_loads(sim, a);
    walk_contacts(sim, a);
    walk_near(sim, a);
    walk_watches(sim, a);
    walk_happenings(sim, a);
}
