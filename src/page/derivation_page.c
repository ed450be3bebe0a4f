// A derivation's page for the public door: sections derived one by one, printed as they come.
#include <stdlib.h>
#include "derive/derive.h"
#include "page/print.h"

enum { BYTES_AT_ONCE = 1 << 22 }; // a page up to here is handed over at once

typedef struct Printer {
    YkDerivation *d;
    const YkPageOptions *options;
    YkPrinting printing;
    bool is_stopped; // by `write`
} Printer;

YkPageOptions yk_default_page_options(void)
{
    return (YkPageOptions){.format = YK_PAGE_TEXT};
}

const char *yk_derivation_text(const YkDerivation *d)
{
    return yk_text_get(&d->page);
}

static bool is_wanted(const YkDerivation *d, const YkPageOptions *options, size_t section)
{
    return options->sections ? options->sections[section] : yk_derivation_has_section(d, section);
}

// Hands over what is printed, where somebody takes it.
static bool hand_over(Printer *printer)
{
    YkText *text = &printer->d->page;
    if (text->failed) return false;
    if (!printer->options->write || text->length == 0) return true;
    printer->is_stopped = !printer->options->write(printer->options->context, yk_text_get(text), text->length);
    yk_text_clear(text);
    return !printer->is_stopped;
}

static void print_part(void *context, YkPage *page)
{
    Printer *printer = context;
    if (!yk_page_add_part(&printer->printing, page)) page->failed = true;
    yk_page_forget(page);
    bool is_long = printer->d->page.length >= BYTES_AT_ONCE;
    if (page->failed || printer->is_stopped || (is_long && !hand_over(printer))) page->failed = true;
}

static bool write_sections(Printer *printer, YkPage *page)
{
    bool good = true;
    for (size_t k = 0; yk_derive_sections[k].name && good; k++) {
        yk_pace_reach(&printer->d->pace, (double)k / (double)(yk_derivation_section_count() + 1)); // one: printing
        good = !is_wanted(printer->d, printer->options, k) || yk_derive_write(printer->d, k, page);
    }
    return good;
}

// Part by part: a large machine needs neither memory for the whole page nor patience for its first lines.
static bool write_parts(Printer *printer, YkPage *page)
{
    page->passing = yk_arena_new();
    page->part_ends = print_part;
    page->context = printer;
    bool good = page->passing && write_sections(printer, page);
    if (good) print_part(printer, page);
    good = yk_page_end_parts(&printer->printing) && good && !page->failed;
    yk_arena_free(page->passing);
    return good;
}

static bool write_whole(Printer *printer, YkPage *page)
{
    YkDerivation *d = printer->d;
    double *values = NULL;
    if (!write_sections(printer, page)) return false;
    if (printer->options->state) {
        values = yk_derive_scratch(d, yk_ring_symbol_count(d->ring) + 1, sizeof *values);
        if (!values) return false;
        yk_derive_values(d, printer->options->state, printer->options->dynamics, values);
    }
    bool good = yk_page_write(page, printer->options->format, d->model->name, values, &d->page);
    free(values);
    return good;
}

// The section at which it came to an end, and why.
static YkStatus cannot(YkDerivation *d, const YkPage *page, YkProblems *problems)
{
    YkRingStatus why = yk_derivation_fault(d);
    size_t section = page->section ? yk_derivation_section_find(page->section) : YK_NOT_FOUND;
    if (why == YK_RING_STOPPED)
        yk_problem_stopped(problems);
    else if (section == YK_NOT_FOUND)
        yk_problem(problems, yk_derive_code(why), (YkPlace){0}, "%s", yk_ring_status_text(why));
    else
        yk_problem(problems, yk_derive_code(why), (YkPlace){0}, "%s (%q): %s", yk_derive_sections[section].title,
                   page->section, yk_ring_status_text(why));
    if (why == YK_RING_SIZE)
        yk_problem_hint(problems, "other sections, such as `loops` and `jacobian`, contain no products of long sums; "
                                  "they can still be derived");
    if (why == YK_RING_OVERFLOW)
        yk_problem_hint(problems, "give numbers of many digits as `parameters:`, which are symbols; other sections can "
                                  "still be derived");
    if (why == YK_RING_STOPPED) return YK_STOPPED;
    return why == YK_RING_MEMORY ? YK_NO_MEMORY : YK_BAD_MODEL;
}

YkStatus yk_derivation_page(YkDerivation *d, const YkPageOptions *options, YkProblems *problems)
{
    const YkPageOptions defaults = yk_default_page_options();
    if (!options) options = &defaults;
    if (options->format >= YK_PAGE_FORMATS || (options->dynamics && !options->state)) return YK_BAD_ARGUMENT;
    yk_text_free(&d->page);
    Printer printer = {.d = d, .options = options};
    printer.printing =
        (YkPrinting){.ring = d->ring, .text = &d->page, .title = d->model->name, .format = options->format};
    YkPage page = {.arena = yk_arena_new(), .ring = d->ring, .has_numbers = options->state != NULL};
    bool has_parts = yk_page_has_parts(options->format) && !options->state;
    bool good = yk_derivation_begin(d) && page.arena &&
                (has_parts ? write_parts(&printer, &page) : write_whole(&printer, &page));
    good = good && !yk_derivation_ran_out(d) && hand_over(&printer);
    good = good && yk_ring_spend(d->ring, 0);
    yk_derivation_end(d);
    YkStatus status = good ? YK_OK : printer.is_stopped ? YK_STOPPED : cannot(d, &page, problems);
    if (!good) yk_text_free(&d->page);
    yk_arena_free(page.arena);
    return status;
}
