// Compiling: what it costs as machines grow (to 1e5 links with YOKE_FULL=1 in the environment), and that the same model
// gives the same mechanism.
#include <stdlib.h>
#include "ladder.h"
#include "machine.h"
#include "table.h"

// What a link comes to in the mechanism: steps, terms, nodes and members, which compiling makes and solving reads.
static double cost_per_link(Story story, size_t links, size_t blocks, size_t inputs)
{
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(story.text, story.length, "long.yaml", NULL, problems);
    if (!model) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(model);
    YkMechanism *mech = yk_mechanism_compile(model, NULL, problems);
    if (!mech) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(mech);
    assert_int_equal(yk_block_count(mech), blocks);
    assert_int_equal(yk_input_count(mech), inputs);
    double cost = (double)(mech->step_count + mech->term_count + mech->node_count + mech->member_count);
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
    free(story.text);
    return cost / (double)links;
}

static void check_growth(double few, double many)
{
    assert_true(many <= 1.1 * few);
}

static void a_ladder_of_four_bars_costs_the_same_per_link_however_long(void **state)
{
    (void)state;
    double first = cost_per_link(ladder(1000), 2001, 1000, 1);
    double second = cost_per_link(ladder(10000), 20001, 10000, 1);
    check_growth(first, second);
    if (getenv("YOKE_FULL")) check_growth(second, cost_per_link(ladder(100000), 200001, 100000, 1));
}

static void a_driven_chain_costs_the_same_per_link_however_long(void **state)
{
    (void)state;
    double first = cost_per_link(chain(1000), 1000, 0, 1000);
    double second = cost_per_link(chain(10000), 10000, 0, 10000);
    check_growth(first, second);
    if (getenv("YOKE_FULL")) check_growth(second, cost_per_link(chain(100000), 100000, 0, 100000));
}

// The origin of the last body of a chain must not be a sum over all before it.
static void sums_stay_short_however_deep_the_machine(void **state)
{
    (void)state;
    Story story = chain(3000);
    Machine m = machine(story.text);
    for (size_t b = 0; b < m.model->body_count; b++) assert_true(m.mech->bodies[b].origin.count <= 4);
    assert_true(m.mech->term_count < 20 * m.model->body_count);
    machine_free(&m);
    free(story.text);
}

static void compiling_twice_gives_the_same(void **state)
{
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine a = machine(machines[k].source);
        YkMechanism *b = yk_mechanism_compile(a.model, NULL, a.problems);
        assert_non_null(b);
        assert_int_equal(a.mech->step_count, b->step_count);
        assert_int_equal(a.mech->term_count, b->term_count);
        for (size_t s = 0; s < b->step_count; s++) {
            assert_int_equal(a.mech->steps[s].kind, b->steps[s].kind);
            assert_int_equal(a.mech->steps[s].target, b->steps[s].target);
        }
        for (size_t t = 0; t < b->term_count; t++) {
            assert_int_equal(a.mech->terms[t].slot, b->terms[t].slot);
            assert_int_equal(a.mech->terms[t].distance, b->terms[t].distance);
            assert_memory_equal(&a.mech->terms[t].v, &b->terms[t].v, sizeof(YkVec));
        }
        yk_mechanism_free(b);
        machine_free(&a);
    }
}

static void a_refusal_leaves_the_model_as_it_was(void **state)
{
    (void)state;
    const char *both[] = {"theta4", "gamma"};
    Machine m = machine("four-bar");
    assert_null(yk_mechanism_compile(m.model, &(YkCompileOptions){both, 2}, m.problems));
    YkMechanism *mech = yk_mechanism_compile(m.model, NULL, m.problems);
    assert_non_null(mech);
    assert_ptr_equal(yk_mechanism_model(mech), m.model);
    CHECK_NEAR(yk_mechanism_size(mech), m.model->size, 0);
    yk_mechanism_free(mech);
    yk_mechanism_free(NULL);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ladder_of_four_bars_costs_the_same_per_link_however_long),
        cmocka_unit_test(a_driven_chain_costs_the_same_per_link_however_long),
        cmocka_unit_test(sums_stay_short_however_deep_the_machine),
        cmocka_unit_test(compiling_twice_gives_the_same),
        cmocka_unit_test(a_refusal_leaves_the_model_as_it_was),
    };
    return cmocka_run_group_tests_name("compile/compile", tests, NULL, NULL);
}
