// A whole derivation: the frame, all sections that `yoke derive` prints when none is named, or one of them, and the page
// in text, from a compiled machine.
#include <stdlib.h>
#include <string.h>
#include "derive/derive.h"
#include "machine.h"
#include "page/print.h"
#include "reference/common/bench.h"

enum { ROUNDS = 25, SECTIONS_MAX = 16, FRAME = SECTIONS_MAX, PRINT, PARTS };
static const double SPAN = 0.02; // seconds a round at least, so that the clock's grain does not matter

typedef struct Times {
    double part[PARTS][ROUNDS], all[ROUNDS]; // seconds
    size_t bytes;
} Times;

static void die(const char *what)
{
    fprintf(stderr, "%s\n", what);
    exit(1);
}

// One derivation from beginning to end, with one section if `only` is not NULL; adds to the times of round r.
static void derive_once(const Machine *m, const char *only, Times *times, size_t r)
{
    YkText text = {0};
    double start = bench_now(), before = start, now;
    YkDerivation *d = yk_derivation_new(m->model, m->mech, m->problems);
    YkPage page = {.arena = yk_arena_new(), .ring = d ? d->ring : NULL};
    if (!d || !page.arena) die("no derivation");
    times->part[FRAME][r] += (now = bench_now()) - before;
    for (size_t k = 0; yk_derive_sections[k].name; k++) {
        before = now;
        bool is_asked = only ? strcmp(only, yk_derive_sections[k].name) == 0 : yk_derivation_has_section(d, k);
        if (is_asked && !yk_derive_write(d, k, &page)) die(yk_derive_sections[k].name);
        times->part[k][r] += (now = bench_now()) - before;
    }
    before = now;
    if (!yk_page_write(&page, YK_PAGE_TEXT, "bench", NULL, &text)) die("not printed");
    times->part[PRINT][r] += (now = bench_now()) - before;
    times->bytes = text.length;
    before = now;
    yk_text_free(&text);
    yk_arena_free(page.arena);
    yk_derivation_free(d);
    times->part[FRAME][r] += (now = bench_now()) - before;
    times->all[r] += now - start;
}

static Times time_machine(const Machine *m, const char *only)
{
    Times times = {.bytes = 0};
    for (size_t r = 0; r < ROUNDS; r++) {
        size_t runs = 0;
        for (; times.all[r] < SPAN; runs++) derive_once(m, only, &times, r);
        for (size_t k = 0; k < PARTS; k++) times.part[k][r] /= (double)runs;
        times.all[r] /= (double)runs;
    }
    return times;
}

static const char *part_name(size_t k)
{
    return k == FRAME ? "frame" : k == PRINT ? "print" : yk_derive_sections[k].name;
}

// The whole against what is asked, in milliseconds; then its parts in microseconds.
static bool show(const char *name, Times *times, double most)
{
    double middle = 1e3 * median(times->all, ROUNDS);
    bool keeps = middle <= most;
    printf("%-22s %8.3f %8.3f %8.3f %8zu   %s <= %g ms\n", name, middle, 1e3 * times->all[0],
           1e3 * times->all[ROUNDS - 1], times->bytes, keeps ? "keeps" : "MISSES", most);
    printf("   us:");
    for (size_t k = 0; k < PARTS; k++) {
        double us = 1e6 * median(times->part[k], ROUNDS);
        if (us > 0.05) printf(" %s %.1f,", part_name(k), us);
    }
    printf("\n");
    return keeps;
}

static bool run(Machine *m, bool stands, const char *only, const char *name, double most)
{
    if (!stands) exit(1);
    Times times = time_machine(m, only);
    machine_end(m);
    return show(name, &times, most);
}

static bool run_file(const char *path, const char *name, double most)
{
    Machine m;
    return run(&m, machine_load(&m, path), NULL, name, most);
}

static bool run_arm(size_t links, const char *name, double most)
{
    Machine m;
    char *text = arm_text(links);
    bool stands = machine_parse(&m, text);
    free(text);
    return run(&m, stands, NULL, name, most);
}

// The free bodies of a ladder of four-bars, which go from body to body: 4 us each.
static bool run_ladder(size_t four_bars, const char *name)
{
    Machine m;
    char *text = n_four_bar_text(four_bars);
    bool stands = machine_parse(&m, text);
    free(text);
    return run(&m, stands, "free-bodies", name, 4e-3 * (double)(2 * four_bars + 1));
}

int main(void)
{
    printf("%-22s %8s %8s %8s %8s\n", "everything, in text", "ms", "least", "most", "bytes");
    bool keeps = run_file(YOKE_ROOT "/examples/double-pendulum.yaml", "double pendulum", 0.1);
    keeps &= run_file(YOKE_ROOT "/examples/toggle.yaml", "toggle linkage", 0.3);
    keeps &= run_arm(8, "arm of 8 links", 1.5);
    keeps &= run_arm(20, "arm of 20 links", 20);
    keeps &= run_ladder(100, "ladder of 201 bodies");
    keeps &= run_ladder(1000, "ladder of 2001 bodies");
    return keeps ? 0 : 2;
}
