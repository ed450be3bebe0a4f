// Pages of mathematics (derive/page.h) in print.
#ifndef PAGE_PRINT_H
#define PAGE_PRINT_H
#include "base/text.h"
#include "derive/page.h"
#include "write/json.h"

typedef enum YkPageFormat {
    YK_PAGE_TEXT,
    YK_PAGE_LATEX,
    YK_PAGE_MATHML,
    YK_PAGE_JSON,
    YK_PAGE_C,
    YK_PAGE_FORMATS
} YkPageFormat;

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

// Writes a page: text for people (80 columns are not kept: a formula is one line, a matrix a box); a whole LaTeX
// document (article, amsmath); a whole HTML document with presentation MathML; JSON as in man/yoke-derive.1.scd; a
// C file with a function a section. false when out of memory or where the ring failed.
bool yk_page_write(const YkPage *page, YkPageFormat format, const char *title, const double *values, YkText *text);
// The page as a part of an HTML document, headings from the level given on. Values as above. false as above.
bool yk_page_write_part(const YkPage *page, int heading, const double *values, YkText *html);
// A page that comes in parts, in any format but C, whose struct has to know all: each is added to printing->text, the
// first below the page's head. At the end yk_page_end_parts adds what closes the page and gives the memory back.
// Between parts the text may be taken away. false when out of memory or where the ring failed.
bool yk_page_has_parts(YkPageFormat format);
bool yk_page_add_part(YkPrinting *printing, const YkPage *part);
bool yk_page_end_parts(YkPrinting *printing);
// "text", "latex", ...; YK_PAGE_FORMATS where there is no such format.
YkPageFormat yk_page_format_find(const char *name);

// --- Inside: one file a format. The head of a page, its lines, its end.
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
// One formula without its value, on one line: matrices as [a, b; c, d].
void yk_print_formula_text(YkPrinting *printing, const YkLine *line, YkText *text);
void yk_print_formula_latex(YkPrinting *printing, const YkLine *line, YkText *text);
void yk_print_element(YkPrinting *printing, const YkPoisson *a, YkRingFormat format, YkRingStyle style, YkText *text);
bool yk_print_has_sum(const char *text); // + or - outside of brackets
bool yk_print_is_one_factor(const char *text);
void yk_print_brackets(YkText *text, size_t start);             // round what was written since `start`
bool yk_print_is_sum(YkPrinting *printing, const YkPoisson *a); // does it need brackets as a factor?
// The value of a line; false if there is none. 6 significant digits.
bool yk_print_value(const YkPrinting *printing, const YkLine *line, YkVec *value);
// The matrix of a line that shows just one, else NULL: its values may stand behind it.
const YkShownMatrix *yk_print_only_matrix(const YkLine *line);
double yk_print_entry(const YkPrinting *printing, const YkPoisson *entry);
void yk_print_number(YkText *text, double value);
// Names: a letter with digits behind it is set with a subscript, others as words.
bool yk_print_is_letter_name(const char *name);

#endif
