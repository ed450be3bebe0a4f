// Finds derivatives of channels with respect to parameters, in two ways that share only the pose.
//
// By derivative: with fixed inputs the loops Phi(x, p) = 0 give J dx = -dPhi/dp; an answer y(x, p) then has
// dy = dy/dx dx + dy/dp. Only explicit functions - Phi and y at given x - are differenced, along one direction.
// By difference: the whole machine is solved at neighbouring values.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "compile/closure.h"
#include "elementary/elementary.h"
#include "num/dense.h"
#include "study/study.h"

enum { STAGES = 5 };

// Returns a small step for a parameter, relative to its size, or to the machine's if it is 0.
static double step_of(const YkStudy *study, size_t parameter)
{
    double own = fabs(study->own[parameter]);
    return 1e-2 * (own > 0 ? own : 0.1 * study->worker[0].mech->size);
}

// Extrapolates the differences D(h), D(h/2), ..., whose errors go with h^2, by Neville's table, and keeps the entry
// with the least change. Source: Richardson 1911; Ridders 1982.
static double extrapolate(const double *difference, size_t count)
{
    double table[STAGES], last = difference[0], best = INFINITY, value = difference[0];
    for (size_t k = 0; k < count; k++) {
        double above = difference[k], factor = 1;
        for (size_t j = 0; j < k; j++) {
            factor *= 4;
            double next = above + (above - table[j]) / (factor - 1);
            table[j] = above;
            above = next;
        }
        table[k] = above;
        if (k > 0 && fabs(above - last) < best) best = fabs(above - last), value = above;
        last = above;
    }
    return value;
}

// --- by difference

static YkStatus channels_at(YkWorker *w, const double *values, double *out)
{
    YkStatus status = yk_worker_set(w, values);
    signed char one = YK_OK;
    for (size_t c = 0; c < w->study->channel_count; c++) w->outputs[c] = out + c;
    if (status >= 0) status = yk_worker_go(w, w->outputs, &one, 1);
    for (size_t c = 0; status >= 0 && c < w->study->channel_count; c++)
        if (!yk_study_counts(w->study->channels[c], (YkStatus)one)) out[c] = NAN;
    return status;
}

static YkStatus by_difference(YkStudy *study, size_t parameter, double *derivative, double *scratch)
{
    YkWorker *w = &study->worker[0];
    size_t channels = study->channel_count;
    double h = step_of(study, parameter), *low = scratch, *high = scratch + channels, *stages = scratch + 2 * channels;
    for (int stage = 0; stage < STAGES; stage++, h /= 2) {
        memcpy(w->value, study->own, study->parameter_count * sizeof *w->value);
        w->value[parameter] = study->own[parameter] - h;
        double from = w->value[parameter];
        YkStatus status = channels_at(w, w->value, low);
        if (status < 0) return status;
        w->value[parameter] = study->own[parameter] + h;
        double to = w->value[parameter];
        status = channels_at(w, w->value, high);
        if (status < 0) return status;
        for (size_t c = 0; c < channels; c++) stages[c * STAGES + (size_t)stage] = (high[c] - low[c]) / (to - from);
    }
    for (size_t c = 0; c < channels; c++) derivative[c] = extrapolate(stages + c * STAGES, STAGES);
    return YK_OK;
}

// --- by derivative

typedef struct Linear { // the loops and inputs at the pose, as equations of dx
    const YkMechanism *mech;
    size_t variables, rows;
    double *x, *J, *b, *dx, *tau, *work, *stages; // work: of the explicit functions; stages: [loop equation][STAGES]
    size_t *order;
    YkVec *origin; // [body]
    double *angle; // [body] of its orientation
    size_t rank;
    double size; // of the machine, with the file's parameters
} Linear;

static bool is_position(YkChannel channel)
{
    return channel.order == 0 && channel.kind <= YK_CHANNEL_POINT_Y;
}

// Returns whether some column follows from the loops of the tree.
static bool can_linearise(const YkStudy *study, const YkMechanism *mech)
{
    if (mech->relation_count > 0 || yk_variable_count(mech) > YK_CLOSURE_MAX) return false;
    for (size_t c = 0; c < study->channel_count; c++)
        if (is_position(study->channels[c])) return true;
    return false;
}

static size_t variable_of(const YkMechanism *mech, bool is_distance, int32_t index)
{
    return is_distance ? mech->orientation_count - 1 + (size_t)index : (size_t)index - 1;
}

static void end_linear(Linear *l)
{
    free(l->x);
    free(l->order);
    free(l->origin);
}

