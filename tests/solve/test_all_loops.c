// Three equal cranks on one bar, and a block that slides on the bar and up and down: where crank and bar are in line
// two of the cranks alone could fold, and rates come from all loops together, those of a wheel in mesh with a crank
// too. In closed form the bar only translates.
#include "machine.h"

#define MACHINE                                                                                                        \
    "parameters: {from: 1 rad}\nbodies:\n  ground: {points: {O: [0, 0], Q: [3, 0], P: [2, 1.5], G: [2, 0], W: [5, "    \
    "0]}}\n  a: "                                                                                                      \
    "{points: {O: [0, 0], A: [0.8, "                                                                                   \
    "0]}}\n"                                                                                                           \
    "  b: {points: {A: [0, 0], B: [3, 0], D: [2, 1.5]}}\n  c: {points: {Q: [0, 0], B: [0.8, 0]}}\n"                    \
    "  d: {points: {P: [0, 0], D: [0.8, 0]}}\n  block: {points: {S: [0, 0]}}\n  w: {points: {W: [0, 0]}}\njoints:\n"   \
    "  O: {pin: [ground, a], angle: th}\n  Q: {pin: [ground, c], angle: ps}\n  P: {pin: [ground, d], angle: ph}\n"     \
    "  A: {pin: [a, b], angle: u}\n  B: {pin: [b, c]}\n  D: {pin: [b, d]}\n"                                           \
    "  G: {slide: [ground, block], along: y, from: G, to: S, distance: y}\n"                                           \
    "  S: {pin-slot: [b, block], along: x, from: A, at: S}\n"                                                          \
    "  W: {pin: [ground, w], angle: we}\ngears: {g: {mesh: [c, w], teeth: [20, 30]}}\n"                                \
    "start: {th: from, ps: from, ph: from, u: -from, y: 0.8 m * sin(from)}\n"

static const char by_crank[] = MACHINE "drives: {th: from}\n", by_block[] = MACHINE "drives: {y: 0.8 m * sin(from)}\n";

static void check_pose(const Machine *m, double theta, double w, double a)
{
    const double r = 0.8, c = cos(theta), s = sin(theta);
    const struct {
        const char *name;
        double value[3];
    } truth[] = {{"th", {theta, w, a}},
                 {"ps", {theta, w, a}},
                 {"ph", {theta, w, a}},
                 {"b.angle", {0, 0, 0}},
                 {"we", {-theta / 1.5, -w / 1.5, -a / 1.5}}, // for each turn of its crank two thirds of one
                 {"y", {r * s, r * c * w, r * (c * a - s * w * w)}},
                 {"S.distance", {2 - r * c, r * s * w, r * (s * a + c * w * w)}}};
    for (size_t k = 0; k < sizeof truth / sizeof *truth; k++) {
        static const char *const orders[] = {"%s", "%s.rate", "%s.accel"};
        for (int order = 0; order < 3; order++) {
            char name[40];
            snprintf(name, sizeof name, orders[order], truth[k].name);
            double off = machine_ask(m, name) - truth[k].value[order];
            if (order == 0 && k < 5) off = remainder(off, k < 4 ? 2 * YK_PI : 2 * YK_PI / 3);
            if (!(fabs(off) <= 1e-8)) print_error("%s at %.17g: off by %.3g\n", name, theta, off);
            CHECK_NEAR(off, 0, 1e-8);
        }
    }
}

// On the fold, and as close to it as the dyads alone would lose half their digits.
static void check_folds(const char *text)
{
    bool is_by_block = text == by_block;
    static const double beside[] = {0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-4, 1e-3, 0.01};
    for (int fold = -2; fold <= 2; fold++)
        for (size_t k = 0; k < sizeof beside / sizeof *beside; k++)
            for (int side = -1; side <= 1; side += 2) {
                double theta = fold * YK_PI + side * beside[k], w = 1.3, a = -0.7;
                char from[40];
                snprintf(from, sizeof from, "%.17g rad",
                         fold * YK_PI + side); // the branch that goes on as a parallelogram
                YkOverride override = {.name = "from", .value = from};
                Machine m = machine_parse_with(text, &override, 1);
                assert_true(yk_state_assemble(m.state) >= 0);
                double y = 0.8 * sin(theta), v = 0.8 * cos(theta) * w, z = 0.8 * (cos(theta) * a - sin(theta) * w * w);
                YkStatus status = is_by_block ? machine_solve(&m, y, v, z) : machine_solve(&m, theta, w, a);
                assert_int_equal(status, YK_REDUNDANT);
                assert_true(yk_state_has_rates(m.state));
                check_pose(&m, theta, w, a);
                YkResiduals r = yk_state_residuals(m.state);
                CHECK_NEAR(r.position, 0, 1e-12);
                CHECK_NEAR(r.velocity, 0, 1e-10);
                CHECK_NEAR(r.acceleration, 0, 1e-9);
                machine_free(&m);
            }
}

static void rates_on_a_fold_are_those_of_all_loops(void **unused)
{
    (void)unused;
    check_folds(by_crank);
}

static void so_they_are_where_a_distance_drives(void **unused)
{
    (void)unused;
    check_folds(by_block);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rates_on_a_fold_are_those_of_all_loops),
        cmocka_unit_test(so_they_are_where_a_distance_drives),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
