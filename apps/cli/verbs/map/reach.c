// `yoke map --pose ... --reach ...`: whether the machine gets from one pose to the other, and how.
#include <math.h>
#include "session.h"
#include "verbs/map/map.h"
#include "write/table.h"

enum { PLACES_MAX = 4096 };

// The place that --pose or --reach gives: values of coordinates, NaN for those not named.
typedef struct Wanted {
    const char *option;
    double *values;
    YkMapPlace *places; // the configurations that have them
    size_t count;
    bool is_far; // there are configurations at the mapped value, but none has the other values
} Wanted;

typedef struct Reach {
    YkMapAnswer *answer;
    Wanted from, to;
    YkMapPlace *way;
    size_t way_count;
    double *rows; // [way_count][coordinates]
} Reach;

static bool read_values(YkMapAnswer *answer, const YkAssignments *pairs, Wanted *wanted)
{
    YkSession *session = answer->session;
    size_t coordinate, mapped = yk_map_coordinate(answer->map);
    for (size_t k = 0; k < yk_coordinate_count(session->mech); k++) wanted->values[k] = NAN;
    for (size_t k = 0; k < pairs->count; k++) {
        const YkAssignment *pair = &pairs->items[k];
        if (!yk_session_coordinate(session, pair->name, &coordinate)) return false;
        YkQuantity quantity = yk_quantity_of(yk_coordinate_info(session->mech, coordinate).is_distance, 0);
        if (!yk_session_value(session, wanted->option, pair->name, pair->value, quantity, &wanted->values[coordinate]))
            return false;
    }
    if (pairs->count == 0 || !isnan(wanted->values[mapped])) return true;
    yk_session_refuse(session, YK_CODE_OPTION_MISSING, "%s must give the mapped coordinate too", wanted->option);
    yk_problem_hint(session->problems, "%s %s=VALUE", wanted->option, answer->name);
    return false;
}

// Finds the configurations that have the values. Returns false when out of memory.
static bool find_places(Reach *r, Wanted *wanted)
{
    double at = wanted->values[yk_map_coordinate(r->answer->map)];
    size_t count = yk_map_find(r->answer->map, wanted->values, wanted->places, PLACES_MAX);
    if (count == YK_NOT_FOUND) return false;
    wanted->count = count < PLACES_MAX ? count : PLACES_MAX;
    wanted->is_far = count == 0 && yk_map_places(r->answer->map, at, NULL, 0) > 0;
    return true;
}

// Finds the shortest way from any of the poses to any of the others.
static bool find_way(Reach *r)
{
    YkMap *map = r->answer->map;
    for (size_t a = 0; a < r->from.count; a++)
        for (size_t b = 0; b < r->to.count; b++) {
            size_t count = yk_map_way(map, r->from.places[a], r->to.places[b], NULL, 0);
            if (count == YK_NOT_FOUND) return false;
            if (count == 0 || (r->way_count > 0 && count >= r->way_count)) continue;
            r->way = yk_session_alloc(r->answer->session, count, sizeof *r->way);
            if (!r->way) return false;
            r->way_count = yk_map_way(map, r->from.places[a], r->to.places[b], r->way, count);
            if (r->way_count == YK_NOT_FOUND) return false;
        }
    return true;
}

// Returns the least circuit of a pose beyond `after` (YK_NOT_FOUND: none is before), or YK_NOT_FOUND.
static size_t next_circuit(const Wanted *wanted, size_t after)
{
    size_t next = YK_NOT_FOUND;
    for (size_t k = 0; k < wanted->count; k++) {
        size_t circuit = wanted->places[k].circuit;
        bool is_beyond = after == YK_NOT_FOUND || circuit > after;
        if (is_beyond && (next == YK_NOT_FOUND || circuit < next)) next = circuit;
    }
    return next;
}

// Writes "circuit 2", or "circuits 2, 3 and 4".
static void add_circuits(const Wanted *wanted, YkText *text)
{
    size_t first = next_circuit(wanted, YK_NOT_FOUND), circuit = next_circuit(wanted, first);
    yk_text_format(text, "circuit%s %z", circuit == YK_NOT_FOUND ? "" : "s", first + 1);
    while (circuit != YK_NOT_FOUND) {
        size_t after = next_circuit(wanted, circuit);
        yk_text_format(text, "%s%z", after == YK_NOT_FOUND ? " and " : ", ", circuit + 1);
        circuit = after;
    }
}

// Explains why the machine cannot get there.
static void add_reason(const Reach *r, YkText *text)
{
    const Wanted *poses[2] = {&r->from, &r->to};
    for (int k = 0; k < 2; k++) {
        if (poses[k]->count > 0) continue;
        if (poses[k]->is_far)
            yk_text_format(text, "no configuration has the values of %s", poses[k]->option);
        else
            yk_text_format(text, "no configuration closes at the %s of %s", r->answer->name, poses[k]->option);
        return;
    }
    yk_text_format(text, "the pose is on circuit %z, and what is to be reached on ", r->from.places[0].circuit + 1);
    add_circuits(&r->to, text);
    yk_text_puts(text, ": no motion joins them");
    if (!yk_map_is_complete(r->answer->map)) yk_text_puts(text, " that was found, but the map is not complete");
}

