// Advances through time: steps, checks between them, and the events that end a step.
#include <string.h>
#include "simulate/crossing.h"

static YkStatus give_up(YkSimulation *sim, YkStatus status, const char *why)
{
    yk_dynamics_fail(sim->dynamics, status, why, "", "");
    sim->report = sim->dynamics->report;
    return sim->status = status;
}

static const char *const near_rest =
    "a drive comes to rest, or turns back, so near to a change point that steps in time do "
    "not show on which side of it the machine goes on; `yoke sweep --over t` does";

static const char *const lost_energy = "the balance of energy is off by more than a thousandth: from a "
                                       "singular position on, or where the steps "
                                       "are too coarse, this is not the machine's motion";

// Counts the present pose, (t, y). Returns false if energy was lost.
static bool count(YkSimulation *sim, const double *y)
{
    memcpy(sim->work, y + 2 * sim->free_count, sim->work_count * sizeof *sim->work);
    yk_simulation_count_energy(sim);
    if (!yk_simulation_has_lost_energy(sim)) return true;
    give_up(sim, YK_NOT_CONVERGED, lost_energy);
    return false;
}

// Solves the pose at (t, y) and counts it.
static bool stand(YkSimulation *sim, double t, const double *y)
{
    if (!yk_simulation_pose(sim, t, y)) return false;
    if (!yk_simulation_agrees_with_guide(sim)) {
        give_up(sim, YK_NOT_CONVERGED, near_rest);
        return false;
    }
    sim->is_elsewhere = true;
    return count(sim, y);
}

// Releases contacts that cannot hold, at once.
static bool settle_contacts(YkSimulation *sim)
{
    if (sim->contact_count == 0) return true;
    bool ok;
    do {
        sim->is_testing = true;
        ok = yk_simulation_pose(sim, sim->time, sim->y);
        sim->is_testing = false;
    } while (ok && yk_simulation_contacts_check(sim));
    return ok;
}

// Starts the stepper at the present time and inputs.
static bool restart_with(YkSimulation *sim, bool keep_step)
{
    double end = sim->options.horizon > sim->time ? sim->options.horizon : sim->target;
    yk_simulation_contacts_start(sim);
    if (!settle_contacts(sim)) return false;
    if (!(end > sim->time)) end = sim->time + 1;
    sim->is_new_step = false;
    YkOdeStatus status = yk_ode_start(sim->ode, sim->time, sim->y, end, keep_step);
    if (status == YK_ODE_OK) return true;
    sim->status = YK_NOT_CONVERGED;
    if (sim->report.message[0] == 0) sim->report = sim->dynamics->report;
    return false;
}

static bool restart(YkSimulation *sim)
{
    return restart_with(sim, false);
}

static const double POOR = 0.2, // sin^2 of the worst block, below which other coordinates are sought
    BLIND = 1e-8;               // and below which the pose does not determine its rates well enough to find any

// Looks for better coordinates if these are near a dead point, and for blocks near a singular position.
static bool look_round(YkSimulation *sim)
{
    bool changed = false;
    if (yk_simulation_margin(sim) < POOR) {
        bool is_blind = yk_simulation_margin(sim) <= BLIND;
        if (is_blind && sim->keeps_apart) return false;
        if (!is_blind && !yk_simulation_recoordinate(sim, &changed)) return false;
        if (changed && !yk_simulation_pose(sim, sim->time, sim->y)) return false;
    }
    yk_simulation_look_near(sim, sim->time);
    if (sim->near_count > 0 && !yk_simulation_look_whether_apart(sim)) return false;
    return !changed || restart(sim);
}

// Lets followers go that their cams would have to pull at the start.
static bool part_cams(YkSimulation *sim)
{
    for (size_t k = 0; k < sim->model->cam_count; k++) {
        if (sim->open[k] || sim->flights[k].is_held || !(yk_simulation_pull(sim, k) > 0)) continue;
        if (!yk_simulation_lift_off(sim, k) || !restart(sim) || !yk_simulation_pose(sim, sim->time, sim->y))
            return false;
        k = SIZE_MAX; // others may have to pull now
    }
    return true;
}

// Prepares the first step, when efforts are set and watches known.
static bool start_moving(YkSimulation *sim)
{
    sim->has_begun = true;
    sim->has_acted = false;
    yk_simulation_tell_start(sim, sim->options.pose);
    yk_simulation_contacts_start(sim);
    yk_simulation_look_near(sim, sim->time);
    if (!settle_contacts(sim) || !stand(sim, sim->time, sim->y)) return false;
    if (!sim->is_flat) sim->near_count = 0; // with accelerations they are known better
    yk_simulation_look_near(sim, sim->time);
    if (!restart(sim) || !yk_simulation_pose(sim, sim->time, sim->y)) return false;
    if (!part_cams(sim) || !look_round(sim)) return false;
    yk_simulation_watch_start(sim);
    return true;
}

