// Checks that a chain of joints holds every body to the ground. Groups by union-find (Tarjan 1975); near-linear.
#include <string.h>
#include "model/load.h"

enum { NAMES_SHOWN = 8 };

typedef struct Groups {
    int32_t *parent; // towards the group's representative
    int32_t *size;
    int32_t *next; // bodies of one group in file order; the list starts at the representative's `first`
    int32_t *first, *last;
} Groups;

static int32_t find(const Groups *groups, int32_t body)
{
    while (groups->parent[body] != body) {
        groups->parent[body] = groups->parent[groups->parent[body]];
        body = groups->parent[body];
    }
    return body;
}

static void unite(Groups *groups, int32_t a, int32_t b)
{
    a = find(groups, a);
    b = find(groups, b);
    if (a == b) return;
    int32_t large = groups->size[a] >= groups->size[b] ? a : b, small = large == a ? b : a;
    groups->parent[small] = large;
    groups->size[large] += groups->size[small];
}

static void link_members(Groups *groups, int32_t count)
{
    for (int32_t i = 0; i < count; i++) groups->first[i] = groups->last[i] = groups->next[i] = YK_NONE;
    for (int32_t i = 0; i < count; i++) {
        int32_t group = find(groups, i), last = groups->last[group];
        if (last == YK_NONE)
            groups->first[group] = i;
        else
            groups->next[last] = i;
        groups->last[group] = i;
    }
}

static void report(YkLoader *loader, const Groups *groups, int32_t group)
{
    const YkBody *bodies = loader->model->bodies;
    YkText *text = &loader->text;
    int32_t shown = 0, total = 0; // without the carriages of free joints, which come last
    yk_text_clear(text);
    for (int32_t i = groups->first[group]; i != YK_NONE; i = groups->next[i]) total += !bodies[i].is_carriage;
    for (int32_t i = groups->first[group]; shown < total && shown < NAMES_SHOWN; i = groups->next[i]) {
        const char *joiner = shown == 0 ? "" : shown + 1 == total ? " and " : ", ";
        yk_text_format(text, "%s%q", joiner, bodies[i].name);
        shown++;
    }
    if (shown < total) yk_text_format(text, " and %d more", (int)(total - shown));
    yk_problem(loader->problems, YK_CODE_NOT_CONNECTED, bodies[groups->first[group]].place,
               "%s %s not connected to the ground by joints", yk_text_get(text), total == 1 ? "is" : "are");
}

// A name for what holds a body that is no joint's yet.
static const char *free_name(YkLoader *loader, const char *body)
{
    YkText *text = &loader->text;
    yk_text_clear(text);
    yk_text_format(text, "hold-%s", body);
    while (!text->failed && yk_names_find(&loader->model->joint_names, yk_text_get(text)) != YK_NONE)
        yk_text_puts(text, "-");
    return yk_arena_copy(loader->arena, yk_text_get(text), text->length);
}

// Welds a group to the ground by its first body, axes on axes, so that a sketch can be compiled and drawn.
static void hold(YkLoader *loader, int32_t body)
{
    YkModel *model = loader->model;
    size_t count = model->joint_count;
    YkJoint *joints =
        model->held_joints ? model->joints : YK_NEW(loader->arena, YkJoint, count + model->body_count); // room for all
    const char *name = free_name(loader, model->bodies[body].name);
    int32_t existing;
    if (!joints || !name) return;
    if (count > 0 && joints != model->joints) memcpy(joints, model->joints, count * sizeof *joints);
    joints[count] = (YkJoint){.name = name,
                              .place = model->bodies[body].place,
                              .kind = YK_WELD,
                              .body = {0, body},
                              .point = {YK_NONE, YK_NONE},
                              .along = {1, 0},
                              .angle = YK_NONE,
                              .distance = YK_NONE};
    loader->failed |= !yk_names_add(&model->joint_names, name, (int32_t)count, &existing);
    model->joints = joints;
    model->joint_count++;
    model->held_joints++;
}

void yk_load_check_connected(YkLoader *loader)
{
    const YkModel *model = loader->model;
    size_t count = model->body_count;
    Groups groups = {.parent = YK_NEW(loader->arena, int32_t, count),
                     .size = YK_NEW(loader->arena, int32_t, count),
                     .next = YK_NEW(loader->arena, int32_t, count),
                     .first = YK_NEW(loader->arena, int32_t, count),
                     .last = YK_NEW(loader->arena, int32_t, count)};
    if (yk_arena_failed(loader->arena) || loader->has_bad_joint) return;
    for (size_t i = 0; i < count; i++) {
        groups.parent[i] = (int32_t)i;
        groups.size[i] = 1;
    }
    for (size_t i = 0; i < model->joint_count; i++) unite(&groups, model->joints[i].body[0], model->joints[i].body[1]);
    link_members(&groups, (int32_t)count);
    int32_t ground = find(&groups, 0);
    for (size_t i = 1; i < count; i++) {
        int32_t group = find(&groups, (int32_t)i);
        if (group != ground && groups.first[group] == (int32_t)i) {
            if (loader->is_sketch)
                hold(loader, (int32_t)i);
            else
                report(loader, &groups, group);
        }
    }
}
