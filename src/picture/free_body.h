// Free-body drawings: a picture for every body but the ground, and one for every junction, with all that acts on it
// under the names of the equations. Pictures are without dimensions: each is as large as the others, and so is each
// arrow. An unknown force is drawn as it points when its components are positive, on the other body the other way.
#ifndef PICTURE_FREE_BODY_H
#define PICTURE_FREE_BODY_H
#include "derive/forces/free_bodies.h"

typedef struct YkFreeBodyDrawings YkFreeBodyDrawings;

// Lays out all pictures at the pose of `state` (assembled; only positions are used). The derivation and what it stands
// on must outlive them. Returns NULL when out of memory (the derivation then has run out, too), where the ring failed,
// or where the pose cannot be drawn. Cost O(arrows^2) at worst, some microseconds an arrow.
YkFreeBodyDrawings *yk_free_body_drawings_new(YkDerivation *d, const YkState *state);
void yk_free_body_drawings_free(YkFreeBodyDrawings *pictures);
size_t yk_free_body_drawings_count(const YkFreeBodyDrawings *pictures);
const char *yk_free_body_drawings_title(const YkFreeBodyDrawings *pictures,
                                        size_t picture); // "crank, body 1"; "Junction A"
const char *yk_free_body_drawings_stem(const YkFreeBodyDrawings *pictures,
                                       size_t picture); // fit for a file: "1-crank", "junction-A"
// A whole SVG document, the same bytes every time; valid until the next call. Returns NULL when out of memory.
const char *yk_free_body_drawings_svg(YkFreeBodyDrawings *pictures, size_t picture);

#endif
