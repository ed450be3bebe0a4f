// The drawing of a map, read by the numbers at its axes: every row of the map is there, and nothing else.
#include <ctype.h>
#include <stdlib.h>
#include <yoke/map.h>
#include <yoke/yoke.h>
#include "base/vec.h"
#include "check.h"

enum { MOST = 20000 };

// A panel's axes: value = first + per * pixel, by the numbers at its grid.
typedef struct Axis {
    double first, per, step;
    size_t numbers;
} Axis;

typedef struct Drawing {
    YkVec point[MOST];
    size_t line[MOST], points, lines, circles; // which polyline a point is of
    YkVec circle[64];
    Axis axis[2][2]; // [panel][axis]
} Drawing;

static double attribute(const char *element, const char *name)
{
    char key[20];
    snprintf(key, sizeof key, " %s=\"", name);
    const char *at = strstr(element, key);
    return at ? strtod(at + strlen(key), NULL) : NAN;
}

// Takes the numbers at the axes: those below a panel are centred, those beside it end there.
static void read_axes(const char *svg, Drawing *d)
{
    double pixel[2][2][2], value[2][2][2]; // [panel][axis][first, last]
    for (const char *at = strstr(svg, "<text"); at; at = strstr(at + 1, "<text")) {
        const char *word = strchr(at, '>') + 1;
        char *end;
        double number = strtod(word, &end);
        const char *middle = strstr(at, "\"middle\""), *last = strstr(at, "\"end\"");
        int axis = middle && middle < word ? 0 : 1;
        if (end == word || *end != '<' || (axis == 1 && !(last && last < word))) continue;
        int panel = attribute(at, "x") > 600;
        Axis *a = &d->axis[panel][axis];
        int which = a->numbers > 0;
        pixel[panel][axis][which] = axis == 0 ? attribute(at, "x") : attribute(at, "y") - 4; // words stand 4 px lower
        value[panel][axis][which] = number;
        a->numbers++;
        if (a->numbers > 2) { // further numbers stand where the first two say, each at a line of the grid
            double place = axis == 0 ? attribute(at, "x") : attribute(at, "y") - 4;
            CHECK_NEAR(a->first + a->per * place, number, 0.02 * fabs(a->per) * (double)a->numbers);
        }
        if (!which || a->numbers > 2) continue;
        a->per = (value[panel][axis][1] - value[panel][axis][0]) / (pixel[panel][axis][1] - pixel[panel][axis][0]);
        a->step = fabs(value[panel][axis][1] - value[panel][axis][0]);
        a->first = value[panel][axis][0] - a->per * pixel[panel][axis][0];
    }
}

static void read_drawing(const char *svg, Drawing *d)
{
    memset(d, 0, sizeof *d);
    read_axes(svg, d);
    for (const char *at = strstr(svg, "<polyline"); at; at = strstr(at + 1, "<polyline"), d->lines++) {
        const char *c = strstr(at, "points=\"") + 8;
        for (char *end; *c != '"'; c = end) {
            assert_true(d->points < MOST);
            d->point[d->points].x = strtod(c, &end);
            d->point[d->points].y = strtod(end + 1, &end);
            d->line[d->points++] = d->lines;
            while (*end == ' ') end++;
        }
    }
    for (const char *at = strstr(svg, "<circle"); at; at = strstr(at + 1, "<circle"), d->circles++) {
        assert_true(d->circles < 64);
        d->circle[d->circles] = yk_vec(attribute(at, "cx"), attribute(at, "cy"));
    }
}

static YkVec value_at(const Drawing *d, int panel, YkVec pixel)
{
    const Axis *a = d->axis[panel];
    return yk_vec(a[0].first + a[0].per * pixel.x, a[1].first + a[1].per * pixel.y);
}

// How far apart two values are on an axis, angles to whole turns.
static double apart(double a, double b, double turn)
{
    return fabs(turn > 0 ? remainder(a - b, turn) : a - b);
}

typedef struct Case {
    const char *file, *coordinate, *over, *point;
    bool is_distance;
} Case;

