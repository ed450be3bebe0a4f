// Finds the rows of J, and the blocks in which its unknown columns are solved.
#include "derive/blocks.h"
#include <string.h>
#include "derive/relations.h"
#include "num/components.h"
#include "num/matching.h"

// Finds the coordinates on the branches from a joint's two bodies to where they part, and the joint's own distance,
// ascending.
static size_t coordinates_of(const YkDerivation *d, const YkDeriveLoop *loop, int32_t *found)
{
    size_t count = 0;
    const YkJoint *j = &d->model->joints[loop->joint];
    for (int side = 0; side < 2; side++)
        for (int32_t b = j->body[side]; b != loop->axes; b = d->bodies[b].parent) {
            int32_t by = d->bodies[b].joint;
            if (d->joint_angle[by] != YK_NONE) found[count++] = d->joint_angle[by];
            if (d->joint_distance[by] != YK_NONE) found[count++] = d->joint_distance[by];
        }
    if (d->joint_distance[loop->joint] != YK_NONE) found[count++] = d->joint_distance[loop->joint];
    for (size_t i = 1; i < count; i++)
        for (size_t k = i; k > 0 && found[k - 1] > found[k]; k--) {
            int32_t held = found[k];
            found[k] = found[k - 1], found[k - 1] = held;
        }
    return count;
}

// Keeps the coordinates that a complex sum depends on.
static size_t keep_mentioned(const YkDerivation *d, const YkPoisson *a, const int32_t *all, size_t count, int32_t *kept)
{
    size_t n = 0;
    for (size_t k = 0; k < count; k++)
        if (yk_ring_mentions(d->ring, a, d->coordinates[all[k]].position)) kept[n++] = all[k];
    return n;
}

static bool add_row(YkDerivation *d, struct YkDeriveBlocks *blocks, YkDeriveRow row)
{
    if (!row.value) return false;
    if (yk_ring_is_zero(row.value)) return true; // 0 = 0: two parallel guides
    row.entries = YK_NEW(d->arena, const YkPoisson *, row.count + 1);
    if (!row.entries) return false;
    row.block = YK_NONE;
    for (size_t k = 0; k < row.count; k++) {
        row.entries[k] = yk_ring_partial(d->ring, row.value, d->coordinates[row.columns[k]].position);
        if (!row.entries[k]) return false;
    }
    blocks->rows[blocks->row_count++] = row;
    return true;
}

// The row of a gear depends on everything that has a derivative, functions of coordinates included.
static bool add_tie(YkDerivation *d, struct YkDeriveBlocks *blocks, int32_t tie)
{
    YkDeriveRow row = {.loop = YK_NONE, .tie = tie, .part = 3, .value = d->ties[tie].value};
    row.columns = YK_NEW(d->arena, int32_t, d->coordinate_count + 1);
    if (!row.columns) return false;
    if (!row.value) return yk_derivation_is_well(d); // it cannot be written: the section says so
    for (size_t k = 0; k < d->coordinate_count; k++) {
        const YkPoisson *slope = yk_ring_partial(d->ring, row.value, d->coordinates[k].position);
        if (!slope) return false;
        if (!yk_ring_is_zero(slope)) row.columns[row.count++] = (int32_t)k;
    }
    return add_row(d, blocks, row);
}

static bool make_rows(YkDerivation *d, struct YkDeriveBlocks *blocks, int32_t *found)
{
    const YkDeriveLoop *loops = yk_derive_loops(d);
    yk_derive_ties(d);
    blocks->rows = YK_NEW(d->arena, YkDeriveRow, 3 * d->loop_count + d->tie_count + 1);
    if (!loops || !blocks->rows) return false;
    for (size_t l = 0; l < d->loop_count; l++) {
        size_t all = coordinates_of(d, &loops[l], found);
        YkDeriveRow row = {.loop = (int32_t)l, .tie = YK_NONE, .columns = YK_NEW(d->arena, int32_t, all + 1)};
        if (!row.columns) return false;
        row.count = keep_mentioned(d, loops[l].sum, found, all, row.columns);
        row.value = yk_ring_real(d->ring, loops[l].sum);
        if (!add_row(d, blocks, row)) return false;
        row.part = 1, row.value = yk_ring_imaginary(d->ring, loops[l].sum);
        if (!add_row(d, blocks, row)) return false;
        if (!loops[l].angle) continue;
        row = (YkDeriveRow){.loop = (int32_t)l,
                            .tie = YK_NONE,
                            .part = 2,
                            .columns = YK_NEW(d->arena, int32_t, all + 1),
                            .value = loops[l].angle};
        if (!row.columns) return false;
        row.count = keep_mentioned(d, row.value, found, all, row.columns);
        if (!add_row(d, blocks, row)) return false;
    }
    for (size_t k = 0; k < d->tie_count; k++)
        if (!add_tie(d, blocks, (int32_t)k)) return false;
    return true;
}

