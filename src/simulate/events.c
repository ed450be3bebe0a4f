// Events between two accepted steps: stops hit, joints that come to rest, watched values that cross their level.
#include <string.h>
#include "simulate/simulation.h"

enum { PROBES = 5 };

// A function of time within the last step: above 0 once the event has happened.
typedef struct Event {
    YkSimulation *sim;
    const YkLoadItem *item; // STOP or COULOMB
    const YkEventWatch *watch;
    double way; // watch: +1 rising, -1 falling
    size_t cam; // if there is neither: a cam that pushes and then would have to pull, or that is reached
    bool is_landing;
    const YkLawUse *use; // or, if given, a law whose range is left
} Event;

// Returns how deep a follower in flight is in its cam, less what is rounding.
static double depth_here(const YkSimulation *sim, size_t cam)
{
    double unit = sim->model->cams[cam].oscillates ? 1 : sim->mech->size;
    return -yk_simulation_gap(sim, cam).position - 1e-12 * unit;
}

static double argument_here(YkSimulation *sim, const YkLawUse *use)
{
    return yk_law_use_argument(use, sim->state, sim->dynamics->loads);
}

// Returns by how much the argument of a law is outside its range; below 0 if the law is not in use.
static double excess_here(YkSimulation *sim, const YkLawUse *use)
{
    double excess = yk_law_use_excess(use, argument_here(sim, use));
    return isnan(excess) ? -1 : excess;
}

static double event_here(const Event *e)
{
    YkSimulation *sim = e->sim;
    const YkLoadItem *item = e->item;
    if (e->use) return excess_here(sim, e->use);
    if (e->is_landing) return depth_here(sim, e->cam);
    if (!item && !e->watch) return yk_simulation_pull(sim, e->cam);
    if (!item) return e->way * (yk_simulation_channel(sim, e->watch->channel) - e->watch->level);
    if (item->kind == YK_LOAD_COULOMB)
        return -item->direction * yk_joint_rate(sim->mech, &sim->state->space, item->joint, item->is_distance);
    double value = yk_loads_coordinate(sim->state, &sim->state->space, item->coordinate).position;
    return fmax(item->stop->low - value, value - item->stop->high);
}

// Puts the state at a time within the last step.
static bool visit(YkSimulation *sim, double t, bool with_accelerations)
{
    if (yk_ode_dense(sim->ode, t, sim->dense) != YK_ODE_OK) return false;
    if (with_accelerations) return yk_simulation_pose(sim, t, sim->dense);
    if (!yk_simulation_set(sim, t, sim->dense) || yk_state_solve(sim->state) < 0) return false;
    sim->time = t;
    return true;
}

static double event_at(const Event *e, double t, bool *ok)
{
    *ok = *ok && visit(e->sim, t, !e->item && !e->use && !e->is_landing);
    return *ok ? event_here(e) : 0;
}

// Returns the time at which the event's function passes 0 between a (not above) and b (above): Illinois variant of the
// false position.
static double locate(const Event *e, double a, double fa, double b, double fb, bool *ok)
{
    int side = 0;
    for (int k = 0; k < 100 && *ok && fabs(b - a) > 4e-16 * fmax(fabs(a), fabs(b)); k++) {
        double t = fb != fa ? b - fb * (b - a) / (fb - fa) : 0.5 * (a + b);
        if (!(t > fmin(a, b) && t < fmax(a, b)) || k > 60) t = 0.5 * (a + b);
        if (t == a || t == b) break;
        double f = event_at(e, t, ok);
        if (f == 0) return t;
        if (f > 0) {
            b = t;
            fb = f;
            if (side > 0) fa *= 0.5;
            side = 1;
        } else {
            a = t;
            fa = f;
            if (side < 0) fb *= 0.5;
            side = -1;
        }
    }
    return a; // the last time at which it had not happened
}

static bool is_in_contact(const YkSimulation *sim, const YkLoadItem *item)
{
    for (size_t c = 0; c < sim->contact_count; c++)
        if (&sim->dynamics->loads->items[sim->contacts[c].item] == item) return true;
    return false;
}

