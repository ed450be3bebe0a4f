// Makes designs anew, one after the other: the file's text with other values, compiled with the same inputs, assembled
// as the file's machine is, then solved as a study of one design.
#include "study/remake.h"
#include <stdlib.h>
#include <string.h>
#include <yoke/builder.h>
#include "base/number.h"
#include "base/problems.h"

#define TURN_MOST 0.5 // rad, or lengths over the size: as far as groups may move from the file's configuration

struct YkRemake {
    const YkState *state, *start; // start: of other inputs, or NULL
    char **names;
    double *units; // [parameter]: in which the file's numbers are
    size_t count;
};

// --- starting

static char *copy_text(const char *text)
{
    char *copy = malloc(strlen(text) + 1);
    return copy ? strcpy(copy, text) : NULL;
}

bool yk_remake_start(YkStudy *study, const YkState *state, const YkStudyOptions *options)
{
    YkRemake *r = study->remake = calloc(1, sizeof *r);
    if (!r) return false;
    r->state = state;
    r->start = options->start && options->start->mech != state->mech ? options->start : NULL;
    r->names = calloc(options->parameter_count + 1, sizeof *r->names);
    r->units = calloc(options->parameter_count + 1, sizeof *r->units);
    if (!r->names || !r->units) return false;
    for (; r->count < options->parameter_count; r->count++) {
        const char *name = options->parameters[r->count];
        r->names[r->count] = copy_text(name);
        r->units[r->count] = yk_model_parameter_unit(state->mech->model, name);
        if (!r->names[r->count]) return false;
    }
    return true;
}

void yk_remake_end(YkStudy *study)
{
    YkRemake *r = study->remake;
    if (!r) return;
    for (size_t k = 0; k < r->count; k++) free(r->names[k]);
    free(r->names);
    free(r->units);
    free(r);
}

// --- one machine

typedef struct Made {
    YkProgress progress;
    YkProblems *problems; // unused: the status says enough
    YkModel *model;
    YkMechanism *mech, *base_mech;
    YkState *state, *base; // base: with the inputs of the start, if these differ
} Made;

