// Runs one pose: every record of the space is read in place, and values pass between steps in registers.
#include "solve/single.h"
#include "base/memory.h"
#include "elementary/turn.h"
#include "solve/kernels/rpr.h"
#include "solve/kernels/rrp.h"
#include "solve/kernels/rrr.h"
#include "solve/kernels/term.h"
#include "solve/pose.h"

typedef struct Pose {
    const YkTerm *terms;
    Line *turn;   // [slot]
    Slide *slide; // [distance]
    Known *node;  // [node]
    double *margin, *block_margin;
} Pose;

static inline Pose pose_of(const YkRun *run)
{
    const YkSpace *s = run->space;
    return (Pose){run->mech->terms, pose_turns(s), pose_slides(s), pose_nodes(s), s->margin, s->block_margin};
}

// --- sums

YK_INLINE YkVec start_of(YkVec constant, const YkVec *plus, const YkVec *minus)
{
    YkVec sum = plus ? yk_add(constant, *plus) : constant;
    return minus ? yk_sub(sum, *minus) : sum;
}

YK_INLINE Known sum_nodes(const Pose *p, const YkSum *sum)
{
    const YkVec zero = {0, 0};
    const Known *plus = sum->plus == YK_NONE ? NULL : &p->node[sum->plus];
    const Known *minus = sum->minus == YK_NONE ? NULL : &p->node[sum->minus];
    if (!plus && !minus) return (Known){.place = sum->constant};
    return (Known){start_of(sum->constant, plus ? &plus->place : NULL, minus ? &minus->place : NULL),
                   start_of(zero, plus ? &plus->rate : NULL, minus ? &minus->rate : NULL),
                   start_of(zero, plus ? &plus->accel : NULL, minus ? &minus->accel : NULL)};
}

YK_INLINE Known turned(const Pose *p, const YkTerm *term)
{
    Line turn = p->turn[term->slot];
    return yk_is_axial(term->v) ? term_turned(turn, term->v, true) : term_turned(turn, term->v, false);
}

YK_INLINE Known sliding(const Pose *p, const YkTerm *term)
{
    Slide s = p->slide[term->distance];
    Line turn = p->turn[term->slot];
    return term->slot == 0 ? term_sliding(turn, false, term->v, s.d, s.v, s.a)
                           : term_sliding(turn, true, term->v, s.d, s.v, s.a);
}

YK_INLINE Known sum_of(const Pose *p, const YkSum *sum)
{
    const YkTerm *term = p->terms + sum->first, *end = term + sum->count;
    Known total;
    if (sum->plus == YK_NONE && sum->minus == YK_NONE && term < end && term->distance == YK_NONE) {
        total = term->slot == 0 ? (Known){.place = term->v} : turned(p, term);
        total.place = yk_add(sum->constant, total.place);
        term++;
    } else {
        total = sum_nodes(p, sum);
    }
    for (; term < end; term++) {
        Known one = term->distance == YK_NONE ? turned(p, term) : sliding(p, term);
        total = (Known){yk_add(total.place, one.place), yk_add(total.rate, one.rate), yk_add(total.accel, one.accel)};
    }
    return total;
}

// --- steps

YK_INLINE YkVec near_unit(double x)
{
    double s, c;
    sincos_near(x, &s, &c);
    return yk_vec(c, s);
}

YK_APART YkVec far_unit(double x)
{
    return yk_unit(x);
}

YK_INLINE void turn(const Pose *p, const YkStep *step, const double *const *in)
{
    double x = step->sign * (*in[0] + step->offset), w = step->sign * *in[1], a = step->sign * *in[2];
    YkVec e = sincos_is_far(sincos_far_bits(x)) ? far_unit(x) : near_unit(x);
    Line parent = p->turn[step->parent];
    p->turn[step->target] =
        step->parent == 0 ? (Line){e, w, a} : (Line){yk_mul(parent.e, e), parent.w + w, parent.a + a};
}

YK_INLINE void keep_margin(const Pose *p, size_t index, double margin, double witness)
{
    lane_margin(p->margin, p->block_margin ? p->block_margin + index : p->margin, 0, margin, witness);
}

YK_INLINE void keep_found(const Pose *p, const YkBlock *b, size_t index, Found found)
{
    p->turn[b->column[0].index] = (Line){found.e, found.rates.w, found.rates.turn_accel};
    p->slide[b->column[1].index] = (Slide){found.d, found.rates.v, found.rates.slide_accel};
    keep_margin(p, index, found.margin, found.e.x);
}