// --- failures

static void take_step_end(YkSimulation *sim)
{
    memcpy(sim->y, yk_ode_state(sim->ode), (2 * sim->free_count + sim->work_count) * sizeof *sim->y);
    sim->time = yk_ode_time(sim->ode);
}

static bool has_run_out(const YkSimulation *sim)
{
    return sim->dynamics->ran_out || yk_arena_failed(sim->arena);
}

static YkStatus fail(YkSimulation *sim, YkOdeStatus status)
{
    if (has_run_out(sim)) sim->status = YK_NO_MEMORY;
    if (sim->status == YK_OK) sim->status = status == YK_ODE_NO_MEMORY ? YK_NO_MEMORY : YK_NOT_CONVERGED;
    if (sim->status != YK_NO_MEMORY) yk_simulation_end_at_limit(sim);
    yk_simulation_stand_still(sim);
    if (sim->report.message[0] == 0) yk_simulation_explain(sim);
    return sim->status;
}

// --- events

// Counts an event; gives up if events follow each other without any time between them, since that would never end.
static bool is_going_on(YkSimulation *sim)
{
    enum { STALLED_MAX = 500 };
    bool same = sim->events > 0 && sim->pending_time - sim->last_event <= 1e-15 * fabs(sim->pending_time);
    sim->stalled = same ? sim->stalled + 1 : 0;
    sim->last_event = sim->pending_time;
    sim->events++;
    if (sim->stalled <= STALLED_MAX) return true;
    give_up(sim, YK_NOT_CONVERGED, "stops and dry friction follow each other without end at this time");
    return false;
}

// Changes rates or contacts at the pose of a happening.
static bool change(YkSimulation *sim, YkPendingKind kind)
{
    switch (kind) {
    case YK_PENDING_STOP:
    case YK_PENDING_STICK:
        return yk_simulation_hit(sim, sim->pending_item);
    case YK_PENDING_LIFT_OFF:
        return yk_simulation_lift_off(sim, sim->pending_item);
    case YK_PENDING_LANDING:
        return yk_simulation_land(sim, sim->pending_item);
    default:
        return true; // the restart releases what cannot hold
    }
}

// Handles a happening that ends a step: puts the state there, changes it, and restarts the stepper.
static bool take_pending(YkSimulation *sim)
{
    size_t all = 2 * sim->free_count + sim->work_count;
    if (!is_going_on(sim) || yk_ode_dense(sim->ode, sim->pending_time, sim->dense) != YK_ODE_OK) return false;
    memcpy(sim->y, sim->dense, all * sizeof *sim->y);
    YkPendingKind kind = sim->pending;
    sim->pending = YK_PENDING_NONE;
    if (!yk_simulation_pose(sim, sim->pending_time, sim->y) || !yk_simulation_tell(sim, YK_WITNESS_STEP)) return false;
    if (!change(sim, kind)) return false;
    sim->near_count = 0; // its rates have changed
    sim->first_rate = 0;
    return restart(sim) && stand(sim, sim->time, sim->y) && look_round(sim);
}

// --- steps

static bool has_contacts(const YkSimulation *sim)
{
    for (size_t k = 0; k < sim->item_count; k++)
        if (sim->dynamics->loads->items[k].kind >= YK_LOAD_COULOMB) return true;
    return false;
}

// Examines an accepted step for events. Rows within the step may still be requested.
static void look_back(YkSimulation *sim)
{
    bool is_watched = sim->watch_count > 0 || sim->laws->count > 0;
    if (!is_watched && (sim->is_lean || (sim->model->cam_count == 0 && !has_contacts(sim)))) return;
    yk_simulation_look(sim);
    sim->is_elsewhere = true;
}

// Returns whether positions and rates at the end of a step suffice, far from singular positions and without contacts.
static bool is_plain(const YkSimulation *sim)
{
    return sim->contact_count == 0 && sim->near_count == 0 && yk_simulation_margin(sim) >= 0.25;
}