// Returns the first time in the last step at which the event happens, by probes of the step; HUGE_VAL if it does not.
// fa: its function at the step's beginning.
static double first_time(const Event *e, double fa, bool *ok)
{
    double from = yk_ode_previous(e->sim->ode), to = yk_ode_time(e->sim->ode), a = from;
    for (int k = 1; k <= PROBES && *ok; k++) {
        double t = k == PROBES ? to : from + (to - from) * k / PROBES, f = event_at(e, t, ok);
        if (f > 0 && fa <= 0) return locate(e, a, fa, t, f, ok);
        a = t;
        fa = f;
    }
    return fa > 0 && *ok ? from : HUGE_VAL; // it had happened all along: a rebound too small to see
}

// --- contacts that can no longer hold

// Returns whether the contacts can hold at a time within the last step. *asked: the sum of the efforts that this
// requires.
static bool holds_at(YkSimulation *sim, double t, double *asked)
{
    bool holds = true;
    *asked = 0;
    if (yk_ode_dense(sim->ode, t, sim->dense) != YK_ODE_OK) return true; // checked again at the end of the step
    sim->is_testing = true;
    bool failed = yk_simulation_motion(sim, t, sim->dense, sim->rate) != 0;
    sim->is_testing = false;
    if (failed) return sim->near_count > 0 && yk_simulation_in_zone(sim, t);
    for (size_t c = 0; c < sim->contact_count; c++) {
        double inverse = sim->matrix[c * sim->contact_count + c];
        if (inverse > 0) *asked += sim->bias[c] / inverse;
        holds = holds && yk_simulation_contact_acceleration(sim, c) == 0;
    }
    return holds;
}

// Returns the first time between a, where they hold, and b, where they do not, at which they do not; as precisely as
// times can be distinguished.
static double locate_failure(YkSimulation *sim, double a, double b)
{
    double asked, least = 1e-14 * (yk_ode_time(sim->ode) - yk_ode_previous(sim->ode));
    while (b - a > fmax(least, 4e-16 * fabs(b))) {
        double t = 0.5 * (a + b);
        if (t <= a || t >= b) break;
        *(holds_at(sim, t, &asked) ? &a : &b) = t;
    }
    return b;
}

typedef struct Probe {
    double t, asked;
} Probe;

// Checks between two times at which they hold: halfway, and further where the required efforts are not on a straight
// line. Returns a time at which they do not hold, or HUGE_VAL.
static double look_between(YkSimulation *sim, Probe a, Probe b, double most, int depth)
{
    Probe middle = {.t = 0.5 * (a.t + b.t)};
    if (!holds_at(sim, middle.t, &middle.asked)) return locate_failure(sim, a.t, middle.t);
    most = fmax(most, fabs(middle.asked));
    bool is_straight = fabs(middle.asked - 0.5 * (a.asked + b.asked)) <= 0.02 * most;
    if (is_straight || depth == 0) return HUGE_VAL;
    double t = look_between(sim, a, middle, most, depth - 1);
    return t < HUGE_VAL ? t : look_between(sim, middle, b, most, depth - 1);
}

// Returns the first time in the last step at which the contacts can no longer hold; HUGE_VAL if they hold to its end.
static double first_failure(YkSimulation *sim)
{
    enum { DEPTH = 7 };
    double from = yk_ode_previous(sim->ode), to = yk_ode_time(sim->ode);
    Probe a = {.t = from}, b = {.t = to}, quarter = {.t = from + 0.25 * (to - from)};
    holds_at(sim, from, &a.asked);
    if (!holds_at(sim, quarter.t, &quarter.asked)) return locate_failure(sim, from, quarter.t);
    bool holds = holds_at(sim, to, &b.asked);
    double most = fmax(fabs(quarter.asked), fmax(fabs(a.asked), fabs(b.asked)));
    double t = look_between(sim, a, quarter, most, DEPTH);
    if (t == HUGE_VAL) t = look_between(sim, quarter, b, most, DEPTH);
    return t < HUGE_VAL || holds ? t : locate_failure(sim, quarter.t, to);
}

