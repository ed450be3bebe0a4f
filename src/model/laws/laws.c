// Reads `laws:`, motion programs and tables by name. build.c builds them once all values are known.
#include <string.h>
#include "model/laws/laws.h"
#include "model/laws/read.h"
#include "model/load.h"

static const char *const keys[] = {"from", "period", "segments", "table", "between", NULL};

static void read_point(YkLawReader *reader, const YkNode *node, YkLawNumber point[2])
{
    if (!yk_load_law_expect(reader, node, YK_NODE_LIST, "point")) return;
    if (node->count != 2) {
        yk_problem(reader->loader->problems, YK_CODE_COMPONENTS, node->place,
                   "a point of table %q is [argument, value]; here are %z", reader->law->name, node->count);
        reader->source->is_bad = true;
        return;
    }
    yk_load_law_number(reader, node->items[0], "argument", reader->law->of, &point[0]);
    yk_load_law_number(reader, node->items[1], "value", reader->law->value, &point[1]);
}

static void read_table(YkLawReader *reader, const YkNode *table)
{
    YkLawSource *source = reader->source;
    if (!yk_load_law_expect(reader, table, YK_NODE_LIST, "table")) return;
    if (!yk_load_count_fits(reader->loader, table, table->count, "points")) return;
    source->points = yk_arena_alloc(reader->loader->arena, table->count + 1, sizeof *source->points);
    if (!source->points) return;
    source->point_count = table->count;
    for (size_t i = 0; i < table->count; i++) read_point(reader, table->items[i], source->points[i]);
}

static void read_between(YkLawReader *reader, const YkNode *node)
{
    static const char *const words[] = {"linear", "cubic", "monotone", NULL};
    static const YkTableShape shapes[] = {YK_TABLE_LINEAR, YK_TABLE_CUBIC, YK_TABLE_MONOTONE};
    reader->source->between = YK_TABLE_MONOTONE;
    if (!node || !yk_load_law_expect(reader, node, YK_NODE_SCALAR, "between")) return;
    for (size_t i = 0; words[i]; i++) {
        if (strcmp(node->text, words[i]) != 0) continue;
        reader->source->between = shapes[i];
        return;
    }
    yk_problem(reader->loader->problems, YK_CODE_WRONG_WORD, node->place,
               "between its points a table is `linear`, `monotone` or `cubic`, not %q", node->text);
    yk_load_hint_nearest_key(reader->loader, node->text, words);
    reader->source->is_bad = true;
}

static void read_kind(YkLawReader *reader, const YkNode *map)
{
    const YkNode *segments = yk_node_get(map, "segments"), *table = yk_node_get(map, "table");
    const YkNode *between = yk_load_key(map, "between");
    if (!segments == !table) {
        yk_problem(reader->loader->problems, YK_CODE_LAW_KIND, reader->law->place,
                   segments ? "law %q has both `segments` and a `table`" : "law %q needs `segments` or a `table`",
                   reader->law->name);
        reader->source->is_bad = true;
    } else if (segments && between) {
        yk_problem(reader->loader->problems, YK_CODE_LAW_KIND, between->place,
                   "`between` is for the points of a table; law %q has segments", reader->law->name);
    }
    if (segments) yk_load_law_segments(reader, segments);
    if (table) read_table(reader, table);
    read_between(reader, table ? yk_node_get(map, "between") : NULL);
}

static void read_law(YkLoader *loader, const YkNodePair *pair, YkModelLaw *law)
{
    YkLawReader reader = {.loader = loader, .law = law, .source = law->source};
    const YkSubject subject = {.noun = "law", .part = law->name};
    if (!yk_load_expect(loader, pair->value, YK_NODE_MAP, &subject)) {
        law->source->is_bad = true;
        return;
    }
    yk_load_check_keys(loader, pair->value, keys, &subject);
    yk_load_law_optional(&reader, pair->value, "from", law->of, &law->source->from);
    yk_load_law_optional(&reader, pair->value, "period", law->of, &law->source->period);
    read_kind(&reader, pair->value);
}

void yk_load_laws(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "laws"), *cams = yk_node_get(loader->root, "cams");
    YkModel *model = loader->model;
    size_t made = cams && cams->kind == YK_NODE_MAP ? cams->count : 0; // room for yk_load_make_law
    size_t given = section ? section->count : 0;
    if (given + made == 0) return;
    model->laws = YK_NEW(loader->arena, YkModelLaw, given + made);
    if (!model->laws || given == 0) return;
    for (size_t i = 0; i < section->count; i++) {
        const YkNodePair *pair = &section->pairs[i];
        YkModelLaw *law = &model->laws[i];
        *law = (YkModelLaw){.name = pair->key->text, .place = pair->key->place};
        law->source = YK_NEW(loader->arena, YkLawSource, 1);
        if (!law->source) return;
        yk_load_name(loader, pair->key, "law");
    }
    model->law_count = section->count;
    yk_load_law_dimensions(loader, section);
    for (size_t i = 0; i < section->count; i++) read_law(loader, &section->pairs[i], &model->laws[i]);
}

int32_t yk_load_law(YkLoader *loader, const YkNode *node)
{
    const YkModel *model = loader->model;
    if (!yk_load_expect(loader, node, YK_NODE_SCALAR, &(YkSubject){.noun = "law"})) return YK_NONE;
    for (size_t i = 0; i < model->law_count; i++) {
        if (!model->laws[i].source->is_made && strcmp(model->laws[i].name, node->text) == 0) return (int32_t)i;
    }
    yk_problem(loader->problems, YK_CODE_UNKNOWN_LAW, node->place, "there is no law %q", node->text);
    yk_load_hint_nearest(loader->problems, node->text, model->laws, model->law_count, sizeof *model->laws);
    return YK_NONE;
}

int32_t yk_load_make_law(YkLoader *loader, const char *name, YkPlace place)
{
    YkModel *model = loader->model;
    YkLawSource *source = YK_NEW(loader->arena, YkLawSource, 1);
    if (!model->laws || !source) return YK_NONE;
    source->is_made = true;
    model->laws[model->law_count] = (YkModelLaw){.name = name, .place = place, .of = YK_DIM_ANGLE, .source = source};
    return (int32_t)model->law_count++;
}
