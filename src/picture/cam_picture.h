// Profiles of a cam as pictures to scale: SVG in millimetres for people, DXF for machines.
#ifndef PICTURE_CAM_PICTURE_H
#define PICTURE_CAM_PICTURE_H
#include <yoke/cam.h>
#include "base/text.h"
#include "base/vec.h"

typedef struct YkCamOutline {
    const char *layer; // "surface", "pitch", "groove", "cutter", "surface-2", "pitch-2"
    YkVec *points;     // cam's axes, m
    size_t count;
} YkCamOutline;

enum { YK_CAM_OUTLINES_MAX = 6 };

typedef struct YkCamPicture {
    const YkCamDesign *design;
    YkCamOutline outlines[YK_CAM_OUTLINES_MAX];
    size_t count;
    double cutter; // radius, m; 0: none
    bool ran_out;  // memory ran out
} YkCamPicture;

// Takes all curves of the cam within a tolerance (m). Returns false when out of memory or if the tolerance is too
// small.
bool yk_cam_picture_take(YkCamPicture *picture, const YkCamDesign *design, double tolerance, double cutter);
void yk_cam_picture_free(YkCamPicture *picture);
// Writes surface, base circle, pitch curve, roller or face at cam angle 0, centre marks; one user unit is 1 mm.
void yk_cam_picture_svg(const YkCamPicture *picture, YkText *svg);
// Writes the curves, the base circle and centre marks, on layers.
void yk_cam_picture_dxf(const YkCamPicture *picture, YkText *dxf);

#endif
