// Writes the results of opening: problems, missing parts, the machine.
#include "base/problems.h"
#include "core.h"
#include "exports.h"
#include "write/amount.h"
#include "write/json.h"

static void add_problem(YkJson *json, const YkProblem *problem)
{
    static const char *const severities[] = {"note", "warning", "error"};
    YkText code = {0};
    yk_text_format(&code, "%c", "NWE"[problem->severity]);
    for (int digit = 1000; digit > 0; digit /= 10) yk_text_format(&code, "%c", '0' + problem->code / digit % 10);
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_string(json, "code", yk_text_get(&code));
    yk_json_string(json, "severity", severities[problem->severity]);
    yk_json_string(json, "message", problem->message);
    if (problem->hint) yk_json_string(json, "hint", problem->hint);
    yk_json_integer(json, "line", problem->place.line);
    yk_json_integer(json, "column", problem->place.column);
    if (problem->place.line > 0)
        yk_json_integer(json, "endColumn",
                        problem->place.column + (problem->place.length > 0 ? problem->place.length : 1));
    yk_json_end(json);
    yk_text_free(&code);
}

// Adds "body.point", or nothing.
static void add_point(YkJson *json, const char *key, const YkModel *model, size_t point)
{
    YkText name = {0};
    if (point == YK_NOT_FOUND) return;
    yk_text_format(&name, "%s.%s", yk_model_body_name(model, yk_model_point_body(model, point)),
                   yk_model_point_name(model, point));
    yk_json_string(json, key, yk_text_get(&name));
    yk_text_free(&name);
}

static void add_lack(YkJson *json, const YkCore *core, const YkLack *lack)
{
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_string(json, "kind", yk_lack_kind_name(lack->kind));
    yk_json_bool(json, "optional", lack->is_optional);
    yk_json_string(json, "text", lack->text);
    yk_json_string(json, "mend", lack->mend);
    if (lack->path) yk_json_string(json, "path", lack->path);
    if (lack->value) yk_json_string(json, "value", lack->value);
    if (lack->body != YK_NOT_FOUND) yk_json_string(json, "body", yk_model_body_name(core->model, lack->body));
    add_point(json, "point", core->model, lack->point);
    add_point(json, "other", core->model, lack->other);
    if (lack->coordinate != YK_NOT_FOUND)
        yk_json_string(json, "coordinate",
                       yk_coordinate_info(yk_sketch_mechanism(core->sketch), lack->coordinate).name);
    yk_json_end(json);
}

static void add_body(YkJson *json, const YkModel *model, size_t index)
{
    const YkBody *body = &model->bodies[index];
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_string(json, "name", body->name);
    yk_json_bool(json, "ground", index == 0);
    yk_json_integer(json, "line", body->place.line);
    yk_json_list(json, "points", YK_JSON_INLINE);
    for (int32_t p = 0; p < body->point_count; p++) {
        const YkPoint *point = &model->points[body->first_point + p];
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "name", point->name);
        yk_json_list(json, "at", YK_JSON_INLINE);
        yk_json_number(json, NULL, point->at.x);
        yk_json_number(json, NULL, point->at.y);
        yk_json_end(json);
        yk_json_end(json);
    }
    yk_json_end(json);
    yk_json_end(json);
}

static void add_joint(YkJson *json, const YkModel *model, size_t index)
{
    const YkJoint *joint = &model->joints[index];
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_string(json, "name", joint->name);
    yk_json_string(json, "kind", yk_model_joint_kind(model, index));
    yk_json_list(json, "bodies", YK_JSON_INLINE);
    for (int side = 0; side < 2; side++)
        yk_json_string(json, NULL, yk_model_body_name(model, yk_model_joint_body(model, index, side)));
    yk_json_end(json);
    yk_json_list(json, "points", YK_JSON_INLINE);
    for (int side = 0; side < 2 && joint->point[0] >= 0 && joint->point[1] >= 0; side++)
        yk_json_string(json, NULL, model->points[joint->point[side]].name);
    yk_json_end(json);
    yk_json_integer(json, "line", joint->place.line);
    yk_json_end(json);
}

