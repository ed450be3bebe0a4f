// The inside of the cognates: what their picture reads.
#ifndef SYNTHESIS_COGNATES_H
#define SYNTHESIS_COGNATES_H
#include "synthesis/synthesis.h"

enum { YK_COGNATES_MAX = 2 };

typedef struct YkCognate {
    YkDesign design;
    YkText model;
    double apart; // m
} YkCognate;

struct YkCognates {
    const YkModel *model;
    size_t point;
    YkDesign own;
    YkCognate item[YK_COGNATES_MAX];
    size_t count;
    double curve[2 * YK_CURVE_ROWS];
    size_t rows;
    YkText picture;
};

#endif
