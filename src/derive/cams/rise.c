// Writes rises and falls by the library's laws in textbook form: s = h f(u), v = h/beta f'(u), ..., zone by zone and
// exactly. A fall is the rise run backwards. Sources: Norton 2009, Cam Design and Manufacturing Handbook, ch. 3-4;
// Rothbart 2004, ch. 2-3.
#include "derive/cams/cams.h"

enum { ZONES_MAX = 5 };

// f over [from, to]: an element of z and of the angle phi = omega (z - start); omega NULL: no angle.
typedef struct Zone {
    const YkPoisson *from, *to, *f, *omega, *phi;
} Zone;

typedef struct Rise {
    YkDeriveLaw *law;
    const YkLawPart *part;
    YkDeriveSpan span;
    const YkPoisson *z, *rate;      // f's argument in u, and its slope by theta
    const YkPoisson *base, *height; // s = base + height f(z)
    const YkPoisson *low, *high;    // the part of f's range that is used
    Zone zones[ZONES_MAX];
    size_t count;
    const YkPoisson *at, *s, *v; // where the next zone begins: z, f and f' there
    const YkPoisson *factor;     // Ca, if f is a multiple of it; NULL: 1
} Rise;

static YkRing *ring_of(const Rise *rise)
{
    return rise->law->d->ring;
}

static const YkPoisson *number(const Rise *rise, int64_t over, int64_t under)
{
    return yk_ring_rational(ring_of(rise), over, under);
}

static const YkPoisson *times(const Rise *rise, const YkPoisson *a, const YkPoisson *b)
{
    return yk_ring_multiply(ring_of(rise), a, b);
}

static const YkPoisson *plus(const Rise *rise, const YkPoisson *a, const YkPoisson *b)
{
    return yk_ring_add(ring_of(rise), a, b);
}

static const YkPoisson *minus(const Rise *rise, const YkPoisson *a, const YkPoisson *b)
{
    return yk_ring_subtract(ring_of(rise), a, b);
}

static const YkPoisson *pi_over(const Rise *rise, const YkPoisson *b)
{
    return yk_ring_divide(ring_of(rise), yk_ring_pi(ring_of(rise)), b);
}

// --- Zones

// The angle of a zone, phi = omega (z - start).
static const YkPoisson *enter_phi(Rise *rise, const YkPoisson *omega, const YkPoisson *start, bool is_only)
{
    YkDerivation *d = rise->law->d;
    YkText key = {0}, name = {0};
    bool is_new;
    yk_text_format(&key, "%s %z phi%z", rise->law->law->name, rise->law->index, rise->count);
    yk_text_format(&name, is_only ? "phi%s" : "phi%s_%c", rise->law->ending, (char)('a' + (int)rise->count));
    int32_t phi = yk_derive_once(d, yk_text_get(&key), yk_text_get(&name), YK_RING_COORDINATE, true, &is_new);
    yk_text_free(&key);
    yk_text_free(&name);
    if (is_new) yk_derive_define(d, phi, times(rise, omega, minus(rise, rise->z, start)));
    return yk_ring_of(d->ring, phi);
}

static const YkPoisson *turn_of(const Rise *rise, const YkPoisson *phi, bool is_sine)
{
    YkRing *ring = ring_of(rise);
    const YkAngleTerm term = {yk_ring_next_symbol(ring, phi, -1), 1};
    return is_sine ? yk_ring_sin(ring, &term, 1) : yk_ring_cos(ring, &term, 1);
}

static void add_zone(Rise *rise, const YkPoisson *to, const YkPoisson *f, const YkPoisson *omega, const YkPoisson *phi)
{
    rise->zones[rise->count++] = (Zone){rise->at, to, f, omega, phi};
    rise->at = to;
}

// Enters phi = omega z for a law that is one formula from 0 to 1.
static const YkPoisson *whole_phi(Rise *rise, int64_t half_turns)
{
    return enter_phi(rise, yk_ring_scale(ring_of(rise), yk_ring_pi(ring_of(rise)), half_turns, 1), number(rise, 0, 1),
                     true);
}

static void harmonic(Rise *rise)
{
    const YkPoisson *phi = whole_phi(rise, 1), *half = number(rise, 1, 2);
    const YkPoisson *f = times(rise, half, minus(rise, number(rise, 1, 1), turn_of(rise, phi, false)));
    add_zone(rise, number(rise, 1, 1), f, yk_ring_pi(ring_of(rise)), phi);
}

