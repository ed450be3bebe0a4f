// Angles and distances that are sums of inputs, which stay exact over any number of turns.
#include "base/memory.h"
#include "compile/plan.h"

YkInputSum *yk_plan_sums(YkPlan *plan)
{
    if (!plan->forms) {
        size_t slots = plan->mech->slot_count + plan->mech->orientation_count + 1;
        plan->forms = YK_NEW(plan->arena, YkInputSum, slots + plan->mech->distance_count);
        plan->distance_forms = yk_from(plan->forms, slots);
        if (plan->forms) plan->forms[0].is_known = true; // the ground
    }
    if (!plan->forms) plan->failed = true;
    return plan->forms;
}

YkInputSum *yk_plan_sum_of(const YkPlan *plan, YkRelationTerm term)
{
    return (term.is_distance ? plan->distance_forms : plan->forms) + term.index;
}

double yk_plan_add(double x, double y)
{
    return fabs(x + y) < 1e-12 * (fabs(x) + fabs(y)) ? 0 : x + y;
}

void yk_plan_add_sum(YkPlan *plan, YkInputSum *target, const YkInputSum *form, double factor)
{
    YkRelationSource *sources = YK_NEW(plan->arena, YkRelationSource, target->count + form->count + 1);
    if (!sources) {
        plan->failed = true;
        return;
    }
    size_t count = 0;
    for (size_t k = 0; k < target->count; k++) sources[count++] = target->sources[k];
    for (size_t k = 0; k < form->count; k++) {
        size_t at = 0;
        while (at < count && sources[at].index != form->sources[k].index) at++;
        if (at == count) sources[count++] = (YkRelationSource){YK_SOURCE_INPUT, form->sources[k].index, YK_NONE, 0};
        sources[at].factor = yk_plan_add(sources[at].factor, factor * form->sources[k].factor);
    }
    target->sources = sources;
    target->count = count;
    target->constant += factor * form->constant;
}

// Adds two forms: the parent's, which is the ground's for a distance, and an input or what turns with the parent.
static void note_step(YkPlan *plan, const YkStep *step)
{
    bool is_composed = step->kind == YK_STEP_COMPOSE;
    YkInputSum input = {true, step->offset, &(YkRelationSource){YK_SOURCE_INPUT, step->input, YK_NONE, 1}, 1};
    const YkInputSum *parent = &plan->forms[step->parent], *other = is_composed ? &plan->forms[step->other] : &input;
    if (!parent->is_known || !other->is_known) return;
    YkInputSum *form = yk_plan_sum_of(plan, (YkRelationTerm){step->kind == YK_STEP_DISTANCE, step->target, 0});
    yk_plan_add_sum(plan, form, parent, 1);
    yk_plan_add_sum(plan, form, other, is_composed ? 1 : step->sign);
    form->is_known = true;
}

void yk_plan_note_step(YkPlan *plan, const YkStep *step)
{
    if (plan->mech->relation_count > 0 && yk_plan_sums(plan)) note_step(plan, step);
}
