// A drawing inside: poses collected in metres, then laid out in pixels and written in layers.
#ifndef PICTURE_DRAWING_H
#define PICTURE_DRAWING_H
#include <yoke/draw.h>
#include <yoke/centers.h>
#include "base/text.h"
#include "base/vec.h"
#include "model/model.h"

// The frame of a body's axes: origin in metres, direction of x as a unit vector.
typedef struct YkFrame {
    YkVec origin, axis;
} YkFrame;

// A body's outline in its own axes, made once: the convex hull of its points. 1 corner: a dot, 2: a bar, more: a plate.
typedef struct YkOutline {
    size_t first, count;
} YkOutline;

typedef struct YkDrawnCam YkDrawnCam; // drawing_cams.c

struct YkDrawing {
    const YkMechanism *mech;
    const YkModel *model;
    YkDrawOptions options; // traced_points is a copy of its own
    YkOutline *outlines;   // [body]
    YkVec *corners;
    size_t corner_count;
    YkDrawnCam *cams;     // [cam]
    bool keeps_followers; // bodies are drawn where the equations have them: no follower is moved to where it rides
    YkFrame *frames;      // [pose][body]
    YkFrame *placed;      // [body]: scratch
    YkMotion *motions;    // [body]: scratch
    size_t pose_count, pose_capacity;
    YkVec *traces; // [position][traced point]
    size_t trace_count, trace_capacity;
    YkText svg;
    double scale, width, height; // px per metre, px, px
    YkVec low, high;             // what is drawn lies within, m
    double bar;                  // width of a bar, px
    size_t shown;                // moving: the pose to which the groups are taken
    bool is_scene;               // moving, and each group is in its body's own axes (drawing_scene.c)
    YkCenter *centers;           // instant centres at the last pose
    bool *shows_center;          // [center_count]: it lies on the page
    size_t center_count;
    YkCentrodePoint *centrode; // [centrode_count]
    size_t centrode_count, centrode_body[2];
    YkVec centrode_low, centrode_high; // what of them is shown lies within, m
    double fixed_scale;                // px per metre, for whoever shows it; 0: as large as the page allows
};

// Returns whether a joint is not drawn: a free joint, which holds nothing, or one that holds a sketch's loose bodies.
static inline bool yk_drawing_omits(const YkModel *model, const YkJoint *joint)
{
    return joint->is_free || (size_t)(joint - model->joints) >= model->joint_count - model->held_joints;
}

static inline YkVec yk_frame_apply(YkFrame frame, YkVec at)
{
    return yk_add(frame.origin, yk_mul(frame.axis, at));
}
static inline const YkFrame *yk_drawing_frames(const YkDrawing *drawing, size_t pose)
{
    return drawing->frames + pose * drawing->model->body_count;
}
// Returns a joint's point on body side 0 or 1, in metres.
static inline YkVec yk_drawing_joint(const YkDrawing *drawing, const YkFrame *frames, const YkJoint *joint, int side)
{
    (void)drawing;
    return yk_frame_apply(frames[joint->body[side]], joint->at[side]);
}

// Returns the pose in which everything is written: the last one.
static inline size_t yk_drawing_reference(const YkDrawing *drawing)
{
    return drawing->pose_count - 1;
}

// For moving drawings: what comes between belongs to the body, or is a name that follows a place (metres, at the pose
// `reference` and at the pose shown). Otherwise they write nothing. Groups do not nest.
void yk_drawing_group(YkDrawing *drawing, size_t body);
void yk_drawing_group_name(YkDrawing *drawing, char kind, size_t index, YkVec from, YkVec to);
void yk_drawing_ungroup(YkDrawing *drawing);
// The displacement of a body on the page from its place in the reference pose.
typedef struct YkShift {
    YkVec by;     // px
    double turn;  // clockwise as SVG counts, rad, within half a turn
    YkVec center; // about which it turns: where its origin is in the reference pose, px
} YkShift;
YkShift yk_drawing_shift(const YkDrawing *drawing, size_t body, size_t pose);

// Returns a drawing of which only the bodies move from pose to pose, made with options.moving, in the last of its
// poses; all poses together decide its size. The parts of a body are groups <g data-body="NAME"> in the
// body's own axes, m, y up, whose transform "translate(X Y) rotate(DEGREES)" is the body's pose. Names are left out.
// NULL when out of memory.
const char *yk_drawing_scene(YkDrawing *drawing);
// Returns what goes with that drawing at another pose and is not fixed to one body, in pixels of the drawing: springs
// and names. Empty if there is nothing. NULL when out of memory.
const char *yk_drawing_parts(YkDrawing *drawing, const YkState *state);
// Returns where the name of a joint or a body is attached, m.
YkVec yk_drawing_middle(const YkDrawing *drawing, const YkFrame *frames, size_t body);
// Writes keyframes of all bodies and names over the poses.
void yk_drawing_keyframes(YkDrawing *drawing, double seconds, bool to_and_fro);

