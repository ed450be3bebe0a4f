// Reads a file of distributions: how each parameter scatters.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/number.h"
#include "base/problems.h"
#include "doc/node.h"
#include "model/load.h"
#include "study/sample.h"

typedef struct Entry {
    const char *name;
    YkDistribution distribution;
} Entry;

struct YkTolerances {
    YkArena *arena;
    Entry *entries;
    size_t count;
    uint64_t seed, designs;
};

typedef struct Reader {
    YkTolerances *t;
    const YkModel *model;
    YkProblems *problems;
    bool good;
} Reader;

static void refuse(Reader *r, const YkNode *node, const char *message, const char *word)
{
    yk_problem(r->problems, YK_CODE_BAD_TOLERANCE, node->place, message, word);
    yk_problem_hint(r->problems, "as in `a: {uniform: [39 mm, 41 mm]}`, `{normal: [40 mm, 0.1 mm], within: [39.8 mm, "
                                 "40.2 mm]}`, `{triangular: [39, 40, 41]}` or `{tolerance: 0.2 mm}`");
    r->good = false;
}

static bool read_value(Reader *r, const YkNode *node, const YkParameter *parameter, double *value)
{
    if (node->kind != YK_NODE_SCALAR) {
        refuse(r, node, "a value is expected here%s", "");
        return false;
    }
    if (yk_model_value_of(r->model, node->text, parameter->dimension, node->place, value, r->problems) == YK_OK)
        return true;
    r->good = false;
    return false;
}

// Reads [a, b, ...] with exactly `count` values.
static bool read_list(Reader *r, const YkNode *node, const YkParameter *parameter, size_t count, double *values)
{
    if (node->kind != YK_NODE_LIST || node->count != count) {
        refuse(r, node, "%s", count == 2 ? "two values are expected here" : "three values are expected here");
        return false;
    }
    bool good = true;
    for (size_t k = 0; k < count; k++) good = read_value(r, node->items[k], parameter, &values[k]) && good;
    return good;
}

static bool read_distribution(Reader *r, const YkNode *node, const YkParameter *parameter, YkDistribution *d)
{
    const char *const keys[] = {"uniform", "normal", "triangular", "tolerance"};
    const YkNode *found = NULL, *within = yk_node_get(node, "within");
    size_t kind = 0, known = within ? 1 : 0;
    double v[3];
    for (size_t k = 0; k < 4; k++)
        if (yk_node_get(node, keys[k])) found = yk_node_get(node, keys[k]), kind = k, known++;
    if (!found || known != node->count || known != (within ? 2u : 1u) || (within && kind != 1)) {
        refuse(r, node, "%q needs one of uniform, normal (with `within`, if it is cut off), triangular or tolerance",
               parameter->name);
        return false;
    }
    *d = (YkDistribution){.low = -INFINITY, .high = INFINITY};
    if (kind == 3) {
        if (!read_value(r, found, parameter, v)) return false;
        d->low = parameter->value - v[0], d->high = parameter->value + v[0];
    } else if (kind == 2) {
        if (!read_list(r, found, parameter, 3, v)) return false;
        *d = (YkDistribution){YK_DISTRIBUTION_TRIANGULAR, v[0], v[2], v[1], 0};
    } else {
        if (!read_list(r, found, parameter, 2, v)) return false;
        if (kind == 0) d->low = v[0], d->high = v[1];
        if (kind == 1) d->kind = YK_DISTRIBUTION_NORMAL, d->center = v[0], d->spread = v[1];
    }
    if (within) {
        if (!read_list(r, within, parameter, 2, v)) return false;
        d->low = v[0], d->high = v[1];
    }
    if (yk_distribution_is_valid(d)) return true;
    refuse(r, found, "the distribution of %q makes no sense: its ends are in the wrong order, or it has no width",
           parameter->name);
    return false;
}

