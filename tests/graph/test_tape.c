// Tapes: random graphs against the values of the graph one by one, calls against their definition; the same bits for
// any number of lanes.
#include "elementary/kernel.h"
#include "graph_check.h"
#include "graph/tape.h"

enum { LEAVES = 6, PARAMETERS = 3, VALUES = 120, ROOTS = 7, LANES = 24 };

typedef struct Case {
    YkArena *arena;
    YkGraph graph;
    YkRef leaves[LEAVES + PARAMETERS], roots[ROOTS];
    double leaf[LEAVES + PARAMETERS][LANES];
    double out[ROOTS][LANES];
} Case;

static void start(Case *c, uint64_t *seed)
{
    c->arena = yk_arena_new();
    assert_true(yk_graph_start(&c->graph, c->arena));
    for (int k = 0; k < LEAVES + PARAMETERS; k++) {
        bool is_parameter = k >= LEAVES;
        const char *name = yk_graph_text(&c->graph, "%s%d", is_parameter ? "p" : "x", k);
        c->leaves[k] = yk_graph_leaf(&c->graph, is_parameter ? YK_LEAF_PARAMETER : YK_LEAF_POSE, name);
        for (int i = 0; i < LANES; i++)
            c->leaf[k][i] = is_parameter && i > 0 ? c->leaf[k][0] : check_uniform(seed, -2, 2);
    }
}

static void end(Case *c)
{
    yk_graph_end(&c->graph);
    yk_arena_free(c->arena);
}

static YkRef combine(YkGraph *g, int kind, YkRef a, YkRef b, YkRef c)
{
    switch (kind) {
    case 0:
    case 1:
        return yk_graph_add(g, a, yk_graph_multiply(g, b, c));
    case 2:
        return yk_graph_subtract(g, yk_graph_multiply(g, a, b), c);
    case 3:
        return yk_graph_subtract(g, c, yk_graph_multiply(g, a, b));
    case 4:
        return yk_graph_dot(g, (YkRefVec){a, b}, (YkRefVec){c, a});
    case 5:
        return yk_graph_cross(g, (YkRefVec){a, b}, (YkRefVec){c, b});
    case 6:
        return yk_graph_divide(g, a, yk_graph_add(g, yk_graph_unary(g, YK_VALUE_SIZE, b), yk_graph_number(g, 1)));
    case 7:
        return yk_graph_function(g, YK_SQRT, yk_graph_unary(g, YK_VALUE_SIZE, a), -1);
    case 8:
        return yk_graph_choose(g, a, b, c);
    case 9:
        return yk_graph_minus(g, a);
    case 10: { // both components of a turning vector's acceleration
        YkRef square = yk_graph_multiply(g, c, c);
        YkRef along = yk_graph_dot(g, (YkRefVec){a, b}, (YkRefVec){square, c});
        YkRef across = yk_graph_subtract(g, yk_graph_multiply(g, a, c), yk_graph_multiply(g, b, square));
        return yk_graph_choose(g, a, along, across);
    }
    default:
        return yk_graph_multiply(g, a, yk_graph_number(g, 0.25));
    }
}

static void grow(Case *c, uint64_t *seed)
{
    YkRef values[LEAVES + PARAMETERS + VALUES];
    size_t count = LEAVES + PARAMETERS;
    memcpy(values, c->leaves, sizeof c->leaves);
    for (; count < LEAVES + PARAMETERS + VALUES; count++) {
        YkRef a = values[check_random(seed) % count], b = values[check_random(seed) % count],
              third = values[check_random(seed) % count];
        values[count] = combine(&c->graph, (int)(check_random(seed) % 12), a, b, third);
    }
    for (int k = 0; k < ROOTS; k++) c->roots[k] = values[count - 1 - check_random(seed) % (VALUES / 2)];
    c->roots[ROOTS - 1] = c->roots[0];
    c->roots[ROOTS - 2] = c->leaves[check_random(seed) % (LEAVES + PARAMETERS)];
}

