// Growing text, with a failed state that stays.
#include "base/text.h"
#include <stdint.h>
#include <stdlib.h>

enum { SIZE_MIN = 256 };

const char yk_text_lost[] = "out of memory";

void yk_text_free(YkText *text)
{
    free(text->data);
    *text = (YkText){0};
}

const char *yk_text_get(const YkText *text)
{
    return text->failed ? yk_text_lost : text->data ? text->data : "";
}

bool yk_text_has_some(const YkText *text)
{
    return text->length > 0 || text->failed;
}

void yk_text_clear(YkText *text)
{
    text->length = 0;
    if (text->failed) text->capacity = 0;
    if (text->data) text->data[0] = '\0';
}

void yk_text_fail(YkText *text)
{
    text->failed = true;
    text->capacity = text->length; // no room for anything
}

bool yk_text_reserve(YkText *text, size_t extra)
{
    if (text->failed) return false;
    if (extra < text->capacity - text->length) return true;
    size_t needed = text->length + extra + 1, doubled = 2 * text->capacity;
    char *grown = NULL;
    if (needed > extra && needed <= PTRDIFF_MAX) {
        if (needed < doubled) needed = doubled;
        if (needed < SIZE_MIN) needed = SIZE_MIN;
        grown = realloc(text->data, needed);
    }
    if (!grown) {
        yk_text_fail(text);
        return false;
    }
    text->data = grown;
    text->capacity = needed;
    return true;
}

void yk_text_move(YkText *text, char *to, size_t size)
{
    size_t length = text->failed ? 0 : text->length < size ? text->length : size - 1;
    if (length > 0) memcpy(to, text->data, length);
    to[length] = '\0';
    yk_text_free(text);
}

void yk_text_repeat(YkText *text, char character, size_t count)
{
    if (!yk_text_reserve(text, count)) return;
    memset(text->data + text->length, character, count);
    text->length += count;
    text->data[text->length] = '\0';
}
