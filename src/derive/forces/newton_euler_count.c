// Counts equations and unknowns as a textbook does.
//
// Every moving body has two force equations and a moment equation, a junction two force equations; what closes loops
// gives equations between accelerations. A body whose forces all meet in its centre of mass has a trivial moment
// equation - its guide's moment is 0 - and both are left out.
#include "derive/forces/free_bodies.h"

static size_t count_closing(YkDerivation *d)
{
    size_t count = d->mech->relation_count;
    const YkDeriveLoop *loops = yk_derive_loops(d);
    for (size_t k = 0; loops && k < d->loop_count; k++)
        count += (d->joint_distance[loops[k].joint] != YK_NONE ? 1u : 2u) + (loops[k].angle != NULL);
    return count;
}

YkEquationCount yk_derive_count(const YkDeriveForces *f, bool all_given)
{
    YkDerivation *d = f->d;
    YkEquationCount c = {.unknown_reactions = f->reaction_count, .unknown_accelerations = d->tree_count};
    c.force = 2 * (d->model->body_count - d->model->carriage_count - 1 + f->junction_count);
    for (size_t b = 1; b < d->model->body_count - d->model->carriage_count; b++) {
        if (f->bodies[b].is_trivial)
            c.unknown_reactions--;
        else
            c.moment++;
    }
    c.acceleration = count_closing(d);
    size_t given = f->effort_count;
    for (size_t k = 0; k < d->tree_count && all_given; k++) given += d->coordinates[k].is_input;
    if (all_given) given -= f->effort_count;
    c.unknown_accelerations -= given;
    c.unknown_efforts = given;
    return c;
}
