// Solves linear equations in exact fractions, with several right-hand sides.
#ifndef NUM_EXACT_SYSTEM_H
#define NUM_EXACT_SYSTEM_H
#include "num/whole.h"

// cell[rows][columns + rights]. After reduction each pivot column has a 1 in its pivot row and 0 elsewhere.
typedef struct YkExactSystem {
    int32_t rows, columns, rights;
    YkFraction *cell;
    int32_t *pivot_row;    // per column: the row that solves it, or -1
    int32_t *pivot_column; // per row: the column it solves, or -1
    int32_t rank;
    YkOverflow overflow;
} YkExactSystem;

bool yk_exact_new(YkExactSystem *system, int32_t rows, int32_t columns, int32_t rights); // false when out of memory
void yk_exact_free(YkExactSystem *system);
YkFraction *yk_exact_cell(const YkExactSystem *system, int32_t row, int32_t column);
// Reduces by Gauss and Jordan. The next pivot is in the row, then the column, with the fewest entries (Markowitz 1957),
// which keeps the equations of a gear train sparse.
void yk_exact_reduce(YkExactSystem *system);
// Returns whether the unknown is the same in all solutions. Its values are then the right-hand entries of its pivot
// row.
bool yk_exact_is_determined(const YkExactSystem *system, int32_t column);
// Returns a row that says 0 = something, a contradiction; -1 if there is none.
int32_t yk_exact_contradiction(const YkExactSystem *system, int32_t rights);

#endif
