// Reads the values that tasks of all kinds have.
#include <math.h>
#include <string.h>
#include "synthesis/tasks/task.h"

void yk_task_value(YkTaskReader *reader, const YkNode *map, const char *key, YkDimension dimension, YkGiven *given)
{
    const YkNode *node = map ? yk_node_get(map, key) : NULL;
    YkWant want = {.dimension = dimension, .subject = {.noun = "value", .part = key}};
    *given = (YkGiven){.is_given = node != NULL};
    if (node) yk_load_value(reader->loader, node, &want, &given->value);
}

void yk_task_need(YkTaskReader *reader, const YkNode *map, const char *key, YkDimension dimension, double *value)
{
    const YkNode *node = yk_load_require(reader->loader, map, key, &(YkSubject){.noun = "the task"});
    YkWant want = {.dimension = dimension, .subject = {.noun = "value", .part = key}};
    *value = NAN;
    if (node) yk_load_value(reader->loader, node, &want, value);
}

void yk_task_bound(YkTaskReader *reader, const YkNode *node, const char *key, YkDimension dimension, YkBound *bound)
{
    YkSubject subject = {.noun = "range", .part = key};
    YkWant want = {.dimension = dimension, .subject = subject};
    *bound = node ? (YkBound){NAN, NAN, true} : (YkBound){-INFINITY, INFINITY, false};
    if (!node || !yk_load_expect(reader->loader, node, YK_NODE_LIST, &subject)) return;
    if (node->count != 2) {
        yk_problem(reader->loader->problems, YK_CODE_COMPONENTS, node->place,
                   "range %q has two ends, [from, to]; here are %z", key, node->count);
        return;
    }
    yk_load_value(reader->loader, node->items[0], &want, &bound->low);
    yk_load_value(reader->loader, node->items[1], &want, &bound->high);
}

void yk_task_point(YkTaskReader *reader, const YkNode *map, const char *key, YkGivenPoint *point)
{
    const YkNode *node = map ? yk_node_get(map, key) : NULL;
    YkWant want = {.dimension = YK_DIM_LENGTH, .subject = {.noun = "point", .part = key}};
    YkExpr *expr[2];
    *point = (YkGivenPoint){.is_given = node != NULL};
    if (node) yk_load_pair(reader->loader, node, &want, expr, &point->at);
}

bool yk_task_word(YkTaskReader *reader, const YkNode *map, const char *key, const char *const *words, size_t *found)
{
    const YkNode *node = map ? yk_node_get(map, key) : NULL;
    YkText list = {0};
    if (!node || !yk_load_expect(reader->loader, node, YK_NODE_SCALAR, &(YkSubject){.noun = "value", .part = key}))
        return false;
    for (size_t k = 0; words[k]; k++) {
        if (strcmp(words[k], node->text) == 0) {
            *found = k;
            yk_text_free(&list);
            return true;
        }
        yk_text_format(&list, "%s%s", k == 0 ? "" : words[k + 1] ? ", " : " or ", words[k]);
    }
    yk_problem(reader->loader->problems, YK_CODE_WRONG_WORD, node->place, "%q is %s, not %q", key, yk_text_get(&list),
               node->text);
    yk_text_free(&list);
    return false;
}

bool yk_task_yes(YkTaskReader *reader, const YkNode *map, const char *key, bool otherwise)
{
    static const char *const words[] = {"true", "false", NULL};
    size_t found = otherwise ? 0 : 1;
    yk_task_word(reader, map, key, words, &found);
    return found == 0;
}
