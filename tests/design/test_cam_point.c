// The geometry of a cam at one angle, against ways that share nothing with it: envelopes of circles and lines, the
// instant centre, cams that are circles, and the formulas of the textbooks.
#include "design/cam_check.h"

static void lift_at(const Cam *cam, double angle, double d[5])
{
    yk_law_eval(cam->design->law->law, angle, d);
}

// What follows is written out in coordinates, cam axes by a plain rotation.
static YkVec turned_back(YkVec at, double angle)
{
    return yk_vec(cos(angle) * at.x + sin(angle) * at.y, -sin(angle) * at.x + cos(angle) * at.y);
}

static const char translating[] = LIFT "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 40 mm, "
                                       "roller: 9 mm, offset: 7 mm}}\n" SLIDE;
static const char oscillating[] = SWING "cams: {c: {cam: shaft, follower: rocker, law: lift, base: 40 mm, "
                                        "roller: 9 mm, at: P}}\n" PIVOT;
static const char flat[] = LIFT "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 80 mm, face: flat}}\n" SLIDE;
static const char flat_oscillating[] = SWING "cams: {c: {cam: shaft, follower: rocker, law: lift, base: 40 mm, "
                                             "face: flat, offset: 5 mm}}\n" PIVOT;

// A roller's centre in the carrier: offset 7 mm to the right of a line that goes up.
static YkVec slide_center(const Cam *cam, double angle)
{
    double d[5];
    lift_at(cam, angle, d);
    return yk_vec(0.007, sqrt(0.049 * 0.049 - 0.007 * 0.007) + d[0]);
}

// Pivot at (80, 30) mm, arm 70 mm; the arm's angle at lift 0 by bisection on the distance, lift towards larger angles.
static double arm_start(void)
{
    double gamma = atan2(30, 80), low = gamma + YK_PI, high = gamma + 2 * YK_PI; // distance grows between
    for (int i = 0; i < 200; i++) {
        double m = (low + high) / 2, x = 0.08 + 0.07 * cos(m), y = 0.03 + 0.07 * sin(m);
        if (sqrt(x * x + y * y) < 0.049)
            low = m;
        else
            high = m;
    }
    return low;
}

static YkVec arm_center(const Cam *cam, double angle)
{
    double d[5], psi;
    lift_at(cam, angle, d);
    psi = arm_start() + d[0];
    return yk_vec(0.08 + 0.07 * cos(psi), 0.03 + 0.07 * sin(psi));
}

// Point x lies on the envelope of the circles of radius r about c(angle): on the circle, and |x - c| does not change
// as the angle does.
static void check_envelope(const Cam *cam, YkVec (*center)(const Cam *, double), double r)
{
    const double step = 1e-5;
    for (double angle = 0.001; angle < 2 * YK_PI; angle += 0.05) {
        YkCamPoint p = yk_cam_at(cam->design, angle);
        YkVec x = yk_vec(p.surface[0], p.surface[1]);
        YkVec here = turned_back(center(cam, angle), angle);
        double before = yk_norm(yk_sub(x, turned_back(center(cam, angle - step), angle - step)));
        double after = yk_norm(yk_sub(x, turned_back(center(cam, angle + step), angle + step)));
        CHECK_NEAR(p.pitch[0], here.x, 1e-13);
        CHECK_NEAR(p.pitch[1], here.y, 1e-13);
        CHECK_NEAR(yk_norm(yk_sub(x, here)), r, 1e-13);
        CHECK_NEAR((after - before) / (2 * step), 0, 1e-9);
        assert_true(yk_norm(x) < yk_norm(here)); // the cam is inside
        YkVec outer = yk_vec(p.outer[0], p.outer[1]);
        CHECK_NEAR(yk_norm(yk_add(yk_sub(outer, here), yk_sub(x, here))), 0, 1e-13);
    }
}

static void a_rollers_surface_is_the_envelope_of_its_circles(void **state)
{
    (void)state;
    Cam a = cam_load(translating), b = cam_load(oscillating);
    check_envelope(&a, slide_center, 0.009);
    check_envelope(&b, arm_center, 0.009);
    cam_free(&a);
    cam_free(&b);
}

// The distance of x from the flat face at an angle: the face is y = 80 mm + s in the carrier.
static double off_face(const Cam *cam, YkVec x, double angle)
{
    double d[5];
    lift_at(cam, angle, d);
    return sin(angle) * x.x + cos(angle) * x.y - (0.08 + d[0]);
}

