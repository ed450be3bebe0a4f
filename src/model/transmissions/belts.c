// Reads `belts:`, belts and chains between two pulleys, open or crossed.
#include "model/load.h"

static void read_belt(YkLoader *loader, YkBelt *belt, const YkNode *node)
{
    static const char *const keys[] = {"between", "radii", "crossed", "carrier", NULL};
    const YkSubject subject = {.noun = "belt", .part = belt->name};
    const YkWant want = {.dimension = YK_DIM_LENGTH, .subject = {.noun = "radius", .owner = belt->name}};
    if (!yk_load_expect(loader, node, YK_NODE_MAP, &subject)) return;
    yk_load_check_keys(loader, node, keys, &subject);
    yk_load_two_bodies(loader, yk_load_two_values(loader, node, "between", &subject), &subject, belt->body);
    const YkNode *radii = yk_load_two_values(loader, node, "radii", &subject);
    for (int k = 0; radii && k < 2; k++)
        belt->radius_expr[k] = yk_load_value(loader, radii->items[k], &want, &belt->radius[k]);
    belt->is_crossed = yk_load_yes_or_no(loader, node, "crossed", &subject);
    belt->carrier = yk_load_carrier(loader, node);
}

void yk_load_belts(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "belts");
    YkModel *model = loader->model;
    if (!section) return;
    model->belts = YK_NEW(loader->arena, YkBelt, section->count);
    if (!model->belts) return;
    for (size_t i = 0; i < section->count; i++) {
        const YkNodePair *pair = &section->pairs[i];
        YkBelt *belt = &model->belts[model->belt_count++];
        *belt = (YkBelt){
            .name = pair->key->text, .place = pair->key->place, .body = {YK_NONE, YK_NONE}, .carrier = YK_NONE};
        yk_load_name(loader, pair->key, "belt");
        read_belt(loader, belt, pair->value);
    }
}

// Warns if no belt could lie around the two pulleys.
static void check_room(YkLoader *loader, const YkBelt *belt, double distance)
{
    double sum = belt->radius[0] + belt->radius[1], size = 1;
    bool is_known = belt->carrier >= 0 && belt->radius[0] > 0 && belt->radius[1] > 0;
    if (!is_known || sum <= distance * (1 + 1e-9)) return;
    const char *unit = yk_model_unit(loader->model, YK_QUANTITY_LENGTH, &size);
    yk_problem(loader->problems, YK_CODE_PULLEYS_OVERLAP, belt->place,
               "belt %q: its pulleys overlap, since their centres are %e %s apart and their radii are %e and %e %s",
               belt->name, distance / size, unit, belt->radius[0] / size, belt->radius[1] / size, unit);
}

void yk_load_finish_belts(YkLoader *loader)
{
    YkModel *model = loader->model;
    for (size_t i = 0; i < model->belt_count; i++) {
        YkBelt *belt = &model->belts[i];
        double distance = 0;
        const YkWheelPair pair = {"belt", belt->name, belt->place, {belt->body[0], belt->body[1]}, belt->carrier};
        belt->carrier = yk_load_find_carrier(loader, &pair, &distance, NULL);
        for (int k = 0; k < 2; k++) {
            if (!belt->radius_expr[k]) continue;
            belt->exact_radius[k] = yk_model_exact(model, belt->radius_expr[k]);
            if (!(belt->radius[k] <= 0)) continue;
            yk_load_refuse_amount(loader, YK_CODE_BAD_RADIUS, belt->radius_expr[k], belt->radius[k], YK_DIM_LENGTH,
                                  "the %s of %q is %e %s; it must be positive", "radius", belt->name);
        }
        check_room(loader, belt, distance);
    }
}
