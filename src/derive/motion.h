// Velocities and accelerations: what the two sections share.
#ifndef DERIVE_MOTION_H
#define DERIVE_MOTION_H
#include "derive/blocks.h"

// J q'' = gamma, one row: gamma = - (d/dt J) q'.
const YkPoisson *yk_derive_gamma(YkDerivation *d, YkDeriveRow *row);
// Writes all blocks in order: their unknowns, then the rates of bodies that they settle; systems if not solved.
void yk_derive_put_solutions(YkDerivation *d, YkPage *page, bool accelerations);

#endif
