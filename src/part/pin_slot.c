// The pin in a slot: a point of b moves along a line of a; b is free to turn.
//   Phi = n_a . (d_b - d_a) = 0, one row;  coordinates: the angle from a to b and the distance along the slot.
#include "part/parts.h"

static const char *const keys[] = {"at", "from", "along", "angle", "distance", "friction", NULL};

const YkPart yk_part_pin_slot = {.key = "pin-slot", .turns = true, .slides = true, .keys = keys, .constraints = 1};
