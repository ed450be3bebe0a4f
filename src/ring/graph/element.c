// Turns elements into operations: sums of constants times sine or cosine, grouped by their common factor.
#include <math.h>
#include <stdlib.h>
#include "ring/graph/inside.h"

// A term of a real element, taken together with its conjugate.
typedef struct Piece {
    uint32_t rest, constant; // monomials: coordinates and rates; constants
    uint32_t phase;
    bool is_sine;
    double number;
    size_t order; // index of the term
} Piece;

static int by_rest(const void *left, const void *right)
{
    const Piece *a = left, *b = right;
    if (a->rest != b->rest) return a->rest < b->rest ? -1 : 1;
    if (a->phase != b->phase) return a->phase < b->phase ? -1 : 1;
    if (a->is_sine != b->is_sine) return a->is_sine ? 1 : -1;
    return a->order < b->order ? -1 : a->order > b->order;
}

// --- Angles

typedef struct Unit { // cosine and sine
    YkGraphValue re, im;
} Unit;

static Unit unit_product(YkGraph *graph, Unit a, Unit b)
{
    return (Unit){yk_graph_subtract(graph, yk_graph_multiply(graph, a.re, b.re), yk_graph_multiply(graph, a.im, b.im)),
                  yk_graph_add(graph, yk_graph_multiply(graph, a.im, b.re), yk_graph_multiply(graph, a.re, b.im))};
}

// Returns e^(i factor angle); small factors by products.
static Unit unit_of_angle(YkGraph *graph, int32_t symbol, int32_t factor)
{
    enum { FACTOR_MAX = 3 };
    YkGraphValue angle = yk_graph_symbol(graph, symbol);
    int32_t times = factor < 0 ? -factor : factor;
    if (times > FACTOR_MAX) {
        angle = yk_graph_multiply(graph, yk_graph_number(graph, times), angle);
        times = 1;
    }
    Unit once = {yk_graph_function(graph, YK_OP_COS, angle), yk_graph_function(graph, YK_OP_SIN, angle)};
    Unit unit = once;
    for (int32_t k = 1; k < times; k++) unit = unit_product(graph, unit, once);
    if (factor < 0) unit.im = yk_graph_negate(unit.im);
    return unit;
}

static Unit unit_of(YkGraph *graph, uint32_t phase)
{
    uint32_t count;
    Unit unit = {yk_graph_number(graph, 1), yk_graph_number(graph, 0)};
    yk_powers_of(&graph->ring->phases, phase, &count);
    for (uint32_t k = 0; k < count; k++) {
        YkPower power = yk_powers_of(&graph->ring->phases, phase, &count)[k]; // squaring may enter new ones
        unit = unit_product(graph, unit, unit_of_angle(graph, power.symbol, power.exponent));
    }
    return unit;
}

// --- Products

static YkGraphValue power_of(YkGraph *graph, YkGraphValue base, int32_t exponent)
{
    YkGraphValue power = yk_graph_number(graph, 1);
    for (uint32_t rest = (uint32_t)exponent; rest > 0; rest /= 2) {
        if (rest & 1) power = yk_graph_multiply(graph, power, base);
        if (rest > 1) base = yk_graph_multiply(graph, base, base);
    }
    return power;
}

static YkGraphValue monomial_of(YkGraph *graph, uint32_t monomial)
{
    uint32_t count;
    YkGraphValue above = yk_graph_number(graph, 1), below = above;
    yk_powers_of(&graph->ring->monomials, monomial, &count);
    for (uint32_t k = 0; k < count; k++) {
        YkPower power = yk_powers_of(&graph->ring->monomials, monomial, &count)[k];
        YkGraphValue base = yk_graph_symbol(graph, power.symbol);
        YkGraphValue *side = power.exponent > 0 ? &above : &below;
        *side = yk_graph_multiply(graph, *side,
                                  power_of(graph, base, power.exponent < 0 ? -power.exponent : power.exponent));
    }
    return yk_graph_divide(graph, above, below);
}

