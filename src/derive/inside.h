// Private functions that the files of derive/ share.
#ifndef DERIVE_INSIDE_H
#define DERIVE_INSIDE_H
#include "derive/derive.h"

// Finds the symbol that the file calls `name` (a parameter, a coordinate, its rate, t); -1 if there is none
// (symbols.c).
int32_t yk_derive_find(const YkDerivation *d, const char *name);
int32_t yk_derive_angle(YkDerivation *d, const char *name); // as yk_derive_symbol, an angle
// Enters other names, for equations and expressions: JOINT.angle of a coordinate, BODY.angle and BODY.rate of a body.
void yk_derive_enter_names(YkDerivation *d);
// Enters all symbols. Returns false on failure.
bool yk_derive_enter_parameters(YkDerivation *d);
bool yk_derive_enter_coordinates(YkDerivation *d);
// Returns the size of a unit, exactly: a short decimal (mm), a power of pi times a fraction (deg, rpm), a fraction
// (km/h). angle: the power of angle in its dimension, for which powers of pi are tried; 0: none (expression.c).
const YkPoisson *yk_derive_unit_size(YkDerivation *d, double size, int angle);
// Returns the angle of a body's axes outside cos and sin, joint form (bodies.c).
const YkPoisson *yk_derive_body_angle(YkDerivation *d, int32_t body);
// Adds a named constant (constants.c). Returns false when out of memory.
bool yk_derive_add_constant(YkDerivation *d, YkDeriveConstant constant);
bool yk_derive_enter_bodies(YkDerivation *d);
bool yk_derive_is_long(const YkDerivation *d); // so long that it has no joint form

#endif
