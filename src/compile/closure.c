// Residuals of the tree's loops and relations, their Jacobian, and guesses of the variables.
#include "compile/closure.h"
#include <math.h>
#include <string.h>
#include "law/law.h"

static void add_entry(double *J, size_t n, size_t column, YkVec entry)
{
    J[column] += entry.x;
    J[n + column] += entry.y;
}

void yk_closure_loop(const YkMechanism *mech, size_t loop, const double *x, double *residual, double *J, size_t n,
                     const int32_t *column)
{
    const YkSum *sum = &mech->loops[loop].sum;
    size_t o = mech->orientation_count - 1;
    YkVec total = sum->constant;
    for (uint32_t k = 0; k < sum->count; k++) {
        YkTerm t = mech->terms[sum->first + k];
        size_t turning = (size_t)t.slot - 1, sliding = o + (size_t)t.distance;
        double d = t.distance == YK_NONE ? 1 : x[sliding];
        YkVec turned = t.slot == 0 ? t.v : yk_mul(yk_unit(x[turning]), t.v);
        total = yk_add(total, yk_scale(d, turned));
        if (J && t.slot > 0)
            add_entry(J, n, column ? (size_t)column[turning] : turning, yk_scale(d, yk_quarter(turned)));
        if (J && t.distance != YK_NONE) add_entry(J, n, column ? (size_t)column[sliding] : sliding, turned);
    }
    residual[0] = total.x;
    residual[1] = total.y;
}

static size_t variable_of(const YkMechanism *mech, YkRelationTerm term)
{
    return term.is_distance ? mech->orientation_count - 1 + (size_t)term.index : (size_t)term.index - 1;
}

void yk_closure_relation(const YkMechanism *mech, size_t relation, const double *x, double *residual, double *J,
                         const int32_t *column)
{
    const YkRelation *r = &mech->relations[relation];
    const YkRelationTerm *terms = mech->relation_terms + r->first_term,
                         *arguments = mech->relation_terms + r->first_argument;
    double weight = yk_relation_weight(mech, r), argument = r->argument_constant, sum = -r->constant,
           law[YK_LAW_ORDER + 1] = {0};
    for (uint32_t k = 0; k < r->argument_count; k++)
        argument += arguments[k].factor * x[variable_of(mech, arguments[k])];
    if (r->law) yk_law_eval(r->law, argument, law);
    for (uint32_t k = 0; k < r->term_count; k++) {
        size_t v = variable_of(mech, terms[k]);
        sum += terms[k].factor * x[v];
        if (J) J[column ? (size_t)column[v] : v] += weight * terms[k].factor;
    }
    for (uint32_t k = 0; J && k < r->argument_count; k++) {
        size_t v = variable_of(mech, arguments[k]);
        J[column ? (size_t)column[v] : v] -= weight * law[1] * arguments[k].factor;
    }
    *residual = weight * (sum - law[0]);
}

void yk_closure(const YkMechanism *mech, const double *x, double *residual, double *jacobian)
{
    size_t n = yk_variable_count(mech);
    if (jacobian) memset(jacobian, 0, 2 * mech->loop_count * n * sizeof *jacobian);
    for (size_t l = 0; l < mech->loop_count; l++)
        yk_closure_loop(mech, l, x, residual + 2 * l, jacobian ? jacobian + 2 * l * n : NULL, n, NULL);
}

YkJointAngle yk_joint_angle(const YkMechanism *mech, int32_t joint)
{
    const YkJoint *j = &mech->model->joints[joint];
    const YkPlacing *a = &mech->bodies[j->body[0]], *b = &mech->bodies[j->body[1]];
    return (YkJointAngle){a->orientation, b->orientation, b->turn - a->turn};
}

// Guesses an orientation's angle from its first body that the tree reaches: the angle of the body before, turned by the
// joint.
static void guess_orientation(const YkMechanism *mech, int32_t body, const double *coordinates, double *x)
{
    int32_t joint = mech->tree.joint[body], to = mech->bodies[body].orientation;
    if (to == 0 || !isnan(x[to - 1])) return;
    int32_t from = mech->bodies[mech->tree.parent[body]].orientation, c = yk_tree_coordinate(mech, joint, false);
    YkJointAngle angle = yk_joint_angle(mech, joint);
    double turn = c == YK_NONE ? 0 : coordinates[c] - angle.offset;
    x[to - 1] = (from == 0 ? 0 : x[from - 1]) + (angle.a == from ? turn : -turn);
}

// Guesses the distance of a joint that closes a loop: it is not a coordinate and appears in no other loop, so it takes
// the value at which its loop comes nearest to closing.
static void guess_closing_distance(const YkMechanism *mech, size_t loop, double *x)
{
    const YkSum *sum = &mech->loops[loop].sum;
    int32_t d = mech->joint_distance[mech->loops[loop].joint];
    if (d == YK_NONE) return;
    YkVec line = {0, 0};
    double miss[2], *own = &x[mech->orientation_count - 1 + (size_t)d];
    for (uint32_t k = 0; k < sum->count; k++) {
        YkTerm t = mech->terms[sum->first + k];
        if (t.distance == d) line = yk_add(line, t.slot == 0 ? t.v : yk_mul(yk_unit(x[t.slot - 1]), t.v));
    }
    *own = 0;
    yk_closure_loop(mech, loop, x, miss, NULL, 0, NULL);
    double square = yk_dot(line, line);
    if (square > 0) *own = -yk_dot(yk_vec(miss[0], miss[1]), line) / square;
}

void yk_closure_guess(const YkMechanism *mech, const double *coordinates, double *x)
{
    size_t o = mech->orientation_count - 1;
    for (size_t k = 0; k < o; k++) x[k] = NAN;
    for (size_t d = 0; d < mech->distance_count; d++) x[o + d] = 0;
    for (size_t k = 0; k < mech->model->body_count; k++) guess_orientation(mech, mech->tree_order[k], coordinates, x);
    for (size_t k = 0; k < mech->coordinate_count; k++)
        if (mech->coordinates[k].is_distance) x[o + (size_t)mech->coordinates[k].distance] = coordinates[k];
    for (size_t l = 0; l < mech->loop_count; l++) guess_closing_distance(mech, l, x);
}
