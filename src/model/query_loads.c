// Answers the public door's questions about the loads on a machine.
#include "model/model.h"

static size_t count_masses(const YkModel *model, double *mass)
{
    size_t count = 0;
    for (size_t b = 1; b < model->body_count; b++) {
        if (!model->bodies[b].has_mass) continue;
        *mass += model->bodies[b].mass;
        count++;
    }
    return count;
}

YkLoadCounts yk_model_loads(const YkModel *model)
{
    YkLoadCounts counts = {.efforts = model->effort_count, .forces = model->force_count, .stops = model->stop_count};
    counts.has_gravity = model->has_gravity && (model->gravity.x != 0 || model->gravity.y != 0);
    counts.masses = count_masses(model, &counts.mass);
    for (size_t k = 0; k < model->spring_count; k++) {
        counts.springs += model->springs[k].stiffness_expr != NULL || model->springs[k].force.expr != NULL;
        counts.dampers += model->springs[k].damping_expr != NULL;
    }
    for (size_t j = 0; j < model->joint_count; j++) counts.frictions += model->joints[j].has_friction;
    return counts;
}

double yk_model_body_mass(const YkModel *model, size_t body)
{
    return body < model->body_count && model->bodies[body].has_mass ? model->bodies[body].mass : 0;
}
