// The writers of a simulation.
#include <stdio.h>
#include <stdlib.h>
#include "out/csv.h"
#include "out/plot.h"
#include "out/table.h"
#include "session.h"
#include "simulate.h"

const char *yk_happening_word(YkHappeningKind kind)
{
    static const char *const words[] = {"stop", "release", "stick", "slip", "change-point", "dead-point", "crossing"};
    return words[kind];
}

static double cell(const YkSimulationAnswer *answer, size_t row, size_t column)
{
    return answer->rows[row * (answer->column_count + 1) + column];
}

static double shown_cell(const YkSimulationAnswer *answer, size_t row, size_t column)
{
    YkQuantity quantity = column == 0 ? YK_QUANTITY_TIME : answer->columns[column - 1].channel.quantity;
    return yk_shown(answer->session, cell(answer, row, column), quantity);
}

void yk_simulate_csv_head(YkSimulationAnswer *answer)
{
    YkCsv csv = {.text = &answer->session->out};
    yk_csv_name(&csv, "t");
    for (size_t c = 0; c < answer->column_count; c++) yk_csv_name(&csv, answer->columns[c].name);
    yk_csv_row(&csv);
}

void yk_simulate_csv_rows(YkSimulationAnswer *answer)
{
    YkCsv csv = {.text = &answer->session->out};
    for (; answer->written < answer->row_count; answer->written++) {
        for (size_t c = 0; c <= answer->column_count; c++) yk_csv_number(&csv, cell(answer, answer->written, c));
        yk_csv_row(&csv);
    }
}

static void add_events_table(YkSimulationAnswer *answer)
{
    size_t count = yk_simulation_happening_count(answer->simulation);
    YkTable *table = yk_table_new(3);
    yk_table_head(table, "event", NULL);
    yk_table_head(table, "t", yk_unit_of(answer->session, YK_QUANTITY_TIME));
    yk_table_head(table, "of", NULL);
    for (size_t k = 0; k < count; k++) {
        YkHappening h = yk_simulation_happening(answer->simulation, k);
        yk_table_word(table, yk_happening_word(h.kind));
        yk_table_number(table, yk_shown(answer->session, h.time, YK_QUANTITY_TIME), 10);
        yk_table_word(table, h.name);
    }
    if (count > 0) {
        yk_text_puts(&answer->session->out, "\n");
        if (!yk_table_write(table, 2, &answer->session->out)) answer->session->out.failed = true;
    }
    yk_table_free(table);
}

void yk_simulate_text(YkSimulationAnswer *answer)
{
    const YkSession *session = answer->session;
    YkText *out = &answer->session->out;
    YkTable *table = yk_table_new(answer->column_count + 1);
    yk_text_format(out, "%s: motion in time\n\n", yk_model_name(session->model));
    yk_table_head(table, "t", yk_unit_of(session, YK_QUANTITY_TIME));
    for (size_t c = 0; c < answer->column_count; c++)
        yk_table_head(table, answer->columns[c].name, yk_unit_of(session, answer->columns[c].channel.quantity));
    for (size_t row = 0; row < answer->row_count; row++)
        for (size_t c = 0; c <= answer->column_count; c++)
            yk_table_number(table, shown_cell(answer, row, c), YK_DIGITS);
    if (!yk_table_write(table, 2, out)) out->failed = true;
    yk_table_free(table);
    add_events_table(answer);
}

// --- JSON
// ---------------------------------------------------------------------------------------------------------------

