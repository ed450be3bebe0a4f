// Motion through positions where two branches meet, on the branch that momentum takes; and past dead points.
#include "base/problems.h"
#include "base/vec.h"
#include "parallelogram.h"
#include "run.h"

// N parallelograms move as one angle: I phi'' = W sin(phi). Rows to 18 digits (validation case IFT-A2).
static void parallelograms_stay_parallelograms(void **unused)
{
    (void)unused;
    static const double rows[][3] = {{1, -0.195020301949435094, -0.980799205662173833},
                                     {5, -0.811310461005107412, -0.584615545348975548},
                                     {10, 0.328458111540815379, 0.944518538178600962},
                                     {20, 0.839746574306843547, 0.542978536352884662}};
    Run run = run_of_example("n-four-bar", run_options(1e-11));
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        assert_int_equal(yk_simulation_advance(run.sim, rows[k][0]), YK_OK);
        CHECK_NEAR(run_value(&run, "link0.B0.x"), rows[k][1], 1e-7);
        CHECK_NEAR(run_value(&run, "link0.B0.y"), rows[k][2], 1e-7);
        CHECK_NEAR(run_value(&run, "rod2.angle"), 0, 1e-9); // no coupler ever turns
    }
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-8);
    run_free(&run);
}

// A slider-crank whose first coordinate in the file is the slide: it comes to its dead points twice a turn.
static void dead_points_of_a_coordinate_are_passed(void **unused)
{
    (void)unused;
    const char *text =
        "bodies:\n  ground: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0], A: [0.1, 0]}, mass: 2, inertia: 0.01, "
        "center: [0, 0]}\n"
        "  rod: {points: {A: [0, 0], B: [0.3, 0]}, mass: 0.5, rod: [A, B]}\n  piston: {points: {B: [0, 0]}, mass: 1}\n"
        "joints:\n  R: {slide: [ground, piston], along: x, distance: d}\n  O: {pin: [ground, crank], angle: q}\n"
        "  B: {pin: [piston, rod], angle: p}\n  A: {pin: [crank, rod]}\n"
        "start: {d: 0.33, q: 60 deg, p: 160 deg, q.rate: 20 rad/s}\n";
    Run run = run_of_text(text, run_options(1e-11));
    for (int k = 1; k <= 50; k++) assert_int_equal(yk_simulation_advance(run.sim, 0.05 * k), YK_OK);
    assert_true(run_value(&run, "q") > 40); // several turns
    YkSimulationSummary s = yk_simulation_summary(run.sim);
    assert_true(s.recoordinations >= 1 && s.energy_error < 1e-8 && s.worst_residual < 1e-13);
    double q = run_value(&run, "q"), d = run_value(&run, "d"); // and it is the same assembly
    CHECK_NEAR(d, 0.1 * cos(q) + sqrt(0.09 - 0.01 * sin(q) * sin(q)), 1e-12);
    size_t count = yk_simulation_happening_count(run.sim); // one for each half turn of the crank
    assert_int_equal(count, (size_t)(q / YK_PI));
    Run again = run_of_text(text, run_options(1e-11));
    for (size_t k = 0; k < count; k++) { // where crank and rod are in line
        YkHappening happening = yk_simulation_happening(run.sim, k);
        assert_int_equal(happening.kind, YK_HAPPENING_DEAD_POINT);
        assert_string_equal(happening.name, "d");
        assert_int_equal(yk_simulation_advance(again.sim, happening.time), YK_OK);
        CHECK_NEAR(run_value(&again, "q"), YK_PI * (double)(k + 1), 1e-8);
    }
    run_free(&again);
    run_free(&run);
}

// A kite of equal neighbours folds flat: momentum carries it through on the branch it came by.
static void the_motion_is_smooth_through_a_change_point(void **unused)
{
    (void)unused;
    YkSimulationOptions options = run_options(1e-11);
    options.horizon = 2;
    Run run = run_of_example("n-four-bar", options);
    double last[3] = {0, 0, 0}, h = 1e-3;
    for (int k = 0; k <= 600; k++) {
        assert_int_equal(yk_simulation_advance(run.sim, h * k), YK_OK);
        double rate = run_value(&run, "theta1.rate");
        if (k > 1) assert_true(fabs(rate - 2 * last[1] + last[0]) < 200 * h * h); // no kink
        last[0] = last[1];
        last[1] = rate;
    }
    run_free(&run);
}

