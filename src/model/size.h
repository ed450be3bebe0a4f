// The size of a machine: the largest extent of a body, or distance of a slide at the start; where both are 0, the
// largest length of the file. For tolerances and scales.
#ifndef MODEL_SIZE_H
#define MODEL_SIZE_H
#include "model/model.h"

// Sets has_origin[body], all false before, for bodies whose origin a joint uses.
void yk_size_origins(const YkModel *model, bool *has_origin);
// Returns how many vectors yk_size_of_body needs as scratch, for any body.
static inline size_t yk_size_room(const YkModel *model)
{
    return 3 * (model->point_count + 1);
}
double yk_size_of_body(const YkModel *model, size_t body, bool has_origin, YkVec *room);
double yk_size_of_start(const YkModel *model);
// Returns the largest length among parameters and cams, for a machine without another; the file's unit if there is
// none.
double yk_size_of_values(const YkModel *model);

#endif