static YkTape *tape_of(Case *c, YkTapeLaws laws)
{
    YkTape *t = yk_tape_new(&c->graph, c->leaves, LEAVES + PARAMETERS, c->roots, ROOTS, LANES, laws);
    assert_non_null(t);
    for (size_t k = LEAVES; k < LEAVES + PARAMETERS; k++) yk_tape_set(t, k, c->leaf[k][0]);
    yk_tape_prepare(t);
    return t;
}

static void run(Case *c, YkTape *t, size_t from, size_t n)
{
    double *out[ROOTS];
    for (size_t k = 0; k < LEAVES; k++) yk_tape_set_lanes(t, k, c->leaf[k] + from);
    for (size_t k = 0; k < ROOTS; k++) out[k] = c->out[k] + from;
    yk_tape_run(t, out, n);
}

static void test_random_graphs(void **unused)
{
    (void)unused;
    static Case c;
    uint64_t seed = 11;
    for (int round = 0; round < 300; round++) {
        start(&c, &seed);
        grow(&c, &seed);
        YkTape *t = tape_of(&c, (YkTapeLaws){0}); // adds numbers to the graph
        double *numbers = calloc(c.graph.count, sizeof *numbers), alone[ROOTS];
        run(&c, t, 0, LANES);
        for (size_t i = 0; i < LANES; i++) {
            for (int k = 0; k < LEAVES + PARAMETERS; k++) numbers[c.leaves[k]] = c.leaf[k][i];
            graph_evaluate(&c.graph, numbers);
            for (int k = 0; k < ROOTS; k++) {
                alone[k] = c.out[k][i];
                assert_memory_equal(&alone[k], &numbers[c.roots[k]], sizeof(double));
            }
            run(&c, t, i, 1);
            for (int k = 0; k < ROOTS; k++) assert_memory_equal(&alone[k], &c.out[k][i], sizeof(double));
        }
        yk_tape_free(t);
        free(numbers);
        end(&c);
    }
}

// Sums with v in each of their places: as a term, as a factor of the first or of the second product.
static YkRef reader_of(YkGraph *g, YkRef v, const YkRef *x, YkRef number, int kind)
{
    YkRef xy = yk_graph_multiply(g, x[0], x[1]), nx = yk_graph_multiply(g, number, x[2]);
    YkRef vx = yk_graph_multiply(g, v, x[3]), term = kind / 12 % 2 ? v : vx;
    YkRef other = kind / 24 % 2 ? nx : xy;
    switch (kind % 12) {
    case 0:
        return yk_graph_add(g, term, other);
    case 1:
        return yk_graph_subtract(g, term, other);
    case 2:
        return yk_graph_subtract(g, other, term);
    case 3:
        return yk_graph_add(g, x[3], yk_graph_add(g, term, other));
    case 4:
        return yk_graph_subtract(g, x[3], yk_graph_subtract(g, term, other));
    case 5:
        return yk_graph_subtract(g, yk_graph_subtract(g, other, term), x[3]);
    case 6:
        return yk_graph_add(g, yk_graph_add(g, x[3], other), term);
    case 7:
        return yk_graph_subtract(g, yk_graph_subtract(g, x[3], other), term);
    case 8:
        return yk_graph_unary(g, YK_VALUE_SIZE, v);
    case 9:
        return yk_graph_multiply(g, number, v);
    case 10:
        return yk_graph_divide(g, number, v);
    default:
        return yk_graph_multiply(g, v, v);
    }
}

static size_t length_of(Case *c)
{
    YkTape *t = tape_of(c, (YkTapeLaws){0});
    size_t length = yk_tape_length(t);
    yk_tape_free(t);
    return length;
}