static bool start_linear(Linear *l, const YkMechanism *mech)
{
    size_t n = yk_variable_count(mech), loops = 2 * mech->loop_count, m = loops + mech->input_count;
    size_t bodies = mech->model->body_count;
    *l = (Linear){.mech = mech, .variables = n, .rows = m};
    l->x = calloc(5 * n + m * n + 2 * m + (2 + STAGES) * loops + bodies + 8, sizeof *l->x);
    l->order = calloc(n + 1, sizeof *l->order);
    l->origin = calloc(bodies, sizeof *l->origin);
    if (!l->x || !l->order || !l->origin) return false;
    l->dx = l->x + n, l->tau = l->dx + n, l->J = l->tau + n, l->b = l->J + m * n, l->work = l->b + m;
    l->stages = l->work + 2 * loops + n;
    l->angle = l->stages + STAGES * loops;
    return true;
}

// Returns the unit of a variable in J, whose entries are lengths: a radian, or the machine's size.
static double unit_of(const Linear *l, size_t variable)
{
    return variable < l->mech->orientation_count - 1 ? 1 : l->size;
}

// Takes x from the pose; fills J from the loops and one row per input, whose coordinate does not change.
static void linearise(Linear *l, const YkState *state)
{
    const YkMechanism *mech = l->mech;
    for (size_t o = 1; o < mech->orientation_count; o++) {
        YkTurn t = yk_space_turn(&state->space, (int32_t)o);
        l->x[o - 1] = yk_atan2(t.s[0], t.c[0]);
    }
    for (size_t d = 0; d < mech->distance_count; d++)
        l->x[mech->orientation_count - 1 + d] = yk_space_slide(&state->space, (int32_t)d).d[0];
    l->size = mech->size;
    memset(l->J, 0, l->rows * l->variables * sizeof *l->J);
    yk_closure(mech, l->x, l->work, l->J);
    for (size_t i = 0; i < mech->input_count; i++) {
        const YkTreeCoordinate *q = &mech->coordinates[mech->inputs[i]];
        double *row = l->J + (2 * mech->loop_count + i) * l->variables;
        if (q->is_distance) {
            row[variable_of(mech, true, q->distance)] = 1;
        } else {
            if (q->angle.b > 0) row[variable_of(mech, false, q->angle.b)] += mech->size;
            if (q->angle.a > 0) row[variable_of(mech, false, q->angle.a)] -= mech->size;
        }
    }
    for (size_t k = 0; k < l->rows * l->variables; k++) l->J[k] *= unit_of(l, k % l->variables);
    l->rank = yk_qr_factor(l->rows, l->variables, l->J, l->order, l->tau, 1e-10);
}

// Places all bodies at given x, outwards along the tree.
static void place(Linear *l, const double *x)
{
    const YkMechanism *mech = l->mech;
    const YkModel *model = mech->model;
    for (size_t k = 0; k < model->body_count; k++) {
        int32_t b = mech->tree_order[k], p = mech->tree.parent[b], o = mech->bodies[b].orientation;
        l->angle[b] = o > 0 ? x[variable_of(mech, false, o)] : 0;
        if (p == YK_NONE) {
            l->origin[b] = yk_vec(0, 0);
            continue;
        }
        const YkJoint *j = &model->joints[mech->tree.joint[b]];
        int32_t d = mech->joint_distance[mech->tree.joint[b]];
        int own = j->body[1] == b;
        YkVec turn[2];
        for (int e = 0; e < 2; e++) turn[e] = yk_mul(yk_unit(l->angle[j->body[e]]), mech->bodies[j->body[e]].turn_unit);
        YkVec across = yk_sub(yk_mul(turn[0], j->at[0]), yk_mul(turn[1], j->at[1]));
        if (d != YK_NONE) across = yk_add(across, yk_scale(x[variable_of(mech, true, d)], yk_mul(turn[0], j->along)));
        l->origin[b] = yk_add(l->origin[p], yk_scale(own ? 1 : -1, across));
    }
}

