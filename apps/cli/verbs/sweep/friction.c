// Rows of a sweep in which the machine stands under dry friction, so that an effort is not unique.
#include "verbs/sweep/sweep.h"
#include "write/amount.h"

double yk_sweep_place(const YkSweepAnswer *answer, const YkState *state)
{
    int swept = answer->over.coordinate;
    return swept >= 0 ? yk_state_coordinate(state, (size_t)swept).position : yk_state_time(state);
}

void yk_sweep_look_at_friction(void *context, const YkState *state)
{
    YkSweepAnswer *answer = context;
    const YkDynamics *dynamics = answer->session->dynamics;
    if (!dynamics || !yk_state_has_rates(state)) return;
    for (size_t c = 0; c < answer->column_count; c++) {
        YkChannel channel = answer->columns[c].channel;
        if (channel.kind != YK_CHANNEL_EFFORT) continue;
        YkEffortRange range = yk_dynamics_effort_range(dynamics, (size_t)channel.index);
        if (range.is_single || answer->held[c].rows++ > 0) continue;
        answer->held[c].at = yk_sweep_place(answer, state);
        answer->held[c].range = range;
    }
}

static void warn(const YkSweepAnswer *answer, const YkAnswerColumn *column, const YkHeldColumn *held)
{
    YkSession *session = answer->session;
    YkText range = {0}, at = {0};
    YkQuantity quantity = column->channel.quantity;
    if (held->range.is_known) {
        yk_text_puts(&range, " (");
        yk_amount_between(&range, yk_shown(session, held->range.low, quantity),
                          yk_shown(session, held->range.high, quantity), YK_DIGITS);
        yk_text_format(&range, " %s)", yk_unit_of(session, quantity));
    }
    yk_add_value(session, &at, held->at, answer->over.quantity, YK_DIGITS);
    yk_problem(session->problems, YK_CODE_EFFORT_RANGE, (YkPlace){0},
               "in %z row%s the machine stands under dry friction: every effort of a range holds it, and %q has no "
               "single value; first at %s = %s%s",
               held->rows, held->rows == 1 ? "" : "s", column->name, answer->over.name, yk_text_get(&at),
               yk_text_get(&range));
    yk_problem_hint(session->problems, "--of %s.from,%s.to gives the range; --rate makes the machine move",
                    column->name, column->name);
    session->out.failed |= at.failed || range.failed;
    yk_text_free(&at);
    yk_text_free(&range);
}

void yk_sweep_warn_of_friction(const YkSweepAnswer *answer)
{
    for (size_t c = 0; answer->held && c < answer->column_count; c++)
        if (answer->held[c].rows > 0) warn(answer, &answer->columns[c], &answer->held[c]);
}
