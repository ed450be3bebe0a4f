// Drawings: the machine at one pose or several, as SVG text.
#ifndef YOKE_DRAW_H
#define YOKE_DRAW_H

#include <yoke/centers.h>
#include <yoke/centrodes.h>
#include <yoke/sweep.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkDrawOptions {
    double width;                // px, default 800; the height follows
    bool labels;                 // names of joints and bodies, default true
    const size_t *traced_points; // model points whose path is drawn
    size_t traced_count;
    size_t traced_hidden; // moving: this many of the last paths are hidden at first, with class off
    bool moving; // the poses are one motion: the machine is drawn once, at the last pose, in groups that can be moved
} YkDrawOptions;
YK_API YkDrawOptions yk_default_draw_options(void);

typedef struct YkDrawing YkDrawing;
// Starts a drawing. It collects poses (all but the last are drawn faint, as under a stroboscope) and traced positions,
// and then writes SVG. Each text lives until the drawing's next call. The mechanism must outlive it. Returns
// NULL when out of memory.
YK_API YkDrawing *yk_drawing_new(const YkMechanism *mech, const YkDrawOptions *options);
YK_API void yk_drawing_free(YkDrawing *drawing);
// Adds the pose of a state, with the positions of the traced points; or these positions alone. Returns YK_OK or
// YK_NO_MEMORY.
YK_API YkStatus yk_drawing_pose(YkDrawing *drawing, const YkState *state);
YK_API YkStatus yk_drawing_trace(YkDrawing *drawing, const YkState *state);
// Adds instant centres, those of the last pose: marks with the names of both bodies, with the lines of Kennedy's
// theorem; centres far away or at infinity are listed below. NULL: none. Returns YK_OK or YK_NO_MEMORY.
YK_API YkStatus yk_drawing_centers(YkDrawing *drawing, const YkCenters *centers);
// Adds centrodes, as they lie at the last pose: the first body's solid, the second's dashed. Parts farther than the
// machine's size from it are left out. Returns YK_OK or YK_NO_MEMORY.
YK_API YkStatus yk_drawing_centrodes(YkDrawing *drawing, const YkCentrodes *centrodes);
YK_API const char *yk_drawing_svg(YkDrawing *drawing); // a whole SVG document; NULL when out of memory
// Returns the drawing, made with options.moving, at a pose. The elements of body 3 have class b3; the
// names of joint 2 and body 3 have classes j2 and n3. Returns NULL when out of memory.
YK_API const char *yk_drawing_frame(YkDrawing *drawing, size_t pose);
// Returns the poses one after the other in a loop that lasts `seconds`, animated by CSS alone; to_and_fro: the motion
// also goes back. Returns NULL when out of memory.
YK_API const char *yk_drawing_animation(YkDrawing *drawing, double seconds, bool to_and_fro);

#ifdef __cplusplus
}
#endif

#endif
