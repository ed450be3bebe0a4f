// The pin (revolute joint): a point of b stays on a point of a; b is free to turn.
//   Phi = (p_a + R_a s_a) - (p_b + R_b s_b) = 0, two rows;  coordinate: the angle from a to b.
#include "part/parts.h"

static const char *const keys[] = {"at", "angle", "friction", NULL};

const YkPart yk_part_pin = {.key = "pin", .turns = true, .slides = false, .keys = keys, .constraints = 2};
