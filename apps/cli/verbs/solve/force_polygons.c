// yoke solve --polygon force: the force polygon of every body, with words.
#include <math.h>
#include "session.h"
#include "verbs/solve/solve.h"
#include "write/table.h"

static const char *const parts[] = {"weight", "loads", "inertia", "planets", "contact", "reaction"};

YkForcePolygons *yk_force_polygons_of(YkSession *session, const YkDynamics *dynamics, const char *why)
{
    if (dynamics) return yk_force_polygons_new(dynamics, session->problems);
    if (!why && session->state) why = yk_state_report(session->state)->message; // without rates none were looked for
    yk_session_refuse(session, YK_CODE_NO_POLYGON, "no force polygon can be drawn: %s",
                      why && *why ? why : "the forces are not determined at this pose");
    return NULL;
}

void yk_force_polygon_text(YkSession *session)
{
    static const char *const heads[] = {"on", "force", "from", "x", "y", "size", "moment"};
    YkForcePolygons *p = yk_force_polygons_of(session, session->dynamics, session->forces_message);
    if (!p) return;
    YkTable *table = yk_table_new(7);
    for (size_t k = 0; k < 7; k++)
        yk_table_head(table, heads[k],
                      k < 3 ? NULL : yk_unit_of(session, k < 6 ? YK_QUANTITY_FORCE : YK_QUANTITY_TORQUE));
    for (size_t k = 0; k < yk_force_polygons_vector_count(p); k++) {
        YkForceVector v = yk_force_polygons_vector(p, k);
        yk_table_word(table, yk_model_body_name(session->model, v.body));
        yk_table_word(table, v.name);
        yk_table_word(table, v.by == YK_NOT_FOUND ? "" : yk_model_body_name(session->model, v.by));
        const double sizes[] = {v.value[0], v.value[1], sqrt(v.value[0] * v.value[0] + v.value[1] * v.value[1])};
        for (size_t i = 0; i < 3; i++)
            yk_table_number(table, yk_shown(session, sizes[i], YK_QUANTITY_FORCE), YK_DIGITS);
        yk_table_number(table, yk_shown(session, v.moment, YK_QUANTITY_TORQUE), YK_DIGITS);
    }
    yk_text_puts(&session->out, "\nForce polygons\n");
    for (size_t k = 0; k < yk_force_polygons_step_count(p); k++)
        yk_text_format(&session->out, "  %z. %s\n", k + 1, yk_force_polygons_step(p, k));
    yk_table_show(table, NULL, &session->out);
    yk_force_polygons_free(p);
}

static void add_vector(const YkSession *session, YkJson *json, const YkForceVector *v)
{
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_string(json, "body", yk_model_body_name(session->model, v->body));
    yk_json_string(json, "name", v->name);
    yk_json_string(json, "part", parts[v->part]);
    if (v->by != YK_NOT_FOUND) yk_json_string(json, "by", yk_model_body_name(session->model, v->by));
    yk_polygon_pair(json, "at", v->at);
    yk_polygon_pair(json, "start", v->start);
    yk_polygon_pair(json, "value", v->value);
    yk_json_number(json, "moment", v->moment);
    if (!v->is_determinate) yk_json_bool(json, "determinate", false);
    yk_json_end(json);
}

void yk_force_polygon_json(YkSession *session, YkJson *json)
{
    YkForcePolygons *p = yk_force_polygons_of(session, session->dynamics, session->forces_message);
    if (!p) return;
    yk_json_object(json, "polygon", YK_JSON_LINES);
    yk_json_string(json, "kind", "force");
    yk_json_list(json, "vectors", YK_JSON_LINES);
    for (size_t k = 0; k < yk_force_polygons_vector_count(p); k++) {
        YkForceVector v = yk_force_polygons_vector(p, k);
        add_vector(session, json, &v);
    }
    yk_json_end(json);
    yk_json_list(json, "steps", YK_JSON_LINES);
    for (size_t k = 0; k < yk_force_polygons_step_count(p); k++)
        yk_json_string(json, NULL, yk_force_polygons_step(p, k));
    yk_json_end(json);
    yk_json_end(json);
    yk_force_polygons_free(p);
}

void yk_polygon_pair(YkJson *json, const char *key, const double value[2])
{
    yk_json_numbers(json, key, value, 2);
}
