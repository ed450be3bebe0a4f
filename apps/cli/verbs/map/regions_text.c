// `yoke map --over A,B` for people, and as JSON.
#include <string.h>
#include "session.h"
#include "verbs/map/map.h"
#include "write/table.h"

// Returns the joint that names a block, or, if that is the one by which a point is carried, the block's last own joint;
// NULL at the end of the map.
static const char *name_of(const YkRegionsAnswer *answer, YkRegionBound bound)
{
    if (bound.block < 0) return NULL;
    YkBlockInfo info = yk_block_info(answer->mech, (size_t)bound.block);
    if (strncmp(info.label, YK_MAP_CARRIAGE, strlen(YK_MAP_CARRIAGE)) != 0) return info.label;
    const YkModel *model = answer->model ? answer->model : answer->session->model;
    for (size_t k = info.joint_count; k-- > 0;) {
        const char *name = yk_model_joint_name(model, yk_block_joint(answer->mech, (size_t)bound.block, k));
        if (strncmp(name, YK_MAP_CARRIAGE, strlen(YK_MAP_CARRIAGE)) != 0) return name;
    }
    return info.label;
}

// Writes "P 62 %, Q 38 %".
static void add_bounds(const YkRegionsAnswer *answer, size_t region, size_t count, YkText *text)
{
    yk_text_clear(text);
    for (size_t k = 0; k < count; k++) {
        YkRegionBound bound = yk_regions_bound(answer->regions, region, k);
        const char *name = name_of(answer, bound);
        yk_text_format(text, "%s%s", k == 0 ? "" : ", ", name ? name : "end of the map");
        if (count > 1) yk_text_format(text, " %d %%", (int)(100 * bound.part + 0.5));
    }
}

static void add_head(const YkRegionsAnswer *answer, YkTable *table)
{
    YkText unit = {0};
    const char *units[2];
    for (int k = 0; k < 2; k++) units[k] = yk_unit_of(answer->session, answer->quantity[k]);
    if (answer->quantity[0] == answer->quantity[1])
        yk_text_format(&unit, "%s^2", units[0]);
    else
        yk_text_format(&unit, "%s %s", units[0], units[1]);
    yk_table_head(table, "region", NULL);
    yk_table_head(table, "configurations", NULL);
    yk_table_head(table, "area", yk_text_get(&unit));
    for (int k = 0; k < 2; k++) {
        yk_table_head(table, answer->names[k], units[k]);
        yk_table_head(table, "to", NULL);
    }
    yk_table_head(table, "bounded by", NULL);
    if (unit.failed) yk_session_run_out(answer->session);
    yk_text_free(&unit);
}

static void add_row(const YkRegionsAnswer *answer, YkTable *table, size_t k, YkText *bounds)
{
    const YkSession *session = answer->session;
    YkRegion region = yk_regions_region(answer->regions, k);
    double per_area = yk_shown(session, 1, answer->quantity[0]) * yk_shown(session, 1, answer->quantity[1]);
    yk_table_number(table, (double)k + 1, YK_DIGITS);
    yk_table_number(table, region.configurations, YK_DIGITS);
    yk_table_number(table, region.area * per_area, YK_DIGITS);
    for (int axis = 0; axis < 2; axis++) {
        yk_table_number(table, yk_shown(session, region.range[axis].from, answer->quantity[axis]), YK_DIGITS);
        yk_table_number(table, yk_shown(session, region.range[axis].to, answer->quantity[axis]), YK_DIGITS);
    }
    add_bounds(answer, k, region.bounds, bounds);
    yk_table_word(table, yk_text_get(bounds));
}

