// Contacts: stops that a coordinate rests against, and joints that dry friction makes stick.
//
// Each exerts an effort along its coordinate within bounds (a stop pushes only; friction holds up to its limit), just
// enough that the coordinate does not accelerate: a quadratic problem with bounds in as many unknowns as there are
// contacts (its matrix: the accelerations that unit efforts cause), solved by projected Gauss-Seidel (Moreau; Jourdan,
// Alart & Jean 1998). Sliding friction and limits depend on the joint reactions, which depend on them: repeated until
// they stand.
#include <stdlib.h>
#include <string.h>
#include "dynamics/simulation.h"

static YkLoadItem *item_of(const YkSimulation *sim, size_t contact)
{
    return &sim->dynamics->loads->items[sim->contacts[contact].item];
}

static void unknowns_of(const YkSimulation *sim, const YkLoadItem *item, int32_t *b, int32_t *a)
{
    if (item->is_distance) {
        *b = yk_unknown_of_distance(sim->mech, sim->mech->joint_distance[item->joint]);
        *a = 0;
        return;
    }
    YkJointAngle angle = yk_joint_angle(sim->mech, item->joint);
    *b = angle.b;
    *a = angle.a;
}

static double along(const YkSimulation *sim, const YkLoadItem *item)
{
    const double *xi = sim->dynamics->reduced->xi;
    int32_t a, b;
    unknowns_of(sim, item, &b, &a);
    return (b > 0 ? xi[b] : 0) - (a > 0 ? xi[a] : 0);
}

static double response_of_input(const YkSimulation *sim, size_t input)
{
    const YkReduced *r = sim->dynamics->reduced;
    const YkElimination *e = r->e;
    int32_t at = e->operation_of_input[input], parent = e->parent_of_input[input];
    if (at == YK_NONE || e->operations[at].kind != YK_OP_FREE) return 0;
    int32_t own = e->index[e->operations[at].first_index];
    return e->sign_of_input[input] * (r->xi[own] - (parent > 0 ? r->xi[parent] : 0));
}

// Accelerations of the contacts' coordinates without them (bias); what a unit effort at each does (response, matrix).
static void find_responses(YkSimulation *sim)
{
    YkDynamics *d = sim->dynamics;
    size_t m = sim->contact_count, n = sim->mech->input_count;
    yk_reduced_solve(d->reduced, d->acceleration, true);
    for (size_t c = 0; c < m; c++) {
        const YkLoadItem *item = item_of(sim, c);
        YkMotion pose = yk_joint_motion(sim->mech, &sim->state->space, item->joint, item->is_distance);
        sim->bias[c] = pose.acceleration + along(sim, item);
    }
    for (size_t c = 0; c < m; c++) {
        int32_t a, b;
        unknowns_of(sim, item_of(sim, c), &b, &a);
        yk_reduced_respond(d->reduced, b, a);
        for (size_t i = 0; i < n; i++) sim->response[c * n + i] = response_of_input(sim, i);
        for (size_t k = 0; k < m; k++) sim->matrix[c * m + k] = along(sim, item_of(sim, k));
    }
}

// matrix lambda + bias = 0 within bounds, as far as they let it.
static void solve_bounded(YkSimulation *sim, const double *bias)
{
    enum { SWEEPS_MAX = 5000 };
    size_t m = sim->contact_count;
    for (int sweep = 0; sweep < SWEEPS_MAX; sweep++) {
        double moved = 0, size = 0;
        for (size_t c = 0; c < m; c++) {
            const double *row = sim->matrix + c * m;
            if (!(row[c] > 0)) continue;
            double rest = bias[c];
            for (size_t k = 0; k < m; k++) rest += row[k] * sim->lambda[k];
            double next = fmin(sim->contacts[c].high, fmax(sim->contacts[c].low, sim->lambda[c] - rest / row[c]));
            moved = fmax(moved, fabs(next - sim->lambda[c]));
            size = fmax(size, fabs(next));
            sim->lambda[c] = next;
        }
        if (moved <= 1e-15 * size) return;
    }
}

static void add_contacts(YkSimulation *sim)
{
    YkDynamics *d = sim->dynamics;
    size_t n = sim->mech->input_count;
    find_responses(sim);
    solve_bounded(sim, sim->bias);
    for (size_t c = 0; c < sim->contact_count; c++) {
        item_of(sim, c)->dry = sim->lambda[c];
        for (size_t i = 0; i < n; i++)
            if (d->is_free[i]) d->acceleration[i] += sim->lambda[c] * sim->response[c * n + i];
    }
}

