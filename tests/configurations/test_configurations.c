// Every configuration: the one a machine was built from is among them, none is missing, none is there twice.
#include "configurations/slides.h"
#include "configurations/truss.h"

enum { FOUND_MAX = 128, COORDINATES_MAX = 40 };

typedef struct Found {
    double q[FOUND_MAX][COORDINATES_MAX];
    int signs;
    size_t count, coordinates;
} Found;

static bool gather(void *context, YkState *state)
{
    Found *f = context;
    YkResiduals r = yk_state_residuals(state);
    assert_true(f->count < FOUND_MAX);
    assert_true(r.position <= 1e-12);
    f->coordinates = yk_coordinate_count(yk_state_mechanism(state));
    assert_true(f->coordinates <= COORDINATES_MAX);
    for (size_t k = 0; k < f->coordinates; k++) f->q[f->count][k] = yk_state_coordinate(state, k).position;
    for (size_t b = 0; b < yk_block_count(yk_state_mechanism(state)); b++) f->signs += yk_state_branch(state, b);
    f->count++;
    return true;
}

static bool same(const Machine *m, const double *a, const double *b)
{
    for (size_t k = 0; k < yk_coordinate_count(m->mech); k++) {
        double off = a[k] - b[k];
        if (!yk_coordinate_info(m->mech, k).is_distance) off = yk_nearest_turn(off, 0);
        if (fabs(off) > 1e-6) return false;
    }
    return true;
}

static bool holds(const Machine *m, const Found *f, const double *q)
{
    for (size_t k = 0; k < f->count; k++)
        if (same(m, f->q[k], q)) return true;
    return false;
}

static YkConfigurationsReport enumerate(Machine *m, bool in_search_order, Found *f)
{
    YkConfigurations *all = yk_configurations_new(m->mech);
    YkConfigurationsOptions options = yk_default_configurations_options();
    YkConfigurationsReport report;
    options.in_search_order = in_search_order;
    *f = (Found){.count = 0};
    assert_non_null(all);
    assert_true(yk_configurations_each(all, m->state, &options, gather, f, &report) >= 0);
    assert_int_equal(report.count, f->count);
    yk_configurations_free(all);
    return report;
}

// Checks a machine of one group whose dimensions come from the configuration with these coordinates: q[k] = 0 for
// angles, and distances of any value.
static void check_whole(Machine *m, const char *what, uint64_t seed)
{
    Found f, searched = {.count = 0};
    YkConfigurationsReport r = enumerate(m, false, &f);
    if (!r.complete || r.proved != r.expected) print_error("%s, seed %d: %s\n", what, (int)seed, r.message);
    assert_true(r.complete);
    assert_int_equal(r.reason, YK_COMPLETE_BY_COUNT);
    assert_true(f.count <= r.expected && f.count % 2 == r.expected % 2); // the others are pairs of conjugates
    assert_int_equal(f.signs, 0);                                        // regular solutions of a closed family
    for (size_t k = 0; k < f.count; k++)
        for (size_t j = 0; j < k; j++) assert_false(same(m, f.q[j], f.q[k]));
    yk_state_each(m->state, gather, &searched, NULL); // by Newton's method from many starts: nothing that is not here
    for (size_t k = 0; k < searched.count; k++) assert_true(holds(m, &f, searched.q[k]));
    assert_true(searched.count > 0);
}

static void test_a_truss_has_the_configuration_it_was_built_from(void **unused)
{
    (void)unused;
    static const char *const links[] = {"abc ad be cf def", "cef egh agi bdh ab cd fi", "acd cef bfi ghi ab dg eh",
                                        "bfhi cde adg ab cf gh ei", "adk abeh bcg cd efj fg hil ij kl"};
    const double zero[COORDINATES_MAX] = {0};
    for (size_t k = 0; k < sizeof links / sizeof *links; k++)
        for (uint64_t seed = 1; seed <= 4; seed++) {
            Truss truss = {.links = links[k]};
            Found f;
            truss_scatter(&truss, seed);
            Machine m = truss_machine(&truss);
            check_whole(&m, links[k], seed);
            enumerate(&m, false, &f);
            assert_true(holds(&m, &f, zero));
            machine_free(&m);
        }
}

