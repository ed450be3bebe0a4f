// Many linkages that two drives bring to their change points at once: each finds its side by itself, yet the cost must
// not multiply from one to the next.
#include "../solve/machine.h"
#include <yoke/move.h>

enum { LINKAGES = 12, TEXT = 8192 };

// Parallelograms on one crank, which stands on an arm that turns too; side by side, or each on the rocker of the one
// before.
static void write_machine(char *text, bool is_chain)
{
    int n = snprintf(text, TEXT, "bodies:\n  ground: {points: {O: [0, 0]");
#define ADD(...) (n += snprintf(text + n, TEXT - (size_t)n, __VA_ARGS__))
    for (int k = 0; k < LINKAGES; k++) ADD(", O%d: [%d, 0]", k, 4 * (k + 1));
    ADD("}}\n  arm: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0]");
    for (int k = 0; k < (is_chain ? 1 : LINKAGES); k++) ADD(", A%d: [2, 0]", k);
    ADD("}}\n");
    for (int k = 0; k < LINKAGES; k++) {
        ADD("  c%d: {points: {A%d: [0, 0], B%d: [%d, 0]}}\n", k, k, k, is_chain ? 4 : 4 * (k + 1));
        ADD("  r%d: {points: {O%d: [0, 0], B%d: [2, 0], A%d: [2, 0]}}\n", k, k, k, k + 1);
    }
    ADD("joints:\n  Oa: {pin: [ground, arm], at: O, angle: theta1}\n  Oc: {pin: [arm, crank], at: O, angle: theta2}\n");
    for (int k = 0; k < LINKAGES; k++) {
        if (is_chain && k > 0)
            ADD("  A%d: {pin: [r%d, c%d], angle: phi%d}\n", k, k - 1, k, k);
        else
            ADD("  A%d: {pin: [crank, c%d], angle: phi%d}\n", k, k, k);
        ADD("  B%d: {pin: [c%d, r%d]}\n  O%d: {pin: [ground, r%d], angle: y%d}\n", k, k, k, k, k, k);
    }
    ADD("drives: {theta1: 0.2 rad + 1.3 rad/s * t, theta2: 0.3 rad - 2 rad/s * t}\nstart: {");
    for (int k = 0; k < LINKAGES; k++) ADD("%sphi%d: -0.5 rad, y%d: 0.5 rad", k ? ", " : "", k, k);
    ADD("}\n");
#undef ADD
    assert_true(n < TEXT);
}

// Two more parallelograms, each on the rocker before it by a small angle, so that their change points lie close
// together: whichever is found first, and by whatever, each keeps its own sides.
static void test_change_points_close_together(void **unused)
{
    (void)unused;
    const double mean = 0.0006915812077210475, by[4] = {0, -0.0003664950312011648, -0.00030669039211176193};
    char text[TEXT], name[8];
    int n = snprintf(text, TEXT,
                     "bodies:\n  ground: {points: {O: [0, 0], O0: [4, 0], O1: [8, 0], O2: [12, 0]}}\n"
                     "  arm: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0], A0: [2, 0]}}\n");
#define ADD(...) (n += snprintf(text + n, TEXT - (size_t)n, __VA_ARGS__))
    for (int k = 0; k < 3; k++) {
        double next = k < 2 ? by[k + 1] : 0;
        ADD("  c%d: {points: {A%d: [0, 0], B%d: [4, 0]}}\n", k, k, k);
        ADD("  r%d: {points: {O%d: [0, 0], B%d: [2, 0], A%d: [%.17g, %.17g]}}\n", k, k, k, k + 1, 2 * cos(next),
            2 * sin(next));
    }
    ADD("joints:\n  Oa: {pin: [ground, arm], at: O, angle: theta1}\n  Oc: {pin: [arm, crank], at: O, angle: theta2}\n"
        "  A0: {pin: [crank, c0], angle: phi0}\n  A1: {pin: [r0, c1], angle: phi1}\n  A2: {pin: [r1, c2], angle: "
        "phi2}\n");
    for (int k = 0; k < 3; k++)
        ADD("  B%d: {pin: [c%d, r%d]}\n  O%d: {pin: [ground, r%d], angle: y%d}\n", k, k, k, k, k, k);
    ADD("drives:\n  theta1: '0.2 rad - 1.5 rad/s * t + 0.7 rad * sin(0.6*t/(1 s))'\n"
        "  theta2: '%.17g rad + 0.5 rad * cos(2.6*t/(1 s)) - 0.2 rad + 1.5 rad/s * t - 0.7 rad * sin(0.6*t/(1 "
        "s))'\nstart: {",
        mean);
    double y = mean + 0.5;
    for (int k = 0; k < 3; y += by[++k])
        ADD("%sphi%d: %.17g, y%d: %.17g", k ? ", " : "", k, -(k ? y - by[k] : y), k, y + 0.0);
    ADD("}\n");
#undef ADD
    for (int steps = 1; steps <= 20; steps++) {
        Machine m = machine_parse(text, true);
        for (int k = 1; k <= steps; k++) {
            double t = 3.0 * k / steps, sum = mean + 0.5 * cos(2.6 * t);
            assert_int_equal(yk_state_move_time(m.state, t, NULL, NULL, m.problems), YK_OK);
            for (int i = 0; i < 3; i++) {
                snprintf(name, sizeof name, "y%d", i);
                sum += by[i];
                CHECK_NEAR(machine_ask(&m, name), sum, 1e-6);
            }
        }
        machine_free(&m);
    }
}

static bool goes_on(void *context, double part)
{
    size_t *asked = context;
    (void)part;
    return ++*asked < 500; // slices of work: before, seven linkages took thousands
}

static void check(bool is_chain)
{
    char text[TEXT], name[8];
    write_machine(text, is_chain);
    Machine m = machine_parse(text, true);
    size_t asked = 0;
    yk_state_set_progress(m.state, (YkProgress){goes_on, &asked});
    for (int k = 1; k <= 4; k++) { // the crank, at 0.5 - 0.7 t, goes through 0 in the second step
        double t = 0.5 * k;
        assert_int_equal(yk_state_move_time(m.state, t, NULL, NULL, m.problems), YK_OK);
        for (int i = 0; i < LINKAGES; i++) {
            snprintf(name, sizeof name, "y%d", i);
            CHECK_NEAR(machine_ask(&m, name), 0.5 - 0.7 * t, 1e-9);
        }
    }
    machine_free(&m);
}

static void test_linkages_beside_each_other(void **unused)
{
    (void)unused;
    check(false);
}

static void test_linkages_behind_each_other(void **unused)
{
    (void)unused;
    check(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_linkages_beside_each_other),
        cmocka_unit_test(test_linkages_behind_each_other),
        cmocka_unit_test(test_change_points_close_together),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