// Where -v is asked for and v is read, the negative is computed alone as far as signs allow it, with the same values.
static void test_signs_cost_no_step(void **unused)
{
    (void)unused;
    static Case c;
    uint64_t seed = 8;
    size_t kept = 0;
    for (int kind = 0; kind < 40 * 48; kind++) {
        start(&c, &seed);
        YkGraph *g = &c.graph;
        YkRef number = yk_graph_number(g, 0.7);
        YkRef v = reader_of(g, c.leaves[4], c.leaves, number, kind / 48),
              u = reader_of(g, v, c.leaves + 2, number, kind);
        for (int k = 0; k < ROOTS; k++) c.roots[k] = k == 0 ? v : k == 1 ? u : c.leaves[0];
        size_t plain = length_of(&c);
        c.roots[0] = yk_graph_minus(g, v);
        YkTape *t = tape_of(&c, (YkTapeLaws){0});
        kept += yk_tape_length(t) > plain;
        run(&c, t, 0, LANES);
        double *numbers = calloc(g->count, sizeof *numbers);
        for (size_t i = 0; i < LANES; i++) {
            for (int k = 0; k < LEAVES + PARAMETERS; k++) numbers[c.leaves[k]] = c.leaf[k][i];
            graph_evaluate(g, numbers);
            for (int k = 0; k < 2; k++) assert_true(c.out[k][i] == numbers[c.roots[k]]);
        }
        free(numbers);
        yk_tape_free(t);
        end(&c);
    }
    assert_true(!YK_KNOWS_BLOCKS ||
                kept <= 1507); // sums of products without numbers, of one sign each, have no negative
}

static bool are_finite(const Case *c, const YkTape *t, size_t lane, bool only_telling)
{
    for (size_t k = 0; k < ROOTS; k++)
        if ((!only_telling || yk_tape_tells(t, k)) && !isfinite(c->out[k][lane])) return false;
    return true;
}

// Whatever leaf or parameter is not finite, the roots that tell are all finite where all roots are.
static void test_roots_that_tell(void **unused)
{
    (void)unused;
    static Case c;
    uint64_t seed = 41;
    size_t telling = 0, bad = 0;
    const double odd[] = {INFINITY, -INFINITY, NAN, 1e200, 0};
    for (int round = 0; round < 300; round++) {
        start(&c, &seed);
        grow(&c, &seed);
        if (round % 4 == 0) c.leaf[LEAVES + round / 4 % PARAMETERS][0] = odd[round / 12 % 5];
        for (size_t i = 0; i < LANES; i++) c.leaf[check_random(&seed) % LEAVES][i] = odd[i % 5];
        YkTape *t = tape_of(&c, (YkTapeLaws){0});
        run(&c, t, 0, LANES);
        for (size_t k = 0; k < ROOTS; k++) telling += yk_tape_tells(t, k);
        for (size_t i = 0; i < LANES; i++) {
            bool finite = are_finite(&c, t, i, false);
            assert_int_equal(are_finite(&c, t, i, true), finite);
            bad += !finite;
        }
        yk_tape_free(t);
        end(&c);
    }
    assert_true(telling > 300 && telling < 300 * (ROOTS - 1)); // the last root repeats the first
    assert_true(bad > 300 && bad < 300 * LANES - 300);
}

// A root need not tell where another one is not finite whenever it is not: as a term, a factor, a numerator or the
// operand of a sign, but not as a denominator, in a choice or in another function.
static void test_which_roots_tell(void **unused)
{
    (void)unused;
    static Case c;
    uint64_t seed = 43;
    for (int kind = 0; kind < 12; kind++) {
        start(&c, &seed);
        YkGraph *g = &c.graph;
        YkRef x = yk_graph_multiply(g, c.leaves[0], c.leaves[1]), y = c.leaves[2];
        const YkRef readers[] = {yk_graph_add(g, x, y),
                                 yk_graph_subtract(g, x, y),
                                 yk_graph_subtract(g, y, x),
                                 yk_graph_multiply(g, x, y),
                                 yk_graph_divide(g, x, y),
                                 yk_graph_unary(g, YK_VALUE_SIZE, x),
                                 yk_graph_unary(g, YK_VALUE_SIZE, yk_graph_subtract(g, y, x)),
                                 yk_graph_add(g, yk_graph_minus(g, yk_graph_divide(g, x, y)), c.leaves[3]),
                                 yk_graph_divide(g, y, x),
                                 yk_graph_choose(g, x, y, c.leaves[3]),
                                 yk_graph_unary(g, YK_VALUE_ROOT, x),
                                 yk_graph_function(g, YK_ATAN, x, YK_NONE)};
        const YkRef roots[] = {x, readers[kind]};
        YkTape *t = yk_tape_new(g, c.leaves, LEAVES + PARAMETERS, roots, 2, LANES, (YkTapeLaws){0});
        assert_non_null(t);
        assert_true(yk_tape_tells(t, 1));
        assert_int_equal(yk_tape_tells(t, 0), kind >= 8);
        yk_tape_free(t);
        end(&c);
    }
}

