// Wheels, shared by gears, racks and belts: bodies that turn about their origin, on axes that a carrier holds.
#include <math.h>
#include <string.h>
#include "elementary/elementary.h"
#include "model/load.h"

static void mark(YkLoader *loader, const YkNode *name)
{
    if (!name || name->kind != YK_NODE_SCALAR) return;
    int32_t body = yk_names_find(&loader->model->body_names, name->text);
    if (body != YK_NONE) loader->is_wheel[body] = true;
}

static void mark_section(YkLoader *loader, const char *section, const char *key)
{
    const YkNode *map = yk_node_get(loader->root, section);
    if (!map || map->kind != YK_NODE_MAP) return;
    for (size_t i = 0; i < map->count; i++) {
        const YkNode *entry = map->pairs[i].value;
        const YkNode *names = entry->kind == YK_NODE_MAP ? yk_node_get(entry, key) : NULL;
        if (!names || names->kind == YK_NODE_MAP) continue;
        if (names->kind == YK_NODE_SCALAR) mark(loader, names);
        for (size_t k = 0; names->kind == YK_NODE_LIST && k < names->count; k++) mark(loader, names->items[k]);
    }
}

void yk_load_wheels(YkLoader *loader)
{
    loader->is_wheel = YK_NEW(loader->arena, bool, loader->model->body_count);
    if (!loader->is_wheel) {
        loader->failed = true;
        return;
    }
    mark_section(loader, "gears", "mesh");
    mark_section(loader, "racks", "pinion");
    mark_section(loader, "belts", "between");
    mark_section(loader, "cams", "cam");
}

const YkNode *yk_load_two_values(YkLoader *loader, const YkNode *map, const char *key, const YkSubject *subject)
{
    const YkNode *list = yk_load_require(loader, map, key, subject);
    if (!list) return NULL;
    const YkSubject inner = {.noun = key, .owner = subject->part};
    if (!yk_load_expect(loader, list, YK_NODE_LIST, &inner)) return NULL;
    if (list->count == 2) return list;
    yk_problem(loader->problems, YK_CODE_COMPONENTS, list->place, "%s has two entries, first and second; here are %z",
               yk_load_subject(loader, &inner), list->count);
    return NULL;
}

void yk_load_two_bodies(YkLoader *loader, const YkNode *list, const YkSubject *subject, int32_t body[2])
{
    if (!list) return;
    for (int k = 0; k < 2; k++) body[k] = yk_load_body(loader, list->items[k]);
    if (body[0] == YK_NONE || body[0] != body[1]) return;
    yk_problem(loader->problems, YK_CODE_SELF_MESH, list->place, "%s: %q cannot drive itself",
               yk_load_subject(loader, subject), loader->model->bodies[body[0]].name);
    body[1] = YK_NONE;
}

bool yk_load_yes_or_no(YkLoader *loader, const YkNode *map, const char *key, const YkSubject *subject)
{
    const YkNode *node = yk_node_get(map, key);
    if (!node || !yk_load_expect(loader, node, YK_NODE_SCALAR, &(YkSubject){.noun = key, .owner = subject->part}))
        return false;
    if (strcmp(node->text, "true") == 0 || strcmp(node->text, "false") == 0) return node->text[0] == 't';
    yk_problem(loader->problems, YK_CODE_WRONG_WORD, node->place, "`%s` of %q is `true` or `false`, not %q", key,
               subject->part, node->text);
    return false;
}

int32_t yk_load_carrier(YkLoader *loader, const YkNode *map)
{
    const YkNode *node = yk_node_get(map, "carrier");
    if (!node) return YK_NONE;
    int32_t body = yk_load_body(loader, node);
    return body == YK_NONE ? YK_REPORTED : body;
}

// --- axes

// The bodies that turn about one axis, each with the axis's place on it.
typedef struct Axis {
    bool *has; // per body
    YkVec *at; // per body, if it has the axis
    size_t count;
} Axis;

static bool coincide(YkVec a, YkVec b)
{
    YkVec apart = yk_sub(a, b);
    return yk_hypot(apart.x, apart.y) <= 1e-9 * fmax(yk_hypot(a.x, a.y), yk_hypot(b.x, b.y));
}

