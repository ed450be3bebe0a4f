// Points of a path: the published problems, machines found again from their curves, and every answer measured on its
// file.
#include "synthesis/answer.h"
#include "base/codes.h"
#include "base/mix.h"
#include "synthesis/paths/path_chain.h"
#include "synthesis/paths/path_fit.h"
#include "synthesis/synthesis.h"

// Measures a candidate by its file alone: drives it to the told angles, in small steps that jump nowhere, and returns
// the sum of squared distances from the points.
static double measured(const Answer *a, size_t index, const YkVec *point, size_t count)
{
    enum { STEPS = 200 };
    YkCandidate c = yk_synthesis_candidate(a->synthesis, index);
    size_t angles;
    const double *angle = yk_synthesis_angles(a->synthesis, index, &angles);
    assert_int_equal(angles, count);
    Standing s = standing(c.model);
    size_t P = yk_model_find_point(s.model, "coupler.P");
    double error = 0, size = yk_mechanism_size(s.mech);
    YkVec last = {0, 0};
    for (size_t k = 0; k < count; k++)
        for (int i = k == 0 ? STEPS : 1; i <= STEPS; i++) {
            double from = angle[k > 0 ? k - 1 : 0], to = from + (angle[k] - from) * i / STEPS;
            yk_state_set_input_to(s.state, 0, i == STEPS ? angle[k] : to, 0, 0);
            assert_true(yk_state_solve(s.state) >= 0);
            YkPointMotion p = yk_state_point(s.state, P);
            YkVec at = yk_vec(p.position[0], p.position[1]);
            if (k > 0) assert_true(yk_norm(yk_sub(at, last)) < 0.2 * size);
            last = at;
            if (i == STEPS) error += yk_dot(yk_sub(at, point[k]), yk_sub(at, point[k]));
        }
    standing_free(&s);
    return error;
}

static char *copy_of(const char *text)
{
    char *copy = malloc(strlen(text) + 1);
    assert_non_null(copy);
    return strcpy(copy, text);
}

static void check_all(const Answer *a, const YkVec *point, size_t count)
{
    double last = 0;
    for (size_t k = 0; k < yk_synthesis_count(a->synthesis); k++) {
        YkCandidate c = yk_synthesis_candidate(a->synthesis, k);
        double again = measured(a, k, point, count);
        CHECK_NEAR(again, c.error, 1e-9 * again + 1e-22 * c.size * c.size);
        if (c.error > 1e-18) assert_true(c.error >= last);
        last = c.error;
    }
}

// --- the published problems

static const YkVec line[] = {{20, 20}, {20, 25}, {20, 30}, {20, 35}, {20, 40}, {20, 45}};
static const YkVec arc[] = {{0, 0}, {1.9098, 5.8779}, {6.9098, 9.5106}, {13.09, 9.5106}, {18.09, 5.8779}, {20, 0}};
static const YkVec oval[] = {{20, 10},         {17.66, 15.142}, {11.736, 17.878}, {5, 16.928},     {.60307, 12.736},
                             {.60307, 7.2638}, {5, 3.0718},     {11.736, 2.1215}, {17.66, 4.8577}, {20, 10}};

static void six_points_of_a_line_are_met_to_rounding(void **state)
{
    (void)state;
    Answer a =
        answer_to("synthesis: path\npoints: [[20, 20], [20, 25], [20, 30], [20, 35], [20, 40], [20, 45]]\nbest: 4\n"
                  "bounds: {lengths: [0, 60], coupler_point: [-60, 60], pivots: [[-60, -60], [60, 60]]}\n");
    assert_int_equal(yk_synthesis_count(a.synthesis), 4);
    for (size_t k = 0; k < 4; k++) {
        YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
        assert_true(c.error < 1e-20);
        for (size_t i = 0; i < 4; i++) assert_true(c.lengths[i] > 0 && c.lengths[i] <= 60 * (1 + 1e-9));
        for (size_t i = 0; i < 4; i++) assert_true(fabs(c.pivots[i / 2][i % 2]) <= 60 * (1 + 1e-9));
        for (size_t i = 0; i < 2; i++) assert_true(fabs(c.point[i]) <= 60 * (1 + 1e-9));
    }
    check_all(&a, line, 6);
    answer_free(&a);
}

