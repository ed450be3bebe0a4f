// A point through points: bars by random starts and least squares, each judged by the engine on its file.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "synthesis/path_start.h"
#include "synthesis/synthesis.h"

// A batch draws starts, improves the best of them a little, and the best of these to the end; the first two with a part of
// the points where there are many. The search ends after so many batches, or when enough bars pass the points to rounding:
// where there are more points than a bar can be made to pass, few do, and all of them soon.
enum { BATCHES = 1500, STARTS = 60, HOPEFUL = 6, FIRST_STEPS = 12, LAST_STEPS = 400, POOL = 400 };
enum { COARSE = 16, EXACT = 60, EXACT_OF_MANY = 2, MORE_BATCHES = 40, HARD_WEIGHT = 100000 };

typedef struct Search {
    YkSynthesis *s;
    YkPathProblem problem, coarse; // all points, and every `stride`th
    YkPathWork work;
    YkPathTry try[HOPEFUL + 1], whole; // of some points, the last one is drawn into; of all points
    size_t stride;
    YkPathTry pool[POOL];       // that passed, best first
    size_t pooled, most, exact; // `most`: as many are kept
    YkVec *path;                // [count]
    uint64_t seed;
} Search;

// --- the problem

static void set_range(YkPathProblem *p, int index, const YkBound *bound, double low, double high)
{
    p->low[index] = bound && bound->is_given ? fmax(bound->low, low) : low;
    p->high[index] = bound && bound->is_given ? fmin(bound->high, high) : high;
}

static void fix_value(YkPathProblem *p, int index, double value)
{
    p->low[index] = p->high[index] = value;
}

// What `fix` gives. A bar whose output pivot alone is given hangs there.
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

static void pose_problem(const YkTask *task, YkDesignKind kind, YkPathProblem *p)
{
    static const double least = 1e-3, most = 1e3; // over the size of the points
    const YkPathTask *path = &task->path;
    YkVec low = path->point[0], high = low;
    for (size_t k = 1; k < path->count; k++) {
        low = yk_vec(fmin(low.x, path->point[k].x), fmin(low.y, path->point[k].y));
        high = yk_vec(fmax(high.x, path->point[k].x), fmax(high.y, path->point[k].y));
    }
    *p = (YkPathProblem){.task = task, .point = path->point, .count = path->count, .kind = kind};
    p->angle = path->angle;
    p->step = path->step;
    p->size = yk_norm(yk_sub(high, low));
    p->middle = yk_scale(0.5, yk_add(low, high));
    p->is_timed = path->timing != YK_TIMING_ANY;
    p->shifts = path->timing == YK_TIMING_STEP;
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
    set_range(p, YK_BAR_TURN, NULL, -1e3, 1e3);
    set_range(p, YK_BAR_PX, &task->coupler_point, -far, far);
    set_range(p, YK_BAR_PY, &task->coupler_point, -far, far);
    p->low[YK_BAR_SIZE] = p->shifts ? -INFINITY : 0;
    p->high[YK_BAR_SIZE] = p->shifts ? INFINITY : 0;
    fix_given(p, path);
}

// --- what a bar does on the way

// Returns whether the angles go on and on, within a turn.
static bool is_in_order(const YkPathProblem *p, const double *angle)
{
    double whole = angle[p->count - 1] - angle[0];
    for (size_t k = 1; k < p->count; k++)
        if (!((angle[k] - angle[k - 1]) * whole > 0)) return false;
    return p->is_timed || fabs(whole) <= 2 * YK_PI + 1e-6;
}

// Finds what can be told without the engine.
static YkDefect first_look(const Search *search, const YkPathTry *try, YkDesign *design)
{
    const YkPathProblem *p = &search->problem;
    const YkTask *task = p->task;
    YkDefect defect = YK_DEFECT_NONE;
    if (!yk_bar_design(&try->bar, try->angle[0], design)) return YK_DEFECT_ASSEMBLY;
    if (!task->any_order && !is_in_order(p, try->angle)) return YK_DEFECT_ORDER;
    if (p->turns && !yk_design_turns(design)) return YK_DEFECT_INPUT;
    defect = yk_design_bounds(design, task);
    for (size_t k = 1; k < p->count && defect == YK_DEFECT_NONE && p->kind == YK_DESIGN_FOUR_BAR; k++) {
        YkDesign then;
        if (!yk_bar_design(&try->bar, try->angle[k], &then)) return YK_DEFECT_ASSEMBLY;
        double angle[2][3];
        memcpy(angle[0], design->angle, sizeof angle[0]);
        memcpy(angle[1], then.angle, sizeof angle[1]);
        defect = yk_design_signs(design, angle, 2);
    }
    return defect;
}

// Gives a machine that is kept its angles.
static void keep(const Search *search, const YkPathTry *try, YkFound *found)
{
    size_t n = search->problem.count;
    double *angle = found ? YK_NEW(search->s->arena, double, n) : NULL;
    if (!angle) return;
    memcpy(angle, try->angle, n * sizeof *angle);
    found->angle = angle;
}

