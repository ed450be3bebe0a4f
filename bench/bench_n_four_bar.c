// N parallelograms side by side: one right-hand side, time a loop, against the recursion over the windows written by
// hand; and 10 s of motion of 1000 of them, through ten singular positions, against an augmented Lagrangian written by
// hand.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "machine.h"
#include "reference/common/bench.h"
#include "reference/d2.h"

enum { ROUNDS = 5, WORK = 1000000, LOOPS = 1000 };    // loops a round and way; loops of the motion
static const double MOST = 120;                       // ns a loop
static const double MOST_SECOND = 0.05, DRIFT = 1e-8; // s a simulated second, of the energy
static const double SPAN = 10, STEP = 0.01, TOLERANCE = 1e-10;
static const double ANGLE = 0.3, RATE = 1.1, UPRIGHT = 1.5707963267948966; // the pose of the right-hand sides

// --- one right-hand side
// ------------------------------------------------------------------------------------------------

typedef struct Bench {
    size_t n;
    Machine machine;
    double own; // acceleration of theta0, which turns the other way
    double *crank, *coupler, *crank_rate, *coupler_rate, *a, *ratio;
} Bench;

static bool load(Machine *machine, size_t n)
{
    char *text = n_four_bar_text(n);
    bool stands = machine_parse(machine, text);
    free(text);
    return stands;
}

static bool start(Bench *b, size_t n)
{
    *b = (Bench){.n = n};
    double *p = calloc(8 * n + 6, sizeof *p);
    b->crank = p;
    if (!p || !load(&b->machine, n)) return false;
    b->coupler = p + n + 1, b->crank_rate = p + 2 * n + 1, b->coupler_rate = p + 3 * n + 2;
    b->a = p + 4 * n + 2, b->ratio = p + 6 * n + 3;
    for (size_t i = 0; i <= n; i++) b->crank[i] = ANGLE, b->crank_rate[i] = RATE;
    return true;
}

static void by_hand(Bench *b)
{
    d2_recursion(b->n, b->crank, b->coupler, b->crank_rate, b->coupler_rate, b->a, b->ratio);
    b->crank[0] += 1e-14;
}

static void by_dynamics(Bench *b)
{
    yk_state_set_input(b->machine.state, 0, (YkMotion){.position = UPRIGHT - b->crank[0], .velocity = -RATE});
    machine_accelerate(&b->machine, &b->own);
    b->crank[0] += 1e-14;
}

static double relative(double value, double exact)
{
    return fabs(value - exact) / fabs(exact);
}

static bool measure(size_t n)
{
    static void (*const ways[])(Bench *) = {by_dynamics, by_hand};
    double ns[2][ROUNDS], at[2];
    Bench b;
    if (!start(&b, n)) exit(1);
    size_t runs = (WORK + n - 1) / n;
    by_hand(&b);
    by_dynamics(&b);
    double exact = d2_exact(n, ANGLE), off = relative(-b.own, exact), off_hand = relative(b.a[0], exact);
    for (size_t r = 0; r < ROUNDS; r++)
        for (size_t way = 0; way < 2; way++) {
            double begin = bench_now();
            for (size_t k = 0; k < runs; k++) ways[way](&b);
            ns[way][r] = (bench_now() - begin) * 1e9 / (double)(runs * n);
        }
    for (size_t way = 0; way < 2; way++) at[way] = median(ns[way], ROUNDS);
    bool keeps = at[0] <= MOST;
    printf("%9zu %9.1f %9.1f %9.1f %9.1f %9.2f %12.1e %12.1e   %s <= %g ns\n", n, at[0], ns[0][0], ns[0][ROUNDS - 1],
           at[1], at[0] / at[1], off, off_hand, keeps ? "keeps" : "MISSES", MOST);
    fflush(stdout);
    char task[80];
    snprintf(task, sizeof task, "N-four-bar, N = %zu, one right-hand side, a loop", n);
    bool has_ratio = row(task, at[1], at[0], "ns", 1.5, off);
    machine_end(&b.machine);
    free(b.crank);
    return keeps && has_ratio;
}

// --- motion
// -------------------------------------------------------------------------------------------------------------

typedef struct Motion {
    double seconds, setup; // a simulated second; before it
    double drift;          // of the energy, at worst
    double angle;          // of the first crank in the end, clockwise from the vertical
    size_t steps, evaluations;
} Motion;

static Motion move_by_hand(void)
{
    Motion m = {.steps = (size_t)lround(SPAN / STEP)};
    D2Augmented system;
    double begin = bench_now();
    if (!d2_start(&system, LOOPS)) exit(1);
    m.setup = bench_now() - begin;
    double energy = d2_energy(&system);
    for (size_t k = 0; k < m.steps; k += 20) {
        begin = bench_now();
        for (size_t j = 0; j < 20; j++) d2_step(&system, STEP);
        m.seconds += (bench_now() - begin) / SPAN;
        m.drift = fmax(m.drift, fabs(d2_energy(&system) / energy - 1));
    }
    m.evaluations = 4 * m.steps;
    m.angle = system.q[0];
    d2_end(&system);
    return m;
}

