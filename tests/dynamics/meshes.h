// Machines with gears, racks, belts and cams.
#ifndef TESTS_DYNAMICS_MESHES_H
#define TESTS_DYNAMICS_MESHES_H

#define GEARED_FIVE_BAR                                                                                                \
    "gravity: [0, -9.81]\nbodies:\n"                                                                                   \
    "  ground: {points: {A: [0, 0], E: [0.3, 0]}}\n"                                                                   \
    "  w1: {points: {A: [0, 0], B: [0.1, 0]}, mass: 1, center: [0.02, 0], inertia: 0.01}\n"                            \
    "  w2: {points: {E: [0, 0], D: [0.12, 0]}, mass: 1.5, center: [0.01, 0], inertia: 0.012}\n"                        \
    "  b: {points: {B: [0, 0], C: [0.35, 0]}, mass: 0.7, rod: [B, C]}\n"                                               \
    "  d: {points: {D: [0, 0], C: [0.3, 0]}, mass: 0.6, rod: [D, C]}\n"                                                \
    "joints:\n  A: {pin: [ground, w1], angle: t1}\n  E: {pin: [ground, w2], angle: t2}\n"                              \
    "  B: {pin: [w1, b], angle: t3}\n  D: {pin: [w2, d], angle: t4}\n  C: {pin: [b, d]}\n"                             \
    "gears: {g: {mesh: [w1, w2], teeth: [20, 40]}}\n"                                                                  \
    "start: {t1: 60 deg, t2: 100 deg, t3: 0, t4: 0, t1.rate: 3}\n"

#define RACK                                                                                                           \
    "gravity: [0, -9.81]\nbodies:\n  ground: {points: {A: [0, 0], R: [0, -0.05]}}\n"                                   \
    "  p: {points: {A: [0, 0]}, mass: 2, inertia: 0.003, center: [0.01, 0]}\n  bar: {points: {R: [0, 0]}, mass: 1}\n"  \
    "joints:\n  A: {pin: [ground, p], angle: q}\n  S: {slide: [ground, bar], along: x, from: R, distance: s}\n"        \
    "racks: {r: {pinion: p, rack: bar, radius: 50 mm}}\nstart: {q: 1, q.rate: 2}\n"

// The same, with the slide written from the rack to the ground: its line is the rack's, its distance runs backwards.
#define RACK_BACKWARDS                                                                                                 \
    "gravity: [0, -9.81]\nbodies:\n  ground: {points: {A: [0, 0], R: [0, -0.05]}}\n"                                   \
    "  p: {points: {A: [0, 0]}, mass: 2, inertia: 0.003, center: [0.01, 0]}\n  bar: {points: {R: [0, 0]}, mass: 1}\n"  \
    "joints:\n  A: {pin: [ground, p], angle: q}\n  S: {slide: [bar, ground], along: x, to: R, distance: s}\n"          \
    "racks: {r: {pinion: p, rack: bar, radius: 50 mm}}\nstart: {q: 1, q.rate: 2}\n"

#define CAM_PARTS                                                                                                      \
    "gravity: [0, -9.81]\nbodies:\n  ground: {points: {K: [0, 0], P: [0.1, 0.2]}}\n"                                   \
    "  shaft: {points: {K: [0, 0]}, mass: 1, inertia: 0.002}\n  tappet: {points: {T: [0, 0]}, mass: 0.2}\n"            \
    "  rod: {points: {T: [0, 0], Q: [0.16, 0]}, mass: 0.1, rod: [T, Q]}\n"                                             \
    "  lever: {points: {P: [0, 0], Q: [0.1, 0]}, mass: 0.1, rod: [P, Q]}\n"                                            \
    "joints:\n  K: {pin: [ground, shaft], angle: th}\n  G: {slide: [ground, tappet], along: y, distance: s}\n"         \
    "  T: {pin: [tappet, rod], angle: b}\n  P: {pin: [ground, lever], angle: c}\n  Q: {pin: [rod, lever]}\n"
#define CAM                                                                                                            \
    "laws:\n  lift: {period: 2*pi, segments: [{rise: {to: 120 deg, by: 20 mm, law: cycloidal}}, "                      \
    "{fall: {to: 240 deg, by: 20 mm, law: cycloidal}}, {dwell: {to: 2*pi}}]}\n" CAM_PARTS                              \
    "cams: {valve: {cam: shaft, follower: tappet, law: lift, roller: 10 mm, base: 30 mm, offset: 5 mm}}\n"             \
    "start: {th: 40 deg, b: 60 deg, c: 170 deg, th.rate: 20}\n"

