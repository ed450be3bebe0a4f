// Writes DXF (AutoCAD release 12, which every program reads): outlines in millimetres, as text.
#ifndef PICTURE_DXF_H
#define PICTURE_DXF_H
#include "base/text.h"
#include "base/vec.h"

// Begins a drawing with layers (colour 1, 2, ... in turn). Coordinates are in mm, nine decimals.
void yk_dxf_begin(YkText *dxf, const char *const *layers, size_t count);
void yk_dxf_outline(YkText *dxf, const char *layer, const YkVec *points, size_t count); // a closed polyline
void yk_dxf_circle(YkText *dxf, const char *layer, YkVec center, double radius);
void yk_dxf_line(YkText *dxf, const char *layer, YkVec a, YkVec b);
void yk_dxf_end(YkText *dxf);

#endif
