// Reads pieces in real unknowns, and finds their solutions at a pose.
#include "map/meshed.h"
#include <stdlib.h>
#include <string.h>
#include "solve/state.h"

// --- reading

// Returns whether a relation's law, if it has one, depends on inputs alone.
static bool is_law_known(const YkMechanism *mech, const YkRelation *r)
{
    for (uint32_t k = r->first_argument_source; k < r->first_argument_source + r->argument_source_count; k++)
        if (mech->sources[k].kind != YK_SOURCE_INPUT) return false;
    return !r->law || yk_law_bound(r->law).is_continuous;
}

static bool read_group(YkPiece *piece, const YkState *start)
{
    YkGeared *g = &piece->meshed->geared;
    YkRun run = yk_state_run((YkState *)(uintptr_t)start, &((YkState *)(uintptr_t)start)->space); // only read
    if (!yk_geared_read(g, &run, piece->block)) return false;
    if (g->relations == 0 || g->shape.unknowns != 2 * g->shape.loops + g->relations) return false;
    for (size_t r = 0; r < g->relations; r++) {
        if (!is_law_known(start->mech, &start->mech->relations[g->relation[r]])) return false;
        g->laws[r].law = NULL; // it is known, and stands in the phase
    }
    piece->shape = g->shape;
    piece->shape.relations = g->relations;
    piece->shape.whole = g->turning;
    return true;
}

// Finds the least number of times a gear's value that takes all angles that loops place whole times. 0: none is.
static int times_of(const YkMechanism *mech, const YkRelation *r)
{
    for (int times = 1; times <= 720; times++) {
        bool all = true;
        for (uint32_t k = r->first_source; k < r->first_source + r->source_count; k++) {
            double factor = times * mech->sources[k].factor;
            all &= mech->sources[k].kind != YK_SOURCE_SLOT || fabs(factor - rint(factor)) < 1e-9;
        }
        if (all) return times;
    }
    return 0;
}

// Reads a gear outside of groups. Its angle times as many turns as it needs is what is known, modulo 2 pi.
static bool read_gear(YkPiece *piece, const YkMechanism *mech)
{
    YkGeared *g = &piece->meshed->geared;
    const YkRelation *r = &mech->relations[piece->relation];
    int times = times_of(mech, r);
    if (r->target.is_distance || !is_law_known(mech, r) || times == 0) return false;
    for (uint32_t k = r->first_source; k < r->first_source + r->source_count; k++)
        if (mech->sources[k].kind == YK_SOURCE_COLUMN) return false;
    *g = (YkGeared){.relations = 1, .turning = 1, .size = mech->size};
    g->shape = piece->shape = (YkShape){.angles = 1, .unknowns = 1, .relations = 1, .whole = 1, .turning = {-1}};
    g->relation[0] = (size_t)piece->relation;
    g->factor[0][0] = times;
    g->share[0][0] = -times;
    piece->meshed->is_listed = true;
    return true;
}

bool yk_meshed_read(YkPiece *piece, const YkState *start, size_t step, bool *out_of_memory)
{
    const YkStep *own = &start->mech->steps[step];
    bool is_gear = own->kind == YK_STEP_RELATION;
    if (!is_gear && (own->kind != YK_STEP_BLOCK || start->mech->blocks[own->target].relation_count == 0)) return false;
    *piece = (YkPiece){.block = is_gear ? 0 : (size_t)own->target,
                       .step = step,
                       .relation = is_gear ? own->target : YK_NONE,
                       .meshed = calloc(1, sizeof *piece->meshed)};
    *out_of_memory |= !piece->meshed;
    if (piece->meshed && (is_gear ? read_gear(piece, start->mech) : read_group(piece, start))) return true;
    yk_meshed_free(piece->meshed);
    piece->meshed = NULL;
    return false;
}

void yk_meshed_free(YkMeshed *meshed)
{
    if (!meshed) return;
    yk_excluded_end(&meshed->found);
    free(meshed);
}

bool yk_meshed_repeats(const YkMeshed *m, const YkMechanism *mech, int32_t input, int turns)
{
    for (size_t row = 0; row < m->geared.relations; row++) {
        double way = 0;
        for (size_t r = 0; r < m->geared.relations; r++) {
            const YkRelation *own = &mech->relations[m->geared.relation[r]];
            for (uint32_t k = own->first_source; k < own->first_source + own->source_count; k++)
                if (mech->sources[k].kind == YK_SOURCE_INPUT && mech->sources[k].index == input)
                    way += m->geared.share[row][r] * mech->sources[k].factor;
        }
        if (row >= m->geared.turning ? way != 0 : fabs(way * turns - rint(way * turns)) > 1e-9) return false;
    }
    return true;
}

