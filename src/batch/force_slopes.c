// Derivatives of forces at a pose: brings its numbers to the tape, and hands their shares to the gradient.
#include <math.h>
#include "batch/lane_forces.h"
#include "compile/gradient.h"

// Makes the derivatives of the weighted sum of the channels by all leaves so far; NULL if there are none.
static YkRef *by_leaves(YkLaneForces *f, YkGraph *g, const YkRef *channel, size_t count)
{
    YkRef sum = yk_graph_number(g, 0), *by_leaf = YK_NEW(g->arena, YkRef, f->leaf_count + 1);
    f->by_count = f->leaf_count;
    for (size_t k = 0; k < count; k++) {
        YkRef weight = yk_lane_forces_leaf(f, g, YK_LEAF_OF_WEIGHT, k, 0);
        sum = yk_graph_add(g, sum, yk_graph_multiply(g, weight, channel[k]));
    }
    return by_leaf && yk_graph_adjoint(g, sum, f->leaves, f->by_count, by_leaf) ? by_leaf : NULL;
}

YkLaneForces *yk_force_slopes_new(const YkMechanism *mech, const YkChannel *channels, size_t channel_count, bool *fits)
{
    *fits = true;
    for (size_t k = 0; k < mech->relation_count + mech->derived_count; k++) *fits &= mech->relations[k].law == NULL;
    return *fits ? yk_lane_forces_make(mech, channels, channel_count, 1, by_leaves, fits) : NULL;
}

size_t yk_force_slopes_count(const YkLaneForces *f)
{
    return f->by_count;
}

static double number_of(const YkLeafSource *s, YkGradient *gradient, const YkSlopesAt *at)
{
    double value[6];
    if (s->kind == YK_LEAF_OF_TURN) yk_gradient_turn(gradient, s->index, value);
    if (s->kind == YK_LEAF_OF_SLIDE) yk_gradient_slide(gradient, s->index, value);
    if (s->kind == YK_LEAF_OF_NODE) yk_gradient_node(gradient, s->index, value);
    if (s->kind <= YK_LEAF_OF_NODE) return value[s->part];
    if (s->kind == YK_LEAF_OF_COORDINATE) return yk_gradient_angle(gradient, (size_t)s->index);
    if (s->kind == YK_LEAF_OF_INPUT) return at->inputs[3 * s->index + s->part];
    return s->kind == YK_LEAF_OF_WEIGHT ? at->weights[s->index] : at->time;
}

static void take(const YkLeafSource *s, YkGradient *gradient, double by)
{
    double share[6] = {0};
    share[s->part] = by;
    if (s->kind == YK_LEAF_OF_TURN) yk_gradient_take_turn(gradient, s->index, share);
    if (s->kind == YK_LEAF_OF_SLIDE) yk_gradient_take_slide(gradient, s->index, share);
    if (s->kind == YK_LEAF_OF_NODE) yk_gradient_take_node(gradient, s->index, share);
    if (s->kind == YK_LEAF_OF_COORDINATE) yk_gradient_take_angle(gradient, (size_t)s->index, by);
    if (s->kind == YK_LEAF_OF_PARAMETER) yk_gradient_take_parameter(gradient, s->index, by);
}

bool yk_force_slopes_take(YkLaneForces *f, YkGradient *gradient, const YkSlopesAt *at, double *by)
{
    for (const YkLeafSource *s = f->needed; s < f->needed + f->needed_count; s++)
        if (s->kind != YK_LEAF_OF_PARAMETER && s->one) *s->one = number_of(s, gradient, at);
    const double *const *slopes = yk_tape_run_one(f->tape, NULL);
    for (size_t k = 0; k < f->by_count; k++) {
        by[k] = *slopes[k];
        if (!isfinite(by[k])) return false;
        if (by[k] != 0) take(&f->sources[k], gradient, by[k]);
    }
    return true;
}
