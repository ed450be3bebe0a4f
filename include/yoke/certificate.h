// The certificate of a motion: a proof that a machine stays on its configuration between the poses that were solved.
//
// Dyads are solved in closed form, and every motion knows when they come to a change point. Larger groups are solved by
// Newton's method from the pose before, which by itself could come to another solution. A certifier proves that it did
// not: between two poses Krawczyk's operator, rounded outward, shows that everything up to the last group has
// exactly one solution in a tube about the way, and that both poses are in it. docs/configurations.md has the
// mathematics.
#ifndef YOKE_CERTIFICATE_H
#define YOKE_CERTIFICATE_H

#include <yoke/state.h>

#ifdef __cplusplus
extern "C" {
#endif

// Proves the motions of a state. Use one per state; the mechanism must outlive it. yk_certifier_new returns NULL when
// out of memory.
typedef struct YkCertifier YkCertifier;
YK_API YkCertifier *yk_certifier_new(const YkMechanism *mech);
YK_API void yk_certifier_free(YkCertifier *certifier);
// Lets a certifier watch all moves and sweeps of a state from now on. NULL ends this; the certifier may then be freed.
// A copy of the state is not watched. Returns YK_OK, or YK_BAD_ARGUMENT for the certifier of another machine.
// Cost at every verified pose: some n^3 multiplications for each of three steps, for n unknowns; none without groups.
YK_API YkStatus yk_state_set_certifier(YkState *state, YkCertifier *certifier);

typedef struct YkMotionCertificate {
    bool is_needed;       // the machine has groups
    bool is_certified;    // every step is proved, or there is nothing to prove: no group
    bool is_refuted;      // some step is proved to have gone to another solution
    size_t steps, proved; // between poses
    int input;            // the input that moved most on the first step that is not proved; -1: there is none
    double from, to;      // its values before and after that step
    char message[200];    // one sentence
    // About the first step that is not proved; the names live as long as the certifier:
    const char *why;           // a clause, or "" if all is proved
    const char *joint;         // of the group, or of the dyad before it, that is not proved; "": not known, or all are
    const char *coordinate;    // the name of `input`: a simulation may have other inputs than the machine it began with
    double from_time, to_time; // equal if the motion is not one through time, s
    bool has_run_out;          // of memory, on the way: nothing is proved
} YkMotionCertificate;
// Returns what is proved of the motions so far. Between two verified poses, which in sweeps and moves are at most
// turn_max apart, all inputs are taken to change linearly. Over time, if that is too far from cubics through their
// positions and rates at both poses, they follow chords of these. A move that goes round a limit is proved along the
// way that it found; ways that it tried in vain do not count. Changes between two motions (yk_state_solve,
// yk_state_assemble, other values of a variant) are not proved.
YK_API YkMotionCertificate yk_certifier_report(const YkCertifier *certifier);

#ifdef __cplusplus
}
#endif

#endif
