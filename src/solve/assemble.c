// Searches the branches of all blocks for configurations that close.
#include "solve/assemble.h"
#include <string.h>
#include "compile/closure.h"
#include "solve/all_loops.h"
#include "solve/coincidence.h"
#include "solve/gap.h"
#include "solve/relations.h"

// Limits of the search: configurations seen; blocks opened before the first configuration was found, and after it
// (besides one for each block).
enum { LEAVES_MAX = 1 << 14, EACH_MAX = 4096, LISTED_MAX = 1 << 20, OPENED_BEFORE = 1 << 20, OPENED_AFTER = 1 << 16 };

// --- preparation

static bool has_branches(const YkBlock *b)
{
    return b->kind <= YK_BLOCK_RPR || b->kind == YK_BLOCK_GROUP;
}

// The level after which each slot and distance is known; level 0 means before any choice.
typedef struct Known {
    size_t *slot, *distance;
} Known;

static void learn_step(const YkMechanism *mech, const YkStep *step, size_t level, Known *known)
{
    if (step->kind == YK_STEP_TURN || step->kind == YK_STEP_COMPOSE) known->slot[step->target] = level;
    if (step->kind == YK_STEP_DISTANCE) known->distance[step->target] = level;
    if (step->kind == YK_STEP_RELATION) {
        YkRelationTerm t = mech->relations[step->target].target;
        (t.is_distance ? known->distance : known->slot)[t.index] = level;
    }
    if (step->kind != YK_STEP_BLOCK) return;
    const YkBlock *b = &mech->blocks[step->target];
    for (uint32_t k = 0; k < b->column_count; k++) {
        YkColumn c = b->kind == YK_BLOCK_GROUP ? mech->group_columns[b->first_column + k] : b->column[k];
        (c.is_distance ? known->distance : known->slot)[c.index] = level;
    }
}

static void cut_levels(YkSearch *search, const YkMechanism *mech, Known *known)
{
    search->first_step = mech->step_count;
    for (size_t k = 0; k < mech->step_count; k++) {
        const YkStep *step = &mech->steps[k];
        if (step->kind == YK_STEP_BLOCK && has_branches(&mech->blocks[step->target])) {
            if (search->level_count == 0)
                search->first_step = k;
            else
                search->levels[search->level_count - 1].to = k;
            search->levels[search->level_count++] = (YkLevel){.block = step->target, .from = k, .to = mech->step_count};
        }
        learn_step(mech, step, search->level_count, known);
    }
}

static size_t level_of(const YkMechanism *mech, const Known *known, size_t coordinate)
{
    const YkTreeCoordinate *c = &mech->coordinates[coordinate];
    if (c->is_distance) return known->distance[c->distance];
    YkJointAngle j = c->angle;
    return known->slot[j.a] > known->slot[j.b] ? known->slot[j.a] : known->slot[j.b];
}

// Sorts coordinates by level (counting sort).
static bool share_coordinates(YkSearch *search, const YkMechanism *mech, const Known *known, YkArena *arena)
{
    uint32_t *first = YK_NEW(arena, uint32_t, search->level_count + 2);
    if (!first) return false;
    for (size_t k = 0; k < mech->coordinate_count; k++) first[level_of(mech, known, k) + 1]++;
    for (size_t l = 0; l <= search->level_count; l++) first[l + 1] += first[l];
    for (size_t l = 1; l <= search->level_count; l++) {
        search->levels[l - 1].first_coordinate = first[l];
        search->levels[l - 1].coordinate_count = first[l + 1] - first[l];
    }
    for (size_t k = 0; k < mech->coordinate_count; k++)
        search->coordinates[first[level_of(mech, known, k)]++] = (int32_t)k;
    return true;
}

static size_t options_max(const YkMechanism *mech, const YkLevel *level)
{
    return mech->blocks[level->block].kind == YK_BLOCK_GROUP ? YK_GROUP_SOLUTIONS_MAX : 2;
}

