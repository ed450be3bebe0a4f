// The pieces of a formula as plain text, in one line.
#include "page/print.h"

static void put_factor(YkPrinting *printing, const YkPoisson *a, YkText *text)
{
    size_t start = text->length;
    yk_print_element(printing, a, YK_RING_BOOK, YK_RING_TEXTBOOK, text);
    if (yk_print_has_sum(yk_text_get(text) + start)) yk_print_brackets(text, start);
}

// Writes a dividend; a minus before a single product needs no brackets.
static void put_dividend(YkPrinting *printing, const YkPoisson *a, YkText *text)
{
    size_t start = text->length;
    yk_print_element(printing, a, YK_RING_BOOK, YK_RING_TEXTBOOK, text);
    const char *written = yk_text_get(text) + start;
    if (yk_print_has_sum(written + (*written == '-'))) yk_print_brackets(text, start);
}

// Writes a divisor; more than one symbol needs brackets.
static void put_divisor(YkPrinting *printing, const YkPoisson *a, YkText *text)
{
    size_t start = text->length;
    yk_print_element(printing, a, YK_RING_BOOK, YK_RING_TEXTBOOK, text);
    if (!yk_print_is_one_factor(yk_text_get(text) + start)) yk_print_brackets(text, start);
}

// Writes a product of factors; below the line in brackets if there are several.
static void put_factors(YkPrinting *printing, const YkPagePiece *piece, int side, YkText *text)
{
    size_t count = piece->factor_count[side];
    bool brackets = side == 1 && count > 1;
    if (brackets) yk_text_puts(text, "(");
    for (size_t k = 0; k < count; k++) {
        if (k > 0) yk_text_puts(text, " ");
        if (side == 1 && count == 1)
            put_divisor(printing, piece->factors[side][k], text);
        else
            put_factor(printing, piece->factors[side][k], text);
    }
    if (brackets) yk_text_puts(text, ")");
}

static void put_quotient(YkPrinting *printing, const YkPagePiece *piece, YkText *text)
{
    if (piece->factors[0])
        put_factors(printing, piece, 0, text);
    else
        put_dividend(printing, piece->over, text);
    yk_text_puts(text, " / ");
    if (piece->factors[1])
        put_factors(printing, piece, 1, text);
    else
        put_divisor(printing, piece->under, text);
}

static void put_name(const YkPagePiece *piece, YkText *text)
{
    yk_text_puts(text, piece->text);
    if (piece->sub) {
        yk_text_puts(text, "_");
        yk_text_puts(text, piece->sub);
    }
    if (!piece->super) return;
    yk_text_puts(text, "^{");
    yk_text_puts(text, piece->super);
    yk_text_puts(text, "}");
}

static bool is_sign_of(const YkPagePiece *piece, const char *signs)
{
    if (piece->kind != YK_PIECE_SIGN) return false;
    while (*signs && *signs != *piece->text) signs++;
    return *signs != '\0';
}

void yk_print_text_piece(YkPrinting *printing, const YkPagePiece *piece, const YkPagePiece *before, YkText *text)
{
    const YkRingView view = yk_print_piece(piece);
    bool is_spaced = before && !is_sign_of(piece, ",)]") && !is_sign_of(before, "([");
    if (before && before->kind == YK_PIECE_QUOTIENT && piece->kind == YK_PIECE_ELEMENT) yk_text_puts(text, " *");
    if (is_spaced) yk_text_puts(text, " ");
    switch (piece->kind) {
    case YK_PIECE_ELEMENT:
        if (piece->is_factor)
            put_factor(printing, piece->over, text);
        else
            yk_print_view(printing, &view, YK_RING_BOOK, piece->style, text);
        break;
    case YK_PIECE_QUOTIENT:
        put_quotient(printing, piece, text);
        break;
    case YK_PIECE_VECTOR:
        put_name(piece, text);
        break;
    case YK_PIECE_SIGN:
    case YK_PIECE_WORDS:
        yk_text_puts(text, piece->text);
        break;
    case YK_PIECE_MATRIX:
        break;
    }
}

void yk_print_formula_text(YkPrinting *printing, const YkLine *line, YkText *text)
{
    const YkPagePiece *before = NULL;
    for (const YkPagePiece *piece = line->first; piece; before = piece, piece = piece->next) {
        yk_print_text_piece(printing, piece, before, text);
        if (piece->kind != YK_PIECE_MATRIX) continue;
        const YkShownMatrix *matrix = piece->matrix;
        yk_text_puts(text, "[");
        for (size_t k = 0; k < matrix->rows * matrix->columns; k++) {
            if (k > 0) yk_text_puts(text, k % matrix->columns == 0 ? "; " : ", ");
            const YkRingView entry = yk_shown_entry(matrix, k);
            yk_print_view(printing, &entry, YK_RING_BOOK, YK_RING_TEXTBOOK, text);
        }
        yk_text_puts(text, "]");
    }
}
