// Cognates trace the same curve: on both configurations of every pose, and against closed forms.
#include "synthesis/answer.h"
#include "base/vec.h"

static const char four_bar[] =
    "bodies:\n  ground: {points: {A0: [%g, %g], B0: [%g, %g]}}\n  crank: {points: {A0: [0, 0], A: [%.17g, 0]}}\n"
    "  rod: {points: {A: [0, 0], B: [%.17g, 0], P: [%.17g, %.17g]}}\n  rocker: {points: {B0: [0, 0], B: [%.17g, 0]}}\n"
    "joints:\n  A0: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
    "  B0: {pin: [ground, rocker], angle: psi}\n  B: {pin: [rod, rocker]}\nstart: {theta: 1, phi: 0, psi: 1}\n";
static const char slider_crank[] =
    "bodies:\n  ground: {points: {A0: [.1, .2], R: [.3, %g]}}\n  crank: {points: {A0: [0, 0], A: [%.17g, 0]}}\n"
    "  rod: {points: {A: [0, 0], B: [%.17g, 0], P: [%.17g, %.17g]}}\n  block: {points: {B: [0, 0]}}\n"
    "joints:\n  A0: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
    "  S: {slide: [ground, block], along: 20 deg, from: R, distance: s}\n  B: {pin: [rod, block]}\n"
    "start: {theta: 1, phi: 0, s: 2}\n";

// Returns how far P is from the nearest configuration of a cognate whose input stands at an angle.
static double apart(Standing *c, double angle, YkVec P)
{
    double nearest = INFINITY;
    size_t point = yk_model_find_point(c->model, "coupler.P");
    yk_state_set_input_to(c->state, 0, angle, 0, 0);
    for (int branch = -1; branch <= 1; branch += 2) {
        yk_state_set_branch(c->state, 0, branch);
        if (yk_state_solve(c->state) < 0) continue;
        YkPointMotion p = yk_state_point(c->state, point);
        nearest = fmin(nearest, hypot(p.position[0] - P.x, p.position[1] - P.y));
    }
    return nearest;
}

// All poses of both configurations of a machine have their place on the curves of its cognates. Poses beside dead
// points, where an angle is known to half the digits, are passed over.
static void check(const char *text, size_t count)
{
    Standing s = standing(text);
    YkProblems *problems = yk_problems_new();
    YkCognates *cognates = yk_cognates_new(s.state, YK_NOT_FOUND, problems);
    if (!cognates) print_error("%s\n%s", text, yk_problems_text(problems, 0));
    assert_non_null(cognates);
    assert_int_equal(yk_cognates_count(cognates), count);
    size_t rod = yk_model_find_body(s.model, "rod"), P = yk_model_find_point(s.model, "rod.P"), tried = 0;
    double size = yk_mechanism_size(s.mech), coupler = yk_state_body(s.state, rod).position;
    for (size_t k = 0; k < count; k++) {
        YkCandidate own = yk_cognates_at(cognates, k);
        assert_true(own.worst < 1e-7 * size);
        Standing c = standing(own.model);
        double input = yk_state_coordinate(c.state, yk_coordinate_find(c.mech, "theta")).position;
        for (int i = 0; i < 720; i++) {
            for (int branch = -1; branch <= 1; branch += 2) {
                yk_state_set_input_to(s.state, 0, i * YK_PI / 360, 0, 0);
                yk_state_set_branch(s.state, 0, branch);
                if (yk_state_solve(s.state) < 0 || yk_state_transmission(s.state, 0) < .15) continue;
                YkPointMotion p = yk_state_point(s.state, P);
                double off = apart(&c, input + yk_state_body(s.state, rod).position - coupler,
                                   yk_vec(p.position[0], p.position[1]));
                if (yk_state_transmission(c.state, 0) < .1) continue;
                CHECK_NEAR(off, 0, 1e-13 * fmax(size, yk_mechanism_size(c.mech)) / .1);
                tried++;
            }
        }
        standing_free(&c);
    }
    assert_true(tried > 100);
    assert_non_null(strstr(yk_cognates_picture(cognates), "polyline"));
    yk_cognates_free(cognates);
    yk_problems_free(problems);
    standing_free(&s);
}

