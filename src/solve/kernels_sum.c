// Sums of vectors: the known part of a loop and the places of points, with their rates and accelerations.
#include "solve/lanes.h"

// Writes or, where `adds`, adds one lane.
YK_INLINE void put(YkPlane out, bool adds, size_t i, YkVec place, YkVec rate, YkVec accel)
{
    out.x[i] = adds ? out.x[i] + place.x : place.x;
    out.y[i] = adds ? out.y[i] + place.y : place.y;
    out.vx[i] = adds ? out.vx[i] + rate.x : rate.x;
    out.vy[i] = adds ? out.vy[i] + rate.y : rate.y;
    out.ax[i] = adds ? out.ax[i] + accel.x : accel.x;
    out.ay[i] = adds ? out.ay[i] + accel.y : accel.y;
}

// z = v e^(i phi): z' = i w z, z'' = (i a - w^2) z.
YK_INLINE YkVec spin_rate(YkVec z, double w)
{
    return yk_scale(w, yk_quarter(z));
}
YK_INLINE YkVec spin_accel(YkVec z, double w, double a)
{
    return yk_sub(yk_scale(a, yk_quarter(z)), yk_scale(w * w, z));
}

// out = constant + plus - minus, for one of the six rows; absent rows are NULL.
YK_INLINE void start_row(double *out, double constant, const double *plus, const double *minus, size_t n)
{
    if (plus && minus) {
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++) out[i] = constant + plus[i] - minus[i];
    } else if (plus) {
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++) out[i] = constant + plus[i];
    } else if (minus) {
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++) out[i] = constant - minus[i];
    } else {
        YK_EACH_LANE
        for (size_t i = 0; i < n; i++) out[i] = constant;
    }
}

void yk_lanes_start(YkPlane out, YkVec constant, YkPlane plus, YkPlane minus, size_t n)
{
    const YkPlane none = {0};
    YkPlane p = plus.x ? plus : none, m = minus.x ? minus : none;
    start_row(out.x, constant.x, p.x, m.x, n);
    start_row(out.y, constant.y, p.y, m.y, n);
    start_row(out.vx, 0, p.vx, m.vx, n);
    start_row(out.vy, 0, p.vy, m.vy, n);
    start_row(out.ax, 0, p.ax, m.ax, n);
    start_row(out.ay, 0, p.ay, m.ay, n);
}

YK_INLINE void sum_turn(YkPlane out, bool adds, YkVec constant, YkTurn turn, YkVec v, bool axial, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        YkVec z = times(lane_unit(turn, i), v, axial);
        put(out, adds, i, adds ? z : yk_add(constant, z), spin_rate(z, turn.w[i]), spin_accel(z, turn.w[i], turn.a[i]));
    }
}

YK_INLINE void yk_lanes_start_turn_body(YkPlane out, YkVec constant, YkTurn turn, YkVec v, size_t n)
{
    const YkPlane none = {0};
    if (turn.c && is_axial(v))
        sum_turn(out, false, constant, turn, v, true, n);
    else if (turn.c)
        sum_turn(out, false, constant, turn, v, false, n);
    else
        yk_lanes_start(out, yk_add(constant, v), none, none, n);
}
YK_KERNEL(yk_lanes_start_turn, (YkPlane out, YkVec constant, YkTurn turn, YkVec v, size_t n), (out, constant, turn, v))

YK_INLINE void yk_lanes_add_turn_body(YkPlane out, YkTurn turn, YkVec v, size_t n)
{
    if (is_axial(v))
        sum_turn(out, true, yk_vec(0, 0), turn, v, true, n);
    else
        sum_turn(out, true, yk_vec(0, 0), turn, v, false, n);
}
YK_KERNEL(yk_lanes_add_turn, (YkPlane out, YkTurn turn, YkVec v, size_t n), (out, turn, v))

// d z with z = v e^(i phi): d' z + d z', d'' z + 2 d' z' + d z''.
YK_INLINE void add_slide(YkPlane out, YkTurn turn, bool turns, YkVec v, YkSlide slide, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        double d = slide.d[i], rate = slide.v[i], accel = slide.a[i];
        YkVec z = turns ? yk_mul(lane_unit(turn, i), v) : v;
        YkVec velocity = yk_scale(rate, z), acceleration = yk_scale(accel, z);
        if (turns) {
            YkVec dz = spin_rate(z, turn.w[i]), ddz = spin_accel(z, turn.w[i], turn.a[i]);
            velocity = yk_add(velocity, yk_scale(d, dz));
            acceleration = yk_add(acceleration, yk_add(yk_scale(2 * rate, dz), yk_scale(d, ddz)));
        }
        put(out, true, i, yk_scale(d, z), velocity, acceleration);
    }
}

YK_INLINE void yk_lanes_add_slide_body(YkPlane out, YkTurn turn, YkVec v, YkSlide slide, size_t n)
{
    if (turn.c)
        add_slide(out, turn, true, v, slide, n);
    else
        add_slide(out, turn, false, v, slide, n);
}
YK_KERNEL(yk_lanes_add_slide, (YkPlane out, YkTurn turn, YkVec v, YkSlide slide, size_t n), (out, turn, v, slide))
