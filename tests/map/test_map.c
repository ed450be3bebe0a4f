// Maps: circuits and limits of four-bars in closed form; for other machines every configuration of `solve --all` at
// random inputs is on the map, and no other.
#include <yoke/configurations.h>
#include <yoke/map.h>
#include "configurations/truss.h"

enum { ALL_MAX = 64, COORDINATES_MAX = 24, RANDOM_TRIES = 12 };

static YkMap *map_of(Machine *m)
{
    YkMap *map = yk_map_new(m->state, yk_input_coordinate(m->mech, 0), m->problems);
    if (!map) print_error("%s", yk_problems_text(m->problems, 0));
    assert_non_null(map);
    return map;
}

static Machine open_over(const char *file, const char *coordinate)
{
    Machine m = machine_open(file, coordinate);
    assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
    return m;
}

// --- four-bars in closed form

static Machine four_bar(double ground, double crank, double coupler, double rocker, const char *start)
{
    char text[1200];
    snprintf(text, sizeof text,
             "bodies:\n  ground: {points: {A: [0, 0], D: [%.17g, 0]}}\n  crank: {points: {A: [0, 0], B: [%.17g, 0]}}\n"
             "  coupler: {points: {B: [0, 0], C: [%.17g, 0]}}\n  rocker: {points: {D: [0, 0], C: [%.17g, 0]}}\n"
             "joints:\n  A: {pin: [ground, crank], angle: u}\n  B: {pin: [crank, coupler], angle: b}\n"
             "  D: {pin: [ground, rocker], angle: d}\n  C: {pin: [coupler, rocker]}\ndrives: {u: %s}\n",
             ground, crank, coupler, rocker, start);
    return machine_parse_with(text, NULL, 0);
}

// Returns the angle of the crank at which A and D span the distance from B to D, or NaN.
static double angle_at(double ground, double crank, double distance)
{
    double c = (ground * ground + crank * crank - distance * distance) / (2 * ground * crank);
    return fabs(c) <= 1 ? acos(c) : NAN;
}

// Checks how far the angle between links p and q turns, which the others, r and s, close: over a circuit it goes
// through the angles at which their ends are no nearer and no farther than r and s let them.
static void check_turn(YkMapTurn turn, double p, double q, double r, double s, bool is_grashof)
{
    double near = angle_at(p, q, fabs(r - s)), far = angle_at(p, q, r + s);
    double width = isnan(near) ? 2 * far : 2 * (YK_PI - near); // through 0, or through a half turn
    if (is_grashof) width = far - near;                        // on one side
    assert_int_equal(turn.is_full, isnan(near) && isnan(far));
    CHECK_NEAR(turn.range.to - turn.range.from, turn.is_full ? 2 * YK_PI : width, 1e-7);
}

// Checks circuits, ranges, turns and limits of a four-bar against the triangles that its diagonals make of it. With
// `apart`, one is taken whose links lie in one line but for that.
static void check_four_bar(uint64_t *seed, double apart)
{
    double g = check_uniform(seed, 0.5, 3), a = check_uniform(seed, 0.5, 3), b = check_uniform(seed, 0.5, 3),
           c = check_uniform(seed, 0.5, 3);
    if (apart != 0) c = fmax(a + b - g, 0.5) + apart;
    double most = fmax(fmax(g, a), fmax(b, c)), least = fmin(fmin(g, a), fmin(b, c));
    double outer = angle_at(g, a, b + c), inner = angle_at(g, a, fabs(b - c)), at[4];
    size_t limits = 0, expected_circuits;
    bool is_grashof = 2 * (most + least) < g + a + b + c;
    if (!isnan(inner)) at[limits++] = -inner, at[limits++] = inner;
    if (!isnan(outer)) at[limits++] = -outer, at[limits++] = outer;
    double start = isnan(inner) && isnan(outer) ? 1
                   : isnan(inner)               ? 0.5 * outer
                   : isnan(outer)               ? 0.5 * (inner + YK_PI)
                                                : 0.5 * (inner + outer);
    if (2 * most >= g + a + b + c) return; // no machine
    // Grashof: two circuits; over a crank each is closed, over a rocker each turns back. Otherwise all is one circuit.
    expected_circuits = is_grashof ? 2 : 1;
    char drive[64];
    snprintf(drive, sizeof drive, "%.17g", start);
    Machine m = four_bar(g, a, b, c, drive);
    assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
    YkMap *map = map_of(&m);
    if (!yk_map_is_complete(map)) print_error("%.17g %.17g %.17g %.17g: %s\n", g, a, b, c, yk_map_message(map));
    assert_true(yk_map_is_complete(map));
    assert_int_equal(yk_map_circuit_count(map), expected_circuits);
    assert_true(yk_map_circuit(map, 0).contains_start);
    size_t events = 0;
    for (size_t k = 0; k < expected_circuits; k++) {
        YkMapCircuit circuit = yk_map_circuit(map, k);
        events += circuit.events;
        assert_int_equal(circuit.branches, limits > 0 ? 2 * circuit.ranges : 1);
        // The shortest link of a Grashof four-bar turns fully to all others.
        bool turns = yk_map_turn(map, k, 0).is_full;
        assert_int_equal(turns, is_grashof && (least == a || least == g));
        assert_int_equal(yk_map_turn(map, k, 3).is_full, is_grashof && (least == b || least == c));
        check_turn(yk_map_turn(map, k, 0), g, a, b, c, is_grashof);
        check_turn(yk_map_turn(map, k, 1), a, b, c, g, is_grashof);
        check_turn(yk_map_turn(map, k, 2), g, c, a, b, is_grashof);
        check_turn(yk_map_turn(map, k, 3), b, c, g, a, is_grashof);
        for (size_t e = 0; e < circuit.events; e++) {
            YkMapEvent event = yk_map_event(map, k, e);
            double off = 10;
            assert_int_equal(event.kind, YK_MAP_LIMIT);
            for (size_t l = 0; l < limits; l++) off = fmin(off, fabs(event.at - at[l]));
            CHECK_NEAR(off, 0, 1e-10);
            // Coupler and rocker lie in one line there.
            double turn = yk_map_event_value(map, k, e, yk_coordinate_find(m.mech, "b")) + event.at -
                          yk_map_event_value(map, k, e, yk_coordinate_find(m.mech, "d"));
            CHECK_NEAR(sin(turn), 0, 1e-7);
        }
    }
    assert_int_equal(events, limits);
    yk_map_free(map);
    machine_free(&m);
}

