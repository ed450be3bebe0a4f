// Repeated keys, in small maps and in large ones.
#include "doc_check.h"

static void a_repeated_key_names_the_first_place(void **state)
{
    (void)state;
    check_refused("a: 1\nb: 2\na: 3\n", YK_CODE_YAML_DUPLICATE_KEY, 3, 1, "line 1, column 1");
    check_refused("x: {a: 1, 'a': 2}\n", YK_CODE_YAML_DUPLICATE_KEY, 1, 11, "line 1, column 5");
    check_refused("{a, a}", YK_CODE_YAML_DUPLICATE_KEY, 1, 5, NULL);
}

static void equal_keys_in_different_maps_are_fine(void **state)
{
    (void)state;
    check_tree("{a: {a: 1}, b: {a: 2}, A: 3}", 0, "{a: {a: 1}, b: {a: 2}, A: 3}");
}

// A map of `count` keys; the one at `again` repeats the one at `first`.
static void check_map(int count, int first, int again)
{
    char text[8192] = "";
    for (int i = 0; i < count; i++) {
        size_t used = strlen(text);
        snprintf(text + used, sizeof text - used, "key%d: 1\n", i == again ? first : i);
    }
    if (again < 0) {
        Fixture fixture = fixture_of(text);
        assert_non_null(fixture.root);
        fixture_free(&fixture);
        return;
    }
    char where[64];
    snprintf(where, sizeof where, "line %d, column 1", first + 1);
    check_refused(text, YK_CODE_YAML_DUPLICATE_KEY, (unsigned)again + 1, 1, where);
}

static void small_and_large_maps_find_the_same(void **state)
{
    (void)state;
    static const int counts[] = {2, 7, 8, 9, 10, 100, 500};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        int n = counts[i];
        check_map(n, 0, -1);
        check_map(n, 0, n - 1);
        check_map(n, n / 2 - 1, n / 2);
    }
}

static void every_repetition_is_reported(void **state)
{
    (void)state;
    for (int filler = 0; filler < 20; filler += 10) { // a small map, a large one
        char text[512] = "a: 1\na: 2\nb: 3\na: 4\nb: 5\n";
        for (int i = 0; i < filler; i++) snprintf(text + strlen(text), sizeof text - strlen(text), "f%d: 1\n", i);
        Fixture fixture = fixture_of(text);
        assert_int_equal(yk_problems_count(fixture.problems), 3);
        fixture_free(&fixture);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_repeated_key_names_the_first_place),
        cmocka_unit_test(equal_keys_in_different_maps_are_fine),
        cmocka_unit_test(small_and_large_maps_find_the_same),
        cmocka_unit_test(every_repetition_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
