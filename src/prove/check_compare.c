// Compares both sides of an equation at poses of the numeric engine.
#include <math.h>
#include <string.h>
#include "prove/check_inside.h"

static const double EQUAL = 1e-9;

static double distance_of(YkCheck *check, const YkForm *zero, const double *values)
{
    return yk_norm(yk_form_value(check->d->ring, zero, values));
}

// Returns whether it is 0 up to rounding. Terms that are 0 on the machine get their size elsewhere.
static YkCheckOutcome judge(YkCheck *check, const YkForm *zero, const double *values, const double *elsewhere)
{
    double distance = distance_of(check, zero, values), size = yk_form_magnitude(check->d->ring, zero, values),
           other = distance_of(check, zero, elsewhere);
    if (!isfinite(distance) || !isfinite(size)) return YK_CHECK_NO_NUMBER;
    return distance > EQUAL * (isfinite(other) ? fmax(size, other) : size) ? YK_CHECK_DIFFERENT : YK_CHECK_SAME;
}

YkCheckOutcome yk_check_judge(YkCheck *check)
{
    yk_check_fill_values(check);
    if (check->failed || !yk_check_is_within(check, check->values)) return YK_CHECK_NO_NUMBER;
    memcpy(check->elsewhere, check->values, check->value_count * sizeof *check->values);
    yk_check_disturb(check, check->elsewhere);
    return judge(check, check->difference, check->values, check->elsewhere);
}

static void note_motion(YkCheck *check, const YkState *state)
{
    YkCheckSeen *seen = check->seen;
    if (seen->count == YK_CHECK_SEEN_MAX) return;
    size_t n = check->d->tree_count;
    double *row = seen->motion + 2 * n * seen->count++;
    for (size_t k = 0; k < n; k++) {
        YkMotion motion = yk_state_coordinate(state, k);
        row[k] = motion.position;
        row[n + k] = motion.velocity;
    }
}

bool yk_check_differs(YkCheck *check, size_t most, size_t *poses)
{
    const YkCheckPose *pose;
    for (size_t k = 0; *poses < most && (pose = yk_check_pose(check, check->poses, k, most)) != NULL; k++) {
        note_motion(check, pose->state);
        YkCheckOutcome outcome = judge(check, check->difference, pose->values, pose->elsewhere);
        *poses += outcome != YK_CHECK_NO_NUMBER;
        if (outcome != YK_CHECK_DIFFERENT) continue;
        yk_state_copy(check->state, pose->state);
        check->seed = pose->behind;
        return yk_check_take_values(check, pose);
    }
    return false;
}

bool yk_check_is_zero_at_poses(YkCheck *check, const YkForm *zero)
{
    size_t compared = 0;
    const YkCheckPose *pose;
    for (size_t k = 0; k < YK_CHECK_POSES && (pose = yk_check_pose(check, check->poses, k, YK_CHECK_POSES)); k++) {
        YkCheckOutcome outcome = judge(check, zero, pose->values, pose->elsewhere);
        if (outcome == YK_CHECK_DIFFERENT) return false;
        compared += outcome == YK_CHECK_SAME;
    }
    return compared >= YK_CHECK_POSES_MIN;
}
