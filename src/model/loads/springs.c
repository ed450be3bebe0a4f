// Reads `springs:`, springs with dampers and pulls by laws of their own, between two points or along a coordinate.
#include "model/load.h"

// Between points, along a distance, or along an angle: this decides the units, and the name of the free value.
typedef enum Form { BETWEEN, ALONG_DISTANCE, ALONG_ANGLE } Form;

static void read_ends(YkLoader *loader, YkSpring *spring, const YkNode *ends)
{
    const YkSubject subject = {.noun = "between", .owner = spring->name};
    if (!yk_load_expect(loader, ends, YK_NODE_LIST, &subject)) return;
    if (ends->count != 2) {
        yk_problem(loader->problems, YK_CODE_COMPONENTS, ends->place, "%s names two points; here are %z",
                   yk_load_subject(loader, &subject), ends->count);
        return;
    }
    for (int k = 0; k < 2; k++) spring->point[k] = yk_load_body_point(loader, ends->items[k], &spring->body[k]);
}

static void read_coordinate(YkLoader *loader, YkSpring *spring, const YkNode *along)
{
    const YkSubject subject = {.noun = "along", .owner = spring->name};
    if (!yk_load_expect(loader, along, YK_NODE_SCALAR, &subject)) return;
    int32_t coordinate = yk_load_coordinate_key(loader, along, NULL);
    if (coordinate >= 0) spring->coordinate = coordinate;
}

// Reads where the spring acts. Returns false if that is unknown, since its units then are as well.
static bool read_place(YkLoader *loader, YkSpring *spring, const YkNode *node, Form *form)
{
    const YkSubject subject = {.noun = "spring", .part = spring->name};
    const YkNode *along = yk_node_get(node, "along"), *between = yk_node_get(node, "between");
    *form = BETWEEN;
    if (along && between) {
        yk_problem(loader->problems, YK_CODE_RIVAL_KEYS, yk_load_key(node, "between")->place,
                   "spring %q acts along a coordinate already; it cannot act between points as well", spring->name);
        return false;
    }
    if (!along) between = yk_load_require(loader, node, "between", &subject);
    if (between) read_ends(loader, spring, between);
    if (!along) return true;
    read_coordinate(loader, spring, along);
    if (spring->coordinate == YK_NONE) return false;
    *form = loader->model->coordinates[spring->coordinate].is_distance ? ALONG_DISTANCE : ALONG_ANGLE;
    return true;
}

// Reports the key that belongs to the other kind of spring; returns whether it is there.
static bool refuse_key(YkLoader *loader, const YkSpring *spring, const YkNode *node, Form form, const char *has,
                       const char *other)
{
    static const char *const forms[] = {"lies between points", "lies along a distance", "lies along an angle"};
    const YkNode *wrong = yk_load_key(node, other);
    if (!wrong) return false;
    yk_problem(loader->problems, YK_CODE_UNKNOWN_KEY, wrong->place, "spring %q %s: it has a %s, no `%s`", spring->name,
               forms[form], has, other);
    return true;
}

// Reads the length or angle at which the spring is free. Refuses the key of the other kind.
static void read_free(YkLoader *loader, YkSpring *spring, const YkNode *node, Form form)
{
    const char *key = form == ALONG_ANGLE ? "angle" : "length";
    if (form == ALONG_ANGLE)
        refuse_key(loader, spring, node, form, "free `angle`", "length");
    else
        refuse_key(loader, spring, node, form, "free `length`", "angle");
    YkWant want = {.dimension = form == ALONG_ANGLE ? YK_DIM_ANGLE : YK_DIM_LENGTH,
                   .subject = {.noun = key, .owner = spring->name}};
    spring->length_expr = yk_load_key_value(loader, node, key, &want, &spring->length);
}

static void read_rates(YkLoader *loader, YkSpring *spring, const YkNode *node, Form form)
{
    YkWant want = {.subject = {.noun = "stiffness", .owner = spring->name}};
    want.dimension = form == ALONG_ANGLE ? YK_DIM_TURN_STIFFNESS : YK_DIM_STIFFNESS;
    spring->stiffness_expr = yk_load_key_value(loader, node, "stiffness", &want, &spring->stiffness);
    want.subject.noun = "damping";
    want.dimension = form == ALONG_ANGLE ? YK_DIM_TURN_DAMPING : YK_DIM_DAMPING;
    spring->damping_expr = yk_load_key_value(loader, node, "damping", &want, &spring->damping);
}

