// Evaluates relations: over lanes, in groups, and the references of their angles.
#include "solve/relations.h"

// Inputs are only read.
static YkScalar input_of(const YkRun *run, int32_t input)
{
    const double *const *in = run->inputs + 3 * input;
    return (YkScalar){(double *)(uintptr_t)in[0], (double *)(uintptr_t)in[1], (double *)(uintptr_t)in[2]};
}

static YkScalar source_of(const YkRun *run, const YkRelationSource *s, double *angle)
{
    if (s->kind == YK_SOURCE_INPUT) return input_of(run, s->index);
    if (s->kind == YK_SOURCE_DISTANCE) {
        YkSlide d = yk_space_slide(run->space, s->index);
        return (YkScalar){d.d, d.v, d.a};
    }
    YkTurn t = yk_space_turn(run->space, s->index);
    yk_lanes_angle(angle, yk_space_turn(run->space, 0), t, 0, run->references[s->reference], run->lanes);
    return (YkScalar){angle, t.w, t.a};
}

static void hold_still(const YkRun *run, double value, YkScalar out)
{
    for (size_t k = 0; k < run->lanes; k++) {
        out.x[k] = value;
        out.v[k] = out.a[k] = 0;
    }
}

// Adds up sources, if there are any.
static void add_sources(const YkRun *run, uint32_t first, uint32_t count, double offset, YkScalar out, double *angle)
{
    size_t n = run->lanes;
    for (uint32_t k = first; k < first + count; k++) {
        const YkRelationSource *s = &run->mech->sources[k];
        yk_lanes_multiple(out, offset, k == first, s->factor, source_of(run, s, angle), n);
    }
}

// Adds gain * law(argument) to out, with the rates by the chain rule.
static void add_law(const YkRun *run, const YkRelation *r, YkScalar argument, YkScalar out, double *slope)
{
    enum { SOME = 96 };
    double value[SOME], first[SOME], second[SOME], *const d[] = {value, first, second};
    for (size_t at = 0; at < run->lanes; at += SOME) {
        size_t n = run->lanes - at < SOME ? run->lanes - at : SOME;
        YkScalar to = {out.x + at, out.v + at, out.a + at}, x = {argument.x + at, argument.v + at, argument.a + at};
        yk_law_eval_lanes(r->law, x.x, d, n);
        yk_lanes_add_law(to, r->offset, r->source_count == 0, r->gain, (const double *const *)d, x, slope + at, n);
    }
}

// Returns the argument of a law: a source itself if it is all, otherwise a sum in scratch lanes.
static YkScalar argument_of(const YkRun *run, const YkRelation *r, double *angle)
{
    YkPlane scratch = yk_space_scratch(run->space, YK_SCRATCH_ARM_1);
    YkScalar argument = {scratch.x, scratch.vx, scratch.ax};
    const YkRelationSource *first = &run->mech->sources[r->first_argument_source];
    if (r->argument_source_count == 1 && first->factor == 1 && r->argument_offset == 0)
        return source_of(run, first, angle);
    if (r->argument_source_count == 0) hold_still(run, r->argument_offset, argument);
    add_sources(run, r->first_argument_source, r->argument_source_count, r->argument_offset, argument, angle);
    return argument;
}

// Evaluates a relation's value with its rates.
static void evaluate(const YkRun *run, size_t index, YkScalar out)
{
    const YkRelation *r = &run->mech->relations[index];
    double *angle = yk_space_scratch(run->space, YK_SCRATCH_ARM_2).x;
    if (r->source_count == 0 && !r->law) hold_still(run, r->offset, out);
    add_sources(run, r->first_source, r->source_count, r->offset, out, angle);
    if (!r->law) return;
    add_law(run, r, argument_of(run, r, angle), out, run->space->gain + index * run->space->stride);
}

void yk_run_relation(const YkRun *run, size_t index)
{
    YkRelationTerm to = run->mech->relations[index].target;
    if (to.is_distance) {
        YkSlide target = yk_space_slide(run->space, to.index);
        evaluate(run, index, (YkScalar){target.d, target.v, target.a});
        return;
    }
    if (yk_run_is_idle(run, to.index)) return;
    YkTurn target = yk_run_turn(run, to.index);
    double *angle = yk_space_scratch(run->space, YK_SCRATCH_KNOWN).x;
    evaluate(run, index, (YkScalar){angle, target.w, target.a});
    yk_lanes_turn(target, yk_space_turn(run->space, 0), angle, target.w, target.a, 0, 1, run->lanes);
}

void yk_run_relation_check(const YkRun *run, size_t index)
{
    YkPlane out = yk_space_scratch(run->space, YK_SCRATCH_KNOWN);
    double *gap = run->space->gap;
    evaluate(run, index, (YkScalar){out.x, out.vx, out.ax});
    for (size_t k = 0; k < run->lanes; k++) gap[k] = fmax(gap[k], fabs(out.x[k]));
}