static void six_points_at_given_angles_are_met_as_well_as_published(void **state)
{
    (void)state;
    Answer a = answer_to("synthesis: path\npoints: [[0, 0], [1.9098, 5.8779], [6.9098, 9.5106], [13.09, 9.5106],\n"
                         "  [18.09, 5.8779], [20, 0]]\nbest: 3\n"
                         "angles: [30 deg, 60 deg, 90 deg, 120 deg, 150 deg, 180 deg]\n"
                         "bounds: {lengths: [5, 50], coupler_point: [-50, 50], pivots: [[-50, -50], [50, 50]]}\n");
    YkCandidate c = yk_synthesis_candidate(a.synthesis, 0);
    assert_true(c.error <= 2.5803559);
    for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++)
        for (size_t i = 0; i < 6; i++)
            CHECK_NEAR(yk_synthesis_angles(a.synthesis, k, NULL)[i], (double)(i + 1) * YK_PI / 6, 1e-15);
    check_all(&a, arc, 6);
    answer_free(&a);
}

// The publications count the angles from the ground link, whose direction is free.
static void six_points_at_angles_from_the_ground_are_met_as_well_as_published(void **state)
{
    (void)state;
    Answer a = {.task = yk_task_load(YOKE_ROOT "/examples/tasks/arc-at-angles-from-ground.yaml", NULL)};
    a.synthesis = yk_synthesis_run(a.task, NULL, NULL);
    assert_non_null(a.synthesis);
    YkCandidate c = yk_synthesis_candidate(a.synthesis, 0);
    assert_true(c.error * 1e6 <= 2.5803559); // mm
    for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
        c = yk_synthesis_candidate(a.synthesis, k);
        double ground = yk_atan2(c.pivots[1][1] - c.pivots[0][1], c.pivots[1][0] - c.pivots[0][0]);
        for (size_t i = 0; i < 6; i++) {
            double angle = yk_synthesis_angles(a.synthesis, k, NULL)[i] - ground;
            CHECK_NEAR(yk_remainder(angle - (double)(i + 1) * YK_PI / 6, 2 * YK_PI), 0, 1e-11);
        }
    }
    answer_free(&a);
}

static void ten_points_of_an_oval_are_met_as_well_as_published(void **state)
{
    (void)state;
    Answer a =
        answer_to("synthesis: path\npoints: [[20, 10], [17.66, 15.142], [11.736, 17.878], [5, 16.928],\n"
                  "  [.60307, 12.736], [.60307, 7.2638], [5, 3.0718], [11.736, 2.1215], [17.66, 4.8577], [20, 10]]\n"
                  "best: 2\nbounds: {lengths: [5, 80], coupler_point: [-80, 80], pivots: [[-80, -80], [80, 80]]}\n");
    assert_true(yk_synthesis_candidate(a.synthesis, 0).error < 4.019925e-4);
    check_all(&a, oval, 10);
    answer_free(&a);
}

// --- machines found again

// Points of a four-bar's coupler by the law of cosines: ground 3.2, input 1, coupler 3, output 2.5, turned and moved.
static void trace(YkVec *point, size_t count, double from, double span)
{
    YkVec place = yk_vec(3, 4), turn = yk_unit(0.4), arm = yk_vec(1.5, 1.2);
    for (size_t k = 0; k < count; k++) {
        YkVec A = yk_unit(from + span * (double)k), D = yk_sub(yk_vec(3.2, 0), A);
        double d = yk_norm(D), angle = yk_acos((d * d + 9 - 6.25) / (6 * d));
        YkVec u = yk_mul(yk_scale(1 / d, D), yk_unit(angle));
        point[k] = yk_add(place, yk_mul(turn, yk_add(A, yk_mul(arm, u))));
    }
}

static size_t write_points(char *text, size_t size, const YkVec *point, size_t count)
{
    size_t at = (size_t)snprintf(text, size, "synthesis: path\npoints:\n");
    for (size_t k = 0; k < count; k++)
        at += (size_t)snprintf(text + at, size - at, "  - [%.17g, %.17g]\n", point[k].x, point[k].y);
    return at;
}

static bool is_the_bar(const YkCandidate *c)
{
    static const double length[] = {3.2, 1, 3, 2.5};
    for (size_t i = 0; i < 4; i++)
        if (fabs(c->lengths[i] - length[i]) > 1e-8) return false;
    return fabs(c->pivots[0][0] - 3) < 1e-8 && fabs(c->pivots[0][1] - 4) < 1e-8;
}

