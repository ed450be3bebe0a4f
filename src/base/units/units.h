// Units and physical dimensions.
#ifndef BASE_UNITS_H
#define BASE_UNITS_H
#include <stdbool.h>
#include <stddef.h>
#include "base/text.h"

// Exponents of length, mass, time and angle. The angle's exponent serves only to convert bare numbers: two dimensions
// that differ only in it are equal, since a radian is a number.
typedef struct YkDimension {
    signed char length, mass, time, angle;
} YkDimension;

bool yk_dimension_equal(YkDimension a, YkDimension b);
YkDimension yk_dimension_times(YkDimension a, YkDimension b, int power); // a * b^power
const char *
yk_dimension_name(YkDimension dimension); // "a length", "a mass", "a torque or energy", "a number"; or "a quantity in
                                          // kg m^2 s^-1"; never NULL, static or built once from a table
// Reads a unit word: "mm", "kg*m^2", "rad/s", "N*s/m", "m/s^2", "rpm", "deg", "%". *size is its size in SI. Returns
// false when it is unknown; *bad and *bad_length then give the part that is not a unit.
bool yk_unit_read(const char *text, size_t length, double *size, YkDimension *dimension, const char **bad,
                  size_t *bad_length);
// Returns the nearest unit name for a hint, or NULL.
const char *yk_unit_nearest(const char *text, size_t length);

// The meaning of bare numbers in a file: `units: {length: mm, mass: kg, time: s, angle: deg, force: N}`.
typedef struct YkUnits {
    double length, mass, time, angle, force; // sizes in SI; force 0: derived from the others
    const char *length_name, *mass_name, *time_name, *angle_name,
        *force_name; // as written; force_name NULL when derived
} YkUnits;
YkUnits yk_units_si(void); // m, kg, s, rad, force derived (N)
// Returns the size in SI of a bare number of this dimension. If the file declares a force unit, mass^b time^c (b, c
// both nonzero) counts as force^b: a stiffness in mm, N is N/mm, a torque N*mm; an inertia stays kg*mm^2, a mass kg.
double yk_units_size(const YkUnits *units, YkDimension dimension);
// Adds the unit of a bare number of this dimension, as a file would write it: "N*mm", "kg*mm^2/s^2", "deg/s"; adds
// nothing for a plain number. If no unit of force is declared and the others make a newton, N is used: "N/m".
void yk_units_name(const YkUnits *units, YkDimension dimension, YkText *text);

#endif
