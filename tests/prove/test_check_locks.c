// Verdicts under a lock: what it holds stands still, in proofs as at poses.
#include "verdicts.h"

static Machine locked(const char *text, const char *lock)
{
    Machine m = {.problems = yk_problems_new(), .seed = 7};
    YkLoadOptions options = yk_default_load_options();
    options.lock = lock;
    m.model = yk_model_parse(text, strlen(text), "test", &options, m.problems);
    if (machine_finish(&m)) return m;
    print_error("%s\n", yk_problems_text(m.problems, 0));
    fail();
    return m;
}

static void check_under(const char *text, const char *lock, const Expected *expected, size_t count)
{
    Machine m = locked(text, lock);
    check_kinds(&m, expected, count);
    machine_end(&m);
}
#define CHECK_UNDER(text, lock, ...)                                                                                   \
    check_under(text, lock, (const Expected[]){__VA_ARGS__}, sizeof((const Expected[]){__VA_ARGS__}) / sizeof(Expected))

static const char planetary[] = "parameters: {Zs: 20, Zp: 7, Zr: 34, mod: 2 mm}\n"
                                "bodies: {sun: {}, planet: {}, ring: {}, arm: {points: {P: [mod*(Zs + Zp)/2, 0]}}}\n"
                                "joints:\n"
                                "  S: {pin: [ground, sun], angle: s}\n"
                                "  R: {pin: [ground, ring], angle: r}\n"
                                "  C: {pin: [ground, arm], angle: c}\n"
                                "  P: {pin: [arm, planet]}\n"
                                "gears:\n"
                                "  a: {mesh: [sun, planet], teeth: [Zs, Zp], module: mod}\n"
                                "  b: {mesh: [planet, ring], teeth: [Zp, Zr], module: mod, internal: true}\n"
                                "locks: {ring: [ring], sun: [sun], arm: [arm], direct: {join: [[sun, arm]]}}\n";

// The six ratios of the simplest planetary set, each under its own lock only.
static void a_planetary_set_has_the_ratio_of_its_lock(void **state)
{
    (void)state;
    static const char ring[] = "s' Zs = c' (Zs + Zr)", sun[] = "r' Zr = c' (Zs + Zr)", arm[] = "s' Zs = -r' Zr",
                      direct[] = "s' = r'", still[] = "r' = 0", never_starts[] = "r'' = 0";
    CHECK_UNDER(planetary, NULL, {ring, YK_CHECK_FALSE}, {sun, YK_CHECK_FALSE}, {arm, YK_CHECK_FALSE},
                {direct, YK_CHECK_FALSE}, {still, YK_CHECK_FALSE});
    CHECK_UNDER(planetary, "ring", {ring, YK_CHECK_TRUE}, {sun, YK_CHECK_FALSE}, {arm, YK_CHECK_FALSE},
                {direct, YK_CHECK_FALSE}, {still, YK_CHECK_TRUE}, {never_starts, YK_CHECK_TRUE});
    CHECK_UNDER(planetary, "sun", {ring, YK_CHECK_FALSE}, {sun, YK_CHECK_TRUE}, {arm, YK_CHECK_FALSE},
                {still, YK_CHECK_FALSE}, {never_starts, YK_CHECK_FALSE});
    CHECK_UNDER(planetary, "arm", {ring, YK_CHECK_FALSE}, {sun, YK_CHECK_FALSE}, {arm, YK_CHECK_TRUE});
    CHECK_UNDER(planetary, "direct", {ring, YK_CHECK_FALSE}, {direct, YK_CHECK_TRUE}, {"s'' = c''", YK_CHECK_TRUE});
}

