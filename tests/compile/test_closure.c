// The loops' Jacobian against a complex step through positions computed joint by joint, its rank, and the freedom by
// rank.
#include "compile/closure.h"
#include "compile/inputs.h"
#include <yoke/state.h>
#include "machine.h"
#include "table.h"

static double largest(const double *v, size_t n)
{
    double most = 0;
    for (size_t k = 0; k < n; k++) most = fmax(most, fabs(v[k]));
    return most;
}

static void jacobians_equal_a_complex_step(void **state)
{
    (void)state;
    const double h = 1e-60; // no difference is taken, so the step may be as small as it likes
    uint64_t seed = 41;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        size_t n = yk_variable_count(m.mech), rows = 2 * yk_loop_count(m.mech);
        double *x = calloc(n + 1, sizeof *x), *r = calloc(rows + 1, sizeof *r), *J = calloc(rows * n + 1, sizeof *J);
        Pose pose = pose_new(m.model);
        for (int trial = 0; trial < 20; trial++) {
            random_variables(m.mech, &seed, x);
            yk_closure(m.mech, x, r, J);
            double scale = fmax(largest(J, rows * n), 1e-300);
            for (size_t v = 0; v < n; v++) {
                pose_from_variables(m.mech, x, v, h, &pose);
                for (size_t l = 0; l < rows / 2; l++) {
                    Vector gap = loop_gap(m.mech, &pose, l);
                    CHECK_NEAR(J[2 * l * n + v], cimag(gap.x) / h, 1e-13 * scale);
                    CHECK_NEAR(J[(2 * l + 1) * n + v], cimag(gap.y) / h, 1e-13 * scale);
                }
            }
        }
        pose_free(&pose);
        free(x);
        free(r);
        free(J);
        machine_free(&m);
    }
}

// Elimination with full pivoting: another way to the rank than the engine's QR.
static size_t rank_of(size_t rows, size_t n, double *A)
{
    double most = largest(A, rows * n);
    for (size_t k = 0; k < rows && k < n; k++) {
        size_t p = k, q = k;
        for (size_t i = k; i < rows; i++)
            for (size_t j = k; j < n; j++)
                if (fabs(A[i * n + j]) > fabs(A[p * n + q])) p = i, q = j;
        if (fabs(A[p * n + q]) <= 1e-8 * most) return k;
        for (size_t j = 0; j < n; j++) {
            double t = A[k * n + j];
            A[k * n + j] = A[p * n + j];
            A[p * n + j] = t;
        }
        for (size_t i = 0; i < rows; i++) {
            double t = A[i * n + k];
            A[i * n + k] = A[i * n + q];
            A[i * n + q] = t;
        }
        for (size_t i = k + 1; i < rows; i++) {
            double f = A[i * n + k] / A[k * n + k];
            for (size_t j = k; j < n; j++) A[i * n + j] -= f * A[k * n + j];
        }
    }
    return rows < n ? rows : n;
}

static void variables_of_state(const YkMechanism *mech, const YkState *s, double *x)
{
    size_t o = mech->orientation_count - 1;
    for (size_t k = 1; k <= o; k++) x[k - 1] = yk_state_body(s, (size_t)mech->orientation_body[k]).position;
    for (size_t j = 0; j < mech->model->joint_count; j++)
        if (mech->joint_distance[j] >= 0)
            x[o + (size_t)mech->joint_distance[j]] =
                yk_state_channel(s, (YkChannel){YK_CHANNEL_JOINT_DISTANCE, (int)j, 0, YK_QUANTITY_LENGTH});
}

static void assembled_machines_close_and_have_the_rank_that_freedom_says(void **state)
{
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        YkState *s = yk_state_new(m.mech);
        size_t n = yk_variable_count(m.mech), rows = 2 * yk_loop_count(m.mech), o = m.mech->orientation_count - 1;
        double *x = calloc(n + 1, sizeof *x), *r = calloc(rows + 1, sizeof *r), *J = calloc(rows * n + 1, sizeof *J);
        assert_int_equal(yk_state_set_time(s, 0, NULL), YK_OK);
        YkStatus status = yk_state_assemble(s);
        if (status < 0) print_error("%s\n%s\n", machines[k].source, yk_state_report(s)->message);
        assert_true(status >= 0);
        variables_of_state(m.mech, s, x);
        yk_closure(m.mech, x, r, J);
        CHECK_NEAR(largest(r, rows), 0, 1e-12 * m.mech->size);
        for (size_t i = 0; i < rows; i++)
            for (size_t j = 0; j < o; j++) J[i * n + j] /= m.mech->size;
        if (n - rank_of(rows, n, J) != (size_t)machines[k].by_rank) print_error("%s\n", machines[k].source);
        assert_int_equal(n - rank_of(rows, n, J), machines[k].by_rank);
        yk_state_free(s);
        free(x);
        free(r);
        free(J);
        machine_free(&m);
    }
}

