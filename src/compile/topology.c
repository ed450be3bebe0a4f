// Finds orientations and distances, grows the spanning tree, and closes its loops.
#include "compile/topology.h"
#include "compile/terms.h"
#include "base/problems.h"

bool yk_incidence_build(YkIncidence *incidence, YkArena *arena, const YkModel *model)
{
    size_t n = model->body_count;
    uint32_t *first = incidence->first = YK_NEW(arena, uint32_t, n + 2);
    incidence->joint = YK_NEW(arena, int32_t, 2 * model->joint_count + 1);
    if (yk_arena_failed(arena)) return false;
    for (size_t j = 0; j < model->joint_count; j++)
        for (int k = 0; k < 2; k++) first[model->joints[j].body[k] + 2]++;
    for (size_t b = 0; b < n; b++) first[b + 2] += first[b + 1];
    for (size_t j = 0; j < model->joint_count; j++)
        for (int k = 0; k < 2; k++) incidence->joint[first[model->joints[j].body[k] + 1]++] = (int32_t)j;
    return true;
}

// Returns whether the joint keeps the angle between its bodies.
static bool keeps_angle(const YkJoint *joint)
{
    return !yk_part(joint->kind)->turns;
}

// Checks a slide or weld that returns to a body whose turn is known: the two must agree.
static void check_turn(const YkMechanism *mech, const YkJoint *joint, YkProblems *problems, bool *ok)
{
    const YkPlacing *a = &mech->bodies[joint->body[0]], *b = &mech->bodies[joint->body[1]];
    double off = yk_nearest_turn(a->turn + joint->turned - b->turn, 0);
    if (fabs(off) <= 1e-12) return;
    yk_problem(problems, YK_CODE_TURNS_DISAGREE, joint->place,
               "joint %q would turn %q by %e deg against what the other slides and welds allow", joint->name,
               mech->model->bodies[joint->body[1]].name, off * 180 / YK_PI);
    yk_problem_hint(
        problems,
        "a slide or weld keeps the angle of its bodies: give `turned:` so that the angles round the loop add up");
    *ok = false;
}

bool yk_topology_orientations(YkMechanism *mech, const YkIncidence *incidence, YkProblems *problems)
{
    const YkModel *model = mech->model;
    bool ok = true;
    mech->bodies = YK_NEW(mech->arena, YkPlacing, model->body_count);
    mech->orientation_body = YK_NEW(mech->arena, int32_t, model->body_count);
    mech->joint_distance = YK_NEW(mech->arena, int32_t, model->joint_count + 1);
    int32_t *queue = YK_NEW(mech->arena, int32_t, model->body_count);
    if (yk_arena_failed(mech->arena)) return false;
    for (size_t b = 0; b < model->body_count; b++) mech->bodies[b].orientation = YK_NONE;
    for (size_t start = 0; start < model->body_count; start++) {
        if (mech->bodies[start].orientation != YK_NONE) continue;
        int32_t o = (int32_t)mech->orientation_count++;
        size_t head = 0, tail = 0;
        mech->orientation_body[o] = (int32_t)start;
        mech->bodies[start].orientation = o;
        queue[tail++] = (int32_t)start;
        while (head < tail && yk_compile_goes_on(mech, 1)) {
            int32_t b = queue[head++];
            for (uint32_t k = incidence->first[b]; k < incidence->first[b + 1]; k++) {
                const YkJoint *joint = &model->joints[incidence->joint[k]];
                int32_t c = yk_other_body(model, incidence->joint[k], b);
                if (!keeps_angle(joint) || mech->bodies[c].orientation != YK_NONE) continue;
                mech->bodies[c].orientation = o;
                mech->bodies[c].turn = mech->bodies[b].turn + (joint->body[0] == b ? joint->turned : -joint->turned);
                queue[tail++] = c;
            }
        }
    }
    for (size_t b = 0; b < model->body_count; b++) {
        double turn = mech->bodies[b].turn;
        mech->bodies[b].turn_unit = turn == 0 ? yk_vec(1, 0) : yk_unit(turn);
    }
    for (size_t j = 0; j < model->joint_count; j++) {
        const YkJoint *joint = &model->joints[j];
        mech->joint_distance[j] = yk_part(joint->kind)->slides ? (int32_t)mech->distance_count++ : YK_NONE;
        if (keeps_angle(joint)) check_turn(mech, joint, problems, &ok);
    }
    return ok;
}

