// Section: the Jacobian J of the loop equations, its blocks and their determinants.
#include "derive/blocks.h"
#include "derive/relations.h"
#include "derive/sections.h"

enum { ROWS_SHOWN_MAX = 24 };

// "A x", "sun-planet": a row's name, in the page's arena or the machine's.
static const char *row_label(YkDerivation *d, YkPage *page, const YkDeriveRow *row)
{
    if (row->part == 3) return d->ties[row->tie].name;
    static const char *const parts[] = {"x", "y", "angle"};
    YkText text = {0};
    yk_text_format(&text, "%s %s", d->model->joints[d->loops[row->loop].joint].name, parts[row->part]);
    const char *copy = yk_arena_copy(page->arena, yk_text_get(&text), text.length);
    page->failed |= !copy;
    yk_text_free(&text);
    return copy;
}

static void fill_row(YkDerivation *d, YkPage *page, YkShownMatrix *matrix, size_t i, const YkDeriveRow *row)
{
    const YkDeriveBlocks *blocks = d->blocks;
    matrix->row_labels[i] = row_label(d, page, row);
    for (size_t k = 0; k < matrix->columns; k++) {
        matrix->entries[i * matrix->columns + k] = yk_derive_entry(d, row, blocks->column_order[k]);
        matrix->column_symbols[k] = d->coordinates[blocks->column_order[k]].position;
    }
}

static void cut(const YkDeriveBlocks *blocks, YkShownMatrix *matrix)
{
    if (blocks->input_count > 0) matrix->column_cut[blocks->input_count - 1] = true;
    for (size_t b = 0; b < blocks->block_count; b++) {
        const YkDeriveBlock *block = &blocks->blocks[b];
        if (block->first_row + block->row_count < matrix->rows)
            matrix->row_cut[block->first_row + block->row_count - 1] = true;
        if (block->first_column + block->column_count < matrix->columns)
            matrix->column_cut[block->first_column + block->column_count - 1] = true;
    }
}

static void put_matrix(YkDerivation *d, YkPage *page)
{
    const YkDeriveBlocks *blocks = d->blocks;
    YkLine *line = yk_page_formula(page, "J q' = 0");
    yk_line_vector(page, line, "J", NULL, NULL);
    yk_line_sign(page, line, "=");
    YkShownMatrix *matrix = yk_line_matrix(page, line, blocks->row_count, blocks->column_count);
    if (!matrix) return;
    for (size_t i = 0; i < blocks->row_count; i++) fill_row(d, page, matrix, i, &blocks->rows[blocks->row_order[i]]);
    cut(blocks, matrix);
    matrix->target = "J";
}

// Writes one row as an equation between rates, for machines whose J does not fit on a page.
static void put_row(YkDerivation *d, YkPage *page, const YkDeriveRow *row)
{
    const YkPoisson *sum = yk_ring_time_derivative(d->ring, row->value);
    yk_page_equation(page, row_label(d, page, row), sum, NULL, YK_RING_TEXTBOOK);
}

static void put_determinant(YkDerivation *d, YkPage *page, const YkDeriveBlock *block, size_t number)
{
    YkText text = {0};
    yk_text_format(&text, "%z", number);
    YkLine *line = yk_page_formula(page, yk_derive_block_name(d, block));
    yk_line_vector(page, line, "D", NULL, yk_text_get(&text));
    yk_text_free(&text);
    yk_line_sign(page, line, "=");
    if (block->determinant) {
        yk_line_element(page, line, block->determinant, YK_RING_TEXTBOOK);
        if (line) line->value = block->determinant;
    } else {
        yk_line_words(page, line, "a group of more than one dyad, solved as a whole");
    }
}

bool yk_derive_section_jacobian(YkDerivation *d, YkPage *page)
{
    const YkDeriveBlocks *blocks = yk_derive_blocks(d);
    if (!blocks) return false;
    if (blocks->row_count == 0) {
        yk_page_words(page, "The machine has no loop, so J has no rows.");
        return true;
    }
    if (blocks->row_count <= ROWS_SHOWN_MAX) {
        put_matrix(d, page);
    } else {
        for (size_t i = 0; i < blocks->row_count; i++) put_row(d, page, &blocks->rows[blocks->row_order[i]]);
    }
    yk_page_heading(page, 2, "Determinants of the blocks");
    for (size_t b = 0; b < blocks->block_count; b++) put_determinant(d, page, &blocks->blocks[b], b + 1);
    if (blocks->solved_row_count < blocks->row_count)
        yk_page_words(page, "%z of the %z rows repeat others: they hold by themselves for these dimensions.",
                      blocks->row_count - blocks->solved_row_count, blocks->row_count);
    return true;
}