static void a_closed_curve_gives_its_four_bar_and_the_cognate_with_a_crank(void **state)
{
    (void)state;
    YkVec point[60];
    char text[6000];
    trace(point, 60, 0.1, 2 * YK_PI / 60);
    size_t at = write_points(text, sizeof text, point, 60);
    snprintf(text + at, sizeof text - at, "closed: true\nbest: 2\n");
    Answer a = answer_to(text);
    assert_int_equal(yk_synthesis_count(a.synthesis), 2);
    YkCandidate c[2] = {yk_synthesis_candidate(a.synthesis, 0), yk_synthesis_candidate(a.synthesis, 1)};
    assert_true(c[0].error < 1e-20 && c[1].error < 1e-20);
    assert_true(is_the_bar(&c[0]) != is_the_bar(&c[1]));
    check_all(&a, point, 60);
    answer_free(&a);
}

static void given_angles_give_the_one_four_bar_that_has_them(void **state)
{
    (void)state;
    YkVec point[9];
    char text[2000];
    trace(point, 9, 0.2, 0.3);
    size_t at = write_points(text, sizeof text, point, 9);
    at += (size_t)snprintf(text + at, sizeof text - at, "best: 1\nangles: [");
    for (size_t k = 0; k < 9; k++)
        at += (size_t)snprintf(text + at, sizeof text - at, "%s%.17g", k ? ", " : "", 0.4 + 0.2 + 0.3 * (double)k);
    snprintf(text + at, sizeof text - at, "]\n");
    Answer a = answer_to(text);
    YkCandidate c = yk_synthesis_candidate(a.synthesis, 0);
    assert_true(c.error < 1e-20 && is_the_bar(&c));
    answer_free(&a);
    // The same bar, whose ground has a direction of 0.4 rad.
    at = write_points(text, sizeof text, point, 9);
    at += (size_t)snprintf(text + at, sizeof text - at, "best: 1\nangles_from: ground\nangles: [");
    for (size_t k = 0; k < 9; k++)
        at += (size_t)snprintf(text + at, sizeof text - at, "%s%.17g", k ? ", " : "", 0.2 + 0.3 * (double)k);
    snprintf(text + at, sizeof text - at, "]\n");
    a = answer_to(text);
    c = yk_synthesis_candidate(a.synthesis, 0);
    assert_true(c.error < 1e-20 && is_the_bar(&c));
    answer_free(&a);
    at = write_points(text, sizeof text, point, 9);
    snprintf(text + at, sizeof text - at, "best: 2\nangles: {from: free, step: 0.3}\n");
    a = answer_to(text);
    c = yk_synthesis_candidate(a.synthesis, 0);
    YkCandidate other = yk_synthesis_candidate(a.synthesis, 1);
    assert_true(c.error < 1e-20 && (is_the_bar(&c) || is_the_bar(&other)));
    answer_free(&a);
}

static void slider_cranks_are_found_and_measured(void **state)
{
    (void)state;
    static const YkVec point[] = {{0, 0}, {10, 4}, {20, 6}, {30, 5}, {40, 1}};
    Answer a = answer_to("synthesis: path\npoints: [[0, 0], [10, 4], [20, 6], [30, 5], [40, 1]]\nbest: 3\n"
                         "mechanisms: [slider-crank]\n");
    assert_int_equal(yk_synthesis_count(a.synthesis), 3);
    for (size_t k = 0; k < 3; k++)
        assert_string_equal(yk_synthesis_candidate(a.synthesis, k).mechanism, "slider-crank");
    check_all(&a, point, 5);
    answer_free(&a);
}

// --- what is given and required

