// Equilibria and small vibrations, in each format.
#ifndef CLI_REST_H
#define CLI_REST_H
#include "answer.h"

typedef struct YkRestAnswer {
    YkSession *session;
    YkRest *rest;
    const YkMechanism *mech; // that the search used: its coordinates are told
} YkRestAnswer;

const char *yk_stability_word(YkStability stability); // "stable", "unstable", "neutral"
// Of the undamped motion, Hz; NaN where the mode does not vibrate.
double yk_mode_hertz(YkMode mode);
void yk_rest_text(const YkRestAnswer *answer);
void yk_rest_json(const YkRestAnswer *answer);
void yk_rest_csv(const YkRestAnswer *answer);

#endif
