// Strokes and time ratios against closed forms and the textbook's figures.
#include <yoke/design.h>
#include "compile/machine.h"
#include "compile/table.h"

typedef struct Ready {
    Machine machine;
    YkState *state;
} Ready;

static Ready ready(const char *source, const YkLoadOptions *load)
{
    Ready r = {.machine = machine_try_with(source, load, NULL)};
    if (!r.machine.mech) print_error("%s", yk_problems_text(r.machine.problems, 0));
    assert_non_null(r.machine.mech);
    r.state = yk_state_new(r.machine.mech);
    assert_int_equal(yk_state_set_time(r.state, 0, NULL), YK_OK);
    YkStatus status = yk_state_assemble(r.state);
    if (status < 0) print_error("%s\n%s\n", source, yk_state_report(r.state)->message);
    assert_true(status >= 0);
    return r;
}
static void done(Ready *r)
{
    yk_state_free(r->state);
    machine_free(&r->machine);
}

static YkStatus stroke_of(Ready *r, const char *channel, YkStroke *stroke)
{
    YkChannel c;
    assert_int_equal(yk_channel_parse(r->machine.mech, channel, &c, r->machine.problems), YK_OK);
    return yk_stroke(r->state, 0, c, stroke);
}
static YkStroke stroke(Ready *r, const char *channel)
{
    YkStroke s;
    assert_int_equal(stroke_of(r, channel, &s), YK_OK);
    return s;
}

static double turn_between(double a, double b)
{
    return remainder(a - b, 2 * YK_PI);
}

// --- quick returns: Khurmi and Gupta, Theory of Machines, ch. 5
// ----------------------------------------------------------

static void shapers_have_the_time_ratio_and_stroke_of_the_textbook(void **state)
{
    (void)state;
    static const struct {
        const char *c, *r;
        double ratio;
    } cases[] = {{"300", "120", 1.7099527817214106}, {"240", "120", 2}}; // examples 5.1, 5.2
    for (size_t k = 0; k < 2; k++) {
        const YkOverride values[] = {{"c", cases[k].c}, {"r", cases[k].r}};
        Ready r = ready("crank-slotted-lever", &(YkLoadOptions){values, 2});
        YkStroke s = stroke(&r, "x");
        double sine = atof(cases[k].r) / atof(cases[k].c), half = asin(sine);
        CHECK_NEAR(s.ratio, cases[k].ratio, 1e-9);
        CHECK_NEAR(s.ratio, (YK_PI + 2 * half) / (YK_PI - 2 * half), 1e-9);
        CHECK_NEAR(s.high - s.low, 2 * 0.45 * sine, 1e-12); // 450 mm in example 5.2
        CHECK_NEAR(s.high, -s.low, 1e-12);
        done(&r);
    }
}

static void whitworth_has_the_time_ratio_of_the_textbook(void **state)
{
    (void)state;
    Ready r = ready("whitworth-kg", NULL);
    // the ram's own extremes lie where the lever points along the ram's line: crank at asin(c / r) to it
    YkStroke s = stroke(&r, "x");
    double half = acos(50.0 / 75);
    CHECK_NEAR(s.ratio, 2.735239182632302, 1e-9); // example 5.4
    CHECK_NEAR(s.ratio, (YK_PI - half) / half, 1e-9);
    CHECK_NEAR(s.high - s.low, 2 * 0.04375, 1e-12);
    done(&r);
}

static void the_time_ratio_does_not_ask_which_way_the_crank_starts(void **state)
{
    (void)state;
    Ready r = ready("whitworth-kg", NULL);
    for (int k = -12; k < 12; k++) {
        YkMotion m = yk_state_input(r.state, 0);
        m.position = k * YK_PI / 6 + 0.01;
        yk_state_set_input(r.state, 0, m);
        assert_int_equal(yk_state_solve(r.state), YK_OK);
        CHECK_NEAR(stroke(&r, "x").ratio, 2.735239182632302, 1e-9);
    }
    done(&r);
}

// --- slider-cranks
// ------------------------------------------------------------------------------------------------------

static void slider_crank(char *text, size_t capacity, double a, double b, double c, double start)
{
    snprintf(text, capacity,
             "parameters: {a: %.17g, b: %.17g, c: %.17g, go: %.17g rad}\n"
             "bodies:\n  ground: {points: {K: [0, 0], G: [0, c]}}\n" LINK("crank", "K", "A", "a")
                 LINK("rod", "A", "B",
                      "b") "  block: {points: {B: [0, 0]}}\n"
                           "joints: {K: {pin: [ground, crank], angle: th}, A: {pin: [crank, rod]}, B: {pin: [rod, "
                           "block]}, S: {slide: [ground, block], along: x, from: G, distance: d}}\n"
                           "drives: {th: go + 1 rad/s * t}\nstart: {d: b}\n",
             a, b, c, start);
}

static void offset_slider_cranks_have_the_closed_forms(void **state)
{
    (void)state;
    uint64_t seed = 71;
    for (int trial = 0; trial < 60; trial++) {
        char text[1500];
        double a = check_uniform(&seed, 0.2, 1), b = a * check_uniform(&seed, 1.8, 5),
               c = (b - a) * check_uniform(&seed, -0.9, 0.9);
        slider_crank(text, sizeof text, a, b, c, check_uniform(&seed, -3, 3));
        Ready r = ready(text, NULL);
        YkStroke s = stroke(&r, "d");
        // stretched: crank and rod in line; folded: rod back over the crank
        double out = asin(c / (a + b)), in = YK_PI + asin(c / (b - a));
        double there = fabs(in - out), back = 2 * YK_PI - there;
        if (fabs(s.high - sqrt((a + b) * (a + b) - c * c)) > 1e-12)
            print_error("trial %d of seed 71: %g %g %g\n", trial, a, b, c);
        CHECK_NEAR(s.high, sqrt((a + b) * (a + b) - c * c), 1e-12 * b);
        CHECK_NEAR(s.low, sqrt((b - a) * (b - a) - c * c), 1e-12 * b);
        CHECK_NEAR(turn_between(s.high_at, out), 0, 1e-9);
        CHECK_NEAR(turn_between(s.low_at, in), 0, 1e-9);
        CHECK_NEAR(s.ratio, fmax(there, back) / fmin(there, back), 1e-9);
        assert_true(s.ratio >= 1);
        done(&r);
    }
}

