// A machine with its dynamics, ready for a test.
#ifndef TESTS_DYNAMICS_RIG_H
#define TESTS_DYNAMICS_RIG_H
#include <stdlib.h>
#include <yoke/yoke.h>
#include "check.h"
#include "dynamics/dynamics.h"

typedef struct Rig {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
    YkDynamics *dynamics;
    YkProblems *problems;
} Rig;

static inline Rig rig_of_model(YkModel *model, YkProblems *problems)
{
    Rig rig = {.model = model, .problems = problems};
    if (!model)
        for (size_t k = 0; k < yk_problems_count(problems); k++)
            print_error("%s\n", yk_problems_get(problems, k)->message);
    assert_non_null(model);
    rig.mech = yk_mechanism_compile(model, NULL, problems);
    assert_non_null(rig.mech);
    rig.state = yk_state_new(rig.mech);
    assert_non_null(rig.state);
    assert_true(yk_state_assemble(rig.state) >= 0);
    rig.dynamics = yk_dynamics_new(rig.mech, problems);
    assert_non_null(rig.dynamics);
    return rig;
}

static inline Rig rig_of_text(const char *text)
{
    YkProblems *problems = yk_problems_new();
    return rig_of_model(yk_model_parse(text, strlen(text), "test.yaml", NULL, problems), problems);
}

static inline Rig rig_of_example(const char *name)
{
    char path[512];
    YkProblems *problems = yk_problems_new();
    snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, name);
    return rig_of_model(yk_model_load(path, NULL, problems), problems);
}

static inline void rig_free(Rig *rig)
{
    yk_dynamics_free(rig->dynamics);
    yk_state_free(rig->state);
    yk_mechanism_free(rig->mech);
    yk_model_free(rig->model);
    yk_problems_free(rig->problems);
}

static inline YkChannel rig_channel(const YkMechanism *mech, const char *name)
{
    YkChannel channel = {0};
    assert_int_equal(yk_channel_parse(mech, name, &channel, NULL), YK_OK);
    return channel;
}

// Moves every input by at most this much (rad, or sizes of the machine), with rates and accelerations up to those.
static inline void rig_move(Rig *rig, uint64_t *seed, double position, double rate, double acceleration)
{
    for (size_t i = 0; i < rig->mech->input_count; i++) {
        YkMotion m = yk_state_input(rig->state, i);
        double scale = rig->mech->coordinates[rig->mech->inputs[i]].is_distance ? rig->mech->size : 1;
        m.position += scale * check_uniform(seed, -position, position);
        m.velocity = scale * check_uniform(seed, -rate, rate);
        m.acceleration = scale * check_uniform(seed, -acceleration, acceleration);
        yk_state_set_input(rig->state, i, m);
    }
}

// Moves every input a little from the start, with rates, and solves; false where it does not close there.
static inline bool rig_shake(Rig *rig, uint64_t *seed)
{
    rig_move(rig, seed, 0.2, 2, 3);
    return yk_state_solve(rig->state) >= 0 && yk_state_has_rates(rig->state) && rig->state->space.margin[0] > 1e-3;
}

// Examples with masses.
static const char *const rig_examples[] = {"toggle",           "double-pendulum",
                                           "andrews",          "n-four-bar",
                                           "rocking-four-bar", "spring-slider-crank",
                                           "steam-engine",     "gas-engine",
                                           "five-bar-motors",  "cart-pendulum",
                                           "crank-press",      "watt-with-masses",
                                           "car-axis",         "chain"};
enum { RIG_EXAMPLES = sizeof rig_examples / sizeof *rig_examples };

// Cheap and strict: the balance of every body; and what loads and inertia do in the motion, in which joints, gears,
// racks and cams do no work.
static inline void rig_check_balance(const Rig *rig, double allowed, double loose, uint64_t machine)
{
    const YkDynamics *d = rig->dynamics;
    double off = 0, sum = d->largest_force * rig->mech->size;
    for (size_t b = 1; b < yk_model_body_count(rig->model); b++) {
        const YkBody *body = &rig->mech->model->bodies[b];
        const YkBodyMotion *m = &d->motion[b];
        double inertia = body->mass * yk_dot(m->velocity, m->acceleration) + body->inertia * m->w * m->a;
        double loads = yk_dot(d->load[b].force, m->velocity) + d->load[b].moment * m->w;
        off += inertia - loads;
        sum += fabs(inertia) + fabs(loads);
        double residual = yk_dynamics_balance(d, b).residual;
        if (!(residual <= allowed * loose)) print_error("machine %lu:\n", (unsigned long)machine);
        CHECK_NEAR(residual, 0, allowed * loose);
    }
    CHECK_NEAR(off, 0, allowed * loose * sum);
}

#endif
