// Text: a growing string, and formatting without stdio or locale.
#ifndef BASE_TEXT_H
#define BASE_TEXT_H
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

typedef struct YkText {
    char *data; // always NUL-terminated once anything was added; "" before (use yk_text_get)
    size_t length, capacity;
    bool failed; // an allocation failed; the text is then incomplete
} YkText;

void yk_text_free(YkText *text);             // frees and zeroes; a zeroed YkText is an empty text
const char *yk_text_get(const YkText *text); // never NULL
void yk_text_clear(YkText *text);            // empties, keeps the memory
// Makes room for so many more bytes and the final NUL; false when out of memory, now or before: a text with a hole
// would be worse than one cut short.
bool yk_text_reserve(YkText *text, size_t extra);
static inline void yk_text_add(YkText *text, const char *data, size_t length)
{
    if (length >= text->capacity - text->length && !yk_text_reserve(text, length)) return;
    if (length > 0) memcpy(text->data + text->length, data, length);
    text->length += length;
    text->data[text->length] = '\0';
}
// The same where 16 bytes of data can be read whatever its length: short ones are copied in one go.
static inline void yk_text_add_padded(YkText *text, const char *data, size_t length)
{
    enum { ROW = 16 };
    if (length > ROW || text->capacity - text->length <= ROW) {
        yk_text_add(text, data, length);
        return;
    }
    memcpy(text->data + text->length, data, ROW);
    text->length += length;
    text->data[text->length] = '\0';
}
static inline void yk_text_puts(YkText *text, const char *string)
{
    yk_text_add(text, string, strlen(string));
}
void yk_text_repeat(YkText *text, char character, size_t count);
// Formats: %s string, %q string in `backquotes` with bytes outside printable UTF-8 escaped and cut at 80 columns,
// %c char, %d int, %u unsigned, %z size_t, %g double (shortest that reads back), %e double to 6 significant digits, %%.
void yk_text_format(YkText *text, const char *format, ...);
void yk_text_vformat(YkText *text, const char *format, va_list arguments);

#endif
