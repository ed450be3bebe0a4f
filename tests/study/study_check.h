// Shared by the tests of studies: a machine with the channels and parameters of a study.
#ifndef TESTS_STUDY_CHECK_H
#define TESTS_STUDY_CHECK_H
#include "../solve/machine.h"

enum { NAMES_MAX = 8 };

// Assur's triad: a six-bar without a dyad; one link varies.
#define TRIAD                                                                                                          \
    "parameters: {l: 4.5, r: 3}\n"                                                                                     \
    "bodies:\n"                                                                                                        \
    "  ground: {points: {O2: [0, 0], O4: [4, 0], O6: [6, 2.5]}}\n"                                                     \
    "  crank: {points: {O2: [0, 0], A: [1, 0]}}\n"                                                                     \
    "  coupler: {points: {A: [0, 0], B: [3.5, 0], C: [2, 1.5]}}\n"                                                     \
    "  rocker: {points: {O4: [0, 0], B: [r, 0]}}\n"                                                                    \
    "  link: {points: {C: [0, 0], D: [l, 0]}}\n"                                                                       \
    "  output: {points: {O6: [0, 0], D: [2.5, 0]}}\n"                                                                  \
    "joints:\n"                                                                                                        \
    "  O6: {pin: [ground, output], angle: theta6}\n"                                                                   \
    "  D: {pin: [output, link], angle: theta5}\n"                                                                      \
    "  O2: {pin: [ground, crank], angle: theta2}\n"                                                                    \
    "  A: {pin: [crank, coupler], angle: theta3}\n"                                                                    \
    "  O4: {pin: [ground, rocker], angle: theta4}\n"                                                                   \
    "  B: {pin: [coupler, rocker]}\n"                                                                                  \
    "  C: {pin: [coupler, link]}\n"                                                                                    \
    "drives: {theta6: 120 deg + 0.1 rad/s * t}\n"                                                                      \
    "start: {theta2: 120 deg, theta3: -90 deg, theta4: 119 deg, theta5: -101 deg}\n"

// Gears drive a slider-crank: other teeth make another machine.
#define GEARED                                                                                                         \
    "parameters: {z1: 20, z2: 40, m: 2 mm, r: 20 mm, l: 80 mm}\n"                                                      \
    "bodies:\n"                                                                                                        \
    "  ground: {points: {O: [0, 0], P: [(z1 + z2)*m/2, 0]}}\n"                                                         \
    "  pinion: {points: {O: [0, 0]}}\n"                                                                                \
    "  wheel:  {points: {P: [0, 0], A: [r, 0]}, mass: 2 kg, inertia: 0.001 kg*m^2}\n"                                  \
    "  rod:    {points: {A: [0, 0], B: [l, 0]}}\n"                                                                     \
    "  piston: {points: {B: [0, 0]}, mass: 1 kg}\n"                                                                    \
    "joints:\n"                                                                                                        \
    "  O: {pin: [ground, pinion], angle: q}\n"                                                                         \
    "  P: {pin: [ground, wheel], angle: theta}\n"                                                                      \
    "  A: {pin: [wheel, rod], angle: phi}\n"                                                                           \
    "  B: {pin: [rod, piston]}\n"                                                                                      \
    "  S: {slide: [ground, piston], along: x, distance: x}\n"                                                          \
    "gears: {g: {mesh: [pinion, wheel], teeth: [z1, z2], module: m}}\n"                                                \
    "drives: {q: 10 rad/s * t}\n"                                                                                      \
    "start: {theta: 30 deg, phi: -20 deg, x: 150 mm}\n"

static inline YkStudy *study_of(const Machine *m, const char *const *parameters, size_t parameter_count,
                                const char *const *of, size_t count, size_t threads)
{
    YkChannel channels[NAMES_MAX];
    for (size_t c = 0; c < count; c++) channels[c] = machine_channel(m, of[c]);
    YkStudyOptions options = {parameters, parameter_count, channels, count, threads, NULL};
    YkStudy *study = yk_study_new(m->state, &options, m->problems);
    if (!study) print_error("%s", yk_problems_text(m->problems, 0));
    assert_non_null(study);
    return study;
}

#endif
