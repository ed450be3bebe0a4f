// The scale of an answer: what is rounding noise beside everything else that is told with it, and shown as 0 to people.
#ifndef CLI_SCALE_H
#define CLI_SCALE_H
#include <yoke/yoke.h>

typedef struct YkSession YkSession;

// Largest values, in SI; those of lengths' rates are divided by the machine's size. 0: not known yet, and nothing of
// the kind is taken for noise. Lengths are judged by the machine's size, angles by a radian.
typedef struct YkScale {
    double rate, acceleration, force, energy;
    double mass;   // of all bodies: what accelerations that are noise make of forces is noise
    bool is_exact; // no loops: angles and their rates are sums and products of the inputs', so that small ones are true
} YkScale;

// Begins a scale for the session's machine.
void yk_scale_begin(YkSession *session);
// Takes in a pose with its rates, and its forces where session->dynamics has them.
void yk_scale_add_pose(YkSession *session, const YkState *state);
// The same of bodies and points alone: of a state that belongs to another compilation of the model.
void yk_scale_add_bodies(YkSession *session, const YkState *state);
// Takes in a value of a table.
void yk_scale_add(YkSession *session, double value, YkQuantity quantity);
// How large a value may be and still be noise; 0: none is.
double yk_scale_noise(const YkSession *session, YkQuantity quantity);
// The same of kinetic energy, a sum of squares, which is exact however small: only what noise in the rates makes of it.
double yk_scale_kinetic_noise(const YkSession *session);

#endif
