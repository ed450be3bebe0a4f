// Shared by the files of this room: a law is a row of pieces, each a polynomial plus waves in a variable u of its own.
#ifndef LAW_INSIDE_H
#define LAW_INSIDE_H
#include <stdint.h>
#include "law/build.h"

// Over [from, to): f = sum c_k T_k(u) + sum amplitude cos(frequency u + phase), with u = (x - middle) * scale and T_k
// the Chebyshev polynomials. Its numbers are contiguous: `terms` coefficients, then three for each wave.
typedef struct YkPiece {
    double from, to, middle, scale;
    size_t first;
    uint16_t terms, waves;
} YkPiece;

struct YkLaw {
    double from, to, period;
    double start, end; // values held outside the range if there is no period
    const YkPiece *pieces;
    size_t piece_count;
    const double *numbers;
    const YkLawSegment *segments;
    size_t segment_count;
};

struct YkLawBuilder {
    double from, at, value;
    YkPiece *pieces;
    size_t piece_count, piece_capacity;
    double *numbers;
    size_t number_count, number_capacity;
    YkLawSegment *segments;
    size_t segment_count, segment_capacity;
    YkLawCondition *conditions; // of all segments, contiguous; in the finished law the segments point to them
    size_t condition_count, condition_capacity;
    size_t culprit;
    double trouble;
};

// eval.c: computes the value and derivatives of one piece with respect to x, at any x.
void yk_piece_eval(const YkPiece *piece, const double *numbers, double x, double d[YK_LAW_ORDER + 1]);

// kernels_polynomial.c: computes the value and two derivatives of a polynomial, without waves, at n places.
void yk_law_polynomial(const double *c, size_t terms, double middle, double scale, const double *x, double *const *d,
                       size_t n);
// Returns whether n places are all in [from, to).
void yk_law_within(bool *within, const double *x, double from, double to, size_t n);
// build.c: adds a piece with its numbers (terms + 3 waves of them); frame gives the rest. Returns false when out of
// memory.
bool yk_law_add_piece(YkLawBuilder *builder, const YkPiece *frame, const double *numbers);
// Ends a segment that began with piece `first`: its end and the value there, its entry. The `conditions` conditions
// were appended to builder->conditions before. Removes the pieces again on a fault.
YkLawFault yk_law_end_segment(YkLawBuilder *builder, YkLawKind kind, size_t first, size_t conditions,
                              double condition_number);
// Removes the pieces from `first` on, and this many of the last conditions.
void yk_law_take_back(YkLawBuilder *builder, size_t first, size_t conditions);

// conditions.c
// Checks count and range of the conditions and appends them to the builder's in the order s, v, a, ...; *from and *to
// get their range. On a fault nothing is appended.
YkLawFault yk_law_take_conditions(YkLawBuilder *builder, const YkLawCondition *conditions, size_t count, double *from,
                                  double *to);
// Translates the culprit from its index in the sorted list (the builder's last `count`) to its index in the list that
// was given.
void yk_law_name_culprit(YkLawBuilder *builder, const YkLawCondition *given, size_t count);

// solve.c
// Solves A x = b for n conditions (rows of A[n][n], overwritten). *condition_number is that of A with its rows scaled.
// On YK_LAW_CONTRADICTION and YK_LAW_UNDETERMINED *culprit is a row that depends on the others.
YkLawFault yk_law_solve(size_t n, double *A, double *b, double *x, double *condition_number, size_t *culprit);

#endif