// The bounds of what sticks, from the last reactions; do they stand?
static bool find_limits(YkSimulation *sim, int round)
{
    double tolerance = yk_dynamics_dry_tolerance(round);
    bool stands = true;
    for (size_t c = 0; c < sim->contact_count; c++) {
        if (item_of(sim, c)->kind != YK_LOAD_COULOMB) continue;
        double limit = yk_dynamics_dry_limit(sim->dynamics, item_of(sim, c)), old = sim->contacts[c].high;
        bool saturated = fabs(sim->lambda[c]) >= fmin(limit, old) * (1 - 1e-12);
        stands = stands && (!saturated || fabs(limit - old) <= tolerance * limit);
        sim->contacts[c].high = limit;
        sim->contacts[c].low = -limit;
    }
    return stands;
}

YkStatus yk_simulation_accelerate(YkSimulation *sim)
{
    YkDynamics *d = sim->dynamics;
    if (sim->contact_count == 0 && !d->loads->has_dry)
        return sim->has_drives ? yk_dynamics_reduce(d, sim->state) // whose efforts are asked too
                               : yk_dynamics_find_accelerations(d, sim->state);
    for (int round = 0; round < YK_DRY_ROUNDS; round++) {
        for (size_t c = 0; c < sim->contact_count; c++) item_of(sim, c)->dry = 0;
        YkStatus status = yk_dynamics_reduce(d, sim->state);
        if (status < 0 || status == YK_SINGULAR) return round > 0 ? yk_dynamics_fail_at_dry(d) : status;
        if (sim->contact_count > 0) add_contacts(sim);
        if (!d->loads->has_dry) return status;
        status = yk_dynamics_apply(d, sim->state);
        if (status < 0 || status == YK_SINGULAR) return round > 0 ? yk_dynamics_fail_at_dry(d) : status;
        bool slides = yk_dynamics_find_dry(d, sim->state, round), holds = find_limits(sim, round);
        if (slides && holds) return status;
    }
    return yk_dynamics_fail_at_dry(d);
}

// --- beginning and ending
// -------------------------------------------------------------------------------------------------

static double value_of(const YkSimulation *sim, const YkLoadItem *item)
{
    return yk_loads_coordinate(sim->state, &sim->state->space, item->coordinate).position;
}

static bool is_contact(const YkSimulation *sim, size_t item)
{
    for (size_t c = 0; c < sim->contact_count; c++)
        if (sim->contacts[c].item == item) return true;
    return false;
}

static void add_contact(YkSimulation *sim, size_t item, double low, double high)
{
    if (is_contact(sim, item)) return;
    sim->lambda[sim->contact_count] = 0;
    sim->contacts[sim->contact_count++] = (YkContact){item, low, high};
}

static void rest_on_stop(YkSimulation *sim, size_t index)
{
    const YkLoadItem *item = &sim->dynamics->loads->items[index];
    bool is_low = value_of(sim, item) - item->stop->low < item->stop->high - value_of(sim, item);
    add_contact(sim, index, is_low ? 0 : -HUGE_VAL, is_low ? HUGE_VAL : 0);
}

static void stick(YkSimulation *sim, size_t index, double rate)
{
    YkLoadItem *item = &sim->dynamics->loads->items[index];
    if (!is_contact(sim, index) && sim->time > sim->options.start)
        yk_simulation_note(sim, YK_HAPPENING_STICK, sim->time, item->name, rate);
    item->is_held = true;
    item->direction = 0;
    add_contact(sim, index, -HUGE_VAL, HUGE_VAL); // bounds follow from the reactions
}

static void let_go(YkSimulation *sim, size_t contact, double direction)
{
    YkLoadItem *item = item_of(sim, contact);
    item->is_held = false;
    item->direction = direction;
    item->dry = 0;
    sim->contact_count--;
    memmove(sim->contacts + contact, sim->contacts + contact + 1,
            (sim->contact_count - contact) * sizeof *sim->contacts);
    memmove(sim->lambda + contact, sim->lambda + contact + 1, (sim->contact_count - contact) * sizeof *sim->lambda);
}