static bool is_declared(const YkJoint *joint)
{
    return joint->angle != YK_NONE || joint->distance != YK_NONE;
}

typedef struct Growth { // of the spanning tree
    YkMechanism *mech;
    const YkIncidence *incidence;
    int32_t *queue, *stack;
    bool *is_reached;
    size_t head, tail, depth;
} Growth;

static void reach(Growth *g, int32_t body, int32_t parent, int32_t joint)
{
    g->is_reached[body] = true;
    g->mech->tree.parent[body] = parent;
    g->mech->tree.joint[body] = joint;
    g->mech->tree.depth[body] = parent == YK_NONE ? 0 : g->mech->tree.depth[parent] + 1;
    g->stack[g->depth++] = body;
}

// Takes a body and everything attached to it by declared coordinates: those joints become branches.
static void reach_declared(Growth *g, int32_t body, int32_t parent, int32_t joint)
{
    const YkModel *model = g->mech->model;
    reach(g, body, parent, joint);
    while (g->depth > 0) {
        int32_t b = g->stack[--g->depth];
        g->queue[g->tail++] = b;
        for (uint32_t k = g->incidence->first[b]; k < g->incidence->first[b + 1]; k++) {
            int32_t j = g->incidence->joint[k], other = yk_other_body(model, j, b);
            if (is_declared(&model->joints[j]) && !g->is_reached[other]) reach(g, other, b, j);
        }
    }
}

// Grows the tree breadth first from the ground; prefers short loops, and welds before slides before pins, where the
// file leaves the choice.
static void grow_tree(Growth *g)
{
    const YkModel *model = g->mech->model;
    static const YkPartKind order[] = {YK_WELD, YK_SLIDE, YK_PIN_SLOT, YK_PIN};
    reach_declared(g, 0, YK_NONE, YK_NONE);
    while (g->head < g->tail && yk_compile_goes_on(g->mech, 1)) {
        int32_t b = g->queue[g->head++];
        for (size_t kind = 0; kind < 4; kind++)
            for (uint32_t k = g->incidence->first[b]; k < g->incidence->first[b + 1]; k++) {
                int32_t j = g->incidence->joint[k], other = yk_other_body(model, j, b);
                if (model->joints[j].kind == order[kind] && !g->is_reached[other]) reach_declared(g, other, b, j);
            }
    }
}

static bool in_tree(const YkMechanism *mech, int32_t joint)
{
    const YkJoint *j = &mech->model->joints[joint];
    return mech->tree.joint[j->body[0]] == joint || mech->tree.joint[j->body[1]] == joint;
}

static const char *chosen_name(YkMechanism *mech, const char *joint, const char *suffix)
{
    size_t a = 0, b = 0;
    while (joint[a]) a++;
    while (suffix[b]) b++;
    char *name = YK_NEW(mech->arena, char, a + b + 1);
    for (size_t k = 0; name && k < a; k++) name[k] = joint[k];
    for (size_t k = 0; name && k < b; k++) name[a + k] = suffix[k];
    return name;
}

static void add_coordinate(YkMechanism *mech, int32_t joint, bool is_distance)
{
    const YkJoint *j = &mech->model->joints[joint];
    int32_t declared = is_distance ? j->distance : j->angle;
    YkTreeCoordinate *c = &mech->coordinates[mech->coordinate_count++];
    *c = (YkTreeCoordinate){.joint = joint,
                            .is_distance = is_distance,
                            .is_declared = declared != YK_NONE,
                            .drive = YK_NONE,
                            .input = YK_NONE,
                            .distance = YK_NONE};
    c->angle = yk_joint_angle(mech, joint);
    if (is_distance) c->distance = mech->joint_distance[joint];
    if (declared != YK_NONE) {
        c->name = mech->model->coordinates[declared].name;
        c->drive = mech->model->coordinates[declared].drive;
    } else {
        c->name = chosen_name(mech, j->name, is_distance ? ".distance" : ".angle");
    }
}

