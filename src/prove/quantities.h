// Quantities that an equation can name besides the symbols of the machine.
#ifndef PROVE_QUANTITIES_H
#define PROVE_QUANTITIES_H
#include "derive/forces/free_bodies.h"

// Returns a quantity by name: T, V, kinetic, potential, energy, T_lever; positions lever.B.x and velocities
// lever.B.x'; efforts theta1.effort; reactions A.force.x, A.moment, F21x as -F12x. ' and .rate, .accel differentiate by
// time. In body form; NULL for an unknown name (quantities.c).
const YkPoisson *yk_derive_quantity(YkDerivation *d, const char *name);
// Takes ' and .rate, .accel from its end. Returns how often to differentiate by time.
int yk_derive_take_order(const char *name, size_t *length);
// Returns a force by name: theta1.effort, A.force.x, mesh.force.x, A.moment, shaking.x, F21x (as -F12x); NULL for an
// unknown name (quantities_forces.c).
const YkPoisson *yk_derive_force_quantity(const YkDeriveForces *f, const char *name);

#endif
