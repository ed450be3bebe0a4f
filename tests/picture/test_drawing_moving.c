// Drawings that move: a group's transform takes what is written at the reference pose to where it is at any other.
#include "check.h"
#include <stdlib.h>
#include <yoke/yoke.h>
#include "examples.h"
#include "picture/drawing/drawing.h"

typedef struct Machine {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
    YkDrawing *drawing;
} Machine;

// The machine of a file with its first input turned in so many steps through an angle.
static Machine open_machine(const char *name, size_t steps, double angle)
{
    char path[500];
    Machine m = {0};
    YkDrawOptions options = yk_default_draw_options();
    snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, name);
    YkProblems *problems = yk_problems_new();
    m.model = yk_model_load(path, NULL, problems);
    m.mech = yk_mechanism_compile(m.model, NULL, problems);
    m.state = yk_state_new(m.mech);
    assert_non_null(m.state);
    options.moving = true;
    m.drawing = yk_drawing_new(m.mech, &options);
    assert_non_null(m.drawing);
    assert_true(yk_state_set_time(m.state, 0, problems) >= 0 && yk_state_assemble(m.state) >= 0);
    double start = yk_state_input(m.state, 0).position;
    for (size_t k = 0; k <= steps; k++) {
        yk_state_set_input(m.state, 0, (YkMotion){start + angle * (double)k / (double)steps, 0, 0});
        assert_true(yk_state_solve(m.state) >= 0);
        assert_int_equal(yk_drawing_pose(m.drawing, m.state), YK_OK);
    }
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

static YkVec moved(YkShift shift, YkVec at)
{
    return yk_add(yk_add(shift.center, shift.by), yk_mul(yk_unit(shift.turn), yk_sub(at, shift.center)));
}

static void shifts_take_points_to_where_they_are(void **state)
{
    (void)state;
    Machine m = open_machine("quick-return", 20, 2);
    assert_non_null(yk_drawing_svg(m.drawing)); // fits the page
    const YkFrame *drawn = yk_drawing_frames(m.drawing, yk_drawing_reference(m.drawing));
    for (size_t pose = 0; pose < m.drawing->pose_count; pose++) {
        const YkFrame *frames = yk_drawing_frames(m.drawing, pose);
        for (size_t p = 0; p < m.model->point_count; p++) {
            const YkPoint *point = &m.model->points[p];
            YkVec at = yk_drawing_pixel(m.drawing, yk_frame_apply(drawn[point->body], point->at));
            YkVec there = yk_drawing_pixel(m.drawing, yk_frame_apply(frames[point->body], point->at));
            YkVec own = moved(yk_drawing_shift(m.drawing, (size_t)point->body, pose), at);
            CHECK_NEAR(own.x, there.x, 1e-9);
            CHECK_NEAR(own.y, there.y, 1e-9);
        }
    }
    close_machine(&m);
}

static size_t occurrences(const char *text, const char *word)
{
    size_t count = 0;
    for (const char *at = strstr(text, word); at; at = strstr(at + 1, word)) count++;
    return count;
}

static void frames_are_the_same_page_with_its_groups_moved(void **state)
{
    (void)state;
    Machine m = open_machine("quick-return", 6, 1);
    char *last = strdup(yk_drawing_svg(m.drawing));
    assert_non_null(last);
    assert_int_equal(occurrences(last, " transform="), 0);
    assert_string_equal(yk_drawing_frame(m.drawing, 6), last);
    const char *first = yk_drawing_frame(m.drawing, 0);
    assert_int_equal(occurrences(first, " transform="), occurrences(last, "<g class=\"b") +
                                                            occurrences(last, "<g class=\"j") +
                                                            occurrences(last, "<g class=\"n"));
    assert_int_equal(occurrences(first, "<g"), occurrences(first, "</g>"));
    assert_null(yk_drawing_frame(m.drawing, 7));
    free(last);
    close_machine(&m);
}

