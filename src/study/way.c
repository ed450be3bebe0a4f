// Follows the way of a design from its start through its poses. Lanes run along it, at most some degrees apart, as long
// as no branches can have met. If they can, and for machines that lanes cannot follow, the state moves pose by pose.
#include <string.h>
#include "study/study.h"

static const double STEP = 2 * YK_PI / 180, FINE = 2.5 * YK_PI / 180; // rad, or lengths over the size
static const double MEETING_MARGIN = 1e-10;                           // sin^2: within 1e-5 of a change point or a limit
static const double LANES_MAX = 1e5;                                  // of one stretch; moving may count whole turns

// Returns input 3 * i + k at a pose.
static double input_at(const YkWorker *w, size_t input, size_t pose)
{
    return w->inputs[input] ? w->inputs[input][pose] : w->home->input[input];
}

static double time_at(const YkWorker *w, size_t pose)
{
    return w->times ? w->times[pose] : w->home->time;
}

// --- by lanes

// Returns how many lanes it takes from the last lane to a pose.
static double steps_to(const YkWorker *w, size_t pose)
{
    double longest = 0;
    if (w->mech->block_count == 0) return 1; // without loops nothing can close otherwise
    for (size_t i = 0; i < w->mech->input_count; i++) {
        double way = fabs(input_at(w, 3 * i, pose) - w->end[3 * i]);
        if (!(way - way == 0)) return INFINITY;
        way /= yk_input_unit(w->mech, i);
        longest = way > longest ? way : longest;
    }
    double steps = longest <= FINE ? 1 : ceil(longest / STEP), least = w->way.lanes == 1 ? 2 : 1;
    return steps > least ? steps : least; // at least three lanes show what lies between them
}

typedef struct Answers { // of one call
    double *const *outputs;
    signed char *status;
    size_t count, done; // poses
} Answers;

// Returns the work of a lane, for the pace.
static size_t lane_work(const YkWorker *w)
{
    return 10 * (w->mech->step_count + w->study->channel_count + 1);
}

// Runs n of the lanes that were filled in. Returns false if not all of them are surely on the way.
static bool run_lanes(YkWorker *w, size_t from, size_t n, Answers *a)
{
    size_t inputs = 3 * w->mech->input_count, channels = w->study->channel_count;
    if (!yk_pace_spend(&w->pace, n * lane_work(w))) return false;
    for (size_t i = 0; i < inputs; i++) w->row[i] = w->lane + i * YK_STUDY_LANES + from;
    for (size_t c = 0; c < channels; c++) w->row_output[c] = w->lane_output + c * YK_STUDY_BLOCK;
    YkAlong along = {w->lane_is_pose + from, w->lane_time + from};
    size_t clear = n > 0 ? yk_batch_run_along(w->batch, w->row, w->row_output, NULL, along, n) : 0;
    for (size_t k = 0; k < clear; k++) {
        if (w->lane_pose[from + k] < 0) continue;
        size_t pose = (size_t)w->lane_pose[from + k];
        for (size_t c = 0; c < channels; c++) a->outputs[c][pose] = w->row_output[c][k];
        if (a->status) a->status[pose] = YK_OK;
        a->done = pose + 1;
    }
    for (size_t i = 0; clear > 0 && i < inputs; i++) w->last[i] = w->row[i][clear - 1];
    w->way.lanes += clear;
    return clear == n;
}

static bool run_put(YkWorker *w, size_t *put, Answers *a)
{
    size_t n = *put;
    *put = 0;
    return run_lanes(w, 0, n, a);
}

// Fills in lanes `first` to `last` of the `steps` from the last pose to the next one, which is the last lane of all.
static void put_lanes(YkWorker *w, size_t *put, size_t pose, double first, double last, double steps)
{
    size_t at = *put, n = (size_t)(last - first) + 1;
    bool is_there = last == steps;
    double time = time_at(w, pose);
    for (size_t i = 0; i < w->mech->input_count; i++) {
        double from = w->end[3 * i], to = input_at(w, 3 * i, pose), way = to - from;
        double *x = w->lane + 3 * i * YK_STUDY_LANES + at, *v = x + YK_STUDY_LANES, *a = v + YK_STUDY_LANES;
        double rate = input_at(w, 3 * i + 1, pose), accel = input_at(w, 3 * i + 2, pose);
        for (size_t k = 0; k < n; k++) {
            x[k] = from + (first + (double)k) / steps * way;
            v[k] = rate;
            a[k] = accel;
        }
        if (is_there) x[n - 1] = to;
    }
    for (size_t k = 0; k < n; k++) {
        w->lane_pose[at + k] = -1;
        w->lane_is_pose[at + k] = false;
        w->lane_time[at + k] = time;
    }
    if (is_there) w->lane_pose[at + n - 1] = (ptrdiff_t)pose;
    w->lane_is_pose[at + n - 1] = is_there;
    *put += n;
}

