// Gears, belts, racks, cams, laws: relations between angles and distances.
#ifndef DERIVE_RELATIONS_H
#define DERIVE_RELATIONS_H
#include "derive/derive.h"

enum { YK_TIE_ORDERS = 4 }; // a law and its derivatives by its angle

struct YkDeriveRelation {
    const char *name;
    YkRelationKind kind;
    const YkPoisson *value;  // joint form, 0 on the machine
    const YkPoisson *linear; // body form, without the function of a law
    int32_t phase;           // symbol of its constant; -1: none
    double phase_value;
    int32_t function; // first of the symbols s, s_v, s_a, s_j of a law; -1: none
    const YkLaw *law;
    const YkPoisson *argument; // body form: the angle or distance that is the law's argument; NULL: none
    int32_t variable;          // its symbol: a coordinate's, or one of its own
    bool is_own_variable;
    int32_t *B; // of one of its own: its derivatives by the tree's coordinates
};

// The relations, made at first use; NULL if there are none.
const YkDeriveRelation *yk_derive_ties(YkDerivation *d);
// Returns d(relation)/d(position) in body form, for a coordinate of the body form.
const YkPoisson *yk_derive_tie_slope(YkDerivation *d, const YkDeriveRelation *tie, int32_t position);
// Returns the relation's condition on accelerations: its second derivative in time, body form.
const YkPoisson *yk_derive_tie_acceleration(YkDerivation *d, const YkDeriveRelation *tie);

#endif
