// Finds the dimensions of a law's argument and of its values.
//
// The rule: an entry with a unit decides - any number of the law, or a parameter that has one. If there is none, the
// use decides: `efforts: {d5: {law: cutting, of: d5}}` makes it a force over a length. If there is no use either, it is
// a length over an angle, as for a cam. Bare numbers are then in the file's units of these dimensions.
#include <stdlib.h>
#include <string.h>
#include "base/letters.h"
#include "model/laws/read.h"

typedef enum Axis { OF, VALUE, AXES } Axis;

// Expressions that may reveal a dimension through a parameter in them.
typedef struct Names {
    YkExpr **exprs;
    size_t count, capacity;
} Names;

typedef struct Search {
    YkLoader *loader;
    YkDimension dimension[AXES];
    bool is_known[AXES];
    Names names[AXES];
} Search;

static bool has_letter(const char *text)
{
    for (; *text; text++) {
        if (yk_is_letter(*text)) return true;
    }
    return false;
}

// Notes a dimension. A plain number reveals none: it may be a parameter without a unit, which takes the dimension of
// its use.
static void show(Search *search, Axis axis, YkDimension dimension)
{
    if (search->is_known[axis] || (yk_dimension_equal(dimension, YK_DIM_NUMBER) && dimension.angle == 0)) return;
    search->is_known[axis] = true;
    search->dimension[axis] = dimension;
}

static void consider(Search *search, const YkNode *node, Axis axis)
{
    if (!node || node->kind != YK_NODE_SCALAR || search->is_known[axis] || !has_letter(node->text)) return;
    // Mistakes in it are reported when the value itself is read.
    YkExpr *expr = yk_expr_parse(node->text, node->length, node->place, search->loader->arena, NULL);
    const YkExpr *number = expr;
    while (number && number->kind == YK_EXPR_NEGATE) number = number->a;
    Names *names = &search->names[axis];
    if (!number) return;
    if (number->kind == YK_EXPR_NUMBER && number->has_unit) {
        show(search, axis, number->unit);
    } else if (YK_ROOM(names->exprs, names->count, names->capacity)) {
        names->exprs[names->count++] = expr;
    } else {
        search->loader->failed = true;
    }
}

static void consider_conditions(Search *search, const YkNode *list)
{
    if (!list || list->kind != YK_NODE_LIST) return;
    for (size_t i = 0; i < list->count; i++) {
        consider(search, yk_node_get(list->items[i], "at"), OF);
        consider(search, yk_node_get(list->items[i], "s"), VALUE);
    }
}

static void consider_segments(Search *search, const YkNode *segments)
{
    if (!segments || segments->kind != YK_NODE_LIST) return;
    for (size_t i = 0; i < segments->count; i++) {
        const YkNode *segment = segments->items[i];
        for (size_t k = 0; segment->kind == YK_NODE_MAP && k < segment->count; k++) {
            const YkNode *inner = segment->pairs[k].value;
            consider_conditions(search, inner);
            consider_conditions(search, yk_node_get(inner, "through"));
            consider(search, yk_node_get(inner, "to"), OF);
            consider(search, yk_node_get(inner, "by"), VALUE);
        }
    }
}

static void consider_table(Search *search, const YkNode *table)
{
    if (!table || table->kind != YK_NODE_LIST) return;
    for (size_t i = 0; i < table->count; i++) {
        const YkNode *point = table->items[i];
        if (point->kind != YK_NODE_LIST || point->count != 2) continue;
        consider(search, point->items[0], OF);
        consider(search, point->items[1], VALUE);
    }
}

