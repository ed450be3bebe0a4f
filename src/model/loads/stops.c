// Reads `stops:`, the range that a coordinate cannot leave: COORDINATE: [lowest, highest], or with the restitution of
// the impact COORDINATE: {between: [lowest, highest], restitution: 0.3}.
#include "model/load.h"

static void read_ends(YkLoader *loader, YkStop *stop, const YkNode *ends, const YkWant *want)
{
    if (!yk_load_expect(loader, ends, YK_NODE_LIST, &want->subject)) return;
    if (ends->count != 2) {
        yk_problem(loader->problems, YK_CODE_COMPONENTS, ends->place, "%s has two ends, [lowest, highest]; here are %z",
                   yk_load_subject(loader, &want->subject), ends->count);
        return;
    }
    stop->low_expr = yk_load_value(loader, ends->items[0], want, &stop->low);
    stop->high_expr = yk_load_value(loader, ends->items[1], want, &stop->high);
}

static void read_stop(YkLoader *loader, YkStop *stop, const YkNodePair *pair)
{
    static const char *const keys[] = {"between", "restitution", NULL};
    bool is_distance = loader->model->coordinates[stop->coordinate].is_distance;
    YkWant want = {.dimension = is_distance ? YK_DIM_LENGTH : YK_DIM_ANGLE,
                   .subject = {.noun = "stop", .owner = pair->key->text}};
    if (pair->value->kind != YK_NODE_MAP) {
        read_ends(loader, stop, pair->value, &want);
        return;
    }
    yk_load_check_keys(loader, pair->value, keys, &want.subject);
    const YkNode *between = yk_load_require(loader, pair->value, "between", &want.subject);
    if (between) read_ends(loader, stop, between, &want);
    want.dimension = YK_DIM_NUMBER;
    want.subject.noun = "restitution";
    stop->restitution_expr = yk_load_key_value(loader, pair->value, "restitution", &want, &stop->restitution);
}

void yk_load_stops(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "stops");
    YkModel *model = loader->model;
    if (!section) return;
    unsigned char *seen = yk_load_new_seen(loader, section);
    model->stops = YK_NEW(loader->arena, YkStop, section->count);
    if (!seen || !model->stops) return;
    for (size_t i = 0; i < section->count; i++) {
        const YkNodePair *pair = &section->pairs[i];
        int32_t coordinate = yk_load_coordinate_once(loader, pair->key, seen, NULL);
        if (coordinate < 0) continue;
        YkStop *stop = &model->stops[model->stop_count++];
        *stop = (YkStop){.coordinate = coordinate, .place = pair->key->place};
        read_stop(loader, stop, pair);
    }
}

static void check_stop(YkLoader *loader, const YkStop *stop)
{
    const YkCoordinate *coordinate = &loader->model->coordinates[stop->coordinate];
    const char *name = coordinate->name;
    if (stop->low_expr && stop->high_expr && stop->low >= stop->high) {
        YkQuantity quantity = coordinate->is_distance ? YK_QUANTITY_LENGTH : YK_QUANTITY_ANGLE;
        double size = 1;
        const char *unit = yk_model_unit(loader->model, quantity, &size);
        yk_problem(loader->problems, YK_CODE_BAD_STOP, stop->low_expr->place,
                   "the stop of %q reaches from %e to %e %s; the lowest value comes first", name, stop->low / size,
                   stop->high / size, unit);
    }
    if (stop->restitution_expr && (stop->restitution < 0 || stop->restitution > 1)) {
        yk_problem(loader->problems, YK_CODE_BAD_RESTITUTION, stop->restitution_expr->place,
                   "the restitution at the stop of %q is %g; it lies between 0 and 1", name, stop->restitution);
    }
}

void yk_load_finish_stops(YkLoader *loader)
{
    const YkModel *model = loader->model;
    for (size_t i = 0; i < model->stop_count; i++) check_stop(loader, &model->stops[i]);
}