static bool turns_about_a_point(const YkJoint *joint)
{
    return (joint->kind == YK_PIN || joint->kind == YK_WELD) && joint->body[0] != YK_NONE && joint->body[1] != YK_NONE;
}

// Extends the axis by the joints that lie on it, until no joint adds a body.
static void follow(const YkModel *model, Axis *axis)
{
    for (bool grows = true; grows;) {
        grows = false;
        for (size_t i = 0; i < model->joint_count; i++) {
            const YkJoint *joint = &model->joints[i];
            if (!turns_about_a_point(joint)) continue;
            for (int k = 0; k < 2; k++) {
                int32_t from = joint->body[k], to = joint->body[1 - k];
                if (!axis->has[from] || axis->has[to] || !coincide(axis->at[from], joint->at[k])) continue;
                axis->has[to] = grows = true;
                axis->at[to] = joint->at[1 - k];
                axis->count++;
            }
        }
    }
}

// Returns the axis through a wheel's centre.
static Axis axis_of(YkLoader *loader, int32_t wheel)
{
    size_t count = loader->model->body_count;
    Axis axis = {.has = YK_NEW(loader->arena, bool, count), .at = YK_NEW(loader->arena, YkVec, count)};
    if (!axis.has || !axis.at) return axis;
    axis.has[wheel] = true;
    axis.count = 1;
    follow(loader->model, &axis);
    return axis;
}

static void report_no_carrier(YkLoader *loader, const YkWheelPair *pair, const Axis axes[2])
{
    const YkBody *bodies = loader->model->bodies;
    const char *a = bodies[pair->body[0]].name, *b = bodies[pair->body[1]].name;
    for (int k = 0; k < 2; k++) {
        if (axes[k].count > 1) continue;
        yk_problem(loader->problems, YK_CODE_NO_CARRIER, pair->place, "%s %q: no pin holds the centre of %q",
                   pair->noun, pair->name, k == 0 ? a : b);
        yk_problem_hint(loader->problems, "a wheel's centre is the origin of its body; pin it to what carries it");
        return;
    }
    yk_problem(loader->problems, YK_CODE_NO_CARRIER, pair->place, "%s %q: no body holds the centres of both %q and %q",
               pair->noun, pair->name, a, b);
    yk_problem_hint(loader->problems, "pin both to one body, each at a point of its own");
}

// Returns a pin of the wheel whose point is given on neither body: it lies at the origin of the other body, *other.
static const YkJoint *pin_at_origin(const YkModel *model, int32_t wheel, int32_t *other)
{
    for (size_t i = 0; i < model->joint_count; i++) {
        const YkJoint *joint = &model->joints[i];
        if (joint->kind != YK_PIN || joint->point[0] != YK_NONE || joint->point[1] != YK_NONE) continue;
        if (joint->body[0] != wheel && joint->body[1] != wheel) continue;
        *other = joint->body[joint->body[0] == wheel ? 1 : 0];
        return joint;
    }
    return NULL;
}

static const YkPoint *point_off_origin(const YkModel *model, const YkBody *body)
{
    for (int32_t p = body->first_point; p < body->first_point + body->point_count; p++)
        if (!coincide(model->points[p].at, (YkVec){0, 0})) return &model->points[p];
    return NULL;
}