static bool share_options(YkSearch *search, const YkMechanism *mech, YkArena *arena)
{
    size_t total = 0;
    for (size_t l = 0; l < search->level_count; l++) total += options_max(mech, &search->levels[l]);
    double *solutions = YK_NEW(arena, double, mech->column_count *YK_GROUP_SOLUTIONS_MAX);
    double *costs = YK_NEW(arena, double, total);
    uint16_t *orders = YK_NEW(arena, uint16_t, total);
    if (!solutions || !costs || !orders) return false;
    for (size_t l = 0; l < search->level_count; l++) {
        YkLevel *level = &search->levels[l];
        level->own = level->room = (YkOptionRoom){solutions, costs, orders};
        costs += options_max(mech, level);
        orders += options_max(mech, level);
        if (mech->blocks[level->block].kind == YK_BLOCK_GROUP)
            solutions += mech->blocks[level->block].column_count * YK_GROUP_SOLUTIONS_MAX;
    }
    return true;
}

YkSearch *yk_search_new(const YkMechanism *mech, YkArena *arena)
{
    YkSearch *search = YK_NEW(arena, YkSearch, 1);
    if (!search) return NULL;
    Known known = {YK_NEW(arena, size_t, mech->slot_count), YK_NEW(arena, size_t, mech->distance_count)};
    size_t choices = 0;
    for (size_t b = 0; b < mech->block_count; b++) choices += has_branches(&mech->blocks[b]);
    search->levels = YK_NEW(arena, YkLevel, choices);
    search->coordinates = YK_NEW(arena, int32_t, mech->coordinate_count);
    search->best_branch = YK_NEW(arena, signed char, mech->block_count);
    search->kept_branch = YK_NEW(arena, signed char, 2 * mech->block_count);
    search->best_x = YK_NEW(arena, double, mech->column_count);
    search->kept_x = YK_NEW(arena, double, mech->column_count);
    search->kept_reference = YK_NEW(arena, double, mech->reference_count);
    search->path = YK_NEW(arena, double, 2 * mech->input_count);
    search->variables = YK_NEW(arena, double, yk_variable_count(mech));
    search->wanted = YK_NEW(arena, double, 3 * mech->input_count);
    if (yk_arena_failed(arena) || !yk_space_start(&search->kept, mech, 1, true)) return NULL;
    cut_levels(search, mech, &known);
    if (share_coordinates(search, mech, &known, arena) && share_options(search, mech, arena)) return search;
    yk_search_end(search);
    return NULL;
}

void yk_search_end(YkSearch *search)
{
    if (search) yk_space_end(&search->kept);
}

// --- searching

// Returns what a coordinate adds to the distance from the guesses. Coordinates without a guess only break ties.
static double coordinate_cost(const YkState *s, size_t k)
{
    const YkTreeCoordinate *c = &s->mech->coordinates[k];
    if (c->input != YK_NONE) return 0;
    double q = yk_coordinate_in(s, &s->spare, k).position, off = q - s->guess[k];
    off = yk_gap(s->mech, c->is_distance, off);
    return (s->is_guessed[k] ? 1 : 1e-8) * off * off;
}

static void choose(YkState *s, const YkLevel *level, size_t option)
{
    const YkBlock *b = &s->mech->blocks[level->block];
    if (b->kind != YK_BLOCK_GROUP) {
        s->branch[level->block] = option == 0 ? 1 : -1;
        return;
    }
    memcpy(s->groups.x + b->first_column, level->room.solutions + option * b->column_count,
           b->column_count * sizeof(double));
    s->branch[level->block] = 0; // its sign is taken once it is solved
}

// Returns the guessed orientations.
static const YkTurn *guessed_turns(YkState *s)
{
    double *variables = s->search->variables;
    yk_closure_guess(s->mech, s->guess, variables);
    for (size_t k = 1; k < s->mech->orientation_count; k++) {
        YkVec e = yk_unit(variables[k - 1]);
        YkTurn t = yk_space_turn(&s->search->kept, (int32_t)k);
        *t.c = e.x, *t.s = e.y;
    }
    return s->search->kept.turn;
}

