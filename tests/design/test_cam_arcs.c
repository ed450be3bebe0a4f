// Cams of arcs: closed forms of the textbooks, and contact with the surface point by point.
#include <stdio.h>
#include "design/cam_check.h"

static double lift(const Cam *cam, double angle, int order)
{
    double d[YK_LAW_ORDER + 1];
    yk_law_eval(cam->design->law->law, angle, d);
    return d[order];
}

// Straight flanks, roller: s = (b + r) (1 / cos(theta) - 1). Source: any textbook on the tangent cam.
static void a_tangent_cam_lifts_its_roller_as_books_say(void **state)
{
    (void)state;
    Cam cam = cam_load("cams: {c: {cam: shaft, follower: tappet, roller: 15 mm, base: 20 mm, "
                       "arcs: {nose: 6 mm, lift: 12 mm, flank: line, from: 10 deg}}}\n" SLIDE);
    double alpha = acos(14.0 / 26), flank = atan(0.026 * sin(alpha) / 0.035), from = 10 * DEG;
    for (double x = 1e-6; x < flank; x += 0.013) {
        double c = cos(x), s = sin(x);
        CHECK_NEAR(lift(&cam, from + x, 0), 0.035 * (1 / c - 1), 1e-15);
        CHECK_NEAR(lift(&cam, from + x, 1), 0.035 * s / (c * c), 1e-14);
        CHECK_NEAR(lift(&cam, from + x, 2), 0.035 * (1 + s * s) / (c * c * c), 1e-13);
    }
    for (double x = flank + 1e-6; x < 2 * alpha - flank; x += 0.013) { // a crank of 26 mm, a rod of 21 mm
        double a = alpha - x;
        CHECK_NEAR(lift(&cam, from + x, 0), 0.026 * cos(a) + sqrt(0.021 * 0.021 - pow(0.026 * sin(a), 2)) - 0.035,
                   1e-15);
    }
    CHECK_NEAR(lift(&cam, from + alpha, 0), 0.012, 1e-16);
    for (double x = 2 * alpha + 1e-9; x < 2 * YK_PI; x += 0.1) CHECK_NEAR(lift(&cam, from + x, 0), 0, 1e-16);
    cam_free(&cam);
}

// Circular flanks, flat face: s = (R - b) (1 - cos(theta)), then s = d cos(alpha - theta) + nose - b.
static void a_circular_arc_cam_lifts_its_flat_face_as_books_say(void **state)
{
    (void)state;
    const double b = 0.02, n = 0.005, h = 0.01, d = b + h - n, alpha = 60 * DEG;
    double R = (b * b + d * d - 2 * b * d * cos(alpha) - n * n) / (2 * (b - n - d * cos(alpha)));
    double flank = asin(d * sin(alpha) / (R - n)); // the law of sines in the triangle of the centres
    const char *const ways[] = {"angle: 120 deg", "flank: %.17g"};
    for (int way = 0; way < 2; way++) {
        char words[60], text[900];
        snprintf(words, sizeof words, ways[way], R);
        snprintf(text, sizeof text,
                 "cams: {c: {cam: shaft, follower: tappet, face: flat, base: 20 mm, arcs: {nose: 5 mm, lift: 10 mm, "
                 "%s}}}\n%s",
                 words, SLIDE);
        Cam cam = cam_load(text);
        for (double x = 1e-9; x < 2 * alpha; x += 0.011) {
            double y = fmin(x, 2 * alpha - x);
            double wanted = y < flank ? (R - b) * (1 - cos(y)) : d * cos(alpha - y) + n - b;
            CHECK_NEAR(lift(&cam, x, 0), wanted, 1e-15);
        }
        YkLawJump jumps[10];
        assert_int_equal(yk_law_jumps(cam.design->law->law, jumps, 10), 4); // of the acceleration
        for (int k = 0; k < 4; k++) assert_int_equal(jumps[k].order, 2);
        CHECK_NEAR(jumps[0].size, R - b, 1e-13);
        CHECK_NEAR(jumps[1].size, -(R - n), 1e-12);
        cam_free(&cam);
    }
}

// A closed surface of four arcs whose normals change over at these angles: the radii of the second and fourth close it.
typedef struct Oval {
    double change[4], radius[4];
    YkVec center[4];
} Oval;

