// `yoke map` for people.
#include <math.h>
#include "verbs/map/map.h"
#include "write/table.h"

enum { EVENT_DIGITS = 12 };
static const double meeting_known = 1e-9; // rad, or machine sizes: where a change point is known to lie

static void add_count(YkText *text, size_t count, const char *one, const char *many)
{
    static const char *const words[] = {"no", "one", "two", "three", "four", "five", "six"};
    if (count < sizeof words / sizeof *words)
        yk_text_puts(text, words[count]);
    else
        yk_text_format(text, "%z", count);
    yk_text_format(text, " %s", count == 1 ? one : many);
}

static bool is_whole(const YkMapAnswer *answer, YkRange range)
{
    YkRange domain = yk_map_domain(answer->map);
    return answer->quantity == YK_QUANTITY_ANGLE && range.to - range.from > (domain.to - domain.from) * (1 - 1e-12);
}

// Writes "theta1 from 12.4 to 167.9 deg and from 190 to 200 deg", or "theta1 turns fully".
static void add_ranges(const YkMapAnswer *answer, size_t circuit, size_t count, YkText *text)
{
    const YkSession *session = answer->session;
    yk_text_puts(text, answer->name);
    for (size_t k = 0; k < count; k++) {
        YkRange range = yk_map_range(answer->map, circuit, k);
        if (is_whole(answer, range)) {
            yk_text_puts(text, " at every angle");
            return;
        }
        yk_text_format(text, "%s from %e to %e %s", k == 0 ? "" : " and",
                       yk_shown(session, range.from, answer->quantity), yk_shown(session, range.to, answer->quantity),
                       yk_unit_of(session, answer->quantity));
    }
}

// Writes the joints that turn fully, or a "none".
static void add_full_turns(const YkMapAnswer *answer, size_t circuit)
{
    const YkSession *session = answer->session;
    size_t count = 0;
    for (size_t j = 0; j < yk_model_joint_count(session->model); j++) {
        if (!yk_map_turn(answer->map, circuit, j).is_full) continue;
        yk_text_format(&answer->session->out, "%s%s", count++ == 0 ? "  turn fully: " : ", ",
                       yk_model_joint_name(session->model, j));
    }
    yk_text_puts(&answer->session->out, count > 0 ? "\n" : "  no joint turns fully\n");
}

static void add_circuit(const YkMapAnswer *answer, size_t circuit)
{
    YkMapCircuit c = yk_map_circuit(answer->map, circuit);
    YkText *out = &answer->session->out;
    yk_text_format(out, "\ncircuit %z: ", circuit + 1);
    add_ranges(answer, circuit, c.ranges, out);
    yk_text_puts(out, ", ");
    add_count(out, c.branches, "branch", "branches");
    yk_text_puts(out, c.contains_start ? "; contains the start\n" : "; does not contain the start\n");
    add_full_turns(answer, circuit);
}

static const char *word_of(YkMapEventKind kind)
{
    switch (kind) {
    case YK_MAP_LIMIT:
        return "limit";
    case YK_MAP_CHANGE_POINT:
        return "change point";
    case YK_MAP_DEAD_POINT:
        return "dead point";
    default:
        return "end of the map";
    }
}

// Returns a value in the file's unit. Poses at events are known to the square root of the mapped coordinate's rounding.
static double shown(const YkMapAnswer *answer, double value, bool is_distance)
{
    double noise = 1e-8 * (is_distance ? yk_mechanism_size(answer->session->mech) : 1);
    return fabs(value) < noise ? 0 : yk_shown(answer->session, value, yk_quantity_of(is_distance, 0));
}

// Writes the place of an event to the digits that are known.
static void add_place(const YkMapAnswer *answer, YkTable *table, YkMapEvent event)
{
    bool is_angle = answer->quantity == YK_QUANTITY_ANGLE;
    double known = meeting_known * (is_angle ? 1 : yk_mechanism_size(answer->session->mech));
    int digits = EVENT_DIGITS;
    if (event.kind == YK_MAP_CHANGE_POINT || event.kind == YK_MAP_DEAD_POINT)
        for (digits = 1; digits < EVENT_DIGITS && fabs(event.at) >= 10 * known; digits++) known *= 10;
    bool is_noise = digits == 1 && fabs(event.at) < known;
    yk_table_number(table, is_noise ? 0 : yk_shown(answer->session, event.at, answer->quantity), digits);
}

static void add_event_row(const YkMapAnswer *answer, YkTable *table, size_t circuit, size_t k)
{
    const YkSession *session = answer->session;
    YkMapEvent event = yk_map_event(answer->map, circuit, k);
    const char *of = yk_map_event_of(answer, event);
    yk_table_number(table, (double)circuit + 1, YK_DIGITS);
    yk_table_word(table, word_of(event.kind));
    yk_table_word(table, of ? of : "");
    add_place(answer, table, event);
    for (size_t c = 0; c < yk_coordinate_count(session->mech); c++) {
        YkCoordinateInfo info = yk_coordinate_info(session->mech, c);
        if (c == yk_map_coordinate(answer->map) || !info.is_declared) continue;
        double value = yk_map_event_value(answer->map, circuit, k, c);
        yk_table_number(table, shown(answer, value, info.is_distance), YK_DIGITS);
    }
}

static void add_events(const YkMapAnswer *answer)
{
    const YkSession *session = answer->session;
    size_t shown = 0, events = 0;
    for (size_t c = 0; c < yk_coordinate_count(session->mech); c++)
        shown += yk_coordinate_info(session->mech, c).is_declared && c != yk_map_coordinate(answer->map);
    for (size_t k = 0; k < yk_map_circuit_count(answer->map); k++) events += yk_map_circuit(answer->map, k).events;
    if (events == 0) return;
    YkTable *table = yk_table_new(4 + shown);
    yk_table_head(table, "circuit", NULL);
    yk_table_head(table, "event", NULL);
    yk_table_head(table, "of", NULL);
    yk_table_head(table, answer->name, yk_unit_of(session, answer->quantity));
    for (size_t c = 0; c < yk_coordinate_count(session->mech); c++) {
        YkCoordinateInfo info = yk_coordinate_info(session->mech, c);
        if (c == yk_map_coordinate(answer->map) || !info.is_declared) continue;
        yk_table_head(table, info.name, yk_unit_of(session, yk_quantity_of(info.is_distance, 0)));
    }
    for (size_t circuit = 0; circuit < yk_map_circuit_count(answer->map); circuit++)
        for (size_t k = 0; k < yk_map_circuit(answer->map, circuit).events; k++)
            add_event_row(answer, table, circuit, k);
    yk_table_show(table, NULL, &answer->session->out);
}

void yk_map_text(const YkMapAnswer *answer)
{
    YkSession *session = answer->session;
    YkText *out = &session->out;
    yk_scale_begin(session);
    yk_text_format(out, "%s: map over %s, ", yk_model_name(session->model), answer->name);
    add_count(out, yk_map_circuit_count(answer->map), "circuit", "circuits");
    yk_text_format(out, "; %s%s\n",
                   yk_map_is_complete(answer->map) ? "" : "not complete: ", yk_map_message(answer->map));
    for (size_t k = 0; k < yk_map_circuit_count(answer->map); k++) add_circuit(answer, k);
    add_events(answer);
}
