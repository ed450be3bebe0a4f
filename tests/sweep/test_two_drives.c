// Two drives that both turn all the time, while what they do together goes over a change point by 1e-9 to 1e-3 rad and
// comes back. Where the crank is to its frame decides where the machine is. Three linkages whose motions have closed
// forms (a parallelogram, a slider-crank of equal links, a kite), mounted in three ways: on a crank behind an arm, on a
// turntable, on a lever that swings.
#include "../solve/machine.h"
#include <yoke/move.h>
#include <yoke/simulation.h>
#include "base/vec.h"
#include "laws.h"

typedef enum Kind { PARALLELOGRAM, SLIDER_CRANK, KITE, KINDS } Kind;
typedef enum Mounting { BEHIND_ARM, TURNTABLE, LEVER, MOUNTINGS } Mounting;

typedef struct Linkage {
    Kind kind;
    Mounting mounting;
    bool is_other; // the second of its two motions
    double change; // its change point, rad
} Linkage;

static Linkage random_linkage(uint64_t *seed)
{
    Linkage l = {.kind = (Kind)(check_random(seed) % KINDS), .mounting = (Mounting)(check_random(seed) % MOUNTINGS)};
    bool is_second = check_random(seed) % 2;
    l.is_other = check_random(seed) % 2;
    l.change = l.kind == SLIDER_CRANK ? (is_second ? -YK_PI / 2 : YK_PI / 2) : is_second ? YK_PI : 0;
    return l;
}

static double follower(const Linkage *l, double crank)
{
    if (l->kind == SLIDER_CRANK) return l->is_other ? 0 : 2 * cos(crank);
    if (l->kind == KITE) return l->is_other ? YK_PI : 2 * atan2(3 * sin(crank), 3 * cos(crank) - 2) - YK_PI;
    return l->is_other ? 2 * atan2(-3 * sin(crank / 2), cos(crank / 2)) : crank;
}

static double length_of_ground(const Linkage *l)
{
    return l->kind == KITE ? 2 : 4;
}

// Writes what the linkage consists of, on the body `frame`; its crank and the frame are there.
static int write_links(char *text, size_t size, const Linkage *l, const char *frame)
{
    if (l->kind == SLIDER_CRANK)
        return snprintf(text, size,
                        "  rod: {points: {A: [0, 0], B: [1, 0]}}\n  piston: {points: {B: [0, 0]}}\n"
                        "joints:\n  A: {pin: [crank, rod], angle: phi}\n  B: {pin: [rod, piston]}\n"
                        "  S: {slide: [%s, piston], along: x, from: O, to: B, distance: y}\n",
                        frame);
    return snprintf(text, size,
                    "  coupler: {points: {A: [0, 0], B: [%d, 0]}}\n  rocker: {points: {O4: [0, 0], B: [2, 0]}}\n"
                    "joints:\n  A: {pin: [crank, coupler], angle: phi}\n  B: {pin: [coupler, rocker]}\n"
                    "  O4: {pin: [%s, rocker], angle: y}\n",
                    l->kind == KITE ? 3 : 4, frame);
}

// A platform on three legs beside the linkage, which is solved as a group and moves nothing.
static bool has_group;
static const char group_bodies[] =
    "  lk: {points: {K: [0, 0], D: [1.6, 0]}}\n  lx: {points: {X: [0, 0], E: [2.1, 0]}}\n"
    "  ly: {points: {Y: [0, 0], F: [2.6, 0]}}\n  plate: {points: {D: [0, 0], E: [1, 1.2], F: [-1, 1.1]}}\n";
static const char group_joints[] =
    "  K: {pin: [ground, lk], angle: gk}\n  X: {pin: [ground, lx], angle: gx}\n  Y: {pin: [ground, ly], angle: gy}\n"
    "  D: {pin: [lk, plate], angle: gp}\n  E: {pin: [lx, plate]}\n  F: {pin: [ly, plate]}\n";

static int crank_length(const Linkage *l)
{
    return l->kind == PARALLELOGRAM ? 2 : l->kind == KITE ? 3 : 1;
}

