// Decides what is rounding noise, by the largest values written beside it.
#include "scale.h"
#include <math.h>
#include "session.h"
#include "elementary/elementary.h"

// Relative to the scale: what closing loops and adding vectors leave of a zero; what sums and products alone leave.
static const double noise = 1e-13, noise_of_sums = 1e-15;

static void raise_to(double *scale, double value)
{
    if (isfinite(value) && fabs(value) > *scale) *scale = fabs(value);
}

void yk_scale_begin(YkSession *session)
{
    session->scale = (YkScale){.is_exact = session->mech && yk_loop_count(session->mech) == 0};
    if (session->model) session->scale.mass = yk_model_loads(session->model).mass;
}

static double size_of(const YkSession *session)
{
    return session->mech ? yk_mechanism_size(session->mech) : 1;
}

void yk_scale_add(YkSession *session, double value, YkQuantity quantity)
{
    YkScale *scale = &session->scale;
    double size = size_of(session);
    switch (quantity) {
    case YK_QUANTITY_ANGLE_RATE:
        raise_to(&scale->rate, value);
        break;
    case YK_QUANTITY_SPEED:
        raise_to(&scale->rate, value / size);
        break;
    case YK_QUANTITY_ANGLE_ACCELERATION:
        raise_to(&scale->acceleration, value);
        break;
    case YK_QUANTITY_ACCELERATION:
        raise_to(&scale->acceleration, value / size);
        break;
    case YK_QUANTITY_FORCE:
        raise_to(&scale->force, value);
        break;
    case YK_QUANTITY_TORQUE:
        raise_to(&scale->force, value / size);
        break;
    case YK_QUANTITY_ENERGY:
        raise_to(&scale->energy, value);
        break;
    default:
        break;
    }
}

static void add_motion(YkSession *session, YkMotion motion, bool is_distance)
{
    yk_scale_add(session, motion.velocity, is_distance ? YK_QUANTITY_SPEED : YK_QUANTITY_ANGLE_RATE);
    yk_scale_add(session, motion.acceleration, is_distance ? YK_QUANTITY_ACCELERATION : YK_QUANTITY_ANGLE_ACCELERATION);
}

static void add_wrench(YkSession *session, const double force[2], double moment)
{
    yk_scale_add(session, yk_hypot(force[0], force[1]), YK_QUANTITY_FORCE);
    yk_scale_add(session, moment, YK_QUANTITY_TORQUE);
}

static void add_forces(YkSession *session)
{
    const YkDynamics *dynamics = session->dynamics;
    double load = 0; // over the mass of all bodies: that of a light one held fast says nothing of the others
    for (size_t j = 0; j < yk_model_joint_count(session->model); j++) {
        YkReaction r = yk_dynamics_reaction(dynamics, j);
        add_wrench(session, r.force, r.moment);
    }
    for (size_t k = 0; k < yk_dynamics_contact_count(dynamics); k++) {
        YkReaction r = yk_dynamics_contact(dynamics, k);
        add_wrench(session, r.force, r.moment);
    }
    for (size_t b = 1; b < yk_model_body_count(session->model); b++) {
        YkBalance balance = yk_dynamics_balance(dynamics, b);
        add_wrench(session, balance.loads.force, balance.loads.moment);
        add_wrench(session, balance.inertia.force, balance.inertia.moment);
        load += yk_hypot(balance.loads.force[0], balance.loads.force[1]);
    }
    if (session->scale.mass > 0) yk_scale_add(session, load / session->scale.mass, YK_QUANTITY_ACCELERATION);
}

void yk_scale_of_bodies(YkSession *session, size_t one, size_t other)
{
    const size_t bodies[] = {one, other};
    session->scale.own = 0;
    for (size_t k = 0; k < 2 && session->dynamics; k++) {
        double mass = bodies[k] > 0 ? yk_model_body_mass(session->model, bodies[k]) : 0;
        if (mass <= 0) continue;
        YkWrench loads = yk_dynamics_balance(session->dynamics, bodies[k]).loads;
        raise_to(&session->scale.own, yk_hypot(loads.force[0], loads.force[1]) / mass / size_of(session));
    }
}

void yk_scale_add_bodies(YkSession *session, const YkState *state)
{
    if (!yk_state_has_rates(state)) return;
    const YkMotion *bodies = yk_session_bodies(session, state);
    for (size_t i = 1; bodies && i < yk_model_body_count(session->model); i++) add_motion(session, bodies[i], false);
    for (size_t i = 0; i < yk_model_point_count(session->model); i++) {
        YkPointMotion m = yk_state_point(state, i);
        yk_scale_add(session, yk_hypot(m.velocity[0], m.velocity[1]), YK_QUANTITY_SPEED);
        yk_scale_add(session, yk_hypot(m.acceleration[0], m.acceleration[1]), YK_QUANTITY_ACCELERATION);
    }
}

void yk_scale_add_inputs(YkSession *session, const YkState *state)
{
    for (size_t i = 0; i < yk_input_count(session->mech); i++)
        add_motion(session, yk_state_input(state, i),
                   yk_coordinate_info(session->mech, yk_input_coordinate(session->mech, i)).is_distance);
}

void yk_scale_add_pose(YkSession *session, const YkState *state)
{
    yk_scale_add_inputs(session, state); // known at dead points too
    if (!yk_state_has_rates(state)) return;
    if (yk_state_report(state)->status == YK_CHANGE_POINT) session->scale.blur = YK_BLUR_AT_CHANGE_POINT;
    for (size_t i = 0; i < yk_coordinate_count(session->mech); i++)
        add_motion(session, yk_state_coordinate(state, i), yk_coordinate_info(session->mech, i).is_distance);
    yk_scale_add_bodies(session, state);
    if (session->dynamics) add_forces(session);
}

static double usual_noise(const YkSession *session, YkQuantity quantity)
{
    const YkScale *scale = &session->scale;
    double size = size_of(session), of_angles = scale->is_exact ? noise_of_sums : noise;
    double acceleration = fmax(scale->acceleration, scale->rate * scale->rate); // centripetal ones are added too
    double force = fmax(noise * scale->force, noise_of_sums * scale->mass * acceleration * size);
    acceleration = fmax(acceleration, scale->own);
    switch (quantity) {
    case YK_QUANTITY_ANGLE:
        return of_angles;
    case YK_QUANTITY_LENGTH:
        return noise * size;
    case YK_QUANTITY_ANGLE_RATE:
        return of_angles * scale->rate;
    case YK_QUANTITY_SPEED:
        return noise * scale->rate * size;
    case YK_QUANTITY_ANGLE_ACCELERATION:
        return of_angles * acceleration;
    case YK_QUANTITY_ACCELERATION:
        return noise * acceleration * size;
    case YK_QUANTITY_FORCE:
        return force;
    case YK_QUANTITY_TORQUE:
        return force * size;
    case YK_QUANTITY_ENERGY: // a potential is a sum of weights times heights
        return noise_of_sums * fmax(scale->energy, scale->force * size);
    default:
        return 0;
    }
}

double yk_scale_noise(const YkSession *session, YkQuantity quantity)
{
    bool is_position = quantity == YK_QUANTITY_ANGLE || quantity == YK_QUANTITY_LENGTH;
    double blur = session->scale.blur > 0 && !is_position ? session->scale.blur : 1;
    return blur * usual_noise(session, quantity);
}

double yk_scale_kinetic_noise(const YkSession *session)
{
    double speed = noise_of_sums * session->scale.rate * size_of(session);
    return session->scale.mass * speed * speed;
}
