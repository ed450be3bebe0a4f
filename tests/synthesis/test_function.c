// Function generators against published ones, and against four-bars solved by another formula.
#include "synthesis/answer.h"
#include "base/vec.h"

#define DEG (YK_PI / 180)

static const char power[] = "synthesis: function\nof: x^1.5\nx: [1, 4]\ninput: 90 deg\noutput: 90 deg\n";

// The numbers that are told of a machine are those that its file writes as parameters, in this order, and all of them.
static void check_written(const YkSynthesis *synthesis, size_t k)
{
    const char *at = strstr(yk_synthesis_candidate(synthesis, k).model, "parameters:");
    assert_non_null(at);
    at = strchr(at, '{');
    double value;
    for (size_t i = 0; *at != '}'; i++) {
        const char *name = yk_synthesis_parameter(synthesis, k, i, &value);
        at += strspn(at, "{, ");
        assert_non_null(name);
        assert_memory_equal(at, name, strlen(name));
        at += strlen(name);
        assert_memory_equal(at, ": ", 2);
        char *end;
        CHECK_NEAR(strtod(at + 2, &end), value, 1e-10 * fabs(value));
        at = end;
        if (*at == '}') assert_null(yk_synthesis_parameter(synthesis, k, i + 1, NULL));
    }
}

static void the_published_four_bars_for_a_power_are_found(void **state)
{
    (void)state;
    static const double published[3][4] = {{11.277774066, 7.371929960, 3.830185228, .011361},
                                           {2.433295302, 2.319172912, 1.572391543, .022760},
                                           {5.904736371, .824441313, 5.623252391, .172390}};
    Answer a = answer_to(power);
    size_t complex_count, real_count;
    assert_true(yk_synthesis_solutions(a.synthesis, &complex_count, &real_count));
    assert_int_equal(complex_count, 3);
    assert_int_equal(real_count, 3);
    assert_int_equal(yk_synthesis_count(a.synthesis), 3);
    for (size_t k = 0; k < 3; k++) {
        YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
        check_written(a.synthesis, k);
        CHECK_NEAR(c.lengths[0], 1, 1e-12);
        for (size_t i = 0; i < 3; i++) CHECK_NEAR(c.lengths[i + 1], published[k][i], 1e-9);
        CHECK_NEAR(c.worst / DEG, published[k][3], 6e-7);
        assert_true(c.error < 1e-18);
    }
    answer_free(&a);
}

// Solves the four-bar with ground 1 at an input angle: the output angle nearest to `near_to`.
static double output_at(const double length[4], double phi, double near_to)
{
    double g = length[0], a = length[1], b = length[2], c = length[3];
    YkVec d = yk_sub(yk_vec(g, 0), yk_scale(a, yk_unit(phi))); // from A to B0
    double f = yk_norm(d), cosine = (b * b - f * f - c * c) / (2 * f * c), turn = acos(fmin(fmax(cosine, -1), 1));
    double one = yk_nearest_turn(atan2(d.y, d.x) + turn, near_to),
           other = yk_nearest_turn(atan2(d.y, d.x) - turn, near_to);
    return fabs(one - near_to) < fabs(other - near_to) ? one : other;
}

// Returns the largest error of a candidate over its range, from 20,000 poses of the formula above.
static double largest_error(const YkCandidate *c, double (*f)(double), double from, double to, double input,
                            double output)
{
    enum { STEPS = 20000 };
    Standing s = standing(c->model);
    double phi = yk_state_coordinate(s.state, yk_coordinate_find(s.mech, "theta")).position;
    double psi = yk_state_coordinate(s.state, yk_coordinate_find(s.mech, "psi")).position, last = psi, worst = 0;
    // The phase of the output is that of the start of the file, up to the error there: it is written in `start:`.
    const char *at = strstr(c->model, "psi: ");
    double phase = atof(at + 5) * DEG;
    for (int k = 0; k <= STEPS; k++) {
        double part = (double)k / STEPS, wanted = (f(from + part * (to - from)) - f(from)) / (f(to) - f(from)) * output;
        last = output_at(c->lengths, phi + part * input, last);
        worst = fmax(worst, fabs(remainder(last - phase - wanted, 2 * YK_PI)));
    }
    standing_free(&s);
    return worst;
}

