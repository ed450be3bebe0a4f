// A redesign against the loader: the same values as the file read anew with them, refused where the file is.
#include <math.h>
#include "fixture.h"
#include "model/redesign.h"

static const char *const machine =
    "parameters: {x: 1, y: 0.5, m: 2 kg, i: 0.3 kg*m^2, k: 50 N/m, c: 2 N*s/m, mu: 0.2, e: 0.5, low: -1 m, high: 2 m, "
    "g: 9.81 m/s^2, slope: 0.2 rad, both: x + 2*y}\n"
    "gravity: [0, -g]\n"
    "bodies:\n  ground: {points: {O: [0, 0], Q: [3 m, 0]}}\n"
    "  crank: {points: {O: [0, 0], A: [x * 1 m, y * 1 m]}, mass: m, rod: [O, A]}\n"
    "  plate: {points: {A: [0, 0], B: [both * 1 m, 0]}, mass: 2*m, center: [x * 1 m, 0.1 m], inertia: i}\n"
    "  block: {mass: m}\n"
    "joints:\n  O: {pin: [ground, crank], angle: q, friction: {coulomb: mu, radius: 20 mm}}\n"
    "  A: {pin: [crank, plate], angle: u}\n"
    "  S: {slide: [ground, block], along: slope, distance: s, friction: {viscous: c}}\n"
    "springs:\n  k: {between: [plate.B, ground.Q], stiffness: k, length: x * 1 m, damping: c}\n"
    "stops: {s: {between: [low, high], restitution: e}}\n";
static const char *const names[] = {"x", "y", "m", "i", "k", "c", "mu", "e", "low", "high", "g", "slope"};
enum { COUNT = sizeof names / sizeof *names };
static const double usual[COUNT] = {1, 0.5, 2, 0.3, 50, 2, 0.2, 0.5, -1, 2, 9.81, 0.2};
static const char *const units[COUNT] = {"", "", " kg", " kg*m^2", " N/m",   " N*s/m",
                                         "", "", " m",  " m",      " m/s^2", " rad"};

static YkModel *read_anew(const double *values)
{
    char text[COUNT][64];
    YkOverride overrides[COUNT];
    for (int k = 0; k < COUNT; k++) {
        snprintf(text[k], sizeof text[k], "(%.17g)%s%s", values[k], *units[k] ? " * 1" : "", units[k]);
        overrides[k] = (YkOverride){names[k], text[k]};
    }
    YkLoadOptions options = {.parameters = overrides, .parameter_count = COUNT};
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(machine, strlen(machine), "test.yaml", &options, problems);
    yk_problems_free(problems);
    return model;
}

static void check_vec(YkVec a, YkVec b)
{
    CHECK_NEAR(a.x, b.x, 1e-14 * (1 + fabs(b.x)));
    CHECK_NEAR(a.y, b.y, 1e-14 * (1 + fabs(b.y)));
}

static void check_same(const YkModel *a, const YkModel *b)
{
    check_vec(a->gravity, b->gravity);
    for (size_t k = 0; k < b->point_count; k++) check_vec(a->points[k].at, b->points[k].at);
    for (size_t k = 1; k < b->body_count; k++) {
        CHECK_NEAR(a->bodies[k].mass, b->bodies[k].mass, 1e-14 * b->bodies[k].mass);
        CHECK_NEAR(a->bodies[k].inertia, b->bodies[k].inertia, 1e-14 * b->bodies[k].inertia);
        check_vec(a->bodies[k].center, b->bodies[k].center);
    }
    for (size_t k = 0; k < b->joint_count; k++) {
        for (int side = 0; side < 2; side++) check_vec(a->joints[k].at[side], b->joints[k].at[side]);
        check_vec(a->joints[k].along, b->joints[k].along);
        CHECK_NEAR(a->joints[k].friction.coulomb, b->joints[k].friction.coulomb, 0);
        CHECK_NEAR(a->joints[k].friction.viscous, b->joints[k].friction.viscous, 0);
    }
    const YkSpring *s = &a->springs[0], *t = &b->springs[0];
    for (int side = 0; side < 2; side++) check_vec(s->at[side], t->at[side]);
    CHECK_NEAR(s->stiffness, t->stiffness, 0);
    CHECK_NEAR(s->length, t->length, 0);
    CHECK_NEAR(s->damping, t->damping, 0);
    CHECK_NEAR(a->stops[0].low, b->stops[0].low, 0);
    CHECK_NEAR(a->stops[0].high, b->stops[0].high, 0);
    CHECK_NEAR(a->stops[0].restitution, b->stops[0].restitution, 0);
    CHECK_NEAR(a->size, b->size, 1e-13 * b->size);
}

