// The torque balance of a train.
#ifndef DESIGN_TRAIN_TORQUES_H
#define DESIGN_TRAIN_TORQUES_H
#include "design/trains/train.h"

typedef struct YkTrainKnown {
    int32_t coordinate;
    double torque;
    int32_t row; // the input's row in the case, or -1
} YkTrainKnown;

typedef struct YkTrainBalance {
    YkTrain *train;
    YkTrainKnown *known;
    int32_t known_count;
    int32_t load;    // column of the body that takes the load, or -1
    int32_t *driver; // per mesh: 0, 1 or -1
    YkFraction efficiency;
    YkExactSystem system; // rows: columns of the net; columns: rows of the case, then the load; rights: the known
} YkTrainBalance;

// train_balance.c: sets the equations up and reduces them. Returns false when out of memory.
bool yk_train_balance(YkTrainBalance *work);
// Returns the coefficient that turns a row's multiplier into a torque; the driven side of a mesh gets less.
YkFraction yk_train_torque_of(const YkTrainBalance *work, int32_t row, int32_t term, YkOverflow *overflow);
// Returns a solved unknown: the multiplier of a row (known or found), or a column of the system; NaN if it is not
// determined.
double yk_train_multiplier(const YkTrainBalance *work, int32_t row);
double yk_train_unknown(const YkTrainBalance *work, int32_t column);
double yk_train_column_speed(const YkTrain *train, int32_t column); // rad/s, m/s

// Lists the external torques, and the power that goes in, out and round (train_power.c).
bool yk_train_list_torques(YkTrainBalance *work); // false: out of memory
void yk_train_sum_power(YkTrain *train);

#endif
