// The uses of laws without a period, and how far the argument of one is outside its law's range.
#ifndef DYNAMICS_LAW_USES_H
#define DYNAMICS_LAW_USES_H
#include <yoke/laws.h>
#include "loads/loads.h"

typedef struct YkLawUse {
    YkLawLeft told;
    const YkLaw *law;
    int32_t drive;  // of the model, or YK_NONE
    int32_t follow; // likewise
    size_t item;    // of the loads
    size_t part;    // FORCE: 0 x, 1 y, 2 moment
} YkLawUse;

struct YkLawWatch {
    const YkModel *model;
    YkLawUse *uses;
    size_t count;
};

// Finds the argument of a use at a solved state; NaN if the law is not in use there. loads: of the state's mechanism,
// or NULL; then the laws of loads are not in use.
double yk_law_use_argument(const YkLawUse *use, const YkState *state, YkLoads *loads);
// Returns by how much an argument is outside the law's range, less what is rounding: above 0 if it is. NaN for NaN.
double yk_law_use_excess(const YkLawUse *use, double argument);

#endif
