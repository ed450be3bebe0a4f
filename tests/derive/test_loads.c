// Every load of the model file in the equations: as a polynomial, or as a symbol whose meaning is given.
#include "derive/forces/lagrange.h"
#include "forces_check.h"

// Efforts by a law of a rate, by an expression that is not a polynomial; forces in the body's own axes, with a moment;
// springs with dampers between points and along an angle; viscous friction.
#define LEVER                                                                                                          \
    "parameters: {l: 0.4, k: 30, c: 2}\ngravity: [0, -9.81]\n"                                                         \
    "laws:\n  motor: {table: [[-100 rad/s, 5 N*m], [0 rad/s, 3 N*m], [100 rad/s, -5 N*m]]}\nbodies:\n"                 \
    "  ground: {points: {P: [0, 1], O: [0, 0]}}\n"                                                                     \
    "  crank: {points: {P: [0, 0], A: [l, 0]}, mass: 1, inertia: 0.1, center: [l/2, 0]}\n"                             \
    "  block: {points: {A: [0, 0]}, mass: 0.5, inertia: 0.03}\n"                                                       \
    "  lever: {points: {O: [0, 0], T: [0.7, 0.1]}, mass: 1, inertia: 0.2, center: [0.3, 0]}\n"                         \
    "joints:\n  P: {pin: [ground, crank], angle: theta1, friction: {viscous: 0.3}}\n"                                  \
    "  A: {pin: [crank, block]}\n  O: {pin: [ground, lever], angle: theta2}\n"                                         \
    "  S: {slide: [lever, block], along: x, distance: d, friction: {viscous: 2}}\n"                                    \
    "efforts:\n  theta1: {law: motor, of: theta1.rate}\n  d: -5 kg/m * d.rate*abs(d.rate)\n"                           \
    "forces:\n  F1: {body: lever, at: T, value: [-10 N * cos(theta2), 4 N * sin(3 rad/s * t)], axes: body}\n"          \
    "  F2: {body: block, value: [1 N, 2 N], moment: 3 N*m}\n"                                                          \
    "springs:\n  s1: {between: [ground.O, crank.A], stiffness: k, length: 0.3, damping: c}\n"                          \
    "  s2: {along: theta2, stiffness: 2, angle: 0.2, damping: 0.1}\n"                                                  \
    "  s3: {between: [lever.T, crank.A], stiffness: 5}\n"                                                              \
    "start: {theta1: 0.5, theta1.rate: 1, theta2: 1.3}\n"

// A pin in a slot that rubs, a weld, a stop.
#define SLOT                                                                                                           \
    "gravity: [0, -9.81]\nbodies:\n  ground: {points: {O: [0, 0], Q: [0, 0.1]}}\n"                                     \
    "  arm: {points: {O: [0, 0], P: [0.3, 0]}, mass: 1, rod: [O, P]}\n"                                                \
    "  tip: {points: {P: [0, 0], E: [0.1, 0.05]}, mass: 0.4, inertia: 0.002, center: [0.05, 0]}\n"                     \
    "  bar: {points: {Q: [0, 0], R: [0, 0]}, mass: 0.7, inertia: 0.01, center: [0.1, 0]}\n"                            \
    "joints:\n  O: {pin: [ground, arm], angle: a}\n  P: {weld: [arm, tip], turned: 25 deg}\n"                          \
    "  Q: {pin: [ground, bar], angle: b}\n"                                                                            \
    "  R: {pin-slot: [bar, tip], at: E, from: R, along: x, friction: {coulomb: 0.2, viscous: 1}}\n"                    \
    "stops: {a: [-60 deg, 100 deg]}\nefforts: {a: 2 N*m/s * t}\nstart: {a: 40 deg, a.rate: 1, b: 20 deg}\n"

