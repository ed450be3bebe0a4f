// Motion programs: peak factors of the library (CAM-FAC), strokes, conditions, other laws in their place.
#include "design/cam_check.h"

// Tables of Norton and others, exact values: published data of case CAM-FAC.
static void peak_factors_are_the_tabulated_ones(void **state)
{
    (void)state;
    const struct {
        const char *law;
        double v, a, j;
    } cases[] = {
        {"cycloidal", 2.0, 6.283185307179586, 39.47841760435743},
        {"harmonic", 1.5707963267948966, 4.934802200544679, INFINITY},
        {"parabolic", 2.0, 4.0, INFINITY},
        {"modified-trapezoid", 2.0, 4.888123762813258, 61.425974812367315},
        {"modified-sine", 1.7596033859537705, 5.527957070544091, 69.46635728872428},
        {"3-4-5", 1.875, 5.773502691896257, 60.0},
        {"4-5-6-7", 2.1875, 7.513188404399293, 52.5},
        {"constant-velocity", 1.0, INFINITY, INFINITY},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        YkCamFactors f;
        assert_int_equal(yk_cam_law_factors(cases[i].law, &f), YK_OK);
        CHECK_NEAR(f.v, cases[i].v, 1e-12 * cases[i].v);
        if (isfinite(cases[i].a)) CHECK_NEAR(f.a, cases[i].a, 1e-12 * cases[i].a);
        if (isfinite(cases[i].j)) CHECK_NEAR(f.j, cases[i].j, 1e-12 * cases[i].j);
        assert_int_equal(isfinite(f.a) != 0, isfinite(cases[i].a) != 0);
        assert_int_equal(isfinite(f.j) != 0, isfinite(cases[i].j) != 0);
    }
    YkCamFactors f;
    assert_int_equal(yk_cam_law_factors("sinusoidal", &f), YK_BAD_ARGUMENT);
    assert_int_equal(yk_cam_law_factors("scca", &f), YK_BAD_ARGUMENT);
}

static void every_law_of_the_list_has_factors(void **state)
{
    (void)state;
    size_t count = 0;
    for (const char *name; (name = yk_cam_law_name(count)); count++) {
        YkCamFactors f;
        assert_int_equal(yk_cam_law_factors(name, &f), YK_OK);
        assert_true(f.v >= 1 && f.a >= 4 - 1e-12);
        assert_string_not_equal(name, "scca");
    }
    assert_int_equal(count, 9);
}

static void strokes_go_from_rest_to_rest(void **state)
{
    (void)state;
    Cam cam = cam_load(LIFT "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 40 mm}}\n" SLIDE);
    YkCamStroke s[8];
    assert_int_equal(yk_cam_strokes(cam.design, s, 8), 2);
    CHECK_NEAR(s[0].from, 0, 0);
    CHECK_NEAR(s[0].to, 120 * DEG, 1e-15);
    CHECK_NEAR(s[0].lift, 0.02, 1e-16);
    CHECK_NEAR(s[0].factors.v, 2, 1e-12);
    CHECK_NEAR(s[0].factors.a, 2 * YK_PI, 1e-12);
    CHECK_NEAR(s[0].factors.j, 4 * YK_PI * YK_PI, 1e-11);
    CHECK_NEAR(s[1].from, 150 * DEG, 1e-15);
    CHECK_NEAR(s[1].to, 260 * DEG, 1e-15);
    CHECK_NEAR(s[1].lift, -0.02, 1e-16);
    CHECK_NEAR(s[1].factors.a, 10 / sqrt(3), 1e-12);
    assert_int_equal(yk_cam_strokes(cam.design, s, 1), 2); // counts them all
    cam_free(&cam);
}

// The CEP cam: one polynomial up and down. s = h (64 u^3 - 192 u^4 + 192 u^5 - 64 u^6), u = theta / (4 pi / 3).
#define CEP                                                                                                            \
    "laws:\n  lift:\n    period: 2*pi\n    segments:\n"                                                                \
    "      - {polynomial: [{at: 0, s: 0, v: 0, a: 0}, {at: 2*pi/3, s: 20 cm}, {at: 4*pi/3, s: 0, v: 0, a: 0}]}\n"      \
    "      - {dwell: {to: 2*pi}}\n"                                                                                    \
    "cams: {valve: {cam: shaft, follower: tappet, law: lift, roller: 10 mm, base: 60 mm, offset: 0 mm}}\n"

static void the_cep_cam_moves_as_its_polynomial(void **state)
{
    (void)state;
    Cam cam = cam_load(CEP SLIDE);
    const double beta = 4 * YK_PI / 3, h = 0.2;
    for (double angle = 0; angle < 2 * YK_PI; angle += 0.01) {
        double u = angle / beta, w = 1 - u, s = angle < beta ? h * 64 * u * u * u * w * w * w : 0;
        double v = angle < beta ? h * 192 * u * u * w * w * (1 - 2 * u) / beta : 0;
        double a = angle < beta ? h * 384 * u * w * (1 - 5 * u + 5 * u * u) / (beta * beta) : 0;
        YkCamPoint p = yk_cam_at(cam.design, angle);
        CHECK_NEAR(p.lift[0], s, 1e-13);
        CHECK_NEAR(p.lift[1], v, 1e-13);
        CHECK_NEAR(p.lift[2], a, 1e-12);
    }
    YkCamSegment first = yk_cam_segment(cam.design, 0);
    assert_int_equal(yk_cam_segment_count(cam.design), 2);
    assert_string_equal(first.kind, "polynomial");
    assert_int_equal(first.condition_count, 7);
    assert_true(first.condition_number > 1 && first.condition_number < 1e6);
    const int orders[] = {0, 0, 0, 1, 1, 2, 2}; // all s, then v, then a
    for (size_t i = 0; i < 7; i++) assert_int_equal(yk_cam_condition(cam.design, 0, i).order, orders[i]);
    CHECK_NEAR(yk_cam_condition(cam.design, 0, 1).value, 0.2, 0);
    assert_int_equal(yk_cam_segment(cam.design, 1).condition_count, 0);
    YkCamStroke s[4];
    assert_int_equal(yk_cam_strokes(cam.design, s, 4), 2);
    CHECK_NEAR(s[0].to, 2 * YK_PI / 3, 1e-15);
    CHECK_NEAR(s[0].lift, 0.2, 1e-16);
    CHECK_NEAR(s[0].factors.a, s[1].factors.a, 1e-12);
    cam_free(&cam);
}

