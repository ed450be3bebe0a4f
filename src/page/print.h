// Prints pages of mathematics (derive/page.h).
#ifndef PAGE_PRINT_H
#define PAGE_PRINT_H
#include <yoke/derive.h>
#include "base/text.h"
#include "derive/page.h"
#include "write/json.h"

typedef struct YkPrinting {
    YkRing *ring;
    YkText *text;
    const double *values;      // completed, to be put beside the symbols (SI, radians); NULL: none
    const char *title;         // of the whole: the machine's name
    int heading;               // HTML: level of a section's heading
    YkPageFormat format;       // of a page that comes in parts
    bool has_begun;            // its head is written
    struct YkTextSheet *sheet; // of text, while it comes in parts
    YkJson json;               // of JSON likewise: what is open
    bool in_section;
    bool failed;
} YkPrinting;

// Writes a page: text for people (a formula is one line, a matrix a box, whatever the width); a whole LaTeX document
// (article, amsmath); a whole HTML document with presentation MathML; JSON as in man/yoke-derive.1.scd; a C file with a
// function for each section. Returns false when out of memory or if the ring failed.
bool yk_page_write(const YkPage *page, YkPageFormat format, const char *title, const double *values, YkText *text);
// Writes the page as a part of an HTML document, with headings from the given level. Values and result as above.
bool yk_page_write_part(const YkPage *page, int heading, const double *values, YkText *html);
// A page that comes in parts, in any format except C, whose struct needs the whole page: each part is added to
// printing->text, the first after the page's head. At the end yk_page_end_parts adds what closes the page and frees the
// memory. Between parts the text may be removed. Returns false when out of memory or if the ring failed.
bool yk_page_has_parts(YkPageFormat format);
bool yk_page_add_part(YkPrinting *printing, const YkPage *part);
bool yk_page_end_parts(YkPrinting *printing);

// --- Inside: one file for each format, with the head of a page, its lines, its end
void yk_print_text_head(YkPrinting *printing);
void yk_print_text_part(YkPrinting *printing, const YkPage *part);
void yk_print_text_end(YkPrinting *printing);
void yk_print_latex_head(YkPrinting *printing);
void yk_print_latex_part(YkPrinting *printing, const YkPage *part);
void yk_print_latex_end(YkPrinting *printing);
void yk_print_mathml_head(YkPrinting *printing);
void yk_print_mathml_part(YkPrinting *printing, const YkPage *part);
void yk_print_mathml_end(YkPrinting *printing);
void yk_print_json_head(YkPrinting *printing);
void yk_print_json_part(YkPrinting *printing, const YkPage *part);
void yk_print_json_end(YkPrinting *printing);
void yk_print_c(YkPrinting *printing, const YkPage *page);
// Writes one formula without its value, on one line: matrices as [a, b; c, d].
void yk_print_formula_text(YkPrinting *printing, const YkLine *line, YkText *text);
void yk_print_formula_latex(YkPrinting *printing, const YkLine *line, YkText *text);
// Writes a piece, unless it is a matrix, as text in one line; `before`: the piece that it follows, or NULL.
void yk_print_text_piece(YkPrinting *printing, const YkPagePiece *piece, const YkPagePiece *before, YkText *text);
void yk_print_element(YkPrinting *printing, const YkPoisson *a, YkRingFormat format, YkRingStyle style, YkText *text);
void yk_print_view(YkPrinting *printing, const YkRingView *view, YkRingFormat format, YkRingStyle style, YkText *text);
YkRingView yk_print_piece(const YkPagePiece *piece); // what a piece that is an element shows
bool yk_print_has_sum(const char *text);             // + or - outside of brackets
bool yk_print_is_one_factor(const char *text);
void yk_print_brackets(YkText *text, size_t start);                 // round what was written since `start`
bool yk_print_is_sum(YkPrinting *printing, const YkRingView *view); // does it need brackets as a factor?
// Returns the value of a line to 6 significant digits; false if there is none.
bool yk_print_value(const YkPrinting *printing, const YkLine *line, YkVec *value);
// Returns the matrix of a line that shows just one, otherwise NULL: its values may follow it.
const YkShownMatrix *yk_print_only_matrix(const YkLine *line);
double yk_print_entry(const YkPrinting *printing, const YkRingView *entry);
void yk_print_number(YkText *text, double value);
// Returns whether a name is a letter with digits, which is set with a subscript; others are set as words.
bool yk_print_is_letter_name(const char *name);

#endif
