// Writes small pieces of HTML.
#include "report/html.h"
#include <stdint.h>
#include <string.h>

void yk_html_element(YkText *html, const char *tag, const char *words)
{
    yk_text_format(html, "<%s>", tag);
    yk_html_words(html, words);
    yk_text_format(html, "</%s>\n", tag);
}

void yk_html_table(YkText *html, YkTable *table, const char *caption)
{
    if (yk_table_rows(table) > 0) {
        yk_text_puts(html, "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"");
        yk_html_words(html, caption);
        yk_text_puts(html, "\">\n");
        yk_table_write_html(table, caption, html);
        yk_text_puts(html, "</div>\n");
    }
    if (yk_table_failed(table)) yk_text_fail(html);
    yk_table_free(table);
}

static void open_figure(YkText *html, const char *class)
{
    yk_text_format(html, "<figure class=\"%s\">\n", class);
}

static void close_figure(YkText *html, const char *caption)
{
    if (*caption) yk_html_element(html, "figcaption", caption);
    yk_text_puts(html, "</figure>\n");
}

// The root element takes the role of one image; its own title is removed, since the label says more.
void yk_html_picture(YkText *html, const char *svg, const char *told, const char *caption)
{
    const char *root = strstr(svg, "<svg"), *title = strstr(svg, "<title>"), *after = strstr(svg, "</title>");
    if (svg == yk_text_lost) yk_text_fail(html);
    if (!root) return;
    open_figure(html, "paper");
    yk_text_puts(html, "<svg role=\"img\" aria-label=\"");
    yk_html_words(html, told);
    yk_text_puts(html, "\"");
    if (title && after) {
        yk_text_add(html, root + 4, (size_t)(title - root - 4));
        yk_text_puts(html, after + strlen("</title>"));
    } else {
        yk_text_puts(html, root + 4);
    }
    close_figure(html, caption);
}

static void add_base64(YkText *html, const unsigned char *data, size_t length)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < length; i += 3) {
        size_t left = length - i;
        uint32_t bits =
            (uint32_t)data[i] << 16 | (left > 1 ? (uint32_t)data[i + 1] << 8 : 0) | (left > 2 ? data[i + 2] : 0);
        char four[4] = {digits[bits >> 18], digits[bits >> 12 & 63], left > 1 ? digits[bits >> 6 & 63] : '=',
                        left > 2 ? digits[bits & 63] : '='};
        yk_text_add(html, four, 4);
    }
}

void yk_html_image(YkText *html, const char *svg, size_t length, const char *told, const char *caption)
{
    if (svg == yk_text_lost) yk_text_fail(html);
    if (html->failed) return;
    open_figure(html, "paper");
    yk_text_puts(html, "<img alt=\"");
    yk_html_words(html, told);
    yk_text_puts(html, "\" src=\"data:image/svg+xml;base64,");
    add_base64(html, (const unsigned char *)svg, length);
    yk_text_puts(html, "\">\n");
    close_figure(html, caption);
}