// --- Blocks: rows are matched with unknown columns; a block is a strong component of their dependencies.

typedef struct Order {
    YkMatching matching;
    uint32_t *first;
    int32_t *targets, *component, *work;
    int32_t *node, *row; // row -> node among the matched, and back
    size_t nodes, components;
} Order;

static bool match_rows(YkDerivation *d, struct YkDeriveBlocks *blocks, Order *order, int32_t *unknowns)
{
    size_t entries = 0;
    for (size_t r = 0; r < blocks->row_count; r++) entries += blocks->rows[r].count;
    order->first = YK_NEW(d->arena, uint32_t, blocks->row_count + 2);
    order->targets = YK_NEW(d->arena, int32_t, entries + blocks->row_count + 1);
    order->component = YK_NEW(d->arena, int32_t, blocks->row_count + 1);
    order->node = YK_NEW(d->arena, int32_t, blocks->row_count + 1);
    order->row = YK_NEW(d->arena, int32_t, blocks->row_count + 1);
    order->work = YK_NEW(d->arena, int32_t, 5 * blocks->row_count + 1);
    if (yk_arena_failed(d->arena) ||
        !yk_matching_start(&order->matching, d->arena, d->coordinate_count, blocks->row_count, entries))
        return false;
    for (size_t r = 0; r < blocks->row_count; r++) {
        const YkDeriveRow *row = &blocks->rows[r];
        size_t count = 0;
        for (size_t k = 0; k < row->count; k++)
            if (!d->coordinates[row->columns[k]].is_input) unknowns[count++] = row->columns[k];
        bool matched = yk_matching_add(&order->matching, unknowns, count, true);
        order->node[r] = matched ? (int32_t)order->nodes : YK_NONE;
        if (matched) order->row[order->nodes++] = (int32_t)r;
    }
    return true;
}

// Keeps x and y of a loop together, so that a dyad is one block.
static int32_t sibling(const struct YkDeriveBlocks *blocks, size_t r)
{
    const YkDeriveRow *row = &blocks->rows[r];
    size_t other = row->part == 0 ? r + 1 : r - 1;
    if (row->part >= 2 || other >= blocks->row_count) return YK_NONE;
    const YkDeriveRow *beside = &blocks->rows[other];
    return beside->loop == row->loop && beside->part == 1 - row->part ? (int32_t)other : YK_NONE;
}

static void find_components(const YkDerivation *d, const struct YkDeriveBlocks *blocks, Order *order)
{
    uint32_t count = 0;
    for (size_t v = 0; v < order->nodes; v++) {
        size_t r = (size_t)order->row[v];
        const YkDeriveRow *row = &blocks->rows[r];
        order->first[v] = count;
        for (size_t k = 0; k < row->count; k++) {
            int32_t column = row->columns[k], other = order->matching.row_of[column];
            if (!d->coordinates[column].is_input && other >= 0) order->targets[count++] = order->node[other];
        }
        int32_t beside = sibling(blocks, r);
        if (beside != YK_NONE && order->node[beside] != YK_NONE) order->targets[count++] = order->node[beside];
    }
    order->first[order->nodes] = count;
    order->components = yk_components(order->nodes, order->first, order->targets, order->component, order->work);
}

