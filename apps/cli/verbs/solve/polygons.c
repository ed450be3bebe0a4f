// yoke solve --polygon: the vectors of a velocity or acceleration polygon, with the steps of its construction.
#include <math.h>
#include <string.h>
#include "session.h"
#include "verbs/solve/solve.h"
#include "write/table.h"

static const char *const parts[] = {"turning", "normal", "tangential", "sliding", "coriolis"};

bool yk_polygon_read(YkSession *session, YkPolygonKind *kind)
{
    const char *word = session->request->polygon;
    *kind = word && strcmp(word, "acceleration") == 0 ? YK_POLYGON_ACCELERATION : YK_POLYGON_VELOCITY;
    if (!word || *kind == YK_POLYGON_ACCELERATION || strcmp(word, "velocity") == 0) return true;
    if (yk_wants_force_polygons(session)) return true;
    return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--polygon is velocity, acceleration or force, not %q",
                             word);
}

bool yk_wants_force_polygons(const YkSession *session)
{
    const char *word = session->request->polygon;
    return word && strcmp(word, "force") == 0;
}

bool yk_lacks_construction(const YkSession *session)
{
    for (size_t k = 0; k < yk_problems_count(session->problems); k++) {
        int code = yk_problems_get(session->problems, k)->code;
        if (code == YK_CODE_NO_CENTERS || code == YK_CODE_NO_POLYGON) return true;
    }
    return false;
}

YkPolygon *yk_polygon_of(YkSession *session, const YkState *state)
{
    YkPolygonKind kind;
    if (!yk_polygon_read(session, &kind)) return NULL;
    if (kind != YK_POLYGON_ACCELERATION || !session->lacks_accelerations)
        return yk_polygon_new(state, kind, session->problems);
    yk_session_refuse(session, YK_CODE_NO_POLYGON, "no acceleration polygon can be drawn: %s", session->forces_message);
    return NULL;
}

void yk_polygon_text(YkSession *session, const YkState *state)
{
    if (yk_wants_force_polygons(session)) {
        yk_force_polygon_text(session);
        return;
    }
    static const char *const heads[] = {"from", "to", "part", "of", "x", "y", "size"};
    YkPolygon *p = yk_polygon_of(session, state);
    if (!p) return;
    YkTable *table = yk_table_new(7);
    YkQuantity quantity = yk_polygon_kind(p) == YK_POLYGON_VELOCITY ? YK_QUANTITY_SPEED : YK_QUANTITY_ACCELERATION;
    double size = 1;
    const char *unit = yk_model_unit(session->model, quantity, &size);
    for (size_t k = 0; k < 7; k++) yk_table_head(table, heads[k], k < 4 ? NULL : unit);
    for (size_t k = 0; k < yk_polygon_vector_count(p); k++) {
        YkPolygonVector v = yk_polygon_vector(p, k);
        const char *words[] = {v.from, v.to, parts[v.part], yk_model_body_name(session->model, v.body)};
        for (size_t i = 0; i < 4; i++) yk_table_word(table, words[i]);
        for (size_t i = 0; i < 2; i++) yk_table_number(table, v.value[i] / size, YK_DIGITS);
        yk_table_number(table, sqrt(v.value[0] * v.value[0] + v.value[1] * v.value[1]) / size, YK_DIGITS);
    }
    yk_text_format(&session->out, "\n%s polygon\n",
                   yk_polygon_kind(p) == YK_POLYGON_VELOCITY ? "Velocity" : "Acceleration");
    for (size_t k = 0; k < yk_polygon_step_count(p); k++)
        yk_text_format(&session->out, "  %z. %s\n", k + 1, yk_polygon_step(p, k));
    yk_table_show(table, NULL, &session->out);
    yk_polygon_free(p);
}

static void add_vector(const YkSession *session, YkJson *json, const YkPolygonVector *v)
{
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_string(json, "from", v->from);
    yk_json_string(json, "to", v->to);
    yk_json_string(json, "part", parts[v->part]);
    yk_json_string(json, "body", yk_model_body_name(session->model, v->body));
    if (v->joint != YK_NOT_FOUND) yk_json_string(json, "joint", yk_model_joint_name(session->model, v->joint));
    yk_json_integer(json, "step", (long long)v->step);
    yk_polygon_pair(json, "start", v->start);
    yk_polygon_pair(json, "value", v->value);
    yk_json_end(json);
}

void yk_polygon_json(YkSession *session, YkJson *json, const YkState *state)
{
    if (yk_wants_force_polygons(session)) {
        yk_force_polygon_json(session, json);
        return;
    }
    YkPolygon *p = yk_polygon_of(session, state);
    if (!p) return;
    yk_json_object(json, "polygon", YK_JSON_LINES);
    yk_json_string(json, "kind", session->request->polygon);
    yk_json_list(json, "vectors", YK_JSON_LINES);
    for (size_t k = 0; k < yk_polygon_vector_count(p); k++) {
        YkPolygonVector v = yk_polygon_vector(p, k);
        add_vector(session, json, &v);
    }
    yk_json_end(json);
    yk_json_list(json, "images", YK_JSON_LINES);
    for (size_t k = 0; k < yk_polygon_image_count(p); k++) {
        YkPolygonImage image = yk_polygon_image(p, k);
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "name", image.name);
        yk_polygon_pair(json, "at", image.at);
        yk_polygon_pair(json, "value", image.value);
        yk_json_end(json);
    }
    yk_json_end(json);
    yk_json_list(json, "steps", YK_JSON_LINES);
    for (size_t k = 0; k < yk_polygon_step_count(p); k++) yk_json_string(json, NULL, yk_polygon_step(p, k));
    yk_json_end(json);
    yk_json_end(json);
    yk_polygon_free(p);
}
