// Lists the external torques, and finds where the power goes.
#include <math.h>
#include "design/trains/train_torques.h"

static void add_torque(YkTrain *train, const char *name, const char *role, int32_t on, int32_t from, double torque)
{
    double speed = yk_train_column_speed(train, train->net.column_of[on]) -
                   yk_train_column_speed(train, train->net.column_of[from]);
    bool has_power = train->drive_count > 0 && !train->drives[0].shown.is_unit;
    train->torques[train->torque_count++] = (YkTrainTorque){.name = name,
                                                            .role = role,
                                                            .on = (size_t)on,
                                                            .from = (size_t)from,
                                                            .torque = torque,
                                                            .power = has_power ? torque * speed : NAN};
}

static void add_along(YkTrain *train, int32_t coordinate, const char *role, double torque)
{
    const YkCoordinate *c = &train->model->coordinates[coordinate];
    const YkJoint *joint = &train->model->joints[c->joint];
    if (!c->is_distance) {
        add_torque(train, c->name, role, joint->body[1], joint->body[0], torque);
        return;
    }
    for (size_t r = 0; r < train->model->rack_count; r++) {
        if (train->model->racks[r].slide != c->joint) continue;
        bool has_power = train->drive_count > 0 && !train->drives[0].shown.is_unit;
        double speed = yk_train_column_speed(train, train->net.bodies + (int32_t)r);
        train->torques[train->torque_count++] = (YkTrainTorque){.name = c->name,
                                                                .role = role,
                                                                .on = (size_t)joint->body[1],
                                                                .from = (size_t)joint->body[0],
                                                                .torque = torque,
                                                                .power = has_power ? torque * speed : NAN};
    }
}

// Adds a weld to the ground, which holds a body as a lock does; a slide too, if there is something to hold.
static void add_kept(YkTrain *train, const YkJoint *joint, double torque)
{
    int32_t held = joint->body[joint->body[1] == 0 ? 0 : 1], other = joint->body[joint->body[1] == 0 ? 1 : 0];
    if (other != 0 || (joint->kind != YK_WELD && torque == 0)) return;
    add_torque(train, train->model->bodies[held].name, "hold", held, 0, joint->body[1] == held ? torque : -torque);
}

static void add_row(YkTrainBalance *work, int32_t r)
{
    YkTrain *train = work->train;
    const YkTrainRow *row = &train->motion.rows[r];
    const YkLock *lock = train->motion.lock;
    double torque = yk_train_multiplier(work, r);
    if (isnan(torque)) return;
    if (row->kind == YK_ROW_INPUT) {
        const YkTrainDrive *drive = &train->drives[row->index];
        if (drive->coordinate != YK_NONE) {
            add_along(train, drive->coordinate, "drive", torque);
        } else {
            add_torque(train, drive->shown.name, "drive", drive->body, 0, torque);
        }
    } else if (row->kind == YK_ROW_HOLD) {
        const YkHold *hold = &lock->holds[row->index];
        if (hold->body != YK_NONE) {
            add_torque(train, train->model->bodies[hold->body].name, "hold", hold->body, 0, torque);
        } else if (row->count > 0) {
            add_along(train, hold->coordinate, "hold", torque);
        }
    } else if (row->kind == YK_ROW_JOIN) {
        const int32_t *pair = lock->joins[row->index];
        add_torque(train, train->model->bodies[pair[1]].name, "join", pair[1], pair[0], torque);
    } else if (row->kind == YK_ROW_KEPT) {
        add_kept(train, &train->model->joints[row->index], torque);
    }
}

bool yk_train_list_torques(YkTrainBalance *work)
{
    YkTrain *train = work->train;
    train->torques = YK_NEW(train->arena, YkTrainTorque,
                            (size_t)train->motion.row_count + (size_t)work->known_count + train->model->rack_count + 1);
    if (!train->torques) return false;
    for (int32_t r = 0; r < train->motion.row_count; r++)
        if (train->motion.rows[r].kind == YK_ROW_INPUT) add_row(work, r);
    for (int32_t k = 0; k < work->known_count; k++)
        if (work->known[k].row < 0) add_along(train, work->known[k].coordinate, "effort", work->known[k].torque);
    if (work->load >= 0) {
        int32_t body = train->net.body_of[work->load];
        add_torque(train, train->model->bodies[body].name, "load", body, 0,
                   yk_train_unknown(work, train->motion.row_count));
    }
    for (int32_t r = 0; r < train->motion.row_count; r++)
        if (train->motion.rows[r].kind != YK_ROW_INPUT) add_row(work, r);
    return true;
}

// Finds the largest power that goes through one gear of a mesh, seen from the ground.
static void find_circulation(YkTrain *train)
{
    YkTrainPower *power = &train->power;
    for (int32_t m = 0; m < train->net.mesh_count; m++) {
        const YkTrainRow *row = yk_train_mesh_row(&train->net, m);
        const YkTrainMeshPower *mesh = &train->mesh_power[m];
        for (int k = 0; k < 2 && mesh->is_known && row->kind != YK_ROW_RACK; k++) {
            double flow = fabs(mesh->torque[k] * yk_train_column_speed(train, row->terms[k].column));
            if (flow <= power->in * (1 + 1e-9) || flow - power->in <= power->circulating) continue;
            power->circulating = flow - power->in;
            power->mesh = yk_train_mesh(train, (size_t)m).name;
        }
    }
}

void yk_train_sum_power(YkTrain *train)
{
    YkTrainPower *power = &train->power;
    if (train->drives[0].shown.is_unit) return;
    power->is_known = true;
    for (size_t i = 0; i < train->torque_count; i++) {
        double flow = train->torques[i].power;
        if (flow > 0) power->in += flow;
        if (flow < 0) power->out -= flow;
    }
    for (int32_t m = 0; m < train->net.mesh_count; m++) power->loss += train->mesh_power[m].loss;
    power->efficiency = power->in > 0 ? power->out / power->in : NAN;
    find_circulation(train);
}
