// Builds pages of mathematics.
#include "derive/page.h"
#include <assert.h>
#include <string.h>
#include "base/text.h"

enum { PIECE = 500 }; // work of one

static YkArena *memory_of(const YkPage *page)
{
    return page->passing ? page->passing : page->arena;
}

enum { PARTS_MAX = 4 };

const char *yk_page_join(YkArena *arena, const char *const parts[], size_t count)
{
    size_t lengths[PARTS_MAX], length = 0;
    assert(count <= PARTS_MAX);
    for (size_t k = 0; k < count; length += lengths[k++]) {
        if (parts[k] == yk_text_lost) return NULL;
        lengths[k] = strlen(parts[k]);
    }
    char *text = yk_arena_take(arena, length + 1), *end = text;
    if (!text) return NULL;
    for (size_t k = 0; k < count; end += lengths[k++]) memcpy(end, parts[k], lengths[k]);
    *end = '\0';
    return text;
}

static const char *copy(YkPage *page, const char *text)
{
    if (!text) return NULL;
    const char *made = yk_arena_copy(memory_of(page), text, strlen(text));
    if (!made) page->failed = true;
    return made;
}

// Adds a line with a text of its own.
static YkLine *add_line(YkPage *page, YkLineKind kind, const char *text)
{
    YkLine *line = yk_arena_take(memory_of(page), sizeof *line);
    if (!line) {
        page->failed = true;
        return NULL;
    }
    *line = (YkLine){.kind = kind, .text = text, .section = page->section, .solved = -1};
    if (page->last) page->last->next = line;
    if (!page->first) page->first = line;
    page->last = line;
    return line;
}

void yk_page_forget(YkPage *page)
{
    yk_arena_clear(page->passing);
    page->first = page->last = NULL;
}

void yk_page_heading(YkPage *page, int level, const char *text)
{
    if (page->part_ends && page->first) page->part_ends(page->context, page);
    YkLine *line = add_line(page, YK_LINE_HEADING, copy(page, text));
    if (line) line->level = level;
}

void yk_page_words(YkPage *page, const char *format, ...)
{
    YkText text = {0};
    va_list arguments;
    va_start(arguments, format);
    yk_text_vformat(&text, format, arguments);
    va_end(arguments);
    page->failed |= text.failed;
    add_line(page, YK_LINE_WORDS, copy(page, yk_text_get(&text)));
    yk_text_free(&text);
}

YkLine *yk_page_formula(YkPage *page, const char *remark)
{
    return add_line(page, YK_LINE_FORMULA, copy(page, remark));
}

YkLine *yk_page_formula_of(YkPage *page, const char *const remark[], size_t count)
{
    const char *text = yk_page_join(memory_of(page), remark, count);
    page->failed |= !text;
    return add_line(page, YK_LINE_FORMULA, text);
}

static YkPagePiece *add_piece(YkPage *page, YkLine *line, YkPagePieceKind kind)
{
    if (!yk_ring_spend(page->ring, PIECE)) page->failed = true;
    YkPagePiece *piece = line ? yk_arena_take(memory_of(page), sizeof *piece) : NULL;
    if (!piece) {
        page->failed = true;
        return NULL;
    }
    *piece = (YkPagePiece){.kind = kind};
    if (line->last) line->last->next = piece;
    if (!line->first) line->first = piece;
    line->last = piece;
    return piece;
}

void yk_line_element(YkPage *page, YkLine *line, const YkPoisson *a, YkRingStyle style)
{
    YkPagePiece *piece = add_piece(page, line, YK_PIECE_ELEMENT);
    if (!a) page->failed = true;
    if (piece) piece->over = a, piece->style = style;
}

// Beside numbers an element is needed at once: the order in which elements are made decides the last digits.
static const YkPoisson *needed(const YkPage *page, const YkPoisson *a, YkRingChanges **changes)
{
    if (!page->has_numbers || !*changes) return a;
    a = yk_ring_change(page->ring, a, *changes);
    *changes = NULL;
    return a;
}

void yk_line_changed(YkPage *page, YkLine *line, const YkPoisson *a, YkRingChanges *changes)
{
    a = needed(page, a, &changes);
    yk_line_element(page, line, a, YK_RING_TEXTBOOK);
    if (!line) return;
    if (line->last) line->last->changes = changes;
    line->value = a;
    line->value_changes = changes;
}

void yk_line_factor(YkPage *page, YkLine *line, const YkPoisson *a)
{
    yk_line_element(page, line, a, YK_RING_TEXTBOOK);
    if (line && line->last) line->last->is_factor = true;
}

void yk_line_quotient(YkPage *page, YkLine *line, const YkPoisson *over, const YkPoisson *under)
{
    YkPagePiece *piece = add_piece(page, line, YK_PIECE_QUOTIENT);
    if (!over || !under) page->failed = true;
    if (piece) piece->over = over, piece->under = under;
}

