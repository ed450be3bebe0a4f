// The recursion of open trees over lanes.
#include "elementary/elementary.h"
#include "elementary/turn.h"
#include "equations/kernels_chain.h"
#include "equations/kernels_tree.h"
#include "equations/tree_noise.h"

// Repeats the lanes one by one if at least one is beyond the reduction's range.
YK_APART void turn_one_by_one(YkTreeFound *link, const YkTreeFound *parent, const double *q, double sense, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        YkVec e;
        yk_sincos(sense * q[i], &e.y, &e.x);
        if (parent) e = yk_mul(yk_vec(parent->c[i], parent->s[i]), e);
        link->c[i] = e.x;
        link->s[i] = e.y;
    }
}

// Finds direction and rate of turning: the parent's (none: the ground's), turned by sense times the coordinate. Unlike
// the addition of angles, turning loses no digits along a chain that coils up.
YK_INLINE void find_turn(YkTreeFound *link, const YkTreeFound *parent, bool has_parent, const double *q,
                         const double *v, double sense, size_t n)
{
    uint64_t far = 0;
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        double x = sense * q[i], s, c;
        sincos_near(x, &s, &c);
        far |= sincos_far_bits(x);
        YkVec e = has_parent ? yk_mul(yk_vec(parent->c[i], parent->s[i]), yk_vec(c, s)) : yk_vec(c, s);
        link->c[i] = e.x;
        link->s[i] = e.y;
        link->w[i] = has_parent ? parent->w[i] + sense * v[i] : sense * v[i];
    }
    if (sincos_is_far(far)) turn_one_by_one(link, has_parent ? parent : NULL, q, sense, n);
}

// The given values of a link, for the lanes from `at`.
typedef struct Given {
    const double *at_x, *at_y, *center_x, *center_y, *mass, *inertia, *torque;
} Given;

YK_INLINE Given given_of(const YkTreeRows *link, size_t at)
{
    const double *const *row = link->given;
    return (Given){row[YK_GIVEN_AT_X] + at,
                   row[YK_GIVEN_AT_Y] + at,
                   row[YK_GIVEN_CENTER_X] + at,
                   row[YK_GIVEN_CENTER_Y] + at,
                   row[YK_GIVEN_MASS] + at,
                   row[YK_GIVEN_INERTIA] + at,
                   link->torque + at};
}

YK_INLINE YkArticulated shown_to(const YkTreeFound *link, size_t i)
{
    return (YkArticulated){yk_inertia_read(&link->inertia, i), yk_vec(link->f_x[i], link->f_y[i]), link->n[i]};
}

// Passes to the parent, which stores it (is_first) or adds it to that of its other children.
YK_INLINE void show(YkTreeFound *to, bool is_first, const YkArticulated *A, const YkInertia *noise, size_t i)
{
    YkArticulated sum = *A;
    YkInertia sum_noise = *noise;
    if (!is_first) {
        sum = shown_to(to, i);
        yk_articulated_add(&sum, A);
        sum_noise = yk_inertia_read(&to->noise, i);
        yk_inertia_add(&sum_noise, noise);
    }
    yk_inertia_write(&to->inertia, i, sum.of);
    to->f_x[i] = sum.f.x, to->f_y[i] = sum.f.y, to->n[i] = sum.n;
    yk_inertia_write(&to->noise, i, sum_noise);
}

