// `yoke cam --format json`; yoke-cam(1) gives its shape.
#include <math.h>
#include "verbs/cam/cam.h"

static void add_size(const YkCamAnswer *answer, YkJson *json)
{
    const YkCamSize *size = &answer->size;
    yk_json_object(json, "cam", YK_JSON_LINES);
    yk_json_string(json, "name", size->name);
    yk_json_string(json, "law", size->law);
    yk_json_string(json, "cam", size->cam);
    yk_json_string(json, "follower", size->follower);
    yk_json_string(json, "carrier", size->carrier);
    yk_json_string(json, "motion", size->oscillates ? "oscillating" : "translating");
    yk_json_string(json, "face", yk_cam_face_name(size->face));
    yk_json_bool(json, "groove", size->is_groove);
    yk_json_bool(json, "conjugate", size->is_conjugate);
    yk_json_number(json, "base", size->base);
    yk_json_number(json, "roller", size->roller);
    yk_json_number(json, "offset", size->offset);
    if (size->oscillates) {
        yk_json_number(json, "arm", size->arm);
        yk_json_number(json, "centers", size->centers);
    }
    yk_json_number(json, "turn", size->turn);
    yk_json_number(json, "period", size->period);
    if (answer->speed != 0) yk_json_number(json, "speed", answer->speed);
    yk_json_end(json);
}

static void add_segment(const YkCamAnswer *answer, YkJson *json, size_t index)
{
    YkCamSegment segment = yk_cam_segment(answer->design, index);
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_string(json, "kind", segment.kind);
    yk_json_number(json, "from", segment.from);
    yk_json_number(json, "to", segment.to);
    if (segment.condition_count > 0) {
        yk_json_list(json, "conditions", YK_JSON_INLINE);
        for (size_t i = 0; i < segment.condition_count; i++) {
            YkCamCondition condition = yk_cam_condition(answer->design, index, i);
            yk_json_object(json, NULL, YK_JSON_INLINE);
            yk_json_number(json, "at", condition.at);
            yk_json_integer(json, "order", condition.order);
            yk_json_number(json, "value", condition.value);
            yk_json_end(json);
        }
        yk_json_end(json);
        yk_json_number(json, "condition_number", segment.condition_number);
    }
    yk_json_end(json);
}

static void add_factors(YkJson *json, YkCamFactors factors)
{
    yk_json_number(json, "Cv", factors.v);
    yk_json_number(json, "Ca", factors.a);
    yk_json_number(json, "Cj", factors.j);
}

