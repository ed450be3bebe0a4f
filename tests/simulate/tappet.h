// A cam that lifts a tappet of 0.3 kg by h (1 - cos theta)/2, for tests of what leaves it.
#ifndef TESTS_SIMULATE_TAPPET_H
#define TESTS_SIMULATE_TAPPET_H
#include "run.h"

// cam: further keys of the cam; shaft: those of the shaft; rest: drives, springs and the like.
static inline Run run_of_tappet(const char *cam, const char *shaft, const char *rest, double tolerance)
{
    char text[1200];
    snprintf(text, sizeof text,
             "gravity: [0, -9.81]\n"
             "laws:\n"
             "  lift: {period: 360 deg, segments: [{formula: {to: 360 deg, s: 12 mm*(1 - cos(x))/2}}]}\n"
             "cams:\n"
             "  heart: {cam: shaft, follower: tappet, law: lift, roller: 6 mm, base: 30 mm%s}\n"
             "bodies: {shaft: {%s}, tappet: {mass: 0.3 kg}}\n"
             "joints:\n"
             "  K: {pin: [ground, shaft], angle: theta}\n"
             "  T: {slide: [ground, tappet], along: y, distance: s}\n"
             "%s",
             cam, shaft, rest);
    return run_of_text(text, run_options(tolerance));
}

#endif
