// The forces that gears, racks, belts, cams and laws transmit, in symbols: true with the engine's forces, proved to do
// the relation's work, readable.
#include "dynamics/meshes.h"
#include "dynamics/random_geared.h"
#include "derive/forces/lagrange.h"
#include "derive/relations.h"
#include "forces_check.h"
#include "solve/state.h"

#define LIFT                                                                                                           \
    "laws:\n  lift: {period: 2*pi, segments: [{rise: {to: 120 deg, by: 20 mm, law: cycloidal}}, "                      \
    "{fall: {to: 240 deg, by: 20 mm, law: cycloidal}}, {dwell: {to: 2*pi}}]}\n"
#define SWING                                                                                                          \
    "laws:\n  swing: {period: 2*pi, segments: [{rise: {to: 120 deg, by: 20 deg, law: cycloidal}}, "                    \
    "{fall: {to: 240 deg, by: 20 deg, law: cycloidal}}, {dwell: {to: 2*pi}}]}\n"

// A cam and its follower on an arm that turns.
#define CAM_ON_ARM                                                                                                     \
    LIFT "gravity: [0, -9.81]\nparameters: {r: 30 mm}\nbodies:\n"                                                      \
         "  ground: {points: {O: [0, 0]}}\n  arm: {points: {O: [0, 0], K: [0.2, 0.05], E: [0.21, 0.045]}, mass: 1, "   \
         "inertia: 0.01}\n"                                                                                            \
         "  shaft: {points: {K: [0, 0]}, mass: 0.5, inertia: 0.001, center: [0.003, 0]}\n"                             \
         "  tappet: {points: {T: [0, 0]}, mass: 0.2, center: [0.01, 0.02], inertia: 0.0001}\n"                         \
         "joints:\n  O: {pin: [ground, arm], angle: a}\n  K: {pin: [arm, shaft], angle: th}\n"                         \
         "  G: {slide: [arm, tappet], along: 70 deg, from: E, distance: s}\n"                                          \
         "cams: {c: {cam: shaft, follower: tappet, law: lift, roller: 8 mm, base: r}}\n"                               \
         "start: {a: 0.3, th: 40 deg, a.rate: 2, th.rate: 20}\n"

// The same seen from the other bodies: the arm counts back from the shaft, the follower's guide is its own line.
#define CAM_BACKWARDS                                                                                                  \
    LIFT "gravity: [0, -9.81]\nbodies:\n"                                                                              \
         "  ground: {points: {K: [0, 0], T: [0, 0]}}\n  shaft: {points: {K: [0, 0]}, mass: 0.5, inertia: 0.001}\n"     \
         "  tappet: {points: {T: [0, 0]}, mass: 0.2, center: [0.01, 0.02], inertia: 0.0001}\n"                         \
         "joints:\n  K: {pin: [shaft, ground], angle: th}\n  G: {slide: [tappet, ground], along: y, distance: s}\n"    \
         "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 30 mm, offset: 3 mm}}\n"                           \
         "start: {th: -40 deg, th.rate: 20}\n"

#define ROCKER(PIN, KEYS)                                                                                              \
    SWING "gravity: [0, -9.81]\nbodies:\n  ground: {points: {O: [0, 0], Q: [90 mm, 40 mm]}}\n"                         \
          "  shaft: {points: {O: [0, 0]}, mass: 1, inertia: 0.001}\n"                                                  \
          "  rocker: {points: {Q: [0, 0], P: [-80 mm, 5 mm]}, mass: 0.6, center: [-0.03, 0.005], inertia: 0.0007}\n"   \
          "joints:\n  O: {pin: [ground, shaft], angle: theta}\n  Q: {pin: " PIN ", angle: phi}\n"                      \
          "cams: {c: {cam: shaft, follower: rocker, law: swing, roller: 10 mm, base: 45 mm, " KEYS "}}\n"              \
          "start: {theta: 50 deg, theta.rate: 8}\n"

