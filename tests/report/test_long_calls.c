// Long calls that make something, watched and stopped: they end with a problem that says so, and nothing is left.
#include <stdlib.h>
#include "../solve/machine.h"
#include "../watched.h"
#include "derive/derive.h"
#include "ring/inside.h"

// Making a term of an element takes 500 ns at most, with all the work on it.
static const uint64_t TERMS_IN_50_MS = 100000;

typedef struct Subject {
    Machine m;
    char *text;
    YkPageFormat format;
    const char *equation;
    YkDerivation *derivation;
    Watched *w;
} Subject;

static Subject subject_of(size_t four_bars)
{
    Subject subject = {.text = ladder_text(four_bars)};
    subject.m = machine_parse(subject.text, true);
    return subject;
}

// Under the sanitizers a third of the machine asks often enough.
static size_t sized(size_t four_bars)
{
#ifdef IS_SANITIZED
    return four_bars / 3;
#else
    return four_bars;
#endif
}

static void release(Subject *subject)
{
    free(subject->text);
    machine_free(&subject->m);
}

// Returns whether it was stopped, which its problems then say.
static bool judge(bool is_made, YkProblems *problems)
{
    bool is_stopped = !is_made && is_told(problems);
    if (!is_made && !is_stopped) print_error("%s", yk_problems_text(problems, 0));
    assert_true(is_made || is_stopped);
    yk_problems_free(problems);
    return is_stopped;
}

// --- loading and compiling

static bool load(void *self, Watched *w, uint64_t *hash)
{
    Subject *subject = self;
    YkProblems *problems = yk_problems_new();
    YkLoadOptions options = yk_default_load_options();
    options.progress = progress_of(w);
    YkModel *model = yk_model_parse(subject->text, strlen(subject->text), "ladder.yaml", &options, problems);
    size_t counts[2] = {model ? yk_model_body_count(model) : 0, model ? yk_model_joint_count(model) : 0};
    *hash = hash_bytes(*hash, counts, sizeof counts);
    bool is_made = model != NULL;
    yk_model_free(model);
    return judge(is_made, problems);
}

static bool compile(void *self, Watched *w, uint64_t *hash)
{
    Subject *subject = self;
    YkProblems *problems = yk_problems_new();
    YkCompileOptions options = yk_default_compile_options();
    options.progress = progress_of(w);
    YkMechanism *mech = yk_mechanism_compile(subject->m.model, &options, problems);
    for (size_t b = 0; mech && b < yk_block_count(mech); b++) {
        YkBlockInfo info = yk_block_info(mech, b);
        *hash = hash_bytes(*hash, info.label, strlen(info.label));
    }
    bool is_made = mech != NULL;
    yk_mechanism_free(mech);
    return judge(is_made, problems);
}

static void loading_and_compiling_can_be_stopped(void **unused)
{
    (void)unused;
    Subject subject = subject_of(sized(3000));
    check_long_call("load", load, &subject);
    check_long_call("compile", compile, &subject);
    release(&subject);
}

// --- derivations

static bool count_terms(void *context, double part)
{
    Subject *subject = context;
    subject->w->done = subject->derivation->ring->made;
    return watch(subject->w, part);
}

static void begin(Subject *subject, Watched *w, YkProblems *problems)
{
    subject->w = w;
    subject->derivation = yk_derivation_new(subject->m.model, subject->m.mech, problems);
    assert_non_null(subject->derivation);
    if (w) yk_derivation_set_progress(subject->derivation, (YkProgress){count_terms, subject});
}

// A derivation that was stopped is spent: it says so whenever it is asked.
static bool print_page(void *self, Watched *w, uint64_t *hash)
{
    Subject *subject = self;
    YkProblems *problems = yk_problems_new(), *more = yk_problems_new();
    begin(subject, w, problems);
    YkPageOptions options = yk_default_page_options();
    options.format = subject->format;
    YkStatus status = yk_derivation_page(subject->derivation, &options, problems);
    assert_true(status == YK_OK || status == YK_STOPPED);
    const char *text = yk_derivation_text(subject->derivation);
    *hash = hash_bytes(*hash, text, strlen(text));
    if (status == YK_STOPPED) {
        assert_int_equal(strlen(text), 0);
        yk_derivation_set_progress(subject->derivation, (YkProgress){0});
        assert_int_equal(yk_derivation_page(subject->derivation, &options, more), YK_STOPPED);
        assert_true(is_told(more));
        assert_int_equal(yk_derivation_check(subject->derivation, subject->m.state, NULL, "t0 = 0", NULL).kind,
                         YK_CHECK_UNREADABLE);
    }
    yk_problems_free(more);
    yk_derivation_free(subject->derivation);
    return judge(status == YK_OK, problems);
}

