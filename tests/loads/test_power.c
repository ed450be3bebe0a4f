// All kinds of loads at once: what they do to the bodies is the power that they say, less what springs store.
#include <stdio.h>
#include "dynamics/rig.h"
#include "loads/point.h"

static const char *const everything =
    "gravity: [0, -9.81]\nlaws: {line: {table: [[-20 m, -1000], [20 m, 1500]], between: linear}}\nbodies:\n"
    "  ground: {points: {P: [0, 1], O: [0, 0]}}\n"
    "  crank: {points: {P: [0, 0], A: [0.4, 0]}, mass: 1, inertia: 0.1, center: [0.2, 0.05]}\n"
    "  block: {points: {A: [0, 0], C: [0.1, -0.2]}, mass: 0.5, inertia: 0.03, center: [0.02, 0.01]}\n"
    "  lever: {points: {O: [0, 0], T: [0.7, 0.1]}, mass: 1, inertia: 0.2, center: [0.3, 0]}\n"
    "  cart: {points: {B: [0.3, 0.1]}, mass: 2, center: [0.1, 0.1]}\n"
    "joints:\n  P: {pin: [ground, crank], angle: theta1, friction: {viscous: 0.7}}\n"
    "  A: {pin: [crank, block], friction: {viscous: 0.3}}\n"
    "  O: {pin: [ground, lever], angle: theta2, friction: {coulomb: 0.1, radius: 0.05}}\n"
    "  S: {slide: [lever, block], along: x, distance: d, friction: {viscous: 2}}\n"
    "  T: {slide: [lever, cart], along: 0.4 rad, from: T, to: B, distance: s, friction: {coulomb: 0.2}}\n"
    "start: {theta1: 0.5, theta2: 1.3, s: 0.2}\n"
    "efforts: {theta1: 3 N*m + 2 N*m*s * theta1.rate, d: 5 N - 20 N/m * d, s: 4 N}\n"
    "forces:\n  f: {body: block, at: C, value: [3 N + 2 N/s * t, -4 N * cos(theta2)], moment: 0.7 N*m}\n"
    "  g: {body: cart, at: B, value: [2 N, 5 N*s/m * s.rate], axes: body}\n"
    "springs:\n  k: {between: [lever.T, crank.A], stiffness: 50, length: 0.3, damping: 2}\n"
    "  l: {between: [cart.B, ground.O], force: {law: line, of: length - 0.3 m}, stiffness: 20, length: 0.1}\n"
    "  m: {along: theta2, stiffness: 7, angle: 0.2, damping: 0.5}\n"
    "  n: {along: d, stiffness: 40, length: 0.2, damping: 3, force: 2 N*s/m * rate}\n"
    "  o: {along: theta1, torque: 3 N*m * angle + 0.2 N*m*s * rate}\n";

// A hand pulls at two points, a third is let go.
static void pull(Rig *rig)
{
    YkLoads *loads = rig->dynamics->loads;
    assert_true(yk_loads_set_handles(loads, 3));
    assert_int_equal(loads->handle_count, 3);
    for (int k = 0; k < 3; k++)
        loads->handles[k] = (YkHandle){.is_on = k != 1,
                                       .end = yk_load_end(rig->mech, 2 + k, yk_vec(0.3 * k, -0.1)),
                                       .target = yk_vec(1, k),
                                       .force = yk_vec(-2, 3 + k),
                                       .stiffness = 30.0 + k,
                                       .damping = 4};
}

static void put(Rig *rig, const double *q, const double *v, double h)
{
    for (size_t i = 0; i < rig->mech->input_count; i++)
        yk_state_set_input(rig->state, i, (YkMotion){q[i] + h * v[i], v[i], 0});
    assert_int_equal(yk_state_solve(rig->state), YK_OK);
}

