// Finds extremes and signs over a period. The law is sampled in stretches between its segments' ends and its jumps,
// where everything is smooth up to the second derivative; a stretch's last sample has the values just before its end.
#include <math.h>
#include <stdlib.h>
#include "base/sort.h"
#include "design/cams/cam.h"

enum { SAMPLES = 1440, LEAST = 48, JUMPS_MAX = 400, SECTIONS = 60 };

typedef struct Breaks {
    double *at;
    size_t count;
} Breaks;

// Finds the ends of segments and jumps, ascending, each once; first and last are the ends of the period.
static bool find_breaks(const YkLaw *law, YkArena *arena, Breaks *breaks)
{
    size_t segments = yk_law_segment_count(law), jumps = yk_law_jumps(law, NULL, 0);
    YkLawRange range = yk_law_range(law);
    double close = 1e-12 * (range.to - range.from);
    if (jumps > JUMPS_MAX) jumps = JUMPS_MAX;
    YkLawJump *found = YK_NEW(arena, YkLawJump, jumps + 1);
    double *all = YK_NEW(arena, double, segments + jumps + 2);
    if (!found || !all) return false;
    size_t count = 0;
    all[count++] = range.from;
    all[count++] = range.to;
    for (size_t i = 1; i < segments; i++) all[count++] = yk_law_segment(law, i).from;
    yk_law_jumps(law, found, jumps);
    for (size_t i = 0; i < jumps; i++) all[count++] = found[i].x;
    qsort(all, count, sizeof *all, yk_by_size);
    breaks->at = all;
    for (size_t i = 0; i < count; i++) {
        if (breaks->count == 0 || all[i] - all[breaks->count - 1] > close) all[breaks->count++] = all[i];
    }
    return true;
}

static size_t samples_in(double from, double to, double period)
{
    size_t count = (size_t)ceil(SAMPLES * (to - from) / period);
    return (count < LEAST ? LEAST : count) + 1;
}

static YkCamSample take(const YkLaw *law, double angle)
{
    YkCamSample sample = {.angle = angle};
    yk_law_eval(law, angle, sample.lift);
    return sample;
}

bool yk_cam_samples_take(YkCamSamples *samples, const YkLaw *law, YkArena *arena)
{
    Breaks breaks = {NULL, 0};
    *samples = (YkCamSamples){.law = law};
    if (!find_breaks(law, arena, &breaks)) return false;
    double period = breaks.at[breaks.count - 1] - breaks.at[0];
    size_t total = 0;
    samples->first = YK_NEW(arena, size_t, breaks.count + 1);
    for (size_t i = 0; i + 1 < breaks.count; i++) total += samples_in(breaks.at[i], breaks.at[i + 1], period);
    samples->items = YK_NEW(arena, YkCamSample, total + 1);
    if (!samples->first || !samples->items) return false;
    for (size_t i = 0; i + 1 < breaks.count; i++) {
        double from = breaks.at[i], to = breaks.at[i + 1];
        size_t last = samples_in(from, to, period) - 1;
        for (size_t k = 0; k < last; k++)
            samples->items[samples->count++] = take(law, from + (to - from) * (double)k / (double)last);
        samples->items[samples->count++] = take(law, nextafter(to, from));
        samples->first[++samples->stretch_count] = samples->count;
    }
    return true;
}

// A measure of one shape, as a function of the angle.
typedef struct Probe {
    const YkCamSamples *samples;
    const YkCamShape *shape;
    YkCamMeasure measure;
    const void *context;
    double noise; // what rounding leaves of values, once samples were compared
} Probe;

static double of_sample(const Probe *probe, const YkCamSample *sample)
{
    YkCamPoint point = yk_cam_shape_at(probe->shape, sample->angle, sample->lift);
    return probe->measure(&point, probe->context);
}

static double of_angle(const Probe *probe, double angle)
{
    YkCamSample sample = take(probe->samples->law, angle);
    return of_sample(probe, &sample);
}

// Finds the top between two angles by golden section.
static YkCamExtreme climb(const Probe *probe, double low, double high)
{
    const double golden = 0.61803398874989485;
    double a = high - golden * (high - low), b = low + golden * (high - low);
    double at_a = of_angle(probe, a), at_b = of_angle(probe, b);
    for (int i = 0; i < SECTIONS && high - low > 1e-15 * fabs(high); i++) {
        if (at_a >= at_b) {
            high = b;
            b = a;
            at_b = at_a;
            at_a = of_angle(probe, a = high - golden * (high - low));
        } else {
            low = a;
            a = b;
            at_a = at_b;
            at_b = of_angle(probe, b = low + golden * (high - low));
        }
    }
    return at_a >= at_b ? (YkCamExtreme){at_a, a} : (YkCamExtreme){at_b, b};
}

// Finds the first of the greatest samples: where a cam dwells all values are one but for rounding, which is in
// proportion to the largest of all.
static YkCamExtreme greatest_sample(Probe *probe)
{
    const YkCamSamples *samples = probe->samples;
    YkCamExtreme best = {-(double)INFINITY, 0};
    for (size_t i = 0; i < samples->count; i++) {
        double value = of_sample(probe, &samples->items[i]);
        if (isfinite(value)) probe->noise = fmax(probe->noise, 1e-14 * fabs(value));
        if (value - best.value > probe->noise) best = (YkCamExtreme){value, samples->items[i].angle};
    }
    return best;
}

