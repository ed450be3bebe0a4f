// The list of problems: ordered by place, limited in length, and never silently incomplete.
#include "base/problems.h"
#include <stdlib.h>
#include <string.h>
#include "base/escape.h"
#include "base/problem_list.h"

static const char ran_out[] = "out of memory";

YkProblems *yk_problems_new(void)
{
    YkProblems *problems = calloc(1, sizeof *problems);
    if (!problems) return NULL;
    problems->arena = yk_arena_new();
    if (!problems->arena) {
        free(problems);
        return NULL;
    }
    return problems;
}

void yk_problems_free(YkProblems *problems)
{
    if (!problems) return;
    yk_arena_free(problems->arena);
    free(problems->source_name);
    free(problems->source);
    free(problems->teller);
    yk_text_free(&problems->printed);
    free(problems);
}

// Returns a copy; NULL for no bytes, and when out of memory.
static char *copy_bytes(const char *data, size_t length)
{
    char *copy = data && data != yk_text_lost ? malloc(length + 1) : NULL;
    if (!copy) return NULL;
    if (length > 0) memcpy(copy, data, length);
    copy[length] = '\0';
    return copy;
}

void yk_problems_set_source(YkProblems *problems, const char *name, const char *text, size_t length)
{
    if (!problems) return;
    free(problems->source_name);
    free(problems->source);
    if (text && length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) { // a byte order mark does not count as a column
        text += 3;
        length -= 3;
    }
    problems->source_name = copy_bytes(name, name ? strlen(name) : 0);
    problems->source = copy_bytes(text, length);
    problems->source_length = problems->source ? length : 0;
    problems->name_place = NULL;
    if ((name && !problems->source_name) || (text && !problems->source))
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "%s", ran_out);
}

void yk_problems_set_teller(YkProblems *problems, const char *name)
{
    if (!problems) return;
    free(problems->teller);
    problems->teller = copy_bytes(name, name ? strlen(name) : 0);
    if (name && !problems->teller) yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "%s", ran_out);
}

// Formats into the arena and escapes control characters; NULL when out of memory.
static const char *format_message(YkArena *arena, const char *format, va_list arguments)
{
    YkText raw = {0}, safe = {0};
    yk_text_vformat(&raw, format, arguments);
    yk_escape(&safe, yk_text_get(&raw), raw.length);
    const char *message = NULL;
    if (!raw.failed && !safe.failed) message = yk_arena_copy(arena, yk_text_get(&safe), safe.length);
    yk_text_free(&raw);
    yk_text_free(&safe);
    return message;
}

void yk_problems_name_places(YkProblems *problems, YkNamePlace name)
{
    if (problems) problems->name_place = name;
}

// NULL if nothing more than the place itself is known, and when out of memory: the place is still printed.
static const char *name_place(YkProblems *problems, YkPlace place)
{
    YkText words = {0};
    const char *where = NULL;
    if (!problems->name_place || !problems->source || place.line == 0) return NULL;
    if (problems->name_place(problems->source, problems->source_length, place, &words) && !words.failed)
        where = yk_arena_copy(problems->arena, yk_text_get(&words), words.length);
    yk_text_free(&words);
    return where;
}

static bool is_before(YkPlace a, YkPlace b)
{
    return a.line != b.line ? a.line < b.line : a.column < b.column;
}

// Inserts by place; problems at the same place stay in order of arrival.
static void insert_in_order(YkProblems *problems, size_t index)
{
    size_t at = problems->count;
    const YkProblem *items = problems->items;
    for (; at > 0 && is_before(items[index].place, items[problems->order[at - 1]].place); at--)
        problems->order[at] = problems->order[at - 1];
    problems->order[at] = (uint16_t)index;
    problems->count++;
}

// Counts a problem that no longer fits. The last entry is as severe as the worst left out, so that no error is
// overlooked.
static void leave_out(YkProblems *problems, YkSeverity severity)
{
    YkProblem *more = &problems->items[YK_PROBLEMS_MAX];
    problems->last = NULL;
    if (problems->count == YK_PROBLEMS_MAX) {
        *more = (YkProblem){severity,
                            YK_CODE_MORE_PROBLEMS,
                            {0, 0, 0},
                            "there are more problems than these",
                            "correct the first ones and run again",
                            NULL};
        problems->order[problems->count++] = YK_PROBLEMS_MAX;
    }
    if (more->severity < severity) more->severity = severity;
}

// Turns a problem that could not be described into an error, whatever its severity: no answer beside it can be trusted.
static void run_out(YkProblem *problem)
{
    *problem = (YkProblem){YK_SEVERITY_ERROR, YK_CODE_OUT_OF_MEMORY, problem->place, ran_out, NULL, problem->where};
}

void yk_problem(YkProblems *problems, YkCode code, YkPlace place, const char *message, ...)
{
    if (!problems) return;
    YkSeverity severity = yk_code_severity((int)code);
    if (problems->count >= YK_PROBLEMS_MAX) {
        leave_out(problems, severity);
        return;
    }
    size_t index = problems->count;
    va_list arguments;
    va_start(arguments, message);
    const char *formatted = format_message(problems->arena, message, arguments);
    va_end(arguments);
    problems->items[index] = (YkProblem){severity, (int)code, place, formatted, NULL, name_place(problems, place)};
    if (!formatted) run_out(&problems->items[index]);
    problems->last = &problems->items[index];
    insert_in_order(problems, index);
}

void yk_problem_stopped(YkProblems *problems)
{
    for (size_t k = 0; problems && k < problems->count; k++)
        if (problems->items[k].code == YK_CODE_STOPPED) return;
    yk_problem(problems, YK_CODE_STOPPED, (YkPlace){0}, "stopped before it was done, as the caller asked");
}

void yk_problem_hint(YkProblems *problems, const char *hint, ...)
{
    if (!problems || !problems->last) return;
    va_list arguments;
    va_start(arguments, hint);
    problems->last->hint = format_message(problems->arena, hint, arguments);
    va_end(arguments);
    if (!problems->last->hint) run_out(problems->last);
}

void yk_problems_pass_on(YkProblems *problems, const YkProblems *found, const char *about)
{
    for (size_t i = 0; i < yk_problems_count(found); i++) {
        const YkProblem *problem = yk_problems_get(found, i);
        YkCode code = (YkCode)problem->code;
        if (about)
            yk_problem(problems, code, (YkPlace){0}, "%q: %s", about, problem->message);
        else
            yk_problem(problems, code, (YkPlace){0}, "%s", problem->message);
        if (problem->hint) yk_problem_hint(problems, "%s", problem->hint);
    }
}

size_t yk_problems_count(const YkProblems *problems)
{
    return problems ? problems->count : 0;
}

size_t yk_problems_error_count(const YkProblems *problems)
{
    size_t errors = 0;
    for (size_t i = 0; i < yk_problems_count(problems); i++) errors += problems->items[i].severity == YK_SEVERITY_ERROR;
    return errors;
}

const YkProblem *yk_problems_get(const YkProblems *problems, size_t index)
{
    return index < yk_problems_count(problems) ? &problems->items[problems->order[index]] : NULL;
}

bool yk_problems_ran_out(const YkProblems *problems)
{
    bool found = problems && problems->printed.failed;
    for (size_t i = 0; i < yk_problems_count(problems); i++) found |= problems->items[i].code == YK_CODE_OUT_OF_MEMORY;
    return found;
}
