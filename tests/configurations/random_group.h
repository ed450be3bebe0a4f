// Random machines without freedom, of pins, slides and pin-slots, whose loops close where no body is turned.
#ifndef TESTS_CONFIGURATIONS_RANDOM_GROUP_H
#define TESTS_CONFIGURATIONS_RANDOM_GROUP_H
#include <yoke/configurations.h>
#include "compile/mechanism.h"
#include "solve/machine.h"

enum { RANDOM_GROUP_BODIES_MAX = 9 };

// Adds a joint of a kind ('R', 'P' or 'S') at a random place of two bodies.
static inline void random_group_join(YkBuilder *b, const char *name, char kind, const char *first, const char *second,
                                     uint64_t *seed)
{
    double x = check_uniform(seed, -2, 2), y = check_uniform(seed, -2, 2), line = check_uniform(seed, 0, 3);
    double d = kind == 'R' ? 0 : check_uniform(seed, 0.5, 2);
    char along[32], to[16];
    snprintf(along, sizeof along, "%.17g rad", line);
    snprintf(to, sizeof to, "%sto", name);
    yk_builder_point(b, first, name, x, y);
    if (kind == 'R') yk_builder_point(b, second, name, x, y);
    if (kind == 'R') yk_builder_pin(b, name, first, second, name, NULL);
    if (kind != 'R') yk_builder_point(b, second, to, x + d * yk_cos(line), y + d * yk_sin(line));
    if (kind == 'P') yk_builder_slide(b, name, first, second, along, name, to, NULL);
    if (kind == 'S') yk_builder_slot(b, name, first, second, along, name, to, NULL, NULL);
}

// Makes a machine with the given number of loops. Pins and slides take two freedoms, slots take one.
static inline Machine random_group_machine(size_t loops, uint64_t seed)
{
    static const char *const names[] = {"ground", "b1", "b2", "b3", "b4", "b5", "b6", "b7", "b8"};
    bool joined[RANDOM_GROUP_BODIES_MAX][RANDOM_GROUP_BODIES_MAX] = {{false}};
    // 3 bodies = 2 joints + slots, and joints + slots = bodies + loops: bodies + slots = 2 loops.
    size_t slots = (size_t)(check_uniform(&seed, 0, 1) * (double)(loops + 1)), bodies = 2 * loops - slots;
    if (bodies < 2) slots = 2 * loops - (bodies = 2);
    YkBuilder *b = yk_builder_new("group");
    Machine m = {.problems = yk_problems_new()};
    assert_non_null(b);
    for (size_t k = 1; k <= bodies; k++) yk_builder_body(b, names[k]);
    for (size_t k = 0; k < bodies + loops; k++) {
        size_t first, second;
        do {
            // The first joints hang every body on an earlier one; the others close loops.
            second = k < bodies ? k + 1 : (size_t)(check_uniform(&seed, 0, 1) * (double)(bodies + 1));
            first = (size_t)(check_uniform(&seed, 0, 1) * (double)(k < bodies ? second : bodies + 1));
        } while (first == second || (joined[first][second] && check_uniform(&seed, 0, 1) < 0.9));
        joined[first][second] = joined[second][first] = true;
        bool is_slot = k >= bodies + loops - slots, is_slide = check_uniform(&seed, 0, 1) < 0.25;
        char name[8];
        snprintf(name, sizeof name, "j%zu", k);
        random_group_join(b, name, is_slot ? 'S' : is_slide ? 'P' : 'R', names[first], names[second], &seed);
    }
    m.model = yk_builder_model(b, NULL, m.problems);
    if (!m.model) print_error("%s", yk_problems_text(m.problems, 0));
    YkCompileOptions options = {NULL, 0};
    m.mech = m.model ? yk_mechanism_compile(m.model, &options, m.problems) : NULL;
    m.state = m.mech ? yk_state_new(m.mech) : NULL;
    yk_builder_free(b);
    return m;
}

// Returns whether the machine is one group of that many loops without freedom.
static inline bool random_group_is_one(const Machine *m, size_t loops)
{
    if (!m->state || yk_input_count(m->mech) > 0) return false;
    if (m->mech->block_count != 1 || m->mech->blocks[0].kind != YK_BLOCK_GROUP) return false;
    const YkBlock *block = &m->mech->blocks[0];
    return block->loop_count == loops && block->column_count == 2 * loops;
}
#endif
