// Nodes of a document.
#include "doc_check.h"

static void a_key_is_found_only_in_a_map_that_has_it(void **state)
{
    (void)state;
    Fixture fixture = fixture_of("a: 1\nb: [2, 3]\nc: {d: 4}\n");
    assert_string_equal(yk_node_get(fixture.root, "a")->text, "1");
    assert_string_equal(yk_node_get(yk_node_get(fixture.root, "c"), "d")->text, "4");
    assert_null(yk_node_get(fixture.root, "d"));
    assert_null(yk_node_get(fixture.root, ""));
    assert_null(yk_node_get(yk_node_get(fixture.root, "b"), "2"));
    assert_null(yk_node_get(yk_node_get(fixture.root, "a"), "1"));
    assert_null(yk_node_get(NULL, "a"));
    fixture_free(&fixture);
}

static void kinds_have_names_for_messages(void **state)
{
    (void)state;
    Fixture fixture = fixture_of("a: 1\nb: [2]\n");
    assert_string_equal(yk_node_kind_name(fixture.root), "a map");
    assert_string_equal(yk_node_kind_name(yk_node_get(fixture.root, "a")), "a value");
    assert_string_equal(yk_node_kind_name(yk_node_get(fixture.root, "b")), "a list");
    assert_string_equal(yk_node_kind_name(NULL), "nothing");
    fixture_free(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_key_is_found_only_in_a_map_that_has_it),
        cmocka_unit_test(kinds_have_names_for_messages),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
