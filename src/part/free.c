// The free joint: b moves and turns in the plane of a, and its point `to` has two coordinates there.
//   No Phi;  coordinates: x and y of the point in a's axes, from `from`, and the angle from a to b.
// The loader makes it of a slide and a pin in a slot with a carriage between them (model/free_joints.c).
#include "part/parts.h"

static const char *const keys[] = {"at", "from", "to", NULL};

const YkPart yk_part_free = {.key = "free", .turns = true, .slides = true, .keys = keys, .constraints = 0};
