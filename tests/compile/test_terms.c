// Sums of turned vectors: like terms merge, terms that cancel vanish, and a walk along the tree is the way between two
// bodies.
#include "compile/terms.h"
#include "machine.h"
#include "table.h"

// The value of the list at variables x; no nodes.
static YkVec value_of(const YkMechanism *mech, const YkTermList *list, const double *x)
{
    YkVec total = list->constant;
    for (size_t k = 0; k < list->count; k++) {
        YkTerm t = list->items[k];
        double d = t.distance == YK_NONE ? 1 : x[mech->orientation_count - 1 + (size_t)t.distance];
        total = yk_add(total, yk_scale(d, yk_mul(t.slot == 0 ? yk_vec(1, 0) : yk_unit(x[t.slot - 1]), t.v)));
    }
    return total;
}

// How many of its terms are not 0.
static size_t count_of(const YkTermList *list)
{
    size_t count = 0;
    for (size_t k = 0; k < list->count; k++) count += yk_terms_is_there(list, k);
    return count;
}

static void like_terms_merge_and_what_cancels_vanishes(void **state)
{
    (void)state;
    YkTermList list = {0};
    yk_terms_clear(&list);
    yk_terms_add_node(&list, (YkTerm){1, YK_NONE, {1, 2}}, 0, 1);
    yk_terms_add_node(&list, (YkTerm){2, YK_NONE, {3, 0}}, 0, 1);
    yk_terms_add_node(&list, (YkTerm){1, 0, {1, 2}}, 0, 1); // with a distance it is another term
    yk_terms_add_node(&list, (YkTerm){1, YK_NONE, {4, 4}}, 0, 2);
    assert_int_equal(count_of(&list), 3);
    CHECK_NEAR(list.items[0].v.x, 9, 0);
    CHECK_NEAR(list.items[0].v.y, 10, 0);
    yk_terms_add_node(&list, (YkTerm){1, YK_NONE, {9, 10}}, 0, -1);
    assert_int_equal(count_of(&list), 2);
    assert_false(yk_terms_is_there(&list, 0)); // its place is kept: the order of the others does not depend on values
    assert_true(list.items[1].slot == 2 && list.items[2].distance == 0);
    yk_terms_free(&list);
}

static void what_the_ground_holds_goes_into_the_constant(void **state)
{
    (void)state;
    YkTermList list = {0};
    yk_terms_clear(&list);
    yk_terms_add_node(&list, (YkTerm){0, YK_NONE, {1, 2}}, 0, 3);
    yk_terms_add_node(&list, (YkTerm){0, YK_NONE, {1, 1}}, 0, -1);
    yk_terms_add_node(&list, (YkTerm){0, 4, {1, 0}}, 0, 1);       // unless it slides
    yk_terms_add_node(&list, (YkTerm){5, YK_NONE, {0, 0}}, 0, 1); // nothing is nothing
    assert_int_equal(count_of(&list), 1);
    assert_int_equal(list.items[0].distance, 4);
    CHECK_NEAR(list.constant.x, 2, 0);
    CHECK_NEAR(list.constant.y, 5, 0);
    yk_terms_clear(&list);
    assert_int_equal(list.count, 0);
    CHECK_NEAR(list.constant.x, 0, 0);
    yk_terms_free(&list);
}

static void a_walk_is_the_way_between_origins(void **state)
{
    (void)state;
    uint64_t seed = 51;
    YkTermList list = {0};
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        size_t n = yk_variable_count(m.mech);
        double *x = calloc(n + 1, sizeof *x);
        Pose pose = pose_new(m.model);
        random_variables(m.mech, &seed, x);
        pose_from_variables(m.mech, x, n, 0, &pose);
        for (size_t a = 0; a < m.model->body_count; a++)
            for (size_t b = 0; b < m.model->body_count; b++) {
                yk_terms_clear(&list);
                yk_terms_walk(&list, m.mech, &m.mech->tree, (int32_t)a, (int32_t)b);
                YkVec way = value_of(m.mech, &list, x);
                Vector expected = sum(pose.origin[b], pose.origin[a], -1);
                CHECK_NEAR(way.x, creal(expected.x), 1e-13 * m.mech->size);
                CHECK_NEAR(way.y, creal(expected.y), 1e-13 * m.mech->size);
            }
        pose_free(&pose);
        free(x);
        machine_free(&m);
    }
    yk_terms_free(&list);
}

static void crossing_there_and_back_leaves_nothing(void **state)
{
    (void)state;
    YkTermList list = {0};
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        for (size_t j = 0; j < m.model->joint_count; j++) {
            const YkJoint *joint = &m.model->joints[j];
            yk_terms_clear(&list);
            yk_terms_cross(&list, m.mech, (int32_t)j, joint->body[0], 1);
            yk_terms_cross(&list, m.mech, (int32_t)j, joint->body[1], 1);
            assert_int_equal(count_of(&list), 0);
            CHECK_NEAR(list.constant.x, 0, 0);
            CHECK_NEAR(list.constant.y, 0, 0);
        }
        machine_free(&m);
    }
    yk_terms_free(&list);
}

// Origins of placed bodies may rest on nodes: the same node once with each sign cancels.
static void equal_nodes_cancel(void **state)
{
    (void)state;
    Machine m = machine(arm);
    YkTermList list = {0};
    YkSum kept = m.mech->bodies[2].origin;
    m.mech->bodies[2].origin = (YkSum){.constant = {1, 1}, .plus = 7, .minus = YK_NONE};
    yk_terms_clear(&list);
    yk_terms_add_origin(&list, m.mech, 2, 1);
    assert_int_equal(list.plus, 7);
    yk_terms_add_origin(&list, m.mech, 2, -1);
    assert_int_equal(list.plus, YK_NONE);
    assert_int_equal(list.minus, YK_NONE);
    CHECK_NEAR(list.constant.x, 0, 0);
    yk_terms_add_origin(&list, m.mech, 2, -1);
    assert_int_equal(list.minus, 7);
    m.mech->bodies[2].origin = kept;
    yk_terms_free(&list);
    machine_free(&m);
}

static void a_stored_sum_is_the_list(void **state)
{
    (void)state;
    Machine m = machine(arm);
    YkTermList list = {0};
    YkSum stored;
    yk_terms_clear(&list);
    for (int32_t s = 1; s < 4; s++) yk_terms_add_node(&list, (YkTerm){s, YK_NONE, {s, -s}}, 0, 1);
    list.constant = yk_vec(5, 6);
    size_t before = m.mech->term_count;
    assert_true(yk_terms_store(&list, m.mech, &stored));
    assert_int_equal(stored.first, before);
    assert_int_equal(stored.count, 3);
    assert_int_equal(m.mech->term_count, before + 3);
    CHECK_NEAR(stored.constant.y, 6, 0);
    for (int32_t s = 1; s < 4; s++) assert_int_equal(m.mech->terms[stored.first + (uint32_t)s - 1].slot, s);
    list.failed = true; // an incomplete list must not pass for a sum
    assert_false(yk_terms_store(&list, m.mech, &stored));
    yk_terms_free(&list);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(like_terms_merge_and_what_cancels_vanishes),
        cmocka_unit_test(what_the_ground_holds_goes_into_the_constant),
        cmocka_unit_test(a_walk_is_the_way_between_origins),
        cmocka_unit_test(crossing_there_and_back_leaves_nothing),
        cmocka_unit_test(equal_nodes_cancel),
        cmocka_unit_test(a_stored_sum_is_the_list),
    };
    return cmocka_run_group_tests_name("compile/terms", tests, NULL, NULL);
}