static bool is_there(const YkWorker *w, const double *from, size_t pose)
{
    for (size_t i = 0; i < w->mech->input_count; i++)
        if (from[3 * i] != input_at(w, 3 * i, pose)) return false;
    return true;
}

// Fills in the first lane, the start itself. Returns whether it is the first pose.
static bool put_start(YkWorker *w, size_t *put)
{
    bool is_pose = is_there(w, w->begun->valid_input, 0);
    memcpy(w->end, w->begun->valid_input, 3 * w->mech->input_count * sizeof *w->end);
    put_lanes(w, put, 0, is_pose ? 1 : 0, is_pose ? 1 : 0, 1);
    return is_pose;
}

static bool run_start(YkWorker *w, Answers *a)
{
    size_t put = 0;
    put_start(w, &put);
    yk_batch_begin(w->batch, w->begun);
    return run_put(w, &put, a);
}

static void end_at(YkWorker *w, size_t pose)
{
    for (size_t i = 0; i < 3 * w->mech->input_count; i++) w->end[i] = input_at(w, i, pose);
}

// Adds lanes up to a pose; they run when there is no room for more.
static bool add_lanes(YkWorker *w, size_t *put, size_t pose, double steps, Answers *a)
{
    for (double k = 1, last; k <= steps; k = last + 1) {
        double room = (double)(YK_STUDY_BLOCK - *put);
        last = steps - k < room ? steps : k + room - 1;
        put_lanes(w, put, pose, k, last, steps);
        if (*put == YK_STUDY_BLOCK && !run_put(w, put, a)) return false;
    }
    end_at(w, pose);
    return true;
}

bool yk_poses_are_fine(const YkMechanism *mech, const double *const *inputs, size_t from, size_t to)
{
    bool is_far = false;
    for (size_t i = 0; mech->block_count > 0 && i < mech->input_count; i++) {
        const double *x = inputs[3 * i];
        double most = FINE * yk_input_unit(mech, i);
        for (size_t k = from + 1; x && k < to; k++) is_far |= !(fabs(x[k] - x[k - 1]) <= most);
    }
    return !is_far;
}

// Returns whether all poses from `pose` on lie close together, and the first close to where the lanes end.
static bool is_fine(const YkWorker *w, size_t pose, size_t count)
{
    return !(steps_to(w, pose) > 1) && (w->is_fine || yk_poses_are_fine(w->mech, w->inputs, pose, count));
}

// Runs a slice of poses straight from the caller's arrays to the caller's arrays.
static bool run_slice(YkWorker *w, Answers *a)
{
    size_t pose = a->done, inputs = 3 * w->mech->input_count, count = a->count - pose;
    size_t most = YK_STUDY_BLOCK * (1 + YK_PACE_SLICE / 4 / (YK_STUDY_BLOCK * lane_work(w)));
    if (count > most) count = most;
    if (!yk_pace_spend(&w->pace, count * lane_work(w))) return false;
    for (size_t i = 0; i < inputs; i++) w->row[i] = w->inputs[i] ? w->inputs[i] + pose : NULL;
    for (size_t c = 0; c < w->study->channel_count; c++) w->row_output[c] = a->outputs[c] + pose;
    size_t clear = yk_batch_run_along(w->batch, w->row, w->row_output, a->status ? a->status + pose : NULL,
                                      (YkAlong){NULL, w->times ? w->times + pose : NULL}, count);
    a->done += clear;
    w->way.lanes += clear;
    if (clear > 0) end_at(w, a->done - 1);
    if (clear > 0) memcpy(w->last, w->end, inputs * sizeof *w->last);
    return clear == count;
}

static bool run_poses(YkWorker *w, Answers *a)
{
    while (a->done < a->count)
        if (!run_slice(w, a)) return false;
    return true;
}

// --- lanes that stay from design to design

// Returns whether the lanes of the last design lead from the start of this one.
static bool is_planned(const YkWorker *w)
{
    bool is_same = w->planned > 0;
    for (size_t i = 0; i < w->mech->input_count && is_same; i++)
        is_same = w->planned_from[i] == w->begun->valid_input[3 * i];
    return is_same;
}

