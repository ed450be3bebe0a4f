// The choice of inputs: those asked for, then drives, then `start:`, then others; too many are reported by name.
#include "compile/inputs.h"
#include "machine.h"
#include "table.h"

#define FIVE_BAR                                                                                                       \
    "bodies:\n"                                                                                                        \
    "  ground: {points: {L: [0, 0], R: [2, 0]}}\n" LINK("a", "L", "A", "1") LINK("b", "A", "P", "2")                   \
        LINK("c", "R", "C", "1")                                                                                       \
            LINK("d", "C", "P", "2") "joints:\n"                                                                       \
                                     "  L: {pin: [ground, a], angle: p}\n  R: {pin: [ground, c], angle: q}\n  A: "     \
                                     "{pin: [a, b], angle: u}\n  C: {pin: [c, d], angle: v}\n"                         \
                                     "  P: {pin: [b, d]}\n"

static void check_inputs(const char *source, const char *const *asked, size_t count, const char *expected)
{
    char text[200];
    Machine m = machine_with(source, &(YkCompileOptions){asked, count});
    describe_inputs(m.mech, text, sizeof text);
    assert_string_equal(text, expected);
    for (size_t k = 0; k < yk_coordinate_count(m.mech); k++) { // both ways of asking agree
        int input = yk_coordinate_info(m.mech, k).input;
        if (input >= 0) assert_int_equal(yk_input_coordinate(m.mech, (size_t)input), k);
    }
    machine_free(&m);
}
#define ASKED(...) (const char *const[]){__VA_ARGS__}, sizeof((const char *const[]){__VA_ARGS__}) / sizeof(char *)

static void others_come_in_the_files_order(void **state)
{
    (void)state;
    check_inputs(FIVE_BAR, NULL, 0, "p, q");
}

static void start_comes_before_others(void **state)
{
    (void)state;
    check_inputs(FIVE_BAR "start: {v: 60 deg, u: 1}\n", NULL, 0, "v, u");
    check_inputs(FIVE_BAR "start: {v: 60 deg}\n", NULL, 0, "v, p");
}

static void positions_of_start_come_before_rates(void **state)
{
    (void)state;
    check_inputs(FIVE_BAR "start: {v.rate: 1, u: 1, q.rate: 2}\n", NULL, 0, "u, v");
}

static void drives_come_before_start(void **state)
{
    (void)state;
    check_inputs(FIVE_BAR "drives: {q: 1}\nstart: {v: 60 deg, u: 1}\n", NULL, 0, "q, v");
}

static void what_is_asked_for_comes_before_drives(void **state)
{
    (void)state;
    check_inputs(FIVE_BAR "drives: {q: 1}\nstart: {v: 60 deg, u: 1}\n", ASKED("u"), "u, q");
    check_inputs(FIVE_BAR "drives: {q: 1, p: 2}\n", ASKED("v", "u"), "v, u");
    check_inputs(FIVE_BAR "drives: {q: 1, p: 2}\n", ASKED("p"), "p, q");
    check_inputs(FIVE_BAR "drives: {q: 1, p: 2}\n", ASKED("p", "p", "p"),
                 "p, q"); // asking twice is not a contradiction
}

static void a_coordinate_asked_for_replaces_one_drive_only(void **state)
{
    (void)state;
    check_inputs(FIVE_BAR "drives: {q: 1, p: 2}\n", ASKED("u"), "u, q");
    check_inputs("four-bar", ASKED("gamma"), "gamma");
}

static void driven_coordinates_that_depend_on_each_other_are_reported_by_name(void **state)
{
    (void)state;
    machine_refused(
        "bodies:\n  ground: {points: {O: [0, 0], Q: [4, 0]}}\n" LINK("a", "O", "A", "1") LINK("b", "A", "B", "3.5")
            LINK("c", "Q", "B", "3") "joints: {O: {pin: [ground, a], angle: p}, A: {pin: [a, b], angle: q}, Q: {pin: "
                                     "[ground, c], angle: r}, B: {pin: [b, c]}}\n"
                                     "drives: {p: 1, r: 2}\n",
        NULL, YK_CODE_OVERDRIVEN, "`r` is driven, but the other drives already fix it: the machine has 1 freedom");
    machine_refused(FIVE_BAR "drives: {q: 1, p: 2, v: 3}\n", NULL, YK_CODE_OVERDRIVEN,
                    "`v` is driven, but the other drives already fix it: the machine has 2 freedoms");
    machine_refused(
        "bodies:\n  ground: {points: {A: [0, 0], B: [2, 0]}}\n" LINK("a", "A", "C", "1.5")
            LINK("b", "B", "C",
                 "1.2") "joints: {A: {pin: [ground, a], angle: p}, B: {pin: [ground, b], angle: q}, C: {pin: [a, b]}}\n"
                        "drives: {q: 2}\n",
        NULL, YK_CODE_OVERDRIVEN, "`q` is driven, but the joints already fix it: the machine has 0 freedoms");
}

