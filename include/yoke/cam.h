// Cams: the motion program of a law, the profile that produces it, and the results that a designer needs from both.
//
// A cam is pinned to a carrier (the ground or another body) that also guides the follower: along a line (translating)
// or about a pin (oscillating). The law gives the follower's lift over the cam's angle, both as the joints measure
// them. All geometry is about the cam's centre, in the cam's own axes (profiles) or in the carrier's (contact).
// Sources: Norton 2009, Cam Design and Manufacturing Handbook, ch. 7-8; Rothbart 2004, Cam Design Handbook, ch. 3, 7;
// Angeles & Lopez-Cajun 1991, Optimization of Cam Mechanisms, ch. 2-4.
#ifndef YOKE_CAM_H
#define YOKE_CAM_H

#include <yoke/model.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum YkCamFace { YK_CAM_FACE_KNIFE, YK_CAM_FACE_ROLLER, YK_CAM_FACE_FLAT } YkCamFace;

typedef struct YkCamDesign YkCamDesign;

YK_API size_t yk_model_cam_count(const YkModel *model);
YK_API const char *yk_model_cam_name(const YkModel *model, size_t cam);
YK_API size_t yk_model_cam_find(const YkModel *model, const char *name); // YK_NOT_FOUND if there is none
YK_API const char *yk_cam_face_name(YkCamFace face);                     // "knife", "roller", "flat"

// Samples the law once. The model must outlive the design; use a design in one thread at a time. Returns NULL if the
// index is out of range or memory runs out.
YK_API YkCamDesign *yk_cam_design_new(const YkModel *model, size_t cam);
YK_API void yk_cam_design_free(YkCamDesign *design);

// The cam's data in the file; m, rad, rad/s.
typedef struct YkCamSize {
    const char *name, *law, *cam, *follower, *carrier; // names of the bodies
    YkCamFace face;
    bool oscillates; // lifts are then angles
    bool is_groove, is_conjugate;
    double base, roller, offset; // offset: of the line of motion, towards the side where the cam's rise pushes; of a
                                 // flat oscillating face: how far it lies from the pivot, towards the cam
    double arm, centers;         // of an oscillating follower; otherwise 0
    double turn;                 // +1: the cam turns counterclockwise as its angle grows, -1: clockwise
    double period;               // of the law, rad
    double speed;                // of the cam's coordinate, if a drive gives it at constant rate; otherwise 0
} YkCamSize;
YK_API YkCamSize yk_cam_size(const YkCamDesign *design);

// The cam at one angle. Lengths in m, angles in rad. Radii are positive where the cam is convex, negative where it is
// hollow, infinite where it is straight.
typedef struct YkCamPoint {
    double angle;
    double lift[5];        // s and its derivatives by the cam angle: v, a, j, p (m or rad per rad^k)
    double pressure_angle; // between the push on the follower and its motion; signed
    double pitch[2];       // cam's axes: the roller's centre or edge; of a flat face the point of contact
    double surface[2];     // cam's axes: the point of contact
    double normal[2];      // cam's axes: outward unit normal there
    double outer[2];       // cam's axes: the outer wall of a groove
    double contact[2];     // carrier's axes, from the cam's centre: the point of contact
    double pitch_radius;   // of curvature of the pitch curve
    double surface_radius; // of the cam's surface
    double fullness;       // 1 - roller / pitch radius; flat face: surface radius / base; negative: undercut
    double outer_fullness; // the same for the outer wall of a groove: 1 + roller / pitch radius
    double reach;          // flat face: where the contact lies along it, from the line of motion or the pivot's foot
} YkCamPoint;
// Returns the values just after `angle` where the law has a jump. Cost: O(log segments).
YK_API YkCamPoint yk_cam_at(const YkCamDesign *design, double angle);
// Does the same for the second cam of a conjugate pair, whose roller lies on the other side.
YK_API YkCamPoint yk_cam_conjugate_at(const YkCamDesign *design, double angle);

typedef struct YkCamExtreme {
    double value, angle; // at this cam angle, rad
} YkCamExtreme;
typedef struct YkCamRange {
    double from, to;
} YkCamRange; // cam angles, rad
enum { YK_CAM_RANGES_MAX = 16 };
// Extremes over a period, from samples (1440 a period, both sides of segment ends) refined to rounding.
typedef struct YkCamSummary {
    YkCamExtreme lift_low, lift_high;
    YkCamExtreme peak[5];                    // largest magnitude of s, v, a, j, p, with its sign
    YkCamExtreme pressure;                   // largest magnitude, with its sign
    YkCamExtreme pitch_convex, pitch_hollow; // smallest radius of curvature of either kind; infinite if there is none
    YkCamExtreme surface_convex, surface_hollow;
    YkCamExtreme reach_low, reach_high; // flat face
    YkCamExtreme far, near;             // largest and smallest distance of the surface from the cam's centre
    size_t undercut_count;              // ranges in which the surface is cut away; cusps at their ends
    YkCamRange undercut[YK_CAM_RANGES_MAX];
    size_t outer_undercut_count; // the same for a groove's outer wall
    YkCamRange outer_undercut[YK_CAM_RANGES_MAX];
} YkCamSummary;
YK_API YkCamSummary yk_cam_summary(const YkCamDesign *design);
YK_API YkCamSummary yk_cam_conjugate_summary(const YkCamDesign *design);

