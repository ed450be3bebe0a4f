// Reads `points:` of every body; those of one body are contiguous, and all are found by "body.point".
#include <string.h>
#include "model/load.h"

static const YkNode *points_map(YkLoader *loader, const YkBody *body, const YkNode *node)
{
    const YkNode *points = node ? yk_node_get(node, "points") : NULL;
    if (yk_load_is_empty(points)) return NULL;
    YkSubject subject = {.noun = "list of points", .owner = body->name};
    return yk_load_expect(loader, points, YK_NODE_MAP, &subject) ? points : NULL;
}

// Returns "body.point" in the arena: the key of the table of points.
static const char *full_name(YkLoader *loader, const char *body, const YkNode *point)
{
    size_t length = strlen(body);
    char *name = YK_NEW(loader->arena, char, length + point->length + 2);
    if (!name) return NULL;
    memcpy(name, body, length);
    name[length] = '.';
    memcpy(name + length + 1, point->text, point->length);
    return name;
}

static void read_point(YkLoader *loader, int32_t body, const YkNodePair *pair)
{
    YkModel *model = loader->model;
    size_t index = model->point_count++;
    YkPoint *point = &model->points[index];
    const char *owner = model->bodies[body].name;
    *point = (YkPoint){.name = pair->key->text, .place = pair->key->place, .body = body};
    yk_load_name(loader, pair->key, "point");
    int32_t existing;
    const char *key = full_name(loader, owner, pair->key);
    loader->failed |= !key || !yk_names_add(&model->point_names, key, (int32_t)index, &existing);
    YkWant want = {.dimension = YK_DIM_LENGTH,
                   .scope = YK_SCOPE_CONSTANT,
                   .subject = {.noun = "point", .part = point->name, .owner = owner}};
    YkExpr *expr[2] = {NULL, NULL};
    yk_load_pair(loader, pair->value, &want, expr, &point->at);
    point->x = expr[0];
    point->y = expr[1];
}

void yk_load_points(YkLoader *loader, const YkNode *bodies, const YkNode **nodes)
{
    YkModel *model = loader->model;
    size_t total = 0;
    for (size_t i = 0; i < model->body_count; i++) {
        const YkNode *points = points_map(loader, &model->bodies[i], nodes[i]);
        if (points) total += points->count;
    }
    if (total == 0 || !yk_load_count_fits(loader, bodies, total, "points")) return;
    model->points = YK_NEW(loader->arena, YkPoint, total);
    if (!model->points) return;
    for (size_t i = 0; i < model->body_count && yk_load_goes_on(loader); i++) {
        YkBody *body = &model->bodies[i];
        body->first_point = (int32_t)model->point_count;
        const YkNode *points = nodes[i] ? yk_node_get(nodes[i], "points") : NULL;
        if (!points || points->kind != YK_NODE_MAP) continue;
        for (size_t k = 0; k < points->count; k++) read_point(loader, (int32_t)i, &points->pairs[k]);
        body->point_count = (int32_t)points->count;
    }
}
