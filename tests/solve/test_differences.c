// The rates of every point and body of every example are the differences of its poses, the accelerations those of its
// rates, along a motion of the inputs that goes on as their own rates say.
#include <glob.h>
#include <yoke/yoke.h>
#include "check.h"

typedef struct Machine {
    YkProblems *problems;
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
} Machine;

// Puts the inputs where they are after `time`, and solves.
static bool go(const Machine *m, const YkMotion *from, double time)
{
    for (size_t k = 0; k < yk_input_count(m->mech); k++) {
        YkMotion q = from[k];
        q.position += time * q.velocity + 0.5 * time * time * q.acceleration;
        q.velocity += time * q.acceleration;
        yk_state_set_input(m->state, k, q);
    }
    return yk_state_solve(m->state) == YK_OK && yk_state_has_rates(m->state);
}

static void check_difference(double due, double before, double after, double time, double most, const char *file,
                             const char *what)
{
    double found = (after - before) / (2 * time);
    if (fabs(found - due) <= 1e-6 * most) return;
    print_error("%s, %s: %.12g, by differences %.12g\n", file, what, due, found);
    fail();
}

enum { NUMBERS = 400 };

// Reads positions and rates of points and angles of bodies: numbers[3][NUMBERS]. Returns how many.
static size_t read_numbers(const Machine *m, double numbers[3][NUMBERS])
{
    size_t n = 0;
    for (size_t b = 0; b < yk_model_body_count(m->model) && n < NUMBERS; b++, n++) {
        YkMotion q = yk_state_body(m->state, b);
        numbers[0][n] = q.position, numbers[1][n] = q.velocity, numbers[2][n] = q.acceleration;
    }
    for (size_t p = 0; p < yk_model_point_count(m->model); p++) {
        YkPointMotion q = yk_state_point(m->state, p);
        for (int axis = 0; axis < 2 && n < NUMBERS; axis++, n++)
            numbers[0][n] = q.position[axis], numbers[1][n] = q.velocity[axis], numbers[2][n] = q.acceleration[axis];
    }
    return n;
}

// Returns whether differences were taken: not beside a dead point, nor where a drive or a law has a corner.
static bool check_pose(const Machine *m, const YkMotion *from, const char *file)
{
    static double here[3][NUMBERS], before[3][NUMBERS], after[3][NUMBERS];
    double fastest = 1e-3, most[3] = {0, 0, 0};
    if (!go(m, from, 0)) return false;
    size_t n = read_numbers(m, here), bodies = yk_model_body_count(m->model);
    for (size_t k = 0; k < n; k++) {
        fastest = fmax(fastest, fabs(here[1][k]) / (k < bodies ? 1 : yk_mechanism_size(m->mech)));
        for (int order = 1; order < 3; order++) most[order] = fmax(most[order], fabs(here[order][k]));
    }
    double time = 1e-5 / fastest;
    for (size_t k = 0; k < yk_block_count(m->mech); k++)
        if (yk_block_info(m->mech, k).kind <= YK_BLOCK_RPR && yk_state_transmission(m->state, k) < 0.05) return false;
    if (!go(m, from, -time)) return false;
    read_numbers(m, before);
    if (!go(m, from, time)) return false;
    read_numbers(m, after);
    for (size_t k = 0; k < n; k++)
        for (int order = 1; order < 3; order++)
            check_difference(here[order][k], before[order - 1][k], after[order - 1][k], time,
                             most[order] + fastest * yk_mechanism_size(m->mech), file,
                             order == 1 ? "rate" : "acceleration");
    return true;
}

static size_t check_file(const char *path)
{
    const char *file = strrchr(path, '/') + 1;
    size_t done = 0;
    Machine m = {.problems = yk_problems_new()};
    m.model = yk_model_load(path, NULL, m.problems);
    m.mech = m.model ? yk_mechanism_compile(m.model, NULL, m.problems) : NULL;
    m.state = m.mech ? yk_state_new(m.mech) : NULL;
    if (m.state && yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) == YK_OK) {
        YkMotion from[16];
        size_t count = yk_input_count(m.mech);
        uint64_t seed = 3;
        for (int pose = 0; pose < 5 && count <= 16; pose++) {
            for (size_t k = 0; k < count; k++) {
                bool is_distance = yk_coordinate_info(m.mech, yk_input_coordinate(m.mech, k)).is_distance;
                double unit = is_distance ? 0.05 * yk_mechanism_size(m.mech) : 0.2;
                if (pose == 0) from[k] = yk_state_input(m.state, k);
                from[k].position += pose * unit * check_uniform(&seed, 0.2, 1);
                from[k].velocity = unit * check_uniform(&seed, 1, 3);
                from[k].acceleration = unit * check_uniform(&seed, -9, 9);
            }
            if (pose > 0) done += check_pose(&m, from, file); // laws may have corners at the start
        }
    }
    yk_state_free(m.state);
    yk_mechanism_free(m.mech);
    yk_model_free(m.model);
    yk_problems_free(m.problems);
    return done;
}

static void rates_are_differences(void **unused)
{
    (void)unused;
    glob_t found;
    size_t done = 0, step = check_cases(1000) == 1000 ? 1 : 4;
    assert_int_equal(glob(YOKE_ROOT "/examples/*.yaml", 0, NULL, &found), 0);
    for (size_t k = 0; k < found.gl_pathc; k += step) done += check_file(found.gl_pathv[k]);
    assert_true(done * step > 150);
    globfree(&found);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rates_are_differences),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
