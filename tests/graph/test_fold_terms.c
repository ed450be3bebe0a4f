// Sums and products that join terms: whatever is built, they have the value of what was asked for.
#include "graph/graph_check.h"

enum { POOL = 40, STEPS = 60, LEAVES = 6 };

// Values with the numbers that they stand for, and the size of what was added on the way to them: the measure for
// rounding.
typedef struct Pool {
    YkRef ref[POOL];
    double is[POOL], size[POOL];
    size_t count;
} Pool;

static const double numbers[] = {1, 2, -1, 3, 0.5, -4, 0.036};

static void put(Pool *p, uint64_t *seed, YkRef ref, double is, double size)
{
    size_t at = p->count < POOL ? p->count++ : LEAVES + check_random(seed) % (POOL - LEAVES);
    p->ref[at] = ref, p->is[at] = is, p->size[at] = size;
}

static void start(YkGraph *g, Pool *p, uint64_t *seed, double *leaf_value)
{
    static const char *const names[] = {"x", "y", "c", "s", "d", "e"};
    double turn[2] = {check_uniform(seed, -3, 3), check_uniform(seed, -3, 3)};
    for (size_t k = 0; k < LEAVES; k++) {
        double angle = turn[k / 2 - (k > 1)];
        leaf_value[k] = k < 2 ? check_uniform(seed, 0.5, 2) : k % 2 == 0 ? cos(angle) : sin(angle);
        YkRef leaf = yk_graph_leaf(g, YK_LEAF_POSE, names[k]);
        put(p, seed, leaf, leaf_value[k], fabs(leaf_value[k]));
    }
    yk_graph_is_unit(g, (YkRefVec){p->ref[2], p->ref[3]});
    yk_graph_is_unit(g, (YkRefVec){p->ref[4], p->ref[5]});
}

static void build(YkGraph *g, Pool *p, uint64_t *seed)
{
    for (int step = 0; step < STEPS; step++) {
        size_t a = check_random(seed) % p->count, b = check_random(seed) % p->count;
        double number = numbers[check_random(seed) % (sizeof numbers / sizeof *numbers)],
               size = p->size[a] + p->size[b];
        double product = p->size[a] * p->size[b];
        switch (check_random(seed) % 7) {
        case 0:
        case 1:
            if (size < 1e3) put(p, seed, yk_graph_add(g, p->ref[a], p->ref[b]), p->is[a] + p->is[b], size);
            break;
        case 2:
            if (size < 1e3) put(p, seed, yk_graph_subtract(g, p->ref[a], p->ref[b]), p->is[a] - p->is[b], size);
            break;
        case 3:
        case 4:
            if (product < 1e3) put(p, seed, yk_graph_multiply(g, p->ref[a], p->ref[b]), p->is[a] * p->is[b], product);
            break;
        case 5:
            put(p, seed, yk_graph_multiply(g, yk_graph_number(g, number), p->ref[a]), number * p->is[a],
                fabs(number) * p->size[a]);
            break;
        default: // by x or y, which are far from 0
            b = check_random(seed) % 2;
            put(p, seed, yk_graph_multiply(g, p->ref[a], yk_graph_inverse(g, p->ref[b])), p->is[a] / p->is[b],
                p->size[a] / p->is[b]);
        }
    }
}

static void random_sums_of_products_keep_their_value(void **state)
{
    (void)state;
    for (size_t k = 0; k < check_cases(400); k++)
        for (int way = 0; way < 4; way++) {
            uint64_t seed = k + 1;
            double leaf_value[LEAVES];
            Pool p = {.count = 0};
            YkGraph g;
            YkArena *arena = yk_arena_new();
            assert_true(arena && yk_graph_start(&g, arena));
            g.joins_terms = way % 2 == 1, g.shares_signs = way / 2 == 1;
            start(&g, &p, &seed, leaf_value);
            build(&g, &p, &seed);
            double *values = calloc(g.count, sizeof *values);
            assert_non_null(values);
            for (size_t i = 0; i < LEAVES; i++) values[p.ref[i]] = leaf_value[i];
            graph_evaluate(&g, values);
            for (size_t i = 0; i < p.count; i++) {
                double off = fabs(values[p.ref[i]] - p.is[i]), allowed = 1e-13 * (p.size[i] + 1);
                if (!(off <= allowed)) print_error("case %zu, way %d: off by %g of %g\n", k, way, off, p.size[i]);
                assert_true(off <= allowed);
            }
            free(values);
            yk_graph_end(&g);
            yk_arena_free(arena);
        }
}

