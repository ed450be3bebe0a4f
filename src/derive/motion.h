// Velocities and accelerations: what the two sections share.
#ifndef DERIVE_MOTION_H
#define DERIVE_MOTION_H
#include "derive/blocks.h"

// J q'' = gamma, one row: gamma = - (d/dt J) q'.
const YkPoisson *yk_derive_gamma(YkDerivation *d, YkDeriveRow *row);
// Finds determinant * unknown = over[unknown], for rates or accelerations, from earlier ones. Returns false if the
// block is not solved.
bool yk_derive_solve_block(YkDerivation *d, const YkDeriveBlock *block, bool accelerations, const YkPoisson **over);
// Writes all blocks in order: their unknowns, then the rates of bodies that they settle; systems if not solved.
void yk_derive_put_solutions(YkDerivation *d, YkPage *page, bool accelerations);
void yk_derive_put_system(YkDerivation *d, YkPage *page, const YkDeriveBlock *block, bool accelerations);
// Returns determinant * (a body's rate or acceleration) if this block is the last that it needs; otherwise NULL.
const YkPoisson *yk_derive_body_over(YkDerivation *d, int32_t body, size_t block, const YkPoisson *const *over,
                                     bool accelerations);
void yk_derive_put_bodies(YkDerivation *d, YkPage *page, size_t block, const YkPoisson *const *over,
                          bool accelerations);

#endif