// Reports that more than one body could carry wheels that turn about one axis, which cannot mesh: one of their pins
// should lie elsewhere.
static bool report_one_axis(YkLoader *loader, const YkWheelPair *pair, const Axis axes[2])
{
    const YkBody *bodies = loader->model->bodies;
    const int32_t *wheel = pair->body;
    if (!axes[0].has[wheel[1]] || !coincide(axes[0].at[wheel[1]], (YkVec){0, 0})) return false;
    yk_problem(loader->problems, YK_CODE_NO_CARRIER, pair->place,
               "%s %q: %q and %q turn about one axis, so the carrier that keeps them apart is not known", pair->noun,
               pair->name, bodies[wheel[0]].name, bodies[wheel[1]].name);
    int32_t other[2] = {YK_NONE, YK_NONE};
    const YkJoint *pins[2] = {pin_at_origin(loader->model, wheel[0], &other[0]),
                              pin_at_origin(loader->model, wheel[1], &other[1])};
    int k = other[1] > 0 || !pins[0] || other[0] <= 0 ? 1 : 0; // prefers the pin on a body that moves
    const YkPoint *point = pins[k] ? point_off_origin(loader->model, &bodies[other[k]]) : NULL;
    if (point)
        yk_problem_hint(loader->problems, "pin %q lies at the origin of %q; name its point there, as in `at: %s`",
                        pins[k]->name, bodies[other[k]].name, point->name);
    else if (pins[k])
        yk_problem_hint(loader->problems,
                        "pin %q lies at the origin of %q; put it where it belongs: `%s: {points: {%s: [a, 0]}}`, with "
                        "the distance `a` of the centres",
                        pins[k]->name, bodies[other[k]].name, bodies[other[k]].name, pins[k]->name);
    else
        yk_problem_hint(loader->problems, "pin one of them to another point of the body that carries both");
    return true;
}

// Returns the one body that can be the carrier; YK_NONE, reported, if there is none or more than one.
static int32_t infer(YkLoader *loader, const YkWheelPair *pair, const Axis axes[2])
{
    const YkModel *model = loader->model;
    int32_t found = YK_NONE;
    for (int32_t b = 0; b < (int32_t)model->body_count; b++) {
        if (!axes[0].has[b] || !axes[1].has[b] || b == pair->body[0] || b == pair->body[1]) continue;
        if (found != YK_NONE) {
            if (report_one_axis(loader, pair, axes)) return YK_NONE;
            yk_problem(loader->problems, YK_CODE_NO_CARRIER, pair->place, "%s %q: both %q and %q hold the two centres",
                       pair->noun, pair->name, model->bodies[found].name, model->bodies[b].name);
            yk_problem_hint(loader->problems, "say which with `carrier: %s`", model->bodies[found].name);
            return YK_NONE;
        }
        found = b;
    }
    if (found == YK_NONE) report_no_carrier(loader, pair, axes);
    return found;
}

static int32_t check_given(YkLoader *loader, const YkWheelPair *pair, const Axis axes[2])
{
    const YkBody *bodies = loader->model->bodies;
    const char *carrier = bodies[pair->carrier].name;
    if (pair->carrier == pair->body[0] || pair->carrier == pair->body[1]) {
        yk_problem(loader->problems, YK_CODE_NO_CARRIER, pair->place, "%s %q: %q cannot carry itself", pair->noun,
                   pair->name, carrier);
        return YK_NONE;
    }
    for (int k = 0; k < 2; k++) {
        if (axes[k].has[pair->carrier]) continue;
        yk_problem(loader->problems, YK_CODE_NO_CARRIER, pair->place,
                   "%s %q: the carrier %q does not hold the centre of %q", pair->noun, pair->name, carrier,
                   bodies[pair->body[k]].name);
        yk_problem_hint(loader->problems, "pin %q to %q; a wheel's centre is the origin of its body",
                        bodies[pair->body[k]].name, carrier);
        return YK_NONE;
    }
    return pair->carrier;
}

int32_t yk_load_find_carrier(YkLoader *loader, const YkWheelPair *pair, double *distance, YkVec center[2])
{
    *distance = 0;
    if (loader->has_bad_joint || pair->body[0] == YK_NONE || pair->body[1] == YK_NONE) return YK_NONE;
    if (pair->carrier == YK_REPORTED) return YK_NONE;
    const Axis axes[2] = {axis_of(loader, pair->body[0]), axis_of(loader, pair->body[1])};
    if (yk_arena_failed(loader->arena)) return YK_NONE;
    int32_t carrier = pair->carrier == YK_NONE ? infer(loader, pair, axes) : check_given(loader, pair, axes);
    if (carrier == YK_NONE) return YK_NONE;
    *distance = yk_norm(yk_sub(axes[0].at[carrier], axes[1].at[carrier]));
    for (int k = 0; center && k < 2; k++) center[k] = axes[k].at[carrier];
    return carrier;
}
