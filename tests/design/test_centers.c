// Instant centres: their velocities are the engine's on every example of one freedom; a four-bar's by hand.
#include <glob.h>
#include <stdlib.h>
#include "assembled.h"
#include "loads/loads.h"

// The velocity of a world point as it moves with a body.
static YkVec velocity_at(const YkState *state, size_t body, YkVec at)
{
    YkBodyMotion m = yk_body_motion(state->mech, &state->space, body);
    return yk_add(m.velocity, yk_scale(m.w, yk_quarter(yk_sub(at, m.at))));
}

static void check_centers(const char *name, Assembled *m, const YkCenters *centers)
{
    size_t n = yk_model_body_count(m->model);
    double fastest = 0, size = yk_mechanism_size(m->mech);
    assert_int_equal(yk_centers_count(centers), n * (n - 1) / 2);
    for (size_t b = 0; b < n; b++) {
        YkBodyMotion motion = yk_body_motion(m->mech, &m->state->space, b);
        fastest = fmax(fastest, yk_norm(motion.velocity) + fabs(motion.w) * size);
    }
    for (size_t k = 0; k < yk_centers_count(centers); k++) {
        YkCenter c = yk_centers_at(centers, k);
        YkBodyMotion a = yk_body_motion(m->mech, &m->state->space, c.body[0]);
        YkBodyMotion b = yk_body_motion(m->mech, &m->state->space, c.body[1]);
        double off;
        if (c.kind == YK_CENTER_POINT) {
            YkVec at = yk_vec(c.at[0], c.at[1]);
            YkVec apart = yk_sub(velocity_at(m->state, c.body[0], at), velocity_at(m->state, c.body[1], at));
            double reach = (fabs(a.w) + fabs(b.w)) * (yk_norm(at) + size);
            off = yk_norm(apart) / (fastest + reach);
        } else { // they turn alike; at infinity they slide across the direction
            off = fabs(a.w - b.w) * size / fastest;
            YkVec sliding =
                yk_sub(velocity_at(m->state, c.body[0], yk_vec(0, 0)), velocity_at(m->state, c.body[1], yk_vec(0, 0)));
            double along = c.kind == YK_CENTER_UNDEFINED ? yk_norm(sliding) : yk_dot(sliding, yk_unit(c.direction));
            off = fmax(off, fabs(along) / fastest);
        }
        if (!(off < 1e-12))
            print_error("%s: centre of %s and %s is off by %g\n", name, yk_model_body_name(m->model, c.body[0]),
                        yk_model_body_name(m->model, c.body[1]), off);
        assert_true(off < 1e-12);
    }
}

static void centers_have_the_engines_velocities_on_every_example(void **state)
{
    (void)state;
    glob_t found;
    size_t tried = 0;
    assert_int_equal(glob(YOKE_ROOT "/examples/*.yaml", 0, NULL, &found), 0);
    for (size_t k = 0; k < found.gl_pathc; k++) {
        Assembled m;
        if (assembled_open(&m, found.gl_pathv[k], NULL, 0) && yk_input_count(m.mech) == 1) {
            YkMotion input = yk_state_input(m.state, 0); // away from dead points, at a rate of 1
            yk_state_set_input_to(m.state, 0, input.position + .01, 1, 0);
            YkCenters *centers = yk_state_solve(m.state) >= 0 ? yk_centers_new(m.state, NULL) : NULL;
            if (centers) {
                check_centers(found.gl_pathv[k], &m, centers);
                tried++;
            }
            yk_centers_free(centers);
        }
        assembled_close(&m);
    }
    globfree(&found);
    assert_true(tried > 20);
}

static const char four_bar[] =
    "bodies:\n  ground: {points: {A0: [0, 0], B0: [4, 0]}}\n  crank: {points: {A0: [0, 0], A: [1, 0]}}\n"
    "  rod: {points: {A: [0, 0], B: [3.5, 0]}}\n  rocker: {points: {B0: [0, 0], B: [2.5, 0]}}\n"
    "joints:\n  A0: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
    "  B0: {pin: [ground, rocker], angle: psi}\n  B: {pin: [rod, rocker]}\nstart: {theta: 1, phi: -.5, psi: 2}\n";

