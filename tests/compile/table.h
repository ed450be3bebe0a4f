// Machines whose freedom, inputs, blocks and loops are known by hand: the gallery, and texts that the gallery lacks.
#ifndef TESTS_COMPILE_TABLE_H
#define TESTS_COMPILE_TABLE_H

typedef struct Known {
    const char *source; // an example's name, or a text
    int gruebler, by_rank;
    int loops;
    const char *inputs;
    const char *blocks; // kinds and labels in order
} Known;

#define LINK(name, p, q, length) "  " name ": {points: {" p ": [0, 0], " q ": [" length ", 0]}}\n"

static const char wedges[] = "bodies: {ground: {}, wedge: {}, lifter: {}}\n"
                             "joints:\n"
                             "  base:  {slide: [ground, wedge], along: x, distance: d}\n"
                             "  face:  {slide: [wedge, lifter], along: 30 deg, distance: s}\n"
                             "  stand: {slide: [ground, lifter], along: y}\n"
                             "start: {d: 1}\n";
static const char four_cranks[] =
    "bodies:\n"
    "  ground: {points: {O1: [0, 0], O2: [1, 0], O3: [2, 0.5], O4: [3, -0.25]}}\n" LINK("c1", "O1", "A1", "0.4")
        LINK("c2", "O2", "A2", "0.4") LINK("c3", "O3", "A3", "0.4")
            LINK("c4", "O4", "A4", "0.4") "  rod: {points: {A1: [0, 0], A2: [1, 0], A3: [2, 0.5], A4: [3, -0.25]}}\n"
                                          "joints:\n"
                                          "  O1: {pin: [ground, c1], angle: t1}\n  O2: {pin: [ground, c2], angle: "
                                          "t2}\n  O3: {pin: [ground, c3], angle: t3}\n"
                                          "  O4: {pin: [ground, c4], angle: t4}\n  A1: {pin: [c1, rod], angle: phi}\n  "
                                          "A2: {pin: [rod, c2]}\n  A3: {pin: [rod, c3]}\n"
                                          "  A4: {pin: [rod, c4]}\n"
                                          "start: {t1: 40 deg, phi: -40 deg, t2: 40 deg, t3: 40 deg, t4: 40 deg}\n";
static const char tied_parallelogram[] = // a tie bar between the middles of both cranks
    "bodies:\n"
    "  ground: {points: {O: [0, 0], Q: [3, 0]}}\n"
    "  left:  {points: {O: [0, 0], M: [0.5, 0], A: [1, 0]}}\n"
    "  right: {points: {Q: [0, 0], N: [0.5, 0], B: [1, 0]}}\n" LINK("top", "A", "B", "3") LINK(
        "tie", "M", "N", "3") "joints:\n"
                              "  O: {pin: [ground, left], angle: theta}\n  Q: {pin: [ground, right], angle: psi}\n  A: "
                              "{pin: [left, top], angle: alpha}\n"
                              "  B: {pin: [top, right]}\n  M: {pin: [left, tie], angle: mu}\n  N: {pin: [tie, right]}\n"
                              "drives: {theta: 70 deg}\n"
                              "start: {psi: 70 deg, alpha: -70 deg, mu: -70 deg}\n";
static const char cardan[] = // a trammel whose bar also turns on a crank of half its length
    "bodies:\n  ground: {}\n  h: {points: {A: [0, 0]}}\n  v: {points: {B: [0, 0]}}\n  bar: {points: {A: [-1, 0], M: "
    "[0, 0], B: [1, 0]}}\n"
    "  crank: {points: {M: [1, 0]}}\n"
    "joints:\n"
    "  O: {pin: [ground, crank], angle: theta}\n"
    "  M: {pin: [crank, bar], angle: beta}\n"
    "  H: {slide: [ground, h], along: x, distance: x}\n"
    "  V: {slide: [ground, v], along: y, distance: y}\n"
    "  A: {pin: [h, bar]}\n"
    "  B: {pin: [v, bar]}\n"
    "start: {theta: 50 deg, beta: -100 deg, x: 1.3, y: 1.5}\n";
