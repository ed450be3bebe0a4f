// Machines that drives alone move. A second state, the guide, follows the drives as sweeps do. Near a singular position
// it says where the machine is, at which rates, and so what power the drive brings: no equation of forces has to be
// solved there.
#include "simulate/crossing.h"

// Tolerance of directions: near a singular position poses are known to the square root of rounding.
static const double SAME = 1e-5;
static const double SAME_PLACE = 2e-7; // where the pose of the simulation stays
static const double CLOSE = 0.24;      // sin^2 below which a pose is the guide's

bool yk_simulation_start_guide(YkSimulation *sim)
{
    if (sim->free_count > 0 || sim->mech->block_count == 0 || sim->is_flat || sim->guide) return true;
    sim->guide = yk_state_new(sim->mech);
    if (sim->guide) yk_state_take(sim->guide, sim->state);
    return sim->guide != NULL;
}

static bool goes_to(YkSimulation *sim, double t)
{
    return yk_state_move_time(sim->guide, t, NULL, NULL, NULL) >= 0;
}

// Returns whether the guide's rates are those of the motion. Near a limit, and where nothing is smooth, they are not.
static bool has_sure_rates(const YkState *s)
{
    return s->has_rates && (s->is_clear || yk_state_has_limits(s) || s->space.margin[0] > YK_NEAR_MARGIN);
}

// Returns the only input that moves; YK_NONE if none does, or several.
static int32_t moving_input(const YkState *s)
{
    int32_t moving = YK_NONE;
    for (size_t i = 0; i < s->mech->input_count; i++) {
        if (s->input[3 * i + 1] == 0) continue;
        if (moving != YK_NONE) return YK_NONE;
        moving = (int32_t)i;
    }
    return moving;
}

static bool rests(const YkState *s)
{
    for (size_t i = 0; i < s->mech->input_count; i++)
        if (s->input[3 * i + 1] != 0) return false;
    return true;
}

// Returns whether the only input that moves turns back within a short way, as it does just before a limit.
static bool turns_soon(const YkState *s)
{
    const double SHORT = 2e-3; // rad, or lengths over the machine's size
    int32_t i = moving_input(s);
    if (i == YK_NONE) return false;
    double rate = s->input[3 * i + 1], way = SHORT * yk_input_unit(s->mech, (size_t)i);
    return rate * rate < 2 * way * fabs(s->input[3 * i + 2]);
}

bool yk_simulation_stands_with_guide(YkSimulation *sim, double t, bool must_be_sure)
{
    const YkState *guide = sim->guide;
    if (sim->commands || sim->near_count == 0 || sim->contact_count > 0 || sim->dynamics->loads->has_dry) return false;
    if (!goes_to(sim, t) || !guide->has_rates || (must_be_sure && !has_sure_rates(guide))) return false;
    if (must_be_sure ? moving_input(guide) == YK_NONE && !rests(guide) : !turns_soon(guide)) return false;
    yk_state_copy(sim->state, guide);
    return true;
}

void yk_simulation_end_at_limit(YkSimulation *sim)
{
    const double NEAR = 1e-3, // how far the inputs may be from there, rad or lengths over the machine's size,
        SOON = 1e-3;          // and the time, over what has passed: a drive may be coming to rest
    double rate = 0;
    if (!sim->guide || sim->commands || sim->contact_count > 0) return;
    goes_to(sim, sim->time);
    for (size_t i = 0; i < sim->mech->input_count; i++)
        rate = fmax(rate, fabs(sim->guide->input[3 * i + 1]) / yk_input_unit(sim->mech, i));
    double ahead = sim->time + fmin(NEAR / rate, SOON * (sim->time - sim->options.start));
    YkMove way;
    if (!(ahead > sim->time) || yk_state_move_time(sim->guide, ahead, NULL, &way, NULL) != YK_LIMIT || way.block < 0)
        return;
    yk_dynamics_fail(sim->dynamics, YK_LIMIT, "a limit position: beyond, joint `", sim->mech->blocks[way.block].label,
                     "` does not close");
    sim->report = sim->dynamics->report;
    sim->time = sim->guide->time;
    sim->status = YK_LIMIT;
}

