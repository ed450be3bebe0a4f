// Open trees under test: random machines, and their bodies placed straight from the joints' definitions, body by body,
// with first and second derivatives in time. Knows nothing of links, merging or articulated inertia.
#ifndef TESTS_DYNAMICS_OPEN_TREE_H
#define TESTS_DYNAMICS_OPEN_TREE_H
#include "check.h"
#include <stdlib.h>
#include <yoke/yoke.h>
#include "equations/tree.h"

typedef struct OpenTree {
    YkProblems *problems;
    YkModel *model;
    YkMechanism *mech;
    YkTreeDynamics *tree;
    size_t n; // inputs
} OpenTree;

static inline OpenTree open_tree_compile(const char *text)
{
    OpenTree t = {.problems = yk_problems_new()};
    t.model = yk_model_parse(text, strlen(text), "test.yaml", NULL, t.problems);
    t.mech = t.model ? yk_mechanism_compile(t.model, NULL, t.problems) : NULL;
    if (!t.mech) print_error("%.4000s\n%s", text, yk_problems_text(t.problems, 0));
    assert_non_null(t.mech);
    t.n = yk_input_count(t.mech);
    return t;
}

static inline OpenTree open_tree(const char *text)
{
    OpenTree t = open_tree_compile(text);
    bool fits = false;
    t.tree = yk_tree_dynamics_new(t.mech, &fits);
    assert_true(fits);
    assert_non_null(t.tree);
    return t;
}

static inline void open_tree_free(OpenTree *t)
{
    yk_tree_dynamics_free(t->tree);
    yk_mechanism_free(t->mech);
    yk_model_free(t->model);
    yk_problems_free(t->problems);
}

static inline double *numbers(size_t count)
{
    double *x = calloc(count + 1, sizeof *x);
    assert_non_null(x);
    return x;
}

// --- text that grows

typedef struct Text {
    char *at;
    size_t length, capacity;
} Text;

static inline void add(Text *text, const char *format, ...)
{
    va_list arguments;
    if (text->capacity < text->length + 1024) {
        text->capacity = 2 * text->capacity + 4096;
        text->at = realloc(text->at, text->capacity);
        assert_non_null(text->at);
    }
    va_start(arguments, format);
    text->length += (size_t)vsnprintf(text->at + text->length, 1024, format, arguments);
    va_end(arguments);
}

// --- random machines

typedef struct TreeRecipe {
    size_t bodies;
    bool pins_only, is_chain;
} TreeRecipe;

typedef struct RandomJoint {
    YkPartKind kind;
    size_t parent;
    bool is_reversed; // the child is the first body
} RandomJoint;

static inline YkPartKind random_kind(uint64_t *seed, TreeRecipe recipe)
{
    static const YkPartKind kinds[] = {YK_PIN, YK_PIN, YK_SLIDE, YK_PIN_SLOT, YK_WELD};
    return recipe.pins_only ? YK_PIN : kinds[check_random(seed) % 5];
}

static inline void add_point(Text *text, uint64_t *seed, size_t joint)
{
    double y = check_uniform(seed, -1, 1), x = check_uniform(seed, -1, 1);
    add(text, "J%zu: [%.17g, %.17g], ", joint, x, y);
}

// A body carries one point for each of its joints. Only what is welded may be without mass.
static inline void add_body(Text *text, uint64_t *seed, const RandomJoint *joint, size_t body, size_t bodies)
{
    add(text, body == 0 ? "  ground: {points: {" : "  b%zu: {points: {", body);
    for (size_t k = 1; k < bodies; k++)
        if (k == body || joint[k].parent == body) add_point(text, seed, k);
    add(text, "own: [0, 0]}");
    if (body > 0 && !(joint[body].kind == YK_WELD && check_random(seed) % 3 == 0)) {
        double inertia = check_uniform(seed, 0.05, 1), y = check_uniform(seed, -1, 1), x = check_uniform(seed, -1, 1);
        add(text, ", mass: %.17g, center: [%.17g, %.17g], inertia: %.17g", check_uniform(seed, 0.2, 3), x, y, inertia);
    }
    add(text, "}\n");
}

static inline void add_joint(Text *text, uint64_t *seed, const RandomJoint *joint, size_t k)
{
    static const char *const keys[] = {"pin", "slide", "pin-slot", "weld"};
    char parent[32] = "ground", child[32];
    if (joint->parent > 0) snprintf(parent, sizeof parent, "b%zu", joint->parent);
    snprintf(child, sizeof child, "b%zu", k);
    add(text, "  J%zu: {%s: [%s, %s]", k, keys[joint->kind], joint->is_reversed ? child : parent,
        joint->is_reversed ? parent : child);
    bool slides = joint->kind == YK_SLIDE || joint->kind == YK_PIN_SLOT;
    if (slides) add(text, ", from: J%zu, along: %.17g", k, check_uniform(seed, -3, 3));
    if (joint->kind == YK_SLIDE) add(text, ", to: J%zu", k);
    if (joint->kind == YK_SLIDE || joint->kind == YK_WELD) add(text, ", turned: %.17g", check_uniform(seed, -3, 3));
    add(text, "}\n");
}

// The coordinates named in `start:` come first among the inputs: in any order.
static inline void add_start(Text *text, uint64_t *seed, const RandomJoint *joint, size_t bodies)
{
    add(text, "start: {");
    for (size_t k = bodies - 1; k > 0; k--) {
        if (check_random(seed) % 2) continue;
        if (joint[k].kind == YK_PIN || joint[k].kind == YK_PIN_SLOT) add(text, "J%zu.angle: 0.1, ", k);
        if (joint[k].kind == YK_SLIDE || joint[k].kind == YK_PIN_SLOT) add(text, "J%zu.distance: 0.1, ", k);
    }
    add(text, "}\n");
}