bool yk_cam_is_above_zero(const YkCamSamples *samples, const YkCamShape *shape, YkCamMeasure measure,
                          const void *context, size_t *where)
{
    Probe probe = {.samples = samples, .shape = shape, .measure = measure, .context = context};
    if (*where < samples->count && of_sample(&probe, &samples->items[*where]) > 0) return true;
    for (size_t i = 0; i < samples->count; i++) {
        if (!(of_sample(&probe, &samples->items[i]) > 0)) continue;
        *where = i;
        return true;
    }
    return false;
}

// Refines the peaks of one stretch that come near the best sample of all.
static void refine(const Probe *probe, size_t stretch, double near, YkCamExtreme *best)
{
    const YkCamSample *items = probe->samples->items;
    size_t first = probe->samples->first[stretch], end = probe->samples->first[stretch + 1];
    double before = -(double)INFINITY, here = of_sample(probe, &items[first]);
    for (size_t i = first; i < end; i++) {
        double after = i + 1 < end ? of_sample(probe, &items[i + 1]) : -(double)INFINITY;
        if (here >= near && here > before && here >= after) {
            size_t low = i > first ? i - 1 : i, high = i + 1 < end ? i + 1 : i;
            YkCamExtreme top = climb(probe, items[low].angle, items[high].angle);
            if (top.value - best->value > probe->noise) *best = top;
        }
        before = here;
        here = after;
    }
}

YkCamExtreme yk_cam_greatest(const YkCamSamples *samples, const YkCamShape *shape, YkCamMeasure measure,
                             const void *context)
{
    Probe probe = {.samples = samples, .shape = shape, .measure = measure, .context = context};
    YkCamExtreme best = greatest_sample(&probe);
    if (!isfinite(best.value)) return best;
    double near = best.value - 0.02 * fabs(best.value);
    for (size_t k = 0; k < samples->stretch_count; k++) refine(&probe, k, near, &best);
    return best;
}

// Finds where the sign changes between two samples.
static double crossing(const Probe *probe, double low, double high)
{
    bool is_negative = of_angle(probe, low) < 0;
    for (int i = 0; i < 100; i++) {
        double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) break;
        if ((of_angle(probe, middle) < 0) == is_negative) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low + (high - low) / 2;
}

// Ranges, opened and closed in turn.
typedef struct Ranges {
    YkCamRange *items;
    size_t count, capacity;
    bool is_open;
} Ranges;

static void toggle(Ranges *ranges, double at)
{
    if (!ranges->is_open) {
        if (ranges->count < ranges->capacity) ranges->items[ranges->count].from = at;
    } else {
        if (ranges->count < ranges->capacity) ranges->items[ranges->count].to = at;
        ranges->count++;
    }
    ranges->is_open = !ranges->is_open;
}

// Finds a dip below zero between two positive samples, by its bottom.
static double down(const YkCamPoint *point, const void *context)
{
    const Probe *probe = context;
    return -probe->measure(point, probe->context);
}

static void find_dip(const Probe *probe, size_t i, size_t first, size_t end, const double *value, Ranges *ranges)
{
    const YkCamSample *items = probe->samples->items;
    if (ranges->is_open || i == first || i + 1 >= end || !(value[1] < value[0] && value[1] <= value[2])) return;
    Probe turned = {.samples = probe->samples, .shape = probe->shape, .measure = down, .context = probe};
    YkCamExtreme bottom = climb(&turned, items[i - 1].angle, items[i + 1].angle);
    if (!(bottom.value > 0)) return;
    toggle(ranges, crossing(probe, items[i - 1].angle, bottom.angle));
    toggle(ranges, crossing(probe, bottom.angle, items[i + 1].angle));
}

static void scan(const Probe *probe, size_t stretch, Ranges *ranges)
{
    const YkCamSample *items = probe->samples->items;
    size_t first = probe->samples->first[stretch], end = probe->samples->first[stretch + 1];
    double value[3] = {0, of_sample(probe, &items[first]), 0};
    if ((value[1] < 0) != ranges->is_open) toggle(ranges, items[first].angle); // a jump, or the very start
    for (size_t i = first; i < end; i++) {
        value[2] = i + 1 < end ? of_sample(probe, &items[i + 1]) : value[1];
        if (value[1] >= 0 && value[2] >= 0) find_dip(probe, i, first, end, value, ranges);
        if ((value[1] < 0) != (value[2] < 0)) toggle(ranges, crossing(probe, items[i].angle, items[i + 1].angle));
        value[0] = value[1];
        value[1] = value[2];
    }
}

size_t yk_cam_negative(const YkCamSamples *samples, const YkCamShape *shape, YkCamMeasure measure, const void *context,
                       YkCamRange *ranges, size_t capacity)
{
    Probe probe = {.samples = samples, .shape = shape, .measure = measure, .context = context};
    Ranges found = {.items = ranges, .capacity = capacity};
    for (size_t k = 0; k < samples->stretch_count; k++) scan(&probe, k, &found);
    if (found.is_open) toggle(&found, yk_law_range(samples->law).to);
    return found.count;
}
