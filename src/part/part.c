// The catalogue: parts by kind and by key.
#include <string.h>
#include "part/parts.h"

static const YkPart *const catalogue[YK_PART_COUNT] = {[YK_PIN] = &yk_part_pin,
                                                       [YK_SLIDE] = &yk_part_slide,
                                                       [YK_PIN_SLOT] = &yk_part_pin_slot,
                                                       [YK_WELD] = &yk_part_weld,
                                                       [YK_FREE] = &yk_part_free};

const YkPart *yk_part(YkPartKind kind)
{
    return (unsigned)kind < YK_PART_COUNT ? catalogue[kind] : NULL;
}

YkPartKind yk_part_find(const char *key)
{
    for (int kind = 0; kind < YK_PART_COUNT; kind++) {
        if (strcmp(catalogue[kind]->key, key) == 0) return (YkPartKind)kind;
    }
    return YK_PART_COUNT;
}
