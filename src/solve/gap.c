// How far apart two poses are.
#include "solve/gap.h"
#include <math.h>

double yk_gap(const YkMechanism *mech, bool is_distance, double difference)
{
    return fabs(is_distance ? difference / mech->size : yk_nearest_turn(difference, 0));
}

double yk_group_gap(const YkMechanism *mech, const YkBlock *group, const double *a, const double *b)
{
    double gap = 0;
    for (size_t k = 0; k < group->column_count; k++)
        gap = fmax(gap, yk_gap(mech, mech->group_columns[group->first_column + k].is_distance, a[k] - b[k]));
    return gap;
}
