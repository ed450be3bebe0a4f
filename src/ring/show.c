// The tree of sums and products.
#include "ring/shown.h"

YkShow *yk_show(YkSheet *sheet, YkShowKind kind)
{
    YkShow *show = YK_NEW(sheet->arena, YkShow, 1);
    if (show)
        *show = (YkShow){.kind = kind, .exponent = 1, .number = {1, 1}};
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
    bool same = part->kind == whole->kind && part->exponent == 1;
    if (!same) {
        link_part(whole, part);
        return;
    }
    if (whole->kind == YK_SHOW_PRODUCT && part->negative) whole->negative = !whole->negative;
    for (YkShow *inner = part->first, *next; inner; inner = next) {
        next = inner->next;
        if (whole->kind == YK_SHOW_SUM && part->negative) inner->negative = !inner->negative;
        link_part(whole, inner);
    }
}

size_t yk_show_count(const YkShow *whole)
{
    size_t count = 0;
    for (const YkShow *part = whole ? whole->first : NULL; part; part = part->next) count++;
    return count;
}

YkShow *yk_show_simplest(YkShow *sum)
{
    if (!sum || yk_show_count(sum) != 1) return sum;
    sum->first->negative = sum->first->negative != sum->negative;
    return sum->first;
}

static void append_symbols(YkSheet *sheet, YkShow *product, uint32_t monomial, unsigned from_class, unsigned to_class)
{
    uint32_t count;
    const YkPower *powers = yk_powers_of(&sheet->ring->monomials, monomial, &count);
    for (unsigned kind = from_class; kind <= to_class; kind++)
        for (uint32_t i = 0; i < count; i++) {
            if (sheet->ring->symbols[powers[i].symbol].kind != kind) continue;
            YkShow *symbol = yk_show(sheet, YK_SHOW_SYMBOL);
            if (symbol) {
                symbol->symbol = powers[i].symbol;
                symbol->exponent = powers[i].exponent;
            }
            yk_show_append(product, symbol);
        }
}

// i and sqrt(2), sqrt(3), sqrt(6).
static void append_unit(YkSheet *sheet, YkShow *product, const YkAtom *atom)
{
    if (atom->is_imaginary) yk_show_append(product, yk_show(sheet, YK_SHOW_I));
    if (atom->surd == 0) return;
    YkShow *root = yk_show(sheet, YK_SHOW_SQRT);
    int64_t square = (atom->surd & YK_UNIT_SQRT2 ? 2 : 1) * (atom->surd & YK_UNIT_SQRT3 ? 3 : 1);
    if (root) root->number = (YkRatio){square, 1};
    yk_show_append(product, root);
}

YkShow *yk_show_term(YkSheet *sheet, YkRatio number, uint32_t monomial, const YkAtom *atom)
{
    YkShow *product = yk_show(sheet, YK_SHOW_PRODUCT);
    YkRatio size = {number.over < 0 ? -number.over : number.over, number.under};
    bool is_bare =
        monomial == 0 && (!atom || (atom->function == YK_SHOWN_ONE && !atom->is_imaginary && atom->surd == 0));
    if (!yk_ratio_is(size, 1) || is_bare) {
        YkShow *part = yk_show(sheet, YK_SHOW_NUMBER);
        if (part) part->number = size;
        yk_show_append(product, part);
    }
    if (atom) append_unit(sheet, product, atom);
    append_symbols(sheet, product, monomial, YK_RING_INERTIA, YK_RING_FORCE);
    if (atom && atom->function != YK_SHOWN_ONE) {
        YkShow *function = yk_show(sheet, YK_SHOW_FUNCTION);
        if (function) function->atom = *atom;
        yk_show_append(product, function);
    }
    append_symbols(sheet, product, monomial, YK_RING_RATE, YK_RING_ACCELERATION);
    if (product) product->negative = number.over < 0;
    return product;
}

uint32_t yk_constant_angles(const YkRing *ring, uint32_t phase)
{
    uint32_t count, constant = 0;
    const YkPower *powers = yk_powers_of(&ring->phases, phase, &count);
    for (uint32_t i = 0; i < count; i++) constant += ring->symbols[powers[i].symbol].pi_over > 0;
    return constant;
}

bool yk_angle_shown(const YkSheet *sheet, const YkAtom *atom, uint32_t k, YkAngleShown *shown)
{
    uint32_t count;
    const YkPower *powers = yk_powers_of(&sheet->ring->phases, atom->phase, &count);
    if (k < count) {
        int64_t exponent = powers[k].exponent, pi_over = sheet->ring->symbols[powers[k].symbol].pi_over;
        // 3 pi_7 is shown as 3 pi/7, which reads back so; 7 pi_7 as it is, since 7 pi/7 would read as pi, and pi_5 +
        // pi_7, too.
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
