// Cams of arcs that are refused, with the place, the part that does not fit and by how much; those that just fit are
// accepted.
#include "fixture.h"

// `arcs:` stands on line 3 from column 57.
#define CAM(arcs)                                                                                                      \
    "units: {length: mm, angle: deg, force: N}\n"                                                                      \
    "cams:\n"                                                                                                          \
    "  c: {cam: shaft, follower: valve, roller: 15, base: 20, arcs: " arcs "}\n"                                       \
    "bodies: {shaft: {}, valve: {}}\n"                                                                                 \
    "joints: {C: {pin: [ground, shaft], angle: theta}, V: {slide: [ground, valve], along: y, distance: s}}\n"
enum { LINE = 3, COLUMN = 64 };

static void refused(const char *text, unsigned offset, const char *message)
{
    YkProblems *problems = fixture_refuse(text);
    const YkProblem *problem = fixture_problem(problems, YK_CODE_CAM_ARCS);
    bool is_right = problem && problem->place.line == LINE && problem->place.column == COLUMN + offset &&
                    strcmp(problem->message, message) == 0 && yk_problems_error_count(problems) == 1;
    if (!is_right)
        print_error("expected at column %u: %s, found\n%s", COLUMN + offset, message, yk_problems_text(problems, 0));
    assert_true(is_right);
    yk_problems_free(problems);
}

static void arcs_that_do_not_join_are_told_at_their_place(void **state)
{
    (void)state;
    refused(CAM("[]"), 0, "cam `c` has no arcs");
    refused(CAM("[{center: [0, 0], radius: 20}, {center: [50, 0], radius: 6}]"), 1,
            "cam `c`: this arc does not touch the next one: the centres are 50 mm apart, the radii differ by 14 mm");
    // circles in each other: the line would need a sine of 1.5
    refused(CAM("[{center: [0, 0], radius: 20}, line, {center: [10, 0], radius: 5}, line]"), 31,
            "cam `c`: no line touches both neighbours here");
    refused(CAM("[{center: [0, 0], radius: 20}, line]"), 31, "cam `c`: no line touches both neighbours here");
    refused(CAM("[{center: [0, 0], radius: 20}, line, line, {center: [30, 0], radius: 5}]"), 31,
            "cam `c`: no line touches both neighbours here");
    refused(
        CAM("[{center: [0, 0], radius: 20}, {center: [30, 0], radius: -10}]"), 31,
        "cam `c`: the follower does not fit into this hollow: a roller must be smaller, and a flat face cannot enter "
        "one");
}

static void a_symmetrical_cam_needs_sizes_that_go_together(void **state)
{
    (void)state;
    refused(CAM("{nose: 6, lift: 12}"), 0, "cam `c`: the arcs need the angle of action or the flank");
    refused(CAM("{nose: 6, lift: 12, flank: line, angle: 100}"), 0,
            "cam `c`: `angle` and `flank` determine each other: give one of them");
    refused(CAM("{nose: -1, lift: 12, flank: line}"), 7, "cam `c`: the radius of the `nose` must not be negative");
    refused(CAM("{nose: 6, lift: 0, flank: line}"), 16, "cam `c`: the `lift` of its arcs must be greater than zero");
    refused(CAM("{nose: 6, lift: 12, flank: 7}"), 0, "cam `c`: no flank joins this base circle and this nose");
    refused(CAM("{nose: 60, lift: 12, flank: line}"), 0, "cam `c`: no flank joins this base circle and this nose");
    refused(CAM("{nose: 6, lift: 12, angle: 0}"), 0, "cam `c`: no flank joins this base circle and this nose");
    refused(CAM("{nose: 6, lift: 12, angle: 360}"), 0, "cam `c`: no flank joins this base circle and this nose");
}

// By a flank or by the angle that belongs to it, the law is the same: by cosines, (R - r)^2 = (R - b)^2 + d^2 + 2 (R -
// b) d cos(angle/2), with b = 20, d = b + lift - r = 26.
static void angle_and_flank_say_the_same(void **state)
{
    (void)state;
    for (double flank = 30; flank < 500; flank *= 1.7) {
        double b = 20, r = 6, d = 26;
        double half = acos(((flank - r) * (flank - r) - (flank - b) * (flank - b) - d * d) / (2 * (flank - b) * d));
        char text[2][1000];
        for (int k = 0; k < 2; k++) {
            char value[60];
            snprintf(value, sizeof value, k == 0 ? "flank: %.17g" : "angle: %.17g",
                     k == 0 ? flank : 2 * half * 180 / acos(-1));
            snprintf(text[k], sizeof text[k], CAM("{nose: 6, lift: 12, %s}"), value);
        }
        YkModel *by_flank = fixture_load(text[0]), *by_angle = fixture_load(text[1]);
        double most = 0;
        for (double at = -3.1; at < 3.1; at += 0.01) {
            double x[YK_LAW_ORDER + 1], y[YK_LAW_ORDER + 1];
            yk_law_eval(by_flank->laws[by_flank->cams[0].law].law, at, x);
            yk_law_eval(by_angle->laws[by_angle->cams[0].law].law, at, y);
            CHECK_NEAR(x[0], y[0], 1e-12);
            most = fmax(most, x[0]);
        }
        CHECK_NEAR(most, 0.012, 2e-6); // the lift, to the step of the search
        yk_model_free(by_flank);
        yk_model_free(by_angle);
    }
}

// The rise of a symmetrical cam begins at `from`; its fall is the mirror image and ends after the angle of action.
static void a_symmetrical_cam_rises_from_where_it_is_told(void **state)
{
    (void)state;
    for (double from = -150; from <= 170; from += 40) {
        const double angle = 130, rad = acos(-1) / 180;
        char text[1000];
        snprintf(text, sizeof text, CAM("{nose: 6, lift: 12, angle: %g, from: %g}"), angle, from);
        YkModel *model = fixture_load(text);
        const YkLaw *law = model->laws[model->cams[0].law].law;
        double middle[YK_LAW_ORDER + 1];
        yk_law_eval(law, (from + angle / 2) * rad, middle);
        CHECK_NEAR(middle[0], 0.012, 1e-12);
        for (double t = -60; t < angle / 2; t += 5) {
            double rise[YK_LAW_ORDER + 1], fall[YK_LAW_ORDER + 1];
            yk_law_eval(law, (from + t) * rad, rise);
            yk_law_eval(law, (from + angle - t) * rad, fall);
            CHECK_NEAR(rise[0], fall[0], 1e-12);
            CHECK_NEAR(rise[1], -fall[1], 1e-12);
            assert_true(t > 1e-9 ? rise[0] > 1e-6 : fabs(rise[0]) < 1e-12);
        }
        yk_model_free(model);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arcs_that_do_not_join_are_told_at_their_place),
        cmocka_unit_test(a_symmetrical_cam_needs_sizes_that_go_together),
        cmocka_unit_test(angle_and_flank_say_the_same),
        cmocka_unit_test(a_symmetrical_cam_rises_from_where_it_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
