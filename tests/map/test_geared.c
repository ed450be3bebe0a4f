// Maps of machines with gears and racks among their loops: at random inputs they have as many places as a fine walk
// finds by closed form, and those that `solve --all` lists; events stand where the walk's count changes.
#include <yoke/configurations.h>
#include <yoke/map.h>
#include "configurations/geared_chain.h"
#include "map/map.h"
#include "map/meshed.h"

enum { PLACES_MAX = 128 };

static YkMap *map_of(Machine *m)
{
    assert_true(yk_state_set_time(m->state, 0, m->problems) >= 0 && yk_state_assemble(m->state) >= 0);
    YkMap *map = yk_map_new(m->state, yk_input_coordinate(m->mech, 0), m->problems);
    if (!map) print_error("%s", yk_problems_text(m->problems, 0));
    assert_non_null(map);
    return map;
}

// Returns the distance of an input from the nearest event of a map.
static double event_near(const YkMap *map, double at)
{
    double nearest = 10;
    for (size_t c = 0; c < yk_map_circuit_count(map); c++)
        for (size_t k = 0; k < yk_map_circuit(map, c).events; k++)
            nearest = fmin(nearest, fabs(yk_nearest_turn(yk_map_event(map, c, k).at - at, 0)));
    return nearest;
}

static size_t places_at(const YkMap *map, double at)
{
    YkMapPlace places[PLACES_MAX];
    return yk_map_places(map, at, places, PLACES_MAX);
}

static void test_geared_five_bars_have_the_places_of_a_walk(void **unused)
{
    (void)unused;
    uint64_t seed = 21;
    size_t proved = 0, cases = check_cases(3), compared = 0, most = 0;
    for (size_t k = 0; k < cases; k++) {
        Chain chain = {.teeth = {10 + 10 * (int)(3 * check_uniform(&seed, 0, 1)), 20}};
        for (int j = 0; j < LINKS; j++) {
            chain.length[j] = check_uniform(&seed, 0.5, 3);
            chain.angle[j] = check_uniform(&seed, -YK_PI, YK_PI);
        }
        Machine m = machine_of(&chain);
        YkMap *map = map_of(&m);
        if (!yk_map_is_complete(map)) print_message("case %zu: %s\n", k, yk_map_message(map));
        proved += yk_map_is_complete(map);
        assert_true(yk_map_circuit(map, 0).contains_start);
        for (int p = 0; p < 20; p++) {
            double at = check_uniform(&seed, -YK_PI, YK_PI);
            chain.turned = at - chain.angle[A];
            if (event_near(map, at) < 1e-3) continue;
            size_t count = places_at(map, at), walked = count_along(&chain);
            if (count != walked) print_error("case %zu at %.17g: %zu, walked %zu\n", k, at, count, walked);
            assert_int_equal(count, walked);
            compared++;
            most = count > most ? count : most;
        }
        // At a limit two places come or go.
        for (size_t c = 0; c < yk_map_circuit_count(map); c++)
            for (size_t e = 0; e < yk_map_circuit(map, c).events; e++) {
                YkMapEvent event = yk_map_event(map, c, e);
                size_t before, after;
                assert_int_equal(event.kind, YK_MAP_LIMIT);
                chain.turned = event.at - 1e-5 - chain.angle[A];
                before = count_along(&chain);
                chain.turned = event.at + 1e-5 - chain.angle[A];
                after = count_along(&chain);
                assert_int_equal(before > after ? before - after : after - before, 2);
            }
        yk_map_free(map);
        machine_free(&m);
    }
    assert_true(proved == cases);
    assert_true(compared > 15 * cases && most >= 4);
}

// The limits of the example, which looks the same from both sides of the ground line, are found in pairs, and where its
// loop and its mesh have dependent derivatives, from the file's lengths: a determinant of 3 by 3.
static void test_limits_are_where_the_determinant_vanishes(void **unused)
{
    (void)unused;
    Machine m = machine_open("geared-five-bar", NULL);
    YkMap *map = map_of(&m);
    assert_true(yk_map_is_complete(map));
    assert_int_equal(yk_map_circuit_count(map), 7);
    size_t events = 0;
    double sum = 0;
    for (size_t c = 0; c < yk_map_circuit_count(map); c++)
        for (size_t e = 0; e < yk_map_circuit(map, c).events; e++) {
            double angle[4], turn = 0;
            static const char *const names[] = {"t1", "t2", "t3", "t4"};
            static const double length[] = {1, 2.5, 2, 2.2};
            for (int k = 0; k < 4; k++)
                angle[k] = turn += yk_map_event_value(map, c, e, yk_coordinate_find(m.mech, names[k]));
            // b, c and d turn by w such that the loop closes and 20 (w_b - w_c) + 30 (w_d - w_c) = 0.
            YkVec v[4];
            for (int k = 0; k < 4; k++) v[k] = yk_scale(length[k], yk_unit(angle[k]));
            double det = 20 * yk_cross(v[2], v[3]) + 50 * yk_cross(v[1], v[3]) + 30 * yk_cross(v[1], v[2]);
            CHECK_NEAR(det, 0, 1e-3); // at poses known to about 1e-5
            sum += yk_map_event(map, c, e).at;
            events++;
        }
    assert_int_equal(events, 6);
    CHECK_NEAR(sum, 0, 1e-9);
    yk_map_free(map);
    machine_free(&m);
}

