// Every allocation fails once: the k-th, for every k. The sources are compiled in with our own allocator.
#include "allocations.h"
#include "check.h"

#define malloc try_malloc
#define calloc try_calloc
#define realloc try_realloc
#define free count_free
#include "../../src/base/memory.c"
#include "../../src/base/names.c"
#include "../../src/base/problems.c"
#include "../../src/base/text.c"
#undef malloc
#undef calloc
#undef realloc
#undef free

// Runs `use` with the k-th allocation failing, for k = 0, 1, ... until none fails; returns how many there were.
static long fail_each(bool (*use)(void))
{
    for (long k = 0;; k++) {
        countdown = k;
        bool well = use();
        bool reached = countdown < 0;
        countdown = -1;
        assert_int_equal(live, 0);
        if (!reached) {
            assert_true(well);
            return k;
        }
        assert_false(well);
    }
}

static bool use_arena(void)
{
    YkArena *arena = yk_arena_new();
    bool well = arena != NULL;
    for (size_t size = 1; size < 100000; size *= 3) {
        char *block = YK_NEW(arena, char, size);
        well = well && block != NULL;
        if (block) block[size - 1] = 1;
    }
    well = well && yk_arena_copy(arena, "crank", 5) != NULL;
    assert_int_equal(yk_arena_failed(arena), !well);
    yk_arena_free(arena);
    return well;
}

static void a_failing_arena_says_so_and_leaks_nothing(void **state)
{
    (void)state;
    assert_true(fail_each(use_arena) >= 4);
}

static bool use_growth(void)
{
    int *items = NULL;
    size_t count = 0, capacity = 0;
    while (count < 1000 && YK_ROOM(items, count, capacity)) {
        items[count] = (int)count;
        count++;
    }
    for (size_t i = 0; i < count; i++) assert_int_equal(items[i], i);
    count_free(items);
    return count == 1000;
}

static void an_array_that_cannot_grow_keeps_its_items(void **state)
{
    (void)state;
    assert_true(fail_each(use_growth) >= 7);
}

static bool use_text(void)
{
    YkText text = {0};
    for (int i = 0; i < 2000; i++) yk_text_puts(&text, "0123456789");
    bool well = !text.failed;
    assert_int_equal(text.length % 10, 0);
    if (!well) assert_ptr_equal(yk_text_get(&text), yk_text_lost);
    if (well) assert_int_equal(strlen(yk_text_get(&text)), 20000);
    yk_text_free(&text);
    return well;
}

static void a_text_that_cannot_grow_is_cut_short_and_says_so(void **state)
{
    (void)state;
    assert_true(fail_each(use_text) >= 5);
}

static bool use_names(void)
{
    static char keys[100][16];
    YkNames names = {0};
    int32_t added = 0;
    bool well = true;
    for (int32_t i = 0; i < 100; i++) {
        snprintf(keys[i], sizeof keys[i], "n%d", (int)i);
        int32_t existing = 5;
        bool is_in = yk_names_add(&names, keys[i], i, &existing);
        assert_int_equal(existing, YK_NONE);
        assert_int_equal(yk_names_find(&names, keys[i]), is_in ? i : YK_NONE);
        added += is_in;
        well = well && is_in;
    }
    assert_int_equal(names.count, added);
    yk_names_free(&names);
    return well;
}

static void a_table_that_cannot_grow_stays_as_it_was(void **state)
{
    (void)state;
    assert_true(fail_each(use_names) >= 8);
}

static bool use_problems(void)
{
    YkProblems *problems = yk_problems_new();
    if (!problems) return false;
    yk_problems_set_source(problems, "m.yaml", "a: 1\n", 5);
    for (uint32_t i = 0; i < 40; i++) {
        yk_problem(problems, YK_CODE_EXPR_UNIT, (YkPlace){1, 1, 1}, "a message of some length, number %u", i);
        yk_problem_hint(problems, "a hint");
    }
    size_t count = yk_problems_count(problems); // none is lost, whatever happens to its words
    assert_true(count == 40 || (count == 41 && yk_problems_ran_out(problems)));
    assert_int_equal(yk_problems_error_count(problems), count);
    char expected[8000] = "", *end = expected;
    for (unsigned i = 0; i < 40; i++)
        end += sprintf(
            end, "m.yaml:1:1: error: a message of some length, number %u [E0303]\n    a: 1\n    ^\nhint: a hint\n", i);
    const char *text = yk_problems_text(problems, 0);
    assert_true(strlen(text) > 0);
    bool well = strcmp(text, expected) == 0;
    assert_int_equal(yk_problems_ran_out(problems), !well);
    yk_problems_free(problems);
    return well;
}

static void problems_are_still_counted_and_printed(void **state)
{
    (void)state;
    assert_true(fail_each(use_problems) >= 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_failing_arena_says_so_and_leaks_nothing),
        cmocka_unit_test(an_array_that_cannot_grow_keeps_its_items),
        cmocka_unit_test(a_text_that_cannot_grow_is_cut_short_and_says_so),
        cmocka_unit_test(a_table_that_cannot_grow_stays_as_it_was),
        cmocka_unit_test(problems_are_still_counted_and_printed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
