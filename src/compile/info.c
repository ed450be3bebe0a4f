// Answers questions about a mechanism.
#include <string.h>
#include "compile/mechanism.h"

enum { LONGEST = 240 }; // name

const YkModel *yk_mechanism_model(const YkMechanism *mech)
{
    return mech->model;
}
double yk_mechanism_size(const YkMechanism *mech)
{
    return mech->size;
}

size_t yk_coordinate_count(const YkMechanism *mech)
{
    return mech->coordinate_count;
}

// Returns the joint of the file to which a joint belongs.
static int32_t shown_joint(const YkModel *model, int32_t joint)
{
    return (int32_t)(yk_joint_end(model, (size_t)joint, 1) - model->joints);
}

YkCoordinateInfo yk_coordinate_info(const YkMechanism *mech, size_t coordinate)
{
    if (coordinate >= mech->coordinate_count) return (YkCoordinateInfo){.joint = YK_NOT_FOUND, .input = -1};
    const YkTreeCoordinate *c = &mech->coordinates[coordinate];
    return (YkCoordinateInfo){.name = c->name,
                              .joint = (size_t)shown_joint(mech->model, c->joint),
                              .is_distance = c->is_distance,
                              .is_declared = c->is_declared,
                              .has_drive = c->drive != YK_NONE,
                              .is_held = c->drive != YK_NONE && mech->model->drives[c->drive].is_hold,
                              .has_start = c->has_start,
                              .input = c->input};
}

int32_t yk_tree_coordinate(const YkMechanism *mech, int32_t joint, bool is_distance)
{
    const YkModel *model = mech->model;
    const YkTreeCoordinate *c = mech->coordinates;
    size_t low = 0, high = mech->coordinate_count; // sorted by the joints of the file
    int32_t shown = shown_joint(model, joint);
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (shown_joint(model, c[middle].joint) < shown)
            low = middle + 1;
        else
            high = middle;
    }
    for (; low < mech->coordinate_count && shown_joint(model, c[low].joint) == shown; low++)
        if (c[low].joint == joint && c[low].is_distance == is_distance) return (int32_t)low;
    return YK_NONE;
}

int32_t yk_law_relation(const YkMechanism *mech, size_t coordinate)
{
    const YkModel *model = mech->model;
    for (size_t k = 0; model->follow_count > 0 && k < mech->relation_count; k++) {
        const YkRelation *r = &mech->relations[k];
        if (r->kind != YK_RELATION_LAW) continue;
        const YkCoordinate *own = &model->coordinates[model->follows[r->index].coordinate];
        if (yk_tree_coordinate(mech, own->joint, own->is_distance) == (int32_t)coordinate) return (int32_t)k;
    }
    return YK_NONE;
}

// Returns the coordinate that a name may mean: one of the file, or one that is named after its joint.
static int32_t namesake(const YkMechanism *mech, const char *name)
{
    const YkModel *model = mech->model;
    int32_t declared = yk_names_find(&model->coordinate_names, name);
    if (declared != YK_NONE)
        return yk_tree_coordinate(mech, model->coordinates[declared].joint, model->coordinates[declared].is_distance);
    const char *dot = strrchr(name, '.');
    char joint[LONGEST];
    if (!dot || (size_t)(dot - name) >= sizeof joint) return YK_NONE;
    memcpy(joint, name, (size_t)(dot - name));
    joint[dot - name] = 0;
    int32_t found = yk_names_find(&model->joint_names, joint);
    return found == YK_NONE ? YK_NONE : yk_tree_coordinate(mech, found, strcmp(dot, ".distance") == 0);
}

size_t yk_coordinate_find(const YkMechanism *mech, const char *name)
{
    int32_t found = namesake(mech, name);
    if (found != YK_NONE && strcmp(mech->coordinates[found].name, name) == 0) return (size_t)found;
    bool may_hide = mech->model->carriage_count > 0 || strlen(name) >= LONGEST;
    for (size_t k = 0; may_hide && k < mech->coordinate_count; k++) // of joints that the file does not name
        if (strcmp(mech->coordinates[k].name, name) == 0) return k;
    return YK_NOT_FOUND;
}

size_t yk_tree_path(const YkMechanism *mech, int32_t body, size_t from, int32_t *path)
{
    size_t end = (size_t)mech->tree.depth[body] + 1, last = end < from + YK_TREE_PATH ? end : from + YK_TREE_PATH;
    for (; end > last; end--) body = mech->tree.parent[body];
    for (size_t depth = last; depth > from; depth--, body = mech->tree.parent[body]) path[depth - 1 - from] = body;
    return last > from ? last - from : 0;
}

size_t yk_input_count(const YkMechanism *mech)
{
    return mech->input_count;
}
size_t yk_input_coordinate(const YkMechanism *mech, size_t input)
{
    return input < mech->input_count ? (size_t)mech->inputs[input] : YK_NOT_FOUND;
}

YkFreedom yk_mechanism_freedom(const YkMechanism *mech)
{
    YkFreedom f = {.gruebler = mech->gruebler, .by_rank = (int)mech->input_count};
    f.redundant = (size_t)(f.by_rank - f.gruebler);
    for (size_t k = 0; k < mech->coordinate_count; k++) f.driven += mech->coordinates[k].drive != YK_NONE;
    return f;
}

