// Extremes over a turn, undercut, and the smallest base circle.
#include "design/cam_check.h"

#define INCH 0.0254
#define CAM_FLAT(base)                                                                                                 \
    "parameters: {in: 25.4 mm}\n"                                                                                      \
    "laws: {lift: {period: 2*pi, segments: [{rise: {to: 90 deg, by: in, law: cycloidal}}, {dwell: {to: 180 deg}}, "    \
    "{fall: {to: 270 deg, by: in, law: cycloidal}}, {dwell: {to: 360 deg}}]}}\n"                                       \
    "cams: {c: {cam: shaft, follower: tappet, law: lift, base: " base ", face: flat}}\n" SLIDE

// Case CAM-FLAT: Rb = rho_min - min(s + s''), face = 2 max |s'| = 8 / pi.
static void a_flat_faced_follower_has_its_published_sizes(void **state)
{
    (void)state;
    Cam cam = cam_load(CAM_FLAT("2*in"));
    YkCamLimits limits = {30 * DEG, 0.25 * INCH};
    YkCamBase base;
    assert_int_equal(yk_cam_smallest_base(cam.design, &limits, &base), YK_OK);
    CHECK_NEAR(base.base / INCH, 1.892631278649045672, 1e-14); // mpmath, 30 digits
    CHECK_NEAR(base.base / INCH, 1.8926312786470736, 1e-11);   // by samples
    CHECK_NEAR(base.base / INCH, 1.893, 0.0005);               // as printed
    assert_false(base.by_pressure);
    YkCamSummary s = yk_cam_summary(cam.design);
    CHECK_NEAR((s.reach_high.value - s.reach_low.value) / INCH, 2.5464790894703255, 1e-12);
    CHECK_NEAR(s.pressure.value, 0, 0);
    CHECK_NEAR(s.surface_convex.value / INCH, 2 - (1.892631278649045672 - 0.25), 1e-14);
    CHECK_NEAR(s.surface_convex.angle, base.angle, 1e-6);
    CHECK_NEAR(s.lift_high.value, INCH, 1e-16);
    CHECK_NEAR(s.far.value / INCH, 3, 1e-2);
    assert_true(isinf(s.surface_hollow.value) && s.undercut_count == 0);
    cam_free(&cam);
}

#define ROLLER(base, roller, offset)                                                                                   \
    LIFT "cams: {c: {cam: shaft, follower: tappet, law: lift, base: " base ", roller: " roller ", offset: " offset     \
         "}}\n" SLIDE
#define ROCKER(base)                                                                                                   \
    SWING "cams: {c: {cam: shaft, follower: rocker, law: lift, base: " base ", roller: 9 mm, at: P}}\n" PIVOT

// All along a dwell the cam is as wide as where it begins, but for rounding.
static void an_extreme_of_a_dwell_is_where_it_begins(void **state)
{
    (void)state;
    const char *texts[] = {ROLLER("40 mm", "9 mm", "7 mm"), ROLLER("40 mm", "8 mm", "6 mm"), ROCKER("40 mm"),
                           ROCKER("37 mm")};
    for (size_t i = 0; i < 4; i++) {
        Cam cam = cam_load(texts[i]);
        YkCamSummary s = yk_cam_summary(cam.design);
        CHECK_NEAR(s.far.angle, 120 * DEG, 1e-12);
        CHECK_NEAR(s.near.angle, 0, 1e-12);
        cam_free(&cam);
    }
}

// Every extreme against a plain scan with steps far smaller than the samples'.
static void extremes_are_those_of_a_fine_scan(void **state)
{
    (void)state;
    const char *texts[] = {ROLLER("40 mm", "9 mm", "7 mm"), ROCKER("40 mm"), CAM_FLAT("2*in")};
    for (size_t i = 0; i < 3; i++) {
        Cam cam = cam_load(texts[i]);
        YkCamSummary s = yk_cam_summary(cam.design);
        double pressure = 0, convex = 1e9, hollow = -1e9, far = 0, near = 1e9, a = 0;
        for (double x = 0; x < 2 * YK_PI; x += 1e-4) {
            YkCamPoint p = yk_cam_at(cam.design, x);
            double r = hypot(p.surface[0], p.surface[1]);
            pressure = fmax(pressure, fabs(p.pressure_angle));
            if (p.pitch_radius > 0) convex = fmin(convex, p.surface_radius);
            if (p.pitch_radius < 0) hollow = fmax(hollow, p.surface_radius);
            far = fmax(far, r);
            near = fmin(near, r);
            a = fmax(a, fabs(p.lift[2]));
        }
        CHECK_NEAR(fabs(s.pressure.value), pressure, 1e-7);
        CHECK_NEAR(s.surface_convex.value, convex, 1e-6);
        if (hollow > -1e9) CHECK_NEAR(s.surface_hollow.value, hollow, 1e-5);
        CHECK_NEAR(s.far.value, far, 1e-8);
        CHECK_NEAR(s.near.value, near, 1e-8);
        CHECK_NEAR(fabs(s.peak[2].value), a, 1e-7 * a);
        CHECK_NEAR(yk_cam_at(cam.design, s.pressure.angle).pressure_angle, s.pressure.value, 1e-12);
        cam_free(&cam);
    }
}

