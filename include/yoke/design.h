// Results for the designer that follow from kinematics: four-bars, strokes, time ratios.
#ifndef YOKE_DESIGN_H
#define YOKE_DESIGN_H

#include <yoke/sweep.h>

#ifdef __cplusplus
extern "C" {
#endif

// A four-bar inside the machine: four pins and four bodies in a ring.
typedef enum YkFourBarClass {
    YK_FOUR_BAR_CRANK_ROCKER,
    YK_FOUR_BAR_ROCKER_CRANK,
    YK_FOUR_BAR_DRAG_LINK,
    YK_FOUR_BAR_DOUBLE_ROCKER,
    YK_FOUR_BAR_CHANGE_POINT,
    YK_FOUR_BAR_TRIPLE_ROCKER
} YkFourBarClass;
typedef struct YkFourBar {
    size_t body[4];      // frame link, one neighbour (the input if one is driven), coupler, the other neighbour
    size_t joint[4];     // between body[k] and body[(k + 1) % 4]
    double length[4];    // m
    YkFourBarClass kind; // with body[0] as the frame and body[1] as the input
} YkFourBar;
// Finds the machine's four-bars whose frame link is the ground or, if there are none, any ring of four pins. Writes
// `capacity` of them at most. Returns their count, YK_NOT_FOUND when out of memory. The search ends after 2e7 steps,
// since bodies joined by very many pins have too many rings to list.
YK_API size_t yk_four_bars(const YkMechanism *mech, YkFourBar *four_bars, size_t capacity);
YK_API const char *yk_four_bar_name(YkFourBarClass kind); // "crank-rocker (Grashof)", ...

// One turn of an input: extremes of a channel and the time ratio of a quick-return mechanism.
typedef struct YkStroke {
    double low, high;       // extreme values of the channel
    double low_at, high_at; // input angles there, rad, to 1e-9
    double ratio;           // input angle of the slower stroke over the faster one, >= 1
} YkStroke;
// Sweeps the input once round from the state's pose, and leaves the state elsewhere. Returns YK_OK; YK_LIMIT if the
// input cannot turn through; YK_BAD_ARGUMENT if it does not turn at all (a distance),
// the channel does not have exactly two extremes, or the next turn is another.
YK_API YkStatus yk_stroke(YkState *state, size_t input, YkChannel channel, YkStroke *stroke);

#ifdef __cplusplus
}
#endif

#endif
