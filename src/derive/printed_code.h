// The parts of generated code besides the formulas of a page.
#ifndef DERIVE_PRINTED_CODE_H
#define DERIVE_PRINTED_CODE_H
#include "derive/derive.h"
#include "ring/graph/element.h"

// Defines the symbols of bodies by the file's coordinates, and rates of springs' lengths. `derivation` is a
// YkDerivation (a YkPageDefine).
bool yk_derive_define_bodies(void *derivation, YkRingGraph *graph);
// M and h of Lagrange's equations in the coordinates of the file, [tree_count][tree_count] and [tree_count]. `forces`
// is a const YkDeriveForces (a YkPageBuild).
bool yk_derive_build_mass(void *forces, YkRingGraph *graph, YkRef *entries);
bool yk_derive_build_rest(void *forces, YkRingGraph *graph, YkRef *entries);

#endif
