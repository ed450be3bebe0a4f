// Finds the smallest base circle that keeps limits on pressure angle and curvature.
#include <math.h>
#include "design/cams/cam.h"
#include "elementary/elementary.h"

static const double step = 1.01; // of the search from below
enum { STEPS_MAX = 3000, BISECTIONS = 80 };

// Returns by how much a limit is exceeded, relative to it, so that both sides compare: at most 0 if it is kept.
static double over_pressure(const YkCamPoint *point, const void *context)
{
    const YkCamLimits *limits = context;
    double angle = fabs(point->pressure_angle);
    return isnan(angle) ? (double)INFINITY : angle / limits->pressure - 1;
}

typedef struct Bend {
    double least;  // smallest convex radius of the surface wanted, m
    double roller; // m
    bool is_flat;
} Bend;

// Does the same for curvature: of a roller's pitch curve against 1 / (least + roller), of a flat face its radius.
static double over_bend(const YkCamPoint *point, const void *context)
{
    const Bend *bend = context;
    double radius = bend->least + bend->roller;
    if (isnan(point->pitch_radius) || point->fullness < -0.5) return (double)INFINITY;
    if (bend->is_flat) return bend->least - point->surface_radius;
    return radius / point->pitch_radius - 1;
}

typedef struct Search {
    const YkCamSamples *samples;
    YkCamShape shape;
    const YkCamLimits *limits;
    Bend bend;
    size_t steep, bent; // the samples at which the limits were last exceeded: for another base it is there or near
} Search;

// Returns whether this base keeps both limits. One that does not is mostly known by one sample.
static bool keeps(Search *search, double base)
{
    const YkCamSamples *samples = search->samples;
    const YkCamShape *shape = &search->shape;
    search->shape.base = base;
    return yk_cam_shape_fit(&search->shape) &&
           !yk_cam_is_above_zero(samples, shape, over_pressure, search->limits, &search->steep) &&
           !yk_cam_is_above_zero(samples, shape, over_bend, &search->bend, &search->bent) &&
           yk_cam_greatest(samples, shape, over_pressure, search->limits).value <= 0 &&
           yk_cam_greatest(samples, shape, over_bend, &search->bend).value <= 0;
}

// Finds the lowest lift and the range of the lift, from samples.
static void find_lifts(const YkCamSamples *samples, double *low, double *extent)
{
    double high = -(double)INFINITY;
    *low = INFINITY;
    for (size_t i = 0; i < samples->count; i++) {
        *low = fmin(*low, samples->items[i].lift[0]);
        high = fmax(high, samples->items[i].lift[0]);
    }
    *extent = high - *low;
}

// Finds the range of base radii that geometry allows.
static void find_bounds(const YkCamSamples *samples, const YkCamShape *shape, double *low, double *high)
{
    double lowest, extent, f = yk_norm(shape->pivot);
    find_lifts(samples, &lowest, &extent);
    if (shape->oscillates && shape->face == YK_CAM_FACE_FLAT) {
        *low = 1e-6 * f;
        *high = f - shape->offset;
    } else if (shape->oscillates) {
        *low = fmax(fabs(f - shape->arm) - shape->roller, 1e-6 * f);
        *high = f + shape->arm - shape->roller;
    } else {
        double least = shape->face == YK_CAM_FACE_FLAT ? fmax(-lowest, 0)
                                                       : yk_hypot(fmax(-lowest, 0), shape->offset) - shape->roller;
        *low = fmax(least, 1e-6 * (extent + fabs(shape->offset) + shape->roller));
        *high = INFINITY;
    }
}

YkCamLimits yk_default_cam_limits(const YkCamDesign *design)
{
    return (YkCamLimits){.pressure = (design->cam->oscillates ? 35 : 30) * YK_PI / 180, .curvature = 0};
}

YkStatus yk_cam_smallest_base(const YkCamDesign *design, const YkCamLimits *limits, YkCamBase *base)
{
    Search search = {.samples = &design->samples, .shape = design->shape, .limits = limits};
    double low, high, bound;
    search.bend = (Bend){limits->curvature, design->shape.roller, design->shape.face == YK_CAM_FACE_FLAT};
    find_bounds(&design->samples, &design->shape, &low, &bound);
    bool found = false;
    high = low;
    for (int i = 0; i < STEPS_MAX && !found; i++) {
        low = high;
        high = low * step;
        if (!(high < bound)) return YK_LIMIT;
        found = keeps(&search, high);
    }
    if (!found) return YK_LIMIT;
    double failing = high; // a base that just fails: its worst place is where the limit is reached
    for (int i = 0; i < BISECTIONS && high - low > 1e-15 * high; i++) {
        double middle = low + (high - low) / 2;
        if (keeps(&search, middle)) {
            high = middle;
        } else {
            low = middle;
            if (isfinite(search.shape.start)) failing = middle;
        }
    }
    search.shape.base = failing;
    yk_cam_shape_fit(&search.shape);
    YkCamExtreme pressure = yk_cam_greatest(search.samples, &search.shape, over_pressure, limits);
    YkCamExtreme curvature = yk_cam_greatest(search.samples, &search.shape, over_bend, &search.bend);
    base->base = high;
    base->by_pressure = pressure.value > curvature.value;
    base->angle = base->by_pressure ? pressure.angle : curvature.angle;
    return YK_OK;
}