static void what_is_fixed_and_required_holds(void **state)
{
    (void)state;
    Answer a = answer_to("synthesis: path\npoints: [[0, 0], [10, 4], [20, 6], [30, 5], [40, 1]]\nbest: 3\n"
                         "fix: {input_pivot: [0, -30], ground_angle: 10 deg}\nbounds: {lengths: [5, 100]}\n"
                         "require: {input: turns, transmission: 40 deg, size_ratio: 8}\n");
    assert_true(yk_synthesis_count(a.synthesis) > 0);
    for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
        YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
        const double *l = c.lengths;
        CHECK_NEAR(c.pivots[0][0], 0, 1e-12);
        CHECK_NEAR(c.pivots[0][1], -30, 1e-12);
        CHECK_NEAR(atan2(c.pivots[1][1] + 30, c.pivots[1][0]), 10 * YK_PI / 180, 1e-12);
        for (int end = -1; end <= 1; end += 2) { // the extreme transmission angles by the law of cosines
            double d = l[0] + end * l[1], cosine = (l[2] * l[2] + l[3] * l[3] - d * d) / (2 * l[2] * l[3]);
            assert_true(fabs(cosine) <= cos(40 * YK_PI / 180) + 1e-9);
        }
        double least = fmin(fmin(l[0], l[1]), fmin(l[2], l[3])), most = fmax(fmax(l[0], l[1]), fmax(l[2], l[3]));
        assert_true(most <= 8 * least * (1 + 1e-9));
    }
    answer_free(&a);
    a = answer_to("synthesis: path\npoints: [[0, 0], [10, 4], [20, 6], [30, 5], [40, 1]]\nbest: 2\n"
                  "fix: {output_pivot: [50, -30]}\nbounds: {pivots: [[-60, -60], [60, 40]]}\n");
    assert_true(yk_synthesis_count(a.synthesis) > 0); // the box is for the other pivot
    for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
        YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
        CHECK_NEAR(c.pivots[1][0], 50, 1e-9);
        CHECK_NEAR(c.pivots[1][1], -30, 1e-9);
        CHECK_NEAR(c.pivots[0][0], 0, 60 + 1e-4);
        CHECK_NEAR(c.pivots[0][1], -10, 50 + 1e-4);
    }
    answer_free(&a);
}

static void angles_go_on_within_a_turn_unless_any_order_will_do(void **state)
{
    (void)state;
    static const char text[] = "synthesis: path\npoints: [[0, 0], [20, 6], [10, 4], [30, 5], [40, 1]]\nbest: 5\n";
    char free_order[200];
    Answer a = answer_to(text);
    for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
        const double *angle = yk_synthesis_angles(a.synthesis, k, NULL);
        double whole = angle[4] - angle[0];
        for (size_t i = 1; i < 5; i++) assert_true((angle[i] - angle[i - 1]) * whole > 0);
        assert_true(fabs(whole) <= 2 * YK_PI + 1e-6);
    }
    answer_free(&a);
    snprintf(free_order, sizeof free_order, "%srequire: {order: false}\n", text);
    a = answer_to(free_order);
    assert_true(yk_synthesis_candidate(a.synthesis, 0).error < 1e-20);
    answer_free(&a);
}

static bool some_batches(void *context, double part)
{
    (void)part;
    size_t *left = context;
    return (*left)-- > 1;
}

static void a_search_that_is_stopped_keeps_its_best(void **state)
{
    (void)state;
    size_t left = 12;
    YkSynthesisOptions options = yk_default_synthesis_options();
    options.progress = (YkProgress){some_batches, &left};
    Answer a = answer_with(
        "synthesis: path\npoints: [[0, 0], [10, 4], [20, 6], [30, 5], [40, 1], [35, -3], [30, -4], [22, -3],\n"
        "  [15, -2], [8, -1], [2, -1]]\nclosed: true\n",
        &options);
    assert_true(yk_synthesis_was_stopped(a.synthesis));
    assert_false(yk_synthesis_is_complete(a.synthesis));
    assert_true(yk_synthesis_count(a.synthesis) > 0);
    answer_free(&a);
}

enum { TOLD = 400 };
typedef struct Told {
    char *best[TOLD]; // the list of a caller that puts each machine into the place that it is told
    double error[TOLD];
    size_t count, calls;
} Told;

static void hear(void *context, const YkCandidate *c, size_t place, size_t best)
{
    Told *told = context;
    assert_int_equal(best, 4);
    assert_true(place < best && place <= told->count && told->count < TOLD);
    for (size_t k = told->count++; k > place; k--)
        told->best[k] = told->best[k - 1], told->error[k] = told->error[k - 1];
    told->best[place] = copy_of(c->model);
    told->error[place] = c->error;
    told->calls++;
}