static int freedom_from(const YkMechanism *mech, const double *guess, bool *accepted)
{
    int32_t candidates[64];
    size_t count = yk_coordinate_count(mech);
    for (size_t k = 0; k < count; k++) candidates[k] = (int32_t)k;
    memset(accepted, 0, 64 * sizeof *accepted);
    int freedom;
    assert_true(
        yk_closure_freedom(mech, guess, &(YkCandidates){candidates, count, 0, accepted, false}, &freedom, NULL));
    return freedom;
}

// The dense way alone, from the guesses of the file, finds for every machine what the plan's way found.
static void freedom_by_rank_agrees_for_all_known_machines(void **state)
{
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        double guess[64];
        bool accepted[64];
        yk_start_guess(m.mech, guess);
        int freedom = freedom_from(m.mech, guess, accepted), taken = 0;
        if (freedom != machines[k].by_rank) print_error("%s\n", machines[k].source);
        assert_int_equal(freedom, machines[k].by_rank);
        for (size_t c = 0; c < yk_coordinate_count(m.mech); c++) taken += accepted[c];
        if (yk_loop_count(m.mech) > 0) assert_int_equal(taken, freedom); // open chains keep the caller's choice
        machine_free(&m);
    }
}

// A coupling rod on three cranks has one freedom wherever the pins are, from any guess, also where it could be put
// together in other ways that do not move.
static void three_cranks_move_whatever_their_dimensions(void **state)
{
    (void)state;
    uint64_t seed = 42;
    for (int trial = 0; trial < 150; trial++) {
        char text[2000];
        double p = check_uniform(&seed, 0.5, 3), q = check_uniform(&seed, -3, 3), r = check_uniform(&seed, -1, 1),
               l = check_uniform(&seed, 0.2, 2);
        double turn = check_uniform(&seed, -180, 180);
        snprintf(text, sizeof text,
                 "parameters: {p: %.17g, q: %.17g, r: %.17g, l: %.17g, turn: %.17g deg}\n"
                 "bodies:\n"
                 "  ground: {points: {O1: [0, 0], O2: [p, 0], O3: [q, r]}}\n" LINK("c1", "O1", "A1",
                                                                                   "l") LINK("c2", "O2", "A2", "l")
                     LINK("c3", "O3", "A3",
                          "l") "  rod: {points: {A1: [0, 0], A2: [p, 0], A3: [q, r]}}\n"
                               "joints:\n"
                               "  O1: {pin: [ground, c1], angle: t1}\n  O2: {pin: [ground, c2], angle: t2}\n  O3: "
                               "{pin: [ground, c3], angle: t3}\n"
                               "  A1: {pin: [c1, rod], angle: phi}\n  A2: {pin: [rod, c2]}\n  A3: {pin: [rod, c3]}\n"
                               "start: {t1: turn, t2: turn + 5 deg, t3: turn - 4 deg, phi: 3 deg - turn}\n",
                 p, q, r, l, turn);
        Machine m = machine(text);
        YkFreedom f = yk_mechanism_freedom(m.mech);
        if (f.by_rank != 1) print_error("trial %d of seed 42: freedom %d\n%s", trial, f.by_rank, text);
        assert_int_equal(f.gruebler, 0);
        assert_int_equal(f.by_rank, 1);
        assert_int_equal(f.redundant, 1);
        machine_free(&m);
    }
}