static void values_are_those_of_the_file_read_anew(void **unused)
{
    (void)unused;
    uint64_t seed = 5;
    YkModel *model = fixture_load(machine);
    YkProblems *problems = yk_problems_new();
    YkRedesign *redesign = yk_redesign_new(model, names, COUNT, problems);
    assert_non_null(redesign);
    for (int trial = 0; trial < 60; trial++) {
        double values[COUNT];
        for (int k = 0; k < COUNT; k++) values[k] = usual[k] * check_uniform(&seed, 0.2, 1.8);
        assert_int_equal(yk_redesign_set(redesign, values), YK_OK);
        YkModel *anew = read_anew(values);
        assert_non_null(anew);
        check_same(yk_redesign_model(redesign), anew);
        for (size_t k = 0; k < COUNT; k++) assert_true(yk_redesign_value(redesign, k) == values[k]);
        yk_model_free(anew);
    }
    yk_redesign_free(redesign);
    yk_problems_free(problems);
    yk_model_free(model);
}

// One value at a time that is wrong, just wrong, or just right.
static void what_the_loader_refuses_is_refused(void **unused)
{
    (void)unused;
    static const struct {
        const char *name;
        double value;
    } cases[] = {{"m", 0},   {"m", -1},    {"m", 0.5}, {"m", 1e-9}, {"i", -0.1},    {"i", 0},
                 {"k", -1},  {"k", 0},     {"c", -1},  {"c", 0},    {"mu", -0.1},   {"mu", 0},
                 {"mu", 2},  {"e", -0.01}, {"e", 0},   {"e", 1},    {"e", 1.01},    {"low", 3},
                 {"low", 2}, {"high", -2}, {"x", 0},   {"x", -3},   {"slope", 100}, {"g", -5}};
    YkModel *model = fixture_load(machine);
    YkProblems *problems = yk_problems_new();
    YkRedesign *redesign = yk_redesign_new(model, names, COUNT, problems);
    assert_non_null(redesign);
    int refused = 0;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        double values[COUNT];
        for (int i = 0; i < COUNT; i++) values[i] = strcmp(names[i], cases[k].name) ? usual[i] : cases[k].value;
        YkModel *anew = read_anew(values);
        YkStatus status = yk_redesign_set(redesign, values);
        if (status != (anew ? YK_OK : YK_BAD_MODEL)) print_error("%s = %g\n", cases[k].name, cases[k].value);
        assert_int_equal(status, anew ? YK_OK : YK_BAD_MODEL);
        refused += !anew;
        if (anew) check_same(yk_redesign_model(redesign), anew);
        yk_model_free(anew);
    }
    assert_true(refused >= 8);
    const double flat[COUNT] = {0, 0, 2, 0.3, 50, 2, 0.2, 0.5, -1, 2, 9.81, 0.2}; // a rod without length
    assert_int_equal(yk_redesign_set(redesign, flat), YK_BAD_MODEL);
    for (int k = 0; k < COUNT; k++) {
        double values[COUNT];
        memcpy(values, usual, sizeof values);
        values[k] = k % 2 ? (double)NAN : 1e101;
        assert_int_equal(yk_redesign_set(redesign, values), YK_BAD_MODEL);
    }
    assert_int_equal(yk_redesign_set(redesign, usual), YK_OK);
    yk_redesign_free(redesign);
    yk_problems_free(problems);
    yk_model_free(model);
}

