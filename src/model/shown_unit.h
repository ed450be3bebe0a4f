// The units in which people are shown quantities.
#ifndef MODEL_SHOWN_UNIT_H
#define MODEL_SHOWN_UNIT_H
#include <yoke/model.h>

// Returns the unit in which people are shown a quantity, and its size in SI: the file's own. If the file names no unit
// of force, and its units of length, mass and time would make an unusual one (kg*mm/s^2), forces are given in N, N*m
// and J; energies always in J, not in N*m. size may be NULL.
const char *yk_model_shown_unit(const YkModel *model, YkQuantity quantity, double *size);

#endif