static void test_four_bars_are_as_grashof_says(void **unused)
{
    (void)unused;
    uint64_t seed = 18;
    for (uint64_t k = 0; k < check_cases(60); k++) check_four_bar(&seed, 0);
}

// There joints have their extremes close to limits, and turn round within a small part of the motion.
static void test_four_bars_near_change_points_turn_as_far_as_their_links_say(void **unused)
{
    (void)unused;
    uint64_t seed = 19;
    for (uint64_t k = 0; k < check_cases(12); k++)
        check_four_bar(&seed, pow(-1, (double)k) * pow(10, check_uniform(&seed, -6, -3)));
}

static void test_a_rocker_turns_back_where_the_links_say(void **unused)
{
    (void)unused;
    Machine m = open_over("four-bar", "theta4");
    YkMap *map = map_of(&m);
    assert_int_equal(yk_map_circuit_count(map), 2);
    for (size_t k = 0; k < 2; k++) {
        YkRange range = yk_map_range(map, k, 0);
        double sign = range.from > 0 ? 1 : -1;
        CHECK_NEAR(fmin(range.from * sign, range.to * sign) * 180 / YK_PI, 54.9, 0.05);
        CHECK_NEAR(fmax(range.from * sign, range.to * sign) * 180 / YK_PI, 128.7, 0.05);
        assert_true(yk_map_turn(map, k, 0).is_full && !yk_map_turn(map, k, 2).is_full);
    }
    yk_map_free(map);
    machine_free(&m);
}

// --- every configuration of solve --all, and no other

typedef struct All {
    double q[ALL_MAX][COORDINATES_MAX];
    size_t count, coordinates;
} All;

static bool gather(void *context, YkState *state)
{
    All *all = context;
    all->coordinates = yk_coordinate_count(yk_state_mechanism(state));
    assert_true(all->count < ALL_MAX && all->coordinates <= COORDINATES_MAX);
    for (size_t k = 0; k < all->coordinates; k++) all->q[all->count][k] = yk_state_coordinate(state, k).position;
    all->count++;
    return true;
}

// Returns the distance of a configuration from the nearest one of the map at this input; counts those.
static double off_the_map(const Machine *m, YkMap *map, double at, const double *q, size_t *count)
{
    YkMapPlace places[ALL_MAX];
    double nearest = INFINITY, row[COORDINATES_MAX];
    *count = yk_map_places(map, at, places, ALL_MAX);
    assert_true(*count <= ALL_MAX);
    for (size_t p = 0; p < *count && q; p++) {
        double most = 0;
        assert_true(yk_map_coordinates_at(map, places[p], row));
        for (size_t k = 0; k < yk_coordinate_count(m->mech); k++) {
            double off = row[k] - q[k];
            if (k == yk_map_coordinate(map)) continue;
            if (!yk_coordinate_info(m->mech, k).is_distance) off = yk_nearest_turn(off, 0);
            most = fmax(most, fabs(off));
        }
        nearest = fmin(nearest, most);
    }
    return nearest;
}

static double nearest_event(const YkMap *map, double at)
{
    double nearest = INFINITY;
    for (size_t c = 0; c < yk_map_circuit_count(map); c++)
        for (size_t e = 0; e < yk_map_circuit(map, c).events; e++) {
            double off = yk_map_event(map, c, e).at - at;
            nearest = fmin(nearest, fmin(fabs(off), fabs(yk_nearest_turn(off, 0))));
        }
    return nearest;
}

// Compares a map with all configurations at random inputs.
static void compare(Machine *m, YkMap *map, const char *name, int tries)
{
    YkConfigurations *all = yk_configurations_new(m->mech);
    YkRange domain = yk_map_domain(map);
    uint64_t seed = 7;
    size_t found = 0;
    for (int k = 0; k < tries; k++) {
        All at = {.count = 0};
        YkConfigurationsReport report;
        YkRange over = k % 2 == 0 ? domain : yk_map_range(map, 0, 0);
        double u = check_uniform(&seed, over.from, over.to);
        if (nearest_event(map, u) < 1e-3 * (over.to - over.from)) continue;
        yk_state_set_input(m->state, 0, (YkMotion){u, 0, 0});
        yk_configurations_each(all, m->state, NULL, gather, &at, &report);
        assert_true(report.complete);
        size_t count = 0;
        off_the_map(m, map, u, NULL, &count);
        if (count != at.count) print_error("%s at %.17g: %zu of %zu\n", name, u, count, at.count);
        assert_int_equal(count, at.count);
        for (size_t c = 0; c < at.count; c++) {
            double off = off_the_map(m, map, u, at.q[c], &count);
            if (!(off < 1e-9)) print_error("%s at %.17g: off by %g\n", name, u, off);
            assert_true(off < 1e-9);
        }
        found += at.count;
    }
    assert_true(found > (size_t)tries / 4);
    yk_configurations_free(all);
}