// --- Terms

// Returns whether a phase is the one of a negative pair that is skipped: the one with a positive first factor is kept.
static bool is_second_half(const YkRing *ring, uint32_t phase)
{
    uint32_t count;
    const YkPower *powers = yk_powers_of(&ring->phases, phase, &count);
    return count > 0 && powers[0].exponent < 0;
}

static bool make_piece(YkRing *ring, const YkRingTerm *term, int64_t denominator, Piece *piece)
{
    unsigned unit = yk_key_unit(term->key);
    double number = (double)term->number / (double)denominator;
    *piece = (Piece){.phase = yk_key_phase(term->key), .is_sine = unit & YK_UNIT_I};
    if (unit & YK_UNIT_SQRT2) number *= sqrt(2);
    if (unit & YK_UNIT_SQRT3) number *= sqrt(3);
    if (piece->phase != 0) number *= 2;
    piece->number = piece->is_sine ? -number : number; // i n e^(i phi) and its conjugate: - 2 n sin phi
    return yk_ring_split_constants(ring, yk_key_monomial(term->key), &piece->constant, &piece->rest);
}

static size_t make_pieces(YkRing *ring, const YkPoisson *a, Piece *pieces)
{
    size_t count = 0;
    for (size_t i = 0; i < a->count; i++) {
        if (is_second_half(ring, yk_key_phase(a->terms[i].key))) continue;
        if (!make_piece(ring, &a->terms[i], a->denominator, &pieces[count])) return 0;
        pieces[count].order = i;
        count++;
    }
    qsort(pieces, count, sizeof *pieces, by_rest);
    return count;
}

// Returns the sum of the constants of one sine or cosine.
static YkGraphValue lump_of(YkGraph *graph, const Piece *pieces, size_t count)
{
    YkGraphValue sum = yk_graph_number(graph, 0);
    for (size_t i = 0; i < count; i++) {
        YkGraphValue product = monomial_of(graph, pieces[i].constant);
        product = yk_graph_multiply(graph, yk_graph_number(graph, pieces[i].number), product);
        sum = yk_graph_add(graph, sum, product);
    }
    return sum;
}

static YkGraphValue group_of(YkGraph *graph, const Piece *pieces, size_t count)
{
    YkGraphValue sum = yk_graph_number(graph, 0);
    for (size_t start = 0, end; start < count; start = end) {
        for (end = start;
             end < count && pieces[end].phase == pieces[start].phase && pieces[end].is_sine == pieces[start].is_sine;)
            end++;
        Unit unit = unit_of(graph, pieces[start].phase);
        YkGraphValue atom = pieces[start].is_sine ? unit.im : unit.re;
        sum = yk_graph_add(graph, sum, yk_graph_multiply(graph, lump_of(graph, pieces + start, end - start), atom));
    }
    return yk_graph_multiply(graph, sum, monomial_of(graph, pieces[0].rest));
}

YkGraphValue yk_graph_of(YkGraph *graph, const YkPoisson *a)
{
    if (!a || !yk_ring_is_real(graph->ring, a)) {
        if (a) yk_ring_fail(graph->ring, YK_RING_NOT_REAL);
        return YK_GRAPH_NONE;
    }
    Piece *pieces = calloc(a->count + 1, sizeof *pieces);
    size_t count = pieces ? make_pieces(graph->ring, a, pieces) : 0;
    if (!pieces || (count == 0 && a->count > 0)) graph->failed = true;
    YkGraphValue sum = yk_graph_number(graph, 0);
    for (size_t start = 0, end; start < count; start = end) {
        for (end = start; end < count && pieces[end].rest == pieces[start].rest;) end++;
        sum = yk_graph_add(graph, sum, group_of(graph, pieces + start, end - start));
    }
    free(pieces);
    return graph->failed ? YK_GRAPH_NONE : sum;
}
