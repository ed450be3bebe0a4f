// Writes the model's gears, racks, belts, cams and laws as relations between angles and distances.
#include "compile/relations.h"
#include "base/memory.h"
#include "compile/topology.h"
#include "elementary/elementary.h"
#include <stdlib.h>

typedef struct Build {
    YkMechanism *mech;
    double *guess;  // per coordinate of the tree
    bool *is_given; // by `start:` or a drive
    double *share;  // per coordinate: its factor in the present relation
    size_t first;   // first term of the present sum
    bool failed;
} Build;

bool yk_relation_add_term(YkMechanism *mech, size_t first, YkRelationTerm term)
{
    for (size_t k = first; k < mech->relation_term_count; k++) {
        YkRelationTerm *old = &mech->relation_terms[k];
        if (old->is_distance != term.is_distance || old->index != term.index) continue;
        old->factor += term.factor;
        return true;
    }
    if (!YK_ROOM(mech->relation_terms, mech->relation_term_count, mech->relation_term_capacity)) return false;
    mech->relation_terms[mech->relation_term_count++] = term;
    return true;
}

static void add_term(Build *b, YkRelationTerm term)
{
    if (!term.is_distance && term.index == 0) return; // the ground
    if (!yk_relation_add_term(b->mech, b->first, term)) b->failed = true;
}

// Adds factor * (angle of the body, as the sum of joint angles along the tree); returns the constant part of its
// orientation, which belongs on the other side.
static double add_body(Build *b, int32_t body, double factor)
{
    const YkMechanism *mech = b->mech;
    add_term(b, (YkRelationTerm){false, mech->bodies[body].orientation, factor});
    for (int32_t at = body; mech->tree.parent[at] != YK_NONE; at = mech->tree.parent[at]) {
        const YkJoint *joint = &mech->model->joints[mech->tree.joint[at]];
        int32_t c = yk_tree_coordinate(mech, mech->tree.joint[at], false);
        if (c != YK_NONE) b->share[c] += joint->body[1] == at ? factor : -factor;
    }
    return factor * mech->bodies[body].turn;
}

static void add_distance(Build *b, int32_t joint, double factor)
{
    add_term(b, (YkRelationTerm){true, b->mech->joint_distance[joint], factor});
    int32_t c = yk_tree_coordinate(b->mech, joint, true);
    if (c != YK_NONE) b->share[c] += factor;
}

// Returns the value of the relation at the start if all coordinates that it ties are given; otherwise 0.
static double phase(Build *b)
{
    double sum = 0;
    bool all = true;
    for (size_t c = 0; c < b->mech->coordinate_count; c++) {
        if (fabs(b->share[c]) > 1e-12) {
            all = all && b->is_given[c];
            sum += b->share[c] * b->guess[c];
        }
        b->share[c] = 0;
    }
    return all ? sum : 0;
}

static YkRelation *begin(Build *b, YkRelationKind kind, size_t index, const char *name)
{
    YkMechanism *mech = b->mech;
    YkRelation *r = &mech->relations[mech->relation_count++];
    *r = (YkRelation){
        .kind = kind, .index = (int32_t)index, .name = name, .first_term = (uint32_t)mech->relation_term_count};
    b->first = mech->relation_term_count;
    return r;
}

// Drops terms that cancel: a belt round equal pulleys does not involve its carrier. Returns how many terms are left.
static uint32_t end_sum(Build *b)
{
    YkMechanism *mech = b->mech;
    size_t kept = b->first;
    double most = 0;
    for (size_t k = b->first; k < mech->relation_term_count; k++)
        most = fmax(most, fabs(mech->relation_terms[k].factor));
    for (size_t k = b->first; k < mech->relation_term_count; k++)
        if (fabs(mech->relation_terms[k].factor) > 1e-13 * most) mech->relation_terms[kept++] = mech->relation_terms[k];
    mech->relation_term_count = kept;
    return (uint32_t)(kept - b->first);
}

static void end_terms(Build *b, YkRelation *r)
{
    r->term_count = end_sum(b);
    r->first_argument = (uint32_t)b->mech->relation_term_count;
    b->first = b->mech->relation_term_count;
}

// Adds factor_a (a - carrier) + factor_b (b - carrier) = phase.
static void add_wheels(Build *b, YkRelationKind kind, size_t index, const char *name, const int32_t body[2],
                       int32_t carrier, double factor_a, double factor_b)
{
    YkRelation *r = begin(b, kind, index, name);
    double turns = add_body(b, body[0], factor_a);
    turns += add_body(b, body[1], factor_b);
    turns += add_body(b, carrier, -factor_a - factor_b);
    end_terms(b, r);
    r->constant = phase(b) - turns;
}

static void add_gears(Build *b)
{
    const YkModel *model = b->mech->model;
    for (size_t k = 0; k < model->gear_count; k++) {
        const YkGear *g = &model->gears[k];
        double a = (double)g->teeth[0], z = (double)g->teeth[1];
        add_wheels(b, YK_RELATION_GEAR, k, g->name, g->body, g->carrier, a, g->is_internal ? -z : z);
    }
    for (size_t k = 0; k < model->belt_count; k++) {
        const YkBelt *belt = &model->belts[k];
        double sign = belt->is_crossed ? 1 : -1;
        add_wheels(b, YK_RELATION_BELT, k, belt->name, belt->body, belt->carrier, belt->radius[0],
                   sign * belt->radius[1]);
    }
    for (size_t k = 0; k < model->rack_count; k++) {
        const YkRack *rack = &model->racks[k];
        YkRelation *r = begin(b, YK_RELATION_RACK, k, rack->name);
        double factor = -rack->sense * rack->radius;
        add_distance(b, rack->slide, 1);
        double turns = add_body(b, rack->pinion, factor);
        turns += add_body(b, rack->carrier, -factor);
        end_terms(b, r);
        r->constant = phase(b) - turns;
    }
}

