// Reads which parts of a machine can be followed, and keeps the memory that following needs.
#include <math.h>
#include <stdlib.h>
#include "base/problems.h"
#include "law/law.h"
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
        if (step->kind != YK_STEP_BLOCK && !yk_discs_can_take(mech, step))
            return yk_map_refuse(problems, "a cam, a law, or a gear is moved by links that loops place, or a law jumps",
                                 NULL);
        if (step->kind != YK_STEP_BLOCK) continue;
        YkPiece *piece = &t->pieces[t->piece_count];
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

// Returns whether the argument of a relation's law moves by a whole number of periods when the inputs make this many turns.
static bool law_repeats(const YkMechanism *mech, const YkRelation *r, int turns)
{
    bool repeats = true;
    double period = r->law ? yk_law_range(r->law).period : 0;
    for (uint32_t s = r->first_argument_source; r->law && s < r->first_argument_source + r->argument_source_count;
         s++) {
        double way = 2 * YK_PI * mech->sources[s].factor * turns / period;
        if (mech->sources[s].kind == YK_SOURCE_INPUT) repeats &= period > 0 && fabs(way - rint(way)) < 1e-9;
    }
    return repeats;
}

double yk_tracer_period(const YkMechanism *mech)
{
    for (int turns = 1; turns <= 720; turns++) {
        bool repeats = true;
        for (size_t k = 0; k < mech->step_count; k++) {
            if (mech->steps[k].kind != YK_STEP_RELATION) continue;
            const YkRelation *r = &mech->relations[mech->steps[k].target];
            for (uint32_t s = r->first_source; s < r->first_source + r->source_count; s++) {
                double way = mech->sources[s].factor * turns;
                if (mech->sources[s].kind == YK_SOURCE_INPUT)
                    repeats &= !r->target.is_distance && fabs(way - rint(way)) < 1e-9;
            }
            repeats &= law_repeats(mech, r, turns);
        }
        if (repeats) return 2 * YK_PI * turns;
    }
    return 0;
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
    size_t blocks = mech->block_count + 1;
    t->mech = mech;
    t->pieces = calloc(blocks, sizeof *t->pieces);
    t->kept = calloc(blocks, sizeof *t->kept);
    t->solutions = calloc(blocks, sizeof *t->solutions);
    t->expected = calloc(blocks, sizeof *t->expected);
    t->chain = calloc(blocks, sizeof *t->chain);
    t->levels = calloc(blocks, sizeof *t->levels);
    t->ties = calloc(blocks, sizeof *t->ties);
    bool has_discs = yk_discs_start(&t->discs, mech);
    has_discs = yk_discs_start(&t->over, mech) && has_discs;
    return t->pieces && t->kept && t->solutions && t->expected && t->chain && t->levels && t->ties && has_discs;
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
    free(t->levels);
    free(t->ties);
    free(t->kept);
    free(t->solutions);
    free(t->pieces);
    free(t->expected);
    free(t->chain);
    yk_discs_end(&t->discs);
    yk_discs_end(&t->over);
}
