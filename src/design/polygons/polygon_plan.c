// Plans velocity and acceleration polygons: body after body, beginning with those whose motion is known.
#include "design/polygons/polygon_plan.h"
#include <ctype.h>
#include <string.h>

typedef struct Walk {
    YkPolygonPlan *plan;
    YkArena *arena;
    const YkMechanism *mech;
    const YkModel *model;
    bool *is_known;  // [body]
    int *block_of;   // [body], or -1
    bool *is_placed; // [block]
    bool *was_known; // [body]
    bool *is_base;   // [joint]
    size_t *key;     // [image]: the joint or point that it shows
    bool failed;     // out of memory
} Walk;

static bool slides(const Walk *w, size_t joint)
{
    return w->mech->joint_distance[joint] != YK_NONE;
}

// --- places

// A place that is fixed in a body, in its axes. Returns false for a place under what slides, which is not.
static bool fixed_place(const Walk *w, size_t body, size_t joint, YkVec *at)
{
    const YkJoint *j = &w->model->joints[joint];
    size_t side = (size_t)j->body[1] == body;
    *at = j->at[side];
    return side == 1 || !slides(w, joint);
}

static bool is_same(const Walk *w, YkVec a, YkVec b)
{
    return yk_norm(yk_sub(a, b)) <= 1e-12 * w->mech->size;
}

static bool are_one(const Walk *w, size_t body, size_t one, size_t other)
{
    YkVec a, b;
    return fixed_place(w, body, one, &a) && fixed_place(w, body, other, &b) && is_same(w, a, b);
}

static bool touches(const Walk *w, size_t joint, size_t body)
{
    const YkJoint *j = &w->model->joints[joint];
    return (size_t)j->body[0] == body || (size_t)j->body[1] == body;
}

// The pin that holds the second body of a slide where it slides, or YK_NOT_FOUND. A pin to the ground does not count.
static size_t pin_at(const Walk *w, size_t slide)
{
    size_t body = (size_t)w->model->joints[slide].body[1];
    for (size_t k = 0; k < w->model->shown_joints; k++) {
        const YkJoint *j = &w->model->joints[k];
        bool is_free = j->body[0] != 0 && j->body[1] != 0;
        if (is_free && touches(w, k, body) && !slides(w, k) && are_one(w, body, slide, k)) return k;
    }
    return YK_NOT_FOUND;
}

// --- images

static const char *lower(Walk *w, const char *head, const char *tail)
{
    size_t length = strlen(head), more = strlen(tail);
    char *name = YK_NEW(w->arena, char, length + more + 1);
    if (!name) {
        w->failed = true;
        return "";
    }
    for (size_t k = 0; k < length; k++) name[k] = (char)tolower((unsigned char)head[k]);
    memcpy(name + length, tail, more + 1);
    return name;
}

static bool is_taken(const YkPolygonPlan *p, const char *name)
{
    for (size_t k = 0; k < p->image_count; k++)
        if (strcmp(p->image[k].image, name) == 0) return true;
    return false;
}

// Names the image of an end, which is added unless it is there. key: the joint or point that it shows. A name that
// another image has gets one more dash.
static YkPolygonEnd add_image(Walk *w, size_t key, const char *head, const char *tail, YkPolygonEnd end)
{
    YkPolygonPlan *p = w->plan;
    for (size_t k = 0; k < p->image_count; k++) {
        if (w->key[k] != key) continue;
        end.image = p->image[k].image;
        return end;
    }
    end.image = lower(w, head, tail);
    while (!w->failed && is_taken(p, end.image)) end.image = lower(w, end.image, "'");
    w->key[p->image_count] = key;
    p->image[p->image_count++] = end;
    return end;
}

// A joint on one of its bodies: a' is the image of the place under a sliding point A, o that of a pin of the ground. A
// point that slides where a pin holds it as well has the pin's image.
static YkPolygonEnd joint_end(Walk *w, size_t joint, size_t body)
{
    const YkJoint *j = &w->model->joints[joint];
    YkPolygonEnd end = {body, joint, YK_NOT_FOUND, "o"};
    size_t pin = slides(w, joint) ? pin_at(w, joint) : YK_NOT_FOUND;
    bool is_under = slides(w, joint) && (size_t)j->body[0] == body;
    bool is_still = body == 0 || (!slides(w, joint) && (j->body[0] == 0 || j->body[1] == 0));
    if (is_still) return end;
    if (pin == YK_NOT_FOUND) pin = joint;
    return is_under ? add_image(w, 2 * joint + 1, w->model->joints[pin].name, "'", end)
                    : add_image(w, 2 * pin, w->model->joints[pin].name, "", end);
}

