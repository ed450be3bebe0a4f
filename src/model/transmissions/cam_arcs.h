// The surface of a cam as the file gives it by arcs of circles and straight lines, and the lift that follows from it.
#ifndef MODEL_TRANSMISSIONS_CAM_ARCS_H
#define MODEL_TRANSMISSIONS_CAM_ARCS_H
#include "law/build.h"
#include "model/model.h"

// One arc of a list, counterclockwise; or a line that touches its neighbours.
typedef struct YkCamArc {
    YkPlace place;
    bool is_line;
    YkExpr *exprs[3];
    YkVec center;  // in the axes of the cam's body, m
    double radius; // m; negative: a hollow
} YkCamArc;

// Base circle, flank, nose, flank, symmetrical, as books give it; or a list.
typedef struct YkCamArcs {
    YkPlace place;
    bool is_symmetrical, is_bad, flank_is_line;
    YkExpr *from_expr, *nose_expr, *lift_expr, *angle_expr, *flank_expr; // NULL if not given
    double from, nose, lift; // the cam's angle at which the rise begins; m; m beyond the base circle
    double angle;            // of action: between the ends of the base circle, rad
    double flank;            // m; negative: hollow
    YkCamArc *items;         // of a list
    size_t count;
} YkCamArcs;

// An element of the surface with the point where it ends, counterclockwise.
typedef struct YkCamSurface {
    bool is_line;
    YkVec center;
    double radius;
    YkVec normal; // of a line, outwards, at this distance from the cam's centre
    double support;
    YkVec end, end_normal;
    double from, length; // cam angles during which the follower touches it
} YkCamSurface;

// Why no cam comes of the arcs, and which one is at fault.
typedef enum YkCamArcsFault {
    YK_CAM_ARCS_GOOD,
    YK_CAM_ARCS_APART,  // `culprit` does not touch the one that follows
    YK_CAM_ARCS_LINE,   // no line touches the neighbours of `culprit`
    YK_CAM_ARCS_HOLLOW, // the follower does not fit into the hollow `culprit`
    YK_CAM_ARCS_REACH,  // the follower cannot touch the end of `culprit`
    YK_CAM_ARCS_ORDER,  // the follower does not touch every arc in turn
    YK_CAM_ARCS_FLANK   // no flank joins base circle and nose
} YkCamArcsFault;

// Makes the list of a symmetrical cam: base, flank, nose, flank, the nose on the x axis. room: 4. Source: Norton 2009,
// ch. 2; Rothbart 2004, ch. 2 (circular-arc and tangent cams); derived anew.
YkCamArcsFault yk_cam_arcs_symmetrical(const YkCamArcs *arcs, double base, YkCamArc *items);
// Finds where the arcs end and at which angles of the cam the follower touches them.
YkCamArcsFault yk_cam_arcs_surface(const YkCam *cam, const YkCamArc *items, size_t count, YkCamSurface *surface,
                                   size_t *culprit);
// Turns the surface within the cam's body so that the element that follows this one (for the follower) begins at the
// angle `from`.
void yk_cam_arcs_turn(const YkCam *cam, YkCamSurface *surface, size_t count, size_t element, double from);
// Adds the lift over one turn from the angle `from` to a law.
YkLawFault yk_cam_arcs_add(const YkCam *cam, const YkCamSurface *surface, size_t count, double from,
                           YkLawBuilder *builder);

// cam_arcs_lift.c: where the follower stands that touches the base circle, in the terms of YkCamShape.start; and the
// lift at an angle of the cam while the follower touches an element. Returns false if it cannot touch it.
typedef struct YkCamContact {
    const YkCam *cam;
    const YkCamSurface *surface;
} YkCamContact;
bool yk_cam_contact_lift(const void *contact, double angle, double d[YK_LAW_ORDER + 1]);
// Returns the cam's angle at which the follower touches a point of the surface with this normal; NaN if it cannot.
double yk_cam_contact_angle(const YkCam *cam, YkVec point, YkVec normal);

#endif