// --- a gear on a rocker, outside of loops

static Machine wheel_machine(double crank, double coupler, double rocker, double ground, int teeth)
{
    char text[1500];
    snprintf(text, sizeof text,
             "bodies:\n  ground: {points: {A: [0, 0], D: [%.17g, 0], W: [9, 0]}}\n"
             "  crank: {points: {A: [0, 0], B: [%.17g, 0]}}\n  coupler: {points: {B: [0, 0], C: [%.17g, 0]}}\n"
             "  rocker: {points: {D: [0, 0], C: [%.17g, 0]}}\n  wheel: {points: {W: [0, 0]}}\njoints:\n"
             "  A: {pin: [ground, crank], angle: u}\n  B: {pin: [crank, coupler]}\n  C: {pin: [coupler, rocker]}\n"
             "  D: {pin: [ground, rocker], angle: d}\n  W: {pin: [ground, wheel], angle: w}\n"
             "gears: {g: {mesh: [rocker, wheel], teeth: [20, %d]}}\ndrives: {u: 1}\nstart: {d: 1.5}\n",
             ground, crank, coupler, rocker, teeth);
    return machine_parse_with(text, NULL, 0);
}

static void test_a_wheel_on_a_rocker_stands_in_every_phase_of_its_mesh(void **unused)
{
    (void)unused;
    // A rocker that swings keeps the phase of its wheel; one that turns fully goes through all of them.
    Machine swings = wheel_machine(1, 2.5, 2, 3, 30), turns = wheel_machine(4, 4.5, 4.2, 1, 30);
    YkMap *map = map_of(&swings);
    assert_true(yk_map_is_complete(map));
    assert_int_equal(yk_map_circuit_count(map), 2 * 3);
    assert_int_equal(places_at(map, 0.7), 2 * 3);
    assert_false(yk_map_turn(map, 0, 4).is_full);
    YkRange rocker = yk_map_turn(map, 0, 3).range, wheel = yk_map_turn(map, 0, 4).range;
    CHECK_NEAR(wheel.to - wheel.from, (rocker.to - rocker.from) * 20 / 30, 1e-8);
    yk_map_free(map);
    map = map_of(&turns);
    assert_true(yk_map_is_complete(map));
    assert_int_equal(yk_map_circuit_count(map), 2);
    assert_int_equal(places_at(map, 0.7), 2 * 3);
    assert_true(yk_map_turn(map, 0, 4).is_full);
    CHECK_NEAR(yk_map_branch(map, 0, 0).to - yk_map_branch(map, 0, 0).from, 3 * 2 * YK_PI, 1e-9);
    yk_map_free(map);
    machine_free(&swings);
    machine_free(&turns);
}

// --- a rack in a group

// A wheel on the end of a crank that a link holds, and a rack that a carrier leads past it and another link holds. No
// relation tells the input, so all repeats after a turn of the crank.
static void test_a_group_with_a_rack_repeats_after_a_turn(void **unused)
{
    (void)unused;
    Machine m = machine_parse(
        "bodies:\n  ground: {points: {O: [0, 0], E: [3, 0], F: [2, 3]}}\n  crank: {points: {O: [0, 0], A: [0.4, 0]}}\n"
        "  carrier: {points: {A: [0, 0]}}\n  wheel: {points: {A: [0, 0], W: [0.3, 0]}}\n"
        "  bar: {points: {R: [0, 0]}}\n  l1: {points: {W: [0, 0], E: [2.8, 0]}}\n  l2: {points: {R: [0, 0], F: [2.5, "
        "0]}}\n"
        "joints:\n  O: {pin: [ground, crank], angle: u}\n  A: {pin: [crank, carrier], angle: c}\n"
        "  B: {pin: [carrier, wheel], at: A, angle: w}\n  S: {slide: [carrier, bar], along: x, distance: s}\n"
        "  W: {pin: [wheel, l1]}\n  E: {pin: [l1, ground]}\n  R: {pin: [bar, l2]}\n  F: {pin: [l2, ground]}\n"
        "racks: {r: {pinion: wheel, rack: bar, radius: 0.5}}\ndrives: {u: 1}\nstart: {c: 60 deg, w: 20 deg, s: 1}\n",
        true);
    YkTracer t = {.is_angle = true, .scale = 1, .start = m.state};
    double inputs[] = {1};
    assert_true(yk_tracer_begin(&t, m.mech));
    t.discs.mapped = t.over.mapped = 0;
    t.discs.others = t.over.others = inputs;
    bool is_read = yk_tracer_read(&t, m.problems), is_meshed = false;
    if (!is_read) print_error("%s", yk_problems_text(m.problems, 0));
    for (size_t k = 0; k < t.piece_count; k++)
        is_meshed |= t.pieces[k].meshed && t.pieces[k].meshed->geared.relations > 0;
    assert_true(is_read && is_meshed);
    CHECK_NEAR(yk_tracer_period(&t), 2 * YK_PI, 1e-15);
    yk_tracer_end(&t);
    machine_free(&m);
}

