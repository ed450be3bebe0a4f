// The traced point of a machine of two loops, or of one with an input that turns two cranks: the second loop is a dyad
// of a link and an arm, which joins two points of the ground, input, coupler or output; the traced point lies on the
// link.
#ifndef SYNTHESIS_PATH_CHAIN_H
#define SYNTHESIS_PATH_CHAIN_H
#include "synthesis/paths/path_bar.h"

// The body that carries an end of the dyad.
typedef enum YkChainBody { YK_CHAIN_GROUND, YK_CHAIN_INPUT, YK_CHAIN_COUPLER, YK_CHAIN_OUTPUT } YkChainBody;

// The ways in which a kind of machine is built. Watt: the coupler and the output, or the coupler and the input, have
// three joints. Stephenson: the coupler and the ground (III), or the input and the output (I). Geared five-bar: the
// second crank turns `ratio` times as fast.
typedef struct YkChainVariant {
    YkChainBody link, arm; // where the dyad's link and arm begin
    int ratio;             // of a geared five-bar; otherwise 0
} YkChainVariant;
size_t yk_chain_variants(YkDesignKind kind); // 0 of a machine without a dyad
YkChainVariant yk_chain_variant(YkDesignKind kind, int variant);

// The rates of the angle of a direction, rad, by each dimension and, last, by the input.
enum { YK_CHAIN_RATES = YK_BAR_SIZE + 1 };

// A place with its derivatives.
typedef struct YkChainPlace {
    YkVec at, by[YK_CHAIN_RATES];
} YkChainPlace;
// A body's axes: an origin and a direction.
typedef struct YkChainFrame {
    YkChainPlace origin;
    YkVec along;
    double turn[YK_CHAIN_RATES];
} YkChainFrame;

// As yk_bar_point and yk_bar_frame, of machines with a dyad.
bool yk_chain_point(const YkBar *bar, double input, YkBarPoint *point);
bool yk_chain_frame(const YkBar *bar, double input, YkVec *origin, YkVec *along);
// Finds the places of the dyad's ends (link, arm) alone, m.
bool yk_chain_ends(const YkBar *bar, double input, YkVec end[2]);
// Finds the places of the dyad's ends (link, arm) and of their joint, m.
bool yk_chain_dyad(const YkBar *bar, double input, YkVec end[2], YkVec *joint);

#endif
