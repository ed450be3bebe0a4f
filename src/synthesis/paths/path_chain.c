// Frames of the bodies, one after the other, each with its derivatives; then the dyad that closes the second loop.
//
// A dyad from C to D with lengths r and q: |C + r e^(i psi) - D| = q fixes psi on each branch. The condition is linear
// in every derivative of psi, which is singular only where link and arm lie in one line.
#include "synthesis/paths/path_chain.h"
#include <math.h>
#include <string.h>

enum { RATES = YK_CHAIN_RATES, IN = YK_BAR_SIZE };

static const YkChainVariant watt[] = {{YK_CHAIN_COUPLER, YK_CHAIN_OUTPUT, 0},
                                      {YK_CHAIN_OUTPUT, YK_CHAIN_COUPLER, 0},
                                      {YK_CHAIN_COUPLER, YK_CHAIN_INPUT, 0},
                                      {YK_CHAIN_INPUT, YK_CHAIN_COUPLER, 0}};
static const YkChainVariant stephenson[] = {
    {YK_CHAIN_COUPLER, YK_CHAIN_GROUND, 0}, {YK_CHAIN_INPUT, YK_CHAIN_OUTPUT, 0}, {YK_CHAIN_OUTPUT, YK_CHAIN_INPUT, 0}};
static const YkChainVariant geared[] = {{YK_CHAIN_INPUT, YK_CHAIN_OUTPUT, -1}, {YK_CHAIN_INPUT, YK_CHAIN_OUTPUT, 2},
                                        {YK_CHAIN_INPUT, YK_CHAIN_OUTPUT, -2}, {YK_CHAIN_OUTPUT, YK_CHAIN_INPUT, 2},
                                        {YK_CHAIN_OUTPUT, YK_CHAIN_INPUT, -2}, {YK_CHAIN_INPUT, YK_CHAIN_OUTPUT, 1}};

size_t yk_chain_variants(YkDesignKind kind)
{
    return kind == YK_DESIGN_WATT         ? sizeof watt / sizeof *watt
           : kind == YK_DESIGN_STEPHENSON ? sizeof stephenson / sizeof *stephenson
           : kind == YK_DESIGN_GEARED     ? sizeof geared / sizeof *geared
                                          : 0;
}

YkChainVariant yk_chain_variant(YkDesignKind kind, int variant)
{
    return kind == YK_DESIGN_WATT ? watt[variant] : kind == YK_DESIGN_GEARED ? geared[variant] : stephenson[variant];
}

// --- frames

static void add_turning(YkVec off, const double *turn, YkVec *by)
{
    YkVec turned = yk_quarter(off);
    for (size_t j = 0; j < RATES; j++) by[j] = yk_add(by[j], yk_scale(turn[j], turned));
}

// A place of a body at (u, v) in its axes, which are dimensions; index: that of u, or -1 if they are not.
static YkChainPlace place_in(const YkChainFrame *f, double u, double v, int index)
{
    YkChainPlace place = f->origin;
    YkVec off = yk_mul(yk_vec(u, v), f->along);
    place.at = yk_add(place.at, off);
    add_turning(off, f->turn, place.by);
    if (index < 0) return place;
    place.by[index] = yk_add(place.by[index], f->along);
    place.by[index + 1] = yk_add(place.by[index + 1], yk_quarter(f->along));
    return place;
}

// A place along a body's axis at a distance that is a dimension.
static YkChainPlace place_along(const YkChainFrame *f, double distance, int index)
{
    YkChainPlace place = place_in(f, distance, 0, -1);
    place.by[index] = yk_add(place.by[index], f->along);
    return place;
}

static YkChainFrame ground_of(const YkBar *bar)
{
    YkChainFrame f = {.origin.at = yk_vec(bar->v[YK_BAR_X], bar->v[YK_BAR_Y]), .along = yk_unit(bar->v[YK_BAR_TURN])};
    f.origin.by[YK_BAR_X] = yk_vec(1, 0);
    f.origin.by[YK_BAR_Y] = yk_vec(0, 1);
    f.turn[YK_BAR_TURN] = 1;
    if (!bar->hangs_at_end) return f;
    YkVec length = yk_scale(bar->v[YK_BAR_GROUND], f.along);
    f.origin.at = yk_sub(f.origin.at, length);
    f.origin.by[YK_BAR_GROUND] = yk_scale(-1, f.along);
    f.origin.by[YK_BAR_TURN] = yk_scale(-1, yk_quarter(length));
    return f;
}

// A dyad between two places, and the frame of its first link.
typedef struct Dyad {
    double length[2];
    int index[2], branch; // of the lengths among the dimensions
} Dyad;

static bool close_dyad(const Dyad *d, const YkChainPlace *from, const YkChainPlace *to, YkChainFrame *link)
{
    double r = d->length[0], q = d->length[1];
    YkVec D = yk_sub(to->at, from->at);
    double square = yk_dot(D, D), distance = sqrt(square);
    double cosine = (square + r * r - q * q) / (2 * r * distance), rest = 1 - cosine * cosine;
    if (!(rest > 0)) return false;
    YkVec u = yk_mul(yk_scale(1 / distance, D), yk_vec(cosine, d->branch * sqrt(rest)));
    YkVec C = yk_sub(yk_scale(r, u), D);
    double scale = 1 / (r * yk_dot(C, yk_quarter(u)));
    link->origin = *from;
    link->along = u;
    for (size_t j = 0; j < RATES; j++) link->turn[j] = scale * yk_dot(C, yk_sub(to->by[j], from->by[j]));
    link->turn[d->index[0]] -= scale * yk_dot(C, u);
    link->turn[d->index[1]] += scale * q;
    return true;
}

