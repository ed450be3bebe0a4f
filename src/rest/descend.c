// Goes to an equilibrium from a pose nearby, and keeps those that are not known yet.
#include <stdlib.h>
#include <string.h>
#include "num/dense.h"
#include "rest/rest.h"
#include "solve/gap.h"

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
    return size <= 1e-9 * rest->force_scale && step <= 1e-4;
}

// Newton's method, with a line search on the magnitude of the accelerations.
bool yk_rest_descend(YkRest *rest)
{
    enum { STEPS_MAX = 60 };
    size_t f = rest->freedom;
    double *q = rest->q, *a = rest->a, *J = rest->jacobian;
    bool has_inertia = yk_rest_accelerations(rest, q, NULL, a);
    if (!has_inertia && rest->lack.status == YK_OK) rest->lack = rest->dynamics->report;
    if (!has_inertia) return false;
    rest->has_inertia = true;
    double size = norm(rest, a);
    rest->force_scale = fmax(rest->force_scale, size);
    double longest = 0; // rad, or machine sizes
    for (int k = 0; k < STEPS_MAX; k++) {
        if (!yk_pace_spend(rest->pace, f * f * f)) return false;
        if (size <= 1e-13 * rest->force_scale) return true;
        if (!yk_rest_differentiate(rest, q, J)) return false;
        double *step = rest->step;
        for (size_t i = 0; i < f; i++) step[i] = -a[i];
        if (yk_lu_factor(f, J, rest->pivot, rest->trial) == 0) return false;
        yk_lu_solve(f, J, rest->pivot, step);
        const double most = 0.7;
        longest = 0;
        for (size_t i = 0; i < f; i++) longest = fmax(longest, fabs(step[i]) / rest->scale[i]);
        if (!isfinite(longest)) return false;
        double way = longest > most ? most / longest : 1, next = HUGE_VAL;
        double *there = rest->a + f, *trial = rest->a + 2 * f, *kept = rest->a + 3 * f;
        memcpy(kept, step, f * sizeof *kept);
        for (int half = 0; half < 12; half++, way *= 0.5) {
            for (size_t i = 0; i < f; i++) trial[i] = q[i] + way * kept[i];
            next = yk_rest_accelerations(rest, trial, NULL, there) ? norm(rest, there) : HUGE_VAL;
            if (next < size) break;
        }
        if (!(next < size)) return is_at_rest(rest, size, longest);
        memcpy(q, trial, f * sizeof *q);
        memcpy(a, there, f * sizeof *a);
        size = next;
    }
    return is_at_rest(rest, size, longest);
}

// Returns whether the pose was found before. Angles modulo a turn.
static bool is_known(const YkRest *rest, const double *coordinates)
{
    for (size_t p = 0; p < rest->count; p++)
        if (yk_pose_gap(rest->mech, coordinates, rest->points[p].coordinates) < 1e-5) return true;
    return false;
}

// Returns whether the machine rests all the way from the pose in rest->q, in which it stands, to a known point: both
// are poses of one continuum.
static bool rests_until(YkRest *rest, const YkRestPoint *p)
{
    enum { POSES = 8 };
    double *x = rest->trial;
    for (int k = 1; k <= POSES; k++) {
        for (size_t i = 0; i < rest->freedom; i++)
            x[i] = rest->q[i] + (p->inputs[3 * rest->input[i]] - rest->q[i]) * k / POSES;
        if (!yk_rest_accelerations(rest, x, NULL, rest->a) || norm(rest, rest->a) > 1e-9 * rest->force_scale)
            return false;
    }
    if (yk_state_solve(rest->state) < 0) return false;
    for (size_t c = 0; c < rest->mech->coordinate_count; c++) {
        double off = yk_state_coordinate(rest->state, c).position - p->coordinates[c];
        if (yk_gap(rest->mech, rest->mech->coordinates[c].is_distance, off) > 1e-5) return false;
    }
    return true;
}

static bool is_of_known_continuum(YkRest *rest, const YkRestPoint *point)
{
    if (point->at.stability != YK_STABILITY_NEUTRAL) return false;
    for (size_t p = 0; p < rest->count; p++) {
        if (rest->points[p].at.stability != YK_STABILITY_NEUTRAL) continue;
        if (!yk_rest_accelerations(rest, rest->q, NULL, rest->a)) return false; // back to the pose
        if (rests_until(rest, &rest->points[p])) return true;
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
// grows with a power of the distance is rounding long before.
static void narrow(YkRest *rest)
{
    const double FLAT = 1e-7;
    double here = rest->q[0], unit = rest->scale[0], a, b;
    for (double h = 1e-4; h < 0.05; h *= 10) {
        double low = here - h * unit, high = here + h * unit;
        if (!yk_rest_accelerations(rest, &low, NULL, &a) || !yk_rest_accelerations(rest, &high, NULL, &b)) return;
        if (h == 1e-4 && fmax(fabs(a), fabs(b)) > FLAT * rest->force_scale * unit) return;
        for (int k = 0; k < 60 && a * b < 0; k++) {
            double middle = rest->q[0] = 0.5 * (low + high), now;
            if (!yk_rest_accelerations(rest, &middle, NULL, &now)) return;
            if (now * a >= 0) low = middle;
            if (now * a <= 0) high = middle;
        }
        if (a * b < 0) return;
    }
}

bool yk_rest_keep(YkRest *rest)
{
    YkState *s = rest->state;
    if (rest->freedom == 1) narrow(rest);
    if (!yk_rest_accelerations(rest, rest->q, NULL, rest->a) || yk_state_solve(s) < 0) return true;
    YkRestPoint p = new_point(rest);
    if (yk_arena_failed(rest->arena) || !YK_ROOM(rest->points, rest->count, rest->capacity)) return false;
    for (size_t c = 0; c < rest->mech->coordinate_count; c++) p.coordinates[c] = yk_state_coordinate(s, c).position;
    if (is_known(rest, p.coordinates)) return true;
    memcpy(p.inputs, s->input, 3 * rest->mech->input_count * sizeof *p.inputs);
    memcpy(p.branch, s->branch, rest->mech->block_count);
    p.at.potential = yk_dynamics_energy_at(rest->dynamics, s).potential;
    p.at.force = rest->force_scale > 0 ? norm(rest, rest->a) / rest->force_scale : 0;
    if (yk_rest_linearise(rest, &p) && !is_of_known_continuum(rest, &p)) rest->points[rest->count++] = p;
    return true;
}
