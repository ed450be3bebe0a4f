// Impacts: stops that are hit, several at once if reached together; which coordinates rest, rebound or are struck away.
#include "simulate/contact.h"

static bool is_of_kind(const YkSimulation *sim, size_t contact, YkLoadKind kind)
{
    return sim->contacts[contact].cam == YK_NONE && yk_simulation_item(sim, contact)->kind == kind;
}

// Finds impulses that bring the contacts' rates to `wanted`, within the contacts' bounds. Returns false if there are
// none.
static bool strike(YkSimulation *sim)
{
    YkDynamics *d = sim->dynamics;
    size_t n = sim->mech->input_count;
    double before = yk_dynamics_energy_at(d, sim->state).kinetic;
    for (size_t c = 0; c < sim->contact_count; c++) {
        // Friction transmits no impulse.
        if (is_of_kind(sim, c, YK_LOAD_COULOMB)) sim->contacts[c].low = sim->contacts[c].high = 0;
        sim->bias[c] = yk_simulation_contact_rate(sim, c) - sim->wanted[c];
        sim->lambda[c] = 0;
    }
    if (!yk_simulation_solve_contacts(sim)) return false;
    for (size_t k = 0; k < sim->free_count; k++) {
        size_t i = (size_t)sim->free_input[k];
        for (size_t c = 0; c < sim->contact_count; c++)
            sim->y[sim->free_count + k] += sim->lambda[c] * sim->response[c * n + i];
        sim->state->input[3 * i + 1] = sim->y[sim->free_count + k];
    }
    yk_state_solve(sim->state);
    sim->y[2 * sim->free_count + sim->work_count - 1] += yk_dynamics_energy_at(d, sim->state).kinetic - before;
    for (size_t c = 0; c < sim->contact_count; c++) sim->lambda[c] = 0;
    return true;
}

// Factors the equations at the pose, for responses.
static bool factor_here(YkSimulation *sim)
{
    for (size_t c = 0; c < sim->contact_count; c++)
        if (sim->contacts[c].cam == YK_NONE) yk_simulation_item(sim, c)->dry = 0;
    YkStatus status = yk_dynamics_reduce(sim->dynamics, sim->state);
    if (status < 0 || status == YK_SINGULAR) return false;
    yk_simulation_find_responses(sim);
    return true;
}

static double rate_of(const YkSimulation *sim, const YkLoadItem *item)
{
    return yk_joint_rate(sim->mech, &sim->state->space, item->joint, item->is_distance);
}

static double slowest(const YkSimulation *sim, const YkLoadItem *item)
{
    return yk_simulation_rate_floor(sim) * yk_simulation_scale(sim, item);
}

// Returns whether the coordinate reaches this stop here, to rounding.
static bool comes_to(const YkSimulation *sim, const YkLoadItem *item)
{
    double value = yk_loads_coordinate(sim->state, &sim->state->space, item->coordinate).position;
    double low = value - item->stop->low, high = item->stop->high - value, rate = rate_of(sim, item);
    double near = 1e-9 * yk_simulation_scale(sim, item);
    return (low <= near && rate < -slowest(sim, item)) || (high <= near && rate > slowest(sim, item));
}

// Adds a stop to the contacts, with its rebound rate as the wanted one: 0 if it stays.
static void meet(YkSimulation *sim, size_t index)
{
    const YkLoadItem *item = &sim->dynamics->loads->items[index];
    double rate = rate_of(sim, item), rebound = -item->stop->restitution * rate;
    bool rests = fabs(rebound) <= 1e-6 * fabs(sim->fastest) || fabs(rebound) <= slowest(sim, item);
    yk_simulation_note(sim, YK_HAPPENING_STOP, sim->time, item->name, rate);
    yk_simulation_rest_on_stop(sim, index);
    for (size_t c = 0; c < sim->contact_count; c++)
        if (sim->contacts[c].cam == YK_NONE && sim->contacts[c].item == index) sim->wanted[c] = rests ? 0 : rebound;
}