// The unit in which lengths come must not decide what the rank is.
static void freedom_does_not_depend_on_the_size_of_the_machine(void **state)
{
    (void)state;
    static const char *const sizes[] = {"1e-6", "1e-3", "1", "1e3", "1e6"};
    for (size_t k = 0; k < 5; k++) {
        YkOverride scale = {"k", sizes[k]};
        YkLoadOptions load = {&scale, 1};
        Machine m = machine_try_with(
            "parameters: {k: 1}\n"
            "bodies:\n"
            "  ground: {points: {up: [0, 0.2*k], down: [0, -0.3*k]}}\n"
            "  crank: {points: {A: [k, 0]}}\n  rod: {points: {A: [0, 0], B: [3*k, 0]}}\n"
            "  head: {points: {B: [0, 0], up: [0, 0.2*k], down: [0, -0.3*k]}}\n"
            "joints:\n"
            "  K: {pin: [ground, crank], angle: th}\n  A: {pin: [crank, rod], angle: u}\n  B: {pin: [rod, head]}\n"
            "  S: {slide: [ground, head], along: x, from: up, to: up, distance: x}\n"
            "  T: {slide: [ground, head], along: x, from: down, to: down}\n"
            "start: {th: 1, u: -1.3, x: 3*k}\n",
            &load, NULL);
        assert_non_null(m.mech);
        YkFreedom f = yk_mechanism_freedom(m.mech);
        assert_int_equal(f.by_rank, 1);
        assert_int_equal(f.gruebler, -1);
        double guess[64] = {0.5, 0.2, 0.1 * m.mech->size}; // a guess far from closing: the iteration has to work
        bool accepted[64];
        assert_int_equal(freedom_from(m.mech, guess, accepted), 1);
        machine_free(&m);
    }
}

static void what_cannot_close_has_no_freedom_by_rank(void **state)
{
    (void)state;
    Machine m = machine("bodies:\n  ground: {points: {A: [0, 0], B: [9, 0]}}\n" LINK("a", "A", "C", "1") LINK(
        "b", "B", "C",
        "1") "joints: {A: {pin: [ground, a], angle: p}, B: {pin: [ground, b], angle: q}, C: {pin: [a, b]}}\n");
    double guess[64] = {0};
    bool accepted[64];
    assert_int_equal(freedom_from(m.mech, guess, accepted), -1);
    machine_free(&m);
}

// Parts that share only the ground are measured apart: each must find its own freedom, and a large number costs no more
// each.
static void parts_of_a_machine_are_measured_one_by_one(void **state)
{
    (void)state;
    enum { PARTS = 120 }; // 480 variables in all
    char *text = malloc(PARTS * 1000);
    size_t n = 0, room = PARTS * 1000;
    assert_non_null(text);
    n += (size_t)snprintf(text + n, room - n, "bodies:\n  ground: {points: {");
    for (int k = 0; k < PARTS; k++)
        n += (size_t)snprintf(text + n, room - n, "%sO%d: [0, %d], P%d: [1.5, %d], Q%d: [2.9, %d.3]", k ? ", " : "", k,
                              k, k, k, k, k);
    n += (size_t)snprintf(text + n, room - n, "}}\n");
    for (int k = 0; k < PARTS; k++)
        n += (size_t)snprintf(
            text + n, room - n,
            "  a%d: {points: {O%d: [0, 0], A%d: [0.5, 0]}}\n  b%d: {points: {P%d: [0, 0], B%d: [0.5, 0]}}\n"
            "  c%d: {points: {Q%d: [0, 0], C%d: [0.5, 0]}}\n"
            "  r%d: {points: {A%d: [0, 0], B%d: [1.5, 0], C%d: [2.9, 0.3]}}\n",
            k, k, k, k, k, k, k, k, k, k, k, k, k);
    n += (size_t)snprintf(text + n, room - n, "joints:\n");
    for (int k = 0; k < PARTS; k++)
        n += (size_t)snprintf(text + n, room - n,
                              "  O%d: {pin: [ground, a%d], angle: a%d}\n  P%d: {pin: [ground, b%d], angle: b%d}\n"
                              "  Q%d: {pin: [ground, c%d], angle: c%d}\n  A%d: {pin: [a%d, r%d], angle: r%d}\n"
                              "  B%d: {pin: [r%d, b%d]}\n  C%d: {pin: [r%d, c%d]}\n",
                              k, k, k, k, k, k, k, k, k, k, k, k, k, k, k, k, k, k, k);
    n += (size_t)snprintf(text + n, room - n, "start: {");
    for (int k = 0; k < PARTS; k++)
        n += (size_t)snprintf(text + n, room - n, "%sa%d: 1, b%d: 1, c%d: 1, r%d: -1", k ? ", " : "", k, k, k, k);
    snprintf(text + n, room - n, "}\n");
    Machine m = machine(text);
    YkFreedom f = yk_mechanism_freedom(m.mech);
    assert_int_equal(f.gruebler, 0);
    assert_int_equal(f.by_rank, PARTS);
    assert_int_equal(yk_redundant_count(m.mech), PARTS);
    machine_free(&m);
    free(text);
}

