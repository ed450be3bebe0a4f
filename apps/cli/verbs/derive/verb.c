// yoke derive: the machine's equations in symbols, and verdicts on equations of others.
#include <stdlib.h>
#include <string.h>
#include "base/names.h"
#include "reach.h"
#include "verbs/derive/derive.h"
#include "write/stream.h"

enum { SECTIONS_MAX = 32 };

static size_t section_count(void)
{
    size_t count = 0;
    while (yk_derive_sections[count].name) count++;
    return count;
}

static size_t find_section(const char *name, size_t length)
{
    size_t k = 0;
    while (yk_derive_sections[k].name &&
           (strlen(yk_derive_sections[k].name) != length || strncmp(yk_derive_sections[k].name, name, length) != 0))
        k++;
    return k;
}

static bool refuse_section(YkSession *session, const char *word, size_t length)
{
    YkText text = {0};
    const char *names[SECTIONS_MAX];
    size_t count = section_count();
    yk_text_add(&text, word, length);
    yk_problem(session->problems, YK_CODE_OPTION_VALUE, (YkPlace){0}, "--what has no part %q", yk_text_get(&text));
    for (size_t k = 0; k < count; k++) names[k] = yk_derive_sections[k].name;
    const char *near = yk_nearest(yk_text_get(&text), names, count);
    yk_text_clear(&text);
    for (size_t k = 0; k < count; k++) yk_text_format(&text, "%s, ", names[k]);
    if (near)
        yk_problem_hint(session->problems, "did you mean `%s`?", near);
    else
        yk_problem_hint(session->problems, "%sall", yk_text_get(&text));
    yk_text_free(&text);
    return false;
}

// Reads "loops,jacobian" or "all" into wanted[section]. Without the option: all that the machine has.
static bool read_what(YkSession *session, bool *wanted)
{
    const char *word = session->request->what;
    if (!word || strcmp(word, "all") == 0) {
        for (size_t k = 0; k < section_count(); k++)
            wanted[k] = !yk_derive_sections[k].is_of || yk_derive_sections[k].is_of(session->model);
        return true;
    }
    while (*word) {
        size_t length = strcspn(word, ","), k = find_section(word, length);
        if (!yk_derive_sections[k].name) return refuse_section(session, word, length);
        wanted[k] = true;
        word += length + (word[length] == ',');
    }
    return true;
}

static bool read_format(YkSession *session, YkPageFormat *format)
{
    const char *word = session->request->format_word;
    *format = word ? yk_page_format_find(word) : YK_PAGE_TEXT;
    if (*format < YK_PAGE_FORMATS) return true;
    return yk_session_refuse(session, YK_CODE_OPTION_VALUE,
                             "--format takes text, latex, mathml, json or c here, not %q", word);
}

bool yk_derive_pose(YkSession *session)
{
    if ((!session->state && !yk_session_inputs(session)) || !yk_session_forces(session, false)) return false;
    YkStatus status = yk_session_reach(session, NULL);
    if (status < 0) {
        yk_reach_tell(session, status);
        return false;
    }
    const char *message = yk_state_report(session->state)->message;
    if (session->dynamics) {
        status = yk_dynamics_solve(session->dynamics, session->state, YK_METHOD_REDUCED);
        if (status < 0) message = yk_dynamics_report(session->dynamics)->message;
    }
    yk_tell_status(session, status, message);
    return status >= 0;
}

// Says at which section it stopped, and why.
static int cannot(YkSession *session, const YkDerivation *derivation, const YkPage *page)
{
    YkRingStatus why = yk_ring_status(derivation->ring);
    size_t k = page->section ? find_section(page->section, strlen(page->section)) : section_count();
    if (why == YK_RING_OK || yk_derivation_ran_out(derivation)) why = YK_RING_MEMORY; // of the page
    if (k == section_count()) {
        yk_session_refuse(session, yk_derive_code(why), "%s", yk_ring_status_text(why));
        return why == YK_RING_MEMORY ? YK_EXIT_WRONG : YK_EXIT_NO_ANSWER;
    }
    yk_problem(session->problems, yk_derive_code(why), (YkPlace){0}, "%s (--what %s): %s", yk_derive_sections[k].title,
               page->section, yk_ring_status_text(why));
    if (why == YK_RING_SIZE)
        yk_problem_hint(session->problems,
                        "ask for other parts with --what, as in `--what loops,jacobian`: products of "
                        "long sums do not occur in them");
    if (why == YK_RING_OVERFLOW)
        yk_problem_hint(session->problems, "numbers of many digits can be given as `parameters:`, which are symbols; "
                                           "other parts may be asked for with --what");
    return why == YK_RING_MEMORY ? YK_EXIT_WRONG : YK_EXIT_NO_ANSWER;
}

// A page in parts, so that a large machine needs neither memory for the whole nor patience for the first lines. A
// file appears whole or not at all.
typedef struct Parts {
    YkSession *session;
    YkPrinting printing;
    YkStream stream;
    bool good;
} Parts;

