// Reads `bodies:`: the ground first, then the bodies in the file's order, each with its points.
#include "model/load.h"

static const char *const keys[] = {"points", "mass", "center", "inertia", "rod", NULL};

// Returns the body's map, or NULL if it has none (`sun:` is a body without points).
static const YkNode *body_map(YkLoader *loader, const YkNode *node, const char *name)
{
    YkSubject subject = {.noun = "body", .part = name};
    if (yk_load_is_empty(node) || !yk_load_expect(loader, node, YK_NODE_MAP, &subject)) return NULL;
    yk_load_check_keys(loader, node, keys, &subject);
    return node;
}

// Gives every body its number and name; nodes[i] is its map. The ground is number 0 wherever it appears.
static void name_bodies(YkLoader *loader, const YkNode *section, const YkNode **nodes)
{
    YkModel *model = loader->model;
    int32_t existing;
    model->bodies[0] = (YkBody){.name = "ground", .rod = {YK_NONE, YK_NONE}};
    model->body_count = 1;
    loader->failed |= !yk_names_add(&model->body_names, "ground", 0, &existing);
    for (size_t i = 0; section && i < section->count && yk_load_goes_on(loader); i++) {
        const YkNode *key = section->pairs[i].key;
        yk_load_name(loader, key, "body");
        loader->failed |= !yk_names_add(&model->body_names, key->text, (int32_t)model->body_count, &existing);
        size_t body = existing == YK_NONE ? model->body_count++ : (size_t)existing;
        if (existing == YK_NONE) model->bodies[body] = (YkBody){.name = key->text, .rod = {YK_NONE, YK_NONE}};
        model->bodies[body].place = key->place;
        nodes[body] = body_map(loader, section->pairs[i].value, key->text);
    }
}

void yk_load_bodies(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "bodies");
    YkModel *model = loader->model;
    size_t room = 1 + (section ? section->count : 0) + yk_load_count_free(loader) + yk_load_count_planets(loader);
    const YkNode **nodes = YK_NEW(loader->arena, const YkNode *, room);
    model->bodies = YK_NEW(loader->arena, YkBody, room);
    if (!model->bodies || !nodes) return;
    name_bodies(loader, section, nodes);
    if (model->body_count == 1 && !loader->failed && !loader->is_sketch) {
        yk_problem(loader->problems, YK_CODE_NO_BODIES, section ? section->place : loader->root->place,
                   "this machine has no bodies");
        yk_problem_hint(loader->problems, "list them as in `bodies: {crank: {points: {A: [0.1, 0]}}}`");
    }
    yk_load_points(loader, section, nodes);
    yk_load_carriages(loader);
    for (size_t i = 0; i < model->body_count && !yk_arena_failed(loader->arena) && yk_load_goes_on(loader); i++) {
        if (nodes[i]) yk_load_mass(loader, (int32_t)i, nodes[i]);
    }
}
