// Independent coordinates: everything that belongs to a choice of them, and another choice when this one approaches a
// dead point.
#include <stdlib.h>
#include <string.h>
#include "simulate/simulation.h"

static size_t driven_count(const YkDynamics *d)
{
    size_t count = 0;
    for (size_t i = 0; i < d->mech->input_count; i++) count += !d->is_free[i];
    return count;
}

static bool allocate(YkSimulation *sim)
{
    size_t inputs = sim->mech->input_count, items = yk_simulation_contacts_max(sim),
           all = 2 * sim->free_count + sim->work_count;
    YkArena *a = sim->room;
    sim->free_input = yk_arena_alloc(a, inputs + 1, sizeof *sim->free_input);
    sim->y = yk_arena_alloc(a, 7 * (all + 1), sizeof *sim->y);
    sim->response =
        yk_arena_alloc(a, (items + 1) * (inputs + items + 5) + YK_BOUNDED_WORK(items), sizeof *sim->response);
    sim->bounds = yk_arena_alloc(a, items + 1, sizeof *sim->bounds);
    sim->contact_order = yk_arena_alloc(a, YK_BOUNDED_ORDER(items) + 1, sizeof *sim->contact_order);
    sim->contacts = yk_arena_alloc(a, items + 1, sizeof *sim->contacts);
    sim->near = yk_arena_alloc(a, 2 * (sim->mech->block_count + 1), sizeof *sim->near);
    sim->searches = yk_arena_alloc(a, sim->mech->block_count + 1, sizeof *sim->searches);
    size_t pose = 4 * sim->mech->slot_count + 3 * sim->mech->distance_count + 6 * sim->mech->node_count;
    sim->pose_sum = yk_arena_alloc(a, pose + 1, sizeof *sim->pose_sum);
    if (yk_arena_failed(a)) return false;
    sim->dense = sim->y + all + 1;
    sim->rate = sim->dense + all + 1;
    sim->moved = sim->rate + all + 1;
    sim->sampled = sim->moved + all + 1;
    sim->looked = sim->sampled + all + 1;
    sim->work = sim->looked + all + 1;
    sim->matrix = sim->response + (items + 1) * inputs;
    sim->bias = sim->matrix + (items + 1) * items;
    sim->lambda = sim->bias + items + 1;
    sim->wanted = sim->lambda + items + 1;
    sim->kept = sim->wanted + items + 1;
    sim->contact_work = sim->kept + items + 1;
    sim->near_next = sim->near + sim->mech->block_count + 1;
    return true;
}

bool yk_simulation_stepper(YkSimulation *sim)
{
    static const YkOdeMethod methods[] = {YK_ODE_DOP853, YK_ODE_SDIRK4, YK_ODE_RK4};
    size_t n = sim->free_count, all = 2 * n + sim->work_count;
    double *scale = sim->sampled, energy = yk_simulation_energy_scale(sim);
    for (size_t k = 0; k < all; k++) {
        bool is_distance = k < 2 * n && sim->mech->coordinates[sim->mech->inputs[sim->free_input[k % n]]].is_distance;
        scale[k] = k >= 2 * n ? energy : is_distance ? sim->mech->size : 1;
    }
    // The work of drives does not follow from the free motion, so works are then under error control too. Works that
    // are always 0 must not reduce the mean of the errors.
    size_t controlled = sim->has_drives ? all : 2 * n;
    double share = n > 0 ? sqrt(2 * (double)n / (double)controlled) : 1;
    YkOdeOptions options = {.method = methods[sim->options.integrator],
                            .relative = share * sim->options.tolerance,
                            .absolute = share * sim->options.tolerance,
                            .scale = scale,
                            .controlled = controlled,
                            .fixed_step = sim->options.step};
    sim->ode = yk_ode_new(all, &options, yk_simulation_motion, sim);
    return sim->ode != NULL;
}

static bool is_lean(const YkSimulation *sim)
{
    return sim->dynamics->tree != NULL;
}

// They come before all other inputs.
static bool keep_choice(YkSimulation *sim, const YkCompileOptions *compile)
{
    sim->chosen_count = compile ? compile->input_count : 0;
    sim->room = yk_arena_new();
    sim->chosen = YK_NEW(sim->room, int32_t, sim->chosen_count);
    for (size_t k = 0; sim->chosen && k < sim->chosen_count; k++)
        sim->chosen[k] = (int32_t)yk_coordinate_find(sim->mech, compile->inputs[k]);
    return sim->chosen != NULL;
}

bool yk_simulation_build(YkSimulation *sim, const YkCompileOptions *compile, YkProblems *problems)
{
    YkCompileOptions with = compile ? *compile : yk_default_compile_options();
    with.open_cams = sim->open;
    sim->mech = yk_mechanism_compile(sim->model, &with, problems);
    if (!sim->mech || !keep_choice(sim, compile)) return false;
    sim->state = yk_state_new(sim->mech);
    sim->dynamics = sim->state ? yk_dynamics_new(sim->mech, problems) : NULL;
    if (!sim->dynamics) return false;
    if (sim->options.pulls > 0 && !yk_loads_set_handles(sim->dynamics->loads, sim->options.pulls)) return false;
    for (size_t c = 0; sim->has_effort && sim->effort && c < sim->mech->coordinate_count; c++)
        if (sim->has_effort[c]) yk_dynamics_set_effort(sim->dynamics, c, sim->effort[c]);
    size_t driven = driven_count(sim->dynamics);
    sim->item_count = sim->dynamics->loads->item_count;
    sim->free_count = sim->mech->input_count - driven;
    sim->work_count = sim->item_count + driven + (sim->options.pulls > 0) + 1;
    sim->has_drives = driven > 0;
    if (!yk_dynamics_prepare(sim->dynamics) || !allocate(sim)) return false;
    sim->is_lean = is_lean(sim);
    size_t k = 0;
    for (size_t i = 0; i < sim->mech->input_count; i++)
        if (sim->dynamics->is_free[i]) sim->free_input[k++] = (int32_t)i;
    return true;
}

