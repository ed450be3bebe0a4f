// Contact force, torque and jump speed: against the equations written out, closed forms, and the energy.
#include "design/cam_check.h"

// Harmonic up and down without dwell: s = h (1 - cos x) / 2.
#define HARMONIC                                                                                                       \
    "laws: {lift: {period: 2*pi, segments: [{rise: {to: pi, by: 20 mm, law: harmonic}}, "                              \
    "{fall: {to: 2*pi, by: 20 mm, law: harmonic}}]}}\n"
#define CAM "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 60 mm, roller: 9 mm}}\n"

static void springs_weight_and_efforts_press_the_follower(void **state)
{
    (void)state;
    Cam cam = cam_load("gravity: [0, -9.81 m/s^2]\n" HARMONIC CAM SLIDE
                       "springs: {k: {along: s, stiffness: 3000 N/m, length: -15 mm, damping: 2 N*s/m}}\n"
                       "efforts: {s: -10 N - 3 N/m * s - 0.5 N*s/m * s.rate}\n");
    YkCamLoads loads = yk_cam_loads(cam.design);
    assert_true(loads.has_mass && loads.has_spring && !loads.is_partial);
    CHECK_NEAR(loads.inertia, 0.2, 1e-16);
    CHECK_NEAR(loads.preload, 45, 1e-12);
    double w = 62.83185307179586;
    CHECK_NEAR(yk_cam_size(cam.design).speed, w, 1e-12);
    for (double x = 0; x < 6.2; x += 0.1) {
        YkCamPoint p = yk_cam_at(cam.design, x);
        double s = 0.01 * (1 - cos(x)), v = 0.01 * sin(x) * w, a = 0.01 * cos(x) * w * w;
        double effort = 0.2 * (a + 9.81) + 3000 * (s + 0.015) + 2 * v + 10 + 3 * s + 0.5 * v;
        YkCamForce f = yk_cam_force(cam.design, w, x);
        CHECK_NEAR(f.effort, effort, 1e-10);
        CHECK_NEAR(f.contact * cos(p.pressure_angle), effort, 1e-10);
        CHECK_NEAR(f.torque * w, effort * v, 1e-9);
    }
    cam_free(&cam);
}

// At the top: M w^2 h / 2 = k (h + L). It is the worst place while the springs' force grows more slowly than that.
static void the_jump_speed_of_a_harmonic_cam_has_a_closed_form(void **state)
{
    (void)state;
    Cam cam = cam_load(HARMONIC CAM SLIDE "springs: {k: {along: s, stiffness: 3000 N/m, length: -15 mm}}\n");
    double w = sqrt(3000 * (0.02 + 0.015) / (0.2 * 0.01));
    YkCamForceSummary f = yk_cam_force_summary(cam.design, 60);
    CHECK_NEAR(f.jump_speed, w, 1e-11 * w);
    CHECK_NEAR(f.jump_angle, YK_PI, 1e-4);
    CHECK_NEAR(f.torque_mean, 0, 1e-12); // no friction, no work over a turn
    CHECK_NEAR(yk_cam_force_summary(cam.design, w).contact_low.value, 0, 1e-9);
    assert_true(yk_cam_force_summary(cam.design, 1.01 * w).contact_low.value < 0);
    CHECK_NEAR(yk_cam_force_summary(cam.design, w).preload_needed, 45, 1e-9);
    double faster = 2 * w, needed = 0.2 * faster * faster * 0.01 - 3000 * 0.02;
    CHECK_NEAR(yk_cam_force_summary(cam.design, faster).preload_needed, needed, 1e-9 * needed);
    cam_free(&cam);
}

// A damper takes c v^2; over a turn that is c w (h/2)^2 / 2 as a mean torque.
static void the_mean_torque_is_what_dampers_take(void **state)
{
    (void)state;
    Cam cam = cam_load(HARMONIC CAM SLIDE "springs: {k: {along: s, stiffness: 3000 N/m, damping: 40 N*s/m}}\n");
    CHECK_NEAR(yk_cam_force_summary(cam.design, 50).torque_mean, 40 * 50 * 0.01 * 0.01 / 2, 1e-12);
    cam_free(&cam);
}

