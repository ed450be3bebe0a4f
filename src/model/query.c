// Answers the public door's questions about the contents of a model.
#include "model/model.h"
#include <math.h>

const char *yk_model_name(const YkModel *model)
{
    return model->name;
}

size_t yk_model_body_count(const YkModel *model)
{
    return model->body_count - model->carriage_count;
}

const char *yk_model_body_name(const YkModel *model, size_t body)
{
    return body < model->body_count ? model->bodies[body].name : NULL; // of a carriage: its joint's
}

size_t yk_model_point_count(const YkModel *model)
{
    return model->point_count;
}

const char *yk_model_point_name(const YkModel *model, size_t point)
{
    return point < model->point_count ? model->points[point].name : NULL;
}

size_t yk_model_point_body(const YkModel *model, size_t point)
{
    return point < model->point_count ? (size_t)model->points[point].body : YK_NOT_FOUND;
}

void yk_model_point_place(const YkModel *model, size_t point, double place[2])
{
    bool is_there = point < model->point_count;
    place[0] = is_there ? model->points[point].at.x : (double)NAN;
    place[1] = is_there ? model->points[point].at.y : (double)NAN;
}

size_t yk_model_joint_count(const YkModel *model)
{
    return model->carriage_count > 0 ? model->shown_joints : model->joint_count;
}

const char *yk_model_joint_name(const YkModel *model, size_t joint)
{
    return joint < yk_model_joint_count(model) ? model->joints[joint].name : NULL;
}

static size_t find(const YkNames *names, const char *name)
{
    int32_t index = name ? yk_names_find(names, name) : YK_NONE;
    return index == YK_NONE ? YK_NOT_FOUND : (size_t)index;
}

size_t yk_model_find_body(const YkModel *model, const char *name)
{
    return find(&model->body_names, name);
}

size_t yk_model_find_point(const YkModel *model, const char *body_dot_point)
{
    return find(&model->point_names, body_dot_point);
}

size_t yk_model_find_joint(const YkModel *model, const char *name)
{
    return find(&model->joint_names, name);
}

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
