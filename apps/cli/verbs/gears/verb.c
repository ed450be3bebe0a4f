// yoke gears: the speeds and torques of a gear train. It needs the model only, no pose.
#include "verbs/gears/gears.h"

static const YkPlace nowhere = {0};

// Loads only the model. Returns false if that failed, with everything printed.
static bool load(YkSession *session)
{
    if (!session->request->file) {
        yk_problem(session->problems, YK_CODE_FILE_MISSING, nowhere, "`yoke gears` needs a model file");
        yk_problem_hint(session->problems, "yoke gears train.yaml");
        return false;
    }
    YkProblems *problems = yk_problems_new();
    YkLoadOptions options;
    bool good = problems && yk_session_load_options(session, true, &options);
    if (good) options.lock = NULL; // the train engages it, or all of them one after the other
    if (good) session->model = yk_model_load(session->request->file, &options, problems);
    yk_tell_problems(session, problems);
    if (!good) yk_session_refuse_for_memory(session);
    yk_problems_free(problems);
    return session->model != NULL;
}

static bool read_efforts(YkSession *session, YkTrainEffort *efforts)
{
    const YkAssignments *pairs = &session->request->effort;
    for (size_t i = 0; i < pairs->count; i++) {
        efforts[i].coordinate = pairs->items[i].name;
        if (!yk_session_value(session, "--effort", pairs->items[i].name, pairs->items[i].value, YK_QUANTITY_TORQUE,
                              &efforts[i].value))
            return false;
    }
    return true;
}

static bool read_options(YkSession *session, YkTrainOptions *options, YkTrainEffort *efforts)
{
    const YkRequest *request = session->request;
    *options = yk_default_train_options();
    options->lock = request->lock;
    options->in = request->in;
    options->out = request->out;
    options->efforts = efforts;
    options->effort_count = request->effort.count;
    if (request->time && !yk_session_value(session, "--time", "", request->time, YK_QUANTITY_TIME, &options->time))
        return false;
    if (request->efficiency &&
        !yk_session_value(session, "--efficiency", "", request->efficiency, YK_QUANTITY_NUMBER, &options->efficiency))
        return false;
    return read_efforts(session, efforts);
}

// A train that its drives leave undetermined is not an answer; one without drives has only relations, which were asked
// for.
static int judge(YkSession *session, const YkTrain *train)
{
    YkTrainStatus status = yk_train_status(train);
    YkCode code = status == YK_TRAIN_STATUS_LOCKED ? YK_CODE_TRAIN_LOCKED : YK_CODE_TRAIN_UNDETERMINED;
    bool has_table = yk_train_gear_count(train) > 0 || yk_train_ratio(train).is_known;
    if (status == YK_TRAIN_STATUS_OK || status == YK_TRAIN_STATUS_FREE) return YK_EXIT_DONE;
    if (status == YK_TRAIN_STATUS_UNDETERMINED && has_table) return YK_EXIT_DONE; // each row reports its own status
    if (yk_gears_leave_drives_out(session, train)) return YK_EXIT_DONE;
    yk_problem(session->problems, code, nowhere, "%s", yk_train_message(train));
    return YK_EXIT_NO_ANSWER;
}

static void write_answer(const YkGearsAnswer *answer)
{
    switch (answer->session->request->format) {
    case YK_FORMAT_TEXT:
        yk_gears_text(answer);
        break;
    case YK_FORMAT_JSON:
        yk_gears_json(answer);
        break;
    case YK_FORMAT_CSV:
        yk_gears_csv(answer);
        break;
    }
}

int yk_run_gears(YkSession *session)
{
    int exit_code = YK_EXIT_WRONG;
    if (!load(session)) return exit_code;
    YkTrainEffort *efforts = yk_session_alloc(session, session->request->effort.count + 1, sizeof *efforts);
    YkTrainOptions options;
    if (!efforts) {
        yk_session_refuse_for_memory(session);
    } else if (read_options(session, &options, efforts)) {
        YkTrain *train = yk_train_new(session->model, &options, session->problems);
        if (train) {
            write_answer(&(YkGearsAnswer){session, train});
            exit_code = yk_session_finish(session, judge(session, train));
        }
        yk_train_free(train);
    }
    return exit_code;
}
