#include "ring/field.h"

uint64_t yk_field_power(uint64_t base, uint64_t exponent)
{
    uint64_t power = 1;
    for (; exponent > 0; exponent /= 2) {
        if (exponent & 1) power = yk_field_multiply(power, base);
        base = yk_field_multiply(base, base);
    }
    return power;
}

uint64_t yk_field_invert(uint64_t a)
{
    return yk_field_power(a, YK_PRIME - 2); // Fermat
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

static void swap_rows(uint64_t *A, uint64_t *b, size_t columns, size_t i, size_t k)
{
    uint64_t held = b[i];
    b[i] = b[k];
    b[k] = held;
    for (size_t j = 0; j < columns; j++) {
        held = A[i * columns + j];
        A[i * columns + j] = A[k * columns + j];
        A[k * columns + j] = held;
    }
}

// Takes multiples of the pivot row, whose pivot is 1, from all other rows.
static void clear_column(uint64_t *A, uint64_t *b, size_t rows, size_t columns, size_t pivot, size_t column)
{
    for (size_t i = 0; i < rows; i++) {
        uint64_t factor = A[i * columns + column];
        if (i == pivot || factor == 0) continue;
        for (size_t j = 0; j < columns; j++)
            A[i * columns + j] =
                yk_field_subtract(A[i * columns + j], yk_field_multiply(factor, A[pivot * columns + j]));
        b[i] = yk_field_subtract(b[i], yk_field_multiply(factor, b[pivot]));
    }
}

int yk_field_solve(uint64_t *A, uint64_t *b, size_t rows, size_t columns, uint64_t *x)
{
    size_t rank = 0;
    for (size_t column = 0; column < columns && rank < rows; column++) {
        size_t pivot = rank;
        while (pivot < rows && A[pivot * columns + column] == 0) pivot++;
        if (pivot == rows) continue;
        swap_rows(A, b, columns, rank, pivot);
        uint64_t inverse = yk_field_invert(A[rank * columns + column]);
        for (size_t j = 0; j < columns; j++) A[rank * columns + j] = yk_field_multiply(A[rank * columns + j], inverse);
        b[rank] = yk_field_multiply(b[rank], inverse);
        clear_column(A, b, rows, columns, rank++, column);
    }
    for (size_t i = rank; i < rows; i++)
        if (b[i] != 0) return -1;
    for (size_t i = 0; i < rank; i++) { // each row: its pivot, and free unknowns behind it
        size_t lead = 0;
        while (A[i * columns + lead] == 0) lead++;
        uint64_t value = b[i];
        for (size_t j = lead + 1; j < columns; j++)
            value = yk_field_subtract(value, yk_field_multiply(A[i * columns + j], x[j]));
        x[lead] = value;
    }
    return (int)rank;
}
