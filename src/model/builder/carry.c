// Makes the machine in which a point is carried by two slides.
#include <string.h>
#include "model/builder/builder.h"
#include "model/model.h"

// Sets one key of a map below `path`, a text of the builder's own making.
static void set(YkBuilder *builder, YkText *path, const char *map, const char *prefix, const char *end,
                const char *value)
{
    yk_text_clear(path);
    yk_text_format(path, "%s/%s%s", map, prefix, end);
    yk_builder_set(builder, yk_text_get(path), value);
    if (path->failed) builder->failed = true;
}

static void set_number(YkBuilder *builder, YkText *path, const char *prefix, const char *end, double value)
{
    yk_text_clear(path);
    yk_text_format(path, "start/%s%s", prefix, end);
    yk_builder_set_number(builder, yk_text_get(path), value);
    if (path->failed) builder->failed = true;
}

static void add_carriage(YkBuilder *builder, const char *body, const char *point, const char *prefix, const double *at)
{
    YkText path = {0}, value = {0};
    static const char *const of[] = {"x", "y"};
    for (int k = 0; k < 2; k++) {
        set(builder, &path, "bodies", prefix, of[k], "{}");
        yk_text_clear(&value);
        yk_text_format(&value, "{slide: [%s%s, %s%s], along: %s, distance: %s%s}", k == 0 ? "ground" : prefix,
                       k == 0 ? "" : of[0], prefix, of[k], of[k], prefix, of[k]);
        set(builder, &path, "joints", prefix, of[k], yk_text_get(&value));
        set_number(builder, &path, prefix, of[k], at[k]);
    }
    yk_text_clear(&value);
    yk_text_format(&value, "{points: {%s: [0, 0]}}", point);
    set(builder, &path, "bodies", prefix, "y", yk_text_get(&value));
    yk_text_clear(&value);
    yk_text_format(&value, "{pin: [%sy, %s], at: %s}", prefix, body, point);
    set(builder, &path, "joints", prefix, "pin", yk_text_get(&value));
    if (value.failed) builder->failed = true;
    yk_text_free(&path);
    yk_text_free(&value);
}

YkModel *yk_model_carry_point(const YkModel *model, size_t point, const char *prefix, const double at[2],
                              const YkLoadOptions *options, YkProblems *problems)
{
    if (!model || point >= yk_model_point_count(model) || !prefix || !at) return NULL;
    YkBuilder *builder = yk_builder_new(NULL);
    YkArena *arena = yk_arena_new();
    const char *text = yk_model_text(model), *full = yk_model_point_name(model, point);
    const char *dot = strrchr(full, '.');
    double unit = 1;
    YkModel *carried = NULL;
    const YkNode *root = builder && arena && text ? yk_doc_parse(text, strlen(text), "machine", arena, problems) : NULL;
    yk_model_unit(model, YK_QUANTITY_LENGTH, &unit);
    if (root) {
        const double in_units[2] = {at[0] / unit, at[1] / unit};
        builder->root = yk_branch_copy(builder, root);
        if (builder->root)
            add_carriage(builder, yk_model_body_name(model, yk_model_point_body(model, point)), dot ? dot + 1 : full,
                         prefix, in_units);
        else
            builder->failed = true;
        if (builder->root) carried = yk_builder_model(builder, options, problems);
    }
    if (!carried && yk_problems_error_count(problems) == 0)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory");
    yk_arena_free(arena);
    yk_builder_free(builder);
    return carried;
}
