// Profiles as polylines: within the tolerance everywhere, closed, on the curve.
#include "design/cam_check.h"

static const char roller[] = LIFT "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 40 mm, roller: 9 mm, "
                                  "offset: 7 mm, groove: true, conjugate: {span: 130 mm}}}\n" SLIDE;

static YkVec curve_at(const YkCamDesign *design, YkCamCurve curve, double cutter, double angle)
{
    bool is_second = curve == YK_CAM_CURVE_SECOND_SURFACE || curve == YK_CAM_CURVE_SECOND_PITCH;
    YkCamPoint p = is_second ? yk_cam_conjugate_at(design, angle) : yk_cam_at(design, angle);
    const double *at = curve == YK_CAM_CURVE_PITCH || curve == YK_CAM_CURVE_SECOND_PITCH ? p.pitch
                       : curve == YK_CAM_CURVE_OUTER                                     ? p.outer
                                                                                         : p.surface;
    YkVec out = curve == YK_CAM_CURVE_CUTTER ? yk_vec(cutter * p.normal[0], cutter * p.normal[1]) : yk_vec(0, 0);
    return yk_add(yk_vec(at[0], at[1]), out);
}

static double off_segment(YkVec a, YkVec b, YkVec p)
{
    YkVec ab = yk_sub(b, a), ap = yk_sub(p, a);
    double k = fmin(fmax(yk_dot(ab, ap) / yk_dot(ab, ab), 0), 1);
    return yk_norm(yk_sub(ap, yk_scale(k, ab)));
}

static void check_curve(const YkCamDesign *design, YkCamCurve curve, double tolerance, double cutter)
{
    YkCamVertex *v;
    size_t count;
    assert_int_equal(yk_cam_profile(design, curve, tolerance, cutter, &v, &count), YK_OK);
    assert_true(count > 20);
    for (size_t i = 0; i < count; i++) {
        YkVec a = yk_vec(v[i].x, v[i].y), b = yk_vec(v[(i + 1) % count].x, v[(i + 1) % count].y);
        double from = v[i].angle, to = i + 1 < count ? v[i + 1].angle : v[0].angle + 2 * YK_PI;
        assert_true(to > from);
        CHECK_NEAR(yk_norm(yk_sub(curve_at(design, curve, cutter, from), a)), 0, 1e-13);
        for (int k = 1; k < 12; k++) {
            YkVec p = curve_at(design, curve, cutter, from + (to - from) * k / 12);
            assert_true(off_segment(a, b, p) <= tolerance);
        }
    }
    yk_cam_vertices_free(v);
}

static void profiles_stay_within_the_tolerance(void **state)
{
    (void)state;
    Cam cam = cam_load(roller);
    for (double tolerance = 1e-4; tolerance > 1e-8; tolerance /= 10) {
        check_curve(cam.design, YK_CAM_CURVE_SURFACE, tolerance, 0);
        check_curve(cam.design, YK_CAM_CURVE_PITCH, tolerance, 0);
        check_curve(cam.design, YK_CAM_CURVE_OUTER, tolerance, 0);
        check_curve(cam.design, YK_CAM_CURVE_CUTTER, tolerance, 0.004);
        check_curve(cam.design, YK_CAM_CURVE_SECOND_SURFACE, tolerance, 0);
        check_curve(cam.design, YK_CAM_CURVE_SECOND_PITCH, tolerance, 0);
    }
    cam_free(&cam);
}

// A circle of radius R within e needs pi / sqrt(2 e / R) chords at best.
static void few_points_are_used(void **state)
{
    (void)state;
    Cam cam = cam_load(LIFT "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 40 mm, roller: 9 mm}}\n" SLIDE);
    YkCamVertex *v;
    size_t count;
    assert_int_equal(yk_cam_profile(cam.design, YK_CAM_CURVE_SURFACE, 1e-6, 0, &v, &count), YK_OK);
    double best = YK_PI / sqrt(2 * 1e-6 / 0.05);
    assert_true((double)count < 2.5 * best && (double)count > 0.8 * best);
    yk_cam_vertices_free(v);
    cam_free(&cam);
}

// The cutter's centre lies its radius off the surface; one as large as the roller runs along the pitch curve.
static void a_cutter_of_the_rollers_size_runs_along_the_pitch_curve(void **state)
{
    (void)state;
    Cam cam = cam_load(roller);
    for (double x = 0; x < 6.2; x += 0.1) {
        YkVec a = curve_at(cam.design, YK_CAM_CURVE_CUTTER, 0.009, x),
              b = curve_at(cam.design, YK_CAM_CURVE_PITCH, 0, x);
        CHECK_NEAR(yk_norm(yk_sub(a, b)), 0, 1e-15);
    }
    cam_free(&cam);
}

// Two lobes: the law twice in a turn, the profile unchanged by half a turn.
static void a_cam_of_two_lobes_goes_round(void **state)
{
    (void)state;
    Cam cam = cam_load("laws: {lift: {period: pi, segments: [{rise: {to: pi/2, by: 5 mm, law: cycloidal}}, "
                       "{fall: {to: pi, by: 5 mm, law: cycloidal}}]}}\n"
                       "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 40 mm, roller: 9 mm}}\n" SLIDE);
    YkCamVertex *v;
    size_t count;
    check_curve(cam.design, YK_CAM_CURVE_SURFACE, 1e-5, 0);
    assert_int_equal(yk_cam_profile(cam.design, YK_CAM_CURVE_SURFACE, 1e-5, 0, &v, &count), YK_OK);
    assert_int_equal(count % 2, 0);
    for (size_t i = 0; i < count / 2; i++) {
        CHECK_NEAR(v[i].x, -v[i + count / 2].x, 1e-13);
        CHECK_NEAR(v[i].y, -v[i + count / 2].y, 1e-13);
    }
    yk_cam_vertices_free(v);
    cam_free(&cam);
}

static void what_is_not_there_has_no_profile(void **state)
{
    (void)state;
    Cam cam = cam_load(LIFT "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 40 mm, roller: 9 mm}}\n" SLIDE);
    YkCamVertex *v;
    size_t count;
    assert_int_equal(yk_cam_profile(cam.design, YK_CAM_CURVE_OUTER, 1e-5, 0, &v, &count), YK_BAD_ARGUMENT);
    assert_int_equal(yk_cam_profile(cam.design, YK_CAM_CURVE_SECOND_PITCH, 1e-5, 0, &v, &count), YK_BAD_ARGUMENT);
    assert_int_equal(yk_cam_profile(cam.design, YK_CAM_CURVE_SURFACE, 0, 0, &v, &count), YK_BAD_ARGUMENT);
    assert_int_equal(yk_cam_profile(cam.design, YK_CAM_CURVE_SURFACE, (double)NAN, 0, &v, &count), YK_BAD_ARGUMENT);
    assert_int_equal(yk_cam_profile(cam.design, YK_CAM_CURVE_CUTTER, 1e-5, -1, &v, &count), YK_BAD_ARGUMENT);
    assert_null(v);
    cam_free(&cam);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(profiles_stay_within_the_tolerance),
        cmocka_unit_test(few_points_are_used),
        cmocka_unit_test(a_cutter_of_the_rollers_size_runs_along_the_pitch_curve),
        cmocka_unit_test(a_cam_of_two_lobes_goes_round),
        cmocka_unit_test(what_is_not_there_has_no_profile),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
