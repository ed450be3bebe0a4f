// Drives that go over a change point by 1e-9 to 1e-3 rad and come back, by every way to move: where the crank is
// decides where the machine is. Two linkages whose two motions have closed forms: a parallelogram, which may be
// crossed, and a slider-crank of equal links, whose piston may stay in the crank's axis.
#include "../solve/machine.h"
#include "../parallelogram.h"
#include <yoke/move.h>
#include <yoke/simulation.h>
#include "base/vec.h"
#include "laws.h"

typedef struct Linkage {
    bool is_slider, is_other; // the second of its two motions
    double change;            // its change point, rad
} Linkage;

static const Linkage linkages[] = {{false, false, 0},         {false, false, YK_PI},    {false, true, 0},
                                   {false, true, YK_PI},      {true, false, YK_PI / 2}, {true, true, YK_PI / 2},
                                   {true, false, -YK_PI / 2}, {true, true, -YK_PI / 2}};
enum { LINKAGES = sizeof linkages / sizeof *linkages };

static double follower(const Linkage *l, double crank)
{
    if (l->is_slider) return l->is_other ? 0 : 2 * cos(crank);
    return l->is_other ? 2 * atan2(-3 * sin(crank / 2), cos(crank / 2)) : crank;
}

static void write_linkage(char *text, size_t size, const Linkage *l, const char *law, double start)
{
    double crank = l->change + start, y = follower(l, crank);
    if (l->is_slider) {
        double rod = atan2(-sin(crank), y - cos(crank));
        snprintf(text, size,
                 "bodies:\n"
                 "  ground: {points: {O: [0, 0]}}\n"
                 "  crank: {points: {O: [0, 0], A: [1, 0]}, mass: 1, inertia: 1, center: [0, 0]}\n"
                 "  rod: {points: {A: [0, 0], B: [1, 0]}}\n"
                 "  piston: {points: {B: [0, 0]}}\n"
                 "joints:\n"
                 "  O: {pin: [ground, crank], angle: theta2}\n"
                 "  A: {pin: [crank, rod], angle: phi}\n"
                 "  B: {pin: [rod, piston]}\n"
                 "  S: {slide: [ground, piston], along: x, distance: y}\n"
                 "drives: {theta2: '%.17g rad + 1 rad*(%s)'}\nstart: {phi: %.17g rad, y: %.17g}\n",
                 l->change, law, rod - crank, y);
        return;
    }
    double coupler = atan2(2 * sin(y) - 2 * sin(crank), 4 + 2 * cos(y) - 2 * cos(crank));
    snprintf(text, size,
             "bodies:\n"
             "  ground:  {points: {O2: [0, 0], O4: [4, 0]}}\n"
             "  crank:   {points: {O2: [0, 0], A: [2, 0]}, mass: 1, inertia: 1, center: [0, 0]}\n"
             "  coupler: {points: {A: [0, 0], B: [4, 0]}}\n"
             "  rocker:  {points: {O4: [0, 0], B: [2, 0]}}\n" PARALLELOGRAM_JOINTS
             "drives: {theta2: '%.17g rad + 1 rad*(%s)'}\nstart: {theta3: %.17g rad, theta4: %.17g rad}\n",
             l->change, law, coupler - crank, y);
}

static Machine make(const Linkage *l, const char *law, double start)
{
    char text[2048];
    write_linkage(text, sizeof text, l, law, start);
    return machine_parse(text, true);
}

static const char *follower_name(const Linkage *l)
{
    return l->is_slider ? "y" : "theta4";
}

static double off(const Linkage *l, double crank, double value)
{
    double miss = value - follower(l, crank);
    return l->is_slider ? miss : yk_nearest_turn(miss, 0);
}

static bool is_right(const Linkage *l, double crank, double value)
{
    return fabs(off(l, crank, value)) < 1e-6;
}

static size_t wrong;

static void tell(const char *how, const Linkage *l, const char *law, double at, double miss)
{
    wrong++;
    if (wrong < 40)
        print_error("%s: %s%s at %g, %s: off by %g at %.12g\n", how, l->is_other ? "other " : "",
                    l->is_slider ? "slider-crank" : "parallelogram", l->change, law, miss, at);
}

static void sweep_over_time(const Linkage *l, const Law *law, size_t steps)
{
    Machine m = make(l, law->text, law->start);
    const char *of[] = {"theta2", follower_name(l)};
    YkSweep *sweep = machine_sweep(&m, NULL, 0, 3, steps, of, 2);
    if (yk_sweep_status(sweep) != YK_OK)
        tell("sweep ended", l, law->text, yk_sweep_at(sweep, yk_sweep_row_count(sweep) - 1), 0);
    for (size_t row = 0; row < yk_sweep_row_count(sweep); row++)
        if (!is_right(l, yk_sweep_value(sweep, row, 0), yk_sweep_value(sweep, row, 1))) {
            tell("sweep", l, law->text, yk_sweep_at(sweep, row),
                 off(l, yk_sweep_value(sweep, row, 0), yk_sweep_value(sweep, row, 1)));
            break;
        }
    yk_sweep_free(sweep);
    machine_free(&m);
}