// 2 for three lines of the ground, 4 for two, 6 otherwise; a platform that slides on two legs turns with both: 4.
static void test_platforms_with_slides_are_whole(void **unused)
{
    (void)unused;
    static const struct {
        const char *legs;
        size_t count;
    } platforms[] = {{"RRR", 6}, {"RRP", 6}, {"RPP", 4}, {"PPP", 2}, {"RRS", 6}, {"RPS", 6}, {"PPS", 4}, {"RSS", 4}};
    for (size_t k = 0; k < sizeof platforms / sizeof *platforms; k++)
        for (uint64_t seed = 1; seed <= 4; seed++) {
            Machine m = platform_machine(platforms[k].legs, seed);
            Found f;
            check_whole(&m, platforms[k].legs, seed);
            assert_int_equal(enumerate(&m, false, &f).expected, platforms[k].count);
            bool has_own = false; // all angles zero
            for (size_t s = 0; s < f.count; s++) {
                bool is_own = true;
                for (size_t c = 0; c < f.coordinates; c++)
                    is_own &= yk_coordinate_info(m.mech, c).is_distance || fabs(yk_nearest_turn(f.q[s][c], 0)) < 1e-6;
                has_own |= is_own;
            }
            assert_true(has_own);
            machine_free(&m);
        }
}

// Laman's three-prism as a platform with these lengths has all of its 24 configurations real.
// Source: the count of the three-prism, 24, Capco et al. 2018; the lengths are ours.
static const char prism[] = "bodies:\n"
                            "  ground: {points: {a: [0, 0], b: [2, 0]}}\n"
                            "  ac: {points: {a: [0, 0], c: [2, 0]}}\n"
                            "  bc: {points: {b: [0, 0], c: [2, 0]}}\n"
                            "  ad: {points: {a: [0, 0], d: [1.75, 0]}}\n"
                            "  cf: {points: {c: [0, 0], f: [2.7, 0]}}\n"
                            "  be: {points: {b: [0, 0], e: [1.97, 0]}}\n"
                            "  de: {points: {d: [0, 0], e: [2.2, 0]}}\n"
                            "  df: {points: {d: [0, 0], f: [2.9, 0]}}\n"
                            "  ef: {points: {e: [0, 0], f: [2.15, 0]}}\n"
                            "joints:\n"
                            "  A: {pin: [ground, ac], at: a}\n"
                            "  A2: {pin: [ground, ad], at: a}\n"
                            "  B: {pin: [ground, bc], at: b}\n"
                            "  B2: {pin: [ground, be], at: b}\n"
                            "  C: {pin: [ac, bc], at: c}\n"
                            "  C2: {pin: [ac, cf], at: c}\n"
                            "  D: {pin: [ad, de], at: d}\n"
                            "  D2: {pin: [ad, df], at: d}\n"
                            "  E: {pin: [be, de], at: e}\n"
                            "  E2: {pin: [be, ef], at: e}\n"
                            "  F: {pin: [cf, df], at: f}\n"
                            "  F2: {pin: [cf, ef], at: f}\n";

static void test_the_prism_has_twenty_four_real_configurations(void **unused)
{
    (void)unused;
    Machine m = machine_parse_with(prism, NULL, 0);
    Found f, sorted;
    YkConfigurationsReport r = enumerate(&m, true, &f);
    assert_true(r.complete);
    assert_int_equal(f.count, 24);
    assert_int_equal(r.proved, 12); // of the group, on each branch of its dyad
    enumerate(&m, false, &sorted);
    assert_int_equal(sorted.count, 24);
    for (size_t k = 0; k < 24; k++) assert_true(holds(&m, &sorted, f.q[k]));
    machine_free(&m);
}

// --- an independent way: sweep one bar of a triad, close the others in closed form, and look for changes of sign

typedef struct Vec2 {
    double x, y;
} Vec2;

static double length(Vec2 a, Vec2 b)
{
    return hypot(a.x - b.x, a.y - b.y);
}

// Returns the miss of the third bar, given the angle of the first and the branch of the dyad; NAN if it does not close.
// Ground pins a b c, platform d e f, bars ad be cf. d moves on its circle; e is at distance |de| from d and |be| from
// b.
static double miss(const Truss *t, double angle, int branch)
{
    Vec2 p[6];
    for (int k = 0; k < 6; k++) p[k] = (Vec2){t->x[k], t->y[k]};
    double ad = length(p[0], p[3]), be = length(p[1], p[4]), de = length(p[3], p[4]), cf = length(p[2], p[5]);
    Vec2 d = {p[0].x + ad * cos(angle), p[0].y + ad * sin(angle)};
    double base = length(d, p[1]), along = (base * base + de * de - be * be) / (2 * base), h2 = de * de - along * along;
    if (h2 < 0) return NAN;
    double ux = (p[1].x - d.x) / base, uy = (p[1].y - d.y) / base, h = branch * sqrt(h2);
    Vec2 e = {d.x + along * ux - h * uy, d.y + along * uy + h * ux};
    // f from d and e as in the platform's own shape
    double wx = ((p[5].x - p[3].x) * (p[4].x - p[3].x) + (p[5].y - p[3].y) * (p[4].y - p[3].y)) / (de * de);
    double wy = ((p[5].y - p[3].y) * (p[4].x - p[3].x) - (p[5].x - p[3].x) * (p[4].y - p[3].y)) / (de * de);
    Vec2 f = {d.x + wx * (e.x - d.x) - wy * (e.y - d.y), d.y + wx * (e.y - d.y) + wy * (e.x - d.x)};
    return length(f, p[2]) - cf;
}

