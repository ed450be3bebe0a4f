// Alt's problem: the stored start solutions, the equations against four-bars, and paths in both directions.
#include "synthesis/answer.h"
#include <stdlib.h>
#include "synthesis/nine_points/alt_certify.h"
#include "synthesis/paths/path_bar.h"
#include "synthesis/paths/path_search.h"

enum { N = YK_ALT_SIZE, P = YK_ALT_PLACES, TRIPLES = YK_ALT_TRIPLES, NAMES = YK_ALT_NAMES };

// The points of Roth and Freudenstein.
static const YkVec published[YK_ALT_POINTS] = {{.25, 0},     {.52, .10},  {.80, .70}, {1.20, 1}, {1.40, 1.30},
                                               {1.10, 1.48}, {.70, 1.40}, {.20, 1},   {.02, .40}};

// --- a four-bar with nine points of its curve

typedef struct Known {
    YkBar bar;
    YkVec point[YK_ALT_POINTS];
    double input[YK_ALT_POINTS], coupler[YK_ALT_POINTS];
    YkAltTask task;
    YkVec x[N]; // the solution that it is
} Known;

static void set_dyad(const Known *k, YkVec moving, YkVec fixed, YkVec *x)
{
    x[YK_ALT_X] = yk_scale(1 / k->task.size, yk_sub(moving, k->point[0]));
    x[YK_ALT_A] = yk_scale(1 / k->task.size, yk_sub(fixed, k->point[0]));
    x[YK_ALT_X_HAT] = yk_conj(x[YK_ALT_X]);
    x[YK_ALT_A_HAT] = yk_conj(x[YK_ALT_A]);
}

// Invents a crank-rocker and drives its crank through nine points.
static Known known_from(uint64_t *seed)
{
    Known k = {.bar = {.kind = YK_DESIGN_FOUR_BAR, .branch = check_random(seed) & 1 ? 1 : -1}};
    double *v = k.bar.v, at = check_uniform(seed, -3, 3);
    v[YK_BAR_X] = check_uniform(seed, -1, 1);
    v[YK_BAR_Y] = check_uniform(seed, -1, 1);
    v[YK_BAR_TURN] = check_uniform(seed, -3, 3);
    v[YK_BAR_INPUT] = check_uniform(seed, 0.5, 1);
    v[YK_BAR_GROUND] = check_uniform(seed, 2, 3);
    v[YK_BAR_COUPLER] = check_uniform(seed, 2, 3);
    v[YK_BAR_OUTPUT] = check_uniform(seed, 2.5, 3.4);
    v[YK_BAR_PX] = check_uniform(seed, -2, 3);
    v[YK_BAR_PY] = check_uniform(seed, 0.5, 2);
    for (size_t j = 0; j < YK_ALT_POINTS; j++) {
        YkBarPoint p;
        k.input[j] = at;
        at += check_uniform(seed, 0.3, 0.75);
        assert_true(yk_bar_point(&k.bar, k.input[j], &p));
        k.point[j] = p.at;
        k.coupler[j] = p.coupler;
    }
    yk_alt_pose(k.point, 1, &k.task);
    YkVec A0 = yk_bar_pivot(&k.bar), A = yk_add(A0, yk_scale(v[YK_BAR_INPUT], yk_unit(k.input[0])));
    set_dyad(&k, A, A0, k.x);
    set_dyad(&k, yk_add(A, yk_scale(v[YK_BAR_COUPLER], yk_unit(k.coupler[0]))),
             yk_add(A0, yk_scale(v[YK_BAR_GROUND], yk_unit(v[YK_BAR_TURN]))), k.x + YK_ALT_DYAD);
    return k;
}

static double distance(const YkVec *x, const YkVec *y)
{
    double most = 0;
    for (size_t k = 0; k < N; k++) most = fmax(most, yk_norm(yk_sub(x[k], y[k])) / fmax(1, yk_norm(x[k])));
    return most;
}

