// Polygons: every vector is the engine's, closes with the others, and lies as it would be drawn by hand.
#include "assembled.h"
#include <glob.h>
#include <stdlib.h>
#include <strings.h>
#include "base/codes.h"
#include "base/vec.h"
#include "model/model.h"

static bool open_moving(Assembled *m, const char *path, const char *text)
{
    return assembled_open(m, path, text, 0.02) && yk_state_has_rates(m->state);
}

static YkPolygonImage image(const YkPolygon *p, const char *name)
{
    for (size_t k = 0; k < yk_polygon_image_count(p); k++)
        if (strcmp(yk_polygon_image(p, k).name, name) == 0) return yk_polygon_image(p, k);
    print_error("no image %s\n", name);
    assert_true(false);
    return (YkPolygonImage){0};
}

// From the places of points alone: an image of a model's point is its velocity or acceleration.
static size_t check_images(const Assembled *m, const YkPolygon *p, bool is_velocity, double size)
{
    size_t known = 0;
    for (size_t k = 0; k < yk_polygon_image_count(p); k++) {
        YkPolygonImage is = yk_polygon_image(p, k);
        for (size_t i = 0; i < yk_model_joint_count(m->model); i++) {
            const YkJoint *j = &m->model->joints[i];
            if (strcasecmp(j->name, is.name) != 0 || j->point[1] == YK_NONE) continue;
            size_t side = j->body[1] == 0 ? 0 : 1;
            if (j->point[side] == YK_NONE || (side == 0 && j->kind != YK_PIN)) continue;
            YkPointMotion point = yk_state_point(m->state, (size_t)j->point[side]);
            for (int axis = 0; axis < 2; axis++)
                CHECK_NEAR(is.value[axis], (is_velocity ? point.velocity : point.acceleration)[axis], 1e-12 * size);
            known++;
        }
    }
    return known;
}

static void check_vectors(const YkPolygon *p, double size)
{
    for (size_t k = 0; k < yk_polygon_vector_count(p); k++) {
        YkPolygonVector v = yk_polygon_vector(p, k), next = yk_polygon_vector(p, k + 1);
        YkPolygonImage from = image(p, v.from), to = image(p, v.to);
        bool goes_on = k + 1 < yk_polygon_vector_count(p) && next.from == v.from && next.to == v.to &&
                       next.body == v.body && next.part != v.part && v.part != YK_POLYGON_SLIDING;
        bool is_first =
            k == 0 || !(yk_polygon_vector(p, k - 1).from == v.from && yk_polygon_vector(p, k - 1).to == v.to);
        for (int axis = 0; axis < 2; axis++) {
            if (is_first) CHECK_NEAR(v.start[axis], from.value[axis], 1e-12 * size);
            double end = v.start[axis] + v.value[axis];
            CHECK_NEAR(end, goes_on ? next.start[axis] : to.value[axis], 1e-12 * size);
        }
        assert_true(v.step < yk_polygon_step_count(p));
    }
}

static void every_vector_of_the_gallery_is_the_engines(void **state)
{
    (void)state;
    glob_t found;
    size_t machines = 0, images = 0;
    assert_int_equal(glob(YOKE_ROOT "/examples/*.yaml", 0, NULL, &found), 0);
    for (size_t k = 0; k < found.gl_pathc; k++) {
        Assembled m;
        bool is_open = open_moving(&m, found.gl_pathv[k], NULL);
        for (int kind = 0; is_open && kind < 2; kind++) {
            YkProblems *problems = yk_problems_new();
            YkPolygon *p = yk_polygon_new(m.state, (YkPolygonKind)kind, problems);
            if (!p) {
                assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_NO_POLYGON);
            } else {
                double size = 1e-300;
                for (size_t i = 0; i < yk_polygon_vector_count(p); i++) {
                    YkPolygonVector v = yk_polygon_vector(p, i);
                    size = fmax(size, hypot(v.start[0], v.start[1]) + hypot(v.value[0], v.value[1]));
                }
                check_vectors(p, size);
                images += check_images(&m, p, kind == 0, size);
                assert_non_null(yk_polygon_svg(p));
                machines += kind;
            }
            yk_polygon_free(p);
            yk_problems_free(problems);
        }
        assembled_close(&m);
    }
    globfree(&found);
    assert_true(machines >= 40);
    assert_true(images >= 200);
}