// The axes of an output from those of the coupler: along its own line from B0 to B.
static YkChainFrame output_of(const YkBar *bar, const YkChainFrame *coupler, const YkChainPlace *B0)
{
    YkChainPlace B = place_along(coupler, bar->v[YK_BAR_COUPLER], YK_BAR_COUPLER);
    YkVec C = yk_sub(B.at, B0->at);
    double square = yk_dot(C, C);
    YkChainFrame f = {.origin = *B0, .along = yk_scale(1 / sqrt(square), C)};
    for (size_t j = 0; j < RATES; j++) f.turn[j] = yk_cross(C, yk_sub(B.by[j], B0->by[j])) / square;
    return f;
}

// The second crank of a geared five-bar.
static YkChainFrame second_crank(const YkBar *bar, double input, int ratio, const YkChainPlace *B0)
{
    double turn = bar->v[YK_BAR_TURN];
    YkChainFrame f = {.origin = *B0, .along = yk_unit(turn + ratio * (input - turn) + bar->v[YK_BAR_CU])};
    f.turn[YK_BAR_TURN] = 1 - ratio;
    f.turn[YK_BAR_CU] = 1;
    f.turn[IN] = ratio;
    return f;
}

// The axes of all bodies of the first loop, by YkChainBody. Returns false if it does not close.
static bool find_frames(const YkBar *bar, double input, YkChainFrame frame[4])
{
    const double *v = bar->v;
    frame[YK_CHAIN_GROUND] = ground_of(bar);
    YkChainPlace B0 = place_along(&frame[YK_CHAIN_GROUND], v[YK_BAR_GROUND], YK_BAR_GROUND);
    frame[YK_CHAIN_INPUT] = (YkChainFrame){.origin = frame[YK_CHAIN_GROUND].origin, .along = yk_unit(input)};
    frame[YK_CHAIN_INPUT].turn[IN] = 1;
    if (bar->kind == YK_DESIGN_GEARED) {
        frame[YK_CHAIN_OUTPUT] = second_crank(bar, input, yk_chain_variant(bar->kind, bar->variant).ratio, &B0);
        return true;
    }
    YkChainPlace A = place_along(&frame[YK_CHAIN_INPUT], v[YK_BAR_INPUT], YK_BAR_INPUT);
    Dyad d = {{v[YK_BAR_COUPLER], v[YK_BAR_OUTPUT]}, {YK_BAR_COUPLER, YK_BAR_OUTPUT}, bar->branch};
    if (!close_dyad(&d, &A, &B0, &frame[YK_CHAIN_COUPLER])) return false;
    frame[YK_CHAIN_OUTPUT] = output_of(bar, &frame[YK_CHAIN_COUPLER], &B0);
    return true;
}

// Returns where the dyad's link (0) or arm (1) begins.
static YkChainPlace end_of(const YkBar *bar, const YkChainFrame *frame, int which)
{
    YkChainVariant variant = yk_chain_variant(bar->kind, bar->variant);
    YkChainBody body = which == 0 ? variant.link : variant.arm;
    if (bar->kind == YK_DESIGN_GEARED) {
        int index = body == YK_CHAIN_INPUT ? YK_BAR_INPUT : YK_BAR_OUTPUT;
        return place_along(&frame[body], bar->v[index], index);
    }
    int index = which == 0 ? YK_BAR_CU : YK_BAR_DU;
    return place_in(&frame[body], bar->v[index], bar->v[index + 1], index);
}

static bool find_link(const YkBar *bar, double input, YkChainPlace end[2], YkChainFrame *link)
{
    YkChainFrame frame[4];
    if (!find_frames(bar, input, frame)) return false;
    for (int k = 0; k < 2; k++) end[k] = end_of(bar, frame, k);
    Dyad d = {{bar->v[YK_BAR_LINK], bar->v[YK_BAR_ARM]}, {YK_BAR_LINK, YK_BAR_ARM}, bar->bend};
    return close_dyad(&d, &end[0], &end[1], link);
}

bool yk_chain_point(const YkBar *bar, double input, YkBarPoint *point)
{
    YkChainPlace end[2];
    YkChainFrame link;
    if (!find_link(bar, input, end, &link)) return false;
    YkChainPlace P = place_in(&link, bar->v[YK_BAR_PX], bar->v[YK_BAR_PY], YK_BAR_PX);
    point->at = P.at;
    memcpy(point->by, P.by, sizeof point->by);
    point->by_input = P.by[IN];
    point->coupler = yk_atan2(link.along.y, link.along.x);
    return true;
}

bool yk_chain_frame(const YkBar *bar, double input, YkVec *origin, YkVec *along)
{
    YkChainPlace end[2];
    YkChainFrame link;
    if (!find_link(bar, input, end, &link)) return false;
    *origin = yk_sub(link.origin.at, yk_bar_pivot(bar));
    *along = link.along;
    return true;
}

bool yk_chain_ends(const YkBar *bar, double input, YkVec end[2])
{
    YkChainFrame frame[4];
    if (!find_frames(bar, input, frame)) return false;
    for (int k = 0; k < 2; k++) end[k] = end_of(bar, frame, k).at;
    return true;
}

bool yk_chain_dyad(const YkBar *bar, double input, YkVec end[2], YkVec *joint)
{
    YkChainPlace places[2];
    YkChainFrame link;
    if (!find_link(bar, input, places, &link)) return false;
    for (int k = 0; k < 2; k++) end[k] = places[k].at;
    *joint = yk_add(end[0], yk_scale(bar->v[YK_BAR_LINK], link.along));
    return true;
}