// Drives the machine on its file, and keeps or leaves it. Returns whether it passed.
static bool judge(Search *search, const YkPathTry *try)
{
    YkSynthesis *s = search->s;
    const YkPathProblem *p = &search->problem;
    YkDesign design;
    YkVerdict verdict = {.defect = YK_DEFECT_NONE};
    YkText text = {0};
    YkBarPoint at;
    YkVec *path = search->path;
    YkJourney journey = {.task = p->task, .input = try->angle, .count = p->count, .turns = p->turns, .exact = true};
    journey.point = p->point;
    journey.path = path;
    for (size_t k = 0; k < p->count; k++) path[k] = yk_bar_point(&try->bar, try->angle[k], &at) ? at.at : p->point[k];
    YkDefect defect = yk_bar_design(&try->bar, try->angle[0], &design) ? YK_DEFECT_NONE : YK_DEFECT_ASSEMBLY;
    if (defect == YK_DEFECT_NONE) defect = yk_synthesis_try(s, &design, &journey, &text, &verdict);
    double noise = (double)p->count * p->size * p->size * 1e-20; // among exact ones the transmission angle decides
    double merit = verdict.error > noise ? -verdict.error : verdict.transmission[0];
    if (defect == YK_DEFECT_NONE)
        keep(search, try, yk_synthesis_keep(s, &design, &text, &verdict, merit));
    else
        yk_synthesis_leave(s, &design, defect, &verdict);
    yk_text_free(&text);
    return defect == YK_DEFECT_NONE;
}

// --- the search

static void copy_try(const YkPathProblem *p, YkPathTry *to, const YkPathTry *from)
{
    double *angle = to->angle;
    memcpy(angle, from->angle, p->count * sizeof *angle);
    *to = *from;
    to->angle = angle;
}

// Puts a try among the first `*count` of a list, best first, at most `most`.
static void insert(const YkPathProblem *p, YkPathTry *list, size_t *count, size_t most, const YkPathTry *try)
{
    if (*count == most && !(try->cost < list[most - 1].cost)) return;
    size_t k = *count < most ? (*count)++ : most - 1;
    YkPathTry room = list[k];
    for (; k > 0 && try->cost < list[k - 1].cost; k--) list[k] = list[k - 1];
    list[k] = room;
    copy_try(p, &list[k], try);
}

static bool is_known(const Search *search, const YkPathTry *try)
{
    for (size_t k = 0; k < search->pooled; k++) {
        const YkPathTry *other = &search->pool[k];
        double apart = 0, size = search->problem.size;
        for (size_t j = 0; j < YK_BAR_SIZE; j++)
            apart = fmax(apart, j == YK_BAR_TURN ? 0 : fabs(other->bar.v[j] - try->bar.v[j]));
        if (other->bar.branch == try->bar.branch && apart < 1e-4 * (size + try->bar.v[YK_BAR_COUPLER])) return true;
    }
    return false;
}

// Brings the first angle into one turn about 0, and the ground's direction as well.
static void reduce(const YkPathProblem *p, YkPathTry *try)
{
    double turns = yk_remainder(try->angle[0], 2 * YK_PI) - try->angle[0];
    for (size_t k = 0; k < p->count && p->task->path.timing != YK_TIMING_ANGLES; k++) try->angle[k] += turns;
    if (p->low[YK_BAR_TURN] < p->high[YK_BAR_TURN])
        try->bar.v[YK_BAR_TURN] = yk_remainder(try->bar.v[YK_BAR_TURN], 2 * YK_PI);
}

// Improves a try to the end, and judges it where it is among the best.
static void finish(Search *search, YkPathTry *try)
{
    const YkPathProblem *p = &search->problem;
    YkDesign design;
    const double weight = search->work.weight;
    bool closes = yk_path_improve(p, &search->work, try, LAST_STEPS);
    if (closes && try->cost > try->error) { // limits that hold the bar back are then kept within their margin
        search->work.weight = HARD_WEIGHT;
        yk_path_improve(p, &search->work, try, LAST_STEPS);
        search->work.weight = weight;
    }
    if (!closes) return;
    reduce(p, try);
    YkDefect defect = first_look(search, try, &design);
    if (defect != YK_DEFECT_NONE) {
        YkVerdict verdict = {.defect = defect, .error = try->error};
        yk_synthesis_leave(search->s, &design, defect, &verdict);
        return;
    }
    try->cost = try->error;
    bool is_full = search->pooled == search->most && !(try->cost < search->pool[search->most - 1].cost);
    if (is_full || is_known(search, try) || !judge(search, try)) return;
    if (try->error <= 1e-24 * p->size * p->size) search->exact++;
    insert(p, search->pool, &search->pooled, search->most, try);
}

