// From a text to a sketch.
#include <stdlib.h>
#include "base/problems.h"
#include "doc/node.h"
#include "model/builder/builder.h"
#include "sketch/sketch.h"

static bool compile(YkSketch *sketch, YkProblems *problems)
{
    sketch->mech = yk_mechanism_compile(sketch->model, NULL, problems);
    return sketch->mech != NULL;
}

static YkSketch *read(const char *text, size_t length, const char *name, const YkReading *how, YkProblems *problems)
{
    YkSketch *sketch = calloc(1, sizeof *sketch);
    if (!sketch) {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory");
        return NULL;
    }
    sketch->arena = yk_arena_new();
    sketch->model = yk_model_read(text, length, name, how, problems);
    if (!sketch->model || !compile(sketch, problems)) {
        yk_sketch_free(sketch);
        return NULL;
    }
    yk_sketch_find_lacks(sketch);
    if (!sketch->failed && !yk_arena_failed(sketch->arena) && !sketch->text.failed) return sketch;
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory");
    yk_sketch_free(sketch);
    return NULL;
}

YkSketch *yk_sketch_parse(const char *text, size_t length, const char *name, const YkLoadOptions *options,
                          YkProblems *problems)
{
    return read(text, length, name, &(YkReading){.options = options, .is_sketch = true}, problems);
}

YkSketch *yk_sketch_load(const char *path, const YkLoadOptions *options, YkProblems *problems)
{
    size_t length = 0;
    char *text = yk_doc_read_file(path, &length, problems);
    YkSketch *sketch = text ? yk_sketch_parse(text, length, path, options, problems) : NULL;
    free(text);
    return sketch;
}

YkSketch *yk_sketch_build(YkBuilder *builder, const YkLoadOptions *options, YkProblems *problems)
{
    const YkReading how = {.options = options, .name_place = yk_builder_name_place, .is_sketch = true};
    const char *text = yk_builder_text(builder);
    if (!text) yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory");
    YkSketch *sketch = text ? read(text, builder->text.length, "sketch", &how, problems) : NULL;
    yk_problems_pass_on(problems, builder->problems, NULL);
    if (yk_problems_error_count(builder->problems) == 0) return sketch;
    yk_sketch_free(sketch);
    return NULL;
}

void yk_sketch_free(YkSketch *sketch)
{
    if (!sketch) return;
    yk_mechanism_free(sketch->mech);
    yk_model_free(sketch->model);
    yk_arena_free(sketch->arena);
    yk_text_free(&sketch->text);
    free(sketch->lacks);
    free(sketch->group);
    free(sketch);
}

const YkModel *yk_sketch_model(const YkSketch *sketch)
{
    return sketch->model;
}

const YkMechanism *yk_sketch_mechanism(const YkSketch *sketch)
{
    return sketch->mech;
}

size_t yk_sketch_lack_count(const YkSketch *sketch)
{
    return sketch->lack_count;
}

YkLack yk_sketch_lack(const YkSketch *sketch, size_t index)
{
    YkLack none = {.body = YK_NOT_FOUND, .point = YK_NOT_FOUND, .other = YK_NOT_FOUND, .coordinate = YK_NOT_FOUND};
    return index < sketch->lack_count ? sketch->lacks[index] : none;
}

const char *yk_lack_kind_name(YkLackKind kind)
{
    static const char *const names[] = {"body", "connection", "freedom", "drive", "end"};
    return names[kind];
}

bool yk_sketch_moves(const YkSketch *sketch)
{
    for (size_t i = 0; i < sketch->lack_count; i++)
        if (!sketch->lacks[i].is_optional) return false;
    return true;
}
