// Shared by the files of free-body drawings.
#ifndef PICTURE_FREE_BODY_INSIDE_H
#define PICTURE_FREE_BODY_INSIDE_H
#include "base/names.h"
#include "picture/drawing/drawing.h"
#include "picture/free_body.h"
#include "picture/svg.h"

// One force or moment on one picture. Pixels, y down.
typedef struct YkArrow {
    YkSvgName name;
    const char *words; // its description, shown when a reader points at it
    size_t picture;
    YkVec at;    // where it acts
    YkVec along; // a force's direction, of length 1; chosen for a free one
    int turn;    // of a moment: 1 anticlockwise, -1 clockwise; 0: a force
    bool is_negative, is_inertia;
    bool is_free;      // its direction is unknown: any with positive components will do
    bool leaves_point; // always drawn outwards from the point
    double angle;      // of a free one, deg: its preferred direction; 0: 45 deg, or what is clearer
    int32_t partner;   // the same force on another picture, or YK_NONE
    bool is_laid;
    YkVec from, to; // as laid out, of a force; a moment's radius
    double radius;
} YkArrow;

// A named place.
typedef struct YkSpotName {
    const char *name;
    YkVec at;
    bool is_center; // of mass
} YkSpotName;

typedef struct YkFreeBodyDrawing {
    const char *title, *stem;
    int32_t body, junction; // one of them, the other YK_NONE
    YkVec middle;           // of the page, m
    double scale;           // px per metre
    size_t first, count;    // of arrows
    YkSpotName *spots;
    size_t spot_count;
} YkFreeBodyDrawing;

struct YkFreeBodyDrawings {
    YkArena *arena;
    YkDerivation *d;
    const YkDeriveForces *forces;
    double *values;     // of the pose, every unknown 1
    bool *is_reaction;  // per symbol
    YkNames spot_names; // of the present picture
    YkDrawing *drawing;
    double extent; // of the whole machine, m
    YkFreeBodyDrawing *pictures;
    size_t count;
    YkArrow *arrows;
    size_t arrow_count, arrow_capacity;
    bool failed, is_infinite; // out of memory, or the pose cannot be drawn
};

enum { YK_FREE_BODY_WIDTH = 560, YK_FREE_BODY_HEIGHT = 440, YK_ARROW_LENGTH = 62 };

// Sets the drawing's scale and middle to a picture's.
void yk_free_body_turn_to(YkFreeBodyDrawings *pictures, const YkFreeBodyDrawing *picture);
// Lists edges of the body and placed arrows, as lines to keep away from: at most yk_free_body_line_count.
size_t yk_free_body_lines(const YkFreeBodyDrawings *pictures, const YkFreeBodyDrawing *picture, YkVec (*lines)[2]);
size_t yk_free_body_line_count(const YkFreeBodyDrawings *pictures, const YkFreeBodyDrawing *picture);
// Collects all that acts, and places the pictures.
bool yk_free_body_gather(YkFreeBodyDrawings *pictures);
// Chooses directions and ends so that arrows keep clear of each other and of the body.
bool yk_free_body_arrange(YkFreeBodyDrawings *pictures);

#endif
