// Wheels in drawings: radii that touch at the pitch point, a mark for every tooth, marks that meet.
#include "check.h"
#include <stdlib.h>
#include <yoke/yoke.h>
#include "picture/drawing/drawing.h"

static YkGear gear(int64_t a, int64_t b, bool is_internal, double distance, double module)
{
    return (YkGear){.teeth = {a, b}, .is_internal = is_internal, .center_distance = distance, .module = module};
}

static void pitch_circles_touch(void **unused)
{
    (void)unused;
    YkGear outside = gear(27, 36, false, 0.063, 0), inside = gear(24, 87, true, 0.063, 0),
           bare = gear(20, 30, false, 0, 0.002);
    CHECK_NEAR(yk_drawing_pitch_radius(&outside, 0) + yk_drawing_pitch_radius(&outside, 1), 0.063, 1e-16);
    CHECK_NEAR(yk_drawing_pitch_radius(&inside, 1) - yk_drawing_pitch_radius(&inside, 0), 0.063, 1e-16);
    CHECK_NEAR(yk_drawing_pitch_radius(&bare, 1), 0.030, 1e-16);
    CHECK_NEAR(yk_drawing_pitch_radius(&outside, 0) * 36, yk_drawing_pitch_radius(&outside, 1) * 27, 1e-15);
}

static char *draw(const char *text, double angle)
{
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "t.yaml", NULL, problems);
    assert_non_null(model);
    YkMechanism *mech = yk_mechanism_compile(model, NULL, problems);
    assert_non_null(mech);
    YkState *state = yk_state_new(mech);
    assert_true(yk_state_assemble(state) >= 0);
    yk_state_set_input(state, 0, (YkMotion){angle, 0, 0});
    assert_true(yk_state_solve(state) >= 0);
    YkDrawing *drawing = yk_drawing_new(mech, NULL);
    assert_int_equal(yk_drawing_pose(drawing, state), YK_OK);
    const char *svg = yk_drawing_svg(drawing);
    char *copy = malloc(strlen(svg) + 1);
    strcpy(copy, svg);
    yk_drawing_free(drawing);
    yk_state_free(state);
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
    return copy;
}

static size_t count(const char *text, const char *word)
{
    size_t found = 0;
    for (const char *at = strstr(text, word); at; at = strstr(at + 1, word)) found++;
    return found;
}

#define PAIR                                                                                                           \
    "bodies: {ground: {points: {A: [0, 0], B: [0.09, 0]}}, a: {points: {A: [0, 0]}}, b: {points: {B: [0, 0]}}}\n"      \
    "joints: {A: {pin: [ground, a], angle: x}, B: {pin: [ground, b], angle: y}}\n"

// Beyond what the same machine without gears draws: a line for every tooth and a circle for every wheel.
static void every_tooth_has_a_mark(void **unused)
{
    (void)unused;
    char *with = draw(PAIR "gears: {g: {mesh: [a, b], teeth: [13, 27]}}\n", 0.1), *without = draw(PAIR, 0.1);
    assert_int_equal(count(with, "<line"), count(without, "<line") + 13 + 27);
    assert_int_equal(count(with, "<circle"), count(without, "<circle") + 2);
    free(with);
    free(without);
}

// The second wheel has gone half round meanwhile: the same picture all the same.
static void a_turn_further_looks_the_same(void **unused)
{
    (void)unused;
    char *one = draw(PAIR "gears: {g: {mesh: [a, b], teeth: [12, 24]}}\n", 0.3);
    char *two = draw(PAIR "gears: {g: {mesh: [a, b], teeth: [12, 24]}}\n", 0.3 + 2 * YK_PI);
    assert_string_equal(one, two);
    free(one);
    free(two);
}

static void belts_have_two_straight_runs(void **unused)
{
    (void)unused;
    char *with = draw(PAIR "belts: {b: {between: [a, b], radii: [0.02, 0.03]}}\n", 0), *without = draw(PAIR, 0);
    assert_int_equal(count(with, "<line"), count(without, "<line") + 2);
    free(with);
    free(without);
}

// A pinion is a circle as large as its rack says, about its axis, alone or with the rest of the machine.
static void a_pinion_rolls_on_its_rack(void **unused)
{
    (void)unused;
    static const char machine[] = "bodies: {ground: {points: {A: [0, 0]}}, a: {points: {A: [0, 0], P: [0, 0.09]}}, "
                                  "bar: {points: {R: [0, 0]}}}\njoints: {A: {pin: [ground, a], angle: x}, "
                                  "B: {slide: [ground, bar], along: x, distance: s}}\n";
    static const char rack[] = "racks: {r: {pinion: a, rack: bar, radius: 0.03}}\n";
    char text[600];
    snprintf(text, sizeof text, "%s%s", machine, rack);
    char *with = draw(text, 0.1), *without = draw(machine, 0.1);
    assert_int_equal(count(with, "<circle"), count(without, "<circle") + 1);
    double radius = 0, at[2] = {0, 0}, center[2] = {0, 0}, far = 0;
    for (const char *c = strstr(with, "<circle"); c; c = strstr(c + 1, "<circle")) {
        const char *end = strchr(c, '>'), *tip;
        double x = atof(strstr(c, "cx=\"") + 4), y = atof(strstr(c, "cy=\"") + 4), r = atof(strstr(c, " r=\"") + 4);
        tip = strstr(c, "fill=\"none\"");
        if (tip && tip < end) radius = r, at[0] = x, at[1] = y;
        tip = strstr(c, "fill=\"#ffffff\"");
        if (tip && tip < end) center[0] = x, center[1] = y;
    }
    for (const char *c = strstr(with, "<circle"); c; c = strstr(c + 1, "<circle"))
        far = fmax(far, hypot(atof(strstr(c, "cx=\"") + 4) - center[0], atof(strstr(c, "cy=\"") + 4) - center[1]));
    CHECK_NEAR(at[0], center[0], 0.02);
    CHECK_NEAR(at[1], center[1], 0.02);
    CHECK_NEAR(radius, far / 3, 0.05); // P is 0.09 m away
    free(with);
    free(without);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pitch_circles_touch),           cmocka_unit_test(every_tooth_has_a_mark),
        cmocka_unit_test(a_turn_further_looks_the_same), cmocka_unit_test(a_pinion_rolls_on_its_rack),
        cmocka_unit_test(belts_have_two_straight_runs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
