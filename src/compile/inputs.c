// Chooses the inputs: by counting equations and unknowns, and by rank where counting is not enough.
#include "compile/inputs.h"
#include <string.h>
#include "base/problems.h"
#include "compile/closure.h"
#include "compile/plan.h"
#include "num/matching.h"

typedef struct Choice {
    YkMechanism *mech;
    const YkIncidence *incidence;
    YkArena *arena;
    YkProblems *problems;
    int32_t *candidates; // coordinates in order of preference
    bool *is_candidate, *accepted;
    size_t count, wanted, driven; // the first `wanted` were requested, the next `driven` have drives
} Choice;

static void propose(Choice *c, int32_t coordinate)
{
    if (coordinate == YK_NONE || c->is_candidate[coordinate]) return;
    c->is_candidate[coordinate] = true;
    c->candidates[c->count++] = coordinate;
}

static void propose_declared(Choice *c, int32_t declared)
{
    const YkCoordinate *d = &c->mech->model->coordinates[declared];
    propose(c, yk_tree_coordinate(c->mech, d->joint, d->is_distance));
}

static bool propose_all(Choice *c, const YkCompileOptions *options)
{
    YkMechanism *mech = c->mech;
    const YkModel *model = mech->model;
    for (size_t i = 0; i < options->input_count; i++) {
        size_t found = yk_coordinate_find(mech, options->inputs[i]);
        if (found == YK_NOT_FOUND) {
            yk_problem(c->problems, YK_CODE_UNKNOWN_INPUT, (YkPlace){0}, "there is no coordinate %q",
                       options->inputs[i]);
            yk_problem_hint(c->problems, "`yoke check` lists the coordinates of the machine");
            return false;
        }
        propose(c, (int32_t)found);
    }
    c->wanted = c->count;
    for (size_t k = 0; k < model->drive_count; k++) propose_declared(c, model->drives[k].coordinate);
    c->driven = c->count - c->wanted;
    for (size_t k = 0; k < model->start_count; k++)
        if (!model->starts[k].is_rate) propose_declared(c, model->starts[k].coordinate);
    for (size_t k = 0; k < model->start_count; k++) propose_declared(c, model->starts[k].coordinate);
    for (size_t k = 0; k < mech->coordinate_count; k++) propose(c, (int32_t)k);
    return true;
}

// Tests structural independence: matches each loop's two equations with its variables, then one equation for each held
// coordinate.
static bool accept_by_structure(Choice *c)
{
    YkMechanism *mech = c->mech;
    size_t o = mech->orientation_count, columns = o + mech->distance_count, rows = 2 * mech->loop_count + c->count;
    size_t entries = 2 * c->count + mech->own_term_count, most = mech->own_term_count + 1;
    rows += mech->relation_count;
    for (size_t l = 0; l < mech->loop_count; l++) {
        entries += 4 * (size_t)mech->loops[l].sum.count;
        if (mech->loops[l].sum.count > most) most = mech->loops[l].sum.count;
    }
    YkMatching m;
    int32_t *row = YK_NEW(c->arena, int32_t, 2 * most + 2);
    if (!row || !yk_matching_start(&m, c->arena, columns, rows, entries)) return false;
    size_t matched = 0;
    for (size_t l = 0; l < mech->loop_count && yk_compile_goes_on(mech, 1); l++) {
        const YkSum *sum = &mech->loops[l].sum;
        size_t n = 0;
        for (uint32_t k = 0; k < sum->count; k++) {
            YkTerm t = mech->terms[sum->first + k];
            if (t.slot > 0) row[n++] = t.slot;
            if (t.distance != YK_NONE) row[n++] = (int32_t)o + t.distance;
        }
        for (int twice = 0; twice < 2; twice++) matched += yk_matching_add(&m, row, n, true);
    }
    for (size_t r = 0; r < mech->relation_count; r++) {
        const YkRelation *relation = &mech->relations[r];
        size_t n = 0; // its terms and its law's arguments are contiguous
        for (uint32_t k = 0; k < relation->term_count + relation->argument_count; k++) {
            const YkRelationTerm *t = &mech->relation_terms[relation->first_term + k];
            row[n++] = t->is_distance ? (int32_t)o + t->index : t->index;
        }
        matched += yk_matching_add(&m, row, n, true);
    }
    size_t freedom = columns - 1 - matched; // column 0 is the ground's orientation
    for (size_t k = 0; k < c->count && freedom > 0; k++) {
        const YkTreeCoordinate *q = &mech->coordinates[c->candidates[k]];
        YkJointAngle angle = yk_joint_angle(mech, q->joint);
        size_t n = 0;
        if (q->is_distance)
            row[n++] = (int32_t)o + q->distance;
        else if (angle.a != angle.b)
            for (int end = 0; end < 2; end++)
                if ((end ? angle.b : angle.a) > 0) row[n++] = end ? angle.b : angle.a;
        if (n > 0 && yk_matching_add(&m, row, n, false)) {
            c->accepted[k] = true;
            freedom--;
        }
    }
    return true;
}