static Motion move_by_simulation(Machine *machine)
{
    Motion m = {0};
    double begin = bench_now();
    YkSimulation *sim = machine_simulate(machine, TOLERANCE, SPAN);
    double ready = bench_now();
    YkStatus status = yk_simulation_advance(sim, SPAN);
    m.seconds = (bench_now() - ready) / SPAN;
    m.setup = ready - begin;
    if (status < 0) fprintf(stderr, "%s at %g s\n", yk_simulation_report(sim)->message, yk_simulation_time(sim));
    YkSimulationSummary summary = yk_simulation_summary(sim);
    m.steps = summary.steps;
    m.evaluations = summary.evaluations;
    size_t first = yk_coordinate_find(yk_state_mechanism(yk_simulation_state(sim)), "theta0");
    m.angle = UPRIGHT - yk_state_coordinate(yk_simulation_state(sim), first).position;
    yk_simulation_free(sim);
    return m;
}

// The same motion in rows of 0.2 s, not timed: the largest change of the energy, over the energy at the start.
static double drift_of_simulation(Machine *machine)
{
    YkSimulation *sim = machine_simulate(machine, TOLERANCE, SPAN);
    double drift = 0;
    for (int k = 1; k <= 50; k++) {
        if (yk_simulation_advance(sim, SPAN * k / 50) < 0) exit(1);
        YkSimulationSummary summary = yk_simulation_summary(sim);
        drift = fmax(drift, fabs(summary.energy_end / summary.energy_start - 1));
    }
    yk_simulation_free(sim);
    return drift;
}

// By one equation: Runge-Kutta 4 at steps of 1e-4 s.
static double exact_angle(void)
{
    double q = 0, w = 1, h = 1e-4;
    for (long k = lround(SPAN / h); k-- > 0;) {
        double k1 = d2_exact(LOOPS, q), k2 = d2_exact(LOOPS, q + 0.5 * h * w);
        double k3 = d2_exact(LOOPS, q + 0.5 * h * (w + 0.5 * h * k1)), k4 = d2_exact(LOOPS, q + h * (w + 0.5 * h * k2));
        q += h * w + h * h / 6 * (k1 + k2 + k3);
        w += h / 6 * (k1 + 2 * (k2 + k3) + k4);
    }
    return q;
}

static void print_motion(const char *name, const Motion *m, double seconds, double ratio, double exact)
{
    printf("%-36s %9.4f %9.2f %9.4f %8zu %8zu %10.1e %10.1e", name, seconds, ratio, m->setup, m->steps, m->evaluations,
           m->drift, fabs(m->angle - exact));
}

static bool compare_motion(void)
{
    double hand[ROUNDS], own[ROUNDS], exact = exact_angle();
    Motion by_hand_motion = {0}, own_motion = {0};
    Machine machine;
    if (!load(&machine, LOOPS)) exit(1);
    for (size_t r = 0; r < ROUNDS; r++) {
        by_hand_motion = move_by_hand();
        own_motion = move_by_simulation(&machine);
        hand[r] = by_hand_motion.seconds, own[r] = own_motion.seconds;
    }
    own_motion.drift = drift_of_simulation(&machine);
    double least = median(hand, ROUNDS), seconds = median(own, ROUNDS);
    bool keeps = seconds <= MOST_SECOND && own_motion.drift <= DRIFT;
    printf("%-36s %9s %9s %9s %8s %8s %10s %10s\n", "N = 1000, a simulated second, over 10", "s", "ratio", "set-up",
           "steps", "calls", "drift", "angle off");
    print_motion("augmented Lagrangian by hand, h = 0.01", &by_hand_motion, least, 1, exact);
    printf("\n");
    print_motion("yk_simulation_advance, tol 1e-10", &own_motion, seconds, seconds / least, exact);
    printf("   %s <= %g s at drift <= %g\n", keeps ? "keeps" : "MISSES", MOST_SECOND, DRIFT);
    machine_end(&machine);
    return keeps;
}

int main(int argc, char **argv)
{
    printf("ns a loop; ours: yk_dynamics_accelerate\n");
    printf("%9s %9s %9s %9s %9s %9s %12s %12s\n", "loops", "ours", "least", "most", "by hand", "ratio", "error",
           "by hand");
    if (argc > 1) return measure((size_t)strtoull(argv[1], NULL, 10)) ? 0 : 2;
    bool keeps = true;
    for (size_t n = 10; n <= 100000; n *= 10) keeps &= measure(n);
    keeps &= compare_motion();
    return keeps ? 0 : 2;
}