// Returns an answer at given x, after `place`. Angles are known up to a constant.
static double answer(const Linear *l, const double *x, YkChannel c)
{
    const YkMechanism *mech = l->mech;
    const YkModel *model = mech->model;
    if (c.kind == YK_CHANNEL_COORDINATE) {
        const YkTreeCoordinate *q = &mech->coordinates[c.index];
        if (q->is_distance) return x[variable_of(mech, true, q->distance)];
        return (q->angle.b > 0 ? x[variable_of(mech, false, q->angle.b)] : 0) -
               (q->angle.a > 0 ? x[variable_of(mech, false, q->angle.a)] : 0);
    }
    if (c.kind == YK_CHANNEL_BODY) return l->angle[c.index];
    if (c.kind == YK_CHANNEL_JOINT_ANGLE)
        return l->angle[model->joints[c.index].body[1]] - l->angle[model->joints[c.index].body[0]];
    if (c.kind == YK_CHANNEL_JOINT_DISTANCE) return x[variable_of(mech, true, mech->joint_distance[c.index])];
    if (c.kind == YK_CHANNEL_TIME) return 0;
    const YkPoint *p = &model->points[c.index];
    YkVec at = yk_mul(yk_mul(yk_unit(l->angle[p->body]), mech->bodies[p->body].turn_unit), p->at);
    at = yk_add(at, l->origin[p->body]);
    return c.kind == YK_CHANNEL_POINT_X ? at.x : at.y;
}

// Computes Phi at the pose for parameters p +- h: residual[2 loops].
static bool residual_at(YkStudy *study, Linear *l, size_t parameter, double value, double *residual)
{
    YkWorker *w = &study->worker[0];
    memcpy(w->value, study->own, study->parameter_count * sizeof *w->value);
    w->value[parameter] = value;
    if (yk_variant_set(w->variant, w->value) < 0) return false;
    yk_closure(w->mech, l->x, residual, NULL);
    return true;
}

static bool directions(YkStudy *study, Linear *l, size_t parameter)
{
    size_t n = 2 * l->mech->loop_count;
    double own = study->own[parameter], h = step_of(study, parameter), *stages = l->stages;
    bool good = true;
    for (size_t stage = 0; good && stage < STAGES; stage++, h /= 2) {
        good = residual_at(study, l, parameter, own + h, l->b);
        for (size_t k = 0; good && k < n; k++) l->work[k] = l->b[k];
        good = good && residual_at(study, l, parameter, own - h, l->b);
        for (size_t k = 0; good && k < n; k++)
            stages[k * STAGES + stage] = (l->work[k] - l->b[k]) / ((own + h) - (own - h));
    }
    for (size_t k = 0; good && k < l->rows; k++) l->b[k] = k < n ? -extrapolate(stages + k * STAGES, STAGES) : 0;
    if (good) yk_qr_solve(l->rows, l->variables, l->J, l->order, l->tau, l->rank, l->b, l->dx);
    for (size_t k = 0; good && k < l->variables; k++) l->dx[k] *= unit_of(l, k);
    return good;
}

// Computes d/dh of y(x + h dx, p + h); NaN for a channel that is not a position.
static bool answers_along(YkStudy *study, Linear *l, size_t parameter, double *derivative, double *stages)
{
    YkWorker *w = &study->worker[0];
    double own = study->own[parameter], h = step_of(study, parameter), *x = l->work;
    for (size_t stage = 0; stage < STAGES; stage++, h /= 2) {
        for (int side = 0; side < 2; side++) {
            double at = own + (side ? -h : h);
            memcpy(w->value, study->own, study->parameter_count * sizeof *w->value);
            w->value[parameter] = at;
            if (yk_variant_set(w->variant, w->value) < 0) return false;
            for (size_t k = 0; k < l->variables; k++) x[k] = l->x[k] + (at - own) * l->dx[k];
            place(l, x);
            for (size_t c = 0; c < study->channel_count; c++) {
                bool is_known = is_position(study->channels[c]);
                double *slot = &stages[c * STAGES + stage],
                       y = is_known ? answer(l, x, study->channels[c]) : (double)NAN;
                *slot = side ? (*slot - y) / ((own + h) - (own - h)) : y;
            }
        }
    }
    for (size_t c = 0; c < study->channel_count; c++) derivative[c] = extrapolate(stages + c * STAGES, STAGES);
    return true;
}

// --- designs that are made anew

