// Any bytes as an expression in one of the formats: it is read or refused with one problem; what is read is written in
// every format and style and reads back as the identical element.
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "ring/print/write.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { TERMS = 300 };

static void demand(bool condition)
{
    if (!condition) abort();
}

static YkRing *new_ring(void)
{
    static const char *const names[] = {"m1", "I1", "l1", "lc1", "g", "F", "d3", "s"};
    static const YkRingClass kinds[] = {YK_RING_MASS,    YK_RING_INERTIA, YK_RING_CONSTANT,   YK_RING_CONSTANT,
                                        YK_RING_GRAVITY, YK_RING_FORCE,   YK_RING_COORDINATE, YK_RING_FUNCTION};
    YkRing *ring = yk_ring_new();
    if (!ring) return NULL;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) yk_ring_symbol(ring, names[i], kinds[i]);
    int32_t theta = yk_ring_angle(ring, "theta1"), other = yk_ring_angle(ring, "A.angle");
    yk_ring_rates(ring, theta);
    yk_ring_rates(ring, other);
    yk_ring_set_limit(ring, TERMS);
    return ring;
}

static const YkPoisson *read_back(YkRing *ring, YkRingFormat format, const YkText *text)
{
    return yk_ring_read(ring, format, yk_text_get(text), text->length, (YkPlace){1, 1, 0}, NULL);
}

// A coefficient may be too large on the way (2 r, or r times a power of ten), and a sum too long as single terms.
static void check_print(YkRing *ring, const YkPoisson *a)
{
    yk_ring_set_limit(ring, 10 * TERMS);
    for (int format = 0; format < YK_RING_FORMATS; format++)
        for (int style = 0; style < YK_RING_STYLES; style++) {
            YkText text = {0};
            bool written = yk_ring_write(ring, a, (YkRingFormat)format, (YkRingStyle)style, &text);
            bool large = !written && yk_ring_status(ring) == YK_RING_OVERFLOW;
            bool complex = !written && format == YK_RING_C && yk_ring_status(ring) == YK_RING_NOT_REAL;
            demand(written || large || complex);
            yk_ring_clear(ring);
            if (written && format != YK_RING_MATHML) {
                const YkPoisson *back = read_back(ring, (YkRingFormat)format, &text);
                demand(back == NULL || yk_ring_is_same(a, back));
            }
            yk_text_free(&text);
        }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    YkRing *ring = size > 0 ? new_ring() : NULL;
    YkProblems *problems = ring ? yk_problems_new() : NULL;
    if (problems) {
        YkRingFormat format = (YkRingFormat)(data[0] % YK_RING_FORMATS);
        const YkPoisson *a = yk_ring_read(ring, format, (const char *)data + 1, size - 1, (YkPlace){1, 1, 0}, problems);
        demand((a == NULL) == (yk_problems_error_count(problems) == 1));
        demand(yk_ring_status(ring) == YK_RING_OK);
        if (a) check_print(ring, a);
    }
    yk_problems_free(problems);
    yk_ring_free(ring);
    return 0;
}