// Forgets all that belongs to the machine as it is compiled.
static void forget(YkSimulation *sim)
{
    sim->ode = NULL;
    sim->dynamics = NULL;
    sim->state = sim->guide = sim->home = NULL;
    sim->mech = NULL;
    sim->room = NULL;
    sim->y = NULL;
    sim->near_count = 0;
}

void yk_simulation_unbuild(YkSimulation *sim)
{
    if (sim->ode) {
        YkOdeCounts c = yk_ode_counts(sim->ode);
        sim->counts.steps += c.steps;
        sim->counts.rejected += c.rejected;
        sim->counts.evaluations += c.evaluations;
        sim->counts.jacobians += c.jacobians;
    }
    yk_ode_free(sim->ode);
    yk_dynamics_free(sim->dynamics);
    yk_state_free(sim->state);
    yk_state_free(sim->guide);
    yk_state_free(sim->home);
    yk_mechanism_free(sim->mech);
    yk_arena_free(sim->room);
    forget(sim);
    sim->contact_count = 0;
}

// --- taking

static void carry_over(YkSimulation *to, YkSimulation *from)
{
    YkState *s = to->state;
    for (size_t c = 0; c < to->mech->coordinate_count; c++) {
        s->guess[c] = s->reference[c] = yk_state_coordinate(from->state, c).position;
        s->is_guessed[c] = true;
    }
    for (size_t k = 0; k < from->item_count; k++) {
        const YkLoadItem *old = &from->dynamics->loads->items[k];
        YkLoadItem *item = &to->dynamics->loads->items[k];
        item->dry = old->dry;
        item->is_held = old->is_held;
        item->direction = old->direction;
    }
    size_t handles = from->dynamics->loads->handle_count;
    if (handles > 0) memcpy(to->dynamics->loads->handles, from->dynamics->loads->handles, handles * sizeof(YkHandle));
    memcpy(to->contacts, from->contacts, from->contact_count * sizeof *to->contacts);
    memcpy(to->lambda, from->lambda, from->contact_count * sizeof *to->lambda);
    size_t works = to->work_count < from->work_count ? to->work_count : from->work_count;
    memcpy(to->y + 2 * to->free_count, from->y + 2 * from->free_count, works * sizeof *to->y);
}

// Puts the new machine into the pose of the old one; returns false if it does not fit.
static bool move_over(YkSimulation *to, YkSimulation *from)
{
    YkState *s = to->state;
    carry_over(to, from);
    if (yk_simulation_set_time(to, s, from->time, NULL) < 0) return false;
    for (size_t k = 0; k < to->free_count; k++) {
        size_t i = (size_t)to->free_input[k], c = (size_t)to->mech->inputs[i];
        YkMotion m = yk_state_coordinate(from->state, c);
        to->y[k] = m.position;
        to->y[to->free_count + k] = m.velocity;
        yk_state_set_input(s, i, (YkMotion){m.position, m.velocity, 0});
    }
    if (yk_state_assemble(s) < 0) return false;
    for (size_t c = 0; c < to->mech->coordinate_count; c++) {
        double scale = to->mech->coordinates[c].is_distance ? to->mech->size : 1;
        if (!(fabs(yk_state_coordinate(s, c).position - s->guess[c]) < 1e-5 * scale)) return false;
    }
    yk_state_refer(s);
    return true;
}

// Returns whether a build failed for want of memory. Every other failure has an error of its own.
static bool is_out_of_memory(const YkProblems *problems)
{
    if (!problems || yk_problems_error_count(problems) == 0) return true;
    for (size_t k = 0; k < yk_problems_count(problems); k++)
        if (yk_problems_get(problems, k)->code == YK_CODE_OUT_OF_MEMORY) return true;
    return false;
}

bool yk_simulation_take(YkSimulation *sim, const size_t *order, bool *changed)
{
    const char **names = calloc(sim->free_count + 1, sizeof *names);
    if (!names) return false;
    for (size_t j = 0; j < sim->free_count; j++) names[j] = sim->mech->coordinates[order[j]].name;
    bool ok = yk_simulation_take_named(sim, names, sim->free_count, sim->free_count, changed);
    free(names);
    return ok;
}

// Returns whether something determines how the new machine moves: a body that is free now may have no mass.
static bool can_move(YkSimulation *sim)
{
    return sim->contact_count > 0 || yk_dynamics_reduce(sim->dynamics, sim->state) == YK_OK;
}

bool yk_simulation_take_named(YkSimulation *sim, const char *const *names, size_t count, size_t free_count,
                              bool *changed)
{
    YkSimulation next = *sim;
    forget(&next);
    YkProblems *quiet = yk_problems_new();
    bool is_built = yk_simulation_build(&next, &(YkCompileOptions){.inputs = names, .input_count = count}, quiet);
    bool has_memory = is_built || !is_out_of_memory(quiet);
    bool ok = is_built && next.free_count == free_count && move_over(&next, sim);
    if (ok && free_count > sim->free_count) ok = can_move(&next);
    yk_problems_free(quiet);
    if (!ok) {
        yk_simulation_unbuild(&next);
        return has_memory; // keep the present coordinates
    }
    if (sim->witness && sim->has_begun) yk_simulation_tell_start(&next, sim->state);
    yk_simulation_unbuild(sim);
    next.counts = sim->counts;
    *sim = next;
    sim->summary.recoordinations++;
    *changed = true;
    return yk_simulation_stepper(sim);
}
