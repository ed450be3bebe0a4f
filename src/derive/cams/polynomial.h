// The derivation of a polynomial segment inside.
#ifndef DERIVE_CAMS_POLYNOMIAL_H
#define DERIVE_CAMS_POLYNOMIAL_H
#include "derive/cams/cams.h"
#include "num/exact_system.h"

enum { YK_POLYNOMIAL_CONDITIONS_MAX = 25 };

typedef struct YkPolynomialCondition {
    const YkPoisson *at, *value; // as the file writes them; NULL: not exact
    double place;
    int order;
    YkFraction u; // where it lies in the segment, 0 to 1
} YkPolynomialCondition;

typedef struct YkDerivePolynomial {
    YkDeriveLaw *law;
    const YkLawPart *part;
    YkLawSegment segment;
    YkPolynomialCondition conditions[YK_POLYNOMIAL_CONDITIONS_MAX];
    size_t count;
    YkDeriveSpan span;
    const YkPoisson *h;                                    // the factor before the bracket
    const YkPoisson *shares[YK_POLYNOMIAL_CONDITIONS_MAX]; // of each condition: value * beta^order
    const YkPoisson *by_u[YK_POLYNOMIAL_CONDITIONS_MAX]; // coefficients of powers of u; NULL: beyond the ring's numbers
    const YkPoisson *coefficients[YK_POLYNOMIAL_CONDITIONS_MAX]; // of powers of the argument
    const YkPoisson *symbols[YK_POLYNOMIAL_CONDITIONS_MAX];      // C0, C1, ...
    bool is_new;                                                 // the first page of this derivation
    bool is_solved, is_rational;                                 // by_u are known, and rational multiples of h
} YkDerivePolynomial;

// Writes the linear system in powers of the argument, one row per condition, and its condition number.
void yk_polynomial_put_system(const YkDerivePolynomial *p);
void yk_polynomial_put_condition_number(const YkDerivePolynomial *p);
// Returns the k-th coefficient, C0, C1, ..., as a symbol.
const YkPoisson *yk_polynomial_name_coefficient(YkDerivePolynomial *p, size_t k);
// Returns k (k - 1) ... (k - order + 1), the factor of the order-th derivative of u^k.
int64_t yk_polynomial_falling(size_t k, int order);
// Finds where the conditions lie in the segment, as fractions. Returns false if a place is not a rational number.
bool yk_polynomial_find_places(YkDerivePolynomial *p);
// Finds what each condition contributes: its value times beta^order.
void yk_polynomial_find_shares(YkDerivePolynomial *p);
// Solves for by_u and coefficients, in exact fractions.
void yk_polynomial_solve(YkDerivePolynomial *p);

#endif
