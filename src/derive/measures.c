// Masses, inertias, stiffnesses and dampings. Numbers of many digits become constants: with them, formulas would be
// hard to read, and products of a few too large to be exact.
#include "derive/inside.h"

static bool is_short(const YkPoisson *a)
{
    enum { OVER_MAX = 1000, UNDER_MAX = 100 }; // of a fraction that is written in formulas itself
    int64_t over, under;
    return !yk_ring_is_rational(a, &over, &under) || (over <= OVER_MAX && over >= -OVER_MAX && under <= UNDER_MAX);
}

// Makes the constant letter_of, whose value is that of the expression.
static const YkPoisson *name_value(YkDerivation *d, const YkExpr *expr, const YkPoisson *exact, YkRingClass kind,
                                   const char *letter, const char *of)
{
    YkJet jet;
    YkText name = {0};
    if (yk_model_eval(d->model, expr, 0, &jet, NULL) != YK_OK) return exact;
    yk_text_format(&name, "%s_%s", letter, of);
    int32_t symbol = yk_derive_symbol(d, yk_text_get(&name), kind);
    yk_text_free(&name);
    const YkPoisson *named = symbol < 0 ? NULL : yk_ring_of(d->ring, symbol);
    if (!named || !yk_derive_add_constant(d, (YkDeriveConstant){symbol, expr, jet.d[0], exact ? exact : named}))
        return NULL;
    yk_ring_set_number(d->ring, symbol, exact);
    return named;
}

const YkPoisson *yk_derive_measure(YkDerivation *d, const YkExpr *expr, YkRingClass kind, const char *letter,
                                   const char *body)
{
    const YkPoisson *exact = expr ? yk_derive_given(d, expr) : yk_ring_rational(d->ring, 0, 1);
    if (yk_ring_status(d->ring) != YK_RING_OK || (exact && is_short(exact))) return exact;
    return name_value(d, expr, exact, kind, letter, body);
}

const YkPoisson *yk_derive_strength(YkDerivation *d, const YkExpr *expr, const char *letter, const char *spring)
{
    const int64_t most = 1000000000; // 3 lbf/in is a fraction of 13 digits; products of a few such are too large
    int64_t over, under;
    const YkPoisson *exact = yk_derive_expression(d, expr), *number = exact;
    int32_t symbol = exact ? yk_ring_next_symbol(d->ring, exact, -1) : -1, power, highest; // pi, of stiffnesses per deg
    if (symbol >= 0 && symbol == yk_ring_find(d->ring, "pi") &&
        yk_ring_powers(d->ring, exact, symbol, &power, &highest))
        number = yk_ring_coefficient(d->ring, exact, symbol, power);
    if (!number || !yk_ring_is_rational(number, &over, &under)) return exact;
    if (over < most && over > -most && under < most) return exact;
    return name_value(d, expr, exact, YK_RING_CONSTANT, letter, spring);
}
