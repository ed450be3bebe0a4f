// Writes how the report was computed, and how well it closes.
#include <math.h>
#include "report/report.h"

static void add_start(const YkReportPage *report, YkText *html)
{
    YkResiduals residuals = yk_state_residuals(report->start);
    yk_text_puts(html, "<li>Start: loops close within ");
    yk_report_error(html, residuals.position);
    yk_text_puts(html, " of the machine's size, velocities within ");
    yk_report_error(html, residuals.velocity);
    yk_text_puts(html, ", accelerations within ");
    yk_report_error(html, residuals.acceleration);
    yk_text_puts(html, " (measured in the loops of the tree, not in the steps that solved them).</li>\n");
}

static void add_sweep(const YkReportPage *report, YkText *html)
{
    yk_text_format(html,
                   "<li>Motion: %z poses, each solved exactly on the branch of the start, the way between them "
                   "verified; the loops close "
                   "within ",
                   report->row_count);
    yk_report_error(html, yk_sweep_worst_residual(report->sweep));
    yk_text_puts(html, " throughout.</li>\n");
}

static void add_simulation(const YkReportPage *report, YkText *html)
{
    YkSimulationSummary s = yk_simulation_summary(report->simulation);
    yk_text_format(
        html,
        "<li>Motion in time: Dormand and Prince's method of order 8, %z steps, %z evaluations; the loops close within ",
        s.steps, s.evaluations);
    yk_report_error(html, s.worst_residual);
    yk_text_puts(html, ", the balance of energy within ");
    yk_report_error(html, s.energy_error);
    yk_text_puts(html, ".</li>\n");
}

static void add_forces(const YkReportPage *report, YkText *html)
{
    double worst = 0;
    for (size_t b = 1; b < yk_model_body_count(report->model); b++)
        worst = fmax(worst, yk_dynamics_balance(report->dynamics, b).residual);
    yk_text_puts(html, "<li>Forces: equations reduced to the free coordinates; set into the balance of every body, "
                       "Newton's and Euler's "
                       "equations hold within ");
    yk_report_error(html, worst);
    yk_text_puts(html, " of the largest force.</li>\n");
}

void yk_section_method(YkReportPage *report, YkText *html, YkProblems *problems)
{
    (void)problems;
    yk_text_puts(html, "<ul>\n");
    if (!yk_report_has_script())
        yk_text_puts(html, "<li>This page does not move: Yoke was built without Node, which bundles the script that "
                           "moves it.</li>\n");
    if (report->status >= 0) add_start(report, html);
    if (report->sweep) add_sweep(report, html);
    if (report->simulation) add_simulation(report, html);
    if (report->has_forces) add_forces(report, html);
    yk_text_puts(html, "<li>Equations: derived in exact fractions from the machine's structure alone, independently of "
                       "what computed the "
                       "numbers.</li>\n</ul>\n");
}
