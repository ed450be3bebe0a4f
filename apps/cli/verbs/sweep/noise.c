// Measures the rounding noise of every cell of a sweep. A value that looks like noise beside the machine's largest may
// be true: that of a body which takes no part in the large motion, or of a row far from the pose where rates grow
// without bound.
#include <float.h>
#include <math.h>
#include "elementary/elementary.h"
#include "verbs/sweep/sweep.h"

// Returns the least sine of a transmission angle: near a change point or a dead point it is small.
static double least_sine(const YkMechanism *mech, const YkState *state)
{
    double least = 1;
    for (size_t k = 0; k < yk_block_count(mech); k++)
        if (yk_block_info(mech, k).assur_class == 2) least = fmin(least, fabs(yk_sin(yk_state_transmission(state, k))));
    return least;
}

// Brings the state beside to the row's pose with every input moved by `step`, of itself or at least of a radian or the
// machine's size. A sweep over time moves the time too, by `step` of itself or at least of the whole range: where a
// drive turns back, its rate is 0 but for the rounding of the time. Returns whether it has all that the row has.
static bool go_beside(const YkSweepAnswer *answer, const YkState *state, double step, bool has_forces)
{
    const YkSession *session = answer->session;
    const YkMechanism *mech = session->mech;
    YkState *beside = answer->beside;
    yk_state_copy(beside, state);
    if (answer->over.coordinate < 0) {
        double time = yk_state_time(state), range = fabs(answer->over.to - answer->over.from);
        if (yk_state_set_time(beside, time + step * fmax(fabs(time), range), NULL) < 0) return false;
    }
    for (size_t i = 0; i < yk_input_count(mech); i++) {
        YkMotion motion = yk_state_input(beside, i);
        bool is_distance = yk_coordinate_info(mech, yk_input_coordinate(mech, i)).is_distance;
        motion.position += step * fmax(fabs(motion.position), is_distance ? yk_mechanism_size(mech) : 1);
        yk_state_set_input(beside, i, motion);
    }
    YkStatus status = yk_state_solve(beside);
    if (status < 0 || (yk_state_has_rates(state) && !yk_state_has_rates(beside))) return false;
    if (has_forces) status = yk_dynamics_solve(session->dynamics, beside, answer->method);
    return !has_forces || status == YK_OK || status == YK_REDUNDANT;
}

static void read_values(const YkSweepAnswer *answer, const YkState *state, double *values)
{
    for (size_t c = 0; c < answer->column_count; c++)
        values[c] = yk_column_value(answer->session, state, answer->columns[c].channel);
}

// A value is a smooth function of the inputs, and noise is not: raises each column's noise to what is left of it beside
// a straight line through two poses a hair off on one side, and to what the last place of the inputs changes.
static bool add_side(YkSweepAnswer *answer, const YkState *state, double step, bool has_forces)
{
    enum { SAFE = 8 };
    size_t count = answer->column_count;
    double *here = answer->values, *near = here + count, *far = near + count, *noise = far + count;
    for (int k = 1; k <= 2; k++) {
        if (!go_beside(answer, state, k * step, has_forces)) return false;
        read_values(answer, answer->beside, here + (size_t)k * count);
    }
    for (size_t c = 0; c < count; c++) {
        double off = here[c] - near[c], slope = (far[c] - near[c]) / step;
        noise[c] = fmax(noise[c], SAFE * fabs(off + slope * step) + 4 * fabs(slope) * DBL_EPSILON);
    }
    return true;
}

// Returns the part of a column's noise that is as smooth as a value, since it comes of rounded constants: the x of a
// guide at 90 degrees is its length times 6e-17.
static double smooth_noise(const YkSweepAnswer *answer, const YkState *state, size_t column, double usual)
{
    YkChannel across = answer->columns[column].channel;
    bool is_x = across.kind == YK_CHANNEL_POINT_X || across.kind == YK_CHANNEL_FORCE_X;
    bool is_y = across.kind == YK_CHANNEL_POINT_Y || across.kind == YK_CHANNEL_FORCE_Y;
    bool is_turn = across.quantity == YK_QUANTITY_ANGLE_RATE || across.quantity == YK_QUANTITY_ANGLE_ACCELERATION;
    if (!is_x && !is_y) return usual * (is_turn ? 1e-5 : 1e-2);
    across.kind = (YkChannelKind)((int)across.kind + (is_x ? 1 : -1));
    return 4 * DBL_EPSILON * yk_hypot(answer->values[column], yk_column_value(answer->session, state, across));
}

void yk_sweep_measure_noise(YkSweepAnswer *answer, const YkState *state, size_t row)
{
    YkSession *session = answer->session;
    size_t count = answer->column_count;
    YkNoise *noise = answer->noise + row * count;
    double sine = least_sine(session->mech, state), step = fmax(1e-5 * sine * sine, 64 * DBL_EPSILON),
           *measured = answer->values + 3 * count;
    bool is_measured = yk_input_count(session->mech) > 0;
    YkStatus status = session->dynamics ? yk_dynamics_report(session->dynamics)->status : YK_SINGULAR;
    bool has_forces = status == YK_OK || status == YK_REDUNDANT;
    answer->sines[row] = (float)sine;
    yk_scale_begin(session);
    yk_scale_add_pose(session, state);
    read_values(answer, state, answer->values);
    for (size_t c = 0; c < count; c++) yk_scale_add(session, answer->values[c], answer->columns[c].channel.quantity);
    session->scale.blur = 0;
    for (size_t c = 0; c < count; c++) {
        double usual = yk_scale_noise(session, answer->columns[c].channel.quantity);
        measured[c] = 0;
        noise[c] = (YkNoise){.usual = (float)usual, .measured = (float)smooth_noise(answer, state, c, usual)};
    }
    for (int k = 0; k < 4 && is_measured; k++, step *= -1.7) // at a limit, on one side alone
        is_measured = add_side(answer, state, step, has_forces) || add_side(answer, state, -step, has_forces);
    for (size_t c = 0; c < count; c++) {
        if (measured[c] == 0) measured[c] = 1e-2 * (double)noise[c].usual; // a constant may be noise wholly
        noise[c].measured = is_measured ? fmaxf(noise[c].measured, (float)measured[c]) : INFINITY;
    }
}
