// Reads the request for a study: which parameters vary and how, at which poses, with which columns.
#include <string.h>
#include "columns.h"
#include "reach.h"
#include "session.h"
#include "stop.h"
#include "verbs/study/study.h"

enum { DESIGNS = 1000, STEPS_MAX = 1000000, STEPS = 36 };

// Rows that stay in memory are fewer than those that go to a file.
static const uint64_t designs_in_memory = 10000000, designs_in_file = 1000000000000;

static size_t most_designs(const YkRequest *request)
{
    uint64_t most = yk_partial_is_kept(request) ? designs_in_file : designs_in_memory;
    return most < SIZE_MAX ? (size_t)most : SIZE_MAX;
}

static bool refuse_many(const YkStudyAnswer *answer, const char *what)
{
    YkSession *session = answer->session;
    bool is_kept = yk_partial_is_kept(session->request);
    yk_problem(session->problems, YK_CODE_OPTION_VALUE, (YkPlace){0}, "%s has more than %s designs", what,
               is_kept ? "a million million" : "10 million");
    if (!is_kept) yk_problem_hint(session->problems, "with -o FILE a study may have a million million");
    return false;
}

// --- --vary NAME=FROM:TO:N

static bool refuse_vary(YkSession *session, const char *text)
{
    yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--vary takes NAME=FROM:TO:N, not %q", text);
    yk_problem_hint(session->problems, "as in --vary l2=0.9m:1.1m:200; N values, both ends included");
    return false;
}

static bool read_value(YkSession *session, const char *name, const char *text, double *value)
{
    YkProblems *problems = yk_session_file_problems(session);
    bool good = problems && yk_model_parameter_read(session->model, name, text, value, problems) == YK_OK;
    yk_tell_problems(session, problems);
    yk_problems_free(problems);
    session->is_told |= !good;
    return good;
}

static bool read_axis(YkStudyAnswer *answer, const char *text, YkAxis *axis)
{
    YkSession *session = answer->session;
    YkArena *arena = session->request->arena;
    const char *equals = strchr(text, '='), *first = equals ? strchr(equals, ':') : NULL,
               *second = first ? strchr(first + 1, ':') : NULL;
    if (!second || equals == text) return refuse_vary(session, text);
    const char *name = yk_arena_copy(arena, text, (size_t)(equals - text)),
               *from = yk_arena_copy(arena, equals + 1, (size_t)(first - equals - 1)),
               *to = yk_arena_copy(arena, first + 1, (size_t)(second - first - 1));
    if (!name || !from || !to) return yk_session_refuse_for_memory(session);
    *axis = (YkAxis){.name = name};
    return yk_session_count(session, "--vary", second + 1, most_designs(session->request), 1, &axis->count) &&
           read_value(session, name, from, &axis->from) && read_value(session, name, to, &axis->to);
}

static bool read_grid(YkStudyAnswer *answer)
{
    const YkWords *vary = &answer->session->request->vary;
    double designs = 1;
    answer->axes = yk_session_alloc(answer->session, vary->count + 1, sizeof *answer->axes);
    answer->axis_count = vary->count;
    for (size_t k = 0; answer->axes && k < vary->count; k++) {
        if (!read_axis(answer, vary->items[k], &answer->axes[k])) return false;
        designs *= (double)answer->axes[k].count;
    }
    if (designs > (double)most_designs(answer->session->request)) return refuse_many(answer, "--vary: the grid");
    answer->design_count = (size_t)designs;
    return answer->axes != NULL;
}

// --- --sample FILE

