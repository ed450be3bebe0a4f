// The loader: turns a model file into a YkModel, or into a list of everything that is wrong with it.
#include <stdlib.h>
#include <string.h>
#include "model/load.h"

static const char *const keys[] = {"name",  "units",   "parameters", "gravity", "bodies", "joints", "drives",
                                   "start", "efforts", "forces",     "springs", "stops",  "gears",  "racks",
                                   "belts", "cams",    "laws",       "locks",   NULL};

YkLoadOptions yk_default_load_options(void)
{
    return (YkLoadOptions){0};
}

// Returns the file's name without folder and ending.
static const char *base_name(YkArena *arena, const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *start = slash ? slash + 1 : path;
    const char *dot = strrchr(start, '.');
    size_t length = dot && dot != start ? (size_t)(dot - start) : strlen(start);
    if (length == 0 || strcmp(start, "-") == 0) return "machine";
    return yk_arena_copy(arena, start, length);
}

static void read_name(YkLoader *loader)
{
    YkModel *model = loader->model;
    const YkNode *name = yk_node_get(loader->root, "name");
    model->name = base_name(loader->arena, model->source_name);
    if (yk_load_is_empty(name) || !yk_load_expect(loader, name, YK_NODE_SCALAR, &(YkSubject){.noun = "name"})) return;
    if (name->length) model->name = name->text;
}

typedef void (*Step)(YkLoader *loader);

// The first pass: every section, parameters before their uses, bodies before joints, joints before coordinates.
static const Step before_bodies[] = {read_name,         yk_load_units,   yk_load_parameters,
                                     yk_load_overrides, yk_load_gravity, yk_load_bodies};
static const Step after_bodies[] = {yk_load_wheels, yk_load_joints,  yk_load_laws,   yk_load_cams,    yk_load_drives,
                                    yk_load_starts, yk_load_efforts, yk_load_forces, yk_load_springs, yk_load_stops,
                                    yk_load_gears,  yk_load_racks,   yk_load_belts,  yk_load_locks};
// The second pass: names, dimensions, values; then the checks that need values.
static const Step second_pass[] = {
    yk_load_check_uses,      yk_load_infer,         yk_load_eval_parameters, yk_load_check_overrides,
    yk_load_eval_uses,       yk_load_keep_uses,     yk_load_check_gravity,   yk_load_finish_laws,
    yk_load_finish_masses,   yk_load_finish_joints, yk_load_finish_cams,     yk_load_finish_forces,
    yk_load_finish_springs,  yk_load_finish_stops,  yk_load_finish_friction, yk_load_finish_gears,
    yk_load_finish_racks,    yk_load_finish_belts,  yk_load_share_planets,   yk_load_engage,
    yk_load_check_connected, yk_load_check_links};

// Runs one step after the other, until the caller of the long call stops it.
static void run(YkLoader *loader, const Step *steps, size_t count)
{
    for (size_t k = 0; k < count && !yk_pace_is_stopped(loader->arena->pace); k++) steps[k](loader);
}

static void read_sections(YkLoader *loader)
{
    yk_load_check_keys(loader, loader->root, keys, &(YkSubject){.noun = "a model file"});
    run(loader, before_bodies, sizeof before_bodies / sizeof *before_bodies);
    if (loader->model->bodies && !loader->failed && !yk_arena_failed(loader->arena))
        run(loader, after_bodies, sizeof after_bodies / sizeof *after_bodies);
}

static void resolve(YkLoader *loader)
{
    run(loader, second_pass, sizeof second_pass / sizeof *second_pass);
}

static bool is_out_of_memory(const YkLoader *loader)
{
    return loader->failed || loader->text.failed || yk_arena_failed(loader->arena);
}

// The sections of a document that is not a machine, with the steps that every value needs.
static void load_sheet(YkLoader *loader, const YkSheet *sheet)
{
    static const Step values[] = {yk_load_check_uses, yk_load_infer, yk_load_eval_parameters, yk_load_check_overrides,
                                  yk_load_eval_uses};
    yk_load_check_keys(loader, loader->root, sheet->keys, &(YkSubject){.noun = sheet->noun});
    run(loader, (const Step[]){read_name, yk_load_units, yk_load_parameters, yk_load_overrides}, 4);
    sheet->read(loader, sheet->context);
    if (is_out_of_memory(loader)) return;
    loader->dimensions = yk_dimensions_new(loader->arena, &loader->model->units);
    if (!loader->dimensions) return;
    run(loader, values, sizeof values / sizeof *values);
    sheet->finish(loader, sheet->context);
}

