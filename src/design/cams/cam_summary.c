// Finds the extremes of a cam over a period.
#include <math.h>
#include "design/cams/cam.h"
#include "elementary/elementary.h"

static double pressure(const YkCamPoint *p, const void *context)
{
    (void)context;
    return fabs(p->pressure_angle);
}

// Curvatures are used instead of radii, since they are finite where the curve is straight.
static double pitch_curvature(const YkCamPoint *p, const void *context)
{
    return *(const double *)context / p->pitch_radius;
}

static double convex_flat(const YkCamPoint *p, const void *context)
{
    (void)context;
    return -p->surface_radius;
}

static double fullness(const YkCamPoint *p, const void *context)
{
    (void)context;
    return p->fullness;
}

static double outer_fullness(const YkCamPoint *p, const void *context)
{
    (void)context;
    return p->outer_fullness;
}

static double reach(const YkCamPoint *p, const void *context)
{
    return *(const double *)context * p->reach;
}

static double distance(const YkCamPoint *p, const void *context)
{
    return *(const double *)context * yk_hypot(p->surface[0], p->surface[1]);
}

static double lift(const YkCamPoint *p, const void *context)
{
    return *(const double *)context * p->lift[0];
}

typedef struct Finder {
    const YkCamSamples *samples;
    const YkCamShape *shape;
} Finder;

// Finds the greatest (sign +1) or least (-1) value of a measure that takes its sign as context.
static YkCamExtreme extreme(const Finder *finder, YkCamMeasure measure, double sign)
{
    YkCamExtreme found = yk_cam_greatest(finder->samples, finder->shape, measure, &sign);
    found.value *= sign;
    return found;
}

// Where the law is flat an extreme is found only roughly: takes the end of a segment if the lift is the same there.
static YkCamExtreme at_a_joint(const Finder *finder, YkCamExtreme found, double range)
{
    const YkLaw *law = finder->samples->law;
    for (size_t k = 0; k < yk_law_segment_count(law); k++) {
        double d[YK_LAW_ORDER + 1], from = yk_law_segment(law, k).from;
        yk_law_eval(law, from, d);
        if (fabs(d[0] - found.value) <= 1e-13 * range && fabs(from - found.angle) < 0.01)
            return (YkCamExtreme){d[0], from};
    }
    return found;
}

static YkCamPoint at(const Finder *finder, double angle)
{
    double d[YK_LAW_ORDER + 1];
    yk_law_eval(finder->samples->law, angle, d);
    return yk_cam_shape_at(finder->shape, angle, d);
}

// Beside a straight flank the curvature is only rounding, and does not count.
static YkCamExtreme radius_of(YkCamExtreme curvature, double sign, double size)
{
    if (!(curvature.value > 1e-9 / size)) return (YkCamExtreme){sign * (double)INFINITY, 0};
    return (YkCamExtreme){sign / curvature.value, curvature.angle};
}

// A parallel curve is sharpest where its pitch curve is. A flat face cannot make a hollow cam.
static void find_curvature(const Finder *finder, YkCamSummary *summary)
{
    const double plus = 1, minus = -1, roller = finder->shape->roller, size = finder->shape->base + roller;
    const YkCamExtreme none = {-(double)INFINITY, 0};
    if (finder->shape->face == YK_CAM_FACE_FLAT) {
        YkCamExtreme least = yk_cam_greatest(finder->samples, finder->shape, convex_flat, NULL);
        least.value = -least.value;
        summary->pitch_convex = summary->surface_convex = least;
        summary->pitch_hollow = summary->surface_hollow = none;
        return;
    }
    summary->pitch_convex = radius_of(yk_cam_greatest(finder->samples, finder->shape, pitch_curvature, &plus), 1, size);
    summary->pitch_hollow =
        radius_of(yk_cam_greatest(finder->samples, finder->shape, pitch_curvature, &minus), -1, size);
    summary->surface_convex = summary->pitch_convex;
    summary->surface_convex.value -= roller;
    summary->surface_hollow = summary->pitch_hollow;
    summary->surface_hollow.value -= roller;
}

static void find_undercut(const Finder *finder, YkCamSummary *summary)
{
    summary->undercut_count =
        yk_cam_negative(finder->samples, finder->shape, fullness, NULL, summary->undercut, YK_CAM_RANGES_MAX);
    summary->outer_undercut_count = yk_cam_negative(finder->samples, finder->shape, outer_fullness, NULL,
                                                    summary->outer_undercut, YK_CAM_RANGES_MAX);
}

YkCamSummary yk_cam_summarize(const YkCamSamples *samples, const YkCamShape *shape)
{
    Finder finder = {samples, shape};
    YkCamSummary summary = {.lift_low = {0, 0}};
    summary.lift_low = extreme(&finder, lift, -1);
    summary.lift_high = extreme(&finder, lift, 1);
    double range = summary.lift_high.value - summary.lift_low.value;
    summary.lift_low = at_a_joint(&finder, summary.lift_low, range);
    summary.lift_high = at_a_joint(&finder, summary.lift_high, range);
    for (int k = 0; k <= YK_LAW_ORDER; k++) {
        YkLawPeak peak = yk_law_peak(samples->law, k);
        summary.peak[k] = (YkCamExtreme){peak.value, peak.x};
    }
    summary.pressure = yk_cam_greatest(samples, shape, pressure, NULL);
    if (at(&finder, summary.pressure.angle).pressure_angle < 0) summary.pressure.value *= -1;
    find_curvature(&finder, &summary);
    if (shape->face == YK_CAM_FACE_FLAT) {
        summary.reach_low = extreme(&finder, reach, -1);
        summary.reach_high = extreme(&finder, reach, 1);
    }
    summary.far = extreme(&finder, distance, 1);
    summary.near = extreme(&finder, distance, -1);
    find_undercut(&finder, &summary);
    return summary;
}
