// Finds the strokes of a motion program, from rest to the next turning point, and their peak factors.
// Source: Neklutin 1952; Norton 2009, ch. 3.
#include <math.h>
#include "design/cams/cam.h"

enum { JUMPS_MAX = 200 };

void yk_cam_count_jumps(const YkLaw *law, double from, double to, double period, YkCamFactors *factors)
{
    YkLawJump found[JUMPS_MAX];
    size_t count = yk_law_jumps(law, found, JUMPS_MAX);
    double close = 1e-9 * (to - from);
    for (size_t i = 0; i < count && i < JUMPS_MAX; i++) {
        for (double x = found[i].x - period; x <= found[i].x + period * 1.5; x += period > 0 ? period : 1) {
            if (x < from - close || x > to + close) continue;
            factors->j = INFINITY;
            if (found[i].order <= 1) factors->a = INFINITY;
            if (found[i].order == 0) factors->v = INFINITY;
        }
    }
}

typedef struct Part {
    int order;
    double from, to, period;
} Part;

static double size_in(const YkCamPoint *point, const void *context)
{
    const Part *part = context;
    double x = point->angle, close = 1e-12 * part->period;
    if (x > part->to + close) x -= part->period; // a stroke that begins before the period does
    return x >= part->from - close && x <= part->to + close ? fabs(point->lift[part->order]) : -(double)INFINITY;
}

static YkCamFactors factors_of(const YkCamDesign *design, const YkCamStroke *stroke)
{
    Part part = {.from = stroke->from, .to = stroke->to, .period = yk_law_range(design->law->law).period};
    double h = fabs(stroke->lift), beta = stroke->to - stroke->from, peak[4];
    for (part.order = 1; part.order <= 3; part.order++)
        peak[part.order] = yk_cam_greatest(&design->samples, &design->shape, size_in, &part).value;
    YkCamFactors factors = {peak[1] * beta / h, peak[2] * beta * beta / h, peak[3] * beta * beta * beta / h};
    yk_cam_count_jumps(design->law->law, stroke->from, stroke->to, part.period, &factors);
    return factors;
}

// Strokes as they are found: ranges in which v keeps its sign.
typedef struct Strokes {
    YkCamStroke *items;
    size_t count, capacity;
    int sign; // of the open one; 0: none is open
    double from;
} Strokes;

static void end_stroke(Strokes *strokes, double at)
{
    if (strokes->sign != 0) {
        if (strokes->count < strokes->capacity)
            strokes->items[strokes->count] = (YkCamStroke){.from = strokes->from, .to = at, .lift = strokes->sign};
        strokes->count++;
    }
    strokes->sign = 0;
}

// Finds where v passes zero between two samples.
static double turning_point(const YkLaw *law, double low, double high)
{
    double d[YK_LAW_ORDER + 1];
    yk_law_eval(law, low, d);
    bool rises = d[1] > 0;
    for (int i = 0; i < 100; i++) {
        double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) break;
        yk_law_eval(law, middle, d);
        if ((d[1] > 0) == rises) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return high;
}

static void scan_stretch(const YkCamSamples *samples, size_t stretch, double quiet, Strokes *strokes)
{
    size_t first = samples->first[stretch], end = samples->first[stretch + 1], moving = first;
    const YkCamSample *items = samples->items;
    bool moves = false;
    for (size_t i = first; i < end; i++) {
        double v = items[i].lift[1];
        if (fabs(v) <= quiet) continue;
        int sign = v > 0 ? 1 : -1;
        if (sign != strokes->sign) {
            double at = moves ? turning_point(samples->law, items[moving].angle, items[i].angle) : items[first].angle;
            end_stroke(strokes, at);
            strokes->sign = sign;
            strokes->from = at;
        }
        moves = true;
        moving = i;
    }
    if (!moves) end_stroke(strokes, items[first].angle);
}

// Joins a stroke that continues over the end of the period with the one at its beginning.
static void join_ends(Strokes *strokes, YkLawRange range)
{
    if (strokes->count < 2 || strokes->count > strokes->capacity) return;
    YkCamStroke *first = strokes->items, *last = first + strokes->count - 1;
    if (first->from != range.from || last->to != range.to || first->lift != last->lift) return;
    first->from = last->from - range.period;
    strokes->count--;
}

size_t yk_cam_strokes(const YkCamDesign *design, YkCamStroke *strokes, size_t capacity)
{
    const YkLaw *law = design->law->law;
    YkLawRange range = yk_law_range(law);
    double quiet = 1e-12 * fabs(yk_law_peak(law, 1).value);
    Strokes found = {.items = strokes, .capacity = capacity};
    for (size_t k = 0; k < design->samples.stretch_count; k++) scan_stretch(&design->samples, k, quiet, &found);
    end_stroke(&found, range.to);
    join_ends(&found, range);
    for (size_t i = 0; i < found.count && i < capacity; i++) {
        strokes[i].lift = yk_cam_law_lift(law, strokes[i].to) - yk_cam_law_lift(law, strokes[i].from);
        strokes[i].factors = factors_of(design, &strokes[i]);
    }
    return found.count;
}