// Over one turn the crank's keyframes go through 360 degrees without a jump; what stands still has none.
static void keyframes_count_turns_on(void **state)
{
    (void)state;
    Machine m = open_machine("gas-engine", 24, 2 * YK_PI);
    const char *svg = yk_drawing_animation(m.drawing, 3, false), *at = strstr(svg, "@keyframes b1 {");
    assert_non_null(at);
    const char *end = strchr(at, '\n');
    double first = NAN, last = NAN;
    size_t count = 0;
    for (at = strstr(at, "rotate("); at && at < end; at = strstr(at + 1, "rotate("), count++) {
        double turn = atof(at + 7);
        if (count == 0) first = turn;
        if (count > 0) CHECK_NEAR(turn - last, -15, 0.011); // clockwise in SVG is backwards here
        last = turn;
    }
    assert_int_equal(count, 25);
    CHECK_NEAR(last - first, -360, 0.011);
    assert_null(strstr(svg, "@keyframes b0 "));
    assert_null(strstr(svg, "@keyframes j0 ")); // the crank's pin on the ground
    assert_non_null(strstr(svg, "3s linear infinite"));
    assert_null(strstr(svg, "alternate"));
    assert_non_null(strstr(yk_drawing_animation(m.drawing, 3, true), "alternate"));
    close_machine(&m);
}

// Between two points of the machine, to either side of their line alike.
static void springs_run_between_their_points(void **state)
{
    (void)state;
    Machine m = open_machine("spring-slider-crank", 4, 0.5);
    assert_non_null(yk_drawing_scene(m.drawing)); // fits the page
    const char *parts = yk_drawing_parts(m.drawing, m.state), *at = strstr(parts, "<polyline points=\"");
    assert_int_equal(occurrences(parts, "<polyline"), 1);
    YkVec corner = {0, 0}, sum = {0, 0}, end[2];
    for (size_t k = 0; k < 2; k++) {
        YkPointMotion motion = yk_state_point(m.state, yk_model_find_point(m.model, k == 0 ? "crank.M" : "rod.M"));
        end[k] = yk_drawing_pixel(m.drawing, yk_vec(motion.position[0], motion.position[1]));
    }
    int count = 0, used;
    for (at += strlen("<polyline points=\""); sscanf(at, " %lf,%lf%n", &corner.x, &corner.y, &used) == 2; at += used) {
        if (count++ == 0) CHECK_NEAR(yk_norm(yk_sub(corner, end[0])), 0, 0.01);
        sum = yk_add(sum, corner);
    }
    assert_true(count > 4);
    CHECK_NEAR(yk_norm(yk_sub(corner, end[1])), 0, 0.01);
    CHECK_NEAR(yk_norm(yk_sub(yk_scale(1.0 / count, sum), yk_scale(0.5, yk_add(end[0], end[1])))), 0, 0.01);
    close_machine(&m);
}

enum { CORNERS = 40000 };
typedef struct Page { // the corners of all lines, polygons and circles, each where its group takes it, and radii
    YkVec corners[CORNERS];
    bool begins_line[CORNERS];
    size_t count;
} Page;

static void read_page(Page *page, const char *svg)
{
    YkVec by = {0, 0}, center = {0, 0}, at, to;
    YkVec *corners = page->corners;
    double turn = 0, radius;
    size_t count = 0;
    for (const char *c = strchr(svg, '\n'); c && count + 2 < CORNERS; c = strchr(c, '\n')) {
        size_t first = count;
        int used;
        c++;
        if (strncmp(c, "</g>", 4) == 0) by = (YkVec){turn = 0, 0};
        if (strncmp(c, "<g class=", 9) == 0)
            sscanf(c, "<g class=\"%*[a-z0-9]\" transform=\"translate(%lf %lf) rotate(%lf %lf %lf", &by.x, &by.y, &turn,
                   &center.x, &center.y);
        bool is_line = sscanf(c, "<line x1=\"%lf\" y1=\"%lf\" x2=\"%lf\" y2=\"%lf", &at.x, &at.y, &to.x, &to.y) == 4;
        bool is_circle = sscanf(c, "<circle cx=\"%lf\" cy=\"%lf\" r=\"%lf", &at.x, &at.y, &radius) == 3;
        if (is_line || is_circle) corners[count++] = at;
        if (is_line) corners[count++] = to;
        const char *points = strncmp(c, "<poly", 5) == 0 ? strchr(c, '"') + 1 : "";
        for (; count < CORNERS && sscanf(points, " %lf,%lf%n", &at.x, &at.y, &used) == 2; points += used)
            corners[count++] = at;
        if (count == first + 4 && yk_norm(yk_sub(corners[first], corners[first + 2])) < 20) { // a weld, drawn upright
            corners[first] = yk_scale(0.5, yk_add(corners[first], corners[first + 2]));
            count = first + 1;
        }
        YkVec e = yk_unit(turn * YK_PI / 180);
        for (size_t k = first; k < count; k++) {
            corners[k] = yk_add(yk_add(center, by), yk_mul(e, yk_sub(corners[k], center)));
            page->begins_line[k] = is_line && k == first;
        }
        if (is_circle) page->begins_line[count] = false, corners[count++] = (YkVec){radius, 0};
    }
    page->count = count;
}