static void a_four_bar_solves_the_equations_by_all_its_names(void **state)
{
    (void)state;
    uint64_t seed = 1;
    for (uint64_t i = 0; i < check_cases(100); i++) {
        Known k = known_from(&seed);
        YkVec named[N], again[N], turn;
        for (size_t j = 0; j < N; j++) {
            assert_true(yk_alt_turn(k.task.places, k.x, j, &turn));
            YkVec expected = yk_unit(k.coupler[j + 1] - k.coupler[0]);
            CHECK_NEAR(yk_norm(yk_sub(turn, expected)), 0, 1e-7);
        }
        for (size_t name = 0; name < NAMES; name++) {
            yk_alt_name(name, k.x, named);
            memcpy(again, named, sizeof again);
            assert_true(yk_alt_polish(k.task.places, again) < 1e-9);
            CHECK_NEAR(distance(named, again), 0, 1e-8);
            YkVec third = yk_sub(named[YK_ALT_A], k.x[YK_ALT_A]); // names 0 and 1 begin with the first pivot
            assert_int_equal(yk_norm(third) < 1e-8, name < 2);
            yk_alt_swap(named, again);
            YkVec back[N];
            yk_alt_name((name + 3) % NAMES, k.x, back);
            CHECK_NEAR(distance(again, back), 0, 0);
        }
        yk_alt_cognate(k.x, named);
        yk_alt_cognate(named, again); // pairs the first pivot with the second one again
        CHECK_NEAR(distance(k.x, again), 0, 1e-9);
    }
}

static YkVec anywhere(uint64_t *seed)
{
    double x = check_uniform(seed, -1, 1), y = check_uniform(seed, -1, 1);
    return yk_vec(x, y);
}

static void derivatives_are_those_of_differences(void **state)
{
    (void)state;
    uint64_t seed = 2;
    const double h = 1e-6;
    YkVec places[P], rate[P], x[N], J[N * N], F[N], ahead[N], behind[N], by_rate[N], moved[P];
    for (size_t k = 0; k < P; k++) {
        places[k] = anywhere(&seed);
        rate[k] = anywhere(&seed);
    }
    for (size_t k = 0; k < N; k++) x[k] = anywhere(&seed);
    yk_alt_evaluate(places, x, F, J, rate, by_rate);
    for (size_t k = 0; k <= N; k++) { // each unknown, and then the places
        YkVec at = x[k % N];
        for (int side = 0; side < 2; side++) {
            double step = side == 0 ? h : -h;
            if (k < N) x[k] = yk_add(at, yk_vec(step, 0));
            for (size_t i = 0; i < P; i++) moved[i] = k < N ? places[i] : yk_add(places[i], yk_scale(step, rate[i]));
            yk_alt_evaluate(moved, x, side == 0 ? ahead : behind, NULL, NULL, NULL);
        }
        if (k < N) x[k] = at;
        for (size_t j = 0; j < N; j++) {
            YkVec slope = yk_scale(1 / (2 * h), yk_sub(ahead[j], behind[j])), own = k < N ? J[j * N + k] : by_rate[j];
            CHECK_NEAR(yk_norm(yk_sub(slope, own)), 0, 1e-8 * (1 + yk_norm(own)));
        }
    }
}

// --- the start solutions

typedef struct Starts {
    YkVec x[TRIPLES][N];
    YkAltProof proof[TRIPLES];
} Starts;

static Starts *starts(void)
{
    Starts *s = calloc(1, sizeof *s);
    assert_non_null(s);
    for (size_t i = 0; i < TRIPLES; i++) {
        assert_true(yk_alt_start(i, s->x[i]));
        assert_true(yk_alt_certify(yk_alt_start_places(), s->x[i], &s->proof[i]));
    }
    return s;
}

static void the_start_solutions_are_proved_and_all_different(void **state)
{
    (void)state;
    Starts *s = starts();
    for (size_t i = 0; i < TRIPLES; i++) {
        assert_int_equal(s->proof[i].reality, YK_ALT_UNKNOWN); // their places are not real
        for (size_t k = 0; k < i; k++) assert_true(yk_alt_are_different(&s->proof[i], &s->proof[k]));
    }
    YkVec x[N];
    assert_false(yk_alt_start(TRIPLES, x));
    free(s);
}