static void take_accepted(Choice *c)
{
    YkMechanism *mech = c->mech;
    mech->input_count = 0;
    for (size_t k = 0; k < mech->coordinate_count; k++) mech->coordinates[k].input = YK_NONE;
    for (size_t k = 0; k < c->count; k++) {
        if (!c->accepted[k]) continue;
        mech->coordinates[c->candidates[k]].input = (int32_t)mech->input_count;
        mech->inputs[mech->input_count++] = c->candidates[k];
    }
}

// Decides by the rank of the assembled machine if groups are left or constraints repeat: counting is then not enough.
static bool accept_by_rank(Choice *c, bool is_peeled, YkClosedPose *pose)
{
    int freedom;
    size_t variables = yk_variable_count(c->mech);
    double *guess = YK_NEW(c->arena, double, c->mech->coordinate_count + 1);
    pose->x = YK_NEW(c->arena, double, variables + 1);
    pose->is_repeated = YK_NEW(c->arena, bool, variables + 1);
    if (yk_arena_failed(c->arena)) return false;
    yk_start_guess(c->mech, guess);
    YkCandidates wish = {c->candidates, c->count, c->wanted + c->driven, c->accepted, is_peeled};
    return yk_closure_freedom(c->mech, guess, &wish, &freedom, pose);
}

// Reports a gearbox in neutral: more freedoms than drives, and locks from which none was chosen.
static void report_open_lock(Choice *c)
{
    const YkModel *model = c->mech->model;
    size_t given = c->wanted;
    for (size_t k = 0; k < c->mech->input_count; k++) {
        const YkTreeCoordinate *q = &c->mech->coordinates[c->mech->inputs[k]];
        bool is_wanted = false;
        for (size_t w = 0; w < c->wanted; w++) is_wanted |= c->candidates[w] == c->mech->inputs[k];
        given += q->drive != YK_NONE && !is_wanted;
    }
    if (model->lock_count == 0 || model->engaged || c->mech->input_count <= given) return;
    yk_problem(c->problems, YK_CODE_LOCK_OPEN, model->locks[0].place,
               "none of the locks is engaged, and %z of %z freedoms %s neither driven nor set",
               c->mech->input_count - given, c->mech->input_count, c->mech->input_count - given == 1 ? "is" : "are");
    yk_problem_hint(c->problems, "--lock %s", model->locks[0].name);
}

