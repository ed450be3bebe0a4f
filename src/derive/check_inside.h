// What the files of --check share.
#ifndef DERIVE_CHECK_INSIDE_H
#define DERIVE_CHECK_INSIDE_H
#include "derive/check.h"

enum { YK_CHECK_POINTS = 4, YK_CHECK_POINTS_TRIED = 40 * YK_CHECK_POINTS };

typedef struct YkCheck {
    YkDerivation *d;
    YkState *state, *start;
    double start_margin;
    YkDynamics *dynamics;
    const YkEquation *equation;
    const YkForm *difference; // left - right
    const char *text;
    size_t length;
    double *values;
    uint64_t seed;
    YkFieldPoint *points[YK_CHECK_POINTS_TRIED]; // of the machine's motion, made at first use
    size_t point_count, points_tried, points_symbols;
} YkCheck;

// --- check_proof.c: over the prime field
typedef enum YkProof { YK_PROVED, YK_REFUTED, YK_NO_PROOF } YkProof;
YkProof yk_check_prove(YkCheck *check, const YkForm *zero); // is it 0 on the machine, for all dimensions?
void yk_check_free_points(YkCheck *check);

// --- check_poses.c: with the file's numbers
// Compares both sides at the start, then at random poses; stops at a pose that shows a difference, with the state
// there. poses: how many were compared.
bool yk_check_differs(YkCheck *check, size_t *poses);
// Is it true as long as the drives move the inputs? The state comes back as it was.
bool yk_check_holds_in_drive(YkCheck *check);
void yk_check_fill_values(YkCheck *check); // of the state

// --- check_slips.c: "with the other sign before `d3*cos(theta2)` it would be true", or NULL: what the hand that wrote
// a false equation may have meant, where that is true for all dimensions. In the derivation's arena.
const char *yk_check_slip(YkCheck *check);

#endif