// 1/2 (1 - cos phi) - 1/8 (1 - cos 2 phi).
static void double_harmonic(Rise *rise)
{
    YkRing *ring = ring_of(rise);
    const YkPoisson *phi = whole_phi(rise, 1), *one = number(rise, 1, 1);
    const YkAngleTerm twice = {yk_ring_next_symbol(ring, phi, -1), 2};
    const YkPoisson *first = yk_ring_scale(ring, minus(rise, one, turn_of(rise, phi, false)), 1, 2);
    const YkPoisson *second = yk_ring_scale(ring, minus(rise, one, yk_ring_cos(ring, &twice, 1)), 1, 8);
    add_zone(rise, one, minus(rise, first, second), yk_ring_pi(ring), phi);
}

// z - sin(phi) / (2 pi), phi = 2 pi z.
static void cycloidal(Rise *rise)
{
    YkRing *ring = ring_of(rise);
    const YkPoisson *phi = whole_phi(rise, 2), *turn = yk_ring_scale(ring, yk_ring_pi(ring), 2, 1);
    add_zone(rise, number(rise, 1, 1), minus(rise, rise->z, yk_ring_divide(ring, turn_of(rise, phi, true), turn)), turn,
             phi);
}

static void polynomial(Rise *rise, const int64_t *coefficients, int32_t lowest, int32_t count)
{
    YkRing *ring = ring_of(rise);
    const YkPoisson *sum = number(rise, 0, 1);
    for (int32_t k = 0; k < count; k++)
        sum = plus(rise, sum, yk_ring_scale(ring, yk_ring_power(ring, rise->z, lowest + k), coefficients[k], 1));
    add_zone(rise, number(rise, 1, 1), sum, NULL, NULL);
}

// Continues from the last zone's end with s + v w + a w^2 / 2 over this length, w = z - start.
static void accelerate(Rise *rise, const YkPoisson *length, const YkPoisson *a)
{
    if (yk_ring_is_zero(length)) return;
    const YkPoisson *w = minus(rise, rise->z, rise->at), *half = yk_ring_scale(ring_of(rise), a, 1, 2);
    const YkPoisson *f = plus(rise, rise->s, plus(rise, times(rise, rise->v, w), times(rise, half, times(rise, w, w))));
    const YkPoisson *end = times(rise, half, times(rise, length, length));
    rise->s = plus(rise, rise->s, plus(rise, times(rise, rise->v, length), end));
    rise->v = plus(rise, rise->v, times(rise, a, length));
    add_zone(rise, plus(rise, rise->at, length), f, NULL, NULL);
}

// The acceleration of a zone as a sine: sin, cos or -cos of phi = pi w / span.
typedef enum Swing { SWING_UP, SWING_OVER, SWING_BACK } Swing;

static void swing(Rise *rise, const YkPoisson *length, const YkPoisson *span, Swing kind)
{
    if (yk_ring_is_zero(length)) return;
    YkRing *ring = ring_of(rise);
    const YkPoisson *omega = pi_over(rise, span), *amplitude = yk_ring_power(ring, omega, -2);
    const YkPoisson *phi = enter_phi(rise, omega, rise->at, false), *w = minus(rise, rise->z, rise->at);
    const YkPoisson *straight = plus(rise, rise->s, times(rise, rise->v, w)), *f, *one = number(rise, 1, 1);
    const YkPoisson *bent = times(rise, amplitude, minus(rise, one, turn_of(rise, phi, false)));
    const YkPoisson *slope = yk_ring_power(ring, omega, -1);
    if (kind == SWING_UP) { // w / omega - sin(phi) / omega^2, over a quarter turn
        f = minus(rise, plus(rise, straight, times(rise, slope, w)), times(rise, amplitude, turn_of(rise, phi, true)));
        rise->s = minus(rise, plus(rise, rise->s, times(rise, plus(rise, rise->v, slope), length)), amplitude);
        rise->v = plus(rise, rise->v, slope);
    } else if (kind == SWING_OVER) { // half a turn: the slope returns to its value
        f = plus(rise, straight, bent);
        rise->s = plus(rise, plus(rise, rise->s, times(rise, rise->v, length)), yk_ring_scale(ring, amplitude, 2, 1));
    } else { // a quarter turn
        f = minus(rise, straight, bent);
        rise->s = minus(rise, plus(rise, rise->s, times(rise, rise->v, length)), amplitude);
        rise->v = minus(rise, rise->v, slope);
    }
    add_zone(rise, plus(rise, rise->at, length), f, omega, phi);
}

