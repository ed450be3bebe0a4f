// The balance of torques: its equations, exactly, and the values of its unknowns.
#include <math.h>
#include "design/trains/train_torques.h"

// Returns the side of a mesh that a term belongs to: 0 or 1.
static int side_of(const YkTrainRow *row, int32_t term)
{
    if (row->kind == YK_ROW_RACK) return term == 2;
    return term % 2;
}

static bool is_mesh(const YkTrainRow *row)
{
    return row->kind == YK_ROW_GEARS || row->kind == YK_ROW_BELT || row->kind == YK_ROW_RACK;
}

YkFraction yk_train_torque_of(const YkTrainBalance *work, int32_t r, int32_t term, YkOverflow *overflow)
{
    const YkTrainRow *row = &work->train->motion.rows[r];
    YkFraction by = yk_train_coefficient(&work->train->net, row, term);
    if (!is_mesh(row) || work->driver[r] < 0 || side_of(row, term) == work->driver[r]) return by;
    return yk_fraction_multiply(&by, &work->efficiency, overflow);
}

static int32_t known_of_row(const YkTrainBalance *work, int32_t row)
{
    for (int32_t k = 0; k < work->known_count; k++)
        if (work->known[k].row == row) return k;
    return -1;
}

static void add_to(YkTrainBalance *work, int32_t row, int32_t column, const YkFraction *by)
{
    YkFraction *cell = yk_exact_cell(&work->system, row, column);
    *cell = yk_fraction_add(cell, by, &work->system.overflow);
}

// Moves a known torque along a coordinate to the right-hand side: -1 on the second body, +1 on the first.
static void add_known(YkTrainBalance *work, int32_t k)
{
    const YkTrain *train = work->train;
    const YkCoordinate *coordinate = &train->model->coordinates[work->known[k].coordinate];
    const YkJoint *joint = &train->model->joints[coordinate->joint];
    const YkFraction minus = yk_fraction(-1, 1), plus = yk_fraction(1, 1);
    int32_t column = work->system.columns + k;
    if (!coordinate->is_distance) {
        add_to(work, train->net.column_of[joint->body[1]], column, &minus);
        add_to(work, train->net.column_of[joint->body[0]], column, &plus);
        return;
    }
    for (size_t r = 0; r < train->model->rack_count; r++)
        if (train->model->racks[r].slide == coordinate->joint)
            add_to(work, train->net.bodies + (int32_t)r, column, &minus);
}

bool yk_train_balance(YkTrainBalance *work)
{
    const YkTrainCase *motion = &work->train->motion;
    yk_exact_free(&work->system);
    if (!yk_exact_new(&work->system, work->train->net.columns, motion->row_count + 1, work->known_count)) return false;
    for (int32_t r = 0; r < motion->row_count; r++) {
        if (known_of_row(work, r) >= 0) continue;
        for (int32_t t = 0; t < motion->rows[r].count; t++) {
            YkFraction by = yk_train_torque_of(work, r, t, &work->system.overflow);
            add_to(work, motion->rows[r].terms[t].column, r, &by);
        }
    }
    if (work->load >= 0) *yk_exact_cell(&work->system, work->load, motion->row_count) = yk_fraction(1, 1);
    for (int32_t k = 0; k < work->known_count; k++) add_known(work, k);
    yk_exact_reduce(&work->system);
    return true;
}

double yk_train_unknown(const YkTrainBalance *work, int32_t column)
{
    double sum = 0;
    if (!yk_exact_is_determined(&work->system, column)) return NAN;
    for (int32_t k = 0; k < work->known_count; k++)
        sum +=
            yk_fraction_value(yk_exact_cell(&work->system, work->system.pivot_row[column], work->system.columns + k)) *
            work->known[k].torque;
    return sum;
}

double yk_train_multiplier(const YkTrainBalance *work, int32_t row)
{
    int32_t k = known_of_row(work, row);
    return k >= 0 ? work->known[k].torque : yk_train_unknown(work, row);
}

double yk_train_column_speed(const YkTrain *train, int32_t column)
{
    if (column == 0) return 0;
    if (column < train->net.bodies) return train->bodies[column - 1].speed;
    const YkModel *model = train->model;
    return train->rack_speeds[model->gear_count + model->belt_count + (size_t)(column - train->net.bodies)];
}