YK_INLINE void solve_rrr(const Pose *p, const YkBlock *b, size_t index, double branch, bool axial)
{
    const Known none = {{0, 0}, {0, 0}, {0, 0}}; // for constant arms only the lengths count
    RrrFound found = rrr_solve(true, sum_of(p, &b->known), none, false, none, false, b->pair, axial, false, branch);
    p->turn[b->column[0].index] = (Line){found.e1, found.rates.w1, found.rates.a1};
    p->turn[b->column[1].index] = (Line){found.e2, found.rates.w2, found.rates.a2};
    keep_margin(p, index, found.margin, found.e1.x);
}

YK_INLINE void solve_short_rrr(const Pose *p, const YkBlock *b, size_t index, double branch)
{
    const Known none = {{0, 0}, {0, 0}, {0, 0}}; // as above
    RrrFound found = rrr_solve(true, sum_of(p, &b->known), none, false, none, false, b->pair, false, true, branch);
    p->turn[b->column[0].index] = (Line){found.e1, found.rates.w1, found.rates.a1};
    p->turn[b->column[1].index] = (Line){found.e2, found.rates.w2, found.rates.a2};
    keep_margin(p, index, found.margin, found.e1.x);
}

YK_INLINE void solve_rrp(const Pose *p, const YkBlock *b, size_t index, double branch, bool turns, bool axial)
{
    Known W = {.place = b->aside->arm[0].constant};
    Line line = {.e = b->line[0]};
    if (turns) {
        Line by = p->turn[b->line_slot[0]];
        line = (Line){yk_mul(by.e, line.e), by.w, by.a};
    }
    Form form = {.places = true, .rates = true, .turns = turns, .axial = axial};
    keep_found(p, b, index, rrp_solve(form, sum_of(p, &b->known), W, b->circle, line, branch, 0));
}

YK_INLINE void solve_rpr(const Pose *p, const YkBlock *b, size_t index, double branch, bool axial)
{
    Known C = {.place = b->aside->arm[0].constant};
    Form form = {.places = true, .rates = true, .axial = axial};
    keep_found(p, b, index, rpr_solve(form, sum_of(p, &b->known), C, b->per_size2, (Line){.e = b->line[0]}, branch, 0));
}

YK_INLINE void solve_block(const YkRun *run, const Pose *p, const YkStep *step)
{
    size_t index = (size_t)step->target;
    const YkBlock *b = &run->mech->blocks[index];
    double branch = run->branch[index] < 0 ? -1 : 1;
    switch (b->form) {
    case YK_FORM_RRR:
        solve_rrr(p, b, index, branch, false);
        break;
    case YK_FORM_RRR_AXIAL:
        solve_rrr(p, b, index, branch, true);
        break;
    case YK_FORM_RRP:
        solve_rrp(p, b, index, branch, false, false);
        break;
    case YK_FORM_RRP_AXIAL:
        solve_rrp(p, b, index, branch, false, true);
        break;
    case YK_FORM_RRP_TURNING:
        solve_rrp(p, b, index, branch, true, false);
        break;
    case YK_FORM_RPR:
        solve_rpr(p, b, index, branch, false);
        break;
    case YK_FORM_RPR_AXIAL:
        solve_rpr(p, b, index, branch, true);
        break;
    case YK_FORM_RRR_SHORT:
        solve_short_rrr(p, b, index, branch);
        break;
    case YK_FORM_RARE:
        yk_run_lanes(run, step);
        break;
    }
}

void yk_run_single(const YkRun *run, size_t from, size_t to)
{
    const Pose p = pose_of(run);
    const YkStep *step = yk_from(run->mech->steps, from), *end = yk_from(run->mech->steps, to);
    for (; step < end; step++) {
        if (step->kind == YK_STEP_BLOCK)
            solve_block(run, &p, step);
        else if (step->kind == YK_STEP_TURN)
            turn(&p, step, run->inputs + 3 * step->input);
        else if (step->kind == YK_STEP_NODE)
            p.node[step->target] = sum_of(&p, &run->mech->node_sums[step->target]);
        else
            yk_run_lanes(run, step);
    }
}

void yk_run_single_sum(const YkRun *run, const YkSum *sum, YkPlane out)
{
    const Pose p = pose_of(run);
    Known total = sum_of(&p, sum);
    *out.x = total.place.x, *out.y = total.place.y;
    *out.vx = total.rate.x, *out.vy = total.rate.y;
    *out.ax = total.accel.x, *out.ay = total.accel.y;
}
