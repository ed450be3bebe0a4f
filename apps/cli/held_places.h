// A warning about coordinates that a lock holds and the file does not place.
#ifndef CLI_HELD_PLACES_H
#define CLI_HELD_PLACES_H
#include "cli.h"

// Warns (W0618) of every coordinate that the engaged lock holds at 0 while the machine without it starts elsewhere.
void yk_warn_of_held_places(YkSession *session);

#endif
