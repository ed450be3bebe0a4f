// A point through points: bars by random starts and least squares, each judged by the engine on its file.
#include <math.h>
#include <string.h>
#include "synthesis/paths/path_search.h"

// The search ends early when enough bars pass the points to rounding: where there are more points than
// a bar can be made to pass, few do, and all of them soon.
enum { EXACT = 60, EXACT_OF_MANY = 2, MORE_BATCHES = 40 };

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
static YkDefect first_look(const YkPathSearch *search, const YkPathTry *try, YkDesign *design)
{
    const YkPathProblem *p = &search->batches.problem;
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
static void keep(const YkPathSearch *search, const YkPathTry *try, YkFound *found)
{
    size_t n = search->batches.problem.count;
    double *angle = found ? YK_NEW(search->s->arena, double, n) : NULL;
    if (!angle) return;
    memcpy(angle, try->angle, n * sizeof *angle);
    found->angle = angle;
}

// Where several kinds compete, a machine 10 times as large as the path counts as one with twice the error.
static double burden(const YkPathSearch *search, const YkDesign *design)
{
    double size = yk_norm(yk_sub(design->pivot[1], design->pivot[0]));
    for (size_t k = 0; k < 4; k++) size = fmax(size, fabs(design->length[k]));
    for (size_t k = 0; k < 2; k++) size = fmax(size, design->dyad_length[k]);
    return search->kinds > 1 ? 1 + size / (10 * search->batches.problem.size) : 1;
}

// Drives the machine on its file, and keeps or leaves it. Returns whether it passed.
static bool judge(YkPathSearch *search, const YkPathTry *try)
{
    YkSynthesis *s = search->s;
    const YkPathProblem *p = &search->batches.problem;
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
    double merit = verdict.error > noise ? -verdict.error * burden(search, &design) : verdict.transmission[0];
    if (defect == YK_DEFECT_NONE)
        keep(search, try, yk_synthesis_keep(s, &design, &text, &verdict, merit));
    else
        yk_synthesis_leave(s, &design, defect, &verdict);
    yk_text_free(&text);
    return defect == YK_DEFECT_NONE;
}

// --- the search

static bool is_known(const YkPathSearch *search, const YkPathTry *try)
{
    for (size_t k = 0; k < search->pooled; k++) {
        const YkPathTry *other = &search->pool[k];
        double apart = 0, size = search->batches.problem.size;
        for (size_t j = 0; j < search->batches.problem.dimensions; j++)
            apart = fmax(apart, j == YK_BAR_TURN ? 0 : fabs(other->bar.v[j] - try->bar.v[j]));
        if (other->bar.branch == try->bar.branch && other->bar.bend == try->bar.bend &&
            other->bar.variant == try->bar.variant && apart < 1e-4 * (size + try->bar.v[YK_BAR_COUPLER]))
            return true;
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
    yk_path_turn_angles(p, try);
}

// Judges a try that was improved to the end, where it is among the best.
static void finish(YkPathSearch *search, YkPathTry *try)
{
    const YkPathProblem *p = &search->batches.problem;
    YkDesign design;
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
    yk_path_insert(p, search->pool, &search->pooled, search->most, try);
}

static bool make_room(YkPathSearch *search)
{
    YkArena *arena = search->s->arena;
    size_t n = search->batches.problem.count;
    bool good = (search->path = YK_NEW(arena, YkVec, n)) != NULL;
    good &= (search->numbers = YK_NEW(arena, double, yk_path_width(search->s->task))) != NULL;
    for (size_t k = 0; k < search->most; k++) good &= (search->pool[k].angle = YK_NEW(arena, double, n)) != NULL;
    return good;
}

// Returns whether enough bars pass the points to rounding, so that no other can be better.
static bool has_enough(const YkPathSearch *search, size_t batches, size_t *first)
{
    const YkPathProblem *p = &search->batches.problem;
    size_t conditions = p->is_timed ? 2 * p->count : p->count;
    if (conditions <= p->dimensions + 1) return search->exact >= EXACT || search->exact >= search->most;
    if (search->exact == 0) *first = batches;
    return search->exact > 0 &&
           (search->exact >= EXACT_OF_MANY || 4 * search->exact >= search->most || batches > 2 * *first + MORE_BATCHES);
}

// Finds what a batch leaves in `whole`, here or wherever its piece comes from. Returns whether there is anything.
static bool find_batch(YkPathSearch *search, size_t batch)
{
    if (!search->s->options.pieces.get) return yk_path_batch(&search->batches, batch);
    return yk_synthesis_fetch(search->s, search->first_piece + batch * search->kinds, search->numbers) &&
           yk_path_unpack(&search->batches, search->numbers);
}

static YkPathSearch *begin(YkSynthesis *s, YkDesignKind kind, size_t place, size_t kinds)
{
    YkPathSearch *search = YK_NEW(s->arena, YkPathSearch, 1);
    if (!search) return NULL;
    search->s = s;
    search->first_piece = yk_path_exact_pieces(s->task) + place;
    search->kinds = kinds;
    size_t best = s->options.best > 0 ? s->options.best : s->task->best;
    search->most = best < YK_PATH_POOL / 4 ? 4 * best : YK_PATH_POOL;
    bool good = yk_path_batches_new(s->arena, s->task, kind, s->options.seed, &search->batches) && make_room(search);
    return good ? search : NULL;
}

// Runs one batch of a kind. Returns false when the search is stopped. Machines with a dyad, whose batches take long,
// are sought only as long as no kind passes all points.
static bool go_on(YkPathSearch *search, size_t batch, bool *has_exact)
{
    bool is_chain = search->batches.problem.dimensions > YK_BAR_PLAIN;
    if (search->is_done || (is_chain && *has_exact) || batch >= yk_path_batch_count(search->batches.problem.kind))
        return true;
    search->is_done = has_enough(search, batch, &search->first);
    *has_exact |= search->is_done;
    if (search->is_done) return true;
    if (!yk_synthesis_goes_on(search->s, yk_path_batch_work(&search->batches))) return false;
    if (find_batch(search, batch)) finish(search, &search->batches.whole);
    return true;
}

// The kinds take turns, so that a search that is cut by time has looked at all of them.
bool yk_synthesise_path(YkSynthesis *s, YkProblems *problems)
{
    YkPathSearch *search[YK_DESIGN_KINDS];
    YkDesignKind kind[YK_DESIGN_KINDS];
    size_t kinds = yk_path_kinds(s->task, kind), sought = 0;
    bool is_exact = yk_path_is_exact(s->task), is_whole = is_exact && yk_synthesise_exact_path(s, 0.5);
    bool has_some = s->candidates.count > 0, has_exact = has_some;
    (void)problems;
    for (size_t i = 0; i < kinds; i++) {
        // Where no four-bar passes nine points without a defect, one that comes near them is better than none.
        if (has_some && kind[i] == YK_DESIGN_FOUR_BAR) continue;
        search[sought] = begin(s, kind[i], i, kinds);
        if (!search[sought++]) return true; // out of memory, which the arena remembers
    }
    if (is_exact) yk_pace_stage(&s->pace, 0.5, 1);
    for (size_t k = 0; k < YK_PATH_BATCHES && sought > 0; k++) {
        yk_pace_reach(&s->pace, (double)k / YK_PATH_BATCHES);
        for (size_t i = 0; i < sought; i++)
            if (!go_on(search[i], k, &has_exact)) return true;
    }
    s->is_complete = is_whole && sought == 0;
    return true;
}
