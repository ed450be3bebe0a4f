// Continua: movable mechanisms that were published, structures that are shaky and no more, and what solving says of
// them.
#include "configurations/continuum_inside.h"
#include "compile/mechanism.h"
#include "configurations/random_group.h"

// A bipartite linkage K(p, q): a bar from every point A_i to every point B_j; the one from A_0 to B_0 is the ground.
// Bars are not turned where the points are those given.
static Machine bipartite(size_t p, const YkVec *A, size_t q, const YkVec *B)
{
    YkBuilder *b = yk_builder_new("bipartite");
    Machine m = {.problems = yk_problems_new()};
    char bar[16], other[16], joint[16], point[2][8];
    for (size_t i = 0; i < p; i++)
        for (size_t j = 0; j < q; j++) {
            snprintf(bar, sizeof bar, i + j == 0 ? "ground" : "bar%zu%zu", i, j);
            snprintf(point[0], sizeof *point, "A%zu", i);
            snprintf(point[1], sizeof *point, "B%zu", j);
            if (i + j > 0) yk_builder_body(b, bar);
            yk_builder_point(b, bar, point[0], A[i].x, A[i].y);
            yk_builder_point(b, bar, point[1], B[j].x, B[j].y);
            for (int end = 0; end < 2; end++) { // pinned to the first bar at either end
                if ((end == 0 ? j : i) == 0) continue;
                size_t first_i = end == 0 ? i : 0, first_j = end == 0 ? 0 : j;
                snprintf(other, sizeof other, first_i + first_j == 0 ? "ground" : "bar%zu%zu", first_i, first_j);
                snprintf(joint, sizeof joint, "%c%zu%zu", end == 0 ? 'P' : 'Q', i, j);
                yk_builder_pin(b, joint, other, bar, point[end], NULL);
            }
        }
    m.model = yk_builder_model(b, NULL, m.problems);
    machine_compile(&m, NULL);
    assert_true(yk_state_assemble(m.state) >= 0);
    yk_builder_free(b);
    return m;
}

// The continuum through the start of a machine whose inputs are let go.
static YkContinuum continuum_of(Machine *m, size_t *kernel)
{
    YkMechanism freed = *m->mech;
    YkContinua continua;
    YkContinuum found;
    bool is_new;
    freed.input_count = 0;
    assert_true(yk_continua_start(&continua, &freed));
    assert_true(yk_continuum_at(&continua, m->state, &found, &is_new));
    assert_true(is_new);
    assert_true(found.dimension == 0 || found.miss < 1e-12);
    *kernel = yk_continuum_kernel(&continua, continua.x0);
    yk_continua_end(&continua);
    machine_free(m);
    return found;
}

static void assert_continuum(Machine m, size_t dimension, size_t at_least)
{
    size_t kernel;
    YkContinuum c = continuum_of(&m, &kernel);
    assert_int_equal(kernel, dimension);
    assert_int_equal(c.dimension, dimension);
    assert_int_equal(c.at_least, at_least);
    if (dimension > 0) assert_int_equal(c.at_most, dimension);
}

// Dixon 1899: K(3, 3) moves where the A lie on a line and the B on one at right angles, and K(4, 4) where both are
// rectangles with the same axes; neither because of any bars that stay parallel. Other points make a rigid structure.
static void test_the_mechanisms_of_dixon_move(void **unused)
{
    (void)unused;
    YkVec on_x[3] = {{1, 0}, {1.7, 0}, {-0.6, 0}}, on_y[3] = {{0, 0.8}, {0, -1.1}, {0, 1.9}};
    YkVec wide[4] = {{2, 0.5}, {-2, 0.5}, {-2, -0.5}, {2, -0.5}},
          high[4] = {{0.7, 1.6}, {-0.7, 1.6}, {-0.7, -1.6}, {0.7, -1.6}};
    assert_continuum(bipartite(3, on_x, 3, on_y), 1, 0);
    assert_continuum(bipartite(4, wide, 4, high), 1, 0);
    on_y[2].x = 0.3;
    assert_continuum(bipartite(3, on_x, 3, on_y), 0, 0);
    high[1].y = 1.5;
    assert_continuum(bipartite(4, wide, 4, high), 0, 0);
}

// K(3, 3) with its six points on a conic is shaky (Whiteley 1984), and does not move.
static void test_a_shaky_structure_does_not_move(void **unused)
{
    (void)unused;
    YkVec A[3], B[3];
    for (int k = 0; k < 3; k++) {
        A[k] = yk_unit(0.3 + 1.9 * k);
        B[k] = yk_unit(1.1 + 2.2 * k);
    }
    Machine m = bipartite(3, A, 3, B);
    size_t kernel;
    YkContinuum c = continuum_of(&m, &kernel);
    assert_int_equal(kernel, 1);
    assert_int_equal(c.dimension, 0);
}