// A face through the pivot's side: n = (cos nu, sin nu), n . (X - Q) = -5 mm; at lift 0 it is 40 mm from the origin.
static double off_turning_face(const Cam *cam, YkVec x, double angle)
{
    double d[5], gamma = atan2(30, 80), f = hypot(0.08, 0.03), nu;
    lift_at(cam, angle, d);
    nu = gamma - acos(0.045 / f) + d[0];
    YkVec at = yk_vec(cos(angle) * x.x - sin(angle) * x.y, sin(angle) * x.x + cos(angle) * x.y);
    return cos(nu) * (at.x - 0.08) + sin(nu) * (at.y - 0.03) + 0.005;
}

static void a_flat_faces_surface_is_the_envelope_of_its_lines(void **state)
{
    (void)state;
    const struct {
        const char *text;
        double (*off)(const Cam *, YkVec, double);
    } cases[] = {{flat, off_face}, {flat_oscillating, off_turning_face}};
    const double step = 1e-5;
    for (size_t i = 0; i < 2; i++) {
        Cam cam = cam_load(cases[i].text);
        for (double angle = 0.001; angle < 2 * YK_PI; angle += 0.05) {
            YkCamPoint p = yk_cam_at(cam.design, angle);
            YkVec x = yk_vec(p.surface[0], p.surface[1]);
            CHECK_NEAR(cases[i].off(&cam, x, angle), 0, 1e-13);
            double slope = (cases[i].off(&cam, x, angle + step) - cases[i].off(&cam, x, angle - step)) / (2 * step);
            CHECK_NEAR(slope, 0, 1e-9);
            if (p.lift[0] == 0) CHECK_NEAR(cases[i].off(&cam, yk_vec(0, 0), angle), i == 0 ? -0.08 : -0.04, 1e-13);
        }
        cam_free(&cam);
    }
}

// Aronhold and Kennedy: the contact normal meets the line of centres in the instant centre of cam and follower.
static void the_contact_normal_passes_through_the_instant_centre(void **state)
{
    (void)state;
    const char *texts[] = {translating, oscillating, flat, flat_oscillating};
    for (size_t i = 0; i < 4; i++) {
        Cam cam = cam_load(texts[i]);
        for (double angle = 0; angle < 2 * YK_PI; angle += 0.03) {
            YkCamPoint p = yk_cam_at(cam.design, angle);
            double v = p.lift[1], x = v / (v - 1);
            YkVec centre = i % 2 == 0 ? yk_vec(v, 0) : yk_vec(0.08 * x, 0.03 * x);
            YkVec normal = yk_vec(cos(angle) * p.normal[0] - sin(angle) * p.normal[1],
                                  sin(angle) * p.normal[0] + cos(angle) * p.normal[1]);
            YkVec to = yk_sub(yk_vec(p.contact[0], p.contact[1]), centre);
            CHECK_NEAR(yk_cross(normal, to), 0, 1e-14);
            CHECK_NEAR(yk_norm(normal), 1, 1e-14);
        }
        cam_free(&cam);
    }
}

// Norton 2009, eq. 7.1 and 7.2: tan phi = (v - e) / (s + d), d = sqrt(Rp^2 - e^2).
static void pressure_angle_and_curvature_are_the_textbooks(void **state)
{
    (void)state;
    Cam cam = cam_load(translating);
    double e = 0.007, d0 = sqrt(0.049 * 0.049 - e * e);
    for (double angle = 0; angle < 2 * YK_PI; angle += 0.03) {
        YkCamPoint p = yk_cam_at(cam.design, angle);
        double s = p.lift[0], v = p.lift[1], a = p.lift[2], y = s + d0;
        CHECK_NEAR(p.pressure_angle, atan((v - e) / y), 1e-14);
        double square = y * y + (v - e) * (v - e), bend = y * y + (v - e) * (2 * v - e) - y * a;
        CHECK_NEAR(1 / p.pitch_radius, bend / (square * sqrt(square)), 1e-12);
        CHECK_NEAR(p.surface_radius, p.pitch_radius - 0.009, 1e-12);
        CHECK_NEAR(p.fullness, 1 - 0.009 / p.pitch_radius, 1e-12);
    }
    cam_free(&cam);
}

// The power of the contact force in both bodies is the same: cos(phi) of an oscillating follower by velocities.
static void the_pressure_angle_is_that_of_force_and_velocity(void **state)
{
    (void)state;
    Cam cam = cam_load(oscillating);
    for (double angle = 0.01; angle < 2 * YK_PI; angle += 0.05) {
        YkCamPoint p = yk_cam_at(cam.design, angle);
        YkVec centre = arm_center(&cam, angle), arm = yk_sub(centre, yk_vec(0.08, 0.03));
        YkVec push = yk_sub(centre, yk_vec(p.contact[0], p.contact[1]));
        double cosine = yk_dot(push, yk_quarter(arm)) / (yk_norm(push) * yk_norm(arm));
        CHECK_NEAR(cos(p.pressure_angle), cosine, 1e-12);
        assert_true(p.pressure_angle > -YK_PI / 2 && p.pressure_angle < YK_PI / 2);
    }
    cam_free(&cam);
}

