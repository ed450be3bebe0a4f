// Machines for the benches of dynamics, and medians over rounds.
#include "machine.h"
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static bool finish(Machine *m)
{
    m->mech = m->model ? yk_mechanism_compile(m->model, NULL, m->problems) : NULL;
    m->state = m->mech ? yk_state_new(m->mech) : NULL;
    m->dynamics = m->state ? yk_dynamics_new(m->mech, m->problems) : NULL;
    bool stands = m->dynamics && yk_state_set_time(m->state, 0, m->problems) >= 0 && yk_state_assemble(m->state) >= 0;
    if (!stands) fprintf(stderr, "%s", yk_problems_text(m->problems, 0));
    return stands;
}

bool machine_load(Machine *m, const char *path)
{
    *m = (Machine){.problems = yk_problems_new()};
    m->model = yk_model_load(path, NULL, m->problems);
    return finish(m);
}

bool machine_parse(Machine *m, const char *text)
{
    *m = (Machine){.problems = yk_problems_new()};
    m->model = text ? yk_model_parse(text, strlen(text), "bench.yaml", NULL, m->problems) : NULL;
    return finish(m);
}

void machine_end(Machine *m)
{
    yk_dynamics_free(m->dynamics);
    yk_state_free(m->state);
    yk_mechanism_free(m->mech);
    yk_model_free(m->model);
    yk_problems_free(m->problems);
}

void machine_accelerate(Machine *m, double *accelerations)
{
    if (yk_dynamics_accelerate(m->dynamics, m->state, accelerations) >= 0) return;
    fprintf(stderr, "%s\n", yk_dynamics_report(m->dynamics)->message);
    exit(1);
}

YkSimulation *machine_simulate(Machine *m, double tolerance, double horizon)
{
    YkSimulationOptions options = yk_default_simulation_options();
    options.tolerance = tolerance;
    options.horizon = horizon;
    YkSimulation *simulation = yk_simulation_new(m->model, &options, m->problems);
    if (simulation) return simulation;
    fprintf(stderr, "%s", yk_problems_text(m->problems, 0));
    exit(1);
}

// --- texts
// --------------------------------------------------------------------------------------------------------------

typedef struct Text {
    char *start;
    size_t at;
} Text;

static void add(Text *text, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    text->at += (size_t)vsprintf(text->start + text->at, format, list);
    va_end(list);
}

char *chain_text(size_t n)
{
    Text t = {malloc(160 * n + 200), 0};
    if (!t.start) return NULL;
    add(&t, "gravity: [0, -9.81]\nbodies:\n  ground: {points: {J0: [0, 0]}}\n");
    for (size_t i = 0; i < n; i++)
        add(&t, "  b%zu: {points: {J%zu: [0, 0], J%zu: [0, -1]}, mass: 1, rod: [J%zu, J%zu]}\n", i, i, i + 1, i, i + 1);
    add(&t, "joints:\n  J0: {pin: [ground, b0]}\n");
    for (size_t i = 1; i < n; i++) add(&t, "  J%zu: {pin: [b%zu, b%zu]}\n", i, i - 1, i);
    return t.start;
}

char *arm_text(size_t n)
{
    Text t = {malloc(250 * n + 300), 0};
    if (!t.start) return NULL;
    add(&t, "parameters: {g: 9.81");
    for (size_t i = 1; i <= n; i++) add(&t, ", l%zu: 1, lc%zu: 0.5, m%zu: 1, I%zu: 0.1", i, i, i, i);
    add(&t, "}\ngravity: [0, -g]\nbodies:\n  ground: {points: {J1: [0, 0]}}\n");
    for (size_t i = 1; i <= n; i++)
        add(&t, "  b%zu: {points: {J%zu: [0, 0], J%zu: [l%zu, 0]}, mass: m%zu, center: [lc%zu, 0], inertia: I%zu}\n", i,
            i, i + 1, i, i, i, i);
    add(&t, "joints:\n  J1: {pin: [ground, b1], angle: q1}\n");
    for (size_t i = 2; i <= n; i++) add(&t, "  J%zu: {pin: [b%zu, b%zu], angle: q%zu}\n", i, i - 1, i, i);
    return t.start;
}