static void check_map(const Case *c, YkMap *map, const YkMechanism *mech, const YkModel *model)
{
    static Drawing d;
    size_t over = yk_coordinate_find(mech, c->over), up = yk_coordinate_find(mech, c->coordinate);
    size_t point = yk_model_find_point(model, c->point), rows = 0, events = 0;
    YkMapPicture options = {.coordinate = up,
                            .points = &point,
                            .point_count = 1,
                            .angle_unit = "deg",
                            .length_unit = "mm",
                            .angle = 180 / YK_PI,
                            .length = 1000};
    const char *svg = yk_map_picture(map, &options);
    assert_non_null(svg);
    read_drawing(svg, &d);
    double size[2] = {fabs(d.axis[0][0].per), fabs(d.axis[0][1].per)}; // of a pixel
    for (int axis = 0; axis < 2; axis++) assert_true(d.axis[0][axis].numbers > 2 && d.axis[1][axis].numbers > 2);
    assert_true(d.axis[0][0].per > 0 && d.axis[0][1].per < 0);
    for (int panel = 0; panel < 2; panel++)
        for (int axis = 0; axis < 2; axis++) { // steps are 1, 2 or 5 times a power of ten, or parts of a turn
            double step = d.axis[panel][axis].step, digit = step / pow(10, floor(log10(step) + 1e-9));
            bool is_turn = fabs(remainder(360, step)) < 1e-9;
            assert_true(is_turn || fabs(digit - 1) < 1e-9 || fabs(digit - 2) < 1e-9 || fabs(digit - 5) < 1e-9);
            assert_true(d.axis[panel][axis].numbers < 13);
        }
    CHECK_NEAR(d.axis[1][0].per, -d.axis[1][1].per, 1e-3 * d.axis[1][0].per); // the points' curves are to scale
    for (size_t k = 0; k < yk_map_circuit_count(map); k++) {
        events += yk_map_circuit(map, k).events;
        for (size_t b = 0; b < yk_map_circuit(map, k).branches; b++)
            for (size_t r = 0; r < yk_map_branch(map, k, b).rows; r++, rows++) {
                const double *row = yk_map_row(map, k, b, r), *place = yk_map_points(map, k, b, r) + 2 * point;
                YkVec expected[2] = {
                    yk_vec(row[over] * options.angle, row[up] * (c->is_distance ? 1000 : options.angle)),
                    yk_vec(1000 * place[0], 1000 * place[1])};
                bool found[2] = {false, false};
                for (size_t i = 0; i < d.points; i++) {
                    int panel = d.point[i].x > 620;
                    YkVec at = value_at(&d, panel, d.point[i]);
                    double off =
                        panel ? fmax(apart(at.x, expected[1].x, 0), apart(at.y, expected[1].y, 0)) / d.axis[1][0].per
                              : fmax(apart(at.x, expected[0].x, 360) / size[0],
                                     apart(at.y, expected[0].y, c->is_distance ? 0 : 360) / size[1]);
                    found[panel] |= off < 0.1;
                }
                if (!found[0] || !found[1]) print_error("%s: circuit %zu, branch %zu, row %zu\n", c->file, k, b, r);
                assert_true(found[0] && found[1]);
            }
    }
    assert_true(d.points <= 2 * rows && d.points >= 2 * rows - 2 * d.lines - 20); // but for lines of one point
    const char *frame = svg;
    for (int panel = 0; panel < 2; panel++) { // distances fill most of an axis, in its middle
        frame = strstr(frame + 1, "<polygon points=\"");
        double left = atof(frame + strlen("<polygon points=\"")), low[2] = {INFINITY, INFINITY}, high[2] = {0, 0};
        for (size_t i = 0; i < d.points; i++) {
            if ((d.point[i].x > 620) != panel) continue;
            assert_true(d.point[i].x >= left - 0.01 && d.point[i].x <= left + 520.01);
            low[0] = fmin(low[0], d.point[i].x - left), high[0] = fmax(high[0], d.point[i].x - left);
            low[1] = fmin(low[1], d.point[i].y - 30), high[1] = fmax(high[1], d.point[i].y - 30);
        }
        for (int axis = 0; axis < 2; axis++)
            if (panel == 1 || (axis == 1 && c->is_distance)) CHECK_NEAR(low[axis] + high[axis], 520, 0.1);
        assert_true(left + 520 < atof(strstr(svg, "width=\"") + strlen("width=\"")));
        if (panel == 0 && c->is_distance) assert_true(high[1] - low[1] > 0.88 * 520 && high[1] - low[1] < 0.95 * 520);
        if (panel == 1) CHECK_NEAR(fmax(high[0] - low[0], high[1] - low[1]), 520 / 1.1, 0.1);
    }
    for (size_t i = 0; i < d.points; i++) { // nothing leaves its panel, and no line crosses it
        assert_true(d.point[i].y >= 30 && d.point[i].y <= 550.01);
        bool goes_on = i > 0 && d.line[i] == d.line[i - 1];
        if (goes_on) assert_true(hypot(d.point[i].x - d.point[i - 1].x, d.point[i].y - d.point[i - 1].y) < 120);
    }
    assert_int_equal(d.circles, events);
    size_t seen = 0;
    for (size_t k = 0; k < yk_map_circuit_count(map); k++)
        for (size_t e = 0; e < yk_map_circuit(map, k).events; e++, seen++) {
            YkVec at = value_at(&d, 0, d.circle[seen]);
            CHECK_NEAR(apart(at.x, yk_map_event(map, k, e).at * options.angle, 360), 0, 0.1 * size[0]);
            double y = yk_map_event_value(map, k, e, up) * (c->is_distance ? 1000 : options.angle);
            CHECK_NEAR(apart(at.y, y, c->is_distance ? 0 : 360), 0, 0.1 * size[1]);
        }
}

static void every_row_is_drawn_where_the_axes_say(void **state)
{
    (void)state;
    static const Case cases[] = {
        {"four-bar", "theta4", "theta2", "coupler.P", false},
        {"slider-crank", "x", "theta", "rod.B", true},
        {"non-grashof", "theta4", "theta2", "coupler.B", false},
    };
    size_t tried = 0;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char path[400];
        snprintf(path, sizeof path, YOKE_ROOT "/examples/%s.yaml", cases[k].file);
        YkProblems *problems = yk_problems_new();
        YkModel *model = yk_model_load(path, NULL, problems);
        YkMechanism *mech = model ? yk_mechanism_compile(model, NULL, problems) : NULL;
        if (!mech || yk_coordinate_find(mech, cases[k].over) == YK_NOT_FOUND)
            print_error("%s\n", yk_problems_text(problems, 0));
        assert_non_null(mech);
        YkState *pose = yk_state_new(mech);
        yk_state_set_time(pose, 0, NULL);
        assert_true(yk_state_assemble(pose) >= 0);
        YkMap *map = yk_map_new(pose, yk_coordinate_find(mech, cases[k].over), problems);
        assert_non_null(map);
        check_map(&cases[k], map, mech, model);
        tried++;
        yk_map_free(map);
        yk_state_free(pose);
        yk_mechanism_free(mech);
        yk_model_free(model);
        yk_problems_free(problems);
    }
    assert_int_equal(tried, sizeof cases / sizeof *cases);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_row_is_drawn_where_the_axes_say)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