// A cam of two rollers: the second bears where the first would have to pull.
#define TAPPET_OF_TWO                                                                                                  \
    LIFT "gravity: [0, -9.81]\nbodies:\n  ground: {points: {K: [0, 0]}}\n"                                             \
         "  shaft: {points: {K: [0, 0]}, mass: 0.5, inertia: 0.001}\n"                                                 \
         "  tappet: {points: {T: [0, 0]}, mass: 0.2, inertia: 0.0001}\n"                                               \
         "joints:\n  K: {pin: [ground, shaft], angle: th}\n  G: {slide: [ground, tappet], along: y, distance: s}\n"    \
         "cams: {c: {cam: shaft, follower: tappet, law: lift, roller: 8 mm, base: 40 mm, offset: 4 mm, "               \
         "conjugate: {roller: 9 mm, span: 150 mm}}}\nforces: {F: {body: tappet, value: [0, 20 N * "                    \
         "sin(20*th)]}}\nstart: {th: 40 deg, th.rate: 20}\n"

// A pulley's motion follows another's by a law.
#define FOLLOW_ANGLE(OWN, OF)                                                                                          \
    SWING "bodies:\n  ground: {points: {A: [0, 0], B: [1, 0]}}\n  p: {points: {A: [0, 0]}, mass: 1, inertia: 0.3}\n"   \
          "  q: {points: {B: [0, 0], C: [0.3, 0]}, mass: 1, inertia: 0.7}\n  r: {points: {C: [0, 0]}, mass: 1, "       \
          "inertia: 0.2}\n"                                                                                            \
          "joints:\n  A: {pin: [ground, p], angle: x}\n  B: {pin: [ground, q], angle: y}\n"                            \
          "  C: {pin: [q, r], angle: z}\ndrives: {" OWN ": {law: swing, of: " OF "}}\nefforts: {y: 1}\n"               \
          "start: {" OF ": 0.5, " OF ".rate: 3, y.rate: 2}\n"

// A slide that follows another's distance by a law, and one that follows an angle; on bodies that move.
#define FOLLOW_DISTANCE                                                                                                \
    "laws:\n  ramp: {table: [[-2 m, -1 m], [0 m, 0.1 m], [1 m, 0.5 m], [2 m, 0.7 m]]}\n"                               \
    "gravity: [0, -9.81]\nbodies:\n  ground: {points: {O: [0, 0]}}\n"                                                  \
    "  arm: {points: {O: [0, 0], P: [0.3, 0.1]}, mass: 1, inertia: 0.3, center: [0.2, 0]}\n"                           \
    "  p: {points: {T: [0, 0]}, mass: 0.5, inertia: 0.01, center: [0.02, 0.01]}\n"                                     \
    "  q: {points: {T: [0, 0]}, mass: 0.7, inertia: 0.02, center: [0.03, 0]}\n"                                        \
    "joints:\n  O: {pin: [ground, arm], angle: a}\n  S: {slide: [arm, p], along: 20 deg, from: P, distance: u}\n"      \
    "  R: {slide: [p, q], along: 70 deg, distance: w}\ndrives: {w: {law: ramp, of: u}}\nefforts: {a: 2 N*m}\n"         \
    "start: {a: 0.4, a.rate: 1, u: 0.3, u.rate: 0.5}\n"

// Gears on one axis, nothing known of where they mesh.
#define COAXIAL                                                                                                        \
    "bodies:\n  ground: {points: {O: [0, 0]}}\n  sun: {points: {O: [0, 0]}, mass: 1, inertia: 0.2}\n"                  \
    "  planet: {points: {O: [0, 0]}, mass: 1, inertia: 0.1}\n  arm: {points: {O: [0, 0]}, mass: 1, inertia: 0.3}\n"    \
    "joints:\n  S: {pin: [ground, sun], at: O, angle: s}\n  C: {pin: [ground, arm], at: O, angle: c}\n"                \
    "  P: {pin: [arm, planet], at: O, angle: p}\n"                                                                     \
    "gears: {g: {mesh: [sun, planet], teeth: [20, 30], carrier: arm}}\nefforts: {s: 2}\n"                              \
    "start: {s.rate: 1, c.rate: 2}\n"

