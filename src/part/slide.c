// The slide (prismatic joint): b moves along a line of a without turning.
//   Phi = n_a . (d_b - d_a) = 0 and phi_b - phi_a - turned = 0, two rows;  coordinate: the distance along the line.
#include "part/parts.h"

static const char *const keys[] = {"along", "from", "to", "turned", "distance", "friction", NULL};

const YkPart yk_part_slide = {.key = "slide", .turns = false, .slides = true, .keys = keys, .constraints = 2};
