// Sliders that follow an angle: the machine from which the pairs come, Freudenstein's equation, errors by the closed
// form.
#include "synthesis/answer.h"
#include <math.h>
#include "base/vec.h"

#define DEG (YK_PI / 180)

// A slider-crank at an input angle: how far the slider is along its line.
typedef struct Slider {
    double crank, coupler, offset, sense;
} Slider;

static double place(const Slider *m, double phi)
{
    double y = m->offset - m->crank * sin(phi);
    return m->crank * cos(phi) + m->sense * sqrt(m->coupler * m->coupler - y * y);
}

static const Slider own = {0.04, 0.11, 0.015, 1};
static const double phi0 = 50 * DEG, turn[5] = {0, 17 * DEG, 40 * DEG, 66 * DEG, 90 * DEG};

static void add_pairs(char *text, size_t size, const Slider *m, size_t count)
{
    size_t at = strlen(text);
    at += (size_t)snprintf(text + at, size - at, "pairs: [");
    for (size_t k = 0; k < count; k++)
        at += (size_t)snprintf(text + at, size - at, "%s[%.17g rad, %.17g m]", k > 0 ? ", " : "", turn[k],
                               place(m, phi0 + turn[k]) - place(m, phi0));
    snprintf(text + at, size - at, "]\n");
}

// What a candidate's file says of the machine: offset, place and angle at the start.
typedef struct Found {
    Slider m;
    double phi, s;
} Found;

static Found read_candidate(const YkCandidate *c)
{
    Standing stands = standing(c->model);
    double x1 = yk_model_parameter(stands.model, "x1"), y1 = yk_model_parameter(stands.model, "y1");
    Found f = {.m = {c->lengths[1], c->lengths[2], yk_model_parameter(stands.model, "y2") - y1, 1}};
    assert_true(x1 == 0 && yk_model_parameter(stands.model, "x2") == 0);
    f.phi = yk_state_coordinate(stands.state, yk_coordinate_find(stands.mech, "theta")).position;
    f.s = yk_state_coordinate(stands.state, yk_coordinate_find(stands.mech, "s")).position;
    if (f.s < f.m.crank * cos(f.phi)) f.m.sense = -1;
    standing_free(&stands);
    return f;
}

// Every candidate closes at all pairs, by Freudenstein's equation for sliders, and one is the machine they come from.
static void pairs_of_a_slider_crank_give_it_back(void **state)
{
    (void)state;
    static const char *const fix[3] = {"fix: {input_start: 50 deg, output_start: %.17g m}\n",
                                       "fix: {input_start: 50 deg}\n", ""};
    for (size_t count = 3; count <= 5; count++) {
        char text[1000];
        snprintf(text, sizeof text, "synthesis: function\nmechanisms: [slider-crank]\n");
        snprintf(text + strlen(text), sizeof text - strlen(text), fix[count - 3], place(&own, phi0));
        add_pairs(text, sizeof text, &own, count);
        Answer a = answer_to(text);
        size_t seen = 0;
        assert_true(yk_synthesis_is_complete(a.synthesis));
        assert_true(yk_synthesis_count(a.synthesis) > 0);
        for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
            YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
            Found f = read_candidate(&c);
            assert_string_equal(c.mechanism, "slider-crank");
            assert_true(c.error < 1e-18);
            for (size_t i = 0; i < count; i++) {
                double s = f.s + place(&own, phi0 + turn[i]) - place(&own, phi0), phi = f.phi + turn[i];
                double right = 2 * f.m.crank * (s * cos(phi) + f.m.offset * sin(phi)) - f.m.crank * f.m.crank -
                               f.m.offset * f.m.offset + f.m.coupler * f.m.coupler;
                CHECK_NEAR(s * s, right, 1e-9 * (s * s + f.m.coupler * f.m.coupler));
            }
            bool is_own = fabs(f.m.crank - own.crank) < 1e-8 && fabs(f.m.coupler - own.coupler) < 1e-8 &&
                          fabs(f.m.offset - own.offset) < 1e-8 && fabs(remainder(f.phi - phi0, 2 * YK_PI)) < 1e-6;
            seen += is_own;
        }
        assert_int_equal(seen, 1);
        answer_free(&a);
    }
}

