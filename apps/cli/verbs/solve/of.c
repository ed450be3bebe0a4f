// Writes the columns of `solve --of`, in each format.
#include <string.h>
#include "columns.h"
#include "verbs/solve/solve.h"
#include "write/amount.h"
#include "write/csv.h"
#include "write/table.h"

void yk_solve_of_warn(YkSession *session)
{
    for (size_t c = 0; session->columns && session->dynamics && c < session->columns->count; c++) {
        const YkAnswerColumn *column = &session->columns->items[c];
        YkQuantity quantity = column->channel.quantity;
        if (column->channel.kind != YK_CHANNEL_EFFORT) continue;
        YkEffortRange range = yk_dynamics_effort_range(session->dynamics, (size_t)column->channel.index);
        if (range.is_single) continue;
        YkText words = {0};
        if (range.is_known)
            yk_amount_between(&words, yk_shown(session, range.low, quantity), yk_shown(session, range.high, quantity),
                              YK_DIGITS);
        else
            yk_text_puts(&words, "not found, in");
        yk_problem(
            session->problems, YK_CODE_EFFORT_RANGE, (YkPlace){0},
            "the machine stands under dry friction: every effort of a range holds it, and %q has no single value "
            "(%s %s)",
            column->name, yk_text_get(&words), yk_unit_of(session, quantity));
        yk_problem_hint(session->problems, "--of %s.from,%s.to gives the range; --rate makes the machine move",
                        column->name, column->name);
        session->out.failed |= words.failed;
        yk_text_free(&words);
    }
}

void yk_solve_of_text(YkSession *session, const YkState *state)
{
    YkTable *table = yk_table_new(3);
    yk_table_head(table, "column", NULL);
    yk_table_head(table, "value", NULL);
    yk_table_head(table, "unit", NULL);
    for (size_t c = 0; c < session->columns->count; c++) {
        const YkAnswerColumn *column = &session->columns->items[c];
        double value = yk_column_value(session, state, column->channel);
        yk_table_word(table, column->name);
        yk_table_number(table, yk_column_shown(session, value, column->channel), YK_DIGITS);
        yk_table_word(table, yk_unit_of(session, column->channel.quantity));
    }
    yk_text_puts(&session->out, "\n");
    if (!yk_table_write(table, 2, &session->out)) session->out.failed = true;
    yk_table_free(table);
}

// Returns whether the column's name is one of those before it: an object has each key once.
static bool is_repeated(const YkAnswerColumns *columns, size_t index)
{
    for (size_t c = 0; c < index; c++)
        if (strcmp(columns->items[c].name, columns->items[index].name) == 0) return true;
    return false;
}

void yk_solve_of_json(YkSession *session, YkJson *json, const YkState *state)
{
    const YkAnswerColumns *columns = session->columns;
    yk_json_object(json, "of", YK_JSON_INLINE);
    for (size_t c = 0; c < columns->count; c++)
        if (!is_repeated(columns, c))
            yk_json_number(json, columns->items[c].name, yk_column_value(session, state, columns->items[c].channel));
    yk_json_end(json);
}

void yk_solve_of_csv_head(YkSession *session)
{
    YkCsv csv = {.text = &session->out};
    yk_csv_name(&csv, "configuration");
    for (size_t c = 0; c < session->columns->count; c++) yk_csv_name(&csv, session->columns->items[c].name);
    yk_csv_row(&csv);
}

void yk_solve_of_csv(YkSession *session, const YkState *state)
{
    YkText label = yk_label_of(state);
    YkCsv csv = {.text = &session->out};
    yk_csv_name(&csv, yk_text_get(&label));
    for (size_t c = 0; c < session->columns->count; c++)
        yk_csv_number(&csv, yk_column_value(session, state, session->columns->items[c].channel));
    yk_csv_row(&csv);
    yk_text_free(&label);
}
