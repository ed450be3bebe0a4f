// Quantities that an equation may name besides the symbols of the machine.
#ifndef PROVE_QUANTITIES_H
#define PROVE_QUANTITIES_H
#include "derive/forces/free_bodies.h"

// quantities.c: what an equation may speak of besides symbols: T, V, kinetic, potential, energy, T_lever; positions
// lever.B.x and velocities lever.B.x'; efforts theta1.effort; reactions A.force.x, A.moment, F21x as -F12x. ' and
// .rate, .accel take derivatives by time. In body form; NULL if there is no such thing.
const YkPoisson *yk_derive_quantity(YkDerivation *d, const char *name);
// Takes ' and .rate, .accel from its end: how often to differentiate by time.
int yk_derive_take_order(const char *name, size_t *length);
// quantities_forces.c: what an equation calls theta1.effort, A.force.x, mesh.force.x, A.moment, shaking.x, F21x (as
// -F12x); NULL if there is no such thing.
const YkPoisson *yk_derive_force_quantity(const YkDeriveForces *f, const char *name);

#endif
