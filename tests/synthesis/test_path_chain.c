// Curves of six-bars, geared five-bars and inverted slider-cranks: made by complex numbers alone, found again, and
// driven by the engine on the written file.
#include "synthesis/answer.h"
#include <complex.h>
#include "base/mix.h"
#include "synthesis/paths/path_search.h"

enum { POINTS = 60, FINE = 360 };
typedef double complex Complex;

// Where links of lengths r and q from p and s meet, or NaN near a dead point.
static Complex meet(Complex p, Complex s, double r, double q, int branch)
{
    Complex D = s - p;
    double d = cabs(D), c = (d * d + r * r - q * q) / (2 * r * d);
    return fabs(c) > 0.995 ? (double)NAN : p + r * D / d * (c + branch * I * sqrt(1 - c * c));
}

static Complex anywhere(uint64_t *seed)
{
    double x = check_uniform(seed, -4, 4);
    return x + I * check_uniform(seed, -4, 4);
}

static int either(uint64_t *seed)
{
    return check_uniform(seed, -1, 1) < 0 ? -1 : 1;
}

typedef enum Kind { WATT, STEPHENSON_III, STEPHENSON_I } Kind;

// A random curve of a six-bar whose crank turns through. Returns false if it does not close all round.
static bool draw(Kind kind, uint64_t *seed, Complex curve[FINE])
{
    double g = check_uniform(seed, 1.2, 5), b = check_uniform(seed, 1.2, 5), c = check_uniform(seed, 1.2, 5);
    double r = check_uniform(seed, 1, 6), q = check_uniform(seed, 1, 6);
    Complex x = anywhere(seed), y = anywhere(seed), w = anywhere(seed), at = anywhere(seed);
    int branch = either(seed), bend = either(seed);
    for (int k = 0; k < FINE; k++) {
        Complex A = cexp(I * (2 * YK_PI * k / FINE + 0.3)), B = meet(A, g, b, c, branch);
        Complex u = (B - A) / b, v = (B - g) / c;
        Complex C = kind == STEPHENSON_I ? x * A : A + x * u, D = kind == STEPHENSON_III ? y : g + y * v;
        Complex E = meet(C, D, r, q, bend);
        curve[k] = at + (C + w * (E - C) / r) * cexp(1.1 * I);
        if (isnan(creal(curve[k])) || (k > 0 && cabs(curve[k] - curve[k - 1]) > 0.8)) return false;
    }
    return true;
}

static double write_task(const Complex *curve, size_t count, size_t stride, const char *mechanisms, YkText *text)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    yk_text_format(text, "synthesis: path\nclosed: true\nbest: 1\nmechanisms: [%s]\npoints:\n", mechanisms);
    for (size_t k = 0; k < count; k++) {
        const double xy[] = {creal(curve[k * stride]), cimag(curve[k * stride])};
        char line[100];
        snprintf(line, sizeof line, "- [%.15g, %.15g]\n", xy[0], xy[1]);
        yk_text_puts(text, line);
        for (int i = 0; i < 2; i++) {
            low[i] = fmin(low[i], xy[i]);
            high[i] = fmax(high[i], xy[i]);
        }
    }
    return hypot(high[0] - low[0], high[1] - low[1]);
}

// Returns the root mean square distance, over the size of the curve, of the best that a number of batches finds.
static double found_by_batches(const YkText *text, double size, size_t batches)
{
    static const YkDesignKind kinds[] = {YK_DESIGN_WATT, YK_DESIGN_STEPHENSON};
    YkTask *task = yk_task_parse(yk_text_get(text), text->length, "test.yaml", NULL);
    YkArena *arena = yk_arena_new();
    YkPathBatches *of[2];
    double best = INFINITY;
    assert_non_null(task);
    for (size_t k = 0; k < 2; k++) {
        of[k] = calloc(1, sizeof *of[k]);
        assert_true(yk_path_batches_new(arena, task, kinds[k], 1, of[k]));
    }
    for (size_t k = 0; k < 2 * batches && !(best < 1e-3); k++)
        if (yk_path_batch(of[k % 2], k / 2)) best = fmin(best, sqrt(of[k % 2]->whole.error / POINTS) / size);
    for (size_t k = 0; k < 2; k++) free(of[k]);
    yk_arena_free(arena);
    yk_task_free(task);
    return best;
}

