// Reads `joints:`, which hold the bodies together, and the coordinates named there.
#include <string.h>
#include "model/load.h"

// Returns the key that gives the kind of joint; NULL (reported) unless there is exactly one.
static const YkNodePair *find_kind(YkLoader *loader, const YkNode *node, const YkNode *name)
{
    const YkNodePair *found = NULL;
    for (size_t i = 0; i < node->count; i++) {
        if (yk_part_find(node->pairs[i].key->text) == YK_PART_COUNT) continue;
        if (found) {
            yk_problem(loader->problems, YK_CODE_JOINT_KIND, node->pairs[i].key->place,
                       "joint %q is already a %s; it cannot also be a %s", name->text, found->key->text,
                       node->pairs[i].key->text);
            return NULL;
        }
        found = &node->pairs[i];
    }
    if (found) return found;
    static const char *const kinds[] = {"pin", "slide", "pin-slot", "weld", "free", NULL};
    const YkNode *first = node->count ? node->pairs[0].key : name;
    yk_problem(loader->problems, YK_CODE_JOINT_KIND, first->place,
               "joint %q is not declared as a pin, slide, pin-slot, weld or free", name->text);
    yk_load_hint_nearest_key(loader, first->text, kinds);
    return NULL;
}

static void read_bodies(YkLoader *loader, YkJoint *joint, const YkNode *list, const char *key)
{
    YkSubject subject = {.noun = key, .part = joint->name};
    if (!yk_load_expect(loader, list, YK_NODE_LIST, &subject)) {
        yk_problem_hint(loader->problems, "write its two bodies, as in `%s: [ground, crank]`", key);
        return;
    }
    if (list->count != 2) {
        yk_problem(loader->problems, YK_CODE_BODY_PAIR, list->place, "%s joins two bodies; here are %z",
                   yk_load_subject(loader, &subject), list->count);
        return;
    }
    for (int k = 0; k < 2; k++) joint->body[k] = yk_load_body(loader, list->items[k]);
    if (joint->body[0] == YK_NONE || joint->body[0] != joint->body[1]) return;
    yk_problem(loader->problems, YK_CODE_SELF_JOINT, list->place, "%s joins %q to itself",
               yk_load_subject(loader, &subject), loader->model->bodies[joint->body[0]].name);
}

// Reads a named direction, which is exact; any other is an angle, turned into a direction once it has a value.
static bool read_named_direction(YkJoint *joint, const char *text)
{
    static const struct {
        const char *name;
        YkVec along;
        double angle;
    } named[] = {{"x", {1, 0}, 0}, {"y", {0, 1}, YK_PI / 2}, {"-x", {-1, 0}, YK_PI}, {"-y", {0, -1}, -YK_PI / 2}};
    for (size_t i = 0; i < sizeof named / sizeof *named; i++) {
        if (strcmp(named[i].name, text) != 0) continue;
        joint->along = named[i].along;
        joint->along_angle = named[i].angle;
        return true;
    }
    return false;
}

static void read_direction(YkLoader *loader, YkJoint *joint, const YkNode *node)
{
    const YkNode *along = yk_node_get(node, "along"), *turned = yk_node_get(node, "turned");
    YkWant want = {.dimension = YK_DIM_ANGLE, .subject = {.noun = "direction", .owner = joint->name}};
    joint->along = yk_vec(1, 0);
    if (along && !(along->kind == YK_NODE_SCALAR && read_named_direction(joint, along->text))) {
        joint->along_expr = yk_load_value(loader, along, &want, &joint->along_angle);
    }
    want.subject.noun = "angle `turned`";
    if (turned) joint->turned_expr = yk_load_value(loader, turned, &want, &joint->turned);
}

static int32_t read_coordinate(YkLoader *loader, int32_t index, const YkNode *node, bool is_distance)
{
    const char *noun = is_distance ? "distance" : "angle";
    const YkNode *name = yk_node_get(node, noun);
    const YkJoint *joint = &loader->model->joints[index];
    if (!name) return YK_NONE;
    if (!yk_load_expect(loader, name, YK_NODE_SCALAR, &(YkSubject){.noun = noun, .owner = joint->name})) return YK_NONE;
    if (!yk_load_symbol_name(loader, name, "coordinate")) return YK_NONE;
    return yk_load_declare(loader, name->text, name->place, index, is_distance);
}

