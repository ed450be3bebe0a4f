// Trusses under test: machines made of links whose pins are listed, with dimensions from one configuration.
#ifndef TESTS_CONFIGURATIONS_TRUSS_H
#define TESTS_CONFIGURATIONS_TRUSS_H
#include <time.h>
#include <yoke/configurations.h>
#include "solve/machine.h"

enum { TRUSS_PINS_MAX = 40, TRUSS_LINKS_MAX = 16 };

// Links, the ground first, as letters of their pins: "ad be cf abc" ... Pin k is letter 'a' + k. Every pin joins the
// links that name it (three at one place: two joints). x, y: where the pins are in the configuration that gives the
// dimensions.
typedef struct Truss {
    const char *links;
    double x[TRUSS_PINS_MAX], y[TRUSS_PINS_MAX];
    double mass; // of each link, at its first pin, with as much inertia
} Truss;

static inline void truss_scatter(Truss *truss, uint64_t seed)
{
    for (size_t k = 0; k < TRUSS_PINS_MAX; k++) {
        truss->x[k] = check_uniform(&seed, -2, 2);
        truss->y[k] = check_uniform(&seed, -2, 2);
    }
}

// Makes the platform def of a triad similar to the ground's abc: turned, smaller, and elsewhere.
static inline void truss_make_similar(Truss *t)
{
    for (int k = 0; k < 3; k++) {
        t->x[3 + k] = 0.3 + 0.5 * t->x[k] - 0.25 * t->y[k];
        t->y[3 + k] = -0.2 + 0.5 * t->y[k] + 0.25 * t->x[k];
    }
}

static inline Machine truss_machine(const Truss *truss)
{
    YkBuilder *b = yk_builder_new("truss");
    if (truss->mass > 0) yk_builder_gravity(b, 0, -9.81);
    const char *first[TRUSS_PINS_MAX] = {0};
    static const char *const names[TRUSS_LINKS_MAX] = {"ground", "L1", "L2",  "L3",  "L4",  "L5",  "L6",  "L7",
                                                       "L8",     "L9", "L10", "L11", "L12", "L13", "L14", "L15"};
    size_t link = 0, joint = 0;
    assert_non_null(b);
    for (const char *c = truss->links; *c; link++) {
        if (link > 0) yk_builder_body(b, names[link]);
        size_t own = (size_t)(*c >= 'a' ? *c - 'a' : *c - 'A' + 26);
        for (; *c && *c != ' '; c++) {
            char pin[2] = {*c, 0}, name[8];
            size_t k = (size_t)(*c >= 'a' ? *c - 'a' : *c - 'A' + 26);
            yk_builder_point(b, names[link], pin, truss->x[k], truss->y[k]);
            snprintf(name, sizeof name, "%s%zu", pin, joint++);
            if (first[k])
                yk_builder_pin(b, name, first[k], names[link], pin, NULL);
            else
                first[k] = names[link];
        }
        if (link > 0 && truss->mass > 0)
            yk_builder_mass(b, names[link], truss->mass, truss->x[own], truss->y[own], truss->mass);
        while (*c == ' ') c++;
    }
    Machine m = {.problems = yk_problems_new()};
    m.model = yk_builder_model(b, NULL, m.problems);
    machine_compile(&m, NULL);
    yk_builder_free(b);
    return m;
}
#endif