// Starts a drawing with the machine in two poses: at its start, and a little further; that one first if `is_back`.
static YkDrawing *draw_two(Machine *m, bool is_back)
{
    YkDrawOptions options = yk_default_draw_options();
    options.moving = true;
    options.labels = false;
    YkDrawing *drawing = yk_drawing_new(m->mech, &options);
    assert_non_null(drawing);
    for (int k = 0; k < 2; k++) {
        bool is_start = (k == 0) != is_back;
        YkState *beside = yk_state_new(m->mech);
        assert_true(beside && yk_state_copy(beside, m->state) == YK_OK);
        for (size_t i = 0; !is_start && i < yk_input_count(m->mech); i++) {
            bool is_distance = yk_coordinate_info(m->mech, yk_input_coordinate(m->mech, i)).is_distance;
            YkMotion q = yk_state_input(beside, i);
            q.position += is_distance ? 0.05 * yk_mechanism_size(m->mech) : 0.1;
            yk_state_set_input(beside, i, q);
        }
        bool stands = is_start || yk_state_solve(beside) >= 0;
        if (stands) assert_int_equal(yk_drawing_pose(drawing, beside), YK_OK);
        yk_state_free(beside);
        if (stands) continue;
        yk_drawing_free(drawing);
        return NULL;
    }
    return drawing;
}

static double nearest(YkVec at, const Page *page)
{
    double least = INFINITY;
    for (size_t k = 0; k < page->count; k++) least = fmin(least, yk_norm(yk_sub(page->corners[k], at)));
    return least;
}

static double nearest_line(YkVec at, const Page *page)
{
    double least = INFINITY;
    for (size_t k = 0; k < page->count; k++) {
        if (!page->begins_line[k]) continue;
        YkVec along = yk_sub(page->corners[k + 1], page->corners[k]), off = yk_sub(at, page->corners[k]);
        double part = yk_dot(along, off) / fmax(yk_dot(along, along), 1e-9);
        least = fmin(least, yk_norm(yk_sub(off, yk_scale(fmax(0, fmin(1, part)), along))));
    }
    return least;
}

// Each pin whose place is a point of the file is drawn where the state has that point.
static void check_pins(const Machine *m, const YkDrawing *drawing, const Page *page)
{
    for (size_t j = 0; j < m->model->joint_count; j++) {
        const YkJoint *joint = &m->model->joints[j];
        if (joint->point[0] == YK_NONE || joint->kind != YK_PIN) continue;
        YkPointMotion motion = yk_state_point(m->state, (size_t)joint->point[0]);
        YkVec pixel = yk_drawing_pixel(drawing, yk_vec(motion.position[0], motion.position[1]));
        CHECK_NEAR(nearest(pixel, page), 0, 0.01);
    }
}

// What slides is on a line that is drawn for it; in the ground, between two rails.
static void check_slides(const YkDrawing *drawing, const Page *page, const char *path)
{
    const YkFrame *frames = yk_drawing_frames(drawing, yk_drawing_reference(drawing));
    for (size_t j = 0; j < drawing->model->joint_count; j++) {
        const YkJoint *joint = &drawing->model->joints[j];
        if (yk_drawing_omits(drawing->model, joint) || !yk_part(joint->kind)->slides) continue;
        double off =
            nearest_line(yk_drawing_pixel(drawing, yk_drawing_joint(drawing, frames, joint, 1)), page) / drawing->bar;
        if (off > (joint->body[0] == 0 ? 1.1 : 0.1)) print_error("%s: %s, %.3g\n", path, joint->name, off);
        assert_true(off <= (joint->body[0] == 0 ? 1.1 : 0.1));
    }
}

