// Amounts: quantities as people read them, in the file's own units.
#ifndef WRITE_AMOUNT_H
#define WRITE_AMOUNT_H
#include <yoke/mechanism.h>
#include "base/text.h"
#include "base/units/units.h"
#include "model/shown_unit.h"

// Returns the quantity that shows a dimension in the file's units; NUMBER if there is none.
YkQuantity yk_amount_quantity(YkDimension dimension);
// Returns a value in the unit in which the quantity is shown (yk_model_shown_unit).
double yk_amount_of(const YkModel *model, double value, YkQuantity quantity);
// Returns a value in that unit, with rounding noise (1e-13 of the machine's size) set to zero. mech may be NULL.
double yk_amount_in_unit(const YkModel *model, const YkMechanism *mech, double value, YkQuantity quantity);
// Adds "190.09 deg" for a value in that unit, to `digits` significant digits; angles in radians also in degrees.
void yk_amount_write_shown(YkText *text, const YkModel *model, double shown, YkQuantity quantity, int digits);

// Adds "2.96 to 3.49", "3 or more", "up to 5" or "any": numbers from low to high, either of which may be infinite.
void yk_amount_between(YkText *text, double low, double high, int digits);

#endif
