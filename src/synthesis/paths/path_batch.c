// A batch of a path's search: starts are drawn, and the best of them improved, with a part of the points where there
// are many; then the best of these to the end, with all points.
#include <math.h>
#include <string.h>
#include "base/mix.h"
#include "synthesis/paths/path_chain.h"
#include "synthesis/paths/path_search.h"

enum {
    STARTS = 60,
    STARTS_OF_CHAINS = 400,
    FIRST_STEPS = 12,
    TIED_STEPS = 120,
    LAST_STEPS = 1500,
    HARD_WEIGHT = 100000
};

static void copy_try(const YkPathProblem *p, YkPathTry *to, const YkPathTry *from)
{
    double *angle = to->angle;
    memcpy(angle, from->angle, p->count * sizeof *angle);
    *to = *from;
    to->angle = angle;
}

// Puts a try among the first `*count` of a list, best first, at most `most`.
void yk_path_insert(const YkPathProblem *p, YkPathTry *list, size_t *count, size_t most, const YkPathTry *try)
{
    if (*count == most && !(try->cost < list[most - 1].cost)) return;
    size_t k = *count < most ? (*count)++ : most - 1;
    YkPathTry room = list[k];
    for (; k > 0 && try->cost < list[k - 1].cost; k--) list[k] = list[k - 1];
    list[k] = room;
    copy_try(p, &list[k], try);
}

// Fills in the angles of all points from those of a part: as given, or evenly between neighbours.
static void fill_angles(const YkPathBatches *batches, const YkPathTry *part, YkPathTry *whole)
{
    const YkPathProblem *p = &batches->problem, *c = &batches->coarse;
    double last = part->angle[c->count - 1], turn = last < part->angle[0] ? -2 * YK_PI : 2 * YK_PI;
    double *angle = whole->angle;
    *whole = *part;
    whole->angle = angle;
    for (size_t k = 0; k < p->count; k++) {
        size_t i = k / batches->stride, off = k % batches->stride;
        double from = part->angle[i], to = i + 1 < c->count ? part->angle[i + 1] : part->angle[0] + turn;
        size_t gap = i + 1 < c->count ? batches->stride : p->count - i * batches->stride;
        angle[k] = from + (to - from) * (double)off / (double)gap;
        if (p->angle) angle[k] = p->angle[k];
        if (p->shifts) angle[k] = part->angle[0] + p->step * (double)k;
    }
}

// Makes the part of the points a problem whose angles turn together alone: a bar then does not fold the curve into a
// part of it. `step` is 0 if the angles are found otherwise.
static YkPathProblem tie_angles(YkPathProblem p, double step)
{
    p.is_timed = p.shifts = true;
    p.step = step;
    p.low[p.dimensions] = -INFINITY;
    p.high[p.dimensions] = INFINITY;
    return p;
}

// Gives a try the angles at which it has gone the same part of its curve as the points of theirs. Leaves it as it is
// where the input does not turn through.
static void match_ways(const YkPathProblem *p, YkPathTry *try)
{
    enum { PARTS = 128 };
    double way[PARTS + 1] = {0}, whole = 0, gone = 0, sense = try->angle[1] < try->angle[0] ? -1 : 1;
    YkBarPoint at;
    YkVec last = {0};
    for (size_t i = 0; i <= PARTS; i++) {
        if (!yk_bar_point(&try->bar, try->angle[0] + sense * 2 * YK_PI * (double)i / PARTS, &at)) return;
        if (i > 0) way[i] = way[i - 1] + yk_norm(yk_sub(at.at, last));
        last = at.at;
    }
    for (size_t k = 0; k < p->count; k++) whole += yk_norm(yk_sub(p->point[(k + 1) % p->count], p->point[k]));
    for (size_t k = 1, i = 0; k < p->count; k++) {
        gone += yk_norm(yk_sub(p->point[k], p->point[k - 1]));
        double wanted = gone / whole * way[PARTS];
        while (i + 1 < PARTS && way[i + 1] < wanted) i++;
        double part = way[i + 1] > way[i] ? (wanted - way[i]) / (way[i + 1] - way[i]) : 0;
        try->angle[k] = try->angle[0] + sense * 2 * YK_PI * ((double)i + part) / PARTS;
    }
}

// Improves a try that keeps pace with the points along its curve.
static void improve_in_pace(YkPathBatches *batches, const YkPathProblem *p, YkPathTry *try, size_t rounds)
{
    enum { STEPS = 4 };
    for (size_t k = 0; k < rounds; k++) {
        match_ways(p, try);
        yk_path_improve(p, &batches->work, try, STEPS);
    }
}

// How a batch treats free angles: each its own, at even steps, or in pace with the points along the curve.
typedef enum Tie { TIE_NONE, TIE_STEPS, TIE_PACE } Tie;

static void improve_tied(YkPathBatches *batches, const YkPathProblem *p, Tie tie, YkPathTry *try, size_t steps)
{
    if (tie == TIE_PACE)
        improve_in_pace(batches, p, try, steps / 4);
    else
        yk_path_improve(p, &batches->work, try, steps);
}

