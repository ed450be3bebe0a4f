// Text: a growing string, and formatting without stdio or locale.
//
// A failure is kept and passed on, so callers check only where they hand a text over (`failed`). A text that has run
// out of memory accepts nothing more and stays failed until it is freed. Its content is then `yk_text_lost`, and
// whatever is given that content - another text, an arena's copy, a writer of files - fails as well.
#ifndef BASE_TEXT_H
#define BASE_TEXT_H
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

typedef struct YkText {
    char *data; // NUL-terminated once anything was added; read it by yk_text_get
    size_t length, capacity;
    bool failed; // an allocation failed; the text is then incomplete
} YkText;

// The content of a failed text, recognised by its address.
extern const char yk_text_lost[];

void yk_text_free(YkText *text);             // frees and zeroes; a zeroed YkText is an empty text
const char *yk_text_get(const YkText *text); // never NULL; `yk_text_lost` if the text failed
bool yk_text_has_some(const YkText *text);   // whether there is anything to hand on: content, or a failure
void yk_text_clear(YkText *text);            // empties the text; keeps its memory and its failed state
void yk_text_fail(YkText *text);             // marks the text failed: something that should have been added is missing
// Makes room for `extra` more bytes and the final NUL. Returns false when out of memory, now or before: a text with a
// hole would be worse than one cut short.
bool yk_text_reserve(YkText *text, size_t extra);
static inline void yk_text_add(YkText *text, const char *data, size_t length)
{
    if (data == yk_text_lost) yk_text_fail(text);
    if (length >= text->capacity - text->length && !yk_text_reserve(text, length)) return;
    if (length > 0) memcpy(text->data + text->length, data, length);
    text->length += length;
    text->data[text->length] = '\0';
}
// Does the same where 16 bytes of data can be read whatever its length: copies short ones in one go.
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
// Adds a string; NULL stands for a string for which there was no memory.
static inline void yk_text_puts(YkText *text, const char *string)
{
    if (string)
        yk_text_add(text, string, strlen(string));
    else
        yk_text_fail(text);
}
static inline void yk_text_join(YkText *text, const YkText *other)
{
    yk_text_add(text, yk_text_get(other), other->length);
}
// Moves the content into a buffer of this size, cut short where it does not fit, and frees the text. A failed text
// leaves the buffer empty.
void yk_text_move(YkText *text, char *to, size_t size);
void yk_text_repeat(YkText *text, char character, size_t count);
// Formats: %s string, %q string in `backquotes` with bytes outside printable UTF-8 escaped and cut at 80 columns,
// %c char, %d int, %u unsigned, %z size_t, %g double (shortest that reads back), %e double to 6 significant digits, %%.
void yk_text_format(YkText *text, const char *format, ...);
void yk_text_vformat(YkText *text, const char *format, va_list arguments);

#endif