static void what_is_found_is_told_while_the_search_runs(void **state)
{
    (void)state;
    check_without_sanitizers();
    YkSynthesisOptions options = yk_default_synthesis_options();
    Told told = {.count = 0};
    options.best = 4;
    static const char text[] =
        "synthesis: path\nmechanisms: [slider-crank]\npoints: [[0, 0], [10, 4], [20, 6], [30, 5], "
        "[40, 1], [35, -3], [30, -4], [22, -3], [15, -2], [8, -1], [2, -1]]\nclosed: true\n";
    Answer unheard = answer_with(text, &options);
    options.findings = (YkFindings){hear, &told};
    Answer heard = answer_with(text, &options);
    size_t count = yk_synthesis_count(heard.synthesis);
    assert_true(told.calls > count);
    for (size_t k = 1; k < told.count; k++) assert_true(told.error[k - 1] <= told.error[k]);
    assert_int_equal(yk_synthesis_count(unheard.synthesis), count);
    for (size_t k = 0; k < count; k++) // hearing changes nothing
        assert_string_equal(yk_synthesis_candidate(heard.synthesis, k).model,
                            yk_synthesis_candidate(unheard.synthesis, k).model);
    assert_string_equal(told.best[0], yk_synthesis_candidate(heard.synthesis, 0).model);
    for (size_t k = 0; k < told.count; k++) free(told.best[k]);
    answer_free(&unheard);
    answer_free(&heard);
}

static void a_seed_determines_the_answer(void **state)
{
    (void)state;
    YkSynthesisOptions options = yk_default_synthesis_options();
    static const char text[] = "synthesis: path\npoints: [[0, 0], [10, 4], [20, 6], [30, 5], [40, 1]]\nbest: 3\n";
    Answer a = answer_with(text, &options), b = answer_with(text, &options);
    options.seed = 2;
    Answer other = answer_with(text, &options);
    for (size_t k = 0; k < 3; k++)
        assert_string_equal(yk_synthesis_candidate(a.synthesis, k).model, yk_synthesis_candidate(b.synthesis, k).model);
    assert_string_not_equal(yk_synthesis_candidate(a.synthesis, 0).model,
                            yk_synthesis_candidate(other.synthesis, 0).model);
    answer_free(&a);
    answer_free(&b);
    answer_free(&other);
}

// --- derivatives

// The derivative of f at 0 from four values about it: the error falls with the fourth power of h.
static double derivative(const double value[4], double h)
{
    return (8 * (value[2] - value[1]) - (value[3] - value[0])) / (12 * h);
}

static void derivatives_agree_with_differences(void **state)
{
    (void)state;
    static const double offset[] = {-2, -1, 1, 2};
    const double h = 1e-3;
    uint64_t seed = 7;
    size_t tried[YK_DESIGN_KINDS] = {0};
    for (size_t k = 0; k < 400 * YK_DESIGN_KINDS; k++) {
        YkBar bar = {.kind = (YkDesignKind)(k % YK_DESIGN_KINDS), .branch = k & 8 ? 1 : -1, .bend = k & 16 ? 1 : -1};
        size_t variants = yk_chain_variants(bar.kind), size = yk_bar_size(bar.kind);
        bar.hangs_at_end = bar.kind != YK_DESIGN_SLIDER_CRANK && k & 32;
        bar.variant = variants ? (int)(yk_mix_next(&seed) % variants) : 0;
        for (size_t j = 0; j < YK_BAR_SIZE; j++) bar.v[j] = 1 + 2 * yk_mix_unit(&seed);
        double input = 6 * yk_mix_unit(&seed);
        YkBarPoint p, near;
        if (!yk_bar_point(&bar, input, &p) || yk_norm(p.by_input) > 5) continue; // not beside a dead point
        bool good = true;
        for (size_t j = 0; j <= size && good; j++) {
            double x[4], y[4];
            for (size_t i = 0; i < 4 && good; i++) {
                YkBar moved = bar;
                double turned = input + (j == size ? offset[i] * h : 0);
                if (j < size) moved.v[j] += offset[i] * h;
                good = yk_bar_point(&moved, turned, &near);
                x[i] = near.at.x;
                y[i] = near.at.y;
            }
            if (!good) break;
            YkVec by = j == size ? p.by_input : p.by[j];
            double scale = yk_norm(p.by_input) + yk_norm(by) + 1;
            CHECK_NEAR(derivative(x, h), by.x, 1e-6 * scale * scale * scale);
            CHECK_NEAR(derivative(y, h), by.y, 1e-6 * scale * scale * scale);
            tried[bar.kind]++;
        }
    }
    for (size_t kind = 0; kind < YK_DESIGN_KINDS; kind++) assert_true(tried[kind] > 500);
}