// Reads the pull by a law of its own, `force`, or along an angle `torque`: what `length`, or `angle`, and `rate` mean
// in it is the spring's own.
static void read_force(YkLoader *loader, YkSpring *spring, const YkNode *node, Form form)
{
    const char *key = form == ALONG_ANGLE ? "torque" : "force";
    if (form == ALONG_ANGLE ? refuse_key(loader, spring, node, form, "`torque`", "force")
                            : refuse_key(loader, spring, node, form, "`force`", "torque"))
        return;
    const YkNode *force = yk_node_get(node, key);
    const char *along = form == BETWEEN ? NULL : loader->model->coordinates[spring->coordinate].name;
    const char *whose = "the spring's own";
    const YkOwnName own[] = {{form == ALONG_ANGLE ? "angle" : "length", along ? along : YK_OWN_LENGTH, whose},
                             {"rate", along ? yk_load_rate_name(loader, along) : YK_OWN_RATE, whose},
                             {NULL, NULL, NULL}};
    YkWant want = {.dimension = form == ALONG_ANGLE ? YK_DIM_TORQUE : YK_DIM_FORCE,
                   .scope = YK_SCOPE_STATE,
                   .subject = {.noun = key, .owner = spring->name},
                   .own = own};
    if (force) spring->force = yk_load_strength(loader, force, &want);
    if (force || yk_node_get(node, "stiffness") || yk_node_get(node, "damping")) return;
    yk_problem(loader->problems, YK_CODE_MISSING_KEY, node->place, "spring %q needs `stiffness`, `damping` or `%s`",
               spring->name, key);
}

// Warns about a free length or angle that has no effect: only `stiffness` acts from it.
static void check_free(YkLoader *loader, const YkSpring *spring, const YkNode *node, Form form)
{
    const char *key = form == ALONG_ANGLE ? "angle" : "length";
    const YkNode *given = yk_node_get(node, key);
    if (!given || yk_node_get(node, "stiffness")) return;
    yk_problem(loader->problems, YK_CODE_FREE_UNUSED, given->place,
               "the free %s of spring %q has no effect, since the spring has no `stiffness`", key, spring->name);
    if (yk_node_get(node, form == ALONG_ANGLE ? "torque" : "force"))
        yk_problem_hint(loader->problems, "let the spring's own law contain it, as in `%s - %s`", key,
                        form == ALONG_ANGLE ? "phi0" : "l0");
    else
        yk_problem_hint(loader->problems, "give a `stiffness`, or remove `%s`", key);
}

static void read_spring(YkLoader *loader, YkSpring *spring, const YkNode *node)
{
    static const char *const keys[] = {"between", "along", "stiffness", "length", "angle",
                                       "damping", "force", "torque",    NULL};
    const YkSubject subject = {.noun = "spring", .part = spring->name};
    Form form;
    if (!yk_load_expect(loader, node, YK_NODE_MAP, &subject)) return;
    yk_load_check_keys(loader, node, keys, &subject);
    if (!read_place(loader, spring, node, &form)) return;
    read_free(loader, spring, node, form);
    read_rates(loader, spring, node, form);
    read_force(loader, spring, node, form);
    check_free(loader, spring, node, form);
}

void yk_load_springs(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "springs");
    YkModel *model = loader->model;
    if (!section) return;
    model->springs = YK_NEW(loader->arena, YkSpring, section->count);
    if (!model->springs) return;
    for (size_t i = 0; i < section->count; i++) {
        const YkNodePair *pair = &section->pairs[i];
        YkSpring *spring = &model->springs[model->spring_count++];
        *spring = (YkSpring){.name = pair->key->text,
                             .place = pair->key->place,
                             .coordinate = YK_NONE,
                             .body = {YK_NONE, YK_NONE},
                             .point = {YK_NONE, YK_NONE},
                             .force = {.law = YK_NONE}};
        yk_load_name(loader, pair->key, "spring");
        read_spring(loader, spring, pair->value);
    }
}

static void tell_negative(YkLoader *loader, const YkSpring *spring, const YkExpr *expr, double value, YkCode code,
                          const char *noun, YkDimension dimension)
{
    if (!expr || !(value < 0)) return;
    const char *message = "the %s of spring %q is %e %s; it cannot be negative";
    if (code == YK_CODE_NEGATIVE_STIFFNESS)
        message = yk_dimension_equal(dimension, YK_DIM_TURN_STIFFNESS)
                      ? "the %s of spring %q is %e %s; it pushes away from its free angle"
                      : "the %s of spring %q is %e %s; it pushes away from its free length";
    yk_load_refuse_amount(loader, code, expr, value, dimension, message, noun, spring->name);
}

void yk_load_finish_springs(YkLoader *loader)
{
    YkModel *model = loader->model;
    for (size_t i = 0; i < model->spring_count; i++) {
        YkSpring *spring = &model->springs[i];
        for (int k = 0; k < 2; k++) {
            if (spring->point[k] != YK_NONE) spring->at[k] = model->points[spring->point[k]].at;
        }
        bool turns = spring->coordinate != YK_NONE && !model->coordinates[spring->coordinate].is_distance;
        tell_negative(loader, spring, spring->stiffness_expr, spring->stiffness, YK_CODE_NEGATIVE_STIFFNESS,
                      "stiffness", turns ? YK_DIM_TURN_STIFFNESS : YK_DIM_STIFFNESS);
        tell_negative(loader, spring, spring->damping_expr, spring->damping, YK_CODE_BAD_DAMPING, "damping",
                      turns ? YK_DIM_TURN_DAMPING : YK_DIM_DAMPING);
        if (spring->coordinate != YK_NONE) continue;
        tell_negative(loader, spring, spring->length_expr, spring->length, YK_CODE_BAD_LENGTH, "free length",
                      YK_DIM_LENGTH);
    }
}
