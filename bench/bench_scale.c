// Scale: ladders of four-bars and hanging chains of up to 1e6 links, their texts made in memory: load, compile,
// assemble, solve, one right-hand side of the dynamics - time a link - and the memory that all of it takes.
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include "machine.h"
#include "reference/common/bench.h"

enum { PARTS = 5 };

typedef struct Scale {
    const char *name;
    char *(*text)(size_t n);
    size_t links_each; // of a loop or rod
} Scale;

static const Scale scales[] = {{"ladder of four-bars", n_four_bar_text, 2}, {"chain", chain_text, 1}};

static void die(Machine *m)
{
    fprintf(stderr, "%s", yk_problems_text(m->problems, 0));
    exit(1);
}

// ns a link of each part, and bytes a link at the end.
static void measure(const Scale *scale, size_t n, double *ns, double *bytes)
{
    double links = (double)(scale->links_each * n), before = bench_rss_mb(), t[PARTS + 1];
    char *text = scale->text(n);
    Machine m = {.problems = yk_problems_new()};
    double *a = calloc(n + 2, sizeof *a);
    if (!text || !a) exit(1);
    t[0] = bench_now();
    m.model = yk_model_parse(text, strlen(text), "scale.yaml", NULL, m.problems);
    t[1] = bench_now();
    m.mech = m.model ? yk_mechanism_compile(m.model, NULL, m.problems) : NULL;
    t[2] = bench_now();
    m.state = m.mech ? yk_state_new(m.mech) : NULL;
    if (!m.state || yk_state_assemble(m.state) < 0) die(&m);
    t[3] = bench_now();
    if (yk_state_solve(m.state) < 0) die(&m);
    t[4] = bench_now();
    m.dynamics = yk_dynamics_new(m.mech, m.problems);
    if (!m.dynamics) die(&m);
    machine_accelerate(&m, a); // prepares
    double start = bench_now();
    machine_accelerate(&m, a);
    ns[4] = (bench_now() - start) / links * 1e9;
    for (int k = 0; k < 4; k++) ns[k] = (t[k + 1] - t[k]) / links * 1e9;
    *bytes = (bench_rss_mb() - before) * 1048576 / links;
    machine_end(&m);
    free(a);
    free(text);
}

// In a process of its own, so that the memory is its own.
static void measure_apart(const Scale *scale, size_t links)
{
    double ns[PARTS], bytes;
    fflush(stdout);
    pid_t child = fork();
    if (child != 0) {
        waitpid(child, NULL, 0);
        return;
    }
    measure(scale, links / scale->links_each, ns, &bytes);
    printf("%-22s %9zu %9.0f %9.0f %9.0f %9.0f %9.1f %9.0f\n", "", links, ns[0], ns[1], ns[2], ns[3], ns[4], bytes);
    printf("scale\t%s\t%zu\t%.0f ns\t%.0f ns\t%.0f ns\t%.0f ns\t%.1f ns\t%.1f kB\n", scale->name, links, ns[0], ns[1],
           ns[2], ns[3], ns[4], bytes / 1000);
    fflush(stdout);
    _exit(0);
}

int main(int argc, char **argv)
{
    size_t most = argc > 1 ? (size_t)strtoull(argv[1], NULL, 10) : 1000000;
    for (size_t s = 0; s < sizeof scales / sizeof *scales; s++) {
        const Scale *scale = &scales[s];
        printf("%-22s %9s %9s %9s %9s %9s %9s %9s\n", scale->name, "links", "load", "compile", "assemble", "solve",
               "dynamics", "bytes");
        for (size_t links = 100; links <= most; links *= 10) measure_apart(scale, links);
    }
    return 0;
}
