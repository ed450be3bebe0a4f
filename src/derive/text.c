// Names put together.
#include <string.h>
#include "derive/derive.h"

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

const char *yk_derive_numbered(YkDerivation *d, const char *stem, size_t number)
{
    char digits[24], *first = digits + sizeof digits;
    *--first = '\0';
    do *--first = (char)('0' + number % 10);
    while ((number /= 10) > 0);
    return yk_derive_text(d, stem, first, "");
}
