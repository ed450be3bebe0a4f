// Task files: which kind, the keys that all kinds share, and the way from text to a YkTask.
#include "synthesis/design.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct Kind {
    const char *name;
    void (*read)(YkTaskReader *reader), (*check)(YkTaskReader *reader);
    const char *keys[10]; // of its own
} Kind;

static const Kind kinds[YK_TASK_KINDS] = {
    {"motion", yk_task_read_motion, yk_task_check_motion, {"positions", "rates"}},
    {"function",
     yk_task_read_function,
     yk_task_check_function,
     {"of", "x", "input", "output", "samples", "evened", "pairs"}},
    {"stroke", yk_task_read_stroke, yk_task_check_stroke, {"swing", "stroke", "time_ratio"}},
    {"path", yk_task_read_path, yk_task_check_path, {"points", "closed", "angles", "angles_from"}},
    {"machine", yk_task_read_machine, yk_task_check_machine, {"machine", "free", "over", "goals"}},
};
static const char *const keys[] = {"name",       "synthesis", "units",   "parameters", "mechanisms", "fix",
                                   "bounds",     "require",   "best",    "positions",  "of",         "x",
                                   "input",      "output",    "samples", "pairs",      "swing",      "stroke",
                                   "time_ratio", "points",    "closed",  "angles",     "evened",     "angles_from",
                                   "machine",    "free",      "over",    "goals",      "rates",      NULL};

const char *yk_task_kind(const YkTask *task)
{
    return task ? kinds[task->kind].name : NULL;
}

static void hint_kinds(YkProblems *problems)
{
    yk_problem_hint(problems,
                    "yoke solves path (a point through points), motion (a body through positions), function (an angle "
                    "of another), stroke (a swing or stroke with its time ratio) and machine (parameters of a file)");
}

// Finds the kind that `synthesis:` names; reports a kind that is planned, and any other word.
static bool find_kind(YkTaskReader *reader)
{
    YkLoader *loader = reader->loader;
    const YkNode *node = yk_load_require(loader, loader->root, "synthesis", &(YkSubject){.noun = "a task file"});
    if (!node) hint_kinds(loader->problems);
    if (!node || !yk_load_expect(loader, node, YK_NODE_SCALAR, &(YkSubject){.noun = "value", .part = "synthesis"}))
        return false;
    reader->task->kind_place = node->place;
    for (size_t k = 0; k < YK_TASK_KINDS; k++) {
        if (strcmp(kinds[k].name, node->text) != 0) continue;
        reader->task->kind = (YkTaskKind)k;
        return true;
    }
    yk_problem(loader->problems, YK_CODE_TASK_KIND, node->place, "there is no kind of task %q", node->text);
    hint_kinds(loader->problems);
    return false;
}

// Reports keys that belong to other kinds.
static void check_own_keys(YkTaskReader *reader)
{
    const YkNode *root = reader->loader->root;
    for (size_t k = 0; k < YK_TASK_KINDS; k++)
        for (size_t i = 0; kinds[k].keys[i] && k != reader->task->kind; i++) {
            const YkNode *key = yk_load_key(root, kinds[k].keys[i]);
            if (!key) continue;
            yk_problem(reader->loader->problems, YK_CODE_UNKNOWN_KEY, key->place, "a task of the kind %s has no key %q",
                       kinds[reader->task->kind].name, key->text);
            yk_problem_hint(reader->loader->problems, "it belongs to `synthesis: %s`", kinds[k].name);
        }
}

static void read_bounds(YkTaskReader *reader)
{
    static const char *const own[] = {"lengths", "coupler_point", "pivots", NULL};
    YkTask *task = reader->task;
    const YkNode *map = yk_load_section(reader->loader, "bounds");
    const YkNode *pivots = map ? yk_node_get(map, "pivots") : NULL;
    if (map) yk_load_check_keys(reader->loader, map, own, &(YkSubject){.noun = "section", .part = "bounds"});
    yk_task_bound(reader, map ? yk_node_get(map, "lengths") : NULL, "lengths", YK_DIM_LENGTH, &task->lengths);
    yk_task_bound(reader, map ? yk_node_get(map, "coupler_point") : NULL, "coupler_point", YK_DIM_LENGTH,
                  &task->coupler_point);
    for (size_t i = 0; i < 2; i++) task->pivots[i] = (YkBound){-INFINITY, INFINITY, false};
    if (!pivots || !yk_load_expect(reader->loader, pivots, YK_NODE_LIST, &(YkSubject){.noun = "box", .part = "pivots"}))
        return;
    if (pivots->count != 2) {
        yk_problem(reader->loader->problems, YK_CODE_COMPONENTS, pivots->place,
                   "box `pivots` has two corners, [[x, y], [x, y]]; here are %z", pivots->count);
        return;
    }
    YkWant want = {.dimension = YK_DIM_LENGTH, .subject = {.noun = "corner", .owner = "pivots"}};
    for (size_t end = 0; end < 2; end++) { // straight into the bounds of x and y
        const YkNode *corner = pivots->items[end];
        if (!yk_load_expect(reader->loader, corner, YK_NODE_LIST, &want.subject) || corner->count != 2) {
            if (corner->kind == YK_NODE_LIST)
                yk_problem(reader->loader->problems, YK_CODE_COMPONENTS, corner->place,
                           "a corner of `pivots` has two components, x and y; here are %z", corner->count);
            continue;
        }
        for (size_t i = 0; i < 2; i++) {
            task->pivots[i].is_given = true;
            yk_load_value(reader->loader, corner->items[i], &want,
                          end == 0 ? &task->pivots[i].low : &task->pivots[i].high);
        }
    }
}

