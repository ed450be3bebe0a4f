// Makes the forces of lanes: the tape, and the sources of its leaves' values.
#include <stdlib.h>
#include "base/text.h"
#include "batch/lane_forces.h"
#include "law/law.h"
#include "model/transmissions/cam_place.h"
#include "program/balance.h"

enum { BODIES_MAX = 64 }; // the equations of all bodies are dense while they are made

// --- leaves

YkRef yk_lane_forces_leaf(YkLaneForces *f, YkGraph *g, YkLeafKind kind, size_t index, int32_t part)
{
    YkLeafClass leaf_class = kind == YK_LEAF_OF_PARAMETER ? YK_LEAF_PARAMETER : YK_LEAF_POSE;
    if (f->leaf_count == f->leaf_capacity) {
        f->failed = true;
        return 0;
    }
    YkRef ref = yk_graph_leaf(g, leaf_class, yk_graph_text(g, "%d.%d.%d", (int)kind, (int)index, (int)part));
    f->sources[f->leaf_count] = (YkLeafSource){.kind = kind, .index = (int32_t)index, .part = part};
    f->leaves[f->leaf_count++] = ref;
    return ref;
}

static YkRefVec two_leaves(YkLaneForces *f, YkGraph *g, YkLeafKind kind, size_t index, int32_t part)
{
    YkRefVec v = {.x = yk_lane_forces_leaf(f, g, kind, index, part)};
    v.y = yk_lane_forces_leaf(f, g, kind, index, part + 1);
    return v;
}

static size_t count_leaves(const YkMechanism *mech, size_t weights)
{
    return 4 * (mech->slot_count + 1) + 3 * (mech->distance_count + 1) + 6 * (mech->node_count + 1) +
           mech->coordinate_count + 3 * mech->input_count + mech->relation_count + mech->derived_count +
           mech->model->parameter_count + weights + 2;
}

static bool start_leaves(YkLaneForces *f, size_t channels)
{
    f->leaf_capacity = count_leaves(f->mech, f->roots_of ? channels : 0);
    f->sources = calloc(f->leaf_capacity, sizeof *f->sources);
    f->leaves = calloc(f->leaf_capacity, sizeof *f->leaves);
    f->needs = calloc(f->mech->coordinate_count + 1, sizeof *f->needs);
    return f->sources && f->leaves && f->needs;
}

// The parameters that vary are leaves; all others keep their values.
static bool prepare(YkProgram *p, const YkVariant *variant)
{
    size_t count = p->model->parameter_count;
    p->names.parameter = YK_NEW(p->arena, const char *, count + 1);
    p->names.law = YK_NEW(p->arena, const char *, p->model->law_count + 1);
    if (yk_arena_failed(p->arena)) return false;
    for (size_t k = 0; k < p->model->law_count; k++) p->names.law[k] = p->model->laws[k].name;
    for (size_t k = 0; k < count; k++) {
        p->names.parameter[k] = p->model->parameters[k].name;
        p->is_fixed[k] = !variant || !yk_redesign_varies(variant->redesign, (int32_t)k);
    }
    p->takes_all = true;
    return true;
}

// Parameters that are leaves of the graph get their values from the model.
static void find_parameters(YkLaneForces *f, YkProgram *p)
{
    for (size_t k = 0; k < p->model->parameter_count; k++) {
        if (p->graph.values[p->parameter[k]].op != YK_VALUE_LEAF) continue;
        if (f->leaf_count == f->leaf_capacity) f->failed = true;
        if (f->failed) return;
        f->sources[f->leaf_count] = (YkLeafSource){.kind = YK_LEAF_OF_PARAMETER, .index = (int32_t)k};
        f->leaves[f->leaf_count++] = p->parameter[k];
    }
}

