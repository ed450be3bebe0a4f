// Moves the machine from the pose in which it was assembled to the requested one.
#include "reach.h"
#include "answer.h"
#include "certify.h"
#include "stop.h"

static YkStatus run_out(YkSession *session)
{
    yk_session_run_out(session);
    yk_text_puts(&session->reach_message, "out of memory");
    return YK_NO_MEMORY;
}

// --- where the machine was assembled

// Returns the state of a mechanism at t = 0, assembled nearest to the guesses of `start:`; NULL when out of memory.
static YkState *assemble(const YkSession *session, const YkMechanism *mech, YkStatus *status)
{
    YkState *state = yk_session_new_state(session, mech);
    if (!state) return NULL;
    *status = yk_state_set_time(state, 0, NULL);
    if (*status >= 0) *status = yk_state_assemble(state);
    return state;
}

// Assembles the file's own machine when --param gives other parameters. Returns NULL if the file's make no valid
// machine, or one that cannot be assembled.
static YkState *assemble_own(YkSession *session, YkMechanism **mech)
{
    YkProblems *quiet = yk_problems_new();
    YkStatus status = YK_BAD_MODEL;
    if (!session->own && quiet) session->own = yk_session_load_model(session, false, quiet);
    YkCompileOptions options = yk_default_compile_options();
    options.progress = yk_stop_progress(session);
    *mech = session->own && quiet ? yk_mechanism_compile(session->own, &options, quiet) : NULL;
    YkState *state = *mech ? assemble(session, *mech, &status) : NULL;
    if (!*mech ? yk_ran_out(quiet) : !state) yk_session_run_out(session);
    yk_problems_free(quiet);
    if (status >= 0) return state;
    yk_state_free(state);
    return NULL;
}

// Moves all parameters at once from the file's to the command line's, with the assembly. Returns false if they do not
// vary continuously, such as numbers of teeth.
static bool carry(YkSession *session, YkState *own, YkState *state, YkStatus *status)
{
    const YkAssignments *param = &session->request->param;
    size_t count = param->count, inputs = yk_input_count(session->mech);
    const char **names = yk_session_alloc(session, count + 1, sizeof *names);
    double *from = yk_session_alloc(session, 2 * count + 1, sizeof *from);
    YkMotion *goal = yk_session_alloc(session, inputs + 1, sizeof *goal);
    bool good = names && from && goal && yk_input_count(yk_state_mechanism(own)) == inputs;
    for (size_t k = 0; good && k < count; k++) {
        names[k] = param->items[k].name;
        from[k] = yk_model_parameter(session->own, names[k]);
        from[count + k] = yk_model_parameter(session->model, names[k]);
    }
    for (size_t i = 0; good && i < inputs; i++) goal[i] = yk_state_input(state, i);
    YkProblems *quiet = yk_problems_new();
    YkVariant *variant = good && quiet ? yk_variant_new(yk_state_mechanism(own), names, count, quiet) : NULL;
    YkState *moving = variant ? yk_session_new_state(session, yk_variant_mechanism(variant)) : NULL;
    if (!names || !from || !goal || (variant ? !moving : good && yk_ran_out(quiet))) yk_session_run_out(session);
    yk_problems_free(quiet);
    good = moving && yk_state_adopt(moving, own) >= 0;
    if (good) *status = yk_state_carry(moving, variant, from, from + count, count, goal);
    if (good && *status >= 0) *status = yk_state_adopt(state, moving);
    yk_state_free(moving);
    yk_variant_free(variant);
    return good;
}

// Takes the configuration that the file has at its own parameters, with those of the command line.
static YkStatus take_own(YkSession *session, YkState *own, YkState *state)
{
    YkStatus status = yk_state_set_time(state, 0, NULL);
    if (status < 0) return status;
    if (yk_state_take_labels(state, own) == YK_OK) {
        status = yk_state_solve(state);
    } else if (!carry(session, own, state, &status)) {
        status = yk_state_guess(state, own);
        if (status >= 0) status = yk_state_assemble(state);
    }
    return status == YK_LIMIT ? YK_NO_ASSEMBLY : status;
}

YkState *yk_reach_start(YkSession *session, YkStatus *status)
{
    const YkMechanism *mech = session->base ? session->base : session->mech;
    YkMechanism *own_mech = NULL;
    YkState *own = session->request->param.count > 0 ? assemble_own(session, &own_mech) : NULL;
    YkState *state = own ? yk_session_new_state(session, mech) : assemble(session, mech, status);
    if (own && state) *status = take_own(session, own, state);
    yk_state_free(own);
    yk_mechanism_free(own_mech);
    return state;
}

// Returns whether a drive or `start:` gives every input a value. Otherwise the file does not say where it was
// assembled.
static bool tells_start(const YkMechanism *mech)
{
    for (size_t i = 0; i < yk_input_count(mech); i++) {
        YkCoordinateInfo info = yk_coordinate_info(mech, yk_input_coordinate(mech, i));
        if (!info.has_drive && !info.has_start) return false;
    }
    return true;
}

// --- the way from there

static void note_way(YkSession *session)
{
    const YkMove *move = &session->move;
    if (move->is_detour)
        yk_problem(session->problems, YK_CODE_WAY_ROUND, (YkPlace){0},
                   "a limit blocks the straight way from `start:`; the machine got here by a detour, through its "
                   "several inputs");
    if (move->pass_count == 0) return;
    yk_problem(session->problems, YK_CODE_WAY_CHANGE_POINT, (YkPlace){0},
               "the machine passed %z change point%s on its way from `start:`, the first of them at joint %q",
               move->pass_count, move->pass_count == 1 ? "" : "s",
               yk_block_info(session->mech, (size_t)move->passes[0].block).label);
}

