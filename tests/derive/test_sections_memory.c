// Gears, cams, polygons and centres in symbols survive the failure of any one allocation: false comes back, or the
// whole section; nothing leaks, nothing crashes.
#include "interposed.h"
#include "derive_check.h"

static uint64_t mix(uint64_t mark, uint64_t number)
{
    return (mark ^ number) * 0x9e3779b97f4a7c15U + (mark >> 29);
}

// A number for what stands on the page: the kinds of its lines and pieces, their words, and how long elements are.
static uint64_t mark_of(const YkPage *page)
{
    uint64_t mark = 1;
    for (const YkLine *line = page->first; line; line = line->next) {
        mark = mix(mark, line->kind);
        for (const char *c = line->text; c && *c; c++) mark = mix(mark, (unsigned char)*c);
        for (const YkPagePiece *piece = line->first; piece; piece = piece->next) {
            mark = mix(mark, piece->kind);
            for (const char *c = piece->text; c && *c; c++) mark = mix(mark, (unsigned char)*c);
            mark = mix(mark, yk_ring_terms(piece->over) + 1000 * yk_ring_terms(piece->under));
        }
    }
    return mark;
}

static bool derive_one(const YkModel *model, const YkMechanism *mech, size_t section, uint64_t *mark)
{
    YkDerivation *d = yk_derivation_new(model, mech, NULL);
    YkPage page = {.arena = yk_arena_new(), .ring = d ? d->ring : NULL, .has_numbers = true};
    bool well = d && page.arena && yk_derive_write(d, section, &page);
    if (well) *mark = mark_of(&page);
    yk_arena_free(page.arena);
    yk_derivation_free(d);
    return well;
}

// What comes in spite of a failure is the whole section: nothing is left out for lack of memory.
static void check_example(const char *name, const char *section)
{
    Machine m = example(name);
    size_t which = section_of(section);
    long before = live, failures = 0;
    uint64_t whole = 0, mark = 0;
    assert_true(derive_one(m.model, m.mech, which, &whole));
    assert_int_equal(live, before);
    for (long k = 0;; k++) {
        countdown = k;
        bool well = derive_one(m.model, m.mech, which, &mark), is_past = countdown >= 0;
        countdown = -1;
        assert_int_equal(live, before);
        if (well && mark != whole) fail_msg("%s, %s: allocation %ld failed unnoticed", name, section, k);
        if (is_past) {
            assert_true(well);
            break;
        }
        failures += !well;
    }
    assert_true(failures > 20);
    machine_end(&m);
}

static void any_one_failure_is_survived(void **state)
{
    (void)state;
    skip_unless_interposed();
    check_example("epicyclic", "gears");
    check_example("simple-planetary", "gears");
    check_example("cep-cam", "cam");
    check_example("quick-return", "polygons");
    check_example("quick-return", "centers");
    check_example("swing-cam", "cam");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(any_one_failure_is_survived)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
