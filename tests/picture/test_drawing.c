// Drawings of the examples: well formed, the same bytes every time, nothing outside the page.
#include "check.h"
#include <stdlib.h>
#include <unistd.h>
#include <yoke/yoke.h>
#include "write/process.h"

// A machine at its start, assembled.
typedef struct Machine {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
} Machine;

static Machine open_machine(const char *name)
{
    char path[500];
    Machine m = {0};
    snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, name);
    YkProblems *problems = yk_problems_new();
    m.model = yk_model_load(path, NULL, problems);
    assert_non_null(m.model);
    m.mech = yk_mechanism_compile(m.model, NULL, problems);
    assert_non_null(m.mech);
    m.state = yk_state_new(m.mech);
    assert_non_null(m.state);
    assert_true(yk_state_set_time(m.state, 0, problems) >= 0);
    assert_true(yk_state_assemble(m.state) >= 0);
    yk_problems_free(problems);
    return m;
}

static void close_machine(Machine *m)
{
    yk_state_free(m->state);
    yk_mechanism_free(m->mech);
    yk_model_free(m->model);
}

static char *draw_once(const Machine *m, const YkDrawOptions *options)
{
    YkDrawing *drawing = yk_drawing_new(m->mech, options);
    assert_non_null(drawing);
    assert_int_equal(yk_drawing_pose(drawing, m->state), YK_OK);
    const char *svg = yk_drawing_svg(drawing);
    assert_non_null(svg);
    char *copy = malloc(strlen(svg) + 1);
    assert_non_null(copy);
    strcpy(copy, svg);
    yk_drawing_free(drawing);
    return copy;
}

static size_t occurrences(const char *text, const char *word)
{
    size_t count = 0;
    for (const char *at = strstr(text, word); at; at = strstr(at + 1, word)) count++;
    return count;
}

static double attribute(const char *element, const char *name)
{
    char pattern[32];
    snprintf(pattern, sizeof pattern, " %s=\"", name);
    const char *at = strstr(element, pattern);
    return at ? atof(at + strlen(pattern)) : NAN;
}

typedef struct Page {
    double width, height;
} Page;

static void check_place(const Page *page, double x, double y)
{
    assert_true(x >= 0 && x <= page->width);
    assert_true(y >= 0 && y <= page->height);
}

// Both ends of lines, the whole of circles and all corners lie on the page.
static void check_on_page(const char *svg)
{
    Page page = {attribute(svg, "width"), attribute(svg, "height")};
    assert_true(page.width > 0 && page.height > 0);
    for (const char *at = strstr(svg, "<line"); at; at = strstr(at + 1, "<line")) {
        check_place(&page, attribute(at, "x1"), attribute(at, "y1"));
        check_place(&page, attribute(at, "x2"), attribute(at, "y2"));
    }
    for (const char *at = strstr(svg, "<circle"); at; at = strstr(at + 1, "<circle")) {
        double x = attribute(at, "cx"), y = attribute(at, "cy"), r = attribute(at, "r");
        check_place(&page, x - r, y - r);
        check_place(&page, x + r, y + r);
    }
    for (const char *at = strstr(svg, " points=\""); at; at = strstr(at, " points=\"")) {
        char *end;
        for (at += 9; *at != '"'; at = end) {
            double x = strtod(at, &end);
            assert_true(*end == ',');
            double y = strtod(end + 1, &end);
            check_place(&page, x, y);
        }
    }
}

static void check_well_formed(const char *svg)
{
    static const char *const xmllint[] = {"xmllint", "--noout", "--nonet", "-", NULL};
    YkText input = {0}, output = {0};
    YkProblems *problems = yk_problems_new();
    yk_text_puts(&input, svg);
    bool good = yk_process_filter(xmllint, "checking", &input, &output, problems);
    if (!good)
        assert_non_null(strstr(yk_problems_get(problems, 0)->message, "needs the program")); // not installed is fine
    yk_text_free(&input);
    yk_text_free(&output);
    yk_problems_free(problems);
}

static const char *const machines[] = {"quick-return",     "toggle",
                                       "double-pendulum",  "scotch-yoke",
                                       "elliptic-trammel", "peaucellier",
                                       "jansen",           "oscillating-cylinder",
                                       "excavator",        "three-crank-parallelogram",
                                       "epicyclic",        "gearbox-8hp70",
                                       "valve-cam",        "swing-cam",
                                       "flat-faced-cam"};