// An extreme exactly where the turn begins, and so ends, is found, and once.
static void a_turn_may_begin_at_an_extreme(void **state)
{
    (void)state;
    for (int k = -2; k < 3; k++) {
        char text[1500];
        slider_crank(text, sizeof text, 1, 3, 0, k * YK_PI);
        Ready r = ready(text, NULL);
        YkStroke s = stroke(&r, "d");
        CHECK_NEAR(s.high, 4, 1e-12);
        CHECK_NEAR(s.low, 2, 1e-12);
        CHECK_NEAR(s.ratio, 1, 1e-9);
        done(&r);
    }
}

static void the_state_is_left_as_it_was(void **state)
{
    (void)state;
    Ready r = ready("offset-slider-crank", NULL);
    YkMotion input = yk_state_input(r.state, 0), before = yk_state_coordinate(r.state, 2);
    stroke(&r, "d");
    YkMotion after = yk_state_coordinate(r.state, 2);
    CHECK_NEAR(yk_state_input(r.state, 0).position, input.position, 0);
    CHECK_NEAR(after.position, before.position, 0);
    CHECK_NEAR(after.velocity, before.velocity, 0);
    done(&r);
}

// Rockers: the angle between the extremes of a crank-rocker from the two triangles in which crank and coupler are in
// line.
static void crank_rockers_swing_between_their_stretched_and_folded_positions(void **state)
{
    (void)state;
    Ready r = ready("four-bar", NULL); // 100, 40, 120, 80 mm
    YkStroke s = stroke(&r, "theta4");
    double f = 100, a = 40, c = 120, b = 80;
    double stretched = acos((f * f + b * b - (a + c) * (a + c)) / (2 * f * b)),
           folded = acos((f * f + b * b - (c - a) * (c - a)) / (2 * f * b));
    CHECK_NEAR(s.high - s.low, stretched - folded, 1e-12); // angles at the rocker's pivot
    CHECK_NEAR(s.high, YK_PI - folded, 1e-12);
    done(&r);
}

static void what_cannot_turn_through_has_no_stroke(void **state)
{
    (void)state;
    YkStroke s;
    Ready r = ready("non-grashof", NULL);
    assert_int_equal(stroke_of(&r, "theta4", &s), YK_LIMIT);
    done(&r);
}

// A wheel that turns ten times in eleven turns of the crank comes back elsewhere, though its point moves to and fro.
static void turns_that_differ_have_no_stroke(void **state)
{
    (void)state;
    static const char *const teeth[] = {"[20, 22]", "[20, 20]"};
    for (size_t k = 0; k < 2; k++) {
        char text[600];
        snprintf(text, sizeof text,
                 "bodies:\n  ground: {points: {O: [0, 0], W: [3, 0]}}\n  crank: {points: {O: [0, 0]}}\n"
                 "  wheel: {points: {W: [0, 0], P: [0.4, 0.3]}}\n"
                 "joints: {O: {pin: [ground, crank], angle: theta}, W: {pin: [ground, wheel], angle: psi}}\n"
                 "gears: {g: {mesh: [crank, wheel], teeth: %s}}\ndrives: {theta: 1 rad/s * t}\n",
                 teeth[k]);
        Ready r = ready(text, NULL);
        YkStroke s;
        assert_int_equal(stroke_of(&r, "wheel.P.x", &s), k == 0 ? YK_BAD_ARGUMENT : YK_OK);
        done(&r);
    }
}

static void what_has_not_two_extremes_has_no_stroke(void **state)
{
    (void)state;
    YkStroke s;
    Ready r = ready("drag-link", NULL);
    assert_int_equal(stroke_of(&r, "theta4", &s), YK_BAD_ARGUMENT); // it turns on and on
    assert_int_equal(stroke_of(&r, "theta2", &s), YK_BAD_ARGUMENT);
    done(&r);
}

static void an_input_that_slides_has_no_turn(void **state)
{
    (void)state;
    YkStroke s;
    Ready r = ready(yoke_driven_by_slide, NULL);
    assert_int_equal(stroke_of(&r, "th", &s), YK_BAD_ARGUMENT);
    done(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shapers_have_the_time_ratio_and_stroke_of_the_textbook),
        cmocka_unit_test(whitworth_has_the_time_ratio_of_the_textbook),
        cmocka_unit_test(the_time_ratio_does_not_ask_which_way_the_crank_starts),
        cmocka_unit_test(offset_slider_cranks_have_the_closed_forms),
        cmocka_unit_test(a_turn_may_begin_at_an_extreme),
        cmocka_unit_test(the_state_is_left_as_it_was),
        cmocka_unit_test(crank_rockers_swing_between_their_stretched_and_folded_positions),
        cmocka_unit_test(what_cannot_turn_through_has_no_stroke),
        cmocka_unit_test(turns_that_differ_have_no_stroke),
        cmocka_unit_test(what_has_not_two_extremes_has_no_stroke),
        cmocka_unit_test(an_input_that_slides_has_no_turn),
    };
    return cmocka_run_group_tests_name("design/stroke", tests, NULL, NULL);
}
