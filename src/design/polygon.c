// Constructs velocity and acceleration polygons: body after body, from what is known.
#include "design/polygon.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include "base/problems.h"
#include "compile/mechanism.h"
#include "loads/loads.h"
#include "solve/state.h"

typedef struct Walk {
    YkPolygon *p;
    const YkMechanism *mech;
    const YkModel *model;
    YkBodyMotion *motion; // [body]
    bool *is_known;       // [body]
    int *block_of;        // [body], or -1
    bool *is_placed;      // [block]
    double *rate;         // [body]: of what is drawn
    size_t *bodies;       // of a step
    size_t *key;          // [image]: of which joint or point
} Walk;

// --- motions

// The velocity or acceleration of the place of a body that is at a world point now.
static YkVec image_of(const Walk *w, size_t body, YkVec at)
{
    const YkBodyMotion *m = &w->motion[body];
    YkVec arm = yk_sub(at, m->at), across = yk_quarter(arm);
    if (w->p->kind == YK_POLYGON_VELOCITY) return yk_add(m->velocity, yk_scale(m->w, across));
    return yk_add(m->acceleration, yk_sub(yk_scale(m->a, across), yk_scale(m->w * m->w, arm)));
}

static YkVec place_of(const Walk *w, size_t body, YkVec at)
{
    const YkBodyMotion *m = &w->motion[body];
    return yk_add(m->at, yk_mul(m->e, yk_sub(at, yk_reference_point(w->model, body))));
}

// Where a joint is: its point on the second body, which slides along the line of the first where it slides.
static YkVec joint_at(const Walk *w, const YkJoint *joint)
{
    return place_of(w, (size_t)joint->body[1], joint->at[1]);
}

static bool slides(const Walk *w, size_t joint)
{
    return w->mech->joint_distance[joint] != YK_NONE;
}

// --- images

static const char *lower(YkPolygon *p, const char *head, const char *tail)
{
    size_t length = strlen(head), more = strlen(tail);
    char *name = YK_NEW(p->arena, char, length + more + 1);
    if (!name) {
        p->failed = true;
        return "";
    }
    for (size_t k = 0; k < length; k++) name[k] = (char)tolower((unsigned char)head[k]);
    memcpy(name + length, tail, more + 1);
    return name;
}

static bool is_taken(const YkPolygon *p, const char *name)
{
    for (size_t k = 0; k < p->image_count; k++)
        if (strcmp(p->image[k].name, name) == 0) return true;
    return false;
}

// Returns the name of an image, which is added unless it is there. key: what it is the image of. A name that another
// image has gets one more dash.
static const char *add_image(Walk *w, size_t key, const char *head, const char *tail, size_t body, YkVec at)
{
    YkPolygon *p = w->p;
    for (size_t k = 0; k < p->image_count; k++)
        if (w->key[k] == key) return p->image[k].name;
    const char *name = lower(p, head, tail);
    while (!p->failed && is_taken(p, name)) name = lower(p, name, "'");
    YkVec value = image_of(w, body, at);
    w->key[p->image_count] = key;
    p->image[p->image_count++] = (YkPolygonImage){name, {at.x, at.y}, {value.x, value.y}};
    return name;
}

// The image of a joint on one of its bodies: a' for the place under a sliding point A, o for a pin of the ground.
static const char *joint_image(Walk *w, size_t joint, size_t body)
{
    const YkJoint *j = &w->model->joints[joint];
    bool is_under = slides(w, joint) && (size_t)j->body[0] == body;
    bool is_still = body == 0 || (!slides(w, joint) && (j->body[0] == 0 || j->body[1] == 0));
    if (is_still) return "o";
    return add_image(w, 2 * joint + is_under, j->name, is_under ? "'" : "", body, joint_at(w, j));
}

// --- vectors