// The smallest base circle that keeps both limits, with everything else as in the file.
typedef struct YkCamLimits {
    double pressure;  // largest pressure angle, rad
    double curvature; // smallest convex radius of the surface, m; 0: no undercut
} YkCamLimits;
typedef struct YkCamBase {
    double base;      // m
    double angle;     // where the limiting quantity reaches its limit
    bool by_pressure; // the pressure angle limits it; otherwise the curvature
} YkCamBase;
YK_API YkCamLimits
yk_default_cam_limits(const YkCamDesign *design); // 30 deg translating, 35 deg oscillating; no undercut
// Finds the smallest base circle: searches the base radius from below (steps of 1 %) and bisects, with the extremes
// of the summary at each. Returns YK_OK, or YK_LIMIT if no base circle keeps the limits. Source: Rothbart 2004, ch. 7.
YK_API YkStatus yk_cam_smallest_base(const YkCamDesign *design, const YkCamLimits *limits, YkCamBase *base);

// The program: segments as the file gives them, and strokes (from rest to the next turning point).
typedef struct YkCamSegment {
    const char *kind; // "polynomial", "dwell", "rise", "formula", "arc", ...
    double from, to;  // cam angles, rad
    size_t condition_count;
    double condition_number; // of the linear system that was solved; 0 if none was
} YkCamSegment;
typedef struct YkCamCondition {
    double at;    // cam angle, rad
    int order;    // of the derivative of the lift by the cam angle
    double value; // m (or rad) / rad^order
} YkCamCondition;
YK_API size_t yk_cam_segment_count(const YkCamDesign *design);
YK_API YkCamSegment yk_cam_segment(const YkCamDesign *design, size_t segment);
YK_API YkCamCondition yk_cam_condition(const YkCamDesign *design, size_t segment, size_t condition);
// Finds jumps of s, v, a where segments join (fundamental law of cam design). Writes `capacity` of them at most.
// Returns how many there are.
typedef struct YkCamJump {
    double angle; // of the cam, rad
    int order;    // of the derivative that jumps
    double size;  // m (or rad) / rad^order
} YkCamJump;
YK_API size_t yk_cam_jumps(const YkCamDesign *design, YkCamJump *jumps, size_t capacity);

// Peak factors: |v| = Cv h / beta, |a| = Ca h / beta^2, |j| = Cj h / beta^3; infinite if a lower derivative jumps.
typedef struct YkCamFactors {
    double v, a, j;
} YkCamFactors;
typedef struct YkCamStroke {
    double from, to; // cam angles, rad
    double lift;     // m or rad; signed: a fall is negative
    YkCamFactors factors;
} YkCamStroke;
// Writes `capacity` of the strokes at most. Returns how many there are.
YK_API size_t yk_cam_strokes(const YkCamDesign *design, YkCamStroke *strokes, size_t capacity);
// Finds the factors of a law by its textbook name ("cycloidal", ...). Returns YK_BAD_ARGUMENT for an unknown one.
YK_API YkStatus yk_cam_law_factors(const char *law, YkCamFactors *factors);
// Returns the name of a law, counted from 0; NULL past the last one.
YK_API const char *yk_cam_law_name(size_t index);
// Returns the same cam with every stroke replaced by this law. Returns NULL when out of memory, or for a law that is
// unknown or cannot be built. Free it like any design, before the original.
YK_API YkCamDesign *yk_cam_design_with(const YkCamDesign *design, const char *law);

// Profiles as closed polylines: the first point is not repeated at the end.
typedef enum YkCamCurve {
    YK_CAM_CURVE_SURFACE,
    YK_CAM_CURVE_PITCH,
    YK_CAM_CURVE_OUTER,
    YK_CAM_CURVE_CUTTER,
    YK_CAM_CURVE_SECOND_SURFACE,
    YK_CAM_CURVE_SECOND_PITCH
} YkCamCurve;
typedef struct YkCamVertex {
    double angle, x, y;
} YkCamVertex; // cam angle, rad; cam's axes, m
// Computes a profile that deviates from the curve by at most `tolerance` (m). cutter: radius of the cutter for
// YK_CAM_CURVE_CUTTER. Free *vertices with yk_cam_vertices_free. Returns YK_OK, YK_BAD_ARGUMENT or YK_NO_MEMORY.
// Cost: O(points).
YK_API YkStatus yk_cam_profile(const YkCamDesign *design, YkCamCurve curve, double tolerance, double cutter,
                               YkCamVertex **vertices, size_t *count);
YK_API void yk_cam_vertices_free(YkCamVertex *vertices);

// Forces at constant cam speed, quasi-rigid: inertia of the follower along its coordinate, springs `along` that
// coordinate, efforts along it, gravity on the follower. Other bodies attached to the follower do not count.
typedef struct YkCamLoads {
    bool has_mass, has_spring;
    double inertia;            // kg, or kg m^2 about the pivot
    double stiffness, damping; // N/m, N s/m, or per radian
    double preload;            // of the springs at lift 0, pressing the follower to the cam, N or N m
    bool is_partial;           // some load does not count: an effort that depends on other motions
} YkCamLoads;
YK_API YkCamLoads yk_cam_loads(const YkCamDesign *design);
typedef struct YkCamForce {
    double effort;  // along the follower's coordinate, by the cam on the follower, N or N m
    double contact; // normal force between cam and follower, N; negative: they part, or the second roller bears
    double torque;  // that drives the cam about its axis, along its coordinate, N m
} YkCamForce;
YK_API YkCamForce yk_cam_force(const YkCamDesign *design, double speed, double angle);
typedef struct YkCamForceSummary {
    YkCamExtreme contact_low, contact_high, torque_low, torque_high;
    double torque_mean;    // over a period
    double jump_speed;     // at which the follower leaves the cam, rad/s; infinite: never
    double jump_angle;     // where it leaves
    double preload_needed; // at this speed, for a contact that just holds, N or N m
} YkCamForceSummary;
YK_API YkCamForceSummary yk_cam_force_summary(const YkCamDesign *design, double speed);

#ifdef __cplusplus
}
#endif

#endif