// Fills in the angles of all points from those of a part: as given, or evenly between neighbours.
static void fill_angles(const Search *search, const YkPathTry *part, YkPathTry *whole)
{
    const YkPathProblem *p = &search->problem, *c = &search->coarse;
    double last = part->angle[c->count - 1], turn = last < part->angle[0] ? -2 * YK_PI : 2 * YK_PI;
    double *angle = whole->angle;
    *whole = *part;
    whole->angle = angle;
    for (size_t k = 0; k < p->count; k++) {
        size_t i = k / search->stride, off = k % search->stride;
        double from = part->angle[i], to = i + 1 < c->count ? part->angle[i + 1] : part->angle[0] + turn;
        size_t gap = i + 1 < c->count ? search->stride : p->count - i * search->stride;
        angle[k] = from + (to - from) * (double)off / (double)gap;
        if (p->angle) angle[k] = p->angle[k];
        if (p->shifts) angle[k] = part->angle[0] + p->step * (double)k;
    }
}

static void run_batch(Search *search)
{
    const YkPathProblem *c = &search->coarse;
    YkPathTry *fresh = &search->try[HOPEFUL];
    size_t count = 0, best = 0;
    for (size_t k = 0; k < STARTS; k++)
        if (yk_path_draw(c, &search->work, &search->seed, fresh)) insert(c, search->try, &count, HOPEFUL, fresh);
    for (size_t k = 0; k < count; k++) {
        yk_path_improve(c, &search->work, &search->try[k], FIRST_STEPS);
        if (search->try[k].cost < search->try[best].cost) best = k;
    }
    if (count == 0) return;
    fill_angles(search, &search->try[best], &search->whole);
    finish(search, &search->whole);
}

// Returns the work of a batch, microseconds.
static size_t batch_work(const YkPathProblem *p)
{
    return 500 + 20 * p->count;
}

// Takes every so many points, so that some 16 remain. An open path keeps its last point only if it is one of them.
static bool choose_coarse(Search *search)
{
    const YkPathProblem *p = &search->problem;
    YkArena *arena = search->s->arena;
    size_t stride = p->count >= 2 * COARSE ? p->count / COARSE : 1, count = (p->count + stride - 1) / stride;
    YkVec *point = YK_NEW(arena, YkVec, count);
    double *angle = p->angle ? YK_NEW(arena, double, count) : NULL;
    search->coarse = *p;
    search->stride = stride;
    if (!point || (p->angle && !angle)) return false;
    for (size_t k = 0; k < count; k++) point[k] = p->point[k * stride];
    for (size_t k = 0; k < count && angle; k++) angle[k] = p->angle[k * stride];
    search->coarse.point = point;
    search->coarse.angle = angle;
    search->coarse.count = count;
    search->coarse.step = p->step * (double)stride;
    return true;
}

static bool make_room(Search *search)
{
    YkArena *arena = search->s->arena;
    size_t n = search->problem.count;
    bool good = choose_coarse(search) && yk_path_work(arena, n, &search->work);
    good &= (search->path = YK_NEW(arena, YkVec, n)) != NULL;
    good &= (search->whole.angle = YK_NEW(arena, double, n)) != NULL;
    for (size_t k = 0; k <= HOPEFUL; k++) good &= (search->try[k].angle = YK_NEW(arena, double, n)) != NULL;
    for (size_t k = 0; k < search->most; k++) good &= (search->pool[k].angle = YK_NEW(arena, double, n)) != NULL;
    return good;
}

// Returns whether so many bars pass the points to rounding that no other can be better.
static bool has_enough(const Search *search, size_t batches, size_t *first)
{
    const YkPathProblem *p = &search->problem;
    size_t conditions = p->is_timed ? 2 * p->count : p->count;
    if (conditions <= YK_PATH_UNKNOWNS) return search->exact >= EXACT;
    if (search->exact == 0) *first = batches;
    return search->exact > 0 && (search->exact >= EXACT_OF_MANY || batches > 2 * *first + MORE_BATCHES);
}

static void search_kind(YkSynthesis *s, YkDesignKind kind, double from, double to)
{
    Search *search = YK_NEW(s->arena, Search, 1);
    if (!search) return;
    search->s = s;
    search->seed = s->options.seed;
    size_t best = s->options.best > 0 ? s->options.best : s->task->best;
    search->most = best < POOL / 4 ? 4 * best : POOL;
    pose_problem(s->task, kind, &search->problem);
    if (!make_room(search)) return;
    yk_pace_stage(&s->pace, from, to);
    for (size_t k = 0, first = 0; k < BATCHES && !has_enough(search, k, &first); k++) {
        yk_pace_reach(&s->pace, (double)k / BATCHES);
        if (!yk_synthesis_goes_on(s, batch_work(&search->problem))) break;
        run_batch(search);
    }
}

bool yk_synthesise_path(YkSynthesis *s, YkProblems *problems)
{
    const YkPathTask *path = &s->task->path;
    (void)problems;
    if (path->has_four_bar) search_kind(s, YK_DESIGN_FOUR_BAR, 0, path->has_slider ? 0.5 : 1);
    if (path->has_slider) search_kind(s, YK_DESIGN_SLIDER_CRANK, path->has_four_bar ? 0.5 : 0, 1);
    return true;
}
