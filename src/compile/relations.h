// Relations from the model's gears, racks, belts and cams.
#ifndef COMPILE_RELATIONS_H
#define COMPILE_RELATIONS_H
#include "compile/mechanism.h"

// Fills mech->relations (after the tree and its coordinates). The phase of a gear: where `start:` and drives give all
// the coordinates that it ties, theirs; otherwise the teeth that meet when all coordinates are 0 meet. False when out
// of memory.
bool yk_relations_build(YkMechanism *mech);
// The constants of the relations, constants[mech->relation_count], as the model's values are now: a phase hangs on what
// `start:` and drives give. False when out of memory.
bool yk_relations_constants(const YkMechanism *mech, double *constants);
// Adds a term to the sum that begins at mech->relation_terms[first] and ends with the last. False when out of memory.
bool yk_relation_add_term(YkMechanism *mech, size_t first, YkRelationTerm term);

#endif
