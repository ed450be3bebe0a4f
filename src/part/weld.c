// The weld: b is one with a.
//   Phi = (p_a + R_a s_a) - (p_b + R_b s_b) = 0 and phi_b - phi_a - turned = 0, three rows;  no coordinate.
#include "part/parts.h"

static const char *const keys[] = {"at", "turned", NULL};

const YkPart yk_part_weld = {.key = "weld", .turns = false, .slides = false, .keys = keys, .constraints = 3};
