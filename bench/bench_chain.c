// Forward dynamics of a hanging chain of N uniform rods: ours from a model file, against the recursion written by hand
// for this chain alone. Time a link; all ways take turns in one run, the median of the rounds counts.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yoke/yoke.h>
#include "dynamics/tree.h"
#include "reference/common/bench.h"
#include "reference/d3.h"

enum { ROUNDS = 5, WORK = 3000000 }; // links a round and way
static const double MOST = 45;       // ns a link

typedef struct Chain {
    size_t n;
    YkProblems *problems;
    YkModel *model;
    YkMechanism *mech;
    YkTreeDynamics *tree;
    double *q, *v, *a;         // relative
    double *theta, *w, *alpha; // absolute
    double *sine;
    D3Link *link;
} Chain;

static char *chain_text(size_t n)
{
    size_t at = 0;
    char *text = malloc(160 * n + 200);
    if (!text) return NULL;
    at += (size_t)sprintf(text, "gravity: [0, -9.81]\nbodies:\n  ground: {points: {J0: [0, 0]}}\n");
    for (size_t i = 0; i < n; i++)
        at +=
            (size_t)sprintf(text + at, "  b%zu: {points: {J%zu: [0, 0], J%zu: [0, -1]}, mass: 1, rod: [J%zu, J%zu]}\n",
                            i, i, i + 1, i, i + 1);
    at += (size_t)sprintf(text + at, "joints:\n");
    for (size_t i = 0; i < n; i++)
        at += i == 0 ? (size_t)sprintf(text + at, "  J0: {pin: [ground, b0]}\n")
                     : (size_t)sprintf(text + at, "  J%zu: {pin: [b%zu, b%zu]}\n", i, i - 1, i);
    return text;
}

static bool load(Chain *chain)
{
    bool fits = false;
    char *text = chain_text(chain->n);
    chain->problems = yk_problems_new();
    chain->model = text ? yk_model_parse(text, strlen(text), "chain.yaml", NULL, chain->problems) : NULL;
    chain->mech = chain->model ? yk_mechanism_compile(chain->model, NULL, chain->problems) : NULL;
    chain->tree = chain->mech ? yk_tree_dynamics_new(chain->mech, &fits) : NULL;
    free(text);
    if (!chain->tree) fprintf(stderr, "%s", yk_problems_text(chain->problems, 0));
    return chain->tree != NULL;
}

// The pose that the other programs of this comparison use.
static void pose(Chain *chain)
{
    for (size_t i = 0; i < chain->n; i++) {
        chain->q[i] = 0.01 * (double)(i * 7 % 11);
        chain->v[i] = 0.001 * ((double)(i * 5 % 7) - 3);
    }
    double angle = 0, rate = 0;
    for (size_t i = 0; i < chain->n; i++) {
        angle = fmod(angle + chain->q[i], 6.283185307179586);
        rate += chain->v[i];
        chain->theta[i] = angle;
        chain->w[i] = rate;
    }
}

static bool start(Chain *chain, size_t n)
{
    *chain = (Chain){.n = n};
    double *rows = malloc(8 * n * sizeof *rows);
    chain->link = malloc(n * sizeof *chain->link);
    chain->q = rows;
    if (!rows || !chain->link || !load(chain)) return false;
    chain->v = rows + n, chain->a = rows + 2 * n, chain->theta = rows + 3 * n, chain->w = rows + 4 * n;
    chain->alpha = rows + 5 * n, chain->sine = rows + 6 * n;
    pose(chain);
    return true;
}

static void end(Chain *chain)
{
    yk_tree_dynamics_free(chain->tree);
    yk_mechanism_free(chain->mech);
    yk_model_free(chain->model);
    yk_problems_free(chain->problems);
    free(chain->q);
    free(chain->link);
}

static void ours(Chain *chain)
{
    if (yk_tree_accelerate(chain->tree, chain->q, chain->v, NULL, chain->a) >= 0) exit(1);
    chain->q[0] += 1e-12;
}
static void by_hand(Chain *chain)
{
    d3_chain(chain->n, chain->theta, chain->w, chain->alpha, chain->link);
    chain->theta[0] += 1e-12;
}
static void by_lanes(Chain *chain)
{
    d3_chain_lanes(chain->n, chain->theta, chain->w, chain->alpha, chain->link, chain->sine);
    chain->theta[0] += 1e-12;
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// The largest difference of the absolute accelerations, over the largest of them.
static double difference(Chain *chain)
{
    double sum = 0, worst = 0, largest = 0;
    pose(chain);
    d3_chain(chain->n, chain->theta, chain->w, chain->alpha, chain->link);
    if (yk_tree_accelerate(chain->tree, chain->q, chain->v, NULL, chain->a) >= 0) exit(1);
    for (size_t i = 0; i < chain->n; i++) {
        sum += chain->a[i];
        worst = fmax(worst, fabs(sum - chain->alpha[i]));
        largest = fmax(largest, fabs(chain->alpha[i]));
    }
    return worst / largest;
}

static bool measure(size_t n)
{
    static void (*const ways[])(Chain *) = {ours, by_hand, by_lanes};
    enum { WAYS = sizeof ways / sizeof *ways };
    double ns[WAYS][ROUNDS];
    Chain chain;
    if (!start(&chain, n)) exit(1);
    double off = difference(&chain);
    size_t runs = (WORK + n - 1) / n;
    for (size_t r = 0; r < ROUNDS; r++)
        for (size_t way = 0; way < WAYS; way++) {
            double begin = bench_now();
            for (size_t k = 0; k < runs; k++) ways[way](&chain);
            ns[way][r] = (bench_now() - begin) * 1e9 / (double)(runs * n);
        }
    for (size_t way = 0; way < WAYS; way++) qsort(ns[way], ROUNDS, sizeof(double), ascending);
    double own = ns[0][ROUNDS / 2], hand = ns[1][ROUNDS / 2], lanes = ns[2][ROUNDS / 2];
    bool keeps = own <= MOST;
    printf("%9zu %9.2f %9.2f %9.2f %9.2f %9.2f %12.1e   %s <= %g ns\n", n, own, hand, own / hand, lanes, own / lanes,
           off, keeps ? "keeps" : "MISSES", MOST);
    fflush(stdout);
    end(&chain);
    return keeps;
}

int main(int argc, char **argv)
{
    printf("%9s %9s %9s %9s %9s %9s %12s\n", "links", "ours", "by hand", "ratio", "by lanes", "ratio", "difference");
    if (argc > 1) return measure((size_t)strtoull(argv[1], NULL, 10)) ? 0 : 2;
    bool keeps = true;
    for (size_t n = 10; n <= 1000000; n *= 10) keeps &= measure(n);
    return keeps ? 0 : 2;
}
