// The same machine moved, turned, mirrored, measured in other units, written in another order, run backwards: its
// answers map back to 1e-12.
#include "machine.h"

// A quick-return and a four-bar on one crank, so that every kind of dyad takes part. (X, Y): moved; phi: turned; m =
// -1: mirrored; k: all lengths.
#define HEAD                                                                                                           \
    "parameters: {X: 0, Y: 0, phi: 0, m: 1, k: 1, c: cos(phi), s: sin(phi), a1: k, l1: 3/4*k, l2: 7/4*k, l4: 2/3*k}\n" \
    "bodies:\n"
#define GROUND                                                                                                         \
    "  ground:  {points: {O1: [X - s*m*a1, Y + c*m*a1], O2: [X, Y], C0: [X - 2*s*m*a1, Y + 2*c*m*a1],"                 \
    " O4: [X + 2.5*c*k - s*m*a1, Y + 2.5*s*k + c*m*a1]}}\n"
#define CRANK "  crank:   {points: {O1: [0, 0], A: [l1, 0], D: [0.4*k, 0.3*k*m]}}\n"
#define LEVER "  lever:   {points: {O2: [0, 0], B: [l2, 0]}}\n"
#define BLOCK "  block:   {points: {A: [0, 0]}}\n"
#define COUPLER "  coupler: {points: {B: [0, 0], C: [l4, 0]}}\n"
#define RAM "  ram:     {points: {C: [0, 0]}}\n"
#define BAR "  bar:     {points: {D: [0, 0], E: [2*k, 0.1*k*m], P: [k, k*m]}}\n"
#define ROCKER "  rocker:  {points: {O4: [0, 0], E: [1.5*k, 0]}}\n"
#define TREE                                                                                                           \
    "  O1: {pin: [ground, crank], angle: theta1}\n"                                                                    \
    "  O2: {pin: [ground, lever], angle: theta2}\n"                                                                    \
    "  S:  {slide: [lever, block], along: x, distance: d3}\n"                                                          \
    "  B:  {pin: [lever, coupler], angle: theta4}\n"                                                                   \
    "  R:  {slide: [ground, ram], along: phi, from: C0, distance: d5}\n"                                               \
    "  D:  {pin: [crank, bar], angle: delta}\n"                                                                        \
    "  O4: {pin: [ground, rocker], angle: epsilon}\n"
#define CLOSING                                                                                                        \
    "  A:  {pin: [crank, block]}\n"                                                                                    \
    "  C:  {pin: [coupler, ram]}\n"                                                                                    \
    "  E:  {pin: [bar, rocker]}\n"
#define START                                                                                                          \
    "start: {theta1: phi + m*0.5, theta2: phi + m*1.1, d3: 1.5*k, theta4: -m*0.35, d5: 1.2*k, delta: -m*0.5, "         \
    "epsilon: "                                                                                                        \
    "phi + m*2}\n"

static const char in_order[] = HEAD GROUND CRANK LEVER BLOCK COUPLER RAM BAR ROCKER "joints:\n" TREE CLOSING START;
static const char in_another_order[] =
    HEAD ROCKER BAR GROUND RAM BLOCK COUPLER LEVER CRANK "joints:\n" CLOSING TREE START;
static const char in_millimetres[] =
    "units: {length: mm}\n" HEAD GROUND CRANK LEVER BLOCK COUPLER RAM BAR ROCKER "joints:\n" TREE CLOSING START;

// How answers of the changed machine map to those of the first.
typedef struct Change {
    double x, y, phi, mirror, scale, time;
} Change;
static const Change none = {0, 0, 0, 1, 1, 1};

static const char *const turned[] = {"theta1", "theta2", "epsilon", "bar.angle", "coupler.angle"}; // against the ground
static const char *const relative[] = {"theta4", "delta"};
static const char *const lengths[] = {"d3", "d5"};
static const char *const points[] = {"bar.P", "ram.C", "block.A", "rocker.E", "coupler.C"};

