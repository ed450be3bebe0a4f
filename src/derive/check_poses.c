// Are both sides equal at poses of the numeric engine?
#include <math.h>
#include <stdlib.h>
#include "derive/check_inside.h"
#include "derive/relations.h"

enum { POSES = 24, TRIES = 100, STEPS = 96 };
static const double EQUAL = 1e-9;

static double uniform(YkCheck *check, double low, double high) // splitmix64 (Steele et al. 2014)
{
    uint64_t z = (check->seed += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return low + (high - low) * (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

static bool solve_pose(YkCheck *check)
{
    YkStatus status = check->dynamics ? yk_dynamics_solve(check->dynamics, check->state, YK_METHOD_REDUCED)
                                      : yk_state_solve(check->state);
    return status >= 0 && yk_state_has_rates(check->state);
}

// The smallest transmission angle of the dyads: at 0 two configurations meet.
static double margin(const YkCheck *check)
{
    const YkMechanism *mech = check->d->mech;
    double least = YK_PI;
    for (size_t b = 0; b < mech->block_count; b++)
        if (mech->blocks[b].kind <= YK_BLOCK_RPR) least = fmin(least, yk_state_transmission(check->state, b));
    return least;
}

static void go(YkCheck *check, const YkMotion *target, double part)
{
    for (size_t i = 0; i < check->d->mech->input_count; i++) {
        YkMotion motion = target[i], from = yk_state_input(check->start, i);
        motion.position = from.position + part * (motion.position - from.position);
        yk_state_set_input(check->state, i, motion);
    }
}

static YkMotion random_input(YkCheck *check, size_t input)
{
    const YkDerivation *d = check->d;
    int32_t c = d->mech->inputs[input];
    bool is_distance = d->coordinates[c].is_distance;
    YkMotion from = yk_state_input(check->start, input);
    if (d->coordinates[c].is_held) return (YkMotion){.position = from.position};
    double size = is_distance ? d->mech->size : 1, reach = is_distance ? 0.5 * fabs(from.position) + 0.1 * size : YK_PI;
    return (YkMotion){from.position + uniform(check, -reach, reach), size * uniform(check, 0.3, 2),
                      size * uniform(check, -2, 2)};
}

// From the start towards random inputs in small steps, and no further than to where another configuration comes near:
// with special dimensions (a parallelogram) what holds in one does not hold in the other.
static bool move_to_random_pose(YkCheck *check, YkMotion *target)
{
    const YkMechanism *mech = check->d->mech;
    double reached = 0, least = fmin(0.1, 0.5 * check->start_margin);
    for (size_t i = 0; i < mech->input_count; i++) target[i] = random_input(check, i);
    yk_state_copy(check->state, check->start);
    for (int step = 1; step <= STEPS; step++) {
        go(check, target, (double)step / STEPS);
        if (yk_state_solve(check->state) < 0 || margin(check) < least) break;
        reached = (double)step / STEPS;
    }
    go(check, target, reached);
    return solve_pose(check);
}

void yk_check_fill_values(YkCheck *check)
{
    yk_derive_values(check->d, check->state, check->dynamics, check->values);
}

static double distance_of(YkCheck *check)
{
    return yk_norm(yk_form_value(check->d->ring, check->difference, check->values));
}

// Forces that are rounding alone - a moment that is 0 - are measured by those that are not.
static void disturb_forces(YkCheck *check)
{
    const YkDerivation *d = check->d;
    double most = 0;
    for (size_t k = 0; k < d->unknown_count; k++)
        if (isfinite(check->values[d->unknowns[k]])) most = fmax(most, fabs(check->values[d->unknowns[k]]));
    for (size_t k = 0; k < d->unknown_count; k++) check->values[d->unknowns[k]] += most * uniform(check, 0.2, 1);
}

// The size of what is compared when the coordinates are *not* on the machine: terms that are 0 there, too, have one.
static double size_off_the_machine(YkCheck *check)
{
    const YkDerivation *d = check->d;
    for (size_t k = 0; k < d->coordinate_count; k++) {
        const YkDeriveCoordinate *c = &d->coordinates[k];
        double size = c->is_distance ? d->mech->size : 1;
        check->values[c->position] += size * uniform(check, 0.2, 1);
        check->values[c->rate] += size * uniform(check, 0.2, 1);
        check->values[c->acceleration] += size * uniform(check, 0.2, 1);
    }
    for (size_t k = 0; k < d->tie_count; k++) // laws: in a dwell their slopes are no more than rounding
        for (int32_t order = 0; d->ties[k].function >= 0 && order < YK_TIE_ORDERS; order++)
            check->values[d->ties[k].function + order] += d->mech->size * uniform(check, 0.2, 1);
    for (size_t b = 0; b < d->model->body_count; b++)
        if (d->bodies[b].angle >= 0) check->values[d->bodies[b].angle] += uniform(check, 0.2, 1);
    disturb_forces(check);
    yk_ring_complete(d->ring, check->values);
    return distance_of(check);
}

// Compares at one pose; true when the sides differ there by more than rounding.
static bool differs_here(YkCheck *check, size_t *poses)
{
    yk_check_fill_values(check);
    double distance = distance_of(check), size = yk_form_magnitude(check->d->ring, check->difference, check->values),
           elsewhere = size_off_the_machine(check);
    if (!isfinite(distance) || !isfinite(size)) return false;
    ++*poses;
    return distance > EQUAL * (isfinite(elsewhere) ? fmax(size, elsewhere) : size);
}

bool yk_check_differs(YkCheck *check, size_t *poses)
{
    YkMotion *target = calloc(check->d->mech->input_count + 1, sizeof *target);
    bool differs = false;
    check->start_margin = margin(check);
    for (int k = 0; target && k < TRIES && *poses < POSES && !differs; k++)
        if (k == 0 ? solve_pose(check) : move_to_random_pose(check, target)) differs = differs_here(check, poses);
    free(target);
    return differs;
}

bool yk_check_holds_in_drive(YkCheck *check)
{
    static const double times[] = {0, 0.013, 0.137, 0.31};
    const YkMechanism *mech = check->d->mech;
    bool has_drive = false, holds = true;
    size_t poses = 0, count = sizeof times / sizeof *times;
    for (size_t i = 0; i < mech->input_count; i++) {
        const YkDeriveCoordinate *c = &check->d->coordinates[mech->inputs[i]];
        has_drive |= c->drive != YK_NONE && !c->is_held;
    }
    YkState *shown = has_drive ? yk_state_new(mech) : NULL;
    if (!shown || yk_state_copy(shown, check->state) < 0) holds = false;
    yk_state_copy(check->state, check->start);
    for (size_t k = 0; k < count && holds; k++)
        holds =
            yk_state_set_time(check->state, times[k], NULL) >= 0 && solve_pose(check) && !differs_here(check, &poses);
    if (shown) yk_state_copy(check->state, shown);
    yk_state_free(shown);
    return holds && poses == count;
}
