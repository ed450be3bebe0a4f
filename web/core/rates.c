// Velocities and accelerations of the pose, for arrows; and whether a drive turns evenly, for the length of a turn.
#include <math.h>
#include "core.h"
#include "exports.h"

// Writes vx, vy, ax, ay of every point of a body.
static double *write_points(const YkState *state, const YkBody *body, double *numbers)
{
    for (int32_t p = 0; p < body->point_count; p++, numbers += 4) {
        YkPointMotion motion = yk_state_point(state, (size_t)(body->first_point + p));
        for (int axis = 0; axis < 2; axis++) {
            numbers[axis] = motion.velocity[axis];
            numbers[2 + axis] = motion.acceleration[axis];
        }
    }
    return numbers;
}

// Writes the numbers: body by body vx, vy, ax, ay of each of its points in the ground's axes, then the rate and the
// acceleration of each coordinate; SI. Returns a status; there are no numbers where there is no pose, or where it has
// no velocities (at a dead point).
YK_DOOR(ys_rates) int ys_rates(void)
{
    const YkState *state = yk_core.mech ? yk_core_shown() : NULL;
    yk_core.number_count = 0;
    yk_text_clear(&yk_core.message);
    if (!state || !yk_state_has_pose(state)) return YK_BAD_ARGUMENT;
    if (!yk_state_has_rates(state)) return YK_SINGULAR;
    size_t coordinates = yk_coordinate_count(yk_core.mech), points = yk_model_point_count(yk_core.model);
    double *numbers = yk_core_room(4 * points + 2 * coordinates);
    if (!numbers) return YK_NO_MEMORY;
    for (size_t b = 0; b < yk_model_body_count(yk_core.model); b++)
        numbers = write_points(state, &yk_core.model->bodies[b], numbers);
    for (size_t k = 0; k < coordinates; k++, numbers += 2) {
        YkMotion motion = yk_state_coordinate(state, k);
        numbers[0] = motion.velocity;
        numbers[1] = motion.acceleration;
    }
    return yk_state_report(state)->status;
}

// Returns whether the drive of an input has the same rate at all of some times, whose ratios are no simple fractions.
static bool is_even(YkState *state, size_t input, YkMotion *first)
{
    static const double times[] = {0, 0.013, 0.0871, 0.377, 1.1};
    for (size_t k = 0; k < sizeof times / sizeof *times; k++) {
        if (yk_state_set_time(state, times[k], NULL) < 0) return false;
        YkMotion at = yk_state_input(state, input);
        if (k == 0) *first = at;
        double straight = first->position + first->velocity * times[k];
        if (at.velocity != first->velocity || fabs(at.position - straight) > 1e-9 * (1 + fabs(straight))) return false;
    }
    return true;
}

// Writes the numbers: where a driven coordinate stands at t = 0, and its rate, if its drive moves it evenly; none if
// not.
YK_DOOR(ys_turn) int ys_turn(size_t coordinate)
{
    yk_core.number_count = 0;
    yk_text_clear(&yk_core.message);
    if (!yk_core.state || coordinate >= yk_coordinate_count(yk_core.mech)) return YK_BAD_ARGUMENT;
    YkCoordinateInfo info = yk_coordinate_info(yk_core.mech, coordinate);
    YkMotion first = {0};
    if (info.input < 0 || !info.has_drive) return YK_OK;
    YkState *state = yk_state_new(yk_core.mech);
    double *numbers = state && is_even(state, (size_t)info.input, &first) ? yk_core_room(2) : NULL;
    if (numbers) {
        numbers[0] = first.position;
        numbers[1] = first.velocity;
    }
    yk_state_free(state);
    return state ? YK_OK : YK_NO_MEMORY;
}