static bool check_equation(void *self, Watched *w, uint64_t *hash)
{
    Subject *subject = self;
    YkProblems *problems = yk_problems_new();
    YkState *state = yk_state_new(subject->m.mech);
    assert_int_equal(yk_state_copy(state, subject->m.state), YK_OK);
    begin(subject, w, problems);
    YkCheckVerdict verdict = yk_derivation_check(subject->derivation, state, NULL, subject->equation, problems);
    *hash = hash_bytes(*hash, &verdict.kind, sizeof verdict.kind);
    *hash = hash_bytes(*hash, &verdict.poses, sizeof verdict.poses);
    yk_state_free(state);
    yk_derivation_free(subject->derivation);
    return judge(verdict.kind != YK_CHECK_UNREADABLE, problems);
}

static void derivations_can_be_stopped(void **unused)
{
    (void)unused;
    Subject subject = subject_of(sized(150));
    static const char *const names[] = {"text", "latex", "mathml", "json", "c"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        subject.format = yk_page_format_find(names[k]);
        assert_true(check_long_call(names[k], print_page, &subject) <= TERMS_IN_50_MS);
    }
    release(&subject);
}

static void checks_can_be_stopped(void **unused)
{
    (void)unused;
    Subject subject = subject_of(100);
    subject.equation = "0.1*cos(t0) + l*cos(t0 + u0) = l + 0.1*cos(t1) - 0.01*sin(t1)";
    check_long_call("check", check_equation, &subject);
    release(&subject);
}

// --- equilibria, code, the report

static bool find_rest(void *self, Watched *w, uint64_t *hash)
{
    Subject *subject = self;
    YkProblems *problems = yk_problems_new();
    YkRestOptions options = yk_default_rest_options();
    options.progress = progress_of(w);
    options.starts = 4000;
    YkRest *rest = yk_rest_find(subject->m.model, &options, problems);
    size_t count = rest ? yk_rest_count(rest) : 0;
    *hash = hash_bytes(*hash, &count, sizeof count);
    for (size_t k = 0; k < count; k++) {
        YkEquilibrium found = yk_rest_equilibrium(rest, k);
        *hash = hash_bytes(*hash, &found.potential, sizeof found.potential);
    }
    bool is_made = rest != NULL;
    yk_rest_free(rest);
    return judge(is_made, problems);
}

static void a_search_for_equilibria_can_be_stopped(void **unused)
{
    (void)unused;
    Subject subject = {.m = machine_load("double-pendulum")};
    check_long_call("rest", find_rest, &subject);
    release(&subject);
}

static void reaching_equilibria_can_be_stopped_and_asked_again(void **unused)
{
    (void)unused;
    Subject subject = {.m = machine_load("watt-with-masses")};
    Watched w = watched(0);
    YkRestOptions options = yk_default_rest_options();
    options.progress = progress_of(&w);
    YkRest *rest = yk_rest_find(subject.m.model, &options, subject.m.problems);
    if (!rest) print_error("%s", yk_problems_text(subject.m.problems, 0));
    assert_non_null(rest);
    w = watched(1);
    assert_int_equal(yk_rest_reach(rest), YK_STOPPED);
    for (size_t k = 0; k < yk_rest_count(rest); k++) assert_false(yk_rest_equilibrium(rest, k).is_reachable);
    w = watched(0);
    assert_int_equal(yk_rest_reach(rest), YK_OK);
    yk_rest_free(rest);
    release(&subject);
}

static bool print_code(void *self, Watched *w, uint64_t *hash)
{
    Subject *subject = self;
    YkProblems *problems = yk_problems_new();
    YkCSourceOptions options = yk_default_c_source_options();
    options.progress = progress_of(w);
    YkCSource *code = yk_c_source_new(subject->m.model, &options, problems);
    if (code) *hash = hash_bytes(*hash, yk_c_source_text(code), strlen(yk_c_source_text(code)));
    bool is_made = code != NULL;
    yk_c_source_free(code);
    return judge(is_made, problems);
}

static bool report(void *self, Watched *w, uint64_t *hash)
{
    Subject *subject = self;
    YkProblems *problems = yk_problems_new();
    assert_int_equal(yk_state_set_progress(subject->m.state, progress_of(w)), YK_OK);
    YkReportPage *page = yk_report_new(subject->m.state, NULL, problems);
    if (w) w->last = 0; // the other call
    const char *html = page ? yk_report_html(page, problems) : NULL;
    if (html) *hash = hash_bytes(*hash, html, strlen(html));
    bool is_made = html != NULL;
    yk_report_free(page);
    return judge(is_made, problems);
}

static void code_and_reports_can_be_stopped(void **unused)
{
    (void)unused;
    check_without_sanitizers();
    Subject subject = subject_of(60);
    check_long_call("code", print_code, &subject);
    assert_int_equal(yk_state_set_progress(subject.m.state, (YkProgress){watch, NULL}), YK_OK);
    check_long_call("report", report, &subject);
    release(&subject);
}

int main(void)
{
    start_counting();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loading_and_compiling_can_be_stopped),
        cmocka_unit_test(derivations_can_be_stopped),
        cmocka_unit_test(checks_can_be_stopped),
        cmocka_unit_test(a_search_for_equilibria_can_be_stopped),
        cmocka_unit_test(reaching_equilibria_can_be_stopped_and_asked_again),
        cmocka_unit_test(code_and_reports_can_be_stopped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
