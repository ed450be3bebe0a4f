// Computes profiles as polylines that stay within a tolerance of the curve.
#include <math.h>
#include <stdlib.h>
#include "design/cams/cam.h"
#include "elementary/elementary.h"

enum { DEPTH_MAX = 22, VERTICES_MAX = 4000000 };
static const double first_step = 5 * YK_PI / 180; // so that nothing between is missed

typedef struct Tracer {
    const YkCamDesign *design;
    const YkCamShape *shape;
    YkCamCurve curve;
    double cutter, tolerance;
    double lap; // angle added to the period's, for cams of several lobes
    YkCamVertex *items;
    size_t count, capacity;
    bool failed;
} Tracer;

static YkCamVertex vertex_at(const Tracer *tracer, double angle)
{
    double lift[YK_LAW_ORDER + 1];
    yk_law_eval(tracer->design->law->law, angle, lift);
    YkCamPoint p = yk_cam_shape_at(tracer->shape, angle + tracer->lap, lift);
    const double *at = tracer->curve == YK_CAM_CURVE_PITCH || tracer->curve == YK_CAM_CURVE_SECOND_PITCH ? p.pitch
                       : tracer->curve == YK_CAM_CURVE_OUTER                                             ? p.outer
                                                                                                         : p.surface;
    double out = tracer->curve == YK_CAM_CURVE_CUTTER ? tracer->cutter : 0;
    return (YkCamVertex){angle + tracer->lap, at[0] + out * p.normal[0], at[1] + out * p.normal[1]};
}

static void add(Tracer *tracer, YkCamVertex vertex)
{
    if (tracer->count > 0) { // the curve stands still: no point twice
        const YkCamVertex *last = &tracer->items[tracer->count - 1];
        if (yk_hypot(vertex.x - last->x, vertex.y - last->y) <= 1e-3 * tracer->tolerance) return;
    }
    if (tracer->count >= VERTICES_MAX || !YK_ROOM(tracer->items, tracer->count, tracer->capacity)) {
        tracer->failed = true;
    } else {
        tracer->items[tracer->count++] = vertex;
    }
}

// Returns the distance of a point from the chord between two others.
static double off_chord(YkCamVertex a, YkCamVertex b, YkCamVertex p)
{
    YkVec chord = yk_vec(b.x - a.x, b.y - a.y), to = yk_vec(p.x - a.x, p.y - a.y);
    double square = yk_dot(chord, chord), along = square > 0 ? yk_dot(chord, to) / square : 0;
    return yk_norm(yk_sub(to, yk_scale(fmin(fmax(along, 0), 1), chord)));
}

// Adds the inner points of a span, without its ends. Between the three points tried, a smooth curve leaves the chord
// by hardly more than at them: 0.8 of the tolerance is used.
static void split(Tracer *tracer, YkCamVertex a, double from, YkCamVertex b, double to, int depth)
{
    double middle = from + (to - from) / 2, most = 0.8 * tracer->tolerance;
    YkCamVertex m = vertex_at(tracer, middle);
    bool is_close = off_chord(a, b, m) <= most && off_chord(a, b, vertex_at(tracer, from + (to - from) / 4)) <= most &&
                    off_chord(a, b, vertex_at(tracer, to - (to - from) / 4)) <= most;
    if (tracer->failed || is_close || depth >= DEPTH_MAX) return;
    split(tracer, a, from, m, middle, depth + 1);
    add(tracer, m);
    split(tracer, m, middle, b, to, depth + 1);
}

static void trace_stretch(Tracer *tracer, double from, double to)
{
    size_t steps = (size_t)ceil((to - from) / first_step);
    if (steps < 2) steps = 2;
    YkCamVertex a = vertex_at(tracer, from);
    double at = from;
    add(tracer, a);
    for (size_t i = 1; i <= steps; i++) {
        double next = i == steps ? to : from + (to - from) * (double)i / (double)steps;
        YkCamVertex b = vertex_at(tracer, next);
        split(tracer, a, at, b, next, 0);
        add(tracer, b);
        a = b;
        at = next;
    }
}

static void trace(Tracer *tracer)
{
    const YkCamSamples *samples = &tracer->design->samples;
    double period = yk_law_range(samples->law).period;
    int laps = (int)rint(2 * YK_PI / period);
    for (int lap = 0; lap < laps; lap++) {
        tracer->lap = lap * period;
        for (size_t k = 0; k < samples->stretch_count; k++)
            trace_stretch(tracer, samples->items[samples->first[k]].angle,
                          samples->items[samples->first[k + 1] - 1].angle);
    }
    while (tracer->count > 1 &&
           yk_hypot(tracer->items[tracer->count - 1].x - tracer->items[0].x,
                    tracer->items[tracer->count - 1].y - tracer->items[0].y) <= 1e-3 * tracer->tolerance)
        tracer->count--; // the curve is closed
}

static bool is_there(const YkCamDesign *design, YkCamCurve curve)
{
    switch (curve) {
    case YK_CAM_CURVE_OUTER:
        return design->cam->is_groove;
    case YK_CAM_CURVE_SECOND_SURFACE:
    case YK_CAM_CURVE_SECOND_PITCH:
        return design->cam->is_conjugate;
    default:
        return true;
    }
}

YkStatus yk_cam_profile(const YkCamDesign *design, YkCamCurve curve, double tolerance, double cutter,
                        YkCamVertex **vertices, size_t *count)
{
    bool is_second = curve == YK_CAM_CURVE_SECOND_SURFACE || curve == YK_CAM_CURVE_SECOND_PITCH;
    Tracer tracer = {.design = design,
                     .shape = is_second ? &design->second : &design->shape,
                     .curve = curve,
                     .cutter = cutter,
                     .tolerance = tolerance};
    *vertices = NULL;
    *count = 0;
    if (!is_there(design, curve) || !(tolerance >= 1e-9 * design->cam->base) || !(cutter >= 0)) return YK_BAD_ARGUMENT;
    trace(&tracer);
    if (tracer.failed) {
        free(tracer.items);
        return YK_NO_MEMORY;
    }
    *vertices = tracer.items;
    *count = tracer.count;
    return YK_OK;
}

void yk_cam_vertices_free(YkCamVertex *vertices)
{
    free(vertices);
}
