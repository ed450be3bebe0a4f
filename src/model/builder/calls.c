// The builder's calls: each adds an entry of a file.
#include <string.h>
#include "model/builder/builder.h"

static YkBranch *section(YkBuilder *builder, const char *name)
{
    return yk_branch_map(builder, builder->root, name);
}

static void put_text(YkBuilder *builder, YkBranch *map, const char *key, const char *text)
{
    if (map && text) yk_branch_put(builder, map, key, yk_branch_scalar(builder, text));
}

static void put_number(YkBuilder *builder, YkBranch *map, const char *key, double value)
{
    if (map) yk_branch_put(builder, map, key, yk_branch_number(builder, value));
}

// A list of two, in the map.
static void put_two(YkBuilder *builder, YkBranch *map, const char *key, YkBranch *first, YkBranch *second)
{
    YkBranch *list = map ? yk_branch_new(builder, YK_NODE_LIST) : NULL;
    yk_branch_add(builder, list, first);
    yk_branch_add(builder, list, second);
    yk_branch_put(builder, map, key, list);
}

static void put_numbers(YkBuilder *builder, YkBranch *map, const char *key, double first, double second)
{
    YkBranch *one = yk_branch_number(builder, first), *other = yk_branch_number(builder, second);
    put_two(builder, map, key, one, other);
}

static void put_texts(YkBuilder *builder, YkBranch *map, const char *key, const char *first, const char *second)
{
    YkBranch *one = yk_branch_scalar(builder, first), *other = yk_branch_scalar(builder, second);
    put_two(builder, map, key, one, other);
}

// Says the same thing of the same name twice? A file would refuse the second, too.
static bool is_new(YkBuilder *builder, const YkBranch *map, const char *noun, const char *name)
{
    if (!yk_branch_get(map, name)) return true;
    yk_problem(builder->problems, YK_CODE_YAML_DUPLICATE_KEY, (YkPlace){0}, "the %s %q is given twice", noun, name);
    yk_problem_hint(builder->problems, "yk_builder_set replaces what was given");
    return false;
}

// A new entry of a section; NULL if it exists already (reported).
static YkBranch *entry(YkBuilder *builder, const char *section_name, const char *noun, const char *name)
{
    YkBranch *map = section(builder, section_name);
    return map && is_new(builder, map, noun, name) ? yk_branch_map(builder, map, name) : NULL;
}

static void hint_body(YkBuilder *builder, const YkBranch *bodies, const char *name)
{
    size_t count = bodies ? bodies->node.count : 0;
    const char **names = YK_NEW(builder->arena, const char *, count + 1);
    for (size_t i = 0; names && i < count; i++) names[i] = bodies->node.pairs[i].key->text;
    const char *nearest = names ? yk_nearest(name, names, count) : NULL;
    if (nearest)
        yk_problem_hint(builder->problems, "did you mean %q?", nearest);
    else
        yk_problem_hint(builder->problems, "yk_builder_body makes a body");
}

static YkBranch *body(YkBuilder *builder, const char *name)
{
    YkBranch *bodies = section(builder, "bodies");
    if (strcmp(name, "ground") == 0 || !bodies || yk_branch_get(bodies, name))
        return yk_branch_map(builder, bodies, name);
    yk_problem(builder->problems, YK_CODE_UNKNOWN_BODY, (YkPlace){0}, "there is no body %q", name);
    hint_body(builder, bodies, name);
    return NULL;
}

void yk_builder_parameter(YkBuilder *builder, const char *name, const char *value)
{
    YkBranch *map = section(builder, "parameters");
    if (map && is_new(builder, map, "parameter", name)) put_text(builder, map, name, value);
}

void yk_builder_gravity(YkBuilder *builder, double x, double y)
{
    put_numbers(builder, builder->root, "gravity", x, y);
}

void yk_builder_body(YkBuilder *builder, const char *name)
{
    entry(builder, "bodies", "body", name);
}

void yk_builder_point(YkBuilder *builder, const char *body_name, const char *point, double x, double y)
{
    YkBranch *of = body(builder, body_name);
    YkBranch *points = of ? yk_branch_map(builder, of, "points") : NULL;
    if (points && is_new(builder, points, "point", point)) put_numbers(builder, points, point, x, y);
}

void yk_builder_mass(YkBuilder *builder, const char *body_name, double mass, double center_x, double center_y,
                     double inertia)
{
    YkBranch *of = body(builder, body_name);
    if (!of) return;
    put_number(builder, of, "mass", mass);
    put_numbers(builder, of, "center", center_x, center_y);
    put_number(builder, of, "inertia", inertia);
}

void yk_builder_rod(YkBuilder *builder, const char *body_name, double mass, const char *from, const char *to)
{
    YkBranch *of = body(builder, body_name);
    if (!of) return;
    put_number(builder, of, "mass", mass);
    put_texts(builder, of, "rod", from, to);
}

static YkBranch *joint(YkBuilder *builder, const char *name, const char *kind, const char *first, const char *second)
{
    YkBranch *map = entry(builder, "joints", "joint", name);
    if (map) put_texts(builder, map, kind, first, second);
    return map;
}

void yk_builder_pin(YkBuilder *builder, const char *name, const char *first, const char *second, const char *at,
                    const char *angle)
{
    YkBranch *map = joint(builder, name, "pin", first, second);
    put_text(builder, map, "at", at);
    put_text(builder, map, "angle", angle);
}

void yk_builder_weld(YkBuilder *builder, const char *name, const char *first, const char *second, const char *at)
{
    put_text(builder, joint(builder, name, "weld", first, second), "at", at);
}