// Counts changes of sign over the circle on both branches. Where a branch ends the two join, so that the end is a
// neighbour of itself on the other branch.
static size_t count_by_sweeping(const Truss *t)
{
    enum { SAMPLES = 40000 };
    size_t count = 0;
    for (int k = 0; k < SAMPLES; k++) {
        double angle = 2 * YK_PI * k / SAMPLES, next = 2 * YK_PI * (k + 1) / SAMPLES, at[2][2];
        for (int branch = 0; branch < 2; branch++) {
            at[branch][0] = miss(t, angle, 2 * branch - 1);
            at[branch][1] = miss(t, next, 2 * branch - 1);
            count += !isnan(at[branch][0]) && !isnan(at[branch][1]) && (at[branch][0] < 0) != (at[branch][1] < 0);
        }
        int side = isnan(at[0][0]) ? 1 : 0; // the branches end within this step
        if (isnan(at[0][0]) != isnan(at[0][1])) count += (at[0][side] < 0) != (at[1][side] < 0);
    }
    return count;
}

static void test_triads_have_as_many_as_a_sweep_finds(void **unused)
{
    (void)unused;
    check_without_sanitizers();
    size_t histogram[7] = {0};
    for (uint64_t seed = 1; seed <= 80; seed++) {
        Truss truss = {.links = "abc ad be cf def"};
        Found f;
        truss_scatter(&truss, seed);
        if (seed % 10 == 0) truss_make_similar(&truss); // special, with four complex configurations
        Machine m = truss_machine(&truss);
        YkConfigurationsReport r = enumerate(&m, false, &f);
        assert_true(r.complete);
        assert_int_equal(r.expected, seed % 10 == 0 ? 4 : 6);
        size_t swept = count_by_sweeping(&truss);
        if (swept != f.count) print_error("seed %d: %zu, a sweep finds %zu\n", (int)seed, f.count, swept);
        assert_int_equal(f.count, swept);
        histogram[f.count]++;
        machine_free(&m);
    }
    assert_true(histogram[2] > 0 && histogram[4] > 0 && histogram[6] > 0);
}

// --- what is not complete says so

static void test_at_a_dead_point_it_is_not_complete(void **unused)
{
    (void)unused;
    // The lines of all three bars meet in one point: the configuration is a double root.
    Truss truss = {.links = "abc ad be cf def", .x = {2, -2, 0.3, 1, -1.2, 0.06}, .y = {1, 1.5, -2, 0.5, 0.9, -0.4}};
    Machine m = truss_machine(&truss);
    YkConfigurations *all = yk_configurations_new(m.mech);
    YkConfigurationsReport r;
    yk_configurations_each(all, m.state, NULL, NULL, NULL, &r);
    assert_false(r.complete);
    assert_int_equal(r.reason, YK_INCOMPLETE);
    assert_int_equal(r.expected, 6);
    assert_int_equal(r.proved, 4);
    yk_configurations_free(all);
    machine_free(&m);
}

static void test_no_assembly_is_proved(void **unused)
{
    (void)unused;
    Machine m = machine_load("stephenson-awkward");
    YkConfigurations *all = yk_configurations_new(m.mech);
    YkConfigurationsReport r;
    yk_state_set_input(m.state, 0, (YkMotion){0, 0, 0});
    assert_int_equal(yk_configurations_each(all, m.state, NULL, NULL, NULL, &r), YK_NO_ASSEMBLY);
    assert_true(r.complete);
    assert_int_equal(r.proved, 6);
    assert_int_equal(r.count, 0);
    yk_configurations_free(all);
    machine_free(&m);
}

static void test_dyads_are_complete_in_closed_form(void **unused)
{
    (void)unused;
    Machine m = machine_load("four-bar");
    Found f;
    YkConfigurationsReport r = enumerate(&m, false, &f);
    assert_true(r.complete);
    assert_int_equal(r.reason, YK_COMPLETE_BY_CLOSED_FORM);
    assert_int_equal(f.count, 2);
    machine_free(&m);
}

