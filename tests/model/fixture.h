// Shared by the tests of the model: loads a text with its problems, and finds its parts.
#ifndef TESTS_MODEL_FIXTURE_H
#define TESTS_MODEL_FIXTURE_H
#include "check.h"
#include "base/problems.h"
#include "model/model.h"

// A crank and nothing more, to which a test adds what it is about.
#define CRANK                                                                                                          \
    "bodies: {crank: {points: {O: [0, 0], A: [0.1, 0]}}, ground: {points: {O: [0, 0]}}}\n"                             \
    "joints: {O: {pin: [ground, crank], angle: theta}}\n"

// Loads a text that must be right; its problems are printed and fail the test where there are errors.
static inline YkModel *fixture_load_with(const char *text, const YkLoadOptions *options)
{
    YkProblems *problems = yk_problems_new();
    assert_non_null(problems);
    YkModel *model = yk_model_parse(text, strlen(text), "folder/test.yaml", options, problems);
    if (!model) print_error("%s", yk_problems_text(problems, 0));
    yk_problems_free(problems);
    assert_non_null(model);
    return model;
}
static inline YkModel *fixture_load(const char *text)
{
    return fixture_load_with(text, NULL);
}

// Loads a text that must be wrong, and gives what was found.
static inline YkProblems *fixture_refuse_with(const char *text, const YkLoadOptions *options)
{
    YkProblems *problems = yk_problems_new();
    assert_non_null(problems);
    YkModel *model = yk_model_parse(text, strlen(text), "test.yaml", options, problems);
    if (model) print_error("should not load:\n%s", text);
    assert_null(model);
    assert_true(yk_problems_error_count(problems) > 0);
    return problems;
}
static inline YkProblems *fixture_refuse(const char *text)
{
    return fixture_refuse_with(text, NULL);
}

// The first problem of this code, or NULL.
static inline const YkProblem *fixture_problem(const YkProblems *problems, int code)
{
    for (size_t i = 0; i < yk_problems_count(problems); i++) {
        const YkProblem *problem = yk_problems_get(problems, i);
        if (problem->code == code) return problem;
    }
    return NULL;
}

// A text must be refused with this code at line:column, the message holding `part` (NULL: whatever), and nothing else.
static inline void fixture_refused(const char *text, int code, unsigned line, unsigned column, const char *part)
{
    YkProblems *problems = fixture_refuse(text);
    const YkProblem *problem = fixture_problem(problems, code);
    int is_right = problem && problem->place.line == line && problem->place.column == column &&
                   (!part || strstr(problem->message, part) || (problem->hint && strstr(problem->hint, part))) &&
                   yk_problems_error_count(problems) == 1;
    if (!is_right) {
        print_error("expected E%04d at %u:%u (%s), found\n%s", code, line, column, part ? part : "",
                    yk_problems_text(problems, 0));
    }
    yk_problems_free(problems);
    assert_true(is_right);
}

// Elements by name; a name that is not there fails the test.
#define FIXTURE_BY_NAME(type, function, items, count)                                                                  \
    static inline const type *function(const YkModel *model, const char *name)                                         \
    {                                                                                                                  \
        for (size_t i = 0; i < model->count; i++) {                                                                    \
            if (strcmp(model->items[i].name, name) == 0) return &model->items[i];                                      \
        }                                                                                                              \
        print_error("no `%s` among " #items "\n", name);                                                               \
        fail();                                                                                                        \
        return NULL;                                                                                                   \
    }
FIXTURE_BY_NAME(YkParameter, fixture_parameter, parameters, parameter_count)
FIXTURE_BY_NAME(YkBody, fixture_body, bodies, body_count)
FIXTURE_BY_NAME(YkJoint, fixture_joint, joints, joint_count)
FIXTURE_BY_NAME(YkCoordinate, fixture_coordinate, coordinates, coordinate_count)

static inline const YkPoint *fixture_point(const YkModel *model, const char *name)
{
    size_t index = yk_model_find_point(model, name);
    if (index == (size_t)-1) print_error("no point `%s`\n", name);
    assert_true(index < model->point_count);
    return &model->points[index];
}

#endif
