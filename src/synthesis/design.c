// Dimensions, type and defects of a four-bar from two dyads.
#include "synthesis/paths/path_chain.h"
#include <math.h>

static YkVec vector(const double v[2])
{
    return yk_vec(v[0], v[1]);
}

// A slider-crank: the second dyad is a slide along a line of the ground.
static bool slider_of_dyads(const YkPose *first, const YkDyad *output, YkDesign *design)
{
    design->kind = YK_DESIGN_SLIDER_CRANK;
    design->pivot[1] = yk_pose_apply(*first, vector(output->moving));
    design->along = output->direction;
    return design->length[1] > 1e-7 * design->length[2] && design->length[2] > 1e-7 * design->length[1];
}

// An inverted slider-crank: the second dyad is a block on the ground's pivot, through which a line of the body slides.
// The coupler's axis is parallel to that line, through the input's joint.
static bool inverted_of_dyads(const YkPose *first, const YkDyad *input, const YkDyad *output, YkDesign *design)
{
    YkVec along = yk_unit(output->direction), z = vector(input->moving);
    design->kind = YK_DESIGN_INVERTED;
    design->pivot[1] = vector(output->fixed);
    design->length[0] = yk_norm(yk_sub(design->pivot[1], design->pivot[0]));
    design->length[2] = 0;
    design->length[3] = yk_cross(along, yk_sub(vector(output->moving), z));
    design->turn = -output->direction;
    design->point = yk_mul(yk_unit(design->turn), yk_scale(-1, z));
    yk_design_angles(design, *first, design->angle);
    return design->length[1] > 1e-7 * (design->length[0] + design->length[1]);
}

bool yk_design_of_dyads(const YkPose *first, const YkDyad *input, const YkDyad *output, YkDesign *design)
{
    YkVec z = vector(input->moving), across = yk_sub(vector(output->moving), z);
    YkVec ground = yk_sub(vector(output->fixed), vector(input->fixed));
    double coupler = yk_norm(across), size = input->length + output->length + coupler + yk_norm(ground);
    bool good = true;
    *design = (YkDesign){.kind = YK_DESIGN_FOUR_BAR, .has_point = true};
    design->pivot[0] = vector(input->fixed);
    design->length[1] = input->length;
    design->length[2] = coupler;
    design->turn = -yk_argument(across);
    design->point = yk_mul(yk_unit(design->turn), yk_scale(-1, z));
    if (output->kind == YK_DYAD_RP) return inverted_of_dyads(first, input, output, design);
    if (output->kind == YK_DYAD_PR) {
        good = slider_of_dyads(first, output, design);
    } else {
        design->pivot[1] = vector(output->fixed);
        design->length[0] = yk_norm(ground);
        design->length[3] = output->length;
        for (size_t k = 0; k < 4; k++) good = good && design->length[k] > 1e-7 * size;
    }
    if (good) yk_design_angles(design, *first, design->angle);
    return good;
}

// The classes of design/four_bar.c, of lengths in the same order.
YkFourBarClass yk_design_class(const YkDesign *design)
{
    static const YkFourBarClass inversions[] = {YK_FOUR_BAR_DRAG_LINK, YK_FOUR_BAR_CRANK_ROCKER,
                                                YK_FOUR_BAR_DOUBLE_ROCKER, YK_FOUR_BAR_ROCKER_CRANK};
    size_t shortest = 0, longest = 0;
    double sum = 0;
    for (size_t k = 0; k < 4; k++) {
        sum += design->length[k];
        if (design->length[k] < design->length[shortest]) shortest = k;
        if (design->length[k] > design->length[longest]) longest = k;
    }
    double excess = 2 * (design->length[shortest] + design->length[longest]) - sum;
    if (fabs(excess) <= 1e-9 * sum) return YK_FOUR_BAR_CHANGE_POINT;
    return excess > 0 ? YK_FOUR_BAR_TRIPLE_ROCKER : inversions[shortest];
}

const char *yk_design_kind_name(YkDesignKind kind)
{
    static const char *const names[YK_DESIGN_KINDS] = {"four-bar",        "slider-crank", "inverted-slider-crank",
                                                       "geared-five-bar", "watt",         "stephenson"};
    return (size_t)kind < YK_DESIGN_KINDS ? names[kind] : NULL;
}

