// Reads the stored start solutions of Alt's problem (alt_start_table.c, written by tools/find-alt-start).
#include "synthesis/nine_points/alt_start.h"
#include <string.h>
#include "synthesis/nine_points/alt.h"

static uint32_t digit_of(char c)
{
    if (c >= 'a') return (uint32_t)(c - 'a') + 26;
    if (c >= 'A') return (uint32_t)(c - 'A');
    return c == '+' ? 62 : c == '/' ? 63 : (uint32_t)(c - '0') + 52;
}

// Reads 32 bits, the first ones highest, from six of them a digit.
static uint32_t read_bits(const char *text, size_t from)
{
    uint64_t bits = 0;
    size_t first = from / 6, last = (from + 31) / 6;
    for (size_t k = first; k <= last; k++) bits = bits << 6 | digit_of(text[k]);
    return (uint32_t)(bits >> (6 * (last + 1) - (from + 32)));
}

const YkVec *yk_alt_start_places(void)
{
    return yk_alt_start_at;
}

bool yk_alt_start(size_t index, YkVec *x)
{
    const YkVec *places = yk_alt_start_places();
    if (index >= YK_ALT_TRIPLES) return false;
    for (size_t k = 0; k < 2 * YK_ALT_SIZE; k++) {
        uint32_t bits = read_bits(yk_alt_start_text[index], 32 * k);
        float value;
        memcpy(&value, &bits, sizeof value);
        *(k % 2 == 0 ? &x[k / 2].x : &x[k / 2].y) = (double)value;
    }
    return yk_alt_polish(places, x) < 1e-9;
}