static double largest_error(const Found *f, double travel, int *changes)
{
    enum { STEPS = 20000 };
    double worst = 0, before = 0;
    *changes = 0;
    for (int k = 0; k <= STEPS; k++) {
        double part = (double)k / STEPS, wanted = (pow(1 + 3 * part, 1.5) - 1) / 7 * travel;
        double error = place(&f->m, f->phi + part * 90 * DEG) - f->s - wanted;
        worst = fmax(worst, fabs(error));
        *changes += error * before < 0;
        if (error != 0) before = error;
    }
    return worst;
}

static void errors_are_those_of_the_closed_form_and_are_evened_out(void **state)
{
    (void)state;
    static const char power[] = "synthesis: function\nof: x^1.5\nx: [1, 4]\ninput: 90 deg\noutput: 80 mm\n"
                                "mechanisms: [slider-crank]\n";
    char text[300];
    size_t evened = 0;
    snprintf(text, sizeof text, "%sevened: true\n", power);
    Answer a = answer_to(power), b = answer_to(text);
    size_t complex_count, real_count;
    assert_true(yk_synthesis_solutions(a.synthesis, &complex_count, &real_count));
    assert_true(complex_count == 3 && real_count == 3);
    for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
        YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
        Found f = read_candidate(&c);
        const char *at = strstr(c.model, "start:"); // the phase, off by the error there
        assert_true(at && (at = strstr(at, " s: ")) != NULL);
        f.s = atof(at + 4);
        int changes;
        CHECK_NEAR(c.worst, largest_error(&f, 0.08, &changes), 1e-9);
        assert_int_equal(changes, 5);
    }
    for (size_t k = 0; k < yk_synthesis_count(b.synthesis); k++) {
        YkCandidate c = yk_synthesis_candidate(b.synthesis, k);
        double before = yk_synthesis_interpolating(b.synthesis, k);
        if (isnan(before)) continue;
        assert_true(c.worst < 0.9 * before);
        evened++;
    }
    assert_true(evened >= 1);
    answer_free(&a);
    answer_free(&b);
}

// Where four-bars are sought as well, the travel is 1 m or what `fix` says, and sizes follow it.
static void beside_four_bars_the_travel_is_free(void **state)
{
    (void)state;
    static const char both[] = "synthesis: function\nof: x^1.5\nx: [1, 4]\ninput: 90 deg\noutput: 90 deg\n"
                               "mechanisms: [four-bar, slider-crank]\n";
    char text[300];
    snprintf(text, sizeof text, "%sfix: {travel: 250 mm}\n", both);
    Answer a = answer_to(both), b = answer_to(text);
    size_t sliders = 0, complex_count, real_count;
    assert_true(yk_synthesis_solutions(a.synthesis, &complex_count, &real_count));
    assert_true(complex_count == 6 && real_count == 6);
    assert_int_equal(yk_synthesis_count(a.synthesis), yk_synthesis_count(b.synthesis));
    for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
        YkCandidate one = yk_synthesis_candidate(a.synthesis, k), other = yk_synthesis_candidate(b.synthesis, k);
        bool is_slider = strcmp(one.mechanism, "slider-crank") == 0;
        assert_string_equal(one.mechanism, other.mechanism);
        for (size_t i = 0; i < 4; i++)
            CHECK_NEAR(other.lengths[i], (is_slider ? 0.25 : 1) * one.lengths[i], 1e-9 * one.lengths[i]);
        CHECK_NEAR(other.worst, (is_slider ? 0.25 : 1) * one.worst, 1e-12 * one.size / one.transmission[0] + 1e-9);
        sliders += is_slider;
    }
    assert_int_equal(sliders, 3);
    answer_free(&a);
    answer_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pairs_of_a_slider_crank_give_it_back),
        cmocka_unit_test(errors_are_those_of_the_closed_form_and_are_evened_out),
        cmocka_unit_test(beside_four_bars_the_travel_is_free),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
