// A whole derivation: the frame, all sections that `yoke derive` prints when none is named, and the page in text, from
// a compiled machine; and the free bodies of a ladder of four-bars, as the command streams them.
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

// One derivation from beginning to end; adds to the times of round r.
static void derive_once(const Machine *m, Times *times, size_t r)
{
    YkText text = {0};
    double start = bench_now(), before = start, now;
    YkDerivation *d = yk_derivation_new(m->model, m->mech, m->problems);
    YkPage page = {.arena = yk_arena_new(), .ring = d ? d->ring : NULL};
    if (!d || !page.arena) die("no derivation");
    times->part[FRAME][r] += (now = bench_now()) - before;
    for (size_t k = 0; yk_derive_sections[k].name; k++) {
        before = now;
        if (yk_derivation_has_section(d, k) && !yk_derive_write(d, k, &page)) die(yk_derive_sections[k].name);
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

static bool take(void *context, const char *text, size_t length)
{
    (void)text;
    *(size_t *)context += length;
    return true;
}

static void stream_free_bodies(const Machine *m, Times *times, size_t r)
{
    bool sections[SECTIONS_MAX] = {false};
    sections[yk_derivation_section_find("free-bodies")] = true;
    YkPageOptions options = yk_default_page_options();
    options.sections = sections, options.write = take, options.context = &times->bytes;
    times->bytes = 0;
    double start = bench_now();
    YkDerivation *d = yk_derivation_new(m->model, m->mech, m->problems);
    if (!d || yk_derivation_page(d, &options, m->problems) != YK_OK) die("no page");
    yk_derivation_free(d);
    times->all[r] += bench_now() - start;
}

static Times time_machine(const Machine *m, void (*once)(const Machine *m, Times *times, size_t r))
{
    Times times = {.bytes = 0};
    for (size_t r = 0; r < ROUNDS; r++) {
        size_t runs = 0;
        for (; times.all[r] < SPAN; runs++) once(m, &times, r);
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
    if (times->part[FRAME][ROUNDS - 1] == 0) return keeps;
    printf("   us:");
    for (size_t k = 0; k < PARTS; k++) {
        double us = 1e6 * median(times->part[k], ROUNDS);
        if (us > 0.05) printf(" %s %.1f,", part_name(k), us);
    }
    printf("\n");
    return keeps;
}

static bool run(Machine *m, bool stands, const char *name, double most)
{
    if (!stands) exit(1);
    Times times = time_machine(m, derive_once);
    machine_end(m);
    return show(name, &times, most);
}

static bool run_file(const char *path, const char *name, double most)
{
    Machine m;
    return run(&m, machine_load(&m, path), name, most);
}

static bool run_arm(size_t links, const char *name, double most)
{
    Machine m;
    char *text = arm_text(links);
    bool stands = machine_parse(&m, text);
    free(text);
    return run(&m, stands, name, most);
}

static bool run_ladder(size_t four_bars, const char *name)
{
    Machine m;
    char *text = n_four_bar_text(four_bars);
    if (!machine_parse(&m, text)) exit(1);
    free(text);
    Times times = time_machine(&m, stream_free_bodies);
    machine_end(&m);
    return show(name, &times, 4e-3 * (double)(2 * four_bars + 1)); // 4 us a body
}

int main(void)
{
    printf("%-22s %8s %8s %8s %8s\n", "everything, in text", "ms", "least", "most", "bytes");
    bool keeps = run_file(YOKE_ROOT "/examples/double-pendulum.yaml", "double pendulum", 0.1);
    keeps &= run_file(YOKE_ROOT "/examples/toggle.yaml", "toggle linkage", 0.3);
    keeps &= run_arm(8, "arm of 8 links", 1.5);
    keeps &= run_arm(20, "arm of 20 links", 20);
    keeps &= run_ladder(10, "ladder of 21 bodies");
    keeps &= run_ladder(100, "ladder of 201 bodies");
    keeps &= run_ladder(1000, "ladder of 2001 bodies");
    return keeps ? 0 : 2;
}