static YkMotion ask(const Machine *m, const char *name)
{
    char text[64];
    YkMotion q;
    q.position = machine_ask(m, name);
    snprintf(text, sizeof text, "%s.rate", name);
    q.velocity = machine_ask(m, text);
    snprintf(text, sizeof text, "%s.accel", name);
    q.acceleration = machine_ask(m, text);
    return q;
}

static void check_motion(YkMotion found, YkMotion due, bool is_angle, double unit)
{
    CHECK_NEAR(is_angle ? angle_between(found.position, due.position) : found.position - due.position, 0, 1e-12 * unit);
    CHECK_NEAR(found.velocity, due.velocity, 1e-12 * (unit + fabs(due.velocity)));
    CHECK_NEAR(found.acceleration, due.acceleration, 1e-11 * (unit + fabs(due.acceleration)));
}

static YkMotion mapped(YkMotion q, double factor, double offset, double time)
{
    return (YkMotion){factor * q.position + offset, time * factor * q.velocity, factor * q.acceleration};
}

static void check_points(const Machine *a, const Machine *b, Change c)
{
    double co = cos(c.phi), si = sin(c.phi);
    for (size_t k = 0; k < sizeof points / sizeof points[0]; k++) {
        char name[64];
        snprintf(name, sizeof name, "%s.x", points[k]);
        YkMotion x = ask(a, name), bx = ask(b, name);
        snprintf(name, sizeof name, "%s.y", points[k]);
        YkMotion y = ask(a, name), by = ask(b, name);
        x = mapped(x, c.scale, 0, c.time);
        y = mapped(y, c.scale * c.mirror, 0, c.time);
        YkMotion dx = {c.x + co * x.position - si * y.position, co * x.velocity - si * y.velocity,
                       co * x.acceleration - si * y.acceleration};
        YkMotion dy = {c.y + si * x.position + co * y.position, si * x.velocity + co * y.velocity,
                       si * x.acceleration + co * y.acceleration};
        check_motion(bx, dx, false, c.scale);
        check_motion(by, dy, false, c.scale);
    }
}

static void check_pose(const Machine *a, const Machine *b, Change c)
{
    for (size_t k = 0; k < sizeof turned / sizeof turned[0]; k++)
        check_motion(ask(b, turned[k]), mapped(ask(a, turned[k]), c.mirror, c.phi, c.time), true, 1);
    for (size_t k = 0; k < sizeof relative / sizeof relative[0]; k++)
        check_motion(ask(b, relative[k]), mapped(ask(a, relative[k]), c.mirror, 0, c.time), true, 1);
    for (size_t k = 0; k < sizeof lengths / sizeof lengths[0]; k++)
        check_motion(ask(b, lengths[k]), mapped(ask(a, lengths[k]), c.scale, 0, c.time), false, c.scale);
    check_points(a, b, c);
}

// `text` with the parameters of the change against the first machine, over the range in which it closes.
static void check_change(const char *text, Change c, double k)
{
    static const char *const names[] = {"X", "Y", "phi", "m", "k"};
    const double values[] = {c.x, c.y, c.phi, c.mirror, k};
    char words[5][40];
    YkOverride overrides[5];
    for (size_t i = 0; i < 5; i++) {
        snprintf(words[i], sizeof words[i], "%.17g", values[i]);
        overrides[i] = (YkOverride){names[i], words[i]};
    }
    Machine a = machine_parse(in_order, true), b = machine_parse_with(text, overrides, 5);
    assert_true(yk_state_assemble(b.state) >= 0);
    for (int pose = 0; pose <= 100; pose++) {
        double theta = 0.1 + 2.9 * pose / 100;
        YkStatus one = machine_solve(&a, theta, 1.5, -0.5);
        YkStatus two = machine_solve(&b, c.phi + c.mirror * theta, c.time * c.mirror * 1.5, -c.mirror * 0.5);
        assert_int_equal(one, YK_OK);
        assert_int_equal(two, YK_OK);
        check_pose(&a, &b, c);
    }
    machine_free(&a);
    machine_free(&b);
}