// From guesses far away three cranks often close in a way that is rigid; the motion that they have is looked for
// further on.
static void rigid_ways_to_close_do_not_hide_the_motion(void **state)
{
    (void)state;
    uint64_t seed = 43;
    size_t moving = 0, trials = 200;
    Machine m = machine("three-crank-parallelogram");
    for (size_t trial = 0; trial < trials; trial++) {
        double guess[8];
        bool accepted[64];
        for (size_t k = 0; k < 4; k++) guess[k] = check_uniform(&seed, -3, 3);
        moving += freedom_from(m.mech, guess, accepted) == 1;
    }
    print_message("%zu of %zu guesses\n", moving, trials);
    assert_true(10 * moving >= 9 * trials);
    machine_free(&m);
}

// A rod that does not turn is not an input, though counting would take it; of inputs that move the same, one is taken.
static void only_what_moves_independently_is_accepted(void **state)
{
    (void)state;
    Machine m = machine("three-crank-parallelogram"); // theta1, phi, theta2, theta3
    double guess[8];
    yk_start_guess(m.mech, guess);
    static const int32_t orders[][4] = {{0, 1, 2, 3}, {3, 2, 1, 0}, {1, 0, 2, 3}};
    for (size_t k = 0; k < 3; k++) {
        bool accepted[4] = {false};
        int freedom;
        assert_true(
            yk_closure_freedom(m.mech, guess, &(YkCandidates){orders[k], 4, 0, accepted, false}, &freedom, NULL));
        assert_int_equal(freedom, 1);
        for (size_t c = 0; c < 4; c++) assert_int_equal(accepted[c], c == 0);
    }
    machine_free(&m);
}

static void guesses_become_variables_along_the_tree_in_any_order_of_joints(void **state)
{
    (void)state;
    Machine m = machine("bodies: {a: {}, b: {}, c: {}, d: {}}\n"
                        "joints:\n"
                        "  J4: {pin: [d, c], angle: w}\n" // turned round: c relative to d
                        "  J3: {slide: [b, c], along: x, turned: 0.25, distance: s}\n"
                        "  J2: {pin: [a, b], angle: v}\n"
                        "  J1: {pin: [ground, a], angle: u}\n");
    double coordinates[] = {0.1, 7, 0.02, 0.003}, x[8];
    yk_closure_guess(m.mech, coordinates, x);
    for (size_t o = 1; o < m.mech->orientation_count; o++) {
        const char *body = yk_model_body_name(m.model, (size_t)m.mech->orientation_body[o]);
        double expected = 0.003;                         // a
        if (*body == 'b') expected = 0.023;              // b = a + v; c stands 0.25 from it
        if (*body == 'd') expected = 0.023 + 0.25 - 0.1; // c = d + w
        CHECK_NEAR(x[o - 1], expected, 1e-15);
    }
    CHECK_NEAR(x[m.mech->orientation_count - 1], 7, 0);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(jacobians_equal_a_complex_step),
        cmocka_unit_test(assembled_machines_close_and_have_the_rank_that_freedom_says),
        cmocka_unit_test(freedom_by_rank_agrees_for_all_known_machines),
        cmocka_unit_test(three_cranks_move_whatever_their_dimensions),
        cmocka_unit_test(freedom_does_not_depend_on_the_size_of_the_machine),
        cmocka_unit_test(what_cannot_close_has_no_freedom_by_rank),
        cmocka_unit_test(parts_of_a_machine_are_measured_one_by_one),
        cmocka_unit_test(rigid_ways_to_close_do_not_hide_the_motion),
        cmocka_unit_test(only_what_moves_independently_is_accepted),
        cmocka_unit_test(guesses_become_variables_along_the_tree_in_any_order_of_joints),
    };
    return cmocka_run_group_tests_name("compile/closure", tests, NULL, NULL);
}
