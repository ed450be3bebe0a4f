// Newton-Euler as a linear system.
#ifndef DERIVE_FORCES_NEWTON_EULER_H
#define DERIVE_FORCES_NEWTON_EULER_H
#include "derive/forces/free_bodies.h"

typedef struct YkDeriveSystem { // A xi = b
    const YkPoisson **zeros;    // [row_count] as shown; 0 on the machine
    const char **labels;
    int32_t *unknowns; // symbols
    size_t row_count, unknown_count;
} YkDeriveSystem;

// Makes the system. Rows: forces x and y and moments of every body, junctions, accelerations of what closes loops,
// without trivial pairs. Unknowns: reactions, efforts of drives, accelerations that are not given.
bool yk_derive_system(const YkDeriveForces *f, YkDeriveSystem *system);
// Finds only the unknowns and the number of rows.
bool yk_derive_system_size(const YkDeriveForces *f, YkDeriveSystem *system);
// Writes a row of A, [unknown_count]; returns that of b.
const YkPoisson *yk_derive_system_row(const YkDeriveForces *f, const YkDeriveSystem *system, size_t row,
                                      const YkPoisson **entries);

#endif