// All flat where the first link lies on the line of the pivots; there each crossing is told, and angles stay continuous
// though the pose itself does not tell them.
static void change_points_are_told(void **unused)
{
    (void)unused;
    Run run = run_of_example("n-four-bar", run_options(1e-11));
    YkChannel angle = {0};
    const YkMechanism *mech = yk_state_mechanism(yk_simulation_state(run.sim));
    assert_int_equal(yk_channel_parse(mech, "theta0", &angle, NULL), YK_OK);
    assert_int_equal(yk_simulation_watch(run.sim, "flat", angle, 0, 0), YK_OK);
    assert_int_equal(yk_simulation_watch(run.sim, "flat", angle, -YK_PI, 0), YK_OK);
    assert_int_equal(yk_simulation_advance(run.sim, 2), YK_OK);
    double flat[2] = {0}, passed[4] = {0};
    size_t flats = 0, passages = 0;
    for (size_t k = 0; k < yk_simulation_happening_count(run.sim); k++) {
        YkHappening happening = yk_simulation_happening(run.sim, k);
        if (happening.kind == YK_HAPPENING_CROSSING && flats < 2) flat[flats++] = happening.time;
        if (happening.kind == YK_HAPPENING_CHANGE_POINT && passages < 4) passed[passages++] = happening.time;
    }
    assert_true(flats == 2 && passages == 4); // two blocks, twice
    for (size_t k = 0; k < 4; k++) CHECK_NEAR(passed[k], flat[k / 2], 1e-6);
    CHECK_NEAR(run_value(&run, "theta2"), run_value(&run, "theta0"), 1e-9);
    run_free(&run);
}

// The pin of a lever's slot passes the lever's own pivot: with crank and frame of one length the lever turns half as
// fast as the crank, for ever, and so it does in that moment. Rows before it, in it and after it.
static void a_lever_does_not_turn_over_where_the_pin_passes_its_pivot(void **unused)
{
    (void)unused;
    const char *text =
        "bodies:\n  ground: {points: {O: [0, 0], C: [1, 0]}}\n  crank: {points: {O: [0, 0], A: [1, 0]}, mass: 1, "
        "inertia: 1}\n  lever: {points: {C: [0, 0], E: [2, 0]}, mass: 1, inertia: 1}\n"
        "joints:\n  O: {pin: [ground, crank], angle: th}\n  C: {pin: [ground, lever], angle: ps}\n"
        "  A: {pin-slot: [lever, crank], along: x, from: C, at: A}\n"
        "start: {th: 40 deg, ps: 110 deg, th.rate: -1}\n";
    static const YkIntegrator integrators[] = {YK_INTEGRATOR_DOP853, YK_INTEGRATOR_SDIRK4, YK_INTEGRATOR_RK4};
    static const double beside[] = {-0.1,  -1e-2, -2e-3, -1e-4, -1e-6, -1e-9, -1e-12, 0,
                                    1e-16, 1e-12, 1e-9,  1e-6,  1e-4,  2e-3,  1e-2,   0.1};
    double start = 40 * YK_PI / 180, lever = 110 * YK_PI / 180;
    for (size_t k = 0; k < 3; k++) {
        YkSimulationOptions options = run_options(1e-9);
        options.integrator = integrators[k];
        Run run = run_of_text(text, options);
        for (size_t row = 0; row < sizeof beside / sizeof *beside; row++) {
            double t = start + beside[row];
            assert_int_equal(yk_simulation_advance(run.sim, t), YK_OK);
            CHECK_NEAR(run_value(&run, "ps"), lever - 0.5 * t, 1e-10);
            CHECK_NEAR(run_value(&run, "ps.rate"), -0.5, 1e-10);
            CHECK_NEAR(run_value(&run, "ps.accel"), 0, 1e-7);
            CHECK_NEAR(run_value(&run, "lever.E.y"), 2 * sin(lever - 0.5 * t), 1e-10);
            CHECK_NEAR(run_value(&run, "energy"), 0.5 * 1 + 0.5 * 0.25, 1e-10);
            assert_true(yk_state_residuals(yk_simulation_state(run.sim)).position < 1e-12);
        }
        assert_int_equal(yk_simulation_happening_count(run.sim), 1);
        CHECK_NEAR(yk_simulation_happening(run.sim, 0).time, start, 1e-9);
        run_free(&run);
    }
}