// Counting alone would let three drives pass on three freedoms, two of them on the same four-bar.
static void drives_count_where_they_act(void **state)
{
    (void)state;
    char text[4000];
    snprintf(text, sizeof text, "%sdrives: {t2: 1, t4: 2}\n", two_four_bars);
    machine_refused(text, NULL, YK_CODE_OVERDRIVEN, "`t4`");
    snprintf(text, sizeof text, "%sdrives: {u2: 1, t4: 2}\n", two_four_bars);
    check_inputs(text, NULL, 0, "u2, t4");
}

static void a_drive_on_a_redundant_machine_is_judged_by_rank(void **state)
{
    (void)state;
    char text[4000];
    snprintf(text, sizeof text, "%sdrives: {t2: 40 deg}\n", four_cranks); // Gruebler counts -1
    check_inputs(text, NULL, 0, "t2");
    snprintf(text, sizeof text, "%sdrives: {t2: 40 deg, t3: 40 deg}\n", four_cranks);
    machine_refused(text, NULL, YK_CODE_OVERDRIVEN, "`t3`");
}

// Freedom and inputs do not depend on how large a machine is, nor on whether it starts on a fold, where the rank drops.
static void the_size_of_a_machine_does_not_change_its_freedom(void **state)
{
    (void)state;
    static const char cranks[] =
        "parameters: {k: 1 m, from: 1 rad}\nbodies:\n  ground: {points: {O: [0, 0], Q: [3*k, 0], P: [5*k, 0], G: [2*k, "
        "0]}}\n"
        "  a: {points: {O: [0, 0], A: [0.8*k, 0]}}\n  b: {points: {A: [0, 0], B: [3*k, 0], D: [5*k, 0]}}\n"
        "  c: {points: {Q: [0, 0], B: [0.8*k, 0]}}\n  d: {points: {P: [0, 0], D: [0.8*k, 0]}}\n"
        "  block: {points: {S: [0, 0]}}\njoints:\n  O: {pin: [ground, a], angle: th}\n"
        "  Q: {pin: [ground, c], angle: ps}\n  P: {pin: [ground, d], angle: ph}\n  A: {pin: [a, b], angle: u}\n"
        "  B: {pin: [b, c]}\n  D: {pin: [b, d]}\n  G: {slide: [ground, block], along: y, from: G, to: S, distance: y}\n"
        "  S: {pin-slot: [b, block], along: x, from: A, at: S}\ndrives: {th: from}\n"
        "start: {ps: from, ph: from, u: -from, y: 0.8*k*sin(from)}\n";
    static const char *const sizes[] = {"1e-4 m", "1e-2 m", "1 m", "1e3 m", "1e6 m"}, *const starts[] = {"1 rad",
                                                                                                         "0 rad",
                                                                                                         "0.001 rad"};
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++)
        for (size_t from = 0; from < sizeof starts / sizeof *starts; from++) {
            char text[200];
            YkOverride overrides[] = {{"k", sizes[k]}, {"from", starts[from]}};
            Machine m = machine_try_with(cranks, &(YkLoadOptions){overrides, 2, NULL}, NULL);
            if (!m.mech) print_error("%s, %s: %s", sizes[k], starts[from], yk_problems_text(m.problems, 0));
            assert_non_null(m.mech);
            YkFreedom freedom = yk_mechanism_freedom(m.mech);
            if (freedom.by_rank != 1) print_error("%s, %s: %d\n", sizes[k], starts[from], freedom.by_rank);
            assert_int_equal(freedom.by_rank, 1);
            assert_int_equal(freedom.gruebler, 0);
            assert_int_equal(freedom.redundant, 1);
            describe_inputs(m.mech, text, sizeof text);
            assert_string_equal(text, "th");
            machine_free(&m);
        }
}

// Two bars in line between pivots as far apart as both are long: they shake, to first order, but no pose is near.
static void bars_in_line_are_rigid(void **state)
{
    (void)state;
    Machine m = machine("bodies:\n  ground: {points: {O: [0, 0], P: [2, 0]}}\n  a: {points: {O: [0, 0], A: [1, 0]}}\n"
                        "  b: {points: {A: [0, 0], P: [1, 0]}}\njoints:\n  O: {pin: [ground, a], angle: th}\n"
                        "  A: {pin: [a, b], angle: u}\n  P: {pin: [ground, b]}\nstart: {th: 0, u: 0}\n");
    assert_int_equal(yk_mechanism_freedom(m.mech).by_rank, 0);
    assert_int_equal(yk_input_count(m.mech), 0);
    machine_free(&m);
}