static void load(YkLoader *loader, const YkSheet *sheet)
{
    if (loader->root->kind != YK_NODE_MAP) {
        yk_problem(loader->problems, YK_CODE_MODEL_NOT_MAP, loader->root->place, "%s is a map of keys, this is %s",
                   sheet ? sheet->noun : "a model file", yk_node_kind_name(loader->root));
        return;
    }
    if (sheet) {
        load_sheet(loader, sheet);
        return;
    }
    read_sections(loader);
    if (is_out_of_memory(loader)) return;
    // It copies the units, so it comes after `units:`.
    loader->dimensions = yk_dimensions_new(loader->arena, &loader->model->units);
    if (loader->dimensions) resolve(loader);
}

static const double PARSED = 0.6; // share of the work

static YkModel *new_model(const char *name)
{
    YkArena *arena = yk_arena_new();
    YkModel *model = arena ? YK_NEW(arena, YkModel, 1) : NULL;
    const char *source = model ? yk_arena_copy(arena, name, strlen(name)) : NULL;
    if (!source) {
        yk_arena_free(arena);
        return NULL;
    }
    model->arena = arena;
    model->source_name = source;
    return model;
}

// Returns whether an error came after the first `errors` errors. A list that is full may have lost some.
static bool has_new_errors(const YkProblems *problems, size_t errors)
{
    size_t now = yk_problems_error_count(problems);
    return now > errors || (now > 0 && yk_problems_count(problems) > YK_PROBLEMS_MAX);
}

// Loads into a new model; returns false if there was an error.
static bool fill(YkModel *model, const char *text, size_t length, const YkReading *how, YkProblems *problems)
{
    size_t errors = yk_problems_error_count(problems);
    YkLoader loader = {.model = model, .arena = model->arena};
    loader.problems = problems;
    loader.options = how->options;
    loader.is_sketch = how->is_sketch;
    yk_pace_stage(model->arena->pace, 0, PARSED);
    loader.root = yk_doc_parse(text, length, model->source_name, model->arena, problems);
    yk_pace_stage(model->arena->pace, PARSED, 1);
    if (how->name_place) yk_problems_name_places(problems, how->name_place);
    if (loader.root) load(&loader, how->sheet);
    bool done = loader.root && !has_new_errors(problems, errors);
    if (done) yk_load_keep_source(&loader, text, length);
    if (yk_pace_is_stopped(model->arena->pace)) {
        yk_problem_stopped(problems);
        done = false;
    } else if (is_out_of_memory(&loader) || (done && !how->sheet && !yk_load_size(model))) {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while loading the model");
        done = false;
    }
    free(loader.uses);
    yk_names_free(&loader.fixed);
    yk_text_free(&loader.text);
    return done;
}

YkModel *yk_model_read(const char *text, size_t length, const char *name, const YkReading *how, YkProblems *problems)
{
    YkProblems *own = problems ? NULL : yk_problems_new(); // errors are counted even if the caller does not want them
    YkModel *model = problems || own ? new_model(name) : NULL;
    YkPace pace;
    yk_pace_begin(&pace, how->options ? how->options->progress : (YkProgress){0});
    if (model) model->arena->pace = &pace;
    if (!model) {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while loading the model");
    } else if (!fill(model, text, length, how, problems ? problems : own)) {
        yk_model_free(model);
        model = NULL;
    }
    if (model) model->arena->pace = NULL;
    yk_problems_free(own);
    return model;
}

YkModel *yk_model_parse(const char *text, size_t length, const char *name, const YkLoadOptions *options,
                        YkProblems *problems)
{
    return yk_model_read(text, length, name, &(YkReading){.options = options}, problems);
}

YkModel *yk_model_load(const char *path, const YkLoadOptions *options, YkProblems *problems)
{
    size_t length = 0;
    char *text = yk_doc_read_file(path, &length, problems);
    YkModel *model = text ? yk_model_parse(text, length, path, options, problems) : NULL;
    free(text);
    return model;
}

void yk_model_free(YkModel *model)
{
    if (!model) return;
    yk_names_free(&model->body_names);
    yk_names_free(&model->joint_names);
    yk_names_free(&model->parameter_names);
    yk_names_free(&model->coordinate_names);
    yk_names_free(&model->point_names);
    yk_arena_free(model->arena); // the arena contains the model itself
}
