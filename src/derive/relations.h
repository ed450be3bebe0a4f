// Gears, belts, racks, cams, laws: relations between angles and distances.
#ifndef DERIVE_RELATIONS_H
#define DERIVE_RELATIONS_H
#include "derive/derive.h"

struct YkDeriveRelation {
    const char *name;
    YkRelationKind kind;
    const YkPoisson
        *value;    // joint form, 0 on the machine; NULL where it cannot be written (a cam whose angle is no coordinate)
    int32_t phase; // symbol of its constant; -1: none
    double phase_value;
    int32_t function; // first of the symbols s, s_v, s_a, s_j of a law; -1: none
    const YkLaw *law;
    int32_t argument; // coordinate
};

// Made at first use; NULL where there are none.
const YkDeriveRelation *yk_derive_ties(YkDerivation *d);

#endif
