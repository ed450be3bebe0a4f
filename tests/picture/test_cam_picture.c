// Profiles as SVG and DXF.
#include "design/cam_check.h"
#include <stdlib.h>
#include "picture/cam_picture.h"

static const char text[] = LIFT "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 40 mm, roller: 9 mm, "
                                "groove: true, conjugate: {span: 130 mm}}}\n" SLIDE;

static Cam load(void)
{
    return cam_load(text);
}

static size_t count_of(const char *where, const char *what)
{
    size_t count = 0;
    for (const char *at = where; (at = strstr(at, what)); at++) count++;
    return count;
}

static void every_curve_of_the_cam_is_there(void **state)
{
    (void)state;
    static const char *const layers[] = {"surface", "pitch", "groove", "cutter", "surface-2", "pitch-2"};
    Cam cam = load();
    YkCamPicture picture;
    YkText svg = {0}, dxf = {0};
    assert_true(yk_cam_picture_take(&picture, cam.design, 1e-5, 0.004));
    assert_int_equal(picture.count, 6);
    yk_cam_picture_svg(&picture, &svg);
    yk_cam_picture_dxf(&picture, &dxf);
    for (size_t i = 0; i < 6; i++) {
        char id[40];
        assert_string_equal(picture.outlines[i].layer, layers[i]);
        snprintf(id, sizeof id, "<path id=\"%s\" d=\"M", layers[i]);
        assert_int_equal(count_of(yk_text_get(&svg), id), 1);
        snprintf(id, sizeof id, "POLYLINE\n8\n%s\n", layers[i]);
        assert_int_equal(count_of(yk_text_get(&dxf), id), 1);
    }
    assert_int_equal(count_of(yk_text_get(&svg), "L") + 6, picture.outlines[0].count + picture.outlines[1].count +
                                                               picture.outlines[2].count + picture.outlines[3].count +
                                                               picture.outlines[4].count + picture.outlines[5].count);
    yk_text_free(&svg);
    yk_text_free(&dxf);
    yk_cam_picture_free(&picture);
    cam_free(&cam);
}

// One user unit is a millimetre, the base circle and the roller at lift 0 are at their places, y points up.
static void the_picture_is_to_scale(void **state)
{
    (void)state;
    Cam cam = load();
    YkCamPicture picture;
    YkText svg = {0};
    assert_true(yk_cam_picture_take(&picture, cam.design, 1e-5, 0));
    yk_cam_picture_svg(&picture, &svg);
    const char *all = yk_text_get(&svg);
    double width = strtod(strstr(all, "width=\"") + 7, NULL), box[4];
    char *at = strstr(all, "viewBox=\"") + 9;
    for (int i = 0; i < 4; i++) box[i] = strtod(at, &at);
    CHECK_NEAR(width, box[2], 0);
    assert_true(box[0] < -49 && box[0] + box[2] > 49);
    assert_non_null(strstr(all, "cx=\"0.00000\" cy=\"0.00000\" r=\"40.00000\""));
    assert_non_null(strstr(all, "cx=\"0.00000\" cy=\"-49.00000\" r=\"9.00000\""));
    assert_non_null(strstr(all, "base circle R40 mm, roller R9 mm, turns counterclockwise"));
    assert_true(strcmp(all + svg.length - 7, "</svg>\n") == 0);
    yk_text_free(&svg);
    yk_cam_picture_free(&picture);
    cam_free(&cam);
}

// The corners of what is drawn: every vertex, and circles as far as they reach.
typedef struct Extent {
    double low[2], high[2];
} Extent;

static void widen(Extent *e, double x, double y, double r)
{
    const double at[2] = {x, y};
    for (int k = 0; k < 2; k++) {
        e->low[k] = fmin(e->low[k], at[k] - r);
        e->high[k] = fmax(e->high[k], at[k] + r);
    }
}

static double attribute(const char *element, const char *name)
{
    char key[20];
    snprintf(key, sizeof key, " %s=\"", name);
    return strtod(strstr(element, key) + strlen(key), NULL);
}

