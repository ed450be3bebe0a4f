// A polynomial from conditions, and its coefficients in powers of x.
#include <stdlib.h>
#include <string.h>
#include "elementary/elementary.h"
#include "law/inside.h"

// Computes row[k] = the derivative of this order of the Chebyshev polynomial T_k at u, k < count, by the recurrence
// T_{k+1} = 2 u T_k - T_{k-1}, differentiated one order after the other.
static void chebyshev_row(double u, int order, size_t count, double *row)
{
    double below[YK_LAW_CONDITIONS_MAX]; // of the order below
    for (int m = 0; m <= order; m++) {
        if (m > 0) memcpy(below, row, count * sizeof *row);
        row[0] = m == 0;
        row[1] = m == 0 ? u : m == 1;
        for (size_t k = 2; k < count; k++) {
            row[k] = 2 * u * row[k - 1] - row[k - 2];
            if (m > 0) row[k] += 2 * m * below[k - 1];
        }
    }
}

// Solves the system in u; a condition's place is `at`, its list the builder's last `count`. Fault, coefficients and
// condition number are those of yk_law_solve.
static YkLawFault solve(YkLawBuilder *builder, const YkPiece *frame, size_t count, double *coefficients,
                        double *condition_number)
{
    const YkLawCondition *conditions = builder->conditions + (builder->condition_count - count);
    double *A = malloc((count + 1) * count * sizeof *A);
    if (!A) return YK_LAW_NO_MEMORY;
    double *b = A + count * count;
    for (size_t i = 0; i < count; i++) {
        double u = (conditions[i].at - frame->middle) * frame->scale;
        chebyshev_row(u, conditions[i].order, count, A + i * count);
        b[i] = conditions[i].value / yk_pow(frame->scale, conditions[i].order);
    }
    YkLawFault fault = yk_law_solve(count, A, b, coefficients, condition_number, &builder->culprit);
    free(A);
    return fault;
}

YkLawFault yk_law_add_polynomial(YkLawBuilder *builder, const YkLawCondition *conditions, size_t count)
{
    double from, to, coefficients[YK_LAW_CONDITIONS_MAX], condition_number = 0;
    YkLawFault fault = yk_law_take_conditions(builder, conditions, count, &from, &to);
    if (fault != YK_LAW_OK) return fault;
    YkPiece frame = {.from = builder->at,
                     .to = to,
                     .middle = from + (to - from) / 2,
                     .scale = 2 / (to - from),
                     .terms = (uint16_t)count};
    size_t first = builder->piece_count;
    fault = solve(builder, &frame, count, coefficients, &condition_number);
    if (fault == YK_LAW_OK && !yk_law_add_piece(builder, &frame, coefficients)) fault = YK_LAW_NO_MEMORY;
    if (fault == YK_LAW_OK) return yk_law_end_segment(builder, YK_LAW_POLYNOMIAL, first, count, condition_number);
    yk_law_name_culprit(builder, conditions, count);
    yk_law_take_back(builder, first, count);
    return fault;
}

void yk_law_power_row(const YkLawCondition *condition, size_t count, double *row)
{
    double power = 1; // at^(k - order)
    for (size_t k = 0; k < count; k++) {
        double factor = 1;
        row[k] = 0;
        if (k < (size_t)condition->order) continue;
        for (int m = 0; m < condition->order; m++) factor *= (double)(k - (size_t)m);
        row[k] = factor * power;
        power *= condition->at;
    }
}

// Computes p(x) <- (x - shift) * scale * p(x) in place: one more coefficient.
static void multiply(double *p, size_t count, double shift, double scale)
{
    p[count] = 0;
    for (size_t k = count + 1; k-- > 0;) p[k] = scale * ((k > 0 ? p[k - 1] : 0) - shift * p[k]);
}

// Runs Clenshaw's recurrence on polynomials in x, with u = (x - middle) * scale.
bool yk_law_power_coefficients(const YkLaw *law, size_t segment, double *coefficients)
{
    if (segment >= law->segment_count || law->segments[segment].kind != YK_LAW_POLYNOMIAL) return false;
    const YkPiece *piece = &law->pieces[law->segments[segment].first_piece];
    const double *c = law->numbers + piece->first;
    double b1[YK_LAW_CONDITIONS_MAX + 1] = {0}, b2[YK_LAW_CONDITIONS_MAX + 1] = {0}, next[YK_LAW_CONDITIONS_MAX + 1];
    size_t terms = piece->terms;
    for (size_t k = terms; k-- > 0;) {
        memcpy(next, b1, sizeof next);
        multiply(next, terms, piece->middle, (k > 0 ? 2 : 1) * piece->scale);
        for (size_t i = 0; i < terms; i++) next[i] -= b2[i];
        next[0] += c[k];
        memcpy(b2, b1, sizeof b2);
        memcpy(b1, next, sizeof b1);
    }
    memcpy(coefficients, b1, terms * sizeof *coefficients);
    return true;
}