// Collects the rows and columns of all blocks, block by block, each in order: counting sorts by component.
static bool gather_blocks(YkDerivation *d, struct YkDeriveBlocks *blocks, const Order *order)
{
    size_t *row_at = YK_NEW(d->arena, size_t, order->components + 1);
    size_t *column_at = YK_NEW(d->arena, size_t, order->components + 1);
    if (!row_at || !column_at) return false;
    for (size_t v = 0; v < order->nodes; v++) {
        row_at[order->component[v] + 1]++;
        blocks->rows[order->row[v]].block = order->component[v];
    }
    for (size_t k = 0; k < d->coordinate_count; k++) {
        int32_t row = d->coordinates[k].is_input ? -1 : order->matching.row_of[k];
        blocks->block_of[k] = row >= 0 ? blocks->rows[row].block : YK_NONE;
        if (blocks->block_of[k] != YK_NONE) column_at[blocks->block_of[k] + 1]++;
    }
    column_at[0] = blocks->column_count;
    for (size_t c = 0; c < order->components; c++) {
        blocks->blocks[c] = (YkDeriveBlock){row_at[c], row_at[c + 1], column_at[c], column_at[c + 1], NULL};
        row_at[c + 1] += row_at[c], column_at[c + 1] += column_at[c];
    }
    for (size_t v = 0; v < order->nodes; v++) blocks->row_order[row_at[order->component[v]]++] = (size_t)order->row[v];
    for (size_t k = 0; k < d->coordinate_count; k++)
        if (blocks->block_of[k] != YK_NONE) blocks->column_order[column_at[blocks->block_of[k]]++] = (int32_t)k;
    blocks->block_count = order->components;
    blocks->solved_row_count = order->nodes;
    for (size_t c = 0; c < order->components; c++) blocks->column_count += blocks->blocks[c].column_count;
    return true;
}

// Finds for each body the last block that its angle needs.
static bool find_last_blocks(YkDerivation *d, struct YkDeriveBlocks *blocks)
{
    size_t bodies = d->model->body_count;
    blocks->last_of = YK_NEW(d->arena, int32_t, bodies + 1);
    blocks->next_body = YK_NEW(d->arena, int32_t, bodies + 1);
    blocks->first_body = YK_NEW(d->arena, int32_t, blocks->block_count + 1);
    if (!blocks->last_of || !blocks->next_body || !blocks->first_body) return false;
    for (size_t k = 0; k < bodies; k++) {
        int32_t b = d->mech->tree_order[k], parent = d->bodies[b].parent;
        int32_t c = parent == YK_NONE ? YK_NONE : d->joint_angle[d->bodies[b].joint];
        int32_t before = parent == YK_NONE ? YK_NONE : blocks->last_of[parent];
        int32_t own = c == YK_NONE ? YK_NONE : blocks->block_of[c];
        blocks->last_of[b] = own > before ? own : before;
    }
    for (size_t k = 0; k < blocks->block_count; k++) blocks->first_body[k] = YK_NONE;
    for (size_t b = bodies; b-- > 0;) {
        if (blocks->last_of[b] == YK_NONE) continue;
        blocks->next_body[b] = blocks->first_body[blocks->last_of[b]];
        blocks->first_body[blocks->last_of[b]] = (int32_t)b;
    }
    return true;
}

static bool take_determinant(YkDerivation *d, struct YkDeriveBlocks *blocks, YkDeriveBlock *block)
{
    const YkPoisson *A[YK_CRAMER_MAX * YK_CRAMER_MAX];
    size_t n = block->row_count;
    if (n > YK_CRAMER_MAX || n != block->column_count) return true;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++)
            A[n * i + k] = yk_derive_entry(d, &blocks->rows[blocks->row_order[block->first_row + i]],
                                           blocks->column_order[block->first_column + k]);
    block->determinant = yk_derive_determinant(d->ring, A, n);
    return block->determinant != NULL;
}

