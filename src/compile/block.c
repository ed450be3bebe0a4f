// Turns a closed loop into a block: what is known, what is unknown, and which closed form solves it.
#include "compile/judge.h"

typedef struct Parts { // of a loop
    YkTermList known, arm[2];
    int32_t root[2];
    size_t angles;
    YkTerm line[2]; // unknown distances, with their lines
    int32_t line_node[2];
    bool line_turns[2]; // the line belongs to an unknown orientation
    size_t lines;
    bool too_many;
} Parts;

static size_t angle_column(Parts *p, int32_t root)
{
    for (size_t k = 0; k < p->angles; k++)
        if (p->root[k] == root) return k;
    if (p->angles == 2) {
        p->too_many = true;
        return 0;
    }
    p->root[p->angles] = root;
    return p->angles++;
}

static void sort_term(const YkPlan *plan, Parts *p, size_t k)
{
    YkTerm term = plan->list.items[k];
    int32_t node = yk_terms_node(&plan->list, k);
    const YkMechanism *mech = plan->mech;
    int32_t root = mech->group_root[term.slot];
    bool open_distance = term.distance != YK_NONE && !plan->distance_known[term.distance];
    if (!open_distance && plan->root_known[root]) {
        yk_terms_add_node(&p->known, term, node, 1);
        return;
    }
    if (!plan->root_known[root]) {
        size_t column = angle_column(p, root);
        term.slot = mech->relative_slot[term.slot];
        if (!open_distance) yk_terms_add_node(&p->arm[column], term, node, 1);
    }
    if (!open_distance) return;
    if (p->lines == 2) {
        p->too_many = true;
        return;
    }
    p->line_turns[p->lines] = !plan->root_known[root];
    p->line_node[p->lines] = node;
    p->line[p->lines++] = term;
}

static void sort_terms(const YkPlan *plan, Parts *p)
{
    const YkTermList *list = &plan->list;
    p->known.recipe = p->arm[0].recipe = p->arm[1].recipe = list->recipe;
    yk_terms_clear(&p->known);
    yk_terms_clear(&p->arm[0]);
    yk_terms_clear(&p->arm[1]);
    p->known.constant = list->constant;
    p->known.constant_node = list->constant_node;
    p->known.plus = list->plus;
    p->known.minus = list->minus;
    for (size_t k = 0; k < list->count; k++)
        if (yk_terms_is_there(list, k)) sort_term(plan, p, k);
}

static bool is_constant(const YkTermList *arm)
{
    for (size_t k = 0; k < arm->count; k++)
        if (yk_terms_is_there(arm, k)) return false;
    return true;
}

static bool is_zero_arm(const YkPlan *plan, const YkTermList *arm)
{
    return is_constant(arm) && yk_norm(arm->constant) <= YK_CLOSURE_ROUNDING * plan->mech->size;
}

static bool are_parallel(const YkTerm *a, const YkTerm *b)
{
    return a->slot == b->slot && fabs(yk_cross(a->v, b->v)) < 1e-12;
}

// Finds the kind that the parts make; returns false if they make none that can be solved.
static bool kind_of(const YkPlan *plan, const Parts *p, YkBlockKind *kind)
{
    if (p->too_many) return false;
    if (p->angles == 2 && p->lines == 0) {
        *kind = YK_BLOCK_RRR;
        return !is_zero_arm(plan, &p->arm[0]) && !is_zero_arm(plan, &p->arm[1]);
    }
    if (p->angles == 1 && p->lines == 1) {
        *kind = p->line_turns[0] ? YK_BLOCK_RPR : YK_BLOCK_RRP;
        return p->line_turns[0] || !is_zero_arm(plan, &p->arm[0]);
    }
    if (p->angles == 0 && p->lines == 2) {
        *kind = YK_BLOCK_PP;
        return !are_parallel(&p->line[0], &p->line[1]);
    }
    *kind = p->angles + p->lines == 0 ? YK_BLOCK_CHECK : YK_BLOCK_LINK;
    return p->angles == 0 || !is_zero_arm(plan, &p->arm[0]);
}

// Puts angles in the order of their orientations, so that the sign of a branch does not depend on the direction round
// the loop.
static void order_angles(Parts *p)
{
    if (p->angles < 2 || p->root[0] < p->root[1]) return;
    YkTermList arm = p->arm[0];
    int32_t root = p->root[0];
    p->arm[0] = p->arm[1];
    p->arm[1] = arm;
    p->root[0] = p->root[1];
    p->root[1] = root;
}

static void order_lines(Parts *p)
{
    if (p->lines < 2 || p->line[0].distance < p->line[1].distance) return;
    YkTerm line = p->line[0];
    int32_t node = p->line_node[0];
    p->line[0] = p->line[1];
    p->line[1] = line;
    p->line_node[0] = p->line_node[1];
    p->line_node[1] = node;
}

