// Makes variants. A second mechanism, with the recipe of all its vectors, is compiled from a copy of the model at
// values slightly beside the file's, so that a vector which is 0 or cancels there by chance is kept.
#include "compile/variant.h"
#include "compile/relations.h"
#include <stdlib.h>
#include <string.h>
#include "base/problems.h"
#include "elementary/elementary.h"

// Returns a value beside the file's for parameter k: about 0.1 % off, by amounts that no sum or difference of a few
// makes 0 again.
static double beside(double own, size_t k, double sign)
{
    double part = sign * 1e-3 * (0.5 + yk_fmod((double)(k + 1) * 0.6180339887498949, 1));
    return own != 0 ? own * (1 + part) : part;
}

// Sets the values one by one. If a value beside the file's makes no machine - a restitution above 1 - it tries the
// other side; failing that, the file's value stays.
static bool set_one_by_one(const YkVariant *v, size_t count, const double *own, double *values)
{
    memcpy(values, own, count * sizeof *values);
    for (size_t k = 0; k < count; k++) {
        for (int side = 1; side >= -1; side -= 2) {
            values[k] = beside(own[k], k, side);
            if (yk_redesign_set(v->redesign, values) == YK_OK) break;
            values[k] = own[k];
        }
    }
    return yk_redesign_set(v->redesign, values) == YK_OK;
}

// Sets values beside the file's in the copy. values[count]: scratch.
static bool set_beside(const YkVariant *v, size_t count, const double *own, double *values)
{
    for (size_t k = 0; k < count; k++) values[k] = beside(own[k], k, 1);
    return yk_redesign_set(v->redesign, values) == YK_OK || set_one_by_one(v, count, own, values);
}

static bool same_plan(const YkMechanism *a, const YkMechanism *b)
{
    bool same = a->slot_count == b->slot_count && a->distance_count == b->distance_count &&
                a->block_count == b->block_count && a->input_count == b->input_count &&
                a->column_count == b->column_count && a->reference_count == b->reference_count;
    for (size_t k = 0; same && k < a->block_count; k++) same = a->blocks[k].kind == b->blocks[k].kind;
    for (size_t k = 0; same && k < a->input_count; k++) same = a->inputs[k] == b->inputs[k];
    for (size_t k = 0; same && k < a->column_count; k++) // their order determines the sign of a group's branch
        same = a->group_columns[k].is_distance == b->group_columns[k].is_distance &&
               a->group_columns[k].index == b->group_columns[k].index;
    return same;
}

static bool lacks_memory(const YkProblems *problems)
{
    for (size_t k = 0; k < yk_problems_count(problems); k++)
        if (yk_problems_get(problems, k)->code == YK_CODE_OUT_OF_MEMORY) return true;
    return false;
}

// Returns NULL if the copy is another machine, or, with v->failed set, when out of memory, which `problems` tell.
static YkMechanism *compile(YkVariant *v, const YkMechanism *mech, YkProblems *problems)
{
    const char **inputs = calloc(mech->input_count + 1, sizeof *inputs);
    YkMechanism *made = NULL;
    yk_recipe_end(&v->recipe);
    if (inputs && yk_recipe_start(&v->recipe, v->redesign)) {
        for (size_t i = 0; i < mech->input_count; i++) inputs[i] = mech->coordinates[mech->inputs[i]].name;
        YkCompileOptions options = {.inputs = inputs, .input_count = mech->input_count};
        made = yk_compile_with(yk_redesign_model(v->redesign), &options, &v->recipe, problems);
    }
    v->failed |= !inputs || v->recipe.failed || (!made && lacks_memory(problems));
    free((void *)inputs);
    if (made && !v->failed && same_plan(mech, made)) return made;
    yk_mechanism_free(made);
    return NULL;
}

// Compiles at values beside the file's. If these make another machine, the reasons are of no interest and are dropped.
static YkMechanism *compile_beside(YkVariant *v, const YkMechanism *mech)
{
    YkProblems *unheard = yk_problems_new();
    YkMechanism *made = unheard ? compile(v, mech, unheard) : NULL;
    v->failed |= !unheard;
    yk_problems_free(unheard);
    return made;
}