static void limits_agree_with_differences(void **state)
{
    (void)state;
    static const char text[] = "synthesis: path\npoints: [[0, 0], [10, 4]]\nbounds: {pivots: [[-5, -6], [7, 8]]}\n"
                               "require: {input: turns, transmission: 40 deg, size_ratio: 3}\n";
    static const double offset[] = {-2, -1, 1, 2};
    YkTask *task = yk_task_parse(text, strlen(text), "test.yaml", NULL);
    YkPathProblem problem = {.task = task, .has_box = true, .turns = true, .low = {-5, -6}, .high = {7, 8}};
    uint64_t seed = 3;
    const double h = 1e-3;
    assert_non_null(task);
    for (size_t k = 0; k < 100; k++) {
        YkBar bar = {.kind = k & 1 ? YK_DESIGN_SLIDER_CRANK : YK_DESIGN_FOUR_BAR, .hangs_at_end = (k & 2) != 0};
        double excess[YK_PATH_LIMITS], by[YK_PATH_LIMITS][YK_BAR_SIZE];
        double moved[4][YK_PATH_LIMITS], none[YK_PATH_LIMITS][YK_BAR_SIZE];
        for (size_t j = 0; j < YK_BAR_SIZE; j++) bar.v[j] = 1 + 0.1 * (double)j + 2 * yk_mix_unit(&seed);
        size_t count = yk_path_limits(&problem, &bar, excess, by);
        assert_int_equal(count, k & 1 ? 2 : 10);
        for (int side = -1; side <= 1 && !(k & 1); side += 2) { // the links' angle where input and ground are in line
            double b = bar.v[YK_BAR_COUPLER], c = bar.v[YK_BAR_OUTPUT],
                   d = bar.v[YK_BAR_GROUND] - side * bar.v[YK_BAR_INPUT];
            double cosine = (b * b + c * c - d * d) / (2 * b * c), most = cos(40 * YK_PI / 180);
            CHECK_NEAR(excess[side < 0 ? 8 : 9], 2 * b * c / (b + c) * (fabs(cosine) - most), 1e-12);
        }
        for (size_t j = 0; j < YK_BAR_SIZE; j++) {
            for (size_t i = 0; i < 4; i++) {
                YkBar other = bar;
                other.v[j] += offset[i] * h;
                yk_path_limits(&problem, &other, moved[i], none);
            }
            for (size_t r = 0; r < count; r++) {
                double value[4] = {moved[0][r], moved[1][r], moved[2][r], moved[3][r]};
                bool has_kink = fabs(value[3] - 2 * excess[r] + value[0]) > 1e-3; // another link became the shortest
                if (!has_kink) CHECK_NEAR(derivative(value, h), by[r][j], 1e-8);
            }
        }
    }
    yk_task_free(task);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(six_points_of_a_line_are_met_to_rounding),
        cmocka_unit_test(six_points_at_given_angles_are_met_as_well_as_published),
        cmocka_unit_test(six_points_at_angles_from_the_ground_are_met_as_well_as_published),
        cmocka_unit_test(ten_points_of_an_oval_are_met_as_well_as_published),
        cmocka_unit_test(a_closed_curve_gives_its_four_bar_and_the_cognate_with_a_crank),
        cmocka_unit_test(given_angles_give_the_one_four_bar_that_has_them),
        cmocka_unit_test(slider_cranks_are_found_and_measured),
        cmocka_unit_test(what_is_fixed_and_required_holds),
        cmocka_unit_test(angles_go_on_within_a_turn_unless_any_order_will_do),
        cmocka_unit_test(a_search_that_is_stopped_keeps_its_best),
        cmocka_unit_test(what_is_found_is_told_while_the_search_runs),
        cmocka_unit_test(a_seed_determines_the_answer),
        cmocka_unit_test(derivatives_agree_with_differences),
        cmocka_unit_test(limits_agree_with_differences),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
