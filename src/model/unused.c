// Keys that kinematics does not compute with: forces, springs, stops, friction. Their names and units are checked, so
// that a file stands when a later version reads it, and one note says that they are not used.
#include <string.h>
#include "model/load.h"

#define STIFFNESS YK_DIM(0, 1, -2, 0)
#define DAMPING YK_DIM(0, 1, -1, 0)
#define TURN_STIFFNESS YK_DIM(2, 1, -2, -1)
#define TURN_DAMPING YK_DIM(2, 1, -1, -1)

static void note(YkLoader *loader, const YkNode *key, const char *what)
{
    yk_problem(loader->problems, YK_CODE_NOT_USED, key->place, "%s are read but not used by kinematics", what);
}

// Reads the value of a key for its mistakes only.
static void check_value(YkLoader *loader, const YkNode *map, const char *key, YkDimension dimension, const char *owner)
{
    const YkNode *node = yk_node_get(map, key);
    YkWant want = {.dimension = dimension, .scope = YK_SCOPE_STATE, .subject = {.noun = key, .owner = owner}};
    if (node) yk_load_value(loader, node, &want, NULL);
}

static const YkNode *require(YkLoader *loader, const YkNode *map, const char *key, const YkSubject *subject)
{
    const YkNode *node = yk_node_get(map, key);
    if (!node) {
        yk_problem(loader->problems, YK_CODE_MISSING_KEY, map->place, "%s needs `%s`", yk_load_subject(loader, subject),
                   key);
    }
    return node;
}

static void check_force(YkLoader *loader, const YkPair *pair)
{
    static const char *const keys[] = {"on", "at", "value", "axes", NULL};
    const char *name = pair->key->text;
    const YkSubject subject = {.noun = "force", .part = name};
    yk_load_name(loader, pair->key, "force");
    if (!yk_load_expect(loader, pair->value, YK_NODE_MAP, &subject)) return;
    yk_load_check_keys(loader, pair->value, keys, &subject);
    const YkNode *on = require(loader, pair->value, "on", &subject), *at = yk_node_get(pair->value, "at");
    int32_t body = on ? yk_load_body(loader, on) : YK_NONE;
    if (at && body != YK_NONE) yk_load_point(loader, body, at);
    const YkNode *value = require(loader, pair->value, "value", &subject), *axes = yk_node_get(pair->value, "axes");
    YkWant want = {.dimension = YK_DIM_FORCE, .scope = YK_SCOPE_STATE, .subject = subject};
    YkExpr *expr[2];
    if (value) yk_load_pair(loader, value, &want, expr, NULL);
    if (!axes || !yk_load_expect(loader, axes, YK_NODE_SCALAR, &(YkSubject){.noun = "axes", .owner = name})) return;
    if (strcmp(axes->text, "body") == 0 || strcmp(axes->text, "world") == 0) return;
    yk_problem(loader->problems, YK_CODE_WRONG_WORD, axes->place, "the axes of a force are `body` or `world`, not %q",
               axes->text);
}

static void check_ends(YkLoader *loader, const YkNode *ends, const char *name)
{
    const YkSubject subject = {.noun = "between", .owner = name};
    if (!yk_load_expect(loader, ends, YK_NODE_LIST, &subject)) return;
    if (ends->count != 2) {
        yk_problem(loader->problems, YK_CODE_COMPONENTS, ends->place, "%s names two points; here are %z",
                   yk_load_subject(loader, &subject), ends->count);
        return;
    }
    int32_t body;
    for (int k = 0; k < 2; k++) yk_load_body_point(loader, ends->items[k], &body);
}

static void check_spring(YkLoader *loader, const YkPair *pair)
{
    static const char *const keys[] = {"between", "along", "stiffness", "length", "angle", "damping", NULL};
    const char *name = pair->key->text;
    const YkSubject subject = {.noun = "spring", .part = name};
    yk_load_name(loader, pair->key, "spring");
    if (!yk_load_expect(loader, pair->value, YK_NODE_MAP, &subject)) return;
    yk_load_check_keys(loader, pair->value, keys, &subject);
    const YkNode *along = yk_node_get(pair->value, "along");
    const YkNode *between =
        along ? yk_node_get(pair->value, "between") : require(loader, pair->value, "between", &subject);
    bool turns = false;
    if (along && yk_load_expect(loader, along, YK_NODE_SCALAR, &(YkSubject){.noun = "along", .owner = name})) {
        int32_t coordinate = yk_load_coordinate_key(loader, along, NULL);
        turns = coordinate >= 0 && !loader->model->coordinates[coordinate].is_distance;
    }
    if (between) check_ends(loader, between, name);
    check_value(loader, pair->value, "stiffness", turns ? TURN_STIFFNESS : STIFFNESS, name);
    check_value(loader, pair->value, "damping", turns ? TURN_DAMPING : DAMPING, name);
    check_value(loader, pair->value, "length", YK_DIM_LENGTH, name);
    check_value(loader, pair->value, "angle", YK_DIM_ANGLE, name);
}

static void check_stop(YkLoader *loader, const YkPair *pair)
{
    int32_t coordinate = yk_load_coordinate_key(loader, pair->key, NULL);
    if (coordinate < 0) return;
    bool is_distance = loader->model->coordinates[coordinate].is_distance;
    YkWant want = {.dimension = is_distance ? YK_DIM_LENGTH : YK_DIM_ANGLE,
                   .subject = {.noun = "stop", .owner = pair->key->text}};
    if (!yk_load_expect(loader, pair->value, YK_NODE_LIST, &want.subject)) return;
    if (pair->value->count != 2) {
        yk_problem(loader->problems, YK_CODE_COMPONENTS, pair->value->place,
                   "%s has two ends, [lowest, highest]; here are %z", yk_load_subject(loader, &want.subject),
                   pair->value->count);
        return;
    }
    for (int k = 0; k < 2; k++) yk_load_value(loader, pair->value->items[k], &want, NULL);
}

static void check_section(YkLoader *loader, const char *name, void (*check)(YkLoader *, const YkPair *))
{
    const YkNode *section = yk_load_section(loader, name);
    if (!section || section->count == 0) return;
    note(loader, yk_load_key(loader->root, name), name);
    for (size_t i = 0; i < section->count; i++) check(loader, &section->pairs[i]);
}

void yk_load_unused(YkLoader *loader)
{
    check_section(loader, "forces", check_force);
    check_section(loader, "springs", check_spring);
    check_section(loader, "stops", check_stop);
}

void yk_load_friction(YkLoader *loader, const YkNode *node, const YkJoint *joint)
{
    static const char *const keys[] = {"coulomb", "radius", "viscous", NULL};
    if (!node) return;
    const YkSubject subject = {.noun = "friction", .owner = joint->name};
    if (!yk_load_expect(loader, node, YK_NODE_MAP, &subject)) return;
    if (!loader->noted_friction) note(loader, node, "friction values");
    loader->noted_friction = true;
    yk_load_check_keys(loader, node, keys, &subject);
    check_value(loader, node, "coulomb", YK_DIM_NUMBER, joint->name);
    check_value(loader, node, "radius", YK_DIM_LENGTH, joint->name);
    check_value(loader, node, "viscous", yk_part(joint->kind)->turns ? TURN_DAMPING : DAMPING, joint->name);
}