YkBlock *yk_plan_new_block(YkPlan *plan, YkBlockKind kind, const int32_t *joints, size_t count)
{
    YkMechanism *mech = plan->mech;
    if (!YK_ROOM(mech->blocks, mech->block_count, mech->block_capacity)) {
        plan->failed = true;
        return NULL;
    }
    YkBlock *block = &mech->blocks[mech->block_count];
    *block = (YkBlock){.kind = kind, .aside = YK_NEW(mech->arena, YkBlockAside, 1)};
    if (!block->aside) {
        plan->failed = true;
        return NULL;
    }
    block->aside->first_joint = (uint32_t)mech->member_count;
    block->aside->joint_count = (uint32_t)count;
    // labelled by the joint that closes its loop in the tree of coordinates, otherwise by its middle joint
    int32_t label = joints[count / 2];
    for (size_t k = 0; k < count; k++) {
        const YkJoint *j = &mech->model->joints[joints[k]];
        if (mech->tree.joint[j->body[0]] != joints[k] && mech->tree.joint[j->body[1]] != joints[k]) label = joints[k];
        if (!YK_ROOM(mech->block_members, mech->member_count, mech->member_capacity)) {
            plan->failed = true;
            return NULL;
        }
        mech->block_members[mech->member_count++] = joints[k];
    }
    block->label = mech->model->joints[label].name;
    block->aside->assur_class = kind <= YK_BLOCK_PP ? 2 : 0;
    block->aside->first_body = (uint32_t)mech->member_count;
    mech->block_count++;
    return block;
}

void yk_plan_block_bodies(YkPlan *plan, YkBlock *block, const int32_t *clusters, size_t count)
{
    YkMechanism *mech = plan->mech;
    block->aside->first_body = (uint32_t)mech->member_count;
    for (size_t c = 0; c < count; c++)
        for (uint32_t k = plan->cluster_first[clusters[c]]; k < plan->cluster_first[clusters[c] + 1]; k++) {
            if (!YK_ROOM(mech->block_members, mech->member_count, mech->member_capacity)) {
                plan->failed = true;
                return;
            }
            mech->block_members[mech->member_count++] = plan->cluster_member[k];
        }
    block->aside->body_count = (uint32_t)mech->member_count - block->aside->first_body;
}

static double share_of(const YkBlock *block, int k, double per_enough2)
{
    return yk_arm_share(yk_dot(block->aside->arm[k].constant, block->aside->arm[k].constant), per_enough2);
}

// Finds the form. per_enough2 is that of the arms, as for yk_arm_share. In long machines all arms are short.
static YkBlockForm form_of(const YkBlock *block, double per_enough2)
{
    YkVec arm = block->aside->arm[0].constant;
    bool is_axial = yk_is_axial(block->line[0]), is_fixed = block->line_slot[0] == 0;
    if (!block->arm_is_constant[0]) return YK_FORM_RARE;
    if (block->kind == YK_BLOCK_RRR && block->arm_is_constant[1]) {
        if (share_of(block, 0, per_enough2) < 1 || share_of(block, 1, per_enough2) < 1) return YK_FORM_RRR_SHORT;
        return yk_is_axial(arm) && yk_is_axial(block->aside->arm[1].constant) ? YK_FORM_RRR_AXIAL : YK_FORM_RRR;
    }
    if (block->kind != YK_BLOCK_RPR && share_of(block, 0, per_enough2) < 1) return YK_FORM_RARE;
    if (block->kind == YK_BLOCK_RRP && !is_fixed) return YK_FORM_RRP_TURNING;
    if (block->kind == YK_BLOCK_RRP) return is_axial && yk_is_axial(arm) ? YK_FORM_RRP_AXIAL : YK_FORM_RRP;
    if (block->kind != YK_BLOCK_RPR || !is_fixed) return YK_FORM_RARE;
    return is_axial && arm.x == 0 && arm.y == 0 ? YK_FORM_RPR_AXIAL : YK_FORM_RPR;
}

// Adds the lengths of a sum's vectors to `length`, with those of the nodes from which it starts, until it is `enough`.
static double add_lengths(const YkMechanism *mech, const YkSum *sum, double length, double enough, int depth)
{
    enum { DEPTH = 64 };
    if (depth > DEPTH) return enough;
    length += yk_norm(sum->constant);
    for (uint32_t k = 0; k < sum->count && length < enough; k++) {
        YkTerm term = mech->terms[sum->first + k];
        if (term.distance == YK_NONE) length += yk_norm(term.v);
    }
    for (int side = 0; side < 2 && length < enough; side++) {
        int32_t node = side == 0 ? sum->plus : sum->minus;
        if (node != YK_NONE) length = add_lengths(mech, &mech->node_sums[node], length, enough, depth + 1);
    }
    return length;
}

