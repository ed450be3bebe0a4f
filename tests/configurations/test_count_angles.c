// The count against published numbers, against a second way to it, and against what monodromy finds.
#include "configurations/count.h"
#include "configurations/generic.h"
#include "configurations/random_group.h"
#include "configurations/truss.h"
#include "solve/state.h"

// The group of a machine's last block at its inputs, as a system.
typedef struct Group {
    YkShape shape;
    YkVec coefficients[2 * YK_SYSTEM_LOOPS_MAX * (2 * YK_SYSTEM_LOOPS_MAX + 1)];
} Group;

static Group group_of(Machine *m)
{
    Group g;
    size_t block = m->mech->block_count;
    YkRun run = yk_state_run(m->state, &m->state->spare);
    while (m->mech->blocks[--block].kind != YK_BLOCK_GROUP) assert_true(block > 0);
    yk_run_begin(&run);
    for (size_t k = 0; k < m->mech->step_count; k++) {
        const YkStep *step = &m->mech->steps[k];
        if (step->kind == YK_STEP_BLOCK && step->target == (int32_t)block) break;
        yk_run_steps(&run, k, k + 1);
    }
    assert_int_equal(yk_shape_read(&g.shape, m->mech, block), YK_OUTSIDE_NOT);
    yk_coefficients_read(&g.shape, &run, block, g.coefficients);
    return g;
}

typedef struct Counts {
    size_t angles, cones; // cones: 0 where there are too many
    bool counted;
} Counts;

static Counts counts_of(const Group *g)
{
    YkMatroid matroid;
    Counts c = {0};
    assert_int_equal(yk_matroid_make(&matroid, &g->shape, g->coefficients), YK_MATROID_MADE);
    assert_int_equal(yk_count_angles(&matroid, NULL, &c.angles), YK_COUNTED);
    if (g->shape.loops <= 5) assert_int_equal(yk_count_cones(&matroid, &g->shape, NULL, &c.cones), YK_COUNTED);
    yk_matroid_free(&matroid);
    return c;
}

static Counts counts_of_truss(const char *links, uint64_t seed)
{
    Truss truss = {.links = links};
    truss_scatter(&truss, seed);
    Machine m = truss_machine(&truss);
    Group g = group_of(&m);
    machine_free(&m);
    return counts_of(&g);
}

typedef struct Published {
    const char *links;
    size_t count;
} Published;

// The triad, the three trusses of seven links, and Watt-Baranov trusses of nine, eleven and thirteen:
// 2^(loops + 1) - 2.
// Sources: Rojas & Thomas 2012 (closed-form position analysis of Watt-Baranov trusses); Wampler 2001.
static const Published published[] = {{"abc ad be cf def", 6},
                                      {"cef egh agi bdh ab cd fi", 14},
                                      {"acd cef bfi ghi ab dg eh", 16},
                                      {"bfhi cde adg ab cf gh ei", 18},
                                      {"adk abeh bcg cd efj fg hil ij kl", 30},
                                      {"adn abehk bcg cd efj fg him ij klo lm no", 62},
                                      {"adq abehkn bcg cd efj fg him ij klp lm nor op qr", 126}};

static void test_counts_are_those_published(void **unused)
{
    (void)unused;
    for (size_t k = 0; k < sizeof published / sizeof *published; k++)
        assert_int_equal(counts_of_truss(published[k].links, 5 + k).angles, published[k].count);
}

// Twenty-eight trusses of nine links, up to isomorphism, with the numbers of their configurations.
static const Published nine_links[] = {
#include "configurations/nine_links.h"
};

static void test_the_trusses_of_nine_links_have_thirty_to_fifty_eight(void **unused)
{
    (void)unused;
    size_t how_many = sizeof nine_links / sizeof *nine_links;
    assert_int_equal(how_many, 28);
    for (size_t k = 0; k < how_many; k++) {
        size_t count = counts_of_truss(nine_links[k].links, 40 + k).angles;
        if (count != nine_links[k].count) print_error("%s\n", nine_links[k].links);
        assert_int_equal(count, nine_links[k].count);
    }
}

// Deletion and contraction, and the intersection of cones: two algorithms with nothing in common but the matroid.
static void test_two_ways_of_counting_agree(void **unused)
{
    (void)unused;
    for (uint64_t seed = 1; seed <= 6; seed++)
        for (size_t k = 0; k < (seed == 1 ? 6 : 5); k++) {
            Counts c = counts_of_truss(published[k].links, seed);
            assert_int_equal(c.cones, c.angles);
        }
}

// A platform similar to the triangle of its pins on the ground has two configurations fewer than a generic one.
static void test_special_dimensions_count_less(void **unused)
{
    (void)unused;
    Truss truss = {.links = "abc ad be cf def"};
    truss_scatter(&truss, 3);
    truss_make_similar(&truss);
    Machine m = truss_machine(&truss);
    Group g = group_of(&m);
    Counts c = counts_of(&g);
    assert_int_equal(c.angles, 4);
    assert_int_equal(c.cones, 4);
    machine_free(&m);
}

// At a generic system as many solutions are found as counted, and without being told how many, no more.
static void test_monodromy_finds_as_many_as_are_counted(void **unused)
{
    (void)unused;
    check_without_sanitizers();
    for (size_t k = 0; k < 5; k++) {
        Truss truss = {.links = published[k].links};
        truss_scatter(&truss, 11 + k);
        Machine m = truss_machine(&truss);
        Group g = group_of(&m);
        YkGeneric generic;
        yk_generic_make(&generic, &g.shape, g.coefficients, 0, NULL);
        assert_int_equal(generic.count, published[k].count);
        yk_generic_free(&generic);
        machine_free(&m);
    }
}

// Groups of up to four loops with slides and slots: monodromy, which is not told how many there are, finds as many as
// the cones count.
static void test_groups_with_slides_have_as_many_as_monodromy_finds(void **unused)
{
    (void)unused;
    size_t wanted = check_cases(8), found[5] = {0};
    for (uint64_t seed = 1; found[4] < wanted; seed++) {
        size_t loops = 2 + seed % 3;
        Machine m = random_group_machine(loops, 104729 * seed);
        if (found[loops] < wanted && random_group_is_one(&m, loops)) {
            Group g = group_of(&m);
            YkMatroid matroid;
            YkGeneric generic;
            size_t count;
            if (g.shape.angles < g.shape.unknowns) {
                assert_int_equal(yk_matroid_make(&matroid, &g.shape, g.coefficients), YK_MATROID_MADE);
                assert_int_equal(yk_count_cones(&matroid, &g.shape, NULL, &count), YK_COUNTED);
                yk_generic_make(&generic, &g.shape, g.coefficients, 0, NULL);
                if (generic.count != count) print_error("seed %d\n", (int)seed);
                assert_int_equal(generic.count, count);
                yk_matroid_free(&matroid);
                yk_generic_free(&generic);
                found[loops]++;
            }
        }
        machine_free(&m);
    }
    assert_true(found[2] > 0 && found[3] > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_counts_are_those_published),
        cmocka_unit_test(test_the_trusses_of_nine_links_have_thirty_to_fifty_eight),
        cmocka_unit_test(test_two_ways_of_counting_agree),
        cmocka_unit_test(test_special_dimensions_count_less),
        cmocka_unit_test(test_monodromy_finds_as_many_as_are_counted),
        cmocka_unit_test(test_groups_with_slides_have_as_many_as_monodromy_finds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
