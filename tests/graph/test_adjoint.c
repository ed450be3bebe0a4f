// Derivatives by all leaves at once: against those by one leaf, and through solved equations against differences.
#include "graph/graph_check.h"
#include "graph/tape.h"

enum { LEAVES = 15 };

// The only law of these graphs: x^3 - x.
static void cubic(const void *context, int32_t law, double x, double result[3])
{
    (void)context, (void)law;
    result[0] = x * x * x - x;
    result[1] = 3 * x * x - 1;
    result[2] = 6 * x;
}

// Computes the roots at the leaves' values.
static void compute(YkGraph *g, const YkRef *leaves, size_t count, const double *at, const YkRef *roots,
                    size_t root_count, double *value)
{
    YkTape *tape = yk_tape_new(g, leaves, count, roots, root_count, 1, (YkTapeLaws){NULL, cubic});
    double *out[2 * LEAVES];
    assert_non_null(tape);
    for (size_t k = 0; k < count; k++) yk_tape_set(tape, k, at[k]);
    yk_tape_prepare(tape);
    for (size_t k = 0; k < root_count; k++) out[k] = &value[k];
    yk_tape_run(tape, out, 1);
    yk_tape_free(tape);
}

static void start(YkGraph *g, YkArena **arena, YkRef *leaves, size_t count)
{
    *arena = yk_arena_new();
    assert_true(*arena && yk_graph_start(g, *arena));
    for (size_t k = 0; k < count; k++)
        leaves[k] = yk_graph_leaf(g, k == 2 ? YK_LEAF_PARAMETER : YK_LEAF_POSE, yk_graph_text(g, "x%d", (int)k));
}

static void backwards_and_forwards_agree(void **state)
{
    (void)state;
    enum { OWN = 4, STEPS = 60 };
    uint64_t seed = 20;
    for (int round = 0; round < 20; round++) {
        YkGraph g = {0};
        YkArena *arena;
        YkRef leaves[OWN], value[OWN + STEPS], roots[2 * OWN];
        double at[OWN], found[2 * OWN];
        start(&g, &arena, leaves, OWN);
        for (int k = 0; k < OWN; k++) {
            value[k] = leaves[k];
            at[k] = check_uniform(&seed, 0.3, 0.9);
        }
        for (int k = OWN; k < OWN + STEPS; k++) {
            YkRef a = value[(int)check_uniform(&seed, 0, k)], b = value[(int)check_uniform(&seed, 0, k)];
            YkRef half = yk_graph_number(&g, 0.5), square = yk_graph_add(&g, yk_graph_multiply(&g, a, a), half);
            YkRef small = yk_graph_divide(&g, a, yk_graph_add(&g, square, yk_graph_multiply(&g, b, b)));
            const YkRef ways[] = {yk_graph_add(&g, a, b),
                                  yk_graph_subtract(&g, yk_graph_multiply(&g, half, a), b),
                                  small,
                                  yk_graph_multiply(&g, small, b),
                                  yk_graph_minus(&g, a),
                                  yk_graph_unary(&g, YK_VALUE_ROOT, square),
                                  yk_graph_unary(&g, YK_VALUE_PER_ROOT, square),
                                  yk_graph_unary(&g, YK_VALUE_SIZE, a),
                                  yk_graph_choose(&g, a, b, small),
                                  yk_graph_unit(&g, small).x,
                                  yk_graph_function(&g, YK_ATAN2, a, square),
                                  yk_graph_function(&g, YK_SIN, small, -1)};
            value[k] = ways[(int)check_uniform(&seed, 0, sizeof ways / sizeof *ways)];
        }
        YkRef sum = value[OWN + STEPS - 1];
        for (int k = 1; k < 12; k++)
            sum = yk_graph_add(&g, sum, yk_graph_function(&g, YK_ATAN, value[OWN + STEPS - 1 - k], -1));
        assert_true(yk_graph_adjoint(&g, sum, leaves, OWN, roots));
        for (int k = 0; k < OWN; k++) roots[OWN + k] = yk_graph_derivative(&g, sum, leaves[k]);
        compute(&g, leaves, OWN, at, roots, 2 * OWN, found);
        for (int k = 0; k < OWN; k++) CHECK_NEAR(found[k], found[OWN + k], 1e-12 * (1 + fabs(found[k])));
        yk_graph_end(&g);
        yk_arena_free(arena);
    }
}