static void every_machine_gives_a_well_formed_page(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof machines / sizeof *machines; i++) {
        Machine m = open_machine(machines[i]);
        char *svg = draw_once(&m, NULL);
        assert_null(strstr(svg, "nan"));
        assert_null(strstr(svg, "inf\""));
        check_on_page(svg);
        check_well_formed(svg);
        free(svg);
        close_machine(&m);
    }
}

static void the_same_pose_is_the_same_bytes(void **state)
{
    (void)state;
    Machine m = open_machine("quick-return");
    char *first = draw_once(&m, NULL), *second = draw_once(&m, NULL);
    assert_string_equal(first, second);
    free(first);
    free(second);
    close_machine(&m);
}

static void asking_twice_gives_the_same_document(void **state)
{
    (void)state;
    Machine m = open_machine("toggle");
    YkDrawing *drawing = yk_drawing_new(m.mech, NULL);
    assert_int_equal(yk_drawing_pose(drawing, m.state), YK_OK);
    size_t first = strlen(yk_drawing_svg(drawing));
    assert_int_equal(strlen(yk_drawing_svg(drawing)), first);
    yk_drawing_free(drawing);
    close_machine(&m);
}

static void joints_and_bodies_are_named_unless_told_otherwise(void **state)
{
    (void)state;
    Machine m = open_machine("quick-return");
    YkDrawOptions options = yk_default_draw_options();
    char *with = draw_once(&m, &options);
    for (size_t j = 0; j < yk_model_joint_count(m.model); j++) {
        char word[64];
        snprintf(word, sizeof word, ">%s</text>", yk_model_joint_name(m.model, j));
        assert_non_null(strstr(with, word));
    }
    assert_non_null(strstr(with, ">lever</text>"));
    options.labels = false;
    char *without = draw_once(&m, &options);
    assert_int_equal(occurrences(without, "<text"), 0);
    free(with);
    free(without);
    close_machine(&m);
}

static void the_page_is_as_wide_as_asked(void **state)
{
    (void)state;
    Machine m = open_machine("quick-return");
    YkDrawOptions options = yk_default_draw_options();
    options.width = 500;
    char *svg = draw_once(&m, &options);
    assert_true(attribute(svg, "width") == 500);
    check_on_page(svg);
    free(svg);
    close_machine(&m);
}

static void poses_but_the_last_are_faint_and_traces_are_paths(void **state)
{
    (void)state;
    Machine m = open_machine("four-bar");
    size_t input = 0, traced = yk_model_point_count(m.model) - 1;
    YkDrawOptions options = yk_default_draw_options();
    options.traced_points = &traced;
    options.traced_count = 1;
    YkDrawing *drawing = yk_drawing_new(m.mech, &options);
    for (int i = 0; i < 5; i++) {
        YkMotion motion = yk_state_input(m.state, input);
        motion.position += 0.05;
        yk_state_set_input(m.state, input, motion);
        assert_true(yk_state_solve(m.state) >= 0);
        assert_int_equal(yk_drawing_pose(drawing, m.state), YK_OK);
        assert_int_equal(yk_drawing_trace(drawing, m.state), YK_OK);
    }
    const char *svg = yk_drawing_svg(drawing), *path = strstr(svg, "<polyline points=\"");
    assert_int_equal(occurrences(svg, "<g opacity="), 4);
    assert_int_equal(occurrences(svg, "<polyline"), 1);
    size_t corners = 0;
    for (const char *at = path + strlen("<polyline points=\""); *at != '"'; at++) corners += *at == ',';
    assert_int_equal(corners, 5);
    check_on_page(svg);
    check_well_formed(svg);
    yk_drawing_free(drawing);
    close_machine(&m);
}