static void test_a_gear_in_a_group_is_excluded(void **unused)
{
    (void)unused;
    Machine m = machine_load("geared-five-bar");
    YkConfigurations *all = yk_configurations_new(m.mech);
    YkConfigurationsReport r;
    assert_int_equal(yk_configurations_each(all, m.state, NULL, NULL, NULL, &r), YK_OK);
    assert_true(r.complete);
    assert_int_equal(r.reason, YK_COMPLETE_BY_EXCLUSION);
    assert_int_equal(r.count, 10); // the search finds 4 of them
    yk_configurations_free(all);
    machine_free(&m);
}

// --- from pose to pose

static bool always(void *context, double part)
{
    (void)context;
    (void)part;
    return true;
}
static bool never(void *context, double part)
{
    (void)context;
    (void)part;
    return false;
}

static void test_warm_and_cold_find_the_same(void **unused)
{
    (void)unused;
    Machine m = machine_load("stephenson-awkward");
    YkConfigurations *warm = yk_configurations_new(m.mech);
    YkConfigurationsOptions watched = {false, {always, NULL}};
    for (double theta = 0; theta < 6.3; theta += 0.1) {
        Found a = {.count = 0}, b = {.count = 0};
        YkConfigurationsReport r;
        yk_state_set_input(m.state, 0, (YkMotion){theta, 1, 0});
        yk_configurations_each(warm, m.state, &watched, gather, &a, &r);
        assert_true(r.complete);
        YkConfigurations *cold = yk_configurations_new(m.mech);
        yk_configurations_each(cold, m.state, NULL, gather, &b, &r);
        assert_true(r.complete);
        assert_int_equal(a.count, b.count);
        for (size_t k = 0; k < a.count; k++) assert_true(same(&m, a.q[k], b.q[k]));
        assert_int_equal(a.signs, 0);
        yk_configurations_free(cold);
    }
    yk_configurations_free(warm);
    machine_free(&m);
}

static void test_once_it_is_enough_nothing_is_claimed(void **unused)
{
    (void)unused;
    Machine m = machine_load("double-butterfly");
    YkConfigurations *all = yk_configurations_new(m.mech);
    YkConfigurationsOptions options = {false, {never, NULL}};
    YkConfigurationsReport r;
    yk_configurations_each(all, m.state, &options, NULL, NULL, &r);
    assert_false(r.complete);
    yk_configurations_each(all, m.state, NULL, NULL, NULL, &r); // and can go on afterwards
    assert_true(r.complete);
    assert_int_equal(r.count, 8);
    yk_configurations_free(all);
    machine_free(&m);
}

typedef struct Nested {
    YkConfigurations *all;
    YkStatus status;
} Nested;

static bool call_again(void *context, YkState *state)
{
    Nested *nested = context;
    nested->status = yk_configurations_each(nested->all, state, NULL, NULL, NULL, NULL);
    return false;
}

static void test_wrong_calls_are_refused(void **unused)
{
    (void)unused;
    Machine m = machine_load("four-bar"), other = machine_load("stephenson-awkward");
    Nested nested = {yk_configurations_new(m.mech), YK_OK};
    assert_null(yk_configurations_new(NULL));
    assert_int_equal(yk_configurations_each(NULL, m.state, NULL, NULL, NULL, NULL), YK_BAD_ARGUMENT);
    assert_int_equal(yk_configurations_each(nested.all, NULL, NULL, NULL, NULL, NULL), YK_BAD_ARGUMENT);
    assert_int_equal(yk_configurations_each(nested.all, other.state, NULL, NULL, NULL, NULL), YK_BAD_ARGUMENT);
    YkConfigurationsReport r;
    yk_configurations_each(nested.all, m.state, NULL, call_again, &nested, &r);
    assert_int_equal(nested.status, YK_BAD_ARGUMENT);
    assert_false(r.complete); // call_again left before it had seen the second
    assert_int_equal(r.count, 1);
    yk_configurations_free(nested.all);
    yk_configurations_free(NULL);
    machine_free(&m);
    machine_free(&other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_truss_has_the_configuration_it_was_built_from),
        cmocka_unit_test(test_platforms_with_slides_are_whole),
        cmocka_unit_test(test_the_prism_has_twenty_four_real_configurations),
        cmocka_unit_test(test_triads_have_as_many_as_a_sweep_finds),
        cmocka_unit_test(test_at_a_dead_point_it_is_not_complete),
        cmocka_unit_test(test_no_assembly_is_proved),
        cmocka_unit_test(test_dyads_are_complete_in_closed_form),
        cmocka_unit_test(test_a_gear_in_a_group_is_excluded),
        cmocka_unit_test(test_warm_and_cold_find_the_same),
        cmocka_unit_test(test_once_it_is_enough_nothing_is_claimed),
        cmocka_unit_test(test_wrong_calls_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