// Where nothing has to be closed, the rows of a gear train are its poses at equal steps of the whole domain.
static void test_rows_of_a_gear_train_are_equal_steps(void **unused)
{
    (void)unused;
    Machine m = machine_load("planetary-gear");
    YkMap *map = map_of(&m);
    YkMapBranch branch = yk_map_branch(map, 0, 0);
    YkRange domain = yk_map_domain(map);
    size_t count = yk_coordinate_count(m.mech), input = yk_map_coordinate(map);
    assert_int_equal(yk_map_circuit_count(map), 1);
    assert_true(branch.rows > 20 && branch.is_closed);
    double step = (domain.to - domain.from) / (double)(branch.rows - 1);
    assert_true(step < 0.06);
    for (size_t row = 1; row < branch.rows; row++)
        for (size_t k = 0; k < count; k++) {
            double by = yk_map_row(map, 0, 0, row)[k] - yk_map_row(map, 0, 0, row - 1)[k];
            double first = yk_map_row(map, 0, 0, 1)[k] - yk_map_row(map, 0, 0, 0)[k];
            CHECK_NEAR(by, first, 1e-11);
            if (k == input) CHECK_NEAR(by, step, 1e-11);
        }
    yk_map_free(map);
    machine_free(&m);
}

// --- a law of the input among a group's equations

// A five-bar whose third angle follows a law of its crank. It closes as a four-bar does whose coupler is that long;
// there are limits where the ends of crank and ground are as far apart as coupler and rocker together, or without each
// other.
static void test_a_law_of_the_input_counts_once(void **unused)
{
    (void)unused;
    static const char *const text = "laws: {lift: {period: 2*pi, segments: [\n"
                                    "  {rise: {to: 180 deg, by: 40 deg, law: cycloidal}},\n"
                                    "  {fall: {to: 360 deg, by: 40 deg, law: cycloidal}}]}}\nbodies:\n"
                                    "  ground: {points: {A: [0, 0], E: [3, 0]}}\n"
                                    "  a: {points: {A: [0, 0], B: [1, 0]}}\n"
                                    "  b: {points: {C: [0, 0], B: [-2.5, 0]}}\n"
                                    "  c: {points: {C: [0, 0], D: [2, 0]}}\n"
                                    "  d: {points: {D: [0, 0], E: [2.2, 0]}}\njoints:\n"
                                    "  A: {pin: [ground, a], angle: t1}\n  B: {pin: [a, b], angle: t2}\n"
                                    "  C: {pin: [b, c], angle: t3}\n  D: {pin: [c, d], angle: t4}\n"
                                    "  E: {pin: [ground, d]}\ndrives: {t1: 1, t3: {law: lift, of: t1}}\n"
                                    "start: {t2: -30 deg, t4: -60 deg}\n";
    Machine m = machine_parse(text, true);
    YkMap *map = map_of(&m);
    size_t limits = 0;
    if (!yk_map_is_complete(map)) print_error("%s\n", yk_map_message(map));
    assert_true(yk_map_is_complete(map));
    for (int k = 0; k < 40; k++) {
        double at = -3.1 + 0.157 * k, part = (at < 0 ? -at : at) / YK_PI; // it falls as it rises
        double bend = 40 * YK_PI / 180 * (part - sin(2 * YK_PI * part) / (2 * YK_PI));
        double coupler = hypot(2.5 + 2 * cos(bend), 2 * sin(bend)), far = hypot(3 - cos(at), sin(at));
        if (event_near(map, at) < 1e-3) continue;
        assert_int_equal(places_at(map, at), far > fabs(coupler - 2.2) && far < coupler + 2.2 ? 2 : 0);
    }
    for (size_t c = 0; c < yk_map_circuit_count(map); c++)
        for (size_t e = 0; e < yk_map_circuit(map, c).events; e++)
            limits += yk_map_event(map, c, e).kind == YK_MAP_LIMIT;
    assert_int_equal(limits, 2);
    yk_map_free(map);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_a_law_of_the_input_counts_once),
                                       cmocka_unit_test(test_a_group_with_a_rack_repeats_after_a_turn),
                                       cmocka_unit_test(test_rows_of_a_gear_train_are_equal_steps),
                                       cmocka_unit_test(test_geared_five_bars_have_the_places_of_a_walk),
                                       cmocka_unit_test(test_limits_are_where_the_determinant_vanishes),
                                       cmocka_unit_test(test_a_wheel_on_a_rocker_stands_in_every_phase_of_its_mesh)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