static double rate_floor(const YkSimulation *sim)
{
    double fastest = 0;
    for (size_t k = 0; k < sim->free_count; k++) {
        bool is_distance = sim->mech->coordinates[sim->mech->inputs[sim->free_input[k]]].is_distance;
        fastest =
            fmax(fastest, fabs(sim->state->input[3 * sim->free_input[k] + 1]) / (is_distance ? sim->mech->size : 1));
    }
    return 1e-8 * fmax(1e-3, fastest);
}

static double item_scale(const YkSimulation *sim, const YkLoadItem *item)
{
    return item->is_distance ? sim->mech->size : 1;
}

bool yk_simulation_contacts_start(YkSimulation *sim)
{
    YkLoads *loads = sim->dynamics->loads;
    double least = rate_floor(sim);
    for (size_t k = 0; k < loads->item_count; k++) {
        YkLoadItem *item = &loads->items[k];
        if (item->kind != YK_LOAD_COULOMB && item->kind != YK_LOAD_STOP) continue;
        double rate = yk_joint_rate(sim->mech, &sim->state->space, item->joint, item->is_distance);
        bool is_slow = fabs(rate) <= least * item_scale(sim, item);
        if (item->kind == YK_LOAD_COULOMB) {
            if (is_slow)
                stick(sim, k, rate);
            else if (!item->is_held)
                item->direction = rate > 0 ? 1 : -1;
        } else {
            double value = value_of(sim, item), scale = 1e-9 * item_scale(sim, item);
            bool low = value - item->stop->low <= scale, high = item->stop->high - value <= scale;
            if ((low || high) && is_slow) rest_on_stop(sim, k);
        }
    }
    return true;
}

// A joint that sticks for no time at all has only turned round, or was never at rest.
static void note_slip(YkSimulation *sim, const YkLoadItem *item)
{
    size_t n = sim->happening_count;
    if (sim->time == sim->options.start) return;
    for (size_t k = n; k-- > 0 && sim->happenings[k].time == sim->time;) {
        const YkHappening *h = &sim->happenings[k];
        if (h->kind != YK_HAPPENING_STICK || strcmp(h->name, item->name) != 0) continue;
        memmove(sim->happenings + k, sim->happenings + k + 1, (n - k - 1) * sizeof *sim->happenings);
        sim->happening_count--;
        return;
    }
    yk_simulation_note(sim, YK_HAPPENING_SLIP, sim->time, item->name, 0);
}

bool yk_simulation_contacts_check(YkSimulation *sim)
{
    bool changed = false;
    for (size_t c = sim->contact_count; c-- > 0;) {
        YkLoadItem *item = item_of(sim, c);
        double force = sim->lambda[c], acceleration = sim->bias[c];
        for (size_t k = 0; k < sim->contact_count; k++)
            acceleration += sim->matrix[c * sim->contact_count + k] * sim->lambda[k];
        bool moves = fabs(acceleration) > 1e-9 * (fabs(sim->bias[c]) + fabs(acceleration));
        if (item->kind == YK_LOAD_STOP) {
            if (force != 0 || !moves) continue;
            yk_simulation_note(sim, YK_HAPPENING_RELEASE, sim->time, item->name, 0);
            let_go(sim, c, 0);
        } else {
            bool is_driven = !(sim->matrix[c * sim->contact_count + c] > 0); // no force at this joint could hold it
            bool holds = is_driven ? fabs(acceleration) <= 1e-9 * item_scale(sim, item)
                                   : fabs(force) < sim->contacts[c].high * (1 - 1e-9);
            if (!moves || holds) continue;
            note_slip(sim, item);
            let_go(sim, c, acceleration > 0 ? 1 : -1);
        }
        changed = true;
        break; // the matrix is of the contacts as they were: look again after the next evaluation
    }
    return changed;
}

// --- impacts
// ------------------------------------------------------------------------------------------------------------

