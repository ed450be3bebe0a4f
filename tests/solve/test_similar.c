// The examples in other units (tests/similar.h): compiled alike, and similar in every number of every pose.
#include "../similar.h"

// So far apart that a tolerance without its unit, or with a wrong one, decides otherwise.
static const int units[][3] = {{37, 0, 0}, {-35, 24, 33}, {17, -29, -36}};

// Solves both at a time, and compares them.
static void check_time(Similar *a, Similar *b, double time)
{
    YkStatus one = yk_state_set_time(a->state, time, a->problems);
    SIMILAR_EQUAL(a->file, yk_state_set_time(b->state, similar_to(time, YK_QUANTITY_TIME), b->problems), one);
    if (one < 0) return;
    one = yk_state_solve(a->state);
    SIMILAR_EQUAL(a->file, yk_state_solve(b->state), one);
    similar_check_state(a, b);
}

// Turns the free inputs a little, with rates, and compares.
static void check_inputs(Similar *a, Similar *b, double by)
{
    for (size_t k = 0; k < yk_input_count(a->mech); k++) {
        YkCoordinateInfo info = yk_coordinate_info(a->mech, yk_input_coordinate(a->mech, k));
        if (info.has_drive) continue;
        YkMotion q = yk_state_input(a->state, k);
        q.position += by * (info.is_distance ? yk_mechanism_size(a->mech) : 1);
        q.velocity = 0.7 + 0.1 * (double)k;
        q.acceleration = -0.4;
        yk_state_set_input(a->state, k, q);
        yk_state_set_input(b->state, k, similar_motion(q, info.is_distance));
    }
    YkStatus one = yk_state_solve(a->state);
    SIMILAR_EQUAL(a->file, yk_state_solve(b->state), one);
    similar_check_state(a, b);
}

typedef struct Seen {
    Similar *a, *b;
    size_t count, wanted;
} Seen;

// Stops b at the configuration at which a stands.
static bool stop_at(void *context, YkState *state)
{
    Seen *seen = context;
    (void)state;
    if (seen->count++ < seen->wanted) return true;
    similar_check_state(seen->a, seen->b);
    return false;
}

static bool compare_each(void *context, YkState *state)
{
    Seen *seen = context;
    (void)state;
    seen->wanted = seen->count++;
    Seen inner = {seen->a, seen->b, 0, seen->wanted};
    yk_state_each(seen->b->state, stop_at, &inner, NULL);
    assert_int_equal(inner.count, seen->wanted + 1);
    return seen->count < 6;
}

static void check_pair(Similar *a, Similar *b, size_t unused)
{
    (void)unused;
    yk_state_each(a->state, compare_each, &(Seen){a, b, 0, 0}, NULL);
    check_time(a, b, 0.01);
    check_inputs(a, b, 0.01);
    check_inputs(a, b, 0.3);
}

static void test_every_example_in_other_units(void **unused)
{
    (void)unused;
    similar_each_pair(units, sizeof units / sizeof *units, check_pair);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_example_in_other_units),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
