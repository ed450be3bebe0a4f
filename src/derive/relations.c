// Gears, belts, racks, cams and laws: the conditions that they put on angles and distances, joint form.
#include "derive/relations.h"
#include <math.h>
#include "derive/forces/free_bodies.h"
#include "derive/inside.h"
#include "law/law.h"

// Returns a relation's constant, which gives the first position of the teeth; 0 if it is only rounding.
static const YkPoisson *phase_of(YkDerivation *d, YkDeriveRelation *relation, double value)
{
    YkText name = {0};
    if (fabs(value) < 1e-12) return yk_ring_rational(d->ring, 0, 1);
    yk_text_format(&name, "phase_%s", relation->name);
    relation->phase = yk_derive_symbol(d, yk_text_get(&name), YK_RING_CONSTANT);
    relation->phase_value = value;
    d->failed |= name.failed;
    yk_text_free(&name);
    return yk_ring_of(d->ring, relation->phase);
}

static double turn(const YkDerivation *d, int32_t body)
{
    return d->mech->bodies[body].turn;
}

// a (phi_0 - phi_c) + b (phi_1 - phi_c) = phase.
static const YkPoisson *wheels(YkDerivation *d, YkDeriveRelation *relation, const int32_t body[2], int32_t carrier,
                               const YkPoisson *a, const YkPoisson *b, const double factor[2], double constant)
{
    YkRing *ring = d->ring;
    const YkPoisson *arm = yk_derive_axes_angle(d, carrier);
    const YkPoisson *first = yk_ring_subtract(ring, yk_derive_axes_angle(d, body[0]), arm);
    const YkPoisson *second = yk_ring_subtract(ring, yk_derive_axes_angle(d, body[1]), arm);
    double phase = constant + factor[0] * (turn(d, body[0]) - turn(d, carrier)) +
                   factor[1] * (turn(d, body[1]) - turn(d, carrier));
    const YkPoisson *sum = yk_ring_multiply(ring, a, first);
    sum = yk_ring_add(ring, sum, yk_ring_multiply(ring, b, second));
    return yk_ring_subtract(ring, sum, phase_of(d, relation, phase));
}

static const YkPoisson *gear(YkDerivation *d, YkDeriveRelation *relation, const YkRelation *of)
{
    const YkGear *g = &d->model->gears[of->index];
    int sign = g->is_internal ? -1 : 1;
    const double factor[] = {(double)g->teeth[0], sign * (double)g->teeth[1]};
    const YkPoisson *second = yk_derive_expression(d, g->teeth_expr[1]);
    return wheels(d, relation, g->body, g->carrier, yk_derive_expression(d, g->teeth_expr[0]),
                  yk_ring_scale(d->ring, second, sign, 1), factor, of->constant);
}

static const YkPoisson *belt(YkDerivation *d, YkDeriveRelation *relation, const YkRelation *of)
{
    const YkBelt *b = &d->model->belts[of->index];
    int sign = b->is_crossed ? 1 : -1;
    const double factor[] = {b->radius[0], sign * b->radius[1]};
    const YkPoisson *second = yk_derive_expression(d, b->radius_expr[1]);
    return wheels(d, relation, b->body, b->carrier, yk_derive_expression(d, b->radius_expr[0]),
                  yk_ring_scale(d->ring, second, sign, 1), factor, of->constant);
}

// distance - sense radius (pinion - carrier) = phase.
static const YkPoisson *rack(YkDerivation *d, YkDeriveRelation *relation, const YkRelation *of)
{
    const YkRack *r = &d->model->racks[of->index];
    YkRing *ring = d->ring;
    const YkPoisson *angle = yk_derive_axes_angle(d, r->pinion);
    angle = yk_ring_subtract(ring, angle, yk_derive_axes_angle(d, r->carrier));
    const YkPoisson *rolled = yk_ring_multiply(ring, yk_derive_expression(d, r->radius_expr), angle);
    double phase = of->constant - r->sense * r->radius * (turn(d, r->pinion) - turn(d, r->carrier));
    const YkPoisson *moved =
        yk_ring_subtract(ring, yk_derive_distance(d, r->slide), yk_ring_scale(ring, rolled, r->sense, 1));
    return yk_ring_subtract(ring, moved, phase_of(d, relation, phase));
}

