// Draws plots by gnuplot.
#include "picture/plot.h"
#include <math.h>
#include <string.h>
#include "base/problems.h"
#include "write/process.h"

enum { WIDTH = 800, PANEL_HEIGHT = 320, POINTS_PER_INCH = 72 };

static const char *const colours[] = {"#1f6fb2", "#d1622b", "#2e8b57", "#8b4a9c",
                                      "#b8860b", "#c0394b", "#4a7c8c", "#5d5d5d"};

// Writes a string in gnuplot's single quotes, in which only the quote itself is special.
static void add_quoted(YkText *script, const char *string)
{
    if (string == yk_text_lost) yk_text_fail(script);
    yk_text_puts(script, "'");
    for (const char *c = string; *c; c++) yk_text_add(script, *c == '\'' ? "''" : c, *c == '\'' ? 2 : 1);
    yk_text_puts(script, "'");
}

static void add_number(YkText *script, double value)
{
    if (isfinite(value)) {
        yk_text_format(script, " %g", value);
    } else {
        yk_text_puts(script, " ?");
    }
}

// Returns whether this column is the first of its unit, so that a panel begins with it.
static bool opens_panel(const YkPlot *plot, size_t column)
{
    for (size_t i = 0; i < column; i++)
        if (strcmp(plot->columns[i].unit, plot->columns[column].unit) == 0) return false;
    return true;
}

static size_t panel_count(const YkPlot *plot)
{
    size_t count = 0;
    for (size_t i = 0; i < plot->column_count; i++) count += opens_panel(plot, i);
    return count;
}

static void add_terminal(const YkPlot *plot, YkFileKind kind, YkText *script)
{
    size_t height = PANEL_HEIGHT * panel_count(plot) + 40;
    if (kind == YK_FILE_PDF) {
        yk_text_format(script, "set terminal pdfcairo noenhanced font 'sans,11' size %gin,%gin\n",
                       (double)WIDTH / POINTS_PER_INCH, (double)height / POINTS_PER_INCH);
    } else if (kind == YK_FILE_PNG) {
        yk_text_format(script, "set terminal pngcairo noenhanced font 'sans,20' size %d,%z linewidth 2\n", 2 * WIDTH,
                       2 * height);
    } else {
        yk_text_format(script, "set terminal svg noenhanced font 'sans,13' size %d,%z background '#ffffff'\n", WIDTH,
                       height);
    }
}

static void add_data(const YkPlot *plot, YkText *script)
{
    yk_text_puts(script, "$data << EOD\n");
    for (size_t row = 0; row < plot->rows; row++) {
        yk_text_format(script, "%g", plot->x[row]);
        for (size_t c = 0; c < plot->column_count; c++) add_number(script, plot->columns[c].values[row]);
        yk_text_puts(script, "\n");
    }
    yk_text_puts(script, "EOD\n");
}

// Writes the range of x, so that every panel shows the same one even if lines have gaps.
static void add_range(const YkPlot *plot, YkText *script)
{
    double low = plot->x[0], high = low;
    for (size_t row = 1; row < plot->rows; row++) {
        low = fmin(low, plot->x[row]);
        high = fmax(high, plot->x[row]);
    }
    if (high > low) yk_text_format(script, "set xrange [%g:%g]\n", low, high);
}

static void add_marks(const YkPlot *plot, YkText *script)
{
    for (size_t i = 0; i < plot->mark_count; i++) {
        yk_text_format(script,
                       "set arrow from first %g, graph 0 to first %g, graph 1 nohead dashtype 2 linecolor '#999999'\n",
                       plot->marks[i].at, plot->marks[i].at);
        yk_text_puts(script, "set label ");
        add_quoted(script, plot->marks[i].label);
        yk_text_format(script, " at first %g, graph 0.97 rotate by 90 right offset -0.6,0 textcolor '#777777'\n",
                       plot->marks[i].at);
    }
}

static void add_axis(YkText *script, const char *axis, const char *name, const char *unit)
{
    YkText label = {0};
    yk_text_puts(&label, name);
    if (*unit) yk_text_format(&label, "%s[%s]", *name ? " " : "", unit);
    yk_text_format(script, "set %slabel ", axis);
    add_quoted(script, yk_text_get(&label));
    yk_text_puts(script, "\n");
    yk_text_free(&label);
}

static void add_panel(const YkPlot *plot, size_t first, YkText *script)
{
    const char *separator = "plot";
    add_axis(script, "y", "", plot->columns[first].unit);
    for (size_t c = first; c < plot->column_count; c++) {
        if (strcmp(plot->columns[c].unit, plot->columns[first].unit) != 0) continue;
        yk_text_format(script, "%s $data using 1:%z with %s title ", separator, c + 2,
                       plot->rows > 1 ? "lines" : "points");
        add_quoted(script, plot->columns[c].name);
        yk_text_format(script, " linewidth 2 linecolor '%s'", colours[c % (sizeof colours / sizeof *colours)]);
        separator = ", \\\n    ";
    }
    yk_text_puts(script, "\n");
}

void yk_plot_script(const YkPlot *plot, YkFileKind kind, YkText *script)
{
    add_terminal(plot, kind, script);
    add_data(plot, script);
    yk_text_puts(script, "set encoding utf8\nset datafile missing '?'\nset grid linecolor '#dddddd' linewidth 0.5\n"
                         "set border 3 linecolor '#666666'\nset tics nomirror textcolor '#333333'\n"
                         "set key outside right top\n"
                         "set lmargin at screen 0.11\nset rmargin at screen 0.82\n"); // panels line up
    if (plot->rows > 0) add_range(plot, script);
    add_marks(plot, script);
    yk_text_format(script, "set multiplot layout %z,1 title ", panel_count(plot));
    add_quoted(script, plot->title);
    yk_text_puts(script, "\n");
    add_axis(script, "x", plot->x_name, plot->x_unit);
    for (size_t c = 0; c < plot->column_count; c++)
        if (opens_panel(plot, c)) add_panel(plot, c, script);
    yk_text_puts(script, "unset multiplot\n");
}

bool yk_plot_draw(const YkPlot *plot, YkFileKind kind, YkText *output, YkProblems *problems)
{
    static const char *const gnuplot[] = {"gnuplot", "-d", "-", NULL};
    YkText script = {0};
    bool good = false;
    yk_plot_script(plot, kind, &script);
    if (script.failed) {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory");
    } else {
        good = yk_process_filter(gnuplot, "drawing a plot", &script, output, problems);
        if (!good)
            yk_problem_hint(problems, "without --plot the table still comes; gnuplot is in the package gnuplot-nox");
    }
    yk_text_free(&script);
    return good;
}