enum { BYTES_AT_ONCE = 1 << 22 }; // a smaller page is written at once, to standard output too

static bool flush(Parts *parts)
{
    YkText *out = &parts->session->out;
    bool good = !out->failed;
    if (!good) yk_session_refuse(parts->session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
    if (good && !parts->stream.is_open)
        good = yk_stream_open(&parts->stream, parts->session->request->output, parts->session->problems);
    good = good && yk_stream_write(&parts->stream, yk_text_get(out), out->length, parts->session->problems);
    yk_text_clear(out);
    return good;
}

static void put_part(void *context, YkPage *page)
{
    Parts *parts = context;
    if (!yk_page_add_part(&parts->printing, page)) page->failed = true;
    yk_page_forget(page);
    if (parts->session->out.length >= BYTES_AT_ONCE && parts->good) parts->good = flush(parts);
    page->failed |= !parts->good;
}

static int finish_parts(Parts *parts, YkDerivation *derivation, const YkPage *page, bool derived)
{
    YkSession *session = parts->session;
    derived = derived && !yk_derivation_ran_out(derivation);
    if (!derived || !parts->good) { // the latter was reported
        yk_stream_drop(&parts->stream);
        return parts->good ? cannot(session, derivation, page) : YK_EXIT_WRONG;
    }
    if (!parts->stream.is_open) return yk_session_finish(session, YK_EXIT_DONE);
    if (!flush(parts)) {
        yk_stream_drop(&parts->stream);
        return YK_EXIT_WRONG;
    }
    return yk_stream_close(&parts->stream, session->problems) ? YK_EXIT_DONE : YK_EXIT_WRONG;
}

static int write_parts(YkSession *session, YkDerivation *derivation, YkPage *page, YkPageFormat format,
                       const bool *wanted)
{
    Parts parts = {.session = session, .good = true};
    parts.printing = (YkPrinting){
        .ring = derivation->ring, .text = &session->out, .title = yk_model_name(session->model), .format = format};
    page->passing = yk_arena_new();
    page->part_ends = put_part, page->context = &parts;
    bool derived = page->passing != NULL;
    for (size_t k = 0; yk_derive_sections[k].name && derived; k++)
        derived = !wanted[k] || yk_derive_write(derivation, k, page);
    if (derived) put_part(&parts, page);
    bool ended = yk_page_end_parts(&parts.printing);
    yk_arena_free(page->passing);
    return finish_parts(&parts, derivation, page, derived && ended && !page->failed);
}

static int write_page(YkSession *session, YkDerivation *derivation, YkPage *page, YkPageFormat format,
                      const bool *wanted)
{
    double *values = NULL;
    if (yk_page_has_parts(format) && !session->request->numbers)
        return write_parts(session, derivation, page, format, wanted);
    for (size_t k = 0; yk_derive_sections[k].name; k++)
        if (wanted[k] && !yk_derive_write(derivation, k, page)) return cannot(session, derivation, page);
    if (session->request->numbers) {
        if (!yk_derive_pose(session)) return YK_EXIT_NO_ANSWER;
        // Printing may enter a few more symbols, none of which is in a formula.
        values = calloc(yk_ring_symbol_count(derivation->ring) + 1, sizeof *values);
        if (!values) yk_text_fail(&session->out);
        if (values) yk_derive_values(derivation, session->state, session->dynamics, values);
    }
    bool good = yk_page_write(page, format, yk_model_name(session->model), values, &session->out);
    free(values);
    session->ran_out |= yk_derivation_ran_out(derivation);
    if (!good) return cannot(session, derivation, page);
    return yk_session_finish(session, YK_EXIT_DONE);
}

static int derive(YkSession *session, YkDerivation *derivation, YkPageFormat format)
{
    bool wanted[SECTIONS_MAX] = {false};
    if (session->request->checks.count > 0) {
        if (!yk_derive_pose(session)) return YK_EXIT_NO_ANSWER;
        return yk_derive_checks(session, derivation, format == YK_PAGE_JSON);
    }
    if (!read_what(session, wanted)) return YK_EXIT_WRONG;
    int drawn = session->request->svg ? yk_derive_drawings(session, derivation) : YK_EXIT_DONE;
    if (drawn != YK_EXIT_DONE) return drawn;
    YkPage page = {.arena = yk_arena_new(), .ring = derivation->ring, .has_numbers = session->request->numbers};
    int exit_code =
        page.arena ? write_page(session, derivation, &page, format, wanted) : cannot(session, derivation, &page);
    yk_arena_free(page.arena);
    return exit_code;
}

int yk_run_derive(YkSession *session)
{
    YkPageFormat format;
    if (!read_format(session, &format) || !yk_session_load(session, NULL)) return YK_EXIT_WRONG;
    YkDerivation *derivation = yk_derivation_new(session->model, session->mech, session->problems);
    int exit_code = derivation ? derive(session, derivation, format) : YK_EXIT_NO_ANSWER;
    yk_derivation_free(derivation);
    return exit_code;
}
