// Lists of configurations, and the state that they leave behind: each is the pose that a state standing there solves
// again, with the same rates and the same word on whether they exist; and afterwards the state goes on, to the last
// bit, as one that was never asked for the list.
#include "machine.h"

enum { SHOWN_MAX = 6 };

typedef struct List {
    const Machine *machine;
    YkState *copy;
    size_t shown, with_rates;
} List;

static void check_coordinate(const List *list, YkMotion shown, YkMotion again, bool is_distance)
{
    double size = is_distance ? yk_mechanism_size(list->machine->mech) : 1;
    double off = is_distance ? again.position - shown.position : angle_between(again.position, shown.position);
    CHECK_NEAR(off, 0, 1e-7 * size);
    if (!yk_state_has_rates(list->copy)) return;
    CHECK_NEAR(again.velocity, shown.velocity, 1e-6 * (size + fabs(shown.velocity)));
    CHECK_NEAR(again.acceleration, shown.acceleration, 1e-5 * (size + fabs(shown.acceleration)));
}

static bool show(void *context, YkState *state)
{
    List *list = context;
    const YkMechanism *mech = list->machine->mech;
    assert_true(yk_state_residuals(state).position < 1e-9);
    assert_int_equal(yk_state_copy(list->copy, state), YK_OK);
    assert_true(yk_state_solve(list->copy) >= 0);
    assert_int_equal(yk_state_has_rates(list->copy), yk_state_has_rates(state));
    for (size_t k = 0; k < yk_coordinate_count(mech); k++)
        check_coordinate(list, yk_state_coordinate(state, k), yk_state_coordinate(list->copy, k),
                         yk_coordinate_info(mech, k).is_distance);
    list->with_rates += yk_state_has_rates(state);
    return ++list->shown < SHOWN_MAX;
}

static void check_same_bits(const Machine *a, const Machine *b)
{
    for (size_t k = 0; k < yk_coordinate_count(a->mech); k++) {
        YkMotion p = yk_state_coordinate(a->state, k), q = yk_state_coordinate(b->state, k);
        assert_memory_equal(&p, &q, sizeof p);
    }
}

static void check_example(const char *file, size_t *with_rates)
{
    Machine m = machine_load(file), other = machine_load(file);
    if (yk_input_count(m.mech) > 0) {
        double from = yk_state_input(m.state, 0).position;
        machine_solve(&m, from, 1.3, -0.7);
        machine_solve(&other, from, 1.3, -0.7);
        List list = {&m, yk_state_new(m.mech), 0, 0};
        assert_non_null(list.copy);
        assert_int_equal(yk_state_each(m.state, show, &list, NULL), YK_OK);
        check_same_bits(&m, &other);
        double size =
            yk_coordinate_info(m.mech, yk_input_coordinate(m.mech, 0)).is_distance ? yk_mechanism_size(m.mech) : 1;
        for (int k = 1; k <= 5; k++) {
            double at = from + 1e-3 * k * size;
            assert_int_equal(machine_solve(&m, at, 1.3, -0.7), machine_solve(&other, at, 1.3, -0.7));
            check_same_bits(&m, &other);
        }
        *with_rates += list.with_rates;
        yk_state_free(list.copy);
    }
    machine_free(&m);
    machine_free(&other);
}

static void a_list_shows_poses_that_are_solved_again_and_changes_nothing(void **unused)
{
    (void)unused;
    size_t with_rates = 0;
    for (size_t k = 0; k < EXAMPLE_COUNT; k++) check_example(all_examples[k], &with_rates);
    assert_true(with_rates > EXAMPLE_COUNT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_list_shows_poses_that_are_solved_again_and_changes_nothing),
    };
    return cmocka_run_group_tests_name("solve/each", tests, NULL, NULL);
}
