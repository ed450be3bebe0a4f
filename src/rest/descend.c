// Goes to an equilibrium from a pose nearby, and keeps those that are not known yet.
#include <string.h>
#include "num/dense.h"
#include "rest/rest.h"
#include "solve/gap.h"

static const double SAME = 1e-5; // rad, or machine sizes: poses that are one
static const double NONE = 1e-9; // of the largest acceleration: at rest

static double norm(const YkRest *rest, const double *a)
{
    double sum = 0;
    for (size_t k = 0; k < rest->freedom; k++) sum += a[k] / rest->scale[k] * (a[k] / rest->scale[k]);
    return sqrt(sum);
}

// Returns whether a pose from which the search goes no further is an equilibrium. Forces may be small only because the
// largest seen, such as those beside a dead point, are huge: the next step must be small too.
static bool is_at_rest(const YkRest *rest, double size, double step)
{
    return size <= NONE * rest->force_scale && step <= 1e-4;
}

// Finds the step of Newton's method in rest->step, or with `is_least` the one that leaves out directions that meet
// hardly any force. Returns the longest of its parts; HUGE_VAL if there is none.
static double find_step(YkRest *rest, bool is_least)
{
    const double FORCELESS = 1e-9;
    size_t f = rest->freedom;
    double *J = rest->jacobian, *step = rest->step, *b = rest->trial, *tau = rest->a + 2 * f, longest = 0;
    if (!yk_rest_differentiate(rest, rest->q, J)) return HUGE_VAL;
    for (size_t i = 0; i < f; i++) {
        b[i] = -rest->a[i] / rest->scale[i];
        for (size_t j = 0; is_least && j < f; j++) J[i * f + j] *= rest->scale[j] / rest->scale[i];
    }
    if (is_least) {
        size_t rank = yk_qr_factor(f, f, J, rest->order, tau, FORCELESS);
        yk_qr_solve(f, f, J, rest->order, tau, rank, b, step);
        for (size_t i = 0; i < f; i++) step[i] *= rest->scale[i];
    } else {
        for (size_t i = 0; i < f; i++) step[i] = -rest->a[i];
        if (yk_lu_factor(f, J, rest->pivot, rest->trial) == 0) return HUGE_VAL;
        yk_lu_solve(f, J, rest->pivot, step);
    }
    for (size_t i = 0; i < f; i++) longest = fmax(longest, fabs(step[i]) / rest->scale[i]);
    return longest;
}

// Returns how large accelerations are that are none, if those of this pose may be: rounding beside the largest, and
// also beside what the loads here would give if none balanced another. Stiff springs may be slack here. Changes
// rest->trial.
static double find_none(YkRest *rest, double size)
{
    const double ROUNDING = 1e-12;
    bool may_be = size <= ROUNDING * rest->force_scale && yk_rest_weigh_loads(rest);
    return ROUNDING * (may_be ? fmin(rest->loads, rest->force_scale) : rest->force_scale);
}

// Newton's method, with a line search on the magnitude of the accelerations. Where those that are left are rounding, a
// stiff direction may hide a weak one: it goes on as long as steps are short and help.
bool yk_rest_descend(YkRest *rest)
{
    enum { STEPS_MAX = 60 };
    const double FAR = 100, SHORT = 0.1, NO_STEP = 1e-10; // rad, or machine sizes
    size_t f = rest->freedom;
    double *q = rest->q, *a = rest->a;
    bool has_inertia = yk_rest_accelerations(rest, q, NULL, a);
    if (!has_inertia && rest->lack.status == YK_OK) rest->lack = rest->dynamics->report;
    if (!has_inertia) return false;
    rest->has_inertia = true;
    double size = norm(rest, a), longest = 0;
    rest->force_scale = fmax(rest->force_scale, size);
    for (int k = 0; k < STEPS_MAX; k++) {
        if (!yk_pace_spend(rest->pace, f * f * f)) return false;
        double none = find_none(rest, size);
        bool is_none = size <= none;
        longest = size > 0 ? find_step(rest, false) : 0;
        if (is_none && (!(longest < SHORT) || (size <= 0.1 * none && longest <= NO_STEP))) return true;
        const double most = 0.7;
        double part = longest < FAR ? longest : find_step(rest, true), next = HUGE_VAL;
        if (!isfinite(part)) return false;
        double way = part > most ? most / part : 1;
        double *there = rest->a + f, *trial = rest->a + 2 * f, *kept = rest->a + 3 * f;
        memcpy(kept, rest->step, f * sizeof *kept);
        for (int half = 0; half < 12; half++, way *= 0.5) {
            for (size_t i = 0; i < f; i++) trial[i] = q[i] + way * kept[i];
            next = yk_rest_accelerations(rest, trial, NULL, there) ? norm(rest, there) : HUGE_VAL;
            if (next < size) break;
        }
        if (!(next < size)) return is_none || is_at_rest(rest, size, longest);
        memcpy(q, trial, f * sizeof *q);
        memcpy(a, there, f * sizeof *a);
        size = next;
    }
    return is_at_rest(rest, size, longest);
}

// Returns how far the pose in which the machine stands is from a known one.
static double gap_to(const YkRest *rest, const YkRestPoint *p)
{
    const YkMechanism *mech = rest->mech;
    double gap = 0;
    for (size_t c = 0; c < mech->coordinate_count; c++) {
        double off = yk_state_coordinate(rest->state, c).position - p->coordinates[c];
        gap = fmax(gap, yk_gap(mech, mech->coordinates[c].is_distance, off));
    }
    return gap;
}

