// The scale of an answer: what is rounding noise beside everything else in it, and is shown to people as 0.
#ifndef CLI_SCALE_H
#define CLI_SCALE_H
#include <yoke/yoke.h>

typedef struct YkSession YkSession;

// Largest values, in SI; rates of lengths are divided by the machine's size. 0: not known yet, so that nothing of the
// kind counts as noise. Lengths are compared with the machine's size, angles with a radian.
typedef struct YkScale {
    double rate, acceleration, force, energy;
    double blur;   // how many times as large noise is in what is being written; 0: as large as usual
    double mass;   // of all bodies: forces from accelerations that are noise are noise
    double own;    // acceleration that the loads of the bodies of a row could give them; 0: of no body
    bool is_exact; // no loops: angles and their rates are sums and products of the inputs', so small ones are real
} YkScale;

// The blur at a change point, where rates are limits made of poses beside it.
#define YK_BLUR_AT_CHANGE_POINT 1e4

// Begins a scale for the session's machine.
void yk_scale_begin(YkSession *session);
// Adds a pose with its rates, and its forces if session->dynamics has them.
void yk_scale_add_pose(YkSession *session, const YkState *state);
// Does the same for bodies and points only, for a state of another compilation of the model.
void yk_scale_add_bodies(YkSession *session, const YkState *state);
// Notes that what is written next is about these two bodies (0: none), whose large loads leave noise in their
// accelerations.
void yk_scale_of_bodies(YkSession *session, size_t one, size_t other);
// Adds the rates of the inputs alone.
void yk_scale_add_inputs(YkSession *session, const YkState *state);
// Adds a value of a table.
void yk_scale_add(YkSession *session, double value, YkQuantity quantity);
// Returns how large noise can be; 0: nothing is noise.
double yk_scale_noise(const YkSession *session, YkQuantity quantity);
// Does the same for kinetic energy, a sum of squares, which is exact however small: only noise in the rates counts.
double yk_scale_kinetic_noise(const YkSession *session);

#endif
