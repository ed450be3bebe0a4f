// Equations that hold on one assembly of a machine and not on another: dimensions that occur twice split the loops'
// equations.
#include "verdicts.h"

static void check_machine(const char *text, const Expected *expected, size_t count)
{
    Machine m = machine_of(text);
    check_kinds(&m, expected, count);
    machine_end(&m);
}
#define CHECK_MACHINE(text, ...)                                                                                       \
    check_machine(text, (const Expected[]){__VA_ARGS__}, sizeof((const Expected[]){__VA_ARGS__}) / sizeof(Expected))

static const char scissor[] = "parameters: {L: 1.2 m, W: 80 kg}\n"
                              "gravity: [0, -9.81 m/s^2]\n"
                              "bodies:\n"
                              "  ground: {points: {O: [0, 0]}}\n"
                              "  a: {points: {O: [0, 0], M: [L/2, 0], T: [L, 0]}}\n"
                              "  b: {points: {B: [0, 0], M: [L/2, 0], S: [L, 0]}}\n"
                              "  foot: {points: {B: [0, 0]}}\n"
                              "  table: {points: {S: [0, 0], G: [0.5 m, 0.1 m]}, mass: W, center: [0.5 m, 0.1 m]}\n"
                              "  roller: {points: {T: [0, 0]}}\n"
                              "joints:\n"
                              "  O: {pin: [ground, a], angle: theta}\n"
                              "  M: {pin: [a, b]}\n"
                              "  F: {slide: [ground, foot], along: x, from: O, distance: x}\n"
                              "  B: {pin: [foot, b]}\n"
                              "  S: {pin: [b, table]}\n"
                              "  T: {pin: [a, roller]}\n"
                              "  R: {slide: [table, roller], along: x, distance: u}\n"
                              "drives: {x: 1.0 m - 0.1 m/s * t}\n"
                              "start: {theta: 33 deg, u: 1.0 m}\n";

static void a_scissor_lift_stays_level(void **state)
{
    (void)state;
    CHECK_MACHINE(scissor, IS("B.angle = pi - theta"), IS("sin(theta + B.angle) = 0"), IS("table.angle = 0"),
                  IS("u = x"), IS("table.G.y = L sin(theta) + 0.1 m"), IS("x = L cos(theta)"),
                  IS("table.G.y' = x theta'"), IS_NOT("B.angle = theta"), IS_NOT("table.G.y = L cos(theta) + 0.1 m"),
                  IS_HERE("L = 1.2 m"), IS_NOT("x = 2 L cos(theta)"), IS_NOT("L = 0"), IS_NOT("u = 0"));
}

// Of lengths a and b; the ground's and the follower's by name.
#define FOUR_BAR_OF(numbers, ground, follower)                                                                         \
    "parameters: {" numbers "}\n"                                                                                      \
    "bodies:\n"                                                                                                        \
    "  ground: {points: {O: [0, 0], C: [" ground ", 0]}}\n"                                                            \
    "  crank: {points: {O: [0, 0], A: [a, 0]}}\n"                                                                      \
    "  rod: {points: {A: [0, 0], B: [b, 0]}}\n"                                                                        \
    "  other: {points: {C: [0, 0], B: [" follower ", 0]}}\n"                                                           \
    "joints:\n"                                                                                                        \
    "  O: {pin: [ground, crank], angle: t1}\n"                                                                         \
    "  A: {pin: [crank, rod], angle: t2}\n"                                                                            \
    "  C: {pin: [ground, other], angle: t3}\n"                                                                         \
    "  B: {pin: [rod, other]}\n"
#define FOUR_BAR FOUR_BAR_OF("a: 0.3, b: 0.8", "b", "a")

// The same lengths and the same equations: what is true of one assembly is false of the other.
static void parallelogram_and_contra_parallelogram_are_told_apart(void **state)
{
    (void)state;
    CHECK_MACHINE(FOUR_BAR "start: {t1: 1, t2: -1, t3: 1}\n", IS("t3 = t1"), IS("rod.angle = 0"), IS("t2 = -t1"),
                  IS("t1' = t3'"), IS("rod.B.x = b + a cos(t1)"), IS("rod.B.y'' = a cos(t1) t1'' - a sin(t1) t1'^2"),
                  IS_NOT("t2 = t3"), IS_NOT("t1' = -t3'"), IS_NOT("rod.B.y = a cos(t1)"), IS_HERE("a = 0.3"));
    CHECK_MACHINE(FOUR_BAR "start: {t1: 1, t2: -1.5, t3: -1.6}\n", IS("t2 = t3"), IS("rod.angle = t1 + t3"),
                  IS("a (cos(t1) - cos(t3)) = b - b cos(t1 + t2)"), IS_NOT("t3 = t1"), IS_NOT("rod.angle = 0"),
                  IS_NOT("t1' = t3'"));
}