static void read_require(YkTaskReader *reader)
{
    static const char *const own[] = {"input", "transmission", "order", "size_ratio", NULL};
    static const char *const ways[] = {"turns", "moves", NULL};
    YkTask *task = reader->task;
    size_t way = 1;
    const YkNode *map = yk_load_section(reader->loader, "require");
    if (map) yk_load_check_keys(reader->loader, map, own, &(YkSubject){.noun = "section", .part = "require"});
    bool is_given = yk_task_word(reader, map, "input", ways, &way);
    task->turns = is_given && way == 0;
    task->moves = is_given && way == 1;
    task->any_order = !yk_task_yes(reader, map, "order", true);
    yk_task_value(reader, map, "transmission", YK_DIM_ANGLE, &task->transmission);
    yk_task_value(reader, map, "size_ratio", YK_DIM_NUMBER, &task->size_ratio);
}

// Returns the kinds that a word of `mechanisms:` asks for, as bits: none if the task does not give them.
static unsigned kinds_of(const YkTask *task, const char *word)
{
    size_t count = task->kind == YK_TASK_PATH       ? YK_DESIGN_KINDS
                   : task->kind == YK_TASK_MOTION   ? 3
                   : task->kind == YK_TASK_FUNCTION ? 2
                                                    : 1;
    if (strcmp(word, "all") == 0) return (1u << count) - 1;
    for (size_t k = 0; k < count; k++)
        if (strcmp(word, yk_design_kind_name((YkDesignKind)k)) == 0) return 1u << k;
    return 0;
}

static bool is_kind(const char *word)
{
    for (int k = 0; k < YK_DESIGN_KINDS; k++)
        if (strcmp(word, yk_design_kind_name((YkDesignKind)k)) == 0) return true;
    return false;
}

// Reports a word of `mechanisms:` that gives the task nothing: a warning where it is a machine, and others are left.
static void refuse_mechanism(const YkTaskReader *reader, const YkNode *item)
{
    static const char *const found[YK_TASK_KINDS] = {
        [YK_TASK_MOTION] = "four-bars, slider-cranks and inverted slider-cranks",
        [YK_TASK_FUNCTION] = "four-bars and slider-cranks",
        [YK_TASK_PATH] = "four-bars, slider-cranks, inverted slider-cranks, geared five-bars and six-bars"};
    static const char *const hint[YK_TASK_KINDS] = {
        [YK_TASK_MOTION] = "write some of [four-bar, slider-crank, inverted-slider-crank], or [all]",
        [YK_TASK_FUNCTION] = "write some of [four-bar, slider-crank], or [all]",
        [YK_TASK_PATH] = "write some of [four-bar, slider-crank, inverted-slider-crank, "
                         "geared-five-bar, watt, stephenson], or [all]"};
    YkTaskKind kind = reader->task->kind;
    bool is_passed_over = reader->task->kinds != 0 && is_kind(item->text);
    yk_problem(reader->loader->problems, is_passed_over ? YK_CODE_TASK_MECHANISM : YK_CODE_WRONG_WORD, item->place,
               "this version finds %s for a %s, not %q", found[kind] ? found[kind] : "four-bars", kinds[kind].name,
               item->text);
    yk_problem_hint(reader->loader->problems, "%s",
                    hint[kind] ? hint[kind] : "write [four-bar], or leave `mechanisms` out");
}

// `mechanisms:` may only name what the kind gives: four-bars, for functions slider-cranks as well, for motions and
// paths more.
static void read_mechanisms(YkTaskReader *reader)
{
    YkLoader *loader = reader->loader;
    YkTask *task = reader->task;
    const YkNode *list = yk_node_get(loader->root, "mechanisms");
    if (!list) task->kinds = 1u << YK_DESIGN_FOUR_BAR;
    if (list && yk_load_expect(loader, list, YK_NODE_LIST, &(YkSubject){.noun = "value", .part = "mechanisms"})) {
        for (size_t k = 0; k < list->count; k++) {
            const YkNode *item = list->items[k];
            if (!yk_load_expect(loader, item, YK_NODE_SCALAR, &(YkSubject){.noun = "entry", .owner = "mechanisms"}))
                continue;
            task->kinds |= kinds_of(task, item->text);
        }
        for (size_t k = 0; k < list->count; k++) {
            const YkNode *item = list->items[k];
            if (item->kind == YK_NODE_SCALAR && kinds_of(task, item->text) == 0) refuse_mechanism(reader, item);
        }
        if (list->count == 0) {
            yk_problem(loader->problems, YK_CODE_WRONG_WORD, list->place, "`mechanisms` names no machine");
            yk_problem_hint(loader->problems, "leave it out to have four-bars");
        }
    }
    task->has_four_bar = task->kinds >> YK_DESIGN_FOUR_BAR & 1;
    task->has_slider = task->kinds >> YK_DESIGN_SLIDER_CRANK & 1;
}

