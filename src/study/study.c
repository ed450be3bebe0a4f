// Solves designs. A worker has all it needs to solve a design by itself: a variant, a state, a
// batch. Designs are handed out in chunks, and the thread on which a design is solved changes nothing in its results.
#include "study/kernels_extent.h"
#include "study/study.h"
#include <stdlib.h>
#include <string.h>
#include "base/problems.h"
#include "compile/variant.h"
#include "study/remake.h"

// --- workers

static bool make_room(YkWorker *w, size_t parameters, size_t channels)
{
    size_t inputs = 3 * w->mech->input_count;
    YkArena *a = w->arena = yk_arena_new();
    w->value = yk_arena_alloc(a, parameters + 1, sizeof *w->value);
    w->inputs = yk_arena_alloc(a, inputs + 1, sizeof *w->inputs);
    w->outputs = yk_arena_alloc(a, channels + 1, sizeof *w->outputs);
    w->extent = yk_arena_alloc(a, channels + 1, sizeof *w->extent);
    w->count = yk_arena_alloc(a, channels + 1, sizeof *w->count);
    w->block = yk_arena_alloc(a, (channels + 1) * YK_STUDY_BLOCK, sizeof *w->block);
    w->block_status = yk_arena_alloc(a, YK_STUDY_BLOCK, 1);
    w->last = yk_arena_alloc(a, inputs + 1, sizeof *w->last);
    w->end = yk_arena_alloc(a, inputs + 1, sizeof *w->end);
    w->lane = yk_arena_alloc(a, inputs * YK_STUDY_LANES + 1, sizeof *w->lane);
    w->lane_output = yk_arena_alloc(a, (channels + 1) * YK_STUDY_BLOCK, sizeof *w->lane_output);
    w->lane_pose = yk_arena_alloc(a, YK_STUDY_LANES, sizeof *w->lane_pose);
    w->planned_from = yk_arena_alloc(a, inputs + 1, sizeof *w->planned_from);
    w->row = yk_arena_alloc(a, inputs + 1, sizeof *w->row);
    w->row_output = yk_arena_alloc(a, channels + 1, sizeof *w->row_output);
    return !yk_arena_failed(a);
}

static bool start_worker(YkStudy *study, YkWorker *w, const YkState *state, const YkStudyOptions *options,
                         YkProblems *problems)
{
    w->study = study;
    if (!w->variant) w->variant = yk_variant_new(state->mech, options->parameters, options->parameter_count, problems);
    if (!w->variant) return false;
    w->mech = yk_variant_mechanism(w->variant);
    if (!make_room(w, options->parameter_count, options->channel_count)) return false;
    if (!yk_worker_start(w, state, options, problems)) return false;
    bool none, is_followed = yk_batch_can_follow(w->mech, options->channels, options->channel_count);
    if (is_followed) w->batch = yk_batch_new_along(w->home, options->channels, options->channel_count);
    if (is_followed && (!w->batch || !yk_batch_has_slow_forces(w->batch))) return w->batch != NULL;
    yk_batch_free(w->batch); // every pose needs the state
    w->batch = NULL;
    w->forces = yk_pose_forces_new(w->mech, options->channels, options->channel_count, 1, &none);
    return w->forces || none;
}

static void end_worker(YkWorker *w)
{
    yk_batch_free(w->batch);
    yk_pose_forces_free(w->forces);
    yk_state_free(w->state);
    yk_state_free(w->kept);
    yk_state_free(w->begun);
    yk_state_free(w->home);
    yk_state_free(w->base);
    yk_state_free(w->base_home);
    yk_variant_free(w->base_variant);
    yk_variant_free(w->variant);
    free(w->goal);
    yk_arena_free(w->arena);
}

// --- inputs

// Returns the expression of an input's drive or, if it is held, of its start; NULL if it has none.
static const YkExpr *input_expr(const YkState *state, size_t input)
{
    const YkModel *model = state->mech->model;
    const YkTreeCoordinate *q = &state->mech->coordinates[state->mech->inputs[input]];
    if (q->drive != YK_NONE) return model->drives[q->drive].expr;
    for (size_t k = 0; k < model->start_count; k++) {
        const YkCoordinate *c = &model->coordinates[model->starts[k].coordinate];
        if (c->joint == q->joint && c->is_distance == q->is_distance) return model->starts[k].expr;
    }
    return NULL;
}

// Returns false if a drive varies, or the start value of a held input: the state's inputs would not follow.
static bool inputs_stay(const YkState *state, const bool *varies, YkProblems *problems)
{
    bool good = true;
    for (size_t i = 0; i < state->mech->input_count; i++) {
        const YkExpr *expr = input_expr(state, i);
        if (!yk_model_depends(state->mech->model, varies, expr)) continue;
        yk_problem(problems, YK_CODE_CANNOT_VARY, expr->place,
                   "a parameter that varies enters the drive or start of %q here",
                   state->mech->coordinates[state->mech->inputs[i]].name);
        yk_problem_hint(problems, "sweep the coordinate itself, with --over");
        good = false;
    }
    return good;
}