// Centres on a slanted line, teeth as parameters, a distance that is not the module's: pitch radii are quotients.
#define SLANTED                                                                                                        \
    "gravity: [0, -9.81]\nparameters: {Z1: 20, Z2: 30, u: 30 mm, v: 40 mm, alpha: 25 deg}\nbodies:\n"                  \
    "  ground: {points: {A: [0, 0], B: [u, v]}}\n  p: {points: {A: [0, 0]}, mass: 1, inertia: 0.3}\n"                  \
    "  q: {points: {B: [0, 0]}, mass: 1, inertia: 0.7, center: [0.02, 0]}\n"                                           \
    "joints:\n  A: {pin: [ground, p], angle: x}\n  B: {pin: [ground, q], angle: y}\n"                                  \
    "gears: {g: {mesh: [p, q], teeth: [Z1, Z2], pressure_angle: alpha}}\nefforts: {x: 2}\nstart: {x: 0, x.rate: 3}\n"

// A wheel whose pin closes the loop: the tree comes to it over the bars.
#define WHEEL_IN_LOOP                                                                                                  \
    "gravity: [0, -9.81]\nbodies:\n"                                                                                   \
    "  ground: {points: {A: [0, 0], E: [0.3, 0]}}\n"                                                                   \
    "  w1: {points: {A: [0, 0], B: [0.1, 0]}, mass: 1, center: [0.02, 0], inertia: 0.01}\n"                            \
    "  w2: {points: {E: [0, 0], D: [0.12, 0]}, mass: 1.5, center: [0.01, 0], inertia: 0.012}\n"                        \
    "  b: {points: {B: [0, 0], C: [0.35, 0]}, mass: 0.7, rod: [B, C]}\n"                                               \
    "  d: {points: {D: [0, 0], C: [0.3, 0]}, mass: 0.6, rod: [D, C]}\n"                                                \
    "joints:\n  A: {pin: [ground, w1], angle: t1}\n  B: {pin: [w1, b], angle: t3}\n"                                   \
    "  C: {pin: [b, d], angle: t4}\n  D: {pin: [d, w2], angle: t2}\n  E: {pin: [ground, w2]}\n"                        \
    "gears: {g: {mesh: [w1, w2], teeth: [20, 40]}}\n"                                                                  \
    "start: {t1: 60 deg, t1.rate: 3, t3: 0, t4: 0, t2: 0}\n"

// A wheel that turns on another, whose pin closes a loop.
#define WHEEL_ON_WHEEL                                                                                                 \
    "gravity: [0, -9.81]\nbodies:\n  ground: {points: {A: [0, 0], B: [0.09, 0]}}\n"                                    \
    "  p: {points: {A: [0, 0], C: [0.02, 0]}, mass: 1, inertia: 0.001}\n"                                              \
    "  bar: {points: {C: [0, 0], D: [0.1, 0]}, mass: 0.4, rod: [C, D]}\n"                                              \
    "  q: {points: {B: [0, 0], D: [0.05, 0]}, mass: 1, inertia: 0.002}\n"                                              \
    "  r: {points: {B: [0, 0]}, mass: 1, inertia: 0.001}\n"                                                            \
    "joints:\n  A: {pin: [ground, p], angle: x}\n  C: {pin: [p, bar], angle: y}\n  D: {pin: [bar, q], angle: z}\n"     \
    "  B: {pin: [ground, q]}\n  R: {pin: [q, r], at: B, angle: w}\n"                                                   \
    "gears: {g: {mesh: [p, r], teeth: [10, 20]}}\nstart: {x: 0.3, x.rate: 2, y: 1, z: 1}\n"

