// Limits on several dimensions of a path's bars: an input that turns fully, pivots in a box, sizes, transmission.
#include <math.h>
#include <string.h>
#include "synthesis/paths/path_fit.h"

typedef struct Limits {
    double *excess, (*by)[YK_BAR_SIZE];
    size_t count;
} Limits;

static double *add(Limits *l, double excess)
{
    double *row = l->by[l->count];
    memset(row, 0, YK_BAR_SIZE * sizeof *row);
    l->excess[l->count++] = excess;
    return row;
}

// least + other <= the sum of the remaining two.
static void add_grashof(Limits *l, const double *v, int least, int other)
{
    static const int links[] = {YK_BAR_GROUND, YK_BAR_INPUT, YK_BAR_COUPLER, YK_BAR_OUTPUT};
    double excess = 0;
    for (size_t k = 0; k < 4; k++) excess += links[k] == least || links[k] == other ? v[links[k]] : -v[links[k]];
    double *row = add(l, excess);
    for (size_t k = 0; k < 4; k++) row[links[k]] = links[k] == least || links[k] == other ? 1 : -1;
}

// Input or ground, whichever is shorter, is the shortest of all, and meets Grashof's condition with each.
static void add_turning(Limits *l, const YkBar *bar)
{
    const double *v = bar->v;
    if (bar->kind == YK_DESIGN_SLIDER_CRANK) {
        double *row = add(l, v[YK_BAR_INPUT] + fabs(v[YK_BAR_GROUND]) - v[YK_BAR_COUPLER]);
        row[YK_BAR_INPUT] = 1;
        row[YK_BAR_GROUND] = v[YK_BAR_GROUND] < 0 ? -1 : 1;
        row[YK_BAR_COUPLER] = -1;
        return;
    }
    if (!yk_bar_has_loop(bar->kind)) return;
    int least = v[YK_BAR_INPUT] <= v[YK_BAR_GROUND] ? YK_BAR_INPUT : YK_BAR_GROUND;
    add_grashof(l, v, least, least == YK_BAR_INPUT ? YK_BAR_GROUND : YK_BAR_INPUT);
    add_grashof(l, v, least, YK_BAR_COUPLER);
    add_grashof(l, v, least, YK_BAR_OUTPUT);
}

// The pivot that is not among the dimensions.
static void add_box(Limits *l, const YkPathProblem *problem, const YkBar *bar)
{
    YkVec away = yk_unit(bar->v[YK_BAR_TURN]), turned = yk_quarter(away);
    const YkBound *box = problem->task->pivots; // the pivot among the dimensions may be fixed
    double sign = bar->hangs_at_end ? -1 : 1, reach = sign * bar->v[YK_BAR_GROUND];
    for (int i = 0; i < 2; i++) {
        double at = bar->v[i] + reach * (i == 0 ? away.x : away.y);
        for (int end = 0; end < 2; end++) {
            double side = end == 0 ? -1 : 1, limit = end == 0 ? box[i].low : box[i].high;
            double *row = add(l, side * (at - limit));
            row[i] = side;
            row[YK_BAR_GROUND] = side * sign * (i == 0 ? away.x : away.y);
            row[YK_BAR_TURN] = side * reach * (i == 0 ? turned.x : turned.y);
        }
    }
}

static void add_size(Limits *l, const YkBar *bar, double ratio)
{
    int least = YK_BAR_INPUT, most = YK_BAR_INPUT;
    for (int k = YK_BAR_GROUND; k <= YK_BAR_ARM; k++) {
        if (!yk_bar_is_length(bar->kind, k)) continue;
        if (bar->v[k] < bar->v[least]) least = k;
        if (bar->v[k] > bar->v[most]) most = k;
    }
    double *row = add(l, (bar->v[most] - ratio * bar->v[least]) / ratio);
    row[most] += 1 / ratio;
    row[least] -= 1;
}

// A four-bar whose input turns through has its extreme transmission angles where input and ground lie in one line:
// |b^2 + c^2 - (g +- a)^2| <= 2 b c cos(angle).
static void add_transmission(Limits *l, const YkBar *bar, double angle)
{
    const double *v = bar->v, b = v[YK_BAR_COUPLER], c = v[YK_BAR_OUTPUT], most = 2 * yk_cos(angle);
    for (int k = 0; k < 2; k++) {
        double sign = k == 0 ? 1 : -1, d = v[YK_BAR_GROUND] + sign * v[YK_BAR_INPUT], open = b * b + c * c - d * d;
        double side = open < 0 ? -1 : 1, scale = 1 / (b + c);
        double excess = scale * (side * open - most * b * c);
        double *row = add(l, excess);
        row[YK_BAR_GROUND] = -2 * scale * side * d;
        row[YK_BAR_INPUT] = -2 * scale * side * d * sign;
        row[YK_BAR_COUPLER] = scale * (2 * side * b - most * c - excess);
        row[YK_BAR_OUTPUT] = scale * (2 * side * c - most * b - excess);
    }
}

size_t yk_path_limits(const YkPathProblem *problem, const YkBar *bar, double excess[YK_PATH_LIMITS],
                      double by[YK_PATH_LIMITS][YK_BAR_SIZE])
{
    Limits limits = {excess, by, 0};
    const YkTask *task = problem->task;
    bool is_four_bar = bar->kind == YK_DESIGN_FOUR_BAR;
    if (problem->turns) add_turning(&limits, bar);
    if (problem->has_box && bar->kind != YK_DESIGN_SLIDER_CRANK) add_box(&limits, problem, bar);
    if (task->size_ratio.is_given) add_size(&limits, bar, task->size_ratio.value);
    if (task->transmission.is_given && problem->turns && is_four_bar)
        add_transmission(&limits, bar, task->transmission.value);
    return limits.count;
}
