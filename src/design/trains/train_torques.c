// Solves for torques in steady motion by virtual work: each equation between speeds has a multiplier, and its
// coefficients times the multiplier are the torques that a mesh, lock or drive exerts on the bodies. With losses the
// driven side of a mesh gets less than the driving side gives; which side drives is found by iteration until it no
// longer changes. Sources: Merritt 1971, Gear Engineering; power seen from the carrier: Macmillan 1949.
#include <math.h>
#include <stdlib.h>
#include "base/number.h"
#include "design/trains/train_torques.h"

enum { ROUNDS_MAX = 60 };
static const YkPlace nowhere = {0};

// --- What is known

static bool is_between(const YkModel *model, int32_t coordinate, int32_t body)
{
    const YkCoordinate *c = &model->coordinates[coordinate];
    return !c->is_distance && model->joints[c->joint].body[0] == 0 && model->joints[c->joint].body[1] == body;
}

static int32_t row_of_input(const YkTrain *train, int32_t coordinate)
{
    for (int32_t r = 0; r < train->motion.row_count; r++) {
        const YkTrainRow *row = &train->motion.rows[r];
        if (row->kind != YK_ROW_INPUT) continue;
        const YkTrainDrive *drive = &train->drives[row->index];
        if (drive->coordinate == coordinate) return r;
        if (drive->coordinate == YK_NONE && is_between(train->model, coordinate, drive->body)) return r;
    }
    return -1;
}

static void learn(YkTrainBalance *work, int32_t coordinate, double torque)
{
    for (int32_t k = 0; k < work->known_count; k++) {
        if (work->known[k].coordinate != coordinate) continue;
        work->known[k].torque = torque;
        return;
    }
    work->known[work->known_count++] = (YkTrainKnown){coordinate, torque, row_of_input(work->train, coordinate)};
}

static bool is_of_train(const YkTrain *train, int32_t coordinate)
{
    const YkCoordinate *c = &train->model->coordinates[coordinate];
    const YkJoint *joint = &train->model->joints[c->joint];
    if (!c->is_distance) return train->net.column_of[joint->body[0]] >= 0 && train->net.column_of[joint->body[1]] >= 0;
    for (size_t r = 0; r < train->model->rack_count; r++)
        if (train->model->racks[r].slide == c->joint) return true;
    return false;
}

static bool learn_option(YkTrainBalance *work, const YkTrainEffort *effort, YkProblems *problems)
{
    const YkModel *model = work->train->model;
    int32_t coordinate = yk_names_find(&model->coordinate_names, effort->coordinate);
    if (coordinate == YK_NONE) {
        yk_problem(problems, YK_CODE_NOT_A_COORDINATE, nowhere, "the model declares no coordinate %q",
                   effort->coordinate);
        return false;
    }
    if (is_of_train(work->train, coordinate)) learn(work, coordinate, effort->value);
    return true;
}

static bool learn_all(YkTrainBalance *work, YkProblems *problems)
{
    const YkTrain *train = work->train;
    const YkModel *model = train->model;
    work->known = calloc(model->effort_count + train->options.effort_count + 1, sizeof *work->known);
    if (!work->known) return false;
    for (size_t i = 0; i < model->effort_count; i++) {
        const YkEffort *effort = &model->efforts[i];
        YkJet jet;
        if (effort->strength.law != YK_NONE || !effort->strength.expr || !is_of_train(train, effort->coordinate))
            continue;
        if (yk_model_eval(model, effort->strength.expr, train->options.time, &jet, NULL) != YK_OK) continue;
        learn(work, effort->coordinate, jet.d[0]);
    }
    for (size_t i = 0; i < train->options.effort_count; i++)
        if (!learn_option(work, &train->options.efforts[i], problems)) return false;
    work->load = -1;
    for (int32_t k = 0; k < work->known_count && train->ratio.out != YK_NOT_FOUND; k++)
        if (work->known[k].row >= 0) work->load = train->net.column_of[train->ratio.out];
    return true;
}

static YkFraction efficiency_of(double value)
{
    char text[YK_NUMBER_SIZE];
    int64_t mantissa = 1;
    int32_t exponent = 0;
    YkOverflow overflow = false;
    size_t length = yk_number_write_digits(value, 12, text);
    if (!yk_number_read_exact(text, length, &mantissa, &exponent)) return yk_fraction(1, 1);
    YkFraction result = yk_fraction(mantissa, 1), tenth = yk_fraction(1, 10);
    for (; exponent < 0; exponent++) result = yk_fraction_multiply(&result, &tenth, &overflow);
    return result;
}

// --- Meshes

// Returns the speed of one side of a mesh, seen from its carrier.
static double rolling_speed(const YkTrain *train, int32_t mesh, int side)
{
    const YkTrainRow *row = yk_train_mesh_row(&train->net, mesh);
    bool is_rack = row->kind == YK_ROW_RACK;
    if (is_rack && side == 1) return yk_train_column_speed(train, row->terms[2].column);
    double own = yk_train_column_speed(train, row->terms[side].column),
           carrier = yk_train_column_speed(train, row->terms[is_rack ? 1 : 2].column);
    return fabs(own - carrier) > 1e-13 * (fabs(own) + fabs(carrier)) ? own - carrier : 0;
}

