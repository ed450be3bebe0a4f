// Reads `efforts:`, torques and forces along coordinates: COORDINATE: expression, or {law: NAME, of: expression}.
#include "model/load.h"

static YkDimension effort_dimension(const YkLoader *loader, int32_t coordinate)
{
    return loader->model->coordinates[coordinate].is_distance ? YK_DIM_FORCE : YK_DIM_TORQUE;
}

// Checks that the law gives an effort along the coordinate.
static void check_law(YkLoader *loader, const YkEffort *effort, const YkNode *node)
{
    const YkModelLaw *law = &loader->model->laws[effort->law.law];
    const YkCoordinate *coordinate = &loader->model->coordinates[effort->coordinate];
    YkDimension wanted = effort_dimension(loader, effort->coordinate);
    if (yk_dimension_equal(law->value, wanted)) return;
    yk_problem(loader->problems, YK_CODE_WRONG_DIMENSION, node->place,
               "law %q gives %s; the effort along %q must be %s", law->name, yk_dimension_name(law->value),
               coordinate->name, yk_dimension_name(wanted));
}

static void read_law(YkLoader *loader, YkEffort *effort, const YkNodePair *pair)
{
    static const char *const keys[] = {"law", "of", NULL};
    const YkSubject subject = {.noun = "effort", .owner = pair->key->text};
    yk_load_check_keys(loader, pair->value, keys, &subject);
    const YkNode *name = yk_load_require(loader, pair->value, "law", &subject);
    const YkNode *of = yk_load_require(loader, pair->value, "of", &subject);
    effort->law.law = name ? yk_load_law(loader, name) : YK_NONE;
    if (effort->law.law == YK_NONE) return;
    check_law(loader, effort, name);
    YkWant want = {.dimension = loader->model->laws[effort->law.law].of,
                   .scope = YK_SCOPE_STATE,
                   .subject = {.noun = "argument of the law", .owner = pair->key->text}};
    if (of) effort->law.of = yk_load_value(loader, of, &want, NULL);
}

static void read_effort(YkLoader *loader, YkEffort *effort, const YkNodePair *pair)
{
    YkWant want = {.dimension = effort_dimension(loader, effort->coordinate),
                   .scope = YK_SCOPE_STATE,
                   .subject = {.noun = "effort", .owner = pair->key->text}};
    if (pair->value->kind == YK_NODE_MAP) {
        read_law(loader, effort, pair);
    } else {
        effort->expr = yk_load_value(loader, pair->value, &want, NULL);
    }
}

void yk_load_efforts(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "efforts");
    YkModel *model = loader->model;
    if (!section) return;
    unsigned char *seen = yk_load_new_seen(loader, section);
    model->efforts = YK_NEW(loader->arena, YkEffort, section->count);
    if (!seen || !model->efforts) return;
    for (size_t i = 0; i < section->count; i++) {
        const YkNodePair *pair = &section->pairs[i];
        int32_t coordinate = yk_load_coordinate_once(loader, pair->key, seen, NULL);
        if (coordinate < 0) continue;
        YkEffort *effort = &model->efforts[model->effort_count++];
        *effort = (YkEffort){.coordinate = coordinate, .place = pair->key->place, .law = {.law = YK_NONE}};
        read_effort(loader, effort, pair);
    }
}
