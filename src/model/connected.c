// Checks that a chain of joints holds every body to the ground.
#include <string.h>
#include "base/sets.h"
#include "model/load.h"

enum { NAMES_SHOWN = 8 };

typedef struct Groups {
    int32_t *parent;      // sets of connected bodies; the first in the file stands for each
    int32_t *next, *last; // bodies of one group in file order, which begin with its root
} Groups;

static void link_members(Groups *groups, int32_t count)
{
    for (int32_t i = 0; i < count; i++) groups->last[i] = groups->next[i] = YK_NONE;
    for (int32_t i = 0; i < count; i++) {
        int32_t group = yk_root_of(groups->parent, i), last = groups->last[group];
        if (last != YK_NONE) groups->next[last] = i;
        groups->last[group] = i;
    }
}

static void report(YkLoader *loader, const Groups *groups, int32_t group)
{
    const YkBody *bodies = loader->model->bodies;
    YkText *text = &loader->text;
    int32_t shown = 0, total = 0; // without the carriages of free joints, which come last
    yk_text_clear(text);
    for (int32_t i = group; i != YK_NONE; i = groups->next[i]) total += !bodies[i].is_carriage;
    for (int32_t i = group; shown < total && shown < NAMES_SHOWN; i = groups->next[i]) {
        const char *joiner = shown == 0 ? "" : shown + 1 == total ? " and " : ", ";
        yk_text_format(text, "%s%q", joiner, bodies[i].name);
        shown++;
    }
    if (shown < total) yk_text_format(text, " and %d more", (int)(total - shown));
    yk_problem(loader->problems, YK_CODE_NOT_CONNECTED, bodies[group].place,
               "%s %s not connected to the ground by joints", yk_text_get(text), total == 1 ? "is" : "are");
}

// Returns a name, not yet a joint's, for the weld that holds a body.
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
                     .next = YK_NEW(loader->arena, int32_t, count),
                     .last = YK_NEW(loader->arena, int32_t, count)};
    if (yk_arena_failed(loader->arena) || loader->has_bad_joint) return;
    yk_sets_begin(groups.parent, count);
    for (size_t i = 0; i < model->joint_count; i++)
        yk_sets_join(groups.parent, model->joints[i].body[0], model->joints[i].body[1]);
    link_members(&groups, (int32_t)count);
    for (int32_t i = 1; i < (int32_t)count; i++) {
        if (groups.parent[i] != i) continue;
        if (loader->is_sketch)
            hold(loader, i);
        else
            report(loader, &groups, i);
    }
}
