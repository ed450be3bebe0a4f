// The gap between a follower and its cam, and the force of their contact as terms of the equations.
#include "law/law.h"
#include "simulate/contact.h"

static YkMotion motion_of(const YkSimulation *sim, YkChannelKind kind, int32_t joint)
{
    YkChannel value = {.kind = kind, .index = joint}, rate = {.kind = kind, .index = joint, .order = 1};
    return (YkMotion){yk_state_channel(sim->state, value), yk_state_channel(sim->state, rate), 0};
}

static double slope_of(const YkSimulation *sim, const YkCam *cam, double angle, double *lift)
{
    double d[YK_LAW_ORDER + 1];
    yk_law_eval(sim->model->laws[cam->law].law, angle, d);
    *lift = d[0];
    return d[1];
}

YkMotion yk_simulation_gap(const YkSimulation *sim, size_t index)
{
    const YkCam *cam = &sim->model->cams[index];
    YkMotion follower =
        motion_of(sim, cam->oscillates ? YK_CHANNEL_JOINT_ANGLE : YK_CHANNEL_JOINT_DISTANCE, cam->follower_joint);
    YkMotion shaft = motion_of(sim, YK_CHANNEL_JOINT_ANGLE, cam->cam_joint);
    double way = sim->flights[index].way, lift, slope = slope_of(sim, cam, shaft.position, &lift);
    return (YkMotion){way * (follower.position - lift), way * (follower.velocity - slope * shaft.velocity), 0};
}

size_t yk_simulation_cam_terms(const YkSimulation *sim, size_t index, YkContactTerm term[2])
{
    const YkCam *cam = &sim->model->cams[index];
    const YkMechanism *mech = sim->mech;
    YkJointAngle shaft = yk_joint_angle(mech, cam->cam_joint), own = yk_joint_angle(mech, cam->follower_joint);
    double angle = motion_of(sim, YK_CHANNEL_JOINT_ANGLE, cam->cam_joint).position, lift;
    double way = sim->flights[index].way, slope = slope_of(sim, cam, angle, &lift);
    if (!cam->oscillates)
        own = (YkJointAngle){.b = yk_unknown_of_distance(mech, mech->joint_distance[cam->follower_joint]), .a = 0};
    term[0] = (YkContactTerm){own.b, own.a, way};
    term[1] = (YkContactTerm){shaft.b, shaft.a, -way * slope};
    return 2;
}