// Returns to the pose at the end of the last step; usually the last evaluation left it there, without accelerations.
static bool return_to_end(YkSimulation *sim, double t)
{
    memcpy(sim->y, yk_ode_state(sim->ode), (2 * sim->free_count + sim->work_count) * sizeof *sim->y);
    if (!is_plain(sim)) return yk_simulation_pose(sim, t, sim->y);
    if (sim->is_elsewhere && (!yk_simulation_set(sim, t, sim->y) || yk_state_solve(sim->state) < 0)) return false;
    if (sim->is_elsewhere && yk_simulation_margin(sim) < 0.25) return yk_simulation_pose(sim, t, sim->y);
    sim->time = t;
    yk_state_refer(sim->state);
    return true;
}

// Prepares the next step: contacts that release, coordinates that no longer serve, positions where branches meet.
static bool look_ahead(YkSimulation *sim)
{
    double t = yk_ode_time(sim->ode);
    size_t before = sim->contact_count;
    sim->is_new_step = false;
    if (sim->is_lean) return true;
    if (!return_to_end(sim, t) || !yk_simulation_tell(sim, YK_WITNESS_STEP)) return false;
    if (yk_simulation_look_dead(sim)) {
        sim->is_elsewhere = true;
        if (!return_to_end(sim, t)) return false;
    }
    sim->is_elsewhere = false;
    if (before > 0) {
        if (!settle_contacts(sim)) return false;
        if (sim->contact_count < before) return restart(sim) && yk_simulation_pose(sim, t, sim->y) && look_round(sim);
    }
    return yk_simulation_margin(sim) < 0.25 || sim->near_count > 0 ? look_round(sim) : true;
}

static bool is_spent(const YkSimulation *sim)
{
    size_t most = sim->options.steps_max;
    return most > 0 && yk_ode_counts(sim->ode).steps + sim->counts.steps + sim->events >= most;
}

// Sets the end of a step, which must not pass a singular position that is not watched yet: branches could change
// unnoticed.
static void set_end(YkSimulation *sim, double to)
{
    double end = sim->options.horizon >= to ? sim->options.horizon : to, t = yk_ode_time(sim->ode);
    end = fmin(end, fmax(yk_simulation_next_sample(sim), t));
    bool may_cross = !sim->is_lean && sim->options.integrator != YK_INTEGRATOR_RK4 && sim->mech->block_count > 0;
    if (t < sim->redo_until) end = fmin(end, t + sim->redo_step);
    if (may_cross) end = fmin(end, fmax(t + yk_simulation_reach(sim), t + 1e-9 * fabs(t)));
    yk_ode_set_end(sim->ode, end);
}

static bool is_passed(const YkSimulation *sim, double to)
{
    double reached = yk_ode_time(sim->ode);
    return sim->pending != YK_PENDING_NONE ? sim->pending_time >= to : reached >= to;
}

// Samples the energy between rows too, since rows may all meet the same phase of the motion, such as standstill: at the
// end of each of the first steps, then of some.
static bool sample_energy(YkSimulation *sim)
{
    enum { EACH = 64, SOME = 16 };
    size_t steps = yk_ode_counts(sim->ode).steps;
    if (sim->pending != YK_PENDING_NONE || (steps > EACH && steps % SOME != 0)) return true;
    double t = yk_ode_time(sim->ode);
    const double *y = yk_ode_state(sim->ode);
    bool is_there = !sim->dynamics->tree && !sim->is_elsewhere; // open trees are evaluated without a pose
    if (sim->guide || !is_plain(sim)) return stand(sim, t, y);
    if (!is_there && (!yk_simulation_set(sim, t, y) || yk_state_solve(sim->state) < 0)) return stand(sim, t, y);
    if (!is_there) yk_state_refer(sim->state);
    sim->time = t;
    sim->has_forces = false;
    return count(sim, y);
}

// --- acting ---------------------------------------------------------------------------------------

// Forgets what was found in the last step after the time at which the host acts: it no longer happens.
static void forget_future(YkSimulation *sim)
{
    size_t kept = 0;
    for (size_t k = 0; k < sim->happening_count; k++)
        if (sim->happenings[k].time <= sim->time) sim->happenings[kept++] = sim->happenings[k];
    sim->happening_count = kept;
    sim->pending = YK_PENDING_NONE;
}

// Begins anew at the time that stands, which may lie within the last step, with what the host has set.
static bool take_acts(YkSimulation *sim)
{
    double t = sim->time;
    sim->has_acted = false;
    if (yk_ode_dense(sim->ode, t, sim->dense) != YK_ODE_OK) return false;
    memcpy(sim->y, sim->dense, (2 * sim->free_count + sim->work_count) * sizeof *sim->y);
    forget_future(sim);
    if (!yk_simulation_pose(sim, t, sim->y) || !yk_simulation_tell(sim, YK_WITNESS_STEP)) return false;
    if (!restart_with(sim, true)) return false;
    if (!stand(sim, t, sim->y) || !look_round(sim)) return false;
    yk_simulation_watch_start(sim);
    return true;
}

