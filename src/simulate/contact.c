// Contacts: stops against which a coordinate rests, and joints that stick under dry friction.
//
// Each exerts an effort along its coordinate within bounds (a stop only pushes; friction holds up to its limit), just
// enough that the coordinate does not accelerate. This is a quadratic problem with bounds in as many unknowns as there
// are contacts (its matrix: the accelerations caused by unit efforts; num/bounded). Sliding friction and limits depend
// on the joint reactions, which depend on them: the solution is repeated until they settle.
//
// Within a step contacts hold without bounds, so that the motion is smooth there. Between steps it is checked whether
// they could hold, and the step is cut where they no longer can (events.c).
#include <string.h>
#include "simulate/contact.h"

YkLoadItem *yk_simulation_item(const YkSimulation *sim, size_t contact)
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

static size_t terms_of(const YkSimulation *sim, size_t contact, YkContactTerm term[2])
{
    if (sim->contacts[contact].cam != YK_NONE)
        return yk_simulation_cam_terms(sim, (size_t)sim->contacts[contact].cam, term);
    term[0].factor = 1;
    unknowns_of(sim, yk_simulation_item(sim, contact), &term[0].b, &term[0].a);
    return 1;
}

static double along(const YkSimulation *sim, size_t contact)
{
    const double *xi = sim->dynamics->reduced->xi;
    YkContactTerm term[2];
    double sum = 0;
    size_t count = terms_of(sim, contact, term);
    for (size_t k = 0; k < count; k++)
        sum += term[k].factor * ((term[k].b > 0 ? xi[term[k].b] : 0) - (term[k].a > 0 ? xi[term[k].a] : 0));
    return sum;
}

