// Escapes control characters, invisible characters and bytes that are not UTF-8; quotes names for messages.
#include "base/escape.h"
#include <string.h>
#include "base/utf8.h"

enum { QUOTE_COLUMNS = 80 };

static void add_hex(YkText *text, uint32_t value, int digits)
{
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4)
        yk_text_add(text, &"0123456789abcdef"[value >> shift & 15], 1);
}

static void add_escape(YkText *text, uint32_t code)
{
    if (code == '\n' || code == '\t' || code == '\r') {
        yk_text_puts(text, code == '\n' ? "\\n" : code == '\t' ? "\\t" : "\\r");
    } else if (code <= 0xff) {
        yk_text_puts(text, "\\x");
        add_hex(text, code, 2);
    } else {
        yk_text_puts(text, "\\u{");
        add_hex(text, code, code > 0xffff ? 6 : 4);
        yk_text_puts(text, "}");
    }
}

size_t yk_escape_one(YkText *text, const char *data, size_t length, size_t *columns)
{
    uint32_t code;
    size_t size = yk_utf8_decode(data, length, &code), before = text->length;
    if (size > 0 && yk_utf8_printable(code)) {
        yk_text_add(text, data, size);
        *columns += (size_t)yk_utf8_width(code);
        return size;
    }
    add_escape(text, size > 0 ? code : (unsigned char)data[0]);
    *columns += text->length - before;
    return size > 0 ? size : 1;
}

void yk_escape(YkText *text, const char *data, size_t length)
{
    if (data == yk_text_lost) yk_text_fail(text);
    if (text->failed) return;
    for (size_t i = 0, columns = 0; i < length;) i += yk_escape_one(text, data + i, length - i, &columns);
}

void yk_escape_quoted(YkText *text, const char *string)
{
    size_t length = strlen(string), columns = 0, i = 0;
    if (string == yk_text_lost) yk_text_fail(text);
    yk_text_add(text, "`", 1);
    while (i < length && columns < QUOTE_COLUMNS) i += yk_escape_one(text, string + i, length - i, &columns);
    if (i < length) yk_text_puts(text, "...");
    yk_text_add(text, "`", 1);
}

void yk_escape_xml(YkText *xml, const char *string)
{
    if (string == yk_text_lost) yk_text_fail(xml);
    for (const char *c = string; *c; c++) {
        unsigned char byte = (unsigned char)*c;
        if (byte == '&') {
            yk_text_puts(xml, "&amp;");
        } else if (byte == '<') {
            yk_text_puts(xml, "&lt;");
        } else if (byte == '>') {
            yk_text_puts(xml, "&gt;");
        } else if (byte == '"') {
            yk_text_puts(xml, "&quot;");
        } else if (byte < 0x20) {
            yk_text_puts(xml, "\xef\xbf\xbd");
        } else {
            yk_text_add(xml, c, 1);
        }
    }
}
