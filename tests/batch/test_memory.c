// Batches whose allocations fail one after the other: none is made that lacks something, and nothing is lost.
#include "../survive.h"
#include "batch/batch.h"
#include "solve/machine.h"

typedef struct Task {
    Machine m;
    YkChannel channels[3];
    size_t count;
    bool is_along;
    double due[3];
} Task;

static bool call(void *context)
{
    Task *t = context;
    const double *inputs[3] = {NULL, NULL, NULL};
    double out[3], *outputs[3] = {&out[0], &out[1], &out[2]};
    YkBatch *batch = t->is_along ? yk_batch_new_along(t->m.state, t->channels, t->count)
                                 : yk_batch_new(t->m.state, t->channels, t->count);
    if (!batch) return false;
    assert_int_equal(yk_batch_run(batch, inputs, outputs, NULL, 1), YK_OK);
    for (size_t c = 0; c < t->count; c++) CHECK_NEAR(out[c], t->due[c], 1e-9 * (1 + fabs(t->due[c])));
    yk_batch_free(batch);
    return true;
}

static void test_a_batch_without_memory_is_none(void **unused)
{
    (void)unused;
    for (int k = 0; k < 3; k++) {
        Task t = {.m = machine_load("compound-pendulum"), .count = k == 0 ? 2 : 3, .is_along = k == 2};
        t.channels[0] = machine_channel(&t.m, "theta");
        t.channels[1] = machine_channel(&t.m, "theta.rate");
        t.channels[2] = machine_channel(&t.m, "kinetic");
        t.due[0] = yk_state_channel(t.m.state, t.channels[0]);
        t.due[1] = yk_state_channel(t.m.state, t.channels[1]);
        survive(call, &t, "batch");
        machine_free(&t.m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_a_batch_without_memory_is_none)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
