// Makes poses of the numeric engine at which equations are compared.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/mix.h"
#include "derive/relations.h"
#include "prove/check_inside.h"
#include "solve/state.h"

enum { TRIES_IN_SEGMENT = 40, STEPS = 96, SOLVE = 300 }; // SOLVE: work for each step of solution
static const double TIME = 5;

double yk_check_uniform(YkCheck *check, double low, double high)
{
    return low + (high - low) * yk_mix_unit(&check->seed);
}

bool yk_check_solve(YkCheck *check)
{
    if (!yk_ring_spend(check->d->ring, SOLVE * check->d->mech->step_count)) return false;
    YkStatus status = check->dynamics ? yk_dynamics_solve(check->dynamics, check->state, YK_METHOD_REDUCED)
                                      : yk_state_solve(check->state);
    return status >= 0 && status != YK_CHANGE_POINT && yk_state_has_rates(check->state);
}

// Returns the smallest transmission angle of the dyads: at 0 two configurations meet.
static double margin_of(const YkCheck *check)
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

static YkMotion random_input(YkCheck *check, const YkCheckPoses *poses, size_t input)
{
    const YkDerivation *d = check->d;
    int32_t c = d->mech->inputs[input];
    bool is_distance = d->coordinates[c].is_distance;
    YkMotion from = yk_state_input(check->start, input);
    if (d->coordinates[c].is_held) return (YkMotion){.position = from.position};
    double size = is_distance ? d->mech->size : 1,
           turn = poses->is_of_segment ? 2 * YK_PI : YK_PI, // all segments of a motion program
        reach = is_distance ? 0.5 * fabs(from.position) + 0.1 * size : turn;
    YkMotion pose; // one draw a statement: within an expression C leaves their order open
    pose.position = from.position + yk_check_uniform(check, -reach, reach);
    pose.velocity = size * yk_check_uniform(check, 0.3, 2);
    pose.acceleration = size * yk_check_uniform(check, -2, 2);
    return pose;
}

// Sets any time, since loads may depend on it; inputs are set afterwards.
static void set_any_time(YkCheck *check)
{
    if (yk_state_set_time(check->state, yk_check_uniform(check, 0, TIME), NULL) >= 0) return;
    yk_state_set_time(check->state, yk_state_time(check->start), NULL);
}

// Moves from the start towards random inputs in small steps, but not close to another configuration: with special
// dimensions (a parallelogram) one configuration may obey what another does not.
static bool move_to_random_pose(YkCheck *check, YkCheckPoses *poses)
{
    const YkMechanism *mech = check->d->mech;
    YkMotion *target = poses->target;
    double reached = 0, least = fmin(0.1, 0.5 * poses->start_margin);
    for (size_t i = 0; i < mech->input_count; i++) target[i] = random_input(check, poses, i);
    yk_state_copy(check->state, check->start);
    set_any_time(check);
    int steps = mech->block_count > 0 || mech->relation_count > 0 ? STEPS : 1; // a tree can go anywhere in one step
    for (int step = 1; step <= steps; step++) {
        go(check, target, (double)step / steps);
        if (!yk_ring_spend(check->d->ring, SOLVE * mech->step_count)) return false;
        if (yk_state_solve(check->state) < 0 || margin_of(check) < least) break;
        yk_state_refer(check->state); // angles continue from here, over any number of turns
        reached = (double)step / steps;
    }
    go(check, target, reached);
    return yk_check_solve(check);
}

// --- Values

// Reading an equation adds symbols: its own constants, angles and roots, and those of the slips that are looked for.
static bool make_room(YkCheck *check)
{
    size_t count = yk_ring_symbol_count(check->d->ring), room = count + 64;
    if (count <= check->value_count) return true;
    double *values = realloc(check->values, room * sizeof *values);
    if (values) check->values = values;
    double *elsewhere = values ? realloc(check->elsewhere, room * sizeof *elsewhere) : NULL;
    if (elsewhere) check->elsewhere = elsewhere;
    check->failed |= !elsewhere;
    if (!elsewhere) return false;
    check->value_count = room;
    return true;
}

bool yk_check_take_values(YkCheck *check, const YkCheckPose *pose)
{
    if (!make_room(check)) return false;
    memcpy(check->values, pose->values, pose->symbols * sizeof *check->values);
    return true;
}

void yk_check_fill_values(YkCheck *check)
{
    if (make_room(check)) yk_derive_values(check->d, check->state, check->dynamics, check->values);
}

// Forces that are only rounding - a moment that is 0 - are measured against the others.
static void disturb_forces(YkCheck *check, double *values)
{
    const YkDerivation *d = check->d;
    double most = 0;
    for (size_t k = 0; k < d->unknown_count; k++)
        if (isfinite(values[d->unknowns[k]])) most = fmax(most, fabs(values[d->unknowns[k]]));
    for (size_t k = 0; k < d->unknown_count; k++) values[d->unknowns[k]] += most * yk_check_uniform(check, 0.2, 1);
}

void yk_check_disturb(YkCheck *check, double *values)
{
    const YkDerivation *d = check->d;
    for (size_t k = 0; k < d->coordinate_count; k++) {
        const YkDeriveCoordinate *c = &d->coordinates[k];
        double size = c->is_distance ? d->mech->size : 1;
        values[c->position] += size * yk_check_uniform(check, 0.2, 1);
        values[c->rate] += size * yk_check_uniform(check, 0.2, 1);
        values[c->acceleration] += size * yk_check_uniform(check, 0.2, 1);
    }
    for (size_t k = 0; k < d->tie_count; k++) // laws: in a dwell their slopes are only rounding
        for (int32_t order = 0; d->ties[k].function >= 0 && order < YK_TIE_ORDERS; order++)
            values[d->ties[k].function + order] += d->mech->size * yk_check_uniform(check, 0.2, 1);
    for (size_t b = 0; b < d->model->body_count; b++)
        if (d->bodies[b].angle >= 0) values[d->bodies[b].angle] += yk_check_uniform(check, 0.2, 1);
    disturb_forces(check, values);
    yk_ring_complete(d->ring, values);
}

