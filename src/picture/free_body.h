// Free-body drawings: a picture for every body except the ground, and one for every junction, with all that acts on it
// under the names of the equations. Pictures have no scale: all have the same size, and so do all arrows. An unknown
// force points as it does when its components are positive, and the other way on the other body.
#ifndef PICTURE_FREE_BODY_H
#define PICTURE_FREE_BODY_H
#include "derive/forces/free_bodies.h"

typedef struct YkFreeBodyDrawings YkFreeBodyDrawings;

// Lays out all pictures at the pose of `state` (assembled; only positions are used; `dynamics`, solved there or NULL,
// says which flanks of gears push). The derivation, with its model and mechanism, must outlive them. Returns NULL when
// out of memory (as the derivation then is), if the ring failed, or if the pose cannot be drawn. Cost: at worst
// O(arrows^2), some microseconds per arrow.
YkFreeBodyDrawings *yk_free_body_drawings_new(YkDerivation *d, const YkState *state, YkDynamics *dynamics);
void yk_free_body_drawings_free(YkFreeBodyDrawings *pictures);
size_t yk_free_body_drawings_count(const YkFreeBodyDrawings *pictures);
const char *yk_free_body_drawings_title(const YkFreeBodyDrawings *pictures,
                                        size_t picture); // "crank, body 1"; "Junction A"
const char *yk_free_body_drawings_stem(const YkFreeBodyDrawings *pictures,
                                       size_t picture); // fit for a file: "1-crank", "junction-A"
// Returns a whole SVG document, with the same bytes every time; valid until the next call. NULL when out of memory.
const char *yk_free_body_drawings_svg(YkFreeBodyDrawings *pictures, size_t picture);

#endif
