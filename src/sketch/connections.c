// Groups of bodies that float, open ends, and where either could be pinned: at points of the same name.
#include <stdlib.h>
#include "base/sets.h"
#include "sketch/sketch.h"

enum { LOOKS = 64 }; // at most this number of points of one name is looked at for each

// The sketch's own joints, with the slides of free joints, followed by the welds of the parts that float.
static size_t own_joints(const YkModel *model)
{
    return model->joint_count - model->held_joints;
}

// The sketch's own joints unite their bodies; the first body leads each group.
static bool find_groups(YkSketch *sketch)
{
    const YkModel *model = sketch->model;
    int32_t *group = calloc(model->body_count, sizeof *group);
    sketch->group = group;
    if (!group) return false;
    for (size_t b = 0; b < model->body_count; b++) group[b] = (int32_t)b;
    for (size_t j = 0; j < own_joints(model); j++) {
        int32_t a = yk_root_of(group, model->joints[j].body[0]), b = yk_root_of(group, model->joints[j].body[1]);
        group[a > b ? a : b] = a > b ? b : a;
    }
    for (size_t b = 0; b < model->body_count; b++) group[b] = yk_root_of(group, (int32_t)b);
    return true;
}

// Points by name: the first of each name, and from each point to the next of its name.
typedef struct PointNames {
    YkNames first;
    int32_t *next;
} PointNames;

static bool gather(const YkModel *model, PointNames *names)
{
    names->next = calloc(model->point_count + 1, sizeof *names->next);
    bool good = names->next != NULL;
    for (size_t p = model->point_count; good && p-- > 0;) {
        int32_t other;
        names->next[p] = YK_NONE;
        good = yk_names_add(&names->first, model->points[p].name, (int32_t)p, &other);
        if (good && other == YK_NONE) continue;
        names->next[p] = good ? names->next[other] : YK_NONE;
        if (good) names->next[other] = (int32_t)p;
    }
    return good;
}

// Are two bodies joined by a joint of the sketch's own?
static bool are_joined(const YkSketch *sketch, int32_t a, int32_t b)
{
    for (size_t j = 0; j < yk_sketch_joint_count(sketch); j++) {
        int32_t body[] = {(int32_t)yk_model_joint_body(sketch->model, j, 0),
                          (int32_t)yk_model_joint_body(sketch->model, j, 1)};
        if ((body[0] == a && body[1] == b) || (body[0] == b && body[1] == a)) return true;
    }
    return false;
}

// A point of the same name on another body - outside of the group, where `leaves_group` -, or YK_NONE.
static int32_t find_partner(const YkSketch *sketch, const PointNames *names, int32_t point, bool leaves_group)
{
    const YkModel *model = sketch->model;
    int32_t body = model->points[point].body, other = yk_names_find(&names->first, model->points[point].name);
    for (int looks = 0; other != YK_NONE && looks < LOOKS; other = names->next[other], looks++) {
        int32_t with = model->points[other].body;
        if (with == body) continue;
        if (leaves_group ? sketch->group[with] != sketch->group[body] : !are_joined(sketch, body, with)) return other;
    }
    return YK_NONE;
}

// The joint that pins both points: "joints/B", "{pin: [rod, piston]}"; `at` where a joint has the point's name already.
static void suggest_pin(YkSketch *sketch, YkLack *lack, int32_t point, int32_t other)
{
    const YkModel *model = sketch->model;
    const YkPoint *one = &model->points[point], *two = &model->points[other];
    const char *a = model->bodies[two->body].name, *b = model->bodies[one->body].name, *name = one->name;
    bool is_taken = yk_names_find(&model->joint_names, name) != YK_NONE;
    if (is_taken) name = yk_sketch_words(sketch, "%s-%s", name, b);
    lack->point = (size_t)point;
    lack->other = (size_t)other;
    if (!name || yk_names_find(&model->joint_names, name) != YK_NONE) return;
    lack->path = yk_sketch_words(sketch, "joints/%s", name);
    lack->value = is_taken ? yk_sketch_words(sketch, "{pin: [%s, %s], at: %s}", a, b, one->name)
                           : yk_sketch_words(sketch, "{pin: [%s, %s]}", a, b);
    lack->mend = yk_sketch_words(sketch, "%q and %q both have a point %q: pin them, as in `joints: {%s: %s}`", a, b,
                                 one->name, name, lack->value ? lack->value : "");
}

