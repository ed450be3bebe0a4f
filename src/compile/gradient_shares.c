// Hands the shares of an answer backwards: from sums of turned vectors to angles, distances, and points of the model.
#include "compile/closure.h"
#include "compile/gradient_inside.h"
#include "law/law.h"

bool yk_gradient_covers(const YkMechanism *mech, YkChannel c)
{
    if (c.kind <= YK_CHANNEL_POINT_SPEED) return true;
    if (c.kind != YK_CHANNEL_TRANSMISSION) return false;
    YkBlockKind kind = mech->blocks[c.index].kind;
    return kind == YK_BLOCK_RRR || kind == YK_BLOCK_RRP;
}

// --- angles and distances

// Returns the angle of a slot, or a derivative of it.
static double angle_of(const YkGradient *g, int32_t slot, size_t order)
{
    const double *x = g->x + order * g->variables;
    YkSlotAngle s = g->slot[slot];
    return (s.of > 0 ? x[s.of - 1] : 0) - (s.from > 0 ? x[s.from - 1] : 0);
}

static void take_angle(YkGradient *g, int32_t slot, size_t order, double by)
{
    double *at = g->by_x + order * g->variables;
    YkSlotAngle s = g->slot[slot];
    if (s.of > 0) at[s.of - 1] += by;
    if (s.from > 0) at[s.from - 1] -= by;
}

static double distance_of(const YkGradient *g, int32_t distance, size_t order)
{
    return g->x[order * g->variables + yk_gradient_variable(g, distance)];
}

static void take_distance(YkGradient *g, int32_t distance, size_t order, double by)
{
    g->by_x[order * g->variables + yk_gradient_variable(g, distance)] += by;
}

// --- terms

typedef struct Turned { // a term: w = e^(i angle) v as a jet, its factor, and the slot's rates
    YkVecJet w;
    double d[YK_JET], rate, accel;
} Turned;

static Turned turned(const YkGradient *g, const YkTerm *term)
{
    YkSlotTurn turn = g->turn[term->slot];
    Turned t = {.rate = turn.rate, .accel = turn.accel, .d = {1, 0, 0}};
    YkVec w = yk_mul(turn.unit, term->v), q = yk_quarter(w);
    t.w = (YkVecJet){{w, yk_scale(t.rate, q), yk_sub(yk_scale(t.accel, q), yk_scale(t.rate * t.rate, w))}};
    for (size_t k = 0; k < YK_JET && term->distance != YK_NONE; k++) t.d[k] = distance_of(g, term->distance, k);
    return t;
}

// Adds a term to a jet.
static void add_term(const YkGradient *g, const YkTerm *term, YkVecJet *sum)
{
    Turned t = turned(g, term);
    const YkVec *w = t.w.v;
    YkVec first = yk_add(yk_scale(t.d[1], w[0]), yk_scale(t.d[0], w[1]));
    YkVec second = yk_add(yk_scale(t.d[2], w[0]), yk_add(yk_scale(2 * t.d[1], w[1]), yk_scale(t.d[0], w[2])));
    sum->v[0] = yk_add(sum->v[0], yk_scale(t.d[0], w[0]));
    sum->v[1] = yk_add(sum->v[1], first);
    sum->v[2] = yk_add(sum->v[2], second);
}

// Takes the shares of a term, and returns that of its vector, in the axes of the slot.
static YkVec take_term(YkGradient *g, const YkTerm *term, const YkVecJet *by)
{
    Turned t = turned(g, term);
    const YkVec *w = t.w.v, *b = by->v;
    const YkVec at[YK_JET] = {
        yk_add(yk_scale(t.d[0], b[0]), yk_add(yk_scale(t.d[1], b[1]), yk_scale(t.d[2], b[2]))),
        yk_add(yk_scale(t.d[0], b[1]), yk_scale(2 * t.d[1], b[2])),
        yk_scale(t.d[0], b[2]),
    };
    if (term->distance != YK_NONE) {
        take_distance(g, term->distance, 0, yk_dot(b[0], w[0]) + yk_dot(b[1], w[1]) + yk_dot(b[2], w[2]));
        take_distance(g, term->distance, 1, yk_dot(b[1], w[0]) + 2 * yk_dot(b[2], w[1]));
        take_distance(g, term->distance, 2, yk_dot(b[2], w[0]));
    }
    YkVec q = yk_quarter(w[0]);
    double turning = yk_dot(at[2], q);
    take_angle(g, term->slot, 0,
               yk_dot(at[0], q) - t.rate * yk_dot(at[1], w[0]) - t.accel * yk_dot(at[2], w[0]) -
                   t.rate * t.rate * turning);
    take_angle(g, term->slot, 1, yk_dot(at[1], q) - 2 * t.rate * yk_dot(at[2], w[0]));
    take_angle(g, term->slot, 2, turning);
    // w' = i rate w, w'' = (i accel - rate^2) w: what they share goes back by the conjugates.
    YkVec back = yk_add(at[0], yk_scale(-t.rate, yk_quarter(at[1])));
    back = yk_sub(back, yk_add(yk_scale(t.accel, yk_quarter(at[2])), yk_scale(t.rate * t.rate, at[2])));
    return yk_mul(yk_conj(g->turn[term->slot].unit), back);
}