static void test_every_configuration_is_on_the_map(void **unused)
{
    (void)unused;
    static const struct {
        const char *file, *over;
        size_t circuits;
    } machines[] = {{"watt-six-bar", NULL, 1},
                    {"stephenson-six-bar", NULL, 4},
                    {"stephenson-awkward", NULL, 4},
                    {"jansen", NULL, 6},
                    {"klann", NULL, 3},
                    {"quick-return", NULL, 2},
                    {"slider-crank", NULL, 2},
                    {"drag-link", NULL, 2},
                    {"driven-coupler", NULL, 2},
                    {"inverted-slider-crank", NULL, 2},
                    {"whitworth-kg", NULL, 4},
                    {"chebyshev", NULL, 2}};
    for (size_t k = 0; k < sizeof machines / sizeof *machines; k++) {
        Machine m = open_over(machines[k].file, machines[k].over);
        YkMap *map = map_of(&m);
        if (!yk_map_is_complete(map)) print_error("%s: %s\n", machines[k].file, yk_map_message(map));
        assert_true(yk_map_is_complete(map));
        assert_int_equal(yk_map_circuit_count(map), machines[k].circuits);
        assert_true(yk_map_circuit(map, 0).contains_start);
        compare(&m, map, machines[k].file, (int)check_cases(60));
        yk_map_free(map);
        machine_free(&m);
    }
}

static void test_the_double_butterfly_is_mapped(void **unused)
{
    (void)unused;
    check_without_sanitizers();
    Machine m = open_over("double-butterfly", NULL);
    YkMap *map = map_of(&m);
    assert_true(yk_map_is_complete(map));
    compare(&m, map, "double-butterfly", (int)check_cases(40));
    yk_map_free(map);
    machine_free(&m);
}

// At a limit the number of configurations changes by two.
static void test_the_count_changes_at_limits_alone(void **unused)
{
    (void)unused;
    Machine m = open_over("stephenson-awkward", NULL);
    YkMap *map = map_of(&m);
    YkConfigurations *all = yk_configurations_new(m.mech);
    size_t events = 0;
    for (size_t c = 0; c < yk_map_circuit_count(map); c++)
        for (size_t e = 0; e < yk_map_circuit(map, c).events; e++, events++) {
            size_t count[2];
            for (int side = 0; side < 2; side++) {
                YkConfigurationsReport report;
                double u = yk_map_event(map, c, e).at + (side == 0 ? -1e-6 : 1e-6);
                yk_state_set_input(m.state, 0, (YkMotion){u, 0, 0});
                yk_configurations_each(all, m.state, NULL, NULL, NULL, &report);
                assert_true(report.complete);
                count[side] = report.count;
            }
            assert_int_equal(count[0] > count[1] ? count[0] - count[1] : count[1] - count[0], 2);
        }
    assert_int_equal(events, 8);
    yk_configurations_free(all);
    yk_map_free(map);
    machine_free(&m);
}

// Random machines of two and three loops, the last of them with a triad; dimensions from one configuration, in which
// all angles are 0.
static void check_machine(const char *links, uint64_t seed, size_t *found, size_t *incomplete)
{
    Truss truss = {.links = links};
    truss_scatter(&truss, seed);
    Machine m = truss_machine(&truss);
    assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
    YkMap *map = map_of(&m);
    // A few have two events so near each other that they are not proved apart, and say so.
    *incomplete += !yk_map_is_complete(map);
    assert_true(yk_map_circuit(map, 0).contains_start);
    compare(&m, map, links, 12);
    for (size_t c = 0; c < yk_map_circuit_count(map); c++) *found += yk_map_circuit(map, c).events;
    yk_map_free(map);
    machine_free(&m);
}

static void agree_with_solve_all(const char *const links[], size_t kinds, uint64_t first)
{
    size_t events = 0, incomplete = 0, tries = check_cases(RANDOM_TRIES);
    if (tries > 2 && !getenv("YOKE_FULL")) tries = 2;
    for (size_t k = 0; k < kinds; k++)
        for (uint64_t seed = first; seed <= tries; seed++) check_machine(links[k], seed, &events, &incomplete);
    assert_true(events > tries * kinds / 2 && incomplete <= 1);
}

static void test_random_machines_agree_with_solve_all(void **unused)
{
    (void)unused;
    static const char *const links[] = {"abc ad be def fg cg", "ab ac cde bdf eg fg", "hbc ha ad be cf def"};
    agree_with_solve_all(links, sizeof links / sizeof *links, 1);
}

static void test_triads_beside_loops_agree_with_solve_all(void **unused)
{
    (void)unused;
    check_without_sanitizers();
    static const char *const links[] = {"abk ac cd bdef eg fgh hi ki"};
    agree_with_solve_all(links, 1, 2); // the first takes seconds
}

// --- change points, gears, sliders

