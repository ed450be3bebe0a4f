// Standard input as a text.
#ifndef CLI_DERIVE_INPUT_H
#define CLI_DERIVE_INPUT_H
#include <stddef.h>
#include <yoke/problem.h>

// Returns a text from malloc; NULL with a problem added.
char *yk_derive_read_input(size_t *length, YkProblems *problems);

#endif