// A stroke may begin before the law's period does: it is one all the same.
static void a_stroke_over_the_end_of_the_period_is_one(void **state)
{
    (void)state;
    Cam cam = cam_load("laws: {lift: {period: 2*pi, from: 0, segments: [{fall: {to: 60 deg, by: 20 mm, law: cycloidal, "
                       "half: second}}, {dwell: {to: 100 deg}}, {rise: {to: 200 deg, by: 40 mm, law: cycloidal}}, "
                       "{dwell: {to: 300 deg}}, {fall: {to: 360 deg, by: 20 mm, law: cycloidal, half: first}}]}}\n"
                       "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 90 mm}}\n" SLIDE);
    YkCamStroke s[8];
    assert_int_equal(yk_cam_strokes(cam.design, s, 8), 2);
    CHECK_NEAR(s[0].from, -60 * DEG, 1e-15);
    CHECK_NEAR(s[0].to, 60 * DEG, 1e-15);
    CHECK_NEAR(s[0].lift, -0.04, 1e-16);
    CHECK_NEAR(s[0].factors.a, 2 * YK_PI, 1e-11);
    YkCamDesign *other = yk_cam_design_with(cam.design, "3-4-5");
    assert_non_null(other);
    for (double x = 0; x < 6.2; x += 0.1) {
        double u = x < 60 * DEG ? x / (120 * DEG) + 0.5 : (x - 300 * DEG) / (120 * DEG), fall;
        if (u < 0 || u > 1) continue;
        fall = u * u * u * (10 - 15 * u + 6 * u * u);
        CHECK_NEAR(yk_cam_at(other, x).lift[0] - yk_cam_at(other, 80 * DEG).lift[0], 0.04 * (1 - fall), 1e-15);
    }
    yk_cam_design_free(other);
    cam_free(&cam);
}

static void other_laws_keep_strokes_and_dwells(void **state)
{
    (void)state;
    Cam cam = cam_load(CEP SLIDE);
    const char *name;
    for (size_t i = 0; (name = yk_cam_law_name(i)); i++) {
        YkCamDesign *other = yk_cam_design_with(cam.design, name);
        assert_non_null(other);
        assert_string_equal(yk_cam_size(other).law, name);
        YkCamStroke s[4];
        YkCamFactors f;
        assert_int_equal(yk_cam_strokes(other, s, 4), 2);
        assert_int_equal(yk_cam_law_factors(name, &f), YK_OK);
        CHECK_NEAR(s[0].lift, 0.2, 1e-15);
        CHECK_NEAR(s[0].factors.v, f.v, 1e-11);
        CHECK_NEAR(s[1].factors.v, f.v, 1e-11);
        CHECK_NEAR(yk_cam_at(other, 5).lift[0], 0, 1e-15);
        yk_cam_design_free(other);
    }
    assert_null(yk_cam_design_with(cam.design, "no-such-law"));
    cam_free(&cam);
}

static void jumps_are_told_with_their_size(void **state)
{
    (void)state;
    Cam cam = cam_load("laws: {lift: {period: 2*pi, segments: [{rise: {to: pi, by: 20 mm, law: parabolic}}, "
                       "{fall: {to: 2*pi, by: 20 mm, law: cycloidal}}]}}\n"
                       "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 90 mm}}\n" SLIDE);
    YkCamJump jumps[8];
    double a = 4 * 0.02 / (YK_PI * YK_PI);
    assert_int_equal(yk_cam_jumps(cam.design, jumps, 8), 3);
    for (int i = 0; i < 3; i++) assert_int_equal(jumps[i].order, 2);
    CHECK_NEAR(jumps[1].angle, YK_PI / 2, 1e-15);
    CHECK_NEAR(jumps[1].size, -2 * a, 1e-15);
    CHECK_NEAR(jumps[2].size, a, 1e-15);
    YkCamStroke s[4];
    yk_cam_strokes(cam.design, s, 4);
    CHECK_NEAR(s[0].factors.a, 4, 1e-12);
    assert_true(isinf(s[0].factors.j));
    cam_free(&cam);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(peak_factors_are_the_tabulated_ones),
        cmocka_unit_test(every_law_of_the_list_has_factors),
        cmocka_unit_test(strokes_go_from_rest_to_rest),
        cmocka_unit_test(the_cep_cam_moves_as_its_polynomial),
        cmocka_unit_test(a_stroke_over_the_end_of_the_period_is_one),
        cmocka_unit_test(other_laws_keep_strokes_and_dwells),
        cmocka_unit_test(jumps_are_told_with_their_size),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
