// Sets the dimension of a name, and queues what depends on it.
#include "expr/dimension.h"

void yk_dim_queue(YkDimensions *dims, int32_t index)
{
    YkConstraint *constraint = &dims->constraints[index];
    if (constraint->is_queued || (dims->phase == YK_PHASE_OWN && constraint->parameter < 0)) return;
    constraint->is_queued = true;
    dims->queue[(dims->queue_first + dims->queue_count++) % dims->constraint_count] = index;
}

void yk_dim_set(YkDimensions *dims, int32_t name, YkDimension dimension, const YkConstraint *origin, YkPlace place)
{
    YkDimName *entry = &dims->names[name];
    entry->is_known = true;
    entry->dimension = dimension;
    entry->origin = origin;
    entry->origin_place = place;
    for (size_t i = dims->first_dependent[name]; i < dims->first_dependent[name + 1]; i++)
        yk_dim_queue(dims, dims->dependents[i]);
    // Its own expression may have bare parts that can take the dimension now.
    for (size_t low = 0, high = dims->constraint_count; low < high;) {
        size_t middle = low + (high - low) / 2; // parameters' constraints are in the order of their names
        int32_t parameter = dims->constraints[middle].parameter;
        if (parameter == name) {
            yk_dim_queue(dims, (int32_t)middle);
            break;
        }
        if (parameter < 0 || parameter > name)
            high = middle;
        else
            low = middle + 1;
    }
}