// Finds the start solution to which a solution at a task's places belongs, along route 0.
static size_t origin_of(const Known *k, const Starts *s)
{
    YkAltRoute route;
    YkVec x[N];
    bool arrived = false;
    yk_alt_lay(&k->task, 0, &route);
    for (size_t i = 0; i < NAMES && !arrived; i++) {
        YkAltPath path = {k->task.places, route.from, i >= NAMES / 2, NULL};
        yk_alt_name(i % (NAMES / 2), k->x, x);
        arrived = yk_alt_follow(&path, x);
    }
    assert_true(arrived);
    for (size_t i = 0; i < N; i++)
        x[i] = yk_mul(yk_inverse(i % YK_ALT_DYAD < YK_ALT_X_HAT ? route.z : route.hat), x[i]);
    YkAltProof proof;
    size_t found = TRIPLES, matches = 0;
    assert_true(yk_alt_polish(yk_alt_start_places(), x) < 1e-9);
    assert_true(yk_alt_certify(yk_alt_start_places(), x, &proof));
    for (size_t i = 0; i < TRIPLES; i++) {
        if (yk_alt_are_different(&proof, &s->proof[i])) continue;
        found = i;
        matches++;
    }
    assert_int_equal(matches, 1); // the table has it, and once
    return found;
}

static void every_four_bar_comes_from_a_start_solution(void **state)
{
    (void)state;
    Starts *s = starts();
    uint64_t seed = 3;
    for (uint64_t i = 0; i < check_cases(60); i++) {
        Known k = known_from(&seed);
        YkAltProof proof, own;
        YkVec x[N];
        size_t origin = origin_of(&k, s);
        assert_true(yk_alt_path(&k.task, origin, NULL, x));
        assert_true(yk_alt_certify(k.task.places, x, &proof));
        assert_int_equal(proof.reality, YK_ALT_REAL);
        assert_true(yk_alt_certify(k.task.places, k.x, &own));
        assert_int_equal(own.reality, YK_ALT_REAL);
        assert_false(yk_alt_are_different(&proof, &own));
    }
    free(s);
}

static void paths_to_the_published_points_are_proved_and_different(void **state)
{
    (void)state;
    enum { PATHS = 100 };
    YkAltTask task;
    static YkAltProof proof[PATHS];
    size_t count = 0, cases = (size_t)check_cases(PATHS), of[3] = {0};
    yk_alt_pose(published, 1, &task);
    for (size_t i = 0; i < cases; i++) {
        YkVec x[N], y[N];
        assert_true(yk_alt_path(&task, i, NULL, x));
        memcpy(y, x, sizeof y);
        assert_true(yk_alt_certify(task.places, y, &proof[count]));
        CHECK_NEAR(distance(x, y), 0, 1e-7);
        of[proof[count].reality]++;
        for (size_t k = 0; k < count; k++) assert_true(yk_alt_are_different(&proof[count], &proof[k]));
        count++;
    }
    assert_int_equal(of[YK_ALT_UNKNOWN], 0);
    if (cases == PATHS) assert_true(of[YK_ALT_REAL] > 0 && of[YK_ALT_REAL] < 20); // 64 of 1,442 are
}

static void a_point_that_is_no_solution_is_not_proved(void **state)
{
    (void)state;
    uint64_t seed = 4;
    Known k = known_from(&seed);
    YkAltProof proof;
    YkVec near[N], far[N];
    memcpy(near, k.x, sizeof near);
    memcpy(far, k.x, sizeof far);
    near[0].x += 1e-9; // improved, and then proved
    far[0].x += 0.3;
    assert_true(yk_alt_certify(k.task.places, near, &proof));
    CHECK_NEAR(distance(near, k.x), 0, 1e-10);
    assert_false(yk_alt_certify(k.task.places, far, &proof));
}

// --- the whole answer

typedef struct OnePath {
    YkPieces *pieces;
    size_t wanted, width;
} OnePath;

// Computes one path of the exact search alone, in the place of the first, as if all others had got lost.
static YkStatus get_one(void *context, size_t piece, double *numbers)
{
    OnePath *one = context;
    if (piece == 0) return yk_pieces_compute(one->pieces, one->wanted, numbers);
    for (size_t k = 0; k < one->width; k++) numbers[k] = 0;
    return YK_OK;
}

