// Angles and roots of an equation's own. Angles in cos, sin and tan need not be whole multiples of the machine's
// (omega t, theta/2): the remainder beside such multiples is an angle with a value. Roots are positive. Only what holds
// for any angle and any number can be proved of them.
#include <math.h>
#include "derive/inside.h"
#include "prove/equation.h"

typedef struct YkEquationOwn {
    int32_t symbol;
    bool is_root;
    const YkPoisson *value; // the angle, or the root's square
    struct YkEquationOwn *next;
} YkEquationOwn;

// Fills them in order, since later ones may contain earlier ones.
static void fill(void *context, const YkState *state, YkDynamics *dynamics, double *values)
{
    const YkDerivation *d = context;
    (void)state, (void)dynamics;
    yk_ring_complete(d->ring, values);
    for (const YkEquationOwn *own = d->own_of_equations; own; own = own->next) {
        double value = yk_ring_value(d->ring, own->value, values).x;
        values[own->symbol] = own->is_root ? sqrt(value) : value;
    }
}

static int32_t enter(YkDerivation *d, const YkPoisson *value, bool is_root)
{
    YkText name = {0};
    size_t count = 1;
    YkEquationOwn **last = &d->own_of_equations, *own = YK_NEW(d->arena, YkEquationOwn, 1);
    for (; *last; last = &(*last)->next) count++;
    yk_text_format(&name, is_root ? "root_in_equation_%z" : "angle_in_equation_%z", count);
    int32_t symbol = !own || name.failed ? -1
                     : is_root           ? yk_derive_symbol(d, yk_text_get(&name), YK_RING_CONSTANT)
                                         : yk_derive_angle(d, yk_text_get(&name));
    yk_text_free(&name);
    if (symbol < 0 || (count == 1 && !yk_derive_add_source(d, fill, d))) return -1;
    *own = (YkEquationOwn){symbol, is_root, value, NULL};
    *last = own;
    return symbol;
}

// Splits off whole multiples of angles and fractions of pi, and multiplies the unit by theirs.
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

const YkPoisson *yk_equation_unit(YkDerivation *d, const YkPoisson *angle)
{
    YkRing *ring = d->ring;
    const YkPoisson *unit = yk_ring_rational(ring, 1, 1);
    const YkPoisson *rest =
        angle ? take_multiples(ring, yk_derive_is_long(d) ? angle : yk_derive_in_joints(d, angle), &unit) : NULL;
    if (!rest || yk_ring_is_zero(rest)) return rest ? unit : NULL;
    if (!yk_ring_is_real(ring, rest)) return NULL;
    const YkPoisson *turned = yk_ring_negate(ring, rest);
    for (const YkEquationOwn *own = d->own_of_equations; own; own = own->next) {
        const YkPoisson *known = own->is_root ? NULL : yk_ring_unit(ring, own->symbol);
        if (known && yk_ring_is_same(own->value, rest)) return yk_ring_multiply(ring, unit, known);
        if (known && yk_ring_is_same(own->value, turned)) return yk_ring_divide(ring, unit, known);
    }
    int32_t symbol = enter(d, rest, false);
    return symbol < 0 ? NULL : yk_ring_multiply(ring, unit, yk_ring_unit(ring, symbol));
}

const YkPoisson *yk_equation_root(YkDerivation *d, const YkPoisson *square)
{
    if (!square || !yk_ring_is_real(d->ring, square)) return NULL;
    for (const YkEquationOwn *own = d->own_of_equations; own; own = own->next)
        if (own->is_root && yk_ring_is_same(own->value, square)) return yk_ring_of(d->ring, own->symbol);
    int32_t symbol = enter(d, square, true);
    return symbol < 0 ? NULL : yk_ring_of(d->ring, symbol);
}

bool yk_equation_has_own(const YkDerivation *d, const YkPoisson *a)
{
    for (const YkEquationOwn *own = d->own_of_equations; own; own = own->next)
        if (yk_ring_mentions(d->ring, a, own->symbol)) return true;
    return false;
}

bool yk_equation_mentions(const YkDerivation *d, const YkPoisson *a, int32_t symbol)
{
    if (yk_ring_mentions(d->ring, a, symbol)) return true;
    for (const YkEquationOwn *own = d->own_of_equations; own; own = own->next)
        if (yk_ring_mentions(d->ring, a, own->symbol) && yk_equation_mentions(d, own->value, symbol)) return true;
    return false;
}