// The circle through three near points of the surface.
static double circle_radius(YkVec a, YkVec b, YkVec c)
{
    double area = yk_cross(yk_sub(b, a), yk_sub(c, a));
    return -yk_norm(yk_sub(a, b)) * yk_norm(yk_sub(b, c)) * yk_norm(yk_sub(c, a)) / (2 * area); // run clockwise
}

static void radii_of_curvature_are_those_of_the_curves(void **state)
{
    (void)state;
    const char *texts[] = {translating, oscillating, flat, flat_oscillating};
    const double step = 1e-3;
    for (size_t i = 0; i < 4; i++) {
        Cam cam = cam_load(texts[i]);
        for (double angle = 0.011; angle < 2 * YK_PI; angle += 0.05) {
            YkCamPoint p = yk_cam_at(cam.design, angle), b = yk_cam_at(cam.design, angle - step),
                       c = yk_cam_at(cam.design, angle + step);
            double radius = circle_radius(yk_vec(b.surface[0], b.surface[1]), yk_vec(p.surface[0], p.surface[1]),
                                          yk_vec(c.surface[0], c.surface[1]));
            if (fabs(p.lift[2]) + fabs(b.lift[2]) + fabs(c.lift[2]) > 0 &&
                (p.lift[2] == 0 || b.lift[2] == 0 || c.lift[2] == 0))
                continue;                         // a joint between
            if (p.fullness < 0) radius = -radius; // cut away: the curve runs back there
            CHECK_NEAR(1 / radius, 1 / p.surface_radius, 2e-3 * fabs(1 / p.surface_radius) + 0.05);
        }
        cam_free(&cam);
    }
}

// A circle of radius R about a point E from the shaft is the cam: every follower must give it back.
static void a_circle_is_recovered_from_the_motion_it_gives(void **state)
{
    (void)state;
    const double R = 0.05, E = 0.012, r = 0.008, L = R + r;
    for (int turn = -1; turn <= 1; turn += 2) {
        YkCamShape shape = {.face = YK_CAM_FACE_ROLLER,
                            .turn = turn,
                            .swing = 1,
                            .sign = 1,
                            .base = R - E,
                            .roller = r,
                            .along = yk_vec(0, 1)};
        assert_true(yk_cam_shape_fit(&shape));
        for (double x = 0; x < 6.3; x += 0.1) { // lowest at x = 0
            double root = sqrt(L * L - E * E * sin(x) * sin(x)), sc = sin(x) * cos(x);
            double root1 = -E * E * sc / root, root2 = -E * E * cos(2 * x) / root - root1 * root1 / root;
            double lift[5] = {root - E * cos(x) - (L - E), root1 + E * sin(x), root2 + E * cos(x), 0, 0};
            YkCamPoint p = yk_cam_shape_at(&shape, x, lift);
            CHECK_NEAR(p.pitch_radius, L, 1e-13);
            CHECK_NEAR(p.surface_radius, R, 1e-13);
            CHECK_NEAR(hypot(p.surface[0], p.surface[1] + E), R, 1e-14);
        }
        YkCamShape face = {
            .face = YK_CAM_FACE_FLAT, .turn = turn, .swing = 1, .sign = 1, .base = R - E, .along = yk_vec(0, 1)};
        assert_true(yk_cam_shape_fit(&face));
        for (double x = 0; x < 6.3; x += 0.1) {
            double lift[5] = {E * (1 - cos(x)), E * sin(x), E * cos(x), 0, 0};
            YkCamPoint p = yk_cam_shape_at(&face, x, lift);
            CHECK_NEAR(p.surface_radius, R, 1e-15);
            CHECK_NEAR(hypot(p.surface[0], p.surface[1] + E), R, 1e-15);
            CHECK_NEAR(p.reach, turn * E * sin(x), 1e-15);
        }
    }
}

// A circle under an oscillating flat face through the pivot: f sin(lift + ...) follows from E cos(..) + R.
static void a_circle_is_recovered_from_an_oscillating_face(void **state)
{
    (void)state;
    const double R = 0.05, E = 0.012, f = 0.1;
    YkCamShape shape = {.face = YK_CAM_FACE_FLAT,
                        .oscillates = true,
                        .turn = 1,
                        .swing = 1,
                        .sign = 1,
                        .base = 0.04,
                        .pivot = yk_vec(f, 0)};
    assert_true(yk_cam_shape_fit(&shape));
    for (double x = 0; x < 6.3; x += 0.1) {
        // the circle's centre in the carrier is E exp(i x); n . Q = n . centre + R with n at angle nu
        double nu = -1.0, d[5] = {0};
        for (int i = 0; i < 100; i++) {
            double g = f * cos(nu) - E * cos(nu - x) - R, slope = -f * sin(nu) + E * sin(nu - x);
            nu -= g / slope;
        }
        double slope = -f * sin(nu) + E * sin(nu - x), v = E * sin(nu - x) / slope; // dg = slope dnu - E sin(nu - x) dx
        double slope1 = -f * cos(nu) * v + E * cos(nu - x) * (v - 1);
        d[0] = nu - shape.start;
        d[1] = v;
        d[2] = (E * cos(nu - x) * (v - 1) - v * slope1) / slope;
        YkCamPoint p = yk_cam_shape_at(&shape, x, d);
        CHECK_NEAR(p.surface_radius, R, 1e-12);
        CHECK_NEAR(hypot(p.surface[0] - E, p.surface[1]), R, 1e-13);
    }
}