// Returns whether the way leaves the start's pose.
static bool moves(const YkSession *session)
{
    for (size_t k = 0; k < session->hold_count; k++) {
        const YkInputHold *hold = &session->holds[k];
        if (hold->order == 0 && hold->value != yk_state_input(session->state, hold->input).position) return true;
    }
    return session->time != 0 || session->request->over != NULL;
}

static void warn_of_start(YkSession *session, const YkState *start)
{
    YkText label = yk_label_of(start);
    yk_problem(session->problems, YK_CODE_START_SINGULAR, (YkPlace){0},
               "the pose of `start:` is one where two configurations meet; the machine is taken to leave it as %s",
               yk_text_get(&label));
    yk_text_free(&label);
}

// Puts session->state where the machine was assembled, with the inputs of the command line.
static YkStatus enter(YkSession *session, const YkState *start)
{
    if (!session->base) {
        yk_state_copy(session->state, start);
        if (yk_state_report(start)->status == YK_SINGULAR && moves(session)) warn_of_start(session, start);
        return yk_state_report(start)->status;
    }
    YkStatus status = yk_state_adopt(session->state, start);
    if (status != YK_SINGULAR || !moves(session)) return status;
    yk_text_puts(&session->reach_message, "with these inputs the pose of `start:` is a dead point, from which two "
                                          "branches part, and the file does not say which is meant");
    return YK_LIMIT;
}

static YkStatus stand(YkSession *session, const YkState *start, YkStatus status)
{
    if (status >= 0) return enter(session, start);
    const char *why = yk_state_report(start)->message; // empty if a drive has no value, which a problem reports
    yk_text_format(&session->reach_message, "at the pose of `start:`, %s",
                   *why ? why : "a drive has no value, rate or acceleration");
    return status;
}

static YkStatus reach_from(YkSession *session, const YkState *start, YkStatus status)
{
    status = stand(session, start, status);
    if (status < 0) return status;
    yk_certify_watch(session);
    status = yk_state_reach(session->state, session->holds, session->hold_count, session->time, NULL, &session->move,
                            session->problems);
    if (status == YK_NO_MEMORY) return run_out(session);
    session->is_start = status >= 0;
    if (status < 0) yk_reach_word_stop(session);
    return status;
}

// Returns the machine where it was assembled, and a fresh session->state; NULL when out of memory. is_untold: the
// file does not say where that is.
static YkState *find_start(YkSession *session, YkStatus *status, bool *is_untold)
{
    *status = YK_NO_MEMORY;
    YkState *start = yk_reach_start(session, status), *fresh = yk_session_new_state(session, session->mech);
    if (!start || !fresh) {
        yk_state_free(start);
        yk_state_free(fresh);
        return NULL;
    }
    yk_state_free(session->state);
    session->state = fresh;
    *is_untold = (*status == YK_NO_ASSEMBLY || *status == YK_LIMIT) && session->hold_count > 0 &&
                 !tells_start(yk_state_mechanism(start));
    return start;
}

// is_untold: the file does not say where the machine was assembled, and session->state has no pose.
static YkStatus reach(YkSession *session, bool *is_untold)
{
    YkStatus status;
    YkState *start = find_start(session, &status, is_untold);
    if (!start) return run_out(session);
    if (!*is_untold) status = reach_from(session, start, status);
    yk_state_free(start);
    return status;
}

YkState *yk_reach_own(YkSession *session)
{
    YkState *asked = session->state;
    bool is_untold = false, is_start = session->is_start;
    session->state = NULL;
    YkStatus status = reach(session, &is_untold);
    YkState *own = session->state;
    session->state = asked;
    session->is_start = is_start;
    yk_text_clear(&session->reach_message);
    if (status >= 0 && !is_untold) return own;
    yk_state_free(own);
    return NULL;
}

// A range starts at its FROM.
static void hold_range(YkSession *session, const YkOver *over)
{
    if (over && over->coordinate >= 0) {
        int input = yk_coordinate_info(session->mech, (size_t)over->coordinate).input;
        session->holds[session->hold_count++] = (YkInputHold){(size_t)input, 0, over->from};
    } else if (over) {
        session->time = over->from;
    }
}

YkStatus yk_session_stand(YkSession *session, const YkOver *over, YkState **start)
{
    bool is_untold = false;
    YkStatus status;
    *start = NULL;
    hold_range(session, over);
    if (session->request->assembly) return yk_reach_choose(session);
    *start = find_start(session, &status, &is_untold);
    if (!*start) return run_out(session);
    if (!is_untold && (status < 0 || !session->base)) return stand(session, *start, status);
    if (!is_untold) return yk_state_adopt(session->state, *start); // a design may be near the file's dead point
    yk_state_free(*start);
    *start = NULL;
    return yk_reach_untold(session);
}

YkStatus yk_session_reach(YkSession *session, const YkOver *over)
{
    hold_range(session, over);
    bool is_untold = false;
    if (session->request->assembly) return yk_reach_choose(session);
    YkStatus status = reach(session, &is_untold);
    if (is_untold) return yk_reach_untold(session);
    if (status >= 0) note_way(session);
    return status;
}
