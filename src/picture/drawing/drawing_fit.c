// Finds the scale at which everything fits the page.
#include "picture/drawing/drawing.h"

enum { MARGIN = YK_DRAWING_MARGIN, HEAD = YK_DRAWING_HEAD, FOOT = 26 }; // px

static void include(YkDrawing *drawing, YkVec at)
{
    drawing->low = yk_vec(fmin(drawing->low.x, at.x), fmin(drawing->low.y, at.y));
    drawing->high = yk_vec(fmax(drawing->high.x, at.x), fmax(drawing->high.y, at.y));
}

static void include_circle(YkDrawing *drawing, YkVec center, double radius)
{
    include(drawing, yk_add(center, yk_vec(radius, radius)));
    include(drawing, yk_sub(center, yk_vec(radius, radius)));
}

static void include_pose(YkDrawing *drawing, const YkFrame *frames)
{
    const YkModel *model = drawing->model;
    for (size_t b = 0; b < model->body_count; b++)
        for (size_t c = 0; c < drawing->outlines[b].count; c++)
            include(drawing, yk_frame_apply(frames[b], drawing->corners[drawing->outlines[b].first + c]));
    for (size_t j = 0; j < model->joint_count - model->held_joints; j++)
        for (int side = 0; side < 2; side++)
            include(drawing, yk_drawing_joint(drawing, frames, &model->joints[j], side));
    for (size_t k = 0; k < model->cam_count; k++) {
        YkVec center = yk_drawing_cam_center(drawing, frames, k), rider = yk_drawing_rider(drawing, frames, k);
        include_circle(drawing, center, yk_drawing_cam_reach(drawing, k));
        include_circle(drawing, rider, model->cams[k].roller);
    }
    for (size_t b = 0; b < model->body_count; b++) {
        double reach = 0;
        yk_drawing_wheel_reach(drawing, (int32_t)b, &reach);
        if (reach > 0) include_circle(drawing, frames[b].origin, reach);
    }
}

// Returns the mean length of a link, m: the distance between the first two corners of an outline.
static double mean_link(const YkDrawing *drawing)
{
    double sum = 0;
    size_t count = 0;
    for (size_t b = 0; b < drawing->model->body_count; b++) {
        const YkVec *corner = drawing->corners + drawing->outlines[b].first;
        if (drawing->outlines[b].count < 2) continue;
        sum += yk_norm(yk_sub(corner[1], corner[0]));
        count++;
    }
    return count > 0 ? sum / (double)count : 0;
}

void yk_drawing_fit(YkDrawing *drawing)
{
    double page = fmax(drawing->options.width, 4 * MARGIN), tallest = 1.1 * page;
    drawing->low = yk_vec(INFINITY, INFINITY);
    drawing->high = yk_vec(-INFINITY, -INFINITY);
    for (size_t pose = 0; pose < drawing->pose_count; pose++) include_pose(drawing, yk_drawing_frames(drawing, pose));
    for (size_t i = 0; i < drawing->trace_count * drawing->options.traced_count; i++)
        include(drawing, drawing->traces[i]);
    if (!(drawing->low.x <= drawing->high.x)) drawing->low = drawing->high = yk_vec(0, 0);
    yk_drawing_include_centrodes(drawing);
    yk_drawing_include_centers(drawing);
    YkVec extent = yk_sub(drawing->high, drawing->low);
    double across = (page - 2 * MARGIN) / extent.x, up = (tallest - 2 * MARGIN) / extent.y;
    drawing->scale = fmin(across, up);
    if (!isfinite(drawing->scale)) drawing->scale = 1;
    if (drawing->fixed_scale > 0) drawing->scale = drawing->fixed_scale;
    drawing->width = drawing->fixed_scale > 0 ? extent.x * drawing->scale + 2 * MARGIN : page;
    drawing->height = extent.y * drawing->scale + 2 * MARGIN + HEAD + FOOT + yk_drawing_notes(drawing);
    double bar = 0.085 * mean_link(drawing) * drawing->scale;
    drawing->bar = fmin(fmax(bar > 0 ? bar : 10, 0.8), 12);
}

double yk_drawing_extent(const YkDrawing *drawing)
{
    YkDrawing all = *drawing;
    all.low = yk_vec(INFINITY, INFINITY);
    all.high = yk_vec(-INFINITY, -INFINITY);
    include_pose(&all, yk_drawing_frames(drawing, 0));
    if (!(all.low.x <= all.high.x)) return 0;
    return fmax(fmax(fabs(all.low.x), fabs(all.high.x)), fmax(fabs(all.low.y), fabs(all.high.y)));
}
