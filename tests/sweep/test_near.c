// Distances on a path over time are those of the drives: how far they go, the place that far away, the part of a way,
// where they turn back.
#include "solve/machine.h"
#include "sweep/path.h"

typedef double (*Drive)(double t);

static double steady(double t)
{
    return 0.3 + 2 * t;
}
static double quick(double t)
{
    return 0.3 - 500 * t;
}
static double cube(double t)
{
    return t * t * t;
}
static double swing(double t)
{
    return 0.7 * sin(3 * t);
}
static double bump(double t)
{
    return -2 * (t - 0.4) * (t - 0.4);
}

static const struct {
    const char *formula;
    Drive drive;
    double turns_at; // where it turns back; NaN: nowhere near
    bool is_monotone;
} drives[] = {{"0.3 + 2*T", steady, NAN, true},
              {"0.3 - 500*T", quick, NAN, true},
              {"T^3", cube, NAN, true},
              {"0.7*sin(3*T)", swing, 0.52359877559829887, false},
              {"-2*(T - 0.4)^2", bump, 0.4, false}};

// A crank, or a slide whose body is 4 m long, driven so; beside it a crank that moves a hundredth as far.
static Machine machine_with(size_t k, bool is_slide)
{
    char text[1000], drive[200] = "";
    for (const char *c = drives[k].formula; *c; c++) {
        size_t n = strlen(drive);
        snprintf(drive + n, sizeof drive - n, *c == 'T' ? "(t/(1 s))" : "%c", *c);
    }
    snprintf(text, sizeof text,
             "bodies:\n  ground: {points: {O: [0, 0]}}\n  a: {points: {O: [0, 0], A: [4, 0]}}\n"
             "  b: {points: {O: [0, 0]}}\njoints:\n  O: {%s: [ground, a], %s}\n  Q: {pin: [ground, b], angle: p}\n"
             "drives: {q: (%s)*%s, p: 0.01*(%s)*(1 rad)}\n",
             is_slide ? "slide" : "pin", is_slide ? "along: x, distance: q" : "angle: q", drive,
             is_slide ? "(4 m)" : "(1 rad)", drive);
    return machine_parse(text, true);
}

static double size_of_step(size_t k, double a, double b)
{
    return fabs(drives[k].drive(b) - drives[k].drive(a));
}

static void check_place(YkPath *path, size_t k, double at, uint64_t *seed)
{
    double distance = pow(10, check_uniform(seed, -7, -1)), way = check_random(seed) % 2 ? 1 : -1;
    double place = yk_path_off(path, at, way, distance);
    bool gets_there = drives[k].drive != swing || distance < 0.3;
    if (gets_there) assert_true((place - at) * way > 0);
    if (!isnan(place)) {
        double gone = size_of_step(k, at, place);
        assert_true(gone >= 0.4999 * distance && gone < 2.0001 * distance);
    }
    double b = at + check_uniform(seed, 0.05, 0.3), part = check_uniform(seed, 0.1, 0.9);
    double length = yk_path_way(path, at, b);
    assert_true(length >= size_of_step(k, at, b) * (1 - 1e-12));
    double whole = yk_path_length(path, at, b), back = yk_path_length(path, b, at);
    if (drives[k].is_monotone) CHECK_NEAR(whole, size_of_step(k, at, b), 0.02 * size_of_step(k, at, b));
    CHECK_NEAR(back, whole, 0.02 * whole);
    CHECK_NEAR(yk_path_scale(path), 1 / fmax(1, yk_path_fastest(path->state)), 0);
    if (!drives[k].is_monotone) return;
    CHECK_NEAR(length, size_of_step(k, at, b), 1e-12 * (1 + length));
    double between = yk_path_between(path, at, b, part);
    CHECK_NEAR(size_of_step(k, at, between), part * length, 1e-9 * (1 + length));
    assert_false(yk_path_turns_back(path, at));
    double heads = yk_path_heads(path, 0, at, 1), behind = yk_path_heads(path, 0, at, -1);
    assert_true(heads * (drives[k].drive(b) - drives[k].drive(at)) > 0 && heads * behind < 0);
    assert_true(fabs(heads) > 4e-6 && fabs(heads) < 2.1e-5);
    CHECK_NEAR(yk_path_heads(path, 1, at, 1), 0.01 * heads, 1e-9 * fabs(heads) + 1e-15);
}