void yk_map_regions_text(const YkRegionsAnswer *answer)
{
    YkSession *session = answer->session;
    YkText *out = &session->out, bounds = {0};
    size_t count = yk_regions_count(answer->regions);
    bool has_start = count > 0 && yk_regions_region(answer->regions, 0).contains_start;
    yk_scale_begin(session);
    yk_text_format(
        out, "%s: map over %s and %s, %z %s; %s%s\n", yk_model_name(session->model), answer->names[0], answer->names[1],
        count, count == 1 ? "region" : "regions",
        yk_regions_are_complete(answer->regions) ? "" : "not complete: ", yk_regions_message(answer->regions));
    yk_text_puts(out, "what is narrower than ");
    for (int k = 0; k < 2; k++)
        yk_text_format(out, "%s%e %s", k == 0 ? "" : " or ",
                       yk_shown(session, yk_regions_tolerance(answer->regions, k), answer->quantity[k]),
                       yk_unit_of(session, answer->quantity[k]));
    yk_text_puts(out, " may be missing\n\n");
    YkTable *table = yk_table_new(8);
    add_head(answer, table);
    for (size_t k = 0; k < count; k++) add_row(answer, table, k, &bounds);
    yk_table_write(table, 2, out);
    yk_table_free(table);
    if (has_start) yk_text_puts(out, "\nregion 1 contains the start\n");
    if (bounds.failed) yk_session_run_out(session);
    yk_text_free(&bounds);
}

// --- JSON

static void add_outline(const YkRegionsAnswer *answer, YkJson *json, const char *key, size_t region, size_t outline)
{
    size_t count;
    const double *points = yk_regions_outline(answer->regions, region, outline, &count);
    yk_json_list(json, key, YK_JSON_INLINE);
    for (size_t k = 0; k < count; k++) {
        yk_json_numbers(json, NULL, points + 2 * k, 2);
    }
    yk_json_end(json);
}

static void add_region(const YkRegionsAnswer *answer, YkJson *json, size_t k)
{
    YkRegion region = yk_regions_region(answer->regions, k);
    yk_json_object(json, NULL, YK_JSON_LINES);
    yk_json_integer(json, "configurations", region.configurations);
    yk_json_bool(json, "contains_start", region.contains_start);
    yk_json_number(json, "area", region.area);
    yk_json_list(json, "bounds", YK_JSON_LINES);
    for (size_t b = 0; b < region.bounds; b++) {
        YkRegionBound bound = yk_regions_bound(answer->regions, k, b);
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "of", name_of(answer, bound));
        yk_json_number(json, "part", bound.part);
        yk_json_end(json);
    }
    yk_json_end(json);
    add_outline(answer, json, "polygon", k, 0);
    yk_json_list(json, "holes", YK_JSON_LINES);
    for (size_t o = 1; o < region.outlines; o++) add_outline(answer, json, NULL, k, o);
    yk_json_end(json);
    yk_json_end(json);
}

static void add_pair(YkJson *json, const char *key, double first, double second)
{
    yk_json_numbers(json, key, (double[]){first, second}, 2);
}

void yk_map_regions_json(const YkRegionsAnswer *answer)
{
    const YkRegions *r = answer->regions;
    YkJson json = {.text = &answer->session->out};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_head(&json, answer->session, YK_OK, "");
    yk_json_list(&json, "coordinates", YK_JSON_INLINE);
    for (int k = 0; k < 2; k++) yk_json_string(&json, NULL, answer->names[k]);
    yk_json_end(&json);
    yk_json_list(&json, "domain", YK_JSON_INLINE);
    for (int k = 0; k < 2; k++) add_pair(&json, NULL, yk_regions_domain(r, k).from, yk_regions_domain(r, k).to);
    yk_json_end(&json);
    add_pair(&json, "tolerance", yk_regions_tolerance(r, 0), yk_regions_tolerance(r, 1));
    yk_json_bool(&json, "complete", yk_regions_are_complete(r));
    yk_json_string(&json, "reason", yk_regions_message(r));
    yk_json_number(&json, "proved", yk_regions_proved(r));
    yk_json_list(&json, "regions", YK_JSON_LINES);
    for (size_t k = 0; k < yk_regions_count(r); k++) add_region(answer, &json, k);
    yk_json_end(&json);
    yk_json_end(&json);
}
