// Elimination and paths: two solvers that share no step find the same configurations of random groups.
#include "configurations/random_group.h"
#include "configurations/truss.h"

enum { MOST = 80, COORDINATES_MAX = 40 };

typedef struct List {
    double q[MOST][COORDINATES_MAX];
    size_t count, coordinates;
    YkConfigurationsReport report;
} List;

static bool gather(void *context, YkState *state)
{
    List *list = context;
    list->coordinates = yk_coordinate_count(yk_state_mechanism(state));
    assert_true(list->count < MOST && list->coordinates <= COORDINATES_MAX);
    assert_true(yk_state_residuals(state).position <= 1e-12);
    for (size_t k = 0; k < list->coordinates; k++) list->q[list->count][k] = yk_state_coordinate(state, k).position;
    list->count++;
    return true;
}

static void find(Machine *m, YkGroupSolver solver, List *list)
{
    YkConfigurations *all = yk_configurations_new(m->mech);
    YkConfigurationsOptions options = yk_default_configurations_options();
    options.solver = solver;
    *list = (List){.count = 0};
    assert_non_null(all);
    assert_true(yk_configurations_each(all, m->state, &options, gather, list, &list->report) >= 0);
    yk_configurations_free(all);
}

static bool holds(const Machine *m, const List *list, const double *q)
{
    for (size_t s = 0; s < list->count; s++) {
        bool is_same = true;
        for (size_t k = 0; k < list->coordinates; k++) {
            double off = list->q[s][k] - q[k];
            if (!yk_coordinate_info(m->mech, k).is_distance) off = yk_nearest_turn(off, 0);
            is_same &= fabs(off) < 1e-7 * fmax(1, fabs(q[k]));
        }
        if (is_same) return true;
    }
    return false;
}

// Both are complete, for the same reason, with the same configurations.
static void check_agreement(Machine *m, const char *what, uint64_t seed)
{
    static List eliminated, followed;
    find(m, YK_SOLVER_ELIMINATION, &eliminated);
    find(m, YK_SOLVER_PATHS, &followed);
    bool is_good = eliminated.report.complete && followed.report.complete && eliminated.count == followed.count;
    if (!is_good)
        print_error("%s, seed %d: %s; by paths %s\n", what, (int)seed, eliminated.report.message,
                    followed.report.message);
    assert_true(is_good);
    assert_int_equal(eliminated.report.reason, YK_COMPLETE_BY_COUNT);
    assert_int_equal(eliminated.report.proved, followed.report.proved);
    for (size_t s = 0; s < eliminated.count; s++) assert_true(holds(m, &followed, eliminated.q[s]));
}

// Returns whether the seed gave a group of that many loops.
static bool try_group(size_t loops, uint64_t seed)
{
    Machine m = random_group_machine(loops, seed);
    bool is_one = random_group_is_one(&m, loops);
    if (is_one) check_agreement(&m, "random group", seed);
    machine_free(&m);
    return is_one;
}

// 1,000 of them with YOKE_FULL=1; all of their counts come from the matroid, which knows neither solver.
static void test_both_solvers_agree_on_random_groups(void **unused)
{
    (void)unused;
    uint64_t wanted = getenv("YOKE_FULL") ? 1000 : check_cases(40), found[4] = {0};
    for (uint64_t seed = 1; found[2] + found[3] < wanted; seed++) {
        size_t loops = 2 + seed % 2;
        found[loops] += try_group(loops, 7919 * seed);
    }
    assert_true(found[2] > 0 && found[3] > 0);
}

// In these a slide that is hidden has the same distance in several solutions, and eigenvectors must be told apart. The
// last has a solution at 126 times the machine's size, which only a small polydisc proves to be real.
static void test_solutions_with_an_equal_unknown_are_told_apart(void **unused)
{
    (void)unused;
    static const uint64_t seeds[] = {21, 107, 112, 126, 2957};
    for (size_t k = 0; k < sizeof seeds / sizeof *seeds; k++) assert_true(try_group(2 + seeds[k] % 2, 7919 * seeds[k]));
}

typedef struct Published {
    const char *links;
    size_t count;
} Published;

static const Published nine_links[] = {
#include "configurations/nine_links.h"
};

static void test_both_solvers_agree_on_trusses_of_nine_links(void **unused)
{
    (void)unused;
    check_without_sanitizers();
    size_t step = getenv("YOKE_FULL") ? 1 : 9;
    for (size_t k = 0; k < sizeof nine_links / sizeof *nine_links; k += step) {
        Truss truss = {.links = nine_links[k].links};
        List list;
        truss_scatter(&truss, 3);
        Machine m = truss_machine(&truss);
        check_agreement(&m, truss.links, 3);
        find(&m, YK_SOLVER_ELIMINATION, &list);
        assert_int_equal(list.report.proved, nine_links[k].count);
        machine_free(&m);
    }
}

static void test_larger_groups_are_not_eliminated(void **unused)
{
    (void)unused;
    Truss truss = {.links = "adn abehk bcg cd efj fg him ij klo lm no"};
    List list;
    truss_scatter(&truss, 3);
    Machine m = truss_machine(&truss);
    find(&m, YK_SOLVER_ELIMINATION, &list);
    assert_false(list.report.complete);
    assert_non_null(strstr(list.report.message, "up to four loops"));
    assert_true(list.count > 0); // searched
    machine_free(&m);
}

// At a double root no solver can prove both, and elimination claims nothing either.
static void test_a_dead_point_is_not_complete(void **unused)
{
    (void)unused;
    Truss truss = {.links = "abc ad be cf def", .x = {2, -2, 0.3, 1, -1.2, 0.06}, .y = {1, 1.5, -2, 0.5, 0.9, -0.4}};
    List list;
    Machine m = truss_machine(&truss);
    find(&m, YK_SOLVER_ELIMINATION, &list);
    assert_false(list.report.complete);
    assert_int_equal(list.report.proved, 4);
    assert_int_equal(list.report.expected, 6);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_both_solvers_agree_on_random_groups),
        cmocka_unit_test(test_solutions_with_an_equal_unknown_are_told_apart),
        cmocka_unit_test(test_both_solvers_agree_on_trusses_of_nine_links),
        cmocka_unit_test(test_larger_groups_are_not_eliminated),
        cmocka_unit_test(test_a_dead_point_is_not_complete),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
