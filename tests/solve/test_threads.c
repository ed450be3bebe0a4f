// One mechanism, many threads, one state each: every thread gets the answers that one alone gets.
#include "machine.h"
#include <pthread.h>

enum { THREADS = 4, POSES = 400, COORDINATES_MAX = 16 };

typedef struct Job {
    const YkMechanism *mech;
    double start, span;
    double sum[COORDINATES_MAX];
    double swept;
    pthread_t thread;
} Job;

// Everything that touches the mechanism: assembling, solving, all configurations, a sweep, a batch.
static bool count(void *context, YkState *state)
{
    (void)state;
    (*(double *)context)++;
    return true;
}

static void *work(void *context)
{
    Job *job = context;
    YkState *state = yk_state_new(job->mech);
    if (!state || yk_state_assemble(state) < 0) return NULL;
    size_t n = yk_coordinate_count(job->mech);
    for (int k = 0; k < POSES; k++) {
        yk_state_set_input(state, 0, (YkMotion){job->start + job->span * k / POSES, 1, 0});
        if (yk_state_solve(state) < 0) continue;
        for (size_t c = 0; c < n; c++) job->sum[c] += yk_state_coordinate(state, c).acceleration;
    }
    yk_state_set_time(state, 0, NULL);
    yk_state_assemble(state);
    yk_state_each(state, count, &job->swept, NULL);
    YkSweepOptions options = yk_default_sweep_options();
    options.coordinate = (int)yk_input_coordinate(job->mech, 0);
    options.from = job->start;
    options.to = job->start + job->span;
    YkChannel channel = {YK_CHANNEL_COORDINATE, 1, 0, YK_QUANTITY_ANGLE};
    YkSweep *sweep = yk_sweep_run(state, &options, &channel, 1, NULL);
    for (size_t row = 0; sweep && row < yk_sweep_row_count(sweep); row++) job->swept += yk_sweep_value(sweep, row, 0);
    yk_sweep_free(sweep);
    YkBatch *batch = yk_batch_new(state, &channel, 1);
    double out[1], *outs[1] = {out};
    const double *in[COORDINATES_MAX * 3] = {0};
    if (batch) yk_batch_run(batch, in, outs, NULL, 1);
    job->swept += out[0];
    yk_batch_free(batch);
    yk_state_free(state);
    return NULL;
}

static void check_machine(const char *file, double span)
{
    Machine m = machine_load(file);
    Job alone = {.mech = m.mech, .start = yk_state_input(m.state, 0).position, .span = span}, jobs[THREADS];
    for (int k = 0; k < THREADS; k++) jobs[k] = alone;
    assert_true(yk_coordinate_count(m.mech) <= COORDINATES_MAX && yk_input_count(m.mech) <= COORDINATES_MAX);
    for (int k = 0; k < THREADS; k++) assert_int_equal(pthread_create(&jobs[k].thread, NULL, work, &jobs[k]), 0);
    for (int k = 0; k < THREADS; k++) pthread_join(jobs[k].thread, NULL);
    work(&alone);
    assert_true(isfinite(alone.swept) && alone.swept != 0);
    for (int k = 0; k < THREADS; k++) {
        assert_memory_equal(jobs[k].sum, alone.sum, sizeof alone.sum);
        assert_memory_equal(&jobs[k].swept, &alone.swept, sizeof alone.swept);
    }
    machine_free(&m);
}

static void test_threads_that_share_a_mechanism_get_the_same_bits(void **unused)
{
    (void)unused;
    check_machine("jansen", 6);
    check_machine("parallelogram", 7);
    check_machine("stephenson-awkward", 0.5);
    check_machine("three-crank-parallelogram", 7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_threads_that_share_a_mechanism_get_the_same_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
