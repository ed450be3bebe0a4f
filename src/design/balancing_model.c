// Writes a model with counterweights: each a body of its own, welded to the one that it balances.
#include <string.h>
#include <yoke/builder.h>
#include "design/balancing.h"
#include "doc/node.h"

// Adds a pair to a map of the tree.
static bool add_pair(YkArena *arena, YkNode *map, const char *name, const YkText *value)
{
    YkNode *node = yk_doc_parse(yk_text_get(value), value->length, "counterweight", arena, NULL);
    YkNode *key = YK_NEW(arena, YkNode, 1);
    YkNodePair *pairs = YK_NEW(arena, YkNodePair, map->count + 1);
    if (!node || !key || !pairs || value->failed) return false;
    if (map->count > 0) memcpy(pairs, map->pairs, map->count * sizeof *pairs);
    *key = (YkNode){.kind = YK_NODE_SCALAR, .text = name, .length = strlen(name)};
    pairs[map->count] = (YkNodePair){key, node};
    map->pairs = pairs;
    map->count++;
    return true;
}

static YkNode *section(YkNode *root, const char *name)
{
    for (size_t k = 0; k < root->count; k++)
        if (strcmp(root->pairs[k].key->text, name) == 0) return root->pairs[k].value;
    return NULL;
}

// Adds one counterweight: a point mass, in axes parallel to the body's, with its origin in the body's pin.
static bool add_weight(const YkModel *model, YkArena *arena, YkNode *root, const YkCounterweight *w)
{
    const YkJoint *pin = &model->joints[w->joint];
    int side = pin->body[1] == (int32_t)w->body;
    const char *point = pin->point[side] == YK_NONE ? NULL : model->points[pin->point[side]].name;
    const char *body = model->bodies[w->body].name;
    YkText name = {0}, text = {0};
    YkNode *bodies = section(root, "bodies"), *joints = section(root, "joints");
    YkVec at = yk_scale(w->radius, yk_unit(w->angle));
    yk_text_format(&name, "counterweight-%s", body);
    const char *own = yk_arena_copy(arena, yk_text_get(&name), name.length);
    if (point) yk_text_format(&text, "{points: {%s: [0, 0]}, ", point);
    yk_text_format(&text, "%smass: %g kg, center: [%g m, %g m], inertia: 0}", point ? "" : "{", w->mass, at.x, at.y);
    bool good = own && bodies && joints && add_pair(arena, bodies, own, &text);
    yk_text_clear(&text);
    yk_text_format(&text, "{weld: [%s, %s]%s%s}", body, own ? own : "", point ? ", at: " : "", point ? point : "");
    good = good && add_pair(arena, joints, own, &text);
    yk_text_free(&name);
    yk_text_free(&text);
    return good;
}

bool yk_balancing_write(const YkModel *model, YkBalancing *balancing)
{
    const char *source = yk_model_text(model);
    YkArena *arena = source ? yk_arena_new() : NULL;
    YkNode *root = arena ? yk_doc_parse(source, strlen(source), "model", arena, NULL) : NULL;
    bool good = root != NULL;
    for (size_t k = 0; k < balancing->count && good; k++) good = add_weight(model, arena, root, &balancing->weight[k]);
    yk_text_clear(&balancing->model);
    if (good) {
        yk_text_puts(&balancing->model, "# With counterweights by `yoke balance`.\n");
        yk_doc_write(root, &balancing->model);
    }
    yk_arena_free(arena);
    return good && !balancing->model.failed;
}
