// `yoke solve --format json`.
#include <math.h>
#include "reach.h"
#include "session.h"
#include "roll.h"
#include "verbs/solve/solve.h"

static void add_rates(YkSession *session, YkJson *json, const YkState *state, const char *rate, YkMotion motion)
{
    yk_json_number(json, rate, yk_if_rates(state, motion.velocity));
    yk_json_number(json, "acceleration", yk_if_accelerations(session, state, motion.acceleration));
}

static void add_coordinates(YkSession *session, YkJson *json, const YkState *state)
{
    yk_json_object(json, "coordinates", YK_JSON_LINES);
    for (size_t i = 0; i < yk_coordinate_count(session->mech); i++) {
        YkMotion motion = yk_state_coordinate(state, i);
        yk_json_object(json, yk_coordinate_info(session->mech, i).name, YK_JSON_INLINE);
        yk_json_number(json, "position", motion.position);
        add_rates(session, json, state, "velocity", motion);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_bodies(YkSession *session, YkJson *json, const YkState *state)
{
    yk_json_object(json, "bodies", YK_JSON_LINES);
    const YkMotion *bodies = yk_session_bodies(session, state);
    for (size_t i = 1; bodies && i < yk_model_body_count(session->model); i++) {
        yk_json_object(json, yk_model_body_name(session->model, i), YK_JSON_INLINE);
        yk_json_number(json, "angle", bodies[i].position);
        add_rates(session, json, state, "rate", bodies[i]);
        yk_json_end(json);
    }
    yk_json_end(json);
}

// Writes [x, y], or [null, null] if it is not known.
static void add_vector(YkJson *json, const char *key, const double vector[2], bool is_known)
{
    yk_json_list(json, key, YK_JSON_INLINE);
    for (int i = 0; i < 2; i++) yk_json_number(json, NULL, is_known ? vector[i] : (double)NAN);
    yk_json_end(json);
}

static void add_points(YkSession *session, YkJson *json, const YkState *state)
{
    YkText name = {0};
    bool has_rates = yk_state_has_rates(state);
    yk_json_object(json, "points", YK_JSON_LINES);
    for (size_t i = 0; i < yk_model_point_count(session->model); i++) {
        YkPointMotion motion = yk_state_point(state, i);
        const char *body = yk_model_body_name(session->model, yk_model_point_body(session->model, i));
        yk_text_clear(&name);
        yk_text_format(&name, "%s.%s", body, yk_model_point_name(session->model, i));
        yk_json_object(json, yk_text_get(&name), YK_JSON_INLINE);
        add_vector(json, "position", motion.position, true);
        add_vector(json, "velocity", motion.velocity, has_rates);
        add_vector(json, "acceleration", motion.acceleration, has_rates && !session->lacks_accelerations);
        yk_json_end(json);
    }
    yk_json_end(json);
    yk_text_free(&name);
}

// Writes the transmission angles of the dyads, by the label of their block.
static void add_transmission(YkSession *session, YkJson *json, const YkState *state)
{
    yk_json_object(json, "transmission", YK_JSON_INLINE);
    for (size_t i = 0; i < yk_block_count(session->mech); i++) {
        YkBlockInfo block = yk_block_info(session->mech, i);
        if (block.assur_class == 2) yk_json_number(json, block.label, yk_state_transmission(state, i));
    }
    yk_json_end(json);
}

static void add_continuum(const YkSession *session, YkJson *json)
{
    const YkContinuum *c = yk_session_continuum(session);
    if (!c) return;
    yk_json_object(json, "continuum", YK_JSON_INLINE);
    yk_json_number(json, "dimension", (double)c->dimension);
    yk_json_number(json, "at_least", (double)c->at_least);
    yk_json_number(json, "at_most", (double)c->at_most);
    yk_json_number(json, "poses", (double)c->poses);
    yk_json_number(json, "miss", c->miss);
    yk_json_end(json);
}

void yk_solve_json(YkSession *session, YkJson *json, const YkState *state)
{
    YkText label = yk_configuration_name(session, state);
    yk_json_object(json, NULL, YK_JSON_LINES);
    yk_json_string(json, "label", yk_text_get(&label));
    yk_json_bool(json, "is_start", session->is_start);
    yk_json_string(json, "reached", session->is_chosen ? "chosen" : "moved");
    add_continuum(session, json);
    if (session->forces_message) yk_json_string(json, "message", session->forces_message); // why there are no forces
    add_coordinates(session, json, state);
    add_bodies(session, json, state);
    add_points(session, json, state);
    add_transmission(session, json, state);
    if (session->dynamics) yk_forces_json(session, json);
    if (session->request->centers) yk_centers_json(session, json, state);
    if (session->request->polygon) yk_polygon_json(session, json, state);
    if (session->columns) yk_solve_of_json(session, json, state);
    yk_json_end(json);
    yk_text_free(&label);
}
