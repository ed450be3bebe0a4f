// The double pendulum of examples/double-pendulum.yaml, against its equations written by hand: one right-hand side,
// each from the last one's answer as in a time step (latency, not throughput); and 10 s at a tolerance of 1e-10.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "equations/tree.h"
#include "machine.h"
#include "reference/common/bench.h"
#include "reference/d1.h"

enum { ROUNDS = 5, EVALUATIONS = 1000000, RUNS = 20 };
static const double MOST = 60, MOST_RUN = 0.45; // ns, ms
static const double TOLERANCE = 1e-10, SPAN = 10;

typedef struct Bench {
    Machine machine;
    YkTreeDynamics *tree;
    double y[4], dy[4];
} Bench;

static const double Y0[4] = {1.0471975511965976, 0.78539816339744828, 0.1, -0.2}, TAU[2] = {0.5, -0.2};
// After 10 s without torques: Taylor series of order 36 in long double.
static const double END[4] = {0.224688023300982777, 0.622786344042675665, -3.49602469300504193, -1.81212883487179496};

static bool open_model(Bench *b, const char *path)
{
    bool fits = false;
    b->tree = machine_load(&b->machine, path) ? yk_tree_dynamics_new(b->machine.mech, &fits) : NULL;
    return b->tree != NULL;
}

static void close_model(Bench *b)
{
    yk_tree_dynamics_free(b->tree);
    machine_end(&b->machine);
}

// --- one right-hand side
// ------------------------------------------------------------------------------------------------

static void by_hand(Bench *b)
{
    d1_rhs(b->y, TAU, b->dy);
}

static void by_tree(Bench *b)
{
    memcpy(b->dy, b->y + 2, 2 * sizeof *b->dy);
    if (yk_tree_accelerate(b->tree, b->y, b->y + 2, TAU, b->dy + 2) >= 0) exit(1);
}

static void by_dynamics(Bench *b)
{
    for (size_t i = 0; i < 2; i++)
        yk_state_set_input(b->machine.state, i, (YkMotion){.position = b->y[i], .velocity = b->y[2 + i]});
    memcpy(b->dy, b->y + 2, 2 * sizeof *b->dy);
    machine_accelerate(&b->machine, b->dy + 2);
}

typedef struct Way {
    const char *name;
    void (*run)(Bench *b);
    double most, ns[ROUNDS];
} Way;

static double time_way(Bench *b, const Way *way)
{
    memcpy(b->y, Y0, sizeof Y0);
    double start = bench_now();
    for (size_t k = 0; k < EVALUATIONS; k++) {
        way->run(b);
        b->y[0] += 1e-9 * b->dy[2];
        b->y[1] += 1e-9 * b->dy[3];
    }
    return (bench_now() - start) * 1e9 / EVALUATIONS;
}

// The largest difference from the equations by hand over many states, over the largest acceleration.
static double difference(Bench *b, const Way *way)
{
    double worst = 0, largest = 0;
    for (int k = 0; k < 10000; k++) {
        double exact[4];
        for (int i = 0; i < 4; i++) b->y[i] = 6 * sin(1.7 * k + i);
        d1_rhs(b->y, TAU, exact);
        way->run(b);
        for (int i = 2; i < 4; i++) {
            worst = fmax(worst, fabs(b->dy[i] - exact[i]));
            largest = fmax(largest, fabs(exact[i]));
        }
    }
    return worst / largest;
}

static bool compare_sides(Bench *b)
{
    Way ways[] = {{.name = "equations by hand", .run = by_hand},
                  {.name = "yk_tree_accelerate", .run = by_tree},
                  {.name = "yk_dynamics_accelerate", .run = by_dynamics, .most = MOST}};
    const size_t count = sizeof ways / sizeof *ways;
    bool keeps = true;
    for (size_t r = 0; r < ROUNDS; r++)
        for (size_t k = 0; k < count; k++) ways[k].ns[r] = time_way(b, &ways[k]);
    printf("%-28s %9s %9s %9s %9s %12s\n", "one right-hand side", "ns", "least", "most", "ratio", "difference");
    double hand = median(ways[0].ns, ROUNDS);
    for (size_t k = 0; k < count; k++) {
        Way *way = &ways[k];
        double ns = median(way->ns, ROUNDS);
        printf("%-28s %9.2f %9.2f %9.2f %9.2f %12.1e", way->name, ns, way->ns[0], way->ns[ROUNDS - 1], ns / hand,
               difference(b, way));
        if (way->most > 0) printf("   %s <= %g ns", ns <= way->most ? "keeps" : "MISSES", way->most);
        printf("\n");
        keeps = keeps && (way->most <= 0 || ns <= way->most);
    }
    row("double pendulum, one right-hand side", hand, median(ways[2].ns, ROUNDS), "ns", 0, difference(b, &ways[2]));
    return keeps;
}

