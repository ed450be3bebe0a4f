// YAML text into a tree with places; what model files do not need is refused.
#include "doc_check.h"

static void maps_lists_and_scalars_become_a_tree(void **state)
{
    (void)state;
    check_tree("a: 1\nb: [x, y]\nc: {d: 2 mm, e: {}}\n", 0, "{a: 1, b: [x, y], c: {d: 2 mm, e: {}}}");
    check_tree("a:\n  b:\n    - 1\n    - c: 2\n      d: 3\n", 0, "{a: {b: [1, {c: 2, d: 3}]}}");
    check_tree("[a, [], {b: c}]", 0, "[a, [], {b: c}]");
    check_tree("just text\n", 0, "just text");
    check_tree("# comment\n---\na: 1 # more\n...\n", 0, "{a: 1}");
    check_tree("a:\nb: ''\nc: \"\"\n", 0, "{a: , b: \"\", c: \"\"}");
    check_tree("theta1.rate: 3 rad/s\ndrives: {theta1: 30 deg - 0.5 rad/s * t}\n", 0,
               "{theta1.rate: 3 rad/s, drives: {theta1: 30 deg - 0.5 rad/s * t}}");
    check_tree("{}", 0, "{}");
    check_tree("[]", 0, "[]");
    check_tree("{A, B}", 0, "{A: , B: }");
    check_tree("[a: 1]", 0, "[{a: 1}]");
}

static void every_node_knows_its_place_and_length(void **state)
{
    (void)state;
    check_tree("ab: 1 mm\n", 1, "{ab@1:1+2: 1 mm@1:5+4}@1:1+0");
    check_tree("a:\n  - x\n  - \"y z\"\n", 1, "{a@1:1+1: [x@2:5+1, \"y z\"@3:5+5]@2:3+0}@1:1+0");
    check_tree("{p: [1, 22], q: 'r'}  # c\n", 1, "{p@1:2+1: [1@1:6+1, 22@1:9+2]@1:5+7, q@1:14+1: \"r\"@1:17+3}@1:1+20");
}

static void columns_count_code_points(void **state)
{
    (void)state;
    check_tree("\xc3\xa9t\xc3\xa9: [\xe2\x82\xac, b]\n", 1,
               "{\xc3\xa9t\xc3\xa9@1:1+3: [\xe2\x82\xac@1:7+1, b@1:10+1]@1:6+6}@1:1+0");
    check_tree("{\xf0\x9d\x9b\x89: 1}", 1, "{\xf0\x9d\x9b\x89@1:2+1: 1@1:5+1}@1:1+6");
}

static void a_byte_order_mark_is_no_column(void **state)
{
    (void)state;
    check_tree("\xef\xbb\xbf"
               "a: 1\n",
               1, "{a@1:1+1: 1@1:4+1}@1:1+0");
}

static void windows_line_ends_are_read_alike(void **state)
{
    (void)state;
    check_tree("a: 1\r\nb:\r\n  - x\r\n", 1, "{a@1:1+1: 1@1:4+1, b@2:1+1: [x@3:5+1]@3:3+0}@1:1+0");
}

static void text_over_several_lines_is_underlined_to_the_end_of_the_first(void **state)
{
    (void)state;
    check_tree("a: one\n  two\nb: \"three\n  four\" \nc: 1\n", 1,
               "{a@1:1+1: one two@1:4+3, b@3:1+1: \"three four\"@3:4+6, c@5:1+1: 1@5:4+1}@1:1+0");
}