static void find_group(YkSketch *sketch, const PointNames *names, int32_t first)
{
    const YkModel *model = sketch->model;
    YkLack *lack = yk_sketch_add(sketch, YK_LACK_CONNECTION);
    int32_t point = YK_NONE, other = YK_NONE;
    if (!lack) return;
    lack->freedom = 3;
    lack->body = (size_t)first;
    for (size_t b = (size_t)first; b < model->body_count; b++) {
        const YkBody *body = &model->bodies[b];
        if (sketch->group[b] != first || body->is_carriage) continue;
        lack->body_count++;
        for (int32_t p = body->first_point; other == YK_NONE && p < body->first_point + body->point_count; p++) {
            other = find_partner(sketch, names, p, true);
            point = p;
        }
    }
    const char *name = model->bodies[first].name;
    lack->text = lack->body_count == 1
                     ? yk_sketch_words(sketch, "%q is not connected to the ground by joints", name)
                     : yk_sketch_words(sketch, "%q and %z more bod%s joined to it are not connected to the ground",
                                       name, lack->body_count - 1, lack->body_count == 2 ? "y" : "ies");
    lack->mend = "join it to a body that is connected, by a pin, slide, pin-slot or weld";
    if (other != YK_NONE) suggest_pin(sketch, lack, point, other);
}

void yk_sketch_find_connections(YkSketch *sketch)
{
    const YkModel *model = sketch->model;
    PointNames names = {0};
    sketch->failed |= !find_groups(sketch) || !gather(model, &names);
    for (size_t j = own_joints(model); !sketch->failed && j < model->joint_count; j++)
        find_group(sketch, &names, model->joints[j].body[1]);
    yk_names_free(&names.first);
    free(names.next);
}

// --- open ends

static void use(bool *is_used, int32_t point)
{
    if (point != YK_NONE) is_used[point] = true;
}

// Marks the points that something of the machine uses, besides their place.
static void mark_used(const YkModel *model, bool *is_used)
{
    for (size_t j = 0; j < model->joint_count; j++)
        for (int k = 0; k < 2; k++) use(is_used, model->joints[j].point[k]);
    for (size_t k = 0; k < model->spring_count; k++)
        for (int side = 0; model->springs[k].coordinate == YK_NONE && side < 2; side++)
            use(is_used, model->springs[k].point[side]);
    for (size_t k = 0; k < model->force_count; k++) use(is_used, model->forces[k].point);
    for (size_t k = 0; k < model->cam_count; k++) use(is_used, model->cams[k].point);
}

static void find_end(YkSketch *sketch, const PointNames *names, int32_t point)
{
    const YkPoint *end = &sketch->model->points[point];
    const char *body = sketch->model->bodies[end->body].name;
    YkLack *lack = yk_sketch_add(sketch, YK_LACK_END);
    if (!lack) return;
    lack->is_optional = true;
    lack->body = (size_t)end->body;
    lack->point = (size_t)point;
    lack->text = yk_sketch_words(sketch, "the end %q of %q is open", end->name, body);
    lack->mend =
        yk_sketch_words(sketch, "pin another body there, as in `joints: {%s: {pin: [%s, BODY]}}`", end->name, body);
    int32_t other = find_partner(sketch, names, point, false);
    if (other != YK_NONE) suggest_pin(sketch, lack, point, other);
}

// Reports an end of a body only if the body has no mass and one joint holds it: with mass it is a pendulum.
void yk_sketch_find_ends(YkSketch *sketch)
{
    const YkModel *model = sketch->model;
    int32_t *joints = calloc(model->body_count, sizeof *joints);
    bool *is_used = calloc(model->point_count + 1, sizeof *is_used);
    PointNames names = {0};
    bool good = joints && is_used && gather(model, &names);
    for (size_t j = 0; good && j < yk_sketch_joint_count(sketch); j++)
        for (int k = 0; k < 2; k++) joints[model->joints[j].body[k]]++;
    if (good) mark_used(model, is_used);
    for (size_t p = 0; good && p < model->point_count; p++) {
        int32_t body = model->points[p].body;
        if (body > 0 && joints[body] == 1 && !is_used[p] && !model->bodies[body].has_mass)
            find_end(sketch, &names, (int32_t)p);
    }
    sketch->failed |= !good;
    yk_names_free(&names.first);
    free(names.next);
    free(joints);
    free(is_used);
}
