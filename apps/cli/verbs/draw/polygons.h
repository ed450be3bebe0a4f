// Polygons as pictures of their own.
#ifndef CLI_DRAW_POLYGONS_H
#define CLI_DRAW_POLYGONS_H
#include "picture/convert.h"
#include "session.h"

// Draws the polygon that --polygon names, in place of the machine. Returns false with a problem where there is none.
bool yk_draw_polygon(YkSession *session, YkFileKind kind);

#endif
