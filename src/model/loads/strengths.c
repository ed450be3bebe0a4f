// Reads values that follow the time and the pose: an expression, or {law: NAME, of: expression}.
#include "model/load.h"

// Checks that the law gives what is wanted.
static void check_law(YkLoader *loader, const YkModelLaw *law, const YkWant *want, YkPlace place)
{
    if (yk_dimension_equal(law->value, want->dimension)) return;
    yk_problem(loader->problems, YK_CODE_WRONG_DIMENSION, place, "law %q gives %s; the %s must be %s", law->name,
               yk_dimension_name(law->value), yk_load_subject(loader, &want->subject),
               yk_dimension_name(want->dimension));
}

static YkStrength read_law(YkLoader *loader, const YkNode *node, const YkWant *want)
{
    static const char *const keys[] = {"law", "of", NULL};
    YkStrength strength = {.law = YK_NONE};
    yk_load_check_keys(loader, node, keys, &want->subject);
    const YkNode *name = yk_load_require(loader, node, "law", &want->subject);
    const YkNode *of = yk_load_require(loader, node, "of", &want->subject);
    int32_t law = name ? yk_load_law(loader, name) : YK_NONE;
    if (law == YK_NONE) return strength;
    check_law(loader, &loader->model->laws[law], want, name->place);
    YkWant argument = *want;
    argument.dimension = loader->model->laws[law].of;
    argument.subject.noun = "argument of the law";
    argument.subject.axis = NULL;
    if (of) strength.expr = yk_load_value(loader, of, &argument, NULL);
    if (strength.expr) strength.law = law;
    return strength;
}

YkStrength yk_load_strength(YkLoader *loader, const YkNode *node, const YkWant *want)
{
    if (node->kind == YK_NODE_MAP) return read_law(loader, node, want);
    return (YkStrength){.expr = yk_load_value(loader, node, want, NULL), .law = YK_NONE};
}