// The wheel turns the other way there, which a redesign cannot tell.
static void a_rack_on_the_other_side_of_its_pinion_is_refused(void **unused)
{
    (void)unused;
    static const char *const slides[] = {"[ground, bar], along: a, from: T", "[bar, ground], along: a, to: T"};
    for (int k = 0; k < 2; k++) {
        char text[600];
        snprintf(text, sizeof text,
                 "parameters: {h: -0.05, a: 0.2}\nbodies:\n  ground: {points: {O: [0, 0], T: [0.03, h]}}\n  wheel: "
                 "{points: {O: [0, 0]}}\n  bar: {}\njoints:\n  O: {pin: [ground, wheel], angle: q}\n"
                 "  R: {slide: %s, distance: s}\nracks: {r: {pinion: wheel, rack: bar, radius: 0.05}}\n",
                 slides[k]);
        YkModel *model = fixture_load(text);
        YkProblems *problems = yk_problems_new();
        YkRedesign *redesign = yk_redesign_new(model, (const char *[]){"h", "a"}, 2, problems);
        assert_non_null(redesign);
        assert_int_equal(yk_redesign_set(redesign, (double[]){-0.04, 0.4}), YK_OK);
        assert_int_equal(yk_redesign_set(redesign, (double[]){0.05, 0.2}), YK_BAD_MODEL);
        assert_int_equal(yk_redesign_set(redesign, (double[]){-0.05, 3.3}), YK_BAD_MODEL);
        assert_int_equal(yk_redesign_set(redesign, (double[]){-0.001, 0.2}), YK_OK);
        assert_int_equal(yk_redesign_set(redesign, (double[]){-0.05, 0.2}), YK_OK);
        yk_redesign_free(redesign);
        yk_problems_free(problems);
        yk_model_free(model);
    }
}

// What follows no parameter is said with its place; a parameter that is not the file's, or follows another that varies,
// too.
static void what_cannot_follow_is_said_where_it_stands(void **unused)
{
    (void)unused;
    static const char *const text =
        "parameters: {r: 30 mm, a: 20 deg, l: 1 m, twice: 2*l}\n"
        "bodies: {wheel: {}, other: {points: {Q: [0, 0], F: [twice, 0]}}, bar: {}, ground: {points: {Q: [0.1, 0], G: "
        "[0, -30 "
        "mm]}}}\n"
        "joints:\n  O: {pin: [ground, wheel], angle: q}\n  Q: {pin: [ground, other], at: Q}\n"
        "  S: {slide: [other, bar], along: x, turned: a}\n"
        "belts: {b: {between: [wheel, other], radii: [r, 10 mm]}}\n";
    static const struct {
        const char *name, *message;
        unsigned line, column;
    } cases[] = {{"a", "a parameter that varies enters the constant angle of a joint here", 6, 46},
                 {"r", "a parameter that varies enters a wheel, a cam or a law here", 7, 46}};
    YkModel *model = fixture_load(text);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        YkProblems *problems = yk_problems_new();
        assert_null(yk_redesign_new(model, &cases[k].name, 1, problems));
        const YkProblem *problem = fixture_problem(problems, YK_CODE_CANNOT_VARY);
        assert_non_null(problem);
        assert_string_equal(problem->message, cases[k].message);
        if (problem->place.line != cases[k].line || problem->place.column != cases[k].column)
            print_error("%u:%u\n", problem->place.line, problem->place.column);
        assert_int_equal(problem->place.line, cases[k].line);
        assert_int_equal(problem->place.column, cases[k].column);
        assert_int_equal(yk_problems_count(problems), 1);
        yk_problems_free(problems);
    }
    const char *both[] = {"l", "twice"}, *stranger = "nobody";
    YkRedesign *good = yk_redesign_new(model, both, 1, NULL);
    assert_non_null(good);
    const double half = 0.5;
    assert_int_equal(yk_redesign_set(good, &half), YK_OK);
    for (size_t p = 0; p < model->point_count; p++)
        if (model->points[p].body == 2)
            CHECK_NEAR(yk_redesign_model(good)->points[p].at.x, model->points[p].at.x / 2, 1e-16);
    yk_redesign_free(good);
    assert_null(yk_redesign_new(model, &stranger, 1, NULL));
    yk_model_free(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_cannot_follow_is_said_where_it_stands),
        cmocka_unit_test(values_are_those_of_the_file_read_anew),
        cmocka_unit_test(what_the_loader_refuses_is_refused),
        cmocka_unit_test(a_rack_on_the_other_side_of_its_pinion_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