static void what_model_files_have_no_use_for_is_refused(void **state)
{
    (void)state;
    check_refused("a: &x 1\nb: 2\n", YK_CODE_YAML_ANCHOR, 1, 4, "parameter");
    check_refused("a: &x [1]\n", YK_CODE_YAML_ANCHOR, 1, 4, "parameter");
    check_refused("a: &x {b: 1}\n", YK_CODE_YAML_ANCHOR, 1, 4, "parameter");
    check_refused("a: 1\nb: *x\n", YK_CODE_YAML_ALIAS, 2, 4, "alias");
    check_refused("a: 2\nb: *a*2\n", YK_CODE_YAML_ALIAS, 2, 4, NULL);
    check_refused("a: !!str 1\n", YK_CODE_YAML_TAG, 1, 4, "tag");
    check_refused("a: !mm [1]\n", YK_CODE_YAML_TAG, 1, 4, "tag");
    check_refused("a: !mm {b: 1}\n", YK_CODE_YAML_TAG, 1, 4, "tag");
    check_refused("%TAG ! tag:x,2000:\n---\na: 1\n", YK_CODE_YAML_TAG, 1, 1, "tag");
    check_refused("a: {<<: 1}\n", YK_CODE_YAML_MERGE, 1, 5, "merge");
    check_refused("a: 1\n---\nb: 2\n", YK_CODE_YAML_DOCUMENTS, 2, 1, "---");
    check_refused("[a]: 1\n", YK_CODE_YAML_KEY_NOT_SCALAR, 1, 1, "quotes");
    check_refused("a: {{b: 1}: 2}\n", YK_CODE_YAML_KEY_NOT_SCALAR, 1, 5, NULL);
    check_refused("a: {? : 1}\n", YK_CODE_YAML_KEY_EMPTY, 1, 7, "key is missing");
    check_refused("a: {'': 1}\n", YK_CODE_YAML_KEY_EMPTY, 1, 5, "key is missing");
    check_refused("a: |\n  x\n", YK_CODE_YAML_CONTROL, 1, 4, "line break");
    check_refused("a: x\ty\n", YK_CODE_YAML_CONTROL, 1, 4, "tab");
    check_refused("a: \"x\\u0007\"\n", YK_CODE_YAML_CONTROL, 1, 4, "control");
    check_refused("a: \"x\\0\"\n", YK_CODE_YAML_CONTROL, 1, 4, "control");
    check_refused("a: \"\\u202e\"\n", YK_CODE_YAML_CONTROL, 1, 4, "control");
}

static void a_quoted_merge_key_is_a_name_like_any_other(void **state)
{
    (void)state;
    check_tree("{'<<': 1}", 0, "{\"<<\": 1}");
}

static void an_empty_file_says_so(void **state)
{
    (void)state;
    static const char *const empties[] = {"", "\n\n", "# nothing\n", "---\n", "---\n...\n", "\xef\xbb\xbf"};
    for (size_t i = 0; i < sizeof empties / sizeof *empties; i++)
        check_refused(empties[i], YK_CODE_YAML_EMPTY, 1, 1, "bodies");
}

static void several_mistakes_are_reported_in_one_run(void **state)
{
    (void)state;
    Fixture fixture = fixture_of("a: &x 1\nb: *x\n<<: 2\nc: !t 3\na: 4\n");
    static const int codes[] = {YK_CODE_YAML_ANCHOR, YK_CODE_YAML_ALIAS, YK_CODE_YAML_MERGE, YK_CODE_YAML_TAG,
                                YK_CODE_YAML_DUPLICATE_KEY};
    assert_null(fixture.root);
    assert_int_equal(yk_problems_count(fixture.problems), 5);
    for (size_t i = 0; i < 5; i++) assert_int_equal(yk_problems_get(fixture.problems, i)->code, codes[i]);
    fixture_free(&fixture);
}

// n opening brackets and as many closing ones.
static char *nest(size_t n)
{
    char *text = malloc(2 * n + 1);
    assert_non_null(text);
    memset(text, '[', n);
    memset(text + n, ']', n);
    text[2 * n] = '\0';
    return text;
}

static void depth_is_limited_exactly(void **state)
{
    (void)state;
    char *deepest = nest(YK_DOC_DEPTH_MAX), *deeper = nest(YK_DOC_DEPTH_MAX + 1), *far = nest(100000);
    Fixture fixture = fixture_of(deepest);
    assert_non_null(fixture.root);
    fixture_free(&fixture);
    check_refused(deeper, YK_CODE_YAML_DEPTH, 1, YK_DOC_DEPTH_MAX + 1, NULL);
    Fixture refused = fixture_of(far);
    assert_null(refused.root);
    fixture_free(&refused);
    free(deepest);
    free(deeper);
    free(far);
}