// A batch takes some 40 ms; 100 curves need 2 on the mean, and 99 of them less than 30.
static void curves_of_random_six_bars_are_found_again(void **state)
{
    (void)state;
    uint64_t seed = 77;
    size_t found = 0, count = getenv("YOKE_FULL") ? 100 : check_cases(5);
    for (size_t k = 0; k < count; k++) {
        Complex curve[FINE];
        YkText text = {0};
        while (!draw((Kind)(k % 3), &seed, curve)) {}
        double size = write_task(curve, POINTS, FINE / POINTS, "watt, stephenson", &text);
        found += found_by_batches(&text, size, 40) < 1e-3;
        yk_text_free(&text);
    }
    assert_true(10 * found >= 8 * count);
}

static bool go_on(void *context, double part)
{
    return part <= *(const double *)context;
}

// Runs a search as far as a part of it, and returns the best candidate's error, measured by the engine.
static double error_of(const YkText *text, double part, const char *mechanism, const char *last)
{
    YkSynthesisOptions options = yk_default_synthesis_options();
    options.progress = (YkProgress){.goes_on = go_on, .context = &part};
    Answer a = answer_with(yk_text_get(text), &options);
    assert_true(yk_synthesis_count(a.synthesis) > 0);
    YkCandidate c = yk_synthesis_candidate(a.synthesis, 0);
    if (mechanism) assert_string_equal(c.mechanism, mechanism);
    size_t names = 0;
    const char *name = NULL;
    for (const char *next; (next = yk_synthesis_parameter(a.synthesis, 0, names, NULL)) != NULL; names++) name = next;
    if (last) assert_string_equal(name, last);
    for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) check_parameters(a.synthesis, k);
    assert_non_null(yk_synthesis_picture(a.synthesis));
    double error = c.error;
    answer_free(&a);
    return error;
}

static void a_geared_five_bar_is_found_again(void **state)
{
    (void)state;
    Complex curve[40];
    YkText text = {0};
    for (int k = 0; k < 40; k++) {
        double t = 2 * YK_PI * k / 40 + 0.3;
        Complex A = 20 * cexp(I * t), E = meet(A, 60 + 25 * cexp(I * (0.7 - 2 * t)), 55, 50, 1);
        curve[k] = A + (60 + 15 * I) * (E - A) / 55;
    }
    write_task(curve, 40, 1, "geared-five-bar", &text);
    CHECK_NEAR(error_of(&text, 1, "geared-five-bar", "m"), 0, 1e-16);
    yk_text_free(&text);
}

static void an_inverted_slider_crank_is_found_again(void **state)
{
    (void)state;
    Complex curve[40];
    YkText text = {0};
    for (int k = 0; k < 40; k++) {
        Complex A = 20 * cexp(I * (2 * YK_PI * k / 40 + 0.3)), D = 70 - A;
        double e = 6, s = sqrt(cabs(D) * cabs(D) - e * e);
        curve[k] = A + (95 + 12 * I) * D / (s + I * e);
    }
    write_task(curve, 40, 1, "inverted-slider-crank", &text);
    CHECK_NEAR(error_of(&text, 1, "inverted-slider-crank", "py"), 0, 1e-16);
    yk_text_free(&text);
}

// An oval with three bumps and some noise: six-bars come nearer than four-bars, and all kinds are looked at soon.
static void a_curve_drawn_by_hand_gets_the_best_of_all_kinds(void **state)
{
    (void)state;
    Complex curve[48];
    uint64_t seed = 5;
    YkText all = {0}, simple = {0};
    for (int k = 0; k < 48; k++) {
        double t = 2 * YK_PI * k / 48, r = 40 + 9 * cos(2 * t + .4) + 6 * sin(3 * t);
        double off = check_uniform(&seed, -.5, .5), aside = check_uniform(&seed, -.5, .5);
        curve[k] = r * (1.3 * cos(t) + I * sin(t)) + off + I * aside;
    }
    write_task(curve, 48, 1, "all", &all);
    write_task(curve, 48, 1, "four-bar", &simple);
    double best = error_of(&all, 0.005, NULL, NULL), least = error_of(&simple, 0.02, "four-bar", NULL);
    assert_true(best < 0.5 * least);
    assert_true(sqrt(best / 48) < 0.03 * 100); // of a curve that is 100 wide
    yk_text_free(&all);
    yk_text_free(&simple);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(curves_of_random_six_bars_are_found_again),
        cmocka_unit_test(a_geared_five_bar_is_found_again),
        cmocka_unit_test(an_inverted_slider_crank_is_found_again),
        cmocka_unit_test(a_curve_drawn_by_hand_gets_the_best_of_all_kinds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
