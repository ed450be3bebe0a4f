// The catalogue of joints: what each part is, never what somebody wants to compute with it.
#ifndef PART_PART_H
#define PART_PART_H
#include <stdbool.h>
#include <stddef.h>

typedef enum YkPartKind { YK_PIN, YK_SLIDE, YK_PIN_SLOT, YK_WELD, YK_PART_COUNT } YkPartKind;

// A joint holds point `at` of body b on a place of body a. What it leaves free:
typedef struct YkPart {
    const char *key;         // its key in the model file: "pin", "slide", "pin-slot", "weld"
    bool turns;              // b may turn against a (coordinate: angle)
    bool slides;             // b's point may move along a line of a (coordinate: distance)
    const char *const *keys; // further keys it takes, NULL-terminated
    int constraints;         // 3 - turns - slides, for Gruebler's count
} YkPart;

const YkPart *yk_part(YkPartKind kind);
// The kind whose key this is; YK_PART_COUNT where there is none.
YkPartKind yk_part_find(const char *key);

#endif
