// Dynamics whose allocations fail one after the other: each call is refused, or says that it ran out, and the next one
// is right. Indices beyond the last: nothing is read there, and the answers are those of the header.
#include "../survive.h"
#include "rig.h"

// A slider-crank behind a gear, with dry friction, a spring and a law, so that every part of the dynamics is made.
static const char text[] = "parameters: {m: 2 kg, mu: 0.1}\ngravity: [0, -10]\n"
                           "laws: {press: {between: linear, table: [[0 mm, 10 N], [400 mm, 50 N]]}}\n"
                           "bodies:\n"
                           "  ground: {points: {O: [0, 0], P: [90 mm, 0], F: [600 mm, 0]}}\n"
                           "  pinion: {points: {O: [0, 0]}, mass: 0.5 kg, inertia: 0.001 kg*m^2}\n"
                           "  wheel: {points: {P: [0, 0], A: [50 mm, 0]}, mass: m, inertia: 0.002 kg*m^2}\n"
                           "  rod: {points: {A: [0, 0], B: [180 mm, 0]}, mass: 1 kg, rod: [A, B]}\n"
                           "  ram: {points: {B: [0, 0]}, mass: m}\n"
                           "joints:\n"
                           "  O: {pin: [ground, pinion], angle: q}\n"
                           "  P: {pin: [ground, wheel], angle: theta}\n"
                           "  A: {pin: [wheel, rod], angle: phi}\n"
                           "  B: {pin: [rod, ram]}\n"
                           "  S: {slide: [ground, ram], along: x, distance: s, friction: {coulomb: mu}}\n"
                           "gears: {g: {mesh: [pinion, wheel], teeth: [20, 40]}}\n"
                           "springs: {k: {between: [ground.F, ram.B], stiffness: 100 N/m, length: 0.3 m}}\n"
                           "efforts: {s: {law: press, of: s}}\n"
                           "start: {q: 0, theta: 60 deg, phi: -75 deg, s: 300 mm}\n";

typedef struct Task {
    Rig rig; // its state and mechanism are those of a variant
    YkVariant *variant;
    double free, effort, fast; // answers: accelerations by both methods, and what holds the machine
} Task;

// Fails for want of memory alone.
static bool is_done(YkStatus status)
{
    if (status < 0 && status != YK_NO_MEMORY) fail_msg("%s", yk_status_name(status));
    return status >= 0;
}

// Solves the machine as it is, held at rest, and with another mass.
static bool answer(void *context)
{
    Task *t = context;
    double accelerations[8], light = 1, own = yk_model_parameter(t->rig.model, "m");
    YkDynamics *d = yk_dynamics_new(t->rig.mech, NULL);
    YkLawWatch *watch = yk_law_watch_new(t->rig.model);
    bool good = d && watch && is_done(yk_variant_set(t->variant, &own));
    if (good) {
        yk_dynamics_prescribe(d, 0, false);
        yk_state_set_input(t->rig.state, 0, (YkMotion){0.3, 2, 0});
        good = is_done(yk_dynamics_solve(d, t->rig.state, YK_METHOD_REDUCED));
        t->free = yk_state_input(t->rig.state, 0).acceleration;
    }
    if (good) good = is_done(yk_dynamics_solve(d, t->rig.state, YK_METHOD_NEWTON_EULER));
    if (good) {
        CHECK_NEAR(yk_state_input(t->rig.state, 0).acceleration, t->free, 1e-10 * fabs(t->free));
        assert_int_equal(yk_law_watch_look(watch, t->rig.state, d, 0), 0);
        good = !yk_dynamics_count(d).ran_out;
    }
    if (good)
        good = is_done(yk_variant_set(t->variant, &light)) &&
               is_done(yk_dynamics_accelerate(d, t->rig.state, accelerations));
    if (good) t->fast = accelerations[0];
    if (good) {
        yk_dynamics_prescribe(d, 0, true);
        yk_state_set_input(t->rig.state, 0, (YkMotion){0.3, 0, 0});
        good = is_done(yk_dynamics_solve(d, t->rig.state, YK_METHOD_REDUCED));
        t->effort = yk_dynamics_effort(d, 0);
    }
    yk_law_watch_free(watch);
    yk_dynamics_free(d);
    return good;
}

