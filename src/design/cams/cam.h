// The geometry of cams, as pure functions of a law and dimensions.
//
// The cam's centre is the origin, vectors are complex numbers, theta is the cam's angle and sigma = +-1 the sense in
// which it turns. A point C(theta) of the carrier lies at c = exp(-i sigma theta) C in the cam's axes. A roller or edge
// follows C(theta): c is the pitch curve, and the surface is its parallel curve at the roller's radius. A flat face is
// a line at distance h(theta) whose normal has the angle nu(theta): the surface is the envelope of these lines, with h
// as its support function over phi = nu - sigma theta.
#ifndef DESIGN_CAM_H
#define DESIGN_CAM_H
#include <yoke/cam.h>
#include "base/vec.h"
#include "model/model.h"

typedef struct YkCamShape {
    YkCamFace face;
    bool oscillates;
    double turn;         // sigma
    double swing;        // +1: an oscillating follower turns counterclockwise where it leaves the cam
    double sign;         // +1; -1 for a follower that approaches the cam as the lift grows
    double base, roller; // m
    double offset;       // translating: of the line of motion towards -i along; flat oscillating: of the face from the
                         // pivot towards the cam
    double arm;          // oscillating
    YkVec along;         // translating: unit direction of motion
    YkVec pivot;         // oscillating, from the cam's centre
    double start;        // at lift 0: distance along the line of motion, or angle of the arm or of the face's normal
} YkCamShape;

// Sets `start` so that the follower touches the base circle at lift 0, on the side from which the lift leads away.
// Returns false if it cannot touch it.
bool yk_cam_shape_fit(YkCamShape *shape);
YkCamShape yk_cam_shape_of(const YkCam *cam);
// Returns the second roller of a conjugate pair, rigidly behind the first.
YkCamShape yk_cam_shape_second(const YkCamShape *first, const YkCam *cam);
// Returns the cam at an angle where the law's values are lift[0], lift[1], ...
YkCamPoint yk_cam_shape_at(const YkCamShape *shape, double angle, const double lift[YK_LAW_ORDER + 1]);

// The law over one period, in stretches without jumps.
typedef struct YkCamSample {
    double angle, lift[YK_LAW_ORDER + 1];
} YkCamSample;
typedef struct YkCamSamples {
    const YkLaw *law;
    YkCamSample *items;
    size_t count;
    size_t *first; // [stretch_count + 1]: where each begins in items
    size_t stretch_count;
} YkCamSamples;
// Samples the law. Returns false when out of memory.
bool yk_cam_samples_take(YkCamSamples *samples, const YkLaw *law, YkArena *arena);

// A measure: a number computed from one pose of the cam.
typedef double (*YkCamMeasure)(const YkCamPoint *point, const void *context);
// Finds the greatest value over a period, by samples and golden sections round those near the top. The value is
// -INFINITY if the measure is never above that.
YkCamExtreme yk_cam_greatest(const YkCamSamples *samples, const YkCamShape *shape, YkCamMeasure measure,
                             const void *context);
// Returns whether a sample of the measure is above zero. Tries number *where first, and leaves there which it found.
bool yk_cam_is_above_zero(const YkCamSamples *samples, const YkCamShape *shape, YkCamMeasure measure,
                          const void *context, size_t *where);
// Finds the ranges in which the measure is negative, with ends to rounding. Returns their count.
size_t yk_cam_negative(const YkCamSamples *samples, const YkCamShape *shape, YkCamMeasure measure, const void *context,
                       YkCamRange *ranges, size_t capacity);
YkCamSummary yk_cam_summarize(const YkCamSamples *samples, const YkCamShape *shape);

// Makes the next derivative's factor infinite where the law jumps within a stroke. period 0: the law does not repeat.
void yk_cam_count_jumps(const YkLaw *law, double from, double to, double period, YkCamFactors *factors);

// Loads on the follower: the cam's effort is inertia * acceleration plus the effort that the loads need.
typedef struct YkCamLoad {
    double inertia, stiffness, damping;
    double constant;       // against the lift, at lift 0: preload less what presses the other way
    double weight, center; // oscillating: gravity's moment is weight cos(coordinate + center); weight 0: none
    struct YkCamEffort *efforts;
    size_t effort_count;
} YkCamLoad;

struct YkCamDesign {
    const YkModel *model;
    const YkCam *cam;
    const YkModelLaw *law;
    YkCamShape shape, second;
    YkCamSamples samples;
    double speed; // of the cam, rad/s; 0: not known
    double phase; // the cam's angle at t = 0
    YkCamLoads loads;
    YkCamLoad load;
    YkArena *arena;
};
// Collects the loads on the follower (cam_loads.c). Returns false when out of memory.
bool yk_cam_gather_loads(YkCamDesign *design);
// Returns the effort that the cam must give along the coordinate, from the terms that do not grow with speed.
double yk_cam_static_effort(const YkCamDesign *design, double speed, const YkCamSample *at);
// cam_law.c
double yk_cam_law_lift(const YkLaw *law, double angle);

#endif