static void read_entry(Reader *r, const YkNodePair *pair)
{
    const YkModel *model = r->model;
    int32_t index = yk_names_find(&model->parameter_names, pair->key->text);
    if (index == YK_NONE) {
        yk_problem(r->problems, YK_CODE_UNKNOWN_OVERRIDE, pair->key->place, "the model has no parameter %q",
                   pair->key->text);
        yk_load_hint_nearest(r->problems, pair->key->text, model->parameters, model->parameter_count,
                             sizeof *model->parameters);
        r->good = false;
        return;
    }
    Entry *entry = &r->t->entries[r->t->count];
    entry->name = model->parameters[index].name;
    if (pair->value->kind != YK_NODE_MAP)
        refuse(r, pair->value, "%q needs a distribution", pair->key->text);
    else if (read_distribution(r, pair->value, &model->parameters[index], &entry->distribution))
        r->t->count++;
}

static void read_whole(Reader *r, const YkNode *root, const char *key, uint64_t *whole)
{
    const YkNode *node = yk_node_get(root, key);
    double value;
    if (!node) return;
    bool good = node->kind == YK_NODE_SCALAR && yk_number_read(node->text, node->length, &value) == node->length &&
                value >= 0 && value <= 0x1p53 && value == floor(value);
    if (good)
        *whole = (uint64_t)value;
    else
        refuse(r, node, "%q is a whole number, zero or positive", key);
}

static void read(Reader *r, const YkNode *root)
{
    const YkNode *parameters = root->kind == YK_NODE_MAP ? yk_node_get(root, "parameters") : NULL;
    if (!parameters || parameters->kind != YK_NODE_MAP || parameters->count == 0) {
        refuse(r, root, "a file of tolerances has a section `parameters`%s", "");
        return;
    }
    for (size_t k = 0; k < root->count; k++) {
        const char *key = root->pairs[k].key->text;
        if (strcmp(key, "parameters") != 0 && strcmp(key, "seed") != 0 && strcmp(key, "designs") != 0)
            refuse(r, root->pairs[k].key, "a file of tolerances has seed, designs and parameters, no %q", key);
    }
    read_whole(r, root, "seed", &r->t->seed);
    read_whole(r, root, "designs", &r->t->designs);
    r->t->entries = YK_NEW(r->t->arena, Entry, parameters->count);
    for (size_t k = 0; r->t->entries && k < parameters->count; k++) read_entry(r, &parameters->pairs[k]);
}

YkTolerances *yk_tolerances_load(const char *path, const YkModel *model, YkProblems *problems)
{
    size_t length = 0;
    YkTolerances *t = calloc(1, sizeof *t);
    if (t) t->arena = yk_arena_new();
    bool has_memory = t && t->arena;
    char *text = has_memory ? yk_doc_read_file(path, &length, problems) : NULL;
    Reader r = {t, model, problems, text != NULL};
    if (text) {
        t->seed = 1;
        const YkNode *root = yk_doc_parse(text, length, path, t->arena, problems);
        r.good = root != NULL;
        if (root) read(&r, root);
        has_memory = !yk_arena_failed(t->arena);
    }
    free(text);
    if (!has_memory)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while reading tolerances");
    if (r.good && has_memory) return t;
    yk_tolerances_free(t);
    return NULL;
}

void yk_tolerances_free(YkTolerances *t)
{
    if (!t) return;
    yk_arena_free(t->arena);
    free(t);
}

size_t yk_tolerances_count(const YkTolerances *t)
{
    return t->count;
}
const char *yk_tolerances_name(const YkTolerances *t, size_t index)
{
    return index < t->count ? t->entries[index].name : NULL;
}
YkDistribution yk_tolerances_at(const YkTolerances *t, size_t index)
{
    return index < t->count ? t->entries[index].distribution
                            : (YkDistribution){.low = (double)NAN, .high = (double)NAN};
}
uint64_t yk_tolerances_seed(const YkTolerances *t)
{
    return t->seed;
}
uint64_t yk_tolerances_designs(const YkTolerances *t)
{
    return t->designs;
}
