// Names put together.
#include <string.h>
#include "derive/forces/free_bodies.h"

const char *yk_derive_text(YkDerivation *d, const char *first, const char *second, const char *third)
{
    const char *const parts[] = {first, second, third};
    for (size_t k = 0; k < 3; k++) d->failed |= parts[k] == yk_text_lost;
    const size_t lengths[] = {strlen(first), strlen(second), strlen(third)};
    char *text = yk_arena_take(d->arena, lengths[0] + lengths[1] + lengths[2] + 1), *end = text;
    if (!text) {
        d->failed = true;
        return "";
    }
    for (size_t k = 0; k < 3; end += lengths[k++]) memcpy(end, parts[k], lengths[k]);
    *end = '\0';
    return text;
}
