// Strong components against reachability by exhaustion.
#include <stdbool.h>
#include <stdlib.h>
#include "check.h"
#include "num/components.h"

enum { MOST = 12 };

typedef struct Digraph {
    size_t n;
    bool edge[MOST][MOST];
    uint32_t first[MOST + 1];
    int32_t target[MOST * MOST];
} Digraph;

static Digraph random_digraph(uint64_t *seed)
{
    Digraph g = {.n = (size_t)(check_random(seed) % (MOST + 1))};
    double density = check_uniform(seed, 0.02, 0.4);
    uint32_t edges = 0;
    for (size_t v = 0; v < g.n; v++) {
        g.first[v] = edges;
        for (size_t w = 0; w < g.n; w++)
            if (check_uniform(seed, 0, 1) < density) {
                g.edge[v][w] = true;
                g.target[edges++] = (int32_t)w;
            }
    }
    g.first[g.n] = edges;
    return g;
}

// Warshall: reach[v][w] when a path leads from v to w.
static void reachable(const Digraph *g, bool reach[MOST][MOST])
{
    for (size_t v = 0; v < g->n; v++)
        for (size_t w = 0; w < g->n; w++) reach[v][w] = v == w || g->edge[v][w];
    for (size_t k = 0; k < g->n; k++)
        for (size_t v = 0; v < g->n; v++)
            for (size_t w = 0; w < g->n; w++) reach[v][w] = reach[v][w] || (reach[v][k] && reach[k][w]);
}

static void components_are_the_classes_of_mutual_reach(void **state)
{
    (void)state;
    uint64_t seed = 21;
    for (int trial = 0; trial < 4000; trial++) {
        Digraph g = random_digraph(&seed);
        bool reach[MOST][MOST], used[MOST] = {false};
        int32_t component[MOST], work[5 * MOST];
        size_t count = yk_components(g.n, g.first, g.target, component, work);
        reachable(&g, reach);
        for (size_t v = 0; v < g.n; v++) {
            assert_in_range(component[v], 0, count - 1);
            used[component[v]] = true;
            for (size_t w = 0; w < g.n; w++) {
                assert_int_equal(component[v] == component[w], reach[v][w] && reach[w][v]);
                if (reach[v][w]) assert_true(component[w] <= component[v]); // what v needs comes first
            }
        }
        for (size_t c = 0; c < count; c++) assert_true(used[c]); // no number is skipped
    }
}

static void a_long_path_and_a_long_ring_need_no_recursion(void **state)
{
    (void)state;
    enum { LONG = 300000 };
    uint32_t *first = calloc(LONG + 1, sizeof *first);
    int32_t *target = calloc(LONG, sizeof *target), *component = calloc(LONG, sizeof *component),
            *work = calloc(5 * LONG, sizeof *work);
    assert_true(first && target && component && work);
    for (int ring = 0; ring < 2; ring++) {
        for (uint32_t v = 0; v <= LONG; v++) first[v] = v < LONG - 1 || ring ? v : LONG - 1;
        for (int32_t v = 0; v < LONG; v++) target[v] = (v + 1) % LONG;
        size_t count = yk_components(LONG, first, target, component, work);
        assert_int_equal(count, ring ? 1 : LONG);
        assert_int_equal(component[LONG - 1], 0);
        assert_int_equal(component[0], ring ? 0 : LONG - 1);
    }
    free(first);
    free(target);
    free(component);
    free(work);
}

static void loops_to_itself_and_doubled_edges_change_nothing(void **state)
{
    (void)state;
    const uint32_t first[] = {0, 3, 5};
    const int32_t target[] = {0, 1, 1, 1, 1};
    int32_t component[2], work[10];
    assert_int_equal(yk_components(2, first, target, component, work), 2);
    assert_int_equal(component[1], 0);
    assert_int_equal(component[0], 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(components_are_the_classes_of_mutual_reach),
        cmocka_unit_test(a_long_path_and_a_long_ring_need_no_recursion),
        cmocka_unit_test(loops_to_itself_and_doubled_edges_change_nothing),
    };
    return cmocka_run_group_tests_name("num/components", tests, NULL, NULL);
}
