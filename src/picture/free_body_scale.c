// The axes of a free body's drawing.
#include "picture/free_body_inside.h"

void yk_free_body_turn_to(YkFreeBodyDrawings *p, const YkFreeBodyDrawing *picture)
{
    yk_drawing_center(p->drawing, picture->middle, picture->scale, YK_FREE_BODY_WIDTH, YK_FREE_BODY_HEIGHT);
    p->drawing->bar = 11;
}
