// Distinguishes the branches of a dyad by an angle whose sine has the determinant's sign, with its rate and
// acceleration at a pose: the angle between its two columns. For an RPR it is another angle, since its columns swap
// sides abruptly where the point passes the pin: its determinant r is a length, and the angle's tangent is r over the
// machine's size.
#include "simulate/crossing.h"

static YkDirection of_plane(YkPlane p)
{
    double x = p.x[0], y = p.y[0], vx = p.vx[0], vy = p.vy[0], r2 = x * x + y * y;
    double rate = (x * vy - y * vx) / r2;
    return (YkDirection){yk_atan2(y, x), rate, (x * p.ay[0] - y * p.ax[0]) / r2 - 2 * (x * vx + y * vy) / r2 * rate};
}

static YkDirection turned(YkDirection d, const YkSpace *space, int32_t slot)
{
    if (slot == 0) return d;
    YkTurn t = yk_space_turn(space, slot);
    return (YkDirection){d.angle + yk_atan2(t.s[0], t.c[0]), d.rate + t.w[0], d.acceleration + t.a[0]};
}

static YkDirection of_vector(YkVec v)
{
    return (YkDirection){yk_atan2(v.y, v.x), 0, 0};
}

static YkDirection of_sum(const YkRun *run, const YkSum *sum)
{
    YkPlane p = yk_space_scratch(run->space, YK_SCRATCH_ARM_1);
    yk_run_sum(run, sum, p);
    return of_plane(p);
}

static YkDirection of_arm(const YkRun *run, const YkBlock *b, int k)
{
    YkDirection d = b->arm_is_constant[k] ? of_vector(b->aside->arm[k].constant) : of_sum(run, &b->aside->arm[k]);
    return turned(d, run->space, b->column[b->kind == YK_BLOCK_RRR ? k : 0].index);
}

// Uses r = dot(e, p), p = -K.
static YkDirection of_root(const YkRun *run, const YkBlock *b)
{
    YkPlane K = yk_space_scratch(run->space, YK_SCRATCH_KNOWN);
    YkDirection line =
        turned(turned(of_vector(b->line[0]), run->space, b->line_slot[0]), run->space, b->column[0].index);
    double size = run->mech->size, w = line.rate;
    YkVec e = yk_unit(line.angle), ie = yk_quarter(e);
    yk_run_sum(run, &b->known, K);
    YkVec p = yk_vec(-K.x[0], -K.y[0]), v = yk_vec(-K.vx[0], -K.vy[0]), a = yk_vec(-K.ax[0], -K.ay[0]);
    double r = yk_dot(e, p), rate = yk_dot(e, v) + w * yk_dot(ie, p);
    double accel = yk_dot(e, a) + 2 * w * yk_dot(ie, v) + line.acceleration * yk_dot(ie, p) - w * w * r;
    double per = size / (size * size + r * r), turn = per * rate;
    return (YkDirection){yk_atan2(r, size), turn, per * accel - 2 * r / size * turn * turn};
}

YkDirection yk_between_columns(const YkRun *run, const YkBlock *b)
{
    YkDirection one, two;
    if (b->kind == YK_BLOCK_RPR) return of_root(run, b);
    if (b->kind == YK_BLOCK_RRR) {
        one = of_arm(run, b, 0);
        two = of_arm(run, b, 1);
    } else {
        one = turned(of_vector(b->line[0]), run->space, b->line_slot[0]);
        two = of_arm(run, b, 0);
        two.angle += YK_PI / 2;
    }
    return (YkDirection){yk_nearest_turn(two.angle - one.angle, 0), two.rate - one.rate,
                         two.acceleration - one.acceleration};
}
