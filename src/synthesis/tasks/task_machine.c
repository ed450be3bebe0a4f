// `synthesis: machine`: parameters of a model file that may vary, and what the machine is to do.
#include <math.h>
#include <string.h>
#include "synthesis/tasks/task.h"

// Puts the machine's path beside that of the task.
static void place_beside(const YkLoader *loader, const char *file, YkText *path)
{
    const char *own = loader->model->source_name, *slash = own ? strrchr(own, '/') : NULL;
    if (slash && file[0] != '/') yk_text_add(path, own, (size_t)(slash - own) + 1);
    yk_text_puts(path, file);
}

// Reports the first mistake of the machine's own file at the place where the task names it.
static void tell_machine(YkTaskReader *reader, const YkNode *node, const YkProblems *own)
{
    const YkProblem *why = NULL;
    if (yk_task_out_of_memory(reader, own)) return;
    for (size_t k = 0; k < yk_problems_count(own) && !why; k++)
        if (yk_problems_get(own, k)->severity == YK_SEVERITY_ERROR) why = yk_problems_get(own, k);
    yk_problem(reader->loader->problems, YK_CODE_TASK_MACHINE, node->place, "machine %q: line %z: %s", node->text,
               (size_t)(why ? why->place.line : 0), why ? why->message : "it cannot be read");
    yk_problem_hint(reader->loader->problems, "`yoke check` shows all about that file; its path begins at the task's");
}

static void load_machine(YkTaskReader *reader, const char *coordinate)
{
    YkLoader *loader = reader->loader;
    YkMachineTask *machine = &reader->task->machine;
    const YkNode *node = yk_load_require(loader, loader->root, "machine", &(YkSubject){.noun = "a machine task"});
    YkText path = {0};
    YkProblems *own = yk_problems_new();
    YkCompileOptions options = yk_default_compile_options();
    options.inputs = &coordinate;
    options.input_count = coordinate ? 1 : 0;
    if (node && own && yk_load_expect(loader, node, YK_NODE_SCALAR, &(YkSubject){.noun = "value", .part = "machine"})) {
        machine->place = node->place;
        place_beside(loader, node->text, &path);
        if (!path.failed) machine->model = yk_model_load(yk_text_get(&path), NULL, own);
        if (machine->model) machine->mech = yk_mechanism_compile(machine->model, &options, own);
        if (!machine->mech && !path.failed) tell_machine(reader, node, own);
    }
    if (!own || path.failed) loader->failed = true;
    yk_text_free(&path);
    yk_problems_free(own);
}

// --- free: {NAME: [from, to]}

static void read_free(YkTaskReader *reader)
{
    YkLoader *loader = reader->loader;
    YkMachineTask *machine = &reader->task->machine;
    const YkNode *map = yk_load_require(loader, loader->root, "free", &(YkSubject){.noun = "a machine task"});
    if (!map || !yk_load_expect(loader, map, YK_NODE_MAP, &(YkSubject){.noun = "section", .part = "free"})) return;
    if (map->count < 1 || map->count > YK_FREE_MAX) {
        yk_problem(loader->problems, YK_CODE_TASK_BOUNDS, map->place, "1 to %d parameters may be free; here are %z",
                   (int)YK_FREE_MAX, map->count);
        return;
    }
    machine->name = YK_NEW(loader->arena, const char *, map->count);
    machine->range = YK_NEW(loader->arena, YkBound, map->count);
    if (!machine->name || !machine->range || !machine->model) return;
    for (size_t k = 0; k < map->count; k++) {
        const YkNode *key = map->pairs[k].key, *value = map->pairs[k].value;
        int32_t index = yk_names_find(&machine->model->parameter_names, key->text);
        if (index == YK_NONE) {
            yk_problem(loader->problems, YK_CODE_UNKNOWN_NAME, key->place, "the machine has no parameter %q",
                       key->text);
            continue;
        }
        machine->name[machine->free_count] = yk_arena_copy(loader->arena, key->text, key->length);
        yk_task_bound(reader, value, key->text, machine->model->parameters[index].dimension,
                      &machine->range[machine->free_count++]);
    }
}

// --- over: {input: NAME, range: [from, to], steps: 72}

static const char *coordinate_of(YkTaskReader *reader, const YkNode *over)
{
    const YkNode *node =
        yk_load_require(reader->loader, over, "input", &(YkSubject){.noun = "section", .part = "over"});
    bool good =
        node && yk_load_expect(reader->loader, node, YK_NODE_SCALAR, &(YkSubject){.noun = "value", .part = "input"});
    return good ? node->text : NULL;
}

