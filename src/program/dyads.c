// Computes dyads in closed form: the formulas of solve/kernels*, where they are derived.
#include "program/blocks.h"

// 1 / a, as a complex number.
static YkRefVec vec_inverse(YkGraph *g, YkRefVec a)
{
    if (yk_graph_is_number(g, a.y, 0)) return (YkRefVec){yk_graph_inverse(g, a.x), a.y};
    YkRef per_square = yk_graph_inverse(g, yk_graph_dot(g, a, a));
    return yk_graph_vec_scale(g, per_square, yk_graph_vec_conjugate(g, a));
}

static YkRef not_negative(YkGraph *g, YkRef a)
{
    return yk_graph_binary(g, YK_VALUE_LARGEST, a, yk_graph_number(g, 0));
}

// Returns by how much an arm's length lowers the margin, as yk_arm_share does; `square` is that of its length.
static YkRef arm_share(YkProgram *p, const YkBlock *b, int k, YkRef square)
{
    YkGraph *g = &p->graph;
    double size = yk_program_block_size(p, b), enough = b->arm_is_constant[k] ? YK_PER_ARM_ENOUGH2 : 1;
    return yk_graph_multiply(g, yk_graph_number(g, enough / (size * size)), square);
}

// Returns whether an arm is short, or may be.
static bool is_careful(YkProgram *p, const YkBlock *b, int arms)
{
    double size = yk_program_block_size(p, b);
    bool careful = false;
    for (int k = 0; k < arms; k++) {
        YkVec arm = b->aside->arm[k].constant;
        careful =
            careful || !b->arm_is_constant[k] || yk_arm_share(yk_dot(arm, arm), YK_PER_ARM_ENOUGH2 / (size * size)) < 1;
    }
    return careful;
}

// Returns the margin where the loop closes, less the arms' shares.
static YkRef with_share(YkProgram *p, YkRef margin, YkRef share)
{
    YkGraph *g = &p->graph;
    YkRef most = yk_graph_binary(g, YK_VALUE_LEAST, share, yk_graph_number(g, 1));
    return yk_graph_choose(g, margin, margin, yk_graph_multiply(g, margin, most));
}

static YkRefVec of_length_one(YkGraph *g, YkRefVec e)
{
    YkRef per = yk_graph_inverse(g, yk_graph_vec_length(g, e));
    return yk_graph_vec_scale(g, per, e);
}

// An arm is short, or may be: its unit vector takes more of the base's rounding than its length allows.
static void make_careful(YkProgram *p, YkPlaced *placed, YkRefVec U, YkRefVec W)
{
    YkGraph *g = &p->graph;
    for (int k = 0; k < 2; k++) placed->e[k] = of_length_one(g, placed->e[k]);
    placed->p = yk_graph_vec_multiply(g, U, placed->e[0]);
    placed->q = yk_graph_vec_multiply(g, W, placed->e[1]);
    placed->inverse = yk_graph_inverse(g, yk_graph_cross(g, placed->p, placed->q));
}

// 1 / sqrt(square), with the sign of the block's branch.
static YkRef signed_per_root(YkProgram *p, size_t block, YkRef square)
{
    YkRef branch = yk_block_branch(p, block);
    return yk_graph_multiply(&p->graph, branch, yk_graph_unary(&p->graph, YK_VALUE_PER_ROOT, square));
}

