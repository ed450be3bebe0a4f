// What the files of the section of Lagrange's equations share.
#ifndef DERIVE_FORCES_LAGRANGE_H
#define DERIVE_FORCES_LAGRANGE_H
#include "derive/forces/free_bodies.h"

// The element with every polynomial in constants under a name, which is entered.
const YkPoisson *yk_derive_lumped(const YkDeriveForces *f, const YkPoisson *a);
// Definitions of the names, and the equations by them.
void yk_derive_put_lumps(const YkDeriveForces *f, YkPage *page, const YkDeriveLagrange *equations, size_t count);
// Newton's and Euler's equations projected on the partial velocities, and whether they are Lagrange's: proved in the
// ring.
void yk_derive_put_projection(const YkDeriveForces *f, YkPage *page);
// Is left - right + projected = 0, with the multipliers as joint forces, for a coordinate of the body form?
bool yk_derive_do_methods_agree(const YkDeriveForces *f, size_t coordinate);

#endif