static void check_change_points(const char *file, size_t count)
{
    Machine m = open_over(file, NULL);
    YkMap *map = map_of(&m);
    assert_true(yk_map_is_complete(map));
    assert_int_equal(yk_map_circuit_count(map), 1);
    assert_int_equal(yk_map_circuit(map, 0).events, count);
    for (size_t e = 0; e < count; e++) {
        YkMapEvent event = yk_map_event(map, 0, e);
        assert_int_equal(event.kind, YK_MAP_CHANGE_POINT);
        CHECK_NEAR(sin(event.at), 0, 1e-10); // the links in one line: 0 or 180 deg
    }
    yk_map_free(map);
    machine_free(&m);
}

static void test_branches_cross_at_change_points(void **unused)
{
    (void)unused;
    check_change_points("parallelogram", 2);
    check_change_points("kite", 2);
    check_change_points("change-point-four-bar", 1);
}

static Machine geared_five_bar(int teeth, int other)
{
    char text[1400];
    snprintf(text, sizeof text,
             "bodies:\n  ground: {points: {A: [0, 0], E: [2, 0]}}\n  left: {points: {A: [0, 0], B: [0.6, 0]}}\n"
             "  right: {points: {E: [0, 0], D: [0.5, 0]}}\n  long: {points: {B: [0, 0], C: [2, 0]}}\n"
             "  short: {points: {D: [0, 0], C: [1.9, 0]}}\njoints:\n  A: {pin: [ground, left], angle: u}\n"
             "  E: {pin: [ground, right], angle: v}\n  B: {pin: [left, long], angle: b}\n"
             "  D: {pin: [right, short], angle: d}\n  C: {pin: [long, short]}\n"
             "gears: {G: {mesh: [left, right], teeth: [%d, %d], carrier: ground}}\ndrives: {u: 0.3}\n",
             teeth, other);
    return machine_parse_with(text, NULL, 0);
}

static void test_a_geared_five_bar_repeats_after_whole_turns_of_both(void **unused)
{
    (void)unused;
    static const int teeth[][3] = {{20, 20, 1}, {40, 20, 1}, {20, 40, 2}, {30, 20, 2}, {20, 30, 3}};
    for (size_t k = 0; k < sizeof teeth / sizeof *teeth; k++) {
        Machine m = geared_five_bar(teeth[k][0], teeth[k][1]);
        assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
        YkMap *map = map_of(&m);
        YkRange domain = yk_map_domain(map);
        assert_true(yk_map_is_complete(map));
        CHECK_NEAR((domain.to - domain.from) / (2 * YK_PI), teeth[k][2], 1e-12);
        compare(&m, map, "geared five-bar", 40);
        yk_map_free(map);
        machine_free(&m);
    }
}

// A crank and a rod of equal lengths reach from -2 to 2 of them, and turn freely where they fold.
static void test_a_slider_on_equal_links_has_both_limits(void **unused)
{
    (void)unused;
    Machine m = machine_parse_with("bodies:\n  ground: {points: {O: [0, 0]}}\n"
                                   "  crank: {points: {O: [0, 0], A: [0.3, 0]}}\n"
                                   "  rod: {points: {A: [0, 0], B: [0.3, 0]}}\n  piston: {points: {B: [0, 0]}}\n"
                                   "joints:\n  O: {pin: [ground, crank], angle: th}\n  A: {pin: [crank, rod]}\n"
                                   "  B: {pin: [rod, piston]}\n  S: {slide: [ground, piston], along: x, distance: s}\n"
                                   "drives: {s: 0.5}\nstart: {th: 0.5}\n",
                                   NULL, 0);
    assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
    YkMap *map = map_of(&m);
    double limits[8];
    size_t count = 0;
    for (size_t c = 0; c < yk_map_circuit_count(map); c++)
        for (size_t e = 0; e < yk_map_circuit(map, c).events; e++) {
            YkMapEvent event = yk_map_event(map, c, e);
            if (event.kind != YK_MAP_LIMIT) CHECK_NEAR(event.at, 0, 1e-9);
            if (event.kind == YK_MAP_LIMIT && count < 8) limits[count++] = event.at;
        }
    assert_int_equal(count, 2);
    CHECK_NEAR(limits[0], -0.6, 1e-10);
    CHECK_NEAR(limits[1], 0.6, 1e-10);
    assert_false(yk_map_is_complete(map)); // where they fold there is a continuum
    CHECK_NEAR(strtod(strstr(yk_map_message(map), "near ") + 5, NULL), 0, 1e-9);
    yk_map_free(map);
    machine_free(&m);
}

static void test_a_slider_turns_back_at_its_dead_centres(void **unused)
{
    (void)unused;
    static const char text[] =
        "bodies:\n  ground: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0], A: [1, 0]}}\n"
        "  rod: {points: {A: [0, 0], B: [3, 0]}}\n  piston: {points: {B: [0, 0]}}\njoints:\n"
        "  O: {pin: [ground, crank], angle: u}\n  A: {pin: [crank, rod], angle: b}\n  B: {pin: [rod, piston]}\n"
        "  S: {slide: [ground, piston], along: x, distance: s}\ndrives: {s: 3.2}\nstart: {u: 60 deg}\n";
    Machine m = machine_parse_with(text, NULL, 0);
    assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
    YkMap *map = map_of(&m);
    assert_true(yk_map_is_complete(map));
    assert_int_equal(yk_map_circuit_count(map), 2); // s in [2, 4] and in [-4, -2]
    for (size_t c = 0; c < 2; c++) {
        YkRange range = yk_map_range(map, c, 0);
        CHECK_NEAR(fabs(range.from), c == 0 ? 2 : 4, 1e-10);
        CHECK_NEAR(fabs(range.to), c == 0 ? 4 : 2, 1e-10);
        assert_true(yk_map_turn(map, c, 0).is_full);
    }
    compare(&m, map, "slider-crank over s", 100);
    yk_map_free(map);
    machine_free(&m);
}