void yk_builder_free_joint(YkBuilder *builder, const char *name, const char *first, const char *second,
                           const char *from, const char *to, const char *x, const char *y, const char *angle)
{
    YkBranch *map = joint(builder, name, "free", first, second);
    const char *const names[] = {x, y, angle};
    YkBranch *at = map && x && y && angle ? yk_branch_new(builder, YK_NODE_LIST) : NULL;
    for (size_t k = 0; at && k < 3; k++) yk_branch_add(builder, at, yk_branch_scalar(builder, names[k]));
    if (at) yk_branch_put(builder, map, "at", at);
    put_text(builder, map, "from", from);
    put_text(builder, map, "to", to);
}

void yk_builder_slide(YkBuilder *builder, const char *name, const char *first, const char *second, const char *along,
                      const char *from, const char *to, const char *distance)
{
    YkBranch *map = joint(builder, name, "slide", first, second);
    put_text(builder, map, "along", along);
    put_text(builder, map, "from", from);
    put_text(builder, map, "to", to);
    put_text(builder, map, "distance", distance);
}

void yk_builder_slot(YkBuilder *builder, const char *name, const char *first, const char *second, const char *along,
                     const char *from, const char *at, const char *distance, const char *angle)
{
    YkBranch *map = joint(builder, name, "pin-slot", first, second);
    put_text(builder, map, "along", along);
    put_text(builder, map, "from", from);
    put_text(builder, map, "at", at);
    put_text(builder, map, "distance", distance);
    put_text(builder, map, "angle", angle);
}

void yk_builder_drive(YkBuilder *builder, const char *coordinate, const char *value)
{
    YkBranch *map = section(builder, "drives");
    if (map && is_new(builder, map, "drive of", coordinate)) put_text(builder, map, coordinate, value);
}

void yk_builder_start(YkBuilder *builder, const char *coordinate, double value)
{
    YkBranch *map = section(builder, "start");
    if (map && is_new(builder, map, "start of", coordinate)) put_number(builder, map, coordinate, value);
}

void yk_builder_effort(YkBuilder *builder, const char *coordinate, const char *value)
{
    YkBranch *map = section(builder, "efforts");
    if (map && is_new(builder, map, "effort along", coordinate)) put_text(builder, map, coordinate, value);
}

void yk_builder_force(YkBuilder *builder, const char *name, const char *body_name, const char *point, const char *x,
                      const char *y)
{
    YkBranch *map = entry(builder, "forces", "force", name);
    if (!map) return;
    put_text(builder, map, "body", body_name);
    put_text(builder, map, "at", point);
    put_texts(builder, map, "value", x, y);
}

void yk_builder_spring(YkBuilder *builder, const char *name, const char *from, const char *to, double stiffness,
                       double length, double damping)
{
    YkBranch *map = entry(builder, "springs", "spring", name);
    if (!map) return;
    put_texts(builder, map, "between", from, to);
    put_number(builder, map, "stiffness", stiffness);
    put_number(builder, map, "length", length);
    put_number(builder, map, "damping", damping);
}

// Is the coordinate the distance of a joint? Then the spring's free value is a length.
static bool is_distance(const YkBuilder *builder, const char *coordinate)
{
    const YkBranch *joints = yk_branch_get(builder->root, "joints");
    for (size_t i = 0; joints && i < joints->node.count; i++) {
        const YkNode *name = yk_node_get(joints->node.pairs[i].value, "distance");
        if (name && name->kind == YK_NODE_SCALAR && strcmp(name->text, coordinate) == 0) return true;
    }
    const char *dot = strrchr(coordinate, '.');
    return dot && strcmp(dot, ".distance") == 0;
}

void yk_builder_spring_along(YkBuilder *builder, const char *name, const char *coordinate, double stiffness,
                             double free_value, double damping)
{
    YkBranch *map = entry(builder, "springs", "spring", name);
    if (!map) return;
    put_text(builder, map, "along", coordinate);
    put_number(builder, map, "stiffness", stiffness);
    put_number(builder, map, is_distance(builder, coordinate) ? "length" : "angle", free_value);
    put_number(builder, map, "damping", damping);
}

void yk_builder_stop(YkBuilder *builder, const char *coordinate, double low, double high)
{
    YkBranch *map = section(builder, "stops");
    if (map && is_new(builder, map, "stop of", coordinate)) put_numbers(builder, map, coordinate, low, high);
}

void yk_builder_gear(YkBuilder *builder, const char *name, const char *first, const char *second, int first_teeth,
                     int second_teeth)
{
    YkBranch *map = entry(builder, "gears", "mesh of gears", name);
    if (!map) return;
    put_texts(builder, map, "mesh", first, second);
    put_numbers(builder, map, "teeth", first_teeth, second_teeth);
}

void yk_builder_rack(YkBuilder *builder, const char *name, const char *pinion, const char *rack, double radius)
{
    YkBranch *map = entry(builder, "racks", "rack", name);
    put_text(builder, map, "pinion", pinion);
    put_text(builder, map, "rack", rack);
    put_number(builder, map, "radius", radius);
}

void yk_builder_belt(YkBuilder *builder, const char *name, const char *first, const char *second, double first_radius,
                     double second_radius)
{
    YkBranch *map = entry(builder, "belts", "belt", name);
    if (!map) return;
    put_texts(builder, map, "between", first, second);
    put_numbers(builder, map, "radii", first_radius, second_radius);
}
