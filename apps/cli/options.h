// Reads options; option_table.h lists them.
#ifndef CLI_OPTIONS_H
#define CLI_OPTIONS_H
#include "cli.h"

// Reads a command line, and adds all its errors to `problems`.
void yk_options_read(int argc, char **argv, YkRequest *request, YkProblems *problems);
void yk_request_free(YkRequest *request);

#endif