// Brings the random numbers to where a batch begins.
static void go_to(YkPathBatches *batches, size_t batch)
{
    if (batches->problem.kind >= YK_DESIGN_INVERTED) { // a seed of its own
        batches->seed = yk_mix(batches->first_seed ^ yk_mix(batch + 1000 * (uint64_t)batches->problem.kind));
        return;
    }
    if (batch < batches->next) {
        batches->next = 0;
        batches->seed = batches->first_seed;
    }
    for (; batches->next < batch; batches->next++)
        for (size_t k = 0; k < STARTS; k++)
            yk_path_skip(&batches->coarse, &batches->seed, &batches->try[YK_PATH_HOPEFUL]);
    batches->next++; // the batch itself draws the rest
}

static bool improve_to_the_end(YkPathBatches *batches)
{
    const YkPathProblem *p = &batches->problem;
    YkPathTry *try = &batches->whole;
    const double weight = batches->work.weight;
    bool closes = yk_path_improve(p, &batches->work, try, LAST_STEPS);
    if (closes && try->cost > try->error) { // limits that hold the bar back are then kept within their margin
        batches->work.weight = HARD_WEIGHT;
        yk_path_improve(p, &batches->work, try, LAST_STEPS);
        batches->work.weight = weight;
    }
    return closes;
}

size_t yk_path_batch_work(const YkPathBatches *batches)
{
    return 500 + 20 * batches->problem.count;
}

bool yk_path_batch(YkPathBatches *batches, size_t batch)
{
    static const Tie ties[] = {TIE_STEPS, TIE_PACE, TIE_STEPS, TIE_NONE};
    const YkPathProblem *c = &batches->coarse;
    YkPathTry *fresh = &batches->try[YK_PATH_HOPEFUL];
    size_t count = 0, best = 0;
    bool may_tie = !c->is_timed && c->task->path.is_closed && c->count > YK_BAR_PLAIN + 1;
    Tie tie = may_tie ? ties[batch % 4] : TIE_NONE;
    double step = batch % 4 == 0 ? 2 * YK_PI : -2 * YK_PI;
    YkPathProblem tied = tie_angles(*c, step / (double)c->count);
    go_to(batches, batch);
    size_t starts = c->dimensions > YK_BAR_PLAIN ? STARTS_OF_CHAINS : STARTS;
    for (size_t k = 0; k < starts; k++)
        if (yk_path_draw(tie == TIE_STEPS ? &tied : c, &batches->work, &batches->seed, fresh))
            yk_path_insert(c, batches->try, &count, YK_PATH_HOPEFUL, fresh);
    for (size_t k = 0; k < count; k++) {
        improve_tied(batches, tie == TIE_NONE ? c : &tied, tie, &batches->try[k], FIRST_STEPS);
        if (batches->try[k].cost < batches->try[best].cost) best = k;
    }
    if (count == 0) return false;
    if (tie != TIE_NONE) improve_tied(batches, &tied, tie, &batches->try[best], TIED_STEPS);
    fill_angles(batches, &batches->try[best], &batches->whole);
    return improve_to_the_end(batches);
}

// --- as numbers

size_t yk_path_width(const YkTask *task)
{
    return YK_BAR_SIZE + 6 + task->path.count;
}

void yk_path_pack(const YkPathBatches *batches, bool closes, double *numbers)
{
    const YkPathTry *try = &batches->whole;
    double *at = numbers;
    memset(numbers, 0, yk_path_width(batches->problem.task) * sizeof *numbers);
    if (!closes) return;
    *at++ = 1;
    *at++ = try->bar.branch;
    *at++ = try->bar.bend;
    *at++ = try->bar.variant;
    *at++ = try->error;
    *at++ = try->cost;
    memcpy(at, try->bar.v, sizeof try->bar.v);
    memcpy(at + YK_BAR_SIZE, try->angle, batches->problem.count * sizeof *at);
}

bool yk_path_unpack(YkPathBatches *batches, const double *numbers)
{
    const YkPathProblem *p = &batches->problem;
    YkPathTry *try = &batches->whole;
    const double *at = numbers;
    if (*at++ != 1) return false;
    try->bar = (YkBar){.kind = p->kind, .hangs_at_end = p->hangs_at_end};
    try->bar.branch = *at++ < 0 ? -1 : 1;
    try->bar.bend = *at++ < 0 ? -1 : 1;
    double variant = *at++, variants = (double)yk_chain_variants(p->kind);
    if (!(variant >= 0 && variant < fmax(1, variants))) return false; // numbers may come from elsewhere
    try->bar.variant = (int)variant;
    try->error = *at++;
    try->cost = *at++;
    memcpy(try->bar.v, at, sizeof try->bar.v);
    memcpy(try->angle, at + YK_BAR_SIZE, p->count * sizeof *at);
    return true;
}
