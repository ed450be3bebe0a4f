// Writes the diagrams, which the script draws; without it, pictures by gnuplot.
#include <math.h>
#include <stdlib.h>
#include "picture/plot.h"
#include "report/html.h"
#include "report/panels.h"

// Writes "theta2 between -1 and 1 rad, d3 ...": a diagram's description for readers who cannot see it.
static void tell(YkReportPage *report, const YkPanel *panel, YkText *text)
{
    yk_text_format(text, "%s over %s: ", panel->title, yk_report_axis(report));
    for (size_t k = 0; k < panel->count; k++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t row = 0; row < report->row_count; row++) {
            double value = yk_report_value(report, row, panel->columns[k]);
            low = fmin(low, value);
            high = fmax(high, value);
        }
        yk_text_format(text, "%s%s between ", k > 0 ? "; " : "", report->columns[panel->columns[k]].name);
        yk_report_amount(report, text, low, panel->quantity);
        yk_text_puts(text, " and ");
        yk_report_amount(report, text, high, panel->quantity);
    }
}

static double *in_units(const YkReportPage *report, size_t column, YkQuantity quantity)
{
    double *values = calloc(report->row_count + 1, sizeof *values);
    for (size_t row = 0; values && row < report->row_count; row++)
        values[row] = yk_report_in_unit(report, yk_report_value(report, row, column), quantity);
    return values;
}

static bool draw_plain(YkReportPage *report, const YkPanel *panel, YkText *svg, YkProblems *problems)
{
    YkPlotColumn columns[YK_PANEL_COLUMNS_MAX];
    double *own[YK_PANEL_COLUMNS_MAX] = {0}, *x = calloc(report->row_count + 1, sizeof *x);
    YkQuantity axis = yk_report_axis_quantity(report);
    bool good = x != NULL;
    for (size_t row = 0; x && row < report->row_count; row++) x[row] = yk_report_in_unit(report, report->at[row], axis);
    for (size_t k = 0; k < panel->count; k++) {
        own[k] = in_units(report, panel->columns[k], panel->quantity);
        good = good && own[k];
        columns[k] = (YkPlotColumn){.name = report->columns[panel->columns[k]].name,
                                    .unit = yk_report_unit(report, panel->quantity, NULL),
                                    .values = own[k]};
    }
    YkPlot plot = {.title = panel->title,
                   .x_name = yk_report_axis(report),
                   .x_unit = yk_report_unit(report, axis, NULL),
                   .x = x,
                   .rows = report->row_count,
                   .columns = columns,
                   .column_count = panel->count};
    good = good && yk_plot_draw(&plot, YK_FILE_SVG, svg, problems);
    for (size_t k = 0; k < panel->count; k++) free(own[k]);
    free(x);
    return good;
}

// Returns false if gnuplot is missing or failed: then no other panel is tried.
static bool add_plain(YkReportPage *report, const YkPanel *panel, const char *told, YkText *html)
{
    YkProblems *problems = yk_problems_new();
    YkText svg = {0};
    bool good = draw_plain(report, panel, &svg, problems);
    yk_report_note_problems(report, problems);
    if (!good && problems && yk_problems_count(problems) == 0) yk_text_fail(html);
    if (good)
        yk_html_image(html, yk_text_get(&svg), svg.length, told, "");
    else if (problems && yk_problems_count(problems) > 0)
        yk_html_element(html, "p", yk_problems_get(problems, 0)->message);
    yk_text_free(&svg);
    yk_problems_free(problems);
    return good;
}

static void add_moving(const YkPanel *panel, const char *told, YkText *html)
{
    yk_text_format(
        html, "<figure class=\"chart\" id=\"chart-%s\">\n<h3>%s</h3>\n<div class=\"plot\" role=\"img\" aria-label=\"",
        panel->id, panel->title);
    yk_html_words(html, told);
    yk_text_puts(html, "\"></div>\n</figure>\n");
}

void yk_section_diagrams(YkReportPage *report, YkText *html, YkProblems *problems)
{
    YkPanel panels[YK_PANELS_MAX];
    size_t count = yk_report_panels(report, panels, YK_PANELS_MAX);
    bool is_plain = report->options.is_plain || !yk_report_has_script(), good = true;
    YkText told = {0};
    (void)problems;
    if (count > 0 && !is_plain)
        yk_text_puts(
            html,
            "<p class=\"hint\">Drag over a diagram to look closer, double-click to see all of it again; a name in the "
            "legend hides its line.</p>\n<noscript><p>The diagrams need a browser that runs scripts.</p></noscript>\n");
    yk_text_puts(html, count > 0 ? "<div class=\"charts\">\n" : "");
    for (size_t k = 0; k < count && good; k++) {
        yk_text_clear(&told);
        tell(report, &panels[k], &told);
        if (is_plain)
            good = add_plain(report, &panels[k], yk_text_get(&told), html);
        else
            add_moving(&panels[k], yk_text_get(&told), html);
    }
    yk_text_puts(html, count > 0 ? "</div>\n" : "");
    yk_text_free(&told);
}