double yk_simulation_contact_rate(const YkSimulation *sim, size_t contact)
{
    if (sim->contacts[contact].cam != YK_NONE)
        return yk_simulation_gap(sim, (size_t)sim->contacts[contact].cam).velocity;
    const YkLoadItem *item = yk_simulation_item(sim, contact);
    return yk_joint_rate(sim->mech, &sim->state->space, item->joint, item->is_distance);
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

// Finds the accelerations of the contacts' coordinates without contacts (bias), and those caused by unit efforts
// (response, matrix).
void yk_simulation_find_responses(YkSimulation *sim)
{
    YkDynamics *d = sim->dynamics;
    size_t m = sim->contact_count, n = sim->mech->input_count;
    yk_reduced_solve(d->reduced, d->acceleration, true);
    for (size_t c = 0; c < m; c++) {
        if (sim->contacts[c].cam != YK_NONE) continue; // only in impacts, which have a bias of their own
        const YkLoadItem *item = yk_simulation_item(sim, c);
        YkMotion pose = yk_joint_motion(sim->mech, &sim->state->space, item->joint, item->is_distance);
        sim->bias[c] = pose.acceleration + along(sim, c);
    }
    for (size_t c = 0; c < m; c++) {
        YkContactTerm term[2];
        size_t terms = terms_of(sim, c, term);
        for (size_t i = 0; i < n; i++) sim->response[c * n + i] = 0;
        for (size_t k = 0; k < m; k++) sim->matrix[c * m + k] = 0;
        for (size_t t = 0; t < terms; t++) {
            yk_reduced_respond(d->reduced, term[t].b, term[t].a);
            for (size_t i = 0; i < n; i++) sim->response[c * n + i] += term[t].factor * response_of_input(sim, i);
            for (size_t k = 0; k < m; k++) sim->matrix[c * m + k] += term[t].factor * along(sim, k);
        }
    }
}

// Solves matrix lambda + bias = 0 within bounds, as far as they allow. Returns false if no answer was found.
static bool solve_within(YkSimulation *sim, bool has_bounds)
{
    size_t m = sim->contact_count;
    for (size_t c = 0; c < m; c++) {
        const YkContact *contact = &sim->contacts[c];
        sim->bounds[c] =
            has_bounds ? (YkBounds){contact->low, contact->high} : (YkBounds){-(double)INFINITY, (double)INFINITY};
    }
    return yk_bounded_solve(m, sim->matrix, sim->bias, sim->bounds, sim->sweeps_max, sim->lambda, sim->contact_work,
                            sim->contact_order);
}

bool yk_simulation_solve_contacts(YkSimulation *sim)
{
    if (solve_within(sim, true)) return true;
    yk_dynamics_fail(sim->dynamics, YK_NOT_CONVERGED,
                     "the efforts of stops and dry friction were not found at this pose: ",
                     "the iteration over the contacts did not settle", "");
    return false;
}

double yk_simulation_contact_acceleration(const YkSimulation *sim, size_t contact)
{
    size_t m = sim->contact_count;
    const double *row = sim->matrix + contact * m;
    double sum = sim->bias[contact], size = fabs(sum), most = 0;
    for (size_t k = 0; k < m; k++) {
        sum += row[k] * sim->lambda[k];
        size += fabs(row[k] * sim->lambda[k]);
        most = fmax(most, fabs(sim->lambda[k]));
    }
    bool is_driven = !(row[contact] > 0); // nothing at this joint could hold it
    double none = is_driven ? 1e-9 * yk_simulation_scale(sim, yk_simulation_item(sim, contact))
                            : 1e-12 * (size + 1e-3 * row[contact] * most);
    return fabs(sum) > none ? sum : 0;
}

// Finds what the contacts would have to exert to hold, also beyond their bounds. If there is no such answer, the one
// within bounds stays.
static void hold_without_bounds(YkSimulation *sim)
{
    size_t m = sim->contact_count;
    bool moves = false;
    for (size_t c = 0; c < m; c++)
        moves = moves || (sim->matrix[c * m + c] > 0 && yk_simulation_contact_acceleration(sim, c) != 0);
    if (!moves) return;
    memcpy(sim->kept, sim->lambda, m * sizeof *sim->lambda);
    if (!solve_within(sim, false)) memcpy(sim->lambda, sim->kept, m * sizeof *sim->lambda);
}

static bool add_contacts(YkSimulation *sim)
{
    YkDynamics *d = sim->dynamics;
    size_t n = sim->mech->input_count;
    yk_simulation_find_responses(sim);
    if (!yk_simulation_solve_contacts(sim)) return false;
    if (!sim->is_testing) hold_without_bounds(sim);
    for (size_t c = 0; c < sim->contact_count; c++) {
        yk_simulation_item(sim, c)->dry = sim->lambda[c];
        for (size_t i = 0; i < n; i++)
            if (d->is_free[i]) d->acceleration[i] += sim->lambda[c] * sim->response[c * n + i];
    }
    return true;
}

// Finds the bounds of sticking joints from the last reactions; returns whether they have settled.
static bool find_limits(YkSimulation *sim, int round)
{
    double tolerance = yk_dynamics_dry_tolerance(round);
    bool stands = true;
    for (size_t c = 0; c < sim->contact_count; c++) {
        if (yk_simulation_item(sim, c)->kind != YK_LOAD_COULOMB) continue;
        double limit = yk_dynamics_dry_limit(sim->dynamics, yk_simulation_item(sim, c)), old = sim->contacts[c].high;
        bool saturated = fabs(sim->lambda[c]) >= fmin(limit, old) * (1 - 1e-12);
        stands = stands && limit < (double)INFINITY && (!saturated || fabs(limit - old) <= tolerance * limit);
        sim->contacts[c].high = limit;
        sim->contacts[c].low = -limit;
    }
    return stands;
}

YkStatus yk_simulation_accelerate(YkSimulation *sim)
{
    YkDynamics *d = sim->dynamics;
    if (sim->contact_count == 0 && !d->loads->has_dry)
        return sim->has_drives ? yk_dynamics_reduce(d, sim->state) // whose efforts are needed too
                               : yk_dynamics_find_accelerations(d, sim->state);
    for (int round = 0; round < YK_DRY_ROUNDS; round++) {
        for (size_t c = 0; c < sim->contact_count; c++) yk_simulation_item(sim, c)->dry = 0;
        YkStatus status = yk_dynamics_reduce(d, sim->state);
        if (status < 0 || status == YK_SINGULAR) return round > 0 ? yk_dynamics_fail_at_dry(d) : status;
        if (sim->contact_count > 0 && !add_contacts(sim)) return YK_NOT_CONVERGED;
        if (!d->loads->has_dry) return status;
        status = yk_dynamics_apply(d, sim->state);
        if (status < 0 || status == YK_SINGULAR) return round > 0 ? yk_dynamics_fail_at_dry(d) : status;
        bool slides = yk_dynamics_find_dry(d, sim->state, round), holds = find_limits(sim, round);
        if (slides && holds) return status;
    }
    return yk_dynamics_fail_at_dry(d);
}

// --- beginning and ending

static double value_of(const YkSimulation *sim, const YkLoadItem *item)
{
    return yk_loads_coordinate(sim->state, &sim->state->space, item->coordinate).position;
}

static bool is_contact(const YkSimulation *sim, size_t item)
{
    for (size_t c = 0; c < sim->contact_count; c++)
        if (sim->contacts[c].cam == YK_NONE && sim->contacts[c].item == item) return true;
    return false;
}

static void add_contact(YkSimulation *sim, size_t item, double low, double high)
{
    if (is_contact(sim, item)) return;
    sim->lambda[sim->contact_count] = 0;
    sim->contacts[sim->contact_count++] = (YkContact){item, YK_NONE, low, high};
}

void yk_simulation_touch_cam(YkSimulation *sim, size_t cam)
{
    sim->lambda[sim->contact_count] = sim->wanted[sim->contact_count] = 0;
    sim->contacts[sim->contact_count++] = (YkContact){0, (int32_t)cam, 0, HUGE_VAL};
}

void yk_simulation_leave_cams(YkSimulation *sim)
{
    size_t kept = 0;
    for (size_t c = 0; c < sim->contact_count; c++) {
        if (sim->contacts[c].cam != YK_NONE) continue;
        sim->lambda[kept] = sim->lambda[c];
        sim->contacts[kept++] = sim->contacts[c];
    }
    sim->contact_count = kept;
}

void yk_simulation_rest_on_stop(YkSimulation *sim, size_t index)
{
    const YkLoadItem *item = &sim->dynamics->loads->items[index];
    bool is_low = value_of(sim, item) - item->stop->low < item->stop->high - value_of(sim, item);
    add_contact(sim, index, is_low ? 0 : -HUGE_VAL, is_low ? HUGE_VAL : 0);
}

void yk_simulation_stick(YkSimulation *sim, size_t index, double rate)
{
    YkLoadItem *item = &sim->dynamics->loads->items[index];
    if (!is_contact(sim, index) && sim->time > sim->options.start)
        yk_simulation_note(sim, YK_HAPPENING_STICK, sim->time, item->name, rate);
    item->is_held = true;
    item->direction = 0;
    add_contact(sim, index, -HUGE_VAL, HUGE_VAL); // its bounds follow from the reactions
}

void yk_simulation_let_go(YkSimulation *sim, size_t contact, double direction)
{
    YkLoadItem *item = yk_simulation_item(sim, contact);
    item->is_held = false;
    item->direction = direction;
    item->dry = 0;
    sim->contact_count--;
    memmove(sim->contacts + contact, sim->contacts + contact + 1,
            (sim->contact_count - contact) * sizeof *sim->contacts);
    memmove(sim->lambda + contact, sim->lambda + contact + 1, (sim->contact_count - contact) * sizeof *sim->lambda);
}

double yk_simulation_scale(const YkSimulation *sim, const YkLoadItem *item)
{
    return item->is_distance ? sim->mech->size : 1;
}

bool yk_simulation_contacts_start(YkSimulation *sim)
{
    YkLoads *loads = sim->dynamics->loads;
    double least = yk_simulation_rate_floor(sim);
    for (size_t k = 0; k < loads->item_count; k++) {
        YkLoadItem *item = &loads->items[k];
        if (item->kind != YK_LOAD_COULOMB && item->kind != YK_LOAD_STOP) continue;
        double rate = yk_joint_rate(sim->mech, &sim->state->space, item->joint, item->is_distance);
        bool is_slow = fabs(rate) <= least * yk_simulation_scale(sim, item);
        if (item->kind == YK_LOAD_COULOMB) {
            if (is_slow)
                yk_simulation_stick(sim, k, rate);
            else if (!item->is_held)
                item->direction = rate > 0 ? 1 : -1;
        } else {
            double value = value_of(sim, item), scale = 1e-9 * yk_simulation_scale(sim, item);
            bool low = value - item->stop->low <= scale, high = item->stop->high - value <= scale;
            if ((low || high) && is_slow) yk_simulation_rest_on_stop(sim, k);
        }
    }
    return true;
}

// Notes a slip, unless a joint stuck for no time at all: it has only turned round, or was never at rest.
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
        YkLoadItem *item = yk_simulation_item(sim, c);
        double acceleration = yk_simulation_contact_acceleration(sim, c);
        if (acceleration == 0) continue;
        if (item->kind == YK_LOAD_STOP) {
            yk_simulation_note(sim, YK_HAPPENING_RELEASE, sim->time, item->name, 0);
            yk_simulation_let_go(sim, c, 0);
        } else {
            note_slip(sim, item);
            yk_simulation_let_go(sim, c, acceleration > 0 ? 1 : -1);
        }
        changed = true;
        break; // the matrix is that of the earlier contacts: check again after the next evaluation
    }
    return changed;
}
