// yoke solve --centers: the instant centres of a configuration.
#include "verbs/solve/solve.h"
#include "write/table.h"

static const char *body(const YkSession *session, size_t index)
{
    return yk_model_body_name(session->model, index);
}

// Says how a centre was found.
static void add_source(const YkSession *session, YkText *text, const YkCenter *c)
{
    if (c->source == YK_CENTER_JOINT)
        yk_text_format(text, "joint %s", yk_model_joint_name(session->model, c->joint));
    else if (c->kind == YK_CENTER_UNDEFINED)
        yk_text_puts(text, "they move as one");
    else if (c->source == YK_CENTER_KENNEDY)
        yk_text_format(text, "lines by %s and %s", body(session, c->by[0]), body(session, c->by[1]));
    else
        yk_text_puts(text, "velocities");
}

void yk_centers_text(YkSession *session, const YkState *state)
{
    YkCenters *centers = yk_centers_new(state, session->problems);
    if (!centers) return;
    YkTable *table = yk_table_new(6);
    YkText words = {0};
    static const char *const heads[] = {"centre of", "and", "x", "y", "at infinity towards", "found by"};
    for (size_t k = 0; k < 6; k++)
        yk_table_head(table, heads[k],
                      k == 2 || k == 3 ? yk_unit_of(session, YK_QUANTITY_LENGTH)
                      : k == 4         ? yk_unit_of(session, YK_QUANTITY_ANGLE)
                                       : NULL);
    for (size_t k = 0; k < yk_centers_count(centers); k++) {
        YkCenter c = yk_centers_at(centers, k);
        for (size_t i = 0; i < 2; i++) yk_table_word(table, body(session, c.body[i]));
        for (size_t i = 0; i < 2; i++) {
            if (c.kind == YK_CENTER_POINT)
                yk_table_number(table, yk_shown(session, c.at[i], YK_QUANTITY_LENGTH), YK_DIGITS);
            else
                yk_table_word(table, "-");
        }
        if (c.kind == YK_CENTER_AT_INFINITY)
            yk_table_number(table, yk_shown(session, c.direction, YK_QUANTITY_ANGLE), YK_DIGITS);
        else
            yk_table_word(table, "-");
        yk_text_clear(&words);
        add_source(session, &words, &c);
        yk_table_word(table, yk_text_get(&words));
    }
    yk_text_puts(&session->out, "\n");
    yk_table_write(table, 2, &session->out);
    if (yk_centers_stalled(centers) > 0)
        yk_text_format(&session->out,
                       "\n  Kennedy's theorem stalled %z time%s: one centre came from velocities each time.\n",
                       yk_centers_stalled(centers), yk_centers_stalled(centers) == 1 ? "" : "s");
    yk_table_free(table);
    yk_text_free(&words);
    yk_centers_free(centers);
}

static void add_center(const YkSession *session, YkJson *json, const YkCenter *c)
{
    static const char *const kinds[] = {"point", "infinity", "undefined"};
    static const char *const sources[] = {"joint", "kennedy", "velocities"};
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_list(json, "bodies", YK_JSON_INLINE);
    for (size_t i = 0; i < 2; i++) yk_json_string(json, NULL, body(session, c->body[i]));
    yk_json_end(json);
    yk_json_string(json, "kind", kinds[c->kind]);
    if (c->kind == YK_CENTER_POINT) {
        yk_json_numbers(json, "at", c->at, 2);
    } else if (c->kind == YK_CENTER_AT_INFINITY) {
        yk_json_number(json, "direction", c->direction);
    }
    yk_json_string(json, "source", sources[c->source]);
    if (c->source == YK_CENTER_JOINT) yk_json_string(json, "joint", yk_model_joint_name(session->model, c->joint));
    if (c->source == YK_CENTER_KENNEDY) {
        yk_json_list(json, "by", YK_JSON_INLINE);
        for (size_t i = 0; i < 2; i++) yk_json_string(json, NULL, body(session, c->by[i]));
        yk_json_end(json);
    }
    yk_json_end(json);
}

void yk_centers_json(YkSession *session, YkJson *json, const YkState *state)
{
    YkCenters *centers = yk_centers_new(state, session->problems);
    if (!centers) return;
    yk_json_list(json, "centers", YK_JSON_LINES);
    for (size_t k = 0; k < yk_centers_count(centers); k++) {
        YkCenter c = yk_centers_at(centers, k);
        add_center(session, json, &c);
    }
    yk_json_end(json);
    yk_json_integer(json, "stalled", (long long)yk_centers_stalled(centers));
    yk_centers_free(centers);
}
