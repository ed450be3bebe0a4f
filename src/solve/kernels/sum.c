// Sums of vectors: the known part of a loop and the positions of points, with their rates and accelerations.
#include "solve/kernels/term.h"

// Writes one lane or, if `adds`, adds to it.
YK_INLINE void put(YkPlane out, bool adds, size_t i, Known term)
{
    out.x[i] = adds ? out.x[i] + term.place.x : term.place.x;
    out.y[i] = adds ? out.y[i] + term.place.y : term.place.y;
    out.vx[i] = adds ? out.vx[i] + term.rate.x : term.rate.x;
    out.vy[i] = adds ? out.vy[i] + term.rate.y : term.rate.y;
    out.ax[i] = adds ? out.ax[i] + term.accel.x : term.accel.x;
    out.ay[i] = adds ? out.ay[i] + term.accel.y : term.accel.y;
}

// Computes out = constant + plus - minus, for one of the six rows; absent rows are NULL.
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
        Known term = term_turned(lane_turning(turn, i), v, axial);
        if (!adds) term.place = yk_add(constant, term.place);
        put(out, adds, i, term);
    }
}

YK_INLINE void yk_lanes_start_turn_body(YkPlane out, YkVec constant, YkTurn turn, YkVec v, size_t n)
{
    const YkPlane none = {0};
    if (turn.c && yk_is_axial(v))
        sum_turn(out, false, constant, turn, v, true, n);
    else if (turn.c)
        sum_turn(out, false, constant, turn, v, false, n);
    else
        yk_lanes_start(out, yk_add(constant, v), none, none, n);
}
YK_KERNEL(yk_lanes_start_turn, (YkPlane out, YkVec constant, YkTurn turn, YkVec v, size_t n), (out, constant, turn, v))

YK_INLINE void yk_lanes_add_turn_body(YkPlane out, YkTurn turn, YkVec v, size_t n)
{
    if (yk_is_axial(v))
        sum_turn(out, true, yk_vec(0, 0), turn, v, true, n);
    else
        sum_turn(out, true, yk_vec(0, 0), turn, v, false, n);
}
YK_KERNEL(yk_lanes_add_turn, (YkPlane out, YkTurn turn, YkVec v, size_t n), (out, turn, v))

YK_INLINE void add_slide(YkPlane out, YkTurn turn, bool turns, YkVec v, YkSlide slide, size_t n)
{
    YK_EACH_LANE
    for (size_t i = 0; i < n; i++) {
        Line none = {{1, 0}, 0, 0};
        put(out, true, i,
            term_sliding(turns ? lane_turning(turn, i) : none, turns, v, slide.d[i], slide.v[i], slide.a[i]));
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
