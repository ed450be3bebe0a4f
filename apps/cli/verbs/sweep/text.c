// `yoke sweep` for people.
#include <math.h>
#include "certify.h"
#include "verbs/sweep/sweep.h"
#include "write/amount.h"
#include "write/table.h"

enum { EVENT_DIGITS = 10 };

// Scales by the whole table: its values, and the pose at its end.
static void find_scale(const YkSweepAnswer *answer)
{
    YkSession *session = answer->session;
    yk_scale_begin(session);
    if (!answer->sweep) return;
    if (session->dynamics) yk_dynamics_solve(session->dynamics, session->state, answer->method); // it was beside it
    yk_scale_add_pose(session, session->state);
    for (size_t row = 0; row < yk_sweep_row_count(answer->sweep); row++)
        for (size_t c = 0; c < answer->column_count; c++)
            yk_scale_add(session, yk_sweep_cell(answer, row, c), answer->columns[c].channel.quantity);
}

// Returns the swept value in the file's unit; 0 if only rounding of the steps is left.
static double shown_at(const YkSweepAnswer *answer, double at)
{
    double largest = fmax(fabs(answer->over.from), fabs(answer->over.to));
    return fabs(at) <= 1e-15 * largest ? 0 : yk_amount_of(answer->session->model, at, answer->over.quantity);
}

static const YkNoise *noise_of(const YkSweepAnswer *answer, size_t row)
{
    return answer->noise + row * answer->column_count;
}

// Returns a cell of a row in the file's unit. 0: noise by the whole table and by what was measured there, which says
// nothing of limits.
static double shown_in_row(const YkSweepAnswer *answer, size_t row, size_t column)
{
    double value = yk_sweep_cell(answer, row, column);
    YkChannel channel = answer->columns[column].channel;
    bool is_limit = yk_sweep_row_status(answer->sweep, row) == YK_CHANGE_POINT;
    if (!is_limit && fabs(value) > (double)noise_of(answer, row)[column].measured)
        return yk_amount_of(answer->session->model, value, channel.quantity);
    return yk_column_shown(answer->session, value, channel);
}

// Returns the last row before a place of the sweep, or the first row.
static size_t row_before(const YkSweepAnswer *answer, double at)
{
    double first = yk_sweep_at(answer->sweep, 0);
    size_t row = 0, end = yk_sweep_row_count(answer->sweep);
    while (row + 1 < end) {
        size_t middle = row + (end - row) / 2;
        if (fabs(yk_sweep_at(answer->sweep, middle) - first) < fabs(at - first))
            row = middle;
        else
            end = middle;
    }
    return row;
}

// Returns a value at an event, whose place is known to fewer digits, in the file's unit. 0: noise by the whole table
// and by the two rows before, the last of which is `row`: in one of them all may stand still.
static double shown_at_event(const YkSweepAnswer *answer, size_t event, size_t row, size_t column)
{
    double value = yk_sweep_event_value(answer->sweep, event, column);
    YkChannel channel = answer->columns[column].channel;
    float usual = fmaxf(noise_of(answer, row)[column].usual, noise_of(answer, row - (row > 0))[column].usual);
    if (fabs(value) > 1e3 * (double)usual) return yk_amount_of(answer->session->model, value, channel.quantity);
    return yk_column_shown(answer->session, value, channel);
}

// Beside a change point rates and accelerations lose digits, with the sine of the transmission angle to the third
// power; at one they are limits. So there is more noise there, which is at most taken for 1e-8.
static double blur_of(const YkSweepAnswer *answer, size_t row)
{
    const double most = 1e5;
    double sine = (double)answer->sines[row];
    if (yk_sweep_row_status(answer->sweep, row) == YK_CHANGE_POINT) return YK_BLUR_AT_CHANGE_POINT;
    return fmin(most, fmax(1, 1e-2 / (sine * sine * sine)));
}

static void add_rows(const YkSweepAnswer *answer)
{
    YkSession *session = answer->session;
    size_t rows = answer->sweep ? yk_sweep_row_count(answer->sweep) : 0;
    YkTable *table = yk_table_new(answer->column_count + 1);
    yk_table_head(table, answer->over.name, yk_unit_of(session, answer->over.quantity));
    for (size_t c = 0; c < answer->column_count; c++)
        yk_table_head(table, answer->columns[c].name, yk_unit_of(session, answer->columns[c].channel.quantity));
    for (size_t row = 0; row < rows; row++) {
        session->scale.blur = blur_of(answer, row);
        yk_table_number(table, shown_at(answer, yk_sweep_at(answer->sweep, row)), YK_DIGITS);
        for (size_t c = 0; c < answer->column_count; c++)
            yk_table_number(table, shown_in_row(answer, row, c), YK_DIGITS);
    }
    session->scale.blur = 0;
    yk_table_show(table, NULL, &answer->session->out);
}