// The distance on the page between two pins over their distance in metres is one number: a drawing is to scale.
static void a_drawing_is_to_scale(void **state)
{
    (void)state;
    Machine m = open_machine("toggle");
    YkDrawOptions options = yk_default_draw_options();
    options.labels = false;
    char *svg = draw_once(&m, &options);
    double pins[16][2];
    size_t count = 0;
    for (const char *at = strstr(svg, "<circle"); at && count < 16; at = strstr(at + 1, "<circle")) {
        const char *end = strchr(at, '>'), *white = strstr(at, "fill=\"#ffffff\"");
        if (!white || white > end) continue; // pins are white, other points are not
        pins[count][0] = attribute(at, "cx");
        pins[count++][1] = attribute(at, "cy");
    }
    // toggle.yaml: O1, A, O2, J34, J23, B in this order; link1 is 0.1, link3 0.2, link4 0.25 long.
    assert_int_equal(count, 6);
    double link1 = hypot(pins[1][0] - pins[0][0], pins[1][1] - pins[0][1]);
    double link3 = hypot(pins[3][0] - pins[2][0], pins[3][1] - pins[2][1]);
    double link4 = hypot(pins[5][0] - pins[4][0], pins[5][1] - pins[4][1]);
    CHECK_NEAR(link3 / link1, 2.0, 1e-3);
    CHECK_NEAR(link4 / link1, 2.5, 1e-3);
    free(svg);
    close_machine(&m);
}

static void a_drawing_without_poses_is_an_empty_page(void **state)
{
    (void)state;
    Machine m = open_machine("toggle");
    YkDrawing *drawing = yk_drawing_new(m.mech, NULL);
    const char *svg = yk_drawing_svg(drawing);
    assert_non_null(svg);
    assert_int_equal(occurrences(svg, "<circle"), 0);
    check_well_formed(svg);
    yk_drawing_free(drawing);
    yk_drawing_free(NULL);
    close_machine(&m);
}

// The name of a machine may hold what XML reserves.
static void names_are_escaped(void **state)
{
    (void)state;
    static const char text[] = "name: \"<crank> & 'rocker'\"\n"
                               "bodies: {ground: {points: {O: [0, 0]}}, link: {points: {O: [0, 0], P: [1, 0]}}}\n"
                               "joints: {O: {pin: [ground, link], angle: q}}\n";
    YkProblems *problems = yk_problems_new();
    Machine m = {.model = yk_model_parse(text, strlen(text), "test", NULL, problems)};
    assert_non_null(m.model);
    m.mech = yk_mechanism_compile(m.model, NULL, problems);
    m.state = yk_state_new(m.mech);
    assert_true(yk_state_set_time(m.state, 0, problems) >= 0);
    assert_true(yk_state_assemble(m.state) >= 0);
    char *svg = draw_once(&m, NULL);
    assert_non_null(strstr(svg, "&lt;crank&gt; &amp; 'rocker'"));
    check_well_formed(svg);
    free(svg);
    close_machine(&m);
    yk_problems_free(problems);
}

// All points in one place: no extent, but a page all the same.
static void a_machine_without_extent_is_drawn(void **state)
{
    (void)state;
    static const char text[] = "bodies: {link: {}}\njoints: {O: {pin: [ground, link], angle: q}}\n";
    YkProblems *problems = yk_problems_new();
    Machine m = {.model = yk_model_parse(text, strlen(text), "test", NULL, problems)};
    assert_non_null(m.model);
    m.mech = yk_mechanism_compile(m.model, NULL, problems);
    m.state = yk_state_new(m.mech);
    assert_true(yk_state_set_time(m.state, 0, problems) >= 0);
    assert_true(yk_state_assemble(m.state) >= 0);
    char *svg = draw_once(&m, NULL);
    check_on_page(svg);
    assert_null(strstr(svg, "nan"));
    free(svg);
    close_machine(&m);
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_machine_gives_a_well_formed_page),
        cmocka_unit_test(the_same_pose_is_the_same_bytes),
        cmocka_unit_test(asking_twice_gives_the_same_document),
        cmocka_unit_test(joints_and_bodies_are_named_unless_told_otherwise),
        cmocka_unit_test(the_page_is_as_wide_as_asked),
        cmocka_unit_test(poses_but_the_last_are_faint_and_traces_are_paths),
        cmocka_unit_test(a_drawing_is_to_scale),
        cmocka_unit_test(a_drawing_without_poses_is_an_empty_page),
        cmocka_unit_test(names_are_escaped),
        cmocka_unit_test(a_machine_without_extent_is_drawn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
