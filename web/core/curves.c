// Curves over a coordinate or time, and traces of points, from the present assembly; the pose stays where it is.
#include <stdlib.h>
#include <string.h>
#include "core.h"
#include "exports.h"

enum { STEPS_MAX = 100000, CHANNELS_MAX = 256 };

typedef struct Curves {
    YkProblems *problems;
    YkState *state; // moves; its mechanism has the swept coordinate as an input
    YkMechanism *own;
    YkDynamics *dynamics;
    YkSweepOptions options;
    YkChannel channels[CHANNELS_MAX];
    size_t channel_count;
    // a trace
    size_t body;
    double place[2], *points;
    size_t point_count;
} Curves;

static bool is_time(const char *over)
{
    return strcmp(over, "t") == 0;
}

// Makes the moving state: of the machine, with the swept coordinate as an input.
static YkStatus make_state(Curves *c, const char *over)
{
    const YkMechanism *mech = yk_core.mech;
    size_t k = is_time(over) ? YK_NOT_FOUND : yk_coordinate_find(mech, over);
    bool is_input = is_time(over) || (k != YK_NOT_FOUND && yk_coordinate_info(mech, k).input >= 0);
    if (!is_input) {
        YkCompileOptions options = yk_default_compile_options();
        options.inputs = &over;
        options.input_count = 1;
        c->own = yk_mechanism_compile(yk_core.model, &options, c->problems);
        if (!c->own) return YK_BAD_ARGUMENT;
        mech = c->own;
    }
    c->state = yk_state_new(mech);
    if (!c->state) return YK_NO_MEMORY;
    if (c->own) return yk_state_adopt(c->state, yk_core.state);
    return yk_state_copy(c->state, yk_core.state);
}

static YkStatus go_to_start(Curves *c)
{
    if (c->options.coordinate < 0) {
        YkState *start = yk_core.is_scheduled ? NULL : yk_core.start; // the drives' motion begins there
        if (start && !c->own) yk_state_copy(c->state, start);
        return yk_state_move_time(c->state, c->options.from, NULL, NULL, c->problems);
    }
    const YkMechanism *mech = yk_state_mechanism(c->state);
    size_t count = yk_input_count(mech), input = (size_t)yk_coordinate_info(mech, (size_t)c->options.coordinate).input;
    YkMotion *goal = calloc(count + 1, sizeof *goal);
    if (!goal) return YK_NO_MEMORY;
    for (size_t i = 0; i < count; i++) goal[i] = yk_state_input(c->state, i);
    goal[input].position = c->options.from;
    YkStatus status = yk_state_move_to(c->state, goal, NULL, NULL);
    free(goal);
    return status;
}

static YkStatus read_channels(Curves *c, const char *names, const char *end)
{
    bool needs_forces = false;
    const YkMechanism *mech = yk_state_mechanism(c->state);
    for (; names < end && c->channel_count < CHANNELS_MAX; names += strlen(names) + 1) {
        YkChannel *channel = &c->channels[c->channel_count++];
        if (yk_channel_parse(mech, names, channel, c->problems) != YK_OK) return YK_BAD_ARGUMENT;
        needs_forces |= yk_channel_needs_forces(*channel);
    }
    if (!needs_forces) return YK_OK;
    c->dynamics = yk_dynamics_new(mech, c->problems);
    if (!c->dynamics) return YK_BAD_ARGUMENT;
    for (size_t i = 0; i < yk_input_count(mech); i++) yk_dynamics_prescribe(c->dynamics, i, true);
    c->options.dynamics = c->dynamics;
    return YK_OK;
}

// Begins with the name in the input: the state stands at `from`. Channels follow the name.
static YkStatus begin(Curves *c, double from, double to, size_t steps)
{
    const char *over = yk_text_get(&yk_core.input), *end = over + yk_core.input.length;
    c->problems = yk_problems_new();
    if (!c->problems) return YK_NO_MEMORY;
    if (!yk_core.state || !yk_state_has_pose(yk_core.state) || steps < 1 || steps > STEPS_MAX) return YK_BAD_ARGUMENT;
    YkStatus status = make_state(c, over);
    if (status < 0) return status;
    c->options = yk_default_sweep_options();
    c->options.coordinate = is_time(over) ? -1 : (int)yk_coordinate_find(yk_state_mechanism(c->state), over);
    c->options.from = from;
    c->options.to = to;
    c->options.steps = steps;
    const char *names = over + strlen(over) + 1;
    status = names < end ? read_channels(c, names, end) : YK_OK;
    return status < 0 ? status : go_to_start(c);
}

