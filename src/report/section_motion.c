// Writes the machine at its start; with the script it moves, by the controls that are written here, hidden without it.
#include "report/html.h"
#include "report/report.h"

static bool has_script(const YkReportPage *report)
{
    return yk_report_has_script() && !report->options.is_plain && report->row_count > 1 &&
           report->posed == report->row_count;
}

static void tell_motion(YkReportPage *report, YkText *text)
{
    const YkReportMotion *motion = &report->motion;
    if (motion->kind == YK_REPORT_STILL || report->row_count < 2) {
        yk_text_puts(text, "The machine at its start.");
        return;
    }
    yk_text_puts(text, motion->kind == YK_REPORT_SIMULATION ? "Its motion under its loads, "
                       : motion->kind == YK_REPORT_TIME     ? "Its motion as the drives move it, "
                       : motion->kind == YK_REPORT_TURN     ? "One turn, "
                                                            : "Back and forth, ");
    yk_report_amount_at(report, text, report->at[0]);
    yk_text_puts(text, " to ");
    yk_report_amount(report, text, report->at[report->row_count - 1], yk_report_axis_quantity(report));
    yk_text_puts(text,
                 motion->is_cut ? ", a little short of its limits; drawn at its start." : "; drawn at its start.");
}

static void add_controls(YkReportPage *report, YkText *html)
{
    yk_text_puts(html, "<div class=\"controls\" id=\"controls\" hidden>\n"
                       "<button type=\"button\" id=\"play\" aria-pressed=\"false\">Play</button>\n"
                       "<label class=\"slider\"><span>");
    yk_html_words(html, yk_report_axis(report));
    yk_text_format(
        html, "</span> <input type=\"range\" id=\"slider\" min=\"0\" max=\"%z\" step=\"any\" value=\"0\"></label>\n",
        report->row_count - 1);
    yk_text_puts(html, "<output id=\"now\" for=\"slider\"></output>\n"
                       "<label>Speed <select id=\"speed\"><option value=\"0.25\">1/4</option>"
                       "<option value=\"0.5\">1/2</option><option value=\"1\" selected>1</option>"
                       "<option value=\"2\">2</option></select></label>\n</div>\n"
                       "<div class=\"controls\" id=\"shows\" hidden></div>\n");
}

static void add_readout(YkText *html)
{
    yk_text_puts(
        html,
        "<div class=\"scroll\" id=\"readout\" tabindex=\"0\" role=\"region\" "
        "aria-label=\"Values at the pose shown\" hidden></div>\n"
        "<p class=\"hint\" id=\"keys\" hidden>Keys: space plays and pauses; with the slider in focus the arrows step, "
        "Home and End go to the ends. Moving over a diagram moves the machine.</p>\n");
}

void yk_section_motion(YkReportPage *report, YkText *html, YkProblems *problems)
{
    (void)problems;
    if (!report->drawing) return;
    const char *svg = yk_drawing_svg(report->drawing);
    YkText told = {0}, caption = {0};
    if (!svg) html->failed = true;
    yk_text_format(&told, "Drawing of %s: its bodies, joints and guides to scale", report->model->name);
    tell_motion(report, &caption);
    yk_text_puts(html, "<div id=\"stage\">\n");
    if (svg) yk_html_picture(html, svg, yk_text_get(&told), yk_text_get(&caption));
    yk_text_puts(html, "</div>\n");
    if (has_script(report)) {
        add_controls(report, html);
        add_readout(html);
    }
    html->failed |= told.failed || caption.failed;
    yk_text_free(&told);
    yk_text_free(&caption);
}
