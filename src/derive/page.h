// A page of mathematics, before it is text, LaTeX, MathML, JSON or C: headings, sentences, formulas. Formulas are rows
// of pieces that know their elements, so that every printer writes them its way, values can be put beside them, and
// tests can ask whether a formula is true.
#ifndef DERIVE_PAGE_H
#define DERIVE_PAGE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/memory.h"
#include "ring/graph/element.h"
#include "ring/print/write.h"
#include "ring/ring.h"

typedef enum YkPagePieceKind {
    YK_PIECE_ELEMENT,  // an element; in brackets if it is a sum and `is_factor`
    YK_PIECE_QUOTIENT, // over / under, or products of factors over and under the line
    YK_PIECE_VECTOR,   // a vector's or force's name: base, superscript, subscript: p^{A/O1}, F_{01}
    YK_PIECE_SIGN,     // = + - x . ( ) , as they stand; "x" is the cross product, "." the dot product
    YK_PIECE_WORDS,    // plain words inside a formula
    YK_PIECE_MATRIX    // rows x columns of elements
} YkPagePieceKind;

// For code: makes the entries in a shorter way than one by one, row by row. Returns false on failure.
typedef bool (*YkPageBuild)(void *context, YkRingGraph *graph, YkRef *entries);
// For code: defines symbols that stand for others.
typedef bool (*YkPageDefine)(void *context, YkRingGraph *graph);

// Entries row by row; NULL is 0. A cut after row or column k is a printed line between blocks. Labels may be NULL.
typedef struct YkShownMatrix {
    size_t rows, columns;
    const YkPoisson **entries;
    const YkPoisson *vector;    // not NULL: its x and y, one below the other, stand in place of entries
    YkRingChanges *changes;     // then what it becomes by these; NULL: as it is
    bool *row_cut, *column_cut; // NULL: none
    const char **row_labels;
    int32_t *column_symbols; // NULL: none
    const char *target;      // in C: the array that it fills; NULL: none
    const char *code_remark; // in C: what it is, "A xi = b with xi = F01x, F01y"; or NULL
    YkPageBuild build;       // NULL: entry by entry
    void *build_context;
} YkShownMatrix;

typedef struct YkPagePiece YkPagePiece;
struct YkPagePiece {
    YkPagePieceKind kind;
    const YkPoisson *over, *under;
    YkRingChanges *changes;       // of an element: shown as what it becomes by these; NULL: as it is
    const YkPoisson **factors[2]; // of a quotient of products: over and under, in place of `over` and `under`
    size_t factor_count[2];
    YkRingStyle style;
    bool is_factor;
    const char *text, *super, *sub; // sign, words; base of a name
    YkShownMatrix *matrix;
    YkPagePiece *next;
};

typedef enum YkLineKind { YK_LINE_HEADING, YK_LINE_WORDS, YK_LINE_FORMULA } YkLineKind;

typedef struct YkLine YkLine;
struct YkLine {
    YkLineKind kind;
    int level;           // of a heading: 1 section, 2 part of it
    const char *text;    // heading, words; of a formula a name or remark, or NULL
    const char *section; // the section it belongs to
    YkPagePiece *first, *last;
    // factor * left = right holds wherever the formula does, on the machine's own motion. right NULL: 0; factor NULL:
    // 1; left NULL: not an equation between scalars or vectors.
    const YkPoisson *left, *right, *factor;
    bool is_identity;   // it holds by itself, for free coordinates
    bool is_in_numbers; // it holds only with the file's numbers
    // For C: target = over / under; under NULL: 1. "Phi" gathers rows. NULL: no statement, unless the formula is
    // name = a value: then the name. Matrices have targets of their own.
    const char *target;
    int32_t solved; // the symbol that is the target; -1: none
    const YkPoisson *over, *under;
    // For values beside symbols: the element that has a number; under NULL: 1. NULL: none.
    const YkPoisson *value, *value_under;
    YkRingChanges *value_changes; // the value is what it becomes by these; NULL: as it is
    bool is_vector;               // the value has x and y
    const YkPoisson *within; // holds, and has its value, only where this lies in 0 to 1: a segment; NULL: everywhere
    YkLine *next;
};

