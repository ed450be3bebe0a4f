// Names of points, and walks from point to point as sums of named vectors.
#include <stdlib.h>
#include <string.h>
#include "base/sets.h"
#include "derive/inside.h"

// Places: the model's points, then each body's origin. Places that always coincide share a root.
struct YkDeriveNames {
    int32_t *root;       // sets of points that coincide
    bool *is_ambiguous;  // per point: another place has the same name
    const char **origin; // per body: name of its origin
    const char **center; // per body: name of its centre of mass
};

static int32_t place_index(const YkDerivation *d, YkDerivePlace place)
{
    return place.point != YK_NONE ? place.point : (int32_t)d->model->point_count + place.body;
}

static void unite_places(YkDerivation *d, struct YkDeriveNames *names)
{
    for (size_t j = 0; j < d->model->joint_count; j++) {
        YkPartKind kind = d->model->joints[j].kind;
        if (kind != YK_PIN && kind != YK_WELD) continue;
        int32_t first = place_index(d, yk_derive_place(d, (int32_t)j, 0));
        yk_sets_join(names->root, first, place_index(d, yk_derive_place(d, (int32_t)j, 1)));
    }
    for (size_t p = 0; p < d->model->point_count; p++) {
        int32_t body = d->model->points[p].body;
        if (yk_ring_is_zero(yk_derive_at(d, (int32_t)p)))
            yk_sets_join(names->root, (int32_t)p, place_index(d, (YkDerivePlace){body, YK_NONE}));
    }
}

// A name stands alone if all points of that name coincide.
static bool find_ambiguous(YkDerivation *d, struct YkDeriveNames *names)
{
    size_t points = d->model->point_count;
    int32_t *first = yk_derive_scratch(d, points + 1, sizeof *first); // point of this name
    YkNames table = {0};
    bool well = first != NULL;
    for (size_t p = 0; p < points && well; p++) {
        well = yk_names_add(&table, d->model->points[p].name, (int32_t)p, &first[p]);
        if (first[p] == YK_NONE) first[p] = (int32_t)p;
        if (yk_root_of(names->root, first[p]) != yk_root_of(names->root, (int32_t)p))
            names->is_ambiguous[first[p]] = true;
    }
    for (size_t p = 0; p < points && well; p++) names->is_ambiguous[p] = names->is_ambiguous[first[p]];
    yk_names_free(&table);
    free(first);
    return well;
}

static bool is_point_name(const YkDerivation *d, const char *name)
{
    for (size_t p = 0; p < d->model->point_count; p++)
        if (strcmp(d->model->points[p].name, name) == 0) return true;
    return false;
}

// Names origins by the point that the file puts there; else O for the ground, or with 0 the first body with that
// origin.
static void name_origins(YkDerivation *d, struct YkDeriveNames *names)
{
    bool has_O = is_point_name(d, "O");
    int32_t points = (int32_t)d->model->point_count;
    for (size_t b = 0; b < d->model->body_count; b++) {
        int32_t root = yk_root_of(names->root, place_index(d, (YkDerivePlace){(int32_t)b, YK_NONE}));
        if (root < points)
            names->origin[b] = yk_derive_point_name(d, d->model->points[root].body, root);
        else
            names->origin[b] =
                root == points && !has_O ? "O" : yk_derive_text(d, d->model->bodies[root - points].name, "", "0");
    }
}

// Names centres C1, C2, ... in the order of bodies with mass; G1, G2, ... if a point of the file has such a name.
static void name_centers(YkDerivation *d, struct YkDeriveNames *names)
{
    static const char *const stems[] = {"C", "G", "S", "center"};
    size_t stem = 0, count = 0;
    for (size_t p = 0; p < d->model->point_count && stem < 3;) {
        const char *name = d->model->points[p].name;
        bool taken = name[0] == stems[stem][0] && name[1] >= '0' && name[1] <= '9';
        stem += taken;
        p = taken ? 0 : p + 1;
    }
    for (size_t b = 1; b < d->model->body_count; b++)
        if (d->model->bodies[b].has_mass) names->center[b] = yk_derive_numbered(d, stems[stem], ++count);
}

static struct YkDeriveNames *make_names(YkDerivation *d)
{
    size_t points = d->model->point_count, bodies = d->model->body_count;
    struct YkDeriveNames *names = YK_NEW(d->arena, struct YkDeriveNames, 1);
    if (!names) return NULL;
    names->root = YK_NEW(d->arena, int32_t, points + bodies);
    names->is_ambiguous = YK_NEW(d->arena, bool, points + 1);
    names->origin = YK_NEW(d->arena, const char *, bodies);
    names->center = YK_NEW(d->arena, const char *, bodies);
    if (yk_arena_failed(d->arena)) return NULL;
    yk_sets_begin(names->root, points + bodies);
    unite_places(d, names);
    if (!find_ambiguous(d, names)) return NULL;
    d->names = names;
    name_origins(d, names);
    name_centers(d, names);
    return names;
}

