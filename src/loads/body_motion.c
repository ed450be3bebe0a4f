// Reads the positions and motions of bodies from a space.
#include "loads/loads.h"
#include "solve/run.h"

YkVec yk_reference_point(const YkModel *model, size_t body)
{
    const YkBody *b = &model->bodies[body];
    return b->has_mass ? b->center : yk_vec(0, 0);
}

YkBodyMotion yk_body_motion(const YkMechanism *mech, const YkSpace *space, size_t body)
{
    double x[6];
    YkRun run = {.mech = mech, .space = space, .lanes = 1};
    const YkPlacing *placing = &mech->bodies[body];
    YkBodyMotion m = {.e = placing->turn_unit};
    yk_run_sum(&run, &placing->origin, (YkPlane){x, x + 1, x + 2, x + 3, x + 4, x + 5});
    if (placing->orientation != 0) {
        YkTurn turn = yk_space_turn(space, placing->orientation);
        m.e = yk_mul(yk_vec(turn.c[0], turn.s[0]), placing->turn_unit);
        m.w = turn.w[0];
        m.a = turn.a[0];
    }
    YkVec arm = yk_mul(m.e, yk_reference_point(mech->model, body)), across = yk_quarter(arm);
    m.at = yk_add(yk_vec(x[0], x[1]), arm);
    m.velocity = yk_add(yk_vec(x[2], x[3]), yk_scale(m.w, across));
    m.acceleration = yk_add(yk_vec(x[4], x[5]), yk_sub(yk_scale(m.a, across), yk_scale(m.w * m.w, arm)));
    return m;
}
