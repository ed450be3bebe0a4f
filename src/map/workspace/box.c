// Counts the configurations over boxes of two inputs, block by block.
#include "map/workspace/box.h"
#include <stdlib.h>
#include <string.h>
#include "map/workspace/dyad.h"
#include "map/workspace/polygon.h"

typedef struct Visit {
    YkTracer *tracer;
    int *counts;
    bool is_within_hull; // a dyad below is taken in pieces
    YkFold *fold;        // NULL: not asked for; its level is YK_NOT_FOUND until there is one
    YkGap *gap;          // likewise
} Visit;

static int count_from(Visit *v, size_t level);

// Counts on top of one solution of block `level`, which is no farther from x than `within`.
static int count_above(Visit *v, size_t level, const YkVec *x, double within)
{
    YkDual known[YK_PIECE_UNKNOWNS];
    const YkPiece *piece = &v->tracer->pieces[level];
    for (size_t k = 0; k < piece->shape.unknowns; k++) {
        known[k].at = yk_ball(x[k], YK_BALL_OUT(within * yk_piece_size(piece, x, k)));
        known[k].rate = yk_ball(yk_vec(0, 0), 0);
    }
    yk_discs_place(&v->tracer->discs, piece, known);
    return count_from(v, level + 1);
}

static void note(Visit *v, size_t level, int count)
{
    if (v->counts && count > 0) v->counts[level + 1] += count;
}

static void place(Visit *v, size_t level, const YkBall x[2])
{
    YkDual known[2];
    for (int k = 0; k < 2; k++) known[k] = (YkDual){x[k], yk_ball(yk_vec(0, 0), 0)};
    yk_discs_place(&v->tracer->discs, &v->tracer->pieces[level], known);
}

// Returns whether no solution of a dyad that may be there lets the blocks above it close.
static bool is_empty_above(Visit *v, size_t level, const YkDiscCoefficients *c)
{
    enum { PARTS = 32 };
    YkTracer *t = v->tracer;
    YkBall x[2];
    for (size_t part = 0; part < PARTS; part++) {
        if (!yk_dyad_hull(&t->pieces[level].shape, c, part, PARTS, x)) return false;
        place(v, level, x);
        if (count_from(v, level + 1) != 0) return false;
    }
    return true;
}

// If solutions meet here, the blocks above may still close with none of them.
static int unless_empty_above(Visit *v, size_t level, const YkDiscCoefficients *c)
{
    bool can_be = level + 1 < v->tracer->piece_count && !v->is_within_hull;
    v->is_within_hull = true;
    int *counts = v->counts;
    v->counts = NULL;
    bool is_empty = can_be && is_empty_above(v, level, c);
    if (can_be) v->is_within_hull = false;
    v->counts = counts;
    return is_empty ? 0 : YK_BOX_UNCLEAR;
}

// Notes a dyad that can fold, if its ends are nearer to each other than those of the one noted before.
static void note_fold(Visit *v, size_t level, const YkDiscCoefficients *c)
{
    const double rounding = 1e-13;
    if (v->tracer->pieces[level].shape.angles != 2) return;
    if (!(fabs(yk_norm(c->at[0]) - yk_norm(c->at[1])) < rounding)) return;
    if (v->fold->level != YK_NOT_FOUND && yk_norm(v->fold->apart) <= yk_norm(c->at[2])) return;
    *v->fold = (YkFold){level, c->at[2]};
}

static void note_gap(Visit *v, size_t level, const YkDiscCoefficients *c)
{
    const YkShape *shape = &v->tracer->pieces[level].shape;
    double gap = yk_dyad_gap(shape, c).at.at.x;
    if (shape->angles == 2 && yk_norm(c->at[2]) < 1e-6) return;
    if (v->gap->level != YK_NOT_FOUND && fabs(v->gap->value) <= fabs(gap)) return;
    *v->gap = (YkGap){level, gap};
}

// Returns the gap of the first dyad, with its derivative by one of the inputs.
static YkDual first_gap(YkTracer *t, const YkBall input[2], int by)
{
    YkDiscs *d = &t->discs;
    YkDiscCoefficients c;
    int32_t mapped = d->mapped, second = d->second;
    if (by == 1) d->mapped = second, d->second = mapped;
    d->input = input[by];
    d->second_input = input[1 - by];
    yk_trace_steps(t, d, 0);
    yk_piece_coefficients(&t->pieces[0], d, &c);
    d->mapped = mapped;
    d->second = second;
    d->input = input[0];
    d->second_input = input[1];
    return yk_dyad_gap(&t->pieces[0].shape, &c);
}

