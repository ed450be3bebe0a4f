// Everything is allocated while loading and compiling: solving, sweeping over poses by hand and running a batch ask the
// allocator for nothing. Every request of the process is counted, those that the C library makes for itself too.
#include "interposed.h"
#include <yoke/yoke.h>

typedef struct Machine {
    YkProblems *problems;
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
} Machine;

static Machine load(const char *file)
{
    char path[512];
    snprintf(path, sizeof path, "%s/examples/%s", YOKE_ROOT, file);
    Machine machine = {.problems = yk_problems_new()};
    machine.model = yk_model_load(path, NULL, machine.problems);
    if (!machine.model) print_error("%s", yk_problems_text(machine.problems, 0));
    assert_non_null(machine.model);
    machine.mech = yk_mechanism_compile(machine.model, NULL, machine.problems);
    assert_non_null(machine.mech);
    machine.state = yk_state_new(machine.mech);
    assert_non_null(machine.state);
    assert_true(yk_state_set_time(machine.state, 0, machine.problems) >= 0);
    assert_true(yk_state_assemble(machine.state) >= 0);
    return machine;
}

static void unload(Machine *machine)
{
    yk_state_free(machine->state);
    yk_mechanism_free(machine->mech);
    yk_model_free(machine->model);
    yk_problems_free(machine->problems);
}

// Keeps the compiler from removing an allocation whose result is not used.
static void *volatile sink;

static void test_the_counter_sees_every_way_to_allocate(void **unused)
{
    (void)unused;
    long before = requests;
    sink = malloc(10);
    assert_int_equal(requests - before, 1);
    sink = realloc(sink, 1000);
    assert_int_equal(requests - before, 2);
    free(sink);
    sink = calloc(3, 5);
    free(sink);
    sink = aligned_alloc(64, 128);
    free(sink);
    assert_int_equal(requests - before, 4);
}

// Turns the input by small steps, solves and reads every kind of answer at each pose.
static void check_solving_allocates_nothing(const char *file, double step, int poses)
{
    Machine machine = load(file);
    const YkMotion start = yk_state_input(machine.state, 0);
    YkState *copy = yk_state_new(machine.mech);
    assert_non_null(copy);
    char label[64];
    double sum = 0;
    const long before = requests;
    for (int pose = 0; pose < poses; pose++) {
        yk_state_set_input(machine.state, 0,
                           (YkMotion){start.position + step * pose, start.velocity, start.acceleration});
        if (yk_state_solve(machine.state) < 0) continue;
        for (size_t i = 0; i < yk_coordinate_count(machine.mech); i++)
            sum += yk_state_coordinate(machine.state, i).acceleration;
        for (size_t i = 0; i < yk_model_point_count(machine.model); i++)
            sum += yk_state_point(machine.state, i).velocity[0];
        sum += yk_state_residuals(machine.state).position;
        yk_state_label(machine.state, label, sizeof label);
        yk_state_copy(copy, machine.state);
    }
    const long after = requests;
    assert_true(isfinite(sum));
    assert_int_equal(after - before, 0);
    yk_state_free(copy);
    unload(&machine);
}

static void test_solving_dyads_allocates_nothing(void **unused)
{
    (void)unused;
    check_solving_allocates_nothing("quick-return.yaml", 0.01, 200);
    check_solving_allocates_nothing("jansen.yaml", 0.05, 200);
}

static void test_solving_a_group_by_iteration_allocates_nothing(void **unused)
{
    (void)unused;
    check_solving_allocates_nothing("stephenson-awkward.yaml", 0.002, 100);
}

static void test_failing_to_close_allocates_nothing(void **unused)
{
    (void)unused;
    check_solving_allocates_nothing("quick-return.yaml", 0.1, 63); // far past both limits
}

static void test_another_time_allocates_nothing(void **unused)
{
    (void)unused;
    Machine machine = load("quick-return.yaml");
    const long before = requests;
    for (int i = 0; i < 100; i++) {
        assert_int_equal(yk_state_set_time(machine.state, -0.02 * i, machine.problems), YK_OK);
        assert_int_equal(yk_state_solve(machine.state), YK_OK);
    }
    assert_int_equal(requests - before, 0);
    unload(&machine);
}

enum { POSES = 1000, CHANNELS = 6 };
static double angles[POSES], velocities[POSES], results[CHANNELS][POSES];

static void test_running_a_batch_allocates_nothing(void **unused)
{
    (void)unused;
    static const char *const names[CHANNELS] = {"theta2", "d5", "d5.rate", "d5.accel", "ram.C.x", "lever.angle"};
    Machine machine = load("quick-return.yaml");
    YkChannel channels[CHANNELS];
    double *outputs[CHANNELS];
    for (size_t i = 0; i < CHANNELS; i++) {
        assert_int_equal(yk_channel_parse(machine.mech, names[i], &channels[i], machine.problems), YK_OK);
        outputs[i] = results[i];
    }
    for (size_t i = 0; i < POSES; i++) {
        angles[i] = 3.0 * (double)i / POSES;
        velocities[i] = -0.5;
    }
    const double *inputs[3] = {angles, velocities, NULL};
    YkBatch *batch = yk_batch_new(machine.state, channels, CHANNELS);
    assert_non_null(batch);
    static signed char status[POSES];
    const long before = requests;
    assert_int_equal(yk_batch_run(batch, inputs, outputs, status, POSES), YK_OK);
    assert_int_equal(yk_batch_run(batch, inputs, outputs, NULL, 1), YK_OK);
    assert_int_equal(requests - before, 0);
    yk_batch_free(batch);
    unload(&machine);
}

int main(void)
{
    start_counting();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_counter_sees_every_way_to_allocate),
        cmocka_unit_test(test_solving_dyads_allocates_nothing),
        cmocka_unit_test(test_solving_a_group_by_iteration_allocates_nothing),
        cmocka_unit_test(test_failing_to_close_allocates_nothing),
        cmocka_unit_test(test_another_time_allocates_nothing),
        cmocka_unit_test(test_running_a_batch_allocates_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