// Springs by laws of their own: polynomials and tables of length, angle and rate; a force by a table.
#define PULLS                                                                                                          \
    "parameters: {l: 0.4, k3: 900 N/m^3, L0: 0.5}\ngravity: [0, -9.81]\nlaws:\n"                                       \
    "  bump: {table: [[0.2, -5], [0.5, 0], [0.7, 4], [1.5, 30]], between: cubic}\n"                                    \
    "  rubber: {table: [[-1, -3], [0, 0], [2, 5]]}\nbodies:\n"                                                         \
    "  ground: {points: {P: [0, 1], O: [0, 0]}}\n"                                                                     \
    "  crank: {points: {P: [0, 0], A: [l, 0]}, mass: 1, inertia: 0.1, center: [l/2, 0]}\n"                             \
    "  block: {points: {A: [0, 0]}, mass: 0.5, inertia: 0.03}\n"                                                       \
    "  lever: {points: {O: [0, 0], T: [0.7, 0.1]}, mass: 1, inertia: 0.2, center: [0.3, 0]}\n"                         \
    "joints:\n  P: {pin: [ground, crank], angle: theta1}\n  A: {pin: [crank, block]}\n"                                \
    "  O: {pin: [ground, lever], angle: theta2}\n  S: {slide: [lever, block], along: x, distance: d}\n"                \
    "forces:\n  F1: {body: lever, at: T, value: [{law: bump, of: d}, 2 N * sin(theta1)], "                             \
    "moment: {law: rubber, of: theta1}}\nsprings:\n"                                                                   \
    "  s1: {between: [ground.O, crank.A], force: k3*(length - L0)^3 + 2 N*s/m * rate, stiffness: 4}\n"                 \
    "  s2: {between: [lever.T, crank.A], force: {law: bump, of: length}}\n"                                            \
    "  s3: {along: theta2, torque: {law: rubber, of: angle}, damping: 0.1}\n"                                          \
    "  s4: {along: d, force: 30 N/m * (length - 0.2 m) + 1 kg/m * rate*abs(rate)}\n"                                   \
    "start: {theta1: 0.5, theta1.rate: 1, theta2: 1.3}\n"

// A free joint between bodies that move, with loads along all its coordinates.
#define FREE                                                                                                           \
    "gravity: [0.4, -9.81]\nbodies:\n  ground: {points: {O: [0.1, 0.2], P: [0, 1]}}\n"                                 \
    "  arm: {points: {O: [0, 0], K: [0.5, 0.1]}, mass: 1.1, center: [0.2, 0.05], inertia: 0.07}\n"                     \
    "  plate: {points: {A: [-0.3, 0.1], B: [0.3, 0.1], C: [0.05, -0.1]}, mass: 2, center: [0.02, 0.03], inertia: "     \
    "0.1}\n"                                                                                                           \
    "  bob: {points: {B: [0, 0], E: [0, -0.2]}, mass: 0.5, center: [0, -0.2], inertia: 0.01}\n"                        \
    "  tip: {points: {E: [0, 0]}, mass: 0.3, center: [0.1, 0.1], inertia: 0.02}\njoints:\n  O: {pin: [ground, arm], "  \
    "angle: q}\n  F: {free: [arm, plate], at: [x, y, phi], from: K, to: C}\n"                                          \
    "  B: {pin: [plate, bob], angle: psi}\n  E: {pin: [bob, tip], angle: chi}\n"                                       \
    "springs:\n  a: {between: [ground.P, plate.A], stiffness: 100, length: 0.2}\n"                                     \
    "  c: {along: x, stiffness: 30, length: 0.1, damping: 2}\n  d: {along: y, force: 50 N/m^3 * length^3}\n"           \
    "  e: {along: phi, stiffness: 3, damping: 0.2}\nefforts: {x: 3 N - 1 N*s/m * y.rate, phi: 0.5 N*m * cos(phi)}\n"   \
    "start: {q: 0.3, q.rate: 0.4, x: 0.5, y: 0.4, phi: 0.2, x.rate: 0.3, y.rate: -0.2, phi.rate: 0.7}\n"

// More joints than are added up in the angles of the last bodies, with welds in their midst, forwards and backwards.
#define BODY(ON, NAME, PLACE)                                                                                          \
    "  " NAME ": {points: {" ON ": [0, 0], " NAME ": [0.3, 0.1]}, mass: 1, center: [0.1, 0.02], inertia: " PLACE "}\n"
