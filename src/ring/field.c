#include "ring/field.h"
#include <stdlib.h>

uint64_t yk_field_power(uint64_t base, uint64_t exponent)
{
    uint64_t power = 1;
    for (; exponent > 0; exponent /= 2) {
        if (exponent & 1) power = yk_field_multiply(power, base);
        base = yk_field_multiply(base, base);
    }
    return power;
}

// a^(2^times): squared so often.
static uint64_t squared(uint64_t a, int times)
{
    for (int k = 0; k < times; k++) a = yk_field_multiply(a, a);
    return a;
}

// Fermat: a^(p - 2), where p - 2 = 31 ones, a zero and 32 ones in binary; ones(2 n) = ones(n)^(2^n) * ones(n).
uint64_t yk_field_invert(uint64_t a)
{
    uint64_t ones2 = yk_field_multiply(squared(a, 1), a), ones3 = yk_field_multiply(squared(ones2, 1), a),
             ones6 = yk_field_multiply(squared(ones3, 3), ones3), ones12 = yk_field_multiply(squared(ones6, 6), ones6),
             ones24 = yk_field_multiply(squared(ones12, 12), ones12),
             ones30 = yk_field_multiply(squared(ones24, 6), ones6), ones31 = yk_field_multiply(squared(ones30, 1), a),
             high = squared(ones31, 1);
    return yk_field_multiply(squared(high, 32), yk_field_multiply(high, a));
}

uint64_t yk_field_of(int64_t value)
{
    uint64_t size = value < 0 ? (uint64_t)0 - (uint64_t)value : (uint64_t)value;
    return value < 0 ? yk_field_negate(size) : size; // |value| <= 2^63 < p
}

// p - 1 = 2^32 * odd. 7 generates the field, so 7^odd has order 2^32 (Tonelli 1891, Shanks 1973).
bool yk_field_sqrt(uint64_t a, uint64_t *root)
{
    const uint64_t odd = 0xffffffffu;
    *root = 0;
    if (a == 0) return true;
    uint64_t x = yk_field_power(a, (odd + 1) / 2), t = yk_field_power(a, odd), c = yk_field_power(7, odd);
    unsigned order = 32;
    while (t != 1) {
        unsigned i = 0;
        for (uint64_t power = t; power != 1 && i < order; i++) power = yk_field_multiply(power, power);
        if (i >= order) return false;
        for (unsigned k = 0; k + i + 1 < order; k++) c = yk_field_multiply(c, c);
        x = yk_field_multiply(x, c);
        c = yk_field_multiply(c, c);
        t = yk_field_multiply(t, c);
        order = i;
    }
    *root = x;
    return true;
}

// --- Elimination. Which row becomes the pivot's changes no result - the reduced form of a matrix is one -, so the
// shortest is taken, and rows stay as sparse as they are.

typedef struct Elimination {
    uint64_t *A, *b;
    size_t rows, columns;
    size_t *row, *filled, *entry; // the order of rows; how many entries of each are not 0; columns of the pivot row's
} Elimination;

static uint64_t *row_at(const Elimination *e, size_t place)
{
    return e->A + e->row[place] * e->columns;
}

// The shortest row from `rank` on that has an entry there comes to this place; false where there is none.
static bool choose_pivot(Elimination *e, size_t rank, size_t column)
{
    size_t best = e->rows;
    for (size_t i = rank; i < e->rows; i++)
        if (row_at(e, i)[column] != 0 && (best == e->rows || e->filled[e->row[i]] < e->filled[e->row[best]])) best = i;
    if (best == e->rows) return false;
    size_t held = e->row[rank];
    e->row[rank] = e->row[best], e->row[best] = held;
    return true;
}

// Makes the pivot 1; returns how many entries stand behind it.
static size_t norm_pivot(Elimination *e, size_t rank, size_t column)
{
    uint64_t *pivot = row_at(e, rank), inverse = yk_field_invert(pivot[column]);
    size_t count = 0;
    for (size_t j = column; j < e->columns; j++) {
        if (pivot[j] == 0) continue;
        pivot[j] = yk_field_multiply(pivot[j], inverse);
        if (j > column) e->entry[count++] = j;
    }
    e->b[e->row[rank]] = yk_field_multiply(e->b[e->row[rank]], inverse);
    return count;
}

// Takes a multiple of the pivot row from the row at that place.
static void reduce(Elimination *e, size_t rank, size_t place, size_t column, size_t count)
{
    uint64_t *row = row_at(e, place), factor = row[column];
    const uint64_t *pivot = row_at(e, rank);
    size_t filled = e->filled[e->row[place]] - 1;
    row[column] = 0;
    for (size_t k = 0; k < count; k++) {
        size_t j = e->entry[k];
        filled -= row[j] != 0;
        row[j] = yk_field_subtract(row[j], yk_field_multiply(factor, pivot[j]));
        filled += row[j] != 0;
    }
    e->filled[e->row[place]] = filled;
    e->b[e->row[place]] = yk_field_subtract(e->b[e->row[place]], yk_field_multiply(factor, e->b[e->row[rank]]));
}

static size_t eliminate(Elimination *e)
{
    size_t rank = 0;
    for (size_t column = 0; column < e->columns && rank < e->rows; column++) {
        if (!choose_pivot(e, rank, column)) continue;
        size_t count = norm_pivot(e, rank, column);
        for (size_t i = rank + 1; i < e->rows; i++)
            if (row_at(e, i)[column] != 0) reduce(e, rank, i, column, count);
        rank++;
    }
    return rank;
}

// From the last pivot to the first: each row's, by what stands behind it.
static void substitute_back(const Elimination *e, size_t rank, uint64_t *x)
{
    for (size_t i = rank; i-- > 0;) {
        const uint64_t *row = row_at(e, i);
        size_t lead = 0;
        while (row[lead] == 0) lead++;
        uint64_t value = e->b[e->row[i]];
        for (size_t j = lead + 1; j < e->columns; j++)
            if (row[j] != 0) value = yk_field_subtract(value, yk_field_multiply(row[j], x[j]));
        x[lead] = value;
    }
}

int yk_field_solve(uint64_t *A, uint64_t *b, size_t rows, size_t columns, uint64_t *x)
{
    size_t *work = calloc(2 * rows + columns + 1, sizeof *work);
    if (!work) return -1;
    Elimination e = {A, b, rows, columns, work, work + rows, work + 2 * rows};
    for (size_t i = 0; i < rows; i++) {
        e.row[i] = i;
        for (size_t j = 0; j < columns; j++) e.filled[i] += A[i * columns + j] != 0;
    }
    size_t rank = eliminate(&e);
    bool has_solution = true;
    for (size_t i = rank; i < rows; i++) has_solution = has_solution && b[e.row[i]] == 0;
    if (has_solution) substitute_back(&e, rank, x);
    free(work);
    return has_solution ? (int)rank : -1;
}