static bool check_inputs(const YkState *state, const YkStudyOptions *options, YkProblems *problems)
{
    const YkModel *model = state->mech->model;
    bool *varies = calloc(model->parameter_count + 1, sizeof *varies);
    if (!varies) return false;
    for (size_t k = 0; k < options->parameter_count; k++)
        varies[yk_names_find(&model->parameter_names, options->parameters[k])] = true;
    yk_model_mark_dependents(model, varies);
    bool good = inputs_stay(state, varies, problems);
    if (good && options->start) good = inputs_stay(options->start, varies, problems);
    free(varies);
    return good;
}

// --- the two ways to make designs

// Returns whether parameters enter what a variant cannot follow, and nothing else is wrong.
static bool must_be_remade(const YkProblems *found)
{
    size_t count = 0;
    for (size_t k = 0; k < yk_problems_count(found); k++) {
        const YkProblem *problem = yk_problems_get(found, k);
        if (problem->severity != YK_SEVERITY_ERROR) continue;
        if (problem->code != YK_CODE_CANNOT_VARY) return false;
        count++;
    }
    return count > 0;
}

// Makes the first worker's variant. If there can be none, designs are to be made anew.
static bool choose_way(YkStudy *study, const YkState *state, const YkStudyOptions *options, YkProblems *problems)
{
    YkProblems *found = yk_problems_new();
    if (!found) return false;
    YkVariant *variant = yk_variant_new(state->mech, options->parameters, options->parameter_count, found);
    bool is_remade = !variant && must_be_remade(found);
    study->worker[0].variant = variant;
    study->thread_count = variant ? 1 : 0;
    if (!is_remade) yk_problems_pass_on(problems, found, NULL);
    yk_problems_free(found);
    if (is_remade ? !yk_remake_start(study, state, options) : !variant) return false;
    return check_inputs(state, options, problems);
}

static bool start_remaking(YkStudy *study, YkWorker *w, const YkState *state, const YkStudyOptions *options)
{
    w->study = study;
    w->mech = state->mech;
    return make_room(w, options->parameter_count, options->channel_count);
}

static bool start_workers(YkStudy *study, const YkState *state, const YkStudyOptions *options, YkPace *pace,
                          YkProblems *problems)
{
    size_t threads = options->threads ? options->threads : 1;
    bool good = choose_way(study, state, options, problems);
    for (size_t t = 0; good && t < threads && yk_pace_ask(pace); t++) {
        study->thread_count = t + 1;
        good = study->remake ? start_remaking(study, &study->worker[t], state, options)
                             : start_worker(study, &study->worker[t], state, options, t == 0 ? problems : NULL);
    }
    return good;
}

YkStudy *yk_study_new(const YkState *state, const YkStudyOptions *options, YkProblems *problems)
{
    size_t errors = yk_problems_error_count(problems), threads = options->threads ? options->threads : 1;
    YkStudy *study = calloc(1, sizeof *study);
    bool good = study != NULL;
    if (good) {
        study->channel_count = options->channel_count;
        study->parameter_count = options->parameter_count;
        study->progress = options->progress;
        study->follows_time = options->follows_time;
        study->worker = calloc(threads, sizeof *study->worker);
        study->thread = calloc(threads, sizeof *study->thread);
        study->channels = calloc(options->channel_count + 1, sizeof *study->channels);
        study->own = calloc(options->parameter_count + 1, sizeof *study->own);
        good = study->worker && study->thread && study->channels && study->own;
    }
    for (size_t c = 0; good && c < options->channel_count; c++) study->channels[c] = options->channels[c];
    for (size_t p = 0; good && p < options->parameter_count; p++)
        study->own[p] = yk_model_parameter(state->mech->model, options->parameters[p]);
    YkPace pace;
    yk_pace_begin(&pace, options->progress);
    if (good && start_workers(study, state, options, &pace, problems) && !pace.is_stopped) return study;
    yk_study_free(study);
    if (pace.is_stopped)
        yk_problem_stopped(problems);
    else if (problems && yk_problems_error_count(problems) == errors)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while preparing the study");
    return NULL;
}

void yk_study_free(YkStudy *study)
{
    if (!study) return;
    for (size_t t = 0; t < study->thread_count; t++) end_worker(&study->worker[t]);
    yk_remake_end(study);
    free(study->worker);
    free(study->thread);
    free(study->channels);
    free(study->own);
    free(study);
}

// --- a design

enum { NUMBERS = 100, REMAKING = 20000 }; // work for each step: other numbers; a machine that is made anew

YkStatus yk_worker_set(YkWorker *w, const double *values)
{
    size_t steps = w->mech->step_count + w->study->parameter_count + 1;
    if (!yk_pace_spend(&w->pace, steps * NUMBERS)) return YK_STOPPED;
    YkStatus status = yk_variant_set(w->variant, values);
    if (status >= 0) status = yk_worker_begin(w, values);
    return status;
}

static void point_inputs(YkWorker *w, const YkStudyCase *asked, size_t design, size_t from)
{
    size_t at = from + (asked->inputs_per_design ? design * asked->pose_count : 0);
    for (size_t i = 0; i < 3 * w->mech->input_count; i++)
        w->inputs[i] = asked->inputs && asked->inputs[i] ? asked->inputs[i] + at : NULL;
    w->times = asked->times ? asked->times + from : NULL;
}

