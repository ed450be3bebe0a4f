// A simulation, ready for a test.
#ifndef TESTS_DYNAMICS_RUN_H
#define TESTS_DYNAMICS_RUN_H
#include <stdlib.h>
#include <yoke/yoke.h>
#include "check.h"

typedef struct Run {
    YkModel *model;
    YkSimulation *sim;
    YkProblems *problems;
} Run;

static inline Run run_of_model(YkModel *model, YkProblems *problems, YkSimulationOptions options)
{
    Run run = {.model = model, .problems = problems};
    if (model) run.sim = yk_simulation_new(model, &options, problems);
    if (!run.sim)
        for (size_t k = 0; k < yk_problems_count(problems); k++)
            print_error("%s\n", yk_problems_get(problems, k)->message);
    assert_non_null(run.sim);
    return run;
}

static inline YkSimulationOptions run_options(double tolerance)
{
    YkSimulationOptions options = yk_default_simulation_options();
    options.tolerance = tolerance;
    return options;
}

static inline Run run_of_text(const char *text, YkSimulationOptions options)
{
    YkProblems *problems = yk_problems_new();
    return run_of_model(yk_model_parse(text, strlen(text), "test.yaml", NULL, problems), problems, options);
}

static inline Run run_of_example(const char *name, YkSimulationOptions options)
{
    char path[512];
    YkProblems *problems = yk_problems_new();
    snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, name);
    return run_of_model(yk_model_load(path, NULL, problems), problems, options);
}

static inline void run_free(Run *run)
{
    yk_simulation_free(run->sim);
    yk_model_free(run->model);
    yk_problems_free(run->problems);
}

static inline double run_value(Run *run, const char *name)
{
    YkChannel channel = {0};
    const YkMechanism *mech = yk_state_mechanism(yk_simulation_state(run->sim));
    assert_int_equal(yk_channel_parse(mech, name, &channel, NULL), YK_OK);
    return yk_simulation_channel(run->sim, channel);
}

#endif