static YkTask *task_of(const YkVec *point)
{
    char text[2000];
    int length = snprintf(text, sizeof text, "synthesis: path\nmechanisms: [four-bar]\npoints:\n");
    for (size_t k = 0; k < YK_ALT_POINTS; k++)
        length += snprintf(text + length, sizeof text - (size_t)length, "- [%.17g, %.17g]\n", point[k].x, point[k].y);
    YkProblems *problems = yk_problems_new();
    YkTask *task = yk_task_parse(text, strlen(text), "task.yaml", problems);
    if (!task) print_error("%s\n", yk_problems_text(problems, 0));
    assert_non_null(task);
    yk_problems_free(problems);
    return task;
}

// Whether a machine joins two of a triple's fixed pivots.
static bool joins(const YkCandidate *c, YkVec one, YkVec other)
{
    YkVec pivot[2] = {yk_vec(c->pivots[0][0], c->pivots[0][1]), yk_vec(c->pivots[1][0], c->pivots[1][1])};
    for (int swapped = 0; swapped < 2; swapped++)
        if (yk_norm(yk_sub(pivot[swapped], one)) + yk_norm(yk_sub(pivot[1 - swapped], other)) < 1e-6 * c->size)
            return true;
    return false;
}

// Requires the four-bar and its two cognates among the answers, shown or left out.
static void expect_triple(const YkSynthesis *s, const Known *k)
{
    for (size_t name = 0; name < NAMES / 2; name++) {
        YkVec x[N];
        size_t found = 0;
        yk_alt_name(name, k->x, x);
        YkVec one = yk_add(k->point[0], yk_scale(k->task.size, x[YK_ALT_A]));
        YkVec other = yk_add(k->point[0], yk_scale(k->task.size, x[YK_ALT_DYAD + YK_ALT_A]));
        for (size_t i = 0; i < yk_synthesis_count(s); i++) {
            YkCandidate c = yk_synthesis_candidate(s, i);
            found += joins(&c, one, other);
        }
        for (size_t i = 0; i < yk_synthesis_defect_count(s); i++) {
            YkCandidate c = yk_synthesis_defect(s, i);
            found += joins(&c, one, other);
        }
        assert_true(found >= 1);
    }
}

static void a_four_bar_and_its_cognates_are_among_the_answers(void **state)
{
    (void)state;
    Starts *s = starts();
    uint64_t seed = 5;
    Known k = known_from(&seed);
    YkTask *task = task_of(k.point);
    OnePath one = {.pieces = yk_pieces_new(task, NULL, NULL), .wanted = origin_of(&k, s)};
    one.width = yk_pieces_width(one.pieces);
    YkSynthesisOptions options = yk_default_synthesis_options();
    options.pieces = (YkPieceSource){get_one, &one};
    YkSynthesis *answer = yk_synthesis_run(task, &options, NULL);
    size_t complex_count = 0, real_count = 0, left_out = 0;
    assert_non_null(answer);
    assert_true(yk_synthesis_solutions(answer, &complex_count, &real_count));
    assert_int_equal(complex_count, NAMES);
    assert_int_equal(real_count, NAMES);
    assert_false(yk_synthesis_is_complete(answer)); // 1 of 1,442
    for (int d = 1; d < YK_DEFECT_COUNT; d++) left_out += yk_synthesis_left_out(answer, (YkDefect)d);
    assert_int_equal(yk_synthesis_count(answer) + left_out, NAMES / 2);
    assert_true(yk_synthesis_count(answer) >= 2); // a crank-rocker has a cognate of its kind
    for (size_t i = 0; i < yk_synthesis_count(answer); i++) {
        YkCandidate c = yk_synthesis_candidate(answer, i);
        size_t angles;
        assert_true(c.worst < 1e-11);
        assert_non_null(yk_synthesis_angles(answer, i, &angles));
        assert_int_equal(angles, YK_ALT_POINTS);
    }
    expect_triple(answer, &k);
    yk_synthesis_free(answer);
    yk_pieces_free(one.pieces);
    yk_task_free(task);
    free(s);
}

typedef struct Asked {
    size_t exact, paths;
} Asked;

// Counts the paths that are asked for; none of them arrives, and the search that follows is ended.
static YkStatus get_none(void *context, size_t piece, double *numbers)
{
    Asked *asked = context;
    if (piece >= asked->exact) return YK_STOPPED;
    asked->paths++;
    numbers[0] = 0;
    return YK_OK;
}

