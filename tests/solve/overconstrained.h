// Random machines assembled by construction: bodies are placed at a pose drawn first, joints are laid through them
// there, and the file is written with that pose as its start. Many of their constraints repeat others: bodies joined
// twice, parallel cranks, doubled guides and meshes.
#ifndef TESTS_SOLVE_OVERCONSTRAINED_H
#define TESTS_SOLVE_OVERCONSTRAINED_H
#include "check.h"
#include <stdbool.h>
#include "base/vec.h"

enum { BODIES_MAX = 40, JOINTS_MAX = 80, MESHES_MAX = 8, COLUMNS_MAX = 3 * BODIES_MAX, ROWS_MAX = 3 * JOINTS_MAX };

typedef enum Joining { PIN, SLIDE, PIN_SLOT, WELD } Joining;
typedef struct Joint {
    Joining kind;
    int body[2];
    YkVec at[2];             // on each body, in its axes: of the second the point that is held
    double along;            // of the line, in the first body's axes
    double turned, distance; // of the second body to the first, at the pose drawn
    bool in_tree;            // its coordinates are named, and given by `start:`
} Joint;
typedef struct Mesh { // first (a - carrier) + second (b - carrier) is constant
    int body[2], carrier, teeth[2];
} Mesh;
typedef struct Drawn { // body 0 is the ground
    YkVec place[BODIES_MAX];
    double angle[BODIES_MAX];
    int bodies, joints, meshes;
    Joint joint[JOINTS_MAX];
    Mesh mesh[MESHES_MAX];
} Drawn;

static inline int draw_below(uint64_t *seed, int n)
{
    return (int)(check_random(seed) % (uint64_t)n);
}

// On a grid of tenths: points coincide and lie in line more often than by chance.
static inline double draw_tenths(uint64_t *seed)
{
    return (draw_below(seed, 31) - 15) / 10.0;
}
static inline YkVec draw_place(uint64_t *seed)
{
    double x = draw_tenths(seed);
    return yk_vec(x, draw_tenths(seed));
}
static inline double draw_direction(uint64_t *seed)
{
    static const double few[] = {0, YK_PI / 2, YK_PI / 4, -0.5};
    int k = draw_below(seed, 6);
    return k < 4 ? few[k] : check_uniform(seed, -3, 3);
}

static inline int draw_body(Drawn *d, uint64_t *seed)
{
    int b = d->bodies++;
    bool in_world_axes = draw_below(seed, 2) == 0;
    d->place[b] = in_world_axes ? yk_vec(0, 0) : draw_place(seed);
    d->angle[b] = in_world_axes ? 0 : check_uniform(seed, -3, 3);
    return b;
}

static inline YkVec in_axes(const Drawn *d, int body, YkVec world)
{
    return yk_mul(yk_conj(yk_unit(d->angle[body])), yk_sub(world, d->place[body]));
}

// A joint at a place of the world; its line, where it has one, in that direction.
static inline Joint *join(Drawn *d, Joining kind, int a, int b, YkVec world, double direction, double distance)
{
    Joint *j = &d->joint[d->joints++];
    YkVec from = yk_sub(world, yk_scale(distance, yk_unit(direction)));
    bool slides = kind == SLIDE || kind == PIN_SLOT;
    *j = (Joint){.kind = kind, .body = {a, b}, .along = direction - d->angle[a], .turned = d->angle[b] - d->angle[a]};
    j->at[0] = in_axes(d, a, slides ? from : world);
    j->at[1] = in_axes(d, b, world);
    j->distance = slides ? distance : 0;
    return j;
}

// A joint of the tree has a coordinate, so it is not a weld.
static inline Joint *join_anyhow(Drawn *d, uint64_t *seed, int a, int b, bool in_tree)
{
    static const Joining kinds[] = {PIN, PIN, PIN, PIN, PIN, SLIDE, SLIDE, PIN_SLOT, PIN_SLOT, WELD};
    Joining kind = kinds[draw_below(seed, in_tree ? 9 : 10)];
    YkVec world = draw_place(seed);
    double direction = draw_direction(seed);
    Joint *j = join(d, kind, a, b, world, direction, draw_tenths(seed));
    j->in_tree = in_tree;
    return j;
}

static inline void draw_pair(const Drawn *d, uint64_t *seed, int *a, int *b)
{
    *a = draw_below(seed, d->bodies);
    *b = draw_below(seed, d->bodies - 1);
    *b += *b >= *a;
}

// --- what repeats constraints
// -----------------------------------------------------------------------------------------

