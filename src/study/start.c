// Assembles a design at the start's inputs, in the configuration that the file has at its own values.
#include <stdlib.h>
#include <string.h>
#include "study/start.h"
#include "study/study.h"

#define SAME 1e-5 // rad, or lengths over the size: at a dead point positions are known to the root of rounding

YkStatus yk_study_take_home(YkState *home, const YkState *state)
{
    yk_state_take(home, state);
    memcpy(home->input, state->valid_input, 3 * home->mech->input_count * sizeof *home->input);
    if (!home->mech->has_groups) return yk_state_solve(home);
    YkStatus status = yk_state_adopt(home, state);
    if (status < 0) return status;
    for (size_t i = 0; i < home->mech->input_count; i++) // the drives' inputs may differ from the state's
        memcpy(home->input + 3 * i, state->valid_input + 3 * i, 3 * sizeof *home->input);
    status = yk_state_solve(home);
    if (status >= 0) yk_state_refer(home);
    return status;
}

static bool start_base(YkWorker *w, const YkStudyOptions *options, YkProblems *problems)
{
    const YkState *start = options->start;
    w->base_variant = yk_variant_new(start->mech, options->parameters, options->parameter_count, problems);
    if (!w->base_variant) return false;
    w->base_home = yk_state_new(yk_variant_mechanism(w->base_variant));
    w->base = yk_state_new(yk_variant_mechanism(w->base_variant));
    if (!w->base_home || !w->base) return false;
    yk_state_lend(w->base, &w->pace);
    w->home_status = yk_study_take_home(w->base_home, start);
    return w->home_status != YK_NO_MEMORY;
}

bool yk_worker_start(YkWorker *w, const YkState *state, const YkStudyOptions *options, YkProblems *problems)
{
    w->home = yk_state_new(w->mech);
    w->begun = yk_state_new(w->mech);
    w->state = yk_state_new(w->mech);
    w->kept = yk_state_new(w->mech);
    w->goal = calloc(w->mech->input_count + 1, sizeof *w->goal);
    if (!w->home || !w->begun || !w->state || !w->kept || !w->goal) return false;
    yk_state_lend(w->begun, &w->pace);
    yk_state_lend(w->state, &w->pace);
    if (options->start && options->start->mech != state->mech && !start_base(w, options, problems)) return false;
    YkStatus status = yk_study_take_home(w->home, state);
    if (w->home_status >= 0) w->home_status = status;
    yk_state_copy(w->begun, w->home);
    return status != YK_NO_MEMORY;
}

static void goal_of(const YkState *home, YkMotion *goal)
{
    for (size_t i = 0; i < home->mech->input_count; i++)
        goal[i] = (YkMotion){home->valid_input[3 * i], home->valid_input[3 * i + 1], home->valid_input[3 * i + 2]};
}

// Keeps the labels of dyads, and carries groups along while the parameters move.
static YkStatus carry(YkWorker *w, YkVariant *variant, YkState *home, YkState *state, const double *values,
                      const YkMotion *goal)
{
    const YkMechanism *mech = state->mech;
    yk_state_copy(state, home);
    if (mech->has_groups) return yk_state_carry(state, variant, w->study->own, values, w->study->parameter_count, goal);
    for (size_t i = 0; i < mech->input_count; i++) yk_state_set_input(state, i, goal[i]);
    return yk_state_solve(state);
}

YkStatus yk_study_carry(YkVariant *variant, const YkState *home, YkState *state, const double *own,
                        const double *values, size_t count, YkMotion *goal)
{
    yk_state_copy(state, home);
    goal_of(home, goal);
    if (!state->mech->has_groups) return YK_OK;
    YkStatus status = yk_state_carry(state, variant, own, values, count, goal);
    return status == YK_LIMIT ? YK_NO_ASSEMBLY : status;
}

static bool stands_as(const YkState *a, const YkState *b)
{
    const YkMechanism *mech = a->mech;
    for (size_t c = 0; c < mech->coordinate_count; c++) {
        double off = yk_state_coordinate(a, c).position - yk_state_coordinate(b, c).position;
        off = mech->coordinates[c].is_distance ? off / mech->size : off - 2 * YK_PI * rint(off / (2 * YK_PI));
        if (!(fabs(off) < SAME)) return false;
    }
    return true;
}

// The design starts at the pose that the other inputs give. Usually the labels of the file's pose are those of the
// design's; otherwise the pose is searched for.
static YkStatus begin_at_base(YkWorker *w, const double *values)
{
    YkStatus status = yk_variant_set(w->base_variant, values);
    goal_of(w->base_home, w->goal); // the two have as many inputs
    if (status >= 0) status = carry(w, w->base_variant, w->base_home, w->base, values, w->goal);
    if (status < 0) return status == YK_LIMIT ? YK_NO_ASSEMBLY : status;
    goal_of(w->home, w->goal);
    for (size_t i = 0; i < w->mech->input_count; i++)
        w->goal[i].position = yk_state_coordinate(w->base, (size_t)w->mech->inputs[i]).position;
    status = carry(w, w->variant, w->home, w->begun, values, w->goal);
    if (status >= 0 && stands_as(w->begun, w->base))
        for (size_t c = 0; c < w->mech->coordinate_count; c++)
            w->begun->reference[c] = yk_state_coordinate(w->base, c).position;
    else if ((status = yk_variant_set(w->variant, values)) >= 0) // carrying may have stopped on the way
        status = yk_state_adopt(w->begun, w->base);
    return status == YK_SINGULAR ? YK_LIMIT
                                 : status; // two branches part there, and the file does not say which is meant
}

YkStatus yk_worker_begin(YkWorker *w, const double *values)
{
    YkStatus status = w->home_status;
    bool is_elsewhere = w->base || w->mech->has_groups; // otherwise at the file's own inputs and labels
    w->way = (YkWay){.status = YK_OK};
    if (status >= 0 && w->base) status = begin_at_base(w, values);
    if (status >= 0 && !w->base && is_elsewhere) {
        goal_of(w->home, w->goal);
        status = carry(w, w->variant, w->home, w->begun, values, w->goal);
    }
    if (status < 0) return status == YK_LIMIT && !w->base ? YK_NO_ASSEMBLY : status;
    return YK_OK;
}

YkStatus yk_worker_stand(YkWorker *w)
{
    yk_state_copy(w->state, w->begun);
    YkStatus status = YK_OK;
    if (!w->base && !w->mech->has_groups) status = yk_state_solve(w->state);
    return status < 0 ? YK_NO_ASSEMBLY : status;
}