// --- Laws

// Returns what a pin turns by: its second body against its first.
static const YkPoisson *pin_angle(YkDerivation *d, int32_t joint)
{
    const int32_t *body = d->model->joints[joint].body;
    const YkPoisson *second = yk_derive_axes_angle(d, body[1]);
    return yk_ring_subtract(d->ring, second, yk_derive_axes_angle(d, body[0]));
}

// A pin that closes a loop has no coordinate for its angle: it gets a symbol with the rate and the derivatives that
// the tree gives.
static int32_t variable_of_its_own(YkDerivation *d, YkDeriveRelation *relation, int32_t joint)
{
    YkText name = {0};
    yk_text_format(&name, "%s.angle", d->model->joints[joint].name);
    int32_t symbol = name.failed ? -1 : yk_derive_angle(d, yk_text_get(&name));
    yk_text_free(&name);
    int32_t *both = YK_NEW(d->arena, int32_t, 2 * d->tree_count + 2), *first = both + d->tree_count;
    relation->is_own_variable = true;
    relation->B = both;
    if (symbol < 0 || !both) return -1;
    yk_derive_combination(d, d->model->joints[joint].body[1], both);
    yk_derive_combination(d, d->model->joints[joint].body[0], first);
    const YkPoisson *rate = yk_ring_rational(d->ring, 0, 1);
    for (size_t k = 0; k < d->tree_count; k++) {
        both[k] -= first[k];
        if (both[k] == 0) continue;
        yk_ring_set_partial(d->ring, symbol, d->coordinates[k].position, yk_ring_rational(d->ring, both[k], 1));
        rate =
            yk_ring_add(d->ring, rate, yk_ring_scale(d->ring, yk_ring_of(d->ring, d->coordinates[k].rate), both[k], 1));
    }
    return yk_ring_set_rate(d->ring, symbol, rate) ? symbol : -1;
}

// Returns the function s of a pin's angle, or of a slide's distance, with its derivatives s_v, s_a, s_j.
static const YkPoisson *function_of(YkDerivation *d, YkDeriveRelation *relation, int32_t law, int32_t joint,
                                    bool is_distance)
{
    static const char *const endings[YK_TIE_ORDERS] = {"", "_v", "_a", "_j"};
    YkText text[YK_TIE_ORDERS] = {{0}};
    const char *names[YK_TIE_ORDERS];
    size_t taken = 0;
    bool free_name = false;
    for (; taken < 20 && !free_name; taken++) {
        free_name = true;
        for (size_t k = 0; k < YK_TIE_ORDERS; k++) {
            yk_text_clear(&text[k]);
            for (const char *c = d->model->laws[law].name; *c; c++)
                yk_text_format(&text[k], "%c", *c == '-' ? '_' : *c);
            yk_text_repeat(&text[k], '_', taken);
            yk_text_puts(&text[k], endings[k]);
            names[k] = yk_text_get(&text[k]);
            free_name &= yk_ring_find(d->ring, names[k]) < 0;
        }
    }
    int32_t coordinate = is_distance ? d->joint_distance[joint] : d->joint_angle[joint];
    relation->law = d->model->laws[law].law;
    relation->argument = is_distance ? yk_derive_distance(d, joint) : pin_angle(d, joint);
    relation->variable =
        coordinate != YK_NONE ? d->coordinates[coordinate].position : variable_of_its_own(d, relation, joint);
    relation->function =
        relation->variable < 0 ? -1 : yk_ring_function(d->ring, names, YK_TIE_ORDERS, relation->variable);
    for (size_t k = 0; k < YK_TIE_ORDERS; k++) yk_text_free(&text[k]);
    return relation->function < 0 ? NULL : yk_ring_of(d->ring, relation->function);
}

static const YkPoisson *cam(YkDerivation *d, YkDeriveRelation *relation, const YkRelation *of)
{
    const YkCam *c = &d->model->cams[of->index];
    function_of(d, relation, c->law, c->cam_joint, false);
    return c->oscillates ? pin_angle(d, c->follower_joint) : yk_derive_distance(d, c->follower_joint);
}