// c x + c y and s x + s y have one sum x + y, whose numbers cancel as far as they are more than rounded.
static void what_lies_along_one_direction_shares_a_sum(void **state)
{
    (void)state;
    for (int shares = 0; shares < 2; shares++) {
        YkGraph g;
        YkArena *arena = yk_arena_new();
        assert_true(arena && yk_graph_start(&g, arena));
        g.joins_terms = true, g.shares_signs = shares == 1;
        YkRef x = yk_graph_leaf(&g, YK_LEAF_POSE, "x"), y = yk_graph_leaf(&g, YK_LEAF_POSE, "y"), along[2];
        YkRef part[2] = {yk_graph_leaf(&g, YK_LEAF_POSE, "c"), yk_graph_leaf(&g, YK_LEAF_POSE, "s")};
        yk_graph_is_unit(&g, (YkRefVec){part[0], part[1]});
        for (int k = 0; k < 2; k++) {
            YkRef terms[] = {x, yk_graph_number(&g, 0.1), y, yk_graph_number(&g, 0.2), yk_graph_number(&g, -0.3)};
            along[k] = yk_graph_number(&g, 0);
            for (size_t i = 0; i < 5; i++)
                along[k] = yk_graph_add(&g, along[k], yk_graph_multiply(&g, part[k], terms[i]));
        }
        for (int k = 0; k < 2; k++)
            assert_int_equal(along[k] == yk_graph_multiply(&g, part[k], yk_graph_add(&g, x, y)), shares);
        yk_graph_end(&g);
        yk_arena_free(arena);
    }
}

// Moments of what turns with a body, in any order of their terms, for every k: k c (c x + s y) + k s (s x - c y) is
// k x, and k s (c x + s y) - k c (s x - c y) is k y.
static void what_turns_with_one_body_folds(void **state)
{
    (void)state;
    uint64_t seed = 3;
    for (int trial = 0; trial < 128; trial++) {
        bool is_y = trial % 2 == 1;
        YkGraph g;
        YkArena *arena = yk_arena_new();
        assert_true(arena && yk_graph_start(&g, arena));
        g.joins_terms = true;
        YkRef x = yk_graph_leaf(&g, YK_LEAF_POSE, "x"), y = yk_graph_leaf(&g, YK_LEAF_POSE, "y"),
              c = yk_graph_leaf(&g, YK_LEAF_POSE, "c"), s = yk_graph_leaf(&g, YK_LEAF_POSE, "s");
        yk_graph_is_unit(&g, (YkRefVec){c, s});
        YkRef cc = yk_graph_multiply(&g, c, c), ss = yk_graph_multiply(&g, s, s), cs = yk_graph_multiply(&g, c, s);
        YkRef k = yk_graph_number(&g, numbers[trial / 2 % 7]);
        YkRef term[4] = {yk_graph_multiply(&g, cc, is_y ? y : x), yk_graph_multiply(&g, cs, is_y ? x : y),
                         yk_graph_multiply(&g, ss, is_y ? y : x), yk_graph_multiply(&g, cs, is_y ? x : y)};
        double sign[4] = {1, 1, 1, -1};
        for (size_t i = 3; i > 0; i--) { // in any order
            size_t j = check_random(&seed) % (i + 1);
            YkRef kept = term[i];
            double own = sign[i];
            term[i] = term[j], sign[i] = sign[j];
            term[j] = kept, sign[j] = own;
        }
        YkRef sum = yk_graph_number(&g, 0);
        for (size_t i = 0; i < 4; i++) {
            YkRef next = yk_graph_multiply(&g, k, term[i]);
            sum = sign[i] > 0 ? yk_graph_add(&g, sum, next) : yk_graph_subtract(&g, sum, next);
        }
        assert_int_equal(sum, yk_graph_multiply(&g, k, is_y ? y : x));
        yk_graph_end(&g);
        yk_arena_free(arena);
    }
}

// 5 (2 x + 3 y) is 10 x + 15 y, and 5 (2 x + 3 y - 4) is 10 x + 15 y - 20: the sum in brackets needs no step.
static void a_number_multiplies_each_term(void **state)
{
    (void)state;
    for (int shares = 0; shares < 2; shares++) {
        YkGraph g;
        YkArena *arena = yk_arena_new();
        assert_true(arena && yk_graph_start(&g, arena));
        g.joins_terms = true, g.shares_signs = shares == 1;
        YkRef term[2][2], five = yk_graph_number(&g, 5);
        for (int k = 0; k < 2; k++) {
            YkRef leaf = yk_graph_leaf(&g, YK_LEAF_POSE, k ? "y" : "x");
            for (int times = 0; times < 2; times++)
                term[times][k] = yk_graph_multiply(&g, yk_graph_number(&g, (2 + k) * (times ? 5 : 1)), leaf);
        }
        YkRef sum = yk_graph_add(&g, term[0][0], term[0][1]), five_sums = yk_graph_add(&g, term[1][0], term[1][1]);
        YkRef less = yk_graph_subtract(&g, sum, yk_graph_number(&g, 4)),
              five_less = yk_graph_subtract(&g, five_sums, yk_graph_number(&g, 20));
        assert_int_equal(yk_graph_multiply(&g, five, sum) == five_sums, shares);
        assert_int_equal(yk_graph_multiply(&g, five, less) == five_less, shares);
        yk_graph_end(&g);
        yk_arena_free(arena);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_sums_of_products_keep_their_value),
        cmocka_unit_test(what_turns_with_one_body_folds),
        cmocka_unit_test(what_lies_along_one_direction_shares_a_sum),
        cmocka_unit_test(a_number_multiplies_each_term),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