double yk_block_size(const YkMechanism *mech, const YkBlock *block)
{
    const double SMALL = 1e-3; // over the size
    double enough = SMALL * mech->size, length = 0;
    if (block->kind > YK_BLOCK_RPR) return mech->size;
    for (int k = 0; k < (block->kind == YK_BLOCK_RRR ? 2 : 1) && length < enough; k++)
        length = add_lengths(mech, &block->aside->arm[k], length, enough, 0);
    if (length < enough) length = add_lengths(mech, &block->known, length, enough, 0);
    return length > 0 && length < enough ? length : mech->size;
}

void yk_block_measure(YkBlock *block, double size)
{
    double per_size2 = 1 / (size * size), per_enough2 = YK_PER_ARM_ENOUGH2 * per_size2;
    block->per_size2 = per_size2;
    const YkSum *arm = block->aside->arm;
    block->form = form_of(block, per_enough2);
    if (block->form == YK_FORM_RRR || block->form == YK_FORM_RRR_AXIAL || block->form == YK_FORM_RRR_SHORT)
        block->pair = yk_arm_pair(arm[0].constant, arm[1].constant, per_enough2, per_enough2);
    else if (block->kind == YK_BLOCK_RRP)
        block->circle = yk_arm_circle(arm[0].constant, per_enough2);
}

double yk_distance_unit(const YkMechanism *mech)
{
    const double WIDE = 100, NONE = 1e-6; // shorter ones, over the size, are offsets that should be 0
    double least = mech->size;
    for (size_t b = 0; b < mech->block_count; b++) {
        const YkBlock *block = &mech->blocks[b];
        double none = NONE * yk_block_size(mech, block);
        for (size_t k = 0; k < 2 && block->kind <= YK_BLOCK_RRP; k++) {
            double arm = block->arm_is_constant[k] ? yk_norm(block->aside->arm[k].constant) : 0;
            if (arm > none) least = fmin(least, arm);
        }
    }
    for (size_t k = 0; k < mech->model->rack_count; k++) least = fmin(least, fabs(mech->model->racks[k].radius));
    return least > 0 ? fmin(mech->size, WIDE * least) : mech->size;
}

static size_t columns_of(const Parts *p, YkColumn columns[4])
{
    size_t count = 0;
    for (size_t k = 0; k < p->angles; k++) columns[count++] = (YkColumn){false, p->root[k]};
    for (size_t k = 0; k < p->lines; k++) columns[count++] = (YkColumn){true, p->line[k].distance};
    return count;
}

static void fill_block(YkPlan *plan, YkBlock *block, const Parts *p)
{
    YkMechanism *mech = plan->mech;
    bool ok = yk_terms_store(&p->known, mech, &block->known);
    for (size_t k = 0; k < p->angles; k++) {
        ok = ok && yk_terms_store(&p->arm[k], mech, &block->aside->arm[k]);
        block->arm_is_constant[k] = is_constant(&p->arm[k]);
    }
    for (size_t k = 0; k < p->lines; k++) {
        block->line_slot[k] = p->line[k].slot;
        block->line[k] = p->line[k].v;
        yk_recipe_note_line(mech->recipe, (int32_t)(block - mech->blocks), (int32_t)k, p->line_node[k]);
    }
    YkColumn columns[4];
    block->column_count = (uint32_t)columns_of(p, columns);
    for (uint32_t k = 0; k < block->column_count; k++) block->column[k] = columns[k];
    if (ok) yk_block_measure(block, yk_block_size(mech, block));
    if (!ok) plan->failed = true;
}

static void note_redundant(YkPlan *plan, const YkBlock *block)
{
    YkMechanism *mech = plan->mech;
    if (block->kind != YK_BLOCK_LINK && block->kind != YK_BLOCK_CHECK) return;
    if (!YK_ROOM(mech->redundant, mech->redundant_count, mech->redundant_capacity)) {
        plan->failed = true;
        return;
    }
    mech->redundant[mech->redundant_count++] =
        mech->block_members[block->aside->first_joint + block->aside->joint_count - 1];
}

bool yk_plan_block(YkPlan *plan, const int32_t *joints, size_t count, size_t expected)
{
    Parts parts = {0};
    YkBlockKind kind;
    sort_terms(plan, &parts);
    order_angles(&parts);
    order_lines(&parts);
    YkColumn columns[4];
    size_t unknowns = columns_of(&parts, columns);
    bool is_block = kind_of(plan, &parts, &kind) && unknowns == expected && yk_judge_block(plan, columns, unknowns);
    if (is_block) {
        YkBlock *block = yk_plan_new_block(plan, kind, joints, count);
        if (block) {
            fill_block(plan, block, &parts);
            note_redundant(plan, block);
            yk_plan_step(plan, (YkStep){.kind = YK_STEP_BLOCK, .target = (int32_t)plan->mech->block_count - 1});
            for (size_t k = 0; k < expected; k++) yk_plan_learn(plan, columns[k]);
        }
    }
    if (parts.known.failed || parts.arm[0].failed || parts.arm[1].failed) plan->failed = true;
    yk_terms_free(&parts.known);
    yk_terms_free(&parts.arm[0]);
    yk_terms_free(&parts.arm[1]);
    return is_block && !plan->failed;
}
