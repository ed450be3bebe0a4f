// Shared by the tests of derivations: a machine from text or from the examples, its symbols, its numbers at random
// poses.
#ifndef TESTS_DERIVE_CHECK_H
#define TESTS_DERIVE_CHECK_H
#include "check.h"
#include <dirent.h>
#include <stdlib.h>
#include <yoke/yoke.h>
#include "derive/blocks.h"
#include "derive/derive.h"
#include "page/print.h"
#include "prove/loop_point.h"

typedef struct Machine {
    YkProblems *problems;
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
    YkDerivation *d;
    YkPage page;
    double *values; // [value_count]
    size_t value_count;
    uint64_t seed;
} Machine;

static inline void machine_end(Machine *m)
{
    free(m->values);
    yk_arena_free(m->page.arena);
    yk_derivation_free(m->d);
    yk_state_free(m->state);
    yk_mechanism_free(m->mech);
    yk_model_free(m->model);
    yk_problems_free(m->problems);
}

// A random point of the machine's motion over the prime field, or NULL.
static inline YkFieldPoint *loop_point(YkDerivation *d, uint64_t seed, bool *is_possible)
{
    int rank;
    return yk_derive_assembly_point(d, NULL, seed, &rank, is_possible);
}

// What is 0 wherever the formula holds: factor * left - right; NULL if it is no equation.
static inline const YkPoisson *line_vanishes(YkRing *ring, const YkLine *line)
{
    const YkPoisson *left = line->factor ? yk_ring_multiply(ring, line->factor, line->left) : line->left;
    return left && line->right ? yk_ring_subtract(ring, left, line->right) : left;
}

static inline bool machine_finish(Machine *m)
{
    m->mech = m->model ? yk_mechanism_compile(m->model, NULL, m->problems) : NULL;
    if (!m->mech) return false;
    m->state = yk_state_new(m->mech);
    m->d = yk_derivation_new(m->model, m->mech, m->problems);
    m->page = (YkPage){.arena = yk_arena_new(), .ring = m->d ? m->d->ring : NULL};
    return m->state && m->d && m->page.arena;
}

static inline bool machine_open(Machine *m, const char *path)
{
    *m = (Machine){.problems = yk_problems_new(), .seed = 11};
    m->model = yk_model_load(path, NULL, m->problems);
    return machine_finish(m);
}

static inline Machine machine_of(const char *text)
{
    Machine m = {.problems = yk_problems_new(), .seed = 7};
    m.model = yk_model_parse(text, strlen(text), "test", NULL, m.problems);
    if (!machine_finish(&m)) {
        print_error("%s\n", yk_problems_text(m.problems, 0));
        fail();
    }
    return m;
}

static inline Machine example(const char *name)
{
    Machine m;
    char path[512];
    snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, name);
    if (!machine_open(&m, path)) {
        print_error("%s\n%s\n", path, yk_problems_text(m.problems, 0));
        fail();
    }
    return m;
}

static inline size_t section_of(const char *name)
{
    size_t k = 0;
    while (yk_derive_sections[k].name && strcmp(yk_derive_sections[k].name, name) != 0) k++;
    return k;
}

// Fills values at the pose of the state.
static inline void take_values(Machine *m)
{
    free(m->values);
    m->value_count = yk_ring_symbol_count(m->d->ring) + 64; // reading back brings symbols of its own
    m->values = calloc(m->value_count, sizeof *m->values);
    assert_non_null(m->values);
    yk_derive_values(m->d, m->state, NULL, m->values);
}

// The values for a page to print: of every symbol that there is now; of those made since, none.
static inline const double *page_values(Machine *m)
{
    size_t count = yk_ring_symbol_count(m->d->ring);
    double *values = m->values && count > m->value_count ? realloc(m->values, count * sizeof *values) : m->values;
    if (values == NULL) return NULL;
    for (size_t k = m->value_count; k < count; k++) values[k] = NAN;
    if (count > m->value_count) m->value_count = count;
    return m->values = values;
}

// The page can be written in every format, and every name in it is there.
static inline void check_formats(Machine *m, const char *title, const double *values)
{
    for (size_t format = 0; format < YK_PAGE_FORMATS; format++) {
        YkText text = {0};
        assert_true(yk_page_write(&m->page, (YkPageFormat)format, title, values, &text));
        assert_null(strstr(yk_text_get(&text), "(null)"));
        yk_text_free(&text);
    }
}

