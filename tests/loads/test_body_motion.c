// Bodies' reference points and their motion, against the answers for points and angles.
#include "loads/loads.h"
#include "../check_vec.h"
#include "solve/machine.h"
#include "solve/state.h"

static void give_masses(Machine *m, uint64_t *seed)
{
    for (size_t b = 1; b < m->model->body_count; b++) {
        YkBody *body = &m->model->bodies[b];
        body->has_mass = check_random(seed) % 4 != 0;
        body->center = check_vec(seed, -1, 1, -1, 1);
    }
}

static void check_body(const Machine *m, size_t body)
{
    Place p;
    YkVec at = yk_reference_point(m->model, body);
    if (!body_place(m, body, at, &p)) return;
    YkBodyMotion motion = yk_body_motion(m->mech, &m->state->space, body);
    double size = m->mech->size + yk_norm(at), w = fabs(motion.w), a = fabs(motion.a);
    double fast = size * w + yk_norm(p.rate), hard = size * (a + w * w) + yk_norm(p.accel);
    CHECK_NEAR(yk_norm(yk_sub(motion.at, p.place)), 0, 1e-13 * (size + yk_norm(p.place)));
    CHECK_NEAR(yk_norm(yk_sub(motion.velocity, p.rate)), 0, 1e-12 * (fast + 1e-9));
    CHECK_NEAR(yk_norm(yk_sub(motion.acceleration, p.accel)), 0, 1e-11 * (hard + 1e-9));
    CHECK_NEAR(motion.w, p.spin, 0);
    CHECK_NEAR(yk_norm(yk_sub(motion.e, yk_unit(p.angle))), 0, 1e-13);
}

static void test_bodies_move_as_their_points_do(void **unused)
{
    (void)unused;
    uint64_t seed = 17;
    for (size_t e = 0; e < EXAMPLE_COUNT; e++) {
        Machine m = machine_load(all_examples[e]);
        give_masses(&m, &seed);
        for (size_t i = 0; i < yk_input_count(m.mech); i++) {
            YkMotion q = yk_state_input(m.state, i);
            yk_state_set_input(m.state, i,
                               (YkMotion){q.position, check_uniform(&seed, -2, 2), check_uniform(&seed, -2, 2)});
        }
        if (yk_state_solve(m.state) >= 0 && yk_state_has_rates(m.state))
            for (size_t b = 0; b < m.model->body_count; b++) check_body(&m, b);
        machine_free(&m);
    }
}

static void test_the_reference_point_is_the_centre_of_mass_or_else_the_origin(void **unused)
{
    (void)unused;
    Machine m = machine_parse("bodies: {heavy: {points: {P: [1, 0]}, mass: 2, center: [0.5, 0.25], inertia: 1}, light: "
                              "{points: {P: [0, 0]}}}\n"
                              "joints: {O: {pin: [ground, heavy], angle: q}, P: {pin: [heavy, light], angle: p}}\n"
                              "start: {q: 90 deg, q.rate: 2 rad/s, p: 0}\n",
                              true);
    YkVec heavy = yk_reference_point(m.model, 1), light = yk_reference_point(m.model, 2);
    CHECK_NEAR(heavy.x, 0.5, 0);
    CHECK_NEAR(heavy.y, 0.25, 0);
    CHECK_NEAR(yk_norm(light), 0, 0);
    YkBodyMotion motion = yk_body_motion(m.mech, &m.state->space, 1);
    CHECK_NEAR(motion.at.x, -0.25, 1e-15); // turned by a quarter
    CHECK_NEAR(motion.at.y, 0.5, 1e-15);
    CHECK_NEAR(motion.velocity.x, -1, 1e-15);
    CHECK_NEAR(motion.velocity.y, -0.5, 1e-15);
    CHECK_NEAR(motion.acceleration.x, 1, 1e-15); // towards the axis
    CHECK_NEAR(motion.acceleration.y, -2, 1e-15);
    machine_free(&m);
}

static void test_the_ground_rests(void **unused)
{
    (void)unused;
    Machine m = machine_load("quick-return");
    YkBodyMotion motion = yk_body_motion(m.mech, &m.state->space, 0);
    CHECK_NEAR(yk_norm(motion.at) + yk_norm(motion.velocity) + yk_norm(motion.acceleration), 0, 0);
    CHECK_NEAR(motion.e.x, 1, 0);
    CHECK_NEAR(fabs(motion.w) + fabs(motion.a) + fabs(motion.e.y), 0, 0);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bodies_move_as_their_points_do),
        cmocka_unit_test(test_the_reference_point_is_the_centre_of_mass_or_else_the_origin),
        cmocka_unit_test(test_the_ground_rests),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