// A roller too large for the cam's nose: between two cusps the surface runs backwards.
static void undercut_lies_between_its_cusps(void **state)
{
    (void)state;
    Cam cam = cam_load(ROLLER("5 mm", "150 mm", "0 mm"));
    YkCamSummary s = yk_cam_summary(cam.design);
    assert_true(s.undercut_count > 0);
    assert_true(s.surface_convex.value < 0);
    size_t inside = 0;
    for (double x = 0; x < 2 * YK_PI; x += 1e-4) {
        YkCamPoint p = yk_cam_at(cam.design, x), next = yk_cam_at(cam.design, x + 1e-7);
        double forward =
            p.normal[0] * (next.surface[1] - p.surface[1]) - p.normal[1] * (next.surface[0] - p.surface[0]);
        int is_in = 0;
        for (size_t k = 0; k < s.undercut_count; k++) is_in |= x > s.undercut[k].from && x < s.undercut[k].to;
        assert_int_equal(p.fullness < 0, is_in);
        if (fabs(p.fullness) > 1e-3) assert_int_equal(forward > 0, is_in); // the surface runs clockwise otherwise
        inside += (size_t)is_in;
    }
    assert_true(inside > 100);
    for (size_t k = 0; k < s.undercut_count; k++) {
        // a cusp, or the jump at the end of a segment
        YkCamPoint from = yk_cam_at(cam.design, s.undercut[k].from);
        CHECK_NEAR(from.fullness, 0, 1e-9);
    }
    cam_free(&cam);
}

// On the same pitch curve a roller is undercut where its radius exceeds the curve's, however little and briefly: twice
// on a lift that falls as it rises.
static void a_roller_a_little_larger_than_the_pitch_curve_is_undercut(void **state)
{
    (void)state;
    static const char text[] =
        "laws: {lift: {period: 2*pi, segments: [{rise: {to: 120 deg, by: 20 mm, law: cycloidal}}, {dwell: {to: 150 "
        "deg}}, "
        "{fall: {to: 270 deg, by: 20 mm, law: cycloidal}}, {dwell: {to: 360 deg}}]}}\n"
        "cams: {c: {cam: shaft, follower: tappet, law: lift, base: %.17g, roller: %.17g}}\n" SLIDE;
    double sharpest = 0.005, prime = 0.049; // a roller's radius to begin with; the pitch curve's least
    for (int k = -1; k < 10; k++) {
        char own[1000];
        double roller = k < 0 ? sharpest : sharpest * (1 + (k % 2 ? 1 : -1) * pow(10, -2 - k));
        snprintf(own, sizeof own, text, prime - roller, roller);
        Cam cam = cam_load(own);
        YkCamSummary s = yk_cam_summary(cam.design);
        if (k < 0) sharpest = s.pitch_convex.value;
        assert_int_equal(s.undercut_count, k > 0 && k % 2 ? 2 : 0);
        for (size_t i = 0; i < s.undercut_count; i++) {
            double from = s.undercut[i].from, to = s.undercut[i].to;
            assert_true(yk_cam_at(cam.design, from + 0.5 * (to - from)).fullness < 0);
            assert_true(yk_cam_at(cam.design, from - 0.1 * (to - from)).fullness > 0);
            assert_true(yk_cam_at(cam.design, to + 0.1 * (to - from)).fullness > 0);
        }
        cam_free(&cam);
    }
}

static void a_groove_may_be_undercut_outside(void **state)
{
    (void)state;
    Cam cam = cam_load(
        "laws: {lift: {period: 2*pi, segments: [{rise: {to: 40 deg, by: 40 mm, law: cycloidal}}, "
        "{dwell: {to: 180 deg}}, {fall: {to: 220 deg, by: 40 mm, law: cycloidal}}, {dwell: {to: 2*pi}}]}}\n"
        "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 10 mm, roller: 50 mm, groove: true}}\n" SLIDE);
    YkCamSummary s = yk_cam_summary(cam.design);
    assert_true(s.outer_undercut_count > 0);
    assert_true(s.pitch_hollow.value > -0.050);
    double middle = (s.outer_undercut[0].from + s.outer_undercut[0].to) / 2;
    assert_true(yk_cam_at(cam.design, middle).outer_fullness < 0);
    cam_free(&cam);
}

