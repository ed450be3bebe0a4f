// Fills velocity and acceleration polygons with the numbers of a pose.
#include "design/polygons/polygon.h"
#include <stdlib.h>
#include "base/problems.h"
#include "design/polygons/polygon_plan.h"
#include "loads/loads.h"
#include "solve/state.h"

typedef struct Walk {
    YkPolygon *p;
    const YkPolygonPlan *plan;
    const YkMechanism *mech;
    const YkModel *model;
    YkBodyMotion *motion; // [body]
    double *rate;         // [body]: its rate or angular acceleration, as the kind asks
    double none;          // of a velocity or acceleration: what is rounding beside the largest
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

// Returns where an end is. A joint is where its point on the second body is, which slides along the line of the first
// where it slides.
static YkVec end_at(const Walk *w, const YkPolygonEnd *end)
{
    if (end->joint == YK_NOT_FOUND) return place_of(w, end->body, w->model->points[end->point].at);
    const YkJoint *joint = &w->model->joints[end->joint];
    return place_of(w, (size_t)joint->body[1], joint->at[1]);
}

// --- vectors

// Returns a component, or 0 if it is what rounding leaves beside the largest motion.
static double shown(const Walk *w, double value)
{
    return fabs(value) > w->none ? value + 0.0 : 0; // no -0
}

static void add_vector(Walk *w, YkPolygonVector v, YkVec start, YkVec value)
{
    YkPolygon *p = w->p;
    v.start[0] = start.x;
    v.start[1] = start.y;
    v.value[0] = shown(w, value.x);
    v.value[1] = shown(w, value.y);
    v.step = p->step_count;
    p->vector[p->vector_count++] = v;
}

// From a place of a body to another one of the same body.
static void turn(Walk *w, const YkPolygonLink *link)
{
    const YkBodyMotion *m = &w->motion[link->body];
    YkVec from = end_at(w, &link->from), arm = yk_sub(end_at(w, &link->to), from);
    YkVec start = image_of(w, link->body, from);
    YkPolygonVector v = {YK_POLYGON_TURNING, link->body, YK_NOT_FOUND, 0, {0}, {0}, link->from.image, link->to.image};
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
static void slide(Walk *w, const YkPolygonLink *link)
{
    size_t carrier = link->body, joint = link->joint;
    YkVec at = end_at(w, &link->to), start = image_of(w, link->from.body, at);
    YkVec whole = yk_sub(image_of(w, link->to.body, at), start);
    YkVec line = yk_mul(w->motion[carrier].e, w->model->joints[joint].along);
    YkPolygonVector v = {YK_POLYGON_CORIOLIS, carrier, joint, 0, {0}, {0}, link->from.image, link->to.image};
    if (w->p->kind == YK_POLYGON_ACCELERATION && carrier != 0) {
        YkVec across = yk_scale(yk_dot(whole, yk_quarter(line)), yk_quarter(line));
        add_vector(w, v, start, across);
        start = yk_add(start, across);
    }
    v.part = YK_POLYGON_SLIDING;
    add_vector(w, v, start, yk_scale(yk_dot(whole, line), line));
}

// --- making

static bool allocate(Walk *w)
{
    YkPolygon *p = w->p;
    size_t bodies = w->model->body_count;
    w->motion = YK_NEW(p->arena, YkBodyMotion, bodies);
    w->rate = YK_NEW(p->arena, double, bodies);
    p->vector = YK_NEW(p->arena, YkPolygonVector, yk_polygon_most_vectors(w->plan));
    p->image = YK_NEW(p->arena, YkPolygonImage, w->plan->image_count);
    p->step = YK_NEW(p->arena, const char *, w->plan->step_count + 1);
    return !yk_arena_failed(p->arena);
}

static void take_motions(Walk *w, const YkState *state)
{
    for (size_t b = 0; b < w->model->body_count; b++) {
        w->motion[b] = yk_body_motion(w->mech, &state->space, b);
        w->rate[b] = w->p->kind == YK_POLYGON_VELOCITY ? w->motion[b].w : w->motion[b].a;
        YkVec at = w->p->kind == YK_POLYGON_VELOCITY ? w->motion[b].velocity : w->motion[b].acceleration;
        double normal = w->p->kind == YK_POLYGON_VELOCITY ? 0 : w->motion[b].w * w->motion[b].w;
        w->none = fmax(w->none, 1e-12 * fmax(yk_norm(at), fmax(fabs(w->rate[b]), normal) * w->mech->size));
    }
    for (size_t b = 0; b < w->model->body_count; b++)
        if (fabs(w->rate[b]) * w->mech->size <= w->none) w->rate[b] = 0;
}

static void take_images(Walk *w)
{
    YkPolygon *p = w->p;
    p->image[p->image_count++] = (YkPolygonImage){"o", {0, 0}, {0, 0}};
    for (size_t k = 1; k < w->plan->image_count; k++) {
        const YkPolygonEnd *end = &w->plan->image[k];
        YkVec at = end_at(w, end), value = image_of(w, end->body, at);
        p->image[p->image_count++] = (YkPolygonImage){end->image, {at.x, at.y}, {shown(w, value.x), shown(w, value.y)}};
    }
}

static void take_steps(Walk *w)
{
    for (size_t k = 0; k < w->plan->step_count; k++) {
        const YkPolygonStep *step = &w->plan->step[k];
        size_t first = w->p->vector_count;
        for (size_t i = 0; i < step->links; i++) {
            const YkPolygonLink *link = &w->plan->link[step->first + i];
            link->joint == YK_NOT_FOUND ? turn(w, link) : slide(w, link);
        }
        yk_polygon_tell(w->p, w->plan, step, first, w->rate);
    }
}

static const char *why_not(const YkState *state)
{
    if (!yk_state_has_pose(state) || !yk_state_has_rates(state)) return "the rates are not determined at this pose";
    return yk_polygon_why_not(state->mech->model);
}

static bool make(YkPolygon *p, const YkState *state)
{
    Walk w = {.p = p, .mech = state->mech, .model = state->mech->model};
    p->arena = yk_arena_new();
    if (!p->arena) return false;
    p->model = w.model;
    w.plan = yk_polygon_plan(w.mech, p->arena);
    if (!w.plan || !allocate(&w)) return false;
    take_motions(&w, state);
    take_images(&w);
    take_steps(&w);
    return !p->failed && !yk_arena_failed(p->arena);
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
    if (p) p->kind = kind;
    if (p && make(p, state)) return p;
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