static inline bool has_room(const Drawn *d, int bodies, int joints)
{
    return d->bodies + bodies <= BODIES_MAX && d->joints + joints <= JOINTS_MAX;
}

// Two or three links of the same length and direction between two bodies, as of a parallelogram.
static inline void add_parallel_links(Drawn *d, uint64_t *seed)
{
    int a, b, links = 2 + draw_below(seed, 2);
    YkVec way = draw_place(seed);
    draw_pair(d, seed, &a, &b);
    for (int k = 0; k < links && has_room(d, 1, 2); k++) {
        int link = draw_body(d, seed);
        YkVec foot = draw_place(seed);
        join(d, PIN, a, link, foot, 0, 0)->in_tree = true;
        join(d, PIN, link, b, yk_add(foot, way), 0, 0);
    }
}

// The same link twice, on the same two pins.
static inline void add_doubled_link(Drawn *d, uint64_t *seed)
{
    int a, b;
    YkVec P = draw_place(seed), Q = draw_place(seed);
    draw_pair(d, seed, &a, &b);
    for (int k = 0; k < 2 && has_room(d, 1, 2); k++) {
        int link = draw_body(d, seed);
        join(d, PIN, a, link, P, 0, 0)->in_tree = true;
        join(d, PIN, link, b, Q, 0, 0);
    }
}

// A guide beside a guide, or further along the same line.
static inline void add_doubled_guide(Drawn *d, uint64_t *seed)
{
    int first = draw_below(seed, d->joints);
    for (int k = 0; k < d->joints; k++) {
        const Joint *j = &d->joint[(first + k) % d->joints];
        if (j->kind != SLIDE) continue;
        double direction = j->along + d->angle[j->body[0]];
        YkVec world = draw_place(seed);
        join(d, SLIDE, j->body[0], j->body[1], world, direction, draw_tenths(seed));
        return;
    }
}

// Three bodies on one pin, joined in a ring; or three that slide in one direction.
static inline void add_ring(Drawn *d, uint64_t *seed)
{
    int a, b, c = d->bodies;
    YkVec world = draw_place(seed);
    Joining kind = draw_below(seed, 2) ? PIN : SLIDE;
    double direction = draw_direction(seed);
    draw_pair(d, seed, &a, &b);
    draw_body(d, seed);
    join(d, kind, a, c, world, direction, draw_tenths(seed))->in_tree = true;
    join(d, kind, c, b, world, direction, draw_tenths(seed));
    join(d, kind, a, b, world, direction, draw_tenths(seed));
}

// Two bodies joined by two pins, or what else a pair can be joined by.
static inline void add_twice(Drawn *d, uint64_t *seed)
{
    const Joint *j = &d->joint[draw_below(seed, d->joints)];
    int a = j->body[0], b = j->body[1];
    if (draw_below(seed, 2))
        join(d, PIN, a, b, draw_place(seed), 0, 0);
    else
        join_anyhow(d, seed, a, b, false);
}

// Two wheels on a carrier, meshed once or twice, with the same ratio.
static inline void add_meshes(Drawn *d, uint64_t *seed)
{
    int carrier = draw_below(seed, d->bodies), wheel[2], teeth[2], meshes = 1 + draw_below(seed, 2);
    for (int k = 0; k < 2; k++) {
        wheel[k] = draw_body(d, seed);
        teeth[k] = 12 + draw_below(seed, 30);
        d->place[wheel[k]] = draw_place(seed);
        join(d, PIN, carrier, wheel[k], d->place[wheel[k]], 0, 0)->in_tree = true;
    }
    for (int k = 1; k <= meshes && d->meshes < MESHES_MAX; k++)
        d->mesh[d->meshes++] = (Mesh){{wheel[0], wheel[1]}, carrier, {k * teeth[0], k * teeth[1]}};
}

static inline void add_extra(Drawn *d, uint64_t *seed)
{
    int a, b;
    if (!has_room(d, 3, 6)) return;
    switch (draw_below(seed, 9)) {
    case 0:
        add_parallel_links(d, seed);
        break;
    case 1:
        add_doubled_link(d, seed);
        break;
    case 2:
        add_doubled_guide(d, seed);
        break;
    case 3:
        add_ring(d, seed);
        break;
    case 4:
    case 5:
        add_twice(d, seed);
        break;
    case 6:
        add_meshes(d, seed);
        break;
    default:
        draw_pair(d, seed, &a, &b);
        join_anyhow(d, seed, a, b, false);
    }
}