static double power_of(double x)
{
    return pow(x, 1.5);
}

static void errors_over_the_range_are_those_of_the_closed_form(void **state)
{
    (void)state;
    Answer a = answer_to(power);
    for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
        YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
        CHECK_NEAR(c.worst, largest_error(&c, power_of, 1, 4, 90 * DEG, 90 * DEG), 1e-9);
    }
    answer_free(&a);
    a = answer_to("synthesis: function\nof: log10(x)\nx: [1, 2]\ninput: 60 deg\noutput: -70 deg\nsamples: 4\n"
                  "require: {transmission: 20 deg}\nbest: 6\n");
    assert_true(yk_synthesis_count(a.synthesis) >= 2);
    for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
        YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
        CHECK_NEAR(c.worst, largest_error(&c, log10, 1, 2, 60 * DEG, -70 * DEG), 1e-8);
        assert_true(c.transmission[0] >= 20 * DEG);
        if (k > 0) assert_true(c.worst >= yk_synthesis_candidate(a.synthesis, k - 1).worst);
    }
    answer_free(&a);
}

// The error of a four-bar with ground 1 over the power's range, largest at 4,000 poses; how often its sign changes.
static double power_error(const double l[4], double phi, double psi, double near_to, int *changes)
{
    enum { STEPS = 4000 };
    double last = near_to, before = 0, worst = 0;
    *changes = 0;
    for (int k = 0; k <= STEPS; k++) {
        double part = (double)k / STEPS, wanted = (power_of(1 + 3 * part) - 1) / 7 * 90 * DEG;
        last = output_at(l, phi + part * 90 * DEG, last);
        double error = remainder(last - psi - wanted, 2 * YK_PI);
        worst = fmax(worst, fabs(error));
        *changes += error * before < 0;
        if (error != 0) before = error;
    }
    return worst;
}

// Evened out, the error is below the interpolating one's, changes sign five times or more, and grows whichever
// dimension changes: a local minimum has six extremes that are alike (Chebyshev), so that the sum of two opposite
// growths is of first order.
static void errors_that_are_evened_out_are_the_least_nearby(void **state)
{
    (void)state;
    static const double published[3] = {.011361, .022760, .172390};
    char text[200];
    bool seen[3] = {false};
    snprintf(text, sizeof text, "%sevened: true\n", power);
    Answer a = answer_to(text), plain = answer_to(power);
    assert_int_equal(yk_synthesis_count(a.synthesis), 3);
    assert_true(isnan(yk_synthesis_interpolating(plain.synthesis, 0)));
    for (size_t k = 0; k < 3; k++) {
        YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
        double before = yk_synthesis_interpolating(a.synthesis, k);
        for (size_t i = 0; i < 3; i++) {
            YkCandidate p = yk_synthesis_candidate(plain.synthesis, i);
            if (fabs(before / DEG - published[i]) > 6e-7) continue;
            seen[i] = true;
            CHECK_NEAR(before, p.worst, 1e-9);
            assert_true(c.worst < .97 * p.worst);
        }
        Standing s = standing(c.model);
        double phi = yk_state_coordinate(s.state, yk_coordinate_find(s.mech, "theta")).position;
        double start = yk_state_coordinate(s.state, yk_coordinate_find(s.mech, "psi")).position;
        double psi = atof(strstr(c.model, "psi: ") + 5) * DEG;
        standing_free(&s);
        int changes;
        double worst = power_error(c.lengths, phi, psi, start, &changes);
        CHECK_NEAR(worst, c.worst, 1e-8);
        assert_true(changes >= 5);
        for (int i = 0; i < 5; i++)
            for (int sign = -1; sign <= 1; sign += 2) {
                double l[4] = {1, c.lengths[1], c.lengths[2], c.lengths[3]}, angle[2] = {phi, psi}, h = sign * 1e-6;
                *(i < 3 ? &l[i + 1] : &angle[i - 3]) += h;
                assert_true(power_error(l, angle[0], angle[1], start, &changes) > worst);
            }
    }
    assert_true(seen[0] && seen[1] && seen[2]);
    answer_free(&a);
    answer_free(&plain);
}