// --- dead points, refusals

static void test_dead_points_are_limits_of_the_drive(void **unused)
{
    (void)unused;
    const char *input = "theta2";
    Machine m = open_over("non-grashof", "theta4"), d = {.model = m.model, .problems = m.problems};
    machine_compile(&d, input);
    assert_true(yk_state_set_time(d.state, 0, m.problems) >= 0 && yk_state_assemble(d.state) >= 0);
    YkMap *map = map_of(&m), *drive = map_of(&d);
    size_t theta2 = yk_coordinate_find(m.mech, "theta2"), dead = 0;
    assert_int_equal(yk_map_add_dead_points(map, drive), YK_OK);
    assert_true(yk_map_is_complete(map));
    for (size_t e = 0; e < yk_map_circuit(map, 0).events; e++) {
        YkMapEvent event = yk_map_event(map, 0, e);
        if (event.kind != YK_MAP_DEAD_POINT) continue;
        dead++;
        assert_int_equal(event.coordinate, theta2);
        // theta2 is at one of its own limits there
        double value = yk_nearest_turn(yk_map_event_value(map, 0, e, theta2), 0);
        CHECK_NEAR(fabs(value), fabs(yk_map_event(drive, 0, 0).at), 1e-9);
    }
    assert_int_equal(dead, 2);
    YkMap *other = map_of(&m); // the drive of the file is theta2
    assert_int_equal(yk_map_add_drives(other, m.state, m.problems), YK_OK);
    assert_true(yk_map_is_complete(other));
    assert_int_equal(yk_map_circuit(other, 0).events, yk_map_circuit(map, 0).events);
    for (size_t e = 0; e < yk_map_circuit(map, 0).events; e++) {
        YkMapEvent event = yk_map_event(map, 0, e), same = yk_map_event(other, 0, e);
        assert_int_equal(same.kind, event.kind);
        assert_true(same.coordinate == event.coordinate);
        CHECK_NEAR(same.at, event.at, 1e-9);
    }
    assert_int_equal(yk_map_add_drives(other, d.state, m.problems), YK_BAD_ARGUMENT); // of another mechanism
    assert_int_equal(yk_map_add_drives(other, NULL, m.problems), YK_BAD_ARGUMENT);
    assert_int_equal(yk_map_add_drives(NULL, m.state, m.problems), YK_BAD_ARGUMENT);
    yk_map_free(other);
    assert_int_equal(yk_map_add_dead_points(map, map), YK_BAD_ARGUMENT);
    assert_int_equal(yk_map_add_dead_points(NULL, map), YK_BAD_ARGUMENT);
    yk_map_free(map);
    yk_map_free(drive);
    yk_state_free(d.state);
    yk_mechanism_free(d.mech);
    machine_free(&m);
}

// A machine that stands at a limit, on either side, is on its circuit there.
static void test_a_start_at_a_limit_is_on_the_map(void **unused)
{
    (void)unused;
    for (int side = -1; side <= 1; side += 2) {
        Machine m = open_over("non-grashof", NULL);
        YkSweep *sweep = machine_sweep(&m, "theta2", 0.5, side * 3, 5, NULL, 0);
        assert_int_equal(yk_sweep_status(sweep), YK_LIMIT);
        YkMap *map = map_of(&m);
        assert_true(yk_map_is_complete(map) && yk_map_circuit(map, 0).contains_start);
        CHECK_NEAR(yk_map_start(map).at, side * fmax(-yk_map_range(map, 0, 0).from, yk_map_range(map, 0, 0).to), 1e-8);
        yk_sweep_free(sweep);
        yk_map_free(map);
        machine_free(&m);
    }
}

static void test_what_cannot_be_mapped_is_refused(void **unused)
{
    (void)unused;
    static const char *const files[] = {"ferguson", "two-rings"};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        Machine m = open_over(files[k], NULL);
        assert_null(yk_map_new(m.state, yk_input_coordinate(m.mech, 0), m.problems));
        assert_non_null(strstr(yk_problems_text(m.problems, 0), "cannot be mapped"));
        machine_free(&m);
    }
    Machine m = open_over("four-bar", NULL);
    assert_null(yk_map_new(NULL, 0, NULL));
    assert_null(yk_map_new(m.state, 99, m.problems));
    assert_null(yk_map_new(m.state, yk_coordinate_find(m.mech, "theta4"), m.problems)); // not an input
    machine_free(&m);
}

// --- cams

// A cam lifts a table. A rod joins the table to the end of a crank of length 1 that turns about (1.2, y).
static Machine cam_machine(double lift, double y, double rod)
{
    char text[2000];
    snprintf(
        text, sizeof text,
        "laws:\n  lift:\n    period: 360 deg\n    segments:\n      - {rise: {to: 120 deg, by: %.17g, law: cycloidal}}\n"
        "      - {dwell: {to: 180 deg}}\n      - {fall: {to: 300 deg, by: %.17g, law: cycloidal}}\n"
        "      - {dwell: {to: 360 deg}}\ncams:\n  disc: {cam: shaft, follower: table, law: lift, face: flat, base: 2}\n"
        "bodies:\n  ground: {points: {O: [0, 0], Q: [1.2, %.17g]}}\n  shaft: {}\n  table: {points: {P: [0, 0]}}\n"
        "  rod: {points: {P: [0, 0], R: [%.17g, 0]}}\n  crank: {points: {Q: [0, 0], R: [1, 0]}}\njoints:\n"
        "  K: {pin: [ground, shaft], angle: u}\n  T: {slide: [ground, table], along: y, distance: s}\n"
        "  P: {pin: [table, rod], angle: b}\n  Q: {pin: [ground, crank], angle: d}\n  R: {pin: [rod, crank]}\n"
        "drives: {u: 10 deg}\nstart: {b: 60 deg, d: 120 deg}\n",
        lift, lift, y, rod);
    return machine_parse_with(text, NULL, 0);
}