// An offset slider-crank at a pose that is worked out by hand: crank 3 upright, rod 5 to a line on the ground.
static void a_slider_crank_by_hand(void **state)
{
    (void)state;
    Assembled m;
    static const char text[] =
        "bodies:\n  ground: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0], A: [3, 0]}}\n"
        "  rod: {points: {A: [0, 0], B: [5, 0]}}\n  slider: {points: {B: [0, 0]}}\n"
        "joints:\n  O: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
        "  B: {pin: [rod, slider]}\n  S: {slide: [ground, slider], distance: s}\n"
        "drives: {theta: 90 deg + 2 rad/s * (t - 0.02 s)}\nstart: {phi: -127 deg, s: 4}\n";
    assert_true(open_moving(&m, NULL, text));
    YkPolygon *p = yk_polygon_new(m.state, YK_POLYGON_VELOCITY, NULL);
    assert_int_equal(yk_polygon_step_count(p), 2);
    CHECK_NEAR(image(p, "a").value[0], -6, 1e-12); // the rod only shifts here
    CHECK_NEAR(image(p, "b").value[0], -6, 1e-12);
    CHECK_NEAR(image(p, "b").value[1], 0, 1e-12);
    assert_non_null(strstr(yk_polygon_step(p, 0), "crank, whose motion is given: 2 rad/s"));
    assert_null(yk_polygon_step(p, 2));
    yk_polygon_free(p);
    p = yk_polygon_new(m.state, YK_POLYGON_ACCELERATION, NULL);
    // a = 12 downwards; the rod has no rate, so that b = 12 * 3/4 to the left or right closes the polygon: to the
    // right.
    CHECK_NEAR(image(p, "a").value[1], -12, 1e-12);
    CHECK_NEAR(image(p, "b").value[0], 9, 1e-12);
    yk_polygon_free(p);
    assembled_close(&m);
}

// The coupler of a parallelogram only shifts: what rounding leaves of its rates is told as 0, in numbers and words.
static void rounding_is_told_as_nothing(void **state)
{
    (void)state;
    static const char text[] =
        "bodies:\n  ground: {points: {O: [0, 0], C: [0.1, 0]}}\n  a: {points: {O: [0, 0], A: [0.05, 0]}}\n"
        "  b: {points: {A: [0, 0], B: [0.1, 0]}}\n  c: {points: {C: [0, 0], B: [0.05, 0]}}\n"
        "joints:\n  O: {pin: [ground, a], angle: q}\n  A: {pin: [a, b], angle: p}\n  C: {pin: [ground, c], angle: r}\n"
        "  B: {pin: [b, c]}\ndrives: {q: 60 deg + 100 rpm * (t - 0.02 s)}\nstart: {p: -60 deg, r: 60 deg}\n";
    for (int kind = 0; kind < 2; kind++) {
        Assembled m;
        assert_true(open_moving(&m, NULL, text));
        YkPolygon *p = yk_polygon_new(m.state, kind ? YK_POLYGON_ACCELERATION : YK_POLYGON_VELOCITY, NULL);
        size_t of_coupler = 0;
        for (size_t k = 0; k < yk_polygon_vector_count(p); k++) {
            YkPolygonVector v = yk_polygon_vector(p, k);
            if (strcmp(yk_model_body_name(m.model, v.body), "b") != 0) continue;
            assert_true(v.value[0] == 0 && v.value[1] == 0);
            of_coupler++;
        }
        assert_true(of_coupler > 0);
        for (size_t k = 0; k < yk_polygon_step_count(p); k++) assert_null(strstr(yk_polygon_step(p, k), "e-"));
        yk_polygon_free(p);
        assembled_close(&m);
    }
}

