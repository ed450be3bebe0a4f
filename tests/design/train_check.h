// Shared by the tests of gear trains: a train from text, and its answers by name.
#ifndef TESTS_DESIGN_TRAIN_CHECK_H
#define TESTS_DESIGN_TRAIN_CHECK_H
#include <yoke/train.h>
#include "check.h"
#include "base/problems.h"
#include "base/vec.h"

#define RPM (YK_PI / 30)

typedef struct Train {
    YkModel *model;
    YkTrain *train;
    YkProblems *problems;
} Train;

static inline Train train_ask(YkModel *model, const YkTrainOptions *options)
{
    Train t = {.model = model, .problems = yk_problems_new()};
    assert_non_null(model);
    t.train = yk_train_new(t.model, options, t.problems);
    return t;
}

static inline YkModel *train_parse(const char *text)
{
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "train.yaml", NULL, problems);
    if (!model) print_error("%s\n%s", text, yk_problems_text(problems, 0));
    yk_problems_free(problems);
    return model;
}

static inline Train train_of(const char *text, const YkTrainOptions *options)
{
    Train t = train_ask(train_parse(text), options);
    if (!t.train) print_error("%s\n%s", text, yk_problems_text(t.problems, 0));
    assert_non_null(t.train);
    return t;
}

static inline Train train_example(const char *name, const YkTrainOptions *options)
{
    char path[500];
    snprintf(path, sizeof path, YOKE_ROOT "/examples/%s.yaml", name);
    Train t = train_ask(yk_model_load(path, NULL, NULL), options);
    if (!t.train) print_error("%s", yk_problems_text(t.problems, 0));
    assert_non_null(t.train);
    return t;
}

static inline void train_done(Train *t)
{
    yk_train_free(t->train);
    yk_model_free(t->model);
    yk_problems_free(t->problems);
}

static inline YkTrainBody train_body(const Train *t, const char *name)
{
    for (size_t i = 0; i < yk_train_body_count(t->train); i++) {
        YkTrainBody body = yk_train_body(t->train, i);
        if (strcmp(yk_model_body_name(t->model, body.body), name) == 0) return body;
    }
    print_error("no body %s\n", name);
    fail();
    return (YkTrainBody){0};
}

static inline YkTrainShare train_share(const Train *t, const char *name, size_t input)
{
    for (size_t i = 0; i < yk_train_body_count(t->train); i++)
        if (strcmp(yk_model_body_name(t->model, yk_train_body(t->train, i).body), name) == 0)
            return yk_train_share(t->train, i, input);
    fail();
    return (YkTrainShare){0};
}

static inline YkTrainTorque train_torque(const Train *t, const char *name)
{
    for (size_t i = 0; i < yk_train_torque_count(t->train); i++)
        if (strcmp(yk_train_torque(t->train, i).name, name) == 0) return yk_train_torque(t->train, i);
    print_error("no torque at %s\n%s", name, yk_problems_text(t->problems, 0));
    fail();
    return (YkTrainTorque){0};
}

#endif