// A body of two points is a bar between them.
static void check_bars(const YkDrawing *drawing, const Page *page)
{
    const YkFrame *frames = yk_drawing_frames(drawing, yk_drawing_reference(drawing));
    for (size_t b = 1; b < yk_model_body_count(drawing->model); b++) {
        if (drawing->outlines[b].count != 2) continue;
        YkVec end[2];
        for (size_t k = 0; k < 2; k++)
            end[k] =
                yk_drawing_pixel(drawing, yk_frame_apply(frames[b], drawing->corners[drawing->outlines[b].first + k]));
        double least = INFINITY;
        for (size_t k = 0; k < page->count; k++)
            if (page->begins_line[k])
                least = fmin(least,
                             yk_norm(yk_sub(page->corners[k], end[0])) + yk_norm(yk_sub(page->corners[k + 1], end[1])));
        CHECK_NEAR(least, 0, 0.02);
    }
}

// A scene says where on its page the origin of the world is, and how long a metre.
static void check_scene(YkDrawing *drawing)
{
    const char *scene = strstr(yk_drawing_scene(drawing), " data-scale=");
    double scale;
    YkVec origin;
    assert_non_null(scene);
    assert_int_equal(sscanf(scene, " data-scale=\"%lf\" data-origin=\"%lf %lf\"", &scale, &origin.x, &origin.y), 3);
    YkVec at = yk_vec(0.3, -0.7), wanted = yk_add(origin, yk_scale(scale, yk_conj(at)));
    YkVec pixel = yk_drawing_pixel(drawing, at);
    CHECK_NEAR(yk_norm(yk_sub(pixel, wanted)), 0, 1e-5 * (yk_norm(origin) + scale));
}

static size_t check_frames(const char *path, size_t number)
{
    static Page moved_there, drawn_there, drawn_further;
    Machine m = {.model = yk_model_load(path, NULL, NULL)};
    (void)number;
    m.mech = m.model ? yk_mechanism_compile(m.model, NULL, NULL) : NULL;
    m.state = m.mech ? yk_state_new(m.mech) : NULL;
    size_t seen = 0;
    if (m.state && yk_state_assemble(m.state) >= 0 && (m.drawing = draw_two(&m, false))) {
        YkDrawing *back = draw_two(&m, true);
        read_page(&drawn_further, yk_drawing_svg(m.drawing));
        read_page(&moved_there, yk_drawing_frame(m.drawing, 0));
        read_page(&drawn_there, yk_drawing_svg(back));
        assert_int_equal(moved_there.count, drawn_there.count);
        for (size_t k = 0; k < moved_there.count; k++) {
            double off = yk_norm(yk_sub(moved_there.corners[k], drawn_there.corners[k]));
            if (off > 0.05) off = nearest(moved_there.corners[k], &drawn_there); // marks of teeth begin anywhere
            if (off > 0.05) print_error("%s: corner %d\n", path, (int)k);
            CHECK_NEAR(off, 0, 0.05);
        }
        check_pins(&m, back, &drawn_there);
        check_slides(back, &drawn_there, path);
        check_slides(m.drawing, &drawn_further, path);
        check_bars(back, &drawn_there);
        check_scene(m.drawing);
        yk_drawing_free(back);
        seen = 1;
    }
    close_machine(&m);
    return seen;
}

// With all that is drawn of it: bars, slots, marks on wheels, cams, hatches.
static void frames_of_every_example_are_pages_drawn_there(void **state)
{
    (void)state;
    assert_true(each_example(check_frames) > 50);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(springs_run_between_their_points),
        cmocka_unit_test(shifts_take_points_to_where_they_are),
        cmocka_unit_test(frames_are_the_same_page_with_its_groups_moved),
        cmocka_unit_test(keyframes_count_turns_on),
        cmocka_unit_test(frames_of_every_example_are_pages_drawn_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
