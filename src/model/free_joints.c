// Makes a free joint of a slide, a carriage without mass and a pin-slot, so that no other room has to know a joint with
// three freedoms. Carriages and their slides stand behind all bodies and joints of the file.
#include "model/load.h"

static bool is_free(const YkNode *joint)
{
    return joint->kind == YK_NODE_MAP && yk_node_get(joint, yk_part(YK_FREE)->key);
}

size_t yk_load_count_free(YkLoader *loader)
{
    const YkNode *section = yk_node_get(loader->root, "joints");
    size_t count = 0;
    for (size_t i = 0; section && section->kind == YK_NODE_MAP && i < section->count; i++)
        count += is_free(section->pairs[i].value);
    return count;
}

void yk_load_carriages(YkLoader *loader)
{
    YkModel *model = loader->model;
    const YkNode *section = yk_node_get(loader->root, "joints");
    for (size_t i = 0; section && section->kind == YK_NODE_MAP && i < section->count; i++) {
        if (!is_free(section->pairs[i].value)) continue;
        const YkNode *key = section->pairs[i].key;
        model->bodies[model->body_count++] =
            (YkBody){.name = key->text, .place = key->place, .rod = {YK_NONE, YK_NONE}, .is_carriage = true};
        model->carriage_count++;
    }
}

// Names a coordinate: as `at` does, or JOINT.x, JOINT.y, JOINT.angle.
static int32_t name_coordinate(YkLoader *loader, int32_t index, const YkNode *at, size_t k, bool is_distance)
{
    static const char *const endings[] = {"x", "y", "angle"};
    const YkJoint *joint = &loader->model->joints[index];
    const YkSubject subject = {.noun = "at", .owner = joint->name};
    const YkNode *name = at ? at->items[k] : NULL;
    if (!name) {
        yk_text_clear(&loader->text);
        yk_text_format(&loader->text, "%s.%s", joint->name, endings[k]);
        const char *own = yk_arena_copy(loader->arena, yk_text_get(&loader->text), loader->text.length);
        return own ? yk_load_declare(loader, own, joint->place, index, is_distance) : YK_NONE;
    }
    if (!yk_load_expect(loader, name, YK_NODE_SCALAR, &subject)) return YK_NONE;
    if (!yk_load_symbol_name(loader, name, "coordinate")) return YK_NONE;
    return yk_load_declare(loader, name->text, name->place, index, is_distance);
}

// Returns the names of the coordinates; NULL if they are left out or (reported) wrong.
static const YkNode *names_of(YkLoader *loader, const YkJoint *joint, const YkNode *node)
{
    const YkNode *at = yk_node_get(node, "at");
    const YkSubject subject = {.noun = "at", .owner = joint->name};
    if (!at || !yk_load_expect(loader, at, YK_NODE_LIST, &subject)) return NULL;
    if (at->count == 3) return at;
    yk_problem(loader->problems, YK_CODE_COMPONENTS, at->place,
               "%s names three coordinates, as in `at: [x, y, phi]`; here are %z", yk_load_subject(loader, &subject),
               at->count);
    return NULL;
}

void yk_load_free_joint(YkLoader *loader, int32_t index, int32_t carriage, int32_t slide, const YkNode *node)
{
    YkModel *model = loader->model;
    YkJoint *own = &model->joints[index], *other = &model->joints[slide];
    const YkNode *from = yk_node_get(node, "from"), *to = yk_node_get(node, "to"), *at = names_of(loader, own, node);
    *other = *own;
    other->kind = YK_SLIDE;
    other->body[1] = carriage;
    other->along = yk_vec(1, 0);
    own->kind = YK_PIN_SLOT;
    own->body[0] = carriage;
    own->along = yk_vec(0, 1);
    own->along_angle = YK_PI / 2;
    own->is_free = other->is_free = true;
    own->partner = slide;
    other->partner = index;
    other->distance = name_coordinate(loader, slide, at, 0, true);
    own->distance = name_coordinate(loader, index, at, 1, true);
    own->angle = name_coordinate(loader, index, at, 2, false);
    if (other->body[0] == YK_NONE || own->body[1] == YK_NONE) return;
    if (from) other->point[0] = yk_load_point(loader, other->body[0], from);
    if (to) own->point[1] = yk_load_point(loader, own->body[1], to);
}
