// `yoke gears --format json`.
#include <math.h>
#include "verbs/gears/gears.h"
#include "write/json.h"

static void add_code(const YkGearsAnswer *answer, YkJson *json)
{
    YkTrainStatus status = yk_train_status(answer->train);
    yk_json_string(json, "model", yk_model_name(answer->session->model));
    yk_json_string(json, "status", yk_train_status_name(status));
    yk_json_integer(json, "freedom", yk_train_freedom(answer->train));
    yk_json_string(json, "lock", yk_train_lock(answer->train));
    if (status == YK_TRAIN_STATUS_OK) return;
    yk_json_string(json, "message", yk_train_message(answer->train));
    if (status != YK_TRAIN_STATUS_FREE)
        yk_json_string(json, "code", status == YK_TRAIN_STATUS_LOCKED ? "E0515" : "E0516");
}

static void add_inputs(const YkGearsAnswer *answer, YkJson *json)
{
    yk_json_list(json, "inputs", YK_JSON_LINES);
    for (size_t k = 0; k < yk_train_input_count(answer->train); k++) {
        YkTrainInput input = yk_train_input(answer->train, k);
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "name", input.name);
        yk_json_string(json, "kind", input.is_unit ? "turn" : input.is_distance ? "distance" : "angle");
        yk_json_number(json, "speed", input.speed);
        yk_json_string(json, "exact", input.exact);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_body(const YkGearsAnswer *answer, YkJson *json, size_t member)
{
    YkTrainBody body = yk_train_body(answer->train, member);
    yk_json_object(json, yk_gears_body(answer, body.body), YK_JSON_INLINE);
    yk_json_number(json, "speed", body.speed);
    yk_json_string(json, "exact", body.exact);
    yk_json_object(json, "shares", YK_JSON_INLINE);
    for (size_t k = 0; body.is_determined && k < yk_train_input_count(answer->train); k++) {
        YkTrainShare share = yk_train_share(answer->train, member, k);
        yk_json_object(json, yk_train_input(answer->train, k).name, YK_JSON_INLINE);
        yk_json_number(json, "value", share.value);
        yk_json_string(json, "exact", share.exact);
        yk_json_string(json, "formula", share.formula);
        yk_json_end(json);
    }
    yk_json_end(json);
    yk_json_end(json);
}

static void add_bodies(const YkGearsAnswer *answer, YkJson *json)
{
    yk_json_object(json, "bodies", YK_JSON_LINES);
    for (size_t i = 0; i < yk_train_body_count(answer->train); i++) add_body(answer, json, i);
    yk_json_end(json);
}

static void add_pair(YkJson *json, const char *key, const double pair[2], bool is_known)
{
    yk_json_list(json, key, YK_JSON_INLINE);
    for (int k = 0; k < 2; k++) yk_json_number(json, NULL, is_known ? pair[k] : NAN);
    yk_json_end(json);
}

static void add_mesh_power(const YkGearsAnswer *answer, YkJson *json, const YkTrainMesh *mesh)
{
    add_pair(json, "torques", mesh->torque, mesh->has_power);
    yk_json_number(json, "carrier_torque", mesh->has_power ? mesh->carrier_torque : NAN);
    yk_json_string(json, "driver", mesh->driver < 0 ? NULL : yk_gears_body(answer, mesh->body[mesh->driver]));
    yk_json_number(json, "rolling_power", mesh->has_power ? mesh->rolling_power : NAN);
    yk_json_number(json, "loss", mesh->has_power ? mesh->loss : NAN);
}

static void add_meshes(const YkGearsAnswer *answer, YkJson *json)
{
    yk_json_object(json, "meshes", YK_JSON_LINES);
    for (size_t m = 0; m < yk_train_mesh_count(answer->train); m++) {
        YkTrainMesh mesh = yk_train_mesh(answer->train, m);
        yk_json_object(json, mesh.name, YK_JSON_INLINE);
        yk_json_string(json, "kind", yk_gears_kind(mesh.kind));
        yk_json_bool(json, "internal", mesh.is_internal);
        yk_json_list(json, "bodies", YK_JSON_INLINE);
        for (int k = 0; k < 2; k++) yk_json_string(json, NULL, yk_gears_body(answer, mesh.body[k]));
        yk_json_end(json);
        yk_json_string(json, "carrier", yk_gears_body(answer, mesh.carrier));
        yk_json_list(json, "teeth", YK_JSON_INLINE);
        for (int k = 0; k < 2 && mesh.kind == YK_TRAIN_KIND_GEARS; k++) yk_json_integer(json, NULL, mesh.teeth[k]);
        yk_json_end(json);
        yk_json_list(json, "symbols", YK_JSON_INLINE);
        for (int k = 0; k < 2; k++) yk_json_string(json, NULL, mesh.symbol[k]);
        yk_json_end(json);
        add_pair(json, "radii", mesh.radius, mesh.radius[0] > 0);
        yk_json_number(json, "distance", mesh.distance > 0 ? mesh.distance : NAN);
        yk_json_string(json, "willis", mesh.willis);
        yk_json_number(json, "rack_speed", yk_train_rack_speed(answer->train, m));
        add_mesh_power(answer, json, &mesh);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_ratio(const YkGearsAnswer *answer, YkJson *json, const YkTrainRatio *ratio)
{
    yk_json_object(json, "ratio", YK_JSON_INLINE);
    yk_json_string(json, "in", yk_gears_body(answer, ratio->in));
    yk_json_string(json, "out", yk_gears_body(answer, ratio->out));
    yk_json_number(json, "value", ratio->is_known && !ratio->out_stands ? ratio->value : NAN);
    yk_json_string(json, "exact", ratio->exact);
    yk_json_string(json, "formula", ratio->formula);
    yk_json_bool(json, "output_stands", ratio->out_stands);
    yk_json_bool(json, "at_these_inputs", ratio->is_by_drives);
    yk_json_end(json);
}

static void add_ratios(const YkGearsAnswer *answer, YkJson *json)
{
    YkTrainRatio ratio = yk_train_ratio(answer->train);
    if (ratio.is_known) {
        add_ratio(answer, json, &ratio);
    } else {
        yk_json_null(json, "ratio");
    }
    yk_json_object(json, "shift_table", YK_JSON_LINES);
    for (size_t i = 0; i < yk_train_gear_count(answer->train); i++) {
        YkTrainGear gear = yk_train_gear(answer->train, i);
        yk_json_object(json, gear.lock, YK_JSON_INLINE);
        yk_json_string(json, "status", yk_train_status_name(gear.status));
        yk_json_integer(json, "freedom", gear.freedom);
        if (gear.status != YK_TRAIN_STATUS_OK) yk_json_string(json, "message", gear.message);
        add_ratio(answer, json, &gear.ratio);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_table(const YkGearsAnswer *answer, YkJson *json, const YkTrainTable *table)
{
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_string(json, "carrier", yk_gears_body(answer, table->carrier));
    yk_json_object(json, "turns", YK_JSON_INLINE);
    for (size_t k = 0; k < table->count; k++)
        yk_json_string(json, yk_gears_body(answer, table->body[k]), table->turns[k]);
    yk_json_end(json);
    yk_json_number(json, "x", table->has_speeds ? table->x : NAN);
    yk_json_number(json, "y", table->has_speeds ? table->y : NAN);
    yk_json_string(json, "exact_x", table->exact_x);
    yk_json_string(json, "exact_y", table->exact_y);
    yk_json_end(json);
}

static void add_torques(const YkGearsAnswer *answer, YkJson *json)
{
    YkTrainPower power = yk_train_power(answer->train);
    yk_json_list(json, "torques", YK_JSON_LINES);
    for (size_t i = 0; i < yk_train_torque_count(answer->train); i++) {
        YkTrainTorque torque = yk_train_torque(answer->train, i);
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "name", torque.name);
        yk_json_string(json, "role", torque.role);
        yk_json_string(json, "on", yk_gears_body(answer, torque.on));
        yk_json_string(json, "from", yk_gears_body(answer, torque.from));
        yk_json_number(json, "torque", torque.torque);
        yk_json_number(json, "power", torque.power);
        yk_json_end(json);
    }
    yk_json_end(json);
    if (!power.is_known) {
        yk_json_null(json, "power");
        return;
    }
    yk_json_object(json, "power", YK_JSON_INLINE);
    yk_json_number(json, "in", power.in);
    yk_json_number(json, "out", power.out);
    yk_json_number(json, "loss", power.loss);
    yk_json_number(json, "efficiency", power.efficiency);
    yk_json_number(json, "circulating", power.circulating);
    yk_json_string(json, "mesh", power.mesh);
    yk_json_end(json);
}

void yk_gears_json(const YkGearsAnswer *answer)
{
    YkJson json = {.text = &answer->session->out};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    add_code(answer, &json);
    add_inputs(answer, &json);
    add_bodies(answer, &json);
    add_meshes(answer, &json);
    add_ratios(answer, &json);
    yk_json_list(&json, "tabular", YK_JSON_LINES);
    for (size_t i = 0; i < yk_train_table_count(answer->train); i++) {
        YkTrainTable table = yk_train_table(answer->train, i);
        add_table(answer, &json, &table);
    }
    yk_json_end(&json);
    add_torques(answer, &json);
    yk_json_list(&json, "remarks", YK_JSON_LINES);
    for (size_t i = 0; i < yk_train_remark_count(answer->train); i++) {
        YkTrainRemark remark = yk_train_remark(answer->train, i);
        yk_json_object(&json, NULL, YK_JSON_INLINE);
        yk_json_string(&json, "mesh", remark.mesh);
        yk_json_bool(&json, "fault", remark.is_fault);
        yk_json_string(&json, "text", remark.text);
        yk_json_end(&json);
    }
    yk_json_end(&json);
    yk_json_end(&json);
}
