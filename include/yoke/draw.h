// Drawings: the machine at one pose or several, as SVG text.
#ifndef YOKE_DRAW_H
#define YOKE_DRAW_H

#include <yoke/sweep.h>

typedef struct YkDrawOptions {
    double width;                // px, default 800; the height follows
    bool labels;                 // names of joints and bodies, default true
    const size_t *traced_points; // model points whose path is drawn
    size_t traced_count;
    size_t traced_hidden; // moving: the last so many of them begin hidden, of class off
    bool
        moving; // the poses are one motion: the machine is drawn once, at the last of them, in groups that can be moved
} YkDrawOptions;
YK_API YkDrawOptions yk_default_draw_options(void);

typedef struct YkDrawing YkDrawing;
// A drawing gathers poses (all but the last are drawn faint, as a stroboscope) and trace positions, then becomes text.
YK_API YkDrawing *yk_drawing_new(const YkMechanism *mech, const YkDrawOptions *options);
YK_API void yk_drawing_free(YkDrawing *drawing);
YK_API YkStatus yk_drawing_pose(YkDrawing *drawing, const YkState *state);  // adds a pose
YK_API YkStatus yk_drawing_trace(YkDrawing *drawing, const YkState *state); // adds only the traced points' positions
YK_API const char *yk_drawing_svg(YkDrawing *drawing); // whole SVG document; NULL when out of memory
// Of a drawing with options.moving, the same page as it stands at a pose; what belongs to body 3 is of class b3, the
// names of joint 2 and body 3 of classes j2 and n3. NULL when out of memory.
YK_API const char *yk_drawing_frame(YkDrawing *drawing, size_t pose);
// The poses one after the other within so many seconds, for ever, by CSS alone; to_and_fro: and back. NULL when out of
// memory.
YK_API const char *yk_drawing_animation(YkDrawing *drawing, double seconds, bool to_and_fro);

#endif
