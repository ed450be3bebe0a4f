// Elements as values of a graph: evaluated there they are what the ring's own sum of terms gives.
#include "graph/graph_check.h"
#include "ring/graph/element.h"
#include "ring/inside.h"
#include "ring/ring_check.h"

typedef struct Case {
    Fixture f;
    YkArena *arena;
    YkRingGraph graph;
} Case;

static Case case_new(uint64_t seed)
{
    Case c = {.f = fixture_new(seed), .arena = yk_arena_new()};
    assert_non_null(c.arena);
    return c;
}

static void start(Case *c)
{
    assert_true(yk_ring_graph_start(&c->graph, c->f.ring, c->arena));
}

static void case_free(Case *c)
{
    yk_ring_graph_end(&c->graph);
    yk_arena_free(c->arena);
    yk_ring_free(c->f.ring);
}

// Evaluates a value of the graph where each leaf has its symbol's value.
static double evaluate(const Case *c, YkRef ref, const double *values)
{
    double *numbers = calloc(c->graph.graph.count, sizeof *numbers);
    assert_non_null(numbers);
    for (size_t s = 0; s < c->graph.symbol_count; s++)
        if (c->graph.leaf[s] != YK_NONE) numbers[c->graph.leaf[s]] = values[s];
    graph_evaluate(&c->graph.graph, numbers);
    double found = numbers[ref];
    free(numbers);
    return found;
}

static void check_real(Case *c, Element a, const double *values)
{
    YkRef ref = yk_ring_graph_of(&c->graph, a);
    assert_false(c->graph.graph.failed);
    double size = 0;
    for (size_t k = 0; k < a->count; k++) // terms are larger than their sum
        size += yk_norm(yk_ring_value(
            c->f.ring, yk_poisson_term(c->f.ring, a->terms[k].key, a->terms[k].number, a->denominator), values));
    CHECK_NEAR(evaluate(c, ref, values), yk_ring_value(c->f.ring, a, values).x, 1e-12 * (1 + size));
}

static void a_graph_has_the_values_of_the_elements(void **state)
{
    (void)state;
    Case c = case_new(11);
    YkRing *r = c.f.ring;
    int32_t root = yk_ring_root(r, "L", read_text(&c.f, "l1^2 + 4 m1 lc1 + l1*lc1*cos(theta1)"));
    double *values = random_values(&c.f);
    start(&c);
    for (int i = 0; i < 400; i++) {
        Element a = random_element(&c.f, 1 + below(&c.f, 6));
        if (below(&c.f, 3) == 0) a = yk_ring_multiply(r, a, yk_ring_of(r, root));
        check_real(&c, yk_ring_real(r, a), values);
        check_real(&c, yk_ring_imaginary(r, a), values);
    }
    free(values);
    case_free(&c);
}

// Multiples of one angle, by products up to three times and by the angle's own multiple beyond, either way round.
static void multiples_of_angles_turn_the_right_way(void **state)
{
    (void)state;
    Case c = case_new(12);
    YkRing *r = c.f.ring;
    double *values = random_values(&c.f);
    start(&c);
    for (int32_t first = -6; first <= 6; first++)
        for (int32_t second = -6; second <= 6; second++) {
            const YkAngleTerm terms[] = {{c.f.angle[0], first}, {c.f.angle[1], second}};
            Element unit = yk_ring_exp(r, terms, 2);
            double angle = first * values[c.f.angle[0]] + second * values[c.f.angle[1]];
            CHECK_NEAR(evaluate(&c, yk_ring_graph_of(&c.graph, yk_ring_real(r, unit)), values), cos(angle), 1e-14);
            CHECK_NEAR(evaluate(&c, yk_ring_graph_of(&c.graph, yk_ring_imaginary(r, unit)), values), sin(angle), 1e-14);
        }
    free(values);
    case_free(&c);
}

// A symbol that stands for a value has it until it is taken back; definitions nest.
static void a_symbol_stands_for_a_value_until_it_is_forgotten(void **state)
{
    (void)state;
    Case c = case_new(13);
    double *values = random_values(&c.f);
    start(&c);
    int32_t theta = c.f.angle[0], l1 = c.f.parameter[3];
    double x = values[theta], l = values[l1];
    Element a = read_text(&c.f, "l1*sin(2 theta1) + l1^2");
    CHECK_NEAR(evaluate(&c, yk_ring_graph_of(&c.graph, a), values), l * sin(2 * x) + l * l, 1e-14);
    YkRef minus = yk_graph_minus(&c.graph.graph, yk_ring_graph_symbol(&c.graph, theta));
    yk_ring_graph_define(&c.graph, theta, minus);
    CHECK_NEAR(evaluate(&c, yk_ring_graph_of(&c.graph, a), values), -l * sin(2 * x) + l * l, 1e-14);
    yk_ring_graph_define(&c.graph, l1, yk_graph_number(&c.graph.graph, 3));
    yk_ring_graph_define(&c.graph, theta, yk_graph_number(&c.graph.graph, 0.25));
    CHECK_NEAR(evaluate(&c, yk_ring_graph_of(&c.graph, a), values), 3 * sin(0.5) + 9, 1e-14);
    yk_ring_graph_forget(&c.graph, 2);
    CHECK_NEAR(evaluate(&c, yk_ring_graph_of(&c.graph, a), values), -3 * sin(2 * x) + 9, 1e-14);
    yk_ring_graph_forget(&c.graph, 0);
    CHECK_NEAR(evaluate(&c, yk_ring_graph_of(&c.graph, a), values), l * sin(2 * x) + l * l, 1e-14);
    // A symbol that came later has its room.
    int32_t late = yk_ring_symbol(c.f.ring, "late", YK_RING_CONSTANT);
    YkRef leaf = yk_ring_graph_symbol(&c.graph, late);
    assert_string_equal(c.graph.graph.values[leaf].name, "late");
    assert_true(c.graph.graph.values[leaf].of_parameters);
    YkRef angle = yk_ring_graph_symbol(&c.graph, theta);
    assert_string_equal(c.graph.graph.values[angle].name, "m->theta1");
    assert_false(c.graph.graph.values[angle].of_parameters);
    free(values);
    case_free(&c);
}

static void what_is_not_real_is_refused(void **state)
{
    (void)state;
    Case c = case_new(14);
    start(&c);
    yk_ring_graph_of(&c.graph, yk_ring_unit(c.f.ring, c.f.angle[0]));
    assert_true(c.graph.graph.failed);
    assert_int_equal(yk_ring_status(c.f.ring), YK_RING_NOT_REAL);
    case_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_graph_has_the_values_of_the_elements),
        cmocka_unit_test(multiples_of_angles_turn_the_right_way),
        cmocka_unit_test(a_symbol_stands_for_a_value_until_it_is_forgotten),
        cmocka_unit_test(what_is_not_real_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
