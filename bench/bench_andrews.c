// Andrews' squeezing mechanism from examples/andrews.yaml: one right-hand side, and the motion to 0.03 s at several
// tolerances, against the reduced equations in closed form written by hand. Errors are those of the seven angles
// against a solution in quadruple precision.
#include <math.h>
#include <stdlib.h>
#include "machine.h"
#include "reference/common/bench.h"
#include "reference/d4.h"

enum { ROUNDS = 5, EVALUATIONS = 100000, RUNS = 10, TOLERANCES = 7 };
static const double MOST = 0.6, ERROR = 1e-8; // ms, rad
static const double SPAN = 0.03;
static const char *const NAMES[D4_ANGLES] = {"beta", "Theta", "gamma", "Phi", "delta", "Omega", "epsilon"};

static double error_of(const double *angles)
{
    double worst = 0;
    for (int i = 0; i < D4_ANGLES; i++) worst = fmax(worst, fabs(angles[i] - d4_end[i]));
    return worst;
}

// --- one right-hand side
// ------------------------------------------------------------------------------------------------

static double time_hand(double *acceleration)
{
    double y[2] = {d4_start[0], 100}, dy[2] = {0}, start = bench_now();
    for (size_t k = 0; k < EVALUATIONS; k++) {
        d4_rhs(y, dy);
        y[0] += 1e-20 * dy[1];
    }
    *acceleration = dy[1];
    return (bench_now() - start) * 1e9 / EVALUATIONS;
}

static double time_own(Machine *m, double *acceleration)
{
    double beta = d4_start[0], a = 0, start = bench_now();
    for (size_t k = 0; k < EVALUATIONS; k++) {
        yk_state_set_input(m->state, 0, (YkMotion){.position = beta, .velocity = 100});
        machine_accelerate(m, &a);
        beta += 1e-20 * a;
    }
    *acceleration = a;
    return (bench_now() - start) * 1e9 / EVALUATIONS;
}

static void compare_sides(Machine *m)
{
    double hand[ROUNDS], own[ROUNDS], exact, a;
    for (size_t r = 0; r < ROUNDS; r++) {
        hand[r] = time_hand(&exact);
        own[r] = time_own(m, &a);
    }
    double least = median(hand, ROUNDS), ns = median(own, ROUNDS);
    printf("%-32s %9s %9s %12s\n", "one right-hand side", "ns", "ratio", "difference");
    printf("%-32s %9.1f %9.2f %12.1e\n", "reduced by hand", least, 1., 0.);
    printf("%-32s %9.1f %9.2f %12.1e\n", "yk_dynamics_accelerate", ns, ns / least, fabs(a - exact) / fabs(exact));
}

// --- motion
// -------------------------------------------------------------------------------------------------------------

typedef struct Run {
    double ms[ROUNDS], error;
    long evaluations;
} Run;

static void run_by_hand(double tolerance, Run *run, size_t round)
{
    double angles[D4_ANGLES], start = bench_now();
    for (int k = 0; k < RUNS; k++) run->evaluations = d4_run(tolerance, angles);
    run->ms[round] = (bench_now() - start) * 1e3 / RUNS;
    run->error = error_of(angles);
}

// Only yk_simulation_advance is counted, not the making of the simulation.
static void run_by_simulation(Machine *m, double tolerance, Run *run, size_t round)
{
    double angles[D4_ANGLES];
    run->ms[round] = 0;
    for (int k = 0; k < RUNS; k++) {
        YkSimulation *sim = machine_simulate(m, tolerance, SPAN);
        YkState *state = yk_simulation_state(sim);
        double start = bench_now();
        if (yk_simulation_advance(sim, SPAN) < 0) exit(1);
        run->ms[round] += (bench_now() - start) * 1e3 / RUNS;
        state = yk_simulation_state(sim);
        for (int i = 0; i < D4_ANGLES; i++)
            angles[i] = yk_state_coordinate(state, yk_coordinate_find(yk_state_mechanism(state), NAMES[i])).position;
        run->evaluations = (long)yk_simulation_summary(sim).evaluations;
        run->error = error_of(angles);
        yk_simulation_free(sim);
    }
}

// The cheapest run whose error is small enough: its ms; infinite if there is none.
static double cheapest(Run *runs)
{
    double best = INFINITY;
    for (size_t k = 0; k < TOLERANCES; k++)
        if (runs[k].error <= ERROR) best = fmin(best, median(runs[k].ms, ROUNDS));
    return best;
}

static bool compare_runs(Machine *m)
{
    static Run hand[TOLERANCES], own[TOLERANCES];
    for (size_t r = 0; r < ROUNDS; r++)
        for (size_t k = 0; k < TOLERANCES; k++) {
            double tolerance = pow(10, -6 - (double)k);
            run_by_hand(tolerance, &hand[k], r);
            run_by_simulation(m, tolerance, &own[k], r);
        }
    printf("%-12s %10s %8s %10s %10s %8s %10s %8s\n", "to 0.03 s", "ours, ms", "calls", "error", "by hand", "calls",
           "error", "ratio");
    for (size_t k = 0; k < TOLERANCES; k++) {
        double ms = median(own[k].ms, ROUNDS), least = median(hand[k].ms, ROUNDS);
        printf("tol 1e-%02zu    %10.4f %8ld %10.1e %10.4f %8ld %10.1e %8.2f\n", k + 6, ms, own[k].evaluations,
               own[k].error, least, hand[k].evaluations, hand[k].error, ms / least);
    }
    double ms = cheapest(own), least = cheapest(hand);
    printf("error <= %g: ours %.4f ms, by hand %.4f ms, ratio %.2f   %s <= %g ms\n", ERROR, ms, least, ms / least,
           ms <= MOST ? "keeps" : "MISSES", MOST);
    double error = INFINITY;
    for (size_t k = 0; k < TOLERANCES; k++)
        if (own[k].error <= ERROR) error = fmin(error, own[k].error);
    return row("Andrews' mechanism to 0.03 s at an error of at most 1e-8", least, ms, "ms", 2, error) && ms <= MOST;
}

int main(int argc, char **argv)
{
    Machine machine;
    if (!machine_load(&machine, argc > 1 ? argv[1] : YOKE_ROOT "/examples/andrews.yaml")) return 1;
    compare_sides(&machine);
    bool keeps = compare_runs(&machine);
    machine_end(&machine);
    return keeps ? 0 : 2;
}