// A four-bar, and open chains of three and four bars: Gruebler's count, proved from below too.
static void test_linkages_with_freedoms_are_continua_of_that_dimension(void **unused)
{
    (void)unused;
    YkVec A[2] = {{0, 0}, {2, 1}}, B[4] = {{1, 0.3}, {0.2, 1.4}, {2.6, -0.8}, {1.5, 1.9}};
    assert_continuum(bipartite(2, A, 2, B), 1, 1);
    assert_continuum(bipartite(1, A, 3, B), 2, 2);
    assert_continuum(bipartite(1, A, 4, B), 3, 3);
}

// Three equal cranks of a platform congruent to its base: the machine of a continuum beside two poses. The platform
// turned by 2 asin(l / 2 rho) about the circumcentre of the base, whose radius is rho, has pins at the same distance l
// from their places.
static Machine congruent_platform(double length)
{
    static const YkVec pin[3] = {{0, 0}, {2, 0}, {0.7, 1.1}};
    static const char *const legs[] = {"a", "b", "c"}, *const low[] = {"A", "B", "C"}, *const high[] = {"D", "E", "F"};
    double y = (0.7 * 0.7 + 1.1 * 1.1 - 2 * 0.7) / (2 * 1.1);
    YkVec centre = yk_vec(1, y), turn = yk_unit(2 * yk_asin(length / (2 * yk_norm(centre))));
    YkBuilder *b = yk_builder_new("platform");
    Machine m = {.problems = yk_problems_new()};
    yk_builder_body(b, "p");
    for (int k = 0; k < 3; k++) { // all bodies are at the angle of the start: points are those of the turned platform
        YkVec to = yk_add(centre, yk_mul(turn, yk_sub(pin[k], centre)));
        yk_builder_body(b, legs[k]);
        yk_builder_point(b, "ground", low[k], pin[k].x, pin[k].y);
        yk_builder_point(b, legs[k], low[k], pin[k].x, pin[k].y);
        yk_builder_point(b, legs[k], high[k], to.x, to.y);
        yk_builder_point(b, "p", high[k], to.x, to.y);
        yk_builder_pin(b, low[k], "ground", legs[k], low[k], NULL);
        yk_builder_pin(b, high[k], legs[k], "p", high[k], NULL);
    }
    m.model = yk_builder_model(b, NULL, m.problems);
    machine_compile(&m, NULL);
    assert_true(yk_state_assemble(m.state) >= 0);
    yk_builder_free(b);
    return m;
}

static bool count_one(void *context, YkState *state)
{
    (void)state;
    ++*(size_t *)context;
    return true;
}

typedef struct Seen {
    const YkConfigurations *all;
    size_t count, continua, dimension;
} Seen;

static bool look(void *context, YkState *state)
{
    Seen *seen = context;
    const YkContinuum *c = yk_configurations_continuum(seen->all);
    (void)state;
    seen->count++;
    seen->continua += c != NULL;
    if (c) seen->dimension = c->dimension;
    return true;
}

static Seen enumerate(Machine *m, YkConfigurationsReport *report)
{
    YkConfigurations *all = yk_configurations_new(m->mech);
    Seen seen = {.all = all};
    assert_int_equal(yk_configurations_each(all, m->state, NULL, look, &seen, report), YK_OK);
    assert_null(yk_configurations_continuum(all));
    yk_configurations_free(all);
    return seen;
}

static void test_a_continuum_is_shown_once_beside_isolated_poses(void **unused)
{
    (void)unused;
    for (int k = 0; k < 3; k++) {
        Machine m = congruent_platform(0.6 + 0.3 * k);
        YkConfigurationsReport report;
        Seen seen = enumerate(&m, &report);
        assert_int_equal(seen.count, 3);
        assert_int_equal(seen.continua, 1);
        assert_int_equal(seen.dimension, 1);
        assert_false(report.complete);
        assert_int_equal(report.continua, 1);
        assert_int_equal(report.continuum.at_least, 1); // the legs stay parallel
        assert_int_equal(report.continuum.at_most, 1);
        assert_non_null(strstr(report.message, "one of them stands for a continuum of dimension 1, proved"));
        assert_non_null(strstr(report.message, "proved not to close it, but within 1.2 deg of singular poses"));
        machine_free(&m);
    }
}

