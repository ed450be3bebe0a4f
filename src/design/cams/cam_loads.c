// Collects the loads on a follower along its coordinate: springs, efforts, weight.
#include "design/cams/cam.h"
#include "elementary/elementary.h"
#include "model/formulas.h"

enum { TIME, LIFT, LIFT_RATE, CAM, CAM_RATE, VARIABLES };

// An effort along the coordinate: a formula, or a law of a formula.
typedef struct YkCamEffort {
    YkFormula *formula;
    const YkLaw *law; // NULL: the formula is the effort
    double sign;      // -1: it pulls back, as a spring
} YkCamEffort;

static int32_t coordinate_of(const YkCamDesign *design, bool is_follower)
{
    const YkCam *cam = design->cam;
    const YkJoint *joint = &design->model->joints[is_follower ? cam->follower_joint : cam->cam_joint];
    return is_follower && !cam->oscillates ? joint->distance : joint->angle;
}

static int variable_of(void *context, int32_t coordinate, bool is_rate)
{
    const YkCamDesign *design = context;
    if (coordinate == coordinate_of(design, true)) return is_rate ? LIFT_RATE : LIFT;
    if (coordinate == coordinate_of(design, false)) return is_rate ? CAM_RATE : CAM;
    return -1;
}

static void add_effort(YkCamDesign *design, const YkStrength *strength, double sign)
{
    const YkModel *model = design->model;
    YkCamEffort *own = &design->load.efforts[design->load.effort_count];
    if (!strength->expr) return;
    own->formula = yk_model_formula(model, strength->expr, variable_of, design, design->arena);
    own->law = strength->law == YK_NONE ? NULL : model->laws[strength->law].law;
    own->sign = sign;
    if (own->formula)
        design->load.effort_count++;
    else
        design->loads.is_partial = true; // it depends on other motions
}

static void add_springs(YkCamDesign *design)
{
    const YkModel *model = design->model;
    for (size_t i = 0; i < model->spring_count; i++) {
        const YkSpring *spring = &model->springs[i];
        int32_t follower = design->cam->follower;
        if (spring->coordinate == YK_NONE) {
            if (spring->body[0] == follower || spring->body[1] == follower) design->loads.is_partial = true;
        } else if (spring->coordinate == coordinate_of(design, true)) {
            design->loads.has_spring = true;
            design->load.stiffness += spring->stiffness;
            design->load.damping += spring->damping;
            design->loads.preload -= spring->stiffness * spring->length;
            add_effort(design, &spring->force, -1);
        }
    }
}

static void add_efforts(YkCamDesign *design)
{
    const YkModel *model = design->model;
    for (size_t i = 0; i < model->effort_count; i++)
        if (model->efforts[i].coordinate == coordinate_of(design, true))
            add_effort(design, &model->efforts[i].strength, 1);
}

// Adds the weight: a constant for a follower that slides, a moment for one that turns. The carrier must stand still.
static void add_weight(YkCamDesign *design)
{
    const YkModel *model = design->model;
    const YkCam *cam = design->cam;
    const YkBody *body = &model->bodies[cam->follower];
    const YkJoint *pin = &model->joints[cam->follower_joint];
    if (!model->has_gravity || !body->has_mass) return;
    if (cam->carrier != 0) {
        design->loads.is_partial = true;
        return;
    }
    if (!cam->oscillates) {
        design->load.constant = -body->mass * yk_dot(model->gravity, cam->along);
        return;
    }
    int side = pin->body[0] == cam->follower ? 0 : 1;
    YkVec center = yk_sub(body->center, pin->at[side]);
    double turned = 0; // of the body at lift 0: its arm lies where the cam holds it
    if (cam->point != YK_NONE) {
        YkVec arm = yk_sub(model->points[cam->point].at, pin->at[side]);
        turned = design->shape.start - yk_atan2(arm.y, arm.x);
    }
    // The moment of the weight m g on the lever c exp(i a) is m |c| |g| sin(gamma - a) = ... cos(a - gamma + pi/2).
    design->load.weight = body->mass * yk_norm(center) * yk_norm(model->gravity);
    design->load.center =
        turned + yk_atan2(center.y, center.x) - yk_atan2(model->gravity.y, model->gravity.x) + YK_PI / 2;
}

static void add_inertia(YkCamDesign *design)
{
    const YkModel *model = design->model;
    const YkCam *cam = design->cam;
    const YkBody *body = &model->bodies[cam->follower];
    const YkJoint *joint = &model->joints[cam->follower_joint];
    if (!body->has_mass) return;
    YkVec center = yk_sub(body->center, joint->at[joint->body[0] == cam->follower ? 0 : 1]);
    design->loads.has_mass = true;
    design->load.inertia = cam->oscillates ? body->inertia + body->mass * yk_dot(center, center) : body->mass;
}

// Returns whether there are loads that this quasi-rigid model leaves out.
static bool has_others(const YkCamDesign *design)
{
    const YkModel *model = design->model;
    const YkCam *cam = design->cam;
    for (size_t i = 0; i < model->force_count; i++)
        if (model->forces[i].body == cam->follower) return true;
    for (size_t i = 0; i < model->joint_count; i++) {
        const YkJoint *joint = &model->joints[i];
        if ((int32_t)i != cam->follower_joint && (joint->body[0] == cam->follower || joint->body[1] == cam->follower))
            return true;
    }
    return false;
}

bool yk_cam_gather_loads(YkCamDesign *design)
{
    design->load = (YkCamLoad){0};
    design->loads = (YkCamLoads){.is_partial = has_others(design)};
    size_t most = design->model->effort_count + design->model->spring_count;
    design->load.efforts = YK_NEW(design->arena, YkCamEffort, most + 1);
    if (!design->load.efforts) return false;
    add_inertia(design);
    add_springs(design);
    add_efforts(design);
    add_weight(design);
    design->loads.inertia = design->load.inertia;
    design->loads.stiffness = design->load.stiffness;
    design->loads.damping = design->load.damping;
    return !yk_arena_failed(design->arena);
}

YkCamLoads yk_cam_loads(const YkCamDesign *design)
{
    return design->loads;
}

static double efforts_at(const YkCamDesign *design, double speed, const YkCamSample *at)
{
    double sum = 0, d[YK_LAW_ORDER + 1];
    double variables[VARIABLES] = {[TIME] = speed != 0 ? (at->angle - design->phase) / speed : 0,
                                   [LIFT] = at->lift[0],
                                   [LIFT_RATE] = at->lift[1] * speed,
                                   [CAM] = at->angle,
                                   [CAM_RATE] = speed};
    for (size_t i = 0; i < design->load.effort_count; i++) {
        const YkCamEffort *effort = &design->load.efforts[i];
        double value = yk_formula_eval(effort->formula, variables);
        if (effort->law) {
            yk_law_eval(effort->law, value, d);
            value = d[0];
        }
        sum += effort->sign * value;
    }
    return sum;
}

double yk_cam_static_effort(const YkCamDesign *design, double speed, const YkCamSample *at)
{
    const YkCamLoad *load = &design->load;
    double swing = design->cam->swing, s = at->lift[0];
    double weight = load->weight * swing * yk_cos(load->center + swing * s); // moment along the coordinate
    return load->stiffness * s + design->loads.preload + load->constant - weight - efforts_at(design, speed, at);
}
