#include "dynamics/kernels_tree.h"
#include "dynamics/tree_articulated.h"
#include "solve/lanes.h"

YK_INLINE void yk_lanes_tree_angle_body(double *const *link, double *const *parent, const double *q, const double *v,
                                        double sense, size_t n)
{
    double *angle = link[YK_ROW_ANGLE], *w = link[YK_ROW_W];
    const double *before = parent ? parent[YK_ROW_ANGLE] : NULL, *rate = parent ? parent[YK_ROW_W] : NULL;
    if (!parent) {
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++) angle[i] = sense * q[i], w[i] = sense * v[i];
    } else {
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++) angle[i] = before[i] + sense * q[i], w[i] = rate[i] + sense * v[i];
    }
    yk_sincos_lanes(angle, link[YK_ROW_S], link[YK_ROW_C], n);
}
YK_KERNEL(yk_lanes_tree_angle,
          (double *const *link, double *const *parent, const double *q, const double *v, double sense, size_t n),
          (link, parent, q, v, sense))

// What the children showed, and the link itself: all about its pin.
YK_INLINE YkArticulated whole_link(double *const *r, bool has_children, YkVec e, double w, size_t i)
{
    YkArticulated A = {0};
    YkVec center = yk_vec(r[YK_ROW_CENTER_X][i], r[YK_ROW_CENTER_Y][i]);
    double mass = r[YK_ROW_MASS][i];
    if (has_children) {
        A = (YkArticulated){
            r[YK_ROW_J][i],  yk_vec(r[YK_ROW_H_X][i], r[YK_ROW_H_Y][i]), r[YK_ROW_XX][i], r[YK_ROW_XY][i],
            r[YK_ROW_YY][i], yk_vec(r[YK_ROW_F_X][i], r[YK_ROW_F_Y][i]), r[YK_ROW_N][i]};
    }
    yk_articulated_add_body(&A, mass, yk_mul(e, yk_scale(mass, center)),
                            r[YK_ROW_INERTIA][i] + mass * yk_dot(center, center), w);
    return A;
}

YK_INLINE void hand_over(double *const *p, bool is_first, const YkArticulated *A, size_t i)
{
    const double value[] = {A->J, A->h.x, A->h.y, A->xx, A->xy, A->yy, A->f.x, A->f.y, A->n};
    for (int k = 0; k < 9; k++) p[YK_ROW_J + k][i] = is_first ? value[k] : p[YK_ROW_J + k][i] + value[k];
}

YK_INLINE void inward_loop(double *const *r, double *const *p, bool has_parent, bool has_children, bool is_first,
                           const double *torque, double sense, double *ok, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        double mass = r[YK_ROW_MASS][i], w = r[YK_ROW_W][i];
        YkVec e = yk_vec(r[YK_ROW_C][i], r[YK_ROW_S][i]), center = yk_vec(r[YK_ROW_CENTER_X][i], r[YK_ROW_CENTER_Y][i]);
        YkArticulated A = whole_link(r, has_children, e, w, i);
        // what stands behind the pin: see tree_pins.c
        double behind = r[YK_ROW_INERTIA][i] + mass * yk_dot(center, center) + (has_children ? r[YK_ROW_LEAST][i] : 0);
        double out = mass + (has_children ? r[YK_ROW_MASS_OUT][i] : 0);
        ok[i] = A.J > YK_LEAST_PIVOT * behind || ok[i] < 0 ? ok[i] : 0;
        YkAnswer answer = yk_articulated_release_turn(&A, torque ? sense * torque[i] : 0);
        r[YK_ROW_ON_X][i] = answer.on.x;
        r[YK_ROW_ON_Y][i] = answer.on.y;
        if (!has_parent) {
            r[YK_ROW_BY][i] = answer.by;
            continue;
        }
        YkVec at = yk_vec(r[YK_ROW_AT_X][i], r[YK_ROW_AT_Y][i]);
        YkVec arm = yk_mul(yk_vec(p[YK_ROW_C][i], p[YK_ROW_S][i]), at);
        YkVec bias = yk_scale(-p[YK_ROW_W][i] * p[YK_ROW_W][i], arm), across = yk_quarter(arm);
        r[YK_ROW_BY][i] = answer.by - yk_dot(answer.on, bias);
        r[YK_ROW_TURN][i] = yk_dot(answer.on, across);
        r[YK_ROW_BIAS_X][i] = bias.x;
        r[YK_ROW_BIAS_Y][i] = bias.y;
        r[YK_ROW_ACROSS_X][i] = across.x;
        r[YK_ROW_ACROSS_Y][i] = across.y;
        A = yk_articulated_move_force(&A, arm, bias);
        hand_over(p, is_first, &A, i);
        double least = out * yk_dot(at, at);
        p[YK_ROW_LEAST][i] = is_first ? least : p[YK_ROW_LEAST][i] + least;
        p[YK_ROW_MASS_OUT][i] = is_first ? out : p[YK_ROW_MASS_OUT][i] + out;
    }
}