// Machines at random that come to a change point or a coincidence while they coast: whatever row is asked for has the
// energy of the start, or the run stops with a status.
static void no_row_is_wrong_near_a_change_point(void **unused)
{
    (void)unused;
    const char *wish = getenv("YOKE_FULL");
    size_t machines = wish ? 20000 : 60, through = 0;
    for (uint64_t k = 1; k <= machines; k++) {
        uint64_t seed = k;
        double a = check_uniform(&seed, 0.3, 2), b = check_uniform(&seed, 0.3, 2), rate = check_uniform(&seed, -3, 3);
        bool slotted = check_random(&seed) % 2;
        char text[1000];
        if (slotted)
            snprintf(text, sizeof text,
                     "bodies: {ground: {points: {O: [0, 0], C: [%.17g, 0]}}, crank: {points: {O: [0, 0], A: [%.17g, "
                     "0]}, mass: 1, inertia: %.17g},\n  lever: {points: {C: [0, 0]}, mass: 1, inertia: 1, center: "
                     "[%.17g, 0.1]}}\n"
                     "joints: {O: {pin: [ground, crank], angle: th}, C: {pin: [ground, lever], angle: ps},\n"
                     "  A: {pin-slot: [lever, crank], along: x, from: C, at: A}}\nstart: {th: %.17g, th.rate: %.17g}\n",
                     a, a, b, b, rate > 0 ? -0.7 : 0.7, rate);
        else
            snprintf(text, sizeof text,
                     "bodies: {ground: {points: {O: [0, 0], Q: [%.17g, 0]}}, crank: {points: {O: [0, 0], A: [%.17g, "
                     "0]}, mass: 1, inertia: 1},\n  coupler: {points: {A: [0, 0], B: [%.17g, 0]}, mass: 1, inertia: 1, "
                     "center: [0.1, 0.3]}, rocker: {points: {Q: [0, 0], B: [%.17g, 0]}, mass: 1, inertia: 1}}\n"
                     "joints: {O: {pin: [ground, crank], angle: th}, A: {pin: [crank, coupler], angle: u},\n"
                     "  Q: {pin: [ground, rocker], angle: v}, B: {pin: [coupler, rocker]}}\n"
                     "start: {th: %.17g, u: %.17g, v: %.17g, th.rate: %.17g}\n",
                     b, a, b, a, rate > 0 ? -0.7 : 0.7, rate > 0 ? 0.7 : -0.7, rate > 0 ? -0.7 : 0.7, rate);
        Run run = run_of_text(text, run_options(1e-10));
        double energy = run_value(&run, "energy"), end = 1.4 / fabs(rate);
        YkStatus status = YK_OK;
        for (int row = 1; row <= 200 && status == YK_OK; row++) {
            status = yk_simulation_advance(run.sim, end * row / 200);
            if (status != YK_OK) break;
            if (fabs(run_value(&run, "energy") - energy) > 1e-6 * energy)
                print_error("seed %d row %d\n%s", (int)k, row, text);
            CHECK_NEAR(run_value(&run, "energy"), energy, 1e-6 * energy);
            assert_true(yk_state_residuals(yk_simulation_state(run.sim)).position < 1e-11);
        }
        through += status == YK_OK;
        run_free(&run);
    }
    assert_true(through > machines * 9 / 10);
}