// Checks that the requested inputs were accepted; returns false if one was not.
static bool report_overdriven(Choice *c)
{
    YkMechanism *mech = c->mech;
    bool ok = true;
    size_t used = 0, refused = 0, others = 0;
    for (size_t k = 0; k < c->wanted; k++)
        if (c->accepted[k] && mech->coordinates[c->candidates[k]].drive == YK_NONE) used++;
    for (size_t k = 0; k < c->wanted + c->driven; k++) others += c->accepted[k];
    for (size_t k = c->wanted; k < c->wanted + c->driven; k++) {
        if (c->accepted[k] || refused++ < used) continue;
        const YkTreeCoordinate *q = &mech->coordinates[c->candidates[k]];
        yk_problem(c->problems, YK_CODE_OVERDRIVEN, mech->model->drives[q->drive].place,
                   "%q is driven, but %s already fix it: the machine has %z freedom%s", q->name,
                   others > 0 ? "the other drives" : "the joints", mech->input_count,
                   mech->input_count == 1 ? "" : "s");
        yk_problem_hint(c->problems,
                        others > 0 ? "remove a drive, or a joint" : "drive another coordinate, or remove a joint");
        ok = false;
    }
    for (size_t k = 0; k < c->wanted; k++) {
        if (c->accepted[k]) continue;
        yk_problem(c->problems, YK_CODE_OVERDRIVEN, (YkPlace){0},
                   "coordinate %q cannot be set as well: the machine has %z freedom%s",
                   mech->coordinates[c->candidates[k]].name, mech->input_count, mech->input_count == 1 ? "" : "s");
        ok = false;
    }
    return ok;
}

static bool plan(Choice *c, const YkClosedPose *pose, size_t *missing)
{
    YkPlan p;
    YkArena *scratch = yk_arena_new();
    bool ok = scratch && yk_plan_make(&p, c->mech, c->incidence, pose, scratch);
    if (ok) *missing = p.missing;
    if (scratch) yk_plan_end(&p);
    yk_arena_free(scratch);
    return ok;
}

// Machines with this many unknowns or fewer are measured by rank even if counting finds nothing wrong: dimensions can
// be special.
enum { RANK_ALWAYS_MAX = 40 };

static bool choose(Choice *c, const YkCompileOptions *options)
{
    YkMechanism *mech = c->mech;
    size_t missing = 0;
    if (!propose_all(c, options) || !accept_by_structure(c)) return false;
    take_accepted(c);
    if (!plan(c, NULL, &missing)) return false;
    bool is_peeled = !mech->has_groups && missing == 0 && mech->redundant_count + mech->redundant_relation_count == 0;
    if (!is_peeled || yk_variable_count(mech) <= RANK_ALWAYS_MAX) { // at most twice: structure, then rank
        YkClosedPose pose;
        bool *counted = YK_NEW(c->arena, bool, c->count + 1);
        if (!counted) return false;
        memcpy(counted, c->accepted, c->count * sizeof *counted);
        if (!accept_by_rank(c, is_peeled, &pose)) return false;
        take_accepted(c);
        bool is_same = is_peeled && memcmp(counted, c->accepted, c->count * sizeof *counted) == 0;
        if (!is_same && !plan(c, &pose, &missing)) return false;
    }
    bool ok = report_overdriven(c);
    if (ok) report_open_lock(c);
    if (missing > 0)
        yk_problem(c->problems, YK_CODE_UNDETERMINED, (YkPlace){0},
                   "neither the loops nor the inputs determine %z unknowns of the machine", missing);
    return ok && missing == 0;
}

bool yk_inputs_choose(YkMechanism *mech, const YkIncidence *incidence, const YkCompileOptions *options,
                      YkProblems *problems)
{
    Choice c = {.mech = mech, .incidence = incidence, .problems = problems, .arena = yk_arena_new()};
    bool ok = c.arena != NULL;
    if (ok) {
        c.candidates = YK_NEW(c.arena, int32_t, mech->coordinate_count + 1);
        c.is_candidate = YK_NEW(c.arena, bool, mech->coordinate_count + 1);
        c.accepted = YK_NEW(c.arena, bool, mech->coordinate_count + 1);
        ok = !yk_arena_failed(c.arena) && choose(&c, options);
    }
    yk_arena_free(c.arena);
    return ok;
}
