// The axes of a map: a square panel with a grid.
#ifndef PICTURE_AXES_H
#define PICTURE_AXES_H
#include "base/text.h"
#include "base/vec.h"

enum { YK_PANEL_SIZE = 520, YK_PANEL_LEFT = 70, YK_PANEL_TOP = 30, YK_PANEL_BOTTOM = 56 }; // px

// A panel: x from low.x to high.x over its width, y upwards.
typedef struct YkPanel {
    YkText *svg;
    double left; // px
    YkVec low, high;
} YkPanel;

void yk_panel_begin(const YkPanel *panel, int width); // the head of a drawing that is one panel high
YkVec yk_panel_pixel(const YkPanel *panel, YkVec at);
// Draws the frame, the grid and its numbers. is_degrees: of x and y, whose grid has round parts of a turn.
void yk_panel_frame(const YkPanel *panel, bool is_degrees[2], const char *x_name, const char *y_name);
void yk_panel_square(YkPanel *panel); // makes both axes equally long, about their middle

#endif
