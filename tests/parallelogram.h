// The joints of a parallelogram of the bodies ground, crank, coupler and rocker, for models that tests write as text.
#ifndef TESTS_PARALLELOGRAM_H
#define TESTS_PARALLELOGRAM_H

#define PARALLELOGRAM_JOINTS                                                                                           \
    "joints:\n"                                                                                                        \
    "  O2: {pin: [ground, crank], angle: theta2}\n"                                                                    \
    "  A: {pin: [crank, coupler], angle: theta3}\n"                                                                    \
    "  O4: {pin: [ground, rocker], angle: theta4}\n"                                                                   \
    "  B: {pin: [coupler, rocker]}\n"

#endif
