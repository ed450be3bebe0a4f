// The coupler point of a four-bar or slider-crank as a function of its dimensions and its input, with derivatives.
#ifndef SYNTHESIS_PATH_BAR_H
#define SYNTHESIS_PATH_BAR_H
#include "synthesis/design.h"

// Dimensions: a fixed pivot (of the input, or of the output if the bar hangs there), ground length and direction,
// input, coupler, output, coupler point in the coupler's axes. Slider-crank: the ground length is the distance of the
// slider's line from the input pivot, to the left of its direction; the output is not used. Inverted slider-crank: the
// output is how far the output pivot lies to the left of the coupler's line; the coupler has no length. Machines with a
// dyad have more (path_chain.h): where it begins in the axes of its two bodies, C of its link and D of its arm, and its
// lengths; their coupler point lies on the link. Geared five-bar: CU is the phase of the second crank, rad; its length
// is the output's.
enum {
    YK_BAR_X,
    YK_BAR_Y,
    YK_BAR_GROUND,
    YK_BAR_TURN,
    YK_BAR_INPUT,
    YK_BAR_COUPLER,
    YK_BAR_OUTPUT,
    YK_BAR_PX,
    YK_BAR_PY,
    YK_BAR_PLAIN,
    YK_BAR_CU = YK_BAR_PLAIN,
    YK_BAR_CV,
    YK_BAR_DU,
    YK_BAR_DV,
    YK_BAR_LINK,
    YK_BAR_ARM,
    YK_BAR_SIZE
};
// Returns the number of dimensions of a kind: YK_BAR_PLAIN, or YK_BAR_SIZE of those with a dyad.
size_t yk_bar_size(YkDesignKind kind);
bool yk_bar_is_length(YkDesignKind kind, int index); // whether a dimension is the length of a link, or of the ground
bool yk_bar_has_loop(YkDesignKind kind);             // a four-bar is, or is part of, the machine

typedef struct YkBar {
    double v[YK_BAR_SIZE]; // m, rad
    YkDesignKind kind;
    int branch;        // +1: output ahead of the coupler (slider-crank: coupler points along the line); -1: otherwise
    bool hangs_at_end; // the pivot among the dimensions is the output's
    int bend, variant; // of a dyad: its branch, as that of coupler and output; how it is built
} YkBar;

// The coupler point at one input angle, m, with its derivatives.
typedef struct YkBarPoint {
    YkVec at, by[YK_BAR_SIZE], by_input;
    double coupler; // angle, rad
} YkBarPoint;

// Returns the fixed pivot of the input.
static inline YkVec yk_bar_pivot(const YkBar *bar)
{
    YkVec at = yk_vec(bar->v[YK_BAR_X], bar->v[YK_BAR_Y]);
    if (!bar->hangs_at_end) return at;
    return yk_sub(at, yk_scale(bar->v[YK_BAR_GROUND], yk_unit(bar->v[YK_BAR_TURN])));
}
// Finds the point at the input's absolute angle, rad. Returns false if the bar does not close. Cost: some 100 ns.
bool yk_bar_point(const YkBar *bar, double input, YkBarPoint *point);
// Finds the axes in which the coupler point is fixed: their origin as seen from the input pivot, and their direction.
bool yk_bar_frame(const YkBar *bar, double input, YkVec *origin, YkVec *along);
// Puts the bar as a design, with its angles at an input angle. Returns false if it does not close.
bool yk_bar_design(const YkBar *bar, double input, YkDesign *design);

#endif