static void check_pose(const Machine *m, const Linkage *l, const char *how, const char *law, double at, YkStatus status)
{
    double crank = machine_ask(m, "theta2"), y = machine_ask(m, follower_name(l));
    if (status < 0) tell(how, l, law, at, NAN);
    if (status >= 0 && !is_right(l, crank, y)) tell(how, l, law, at, off(l, crank, y));
}

static void move_over_time(const Linkage *l, const Law *law, size_t steps)
{
    Machine m = make(l, law->text, law->start);
    size_t before = wrong;
    for (size_t k = 1; k <= steps && wrong == before; k++) {
        double t = 3.0 * (double)k / (double)steps;
        check_pose(&m, l, "time", law->text, t, yk_state_move_time(m.state, t, NULL, NULL, m.problems));
    }
    if (wrong == before)
        check_pose(&m, l, "back", law->text, 0, yk_state_move_time(m.state, 0, NULL, NULL, m.problems));
    machine_free(&m);
}

// Moves to and fro over the change point by small amounts, and a long way now and then.
static void move_to_and_fro(const Linkage *l, uint64_t *seed)
{
    Machine m = make(l, "0.3", 0.3);
    size_t before = wrong;
    for (size_t k = 0; k < 12 && wrong == before; k++) {
        double u = pow(10, check_uniform(seed, -9, 0));
        if (check_random(seed) % 2 == 0) u = -u;
        if (k % 5 == 3) u = 0;
        if (k % 5 == 4) u = check_uniform(seed, -1, 1);
        YkMotion goal = {l->change + u, 1, 0};
        check_pose(&m, l, "move", "", u, yk_state_move_to(m.state, &goal, NULL, NULL));
    }
    machine_free(&m);
}

// Sweeps over the crank's angle, from one small distance to another, each from where the last one ended.
static void sweep_to_and_fro(const Linkage *l, uint64_t *seed)
{
    Machine m = make(l, "0.3", 0.3);
    const char *of[] = {"theta2", follower_name(l)};
    size_t before = wrong;
    for (size_t k = 0; k < 6 && wrong == before; k++) {
        double from = pow(10, check_uniform(seed, -9, -1));
        if (check_random(seed) % 2 == 0) from = -from;
        double to = pow(10, check_uniform(seed, -9, 0));
        if (check_random(seed) % 2 == 0) to = -to;
        YkSweep *sweep =
            machine_sweep(&m, "theta2", l->change + from, l->change + to, 1 + check_random(seed) % 9, of, 2);
        for (size_t row = 0; row < yk_sweep_row_count(sweep) && wrong == before; row++)
            if (!is_right(l, yk_sweep_value(sweep, row, 0), yk_sweep_value(sweep, row, 1)))
                tell("coordinate", l, "", yk_sweep_at(sweep, row),
                     off(l, yk_sweep_value(sweep, row, 0), yk_sweep_value(sweep, row, 1)));
        if (yk_sweep_status(sweep) != YK_OK) tell("coordinate ended", l, "", from, to);
        yk_sweep_free(sweep);
    }
    machine_free(&m);
}

static size_t simulated, refused;

static void simulate(const Linkage *l, const Law *law, size_t steps)
{
    char text[2048];
    write_linkage(text, sizeof text, l, law->text, law->start);
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
    simulated++;
    for (size_t k = 1; k <= steps && wrong == before; k++) {
        double t = 3.0 * (double)k / (double)steps;
        YkStatus status = yk_simulation_advance(sim, t);
        if (status < 0) {
            refused++;
            if (refused < 10) print_error("refused: %s at %g: %s\n", law->text, t, yk_simulation_report(sim)->message);
            break;
        }
        check_pose(&m, l, "simulate", law->text, t, status);
    }
    yk_simulation_free(sim);
    yk_model_free(model);
    yk_problems_free(problems);
}

static void test_no_excursion_is_missed(void **unused)
{
    (void)unused;
    static const size_t steps[] = {1, 2, 3, 7, 30, 101};
    for (uint64_t k = 1; k <= check_cases(8); k++) {
        uint64_t seed = 1000 * k;
        size_t before = wrong, n = steps[k % 6];
        const Linkage *l = &linkages[check_random(&seed) % LINKAGES];
        Law law = random_law(&seed);
        move_to_and_fro(l, &seed);
        sweep_to_and_fro(l, &seed);
        if (fabs(law.start) < 0.02 || fabs(law.start) > 20) continue;
        sweep_over_time(l, &law, n);
        move_over_time(l, &law, n);
        simulate(l, &law, n);
        if (wrong != before) print_error("seed %llu, %zu steps\n", (unsigned long long)seed, n);
    }
    assert_int_equal(wrong, 0);
    assert_true(simulated > 0 && 20 * refused <= simulated); // where a drive rests for long exactly there
}

