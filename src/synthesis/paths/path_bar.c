// The coupler point P = A0 + a e^(i theta) + p e^(i phi) of a four-bar or slider-crank, with exact derivatives.
//
// Four-bar: with D from A to B0, |b e^(i phi) - D| = c fixes phi on each branch. Slider-crank: the distance of B from
// the line through A0 is fixed. Both conditions are linear in the derivative of phi, which is singular only at dead
// points.
#include <math.h>
#include "synthesis/paths/path_chain.h"

size_t yk_bar_size(YkDesignKind kind)
{
    return yk_chain_variants(kind) > 0 ? YK_BAR_SIZE : YK_BAR_PLAIN;
}

bool yk_bar_is_length(YkDesignKind kind, int index)
{
    switch (index) {
    case YK_BAR_INPUT:
        return true;
    case YK_BAR_GROUND:
        return kind != YK_DESIGN_SLIDER_CRANK;
    case YK_BAR_COUPLER:
        return kind != YK_DESIGN_INVERTED && kind != YK_DESIGN_GEARED;
    case YK_BAR_OUTPUT:
        return kind != YK_DESIGN_SLIDER_CRANK && kind != YK_DESIGN_INVERTED;
    case YK_BAR_LINK:
    case YK_BAR_ARM:
        return yk_bar_size(kind) > YK_BAR_PLAIN;
    default:
        return false;
    }
}

bool yk_bar_has_loop(YkDesignKind kind)
{
    return kind == YK_DESIGN_FOUR_BAR || kind == YK_DESIGN_WATT || kind == YK_DESIGN_STEPHENSON;
}

// From the moving joint A to the output's fixed pivot.
static YkVec across(const YkBar *bar, YkVec ground, YkVec crank)
{
    return yk_sub(yk_scale(bar->v[YK_BAR_GROUND], ground), yk_scale(bar->v[YK_BAR_INPUT], crank));
}

static bool close_four_bar(const YkBar *bar, YkVec D, YkVec *along)
{
    double b = bar->v[YK_BAR_COUPLER], c = bar->v[YK_BAR_OUTPUT], d2 = yk_dot(D, D), d = sqrt(d2);
    double cosine = (d2 + b * b - c * c) / (2 * b * d), rest = 1 - cosine * cosine;
    if (!(rest > 0)) return false;
    *along = yk_mul(yk_scale(1 / d, D), yk_vec(cosine, bar->branch * sqrt(rest)));
    return true;
}

static bool close_slider(const YkBar *bar, YkVec line, YkVec crank, YkVec *along)
{
    double b = bar->v[YK_BAR_COUPLER];
    double sine = (bar->v[YK_BAR_GROUND] - bar->v[YK_BAR_INPUT] * yk_cross(line, crank)) / b, rest = 1 - sine * sine;
    if (!(rest > 0)) return false;
    *along = yk_mul(line, yk_vec(bar->branch * sqrt(rest), sine));
    return true;
}

// Inverted slider-crank: the coupler's line passes the output pivot at a given distance; D = s u + e i u.
static bool close_inverted(const YkBar *bar, YkVec D, YkVec *along)
{
    double e = bar->v[YK_BAR_OUTPUT], d2 = yk_dot(D, D), rest = d2 - e * e;
    if (!(rest > 1e-12 * d2)) return false;
    *along = yk_mul(yk_scale(1 / d2, D), yk_vec(bar->branch * sqrt(rest), -e));
    return true;
}

static bool close_up(const YkBar *bar, YkVec ground, YkVec crank, YkVec *along)
{
    if (bar->kind == YK_DESIGN_INVERTED) return close_inverted(bar, across(bar, ground, crank), along);
    if (bar->kind == YK_DESIGN_SLIDER_CRANK) return close_slider(bar, ground, crank, along);
    return close_four_bar(bar, across(bar, ground, crank), along);
}

bool yk_bar_frame(const YkBar *bar, double input, YkVec *origin, YkVec *along)
{
    if (yk_bar_size(bar->kind) > YK_BAR_PLAIN) return yk_chain_frame(bar, input, origin, along);
    YkVec crank = yk_unit(input);
    *origin = yk_scale(bar->v[YK_BAR_INPUT], crank);
    return close_up(bar, yk_unit(bar->v[YK_BAR_TURN]), crank, along);
}

