// Memory: solving again allocates nothing, and every allocation may fail. The sources are compiled in with our own
// allocator.
#include "allocations.h"
#include "loads_check.h"

#define malloc try_malloc
#define calloc try_calloc
#define realloc try_realloc
#define free count_free
#define allocate sparse_allocate
#include "../../src/num/sparse.c"
#undef allocate
#define allocate order_allocate
#define eliminate order_eliminate
#include "../../src/num/sparse_order.c"
#undef allocate
#undef eliminate
#define find_parents tree_find_parents
#include "../../src/num/sparse_factor.c"
#include "../../src/num/sparse_postorder.c"
#define solve sparse_solve
#include "../../src/num/sparse_solve.c"
#undef solve
#include "../../src/free_bodies/parts.c"
#include "../../src/free_bodies/system.c"
#include "../../src/free_bodies/wrenches.c"
#define make_system balance_make_system
#define ROUNDS_MAX BALANCE_ROUNDS_MAX
#include "../../src/free_bodies/balance.c"
#undef make_system
#undef ROUNDS_MAX
#include "../../src/free_bodies/free_bodies.c"
#include "../../src/free_bodies/motion.c"
#undef malloc
#undef calloc
#undef realloc
#undef free

static Rig weigh(Machine m)
{
    for (size_t b = 1; b < m.model->body_count; b++) {
        YkBody *body = &m.model->bodies[b];
        body->has_mass = true;
        body->mass = 1 + (double)b;
        body->inertia = 0.1 * body->mass * m.mech->size * m.mech->size;
    }
    Rig r = rig_of(m);
    load_gravity(&r, yk_vec(0, -9.81));
    return r;
}

static Rig heavy(const char *file)
{
    return weigh(machine_load(file));
}

static void check_solving_again(const char *file)
{
    Rig r = heavy(file);
    YkMotion q = yk_state_input(r.m.state, 0);
    long before = 0;
    for (int k = 0; k < 20; k++) {
        rig_move(&r, 0, q.position, 0.1 * k, 0.3);
        if (k == 2) before = requests;
        r.is_prescribed[0] = false;
        assert_true(rig_forward(&r, NULL) >= 0);
        assert_true(rig_inverse(&r) >= 0);
        assert_true(isfinite(r.accelerations[0]) && imbalance_of(r.bodies) < 1e-12);
    }
    assert_int_equal(requests, before);
    rig_free(&r);
}

static void test_solving_again_allocates_nothing(void **unused)
{
    (void)unused;
    check_solving_again("toggle");
    check_solving_again("jansen");
    check_solving_again("quick-return");
    check_solving_again("doubled-guide");
    assert_int_equal(live, 0);
}

static void test_other_prescribed_inputs_rebuild_and_agree(void **unused)
{
    (void)unused;
    Rig r = heavy("five-bar");
    double first[2];
    r.is_prescribed[1] = true;
    r.accelerations[1] = 2;
    assert_int_equal(rig_forward(&r, NULL), YK_OK);
    first[0] = r.accelerations[0];
    first[1] = yk_free_bodies_effort(r.bodies, 1);
    r.is_prescribed[1] = false; // its effort as a load: the same motion
    load_input(&r, 1, first[1]);
    assert_int_equal(rig_forward(&r, NULL), YK_OK);
    CHECK_NEAR(r.accelerations[0], first[0], 1e-11 * fabs(first[0]));
    CHECK_NEAR(r.accelerations[1], 2, 1e-11 * fabs(first[0]));
    rig_free(&r);
    assert_int_equal(live, 0);
}

// 1: an allocation failed and was reported.
static int try_rig(Rig *r)
{
    r->bodies = yk_free_bodies_new(r->m.mech);
    if (!r->bodies) return 1;
    int failed = (rig_inverse(r) == YK_NO_MEMORY) + (rig_forward(r, NULL) == YK_NO_MEMORY);
    if (failed) { // and can be tried again
        countdown = -1;
        assert_true(rig_inverse(r) >= 0 && rig_forward(r, NULL) >= 0);
        assert_true(imbalance_of(r->bodies) < 1e-12);
    }
    yk_free_bodies_free(r->bodies);
    r->bodies = NULL;
    return failed;
}

static void check_failing_allocations(Rig r)
{
    yk_free_bodies_free(r.bodies);
    int failures = 0;
    for (long k = 0; k < 300; k++) {
        countdown = k;
        int failed = try_rig(&r);
        bool reached = countdown < 0;
        countdown = -1;
        assert_int_equal(live, 0);
        assert_int_equal(reached, failed > 0); // none goes unnoticed
        if (!reached) {
            assert_true(failures > 10);
            rig_free(&r);
            return;
        }
        failures += failed;
    }
    fail();
}

static void test_every_allocation_may_fail(void **unused)
{
    (void)unused;
    check_failing_allocations(heavy("toggle"));
    check_failing_allocations(heavy("doubled-guide"));
    check_failing_allocations(weigh(machine_parse( // the second part is well where the first has run out
        "bodies: {ground: {points: {O: [0, 0], Q: [1, 0]}}, a: {points: {O: [0, 0]}}, b: {points: {Q: [0, 0]}}}\n"
        "joints: {O: {pin: [ground, a], angle: p}, Q: {pin: [ground, b], angle: q}}\n",
        true)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_solving_again_allocates_nothing),
        cmocka_unit_test(test_other_prescribed_inputs_rebuild_and_agree),
        cmocka_unit_test(test_every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
