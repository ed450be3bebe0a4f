// Names and symbols: parameters by their dimension, coordinates with rates, time.
#include <string.h>
#include "derive/inside.h"

static bool fits(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.';
}

// Makes a name that the ring accepts: letters, digits, _ and dots, then primes.
static void fit_name(YkText *text, const char *name)
{
    yk_text_clear(text);
    yk_text_puts(text, name);
    for (char *c = text->data; c && *c; c++)
        if (!fits(*c)) *c = '_';
}

enum { FORMS_MAX = 20 }; // of a name in use: NAME, NAME_, NAME__, ...

// Enters a new symbol under the first free form of its name.
static int32_t enter(YkDerivation *d, const char *name, YkRingClass kind, bool is_angle)
{
    size_t length = strlen(name);
    char *form = name == yk_text_lost ? NULL : yk_arena_take(d->arena, length + FORMS_MAX);
    int32_t symbol = -1;
    for (size_t k = 0; form && k < length; k++) form[k] = fits(name[k]) ? name[k] : '_';
    for (size_t more = 0; form && more < FORMS_MAX && symbol < 0 && yk_ring_status(d->ring) == YK_RING_OK; more++) {
        if (more > 0) form[length + more - 1] = '_';
        form[length + more] = '\0';
        symbol = is_angle ? yk_ring_angle(d->ring, form) : yk_ring_symbol(d->ring, form, kind);
        if (symbol < 0 && yk_ring_status(d->ring) == YK_RING_NAME) yk_ring_clear(d->ring); // taken, or reserved
    }
    if (form) yk_arena_give_back(d->arena, form, 0);
    d->failed |= !form;
    return symbol;
}

int32_t yk_derive_symbol(YkDerivation *d, const char *name, YkRingClass kind)
{
    return enter(d, name, kind, false);
}

int32_t yk_derive_angle(YkDerivation *d, const char *name)
{
    return enter(d, name, YK_RING_COORDINATE, true);
}

int32_t yk_derive_find(const YkDerivation *d, const char *name)
{
    YkText text = {0};
    int32_t parameter = yk_names_find(&d->model->parameter_names, name);
    if (parameter != YK_NONE) return d->parameters[parameter];
    fit_name(&text, name);
    int32_t symbol = text.failed ? -1 : yk_ring_find(d->ring, yk_text_get(&text));
    yk_text_free(&text);
    return symbol;
}

// Adds another name for a symbol, first + second, if it is free and can be a name.
static void add_other_name(YkDerivation *d, int32_t symbol, const char *first, const char *second)
{
    YkText text = {0}, name = {0};
    yk_text_format(&name, "%s%s", first, second);
    fit_name(&text, yk_text_get(&name));
    for (size_t i = 0; i < name.length && !text.failed; i++) // primes stay
        if (name.data[i] == '\'') text.data[i] = '\'';
    d->failed |= text.failed || name.failed;
    if (!d->failed && symbol >= 0 && yk_ring_find(d->ring, yk_text_get(&text)) < 0 &&
        !yk_ring_alias(d->ring, symbol, yk_text_get(&text)) && yk_ring_status(d->ring) == YK_RING_NAME)
        yk_ring_clear(d->ring); // the file may use the name, equations cannot
    yk_text_free(&text);
    yk_text_free(&name);
}

static YkRingClass class_of(YkDimension dimension)
{
    dimension.angle = 0;
    if (yk_dimension_equal(dimension, (YkDimension){.mass = 1})) return YK_RING_MASS;
    if (yk_dimension_equal(dimension, (YkDimension){.length = 2, .mass = 1})) return YK_RING_INERTIA;
    if (yk_dimension_equal(dimension, (YkDimension){.length = 1, .time = -2})) return YK_RING_GRAVITY;
    if (dimension.mass == 1 && dimension.time == -2 && dimension.length > 0) return YK_RING_FORCE;
    return YK_RING_CONSTANT;
}

static bool is_angle(YkDimension dimension)
{
    return dimension.length == 0 && dimension.mass == 0 && dimension.time == 0 && dimension.angle == 1;
}

bool yk_derive_enter_parameters(YkDerivation *d)
{
    const YkModel *model = d->model;
    d->time = yk_ring_symbol(d->ring, "t", YK_RING_COORDINATE);
    yk_ring_set_rate(d->ring, d->time, yk_ring_rational(d->ring, 1, 1));
    d->parameters = YK_NEW(d->arena, int32_t, model->parameter_count + 1);
    if (!d->parameters) return false;
    for (size_t k = 0; k < model->parameter_count; k++) {
        const YkParameter *p = &model->parameters[k];
        d->parameters[k] =
            is_angle(p->dimension) ? yk_derive_angle(d, p->name) : yk_derive_symbol(d, p->name, class_of(p->dimension));
        if (d->parameters[k] < 0) return false;
    }
    return true;
}

