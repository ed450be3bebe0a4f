// Decides which names are allowed, and finds the one nearest to an unknown name.
#include <stdlib.h>
#include <string.h>
#include "base/letters.h"
#include "graph/function.h"
#include "model/load.h"

enum { NEAREST_MAX = 10000 }; // as many as yk_nearest looks at

// Returns what a name means in every expression; NULL if it is free.
static const char *reserved_meaning(const char *name)
{
    YkFunction function;
    if (strcmp(name, "t") == 0) return "the time";
    if (strcmp(name, "pi") == 0) return "a number";
    return yk_function_find(name, &function) ? "a function" : NULL;
}

static bool is_name(const YkNode *node, bool for_expressions)
{
    if (node->length == 0 || node->length > YK_NAME_MAX || !yk_begins_name(node->text[0])) return false;
    for (size_t i = 1; i < node->length; i++) {
        char c = node->text[i];
        if (!yk_begins_name(c) && !yk_is_digit(c) && (c != '-' || for_expressions)) return false;
    }
    return true;
}

static bool check_name(YkLoader *loader, const YkNode *node, const char *noun, bool for_expressions)
{
    if (node->kind != YK_NODE_SCALAR) {
        YkSubject subject = {.noun = "name of a", .axis = noun};
        return yk_load_expect(loader, node, YK_NODE_SCALAR, &subject);
    }
    if (is_name(node, for_expressions)) return true;
    yk_problem(loader->problems, YK_CODE_BAD_NAME, node->place, "%q cannot be the name of a %s", node->text, noun);
    yk_problem_hint(loader->problems,
                    for_expressions
                        ? "use at most 100 letters, digits and `_`, beginning with a letter, as in `l1`"
                        : "use at most 100 letters, digits, `_` and `-`, beginning with a letter, as in `link-1`");
    return false;
}

bool yk_load_name(YkLoader *loader, const YkNode *node, const char *noun)
{
    return check_name(loader, node, noun, false);
}

bool yk_load_symbol_name(YkLoader *loader, const YkNode *node, const char *noun)
{
    if (!check_name(loader, node, noun, true)) return false;
    const char *meaning = reserved_meaning(node->text);
    if (meaning) {
        yk_problem(loader->problems, YK_CODE_RESERVED_NAME, node->place, "%q cannot be the name of a %s: it is %s",
                   node->text, noun, meaning);
    }
    return !meaning;
}

// Collects the names of structs that begin with their name.
static size_t gather(const char **names, size_t room, const void *items, size_t count, size_t size)
{
    size_t found = 0;
    for (size_t i = 0; i < count && found < room; i++) {
        const char *name = *(const char *const *)((const char *)items + i * size);
        if (name) names[found++] = name;
    }
    return found;
}

// Returns whether to look for near names, which costs time: not once no more problems are recorded.
static bool is_worth_a_hint(const YkProblems *problems, const char *name)
{
    return strlen(name) <= YK_NAME_MAX && yk_problems_count(problems) < YK_PROBLEMS_MAX;
}

static bool hint(YkProblems *problems, const char *nearest)
{
    if (nearest) yk_problem_hint(problems, "did you mean %q?", nearest);
    return nearest != NULL;
}

// Returns room for names, or NULL with E0100: a message without its hint is not the right one.
static const char **names_new(YkProblems *problems, size_t count)
{
    const char **names = malloc(count * sizeof *names);
    if (!names)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while looking for similar names");
    return names;
}

bool yk_load_hint_nearest(YkProblems *problems, const char *name, const void *items, size_t count, size_t size)
{
    if (!is_worth_a_hint(problems, name) || count == 0) return false;
    size_t room = count < NEAREST_MAX ? count : NEAREST_MAX;
    const char **names = names_new(problems, room);
    if (!names) return false;
    bool found = hint(problems, yk_nearest(name, names, gather(names, room, items, count, size)));
    free(names);
    return found;
}

// Words of textbooks and other programs, each with the key that says the same here.
static const char *const synonyms[][2] = {
    {"title", "name"},           {"links", "bodies"},
    {"loads", "forces"},         {"load", "forces"},
    {"constants", "parameters"}, {"variables", "parameters"},
    {"motors", "efforts"},       {"torques", "efforts"},
    {"inputs", "drives"},        {"motion", "drives"},
    {"guess", "start"},          {"initial", "start"},
    {"revolute", "pin"},         {"hinge", "pin"},
    {"prismatic", "slide"},      {"slider", "slide"},
    {"slot", "pin-slot"},        {"fixed", "weld"},
    {"force", "value"},          {"torque", "moment"},
    {"cog", "center"},           {"com", "center"},
    {"k", "stiffness"},          {"c", "damping"},
    {"dampers", "springs"},      {"damper", "damping"},
};

// Returns the key of these that `name` means elsewhere, or NULL.
static const char *synonym(const char *name, const char *const *keys)
{
    for (size_t i = 0; i < sizeof synonyms / sizeof *synonyms; i++) {
        if (strcmp(name, synonyms[i][0]) != 0) continue;
        for (size_t k = 0; keys[k]; k++)
            if (strcmp(keys[k], synonyms[i][1]) == 0) return keys[k];
    }
    return NULL;
}

void yk_load_hint_nearest_key(YkLoader *loader, const char *name, const char *const *keys)
{
    size_t count = 0;
    while (keys[count]) count++;
    if (!is_worth_a_hint(loader->problems, name)) return;
    if (hint(loader->problems, synonym(name, keys))) return;
    if (hint(loader->problems, yk_nearest(name, keys, count))) return;
    YkText text = {0};
    for (size_t i = 0; i < count; i++) yk_text_format(&text, i ? ", %s" : "%s", keys[i]);
    yk_problem_hint(loader->problems, "the keys here are: %s", yk_text_get(&text));
    yk_text_free(&text);
}

void yk_load_hint_nearest_symbol(YkLoader *loader, const char *name)
{
    const YkModel *model = loader->model;
    if (!is_worth_a_hint(loader->problems, name)) return;
    const char **names = names_new(loader->problems, 2 * NEAREST_MAX);
    if (!names) return;
    size_t count = gather(names, NEAREST_MAX, model->parameters, model->parameter_count, sizeof *model->parameters);
    count +=
        gather(names + count, NEAREST_MAX, model->coordinates, model->coordinate_count, sizeof *model->coordinates);
    hint(loader->problems, yk_nearest(name, names, count));
    free(names);
}
