// Compiles a model into a mechanism.
#include <stdlib.h>
#include <string.h>
#include "base/problems.h"
#include "compile/inputs.h"
#include "compile/plan.h"
#include "compile/relations.h"
#include "compile/variant.h"

YkCompileOptions yk_default_compile_options(void)
{
    return (YkCompileOptions){0};
}

void yk_mechanism_free(YkMechanism *mech)
{
    if (!mech) return;
    free(mech->steps);
    free(mech->node_sums);
    free(mech->blocks);
    free(mech->block_members);
    free(mech->group_columns);
    free(mech->group_loops);
    free(mech->group_relations);
    free(mech->terms);
    free(mech->redundant);
    free(mech->relation_terms);
    free(mech->sources);
    yk_arena_free(mech->arena);
    free(mech);
}

static bool build(YkMechanism *mech, const YkCompileOptions *options, YkPace *pace, YkProblems *problems)
{
    YkIncidence incidence = {0};
    mech->arena = yk_arena_new();
    if (mech->arena) mech->arena->pace = pace;
    if (!YK_ROOM(mech->terms, 0, mech->term_capacity)) return false; // never NULL: sums may be empty
    if (mech->arena && options->open_cams && mech->model->cam_count > 0) {
        bool *open = YK_NEW(mech->arena, bool, mech->model->cam_count);
        if (open) memcpy(open, options->open_cams, mech->model->cam_count * sizeof *open);
        mech->open_cams = open;
    }
    if (!mech->arena || !yk_incidence_build(&incidence, mech->arena, mech->model)) return false;
    if (!yk_pace_ask(pace) || !yk_topology_orientations(mech, &incidence, problems)) return false;
    if (!yk_pace_ask(pace) || !yk_topology_tree(mech, &incidence, problems)) return false;
    if (!yk_pace_ask(pace) || !yk_relations_build(mech)) return false;
    mech->group_root = YK_NEW(mech->arena, int32_t, mech->orientation_count);
    mech->relative_slot = YK_NEW(mech->arena, int32_t, mech->orientation_count);
    mech->inputs = YK_NEW(mech->arena, int32_t, mech->coordinate_count + 1);
    if (yk_arena_failed(mech->arena) || !yk_pace_ask(pace)) return false;
    return yk_inputs_choose(mech, &incidence, options, problems);
}

YkMechanism *yk_mechanism_compile(const YkModel *model, const YkCompileOptions *options, YkProblems *problems)
{
    return yk_compile_with(model, options, NULL, problems);
}

YkMechanism *yk_compile_with(const YkModel *model, const YkCompileOptions *options, YkRecipe *recipe,
                             YkProblems *problems)
{
    YkCompileOptions defaults = yk_default_compile_options();
    YkMechanism *mech = calloc(1, sizeof *mech);
    size_t errors = yk_problems_error_count(problems);
    YkPace pace;
    yk_pace_begin(&pace, options ? options->progress : defaults.progress);
    if (mech) {
        mech->model = model;
        mech->size = mech->distance_unit = model->size;
        mech->recipe = recipe;
        bool is_built = build(mech, options ? options : &defaults, &pace, problems);
        if (mech->arena) mech->arena->pace = NULL;
        if (is_built) mech->distance_unit = yk_distance_unit(mech);
        if (is_built && !pace.is_stopped) return mech;
    }
    if (pace.is_stopped)
        yk_problem_stopped(problems);
    else if (problems && yk_problems_error_count(problems) == errors)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while compiling the machine");
    yk_mechanism_free(mech);
    return NULL;
}