// --- the values to be set

static void add_patch(YkVariant *v, YkVec *at, int32_t node)
{
    if (!v->recipe.nodes[node].varies) return;
    if (!YK_ROOM(v->patches, v->patch_count, v->patch_capacity)) {
        v->failed = true;
        return;
    }
    v->patches[v->patch_count++] = (YkPatch){at, node};
}

static void add_sum(YkVariant *v, YkSum *sum)
{
    if (sum->first < v->recipe.constant_count)
        add_patch(v, &sum->constant, yk_recipe_constant(&v->recipe, sum->first, sum->plus != YK_NONE));
}

static void list_patches(YkVariant *v)
{
    YkMechanism *mech = v->mech;
    for (size_t k = 0; k < mech->term_count && k < v->recipe.term_count; k++)
        add_patch(v, &mech->terms[k].v, v->recipe.of_term[k]);
    for (size_t k = 0; k < mech->loop_count; k++) add_sum(v, &mech->loops[k].sum);
    for (size_t k = 0; k < mech->model->body_count; k++) add_sum(v, &mech->bodies[k].origin);
    for (size_t k = 0; k < mech->node_count; k++) add_sum(v, &mech->node_sums[k]);
    for (size_t k = 0; k < mech->block_count; k++) {
        YkBlock *block = &mech->blocks[k];
        if (block->kind == YK_BLOCK_GROUP) continue;
        add_sum(v, &block->known);
        for (size_t c = 0; c < 2 && c < block->column_count; c++)
            if (!block->column[c].is_distance) add_sum(v, &block->aside->arm[c]);
    }
    for (size_t k = 0; k < mech->group_loop_count; k++) add_sum(v, &mech->group_loops[k]);
    for (size_t k = 0; k < v->recipe.line_count; k++) {
        const YkRecipeLine *line = &v->recipe.lines[k];
        add_patch(v, &mech->blocks[line->block].line[line->line], line->node);
    }
}

static void list_active(YkVariant *v)
{
    v->active = calloc(v->recipe.node_count + 1, sizeof *v->active);
    for (size_t k = 0; v->active && k < v->recipe.node_count; k++)
        if (v->recipe.nodes[k].varies) v->active[v->active_count++] = (int32_t)k;
    v->failed |= !v->active;
}

// --- making

// Returns the place of a relation that has a phase.
static YkPlace place_of(const YkModel *model, const YkRelation *r)
{
    return r->kind == YK_RELATION_GEAR   ? model->gears[r->index].place
           : r->kind == YK_RELATION_BELT ? model->belts[r->index].place
                                         : model->racks[r->index].place;
}

// Checks phases: one that follows a parameter would change the basis of the order of solution. Call it while the copy
// has the probe's values.
static bool check_phases(const YkVariant *v, const YkMechanism *mech, YkProblems *problems)
{
    double *constants = calloc(mech->relation_count + 1, sizeof *constants);
    YkMechanism probed = *mech;
    probed.model = yk_redesign_model(v->redesign);
    bool good = constants && yk_relations_constants(&probed, constants);
    for (size_t k = 0; good && k < mech->relation_count; k++) {
        if (constants[k] == mech->relations[k].constant) continue;
        yk_problem(problems, YK_CODE_CANNOT_VARY, place_of(mech->model, &mech->relations[k]),
                   "a parameter that varies enters the phase of %q, through the values of `start:` and drives",
                   mech->relations[k].name);
        yk_redesign_hint(problems);
        good = false;
    }
    free(constants);
    return good;
}

