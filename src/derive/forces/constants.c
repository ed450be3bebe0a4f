// Roots and quotients that forces of gears and cams need: exact if they are polynomials, otherwise symbols whose
// meaning the page states. Their values are put back before anything is proved.
#include "derive/forces/free_bodies.h"
#include "derive/relations.h"

// The same name with underscores behind it, where it is taken.
static const char *free_name(YkDerivation *d, const char *name)
{
    YkText text = {0};
    for (const char *c = name; *c; c++) {
        bool fits = (*c >= 'a' && *c <= 'z') || (*c >= 'A' && *c <= 'Z') || (*c >= '0' && *c <= '9') || *c == '.';
        yk_text_format(&text, "%c", fits ? *c : '_');
    }
    while (!text.failed && yk_ring_find(d->ring, yk_text_get(&text)) >= 0) yk_text_format(&text, "_");
    const char *copy = yk_derive_text(d, yk_text_get(&text), "", "");
    d->failed |= text.failed;
    yk_text_free(&text);
    return copy;
}

static const YkPoisson *exact_root(YkRing *ring, const YkPoisson *square)
{
    int64_t over, under;
    if (!yk_ring_is_rational(square, &over, &under) || over <= 0 || over > INT32_MAX || under > INT32_MAX) return NULL;
    const YkPoisson *root = yk_ring_sqrt(ring, over * under);
    if (!root && yk_ring_status(ring) == YK_RING_POWER) yk_ring_clear(ring);
    return root ? yk_ring_scale(ring, root, 1, under) : NULL;
}

const YkPoisson *yk_derive_root(YkDeriveForces *f, const char *name, const char *word, const YkPoisson *square)
{
    YkDerivation *d = f->d;
    if (!square || yk_ring_status(d->ring) != YK_RING_OK) return NULL;
    const YkPoisson *exact = exact_root(d->ring, square);
    if (exact) return exact;
    YkDeriveLength *length = &f->lengths[f->length_count++];
    *length = (YkDeriveLength){.word = word, .rate_symbol = YK_NONE, .square = square};
    length->symbol = yk_ring_root(d->ring, free_name(d, name), square);
    return length->symbol < 0 ? NULL : yk_ring_of(d->ring, length->symbol);
}

// Where both are multiples of one polynomial, their quotient is that of the factors.
static const YkPoisson *exact_ratio(YkRing *ring, const YkPoisson *over, const YkPoisson *under)
{
    const YkPoisson *factor[] = {yk_ring_content(ring, over), yk_ring_content(ring, under)};
    const YkPoisson *rest[] = {yk_ring_divide(ring, over, factor[0]), yk_ring_divide(ring, under, factor[1])};
    const YkPoisson *ratio = yk_ring_divide(ring, factor[0], factor[1]);
    if (yk_ring_is_same(rest[0], rest[1])) return ratio;
    if (yk_ring_is_same(rest[0], yk_ring_negate(ring, rest[1]))) return yk_ring_negate(ring, ratio);
    return yk_ring_terms(under) == 1 ? yk_ring_divide(ring, over, under) : NULL;
}

const YkPoisson *yk_derive_ratio(YkDeriveForces *f, const char *name, const char *word, const YkPoisson *over,
                                 const YkPoisson *under)
{
    YkDerivation *d = f->d;
    if (!over || !under || yk_ring_status(d->ring) != YK_RING_OK) return NULL;
    const YkPoisson *exact = exact_ratio(d->ring, over, under);
    if (exact || yk_ring_status(d->ring) != YK_RING_OK) return exact;
    YkDeriveRatio *ratio = &f->ratios[f->ratio_count++];
    *ratio = (YkDeriveRatio){.over = over, .under = under, .word = word};
    ratio->symbol = yk_derive_symbol(d, name, YK_RING_CONSTANT);
    return ratio->symbol < 0 ? NULL : yk_ring_of(d->ring, ratio->symbol);
}

