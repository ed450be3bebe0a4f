// The catalogue of joints: what each part is, independent of what is computed with it.
#ifndef PART_PART_H
#define PART_PART_H
#include <stdbool.h>
#include <stddef.h>

typedef enum YkPartKind { YK_PIN, YK_SLIDE, YK_PIN_SLOT, YK_WELD, YK_FREE, YK_PART_COUNT } YkPartKind;

// A joint holds point `at` of body b at a place on body a. The members say what it leaves free.
typedef struct YkPart {
    const char *key;         // its key in the model file: "pin", "slide", "pin-slot", "weld", "free"
    bool turns;              // b may turn relative to a (coordinate: angle)
    bool slides;             // b's point may move along a line of a (coordinate: distance)
    const char *const *keys; // further keys it takes, NULL-terminated
    int constraints;         // 3 - turns - slides, for Gruebler's count
} YkPart;

const YkPart *yk_part(YkPartKind kind);
// Returns the kind with this key; YK_PART_COUNT if there is none.
YkPartKind yk_part_find(const char *key);

#endif