static void every_part_survives_failed_allocations(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    const char *name = "m";
    Task t = {.rig = rig_of_text(text)};
    YkState *own = t.rig.state;
    t.variant = yk_variant_new(t.rig.mech, &name, 1, t.rig.problems);
    assert_non_null(t.variant);
    YkMechanism *mech = t.rig.mech;
    t.rig.mech = (YkMechanism *)yk_variant_mechanism(t.variant); // only read
    t.rig.state = yk_state_new(t.rig.mech);
    yk_state_take(t.rig.state, own);
    assert_true(answer(&t));
    double before[] = {t.free, t.fast, t.effort};
    survive(answer, &t, "dynamics");
    assert_true(before[0] == t.free && before[1] == t.fast && before[2] == t.effort && before[0] != before[1]);
    yk_state_free(t.rig.state);
    yk_variant_free(t.variant);
    t.rig.state = own;
    t.rig.mech = mech;
    rig_free(&t.rig);
}

static bool is_none(YkReaction r)
{
    return r.by == YK_NOT_FOUND && r.on == YK_NOT_FOUND && isnan(r.force[0]) && isnan(r.moment) && isnan(r.at[0]);
}

static void indices_beyond_the_last_answer_nothing(void **unused)
{
    (void)unused;
    Rig rig = rig_of_text(text);
    YkDynamics *d = rig.dynamics;
    assert_true(yk_dynamics_solve(d, rig.state, YK_METHOD_REDUCED) >= 0);
    double acceleration = yk_state_input(rig.state, 0).acceleration;
    assert_int_equal(yk_dynamics_contact_count(d), 1);
    assert_string_equal(yk_dynamics_contact_name(d, 0), "g");
    assert_false(is_none(yk_dynamics_contact(d, 0)) || yk_dynamics_contact_pulls(d, 0));
    for (int k = 0; k < 2; k++) { // just beyond, and where a search by name found nothing
        size_t input = k ? YK_NOT_FOUND : yk_input_count(rig.mech), contact = k ? YK_NOT_FOUND : 1;
        size_t coordinate = k ? YK_NOT_FOUND : yk_coordinate_count(rig.mech);
        yk_dynamics_prescribe(d, input, true);
        yk_dynamics_set_effort(d, coordinate, 1e6);
        assert_false(yk_dynamics_is_prescribed(d, input) || yk_dynamics_has_effort(d, coordinate));
        assert_true(is_none(yk_dynamics_reaction(d, k ? YK_NOT_FOUND : yk_model_joint_count(rig.model))));
        assert_true(is_none(yk_dynamics_contact(d, contact)));
        assert_null(yk_dynamics_contact_name(d, contact));
        assert_false(yk_dynamics_contact_pulls(d, contact));
        assert_true(isnan(yk_dynamics_effort(d, coordinate)));
        YkEffortRange range = yk_dynamics_effort_range(d, coordinate);
        assert_true(!range.is_known && !range.is_single && range.low == -INFINITY && range.high == INFINITY);
        YkBalance balance = yk_dynamics_balance(d, k ? YK_NOT_FOUND : yk_model_body_count(rig.model));
        assert_true(isnan(balance.residual) && isnan(balance.loads.force[1]));
    }
    assert_true(yk_dynamics_solve(d, rig.state, YK_METHOD_REDUCED) >= 0);
    assert_true(yk_state_input(rig.state, 0).acceleration == acceleration); // nothing was set
    rig_free(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_part_survives_failed_allocations),
        cmocka_unit_test(indices_beyond_the_last_answer_nothing),
    };
    start_counting();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
