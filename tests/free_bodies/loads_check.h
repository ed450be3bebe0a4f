// Loads for tests, made by hand, and a machine with its free bodies.
#ifndef TESTS_DYNAMICS_LOADS_CHECK_H
#define TESTS_DYNAMICS_LOADS_CHECK_H
#include "free_bodies/inside.h"
#include "solve/machine.h"

typedef struct Rig {
    Machine m;
    YkFreeBodies *bodies;
    YkLoad *load;
    double accelerations[64];
    bool is_prescribed[64];
} Rig;

// y += factor * wrench, on the rows of its bodies.
static inline void wrench_add(const YkFreeBodies *f, const YkWrenchColumn *c, double factor, double *y)
{
    for (int k = 0; k < 2; k++) {
        if (c->body[k] == 0) continue;
        double *row = y + f->body_row[c->body[k]], sign = k ? factor : -factor;
        row[0] += sign * c->force.x;
        row[1] += sign * c->force.y;
        row[2] += factor * c->moment[k];
    }
    const int32_t others[] = {c->third, c->fourth};
    for (int k = 0; k < 2; k++) {
        if (others[k] == 0) continue;
        double *row = y + f->body_row[others[k]], sign = k ? -factor : factor;
        row[0] += sign * c->other.x;
        row[1] += sign * c->other.y;
        row[2] += factor * (k ? c->fourth_moment : c->third_moment);
    }
}

// What the shares of a part leave of every balance. What was not solved does not count.
static inline void part_imbalance(const YkFreeBodies *f, const YkBodyPart *part, double *worst, double *largest)
{
    double *sum = calloc(3 * part->body_count + 1, sizeof *sum);
    bool is_solved = part->column_count == 0;
    assert_non_null(sum);
    for (size_t k = 0; k < part->column_count; k++) {
        const YkWrenchColumn *c = &f->columns[part->columns[k]];
        is_solved |= c->share != 0 || c->freeness != 1;
        wrench_add(f, c, c->share, sum);
        *largest = fmax(*largest, fabs(c->share));
    }
    for (size_t i = 0; i < 3 * part->body_count && is_solved; i++) {
        size_t at = 3 * (size_t)part->bodies[i / 3] + i % 3;
        *worst = fmax(*worst, fabs(f->inertia[at] - f->load[at] - sum[i]));
        *largest = fmax(*largest, fmax(fabs(f->inertia[at]), fabs(f->load[at])));
    }
    free(sum);
}
// The largest residual of any body's equations over the largest force (moments over the machine's size).
static inline double imbalance_of(const YkFreeBodies *f)
{
    double worst = 0, largest = 0;
    for (size_t p = 0; p < f->part_count; p++) part_imbalance(f, &f->parts[p], &worst, &largest);
    return largest > 0 ? worst / largest : 0;
}

static inline Rig rig_of(Machine m)
{
    Rig r = {.m = m, .bodies = yk_free_bodies_new(m.mech)};
    r.load = calloc(m.model->body_count, sizeof *r.load);
    assert_true(r.bodies && r.load && m.mech->input_count <= 64);
    for (size_t i = 0; i < m.mech->input_count; i++) r.accelerations[i] = yk_state_input(m.state, i).acceleration;
    return r;
}
static inline Rig rig_parse(const char *text)
{
    return rig_of(machine_parse(text, true));
}
static inline void rig_free(Rig *r)
{
    yk_free_bodies_free(r->bodies);
    free(r->load);
    machine_free(&r->m);
}

// Sets input i and solves the pose.
static inline void rig_move(Rig *r, size_t input, double position, double rate, double accel)
{
    yk_state_set_input(r->m.state, input, (YkMotion){position, rate, accel});
    assert_true(yk_state_solve(r->m.state) >= 0);
}