static Oval oval_of(const double change[4], double base, double nose)
{
    Oval o = {.radius = {base, 0, nose, 0}};
    YkVec u[4];
    for (int k = 0; k < 4; k++) u[k] = yk_unit(o.change[k] = change[k]);
    YkVec a = yk_sub(u[1], u[0]), b = yk_sub(u[3], u[2]);
    YkVec r = yk_add(yk_scale(nose, yk_sub(u[1], u[2])), yk_scale(base, yk_sub(u[3], u[0])));
    o.radius[1] = yk_cross(r, b) / yk_cross(a, b);
    o.radius[3] = yk_cross(a, r) / yk_cross(a, b);
    for (int k = 0; k < 3; k++) o.center[k + 1] = yk_add(o.center[k], yk_scale(o.radius[k] - o.radius[k + 1], u[k]));
    return o;
}

// Returns the least of the distance of a point from the surface, or the surface's greatest reach in a direction.
static double over_surface(const Oval *o, YkVec v, bool is_reach)
{
    enum { POINTS = 20000 };
    double best = is_reach ? -INFINITY : INFINITY;
    for (int k = 0; k < 4; k++) {
        double from = o->change[(k + 3) % 4] - (k == 0 ? 2 * YK_PI : 0), to = o->change[k];
        for (int i = 0; i <= POINTS; i++) {
            YkVec at = yk_add(o->center[k], yk_scale(o->radius[k], yk_unit(from + (to - from) * i / POINTS)));
            best = is_reach ? fmax(best, yk_dot(at, v)) : fmin(best, yk_norm(yk_sub(v, at)));
        }
    }
    return best;
}

static void check_contact(const Oval *o, const char *keys, const char *machine)
{
    char text[3000];
    int length = snprintf(text, sizeof text, "cams: {c: {cam: shaft, follower: %s, base: 0.03, %s, arcs: [",
                          strstr(machine, "rocker") ? "rocker" : "tappet", keys);
    for (int k = 0; k < 4; k++)
        length += snprintf(text + length, sizeof text - (size_t)length, "%s{center: [%.17g, %.17g], radius: %.17g}",
                           k ? ", " : "", o->center[k].x, o->center[k].y, o->radius[k]);
    snprintf(text + length, sizeof text - (size_t)length, "]}}\n%s", machine);
    Cam cam = cam_load(text);
    const YkCamShape *shape = &cam.design->shape;
    for (double x = 0.05; x < 2 * YK_PI; x += 0.31) {
        YkCamPoint point;
        double d[YK_LAW_ORDER + 1];
        yk_law_eval(cam.design->law->law, x, d);
        point = yk_cam_shape_at(shape, x, d);
        if (shape->face == YK_CAM_FACE_FLAT) {
            YkVec normal = yk_vec(point.normal[0], point.normal[1]);
            double h = point.surface[0] * normal.x + point.surface[1] * normal.y;
            CHECK_NEAR(over_surface(o, normal, true), h, 2e-9);
        } else {
            CHECK_NEAR(over_surface(o, yk_vec(point.pitch[0], point.pitch[1]), false), shape->roller,
                       shape->roller > 0 ? 2e-8 : 3e-6); // an edge: half the distance of two points
        }
        const double h = 1e-4; // each derivative by differences of the one before
        for (int m = 1; m <= YK_LAW_ORDER; m++) {
            bool is_joint = false;
            for (size_t s = 0; s < yk_law_segment_count(cam.design->law->law); s++)
                is_joint |= fabs(yk_law_segment(cam.design->law->law, s).to - x) < 2 * h;
            double slope = (lift(&cam, x + h, m - 1) - lift(&cam, x - h, m - 1)) / (2 * h);
            if (!is_joint) CHECK_NEAR(d[m], slope, 1e-5 * (1 + fabs(d[m])));
        }
    }
    cam_free(&cam);
}

static void the_follower_touches_the_surface_everywhere(void **state)
{
    (void)state;
    const double convex[4] = {-40 * DEG, 30 * DEG, 90 * DEG, 165 * DEG};
    const Oval full = oval_of(convex, 0.03, 0.008);
    for (int k = 0; k < 4; k++) assert_true(full.radius[k] > 0);
    static const char *const slides[] = {SLIDE,
                                         "bodies: {shaft: {}, tappet: {}}\njoints: {K: {pin: [shaft, ground], angle: "
                                         "theta}, T: {slide: [ground, tappet], along: 200 deg, distance: s}}\n"};
    for (int i = 0; i < 2; i++) {
        check_contact(&full, "roller: 0.012, offset: 0.004", slides[i]);
        check_contact(&full, "offset: -0.006", slides[i]);
        check_contact(&full, "face: flat", slides[i]);
    }
    check_contact(&full, "roller: 0.01, at: P", PIVOT);
    check_contact(&full, "face: flat, offset: 0.003", PIVOT);
}