static bool stand_there(YkRest *rest)
{
    return yk_rest_accelerations(rest, rest->q, NULL, rest->a) && yk_state_solve(rest->state) >= 0;
}

// Returns whether the machine comes from the pose of a point to a known one in steps that end at rest: both are poses
// of one continuum.
static bool rests_between(YkRest *rest, const YkRestPoint *from, const YkRestPoint *to)
{
    enum { STEPS = 40 };
    const double STEP = 0.25;
    double *q = rest->q, *way = rest->step, left = HUGE_VAL;
    size_t f = rest->freedom;
    for (size_t i = 0; i < f; i++) q[i] = from->inputs[3 * rest->input[i]];
    for (int k = 0; k < STEPS && left > SAME; k++) {
        if (!yk_rest_accelerations(rest, q, NULL, rest->a)) return false;
        if (norm(rest, rest->a) > NONE * rest->force_scale && !yk_rest_descend(rest)) return false;
        left = 0;
        for (size_t i = 0; i < f; i++) {
            way[i] = to->inputs[3 * rest->input[i]] - q[i];
            if (!rest->mech->coordinates[yk_rest_free_coordinate(rest, i)].is_distance)
                way[i] = yk_nearest_turn(way[i], 0);
            left = fmax(left, fabs(way[i]) / rest->scale[i]);
        }
        for (size_t i = 0; i < f; i++) q[i] += way[i] * fmin(1, STEP / left);
    }
    return left <= SAME && stand_there(rest) && gap_to(rest, to) < SAME;
}

// Returns whether the pose of a point, in which the machine stands, was found before, or is one of a known continuum.
static bool is_known(YkRest *rest, const YkRestPoint *point)
{
    for (size_t k = 0; k < rest->count; k++) {
        const YkRestPoint *p = &rest->points[k];
        if (point->is_continuous ? p->is_continuous && rests_between(rest, point, p) : gap_to(rest, p) < SAME)
            return true;
    }
    return false;
}

static YkRestPoint new_point(YkRest *rest)
{
    size_t f = rest->freedom, inputs = 3 * rest->mech->input_count + 1;
    YkRestPoint p = {.inputs = YK_NEW(rest->arena, double, inputs),
                     .branch = YK_NEW(rest->arena, signed char, rest->mech->block_count + 1),
                     .coordinates = YK_NEW(rest->arena, double, rest->mech->coordinate_count + 1),
                     .mass = YK_NEW(rest->arena, double, 4 * f * f + 6 * f + 6)};
    if (!p.mass) return p;
    p.damping = p.mass + f * f;
    p.stiffness = p.damping + f * f;
    p.shape = p.stiffness + f * f;
    p.frequency = p.shape + f * f;
    p.ratio = p.frequency + f;
    p.real = p.ratio + f;
    p.imaginary = p.real + 2 * f;
    return p;
}

// Goes, where a machine with one freedom meets hardly any force, to the place at which it changes its direction: what
// grows with a power of the distance is rounding long before. Stays if there is more force on the way, to another
// equilibrium.
static void narrow(YkRest *rest)
{
    const double FLAT = 1e-7, ROUNDING = 1e-12;
    double here = rest->q[0], unit = rest->scale[0], most = fmax(fabs(rest->a[0]), ROUNDING * rest->force_scale * unit);
    double a[2] = {0, 0}, now = 0, h = 1e-4;
    for (; a[0] * a[1] >= 0; h *= 4) {
        if (h > 1 || !yk_rest_beside(rest, h, a)) return;
        if (h == 1e-4 && fmax(fabs(a[0]), fabs(a[1])) > FLAT * rest->force_scale * unit) return;
    }
    double there = here, step = h / 4 * unit;
    for (int k = 0; k < 60; k++, step *= 0.5) {
        if (!yk_rest_accelerations(rest, &there, NULL, &now)) return;
        there += now * a[0] > 0 ? 0.5 * step : now * a[0] < 0 ? -0.5 * step : 0;
    }
    double between = 0.5 * (here + there);
    if (yk_rest_accelerations(rest, &between, NULL, &now) && fabs(now) <= most) rest->q[0] = there;
}

bool yk_rest_keep(YkRest *rest)
{
    YkState *s = rest->state;
    if (rest->freedom == 1) narrow(rest);
    if (!stand_there(rest)) return true;
    YkRestPoint p = new_point(rest);
    if (yk_arena_failed(rest->arena) || !YK_ROOM(rest->points, rest->count, rest->capacity)) return false;
    if (is_known(rest, &p)) return true;
    for (size_t c = 0; c < rest->mech->coordinate_count; c++) p.coordinates[c] = yk_state_coordinate(s, c).position;
    memcpy(p.inputs, s->input, 3 * rest->mech->input_count * sizeof *p.inputs);
    memcpy(p.branch, s->branch, rest->mech->block_count);
    p.at.potential = yk_dynamics_energy_at(rest->dynamics, s).potential;
    p.at.force = rest->force_scale > 0 ? norm(rest, rest->a) / rest->force_scale : 0;
    bool has_modes = yk_rest_linearise(rest, &p);
    if (has_modes && !(p.is_continuous && is_known(rest, &p))) rest->points[rest->count++] = p;
    return has_modes || !yk_arena_failed(rest->arena);
}
