// The coupler point of a four-bar or slider-crank as a function of its dimensions and its input, with derivatives.
#ifndef SYNTHESIS_PATH_BAR_H
#define SYNTHESIS_PATH_BAR_H
#include "synthesis/design.h"

// Dimensions: a fixed pivot (of the input, or of the output if the bar hangs there), ground length and direction, input,
// coupler, output, coupler point in the coupler's axes. Slider-crank: the ground length is the distance of the slider's
// line from the input pivot, to the left of its direction; it has no output.
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
    YK_BAR_SIZE
};

typedef struct YkBar {
    double v[YK_BAR_SIZE]; // m, rad
    YkDesignKind kind;
    int branch;        // +1: output ahead of the coupler (slider-crank: coupler points along the line); -1: otherwise
    bool hangs_at_end; // the pivot among the dimensions is the output's
} YkBar;

// The coupler point at one input angle, m, with its derivatives.
typedef struct YkBarPoint {
    YkVec at, by[YK_BAR_SIZE], by_input;
    double coupler; // angle, rad
} YkBarPoint;

// Returns the fixed pivot of the input.
YkVec yk_bar_pivot(const YkBar *bar);
// Finds the point at the input's absolute angle, rad. Returns false where the bar does not close. Cost: some 100 ns.
bool yk_bar_point(const YkBar *bar, double input, YkBarPoint *point);
// Finds the direction of the coupler as a unit vector alone.
bool yk_bar_coupler(const YkBar *bar, double input, YkVec *along);
// Puts the bar as a design, with its angles at an input angle. Returns false where it does not close.
bool yk_bar_design(const YkBar *bar, double input, YkDesign *design);

#endif