static void too_many_asked_for_are_reported_by_name(void **state)
{
    (void)state;
    machine_refused("four-bar", &(YkCompileOptions){ASKED("theta4", "gamma")}, YK_CODE_OVERDRIVEN,
                    "coordinate `gamma` cannot be set as well");
    machine_refused(FIVE_BAR, &(YkCompileOptions){ASKED("p", "q", "u")}, YK_CODE_OVERDRIVEN,
                    "`u` cannot be set as well: the machine has 2 freedoms");
}

static void unknown_ones_are_reported_by_name(void **state)
{
    (void)state;
    machine_refused("four-bar", &(YkCompileOptions){ASKED("theta9")}, YK_CODE_UNKNOWN_INPUT, "no coordinate `theta9`");
}

static void refusals_do_not_need_a_list_of_problems(void **state)
{
    (void)state;
    Machine m = machine("four-bar");
    assert_null(yk_mechanism_compile(m.model, &(YkCompileOptions){ASKED("theta4", "gamma")}, NULL));
    assert_null(yk_mechanism_compile(m.model, &(YkCompileOptions){ASKED("theta9")}, NULL));
    YkMechanism *mech = yk_mechanism_compile(m.model, NULL, NULL);
    assert_non_null(mech);
    yk_mechanism_free(mech);
    machine_free(&m);
}

static void undeclared_machines_get_names_of_their_joints(void **state)
{
    (void)state;
    char text[200];
    Machine m = machine("bodies: {a: {}, b: {}}\njoints: {P: {pin: [ground, a]}, S: {slide: [a, b], along: x}}\n");
    describe_coordinates(m.mech, text, sizeof text);
    assert_string_equal(text, "P.angle, S.distance");
    for (size_t k = 0; k < 2; k++) {
        YkCoordinateInfo info = yk_coordinate_info(m.mech, k);
        assert_false(info.is_declared);
        assert_false(info.has_drive);
        assert_int_equal(info.is_distance, k == 1);
        assert_int_equal(info.joint, k);
    }
    machine_free(&m);
    m = machine("bodies: {a: {points: {K: [1, 0]}}, ground: {}}\njoints: {K: {pin-slot: [ground, a], along: x}, P: "
                "{slide: [ground, a], along: y}}\n");
    describe_coordinates(m.mech, text, sizeof text);
    assert_string_equal(text, "P.distance"); // a slide is preferred to a pin-slot, which closes the loop
    machine_free(&m);
}

static void names_may_be_given_by_mention(void **state)
{
    (void)state;
    check_inputs("bodies: {a: {}, b: {}}\njoints: {P: {pin: [ground, a]}, S: {slide: [a, b], along: x}}\ndrives: "
                 "{S.distance: 1}\nstart: {P.angle: 1}\n",
                 NULL, 0, "S.distance, P.angle");
    check_inputs(undeclared, ASKED("Q.angle"), "Q.angle");
}

static void the_guess_is_start_and_drives_at_time_zero(void **state)
{
    (void)state;
    double guess[4];
    Machine m = machine(FIVE_BAR "drives: {q: 1.5 + 3 rad/s * t}\nstart: {v: 0.25, q: 9, v.rate: 4}\n");
    yk_start_guess(m.mech, guess);
    const double expected[] = {0, 1.5, 0, 0.25}; // p, q, u, v
    for (size_t k = 0; k < 4; k++) CHECK_NEAR(guess[k], expected[k], 0);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(others_come_in_the_files_order),
        cmocka_unit_test(start_comes_before_others),
        cmocka_unit_test(positions_of_start_come_before_rates),
        cmocka_unit_test(drives_come_before_start),
        cmocka_unit_test(what_is_asked_for_comes_before_drives),
        cmocka_unit_test(a_coordinate_asked_for_replaces_one_drive_only),
        cmocka_unit_test(driven_coordinates_that_depend_on_each_other_are_reported_by_name),
        cmocka_unit_test(drives_count_where_they_act),
        cmocka_unit_test(a_drive_on_a_redundant_machine_is_judged_by_rank),
        cmocka_unit_test(the_size_of_a_machine_does_not_change_its_freedom),
        cmocka_unit_test(bars_in_line_are_rigid),
        cmocka_unit_test(too_many_asked_for_are_reported_by_name),
        cmocka_unit_test(unknown_ones_are_reported_by_name),
        cmocka_unit_test(refusals_do_not_need_a_list_of_problems),
        cmocka_unit_test(undeclared_machines_get_names_of_their_joints),
        cmocka_unit_test(names_may_be_given_by_mention),
        cmocka_unit_test(the_guess_is_start_and_drives_at_time_zero),
    };
    return cmocka_run_group_tests_name("compile/inputs", tests, NULL, NULL);
}