static const YkPoisson *law(YkDerivation *d, YkDeriveRelation *relation, const YkRelation *of)
{
    const YkFollow *f = &d->model->follows[of->index];
    const YkCoordinate *own = &d->model->coordinates[f->coordinate];
    const YkCoordinate *of_which = &d->model->coordinates[f->of];
    function_of(d, relation, f->law, of_which->joint, of_which->is_distance);
    return own->is_distance ? yk_derive_distance(d, own->joint) : pin_angle(d, own->joint);
}

const YkPoisson *yk_derive_tie_slope(YkDerivation *d, const YkDeriveRelation *tie, int32_t position)
{
    YkRing *ring = d->ring;
    const YkPoisson *slope = yk_ring_partial(ring, tie->linear, position);
    if (tie->function < 0 || !yk_ring_mentions(ring, tie->argument, position)) return slope;
    const YkPoisson *turns = yk_ring_partial(ring, tie->argument, position);
    return yk_ring_subtract(ring, slope, yk_ring_multiply(ring, yk_ring_of(ring, tie->function + 1), turns));
}

const YkPoisson *yk_derive_tie_acceleration(YkDerivation *d, const YkDeriveRelation *tie)
{
    YkRing *ring = d->ring;
    const YkPoisson *second = yk_ring_time_derivative(ring, yk_ring_time_derivative(ring, tie->linear));
    if (tie->function < 0) return second;
    const YkPoisson *rate = yk_ring_time_derivative(ring, tie->argument);
    const YkPoisson *v = yk_ring_of(ring, tie->function + 1), *a = yk_ring_of(ring, tie->function + 2);
    const YkPoisson *by_rate = yk_ring_product(ring, (const YkPoisson *[]){a, rate, rate}, 3);
    const YkPoisson *by_acceleration = yk_ring_multiply(ring, v, yk_ring_time_derivative(ring, rate));
    return yk_ring_subtract(ring, second, yk_ring_add(ring, by_rate, by_acceleration));
}

static void fill(void *context, const YkState *state, YkDynamics *dynamics, double *values)
{
    const YkDerivation *d = context;
    (void)state, (void)dynamics;
    for (size_t k = 0; k < d->tie_count; k++) {
        const YkDeriveRelation *relation = &d->ties[k];
        if (relation->phase >= 0) values[relation->phase] = relation->phase_value;
        if (relation->function < 0) continue;
        double found[YK_LAW_ORDER + 1];
        if (relation->is_own_variable) values[relation->variable] = 0;
        for (size_t c = 0; relation->is_own_variable && c < d->tree_count; c++)
            values[relation->variable] += relation->B[c] * values[d->coordinates[c].position];
        yk_law_eval(relation->law, values[relation->variable], found);
        for (int32_t order = 0; order < YK_TIE_ORDERS; order++) values[relation->function + order] = found[order];
    }
}

const YkDeriveRelation *yk_derive_ties(YkDerivation *d)
{
    typedef const YkPoisson *(*Maker)(YkDerivation *, YkDeriveRelation *, const YkRelation *);
    static const Maker makers[] = {gear, rack, belt, cam, law}; // as YkRelationKind
    if (d->ties || d->mech->relation_count == 0) return d->ties;
    YkDeriveRelation *ties = YK_NEW(d->arena, YkDeriveRelation, d->mech->relation_count);
    if (!ties) return NULL;
    for (size_t k = 0; k < d->mech->relation_count; k++) {
        const YkRelation *of = &d->mech->relations[k];
        ties[k] = (YkDeriveRelation){.name = of->name, .kind = of->kind, .phase = -1, .function = -1};
        ties[k].linear = makers[of->kind](d, &ties[k], of);
        ties[k].value = yk_derive_in_joints(d, ties[k].linear);
        if (ties[k].argument)
            ties[k].value = ties[k].function < 0
                                ? NULL
                                : yk_ring_subtract(d->ring, ties[k].value, yk_ring_of(d->ring, ties[k].function));
    }
    d->ties = ties;
    d->tie_count = d->mech->relation_count;
    yk_derive_add_source(d, fill, d);
    return ties;
}
