// The five examples of the format, as its description prints them.
#ifndef TESTS_MODEL_EXAMPLES_H
#define TESTS_MODEL_EXAMPLES_H

static const char quick_return[] = "name: Whitworth quick-return\n"
                                   "parameters: {a1: 1 m, a2: 1 m, l1: 3/4 m, l2: 7/4 m, l4: 2/3 m}\n"
                                   "bodies:\n"
                                   "  ground:  {points: {O1: [0, a1], O2: [0, 0], C0: [0, a1 + a2]}}\n"
                                   "  crank:   {points: {O1: [0, 0], A: [l1, 0]}}\n"
                                   "  lever:   {points: {O2: [0, 0], B: [l2, 0]}}\n"
                                   "  block:   {points: {A: [0, 0]}}\n"
                                   "  coupler: {points: {B: [0, 0], C: [l4, 0]}}\n"
                                   "  ram:     {points: {C: [0, 0]}}\n"
                                   "joints:\n"
                                   "  O1: {pin: [ground, crank], angle: theta1}\n"
                                   "  O2: {pin: [ground, lever], angle: theta2}\n"
                                   "  S:  {slide: [lever, block], along: x, distance: d3}\n"
                                   "  A:  {pin: [crank, block]}\n"
                                   "  B:  {pin: [lever, coupler], angle: theta4}\n"
                                   "  C:  {pin: [coupler, ram]}\n"
                                   "  R:  {slide: [ground, ram], along: x, from: C0, distance: d5}\n"
                                   "drives: {theta1: 30 deg - 0.5 rad/s * t}\n"
                                   "start:  {theta2: 60 deg, d3: 1.5 m, theta4: -20 deg, d5: 1.2 m}\n";

static const char toggle[] =
    "name: Toggle linkage\n"
    "parameters: {l1: 0.1, l2: 0.22, l3: 0.2, l4: 0.25, a0x: 0.25, a0y: 0.12, m1: 0.4, m2: 0.9, m3: 0.8, m4: 1.0, "
    "m5: 2.5, tau: 2, g: 9.81 m/s^2}\n"
    "gravity: [0, -g]\n"
    "bodies:\n"
    "  ground: {points: {O1: [0, 0], O2: [a0x, -a0y]}}\n"
    "  link1:  {points: {O1: [0, 0], A: [l1, 0]}, mass: m1, rod: [O1, A]}\n"
    "  link2:  {points: {A: [0, 0], J: [l2, 0]},  mass: m2, rod: [A, J]}\n"
    "  link3:  {points: {O2: [0, 0], J: [l3, 0]}, mass: m3, rod: [O2, J]}\n"
    "  link4:  {points: {J: [0, 0], B: [l4, 0]},  mass: m4, rod: [J, B]}\n"
    "  slider: {points: {B: [0, 0]}, mass: m5}\n"
    "joints:\n"
    "  O1:  {pin: [ground, link1], angle: theta1}\n"
    "  A:   {pin: [link1, link2], angle: theta2}\n"
    "  O2:  {pin: [ground, link3], angle: theta3}\n"
    "  J34: {pin: [link3, link4], at: J, angle: theta4}\n"
    "  J23: {pin: [link2, link3], at: J}\n"
    "  B:   {pin: [link4, slider]}\n"
    "  R:   {slide: [ground, slider], along: x, from: O2, distance: d5}\n"
    "efforts: {theta1: tau}\n"
    "start: {theta1: 70 deg, theta2: -60 deg, theta3: 120 deg, theta4: -150 deg, d5: 0.1, theta1.rate: 3 rad/s}\n";

static const char double_pendulum[] =
    "name: Planar double pendulum\n"
    "parameters: {l1: 0.5, l2: 0.5, lc1: 0.35, lc2: 0.3, m1: 0.5, m2: 0.4, I1: 0.025, I2: 0.02, tau1: 0.5, tau2: "
    "-0.2, g: 9.81}\n"
    "gravity: [0, -g]\n"
    "bodies:\n"
    "  ground: {points: {O: [0, 0]}}\n"
    "  link1:  {points: {O: [0, 0], A: [0, -l1]}, mass: m1, center: [0, -lc1], inertia: I1}\n"
    "  link2:  {points: {A: [0, 0], tip: [0, -l2]}, mass: m2, center: [0, -lc2], inertia: I2}\n"
    "joints:\n"
    "  O: {pin: [ground, link1], angle: theta1}\n"
    "  A: {pin: [link1, link2], angle: theta2}\n"
    "efforts: {theta1: tau1, theta2: tau2}\n"
    "start: {theta1: pi/3, theta2: pi/4, theta1.rate: 0.1, theta2.rate: -0.2}\n";

static const char epicyclic[] =
    "name: Epicyclic train with a moving ring\n"
    "parameters: {N1: 27, N2: 36, N3: 24, N4: 87, mod: 2 mm}\n"
    "bodies: {sun: {}, planet: {}, ring: {}, arm: {points: {P: [mod*(N1 + N2)/2, 0]}}}\n"
    "joints:\n"
    "  S: {pin: [ground, sun],  angle: theta1}\n"
    "  C: {pin: [ground, arm],  angle: thetaC}\n"
    "  R: {pin: [ground, ring], angle: theta4}\n"
    "  P: {pin: [arm, planet],  angle: theta2}\n"
    "gears:\n"
    "  sun-planet:  {mesh: [sun, planet],  teeth: [N1, N2], module: mod, pressure_angle: 20 deg, carrier: arm}\n"
    "  planet-ring: {mesh: [planet, ring], teeth: [N3, N4], module: mod, carrier: arm, internal: true}\n"
    "drives: {thetaC: 20 rpm * t, theta1: 40 rpm * t}\n";

static const char cam[] =
    "name: CEP cam, rise and fall as one polynomial\n"
    "laws:\n"
    "  lift:\n"
    "    period: 2*pi\n"
    "    segments:\n"
    "      - {polynomial: [{at: 0, s: 0, v: 0, a: 0}, {at: 2*pi/3, s: 20 cm}, {at: 4*pi/3, s: 0, v: 0, a: 0}]}\n"
    "      - {dwell: {to: 2*pi}}\n"
    "cams:\n"
    "  valve: {cam: shaft, follower: tappet, law: lift, roller: 10 mm, base: 60 mm, offset: 0 mm}\n"
    "bodies: {shaft: {}, tappet: {mass: 0.2 kg}}\n"
    "joints:\n"
    "  K: {pin: [ground, shaft], angle: theta}\n"
    "  T: {slide: [ground, tappet], along: y, distance: s}\n"
    "drives: {theta: 60 rpm * t}\n";

#endif
