// Explains why the machine cannot get to the requested pose.
#include <math.h>
#include "answer.h"
#include "reach.h"
#include "roll.h"
#include "stop.h"

enum { RANGES_MAX = 32, INPUTS_MAX = 3 };
static const double full_turn = 6.28318530717958647692;

static YkCoordinateInfo info_of(const YkSession *session, size_t input)
{
    return yk_coordinate_info(session->mech, yk_input_coordinate(session->mech, input));
}

static void add_input(const YkSession *session, YkText *text, size_t input, double value, int digits)
{
    YkCoordinateInfo info = info_of(session, input);
    yk_text_format(text, "%s = ", info.name);
    yk_add_value(session, text, value, yk_quantity_of(info.is_distance, 0), digits);
}

// Writes "theta4 = 54.9 deg", for up to three inputs.
static void add_inputs(const YkSession *session, YkText *text, const YkState *state, bool asked)
{
    size_t count = yk_input_count(session->mech);
    for (size_t i = 0; i < count && i < INPUTS_MAX; i++) {
        double here = asked ? yk_state_input(state, i).position
                            : yk_state_coordinate(state, yk_input_coordinate(session->mech, i)).position;
        yk_text_puts(text, i > 0 ? ", " : "");
        add_input(session, text, i, here, asked ? YK_DIGITS : 10);
    }
    if (count > INPUTS_MAX) yk_text_puts(text, ", ...");
}

void yk_reach_word_stop(YkSession *session)
{
    YkText *text = &session->reach_message;
    const YkMove *move = &session->move;
    if (move->status == YK_LIMIT && move->block >= 0) {
        YkBlockInfo block = yk_block_info(session->mech, (size_t)move->block);
        yk_text_puts(text, "the way from `start:` ends at ");
        add_inputs(session, text, session->state, false);
        yk_text_format(text, ": beyond, joint %q (%s) does not close", block.label, yk_block_kind_name(block.kind));
    } else {
        yk_text_puts(text, yk_state_report(session->state)->message);
    }
}

const char *yk_reach_message(const YkSession *session)
{
    if (yk_text_has_some(&session->reach_message)) return yk_text_get(&session->reach_message);
    return yk_state_report(session->state)->message;
}

YkStatus yk_reach_ask(YkSession *session)
{
    YkState *state = yk_session_new_state(session, session->mech);
    if (!state) {
        yk_session_run_out(session);
        return YK_NO_MEMORY;
    }
    yk_session_hold(session, state);
    YkStatus status = yk_state_set_time(state, session->time, session->problems);
    yk_state_free(session->state);
    session->state = state;
    return status;
}

static bool count_one(void *context, YkState *state)
{
    (void)state;
    ++*(size_t *)context;
    return true;
}

static void add_range(YkSession *session, YkText *text, size_t input, YkRange range)
{
    YkCoordinateInfo info = info_of(session, input);
    YkText label = yk_label_of(session->state);
    yk_text_format(text, "this configuration (%s) closes for %s from ", yk_text_get(&label), info.name);
    yk_add_value(session, text, range.from, yk_quantity_of(info.is_distance, 0), YK_DIGITS);
    yk_text_puts(text, " to ");
    yk_add_value(session, text, range.to, yk_quantity_of(info.is_distance, 0), YK_DIGITS);
    yk_text_free(&label);
}

// Hints at the range of the machine's only input, and at the detour to an angle a turn away.
static void hint_range(YkSession *session, YkText *text, double asked)
{
    YkRange ranges[RANGES_MAX];
    size_t coordinate = yk_input_coordinate(session->mech, 0);
    double here = yk_state_coordinate(session->state, coordinate).position;
    size_t count = yk_closing_ranges(session->state, coordinate, ranges, RANGES_MAX);
    session->ran_out |= count == YK_NOT_FOUND;
    if (session->ran_out) return;
    for (size_t k = 0; k < count && k < RANGES_MAX; k++) {
        YkRange r = ranges[k];
        if (here < r.from - 1e-6 || here > r.to + 1e-6) continue;
        add_range(session, text, 0, r);
        double other = asked - full_turn * rint((asked - 0.5 * (r.from + r.to)) / full_turn);
        if (!info_of(session, 0).is_distance && other != asked && other >= r.from && other <= r.to) {
            yk_text_puts(text, "; the other way round it comes to ");
            add_input(session, text, 0, other, YK_DIGITS);
        }
        yk_text_puts(text, "; ");
        return;
    }
}

// Returns a state with the requested inputs and no pose; NULL if there is none.
static YkState *asked_state(YkSession *session)
{
    YkState *state = yk_session_new_state(session, session->mech);
    if (!state) yk_session_run_out(session);
    if (!state) return NULL;
    yk_session_hold(session, state);
    if (yk_state_set_time(state, session->time, NULL) >= 0) return state;
    yk_state_free(state);
    return NULL;
}

size_t yk_reach_count(YkSession *session)
{
    size_t count = 0;
    YkState *state = asked_state(session);
    session->ran_out |= !state;
    if (state) yk_note_status(session, yk_session_each(session, state, count_one, &count, NULL));
    yk_state_free(state);
    return count;
}

// Hints at what closes at the requested pose, and at the command that shows it.
static void hint_others(YkSession *session, const YkState *asked, YkText *text)
{
    size_t count = yk_reach_count(session);
    yk_text_puts(text, "at ");
    add_inputs(session, text, asked, true);
    if (count == 0)
        yk_text_puts(text, " no configuration closes");
    else
        yk_text_format(text, " %z other configuration%s: `yoke solve --all` shows %s, `--assembly 1` takes %s", count,
                       count == 1 ? " closes" : "s close", count == 1 ? "it" : "them", count == 1 ? "it" : "the first");
}

void yk_reach_tell(YkSession *session, YkStatus status)
{
    YkText hint = {0};
    if (session->request->assembly && yk_text_has_some(&session->reach_message))
        return; // reported, with the names that exist
    yk_tell_status(session, status, yk_reach_message(session));
    YkState *asked = status == YK_LIMIT || status == YK_STOPPED ? asked_state(session) : NULL;
    if (!asked || session->request->assembly) {
        yk_state_free(asked);
        return;
    }
    if (yk_input_count(session->mech) == 1 && session->move.status == YK_LIMIT)
        hint_range(session, &hint, yk_state_input(asked, 0).position);
    hint_others(session, asked, &hint);
    yk_state_free(asked);
    if (hint.failed) yk_session_run_out(session);
    if (hint.length > 0 && !hint.failed) yk_problem_hint(session->problems, "%s", yk_text_get(&hint));
    yk_text_free(&hint);
}
