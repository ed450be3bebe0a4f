// Plots the columns of a simulation over time, in the file's units.
#include "picture/plot.h"
#include "session.h"
#include "verbs/simulate/simulate.h"

// Fills in column after column, t first.
static void fill(const YkSimulationAnswer *answer, double *values, YkPlotColumn *columns)
{
    const YkSession *session = answer->session;
    size_t rows = answer->row_count, width = answer->column_count + 1;
    for (size_t c = 0; c < width; c++) {
        YkQuantity quantity = c == 0 ? YK_QUANTITY_TIME : answer->columns[c - 1].channel.quantity;
        for (size_t row = 0; row < rows; row++)
            values[c * rows + row] = yk_shown(session, answer->rows[row * width + c], quantity);
        if (c == 0) continue;
        columns[c - 1] = (YkPlotColumn){answer->columns[c - 1].name, yk_unit_of(session, quantity), values + c * rows};
    }
}

bool yk_simulate_plot(const YkSimulationAnswer *answer, const char *path)
{
    YkSession *session = answer->session;
    size_t rows = answer->row_count;
    if (rows == 0 || answer->column_count == 0) return true; // nothing to draw; the reason was reported
    double *values = yk_session_alloc(answer->session, (answer->column_count + 1) * rows, sizeof *values);
    YkPlotColumn *columns = yk_session_alloc(answer->session, answer->column_count, sizeof *columns);
    YkText picture = {0};
    bool good = values && columns;
    if (good) {
        fill(answer, values, columns);
    } else {
        yk_session_refuse_for_memory(session);
    }
    YkPlot plot = {.title = yk_model_name(session->model),
                   .x_name = "t",
                   .x_unit = yk_unit_of(session, YK_QUANTITY_TIME),
                   .x = values,
                   .rows = rows,
                   .columns = columns,
                   .column_count = answer->column_count};
    good = good && yk_plot_draw(&plot, yk_file_kind(path), &picture, session->problems) &&
           yk_file_write(path, yk_text_get(&picture), picture.length, session->problems);
    yk_text_free(&picture);
    return good;
}