// RRR: two circles intersect.
void yk_block_place_rrr(YkProgram *p, size_t index, YkPlaced *placed)
{
    YkGraph *g = &p->graph;
    const YkBlock *b = &p->mech->blocks[index];
    YkRefVec K = placed->known, U = yk_program_sum(p, &b->aside->arm[0]), W = yk_program_sum(p, &b->aside->arm[1]);
    YkRef U2 = yk_graph_dot(g, U, U), W2 = yk_graph_dot(g, W, W), L2 = yk_graph_dot(g, K, K);
    YkRef u = yk_graph_function(g, YK_SQRT, U2, -1), w = yk_graph_function(g, YK_SQRT, W2, -1);
    YkRef sum = yk_graph_add(g, u, w), difference = yk_graph_subtract(g, u, w);
    YkRef outer = yk_graph_multiply(g, sum, sum), inner = yk_graph_multiply(g, difference, difference);
    YkRef product = yk_graph_multiply(g, sum, difference);
    yk_graph_name(g, L2, "%s_L2", placed->name);
    yk_graph_name(g, outer, "%s_outer", placed->name);
    yk_graph_name(g, inner, "%s_inner", placed->name);
    yk_graph_name(g, product, "%s_product", placed->name);
    YkRef to_outer = yk_graph_subtract(g, outer, L2), to_inner = yk_graph_subtract(g, L2, inner);
    YkRef square = yk_graph_multiply(g, to_outer, to_inner);
    yk_graph_name(g, square, "%s_square", placed->name);
    YkRef per_root = signed_per_root(p, index, square);
    YkRef per_L2 = yk_graph_inverse(g, L2), half = yk_graph_multiply(g, yk_graph_number(g, 0.5), per_L2);
    YkRef root = yk_graph_multiply(g, not_negative(g, square), per_root);
    YkRef slope = yk_graph_multiply(g, root, half);
    YkRef first = yk_graph_minus(g, yk_graph_multiply(g, yk_graph_add(g, L2, product), half));
    YkRef second = yk_graph_minus(g, yk_graph_multiply(g, yk_graph_subtract(g, L2, product), half));
    placed->p = yk_graph_vec_multiply(g, K, (YkRefVec){first, slope});
    placed->q = yk_graph_vec_multiply(g, K, (YkRefVec){second, yk_graph_minus(g, slope)});
    yk_block_name(p, placed->p, placed->name, "p");
    yk_block_name(p, placed->q, placed->name, "q");
    placed->inverse = yk_graph_multiply(g, yk_graph_number(g, 2), per_root); // 1 / D
    yk_graph_name(g, placed->inverse, "%s_per_D", placed->name);
    placed->e[0] = yk_graph_vec_multiply(g, placed->p, vec_inverse(g, U));
    placed->e[1] = yk_graph_vec_multiply(g, placed->q, vec_inverse(g, W));
    bool careful = is_careful(p, b, 2);
    if (careful) make_careful(p, placed, U, W);
    yk_program_set_unit(p, b->column[0].index, placed->e[0]);
    yk_program_set_unit(p, b->column[1].index, placed->e[1]);
    YkRef four = yk_graph_number(g, 4), most = yk_graph_multiply(g, four, yk_graph_multiply(g, U2, W2));
    YkRef margin = yk_graph_multiply(g, square, yk_graph_inverse(g, most));
    YkRef shortness = yk_graph_multiply(g, yk_graph_multiply(g, u, w), per_L2);
    YkRef longer = yk_graph_binary(g, YK_VALUE_LARGEST, shortness, yk_graph_number(g, 1));
    YkRef closing = margin;
    if (careful) {
        YkRef of_u = arm_share(p, b, 0, U2), of_w = arm_share(p, b, 1, W2);
        closing = with_share(p, margin, yk_graph_binary(g, YK_VALUE_LEAST, of_u, of_w));
    }
    yk_block_keep_margin(p, yk_graph_choose(g, margin, yk_graph_multiply(g, margin, longer), closing), placed->e[0].x);
}

// RRP: a circle intersects a line.
void yk_block_place_rrp(YkProgram *p, size_t index, YkPlaced *placed)
{
    YkGraph *g = &p->graph;
    const YkBlock *b = &p->mech->blocks[index];
    YkRefVec K = placed->known, W = yk_program_sum(p, &b->aside->arm[0]), e = yk_block_line(p, b, 1, 0);
    YkRef W2 = yk_graph_dot(g, W, W), radius = yk_graph_function(g, YK_SQRT, W2, -1);
    YkRef h = yk_graph_minus(g, yk_graph_cross(g, e, K)), along = yk_graph_dot(g, e, K);
    yk_graph_name(g, h, "%s_h", placed->name);
    YkRef less = yk_graph_subtract(g, radius, h), more = yk_graph_add(g, radius, h),
          g2 = yk_graph_multiply(g, less, more);
    yk_graph_name(g, g2, "%s_g2", placed->name);
    YkRef per_root = yk_graph_minus(g, signed_per_root(p, index, g2));
    YkRef minus_g = yk_graph_multiply(g, not_negative(g, g2), per_root);
    YkRef d = yk_graph_subtract(g, minus_g, along);
    placed->q = yk_graph_vec_multiply(g, (YkRefVec){yk_graph_minus(g, minus_g), h}, e);
    placed->e[0] = e;
    placed->e[1] = yk_graph_vec_multiply(g, placed->q, vec_inverse(g, W));
    placed->inverse = yk_graph_name(g, per_root, "%s_per_g", placed->name);
    yk_program_set_distance(p, b->column[1].index, d);
    yk_program_set_unit(p, b->column[0].index, placed->e[1]);
    YkRef margin = yk_graph_multiply(g, g2, yk_graph_inverse(g, W2));
    if (is_careful(p, b, 1)) margin = with_share(p, margin, arm_share(p, b, 0, W2));
    yk_block_keep_margin(p, margin, placed->e[1].x);
}