// Compares all lanes of the second root with the values of the graph, in lanes and alone.
static void check_second_root(Case *c, YkTape *t)
{
    double *numbers = calloc(c->graph.count, sizeof *numbers);
    run(c, t, 0, LANES);
    for (size_t i = 0; i < LANES; i++) {
        for (int k = 0; k < LEAVES + PARAMETERS; k++) numbers[c->leaves[k]] = c->leaf[k][i];
        graph_evaluate(&c->graph, numbers);
        assert_memory_equal(&c->out[1][i], &numbers[c->roots[1]], sizeof(double));
        run(c, t, i, 1);
        assert_memory_equal(&c->out[1][i], &numbers[c->roots[1]], sizeof(double));
    }
    free(numbers);
}

// Returns a product of leaves; which: the factor that is a parameter, or 2.
static YkRef product_with(Case *c, int leaf, int parameter, int which)
{
    YkRef first = which == 0 ? c->leaves[LEAVES + parameter] : c->leaves[leaf];
    YkRef second = which == 1 ? c->leaves[LEAVES + parameter] : c->leaves[leaf + 1];
    return yk_graph_multiply(&c->graph, first, second);
}

// A sum of two products and one more term is one step, with the bits of its parts; so is the size that is never 0.
// Factors may be the same in all lanes.
static void test_joined_sums(void **unused)
{
    (void)unused;
    static Case c;
    uint64_t seed = 5;
    for (int kind = 0; kind < 99; kind++) {
        start(&c, &seed);
        YkGraph *g = &c.graph;
        YkRef e = c.leaves[4], ab = product_with(&c, 0, 0, kind / 11 % 3), cd = product_with(&c, 2, 1, kind / 33);
        YkRef dot = yk_graph_add(g, ab, cd), cross = yk_graph_subtract(g, ab, cd);
        YkRef plus = yk_graph_add(g, e, ab), less = yk_graph_subtract(g, e, ab);
        const YkRef sums[] = {
            yk_graph_add(g, e, dot),        yk_graph_subtract(g, e, dot),          yk_graph_subtract(g, dot, e),
            yk_graph_add(g, e, cross),      yk_graph_subtract(g, e, cross),        yk_graph_subtract(g, cross, e),
            yk_graph_add(g, plus, cd),      yk_graph_subtract(g, plus, cd),        yk_graph_add(g, less, cd),
            yk_graph_subtract(g, less, cd), yk_graph_unary(g, YK_VALUE_NONZERO, e)};
        for (int k = 0; k < ROOTS; k++) c.roots[k] = sums[kind % 11];
        YkTape *t = tape_of(&c, (YkTapeLaws){0});
        assert_int_equal(yk_tape_length(t), ROOTS); // one step, and copies for the other roots
        check_second_root(&c, t);
        yk_tape_free(t);
        end(&c);
    }
}