static void add_rods(Text *t, size_t n)
{
    add(t, "gravity: [0, -9.81]\nbodies:\n  ground: {points: {A0: [0, 0]");
    for (size_t i = 1; i <= n; i++) add(t, ", A%zu: [%zu, 0]", i, i);
    add(t, "}}\n");
    for (size_t i = 0; i <= n; i++)
        add(t, "  link%zu: {points: {A%zu: [0, 0], B%zu: [1, 0]}, mass: 1, rod: [A%zu, B%zu]}\n", i, i, i, i, i);
    for (size_t i = 0; i < n; i++)
        add(t, "  rod%zu: {points: {B%zu: [0, 0], B%zu: [1, 0]}, mass: 1, rod: [B%zu, B%zu]}\n", i, i, i + 1, i, i + 1);
}

char *n_four_bar_text(size_t n)
{
    Text t = {malloc(600 * n + 600), 0};
    if (!t.start) return NULL;
    add_rods(&t, n);
    add(&t, "joints:\n");
    for (size_t i = 0; i <= n; i++) add(&t, "  A%zu: {pin: [ground, link%zu], angle: theta%zu}\n", i, i, i);
    for (size_t i = 0; i < n; i++) {
        add(&t, "  D%zu: {pin: [link%zu, rod%zu], at: B%zu, angle: psi%zu}\n", i, i, i, i, i);
        add(&t, "  C%zu: {pin: [rod%zu, link%zu], at: B%zu}\n", i, i, i + 1, i + 1);
    }
    add(&t, "start: {theta0: 90 deg, theta0.rate: -1 rad/s");
    for (size_t i = 0; i < n; i++) add(&t, ", theta%zu: 90 deg, psi%zu: -90 deg", i + 1, i);
    add(&t, "}\n");
    return t.start;
}

char *separate_loops_text(size_t n)
{
    Text t = {malloc(1000 * n + 200), 0};
    if (!t.start) return NULL;
    add(&t, "gravity: [0, -9.81]\nbodies:\n  ground:\n    points:\n");
    for (size_t i = 0; i < n; i++) add(&t, "      O%zu: [%zu, 0]\n      C%zu: [%zu, 0]\n", i, 3 * i, i, 3 * i + 2);
    for (size_t i = 0; i < n; i++) {
        add(&t, "  crank%zu: {points: {O%zu: [0, 0], A%zu: [1.5, 0]}, mass: 1, rod: [O%zu, A%zu]}\n", i, i, i, i, i);
        add(&t, "  coupler%zu: {points: {A%zu: [0, 0], B%zu: [1.8, 0]}, mass: 1, rod: [A%zu, B%zu]}\n", i, i, i, i, i);
        add(&t, "  rocker%zu: {points: {C%zu: [0, 0], B%zu: [1.2, 0]}, mass: 1, rod: [C%zu, B%zu]}\n", i, i, i, i, i);
    }
    add(&t, "joints:\n");
    for (size_t i = 0; i < n; i++) {
        add(&t, "  O%zu: {pin: [ground, crank%zu], angle: theta%zu}\n", i, i, i);
        add(&t, "  A%zu: {pin: [crank%zu, coupler%zu], angle: phi%zu}\n", i, i, i, i);
        add(&t, "  C%zu: {pin: [ground, rocker%zu], angle: psi%zu}\n", i, i, i);
        add(&t, "  B%zu: {pin: [coupler%zu, rocker%zu]}\n", i, i, i);
    }
    add(&t, "start: {");
    for (size_t i = 0; i < n; i++) {
        double part = (double)i / (double)n, angle = 1 + 0.2 * part, x = 2 - 1.5 * cos(angle), y = -1.5 * sin(angle);
        double square = x * x + y * y, psi = atan2(-y, -x) - acos((square + 1.44 - 3.24) / (2.4 * sqrt(square)));
        double phi = atan2(y + 1.2 * sin(psi), x + 1.2 * cos(psi)) - angle;
        add(&t, "%stheta%zu: %.17g, phi%zu: %.17g, psi%zu: %.17g, theta%zu.rate: %.17g", i > 0 ? ", " : "", i, angle, i,
            phi, i, psi, i, 2 + part);
    }
    add(&t, "}\n");
    return t.start;
}