// Returns r over the base, squared, or over the size if that is less, as rpr_margin does; per_K2 is -1 if the line
// passes through the pin, so that K^2 = r^2.
static YkRef rpr_margin(YkProgram *p, const YkBlock *b, YkRef r2, YkRef per_K2)
{
    YkGraph *g = &p->graph;
    double size = yk_program_block_size(p, b);
    YkRef of_size = yk_graph_multiply(g, yk_graph_number(g, 1 / (size * size)), r2);
    YkRef of_base = per_K2 < 0 ? yk_graph_number(g, 1) : yk_graph_multiply(g, r2, per_K2);
    return yk_graph_binary(g, YK_VALUE_LEAST, of_base, of_size);
}

// RPR: a line that turns about a pin passes through a point.
void yk_block_place_rpr(YkProgram *p, size_t index, YkPlaced *placed)
{
    YkGraph *g = &p->graph;
    const YkBlock *b = &p->mech->blocks[index];
    YkRefVec K = placed->known, C = yk_program_sum(p, &b->aside->arm[0]), f = yk_block_line(p, b, 1, 0);
    YkRef h = yk_graph_cross(g, f, C), along = yk_graph_dot(g, f, C), K2 = yk_graph_dot(g, K, K);
    YkRef r2 = yk_graph_subtract(g, K2, yk_graph_multiply(g, h, h));
    yk_graph_name(g, K2, "%s_K2", placed->name);
    placed->passes_pin = yk_graph_is_number(g, h, 0) && yk_graph_is_number(g, along, 0);
    YkRef per_root = signed_per_root(p, index, r2);
    YkRef r = yk_graph_name(g, yk_graph_multiply(g, not_negative(g, r2), per_root), "%s_r", placed->name);
    placed->inverse = yk_graph_name(g, per_root, "%s_per_r", placed->name);
    YkRef per_K2 = placed->passes_pin ? -1 : yk_graph_inverse(g, K2);
    YkRef across = placed->passes_pin ? h : yk_graph_multiply(g, h, per_K2);
    YkRef down = yk_graph_minus(g, placed->passes_pin ? per_root : yk_graph_multiply(g, r, per_K2));
    YkRefVec e = yk_graph_vec_multiply(g, K, (YkRefVec){down, across});
    placed->e[0] = e;
    placed->e[1] = yk_graph_vec_multiply(g, e, yk_graph_vec_conjugate(g, f));
    yk_program_set_unit(p, b->column[0].index, placed->e[1]);
    yk_program_set_distance(p, b->column[1].index, yk_graph_subtract(g, r, along));
    yk_block_keep_margin(p, rpr_margin(p, b, r2, per_K2), e.x);
}

// PP: two lines intersect.
void yk_block_place_pp(YkProgram *p, size_t index, YkPlaced *placed)
{
    YkGraph *g = &p->graph;
    const YkBlock *b = &p->mech->blocks[index];
    for (size_t k = 0; k < 2; k++) placed->e[k] = yk_block_line(p, b, k, k);
    YkRef D = yk_graph_cross(g, placed->e[0], placed->e[1]);
    placed->inverse = yk_graph_inverse(g, D);
    YkRef d1 = yk_graph_minus(g, yk_graph_multiply(g, yk_graph_cross(g, placed->known, placed->e[1]), placed->inverse));
    YkRef d2 = yk_graph_multiply(g, yk_graph_cross(g, placed->known, placed->e[0]), placed->inverse);
    yk_program_set_distance(p, b->column[0].index, d1);
    yk_program_set_distance(p, b->column[1].index, d2);
    yk_block_keep_margin(p, yk_graph_multiply(g, D, D), d1);
}