// --- in a group

// Returns a sum of sources in lane 0; adds the magnitudes of its parts to *scale.
static YkMotion sum_of(const YkRun *run, uint32_t first, uint32_t count, double offset, const double *x,
                       const double *rate, double *scale)
{
    YkMotion sum = {offset, 0, 0};
    for (uint32_t k = first; k < first + count; k++) {
        const YkRelationSource *s = &run->mech->sources[k];
        YkMotion m = {0, 0, 0};
        if (s->kind == YK_SOURCE_INPUT) {
            const double *const *in = run->inputs + 3 * s->index;
            m = (YkMotion){in[0][0], in[1][0], in[2][0]};
        } else if (s->kind == YK_SOURCE_DISTANCE) {
            YkSlide d = yk_space_slide(run->space, s->index);
            m = (YkMotion){d.d[0], d.v[0], d.a[0]};
        } else if (s->kind == YK_SOURCE_COLUMN) {
            m = (YkMotion){x[s->index], rate ? rate[s->index] : 0, 0};
        } else {
            YkTurn t = yk_space_turn(run->space, s->index);
            m = (YkMotion){0, t.w[0], t.a[0]};
            yk_lanes_angle(&m.position, yk_space_turn(run->space, 0), t, 0, run->references[s->reference], 1);
        }
        sum.position += s->factor * m.position;
        sum.velocity += s->factor * m.velocity;
        sum.acceleration += s->factor * m.acceleration;
        *scale += fabs(s->factor * m.position);
    }
    return sum;
}

YkRelationPose yk_relation_pose(const YkRun *run, size_t index, const double *x, const double *rate)
{
    const YkRelation *r = &run->mech->relations[index];
    YkRelationPose pose = {.scale = fabs(r->offset)};
    pose.value = sum_of(run, r->first_source, r->source_count, r->offset, x, rate, &pose.scale);
    if (!r->law) return pose;
    double d[YK_LAW_ORDER + 1], turned = 0;
    YkMotion a = sum_of(run, r->first_argument_source, r->argument_source_count, r->argument_offset, x, rate, &turned);
    yk_law_eval(r->law, a.position, d);
    pose.slope = r->gain * d[1];
    pose.argument = a.position;
    pose.scale += fabs(r->gain * d[0]) + fabs(pose.slope) * turned;
    pose.value.position += r->gain * d[0];
    pose.value.velocity += pose.slope * a.velocity;
    pose.value.acceleration += pose.slope * a.acceleration + r->gain * d[2] * a.velocity * a.velocity;
    return pose;
}

static void add_gradient(const YkMechanism *mech, uint32_t first, uint32_t count, double times, double *row)
{
    for (uint32_t k = first; k < first + count; k++)
        if (mech->sources[k].kind == YK_SOURCE_COLUMN) row[mech->sources[k].index] += times * mech->sources[k].factor;
}

void yk_relation_gradient(const YkMechanism *mech, size_t index, double slope, double *row)
{
    const YkRelation *r = &mech->relations[index];
    add_gradient(mech, r->first_source, r->source_count, 1, row);
    add_gradient(mech, r->first_argument_source, r->argument_source_count, slope, row);
}

// --- references

void yk_relations_refer(YkState *s, const YkSpace *space)
{
    for (size_t k = 0; k < s->mech->source_count; k++) {
        const YkRelationSource *source = &s->mech->sources[k];
        if (source->kind != YK_SOURCE_SLOT) continue;
        YkTurn t = yk_space_turn(space, source->index);
        double *reference = &s->slot_reference[source->reference];
        yk_lanes_angle(reference, yk_space_turn(space, 0), t, 0, *reference, 1);
    }
}

// Returns the angle of an orientation's body, with the coordinates' guesses added along the tree.
static double guessed_angle(const YkState *s, int32_t orientation)
{
    const YkMechanism *mech = s->mech;
    double sum = 0;
    for (int32_t b = mech->orientation_body[orientation]; mech->tree.parent[b] != YK_NONE; b = mech->tree.parent[b]) {
        const YkJoint *joint = &mech->model->joints[mech->tree.joint[b]];
        double way = joint->body[1] == b ? 1 : -1;
        int32_t c = yk_tree_coordinate(mech, mech->tree.joint[b], false);
        sum += way * (c == YK_NONE ? joint->turned : s->guess[c]);
    }
    return sum;
}

void yk_relations_guess(YkState *s)
{
    for (size_t k = 0; k < s->mech->source_count; k++) {
        const YkRelationSource *source = &s->mech->sources[k];
        if (source->kind != YK_SOURCE_SLOT || source->index >= (int32_t)s->mech->orientation_count) continue;
        s->slot_reference[source->reference] = guessed_angle(s, source->index);
    }
}
