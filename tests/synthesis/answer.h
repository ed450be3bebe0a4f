// Shared by the tests of synthesis: tasks as text, and candidates read again by the engine.
#ifndef TESTS_SYNTHESIS_TASK_H
#define TESTS_SYNTHESIS_TASK_H
#include "check.h"
#include <stdlib.h>
#include <yoke/yoke.h>

typedef struct Answer {
    YkTask *task;
    YkSynthesis *synthesis;
} Answer;

static inline Answer answer_with(const char *text, const YkSynthesisOptions *options)
{
    YkProblems *problems = yk_problems_new();
    Answer a = {.task = yk_task_parse(text, strlen(text), "test.yaml", problems)};
    if (a.task) a.synthesis = yk_synthesis_run(a.task, options, problems);
    if (!a.synthesis) print_error("%s\n%s", text, yk_problems_text(problems, 0));
    yk_problems_free(problems);
    assert_non_null(a.synthesis);
    return a;
}
static inline Answer answer_to(const char *text)
{
    return answer_with(text, NULL);
}
static inline void answer_free(Answer *a)
{
    yk_synthesis_free(a->synthesis);
    yk_task_free(a->task);
}

// A candidate's file as a machine, standing at its start.
typedef struct Standing {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
} Standing;

static inline Standing standing(const char *model)
{
    YkProblems *problems = yk_problems_new();
    Standing s = {.model = yk_model_parse(model, strlen(model), "candidate.yaml", NULL, problems)};
    if (!s.model) print_error("%s\n%s", model, yk_problems_text(problems, 0));
    assert_non_null(s.model);
    s.mech = yk_mechanism_compile(s.model, NULL, problems);
    assert_non_null(s.mech);
    assert_int_equal(yk_problems_count(problems), 0);
    s.state = yk_state_new(s.mech);
    assert_int_equal(yk_state_set_time(s.state, 0, problems), YK_OK);
    assert_true(yk_state_assemble(s.state) >= 0);
    yk_problems_free(problems);
    return s;
}
// What is said of a candidate's parameters is what its file has under their names.
static inline void check_parameters(const YkSynthesis *synthesis, size_t candidate)
{
    Standing s = standing(yk_synthesis_candidate(synthesis, candidate).model);
    double value = NAN;
    size_t named = 0;
    for (size_t k = 0;; k++) {
        const char *name = yk_synthesis_parameter(synthesis, candidate, k, &value);
        double own = name ? yk_model_parameter(s.model, name) : NAN;
        if (!name) break;
        if (isfinite(own)) named++;
        if (isfinite(own)) CHECK_NEAR(value, own, 1e-12 * (fabs(own) + 1));
    }
    assert_true(named >= 4);
    yk_state_free(s.state);
    yk_mechanism_free(s.mech);
    yk_model_free(s.model);
}
static inline void standing_free(Standing *s)
{
    yk_state_free(s->state);
    yk_mechanism_free(s->mech);
    yk_model_free(s->model);
}

#endif