// Both passages of the shortest excursion are told, each where it is.
static void test_both_passages_are_told(void **unused)
{
    (void)unused;
    uint64_t seed = 7;
    for (uint64_t k = 0; k < check_cases(20); k++) {
        const Linkage *l = &linkages[k % LINKAGES];
        double small = pow(10, check_uniform(&seed, -9, -3)), z = check_uniform(&seed, 0.4, 1.4), half = sqrt(small);
        char law[256];
        snprintf(law, sizeof law, "%.17g - (t/(1 s) - %.17g)^2", small, z);
        Machine m = make(l, law, small - z * z);
        YkSweep *sweep = machine_sweep(&m, NULL, 0, z + 0.5, 1 + k % 7, NULL, 0);
        size_t told = 0;
        for (size_t e = 0; e < yk_sweep_event_count(sweep); e++) {
            YkEvent event = yk_sweep_event(sweep, e);
            if (event.kind != YK_EVENT_CHANGE_POINT) continue;
            CHECK_NEAR(event.at, told == 0 ? z - half : z + half, 1e-8 + 1e-11 / half);
            told++;
        }
        if (told != 2) print_error("%s: %zu passages\n", law, told);
        assert_int_equal(told, 2);
        yk_sweep_free(sweep);
        machine_free(&m);
    }
}

// Excursions as high as the narrowest intervals are wide: an interval may begin before the change point and end beyond
// it, with no pose in it where the margin is much smaller than at its ends.
static void test_excursions_as_high_as_an_interval_is_wide(void **unused)
{
    (void)unused;
    static const struct {
        int linkage;
        double sign, small, factor, middle, times[2];
    } cases[] = {
        {3,
         -1,
         1.4332879049631806e-07,
         1.4172918290142111,
         0.52618182888871989,
         {0.6697110544397864, 0.031642233617636628}},
        {6,
         1,
         1.2406222943937171e-07,
         0.55319214284403206,
         0.78157204590026619,
         {1.206544758130204, 0.764137403043332}},
    };
    for (size_t k = 0; k < 2; k++) {
        const Linkage *l = &linkages[cases[k].linkage];
        double small = cases[k].small, factor = cases[k].factor, z = cases[k].middle;
        char law[256];
        snprintf(law, sizeof law, "%g*(%.17g - %.17g*(t/(1 s) - %.17g)^2)", cases[k].sign, small, factor, z);
        Machine m = make(l, law, cases[k].sign * (small - factor * z * z));
        for (int i = 0; i < 4; i++) {
            double t = cases[k].times[i % 2];
            check_pose(&m, l, "interval", law, t, yk_state_move_time(m.state, t, NULL, NULL, m.problems));
        }
        machine_free(&m);
    }
    assert_int_equal(wrong, 0);
}

// Two parallelograms in series come into line together: the second passes its change point each time that the first
// does.
static void test_links_behind_it_pass_with_it(void **unused)
{
    (void)unused;
    static const char *const of[] = {"theta2", "theta4", "theta6"};
    static const double smalls[] = {1e-9, 3e-8, 2.6817331970361862e-06, 1e-5, 3e-4};
    for (size_t k = 0; k < sizeof smalls / sizeof *smalls; k++) {
        char text[2048];
        snprintf(text, sizeof text,
                 "bodies:\n"
                 "  ground:  {points: {O2: [0, 0], O4: [4, 0], O6: [7, 0]}}\n"
                 "  crank:   {points: {O2: [0, 0], A: [2, 0]}}\n"
                 "  coupler: {points: {A: [0, 0], B: [4, 0]}}\n"
                 "  rocker:  {points: {O4: [0, 0], B: [2, 0], C: [2, 0]}}\n"
                 "  link:    {points: {C: [0, 0], D: [3, 0]}}\n"
                 "  last:    {points: {O6: [0, 0], D: [2, 0]}}\n" PARALLELOGRAM_JOINTS
                 "  C: {pin: [rocker, link], angle: theta5}\n"
                 "  O6: {pin: [ground, last], angle: theta6}\n"
                 "  D: {pin: [link, last]}\n"
                 "drives: {theta2: '1 rad*((1 + %.17g)*sin(5.1*t/(1 s) - 0.5) - 1)'}\n"
                 "start: {theta3: 85 deg, theta4: -85 deg, theta5: 85 deg, theta6: -85 deg}\n",
                 smalls[k]);
        for (size_t steps = 1; steps < 40; steps += 12) {
            Machine m = machine_parse(text, true);
            YkSweep *sweep = machine_sweep(&m, NULL, 0, 2, steps, of, 3);
            assert_int_equal(yk_sweep_row_count(sweep), steps + 1);
            for (size_t row = 0; row <= steps; row++)
                for (size_t c = 1; c < 3; c++)
                    CHECK_NEAR(yk_sweep_value(sweep, row, c), yk_sweep_value(sweep, row, 0), 1e-6);
            yk_sweep_free(sweep);
            machine_free(&m);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_no_excursion_is_missed), cmocka_unit_test(test_excursions_as_high_as_an_interval_is_wide),
        cmocka_unit_test(test_both_passages_are_told), cmocka_unit_test(test_links_behind_it_pass_with_it)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
