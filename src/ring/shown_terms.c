// From terms with e^(i phi) to terms with cos and sin: c e^(i phi) and its conjugate are 2 Re(c) cos phi - 2 Im(c) sin
// phi.
#include <stdlib.h>
#include <string.h>
#include "ring/shown.h"

// All terms of one phase and monomial: their numbers by unit.
typedef struct Cluster {
    uint32_t phase, monomial;
    int64_t number[YK_UNITS];
    unsigned units; // which numbers are not 0: a mask of 1 << unit
} Cluster;

// 4 e^(i k 15 deg) by units 1, i, sqrt 2, i sqrt 2, sqrt 3, i sqrt 3, sqrt 6, i sqrt 6.
static const int8_t twelfths[12][YK_UNITS] = {
    {4, 0, 0, 0, 0, 0, 0, 0},  {0, 0, 1, -1, 0, 0, 1, 1}, {0, 2, 0, 0, 2, 0, 0, 0},  {0, 0, 2, 2, 0, 0, 0, 0},
    {2, 0, 0, 0, 0, 2, 0, 0},  {0, 0, -1, 1, 0, 0, 1, 1}, {0, 4, 0, 0, 0, 0, 0, 0},  {0, 0, 1, 1, 0, 0, -1, 1},
    {-2, 0, 0, 0, 0, 2, 0, 0}, {0, 0, -2, 2, 0, 0, 0, 0}, {0, 2, 0, 0, -2, 0, 0, 0}, {0, 0, -1, -1, 0, 0, -1, 1}};

// Is the cluster's coefficient a rational multiple of e^(i k 15 deg)? The multiple is over 4 of the denominator: *four.
static bool is_turned(const Cluster *cluster, int k, int64_t *number, int64_t *divisor)
{
    unsigned lead = 0, units = 0;
    for (unsigned unit = 0; unit < YK_UNITS; unit++) units |= (unsigned)(twelfths[k][unit] != 0) << unit;
    if (cluster->units != units) return false;
    while (twelfths[k][lead] == 0) lead++;
    for (unsigned unit = 0; unit < YK_UNITS; unit++) {
        int64_t left, right;
        if (!yk_exact_multiply(cluster->number[unit], twelfths[k][lead], &left) ||
            !yk_exact_multiply(cluster->number[lead], twelfths[k][unit], &right) || left != right)
            return false;
    }
    *divisor = twelfths[k][lead];
    return yk_exact_multiply(cluster->number[lead], 4, number);
}

// The order of the first angle of a phase decides which of phase and -phase is shown.
static bool is_first_positive(const YkRing *ring, uint32_t phase)
{
    uint32_t count;
    const YkPower *powers = yk_powers_of(&ring->phases, phase, &count);
    return count == 0 || powers[0].exponent > 0;
}

typedef struct Writer {
    YkSheet *sheet;
    YkShownTerm *terms;
    size_t count;
    int64_t denominator;
    bool is_real;
} Writer;

static void put(Writer *writer, uint32_t monomial, int64_t number, int64_t divisor, YkAtom atom)
{
    YkRatio ratio, factor = {writer->is_real && atom.phase != 0 ? 2 : 1, 1};
    if (!yk_ratio_divide(factor, (YkRatio){divisor, 1}, &factor) ||
        !yk_ratio_make(number, writer->denominator, &ratio) ||
        (!yk_ratio_is(factor, 1) && !yk_ratio_multiply(ratio, factor, &ratio))) {
        yk_ring_fail(writer->sheet->ring, YK_RING_OVERFLOW);
        writer->sheet->failed = true;
        return;
    }
    writer->terms[writer->count++] = (YkShownTerm){monomial, ratio, atom};
}

// One term cos(phi + shift) where the coefficient is a number times e^(i shift), other than 1 and i.
static bool put_turned(Writer *writer, const Cluster *cluster)
{
    if (writer->sheet->format == YK_RING_C || cluster->phase == 0) return false;
    if ((cluster->units & (cluster->units - 1)) == 0) return false; // a single unit: 1 or i times a number or root
    if (yk_constant_angles(writer->sheet->ring, cluster->phase) > 0)
        return false; // pi/7 + pi/12 would read as one angle
    for (int k = 1; k < 12; k++) {
        int64_t number, divisor;
        if (k == 6 || !is_turned(cluster, k, &number, &divisor)) continue;
        YkAtom atom = {writer->is_real ? YK_SHOWN_COS : YK_SHOWN_EXP, .phase = cluster->phase,
                       .shift = k > 6 ? k - 12 : k};
        put(writer, cluster->monomial, k > 6 ? -number : number, divisor, atom);
        return true;
    }
    return false;
}

static void put_units(Writer *writer, const Cluster *cluster)
{
    for (unsigned unit = 0; unit < YK_UNITS; unit++) {
        int64_t number = cluster->number[unit];
        bool has_i = unit & YK_UNIT_I;
        if (number == 0) continue;
        YkAtom atom = {.surd = unit & YK_UNIT_SURD, .phase = cluster->phase};
        if (cluster->phase != 0) atom.function = !writer->is_real ? YK_SHOWN_EXP : has_i ? YK_SHOWN_SIN : YK_SHOWN_COS;
        atom.is_imaginary = has_i && !(writer->is_real && cluster->phase != 0);
        put(writer, cluster->monomial, atom.function == YK_SHOWN_SIN ? -number : number, 1, atom);
    }
}

static size_t read_cluster(const YkPoisson *a, size_t start, Cluster *cluster)
{
    size_t end = start;
    uint64_t head = a->terms[start].key >> YK_UNIT_BITS;
    *cluster = (Cluster){.phase = yk_key_phase(a->terms[start].key), .monomial = yk_key_monomial(a->terms[start].key)};
    for (; end < a->count && a->terms[end].key >> YK_UNIT_BITS == head; end++)
        cluster->number[yk_key_unit(a->terms[end].key)] = a->terms[end].number,
        cluster->units |= 1u << yk_key_unit(a->terms[end].key);
    return end;
}

YkShownTerm *yk_shown_terms(YkSheet *sheet, const YkPoisson *a, size_t *count)
{
    YkRing *ring = sheet->ring;
    Writer writer = {.sheet = sheet, .denominator = a->denominator, .is_real = yk_ring_is_real(ring, a)};
    if (!writer.is_real && sheet->format == YK_RING_C) yk_ring_fail(ring, YK_RING_NOT_REAL);
    writer.terms = YK_NEW(sheet->arena, YkShownTerm, a->count + 1);
    if (!writer.terms) yk_ring_fail(ring, YK_RING_MEMORY);
    if (!writer.terms || (!writer.is_real && sheet->format == YK_RING_C)) return NULL;
    for (size_t i = 0; i < a->count;) {
        Cluster cluster;
        i = read_cluster(a, i, &cluster);
        if (writer.is_real && !is_first_positive(ring, cluster.phase)) continue; // its conjugate carries it
        if (!put_turned(&writer, &cluster)) put_units(&writer, &cluster);
    }
    *count = writer.count;
    return sheet->failed ? NULL : writer.terms;
}
