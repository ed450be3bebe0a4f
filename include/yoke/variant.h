// Variants: one machine with other values of its parameters, again and again, without loading or compiling anew.
#ifndef YOKE_VARIANT_H
#define YOKE_VARIANT_H

#include <yoke/mechanism.h>

typedef struct YkVariant YkVariant;

// A copy of the mechanism whose numbers follow the parameters names[count] of its model; one per thread. States,
// batches and dynamics are made from yk_variant_mechanism; states and batches follow every yk_variant_set at once,
// dynamics (YkDynamics, simulations) are to be made after it. It has the inputs, blocks and branches of `mech` in the
// same order, which must outlive it. Points, directions of slides, masses, gravity, springs, dampers, stops and
// friction can follow; a parameter that enters gears, racks, belts, cams, laws or `turned` is refused, also one that
// enters their phase by `start:` or drives. NULL with problems added. Cost: of compiling.
YK_API YkVariant *yk_variant_new(const YkMechanism *mech, const char *const *names, size_t count, YkProblems *problems);
YK_API void yk_variant_free(YkVariant *variant);
YK_API const YkMechanism *yk_variant_mechanism(const YkVariant *variant);
// values[count], SI and radians. The same numbers, bit for bit, as from compiling the file with these values; where
// they make a place 0 or let places cancel, which compiling leaves out, to rounding. YK_OK, or YK_BAD_MODEL where the
// machine makes no sense with them (a value that is not finite, a mass that is not positive, a rod without length, a
// cam that its follower cannot touch). Cost: of the expressions that depend on the parameters; allocates nothing.
YK_API YkStatus yk_variant_set(YkVariant *variant, const double *values);
// The value of a parameter in the file, SI. NaN where there is none of this name.
YK_API double yk_model_parameter(const YkModel *model, const char *name);
// A value for a parameter, as --param takes it: units, other parameters, bare numbers in the file's units. YK_OK, or
// YK_BAD_ARGUMENT with a problem added.
YK_API YkStatus yk_model_parameter_read(const YkModel *model, const char *name, const char *text, double *value,
                                        YkProblems *problems);
// The size in SI of the unit in which the file gives it (0.001 for mm); 1 where there is none of this name.
YK_API double yk_model_parameter_unit(const YkModel *model, const char *name);

#endif
