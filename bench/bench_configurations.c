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

static void measure_machine(const char *name, Machine *m, int poses)
{
    double cold[ROUNDS], warm[ROUNDS] = {0};
    size_t complete = 0, rounds = poses < POSES ? 1 : ROUNDS;
    YkConfigurationsReport report;
    double from = yk_input_count(m->mech) > 0 ? yk_state_input(m->state, 0).position : 0;
    for (size_t round = 0; round < rounds; round++) {
        YkConfigurations *all = yk_configurations_new(m->mech);
        if (!all) exit(1);
        cold[round] = enumerate(all, m, from, 0, &report);
        complete += report.complete;
        for (int k = 1; k <= poses; k++) {
            warm[round] += enumerate(all, m, from, k, &report) / poses;
            complete += report.complete;
        }
        yk_configurations_free(all);
    }
    printf(
        "%s: %zu configurations at the last pose, %zu complex solutions; complete at %zu of %zu poses; cold %.3g ms, "
        "warm %.3g ms\n",
        name, report.count, report.expected, complete, rounds * (size_t)(poses + 1), 1e3 * median(cold, rounds),
        1e3 * median(warm, rounds));
    fflush(stdout);
}

static void measure(const char *name)
{
    char path[512];
    Machine m;
    snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, name);
    if (!machine_load(&m, path)) exit(1);
    measure_machine(name, &m, POSES);
    machine_end(&m);
}

// --- structures: a short crank, the input, holds the first pin of the ground, so that there are other poses

static double draw(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) * 0x1p-53;
}

static size_t pin_of(char c)
{
    return (size_t)(c >= 'a' ? c - 'a' : c - 'A' + 26);
}

// Measures links with pins named by letters, the ground first, at random places.
static void measure_links(const char *name, const char *links, int poses, uint64_t seed)
{
    enum { PINS = 40 };
    double x[PINS], y[PINS];
    char first[PINS][24] = {{0}}, link_name[24] = "ground";
    Machine m = {.problems = yk_problems_new()};
    YkBuilder *b = yk_builder_new("structure");
    size_t link = 0, joint = 0;
    for (size_t k = 0; k < PINS; k++) {
        x[k] = 4 * draw(&seed) - 2;
        y[k] = 4 * draw(&seed) - 2;
    }
    size_t held = pin_of(links[0]);
    char letter[2] = {links[0], 0};
    yk_builder_body(b, "crank");
    yk_builder_point(b, "ground", "O", x[held] - 0.05, y[held]);
    yk_builder_point(b, "crank", "O", x[held] - 0.05, y[held]);
    yk_builder_point(b, "crank", letter, x[held], y[held]);
    yk_builder_pin(b, "O", "ground", "crank", "O", "u");
    for (const char *c = links; *c; link++) {
        if (link > 0) snprintf(link_name, sizeof link_name, "L%zu", link);
        if (link > 0) yk_builder_body(b, link_name);
        for (; *c && *c != ' '; c++) {
            size_t k = pin_of(*c);
            char pin[2] = {*c, 0}, joint_name[8];
            if (link == 0 && k == held) {
                snprintf(first[k], sizeof first[k], "crank");
                continue;
            }
            yk_builder_point(b, link_name, pin, x[k], y[k]);
            snprintf(joint_name, sizeof joint_name, "%s%zu", pin, joint++);
            if (first[k][0]) yk_builder_pin(b, joint_name, first[k], link_name, pin, NULL);
            if (!first[k][0]) snprintf(first[k], sizeof first[k], "%s", link_name);
        }
        while (*c == ' ') c++;
    }
    m.model = yk_builder_model(b, NULL, m.problems);
    const char *input = "u";
    YkCompileOptions options = {&input, 1};
    m.mech = m.model ? yk_mechanism_compile(m.model, &options, m.problems) : NULL;
    m.state = m.mech ? yk_state_new(m.mech) : NULL;
    if (!m.state) exit(1);
    measure_machine(name, &m, poses);
    yk_builder_free(b);
    machine_end(&m);
}

typedef struct Truss {
    const char *links;
    size_t count;
} Truss;

static const Truss nine_links[] = {
#include "../tests/configurations/nine_links.h"
};

int main(void)
{
    measure("stephenson-awkward");
    measure("double-butterfly");
    measure_links("triad", "abc ad be cf def", POSES, 1);
    measure_links("three-prism", "ab ac bc ad be cf de df ef", POSES, 1);
    measure_links("Watt-Baranov, 11 links", "adn abehk bcg cd efj fg him ij klo lm no", 2, 1);
    measure_links("Watt-Baranov, 13 links", "adq abehkn bcg cd efj fg him ij klp lm nor op qr", 2, 1);
    for (size_t k = 0; k < sizeof nine_links / sizeof *nine_links; k++)
        measure_links(nine_links[k].links, nine_links[k].links, 2, 40 + k);
    return 0;
}
