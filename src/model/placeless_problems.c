// Problems of values that have no place in the file: the message names the value instead.
#include "model/load.h"

void yk_load_pass_on(YkProblems *problems, const YkProblems *found, const char *value, const char *name)
{
    for (size_t i = 0; i < yk_problems_count(found); i++) {
        const YkProblem *problem = yk_problems_get(found, i);
        YkCode code = (YkCode)problem->code;
        if (name) {
            yk_problem(problems, code, (YkPlace){0}, "value %q for %q: %s", value, name, problem->message);
        } else {
            yk_problem(problems, code, (YkPlace){0}, "value %q: %s", value, problem->message);
        }
        if (problem->hint) yk_problem_hint(problems, "%s", problem->hint);
    }
}