// Returns what the drives bring: the power that the masses take up, less what all loads deliver. Returns false if a
// load has no value.
static bool find_power(YkSimulation *sim, double *power)
{
    YkDynamics *d = sim->dynamics;
    const YkModel *model = sim->mech->model;
    size_t culprit;
    memset(d->load, 0, model->body_count * sizeof *d->load);
    if (!yk_loads_add(d->loads, sim->state, &sim->state->space, d->load, d->power, &culprit)) {
        yk_dynamics_fail_at_load(d, culprit);
        sim->report = d->report;
        return false;
    }
    *power = 0;
    for (size_t b = 1; b < model->body_count; b++) {
        const YkBody *body = &model->bodies[b];
        YkBodyMotion m = yk_body_motion(sim->mech, &sim->state->space, b);
        YkVec pull = yk_sub(m.acceleration, model->gravity);
        *power += body->mass * yk_dot(m.velocity, pull) + body->inertia * m.w * m.a;
        *power -= yk_dot(d->load[b].force, m.velocity) + d->load[b].moment * m.w;
    }
    return true;
}

bool yk_simulation_moves_with_guide(YkSimulation *sim, double t, double *dydt, bool must_be_sure)
{
    double drive, *power = dydt + 2 * sim->free_count;
    if (!yk_simulation_stands_with_guide(sim, t, must_be_sure) || !yk_dynamics_prepare(sim->dynamics) ||
        !find_power(sim, &drive))
        return false;
    memset(power, 0, sim->work_count * sizeof *power);
    if (sim->options.pulls > 0) power[sim->work_count - 2] = sim->dynamics->loads->handle_power;
    if (sim->item_count > 0) memcpy(power, sim->dynamics->power, sim->item_count * sizeof *power);
    size_t at = sim->item_count;
    int32_t moving = moving_input(sim->state);
    for (size_t i = 0; i < sim->mech->input_count; i++)
        if (!sim->dynamics->is_free[i]) power[at++] = (int32_t)i == moving ? drive : 0;
    return true;
}

// Returns whether the simulation stands so close to where the guide is, both far from singular positions, that it is on
// the same branch: there, branches are further apart.
static bool is_beside_guide(const YkSimulation *sim)
{
    const double BESIDE =
        0.1; // of directions, and of distances over the machine's size; branches differ by sqrt(CLOSE)
    const YkSpace *s = &sim->state->space, *guide = &sim->guide->space;
    if (!(s->margin[0] >= CLOSE && guide->margin[0] >= CLOSE)) return false;
    for (size_t k = 1; k < s->slots; k++) {
        YkTurn one = yk_space_turn(s, (int32_t)k), other = yk_space_turn(guide, (int32_t)k);
        if (!(fabs(*one.c - *other.c) + fabs(*one.s - *other.s) < BESIDE)) return false;
    }
    for (size_t k = 0; k < s->distances; k++)
        if (!(fabs(*s->slide[k].d - *guide->slide[k].d) < BESIDE * sim->mech->size)) return false;
    return true;
}

bool yk_simulation_agrees_with_guide(YkSimulation *sim)
{
    YkState *s = sim->state, *guide = sim->guide;
    if (!guide || sim->commands) return true;
    bool is_near = sim->near_count > 0 || yk_simulation_margin(sim) < CLOSE;
    if (!is_near && is_beside_guide(sim)) return true; // it follows once it is left behind
    if (!goes_to(sim, sim->time)) return false;
    double most = guide->has_rates ? SAME : SAME_PLACE;
    for (size_t k = 1; k < s->space.slots; k++) {
        YkTurn one = yk_space_turn(&s->space, (int32_t)k), other = yk_space_turn(&guide->space, (int32_t)k);
        if (!(fabs(*one.c - *other.c) + fabs(*one.s - *other.s) < most)) return false;
    }
    if (is_near && guide->has_rates) yk_state_copy(s, guide); // so near, the branches are apart by less than this
    return true;
}