// Reports keys about dimensions that synthesis chooses: those of an existing machine are its parameters.
static void check_no_dimensions(YkTaskReader *reader)
{
    static const char *const others[] = {"mechanisms", "fix", "bounds"};
    for (size_t k = 0; k < sizeof others / sizeof *others; k++) {
        const YkNode *key = yk_load_key(reader->loader->root, others[k]);
        if (!key) continue;
        yk_problem(reader->loader->problems, YK_CODE_UNKNOWN_KEY, key->place,
                   "a task of the kind machine has no key %q", key->text);
        yk_problem_hint(reader->loader->problems, "`free: {length: [20 mm, 80 mm]}` gives parameters their ranges");
    }
}

static void read_all(YkLoader *loader, void *context)
{
    YkTaskReader *reader = context;
    reader->loader = loader;
    bool is_known = find_kind(reader), is_machine = is_known && reader->task->kind == YK_TASK_MACHINE;
    if (!is_machine) read_bounds(reader);
    if (!is_machine) read_require(reader);
    const YkNode *node = yk_node_get(loader->root, "best");
    YkWant want = {.dimension = YK_DIM_NUMBER, .subject = {.noun = "value", .part = "best"}};
    reader->best = 10;
    if (node) yk_load_value(loader, node, &want, &reader->best);
    if (!is_known) return;
    if (is_machine)
        check_no_dimensions(reader);
    else
        read_mechanisms(reader);
    check_own_keys(reader);
    kinds[reader->task->kind].read(reader);
}

static void check_range(YkTaskReader *reader, const char *name, const YkBound *bound, double least)
{
    if (!bound->is_given || isnan(bound->low) || isnan(bound->high)) return;
    if (bound->low <= bound->high && bound->high >= least) return;
    const YkNode *section = yk_node_get(reader->loader->root, "bounds");
    yk_problem(reader->loader->problems, YK_CODE_TASK_BOUNDS, section ? section->place : (YkPlace){0},
               "the range of %q is empty: it ends before it begins", name);
}

static void check_all(YkLoader *loader, void *context)
{
    enum { BEST_MAX = 1000 };
    YkTaskReader *reader = context;
    YkTask *task = reader->task;
    check_range(reader, "lengths", &task->lengths, 0);
    check_range(reader, "coupler_point", &task->coupler_point, -INFINITY);
    for (size_t i = 0; i < 2; i++) check_range(reader, "pivots", &task->pivots[i], -INFINITY);
    if (!isnan(reader->best) && !(reader->best >= 1 && reader->best <= BEST_MAX && reader->best == floor(reader->best)))
        yk_problem(loader->problems, YK_CODE_TASK_BOUNDS, yk_node_get(loader->root, "best")->place,
                   "`best` is a whole number from 1 to %d", (int)BEST_MAX);
    else if (!isnan(reader->best))
        task->best = (size_t)reader->best;
    if (task->kind_place.line > 0 && kinds[task->kind].check) kinds[task->kind].check(reader);
}

YkTask *yk_task_parse(const char *text, size_t length, const char *name, YkProblems *problems)
{
    YkTask *task = calloc(1, sizeof *task);
    YkTaskReader reader = {.task = task};
    YkSheet sheet = {"a task file", keys, read_all, check_all, &reader};
    if (!task || !text || !name) {
        yk_problem(problems, task ? YK_CODE_TASK_KIND : YK_CODE_OUT_OF_MEMORY, (YkPlace){0},
                   task ? "no text of a task is given" : "out of memory while loading the task");
        free(task);
        return NULL;
    }
    task->sheet = yk_model_read(text, length, name, &(YkReading){.sheet = &sheet}, problems);
    if (task->sheet) return task;
    yk_task_free(task);
    return NULL;
}

YkTask *yk_task_load(const char *path, YkProblems *problems)
{
    size_t length = 0;
    char *text = path ? yk_doc_read_file(path, &length, problems) : NULL;
    YkTask *task = text ? yk_task_parse(text, length, path, problems) : NULL;
    free(text);
    return task;
}

void yk_task_free(YkTask *task)
{
    if (!task) return;
    yk_mechanism_free(task->machine.mech);
    yk_model_free(task->machine.model);
    yk_model_free(task->sheet);
    free(task);
}

const char *yk_task_name(const YkTask *task)
{
    return task ? yk_model_name(task->sheet) : NULL;
}

const char *yk_task_unit(const YkTask *task, YkQuantity quantity, double *size)
{
    return task ? yk_model_unit(task->sheet, quantity, size) : NULL;
}