// --- at what is known

// Returns the angle of a unit vector, between -pi and pi.
static YkDual angle_of(YkDual z)
{
    YkBall rate = yk_ball_mul(z.rate, yk_ball(yk_conj(z.at.at), z.at.radius)); // i angle' = z' / z
    double radius = z.at.radius < 0.5 ? 1.3 * z.at.radius + 1e-15 : YK_PI;
    return (YkDual){yk_real_disc(yk_atan2(z.at.at.y, z.at.at.x), YK_BALL_OUT(radius)),
                    yk_real_disc(rate.at.y, rate.radius)};
}

// Returns all of a relation but what the unknowns of its group add.
static YkDual known_of(const YkDiscs *d, const YkRelation *r)
{
    YkDual sum = yk_dual_constant(yk_vec(r->offset, 0));
    for (uint32_t k = r->first_source; k < r->first_source + r->source_count; k++) {
        const YkRelationSource *s = &d->mech->sources[k];
        if (s->kind == YK_SOURCE_COLUMN) continue;
        YkDual value = s->kind == YK_SOURCE_INPUT  ? yk_discs_input(d, s->index)
                       : s->kind == YK_SOURCE_SLOT ? angle_of(d->slots[s->index])
                                                   : d->distances[s->index];
        sum = yk_dual_add(sum, yk_dual_times(yk_vec(s->factor, 0), value));
    }
    return r->law ? yk_dual_add(sum, yk_discs_law(d, r)) : sum;
}

void yk_meshed_row(const YkMeshed *m, const YkDiscs *d, size_t relation, YkDual *row)
{
    size_t n = m->geared.shape.unknowns;
    for (size_t k = 0; k < n; k++) row[k] = yk_dual_constant(yk_vec(m->geared.factor[relation][k], 0));
    row[n] = yk_dual_constant(yk_vec(0, 0));
    for (size_t r = 0; r < m->geared.relations; r++) {
        YkVec share = yk_vec(m->geared.share[relation][r], 0);
        if (share.x != 0)
            row[n] = yk_dual_add(row[n], yk_dual_times(share, known_of(d, &d->mech->relations[m->geared.relation[r]])));
    }
}

bool yk_meshed_take(YkMeshed *m, const YkDiscCoefficients *c)
{
    YkGeared *g = &m->geared;
    size_t half = yk_coefficient_count(&g->shape), n = g->shape.unknowns;
    memcpy(g->coefficients, c->at, 2 * half * sizeof *c->at);
    memcpy(g->radius, c->radius, 2 * half * sizeof *c->radius);
    for (size_t r = 0; r < g->relations; r++) {
        size_t at = 2 * half + r * (n + 1) + n;
        g->phase[r] = r < g->turning ? yk_nearest_turn(c->at[at].x, 0) : c->at[at].x;
        g->phase_radius[r] = c->radius[at];
    }
    return yk_geared_bound(g);
}

bool yk_meshed_solve(YkPiece *piece, const YkDiscCoefficients *c, YkPace *pace, bool *all)
{
    YkMeshed *m = piece->meshed;
    *all = yk_meshed_take(m, c);
    if (m->is_listed) return true;
    if (*all && !yk_exclude(&m->geared, pace, &m->found)) return false;
    *all = *all && m->found.is_complete && m->found.left == 0;
    return true;
}

size_t yk_meshed_count(const YkPiece *piece)
{
    return piece->meshed->is_listed ? (size_t)piece->meshed->geared.factor[0][0] : piece->meshed->found.count;
}

void yk_meshed_solution(const YkPiece *piece, size_t index, YkVec *x)
{
    const YkGeared *g = &piece->meshed->geared;
    if (piece->meshed->is_listed) {
        x[0] = yk_vec((2 * YK_PI * (double)index - g->phase[0]) / g->factor[0][0], 0);
        return;
    }
    const double *pose = piece->meshed->found.poses + index * g->shape.unknowns;
    for (size_t k = 0; k < g->shape.unknowns; k++)
        x[k] = yk_vec(pose[g->shape.column[k]] / (k < g->shape.angles ? 1 : g->size), 0);
}
