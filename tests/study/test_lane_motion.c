// Forward dynamics over lanes: that they settle what they are made for, by themselves, as the dynamics of one pose have
// it. Whoever calls them asks those dynamics about the rest, so that a fault here would only be slow.
#include "study/lane_motion.h"
#include "solve/machine.h"

enum { STATES = 40, MOST = 4 };

// A chain of n pendulums with rods of unlike lengths and masses.
static Machine chain(size_t n, bool has_mass_at_its_end)
{
    char bodies[1000], joints[600], text[2000];
    int b = snprintf(bodies, sizeof bodies, "gravity: [0, -9.81]\nbodies:\n  ground: {points: {J0: [0, 0]}}\n");
    int j = snprintf(joints, sizeof joints, "joints:\n");
    for (size_t k = 0; k < n; k++) {
        double length = 0.4 + 0.1 * (double)k;
        b += snprintf(bodies + b, sizeof bodies - (size_t)b, "  b%zu: {points: {J%zu: [0, 0], J%zu: [%g, 0]}", k, k,
                      k + 1, length);
        if (k + 1 < n || has_mass_at_its_end)
            b += snprintf(bodies + b, sizeof bodies - (size_t)b, ", mass: %g, rod: [J%zu, J%zu]", 3.0 / (double)(k + 1),
                          k, k + 1);
        b += snprintf(bodies + b, sizeof bodies - (size_t)b, "}\n");
        char before[8] = "ground";
        if (k > 0) snprintf(before, sizeof before, "b%zu", k - 1);
        j += snprintf(joints + j, sizeof joints - (size_t)j, "  J%zu: {pin: [%s, b%zu], angle: q%zu}\n", k, before, k,
                      k);
    }
    snprintf(text, sizeof text, "%s%s", bodies, joints);
    return machine_parse(text, true);
}

static void check_chain(size_t n, bool has_mass_at_its_end)
{
    Machine m = chain(n, has_mass_at_its_end);
    YkDynamics *dynamics = yk_dynamics_new(m.mech, m.problems);
    double q[MOST][STATES], v[MOST][STATES], a[MOST][STATES], *out[MOST], alone[MOST];
    const double *positions[MOST], *rates[MOST];
    bool fits, is_solved[STATES];
    uint64_t seed = n;
    for (size_t i = 0; i < n; i++) {
        positions[i] = q[i], rates[i] = v[i], out[i] = a[i];
        for (int s = 0; s < STATES; s++) q[i][s] = check_uniform(&seed, -3, 3), v[i][s] = check_uniform(&seed, -5, 5);
    }
    YkLaneMotion *motion = yk_lane_motion_new(m.state, dynamics, STATES, &fits);
    assert_true(motion && fits);
    YkMotionCase asked = {.positions = positions, .rates = rates, .count = STATES};
    assert_true(yk_lane_motion_run(motion, &asked, 0, STATES, out, is_solved));
    for (size_t s = 0; s < STATES; s++) {
        assert_int_equal(is_solved[s], has_mass_at_its_end); // else nothing determines how the last one turns
        for (size_t i = 0; i < n; i++) yk_state_set_input(m.state, i, (YkMotion){q[i][s], v[i][s], 0});
        double most = 1;
        if (has_mass_at_its_end) assert_int_equal(yk_dynamics_accelerate(dynamics, m.state, alone), YK_OK);
        for (size_t i = 0; i < n; i++) most = fmax(most, has_mass_at_its_end ? fabs(alone[i]) : 1);
        for (size_t i = 0; i < n; i++) CHECK_NEAR(a[i][s], has_mass_at_its_end ? alone[i] : 0, 1e-10 * most);
    }
    yk_lane_motion_free(motion);
    yk_dynamics_free(dynamics);
    machine_free(&m);
}

static void lanes_settle_chains_of_pendulums(void **unused)
{
    (void)unused;
    for (size_t n = 1; n <= MOST; n++) check_chain(n, true);
}

static void lanes_leave_what_has_no_mass(void **unused)
{
    (void)unused;
    for (size_t n = 2; n <= MOST; n++) check_chain(n, false);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(lanes_settle_chains_of_pendulums),
                                       cmocka_unit_test(lanes_leave_what_has_no_mass)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