static void test_a_machine_that_is_moved(void **unused)
{
    (void)unused;
    Change c = none;
    c.x = 1.7;
    c.y = -0.9;
    check_change(in_order, c, 1);
}

static void test_a_machine_that_is_turned(void **unused)
{
    (void)unused;
    for (double phi = -3; phi < 7; phi += 0.83) {
        Change c = none;
        c.phi = phi;
        check_change(in_order, c, 1);
    }
}

static void test_a_machine_in_the_mirror(void **unused)
{
    (void)unused;
    Change c = none;
    c.mirror = -1;
    check_change(in_order, c, 1);
    c.phi = 1.2;
    c.x = 0.3;
    check_change(in_order, c, 1);
}

static void test_a_machine_of_another_size(void **unused)
{
    (void)unused;
    static const double sizes[] = {1e-6, 1e-3, 0.37, 25, 1e4};
    for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; k++) {
        Change c = none;
        c.scale = sizes[k];
        check_change(in_order, c, sizes[k]);
    }
}

static void test_a_machine_given_in_millimetres(void **unused)
{
    (void)unused;
    check_change(in_millimetres, none, 1000);
}

static void test_a_machine_written_in_another_order(void **unused)
{
    (void)unused;
    check_change(in_another_order, none, 1);
}

static void test_a_machine_run_backwards(void **unused)
{
    (void)unused;
    Change c = none;
    c.time = -1;
    check_change(in_order, c, 1);
}

// A joint whose sides change places: its angle is the negative, all else is as before.
static void test_a_joint_written_the_other_way_round(void **unused)
{
    (void)unused;
    static const char swapped[] = HEAD GROUND CRANK LEVER BLOCK COUPLER RAM BAR ROCKER
        "joints:\n"
        "  O1: {pin: [crank, ground], angle: theta1}\n"
        "  O2: {pin: [lever, ground], angle: theta2}\n"
        "  S:  {slide: [block, lever], along: x, distance: d3}\n"
        "  B:  {pin: [coupler, lever], angle: theta4}\n"
        "  R:  {slide: [ground, ram], along: phi, from: C0, distance: d5}\n"
        "  D:  {pin: [bar, crank], angle: delta}\n"
        "  O4: {pin: [rocker, ground], angle: epsilon}\n" CLOSING
        "start: {theta1: -0.5, theta2: -1.1, d3: -1.5, theta4: 0.35, d5: 1.2, delta: 0.5, epsilon: -2}\n";
    Machine a = machine_parse(in_order, true), b = machine_parse(swapped, true);
    static const char *const negative[] = {"theta1", "theta2", "theta4", "delta", "epsilon"};
    for (int pose = 0; pose <= 100; pose++) {
        double theta = 0.1 + 2.9 * pose / 100;
        assert_int_equal(machine_solve(&a, theta, 1.5, -0.5), YK_OK);
        assert_int_equal(machine_solve(&b, -theta, -1.5, 0.5), YK_OK);
        for (size_t k = 0; k < 5; k++)
            check_motion(ask(&b, negative[k]), mapped(ask(&a, negative[k]), -1, 0, 1), true, 1);
        check_motion(ask(&b, "d3"), mapped(ask(&a, "d3"), -1, 0, 1), false, 1); // the lever in the block's axes
        check_points(&a, &b, none);
    }
    machine_free(&a);
    machine_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_machine_that_is_moved),
        cmocka_unit_test(test_a_machine_that_is_turned),
        cmocka_unit_test(test_a_machine_in_the_mirror),
        cmocka_unit_test(test_a_machine_of_another_size),
        cmocka_unit_test(test_a_machine_given_in_millimetres),
        cmocka_unit_test(test_a_machine_written_in_another_order),
        cmocka_unit_test(test_a_machine_run_backwards),
        cmocka_unit_test(test_a_joint_written_the_other_way_round),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