// Returns where link (0) or arm (1) begins.
static YkVec dyad_end(const YkDesign *d, int which, const YkDesignPlaces *at)
{
    YkChainVariant variant = yk_chain_variant(d->kind, d->variant);
    YkChainBody body = which == 0 ? variant.link : variant.arm;
    if (d->kind == YK_DESIGN_GEARED) return body == YK_CHAIN_INPUT ? at->A : at->B;
    const YkVec origin[] = {yk_vec(0, 0), d->pivot[0], at->A, d->pivot[1]};
    YkVec along = body == YK_CHAIN_GROUND ? yk_vec(1, 0) : yk_unit(d->angle[body - 1]);
    return yk_add(origin[body], yk_mul(along, d->end[which]));
}

YkDesignPlaces yk_design_places(const YkDesign *d)
{
    YkDesignPlaces at = {.A = yk_add(d->pivot[0], yk_scale(d->length[1], yk_unit(d->angle[0])))};
    YkVec along = yk_unit(d->angle[1]);
    at.B = d->kind == YK_DESIGN_GEARED     ? yk_add(d->pivot[1], yk_scale(d->length[3], yk_unit(d->angle[2])))
           : d->kind == YK_DESIGN_INVERTED ? d->pivot[1]
                                           : yk_add(at.A, yk_scale(d->length[2], along));
    at.P = d->has_point ? yk_add(at.A, yk_mul(along, d->point)) : at.B;
    if (yk_bar_size(d->kind) == YK_BAR_PLAIN) return at;
    at.C = dyad_end(d, 0, &at);
    at.D = dyad_end(d, 1, &at);
    YkVec link = yk_unit(d->dyad_angle[0]);
    at.E = yk_add(at.C, yk_scale(d->dyad_length[0], link));
    at.P = yk_add(at.C, yk_mul(link, d->point));
    return at;
}

const char *yk_design_type(const YkDesign *design)
{
    static const char *const built[YK_DESIGN_KINDS][6] = {
        [YK_DESIGN_GEARED] = {"geared -1", "geared +2", "geared -2", "geared +2, other side", "geared -2, other side",
                              "geared +1"},
        [YK_DESIGN_WATT] = {"watt, coupler and output", "watt, output and coupler", "watt, coupler and input",
                            "watt, input and coupler"},
        [YK_DESIGN_STEPHENSON] = {"stephenson III", "stephenson I", "stephenson I, other side"}};
    if (design->kind == YK_DESIGN_INVERTED) return "inverted slider-crank";
    if (design->kind >= YK_DESIGN_GEARED) return built[design->kind][design->variant];
    static const char *const names[] = {"crank-rocker",  "rocker-crank", "drag-link",
                                        "double-rocker", "change-point", "triple-rocker"};
    return design->kind == YK_DESIGN_FOUR_BAR ? names[yk_design_class(design)] : "slider-crank";
}

// How far the pivot of a slider-crank's crank lies from the slider's line, with a sign.
static double offset_of(const YkDesign *design)
{
    return yk_cross(yk_unit(design->along), yk_sub(design->pivot[0], design->pivot[1]));
}

// Where the distance of the output pivot from the crank's joint is less than that from the coupler's line, an inverted
// slider-crank stops; a geared five-bar is judged by the engine.
static bool turns_otherwise(const YkDesign *design)
{
    return design->kind == YK_DESIGN_GEARED || fabs(design->length[0] - design->length[1]) > fabs(design->length[3]);
}

bool yk_design_has_circuits(const YkDesign *design)
{
    if (design->kind == YK_DESIGN_GEARED) return true;
    if (design->kind == YK_DESIGN_INVERTED) return turns_otherwise(design);
    if (design->kind == YK_DESIGN_SLIDER_CRANK) // crank or coupler turns through
        return fabs(offset_of(design)) < fabs(design->length[1] - design->length[2]);
    YkFourBarClass kind = yk_design_class(design);
    return kind != YK_FOUR_BAR_TRIPLE_ROCKER && kind != YK_FOUR_BAR_CHANGE_POINT;
}

bool yk_design_turns(const YkDesign *design)
{
    if (design->kind == YK_DESIGN_INVERTED || design->kind == YK_DESIGN_GEARED) return turns_otherwise(design);
    if (design->kind == YK_DESIGN_SLIDER_CRANK) return design->length[1] + fabs(offset_of(design)) < design->length[2];
    YkFourBarClass kind = yk_design_class(design);
    return kind == YK_FOUR_BAR_CRANK_ROCKER || kind == YK_FOUR_BAR_DRAG_LINK;
}

