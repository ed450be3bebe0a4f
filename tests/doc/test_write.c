// A tree that is written as text reads back as the same tree; words stand without quotes, and no line is longer than
// necessary.
#include "doc_check.h"

static YkArena *arena;
static uint64_t seed;

static YkNode *node_of(YkNodeKind kind, size_t count)
{
    YkNode *node = YK_NEW(arena, YkNode, 1);
    assert_non_null(node);
    *node = (YkNode){.kind = kind, .count = count, .text = "", .items = YK_NEW(arena, YkNode *, count + 1)};
    node->pairs = YK_NEW(arena, YkNodePair, count + 1);
    return node;
}

static YkNode *scalar_of(const char *text, bool quoted)
{
    YkNode *node = node_of(YK_NODE_SCALAR, 0);
    node->text = yk_arena_copy(arena, text, strlen(text));
    node->length = strlen(text);
    node->quoted = quoted;
    return node;
}

static size_t some(size_t count)
{
    return (size_t)check_uniform(&seed, 0, (double)count) % count;
}

// Of letters, digits and all that YAML has a use for.
static YkNode *random_scalar(void)
{
    static const char letters[] = "ab1 -?:,[]{}#&*!|>'\"%@`~.=\\/";
    static const char *const words[] = {"~",    "null", "...", "---", "-",  "- a", "a: b",
                                        "a #b", "",     " a",  "a ",  "-1", "x'y"};
    char text[8] = "";
    if (some(3) == 0) return scalar_of(words[some(sizeof words / sizeof *words)], true);
    for (size_t k = 0, count = some(7); k < count; k++) text[k] = letters[some(sizeof letters - 1)];
    return scalar_of(text, true);
}

static YkNode *random_tree(int depth)
{
    size_t kind = depth == 0 ? 0 : some(4), count = some(4);
    if (kind < 2) return random_scalar();
    YkNode *node = node_of(kind == 2 ? YK_NODE_LIST : YK_NODE_MAP, count);
    for (size_t k = 0; k < count; k++) {
        char key[40];
        snprintf(key, sizeof key, "%zu%s", k, random_scalar()->text); // unlike the others
        node->pairs[k].key = scalar_of(key, true);
        node->items[k] = node->pairs[k].value = random_tree(depth - 1);
    }
    return node;
}

static bool is_same(const YkNode *a, const YkNode *b)
{
    bool same = a->kind == b->kind && a->count == b->count;
    if (same && a->kind == YK_NODE_SCALAR) same = strcmp(a->text, b->text) == 0;
    for (size_t k = 0; same && k < a->count; k++)
        same = a->kind == YK_NODE_LIST
                   ? is_same(a->items[k], b->items[k])
                   : is_same(a->pairs[k].key, b->pairs[k].key) && is_same(a->pairs[k].value, b->pairs[k].value);
    return same;
}

static void random_trees_read_back_the_same(void **state)
{
    (void)state;
    for (size_t k = 0; k < check_cases(2000); k++) {
        YkText text = {0};
        seed = k + 1;
        arena = yk_arena_new();
        const YkNode *tree = random_tree(4);
        yk_doc_write(tree, &text);
        Fixture fixture = fixture_of(yk_text_get(&text));
        if (!fixture.root || !is_same(tree, fixture.root))
            print_error("seed %zu\n%s\n%s\n", k + 1, yk_text_get(&text), yk_problems_text(fixture.problems, 0));
        assert_non_null(fixture.root);
        assert_true(is_same(tree, fixture.root));
        fixture_free(&fixture);
        yk_text_free(&text);
        yk_arena_free(arena);
    }
}

static void nothing_stays_nothing(void **state)
{
    (void)state;
    Fixture fixture = fixture_of("{a: , b: ~, c: null, d: '~', e: 'null'}");
    YkText text = {0};
    yk_doc_write(fixture.root, &text);
    assert_string_equal(yk_text_get(&text), "a: ~\nb: ~\nc: ~\nd: '~'\ne: 'null'\n");
    yk_text_free(&text);
    fixture_free(&fixture);
}

static void words_and_formulas_have_no_quotes(void **state)
{
    (void)state;
    static const char text[] =
        "a: 2*pi - theta/3\nb-c: [x.rate, (1 + 2) mm, -3, crank.A]\nd:\n  e: {f: 0.5 N*m, g: -a}\n";
    Fixture fixture = fixture_of(text);
    YkText again = {0};
    yk_doc_write(fixture.root, &again);
    assert_string_equal(yk_text_get(&again), text);
    yk_text_free(&again);
    fixture_free(&fixture);
}

// What stands in a line with its value grows by a letter a time: the value is one line until it would be more than a
// line, and the further in it stands, the sooner.
static size_t longest_in_one_line(const char *before, const char *behind)
{
    size_t longest = 0;
    for (size_t length = 1; length < 130; length++) {
        char source[300], word[140] = "";
        memset(word, 'x', length);
        snprintf(source, sizeof source, "%s[%s, y]%s\n", before, word, behind);
        Fixture fixture = fixture_of(source);
        YkText text = {0};
        yk_doc_write(fixture.root, &text);
        const char *value = strstr(yk_text_get(&text), "[x");
        if (value) {
            assert_int_equal(longest, length - 1);
            longest = length;
        }
        yk_text_free(&text);
        fixture_free(&fixture);
    }
    return longest;
}

static void a_value_is_one_line_until_it_is_too_long(void **state)
{
    (void)state;
    size_t list = longest_in_one_line("a: ", ""), inside = longest_in_one_line("a: {b: ", "}");
    assert_true(list > 80 && list < 120);
    assert_int_equal(inside + 2, list);
    assert_int_equal(longest_in_one_line("a: {b: {c: ",
                                         ", d: [xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx"
                                         "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx]}}"),
                     list - 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_trees_read_back_the_same),
        cmocka_unit_test(nothing_stays_nothing),
        cmocka_unit_test(words_and_formulas_have_no_quotes),
        cmocka_unit_test(a_value_is_one_line_until_it_is_too_long),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
