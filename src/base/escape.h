// Makes foreign text safe to show: characters that a terminal would act upon become escapes.
#ifndef BASE_ESCAPE_H
#define BASE_ESCAPE_H
#include "base/text.h"

// Adds one character of data[0..length) to text, escaped where it is not printable UTF-8 ("\n", "\t", "\x1b", or its
// code point as "\u{202e}"). Returns the bytes consumed; *columns grows by its width on a terminal.
size_t yk_escape_one(YkText *text, const char *data, size_t length, size_t *columns);
// Adds all of data, escaped.
void yk_escape(YkText *text, const char *data, size_t length);
// Adds `string` in `backquotes`, escaped and cut at 80 columns (then "..." stands before the closing quote).
void yk_escape_quoted(YkText *text, const char *string);
// Adds `string` escaped for element text and attributes; characters that XML forbids become U+FFFD.
void yk_escape_xml(YkText *xml, const char *string);

#endif
