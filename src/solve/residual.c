// How well a pose closes, measured in the loops of the tree from the answers themselves: independent of the steps that
// solved it.
#include "solve/state.h"

typedef struct Angle {
    YkVec e;
    double w, a;
} Angle;

static Angle angle_of(const YkState *s, int32_t slot)
{
    if (slot == 0) return (Angle){{1, 0}, 0, 0};
    YkTurn t = yk_space_turn(&s->space, slot);
    return (Angle){{t.c[0], t.s[0]}, t.w[0], t.a[0]};
}

// Sum and sum of sizes of one loop, of order 0, 1, 2.
static void loop_sums(const YkState *s, const YkSum *sum, YkVec total[3], double scale[3])
{
    total[0] = sum->constant;
    total[1] = total[2] = yk_vec(0, 0);
    for (uint32_t k = 0; k < sum->count; k++) {
        YkTerm term = s->mech->terms[sum->first + k];
        Angle t = angle_of(s, term.slot);
        YkVec v = yk_mul(t.e, term.v), iv = yk_quarter(v);
        double d = 1, dv = 0, da = 0;
        if (term.distance != YK_NONE) {
            YkSlide slide = yk_space_slide(&s->space, term.distance);
            d = slide.d[0];
            dv = slide.v[0];
            da = slide.a[0];
        }
        YkVec rate = yk_add(yk_scale(dv, v), yk_scale(d * t.w, iv));
        YkVec accel = yk_add(yk_scale(da - d * t.w * t.w, v), yk_scale(d * t.a + 2 * dv * t.w, iv));
        total[0] = yk_add(total[0], yk_scale(d, v));
        total[1] = yk_add(total[1], rate);
        total[2] = yk_add(total[2], accel);
        scale[1] = fmax(scale[1], yk_norm(rate));
        scale[2] = fmax(scale[2], yk_norm(accel) + fabs(d) * t.w * t.w * yk_norm(v) + fabs(2 * dv * t.w) * yk_norm(v));
    }
}

YkResiduals yk_state_residuals(const YkState *s)
{
    double worst[3] = {0, 0, 0}, scale[3] = {s->mech->size, 0, 0};
    for (size_t l = 0; l < s->mech->loop_count; l++) {
        YkVec total[3];
        loop_sums(s, &s->mech->loops[l].sum, total, scale);
        for (int k = 0; k < 3; k++) worst[k] = fmax(worst[k], yk_norm(total[k]));
    }
    for (int k = 0; k < 3; k++) worst[k] = scale[k] > 0 ? worst[k] / scale[k] : 0;
    if (!s->has_rates) worst[1] = worst[2] = 0;
    return (YkResiduals){worst[0], worst[1], worst[2]};
}