// Counts the solutions of a dyad by the gap in the middle of the box and its slopes over the box: near a place where
// they touch, that is sharper than bounds of the lengths. For the first dyad alone, whose coefficients depend on inputs
// only.
static int count_by_slopes(Visit *v, size_t level, const YkDiscCoefficients *c)
{
    YkTracer *t = v->tracer;
    const YkBall box[2] = {t->discs.input, t->discs.second_input};
    if (level > 0 || t->pieces[0].shape.angles == 0 || (box[0].radius == 0 && box[1].radius == 0)) return -1;
    const YkBall middle[2] = {yk_ball(box[0].at, 0), yk_ball(box[1].at, 0)};
    YkBall gap = first_gap(t, middle, 0).at;
    double first = yk_ball_most(yk_dyad_gap(&t->pieces[0].shape, c).rate), second = 0;
    if (t->discs.second != YK_NONE) second = yk_ball_most(first_gap(t, box, 1).rate);
    first_gap(t, box, 0); // as it was
    double off = YK_BALL_OUT(gap.radius + YK_BALL_OUT(first * box[0].radius) + YK_BALL_OUT(second * box[1].radius));
    return gap.at.x > off ? 2 : gap.at.x < -off ? 0 : -1;
}

static int count_dyad(Visit *v, size_t level, const YkDiscCoefficients *c)
{
    if (v->fold) note_fold(v, level, c);
    if (v->gap) note_gap(v, level, c);
    YkTracer *t = v->tracer;
    const YkShape *shape = &t->pieces[level].shape;
    YkBall x[2];
    int total = 0, count = yk_dyad_count(shape, c);
    if (count < 0) count = count_by_slopes(v, level, c);
    note(v, level, count);
    if (count < 0) return unless_empty_above(v, level, c);
    if (count == 0 || level + 1 == t->piece_count) return count;
    for (int k = 0; k < count; k++) {
        if (!yk_dyad_branch(shape, c, k == 0 ? 1 : -1, x)) return YK_BOX_UNCLEAR;
        place(v, level, x);
        int above = count_from(v, level + 1);
        if (above < 0) return above;
        total += above;
    }
    return total;
}

// Finds all solutions at the middle of the box, from those of the last box if that is enough.
static bool enumerate(YkTracer *t, size_t level, const YkVec *middle)
{
    YkGroupSolutions *all = &t->solutions[level];
    YkGroupStatus status = yk_group_solve_near(&t->kept[level], middle, t->mech->size, t->pace, all);
    t->out_of_memory |= status == YK_GROUP_NO_MEMORY;
    if (t->out_of_memory || yk_pace_is_stopped(t->pace) || !all->is_complete) return false;
    if (all->expected < t->expected[level]) return false; // some have gone to infinity just here
    // More than anywhere before: some were missed there.
    if (t->expected[level] > 0 && all->expected > t->expected[level]) yk_note_unproved(t, 0, level);
    t->expected[level] = all->expected;
    return true;
}

// Every complex solution continues over the whole box as a smooth function of both inputs.
static int count_group(Visit *v, size_t level, const YkDiscCoefficients *c)
{
    YkTracer *t = v->tracer;
    const YkPiece *piece = &t->pieces[level];
    if (yk_polygon_is_open(&piece->shape, c)) return 0;
    if (!enumerate(t, level, c->at)) return YK_BOX_UNCLEAR;
    const YkGroupSolutions *all = &t->solutions[level];
    size_t n = piece->shape.unknowns, real = 0;
    YkVec *x = malloc((all->proved_count * n + 1) * sizeof *x); // what lies above may solve this block again
    double *within = malloc((all->proved_count + 1) * sizeof *within);
    bool good = x && within;
    int total = 0;
    t->out_of_memory |= !good;
    for (size_t k = 0; k < all->proved_count && good; k++) {
        YkCertificate own;
        YkVec *at = x + real * n;
        memcpy(at, all->proved[k].x, n * sizeof *at);
        good = yk_pace_spend(t->pace, 12 * n * n * (n + 10)) && yk_enclose(&piece->shape, c->at, c->radius, at, &own);
        if (!good || all->proved[k].certificate.reality != YK_REAL) continue;
        within[real++] = own.within;
    }
    if (good) note(v, level, (int)real);
    if (level + 1 == t->piece_count) total = (int)real;
    for (size_t k = 0; k < real && good && level + 1 < t->piece_count; k++) {
        int above = count_above(v, level, x + k * n, within[k]);
        good = above >= 0;
        total += good ? above : 0;
    }
    free(x);
    free(within);
    return good ? total : YK_BOX_UNCLEAR;
}