// How the coupler's angle changes: by each dimension, and by the input.
typedef struct Rates {
    double by[YK_BAR_SIZE], by_input;
} Rates;

static Rates four_bar_rates(const YkBar *bar, YkVec ground, YkVec crank, YkVec u)
{
    const double *v = bar->v;
    YkVec C = yk_sub(yk_scale(v[YK_BAR_COUPLER], u), across(bar, ground, crank));
    double scale = 1 / (v[YK_BAR_COUPLER] * yk_dot(C, yk_quarter(u)));
    Rates r = {{0}, -scale * v[YK_BAR_INPUT] * yk_dot(C, yk_quarter(crank))};
    r.by[YK_BAR_GROUND] = scale * yk_dot(C, ground);
    r.by[YK_BAR_TURN] = scale * v[YK_BAR_GROUND] * yk_dot(C, yk_quarter(ground));
    r.by[YK_BAR_INPUT] = -scale * yk_dot(C, crank);
    r.by[YK_BAR_COUPLER] = -scale * yk_dot(C, u);
    r.by[YK_BAR_OUTPUT] = scale * v[YK_BAR_OUTPUT];
    return r;
}

static Rates slider_rates(const YkBar *bar, YkVec line, YkVec crank, YkVec u)
{
    const double *v = bar->v;
    double scale = 1 / (v[YK_BAR_COUPLER] * yk_dot(line, u)), step = v[YK_BAR_INPUT] * yk_dot(line, crank);
    Rates r = {{0}, -scale * step};
    r.by[YK_BAR_GROUND] = scale;
    r.by[YK_BAR_TURN] = 1 + scale * step;
    r.by[YK_BAR_INPUT] = -scale * yk_cross(line, crank);
    r.by[YK_BAR_COUPLER] = -scale * yk_cross(line, u);
    return r;
}

static Rates inverted_rates(const YkBar *bar, YkVec ground, YkVec crank, YkVec u)
{
    const double *v = bar->v;
    double scale = 1 / yk_dot(u, across(bar, ground, crank));
    Rates r = {{0}, -scale * v[YK_BAR_INPUT] * yk_cross(u, yk_quarter(crank))};
    r.by[YK_BAR_GROUND] = scale * yk_cross(u, ground);
    r.by[YK_BAR_TURN] = scale * v[YK_BAR_GROUND] * yk_cross(u, yk_quarter(ground));
    r.by[YK_BAR_INPUT] = -scale * yk_cross(u, crank);
    r.by[YK_BAR_OUTPUT] = -scale;
    return r;
}

static Rates rates_of(const YkBar *bar, YkVec ground, YkVec crank, YkVec u)
{
    if (bar->kind == YK_DESIGN_SLIDER_CRANK) return slider_rates(bar, ground, crank, u);
    if (bar->kind == YK_DESIGN_INVERTED) return inverted_rates(bar, ground, crank, u);
    return four_bar_rates(bar, ground, crank, u);
}

bool yk_bar_point(const YkBar *bar, double input, YkBarPoint *point)
{
    const double *v = bar->v;
    if (yk_bar_size(bar->kind) > YK_BAR_PLAIN) return yk_chain_point(bar, input, point);
    YkVec ground = yk_unit(v[YK_BAR_TURN]), crank = yk_unit(input), u;
    if (!close_up(bar, ground, crank, &u)) return false;
    Rates rates = rates_of(bar, ground, crank, u);
    YkVec off = yk_mul(yk_vec(v[YK_BAR_PX], v[YK_BAR_PY]), u), turned = yk_quarter(off);
    YkVec A = yk_scale(v[YK_BAR_INPUT], crank), pivot = yk_vec(v[YK_BAR_X], v[YK_BAR_Y]);
    for (size_t k = 0; k < YK_BAR_PLAIN; k++) point->by[k] = yk_scale(rates.by[k], turned);
    point->by[YK_BAR_X] = yk_vec(1, 0);
    point->by[YK_BAR_Y] = yk_vec(0, 1);
    point->by[YK_BAR_INPUT] = yk_add(point->by[YK_BAR_INPUT], crank);
    point->by[YK_BAR_PX] = u;
    point->by[YK_BAR_PY] = yk_quarter(u);
    point->by_input = yk_add(yk_quarter(A), yk_scale(rates.by_input, turned));
    if (bar->hangs_at_end) {
        YkVec frame = yk_scale(v[YK_BAR_GROUND], ground);
        pivot = yk_sub(pivot, frame);
        point->by[YK_BAR_GROUND] = yk_sub(point->by[YK_BAR_GROUND], ground);
        point->by[YK_BAR_TURN] = yk_sub(point->by[YK_BAR_TURN], yk_quarter(frame));
    }
    point->at = yk_add(yk_add(pivot, A), off);
    point->coupler = yk_atan2(u.y, u.x);
    return true;
}

