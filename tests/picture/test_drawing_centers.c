// Instant centres on a drawing: marks where they are, lines that meet there, and words for those that are not on the
// page.
#include "check.h"
#include <math.h>
#include <stdlib.h>
#include <yoke/yoke.h>

typedef struct Drawn {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
    YkCenters *centers;
    YkDrawing *drawing;
} Drawn;

static Drawn draw(const char *name)
{
    char path[300];
    snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, name);
    Drawn d = {.model = yk_model_load(path, NULL, NULL)};
    d.mech = yk_mechanism_compile(d.model, NULL, NULL);
    d.state = yk_state_new(d.mech);
    assert_true(yk_state_set_time(d.state, 0, NULL) >= 0 && yk_state_assemble(d.state) >= 0);
    d.centers = yk_centers_new(d.state, NULL);
    d.drawing = yk_drawing_new(d.mech, NULL);
    assert_true(d.centers && d.drawing);
    assert_int_equal(yk_drawing_pose(d.drawing, d.state), YK_OK);
    assert_int_equal(yk_drawing_centers(d.drawing, d.centers), YK_OK);
    return d;
}

static void drawn_free(Drawn *d)
{
    yk_drawing_free(d->drawing);
    yk_centers_free(d->centers);
    yk_state_free(d->state);
    yk_mechanism_free(d->mech);
    yk_model_free(d->model);
}

static size_t count(const char *text, const char *part)
{
    size_t found = 0;
    for (const char *at = text; (at = strstr(at, part)) != NULL; at++) found++;
    return found;
}

static void six_centres_of_a_four_bar_are_marked_where_lines_meet(void **state)
{
    (void)state;
    Drawn d = draw("four-bar");
    const char *svg = yk_drawing_svg(d.drawing);
    assert_int_equal(count(svg, "class=\"center\""), 6);
    assert_int_equal(count(svg, "class=\"kennedy\""), 8); // two centres, two lines each, through two others
    assert_int_equal(count(svg, "class=\"center-note\""), 0);
    assert_int_equal(count(svg, ">ground/coupler<"), 1);
    assert_int_equal(count(svg, ">crank/rocker<"), 1);
    // Lines that end at one centre go through it from two others on one straight line.
    double ends[8][4];
    const char *at = svg;
    for (size_t k = 0; k < 8; k++) {
        at = strstr(at, "class=\"kennedy\"");
        const char *line = at++;
        while (strncmp(line, "<line", 5) != 0) line--;
        assert_int_equal(sscanf(line, "<line x1=\"%lf\" y1=\"%lf\" x2=\"%lf\" y2=\"%lf\"", &ends[k][0], &ends[k][1],
                                &ends[k][2], &ends[k][3]),
                         4);
    }
    for (size_t k = 0; k < 8; k += 2) {
        double ax = ends[k][0] - ends[k][2], ay = ends[k][1] - ends[k][3];
        double bx = ends[k + 1][0] - ends[k + 1][2], by = ends[k + 1][1] - ends[k + 1][3];
        CHECK_NEAR(ends[k][2], ends[k + 1][2], 0);
        CHECK_NEAR((ax * by - ay * bx) / (hypot(ax, ay) * hypot(bx, by)), 0, 1e-3);
    }
    drawn_free(&d);
}

static void centres_at_infinity_are_told(void **state)
{
    (void)state;
    Drawn d = draw("slider-crank");
    const char *svg = yk_drawing_svg(d.drawing);
    assert_int_equal(count(svg, "class=\"center\"") + count(svg, "class=\"center-note\""), 6);
    assert_int_equal(count(svg, "ground/piston: at infinity towards 90 deg"), 1);
    assert_int_equal(yk_drawing_centers(d.drawing, NULL), YK_OK);
    assert_int_equal(count(yk_drawing_svg(d.drawing), "center"), 0);
    assert_int_equal(yk_drawing_centers(NULL, d.centers), YK_BAD_ARGUMENT);
    drawn_free(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(six_centres_of_a_four_bar_are_marked_where_lines_meet),
        cmocka_unit_test(centres_at_infinity_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