// Translating: with d = sqrt(Rp^2 - e^2) the pressure angle asks for d >= |v - e| / tan(limit) - s everywhere.
static void the_smallest_base_for_a_pressure_angle_has_a_closed_form(void **state)
{
    (void)state;
    Cam cam = cam_load(ROLLER("40 mm", "9 mm", "7 mm"));
    YkCamLimits limits = {22 * DEG, 0};
    YkCamBase base;
    double d = 0;
    for (double x = 0; x < 2 * YK_PI; x += 2e-5) {
        YkCamPoint p = yk_cam_at(cam.design, x);
        d = fmax(d, fabs(p.lift[1] - 0.007) / tan(22 * DEG) - p.lift[0]);
    }
    assert_int_equal(yk_cam_smallest_base(cam.design, &limits, &base), YK_OK);
    assert_true(base.by_pressure);
    CHECK_NEAR(base.base, hypot(d, 0.007) - 0.009, 1e-9);
    cam_free(&cam);
}

// Whatever decides: at the base found the limits just hold, and a thousandth below one of them does not.
static void check_base(const char *with, const char *without, const YkCamLimits *limits)
{
    Cam cam = cam_load(with);
    YkCamBase base;
    char text[3000], size[40];
    assert_int_equal(yk_cam_smallest_base(cam.design, limits, &base), YK_OK);
    cam_free(&cam);
    for (int less = 0; less < 2; less++) {
        snprintf(size, sizeof size, "%.17g", base.base * (less ? 0.999 : 1 + 1e-12));
        snprintf(text, sizeof text, without, size);
        Cam other = cam_load(text);
        YkCamSummary s = yk_cam_summary(other.design);
        int holds = fabs(s.pressure.value) <= limits->pressure * (1 + 1e-9) &&
                    s.surface_convex.value >= limits->curvature - 1e-11;
        assert_int_equal(holds, !less);
        double value =
            base.by_pressure ? fabs(yk_cam_at(other.design, base.angle).pressure_angle) / limits->pressure : 1;
        CHECK_NEAR(value, 1, less ? 0.05 : 1e-6);
        cam_free(&other);
    }
}

static void the_smallest_base_keeps_limits_that_a_smaller_one_breaks(void **state)
{
    (void)state;
    check_base(ROLLER("40 mm", "9 mm", "0 mm"), ROLLER("%s", "9 mm", "0 mm"), &(YkCamLimits){25 * DEG, 0.001});
    check_base(ROLLER("40 mm", "9 mm", "0 mm"), ROLLER("%s", "9 mm", "0 mm"), &(YkCamLimits){60 * DEG, 0.02});
    check_base(ROLLER("40 mm", "9 mm", "7 mm"), ROLLER("%s", "9 mm", "7 mm"), &(YkCamLimits){60 * DEG, 0});
    check_base(ROCKER("40 mm"), ROCKER("%s"), &(YkCamLimits){35 * DEG, 0.001});
    check_base(CAM_FLAT("2*in"), CAM_FLAT("%s"), &(YkCamLimits){30 * DEG, 0});
}

static void limits_that_no_base_keeps_are_told(void **state)
{
    (void)state;
    Cam cam = cam_load(ROCKER("40 mm"));
    YkCamBase base;
    assert_int_equal(yk_cam_smallest_base(cam.design, &(YkCamLimits){1 * DEG, 0}, &base), YK_LIMIT);
    YkCamLimits limits = yk_default_cam_limits(cam.design);
    CHECK_NEAR(limits.pressure, 35 * DEG, 1e-15);
    cam_free(&cam);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_flat_faced_follower_has_its_published_sizes),
        cmocka_unit_test(extremes_are_those_of_a_fine_scan),
        cmocka_unit_test(an_extreme_of_a_dwell_is_where_it_begins),
        cmocka_unit_test(undercut_lies_between_its_cusps),
        cmocka_unit_test(a_groove_may_be_undercut_outside),
        cmocka_unit_test(a_roller_a_little_larger_than_the_pitch_curve_is_undercut),
        cmocka_unit_test(the_smallest_base_for_a_pressure_angle_has_a_closed_form),
        cmocka_unit_test(the_smallest_base_keeps_limits_that_a_smaller_one_breaks),
        cmocka_unit_test(limits_that_no_base_keeps_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
