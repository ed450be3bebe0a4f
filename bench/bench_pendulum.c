// The double pendulum: one right-hand side from examples/double-pendulum.yaml, against its equations written by hand.
// Each evaluation starts from the last one's answer, as in a time step: latency, not throughput.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yoke/yoke.h>
#include "dynamics/tree.h"
#include "reference/common/bench.h"
#include "reference/d1.h"

enum { ROUNDS = 5, EVALUATIONS = 1000000 };
static const double MOST = 60; // ns

typedef struct Bench {
    YkProblems *problems;
    YkModel *model;
    YkMechanism *mech;
    YkTreeDynamics *tree;
    double y[4], dy[4];
} Bench;

static const double Y0[4] = {1.0471975511965976, 0.78539816339744828, 0.1, -0.2}, TAU[2] = {0.5, -0.2};

static bool open_model(Bench *b, const char *path)
{
    bool fits = false;
    b->problems = yk_problems_new();
    b->model = yk_model_load(path, NULL, b->problems);
    b->mech = b->model ? yk_mechanism_compile(b->model, NULL, b->problems) : NULL;
    b->tree = b->mech ? yk_tree_dynamics_new(b->mech, &fits) : NULL;
    if (!b->tree) fprintf(stderr, "%s", yk_problems_text(b->problems, 0));
    return b->tree != NULL;
}

static void close_model(Bench *b)
{
    yk_tree_dynamics_free(b->tree);
    yk_mechanism_free(b->mech);
    yk_model_free(b->model);
    yk_problems_free(b->problems);
}

static void by_hand(Bench *b)
{
    d1_rhs(b->y, TAU, b->dy);
}

static void by_tree(Bench *b)
{
    memcpy(b->dy, b->y + 2, 2 * sizeof *b->dy);
    if (yk_tree_accelerate(b->tree, b->y, b->y + 2, TAU, b->dy + 2) >= 0) exit(1);
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

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(int argc, char **argv)
{
    static Bench b;
    Way ways[] = {{.name = "equations by hand", .run = by_hand},
                  {.name = "yk_tree_accelerate", .run = by_tree, .most = MOST}};
    const size_t count = sizeof ways / sizeof *ways;
    bool keeps = true;
    if (!open_model(&b, argc > 1 ? argv[1] : YOKE_ROOT "/examples/double-pendulum.yaml")) return 1;
    for (size_t r = 0; r < ROUNDS; r++)
        for (size_t k = 0; k < count; k++) ways[k].ns[r] = time_way(&b, &ways[k]);
    printf("%-28s %9s %9s %9s %9s %12s\n", "one right-hand side", "ns", "least", "most", "ratio", "difference");
    for (size_t k = 0; k < count; k++) {
        Way *way = &ways[k];
        qsort(way->ns, ROUNDS, sizeof *way->ns, ascending);
        double ns = way->ns[ROUNDS / 2];
        printf("%-28s %9.2f %9.2f %9.2f %9.2f %12.1e", way->name, ns, way->ns[0], way->ns[ROUNDS - 1],
               ns / ways[0].ns[ROUNDS / 2], difference(&b, way));
        if (way->most > 0) printf("   %s <= %g ns", ns <= way->most ? "keeps" : "MISSES", way->most);
        printf("\n");
        keeps = keeps && (way->most <= 0 || ns <= way->most);
    }
    close_model(&b);
    return keeps ? 0 : 2;
}