// Releases the link's pin under its torque and passes the rest to the parent.
YK_INLINE void inward(const YkTreeRows *rows, Given given, YkTreeFound *link, YkTreeFound *parent, bool has_parent,
                      bool has_children, bool is_first, double *ok, size_t n)
{
    double sense = rows->sense, least_mass = rows->has_mass ? 0 : -1;
    const double *sign = rows->sign;
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        double mass = given.mass[i], w = link->w[i], inertia = given.inertia[i];
        YkVec e = yk_vec(link->c[i], link->s[i]);
        YkVec center = yk_vec(sign[YK_GIVEN_CENTER_X] * given.center_x[i], sign[YK_GIVEN_CENTER_Y] * given.center_y[i]);
        double own = inertia + mass * yk_dot(center, center);
        YkVec moment = yk_mul(e, yk_scale(mass, center));
        YkArticulated A = {{own, yk_quarter(moment), mass, 0, mass}, yk_scale(-w * w, moment), 0}; // the link alone
        YkInertia noise = {0};
        if (has_children) {
            noise = yk_inertia_read(&link->noise, i);
            A = shown_to(link, i);
            yk_articulated_add_body(&A, mass, moment, own, w);
        }
        yk_noise_add_body(&noise, mass, own);
        double now = ((mass > least_mass) & (inertia >= 0)) ? ok[i] : -1;
        ok[i] = ((A.of.J > YK_LEAST_OVER_NOISE * noise.J) | (now < 0)) ? now : 0;
        double trace = yk_inertia_trace(&A.of);
        YkAnswer answer = yk_articulated_release_turn(&A, sense * given.torque[i]);
        link->on_x[i] = answer.on.x;
        link->on_y[i] = answer.on.y;
        if (!has_parent) {
            link->by[i] = answer.by;
            continue;
        }
        YkVec at = yk_vec(sign[YK_GIVEN_AT_X] * given.at_x[i], sign[YK_GIVEN_AT_Y] * given.at_y[i]),
              arm = yk_mul(yk_vec(parent->c[i], parent->s[i]), at);
        YkVec bias = yk_scale(-parent->w[i] * parent->w[i], arm), across = yk_quarter(arm);
        link->by[i] = answer.by - yk_dot(answer.on, bias);
        link->turn[i] = yk_dot(answer.on, across);
        link->bias_x[i] = bias.x;
        link->bias_y[i] = bias.y;
        link->across_x[i] = across.x;
        link->across_y[i] = across.y;
        yk_noise_release_turn(&noise, answer.on, trace);
        noise = yk_noise_move_force(&noise, across, yk_inertia_trace(&A.of));
        A = yk_articulated_move_force(&A, arm, bias);
        show(parent, is_first, &A, &noise, i);
    }
}

YK_INLINE void inward_link(const YkTreeRows *rows, Given given, YkTreeFound *link, YkTreeFound *parent, double *ok,
                           size_t n)
{
    if (!parent && rows->has_children)
        inward(rows, given, link, NULL, false, true, true, ok, n);
    else if (!parent)
        inward(rows, given, link, NULL, false, false, true, ok, n);
    else if (rows->is_first && rows->has_children)
        inward(rows, given, link, parent, true, true, true, ok, n);
    else if (rows->is_first)
        inward(rows, given, link, parent, true, false, true, ok, n);
    else if (rows->has_children)
        inward(rows, given, link, parent, true, true, false, ok, n);
    else
        inward(rows, given, link, parent, true, false, false, ok, n);
}

// Computes the acceleration of the coordinate from that of the parent's pin and turning (none: gx, gy is gravity,
// against which the ground accelerates, so that it acts on every mass). If the result is not a number, no inertia
// resisted.
YK_INLINE void outward(YkTreeFound *link, const YkTreeFound *parent, bool has_parent, const double *gx,
                       const double *gy, double sense, double *ok, double *out, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        YkVec on = yk_vec(link->on_x[i], link->on_y[i]), a = yk_vec(-gx[i], -gy[i]);
        double alpha = 0, own;
        if (has_parent) {
            a = yk_vec(parent->pin_x[i], parent->pin_y[i]);
            alpha = parent->alpha[i];
            own = (link->by[i] - yk_dot(on, a)) - link->turn[i] * alpha;
            a = yk_add(yk_add(a, yk_vec(link->bias_x[i], link->bias_y[i])),
                       yk_scale(alpha, yk_vec(link->across_x[i], link->across_y[i])));
        } else {
            own = link->by[i] - yk_dot(on, a);
        }
        double found = sense * (own - alpha), zero = found - found;
        ok[i] = ((zero == 0) | (ok[i] < 0)) ? ok[i] : 0;
        out[i] = found;
        link->pin_x[i] = a.x;
        link->pin_y[i] = a.y;
        link->alpha[i] = own;
    }
}

// Returns whether a row contains only numbers of reasonable size: in bits, where NaN lies above all numbers.
YK_INLINE bool fits(const double *value, size_t n)
{
    const uint64_t most = bits_of(1e100);
    uint64_t beyond = 0;
#pragma GCC unroll 4
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) beyond |= most - (bits_of(value[i]) & ~YK_SIGN_BIT);
    return beyond >> 63 == 0;
}

YK_APART void mark_row(const double *value, double *ok, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!(fabs(value[i]) <= 1e100)) ok[i] = -1;
}

// Returns whether all rows fit.
YK_INLINE bool check_rows(const YkTreeLanes *tree, double *ok, size_t at, size_t n)
{
    bool all_fit = true;
    for (size_t k = 0; k < tree->checked_count; k++) {
        if (fits(tree->checked[k] + at, n)) continue;
        mark_row(tree->checked[k] + at, ok, n);
        all_fit = false;
    }
    return all_fit;
}