static bool read_sample(YkStudyAnswer *answer)
{
    YkSession *session = answer->session;
    const YkRequest *request = session->request;
    YkProblems *problems = yk_problems_new();
    answer->is_sample = true;
    answer->tolerances = problems ? yk_tolerances_load(request->sample, session->model, problems) : NULL;
    yk_tell_problems(session, problems);
    yk_problems_free(problems);
    session->is_told |= !answer->tolerances;
    if (!answer->tolerances) return false;
    size_t designs = DESIGNS;
    uint64_t seed = 0;
    if (yk_tolerances_designs(answer->tolerances) > 0) designs = (size_t)yk_tolerances_designs(answer->tolerances);
    const size_t most = most_designs(request);
    if (!yk_session_count(session, "--designs", request->designs, most, designs, &answer->design_count)) return false;
    if (answer->design_count > most) return refuse_many(answer, "--sample: the file");
    answer->seed = yk_tolerances_seed(answer->tolerances);
    if (!yk_session_whole(session, "--seed", request->seed, (uint64_t)1 << 53, 0, &seed)) return false;
    if (request->seed) answer->seed = seed;
    answer->axis_count = yk_tolerances_count(answer->tolerances);
    answer->axes = yk_session_alloc(answer->session, answer->axis_count + 1, sizeof *answer->axes);
    for (size_t k = 0; answer->axes && k < answer->axis_count; k++)
        answer->axes[k] = (YkAxis){.name = yk_tolerances_name(answer->tolerances, k),
                                   .distribution = yk_tolerances_at(answer->tolerances, k)};
    return answer->axes != NULL;
}

YkDesigns yk_study_designs(const YkStudyAnswer *answer)
{
    return (YkDesigns){answer->axes, answer->axis_count, answer->is_sample, answer->seed};
}

// --- columns and poses

static bool read_columns(YkStudyAnswer *answer)
{
    YkAnswerColumns columns = {0};
    bool good = yk_columns_read(answer->session, &columns);
    answer->columns = columns.items;
    answer->column_count = columns.count;
    answer->has_forces = yk_columns_need_forces(&columns);
    return good;
}

// Reads the inputs at every pose: of the cycle, or the one requested. Over time all drives move, over a coordinate only
// that one; what is held stays.
static bool read_poses(YkStudyAnswer *answer, size_t steps)
{
    YkSession *session = answer->session;
    size_t inputs = yk_input_count(session->mech), n = answer->over.name ? steps + 1 : 1;
    answer->pose_count = n;
    answer->input = yk_session_alloc(answer->session, 3 * inputs * n + 1, sizeof *answer->input);
    answer->input_row = yk_session_alloc(answer->session, 3 * inputs + 1, sizeof *answer->input_row);
    bool is_time = answer->over.name && answer->over.coordinate < 0;
    if (is_time) answer->times = yk_session_alloc(answer->session, n, sizeof *answer->times);
    YkState *state = yk_session_new_state(session, session->mech);
    bool good = answer->input && answer->input_row && state && (!is_time || answer->times);
    if (!good) {
        yk_state_free(state);
        return yk_session_refuse_for_memory(session);
    }
    yk_state_copy(state, session->state);
    yk_session_hold(session, state);
    const YkOver *over = &answer->over;
    for (size_t i = 0; i < 3 * inputs; i++) answer->input_row[i] = answer->input + i * n;
    for (size_t k = 0; good && k < n; k++) {
        double at = k == steps ? over->to : over->from + (over->to - over->from) * (double)k / (double)steps;
        if (is_time) answer->times[k] = at;
        if (k == 0 || is_time) good = yk_state_set_time(state, is_time ? at : session->time, session->problems) >= 0;
        for (size_t i = 0; good && i < inputs; i++) {
            YkMotion m = yk_state_input(state, i);
            if (over->name && (int)yk_input_coordinate(session->mech, i) == over->coordinate) m.position = at;
            answer->input[(3 * i) * n + k] = m.position;
            answer->input[(3 * i + 1) * n + k] = m.velocity;
            answer->input[(3 * i + 2) * n + k] = m.acceleration;
        }
    }
    yk_state_free(state);
    return good;
}

// --- the whole

static bool missing(YkSession *session, const char *what, const char *hint)
{
    yk_session_refuse(session, YK_CODE_OPTION_MISSING, "`yoke study` needs %s", what);
    yk_problem_hint(session->problems, "%s", hint);
    return false;
}