#define FLAT                                                                                                           \
    "laws:\n  lift: {period: 2*pi, segments: [{rise: {to: 120 deg, by: 20 mm, law: cycloidal}}, "                      \
    "{fall: {to: 240 deg, by: 20 mm, law: cycloidal}}, {dwell: {to: 2*pi}}]}\n" CAM_PARTS                              \
    "cams: {valve: {cam: shaft, follower: tappet, law: lift, face: flat, base: 30 mm, offset: 5 mm}}\n"                \
    "start: {th: 40 deg, b: 60 deg, c: 170 deg, th.rate: 20}\n"

#define FOLLOW                                                                                                         \
    "laws:\n  lift: {period: 2*pi, segments: [{rise: {to: 120 deg, by: 20 mm, law: cycloidal}}, "                      \
    "{fall: {to: 240 deg, by: 20 mm, law: cycloidal}}, {dwell: {to: 2*pi}}]}\n" CAM_PARTS                              \
    "drives: {s: {law: lift, of: th}}\nstart: {th: 40 deg, b: 60 deg, c: 170 deg, th.rate: 20}\n"

#define PLANETARY_LINKAGE                                                                                              \
    "gravity: [0, -9.81]\nbodies:\n  ground: {points: {O: [0, 0], E: [0.35, 0.05]}}\n"                                 \
    "  sun: {points: {O: [0, 0]}, mass: 1, inertia: 0.002}\n  arm: {points: {O: [0, 0], P: [0.1, 0]}, mass: 1, rod: "  \
    "[O, P]}\n"                                                                                                        \
    "  planet: {points: {P: [0, 0], Q: [0.05, 0]}, mass: 0.5, inertia: 0.001, center: [0.01, 0]}\n"                    \
    "  rod: {points: {Q: [0, 0], R: [0.3, 0]}, mass: 0.4, rod: [Q, R]}\n"                                              \
    "  rocker: {points: {E: [0, 0], R: [0.2, 0]}, mass: 0.3, rod: [E, R]}\n"                                           \
    "joints:\n  S: {pin: [ground, sun], at: O, angle: a}\n  C: {pin: [ground, arm], at: O, angle: c}\n"                \
    "  P: {pin: [arm, planet], angle: p}\n  Q: {pin: [planet, rod], angle: r}\n  E: {pin: [ground, rocker], angle: "   \
    "e}\n"                                                                                                             \
    "  R: {pin: [rod, rocker]}\ngears: {m: {mesh: [sun, planet], teeth: [20, 30], carrier: arm}}\n"                    \
    "start: {c: 30 deg, a: 10 deg, r: -20 deg, e: 120 deg, c.rate: 4, a.rate: -3}\n"

// The ring is held: both meshes are needed to find planet and arm.
#define PLANETARY_SET                                                                                                  \
    "gravity: [0, -9.81]\nparameters: {mod: 2 mm}\nbodies:\n  ground: {points: {O: [0, 0]}}\n"                         \
    "  sun: {points: {O: [0, 0]}, mass: 0.5, inertia: 0.0002}\n  arm: {points: {O: [0, 0], P: [0.027, 0]}, mass: "     \
    "0.2, inertia: 0.0003, center: [0.01, 0]}\n"                                                                       \
    "  planet: {points: {P: [0, 0]}, mass: 0.1, inertia: 0.00001}\n  ring: {points: {O: [0, 0]}, mass: 1}\n"           \
    "joints:\n  S: {pin: [ground, sun], at: O, angle: s}\n  C: {pin: [ground, arm], at: O, angle: c}\n"                \
    "  P: {pin: [arm, planet], angle: p}\n  R: {weld: [ground, ring], at: O}\n"                                        \
    "gears:\n  a: {mesh: [sun, planet], teeth: [20, 7], module: mod, carrier: arm}\n"                                  \
    "  b: {mesh: [planet, ring], teeth: [7, 34], module: mod, carrier: arm, internal: true}\n"                         \
    "efforts: {s: 0.3}\nstart: {s: 0, s.rate: 5}\n"