// The crank's end is in line with the rod where the table is as high as the triangle of both says; all angles of the
// cam at which it is are limits, and no others.
static void test_a_cam_limits_what_it_moves(void **unused)
{
    (void)unused;
    uint64_t seed = 9;
    size_t limits = 0;
    for (uint64_t k = 0; k < check_cases(30); k++) {
        double lift = check_uniform(&seed, 2, 6), rod = check_uniform(&seed, 1.3, 2);
        Machine m = cam_machine(lift, check_uniform(&seed, 0.8, 1.6), rod);
        assert_true(m.state != NULL);
        if (!(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0)) {
            machine_free(&m);
            continue;
        }
        YkMap *map = map_of(&m);
        if (!yk_map_is_complete(map)) print_error("%g %g: %s\n", lift, rod, yk_map_message(map));
        assert_true(yk_map_is_complete(map));
        compare(&m, map, "cam", 20);
        for (size_t c = 0; c < yk_map_circuit_count(map); c++)
            for (size_t e = 0; e < yk_map_circuit(map, c).events; e++, limits++) {
                double turn = yk_map_event_value(map, c, e, yk_coordinate_find(m.mech, "b")) -
                              yk_map_event_value(map, c, e, yk_coordinate_find(m.mech, "d"));
                assert_int_equal(yk_map_event(map, c, e).kind, YK_MAP_LIMIT);
                CHECK_NEAR(sin(turn), 0, 1e-5);
            }
        yk_map_free(map);
        machine_free(&m);
    }
    assert_true(limits > check_cases(30) / 3);
}

static void test_a_cam_alone_has_one_circuit(void **unused)
{
    (void)unused;
    static const char *const files[] = {"swing-cam", "valve-cam", "formula-cam", "pendulum"};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        Machine m = open_over(files[k], NULL);
        YkMap *map = map_of(&m);
        assert_true(yk_map_is_complete(map));
        assert_int_equal(yk_map_circuit_count(map), 1);
        assert_true(yk_map_turn(map, 0, 0).is_full);
        compare(&m, map, files[k], 20);
        yk_map_free(map);
        machine_free(&m);
    }
}

// --- constraints that repeat others

// Cranks of length 1 that turn in parallel: one at (0, 0), one at (g, 0), the others at x, y; a rod joins them.
static Machine coupled_cranks(double g, size_t others, const double *x, const double *y)
{
    char text[2400], *c = text;
    const char *const end = text + sizeof text;
    c += snprintf(c, (size_t)(end - c), "bodies:\n  ground: {points: {O1: [0, 0], O2: [%.17g, 0]", g);
    for (size_t k = 0; k < others; k++)
        c += snprintf(c, (size_t)(end - c), ", O%zu: [%.17g, %.17g]", k + 3, x[k], y[k]);
    c += snprintf(c, (size_t)(end - c), "}}\n  rod: {points: {A1: [0, 0], A2: [%.17g, 0]", g);
    for (size_t k = 0; k < others; k++)
        c += snprintf(c, (size_t)(end - c), ", A%zu: [%.17g, %.17g]", k + 3, x[k], y[k]);
    c += snprintf(c, (size_t)(end - c), "}}\n");
    for (size_t k = 1; k < others + 3; k++)
        c += snprintf(c, (size_t)(end - c), "  c%zu: {points: {O%zu: [0, 0], A%zu: [1, 0]}}\n", k, k, k);
    c += snprintf(c, (size_t)(end - c), "joints:\n");
    for (size_t k = 1; k < others + 3; k++)
        c +=
            snprintf(c, (size_t)(end - c), "  O%zu: {pin: [ground, c%zu], angle: u%zu}\n  A%zu: {pin: [c%zu, rod]%s}\n",
                     k, k, k, k, k, k == 1 ? ", angle: r" : "");
    c += snprintf(c, (size_t)(end - c), "drives: {u1: 50 deg}\nstart: {r: -50 deg");
    for (size_t k = 2; k < others + 3; k++) c += snprintf(c, (size_t)(end - c), ", u%zu: 50 deg", k);
    snprintf(c, (size_t)(end - c), "}\n");
    return machine_parse_with(text, NULL, 0);
}

// Returns by how much a further crank misses on the crossed branch of the parallelogram, where the rod is mirrored.
static double crossed_miss(double g, double x, double y, double u)
{
    double turn = 2 * atan2(-sin(u), g - cos(u)), c = cos(turn), s = sin(turn);
    return hypot(cos(u) + c * x - s * y - x, sin(u) + s * x + c * y - y) - 1;
}

