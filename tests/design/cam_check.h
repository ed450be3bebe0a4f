// Shared by the tests of cams: models of cams, and the roller's centre found by plain trigonometry.
#ifndef TESTS_DESIGN_CAM_CHECK_H
#define TESTS_DESIGN_CAM_CHECK_H
#include "model/fixture.h"
#include "design/cams/cam.h"

#define DEG (YK_PI / 180)
#define SLIDE                                                                                                          \
    "bodies: {shaft: {}, tappet: {mass: 0.2 kg}}\n"                                                                    \
    "joints: {K: {pin: [ground, shaft], angle: theta}, T: {slide: [ground, tappet], along: y, distance: s}}\n"         \
    "drives: {theta: 600 rpm * t}\n"
#define PIVOT                                                                                                          \
    "bodies: {ground: {points: {O: [0, 0], Q: [80 mm, 30 mm]}}, shaft: {points: {O: [0, 0]}}, "                        \
    "rocker: {points: {Q: [0, 0], P: [0, 70 mm]}, mass: 0.3 kg, center: [10 mm, 20 mm], inertia: 2e-4}}\n"             \
    "joints: {O: {pin: [ground, shaft], angle: theta}, Q: {pin: [ground, rocker], angle: phi}}\n"                      \
    "drives: {theta: 600 rpm * t}\n"
#define LIFT                                                                                                           \
    "laws: {lift: {period: 2*pi, segments: [{rise: {to: 120 deg, by: 20 mm, law: cycloidal}}, {dwell: {to: 150 "       \
    "deg}}, "                                                                                                          \
    "{fall: {to: 260 deg, by: 20 mm, law: 3-4-5}}, {dwell: {to: 360 deg}}]}}\n"
#define SWING                                                                                                          \
    "laws: {lift: {period: 2*pi, segments: [{rise: {to: 120 deg, by: 20 deg, law: cycloidal}}, {dwell: {to: 150 "      \
    "deg}}, "                                                                                                          \
    "{fall: {to: 260 deg, by: 20 deg, law: 4-5-6-7}}, {dwell: {to: 360 deg}}]}}\n"

typedef struct Cam {
    YkModel *model;
    YkCamDesign *design;
} Cam;

static inline Cam cam_load(const char *text)
{
    Cam cam = {.model = fixture_load(text)};
    assert_true(yk_model_cam_count(cam.model) > 0);
    cam.design = yk_cam_design_new(cam.model, 0);
    assert_non_null(cam.design);
    return cam;
}

static inline void cam_free(Cam *cam)
{
    yk_cam_design_free(cam->design);
    yk_model_free(cam->model);
}

#endif