// Freudenstein's equation holds at every pair that a candidate meets.
static double residual(const double l[4], double phi, double psi)
{
    double K1 = l[0] / l[1], K2 = l[0] / l[3];
    double K3 = (l[1] * l[1] - l[2] * l[2] + l[3] * l[3] + l[0] * l[0]) / (2 * l[1] * l[3]);
    return K1 * cos(psi) - K2 * cos(phi) + K3 - cos(phi - psi);
}

static void pairs_and_phases_that_are_given_are_kept(void **state)
{
    (void)state;
    static const double l[4] = {1, .6, 1.2, .9};
    double pair[3][2] = {{0, 0}, {25 * DEG, 0}, {60 * DEG, 0}}, start = output_at(l, 40 * DEG, 1);
    char task[300];
    for (int k = 1; k < 3; k++) pair[k][1] = output_at(l, 40 * DEG + pair[k][0], start) - start;
    snprintf(task, sizeof task,
             "synthesis: function\npairs: [[0, 0], [25 deg, %.17g], [60 deg, %.17g]]\n"
             "fix: {input_start: 40 deg, output_start: %.17g, ground: 300 mm}\n",
             pair[1][1], pair[2][1], start);
    Answer a = answer_to(task);
    assert_true(yk_synthesis_is_complete(a.synthesis));
    assert_int_equal(yk_synthesis_count(a.synthesis), 1);
    for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
        YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
        CHECK_NEAR(c.lengths[0], .3, 1e-12);
        for (size_t i = 0; i < 3; i++)
            CHECK_NEAR(residual(c.lengths, 40 * DEG + pair[i][0], start + pair[i][1]), 0, 1e-9);
        for (size_t i = 0; i < 4; i++) CHECK_NEAR(c.lengths[i], .3 * l[i], 1e-9);
    }
    answer_free(&a);
    // One phase of four pairs.
    for (int side = 0; side < 2; side++) {
        char text[400];
        snprintf(text, sizeof text,
                 "synthesis: function\npairs: [[0, 0], [20 deg, 25 deg], [40 deg, 45 deg], [70 deg, 60 deg]]\n"
                 "fix: {%s_start: 50 deg}\n",
                 side == 0 ? "input" : "output");
        a = answer_to(text);
        assert_true(yk_synthesis_count(a.synthesis) + yk_synthesis_defect_count(a.synthesis) > 0);
        for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
            YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
            Standing s = standing(c.model);
            double start =
                yk_state_coordinate(s.state, yk_coordinate_find(s.mech, side == 0 ? "theta" : "psi")).position;
            CHECK_NEAR(remainder(start - 50 * DEG, 2 * YK_PI), 0, 1e-9);
            standing_free(&s);
        }
        answer_free(&a);
    }
}

