// Geared five-bars: what exclusion finds is what a fine walk along the five-bar without its gear finds, by closed form.
#include <yoke/configurations.h>
#include "configurations/geared_chain.h"

typedef struct Seen {
    const Chain *chain;
    const YkMechanism *mech;
    size_t count;
} Seen;

// Every configuration closes, and keeps the phase of the wheels.
static bool see(void *context, YkState *state)
{
    Seen *seen = context;
    static const char *const names[] = {"t1", "t2", "t3", "t4"};
    double angle[LINKS], sum = 0;
    YkVec end = {0, 0}, wanted = end_of(seen->chain);
    for (int k = 0; k < LINKS; k++) {
        angle[k] = sum += yk_state_coordinate(state, yk_coordinate_find(seen->mech, names[k])).position;
        end = yk_add(end, yk_scale(seen->chain->length[k], yk_unit(angle[k])));
    }
    CHECK_NEAR(end.x, wanted.x, 1e-9);
    CHECK_NEAR(end.y, wanted.y, 1e-9);
    CHECK_NEAR(yk_nearest_turn(roll(seen->chain, angle[B], angle[C], angle[D]), 0), 0, 1e-7);
    seen->count++;
    return true;
}

static void test_all_poses_of_geared_five_bars_are_found(void **unused)
{
    (void)unused;
    uint64_t seed = 12;
    size_t most = 0, incomplete = 0, cases = check_cases(60);
    for (size_t k = 0; k < cases; k++) {
        Chain chain = {.teeth = {10 + 5 * (int)(5 * check_uniform(&seed, 0, 1)), 20}};
        for (int j = 0; j < LINKS; j++) {
            chain.length[j] = check_uniform(&seed, 0.5, 3);
            chain.angle[j] = check_uniform(&seed, -YK_PI, YK_PI);
        }
        Machine m = machine_of(&chain);
        assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
        YkConfigurations *all = yk_configurations_new(m.mech);
        YkConfigurationsReport r;
        Seen seen = {&chain, m.mech, 0};
        assert_int_equal(yk_configurations_each(all, m.state, NULL, see, &seen, &r), YK_OK);
        if (r.complete && seen.count != count_along(&chain))
            print_error("case %zu: %zu, not %zu\n", k, seen.count, count_along(&chain));
        if (r.complete) assert_int_equal(seen.count, count_along(&chain));
        if (r.complete) assert_int_equal(r.reason, YK_COMPLETE_BY_EXCLUSION);
        if (!r.complete) print_message("case %zu: %s\n", k, r.message);
        incomplete += !r.complete;
        most = seen.count > most ? seen.count : most;
        yk_configurations_free(all);
        machine_free(&m);
    }
    print_message("at most %zu configurations; %zu not proved\n", most, incomplete);
    assert_int_equal(incomplete, 0);
    assert_true(most >= 8);
}

// Two poses that coincide cannot be separated, and the answer says so.
static void test_a_double_pose_is_not_claimed(void **unused)
{
    (void)unused;
    // With equal wheels and all links in line, the five-bar stands at a dead point of its gear.
    Chain chain = {.length = {1, 2, 1.5, 2.5}, .angle = {0, 0, 0, 0}, .teeth = {20, 20}};
    Machine m = machine_of(&chain);
    YkConfigurations *all = yk_configurations_new(m.mech);
    YkConfigurationsReport r;
    yk_configurations_each(all, m.state, NULL, NULL, NULL, &r);
    assert_false(r.complete);
    yk_configurations_free(all);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_all_poses_of_geared_five_bars_are_found),
                                       cmocka_unit_test(test_a_double_pose_is_not_claimed)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