// Returns the angle of the coupler or rod to the crank.
static double angle_behind(const Linkage *l, double crank)
{
    double y = follower(l, crank), r = crank_length(l), ground = length_of_ground(l);
    if (l->kind == SLIDER_CRANK) return atan2(-sin(crank), y - cos(crank)) - crank;
    return atan2(2 * sin(y) - r * sin(crank), ground + 2 * cos(y) - r * cos(crank)) - crank;
}

// Drives: `law` is what the crank does to its frame, beyond the change point; `carrier` what theta1 does.
static void write_machine(char *text, size_t size, const Linkage *l, const char *law, double law_start,
                          const char *carrier)
{
    const char *frame = l->mounting == BEHIND_ARM ? "ground" : "base";
    double ground = length_of_ground(l), crank = l->change + law_start;
    int n = snprintf(text, size, "bodies:\n  ground: {points: {O: [0, 0], O4: [%g, 0], H: [3, 0]%s}}\n%s", ground,
                     has_group ? ", K: [0.2, 0], X: [3, 4], Y: [-3, 1.5]" : "", has_group ? group_bodies : "");
    n += snprintf(text + n, size - (size_t)n,
                  "  crank: {points: {O: [0, 0], A: [%d, 0]}, mass: 1, inertia: 1, center: [0, 0]}\n", crank_length(l));
    if (l->mounting == BEHIND_ARM) n += snprintf(text + n, size - (size_t)n, "  arm: {points: {O: [0, 0]}}\n");
    if (l->mounting != BEHIND_ARM)
        n += snprintf(text + n, size - (size_t)n, "  base: {points: {O: [0, 0], O4: [%g, 0]}}\n", ground);
    if (l->mounting == LEVER) n += snprintf(text + n, size - (size_t)n, "  hand: {points: {H: [0, 0], P: [1, 0]}}\n");
    n += write_links(text + n, size - (size_t)n, l, frame);
    static const char *const mounts[] = {
        "  Oa: {pin: [ground, arm], at: O, angle: theta1}\n  Oc: {pin: [arm, crank], at: O, angle: theta2}\n",
        "  Ob: {pin: [ground, base], at: O, angle: theta1}\n  Oc: {pin: [ground, crank], at: O, angle: theta2}\n",
        "  Oh: {pin: [ground, hand], at: H, angle: theta1}\n  Oc: {pin: [ground, crank], at: O, angle: theta2}\n"
        "  Ob: {pin: [ground, base], at: O, angle: beta}\n"
        "  P: {pin-slot: [base, hand], at: P, from: O, along: x}\n"};
    n += snprintf(text + n, size - (size_t)n, "%s%s", mounts[l->mounting], has_group ? group_joints : "");
    n += snprintf(text + n, size - (size_t)n, "drives:\n  theta1: '1 rad*(%s)'\n  theta2: '%.17g rad + 1 rad*(%s)",
                  carrier, l->change, law);
    if (l->mounting == BEHIND_ARM) n += snprintf(text + n, size - (size_t)n, " - 1 rad*(%s)'\n", carrier);
    if (l->mounting == TURNTABLE) n += snprintf(text + n, size - (size_t)n, " + 1 rad*(%s)'\n", carrier);
    if (l->mounting == LEVER)
        n += snprintf(text + n, size - (size_t)n, " + atan2(sin(%s), 3 + cos(%s))'\n", carrier, carrier);
    snprintf(text + n, size - (size_t)n, "start: {phi: %.17g rad, y: %.17g%s%s%s}\n", angle_behind(l, crank),
             follower(l, crank), l->kind == SLIDER_CRANK ? "" : " rad", l->mounting == LEVER ? ", beta: 0" : "",
             has_group ? ", gk: 90 deg, gx: -145 deg, gy: 27.6 deg, gp: -90 deg" : "");
}

