// The derivatives of its cost that a path's fit uses, with limits and with angles that follow the ground, against
// differences of the cost itself.
#include "synthesis/answer.h"
#include "synthesis/paths/path_search.h"

static const char text[] = "synthesis: path\npoints: [[0, 0], [1, .2], [1.5, 1], [.7, 1.4], [-.2, .9]]\n"
                           "require: {input: turns, transmission: 50 deg, size_ratio: 2}\n"
                           "bounds: {pivots: [[-.5, -.5], [.5, .5]]}\n";

// Draws a bar that closes at every point's angle. Returns false after many that do not.
static bool draw(YkPathBatches *b, uint64_t *seed)
{
    YkPathTry *try = &b->whole;
    for (int tries = 0; tries < 2000; tries++) {
        *try = (YkPathTry){.angle = try->angle,
                           .bar = {.kind = b->problem.kind, .hangs_at_end = tries % 2 == 1, .bend = 1}};
        try->bar.branch = check_random(seed) % 2 ? 1 : -1;
        for (size_t j = 0; j < b->problem.dimensions; j++) try->bar.v[j] = check_uniform(seed, j < 2 ? -1.5 : .2, 3);
        for (size_t k = 0; k < b->problem.count; k++)
            try->angle[k] = b->problem.angle ? b->problem.angle[k] : .3 + b->problem.step * (double)k;
        if (yk_path_measure(&b->problem, &b->work, try)) return true;
    }
    return false;
}

// Returns the cost with one unknown changed: a dimension, or the shift of all angles.
static double cost_at(YkPathBatches *b, size_t unknown, double change)
{
    YkPathTry *try = &b->whole;
    YkBar kept = try->bar;
    size_t turned = unknown == b->problem.dimensions ? b->problem.count : 0;
    if (!turned) try->bar.v[unknown] += change;
    for (size_t k = 0; k < turned; k++) try->angle[k] += change;
    assert_true(yk_path_measure(&b->problem, &b->work, try));
    for (size_t k = 0; k < turned; k++) try->angle[k] -= change;
    try->bar = kept;
    return try->cost;
}

// The equations that one step leaves in the scratch space are those at its beginning, and have nothing after the last.
static void check_slopes(const YkTask *task, YkDesignKind kind, uint64_t *seed)
{
    YkArena *arena = yk_arena_new();
    YkPathBatches b;
    assert_true(yk_path_batches_new(arena, task, kind, 1, &b));
    const double step = 1e-6;
    size_t n = b.problem.dimensions, rows = 2 * b.problem.count + YK_PATH_LIMITS;
    double slope[YK_PATH_UNKNOWNS];
    assert_true(draw(&b, seed));
    for (size_t j = 0; j <= n; j++) slope[j] = (cost_at(&b, j, step) - cost_at(&b, j, -step)) / (2 * step);
    double cost = cost_at(&b, 0, 0), sum = 0;
    assert_true(yk_path_improve(&b.problem, &b.work, &b.whole, 1));
    for (size_t r = 0; r < rows; r++) sum += b.work.miss[r] * b.work.miss[r];
    CHECK_NEAR(sum, cost, 1e-12 * cost);
    for (size_t j = 0; j < n + b.problem.shifts; j++) {
        double own = 0;
        for (size_t r = 0; r < rows; r++) own += 2 * b.work.row[r * (n + 1) + j] * b.work.miss[r];
        double bend = 2 * b.work.weight * b.work.weight * step; // where a limit begins to count within the step
        CHECK_NEAR(own, slope[j], 1e-6 * (cost + fabs(own)) + bend);
    }
    yk_arena_free(arena);
}

static void fits_know_the_slopes_of_their_cost(void **state)
{
    (void)state;
    static const char *const timings[] = {"angles: [0, .9, 1.9, 3, 4.4]\n",
                                          "angles: [0, .9, 1.9, 3, 4.4]\nangles_from: ground\n",
                                          "angles: {from: free, step: 50 deg}\n"};
    uint64_t seed = 17;
    for (size_t timing = 0; timing < 3; timing++) {
        char whole[sizeof text + 60];
        snprintf(whole, sizeof whole, "%s%s", text, timings[timing]);
        YkProblems *problems = yk_problems_new();
        YkTask *task = yk_task_parse(whole, strlen(whole), "task.yaml", problems);
        if (!task) print_error("%s", yk_problems_text(problems, 0));
        assert_non_null(task);
        for (int kind = 0; kind < YK_DESIGN_KINDS; kind++)
            for (uint64_t run = 0; run < check_cases(50); run++) check_slopes(task, (YkDesignKind)kind, &seed);
        yk_task_free(task);
        yk_problems_free(problems);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(fits_know_the_slopes_of_their_cost)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