static void add_coordinate(YkJson *json, const YkCore *core, size_t index)
{
    YkCoordinateInfo info = yk_coordinate_info(core->mech, index);
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_string(json, "name", info.name);
    yk_json_string(json, "kind", info.is_distance ? "length" : "angle");
    yk_json_string(json, "joint", yk_model_joint_name(core->model, info.joint));
    yk_json_bool(json, "driven", info.has_drive);
    yk_json_bool(json, "free", info.input >= 0 && !info.has_drive && !info.is_held);
    bool has_pose = yk_state_has_pose(core->state);
    yk_json_number(json, "value", has_pose ? yk_state_coordinate(core->state, index).position : 0);
    yk_json_end(json);
}

static void add_parameter(YkJson *json, const YkModel *model, const YkParameter *parameter)
{
    YkQuantity quantity = yk_amount_quantity(parameter->dimension);
    YkText text = {0};
    double size = 1;
    const char *unit = quantity == YK_QUANTITY_NUMBER ? "" : yk_model_shown_unit(model, quantity, &size);
    yk_amount_write_shown(&text, model, parameter->value / size, quantity, 12);
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_string(json, "name", parameter->name);
    yk_json_number(json, "value", parameter->value);
    yk_json_string(json, "text", yk_text_get(&text));
    yk_json_string(json, "unit", unit);
    yk_json_integer(json, "line", parameter->place.line);
    yk_json_end(json);
    yk_text_free(&text);
}

static void add_machine(YkJson *json, const YkCore *core)
{
    yk_json_object(json, "machine", YK_JSON_LINES);
    yk_json_string(json, "name", yk_model_name(core->model));
    yk_json_list(json, "bodies", YK_JSON_LINES);
    for (size_t b = 0; b < yk_model_body_count(core->model); b++) add_body(json, core->model, b);
    yk_json_end(json);
    yk_json_list(json, "joints", YK_JSON_LINES);
    for (size_t j = 0; j < yk_sketch_joint_count(core->sketch); j++) add_joint(json, core->model, j);
    yk_json_end(json);
    yk_json_list(json, "coordinates", YK_JSON_LINES);
    for (size_t k = 0; k < yk_coordinate_count(core->mech); k++) add_coordinate(json, core, k);
    yk_json_end(json);
    yk_json_list(json, "parameters", YK_JSON_LINES);
    for (size_t p = 0; p < core->model->parameter_count; p++)
        add_parameter(json, core->model, &core->model->parameters[p]);
    yk_json_end(json);
    yk_json_integer(json, "freedom", yk_sketch_freedom(core->sketch));
    yk_json_bool(json, "moves", yk_sketch_moves(core->sketch));
    yk_json_end(json);
}

void yk_core_write(const YkCore *core, YkProblems *problems)
{
    yk_text_clear(&yk_core.text);
    YkJson json = {.text = &yk_core.text};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_list(&json, "problems", YK_JSON_LINES);
    for (size_t i = 0; i < yk_problems_count(problems); i++) add_problem(&json, yk_problems_get(problems, i));
    yk_json_end(&json);
    yk_json_list(&json, "lacks", YK_JSON_LINES);
    for (size_t i = 0; core->sketch && i < yk_sketch_lack_count(core->sketch); i++) {
        YkLack lack = yk_sketch_lack(core->sketch, i);
        add_lack(&json, core, &lack);
    }
    yk_json_end(&json);
    if (core->sketch)
        add_machine(&json, core);
    else
        yk_json_null(&json, "machine");
    yk_json_end(&json);
}

// Writes the scene. Returns 1, 0 if there is none (no machine, or none that can be put together), -1 when out of
// memory.
YK_DOOR(ys_scene) int ys_scene(void)
{
    yk_text_clear(&yk_core.text);
    if (!yk_core.drawing) return 0;
    const char *svg = yk_drawing_scene(yk_core.drawing);
    if (!svg) return -1;
    yk_text_puts(&yk_core.text, svg);
    return yk_core.text.failed ? -1 : 1;
}

// Writes the scene for a view of so many pixels to the metre, and so all scenes after it: lines, pins and names keep
// their width. Returns as ys_scene.
YK_DOOR(ys_look) int ys_look(double scale)
{
    yk_core.scale = scale > 1e-6 && scale < 1e12 ? scale : 0;
    if (yk_core.drawing) yk_core.drawing->fixed_scale = yk_core.scale;
    return ys_scene();
}
