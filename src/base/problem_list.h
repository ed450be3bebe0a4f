// The inside of YkProblems, shared by the list and its printing.
#ifndef BASE_PROBLEM_LIST_H
#define BASE_PROBLEM_LIST_H
#include <stdint.h>
#include "base/memory.h"
#include "base/problems.h"
#include "base/text.h"

struct YkProblems {
    YkProblem items[YK_PROBLEMS_MAX + 1]; // in the order of arrival; the one past the maximum says that there are more
    uint16_t order[YK_PROBLEMS_MAX + 1];  // their indices, ordered by place
    size_t count;
    YkProblem *last;            // the problem added last, NULL if it was left out
    YkArena *arena;             // messages and hints
    char *source_name, *source; // NULL when unknown
    char *teller;               // of problems without a place; NULL: the source
    size_t source_length;
    YkNamePlace name_place; // or NULL
    YkText printed;
};

// A position in the source that only moves forward, so that quoting all places of a file in order costs one pass.
typedef struct YkSourceCursor {
    size_t offset, line_end;
    uint32_t line, column;
} YkSourceCursor;
YkSourceCursor yk_source_start(const YkProblems *problems);

// The sequences that switch the caret's colour on and off; "" and "" for plain text.
typedef struct YkCaretColour {
    const char *on, *off;
} YkCaretColour;
// Adds the source line of `place` to `text`, cut to a window around it, and a line with the caret below. Adds nothing
// if the source is unknown, has no such line, or the line is empty.
void yk_quote_source(YkText *text, const YkProblems *problems, YkPlace place, YkSourceCursor *cursor,
                     YkCaretColour colour);

#endif
