// Shared by the tests of documents: a fixture that parses a text, and a tree written as text.
#ifndef TESTS_DOC_CHECK_H
#define TESTS_DOC_CHECK_H
#include "check.h"
#include <stdlib.h>
#include "base/codes.h"
#include "doc/node.h"

typedef struct Fixture {
    YkArena *arena;
    YkProblems *problems;
    YkNode *root;
} Fixture;

static inline Fixture fixture_of_bytes(const char *text, size_t length)
{
    Fixture fixture = {yk_arena_new(), yk_problems_new(), NULL};
    char *exact = malloc(length > 0 ? length : 1); // so that a sanitizer sees a read beyond the end
    assert_non_null(exact);
    memcpy(exact, text, length);
    fixture.root = yk_doc_parse(exact, length, "test.yaml", fixture.arena, fixture.problems);
    free(exact);
    return fixture;
}

static inline Fixture fixture_of(const char *text)
{
    return fixture_of_bytes(text, strlen(text));
}

static inline void fixture_free(Fixture *fixture)
{
    yk_arena_free(fixture->arena);
    yk_problems_free(fixture->problems);
}

// "{key: value, ...}", "[a, b]", quoted scalars in quotes; with places each node as text@line:column+length.
static inline void tree_write(const YkNode *node, int with_places, char *out, size_t size)
{
    size_t used = strlen(out);
    const char *ends = node->kind == YK_NODE_LIST ? "[]" : "{}";
    if (node->kind == YK_NODE_SCALAR)
        snprintf(out + used, size - used, node->quoted ? "\"%s\"" : "%s", node->text);
    else
        snprintf(out + used, size - used, "%c", ends[0]);
    for (size_t i = 0; node->kind != YK_NODE_SCALAR && i < node->count; i++) {
        if (i > 0) strncat(out, ", ", size - strlen(out) - 1);
        if (node->kind == YK_NODE_MAP) tree_write(node->pairs[i].key, with_places, out, size);
        if (node->kind == YK_NODE_MAP) strncat(out, ": ", size - strlen(out) - 1);
        tree_write(node->kind == YK_NODE_MAP ? node->pairs[i].value : node->items[i], with_places, out, size);
    }
    used = strlen(out);
    if (node->kind != YK_NODE_SCALAR) snprintf(out + used, size - used, "%c", ends[1]);
    used = strlen(out);
    if (with_places)
        snprintf(out + used, size - used, "@%u:%u+%u", (unsigned)node->place.line, (unsigned)node->place.column,
                 (unsigned)node->place.length);
}

static inline void check_tree(const char *text, int with_places, const char *expected)
{
    Fixture fixture = fixture_of(text);
    char tree[2048] = "";
    if (!fixture.root) print_error("%s", yk_problems_text(fixture.problems, 0));
    assert_non_null(fixture.root);
    tree_write(fixture.root, with_places, tree, sizeof tree);
    assert_string_equal(tree, expected);
    assert_int_equal(yk_problems_count(fixture.problems), 0);
    fixture_free(&fixture);
}

// Fails unless the text is refused with this code first, at this place, with `word` in message or hint.
static inline void check_refused_bytes(const char *text, size_t length, int code, unsigned line, unsigned column,
                                       const char *word)
{
    Fixture fixture = fixture_of_bytes(text, length);
    assert_null(fixture.root);
    assert_true(yk_problems_count(fixture.problems) > 0);
    const YkProblem *problem = yk_problems_get(fixture.problems, 0);
    bool fits = problem->code == code && problem->place.line == line && problem->place.column == column;
    bool says = !word || strstr(problem->message, word) || (problem->hint && strstr(problem->hint, word));
    if (!fits || !says)
        print_error("«%s»: wanted %d at %u:%u with «%s», got: %s", text, code, line, column, word ? word : "",
                    yk_problems_text(fixture.problems, 0));
    assert_true(fits && says);
    fixture_free(&fixture);
}

static inline void check_refused(const char *text, int code, unsigned line, unsigned column, const char *word)
{
    check_refused_bytes(text, strlen(text), code, line, column, word);
}
#endif