// Adds the coordinates of a joint; of a free joint all three with its half in the file's place: x, y, angle.
static void add_coordinates(YkMechanism *mech, int32_t joint)
{
    const YkJoint *j = &mech->model->joints[joint];
    const YkPart *part = yk_part(j->kind);
    if (j->is_free && !part->turns) return;
    if (j->is_free) add_coordinate(mech, j->partner, true);
    if (j->is_free) add_coordinate(mech, joint, true);
    if (part->turns) add_coordinate(mech, joint, false);
    if (part->slides && !j->is_free) add_coordinate(mech, joint, true);
}

static bool add_loop(YkMechanism *mech, int32_t joint, YkTermList *list)
{
    const YkJoint *j = &mech->model->joints[joint];
    yk_terms_clear(list);
    // From b's point back through the tree to a's point: r_a + at_a (+ d along) - r_b - at_b.
    yk_terms_cross(list, mech, joint, j->body[0], 1);
    yk_terms_walk(list, mech, &mech->tree, j->body[1], j->body[0]);
    mech->loops[mech->loop_count].joint = joint;
    return yk_terms_store(list, mech, &mech->loops[mech->loop_count++].sum);
}

static void report_closing_coordinate(const YkMechanism *mech, int32_t joint, YkProblems *problems)
{
    const YkJoint *j = &mech->model->joints[joint];
    int32_t c = j->angle != YK_NONE ? j->angle : j->distance;
    yk_problem(problems, YK_CODE_COORDINATE_CLOSES_LOOP, mech->model->coordinates[c].place,
               "coordinate %q of joint %q closes a loop of joints that all have coordinates",
               mech->model->coordinates[c].name, j->name);
    yk_problem_hint(problems,
                    "coordinates are measured along the spanning tree: leave one joint of each loop without a name; "
                    "its value can still be asked for as `%s.%s`",
                    j->name, j->angle != YK_NONE ? "angle" : "distance");
}

static void mark_starts(YkMechanism *mech)
{
    const YkModel *model = mech->model;
    for (size_t k = 0; k < model->start_count; k++) {
        const YkCoordinate *c = &model->coordinates[model->starts[k].coordinate];
        int32_t q = model->starts[k].is_rate ? YK_NONE : yk_tree_coordinate(mech, c->joint, c->is_distance);
        if (q != YK_NONE) mech->coordinates[q].has_start = true;
    }
}

static bool build_tables(YkMechanism *mech, YkProblems *problems)
{
    const YkModel *model = mech->model;
    size_t n = model->joint_count;
    YkTermList list = {.recipe = mech->recipe};
    bool ok = true;
    mech->coordinates = YK_NEW(mech->arena, YkTreeCoordinate, 2 * n + 1);
    mech->loops = YK_NEW(mech->arena, YkLoop, n + 1);
    if (yk_arena_failed(mech->arena)) return false;
    for (size_t j = 0; j < n && yk_compile_goes_on(mech, 1); j++) {
        const YkPart *part = yk_part(model->joints[j].kind);
        mech->gruebler -= part->constraints;
        if (in_tree(mech, (int32_t)j)) {
            add_coordinates(mech, (int32_t)j);
        } else if (is_declared(&model->joints[j])) {
            report_closing_coordinate(mech, (int32_t)j, problems);
            ok = false;
        } else {
            ok = add_loop(mech, (int32_t)j, &list) && ok;
        }
    }
    yk_terms_free(&list);
    mark_starts(mech);
    return ok && !yk_arena_failed(mech->arena);
}

bool yk_topology_tree(YkMechanism *mech, const YkIncidence *incidence, YkProblems *problems)
{
    size_t n = mech->model->body_count;
    Growth g = {.mech = mech, .incidence = incidence};
    mech->tree.parent = YK_NEW(mech->arena, int32_t, n);
    mech->tree.joint = YK_NEW(mech->arena, int32_t, n);
    mech->tree.depth = YK_NEW(mech->arena, int32_t, n);
    g.queue = mech->tree_order = YK_NEW(mech->arena, int32_t, n);
    g.stack = YK_NEW(mech->arena, int32_t, n);
    g.is_reached = YK_NEW(mech->arena, bool, n);
    if (yk_arena_failed(mech->arena)) return false;
    for (size_t b = 0; b < n; b++) mech->tree.parent[b] = mech->tree.joint[b] = YK_NONE;
    mech->gruebler = 3 * ((int)n - 1);
    grow_tree(&g);
    return build_tables(mech, problems);
}
