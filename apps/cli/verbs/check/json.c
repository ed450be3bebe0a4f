// `yoke check --format json`.
#include "verbs/check/check.h"
#include "verbs/solve/solve.h"

static const char *body(const YkCheckAnswer *answer, size_t index)
{
    return yk_model_body_name(answer->session->model, index);
}
static const char *joint(const YkCheckAnswer *answer, size_t index)
{
    return yk_model_joint_name(answer->session->model, index);
}

static void add_parts(const YkCheckAnswer *answer, YkJson *json)
{
    const YkModel *model = answer->session->model;
    yk_json_list(json, "bodies", YK_JSON_INLINE);
    for (size_t i = 0; i < yk_model_body_count(model); i++) yk_json_string(json, NULL, body(answer, i));
    yk_json_end(json);
    yk_json_list(json, "joints", YK_JSON_LINES);
    for (size_t j = 0; j < yk_model_joint_count(model); j++) {
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "name", joint(answer, j));
        yk_json_string(json, "kind", yk_model_joint_kind(model, j));
        yk_json_list(json, "bodies", YK_JSON_INLINE);
        for (int side = 0; side < 2; side++)
            yk_json_string(json, NULL, body(answer, yk_model_joint_body(model, j, side)));
        yk_json_end(json);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_coordinates(const YkCheckAnswer *answer, YkJson *json)
{
    yk_json_list(json, "coordinates", YK_JSON_LINES);
    for (size_t i = 0; i < yk_coordinate_count(answer->session->mech); i++) {
        YkCoordinateInfo info = yk_coordinate_info(answer->session->mech, i);
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "name", info.name);
        yk_json_string(json, "kind", info.is_distance ? "distance" : "angle");
        yk_json_string(json, "joint", joint(answer, info.joint));
        yk_json_bool(json, "declared", info.is_declared);
        yk_json_bool(json, "driven", info.has_drive);
        yk_json_bool(json, "input", info.input >= 0);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_degrees(const YkCheckAnswer *answer, YkJson *json)
{
    YkFreedom freedom = yk_mechanism_freedom(answer->session->mech);
    yk_json_object(json, "degrees", YK_JSON_INLINE);
    yk_json_integer(json, "gruebler", freedom.gruebler);
    if (freedom.by_rank >= 0) {
        yk_json_integer(json, "rank", freedom.by_rank);
    } else {
        yk_json_null(json, "rank");
    }
    yk_json_integer(json, "redundant", (long long)freedom.redundant);
    yk_json_integer(json, "driven", (long long)freedom.driven);
    yk_json_end(json);
}

static void add_loops(const YkCheckAnswer *answer, YkJson *json)
{
    yk_json_list(json, "loops", YK_JSON_LINES);
    for (size_t l = 0; l < yk_loop_count(answer->session->mech); l++) {
        size_t count = yk_check_loop(answer, l);
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "closed_at", joint(answer, yk_loop_joint(answer->session->mech, l)));
        yk_json_list(json, "bodies", YK_JSON_INLINE);
        for (size_t i = 0; i < count; i++) yk_json_string(json, NULL, body(answer, answer->bodies[i]));
        yk_json_end(json);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_block(const YkCheckAnswer *answer, YkJson *json, size_t b)
{
    const YkMechanism *mech = answer->session->mech;
    YkBlockInfo block = yk_block_info(mech, b);
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_string(json, "kind", yk_block_kind_name(block.kind));
    yk_json_integer(json, "class", block.assur_class);
    yk_json_string(json, "label", block.label);
    yk_json_integer(json, "unknowns", (long long)block.unknowns);
    yk_json_integer(json, "equations", (long long)block.equations);
    yk_json_list(json, "joints", YK_JSON_INLINE);
    for (size_t i = 0; i < block.joint_count; i++)
        yk_json_string(json, NULL, joint(answer, yk_block_joint(mech, b, i)));
    yk_json_end(json);
    yk_json_list(json, "relations", YK_JSON_INLINE);
    for (size_t i = 0; i < block.relation_count; i++) yk_json_string(json, NULL, yk_block_relation(mech, b, i));
    yk_json_end(json);
    yk_json_list(json, "bodies", YK_JSON_INLINE);
    for (size_t i = 0; i < block.body_count; i++) yk_json_string(json, NULL, body(answer, yk_block_body(mech, b, i)));
    yk_json_end(json);
    yk_json_end(json);
}

static void add_four_bars(const YkCheckAnswer *answer, YkJson *json)
{
    yk_json_list(json, "four_bars", YK_JSON_LINES);
    for (size_t i = 0; i < answer->four_bar_count; i++) {
        const YkFourBar *bar = &answer->four_bars[i];
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "class", yk_four_bar_name(bar->kind));
        yk_json_list(json, "bodies", YK_JSON_INLINE);
        for (int k = 0; k < 4; k++) yk_json_string(json, NULL, body(answer, bar->body[k]));
        yk_json_end(json);
        yk_json_numbers(json, "lengths", bar->length, 4);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_masses(const YkCheckAnswer *answer, YkJson *json)
{
    const YkModel *model = answer->session->model;
    yk_json_object(json, "masses", YK_JSON_INLINE);
    for (size_t b = 1; b < yk_model_body_count(model); b++)
        if (yk_model_body_mass(model, b) > 0) yk_json_number(json, body(answer, b), yk_model_body_mass(model, b));
    yk_json_end(json);
}

static void add_loads(const YkCheckAnswer *answer, YkJson *json)
{
    const YkLoadCounts *loads = &answer->loads;
    const struct {
        const char *name;
        size_t count;
    } kinds[] = {{"efforts", loads->efforts}, {"forces", loads->forces},       {"springs", loads->springs},
                 {"dampers", loads->dampers}, {"frictions", loads->frictions}, {"stops", loads->stops}};
    yk_json_object(json, "loads", YK_JSON_INLINE);
    yk_json_bool(json, "gravity", loads->has_gravity);
    yk_json_number(json, "mass", loads->mass);
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
        yk_json_integer(json, kinds[k].name, (long long)kinds[k].count);
    yk_json_end(json);
}

void yk_check_json(const YkCheckAnswer *answer)
{
    const YkMechanism *mech = answer->session->mech;
    YkJson json = {.text = &answer->session->out};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_head(&json, answer->session, answer->status, answer->message);
    add_degrees(answer, &json);
    add_parts(answer, &json);
    add_coordinates(answer, &json);
    add_loops(answer, &json);
    yk_json_list(&json, "blocks", YK_JSON_LINES);
    for (size_t b = 0; b < yk_block_count(mech); b++) add_block(answer, &json, b);
    yk_json_end(&json);
    yk_json_list(&json, "redundant", YK_JSON_INLINE);
    for (size_t i = 0; i < yk_redundant_count(mech); i++)
        yk_json_string(&json, NULL, joint(answer, yk_redundant_joint(mech, i)));
    yk_json_end(&json);
    add_four_bars(answer, &json);
    if (answer->has_loads) {
        add_masses(answer, &json);
        add_loads(answer, &json);
        yk_add_equations_json(&json, answer->equations);
    }
    yk_json_end(&json);
}
