// Studies whose allocations fail one after the other: each is refused, or says that it ran out, and the next one is
// right.
#include "../survive.h"
#include "study_check.h"
#include <yoke/blocks.h>

enum { DESIGNS = 3, POSES = 4, CHANNELS_MAX = 2 };

typedef struct Task {
    Machine m;
    const char *parameter, *channels[CHANNELS_MAX];
    double values[DESIGNS], inputs[POSES]; // of the parameter; of the first input, from its own on
    bool has_derivatives;                  // numbers of teeth have none
    double out[CHANNELS_MAX][DESIGNS * POSES];
} Task;

static Machine machine_of(const char *what)
{
    return strchr(what, '\n') ? machine_parse(what, true) : machine_load(what);
}

// what: the name of an example, or a text.
static Task begin(const char *what, const char *parameter, double step, const char *first, const char *second)
{
    Task t = {.m = machine_of(what), .parameter = parameter, .channels = {first, second}};
    double own = yk_model_parameter(t.m.model, parameter), at = yk_state_input(t.m.state, 0).position;
    for (size_t d = 0; d < DESIGNS; d++) t.values[d] = own + step * (double)d;
    for (size_t k = 0; k < POSES; k++) t.inputs[k] = at + 0.05 * (double)k;
    return t;
}

static YkStudy *study_new(Task *t, YkProblems *problems)
{
    YkChannel channels[CHANNELS_MAX];
    for (size_t c = 0; c < CHANNELS_MAX; c++)
        if (yk_channel_parse(t->m.mech, t->channels[c], &channels[c], problems) != YK_OK) return NULL;
    YkStudyOptions options = {.parameters = &t->parameter,
                              .parameter_count = 1,
                              .channels = channels,
                              .channel_count = CHANNELS_MAX,
                              .threads = 1};
    return yk_study_new(t->m.state, &options, problems);
}

// Answers in all four ways. A status below 0 other than that of memory is this test's own mistake.
static bool answer(void *context)
{
    Task *t = context;
    signed char status[DESIGNS * POSES];
    double rows[DESIGNS * 64], by[2][CHANNELS_MAX];
    YkExtent extents[CHANNELS_MAX * DESIGNS];
    size_t standing[DESIGNS];
    const double *parameters[] = {t->values}, *inputs[3 * 8] = {t->inputs};
    double *outputs[] = {t->out[0], t->out[1]};
    YkStudyCase asked = {.parameters = parameters, .design_count = DESIGNS, .inputs = inputs, .pose_count = POSES};
    YkDesignAxis axis = {.name = t->parameter, .from = t->values[0], .to = t->values[1], .count = 2};
    YkDesigns designs = {.axes = &axis, .axis_count = 1};
    YkRowCase row = {.designs = &designs, .inputs = inputs, .pose_count = POSES, .is_reduced = true};
    YkStudy *study = study_new(t, NULL);
    YkStatus worst = study ? yk_study_run(study, &asked, outputs, status) : YK_NO_MEMORY;
    if (worst >= 0) worst = yk_study_reduce(study, &asked, extents, status, standing);
    if (worst >= 0) worst = yk_study_rows(study, &row, 0, 2, rows);
    if (worst >= 0) worst = yk_study_sensitivities(study, NULL, by[0], by[1]);
    yk_study_free(study);
    if (worst < 0 && worst != YK_NO_MEMORY) fail_msg("%s: %s", t->parameter, yk_status_name(worst));
    return worst >= 0;
}

// Compares what stands there after all failures with another study, and the extents of the same.
static void check(const char *what, const char *parameter, double step, const char *first, const char *second)
{
    Task t = begin(what, parameter, step, first, second);
    assert_true(answer(&t));
    double before[CHANNELS_MAX][DESIGNS * POSES];
    memcpy(before, t.out, sizeof before);
    survive(answer, &t, parameter);
    assert_memory_equal(before, t.out, sizeof before);
    machine_free(&t.m);
}

static void dyads_survive(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    check("four-bar", "a", 1e-3, "theta4", "coupler.P.x.rate");
}

static void forces_survive(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    check("spring-slider-crank", "m2", 1e-3, "q.effort", "A.force");
}

static void groups_survive(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    check(TRIAD, "l", 1e-3, "theta2", "link.D.x");
}

static void machines_made_anew_survive(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    check(GEARED, "m", 5e-4, "x", "P.force");
}

typedef struct Motion {
    Machine m;
    const char *parameter;
    double value, out[2];
} Motion;

static bool accelerate(void *context)
{
    Motion *t = context;
    const double *parameters[] = {&t->value};
    double *accelerations[8] = {t->out, t->out + 1};
    signed char status = 0;
    YkMotionCase asked = {.parameters = parameters, .count = 1};
    YkMotionBatch *batch = yk_motion_batch_new(t->m.state, &t->parameter, 1, 1, NULL);
    YkStatus worst = batch ? yk_motion_batch_run(batch, &asked, accelerations, &status) : YK_NO_MEMORY;
    yk_motion_batch_free(batch);
    assert_true(worst >= 0 || worst == YK_NO_MEMORY);
    return worst >= 0;
}

static void motions_survive(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    static const char *const files[] = {"double-pendulum", "spring-slider-crank"}, *const parameters[] = {"m1", "m2"};
    for (size_t k = 0; k < 2; k++) {
        Motion t = {.m = machine_load(files[k]), .parameter = parameters[k]};
        t.value = 1.1 * yk_model_parameter(t.m.model, t.parameter);
        survive(accelerate, &t, files[k]);
        machine_free(&t.m);
    }
}

int main(void)
{
    start_counting();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dyads_survive),   cmocka_unit_test(forces_survive),
        cmocka_unit_test(groups_survive),  cmocka_unit_test(machines_made_anew_survive),
        cmocka_unit_test(motions_survive),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