// Counts where a third crank fits on the crossed branch, but in line with the ground, where both branches are the same.
static size_t count_crossed(double g, double x, double y)
{
    enum { STEPS = 20000 };
    size_t count = 0;
    for (int half = 0; half < 2; half++)
        for (int k = 1; k < STEPS - 1; k++) {
            double from = half * YK_PI + YK_PI * k / STEPS, to = half * YK_PI + YK_PI * (k + 1) / STEPS;
            count += (crossed_miss(g, x, y, from) > 0) != (crossed_miss(g, x, y, to) > 0);
        }
    return count;
}

// The cranks turn in parallel for ever, past the change points of the parallelogram, whose other branch the third crank
// does not let them take; it fits there in single poses alone, and two further ones never.
static void test_coupled_cranks_have_one_circuit(void **unused)
{
    (void)unused;
    uint64_t seed = 3;
    size_t singles = 0;
    for (uint64_t k = 0; k < check_cases(60); k++) {
        double g = check_uniform(&seed, 1.5, 4), x[2], y[2];
        size_t others = 1 + k % 2;
        for (size_t j = 0; j < 2; j++) {
            x[j] = check_uniform(&seed, -4, 4);
            y[j] = check_uniform(&seed, 0.2, 2);
        }
        Machine m = coupled_cranks(g, others, x, y);
        assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
        YkMap *map = map_of(&m);
        size_t fits = others == 1 ? count_crossed(g, x[0], y[0]) : 0, told = 0;
        const char *words = strstr(yk_map_message(map), "close in ");
        if (words) told = (size_t)strtoul(words + strlen("close in "), NULL, 10);
        if (told != fits) print_error("%.17g, %.17g, %.17g: %s\n", g, x[0], y[0], yk_map_message(map));
        assert_int_equal(told, fits);
        assert_int_equal(yk_map_is_complete(map), fits == 0);
        singles += fits;
        assert_int_equal(yk_map_circuit_count(map), 1);
        YkMapCircuit circuit = yk_map_circuit(map, 0);
        assert_true(circuit.contains_start && circuit.branches == 1 && circuit.events == 0 && circuit.ranges == 1);
        YkMapBranch branch = yk_map_branch(map, 0, 0);
        assert_true(branch.is_closed);
        CHECK_NEAR(yk_map_range(map, 0, 0).to - yk_map_range(map, 0, 0).from, 2 * YK_PI, 1e-9);
        for (size_t r = 0; r < branch.rows; r++) { // in parallel
            const double *row = yk_map_row(map, 0, 0, r);
            CHECK_NEAR(cos(row[yk_coordinate_find(m.mech, "u2")] - row[yk_coordinate_find(m.mech, "u1")]), 1, 1e-9);
            CHECK_NEAR(cos(row[yk_coordinate_find(m.mech, "u3")] - row[yk_coordinate_find(m.mech, "u1")]), 1, 1e-9);
        }
        compare(&m, map, "coupled cranks", 6);
        yk_map_free(map);
        machine_free(&m);
    }
    assert_true(singles > 0);
}

static void test_a_second_guide_changes_no_circuit(void **unused)
{
    (void)unused;
    Machine m = open_over("doubled-guide", NULL);
    YkMap *map = map_of(&m);
    assert_true(yk_map_is_complete(map));
    assert_int_equal(yk_map_circuit_count(map), 2);
    compare(&m, map, "doubled-guide", 40);
    yk_map_free(map);
    machine_free(&m);
}

// --- ways

// Returns the configuration at u whose coordinate is nearest to a value.
static YkMapPlace nearest_place(YkMap *map, const Machine *m, double u, const char *name, double value)
{
    YkMapPlace places[ALL_MAX], best = {0, 0, 0};
    double row[COORDINATES_MAX], nearest = INFINITY;
    size_t coordinate = yk_coordinate_find(m->mech, name), count = yk_map_places(map, u, places, ALL_MAX);
    assert_true(count > 0 && count <= ALL_MAX);
    for (size_t k = 0; k < count; k++) {
        assert_true(yk_map_coordinates_at(map, places[k], row));
        double off = fabs(yk_nearest_turn(row[coordinate] - value, 0));
        if (off >= nearest) continue;
        nearest = off;
        best = places[k];
    }
    return best;
}

static void test_the_other_branch_is_reached_over_a_limit(void **unused)
{
    (void)unused;
    Machine m = open_over("non-grashof", NULL);
    YkMap *map = map_of(&m);
    YkMapPlace way[8], a = nearest_place(map, &m, 0.5, "theta3", -1), b = nearest_place(map, &m, 0.5, "theta3", 1);
    assert_true(a.strand != b.strand);
    assert_int_equal(yk_map_way(map, a, b, way, 8), 3);
    assert_true(way[0].strand == a.strand && way[2].strand == b.strand);
    CHECK_NEAR(fabs(way[1].at), yk_map_range(map, 0, 0).to, 1e-8); // beside the limit
    assert_int_equal(yk_map_way(map, a, a, way, 8), 2);
    YkMapPlace start = yk_map_start(map);
    assert_true(start.circuit == 0 && start.strand != YK_NOT_FOUND);
    YkMapPlace wrong = {0, 99, 0.5};
    double row[COORDINATES_MAX];
    assert_int_equal(yk_map_way(map, a, wrong, way, 8), 0);
    assert_false(yk_map_coordinates_at(map, wrong, row));
    assert_int_equal(yk_map_places(map, 3.1, way, 8), 0); // beyond the limits
    yk_map_free(map);
    machine_free(&m);
}

