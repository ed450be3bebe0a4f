// `yoke map --format json`: SI and radians.
#include "verbs/map/map.h"

static void add_range(YkJson *json, const char *key, YkRange range)
{
    yk_json_numbers(json, key, (double[]){range.from, range.to}, 2);
}

static void add_event(const YkMapAnswer *answer, YkJson *json, size_t circuit, size_t k)
{
    const YkMechanism *mech = answer->session->mech;
    YkMapEvent event = yk_map_event(answer->map, circuit, k);
    yk_json_object(json, NULL, YK_JSON_LINES);
    yk_json_string(json, "kind", yk_map_event_kind_name(event.kind));
    yk_json_number(json, "at", event.at);
    yk_json_string(json, "of", yk_map_event_of(answer, event));
    yk_json_integer(json, "branch", (long long)event.branch + 1);
    yk_json_object(json, "coordinates", YK_JSON_INLINE);
    for (size_t c = 0; c < yk_coordinate_count(mech); c++)
        yk_json_number(json, yk_coordinate_info(mech, c).name, yk_map_event_value(answer->map, circuit, k, c));
    yk_json_end(json);
    yk_json_end(json);
}

static void add_turns(const YkMapAnswer *answer, YkJson *json, size_t circuit)
{
    const YkModel *model = answer->session->model;
    yk_json_object(json, "joints", YK_JSON_LINES);
    for (size_t j = 0; j < yk_model_joint_count(model); j++) {
        YkMapTurn turn = yk_map_turn(answer->map, circuit, j);
        if (!(turn.range.to > turn.range.from)) continue;
        yk_json_object(json, yk_model_joint_name(model, j), YK_JSON_INLINE);
        yk_json_bool(json, "full", turn.is_full);
        add_range(json, "range", turn.range);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_branches(const YkMapAnswer *answer, YkJson *json, size_t circuit, size_t count)
{
    yk_json_list(json, "parts", YK_JSON_LINES);
    for (size_t k = 0; k < count; k++) {
        YkMapBranch branch = yk_map_branch(answer->map, circuit, k);
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_number(json, "from", branch.from);
        yk_json_number(json, "to", branch.to);
        yk_json_bool(json, "closed", branch.is_closed);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_circuit(const YkMapAnswer *answer, YkJson *json, size_t circuit)
{
    YkMapCircuit c = yk_map_circuit(answer->map, circuit);
    yk_json_object(json, NULL, YK_JSON_LINES);
    yk_json_bool(json, "contains_start", c.contains_start);
    yk_json_list(json, "ranges", YK_JSON_LINES);
    for (size_t k = 0; k < c.ranges; k++) add_range(json, NULL, yk_map_range(answer->map, circuit, k));
    yk_json_end(json);
    yk_json_integer(json, "branches", (long long)c.branches);
    add_branches(answer, json, circuit, c.branches);
    add_turns(answer, json, circuit);
    yk_json_list(json, "events", YK_JSON_LINES);
    for (size_t k = 0; k < c.events; k++) add_event(answer, json, circuit, k);
    yk_json_end(json);
    yk_json_end(json);
}

void yk_map_json(const YkMapAnswer *answer)
{
    YkJson json = {.text = &answer->session->out};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_head(&json, answer->session, YK_OK, "");
    yk_json_string(&json, "coordinate", answer->name);
    add_range(&json, "domain", yk_map_domain(answer->map));
    yk_json_bool(&json, "complete", yk_map_is_complete(answer->map));
    yk_json_string(&json, "reason", yk_map_message(answer->map));
    yk_json_list(&json, "circuits", YK_JSON_LINES);
    for (size_t k = 0; k < yk_map_circuit_count(answer->map); k++) add_circuit(answer, &json, k);
    yk_json_end(&json);
    yk_json_end(&json);
}
