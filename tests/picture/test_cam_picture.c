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
        cmocka_unit_test(a_tolerance_beyond_reason_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
