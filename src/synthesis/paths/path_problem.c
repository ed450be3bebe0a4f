// Makes the problem of a path's search: the bounds of a bar's dimensions, and a part of the points to begin with.
#include <math.h>
#include "synthesis/paths/path_search.h"

static void set_range(YkPathProblem *p, int index, const YkBound *bound, double low, double high)
{
    p->low[index] = bound && bound->is_given ? fmax(bound->low, low) : low;
    p->high[index] = bound && bound->is_given ? fmin(bound->high, high) : high;
}

static void fix_value(YkPathProblem *p, int index, double value)
{
    p->low[index] = p->high[index] = value;
}

// Fixes the dimensions that `fix` gives. A bar whose output pivot alone is given hangs there.
static void fix_given(YkPathProblem *p, const YkPathTask *path)
{
    p->hangs_at_end = path->pivot[1].is_given && !path->pivot[0].is_given;
    const YkGivenPoint *pivot = &path->pivot[p->hangs_at_end ? 1 : 0];
    if (pivot->is_given) {
        fix_value(p, YK_BAR_X, pivot->at.x);
        fix_value(p, YK_BAR_Y, pivot->at.y);
    }
    if (path->ground_angle.is_given) fix_value(p, YK_BAR_TURN, path->ground_angle.value);
    if (!path->pivot[0].is_given || !path->pivot[1].is_given) return;
    YkVec ground = yk_sub(path->pivot[1].at, path->pivot[0].at);
    fix_value(p, YK_BAR_GROUND, yk_norm(ground));
    fix_value(p, YK_BAR_TURN, yk_atan2(ground.y, ground.x));
}

// The dimensions of a dyad, and where it begins.
static void pose_dyad(YkPathProblem *p, const YkBound *lengths, double near, double far, double wide)
{
    double least = lengths->is_given ? fmax(lengths->low, 1e-9 * p->size) : near;
    for (int j = YK_BAR_CU; j <= YK_BAR_DV; j++) set_range(p, j, NULL, -far, far);
    for (int j = YK_BAR_LINK; j <= YK_BAR_ARM; j++) set_range(p, j, lengths, least, lengths->is_given ? wide : far);
    if (p->kind != YK_DESIGN_GEARED) return;
    set_range(p, YK_BAR_CU, NULL, -1e3, 1e3); // a phase
    for (int j = YK_BAR_CV; j <= YK_BAR_DV; j++) fix_value(p, j, 0);
}

static void pose(const YkTask *task, YkDesignKind kind, YkPathProblem *p)
{
    static const double least = 1e-3, most = 1e3; // over the size of the points
    const YkPathTask *path = &task->path;
    YkVec low = path->point[0], high = low;
    for (size_t k = 1; k < path->count; k++) {
        low = yk_vec(fmin(low.x, path->point[k].x), fmin(low.y, path->point[k].y));
        high = yk_vec(fmax(high.x, path->point[k].x), fmax(high.y, path->point[k].y));
    }
    *p = (YkPathProblem){.task = task, .point = path->point, .count = path->count, .kind = kind};
    p->dimensions = yk_bar_size(kind);
    p->angle = path->angle;
    p->step = path->step;
    p->size = yk_norm(yk_sub(high, low));
    p->middle = yk_scale(0.5, yk_add(low, high));
    p->is_timed = path->timing != YK_TIMING_ANY;
    p->shifts = path->timing == YK_TIMING_STEP;
    p->follows = path->from_ground;
    p->turns = task->turns || path->is_closed;
    p->has_box = task->pivots[0].is_given && !(path->pivot[0].is_given && path->pivot[1].is_given);
    double near = least * p->size, far = most * p->size, wide = fmax(far, 2 * task->lengths.high);
    set_range(p, YK_BAR_X, &task->pivots[0], p->middle.x - far, p->middle.x + far);
    set_range(p, YK_BAR_Y, &task->pivots[1], p->middle.y - far, p->middle.y + far);
    bool is_bounded = task->lengths.is_given;
    for (int j = YK_BAR_GROUND; j <= YK_BAR_OUTPUT; j++)
        set_range(p, j, &task->lengths, is_bounded ? fmax(task->lengths.low, 1e-9 * p->size) : near,
                  is_bounded ? wide : far);
    if (kind == YK_DESIGN_SLIDER_CRANK) set_range(p, YK_BAR_GROUND, NULL, -far, far);
    if (kind == YK_DESIGN_SLIDER_CRANK) fix_value(p, YK_BAR_OUTPUT, 1);
    if (kind == YK_DESIGN_INVERTED) set_range(p, YK_BAR_OUTPUT, NULL, -far, far);
    if (kind == YK_DESIGN_INVERTED || kind == YK_DESIGN_GEARED) fix_value(p, YK_BAR_COUPLER, 1);
    if (p->dimensions > YK_BAR_PLAIN) pose_dyad(p, &task->lengths, near, far, wide);
    set_range(p, YK_BAR_TURN, NULL, -1e3, 1e3);
    set_range(p, YK_BAR_PX, &task->coupler_point, -far, far);
    set_range(p, YK_BAR_PY, &task->coupler_point, -far, far);
    p->low[p->dimensions] = p->shifts ? -INFINITY : 0;
    p->high[p->dimensions] = p->shifts ? INFINITY : 0;
    fix_given(p, path);
}

// Thins the points out evenly, so that some 16 remain. An open path keeps its last point only if it is one of them.
static bool thin(YkArena *arena, YkPathBatches *batches)
{
    enum { COARSE = 16 };
    const YkPathProblem *p = &batches->problem;
    size_t stride = p->count >= 2 * COARSE ? p->count / COARSE : 1, count = (p->count + stride - 1) / stride;
    YkVec *point = YK_NEW(arena, YkVec, count);
    double *angle = p->angle ? YK_NEW(arena, double, count) : NULL;
    batches->coarse = *p;
    batches->stride = stride;
    if (!point || (p->angle && !angle)) return false;
    for (size_t k = 0; k < count; k++) point[k] = p->point[k * stride];
    for (size_t k = 0; k < count && angle; k++) angle[k] = p->angle[k * stride];
    batches->coarse.point = point;
    batches->coarse.angle = angle;
    batches->coarse.count = count;
    batches->coarse.step = p->step * (double)stride;
    return true;
}

size_t yk_path_batch_count(YkDesignKind kind)
{
    return yk_bar_size(kind) > YK_BAR_PLAIN ? YK_CHAIN_BATCHES : YK_PATH_BATCHES;
}

size_t yk_path_kinds(const YkTask *task, YkDesignKind kind[YK_DESIGN_KINDS])
{
    size_t count = 0;
    for (int k = 0; k < YK_DESIGN_KINDS; k++)
        if (task->kinds >> k & 1) kind[count++] = (YkDesignKind)k;
    return count;
}

bool yk_path_batches_new(YkArena *arena, const YkTask *task, YkDesignKind kind, uint64_t seed, YkPathBatches *batches)
{
    *batches = (YkPathBatches){.first_seed = seed, .seed = seed};
    pose(task, kind, &batches->problem);
    size_t n = batches->problem.count;
    bool good = thin(arena, batches) && yk_path_work(arena, n, &batches->work);
    good &= (batches->whole.angle = YK_NEW(arena, double, n)) != NULL;
    for (size_t k = 0; k <= YK_PATH_HOPEFUL; k++) good &= (batches->try[k].angle = YK_NEW(arena, double, n)) != NULL;
    return good;
}