// Writes "d5 = 1.2 m", or "at joint C".
static void add_event_value(const YkSweepAnswer *answer, YkEvent event, YkText *text)
{
    if (event.kind == YK_EVENT_EXTREME) {
        const YkAnswerColumn *column = &answer->columns[event.channel];
        yk_text_format(text, "%s = ", column->name);
        yk_add_value(answer->session, text, event.value, column->channel.quantity, EVENT_DIGITS);
    } else if (event.block >= 0) {
        yk_text_format(text, "at joint %s", yk_block_info(answer->session->mech, (size_t)event.block).label);
    }
}

// With --of, every column is shown at its events, unless each is an extreme of the only column.
static size_t columns_at_events(const YkSweepAnswer *answer, size_t count)
{
    bool has_more = answer->column_count > 1;
    for (size_t i = 0; i < count; i++) has_more |= yk_sweep_event(answer->sweep, i).kind != YK_EVENT_EXTREME;
    return answer->session->request->of && has_more ? answer->column_count : 0;
}

static void add_events(const YkSweepAnswer *answer)
{
    size_t count = answer->sweep ? yk_sweep_event_count(answer->sweep) : 0;
    size_t columns = columns_at_events(answer, count);
    YkTable *table = yk_table_new(3 + columns);
    YkText words = {0};
    yk_table_head(table, "event", NULL);
    yk_table_head(table, answer->over.name, yk_unit_of(answer->session, answer->over.quantity));
    yk_table_head(table, "", NULL);
    for (size_t c = 0; c < columns; c++)
        yk_table_head(table, answer->columns[c].name, yk_unit_of(answer->session, answer->columns[c].channel.quantity));
    answer->session->scale.blur = 100;
    for (size_t i = 0; i < count; i++) {
        YkEvent event = yk_sweep_event(answer->sweep, i);
        yk_text_clear(&words);
        add_event_value(answer, event, &words);
        yk_table_word(table, yk_event_word(event));
        yk_table_number(table, shown_at(answer, event.at), EVENT_DIGITS);
        yk_table_word(table, yk_text_get(&words));
        size_t row = row_before(answer, event.at);
        for (size_t c = 0; c < columns; c++) yk_table_number(table, shown_at_event(answer, i, row, c), YK_DIGITS);
    }
    answer->session->scale.blur = 0;
    yk_text_free(&words);
    yk_table_show(table, NULL, &answer->session->out);
    size_t total = answer->sweep ? yk_sweep_event_total(answer->sweep) : 0;
    if (total > count)
        yk_text_format(&answer->session->out, "\n%z more events were found: the first %z are listed\n", total - count,
                       count);
}

static void add_strokes(const YkSweepAnswer *answer)
{
    YkText *out = &answer->session->out;
    for (size_t c = 0; answer->strokes && c < answer->column_count; c++) {
        YkStroke stroke = answer->strokes[c];
        if (stroke.ratio <= 0) continue;
        yk_text_format(out, "\n%s: stroke ", answer->columns[c].name);
        yk_add_value(answer->session, out, stroke.high - stroke.low, answer->columns[c].channel.quantity, EVENT_DIGITS);
        yk_text_format(out, ", time ratio %e at constant speed", stroke.ratio);
    }
    yk_text_puts(out, "\n");
}

void yk_sweep_text(const YkSweepAnswer *answer)
{
    YkText *out = &answer->session->out;
    yk_text_format(out, "%s: sweep over %s", yk_model_name(answer->session->model), answer->over.name);
    if (yk_text_has_some(&answer->label)) yk_text_format(out, ", configuration %s", yk_text_get(&answer->label));
    yk_text_puts(out, "\n");
    find_scale(answer);
    add_rows(answer);
    add_events(answer);
    add_strokes(answer);
    yk_certify_text(answer->session, "", out);
    if (answer->status != YK_OK)
        yk_text_format(out, "%s: %s\n", yk_status_name(answer->status), yk_text_get(&answer->message));
    if (answer->range_count > 0) {
        yk_text_puts(out, "closes for ");
        yk_sweep_add_ranges(answer, out);
        yk_text_puts(out, "\n");
    }
}