// Sums, differences and quotients whose terms are the same in all lanes.
static void test_terms_of_parameters(void **unused)
{
    (void)unused;
    static Case c;
    uint64_t seed = 7;
    for (int kind = 0; kind < 18; kind++) {
        start(&c, &seed);
        YkGraph *g = &c.graph;
        YkRef x = c.leaves[0], p = c.leaves[LEAVES], q = c.leaves[LEAVES + 1], y = kind < 9 ? c.leaves[1] : q;
        YkRef product = yk_graph_multiply(g, x, y);
        const YkRef values[] = {
            yk_graph_add(g, x, p),       yk_graph_subtract(g, x, p),       yk_graph_subtract(g, p, x),
            yk_graph_divide(g, x, p),    yk_graph_divide(g, p, x),         product,
            yk_graph_add(g, product, p), yk_graph_subtract(g, product, p), yk_graph_subtract(g, p, product)};
        for (int k = 0; k < ROOTS; k++) c.roots[k] = values[kind % 9];
        YkTape *t = tape_of(&c, (YkTapeLaws){0});
        assert_int_equal(yk_tape_length(t), ROOTS);
        check_second_root(&c, t);
        yk_tape_free(t);
        end(&c);
    }
}

// A product with a parameter is part of every sum that needs it; as a root of its own it is a step.
static void test_shared_products(void **unused)
{
    (void)unused;
    static Case c;
    uint64_t seed = 13;
    for (int is_root = 0; is_root < 2; is_root++) {
        start(&c, &seed);
        YkGraph *g = &c.graph;
        YkRef product = yk_graph_multiply(g, c.leaves[0], c.leaves[LEAVES]);
        for (int k = 0; k < ROOTS; k++)
            c.roots[k] = k % 2 ? yk_graph_add(g, product, c.leaves[1 + k % 5])
                               : yk_graph_subtract(g, c.leaves[1 + k % 5], product);
        c.roots[2] = is_root ? product : c.roots[2];
        c.roots[ROOTS - 1] = yk_graph_add(g, c.leaves[5], c.leaves[4]);
        YkTape *t = tape_of(&c, (YkTapeLaws){0});
        assert_int_equal(yk_tape_length(t), ROOTS);
        check_second_root(&c, t);
        yk_tape_free(t);
        end(&c);
    }
}

// Leaves of a pose may also have one value in all lanes, and parameters others later.
static void test_values_for_all_lanes(void **unused)
{
    (void)unused;
    static Case c;
    uint64_t seed = 5;
    start(&c, &seed);
    YkRef sum = yk_graph_add(&c.graph, c.leaves[0], yk_graph_multiply(&c.graph, c.leaves[6], c.leaves[7]));
    for (int k = 0; k < ROOTS; k++) c.roots[k] = sum;
    YkTape *t = tape_of(&c, (YkTapeLaws){0});
    assert_true(yk_tape_needs(t, 0) && yk_tape_needs(t, 6));
    assert_false(yk_tape_needs(t, 1) || yk_tape_needs(t, 8));
    assert_int_equal(yk_tape_length(t), 1 + ROOTS - 1);
    double *out[ROOTS];
    for (size_t k = 0; k < ROOTS; k++) out[k] = c.out[k];
    yk_tape_set(t, 0, 3);
    yk_tape_set(t, 6, 2);
    yk_tape_set(t, 7, 5);
    yk_tape_prepare(t);
    yk_tape_run(t, out, LANES);
    for (size_t k = 0; k < ROOTS; k++) assert_true(c.out[k][0] == 13 && c.out[k][LANES - 1] == 13);
    yk_tape_free(t);
    end(&c);
}

// --- calls

static void square(const void *context, int32_t law, double x, double result[3])
{
    result[0] = *(const double *)context * x * x + law;
    result[1] = 2 * *(const double *)context * x;
    result[2] = 2 * *(const double *)context;
}

static void test_laws(void **unused)
{
    (void)unused;
    static Case c;
    uint64_t seed = 6;
    static const double factor = 3;
    start(&c, &seed);
    int32_t call = yk_graph_call(
        &c.graph,
        (YkCall){.kind = YK_CALL_LAW, .index = 7, .arguments = c.leaves, .argument_count = 1, .result_count = 3});
    YkRef value = yk_graph_result(&c.graph, call, 0), bend = yk_graph_result(&c.graph, call, 2);
    for (int k = 0; k < ROOTS; k++) c.roots[k] = k == 1 ? bend : k == 2 ? yk_graph_add(&c.graph, value, bend) : value;
    YkTape *t = tape_of(&c, (YkTapeLaws){&factor, square});
    run(&c, t, 0, LANES);
    for (int i = 0; i < LANES; i++) {
        double x = c.leaf[0][i];
        assert_true(c.out[0][i] == 3 * x * x + 7 && c.out[1][i] == 6 && c.out[2][i] == c.out[0][i] + 6);
    }
    yk_tape_free(t);
    end(&c);
}