static void place_pose(YkLaneForces *f, YkProgram *p, YkRates *r, YkRates *s)
{
    YkGraph *g = &p->graph;
    const YkMechanism *mech = p->mech;
    p->unit[0] = yk_graph_vec_number(g, 1, 0);
    for (size_t k = 1; k < mech->slot_count; k++) {
        p->unit[k] = two_leaves(f, g, YK_LEAF_OF_TURN, k, 0);
        yk_graph_is_unit(g, p->unit[k]);
        r->turn[k] = yk_lane_forces_leaf(f, g, YK_LEAF_OF_TURN, k, 2);
        s->turn[k] = yk_lane_forces_leaf(f, g, YK_LEAF_OF_TURN, k, 3);
    }
    for (size_t k = 0; k < mech->distance_count; k++) {
        p->distance[k] = yk_lane_forces_leaf(f, g, YK_LEAF_OF_SLIDE, k, 0);
        r->slide[k] = yk_lane_forces_leaf(f, g, YK_LEAF_OF_SLIDE, k, 1);
        s->slide[k] = yk_lane_forces_leaf(f, g, YK_LEAF_OF_SLIDE, k, 2);
    }
    for (size_t k = 0; k < mech->node_count; k++) {
        p->node[k] = two_leaves(f, g, YK_LEAF_OF_NODE, k, 0);
        r->node[k] = two_leaves(f, g, YK_LEAF_OF_NODE, k, 2);
        s->node[k] = two_leaves(f, g, YK_LEAF_OF_NODE, k, 4);
    }
    for (size_t k = 0; k < mech->relation_count + mech->derived_count; k++)
        if (mech->relations[k].law) p->slope[2 * k] = yk_lane_forces_leaf(f, g, YK_LEAF_OF_GAIN, k, 0);
}

static void place_inputs(YkLaneForces *f, YkProgram *p)
{
    for (size_t k = 0; k < p->mech->input_count; k++) {
        YkRef *motion[] = {&p->input[k].position, &p->input[k].velocity, &p->input[k].acceleration};
        for (int32_t part = 0; part < 3; part++)
            *motion[part] = yk_lane_forces_leaf(f, &p->graph, YK_LEAF_OF_INPUT, k, part);
    }
}

static bool is_zero(const YkProgram *p, YkRef value)
{
    return yk_graph_is_number(&p->graph, value, 0);
}

// Returns an orientation that is read and turns at a fixed ratio to this input alone; 0 if there is none. by[input]:
// the rates for rate 1 of one input.
static size_t find_base(const YkProgram *p, const YkRates *by, size_t input)
{
    for (size_t k = p->mech->term_count; k-- > 0;) {
        size_t slot = (size_t)p->mech->terms[k].slot;
        bool is_alone = !is_zero(p, by[input].turn[slot]);
        for (size_t i = 0; i < p->mech->input_count; i++) is_alone &= i == input || is_zero(p, by[i].turn[slot]);
        if (is_alone) return slot;
    }
    return 0;
}

// Returns an input's rate as a multiple of that of its base.
static YkRef rate_by(YkProgram *p, const YkRates *by, size_t input, size_t base, const YkRates *rates, YkRef otherwise)
{
    if (base == 0) return otherwise;
    double ratio = p->graph.values[by[input].turn[base]].number;
    return yk_graph_multiply(&p->graph, yk_graph_number(&p->graph, 1 / ratio), rates->turn[base]);
}

// Orientations that turn at a fixed ratio to an input have rates that are multiples of one rate, so that their terms
// join. In a variant the ratios may vary.
static void place_linear_rates(YkLaneForces *f, YkProgram *p, YkRates *r, YkRates *s)
{
    size_t n = p->mech->input_count;
    YkRates *by = YK_NEW(p->arena, YkRates, n + 1);
    YkRef *rate = YK_NEW(p->arena, YkRef, n + 1), *accel = YK_NEW(p->arena, YkRef, n + 1);
    size_t *base = YK_NEW(p->arena, size_t, n + 1);
    if (f->variant || f->roots_of || yk_arena_failed(p->arena)) return;
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < n; k++) rate[k] = yk_graph_number(&p->graph, k == i ? 1 : 0);
        by[i] = yk_program_new_rates(p);
        yk_program_linear_rates(p, rate, &by[i]);
    }
    if (p->failed) return;
    for (size_t i = 0; i < n; i++) base[i] = find_base(p, by, i);
    for (size_t i = 0; i < n; i++) {
        rate[i] = rate_by(p, by, i, base[i], r, p->input[i].velocity);
        accel[i] = rate_by(p, by, i, base[i], s, p->input[i].acceleration);
    }
    YkRef *w = YK_NEW(p->arena, YkRef, n + 1), *a = YK_NEW(p->arena, YkRef, n + 1);
    if (yk_arena_failed(p->arena)) return;
    for (size_t i = 0; i < n; i++) w[i] = r->turn[base[i]], a[i] = s->turn[base[i]];
    yk_program_linear_rates(p, rate, r);
    yk_program_linear_rates(p, accel, s);
    for (size_t i = 0; i < n; i++) r->turn[base[i]] = w[i], s->turn[base[i]] = a[i];
}