// Runs steps and judges them. At a coincidence, angles that no loop determines keep their guesses.
static YkStatus run_and_judge(YkState *s, size_t from, size_t to)
{
    if (!yk_state_spend(s, to - from)) return YK_STOPPED;
    YkRun run = yk_state_run(s, &s->spare);
    yk_run_begin(&run);
    yk_run_steps(&run, from, to);
    YkStatus status = yk_state_judge(s, &s->spare);
    bool may = false;
    for (size_t k = from; (status < 0 || status == YK_SINGULAR) && k < to && !may; k++) {
        const YkStep *step = &s->mech->steps[k];
        may = step->kind == YK_STEP_BLOCK && s->mech->blocks[step->target].kind <= YK_BLOCK_RPR &&
              yk_may_coincide(s->spare.block_margin[step->target]);
    }
    YkLister *lister = s->search->lister;
    if (!may || (s->mech->has_groups && !(lister && lister->list))) return status;
    if (!yk_run_settled(&run, from, to, guessed_turns(s))) return status;
    if (lister) lister->settled++;
    return yk_state_judge(s, &s->spare);
}

// Runs a level with one option; returns the cost of what becomes known, or infinity if it does not close.
static double run_option(YkState *s, YkLevel *level, size_t option)
{
    YkRun run = yk_state_run(s, &s->spare);
    choose(s, level, option);
    if (run_and_judge(s, level->from, level->to) < 0) return INFINITY;
    if (s->mech->blocks[level->block].kind == YK_BLOCK_GROUP)
        s->branch[level->block] = (signed char)yk_group_sign(&run, (size_t)level->block);
    double cost = 0;
    for (uint32_t k = 0; k < level->coordinate_count; k++)
        cost += coordinate_cost(s, (size_t)s->search->coordinates[level->first_coordinate + k]);
    return cost;
}

static void count_options(YkState *s, YkLevel *level)
{
    const YkBlock *b = &s->mech->blocks[level->block];
    level->options = 2;
    level->room = level->own;
    if (b->kind != YK_BLOCK_GROUP) return;
    YkRun run = yk_state_run(s, &s->spare);
    YkLister *lister = s->search->lister;
    if (lister && lister->list) {
        level->options = (uint32_t)lister->list(lister->context, &run, (size_t)level->block, &level->room);
        return;
    }
    level->options = (uint32_t)yk_group_search(&run, (size_t)level->block);
    if (level->options == 0) s->search->gave_up_at = level->block; // searched, not enumerated
    memcpy(level->room.solutions, s->groups.solutions, level->options * b->column_count * sizeof(double));
}

// Reads the unknowns of a dyad into x. Returns whether they are those that it had and the pose is a dead point, where
// both branches are one. They are not where the ends of two equal arms all but meet.
static bool is_singular_twin(const YkState *s, const YkBlock *b, YkVec x[2])
{
    const double same = 1e-4;
    double gap = 0;
    for (int k = 0; k < 2; k++) {
        YkVec before = x[k];
        YkTurn t = yk_space_turn(&s->spare, b->column[k].is_distance ? 0 : b->column[k].index);
        x[k] = b->column[k].is_distance ? yk_vec(*yk_space_slide(&s->spare, b->column[k].index).d / s->mech->size, 0)
                                        : yk_vec(*t.c, *t.s);
        gap = fmax(gap, yk_norm(yk_sub(x[k], before)));
    }
    return s->spare.margin[0] <= YK_SINGULAR_MARGIN && gap < same;
}

// Tries all options of a level. Sorts them by cost if `nearest`; drops those that do not close.
static void open_level(YkState *s, YkLevel *level, double before, bool nearest)
{
    size_t closing = 0, options;
    const YkBlock *b = &s->mech->blocks[level->block];
    YkLister *lister = b->kind == YK_BLOCK_GROUP ? s->search->lister : NULL;
    YkVec x[2] = {{INFINITY, 0}, {INFINITY, 0}};
    level->before = before;
    level->tried = 0;
    count_options(s, level);
    options = level->options;
    double *costs = level->room.cost;
    uint16_t *order = level->room.order;
    for (size_t o = 0; o < options; o++) {
        costs[o] = run_option(s, level, o);
        if (!(costs[o] < INFINITY)) {
            if (lister && !(s->spare.block_margin[level->block] >= YK_LIMIT_MARGIN)) lister->lost++;
            continue;
        }
        if (b->kind != YK_BLOCK_GROUP && is_singular_twin(s, b, x)) continue;
        size_t place = closing++;
        for (; nearest && place > 0 && costs[order[place - 1]] > costs[o]; place--) order[place] = order[place - 1];
        order[place] = (uint16_t)o;
    }
    level->options = (uint32_t)closing;
}