// A drive alone moves the parallelogram, and rests or turns back exactly where it is flat: whatever is answered is on
// its branch, or the run stops with a status. Where it turns back at once, it goes on. Half of them
// are copied on the way. Couples do their work there, too.
static void drives_that_rest_at_a_change_point_keep_the_branch(void **unused)
{
    (void)unused;
    check_without_sanitizers();
    static const struct {
        const char *law; // of T = t/s, in units of 60 deg around the flat pose
        double start;
        bool is_through;
    } drives[] = {
        {"(t/(1 s) - 1)", -1, true},
        {"(t/(1 s) - 1)^2/3", 1.0 / 3, true},
        {"(t/(1 s) - 1)^2*(t/(1 s) - 2)/2", -1, true},
        {"(t/(1 s) - 1)^3/4", -0.25, false},
        {"(t/(1 s) - 1)^4/17", 1.0 / 17, false},
        {"(t/(1 s) - 1)^5/32", -0.03125, false},
        {"(t/(1 s) - 1)^3*(t/(1 s) - 2)^3/8", 1, false},
        {"max(0, t/(1 s) - 2)^3 - max(0, 1 - t/(1 s))^3", -1, false},
        {"max(0, 1 - t/(1 s))^2 + max(0, t/(1 s) - 2)^3", 1, false},
        {"max(0, 1 - t/(1 s))^2", 1, false},
    };
    for (size_t k = 0; k < sizeof drives / sizeof *drives; k++) {
        char text[1500];
        double theta = 180 + 60 * drives[k].start;
        snprintf(
            text, sizeof text,
            "bodies:\n"
            "  ground:  {points: {O2: [0, 0], O4: [4, 0]}}\n"
            "  crank:   {points: {O2: [0, 0], A: [2, 0]}, mass: 1, inertia: 0.2, center: [1, 0]}\n"
            "  coupler: {points: {A: [0, 0], B: [4, 0]}, mass: 2, inertia: 0.5, center: [2, 0]}\n"
            "  rocker:  {points: {O4: [0, 0], B: [2, 0]}, mass: 1, inertia: 0.2, center: [1, 0]}\n" PARALLELOGRAM_JOINTS
            "gravity: [0, -10]\nsprings: {k: {along: theta2, stiffness: 3, damping: 0.5}}\n"
            "forces: {f: {body: coupler, at: A, value: [2, -1], moment: 0.7}, g: {body: rocker, at: B, value: [0, 0], "
            "moment: 1.5}}\n"
            "drives: {theta2: '180 deg + 60 deg*(%s)'}\nstart: {theta3: %.17g deg, theta4: %.17g deg}\n",
            drives[k].law, -theta, theta);
        Run run = run_of_text(text, run_options(1e-9));
        YkStatus status = YK_OK;
        for (int row = 0; row <= 24 && status == YK_OK; row++) {
            status = yk_simulation_advance(run.sim, row / 8.0);
            if (k % 2 == 1 && row == 4) {
                YkSimulation *copy = yk_simulation_clone(run.sim);
                assert_non_null(copy);
                yk_simulation_free(run.sim);
                run.sim = copy;
            }
            if (status != YK_OK) break;
            double off = run_value(&run, "theta4") - run_value(&run, "theta2");
            double rate = run_value(&run, "theta4.rate") - run_value(&run, "theta2.rate");
            if (!(fabs(off) < 1e-6 && fabs(rate) < 1e-5))
                print_error("%s: row %d off by %g, %g\n", drives[k].law, row, off, rate);
            assert_true(fabs(off) < 1e-6 && fabs(rate) < 1e-5);
        }
        if (drives[k].is_through) assert_int_equal(status, YK_OK);
        if (status == YK_OK) assert_true(yk_simulation_summary(run.sim).energy_error < 1e-6);
        if (status != YK_OK) assert_true(yk_simulation_report(run.sim)->message[0] != 0);
        run_free(&run);
    }
}

// A swing of two arms on a driven cart: where it turns back the machine moves on with the cart, but it has no dead
// point there.
static void a_swing_on_a_driven_cart_has_no_dead_point(void **unused)
{
    (void)unused;
    Run run = run_of_text("gravity: [0, -9.81]\nbodies:\n  ground: {points: {O: [0, 0]}}\n"
                          "  cart: {points: {O: [0, 0], Q: [1, 0]}, mass: 2}\n  a: {points: {O: [0, 0], A: [0, -1]}}\n"
                          "  b: {points: {Q: [0, 0], B: [0, -1]}}\n"
                          "  seat: {points: {A: [0, 0], B: [1, 0]}, mass: 1, center: [0.5, 0], inertia: 0.1}\njoints:\n"
                          "  O: {pin: [cart, a], at: O, angle: q}\n  A: {pin: [a, seat], angle: u}\n"
                          "  Q: {pin: [cart, b], angle: r}\n  B: {pin: [seat, b]}\n"
                          "  S: {slide: [ground, cart], along: x, distance: x}\n"
                          "drives: {x: 1.5 m/s * t}\nstart: {q: 1, u: -1, r: 1}\n",
                          run_options(1e-10));
    for (int row = 1; row <= 10; row++) {
        assert_int_equal(yk_simulation_advance(run.sim, 0.5 * row), YK_OK);
        double q = run_value(&run, "q"), rate = run_value(&run, "q.rate");
        CHECK_NEAR(0.5 * rate * rate, 9.81 * (cos(q) - cos(1)), 1e-8); // as beside a cart at rest
    }
    assert_int_equal(yk_simulation_happening_count(run.sim), 0);
    assert_true(yk_simulation_summary(run.sim).energy_error < 1e-8);
    run_free(&run);
}