// Builds all outlines. Returns false when out of memory. Cost: O(points log points).
bool yk_drawing_outline(YkDrawing *drawing);
// Places all bodies in the pose of `state`. Returns false if a body is attached to nothing placed, or is not finite.
bool yk_drawing_place(const YkDrawing *drawing, const YkState *state, YkFrame *frames);
// Sets scale, size and bar width from everything collected.
void yk_drawing_fit(YkDrawing *drawing);
enum { YK_DRAWING_MARGIN = 64, YK_DRAWING_HEAD = 30 }; // px: around what is drawn, and above it
YkVec yk_drawing_pixel(const YkDrawing *drawing, YkVec metres);

// Does not fit: puts `middle` (m) at the middle of a page of this size (px), at `scale` px per metre.
void yk_drawing_center(YkDrawing *drawing, YkVec middle, double scale, double width, double height);
// Returns the size of the machine in a drawing: the largest coordinate of a joint or corner, m.
double yk_drawing_extent(const YkDrawing *drawing);
// Writes the head of the document.
void yk_drawing_open(YkDrawing *drawing, const char *title);

// Layers, from the back to the front; `pose` is the one whose joints are drawn.
void yk_drawing_guides(YkDrawing *drawing); // ground rails and ground pins, hatched
void yk_drawing_traces(YkDrawing *drawing);
void yk_drawing_bodies(YkDrawing *drawing, size_t pose); // bars, plates, boxes, slots, pins
void yk_drawing_labels(YkDrawing *drawing);              // names, at the last pose
// drawing_centers.c: makes the page hold the centres that are near; the height of the notes on others, px; draws all.
void yk_drawing_include_centers(YkDrawing *drawing);
double yk_drawing_notes(const YkDrawing *drawing);
void yk_drawing_mark_centers(YkDrawing *drawing);
// drawing_centrodes.c: makes the page hold what of them is near; draws both.
void yk_drawing_include_centrodes(YkDrawing *drawing);
void yk_drawing_add_centrodes(YkDrawing *drawing);
void yk_drawing_margin(YkDrawing *drawing); // title and scale bar

// Colours of a body: a light one to fill, a dark one for edges and words.
typedef struct YkColour {
    const char *fill, *edge;
} YkColour;
YkColour yk_drawing_colour(size_t body);

// The stretch of its line that a slide or pin-slot covers in all poses, in metres from the joint's `from` point.
typedef struct YkStretch {
    double low, high;
} YkStretch;
YkStretch yk_drawing_stretch(const YkDrawing *drawing, const YkJoint *joint);
// Draws the lines of moving bodies along which others slide, below everything else.
void yk_drawing_rods(YkDrawing *drawing, const YkFrame *frames);
// Draws pitch circles with marks, pulleys and belts, base circles of cams.
void yk_drawing_wheels(YkDrawing *drawing, const YkFrame *frames);
double yk_drawing_pitch_radius(const YkGear *gear, int side); // m; 0 if neither centres nor module are given
// Raises `reach` to the largest radius of the body's wheels about its origin, m.
void yk_drawing_wheel_reach(const YkDrawing *drawing, int32_t body, double *reach);
// Visits all wheels of one body; `see` gets the centre (m), the radius (m) and whether it is a cam's base circle.
// frames may be NULL if centres are not needed.
typedef void YkSeeWheel(void *context, YkVec center, double radius, bool is_base);
void yk_drawing_each_wheel(const YkDrawing *drawing, const YkFrame *frames, int32_t body, YkSeeWheel *see,
                           void *context);
// Takes the outlines of cams, and rollers, faces and edges of their followers, once. Returns false when out of memory.
bool yk_drawing_take_cams(YkDrawing *drawing);
// Moves followers that are drawn away from their place in the model: called once, when all bodies are placed.
void yk_drawing_move_followers(const YkDrawing *drawing, YkFrame *frames);
double yk_drawing_follower_turn(const YkDrawing *drawing, size_t body); // how far it is turned by that, rad
void yk_drawing_free_cams(YkDrawing *drawing);
void yk_drawing_cams(YkDrawing *drawing, const YkFrame *frames);
YkVec yk_drawing_cam_center(const YkDrawing *drawing, const YkFrame *frames, size_t cam); // m
double yk_drawing_cam_reach(const YkDrawing *drawing, size_t cam); // the farthest of its outline from its centre, m
YkVec yk_drawing_rider(const YkDrawing *drawing, const YkFrame *frames,
                       size_t cam); // centre of the roller, the edge, a point of the face, m
// Draws the pins, boxes and slots of one pose.
void yk_drawing_joints(YkDrawing *drawing, const YkFrame *frames);

// Draw one body by itself: its bar or plate; its wheels as circles; a joint's shape on its body side 0 or 1.
void yk_drawing_body(YkDrawing *drawing, const YkFrame *frame, size_t body);
void yk_drawing_body_wheels(YkDrawing *drawing, const YkFrame *frames, int32_t body);
void yk_drawing_joint_on(YkDrawing *drawing, const YkFrame *frames, const YkJoint *joint, int side);
// drawing_joints.c: the style of a shape with rounded edges.
void yk_drawing_style(YkText *style, const char *fill, const char *edge, double width);

#endif
