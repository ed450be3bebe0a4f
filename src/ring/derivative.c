// Derivations of the ring: fixed by what they do to the symbols, the rest is Leibniz.
// D(c x^n e^(i k a)) = c x^n e^(i k a) (n D(x) / x + i k D(a)).
#include <stdlib.h>
#include <string.h>
#include "ring/inside.h"

enum { TIME = -1, DEPTH_MAX = 64 }; // the variable that stands for time; dependence upon dependence

// What D does to each symbol of one element; NULL where nothing or not yet known.
typedef struct Images {
    const YkPoisson **image; // [symbol count]
    bool *known;
    int64_t denominator; // common to all images
} Images;

static const YkPoisson *derivative(YkRing *ring, const YkPoisson *a, int32_t variable, int depth);

// D of a dependent symbol by the chain rule.
static const YkPoisson *chain(YkRing *ring, const YkRingSymbol *symbol, int32_t variable, int depth);

static const YkPoisson *symbol_derivative(YkRing *ring, int32_t index, int32_t variable, int depth)
{
    if (index == variable) return ring->one;
    const YkRingSymbol symbol = ring->symbols[index]; // a copy: symbols may move
    if (variable == TIME && symbol.rate) return symbol.rate;
    if (depth > DEPTH_MAX) return yk_ring_fail(ring, YK_RING_DERIVATIVE);
    if (symbol.square) {
        const YkPoisson *inner = derivative(ring, symbol.square, variable, depth + 1);
        const YkPoisson *root = yk_ring_of(ring, index);
        return yk_ring_divide(ring, inner, yk_ring_scale(ring, root, 2, 1));
    }
    return chain(ring, &symbol, variable, depth);
}

static const YkPoisson *chain(YkRing *ring, const YkRingSymbol *symbol, int32_t variable, int depth)
{
    const YkPoisson *sum = ring->zero;
    for (const YkPartial *partial = symbol->partials; partial; partial = partial->next) {
        const YkPoisson *inner = symbol_derivative(ring, partial->variable, variable, depth + 1);
        if (!inner) return NULL;
        if (inner->count == 0) continue;
        if (!partial->derivative) return yk_ring_fail(ring, YK_RING_DERIVATIVE);
        sum = yk_ring_add(ring, sum, yk_ring_multiply(ring, partial->derivative, inner));
    }
    return sum;
}

static bool find_image(YkRing *ring, Images *images, int32_t symbol, int32_t variable, int depth)
{
    if (images->known[symbol]) return true;
    const YkPoisson *image = symbol_derivative(ring, symbol, variable, depth);
    if (!image) return false;
    images->known[symbol] = true;
    images->image[symbol] = image->count > 0 ? image : NULL;
    if (yk_common_denominator(images->denominator, image->denominator, &images->denominator)) return true;
    yk_ring_fail(ring, YK_RING_OVERFLOW);
    return false;
}

// The images of all symbols of `a`. The tables of powers may grow while derivatives are made: indices, not pointers.
static bool find_images(YkRing *ring, const YkPoisson *a, int32_t variable, int depth, Images *images)
{
    for (size_t i = 0; i < a->count; i++)
        for (int side = 0; side < 2; side++) {
            const YkPowers *table = side == 0 ? &ring->monomials : &ring->phases;
            uint64_t key = a->terms[i].key;
            uint32_t item = side == 0 ? yk_key_monomial(key) : yk_key_phase(key), count;
            yk_powers_of(table, item, &count);
            for (uint32_t k = 0; k < count; k++)
                if (!find_image(ring, images, yk_powers_of(table, item, &count)[k].symbol, variable, depth))
                    return false;
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

static bool add_monomial_part(YkRing *ring, YkRingTerm term, const Images *images)
{
    uint32_t monomial = yk_key_monomial(term.key), count;
    yk_powers_of(&ring->monomials, monomial, &count);
    for (uint32_t k = 0; k < count; k++) {
        const YkPower power = yk_powers_of(&ring->monomials, monomial, &count)[k];
        const YkPoisson *image = images->image[power.symbol];
        if (!image) continue;
        uint32_t one = yk_ring_monomial_of(ring, power.symbol, 1);
        uint32_t less = one == YK_NO_PRODUCT ? one : yk_ring_monomial(ring, monomial, one, -1);
        if (less == YK_NO_PRODUCT) return !(ring->gather.failed = true);
        YkRingTerm rest = {yk_key(yk_key_phase(term.key), less, yk_key_unit(term.key)), term.number};
        if (!add_image(ring, rest, power.exponent, image, images->denominator)) return false;
    }
    return true;
}

static bool add_phase_part(YkRing *ring, YkRingTerm term, const Images *images)
{
    uint32_t phase = yk_key_phase(term.key), count;
    yk_powers_of(&ring->phases, phase, &count);
    bool has_i = term.key & YK_UNIT_I;
    YkRingTerm turned = {term.key ^ YK_UNIT_I, has_i ? -term.number : term.number}; // i times the term
    for (uint32_t k = 0; k < count; k++) {
        const YkPower power = yk_powers_of(&ring->phases, phase, &count)[k];
        const YkPoisson *image = images->image[power.symbol];
        if (image && !add_image(ring, turned, power.exponent, image, images->denominator)) return false;
    }
    return true;
}

static const YkPoisson *gather_derivative(YkRing *ring, const YkPoisson *a, const Images *images)
{
    int64_t denominator;
    if (!yk_exact_multiply(a->denominator, images->denominator, &denominator))
        return yk_ring_fail(ring, YK_RING_OVERFLOW);
    yk_gather_begin(ring, denominator);
    for (size_t i = 0; i < a->count; i++)
        if (!add_monomial_part(ring, a->terms[i], images) || !add_phase_part(ring, a->terms[i], images)) break;
    return yk_gather_end(ring);
}

static const YkPoisson *derivative(YkRing *ring, const YkPoisson *a, int32_t variable, int depth)
{
    if (!a || a->count == 0) return a;
    Images images = {calloc(ring->symbol_count + 1, sizeof *images.image),
                     calloc(ring->symbol_count + 1, sizeof *images.known), 1};
    const YkPoisson *result = NULL;
    if (!images.image || !images.known)
        yk_ring_fail(ring, YK_RING_MEMORY);
    else if (find_images(ring, a, variable, depth, &images))
        result = gather_derivative(ring, a, &images);
    free(images.image);
    free(images.known);
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
