// Reads `efforts:`, torques and forces along coordinates: COORDINATE: expression, or {law: NAME, of: expression}.
#include "model/load.h"

static void read_effort(YkLoader *loader, YkEffort *effort, const YkNodePair *pair)
{
    bool is_distance = loader->model->coordinates[effort->coordinate].is_distance;
    YkWant want = {.dimension = is_distance ? YK_DIM_FORCE : YK_DIM_TORQUE,
                   .scope = YK_SCOPE_STATE,
                   .subject = {.noun = "effort", .owner = pair->key->text}};
    effort->strength = yk_load_strength(loader, pair->value, &want);
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
        *effort = (YkEffort){.coordinate = coordinate, .place = pair->key->place};
        read_effort(loader, effort, pair);
    }
}
