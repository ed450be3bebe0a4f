// Moves the machine: to values of its inputs, in time, by the hand; and to its other assemblies.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "core.h"
#include "exports.h"

const YkState *yk_core_shown(void)
{
    const YkState *simulated = yk_core_simulated(NULL);
    return simulated ? simulated : yk_core.state;
}

static void write_numbers(const YkState *state, double *numbers)
{
    size_t bodies = yk_model_body_count(yk_core.model), coordinates = yk_coordinate_count(yk_core.mech);
    const YkDrawing *drawing = yk_core.drawing;
    // yk_drawing_parts placed them, and told all angles at once: one by one each costs as many steps as it has
    // ancestors
    const YkFrame *frames = yk_drawing_frames(drawing, drawing->pose_count - 2);
    for (size_t b = 0; b < bodies; b++) {
        numbers[3 * b] = frames[b].origin.x;
        numbers[3 * b + 1] = frames[b].origin.y;
        numbers[3 * b + 2] = drawing->motions[b].position + yk_drawing_follower_turn(drawing, b);
    }
    for (size_t k = 0; k < coordinates; k++) numbers[3 * bodies + k] = yk_state_coordinate(state, k).position;
}

int yk_core_tell(const YkState *state, YkStatus status, const char *message)
{
    yk_text_clear(&yk_core.text);
    yk_text_clear(&yk_core.message);
    yk_core.number_count = 0;
    if (message)
        yk_text_puts(&yk_core.message, message);
    else if (state && status != YK_OK)
        yk_text_puts(&yk_core.message, yk_state_report(state)->message);
    if (!yk_core.drawing || !state || !yk_state_has_pose(state)) return status;
    const char *parts = yk_drawing_parts(yk_core.drawing, state);
    size_t count = 3 * yk_model_body_count(yk_core.model) + yk_coordinate_count(yk_core.mech);
    double *numbers = yk_core_room(count);
    if (!parts || !numbers) return YK_NO_MEMORY;
    yk_text_puts(&yk_core.text, parts);
    write_numbers(state, numbers);
    return yk_core.text.failed ? YK_NO_MEMORY : status;
}

// Writes the pose that is shown.
YK_DOOR(ys_pose) int ys_pose(void)
{
    const YkState *state = yk_core.mech ? yk_core_shown() : NULL;
    if (!state) return yk_core_tell(NULL, YK_BAD_ARGUMENT, "there is no machine");
    return yk_core_tell(state, yk_state_report(state)->status, NULL);
}

YK_DOOR(ys_time) double ys_time(void)
{
    double time;
    if (yk_core_simulated(&time)) return time;
    return yk_core.state ? yk_state_time(yk_core.state) : 0;
}

static bool is_follower(const YkModel *model, size_t body)
{
    for (size_t k = 0; k < model->cam_count; k++)
        if ((size_t)model->cams[k].follower == body) return true;
    return false;
}

YkVec yk_core_in_model(size_t body, YkVec drawn)
{
    YkDrawing *drawing = yk_core.drawing;
    const YkState *state = yk_core.mech ? yk_core_shown() : NULL;
    if (!drawing || !state || !yk_state_has_pose(state) || !is_follower(yk_core.model, body)) return drawn;
    if (!yk_drawing_place(drawing, state, drawing->placed)) return drawn;
    YkFrame there = drawing->placed[body];
    YkVec own = yk_mul(yk_conj(there.axis), yk_sub(drawn, there.origin));
    drawing->keeps_followers = true;
    bool is_placed = yk_drawing_place(drawing, state, drawing->placed);
    drawing->keeps_followers = false;
    return is_placed ? yk_frame_apply(drawing->placed[body], own) : drawn;
}

// --- inputs

static bool is_input(const char *name)
{
    size_t k = yk_coordinate_find(yk_core.mech, name);
    return k != YK_NOT_FOUND && yk_coordinate_info(yk_core.mech, k).input >= 0;
}

// Puts the machine with other inputs in the place of the present one.
static YkStatus adopt(YkMechanism *other)
{
    YkState *start = yk_state_new(other), *state = yk_state_new(other);
    YkStatus status = start && state ? yk_state_adopt(state, yk_core.state) : YK_NO_MEMORY;
    if (status >= 0) (void)yk_state_adopt(start, yk_core.start);
    if (status < 0) {
        yk_state_free(start);
        yk_state_free(state);
        yk_mechanism_free(other);
        return status;
    }
    yk_core_settle();
    yk_state_free(yk_core.start);
    yk_state_free(yk_core.state);
    yk_mechanism_free(yk_core.other);
    yk_core.start = start;
    yk_core.state = state;
    yk_core.mech = yk_core.other = other;
    return YK_OK;
}

YkStatus yk_core_use_inputs(const char *const *names, size_t count, YkProblems *problems)
{
    YkCompileOptions options = yk_default_compile_options();
    size_t k = 0;
    while (k < count && is_input(names[k])) k++;
    if (k == count) return YK_OK;
    options.inputs = names;
    options.input_count = count;
    YkMechanism *other = yk_mechanism_compile(yk_core.model, &options, problems);
    return other ? adopt(other) : YK_BAD_ARGUMENT;
}

// Reads `count` names, one behind the other with a NUL between them. NULL if there are not that many.
static const char **read_names(size_t count)
{
    const char **names = calloc(count + 1, sizeof *names), *at = yk_text_get(&yk_core.input);
    const char *end = at + yk_core.input.length;
    for (size_t k = 0; names && k < count; k++) {
        if (at > end) {
            free((void *)names);
            return NULL;
        }
        names[k] = at;
        at += strlen(at) + 1;
    }
    return names;
}

