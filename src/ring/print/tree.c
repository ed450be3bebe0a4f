// The tree of sums and products.
#include "ring/print/shown.h"

YkShow *yk_show(YkSheet *sheet, YkShowKind kind)
{
    YkShow *show = yk_arena_take(sheet->arena, sizeof *show);
    if (show)
        *show = (YkShow){.kind = kind, .exponent = 1};
    else
        sheet->failed = true;
    return show;
}

static void link_part(YkShow *whole, YkShow *part)
{
    part->next = NULL;
    if (whole->last)
        whole->last->next = part;
    else
        whole->first = part;
    whole->last = part;
}

void yk_show_append(YkShow *whole, YkShow *part)
{
    if (!whole || !part) return;
    if (whole->kind == YK_SHOW_PRODUCT && part->kind != YK_SHOW_SUM && part->negative) {
        whole->negative = !whole->negative;
        part->negative = false;
    }
    if (part->kind != whole->kind || part->exponent != 1) {
        link_part(whole, part);
        return;
    }
    for (YkShow *inner = part->first, *next; inner; inner = next) {
        next = inner->next;
        if (whole->kind == YK_SHOW_SUM && part->negative) inner->negative = !inner->negative;
        link_part(whole, inner);
    }
}

YkShow *yk_show_simplest(YkShow *sum)
{
    if (!sum || !sum->first || sum->first != sum->last) return sum;
    sum->first->negative = sum->first->negative != sum->negative;
    return sum->first;
}

YkShow *yk_show_term(YkSheet *sheet, YkRatio number, YkMonomial monomial, const YkAtom *atom)
{
    const YkAtom none = {.function = YK_SHOWN_ONE};
    YkShow *term = yk_arena_take(sheet->arena, sizeof *term);
    if (!term) {
        sheet->failed = true;
        return NULL;
    }
    if (!atom) atom = &none;
    bool is_bare = monomial.count == 0 && atom->function == YK_SHOWN_ONE && !atom->is_imaginary && atom->surd == 0;
    bool negative = number.over < 0;
    if (negative) number.over = -number.over;
    *term = (YkShow){.kind = YK_SHOW_TERM,
                     .negative = negative,
                     .has_number = is_bare || !yk_ratio_is(number, 1),
                     .exponent = 1,
                     .term = {monomial, number, *atom}};
    return term;
}

YkShow *yk_show_product(YkSheet *sheet, YkShow *part)
{
    YkShow *product = yk_show(sheet, YK_SHOW_PRODUCT);
    yk_show_append(product, part);
    return product;
}

size_t yk_show_below(const YkShow *product, bool *high)
{
    size_t count = 0;
    *high = false;
    for (const YkShow *factor = yk_show_first(product); factor; factor = yk_show_next(product, factor)) {
        YkMonomial monomial = factor->term.monomial;
        if (!(monomial.classes & YK_MAY_BE_BELOW)) continue;
        for (size_t i = 0; i < monomial.count; i++) {
            if (monomial.powers[i].exponent > 0) continue;
            *high |= monomial.powers[i].exponent < -1;
            count++;
        }
    }
    return count;
}

uint32_t yk_constant_angles(const YkRing *ring, uint32_t phase)
{
    uint32_t count, constant = 0;
    const YkPower *powers = yk_powers_of(&ring->phases, phase, &count);
    for (uint32_t i = 0; i < count; i++) constant += ring->symbols[powers[i].symbol].meaning->pi_over > 0;
    return constant;
}

bool yk_angle_shown(const YkSheet *sheet, const YkAtom *atom, uint32_t k, YkAngleShown *shown)
{
    uint32_t count;
    const YkPower *powers = yk_powers_of(&sheet->ring->phases, atom->phase, &count);
    if (k < count) {
        int64_t exponent = powers[k].exponent, pi_over = sheet->ring->symbols[powers[k].symbol].meaning->pi_over;
        // 3 pi_7 is shown as 3 pi/7, which reads back correctly. 7 pi_7 stays, since 7 pi/7 would read as pi; so does
        // pi_5 + pi_7.
        bool is_pi = pi_over > 0 && sheet->format != YK_RING_C &&
                     yk_gcd(yk_magnitude(exponent), (uint64_t)pi_over) == 1 &&
                     yk_constant_angles(sheet->ring, atom->phase) == 1;
        *shown =
            (YkAngleShown){exponent < 0, exponent < 0 ? -exponent : exponent, is_pi ? -1 : powers[k].symbol, pi_over};
        return true;
    }
    if (k > count || atom->shift == 0) return false;
    YkRatio turns = {0, 1};
    yk_ratio_make(atom->shift, 12, &turns);
    *shown = (YkAngleShown){turns.over < 0, turns.over < 0 ? -turns.over : turns.over, -1, turns.under};
    return true;
}