// The dyad of a design whose first loop is there. Returns false if it does not close.
static bool add_dyad(const YkBar *bar, double input, YkDesign *design)
{
    const double *v = bar->v;
    YkVec end[2], joint;
    if (!yk_chain_dyad(bar, input, end, &joint)) return false;
    YkChainVariant variant = yk_chain_variant(bar->kind, bar->variant);
    design->variant = bar->variant;
    for (int k = 0; k < 2; k++) {
        YkVec along = yk_sub(joint, end[k]);
        design->dyad_angle[k] = yk_atan2(along.y, along.x);
        design->dyad_length[k] = v[k == 0 ? YK_BAR_LINK : YK_BAR_ARM];
        design->end[k] = k == 0 ? yk_vec(v[YK_BAR_CU], v[YK_BAR_CV]) : yk_vec(v[YK_BAR_DU], v[YK_BAR_DV]);
        if ((k == 0 ? variant.link : variant.arm) == YK_CHAIN_GROUND)
            design->end[k] = end[k]; // its axes are the world's
    }
    return true;
}

// A geared five-bar has no first loop: its second crank follows the input.
static bool design_geared(const YkBar *bar, double input, YkDesign *design)
{
    double turn = bar->v[YK_BAR_TURN], ratio = yk_chain_variant(bar->kind, bar->variant).ratio;
    design->length[2] = 0;
    design->angle[0] = input;
    design->angle[2] = turn + ratio * (input - turn) + bar->v[YK_BAR_CU];
    return add_dyad(bar, input, design);
}

bool yk_bar_design(const YkBar *bar, double input, YkDesign *design)
{
    const double *v = bar->v;
    YkVec ground = yk_unit(v[YK_BAR_TURN]), crank = yk_unit(input), u;
    *design = (YkDesign){.kind = bar->kind, .has_point = true, .dyad = {-1, -1}};
    design->pivot[0] = yk_bar_pivot(bar);
    design->length[1] = v[YK_BAR_INPUT];
    design->length[2] = v[YK_BAR_COUPLER];
    design->point = yk_vec(v[YK_BAR_PX], v[YK_BAR_PY]);
    if (bar->kind == YK_DESIGN_GEARED) {
        design->pivot[1] = yk_add(design->pivot[0], yk_scale(v[YK_BAR_GROUND], ground));
        design->length[0] = v[YK_BAR_GROUND];
        design->length[3] = v[YK_BAR_OUTPUT];
        return design_geared(bar, input, design);
    }
    if (!close_up(bar, ground, crank, &u)) return false;
    design->angle[0] = input;
    design->angle[1] = yk_atan2(u.y, u.x);
    YkVec B = yk_add(yk_scale(v[YK_BAR_INPUT], crank), yk_scale(v[YK_BAR_COUPLER], u)); // seen from the input pivot
    if (bar->kind == YK_DESIGN_SLIDER_CRANK) {
        design->along = v[YK_BAR_TURN];
        design->pivot[1] = yk_add(design->pivot[0], yk_scale(v[YK_BAR_GROUND], yk_quarter(ground)));
        design->angle[2] = yk_dot(B, ground);
        return true;
    }
    YkVec frame = yk_scale(v[YK_BAR_GROUND], ground), C = yk_sub(B, frame);
    design->pivot[1] = yk_add(design->pivot[0], frame);
    design->length[0] = v[YK_BAR_GROUND];
    design->length[3] = v[YK_BAR_OUTPUT];
    design->angle[2] = yk_atan2(C.y, C.x);
    if (bar->kind == YK_DESIGN_INVERTED) {
        design->length[2] = 0;
        design->angle[2] = yk_dot(across(bar, ground, crank), u);
    }
    return yk_bar_size(bar->kind) == YK_BAR_PLAIN || add_dyad(bar, input, design);
}
