// Turns elements into values of a graph: sums of constants times sine or cosine, grouped by their common factor.
#include <math.h>
#include <stdlib.h>
#include "ring/graph/element.h"
#include "ring/inside.h"

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

// Returns (cos, sin) of an angle.
static YkRefVec unit_once(YkGraph *graph, YkRef angle)
{
    const YkValue *v = &graph->values[angle];
    bool is_negative = v->op == YK_VALUE_MINUS;
    if (is_negative) angle = v->a;
    YkRefVec unit = {.x = yk_graph_function(graph, YK_COS, angle, YK_NONE)};
    unit.y = yk_graph_function(graph, YK_SIN, angle, YK_NONE);
    return is_negative ? yk_graph_vec_conjugate(graph, unit) : unit;
}

// e^(i factor angle); small factors by products.
static YkRefVec unit_of_angle(YkRingGraph *values, int32_t symbol, int32_t factor)
{
    enum { FACTOR_MAX = 3 };
    YkGraph *graph = &values->graph;
    YkRef angle = yk_ring_graph_symbol(values, symbol);
    int32_t times = factor < 0 ? -factor : factor;
    if (times > FACTOR_MAX) {
        angle = yk_graph_multiply(graph, yk_graph_number(graph, times), angle);
        times = 1;
    }
    YkRefVec once = unit_once(graph, angle), unit = once;
    for (int32_t k = 1; k < times; k++) unit = yk_graph_vec_multiply(graph, once, unit);
    return factor < 0 ? yk_graph_vec_conjugate(graph, unit) : unit;
}

static YkRefVec unit_of(YkRingGraph *values, uint32_t phase)
{
    YkGraph *graph = &values->graph;
    uint32_t count;
    YkRefVec unit = yk_graph_vec_number(graph, 1, 0);
    yk_powers_of(&values->ring->phases, phase, &count);
    for (uint32_t k = 0; k < count; k++) {
        YkPower power = yk_powers_of(&values->ring->phases, phase, &count)[k]; // a square may enter new ones
        YkRefVec next = unit_of_angle(values, power.symbol, power.exponent);
        unit = yk_graph_vec_multiply(graph, next, unit);
    }
    return unit;
}

// --- Products

static YkRef power_of(YkGraph *graph, YkRef base, int32_t exponent)
{
    YkRef power = yk_graph_number(graph, 1);
    for (uint32_t rest = (uint32_t)exponent; rest > 0; rest /= 2) {
        if (rest & 1) power = yk_graph_multiply(graph, power, base);
        if (rest > 1) base = yk_graph_multiply(graph, base, base);
    }
    return power;
}

static YkRef monomial_of(YkRingGraph *values, uint32_t monomial)
{
    YkGraph *graph = &values->graph;
    uint32_t count;
    YkRef above = yk_graph_number(graph, 1), below = above;
    yk_powers_of(&values->ring->monomials, monomial, &count);
    for (uint32_t k = 0; k < count; k++) {
        YkPower power = yk_powers_of(&values->ring->monomials, monomial, &count)[k];
        YkRef base = yk_ring_graph_symbol(values, power.symbol);
        YkRef *side = power.exponent > 0 ? &above : &below;
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
static YkRef lump_of(YkRingGraph *values, const Piece *pieces, size_t count)
{
    YkGraph *graph = &values->graph;
    YkRef sum = yk_graph_number(graph, 0);
    for (size_t i = 0; i < count; i++) {
        YkRef product = monomial_of(values, pieces[i].constant);
        product = yk_graph_multiply(graph, yk_graph_number(graph, pieces[i].number), product);
        sum = yk_graph_add(graph, sum, product);
    }
    return sum;
}

static YkRef group_of(YkRingGraph *values, const Piece *pieces, size_t count)
{
    YkGraph *graph = &values->graph;
    YkRef sum = yk_graph_number(graph, 0);
    for (size_t start = 0, end; start < count; start = end) {
        for (end = start;
             end < count && pieces[end].phase == pieces[start].phase && pieces[end].is_sine == pieces[start].is_sine;)
            end++;
        YkRefVec unit = unit_of(values, pieces[start].phase);
        YkRef atom = pieces[start].is_sine ? unit.y : unit.x;
        sum = yk_graph_add(graph, sum, yk_graph_multiply(graph, lump_of(values, pieces + start, end - start), atom));
    }
    return yk_graph_multiply(graph, sum, monomial_of(values, pieces[0].rest));
}

YkRef yk_ring_graph_of(YkRingGraph *values, const YkPoisson *a)
{
    YkGraph *graph = &values->graph;
    bool is_real = a && yk_ring_is_real(values->ring, a);
    if (a && !is_real) yk_ring_fail(values->ring, YK_RING_NOT_REAL);
    Piece *pieces = is_real ? calloc(a->count + 1, sizeof *pieces) : NULL;
    size_t count = pieces ? make_pieces(values->ring, a, pieces) : 0;
    if (!pieces || (count == 0 && a->count > 0)) graph->failed = true;
    YkRef sum = yk_graph_number(graph, 0);
    for (size_t start = 0, end; start < count; start = end) {
        for (end = start; end < count && pieces[end].rest == pieces[start].rest;) end++;
        sum = yk_graph_add(graph, sum, group_of(values, pieces + start, end - start));
    }
    free(pieces);
    return sum;
}