// Between flank and nose the flanks are hollow: the normal turns back.
static void a_roller_follows_a_hollow_flank(void **state)
{
    (void)state;
    const double change[4] = {-35 * DEG, -50 * DEG, 95 * DEG, 80 * DEG};
    const Oval hollow = oval_of(change, 0.03, 0.008);
    assert_true(hollow.radius[1] < -0.02 && hollow.radius[3] < -0.02);
    check_contact(&hollow, "roller: 0.012, offset: 0.002", SLIDE);
    const double gentle[4] = {-10 * DEG, -20 * DEG, 75 * DEG, 62 * DEG};
    const Oval oval = oval_of(gentle, 0.03, 0.008);
    check_contact(&oval, "roller: 0.01, at: P", PIVOT);
}

static void an_eccentric_circle_is_a_crank_and_a_rod(void **state)
{
    (void)state;
    Cam cam = cam_load("cams: {c: {cam: shaft, follower: tappet, face: flat, base: 30 mm, "
                       "arcs: [{center: [8 mm, 0], radius: 38 mm}]}}\n" SLIDE);
    for (double x = 0; x < 2 * YK_PI; x += 0.17) CHECK_NEAR(lift(&cam, x, 0), 0.008 + 0.008 * sin(x), 1e-16);
    assert_int_equal(yk_law_jumps(cam.design->law->law, NULL, 0), 0);
    cam_free(&cam);
}

static void what_no_follower_can_touch_is_refused(void **state)
{
    (void)state;
#define ARCS(keys) "cams:\n c: {cam: shaft, follower: tappet, base: 30 mm, " keys "}\n" SLIDE
    fixture_refused(ARCS("arcs: [{center: [0, 0], radius: 30 mm}, {center: [10 mm, 0], radius: 21 mm}]"),
                    YK_CODE_CAM_ARCS, 2, 56, "0.01 m apart, the radii differ by 0.009 m");
    fixture_refused(ARCS("arcs: [{center: [0, 0], radius: 30 mm}, line, line]"), YK_CODE_CAM_ARCS, 2, 89, "no line");
    fixture_refused(ARCS("arcs: [{center: [0, 0], radius: 30 mm}, line, {center: [9 mm, 0], radius: 20 mm}, line]"),
                    YK_CODE_CAM_ARCS, 2, 89, "no line");
    fixture_refused(ARCS("roller: 8 mm, arcs: {nose: 5 mm, lift: 40 mm, angle: 60 deg}"), YK_CODE_CAM_ARCS, 2, 69,
                    "jams");
    fixture_refused(ARCS("face: flat, arcs: {nose: 5 mm, lift: 20 mm, angle: 60 deg}"), YK_CODE_CAM_ARCS, 2, 67,
                    "hollow");
    fixture_refused(ARCS("arcs: {nose: 5 mm, lift: 20 mm, flank: 31 mm}"), YK_CODE_CAM_ARCS, 2, 55, "no flank");
    fixture_refused(ARCS("arcs: {nose: 5 mm, lift: 20 mm}"), YK_CODE_CAM_ARCS, 2, 55, "the angle of action");
    fixture_refused(ARCS("arcs: {nose: 5 mm, lift: 0, angle: 90 deg}"), YK_CODE_CAM_ARCS, 2, 74, "`lift`");
    fixture_refused(ARCS("arcs: [{center: [0, 0], radius: -30 mm}]"), YK_CODE_CAM_ARCS, 2, 56, "hollow");
    fixture_refused(ARCS("arcs: []"), YK_CODE_CAM_ARCS, 2, 55, "no arcs");
#undef ARCS
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tangent_cam_lifts_its_roller_as_books_say),
        cmocka_unit_test(a_circular_arc_cam_lifts_its_flat_face_as_books_say),
        cmocka_unit_test(the_follower_touches_the_surface_everywhere),
        cmocka_unit_test(a_roller_follows_a_hollow_flank),
        cmocka_unit_test(an_eccentric_circle_is_a_crank_and_a_rod),
        cmocka_unit_test(what_no_follower_can_touch_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