static int move_inputs(const char *const *names, const double *values, size_t count)
{
    YkProblems *problems = yk_problems_new();
    YkStatus status = problems ? yk_core_use_inputs(names, count, problems) : YK_NO_MEMORY;
    const char *message = NULL;
    YkMotion *goal = calloc(yk_input_count(yk_core.mech) + 1, sizeof *goal);
    if (status == YK_BAD_ARGUMENT && yk_problems_count(problems) > 0) message = yk_problems_get(problems, 0)->message;
    if (status >= 0 && goal) {
        for (size_t i = 0; i < yk_input_count(yk_core.mech); i++) goal[i] = yk_state_input(yk_core.state, i);
        for (size_t k = 0; k < count; k++) {
            size_t coordinate = yk_coordinate_find(yk_core.mech, names[k]);
            goal[yk_coordinate_info(yk_core.mech, coordinate).input].position = values[k];
        }
        status = yk_state_move_to(yk_core.state, goal, NULL, NULL);
        yk_core.is_scheduled = false;
    }
    free(goal);
    int told = yk_core_tell(yk_core.state, goal ? status : YK_NO_MEMORY, message);
    yk_problems_free(problems);
    return told;
}

// Moves there: `count` names in the input, their values among the numbers.
YK_DOOR(ys_at) int ys_at(size_t count)
{
    if (!yk_core.state) return ys_pose();
    const char **names = yk_core.number_count >= count ? read_names(count) : NULL;
    double *values = calloc(count + 1, sizeof *values);
    int status = YK_BAD_ARGUMENT;
    yk_core_settle();
    if (names && values) {
        memcpy(values, yk_core.numbers, count * sizeof *values);
        status = move_inputs(names, values, count);
    } else {
        yk_core_tell(yk_core.state, YK_BAD_ARGUMENT, "names and values do not match");
    }
    free((void *)names);
    free(values);
    return status;
}

// Returns the inputs to what the drives say at a time, on a straight way.
static YkStatus go_back_to_drives(double time)
{
    YkState *there = yk_state_new(yk_core.mech);
    size_t count = yk_input_count(yk_core.mech);
    YkMotion *goal = calloc(count + 1, sizeof *goal);
    YkStatus status = there && goal ? yk_state_set_time(there, time, NULL) : YK_NO_MEMORY;
    for (size_t i = 0; status >= 0 && i < count; i++) {
        bool has_drive = yk_coordinate_info(yk_core.mech, yk_input_coordinate(yk_core.mech, i)).has_drive;
        goal[i] = yk_state_input(has_drive ? there : yk_core.state, i);
    }
    if (status >= 0) status = yk_state_move_to(yk_core.state, goal, NULL, NULL);
    free(goal);
    yk_state_free(there);
    return status;
}

YK_DOOR(ys_move_time) int ys_move_time(double time)
{
    if (!yk_core.state) return ys_pose();
    yk_core_settle();
    if (!isfinite(time)) return yk_core_tell(yk_core.state, YK_BAD_ARGUMENT, "this is not a time");
    YkStatus status = yk_core.is_scheduled ? YK_OK : go_back_to_drives(yk_state_time(yk_core.state));
    if (status >= 0) {
        yk_core.is_scheduled = true;
        status = yk_state_move_time(yk_core.state, time, NULL, NULL, NULL);
    }
    return yk_core_tell(yk_core.state, status, NULL);
}

// --- the hand

static void word_end(const YkDragged *dragged, YkText *words)
{
    if (dragged->end == YK_DRAG_LIMIT && dragged->block >= 0)
        yk_text_format(words, "beyond, joint %q does not close",
                       yk_block_info(yk_core.mech, (size_t)dragged->block).label);
    else if (dragged->end == YK_DRAG_STOP && dragged->coordinate >= 0)
        yk_text_format(words, "the stop of %q is in the way",
                       yk_coordinate_info(yk_core.mech, (size_t)dragged->coordinate).name);
}

static bool holds(size_t body, double x, double y)
{
    return yk_core.drag && yk_core.drag_body == body && yk_core.drag_place[0] == x && yk_core.drag_place[1] == y;
}

// Drags a point of a body, in its axes, towards a place in the world.
YK_DOOR(ys_drag) int ys_drag(size_t body, double x, double y, double to_x, double to_y)
{
    YkDragged dragged;
    if (!yk_core.state) return ys_pose();
    if (!holds(body, x, y)) {
        yk_core_settle();
        yk_core.drag_body = body;
        yk_core.drag_place[0] = x;
        yk_core.drag_place[1] = y;
        yk_core.drag = yk_drag_new(yk_core.state, body, yk_core.drag_place, NULL);
        if (!yk_core.drag) return yk_core_tell(yk_core.state, YK_BAD_ARGUMENT, "there is no such body");
    }
    YkVec to = yk_core_in_model(body, yk_vec(to_x, to_y));
    const double target[2] = {to.x, to.y};
    YkText words = {0};
    YkStatus status = yk_state_drag(yk_core.drag, target, &dragged);
    yk_core.is_scheduled = false;
    if (status >= 0) word_end(&dragged, &words);
    int told = yk_core_tell(yk_core.state, status, status >= 0 ? yk_text_get(&words) : NULL);
    yk_text_free(&words);
    return told;
}