static void take_values(YkWorker *w, const YkStudyCase *asked, size_t design)
{
    for (size_t p = 0; p < w->study->parameter_count; p++)
        w->value[p] = asked->parameters && asked->parameters[p] ? asked->parameters[p][design] : w->study->own[p];
}

static YkStatus set_design(YkWorker *w, const YkStudyCase *asked, size_t design)
{
    take_values(w, asked, design);
    return yk_worker_set(w, w->value);
}

static YkStatus run_design(YkWorker *w, const YkJob *job, size_t design)
{
    const YkStudyCase *asked = job->asked;
    size_t n = asked->pose_count, at = design * n;
    YkStatus status = set_design(w, asked, design);
    if (status < 0) {
        for (size_t c = 0; c < w->study->channel_count; c++) memset(job->outputs[c] + at, 0, n * sizeof(double));
        if (job->status) memset(job->status + at, status, n);
        return status;
    }
    point_inputs(w, asked, design, 0);
    for (size_t c = 0; c < w->study->channel_count; c++) w->outputs[c] = job->outputs[c] + at;
    return yk_worker_go(w, w->outputs, job->status ? job->status + at : NULL, n);
}

// --- reducing

bool yk_study_counts(YkChannel channel, YkStatus status)
{
    bool is_force = yk_channel_needs_forces(channel);
    bool is_rate = is_force || channel.order > 0 || channel.kind == YK_CHANNEL_POINT_SPEED;
    return status >= 0 && !(status == YK_SINGULAR && is_rate) && !(status == YK_CHANGE_POINT && is_force);
}

static void add_row(YkWorker *w, size_t c, size_t n, bool all_count)
{
    const double *row = w->outputs[c];
    YkExtent e = w->count[c] > 0 ? w->extent[c] : (YkExtent){INFINITY, -INFINITY, 0};
    size_t added = all_count ? n : 0;
    if (all_count) yk_lanes_extent(&e.least, &e.largest, &e.mean, row, n);
    for (size_t k = 0; !all_count && k < n; k++) {
        if (!yk_study_counts(w->study->channels[c], (YkStatus)w->block_status[k])) continue;
        e.least = e.least <= row[k] ? e.least : row[k];
        e.largest = e.largest >= row[k] ? e.largest : row[k];
        e.mean += row[k];
        added++;
    }
    w->count[c] += added;
    if (w->count[c] > 0) w->extent[c] = e;
}

static YkStatus reduce_design(YkWorker *w, const YkJob *job, size_t design)
{
    const YkStudyCase *asked = job->asked;
    size_t channels = w->study->channel_count, standing = 0;
    YkStatus worst = set_design(w, asked, design);
    bool has_start = worst >= 0;
    memset(w->extent, 0, channels * sizeof *w->extent);
    memset(w->count, 0, channels * sizeof *w->count);
    for (size_t c = 0; c < channels; c++) w->outputs[c] = w->block + c * YK_STUDY_BLOCK;
    for (size_t from = 0; has_start && from < asked->pose_count && !w->pace.is_stopped; from += YK_STUDY_BLOCK) {
        size_t n = asked->pose_count - from < YK_STUDY_BLOCK ? asked->pose_count - from : YK_STUDY_BLOCK, stand = n;
        point_inputs(w, asked, design, from);
        YkStatus here = yk_worker_go(w, w->outputs, w->block_status, n);
        worst = yk_worse(worst, here);
        for (size_t k = 0; here < 0 && k < n; k++) stand -= w->block_status[k] < 0;
        for (size_t c = 0; c < channels; c++) add_row(w, c, n, here == YK_OK);
        standing += stand;
    }
    for (size_t c = 0; c < channels; c++) {
        if (w->count[c] > 0) w->extent[c].mean /= (double)w->count[c];
        job->extents[c * asked->design_count + design] = w->extent[c];
    }
    if (job->status) job->status[design] = (signed char)worst;
    if (job->standing) job->standing[design] = standing;
    return worst;
}

YkStatus yk_worker_design(YkWorker *w, size_t design)
{
    const YkJob *job = w->job;
    if (!w->study->remake) return job->extents ? reduce_design(w, job, design) : run_design(w, job, design);
    if (!yk_pace_spend(&w->pace, (w->mech->step_count + 10) * REMAKING)) return YK_STOPPED;
    take_values(w, job->asked, design);
    point_inputs(w, job->asked, design, 0);
    return yk_remake_design(w, job, design);
}

// --- the door

YkStatus yk_study_run(YkStudy *study, const YkStudyCase *asked, double *const *outputs, signed char *status)
{
    YkJob job = {.asked = asked, .outputs = outputs, .status = status};
    return yk_study_go(study, &job);
}

YkStatus yk_study_reduce(YkStudy *study, const YkStudyCase *asked, YkExtent *extents, signed char *status,
                         size_t *standing)
{
    YkJob job = {.asked = asked, .extents = extents, .status = status, .standing = standing};
    return yk_study_go(study, &job);
}
