// Tests an equation as the drives move the machine. The time advances in small steps, so that angles count turns.
#include <math.h>
#include "prove/check_inside.h"
#include "solve/state.h"

enum { STEPS = 24, TIMES = 24, SOLVE = 300 };  // SOLVE: work for each step of solution
static const double LONGEST = 10, TRAVEL = 12; // s; rad or sizes of the machine

static bool is_driven(const YkCheck *check, size_t input)
{
    const YkDeriveCoordinate *c = &check->d->coordinates[check->d->mech->inputs[input]];
    return c->drive != YK_NONE && !c->is_held;
}

bool yk_check_has_drives(const YkCheck *check)
{
    for (size_t i = 0; i < check->d->mech->input_count; i++)
        if (is_driven(check, i)) return true;
    return false;
}

// Returns a duration in which fast drives do not make many turns between two times.
static double duration(const YkCheck *check)
{
    double longest = LONGEST;
    for (size_t i = 0; i < check->d->mech->input_count; i++) {
        bool is_distance = check->d->coordinates[check->d->mech->inputs[i]].is_distance;
        double speed = fabs(yk_state_input(check->state, i).velocity) / (is_distance ? check->d->mech->size : 1);
        if (is_driven(check, i)) longest = fmin(longest, TRAVEL / speed);
    }
    return longest;
}

// Inputs without a drive stay where they are, with any rate.
static void release(YkCheck *check)
{
    for (size_t i = 0; i < check->d->mech->input_count; i++) {
        const YkDeriveCoordinate *c = &check->d->coordinates[check->d->mech->inputs[i]];
        double size = c->is_distance ? check->d->mech->size : 1;
        YkMotion motion = yk_state_input(check->state, i);
        if (is_driven(check, i) || c->is_held) continue;
        motion.velocity = size * yk_check_uniform(check, 0.3, 2);
        motion.acceleration = size * yk_check_uniform(check, -2, 2);
        yk_state_set_input(check->state, i, motion);
    }
}

// Advances to this time. Returns false if the drives lead no further.
static bool go_on(YkCheck *check, double from, double to)
{
    for (int step = 1; step <= STEPS; step++) {
        if (yk_state_set_time(check->state, from + (to - from) * step / STEPS, NULL) < 0) return false;
        if (!yk_ring_spend(check->d->ring, SOLVE * check->d->mech->step_count)) return false;
        if (yk_state_solve(check->state) < 0) return false;
        yk_state_refer(check->state);
    }
    release(check);
    return true;
}

bool yk_check_differs_in_drive(YkCheck *check, size_t *times)
{
    double start = yk_state_time(check->start), now = start;
    yk_state_copy(check->state, check->start);
    if (yk_state_set_time(check->state, start, NULL) < 0 || yk_state_solve(check->state) < 0) return false;
    double step = duration(check) / TIMES;
    for (int k = 0; k < TIMES; k++) {
        double next = k == 0 ? start : now + step * yk_check_uniform(check, 0.1, 1);
        if (k > 0 && !go_on(check, now, next)) {
            step /= 4; // a limit is near: shorter steps up to it
            yk_state_copy(check->state, check->start);
            if (!go_on(check, start, now)) return false;
            continue;
        }
        now = next;
        YkCheckOutcome outcome = yk_check_solve(check) ? yk_check_judge(check) : YK_CHECK_NO_NUMBER;
        *times += outcome != YK_CHECK_NO_NUMBER;
        if (outcome == YK_CHECK_DIFFERENT) return true;
    }
    return false;
}
