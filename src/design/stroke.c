// Finds the stroke of a machine whose input turns through: extreme positions and time ratio.
#include <yoke/design.h>
#include <stdbool.h>
#include "base/vec.h"
#include "solve/state.h"

enum { TURN = 360 }; // steps

// Returns whether an extreme found at `at` is the one found at `first`, a turn later.
static bool is_again(size_t found, double first, double at)
{
    return found > 0 && fabs(at - first - 2 * YK_PI) < 1e-6;
}

static YkStatus read_extremes(const YkSweep *sweep, YkStroke *stroke)
{
    size_t maxima = 0, minima = 0;
    for (size_t k = 0; k < yk_sweep_event_count(sweep); k++) {
        YkEvent e = yk_sweep_event(sweep, k);
        if (e.kind != YK_EVENT_EXTREME) continue;
        if (e.is_maximum && !is_again(maxima, stroke->high_at, e.at)) {
            maxima++;
            stroke->high = e.value;
            stroke->high_at = e.at;
        } else if (!e.is_maximum && !is_again(minima, stroke->low_at, e.at)) {
            minima++;
            stroke->low = e.value;
            stroke->low_at = e.at;
        }
    }
    return maxima == 1 && minima == 1 ? YK_OK : YK_BAD_ARGUMENT;
}

// Returns whether the second turn begins as the first did; a wheel that turns at another pace comes back elsewhere.
static bool comes_back(const YkSweep *sweep, const YkStroke *stroke)
{
    const double SAME = 1e-6; // of the stroke
    double off = 0;
    for (size_t k = 0; k < 2; k++)
        off = fmax(off, fabs(yk_sweep_value(sweep, TURN + k, 0) - yk_sweep_value(sweep, k, 0)));
    return off <= SAME * (stroke->high - stroke->low);
}

YkStatus yk_stroke(YkState *state, size_t input, YkChannel channel, YkStroke *stroke)
{
    const YkMechanism *mech = yk_state_mechanism(state);
    YkSweepOptions options = yk_default_sweep_options();
    if (input >= yk_input_count(mech) || yk_coordinate_info(mech, yk_input_coordinate(mech, input)).is_distance)
        return YK_BAD_ARGUMENT;
    options.coordinate = (int)yk_input_coordinate(mech, input);
    options.from = yk_state_input(state, input).position;
    // A degree more than a turn, so that an extreme at the very start is passed; what lies in the surplus counts once.
    options.to = options.from + (TURN + 1) * YK_PI / 180;
    options.steps = TURN + 1;
    YkState *probe = yk_state_new(mech);
    if (!probe) return YK_NO_MEMORY;
    yk_state_copy(probe, state);
    bool is_own = yk_state_begin(state);
    yk_state_lend(probe, state->pace);
    YkSweep *sweep = yk_sweep_run(probe, &options, &channel, 1, NULL);
    YkStatus status = sweep ? yk_sweep_status(sweep) : YK_NO_MEMORY;
    if (sweep && status >= 0) status = read_extremes(sweep, stroke);
    if (status == YK_OK && !comes_back(sweep, stroke)) status = YK_BAD_ARGUMENT;
    if (status == YK_OK) {
        double there = fabs(yk_nearest_turn(stroke->high_at - stroke->low_at, YK_PI)), back = 2 * YK_PI - there;
        stroke->ratio = there > back ? there / back : back / there;
    }
    yk_sweep_free(sweep);
    yk_state_free(probe);
    return yk_state_end(state, is_own, status);
}