// The work of the camshaft is the change of the energies, by differences.
static void the_torque_changes_the_energy(void **state)
{
    (void)state;
    const double w = 80, k = 12, inertia = 2e-4 + 0.3 * (0.01 * 0.01 + 0.02 * 0.02), step = 1e-5;
    Cam cam = cam_load("gravity: [2 m/s^2, -9 m/s^2]\n" SWING
                       "cams: {c: {cam: shaft, follower: rocker, law: lift, base: 40 mm, roller: 9 mm, at: P}}\n" PIVOT
                       "springs: {k: {along: phi, stiffness: 12 N*m/rad, angle: -0.2 rad}}\n");
    CHECK_NEAR(yk_cam_loads(cam.design).inertia, inertia, 1e-16);
    for (double x = 0.05; x < 6.2; x += 0.1) {
        double energy[2];
        for (int i = 0; i < 2; i++) {
            YkCamPoint p = yk_cam_at(cam.design, x + (i ? step : -step));
            // the arm to P points to the roller's centre; the mass centre (10, 20) in axes in which P is (0, 70)
            double c = cos(-(x + (i ? step : -step))), s = sin(-(x + (i ? step : -step)));
            YkVec at = yk_vec(c * p.pitch[0] + s * p.pitch[1], -s * p.pitch[0] + c * p.pitch[1]);
            YkVec arm = yk_sub(at, yk_vec(0.08, 0.03)), y = yk_scale(1 / yk_norm(arm), arm);
            YkVec center = yk_add(yk_scale(0.02, y), yk_scale(0.01, yk_vec(y.y, -y.x)));
            double speed = p.lift[1] * w, turn = p.lift[0] + 0.2;
            energy[i] = inertia * speed * speed / 2 + k * turn * turn / 2 - 0.3 * (2 * center.x - 9 * center.y);
        }
        CHECK_NEAR(yk_cam_force(cam.design, w, x).torque, (energy[1] - energy[0]) / (2 * step), 1e-7);
    }
    cam_free(&cam);
}

// Of a flat face that turns the contact's lever is its distance along the face from the pivot's foot.
static void the_contact_force_of_a_turning_face_has_its_lever(void **state)
{
    (void)state;
    Cam cam = cam_load(SWING "cams: {c: {cam: shaft, follower: rocker, law: lift, base: 40 mm, face: flat}}\n" PIVOT
                             "springs: {k: {along: phi, stiffness: 12 N*m/rad, angle: -0.2 rad}}\n");
    for (double x = 0.05; x < 6.2; x += 0.1) {
        YkCamPoint p = yk_cam_at(cam.design, x);
        YkCamForce f = yk_cam_force(cam.design, 0, x);
        YkVec lever = yk_sub(yk_vec(p.contact[0], p.contact[1]), yk_vec(0.08, 0.03));
        YkVec push = yk_vec(cos(x) * p.normal[0] - sin(x) * p.normal[1], sin(x) * p.normal[0] + cos(x) * p.normal[1]);
        CHECK_NEAR(f.contact * yk_cross(lever, push), 12 * (p.lift[0] + 0.2), 1e-12);
    }
    cam_free(&cam);
}

static void what_cannot_be_counted_is_told(void **state)
{
    (void)state;
    Cam bare = cam_load(HARMONIC CAM SLIDE);
    assert_false(yk_cam_loads(bare.design).is_partial);
    assert_false(yk_cam_loads(bare.design).has_spring);
    CHECK_NEAR(yk_cam_force_summary(bare.design, 10).jump_speed, 0, 0); // nothing holds it
    cam_free(&bare);
    Cam force = cam_load(HARMONIC CAM SLIDE "forces: {F: {body: tappet, value: [0, -5 N]}}\n");
    assert_true(yk_cam_loads(force.design).is_partial);
    cam_free(&force);
}