// Assembles at the start, then moves the inputs by random amounts with random rates; false where that does not close.
static inline bool random_pose(Machine *m, bool start)
{
    if (start) {
        yk_state_set_time(m->state, 0, NULL);
        if (yk_state_assemble(m->state) < 0) return false;
    }
    for (size_t i = 0; i < yk_input_count(m->mech); i++) {
        YkMotion motion = yk_state_input(m->state, i);
        bool is_distance = yk_coordinate_info(m->mech, yk_input_coordinate(m->mech, i)).is_distance;
        double size = is_distance ? yk_mechanism_size(m->mech) : 1;
        if (!start) motion.position += size * check_uniform(&m->seed, -0.2, 0.2);
        motion.velocity = size * check_uniform(&m->seed, -2, 2);
        motion.acceleration = size * check_uniform(&m->seed, -2, 2);
        yk_state_set_input(m->state, i, motion);
    }
    if (yk_state_solve(m->state) < 0 || !yk_state_has_rates(m->state)) return false;
    take_values(m);
    return true;
}

// What the element comes to off the machine: the measure for rounding.
static inline double off_machine(const Machine *m, const YkPoisson *a)
{
    double *values = calloc(yk_ring_symbol_count(m->d->ring) + 64, sizeof *values);
    memcpy(values, m->values, yk_ring_symbol_count(m->d->ring) * sizeof *values);
    for (size_t k = 0; k < m->d->coordinate_count; k++) {
        values[m->d->coordinates[k].position] += 0.7;
        values[m->d->coordinates[k].rate] += 0.9;
        values[m->d->coordinates[k].acceleration] += 1.1;
    }
    yk_ring_complete(m->d->ring, values);
    YkVec value = yk_ring_value(m->d->ring, a, values);
    free(values);
    return fmax(1, hypot(value.x, value.y));
}

static inline const YkPoisson *read_in(Machine *m, const char *text)
{
    YkProblems *problems = yk_problems_new();
    const YkPoisson *a = yk_ring_read(m->d->ring, YK_RING_TEXT, text, strlen(text), (YkPlace){1, 1, 0}, problems);
    if (!a) print_error("%s\n%s", text, yk_problems_text(problems, 0));
    yk_problems_free(problems);
    assert_non_null(a);
    return a;
}

static inline void check_element(Machine *m, const YkPoisson *a, const char *expected)
{
    if (yk_ring_is_same(a, read_in(m, expected))) return;
    YkText text = {0};
    yk_ring_write(m->d->ring, a, YK_RING_TEXT, YK_RING_TEXTBOOK, &text);
    print_error("%s\nis not\n%s\n", yk_text_get(&text), expected);
    yk_text_free(&text);
    fail();
}

static inline YkCheckVerdict verdict_on(Machine *m, const char *equation)
{
    yk_state_set_time(m->state, 0, NULL);
    assert_true(yk_state_assemble(m->state) >= 0);
    return yk_derive_check(m->d, m->state, NULL, equation, strlen(equation), (YkPlace){1, 1, 0}, m->problems);
}

// Calls visit for every example that loads, with its derivation. Returns how many there were.
static inline size_t each_example(void (*visit)(Machine *m, const char *name))
{
    size_t count = 0;
    DIR *folder = opendir(YOKE_ROOT "/examples");
    assert_non_null(folder);
    for (const struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        char path[600];
        Machine m;
        size_t length = strlen(entry->d_name);
        if (length < 5 || strcmp(entry->d_name + length - 5, ".yaml") != 0) continue;
        snprintf(path, sizeof path, "%s/examples/%s", YOKE_ROOT, entry->d_name);
        if (machine_open(&m, path)) {
            visit(&m, entry->d_name);
            count++;
        } else if (m.mech) {
            print_error("%s: %s\n", entry->d_name, yk_problems_text(m.problems, 0));
            fail();
        }
        machine_end(&m);
    }
    closedir(folder);
    return count;
}
// The page as text; it stands until the next call.
static inline const char *page_text(Machine *m, bool numbers)
{
    static char kept[60000];
    YkText text = {0};
    assert_true(yk_page_write(&m->page, YK_PAGE_TEXT, NULL, numbers ? page_values(m) : NULL, &text));
    assert_true(text.length < sizeof kept);
    memcpy(kept, yk_text_get(&text), text.length + 1);
    yk_text_free(&text);
    return kept;
}

static inline void expect(const char *text, const char *line)
{
    if (strstr(text, line)) return;
    print_error("no line\n%s\nin\n%s", line, text);
    fail();
}

#endif