#define BELT                                                                                                           \
    "bodies:\n  ground: {points: {A: [0, 0], B: [1, 0]}}\n  p: {points: {A: [0, 0]}, mass: 1, inertia: 0.3}\n"         \
    "  q: {points: {B: [0, 0]}, mass: 1, inertia: 0.7}\njoints:\n  A: {pin: [ground, p], angle: x}\n"                  \
    "  B: {pin: [ground, q], angle: y}\nbelts: {b: {between: [p, q], radii: [0.1, 0.25], crossed: true}}\n"            \
    "efforts: {x: 2}\nstart: {x: 0}\n"

// Three planets share the load of a set whose axis moves; friction in their pins.
#define PLANETS_ON_PLATE                                                                                               \
    "gravity: [0, -9.81]\n"                                                                                            \
    "parameters: {Zs: 20, Zp: 16, mod: 2 mm, N: 3, m: 0.3 kg, r: mod*(Zs + Zp)/2}\n"                                   \
    "bodies:\n"                                                                                                        \
    "  ground: {points: {A: [0, 0]}}\n"                                                                                \
    "  plate: {points: {A: [0, 0], O: [0.3, 0.1]}, mass: 2, center: [0.1, 0], inertia: 0.05}\n"                        \
    "  sun: {mass: 0.5, inertia: 0.0002}\n"                                                                            \
    "  arm: {points: {O: [0, 0], P: [r, 0]}, mass: 0.2, inertia: 0.0003, center: [0.01, 0]}\n"                         \
    "  planet: {mass: m, inertia: 0.0001}\n"                                                                           \
    "  ring: {mass: 1, inertia: 0.004}\n"                                                                              \
    "joints:\n"                                                                                                        \
    "  A: {pin: [ground, plate], angle: a}\n"                                                                          \
    "  S: {pin: [plate, sun], at: O, angle: s}\n"                                                                      \
    "  C: {pin: [plate, arm], at: O, angle: c}\n"                                                                      \
    "  R: {pin: [plate, ring], at: O, angle: q}\n"                                                                     \
    "  P: {pin: [arm, planet], angle: p, friction: {viscous: 0.01}}\n"                                                 \
    "gears:\n"                                                                                                         \
    "  inner: {mesh: [sun, planet], teeth: [Zs, Zp], module: mod, planets: N, carrier: arm}\n"                         \
    "  outer: {mesh: [planet, ring], teeth: [Zp, Zs + 2*Zp], module: mod, internal: true, carrier: arm}\n"             \
    "efforts: {s: 0.3, q: -1}\n"                                                                                       \
    "start: {a: 0.2, s: 0, c: 0.4, a.rate: 2, s.rate: 5, c.rate: 3}\n"

// Two pairs of planets between sun and ring, their pins written either way.
#define PLANETS_IN_PAIRS                                                                                               \
    "gravity: [0, -9.81]\n"                                                                                            \
    "parameters: {r: 52 mm, m: 0.25 kg}\n"                                                                             \
    "bodies:\n"                                                                                                        \
    "  ground: {points: {O: [0, 0]}}\n"                                                                                \
    "  sun: {points: {O: [0, 0]}, mass: 0.5, inertia: 0.0002}\n"                                                       \
    "  arm: {points: {O: [0, 0], P: [36 mm, 0], Q: [30 mm, 32 mm]}, mass: 0.2, inertia: 0.0003}\n"                     \
    "  first: {mass: m, inertia: 0.0001}\n"                                                                            \
    "  second: {mass: 0.3, inertia: 0.00012}\n"                                                                        \
    "  ring: {points: {O: [0, 0]}}\n"                                                                                  \
    "joints:\n"                                                                                                        \
    "  S: {pin: [ground, sun], at: O, angle: s}\n"                                                                     \
    "  C: {pin: [ground, arm], at: O, angle: c}\n"                                                                     \
    "  P: {pin: [arm, first], angle: p}\n"                                                                             \
    "  Q: {pin: [second, arm], at: Q, angle: q}\n"                                                                     \
    "  R: {weld: [ground, ring], at: O}\n"                                                                             \
    "gears:\n"                                                                                                         \
    "  a: {mesh: [first, sun], teeth: [16, 20], planets: 2, carrier: arm}\n"                                           \
    "  b: {mesh: [first, second], teeth: [16, 17], carrier: arm}\n"                                                    \
    "  c: {mesh: [second, ring], teeth: [17, 60], internal: true, carrier: arm}\n"                                     \
    "efforts: {s: 0.3}\n"                                                                                              \
    "start: {s: 0, s.rate: 5}\n"

#endif
