// Plots the columns of a sweep in the file's units.
#include "picture/plot.h"
#include "session.h"
#include "verbs/sweep/sweep.h"

// Fills in x and the columns; limits and similar events are marks.
static bool fill(const YkSweepAnswer *answer, double *values, YkPlotColumn *columns, YkPlotMark *marks, YkPlot *plot)
{
    const YkSession *session = answer->session;
    if (!values || !columns || !marks) return false;
    size_t rows = plot->rows;
    for (size_t row = 0; row < rows; row++)
        values[row] = yk_shown(session, yk_sweep_at(answer->sweep, row), answer->over.quantity);
    for (size_t c = 0; c < answer->column_count; c++) {
        YkQuantity quantity = answer->columns[c].channel.quantity;
        double *column = values + (c + 1) * rows;
        for (size_t row = 0; row < rows; row++)
            column[row] = yk_shown(session, yk_sweep_cell(answer, row, c), quantity);
        columns[c] = (YkPlotColumn){answer->columns[c].name, yk_unit_of(session, quantity), column};
    }
    for (size_t i = 0; i < yk_sweep_event_count(answer->sweep); i++) {
        YkEvent event = yk_sweep_event(answer->sweep, i);
        if (event.kind == YK_EVENT_EXTREME) continue;
        marks[plot->mark_count++] =
            (YkPlotMark){yk_shown(session, event.at, answer->over.quantity), yk_event_word(event)};
    }
    plot->x = values;
    plot->columns = columns;
    plot->column_count = answer->column_count;
    plot->marks = marks;
    return true;
}

bool yk_sweep_plot(const YkSweepAnswer *answer, const char *path)
{
    YkSession *session = answer->session;
    YkPlot plot = {.title = yk_model_name(session->model),
                   .x_name = answer->over.name,
                   .x_unit = yk_unit_of(session, answer->over.quantity),
                   .rows = answer->sweep ? yk_sweep_row_count(answer->sweep) : 0};
    if (plot.rows == 0 || answer->column_count == 0) return true; // nothing to draw; the reason was reported
    double *values = yk_session_alloc(answer->session, (answer->column_count + 1) * plot.rows, sizeof *values);
    YkPlotColumn *columns = yk_session_alloc(answer->session, answer->column_count, sizeof *columns);
    YkPlotMark *marks = yk_session_alloc(answer->session, yk_sweep_event_count(answer->sweep) + 1, sizeof *marks);
    YkText picture = {0};
    bool good = fill(answer, values, columns, marks, &plot);
    if (!good) yk_session_refuse_for_memory(session);
    YkFileKind kind = yk_file_kind(path);
    good = good && yk_plot_draw(&plot, kind, &picture, session->problems) &&
           yk_file_write(path, yk_text_get(&picture), picture.length, session->problems);
    yk_text_free(&picture);
    return good;
}
