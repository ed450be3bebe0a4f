// Variants: one machine with other values of its parameters, again and again, without loading or compiling anew.
#ifndef YOKE_VARIANT_H
#define YOKE_VARIANT_H

#include <yoke/mechanism.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkVariant YkVariant;

// Makes a copy of the mechanism whose numbers follow the parameters names[count] of its model. Use one per thread.
// States, batches and dynamics are made from yk_variant_mechanism, and follow every yk_variant_set
// at once (YkDynamics makes its equations anew at the next pose, and keeps the efforts and the choice of
// free inputs that were set); simulations must be made after it. The copy has the inputs, blocks and
// branches of `mech`, in the same order; `mech` must outlive it. Points, directions of slides, masses, gravity,
// springs, dampers, stops and friction can follow. A parameter is refused if it enters gears, racks, belts, cams, laws
// or `turned`, or their phase by `start:` or drives. Returns NULL with problems added. Cost: that of compiling.
YK_API YkVariant *yk_variant_new(const YkMechanism *mech, const char *const *names, size_t count, YkProblems *problems);
YK_API void yk_variant_free(YkVariant *variant);
YK_API const YkMechanism *yk_variant_mechanism(const YkVariant *variant);
// Sets values[count], SI and radians. The numbers are, bit for bit, those of compiling the file with these values;
// they agree to rounding where the values make a place 0 or let places cancel, which compiling leaves out. Returns
// YK_OK, or YK_BAD_MODEL if the values make no valid machine (a value that is not finite, a mass that is not positive,
// a rod without length, a cam that its follower cannot touch).
// Cost: the expressions that depend on the parameters; allocates nothing.
YK_API YkStatus yk_variant_set(YkVariant *variant, const double *values);

#ifdef __cplusplus
}
#endif

#endif