// Infers what the expressions with names reveal: each is treated like a parameter of its own among those of the file.
static void ask_parameters(Search *search, Axis axis)
{
    YkLoader *loader = search->loader;
    const YkModel *model = loader->model;
    Names *names = &search->names[axis];
    YkDimensions *dimensions = yk_dimensions_new(loader->arena, &model->units);
    char(*own)[24] = yk_arena_alloc(loader->arena, names->count, sizeof *own);
    if (!dimensions || !own) return;
    yk_dimensions_fix(dimensions, "pi", YK_DIM_NUMBER);
    for (size_t i = 0; i < model->parameter_count; i++) {
        const YkParameter *parameter = &model->parameters[i];
        if (parameter->expr) yk_dimensions_parameter(dimensions, parameter->name, parameter->expr);
    }
    for (size_t i = 0; i < names->count; i++) {
        size_t rest = i;
        char *name = own[i];
        *name++ = '#'; // no name of the file contains it
        do *name++ = (char)('0' + rest % 10);
        while ((rest /= 10) > 0);
        yk_dimensions_parameter(dimensions, own[i], names->exprs[i]);
    }
    yk_dimensions_run(dimensions, NULL);
    for (size_t i = 0; i < names->count && !search->is_known[axis]; i++) {
        YkDimension dimension;
        if (yk_dimensions_of(dimensions, own[i], &dimension)) show(search, axis, dimension);
    }
}

// Finds whether the coordinate of this name is a distance. Returns false if there is no such coordinate.
static bool find_coordinate(const YkModel *model, const char *name, bool *is_distance)
{
    int32_t index = yk_names_find(&model->coordinate_names, name);
    const char *ending = strrchr(name, '.');
    if (index != YK_NONE) *is_distance = model->coordinates[index].is_distance;
    if (index == YK_NONE && ending) *is_distance = strcmp(ending, ".distance") == 0;
    return index != YK_NONE || (ending && (*is_distance || strcmp(ending, ".angle") == 0));
}

static bool is_of(const YkNode *use, const char *law)
{
    const YkNode *name = use->kind == YK_NODE_MAP ? yk_node_get(use, "law") : NULL;
    return name && name->kind == YK_NODE_SCALAR && strcmp(name->text, law) == 0;
}

// Looks at the argument in {law: NAME, of: ARGUMENT}.
static void ask_argument(Search *search, const YkNode *use)
{
    const YkNode *of = yk_node_get(use, "of");
    bool is_distance = false;
    if (!of || of->kind != YK_NODE_SCALAR) return;
    if (find_coordinate(search->loader->model, of->text, &is_distance))
        show(search, OF, is_distance ? YK_DIM_LENGTH : YK_DIM_ANGLE);
    else if (strcmp(of->text, "t") == 0)
        show(search, OF, YK_DIM_TIME);
}

// Looks at the uses in a section of the form COORDINATE: {law: NAME, of: ARGUMENT}.
static void ask_uses(Search *search, const char *law, const char *section, YkDimension of_angle,
                     YkDimension of_distance)
{
    const YkNode *map = yk_node_get(search->loader->root, section);
    for (size_t i = 0; map && map->kind == YK_NODE_MAP && i < map->count; i++) {
        const YkNodePair *pair = &map->pairs[i];
        bool is_distance = false;
        if (!is_of(pair->value, law)) continue;
        if (find_coordinate(search->loader->model, pair->key->text, &is_distance))
            show(search, VALUE, is_distance ? of_distance : of_angle);
        ask_argument(search, pair->value);
    }
}

// Looks at the springs whose force is the law's, with `length`, `angle` and `rate` for their own.
static void ask_springs(Search *search, const char *law)
{
    const struct {
        const char *key, *of;
        YkDimension value, position, rate;
    } kinds[] = {{"force", "length", YK_DIM_FORCE, YK_DIM_LENGTH, YK_DIM_SPEED},
                 {"torque", "angle", YK_DIM_TORQUE, YK_DIM_ANGLE, YK_DIM_ANGLE_RATE}};
    const YkNode *map = yk_node_get(search->loader->root, "springs");
    for (size_t i = 0; map && map->kind == YK_NODE_MAP && i < map->count; i++)
        for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
            const YkNode *use = yk_node_get(map->pairs[i].value, kinds[k].key), *of;
            if (!use || !is_of(use, law)) continue;
            show(search, VALUE, kinds[k].value);
            of = yk_node_get(use, "of");
            bool is_name = of && of->kind == YK_NODE_SCALAR;
            if (is_name && strcmp(of->text, kinds[k].of) == 0) show(search, OF, kinds[k].position);
            if (is_name && strcmp(of->text, "rate") == 0) show(search, OF, kinds[k].rate);
            ask_argument(search, use);
        }
}

