// Derivations of the ring: fixed by what they do to the symbols, the rest is Leibniz.
// D(c x^n e^(i k a)) = c x^n e^(i k a) (n D(x) / x + i k D(a)).
#include "ring/inside.h"

enum { TIME = -1, DEPTH_MAX = 64 }; // the variable that stands for time; dependence upon dependence

static const YkPoisson *derivative(YkRing *ring, const YkPoisson *a, int32_t variable, int depth);
static const YkPoisson *symbol_derivative(YkRing *ring, int32_t index, int32_t variable, int depth);

// D of a dependent symbol by the chain rule.
static const YkPoisson *chain(YkRing *ring, const YkPartial *partials, int32_t variable, int depth)
{
    const YkPoisson *sum = ring->zero;
    for (const YkPartial *partial = partials; partial; partial = partial->next) {
        const YkPoisson *inner = symbol_derivative(ring, partial->variable, variable, depth + 1);
        if (!inner) return NULL;
        if (inner->count == 0) continue;
        if (!partial->derivative) return yk_ring_fail(ring, YK_RING_DERIVATIVE);
        sum = yk_ring_add(ring, sum, yk_ring_multiply(ring, partial->derivative, inner));
    }
    return sum;
}

static const YkPoisson *root_derivative(YkRing *ring, int32_t index, int32_t variable, int depth)
{
    const YkPoisson *inner = derivative(ring, ring->symbols[index].square, variable, depth + 1);
    return yk_ring_divide(ring, inner, yk_ring_scale(ring, yk_ring_of(ring, index), 2, 1));
}

// What D does to a symbol. That of a root or a function is kept until a rule is added.
static const YkPoisson *symbol_derivative(YkRing *ring, int32_t index, int32_t variable, int depth)
{
    const YkRingSymbol *symbol = &ring->symbols[index];
    if (index == variable) return ring->one;
    if (variable == TIME && symbol->rate) return symbol->rate;
    if (!symbol->square && !symbol->partials) return ring->zero;
    if (symbol->known && symbol->known_variable == variable && symbol->known_rules == ring->rule_count)
        return symbol->known;
    if (depth > DEPTH_MAX) return yk_ring_fail(ring, YK_RING_DERIVATIVE);
    const YkPoisson *known =
        symbol->square ? root_derivative(ring, index, variable, depth) : chain(ring, symbol->partials, variable, depth);
    YkRingSymbol *kept = &ring->symbols[index]; // symbols may have moved
    kept->known = known, kept->known_variable = variable, kept->known_rules = ring->rule_count;
    return known;
}

// The images of all powers of `a`, in their order, on top of the ring's stack; their common denominator. The tables of
// powers and the stack may grow while derivatives are made: indices, not pointers.
static bool push_images(YkRing *ring, const YkPoisson *a, int32_t variable, int depth, int64_t *denominator)
{
    *denominator = 1;
    for (size_t i = 0; i < a->count; i++)
        for (int side = 0; side < 2; side++) {
            const YkPowers *table = side == 0 ? &ring->monomials : &ring->phases;
            uint64_t key = a->terms[i].key;
            uint32_t item = side == 0 ? yk_key_monomial(key) : yk_key_phase(key), count;
            yk_powers_of(table, item, &count);
            for (uint32_t k = 0; k < count; k++) {
                int32_t symbol = yk_powers_of(table, item, &count)[k].symbol;
                const YkPoisson *image = symbol_derivative(ring, symbol, variable, depth);
                if (!image) return false;
                if (!YK_ROOM(ring->images, ring->image_count, ring->image_capacity))
                    return yk_ring_fail(ring, YK_RING_MEMORY) != NULL;
                ring->images[ring->image_count++] = image;
                if (!yk_common_denominator(*denominator, image->denominator, denominator))
                    return yk_ring_fail(ring, YK_RING_OVERFLOW) != NULL;
            }
        }
    return true;
}

