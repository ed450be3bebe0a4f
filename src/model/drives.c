// Reads `drives:`, coordinates whose motion is an expression of time, and `start:`, values at the start. Both sections
// have the form COORDINATE: expression.
#include "model/load.h"

static YkDimension dimension_of(const YkModel *model, int32_t coordinate)
{
    return model->coordinates[coordinate].is_distance ? YK_DIM_LENGTH : YK_DIM_ANGLE;
}

static void add_drive(YkLoader *loader, int32_t coordinate, YkPlace place, YkExpr *expr, int32_t law)
{
    YkModel *model = loader->model;
    model->coordinates[coordinate].drive = (int32_t)model->drive_count;
    model->drives[model->drive_count++] = (YkDrive){.coordinate = coordinate, .place = place, .expr = expr, .law = law};
}

// Reads {law: NAME, of: a coordinate or an expression of t}.
static void read_law(YkLoader *loader, int32_t coordinate, const YkNodePair *pair)
{
    static const char *const keys[] = {"law", "of", NULL};
    const YkSubject subject = {.noun = "drive", .owner = pair->key->text};
    YkModel *model = loader->model;
    yk_load_check_keys(loader, pair->value, keys, &subject);
    const YkNode *name = yk_load_require(loader, pair->value, "law", &subject);
    const YkNode *of = yk_load_require(loader, pair->value, "of", &subject);
    int32_t law = name ? yk_load_law(loader, name) : YK_NONE;
    if (law == YK_NONE || !of) return;
    if (!yk_dimension_equal(model->laws[law].value, dimension_of(model, coordinate)))
        yk_problem(loader->problems, YK_CODE_WRONG_DIMENSION, name->place,
                   "law %q gives %s; the drive of %q must be %s", model->laws[law].name,
                   yk_dimension_name(model->laws[law].value), pair->key->text,
                   yk_dimension_name(dimension_of(model, coordinate)));
    bool is_rate = false;
    int32_t followed = of->kind == YK_NODE_SCALAR ? yk_load_coordinate(loader, of->text, of->place, &is_rate) : YK_NONE;
    if (followed >= 0 && !is_rate && followed != coordinate) {
        if (!yk_dimension_equal(model->laws[law].of, dimension_of(model, followed)))
            yk_problem(loader->problems, YK_CODE_WRONG_DIMENSION, of->place, "law %q is over %s; %q is %s",
                       model->laws[law].name, yk_dimension_name(model->laws[law].of), of->text,
                       yk_dimension_name(dimension_of(model, followed)));
        model->follows[model->follow_count++] = (YkFollow){coordinate, followed, pair->key->place, law};
        return;
    }
    YkWant want = {.dimension = model->laws[law].of,
                   .scope = YK_SCOPE_TIME,
                   .subject = {.noun = "argument of the law", .owner = pair->key->text}};
    add_drive(loader, coordinate, pair->key->place, yk_load_value(loader, of, &want, NULL), law);
}

void yk_load_drives(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "drives");
    YkModel *model = loader->model;
    if (!section) return;
    unsigned char *seen = yk_load_new_seen(loader, section);
    model->drives = YK_NEW(loader->arena, YkDrive, section->count);
    model->follows = YK_NEW(loader->arena, YkFollow, section->count);
    if (!seen || !model->drives || !model->follows) return;
    for (size_t i = 0; i < section->count; i++) {
        const YkNodePair *pair = &section->pairs[i];
        int32_t coordinate = yk_load_coordinate_once(loader, pair->key, seen, NULL);
        if (coordinate < 0) continue;
        if (pair->value->kind == YK_NODE_MAP) {
            read_law(loader, coordinate, pair);
            continue;
        }
        YkWant want = {.dimension = dimension_of(model, coordinate),
                       .scope = YK_SCOPE_TIME,
                       .subject = {.noun = "drive", .owner = pair->key->text}};
        add_drive(loader, coordinate, pair->key->place, yk_load_value(loader, pair->value, &want, NULL), YK_NONE);
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
    for (size_t i = 0; i < section->count && yk_load_goes_on(loader); i++) {
        const YkNodePair *pair = &section->pairs[i];
        bool is_rate = false;
        int32_t coordinate = yk_load_coordinate_once(loader, pair->key, seen, &is_rate);
        if (coordinate < 0) continue;
        YkWant want = {.dimension = start_dimension(model->coordinates[coordinate].is_distance, is_rate),
                       .scope = YK_SCOPE_CONSTANT,
                       .subject = {.noun = "start", .owner = pair->key->text}};
        YkStart *start = &model->starts[model->start_count++];
        *start = (YkStart){.coordinate = coordinate, .is_rate = is_rate, .place = pair->key->place};
        start->expr = yk_load_value(loader, pair->value, &want, &start->value);
    }
}
