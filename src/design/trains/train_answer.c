// The answers of a train.
#include <math.h>
#include "design/trains/train.h"

YkTrainStatus yk_train_status(const YkTrain *train)
{
    return train->motion.status;
}

const char *yk_train_message(const YkTrain *train)
{
    return train->motion.message;
}

int yk_train_freedom(const YkTrain *train)
{
    return train->freedom;
}

const char *yk_train_lock(const YkTrain *train)
{
    return train->options.lock;
}

size_t yk_train_input_count(const YkTrain *train)
{
    return (size_t)train->drive_count;
}

YkTrainInput yk_train_input(const YkTrain *train, size_t input)
{
    if (input >= yk_train_input_count(train)) return (YkTrainInput){.speed = (double)NAN};
    return train->drives[input].shown;
}

size_t yk_train_body_count(const YkTrain *train)
{
    return (size_t)train->net.bodies - 1;
}

YkTrainBody yk_train_body(const YkTrain *train, size_t member)
{
    if (member >= yk_train_body_count(train)) return (YkTrainBody){.body = YK_NOT_FOUND, .speed = (double)NAN};
    return train->bodies[member];
}

YkTrainShare yk_train_share(const YkTrain *train, size_t member, size_t input)
{
    if (member >= yk_train_body_count(train) || input >= yk_train_input_count(train))
        return (YkTrainShare){.value = (double)NAN};
    return train->shares[member * (size_t)train->drive_count + input];
}

size_t yk_train_mesh_count(const YkTrain *train)
{
    return (size_t)train->net.mesh_count;
}

static void add_gears(const YkGear *gear, YkTrainMesh *mesh)
{
    mesh->kind = YK_TRAIN_KIND_GEARS;
    mesh->name = gear->name;
    mesh->carrier = (size_t)gear->carrier;
    mesh->is_internal = gear->is_internal;
    mesh->module = gear->module;
    for (int k = 0; k < 2; k++) {
        mesh->body[k] = (size_t)gear->body[k];
        mesh->teeth[k] = gear->teeth[k];
        mesh->radius[k] = gear->module * (double)gear->teeth[k] / 2;
    }
    if (gear->module > 0) mesh->distance = mesh->radius[1] + (gear->is_internal ? -1 : 1) * mesh->radius[0];
}

static void add_belt(const YkBelt *belt, YkTrainMesh *mesh)
{
    mesh->kind = YK_TRAIN_KIND_BELT;
    mesh->name = belt->name;
    mesh->carrier = (size_t)belt->carrier;
    mesh->is_internal = !belt->is_crossed;
    for (int k = 0; k < 2; k++) {
        mesh->body[k] = (size_t)belt->body[k];
        mesh->radius[k] = belt->radius[k];
    }
}

static void add_rack(const YkRack *rack, YkTrainMesh *mesh)
{
    mesh->kind = YK_TRAIN_KIND_RACK;
    mesh->name = rack->name;
    mesh->carrier = (size_t)rack->carrier;
    mesh->body[0] = (size_t)rack->pinion;
    mesh->body[1] = (size_t)rack->rack;
    mesh->radius[0] = rack->radius;
}

static void add_power(const YkTrainMeshPower *power, YkTrainMesh *mesh)
{
    mesh->driver = -1;
    if (!power || !power->is_known) return;
    mesh->has_power = true;
    mesh->torque[0] = power->torque[0];
    mesh->torque[1] = power->torque[1];
    mesh->carrier_torque = power->carrier_torque;
    mesh->rolling_power = power->rolling_power;
    mesh->driver = power->driver;
    mesh->loss = power->loss;
}

// The answer for a mesh that does not exist.
static const YkTrainMesh no_mesh = {.body = {YK_NOT_FOUND, YK_NOT_FOUND},
                                    .carrier = YK_NOT_FOUND,
                                    .module = (double)NAN,
                                    .radius = {(double)NAN, (double)NAN},
                                    .distance = (double)NAN,
                                    .torque = {(double)NAN, (double)NAN},
                                    .carrier_torque = (double)NAN,
                                    .rolling_power = (double)NAN,
                                    .driver = -1,
                                    .loss = (double)NAN};

YkTrainMesh yk_train_mesh(const YkTrain *train, size_t index)
{
    if (index >= yk_train_mesh_count(train)) return no_mesh;
    const YkModel *model = train->model;
    YkTrainMesh mesh = {.willis = train->willis ? train->willis[index] : NULL};
    if (index < model->gear_count) {
        add_gears(&model->gears[index], &mesh);
    } else if (index < model->gear_count + model->belt_count) {
        add_belt(&model->belts[index - model->gear_count], &mesh);
    } else {
        add_rack(&model->racks[index - model->gear_count - model->belt_count], &mesh);
    }
    for (int k = 0; k < 2; k++) {
        int32_t symbol = train->net.symbol_of[index][k];
        mesh.symbol[k] = symbol < 0 ? "" : train->net.symbols[symbol].name;
    }
    add_power(train->mesh_power ? &train->mesh_power[index] : NULL, &mesh);
    return mesh;
}

double yk_train_rack_speed(const YkTrain *train, size_t mesh)
{
    return mesh < yk_train_mesh_count(train) ? train->rack_speeds[mesh] : (double)NAN;
}

YkTrainRatio yk_train_ratio(const YkTrain *train)
{
    return train->ratio;
}

size_t yk_train_gear_count(const YkTrain *train)
{
    return train->gear_count;
}

YkTrainGear yk_train_gear(const YkTrain *train, size_t gear)
{
    if (gear >= train->gear_count)
        return (YkTrainGear){.ratio = {.in = YK_NOT_FOUND, .out = YK_NOT_FOUND, .value = (double)NAN}};
    return train->gears[gear];
}

size_t yk_train_table_count(const YkTrain *train)
{
    return train->group_count;
}

YkTrainTable yk_train_table(const YkTrain *train, size_t table)
{
    if (table >= train->group_count) return (YkTrainTable){.carrier = YK_NOT_FOUND, .x = (double)NAN, .y = (double)NAN};
    const YkTrainGroup *group = &train->groups[table];
    return (YkTrainTable){.carrier = (size_t)group->carrier,
                          .count = (size_t)group->count,
                          .body = group->body,
                          .turns = group->turns,
                          .turns_value = group->turns_value,
                          .has_speeds = group->has_speeds,
                          .x = group->x,
                          .y = group->y,
                          .exact_x = group->exact_x,
                          .exact_y = group->exact_y};
}

size_t yk_train_torque_count(const YkTrain *train)
{
    return train->torque_count;
}

YkTrainTorque yk_train_torque(const YkTrain *train, size_t torque)
{
    if (torque >= train->torque_count)
        return (YkTrainTorque){.on = YK_NOT_FOUND, .from = YK_NOT_FOUND, .torque = (double)NAN, .power = (double)NAN};
    return train->torques[torque];
}

YkTrainPower yk_train_power(const YkTrain *train)
{
    return train->power;
}

size_t yk_train_remark_count(const YkTrain *train)
{
    return train->remark_count;
}

YkTrainRemark yk_train_remark(const YkTrain *train, size_t remark)
{
    if (remark >= train->remark_count) return (YkTrainRemark){.text = NULL};
    return train->remarks[remark];
}