YK_INLINE void yk_lanes_tree_inward_body(double *const *link, double *const *parent, bool has_children, bool is_first,
                                         const double *torque, double sense, double *ok, size_t n)
{
    // the rows as locals: they are not read again in the loop
    double *r[YK_ROW_COUNT], *p[YK_ROW_COUNT];
    for (int k = 0; k < YK_ROW_COUNT; k++) r[k] = link[k], p[k] = parent ? parent[k] : NULL;
    if (!parent && has_children)
        inward_loop(r, p, false, true, true, torque, sense, ok, n);
    else if (!parent)
        inward_loop(r, p, false, false, true, torque, sense, ok, n);
    else if (is_first && has_children)
        inward_loop(r, p, true, true, true, torque, sense, ok, n);
    else if (is_first)
        inward_loop(r, p, true, false, true, torque, sense, ok, n);
    else
        inward_loop(r, p, true, has_children, false, torque, sense, ok, n);
}
YK_KERNEL(yk_lanes_tree_inward,
          (double *const *link, double *const *parent, bool has_children, bool is_first, const double *torque,
           double sense, double *ok, size_t n),
          (link, parent, has_children, is_first, torque, sense, ok))

YK_INLINE void outward_loop(double *const *r, double *const *p, bool has_parent, const double *gx, const double *gy,
                            double sense, double *out, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        YkVec on = yk_vec(r[YK_ROW_ON_X][i], r[YK_ROW_ON_Y][i]), a;
        double alpha = 0, own;
        if (has_parent) {
            a = yk_vec(p[YK_ROW_F_X][i], p[YK_ROW_F_Y][i]);
            alpha = p[YK_ROW_N][i];
            own = (r[YK_ROW_BY][i] - yk_dot(on, a)) - r[YK_ROW_TURN][i] * alpha;
            a = yk_add(yk_add(a, yk_vec(r[YK_ROW_BIAS_X][i], r[YK_ROW_BIAS_Y][i])),
                       yk_scale(alpha, yk_vec(r[YK_ROW_ACROSS_X][i], r[YK_ROW_ACROSS_Y][i])));
        } else { // the ground accelerates against gravity, which so acts on every mass
            a = yk_vec(-gx[i], -gy[i]);
            own = r[YK_ROW_BY][i] - yk_dot(on, a);
        }
        out[i] = sense * (own - alpha);
        r[YK_ROW_F_X][i] = a.x;
        r[YK_ROW_F_Y][i] = a.y;
        r[YK_ROW_N][i] = own;
    }
}

YK_INLINE void yk_lanes_tree_outward_body(double *const *link, double *const *parent, const double *gx,
                                          const double *gy, double sense, double *a, size_t n)
{
    double *r[YK_ROW_COUNT], *p[YK_ROW_COUNT];
    for (int k = 0; k < YK_ROW_COUNT; k++) r[k] = link[k], p[k] = parent ? parent[k] : NULL;
    if (parent)
        outward_loop(r, p, true, gx, gy, sense, a, n);
    else
        outward_loop(r, p, false, gx, gy, sense, a, n);
}
YK_KERNEL(yk_lanes_tree_outward,
          (double *const *link, double *const *parent, const double *gx, const double *gy, double sense, double *a,
           size_t n),
          (link, parent, gx, gy, sense, a))

YK_INLINE void yk_lanes_tree_check_body(double *const *link, bool has_mass, double *ok, size_t n)
{
    const double *mass = link[YK_ROW_MASS], *inertia = link[YK_ROW_INERTIA];
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        bool good = (!has_mass || mass[i] > 0) && inertia[i] >= 0;
        ok[i] = good ? ok[i] : -1;
    }
}
YK_KERNEL(yk_lanes_tree_check, (double *const *link, bool has_mass, double *ok, size_t n), (link, has_mass, ok))

YK_INLINE void yk_lanes_tree_fits_body(const double *value, double *ok, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) ok[i] = fabs(value[i]) <= 1e100 ? ok[i] : -1;
}
YK_KERNEL(yk_lanes_tree_fits, (const double *value, double *ok, size_t n), (value, ok))

YK_INLINE void yk_lanes_tree_mask_body(double *a, double *ok, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        double x = a[i];
        ok[i] = x - x == 0 ? ok[i] : (ok[i] < 0 ? ok[i] : 0);
        a[i] = ok[i] > 0 ? x : 0;
    }
}
YK_KERNEL(yk_lanes_tree_mask, (double *a, double *ok, size_t n), (a, ok))
