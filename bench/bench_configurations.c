// Every configuration of machines with groups, cold (the first pose of a topology) and warm (the next poses): CPU time.
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <yoke/configurations.h>
#include "machine.h"

enum { POSES = 40, ROUNDS = 5 };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// Enumerates at pose k of a small motion of the first input. Returns the time it took.
static double enumerate(YkConfigurations *all, Machine *m, double from, int k, YkConfigurationsReport *report)
{
    if (yk_input_count(m->mech) > 0) yk_state_set_input(m->state, 0, (YkMotion){from + 1e-3 * k, 0, 0});
    double begin = now();
    yk_configurations_each(all, m->state, NULL, NULL, NULL, report);
    return now() - begin;
}

static void measure(const char *name)
{
    char path[512];
    Machine m;
    double cold[ROUNDS], warm[ROUNDS] = {0};
    size_t complete = 0;
    YkConfigurationsReport report;
    snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, name);
    if (!machine_load(&m, path)) exit(1);
    double from = yk_state_input(m.state, 0).position;
    for (int round = 0; round < ROUNDS; round++) {
        YkConfigurations *all = yk_configurations_new(m.mech);
        if (!all) exit(1);
        cold[round] = enumerate(all, &m, from, 0, &report);
        complete += report.complete;
        for (int k = 1; k <= POSES; k++) {
            warm[round] += enumerate(all, &m, from, k, &report) / POSES;
            complete += report.complete;
        }
        yk_configurations_free(all);
    }
    printf("%s: %zu configurations at the last pose, %zu complex solutions; complete at %zu of %d poses; cold %.3g ms, "
           "warm %.3g ms\n",
           name, report.count, report.expected, complete, ROUNDS * (POSES + 1), 1e3 * median(cold, ROUNDS),
           1e3 * median(warm, ROUNDS));
    machine_end(&m);
}

int main(void)
{
    measure("stephenson-awkward");
    measure("double-butterfly");
    return 0;
}
