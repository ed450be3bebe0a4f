// Reads `units:`, the meaning of bare numbers; and chooses the unit in which each quantity is shown.
#include <string.h>
#include "model/load.h"

typedef struct Entry {
    const char *key;
    YkDimension dimension;
    size_t size_offset, name_offset; // in YkUnits
} Entry;

#define ENTRY(field, ...)                                                                                              \
    {                                                                                                                  \
        .key = #field, .dimension = {__VA_ARGS__}, .size_offset = offsetof(YkUnits, field),                            \
        .name_offset = offsetof(YkUnits, field##_name)                                                                 \
    }
static const Entry entries[] = {ENTRY(length, .length = 1), ENTRY(mass, .mass = 1), ENTRY(time, .time = 1),
                                ENTRY(angle, .angle = 1), ENTRY(force, .length = 1, .mass = 1, .time = -2)};
static const char *const keys[] = {"length", "mass", "time", "angle", "force", NULL};

// Returns whether the dimensions are exactly equal. For units an angle and a number differ: `angle: %` is a mistake.
static bool is_same(YkDimension a, YkDimension b)
{
    return a.length == b.length && a.mass == b.mass && a.time == b.time && a.angle == b.angle;
}

static void read_entry(YkLoader *loader, const Entry *entry, const YkNode *node)
{
    if (!yk_load_expect(loader, node, YK_NODE_SCALAR, &(YkSubject){.noun = "unit", .owner = entry->key})) return;
    double size = 0;
    YkDimension dimension = {0};
    const char *bad = NULL;
    size_t bad_length = 0;
    if (!yk_unit_read(node->text, node->length, &size, &dimension, &bad, &bad_length)) {
        yk_problem(loader->problems, YK_CODE_UNITS_ENTRY, node->place, "%q is not a unit", node->text);
        const char *nearest = yk_unit_nearest(node->text, node->length);
        if (nearest) yk_problem_hint(loader->problems, "did you mean %q?", nearest);
        return;
    }
    if (!is_same(dimension, entry->dimension)) {
        yk_problem(loader->problems, YK_CODE_UNITS_ENTRY, node->place, "%q is not a unit of %s", node->text,
                   entry->key);
        return;
    }
    char *units = (char *)&loader->model->units;
    memcpy(units + entry->size_offset, &size, sizeof size);
    memcpy(units + entry->name_offset, &node->text, sizeof node->text);
}

// Names the composed units: "mm/s", "deg/s^2", "N*mm".
static void name_quantities(YkLoader *loader)
{
    const YkUnits *u = &loader->model->units;
    bool is_si = u->length == 1 && u->mass == 1 && u->time == 1;
    const char *force = u->force_name ? u->force_name : is_si ? "N" : NULL;
    const struct {
        const char *before, *name, *power, *middle, *after, *end;
    } parts[YK_QUANTITY_COUNT] = {
        [YK_QUANTITY_NUMBER] = {"", "", "", "", "", ""},
        [YK_QUANTITY_ANGLE] = {"", u->angle_name, "", "", "", ""},
        [YK_QUANTITY_LENGTH] = {"", u->length_name, "", "", "", ""},
        [YK_QUANTITY_TIME] = {"", u->time_name, "", "", "", ""},
        [YK_QUANTITY_ANGLE_RATE] = {"", u->angle_name, "", "/", u->time_name, ""},
        [YK_QUANTITY_SPEED] = {"", u->length_name, "", "/", u->time_name, ""},
        [YK_QUANTITY_ANGLE_ACCELERATION] = {"", u->angle_name, "", "/", u->time_name, "^2"},
        [YK_QUANTITY_ACCELERATION] = {"", u->length_name, "", "/", u->time_name, "^2"},
        [YK_QUANTITY_FORCE] = {force ? "" : u->mass_name, force ? force : "*", force ? "" : u->length_name,
                               force ? "" : "/", force ? "" : u->time_name, force ? "" : "^2"},
        [YK_QUANTITY_TORQUE] = {force ? force : u->mass_name, "*", u->length_name, force ? "" : "^2/",
                                force ? "" : u->time_name, force ? "" : "^2"},
        [YK_QUANTITY_ENERGY] = {force ? force : u->mass_name, "*", u->length_name, force ? "" : "^2/",
                                force ? "" : u->time_name, force ? "" : "^2"},
        [YK_QUANTITY_MASS] = {"", u->mass_name, "", "", "", ""},
        [YK_QUANTITY_UNBALANCE] = {u->mass_name, "*", u->length_name, "", "", ""},
        [YK_QUANTITY_INERTIA] = {u->mass_name, "*", u->length_name, "^2", "", ""},
    };
    for (int i = 0; i < YK_QUANTITY_COUNT; i++) {
        YkText *text = &loader->text;
        yk_text_clear(text);
        yk_text_format(text, "%s%s%s%s%s%s", parts[i].before, parts[i].name, parts[i].power, parts[i].middle,
                       parts[i].after, parts[i].end);
        loader->model->unit_names[i] = yk_arena_copy(loader->arena, yk_text_get(text), text->length);
    }
}

void yk_load_units(YkLoader *loader)
{
    loader->model->units = yk_units_si();
    size_t errors = yk_problems_error_count(loader->problems);
    const YkNode *section = yk_load_section(loader, "units");
    if (section) {
        yk_load_check_keys(loader, section, keys, &(YkSubject){.noun = "section", .part = "units"});
        for (size_t i = 0; i < sizeof entries / sizeof *entries; i++) {
            const YkNode *node = yk_node_get(section, entries[i].key);
            if (node) read_entry(loader, &entries[i], node);
        }
    }
    loader->has_bad_units = yk_problems_error_count(loader->problems) > errors;
    name_quantities(loader);
}