// A X = B of three unknowns and two right sides, all of them leaves; the answer is a weighted sum of squares of X.
static void solved_equations_hand_their_shares_on(void **state)
{
    (void)state;
    enum { N = 3, M = 2, STRIDE = N + M };
    uint64_t seed = 5;
    YkGraph g = {0};
    YkArena *arena;
    YkRef leaves[LEAVES], by[LEAVES];
    double at[LEAVES], found[LEAVES];
    start(&g, &arena, leaves, LEAVES);
    for (int k = 0; k < LEAVES; k++)
        at[k] = check_uniform(&seed, -1, 1) + (k % STRIDE == k / STRIDE ? 2 : 0); // a diagonal to divide by
    int32_t call = yk_graph_call(&g, (YkCall){.kind = YK_CALL_SOLVE,
                                              .n = N,
                                              .m = M,
                                              .arguments = leaves,
                                              .argument_count = LEAVES,
                                              .result_count = LEAVES + 1,
                                              .name = "x"});
    YkRef sum = yk_graph_number(&g, 0);
    for (int i = 0; i < N; i++)
        for (int side = 0; side < M; side++) {
            YkRef x = yk_graph_result(&g, call, (size_t)(i * STRIDE + N + side));
            YkRef weight = yk_graph_number(&g, 1 + i - 0.3 * side);
            sum = yk_graph_add(&g, sum, yk_graph_multiply(&g, weight, yk_graph_multiply(&g, x, x)));
        }
    assert_true(yk_graph_adjoint(&g, sum, leaves, LEAVES, by));
    compute(&g, leaves, LEAVES, at, by, LEAVES, found);
    for (int k = 0; k < LEAVES; k++) {
        const double h = 1e-4;
        double value[4], own = at[k];
        static const double way[4] = {-1, 1, -2, 2};
        for (int i = 0; i < 4; i++) {
            at[k] = own + way[i] * h;
            compute(&g, leaves, LEAVES, at, &sum, 1, &value[i]);
        }
        at[k] = own;
        CHECK_NEAR(found[k], (8 * (value[1] - value[0]) - (value[3] - value[2])) / (12 * h),
                   1e-9 * (1 + fabs(found[k])));
    }
    yk_graph_end(&g);
    yk_arena_free(arena);
}

// A law is differentiated into its next derivative, up to the second. The sum is x (y^3 - y) + (3 (x + y)^2 - 1) y in
// closed form.
static void laws_hand_their_slopes_on(void **state)
{
    (void)state;
    YkGraph g = {0};
    YkArena *arena;
    YkRef leaves[2], roots[6];
    uint64_t seed = 8;
    start(&g, &arena, leaves, 2);
    YkRef x = leaves[0], y = leaves[1], inner[2] = {y, yk_graph_add(&g, x, y)}, result[2][3];
    for (int k = 0; k < 2; k++) {
        YkCall call = {
            .kind = YK_CALL_LAW, .arguments = &inner[k], .argument_count = 1, .result_count = 3, .name = "f"};
        int32_t index = yk_graph_call(&g, call);
        for (size_t i = 0; i < 3; i++) result[k][i] = yk_graph_result(&g, index, i);
    }
    YkRef sum = yk_graph_add(&g, yk_graph_multiply(&g, x, result[0][0]), yk_graph_multiply(&g, result[1][1], y));
    assert_true(yk_graph_adjoint(&g, sum, leaves, 2, roots));
    for (int k = 0; k < 2; k++) roots[2 + k] = yk_graph_derivative(&g, sum, leaves[k]);
    roots[4] = sum;
    for (int k = 0; k < 20; k++) {
        double at[2] = {check_uniform(&seed, -2, 2), check_uniform(&seed, -2, 2)}, found[5];
        double a = at[0], b = at[1], c = a + b;
        compute(&g, leaves, 2, at, roots, 5, found);
        CHECK_NEAR(found[4], a * (b * b * b - b) + (3 * c * c - 1) * b, 1e-13);
        for (int way = 0; way < 4; way += 2) {
            CHECK_NEAR(found[way], b * b * b - b + 6 * c * b, 1e-13);
            CHECK_NEAR(found[way + 1], a * (3 * b * b - 1) + 6 * c * b + 3 * c * c - 1, 1e-13);
        }
    }
    assert_false(yk_graph_adjoint(&g, result[0][2], leaves, 2, roots)); // a law has no third derivative
    yk_graph_end(&g);
    yk_arena_free(arena);
}

static void what_has_no_derivative_is_refused(void **state)
{
    (void)state;
    YkGraph g = {0};
    YkArena *arena;
    YkRef leaves[2], by[2];
    start(&g, &arena, leaves, 2);
    assert_false(yk_graph_adjoint(&g, yk_graph_binary(&g, YK_VALUE_LEAST, leaves[0], leaves[1]), leaves, 2, by));
    assert_true(yk_graph_adjoint(&g, leaves[0], leaves, 2, by));
    assert_true(yk_graph_is_number(&g, by[0], 1) && yk_graph_is_number(&g, by[1], 0));
    yk_graph_end(&g);
    yk_arena_free(arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(backwards_and_forwards_agree),
        cmocka_unit_test(solved_equations_hand_their_shares_on),
        cmocka_unit_test(laws_hand_their_slopes_on),
        cmocka_unit_test(what_has_no_derivative_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