static void random_carrier(char *text, size_t size, uint64_t *seed)
{
    double rate = check_uniform(seed, -2, 2), at = check_uniform(seed, -2, 2), swing = check_uniform(seed, 0.2, 3);
    if (check_random(seed) % 2)
        snprintf(text, size, "%.17g + %.17g*t/(1 s)", at, rate);
    else
        snprintf(text, size, "%.17g + %.17g*sin(%.17g*t/(1 s))", at, rate, swing);
}

static Machine make(const Linkage *l, const char *law, double start, const char *carrier)
{
    char text[4096];
    write_machine(text, sizeof text, l, law, start, carrier);
    return machine_parse(text, true);
}

// The frame's angle is not a coordinate where the crank stands on an arm: the two inputs add there.
static double crank_of(const Linkage *l, double theta1, double theta2, double beta)
{
    return l->mounting == BEHIND_ARM ? theta1 + theta2 : l->mounting == TURNTABLE ? theta2 - theta1 : theta2 - beta;
}

static double miss_of(const Linkage *l, double crank, double value)
{
    double miss = value - follower(l, crank);
    return l->kind == SLIDER_CRANK ? miss : yk_nearest_turn(miss, 0);
}

static size_t wrong;

static void tell(const char *how, const Linkage *l, const char *law, double at, double miss)
{
    static const char *const kinds[] = {"parallelogram", "slider-crank", "kite"};
    static const char *const mountings[] = {"behind an arm", "on a turntable", "on a lever"};
    wrong++;
    if (wrong < 40)
        print_error("%s: %s%s %s at %g, %s: off by %g at %.12g\n", how, l->is_other ? "other " : "", kinds[l->kind],
                    mountings[l->mounting], l->change, law, miss, at);
}

static const char *third(const Linkage *l)
{
    return l->mounting == LEVER ? "beta" : "theta1";
}

static void sweep_over_time(const Linkage *l, const Law *law, const char *carrier, size_t steps)
{
    Machine m = make(l, law->text, law->start, carrier);
    const char *of[] = {"theta1", "theta2", third(l), "y"};
    YkSweep *sweep = machine_sweep(&m, NULL, 0, 3, steps, of, 4);
    if (yk_sweep_status(sweep) != YK_OK)
        tell("sweep ended", l, law->text, yk_sweep_at(sweep, yk_sweep_row_count(sweep) - 1), 0);
    for (size_t row = 0; row < yk_sweep_row_count(sweep); row++) {
        double crank =
            crank_of(l, yk_sweep_value(sweep, row, 0), yk_sweep_value(sweep, row, 1), yk_sweep_value(sweep, row, 2));
        double miss = miss_of(l, crank, yk_sweep_value(sweep, row, 3));
        if (fabs(miss) < 1e-6) continue;
        tell("sweep", l, law->text, yk_sweep_at(sweep, row), miss);
        break;
    }
    yk_sweep_free(sweep);
    machine_free(&m);
}

static void check_pose(const Machine *m, const Linkage *l, const char *how, const char *law, double at, YkStatus status)
{
    double crank = crank_of(l, machine_ask(m, "theta1"), machine_ask(m, "theta2"), machine_ask(m, third(l)));
    double miss = status < 0 ? (double)NAN : miss_of(l, crank, machine_ask(m, "y"));
    if (!(fabs(miss) < 1e-6)) tell(how, l, law, at, miss);
}

static void move_over_time(const Linkage *l, const Law *law, const char *carrier, size_t steps)
{
    Machine m = make(l, law->text, law->start, carrier);
    size_t before = wrong;
    for (size_t k = 1; k <= steps && wrong == before; k++) {
        double t = 3.0 * (double)k / (double)steps;
        check_pose(&m, l, "time", law->text, t, yk_state_move_time(m.state, t, NULL, NULL, m.problems));
    }
    if (wrong == before)
        check_pose(&m, l, "back", law->text, 0, yk_state_move_time(m.state, 0, NULL, NULL, m.problems));
    machine_free(&m);
}

static double theta2_of(const Linkage *l, double theta1, double crank)
{
    double lever = atan2(sin(theta1), 3 + cos(theta1));
    return l->mounting == BEHIND_ARM ? crank - theta1 : l->mounting == TURNTABLE ? crank + theta1 : crank + lever;
}

