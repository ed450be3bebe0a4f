// Syntheses whose allocations fail one after the other: refused, or complete.
#include "../survive.h"
#include "solve/machine.h"
#include <yoke/synthesis.h>

typedef struct Search {
    const char *text;
    size_t count; // of machines, once it is known
} Search;

static bool search(void *context)
{
    Search *s = context;
    YkTask *task = yk_task_parse(s->text, strlen(s->text), "task.yaml", NULL);
    YkSynthesis *found = task ? yk_synthesis_run(task, NULL, NULL) : NULL;
    bool good = found && yk_synthesis_picture(found);
    if (good) {
        size_t count = yk_synthesis_count(found);
        assert_true(count > 0 && (s->count == 0 || count == s->count));
        s->count = count;
    }
    yk_synthesis_free(found);
    yk_task_free(task);
    return good;
}

static void searches_survive(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    static const char *const texts[] = {
        "name: rocker\nsynthesis: stroke\nswing: 40 deg\ntime_ratio: 1.2\nfix: {output: 80 mm}\n",
        "name: body\nsynthesis: motion\npositions:\n  - {at: [0, 0], angle: 0 deg}\n  - {at: [0.5, 1], angle: 20 deg}\n"
        "  - {at: [1.5, 1.5], angle: 35 deg}\n  - {at: [2.5, 1.25], angle: 40 deg}\n  - {at: [3, 0.5], angle: 30 "
        "deg}\n"};
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++) {
        Search s = {.text = texts[k]};
        survive(search, &s, texts[k]);
    }
}

static bool cognates(void *context)
{
    const Machine *m = context;
    YkCognates *found = yk_cognates_new(m->state, YK_NOT_FOUND, NULL);
    bool good = found && yk_cognates_picture(found);
    if (good) assert_int_equal(yk_cognates_count(found), 2);
    yk_cognates_free(found);
    return good;
}

static void cognates_survive(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    Machine m = machine_load("four-bar");
    survive(cognates, &m, "cognates");
    machine_free(&m);
}

int main(void)
{
    start_counting();
    const struct CMUnitTest tests[] = {cmocka_unit_test(searches_survive), cmocka_unit_test(cognates_survive)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
