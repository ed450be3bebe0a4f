// Tables of names.
#include "check.h"
#include "base/names.h"

static void an_empty_table_finds_nothing(void **state)
{
    (void)state;
    YkNames names = {0};
    assert_int_equal(yk_names_find(&names, "crank"), YK_NONE);
    yk_names_free(&names);
    yk_names_free(&names);
}

static void every_name_is_found_among_many(void **state)
{
    (void)state;
    enum { COUNT = 20000 };
    static char keys[COUNT][20], others[COUNT][20];
    YkNames names = {0};
    for (int i = 0; i < COUNT; i++) {
        int32_t existing = 77;
        snprintf(keys[i], sizeof keys[i], "link%d", i);
        snprintf(others[i], sizeof others[i], "Link%d", i);
        assert_true(yk_names_add(&names, keys[i], i, &existing));
        assert_int_equal(existing, YK_NONE);
    }
    assert_int_equal(names.count, COUNT);
    for (int i = 0; i < COUNT; i++) {
        char copy[20]; // by content, not by address
        memcpy(copy, keys[i], sizeof copy);
        assert_int_equal(yk_names_find(&names, copy), i);
        assert_int_equal(yk_names_find(&names, others[i]), YK_NONE);
    }
    yk_names_free(&names);
    assert_int_equal(names.count, 0);
}

static void a_name_added_twice_keeps_its_first_value(void **state)
{
    (void)state;
    YkNames names = {0};
    int32_t existing;
    assert_true(yk_names_add(&names, "A", 3, NULL));
    assert_true(yk_names_add(&names, "A", 4, &existing));
    assert_int_equal(existing, 3);
    assert_true(yk_names_add(&names, "A", 5, NULL));
    assert_int_equal(yk_names_find(&names, "A"), 3);
    assert_int_equal(names.count, 1);
    yk_names_free(&names);
}

static void the_empty_name_is_a_name(void **state)
{
    (void)state;
    YkNames names = {0};
    assert_true(yk_names_add(&names, "", 0, NULL));
    assert_int_equal(yk_names_find(&names, ""), 0);
    assert_int_equal(yk_names_find(&names, " "), YK_NONE);
    yk_names_free(&names);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_empty_table_finds_nothing),
        cmocka_unit_test(every_name_is_found_among_many),
        cmocka_unit_test(a_name_added_twice_keeps_its_first_value),
        cmocka_unit_test(the_empty_name_is_a_name),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