// A cam on a shaft, and a follower on a guide, that close loops: only the bars between them are in the tree.
#define CAM_IN_LOOP                                                                                                    \
    LIFT "gravity: [0, -9.81]\nbodies:\n  ground: {points: {K: [0, 0], P: [0.1, 0.2], O: [-0.1, 0]}}\n"                \
         "  shaft: {points: {K: [0, 0], L: [0.07, 0]}, mass: 1, inertia: 0.002}\n"                                     \
         "  crank: {points: {O: [0, 0], M: [0.04, 0]}, mass: 1, inertia: 0.002}\n"                                     \
         "  link: {points: {M: [0, 0], L: [0.1, 0]}, mass: 1, inertia: 0.002}\n"                                       \
         "  tappet: {points: {T: [0, 0]}, mass: 0.2, center: [0.01, 0], inertia: 0.001}\n"                             \
         "  rod: {points: {T: [0, 0], Q: [0.16, 0]}, mass: 0.1, rod: [T, Q]}\n"                                        \
         "  lever: {points: {P: [0, 0], Q: [0.1, 0]}, mass: 0.1, rod: [P, Q]}\n"                                       \
         "joints:\n  O: {pin: [ground, crank], angle: o}\n  M: {pin: [crank, link], angle: m}\n"                       \
         "  L: {pin: [link, shaft], angle: l}\n  K: {pin: [ground, shaft]}\n"                                          \
         "  P: {pin: [ground, lever], angle: c}\n  Q: {pin: [lever, rod], angle: b}\n  T: {pin: [rod, tappet], "       \
         "angle: tt}\n"                                                                                                \
         "  G: {slide: [ground, tappet], along: y}\n"                                                                  \
         "cams: {valve: {cam: shaft, follower: tappet, law: lift, roller: 10 mm, base: 30 mm, offset: 5 mm}}\n"        \
         "start: {o: 40 deg, o.rate: 5, m: -40 deg, l: 20 deg, c: 170 deg, b: 80 deg, tt: 120 deg}\n"

static const char *const machines[] = {
    GEARED_FIVE_BAR,
    RACK,
    RACK_BACKWARDS,
    CAM,
    FLAT,
    FOLLOW,
    PLANETARY_SET,
    PLANETARY_LINKAGE,
    BELT,
    CAM_ON_ARM,
    CAM_BACKWARDS,
    ROCKER("[ground, rocker]", "at: P"),
    ROCKER("[rocker, ground]", "at: P"),
    ROCKER("[ground, rocker]", "arm: 80 mm"),
    ROCKER("[ground, rocker]",
           "at: P, conjugate: {arm: 75 mm, angle: 80 deg}") "efforts: {phi: 3 N*m * sin(20*theta)}\n",
    TAPPET_OF_TWO,
    FOLLOW_ANGLE("z", "x"),
    FOLLOW_ANGLE("x", "z"),
    COAXIAL,
    SLANTED,
    WHEEL_IN_LOOP,
    FOLLOW_DISTANCE,
    WHEEL_ON_WHEEL,
    CAM_IN_LOOP,
    PLANETS_ON_PLATE,
    PLANETS_IN_PAIRS};
enum { MACHINES = sizeof machines / sizeof *machines };

static void they_do_the_work_that_the_relation_asks_for(void **state)
{
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine_of(machines[k]);
        const YkDeriveForces *f = forces_of(&m);
        for (size_t c = 0; c < m.d->coordinate_count; c++)
            if (!yk_derive_do_methods_agree(f, c)) {
                print_error("%s\n%s\n", machines[k], m.d->coordinates[c].name);
                fail();
            }
        assert_true(yk_derivation_is_well(m.d));
        machine_end(&m);
    }
}

static void every_line_holds_with_the_engines_forces(void **state)
{
    (void)state;
    size_t lines = 0, poses = 0;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine_of(machines[k]);
        YkDynamics *dynamics = dynamics_of(&m);
        size_t own = 0;
        forces_of(&m);
        write_section(&m, "free-bodies");
        write_section(&m, "newton-euler");
        write_section(&m, "lagrange");
        for (int turn = 0; turn < 8; turn++) {
            if (!random_pose(&m, turn == 0)) continue;
            if (!take_forces(&m, dynamics, turn % 2 ? YK_METHOD_NEWTON_EULER : YK_METHOD_REDUCED)) continue;
            lines += check_page(&m, machines[k], 1e-12);
            own++;
        }
        if (own < 2) print_error("%s\n%s", machines[k], yk_state_report(m.state)->message);
        assert_true(own >= 2);
        poses += own;
        yk_dynamics_free(dynamics);
        machine_end(&m);
    }
    assert_true(lines > 1500 && poses > 60);
}

