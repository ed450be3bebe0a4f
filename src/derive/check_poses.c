// Are both sides equal at poses of the numeric engine?
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "derive/check_inside.h"
#include "derive/relations.h"
#include "solve/state.h"

enum { TRIES_A_POSE = 4, TRIES_IN_SEGMENT = 40, STEPS = 96 };
static const double EQUAL = 1e-9, TIME = 5;

double yk_check_uniform(YkCheck *check, double low, double high) // splitmix64 (Steele et al. 2014)
{
    uint64_t z = (check->seed += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return low + (high - low) * (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

bool yk_check_solve(YkCheck *check)
{
    YkStatus status = check->dynamics ? yk_dynamics_solve(check->dynamics, check->state, YK_METHOD_REDUCED)
                                      : yk_state_solve(check->state);
    return status >= 0 && yk_state_has_rates(check->state);
}

double yk_check_margin(const YkCheck *check)
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
    double size = is_distance ? d->mech->size : 1,
           turn = check->within_count > 0 ? 2 * YK_PI : YK_PI, // all segments of a motion program
        reach = is_distance ? 0.5 * fabs(from.position) + 0.1 * size : turn;
    return (YkMotion){from.position + yk_check_uniform(check, -reach, reach), size * yk_check_uniform(check, 0.3, 2),
                      size * yk_check_uniform(check, -2, 2)};
}

// Loads may hang on the time; inputs come afterwards.
static void set_any_time(YkCheck *check)
{
    if (yk_state_set_time(check->state, yk_check_uniform(check, 0, TIME), NULL) >= 0) return;
    yk_state_set_time(check->state, yk_state_time(check->start), NULL);
}

// From the start towards random inputs in small steps, and no further than to where another configuration comes near:
// with special dimensions (a parallelogram) what holds in one does not hold in the other.
static bool move_to_random_pose(YkCheck *check, YkMotion *target)
{
    const YkMechanism *mech = check->d->mech;
    double reached = 0, least = fmin(0.1, 0.5 * check->start_margin);
    for (size_t i = 0; i < mech->input_count; i++) target[i] = random_input(check, i);
    yk_state_copy(check->state, check->start);
    set_any_time(check);
    for (int step = 1; step <= STEPS; step++) {
        go(check, target, (double)step / STEPS);
        if (yk_state_solve(check->state) < 0 || yk_check_margin(check) < least) break;
        yk_state_refer(check->state); // angles go on from here, over any number of turns
        reached = (double)step / STEPS;
    }
    go(check, target, reached);
    return yk_check_solve(check);
}

// Reading brings symbols: constants, angles and roots of an equation's own, also of those that slips are looked for in.
static bool make_room(YkCheck *check)
{
    size_t count = yk_ring_symbol_count(check->d->ring), room = count + 64;
    if (count <= check->value_count) return true;
    double *values = realloc(check->values, room * sizeof *values);
    check->failed |= !values;
    if (!values) return false;
    memset(values + check->value_count, 0, (room - check->value_count) * sizeof *values);
    check->values = values;
    check->value_count = room;
    return true;
}

void yk_check_fill_values(YkCheck *check)
{
    if (!make_room(check)) return;
    yk_derive_values(check->d, check->state, check->dynamics, check->values);
}

static double distance_of(YkCheck *check, const YkForm *zero)
{
    return yk_norm(yk_form_value(check->d->ring, zero, check->values));
}

// Forces that are rounding alone - a moment that is 0 - are measured by those that are not.
static void disturb_forces(YkCheck *check)
{
    const YkDerivation *d = check->d;
    double most = 0;
    for (size_t k = 0; k < d->unknown_count; k++)
        if (isfinite(check->values[d->unknowns[k]])) most = fmax(most, fabs(check->values[d->unknowns[k]]));
    for (size_t k = 0; k < d->unknown_count; k++)
        check->values[d->unknowns[k]] += most * yk_check_uniform(check, 0.2, 1);
}

// The size of what is compared when the coordinates are *not* on the machine: terms that are 0 there, too, have one.
static double size_off_the_machine(YkCheck *check, const YkForm *zero)
{
    const YkDerivation *d = check->d;
    for (size_t k = 0; k < d->coordinate_count; k++) {
        const YkDeriveCoordinate *c = &d->coordinates[k];
        double size = c->is_distance ? d->mech->size : 1;
        check->values[c->position] += size * yk_check_uniform(check, 0.2, 1);
        check->values[c->rate] += size * yk_check_uniform(check, 0.2, 1);
        check->values[c->acceleration] += size * yk_check_uniform(check, 0.2, 1);
    }
    for (size_t k = 0; k < d->tie_count; k++) // laws: in a dwell their slopes are no more than rounding
        for (int32_t order = 0; d->ties[k].function >= 0 && order < YK_TIE_ORDERS; order++)
            check->values[d->ties[k].function + order] += d->mech->size * yk_check_uniform(check, 0.2, 1);
    for (size_t b = 0; b < d->model->body_count; b++)
        if (d->bodies[b].angle >= 0) check->values[d->bodies[b].angle] += yk_check_uniform(check, 0.2, 1);
    disturb_forces(check);
    yk_ring_complete(d->ring, check->values);
    return distance_of(check, zero);
}

// Is it 0 at the values of a pose but for rounding? They are disturbed afterwards.
static YkCheckOutcome judge(YkCheck *check, const YkForm *zero)
{
    double distance = distance_of(check, zero), size = yk_form_magnitude(check->d->ring, zero, check->values),
           elsewhere = size_off_the_machine(check, zero);
    if (!isfinite(distance) || !isfinite(size)) return YK_CHECK_NO_NUMBER;
    return distance > EQUAL * (isfinite(elsewhere) ? fmax(size, elsewhere) : size) ? YK_CHECK_DIFFERENT : YK_CHECK_SAME;
}

// A motion program is printed for its first period.
static bool is_in_first_period(const YkCheck *check)
{
    for (size_t k = 0; k < check->d->tie_count; k++) {
        const YkDeriveRelation *tie = &check->d->ties[k];
        if (tie->function < 0) continue;
        YkLawRange range = yk_law_range(tie->law);
        double x = check->values[tie->variable];
        if (range.period > 0 && !(x >= range.from && x <= range.from + range.period)) return false;
    }
    return true;
}

// In the segment of which the equation speaks?
static bool is_within(const YkCheck *check)
{
    if (check->within_count > 0 && !is_in_first_period(check)) return false;
    for (size_t k = 0; k < check->within_count; k++) {
        double part = yk_ring_value(check->d->ring, check->within[k], check->values).x;
        if (!(part >= 0 && part <= 1)) return false;
    }
    return true;
}

YkCheckOutcome yk_check_judge(YkCheck *check)
{
    yk_check_fill_values(check);
    return is_within(check) ? judge(check, check->difference) : YK_CHECK_NO_NUMBER;
}

static void keep_values(YkCheck *check)
{
    size_t count = yk_ring_symbol_count(check->d->ring);
    double *kept = check->kept_count < YK_CHECK_POSES ? malloc(count * sizeof *kept) : NULL;
    if (!kept) return;
    memcpy(kept, check->values, count * sizeof *kept);
    check->kept_size[check->kept_count] = count;
    check->kept[check->kept_count++] = kept;
}

void yk_check_free_poses(YkCheck *check)
{
    for (size_t k = 0; k < check->kept_count; k++) free(check->kept[k]);
    check->kept_count = 0;
}

static void note_motion(YkCheck *check)
{
    YkCheckSeen *seen = check->seen;
    if (seen->count == YK_CHECK_SEEN_MAX) return;
    size_t n = check->d->tree_count;
    double *row = seen->motion + 2 * n * seen->count++;
    for (size_t k = 0; k < n; k++) {
        YkMotion motion = yk_state_coordinate(check->state, k);
        row[k] = motion.position;
        row[n + k] = motion.velocity;
    }
}

// Of a short segment few poses are found by chance.
static size_t tries_for(const YkCheck *check, size_t poses)
{
    return (check->within_count > 0 ? TRIES_IN_SEGMENT : TRIES_A_POSE) * poses;
}

// The first pose is the start.
static bool next_pose(YkCheck *check, size_t index, YkMotion *target)
{
    if (index == 0 ? !yk_check_solve(check) : !move_to_random_pose(check, target)) return false;
    yk_check_fill_values(check);
    return is_within(check);
}

bool yk_check_differs(YkCheck *check, size_t most, size_t *poses)
{
    YkMotion *target = calloc(check->d->mech->input_count + 1, sizeof *target);
    bool differs = false;
    check->start_margin = yk_check_margin(check);
    for (size_t k = 0; target && k < tries_for(check, most) && *poses < most && !differs; k++) {
        if (!next_pose(check, k, target)) continue;
        keep_values(check);
        note_motion(check);
        YkCheckOutcome outcome = judge(check, check->difference);
        *poses += outcome != YK_CHECK_NO_NUMBER;
        differs = outcome == YK_CHECK_DIFFERENT;
    }
    free(target);
    return differs;
}

// More poses, whatever the equation says there. The state comes back as it was; forces do not.
static void keep_more(YkCheck *check)
{
    YkMotion *target = calloc(check->d->mech->input_count + 1, sizeof *target);
    YkState *here = yk_state_new(check->d->mech);
    if (target && here && yk_state_copy(here, check->state) >= 0) {
        for (size_t k = 1; k < tries_for(check, YK_CHECK_POSES) && check->kept_count < YK_CHECK_POSES; k++)
            if (next_pose(check, k, target)) keep_values(check);
        yk_state_copy(check->state, here);
    }
    yk_state_free(here);
    free(target);
}

// Has it symbols from this one on?
static bool is_newer(YkRing *ring, const YkForm *form, size_t first)
{
    const YkPoisson *a = yk_form_element(form);
    for (size_t k = 0; !a && k < yk_form_part_count(form); k++)
        if (is_newer(ring, yk_form_part(form, k), first)) return true;
    return a && yk_ring_next_symbol(ring, a, (int32_t)first - 1) >= 0;
}

bool yk_check_is_zero_at_poses(YkCheck *check, const YkForm *zero)
{
    size_t poses = 0;
    if (check->kept_count < YK_CHECK_POSES_MIN) keep_more(check);
    if (!make_room(check)) return false;
    for (size_t k = 0; k < check->kept_count; k++) {
        if (is_newer(check->d->ring, zero, check->kept_size[k])) return false; // of no known value
        memset(check->values, 0, check->value_count * sizeof *check->values);
        memcpy(check->values, check->kept[k], check->kept_size[k] * sizeof *check->values);
        YkCheckOutcome outcome = judge(check, zero);
        if (outcome == YK_CHECK_DIFFERENT) return false;
        poses += outcome == YK_CHECK_SAME;
    }
    return poses >= YK_CHECK_POSES_MIN;
}
