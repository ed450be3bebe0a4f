// Drawings of cams: what rides touches the outline at every pose, and a follower is drawn where it rides.
#include "check.h"
#include <stdlib.h>
#include <yoke/yoke.h>
#include "picture/drawing/drawing.h"

typedef struct Machine {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
    YkDrawing *drawing;
} Machine;

static Machine open_machine(const char *name)
{
    char path[500];
    Machine m = {0};
    snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, name);
    YkProblems *problems = yk_problems_new();
    m.model = yk_model_load(path, NULL, problems);
    m.mech = yk_mechanism_compile(m.model, NULL, problems);
    m.state = yk_state_new(m.mech);
    assert_non_null(m.state);
    assert_true(yk_state_set_time(m.state, 0, problems) >= 0 && yk_state_assemble(m.state) >= 0);
    m.drawing = yk_drawing_new(m.mech, NULL);
    assert_non_null(m.drawing);
    yk_problems_free(problems);
    return m;
}

static void close_machine(Machine *m)
{
    yk_drawing_free(m->drawing);
    yk_state_free(m->state);
    yk_mechanism_free(m->mech);
    yk_model_free(m->model);
}

// The distance of a point from a closed line.
static double distance_from(const YkCamVertex *line, size_t count, YkVec at)
{
    double least = INFINITY;
    for (size_t i = 0; i < count; i++) {
        YkVec a = {line[i].x, line[i].y}, b = {line[(i + 1) % count].x, line[(i + 1) % count].y}, d = yk_sub(b, a);
        double part = fmax(0, fmin(1, yk_dot(yk_sub(at, a), d) / fmax(yk_dot(d, d), 1e-30)));
        least = fmin(least, yk_norm(yk_sub(at, yk_add(a, yk_scale(part, d)))));
    }
    return least;
}

// The rider's place in the cam's axes, by the cam's own angle, is as far from the profile as its roller is large.
static void check_touch(const char *name)
{
    Machine m = open_machine(name);
    const YkCam *cam = &m.model->cams[0];
    YkCamDesign *design = yk_cam_design_new(m.model, 0);
    YkCamVertex *line;
    size_t count;
    double start = yk_state_input(m.state, 0).position;
    assert_int_equal(yk_cam_profile(design, YK_CAM_CURVE_SURFACE, 1e-5 * cam->base, 0, &line, &count), YK_OK);
    for (int k = 0; k < 24; k++) {
        YkFrame frames[8];
        yk_state_set_input(m.state, 0, (YkMotion){start + 2 * YK_PI * k / 24, 0, 0});
        assert_true(yk_state_solve(m.state) >= 0);
        assert_true(yk_drawing_place(m.drawing, m.state, frames));
        YkVec center = yk_drawing_cam_center(m.drawing, frames, 0), rider = yk_drawing_rider(m.drawing, frames, 0);
        YkVec at = yk_mul(yk_conj(frames[cam->cam].axis), yk_sub(rider, center));
        CHECK_NEAR(distance_from(line, count, at), cam->roller, 2e-5 * cam->base);
        YkVec point = cam->point == YK_NONE ? yk_vec(0, 0) : m.model->points[cam->point].at;
        YkVec follower = yk_frame_apply(frames[cam->follower], point);
        CHECK_NEAR(follower.x, rider.x, 1e-12);
        CHECK_NEAR(follower.y, rider.y, 1e-12);
    }
    yk_cam_vertices_free(line);
    yk_cam_design_free(design);
    close_machine(&m);
}

static void rollers_touch_their_cams(void **state)
{
    (void)state;
    check_touch("valve-cam");
    check_touch("cep-cam");
    check_touch("swing-cam");
}

// A flat face lies across the line of motion at its highest point of the cam: no point of the outline is beyond it.
static void a_flat_face_lies_on_its_cam(void **state)
{
    (void)state;
    Machine m = open_machine("flat-faced-cam");
    const YkCam *cam = &m.model->cams[0];
    YkCamDesign *design = yk_cam_design_new(m.model, 0);
    YkCamVertex *line;
    size_t count;
    assert_int_equal(yk_cam_profile(design, YK_CAM_CURVE_SURFACE, 1e-5 * cam->base, 0, &line, &count), YK_OK);
    for (int k = 0; k < 24; k++) {
        YkFrame frames[8];
        double highest = -INFINITY;
        yk_state_set_input(m.state, 0, (YkMotion){2 * YK_PI * k / 24, 0, 0});
        assert_true(yk_state_solve(m.state) >= 0);
        assert_true(yk_drawing_place(m.drawing, m.state, frames));
        YkVec up = yk_mul(frames[cam->carrier].axis, cam->along);
        for (size_t i = 0; i < count; i++)
            highest = fmax(highest, yk_dot(up, yk_mul(frames[cam->cam].axis, yk_vec(line[i].x, line[i].y))));
        YkVec center = yk_drawing_cam_center(m.drawing, frames, 0);
        CHECK_NEAR(yk_dot(up, yk_sub(yk_drawing_rider(m.drawing, frames, 0), center)), highest, 2e-5 * cam->base);
    }
    yk_cam_vertices_free(line);
    yk_cam_design_free(design);
    close_machine(&m);
}