// A way exists exactly where a sweep there and back, over every limit, meets both: here by circuits in closed form.
static void test_no_way_leads_to_another_circuit(void **unused)
{
    (void)unused;
    Machine m = open_over("four-bar", NULL);
    YkMap *map = map_of(&m);
    uint64_t seed = 5;
    for (int k = 0; k < 50; k++) {
        double u = check_uniform(&seed, -3, 3), v = check_uniform(&seed, -3, 3);
        YkMapPlace up = nearest_place(map, &m, u, "theta4", 1.6), down = nearest_place(map, &m, u, "theta4", -1.6);
        YkMapPlace other = nearest_place(map, &m, v, "theta4", 1.6);
        assert_int_equal(yk_map_way(map, up, other, NULL, 0), 2);
        assert_int_equal(yk_map_way(map, down, other, NULL, 0), 0);
    }
    yk_map_free(map);
    machine_free(&m);
}

// A lever that a block's pin turns closes wherever the block is: its circuits end where what is mapped of a distance
// ends, and belong to no joint and no coordinate there.
static void test_a_map_over_a_distance_ends_with_its_domain(void **unused)
{
    (void)unused;
    Machine m = machine_parse("bodies:\n  ground: {points: {O: [0, 0], C: [0, 1]}}\n  block: {points: {A: [0, 0]}}\n"
                              "  lever: {points: {C: [0, 0], E: [1, 0]}}\njoints:\n"
                              "  S: {slide: [ground, block], along: x, from: O, to: A, distance: s}\n"
                              "  C: {pin: [ground, lever], angle: u}\n"
                              "  A: {pin-slot: [lever, block], along: x, from: C, at: A}\nstart: {s: 0.3, u: -1}\n",
                              true);
    YkMap *map = map_of(&m);
    assert_true(yk_map_is_complete(map));
    assert_true(yk_map_circuit_count(map) >= 1);
    for (size_t c = 0; c < yk_map_circuit_count(map); c++) {
        YkRange range = yk_map_range(map, c, 0);
        assert_true(range.from < -1 && range.to > 1);
        assert_int_equal(yk_map_circuit(map, c).events, 2);
        bool is_seen[2] = {false, false};
        for (size_t e = 0; e < 2; e++) {
            YkMapEvent event = yk_map_event(map, c, e);
            assert_int_equal(event.kind, YK_MAP_END);
            assert_int_equal(event.block, -1);
            assert_true(event.coordinate == YK_NOT_FOUND);
            is_seen[0] |= event.at == range.from;
            is_seen[1] |= event.at == range.to;
        }
        assert_true(is_seen[0] && is_seen[1]);
    }
    yk_map_free(map);
    machine_free(&m);
}

static void test_wrong_indices_get_nothing(void **unused)
{
    (void)unused;
    Machine m = open_over("four-bar", NULL);
    YkMap *map = map_of(&m);
    assert_int_equal(yk_map_circuit(map, 9).branches, 0);
    assert_true(isnan(yk_map_range(map, 0, 9).from) && isnan(yk_map_event(map, 0, 9).at));
    assert_true(isnan(yk_map_event_value(map, 0, 9, 0)) && !yk_map_turn(map, 0, 99).is_full);
    assert_null(yk_map_row(map, 0, 9, 0));
    assert_null(yk_map_points(map, 0, 0, 100000));
    assert_int_equal(yk_map_branch(map, 9, 0).rows, 0);
    assert_false(yk_map_is_complete(NULL));
    assert_int_equal(yk_map_circuit_count(NULL), 0);
    assert_string_equal(yk_map_message(NULL), "");
    assert_int_equal(yk_map_coordinate(NULL), YK_NOT_FOUND);
    assert_null(yk_map_picture(NULL, NULL));
    yk_map_free(map);
    yk_map_free(NULL);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_four_bars_are_as_grashof_says),
        cmocka_unit_test(test_four_bars_near_change_points_turn_as_far_as_their_links_say),
        cmocka_unit_test(test_a_rocker_turns_back_where_the_links_say),
        cmocka_unit_test(test_every_configuration_is_on_the_map),
        cmocka_unit_test(test_the_double_butterfly_is_mapped),
        cmocka_unit_test(test_the_count_changes_at_limits_alone),
        cmocka_unit_test(test_random_machines_agree_with_solve_all),
        cmocka_unit_test(test_triads_beside_loops_agree_with_solve_all),
        cmocka_unit_test(test_branches_cross_at_change_points),
        cmocka_unit_test(test_a_geared_five_bar_repeats_after_whole_turns_of_both),
        cmocka_unit_test(test_a_slider_turns_back_at_its_dead_centres),
        cmocka_unit_test(test_a_slider_on_equal_links_has_both_limits),
        cmocka_unit_test(test_dead_points_are_limits_of_the_drive),
        cmocka_unit_test(test_a_start_at_a_limit_is_on_the_map),
        cmocka_unit_test(test_what_cannot_be_mapped_is_refused),
        cmocka_unit_test(test_a_cam_limits_what_it_moves),
        cmocka_unit_test(test_a_cam_alone_has_one_circuit),
        cmocka_unit_test(test_coupled_cranks_have_one_circuit),
        cmocka_unit_test(test_a_second_guide_changes_no_circuit),
        cmocka_unit_test(test_the_other_branch_is_reached_over_a_limit),
        cmocka_unit_test(test_no_way_leads_to_another_circuit),
        cmocka_unit_test(test_a_map_over_a_distance_ends_with_its_domain),
        cmocka_unit_test(test_wrong_indices_get_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
