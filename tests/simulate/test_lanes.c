// Copies in lanes: against a simulation of each alone, and against closed forms.
#include "run.h"

enum { COPIES = 67, MOST = 8 }; // no whole number of blocks

typedef struct Copies {
    YkLanes *lanes;
    double state[2 * MOST][COPIES], effort[MOST][COPIES], time[COPIES];
    double *states[2 * MOST];
    const double *efforts[MOST];
    signed char status[COPIES];
} Copies;

static YkSimulationOptions fixed(double step)
{
    YkSimulationOptions options = run_options(1e-9);
    options.integrator = YK_INTEGRATOR_RK4;
    options.step = step;
    return options;
}

static YkLanesCase case_of(Copies *c)
{
    return (YkLanesCase){c->states, c->efforts, c->time, c->status};
}

// Copies that begin where the simulation stands, without efforts of their own.
static void begin(Copies *c, Run *run)
{
    bool fits = false;
    *c = (Copies){.lanes = yk_lanes_new(run->sim, &fits)};
    assert_true(fits);
    assert_non_null(c->lanes);
    const YkState *state = yk_simulation_state(run->sim);
    for (size_t i = 0; i < yk_lanes_input_count(c->lanes); i++)
        for (size_t k = 0; k < COPIES; k++) {
            c->state[2 * i][k] = yk_state_input(state, i).position;
            c->state[2 * i + 1][k] = yk_state_input(state, i).velocity;
        }
    for (size_t r = 0; r < 2 * MOST; r++) c->states[r] = c->state[r];
}

static size_t input_of(const Run *run, const char *name)
{
    const YkMechanism *mech = yk_state_mechanism(yk_simulation_state(run->sim));
    return (size_t)yk_coordinate_info(mech, yk_coordinate_find(mech, name)).input;
}

static void step_all(Copies *c, double span)
{
    YkLanesCase asked = case_of(c);
    assert_int_equal(yk_lanes_step(c->lanes, &asked, 0, COPIES, span), YK_OK);
}

#define ARMS                                                                                                           \
    "gravity: [0.3, -9.81]\nbodies:\n  ground: {points: {G: [0, 0]}}\n"                                                \
    "  cart: {points: {O: [0.1, 0.2]}, mass: 2}\n"                                                                     \
    "  upper: {points: {O: [0, 0], W: [0.4, 0.1]}, mass: 1, inertia: 0.02, center: [0.2, 0.03]}\n"                     \
    "  side: {points: {W: [0.1, 0], A: [0.15, 0.1]}, mass: 0.3, inertia: 0.001, center: [0.05, 0.01]}\n"               \
    "  lower: {points: {A: [0.05, 0], T: [0.3, 0]}, mass: 1, rod: [A, T]}\n"
static const char *const trees[] = {
    // a cart, two arms, one of them reversed, a weld
    ARMS "joints:\n  R: {slide: [ground, cart], along: x, distance: x, friction: {viscous: 0.7}}\n"
         "  O: {pin: [cart, upper], angle: a}\n  W: {weld: [upper, side], turned: 20 deg}\n"
         "  A: {pin: [lower, side], angle: b}\n"
         "springs: {k: {along: b, stiffness: 3, angle: 20 deg, damping: 0.1}}\n"
         "efforts: {x: 1.5}\nstart: {a: 20 deg, b: -60 deg, x.rate: 0.4, b.rate: 3}\n",
    // pins in slots: of the parent, and of the link
    ARMS "joints:\n  R: {slide: [cart, ground], along: 30 deg, distance: x}\n"
         "  O: {pin-slot: [cart, upper], from: O, at: O, along: y, angle: a, distance: u}\n"
         "  W: {weld: [upper, side]}\n"
         "  A: {pin-slot: [lower, side], from: T, at: A, along: x, angle: b, distance: v}\n"
         "start: {a: 20 deg, b: 50 deg, x: 0.1, u: 0.2, v: 0.3, a.rate: 1, b.rate: -2, u.rate: 0.5, v.rate: 0.1}\n",
};

