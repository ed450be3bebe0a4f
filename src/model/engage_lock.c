// Engages one of the `locks:`. A drive that stands still holds the freedom of a joint; bodies that no joint ties are
// held by a tie between their turns, like equal pulleys on the ground. Everything that handles drives and belts then
// handles locks too, and the effort of the drive is the holding effort.
#include <string.h>
#include "base/text.h"
#include "model/load.h"

bool yk_model_find_lock(const YkModel *model, const char *name, const YkLock **lock, YkProblems *problems)
{
    *lock = NULL;
    for (size_t i = 0; i < model->lock_count; i++)
        if (strcmp(model->locks[i].name, name) == 0) *lock = &model->locks[i];
    if (*lock) return true;
    yk_problem(problems, YK_CODE_UNKNOWN_LOCK, (YkPlace){0}, "the model has no lock %q", name);
    YkText text = {0};
    for (size_t i = 0; i < model->lock_count && i < 20; i++)
        yk_text_format(&text, "%s`%s`", i ? ", " : "", model->locks[i].name);
    if (yk_text_has_some(&text)) yk_problem_hint(problems, "it has %s", yk_text_get(&text));
    yk_text_free(&text);
    return false;
}

typedef struct Engaging {
    YkLoader *loader;
    const YkLock *lock;
    YkExpr *zero, *one;
} Engaging;

// Holds a coordinate where `start:` places it, or at 0.
static void hold_coordinate(const Engaging *e, int32_t coordinate)
{
    YkModel *model = e->loader->model;
    YkCoordinate *c = &model->coordinates[coordinate];
    const YkStart *start = yk_start_of(model, coordinate);
    bool is_followed = false, has_loops = model->joint_count + 1 > model->body_count;
    for (size_t k = 0; k < model->follow_count; k++) is_followed |= model->follows[k].coordinate == coordinate;
    if (c->drive != YK_NONE && model->drives[c->drive].is_hold) return; // held already
    if (c->drive != YK_NONE || is_followed) {
        yk_problem(e->loader->problems, YK_CODE_BAD_LOCK, e->lock->place, "lock %q holds %q, which is driven",
                   e->lock->name, c->name);
        return;
    }
    if (!start && has_loops) {
        yk_problem(e->loader->problems, YK_CODE_BAD_LOCK, e->lock->place,
                   "lock %q holds %q, but nothing says where; its place may depend on the loops", e->lock->name,
                   c->name);
        yk_problem_hint(e->loader->problems, "give `%s` a value under `start:`", c->name);
        return;
    }
    c->drive = (int32_t)model->drive_count;
    model->drives[model->drive_count++] = (YkDrive){.coordinate = coordinate,
                                                    .place = e->lock->place,
                                                    .expr = start ? start->expr : e->zero,
                                                    .law = YK_NONE,
                                                    .is_hold = true};
}

// Makes the bodies turn as one.
static void tie_turns(const Engaging *e, int32_t a, int32_t b)
{
    YkModel *model = e->loader->model;
    YkBelt *tie = &model->belts[model->belt_count++];
    *tie = (YkBelt){.name = e->lock->name, .place = e->lock->place, .body = {a, b}, .is_lock = true};
    for (int k = 0; k < 2; k++) {
        tie->radius[k] = 1;
        tie->exact_radius[k] = (YkExact){true, 1, 1, 0};
        tie->radius_expr[k] = e->one;
    }
}

// Holds what the joints between two bodies leave free: their coordinates, named or not. Returns false if there is no
// joint.
static bool hold_joints(const Engaging *e, int32_t a, int32_t b)
{
    YkModel *model = e->loader->model;
    bool any = false, turns_unnamed = false;
    for (size_t k = 0; k < model->joint_count; k++) {
        const YkJoint *joint = &model->joints[k], *first = joint, *second = joint; // two halves of a free joint
        if (joint->is_free) *(joint->kind == YK_SLIDE ? &second : &first) = &model->joints[joint->partner];
        int32_t from = first->body[0], to = second->body[1];
        bool is_between = (from == a && to == b) || (from == b && to == a);
        if (!is_between) continue;
        any = true;
        if (joint->angle != YK_NONE) hold_coordinate(e, joint->angle);
        if (joint->distance != YK_NONE) hold_coordinate(e, joint->distance);
        turns_unnamed |= yk_part(joint->kind)->turns && joint->angle == YK_NONE;
        if (yk_part(joint->kind)->slides && joint->distance == YK_NONE) {
            yk_problem(e->loader->problems, YK_CODE_BAD_LOCK, e->lock->place,
                       "lock %q holds what slides in joint %q; that distance has no name", e->lock->name, joint->name);
            yk_problem_hint(e->loader->problems, "name it at the joint by `distance:`");
        }
    }
    if (turns_unnamed) tie_turns(e, a, b);
    return any;
}

static YkExpr *number(YkLoader *loader, const char *text)
{
    YkExpr *expr = yk_expr_parse(text, strlen(text), (YkPlace){0}, loader->arena, NULL);
    if (expr) expr->value_scale = 1;
    return expr;
}

// Makes room for everything that the lock may add: a drive for each coordinate, a tie for each entry.
static bool make_room(YkLoader *loader, const YkLock *lock)
{
    YkModel *model = loader->model;
    size_t ties = lock->hold_count + lock->join_count;
    YkDrive *drives = YK_NEW(loader->arena, YkDrive, model->drive_count + model->coordinate_count + 1);
    YkBelt *belts = YK_NEW(loader->arena, YkBelt, model->belt_count + ties + 1);
    if (!drives || !belts) return false;
    if (model->drive_count) memcpy(drives, model->drives, model->drive_count * sizeof *drives);
    if (model->belt_count) memcpy(belts, model->belts, model->belt_count * sizeof *belts);
    model->drives = drives;
    model->belts = belts;
    return true;
}

void yk_load_engage(YkLoader *loader)
{
    YkModel *model = loader->model;
    Engaging e = {.loader = loader};
    if (!loader->options || !loader->options->lock) return;
    if (!yk_model_find_lock(model, loader->options->lock, &e.lock, loader->problems)) return;
    e.zero = number(loader, "0");
    e.one = number(loader, "1");
    if (!e.zero || !e.one || !make_room(loader, e.lock)) {
        loader->failed = true;
        return;
    }
    model->engaged = e.lock->name;
    for (size_t k = 0; k < e.lock->hold_count; k++) {
        const YkHold *hold = &e.lock->holds[k];
        if (hold->body == YK_NONE)
            hold_coordinate(&e, hold->coordinate);
        else if (!hold_joints(&e, 0, hold->body))
            tie_turns(&e, hold->body, 0);
    }
    for (size_t k = 0; k < e.lock->join_count; k++)
        if (!hold_joints(&e, e.lock->joins[k][0], e.lock->joins[k][1]))
            tie_turns(&e, e.lock->joins[k][0], e.lock->joins[k][1]);
}