// A slider-crank whose crank is 0.3 m long and whose rod `rod`, in gravity.
static Run slider_crank(const char *rod, double rate)
{
    char text[1200];
    snprintf(
        text, sizeof text,
        "gravity: [0, -9.81]\nparameters: {l: %s}\n"
        "bodies:\n  ground: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0], A: [0.3, 0]}, mass: 1, rod: [O, A]}\n"
        "  rod: {points: {A: [0, 0], B: [l, 0]}, mass: 2, rod: [A, B]}\n  piston: {points: {B: [0, 0]}, mass: 3}\n"
        "joints:\n  O: {pin: [ground, crank], angle: th}\n  A: {pin: [crank, rod], angle: ph}\n"
        "  B: {pin: [rod, piston]}\n  S: {slide: [ground, piston], along: x, distance: s}\n"
        "start: {th: 0.5, ph: -1, s: 0.5, th.rate: %g}\n",
        rod, rate);
    return run_of_text(text, run_options(1e-10));
}

// With equal links the rod folds by twice the crank's angle, s = 0.6 m cos(th), through the pose at which the piston
// stands at the crank's pivot. No coordinate is better than the crank's there; the relative angle only turns twice as
// fast.
static void equal_links_pass_their_change_points(void **unused)
{
    (void)unused;
    static const double rates[] = {2, 5.5, 6, 8, 15};
    for (size_t k = 0; k < sizeof rates / sizeof *rates; k++) {
        Run run = slider_crank("0.3", rates[k]);
        for (int row = 0; row <= 60; row++) {
            assert_int_equal(yk_simulation_advance(run.sim, 0.03 * row), YK_OK);
            double th = run_value(&run, "th");
            CHECK_NEAR(run_value(&run, "s"), 0.6 * cos(th), 1e-8);
            CHECK_NEAR(remainder(run_value(&run, "ph") + 2 * th, 2 * YK_PI), 0, 1e-7);
        }
        assert_true(yk_simulation_summary(run.sim).energy_error < 1e-7);
        assert_true(yk_simulation_happening_count(run.sim) >= 1);
        run_free(&run);
    }
}

// The kinetic and potential energy of that slider-crank, from its rates; in the file a point on the rod's axis moves
// with both ends.
static double slider_crank_energy(Run *run, double rod)
{
    double th = run_value(run, "th"), w = run_value(run, "th.rate"), v = run_value(run, "s.rate"), arm = 0.3;
    double ax = -arm * w * sin(th), ay = arm * w * cos(th);           // of the crank's pin
    double cx = 0.5 * (ax + v), cy = 0.5 * ay;                        // of the rod's middle
    double turn = (run_value(run, "ph.rate") + w) * rod;              // of the rod's ends about each other
    double kinetic = 0.5 * arm * arm / 3 * w * w + cx * cx + cy * cy; // masses 1 and 2
    return kinetic + turn * turn / 12 + 1.5 * v * v + 9.81 * (0.5 * arm * sin(th) + arm * sin(th));
}

// Links that differ a little do not reach the change point of equal ones: with the longer rod the piston stays on its
// side of the crank's pivot for ever, and with the shorter one the crank on its side of the line across. The motion
// turns from one branch of the equal links to the other within a hundredth of a radian or less.
static void almost_equal_links_keep_their_circuit(void **unused)
{
    (void)unused;
    static const char *const rods[] = {"0.299", "0.29999", "0.299999", "0.3001", "0.30001", "0.3000001"};
    static const double rates[] = {2, 6, 15};
    for (size_t k = 0; k < 3 * sizeof rods / sizeof *rods; k++) {
        double rod = atof(rods[k / 3]);
        Run run = slider_crank(rods[k / 3], rates[k % 3]);
        double energy = slider_crank_energy(&run, rod);
        for (int row = 1; row <= 40; row++) {
            assert_int_equal(yk_simulation_advance(run.sim, 0.05 * row), YK_OK);
            CHECK_NEAR(slider_crank_energy(&run, rod), energy, 1e-6 * energy);
            assert_true((rod > 0.3 ? run_value(&run, "s") : cos(run_value(&run, "th"))) > 0);
        }
        run_free(&run);
    }
}

// With links still less apart the pose by the change point is not known well enough to go on: that is said, and no row
// from there on is given.
static void a_motion_that_is_not_known_ends(void **unused)
{
    (void)unused;
    static const char *const rods[] = {"0.29999999", "0.2999999", "0.300000001"};
    for (size_t k = 0; k < sizeof rods / sizeof *rods; k++) {
        Run run = slider_crank(rods[k], 6);
        double energy = slider_crank_energy(&run, atof(rods[k]));
        YkStatus status = YK_OK;
        for (int row = 0; row <= 40 && status == YK_OK; row++) {
            status = yk_simulation_advance(run.sim, 0.05 * row);
            if (status == YK_OK) CHECK_NEAR(slider_crank_energy(&run, atof(rods[k])), energy, 1e-3 * energy);
        }
        if (status != YK_OK) assert_true(yk_simulation_report(run.sim)->message[0] != 0);
        run_free(&run);
    }
}