// Each moves for some spans, with a cut step, and efforts that change; the simulation takes the same steps alone.
static void a_copy_moves_as_a_simulation_does_alone(void **unused)
{
    (void)unused;
    static Copies c;
    for (size_t tree = 0; tree < sizeof trees / sizeof *trees; tree++) {
        Run run = run_of_text(trees[tree], fixed(0.004));
        begin(&c, &run);
        for (int s = 0; s < 30; s++) {
            step_all(&c, 0.01);
            assert_int_equal(yk_simulation_step(run.sim, 0.01), YK_OK);
        }
        const YkState *state = yk_simulation_state(run.sim);
        for (size_t i = 0; i < yk_lanes_input_count(c.lanes); i++) {
            YkMotion m = yk_state_input(state, i);
            for (size_t k = 0; k < COPIES; k += 33) {
                CHECK_NEAR(c.state[2 * i][k], m.position, 1e-11);
                CHECK_NEAR(c.state[2 * i + 1][k], m.velocity, 1e-10);
            }
        }
        CHECK_NEAR(c.time[COPIES - 1], 0.3, 1e-14);
        yk_lanes_free(c.lanes);
        run_free(&run);
    }
}

#define BLOCK                                                                                                          \
    "bodies:\n  ground: {points: {O: [0, 0]}}\n  block: {points: {P: [0.1, 0.05]}, mass: 2}\n"                         \
    "joints:\n  R: {slide: [ground, block], along: x, distance: x}\n"

// One step of x'' = -w^2 x multiplies (x, x' / w) by the Taylor polynomial of exp(i w h) of degree 4.
static void an_oscillator_takes_the_steps_of_the_polynomial(void **unused)
{
    (void)unused;
    static Copies c;
    Run run = run_of_text(BLOCK "springs: {k: {along: x, stiffness: 50, length: 0.2}}\nefforts: {x: 0}\n", fixed(0.01));
    begin(&c, &run);
    double w = 5, z = w * 0.01, re = 1 - z * z / 2 + z * z * z * z / 24, im = z - z * z * z / 6, x[COPIES], y[COPIES];
    for (size_t k = 0; k < COPIES; k++) {
        c.effort[0][k] = 2.0 * (double)k; // rests at 0.2 + effort / 50
        c.state[0][k] = 0.01 * (double)k;
        c.state[1][k] = -0.3;
        x[k] = c.state[0][k] - 0.2 - c.effort[0][k] / 50;
        y[k] = c.state[1][k] / w;
    }
    c.efforts[0] = c.effort[0];
    for (int s = 0; s < 10; s++) step_all(&c, 0.05);
    for (size_t k = 0; k < COPIES; k++) {
        for (int s = 0; s < 50; s++) {
            double before = x[k];
            x[k] = re * before + im * y[k];
            y[k] = re * y[k] - im * before;
        }
        CHECK_NEAR(c.state[0][k], 0.2 + c.effort[0][k] / 50 + x[k], 1e-12);
        CHECK_NEAR(c.state[1][k], w * y[k], 1e-11);
    }
    yk_lanes_free(c.lanes);
    run_free(&run);
}

// theta'^2 / 2 - (3 g / 2 l) cos theta of a rod is constant, up to the method's error; far beyond one turn too.
static void a_pendulum_keeps_its_energy(void **unused)
{
    (void)unused;
    static Copies c;
    Run run = run_of_text("gravity: [0, -9.81]\nbodies:\n  ground: {points: {O: [0, 0]}}\n"
                          "  rod: {points: {O: [0, 0], A: [0, -0.5]}, mass: 2, rod: [O, A]}\n"
                          "joints:\n  O: {pin: [ground, rod], angle: q}\n",
                          fixed(0.001));
    begin(&c, &run);
    double before[COPIES], k2 = 1.5 * 9.81 / 0.5;
    for (size_t k = 0; k < COPIES; k++) {
        c.state[0][k] = k == 40 ? 3e5 : 0.1 * (double)k; // beyond the range of the fast sine
        c.state[1][k] = 0.2 * (double)k;
        before[k] = 0.5 * c.state[1][k] * c.state[1][k] - k2 * cos(c.state[0][k]);
    }
    step_all(&c, 2);
    for (size_t k = 0; k < COPIES; k++)
        CHECK_NEAR(0.5 * c.state[1][k] * c.state[1][k] - k2 * cos(c.state[0][k]), before[k], k == 40 ? 1e-6 : 1e-8);
    yk_lanes_free(c.lanes);
    run_free(&run);
}