static inline OpenTree random_tree(uint64_t *seed, TreeRecipe recipe)
{
    Text text = {0};
    RandomJoint *joint = calloc(recipe.bodies, sizeof *joint);
    assert_non_null(joint);
    for (size_t k = 1; k < recipe.bodies; k++) {
        bool is_next = recipe.is_chain || check_random(seed) % 2;
        joint[k].kind = random_kind(seed, recipe);
        joint[k].parent = is_next ? k - 1 : check_random(seed) % k;
        joint[k].is_reversed = check_random(seed) % 2;
    }
    double gravity_y = check_uniform(seed, -10, 10), gravity_x = check_uniform(seed, -10, 10);
    add(&text, "gravity: [%.17g, %.17g]\nbodies:\n", gravity_x, gravity_y);
    for (size_t k = 0; k < recipe.bodies; k++) add_body(&text, seed, joint, k, recipe.bodies);
    add(&text, "joints:\n");
    for (size_t k = 1; k < recipe.bodies; k++) add_joint(&text, seed, &joint[k], k);
    if (check_random(seed) % 2) add_start(&text, seed, joint, recipe.bodies);
    OpenTree t = open_tree(text.at);
    free(text.at);
    free(joint);
    return t;
}

// --- bodies from the joints' definitions

typedef struct Jet {
    double p, v, a;
} Jet; // a number and its derivatives in time
typedef struct VecJet {
    YkVec p, v, a;
} VecJet;
typedef struct BodyJet {
    Jet angle;
    VecJet origin;
} BodyJet;

static inline Jet jet_add(Jet a, Jet b, double sign)
{
    return (Jet){a.p + sign * b.p, a.v + sign * b.v, a.a + sign * b.a};
}
static inline VecJet vec_add(VecJet a, VecJet b, double sign)
{
    return (VecJet){yk_add(a.p, yk_scale(sign, b.p)), yk_add(a.v, yk_scale(sign, b.v)),
                    yk_add(a.a, yk_scale(sign, b.a))};
}

// d e^(i angle) s, differentiated twice.
static inline VecJet turned(Jet angle, Jet d, YkVec s)
{
    YkVec r = yk_mul(yk_vec(cos(angle.p), sin(angle.p)), s);
    double w = angle.v;
    return (VecJet){yk_scale(d.p, r), yk_mul(yk_vec(d.v, d.p * w), r),
                    yk_mul(yk_vec(d.a - d.p * w * w, 2 * d.v * w + d.p * angle.a), r)};
}

static inline Jet coordinate_jet(const OpenTree *t, int32_t joint, bool is_distance, const double *q, const double *v,
                                 const double *a)
{
    for (size_t i = 0; i < t->n; i++) {
        YkCoordinateInfo info = yk_coordinate_info(t->mech, yk_input_coordinate(t->mech, i));
        if ((int32_t)info.joint == joint && info.is_distance == is_distance) return (Jet){q[i], v[i], a[i]};
    }
    fail();
    return (Jet){0, 0, 0};
}

// The body beyond a joint, from the one before it.
static inline BodyJet beyond(const OpenTree *t, int32_t j, bool is_reversed, BodyJet from, const double *q,
                             const double *v, const double *a)
{
    const YkJoint *joint = &t->model->joints[j];
    const Jet one = {1, 0, 0};
    bool turns = joint->kind == YK_PIN || joint->kind == YK_PIN_SLOT;
    bool slides = joint->kind == YK_SLIDE || joint->kind == YK_PIN_SLOT;
    Jet angle = turns ? coordinate_jet(t, j, false, q, v, a) : (Jet){joint->kind == YK_PIN ? 0 : joint->turned, 0, 0};
    Jet d = slides ? coordinate_jet(t, j, true, q, v, a) : (Jet){0, 0, 0};
    BodyJet to = {.angle = jet_add(from.angle, angle, is_reversed ? -1 : 1)};
    Jet first = is_reversed ? to.angle : from.angle, second = is_reversed ? from.angle : to.angle;
    // second body's origin minus the first's
    VecJet way = vec_add(turned(first, one, joint->at[0]), turned(first, d, joint->along), 1);
    way = vec_add(way, turned(second, one, joint->at[1]), -1);
    to.origin = vec_add(from.origin, way, is_reversed ? -1 : 1);
    return to;
}

// body[k] of all bodies.
static inline void place_bodies(const OpenTree *t, const double *q, const double *v, const double *a, BodyJet *body)
{
    size_t n = t->model->body_count, placed = 1;
    bool *is_placed = calloc(n, sizeof *is_placed);
    assert_non_null(is_placed);
    body[0] = (BodyJet){0};
    is_placed[0] = true;
    while (placed < n) {
        size_t before = placed;
        for (size_t j = 0; j < t->model->joint_count; j++) {
            int32_t first = t->model->joints[j].body[0], second = t->model->joints[j].body[1];
            if (is_placed[first] == is_placed[second]) continue;
            bool is_reversed = is_placed[second];
            int32_t to = is_reversed ? first : second, from = is_reversed ? second : first;
            body[to] = beyond(t, (int32_t)j, is_reversed, body[from], q, v, a);
            is_placed[to] = true;
            placed++;
        }
        assert_true(placed > before);
    }
    free(is_placed);
}

static inline VecJet center_of(const OpenTree *t, const BodyJet *body, size_t k)
{
    return vec_add(body[k].origin, turned(body[k].angle, (Jet){1, 0, 0}, t->model->bodies[k].center), 1);
}

#endif