static const char braced_square[] = // with both diagonals: rigid, and one member too many
    "bodies:\n"
    "  ground: {points: {A: [0, 0], B: [2, 0]}}\n"
    "  l: {points: {A: [0, 0], D: [0, 2]}}\n  r: {points: {B: [0, 0], C: [0, 2]}}\n  t: {points: {D: [0, 0], C: [2, "
    "0]}}\n"
    "  p: {points: {A: [0, 0], C: [2, 2]}}\n  q: {points: {B: [0, 0], D: [-2, 2]}}\n"
    "joints:\n"
    "  Al: {pin: [ground, l], at: A}\n  Br: {pin: [ground, r], at: B}\n  Dt: {pin: [l, t], at: D}\n  Ct: {pin: [t, r], "
    "at: C}\n"
    "  Ap: {pin: [ground, p], at: A}\n  Cp: {pin: [p, r], at: C}\n  Bq: {pin: [ground, q], at: B}\n  Dq: {pin: [q, l], "
    "at: D}\n";
static const char triangle[] = // statically determinate: no freedom, nothing redundant
    "bodies:\n"
    "  ground: {points: {A: [0, 0], B: [2, 0]}}\n" LINK("a", "A", "C", "1.5") LINK(
        "b", "B", "C",
        "1.2") "joints: {A: {pin: [ground, a], angle: alpha}, B: {pin: [ground, b], angle: beta}, C: {pin: [a, b]}}\n"
               "start: {alpha: 45 deg, beta: 120 deg}\n";
static const char post[] = "bodies: {ground: {points: {P: [1, 0]}}, post: {points: {P: [0, 0]}}}\n"
                           "joints: {P: {weld: [ground, post], turned: 30 deg}}\n";
static const char arm[] = "bodies: {upper: {points: {S: [0, 0], E: [1, 0]}}, fore: {points: {E: [0, 0], W: [1, 0]}}, "
                          "hand: {points: {W: [0, 0], T: [0.2, 0]}}, ground: {points: {S: [0, 0]}}}\n"
                          "joints: {S: {pin: [ground, upper], angle: a}, E: {pin: [upper, fore], angle: b}, W: {pin: "
                          "[fore, hand], angle: c}}\n"
                          "drives: {c: 3, a: 1, b: 2}\n";
static const char floating_drive[] = // the motor sits between crank and coupler
    "bodies:\n"
    "  ground: {points: {O: [0, 0], Q: [4, 0]}}\n" LINK("crank", "O", "A", "1") LINK("coupler", "A", "B", "3.5") LINK(
        "rocker", "Q", "B", "3") "joints: {O: {pin: [ground, crank], angle: t2}, A: {pin: [crank, coupler], angle: "
                                 "t3}, Q: {pin: [ground, rocker], angle: t4}, B: {pin: [coupler, rocker]}}\n"
                                 "drives: {t3: -30 deg}\n"
                                 "start: {t2: 60 deg, t4: 100 deg}\n";
static const char lift_cylinder[] =
    "bodies:\n"
    "  ground: {points: {O: [0, 0], B: [1, -0.5]}}\n  boom: {points: {O: [0, 0], C: [2, 0]}}\n  barrel: {points: {B: "
    "[0, 0]}}\n  piston: {points: {C: [0, 0]}}\n"
    "joints: {O: {pin: [ground, boom], angle: a}, B: {pin: [ground, barrel], angle: b}, S: {slide: [barrel, piston], "
    "along: x, distance: s}, C: {pin: [boom, piston]}}\n"
    "drives: {s: 1.8}\n"
    "start: {a: 30 deg, b: 70 deg}\n";
