// The entrance to cam design: makes a design from a model and answers by angle.
#include <math.h>
#include <string.h>
#include "design/cams/cam.h"

size_t yk_model_cam_count(const YkModel *model)
{
    return model->cam_count;
}

const char *yk_model_cam_name(const YkModel *model, size_t cam)
{
    return cam < model->cam_count ? model->cams[cam].name : NULL;
}

size_t yk_model_cam_find(const YkModel *model, const char *name)
{
    for (size_t i = 0; name && i < model->cam_count; i++)
        if (strcmp(model->cams[i].name, name) == 0) return i;
    return YK_NOT_FOUND;
}

const char *yk_cam_face_name(YkCamFace face)
{
    static const char *const names[] = {"knife", "roller", "flat"};
    return names[face];
}

// Finds the rate of the cam's drive, if it is linear in time, and its angle at t = 0.
static void find_speed(YkCamDesign *design)
{
    const YkModel *model = design->model;
    int32_t coordinate = model->joints[design->cam->cam_joint].angle;
    int32_t drive = coordinate == YK_NONE ? YK_NONE : model->coordinates[coordinate].drive;
    if (drive == YK_NONE || !model->drives[drive].expr) return;
    YkJet now, later;
    if (yk_model_eval(model, model->drives[drive].expr, 0, &now, NULL) != YK_OK) return;
    if (yk_model_eval(model, model->drives[drive].expr, 0.37, &later, NULL) != YK_OK) return;
    for (int k = 2; k <= YK_JET_ORDER; k++)
        if (now.d[k] != 0 || later.d[k] != 0) return;
    if (fabs(later.d[1] - now.d[1]) > 1e-12 * fabs(now.d[1])) return;
    design->speed = now.d[1];
    design->phase = now.d[0];
}

static bool fill(YkCamDesign *design)
{
    design->shape = yk_cam_shape_of(design->cam);
    if (design->cam->is_conjugate) design->second = yk_cam_shape_second(&design->shape, design->cam);
    find_speed(design);
    return yk_cam_samples_take(&design->samples, design->law->law, design->arena) && yk_cam_gather_loads(design);
}

YkCamDesign *yk_cam_design_new(const YkModel *model, size_t cam)
{
    if (cam >= model->cam_count) return NULL;
    YkArena *arena = yk_arena_new();
    YkCamDesign *design = arena ? YK_NEW(arena, YkCamDesign, 1) : NULL;
    if (design) {
        const YkCam *of = &model->cams[cam];
        *design = (YkCamDesign){.model = model, .cam = of, .law = &model->laws[of->law], .arena = arena};
        if (fill(design)) return design;
    }
    yk_arena_free(arena);
    return NULL;
}

void yk_cam_design_free(YkCamDesign *design)
{
    if (design) yk_arena_free(design->arena); // the design itself lies in it
}

YkCamSize yk_cam_size(const YkCamDesign *design)
{
    const YkModel *model = design->model;
    const YkCam *cam = design->cam;
    return (YkCamSize){.name = cam->name,
                       .law = design->law->name,
                       .cam = model->bodies[cam->cam].name,
                       .follower = model->bodies[cam->follower].name,
                       .carrier = model->bodies[cam->carrier].name,
                       .face = cam->face,
                       .oscillates = cam->oscillates,
                       .is_groove = cam->is_groove,
                       .is_conjugate = cam->is_conjugate,
                       .base = cam->base,
                       .roller = cam->roller,
                       .offset = cam->offset,
                       .arm = cam->arm,
                       .centers = cam->centers,
                       .turn = cam->turn,
                       .period = yk_law_range(design->law->law).period,
                       .speed = design->speed};
}

static YkCamPoint point_at(const YkCamDesign *design, const YkCamShape *shape, double angle)
{
    double lift[YK_LAW_ORDER + 1];
    yk_law_eval(design->law->law, angle, lift);
    return yk_cam_shape_at(shape, angle, lift);
}

YkCamPoint yk_cam_at(const YkCamDesign *design, double angle)
{
    return point_at(design, &design->shape, angle);
}

YkCamPoint yk_cam_conjugate_at(const YkCamDesign *design, double angle)
{
    return point_at(design, design->cam->is_conjugate ? &design->second : &design->shape, angle);
}

YkCamSummary yk_cam_summary(const YkCamDesign *design)
{
    return yk_cam_summarize(&design->samples, &design->shape);
}

YkCamSummary yk_cam_conjugate_summary(const YkCamDesign *design)
{
    return yk_cam_summarize(&design->samples, design->cam->is_conjugate ? &design->second : &design->shape);
}