// Gathers term * factor * image.
static bool add_image(YkRing *ring, YkRingTerm term, int64_t factor, const YkPoisson *image, int64_t denominator)
{
    if (!yk_exact_multiply(factor, denominator / image->denominator, &factor)) {
        ring->gather.failed = true;
        yk_ring_fail(ring, YK_RING_OVERFLOW);
        return false;
    }
    for (size_t i = 0; i < image->count; i++)
        if (!yk_gather_add_product(ring, &term, &image->terms[i], factor)) return false;
    return true;
}

// images: of the powers of this monomial.
static bool add_monomial_part(YkRing *ring, YkRingTerm term, const YkPoisson *const *images, int64_t denominator)
{
    uint32_t monomial = yk_key_monomial(term.key), count;
    yk_powers_of(&ring->monomials, monomial, &count);
    for (uint32_t k = 0; k < count; k++) {
        const YkPower power = yk_powers_of(&ring->monomials, monomial, &count)[k];
        if (images[k]->count == 0) continue;
        uint32_t one = yk_ring_monomial_of(ring, power.symbol, 1);
        uint32_t less = one == YK_NO_PRODUCT ? one : yk_ring_monomial(ring, monomial, one, -1);
        if (less == YK_NO_PRODUCT) return !(ring->gather.failed = true);
        YkRingTerm rest = {yk_key(yk_key_phase(term.key), less, yk_key_unit(term.key)), term.number};
        if (!add_image(ring, rest, power.exponent, images[k], denominator)) return false;
    }
    return true;
}

// images: of the powers of this phase.
static bool add_phase_part(YkRing *ring, YkRingTerm term, const YkPoisson *const *images, int64_t denominator)
{
    uint32_t phase = yk_key_phase(term.key), count;
    yk_powers_of(&ring->phases, phase, &count);
    bool has_i = term.key & YK_UNIT_I;
    YkRingTerm turned = {term.key ^ YK_UNIT_I, has_i ? -term.number : term.number}; // i times the term
    for (uint32_t k = 0; k < count; k++) {
        const YkPower power = yk_powers_of(&ring->phases, phase, &count)[k];
        if (images[k]->count > 0 && !add_image(ring, turned, power.exponent, images[k], denominator)) return false;
    }
    return true;
}

static const YkPoisson *gather_derivative(YkRing *ring, const YkPoisson *a, size_t first_image, int64_t denominator)
{
    int64_t whole;
    const YkPoisson *const *images = ring->images + first_image;
    if (!yk_exact_multiply(a->denominator, denominator, &whole)) return yk_ring_fail(ring, YK_RING_OVERFLOW);
    yk_gather_begin(ring, whole);
    for (size_t i = 0; i < a->count; i++) {
        if (!add_monomial_part(ring, a->terms[i], images, denominator)) break;
        images += ring->monomials.items[yk_key_monomial(a->terms[i].key)].count;
        if (!add_phase_part(ring, a->terms[i], images, denominator)) break;
        images += ring->phases.items[yk_key_phase(a->terms[i].key)].count;
    }
    return yk_gather_end(ring);
}

static const YkPoisson *derivative(YkRing *ring, const YkPoisson *a, int32_t variable, int depth)
{
    if (!a || a->count == 0) return a;
    size_t first_image = ring->image_count;
    int64_t denominator;
    bool well = push_images(ring, a, variable, depth, &denominator);
    const YkPoisson *result = well ? gather_derivative(ring, a, first_image, denominator) : NULL;
    ring->image_count = first_image;
    return result;
}

const YkPoisson *yk_ring_partial(YkRing *ring, const YkPoisson *a, int32_t variable)
{
    if (!a) return NULL;
    if (variable < 0 || (size_t)variable >= ring->symbol_count) return yk_ring_fail(ring, YK_RING_NAME);
    return derivative(ring, a, variable, 0);
}

const YkPoisson *yk_ring_time_derivative(YkRing *ring, const YkPoisson *a)
{
    return a ? derivative(ring, a, TIME, 0) : NULL;
}
