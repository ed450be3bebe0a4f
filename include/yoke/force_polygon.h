// Force polygons, as drawn by hand: all forces on a body head to tail, closed by its inertia force (d'Alembert).
#ifndef YOKE_FORCE_POLYGON_H
#define YOKE_FORCE_POLYGON_H

#include <yoke/dynamics.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum YkForcePart {
    YK_FORCE_WEIGHT,
    YK_FORCE_LOADS,   // resultant of forces, springs, dampers, friction and the drives of slides
    YK_FORCE_INERTIA, // mass times acceleration, reversed
    YK_FORCE_PLANETS, // of equal planets that share a load, those that the file does not describe
    YK_FORCE_CONTACT, // at teeth, belts and cams
    YK_FORCE_REACTION // at a joint
} YkForcePart;

typedef struct YkForceVector {
    YkForcePart part;
    size_t body;         // it acts on this body; the vectors of a body follow one another
    size_t by;           // the body that exerts it at a joint or contact; otherwise YK_NOT_FOUND
    const char *name;    // of the joint or contact; "weight", "loads", "inertia" or "other planets"
    double at[2];        // where it acts, m; the centre of mass if there is no such place
    double start[2];     // from the beginning of the body's polygon, N
    double value[2];     // N; the vector ends at the sum
    double moment;       // that acts beside it, about `at`, N m
    bool is_determinate; // false: a reaction that is one of many
} YkForceVector;

typedef struct YkForcePolygons YkForcePolygons;
// Constructs the polygons of all bodies on which forces act, at the pose of the last yk_dynamics_solve, which must have
// found them. Names live as long as the mechanism. Returns NULL with a problem when out of memory.
// Cost: O(bodies * (joints + contacts)).
YK_API YkForcePolygons *yk_force_polygons_new(const YkDynamics *dynamics, YkProblems *problems);
YK_API void yk_force_polygons_free(YkForcePolygons *polygons);
YK_API size_t yk_force_polygons_vector_count(const YkForcePolygons *polygons);
YK_API YkForceVector yk_force_polygons_vector(const YkForcePolygons *polygons, size_t index);
// Returns the words below the polygons, one body after the other; NULL for an index past the last.
YK_API size_t yk_force_polygons_step_count(const YkForcePolygons *polygons);
YK_API const char *yk_force_polygons_step(const YkForcePolygons *polygons, size_t index);
// Returns the polygons as a picture, an SVG document, each at its own scale, with the words below; it lives as long as
// they do. NULL when out of memory.
YK_API const char *yk_force_polygons_svg(YkForcePolygons *polygons);

#ifdef __cplusplus
}
#endif

#endif