static void they_print_and_read_back(void **state)
{
    (void)state;
    size_t count = 0;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine_of(machines[k]);
        write_section(&m, "free-bodies");
        write_section(&m, "newton-euler");
        write_section(&m, "lagrange");
        count += check_page_reads_back(&m);
        check_formats(&m, "Test", NULL);
        machine_end(&m);
    }
    assert_true(count > 2000);
}

// The text with its lengths of many digits as parameters: as decimals their products are too long to be exact.
static void name_lengths(const char *text, YkText *named)
{
    YkText body = {0};
    size_t count = 0;
    yk_text_puts(named, "parameters: {one: 1");
    for (const char *c = text; *c;) {
        size_t length = strspn(c, "0123456789.");
        if (length > 0 && c[length] == 'e' && c[length + 1] == '-') length += 2 + strspn(c + length + 2, "0123456789");
        bool is_name = c > text && (c[-1] == '_' || (c[-1] >= 'a' && c[-1] <= 'z') || (c[-1] >= 'A' && c[-1] <= 'Z'));
        if (length < 8 || is_name || c[length] == ' ') {
            length = length ? length : 1;
            yk_text_add(&body, c, length);
        } else {
            yk_text_format(named, ", len%z: ", ++count);
            yk_text_add(named, c, length);
            yk_text_format(&body, "len%z", count);
        }
        c += length;
    }
    yk_text_format(named, "}\n%s", yk_text_get(&body));
    assert_false(named->failed || body.failed);
    yk_text_free(&body);
}

// Random linkages with all of these between links that loops place; joints close loops anywhere.
static void random_linkages_are_proved_and_hold(void **state)
{
    (void)state;
    static Geared linkage;
    size_t lines = 0, proved = 0;
    for (uint64_t number = 0; number < 60; number++) {
        geared_machine(&linkage, number);
        YkText named = {0};
        name_lengths(linkage.text, &named);
        Machine m = machine_of(yk_text_get(&named));
        yk_text_free(&named);
        const YkDeriveForces *f = yk_derive_forces(m.d);
        if (!f && yk_ring_status(m.d->ring) == YK_RING_OVERFLOW) { // an angle or a law of too many digits
            machine_end(&m);
            continue;
        }
        assert_non_null(f);
        for (size_t c = 0; c < m.d->coordinate_count; c++, proved++)
            if (!yk_derive_do_methods_agree(f, c)) {
                print_error("%s\n%s\n", linkage.text, m.d->coordinates[c].name);
                fail();
            }
        YkDynamics *dynamics = dynamics_of(&m);
        write_section(&m, "newton-euler");
        write_section(&m, "lagrange");
        for (int turn = 0; turn < 3; turn++)
            if (random_pose(&m, turn == 0) && m.state->space.margin[0] > 0.02 && // not where forces grow beyond all
                take_forces(&m, dynamics, (YkMethod)(turn % 2)))
                lines += check_page(&m, linkage.text, 1e-10);
        yk_dynamics_free(dynamics);
        machine_end(&m);
    }
    assert_true(proved > 200 && lines > 1000);
}

