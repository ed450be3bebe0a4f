// The answer of `yoke rest`, in each format.
#ifndef CLI_REST_H
#define CLI_REST_H
#include "answer.h"
#include "laws_left.h"

typedef struct YkRestAnswer {
    YkSession *session;
    YkRest *rest;
    const YkMechanism *mech; // the one of the search, whose coordinates are written
    YkLawWatch *laws;        // that equilibria have left, each at its number
} YkRestAnswer;

// laws.c: looks at all equilibria. Returns false when out of memory.
bool yk_rest_watch_laws(YkRestAnswer *answer);

const char *yk_stability_word(YkStability stability); // "stable", "unstable", "neutral", "none"
// Returns the frequency of the undamped motion, Hz; NaN if the mode does not vibrate.
double yk_mode_hertz(YkMode mode);
// Adds the motions with damping and follower loads to the text; nothing if the modes are the whole motion.
void yk_rest_motions(const YkRestAnswer *answer, size_t index);
void yk_rest_text(const YkRestAnswer *answer);
void yk_rest_json(const YkRestAnswer *answer);
void yk_rest_csv(const YkRestAnswer *answer);

#endif