static void add_rows(const YkSimulationAnswer *answer, YkJson *json)
{
    yk_json_list(json, "columns", YK_JSON_INLINE);
    yk_json_string(json, NULL, "t");
    for (size_t c = 0; c < answer->column_count; c++) yk_json_string(json, NULL, answer->columns[c].name);
    yk_json_end(json);
    yk_json_list(json, "rows", YK_JSON_LINES);
    for (size_t row = 0; row < answer->row_count; row++) {
        yk_json_list(json, NULL, YK_JSON_INLINE);
        for (size_t c = 0; c <= answer->column_count; c++) yk_json_number(json, NULL, cell(answer, row, c));
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_events(const YkSimulationAnswer *answer, YkJson *json)
{
    yk_json_list(json, "events", YK_JSON_LINES);
    for (size_t k = 0; k < yk_simulation_happening_count(answer->simulation); k++) {
        YkHappening h = yk_simulation_happening(answer->simulation, k);
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "kind", yk_happening_word(h.kind));
        yk_json_number(json, "time", h.time);
        yk_json_string(json, "of", h.name);
        yk_json_number(json, "value", h.value);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_works(const YkSimulationAnswer *answer, YkJson *json)
{
    yk_json_list(json, "work", YK_JSON_LINES);
    for (size_t k = 0; k < yk_simulation_work_count(answer->simulation); k++) {
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "of", yk_simulation_work_name(answer->simulation, k));
        yk_json_number(json, "work", yk_simulation_work(answer->simulation, k));
        yk_json_end(json);
    }
    yk_json_end(json);
}

void yk_simulate_json(YkSimulationAnswer *answer)
{
    YkJson json = {.text = &answer->session->out};
    YkSimulationSummary s = yk_simulation_summary(answer->simulation);
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_head(&json, answer->session, answer->status, yk_simulation_report(answer->simulation)->message);
    if (answer->is_interrupted) yk_json_bool(&json, "interrupted", true);
    add_rows(answer, &json);
    add_events(answer, &json);
    add_works(answer, &json);
    yk_json_object(&json, "summary", YK_JSON_INLINE);
    yk_json_integer(&json, "steps", (long long)s.steps);
    yk_json_integer(&json, "rejected", (long long)s.rejected);
    yk_json_integer(&json, "evaluations", (long long)s.evaluations);
    yk_json_number(&json, "energy_start", s.energy_start);
    yk_json_number(&json, "energy_end", s.energy_end);
    yk_json_number(&json, "energy_error", s.energy_error);
    yk_json_number(&json, "worst_residual", s.worst_residual);
    yk_json_end(&json);
    yk_json_end(&json);
}

// --- the plot
// ------------------------------------------------------------------------------------------------------------

bool yk_simulate_plot(YkSimulationAnswer *answer, const char *path)
{
    YkSession *session = answer->session;
    size_t rows = answer->row_count, n = answer->column_count;
    if (rows == 0 || n == 0) return true;
    double *values = calloc((n + 1) * rows, sizeof *values);
    YkPlotColumn *columns = calloc(n, sizeof *columns);
    YkText picture = {0};
    bool good = values && columns;
    for (size_t c = 0; good && c <= n; c++)
        for (size_t row = 0; row < rows; row++) values[c * rows + row] = shown_cell(answer, row, c);
    for (size_t c = 0; good && c < n; c++)
        columns[c] = (YkPlotColumn){answer->columns[c].name, yk_unit_of(session, answer->columns[c].channel.quantity),
                                    values + (c + 1) * rows};
    YkPlot plot = {.title = yk_model_name(session->model), .x_name = "t", .x_unit = yk_unit_of(session, YK_QUANTITY_TIME),
                   .x = values, .rows = rows, .columns = columns, .column_count = n};
    if (!good) yk_session_refuse(session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
    good = good && yk_plot_draw(&plot, yk_file_kind(path), &picture, session->problems) &&
           yk_file_write(path, yk_text_get(&picture), picture.length, session->problems);
    yk_text_free(&picture);
    free(columns);
    free(values);
    return good;
}

// --- what is told besides
// -----------------------------------------------------------------------------------------------

static void add_events_lines(const YkSimulationAnswer *answer, YkText *text)
{
    enum { LINES_MAX = 50 };
    size_t count = yk_simulation_happening_count(answer->simulation);
    for (size_t k = 0; k < count && k < LINES_MAX; k++) {
        YkHappening h = yk_simulation_happening(answer->simulation, k);
        yk_text_format(text, "simulate: %s of %s at t = %e s\n", yk_happening_word(h.kind), h.name, h.time);
    }
    if (count > LINES_MAX) yk_text_format(text, "simulate: %z more events (--format json lists all)\n", count - LINES_MAX);
}

void yk_simulate_tell(YkSimulationAnswer *answer)
{
    YkText text = {0};
    YkSimulationSummary s = yk_simulation_summary(answer->simulation);
    bool is_quiet = answer->session->request->quiet;
    if (!is_quiet) add_events_lines(answer, &text);
    for (size_t k = 0; !is_quiet && k < yk_simulation_work_count(answer->simulation); k++) {
        double work = yk_simulation_work(answer->simulation, k);
        if (work != 0) yk_text_format(&text, "simulate: work of %s: %e J\n", yk_simulation_work_name(answer->simulation, k), work);
    }
    if (answer->is_interrupted)
        yk_text_format(&text, "simulate: interrupted at t = %e s\n", yk_simulation_time(answer->simulation));
    yk_text_format(&text, "simulate: %z steps, %z evaluations; energy error %e; worst residual %e\n", s.steps, s.evaluations,
                   s.energy_error, s.worst_residual);
    fputs(yk_text_get(&text), stderr);
    yk_text_free(&text);
}