static void add_vector(Walk *w, YkPolygonVector v, YkVec start, YkVec value)
{
    YkPolygon *p = w->p;
    v.start[0] = start.x;
    v.start[1] = start.y;
    v.value[0] = value.x + 0.0; // no -0
    v.value[1] = value.y + 0.0;
    v.step = p->step_count;
    p->vector[p->vector_count++] = v;
}

// From a place of a body to another one of the same body.
static void turn(Walk *w, size_t body, YkVec from, YkVec to, const char *from_name, const char *to_name)
{
    const YkBodyMotion *m = &w->motion[body];
    YkVec arm = yk_sub(to, from), start = image_of(w, body, from);
    YkPolygonVector v = {YK_POLYGON_TURNING, body, YK_NOT_FOUND, 0, {0}, {0}, from_name, to_name};
    if (body == 0) return;
    if (w->p->kind == YK_POLYGON_VELOCITY) {
        add_vector(w, v, start, yk_scale(m->w, yk_quarter(arm)));
        return;
    }
    YkVec normal = yk_scale(-m->w * m->w, arm);
    v.part = YK_POLYGON_NORMAL;
    add_vector(w, v, start, normal);
    v.part = YK_POLYGON_TANGENTIAL;
    add_vector(w, v, yk_add(start, normal), yk_scale(m->a, yk_quarter(arm)));
}

// From the image of a joint on one body to that on the other one.
static void slide(Walk *w, size_t joint, size_t from, size_t to)
{
    const YkJoint *j = &w->model->joints[joint];
    size_t carrier = (size_t)j->body[0];
    YkVec at = joint_at(w, j), start = image_of(w, from, at), whole = yk_sub(image_of(w, to, at), start);
    YkVec line = yk_mul(w->motion[carrier].e, j->along);
    if (!slides(w, joint)) return;
    YkPolygonVector v = {YK_POLYGON_CORIOLIS, carrier, joint, 0, {0}, {0}, joint_image(w, joint, from), NULL};
    v.to = joint_image(w, joint, to);
    if (w->p->kind == YK_POLYGON_ACCELERATION && carrier != 0) {
        YkVec across = yk_scale(yk_dot(whole, yk_quarter(line)), yk_quarter(line));
        add_vector(w, v, start, across);
        start = yk_add(start, across);
    }
    v.part = YK_POLYGON_SLIDING;
    add_vector(w, v, start, yk_scale(yk_dot(whole, line), line));
}

static bool is_apart(const Walk *w, YkVec a, YkVec b)
{
    return yk_norm(yk_sub(a, b)) > 1e-12 * w->mech->size;
}