static bool enter_coordinate(YkDerivation *d, YkDeriveCoordinate *c, const char *name)
{
    c->position = c->is_distance ? yk_derive_symbol(d, name, YK_RING_COORDINATE) : yk_derive_angle(d, name);
    c->rate = yk_ring_rates(d->ring, c->position);
    if (c->rate < 0) return false;
    c->acceleration = c->rate + 1;
    c->name = yk_ring_symbol_name(d->ring, c->position);
    int32_t *place = c->is_distance ? d->joint_distance : d->joint_angle;
    place[c->joint] = (int32_t)(c - d->coordinates);
    return true;
}

static bool is_in_tree(const YkDerivation *d, int32_t joint)
{
    const int32_t *by = d->mech->tree.joint, *body = d->model->joints[joint].body;
    return by[body[0]] == joint || by[body[1]] == joint;
}

// Enters the distances of slides and pin-slots that close loops, which no coordinate of the tree names.
static bool enter_closing_distances(YkDerivation *d)
{
    YkText name = {0};
    bool well = true;
    for (size_t j = 0; j < d->model->joint_count && well; j++) {
        if (!yk_part(d->model->joints[j].kind)->slides || is_in_tree(d, (int32_t)j)) continue;
        YkDeriveCoordinate *c = &d->coordinates[d->coordinate_count++];
        *c = (YkDeriveCoordinate){.joint = (int32_t)j, .is_distance = true, .drive = YK_NONE};
        yk_text_clear(&name);
        yk_text_format(&name, "%s.distance", d->model->joints[j].name);
        well = enter_coordinate(d, c, yk_text_get(&name));
    }
    yk_text_free(&name);
    return well;
}

bool yk_derive_enter_coordinates(YkDerivation *d)
{
    const YkMechanism *mech = d->mech;
    size_t joints = d->model->joint_count;
    d->joint_angle = YK_NEW(d->arena, int32_t, joints + 1);
    d->joint_distance = YK_NEW(d->arena, int32_t, joints + 1);
    d->coordinates = YK_NEW(d->arena, YkDeriveCoordinate, mech->coordinate_count + joints + 1);
    if (yk_arena_failed(d->arena)) return false;
    for (size_t j = 0; j < joints; j++) d->joint_angle[j] = d->joint_distance[j] = YK_NONE;
    for (size_t k = 0; k < mech->coordinate_count; k++) {
        const YkTreeCoordinate *of = &mech->coordinates[k];
        YkDeriveCoordinate *c = &d->coordinates[d->coordinate_count++];
        *c = (YkDeriveCoordinate){.joint = of->joint,
                                  .is_distance = of->is_distance,
                                  .in_tree = true,
                                  .is_input = of->input != YK_NONE,
                                  .is_held = of->drive != YK_NONE && d->model->drives[of->drive].is_hold,
                                  .drive = of->drive};
        if (!enter_coordinate(d, c, of->name)) return false;
    }
    d->tree_count = d->coordinate_count;
    return enter_closing_distances(d);
}

static void name_coordinate(YkDerivation *d, const YkDeriveCoordinate *c)
{
    const char *joint = d->model->joints[c->joint].name;
    static const char *const endings[2][5] = {
        {".angle", ".angle.rate", ".angle.accel", ".angle'", ".angle''"},
        {".distance", ".distance.rate", ".distance.accel", ".distance'", ".distance''"}};
    const int32_t symbols[] = {c->position, c->rate, c->acceleration, c->rate, c->acceleration};
    if (d->model->joints[c->joint].is_free && c->is_distance) return; // it has two
    for (size_t i = 0; i < 5; i++) add_other_name(d, symbols[i], joint, endings[c->is_distance][i]);
}

// Gives a body's angle its name, even if it is a coordinate of the file.
static void name_body(YkDerivation *d, const YkDeriveBody *body)
{
    static const char *const endings[] = {".angle",   ".angle.rate", ".angle.accel", ".angle'",
                                          ".angle''", ".rate",       ".accel"};
    const int32_t symbols[] = {body->angle,        body->rate, body->acceleration, body->rate,
                               body->acceleration, body->rate, body->acceleration};
    if (body->angle < 0 || !yk_ring_is_same(body->turn, yk_ring_rational(d->ring, 1, 1))) return;
    for (size_t i = 0; i < 7; i++) add_other_name(d, symbols[i], body->name, endings[i]);
}

void yk_derive_enter_names(YkDerivation *d)
{
    if (d->has_names) return;
    d->has_names = true;
    for (size_t k = 0; k < d->coordinate_count; k++) name_coordinate(d, &d->coordinates[k]);
    for (size_t b = 0; d->bodies && b < yk_model_body_count(d->model); b++) name_body(d, &d->bodies[b]);
}