// Sine - constant - cosine - constant - sine acceleration of unit height, then scaled by Ca = 1 / f(1).
static bool scca(Rise *rise, const YkPoisson *b, const YkPoisson *c, const YkPoisson *d)
{
    int64_t over, under;
    if (!yk_ring_is_rational(b, &over, &under) || !yk_ring_is_rational(c, &over, &under) ||
        !yk_ring_is_rational(d, &over, &under))
        return false;
    YkRing *ring = ring_of(rise);
    const YkPoisson *half_b = yk_ring_scale(ring, b, 1, 2), *half_c = yk_ring_scale(ring, c, 1, 2);
    swing(rise, half_b, b, SWING_UP);
    accelerate(rise, half_c, number(rise, 1, 1));
    swing(rise, d, d, SWING_OVER);
    accelerate(rise, half_c, number(rise, -1, 1));
    swing(rise, half_b, b, SWING_BACK);
    rise->factor = rise->s; // f(1), inverted below
    return true;
}

// Trapezoidal velocity: constant acceleration at both ends.
static bool constant_velocity(Rise *rise, const YkPoisson *blend)
{
    int64_t over, under;
    const YkPoisson *one = number(rise, 1, 1), *zero = number(rise, 0, 1);
    if (!yk_ring_is_rational(blend, &over, &under)) return false;
    const YkPoisson *top = yk_ring_divide(ring_of(rise), one, minus(rise, one, blend));
    if (over == 0) {
        rise->v = one;
        accelerate(rise, one, zero);
        return true;
    }
    const YkPoisson *a = yk_ring_divide(ring_of(rise), top, blend);
    accelerate(rise, blend, a);
    accelerate(rise, minus(rise, one, plus(rise, blend, blend)), zero);
    accelerate(rise, blend, yk_ring_negate(ring_of(rise), a));
    return true;
}

// Returns the parts b, c, d or the blend exactly; NULL if they are not numbers.
static const YkPoisson *part_of(Rise *rise, const YkLawNumber *of)
{
    if (!of->expr) return number(rise, 0, 1);
    YkExact exact = yk_model_exact(rise->law->d->model, of->expr);
    return exact.is_exact && exact.pi == 0 ? number(rise, exact.numerator, exact.denominator) : NULL;
}

static bool make_zones(Rise *rise)
{
    static const int64_t poly_3_4_5[] = {10, -15, 6}, poly_4_5_6_7[] = {35, -84, 70, -20};
    const YkLawPart *part = rise->part;
    const YkPoisson *zero = number(rise, 0, 1);
    rise->at = rise->s = rise->v = zero;
    switch (part->rise.law) {
    case YK_RISE_HARMONIC:
        harmonic(rise);
        return true;
    case YK_RISE_DOUBLE_HARMONIC:
        double_harmonic(rise);
        return true;
    case YK_RISE_CYCLOIDAL:
        cycloidal(rise);
        return true;
    case YK_RISE_3_4_5:
        polynomial(rise, poly_3_4_5, 3, 3);
        return true;
    case YK_RISE_4_5_6_7:
        polynomial(rise, poly_4_5_6_7, 4, 4);
        return true;
    case YK_RISE_PARABOLIC:
        accelerate(rise, number(rise, 1, 2), number(rise, 4, 1));
        accelerate(rise, number(rise, 1, 2), number(rise, -4, 1));
        return true;
    case YK_RISE_MODIFIED_TRAPEZOID:
        return scca(rise, number(rise, 1, 4), number(rise, 1, 2), number(rise, 1, 4));
    case YK_RISE_MODIFIED_SINE:
        return scca(rise, number(rise, 1, 4), zero, number(rise, 3, 4));
    case YK_RISE_SCCA: {
        const YkPoisson *b = part_of(rise, &part->b), *c = part_of(rise, &part->c);
        return scca(rise, b, c, part_of(rise, &part->d));
    }
    case YK_RISE_CONSTANT_VELOCITY: {
        const YkPoisson *blend = part_of(rise, &part->blend);
        return blend && constant_velocity(rise, blend);
    }
    }
    return false;
}

// --- Whole and halves

// z runs from 0 to 1, or over the half that is used; the first half of a fall, which runs backwards, is the upper one.
static bool place(Rise *rise, bool is_fall, const YkPoisson *from, const YkPoisson *to)
{
    YkRing *ring = ring_of(rise);
    const YkPoisson *zero = number(rise, 0, 1), *half = number(rise, 1, 2), *one = number(rise, 1, 1);
    YkRiseHalf part = rise->part->rise.half;
    bool is_upper = part != YK_RISE_WHOLE && (part == YK_RISE_SECOND_HALF) != is_fall;
    rise->low = is_upper ? half : zero;
    rise->high = part == YK_RISE_WHOLE || is_upper ? one : half;
    if (!yk_derive_span(rise->law, from, to, is_fall, &rise->span)) return false;
    const YkPoisson *width = minus(rise, rise->high, rise->low);
    rise->z = plus(rise, rise->low, times(rise, width, rise->span.u));
    rise->rate = yk_ring_divide(ring, is_fall ? yk_ring_negate(ring, width) : width, rise->span.beta);
    return rise->rate != NULL;
}