// The sum over k of coefficient_k x^k with x = over / under, times a power of under.
static const YkPoisson *without_ratio(YkRing *ring, const YkPoisson *a, const YkDeriveRatio *ratio)
{
    int32_t lowest, highest;
    if (!yk_ring_mentions(ring, a, ratio->symbol) || !yk_ring_powers(ring, a, ratio->symbol, &lowest, &highest))
        return a;
    if (lowest > 0) lowest = 0;
    const YkPoisson *sum = yk_ring_rational(ring, 0, 1);
    for (int32_t k = lowest; k <= highest; k++) {
        const YkPoisson *factors[] = {yk_ring_coefficient(ring, a, ratio->symbol, k),
                                      yk_ring_power(ring, ratio->over, k - lowest),
                                      yk_ring_power(ring, ratio->under, highest - k)};
        sum = yk_ring_add(ring, sum, yk_ring_product(ring, factors, 3));
    }
    return sum;
}

bool yk_derive_is_nothing(const YkDeriveForces *f, const YkPoisson *a)
{
    YkRing *ring = f->d->ring;
    for (size_t k = 0; k < f->d->tie_count && a; k++) {
        const YkDeriveMesh *mesh = &f->meshes[k];
        if (!mesh->direction || !yk_ring_mentions(ring, a, mesh->lean)) continue;
        YkRingChange change = {mesh->lean, NULL, yk_ring_divide(ring, mesh->direction, mesh->length)};
        a = yk_ring_substitute(ring, a, &change, 1);
    }
    for (size_t k = 0; k < f->ratio_count && a; k++) a = without_ratio(ring, a, &f->ratios[k]);
    return a && yk_ring_is_equal(ring, a, yk_ring_rational(ring, 0, 1));
}

static void put_mesh(const YkDeriveForces *f, YkPage *page, const YkDeriveMesh *mesh, const char *of)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    const char *name = yk_ring_symbol_name(ring, mesh->symbol);
    yk_page_words(page, "%s: %s is %s.", of, name, mesh->word);
    if (mesh->lean == YK_NONE) return;
    const char *lean = yk_ring_symbol_name(ring, mesh->lean);
    if (!mesh->direction) {
        yk_page_words(page, "%s is the pressure angle of %e deg with the sign of %s: flanks push their wheels apart.",
                      lean, mesh->lean_value * 180 / YK_PI, name);
        return;
    }
    const YkPoisson *direction = yk_derive_shown(d, mesh->direction), *unit = yk_ring_unit(ring, mesh->lean);
    const YkPoisson *x = yk_ring_real(ring, direction), *y = yk_ring_imaginary(ring, direction);
    const YkPoisson *cosine = yk_ring_real(ring, unit), *sine = yk_ring_imaginary(ring, unit);
    const YkPoisson *left = yk_ring_multiply(ring, x, sine), *right = yk_ring_multiply(ring, y, cosine),
                    *zero = yk_ring_cross(ring, direction, unit);
    bool is_tangent = yk_ring_terms(left) + yk_ring_terms(right) <= yk_ring_terms(zero); // tan phi = y / x
    yk_page_equation(page, "angle of the normal", is_tangent ? left : zero, is_tangent ? right : NULL,
                     YK_RING_TEXTBOOK);
}

void yk_derive_put_meshes(const YkDeriveForces *f, YkPage *page)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    if (page->told_in && page->told_in != page->section) return; // by an earlier section
    page->told_in = page->section;
    for (size_t k = 0; k < d->tie_count; k++) put_mesh(f, page, &f->meshes[k], d->ties[k].name);
    for (size_t k = 0; k < f->length_count; k++) {
        const YkDeriveLength *l = &f->lengths[k];
        if (!l->word || !*l->word) continue;
        yk_page_equation(page, l->word, yk_ring_power(ring, yk_ring_of(ring, l->symbol), 2),
                         yk_derive_shown(d, l->square), YK_RING_TEXTBOOK);
    }
    for (size_t k = 0; k < f->ratio_count; k++) {
        const YkDeriveRatio *r = &f->ratios[k];
        yk_page_solution(page, r->word, r->symbol, r->over, r->under);
    }
    yk_derive_put_loads(f, page);
}
