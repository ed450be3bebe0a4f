// Finds places for names in a picture.
#include "picture/labels.h"

enum { RINGS = 4, PLACES = 16 };

static double overlap(YkBox a, YkBox b)
{
    double across = fmin(a.right, b.right) - fmax(a.left, b.left), up = fmin(a.bottom, b.bottom) - fmax(a.top, b.top);
    return across > 0 && up > 0 ? across * up : 0;
}

// Returns how much of a line runs within a box, by clipping, which is exact (Liang & Barsky 1984).
static double covered(YkBox box, const YkVec line[2])
{
    YkVec d = yk_sub(line[1], line[0]);
    double p[4] = {-d.x, d.x, -d.y, d.y}, low = 0, high = 1;
    double q[4] = {line[0].x - box.left, box.right - line[0].x, line[0].y - box.top, box.bottom - line[0].y};
    for (int i = 0; i < 4; i++) {
        if (p[i] == 0 && q[i] < 0) return 0;
        if (p[i] < 0) low = fmax(low, q[i] / p[i]);
        if (p[i] > 0) high = fmin(high, q[i] / p[i]);
    }
    return high > low ? (high - low) * yk_norm(d) : 0;
}

// Leaving the page costs more than covering something.
static double outside(const YkLabels *labels, YkBox box)
{
    if (labels->width <= 0) return 0;
    double across = fmax(0, 4 - box.left) + fmax(0, box.right - labels->width + 4);
    double up = fmax(0, 4 - box.top) + fmax(0, box.bottom - labels->height + 4);
    return 100 * (across + up);
}

static double cost(const YkLabels *labels, YkBox box)
{
    double sum = outside(labels, box);
    for (size_t i = 0; i < labels->count; i++) sum += 4 * overlap(labels->boxes[i], box);
    YkBox wide = {box.left - labels->half, box.top - labels->half, box.right + labels->half, box.bottom + labels->half};
    for (size_t i = 0; i < labels->line_count; i++) sum += 10 * covered(wide, labels->lines[i]);
    return sum;
}

YkBox yk_box_at(YkVec middle, double width, double height)
{
    return (YkBox){middle.x - 0.5 * width, middle.y - 0.5 * height, middle.x + 0.5 * width, middle.y + 0.5 * height};
}

void yk_labels_take(YkLabels *labels, YkBox box)
{
    if (labels->count < YK_LABELS_MAX) labels->boxes[labels->count++] = box;
}

YkBox yk_labels_find(const YkLabels *labels, YkVec at, double reach, double width, double height, double *price)
{
    double best = INFINITY;
    YkBox chosen = {0};
    for (int ring = 0; ring < RINGS; ring++) {
        for (int i = 0; i < PLACES; i++) {
            YkVec out = yk_unit(-YK_PI / 4 + 2 * YK_PI * i / PLACES);
            double far = reach + 2 + 9.0 * ring;
            YkVec middle = yk_vec(at.x + out.x * (far + 0.5 * width), at.y + out.y * (far + 0.5 * height));
            YkBox box = yk_box_at(middle, width, height);
            double asked = cost(labels, box) + 12.0 * ring;
            if (asked < best - 1e-6) {
                best = asked;
                chosen = box;
            }
        }
    }
    if (price) *price = best;
    return chosen;
}