static const char oldham[] = "bodies: {ground: {points: {P: [0, 0], Q: [0.1, 0.02]}}, one: {points: {P: [0, 0]}}, "
                             "disc: {}, two: {points: {Q: [0, 0]}}}\n"
                             "joints: {P: {pin: [ground, one], angle: th}, S: {slide: [one, disc], along: x, distance: "
                             "u}, T: {slide: [disc, two], along: y, distance: v}, Q: {pin: [ground, two]}}\n"
                             "start: {th: 40 deg}\n";
static const char scissor[] =
    "bodies:\n"
    "  ground: {points: {A: [0, 0]}}\n"
    "  a1: {points: {A: [0, 0], M1: [1, 0], C: [2, 0]}}\n  b1: {points: {B: [0, 0], M1: [1, 0], D: [2, 0]}}\n"
    "  a2: {points: {D: [0, 0], M2: [1, 0], F: [2, 0]}}\n  b2: {points: {C: [0, 0], M2: [1, 0], E: [2, 0]}}\n"
    "  top: {points: {E: [0, 0]}}\n"
    "joints:\n"
    "  A: {pin: [ground, a1], angle: th}\n  M1: {pin: [a1, b1], angle: m}\n  B: {pin-slot: [ground, b1], at: B, along: "
    "x, from: A}\n"
    "  D: {pin: [b1, a2], angle: n}\n  C: {pin: [a1, b2], angle: c}\n  M2: {pin: [a2, b2]}\n"
    "  E: {pin: [b2, top], angle: p}\n  F: {pin-slot: [top, a2], at: F, along: x}\n"
    "start: {th: 30 deg, m: 120 deg, n: -120 deg, c: 120 deg, p: -150 deg}\n";
static const char pantograph[] =
    "bodies:\n"
    "  ground: {points: {O: [0, 0]}}\n"
    "  a: {points: {O: [0, 0], P: [1, 0], R: [3, 0]}}\n  b: {points: {R: [0, 0], S: [2, 0], T: [3, 0]}}\n" LINK(
        "c", "P", "Q", "2")
        LINK("d", "S", "Q", "2") "joints: {O: {pin: [ground, a], angle: th}, R: {pin: [a, b], angle: u}, P: {pin: [a, "
                                 "c], angle: v}, S: {pin: [b, d], angle: w}, Q: {pin: [c, d]}}\n"
                                 "start: {th: 60 deg, u: -90 deg, v: -90 deg, w: -90 deg}\n";
static const char two_four_bars[] =
    "bodies:\n"
    "  ground: {points: {O: [0, 0], Q: [4, 0], U: [0, 9], W: [4, 9]}}\n" LINK("a", "O", "A", "1")
        LINK("b", "A", "B", "3.5") LINK("c", "Q", "B", "3") LINK("d", "U", "D", "1") LINK("e", "D", "E", "3.5")
            LINK("f", "W", "E", "3") "joints:\n"
                                     "  O: {pin: [ground, a], angle: t2}\n  A: {pin: [a, b], angle: t3}\n  Q: {pin: "
                                     "[ground, c], angle: t4}\n  B: {pin: [b, c]}\n"
                                     "  U: {pin: [ground, d], angle: u2}\n  D: {pin: [d, e], angle: u3}\n  W: {pin: "
                                     "[ground, f], angle: u4}\n  E: {pin: [e, f]}\n"
                                     "start: {t2: 1, t3: -0.5, t4: 1.6, u2: 1, u3: -0.5, u4: 1.6}\n";
static const char undeclared[] =
    "bodies:\n"
    "  ground: {points: {O: [0, 0], Q: [4, 0]}}\n" LINK("crank", "O", "A", "1") LINK("coupler", "A", "B", "3.5")
        LINK("rocker", "Q", "B", "3") "joints: {O: {pin: [ground, crank]}, A: {pin: [crank, coupler]}, B: {pin: "
                                      "[coupler, rocker]}, Q: {pin: [ground, rocker]}}\n";
