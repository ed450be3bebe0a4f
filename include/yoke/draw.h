// Drawings: the machine at one pose or several, as SVG text.
#ifndef YOKE_DRAW_H
#define YOKE_DRAW_H

#include <yoke/sweep.h>

typedef struct YkDrawOptions {
    double width;                // px, default 800; the height follows
    bool labels;                 // names of joints and bodies, default true
    const size_t *traced_points; // model points whose path is drawn
    size_t traced_count;
} YkDrawOptions;
YK_API YkDrawOptions yk_default_draw_options(void);

typedef struct YkDrawing YkDrawing;
// A drawing gathers poses (all but the last are drawn faint, as a stroboscope) and trace positions, then becomes text.
YK_API YkDrawing *yk_drawing_new(const YkMechanism *mech, const YkDrawOptions *options);
YK_API void yk_drawing_free(YkDrawing *drawing);
YK_API YkStatus yk_drawing_pose(YkDrawing *drawing, const YkState *state);  // adds a pose
YK_API YkStatus yk_drawing_trace(YkDrawing *drawing, const YkState *state); // adds only the traced points' positions
YK_API const char *yk_drawing_svg(YkDrawing *drawing); // whole SVG document; NULL when out of memory

#endif