// Begins again at a time of the last step, with the signs that near blocks keep from then on.
static bool begin_again(YkSimulation *sim, double t)
{
    if (yk_ode_dense(sim->ode, t, sim->y) != YK_ODE_OK || !yk_simulation_pose(sim, t, sim->y)) return false;
    return restart(sim) && look_round(sim);
}

// Goes on to time `to`, at most to the next sample of the control.
static YkStatus go_to(YkSimulation *sim, double to)
{
    sim->target = to;
    if (!yk_simulation_start_guide(sim)) yk_arena_fail(sim->arena); // where it begins, and where a saved one goes on
    if (!sim->has_begun && !start_moving(sim)) return fail(sim, YK_ODE_FAILED);
    if (sim->has_acted && !take_acts(sim)) return fail(sim, YK_ODE_FAILED);
    if (to == sim->options.start && yk_ode_time(sim->ode) == to) // the first row
        return stand(sim, to, yk_ode_state(sim->ode)) && !has_run_out(sim) ? YK_OK : fail(sim, YK_ODE_FAILED);
    while (!is_passed(sim, to)) {
        if (sim->pending != YK_PENDING_NONE) {
            if (!take_pending(sim)) return fail(sim, YK_ODE_FAILED);
            continue;
        }
        if (sim->is_new_step && !look_ahead(sim)) return fail(sim, YK_ODE_FAILED);
        if (is_spent(sim)) {
            give_up(sim, YK_NOT_CONVERGED, "the allowed steps are used up");
            take_step_end(sim);
            return fail(sim, YK_ODE_FAILED);
        }
        set_end(sim, to);
        YkOdeStatus status = yk_ode_step(sim->ode);
        if (status != YK_ODE_OK) {
            take_step_end(sim);
            return fail(sim, status);
        }
        if (yk_simulation_must_keep_apart(sim)) {
            if (!begin_again(sim, yk_ode_previous(sim->ode))) return fail(sim, YK_ODE_FAILED);
            continue;
        }
        if (yk_simulation_has_jumped(sim)) {
            if (!yk_simulation_go_home(sim) || !restart(sim) || !look_round(sim)) return fail(sim, YK_ODE_FAILED);
            continue;
        }
        sim->report.message[0] = 0;
        sim->is_new_step = true;
        look_back(sim);
        if (!sample_energy(sim)) return fail(sim, YK_ODE_FAILED);
        double reached = sim->pending != YK_PENDING_NONE ? sim->pending_time : yk_ode_time(sim->ode);
        if (sim->options.goes_on && !sim->options.goes_on(sim->options.context, reached)) to = fmin(to, reached);
    }
    if (yk_ode_dense(sim->ode, to, sim->dense) != YK_ODE_OK) return fail(sim, YK_ODE_FAILED);
    bool stands = stand(sim, to, sim->dense) && yk_simulation_tell(sim, YK_WITNESS_ASIDE);
    return stands && !has_run_out(sim) ? YK_OK : fail(sim, YK_ODE_FAILED);
}

// Calls the control where its sample is due. Returns false if the control ends the advance.
static bool take_sample(YkSimulation *sim)
{
    YkSampling *sampling = &sim->sampling;
    if (sim->time != yk_simulation_next_sample(sim)) return true;
    sampling->count++;
    sim->is_in_control = true;
    bool goes_on = sampling->control(sampling->context, sim, sim->time);
    sim->is_in_control = false;
    return goes_on;
}

YkStatus yk_simulation_advance(YkSimulation *sim, double to)
{
    if (sim->status != YK_OK) return sim->status;
    if (!isfinite(to) || to < sim->time || sim->is_in_control) return YK_BAD_ARGUMENT;
    for (;;) {
        double until = fmin(to, yk_simulation_next_sample(sim));
        YkStatus status = go_to(sim, until);
        bool was_ended = status != YK_OK || sim->time < until;
        if (was_ended || !take_sample(sim) || until == to) return status;
    }
}

YkStatus yk_simulation_step(YkSimulation *sim, double span)
{
    return span >= 0 ? yk_simulation_advance(sim, sim->time + span) : YK_BAD_ARGUMENT;
}