// d(stored)/dt by central differences of the sixth order.
static double storing(Rig *rig, const double *q, const double *v)
{
    static const double weight[] = {3.0 / 4, -3.0 / 20, 1.0 / 60}, h = 2e-3;
    double slope = 0;
    for (int k = 1; k <= 3; k++)
        for (int side = -1; side <= 1; side += 2) {
            put(rig, q, v, side * k * h);
            slope += side * weight[k - 1] / h * yk_loads_stored(rig->dynamics->loads, rig->state, &rig->state->space);
        }
    put(rig, q, v, 0);
    return slope;
}

static void loads_do_the_work_that_they_say(void **unused)
{
    (void)unused;
    uint64_t seed = 31;
    Rig rig = rig_of_text(everything);
    YkLoads *loads = rig.dynamics->loads;
    YkVec none = {0, 0};
    pull(&rig);
    for (int turn = 0; turn < 40; turn++) {
        double q[8], v[8], power[32], given = 0, taken = 0, size = 1;
        YkLoad load[8] = {{none, 0}};
        size_t culprit;
        for (size_t i = 0; i < rig.mech->input_count; i++) {
            q[i] = yk_state_input(rig.state, i).position;
            if (turn == 0) continue;
            v[i] = check_uniform(&seed, -1, 1);
        }
        if (turn == 0) memset(v, 0, sizeof v);
        double stored = storing(&rig, q, v);
        for (size_t k = 0; k < loads->item_count; k++) loads->items[k].dry = check_uniform(&seed, -3, 3);
        assert_true(yk_loads_add(loads, rig.state, &rig.state->space, load, power, &culprit));
        YkVec force = none;
        double moment = 0;
        for (size_t b = 0; b < rig.model->body_count; b++) {
            YkBodyMotion m = b ? yk_body_motion(rig.mech, &rig.state->space, b) : (YkBodyMotion){.e = {1, 0}};
            double work = yk_dot(load[b].force, m.velocity) + load[b].moment * m.w;
            taken += work;
            size += fabs(work);
            force = yk_add(force, load[b].force);
            moment += load[b].moment + yk_cross(m.at, load[b].force);
        }
        for (size_t k = 0; k < loads->item_count; k++) given += power[k];
        given += loads->handle_power;
        CHECK_NEAR(taken, given - stored, 1e-8 * size);
        // Efforts, springs and friction act between bodies: what is left is of forces and hands.
        for (size_t k = 0; k < loads->item_count; k++) {
            const YkLoadItem *item = &loads->items[k];
            if (item->kind != YK_LOAD_FORCE) continue;
            YkBodyMotion m = yk_body_motion(rig.mech, &rig.state->space, (size_t)item->body[0]);
            bool is_f = strcmp(item->name, "f") == 0;
            double theta2 = yk_state_coordinate(rig.state, yk_coordinate_find(rig.mech, "theta2")).position;
            double rate = yk_state_coordinate(rig.state, yk_coordinate_find(rig.mech, "s")).velocity;
            YkVec value = is_f ? yk_vec(3, -4 * cos(theta2)) : yk_mul(m.e, yk_vec(2, 5 * rate));
            YkVec at = is_f ? yk_vec(0.1, -0.2) : yk_vec(0.3, 0.1);
            YkVec place = yk_add(m.at, yk_mul(m.e, yk_sub(at, yk_reference_point(rig.model, (size_t)item->body[0]))));
            force = yk_sub(force, value);
            moment -= yk_cross(place, value) + (is_f ? 0.7 : 0);
        }
        for (int k = 0; k < 3; k += 2) {
            const YkHandle *hand = &loads->handles[k];
            YkLoadPoint p = yk_load_point(rig.mech, &rig.state->space, &hand->end);
            YkVec value = yk_add(hand->force, yk_sub(yk_scale(hand->stiffness, yk_sub(hand->target, p.at)),
                                                     yk_scale(hand->damping, p.velocity)));
            force = yk_sub(force, value);
            moment -= yk_cross(p.at, value);
        }
        CHECK_NEAR(yk_norm(force), 0, 1e-11 * size);
        CHECK_NEAR(moment, 0, 1e-11 * size);
    }
    rig_free(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loads_do_the_work_that_they_say),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
