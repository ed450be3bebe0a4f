// Levenberg and Marquardt's way for a path, with the input's free angles eliminated.
#include "synthesis/paths/path_fit.h"
#include <math.h>
#include <string.h>
#include "synthesis/least_squares.h"

enum { N = YK_PATH_UNKNOWNS }; // at most

static const double weight_at_first = 100;
static const double margin = 1e-6;  // by which limits are kept, over the size of the points
static const double turn_max = 0.4; // of the input in one step, rad

bool yk_path_work(YkArena *arena, size_t count, YkPathWork *work)
{
    size_t rows = 2 * count + YK_PATH_LIMITS, all = rows + N;
    *work = (YkPathWork){.count = count, .weight = weight_at_first};
    work->now = YK_NEW(arena, YkBarPoint, count);
    work->next = YK_NEW(arena, YkBarPoint, count);
    work->row = YK_NEW(arena, double, rows *N);
    work->miss = YK_NEW(arena, double, rows);
    work->A = YK_NEW(arena, double, all *N);
    work->b = YK_NEW(arena, double, all);
    work->angle = YK_NEW(arena, double, count);
    return work->now && work->next && work->row && work->miss && work->A && work->b && work->angle;
}

void yk_path_turn_angles(const YkPathProblem *problem, YkPathTry *try)
{
    for (size_t k = 0; k < problem->count && problem->follows; k++)
        try->angle[k] = problem->angle[k] + try->bar.v[YK_BAR_TURN];
}

static double squared(double x)
{
    return x * x;
}

// Returns what the limits add to the cost, m^2.
static double limits_cost(const YkPathProblem *problem, const YkBar *bar, double weight)
{
    double excess[YK_PATH_LIMITS], by[YK_PATH_LIMITS][YK_BAR_SIZE], cost = 0;
    size_t count = yk_path_limits(problem, bar, excess, by);
    for (size_t k = 0; k < count; k++) cost += squared(weight * fmax(excess[k] + margin * problem->size, 0));
    return cost;
}

static bool measure(const YkPathProblem *problem, double weight, YkBarPoint *points, YkPathTry *try)
{
    yk_path_turn_angles(problem, try);
    try->error = 0;
    for (size_t k = 0; k < problem->count; k++) {
        if (!yk_bar_point(&try->bar, try->angle[k], &points[k])) return false;
        YkVec miss = yk_sub(points[k].at, problem->point[k]);
        try->error += yk_dot(miss, miss);
    }
    try->cost = try->error + limits_cost(problem, &try->bar, weight);
    return isfinite(try->cost);
}

bool yk_path_measure(const YkPathProblem *problem, YkPathWork *work, YkPathTry *try)
{
    return measure(problem, work->weight, work->now, try);
}

// --- the linear problem

static void add_row(const YkPathProblem *problem, YkPathWork *work, size_t *rows, const YkBarPoint *p, YkVec along,
                    YkVec miss)
{
    double *row = &work->row[*rows * (problem->dimensions + 1)];
    for (size_t j = 0; j < problem->dimensions; j++) row[j] = yk_dot(along, p->by[j]);
    if (problem->follows) row[YK_BAR_TURN] += yk_dot(along, p->by_input);
    row[problem->dimensions] = problem->shifts ? yk_dot(along, p->by_input) : 0;
    work->miss[(*rows)++] = yk_dot(along, miss);
}

static size_t linearise(const YkPathProblem *problem, YkPathWork *work, const YkPathTry *try)
{
    size_t rows = 0;
    for (size_t k = 0; k < problem->count; k++) {
        const YkBarPoint *p = &work->now[k];
        YkVec miss = yk_sub(p->at, problem->point[k]);
        double speed = yk_norm(p->by_input);
        if (!problem->is_timed && speed > 0) { // along the curve the angle makes up for the miss
            add_row(problem, work, &rows, p, yk_scale(1 / speed, yk_quarter(p->by_input)), miss);
            continue;
        }
        add_row(problem, work, &rows, p, yk_vec(1, 0), miss);
        add_row(problem, work, &rows, p, yk_vec(0, 1), miss);
    }
    double excess[YK_PATH_LIMITS], by[YK_PATH_LIMITS][YK_BAR_SIZE];
    size_t limits = yk_path_limits(problem, &try->bar, excess, by);
    for (size_t k = 0; k < limits; k++) {
        double over = excess[k] + margin * problem->size, *row = &work->row[rows * (problem->dimensions + 1)];
        if (over <= 0) continue;
        for (size_t j = 0; j < problem->dimensions; j++) row[j] = work->weight * by[k][j];
        row[problem->dimensions] = 0;
        work->miss[rows++] = work->weight * over;
    }
    return rows;
}

