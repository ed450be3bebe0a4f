// Reads values of laws in equations: `lift(theta)`, and `lift_v (2/3 pi)` as pages print conditions. Before any other
// bracket a law is a factor.
#include <math.h>
#include "derive/cams/cams.h"
#include "derive/relations.h"
#include "prove/equation.h"

static const YkDeriveRelation *law_of(const YkDerivation *d, int32_t symbol, int *order)
{
    for (size_t k = 0; k < d->tie_count; k++) {
        const YkDeriveRelation *tie = &d->ties[k];
        if (tie->function < 0 || symbol < tie->function || symbol >= tie->function + YK_TIE_ORDERS) continue;
        *order = symbol - tie->function;
        return tie;
    }
    return NULL;
}

// Returns whether it is a number, or a sum of angles and fractions of pi: an argument of a law, never a factor.
static bool is_place(YkDerivation *d, const YkPoisson *a)
{
    int64_t over, under;
    if (yk_ring_is_rational(a, &over, &under)) return true;
    int32_t pi = yk_ring_next_symbol(d->ring, yk_ring_pi(d->ring), -1);
    for (int32_t s = yk_ring_next_symbol(d->ring, a, -1); s >= 0; s = yk_ring_next_symbol(d->ring, a, s)) {
        bool is_constant = s == pi;
        for (size_t k = 0; k < d->model->parameter_count; k++)
            is_constant |= d->parameters[k] == s && yk_ring_is_angle(d->ring, s);
        if (!is_constant) return false;
    }
    return true;
}

// Evaluates the law; 0 if that is only the rounding of its other values.
static double evaluate(const YkLaw *law, double x, int order)
{
    enum { PLACES = 64 };
    double found[YK_LAW_ORDER + 1], most = 0;
    YkLawRange range = yk_law_range(law);
    for (int k = 0; k <= PLACES; k++) {
        yk_law_eval(law, range.from + (range.to - range.from) * k / PLACES, found);
        if (isfinite(found[order])) most = fmax(most, fabs(found[order]));
    }
    yk_law_eval(law, x, found);
    return fabs(found[order]) > 1e-11 * most ? found[order] : 0;
}

// Makes a constant of its own.
static const YkPoisson *value_at(YkDerivation *d, const YkDeriveRelation *tie, int order, const YkPoisson *place)
{
    YkText name = {0};
    bool is_new;
    double x = yk_derive_fixed(d, place);
    yk_text_format(&name, "%s_at_%e", yk_ring_symbol_name(d->ring, tie->function + order), x);
    int32_t symbol =
        name.failed ? -1 : yk_derive_once(d, yk_text_get(&name), yk_text_get(&name), YK_RING_CONSTANT, false, &is_new);
    yk_text_free(&name);
    bool well = symbol >= 0 && (!is_new || yk_derive_fix(d, symbol, evaluate(tie->law, x, order)));
    return well ? yk_ring_of(d->ring, symbol) : NULL;
}

const YkForm *yk_equation_call(YkEquationReader *reader, int32_t symbol)
{
    YkDerivation *d = reader->d;
    int order = 0;
    size_t start = reader->at;
    const YkDeriveRelation *tie = law_of(d, symbol, &order);
    if (!tie || yk_equation_peek(reader) != '(') {
        reader->at = start;
        return NULL;
    }
    const YkForm *inside = yk_equation_bracket(reader);
    const YkPoisson *place = inside ? yk_form_expand(d->ring, inside, 100) : NULL;
    yk_ring_clear(d->ring);
    if (!inside) return NULL;
    const YkPoisson *given = place ? yk_derive_in_joints(d, place) : NULL;
    if (given && yk_ring_is_same(given, yk_derive_in_joints(d, tie->argument)))
        return yk_form_of(d->ring, yk_ring_of(d->ring, symbol));
    if (place && is_place(d, place)) return yk_form_of(d->ring, value_at(d, tie, order, place));
    reader->at = start;
    return NULL;
}