// A block on a turning line: what slides outwards at 0.5 m/s while the line turns at 2 rad/s has Coriolis' 2 m/s^2.
static void coriolis_is_told_on_turning_lines(void **state)
{
    (void)state;
    Assembled m;
    size_t seen = 0;
    static const char text[] =
        "bodies:\n  ground: {points: {O: [0, 0]}}\n  arm: {points: {O: [0, 0]}}\n  block: {points: {B: [0, 0]}}\n"
        "joints:\n  O: {pin: [ground, arm], angle: theta}\n  S: {slide: [arm, block], distance: s}\n"
        "drives: {theta: 2 rad/s * (t - 0.02 s), s: 3 m + 0.5 m/s * (t - 0.02 s)}\n";
    assert_true(open_moving(&m, NULL, text));
    YkPolygon *p = yk_polygon_new(m.state, YK_POLYGON_ACCELERATION, NULL);
    for (size_t k = 0; k < yk_polygon_vector_count(p); k++) {
        YkPolygonVector v = yk_polygon_vector(p, k);
        if (v.part != YK_POLYGON_CORIOLIS) continue;
        CHECK_NEAR(v.value[0], 0, 1e-12);
        CHECK_NEAR(v.value[1], 2, 1e-12);
        seen++;
    }
    assert_int_equal(seen, 1);
    CHECK_NEAR(image(p, "s").value[0], -12, 1e-12);
    CHECK_NEAR(image(p, "s").value[1], 2, 1e-12);
    yk_polygon_free(p);
    assembled_close(&m);
}

// Lengths in the picture are the vectors' times its scale.
static void the_picture_is_to_scale(void **state)
{
    (void)state;
    Assembled m;
    assert_true(open_moving(&m, YOKE_ROOT "/examples/four-bar.yaml", NULL));
    YkPolygon *p = yk_polygon_new(m.state, YK_POLYGON_VELOCITY, NULL);
    const char *svg = yk_polygon_svg(p), *at = strstr(svg, "data-scale=\"");
    assert_non_null(at);
    double scale = strtod(at + 12, NULL);
    size_t index = 0;
    for (const char *line = svg; (line = strstr(line, "<line ")) != NULL; line++) {
        double x1, y1, x2, y2;
        if (sscanf(line, "<line x1=\"%lf\" y1=\"%lf\" x2=\"%lf\" y2=\"%lf\"", &x1, &y1, &x2, &y2) != 4) continue;
        if (index == yk_polygon_vector_count(p)) break; // then comes the bar of the scale
        YkPolygonVector v = yk_polygon_vector(p, index++);
        CHECK_NEAR(x2 - x1, v.value[0] * scale, 0.011);
        CHECK_NEAR(y1 - y2, v.value[1] * scale, 0.011);
    }
    assert_int_equal(index, yk_polygon_vector_count(p));
    yk_polygon_free(p);
    assembled_close(&m);
}

static void what_is_not_there_is_said(void **state)
{
    (void)state;
    assert_null(yk_polygon_new(NULL, YK_POLYGON_VELOCITY, NULL));
    assert_null(yk_polygon_svg(NULL));
    assert_null(yk_polygon_step(NULL, 0));
    assert_int_equal(yk_polygon_vector_count(NULL), 0);
    assert_int_equal(yk_polygon_vector(NULL, 3).joint, YK_NOT_FOUND);
    yk_polygon_free(NULL);
    Assembled m;
    assert_true(open_moving(&m, YOKE_ROOT "/examples/driven-coupler.yaml", NULL));
    YkProblems *problems = yk_problems_new();
    assert_null(yk_polygon_new(m.state, YK_POLYGON_VELOCITY, problems));
    assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_NO_POLYGON);
    yk_problems_free(problems);
    assembled_close(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_vector_of_the_gallery_is_the_engines),
        cmocka_unit_test(a_slider_crank_by_hand),
        cmocka_unit_test(rounding_is_told_as_nothing),
        cmocka_unit_test(coriolis_is_told_on_turning_lines),
        cmocka_unit_test(the_picture_is_to_scale),
        cmocka_unit_test(what_is_not_there_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
