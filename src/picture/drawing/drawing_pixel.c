// From metres to pixels, once the scale is set.
#include "picture/drawing/drawing.h"

YkVec yk_drawing_pixel(const YkDrawing *drawing, YkVec metres)
{
    double middle = 0.5 * (drawing->low.x + drawing->high.x);
    return yk_vec(0.5 * drawing->width + (metres.x - middle) * drawing->scale,
                  YK_DRAWING_HEAD + YK_DRAWING_MARGIN + (drawing->high.y - metres.y) * drawing->scale);
}

void yk_drawing_center(YkDrawing *drawing, YkVec middle, double scale, double width, double height)
{
    drawing->scale = scale;
    drawing->width = width;
    drawing->height = height;
    drawing->low = yk_vec(middle.x, middle.y);
    drawing->high = yk_vec(middle.x, middle.y + (0.5 * height - YK_DRAWING_HEAD - YK_DRAWING_MARGIN) / scale);
}