static void take_vector(YkGradient *g, int32_t node, YkVec by)
{
    g->at_vector[node] = yk_add(g->at_vector[node], by);
}

static void take_node(YkGradient *g, int32_t node, double sign, const YkVecJet *by)
{
    for (size_t k = 0; k < YK_JET && node != YK_NONE; k++)
        g->at_node[node].v[k] = yk_add(g->at_node[node].v[k], yk_scale(sign, by->v[k]));
}

void yk_gradient_take_sum(YkGradient *g, const YkSum *sum, const YkVecJet *by)
{
    take_vector(g, yk_recipe_constant(g->recipe, sum->first, sum->plus != YK_NONE), by->v[0]);
    take_node(g, sum->plus, 1, by);
    take_node(g, sum->minus, -1, by);
    for (uint32_t k = sum->first; k < sum->first + sum->count; k++) {
        YkVec own = take_term(g, &g->mech->terms[k], by);
        if (k < g->recipe->term_count) take_vector(g, g->recipe->of_term[k], own);
    }
}

static YkVecJet sum_of(const YkGradient *g, const YkSum *sum)
{
    YkVecJet jet = {{sum->constant}};
    const int32_t node[2] = {sum->plus, sum->minus};
    for (uint32_t k = sum->first; k < sum->first + sum->count; k++) add_term(g, &g->mech->terms[k], &jet);
    for (size_t i = 0; i < 2; i++) {
        if (node[i] == YK_NONE) continue;
        const YkVecJet *other = &g->node[node[i]];
        for (size_t k = 0; k < YK_JET; k++) jet.v[k] = yk_add(jet.v[k], yk_scale(i == 0 ? 1 : -1, other->v[k]));
    }
    return jet;
}

void yk_gradient_place(YkGradient *g)
{
    for (size_t k = 0; k < g->mech->slot_count; k++)
        g->turn[k] =
            (YkSlotTurn){yk_unit(angle_of(g, (int32_t)k, 0)), angle_of(g, (int32_t)k, 1), angle_of(g, (int32_t)k, 2)};
    for (size_t k = 0; k < g->mech->node_count; k++) g->node[k] = sum_of(g, &g->mech->node_sums[k]);
}

void yk_gradient_settle_nodes(YkGradient *g)
{
    for (size_t k = g->mech->node_count; k-- > 0;) { // each is made of those before it
        YkVecJet by = g->at_node[k];
        bool has_some = false;
        for (size_t i = 0; i < YK_JET; i++) has_some |= by.v[i].x != 0 || by.v[i].y != 0;
        if (has_some) yk_gradient_take_sum(g, &g->mech->node_sums[k], &by);
    }
}

void yk_gradient_settle_vectors(YkGradient *g)
{
    for (size_t k = g->recipe->node_count; k-- > 1;) {
        const YkRecipeNode *node = &g->recipe->nodes[k];
        YkVec by = g->at_vector[k];
        if (node->kind == YK_RECIPE_ADD) {
            take_vector(g, node->a, by);
            take_vector(g, node->b, by);
        } else if (node->kind == YK_RECIPE_NEGATE) {
            take_vector(g, node->a, yk_scale(-1, by));
        } else if (node->kind == YK_RECIPE_ALONG) {
            g->at_direction[node->a] += yk_dot(by, yk_quarter(node->value));
        } else if (node->kind == YK_RECIPE_POINT) {
            const YkJoint *j = &g->model->joints[node->a];
            YkVec *at = &g->at_point[j->point[node->b]];
            *at = yk_add(*at, yk_mul(yk_conj(g->mech->bodies[j->body[node->b]].turn_unit), by));
        }
    }
}