// A x = b with a 0 on the diagonal: rows must change places.
static void test_equations(void **unused)
{
    (void)unused;
    static Case c;
    uint64_t seed = 8;
    start(&c, &seed);
    YkRef zero = yk_graph_number(&c.graph, 0), *x = c.leaves;
    const YkRef system[] = {zero, x[0], x[1], x[2], x[3], x[4]}; // [0 x0 | x1], [x2 x3 | x4]
    int32_t call = yk_graph_call(
        &c.graph,
        (YkCall){.kind = YK_CALL_SOLVE, .n = 2, .m = 1, .arguments = system, .argument_count = 6, .result_count = 7});
    for (int k = 0; k < ROOTS; k++) c.roots[k] = yk_graph_result(&c.graph, call, k == 0 ? 2 : 5);
    YkTape *t = tape_of(&c, (YkTapeLaws){0});
    run(&c, t, 0, LANES);
    for (int i = 0; i < LANES; i++) {
        double first = c.out[0][i], second = c.out[1][i];
        assert_true(fabs(c.leaf[0][i] * second - c.leaf[1][i]) < 1e-14);
        assert_true(fabs(c.leaf[2][i] * first + c.leaf[3][i] * second - c.leaf[4][i]) < 1e-13 * (1 + fabs(second)));
    }
    yk_tape_free(t);
    end(&c);
}

// One lane reads leaves where a pose's numbers stand, in one place and in another, and its own ones between.
static void check_poses(Case *c, YkTape *t)
{
    double pose[LANES][LEAVES];
    run(c, t, 0, LANES);
    for (size_t k = 0; k < LEAVES; k += 2) yk_tape_read_number(t, k, LEAVES - 1 - k);
    for (size_t i = 0; i < LANES; i++) {
        double lanes[ROOTS];
        for (size_t k = 0; k < LEAVES; k++) {
            double *own = yk_tape_leaf_of_one(t, k);
            pose[i][LEAVES - 1 - k] = c->leaf[k][i];
            if (own) *own = k % 2 == 0 ? NAN : c->leaf[k][i];
        }
        const double *const *result = yk_tape_run_one(t, pose[i]);
        for (int k = 0; k < ROOTS; k++) {
            lanes[k] = c->out[k][i];
            assert_memory_equal(result[k], &lanes[k], sizeof(double));
        }
        if (i % 3 == 0) run(c, t, i, 1);
        for (int k = 0; k < ROOTS; k++) assert_memory_equal(&c->out[k][i], &lanes[k], sizeof(double));
    }
}

// Returns a product with its factors in one order or the other.
static YkRef product_either_way(YkGraph *g, YkRef a, YkRef b, bool is_turned)
{
    return is_turned ? yk_graph_multiply(g, b, a) : yk_graph_multiply(g, a, b);
}