static inline void load_clear(Rig *r)
{
    for (size_t b = 0; b < r->m.model->body_count; b++) r->load[b] = (YkLoad){{0, 0}, 0};
}
static inline void load_gravity(Rig *r, YkVec g)
{
    for (size_t b = 1; b < r->m.model->body_count; b++)
        if (r->m.model->bodies[b].has_mass)
            r->load[b].force = yk_add(r->load[b].force, yk_scale(r->m.model->bodies[b].mass, g));
}

// Where a point given in a body's axes is, from the answers of the state.
static inline YkVec place_of(const Rig *r, size_t body, YkVec at)
{
    YkBodyMotion m = yk_body_motion(r->m.mech, &r->m.state->space, body);
    return yk_add(m.at, yk_mul(m.e, yk_sub(at, yk_reference_point(r->m.model, body))));
}

// A force at a place of the world, on a body.
static inline void load_force(Rig *r, size_t body, YkVec place, YkVec force)
{
    YkBodyMotion m = yk_body_motion(r->m.mech, &r->m.state->space, body);
    r->load[body].force = yk_add(r->load[body].force, force);
    r->load[body].moment += yk_cross(yk_sub(place, m.at), force);
}

// An effort along a joint's freedom, on its second body, and its reaction on the first.
static inline void load_effort(Rig *r, int32_t joint, bool is_distance, double effort)
{
    const YkJoint *j = &r->m.model->joints[joint];
    for (int k = 0; k < 2; k++) {
        double signed_effort = k ? effort : -effort;
        if (j->body[k] == 0) continue;
        if (!is_distance) {
            r->load[j->body[k]].moment += signed_effort;
            continue;
        }
        YkBodyMotion a = yk_body_motion(r->m.mech, &r->m.state->space, (size_t)j->body[0]);
        load_force(r, (size_t)j->body[k], place_of(r, (size_t)j->body[1], j->at[1]),
                   yk_scale(signed_effort, yk_mul(a.e, j->along)));
    }
}
static inline void load_input(Rig *r, size_t input, double effort)
{
    const YkTreeCoordinate *c = &r->m.mech->coordinates[r->m.mech->inputs[input]];
    load_effort(r, c->joint, c->is_distance, effort);
}

static inline YkStatus rig_inverse(Rig *r)
{
    return yk_free_bodies_inverse(r->bodies, &r->m.state->space, r->load, false);
}
static inline YkStatus rig_forward(Rig *r, int *culprit)
{
    return yk_free_bodies_forward(r->bodies, &r->m.state->space, r->load, r->is_prescribed, r->accelerations, culprit);
}
// Takes the accelerations found into the pose.
static inline void rig_accelerate(Rig *r)
{
    for (size_t i = 0; i < r->m.mech->input_count; i++) {
        YkMotion q = yk_state_input(r->m.state, i);
        q.acceleration = r->accelerations[i];
        yk_state_set_input(r->m.state, i, q);
    }
    assert_true(yk_state_solve(r->m.state) >= 0);
}

static inline size_t joint_named(const Rig *r, const char *name)
{
    for (size_t j = 0; j < r->m.model->joint_count; j++)
        if (strcmp(r->m.model->joints[j].name, name) == 0) return j;
    fail();
    return 0;
}
static inline YkJointForce reaction(const Rig *r, const char *name)
{
    return yk_free_bodies_joint(r->bodies, joint_named(r, name));
}
static inline size_t body_named(const Rig *r, const char *name)
{
    for (size_t b = 0; b < r->m.model->body_count; b++)
        if (strcmp(r->m.model->bodies[b].name, name) == 0) return b;
    fail();
    return 0;
}

#define CHECK_VEC(v, at_x, at_y, tolerance)                                                                            \
    do {                                                                                                               \
        YkVec check_v = (v);                                                                                           \
        CHECK_NEAR(check_v.x, at_x, tolerance);                                                                        \
        CHECK_NEAR(check_v.y, at_y, tolerance);                                                                        \
    } while (0)

#endif
