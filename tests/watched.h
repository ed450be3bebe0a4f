// Long calls under watch: stopped at the first, a middle and the last question, they end so, leak nothing, and leave
// what they were asked of as it was. Include it in one file of a test, since it takes the program's allocator.
#ifndef TESTS_WATCHED_H
#define TESTS_WATCHED_H
#include "interposed.h"
#include <pthread.h>
#include <yoke/yoke.h>

typedef struct Watched {
    long asked, refused_at; // refused_at 0: never
    double last;            // part
    bool is_fair;           // parts in [0, 1] that do not decrease, on this thread, and no question after a refusal
    pthread_t thread;
    uint64_t done, before, most; // operations: counted by the test; at the last question; most between two
} Watched;

static bool watch(void *context, double part)
{
    Watched *w = context;
    if (w->refused_at > 0 && w->asked >= w->refused_at) w->is_fair = false;
    if (!(part >= w->last && part <= 1) || !pthread_equal(pthread_self(), w->thread)) w->is_fair = false;
    if (w->asked > 0 && w->done - w->before > w->most) w->most = w->done - w->before;
    w->before = w->done;
    w->last = part;
    return ++w->asked != w->refused_at;
}

static inline Watched watched(long refused_at)
{
    return (Watched){.refused_at = refused_at, .is_fair = true, .thread = pthread_self()};
}
static inline YkProgress progress_of(Watched *w)
{
    return w ? (YkProgress){watch, w} : (YkProgress){0};
}

static inline uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t length)
{
    const unsigned char *at = bytes;
    for (size_t k = 0; k < length; k++) hash = (hash ^ at[k]) * UINT64_C(0x100000001b3);
    return hash;
}
static const uint64_t HASH = UINT64_C(0xcbf29ce484222325);

// Runs a call, watched unless w is NULL. Returns whether it was stopped; *hash: of all that it answered.
typedef bool (*LongCall)(void *self, Watched *w, uint64_t *hash);

// Returns the most operations between two questions, as the call counts them.
static inline uint64_t check_long_call(const char *name, LongCall run, void *self)
{
    uint64_t plain = HASH, seen = HASH, again = HASH;
    Watched w = watched(0);
    assert_false(run(self, NULL, &plain));
    long before = live;
    assert_false(run(self, &w, &seen));
    if (w.asked < 3) print_error("%s: asked %ld times\n", name, w.asked);
    assert_true(w.asked >= 3 && w.is_fair);
    assert_true(plain == seen);
    const long at[] = {1, (w.asked + 1) / 2, w.asked};
    for (size_t k = 0; k < 3; k++) {
        Watched stopped = watched(at[k]);
        uint64_t unused = HASH;
        bool is_stopped = run(self, &stopped, &unused);
        if (!is_stopped) print_error("%s: goes on after question %ld\n", name, at[k]);
        assert_true(is_stopped);
        assert_int_equal(stopped.asked, at[k]);
        assert_true(stopped.is_fair);
        if (IS_INTERPOSED && live != before) print_error("%s: leaks, stopped at question %ld\n", name, at[k]);
        if (IS_INTERPOSED) assert_int_equal(live, before);
    }
    assert_false(run(self, NULL, &again));
    if (again != plain) print_error("%s: other bits after it was stopped\n", name);
    assert_true(again == plain);
    return w.most;
}

static inline bool is_told(const YkProblems *problems)
{
    size_t count = yk_problems_count(problems);
    return count > 0 && yk_problems_get(problems, count - 1)->code == 690 && yk_problems_error_count(problems) == 1;
}

// A ladder of n four-bars, one upon the other's rocker: 2 n + 1 links.
static inline char *ladder_text(size_t n)
{
    size_t room = 1000 + 600 * (n + 1), at = 0;
    char *text = malloc(room);
    assert_non_null(text);
#define LADDER(...) (at += (size_t)snprintf(text + at, room - at, __VA_ARGS__))
    LADDER("parameters: {l: 0.3}\nbodies:\n  ground: {points: {");
    for (size_t k = 0; k <= n; k++) LADDER("%sO%zu: [%zu * l, 0]", k ? ", " : "", k, k);
    LADDER("}}\n");
    for (size_t k = 0; k <= n; k++)
        LADDER("  r%zu: {points: {O%zu: [0, 0], A%zu: [0.1, 0], B%zu: [0.1, 0.0%zu]}, mass: 1 kg, center: [0.05, 0]}\n",
               k, k, k, k, k % 3);
    for (size_t k = 0; k < n; k++)
        LADDER("  c%zu: {points: {A%zu: [0, 0], B%zu: [l, 0]}, mass: 1 kg, center: [0.15, 0]}\n", k, k, k + 1);
    LADDER("joints:\n");
    for (size_t k = 0; k <= n; k++) LADDER("  O%zu: {pin: [ground, r%zu], angle: t%zu}\n", k, k, k);
    for (size_t k = 0; k < n; k++)
        LADDER("  A%zu: {pin: [r%zu, c%zu], angle: u%zu}\n  B%zu: {pin: [c%zu, r%zu]}\n", k, k, k, k, k + 1, k, k + 1);
    LADDER("gravity: [0, -9.81]\ndrives: {t0: 60 deg + 1 rad/s * t}\nstart: {");
    for (size_t k = 0; k < n; k++) LADDER("u%zu: -60 deg, t%zu: 60 deg%s", k, k + 1, k + 1 < n ? ", " : "}\n");
#undef LADDER
    return text;
}

#endif
