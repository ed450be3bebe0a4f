// Derivations of the ring, determined by their effect on the symbols and the product rule: D(c x^n e^(i k a)) = c x^n
// e^(i k a) (n D(x) / x + i k D(a)).
#include "ring/inside.h"

enum { TIME = -1, DEPTH_MAX = 64 }; // TIME: the variable that stands for time; DEPTH_MAX: nested dependences

static const YkPoisson *derivative(YkRing *ring, const YkPoisson *a, int32_t variable, int depth);
static const YkPoisson *symbol_derivative(YkRing *ring, int32_t index, int32_t variable, int depth);

// Differentiates a dependent symbol by the chain rule.
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
    const YkPoisson *inner = derivative(ring, ring->symbols[index].meaning->square, variable, depth + 1);
    return yk_ring_divide(ring, inner, yk_ring_scale(ring, yk_ring_of(ring, index), 2, 1));
}

// Returns D of a symbol. That of a root or a function is kept until a rule is added.
static const YkPoisson *symbol_derivative(YkRing *ring, int32_t index, int32_t variable, int depth)
{
    const YkRingSymbol *symbol = &ring->symbols[index];
    if (index == variable) return ring->one;
    if (variable == TIME && symbol->rate) return symbol->rate;
    const YkRingMeaning *is = symbol->meaning;
    if (!is->square && !is->partials) return ring->zero;
    if (is->known && is->known_variable == variable && is->known_rules == ring->rule_count) return is->known;
    if (depth > DEPTH_MAX) return yk_ring_fail(ring, YK_RING_DERIVATIVE);
    const YkPoisson *known =
        is->square ? root_derivative(ring, index, variable, depth) : chain(ring, is->partials, variable, depth);
    YkRingMeaning *kept = yk_ring_meaning(ring, index);
    known = yk_ring_keep(ring, known);
    if (kept) kept->known = known, kept->known_variable = variable, kept->known_rules = ring->rule_count;
    return known;
}

// Returns the marks of all symbols whose derivative is not 0, perhaps with marks of others.
static uint64_t marks_touched(const YkRing *ring, int32_t variable)
{
    return ring->dependent_marks | (variable == TIME ? ring->moving_marks : yk_mark(variable));
}

static bool find_images_of(YkRing *ring, const YkPowers *table, uint32_t item, int32_t variable, int depth,
                           int64_t *denominator)
{
    if (!(table->items[item].marks & ring->dependent_marks)) return true;
    for (uint32_t k = 0; k < table->items[item].count; k++) { // the pool may move while derivatives are made
        int32_t symbol = table->pool[table->items[item].first + k].symbol;
        const YkPoisson *image = symbol_derivative(ring, symbol, variable, depth);
        if (!image) return false;
        if (image->denominator != 1 && !yk_common_denominator(*denominator, image->denominator, denominator))
            return yk_ring_fail(ring, YK_RING_OVERFLOW) != NULL;
    }
    return true;
}

// Makes the missing images, those of symbols that depend on others; finds the common denominator of all.
static bool find_images(YkRing *ring, const YkPoisson *a, int32_t variable, int depth, int64_t *denominator)
{
    *denominator = 1;
    for (size_t i = 0; i < a->count && ring->dependent_marks != 0; i++) {
        uint64_t key = a->terms[i].key;
        if (!find_images_of(ring, &ring->monomials, yk_key_monomial(key), variable, depth, denominator) ||
            !find_images_of(ring, &ring->phases, yk_key_phase(key), variable, depth, denominator))
            return false;
    }
    return true;
}

// A derivation while its terms are gathered: all images are available.
typedef struct Gathering {
    YkRing *ring;
    int32_t variable;
    int64_t denominator; // common denominator of all images
    uint64_t touched;
} Gathering;

static const YkPoisson *image_of(const Gathering *d, int32_t index)
{
    const YkRingSymbol *symbol = &d->ring->symbols[index];
    if (index == d->variable) return d->ring->one;
    if (!(yk_mark(index) & d->touched)) return d->ring->zero;
    if (d->variable == TIME && symbol->rate) return symbol->rate;
    const YkRingMeaning *is = symbol->meaning;
    return is->square || is->partials ? is->known : d->ring->zero;
}

// Gathers term * factor * image.
static bool add_image(const Gathering *d, YkRingTerm term, int64_t factor, const YkPoisson *image)
{
    YkRing *ring = d->ring;
    if (d->denominator != 1 && !yk_exact_multiply(factor, d->denominator / image->denominator, &factor)) {
        ring->gather.failed = true;
        yk_ring_fail(ring, YK_RING_OVERFLOW);
        return false;
    }
    if (!yk_ring_spend(ring, image->count * YK_WORK_PRODUCT)) return !(ring->gather.failed = true);
    for (size_t i = 0; i < image->count; i++)
        if (!yk_gather_add_product(ring, &term, &image->terms[i], factor)) return false;
    return true;
}

static bool add_monomial_part(const Gathering *d, YkRingTerm term)
{
    YkRing *ring = d->ring;
    uint32_t monomial = yk_key_monomial(term.key);
    if (!(ring->monomials.items[monomial].marks & d->touched)) return true;
    for (uint32_t k = 0; k < ring->monomials.items[monomial].count; k++) { // the pool may move
        const YkPower power = ring->monomials.pool[ring->monomials.items[monomial].first + k];
        const YkPoisson *image = image_of(d, power.symbol);
        if (image->count == 0) continue;
        uint32_t one = yk_ring_monomial_of(ring, power.symbol, 1);
        uint32_t less = one == YK_NO_PRODUCT ? one : yk_ring_monomial(ring, monomial, one, -1);
        if (less == YK_NO_PRODUCT) return !(ring->gather.failed = true);
        YkRingTerm rest = {yk_key(yk_key_phase(term.key), less, yk_key_unit(term.key)), term.number};
        if (!add_image(d, rest, power.exponent, image)) return false;
    }
    return true;
}

static bool add_phase_part(const Gathering *d, YkRingTerm term)
{
    YkRing *ring = d->ring;
    uint32_t phase = yk_key_phase(term.key);
    if (!(ring->phases.items[phase].marks & d->touched)) return true;
    bool has_i = term.key & YK_UNIT_I;
    YkRingTerm turned = {term.key ^ YK_UNIT_I, has_i ? -term.number : term.number}; // i times the term
    for (uint32_t k = 0; k < ring->phases.items[phase].count; k++) {
        const YkPower power = ring->phases.pool[ring->phases.items[phase].first + k];
        const YkPoisson *image = image_of(d, power.symbol);
        if (image->count > 0 && !add_image(d, turned, power.exponent, image)) return false;
    }
    return true;
}

static const YkPoisson *derivative(YkRing *ring, const YkPoisson *a, int32_t variable, int depth)
{
    int64_t whole;
    Gathering d = {ring, variable, 1, marks_touched(ring, variable)};
    if (!a || a->count == 0) return a;
    if (!find_images(ring, a, variable, depth, &d.denominator)) return NULL;
    if (!yk_exact_multiply(a->denominator, d.denominator, &whole)) return yk_ring_fail(ring, YK_RING_OVERFLOW);
    yk_gather_begin(ring, whole);
    for (size_t i = 0; i < a->count; i++)
        if (!add_monomial_part(&d, a->terms[i]) || !add_phase_part(&d, a->terms[i])) break;
    return yk_gather_end(ring);
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