typedef bool (*Leaf)(void *context, YkState *state, double cost);

// Searches depth first; `bound` (may be NULL) is the best cost so far. Returns false when a leaf stopped it or a cap
// was reached. With up to about 14 blocks of two branches it sees everything; in longer machines the first
// configuration takes the nearest branch of each block in turn.
static bool search(YkState *s, bool nearest, const double *bound, Leaf leaf, void *context, size_t cap)
{
    YkSearch *q = s->search;
    size_t depth = 0, leaves = 0, opened = 0;
    YkRun run = yk_state_run(s, &s->spare);
    s->groups.global = true;
    q->gave_up_at = -1;
    yk_run_begin(&run);
    yk_run_steps(&run, 0, q->first_step);
    if (yk_state_judge(s, &s->spare) < 0) return true;
    if (q->level_count == 0) return leaf(context, s, 0);
    open_level(s, &q->levels[0], 0, nearest);
    while (!yk_state_is_stopped(s)) {
        YkLevel *level = &q->levels[depth];
        size_t next = level->tried;
        double cost = next < level->options ? level->before + level->room.cost[level->room.order[next]] : INFINITY;
        if (next >= level->options || (bound && cost >= *bound)) {
            if (depth-- == 0) return true;
            continue;
        }
        level->tried++;
        run_option(s, level, level->room.order[next]);
        if (yk_state_is_stopped(s)) return false; // it was not run
        if (depth + 1 < q->level_count) {
            if (++opened > q->level_count + (leaves > 0 && cap < LISTED_MAX ? OPENED_AFTER : OPENED_BEFORE)) {
                q->gave_up_at = level->block;
                return false;
            }
            open_level(s, &q->levels[++depth], cost, nearest);
            continue;
        }
        if (!leaf(context, s, cost) || ++leaves >= cap) return false;
    }
    return false;
}

// --- the nearest

typedef struct Best {
    double cost;
    bool found;
} Best;

static bool keep_best(void *context, YkState *s, double cost)
{
    Best *best = context;
    if (best->found && cost >= best->cost) return true;
    *best = (Best){cost, true};
    memcpy(s->search->best_branch, s->branch, s->mech->block_count);
    if (s->mech->column_count > 0) memcpy(s->search->best_x, s->groups.x, s->mech->column_count * sizeof(double));
    return true;
}

static void guess_groups(YkState *s)
{
    size_t o = s->mech->orientation_count;
    double *variables = s->search->variables;
    yk_closure_guess(s->mech, s->guess, variables);
    for (size_t k = 0; k < s->mech->column_count; k++) {
        YkColumn c = s->mech->group_columns[k];
        s->groups.x[k] = c.is_distance ? variables[o - 1 + (size_t)c.index] : variables[c.index - 1];
    }
}

// Runs everything with the present branches; groups start from the solution in groups.x.
static YkStatus run_whole(YkState *s)
{
    s->groups.global = true;
    return run_and_judge(s, 0, s->mech->step_count);
}

static YkStatus take(YkState *s, const signed char *branch, const double *x)
{
    memcpy(s->branch, branch, s->mech->block_count);
    if (s->mech->column_count > 0) memcpy(s->groups.x, x, s->mech->column_count * sizeof(double));
    YkStatus status = yk_state_by_all_loops(s, &s->spare, run_whole(s));
    yk_state_tell(s, &s->spare, status);
    if (status >= 0) yk_state_accept(s);
    return status;
}

static YkStatus assemble(YkState *s)
{
    Best best = {INFINITY, false};
    yk_relations_guess(s);
    if (s->mech->has_groups) guess_groups(s);
    s->groups.at_guess = s->mech->has_groups;
    search(s, true, &best.cost, keep_best, &best, LEAVES_MAX);
    if (!best.found && s->groups.at_guess) { // another solution of a group may fit where that at the guess does not
        s->groups.at_guess = false;
        search(s, true, &best.cost, keep_best, &best, LEAVES_MAX);
    }
    s->groups.at_guess = false;
    if (!best.found) {
        YkStatus status = s->search->gave_up_at >= 0 ? YK_NOT_CONVERGED : YK_NO_ASSEMBLY;
        yk_state_tell(s, &s->spare, status);
        return status;
    }
    memcpy(s->reference, s->guess, s->mech->coordinate_count * sizeof *s->reference);
    YkStatus status = take(s, s->search->best_branch, s->search->best_x);
    if (status >= 0) yk_state_refer(s);
    return status;
}