static void look_at_items(YkSimulation *sim, bool *ok)
{
    YkLoads *loads = sim->dynamics->loads;
    sim->pending = YK_PENDING_NONE;
    double t_release = sim->contact_count > 0 ? first_failure(sim) : HUGE_VAL;
    if (t_release < HUGE_VAL) {
        sim->pending = YK_PENDING_RELEASE;
        sim->pending_time = t_release;
    }
    for (size_t k = 0; k < loads->item_count && *ok; k++) {
        YkLoadItem *item = &loads->items[k];
        bool is_stop = item->kind == YK_LOAD_STOP, slides = item->kind == YK_LOAD_COULOMB && item->direction != 0;
        if ((!is_stop && !slides) || is_in_contact(sim, item)) continue;
        Event e = {.sim = sim, .item = item};
        double t = first_time(&e, event_at(&e, yk_ode_previous(sim->ode), ok), ok);
        if (t == HUGE_VAL || (sim->pending != YK_PENDING_NONE && t >= sim->pending_time)) continue;
        sim->pending = is_stop ? YK_PENDING_STOP : YK_PENDING_STICK;
        sim->pending_item = k;
        sim->pending_time = t;
    }
}

static void look_at_watch(YkSimulation *sim, YkEventWatch *watch, double end, bool *ok)
{
    Event e = {.sim = sim, .watch = watch, .way = 1};
    double now = event_at(&e, end, ok), last = watch->last;
    watch->last = now;
    if (!*ok || (last <= 0) == (now <= 0)) return;
    double from = yk_ode_previous(sim->ode), way = now > 0 ? 1 : -1;
    if (watch->direction != 0 && way != watch->direction) return;
    e.way = way;
    double t = locate(&e, from, way * last, end, way * now, ok);
    if (*ok) yk_simulation_note(sim, YK_HAPPENING_CROSSING, t, watch->name, watch->level);
}

// --- cams that would have to pull

static bool has_happened(const YkSimulation *sim, YkHappeningKind kind, const char *name)
{
    for (size_t k = 0; k < sim->happening_count; k++)
        if (sim->happenings[k].kind == kind && strcmp(sim->happenings[k].name, name) == 0) return true;
    return false;
}

static void note_pull(const Event *e, double t, bool *ok)
{
    YkSimulation *sim = e->sim;
    const YkCam *cam = &sim->model->cams[e->cam];
    *ok = *ok && visit(sim, t, false);
    double angle = yk_state_channel(sim->state, (YkChannel){.kind = YK_CHANNEL_JOINT_ANGLE, .index = cam->cam_joint});
    if (*ok) yk_simulation_note(sim, YK_HAPPENING_PULL, t, cam->name, angle);
}

// Looks for the times in the last step, up to `end`, from which a cam would have to pull a follower that cannot fly.
static void look_at_held_cam(YkSimulation *sim, size_t cam, double end, bool *ok)
{
    Event e = {.sim = sim, .cam = cam};
    double from = yk_ode_previous(sim->ode), a = from, fa = event_at(&e, from, ok);
    for (int k = 1; k <= PROBES && *ok; k++) {
        double t = k == PROBES ? end : from + (end - from) * k / PROBES, f = event_at(&e, t, ok);
        if (*ok && f > 0 && fa <= 0) note_pull(&e, locate(&e, a, fa, t, f, ok), ok);
        a = t;
        fa = f;
    }
}

static void look_at_held_cams(YkSimulation *sim, double end, bool *ok)
{
    for (size_t k = 0; k < sim->model->cam_count; k++)
        if (sim->flights[k].is_held) look_at_held_cam(sim, k, end, ok);
}

// Finds the first cam in the last step that loses its follower, or that its follower reaches.
static void look_at_cams(YkSimulation *sim, bool *ok)
{
    for (size_t k = 0; k < sim->model->cam_count && *ok; k++) {
        Event e = {.sim = sim, .cam = k, .is_landing = sim->open[k]};
        if (!e.is_landing && (!yk_simulation_is_loose(sim, k) || sim->flights[k].is_held)) continue;
        double from = yk_ode_previous(sim->ode), first = event_at(&e, from, ok);
        double t = first > 0 ? from : first_time(&e, first, ok);
        if (!*ok || t == HUGE_VAL || (sim->pending != YK_PENDING_NONE && t >= sim->pending_time)) continue;
        sim->pending = e.is_landing ? YK_PENDING_LANDING : YK_PENDING_LIFT_OFF;
        sim->pending_item = k;
        sim->pending_time = t;
    }
}