// Moves both inputs at once, over the change point by small amounts, and a long way now and then.
static void move_to_and_fro(const Linkage *l, uint64_t *seed)
{
    Machine m = make(l, "0.3", 0.3, "0.2");
    size_t before = wrong;
    for (size_t k = 0; k < 12 && wrong == before; k++) {
        double u = pow(10, check_uniform(seed, -9, 0)) * (check_random(seed) % 2 ? 1 : -1);
        double theta1 = check_uniform(seed, -0.5, 0.5);
        if (k % 5 == 4) u = check_uniform(seed, -1, 1);
        YkMotion goal[] = {{theta1, 1, 0}, {theta2_of(l, theta1, l->change + u), 1, 0}};
        check_pose(&m, l, "move", "", u, yk_state_move_to(m.state, goal, NULL, NULL));
    }
    machine_free(&m);
}

static void simulate(const Linkage *l, const Law *law, const char *carrier, size_t steps)
{
    char text[4096];
    write_machine(text, sizeof text, l, law->text, law->start, carrier);
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "test.yaml", NULL, problems);
    YkSimulationOptions options = yk_default_simulation_options();
    YkSimulation *sim = model ? yk_simulation_new(model, &options, problems) : NULL;
    if (!sim) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(sim);
    Machine m = {.mech = (YkMechanism *)yk_state_mechanism(yk_simulation_state(sim)),
                 .state = yk_simulation_state(sim),
                 .problems = problems};
    size_t before = wrong;
    for (size_t k = 1; k <= steps && wrong == before; k++) {
        double t = 3.0 * (double)k / (double)steps;
        YkStatus status = yk_simulation_advance(sim, t);
        if (status < 0)
            break; // what each of two drives brings cannot be told there, so it may be refused, but it is not wrong
        check_pose(&m, l, "simulate", law->text, t, status);
    }
    yk_simulation_free(sim);
    yk_model_free(model);
    yk_problems_free(problems);
}

static void check_excursions(uint64_t cases)
{
    static const size_t steps[] = {1, 2, 3, 7, 30, 101};
    for (uint64_t k = 1; k <= cases; k++) {
        uint64_t seed = 1000 * (k == 12 ? 51 : k); // 51: a simulation that stops just at a change point, and goes back
        size_t before = wrong, n = steps[k % 6];
        Linkage l = random_linkage(&seed);
        Law law = random_law(&seed);
        char carrier[256];
        random_carrier(carrier, sizeof carrier, &seed);
        move_to_and_fro(&l, &seed);
        if (fabs(law.start) < 0.02 || fabs(law.start) > 20) continue;
        sweep_over_time(&l, &law, carrier, n);
        move_over_time(&l, &law, carrier, n);
        simulate(&l, &law, carrier, n);
        if (wrong != before) print_error("case %llu, %zu steps, carrier %s\n", (unsigned long long)k, n, carrier);
    }
    assert_int_equal(wrong, 0);
}

static void test_no_excursion_is_missed(void **unused)
{
    (void)unused;
    has_group = false;
    check_excursions(getenv("YOKE_FULL") ? 70 : check_cases(2));
}

static void test_both_inputs_move_to_and_fro(void **unused)
{
    (void)unused;
    has_group = false;
    for (uint64_t k = 1; k <= check_cases(30); k++) {
        uint64_t seed = 77 * k;
        Linkage l = random_linkage(&seed);
        move_to_and_fro(&l, &seed);
    }
    assert_int_equal(wrong, 0);
}

static void test_no_excursion_is_missed_beside_a_group(void **unused)
{
    (void)unused;
    has_group = true;
    check_excursions(getenv("YOKE_FULL") ? 70 : check_cases(2));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_both_inputs_move_to_and_fro),
                                       cmocka_unit_test(test_no_excursion_is_missed),
                                       cmocka_unit_test(test_no_excursion_is_missed_beside_a_group)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