static void four_bars_have_two_cognates_on_every_circuit(void **state)
{
    (void)state;
    uint64_t seed = 31;
    for (int round = 0; round < 12; round++) {
        char text[1000];
        double a = check_uniform(&seed, .4, 1), b = check_uniform(&seed, 1.2, 2), c = check_uniform(&seed, 1, 1.8);
        double px = check_uniform(&seed, -1, 2), py = check_uniform(&seed, .2, 1);
        snprintf(text, sizeof text, four_bar, .3, -.2, 2.1, .4, a, b, px, py, c);
        check(text, 2);
    }
}

static void slider_cranks_have_one(void **state)
{
    (void)state;
    uint64_t seed = 32;
    for (int round = 0; round < 8; round++) {
        char text[1000];
        double py = check_uniform(&seed, .2, 1), px = check_uniform(&seed, -1, 2), rod = check_uniform(&seed, 1.5, 2),
               crank = check_uniform(&seed, .4, .8), offset = check_uniform(&seed, -.2, .4);
        snprintf(text, sizeof text, slider_crank, offset, crank, rod, px, py);
        check(text, 1);
    }
}

// The lengths are those of the coupler's triangle: |l| = AP/AB on the side of A0, BP/AB on the side of B0.
static void lengths_are_those_of_cayleys_diagram(void **state)
{
    (void)state;
    char text[1000];
    snprintf(text, sizeof text, four_bar, 0., 0., 2., 0., .5, 1.5, .9, 1.2, 1.25);
    Standing s = standing(text);
    YkCognates *cognates = yk_cognates_new(s.state, YK_NOT_FOUND, NULL);
    double l[2] = {hypot(.9, 1.2) / 1.5, hypot(.6, 1.2) / 1.5};
    const double from_a[4] = {2, 1.5, .5, 1.25}, from_b[4] = {2, 1.5, 1.25, .5}; // ground, input, coupler, output
    for (size_t k = 0; k < 2; k++) {
        YkCandidate c = yk_cognates_at(cognates, k);
        for (size_t i = 0; i < 4; i++) CHECK_NEAR(c.lengths[i], l[k] * (k == 0 ? from_a : from_b)[i], 1e-14);
    }
    YkCandidate left = yk_cognates_at(cognates, 0), right = yk_cognates_at(cognates, 1);
    for (size_t i = 0; i < 2; i++) CHECK_NEAR(left.pivots[1][i], right.pivots[1][i], 1e-14); // the third pivot is one
    YkCandidate own = yk_cognates_at(cognates, YK_NOT_FOUND), none = yk_cognates_at(cognates, 2);
    const double lengths[4] = {2, .5, 1.5, 1.25};
    for (size_t i = 0; i < 4; i++) CHECK_NEAR(own.lengths[i], lengths[i], 1e-14);
    assert_true(!none.file && none.lengths[0] == 0 && left.file && right.file && strcmp(left.file, right.file) != 0);
    assert_null(yk_cognates_at(NULL, 0).file);
    yk_cognates_free(cognates);
    standing_free(&s);
}

static void a_machine_without_a_coupler_point_is_refused(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    Standing s = standing("bodies: {crank: {points: {O: [0, 0], A: [1, 0]}}, ground: {points: {O: [0, 0]}}}\n"
                          "joints: {O: {pin: [ground, crank], angle: theta}}\n");
    assert_null(yk_cognates_new(s.state, YK_NOT_FOUND, problems));
    assert_int_equal(yk_problems_get(problems, 0)->code, 847);
    assert_null(yk_cognates_new(NULL, 0, problems));
    assert_int_equal(yk_cognates_count(NULL), 0);
    assert_null(yk_cognates_picture(NULL));
    standing_free(&s);
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(four_bars_have_two_cognates_on_every_circuit),
        cmocka_unit_test(slider_cranks_have_one),
        cmocka_unit_test(lengths_are_those_of_cayleys_diagram),
        cmocka_unit_test(a_machine_without_a_coupler_point_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