// Writes every third pin and weld from its second body to the first: from a link to the ground, too.
static inline void turn_some_round(Drawn *d, uint64_t *seed)
{
    for (int k = 0; k < d->joints; k++) {
        Joint *j = &d->joint[k], old = *j;
        if ((j->kind != PIN && j->kind != WELD) || draw_below(seed, 3) > 0) continue;
        for (int end = 0; end < 2; end++) {
            j->body[end] = old.body[1 - end];
            j->at[end] = old.at[1 - end];
        }
        j->turned = -old.turned;
    }
}

// A tree of bodies, then joints that close loops.
static inline void draw_machine(Drawn *d, uint64_t seed, int bodies, int extras)
{
    *d = (Drawn){.bodies = 1};
    for (int k = 1; k <= bodies; k++) {
        int b = draw_body(d, &seed);
        join_anyhow(d, &seed, draw_below(&seed, b), b, true);
    }
    for (int k = 0; k < extras; k++) add_extra(d, &seed);
    turn_some_round(d, &seed);
}

// --- the file
// ---------------------------------------------------------------------------------------------------------

typedef struct Writer {
    char *text;
    size_t size, capacity;
} Writer;

static inline void put(Writer *w, const char *format, ...) __attribute__((format(printf, 2, 3)));
static inline void put(Writer *w, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    int n = vsnprintf(w->text + w->size, w->capacity - w->size, format, list);
    va_end(list);
    assert_true(n >= 0 && (size_t)n < w->capacity - w->size);
    w->size += (size_t)n;
}

static inline const char *body_name(int body, char name[16])
{
    snprintf(name, 16, body == 0 ? "ground" : "b%d", body);
    return name;
}

static inline void put_joint(Writer *w, const Joint *j, int index)
{
    static const char *const keys[] = {"pin", "slide", "pin-slot", "weld"};
    char a[16], b[16];
    put(w, "  J%d: {%s: [%s, %s]", index, keys[j->kind], body_name(j->body[0], a), body_name(j->body[1], b));
    if (j->kind == PIN || j->kind == WELD) put(w, ", at: P%d", index);
    if (j->kind == SLIDE) put(w, ", from: P%d, to: P%d", index, index);
    if (j->kind == PIN_SLOT) put(w, ", from: P%d, at: P%d", index, index);
    if (j->kind == SLIDE || j->kind == PIN_SLOT) put(w, ", along: %.17g", j->along);
    if (j->kind == SLIDE || j->kind == WELD) put(w, ", turned: %.17g", j->turned);
    if (j->in_tree && (j->kind == PIN || j->kind == PIN_SLOT)) put(w, ", angle: a%d", index);
    if (j->in_tree && (j->kind == SLIDE || j->kind == PIN_SLOT)) put(w, ", distance: d%d", index);
    put(w, "}\n");
}

static inline void write_machine(const Drawn *d, char *text, size_t capacity)
{
    Writer w = {text, 0, capacity};
    char name[16];
    put(&w, "bodies:\n");
    for (int b = 0; b < d->bodies; b++) {
        put(&w, "  %s: {points: {O: [0, 0]", body_name(b, name));
        for (int j = 0; j < d->joints; j++)
            for (int end = 0; end < 2; end++)
                if (d->joint[j].body[end] == b)
                    put(&w, ", P%d: [%.17g, %.17g]", j, d->joint[j].at[end].x, d->joint[j].at[end].y);
        put(&w, "}}\n");
    }
    put(&w, "joints:\n");
    for (int j = 0; j < d->joints; j++) put_joint(&w, &d->joint[j], j);
    if (d->meshes > 0) put(&w, "gears:\n");
    for (int k = 0; k < d->meshes; k++) {
        const Mesh *m = &d->mesh[k];
        put(&w, "  M%d: {mesh: [b%d, b%d], teeth: [%d, %d], carrier: %s}\n", k, m->body[0], m->body[1], m->teeth[0],
            m->teeth[1], body_name(m->carrier, name));
    }
    const char *separator = "start: {";
    for (int j = 0; j < d->joints; j++) {
        const Joint *joint = &d->joint[j];
        if (!joint->in_tree || joint->kind == WELD) continue;
        if (joint->kind != SLIDE) {
            put(&w, "%sa%d: %.17g", separator, j, joint->turned);
            separator = ", ";
        }
        if (joint->kind != PIN) {
            put(&w, "%sd%d: %.17g", separator, j, joint->distance);
            separator = ", ";
        }
    }
    if (*separator == ',') put(&w, "}\n");
}

#endif
