// Relations from the model's gears, racks, belts and cams.
#ifndef COMPILE_RELATIONS_H
#define COMPILE_RELATIONS_H
#include "compile/mechanism.h"

// Fills mech->relations (after the tree and its coordinates). The phase of a gear follows from `start:` and drives if
// they give all the coordinates that it ties; otherwise the teeth that meet are those that meet when all coordinates
// are 0. Returns false when out of memory.
bool yk_relations_build(YkMechanism *mech);
// Computes the constants of the relations, constants[mech->relation_count], from the model's present values: a phase
// depends on what `start:` and drives give. Returns false when out of memory.
bool yk_relations_constants(const YkMechanism *mech, double *constants);
// Adds a term to the sum that runs from mech->relation_terms[first] to the last. Returns false when out of memory.
bool yk_relation_add_term(YkMechanism *mech, size_t first, YkRelationTerm term);

#endif