// Differences designs with one parameter beside the file's value, made one after the other.
static YkStatus by_designs(YkStudy *study, const double *const *inputs, size_t parameter, double *column)
{
    size_t channels = study->channel_count;
    double *stages = calloc(channels * (STAGES + 2) + 1, sizeof *stages), *pair = stages + channels * STAGES, values[2];
    double **out = calloc(channels + 1, sizeof *out), h = step_of(study, parameter);
    const double **varied = calloc(study->parameter_count + 1, sizeof *varied);
    YkStatus status = stages && out && varied ? YK_OK : YK_NO_MEMORY;
    signed char one[2] = {YK_OK, YK_OK};
    for (size_t stage = 0; status >= 0 && stage < STAGES; stage++, h /= 2) {
        values[0] = study->own[parameter] + h;
        values[1] = study->own[parameter] - h;
        varied[parameter] = values;
        for (size_t c = 0; c < channels; c++) out[c] = pair + 2 * c;
        YkStudyCase asked = {.parameters = varied, .design_count = 2, .inputs = inputs, .pose_count = 1};
        status = yk_study_run(study, &asked, out, one);
        for (size_t c = 0; c < channels; c++) {
            YkChannel channel = study->channels[c];
            bool counts = yk_study_counts(channel, (YkStatus)one[0]) && yk_study_counts(channel, (YkStatus)one[1]);
            stages[c * STAGES + stage] = counts ? (out[c][0] - out[c][1]) / (values[0] - values[1]) : (double)NAN;
        }
    }
    for (size_t c = 0; status >= 0 && c < channels; c++) column[c] = extrapolate(stages + c * STAGES, STAGES);
    free(stages);
    free(out);
    free(varied);
    return status;
}

static YkStatus differences_of_designs(YkStudy *study, const double *const *inputs, double *by_derivative,
                                       double *by_difference_out)
{
    size_t channels = study->channel_count, parameters = study->parameter_count;
    double *column = calloc(channels + 1, sizeof *column);
    YkStatus status = column ? YK_OK : YK_NO_MEMORY;
    for (size_t p = 0; status >= 0 && p < parameters; p++) {
        status = by_designs(study, inputs, p, column);
        for (size_t c = 0; status >= 0 && c < channels; c++)
            by_difference_out[c * parameters + p] = column[c], by_derivative[c * parameters + p] = (double)NAN;
    }
    free(column);
    return status > 0 ? YK_OK : status;
}

// --- the door

// Puts the file's own machine in the pose.
static YkStatus stand_at_pose(YkWorker *w)
{
    YkStatus status = yk_worker_set(w, w->study->own);
    if (status >= 0) status = yk_worker_stand(w);
    for (size_t i = 0; i < w->mech->input_count; i++) {
        const double *const *x = w->inputs + 3 * i, *own = w->home->input + 3 * i;
        w->goal[i] = (YkMotion){x[0] ? *x[0] : own[0], x[1] ? *x[1] : own[1], x[2] ? *x[2] : own[2]};
    }
    return status < 0 ? status : yk_state_move_to(w->state, w->goal, NULL, NULL);
}

YkStatus yk_study_sensitivities(YkStudy *study, const double *const *inputs, double *by_derivative,
                                double *by_difference_out)
{
    if (study->remake) return differences_of_designs(study, inputs, by_derivative, by_difference_out);
    YkWorker *w = &study->worker[0];
    size_t channels = study->channel_count, parameters = study->parameter_count;
    double *scratch = calloc((3 + STAGES) * (channels + 1), sizeof *scratch), *column = scratch;
    YkStatus status = scratch ? YK_OK : YK_NO_MEMORY;
    Linear l = {0};
    bool is_linear = can_linearise(study, w->mech);
    if (status == YK_OK && is_linear && !start_linear(&l, w->mech)) status = YK_NO_MEMORY;
    for (size_t i = 0; i < 3 * w->mech->input_count; i++) w->inputs[i] = inputs ? inputs[i] : NULL;
    yk_pace_begin(&w->pace, study->progress);
    if (status == YK_OK) status = stand_at_pose(w);
    if (status >= 0 && is_linear) linearise(&l, w->state);
    for (size_t p = 0; status >= 0 && p < parameters && yk_pace_ask(&w->pace); p++) {
        status = by_difference(study, p, column, scratch + channels);
        for (size_t c = 0; c < channels; c++)
            by_difference_out[c * parameters + p] = column[c], by_derivative[c * parameters + p] = (double)NAN;
        if (status < 0 || !is_linear) continue;
        if (!directions(study, &l, p) || !answers_along(study, &l, p, column, scratch + channels))
            status = YK_BAD_MODEL;
        for (size_t c = 0; c < channels; c++) by_derivative[c * parameters + p] = column[c];
        yk_pace_reach(&w->pace, (double)(p + 1) / (double)(parameters + 1));
    }
    if (w->pace.is_stopped) status = YK_STOPPED;
    w->pace = (YkPace){0};
    YkStatus back = yk_worker_set(w, study->own);
    if (status >= 0 && back == YK_NO_MEMORY) status = back;
    end_linear(&l);
    free(scratch);
    return status > 0 ? YK_OK : status;
}
