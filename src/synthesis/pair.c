// Judges a pair of dyads through positions of their coupler, driven from the better side.
#include <math.h>
#include <string.h>
#include "synthesis/synthesis.h"

// Fills the input's angles at the positions: on and on in one sense (+1, -1), or each the nearest way (0). Returns
// false if going on and on takes more than a turn.
static bool fill_inputs(const YkDesign *design, const YkPair *pair, int sense, double *input)
{
    for (size_t k = 0; k < pair->count; k++) {
        double angle[3];
        yk_design_angles(design, pair->pose[k], angle);
        input[k] = angle[0];
        if (k == 0) continue;
        double step = yk_remainder(angle[0] - input[k - 1], 2 * YK_PI);
        if (sense != 0 && step * sense < 0) step += sense * 2 * YK_PI;
        input[k] = input[k - 1] + step;
    }
    return sense == 0 || fabs(input[pair->count - 1] - input[0]) < 2 * YK_PI;
}

typedef struct Attempt {
    YkDefect defect;
    YkDesign design;
    YkVerdict verdict;
    YkText text;
    double input[YK_PAIR_POSES];
} Attempt;

// Tries one machine with one side driven, in each sense.
static void attempt(YkSynthesis *s, const YkDesign *design, const YkPair *pair, Attempt *trial)
{
    double *input = trial->input, angle[YK_PAIR_POSES][3];
    YkVec at[YK_PAIR_POSES];
    bool turns = s->task->turns || pair->turns;
    YkJourney journey = {.task = s->task, .input = input, .count = pair->count, .turns = turns, .exact = true};
    for (size_t k = 0; k < pair->count; k++) at[k] = pair->pose[k].at;
    if (pair->is_motion) {
        const YkMotionTask *motion = &s->task->motion;
        journey.pose = pair->pose;
        journey.rates = motion->conditions - motion->count;
        journey.rate_of = motion->rate_of;
    } else {
        journey.point = journey.path = at;
    }
    trial->design = *design;
    trial->defect = yk_design_bounds(design, s->task);
    for (size_t k = 0; k < pair->count; k++) yk_design_angles(design, pair->pose[k], angle[k]);
    if (trial->defect == YK_DEFECT_NONE) trial->defect = yk_design_signs(design, angle, pair->count);
    if (trial->defect == YK_DEFECT_NONE && turns && !yk_design_turns(design)) trial->defect = YK_DEFECT_INPUT;
    if (trial->defect != YK_DEFECT_NONE) return;
    static const int in_order[] = {1, -1}, anyhow[] = {0, 1, -1};
    size_t senses = s->task->any_order ? 3 : 2;
    YkDefect best = YK_DEFECT_ORDER;
    for (size_t k = 0; k < senses; k++) {
        if (!fill_inputs(design, pair, s->task->any_order ? anyhow[k] : in_order[k], input)) continue;
        best = yk_synthesis_try(s, design, &journey, &trial->text, &trial->verdict);
        if (best == YK_DEFECT_NONE || best > YK_DEFECT_ORDER || s->failed) break;
    }
    // Between dead points and on one circuit: if it can pass the positions somehow, only their order is wrong.
    if (best == YK_DEFECT_BRANCH && !s->task->any_order && fill_inputs(design, pair, 0, input)) {
        YkVerdict verdict;
        if (yk_synthesis_try(s, design, &journey, &trial->text, &verdict) != YK_DEFECT_BRANCH) best = YK_DEFECT_ORDER;
    }
    trial->defect = best;
}

// Returns whether a trial is to be preferred to one of the other side.
static bool is_better(const Attempt *trial, const Attempt *other)
{
    bool good = trial->defect == YK_DEFECT_NONE, other_good = other->defect == YK_DEFECT_NONE;
    if (good && other_good) return trial->verdict.transmission[0] > other->verdict.transmission[0];
    return good || (!other_good && trial->defect > other->defect);
}

static void keep_angles(YkSynthesis *s, const YkPair *pair, const Attempt *trial, YkFound *found)
{
    double *angle = found && !pair->is_motion ? YK_NEW(s->arena, double, pair->count) : NULL;
    if (!angle) return;
    memcpy(angle, trial->input, pair->count * sizeof *angle);
    found->angle = angle;
}

void yk_synthesis_take_pair(YkSynthesis *s, const YkPair *pair)
{
    Attempt trial[YK_SIDES] = {{.defect = YK_DEFECT_NONE}};
    int best = -1;
    for (int side = 0; side < YK_SIDES; side++) {
        YkDesign design;
        if (!pair->may_drive[side]) continue;
        bool is_there = yk_design_of_dyads(&pair->pose[0], &pair->dyad[side], &pair->dyad[1 - side], &design);
        design.dyad[0] = pair->index[side];
        design.dyad[1] = pair->index[1 - side];
        if (is_there) {
            attempt(s, &design, pair, &trial[side]);
        } else {
            trial[side].design = design;
            trial[side].defect = YK_DEFECT_ASSEMBLY;
        }
        if (best < 0 || is_better(&trial[side], &trial[best])) best = side;
    }
    const Attempt *taken = best >= 0 ? &trial[best] : NULL;
    if (taken && taken->defect == YK_DEFECT_NONE) {
        double merit = taken->verdict.transmission[0];
        keep_angles(s, pair, taken, yk_synthesis_keep(s, &taken->design, &taken->text, &taken->verdict, merit));
    } else if (taken) {
        yk_synthesis_leave(s, &taken->design, taken->defect, &taken->verdict);
    }
    for (int side = 0; side < YK_SIDES; side++) yk_text_free(&trial[side].text);
}
