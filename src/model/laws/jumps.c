// Checks the fundamental law of cam design: a motion needs a continuous position, and should have continuous velocity
// and acceleration. Reports jumps where the segments meet, with their size.
#include "model/laws/read.h"

enum { JUMPS_MAX = 100 };

// Returns the place of the segment that begins at x or contains it; a table has one place for the whole.
static YkPlace place_at(const YkModelLaw *law, double x)
{
    size_t count = yk_law_segment_count(law->law), i = 0;
    if (law->source->part_count != count) return law->place;
    while (i + 1 < count && yk_law_segment(law->law, i).to <= x) i++;
    return law->source->parts[i].place;
}

static void report_value(YkLoader *loader, const YkModelLaw *law, const YkLawJump *jump)
{
    YkAmount at = yk_load_law_place(loader->model, law, jump->x);
    YkAmount size = yk_load_law_amount(loader->model, law, jump->size, 0);
    YkLawRange range = yk_law_range(law->law);
    if (range.period > 0 && jump->x == range.from) {
        yk_problem(loader->problems, YK_CODE_LAW_JUMP, law->place,
                   "law %q does not return: from the end of its period to its start it jumps by %s", law->name,
                   size.text);
        return;
    }
    yk_problem(loader->problems, YK_CODE_LAW_JUMP, place_at(law, jump->x), "the value of law %q jumps by %s at %s",
               law->name, size.text, at.text);
}

static void report_derivative(YkLoader *loader, const YkModelLaw *law, const YkLawJump *jump)
{
    YkAmount at = yk_load_law_place(loader->model, law, jump->x);
    YkAmount size = yk_load_law_amount(loader->model, law, jump->size, jump->order);
    yk_problem(loader->problems, jump->order == 1 ? YK_CODE_LAW_JUMP_VELOCITY : YK_CODE_LAW_JUMP_ACCELERATION,
               place_at(law, jump->x), "the %s of law %q jumps by %s at %s",
               jump->order == 1 ? "velocity" : "acceleration", law->name, size.text, at.text);
}

void yk_load_law_report_jumps(YkLoader *loader, const YkModelLaw *law)
{
    YkLawJump jumps[JUMPS_MAX];
    size_t count = yk_law_jumps(law->law, jumps, JUMPS_MAX);
    bool moves = yk_dimension_equal(law->value, YK_DIM_LENGTH) || yk_dimension_equal(law->value, YK_DIM_ANGLE);
    bool is_judged = moves && (law->source->part_count > 0 ||
                               law->source->is_made); // corners of a table are intended, and a force may have any
    for (size_t i = 0; i < count && i < JUMPS_MAX; i++) {
        if (i > 0 && jumps[i].x == jumps[i - 1].x) continue; // the lowest order suffices
        if (jumps[i].order == 0)
            report_value(loader, law, &jumps[i]);
        else if (is_judged)
            report_derivative(loader, law, &jumps[i]);
    }
}