static const char watt_two[] = // two four-bars in a row share a ternary rocker
    "bodies:\n"
    "  ground: {points: {O: [0, 0], Q: [4, 0], W: [9, 0]}}\n" LINK("crank", "O", "A", "1") LINK(
        "b", "A", "B", "3.5") "  rocker: {points: {Q: [0, 0], B: [3, 0], C: [2, -1]}}\n" LINK("d", "C", "D", "4.5")
        LINK("out", "W", "D",
             "2.5") "joints:\n"
                    "  O: {pin: [ground, crank], angle: t1}\n  A: {pin: [crank, b], angle: t2}\n  Q: {pin: [ground, "
                    "rocker], angle: t3}\n  B: {pin: [b, rocker]}\n"
                    "  C: {pin: [rocker, d], angle: t4}\n  W: {pin: [ground, out], angle: t5}\n  D: {pin: [d, out]}\n"
                    "drives: {t1: 1}\nstart: {t2: -0.5, t3: 1.8, t4: -1.5, t5: 2}\n";
static const char yoke_driven_by_slide[] = // the same Scotch yoke, moved by its yoke
    "bodies: {ground: {}, crank: {points: {A: [1, 0]}}, yoke: {}}\n"
    "joints: {O: {pin: [ground, crank], angle: th}, R: {slide: [ground, yoke], along: x, distance: x}, A: {pin-slot: "
    "[yoke, crank], at: A, along: y}}\n"
    "drives: {x: 0.5}\nstart: {th: 50 deg}\n";
static const char rack_of_slots[] = // a plate on three pins in crossed slots of the ground, and no freedom left
    "bodies: {ground: {points: {F: [0, 1]}}, plate: {points: {A: [0, 0], B: [1, 0], C: [0, 1]}}}\n"
    "joints:\n"
    "  A: {pin-slot: [ground, plate], at: A, along: x, distance: u}\n  B: {pin-slot: [ground, plate], at: B, along: "
    "x}\n"
    "  C: {pin-slot: [ground, plate], at: C, from: F, along: 45 deg}\n"
    "start: {u: 0}\n";
static const char cross_head[] = // slider-crank whose rod's end runs in a slot, without a slider
    "bodies:\n  ground: {}\n" LINK("crank", "O", "A", "1")
        LINK("rod", "A", "B", "3") "joints: {K: {pin: [ground, crank], angle: th}, A: {pin: [crank, rod], angle: u}, "
                                   "B: {pin-slot: [ground, rod], at: B, along: x}}\n"
                                   "drives: {th: 1}\nstart: {u: -1.2}\n";
static const char hart[] = // a contraparallelogram held at the middle of one long bar; P runs on a circle
    "bodies:\n"
    "  ground: {points: {O: [0, 0], M: [0.8, 0]}}\n"
    "  base: {points: {A: [-2, 0], O: [0, 0], B: [2, 0]}}\n  top: {points: {D: [-2, 0], C: [2, 0]}}\n"
    "  ac: {points: {A: [0, 0], P: [1, 0], C: [2, 0]}}\n  bd: {points: {B: [0, 0], D: [2, 0]}}\n" LINK(
        "guide", "M", "P",
        "0.8") "joints:\n"
               "  O: {pin: [ground, base], angle: th}\n  A: {pin: [base, ac], angle: a}\n  B: {pin: [base, bd], angle: "
               "b}\n  C: {pin: [ac, top], angle: c}\n"
               "  D: {pin: [bd, top]}\n  M: {pin: [ground, guide], angle: g}\n  P: {pin: [guide, ac]}\n"
               "start: {g: 40 deg, th: 130 deg, a: -60 deg, b: -120 deg, c: 120 deg}\n";