// --- ten seconds
// --------------------------------------------------------------------------------------------------------

typedef struct Run {
    double ms, setup, error;
    long evaluations;
    double drift;
} Run;

static double error_of(const double *y)
{
    double worst = 0;
    for (int i = 0; i < 4; i++) worst = fmax(worst, fabs(y[i] - END[i]));
    return worst;
}

static Run run_by_hand(Bench *b)
{
    Run run = {0};
    (void)b;
    for (int k = 0; k < RUNS; k++) {
        double y[4], start = bench_now();
        memcpy(y, Y0, sizeof y);
        double before = d1_energy(y);
        run.evaluations = d1_run(y, SPAN, TOLERANCE);
        run.ms += (bench_now() - start) * 1e3 / RUNS;
        run.error = error_of(y);
        run.drift = fabs(d1_energy(y) - before) / fabs(before);
    }
    return run;
}

// The file's torques are set to 0. Only yk_simulation_advance is counted; making the simulation is `setup`.
static Run run_by_simulation(Bench *b)
{
    Run run = {0};
    for (int k = 0; k < RUNS; k++) {
        double begin = bench_now();
        YkSimulation *sim = machine_simulate(&b->machine, TOLERANCE, SPAN);
        yk_simulation_set_effort(sim, "theta1", 0);
        yk_simulation_set_effort(sim, "theta2", 0);
        double start = bench_now();
        if (yk_simulation_advance(sim, SPAN) < 0) exit(1);
        run.ms += (bench_now() - start) * 1e3 / RUNS;
        run.setup += (start - begin) * 1e3 / RUNS;
        double y[4];
        for (size_t i = 0; i < 2; i++) {
            YkMotion m = yk_state_coordinate(yk_simulation_state(sim), i);
            y[i] = m.position, y[2 + i] = m.velocity;
        }
        YkSimulationSummary summary = yk_simulation_summary(sim);
        run.error = error_of(y);
        run.evaluations = (long)summary.evaluations;
        run.drift = summary.energy_error;
        yk_simulation_free(sim);
    }
    return run;
}

static bool compare_runs(Bench *b)
{
    double hand[ROUNDS], own[ROUNDS];
    Run by_hand_run = {0}, own_run = {0};
    for (size_t r = 0; r < ROUNDS; r++) {
        by_hand_run = run_by_hand(b);
        own_run = run_by_simulation(b);
        hand[r] = by_hand_run.ms, own[r] = own_run.ms;
    }
    double least = median(hand, ROUNDS), ms = median(own, ROUNDS);
    printf("%-28s %9s %9s %9s %9s %12s %12s\n", "10 s at 1e-10, DOP853", "ms", "ratio", "set-up", "calls", "error",
           "energy off");
    printf("%-28s %9.4f %9.2f %9s %9ld %12.1e %12.1e\n", "equations by hand", least, 1., "-", by_hand_run.evaluations,
           by_hand_run.error, by_hand_run.drift);
    printf("%-28s %9.4f %9.2f %9.4f %9ld %12.1e %12.1e   %s <= %g ms\n", "yk_simulation_advance", ms, ms / least,
           own_run.setup, own_run.evaluations, own_run.error, own_run.drift, ms <= MOST_RUN ? "keeps" : "MISSES",
           MOST_RUN);
    return ms <= MOST_RUN;
}

int main(int argc, char **argv)
{
    static Bench b;
    if (!open_model(&b, argc > 1 ? argv[1] : YOKE_ROOT "/examples/double-pendulum.yaml")) return 1;
    bool keeps = compare_sides(&b);
    keeps &= compare_runs(&b);
    close_model(&b);
    return keeps ? 0 : 2;
}