void yk_line_fraction(YkPage *page, YkLine *line, const YkPoisson *const *over, size_t over_count,
                      const YkPoisson *const *under, size_t under_count)
{
    YkPagePiece *piece = add_piece(page, line, YK_PIECE_QUOTIENT);
    const YkPoisson *const *lists[] = {over, under};
    const size_t counts[] = {over_count, under_count};
    for (int k = 0; piece && k < 2; k++) {
        piece->factors[k] = YK_NEW(memory_of(page), const YkPoisson *, counts[k] + 1);
        piece->factor_count[k] = piece->factors[k] ? counts[k] : 0;
        for (size_t i = 0; i < piece->factor_count[k]; i++) {
            piece->factors[k][i] = lists[k][i];
            page->failed |= !lists[k][i];
        }
        page->failed |= !piece->factors[k];
    }
}

void yk_line_vector(YkPage *page, YkLine *line, const char *base, const char *super, const char *sub)
{
    YkPagePiece *piece = add_piece(page, line, YK_PIECE_VECTOR);
    if (piece) piece->text = base, piece->super = copy(page, super), piece->sub = copy(page, sub);
}

void yk_line_sign(YkPage *page, YkLine *line, const char *sign)
{
    YkPagePiece *piece = add_piece(page, line, YK_PIECE_SIGN);
    if (piece) piece->text = sign;
}

void yk_line_words(YkPage *page, YkLine *line, const char *words)
{
    YkPagePiece *piece = add_piece(page, line, YK_PIECE_WORDS);
    if (piece) piece->text = copy(page, words);
}

YkShownMatrix *yk_line_matrix(YkPage *page, YkLine *line, size_t rows, size_t columns)
{
    YkPagePiece *piece = add_piece(page, line, YK_PIECE_MATRIX);
    YkShownMatrix *matrix = piece ? YK_NEW(memory_of(page), YkShownMatrix, 1) : NULL;
    if (!matrix) {
        page->failed = true;
        return NULL;
    }
    // One block: the arrays of pointers, then those of smaller things.
    size_t pointers = (rows * columns + rows) * sizeof(void *), symbols = columns * sizeof(int32_t);
    char *block = yk_arena_alloc(memory_of(page), pointers + symbols + rows + columns, 1);
    if (!block) {
        page->failed = true;
        return NULL;
    }
    matrix->rows = rows, matrix->columns = columns;
    matrix->entries = (const YkPoisson **)(void *)block;
    matrix->row_labels = (const char **)(void *)block + rows * columns;
    matrix->column_symbols = (int32_t *)(void *)(block + pointers);
    matrix->row_cut = (bool *)(block + pointers + symbols);
    matrix->column_cut = matrix->row_cut + rows;
    for (size_t k = 0; k < columns; k++) matrix->column_symbols[k] = -1;
    piece->matrix = matrix;
    return matrix;
}

void yk_line_column(YkPage *page, YkLine *line, const YkPoisson *vector, YkRingChanges *changes)
{
    YkShownMatrix *column = yk_line_matrix(page, line, 2, 1);
    vector = needed(page, vector, &changes);
    page->failed |= !vector;
    if (!column) return;
    column->vector = page->has_numbers ? NULL : vector;
    column->changes = changes;
    for (size_t k = 0; k < 2 && page->has_numbers; k++)
        column->entries[k] = (k ? yk_ring_imaginary : yk_ring_real)(page->ring, vector);
    line->value = vector;
    line->value_changes = changes;
    line->is_vector = true;
}

const YkPoisson *yk_line_value(YkRing *ring, const YkLine *line)
{
    return line->value_changes ? yk_ring_change(ring, line->value, line->value_changes) : line->value;
}

YkLine *yk_page_equation(YkPage *page, const char *remark, const YkPoisson *left, const YkPoisson *right,
                         YkRingStyle style)
{
    YkLine *line = yk_page_formula(page, remark);
    if (!line) return NULL;
    yk_line_element(page, line, left, style);
    yk_line_sign(page, line, "=");
    yk_line_element(page, line, right ? right : yk_ring_rational(page->ring, 0, 1), style);
    line->left = left, line->right = right;
    int64_t p, q;
    line->value = right && !yk_ring_is_rational(right, &p, &q) ? right : NULL;
    return line;
}

// The ring counts in exponentials, 2 cos x = e^(ix) + e^(-ix), and turns by 45 deg in roots of 2, so that a common
// divisor of 2, or a few, can remain in print.
static void halve_while_whole(YkRing *ring, const YkPoisson **over, const YkPoisson **under)
{
    enum { TIMES_MAX = 4 };
    for (int k = 0; k < TIMES_MAX; k++) {
        const YkPoisson *b = yk_ring_half_if_whole(ring, *under), *a = b ? yk_ring_half_if_whole(ring, *over) : NULL;
        if (!a) return;
        *over = a, *under = b;
    }
}

static bool is_motion(YkRing *ring, int32_t symbol)
{
    YkRingClass kind = yk_ring_symbol_class(ring, symbol);
    return kind == YK_RING_RATE || kind == YK_RING_ACCELERATION || kind == YK_RING_FUNCTION;
}