// From a body's base to its other joints and points. Joints to bodies of the same block come first.
static void reach_points(Walk *w, size_t body, size_t base)
{
    YkVec from = joint_at(w, &w->model->joints[base]);
    const char *name = joint_image(w, base, body);
    for (size_t k = 0; k < w->model->shown_joints; k++) {
        const YkJoint *j = &w->model->joints[k];
        bool touches = (size_t)j->body[0] == body || (size_t)j->body[1] == body;
        if (k != base && touches && is_apart(w, from, joint_at(w, j)))
            turn(w, body, from, joint_at(w, j), name, joint_image(w, k, body));
    }
    const YkBody *b = &w->model->bodies[body];
    for (int32_t k = 0; k < b->point_count; k++) {
        const YkPoint *point = &w->model->points[b->first_point + k];
        YkVec at = place_of(w, body, point->at);
        bool is_joint = false;
        for (size_t i = 0; i < w->model->shown_joints && !is_joint; i++) {
            const YkJoint *j = &w->model->joints[i];
            bool touches = (size_t)j->body[0] == body || (size_t)j->body[1] == body;
            is_joint = touches && !is_apart(w, at, joint_at(w, j));
        }
        if (is_joint) continue;
        YkText whole = {0};
        yk_text_format(&whole, "%s.%s", b->name, point->name);
        w->p->failed |= whole.failed;
        size_t key = 2 * w->model->joint_count + (size_t)(b->first_point + k);
        turn(w, body, from, at, name, add_image(w, key, yk_text_get(&whole), "", body, at));
        yk_text_free(&whole);
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

static void end_step(Walk *w, size_t count, size_t first, int block)
{
    YkPolygonStep step = {w->bodies, count, first, block};
    yk_polygon_tell(w->p, &step, block >= 0 ? w->mech->blocks[block].label : NULL, w->rate);
}

// A body that no block places: driven, welded, or turned by gears and the like.
static bool take_body(Walk *w)
{
    for (size_t b = 1; b < w->model->body_count; b++) {
        size_t base = w->is_known[b] || w->block_of[b] >= 0 ? YK_NOT_FOUND : base_of(w, b);
        if (base == YK_NOT_FOUND) continue;
        size_t first = w->p->vector_count;
        slide(w, base, known_beyond(w, &w->model->joints[base], b), b);
        reach_points(w, b, base);
        w->is_known[b] = true;
        w->bodies[0] = b;
        end_step(w, 1, first, -1);
        return true;
    }
    return false;
}

// Returns the next of a block's bodies that a joint connects to known ones; bases outside the block come first.
static bool take_member(Walk *w, size_t block, const bool *was_known, bool outside, bool *is_base)
{
    for (size_t k = 0; k < yk_block_info(w->mech, block).body_count; k++) {
        size_t b = yk_block_body(w->mech, block, k);
        for (size_t j = 0; j < w->model->shown_joints && !w->is_known[b]; j++) {
            size_t other = known_beyond(w, &w->model->joints[j], b);
            if (other == YK_NOT_FOUND || (outside && !was_known[other])) continue;
            slide(w, j, other, b);
            reach_points(w, b, j);
            w->is_known[b] = is_base[j] = true;
            return true;
        }
    }
    return false;
}

static bool take_block(Walk *w, bool *was_known, bool *is_base)
{
    for (size_t block = 0; block < w->mech->block_count; block++) {
        YkBlockInfo info = yk_block_info(w->mech, block);
        size_t first = w->p->vector_count, count = 0;
        if (w->is_placed[block] || info.body_count == 0) continue;
        memcpy(was_known, w->is_known, w->model->body_count * sizeof *was_known);
        while (take_member(w, block, was_known, true, is_base)) count++;
        if (count == 0) continue;
        while (take_member(w, block, was_known, false, is_base)) count++;
        for (size_t k = 0; k < info.joint_count; k++) {
            size_t j = yk_block_joint(w->mech, block, k);
            const YkJoint *joint = &w->model->joints[j];
            bool is_open = w->is_known[joint->body[0]] && w->is_known[joint->body[1]] && !is_base[j];
            if (is_open && j < w->model->shown_joints) slide(w, j, (size_t)joint->body[0], (size_t)joint->body[1]);
        }
        for (size_t k = 0; k < info.body_count; k++) w->bodies[k] = yk_block_body(w->mech, block, k);
        w->is_placed[block] = true;
        end_step(w, info.body_count, first, (int)block);
        return true;
    }
    return false;
}

// --- making

static bool allocate(Walk *w, size_t capacity)
{
    YkPolygon *p = w->p;
    size_t bodies = w->model->body_count;
    w->motion = YK_NEW(p->arena, YkBodyMotion, bodies);
    w->is_known = YK_NEW(p->arena, bool, bodies);
    w->block_of = YK_NEW(p->arena, int, bodies);
    w->rate = YK_NEW(p->arena, double, bodies);
    w->bodies = YK_NEW(p->arena, size_t, bodies);
    w->is_placed = YK_NEW(p->arena, bool, w->mech->block_count + 1);
    w->key = YK_NEW(p->arena, size_t, capacity);
    p->vector = YK_NEW(p->arena, YkPolygonVector, capacity);
    p->image = YK_NEW(p->arena, YkPolygonImage, capacity);
    p->step = YK_NEW(p->arena, const char *, bodies + 1);
    return !yk_arena_failed(p->arena);
}

static void prepare(Walk *w, const YkState *state)
{
    for (size_t b = 0; b < w->model->body_count; b++) {
        w->motion[b] = yk_body_motion(w->mech, &state->space, b);
        w->rate[b] = w->p->kind == YK_POLYGON_VELOCITY ? w->motion[b].w : w->motion[b].a;
        w->block_of[b] = -1;
    }
    for (size_t k = 0; k < w->mech->block_count; k++)
        for (size_t i = 0; i < yk_block_info(w->mech, k).body_count; i++)
            w->block_of[yk_block_body(w->mech, k, i)] = (int)k;
    w->is_known[0] = true;
    w->key[w->p->image_count] = YK_NOT_FOUND;
    w->p->image[w->p->image_count++] = (YkPolygonImage){"o", {0, 0}, {0, 0}};
}

static const char *why_not(const YkState *state)
{
    if (!yk_state_has_pose(state) || !yk_state_has_rates(state)) return "the rates are not determined at this pose";
    for (size_t j = 0; j < state->mech->model->joint_count; j++)
        if (state->mech->model->joints[j].is_free) return "the machine has `free` joints, which nothing constructs";
    return NULL;
}

YkPolygon *yk_polygon_new(const YkState *state, YkPolygonKind kind, YkProblems *problems)
{
    if (!state) return NULL;
    const char *why = why_not(state);
    if (why) {
        yk_problem(problems, YK_CODE_NO_POLYGON, (YkPlace){0}, "there is no polygon: %s", why);
        return NULL;
    }
    YkPolygon *p = calloc(1, sizeof *p);
    if (p) p->arena = yk_arena_new();
    Walk w = {.p = p, .mech = state->mech, .model = state->mech->model};
    size_t capacity = 12 * w.model->joint_count + 4 * w.model->point_count + 8;
    bool good = p && p->arena;
    if (good) {
        p->model = w.model;
        p->kind = kind;
        good = allocate(&w, capacity);
    }
    if (good) {
        bool *was_known = YK_NEW(p->arena, bool, w.model->body_count),
             *is_base = YK_NEW(p->arena, bool, w.model->joint_count + 1);
        prepare(&w, state);
        while (was_known && is_base && !p->failed && (take_body(&w) || take_block(&w, was_known, is_base))) {}
        good = !p->failed && !yk_arena_failed(p->arena);
    }
    if (good) return p;
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while constructing a polygon");
    yk_polygon_free(p);
    return NULL;
}

void yk_polygon_free(YkPolygon *p)
{
    if (!p) return;
    yk_text_free(&p->svg);
    yk_arena_free(p->arena);
    free(p);
}

YkPolygonKind yk_polygon_kind(const YkPolygon *p)
{
    return p ? p->kind : YK_POLYGON_VELOCITY;
}
size_t yk_polygon_vector_count(const YkPolygon *p)
{
    return p ? p->vector_count : 0;
}
YkPolygonVector yk_polygon_vector(const YkPolygon *p, size_t index)
{
    return index < yk_polygon_vector_count(p) ? p->vector[index] : (YkPolygonVector){.joint = YK_NOT_FOUND};
}
size_t yk_polygon_image_count(const YkPolygon *p)
{
    return p ? p->image_count : 0;
}
YkPolygonImage yk_polygon_image(const YkPolygon *p, size_t index)
{
    return index < yk_polygon_image_count(p) ? p->image[index] : (YkPolygonImage){0};
}
size_t yk_polygon_step_count(const YkPolygon *p)
{
    return p ? p->step_count : 0;
}
const char *yk_polygon_step(const YkPolygon *p, size_t index)
{
    return index < yk_polygon_step_count(p) ? p->step[index] : NULL;
}
