// Tiles of a map: whoever computes them, in whatever order, and one map for all.
#include <yoke/regions.h>
#include "configurations/truss.h"

static const char five_bar[] =
    "bodies:\n  ground: {points: {L: [-0.06, 0], R: [0.06, 0]}}\n  left: {points: {L: [0, 0], A: [0.2, 0]}}\n"
    "  right: {points: {R: [0, 0], B: [0.17, 0]}}\n  reachL: {points: {A: [0, 0], P: [0.26, 0]}}\n"
    "  reachR: {points: {B: [0, 0], P: [0.3, 0]}}\njoints:\n  L: {pin: [ground, left], angle: u}\n"
    "  R: {pin: [ground, right], angle: v}\n  A: {pin: [left, reachL]}\n  B: {pin: [right, reachR]}\n"
    "  P: {pin: [reachL, reachR]}\ndrives: {u: 2, v: 1}\n";
static const char platform[] = // a group, on two cranks
    "bodies:\n  ground: {points: {A: [0, 0], B: [2, 0], C: [1, 1.7]}}\n  crank1: {points: {A: [0, 0], G: [0.3, 0]}}\n"
    "  crank2: {points: {B: [0, 0], H: [0.35, 0]}}\n  leg1: {points: {G: [0, 0], D: [0.8, 0]}}\n"
    "  leg2: {points: {H: [0, 0], E: [0.75, 0]}}\n  leg3: {points: {C: [0, 0], F: [0.9, 0]}}\n"
    "  plate: {points: {D: [0, 0], E: [0.6, 0], F: [0.35, 0.5]}}\njoints:\n  A: {pin: [ground, crank1], angle: u}\n"
    "  B: {pin: [ground, crank2], angle: v}\n  C: {pin: [ground, leg3]}\n  G: {pin: [crank1, leg1]}\n"
    "  H: {pin: [crank2, leg2]}\n  D: {pin: [leg1, plate]}\n  E: {pin: [leg2, plate]}\n  F: {pin: [leg3, plate]}\n"
    "drives: {u: 1, v: 2}\n";

static Machine stand(const char *text)
{
    Machine m = machine_parse_with(text, NULL, 0);
    assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
    return m;
}

static YkRegions *map_of(Machine *m, double tolerance, YkTileSource tiles)
{
    const YkRegionsOptions options = {tolerance, tiles};
    return yk_regions_new(m->state, yk_input_coordinate(m->mech, 0), yk_input_coordinate(m->mech, 1), &options,
                          m->problems);
}

static YkTiles *tiles_of(Machine *m)
{
    YkTiles *t = yk_tiles_new(m->state, yk_input_coordinate(m->mech, 0), yk_input_coordinate(m->mech, 1), m->problems);
    assert_non_null(t);
    return t;
}

static void check_same(const YkRegions *a, const YkRegions *b)
{
    assert_string_equal(yk_regions_message(a), yk_regions_message(b));
    assert_int_equal(yk_regions_are_complete(a), yk_regions_are_complete(b));
    assert_int_equal(yk_regions_count(a), yk_regions_count(b));
    assert_true(yk_regions_proved(a) == yk_regions_proved(b));
    for (size_t k = 0; k < yk_regions_count(a); k++) {
        YkRegion p = yk_regions_region(a, k), q = yk_regions_region(b, k);
        assert_true(p.area == q.area && p.configurations == q.configurations && p.outlines == q.outlines);
        for (size_t o = 0; o < p.outlines; o++) {
            size_t n, m;
            const double *u = yk_regions_outline(a, k, o, &n), *v = yk_regions_outline(b, k, o, &m);
            assert_int_equal(n, m);
            assert_memory_equal(u, v, 2 * n * sizeof *u);
        }
    }
}

// Computes tiles by two that have machines of their own, now and then another tile before the one wanted: neither sees
// them in their order.
typedef struct Crew {
    YkTiles *worker[2];
    uint64_t seed;
    size_t taken;
} Crew;

static YkStatus get_from_crew(void *context, const YkTilePlane *plane, size_t tile, size_t count,
                              const uint32_t **words, size_t *word_count)
{
    Crew *crew = context;
    YkTiles *worker = crew->worker[tile % 2];
    size_t other = (size_t)(check_uniform(&crew->seed, 0, 1) * (double)count);
    if (tile % 16 == 1) yk_tiles_compute(worker, plane, other < count ? other : 0, words, word_count);
    crew->taken++;
    return yk_tiles_compute(worker, plane, tile, words, word_count);
}

static void check_crew(const char *text, double tolerance)
{
    Machine m = stand(text), own[2] = {stand(text), stand(text)};
    Crew crew = {.worker = {tiles_of(&own[0]), tiles_of(&own[1])}, .seed = 5};
    YkRegions *alone = map_of(&m, tolerance, (YkTileSource){NULL, NULL});
    YkRegions *shared = map_of(&m, tolerance, (YkTileSource){get_from_crew, &crew});
    assert_non_null(alone);
    assert_non_null(shared);
    assert_true(yk_regions_count(alone) > 0 && crew.taken > 20);
    check_same(alone, shared);
    yk_regions_free(alone);
    yk_regions_free(shared);
    for (int k = 0; k < 2; k++) {
        yk_tiles_free(crew.worker[k]);
        machine_free(&own[k]);
    }
    machine_free(&m);
}