#define CHAIN                                                                                                          \
    "gravity: [0, -9.81]\nbodies:\n  ground: {points: {g: [0, 0]}}\n" BODY("g", "a", "0.1") BODY("a", "b", "0.1")      \
        BODY("b", "c", "0.2") BODY("c", "d", "0.3") BODY("d", "e", "0.1") BODY("e", "f", "0.2") BODY("f", "h", "0.1")  \
            BODY("h", "i", "0.1") "joints:\n  g: {pin: [ground, a], angle: q1}\n  a: {pin: [b, a], angle: q2}\n"       \
                                  "  b: {pin: [b, c], angle: q3}\n  c: {pin: [c, d], angle: q4}\n"                     \
                                  "  d: {weld: [e, d], turned: 25 deg}\n  e: {weld: [e, f], turned: 40 deg}\n"         \
                                  "  f: {pin: [f, h], angle: q5}\n  h: {pin: [h, i], angle: q6}\n"                     \
                                  "forces: {F: {body: i, at: i, value: [2 N, 3 N], axes: body}}\n"                     \
                                  "start: {q1: 0.3, q2: 0.2, q3: -0.5, q4: 0.4, q5: 0.7, q6: -0.2}\n"

static const char *const machines[] = {LEVER, SLOT, PULLS, FREE, CHAIN};

static void every_line_holds_and_reads_back(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof machines / sizeof *machines; k++) {
        Machine m = machine_of(machines[k]);
        const YkDeriveForces *f = forces_of(&m);
        YkDynamics *dynamics = dynamics_of(&m);
        size_t poses = 0;
        write_section(&m, "free-bodies");
        write_section(&m, "newton-euler");
        write_section(&m, "energy");
        write_section(&m, "lagrange");
        for (int turn = 0; turn < 8; turn++) {
            if (!random_pose(&m, turn == 0)) continue;
            if (!take_forces(&m, dynamics, turn % 2 ? YK_METHOD_NEWTON_EULER : YK_METHOD_REDUCED)) continue;
            assert_true(check_page(&m, machines[k], 1e-12) > 20);
            poses++;
        }
        assert_true(poses > 3);
        for (size_t c = 0; c < m.d->coordinate_count; c++) assert_true(yk_derive_do_methods_agree(f, c));
        assert_true(check_page_reads_back(&m) > 50);
        yk_dynamics_free(dynamics);
        machine_end(&m);
    }
}

// Angles of bodies are shown by those of the joints, or by that of a body before them: the engine's, but for whole
// turns.
static void angles_of_bodies_add_up_over_pins_and_welds(void **state)
{
    (void)state;
    Machine m = machine_of(CHAIN);
    forces_of(&m);
    write_section(&m, "newton-euler");
    size_t seen = 0;
    for (int turn = 0; turn < 6; turn++) {
        if (!random_pose(&m, turn == 0)) continue;
        for (const YkLine *line = m.page.first; line; line = line->next)
            for (size_t b = 1; line->text && line->value && !line->left && b < m.model->body_count; b++) {
                if (strcmp(line->text, m.model->bodies[b].name) != 0) continue;
                double off = remainder(at_pose(&m, line->value) - yk_state_body(m.state, b).position, 2 * YK_PI);
                CHECK_NEAR(off, 0, 1e-12);
                seen++;
            }
    }
    assert_true(seen >= 20);
    machine_end(&m);
}

static void loads_that_are_no_polynomials_tell_what_they_are(void **state)
{
    (void)state;
    Machine m = machine_of(LEVER);
    write_section(&m, "lagrange");
    check_says(&m, "tau_theta1 is what the law motor gives, a function of theta1'.");
    check_says(&m, "F_d stands for the file's expression, a function of d'.");
    machine_end(&m);
    m = machine_of(PULLS);
    write_section(&m, "lagrange");
    check_says(&m, "F_s2 is what the law bump gives, a function of L_s2.");
    check_says(&m, "tau_s3 is what the law rubber gives, a function of theta2.");
    check_says(&m, "F_s4 stands for the file's expression, a function of d', d.");
    machine_end(&m);
    m = machine_of(SLOT);
    write_section(&m, "newton-euler");
    check_says(&m, "R_R is what dry friction or a stop at R exerts");
    check_says(&m, "S_O is what dry friction or a stop at O exerts");
    machine_end(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_line_holds_and_reads_back),
        cmocka_unit_test(angles_of_bodies_add_up_over_pins_and_welds),
        cmocka_unit_test(loads_that_are_no_polynomials_tell_what_they_are),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
