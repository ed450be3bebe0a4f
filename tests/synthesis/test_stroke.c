// Crank-rockers and slider-cranks by their dead centres, against closed forms and the engine's own strokes.
#include "synthesis/answer.h"
#include "base/vec.h"

#define DEG (YK_PI / 180)

static YkStroke stroke_of(const char *model, const char *channel)
{
    Standing s = standing(model);
    YkChannel c;
    YkStroke stroke;
    assert_int_equal(yk_channel_parse(s.mech, channel, &c, NULL), YK_OK);
    assert_int_equal(yk_stroke(s.state, 0, c, &stroke), YK_OK);
    standing_free(&s);
    return stroke;
}

// The coupler that belongs to a crank: b^2 = (chord^2 - 2 a^2 (1 + cos alpha)) / (2 (1 - cos alpha)).
static double coupler_of(double a, double chord, double alpha)
{
    return sqrt((chord * chord - 2 * a * a * (1 + cos(alpha))) / (2 * (1 - cos(alpha))));
}

// The best transmission angle of all slider-cranks with a stroke of 1, over a grid of cranks.
static double best_slider(double alpha)
{
    double best = 0;
    for (double a = .001; a < .5; a += 1e-5) {
        double b = coupler_of(a, 1, alpha), offset = (b * b - a * a) * sin(alpha);
        if (!(a + offset < b) || 2 * a * b < .5) continue; // both ends on one side of the pivot
        best = fmax(best, acos((a + offset) / b));
    }
    return best;
}

static void slider_cranks_have_their_stroke_and_the_best_transmission(void **state)
{
    (void)state;
    static const double ratios[] = {1.05, 1.1, 1.2, 1.5, 1.9};
    for (size_t k = 0; k < 5; k++) {
        char text[200];
        snprintf(text, sizeof text, "synthesis: stroke\nstroke: 80 mm\ntime_ratio: %g\n", ratios[k]);
        Answer a = answer_to(text);
        assert_int_equal(yk_synthesis_count(a.synthesis), 1);
        YkCandidate c = yk_synthesis_candidate(a.synthesis, 0);
        YkStroke stroke = stroke_of(c.model, "s");
        CHECK_NEAR(stroke.high - stroke.low, .08, 1e-11);
        CHECK_NEAR(stroke.ratio, ratios[k], 1e-6);
        double best = best_slider(YK_PI * (ratios[k] - 1) / (ratios[k] + 1));
        CHECK_NEAR(c.transmission[0], best, 2e-8); // of a grid
        answer_free(&a);
    }
}

// The best of all crank-rockers with a rocker of 1: cranks on a grid, and the pivot on either side of the chord.
static double best_rocker(double swing, double alpha)
{
    double half = sin(swing / 2), height = cos(swing / 2), best = 0;
    for (double a = .001; a < half; a += 1e-4)
        for (int side = -1; side <= 1; side += 2) {
            double b = coupler_of(a, 2 * half, alpha), near_end = b - a, far_end = b + a, least = INFINITY;
            double x = (near_end * near_end - far_end * far_end) / (4 * half),
                   y2 = near_end * near_end - (x + half) * (x + half);
            if (!(b > a) || !(y2 > 0)) continue;
            double g = hypot(x, height + side * sqrt(y2)), most = fmax(fmax(g, b), 1);
            if (a > fmin(fmin(g, b), 1) || a + most > g + b + 1 - most) continue; // no crank-rocker
            YkVec A0 = {x, height + side * sqrt(y2)}, B1 = {-half, height}, B2 = {half, height};
            if (yk_cross(A0, B1) * yk_cross(A0, B2) < 0) continue; // two assemblies
            for (int end = -1; end <= 1; end += 2) {
                double across = g + end * a, cosine = (b * b + 1 - across * across) / (2 * b);
                least = fmin(least, acos(fmin(fabs(cosine), 1)));
            }
            best = fmax(best, least);
        }
    return best;
}

static void crank_rockers_have_their_swing_and_the_best_transmission(void **state)
{
    (void)state;
    static const double cases[][2] = {{40, 1.2}, {60, 1.1}, {90, 1.05}, {30, 1.5}, {75, 1.3}};
    for (size_t k = 0; k < 5; k++) {
        char text[200];
        snprintf(text, sizeof text, "synthesis: stroke\nswing: %g deg\ntime_ratio: %g\nfix: {output: 80 mm}\n",
                 cases[k][0], cases[k][1]);
        Answer a = answer_to(text);
        assert_true(yk_synthesis_count(a.synthesis) >= 1);
        for (size_t i = 0; i < yk_synthesis_count(a.synthesis); i++) {
            YkCandidate c = yk_synthesis_candidate(a.synthesis, i);
            YkStroke stroke = stroke_of(c.model, "psi");
            CHECK_NEAR(stroke.high - stroke.low, cases[k][0] * DEG, 1e-9);
            CHECK_NEAR(stroke.ratio, cases[k][1], 1e-6);
            CHECK_NEAR(c.lengths[3], .08, 1e-13);
            assert_string_equal(c.type, "crank-rocker");
        }
        double best = best_rocker(cases[k][0] * DEG, YK_PI * (cases[k][1] - 1) / (cases[k][1] + 1));
        CHECK_NEAR(yk_synthesis_candidate(a.synthesis, 0).transmission[0], best, 1e-4);
        answer_free(&a);
    }
}

static void without_a_quick_return_the_crank_rocker_is_central(void **state)
{
    (void)state;
    Answer a = answer_to("synthesis: stroke\nswing: 50 deg\nfix: {ground: 1}\n");
    assert_true(yk_synthesis_count(a.synthesis) >= 1);
    YkCandidate c = yk_synthesis_candidate(a.synthesis, 0);
    const double *l = c.lengths;
    CHECK_NEAR(l[1] * l[1] + l[0] * l[0], l[2] * l[2] + l[3] * l[3], 1e-9); // the dead centres lie half a turn apart
    CHECK_NEAR(l[1], l[3] * sin(25 * DEG), 1e-9);
    YkStroke stroke = stroke_of(c.model, "psi");
    CHECK_NEAR(stroke.ratio, 1, 1e-9);
    answer_free(&a);
    a = answer_to("synthesis: stroke\nstroke: 100 mm\nbounds: {lengths: [10 mm, 200 mm]}\n");
    c = yk_synthesis_candidate(a.synthesis, 0);
    CHECK_NEAR(c.lengths[1], .05, 1e-15);
    CHECK_NEAR(c.lengths[2], .2, 1e-15);
    CHECK_NEAR(c.transmission[0], acos(.25), 1e-9);
    answer_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slider_cranks_have_their_stroke_and_the_best_transmission),
        cmocka_unit_test(crank_rockers_have_their_swing_and_the_best_transmission),
        cmocka_unit_test(without_a_quick_return_the_crank_rocker_is_central),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