static void equations_keep_the_follower_where_they_have_it(void **state)
{
    (void)state;
    Machine m = open_machine("../tests/bad/W0474-cam-turned"); // its points are not those of lift 0
    YkFrame moved[8], kept[8];
    assert_true(yk_drawing_place(m.drawing, m.state, moved));
    m.drawing->keeps_followers = true;
    assert_true(yk_drawing_place(m.drawing, m.state, kept));
    size_t rocker = yk_model_find_body(m.model, "rocker");
    CHECK_NEAR(atan2(kept[rocker].axis.y, kept[rocker].axis.x), yk_state_body(m.state, rocker).position, 1e-12);
    assert_true(yk_norm(yk_sub(kept[rocker].axis, moved[rocker].axis)) > 0.1);
    close_machine(&m);
}

// A follower that slides is moved to where it rides only if the line of its guide begins at the cam's centre, so that
// the guide's point says where, and if nothing else is attached to it.
static void only_what_rides_alone_is_moved(void **unused)
{
    (void)unused;
    static const char parts[] =
        "laws: {lift: {period: 2*pi, segments: [{rise: {to: 120 deg, by: 20 mm, law: cycloidal}}, "
        "{fall: {to: 360 deg, by: 20 mm, law: cycloidal}}]}}\n"
        "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 40 mm, roller: 9 mm}}\n"
        "bodies: {ground: {points: {K: [0, 0], G: [0, 100 mm]}}, shaft: {points: {K: [0, 0]}}, "
        "tappet: {points: {T: [0, 0]}}%s}\n"
        "joints: {K: {pin: [ground, shaft], angle: theta}, "
        "S: {slide: [ground, tappet], along: y, from: %s, to: T, distance: s}%s}\ndrives: {theta: 1 rad/s * t}\n";
    static const char arm[] = ", arm: {points: {T: [0, 0], Z: [50 mm, 0]}}",
                      pin[] = ", T: {pin: [tappet, arm], angle: q}";
    for (int k = 0; k < 4; k++) {
        char text[1500];
        snprintf(text, sizeof text, parts, k & 2 ? arm : "", k & 1 ? "G" : "K", k & 2 ? pin : "");
        YkProblems *problems = yk_problems_new();
        YkModel *model = yk_model_parse(text, strlen(text), "t.yaml", NULL, problems);
        assert_non_null(model);
        YkMechanism *mech = yk_mechanism_compile(model, NULL, problems);
        YkState *pose = yk_state_new(mech);
        assert_true(yk_state_set_time(pose, 0.7, problems) >= 0 && yk_state_assemble(pose) >= 0);
        YkDrawing *drawing = yk_drawing_new(mech, NULL);
        YkFrame frames[8];
        assert_true(yk_drawing_place(drawing, pose, frames));
        size_t own = yk_model_find_point(model, "tappet.T");
        YkPointMotion there = yk_state_point(pose, own);
        YkVec drawn = yk_frame_apply(frames[model->points[own].body], model->points[own].at),
              rider = yk_drawing_rider(drawing, frames, 0);
        double moved = yk_norm(yk_sub(drawn, yk_vec(there.position[0], there.position[1])));
        if (k == 0) CHECK_NEAR(yk_norm(yk_sub(drawn, rider)), 0, 1e-12);
        assert_true(k == 0 ? moved > 1e-3 : moved < 1e-12);
        double lift = yk_state_coordinate(pose, yk_coordinate_find(mech, "s")).position;
        CHECK_NEAR(yk_norm(rider), 0.049 + lift, 1e-9); // on the cam in any case
        yk_drawing_free(drawing);
        yk_state_free(pose);
        yk_mechanism_free(mech);
        yk_model_free(model);
        yk_problems_free(problems);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rollers_touch_their_cams),
        cmocka_unit_test(a_flat_face_lies_on_its_cam),
        cmocka_unit_test(only_what_rides_alone_is_moved),
        cmocka_unit_test(equations_keep_the_follower_where_they_have_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