// Returns NULL when out of memory: the derivation has then failed.
static struct YkDeriveNames *names_of(YkDerivation *d)
{
    if (!d->names && !make_names(d)) d->failed = true;
    return d->names;
}

const char *yk_derive_point_name(YkDerivation *d, int32_t body, int32_t point)
{
    const struct YkDeriveNames *names = names_of(d);
    if (!names) return "";
    if (point == YK_NONE) return names->origin[body];
    const YkPoint *p = &d->model->points[point];
    return names->is_ambiguous[point] ? yk_derive_text(d, d->model->bodies[p->body].name, ".", p->name) : p->name;
}

const char *yk_derive_center_name(YkDerivation *d, int32_t body)
{
    const struct YkDeriveNames *names = names_of(d);
    const char *name = names ? names->center[body] : NULL;
    return name ? name : yk_derive_point_name(d, body, YK_NONE);
}

// --- Walking

typedef struct Walk {
    YkDerivation *d;
    YkDeriveVector *vectors;
    size_t count;
} Walk;

static void add_vector(Walk *walk, YkDeriveVector vector)
{
    YkRing *ring = walk->d->ring;
    if (!vector.value || yk_ring_is_zero(vector.value)) return;
    YkDeriveVector *last = walk->count > 0 ? &walk->vectors[walk->count - 1] : NULL;
    bool goes_on = last && last->body == vector.body && !last->is_variable && !vector.is_variable &&
                   last->is_negative == vector.is_negative;
    if (goes_on && strcmp(last->head, vector.tail) == 0) { // two steps on one body
        last->head = vector.head;
        last->value = yk_ring_add(ring, last->value, vector.value);
    } else if (goes_on && strcmp(last->tail, vector.head) == 0) {
        last->tail = vector.tail;
        last->value = yk_ring_add(ring, last->value, vector.value);
    } else {
        walk->vectors[walk->count++] = vector;
    }
}

// Returns the vector from a tail to a head, by their names.
static YkDeriveVector between(YkDerivation *d, YkDerivePlace head, YkDerivePlace tail, const YkPoisson *value)
{
    YkDeriveVector vector = {.value = value};
    vector.head = yk_derive_point_name(d, head.body, head.point);
    vector.tail = yk_derive_point_name(d, tail.body, tail.point);
    return vector;
}

// Steps on one body from a place to a place. Away from where the body is attached in the tree a vector keeps its
// sense; towards it, the textbook's vector points outwards and is subtracted.
static void step_on(Walk *walk, YkDerivePlace from, YkDerivePlace to, bool inwards)
{
    YkDerivation *d = walk->d;
    YkDerivePlace tail = inwards ? to : from, head = inwards ? from : to;
    const YkPoisson *arm = yk_derive_at(d, head.point);
    arm = yk_ring_subtract(d->ring, arm, yk_derive_at(d, tail.point));
    YkDeriveVector vector = between(d, head, tail, yk_ring_multiply(d->ring, d->bodies[from.body].unit, arm));
    vector.body = from.body;
    vector.is_negative = inwards;
    add_vector(walk, vector);
}

// Steps over a slide: from the first body's place to the second's, or back.
static void step_over(Walk *walk, int32_t joint, bool inwards, bool to_second)
{
    YkDerivation *d = walk->d;
    if (d->joint_distance[joint] == YK_NONE) return;
    YkDerivePlace from = yk_derive_place(d, joint, 0), to = yk_derive_place(d, joint, 1);
    (void)inwards;
    YkDeriveVector vector = between(d, to, from, yk_derive_slide(d, joint));
    vector.body = from.body;
    vector.is_negative = !to_second;
    vector.is_variable = true;
    add_vector(walk, vector);
}

static int side_of(const YkDerivation *d, int32_t body)
{
    return d->model->joints[d->bodies[body].joint].body[1] == body;
}

// Walks from a place on a body up to the place on the ancestor from which its branch starts.
static YkDerivePlace climb(Walk *walk, YkDerivePlace from, int32_t ancestor)
{
    const YkDerivation *d = walk->d;
    while (from.body != ancestor) {
        int32_t joint = d->bodies[from.body].joint;
        int side = side_of(d, from.body);
        step_on(walk, from, yk_derive_place(d, joint, side), true);
        step_over(walk, joint, true, side == 0);
        from = yk_derive_place(d, joint, !side);
    }
    return from;
}