// What a student derives by hand: with names for the forces, multipliers and angles that the pages use.
static void equations_by_hand_are_decided(void **state)
{
    (void)state;
    static const struct {
        const char *machine, *equation;
        YkCheckKind kind;
    } cases[] = {
        {SLANTED, "0.3 x'' = 2 - Z1 r_g N12 cos(alpha12)", YK_CHECK_TRUE},
        {SLANTED, "0.3 x'' = 2 + Z1 r_g N12 cos(alpha12)", YK_CHECK_FALSE},
        {SLANTED, "r_g^2 (Z1 + Z2)^2 = u^2 + v^2", YK_CHECK_TRUE},
        {SLANTED, "Z1 x'' = -Z2 y''", YK_CHECK_TRUE},
        {SLANTED, "Z2 x'' = -Z1 y''", YK_CHECK_FALSE},
        {SLANTED, "lambda1 = r_g N12 cos(alpha12)", YK_CHECK_TRUE},
        {SLANTED, "lambda1 = r_g N12 sin(alpha12)", YK_CHECK_FALSE},
        {BELT, "0.3 x'' = 2 + 0.1 T12", YK_CHECK_TRUE},
        {BELT, "0.7 y'' = -0.25 T12", YK_CHECK_FALSE},
        {RACK, "s'' = F12", YK_CHECK_TRUE},
        {RACK, "s'' = -F12", YK_CHECK_FALSE},
        {CAM_ON_ARM, "tan(phi23)*(h_c + s) = lift_v + 0.045 + 0.02", YK_CHECK_FALSE},
        {CAM_ON_ARM, "lambda1 = -N23 cos(phi23)", YK_CHECK_TRUE},
        {COAXIAL, "0.2 s'' = 2 + 20 T12", YK_CHECK_TRUE},
        {COAXIAL, "0.3 c'' + 0.1 (c'' + p'') = -50 T12 + 30 T12", YK_CHECK_TRUE},
        {FOLLOW_ANGLE("z", "x"), "0.3 x'' = -swing_v T23", YK_CHECK_TRUE},
        {FOLLOW_ANGLE("z", "x"), "0.3 x'' = swing_v T23", YK_CHECK_FALSE},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        Machine m = machine_of(cases[k].machine);
        YkDynamics *dynamics = dynamics_of(&m);
        assert_true(yk_state_assemble(m.state) >= 0);
        YkCheckVerdict verdict = yk_derive_check(m.d, m.state, dynamics, cases[k].equation, strlen(cases[k].equation),
                                                 (YkPlace){1, 1, 0}, m.problems);
        if (verdict.kind != cases[k].kind) print_error("%s: %d\n", cases[k].equation, (int)verdict.kind);
        assert_int_equal(verdict.kind, cases[k].kind);
        yk_dynamics_free(dynamics);
        machine_end(&m);
    }
}

// With links as parameters, an equation of motion of a geared linkage is proved for all dimensions.
static void an_equation_of_a_geared_five_bar_is_proved(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {a: 0.1, b: 0.35, c: 0.3, d: 0.12, e: 0.3, m: 0.7, J: 0.01, z1: 20, z2: 40}\n"
                           "bodies:\n  ground: {points: {A: [0, 0], E: [e, 0]}}\n"
                           "  w1: {points: {A: [0, 0], B: [a, 0]}, mass: 1, inertia: J}\n"
                           "  w2: {points: {E: [0, 0], D: [d, 0]}, mass: 1, inertia: J}\n"
                           "  b: {points: {B: [0, 0], C: [b, 0]}, mass: m, rod: [B, C]}\n"
                           "  d: {points: {D: [0, 0], C: [c, 0]}, mass: m, rod: [D, C]}\n"
                           "joints:\n  A: {pin: [ground, w1], angle: t1}\n  E: {pin: [ground, w2], angle: t2}\n"
                           "  B: {pin: [w1, b], angle: t3}\n  D: {pin: [w2, d], angle: t4}\n  C: {pin: [b, d]}\n"
                           "gears: {g: {mesh: [w1, w2], teeth: [z1, z2]}}\n"
                           "start: {t1: 60 deg, t2: 100 deg, t3: 0, t4: 0, t1.rate: 3}\n");
    YkDynamics *dynamics = dynamics_of(&m);
    const YkDeriveForces *f = forces_of(&m);
    for (size_t k = 0; k < m.d->coordinate_count; k++) {
        YkText text = {0};
        YkDeriveLagrange sides = yk_derive_lagrange_of(f, k);
        yk_ring_write(m.d->ring, sides.left, YK_RING_TEXT, YK_RING_TEXTBOOK, &text);
        yk_text_puts(&text, " = 0");
        assert_true(yk_state_assemble(m.state) >= 0);
        YkCheckVerdict verdict =
            yk_derive_check(m.d, m.state, dynamics, yk_text_get(&text), text.length, (YkPlace){1, 1, 0}, m.problems);
        assert_int_equal(verdict.kind, YK_CHECK_TRUE);
        assert_false(verdict.is_identity);
        yk_text_free(&text);
    }
    yk_dynamics_free(dynamics);
    machine_end(&m);
}