static void end(Curves *c)
{
    yk_dynamics_free(c->dynamics);
    yk_state_free(c->state);
    yk_mechanism_free(c->own);
    yk_problems_free(c->problems);
    free(c->points);
}

// Says why there is no curve, or not all of it.
static int word(const Curves *c, YkStatus status)
{
    yk_text_clear(&yk_core.text);
    yk_text_clear(&yk_core.message);
    if (c->problems && yk_problems_count(c->problems) > 0)
        yk_text_puts(&yk_core.message, yk_problems_get(c->problems, 0)->message);
    else if (c->state && status != YK_OK)
        yk_text_puts(&yk_core.message, yk_state_report(c->state)->message);
    return status;
}

// Writes rows: the swept value of each, then each channel's values row by row.
static YkStatus write_rows(const Curves *c, const YkSweep *sweep)
{
    size_t rows = yk_sweep_row_count(sweep);
    double *numbers = yk_core_room(rows * (1 + c->channel_count));
    if (!numbers) return YK_NO_MEMORY;
    for (size_t r = 0; r < rows; r++) {
        numbers[r] = yk_sweep_at(sweep, r);
        for (size_t k = 0; k < c->channel_count; k++) numbers[(1 + k) * rows + r] = yk_sweep_value(sweep, r, k);
    }
    return yk_sweep_status(sweep);
}

// Sweeps `over` (a coordinate, or t) as the command does: in the input, its name and those of the channels, each behind
// a NUL. The numbers are the swept values and then those of each channel; a row without a value is NaN.
YK_DOOR(ys_curves) int ys_curves(double from, double to, size_t steps)
{
    Curves c = {0};
    yk_core.number_count = 0;
    YkStatus status = begin(&c, from, to, steps);
    YkSweep *sweep = status >= 0 ? yk_sweep_run(c.state, &c.options, c.channels, c.channel_count, c.problems) : NULL;
    if (status >= 0) status = sweep ? write_rows(&c, sweep) : YK_NO_MEMORY;
    int told = word(&c, status);
    yk_sweep_free(sweep);
    end(&c);
    return told;
}

static void note_place(void *context, const YkState *state)
{
    Curves *c = context;
    YkDrawing *drawing = yk_core.drawing;
    if (c->point_count > c->options.steps || !yk_drawing_place(drawing, state, drawing->placed)) return;
    YkVec at = yk_frame_apply(drawing->placed[c->body], yk_vec(c->place[0], c->place[1]));
    c->points[2 * c->point_count] = at.x;
    c->points[2 * c->point_count + 1] = at.y;
    c->point_count++;
}

// Traces a point of a body, in its axes: the numbers are x and y of every row.
YK_DOOR(ys_trace) int ys_trace(size_t body, double x, double y, double from, double to, size_t steps)
{
    Curves c = {.body = body, .place = {x, y}};
    yk_core.number_count = 0;
    YkStatus status = begin(&c, from, to, steps);
    if (status >= 0 && (!yk_core.drawing || body >= yk_model_body_count(yk_core.model))) status = YK_BAD_ARGUMENT;
    c.points = calloc(2 * steps + 2, sizeof *c.points);
    c.options.visit = note_place;
    c.options.context = &c;
    YkSweep *sweep = status >= 0 && c.points ? yk_sweep_run(c.state, &c.options, NULL, 0, c.problems) : NULL;
    double *numbers = sweep ? yk_core_room(2 * c.point_count) : NULL;
    if (numbers) memcpy(numbers, c.points, 2 * c.point_count * sizeof *numbers);
    if (status >= 0) status = numbers ? yk_sweep_status(sweep) : YK_NO_MEMORY;
    int told = word(&c, status);
    yk_sweep_free(sweep);
    end(&c);
    return told;
}