// Fills in the lanes of one stretch. Returns false if they do not all fit.
static bool plan_stretch(YkWorker *w, size_t *put, size_t pose, double least)
{
    double steps = fmax(steps_to(w, pose), least);
    if (!(steps <= (double)(YK_STUDY_LANES - *put))) return false;
    put_lanes(w, put, pose, 1, steps, steps);
    end_at(w, pose);
    return true;
}

// Fills in the lanes of the whole way. Returns false if there are too many, or none because the poses are close.
static bool plan(YkWorker *w, size_t count)
{
    size_t put = 0, pose = put_start(w, &put) ? 1 : 0;
    if (pose < count && !plan_stretch(w, &put, pose++, 2)) return false; // run by themselves, as in go_by_lanes
    w->first_stretch = put;
    if (pose < count && is_fine(w, pose, count)) return false;
    for (; pose < count; pose++)
        if (!plan_stretch(w, &put, pose, 1)) return false;
    for (size_t i = 0; i < w->mech->input_count; i++) w->planned_from[i] = w->begun->valid_input[3 * i];
    w->planned = put;
    return true;
}

// Runs the lanes of the whole way in the same blocks as go_by_lanes.
static bool run_plan(YkWorker *w, Answers *a)
{
    const size_t parts[] = {0, 1, w->first_stretch, w->planned};
    yk_batch_begin(w->batch, w->begun);
    for (size_t k = 0; k < 3; k++)
        for (size_t from = parts[k], n; from < parts[k + 1]; from += n) {
            n = parts[k + 1] - from < YK_STUDY_BLOCK ? parts[k + 1] - from : YK_STUDY_BLOCK;
            if (!run_lanes(w, from, n, a)) return false;
        }
    end_at(w, a->count - 1);
    return true;
}

// Goes on as far as lanes can judge. Returns false if the rest must be moved.
static bool go_by_lanes(YkWorker *w, Answers *a)
{
    size_t put = 0, pose;
    if (w->way.lanes == 0 && w->plans) {
        w->plans = is_planned(w) || plan(w, a->count);
        if (w->plans) return run_plan(w, a);
        w->planned = 0;
    }
    if (w->way.lanes == 0 && !run_start(w, a)) return false;
    if (w->way.lanes == 1 && a->done < a->count) { // the first stretch
        double steps = steps_to(w, a->done);
        if (!(steps <= LANES_MAX) || !add_lanes(w, &put, a->done, steps, a) || !run_put(w, &put, a)) return false;
    }
    if (a->done == a->count) return true;
    if (is_fine(w, a->done, a->count)) return run_poses(w, a);
    for (pose = a->done; pose < a->count; pose++) {
        double steps = steps_to(w, pose);
        if (!(steps <= LANES_MAX)) {
            run_put(w, &put, a);
            return false;
        }
        if (!add_lanes(w, &put, pose, steps, a)) return false;
    }
    return run_put(w, &put, a);
}

// --- pose by pose

// Puts the state where the lanes ended or, if they have not reached a pose yet, at the start.
static YkStatus take_over(YkWorker *w)
{
    w->way.is_stepwise = true;
    if (!w->way.has_answered) {
        YkStatus status = yk_worker_stand(w);
        if (w->study->follows_time) w->state->time = 0;
        return status;
    }
    yk_state_copy(w->state, w->begun);
    yk_batch_refer(w->batch, w->state);
    memcpy(w->state->input, w->last, 3 * w->mech->input_count * sizeof *w->last);
    return yk_state_solve(w->state);
}

// Returns the only input that the goal moves; the number of inputs if there is none, or more than one.
static size_t moving_input(const YkWorker *w)
{
    size_t moving = w->mech->input_count;
    for (size_t i = 0; i < w->mech->input_count; i++) {
        if (w->goal[i].position == w->state->valid_input[3 * i]) continue;
        if (moving < w->mech->input_count) return w->mech->input_count;
        moving = i;
    }
    return moving;
}

// Returns whether the pose is beyond a known barrier.
static bool is_blocked(const YkWorker *w, size_t moving)
{
    if (moving == w->mech->input_count || moving != w->way.input) return false;
    double at = w->goal[moving].position, tolerance = 1e-9 * fmax(yk_input_unit(w->mech, moving), fabs(at));
    const YkBarrier *below = &w->way.barrier[0], *above = &w->way.barrier[1];
    return (below->is_set && at < below->at - tolerance) || (above->is_set && at > above->at + tolerance);
}

