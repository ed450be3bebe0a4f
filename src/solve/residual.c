// Measures how well a pose closes, in the loops of the tree, in the relations and in the lengths of the bodies, from
// the answers themselves: independent of the steps that solved it.
#include "elementary/elementary.h"
#include "law/law.h"
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

// Computes the sum of one loop and the sum of its terms' magnitudes, of order 0, 1, 2; of order 0 alone without rates.
static void loop_sums(const YkState *s, const YkSum *sum, bool has_rates, YkVec total[3], double scale[3])
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
        total[0] = yk_add(total[0], yk_scale(d, v));
        if (!has_rates) continue;
        YkVec rate = yk_add(yk_scale(dv, v), yk_scale(d * t.w, iv));
        YkVec accel = yk_add(yk_scale(da - d * t.w * t.w, v), yk_scale(d * t.a + 2 * dv * t.w, iv));
        total[1] = yk_add(total[1], rate);
        total[2] = yk_add(total[2], accel);
        scale[1] = fmax(scale[1], yk_norm(rate));
        scale[2] = fmax(scale[2], yk_norm(accel) + fabs(d) * t.w * t.w * yk_norm(v) + fabs(2 * dv * t.w) * yk_norm(v));
    }
}

// --- relations

// Returns the motion of a relation's term: a distance, or an angle that adds up along the tree from the coordinates.
static YkMotion motion_of(const YkState *s, YkRelationTerm term)
{
    if (term.is_distance) {
        YkSlide d = yk_space_slide(&s->space, term.index);
        return (YkMotion){d.d[0], d.v[0], d.a[0]};
    }
    int32_t body = s->mech->orientation_body[term.index];
    YkMotion m = yk_state_body(s, (size_t)body);
    m.position -= s->mech->bodies[body].turn;
    return m;
}

static YkMotion sum_of(const YkState *s, uint32_t first, uint32_t count, double scale[3])
{
    YkMotion sum = {0, 0, 0};
    for (uint32_t k = first; k < first + count; k++) {
        YkRelationTerm term = s->mech->relation_terms[k];
        YkMotion m = motion_of(s, term);
        sum.position += term.factor * m.position;
        sum.velocity += term.factor * m.velocity;
        sum.acceleration += term.factor * m.acceleration;
        scale[0] += fabs(term.factor * m.position);
        scale[1] += fabs(term.factor * m.velocity);
        scale[2] += fabs(term.factor * m.acceleration);
    }
    return sum;
}

// Removes whole turns: angles are given nearest to a reference, and whole turns of any one of them close as well.
static double without_turns(const YkState *s, const YkRelation *r, double miss)
{
    double least = fabs(miss);
    for (uint32_t k = 0; k < r->term_count; k++) {
        YkRelationTerm term = s->mech->relation_terms[r->first_term + k];
        double turn = 2 * YK_PI * fabs(term.factor);
        if (!term.is_distance && turn > 0) least = fmin(least, fabs(miss - turn * rint(miss / turn)));
    }
    return least;
}

// Raises worst[] to the residual of the relation, a length; scale[] to the size of its parts.
static void relation_miss(const YkState *s, const YkRelation *r, double worst[3], double scale[3])
{
    double weight = yk_relation_weight(s->mech, r), own[3] = {fabs(r->constant), 0, 0}, turned[3] = {0, 0, 0},
           law[YK_LAW_ORDER + 1] = {0};
    YkMotion x = sum_of(s, r->first_term, r->term_count, own);
    if (r->law) {
        YkMotion a = sum_of(s, r->first_argument, r->argument_count, turned);
        yk_law_eval(r->law, r->argument_constant + a.position, law);
        x.position -= law[0];
        x.velocity -= law[1] * a.velocity;
        x.acceleration -= law[1] * a.acceleration + law[2] * a.velocity * a.velocity;
        own[1] += fabs(law[1] * a.velocity);
        own[2] += fabs(law[1]) * turned[2] + fabs(law[2] * a.velocity * a.velocity);
    }
    // The lost digits of angles that have made many turns are not the relation's error.
    double miss = fmax(0, without_turns(s, r, x.position - r->constant) - 1e-15 * (own[0] + fabs(law[1]) * turned[0]));
    const double misses[3] = {miss, fabs(x.velocity), fabs(x.acceleration)};
    for (int k = 0; k < 3; k++) {
        worst[k] = fmax(worst[k], weight * misses[k]);
        if (k > 0) scale[k] = fmax(scale[k], weight * own[k]);
    }
}

// Returns the relative error of a body's lengths, which is that of its unit vector.
static double stretch(const YkState *s)
{
    double most = 0;
    for (size_t o = 1; o < s->mech->slot_count; o++) {
        YkTurn t = yk_space_turn(&s->space, (int32_t)o);
        double off = fabs(yk_hypot(t.c[0], t.s[0]) - 1);
        most = off <= most ? most : off; // also for NaN
    }
    return most;
}

static YkResiduals measure(const YkState *s, bool has_rates)
{
    double worst[3] = {s->mech->size * stretch(s), 0, 0}, scale[3] = {s->mech->size, 0, 0};
    for (size_t l = 0; l < s->mech->loop_count; l++) {
        YkVec total[3];
        loop_sums(s, &s->mech->loops[l].sum, has_rates, total, scale);
        for (int k = 0; k < (has_rates ? 3 : 1); k++) worst[k] = fmax(worst[k], yk_norm(total[k]));
    }
    for (size_t r = 0; r < s->mech->relation_count; r++) relation_miss(s, &s->mech->relations[r], worst, scale);
    for (int k = 0; k < 3; k++) worst[k] = scale[k] > 0 ? worst[k] / scale[k] : 0;
    if (!has_rates) worst[1] = worst[2] = 0;
    return (YkResiduals){worst[0], worst[1], worst[2]};
}

YkResiduals yk_state_residuals(const YkState *s)
{
    return measure(s, s->has_rates);
}

double yk_state_gap(const YkState *s)
{
    return measure(s, false).position;
}