YK_INLINE bool all_well(const double *ok, size_t n)
{
    uint64_t bad = 0;
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) bad |= ok[i] > 0 ? 0u : 1u;
    return bad == 0;
}

YK_APART void mask(const YkTreeLanes *tree, const double *ok, size_t at, size_t n)
{
    for (size_t k = 0; k < tree->link_count; k++)
        for (size_t i = 0; i < n; i++)
            if (!(ok[i] > 0)) tree->link[k].a[at + i] = 0;
}

// Computes the states from `at` on, at most YK_TREE_LANES.
YK_INLINE bool few(const YkTreeLanes *tree, double *ok, size_t at, size_t n)
{
    const double *gx = tree->gravity[0] + at, *gy = tree->gravity[1] + at;
    check_rows(tree, ok, at, n);
    for (size_t k = 0; k < tree->link_count; k++) {
        const YkTreeRows *link = &tree->link[k];
        if (link->parent < 0)
            find_turn(&tree->found[k], NULL, false, link->q + at, link->v + at, link->sense, n);
        else
            find_turn(&tree->found[k], &tree->found[link->parent], true, link->q + at, link->v + at, link->sense, n);
    }
    for (size_t k = tree->link_count; k-- > 0;) {
        const YkTreeRows *link = &tree->link[k];
        YkTreeFound *parent = link->parent < 0 ? NULL : &tree->found[link->parent];
        inward_link(link, given_of(link, at), &tree->found[k], parent, ok, n);
    }
    for (size_t k = 0; k < tree->link_count; k++) {
        const YkTreeRows *link = &tree->link[k];
        if (link->parent < 0)
            outward(&tree->found[k], NULL, false, gx, gy, link->sense, ok, link->a + at, n);
        else
            outward(&tree->found[k], &tree->found[link->parent], true, gx, gy, link->sense, ok, link->a + at, n);
    }
    return all_well(ok, n);
}

// One copy for all instruction sets.
YK_APART void repeat_far(const YkTreeLanes *tree, double *ok, bool *bad, size_t n)
{
    for (size_t i = 0; i < n; i++) ok[i] = ok[i] < 0 ? -1 : 1;
    chain_choose(tree, CHAIN_FAR, ok, bad, n);
}

// Repeats the states of two links that no inertia seems to resist: the product of both may be no number.
YK_APART void repeat_singular(const YkTreeLanes *tree, double *ok, bool *bad, size_t n)
{
    bool one_bad;
    for (size_t i = 0; i < n; i++)
        if (ok[i] == 0) chain_lanes(tree, 2, YK_AXIS_NONE, false, CHAIN_LINKS, ok, &one_bad, i, i + 1);
    *bad = !all_well(ok, n);
}

// Rows are checked last: they are then in the cache, while the pass before waits for memory as it computes.
YK_INLINE void yk_lanes_chain_body(bool *well, const YkTreeLanes *tree, double *ok, size_t n)
{
    bool bad;
    if (sincos_is_far(chain_choose(tree, CHAIN_NEAR, ok, &bad, n))) repeat_far(tree, ok, &bad, n);
    if (bad && tree->link_count == 2) repeat_singular(tree, ok, &bad, n);
    bad |= !check_rows(tree, ok, 0, n);
    if (bad) mask(tree, ok, 0, n);
    *well = !bad;
}
YK_KERNEL(yk_lanes_chain, (bool *well, const YkTreeLanes *tree, double *ok, size_t n), (well, tree, ok))

YK_INLINE void yk_lanes_tree_body(bool *well, const YkTreeLanes *tree, double *ok, size_t n)
{
    *well = true;
    for (size_t at = 0; at < n; at += YK_TREE_LANES) {
        size_t count = n - at < YK_TREE_LANES ? n - at : YK_TREE_LANES;
        bool are_well = count == YK_TREE_LANES ? few(tree, ok + at, at, YK_TREE_LANES) : few(tree, ok + at, at, count);
        if (!are_well) mask(tree, ok + at, at, count);
        *well &= are_well;
    }
}
YK_KERNEL(yk_lanes_tree, (bool *well, const YkTreeLanes *tree, double *ok, size_t n), (well, tree, ok))

YK_INLINE void yk_lanes_tree_part_body(double *row, const double *value, double sign, bool adds, size_t n)
{
    if (adds) {
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++) row[i] += sign * value[i];
    } else {
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++) row[i] = sign * value[i];
    }
}
YK_KERNEL(yk_lanes_tree_part, (double *row, const double *value, double sign, bool adds, size_t n),
          (row, value, sign, adds))