static void place_coordinates(YkLaneForces *f, YkForces *forces, const YkRates *r)
{
    YkProgram *p = forces->program;
    for (size_t k = 0; k < p->mech->coordinate_count; k++) {
        const YkTreeCoordinate *c = &p->mech->coordinates[k];
        YkMotionRef *m = &forces->motion[k];
        if (c->input != YK_NONE) {
            *m = p->input[c->input];
            continue;
        }
        m->position =
            c->is_distance ? p->distance[c->distance] : yk_lane_forces_leaf(f, &p->graph, YK_LEAF_OF_COORDINATE, k, 0);
        m->velocity = yk_program_coordinate_rate(p, k, r);
    }
}

// --- making

// Returns whether a joint has dry friction, or may have some in another design.
static bool may_be_dry(const YkJoint *joint, const YkVariant *variant)
{
    if (!joint->has_friction) return false;
    const YkExpr *expr = joint->friction.coulomb_expr;
    return joint->friction.coulomb != 0 || (variant && expr && yk_redesign_expression_varies(variant->redesign, expr));
}

// Returns whether the place of a second roller varies, of which the graph has numbers alone.
static bool moves_pairs(const YkModel *model, const YkVariant *variant)
{
    for (size_t k = 0; variant && k < model->cam_count; k++) {
        const YkExpr *place[YK_CAM_EXPRS];
        for (size_t i = yk_cam_pair_exprs(model, &model->cams[k], place); i-- > 0;)
            if (yk_redesign_expression_varies(variant->redesign, place[i])) return true;
    }
    return false;
}

static bool can_fit(const YkMechanism *mech, const YkVariant *variant)
{
    if (moves_pairs(mech->model, variant)) return false;
    for (size_t j = 0; j < mech->model->joint_count; j++)
        if (may_be_dry(&mech->model->joints[j], variant)) return false;
    return mech->model->body_count <= BODIES_MAX && mech->redundant_count + mech->redundant_relation_count == 0;
}

static void evaluate_law(const void *context, int32_t law, double argument, double result[3])
{
    const YkModel *model = context;
    double d[YK_LAW_ORDER + 1];
    if (!(argument - argument == 0)) {
        result[0] = result[1] = result[2] = argument;
        return;
    }
    yk_law_eval(model->laws[law].law, argument, d);
    for (size_t k = 0; k < 3; k++) result[k] = d[k];
}

// Makes the values of all channels. *fits: the machine can be computed so.
static YkRef *make_roots(YkLaneForces *f, YkProgram *p, const YkChannel *channels, size_t count, bool *fits)
{
    YkForces forces;
    YkBalanceSystem balance = {0};
    YkRef *roots = YK_NEW(p->arena, YkRef, count + 1);
    YkRates r = yk_program_new_rates(p), s = yk_program_new_rates(p);
    f->leaves[f->leaf_count] = p->time;
    f->sources[f->leaf_count++] = (YkLeafSource){.kind = YK_LEAF_OF_TIME};
    if (!roots || p->failed || !yk_forces_start(&forces, p)) return NULL;
    find_parameters(f, p);
    place_inputs(f, p);
    place_pose(f, p, &r, &s);
    place_linear_rates(f, p, &r, &s);
    forces.velocities = r;
    place_coordinates(f, &forces, &r);
    bool has_loads = yk_forces_loads(&forces);
    bool is_solved = has_loads && yk_balance_make(&balance, &forces, &r, &s, 1) && yk_balance_solve(&balance);
    *fits = is_solved || balance.ran_out || p->failed || yk_arena_failed(p->arena); // otherwise the machine is at fault
    if (!is_solved || !yk_balance_read(&balance)) return NULL;
    for (size_t k = 0; k < count; k++) roots[k] = yk_balance_channel(&balance, channels[k]);
    return roots;
}