// A rhombus folded together: the ends of its crank and of its frame meet, and the dyad turns about them. All but folded
// it has two poses, in which the dyad points to opposite sides, at a transmission angle of 1.7e-8 rad or more.
static void test_a_dyad_that_turns_freely_is_a_continuum(void **unused)
{
    (void)unused;
    static const char *const rhombus = "bodies:\n"
                                       "  ground: {points: {A: [0, 0], B: [1, 0]}}\n"
                                       "  a: {points: {A: [0, 0], D: [1, 0]}}\n"
                                       "  b: {points: {B: [0, 0], E: [1, 0], G: [0.5, 0.2]}}\n"
                                       "  p: {points: {D: [0, 0], E: [1, 0]}}\n"
                                       "joints:\n"
                                       "  A: {pin: [ground, a], angle: ta}\n"
                                       "  B: {pin: [ground, b], angle: tb}\n"
                                       "  D: {pin: [a, p]}\n"
                                       "  E: {pin: [b, p]}\n"
                                       "drives: {ta: %s}\n"
                                       "start: {tb: 50 deg}\n";
    char text[1024];
    YkConfigurationsReport report;
    for (int k = 0; k < 4; k++) {
        static const char *const angles[] = {"0 deg", "1 deg", "1e-6 deg", "5e-6 deg"};
        snprintf(text, sizeof text, rhombus, angles[k]);
        Machine m = machine_parse(text, true);
        Seen seen = enumerate(&m, &report);
        assert_int_equal(seen.count, k == 0 ? 1 : 2);
        assert_int_equal(seen.continua, k == 0 ? 1 : 0);
        assert_int_equal(report.complete, k > 0);
        if (k == 0) assert_int_equal(report.continuum.at_least, 1);
        bool is_complete;
        size_t count = 0;
        assert_int_equal(yk_state_each(m.state, count_one, &count, &is_complete), YK_OK);
        assert_int_equal(is_complete, k > 0);
        machine_free(&m);
    }
}

// Five bodies joined by pins and pin-slots at whole coordinates, one equation of which repeats others at the start.
// With its input held it has one pose, as Gauss and Newton's method from 100 random starts on the coordinates of all
// bodies finds (a program of its own, on another formulation).
static void test_groups_that_repeat_equations_are_excluded(void **unused)
{
    (void)unused;
    static const char *const text = "bodies:\n"
                                    "  ground: {points: {j0: [-2, -2], j1: [-2, 1], j4: [-1, 0]}}\n"
                                    "  b1: {points: {j0: [-2, -2], j3: [2, 2], j6: [1, -2]}}\n"
                                    "  b2: {points: {j1: [-2, 1], j2: [1, 2], j5: [0, 1]}}\n"
                                    "  b3: {points: {j2to: [2, 2], j6: [1, -2]}}\n"
                                    "  b4: {points: {j3: [2, 2], j4to: [-1, 1], j5: [0, 1]}}\n"
                                    "joints:\n"
                                    "  j0: {pin: [ground, b1]}\n"
                                    "  j1: {pin: [ground, b2]}\n"
                                    "  j2: {pin-slot: [b2, b3], along: x, from: j2, at: j2to, distance: d2}\n"
                                    "  j3: {pin: [b1, b4]}\n"
                                    "  j4: {pin-slot: [ground, b4], along: y, from: j4, at: j4to, distance: d4}\n"
                                    "  j5: {pin: [b4, b2]}\n"
                                    "  j6: {pin: [b1, b3]}\n"
                                    "start: {d2: 1, d4: 1}\n";
    Machine m = machine_parse(text, true);
    YkConfigurationsReport report;
    assert_int_equal(yk_input_count(m.mech), 1);
    assert_true(m.mech->blocks[0].kind == YK_BLOCK_GROUP && m.mech->blocks[0].column_count == 5);
    Seen seen = enumerate(&m, &report);
    assert_int_equal(seen.count, 1);
    assert_int_equal(seen.continua, 0);
    assert_true(report.complete);
    assert_int_equal(report.reason, YK_COMPLETE_BY_EXCLUSION);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_mechanisms_of_dixon_move),
        cmocka_unit_test(test_a_shaky_structure_does_not_move),
        cmocka_unit_test(test_linkages_with_freedoms_are_continua_of_that_dimension),
        cmocka_unit_test(test_a_continuum_is_shown_once_beside_isolated_poses),
        cmocka_unit_test(test_groups_that_repeat_equations_are_excluded),
        cmocka_unit_test(test_a_dyad_that_turns_freely_is_a_continuum),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
