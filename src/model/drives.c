// `drives:` coordinates whose motion is given as an expression of time; `start:` values at the start. Two sections of
// one form: COORDINATE: expression.
#include <math.h>
#include "model/load.h"

// The coordinate a pair of the section speaks of, or a negative number (reported).
static int32_t read_key(YkLoader *loader, const YkPair *pair, unsigned char *seen, bool *is_rate)
{
    if (pair->value->kind == YK_NODE_MAP && yk_node_get(pair->value, "law")) {
        yk_problem(loader->problems, YK_CODE_NOT_SUPPORTED, pair->value->place,
                   "laws are not part of this version yet");
        yk_problem_hint(loader->problems, "give %q as an expression of `t`", pair->key->text);
        return YK_REPORTED;
    }
    return yk_load_coordinate_once(loader, pair->key, seen, is_rate);
}

void yk_load_drives(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "drives");
    YkModel *model = loader->model;
    if (!section) return;
    unsigned char *seen = yk_load_new_seen(loader, section);
    model->drives = YK_NEW(loader->arena, YkDrive, section->count);
    if (!seen || !model->drives) return;
    for (size_t i = 0; i < section->count; i++) {
        const YkPair *pair = &section->pairs[i];
        int32_t coordinate = read_key(loader, pair, seen, NULL);
        if (coordinate < 0) continue;
        bool is_distance = model->coordinates[coordinate].is_distance;
        YkWant want = {.dimension = is_distance ? YK_DIM_LENGTH : YK_DIM_ANGLE,
                       .scope = YK_SCOPE_TIME,
                       .subject = {.noun = "drive", .owner = pair->key->text}};
        YkExpr *expr = yk_load_value(loader, pair->value, &want, NULL);
        model->coordinates[coordinate].drive = (int32_t)model->drive_count;
        model->drives[model->drive_count++] =
            (YkDrive){.coordinate = coordinate, .place = pair->key->place, .expr = expr};
    }
}

static YkDimension start_dimension(bool is_distance, bool is_rate)
{
    if (is_rate) return is_distance ? YK_DIM_SPEED : YK_DIM_ANGLE_RATE;
    return is_distance ? YK_DIM_LENGTH : YK_DIM_ANGLE;
}

void yk_load_starts(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "start");
    YkModel *model = loader->model;
    if (!section) return;
    unsigned char *seen = yk_load_new_seen(loader, section);
    model->starts = YK_NEW(loader->arena, YkStart, section->count);
    if (!seen || !model->starts) return;
    for (size_t i = 0; i < section->count; i++) {
        const YkPair *pair = &section->pairs[i];
        bool is_rate = false;
        int32_t coordinate = read_key(loader, pair, seen, &is_rate);
        if (coordinate < 0) continue;
        YkWant want = {.dimension = start_dimension(model->coordinates[coordinate].is_distance, is_rate),
                       .scope = YK_SCOPE_CONSTANT,
                       .subject = {.noun = "start", .owner = pair->key->text}};
        YkStart *start = &model->starts[model->start_count++];
        *start = (YkStart){.coordinate = coordinate, .is_rate = is_rate, .place = pair->key->place};
        start->expr = yk_load_value(loader, pair->value, &want, &start->value);
    }
}