// The page is 6 mm larger than what is drawn, and holds words below it that are its name, its circles and how it turns.
static void check_page(const char *all, const YkCamDesign *design)
{
    Extent e = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (const char *at = strstr(all, "<circle"); at; at = strstr(at + 1, "<circle"))
        widen(&e, attribute(at, "cx"), attribute(at, "cy"), attribute(at, "r"));
    for (const char *at = strstr(all, " d=\"M"); at; at = strstr(at + 1, " d=\"M"))
        for (char *c = (char *)(size_t)at + 4; *c != 'Z';) {
            double x = strtod(c + 1, &c), y = strtod(c, &c);
            widen(&e, x, y, 0);
        }
    const char *word = strstr(all, "<text"), *sheet = strstr(all, "<rect");
    double size = attribute(word, "font-size"), box[4];
    char *at = strstr(all, "viewBox=\"") + 9;
    for (int i = 0; i < 4; i++) box[i] = strtod(at, &at);
    CHECK_NEAR(box[0], e.low[0] - 6, 2e-5);
    CHECK_NEAR(box[1], e.low[1] - 6, 2e-5);
    CHECK_NEAR(box[0] + box[2], e.high[0] + 6, 4e-5);
    CHECK_NEAR(box[1] + box[3], e.high[1] + 6 + 1.5 * size, 0.01);
    static const char *const names[] = {"x", "y", "width", "height"};
    for (int i = 0; i < 4; i++) CHECK_NEAR(attribute(sheet, names[i]), box[i], 0);
    CHECK_NEAR(attribute(all, "width"), box[2], 0);
    CHECK_NEAR(attribute(all, "height"), box[3], 0);
    assert_true(size >= 2 && attribute(word, "x") >= e.low[0] - 0.01);
    assert_true(attribute(word, "y") - size > e.high[1] && attribute(word, "y") + 0.25 * size < box[1] + box[3]);
    const char *title = strstr(all, "<title>") + strlen("<title>"), *name = yk_cam_size(design).name;
    assert_memory_equal(title, name, strlen(name));
}

// A cross marks a centre: two lines through it, one across the other, as long.
static void check_cross(const char *line, double x, double y)
{
    double length[2];
    for (int k = 0; k < 2; k++, line = strstr(line + 1, "<line")) {
        double dx = attribute(line, "x2") - attribute(line, "x1"), dy = attribute(line, "y2") - attribute(line, "y1");
        CHECK_NEAR(attribute(line, "x1") + attribute(line, "x2"), 2 * x, 4e-5);
        CHECK_NEAR(attribute(line, "y1") + attribute(line, "y2"), 2 * y, 4e-5);
        CHECK_NEAR(k ? dx : dy, 0, 2e-5);
        length[k] = k ? dy : dx;
    }
    CHECK_NEAR(fabs(length[0]), fabs(length[1]), 4e-5);
    assert_true(fabs(length[0]) > 0.5);
}

// A roller is crossed at its centre; a flat face touches the cam at lift 0, square to its normal, all points that it
// touches in a turn and more.
static void what_rides_is_drawn_where_it_touches(void **state)
{
    (void)state;
    static const char flat[] =
        LIFT "cams: {c: {cam: shaft, follower: tappet, law: lift, face: flat, base: 48 mm}}\n" SLIDE;
    const char *const texts[] = {text, flat};
    for (int k = 0; k < 2; k++) {
        Cam cam = cam_load(texts[k]);
        YkCamPicture picture;
        YkText svg = {0};
        assert_true(yk_cam_picture_take(&picture, cam.design, 1e-5, 0));
        yk_cam_picture_svg(&picture, &svg);
        const char *all = yk_text_get(&svg), *line = strstr(all, "<line");
        YkCamPoint p = yk_cam_at(cam.design, 0);
        check_page(all, cam.design);
        check_cross(line, 0, 0);
        line = strstr(strstr(line + 1, "<line") + 1, "<line");
        if (k == 0) check_cross(line, 1000 * p.pitch[0], -1000 * p.pitch[1]);
        if (k == 1) {
            double low = INFINITY, high = -INFINITY, from[2] = {attribute(line, "x1"), -attribute(line, "y1")},
                   to[2] = {attribute(line, "x2"), -attribute(line, "y2")};
            for (int i = 0; i < 360; i++) {
                double reach = 1000 * yk_cam_at(cam.design, i * DEG).reach;
                low = fmin(low, reach);
                high = fmax(high, reach);
            }
            CHECK_NEAR(from[0] + to[0], 2000 * p.surface[0], 4e-5);
            CHECK_NEAR(from[1] + to[1], 2000 * p.surface[1], 4e-5);
            CHECK_NEAR((to[0] - from[0]) * p.normal[0] + (to[1] - from[1]) * p.normal[1], 0, 4e-5);
            double half = 0.5 * hypot(to[0] - from[0], to[1] - from[1]);
            assert_true(half > fmax(high, -low) && half < 2 * (high - low) && high > 10);
        }
        yk_text_free(&svg);
        yk_cam_picture_free(&picture);
        cam_free(&cam);
    }
}

static void a_tolerance_beyond_reason_is_refused(void **state)
{
    (void)state;
    Cam cam = load();
    YkCamPicture picture;
    assert_false(yk_cam_picture_take(&picture, cam.design, 1e-15, 0));
    assert_int_equal(picture.count, 0);
    cam_free(&cam);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_curve_of_the_cam_is_there),
        cmocka_unit_test(the_picture_is_to_scale),
        cmocka_unit_test(what_rides_is_drawn_where_it_touches),
        cmocka_unit_test(a_tolerance_beyond_reason_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