static bool make(YkVariant *v, const YkMechanism *mech, const char *const *names, size_t count, YkProblems *problems)
{
    v->redesign = yk_redesign_new(mech->model, names, count, problems);
    double *own = v->redesign ? calloc(2 * count + 2, sizeof *own) : NULL;
    if (!own) return false;
    for (size_t k = 0; k < count; k++) own[k] = mech->model->parameters[yk_redesign_parameter(v->redesign, k)].value;
    if (set_beside(v, count, own, own + count)) {
        if (!check_phases(v, mech, problems)) {
            free(own);
            return false;
        }
        v->mech = compile_beside(v, mech);
    }
    v->is_of_file = !v->mech && !v->failed && count > 0;
    if (!v->mech && !v->failed && yk_redesign_set(v->redesign, own) == YK_OK) v->mech = compile(v, mech, problems);
    if (v->mech) {
        v->mech->recipe = NULL;
        v->mech->variant = v;
        list_patches(v);
        list_active(v);
        if (!v->failed) yk_variant_set(v, own);
    }
    free(own);
    return v->mech && !v->failed;
}

YkVariant *yk_variant_new(const YkMechanism *mech, const char *const *names, size_t count, YkProblems *problems)
{
    YkVariant *v = calloc(1, sizeof *v);
    size_t errors = yk_problems_error_count(problems);
    if (v && make(v, mech, names, count, problems)) {
        if (v->is_of_file)
            yk_problem(
                problems, YK_CODE_SPECIAL_VALUES, (YkPlace){0},
                "with slightly different parameters the machine has other constraints or another order of solution: "
                "whatever is 0 or cancels at these values is assumed to stay so");
        return v;
    }
    yk_variant_free(v);
    if (problems && yk_problems_error_count(problems) == errors)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while preparing what varies");
    return NULL;
}

void yk_variant_free(YkVariant *v)
{
    if (!v) return;
    yk_mechanism_free(v->mech);
    yk_recipe_end(&v->recipe);
    yk_redesign_free(v->redesign);
    free(v->active);
    free(v->patches);
    free(v);
}

const YkMechanism *yk_variant_mechanism(const YkVariant *v)
{
    return v->mech;
}

// --- a design

static YkVec value_of(const YkVariant *v, const YkRecipeNode *node)
{
    const YkRecipeNode *nodes = v->recipe.nodes;
    const YkJoint *joints = v->mech->model->joints;
    switch (node->kind) {
    case YK_RECIPE_POINT: {
        const YkJoint *j = &joints[node->a];
        return yk_body_term(v->mech, j->body[node->b], j->at[node->b]).v;
    }
    case YK_RECIPE_ALONG:
        return yk_body_term(v->mech, joints[node->a].body[0], joints[node->a].along).v;
    case YK_RECIPE_NEGATE:
        return yk_scale(-1, nodes[node->a].value);
    case YK_RECIPE_ADD:
        return yk_add(nodes[node->a].value, nodes[node->b].value);
    case YK_RECIPE_FIXED:
        break;
    }
    return node->value;
}

// Weighs a relation: weights follow the machine's size, by powers of two, so that every product of them is exact.
static void weigh_relation(YkMechanism *mech, YkRelation *r)
{
    if (r->weight == 0) return;
    double weight = yk_relation_weight(mech, r), by = weight / r->weight;
    r->weight = weight;
    r->gain *= by;
    r->offset *= by;
    for (uint32_t k = 0; k < r->source_count; k++) mech->sources[r->first_source + k].factor *= by;
}

static void set_size(YkMechanism *mech, double size)
{
    if (size == mech->size) return;
    mech->size = size;
    for (size_t k = 0; k < mech->relation_count + mech->derived_count; k++) weigh_relation(mech, &mech->relations[k]);
}

YkStatus yk_variant_set(YkVariant *v, const double *values)
{
    v->changes++;
    YkStatus status = yk_redesign_set(v->redesign, values);
    if (status < 0) return status;
    set_size(v->mech, v->mech->model->size);
    for (size_t k = 0; k < v->active_count; k++) {
        YkRecipeNode *node = &v->recipe.nodes[v->active[k]];
        node->value = value_of(v, node);
    }
    for (size_t k = 0; k < v->patch_count; k++) *v->patches[k].at = v->recipe.nodes[v->patches[k].node].value;
    for (size_t k = 0; k < v->mech->block_count; k++)
        yk_block_measure(&v->mech->blocks[k], yk_block_size(v->mech, &v->mech->blocks[k]));
    v->mech->distance_unit = yk_distance_unit(v->mech);
    return status;
}