// A crank is driven to where its four-bar does not close any more, at acos(-0.44) to either side; beside it another one
// rests or turns through, before or behind it in the order of solution. The motion ends there, and says at which joint.
static void a_drive_into_a_limit_ends_there(void **unused)
{
    (void)unused;
    static const double rates[] = {1, -1, 0.2, 30};
    for (size_t k = 0; k < 2 * sizeof rates / sizeof *rates; k++) {
        double rate = rates[k / 2], start = 0.5, limit = (rate > 0 ? 1 : -1) * acos(-0.44),
               end = (limit - start) / rate;
        bool is_first = k % 2, rests = k % 4 < 2; // the other crank
        char text[2200];
#define BAR(i, y, a, b, c)                                                                                             \
    "  a" i ": {points: {O" i ": [0, 0], A" i ": [" a ", 0]}, mass: 1, inertia: 1, center: [0, 0]}\n"                  \
    "  b" i ": {points: {A" i ": [0, 0], B" i ": [" b ", 0]}}\n  c" i ": {points: {Q" i ": [0, 0], B" i ": [" c        \
    ", 0]}}\n"
#define PINS(i)                                                                                                        \
    "  O" i ": {pin: [ground, a" i "], angle: t" i "}\n  A" i ": {pin: [a" i ", b" i "], angle: u" i "}\n"             \
    "  Q" i ": {pin: [ground, c" i "], angle: v" i "}\n  B" i ": {pin: [b" i ", c" i "]}\n"
        snprintf(text, sizeof text,
                 "bodies:\n  ground: {points: {O1: [0, 0], Q1: [10, 0], O2: [0, 9], Q2: [10, 9]}}\n"
                 "%s%sjoints:\n%s%sdrives: {t1: 0.5 + %.17g rad/s * t, t2: 0.3 + %.17g rad/s * t}\n"
                 "start: {u1: 1, v1: 2, u2: 1, v2: 2}\n",
                 is_first ? BAR("1", "0", "5", "6", "7") : BAR("2", "9", "2", "9", "8"),
                 is_first ? BAR("2", "9", "2", "9", "8") : BAR("1", "0", "5", "6", "7"),
                 is_first ? PINS("1") : PINS("2"), is_first ? PINS("2") : PINS("1"), rate, rests ? 0 : 0.5 * rate);
        Run run = run_of_text(text, run_options(1e-9));
        YkStatus status = yk_simulation_advance(run.sim, 0.9 * end);
        assert_int_equal(status, YK_OK);
        CHECK_NEAR(run_value(&run, "t1"), start + 0.9 * (limit - start), 1e-9);
        assert_int_equal(yk_simulation_advance(run.sim, 3 * end), YK_LIMIT);
        CHECK_NEAR(yk_simulation_time(run.sim), end, (rests ? 1e-9 : 1e-4) * end); // where two move, it stops before
        assert_true(yk_simulation_time(run.sim) <= end * (1 + 1e-12));
        assert_string_equal(yk_simulation_report(run.sim)->message,
                            "a limit position: beyond, joint `B1` does not close");
        run_free(&run);
    }
}

// Two four-bars that pass dead points of their cranks, beside a pendulum with a gear.
#define FOUR_BAR_POINTS(i, x, end) "      O" i ": [" x ", 0]\n      C" i ": [" end ", 0]\n"
#define FOUR_BAR_BODIES(i)                                                                                             \
    "  crank" i ": {points: {O" i ": [0, 0], A" i ": [1.5, 0]}, mass: 1, rod: [O" i ", A" i "]}\n"                     \
    "  coupler" i ": {points: {A" i ": [0, 0], B" i ": [1.8, 0]}, mass: 1, rod: [A" i ", B" i "]}\n"                   \
    "  rocker" i ": {points: {C" i ": [0, 0], B" i ": [1.2, 0]}, mass: 1, rod: [C" i ", B" i "]}\n"
