// Code for M and h: the short way over the tree gives what the expanded equations give, in few operations.
#include "derive/forces/lagrange.h"
#include "derive/printed_code.h"
#include "forces_check.h"
#include "graph/graph_check.h"

typedef struct Built {
    YkRingGraph graph;
    YkArena *arena;
    YkRef *roots, *M, *h; // M and h are parts of the roots
} Built;

static Built build(Machine *m)
{
    size_t n = m->d->tree_count;
    void *f = (void *)forces_of(m);
    Built built = {.arena = yk_arena_new(), .roots = calloc(n * n + n + 1, sizeof *built.roots)};
    assert_true(built.arena && built.roots && yk_ring_graph_start(&built.graph, m->d->ring, built.arena));
    built.M = built.roots, built.h = built.roots + n * n;
    assert_true(yk_derive_define_bodies(m->d, &built.graph));
    assert_true(yk_derive_build_mass(f, &built.graph, built.M));
    assert_true(yk_derive_build_rest(f, &built.graph, built.h));
    return built;
}

static void built_end(Built *built)
{
    yk_ring_graph_end(&built->graph);
    yk_arena_free(built->arena);
    free(built->roots);
}

typedef struct Sample {
    double *symbols, *numbers;
} Sample;

static void take_definition(const Built *built, const Sample *sample, int32_t symbol)
{
    if (symbol == YK_NONE || (size_t)symbol >= built->graph.symbol_count) return;
    YkRef defined = built->graph.defined[symbol];
    if (defined != YK_NONE) sample->symbols[symbol] = sample->numbers[defined];
}

// What symbols of bodies stand for, as the graph has it.
static void complete(Machine *m, const Built *built, Sample *sample)
{
    const YkDeriveForces *f = forces_of(m);
    for (size_t b = 1; b < m->d->model->body_count; b++) {
        take_definition(built, sample, m->d->bodies[b].angle);
        take_definition(built, sample, m->d->bodies[b].rate);
        take_definition(built, sample, m->d->bodies[b].acceleration);
    }
    for (size_t k = 0; k < m->d->constant_count; k++) // numbers of the file
        take_definition(built, sample, m->d->constants[k].symbol);
    yk_ring_complete(m->d->ring, sample->symbols);
    for (size_t k = 0; k < f->length_count; k++)
        if (f->lengths[k].rate_symbol != YK_NONE)
            sample->symbols[f->lengths[k].rate_symbol] =
                yk_ring_value(m->d->ring, f->lengths[k].rate, sample->symbols).x;
}

// Every symbol random; the numbers of all values.
static Sample take_sample(Machine *m, const Built *built)
{
    size_t count = yk_ring_symbol_count(m->d->ring);
    Sample sample = {calloc(count + 1, sizeof(double)), calloc(built->graph.graph.count, sizeof(double))};
    assert_true(sample.symbols && sample.numbers);
    for (size_t s = 0; s < count; s++) sample.symbols[s] = check_uniform(&m->seed, 0.3, 1.7);
    yk_ring_complete(m->d->ring, sample.symbols); // pi / 9
    for (size_t s = 0; s < built->graph.symbol_count; s++)
        if (built->graph.leaf[s] != YK_NONE) sample.numbers[built->graph.leaf[s]] = sample.symbols[s];
    graph_evaluate(&built->graph.graph, sample.numbers);
    complete(m, built, &sample);
    return sample;
}

static size_t entries_seen;

static void check_entry(Machine *m, YkRef value, const Sample *sample, const YkPoisson *expanded, const char *name)
{
    double got = sample->numbers[value];
    double wanted = yk_ring_value(m->d->ring, expanded, sample->symbols).x;
    entries_seen++;
    if (fabs(got - wanted) <= 1e-12 * fmax(10, fabs(wanted))) return;
    print_error("%s: %.17g, expanded %.17g\n", name, got, wanted);
    fail();
}

static void compare_row(Machine *m, const Built *built, const Sample *sample, size_t i, const char *name)
{
    YkRing *ring = m->d->ring;
    const YkDeriveForces *f = forces_of(m);
    size_t n = m->d->tree_count;
    const YkPoisson *left = yk_derive_in_joints(m->d, yk_derive_lagrange_of(f, i).left);
    for (size_t k = 0; k < n; k++) {
        int32_t acceleration = m->d->coordinates[k].acceleration;
        const YkPoisson *entry = yk_ring_coefficient(ring, left, acceleration, 1);
        check_entry(m, built->M[i * n + k], sample, entry, name);
        left = yk_ring_coefficient(ring, left, acceleration, 0);
    }
    const YkDeriveMultipliers *multipliers = yk_derive_multipliers(f);
    for (size_t r = 0; r < multipliers->count; r++) left = yk_ring_coefficient(ring, left, multipliers->symbols[r], 0);
    check_entry(m, built->h[i], sample, left, name);
}

