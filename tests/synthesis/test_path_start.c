// Where a search for paths begins: angles that go round as the points do, and the place, the size and the coupler point
// that fit best.
#include "synthesis/answer.h"
#include "base/vec.h"
#include "synthesis/paths/path_search.h"

typedef struct Search {
    YkTask *task;
    YkArena *arena;
    YkPathBatches batches;
    uint64_t seed;
} Search;

static Search search_for(const char *text, YkDesignKind kind)
{
    YkProblems *problems = yk_problems_new();
    Search s = {.task = yk_task_parse(text, strlen(text), "task.yaml", problems), .arena = yk_arena_new(), .seed = 7};
    if (!s.task) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(s.task);
    yk_problems_free(problems);
    assert_true(yk_path_batches_new(s.arena, s.task, kind, 1, &s.batches));
    return s;
}

static void end(Search *s)
{
    yk_arena_free(s->arena);
    yk_task_free(s->task);
}

// Draws until a bar closes. Skipping the same bars leaves the random numbers at the same place.
static YkPathTry *draw(Search *s)
{
    YkPathTry *try = &s->batches.whole;
    for (int tries = 0; tries < 20000; tries++) {
        uint64_t skipped = s->seed;
        yk_path_skip(&s->batches.problem, &skipped, &s->batches.try[0]);
        bool closes = yk_path_draw(&s->batches.problem, &s->batches.work, &s->seed, try);
        assert_true(s->seed == skipped);
        if (closes) return try;
    }
    fail_msg("no bar closes");
    return NULL;
}

static const char *const lines[] = {"synthesis: path\npoints: [[0, 0], [1, .2], [1.5, 1], [.7, 1.4], [-.2, .9]]\n",
                                    "synthesis: path\npoints: [[1, 0], [0, 1], [-1, 0], [0, -1]]\nclosed: true\n",
                                    "synthesis: path\npoints: [[1, 0], [0, 1], [-1, 0], [0, -1], [1, 0]]\n"};

// The points of the last two divide a circle evenly, and so do their angles.
static void free_angles_go_one_way_and_at_most_round(void **state)
{
    (void)state;
    for (size_t way = 0; way < 3; way++) {
        Search s = search_for(lines[way], YK_DESIGN_FOUR_BAR);
        size_t n = s.batches.problem.count;
        for (uint64_t run = 0; run < check_cases(60); run++) {
            const double *angle = draw(&s)->angle;
            double whole = angle[n - 1] - angle[0];
            assert_true(fabs(whole) <= 2 * YK_PI * (1 + 1e-15));
            for (size_t k = 1; k < n; k++) {
                assert_true((angle[k] - angle[k - 1]) * whole > 0);
                if (way > 0) CHECK_NEAR(fabs(angle[k] - angle[k - 1]), YK_PI / 2, 1e-13);
            }
        }
        end(&s);
    }
}

static double error_with(Search *s, int dimension, double change)
{
    YkPathTry *try = &s->batches.whole;
    double kept = try->bar.v[dimension];
    try->bar.v[dimension] = kept + change;
    assert_true(yk_path_measure(&s->batches.problem, &s->batches.work, try));
    try->bar.v[dimension] = kept;
    return try->error;
}

static bool is_bounded(const YkPathProblem *p, const YkBar *bar)
{
    for (size_t j = 0; j < p->dimensions; j++)
        if (bar->v[j] <= p->low[j] || bar->v[j] >= p->high[j]) return true;
    return false;
}

// Returns the error with everything but the pivot larger by a part, and turned about it by an angle.
static double error_grown(Search *s, double part, double turn)
{
    YkPathTry *try = &s->batches.whole;
    YkBar kept = try->bar;
    for (int j = YK_BAR_GROUND; j <= YK_BAR_PY; j++) try->bar.v[j] *= j == YK_BAR_TURN ? 1 : 1 + part;
    try->bar.v[YK_BAR_TURN] += turn;
    for (size_t k = 0; k < s->batches.problem.count; k++) try->angle[k] += turn;
    assert_true(yk_path_measure(&s->batches.problem, &s->batches.work, try));
    for (size_t k = 0; k < s->batches.problem.count; k++) try->angle[k] -= turn;
    try->bar = kept;
    return try->error;
}

// No small change of the pivot, the coupler point, the size or the direction makes the sum of squares smaller: their
// differences to both sides are equal, and both are above.
static void bars_are_placed_where_they_fit_best(void **state)
{
    (void)state;
    static const YkDesignKind kinds[] = {YK_DESIGN_FOUR_BAR, YK_DESIGN_SLIDER_CRANK, YK_DESIGN_INVERTED};
    static const int placed[] = {YK_BAR_X, YK_BAR_Y, YK_BAR_PX, YK_BAR_PY};
    const double h = 1e-4;
    size_t compared = 0;
    for (size_t way = 0; way < 2; way++)
        for (size_t kind = 0; kind < 3; kind++) {
            Search s = search_for(lines[way], kinds[kind]);
            for (uint64_t run = 0; run < check_cases(40); run++) {
                double error = draw(&s)->error, scale = yk_norm(yk_vec(s.batches.whole.bar.v[YK_BAR_INPUT], 1));
                if (is_bounded(&s.batches.problem, &s.batches.whole.bar)) continue;
                for (size_t k = 0; k < 4; k++) {
                    double more = error_with(&s, placed[k], h) - error, less = error_with(&s, placed[k], -h) - error;
                    CHECK_NEAR(more, less, 1e-11 * scale * scale);
                    assert_true(more > 0);
                }
                CHECK_NEAR(error_grown(&s, h, 0), error_grown(&s, -h, 0), 1e-9 * scale * scale);
                CHECK_NEAR(error_grown(&s, 0, h), error_grown(&s, 0, -h), 1e-9 * scale * scale);
                compared++;
            }
            end(&s);
        }
    assert_true(compared > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_angles_go_one_way_and_at_most_round),
        cmocka_unit_test(bars_are_placed_where_they_fit_best),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