static void write_text(const Reach *r)
{
    YkSession *session = r->answer->session;
    const YkMechanism *mech = session->mech;
    YkText *out = &session->out;
    yk_scale_begin(session);
    yk_text_format(out, "%s: ", yk_model_name(session->model));
    if (r->way_count == 0) {
        yk_text_puts(out, yk_map_is_complete(r->answer->map) ? "it cannot be reached: " : "no way was found: ");
        add_reason(r, out);
        yk_text_puts(out, "\n");
        return;
    }
    yk_text_format(out, "it can be reached on circuit %z, ", r->way[0].circuit + 1);
    if (r->way_count == 2)
        yk_text_puts(out, "without passing a limit or a change point\n\n");
    else
        yk_text_format(out, "past %z limit%s or change point%s\n\n", r->way_count - 2, r->way_count == 3 ? "" : "s",
                       r->way_count == 3 ? "" : "s");
    YkTable *table = yk_table_new(1 + yk_coordinate_count(mech));
    yk_table_head(table, "", NULL);
    for (size_t c = 0; c < yk_coordinate_count(mech); c++) {
        YkCoordinateInfo info = yk_coordinate_info(mech, c);
        yk_table_head(table, info.name, yk_unit_of(session, yk_quantity_of(info.is_distance, 0)));
    }
    for (size_t k = 0; k < r->way_count; k++) {
        yk_table_word(table, k == 0 ? "from" : k + 1 == r->way_count ? "to" : "over");
        const double *row = r->rows + k * yk_coordinate_count(mech);
        for (size_t c = 0; c < yk_coordinate_count(mech); c++) {
            YkQuantity quantity = yk_quantity_of(yk_coordinate_info(mech, c).is_distance, 0);
            yk_table_number(table, yk_shown(session, row[c], quantity), YK_DIGITS);
        }
    }
    yk_table_write(table, 2, out);
    yk_table_free(table);
}

static void write_json(const Reach *r)
{
    YkSession *session = r->answer->session;
    const YkMechanism *mech = session->mech;
    YkJson json = {.text = &session->out};
    YkText reason = {0};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_head(&json, session, YK_OK, "");
    yk_json_string(&json, "coordinate", r->answer->name);
    yk_json_bool(&json, "complete", yk_map_is_complete(r->answer->map));
    if (r->way_count > 0 || yk_map_is_complete(r->answer->map))
        yk_json_bool(&json, "reachable", r->way_count > 0);
    else
        yk_json_null(&json, "reachable");
    yk_json_list(&json, "coordinates", YK_JSON_INLINE);
    for (size_t c = 0; c < yk_coordinate_count(mech); c++)
        yk_json_string(&json, NULL, yk_coordinate_info(mech, c).name);
    yk_json_end(&json);
    yk_json_list(&json, "way", YK_JSON_LINES);
    for (size_t k = 0; k < r->way_count; k++) {
        const double *row = r->rows + k * yk_coordinate_count(mech);
        yk_json_numbers(&json, NULL, row, yk_coordinate_count(mech));
    }
    yk_json_end(&json);
    if (r->way_count == 0) {
        add_reason(r, &reason);
        yk_json_string(&json, "reason", yk_text_get(&reason));
    }
    yk_json_end(&json);
    yk_text_free(&reason);
}

static bool make_room(Reach *r)
{
    size_t n = yk_coordinate_count(r->answer->session->mech) + 1;
    r->from.values = yk_session_alloc(r->answer->session, n, sizeof *r->from.values);
    r->to.values = yk_session_alloc(r->answer->session, n, sizeof *r->to.values);
    r->from.places = yk_session_alloc(r->answer->session, PLACES_MAX, sizeof *r->from.places);
    r->to.places = yk_session_alloc(r->answer->session, PLACES_MAX, sizeof *r->to.places);
    if (r->from.values && r->to.values && r->from.places && r->to.places) return true;
    return yk_session_refuse_for_memory(r->answer->session);
}

// Reads the poses of the way. Returns false when out of memory.
static bool read_way(Reach *r)
{
    size_t n = yk_coordinate_count(r->answer->session->mech);
    bool good = true;
    r->rows = yk_session_alloc(r->answer->session, r->way_count * n + 1, sizeof *r->rows);
    for (size_t k = 0; k < r->way_count && r->rows && good; k++)
        good = yk_map_coordinates_at(r->answer->map, r->way[k], r->rows + k * n);
    return r->rows && good;
}

static int answer_reach(Reach *r)
{
    YkSession *session = r->answer->session;
    const YkRequest *request = session->request;
    if (!make_room(r)) return YK_EXIT_WRONG;
    if (!read_values(r->answer, &request->pose, &r->from) || !read_values(r->answer, &request->reach, &r->to))
        return YK_EXIT_WRONG;
    bool good = find_places(r, &r->to) && (request->pose.count == 0 || find_places(r, &r->from));
    if (request->pose.count == 0) {
        r->from.places[0] = yk_map_start(r->answer->map);
        r->from.count = r->from.places[0].strand != YK_NOT_FOUND;
    }
    if (r->from.count > 1) {
        yk_session_refuse(session, YK_CODE_OPTION_MISSING, "--pose has several configurations at this %s",
                          r->answer->name);
        yk_map_hint_apart(r->answer, r->from.values, r->from.places, r->from.count);
        return YK_EXIT_WRONG;
    }
    if (!good || !find_way(r) || !read_way(r)) {
        yk_session_refuse_for_memory(session);
        return YK_EXIT_WRONG;
    }
    if (request->format == YK_FORMAT_JSON)
        write_json(r);
    else
        write_text(r);
    return yk_session_finish(session, r->way_count > 0 ? YK_EXIT_DONE : YK_EXIT_NO_ANSWER);
}

int yk_map_reach(YkMapAnswer *answer)
{
    Reach r = {.answer = answer, .from = {.option = "--pose"}, .to = {.option = "--reach"}};
    int exit_code = answer_reach(&r);
    return exit_code;
}
