// Reads which parts of a machine can be followed, and keeps the memory that following needs.
#include <math.h>
#include <stdlib.h>
#include "base/problems.h"
#include "law/law.h"
#include "map/meshed.h"
#include "map/strand.h"

// --- what can be mapped

bool yk_map_refuse(YkProblems *problems, const char *what, const char *label)
{
    yk_problem(problems, YK_CODE_NO_MAP, (YkPlace){0}, "this machine cannot be mapped: %s%s%s%s", what,
               label ? " (joint `" : "", label ? label : "", label ? "`)" : "");
    return false;
}

static const char *reason_of(YkPieceStatus status)
{
    switch (status) {
    case YK_PIECE_REDUNDANT:
        return "some of its constraints repeat others";
    case YK_PIECE_RELATIONS:
        return "gears, belts, cams or laws are solved together with its loops";
    case YK_PIECE_LARGE:
        return "a group has more than seven loops";
    default:
        return "a distance of a group runs along more than one line";
    }
}

bool yk_tracer_read(YkTracer *t, YkProblems *problems)
{
    const YkMechanism *mech = t->mech;
    for (size_t k = 0; k < mech->step_count; k++) {
        const YkStep *step = &mech->steps[k];
        YkPiece *piece = &t->pieces[t->piece_count];
        if (step->kind != YK_STEP_BLOCK && yk_discs_can_take(mech, step)) continue;
        if (t->start && yk_meshed_read(piece, t->start, k, &t->out_of_memory)) {
            t->kept[t->piece_count++].shape = piece->shape;
            continue;
        }
        if (t->out_of_memory) return false;
        if (step->kind != YK_STEP_BLOCK)
            return yk_map_refuse(problems, "a cam, a law, or a rack is moved by links that loops place, or a law jumps",
                                 NULL);
        YkPieceStatus status = yk_piece_read(piece, mech, k);
        t->repeats |= status == YK_PIECE_REPEATED;
        if (status == YK_PIECE_REPEATED) continue;
        if (status != YK_PIECE_READ)
            return yk_map_refuse(problems, reason_of(status), mech->blocks[step->target].label);
        t->kept[t->piece_count].outside = YK_OUTSIDE_NOT;
        t->kept[t->piece_count++].shape = piece->shape;
    }
    return true;
}

// Returns whether a relation reads an input that makes whole turns: a mapped angle.
static bool makes_turns(const YkTracer *t, const YkRelationSource *s)
{
    if (s->kind != YK_SOURCE_INPUT || (s->index != t->discs.mapped && s->index != t->discs.second)) return false;
    for (size_t c = 0; c < t->mech->coordinate_count; c++)
        if (t->mech->coordinates[c].input == s->index) return !t->mech->coordinates[c].is_distance;
    return false;
}

// Returns whether a relation is the same after as many turns of the mapped inputs; but for its own value, if `by_law`.
static bool relation_repeats(const YkTracer *t, const YkRelation *r, int turns, bool by_law)
{
    const YkRelationSource *sources = t->mech->sources;
    double period = r->law ? yk_law_range(r->law).period : 0;
    bool repeats = true;
    for (uint32_t s = r->first_source; !by_law && s < r->first_source + r->source_count; s++) {
        double way = sources[s].factor * turns;
        if (makes_turns(t, &sources[s])) repeats &= !r->target.is_distance && fabs(way - rint(way)) < 1e-9;
    }
    for (uint32_t s = r->first_argument_source; r->law && s < r->first_argument_source + r->argument_source_count;
         s++) {
        double way = 2 * YK_PI * sources[s].factor * turns / period;
        if (makes_turns(t, &sources[s])) repeats &= period > 0 && fabs(way - rint(way)) < 1e-9;
    }
    return repeats;
}

static bool piece_repeats(const YkTracer *t, const YkMeshed *m, int turns)
{
    bool repeats = true;
    for (size_t r = 0; r < m->geared.relations; r++)
        repeats &= relation_repeats(t, &t->mech->relations[m->geared.relation[r]], turns, true);
    return repeats && (!t->is_angle || yk_meshed_repeats(m, t->mech, t->discs.mapped, turns));
}

double yk_tracer_period(const YkTracer *t)
{
    for (int turns = 1; turns <= 720; turns++) {
        bool repeats = true;
        for (size_t k = 0, p = 0; k < t->mech->step_count && repeats; k++) {
            while (p < t->piece_count && t->pieces[p].step < k) p++;
            if (p < t->piece_count && t->pieces[p].step == k && t->pieces[p].meshed)
                repeats = piece_repeats(t, t->pieces[p].meshed, turns);
            else if (t->mech->steps[k].kind == YK_STEP_RELATION)
                repeats = relation_repeats(t, &t->mech->relations[t->mech->steps[k].target], turns, false);
        }
        if (repeats) return 2 * YK_PI * turns;
    }
    return 0;
}

const char *yk_tracer_label(const YkTracer *t, size_t piece, const char **kind)
{
    *kind = "joint ";
    if (piece >= t->piece_count) return "?";
    if (t->pieces[piece].relation == YK_NONE) return t->mech->blocks[t->pieces[piece].block].label;
    *kind = "";
    return t->mech->relations[t->pieces[piece].relation].name;
}

double yk_tracer_reach(const YkMechanism *mech)
{
    double sum = mech->size;
    for (size_t k = 0; k < mech->term_count; k++)
        if (mech->terms[k].distance == YK_NONE) sum += yk_norm(mech->terms[k].v);
    for (size_t k = 0; k < mech->loop_count; k++) sum += yk_norm(mech->loops[k].sum.constant);
    return sum;
}

// --- room

bool yk_tracer_begin(YkTracer *t, const YkMechanism *mech)
{
    size_t blocks = mech->block_count + mech->relation_count + 1;
    YkArena *a = t->arena = yk_arena_new();
    t->mech = mech;
    t->pieces = yk_arena_alloc(a, blocks, sizeof *t->pieces);
    t->kept = yk_arena_alloc(a, blocks, sizeof *t->kept);
    t->solutions = yk_arena_alloc(a, blocks, sizeof *t->solutions);
    t->expected = yk_arena_alloc(a, blocks, sizeof *t->expected);
    t->chain = yk_arena_alloc(a, blocks, sizeof *t->chain);
    t->levels = yk_arena_alloc(a, blocks, sizeof *t->levels);
    t->ties = yk_arena_alloc(a, blocks, sizeof *t->ties);
    bool has_discs = yk_discs_start(&t->discs, mech);
    has_discs = yk_discs_start(&t->over, mech) && has_discs;
    return !yk_arena_failed(a) && has_discs;
}

void yk_tracer_end(YkTracer *t)
{
    for (size_t level = 0; t->levels && level <= t->piece_count; level++) {
        for (size_t k = 0; k < t->levels[level].count; k++) yk_strand_free(t->levels[level].items[k]);
        free(t->levels[level].items);
    }
    for (size_t level = 0; t->ties && level <= t->piece_count; level++) free(t->ties[level].items);
    for (size_t k = 0; t->kept && k < t->piece_count; k++) yk_group_kept_end(&t->kept[k]);
    for (size_t k = 0; t->solutions && k < t->piece_count; k++) yk_group_solutions_end(&t->solutions[k]);
    for (size_t k = 0; t->pieces && k < t->piece_count; k++) yk_meshed_free(t->pieces[k].meshed);
    yk_arena_free(t->arena);
    yk_discs_end(&t->discs);
    yk_discs_end(&t->over);
}