// Divides over / under if the result is a combination of rates with numbers: of bodies that turn with another, or not.
static void divide_out(YkRing *ring, const YkPoisson **over, const YkPoisson **under)
{
    const YkPoisson *rest = *over, *quotient = yk_ring_rational(ring, 0, 1);
    int64_t p, q;
    if (yk_ring_terms(*under) < 2) return;
    for (int32_t symbol = -1; (symbol = yk_ring_next_symbol(ring, *over, symbol)) >= 0;) {
        if (!is_motion(ring, symbol)) continue;
        const YkPoisson *slope = yk_ring_coefficient(ring, rest, symbol, 1), *rate = yk_ring_of(ring, symbol);
        if (!yk_ring_is_multiple(slope, *under, &p, &q)) return;
        quotient = yk_ring_add(ring, quotient, yk_ring_scale(ring, rate, p, q));
        rest = yk_ring_subtract(ring, rest, yk_ring_multiply(ring, slope, rate));
    }
    if (yk_ring_is_multiple(rest, *under, &p, &q))
        quotient = yk_ring_add(ring, quotient, yk_ring_rational(ring, p, q));
    else if (!yk_ring_is_zero(rest))
        return;
    *over = quotient;
    *under = yk_ring_rational(ring, 1, 1);
}

bool yk_page_cancel(YkRing *ring, const YkPoisson **over, const YkPoisson **under)
{
    const YkPoisson *common = yk_ring_common_content(ring, *over, *under);
    if (!common) return false;
    if (!yk_ring_is_zero(common) && !yk_ring_is_same(common, yk_ring_rational(ring, 1, 1))) {
        const YkPoisson *inverse = yk_ring_power(ring, common, -1);
        *over = yk_ring_multiply(ring, *over, inverse);
        *under = yk_ring_multiply(ring, *under, inverse);
    }
    halve_while_whole(ring, over, under);
    divide_out(ring, over, under);
    return *over && *under;
}

// Splits over = rate * rest if every term has the same rate (or influence coefficient), as a factor beside the
// fraction.
static const YkPoisson *take_rate(YkRing *ring, const YkPoisson **over)
{
    const YkPoisson *one = yk_ring_rational(ring, 1, 1), *rate = one, *content = yk_ring_content(ring, *over);
    for (int32_t symbol = -1; (symbol = yk_ring_next_symbol(ring, content, symbol)) >= 0;) {
        int32_t lowest, highest;
        if (!is_motion(ring, symbol)) continue;
        if (!yk_ring_powers(ring, content, symbol, &lowest, &highest) || lowest < 1) continue;
        rate = yk_ring_multiply(ring, rate, yk_ring_power(ring, yk_ring_of(ring, symbol), lowest));
    }
    if (!yk_ring_is_same(rate, one)) *over = yk_ring_divide(ring, *over, rate);
    return rate;
}

static void put_fraction(YkPage *page, YkLine *line, const YkPoisson *over, const YkPoisson *under)
{
    YkRing *ring = page->ring;
    int64_t p, q;
    if (yk_ring_is_rational(under, &p, &q) || yk_ring_is_zero(over)) { // a sum cannot divide, not even 0
        const YkPoisson *quotient = yk_ring_is_zero(over) ? over : yk_ring_divide(ring, over, under);
        yk_line_element(page, line, quotient, YK_RING_TEXTBOOK);
        return;
    }
    const YkPoisson *one = yk_ring_rational(ring, 1, 1), *rate = take_rate(ring, &over);
    yk_line_quotient(page, line, over, under);
    if (rate && !yk_ring_is_same(rate, one)) yk_line_factor(page, line, rate);
}

static bool has_leading_minus(YkRing *ring, const YkPoisson *a, YkText *text)
{
    return yk_ring_write(ring, a, YK_RING_TEXT, YK_RING_TEXTBOOK, text) && *yk_text_get(text) == '-';
}

bool yk_page_is_negative(YkRing *ring, const YkPoisson *a)
{
    YkText text = {0};
    bool negative = has_leading_minus(ring, a, &text);
    int depth = 0;
    for (const char *c = yk_text_get(&text) + negative; *c && negative; c++) {
        depth += (*c == '(') - (*c == ')');
        negative = depth > 0 || (*c != '+' && *c != '-');
    }
    yk_text_free(&text);
    return negative;
}

YkLine *yk_page_solution(YkPage *page, const char *remark, int32_t symbol, const YkPoisson *over,
                         const YkPoisson *under)
{
    YkRing *ring = page->ring;
    YkText text = {0};
    YkLine *line = yk_page_formula(page, remark);
    const YkPoisson *left = yk_ring_of(ring, symbol), *divisor = under ? under : yk_ring_rational(ring, 1, 1);
    if (!line || !yk_page_cancel(ring, &over, &divisor)) {
        page->failed = true;
        return NULL;
    }
    if (has_leading_minus(ring, divisor, &text))
        over = yk_ring_negate(ring, over), divisor = yk_ring_negate(ring, divisor);
    yk_text_free(&text);
    yk_line_element(page, line, left, YK_RING_TEXTBOOK);
    yk_line_sign(page, line, "=");
    put_fraction(page, line, over, divisor);
    line->left = left;
    line->value = line->over = line->right = over;
    line->value_under = line->under = line->factor = divisor;
    line->solved = symbol;
    return line;
}
