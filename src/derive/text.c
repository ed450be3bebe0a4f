// Composes names.
#include "derive/derive.h"

const char *yk_derive_text(YkDerivation *d, const char *first, const char *second, const char *third)
{
    const char *const parts[] = {first, second, third}, *text = yk_page_join(d->arena, parts, 3);
    d->failed |= !text;
    return text ? text : "";
}

char *yk_derive_digits(char *end, size_t number)
{
    do *--end = (char)('0' + number % 10);
    while ((number /= 10) > 0);
    return end;
}

const char *yk_derive_numbered(YkDerivation *d, const char *stem, size_t number)
{
    char digits[24] = {0};
    return yk_derive_text(d, stem, yk_derive_digits(digits + sizeof digits - 1, number), "");
}