static void compare(Machine *m, const char *name)
{
    Built built = build(m);
    for (int round = 0; round < 3; round++) {
        Sample sample = take_sample(m, &built);
        for (size_t i = 0; i < m->d->tree_count; i++) compare_row(m, &built, &sample, i, name);
        free(sample.symbols);
        free(sample.numbers);
    }
    built_end(&built);
}

static void the_short_way_gives_the_expanded_equations(void **state)
{
    (void)state;
    for (size_t e = 0; e < PROVED_EXAMPLES; e++) {
        Machine m = example(proved_examples[e]);
        compare(&m, proved_examples[e]);
        machine_end(&m);
    }
    assert_true(entries_seen > 500);
}

// A tree with branches, joints against the tree's direction, a weld and slides on turning bodies.
static void branches_and_backward_joints(void **state)
{
    (void)state;
    Machine m =
        machine_of("parameters: {l: 0.3 m, g: 9.81}\ngravity: [0, -g]\nbodies:\n"
                   "  ground: {points: {O: [0, 0]}}\n"
                   "  a: {points: {O: [0, 0], P: [l, 0], Q: [0, l]}, mass: 1, center: [0.1, 0.02], inertia: 0.1}\n"
                   "  b: {points: {P: [0, 0], R: [l, 0]}, mass: 2, center: [0.2, 0], inertia: 0.2}\n"
                   "  c: {points: {Q: [0, 0], S: [l, 0]}, mass: 3, center: [0.1, 0.1], inertia: 0.3}\n"
                   "  d: {points: {R: [0, 0]}, mass: 4, center: [0.05, 0.1], inertia: 0.4}\n"
                   "  e: {points: {S: [0, 0], T: [l, l]}, mass: 5, center: [0.1, 0.3], inertia: 0.5}\n"
                   "  f: {points: {T: [0, 0]}, mass: 6, center: [0.3, 0.3], inertia: 0.6}\n"
                   "joints:\n  O: {pin: [ground, a], angle: q1}\n  P: {pin: [b, a], angle: q2}\n"
                   "  Q: {pin: [a, c], angle: q3}\n  R: {slide: [b, d], along: x, distance: s, turned: 20 deg}\n"
                   "  S: {weld: [e, c], turned: 35 deg, at: S}\n  T: {pin: [f, e], angle: q4}\n");
    assert_true(m.d->tree_count == 5);
    compare(&m, "branches");
    machine_end(&m);
}

// Eight links, all dimensions different: 452 operations, 16 of them sines and cosines (at most 500 were asked for).
static void eight_links_take_less_than_500_operations(void **state)
{
    (void)state;
    YkText file = {0};
    yk_text_puts(&file, "parameters: {g: 9.81");
    for (int k = 1; k <= 8; k++)
        yk_text_format(&file, ", l%d: 0.%d, c%d: 0.0%d, m%d: %d, I%d: 0.%d", k, k, k, k, k, k, k, k);
    yk_text_puts(&file, "}\ngravity: [0, -g]\nbodies:\n  ground: {points: {P1: [0, 0]}}\n");
    for (int k = 1; k <= 8; k++)
        yk_text_format(&file,
                       "  b%d: {points: {P%d: [0, 0], P%d: [l%d, 0]}, mass: m%d, center: [c%d, 0], inertia: I%d}\n", k,
                       k, k + 1, k, k, k, k);
    yk_text_puts(&file, "joints:\n  P1: {pin: [ground, b1], angle: q1}\n");
    for (int k = 2; k <= 8; k++) yk_text_format(&file, "  P%d: {pin: [b%d, b%d], angle: q%d}\n", k, k - 1, k, k);
    Machine m = machine_of(yk_text_get(&file));
    Built built = build(&m);
    size_t count = yk_graph_cost(&built.graph.graph, built.roots, 8 * 8 + 8);
    assert_true(count <= 460);
    compare(&m, "eight links");
    built_end(&built);
    machine_end(&m);
    yk_text_free(&file);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_short_way_gives_the_expanded_equations),
                                       cmocka_unit_test(branches_and_backward_joints),
                                       cmocka_unit_test(eight_links_take_less_than_500_operations)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
