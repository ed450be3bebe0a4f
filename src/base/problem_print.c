// Prints problems: "file:line:col: error: message [E0123]", then the quoted source and the hint.
#include <string.h>
#include "base/escape.h"
#include "base/problem_list.h"

typedef struct Colours {
    const char *bold, *severity[3], *caret, *off;
} Colours;

static const Colours plain = {"", {"", "", ""}, "", ""};
static const Colours ansi = {"\033[1m", {"\033[1;36m", "\033[1;35m", "\033[1;31m"}, "\033[1;32m", "\033[0m"};

// Prints what it is about, or "file:line:col: " as far as it is known.
static void print_place(YkText *text, const YkProblems *problems, const YkProblem *problem)
{
    YkPlace place = problem->place;
    const char *name = place.line == 0 && problems->teller ? problems->teller : problems->source_name;
    if (problem->where) {
        yk_text_format(text, "%s: ", problem->where);
        return;
    }
    if (name) yk_escape(text, name, strlen(name));
    if (name && place.line > 0) yk_text_format(text, ":%u:%u", place.line, place.column);
    if (!name && place.line > 0) yk_text_format(text, "line %u, column %u", place.line, place.column);
    if (name || place.line > 0) yk_text_puts(text, ": ");
}

static void print_code(YkText *text, const YkProblem *problem)
{
    if (problem->code == YK_CODE_NONE) return;
    yk_text_format(text, " [%c", "NWE"[problem->severity]);
    for (int power = 1000; power > 1 && problem->code < power; power /= 10) yk_text_puts(text, "0");
    yk_text_format(text, "%d]", problem->code);
}

static void print_problem(YkText *text, const YkProblems *problems, const YkProblem *problem, const Colours *colours,
                          YkSourceCursor *cursor)
{
    static const char *const words[] = {"note: ", "warning: ", "error: "};
    yk_text_puts(text, colours->bold);
    print_place(text, problems, problem);
    yk_text_format(text, "%s%s%s%s%s%s%s", colours->off, colours->severity[problem->severity], words[problem->severity],
                   colours->off, colours->bold, problem->message, colours->off);
    print_code(text, problem);
    yk_text_puts(text, "\n");
    if (problem->place.line > 0)
        yk_quote_source(text, problems, problem->place, cursor, (YkCaretColour){colours->caret, colours->off});
    if (problem->hint) yk_text_format(text, "%shint:%s %s\n", colours->bold, colours->off, problem->hint);
}

const char *yk_problems_text(YkProblems *problems, int colour)
{
    if (!problems) return "";
    YkText *text = &problems->printed;
    YkSourceCursor cursor = yk_source_start(problems);
    if (text->failed)
        yk_text_free(text); // a shorter message may still fit in memory
    else
        yk_text_clear(text);
    for (size_t i = 0; i < problems->count; i++)
        print_problem(text, problems, yk_problems_get(problems, i), colour ? &ansi : &plain, &cursor);
    return text->failed ? "error: out of memory while printing the problems [E0100]\n" : yk_text_get(text);
}