static int count_from(Visit *v, size_t level)
{
    YkTracer *t = v->tracer;
    yk_trace_steps(t, &t->discs, level);
    if (level == t->piece_count) return 1;
    YkDiscCoefficients c;
    yk_piece_coefficients(&t->pieces[level], &t->discs, &c);
    return t->pieces[level].shape.loops == 1 ? count_dyad(v, level, &c) : count_group(v, level, &c);
}

static int visit(Visit *v, const double low[2], const double high[2])
{
    YkTracer *t = v->tracer;
    YkBall input[2];
    if (!yk_pace_spend(t->pace, 1000 * (t->piece_count + 1))) return YK_BOX_UNCLEAR;
    for (int k = 0; k < 2; k++) {
        double middle = low[k] + 0.5 * (high[k] - low[k]);
        input[k] =
            yk_ball(yk_vec(middle, 0), high[k] > low[k] ? YK_BALL_OUT(fmax(high[k] - middle, middle - low[k])) : 0);
    }
    t->discs.input = input[0];
    t->discs.second_input = input[1];
    return count_from(v, 0);
}

int yk_box_count(YkTracer *t, const double low[2], const double high[2], int *counts)
{
    Visit v = {t, counts, false, NULL, NULL};
    if (counts) memset(counts, 0, (t->piece_count + 1) * sizeof *counts);
    return visit(&v, low, high);
}

bool yk_box_fold(YkTracer *t, const double at[2], YkFold *fold)
{
    Visit v = {t, NULL, false, fold, NULL};
    fold->level = YK_NOT_FOUND;
    visit(&v, at, at);
    return fold->level != YK_NOT_FOUND;
}

bool yk_box_gap(YkTracer *t, const double at[2], YkGap *gap)
{
    Visit v = {t, NULL, false, NULL, gap};
    gap->level = YK_NOT_FOUND;
    visit(&v, at, at);
    return gap->level != YK_NOT_FOUND;
}

// --- memory

bool yk_box_remember(const YkTracer *t, YkBoxMemory *memory)
{
    bool good = true;
    for (size_t k = 0; k < t->piece_count && good; k++) {
        good = yk_generic_copy(&memory->generic[k], &t->kept[k].generic, &t->pieces[k].shape);
        memory->expected[k] = t->expected[k];
    }
    return good;
}

bool yk_box_recall(YkTracer *t, const YkBoxMemory *memory, const YkGroupSolutions *near)
{
    bool good = true;
    for (size_t k = 0; k < t->piece_count && good; k++) {
        const YkShape *shape = &t->pieces[k].shape;
        YkGeneric *own = &t->kept[k].generic;
        if (!yk_generics_are_same(own, &memory->generic[k], shape))
            good = yk_generic_copy(own, &memory->generic[k], shape);
        t->expected[k] = memory->expected[k];
        if (near)
            good = good && yk_group_solutions_copy(&t->solutions[k], &near[k], shape);
        else
            t->solutions[k].has_pose = false;
    }
    return good;
}

YkGroupSolutions *yk_box_near(YkTracer *t)
{
    bool has_groups = false, good = true;
    for (size_t k = 0; k < t->piece_count; k++) has_groups |= t->solutions[k].has_pose;
    if (!has_groups) return NULL;
    YkGroupSolutions *near = calloc(t->piece_count, sizeof *near);
    for (size_t k = 0; near && k < t->piece_count && good; k++)
        good = yk_group_solutions_copy(&near[k], &t->solutions[k], &t->pieces[k].shape);
    if (near && good) return near;
    yk_box_near_free(near, t->piece_count);
    t->out_of_memory = true;
    return NULL;
}

void yk_box_near_free(YkGroupSolutions *near, size_t piece_count)
{
    for (size_t k = 0; near && k < piece_count; k++) yk_group_solutions_end(&near[k]);
    free(near);
}

void yk_box_memory_end(YkBoxMemory *memory)
{
    for (size_t k = 0; k < YK_BOX_LEVELS; k++) yk_generic_free(&memory->generic[k]);
}
