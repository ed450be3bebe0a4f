// Random trains: the freedom is what the rank of their equations leaves, what is driven is an input, and every equation
// holds, with rates and after many turns, at any values of as many inputs as there are freedoms. That leaves the pose
// no choice.
#include "random_train.h"
#include <yoke/yoke.h>
#include "machine.h"

enum { TRAINS = 400 };

// Every tie holds with rates and accelerations, to the rounding of what moves farthest.
static void check_ties(const Train *t, const YkState *state, const YkMechanism *mech)
{
    bool is_known_by_turns = mech->model->follow_count > 0; // angles that follow by a law
    YkMotion q[BODIES] = {{0, 0, 0}};
    for (int b = 1; b < t->bodies; b++) {
        char name[8];
        snprintf(name, sizeof name, "q%d", b);
        q[b] = yk_state_coordinate(state, yk_coordinate_find(mech, name));
        if (t->is_bar[b] || t->on[b] == 0) continue;
        const YkMotion *arm = &q[t->on[b]];
        q[b] = (YkMotion){q[b].position + arm->position, q[b].velocity + arm->velocity,
                          q[b].acceleration + arm->acceleration};
    }
    double fastest[3] = {0, 0, 0};
    for (int b = 1; b < t->bodies; b++) {
        fastest[0] = fmax(fastest[0], fabs(q[b].position));
        fastest[1] = fmax(fastest[1], fabs(q[b].velocity));
        fastest[2] = fmax(fastest[2], fabs(q[b].acceleration));
    }
    for (int k = 0; k < t->ties; k++) {
        const Tie *tie = &t->tie[k];
        double sum[3] = {-tie->constant, 0, 0}, size = 0;
        for (int b = 1; b < t->bodies; b++) {
            sum[0] += tie->row[b] * q[b].position;
            sum[1] += tie->row[b] * q[b].velocity;
            sum[2] += tie->row[b] * q[b].acceleration;
            size += fabs(tie->row[b]);
        }
        for (int i = is_known_by_turns; i < 3; i++) CHECK_NEAR(sum[i], 0, 1e-12 * size * fastest[i]);
    }
}

static void check_start(const Train *t, const YkState *state, const YkMechanism *mech)
{
    for (int b = 1; b < t->bodies; b++) {
        char name[8];
        snprintf(name, sizeof name, "q%d", b);
        YkCoordinateInfo info = yk_coordinate_info(mech, yk_coordinate_find(mech, name));
        assert_true(!t->is_driven[b] || info.input >= 0);
        if (info.input < 0 || !t->is_given[b]) continue;
        CHECK_NEAR(yk_state_input(state, (size_t)info.input).position, t->start[b], 1e-12);
    }
}

static void set_inputs(YkState *state, const YkMechanism *mech, uint64_t *seed)
{
    for (size_t i = 0; i < yk_input_count(mech); i++) {
        YkMotion q = yk_state_input(state, i);
        q.position += check_uniform(seed, -1, 1) * 1000; // hundreds of turns
        q.velocity = check_uniform(seed, -2, 2);
        q.acceleration = check_uniform(seed, -2, 2);
        yk_state_set_input(state, i, q);
    }
}

static void check_train(uint64_t number)
{
    static Train t;
    uint64_t seed = number;
    draw_train(&t, &seed);
    Machine m = machine(t.text);
    YkFreedom freedom = yk_mechanism_freedom(m.mech);
    int free = t.bodies - 1 - t.rank;
    assert_int_equal(freedom.gruebler, t.bodies - 1 - t.ties);
    assert_int_equal(freedom.by_rank, free);
    assert_int_equal(yk_input_count(m.mech), free);
    YkState *state = yk_state_new(m.mech);
    YkStatus status = yk_state_assemble(state);
    if (m.model->follow_count == 0) assert_int_equal(status, t.rank < t.ties ? YK_REDUNDANT : YK_OK);
    assert_true(status >= 0);
    check_start(&t, state, m.mech);
    check_ties(&t, state, m.mech);
    set_inputs(state, m.mech, &seed);
    assert_true(yk_state_solve(state) >= 0);
    check_ties(&t, state, m.mech);
    yk_state_free(state);
    machine_free(&m);
}

static void ties_hold_and_the_rest_is_free(void **unused)
{
    (void)unused;
    for (uint64_t k = 0; k < check_cases(TRAINS); k++) check_train(k);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ties_hold_and_the_rest_is_free),
    };
    return cmocka_run_group_tests_name("compile/random_trains", tests, NULL, NULL);
}