static void tell_no_memory(const Made *m)
{
    yk_problem(m->problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while preparing the study");
}

static YkModel *read_with(const YkRemake *r, const double *values, const Made *m)
{
    const YkModel *model = r->state->mech->model;
    YkOverride *overrides = calloc(r->count + 1, sizeof *overrides);
    char(*texts)[YK_NUMBER_SIZE] = calloc(r->count + 1, sizeof *texts);
    YkModel *made = NULL;
    for (size_t k = 0; overrides && texts && k < r->count; k++) {
        yk_number_write(values[k] / r->units[k], texts[k]);
        overrides[k] = (YkOverride){r->names[k], texts[k]};
    }
    const char *text = yk_model_text(model);
    YkLoadOptions options = {overrides, r->count, model->engaged, m->progress};
    if (overrides && texts && text)
        made = yk_model_parse(text, strlen(text), model->source_name, &options, m->problems);
    else
        tell_no_memory(m);
    free(overrides);
    free(texts);
    return made;
}

static YkMechanism *compile_as(const Made *m, const YkMechanism *as)
{
    const char **inputs = calloc(as->input_count + 1, sizeof *inputs);
    for (size_t i = 0; inputs && i < as->input_count; i++) inputs[i] = as->coordinates[as->inputs[i]].name;
    YkCompileOptions options = {.inputs = inputs, .input_count = as->input_count, .progress = m->progress};
    YkMechanism *mech = inputs ? yk_mechanism_compile(m->model, &options, m->problems) : NULL;
    if (!inputs) tell_no_memory(m);
    free(inputs);
    return mech;
}

// Returns whether two machines have the same coordinates and are solved in the same steps.
static bool is_alike(const YkMechanism *a, const YkMechanism *b)
{
    bool same = a->coordinate_count == b->coordinate_count && a->block_count == b->block_count &&
                a->column_count == b->column_count && a->reference_count == b->reference_count;
    for (size_t k = 0; same && k < a->block_count; k++) same = a->blocks[k].kind == b->blocks[k].kind;
    for (size_t k = 0; same && k < a->coordinate_count; k++)
        same = strcmp(a->coordinates[k].name, b->coordinates[k].name) == 0;
    return same;
}

static bool is_near(const YkState *a, const YkState *b)
{
    for (size_t c = 0; c < a->mech->coordinate_count; c++) {
        double off = fabs(yk_state_coordinate(a, c).position - yk_state_coordinate(b, c).position);
        if (!(off <= TURN_MOST * (a->mech->coordinates[c].is_distance ? a->mech->size : 1))) return false;
    }
    return true;
}

// Assembles a machine at the inputs of the file's, in its configuration: by its labels, or nearest to it where groups
// have none.
static YkStatus stand_as(YkState *to, const YkState *from)
{
    YkStatus status = YK_OK;
    if (!is_alike(to->mech, from->mech)) return YK_BAD_MODEL;
    yk_state_take(to, from);
    if (to->mech->has_groups) {
        status = yk_state_guess(to, from);
        if (status >= 0) status = yk_state_assemble(to);
    }
    memcpy(to->input, from->valid_input, 3 * to->mech->input_count * sizeof *to->input);
    if (status >= 0) status = yk_state_solve(to);
    if (status >= 0 && to->mech->has_groups && !is_near(to, from)) status = YK_NO_ASSEMBLY;
    return status == YK_LIMIT ? YK_NO_ASSEMBLY : status;
}

static YkStatus make_state(const Made *m, const YkState *as, YkMechanism **mech, YkState **state)
{
    *mech = compile_as(m, as->mech);
    if (!*mech) return yk_problems_ran_out(m->problems) ? YK_NO_MEMORY : YK_BAD_MODEL;
    *state = yk_state_new(*mech);
    return *state ? stand_as(*state, as) : YK_NO_MEMORY;
}

// Assembles by the start's inputs if these differ, then takes that pose.
static YkStatus make(const YkRemake *r, const double *values, Made *m)
{
    m->problems = yk_problems_new();
    if (!m->problems) return YK_NO_MEMORY;
    m->model = read_with(r, values, m);
    if (!m->model) return yk_problems_ran_out(m->problems) ? YK_NO_MEMORY : YK_BAD_MODEL;
    if (!r->start) return make_state(m, r->state, &m->mech, &m->state);
    YkStatus status = make_state(m, r->start, &m->base_mech, &m->base);
    if (status < 0) return status;
    m->mech = compile_as(m, r->state->mech);
    if (!m->mech) return yk_problems_ran_out(m->problems) ? YK_NO_MEMORY : YK_BAD_MODEL;
    m->state = yk_state_new(m->mech);
    if (!m->state) return YK_NO_MEMORY;
    return is_alike(m->mech, r->state->mech) ? yk_state_adopt(m->state, m->base) : YK_BAD_MODEL;
}

static void end(Made *m)
{
    yk_state_free(m->state);
    yk_state_free(m->base);
    yk_mechanism_free(m->mech);
    yk_mechanism_free(m->base_mech);
    yk_model_free(m->model);
    yk_problems_free(m->problems);
}

// --- one design

// Solves the poses of one machine, by the study of a single design without parameters.
static YkStatus solve(YkWorker *w, const YkJob *job, const Made *m, size_t design)
{
    const YkStudy *study = w->study;
    size_t n = job->asked->pose_count, at = design * n;
    YkStudyOptions options = {.channels = study->channels,
                              .channel_count = study->channel_count,
                              .threads = 1,
                              .progress = m->progress,
                              .follows_time = study->follows_time};
    YkStudy *one = yk_study_new(m->state, &options, NULL);
    if (!one) return YK_NO_MEMORY;
    YkStudyCase asked = {.design_count = 1, .inputs = w->inputs, .pose_count = n, .times = w->times};
    YkStatus status;
    if (job->extents) {
        signed char worst = YK_OK;
        yk_study_reduce(one, &asked, w->extent, &worst, job->standing ? job->standing + design : NULL);
        status = (YkStatus)worst;
    } else {
        for (size_t c = 0; c < study->channel_count; c++) w->outputs[c] = job->outputs[c] + at;
        status = yk_study_run(one, &asked, w->outputs, job->status ? job->status + at : NULL);
    }
    yk_study_free(one);
    return status;
}

// Writes that a design has no pose.
static void leave_out(YkWorker *w, const YkJob *job, size_t design, YkStatus status)
{
    size_t n = job->asked->pose_count, channels = w->study->channel_count;
    memset(w->extent, 0, channels * sizeof *w->extent);
    if (job->standing) job->standing[design] = 0;
    for (size_t c = 0; !job->extents && c < channels; c++) memset(job->outputs[c] + design * n, 0, n * sizeof(double));
    if (!job->extents && job->status) memset(job->status + design * n, status, n);
}

YkStatus yk_remake_design(YkWorker *w, const YkJob *job, size_t design)
{
    Made m = {.progress = yk_pace_within(&w->pace)};
    YkStatus status = make(w->study->remake, w->value, &m);
    bool is_made = status >= 0;
    if (is_made) status = solve(w, job, &m, design);
    if (w->pace.is_stopped) status = YK_STOPPED;
    if (!is_made || status == YK_STOPPED || status == YK_NO_MEMORY) leave_out(w, job, design, status);
    for (size_t c = 0; job->extents && c < w->study->channel_count; c++)
        job->extents[c * job->asked->design_count + design] = w->extent[c];
    if (job->extents && job->status) job->status[design] = (signed char)status;
    end(&m);
    return status;
}
