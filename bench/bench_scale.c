// Scale: a ladder of N four-bars, its text made in memory: load, compile, assemble, solve, in time per link.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <yoke/yoke.h>

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// Windows of ground, two cranks and a bar; 2 n + 1 moving links.
static char *ladder(size_t n)
{
    size_t capacity = 400 * n + 1000, at = 0;
    char *text = malloc(capacity);
    if (!text) exit(1);
    at += (size_t)sprintf(text + at, "name: ladder\nbodies:\n  ground: {points: {");
    for (size_t i = 0; i <= n; i++) at += (size_t)sprintf(text + at, "%sO%zu: [%zu, 0]", i ? ", " : "", i, i);
    at += (size_t)sprintf(text + at, "}}\n");
    for (size_t i = 0; i <= n; i++)
        at += (size_t)sprintf(text + at, "  c%zu: {points: {O%zu: [0, 0], A%zu: [0, 1]}}\n", i, i, i);
    for (size_t i = 0; i < n; i++)
        at += (size_t)sprintf(text + at, "  b%zu: {points: {A%zu: [0, 0], A%zu: [1, 0]}}\n", i, i, i + 1);
    at += (size_t)sprintf(text + at, "joints:\n");
    for (size_t i = 0; i <= n; i++) at += (size_t)sprintf(text + at, "  O%zu: {pin: [ground, c%zu]}\n", i, i);
    for (size_t i = 0; i < n; i++)
        at += (size_t)sprintf(text + at, "  A%zu: {pin: [c%zu, b%zu]}\n  B%zu: {pin: [b%zu, c%zu], at: A%zu}\n", i, i,
                              i, i, i, i + 1, i + 1);
    sprintf(text + at, "drives: {O0.angle: 0.3 rad/s * t}\n");
    return text;
}

static void measure(size_t n)
{
    char *text = ladder(n);
    size_t length = strlen(text);
    double links = (double)(2 * n + 1), t0 = now();
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, length, "ladder.yaml", NULL, problems);
    double t1 = now();
    YkMechanism *mech = model ? yk_mechanism_compile(model, NULL, problems) : NULL;
    double t2 = now();
    YkState *state = mech ? yk_state_new(mech) : NULL;
    double t3 = now();
    YkStatus status = state ? yk_state_assemble(state) : YK_BAD_MODEL;
    double t4 = now();
    yk_state_set_input(state, 0, (YkMotion){0.5, 0.3, 0});
    if (status >= 0) status = yk_state_solve(state);
    double t5 = now();
    YkMotion last = yk_state_body(state, n + 1);
    printf("%8zu links %6.1f MB: load %7.1f, compile %7.1f, state %6.1f, assemble %7.1f, solve %6.1f ns a link; status "
           "%s, last crank %.15g\n",
           2 * n + 1, (double)length * 1e-6, (t1 - t0) / links * 1e9, (t2 - t1) / links * 1e9, (t3 - t2) / links * 1e9,
           (t4 - t3) / links * 1e9, (t5 - t4) / links * 1e9, yk_status_name(status), last.position);
    yk_state_free(state);
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
    free(text);
}

int main(int argc, char **argv)
{
    if (argc > 1) {
        measure((size_t)strtoull(argv[1], NULL, 10));
        return 0;
    }
    for (size_t n = 50; n <= 500000; n *= 10) measure(n);
    return 0;
}
