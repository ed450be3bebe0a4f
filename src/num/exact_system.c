// Gauss-Jordan elimination in exact fractions.
#include "num/exact_system.h"
#include <stdlib.h>

bool yk_exact_new(YkExactSystem *system, int32_t rows, int32_t columns, int32_t rights)
{
    size_t width = (size_t)(columns + rights);
    *system = (YkExactSystem){.rows = rows, .columns = columns, .rights = rights};
    system->cell = calloc((size_t)rows * width + 1, sizeof *system->cell);
    system->pivot_row = calloc((size_t)columns + 1, sizeof *system->pivot_row);
    system->pivot_column = calloc((size_t)rows + 1, sizeof *system->pivot_column);
    for (int32_t c = 0; system->pivot_row && c < columns; c++) system->pivot_row[c] = -1;
    for (int32_t r = 0; system->pivot_column && r < rows; r++) system->pivot_column[r] = -1;
    if (system->cell && system->pivot_row && system->pivot_column) return true;
    yk_exact_free(system);
    return false;
}

void yk_exact_free(YkExactSystem *system)
{
    free(system->cell);
    free(system->pivot_row);
    free(system->pivot_column);
    *system = (YkExactSystem){0};
}

YkFraction *yk_exact_cell(const YkExactSystem *system, int32_t row, int32_t column)
{
    return &system->cell[(size_t)row * (size_t)(system->columns + system->rights) + (size_t)column];
}

static bool is_there(const YkExactSystem *system, int32_t row, int32_t column)
{
    return yk_exact_cell(system, row, column)->over.count > 0;
}

static int32_t entries_of_row(const YkExactSystem *system, int32_t row)
{
    int32_t count = 0;
    for (int32_t c = 0; c < system->columns; c++) count += is_there(system, row, c);
    return count;
}

static int32_t entries_of_column(const YkExactSystem *system, int32_t column)
{
    int32_t count = 0;
    for (int32_t r = 0; r < system->rows; r++) count += system->pivot_column[r] < 0 && is_there(system, r, column);
    return count;
}

static int32_t shortest_row(const YkExactSystem *system)
{
    int32_t best = -1, least = INT32_MAX;
    for (int32_t r = 0; r < system->rows; r++) {
        int32_t count = system->pivot_column[r] < 0 ? entries_of_row(system, r) : 0;
        if (count == 0 || count >= least) continue;
        best = r;
        least = count;
    }
    return best;
}

static int32_t shortest_column(const YkExactSystem *system, int32_t row)
{
    int32_t best = -1, least = INT32_MAX;
    for (int32_t c = 0; c < system->columns; c++) {
        int32_t count = is_there(system, row, c) ? entries_of_column(system, c) : INT32_MAX;
        if (count >= least) continue;
        best = c;
        least = count;
    }
    return best;
}

static void scale_row(YkExactSystem *system, int32_t row, int32_t column)
{
    YkFraction by = yk_fraction_inverse(yk_exact_cell(system, row, column));
    if (yk_fraction_is_one(&by)) return;
    for (int32_t c = 0; c < system->columns + system->rights; c++) {
        YkFraction *cell = yk_exact_cell(system, row, c);
        if (cell->over.count > 0) *cell = yk_fraction_multiply(cell, &by, &system->overflow);
    }
}

static void subtract_row(YkExactSystem *system, int32_t row, int32_t pivot, int32_t column)
{
    YkFraction factor = yk_fraction_negative(yk_exact_cell(system, row, column));
    for (int32_t c = 0; c < system->columns + system->rights; c++) {
        const YkFraction *from = yk_exact_cell(system, pivot, c);
        if (from->over.count == 0) continue;
        YkFraction *cell = yk_exact_cell(system, row, c), part = yk_fraction_multiply(from, &factor, &system->overflow);
        *cell = yk_fraction_add(cell, &part, &system->overflow);
    }
}

void yk_exact_reduce(YkExactSystem *system)
{
    for (int32_t row = shortest_row(system); row >= 0 && !system->overflow; row = shortest_row(system)) {
        int32_t column = shortest_column(system, row);
        system->pivot_row[column] = row;
        system->pivot_column[row] = column;
        system->rank++;
        scale_row(system, row, column);
        for (int32_t r = 0; r < system->rows; r++)
            if (r != row && is_there(system, r, column)) subtract_row(system, r, row, column);
    }
}

bool yk_exact_is_determined(const YkExactSystem *system, int32_t column)
{
    int32_t row = system->pivot_row[column];
    return row >= 0 && entries_of_row(system, row) == 1;
}

int32_t yk_exact_contradiction(const YkExactSystem *system, int32_t rights)
{
    for (int32_t r = 0; r < system->rows; r++) {
        if (system->pivot_column[r] >= 0) continue;
        for (int32_t k = 0; k < rights; k++)
            if (is_there(system, r, system->columns + k)) return r;
    }
    return -1;
}