// Angles go on over turns: phi = -2 theta also where that is far from the start.
static void a_crank_as_long_as_its_rod_makes_an_isosceles_triangle(void **state)
{
    (void)state;
    CHECK_MACHINE("parameters: {r: 0.1}\n"
                  "bodies:\n"
                  "  ground: {points: {O: [0, 0]}}\n"
                  "  crank:  {points: {O: [0, 0], A: [r, 0]}}\n"
                  "  rod:    {points: {A: [0, 0], B: [r, 0]}}\n"
                  "  piston: {points: {B: [0, 0]}}\n"
                  "joints:\n"
                  "  O: {pin: [ground, crank], angle: theta}\n"
                  "  A: {pin: [crank, rod], angle: phi}\n"
                  "  B: {pin: [rod, piston]}\n"
                  "  S: {slide: [ground, piston], along: x, distance: s}\n"
                  "start: {theta: 50 deg, phi: -100 deg, s: 0.12}\n",
                  IS("phi = -2 theta"), IS("rod.angle = -theta"), IS("s = 2 r cos(theta)"),
                  IS("s' = -2 r sin(theta) theta'"), IS("s^2 = 4 r^2 - 4 r^2 sin(theta)^2"), IS_NOT("s = r cos(theta)"),
                  IS_NOT("s = 0"), IS_HERE("s = 0.2 cos(theta)"));
}

static void kites_and_trammels_keep_their_symmetry(void **state)
{
    (void)state;
    CHECK_MACHINE(FOUR_BAR_OF("a: 0.3, b: 0.5", "a", "b") "start: {t1: 1, t2: -1, t3: 1}\n", IS("rod.angle + t3 = t1"),
                  IS("t3' + t2' = 0"), IS("b sin(t3) = a sin(t1) + b sin(t1 + t2)"), IS_NOT("rod.angle + t3 = t1 + pi"),
                  IS_NOT("t2 = t3"));
    CHECK_MACHINE("parameters: {a: 0.3, b: 0.5}\n"
                  "bodies:\n"
                  "  ground: {points: {O: [0, 0]}}\n"
                  "  h: {points: {P: [0, 0]}}\n"
                  "  v: {points: {Q: [0, 0]}}\n"
                  "  bar: {points: {P: [0, 0], Q: [a + b, 0], M: [a, 0]}}\n"
                  "joints:\n"
                  "  H: {slide: [ground, h], along: x, distance: x}\n"
                  "  V: {slide: [ground, v], along: y, distance: y}\n"
                  "  P: {pin: [h, bar], angle: th}\n"
                  "  Q: {pin: [bar, v]}\n"
                  "start: {th: 2, x: 0.3, y: 0.7}\n",
                  IS("x = -(a + b) cos(th)"), IS("y = (a + b) sin(th)"), IS("bar.M.x = -b cos(th)"),
                  IS("(bar.M.x/b)^2 + (bar.M.y/a)^2 = 1"), IS_NOT("(bar.M.x/a)^2 + (bar.M.y/b)^2 = 1"));
}

static void straight_lines_and_enlarged_figures_are_proved(void **state)
{
    (void)state;
    CHECK_MACHINE( // Scott Russell
        "parameters: {l: 0.3}\n"
        "bodies:\n"
        "  ground: {points: {O: [0, 0]}}\n"
        "  crank: {points: {O: [0, 0], A: [l, 0]}}\n"
        "  bar: {points: {B: [0, 0], A: [l, 0], C: [2*l, 0]}}\n"
        "  block: {points: {B: [0, 0]}}\n"
        "joints:\n"
        "  O: {pin: [ground, crank], angle: th}\n"
        "  S: {slide: [ground, block], along: x, distance: s}\n"
        "  B: {pin: [block, bar], angle: ph}\n"
        "  A: {pin: [crank, bar]}\n"
        "start: {th: 1, ph: 2.14, s: 0.32}\n",
        IS("ph = pi - th"), IS("bar.C.x = 0"), IS("bar.C.y = 2 l sin(th)"), IS("s = 2 l cos(th)"),
        IS_NOT("bar.C.y = l sin(th)"), IS_NOT("bar.C.y = 0"));
    CHECK_MACHINE( // a pantograph
        "parameters: {a: 0.2, k: 3}\n"
        "bodies:\n"
        "  ground: {points: {O: [0, 0]}}\n"
        "  u: {points: {O: [0, 0], A: [a, 0], D: [k*a, 0]}}\n"
        "  v: {points: {A: [0, 0], P: [a, 0]}}\n"
        "  w: {points: {D: [0, 0], E: [a, 0], Q: [k*a, 0]}}\n"
        "  z: {points: {P: [0, 0], E: [(k - 1)*a, 0]}}\n"
        "joints:\n"
        "  O: {pin: [ground, u], angle: t1}\n"
        "  A: {pin: [u, v], angle: t2}\n"
        "  D: {pin: [u, w], angle: t3}\n"
        "  P: {pin: [v, z], angle: t4}\n"
        "  E: {pin: [w, z]}\n"
        "start: {t1: 1, t2: -1.3, t3: -1.3, t4: 1.3}\n",
        IS("w.Q.x = k v.P.x"), IS("w.Q.y' = k v.P.y'"), IS("z.angle = t1"), IS("t3 = t2"), IS_NOT("w.Q.x = 2 v.P.x"),
        IS_HERE("w.Q.y = 3 v.P.y"));
}

