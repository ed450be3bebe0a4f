// Names in a picture, each where it covers least of what is already drawn. Pixels, y down.
#ifndef PICTURE_LABELS_H
#define PICTURE_LABELS_H
#include <stddef.h>
#include "base/vec.h"

enum { YK_LABELS_MAX = 160 };

typedef struct YkBox {
    double left, top, right, bottom;
} YkBox;

typedef struct YkLabels {
    YkBox boxes[YK_LABELS_MAX]; // taken: by names, and by what no name may hide
    size_t count;
    YkVec (*lines)[2]; // of bodies' edges, of arrows: the caller's
    size_t line_count;
    double half;  // half the width of a line, px
    double width; // names stay within the page if these are not 0
    double height;
} YkLabels;

YkBox yk_box_at(YkVec middle, double width, double height);
// Takes a place; does nothing beyond YK_LABELS_MAX.
void yk_labels_take(YkLabels *labels, YkBox box);
// Finds the best place of a word of that size round a point, about `reach` away from it, near before far: the first
// of the cheapest. The price is the area it would cover; `price` may be NULL. Takes nothing.
YkBox yk_labels_find(const YkLabels *labels, YkVec at, double reach, double width, double height, double *price);

#endif
