// Writes the page: head, contents, one section after the other, data and script.
#include <yoke/yoke.h>
#include "base/problems.h"
#include "report/html.h"
#include "report/report.h"

typedef struct Section {
    const char *id, *title;
    YkReportSection *write;
} Section;

static const Section sections[] = {
    {"findings", "Findings", yk_section_findings},
    {"motion", "The machine", yk_section_motion},
    {"diagrams", "Diagrams", yk_section_diagrams},
    {"forces", "Forces", yk_section_forces},
    {"gears", "Gears", yk_section_gears},
    {"cams", "Cams", yk_section_cams},
    {"parameters", "Dimensions", yk_section_parameters},
    {"topology", "Structure", yk_section_topology},
    {"equations", "Equations", yk_section_equations},
    {"method", "How it was computed", yk_section_method},
};
enum { SECTIONS = sizeof sections / sizeof *sections };

static bool is_moving(const YkReportPage *report)
{
    return yk_report_has_script() && !report->options.is_plain;
}

static void open_page(YkReportPage *report, YkText *html)
{
    yk_text_puts(html, "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                       "<meta name=\"color-scheme\" content=\"light dark\">\n<title>");
    yk_html_words(html, report->model->name);
    yk_text_puts(html, "</title>\n<style>\n");
    yk_text_add(html, (const char *)yk_report_style, yk_report_style_size);
    yk_text_puts(html, "</style>\n</head>\n<body>\n<header>\n");
    yk_html_element(html, "h1", report->model->name);
}

// Writes "5 moving bodies, 7 joints, 2 loops".
static void add_subtitle(YkReportPage *report, YkText *html)
{
    size_t moving = yk_model_body_count(report->model) - 1, joints = yk_model_joint_count(report->model),
           loops = yk_loop_count(report->mech);
    yk_text_format(html, "<p>%z moving bod%s, %z joint%s, %z loop%s</p>\n</header>\n", moving,
                   moving == 1 ? "y" : "ies", joints, joints == 1 ? "" : "s", loops, loops == 1 ? "" : "s");
}

static void add_contents(YkText *const *parts, YkText *html)
{
    yk_text_puts(html, "<nav aria-label=\"Contents\"><ul>\n");
    for (size_t k = 0; k < SECTIONS; k++)
        if (yk_text_has_some(parts[k]))
            yk_text_format(html, "<li><a href=\"#%s\">%s</a></li>\n", sections[k].id, sections[k].title);
    yk_text_puts(html, "</ul></nav>\n<main>\n");
}

static void add_section(const Section *section, const YkText *part, YkText *html)
{
    if (part->length == 0) return;
    yk_text_format(html, "<section id=\"%s\" aria-labelledby=\"%s-title\">\n<h2 id=\"%s-title\">%s</h2>\n", section->id,
                   section->id, section->id, section->title);
    yk_text_join(html, part);
    yk_text_puts(html, "</section>\n");
}

// Writes JSON inside HTML, in which no text may end the element.
static void add_data(YkReportPage *report, YkText *html)
{
    YkText json = {0};
    yk_report_data(report, &json);
    yk_text_puts(html, "<script type=\"application/json\" id=\"data\">");
    for (size_t i = 0; i < json.length; i++) {
        if (json.data[i] == '<')
            yk_text_puts(html, "\\u003c");
        else
            yk_text_add(html, json.data + i, 1);
    }
    yk_text_puts(html, "</script>\n<script>\n");
    yk_report_add_script(html);
    yk_text_puts(html, "</script>\n");
    if (json.failed) yk_text_fail(html);
    yk_text_free(&json);
}

static void write_page(YkReportPage *report, YkProblems *problems)
{
    YkText *html = &report->html, parts[SECTIONS] = {{0}}, *all[SECTIONS];
    for (size_t k = 0; k < SECTIONS; k++) {
        all[k] = &parts[k];
        yk_pace_stage(&report->pace, (double)k / SECTIONS, (double)(k + 1) / SECTIONS);
        if (!report->pace.is_stopped) sections[k].write(report, all[k], problems);
        if (parts[k].failed) yk_text_fail(html);
    }
    open_page(report, html);
    add_subtitle(report, html);
    add_contents(all, html);
    for (size_t k = 0; k < SECTIONS; k++) {
        add_section(&sections[k], all[k], html);
        yk_text_free(all[k]);
    }
    yk_text_format(html, "</main>\n<footer><p>Made by yoke %s.</p></footer>\n", yk_version());
    if (is_moving(report)) add_data(report, html);
    yk_text_puts(html, "</body>\n</html>\n");
}

const char *yk_report_html(YkReportPage *report, YkProblems *problems)
{
    yk_pace_begin(&report->pace, report->progress);
    if (report->html.length == 0 && !report->pace.is_stopped) write_page(report, problems);
    report->pace.progress = (YkProgress){0};
    if (report->pace.is_stopped) {
        yk_text_free(&report->html);
        yk_problem_stopped(problems);
        return NULL;
    }
    if (!report->html.failed && !report->failed) return yk_text_get(&report->html);
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory");
    return NULL;
}