static const char planets[] = "parameters: {N1: 24, N2: 18, N3: 60, mod: 2 mm, c: mod*(N1 + N2)/2}\n"
                              "bodies: {sun: {}, p1: {}, p2: {}, ring: {}, arm: {points: {P: [c, 0], Q: [-c, 0]}}}\n"
                              "joints:\n"
                              "  S: {pin: [ground, sun],  angle: theta1}\n"
                              "  C: {pin: [ground, arm],  angle: thetaC}\n"
                              "  R: {pin: [ground, ring], angle: theta4}\n"
                              "  P: {pin: [arm, p1],  angle: theta2}\n"
                              "  Q: {pin: [arm, p2],  angle: theta3}\n"
                              "gears:\n"
                              "  a: {mesh: [sun, p1],  teeth: [N1, N2], module: mod, carrier: arm}\n"
                              "  b: {mesh: [sun, p2],  teeth: [N1, N2], module: mod, carrier: arm}\n"
                              "  c1: {mesh: [p1, ring], teeth: [N2, N3], module: mod, carrier: arm, internal: true}\n"
                              "  c2: {mesh: [p2, ring], teeth: [N2, N3], module: mod, carrier: arm, internal: true}\n"
                              "drives: {thetaC: 20 rpm * t, theta1: 40 rpm * t}\n";

static void equal_planets_turn_alike(void **state)
{
    (void)state;
    CHECK_MACHINE(planets, IS("theta2 = theta3"), IS("N1 theta1' = (N1 + N3) thetaC' - N3 theta4'"),
                  IS_NOT("theta2' = -theta3'"), IS_HERE("N3 = N1 + 2 N2"),
                  IS_HERE("2 (N1 + N2) thetaC' = N1 theta1' + N3 theta4'"));
}

// The ring's teeth are those of the sun and of two planets: that is not a coincidence, and nothing is said against it.
static void what_teeth_must_obey_is_not_refuted(void **state)
{
    (void)state;
    Machine m = machine_of(planets);
    YkCheckVerdict verdict = verdict_on(&m, "2 (N1 + N2) thetaC' = N1 theta1' + N3 theta4'");
    assert_int_equal(verdict.kind, YK_CHECK_TRUE_HERE);
    assert_false(verdict.is_refuted || verdict.is_false_there);
    machine_end(&m);
}

static const char equal_bars[] = FOUR_BAR_OF("a: 0.3, b: 0.8", "b", "b") "start: {t1: 1, t2: -0.5, t3: 1.2}\n";

// Three equal bars: at random angles the loop closes with a = b = 0 alone, and no sum of angles stays. What cannot be
// proved is tried on machines with other lengths, and the verdict says how far that went.
static void what_cannot_be_proved_is_tried_with_other_dimensions(void **state)
{
    (void)state;
    Machine m = machine_of(equal_bars);
    YkCheckVerdict verdict = verdict_on(&m, "b sin(t3) = a sin(t1) + b sin(t1 + t2)");
    assert_int_equal(verdict.kind, YK_CHECK_TRUE_HERE);
    assert_true(verdict.machines == 3 && verdict.machine_poses >= 12 && verdict.poses >= 20);
    assert_false(verdict.is_false_there);
    assert_string_equal(verdict.varied, "a, b");
    assert_null(verdict.kept);
    // Freudenstein 1955, with three equal lengths
    verdict = verdict_on(&m, "2 a (b cos(t3) - b cos(t1)) + (a^2 + b^2) = 2 a b cos(t1 - t3)");
    assert_int_equal(verdict.kind, YK_CHECK_FALSE);
    verdict = verdict_on(&m, "2 b (b cos(t3) - a cos(t1)) + (a^2 + b^2) = 2 a b cos(t1 - t3)");
    assert_int_equal(verdict.kind, YK_CHECK_TRUE_HERE);
    assert_true(verdict.machines == 3 && !verdict.is_false_there);
    verdict = verdict_on(&m, "0.8 sin(t3) = a sin(t1) + b sin(t1 + t2)");
    assert_int_equal(verdict.kind, YK_CHECK_TRUE_HERE);
    assert_true(verdict.is_false_there);
    machine_end(&m);
}