static void a_copy_has_the_same_bits_whatever_the_others_do(void **unused)
{
    (void)unused;
    static Copies all, alone;
    Run run = run_of_text(trees[0], fixed(0.004));
    begin(&all, &run);
    for (size_t k = 0; k < COPIES; k++) all.state[2][k] = 0.1 * (double)k;
    alone = all;
    alone.lanes = all.lanes;
    for (size_t r = 0; r < 2 * MOST; r++) alone.states[r] = alone.state[r];
    YkLanesCase asked = case_of(&alone);
    alone.status[3] = YK_LIMIT; // stands still
    for (size_t k = 0; k < COPIES; k++) yk_lanes_step(all.lanes, &asked, k, k + 1, 0.1);
    size_t x = input_of(&run, "x");
    all.efforts[x] = all.effort[x];
    for (size_t k = 0; k < COPIES; k++) all.effort[x][k] = k == 5 ? NAN : 1.5; // the file's own effort, but for one
    asked = case_of(&all);
    assert_int_equal(yk_lanes_step(all.lanes, &asked, 0, COPIES, 0.1), YK_BAD_ARGUMENT);
    assert_true(alone.time[3] == 0 && alone.state[2][3] == 0.1 * 3 && all.status[5] == YK_BAD_ARGUMENT);
    assert_true(all.time[5] == 0 && all.state[2][5] == 0.1 * 5);
    for (size_t k = 0; k < COPIES; k++)
        for (size_t r = 0; r < 6 && k != 3 && k != 5; r++) assert_true(all.state[r][k] == alone.state[r][k]);
    for (double bad = -1; bad > -3; bad--)
        assert_int_equal(yk_lanes_step(all.lanes, &asked, 0, COPIES, bad < -1 ? NAN : bad), YK_BAD_ARGUMENT);
    yk_lanes_free(all.lanes);
    run_free(&run);
}

// A copy that runs away keeps its last finite state, and the others go on.
static void a_copy_that_cannot_go_on_stands_still(void **unused)
{
    (void)unused;
    static Copies c;
    Run run = run_of_text(trees[0], fixed(0.004));
    begin(&c, &run);
    c.state[3][7] = 1e200;
    YkLanesCase asked = case_of(&c);
    assert_int_equal(yk_lanes_step(c.lanes, &asked, 0, COPIES, 0.1), YK_NOT_CONVERGED);
    assert_true(c.status[7] == YK_NOT_CONVERGED && c.state[3][7] == 1e200 && c.time[7] == 0);
    assert_true(c.status[6] == YK_OK && c.status[8] == YK_OK && c.state[2][6] == c.state[2][8]);
    CHECK_NEAR(c.time[8], 0.1, 1e-15);
    yk_lanes_free(c.lanes);
    run_free(&run);
}

static void a_machine_that_does_not_fit_is_refused(void **unused)
{
    (void)unused;
    static const char *const more[] = {
        "efforts: {x: 2 N/s * t}\n",
        "stops: {x: [-1, 1]}\n",
        "drives: {x: 0.1 m/s * t}\n",
        "forces: {f: {body: block, at: P, value: [1, 0]}}\n",
        "springs: {s: {between: [ground.O, block.P], stiffness: 3, length: 0.01}}\n",
    };
    bool fits;
    for (size_t k = 0; k < sizeof more / sizeof *more; k++) {
        char text[600];
        snprintf(text, sizeof text, "%s%s", BLOCK, more[k]);
        Run run = run_of_text(text, fixed(0.01));
        fits = true;
        assert_null(yk_lanes_new(run.sim, &fits));
        assert_false(fits);
        run_free(&run);
    }
    Run loop = run_of_example("crank-press", fixed(0.01)), other = run_of_text(BLOCK, run_options(1e-9));
    assert_null(yk_lanes_new(loop.sim, &fits));
    assert_false(fits);
    fits = true;
    assert_null(yk_lanes_new(other.sim, &fits));
    assert_false(fits);
    run_free(&other);
    run_free(&loop);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_copy_moves_as_a_simulation_does_alone),
        cmocka_unit_test(an_oscillator_takes_the_steps_of_the_polynomial),
        cmocka_unit_test(a_pendulum_keeps_its_energy),
        cmocka_unit_test(a_copy_has_the_same_bits_whatever_the_others_do),
        cmocka_unit_test(a_copy_that_cannot_go_on_stands_still),
        cmocka_unit_test(a_machine_that_does_not_fit_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
