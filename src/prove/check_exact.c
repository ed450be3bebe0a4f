// Compares equations between numbers exactly, with the file's own decimals for its parameters, since rounding would
// take 1.2000000000001 for 1.2.
#include "derive/inside.h"
#include "prove/check_inside.h"

enum { TERMS_MAX = 2000, DEPTH_MAX = 8 };

static const YkPoisson *with_numbers(YkDerivation *d, const YkPoisson *a)
{
    YkRing *ring = d->ring;
    YkRingChange *changes = YK_NEW(d->arena, YkRingChange, d->model->parameter_count + 1);
    size_t count = 0;
    for (size_t k = 0; changes && k < d->model->parameter_count; k++) {
        if (!yk_ring_mentions(ring, a, d->parameters[k])) continue;
        const YkExpr *expr = d->model->parameters[k].expr;
        const YkPoisson *value = yk_derive_expression(d, expr);
        const YkPoisson *unit = yk_ring_is_angle(ring, d->parameters[k]) ? yk_derive_turn(d, expr) : NULL;
        if (!value) return NULL;
        changes[count++] = (YkRingChange){d->parameters[k], value, unit};
    }
    return changes ? yk_ring_substitute(ring, a, changes, count) : NULL;
}

static bool has_parameters(const YkDerivation *d, const YkPoisson *a)
{
    for (size_t k = 0; k < d->model->parameter_count; k++)
        if (yk_ring_mentions(d->ring, a, d->parameters[k])) return true;
    return false;
}

// Without loops and gears, coordinates and their rates may have any value.
static bool is_free(const YkDerivation *d, int32_t symbol)
{
    if (symbol == yk_ring_next_symbol(d->ring, yk_ring_pi(d->ring), -1)) return true;
    for (size_t k = 0; k < d->coordinate_count && d->loop_count == 0 && d->tie_count == 0; k++)
        if (!d->coordinates[k].is_held && (symbol == d->coordinates[k].position || symbol == d->coordinates[k].rate))
            return true;
    return false;
}

YkCheckExact yk_check_exactly(YkCheck *check)
{
    YkDerivation *d = check->d;
    YkRing *ring = d->ring;
    if (yk_derive_is_long(d)) return YK_EXACT_UNKNOWN;
    const YkPoisson *a = yk_form_expand(ring, check->difference, TERMS_MAX);
    if (a) a = yk_derive_in_joints(d, a);
    for (int depth = 0; a && depth < DEPTH_MAX && has_parameters(d, a); depth++) a = with_numbers(d, a);
    yk_ring_clear(ring);
    if (!a || has_parameters(d, a)) return YK_EXACT_UNKNOWN;
    if (yk_ring_is_zero(a)) return YK_EXACT_EQUAL;
    for (int32_t s = yk_ring_next_symbol(ring, a, -1); s >= 0; s = yk_ring_next_symbol(ring, a, s))
        if (!is_free(d, s)) return YK_EXACT_UNKNOWN;
    return YK_EXACT_DIFFERENT;
}