static void note_barrier(YkWorker *w, size_t moving, double from, double part)
{
    if (moving != w->way.input) w->way.barrier[0].is_set = w->way.barrier[1].is_set = false;
    double to = w->goal[moving].position;
    w->way.input = moving;
    w->way.barrier[to > from] = (YkBarrier){true, from + part * (to - from)};
}

// Moves the state along its drives to the time of a pose; if it cannot get there, it stays at the last pose it reached.
static YkStatus move_in_time(YkWorker *w, size_t pose)
{
    yk_state_copy(w->kept, w->state);
    YkStatus status = yk_state_move_time(w->state, time_at(w, pose), NULL, NULL, NULL);
    if (status < 0) yk_state_copy(w->state, w->kept);
    return status == YK_REDUNDANT ? YK_OK : status;
}

// Moves the state to a pose; if it cannot get there, it stays at the last pose it reached.
static YkStatus move(YkWorker *w, size_t pose)
{
    if (w->study->follows_time) return move_in_time(w, pose);
    YkMoveOptions options = yk_default_move_options();
    YkMove way;
    if (w->way.has_answered) options.detours = 0; // later poses follow the first one along their range
    for (size_t i = 0; i < w->mech->input_count; i++)
        w->goal[i] = (YkMotion){input_at(w, 3 * i, pose), input_at(w, 3 * i + 1, pose), input_at(w, 3 * i + 2, pose)};
    size_t moving = moving_input(w);
    if (is_blocked(w, moving)) return YK_LIMIT;
    yk_state_copy(w->kept, w->state);
    YkStatus status = yk_state_move_to(w->state, w->goal, &options, &way);
    if (status >= 0) {
        bool is_same_line = w->mech->input_count == 1 || moving == w->way.input;
        if (!is_same_line) w->way.barrier[0].is_set = w->way.barrier[1].is_set = false;
        return status == YK_REDUNDANT ? YK_OK : status;
    }
    yk_state_copy(w->state, w->kept);
    if (status == YK_LIMIT && moving < w->mech->input_count)
        note_barrier(w, moving, w->state->valid_input[3 * moving], way.part);
    return status == YK_BAD_ARGUMENT ? YK_LIMIT : status; // inputs that are not finite close nothing
}

static YkStatus answer(YkWorker *w, size_t pose, YkStatus status, double *const *outputs)
{
    YkPoseForces *forces = w->batch ? yk_batch_forces(w->batch) : w->forces;
    if (!w->study->follows_time) w->state->time = time_at(w, pose);
    for (size_t c = 0; c < w->study->channel_count; c++) {
        YkChannel channel = w->study->channels[c];
        bool has_value = status >= 0 && !yk_channel_needs_forces(channel);
        outputs[c][pose] = has_value ? yk_state_channel(w->state, channel) : 0;
    }
    return status == YK_OK && forces ? yk_pose_forces_at(forces, w->state, outputs, pose) : status;
}

// Returns whether the state stands where branches meet: the next move would not know which of them it is on.
static bool is_between_branches(const YkWorker *w, YkStatus status)
{
    return status == YK_SINGULAR || w->state->space.margin[0] <= MEETING_MARGIN;
}

static YkStatus go_stepwise(YkWorker *w, Answers *a)
{
    YkStatus worst = YK_OK;
    for (; a->done < a->count && !w->pace.is_stopped; a->done++) {
        YkStatus one = w->way.status;
        if (one >= 0) one = move(w, a->done);
        bool meets = one >= 0 && is_between_branches(w, one);
        one = answer(w, a->done, one, a->outputs);
        if (meets) yk_state_copy(w->state, w->kept); // the next one is sought from the pose before
        w->way.has_answered = true;
        if (a->status) a->status[a->done] = (signed char)one;
        worst = yk_worse(worst, one);
    }
    return worst;
}

YkStatus yk_worker_go(YkWorker *w, double *const *outputs, signed char *status, size_t count)
{
    Answers a = {outputs, status, count, 0};
    if (count == 0) return YK_OK;
    if (w->batch && !w->study->follows_time && !w->way.is_stepwise && go_by_lanes(w, &a)) {
        w->way.has_answered = true;
        return YK_OK;
    }
    if (w->pace.is_stopped) return YK_STOPPED;
    if (a.done > 0) w->way.has_answered = true;
    if (!w->way.is_stepwise) w->way.status = take_over(w);
    return go_stepwise(w, &a);
}