// Returns f(1/2), where a half begins or ends.
static const YkPoisson *middle(const Rise *rise)
{
    return rise->part->rise.law == YK_RISE_DOUBLE_HARMONIC ? number(rise, 1, 4) : number(rise, 1, 2);
}

// Scales s = base + height f from the low end's value. `by` is the file's value, h its name.
static void scale(Rise *rise, const YkPoisson *start, const YkPoisson *by, const YkPoisson *h)
{
    YkRing *ring = ring_of(rise);
    bool is_low = yk_ring_is_zero(rise->low), is_whole = rise->part->rise.half == YK_RISE_WHOLE;
    const YkPoisson *one = number(rise, 1, 1), *f_low = is_low ? number(rise, 0, 1) : middle(rise);
    const YkPoisson *gain = minus(rise, is_whole || !is_low ? one : middle(rise), f_low);
    rise->height = yk_ring_divide(ring, h, gain);
    rise->base = minus(rise, start, times(rise, yk_ring_divide(ring, by, gain), f_low));
}

// --- Print

// Ca = 4 pi^2 / (pi + 4), the peak of the acceleration in units of h / beta^2.
static bool put_factor(Rise *rise)
{
    YkDerivation *d = rise->law->d;
    YkRing *ring = d->ring;
    bool is_new;
    if (!rise->factor) return true;
    const YkPoisson *scale = yk_ring_power(ring, yk_ring_pi(ring), 2), *over = scale,
                    *under = times(rise, rise->factor, scale);
    if (!yk_page_cancel(ring, &over, &under)) return false;
    YkText key = {0}, name = {0};
    yk_text_format(&key, "%s %z Ca", rise->law->law->name, rise->law->index);
    yk_text_format(&name, "Ca%s", rise->law->ending);
    int32_t symbol = yk_derive_once(d, yk_text_get(&key), yk_text_get(&name), YK_RING_FUNCTION, false, &is_new);
    yk_text_free(&key);
    yk_text_free(&name);
    if (symbol < 0 || (is_new && !yk_derive_fix(d, symbol, yk_derive_fixed(d, over) / yk_derive_fixed(d, under))))
        return false;
    yk_page_solution(rise->law->page, NULL, symbol, over, under);
    rise->factor = yk_ring_of(ring, symbol);
    return true;
}

// d f / d z with phi following z.
static const YkPoisson *derivative(const Rise *rise, const Zone *zone, const YkPoisson *f)
{
    YkRing *ring = ring_of(rise);
    int32_t u = yk_ring_next_symbol(ring, rise->span.u, -1);
    const YkPoisson *width = minus(rise, rise->high, rise->low); // dz = width du
    const YkPoisson *slope = yk_ring_divide(ring, yk_ring_partial(ring, f, u), width);
    if (!zone->omega) return slope;
    int32_t phi = yk_ring_next_symbol(ring, zone->phi, -1);
    return plus(rise, slope, times(rise, zone->omega, yk_ring_partial(ring, f, phi)));
}

static void put_order(Rise *rise, int order, const YkPoisson *f, const YkPoisson *within, const char *letter)
{
    YkDeriveLaw *law = rise->law;
    YkRing *ring = ring_of(rise);
    YkLine *line = yk_derive_begin_line(law, order, NULL);
    const YkPoisson *factor = times(rise, rise->height, yk_ring_power(ring, rise->rate, order));
    if (rise->factor) factor = times(rise, factor, rise->factor);
    if (yk_page_is_negative(ring, f)) f = yk_ring_negate(ring, f), factor = yk_ring_negate(ring, factor);
    int64_t over, under;
    bool has_base = order == 0 && !yk_ring_is_zero(rise->base), is_number = yk_ring_is_rational(f, &over, &under);
    if (is_number && over != 0) factor = times(rise, factor, f), f = number(rise, 1, 1);
    bool is_negative = yk_page_is_negative(ring, factor);
    const YkPoisson *value = times(rise, factor, f), *shown = is_negative ? yk_ring_negate(ring, factor) : factor;
    if (has_base) value = plus(rise, value, rise->base);
    if (has_base) yk_line_element(law->page, line, rise->base, YK_RING_TEXTBOOK);
    if (is_number && over == 0) {
        yk_line_sign(law->page, line, "0");
    } else {
        if (has_base || is_negative) yk_line_sign(law->page, line, is_negative ? "-" : "+");
        if (is_number)
            yk_line_element(law->page, line, shown, YK_RING_TEXTBOOK);
        else
            yk_derive_put_bracket(law->page, line, shown, f, rise->span.u);
    }
    yk_derive_end_line(law, line, order, value, within, letter);
}