static void a_four_bars_two_other_centers_lie_on_the_lines_of_its_links(void **state)
{
    (void)state;
    Assembled m;
    assert_true(assembled_open(&m, NULL, four_bar, 0));
    YkCenters *centers = yk_centers_new(m.state, NULL);
    assert_int_equal(yk_centers_count(centers), 6);
    assert_int_equal(yk_centers_stalled(centers), 0);
    for (size_t k = 0; k < 6; k++)
        assert_int_equal(yk_centers_at(centers, k).source, k < 4 ? YK_CENTER_JOINT : YK_CENTER_KENNEDY);
    double theta = yk_state_body(m.state, 1).position, psi = yk_state_body(m.state, 3).position;
    YkVec A = yk_unit(theta), B = yk_add(yk_vec(4, 0), yk_scale(2.5, yk_unit(psi)));
    for (size_t k = 4; k < 6; k++) {
        YkCenter c = yk_centers_at(centers, k);
        YkVec at = yk_vec(c.at[0], c.at[1]);
        if (c.body[0] == 0) { // ground and rod: where crank and rocker meet
            assert_int_equal(c.body[1], 2);
            CHECK_NEAR(yk_cross(at, A), 0, 1e-12);
            CHECK_NEAR(yk_cross(yk_sub(at, yk_vec(4, 0)), yk_sub(B, yk_vec(4, 0))), 0, 1e-12);
        } else { // crank and rocker: on the ground's line, where their rates are in the ratio of the distances
            CHECK_NEAR(at.y, 0, 1e-12);
            CHECK_NEAR(yk_cross(yk_sub(at, A), yk_sub(B, A)), 0, 1e-12);
        }
    }
    yk_centers_free(centers);
    assembled_close(&m);
}

static void a_slider_has_centers_at_infinity(void **state)
{
    (void)state;
    Assembled m;
    assert_true(assembled_open(&m, YOKE_ROOT "/examples/slider-crank.yaml", NULL, 0));
    YkMotion input = yk_state_input(m.state, 0);
    yk_state_set_input_to(m.state, 0, input.position + .3, 1, 0);
    assert_true(yk_state_solve(m.state) >= 0);
    YkCenters *centers = yk_centers_new(m.state, NULL);
    size_t far_away = 0;
    for (size_t k = 0; k < yk_centers_count(centers); k++)
        far_away += yk_centers_at(centers, k).kind == YK_CENTER_AT_INFINITY;
    assert_int_equal(far_away, 1);
    yk_centers_free(centers);
    assembled_close(&m);
}

static void kennedy_stalls_in_a_double_butterfly(void **state)
{
    (void)state;
    Assembled m;
    assert_true(assembled_open(&m, YOKE_ROOT "/examples/double-butterfly.yaml", NULL, 0));
    YkCenters *centers = yk_centers_new(m.state, NULL);
    assert_non_null(centers);
    assert_true(yk_centers_stalled(centers) >= 1);
    yk_centers_free(centers);
    assembled_close(&m);
}

static void machines_of_other_freedoms_are_refused(void **state)
{
    (void)state;
    Assembled m;
    YkProblems *problems = yk_problems_new();
    assert_true(assembled_open(&m, YOKE_ROOT "/examples/double-pendulum.yaml", NULL, 0));
    assert_null(yk_centers_new(m.state, problems));
    assert_int_equal(yk_problems_get(problems, 0)->code, 848);
    assert_null(yk_centers_new(NULL, problems));
    assert_int_equal(yk_centers_count(NULL), 0);
    assert_int_equal(yk_centers_at(NULL, 3).kind, YK_CENTER_UNDEFINED);
    yk_centers_free(NULL);
    yk_problems_free(problems);
    assembled_close(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(centers_have_the_engines_velocities_on_every_example),
        cmocka_unit_test(a_four_bars_two_other_centers_lie_on_the_lines_of_its_links),
        cmocka_unit_test(a_slider_has_centers_at_infinity),
        cmocka_unit_test(kennedy_stalls_in_a_double_butterfly),
        cmocka_unit_test(machines_of_other_freedoms_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