static void add_program(const YkCamAnswer *answer, YkJson *json)
{
    YkCamJump jumps[YK_CAM_JUMPS_MAX];
    size_t count = yk_cam_jumps(answer->design, jumps, YK_CAM_JUMPS_MAX);
    yk_json_list(json, "segments", YK_JSON_LINES);
    for (size_t i = 0; i < yk_cam_segment_count(answer->design); i++) add_segment(answer, json, i);
    yk_json_end(json);
    yk_json_list(json, "jumps", YK_JSON_LINES);
    for (size_t i = 0; i < count && i < YK_CAM_JUMPS_MAX; i++) {
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_number(json, "angle", jumps[i].angle);
        yk_json_integer(json, "order", jumps[i].order);
        yk_json_number(json, "size", jumps[i].size);
        yk_json_end(json);
    }
    yk_json_end(json);
    yk_json_list(json, "strokes", YK_JSON_LINES);
    for (size_t i = 0; i < answer->stroke_count; i++) {
        const YkCamStroke *stroke = &answer->strokes[i];
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_number(json, "from", stroke->from);
        yk_json_number(json, "to", stroke->to);
        yk_json_number(json, "lift", stroke->lift);
        add_factors(json, stroke->factors);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_extreme(YkJson *json, const char *key, YkCamExtreme extreme)
{
    yk_json_object(json, key, YK_JSON_INLINE);
    yk_json_number(json, "value", extreme.value);
    yk_json_number(json, "angle", extreme.angle);
    yk_json_end(json);
}

static void add_ranges(YkJson *json, const char *key, const YkCamRange *ranges, size_t count)
{
    yk_json_list(json, key, YK_JSON_INLINE);
    for (size_t i = 0; i < count && i < YK_CAM_RANGES_MAX; i++) {
        yk_json_numbers(json, NULL, (double[]){ranges[i].from, ranges[i].to}, 2);
    }
    yk_json_end(json);
}

static void add_summary(const YkCamAnswer *answer, YkJson *json, const char *key, const YkCamSummary *summary)
{
    static const char *const peaks[] = {"s", "v", "a", "j", "p"};
    yk_json_object(json, key, YK_JSON_LINES);
    for (int k = 0; k < 5; k++) add_extreme(json, peaks[k], summary->peak[k]);
    add_extreme(json, "pressure_angle", summary->pressure);
    add_extreme(json, "pitch_convex", summary->pitch_convex);
    add_extreme(json, "pitch_hollow", summary->pitch_hollow);
    add_extreme(json, "surface_convex", summary->surface_convex);
    add_extreme(json, "surface_hollow", summary->surface_hollow);
    if (answer->size.face == YK_CAM_FACE_FLAT) {
        add_extreme(json, "reach_low", summary->reach_low);
        add_extreme(json, "reach_high", summary->reach_high);
    }
    add_extreme(json, "near", summary->near);
    add_extreme(json, "far", summary->far);
    add_ranges(json, "undercut", summary->undercut, summary->undercut_count);
    if (answer->size.is_groove)
        add_ranges(json, "outer_undercut", summary->outer_undercut, summary->outer_undercut_count);
    yk_json_end(json);
}

static void add_base(const YkCamAnswer *answer, YkJson *json)
{
    yk_json_object(json, "smallest_base", YK_JSON_INLINE);
    yk_json_number(json, "pressure_limit", answer->limits.pressure);
    yk_json_number(json, "curvature_limit", answer->limits.curvature);
    if (answer->base_status == YK_OK) {
        yk_json_number(json, "base", answer->base.base);
        yk_json_number(json, "angle", answer->base.angle);
        yk_json_string(json, "by", answer->base.by_pressure ? "pressure" : "curvature");
    } else {
        yk_json_null(json, "base");
    }
    yk_json_end(json);
}

static void add_forces(const YkCamAnswer *answer, YkJson *json)
{
    const YkCamForceSummary *forces = &answer->forces;
    if (!answer->has_forces) return;
    yk_json_object(json, "forces", YK_JSON_LINES);
    yk_json_number(json, "speed", answer->speed);
    yk_json_number(json, "inertia", answer->loads.inertia);
    yk_json_number(json, "stiffness", answer->loads.stiffness);
    yk_json_number(json, "damping", answer->loads.damping);
    yk_json_number(json, "preload", answer->loads.preload);
    yk_json_bool(json, "complete", !answer->loads.is_partial);
    add_extreme(json, "contact_low", forces->contact_low);
    add_extreme(json, "contact_high", forces->contact_high);
    add_extreme(json, "torque_low", forces->torque_low);
    add_extreme(json, "torque_high", forces->torque_high);
    yk_json_number(json, "torque_mean", forces->torque_mean);
    yk_json_number(json, "jump_speed", forces->jump_speed);
    if (isfinite(forces->jump_speed)) yk_json_number(json, "jump_angle", forces->jump_angle);
    yk_json_number(json, "preload_needed", forces->preload_needed);
    yk_json_end(json);
}

static void add_others(const YkCamAnswer *answer, YkJson *json)
{
    if (answer->other_count == 0) return;
    yk_json_list(json, "compare", YK_JSON_LINES);
    for (size_t i = 0; i < answer->other_count; i++) {
        const YkCamOther *other = &answer->others[i];
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "law", other->law);
        add_factors(json, other->factors);
        add_extreme(json, "v", other->summary.peak[1]);
        add_extreme(json, "a", other->summary.peak[2]);
        add_extreme(json, "j", other->summary.peak[3]);
        add_extreme(json, "pressure_angle", other->summary.pressure);
        add_extreme(json, "surface_convex", other->summary.surface_convex);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_rows(const YkCamAnswer *answer, YkJson *json)
{
    YkCamColumn columns[YK_CAM_COLUMNS_MAX];
    double values[YK_CAM_COLUMNS_MAX];
    size_t count = yk_cam_columns(answer, columns);
    yk_json_list(json, "columns", YK_JSON_INLINE);
    for (size_t c = 0; c < count; c++) yk_json_string(json, NULL, columns[c].name);
    yk_json_end(json);
    yk_json_list(json, "rows", YK_JSON_LINES);
    for (size_t row = 0; row <= answer->steps && answer->steps > 0; row++) {
        yk_cam_row(answer, yk_cam_row_angle(answer, row), values);
        yk_json_numbers(json, NULL, values, count);
    }
    yk_json_end(json);
}

void yk_cam_json(const YkCamAnswer *answer)
{
    YkJson json = {.text = &answer->session->out};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_string(&json, "model", yk_model_name(answer->session->model));
    yk_json_string(&json, "status", yk_status_name(YK_OK));
    add_size(answer, &json);
    add_program(answer, &json);
    add_summary(answer, &json, "summary", &answer->summary);
    if (answer->size.is_conjugate) add_summary(answer, &json, "second", &answer->second);
    add_base(answer, &json);
    add_forces(answer, &json);
    add_others(answer, &json);
    add_rows(answer, &json);
    yk_json_end(&json);
}