// Held from both sides nothing can jump.
static void a_groove_has_no_jump_speed(void **state)
{
    (void)state;
    Cam cam = cam_load(HARMONIC "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 60 mm, roller: 9 mm, "
                                "groove: true}}\n" SLIDE);
    assert_true(isinf(yk_cam_force_summary(cam.design, 10).jump_speed));
    cam_free(&cam);
}

// The mirror image about the x axis: a law below 0, and every effort along the coordinate of the other sign.
static void a_law_below_zero_presses_as_its_mirror_image(void **state)
{
    (void)state;
    Cam cam[2];
    for (int k = 0; k < 2; k++) {
        char text[2000];
        const char *sign = k == 0 ? "" : "-";
        snprintf(text, sizeof text,
                 "gravity: [3 m/s^2, %s9.81 m/s^2]\n"
                 "laws: {lift: {period: 2*pi, segments: [{%s: {to: pi, by: 20 deg, law: cycloidal}}, "
                 "{%s: {to: 2*pi, by: 20 deg, law: 3-4-5}}]}}\n"
                 "cams: {c: {cam: shaft, follower: rocker, law: lift, base: 40 mm, roller: 10 mm, at: P}}\n"
                 "bodies: {ground: {points: {O: [0, 0], Q: [80 mm, %s30 mm]}}, shaft: {points: {O: [0, 0]}}, rocker: "
                 "{points: {Q: [0, 0], P: [%s]}, mass: 0.3 kg, center: [-10 mm, %s20 mm], inertia: 2e-4}}\n"
                 "joints: {O: {pin: %s, angle: theta}, Q: {pin: [ground, rocker], angle: phi}}\n"
                 "springs: {k: {along: phi, stiffness: 3, angle: %s10 deg}}\ndrives: {theta: 600 rpm * t}\n",
                 sign, k == 0 ? "rise" : "fall", k == 0 ? "fall" : "rise", sign,
                 k == 0 ? "-80 mm, -80 mm" : "-80 mm, 80 mm", sign, k == 0 ? "[ground, shaft]" : "[shaft, ground]",
                 k == 0 ? "-" : "");
        cam[k] = cam_load(text);
    }
    for (double x = 0; x < 6.2; x += 0.1) {
        YkCamForce one = yk_cam_force(cam[0].design, 60, x), other = yk_cam_force(cam[1].design, 60, x);
        CHECK_NEAR(one.effort, -other.effort, 1e-13);
        CHECK_NEAR(one.contact, other.contact, 1e-11);
        CHECK_NEAR(one.torque, other.torque, 1e-13);
    }
    YkCamForceSummary one = yk_cam_force_summary(cam[0].design, 60), other = yk_cam_force_summary(cam[1].design, 60);
    CHECK_NEAR(one.contact_low.value, other.contact_low.value, 1e-9);
    CHECK_NEAR(one.jump_speed, other.jump_speed, 1e-9 * one.jump_speed);
    CHECK_NEAR(one.preload_needed, -other.preload_needed, 1e-12);
    for (int k = 0; k < 2; k++) cam_free(&cam[k]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(springs_weight_and_efforts_press_the_follower),
        cmocka_unit_test(the_jump_speed_of_a_harmonic_cam_has_a_closed_form),
        cmocka_unit_test(the_mean_torque_is_what_dampers_take),
        cmocka_unit_test(the_torque_changes_the_energy),
        cmocka_unit_test(the_contact_force_of_a_turning_face_has_its_lever),
        cmocka_unit_test(what_cannot_be_counted_is_told),
        cmocka_unit_test(a_groove_has_no_jump_speed),
        cmocka_unit_test(a_law_below_zero_presses_as_its_mirror_image),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
