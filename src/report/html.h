// HTML out: small pieces that sections share.
#ifndef REPORT_HTML_H
#define REPORT_HTML_H
#include "base/escape.h"
#include "write/table.h"

// Adds text, escaped for elements and attributes.
static inline void yk_html_words(YkText *html, const char *words)
{
    yk_escape_xml(html, words);
}
// "<p>words</p>", and parts of other kinds.
void yk_html_element(YkText *html, const char *tag, const char *words);
// Writes a table with its caption, in a box that scrolls where it is too wide, and frees it. Does nothing without rows.
void yk_html_table(YkText *html, YkTable *table, const char *caption);
// A picture given as SVG text: drawn in the page, told to those who cannot see it. is_paper: it brings its own colours.
void yk_html_picture(YkText *html, const char *svg, const char *told, const char *caption);
// The same where its inside must stay apart from the page's (ids, styles): as an image.
void yk_html_image(YkText *html, const char *svg, size_t length, const char *told, const char *caption);

#endif