static YkPolygonEnd point_end(Walk *w, size_t body, size_t point)
{
    YkText whole = {0};
    YkPolygonEnd end = {body, YK_NOT_FOUND, point, NULL};
    yk_text_format(&whole, "%s.%s", w->model->bodies[body].name, w->model->points[point].name);
    w->failed |= whole.failed;
    end = add_image(w, 2 * w->model->joint_count + point, yk_text_get(&whole), "", end);
    yk_text_free(&whole);
    return end;
}

// --- links

static void turn(Walk *w, size_t body, YkPolygonEnd from, YkPolygonEnd to)
{
    if (body > 0) w->plan->link[w->plan->link_count++] = (YkPolygonLink){body, YK_NOT_FOUND, from, to};
}

// From the image of a joint on one body to that on the other one.
static void slide(Walk *w, size_t joint, size_t from, size_t to)
{
    if (!slides(w, joint)) return;
    YkPolygonLink link = {(size_t)w->model->joints[joint].body[0], joint, joint_end(w, joint, from), {0}};
    link.to = joint_end(w, joint, to);
    w->plan->link[w->plan->link_count++] = link;
}

static bool is_at_joint(const Walk *w, size_t body, YkVec at)
{
    YkVec place;
    for (size_t k = 0; k < w->model->shown_joints; k++)
        if (touches(w, k, body) && fixed_place(w, body, k, &place) && is_same(w, place, at)) return true;
    return false;
}

// From a body's base to its other joints and points.
static void reach_points(Walk *w, size_t body, size_t base)
{
    const YkBody *b = &w->model->bodies[body];
    YkPolygonEnd from = joint_end(w, base, body);
    for (size_t k = 0; k < w->model->shown_joints; k++)
        if (k != base && touches(w, k, body) && !are_one(w, body, base, k)) turn(w, body, from, joint_end(w, k, body));
    for (int32_t k = 0; k < b->point_count; k++) {
        size_t point = (size_t)(b->first_point + k);
        if (!is_at_joint(w, body, w->model->points[point].at)) turn(w, body, from, point_end(w, body, point));
    }
}

// --- steps

// The other body of a joint if it has this one and the other is known; otherwise YK_NOT_FOUND.
static size_t known_beyond(const Walk *w, const YkJoint *joint, size_t body)
{
    size_t other = (size_t)joint->body[0] == body   ? (size_t)joint->body[1]
                   : (size_t)joint->body[1] == body ? (size_t)joint->body[0]
                                                    : YK_NOT_FOUND;
    return other != YK_NOT_FOUND && other != body && w->is_known[other] ? other : YK_NOT_FOUND;
}

// Returns the joint that connects a body to known ones, or YK_NOT_FOUND.
static size_t base_of(const Walk *w, size_t body)
{
    for (size_t k = 0; k < w->model->shown_joints; k++)
        if (known_beyond(w, &w->model->joints[k], body) != YK_NOT_FOUND) return k;
    return YK_NOT_FOUND;
}

static void end_step(Walk *w, const size_t *bodies, size_t count, size_t first, int block)
{
    YkPolygonPlan *p = w->plan;
    p->step[p->step_count++] = (YkPolygonStep){bodies, count, first, p->link_count - first, block};
}

// A body that no block places: driven, welded, or turned by gears and the like.
static bool take_body(Walk *w)
{
    for (size_t b = 1; b < w->model->body_count; b++) {
        size_t base = w->is_known[b] || w->block_of[b] >= 0 ? YK_NOT_FOUND : base_of(w, b);
        size_t *body = base == YK_NOT_FOUND ? NULL : YK_NEW(w->arena, size_t, 1), first = w->plan->link_count;
        if (!body) continue;
        slide(w, base, known_beyond(w, &w->model->joints[base], b), b);
        reach_points(w, b, base);
        w->is_known[b] = true;
        *body = b;
        end_step(w, body, 1, first, -1);
        return true;
    }
    return false;
}