static void read_over(YkTaskReader *reader, const YkNode *over, const char *coordinate)
{
    YkLoader *loader = reader->loader;
    YkMachineTask *machine = &reader->task->machine;
    const YkNode *range = yk_load_require(loader, over, "range", &(YkSubject){.noun = "section", .part = "over"});
    const YkNode *steps = yk_node_get(over, "steps");
    YkWant want = {.dimension = YK_DIM_NUMBER, .subject = {.noun = "value", .part = "steps"}};
    machine->steps_read = 72;
    if (steps) yk_load_value(loader, steps, &want, &machine->steps_read);
    if (!machine->mech || !coordinate || !range) return;
    machine->coordinate = yk_coordinate_find(machine->mech, coordinate);
    if (machine->coordinate == YK_NOT_FOUND) return;
    bool is_distance = yk_coordinate_info(machine->mech, machine->coordinate).is_distance;
    yk_task_bound(reader, range, "range", is_distance ? YK_DIM_LENGTH : YK_DIM_ANGLE, &machine->over);
}

// --- goals

static void read_through(YkTaskReader *reader, const YkNode *map, YkGoal *goal)
{
    YkLoader *loader = reader->loader;
    const YkNode *point = yk_node_get(map, "point");
    const YkNode *list = yk_load_require(loader, map, "through", &(YkSubject){.noun = "goal"});
    YkWant want = {.dimension = YK_DIM_LENGTH, .subject = {.noun = "point", .owner = "through"}};
    YkExpr *expr[2];
    static const char *const axes[] = {".x", ".y"};
    goal->kind = YK_GOAL_THROUGH;
    if (!yk_load_expect(loader, point, YK_NODE_SCALAR, &(YkSubject){.noun = "value", .part = "point"})) return;
    for (size_t i = 0; i < 2; i++) {
        YkText name = {0};
        yk_text_format(&name, "%s%s", point->text, axes[i]);
        goal->channel[i] = yk_task_channel(reader, point, yk_text_get(&name));
        if (name.failed) loader->failed = true;
        yk_text_free(&name);
        if (goal->channel[i] == YK_NOT_FOUND) return;
    }
    if (!list || !yk_load_expect(loader, list, YK_NODE_LIST, &(YkSubject){.noun = "value", .part = "through"})) return;
    if (list->count < 1 || list->count > YK_PATH_POINTS_MAX) {
        yk_problem(loader->problems, YK_CODE_TASK_POSITIONS, list->place, "`through` has 1 to %d points; here are %z",
                   (int)YK_PATH_POINTS_MAX, list->count);
        return;
    }
    goal->point = YK_NEW(loader->arena, YkVec, list->count);
    for (size_t k = 0; goal->point && k < list->count; k++) {
        goal->point[k] = yk_vec(NAN, NAN);
        yk_load_pair(loader, list->items[k], &want, expr, &goal->point[k]);
        goal->count = k + 1;
    }
}

static void read_equals(YkTaskReader *reader, const YkNode *map, YkGoal *goal)
{
    YkLoader *loader = reader->loader;
    const YkMachineTask *machine = &reader->task->machine;
    const YkNode *value = yk_node_get(map, "value"), *where = yk_node_get(map, "where");
    const YkNode *equals = yk_load_require(loader, map, "equals", &(YkSubject){.noun = "goal"});
    goal->kind = YK_GOAL_EQUALS;
    if (!yk_load_expect(loader, value, YK_NODE_SCALAR, &(YkSubject){.noun = "value", .part = "value"})) return;
    goal->channel[0] = yk_task_channel(reader, value, value->text);
    if (goal->channel[0] == YK_NOT_FOUND) return;
    YkWant want = {.subject = {.noun = "value", .part = "equals"}};
    want.dimension = yk_quantity_dimension(machine->channel[goal->channel[0]].quantity);
    if (equals) yk_load_value(loader, equals, &want, &goal->equals);
    bool is_distance =
        machine->coordinate != YK_NOT_FOUND && yk_coordinate_info(machine->mech, machine->coordinate).is_distance;
    yk_task_bound(reader, where, "where", is_distance ? YK_DIM_LENGTH : YK_DIM_ANGLE, &goal->where);
}

static void read_goal(YkTaskReader *reader, const YkNode *map, YkGoal *goal)
{
    static const char *const keys[3][5] = {
        {"point", "through", "weight", NULL}, {"value", "equals", "where", "weight", NULL}, {"least", "weight", NULL}};
    YkLoader *loader = reader->loader;
    YkMeasure measure;
    *goal = (YkGoal){.channel = {YK_NOT_FOUND, YK_NOT_FOUND}, .equals = NAN, .weight = 1};
    if (!yk_load_expect(loader, map, YK_NODE_MAP, &(YkSubject){.noun = "goal"})) return;
    const YkNode *least = yk_node_get(map, "least"), *weight = yk_node_get(map, "weight");
    YkWant want = {.dimension = YK_DIM_NUMBER, .subject = {.noun = "value", .part = "weight"}};
    size_t kind = yk_node_get(map, "point") ? 0 : yk_node_get(map, "value") ? 1 : 2;
    yk_load_check_keys(loader, map, keys[kind], &(YkSubject){.noun = "goal"});
    if (weight) yk_load_value(loader, weight, &want, &goal->weight);
    if (kind == 0) read_through(reader, map, goal);
    if (kind == 1) read_equals(reader, map, goal);
    if (kind < 2) return;
    goal->kind = YK_GOAL_LEAST;
    least = yk_load_require(loader, map, "least", &(YkSubject){.noun = "goal"});
    if (!least || !yk_load_expect(loader, least, YK_NODE_SCALAR, &(YkSubject){.noun = "value", .part = "least"}))
        return;
    const char *rest = yk_task_measure(reader, least, &measure, &goal->channel[0]);
    if (!rest || (measure == YK_MEASURE_MAX_ABS && *rest == '\0')) return;
    yk_problem(loader->problems, YK_CODE_TASK_FUNCTION, least->place, "`least` takes max(abs(CHANNEL)), not %q",
               least->text);
}

