// Angles in cos, sin and tan that are no whole multiples of the machine's: omega t, theta/2. What is left of them
// beside such multiples is an angle of its own, with its value; nothing is proved of it but what holds for any angle.
#include "derive/equation.h"

typedef struct YkEquationAngle {
    int32_t symbol;
    const YkPoisson *value; // joint form
    struct YkEquationAngle *next;
} YkEquationAngle;

static void fill(void *context, const YkState *state, YkDynamics *dynamics, double *values)
{
    const YkDerivation *d = context;
    (void)state, (void)dynamics;
    yk_ring_complete(d->ring, values);
    for (const YkEquationAngle *angle = d->angles; angle; angle = angle->next)
        values[angle->symbol] = yk_ring_value(d->ring, angle->value, values).x;
}

// Takes whole multiples of angles and fractions of pi off, and multiplies the unit by theirs.
static const YkPoisson *take_multiples(YkRing *ring, const YkPoisson *angle, const YkPoisson **unit)
{
    const YkPoisson *rest = angle;
    int32_t pi = yk_ring_next_symbol(ring, yk_ring_pi(ring), -1);
    for (int32_t s = yk_ring_next_symbol(ring, angle, -1); s >= 0; s = yk_ring_next_symbol(ring, angle, s)) {
        int64_t over, under;
        const YkPoisson *factor = yk_ring_coefficient(ring, angle, s, 1);
        if (!yk_ring_is_rational(factor, &over, &under) || over == 0 || (s != pi && !yk_ring_is_angle(ring, s)))
            continue;
        const YkPoisson *part = yk_ring_scale(ring, yk_ring_of(ring, s), over, under);
        const YkPoisson *own = yk_ring_exp_of(ring, part);
        if (!own) yk_ring_clear(ring);
        if (!own) continue;
        *unit = yk_ring_multiply(ring, *unit, own);
        rest = yk_ring_subtract(ring, rest, part);
    }
    return rest;
}

static int32_t enter(YkDerivation *d, const YkPoisson *value)
{
    YkEquationAngle *angle = YK_NEW(d->arena, YkEquationAngle, 1);
    if (!angle || (!d->angles && !yk_derive_add_source(d, fill, d))) return -1;
    *angle = (YkEquationAngle){yk_derive_angle(d, "angle_in_equation"), value, d->angles};
    d->angles = angle;
    return angle->symbol;
}

const YkPoisson *yk_equation_unit(YkDerivation *d, const YkPoisson *angle)
{
    YkRing *ring = d->ring;
    const YkPoisson *unit = yk_ring_rational(ring, 1, 1);
    const YkPoisson *rest = angle ? take_multiples(ring, yk_derive_in_joints(d, angle), &unit) : NULL;
    if (!rest || yk_ring_is_zero(rest)) return rest ? unit : NULL;
    if (!yk_ring_is_real(ring, rest)) return NULL;
    const YkPoisson *turned = yk_ring_negate(ring, rest);
    for (const YkEquationAngle *known = d->angles; known; known = known->next) {
        if (yk_ring_is_same(known->value, rest)) return yk_ring_multiply(ring, unit, yk_ring_unit(ring, known->symbol));
        if (yk_ring_is_same(known->value, turned)) return yk_ring_divide(ring, unit, yk_ring_unit(ring, known->symbol));
    }
    int32_t symbol = enter(d, rest);
    return symbol < 0 ? NULL : yk_ring_multiply(ring, unit, yk_ring_unit(ring, symbol));
}

typedef struct YkEquationRoot {
    int32_t symbol;
    const YkPoisson *square;
    struct YkEquationRoot *next;
} YkEquationRoot;

const YkPoisson *yk_equation_root(YkDerivation *d, const YkPoisson *square)
{
    if (!square || !yk_ring_is_real(d->ring, square)) return NULL;
    for (const YkEquationRoot *known = d->roots; known; known = known->next)
        if (yk_ring_is_same(known->square, square)) return yk_ring_of(d->ring, known->symbol);
    YkText name = {0};
    size_t count = 1;
    for (const YkEquationRoot *known = d->roots; known; known = known->next) count++;
    yk_text_format(&name, "root_in_equation_%z", count);
    YkEquationRoot *root = YK_NEW(d->arena, YkEquationRoot, 1);
    int32_t symbol = root && !name.failed ? yk_ring_root(d->ring, yk_text_get(&name), square) : -1;
    yk_text_free(&name);
    if (symbol < 0) return NULL;
    *root = (YkEquationRoot){symbol, square, d->roots};
    d->roots = root;
    return yk_ring_of(d->ring, symbol);
}

bool yk_equation_has_own(const YkDerivation *d, const YkPoisson *a)
{
    for (const YkEquationAngle *known = d->angles; known; known = known->next)
        if (yk_ring_mentions(d->ring, a, known->symbol)) return true;
    for (const YkEquationRoot *known = d->roots; known; known = known->next)
        if (yk_ring_mentions(d->ring, a, known->symbol)) return true;
    return false;
}

bool yk_equation_mentions(const YkDerivation *d, const YkPoisson *a, int32_t symbol)
{
    if (yk_ring_mentions(d->ring, a, symbol)) return true;
    for (const YkEquationAngle *known = d->angles; known; known = known->next)
        if (yk_ring_mentions(d->ring, a, known->symbol) && yk_ring_mentions(d->ring, known->value, symbol)) return true;
    for (const YkEquationRoot *known = d->roots; known; known = known->next)
        if (yk_ring_mentions(d->ring, a, known->symbol) && yk_equation_mentions(d, known->square, symbol)) return true;
    return false;
}