size_t yk_loop_count(const YkMechanism *mech)
{
    return mech->loop_count;
}
size_t yk_loop_joint(const YkMechanism *mech, size_t loop)
{
    return loop < mech->loop_count ? (size_t)mech->loops[loop].joint : YK_NOT_FOUND;
}

static int32_t meeting(const YkTree *tree, int32_t a, int32_t b)
{
    while (a != b) {
        if (tree->depth[a] >= tree->depth[b])
            a = tree->parent[a];
        else
            b = tree->parent[b];
    }
    return a;
}

static bool is_carriage(const YkMechanism *mech, int32_t body)
{
    return mech->model->bodies[body].is_carriage;
}

// Lists the bodies, without carriages, from the joint's first one up to where the paths meet, and down to its second.
size_t yk_loop_bodies(const YkMechanism *mech, size_t loop, size_t *bodies, size_t capacity)
{
    if (loop >= mech->loop_count) return 0;
    const YkJoint *joint = &mech->model->joints[mech->loops[loop].joint];
    const YkTree *tree = &mech->tree;
    int32_t top = meeting(tree, joint->body[0], joint->body[1]);
    size_t count = 0, place;
    for (int32_t b = joint->body[0];; b = tree->parent[b]) {
        if (!is_carriage(mech, b) && count++ < capacity) bodies[count - 1] = (size_t)b;
        if (b == top) break;
    }
    for (int32_t b = joint->body[1]; b != top; b = tree->parent[b]) count += !is_carriage(mech, b);
    place = count;
    for (int32_t b = joint->body[1]; b != top; b = tree->parent[b])
        if (!is_carriage(mech, b) && --place < capacity) bodies[place] = (size_t)b;
    return count;
}

size_t yk_block_count(const YkMechanism *mech)
{
    return mech->block_count;
}

// A member of a block: a joint or a body. One half of a free joint stands for both, and carriages are left out.
static bool is_told(const YkMechanism *mech, const YkBlock *b, uint32_t k)
{
    int32_t member = mech->block_members[k];
    if (k < b->aside->first_joint || k >= b->aside->first_joint + b->aside->joint_count)
        return !is_carriage(mech, member);
    const YkJoint *joint = &mech->model->joints[member];
    if (!joint->is_free || joint->kind == YK_PIN_SLOT) return true;
    for (uint32_t i = b->aside->first_joint; i < b->aside->first_joint + b->aside->joint_count; i++)
        if (mech->block_members[i] == joint->partner) return false;
    return true;
}

static size_t count_told(const YkMechanism *mech, const YkBlock *b, uint32_t first, uint32_t count)
{
    size_t told = 0;
    for (uint32_t k = first; k < first + count; k++) told += is_told(mech, b, k);
    return told;
}

// Returns the member number `index` of those that are shown, YK_NONE past the last.
static int32_t told_at(const YkMechanism *mech, const YkBlock *b, uint32_t first, uint32_t count, size_t index)
{
    bool all_are = mech->model->carriage_count == 0;
    if (all_are) return index < count ? mech->block_members[first + index] : YK_NONE;
    for (uint32_t k = first; k < first + count; k++)
        if (is_told(mech, b, k) && index-- == 0) return mech->block_members[k];
    return YK_NONE;
}

YkBlockInfo yk_block_info(const YkMechanism *mech, size_t block)
{
    if (block >= mech->block_count) return (YkBlockInfo){.label = NULL};
    const YkBlock *b = &mech->blocks[block];
    return (YkBlockInfo){.kind = b->kind,
                         .label = b->label,
                         .assur_class = b->aside->assur_class,
                         .unknowns = b->column_count,
                         .equations = b->kind == YK_BLOCK_GROUP ? yk_block_rows(b) : 2,
                         .joint_count = count_told(mech, b, b->aside->first_joint, b->aside->joint_count),
                         .body_count = count_told(mech, b, b->aside->first_body, b->aside->body_count),
                         .relation_count = b->relation_count};
}

size_t yk_block_joint(const YkMechanism *mech, size_t block, size_t index)
{
    if (block >= mech->block_count) return YK_NOT_FOUND;
    const YkBlock *b = &mech->blocks[block];
    int32_t joint = told_at(mech, b, b->aside->first_joint, b->aside->joint_count, index);
    return joint == YK_NONE ? YK_NOT_FOUND : (size_t)shown_joint(mech->model, joint);
}
size_t yk_block_body(const YkMechanism *mech, size_t block, size_t index)
{
    if (block >= mech->block_count) return YK_NOT_FOUND;
    const YkBlock *b = &mech->blocks[block];
    int32_t body = told_at(mech, b, b->aside->first_body, b->aside->body_count, index);
    return body == YK_NONE ? YK_NOT_FOUND : (size_t)body;
}

const char *yk_block_relation(const YkMechanism *mech, size_t block, size_t index)
{
    if (block >= mech->block_count || index >= mech->blocks[block].relation_count) return NULL;
    return mech->relations[mech->group_relations[mech->blocks[block].first_relation + index]].name;
}

const char *yk_block_kind_name(YkBlockKind kind)
{
    static const char *const names[] = {"RRR dyad",       "RRP dyad",       "RPR dyad", "PP dyad",
                                        "redundant link", "redundant loop", "group"};
    return names[kind];
}

size_t yk_redundant_count(const YkMechanism *mech)
{
    return mech->redundant_count;
}
size_t yk_redundant_joint(const YkMechanism *mech, size_t index)
{
    return index < mech->redundant_count ? (size_t)mech->redundant[index] : YK_NOT_FOUND;
}