// --- Segments of motion programs

// Motion programs are printed for their first period.
static bool is_in_first_period(const YkCheck *check, const double *values)
{
    for (size_t k = 0; k < check->d->tie_count; k++) {
        const YkDeriveRelation *tie = &check->d->ties[k];
        if (tie->function < 0) continue;
        YkLawRange range = yk_law_range(tie->law);
        double x = values[tie->variable];
        if (range.period > 0 && !(x >= range.from && x <= range.from + range.period)) return false;
    }
    return true;
}

bool yk_check_is_within(const YkCheck *check, const double *values)
{
    if (check->within_count > 0 && !is_in_first_period(check, values)) return false;
    for (size_t k = 0; k < check->within_count; k++) {
        double part = yk_ring_value(check->d->ring, check->within[k], values).x;
        if (!(part >= 0 && part <= 1)) return false;
    }
    return true;
}

// --- Poses that are kept

static void free_pose(YkCheckPose *pose)
{
    if (!pose) return;
    yk_state_free(pose->state);
    free(pose->values);
    free(pose->elsewhere);
    free(pose);
}

void yk_check_free_poses(YkCheckPoses *poses)
{
    for (size_t k = 0; k < poses->count; k++) free_pose(poses->pose[k]);
    yk_state_free(poses->work);
    free(poses->target);
    *poses = (YkCheckPoses){0};
}

// Fills in the values of the working state, as it was last solved, for all present symbols.
static bool fill(YkCheck *check, const YkCheckPoses *poses, YkCheckPose *pose)
{
    size_t count = yk_ring_symbol_count(check->d->ring);
    double *values = malloc((count + 1) * sizeof *values), *elsewhere = malloc((count + 1) * sizeof *elsewhere);
    if (values && elsewhere) {
        uint64_t seed = check->seed;
        yk_derive_values(check->d, poses->work, check->dynamics, values);
        memcpy(elsewhere, values, count * sizeof *elsewhere);
        check->seed = pose->seed;
        yk_check_disturb(check, elsewhere);
        pose->behind = check->seed;
        check->seed = seed;
        free(pose->values);
        free(pose->elsewhere);
        pose->values = values, pose->elsewhere = elsewhere, pose->symbols = count;
        return true;
    }
    free(values);
    free(elsewhere);
    check->failed = true;
    return false;
}

// Moves the working state to the next pose; the first one is the start.
static bool reach(YkCheck *check, YkCheckPoses *poses, size_t index)
{
    YkState *own = check->state;
    uint64_t seed = check->seed;
    check->state = poses->work, check->seed = poses->seed;
    if (index == 0) yk_state_copy(poses->work, check->start);
    if (index == 0) poses->start_margin = margin_of(check);
    bool is_reached = index == 0 ? yk_check_solve(check) : move_to_random_pose(check, poses);
    poses->seed = check->seed;
    check->state = own, check->seed = seed;
    return is_reached;
}

static void try_pose(YkCheck *check, YkCheckPoses *poses)
{
    if (!reach(check, poses, poses->tried++)) return;
    YkCheckPose *pose = yk_derive_scratch(check->d, 1, sizeof *pose);
    bool is_kept = pose != NULL;
    if (pose) {
        *pose = (YkCheckPose){.state = yk_state_new(check->d->mech), .seed = poses->seed};
        is_kept = pose->state && yk_state_copy(pose->state, poses->work) >= 0 && fill(check, poses, pose);
    }
    check->failed |= !is_kept;
    is_kept = is_kept && (!poses->is_of_segment || yk_check_is_within(check, pose->values));
    if (is_kept) {
        poses->pose[poses->count++] = pose;
        poses->seed = pose->behind;
    } else {
        free_pose(pose);
    }
}

// Renews a pose when equations have added symbols since it was made.
static void renew(YkCheck *check, YkCheckPoses *poses, YkCheckPose *pose)
{
    YkState *own = check->state;
    check->state = poses->work;
    yk_state_copy(poses->work, pose->state);
    if (yk_check_solve(check)) fill(check, poses, pose);
    check->state = own;
}

static bool prepare(YkCheck *check, YkCheckPoses *poses)
{
    if (!poses->work) poses->work = yk_state_new(check->d->mech);
    if (!poses->target)
        poses->target = yk_derive_scratch(check->d, check->d->mech->input_count + 1, sizeof *poses->target);
    check->failed |= !poses->work || !poses->target;
    return poses->work && poses->target;
}

// In a short segment few poses are found by chance.
static size_t tries_for(const YkCheckPoses *poses, size_t most)
{
    return (poses->is_of_segment ? TRIES_IN_SEGMENT : YK_CHECK_TRIES_A_POSE) * most;
}

const YkCheckPose *yk_check_pose(YkCheck *check, YkCheckPoses *poses, size_t index, size_t most)
{
    if (index >= sizeof poses->pose / sizeof *poses->pose || !prepare(check, poses)) return NULL;
    while (poses->count <= index && poses->tried < tries_for(poses, most)) try_pose(check, poses);
    if (index >= poses->count) return NULL;
    YkCheckPose *pose = poses->pose[index];
    if (pose->symbols != yk_ring_symbol_count(check->d->ring)) renew(check, poses, pose);
    return pose->symbols == yk_ring_symbol_count(check->d->ring) ? pose : NULL;
}
