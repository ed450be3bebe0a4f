// Contact force, camshaft torque and jump speed at constant speed. Source: Norton 2009, ch. 8-9 (kinetostatics,
// follower jump); the torque by the power balance.
#include <math.h>
#include "design/cams/cam.h"
#include "elementary/elementary.h"

static double effort_at(const YkCamDesign *design, double speed, const YkCamSample *at)
{
    const YkCamLoad *load = &design->load;
    return load->inertia * at->lift[2] * speed * speed + load->damping * at->lift[1] * speed +
           yk_cam_static_effort(design, speed, at);
}

// Returns the effort along the coordinate over the normal force: the velocity of the contact along the normal per lift.
static double lever(const YkCamShape *shape, const YkCamPoint *point)
{
    if (!shape->oscillates) return shape->sign * yk_cos(point->pressure_angle);
    if (shape->face == YK_CAM_FACE_FLAT) return point->reach;
    return shape->sign * shape->arm * yk_cos(point->pressure_angle);
}

// Returns the force of the roller that bears, negative if it is the second of a pair.
static double contact_at(const YkCamDesign *design, double effort, const YkCamPoint *point)
{
    if (!design->cam->is_conjugate || design->shape.sign * effort >= 0) return effort / lever(&design->shape, point);
    YkCamPoint second = yk_cam_shape_at(&design->second, point->angle, point->lift);
    return -effort / lever(&design->second, &second);
}

static YkCamForce force_at(const YkCamDesign *design, double speed, const YkCamPoint *point)
{
    YkCamSample sample = {.angle = point->angle};
    for (int k = 0; k <= YK_LAW_ORDER; k++) sample.lift[k] = point->lift[k];
    double effort = effort_at(design, speed, &sample);
    return (YkCamForce){effort, contact_at(design, effort, point), effort * point->lift[1]};
}

YkCamForce yk_cam_force(const YkCamDesign *design, double speed, double angle)
{
    YkCamPoint point = yk_cam_at(design, angle);
    return force_at(design, speed, &point);
}

typedef struct Case {
    const YkCamDesign *design;
    double speed, sign;
} Case;

static double contact(const YkCamPoint *point, const void *context)
{
    const Case *of = context;
    return of->sign * force_at(of->design, of->speed, point).contact;
}

static double torque(const YkCamPoint *point, const void *context)
{
    const Case *of = context;
    return of->sign * force_at(of->design, of->speed, point).torque;
}

// Measures the effort by which the cam pushes the follower away.
static double effort(const YkCamPoint *point, const void *context)
{
    const Case *of = context;
    return of->sign * of->design->shape.sign * force_at(of->design, of->speed, point).effort;
}

static YkCamExtreme extreme(const YkCamDesign *design, YkCamMeasure measure, double speed, double sign)
{
    Case of = {design, speed, sign};
    YkCamExtreme found = yk_cam_greatest(&design->samples, &design->shape, measure, &of);
    found.value *= sign;
    return found;
}

// Integrates each stretch by Simpson's rule.
static double mean_torque(const YkCamDesign *design, double speed)
{
    const YkCamSamples *samples = &design->samples;
    double sum = 0, span = 0;
    for (size_t i = 0; i + 1 < samples->count; i++) {
        const YkCamSample *a = &samples->items[i], *b = a + 1;
        double width = b->angle - a->angle, middle[YK_LAW_ORDER + 1];
        YkCamSample half = {.angle = a->angle + width / 2};
        if (!(width > 1e-9)) continue; // from stretch to stretch
        yk_law_eval(samples->law, half.angle, middle);
        for (int k = 0; k <= YK_LAW_ORDER; k++) half.lift[k] = middle[k];
        sum += width / 6 *
               (effort_at(design, speed, a) * a->lift[1] + 4 * effort_at(design, speed, &half) * half.lift[1] +
                effort_at(design, speed, b) * b->lift[1]);
        span += width;
    }
    return span > 0 ? sum / span : 0;
}

enum { DOUBLINGS = 30, BISECTIONS = 60 };

// Finds the lowest speed at which the effort falls to zero somewhere. A groove or second cam holds the follower anyway.
static void find_jump(const YkCamDesign *design, YkCamForceSummary *summary)
{
    double low = 0, high = 1;
    summary->jump_speed = INFINITY;
    if (design->cam->is_groove || design->cam->is_conjugate || !design->loads.has_mass) return;
    YkCamExtreme worst = extreme(design, effort, 0, -1);
    summary->jump_angle = worst.angle;
    if (worst.value < 0 || (worst.value == 0 && extreme(design, effort, 1e-3, -1).value < 0)) {
        summary->jump_speed = 0;
        return;
    }
    for (int i = 0; i < DOUBLINGS && extreme(design, effort, high, -1).value > 0; i++) {
        low = high;
        high *= 2;
    }
    if (extreme(design, effort, high, -1).value > 0) return;
    for (int i = 0; i < BISECTIONS && high - low > 1e-14 * high; i++) {
        double middle = low + (high - low) / 2;
        YkCamExtreme there = extreme(design, effort, middle, -1);
        if (there.value > 0) {
            low = middle;
        } else {
            high = middle;
            summary->jump_angle = there.angle;
        }
    }
    summary->jump_speed = high;
}

YkCamForceSummary yk_cam_force_summary(const YkCamDesign *design, double speed)
{
    YkCamForceSummary summary = {.contact_low = extreme(design, contact, speed, -1),
                                 .contact_high = extreme(design, contact, speed, 1),
                                 .torque_low = extreme(design, torque, speed, -1),
                                 .torque_high = extreme(design, torque, speed, 1)};
    summary.torque_mean = mean_torque(design, speed);
    summary.preload_needed = design->loads.preload - design->shape.sign * extreme(design, effort, speed, -1).value;
    find_jump(design, &summary);
    return summary;
}
