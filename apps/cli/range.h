// --over NAME=FROM:TO, read.
#ifndef CLI_RANGE_H
#define CLI_RANGE_H
#include "cli.h"

typedef struct YkOver {
    const char *name; // of the coordinate, or "t"
    const char *from_text, *to_text;
    int coordinate; // -1: time
    YkQuantity quantity;
    double from, to; // SI
} YkOver;

// Splits the words, before there is a mechanism. A unit at the end holds for both ends: 0:360deg.
bool yk_over_split(YkSession *session, const char *text, YkOver *over);
// Finds the coordinate and reads the ends.
bool yk_over_read(YkSession *session, YkOver *over);

#endif
