// Quotes the source line of a problem with a caret below it. Places count code points; the layout counts terminal
// columns.
#include <string.h>
#include "base/escape.h"
#include "base/problem_list.h"
#include "base/utf8.h"

enum {
    INDENT = 4,
    TAB = 4,
    WINDOW = 160,     // terminal columns shown of a long line
    LEAD = 80,        // code points shown before the place when the line's start is cut off
    FIT = WINDOW - 40 // a place up to here shows the line from its start
};

static bool is_line_break(char c)
{
    return c == '\n' || c == '\r';
}

static YkSourceCursor line_start(const YkProblems *problems, size_t offset, uint32_t line)
{
    size_t end = offset;
    while (end < problems->source_length && !is_line_break(problems->source[end])) end++;
    return (YkSourceCursor){offset, end, line, 1};
}

YkSourceCursor yk_source_start(const YkProblems *problems)
{
    return line_start(problems, 0, 1);
}

// Moves to the start of `line`; lines end with LF, CR LF or CR. Returns false when the source has fewer lines.
static bool seek_line(const YkProblems *problems, uint32_t line, YkSourceCursor *cursor)
{
    while (cursor->line < line) {
        size_t end = cursor->line_end, left = problems->source_length - end;
        if (left == 0) return false;
        size_t bytes = left > 1 && memcmp(problems->source + end, "\r\n", 2) == 0 ? 2 : 1;
        *cursor = line_start(problems, end + bytes, cursor->line + 1);
    }
    return true;
}

static void seek_column(const YkProblems *problems, uint32_t column, YkSourceCursor *cursor)
{
    for (; cursor->column < column && cursor->offset < cursor->line_end; cursor->column++) {
        uint32_t code;
        size_t size = yk_utf8_decode(problems->source + cursor->offset, cursor->line_end - cursor->offset, &code);
        cursor->offset += size > 0 ? size : 1;
    }
}

// Adds one character; a tab becomes spaces up to the next tab stop. Returns the bytes read.
static size_t show_one(YkText *text, const char *data, size_t length, size_t *columns)
{
    if (data[0] != '\t') return yk_escape_one(text, data, length, columns);
    size_t spaces = TAB - *columns % TAB;
    yk_text_repeat(text, ' ', spaces);
    *columns += spaces;
    return 1;
}

// Terminal columns of the quoted text: where the caret starts, and where its underline ends.
typedef struct Underline {
    size_t first, end;
} Underline;

static Underline show_line(YkText *text, const YkProblems *problems, YkPlace place, const YkSourceCursor *cursor)
{
    size_t columns = 0, offset = cursor->offset, column = cursor->column;
    size_t past = (size_t)place.column + (place.length > 0 ? place.length : 1);
    Underline underline = {0, 0};
    if (column > 1) {
        yk_text_puts(text, "...");
        columns = 3;
    }
    for (; offset < cursor->line_end && columns < WINDOW; column++) {
        if (column == place.column) underline.first = columns;
        offset += show_one(text, problems->source + offset, cursor->line_end - offset, &columns);
        if (column < past) underline.end = columns;
    }
    if (column <= place.column) underline.first = columns; // the place is past the line's end
    if (offset < cursor->line_end) yk_text_puts(text, "...");
    return underline;
}

void yk_quote_source(YkText *text, const YkProblems *problems, YkPlace place, YkSourceCursor *cursor,
                     YkCaretColour colour)
{
    if (!problems->source || !seek_line(problems, place.line, cursor)) return;
    if (cursor->column == 1 && cursor->offset == cursor->line_end) return; // an empty line would show nothing
    seek_column(problems, place.column > FIT ? place.column - LEAD : 1, cursor);

    yk_text_repeat(text, ' ', INDENT);
    Underline underline = show_line(text, problems, place, cursor);
    yk_text_puts(text, "\n");
    yk_text_repeat(text, ' ', INDENT + underline.first);
    yk_text_format(text, "%s^", colour.on);
    if (underline.end > underline.first + 1) yk_text_repeat(text, '~', underline.end - underline.first - 1);
    yk_text_format(text, "%s\n", colour.off);
}