// --- relations

static size_t variable_of(const YkGradient *g, YkRelationTerm term)
{
    return term.is_distance ? yk_gradient_variable(g, term.index) : (size_t)term.index - 1;
}

// Their first and second derivatives, -L' a' and -L'' a'^2 - L' a'', have shares of the argument a by those of the law
// L. Linear parts are settled already.
void yk_gradient_take_relation(YkGradient *g, size_t relation, size_t order, double by)
{
    const YkRelation *r = &g->mech->relations[relation];
    const YkRelationTerm *term = g->mech->relation_terms + r->first_argument;
    size_t n = g->variables;
    double a[YK_JET] = {r->argument_constant, 0, 0}, law[YK_LAW_ORDER + 1];
    if (!r->law) return;
    for (uint32_t k = 0; k < r->argument_count; k++)
        for (size_t i = 0; i < YK_JET; i++) a[i] += term[k].factor * g->x[i * n + variable_of(g, term[k])];
    yk_law_eval(r->law, a[0], law);
    by *= yk_relation_weight(g->mech, r);
    double place = order == 1 ? law[2] * a[1] : law[3] * a[1] * a[1] + law[2] * a[2], rate = 2 * law[2] * a[1];
    for (uint32_t k = 0; k < r->argument_count; k++) {
        size_t v = variable_of(g, term[k]);
        g->by_x[v] -= by * term[k].factor * place;
        if (order == 2) g->by_x[n + v] -= by * term[k].factor * rate;
    }
}

// --- channels

static void take_joint_angle(YkGradient *g, YkJointAngle angle, size_t order, double by)
{
    take_angle(g, angle.b, order, by);
    take_angle(g, angle.a, order, -by);
}

static void take_point(YkGradient *g, YkChannel c, double weight)
{
    const YkPoint *p = &g->model->points[c.index];
    YkTerm term = yk_body_term(g->mech, p->body, p->at);
    YkVecJet by = {{{0, 0}}}, at = sum_of(g, &g->mech->bodies[p->body].origin);
    add_term(g, &term, &at);
    double speed = yk_norm(at.v[1]);
    if (c.kind == YK_CHANNEL_POINT_SPEED && speed > 0) // at rest it is as fast a little to either side
        by.v[1] = yk_scale(weight / speed, at.v[1]);
    if (c.kind != YK_CHANNEL_POINT_SPEED)
        by.v[c.order] = c.kind == YK_CHANNEL_POINT_X ? yk_vec(weight, 0) : yk_vec(0, weight);
    YkVec own = yk_mul(yk_conj(g->mech->bodies[p->body].turn_unit), take_term(g, &term, &by));
    g->at_point[c.index] = yk_add(g->at_point[c.index], own);
    yk_gradient_take_sum(g, &g->mech->bodies[p->body].origin, &by);
}

// Takes the share of an arm's direction, a sum in the axes of the unknown angle. Returns the direction in the world.
static YkVec arm_of(YkGradient *g, const YkBlock *b, size_t k)
{
    YkVec arm = sum_of(g, &b->aside->arm[k]).v[0];
    return yk_mul(g->turn[b->column[k].index].unit, arm);
}

static void take_arm(YkGradient *g, const YkBlock *b, size_t k, double by)
{
    YkVec arm = sum_of(g, &b->aside->arm[k]).v[0];
    YkVecJet share = {{yk_scale(by / yk_dot(arm, arm), yk_quarter(arm))}};
    take_angle(g, b->column[k].index, 0, by);
    yk_gradient_take_sum(g, &b->aside->arm[k], &share);
}

