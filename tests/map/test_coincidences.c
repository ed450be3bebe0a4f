// Maps of machines whose dimensions coincide, exactly or nearly: with slides and slots, over a crank and over a slider.
// Where a map is called complete, a dense sweep of `solve --all` finds the same number of configurations, also close
// beside events; where the dimensions are not special, maps are complete.
#include <yoke/configurations.h>
#include <yoke/map.h>
#include <yoke/move.h>
#include "solve/machine.h"

// Returns one of few lengths, so that many coincide, or nearly do.
static double length(uint64_t *seed)
{
    static const double nice[] = {1, 1, 2, 1.5, 0.5}, apart[] = {0, 0, 1e-2, 1e-4, 1e-7, 1e-10, 1e-13};
    double value = nice[(size_t)check_uniform(seed, 0, 4.999)];
    return value + apart[(size_t)check_uniform(seed, 0, 6.999)];
}

// Writes a dyad that hangs on point `at` of body `on`: a rocker, a slider or a slotted lever; k numbers its bodies.
static void add_dyad(int kind, int k, const char *on, const char *at, uint64_t *seed, char *bodies, char *joints,
                     size_t capacity)
{
    double a = length(seed), b = length(seed), e = length(seed);
    if (kind == 2) {
        snprintf(bodies, capacity, "  l%d: {points: {C%d: [0, 0], E%d: [%.17g, %.17g]}}\n", k, k, k, a,
                 k == 1 ? 0.3 : 0);
        snprintf(joints, capacity,
                 "  C%d: {pin: [ground, l%d]}\n  S%d: {pin-slot: [l%d, %s], at: %s, from: C%d, along: x}\n", k, k, k, k,
                 on, at, k);
        return;
    }
    snprintf(bodies, capacity,
             "  l%d: {points: {%s: [0, 0], B%d: [%.17g, 0], E%d: [%.17g, 0]}}\n  r%d: {points: {%s%d: [0, 0]%s%d: "
             "[%.17g, 0]}}\n",
             k, at, k, a, k, e, k, kind == 0 ? "C" : "B", k, kind == 0 ? ", B" : ", X", k, b);
    if (kind == 0)
        snprintf(joints, capacity,
                 "  A%d: {pin: [%s, l%d], at: %s}\n  C%d: {pin: [ground, r%d]}\n  B%d: {pin: [l%d, r%d]}\n", k, on, k,
                 at, k, k, k, k, k);
    else
        snprintf(joints, capacity,
                 "  A%d: {pin: [%s, l%d], at: %s}\n  S%d: {slide: [ground, r%d], along: %s, from: C%d, distance: d%d}\n"
                 "  B%d: {pin: [l%d, r%d]}\n",
                 k, on, k, at, k, k, k == 1 ? "x" : "y", k, k, k, k, k);
}

static Machine random_machine(int first, int second, uint64_t *seed)
{
    char bodies[2][800], joints[2][800], text[4000];
    add_dyad(first, 1, "crank", "A", seed, bodies[0], joints[0], sizeof bodies[0]);
    add_dyad(second, 2, "l1", "E1", seed, bodies[1], joints[1], sizeof bodies[1]);
    double crank = length(seed), x = length(seed), y = (int)check_uniform(seed, 0, 2) ? 0 : length(seed) - 1;
    double gx = length(seed), gy = length(seed), u = check_uniform(seed, -3, 3);
    snprintf(text, sizeof text,
             "bodies:\n  ground: {points: {O: [0, 0], C1: [%.17g, %.17g], C2: [%.17g, %.17g]}}\n"
             "  crank: {points: {O: [0, 0], A: [%.17g, 0]}}\n%s%sjoints:\n  O: {pin: [ground, crank], angle: u}\n%s%s"
             "drives: {u: %.17g}\n",
             x, y, gx, -gy, crank, bodies[0], bodies[1], joints[0], joints[1], u);
    return machine_parse_with(text, NULL, 0);
}