// Looks at the forces whose components or moment are the law's.
static void ask_forces(Search *search, const char *law)
{
    const YkNode *map = yk_node_get(search->loader->root, "forces");
    for (size_t i = 0; map && map->kind == YK_NODE_MAP && i < map->count; i++) {
        const YkNode *value = yk_node_get(map->pairs[i].value, "value");
        const YkNode *moment = yk_node_get(map->pairs[i].value, "moment");
        for (size_t k = 0; value && value->kind == YK_NODE_LIST && k < value->count; k++) {
            if (!is_of(value->items[k], law)) continue;
            show(search, VALUE, YK_DIM_FORCE);
            ask_argument(search, value->items[k]);
        }
        if (!moment || !is_of(moment, law)) continue;
        show(search, VALUE, YK_DIM_TORQUE);
        ask_argument(search, moment);
    }
}

// Looks at the cams that use the law: a sliding follower needs a length, a pinned one an angle, both over an angle.
static void ask_cams(Search *search, const char *law)
{
    const YkModel *model = search->loader->model;
    const YkNode *map = yk_node_get(search->loader->root, "cams");
    for (size_t i = 0; map && map->kind == YK_NODE_MAP && i < map->count; i++) {
        const YkNode *name = yk_node_get(map->pairs[i].value, "law");
        const YkNode *follower = yk_node_get(map->pairs[i].value, "follower");
        if (!name || name->kind != YK_NODE_SCALAR || strcmp(name->text, law) != 0) continue;
        show(search, OF, YK_DIM_ANGLE);
        if (!follower || follower->kind != YK_NODE_SCALAR) continue;
        int32_t body = yk_names_find(&model->body_names, follower->text);
        bool slides = false;
        for (size_t k = 0; body != YK_NONE && k < model->joint_count; k++) {
            const YkJoint *joint = &model->joints[k];
            slides |= joint->kind == YK_SLIDE && (joint->body[0] == body || joint->body[1] == body);
        }
        show(search, VALUE, slides ? YK_DIM_LENGTH : YK_DIM_ANGLE);
    }
}

static void find(YkLoader *loader, const YkNode *node, YkModelLaw *law)
{
    Search search = {.loader = loader};
    consider(&search, yk_node_get(node, "from"), OF);
    consider(&search, yk_node_get(node, "period"), OF);
    consider_segments(&search, yk_node_get(node, "segments"));
    consider_table(&search, yk_node_get(node, "table"));
    for (int axis = 0; axis < AXES; axis++) {
        if (!search.is_known[axis] && search.names[axis].count > 0) ask_parameters(&search, (Axis)axis);
        free(search.names[axis].exprs);
    }
    ask_uses(&search, law->name, "drives", YK_DIM_ANGLE, YK_DIM_LENGTH);
    ask_uses(&search, law->name, "efforts", YK_DIM_TORQUE, YK_DIM_FORCE);
    ask_springs(&search, law->name);
    ask_forces(&search, law->name);
    ask_cams(&search, law->name);
    show(&search, OF, YK_DIM_ANGLE);
    show(&search, VALUE, YK_DIM_LENGTH);
    law->of = search.dimension[OF];
    law->value = search.dimension[VALUE];
}

void yk_load_law_dimensions(YkLoader *loader, const YkNode *section)
{
    for (size_t i = 0; i < section->count; i++) find(loader, section->pairs[i].value, &loader->model->laws[i]);
}