static void test_the_map_does_not_depend_on_who_computes_it(void **unused)
{
    (void)unused;
    check_without_sanitizers();
    check_crew(five_bar, 4e-3);
    check_crew(platform, 0.1);
}

// --- what goes wrong

typedef struct Faulty {
    YkTiles *worker;
    uint32_t words[100000];
    size_t tile, word; // where
    uint32_t flip;
    long longer; // words that are added
    YkStatus status;
} Faulty;

static YkStatus get_faulty(void *context, const YkTilePlane *plane, size_t tile, size_t count, const uint32_t **words,
                           size_t *word_count)
{
    Faulty *f = context;
    (void)count;
    if (tile == f->tile && f->status < 0) return f->status;
    YkStatus status = yk_tiles_compute(f->worker, plane, tile, words, word_count);
    if (status < 0 || tile != f->tile) return status;
    assert_true(*word_count + 1 < sizeof f->words / sizeof *f->words);
    memcpy(f->words, *words, *word_count * sizeof *f->words);
    f->words[f->word] ^= f->flip;
    *word_count = (size_t)((long)*word_count + f->longer);
    *words = f->words;
    return YK_OK;
}

static void test_words_that_no_tile_has_are_refused(void **unused)
{
    (void)unused;
    static Faulty f; // large
    Machine m = stand(five_bar), own = stand(five_bar);
    f.worker = tiles_of(&own);
    f.tile = 3;
    const struct {
        size_t word;
        uint32_t flip;
        long longer;
    } faults[] = {{0, 1, 0},        {1, 1, 0},           {4, 2, 0},        {0, 0x80000000u, 0}, {1, 0x80000000u, 0},
                  {7, 5u << 24, 0}, {7, 0xf0u << 24, 0}, {7, 1u << 23, 0}, {0, 0, 1},           {0, 0, -1}};
    for (size_t k = 0; k < sizeof faults / sizeof *faults; k++) {
        f.word = faults[k].word;
        f.flip = faults[k].flip;
        f.longer = faults[k].longer;
        size_t errors = yk_problems_error_count(m.problems);
        assert_null(map_of(&m, 0.02, (YkTileSource){get_faulty, &f}));
        assert_int_equal(yk_problems_error_count(m.problems), errors + 1);
    }
    f.flip = 0;
    f.longer = 0;
    const YkStatus ends[] = {YK_STOPPED, YK_NO_MEMORY, YK_BAD_ARGUMENT};
    for (size_t k = 0; k < 3; k++) {
        f.status = ends[k];
        size_t errors = yk_problems_error_count(m.problems);
        assert_null(map_of(&m, 0.02, (YkTileSource){get_faulty, &f}));
        assert_int_equal(yk_problems_error_count(m.problems), errors + 1);
    }
    f.status = YK_OK;
    YkRegions *r = map_of(&m, 0.02, (YkTileSource){get_faulty, &f});
    assert_non_null(r);
    yk_regions_free(r);
    yk_tiles_free(f.worker);
    machine_free(&own);
    machine_free(&m);
}

static void test_tiles_that_do_not_exist_are_refused(void **unused)
{
    (void)unused;
    Machine m = stand(five_bar);
    YkTiles *t = tiles_of(&m);
    const uint32_t *words;
    size_t count;
    YkTilePlane good = {{-3, -3}, {3, 3}, 64, true}, odd = good, empty = good, endless = good, large = good;
    odd.squares = 65;
    empty.high[1] = -3;
    endless.high[0] = INFINITY;
    large.squares = 1 << 20;
    const YkTilePlane *bad[] = {&odd, &empty, &endless, &large};
    for (size_t k = 0; k < 4; k++) assert_int_equal(yk_tiles_compute(t, bad[k], 0, &words, &count), YK_BAD_ARGUMENT);
    assert_int_equal(yk_tiles_compute(t, &good, 100000, &words, &count), YK_BAD_ARGUMENT);
    assert_int_equal(yk_tiles_compute(NULL, &good, 0, &words, &count), YK_BAD_ARGUMENT);
    assert_int_equal(yk_tiles_compute(t, &good, 0, &words, &count), YK_OK);
    assert_true(count > 5);
    yk_tiles_free(t);
    yk_tiles_free(NULL);
    assert_null(yk_tiles_new(NULL, 0, 1, m.problems));
    assert_null(yk_tiles_new(m.state, 0, 0, m.problems));
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_map_does_not_depend_on_who_computes_it),
        cmocka_unit_test(test_words_that_no_tile_has_are_refused),
        cmocka_unit_test(test_tiles_that_do_not_exist_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