static double at_machine(const char *parameters, const char *name)
{
    const char *found = strstr(parameters, name);
    return found ? strtod(found + strlen(name), NULL) : NAN;
}

// The machine that is named refutes the equation when its file is written with these numbers.
static void the_machine_that_is_named_refutes_the_equation(void **state)
{
    (void)state;
    static const char file[] = "parameters: {a: %.17g, b: %.17g}\n"
                               "bodies:\n"
                               "  ground: {points: {O: [0, 0]}}\n"
                               "  crank: {points: {O: [0, 0], A: [a, 0]}}\n"
                               "  rod: {points: {A: [0, 0], B: [b, 0]}}\n"
                               "  piston: {points: {B: [0, 0]}}\n"
                               "joints:\n"
                               "  O: {pin: [ground, crank], angle: th}\n"
                               "  A: {pin: [crank, rod], angle: ph}\n"
                               "  B: {pin: [rod, piston]}\n"
                               "  S: {slide: [ground, piston], along: x, distance: s}\n"
                               "start: {th: 1, ph: -1.3, s: 0.2}\n",
                      equation[] = "s^2 - 2 a s cos(th) = 0.24"; // b^2 - a^2
    char text[900];
    snprintf(text, sizeof text, file, 0.1, 0.5);
    Machine m = machine_of(text);
    YkCheckVerdict verdict = verdict_on(&m, equation);
    assert_int_equal(verdict.kind, YK_CHECK_TRUE_HERE);
    assert_true(verdict.is_false_there);
    double a = at_machine(verdict.shown.machine, "a = "), b = at_machine(verdict.shown.machine, "b = ");
    if (isnan(a)) a = 0.1;
    if (isnan(b)) b = 0.5;
    CHECK_NEAR(verdict.shown.left, b * b - a * a, 1e-12);
    CHECK_NEAR(verdict.shown.right, 0.24, 1e-15);
    double th = verdict.shown.positions[0].position, s = verdict.shown.positions[2].position;
    CHECK_NEAR(s * s - 2 * a * s * cos(th), verdict.shown.left, 1e-12);
    snprintf(text, sizeof text, file, a, b);
    Machine other = machine_of(text);
    assert_int_equal(verdict_on(&other, equation).kind, YK_CHECK_FALSE);
    machine_end(&other);
    machine_end(&m);
}

// An offset that is 0 in the file can vary, too.
static void what_is_nothing_in_the_file_may_be_something_elsewhere(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {a: 0.1, b: 0.5, e: 0 m}\n"
                           "bodies:\n"
                           "  ground: {points: {O: [0, 0], Q: [0, e]}}\n"
                           "  crank: {points: {O: [0, 0], A: [a, 0]}}\n"
                           "  rod: {points: {A: [0, 0], B: [b, 0]}}\n"
                           "  piston: {points: {B: [0, 0]}}\n"
                           "joints:\n"
                           "  O: {pin: [ground, crank], angle: th}\n"
                           "  A: {pin: [crank, rod], angle: ph}\n"
                           "  B: {pin: [rod, piston]}\n"
                           "  S: {slide: [ground, piston], along: x, from: Q, distance: s}\n"
                           "start: {th: 1, ph: -1.3, s: 0.2}\n");
    YkCheckVerdict verdict = verdict_on(&m, "a sin(th) + b sin(th + ph) = 0");
    assert_int_equal(verdict.kind, YK_CHECK_TRUE_HERE);
    assert_true(verdict.is_false_there);
    assert_non_null(strstr(verdict.shown.machine, "e = "));
    CHECK_NEAR(verdict.shown.left, at_machine(verdict.shown.machine, "e = "), 1e-12);
    assert_int_equal(verdict_on(&m, "a sin(th) + b sin(th + ph) = e").kind, YK_CHECK_TRUE);
    machine_end(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_scissor_lift_stays_level),
        cmocka_unit_test(parallelogram_and_contra_parallelogram_are_told_apart),
        cmocka_unit_test(a_crank_as_long_as_its_rod_makes_an_isosceles_triangle),
        cmocka_unit_test(kites_and_trammels_keep_their_symmetry),
        cmocka_unit_test(straight_lines_and_enlarged_figures_are_proved),
        cmocka_unit_test(equal_planets_turn_alike),
        cmocka_unit_test(what_teeth_must_obey_is_not_refuted),
        cmocka_unit_test(what_cannot_be_proved_is_tried_with_other_dimensions),
        cmocka_unit_test(the_machine_that_is_named_refutes_the_equation),
        cmocka_unit_test(what_is_nothing_in_the_file_may_be_something_elsewhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
