// Warns if a lock holds a coordinate at 0, because `start:` gives it no value, although gears, racks or belts put it
// elsewhere: parts on it then stand elsewhere than in the machine without the lock.
#include "held_places.h"
#include <math.h>
#include <string.h>
#include "answer.h"
#include "model/model.h"
#include "session.h"

static bool is_unplaced_hold(const YkModel *model, const YkDrive *drive)
{
    return drive->is_hold && !yk_start_of(model, drive->coordinate);
}

static void warn(YkSession *session, const YkDrive *drive, double place)
{
    const YkCoordinate *coordinate = &session->model->coordinates[drive->coordinate];
    YkText words = {0};
    yk_text_format(&words,
                   "lock %q holds %q at 0, since `start:` gives it no value; without the lock the machine starts at ",
                   session->model->engaged, coordinate->name);
    yk_add_value(session, &words, place, yk_quantity_of(coordinate->is_distance, 0), YK_DIGITS);
    session->ran_out |= words.failed;
    yk_problem(session->problems, YK_CODE_HELD_AT_ZERO, drive->place, "%s", yk_text_get(&words));
    yk_problem_hint(session->problems, "give `%s` its value under `start:`", coordinate->name);
    yk_text_free(&words);
}

// Compares with a machine that stands at its start without the lock.
static void compare(YkSession *session, const YkState *state)
{
    static const double rounding = 1e-9; // of a radian or the machine's size
    const YkModel *model = session->model;
    const YkMechanism *mech = yk_state_mechanism(state);
    for (size_t k = 0; k < model->drive_count; k++) {
        const YkDrive *drive = &model->drives[k];
        if (!is_unplaced_hold(model, drive)) continue;
        const YkCoordinate *coordinate = &model->coordinates[drive->coordinate];
        size_t own = yk_coordinate_find(mech, coordinate->name);
        double place = own == YK_NOT_FOUND ? 0 : yk_state_coordinate(state, own).position;
        if (fabs(place) > rounding * (coordinate->is_distance ? yk_mechanism_size(mech) : 1))
            warn(session, drive, place);
    }
}

void yk_warn_of_held_places(YkSession *session)
{
    const YkModel *model = session->model;
    bool any = false;
    for (size_t k = 0; k < model->drive_count; k++) any = any || is_unplaced_hold(model, &model->drives[k]);
    if (!any) return;
    YkLoadOptions options;
    YkProblems *quiet = yk_problems_new();
    const char *text = yk_model_text(model);
    YkModel *loose = NULL; // without the lock
    if (quiet && text && yk_session_load_options(session, true, &options)) {
        options.lock = NULL;
        loose = yk_model_parse(text, strlen(text), "", &options, quiet);
    }
    YkMechanism *mech = loose ? yk_mechanism_compile(loose, NULL, quiet) : NULL;
    YkState *state = mech ? yk_state_new(mech) : NULL;
    if (!mech ? yk_ran_out(quiet) : !state) yk_session_run_out(session);
    if (state && yk_state_set_time(state, 0, NULL) >= 0 && yk_state_assemble(state) >= 0) compare(session, state);
    yk_state_free(state);
    yk_mechanism_free(mech);
    yk_model_free(loose);
    yk_problems_free(quiet);
}