// A four-bar's own pairs give it back.
static void a_four_bar_is_found_again_from_its_pairs(void **state)
{
    (void)state;
    uint64_t seed = 21;
    int found = 0;
    for (int round = 0; round < 40; round++) {
        double l[4] = {1, check_uniform(&seed, .5, 1.5), check_uniform(&seed, 1, 2), check_uniform(&seed, .6, 1.6)};
        double phi = check_uniform(&seed, .3, 1), psi[5], nearest = INFINITY;
        char text[400];
        YkVec A = yk_scale(l[1], yk_unit(phi)), d = yk_sub(yk_vec(1, 0), A);
        if (fabs(l[2] - l[3]) > yk_norm(d) * .9 || l[2] + l[3] < yk_norm(d) * 1.2) continue;
        psi[0] = output_at(l, phi, 1.5);
        bool good = true;
        for (int k = 1; k < 5; k++) {
            psi[k] = output_at(l, phi + .2 * k, psi[k - 1]);
            good = good && fabs(psi[k] - psi[k - 1]) > .02 && fabs(residual(l, phi + .2 * k, psi[k])) < 1e-12;
        }
        if (!good) continue;
        snprintf(text, sizeof text,
                 "synthesis: function\npairs: [[0, 0], [.2, %.17g], [.4, %.17g], [.6, %.17g], [.8, %.17g]]\n",
                 psi[1] - psi[0], psi[2] - psi[0], psi[3] - psi[0], psi[4] - psi[0]);
        Answer a = answer_to(text);
        for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
            YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
            nearest = fmin(nearest, fabs(c.lengths[1] - l[1]) + fabs(c.lengths[2] - l[2]) + fabs(c.lengths[3] - l[3]));
        }
        for (size_t k = 0; k < yk_synthesis_defect_count(a.synthesis); k++) { // near a dead point it may be one
            YkCandidate c = yk_synthesis_defect(a.synthesis, k);
            nearest = fmin(nearest, fabs(c.lengths[1] - l[1]) + fabs(c.lengths[2] - l[2]) + fabs(c.lengths[3] - l[3]));
        }
        CHECK_NEAR(nearest, 0, 1e-3);
        found += yk_synthesis_count(a.synthesis) > 0;
        answer_free(&a);
    }
    assert_true(found >= 5);
}

// Freudenstein's equation for theta4 = 65 deg + 0.43 theta2 at Chebyshev's three places of 15 to 165 deg has negative
// lengths (classical exercise): both links begin half a turn from there. With the angles of what is there nothing is
// reversed.
static void negative_lengths_are_links_that_begin_half_a_turn_away(void **state)
{
    (void)state;
    static const double wanted[] = {1, 0.14083845569327505, 1.0791445269931796, 0.29333640485337126};
    for (int round = 0; round < 4; round++) {
        int turned = round % 2;
        double from[2] = {round < 2 ? 0 : 25.0480947161671,
                          round < 2 ? 0 : 75.77068072795186}; // pairs as angles, or as turns
        char text[600];
        snprintf(
            text, sizeof text,
            "synthesis: function\npairs: [[%.17g deg, %.17g deg], [%.17g deg, %.17g deg], [%.17g deg, %.17g deg]]\n"
            "fix: {input_start: %.17g deg, output_start: %.17g deg, ground: 1}\n",
            from[0], from[1], from[0] + 64.9519052838329, from[1] + 27.92931927204819, from[0] + 129.9038105676658,
            from[1] + 55.85863854409638, 25.0480947161671 + 180 * turned, 75.77068072795186 - 180 * turned);
        Answer a = answer_to(text);
        assert_true(yk_synthesis_is_complete(a.synthesis));
        assert_int_equal(yk_synthesis_count(a.synthesis), 1);
        YkCandidate c = yk_synthesis_candidate(a.synthesis, 0);
        for (int k = 0; k < 4; k++) CHECK_NEAR(c.lengths[k], wanted[k], 1e-10);
        assert_int_equal(yk_synthesis_is_reversed(a.synthesis, 0, false), !turned);
        assert_int_equal(yk_synthesis_is_reversed(a.synthesis, 0, true), !turned);
        assert_false(yk_synthesis_is_reversed(a.synthesis, 1, true));
        answer_free(&a);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_published_four_bars_for_a_power_are_found),
        cmocka_unit_test(errors_over_the_range_are_those_of_the_closed_form),
        cmocka_unit_test(negative_lengths_are_links_that_begin_half_a_turn_away),
        cmocka_unit_test(errors_that_are_evened_out_are_the_least_nearby),
        cmocka_unit_test(pairs_and_phases_that_are_given_are_kept),
        cmocka_unit_test(a_four_bar_is_found_again_from_its_pairs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
