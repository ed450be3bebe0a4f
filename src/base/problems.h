// The inside of YkProblems: how the rooms report problems.
#ifndef BASE_PROBLEMS_H
#define BASE_PROBLEMS_H
#include <stdarg.h>
#include <stdbool.h>
#include <yoke/problem.h>
#include "base/codes.h"
#include "base/text.h"

enum { YK_PROBLEMS_MAX = 200 }; // after these, one last problem says that more were found
// Names the source and keeps a copy of its text for quoting lines (text may be NULL).
void yk_problems_set_source(YkProblems *problems, const char *name, const char *text, size_t length);
// Names the program that problems without a place begin with, instead of the source (NULL: the source again).
void yk_problems_set_teller(YkProblems *problems, const char *name);
// Says in words of what a place in the source is; false if it does not know.
typedef bool (*YkNamePlace)(const char *source, size_t length, YkPlace place, YkText *words);
// From now on problems say so in `where`, until another source is set.
void yk_problems_name_places(YkProblems *problems, YkNamePlace name);
// Adds a problem; message takes the formats of yk_text_format. problems may be NULL (nothing is recorded). The code's
// entry in codes.def gives the severity. Adds E0100 in its place if there is no memory for the message.
void yk_problem(YkProblems *problems, YkCode code, YkPlace place, const char *message, ...);
// Adds that a long call was stopped (base/pace.h), unless a call within it has.
void yk_problem_stopped(YkProblems *problems);
// Adds a hint, formatted the same way, to the problem added last.
void yk_problem_hint(YkProblems *problems, const char *hint, ...);
// Adds what another list has, without its places; `about` (or NULL) stands before each message, in backquotes.
void yk_problems_pass_on(YkProblems *problems, const YkProblems *found, const char *about);
// Returns whether E0100 is among them, or there was no memory to print them.
bool yk_problems_ran_out(const YkProblems *problems);

#endif