// Limits the turn of a free angle: neighbours keep their order where the task has one.
static double limited(const YkPathProblem *problem, const double *angle, size_t k, double turn)
{
    static const double part = 0.45; // of the way to the neighbour
    double most = turn_max;
    if (problem->task->any_order) return fmin(fmax(turn, -most), most);
    size_t last = problem->count - 1;
    double whole = angle[last] - angle[0], rest = 2 * YK_PI - fabs(whole); // from the last point to the first
    bool goes_on = turn * whole > 0;
    if (goes_on && k < last) most = fmin(most, part * fabs(angle[k + 1] - angle[k]));
    if (!goes_on && k > 0) most = fmin(most, part * fabs(angle[k] - angle[k - 1]));
    bool is_end = goes_on ? k == last : k == 0;
    if (problem->task->path.is_closed && is_end) most = fmin(most, fmax(part * rest, 0));
    return fmin(fmax(turn, -most), most);
}

// Moves a try by a step, each free angle as its own point asks.
static void move(const YkPathProblem *problem, const YkPathWork *work, const YkPathTry *from, const double *step,
                 YkPathTry *to)
{
    to->bar = from->bar;
    for (size_t j = 0; j < problem->dimensions; j++)
        to->bar.v[j] = fmin(fmax(from->bar.v[j] + step[j], problem->low[j]), problem->high[j]);
    for (size_t k = 0; k < problem->count; k++) {
        const YkBarPoint *p = &work->now[k];
        double turn = step[problem->dimensions];
        if (!problem->is_timed) {
            YkVec miss = yk_sub(p->at, problem->point[k]);
            for (size_t j = 0; j < problem->dimensions; j++) miss = yk_add(miss, yk_scale(step[j], p->by[j]));
            double speed = yk_dot(p->by_input, p->by_input);
            turn = speed > 0 ? -yk_dot(miss, p->by_input) / speed : 0;
            turn = limited(problem, from->angle, k, turn);
        }
        to->angle[k] = from->angle[k] + turn;
    }
}

bool yk_path_improve(const YkPathProblem *problem, YkPathWork *work, YkPathTry *try, size_t steps)
{
    static const double damping_max = 1e8;
    double damping = 1e-3, none = squared(1e-16 * problem->size) * (double)problem->count;
    size_t still = 0, rows = 0;
    bool is_new = true;
    if (!measure(problem, work->weight, work->now, try)) return false;
    for (size_t k = 0; k < steps && still < 10 && damping < damping_max && try->cost > none; k++) {
        YkPathTry next = {.angle = work->angle};
        double at[N] = {0}, step[N];
        if (is_new) rows = linearise(problem, work, try);
        memcpy(at, try->bar.v, problem->dimensions * sizeof *at);
        YkLinear linear = {problem->dimensions + 1, rows,    work->row, work->miss, at, problem->low,
                           problem->high,           work->A, work->b};
        yk_linear_step(&linear, damping, step);
        move(problem, work, try, step, &next);
        is_new = measure(problem, work->weight, work->next, &next) && next.cost < try->cost;
        damping = is_new ? fmax(damping * 0.2, 1e-14) : damping * 5;
        if (!is_new) continue;
        still = next.cost > (1 - 1e-6) * try->cost ? still + 1 : 0;
        YkBarPoint *points = work->now;
        work->now = work->next;
        work->next = points;
        memcpy(try->angle, next.angle, problem->count * sizeof *next.angle);
        try->bar = next.bar;
        try->error = next.error;
        try->cost = next.cost;
    }
    return true;
}