void yk_design_angles(const YkDesign *design, YkPose pose, double angle[3])
{
    angle[1] = pose.angle - design->turn;
    YkVec along = yk_unit(angle[1]), A = yk_sub(pose.at, yk_mul(along, design->point));
    YkVec B = yk_add(A, yk_scale(design->length[2], along));
    angle[0] = yk_argument(yk_sub(A, design->pivot[0]));
    YkVec out = yk_sub(B, design->pivot[1]);
    angle[2] = design->kind == YK_DESIGN_FOUR_BAR   ? yk_argument(out)
               : design->kind == YK_DESIGN_INVERTED ? yk_dot(yk_sub(design->pivot[1], A), along)
                                                    : yk_dot(out, yk_unit(design->along));
}

static int sign(double x)
{
    return (x > 0) - (x < 0);
}

// An inverted slider-crank cannot pass the place where the output pivot lies across the coupler's line from its joint,
// s = 0: it ends one circuit, or one of the two branches of a machine that has but one.
static YkDefect inverted_signs(const YkDesign *design, double (*angle)[3], size_t count)
{
    for (size_t k = 1; k < count; k++)
        if (angle[k][2] * angle[0][2] <= 0) return yk_design_turns(design) ? YK_DEFECT_CIRCUIT : YK_DEFECT_BRANCH;
    return YK_DEFECT_NONE;
}

// The joint whose sense shows the circuit: one that does not touch the shortest link, whose two links never line up.
static double circuit_sense(const YkDesign *design, const double angle[3])
{
    size_t shortest = 0;
    if (design->kind == YK_DESIGN_SLIDER_CRANK) // the longer link never stands across the line
        return yk_cos(angle[design->length[1] < design->length[2]] - design->along);
    for (size_t k = 1; k < 4; k++)
        if (design->length[k] < design->length[shortest]) shortest = k;
    YkVec ground = yk_sub(design->pivot[1], design->pivot[0]);
    switch (shortest) {
    case 1: // the input: coupler against output
        return yk_sin(angle[2] - angle[1]);
    case 2: // the coupler: input against ground
        return yk_cross(yk_unit(angle[0]), ground);
    default: // ground or output: input against coupler
        return yk_sin(angle[1] - angle[0]);
    }
}

YkDefect yk_design_signs(const YkDesign *design, double (*angle)[3], size_t count)
{
    bool has_circuits = yk_design_has_circuits(design), is_slider = design->kind == YK_DESIGN_SLIDER_CRANK;
    YkDefect defect = YK_DEFECT_NONE;
    if (design->kind == YK_DESIGN_INVERTED) return inverted_signs(design, angle, count);
    int circuit = 0, branch = 0;
    for (size_t k = 0; k < count; k++) {
        int own_circuit = has_circuits ? sign(circuit_sense(design, angle[k])) : 0;
        int own = sign(is_slider ? yk_cos(angle[k][1] - design->along) : yk_sin(angle[k][2] - angle[k][1]));
        if (k > 0 && own_circuit != circuit) return YK_DEFECT_CIRCUIT;
        if (k > 0 && own != branch) defect = YK_DEFECT_BRANCH;
        circuit = own_circuit;
        branch = own;
    }
    return defect;
}

static bool is_within(const YkBound *bound, double value)
{
    double room = 1e-9 * fabs(value);
    return !bound->is_given || (value >= bound->low - room && value <= bound->high + room);
}

YkDefect yk_design_bounds(const YkDesign *design, const YkTask *task)
{
    double least = INFINITY, most = 0;
    bool good = true;
    for (size_t k = 0; k < 6; k++) {
        static const int dimensions[] = {YK_BAR_GROUND, YK_BAR_INPUT, YK_BAR_COUPLER,
                                         YK_BAR_OUTPUT, YK_BAR_LINK,  YK_BAR_ARM};
        double length = k < 4 ? design->length[k] : design->dyad_length[k - 4];
        if (!yk_bar_is_length(design->kind, dimensions[k])) continue;
        good = good && is_within(&task->lengths, length);
        least = fmin(least, length);
        most = fmax(most, length);
    }
    for (size_t i = 0; i < (design->kind == YK_DESIGN_SLIDER_CRANK ? 1u : 2u); i++)
        good =
            good && is_within(&task->pivots[0], design->pivot[i].x) && is_within(&task->pivots[1], design->pivot[i].y);
    if (design->has_point)
        good = good && is_within(&task->coupler_point, design->point.x) &&
               is_within(&task->coupler_point, design->point.y);
    if (!good) return YK_DEFECT_BOUNDS;
    return task->size_ratio.is_given && most > task->size_ratio.value * least ? YK_DEFECT_SIZE : YK_DEFECT_NONE;
}
