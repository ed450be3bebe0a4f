// Answers the public door's questions about a joint: its kind and its bodies.
#include "model/model.h"

const char *yk_model_joint_kind(const YkModel *model, size_t joint)
{
    if (joint >= yk_model_joint_count(model)) return NULL;
    return yk_part(model->joints[joint].is_free ? YK_FREE : model->joints[joint].kind)->key;
}

size_t yk_model_joint_body(const YkModel *model, size_t joint, int side)
{
    if (joint >= yk_model_joint_count(model)) return YK_NOT_FOUND;
    return (size_t)yk_joint_end(model, joint, side != 0)->body[side != 0];
}
