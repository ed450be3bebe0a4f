// A text that is filled again and again, one word after the other.
#ifndef OUT_WORDS_H
#define OUT_WORDS_H
#include "base/text.h"

// Empties a text but keeps in mind that it failed once, so that a failure in the middle of many is not forgotten.
static inline void yk_words_renew(YkText *words)
{
    bool has_failed = words->failed;
    yk_text_clear(words);
    words->failed = has_failed;
}

#endif