#define FOUR_BAR_JOINTS(i)                                                                                             \
    "  O" i ": {pin: [ground, crank" i "], angle: theta" i "}\n  A" i ": {pin: [crank" i ", coupler" i                 \
    "], angle: phi" i "}\n  C" i ": {pin: [ground, rocker" i "], angle: psi" i "}\n  B" i ": {pin: [coupler" i         \
    ", rocker" i "]}\n"
#define FOUR_BAR_START(i, angle, rate)                                                                                 \
    "theta" i ": " angle " deg, phi" i ": -50 deg, psi" i ": 100 deg, theta" i ".rate: " rate
#define ALONE(i, x, end, angle, rate)                                                                                  \
    "gravity: [0, -9.81]\nbodies:\n  ground:\n    points:\n" FOUR_BAR_POINTS(i, x, end)                                \
        FOUR_BAR_BODIES(i) "joints:\n" FOUR_BAR_JOINTS(i) "start: {" FOUR_BAR_START(i, angle, rate) "}\n"

static const char *const FIRST = ALONE("1", "0", "2", "60", "2"), *const SECOND = ALONE("2", "3", "5", "65", "2.6"),
                         *const BESIDE = "gravity: [0, -9.81]\nbodies:\n  ground:\n    points:\n" FOUR_BAR_POINTS(
                             "1", "0", "2")
                             FOUR_BAR_POINTS("2", "3", "5") "      P: [8, 0]\n      Q: [9, 0]\n" FOUR_BAR_BODIES("1")
                                 FOUR_BAR_BODIES(
                                     "2") "  bob: {points: {P: [0, 0], T: [0.7, 0]}, mass: 1, rod: [P, T]}\n"
                                          "  idle: {points: {Q: [0, 0]}}\n"
                                          "joints:\n" FOUR_BAR_JOINTS("1") FOUR_BAR_JOINTS(
                                              "2") "  P: {pin: [ground, bob], angle: swing}\n"
                                                   "  Q: {pin: [ground, idle], angle: turn}\n"
                                                   "gears: {pair: {mesh: [bob, idle], teeth: [20, 40], module: 1/30}}\n"
                                                   "start: {" FOUR_BAR_START("1", "60", "2") ", " FOUR_BAR_START(
                                                       "2", "65", "2.6") ", swing: 0.3}\n";

// What a drive turns beside it, though it comes first in the file, does not change how a linkage moves.
static void test_a_driven_body_beside_a_linkage_changes_nothing(void **unused)
{
    (void)unused;
    char text[3000];
    const char *rest = strstr(FIRST, "      O1"), *joints = strstr(FIRST, "joints:\n") + strlen("joints:\n");
    snprintf(text, sizeof text,
             "gravity: [0, -9.81]\nbodies:\n  ground:\n    points:\n      W: [5, 5]\n%.*s"
             "  wheel: {points: {W: [0, 0]}, mass: 1, inertia: 1, center: [0, 0]}\n"
             "joints:\n  W: {pin: [ground, wheel], angle: turn}\n%sdrives: {turn: 2 rad/s * t}\n",
             (int)(joints - strlen("joints:\n") - rest), rest, joints);
    Run beside = run_of_text(text, run_options(1e-11)), alone = run_of_text(FIRST, run_options(1e-11));
    for (int k = 1; k <= 20; k++) {
        assert_true(yk_simulation_advance(beside.sim, 0.1 * k) >= 0 && yk_simulation_advance(alone.sim, 0.1 * k) >= 0);
        CHECK_NEAR(run_value(&beside, "theta1"), run_value(&alone, "theta1"), 1e-7);
        CHECK_NEAR(run_value(&beside, "psi1"), run_value(&alone, "psi1"), 1e-7);
        CHECK_NEAR(run_value(&beside, "turn"), 0.2 * k, 1e-12);
    }
    assert_true(yk_simulation_summary(beside.sim).recoordinations > 0);
    run_free(&beside);
    run_free(&alone);
}

static size_t projected_rates(const char *text)
{
    Run run = run_of_text(text, run_options(1e-9));
    size_t count = 0;
    for (size_t k = 0; k < yk_problems_count(run.problems); k++)
        count += yk_problems_get(run.problems, k)->code == YK_CODE_RATES_PROJECTED;
    run_free(&run);
    return count;
}

