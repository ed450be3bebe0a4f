// Studies under watch: stopped soon, asked on the calling thread alone, good as new afterwards.
#include "study_check.h"
#include "../watched.h"

enum { DESIGNS = 3000, POSES = 360 };
// A pose of a four-bar in lanes takes 100 ns at most, with everything: so many of them are 50 ms.
static const uint64_t POSES_IN_50_MS = 500000;

typedef struct Subject {
    Machine m;
    size_t threads;
    YkStudy *study;
    Watched now; // who watches the call that runs
    bool is_watched;
    double *values, *inputs, *outputs;
    YkExtent *extents;
    signed char *status;
} Subject;

// The study keeps who watches, the test exchanges it.
static bool pass_on(void *context, double part)
{
    Subject *subject = context;
    if (subject->is_watched) subject->now.done = (uint64_t)(part * (DESIGNS + 1) * POSES + 0.5);
    return !subject->is_watched || watch(&subject->now, part);
}

static void start(Subject *subject, size_t threads)
{
    const char *of[] = {"theta4"}, *parameters[] = {"b"};
    *subject = (Subject){.m = machine_load("four-bar"), .threads = threads};
    YkChannel channel = machine_channel(&subject->m, of[0]);
    YkStudyOptions options = {.parameters = parameters,
                              .parameter_count = 1,
                              .channels = &channel,
                              .channel_count = 1,
                              .threads = threads,
                              .progress = {pass_on, subject}};
    subject->study = yk_study_new(subject->m.state, &options, subject->m.problems);
    assert_non_null(subject->study);
    subject->values = calloc(DESIGNS, sizeof(double));
    subject->inputs = calloc(POSES, sizeof(double));
    subject->outputs = calloc(DESIGNS * POSES, sizeof(double));
    subject->extents = calloc(DESIGNS, sizeof(YkExtent));
    subject->status = calloc(DESIGNS * POSES, 1);
    for (size_t d = 0; d < DESIGNS; d++) subject->values[d] = 0.110 + 0.02 * (double)d / DESIGNS;
    double from = yk_state_input(subject->m.state, 0).position;
    for (size_t k = 0; k < POSES; k++) subject->inputs[k] = from + 6.28 * (double)k / POSES;
}

static void end(Subject *subject)
{
    yk_study_free(subject->study);
    free(subject->values);
    free(subject->inputs);
    free(subject->outputs);
    free(subject->extents);
    free(subject->status);
    machine_free(&subject->m);
}

static bool go(Subject *subject, Watched *w, bool reduces, uint64_t *hash)
{
    const double *parameters[] = {subject->values}, *inputs[] = {subject->inputs, NULL, NULL};
    double *outputs[] = {subject->outputs};
    YkStudyCase asked = {parameters, DESIGNS, inputs, POSES, false};
    subject->is_watched = w != NULL;
    if (w) subject->now = *w;
    YkStatus status = reduces ? yk_study_reduce(subject->study, &asked, subject->extents, subject->status, NULL)
                              : yk_study_run(subject->study, &asked, outputs, subject->status);
    if (w) *w = subject->now;
    if (reduces)
        *hash = hash_bytes(*hash, subject->extents, DESIGNS * sizeof(YkExtent));
    else
        *hash = hash_bytes(*hash, subject->outputs, DESIGNS * POSES * sizeof(double));
    return status == YK_STOPPED;
}

static bool reduce(void *self, Watched *w, uint64_t *hash)
{
    return go(self, w, true, hash);
}

static bool run(void *self, Watched *w, uint64_t *hash)
{
    return go(self, w, false, hash);
}

static void studies_can_be_stopped_on_one_thread(void **unused)
{
    (void)unused;
    Subject subject;
    start(&subject, 1);
    assert_true(check_long_call("reduce", reduce, &subject) <= POSES_IN_50_MS);
    assert_true(check_long_call("run", run, &subject) <= POSES_IN_50_MS);
    end(&subject);
}

// How often it asks depends on how the threads take turns: while the caller waits for a processor, the others may do
// all the work, so that only the first question is sure.
static void on_several_threads_the_caller_alone_is_asked(void **unused)
{
    (void)unused;
    Subject subject;
    start(&subject, 3);
    uint64_t plain = HASH, seen = HASH;
    assert_false(reduce(&subject, NULL, &plain));
    Watched w = watched(0);
    assert_false(reduce(&subject, &w, &seen));
    assert_true(w.asked >= 1 && w.is_fair && seen == plain);
    for (long at = 1; at <= 2; at++) {
        Watched stopped = watched(at);
        uint64_t unused_hash = HASH, again = HASH;
        bool is_stopped = reduce(&subject, &stopped, &unused_hash);
        assert_true(is_stopped == (stopped.asked == at) && stopped.asked <= at && stopped.asked >= 1);
        assert_true(stopped.is_fair && (is_stopped || unused_hash == plain));
        assert_false(reduce(&subject, NULL, &again));
        assert_true(again == plain);
    }
    end(&subject);
}

static void making_a_study_and_sensitivities_can_be_stopped(void **unused)
{
    (void)unused;
    Subject subject;
    start(&subject, 1);
    double derivative = 0, difference = 0, again = 0;
    assert_int_equal(yk_study_sensitivities(subject.study, NULL, &derivative, &difference), YK_OK);
    subject.is_watched = true;
    subject.now = watched(1);
    assert_int_equal(yk_study_sensitivities(subject.study, NULL, &again, &difference), YK_STOPPED);
    subject.is_watched = false;
    assert_int_equal(yk_study_sensitivities(subject.study, NULL, &again, &difference), YK_OK);
    assert_memory_equal(&again, &derivative, sizeof again);

    const char *parameters[] = {"b"};
    YkChannel channel = machine_channel(&subject.m, "theta4");
    Watched w = watched(1);
    YkStudyOptions options = {.parameters = parameters,
                              .parameter_count = 1,
                              .channels = &channel,
                              .channel_count = 1,
                              .threads = 2,
                              .progress = progress_of(&w)};
    YkProblems *problems = yk_problems_new();
    assert_null(yk_study_new(subject.m.state, &options, problems));
    assert_true(is_told(problems));
    yk_problems_free(problems);
    end(&subject);
}

int main(void)
{
    start_counting();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(studies_can_be_stopped_on_one_thread),
        cmocka_unit_test(on_several_threads_the_caller_alone_is_asked),
        cmocka_unit_test(making_a_study_and_sensitivities_can_be_stopped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
