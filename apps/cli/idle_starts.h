// Entries of `start:` that do nothing.
#ifndef CLI_IDLE_STARTS_H
#define CLI_IDLE_STARTS_H
#include "cli.h"

// Warns of every driven coordinate to which `start:` gives another value, or another rate, than its drive has at t = 0.
void yk_warn_of_idle_starts(YkSession *session);

#endif