static const Known machines[] = {
    {"andrews", 1, 1, 3, "beta", "RRR E2, RRR E4, RRR E6"},
    {"change-point-four-bar", 1, 1, 1, "theta2", "RRR B"},
    {"chebyshev", 1, 1, 1, "theta", "RRR B"},
    {"crank-slotted-lever", 1, 1, 2, "theta", "RPR A, PP P"},
    {"double-butterfly", 1, 1, 3, "lambda", "GROUP DW"},
    {"double-pendulum", 2, 2, 0, "theta1, theta2", ""},
    {"doubled-guide", -1, 1, 2, "theta", "RRP B, LINK lower"},
    {"drag-link", 1, 1, 1, "theta2", "RRR B"},
    {"elliptic-trammel", 1, 1, 1, "theta", "PP B"},
    {"excavator", 2, 2, 2, "s1, s2", "RRR C, RRR E"},
    {"five-bar", 2, 2, 1, "theta1, theta2", "RRR P"},
    {"four-bar", 1, 1, 1, "theta2", "RRR B"},
    {"hoeken", 1, 1, 1, "theta", "RRR B"},
    {"inverted-slider-crank", 1, 1, 1, "theta2", "RPR A"},
    {"jansen", 1, 1, 3, "theta", "RRR H, RRR K, RRR N"},
    {"kite", 1, 1, 1, "theta2", "RRR B"},
    {"klann", 1, 1, 2, "theta", "RRR C, RRR hip"},
    {"marghitu", 1, 1, 2, "phi", "RPR B, RRP E"},
    {"non-grashof", 1, 1, 1, "theta2", "RRR B"},
    {"offset-slider-crank", 1, 1, 1, "theta2", "RRP B"},
    {"oscillating-cylinder", 1, 1, 1, "theta", "RPR A"},
    {"parallelogram", 1, 1, 1, "theta2", "RRR B"},
    {"peaucellier", 1, 1, 3, "theta", "RRR B, RRR C, RRR Q"},
    {"pmks-slider-crank", 1, 1, 1, "alpha", "RRP C"},
    {"quick-return", 1, 1, 2, "theta1", "RPR A, RRP C"},
    {"scotch-yoke", 1, 1, 1, "theta", "PP A"},
    {"slider-crank", 1, 1, 1, "theta", "RRP B"},
    {"stephenson-awkward", 1, 1, 2, "theta6", "GROUP B"},
    {"stephenson-six-bar", 1, 1, 2, "theta2", "RRR B, RRR D"},
    {"three-crank-parallelogram", 0, 1, 2, "theta1", "RRR A2, LINK A3"},
    {"toggle", 1, 1, 2, "theta1", "RRR J23, RRP B"},
    {"watt-six-bar", 1, 1, 2, "alpha", "RRR C, RRR F"},
    {"whitworth-kg", 1, 1, 2, "theta", "RPR A, RRP B"},
    {wedges, 0, 1, 1, "d", "PP stand"},
    {four_cranks, -1, 1, 3, "t1", "RRR A2, LINK A3, LINK A4"},
    {tied_parallelogram, 0, 1, 2, "theta", "RRR B, LINK N"},
    {cardan, 0, 1, 2, "theta", "RRP A, LINK V"},
    {braced_square, -1, 0, 3, "", "RRR Dq, RRR Ct, LINK Cp"},
    {triangle, 0, 0, 1, "", "RRR C"},
    {post, 0, 0, 0, "", ""},
    {arm, 3, 3, 0, "c, a, b", ""},
    {floating_drive, 1, 1, 1, "t3", "RRR B"},
    {lift_cylinder, 1, 1, 1, "s", "RRR C"},
    {oldham, 1, 1, 1, "th", "PP T"},
    {scissor, 1, 1, 3, "th", "RRP B, RRR M2, RPR F"},
    {pantograph, 2, 2, 1, "th, u", "RRR Q"},
    {two_four_bars, 2, 2, 2, "t2, u2", "RRR B, RRR E"},
    {undeclared, 1, 1, 1, "O.angle", "RRR B"},
    {watt_two, 1, 1, 2, "t1", "RRR B, RRR D"},
    {yoke_driven_by_slide, 1, 1, 1, "x", "RRP A"},
    {rack_of_slots, 0, 0, 2, "", "GROUP C"},
    {cross_head, 1, 1, 1, "th", "RRP B"},
    {hart, 1, 1, 2, "g", "RRR P, RRR D"},
};
enum { MACHINES = sizeof machines / sizeof *machines };

#endif