static bool make(YkLaneForces *f, const YkChannel *channels, size_t count, size_t lanes, bool *fits)
{
    YkProgram p = {0};
    YkArena *arena = yk_arena_new();
    const YkRecipe *recipe = f->variant ? &f->variant->recipe : NULL;
    bool good = arena && start_leaves(f, count) && yk_program_start(&p, f->mech, recipe, arena, NULL);
    good = good && prepare(&p, f->variant);
    p.graph.joins_terms = p.graph.shares_signs = true;
    if (good) yk_program_constants(&p);
    YkRef *roots = good ? make_roots(f, &p, channels, count, fits) : NULL;
    if (roots && f->roots_of) {
        roots = f->roots_of(f, &p.graph, roots, count);
        count = f->by_count;
        *fits = roots || f->failed || p.failed || p.graph.failed || yk_arena_failed(arena);
    }
    if (roots && !f->failed && !p.failed && !yk_arena_failed(arena))
        f->tape = yk_tape_new(&p.graph, f->leaves, f->leaf_count, roots, count, lanes,
                              (YkTapeLaws){f->mech->model, evaluate_law});
    yk_program_end(&p);
    yk_arena_free(arena);
    return f->tape != NULL;
}

YkLaneForces *yk_lane_forces_make(const YkMechanism *mech, const YkChannel *channels, size_t channel_count,
                                  size_t lanes, YkRootsOf roots_of, bool *fits)
{
    *fits = can_fit(mech, mech->variant);
    YkLaneForces *f = *fits ? calloc(1, sizeof *f) : NULL;
    if (!f) return NULL;
    f->roots_of = roots_of;
    f->mech = mech;
    f->variant = mech->variant;
    if (!make(f, channels, channel_count, lanes, fits) || !yk_lane_forces_keep_needed(f)) {
        yk_lane_forces_free(f);
        return NULL;
    }
    yk_lane_forces_redesign(f);
    return f;
}

YkLaneForces *yk_lane_forces_new(const YkMechanism *mech, const YkChannel *channels, size_t channel_count, size_t lanes,
                                 bool *fits)
{
    return yk_lane_forces_make(mech, channels, channel_count, lanes, NULL, fits);
}

void yk_lane_forces_free(YkLaneForces *f)
{
    if (!f) return;
    yk_tape_free(f->tape);
    free(f->sources);
    free(f->needed);
    free(f->leaves);
    free(f->needs);
    free(f);
}

size_t yk_lane_forces_length(const YkLaneForces *f)
{
    return yk_tape_length(f->tape);
}

bool yk_lane_forces_tell(const YkLaneForces *f, size_t channel)
{
    return yk_tape_tells(f->tape, channel);
}

bool yk_lane_forces_needs(const YkLaneForces *f, size_t coordinate)
{
    return f->needs[coordinate];
}

bool yk_lane_forces_need_direction(const YkLaneForces *f, int32_t slot)
{
    for (const YkLeafSource *s = f->needed; s < f->needed + f->needed_count; s++) {
        if (s->kind == YK_LEAF_OF_TURN && s->index == slot && s->part < 2) return true;
        if (s->kind != YK_LEAF_OF_COORDINATE) continue;
        YkJointAngle angle = f->mech->coordinates[s->index].angle;
        if (angle.a == slot || angle.b == slot) return true;
    }
    return false;
}

bool yk_lane_forces_need_rates(const YkLaneForces *f, int32_t slot)
{
    for (const YkLeafSource *s = f->needed; s < f->needed + f->needed_count; s++)
        if (s->kind == YK_LEAF_OF_TURN && s->index == slot && s->part >= 2) return true;
    return false;
}