static void a_long_text_and_a_big_map_keep_their_contents(void **state)
{
    (void)state;
    enum { LONG = 100000, KEYS = 5000 };
    size_t size = LONG + KEYS * 24, used;
    char *text = malloc(size);
    assert_non_null(text);
    used = (size_t)snprintf(text, size, "long: ");
    memset(text + used, 'x', LONG);
    used += LONG;
    for (int i = 0; i < KEYS; i++) used += (size_t)snprintf(text + used, size - used, "\nkey%d: %d", i, i * i);
    Fixture fixture = fixture_of_bytes(text, used);
    assert_non_null(fixture.root);
    assert_int_equal(fixture.root->count, KEYS + 1);
    assert_int_equal(fixture.root->pairs[0].value->length, LONG);
    for (int i = 0; i < KEYS; i++) {
        char value[16];
        snprintf(value, sizeof value, "%d", i * i);
        assert_string_equal(fixture.root->pairs[i + 1].value->text, value);
        assert_int_equal(fixture.root->pairs[i + 1].key->place.line, i + 2);
    }
    fixture_free(&fixture);
    free(text);
}

// Random trees, written in flow style, read back the same.
static void write_random(uint64_t *seed, int depth, char *out, size_t size)
{
    size_t used = strlen(out), children = check_random(seed) % 4;
    uint64_t kind = depth == 0 ? 0 : check_random(seed) % 3;
    if (kind == 0) {
        snprintf(out + used, size - used, "v%d", (int)(check_random(seed) % 1000));
        return;
    }
    strncat(out, kind == 1 ? "[" : "{", size - strlen(out) - 1);
    for (size_t i = 0; i < children; i++) {
        used = strlen(out);
        if (kind == 2) snprintf(out + used, size - used, "%sk%zu: ", i ? ", " : "", i);
        if (kind == 1 && i) strncat(out, ", ", size - strlen(out) - 1);
        write_random(seed, depth - 1, out, size);
    }
    strncat(out, kind == 1 ? "]" : "}", size - strlen(out) - 1);
}

static void random_trees_read_back_as_written(void **state)
{
    (void)state;
    uint64_t seed = 42;
    for (int i = 0; i < 300; i++) {
        char text[2048] = "";
        write_random(&seed, 4, text, sizeof text);
        check_tree(text, 0, text);
    }
}

static void a_text_over_the_limit_is_refused_before_it_is_looked_at(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    YkArena *arena = yk_arena_new();
    char *text = calloc(YK_DOC_SIZE_MAX + 1, 1); // untouched pages: no memory
    if (text) {
        assert_null(yk_doc_parse(text, YK_DOC_SIZE_MAX + 1, "x", arena, problems));
        assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_FILE_TOO_LARGE);
    }
    free(text);
    yk_arena_free(arena);
    yk_problems_free(problems);
}

static void read_lines(size_t lines)
{
    enum { LINE = 64 };
    char *text = malloc(lines * LINE + 16);
    assert_non_null(text);
    size_t used = (size_t)sprintf(text, "bodies:\n");
    for (size_t i = 0; i < lines; i++)
        used += (size_t)snprintf(text + used, LINE, "  b%zu: {points: {A: [0, 0], B: [1, 0]}}\n", i);
    Fixture fixture = fixture_of_bytes(text, used);
    assert_non_null(fixture.root);
    fixture_free(&fixture);
    free(text);
}

// At a quadratic cost it would not end before the test's time limit.
static void a_long_text_is_read(void **state)
{
    (void)state;
    check_without_sanitizers();
    read_lines(300000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(maps_lists_and_scalars_become_a_tree),
        cmocka_unit_test(every_node_knows_its_place_and_length),
        cmocka_unit_test(columns_count_code_points),
        cmocka_unit_test(a_byte_order_mark_is_no_column),
        cmocka_unit_test(windows_line_ends_are_read_alike),
        cmocka_unit_test(text_over_several_lines_is_underlined_to_the_end_of_the_first),
        cmocka_unit_test(what_model_files_have_no_use_for_is_refused),
        cmocka_unit_test(a_quoted_merge_key_is_a_name_like_any_other),
        cmocka_unit_test(an_empty_file_says_so),
        cmocka_unit_test(several_mistakes_are_reported_in_one_run),
        cmocka_unit_test(depth_is_limited_exactly),
        cmocka_unit_test(a_long_text_and_a_big_map_keep_their_contents),
        cmocka_unit_test(random_trees_read_back_as_written),
        cmocka_unit_test(a_text_over_the_limit_is_refused_before_it_is_looked_at),
        cmocka_unit_test(a_long_text_is_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