// Impulses that bring the contacts' rates to `wanted`, within the contacts' bounds.
static void strike(YkSimulation *sim, const double *wanted)
{
    YkDynamics *d = sim->dynamics;
    size_t n = sim->mech->input_count;
    double before = yk_dynamics_energy_at(d, sim->state).kinetic;
    for (size_t c = 0; c < sim->contact_count; c++) {
        const YkLoadItem *item = item_of(sim, c);
        if (item->kind == YK_LOAD_COULOMB) sim->contacts[c].low = sim->contacts[c].high = 0; // friction gives no blow
        sim->bias[c] = yk_joint_rate(sim->mech, &sim->state->space, item->joint, item->is_distance) - wanted[c];
        sim->lambda[c] = 0;
    }
    solve_bounded(sim, sim->bias);
    for (size_t k = 0; k < sim->free_count; k++) {
        size_t i = (size_t)sim->free_input[k];
        for (size_t c = 0; c < sim->contact_count; c++)
            sim->y[sim->free_count + k] += sim->lambda[c] * sim->response[c * n + i];
        sim->state->input[3 * i + 1] = sim->y[sim->free_count + k];
    }
    yk_state_solve(sim->state);
    sim->y[2 * sim->free_count + sim->work_count - 1] += yk_dynamics_energy_at(d, sim->state).kinetic - before;
    for (size_t c = 0; c < sim->contact_count; c++) sim->lambda[c] = 0;
}

// The factors of the pose, for responses.
static bool factor_here(YkSimulation *sim)
{
    for (size_t c = 0; c < sim->contact_count; c++) item_of(sim, c)->dry = 0;
    YkStatus status = yk_dynamics_reduce(sim->dynamics, sim->state);
    if (status < 0 || status == YK_SINGULAR) return false;
    find_responses(sim);
    return true;
}

// Nothing that is free could stop it.
static bool goes_on_past(const YkSimulation *sim, const YkLoadItem *item, double before)
{
    double after = yk_joint_rate(sim->mech, &sim->state->space, item->joint, item->is_distance);
    return before * after > 0 && fabs(after) > 1e-6 * fabs(before) &&
           fabs(after) > rate_floor(sim) * item_scale(sim, item);
}

// After a blow: what rebounds or was struck away from its stop is free, and dry joints slide.
static void part_contacts(YkSimulation *sim, size_t hit, bool rests)
{
    for (size_t c = sim->contact_count; c-- > 0;) {
        const YkLoadItem *item = item_of(sim, c);
        double after = yk_joint_rate(sim->mech, &sim->state->space, item->joint, item->is_distance);
        bool is_slow = fabs(after) <= rate_floor(sim) * item_scale(sim, item);
        if (item->kind == YK_LOAD_COULOMB) {
            let_go(sim, c, after > 0 ? 1 : after < 0 ? -1 : 0); // it sticks again where it does not move
        } else if (sim->contacts[c].item == hit) {
            if (!rests) let_go(sim, c, 0);
        } else if (!is_slow) {
            yk_simulation_note(sim, YK_HAPPENING_RELEASE, sim->time, item->name, after);
            let_go(sim, c, 0);
        }
    }
}

bool yk_simulation_hit(YkSimulation *sim, size_t index)
{
    YkLoadItem *item = &sim->dynamics->loads->items[index];
    double rate = yk_joint_rate(sim->mech, &sim->state->space, item->joint, item->is_distance);
    bool is_stop = item->kind == YK_LOAD_STOP;
    if (is_stop) {
        yk_simulation_note(sim, YK_HAPPENING_STOP, sim->time, item->name, rate);
        rest_on_stop(sim, index);
    } else {
        stick(sim, index, rate);
    }
    double *wanted = sim->wanted, rebound = is_stop ? -item->stop->restitution * rate : 0;
    bool rests = fabs(rebound) <= 1e-6 * fabs(sim->fastest) || fabs(rebound) <= rate_floor(sim) * item_scale(sim, item);
    if (fabs(rate) > fabs(sim->fastest)) sim->fastest = rate;
    for (size_t c = 0; c < sim->contact_count; c++) wanted[c] = sim->contacts[c].item == index && !rests ? rebound : 0;
    if (!is_stop) return yk_simulation_contacts_start(sim);
    if (!factor_here(sim)) return false;
    strike(sim, wanted);
    if (goes_on_past(sim, item, rate)) {
        yk_dynamics_fail(sim->dynamics, YK_LIMIT, "a drive moves `", item->name, "` past its stop");
        sim->report = sim->dynamics->report;
        sim->status = YK_LIMIT;
        return false;
    }
    part_contacts(sim, index, rests);
    return yk_simulation_contacts_start(sim);
}
