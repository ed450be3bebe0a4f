// Writes rows of a simulation as they are computed: lines of text or CSV to the stream, or kept for JSON and plots.
#include <string.h>
#include "base/number.h"
#include "columns.h"
#include "session.h"
#include "verbs/simulate/simulate.h"
#include "write/amount.h"
#include "write/csv.h"
#include "write/table.h"

enum { NUMBER_WIDTH = 12, GAP = 2 }; // "-1.23457e-10"

static bool keeps_rows(const YkSimulationAnswer *answer)
{
    const YkRequest *request = answer->session->request;
    return request->format == YK_FORMAT_JSON || request->plot;
}

static YkQuantity quantity_of(const YkSimulationAnswer *answer, size_t column)
{
    return column == 0 ? YK_QUANTITY_TIME : answer->columns[column - 1].channel.quantity;
}

static const char *name_of(const YkSimulationAnswer *answer, size_t column)
{
    return column == 0 ? "t" : answer->columns[column - 1].name;
}

// --- text: the width of columns is known before their rows

// Writes "theta1 [rad]" into `head`. Returns how many columns of a terminal the numbers below it take.
static size_t head_of(const YkSimulationAnswer *answer, size_t column, YkText *head)
{
    const char *unit = yk_unit_of(answer->session, quantity_of(answer, column));
    yk_text_clear(head);
    yk_text_puts(head, name_of(answer, column));
    if (*unit) yk_text_format(head, " [%s]", unit);
    size_t width = yk_text_columns(yk_text_get(head), head->length);
    return width > NUMBER_WIDTH ? width : NUMBER_WIDTH;
}

static void add_right(YkText *out, const char *word, size_t length, size_t width)
{
    size_t shown = yk_text_columns(word, length);
    yk_text_repeat(out, ' ', GAP + (width > shown ? width - shown : 0));
    yk_text_add(out, word, length);
}

static void add_text_head(YkSimulationAnswer *answer, YkText *head)
{
    YkText *out = &answer->session->out;
    yk_text_format(out, "%s: motion in time\n\n", yk_model_name(answer->session->model));
    for (size_t c = 0; c <= answer->column_count; c++) {
        size_t width = head_of(answer, c, head);
        add_right(out, yk_text_get(head), head->length, width);
    }
    yk_text_puts(out, "\n");
}

// The scale grows as rows arrive. Accelerations follow them down as well, to a tenth from row to row: a jolt hides none
// for long.
static void raise_scale(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    if (answer->row_count == 1) yk_scale_begin(session);
    session->scale.acceleration *= 0.1;
    yk_scale_add_bodies(session, yk_simulation_state(answer->simulation));
    for (size_t c = 0; c < answer->column_count; c++)
        yk_scale_add(session, answer->row[c + 1], answer->columns[c].channel.quantity);
}

static void add_text_row(YkSimulationAnswer *answer, YkText *head)
{
    YkText *out = &answer->session->out;
    raise_scale(answer);
    char number[YK_NUMBER_SIZE];
    for (size_t c = 0; c <= answer->column_count; c++) {
        size_t width = head_of(answer, c, head);
        double value = c == 0 ? yk_amount_of(answer->session->model, answer->row[c], YK_QUANTITY_TIME)
                              : yk_column_shown(answer->session, answer->row[c], answer->columns[c - 1].channel);
        bool is_known = value - value == 0;
        size_t length = is_known ? yk_number_write_digits(value, YK_DIGITS, number) : 1;
        add_right(out, is_known ? number : "-", length, width);
    }
    yk_text_add(out, yk_text_get(head), 0); // fails where a width is lost
    yk_text_puts(out, "\n");
}

static void add_csv_row(YkSimulationAnswer *answer)
{
    YkCsv csv = {.text = &answer->session->out};
    for (size_t c = 0; c <= answer->column_count; c++) yk_csv_number(&csv, answer->row[c]);
    yk_csv_row(&csv);
}

// --- both

void yk_simulate_head(YkSimulationAnswer *answer)
{
    YkCsv csv = {.text = &answer->session->out};
    YkText head = {0};
    if (answer->session->request->format == YK_FORMAT_TEXT) add_text_head(answer, &head);
    if (answer->session->request->format == YK_FORMAT_CSV) {
        for (size_t c = 0; c <= answer->column_count; c++) yk_csv_name(&csv, name_of(answer, c));
        yk_csv_row(&csv);
    }
    yk_text_free(&head);
}

static bool keep_row(YkSimulationAnswer *answer)
{
    size_t width = answer->column_count + 1;
    if (!YK_ROW_ROOM(answer->rows, width, answer->row_count, answer->row_capacity))
        return yk_session_refuse_for_memory(answer->session);
    memcpy(answer->rows + answer->row_count * width, answer->row, width * sizeof *answer->row);
    return true;
}

// Warns of each cam once, with the time at which it would first have to pull its follower; collects the laws that are
// left.
static void look_at_events(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    size_t count = yk_simulation_happening_count(answer->simulation);
    for (; answer->told_count < count; answer->told_count++) {
        YkHappening h = yk_simulation_happening(answer->simulation, answer->told_count);
        bool is_known = h.kind != YK_HAPPENING_PULL;
        if (h.kind == YK_HAPPENING_LAW_LEFT) yk_law_watch_note(answer->laws, h.name, h.value, h.time);
        for (size_t k = 0; k < answer->told_count && !is_known; k++) {
            YkHappening before = yk_simulation_happening(answer->simulation, k);
            is_known = before.kind == YK_HAPPENING_PULL && strcmp(before.name, h.name) == 0;
        }
        if (!is_known) yk_warn_of_pulling_cam(session, h.name, &h.time);
    }
}

bool yk_simulate_row(YkSimulationAnswer *answer)
{
    YkText head = {0};
    answer->row[0] = yk_simulation_time(answer->simulation);
    for (size_t c = 0; c < answer->column_count; c++)
        answer->row[c + 1] = yk_simulation_channel(answer->simulation, answer->columns[c].channel);
    if (keeps_rows(answer) && !keep_row(answer)) return false;
    look_at_events(answer);
    answer->row_count++;
    if (answer->session->request->format == YK_FORMAT_TEXT) add_text_row(answer, &head);
    if (answer->session->request->format == YK_FORMAT_CSV) add_csv_row(answer);
    yk_text_free(&head);
    return true;
}

bool yk_simulate_flush(YkSimulationAnswer *answer)
{
    YkSession *session = answer->session;
    if (session->out.failed) {
        answer->is_cut = true;
        return yk_session_refuse_for_memory(session);
    }
    answer->is_cut =
        !yk_stream_write(&answer->stream, yk_text_get(&session->out), session->out.length, session->problems);
    yk_text_clear(&session->out);
    return !answer->is_cut;
}