// --- laws whose range is left

// Notes it with the argument at the present pose.
static void note_law(YkSimulation *sim, const YkLawUse *use, double t)
{
    yk_simulation_note(sim, YK_HAPPENING_LAW_LEFT, t, use->told.name, argument_here(sim, use));
}

// Looks for the time in the last step, up to `end`, at which a law is left for the first time.
static void look_at_law(YkSimulation *sim, const YkLawUse *use, double end, bool *ok)
{
    if (has_happened(sim, YK_HAPPENING_LAW_LEFT, use->told.name)) return;
    Event e = {.sim = sim, .use = use};
    double from = yk_ode_previous(sim->ode), a = from, fa = event_at(&e, from, ok), t = HUGE_VAL;
    if (*ok && fa > 0) t = from;
    for (int k = 1; k <= PROBES && *ok && t == HUGE_VAL; k++) {
        double b = k == PROBES ? end : from + (end - from) * k / PROBES, fb = event_at(&e, b, ok);
        if (*ok && fb > 0) t = locate(&e, a, fa, b, fb, ok);
        a = b;
        fa = fb;
    }
    *ok = *ok && (t == HUGE_VAL || visit(sim, t, false));
    if (*ok && t < HUGE_VAL) note_law(sim, use, t);
}

static void look_at_laws(YkSimulation *sim, double end, bool *ok)
{
    for (size_t k = 0; k < sim->laws->count; k++) look_at_law(sim, &sim->laws->uses[k], end, ok);
}

// Returns whether drives move the machine now: it then has kinetic energy where its one free coordinate merely turns
// back.
static bool is_driven(const YkSimulation *sim)
{
    for (size_t i = 0; i < sim->mech->input_count; i++)
        if (!sim->dynamics->is_free[i] && sim->state->input[3 * i + 1] != 0) return true;
    return false;
}

// Takes a machine with one freedom past a dead point of its starting coordinate, where that one reverses while the rest
// continues. The state is at the end of the last step; returns whether it was moved.
bool yk_simulation_look_dead(YkSimulation *sim)
{
    YkEventWatch watch = {.channel = {.kind = YK_CHANNEL_COORDINATE, .index = sim->first, .order = 1}};
    Event e = {.sim = sim, .watch = &watch, .way = 1};
    if (sim->first == YK_NONE || sim->free_count != 1) return false;
    double last = sim->first_rate, now = event_here(&e);
    sim->first_rate = now;
    if (!(last * now < 0)) return false;
    bool ok = true;
    double end = yk_ode_time(sim->ode);
    e.way = now > 0 ? 1 : -1;
    double t = locate(&e, yk_ode_previous(sim->ode), e.way * last, end, e.way * now, &ok);
    double kinetic = ok ? yk_dynamics_energy_at(sim->dynamics, sim->state).kinetic : 0;
    if (kinetic > 1e-9 * sim->kinetic_high && !is_driven(sim))
        yk_simulation_note(sim, YK_HAPPENING_DEAD_POINT, t, sim->mech->coordinates[sim->first].name, 0);
    return true;
}

void yk_simulation_watch_start(YkSimulation *sim)
{
    for (size_t k = 0; k < sim->watch_count; k++)
        sim->watches[k].last = event_here(&(Event){.sim = sim, .watch = &sim->watches[k], .way = 1});
    for (size_t k = 0; k < sim->laws->count; k++) {
        const YkLawUse *use = &sim->laws->uses[k];
        if (excess_here(sim, use) > 0 && !has_happened(sim, YK_HAPPENING_LAW_LEFT, use->told.name))
            note_law(sim, use, sim->time);
    }
}

void yk_simulation_look(YkSimulation *sim)
{
    bool ok = true;
    look_at_items(sim, &ok);
    look_at_cams(sim, &ok);
    double end = sim->pending != YK_PENDING_NONE ? sim->pending_time : yk_ode_time(sim->ode);
    for (size_t k = 0; k < sim->watch_count; k++) look_at_watch(sim, &sim->watches[k], end, &ok);
    look_at_held_cams(sim, end, &ok);
    look_at_laws(sim, end, &ok);
}