static bool read_format(YkStudyAnswer *answer)
{
    static const char *const words[] = {"text", "json", "csv", "npy", "jsonl"};
    const YkRequest *request = answer->session->request;
    const char *output = request->output, *dot = output ? strrchr(output, '.') : NULL;
    if (!request->format_word && dot) // by the output's ending
        for (size_t k = 1; k < 5; k++)
            if (strcmp(dot + 1, words[k]) == 0) answer->format = (YkStudyFormat)k;
    if (!request->format_word) return true;
    for (size_t k = 0; k < 5; k++) {
        answer->format = (YkStudyFormat)k;
        if (strcmp(request->format_word, words[k]) == 0) return true;
    }
    return yk_session_refuse(answer->session, YK_CODE_OPTION_VALUE,
                             "--format takes text, json, jsonl, csv or npy here, not %q", request->format_word);
}

static bool check_request(YkStudyAnswer *answer)
{
    YkSession *session = answer->session;
    const YkRequest *request = session->request;
    if (!request->file) return true; // that is the error to report
    if (request->vary.count == 0 && !request->sample)
        return missing(session, "--vary or --sample", "as in --vary l2=0.9m:1.1m:200, or --sample tolerance.yaml");
    if (request->vary.count > 0 && request->sample)
        return yk_session_refuse(session, YK_CODE_OPTION_REPEATED, "give either --vary or --sample, not both%s", "");
    if (!request->of || !*request->of) return missing(session, "--of", "as in --of theta4,coupler.P.y");
    return read_format(answer);
}

static bool make_study(YkStudyAnswer *answer)
{
    YkSession *session = answer->session;
    YkChannel *channels = yk_session_alloc(answer->session, answer->column_count + 1, sizeof *channels);
    const char **names = yk_session_alloc(answer->session, answer->axis_count + 1, sizeof *names);
    YkProblems *problems = yk_session_file_problems(session);
    for (size_t c = 0; channels && c < answer->column_count; c++) channels[c] = answer->columns[c].channel;
    for (size_t k = 0; names && k < answer->axis_count; k++) names[k] = answer->axes[k].name;
    YkStudyOptions options = {.parameters = names,
                              .parameter_count = answer->axis_count,
                              .channels = channels,
                              .channel_count = answer->column_count,
                              .threads = answer->threads,
                              .start = answer->start,
                              .follows_time = answer->follows_time,
                              .progress = yk_stop_progress(session)};
    answer->timed = yk_state_new(session->mech);
    bool good = channels && names && problems && answer->timed && yk_state_copy(answer->timed, session->state) >= 0 &&
                yk_state_set_time(answer->timed, session->time, session->problems) >= 0;
    if (good) answer->study = yk_study_new(answer->timed, &options, problems);
    yk_tell_problems(session, problems);
    session->is_told |= problems && !answer->study;
    yk_problems_free(problems);
    return answer->study != NULL;
}

static bool stand(YkStudyAnswer *answer)
{
    YkSession *session = answer->session;
    YkStatus status = yk_session_stand(session, answer->over.name ? &answer->over : NULL, &answer->start);
    if (status >= 0) return true;
    answer->start_status = status;
    yk_note_status(session, status);
    yk_tell_status(session, status, yk_reach_message(session));
    return false;
}

bool yk_study_read(YkStudyAnswer *answer)
{
    YkSession *session = answer->session;
    const YkRequest *request = session->request;
    size_t steps = STEPS;
    bool good = check_request(answer);
    good = good && (!request->over || yk_over_split(session, request->over, &answer->over));
    good = good && yk_session_count(session, "--steps", request->steps, STEPS_MAX, STEPS, &steps);
    good = good && yk_session_threads(session, &answer->threads);
    const char *swept = answer->over.name && strcmp(answer->over.name, "t") != 0 ? answer->over.name : NULL;
    good = good && yk_session_load(session, swept) && yk_session_inputs(session);
    good = good && (!answer->over.name || yk_over_read(session, &answer->over));
    good = good && read_columns(answer) && (request->sample ? read_sample(answer) : read_grid(answer));
    if (good && answer->has_forces) good = yk_session_forces(session, true) && yk_session_has_forces(session);
    return good && stand(answer) && read_poses(answer, steps) && yk_study_check_turns(answer) && make_study(answer);
}