// Adds the coordinate of a pin: the angle of its second body less that of its first.
static double add_pin(Build *b, int32_t joint, double factor)
{
    const YkJoint *j = &b->mech->model->joints[joint];
    double turns = add_body(b, j->body[1], factor);
    return turns + add_body(b, j->body[0], -factor);
}

static void add_cams(Build *b)
{
    const YkModel *model = b->mech->model;
    for (size_t k = 0; k < model->cam_count; k++) {
        const YkCam *cam = &model->cams[k];
        if (b->mech->open_cams && b->mech->open_cams[k]) continue;
        YkRelation *r = begin(b, YK_RELATION_CAM, k, cam->name);
        if (cam->oscillates)
            r->constant = -add_pin(b, cam->follower_joint, 1);
        else
            add_distance(b, cam->follower_joint, 1);
        end_terms(b, r);
        r->argument_constant = add_pin(b, cam->cam_joint, 1);
        r->argument_count = end_sum(b);
        r->law = model->laws[cam->law].law;
        phase(b); // clears the shares
    }
}

// Adds a coordinate of the model: its distance, or the angle of its joint.
static double add_coordinate(Build *b, int32_t declared, double factor)
{
    const YkCoordinate *c = &b->mech->model->coordinates[declared];
    if (!c->is_distance) return add_pin(b, c->joint, factor);
    add_distance(b, c->joint, factor);
    return 0;
}

static void add_follows(Build *b)
{
    const YkModel *model = b->mech->model;
    for (size_t k = 0; k < model->follow_count; k++) {
        const YkFollow *follow = &model->follows[k];
        YkRelation *r = begin(b, YK_RELATION_LAW, k, model->coordinates[follow->coordinate].name);
        r->constant = -add_coordinate(b, follow->coordinate, 1);
        end_terms(b, r);
        r->argument_constant = add_coordinate(b, follow->of, 1);
        r->argument_count = end_sum(b);
        r->law = model->laws[follow->law].law;
        phase(b); // clears the shares
    }
}

static void mark_given(Build *b)
{
    const YkMechanism *mech = b->mech;
    const YkModel *model = mech->model;
    yk_start_guess(mech, b->guess);
    for (size_t c = 0; c < mech->coordinate_count; c++) b->is_given[c] = mech->coordinates[c].drive != YK_NONE;
    for (size_t k = 0; k < model->start_count; k++) {
        const YkCoordinate *c = &model->coordinates[model->starts[k].coordinate];
        int32_t q = model->starts[k].is_rate ? YK_NONE : yk_tree_coordinate(mech, c->joint, c->is_distance);
        if (q != YK_NONE) b->is_given[q] = true;
    }
}

size_t yk_contact_of_cam(const YkMechanism *mech, size_t cam)
{
    const YkModel *model = mech->model;
    return model->gear_count + model->belt_count + model->rack_count + cam;
}

size_t yk_contact_count(const YkMechanism *mech)
{
    return yk_contact_of_cam(mech, mech->model->cam_count);
}

const char *yk_contact_name(const YkMechanism *mech, size_t contact)
{
    int32_t relation = yk_contact_relation(mech, contact);
    if (relation != YK_NONE) return mech->relations[relation].name;
    return mech->model->cams[contact - yk_contact_of_cam(mech, 0)].name;
}

int32_t yk_contact_relation(const YkMechanism *mech, size_t contact)
{
    size_t first = yk_contact_of_cam(mech, 0), relation = contact;
    if (!mech->open_cams || contact < first) return (int32_t)contact;
    if (mech->open_cams[contact - first]) return YK_NONE;
    for (size_t k = 0; k < contact - first; k++) relation -= mech->open_cams[k];
    return (int32_t)relation;
}

double yk_relation_weight(const YkMechanism *mech, const YkRelation *r)
{
    double most = 0;
    for (uint32_t k = 0; k < r->term_count; k++) {
        YkRelationTerm term = mech->relation_terms[r->first_term + k];
        most = fmax(most, fabs(term.factor) * (term.is_distance ? mech->size : 1));
    }
    return most > 0 ? yk_exp2(rint(yk_log2(mech->size / most))) : 1;
}

bool yk_relations_build(YkMechanism *mech)
{
    const YkModel *model = mech->model;
    size_t count = model->gear_count + model->belt_count + model->rack_count + model->cam_count + model->follow_count;
    if (count == 0) return true;
    size_t n = mech->coordinate_count + 1;
    Build b = {.mech = mech};
    b.guess = YK_NEW(mech->arena, double, 2 * n);
    b.is_given = YK_NEW(mech->arena, bool, n);
    mech->relations = YK_NEW(mech->arena, YkRelation, 2 * count);
    if (yk_arena_failed(mech->arena)) return false;
    b.share = b.guess + n;
    mark_given(&b);
    add_gears(&b);
    add_cams(&b);
    add_follows(&b);
    mech->gruebler -= (int)mech->relation_count;
    mech->own_term_count = mech->relation_term_count;
    return !b.failed;
}

bool yk_relations_constants(const YkMechanism *mech, double *constants)
{
    YkMechanism again = *mech;
    again.arena = yk_arena_new();
    again.relations = NULL;
    again.relation_terms = NULL;
    again.relation_count = again.relation_term_count = again.relation_term_capacity = 0;
    bool good = again.arena && yk_relations_build(&again);
    for (size_t k = 0; good && k < again.relation_count; k++) constants[k] = again.relations[k].constant;
    free(again.relation_terms);
    yk_arena_free(again.arena);
    return good;
}
