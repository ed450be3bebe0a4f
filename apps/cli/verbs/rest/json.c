// `yoke rest --format json`.
#include "verbs/rest/rest.h"

static const char *input_name(const YkRestAnswer *answer, size_t k)
{
    return yk_coordinate_info(answer->mech, yk_rest_input(answer->rest, k)).name;
}

static void add_matrix(YkJson *json, const char *key, const double *entries, size_t size)
{
    yk_json_list(json, key, YK_JSON_INLINE);
    for (size_t row = 0; row < size; row++) {
        yk_json_numbers(json, NULL, entries + row * size, size);
    }
    yk_json_end(json);
}

static void add_mode(const YkRestAnswer *answer, YkJson *json, YkMode mode)
{
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_number(json, "frequency", mode.frequency); // rad/s; negative: grows at that rate
    yk_json_number(json, "hertz", yk_mode_hertz(mode));
    yk_json_number(json, "damping_ratio", mode.damping_ratio);
    yk_json_numbers(json, "shape", mode.shape, yk_rest_freedom(answer->rest));
    yk_json_end(json);
}

static void add_roots(const YkRestAnswer *answer, YkJson *json, size_t index)
{
    yk_json_list(json, "roots", YK_JSON_INLINE);
    for (size_t k = 0; k < 2 * yk_rest_freedom(answer->rest); k++) {
        double real, imaginary;
        yk_rest_root(answer->rest, index, k, &real, &imaginary);
        yk_json_numbers(json, NULL, (double[]){real, imaginary}, 2);
    }
    yk_json_end(json);
}

static void add_equilibrium(const YkRestAnswer *answer, YkJson *json, size_t index)
{
    YkEquilibrium rest = yk_rest_equilibrium(answer->rest, index);
    const YkState *state = yk_rest_state(answer->rest, index);
    size_t freedom = yk_rest_freedom(answer->rest);
    yk_json_object(json, NULL, YK_JSON_LINES);
    yk_json_string(json, "stability", yk_stability_word(rest.stability));
    yk_json_bool(json, "reachable", rest.is_reachable);
    if (rest.is_higher_order) yk_json_bool(json, "higher_order", true);
    yk_json_number(json, "potential", rest.potential);
    yk_json_number(json, "force", rest.force);
    yk_json_object(json, "coordinates", YK_JSON_INLINE);
    for (size_t i = 0; i < yk_coordinate_count(answer->mech); i++)
        yk_json_number(json, yk_coordinate_info(answer->mech, i).name, yk_state_coordinate(state, i).position);
    yk_json_end(json);
    yk_json_list(json, "modes", YK_JSON_LINES);
    for (size_t k = 0; k < freedom; k++) add_mode(answer, json, yk_rest_mode(answer->rest, index, k));
    yk_json_end(json);
    add_roots(answer, json, index);
    add_matrix(json, "M", yk_rest_mass(answer->rest, index), freedom);
    add_matrix(json, "C", yk_rest_damping(answer->rest, index), freedom);
    add_matrix(json, "K", yk_rest_stiffness(answer->rest, index), freedom);
    yk_json_end(json);
}

void yk_rest_json(const YkRestAnswer *answer)
{
    YkJson json = {.text = &answer->session->out};
    bool has_some = yk_rest_count(answer->rest) > 0;
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_string(&json, "model", yk_model_name(answer->session->model));
    yk_json_string(&json, "status", has_some ? "ok" : "no-equilibrium");
    yk_json_integer(&json, "freedom", yk_freedom_of(answer->session->mech));
    if (!has_some) {
        yk_json_string(&json, "message", "no equilibrium was found");
        yk_json_string(&json, "code", "E0830");
    }
    yk_json_bool(&json, "all_circuits", yk_rest_is_complete(answer->rest));
    if (yk_rest_is_wound(answer->rest)) yk_json_bool(&json, "one_turn", true);
    yk_json_list(&json, "free", YK_JSON_INLINE);
    for (size_t k = 0; k < yk_rest_freedom(answer->rest); k++) yk_json_string(&json, NULL, input_name(answer, k));
    yk_json_end(&json);
    yk_json_list(&json, "equilibria", YK_JSON_LINES);
    for (size_t i = 0; i < yk_rest_count(answer->rest); i++) add_equilibrium(answer, &json, i);
    yk_json_end(&json);
    yk_add_laws_json(&json, answer->laws, true);
    yk_json_end(&json);
}