// Takes the share of the angle, folded to a right one, between the columns of a dyad's loop: across arms, along a line.
static void take_transmission(YkGradient *g, size_t block, double weight)
{
    const YkBlock *b = &g->mech->blocks[block];
    bool has_line = b->kind == YK_BLOCK_RRP;
    YkVec first = arm_of(g, b, 0), second;
    if (has_line) {
        first = yk_quarter(first);
        second = yk_mul(g->turn[b->line_slot[0]].unit, b->line[0]);
    } else {
        second = arm_of(g, b, 1);
    }
    double by = weight * ((yk_cross(first, second) < 0) == (yk_dot(first, second) < 0) ? 1 : -1);
    take_arm(g, b, 0, -by);
    if (!has_line) {
        take_arm(g, b, 1, by);
        return;
    }
    take_angle(g, b->line_slot[0], 0, by);
    for (size_t k = 0; k < g->recipe->line_count; k++) {
        const YkRecipeLine *line = &g->recipe->lines[k];
        if (line->block == (int32_t)block && line->line == 0)
            take_vector(g, line->node, yk_scale(by, yk_quarter(b->line[0])));
    }
}

void yk_gradient_take(YkGradient *g, YkWeighted part)
{
    const YkMechanism *mech = g->mech;
    YkChannel c = part.channel;
    size_t order = (size_t)c.order;
    const YkTreeCoordinate *q = c.kind == YK_CHANNEL_COORDINATE ? &mech->coordinates[c.index] : NULL;
    if (q && q->is_distance)
        take_distance(g, q->distance, order, part.weight);
    else if (q)
        take_joint_angle(g, q->angle, order, part.weight);
    else if (c.kind == YK_CHANNEL_JOINT_ANGLE)
        take_joint_angle(g, yk_joint_angle(mech, c.index), order, part.weight);
    else if (c.kind == YK_CHANNEL_BODY)
        take_angle(g, mech->bodies[c.index].orientation, order, part.weight);
    else if (c.kind == YK_CHANNEL_JOINT_DISTANCE)
        take_distance(g, mech->joint_distance[c.index], order, part.weight);
    else if (c.kind == YK_CHANNEL_TRANSMISSION)
        take_transmission(g, (size_t)c.index, part.weight);
    else if (c.kind >= YK_CHANNEL_POINT_X && c.kind <= YK_CHANNEL_POINT_SPEED)
        take_point(g, c, part.weight);
}

// --- other values of the pose

void yk_gradient_turn(const YkGradient *g, int32_t slot, double value[4])
{
    YkVec u = g->turn[slot].unit;
    value[0] = u.x;
    value[1] = u.y;
    value[2] = g->turn[slot].rate;
    value[3] = g->turn[slot].accel;
}

void yk_gradient_take_turn(YkGradient *g, int32_t slot, const double share[4])
{
    YkVec u = g->turn[slot].unit;
    take_angle(g, slot, 0, share[1] * u.x - share[0] * u.y);
    take_angle(g, slot, 1, share[2]);
    take_angle(g, slot, 2, share[3]);
}

void yk_gradient_slide(const YkGradient *g, int32_t distance, double value[3])
{
    for (size_t k = 0; k < YK_JET; k++) value[k] = distance_of(g, distance, k);
}

void yk_gradient_take_slide(YkGradient *g, int32_t distance, const double share[3])
{
    for (size_t k = 0; k < YK_JET; k++) take_distance(g, distance, k, share[k]);
}

void yk_gradient_node(const YkGradient *g, int32_t node, double value[6])
{
    YkVecJet jet = g->node[node];
    for (size_t k = 0; k < YK_JET; k++) {
        value[2 * k] = jet.v[k].x;
        value[2 * k + 1] = jet.v[k].y;
    }
}

void yk_gradient_take_node(YkGradient *g, int32_t node, const double share[6])
{
    YkVecJet by;
    for (size_t k = 0; k < YK_JET; k++) by.v[k] = yk_vec(share[2 * k], share[2 * k + 1]);
    take_node(g, node, 1, &by);
}

double yk_gradient_angle(const YkGradient *g, size_t coordinate)
{
    YkJointAngle angle = g->mech->coordinates[coordinate].angle;
    return angle_of(g, angle.b, 0) - angle_of(g, angle.a, 0) + angle.offset;
}

void yk_gradient_take_angle(YkGradient *g, size_t coordinate, double share)
{
    take_joint_angle(g, g->mech->coordinates[coordinate].angle, 0, share);
}

void yk_gradient_take_parameter(YkGradient *g, int32_t parameter, double share)
{
    g->at_parameter[parameter] += share;
}
