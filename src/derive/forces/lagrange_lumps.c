// Part of the section on Lagrange's equations: lumped constants, and the equations in them.
#include "derive/forces/lagrange.h"

// A power of one symbol needs no name of its own.
static bool is_worth_a_name(const YkDerivation *d, const YkPoisson *lump)
{
    int32_t first = yk_ring_next_symbol(d->ring, lump, -1);
    return yk_ring_terms(lump) > 1 || (first >= 0 && yk_ring_next_symbol(d->ring, lump, first) >= 0);
}

// Weights stay visible, since readers look for gravity.
static YkRingClass class_of(const YkDerivation *d, const YkPoisson *lump)
{
    for (int32_t s = -1; (s = yk_ring_next_symbol(d->ring, lump, s)) >= 0;)
        if (yk_ring_symbol_class(d->ring, s) == YK_RING_GRAVITY) return YK_RING_GRAVITY;
    return YK_RING_CONSTANT;
}

static const char *lump_name(YkDerivation *d, size_t number)
{
    YkText text = {0};
    yk_text_format(&text, "p%z", number);
    const char *name = yk_derive_text(d, yk_text_get(&text), "", "");
    yk_text_free(&text);
    return name;
}

// p1, p2, ...
static int32_t symbol_of(void *context, const YkPoisson *lump)
{
    const YkDeriveForces *f = context;
    YkDerivation *d = f->d;
    size_t count = 1;
    YkDeriveLump **at = f->lumps;
    for (; *at; at = &(*at)->next, count++)
        if (yk_ring_is_same((*at)->value, lump)) return (*at)->symbol;
    if (!is_worth_a_name(d, lump)) return -1;
    YkDeriveLump *made = YK_NEW(d->arena, YkDeriveLump, 1);
    if (!made) return -1;
    const char *name = lump_name(d, count);
    *made = (YkDeriveLump){.symbol = yk_derive_symbol(d, name, class_of(d, lump)), .value = lump};
    if (made->symbol < 0) return -1;
    *at = made;
    yk_derive_add_unknown(d, made->symbol);
    yk_derive_add_relation(d, yk_ring_subtract(d->ring, yk_ring_of(d->ring, made->symbol), lump));
    return made->symbol;
}

const YkPoisson *yk_derive_lumped(const YkDeriveForces *f, const YkPoisson *a)
{
    return yk_ring_lump(f->d->ring, a, symbol_of, (void *)f);
}

void yk_derive_put_lumps(const YkDeriveForces *f, YkPage *page, const YkDeriveLagrange *equations, size_t count)
{
    YkRing *ring = f->d->ring;
    const YkPoisson **lumped = YK_NEW(page->arena, const YkPoisson *, count + 1);
    if (!lumped) return;
    for (size_t k = 0; k < count; k++) lumped[k] = yk_derive_lumped(f, equations[k].left);
    if (!f->lumps[0]) return;
    yk_page_heading(page, 2, "Lumped constants");
    for (const YkDeriveLump *l = f->lumps[0]; l; l = l->next) yk_page_solution(page, NULL, l->symbol, l->value, NULL);
    for (size_t k = 0; k < count; k++) yk_page_equation(page, NULL, lumped[k], equations[k].right, YK_RING_TEXTBOOK);
    page->failed |= yk_ring_status(ring) != YK_RING_OK;
}