static void put_range(const Rise *rise, const YkPoisson *from, const YkPoisson *to)
{
    YkText low = {0}, high = {0};
    YkRing *ring = ring_of(rise);
    const YkPoisson *ends[] = {from, to};
    YkText *texts[] = {&low, &high};
    for (int k = 0; k < 2; k++) yk_ring_write(ring, ends[k], YK_RING_BOOK, YK_RING_TEXTBOOK, texts[k]);
    yk_page_words(rise->law->page,
                  "For %s from %s to %s:", yk_ring_symbol_name(ring, yk_ring_next_symbol(ring, rise->span.u, -1)),
                  yk_text_get(&low), yk_text_get(&high));
    yk_text_free(&low);
    yk_text_free(&high);
}

// Clips the zone to the part of f that is used, and finds where u lies in 0 to 1 within it.
static bool clip(Rise *rise, const Zone *zone, const YkPoisson **from, const YkPoisson **to)
{
    YkDerivation *d = rise->law->d;
    const YkPoisson *low = yk_derive_fixed(d, zone->from) > yk_derive_fixed(d, rise->low) ? zone->from : rise->low;
    const YkPoisson *high = yk_derive_fixed(d, zone->to) < yk_derive_fixed(d, rise->high) ? zone->to : rise->high;
    const YkPoisson *width = minus(rise, rise->high, rise->low);
    *from = yk_ring_divide(d->ring, minus(rise, low, rise->low), width);
    *to = yk_ring_divide(d->ring, minus(rise, high, rise->low), width);
    return yk_derive_fixed(d, *to) - yk_derive_fixed(d, *from) > 1e-12;
}

static void put_zone(Rise *rise, size_t index)
{
    YkDeriveLaw *law = rise->law;
    YkRing *ring = ring_of(rise);
    const Zone *zone = &rise->zones[index];
    const YkPoisson *from, *to, *f = zone->f;
    char letter[2] = {(char)('a' + (int)index), '\0'};
    if (!clip(rise, zone, &from, &to)) return;
    if (rise->count > 1) put_range(rise, from, to);
    const YkPoisson *within = yk_ring_divide(ring, minus(rise, rise->span.u, from), minus(rise, to, from));
    if (zone->phi) {
        const YkPoisson *meaning = yk_derive_in_joints(law->d, zone->phi);
        YkLine *line = yk_page_equation(law->page, NULL, zone->phi, meaning, YK_RING_TEXTBOOK);
        int32_t symbol = yk_ring_next_symbol(ring, zone->phi, -1);
        if (line) line->solved = symbol, line->over = meaning, line->within = within;
    }
    for (int order = 0; order < YK_DERIVE_ORDERS; order++) {
        put_order(rise, order, f, within, rise->count > 1 ? letter : "");
        if (order + 1 < YK_DERIVE_ORDERS) f = derivative(rise, zone, f);
    }
}

void yk_derive_put_rise(YkDeriveLaw *law, const YkLawPart *part)
{
    YkDerivation *d = law->d;
    Rise *rise = YK_NEW(law->page->arena, Rise, 1);
    const YkPoisson *to = yk_derive_given(d, part->to.expr), *by = yk_derive_given(d, part->by.expr),
                    *start = law->value;
    bool is_fall = part->kind == YK_LAW_FALL;
    const YkPoisson *from = law->at;
    law->at = to;
    law->value = is_fall ? yk_ring_subtract(d->ring, start, by) : yk_ring_add(d->ring, start, by);
    if (!rise || !from || !start || !to || !by) {
        yk_page_words(law->page, "Its ends are not polynomials of the parameters.");
        return;
    }
    *rise = (Rise){.law = law, .part = part};
    const YkPoisson *h = yk_derive_call(law, "h", by);
    if (!place(rise, is_fall, from, to) || !make_zones(rise)) {
        yk_page_words(law->page, "Its parts are not exact numbers: `yoke cam` gives its values.");
        return;
    }
    scale(rise, is_fall ? law->value : start, by, h);
    if (!put_factor(rise)) return;
    for (size_t k = 0; k < rise->count; k++) put_zone(rise, k);
}
