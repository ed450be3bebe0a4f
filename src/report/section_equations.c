// Writes the equations in symbols, with the values of the start beside them.
#include <stdlib.h>
#include <string.h>
#include "derive/derive.h"
#include "page/print.h"
#include "picture/free_body.h"
#include "report/html.h"
#include "report/report.h"

enum {
    BODIES_MAX = 32,
    PICTURES_MAX = 32,
    LENGTH_MAX = 400000
}; // of one part: longer ones belong in a file of their own

static void add_part(YkReportPage *report, YkDerivation *derivation, size_t section, YkText *html)
{
    const YkDeriveSectionEntry *entry = &yk_derive_sections[section];
    YkPage page = {.arena = yk_arena_new(), .ring = derivation->ring, .has_numbers = report->status >= 0};
    YkText part = {0};
    double *values = NULL;
    bool good = page.arena && yk_derive_write(derivation, section, &page);
    if (good && report->status >= 0) {
        values = calloc(yk_ring_symbol_count(derivation->ring) + 1, sizeof *values);
        if (!values) yk_text_fail(html);
        if (values) yk_derive_values(derivation, report->start, report->has_forces ? report->dynamics : NULL, values);
    }
    good = good && yk_page_write_part(&page, 3, values, &part);
    bool ran_out = !good && yk_derivation_fault(derivation) == YK_RING_MEMORY; // on the page, if not in the ring
    if (ran_out || part.failed || yk_arena_failed(page.arena) || yk_derivation_ran_out(derivation)) yk_text_fail(html);
    yk_text_format(html, "<div class=\"scroll equations\" tabindex=\"0\" role=\"region\" aria-label=\"%s\">\n",
                   entry->title);
    if (good && part.length <= LENGTH_MAX) {
        yk_text_add(html, yk_text_get(&part), part.length);
    } else {
        yk_text_format(html, "<h3>%s</h3>\n<p>%s <code>yoke derive --what %s</code> writes them.</p>\n", entry->title,
                       good ? "They are too long for this page:" : "They could not be written here:", entry->name);
    }
    yk_text_puts(html, "</div>\n");
    free(values);
    yk_text_free(&part);
    yk_arena_free(page.arena);
}

// Adds every body by itself with what acts on it, under the names of the equations.
static void add_pictures(YkReportPage *report, YkDerivation *derivation, YkText *html)
{
    YkDynamics *forces = report->has_forces ? report->dynamics : NULL;
    YkFreeBodyDrawings *pictures =
        report->status >= 0 ? yk_free_body_drawings_new(derivation, report->start, forces) : NULL;
    if (!pictures && yk_derivation_ran_out(derivation)) yk_text_fail(html);
    size_t all = pictures ? yk_free_body_drawings_count(pictures) : 0, count = all < PICTURES_MAX ? all : PICTURES_MAX;
    YkText told = {0};
    if (count > 0) yk_text_puts(html, "<div class=\"charts\">\n");
    for (size_t k = 0; k < count; k++) {
        const char *svg = yk_free_body_drawings_svg(pictures, k), *title = yk_free_body_drawings_title(pictures, k);
        yk_text_clear(&told);
        yk_text_format(&told, "Free body: %s with the forces that act on it, named as in the equations", title);
        if (!svg) yk_text_fail(html);
        if (svg) yk_html_picture(html, svg, yk_text_get(&told), "");
    }
    if (count > 0) yk_text_puts(html, "</div>\n");
    yk_text_free(&told);
    yk_free_body_drawings_free(pictures);
}

void yk_section_equations(YkReportPage *report, YkText *html, YkProblems *problems)
{
    (void)problems;
    if (report->model->body_count > BODIES_MAX) {
        yk_text_puts(html,
                     "<p>The machine is too large for its equations to be read on a page: <code>yoke derive</code> "
                     "writes them, part by part.</p>\n");
        return;
    }
    YkProblems *own = yk_problems_new();
    YkDerivation *derivation = own ? yk_derivation_new(report->model, report->mech, own) : NULL;
    yk_report_note_problems(report, own);
    if (derivation) yk_derivation_set_progress(derivation, yk_pace_within(&report->pace));
    if (derivation) yk_derivation_begin(derivation);
    if (derivation) {
        yk_text_puts(html, "<p>In SI units and radians.");
        yk_text_puts(html,
                     report->status >= 0 ? " After the last equals sign: the value at the start.</p>\n" : "</p>\n");
    } else if (own && yk_problems_count(own) > 0) {
        yk_html_element(html, "p", yk_problems_get(own, 0)->message);
    }
    for (size_t k = 0; derivation && yk_derive_sections[k].name; k++) {
        if (yk_derive_sections[k].is_of && !yk_derive_sections[k].is_of(report->model)) continue;
        add_part(report, derivation, k, html);
        if (strcmp(yk_derive_sections[k].name, "free-bodies") == 0) add_pictures(report, derivation, html);
    }
    yk_derivation_free(derivation);
    yk_problems_free(own);
}
