// Checks the bytes of the text before any grammar: UTF-8, control characters, tabs. libyaml checks some of this too,
// but reports only the byte.
#include "base/utf8.h"
#include "doc/reader.h"

// Returns whether text[i] is a continuation byte.
static bool continues(const char *text, size_t i)
{
    return ((unsigned char)text[i] & 0xc0) == 0x80;
}

bool yk_doc_is_allowed(uint32_t c)
{
    if (c < 0x20 || (c >= 0x7f && c <= 0x9f)) return false;
    if (c < 0x2000) return true;
    if (c >= 0x2028 && c <= 0x202e) return false; // line separators, and marks that reorder
    if (c >= 0x2066 && c <= 0x2069) return false; // more such marks
    if (c == 0xfeff || (c >= 0xfdd0 && c <= 0xfdef)) return false;
    return (c & 0xfffe) != 0xfffe;
}

YkPlace yk_doc_place_of(const char *text, size_t offset)
{
    YkPlace place = {1, 1, 1};
    for (size_t i = 0; i < offset; i++) {
        if (text[i] == '\n') {
            place.line++;
            place.column = 1;
        } else if (!continues(text, i)) {
            place.column++;
        }
    }
    return place;
}

static bool refuse_bytes(const char *text, size_t offset, YkProblems *problems)
{
    unsigned value = (unsigned char)text[offset];
    yk_problem(problems, YK_CODE_YAML_UTF8, yk_doc_place_of(text, offset), "byte %u is not UTF-8 text", value);
    yk_problem_hint(problems, "save the file in the encoding UTF-8");
    return false;
}

static bool refuse_control(const char *text, size_t offset, uint32_t code_point, YkProblems *problems)
{
    static const char digits[] = "0123456789ABCDEF";
    char hex[7] = "U+0000";
    for (int i = 0; i < 4; i++) hex[5 - i] = digits[code_point >> (4 * i) & 15];
    yk_problem(problems, YK_CODE_YAML_CONTROL, yk_doc_place_of(text, offset), "an invisible control character, %s",
               hex);
    yk_problem_hint(problems, "remove it; lines end with a line feed, alone or after a carriage return");
    return false;
}

static bool refuse_tab(const char *text, size_t offset, YkProblems *problems)
{
    yk_problem(problems, YK_CODE_YAML_TAB, yk_doc_place_of(text, offset), "a tab in the indentation");
    yk_problem_hint(problems, "indent with spaces");
    return false;
}

bool yk_doc_guard(const char *text, size_t length, YkProblems *problems)
{
    bool indenting = true; // only blanks so far on this line
    for (size_t i = 0; i < length;) {
        unsigned char c = (unsigned char)text[i];
        uint32_t code_point;
        size_t bytes = 1;
        if (c >= 0x80) {
            bytes = yk_utf8_decode(text + i, length - i, &code_point);
            if (!bytes) return refuse_bytes(text, i, problems);
            if (!yk_doc_is_allowed(code_point)) return refuse_control(text, i, code_point, problems);
            indenting = false;
        } else if (c == '\n') {
            indenting = true;
        } else if (c == '\t') {
            if (indenting) return refuse_tab(text, i, problems);
        } else if (c == '\r') {
            if (i + 1 == length || text[i + 1] != '\n') return refuse_control(text, i, c, problems);
        } else if (c < 0x20 || c == 0x7f) {
            return refuse_control(text, i, c, problems);
        } else if (c != ' ') {
            indenting = false;
        }
        i += bytes;
    }
    return true;
}
