// Lagrange's equations: what the files of the section share.
#ifndef DERIVE_FORCES_LAGRANGE_H
#define DERIVE_FORCES_LAGRANGE_H
#include "derive/forces/free_bodies.h"

// Returns the element with names for all polynomials in constants, which are entered.
const YkPoisson *yk_derive_lumped(const YkDeriveForces *f, const YkPoisson *a);
// Writes the definitions of the names, and the equations in them.
void yk_derive_put_lumps(const YkDeriveForces *f, YkPage *page, const YkDeriveLagrange *equations, size_t count);
// Writes Newton's and Euler's equations projected on the partial velocities, and whether they are Lagrange's, which
// is proved in the ring.
void yk_derive_put_projection(const YkDeriveForces *f, YkPage *page);
// Returns whether left - right + projected = 0, with the multipliers as joint forces, for a coordinate of the body
// form.
bool yk_derive_do_methods_agree(const YkDeriveForces *f, size_t coordinate);

#endif