// Walks the same way down, over the bodies between.
static void descend(Walk *walk, YkDerivePlace start, int32_t ancestor, YkDerivePlace to, int32_t *bodies)
{
    const YkDerivation *d = walk->d;
    size_t depth = 0;
    for (int32_t b = to.body; b != ancestor; b = d->bodies[b].parent) bodies[depth++] = b;
    YkDerivePlace here = start;
    for (; depth > 0; depth--) {
        int32_t b = bodies[depth - 1], joint = d->bodies[b].joint;
        int side = side_of(d, b);
        step_on(walk, here, yk_derive_place(d, joint, !side), false);
        step_over(walk, joint, false, side == 1);
        here = yk_derive_place(d, joint, side);
    }
    step_on(walk, here, to, false);
}

// Returns the body at which the tree's branches to two bodies part (path.c).
static int32_t common_body(const YkDerivation *d, int32_t a, int32_t b)
{
    const int32_t *depth = d->mech->tree.depth;
    while (a != b) {
        if (depth[a] >= depth[b])
            a = d->bodies[a].parent;
        else
            b = d->bodies[b].parent;
    }
    return a;
}

bool yk_derive_path(YkDerivation *d, YkDerivePlace from, YkDerivePlace to, YkDerivePath *path)
{
    const int32_t *depth = d->mech->tree.depth;
    size_t most = 2 * (size_t)(depth[from.body] + depth[to.body]) + 4;
    Walk walk = {.d = d, .vectors = YK_NEW(d->arena, YkDeriveVector, most)};
    int32_t *bodies = YK_NEW(d->arena, int32_t, most), common = common_body(d, from.body, to.body);
    *path = (YkDerivePath){0};
    if (!walk.vectors || !bodies) return false;
    descend(&walk, climb(&walk, from, common), common, to, bodies);
    *path = (YkDerivePath){walk.vectors, walk.count, yk_ring_rational(d->ring, 0, 1)};
    for (size_t k = 0; k < walk.count; k++) {
        const YkDeriveVector *v = &walk.vectors[k];
        path->sum =
            v->is_negative ? yk_ring_subtract(d->ring, path->sum, v->value) : yk_ring_add(d->ring, path->sum, v->value);
    }
    return path->sum != NULL;
}

// --- Loops

// Returns the second body's angle minus the first's minus the constant, for a slide or weld that closes a loop.
static const YkPoisson *angle_row(YkDerivation *d, int32_t joint)
{
    YkRing *ring = d->ring;
    const YkJoint *j = &d->model->joints[joint];
    const YkDeriveBody *a = &d->bodies[j->body[0]], *b = &d->bodies[j->body[1]];
    const YkPoisson *sum = yk_ring_negate(ring, yk_derive_expression(d, j->turned_expr));
    if (a->angle == b->angle) return NULL; // slides and welds of the tree keep it already
    for (int side = 0; side < 2; side++) {
        const YkPoisson *angle = yk_derive_body_angle(d, j->body[side]);
        sum = side ? yk_ring_add(ring, sum, angle) : yk_ring_subtract(ring, sum, angle);
    }
    return sum;
}

static bool make_loop(YkDerivation *d, YkDeriveLoop *loop, int32_t joint)
{
    const YkJoint *j = &d->model->joints[joint];
    YkDerivePlace second = yk_derive_place(d, joint, 1), first = yk_derive_place(d, joint, 0);
    *loop = (YkDeriveLoop){.joint = joint, .axes = common_body(d, j->body[0], j->body[1])};
    if (!yk_derive_path(d, second, first, &loop->path)) return false;
    if (d->joint_distance[joint] != YK_NONE) { // the first body's point moves along its line
        YkDerivePath *path = &loop->path;
        YkDeriveVector vector = between(d, second, first, yk_derive_slide(d, joint));
        vector.body = first.body;
        vector.is_variable = true;
        path->vectors[path->count++] = vector;
        path->sum = yk_ring_add(d->ring, path->sum, yk_derive_slide(d, joint));
    }
    const YkPoisson *axes = yk_derive_in_joints(d, d->bodies[loop->axes].unit);
    loop->sum = yk_ring_multiply(d->ring, yk_ring_conjugate(d->ring, axes), yk_derive_in_joints(d, loop->path.sum));
    if (!yk_part(j->kind)->turns) loop->angle = angle_row(d, joint);
    return loop->sum != NULL;
}

const YkDeriveLoop *yk_derive_loops(YkDerivation *d)
{
    if (d->loops) return d->loops;
    YkDeriveLoop *loops = YK_NEW(d->arena, YkDeriveLoop, d->mech->loop_count + 1);
    if (!loops) return NULL;
    for (size_t k = 0; k < d->mech->loop_count; k++)
        if (!make_loop(d, &loops[k], d->mech->loops[k].joint)) return NULL;
    d->loop_count = d->mech->loop_count;
    d->loops = loops;
    return loops;
}