// The proof is not a formality: with another lever it fails.
static void a_wrong_push_is_no_longer_proved(void **state)
{
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine_of(machines[k]);
        const YkDeriveForces *f = forces_of(&m);
        const YkDeriveMultipliers *multipliers = yk_derive_multipliers(f);
        size_t bad = 0, last = multipliers->count - 1;
        multipliers->identities[last] = yk_ring_scale(m.d->ring, multipliers->identities[last], 2, 1);
        for (size_t c = 0; c < m.d->coordinate_count; c++) bad += !yk_derive_do_methods_agree(f, c);
        assert_true(bad > 0);
        machine_end(&m);
    }
}

static void a_pair_of_gears_prints_as_in_the_books(void **state)
{
    (void)state;
    Machine m = example("epicyclic");
    write_section(&m, "free-bodies");
    write_section(&m, "newton-euler");
    write_section(&m, "lagrange");
    check_says(&m, "N12 is the force between these gears at their pitch point Q1, along their line of action.");
    check_says(&m, "alpha12 is the pressure angle of 20 deg with the sign of N12");
    check_says(&m, "F_42 + N_12 - N_23 = 0\n");
    check_says(&m, "p^{Q1/P} x N_12 - p^{Q2/P} x N_23 = 0\n");
    check_says(&m, "moments about O:  tau_theta1 - 1/2 N1 mod N12 cos(alpha12) = 0\n");
    check_says(&m, "theta1:  N1 lambda1 = tau_theta1\n");
    check_says(&m, "sun-planet:  lambda1 = 1/2 mod N12 cos(alpha12)\n");
    machine_end(&m);
    m = example("valve-cam");
    write_section(&m, "newton-euler");
    check_says(&m, "angle of the normal:  1/40 (1 + 40 s) sin(phi12) = lift_v cos(phi12)\n");
    check_says(&m, "4 force + 2 moment + 1 acceleration = 7 equations; 5 reactions + 1 accelerations + 1 efforts = 7");
    machine_end(&m);
}

// Behind the gears come the racks; P, Q, ... as the file leaves them free.
static void pitch_points_have_one_name_in_all_sections(void **state)
{
    (void)state;
    Machine m =
        machine_of("parameters: {r: 0.1}\n"
                   "bodies: {ground: {points: {A: [0.3, 0]}}, a: {}, b: {points: {A: [0, 0], P7: [1, 0]}}, bar: {}}\n"
                   "joints:\n"
                   "  O: {pin: [ground, a], angle: t1}\n"
                   "  A: {pin: [ground, b], angle: t2}\n"
                   "  R: {slide: [ground, bar], along: x, distance: x}\n"
                   "racks: {rail: {pinion: a, rack: bar, radius: r}}\n"
                   "gears: {pair: {mesh: [a, b], teeth: [20, 40]}}\n");
    write_section(&m, "gears");
    write_section(&m, "free-bodies");
    check_says(&m, "v_Q2 = omega_a x p^{Q2/O}");
    check_says(&m, "Q2 is the pitch point: there the pinion's circle touches the rack.");
    check_says(&m, "rail: F13 is the force between pinion and rack at their pitch point Q2, along the rack.");
    check_says(&m, "by bar at Q2:");
    machine_end(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(they_do_the_work_that_the_relation_asks_for),
        cmocka_unit_test(every_line_holds_with_the_engines_forces),
        cmocka_unit_test(they_print_and_read_back),
        cmocka_unit_test(random_linkages_are_proved_and_hold),
        cmocka_unit_test(equations_by_hand_are_decided),
        cmocka_unit_test(an_equation_of_a_geared_five_bar_is_proved),
        cmocka_unit_test(a_wrong_push_is_no_longer_proved),
        cmocka_unit_test(a_pair_of_gears_prints_as_in_the_books),
        cmocka_unit_test(pitch_points_have_one_name_in_all_sections),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