// Both components of a turning vector's acceleration are one step, however they are written, and also where others read
// the square of its rate; but only if they belong together.
static void test_turning_vectors(void **unused)
{
    (void)unused;
    static Case c;
    uint64_t seed = 23;
    for (int kind = 0; kind < 64; kind++) {
        bool is_read = kind & 1, is_pair = kind & 2, turns = kind & 4, swaps = kind & 8;
        start(&c, &seed);
        YkGraph *g = &c.graph;
        YkRef x = c.leaves[0], y = c.leaves[kind & 16 ? LEAVES : 1], w = c.leaves[2], a = c.leaves[3];
        YkRef square = yk_graph_multiply(g, w, w), xw = product_either_way(g, x, square, turns);
        YkRef ya = product_either_way(g, y, a, kind & 32), xa = product_either_way(g, x, a, turns);
        YkRef yw = product_either_way(g, y, square, kind & 32);
        YkRef along = swaps ? yk_graph_add(g, ya, xw) : yk_graph_add(g, xw, ya);
        YkRef across = is_pair ? yk_graph_subtract(g, xa, yw) : yk_graph_subtract(g, yw, xa);
        const YkRef roots[ROOTS] = {along, across, is_read ? square : along, along, across, along, across};
        memcpy(c.roots, roots, sizeof roots);
        YkTape *t = tape_of(&c, (YkTapeLaws){0});
        bool is_joined = YK_KNOWS_BLOCKS && is_pair;
        size_t steps = (is_joined ? 1 : 2) + (is_joined && !is_read ? 0 : 1);
        assert_int_equal(yk_tape_length(t), steps + (is_read ? 4 : 5)); // and copies for the other roots
        run(&c, t, 0, LANES);
        for (size_t i = 0; i < LANES; i++) {
            double X = c.leaf[0][i], Y = kind & 16 ? c.leaf[LEAVES][0] : c.leaf[1][i], W = c.leaf[2][i],
                   A = c.leaf[3][i];
            double xW = X * (W * W), yA = Y * A, xA = X * A, yW = Y * (W * W);
            double first = xW + yA, second = is_pair ? xA - yW : yW - xA;
            assert_memory_equal(&c.out[3][i], &first, sizeof first);
            assert_memory_equal(&c.out[4][i], &second, sizeof second);
        }
        check_poses(&c, t);
        yk_tape_free(t);
        end(&c);
    }
}

static void test_numbers_of_a_pose(void **unused)
{
    (void)unused;
    static Case c;
    uint64_t seed = 12;
    static const double factor = 2;
    for (int round = 0; round < 40; round++) {
        start(&c, &seed);
        grow(&c, &seed);
        int32_t call = yk_graph_call(
            &c.graph, (YkCall){.kind = YK_CALL_LAW, .arguments = c.leaves + 2, .argument_count = 1, .result_count = 3});
        c.roots[4] = yk_graph_result(&c.graph, call, 0);
        c.roots[5] = c.leaves[0];
        c.roots[6] = yk_graph_function(&c.graph, YK_SIN, c.leaves[4], YK_NONE);
        YkTape *t = tape_of(&c, (YkTapeLaws){&factor, square});
        check_poses(&c, t);
        yk_tape_free(t);
        end(&c);
    }
}

static void test_what_a_tape_cannot_do(void **unused)
{
    (void)unused;
    static Case c;
    uint64_t seed = 9;
    start(&c, &seed);
    int32_t call = yk_graph_call(
        &c.graph, (YkCall){.kind = YK_CALL_GROUP, .arguments = c.leaves, .argument_count = 1, .result_count = 1});
    YkRef unknown = yk_graph_result(&c.graph, call, 0), sum = yk_graph_add(&c.graph, c.leaves[0], c.leaves[1]);
    assert_null(yk_tape_new(&c.graph, c.leaves, 2, &unknown, 1, LANES, (YkTapeLaws){0}));
    assert_null(yk_tape_new(&c.graph, c.leaves, 1, &sum, 1, LANES, (YkTapeLaws){0})); // nobody gives the second leaf
    assert_null(yk_tape_new(&c.graph, c.leaves, 1, &c.leaves[1], 1, LANES, (YkTapeLaws){0}));
    end(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_graphs),
        cmocka_unit_test(test_signs_cost_no_step),
        cmocka_unit_test(test_roots_that_tell),
        cmocka_unit_test(test_which_roots_tell),
        cmocka_unit_test(test_joined_sums),
        cmocka_unit_test(test_terms_of_parameters),
        cmocka_unit_test(test_shared_products),
        cmocka_unit_test(test_values_for_all_lanes),
        cmocka_unit_test(test_laws),
        cmocka_unit_test(test_equations),
        cmocka_unit_test(test_turning_vectors),
        cmocka_unit_test(test_numbers_of_a_pose),
        cmocka_unit_test(test_what_a_tape_cannot_do),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