static double nearest_event(const YkMap *map, double at, double period)
{
    double nearest = INFINITY;
    for (size_t c = 0; c < yk_map_circuit_count(map); c++)
        for (size_t e = 0; e < yk_map_circuit(map, c).events; e++) {
            double off = yk_map_event(map, c, e).at - at;
            if (period > 0) off -= period * rint(off / period);
            nearest = fmin(nearest, fabs(off));
        }
    return nearest;
}

static void compare_at(Machine *m, YkMap *map, YkConfigurations *all, double u, const char *what, size_t *compared)
{
    YkMapPlace places[64];
    YkConfigurationsReport report;
    YkRange domain = yk_map_domain(map);
    bool is_angle = !yk_coordinate_info(m->mech, yk_map_coordinate(map)).is_distance;
    double period = is_angle ? domain.to - domain.from : 0;
    if (!(u > domain.from && u < domain.to) || nearest_event(map, u, period) < 1e-5) return;
    yk_state_set_input(m->state, 0, (YkMotion){u, 0, 0});
    yk_configurations_each(all, m->state, NULL, NULL, NULL, &report);
    if (!report.complete) return;
    size_t count = yk_map_places(map, u, places, 64);
    if (count != report.count) print_error("%s at %.17g: %zu, solve --all %zu\n", what, u, count, report.count);
    assert_int_equal(count, report.count);
    ++*compared;
}

static void check_map(Machine *m, const char *what, size_t *maps, size_t *complete, size_t *compared)
{
    YkMap *map = yk_map_new(m->state, yk_input_coordinate(m->mech, 0), m->problems);
    if (!map) print_error("%s", yk_problems_text(m->problems, 0));
    assert_non_null(map);
    ++*maps;
    if (yk_map_is_complete(map)) {
        YkConfigurations *all = yk_configurations_new(m->mech);
        YkRange domain = yk_map_domain(map);
        enum { STEPS = 150 };
        for (int k = 0; k < STEPS; k++)
            compare_at(m, map, all, domain.from + (k + 0.5) / STEPS * (domain.to - domain.from), what, compared);
        for (size_t c = 0; c < yk_map_circuit_count(map); c++)
            for (size_t e = 0; e < yk_map_circuit(map, c).events; e++)
                for (double off = -1e-2; off < 1.5e-2; off += 4e-3)
                    compare_at(m, map, all, yk_map_event(map, c, e).at + off, what, compared);
        yk_configurations_free(all);
        ++*complete;
    }
    yk_map_free(map);
}

// Maps the same machine over its first slider.
static void check_slider(const Machine *of, const char *what, size_t *maps, size_t *complete, size_t *compared)
{
    Machine m = {.model = of->model, .problems = of->problems};
    machine_compile(&m, "d1");
    if (yk_state_adopt(m.state, of->state) >= 0) check_map(&m, what, maps, complete, compared);
    yk_state_free(m.state);
    yk_mechanism_free(m.mech);
}

static void test_complete_maps_agree_with_dense_sweeps(void **unused)
{
    (void)unused;
    size_t maps = 0, complete = 0, compared = 0, slider_maps = 0, slider_complete = 0;
    for (uint64_t k = 0; k < check_cases(45); k++) {
        uint64_t seed = 100 + k;
        int first = (int)(k % 3), second = (int)(k / 3 % 3);
        char what[80];
        Machine m = random_machine(first, second, &seed);
        snprintf(what, sizeof what, "machine %d (dyads %d, %d)", (int)k, first, second);
        if (yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0) {
            check_map(&m, what, &maps, &complete, &compared);
            if (first == 1) check_slider(&m, what, &slider_maps, &slider_complete, &compared);
        }
        machine_free(&m);
    }
    print_message("%zu maps over a crank, %zu complete; %zu over a slider, %zu complete; %zu inputs compared\n", maps,
                  complete, slider_maps, slider_complete, compared);
    assert_true(maps > check_cases(45) / 3 && complete > maps / 3 && compared > 30 * complete);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_complete_maps_agree_with_dense_sweeps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