// Two rates at the start that fit each other are taken as they are, however slow or fast, and others are not.
static void test_rates_at_the_start_fit_or_are_told(void **unused)
{
    (void)unused;
    for (double rate = 1e-9; rate < 1e10; rate *= 1e3) {
        char text[2500], second[64];
        size_t length = strlen(FIRST) - strlen("2}\n");
        snprintf(text, sizeof text, "%.*s%.17g}\n", (int)length, FIRST, rate);
        Run run = run_of_text(text, run_options(1e-9));
        double psi = run_value(&run, "psi1.rate");
        run_free(&run);
        for (int k = 0; k < 2; k++) {
            snprintf(second, sizeof second, ", psi1.rate: %.17g", (k ? 1.001 : 1) * psi);
            snprintf(text, sizeof text, "%.*s%.17g%s}\n", (int)length, FIRST, rate, second);
            assert_int_equal(projected_rates(text), k ? 2 : 0);
        }
    }
}

// A linkage that swings to and fro stands still as a whole at both ends, in no dead point; those that are told lie
// where coupler and rocker are in line.
static void test_a_swing_that_turns_back_has_no_dead_point(void **unused)
{
    (void)unused;
    const char *text = ALONE("1", "0", "2", "60", "0");
    Run run = run_of_text(text, run_options(1e-9)), again = run_of_text(text, run_options(1e-9));
    size_t stops = 0, dead = 0;
    for (int k = 1; k <= 400; k++) {
        double before = run_value(&run, "psi1.rate");
        assert_int_equal(yk_simulation_advance(run.sim, 0.01 * k), YK_OK);
        stops += before * run_value(&run, "psi1.rate") < 0;
    }
    for (size_t k = 0; k < yk_simulation_happening_count(run.sim); k++) {
        if (yk_simulation_happening(run.sim, k).kind != YK_HAPPENING_DEAD_POINT) continue;
        assert_int_equal(yk_simulation_advance(again.sim, yk_simulation_happening(run.sim, k).time), YK_OK);
        CHECK_NEAR(sin(run_value(&again, "theta1") + run_value(&again, "phi1") - run_value(&again, "psi1")), 0, 1e-6);
        dead++;
    }
    assert_true(stops >= 2 && dead >= 1);
    run_free(&run);
    run_free(&again);
}

static void test_separate_loops_change_their_coordinates_as_each_alone(void **unused)
{
    (void)unused;
    Run both = run_of_text(BESIDE, run_options(1e-11)),
        alone[] = {run_of_text(FIRST, run_options(1e-11)), run_of_text(SECOND, run_options(1e-11))};
    static const char *const names[2][3] = {{"theta1", "phi1", "psi1"}, {"theta2", "phi2", "psi2"}};
    double meshed = run_value(&both, "turn") + 0.5 * run_value(&both, "swing");
    for (int k = 1; k <= 20; k++) {
        assert_true(yk_simulation_advance(both.sim, 0.1 * k) >= 0);
        for (int i = 0; i < 2; i++) {
            assert_true(yk_simulation_advance(alone[i].sim, 0.1 * k) >= 0);
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(run_value(&both, names[i][c]), run_value(&alone[i], names[i][c]), 1e-7);
        }
        CHECK_NEAR(run_value(&both, "turn") + 0.5 * run_value(&both, "swing"), meshed, 1e-9);
    }
    for (int i = 0; i < 2; i++) {
        assert_true(yk_simulation_summary(alone[i].sim).recoordinations > 0);
        run_free(&alone[i]);
    }
    assert_true(yk_simulation_summary(both.sim).recoordinations > 0);
    run_free(&both);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_separate_loops_change_their_coordinates_as_each_alone),
        cmocka_unit_test(test_a_driven_body_beside_a_linkage_changes_nothing),
        cmocka_unit_test(test_a_swing_that_turns_back_has_no_dead_point),
        cmocka_unit_test(test_rates_at_the_start_fit_or_are_told),
        cmocka_unit_test(parallelograms_stay_parallelograms),
        cmocka_unit_test(dead_points_of_a_coordinate_are_passed),
        cmocka_unit_test(change_points_are_told),
        cmocka_unit_test(the_motion_is_smooth_through_a_change_point),
        cmocka_unit_test(a_lever_does_not_turn_over_where_the_pin_passes_its_pivot),
        cmocka_unit_test(no_row_is_wrong_near_a_change_point),
        cmocka_unit_test(drives_that_rest_at_a_change_point_keep_the_branch),
        cmocka_unit_test(a_swing_on_a_driven_cart_has_no_dead_point),
        cmocka_unit_test(a_drive_into_a_limit_ends_there),
        cmocka_unit_test(equal_links_pass_their_change_points),
        cmocka_unit_test(almost_equal_links_keep_their_circuit),
        cmocka_unit_test(a_motion_that_is_not_known_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