static bool make_blocks(YkDerivation *d, struct YkDeriveBlocks *blocks)
{
    Order order = {0};
    int32_t *unknowns = YK_NEW(d->arena, int32_t, 2 * d->coordinate_count + 2);
    blocks->row_order = YK_NEW(d->arena, size_t, blocks->row_count + 1);
    blocks->column_order = YK_NEW(d->arena, int32_t, d->coordinate_count + 1);
    blocks->block_of = YK_NEW(d->arena, int32_t, d->coordinate_count + 1);
    blocks->blocks = YK_NEW(d->arena, YkDeriveBlock, blocks->row_count + 1);
    if (yk_arena_failed(d->arena) || !match_rows(d, blocks, &order, unknowns)) return false;
    // Given coordinates come first; those that no loop determines go with them.
    for (size_t k = 0; k < d->coordinate_count; k++)
        if (d->coordinates[k].is_input || order.matching.row_of[k] < 0)
            blocks->column_order[blocks->column_count++] = (int32_t)k;
    blocks->input_count = blocks->column_count;
    find_components(d, blocks, &order);
    if (!gather_blocks(d, blocks, &order) || !find_last_blocks(d, blocks)) return false;
    size_t last = blocks->solved_row_count;
    for (size_t r = 0; r < blocks->row_count; r++)
        if (blocks->rows[r].block == YK_NONE) blocks->row_order[last++] = r;
    for (size_t k = 0; k < blocks->block_count; k++)
        if (!take_determinant(d, blocks, &blocks->blocks[k])) return false;
    return true;
}

const YkDeriveBlocks *yk_derive_blocks(YkDerivation *d)
{
    if (d->blocks) return d->blocks;
    struct YkDeriveBlocks *blocks = YK_NEW(d->arena, struct YkDeriveBlocks, 1);
    int32_t *found = YK_NEW(d->arena, int32_t, 2 * d->coordinate_count + 2);
    if (!blocks || !found || !make_rows(d, blocks, found) || !make_blocks(d, blocks)) return NULL;
    d->blocks = blocks;
    return blocks;
}

const YkPoisson *yk_derive_entry(YkDerivation *d, const YkDeriveRow *row, int32_t coordinate)
{
    for (size_t k = 0; k < row->count; k++)
        if (row->columns[k] == coordinate) return row->entries[k];
    return yk_ring_rational(d->ring, 0, 1);
}

const YkPoisson *yk_derive_determinant(YkRing *ring, const YkPoisson *const *A, size_t n)
{
    if (n == 0) return yk_ring_rational(ring, 1, 1);
    if (n == 1) return A[0];
    const YkPoisson *sum = yk_ring_rational(ring, 0, 1);
    for (size_t skip = 0; skip < n; skip++) { // along the first column
        const YkPoisson *minor[YK_CRAMER_MAX * YK_CRAMER_MAX];
        size_t at = 0;
        for (size_t i = 0; i < n; i++)
            for (size_t k = 1; k < n && i != skip; k++) minor[at++] = A[n * i + k];
        const YkPoisson *term = yk_ring_multiply(ring, A[n * skip], yk_derive_determinant(ring, minor, n - 1));
        sum = skip % 2 == 0 ? yk_ring_add(ring, sum, term) : yk_ring_subtract(ring, sum, term);
    }
    return sum;
}

const YkPoisson *yk_derive_cramer(YkDerivation *d, const YkDeriveBlock *block, size_t unknown,
                                  const YkPoisson *const *right)
{
    const YkPoisson *A[YK_CRAMER_MAX * YK_CRAMER_MAX];
    const YkDeriveBlocks *blocks = d->blocks;
    size_t n = block->row_count;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++)
            A[n * i + k] = k == unknown ? right[i]
                                        : yk_derive_entry(d, &blocks->rows[blocks->row_order[block->first_row + i]],
                                                          blocks->column_order[block->first_column + k]);
    return yk_derive_determinant(d->ring, A, n);
}

const char *yk_derive_block_name(YkDerivation *d, const YkDeriveBlock *block)
{
    YkText text = {0};
    for (size_t k = 0; k < block->column_count; k++)
        yk_text_format(&text, "%s%s", k ? ", " : "",
                       d->coordinates[d->blocks->column_order[block->first_column + k]].name);
    const char *name = yk_arena_copy(d->arena, yk_text_get(&text), text.length);
    yk_text_free(&text);
    return name ? name : "";
}