static void read_goals(YkTaskReader *reader)
{
    YkLoader *loader = reader->loader;
    YkMachineTask *machine = &reader->task->machine;
    const YkNode *list = yk_load_require(loader, loader->root, "goals", &(YkSubject){.noun = "a machine task"});
    const YkNode *require = yk_node_get(loader->root, "require");
    if (list && yk_load_expect(loader, list, YK_NODE_LIST, &(YkSubject){.noun = "section", .part = "goals"})) {
        machine->goal = YK_NEW(loader->arena, YkGoal, list->count + 1);
        for (size_t k = 0; machine->goal && k < list->count; k++)
            read_goal(reader, list->items[k], &machine->goal[machine->goal_count++]);
        if (list->count == 0) yk_problem(loader->problems, YK_CODE_TASK_BOUNDS, list->place, "`goals` has no goal");
    }
    if (!require || !yk_load_expect(loader, require, YK_NODE_LIST, &(YkSubject){.noun = "section", .part = "require"}))
        return;
    machine->claim = YK_NEW(loader->arena, YkClaim, require->count + 1);
    for (size_t k = 0; machine->claim && k < require->count; k++)
        if (yk_task_claim(reader, require->items[k], &machine->claim[machine->claim_count])) machine->claim_count++;
}

void yk_task_read_machine(YkTaskReader *reader)
{
    static const char *const own[] = {"input", "range", "steps", NULL};
    YkLoader *loader = reader->loader;
    const YkNode *over = yk_load_require(loader, loader->root, "over", &(YkSubject){.noun = "a machine task"});
    bool is_map = over && yk_load_expect(loader, over, YK_NODE_MAP, &(YkSubject){.noun = "section", .part = "over"});
    reader->task->machine.coordinate = YK_NOT_FOUND;
    if (is_map) yk_load_check_keys(loader, over, own, &(YkSubject){.noun = "section", .part = "over"});
    const char *coordinate = is_map ? coordinate_of(reader, over) : NULL;
    load_machine(reader, coordinate);
    if (is_map) read_over(reader, over, coordinate);
    read_free(reader);
    read_goals(reader);
}

void yk_task_check_machine(YkTaskReader *reader)
{
    enum { STEPS_MAX = 10000 };
    YkMachineTask *machine = &reader->task->machine;
    YkProblems *problems = reader->loader->problems;
    const YkNode *root = reader->loader->root, *free = yk_node_get(root, "free"), *over = yk_node_get(root, "over");
    for (size_t k = 0; k < machine->free_count; k++)
        if (!isnan(machine->range[k].low + machine->range[k].high) && !(machine->range[k].low < machine->range[k].high))
            yk_problem(problems, YK_CODE_TASK_BOUNDS, free->place, "the range of %q is empty: it ends before it begins",
                       machine->name[k]);
    double steps = machine->steps_read;
    if (over && !isnan(steps) && !(steps >= 2 && steps <= STEPS_MAX && steps == floor(steps)))
        yk_problem(problems, YK_CODE_TASK_BOUNDS, over->place, "`steps` is a whole number from 2 to %d",
                   (int)STEPS_MAX);
    else if (!isnan(steps))
        machine->steps = (size_t)steps;
    if (over && machine->over.is_given && machine->over.low == machine->over.high)
        yk_problem(problems, YK_CODE_TASK_BOUNDS, over->place, "the range of `over` has no length");
    for (size_t k = 0; k < machine->goal_count; k++)
        if (!(machine->goal[k].weight > 0) && !isnan(machine->goal[k].weight))
            yk_problem(problems, YK_CODE_TASK_BOUNDS, yk_node_get(root, "goals")->place,
                       "the weight of goal %z is not positive", k + 1);
}

const char *yk_task_parameter_unit(const YkTask *task, size_t index, double *size)
{
    static const YkQuantity quantities[] = {YK_QUANTITY_LENGTH, YK_QUANTITY_ANGLE};
    if (size) *size = 1;
    if (!task || index >= task->machine.free_count) return NULL;
    const YkModel *model = task->machine.model;
    int32_t parameter = yk_names_find(&model->parameter_names, task->machine.name[index]);
    if (parameter == YK_NONE) return NULL;
    for (size_t k = 0; k < 2; k++)
        if (yk_dimension_equal(model->parameters[parameter].dimension, yk_quantity_dimension(quantities[k])))
            return yk_model_unit(model, quantities[k], size);
    return NULL;
}
