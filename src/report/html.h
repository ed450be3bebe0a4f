// HTML: small pieces that sections share.
#ifndef REPORT_HTML_H
#define REPORT_HTML_H
#include "base/escape.h"
#include "write/table.h"

// Adds text, escaped for elements and attributes.
static inline void yk_html_words(YkText *html, const char *words)
{
    yk_escape_xml(html, words);
}
// Adds "<p>words</p>", or an element of another kind.
void yk_html_element(YkText *html, const char *tag, const char *words);
// Writes a table with its caption, in a box that scrolls if it is too wide, and frees it. Does nothing without rows.
void yk_html_table(YkText *html, YkTable *table, const char *caption);
// Adds an SVG picture, with a description for readers who cannot see it. is_paper: it has its own colours.
void yk_html_picture(YkText *html, const char *svg, const char *told, const char *caption);
// Does the same as an image, for a picture whose ids and styles must be kept apart from the page's.
void yk_html_image(YkText *html, const char *svg, size_t length, const char *told, const char *caption);

#endif
