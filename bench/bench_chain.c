// Forward dynamics of a hanging chain of N uniform rods: from a model file, against the recursion written by hand for
// this chain alone. Time per link; all ways take turns in one run, and the median of the rounds counts.
#include <math.h>
#include <stdlib.h>
#include "equations/tree.h"
#include "machine.h"
#include "reference/common/bench.h"
#include "reference/d3.h"

enum { ROUNDS = 5, WORK = 3000000 }; // links a round and way
static const double MOST = 45;       // ns a link

typedef struct Chain {
    size_t n;
    Machine machine;
    YkTreeDynamics *tree;
    double *q, *v, *a;         // relative
    double *theta, *w, *alpha; // absolute
    double *sine;
    D3Link *link;
} Chain;

static bool load(Chain *chain)
{
    bool fits = false;
    char *text = chain_text(chain->n);
    if (machine_parse(&chain->machine, text)) chain->tree = yk_tree_dynamics_new(chain->machine.mech, &fits);
    free(text);
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

// Inputs come in the order of the joints.
static void set_inputs(Chain *chain)
{
    for (size_t i = 0; i < chain->n; i++)
        yk_state_set_input(chain->machine.state, i, (YkMotion){.position = chain->q[i], .velocity = chain->v[i]});
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
    set_inputs(chain);
    return true;
}

static void end(Chain *chain)
{
    yk_tree_dynamics_free(chain->tree);
    machine_end(&chain->machine);
    free(chain->q);
    free(chain->link);
}

static void by_dynamics(Chain *chain)
{
    yk_state_set_input(chain->machine.state, 0, (YkMotion){.position = chain->q[0], .velocity = chain->v[0]});
    machine_accelerate(&chain->machine, chain->a);
    chain->q[0] += 1e-12;
}
static void by_tree(Chain *chain)
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

// The largest difference of the absolute accelerations, over the largest of them.
static double difference(Chain *chain)
{
    double sum = 0, worst = 0, largest = 0;
    pose(chain);
    by_hand(chain);
    by_dynamics(chain);
    for (size_t i = 0; i < chain->n; i++) {
        sum += chain->a[i];
        worst = fmax(worst, fabs(sum - chain->alpha[i]));
        largest = fmax(largest, fabs(chain->alpha[i]));
    }
    return worst / largest;
}

static bool measure(size_t n)
{
    static void (*const ways[])(Chain *) = {by_dynamics, by_tree, by_hand, by_lanes};
    enum { WAYS = sizeof ways / sizeof *ways };
    double ns[WAYS][ROUNDS], at[WAYS];
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
    for (size_t way = 0; way < WAYS; way++) at[way] = median(ns[way], ROUNDS);
    bool keeps = at[0] <= MOST;
    printf("%9zu %9.2f %9.2f %9.2f %9.2f %9.2f %9.2f %12.1e   %s <= %g ns\n", n, at[0], at[1], at[2], at[0] / at[2],
           at[3], at[0] / at[3], off, keeps ? "keeps" : "MISSES", MOST);
    fflush(stdout);
    char task[80];
    snprintf(task, sizeof task, "open chain of %zu links, forward dynamics, a link", n);
    bool has_ratio = row(task, at[2], at[0], "ns", 1.3, off);
    end(&chain);
    return keeps && has_ratio;
}

int main(int argc, char **argv)
{
    printf("ns a link; ours: yk_dynamics_accelerate\n");
    printf("%9s %9s %9s %9s %9s %9s %9s %12s\n", "links", "ours", "tree", "by hand", "ratio", "by lanes", "ratio",
           "difference");
    if (argc > 1) return measure((size_t)strtoull(argv[1], NULL, 10)) ? 0 : 2;
    bool keeps = true;
    for (size_t n = 10; n <= 1000000; n *= 10) keeps &= measure(n);
    return keeps ? 0 : 2;
}