// Checks the keys; a key that other kinds of joint take gets a message why this one does not.
static void check_keys(YkLoader *loader, const YkJoint *joint, const YkNode *node)
{
    const YkPart *part = yk_part(joint->kind);
    const char *keys[16] = {part->key}; // its kind, its keys, two reported below, NULL
    size_t count = 1;
    for (size_t i = 0; part->keys[i]; i++) keys[count++] = part->keys[i];
    const YkNode *angle = yk_load_key(node, "angle"), *distance = yk_load_key(node, "distance");
    if (angle && !part->turns) {
        yk_problem(loader->problems, YK_CODE_COORDINATE_KIND, angle->place, "a %s does not turn: %q has no angle",
                   part->key, joint->name);
        keys[count++] = "angle";
    }
    if (distance && !part->slides) {
        yk_problem(loader->problems, YK_CODE_COORDINATE_KIND, distance->place,
                   "a %s does not move along a line: %q has no distance", part->key, joint->name);
        keys[count++] = "distance";
    }
    yk_load_check_keys(loader, node, keys, &(YkSubject){.noun = part->key, .part = joint->name});
}

// Takes the next carriage for a free joint.
static void make_free(YkLoader *loader, int32_t index, const YkNode *node)
{
    YkModel *model = loader->model;
    const YkJoint *joint = &model->joints[index];
    size_t first = model->body_count - model->carriage_count, k = model->joint_count - model->shown_joints;
    if (joint->body[0] == YK_NONE || joint->body[1] == YK_NONE) loader->has_bad_joint = true;
    model->joint_count++;
    yk_load_free_joint(loader, index, (int32_t)(first + k), (int32_t)(model->shown_joints + k), node);
}

static void read_joint(YkLoader *loader, int32_t index, const YkNodePair *pair)
{
    YkJoint *joint = &loader->model->joints[index];
    const YkNode *node = pair->value;
    const YkSubject subject = {.noun = "joint", .part = joint->name};
    const YkNodePair *kind =
        yk_load_expect(loader, node, YK_NODE_MAP, &subject) ? find_kind(loader, node, pair->key) : NULL;
    if (kind) {
        joint->kind = yk_part_find(kind->key->text);
        check_keys(loader, joint, node);
        read_bodies(loader, joint, kind->value, kind->key->text);
        if (joint->kind == YK_FREE) {
            make_free(loader, index, node);
            return;
        }
        read_direction(loader, joint, node);
        if (yk_part(joint->kind)->turns) joint->angle = read_coordinate(loader, index, node, false);
        if (yk_part(joint->kind)->slides) joint->distance = read_coordinate(loader, index, node, true);
        yk_load_friction(loader, yk_node_get(node, "friction"), joint);
    }
    if (joint->body[0] == YK_NONE || joint->body[1] == YK_NONE) {
        loader->has_bad_joint = true;
    } else {
        yk_load_joint_points(loader, joint, node);
    }
}

void yk_load_joints(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "joints");
    YkModel *model = loader->model;
    if (!section || section->count == 0) return;
    model->joints =
        YK_NEW(loader->arena, YkJoint, section->count + model->carriage_count + yk_load_count_planets(loader));
    if (!model->joints) return;
    model->joint_count = model->shown_joints = section->count;
    for (size_t i = 0; i < section->count && yk_load_goes_on(loader); i++) {
        const YkNode *key = section->pairs[i].key;
        int32_t existing;
        model->joints[i] = (YkJoint){.name = key->text,
                                     .place = key->place,
                                     .kind = YK_PART_COUNT,
                                     .body = {YK_NONE, YK_NONE},
                                     .point = {YK_NONE, YK_NONE},
                                     .angle = YK_NONE,
                                     .distance = YK_NONE};
        yk_load_name(loader, key, "joint");
        loader->failed |= !yk_names_add(&model->joint_names, key->text, (int32_t)i, &existing);
    }
    for (size_t i = 0; i < section->count && !yk_arena_failed(loader->arena) && yk_load_goes_on(loader); i++) {
        read_joint(loader, (int32_t)i, &section->pairs[i]);
    }
}
