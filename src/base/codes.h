// Every message has a code. codes.def holds them all: X(NAME, number, severity, "what it means and what to do").
#ifndef BASE_CODES_H
#define BASE_CODES_H
#include <yoke/problem.h>

typedef enum YkCode {
#define X(name, number, severity, explanation) YK_CODE_##name = number,
#include "base/codes.def"
#undef X
    YK_CODE_NONE = 0
} YkCode;

YkSeverity yk_code_severity(int code); // YK_SEVERITY_ERROR if there is no such code
#endif