typedef struct YkPage {
    bool has_numbers; // with numbers: sections may add lines that hold for the file's own
    YkArena *arena;   // of all that follows
    YkRing *ring;
    YkLine *first, *last;
    const char *section;      // given to new lines
    const char *told_in;      // the section that has explained the symbols of forces
    size_t constants_told[2]; // number of the derivation's constants already looked through: others, masses
    YkPageDefine define;      // or NULL
    void *define_context;
    bool failed; // out of memory
    // For a page that comes in parts: called at the end of each, to print its lines and forget them. NULL: kept whole.
    void (*part_ends)(void *context, struct YkPage *page);
    void *context;
    YkArena *passing; // then: memory of lines, pieces and their texts
} YkPage;

// Removes all lines of a page that comes in parts, and their memory.
void yk_page_forget(YkPage *page);
// A zeroed page with arena and ring set is empty. All of the following accept NULL lines (after a failure) and copy
// texts.
void yk_page_heading(YkPage *page, int level, const char *text);
void yk_page_words(YkPage *page, const char *format, ...); // yk_text_format's
YkLine *yk_page_formula(YkPage *page, const char *remark); // an empty formula; remark may be NULL
// Does the same with a remark that is put together of up to four parts.
YkLine *yk_page_formula_of(YkPage *page, const char *const remark[], size_t count);
// Puts up to four texts together in an arena. Returns NULL when out of memory, now or where a part was made.
const char *yk_page_join(YkArena *arena, const char *const parts[], size_t count);

void yk_line_element(YkPage *page, YkLine *line, const YkPoisson *a, YkRingStyle style);
// Does the same with what it becomes by changes, which is worked out where it is needed, and gives the line this value.
void yk_line_changed(YkPage *page, YkLine *line, const YkPoisson *a, YkRingChanges *changes);
void yk_line_factor(YkPage *page, YkLine *line, const YkPoisson *a); // in brackets if it is a sum
void yk_line_quotient(YkPage *page, YkLine *line, const YkPoisson *over, const YkPoisson *under);
// Adds products of factors over each other, each in brackets if it is a sum; copies the lists.
void yk_line_fraction(YkPage *page, YkLine *line, const YkPoisson *const *over, size_t over_count,
                      const YkPoisson *const *under, size_t under_count);
// The base and the sign are literals, which are not copied.
void yk_line_vector(YkPage *page, YkLine *line, const char *base, const char *super, const char *sub);
void yk_line_sign(YkPage *page, YkLine *line, const char *sign);
void yk_line_words(YkPage *page, YkLine *line, const char *words);
// Adds a zeroed matrix with room for its entries, to be filled; NULL when out of memory.
YkShownMatrix *yk_line_matrix(YkPage *page, YkLine *line, size_t rows, size_t columns);
// Adds a vector, or what it becomes by changes (which may be NULL), as a column of x and y, which becomes the line's
// value.
void yk_line_column(YkPage *page, YkLine *line, const YkPoisson *vector, YkRingChanges *changes);
// Adds left = right, both real elements; right may be NULL for 0. The value is set unless right is a number.
YkLine *yk_page_equation(YkPage *page, const char *remark, const YkPoisson *left, const YkPoisson *right,
                         YkRingStyle style);
// Adds symbol = over / under with common factors cancelled, with C and value. `under` NULL: 1.
YkLine *yk_page_solution(YkPage *page, const char *remark, int32_t symbol, const YkPoisson *over,
                         const YkPoisson *under);
// Returns the line's value as it is shown; NULL if it has none.
const YkPoisson *yk_line_value(YkRing *ring, const YkLine *line);
// Returns entry k of a matrix, row by row.
static inline YkRingView yk_shown_entry(const YkShownMatrix *matrix, size_t k)
{
    if (!matrix->vector) return yk_ring_as_is(matrix->entries[k]);
    return (YkRingView){matrix->vector, matrix->changes, k == 0 ? YK_RING_X : YK_RING_Y};
}
// Returns whether it prints as a product with a minus before it.
bool yk_page_is_negative(YkRing *ring, const YkPoisson *a);
// Divides both by what all their terms have in common. Returns false if the ring failed.
bool yk_page_cancel(YkRing *ring, const YkPoisson **over, const YkPoisson **under);

#endif
