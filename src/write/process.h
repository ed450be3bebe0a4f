// Other programs as filters: text in, text out, without a shell.
#ifndef WRITE_PROCESS_H
#define WRITE_PROCESS_H
#include <stdbool.h>
#include <stddef.h>
#include <yoke/problem.h>
#include "base/text.h"

// Runs argv[0], found on the PATH, with `input` as its standard input; adds what it writes to `output`. purpose names
// the step in messages ("drawing a plot"). Returns false with a problem added (E0710 if the program is missing, E0711
// with its own words if it fails, E0100 if memory ran out on the way). Input and output pass through unnamed files, so
// neither side can block.
bool yk_process_filter(const char *const *argv, const char *purpose, const YkText *input, YkText *output,
                       YkProblems *problems);

#endif
