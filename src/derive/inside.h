// What the files of derive/ share and nobody outside needs.
#ifndef DERIVE_INSIDE_H
#define DERIVE_INSIDE_H
#include "derive/derive.h"

// symbols.c: the symbol that the file calls `name` (a parameter, a coordinate, its rate, t); -1 if there is none.
int32_t yk_derive_find(const YkDerivation *d, const char *name);
int32_t yk_derive_angle(YkDerivation *d, const char *name); // as yk_derive_symbol, an angle
// One more name for a symbol, first + second, where it is free and can be a name.
void yk_derive_also(YkDerivation *d, int32_t symbol, const char *first, const char *second);
// Other names, for equations and expressions: JOINT.angle of a coordinate, BODY.angle and BODY.rate of a body.
void yk_derive_enter_names(YkDerivation *d);
// Enters all symbols. false on failure.
bool yk_derive_enter_parameters(YkDerivation *d);
bool yk_derive_enter_coordinates(YkDerivation *d);
// expression.c: the size of a unit, exactly: a short decimal (mm), a power of pi times a fraction (deg, rpm), a
// fraction (km/h). angle: the power of angle in its dimension, for which powers of pi are looked for; 0: none.
const YkPoisson *yk_derive_unit_size(YkDerivation *d, double size, int angle);
// path.c: the body at which the branches of the tree to both bodies part.
int32_t yk_derive_common_body(const YkDerivation *d, int32_t a, int32_t b);
// bodies.c: the angle of a body's axes outside of cos and sin, joint form.
const YkPoisson *yk_derive_body_angle(YkDerivation *d, int32_t body);
bool yk_derive_enter_bodies(YkDerivation *d);
bool yk_derive_is_long(const YkDerivation *d); // so long that it has no joint form

#endif
