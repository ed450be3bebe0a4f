// Warns of a link without length: a body held by exactly two pins at the same place. This is almost always a slip.
#include <math.h>
#include "elementary/elementary.h"
#include "model/load.h"

static bool coincide(YkVec a, YkVec b)
{
    YkVec apart = yk_sub(a, b);
    return yk_hypot(apart.x, apart.y) <= 1e-12 * fmax(yk_hypot(a.x, a.y), yk_hypot(b.x, b.y));
}

static const char *point_name(const YkModel *model, const YkJoint *joint, int end)
{
    return joint->point[end] == YK_NONE ? NULL : model->points[joint->point[end]].name;
}

// Says which points coincide; NULL stands for the body's origin.
static void tell(YkLoader *loader, const YkBody *body, const char *a, const char *b)
{
    if (a && b)
        yk_problem(loader->problems, YK_CODE_COINCIDENT_PINS, body->place,
                   "%q is a link without length: its points %q and %q coincide", body->name, a, b);
    else if (a || b)
        yk_problem(loader->problems, YK_CODE_COINCIDENT_PINS, body->place,
                   "%q is a link without length: its point %q lies at its origin, as its other pin does", body->name,
                   a ? a : b);
    else
        yk_problem(loader->problems, YK_CODE_COINCIDENT_PINS, body->place,
                   "%q is a link without length: both its pins lie at its origin", body->name);
    if (!a || !b)
        yk_problem_hint(loader->problems,
                        "a pin without a point lies at the origin; name one of them in the points of %q", body->name);
}

// The last two joints at each body, as joint * 2 + end, and their number.
typedef struct Holds {
    int32_t count, hold[2];
} Holds;

static void check_body(YkLoader *loader, const YkBody *body, const Holds *holds)
{
    const YkModel *model = loader->model;
    const YkJoint *a = &model->joints[holds->hold[0] / 2], *b = &model->joints[holds->hold[1] / 2];
    int end_a = holds->hold[0] % 2, end_b = holds->hold[1] % 2;
    if (a->kind != YK_PIN || b->kind != YK_PIN || !coincide(a->at[end_a], b->at[end_b])) return;
    tell(loader, body, point_name(model, a, end_a), point_name(model, b, end_b));
}

void yk_load_check_links(YkLoader *loader)
{
    const YkModel *model = loader->model;
    Holds *holds = YK_NEW(loader->arena, Holds, model->body_count);
    if (!holds || !loader->is_wheel) return;
    for (size_t i = 0; i < model->joint_count; i++) {
        for (int end = 0; end < 2; end++) {
            int32_t body = model->joints[i].body[end];
            if (body == YK_NONE) continue;
            Holds *at = &holds[body];
            if (model->joints[i].body[1 - end] == YK_NONE) at->count += 2; // in error: its points are not judged
            if (at->count < 2) at->hold[at->count] = (int32_t)i * 2 + end;
            at->count++;
        }
    }
    for (size_t i = 1; i < model->body_count; i++) {
        if (holds[i].count == 2 && !loader->is_wheel[i]) check_body(loader, &model->bodies[i], &holds[i]);
    }
}