YkStatus yk_state_assemble(YkState *s)
{
    bool is_own = yk_state_begin(s);
    return yk_state_end(s, is_own, assemble(s));
}

// --- all

typedef struct Each {
    bool (*visit)(void *, YkState *);
    void *context;
    size_t count;
    bool stopped;
} Each;

// Gathers the margin of all blocks: the search ran them level by level.
static void gather_margin(const YkState *s, YkSpace *space)
{
    space->margin[0] = 1;
    for (size_t b = 0; b < s->mech->block_count; b++) {
        YkBlockKind kind = s->mech->blocks[b].kind;
        if (kind == YK_BLOCK_LINK || kind == YK_BLOCK_CHECK) continue;
        space->margin[0] = fmin(space->margin[0], space->block_margin[b]);
    }
}

// Shows the configuration in `spare` as the state's pose, then restores the pose.
static bool show(void *context, YkState *s, double cost)
{
    Each *each = context;
    YkSpace pose = s->space;
    bool has_pose = s->has_pose, has_rates = s->has_rates, is_regular = s->is_regular, is_kept = s->is_kept;
    if (!yk_state_spend(s, s->mech->block_count / 8)) return false;
    YkReport report = s->report;
    (void)cost;
    s->space = s->spare;
    s->has_pose = true;
    gather_margin(s, &s->space);
    YkStatus status = yk_state_by_all_loops(s, &s->space, yk_state_judge(s, &s->space));
    yk_state_tell(s, &s->space, status);
    s->has_rates = status != YK_SINGULAR;
    each->count++;
    size_t bytes = s->mech->column_count * sizeof(double);
    if (bytes > 0) memcpy(s->search->kept_x, s->valid_x, bytes);
    if (bytes > 0) memcpy(s->valid_x, s->groups.x, bytes); // a copy of the state continues from this configuration
    bool is_polished = s->is_regular;
    each->stopped = !each->visit(each->context, s);
    if (bytes > 0) memcpy(s->valid_x, s->search->kept_x, bytes);
    s->spare = s->space;
    s->space = pose;
    s->has_pose = has_pose;
    s->has_rates = has_rates;
    s->report = report;
    s->is_regular = is_regular;
    s->is_kept = is_kept;
    if (is_polished && !each->stopped) run_whole(s); // the search goes on from the branches' own pose
    return !each->stopped;
}

YkStatus yk_search_each(YkState *s, YkLister *lister, bool (*visit)(void *, YkState *), void *context, bool *all)
{
    Each each = {visit, context, 0, false};
    bool is_own = yk_state_begin(s);
    size_t bytes = s->mech->column_count * sizeof(double), inputs = 3 * s->mech->input_count * sizeof(double);
    memcpy(s->search->wanted, s->valid_input, inputs); // the shown poses have the present inputs
    memcpy(s->valid_input, s->input, inputs);
    memcpy(s->search->best_branch, s->branch, s->mech->block_count);
    if (bytes > 0) memcpy(s->search->best_x, s->groups.x, bytes);
    s->search->lister = lister;
    bool whole = search(s, false, NULL, show, &each, lister && lister->list ? LISTED_MAX : EACH_MAX);
    s->search->lister = NULL;
    memcpy(s->branch, s->search->best_branch, s->mech->block_count);
    memcpy(s->valid_input, s->search->wanted, inputs);
    if (bytes > 0) memcpy(s->groups.x, s->search->best_x, bytes);
    if (all) *all = whole || each.stopped;
    return yk_state_end(s, is_own, each.count > 0 ? YK_OK : YK_NO_ASSEMBLY);
}

YkStatus yk_state_each(YkState *s, bool (*visit)(void *, YkState *), void *context, bool *complete)
{
    bool all;
    YkLister lister = {0}; // counts alone
    YkStatus status = yk_search_each(s, &lister, visit, context, &all);
    if (complete) *complete = all && !s->mech->has_groups && lister.settled == 0;
    return status;
}