// A five-bar of two freedoms: with its second crank held it is a four-bar.
static void a_held_crank_makes_a_five_bar_a_four_bar(void **state)
{
    (void)state;
    static const char five_bar[] = "parameters: {a: 0.5, b: 1.5, c: 1.4, d: 0.6, e: 1.2}\n"
                                   "bodies:\n"
                                   "  ground: {points: {O: [0, 0], Q: [e, 0]}}\n"
                                   "  left: {points: {O: [0, 0], A: [a, 0]}}\n"
                                   "  upper: {points: {A: [0, 0], B: [b, 0]}}\n"
                                   "  lower: {points: {C: [0, 0], B: [c, 0]}}\n"
                                   "  right: {points: {Q: [0, 0], C: [d, 0]}}\n"
                                   "joints:\n"
                                   "  O: {pin: [ground, left], angle: t1}\n"
                                   "  A: {pin: [left, upper]}\n"
                                   "  Q: {pin: [ground, right], angle: t4}\n"
                                   "  C: {pin: [right, lower]}\n"
                                   "  B: {pin: [upper, lower]}\n"
                                   "locks: {brake: {hold: [t4]}}\n"
                                   "start: {t1: 2, t4: 1}\n";
    static const char speeds[] = "c sin(lower.angle - upper.angle) lower.rate = a sin(t1 - upper.angle) t1'",
                      accelerations[] = "c sin(lower.angle - upper.angle) lower.accel"
                                        " + c cos(lower.angle - upper.angle) lower.rate^2 - b upper.rate^2"
                                        " = a sin(t1 - upper.angle) t1'' + a cos(t1 - upper.angle) t1'^2",
                      closing[] = "a cos(t1) + b cos(upper.angle) = e + d cos(t4) + c cos(lower.angle)";
    CHECK_UNDER(five_bar, NULL, {speeds, YK_CHECK_FALSE}, {accelerations, YK_CHECK_FALSE}, {closing, YK_CHECK_TRUE});
    CHECK_UNDER(five_bar, "brake", {speeds, YK_CHECK_TRUE}, {accelerations, YK_CHECK_TRUE}, {closing, YK_CHECK_TRUE},
                {"t4' = 0", YK_CHECK_TRUE}, {"t4 = 1", YK_CHECK_TRUE_HERE}, {"t4 = 2", YK_CHECK_FALSE},
                {"t1' = 0", YK_CHECK_FALSE});
}

// Held at its elbow, a double pendulum is a compound pendulum; the brake's moment is what is left to tell.
static void a_held_elbow_makes_a_compound_pendulum(void **state)
{
    (void)state;
    static const char pendulum[] =
        "parameters: {l1: 0.5, c1: 0.35, c2: 0.3, m1: 0.5, m2: 0.4, I1: 0.025, I2: 0.02,"
        " tau: 0.5, g: 9.81}\n"
        "gravity: [0, -g]\n"
        "bodies:\n"
        "  ground: {points: {O: [0, 0]}}\n"
        "  arm: {points: {O: [0, 0], A: [0, -l1]}, mass: m1, center: [0, -c1], inertia: I1}\n"
        "  hand: {points: {A: [0, 0]}, mass: m2, center: [0, -c2], inertia: I2}\n"
        "joints:\n"
        "  O: {pin: [ground, arm], angle: q1}\n"
        "  A: {pin: [arm, hand], angle: q2}\n"
        "efforts: {q1: tau}\n"
        "locks: {brake: {join: [[arm, hand]]}}\n"
        "start: {q1: 1, q2: 0.7}\n";
    static const char motion[] = "(I1 + I2 + m1 c1^2 + m2 (l1^2 + c2^2 + 2 l1 c2 cos(q2))) q1''"
                                 " + g ((m1 c1 + m2 l1) sin(q1) + m2 c2 sin(q1 + q2)) = tau",
                      without_gravity[] = "(I1 + I2 + m1 c1^2 + m2 (l1^2 + c2^2 + 2 l1 c2 cos(q2))) q1'' = tau";
    CHECK_UNDER(pendulum, NULL, {motion, YK_CHECK_FALSE});
    CHECK_UNDER(pendulum, "brake", {motion, YK_CHECK_TRUE}, {without_gravity, YK_CHECK_FALSE},
                {"hand.rate = q1'", YK_CHECK_TRUE});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_planetary_set_has_the_ratio_of_its_lock),
        cmocka_unit_test(a_held_crank_makes_a_five_bar_a_four_bar),
        cmocka_unit_test(a_held_elbow_makes_a_compound_pendulum),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
