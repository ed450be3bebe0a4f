// Finds where a joint sits on each of its two bodies.
#include "base/names.h"
#include "model/load.h"

// Warns if a wheel that is held at its origin has a point elsewhere with nearly the joint's name.
static void warn_of_slip(YkLoader *loader, const YkJoint *joint, int32_t wheel, const char *name, YkPlace place)
{
    const YkBody *body = &loader->model->bodies[wheel];
    for (int32_t k = 0; k < body->point_count; k++) {
        const YkPoint *point = &loader->model->points[body->first_point + k];
        const char *own = point->name;
        if ((point->at.x == 0 && point->at.y == 0) || !yk_nearest(name, &own, 1)) continue;
        yk_problem(loader->problems, YK_CODE_WHEEL_POINT, place,
                   "%s %q holds %q at its origin: the body has no point %q, but one called %q",
                   yk_part(joint->kind)->key, joint->name, body->name, name, own);
        yk_problem_hint(loader->problems, "if the origin is meant, add `%s: [0, 0]` to its points", name);
        return;
    }
}

// Places a pin or weld: one point known to both bodies, by the name in `at:` or by the joint's own name. If neither
// body has it: both origins.
static void share_point(YkLoader *loader, YkJoint *joint, const YkNode *at)
{
    const YkModel *model = loader->model;
    const char *name = at ? at->text : joint->name;
    for (int k = 0; k < 2; k++) joint->point[k] = yk_load_find_point(loader, joint->body[k], name);
    if (joint->point[0] != YK_NONE && joint->point[1] != YK_NONE) return;
    for (int k = 0; k < 2; k++) { // a wheel's centre needs no name: it is the wheel's origin
        if (joint->point[k] == YK_NONE && joint->point[1 - k] != YK_NONE && loader->is_wheel &&
            loader->is_wheel[joint->body[k]]) {
            warn_of_slip(loader, joint, joint->body[k], name, at ? at->place : joint->place);
            return;
        }
    }
    const char *kind = yk_part(joint->kind)->key;
    const char *a = model->bodies[joint->body[0]].name, *b = model->bodies[joint->body[1]].name;
    YkPlace place = at ? at->place : joint->place;
    if (joint->point[0] == joint->point[1]) {
        if (!at) return;
        yk_problem(loader->problems, YK_CODE_POINT_ON_NEITHER, place, "%s %q: neither %q nor %q has a point %q", kind,
                   joint->name, a, b, name);
        const YkBody *body = &model->bodies[joint->body[1]];
        const YkPoint *first = body->point_count ? model->points + body->first_point : NULL;
        yk_load_hint_nearest(loader->problems, name, first, (size_t)body->point_count, sizeof *first);
    } else {
        bool is_on_a = joint->point[0] != YK_NONE;
        const char *with = is_on_a ? a : b, *without = is_on_a ? b : a;
        yk_problem(loader->problems, YK_CODE_POINT_ON_ONE_BODY, place, "%s %q: %q has the point %q, but %q has not",
                   kind, joint->name, with, name, without);
        yk_problem_hint(loader->problems, "add `%s: [0, 0]` to the points of `%s`, in its own axes", name, without);
    }
}

static int32_t named_point(YkLoader *loader, int32_t body, const YkNode *name)
{
    return name ? yk_load_point(loader, body, name) : YK_NONE;
}

void yk_load_joint_points(YkLoader *loader, YkJoint *joint, const YkNode *node)
{
    const YkNode *at = yk_node_get(node, "at"), *from = yk_node_get(node, "from"), *to = yk_node_get(node, "to");
    switch (joint->kind) {
    case YK_PIN:
    case YK_WELD:
        if (at && !yk_load_expect(loader, at, YK_NODE_SCALAR, &(YkSubject){.noun = "at", .owner = joint->name})) {
            yk_problem_hint(loader->problems, "`at:` is the name of a point, which both bodies give in their own axes");
            return;
        }
        share_point(loader, joint, at);
        break;
    case YK_SLIDE:
        joint->point[0] = named_point(loader, joint->body[0], from);
        joint->point[1] = named_point(loader, joint->body[1], to);
        break;
    case YK_PIN_SLOT:
        joint->point[0] = named_point(loader, joint->body[0], from);
        joint->point[1] =
            at ? yk_load_point(loader, joint->body[1], at) : yk_load_find_point(loader, joint->body[1], joint->name);
        break;
    default:
        break;
    }
}

void yk_load_finish_joints(YkLoader *loader)
{
    YkModel *model = loader->model;
    for (size_t i = 0; i < model->joint_count; i++) {
        YkJoint *joint = &model->joints[i];
        for (int k = 0; k < 2; k++) {
            joint->at[k] = joint->point[k] == YK_NONE ? yk_vec(0, 0) : model->points[joint->point[k]].at;
        }
        if (joint->along_expr) joint->along = yk_unit(joint->along_angle);
    }
}