static void test_distances_over_time(void **unused)
{
    (void)unused;
    uint64_t seed = 17;
    for (size_t k = 0; k < sizeof drives / sizeof *drives; k++)
        for (int is_slide = 0; is_slide < 2; is_slide++) {
            Machine m = machine_with(k, is_slide == 1);
            YkPath path;
            assert_true(yk_path_start(&path, m.state, -1));
            assert_true(yk_path_is_time(&path));
            for (int round = 0; round < 60; round++) {
                double at = check_uniform(&seed, 0.1, 1.2);
                check_place(&path, k, at, &seed);
                double unit = is_slide ? 4 : 1;
                CHECK_NEAR(yk_path_input_at(&path, 0, at), unit * drives[k].drive(at),
                           1e-12 * (1 + fabs(500 * at)) * unit);
            }
            if (!isnan(drives[k].turns_at)) assert_true(yk_path_turns_back(&path, drives[k].turns_at));
            CHECK_NEAR(yk_state_input(m.state, 0).position, (is_slide ? 4 : 1) * drives[k].drive(0),
                       1e-14); // as it was
            yk_path_end(&path);
            machine_free(&m);
        }
}

// Along a coordinate, and along a line, distances are those of the inputs, in radians or sizes of the machine.
static void test_distances_along_a_line(void **unused)
{
    (void)unused;
    for (int is_slide = 0; is_slide < 2; is_slide++) {
        Machine m = machine_with(0, is_slide == 1);
        YkPath path;
        double unit = is_slide ? 4 : 1, goal[6] = {unit * 0.8, 0, 0, 0.053, 0, 0}; // from 0.3 and 0.003
        assert_true(yk_path_start(&path, m.state, 0));
        CHECK_NEAR(yk_path_scale(&path), unit, 0);
        CHECK_NEAR(yk_path_way(&path, 1, 2.5), 1.5 / unit, 1e-15);
        CHECK_NEAR(yk_path_off(&path, 1, -1, 0.25), 1 - 0.25 * unit, 1e-15);
        CHECK_NEAR(yk_path_between(&path, 1, 2, 0.25), 1.25, 1e-15);
        CHECK_NEAR(yk_path_length(&path, 2, 1), 1 / unit, 1e-15);
        assert_false(yk_path_turns_back(&path, 1));
        memcpy(path.others, (double[]){1, 2, 3, 4, 5, 6}, 6 * sizeof(double)); // another rests, if rates are the path's
        assert_int_equal(yk_path_set_inputs(&path, 7, true), YK_OK);
        assert_memory_equal(m.state->input, ((double[]){7, 1, 0, 4, 0, 0}), 6 * sizeof(double));
        assert_int_equal(yk_path_set_inputs(&path, 7, false), YK_OK);
        assert_memory_equal(m.state->input, ((double[]){7, 2, 3, 4, 5, 6}), 6 * sizeof(double));
        yk_path_end(&path);
        assert_true(yk_path_start(&path, m.state, 1));
        memcpy(path.others, (double[]){1, 2, 3, 4, 5, 6}, 6 * sizeof(double));
        assert_int_equal(yk_path_set_inputs(&path, 7, true), YK_OK);
        assert_memory_equal(m.state->input, ((double[]){1, 0, 0, 7, 1, 0}), 6 * sizeof(double));
        yk_path_end(&path);
        assert_true(yk_path_start_line(&path, m.state, goal));
        CHECK_NEAR(yk_path_way(&path, 0, 1), 0.5, 1e-14);
        CHECK_NEAR(yk_path_off(&path, 0.5, 1, 0.1), 0.7, 1e-14);
        yk_path_set_inputs(&path, 0.25, true);
        CHECK_NEAR(m.state->input[0], unit * 0.425, 1e-14);
        CHECK_NEAR(m.state->input[1], unit * 0.5, 1e-14);
        CHECK_NEAR(m.state->input[3], 0.0155, 1e-15);
        goal[1] = 5, goal[2] = 6, goal[4] = 7, goal[5] = 8;
        yk_path_set_inputs(&path, 1, false); // the goal itself, with its rates
        assert_memory_equal(m.state->input, goal, sizeof goal);
        yk_path_set_inputs(&path, 1, true);
        CHECK_NEAR(m.state->input[4], 0.05, 1e-15);
        assert_true(m.state->input[2] == 0 && m.state->input[5] == 0);
        yk_path_end(&path);
        machine_free(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_distances_over_time),
        cmocka_unit_test(test_distances_along_a_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
