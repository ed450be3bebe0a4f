// The order in which the loops' equations are solved for the unknown rates: blocks along the diagonal of J.
#ifndef DERIVE_BLOCKS_H
#define DERIVE_BLOCKS_H
#include "derive/derive.h"

// A scalar equation: a row of J.
typedef struct YkDeriveRow {
    int32_t loop;           // or YK_NONE: a relation
    int32_t tie;            // the relation, or YK_NONE
    int part;               // 0 x, 1 y, 2 angle, 3 relation
    const YkPoisson *value; // joint form, 0 on the machine
    int32_t *columns;       // coordinates that it may contain, ascending
    size_t count;
    const YkPoisson **entries; // partial derivatives by them
    int32_t block;             // YK_NONE: repeats other rows
    const YkPoisson *gamma;    // memo: yk_derive_gamma
} YkDeriveRow;

typedef struct YkDeriveBlock {
    size_t first_row, row_count;       // in row_order
    size_t first_column, column_count; // in column_order
    const YkPoisson *determinant;      // NULL if the block has more than 3 unknowns or is not square
} YkDeriveBlock;

struct YkDeriveBlocks {
    YkDeriveRow *rows;
    size_t row_count, solved_row_count; // rows that repeat others come last in row_order
    size_t *row_order;
    int32_t *column_order; // coordinates: inputs first, then block by block
    size_t column_count, input_count;
    int32_t *block_of;               // per coordinate; YK_NONE: given
    int32_t *last_of;                // per body: the last block that its angle needs; YK_NONE: none
    int32_t *first_body, *next_body; // the bodies whose last block this is, ascending
    YkDeriveBlock *blocks;
    size_t block_count;
};

enum { YK_CRAMER_MAX = 3 };

// The blocks, made at first use; NULL on failure.
const YkDeriveBlocks *yk_derive_blocks(YkDerivation *d);
// Returns row r's derivative by a coordinate; zero if the row does not contain it. NULL only on failure.
const YkPoisson *yk_derive_entry(YkDerivation *d, const YkDeriveRow *row, int32_t coordinate);
// Returns the determinant of an n x n matrix, n <= YK_CRAMER_MAX, expanded row by row.
const YkPoisson *yk_derive_determinant(YkRing *ring, const YkPoisson *const *A, size_t n);
// Applies Cramer's rule to a block: determinant * unknown = over, where J_block unknown = right (row_count elements).
const YkPoisson *yk_derive_cramer(YkDerivation *d, const YkDeriveBlock *block, size_t unknown,
                                  const YkPoisson *const *right);
// Returns whether the block is solved in print.
static inline bool yk_derive_is_solved(const YkDeriveBlock *block)
{
    return block->determinant != NULL && !yk_ring_is_zero(block->determinant);
}
// Returns "theta2, d3": the unknowns of a block.
const char *yk_derive_block_name(YkDerivation *d, const YkDeriveBlock *block);

#endif