static void a_mirrored_cam_is_the_mirror_image(void **state)
{
    (void)state;
    YkCamShape shape = {.face = YK_CAM_FACE_ROLLER,
                        .turn = 1,
                        .swing = 1,
                        .sign = 1,
                        .base = 0.04,
                        .roller = 0.009,
                        .offset = 0.007,
                        .along = yk_vec(0, 1)};
    YkCamShape mirror = shape;
    mirror.turn = -1;
    mirror.offset = -0.007;
    assert_true(yk_cam_shape_fit(&shape) && yk_cam_shape_fit(&mirror));
    const double lift[5] = {0.01, 0.02, -0.01, 0, 0};
    YkCamPoint a = yk_cam_shape_at(&shape, 0.7, lift), b = yk_cam_shape_at(&mirror, 0.7, lift);
    CHECK_NEAR(a.surface[0], -b.surface[0], 1e-16);
    CHECK_NEAR(a.surface[1], b.surface[1], 1e-16);
    CHECK_NEAR(a.pitch_radius, b.pitch_radius, 1e-15);
    CHECK_NEAR(a.pressure_angle, -b.pressure_angle, 1e-15);
}

// Both rollers of a conjugate pair touch their cams, and stay the same distance apart.
static void conjugate_cams_hold_their_rollers_together(void **state)
{
    (void)state;
    Cam a = cam_load(LIFT "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 40 mm, roller: 9 mm, "
                          "conjugate: {span: 130 mm}}}\n" SLIDE);
    for (double angle = 0; angle < 6.3; angle += 0.1) {
        YkCamPoint p = yk_cam_at(a.design, angle), q = yk_cam_conjugate_at(a.design, angle);
        CHECK_NEAR(hypot(p.pitch[0] - q.pitch[0], p.pitch[1] - q.pitch[1]), 0.13, 1e-15);
        CHECK_NEAR(hypot(q.pitch[0], q.pitch[1]), 0.13 - 0.049 - p.lift[0], 1e-15);
        CHECK_NEAR(hypot(q.pitch[0] - q.surface[0], q.pitch[1] - q.surface[1]), 0.009, 1e-15);
        assert_true(hypot(q.surface[0], q.surface[1]) < hypot(q.pitch[0], q.pitch[1]));
    }
    cam_free(&a);
    Cam b = cam_load(SWING "cams: {c: {cam: shaft, follower: rocker, law: lift, base: 40 mm, roller: 9 mm, at: P, "
                           "conjugate: {angle: 80 deg, arm: 60 mm, roller: 8 mm}}}\n" PIVOT);
    for (double angle = 0; angle < 6.3; angle += 0.1) {
        YkCamPoint p = yk_cam_at(b.design, angle), q = yk_cam_conjugate_at(b.design, angle);
        double apart = sqrt(0.07 * 0.07 + 0.06 * 0.06 - 2 * 0.07 * 0.06 * cos(80 * DEG));
        CHECK_NEAR(hypot(p.pitch[0] - q.pitch[0], p.pitch[1] - q.pitch[1]), apart, 1e-14);
        CHECK_NEAR(hypot(q.pitch[0] - q.surface[0], q.pitch[1] - q.surface[1]), 0.008, 1e-15);
    }
    cam_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rollers_surface_is_the_envelope_of_its_circles),
        cmocka_unit_test(a_flat_faces_surface_is_the_envelope_of_its_lines),
        cmocka_unit_test(the_contact_normal_passes_through_the_instant_centre),
        cmocka_unit_test(pressure_angle_and_curvature_are_the_textbooks),
        cmocka_unit_test(the_pressure_angle_is_that_of_force_and_velocity),
        cmocka_unit_test(radii_of_curvature_are_those_of_the_curves),
        cmocka_unit_test(a_circle_is_recovered_from_the_motion_it_gives),
        cmocka_unit_test(a_circle_is_recovered_from_an_oscillating_face),
        cmocka_unit_test(a_mirrored_cam_is_the_mirror_image),
        cmocka_unit_test(conjugate_cams_hold_their_rollers_together),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
