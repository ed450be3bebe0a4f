// Warns if `start:` and a drive give a coordinate two values: the drive's counts, from the start on.
#include "idle_starts.h"
#include <math.h>
#include "answer.h"
#include "model/model.h"

// A value that was rounded to a few digits is the same: relative to a radian or the machine's size, and of a rate.
static const double rounding = 1e-3;
static const double full_turn = 6.28318530717958647692;

static bool is_other(const YkSession *session, const YkStart *start, bool is_distance, double driven)
{
    double off = start->value - driven;
    if (start->is_rate) return !(fabs(off) <= rounding * fmax(fabs(start->value), fabs(driven)));
    if (is_distance) return !(fabs(off) <= rounding * yk_mechanism_size(session->mech));
    return !(fabs(off - full_turn * rint(off / full_turn)) <= rounding);
}

static void warn(YkSession *session, const YkStart *start, const YkCoordinate *coordinate, double driven)
{
    YkText words = {0};
    YkQuantity quantity = yk_quantity_of(coordinate->is_distance, start->is_rate);
    const char *rate = start->is_rate ? ".rate" : "";
    yk_text_format(&words, "%q is driven, so its value here, ", coordinate->name);
    yk_add_value(session, &words, start->value, quantity, YK_DIGITS);
    yk_text_format(&words, ", is not used: at t = 0 its drive has %s%s = ", coordinate->name, rate);
    yk_add_value(session, &words, driven, quantity, YK_DIGITS);
    session->ran_out |= words.failed;
    yk_problem(session->problems, YK_CODE_START_UNUSED, start->place, "%s", yk_text_get(&words));
    yk_text_free(&words);
}

void yk_warn_of_idle_starts(YkSession *session)
{
    const YkModel *model = session->model;
    for (size_t k = 0; k < model->start_count; k++) {
        const YkStart *start = &model->starts[k];
        const YkCoordinate *coordinate = &model->coordinates[start->coordinate];
        YkJet jet;
        if (coordinate->drive == YK_NONE || model->drives[coordinate->drive].is_hold) continue;
        if (yk_model_drive(model, (size_t)coordinate->drive, 0, &jet, NULL) != YK_OK) continue;
        double driven = jet.d[start->is_rate];
        if (is_other(session, start, coordinate->is_distance, driven)) warn(session, start, coordinate, driven);
    }
}