// Adds the stop that ended the step, and all others that are reached at the same time.
static void meet_stops(YkSimulation *sim, size_t first)
{
    const YkLoads *loads = sim->dynamics->loads;
    double fastest = sim->fastest;
    for (size_t k = 0; k < loads->item_count; k++) {
        const YkLoadItem *item = &loads->items[k];
        bool is_met = k == first || (item->kind == YK_LOAD_STOP && comes_to(sim, item));
        if (!is_met) continue;
        double rate = rate_of(sim, item);
        if (fabs(rate) > fabs(fastest)) fastest = rate;
        meet(sim, k);
    }
    sim->fastest = fastest;
}

// Returns a stop that is passed although it pushes as hard as it can: no free coordinate could prevent it. NULL if none
// is passed.
static const YkLoadItem *passed(const YkSimulation *sim)
{
    for (size_t c = 0; c < sim->contact_count; c++) {
        if (!is_of_kind(sim, c, YK_LOAD_STOP)) continue;
        const YkLoadItem *item = yk_simulation_item(sim, c);
        double after = rate_of(sim, item);
        bool is_low = sim->contacts[c].low == 0;
        if ((is_low ? -after : after) > fmax(slowest(sim, item), 1e-6 * fabs(sim->fastest))) return item;
    }
    return NULL;
}

// Releases contacts after an impact: what rebounds or was struck away from its stop is free, and dry joints slide.
static void part_contacts(YkSimulation *sim)
{
    for (size_t c = sim->contact_count; c-- > 0;) {
        const YkLoadItem *item = yk_simulation_item(sim, c);
        double after = rate_of(sim, item);
        if (item->kind == YK_LOAD_COULOMB) {
            yk_simulation_let_go(sim, c, after > 0 ? 1 : after < 0 ? -1 : 0); // it sticks again if it does not move
        } else if (fabs(after) > slowest(sim, item)) {
            if (sim->wanted[c] == 0) yk_simulation_note(sim, YK_HAPPENING_RELEASE, sim->time, item->name, after);
            yk_simulation_let_go(sim, c, 0);
        }
    }
}

// Solves the impact of the contacts, with the cams that touch their followers, and frees what parts.
static bool collide(YkSimulation *sim)
{
    for (size_t k = 0; k < sim->model->cam_count; k++)
        if (sim->flights[k].is_about) yk_simulation_touch_cam(sim, k);
    if (!factor_here(sim) || !strike(sim)) {
        sim->report = sim->dynamics->report;
        sim->status = sim->report.status < 0 ? sim->report.status : YK_NOT_CONVERGED;
        return false;
    }
    yk_simulation_leave_cams(sim);
    const YkLoadItem *beyond = passed(sim);
    if (beyond) {
        yk_dynamics_fail(sim->dynamics, YK_LIMIT, "a drive moves `", beyond->name, "` past its stop");
        sim->report = sim->dynamics->report;
        sim->status = YK_LIMIT;
        return false;
    }
    part_contacts(sim);
    return yk_simulation_close_touching(sim) && yk_simulation_contacts_start(sim);
}

static void want_rest(YkSimulation *sim)
{
    for (size_t c = 0; c < sim->contact_count; c++) sim->wanted[c] = 0;
}

bool yk_simulation_hit(YkSimulation *sim, size_t index)
{
    if (sim->dynamics->loads->items[index].kind != YK_LOAD_STOP) {
        double rate = rate_of(sim, &sim->dynamics->loads->items[index]);
        yk_simulation_stick(sim, index, rate);
        if (fabs(rate) > fabs(sim->fastest)) sim->fastest = rate;
        return yk_simulation_contacts_start(sim);
    }
    if (!yk_simulation_open_touching(sim)) return false;
    want_rest(sim);
    meet_stops(sim, index);
    return collide(sim);
}

bool yk_simulation_land(YkSimulation *sim, size_t cam)
{
    double rate = yk_simulation_gap(sim, cam).velocity;
    yk_simulation_note(sim, YK_HAPPENING_LANDING, sim->time, sim->model->cams[cam].name, rate);
    if (fabs(rate) > fabs(sim->fastest)) sim->fastest = rate;
    if (!yk_simulation_open_touching(sim)) return false;
    sim->flights[cam].is_about = true;
    want_rest(sim);
    return collide(sim);
}