static double torque_on(YkTrainBalance *work, int32_t mesh, int side)
{
    const YkTrainRow *row = yk_train_mesh_row(&work->train->net, mesh);
    int32_t term = row->kind == YK_ROW_RACK && side == 1 ? 2 : side;
    YkFraction by = yk_train_torque_of(work, mesh, term, &work->system.overflow);
    return yk_train_multiplier(work, mesh) * yk_fraction_value(&by);
}

// Returns which side gives power to the mesh, with the present torques.
static int driver_of(YkTrainBalance *work, int32_t mesh)
{
    double power = -torque_on(work, mesh, 0) * rolling_speed(work->train, mesh, 0);
    return power > 0 ? 0 : power < 0 ? 1 : -1;
}

// Balances until every mesh is driven from the side that was assumed. Returns 1 if found, 0 if never, -1 when out of
// memory.
static int find_drivers(YkTrainBalance *work)
{
    int32_t count = work->train->net.mesh_count;
    for (int round = 0; round < ROUNDS_MAX; round++) {
        bool is_same = true;
        if (!yk_train_balance(work)) return -1;
        for (int32_t m = 0; m < count; m++) {
            int driver = driver_of(work, m);
            is_same &= driver == work->driver[m];
            work->driver[m] = driver;
        }
        if (is_same) return 1;
    }
    return 0;
}

static void fill_mesh(YkTrainBalance *work, int32_t mesh)
{
    YkTrainMeshPower *power = &work->train->mesh_power[mesh];
    double torque[2] = {torque_on(work, mesh, 0), torque_on(work, mesh, 1)}, flow[2];
    if (isnan(torque[0]) || isnan(torque[1])) return;
    bool is_rack = yk_train_mesh_row(&work->train->net, mesh)->kind == YK_ROW_RACK;
    for (int k = 0; k < 2; k++) flow[k] = -torque[k] * rolling_speed(work->train, mesh, k);
    *power = (YkTrainMeshPower){.is_known = true,
                                .torque = {torque[0], torque[1]},
                                .carrier_torque = is_rack ? -torque[0] : -torque[0] - torque[1],
                                .driver = work->driver[mesh],
                                .rolling_power = fmax(fmax(flow[0], flow[1]), 0),
                                .loss = work->train->options.efficiency < 1 ? fmax(flow[0] + flow[1], 0) : 0};
}

// --- The whole

// Returns whether all that matters is determined and free of contradictions.
static bool is_answer(const YkTrainBalance *work, YkProblems *problems)
{
    const YkTrainCase *motion = &work->train->motion;
    if (yk_exact_contradiction(&work->system, work->known_count) >= 0) {
        yk_problem(problems, YK_CODE_TORQUES_CONTRADICT, nowhere, "the given torques do not balance");
        if (work->load < 0) yk_problem_hint(problems, "name the body that takes the load: --out BODY");
        return false;
    }
    bool is_open = work->load >= 0 && isnan(yk_train_unknown(work, motion->row_count));
    for (int32_t r = 0; r < motion->row_count; r++)
        is_open |= motion->rows[r].kind == YK_ROW_INPUT && isnan(yk_train_multiplier(work, r));
    if (is_open) yk_problem(problems, YK_CODE_TORQUES_OPEN, nowhere, "the given torques do not determine the others");
    return !is_open;
}

static bool find_torques(YkTrainBalance *work, YkProblems *problems)
{
    YkTrain *train = work->train;
    train->mesh_power = YK_NEW(train->arena, YkTrainMeshPower, (size_t)train->net.mesh_count + 1);
    if (!train->mesh_power || !yk_train_balance(work)) return false;
    if (work->system.overflow || !is_answer(work, problems)) return true;
    int found = find_drivers(work);
    if (found < 0) return false;
    if (found == 0) {
        yk_problem(problems, YK_CODE_SELF_LOCKING, nowhere, "with these losses the train cannot be driven like this");
        return true;
    }
    for (int32_t m = 0; m < train->net.mesh_count; m++) fill_mesh(work, m);
    if (!yk_train_list_torques(work)) return false;
    yk_train_sum_power(train);
    if (train->power.is_known && train->power.in > 0 && train->power.loss > 0 && train->power.out <= 0)
        yk_problem(problems, YK_CODE_SELF_LOCKING, nowhere,
                   "self-locking: the losses take more than the drive gives, so the load must push too");
    return true;
}

bool yk_train_torques(YkTrain *train, YkProblems *problems)
{
    YkTrainBalance work = {.train = train, .load = -1};
    work.efficiency = efficiency_of(train->options.efficiency);
    work.driver = calloc((size_t)train->net.mesh_count + 1, sizeof *work.driver);
    bool good = work.driver && learn_all(&work, problems);
    for (int32_t m = 0; good && m < train->net.mesh_count; m++) work.driver[m] = -1;
    if (good && work.known_count > 0 && train->motion.status == YK_TRAIN_STATUS_OK)
        good = find_torques(&work, problems);
    yk_exact_free(&work.system);
    free(work.known);
    free(work.driver);
    return good;
}
