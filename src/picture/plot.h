// Plots: columns over one variable, one panel for each unit, drawn by gnuplot.
#ifndef PICTURE_PLOT_H
#define PICTURE_PLOT_H
#include <yoke/problem.h>
#include "base/text.h"
#include "write/file.h"

typedef struct YkPlotColumn {
    const char *name, *unit; // columns of equal units share a panel
    const double *values;    // rows; not finite = a gap in the line
} YkPlotColumn;

typedef struct YkPlotMark {
    double at; // a vertical line here: a limit, a dead point
    const char *label;
} YkPlotMark;

typedef struct YkPlot {
    const char *title, *x_name, *x_unit;
    const double *x;
    size_t rows;
    const YkPlotColumn *columns;
    size_t column_count;
    const YkPlotMark *marks;
    size_t mark_count;
} YkPlot;

// Writes the gnuplot script that draws it on standard output, data inside. Deterministic.
void yk_plot_script(const YkPlot *plot, YkFileKind kind, YkText *script);
// Runs gnuplot; adds the picture to `output`. Returns false with a problem added (E0710 if gnuplot is missing).
bool yk_plot_draw(const YkPlot *plot, YkFileKind kind, YkText *output, YkProblems *problems);

#endif
