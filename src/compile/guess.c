// The coordinates at which the search for a pose begins, as the model gives them.
#include "compile/topology.h"

void yk_start_guess(const YkMechanism *mech, double *guess)
{
    const YkModel *model = mech->model;
    for (size_t k = 0; k < mech->coordinate_count; k++) guess[k] = 0;
    for (size_t s = 0; s < model->start_count; s++) {
        const YkStart *start = &model->starts[s];
        if (start->is_rate) continue;
        int32_t k = yk_tree_coordinate(mech, model->coordinates[start->coordinate].joint,
                                       model->coordinates[start->coordinate].is_distance);
        if (k != YK_NONE) guess[k] = start->value;
    }
    for (size_t k = 0; k < mech->coordinate_count; k++) {
        YkJet jet;
        int32_t drive = mech->coordinates[k].drive;
        if (drive != YK_NONE && yk_model_drive(model, (size_t)drive, 0, &jet, NULL) == YK_OK) guess[k] = jet.d[0];
    }
}
