// Velocity and acceleration polygons, as they are drawn by hand: the vectors link by link, in the order of the
// construction, with its steps in words.
#ifndef YOKE_POLYGON_H
#define YOKE_POLYGON_H

#include <yoke/state.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum YkPolygonKind { YK_POLYGON_VELOCITY, YK_POLYGON_ACCELERATION } YkPolygonKind;

// The kinds of vectors. A point of a link moves relative to another one of the same link by turning about it: across
// the line between them, and, for accelerations, also along it. If a body slides on another, the point that slides
// moves relative to the point of the other body that lies under it.
typedef enum YkPolygonPart {
    YK_POLYGON_TURNING,    // velocity: rate times distance, across the line between both points
    YK_POLYGON_NORMAL,     // acceleration: rate^2 times distance, towards the other point
    YK_POLYGON_TANGENTIAL, // acceleration: angular acceleration times distance, across the line
    YK_POLYGON_SLIDING,    // along the line of a slide: rate of its distance, or its acceleration
    YK_POLYGON_CORIOLIS    // twice the rate of the line times the rate of sliding, across the line
} YkPolygonPart;

typedef struct YkPolygonVector {
    YkPolygonPart part;
    size_t body;           // the body that turns; for sliding, the one that carries the line
    size_t joint;          // the slide, for sliding; otherwise YK_NOT_FOUND
    size_t step;           // the step of the construction that draws it
    double start[2];       // from the pole, m/s or m/s^2
    double value[2];       // likewise; the vector ends at the sum
    const char *from, *to; // images: the last vector from an image to another ends at it
} YkPolygonVector;

// The end of the velocity or acceleration of a point, drawn from the pole. "o" is the pole, the image of the ground.
typedef struct YkPolygonImage {
    const char *name;
    double at[2];    // of the point, m
    double value[2]; // m/s or m/s^2
} YkPolygonImage;

typedef struct YkPolygon YkPolygon;
// Constructs a polygon at the pose of a state that has rates (and, for accelerations, accelerations): those of the
// state itself. Returns NULL with a problem added at a dead point, with `free` joints, or when out of memory.
// Cost: O((points + joints)^2).
YK_API YkPolygon *yk_polygon_new(const YkState *state, YkPolygonKind kind, YkProblems *problems);
YK_API void yk_polygon_free(YkPolygon *polygon);
YK_API YkPolygonKind yk_polygon_kind(const YkPolygon *polygon);
YK_API size_t yk_polygon_vector_count(const YkPolygon *polygon);
YK_API YkPolygonVector yk_polygon_vector(const YkPolygon *polygon, size_t index);
YK_API size_t yk_polygon_image_count(const YkPolygon *polygon);
YK_API YkPolygonImage yk_polygon_image(const YkPolygon *polygon, size_t index);
// Returns the steps of the construction in words, one after the other; NULL for an index past the last.
YK_API size_t yk_polygon_step_count(const YkPolygon *polygon);
YK_API const char *yk_polygon_step(const YkPolygon *polygon, size_t index);
// Returns the polygon as a picture to scale, an SVG document with the steps below; it lives as long as the polygon.
// NULL when out of memory.
YK_API const char *yk_polygon_svg(YkPolygon *polygon);

#ifdef __cplusplus
}
#endif

#endif
