// Problems: errors, warnings and notes about a model file or a request. A run can report many, each with its place.
#ifndef YOKE_PROBLEM_H
#define YOKE_PROBLEM_H

#include <stddef.h>
#include <stdint.h>
#include <yoke/status.h>

#ifdef __cplusplus
extern "C" {
#endif

// A place in the source text. Lines and columns count from 1; columns count Unicode code points. Line 0: no place.
typedef struct YkPlace {
    uint32_t line, column;
    uint32_t length; // number of columns that the caret underlines; 0 means 1
} YkPlace;

typedef enum YkSeverity { YK_SEVERITY_NOTE, YK_SEVERITY_WARNING, YK_SEVERITY_ERROR } YkSeverity;

typedef struct YkProblem {
    YkSeverity severity;
    int code; // 123 prints as E0123 and is explained by yk_code_explain(123)
    YkPlace place;
    const char *message; // one sentence without a final full stop; never contains control characters
    const char *hint;    // what to do about it, or NULL
    const char *where;   // for a machine made by calls (builder.h): "body `crank`, point `A`"; NULL: see `place`
} YkProblem;

typedef struct YkProblems YkProblems;

YK_API YkProblems *yk_problems_new(void); // NULL when out of memory
YK_API void yk_problems_free(YkProblems *problems);
YK_API size_t yk_problems_count(const YkProblems *problems);
YK_API size_t yk_problems_error_count(const YkProblems *problems);
YK_API const YkProblem *yk_problems_get(const YkProblems *problems, size_t index); // in order of their places
// Returns all problems as text: "file:line:col: error: message [E0123]", the source line, a caret line, "hint: ...".
// The string belongs to `problems` and is valid until the next call that uses them. colour: 1 adds ANSI colours.
YK_API const char *yk_problems_text(YkProblems *problems, int colour);
// Returns the paragraph that explains a code, or NULL for an unknown code. yk_code_at lists the codes in ascending
// order.
YK_API const char *yk_code_explain(int code);
YK_API size_t yk_code_count(void);
YK_API int yk_code_at(size_t index);

#ifdef __cplusplus
}
#endif

#endif
