// Stands in for src/write/process.c where no other program can be started.
#include "write/process.h"
#include "base/problems.h"

bool yk_process_filter(const char *const *argv, const char *purpose, const YkText *input, YkText *output,
                       YkProblems *problems)
{
    (void)input, (void)output;
    yk_problem(problems, YK_CODE_PROGRAM_MISSING, (YkPlace){0}, "%s needs the program %q, which is not on the PATH",
               purpose, argv[0]);
    return false;
}