// Returns the next of a block's bodies that a joint connects to known ones; their bases outside the block come first.
static bool take_member(Walk *w, size_t block, bool outside)
{
    for (size_t k = 0; k < yk_block_info(w->mech, block).body_count; k++) {
        size_t b = yk_block_body(w->mech, block, k);
        for (size_t j = 0; j < w->model->shown_joints && !w->is_known[b]; j++) {
            size_t other = known_beyond(w, &w->model->joints[j], b);
            if (other == YK_NOT_FOUND || (outside && !w->was_known[other])) continue;
            slide(w, j, other, b);
            reach_points(w, b, j);
            w->is_known[b] = w->is_base[j] = true;
            return true;
        }
    }
    return false;
}

// The slides of a block on which none of its bodies was placed close the polygon.
static void close_slides(Walk *w, size_t block)
{
    for (size_t k = 0; k < yk_block_info(w->mech, block).joint_count; k++) {
        size_t j = yk_block_joint(w->mech, block, k);
        const YkJoint *joint = &w->model->joints[j];
        bool is_open = w->is_known[joint->body[0]] && w->is_known[joint->body[1]] && !w->is_base[j];
        if (is_open && j < w->model->shown_joints) slide(w, j, (size_t)joint->body[0], (size_t)joint->body[1]);
    }
}

static bool take_block(Walk *w)
{
    for (size_t block = 0; block < w->mech->block_count; block++) {
        size_t bodies = yk_block_info(w->mech, block).body_count, first = w->plan->link_count, count = 0;
        if (w->is_placed[block] || bodies == 0) continue;
        memcpy(w->was_known, w->is_known, w->model->body_count * sizeof *w->was_known);
        while (take_member(w, block, true)) count++;
        if (count == 0) continue;
        while (take_member(w, block, false)) count++;
        close_slides(w, block);
        size_t *body = YK_NEW(w->arena, size_t, bodies);
        for (size_t k = 0; body && k < bodies; k++) body[k] = yk_block_body(w->mech, block, k);
        w->is_placed[block] = true;
        end_step(w, body, body ? bodies : 0, first, (int)block);
        return true;
    }
    return false;
}

// --- making

static bool allocate(Walk *w)
{
    YkPolygonPlan *p = w->plan;
    size_t bodies = w->model->body_count, joints = w->model->joint_count;
    size_t capacity = 6 * joints + 2 * w->model->point_count + 8;
    w->is_known = YK_NEW(w->arena, bool, bodies);
    w->was_known = YK_NEW(w->arena, bool, bodies);
    w->block_of = YK_NEW(w->arena, int, bodies);
    w->is_placed = YK_NEW(w->arena, bool, w->mech->block_count + 1);
    w->is_base = YK_NEW(w->arena, bool, joints + 1);
    w->key = YK_NEW(w->arena, size_t, capacity);
    p->link = YK_NEW(w->arena, YkPolygonLink, capacity);
    p->image = YK_NEW(w->arena, YkPolygonEnd, capacity);
    p->step = YK_NEW(w->arena, YkPolygonStep, bodies + 1);
    return !yk_arena_failed(w->arena);
}

static void prepare(Walk *w)
{
    for (size_t b = 0; b < w->model->body_count; b++) w->block_of[b] = -1;
    for (size_t k = 0; k < w->mech->block_count; k++)
        for (size_t i = 0; i < yk_block_info(w->mech, k).body_count; i++)
            w->block_of[yk_block_body(w->mech, k, i)] = (int)k;
    w->is_known[0] = true;
    w->key[0] = YK_NOT_FOUND;
    w->plan->image[w->plan->image_count++] = (YkPolygonEnd){0, YK_NOT_FOUND, YK_NOT_FOUND, "o"};
}

const YkPolygonPlan *yk_polygon_plan(const YkMechanism *mech, YkArena *arena)
{
    Walk w = {.plan = YK_NEW(arena, YkPolygonPlan, 1), .arena = arena, .mech = mech, .model = mech->model};
    if (!w.plan || !allocate(&w)) return NULL;
    w.plan->mech = mech;
    prepare(&w);
    while (!w.failed && !yk_arena_failed(arena) && (take_body(&w) || take_block(&w))) {}
    return w.failed || yk_arena_failed(arena) ? NULL : w.plan;
}

const char *yk_polygon_why_not(const YkModel *model)
{
    for (size_t j = 0; j < model->joint_count; j++)
        if (model->joints[j].is_free) return "the machine has `free` joints, which nothing constructs";
    return NULL;
}
