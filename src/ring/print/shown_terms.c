// Turns terms with e^(i phi) into terms with cos and sin: c e^(i phi) and its conjugate are 2 Re(c) cos phi - 2 Im(c)
// sin phi.
#include "ring/print/shown.h"

// All terms of one phase and monomial: their numbers by unit.
typedef struct Cluster {
    uint32_t phase;
    int64_t number[YK_UNITS];
    unsigned units; // which numbers are not 0: a mask of 1 << unit
} Cluster;

// 4 e^(i k 15 deg) by units 1, i, sqrt 2, i sqrt 2, sqrt 3, i sqrt 3, sqrt 6, i sqrt 6.
static const int8_t twelfths[12][YK_UNITS] = {
    {4, 0, 0, 0, 0, 0, 0, 0},  {0, 0, 1, -1, 0, 0, 1, 1}, {0, 2, 0, 0, 2, 0, 0, 0},  {0, 0, 2, 2, 0, 0, 0, 0},
    {2, 0, 0, 0, 0, 2, 0, 0},  {0, 0, -1, 1, 0, 0, 1, 1}, {0, 4, 0, 0, 0, 0, 0, 0},  {0, 0, 1, 1, 0, 0, -1, 1},
    {-2, 0, 0, 0, 0, 2, 0, 0}, {0, 0, -2, 2, 0, 0, 0, 0}, {0, 2, 0, 0, -2, 0, 0, 0}, {0, 0, -1, -1, 0, 0, -1, 1}};

// Returns whether the cluster's coefficient is a rational multiple of e^(i k 15 deg): 4 *number / *divisor over the
// denominator.
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

// Returns whether the first angle of a phase has a positive factor, which decides whether phase or -phase is shown.
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
    bool is_real;
    YkRatio scale, paired; // factors of numbers: 1 over the denominator; twice that if two terms make a cosine or sine
} Writer;

// Adds a term of number / divisor.
static void put(Writer *writer, YkMonomial monomial, int64_t number, int64_t divisor, YkAtom atom)
{
    YkRatio ratio = {0, 1}, scale = writer->is_real && atom.phase != 0 ? writer->paired : writer->scale;
    bool is_whole = divisor == 1 && scale.under == 1; // for most terms
    if (is_whole ? !yk_exact_multiply(number, scale.over, &ratio.over)
                 : !yk_ratio_divide(scale, (YkRatio){divisor, 1}, &scale) ||
                       !yk_ratio_multiply((YkRatio){number, 1}, scale, &ratio)) {
        yk_ring_fail(writer->sheet->ring, YK_RING_OVERFLOW);
        writer->sheet->failed = true;
        return;
    }
    writer->terms[writer->count++] = (YkShownTerm){monomial, ratio, atom};
}

// Adds one term cos(phi + shift) if the coefficient is a number times e^(i shift), other than 1 and i.
static bool put_turned(Writer *writer, YkMonomial monomial, const Cluster *cluster)
{
    if (writer->sheet->format == YK_RING_C || cluster->phase == 0) return false;
    if ((cluster->units & (cluster->units - 1)) == 0) return false; // a single unit: 1 or i times a number or root
    if (yk_constant_angles(writer->sheet->ring, cluster->phase) > 0)
        return false; // pi/7 + pi/12 would read as one angle
    for (int k = 1; k < 12; k++) {
        int64_t number, divisor;
        if (k == 6 || !is_turned(cluster, k, &number, &divisor)) continue;
        YkAtom atom = {.phase = cluster->phase,
                       .shift = (int8_t)(k > 6 ? k - 12 : k),
                       .function = writer->is_real ? YK_SHOWN_COS : YK_SHOWN_EXP};
        put(writer, monomial, k > 6 ? -number : number, divisor, atom);
        return true;
    }
    return false;
}

static void put_unit(Writer *writer, YkMonomial monomial, uint32_t phase, unsigned unit, int64_t number)
{
    bool has_i = unit & YK_UNIT_I;
    YkAtom atom = {.surd = (uint8_t)(unit & YK_UNIT_SURD), .phase = phase};
    if (phase != 0) atom.function = !writer->is_real ? YK_SHOWN_EXP : has_i ? YK_SHOWN_SIN : YK_SHOWN_COS;
    atom.is_imaginary = has_i && !(writer->is_real && phase != 0);
    put(writer, monomial, atom.function == YK_SHOWN_SIN ? -number : number, 1, atom);
}

// Adds the terms a[start ... end), which all have one phase and monomial.
static void put_cluster(Writer *writer, const YkPoisson *a, size_t start, size_t end)
{
    uint64_t key = a->terms[start].key;
    YkMonomial monomial = yk_monomial(writer->sheet, yk_key_monomial(key));
    if (end - start > 1) {
        Cluster cluster = {.phase = yk_key_phase(key)};
        for (size_t i = start; i < end; i++) {
            unsigned unit = yk_key_unit(a->terms[i].key);
            cluster.number[unit] = a->terms[i].number;
            cluster.units |= 1u << unit;
        }
        if (put_turned(writer, monomial, &cluster)) return;
    }
    for (size_t i = start; i < end; i++)
        put_unit(writer, monomial, yk_key_phase(key), yk_key_unit(a->terms[i].key), a->terms[i].number);
}

YkShownTerm *yk_shown_terms(YkSheet *sheet, const YkPoisson *a, size_t *count)
{
    YkRing *ring = sheet->ring;
    Writer writer = {.sheet = sheet, .is_real = yk_ring_is_real(ring, a), .scale = {1, a->denominator}};
    if (!writer.is_real && sheet->format == YK_RING_C) {
        yk_ring_fail(ring, YK_RING_NOT_REAL);
        return NULL;
    }
    yk_ratio_make(2, a->denominator, &writer.paired);
    writer.terms = yk_arena_take(sheet->arena, (a->count + 1) * sizeof *writer.terms);
    if (!writer.terms) yk_ring_fail(ring, YK_RING_MEMORY);
    for (size_t start = 0, end; start < a->count && writer.terms; start = end) {
        uint64_t head = a->terms[start].key >> YK_UNIT_BITS;
        for (end = start + 1; end < a->count && a->terms[end].key >> YK_UNIT_BITS == head; end++) {}
        if (writer.is_real && !is_first_positive(ring, yk_key_phase(a->terms[start].key)))
            continue; // its conjugate carries it
        put_cluster(&writer, a, start, end);
    }
    *count = writer.count;
    return sheet->failed ? NULL : writer.terms;
}