// No path to points on a line arrives at a solution that is alone.
static void points_without_such_solutions_are_given_up_soon(void **state)
{
    (void)state;
    YkVec line[YK_ALT_POINTS], x[N];
    for (size_t k = 0; k < YK_ALT_POINTS; k++) line[k] = yk_vec((double)k, 0);
    YkAltTask alt;
    yk_alt_pose(line, 1, &alt);
    YkAltProof proof;
    bool arrived = yk_alt_path(&alt, 0, NULL, x);
    assert_false(arrived && yk_alt_certify(alt.places, x, &proof));
    YkTask *task = task_of(line);
    Asked asked = {.exact = yk_path_exact_pieces(task)};
    assert_int_equal(asked.exact, YK_ALT_ROUTES * TRIPLES);
    YkSynthesisOptions options = yk_default_synthesis_options();
    options.pieces = (YkPieceSource){get_none, &asked};
    YkSynthesis *answer = yk_synthesis_run(task, &options, NULL);
    size_t complex_count, real_count;
    assert_non_null(answer);
    assert_true(asked.paths > 0 && asked.paths < 100);
    assert_false(yk_synthesis_solutions(answer, &complex_count, &real_count));
    assert_false(yk_synthesis_is_complete(answer));
    yk_synthesis_free(answer);
    yk_task_free(task);
}

static void the_published_points_have_8652_solutions(void **state)
{
    (void)state;
    if (!getenv("YOKE_FULL")) skip();
    YkTask *task = task_of(published);
    for (uint64_t seed = 1; seed <= 3; seed++) {
        YkSynthesisOptions options = yk_default_synthesis_options();
        options.seed = seed;
        YkSynthesis *answer = yk_synthesis_run(task, &options, NULL);
        size_t complex_count = 0, real_count = 0, left_out = 0;
        assert_non_null(answer);
        assert_true(yk_synthesis_solutions(answer, &complex_count, &real_count));
        assert_int_equal(complex_count, 8652);
        assert_int_equal(real_count, 384);
        assert_true(yk_synthesis_is_complete(answer));
        for (int d = 1; d < YK_DEFECT_COUNT; d++) left_out += yk_synthesis_left_out(answer, (YkDefect)d);
        assert_int_equal(yk_synthesis_count(answer) + left_out, 192);
        assert_int_equal(yk_synthesis_count(answer), 2); // cognates of each other
        yk_synthesis_free(answer);
    }
    yk_task_free(task);
}

static void four_bars_are_found_again_among_all(void **state)
{
    (void)state;
    if (!getenv("YOKE_FULL")) skip();
    uint64_t seed = 6;
    for (int i = 0; i < 20; i++) {
        Known k = known_from(&seed);
        YkTask *task = task_of(k.point);
        YkSynthesisOptions options = yk_default_synthesis_options();
        options.best = 1000;
        YkSynthesis *answer = yk_synthesis_run(task, &options, NULL);
        size_t complex_count = 0, real_count = 0;
        assert_non_null(answer);
        assert_true(yk_synthesis_solutions(answer, &complex_count, &real_count));
        print_message("%d: %zu solutions, %zu real, %zu machines\n", i, complex_count, real_count,
                      yk_synthesis_count(answer));
        assert_true(yk_synthesis_is_complete(answer));
        assert_int_equal(complex_count, 8652);
        expect_triple(answer, &k);
        yk_synthesis_free(answer);
        yk_task_free(task);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_four_bar_solves_the_equations_by_all_its_names),
        cmocka_unit_test(derivatives_are_those_of_differences),
        cmocka_unit_test(the_start_solutions_are_proved_and_all_different),
        cmocka_unit_test(every_four_bar_comes_from_a_start_solution),
        cmocka_unit_test(paths_to_the_published_points_are_proved_and_different),
        cmocka_unit_test(a_point_that_is_no_solution_is_not_proved),
        cmocka_unit_test(a_four_bar_and_its_cognates_are_among_the_answers),
        cmocka_unit_test(points_without_such_solutions_are_given_up_soon),
        cmocka_unit_test(the_published_points_have_8652_solutions),
        cmocka_unit_test(four_bars_are_found_again_among_all),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
