// `synthesis: function`: an angle that is to follow another, by a formula or by pairs.
#include <math.h>
#include <string.h>
#include "synthesis/tasks/task.h"

static YkDimension output_dimension(const YkFunctionTask *function)
{
    return function->is_slider ? YK_DIM_LENGTH : YK_DIM_ANGLE;
}

static void read_formula(YkTaskReader *reader, const YkNode *of)
{
    static const YkOwnName own[] = {{"x", YK_OWN_ARGUMENT, "the function's argument"}, {0}};
    YkLoader *loader = reader->loader;
    YkFunctionTask *function = &reader->task->function;
    YkWant want = {.dimension = YK_DIM_NUMBER, .subject = {.noun = "function", .part = "of"}, .own = own};
    YkBound *range = &function->range;
    function->place = of->place;
    function->of = yk_load_value(loader, of, &want, NULL);
    const YkNode *x = yk_load_require(loader, loader->root, "x", &(YkSubject){.noun = "the function"});
    range->low = range->high = NAN;
    if (x) yk_task_bound(reader, x, "x", YK_DIM_NUMBER, range);
    yk_task_need(reader, loader->root, "input", YK_DIM_ANGLE, &function->input);
    yk_task_need(reader, loader->root, "output", output_dimension(function), &function->output);
}

static void read_pairs(YkTaskReader *reader, const YkNode *pairs)
{
    YkLoader *loader = reader->loader;
    YkFunctionTask *function = &reader->task->function;
    YkWant want[2] = {{.dimension = YK_DIM_ANGLE, .subject = {.noun = "angle", .owner = "pairs"}},
                      {.dimension = output_dimension(function), .subject = {.noun = "output", .owner = "pairs"}}};
    function->place = pairs->place;
    if (!yk_load_expect(loader, pairs, YK_NODE_LIST, &(YkSubject){.noun = "section", .part = "pairs"})) return;
    if (pairs->count < 3 || pairs->count > YK_PAIRS_MAX) {
        yk_problem(loader->problems, YK_CODE_TASK_POSITIONS, pairs->place,
                   "a machine meets three to five pairs exactly; here are %z", pairs->count);
        return;
    }
    function->count = pairs->count;
    for (size_t k = 0; k < pairs->count; k++) {
        const YkNode *pair = pairs->items[k];
        function->pair[k][0] = function->pair[k][1] = NAN;
        if (!yk_load_expect(loader, pair, YK_NODE_LIST, &(YkSubject){.noun = "pair"})) continue;
        if (pair->count != 2) {
            yk_problem(loader->problems, YK_CODE_COMPONENTS, pair->place,
                       "a pair is [input, output]; here are %z values", pair->count);
            continue;
        }
        for (size_t i = 0; i < 2; i++) yk_load_value(loader, pair->items[i], &want[i], &function->pair[k][i]);
    }
}

void yk_task_read_function(YkTaskReader *reader)
{
    static const char *const own[] = {"input_start", "output_start", "ground", "travel", NULL};
    YkLoader *loader = reader->loader;
    YkFunctionTask *function = &reader->task->function;
    const YkNode *of = yk_node_get(loader->root, "of"), *pairs = yk_node_get(loader->root, "pairs");
    const YkNode *fix = yk_load_section(loader, "fix"), *samples = yk_node_get(loader->root, "samples");
    if (fix) yk_load_check_keys(loader, fix, own, &(YkSubject){.noun = "section", .part = "fix"});
    function->is_slider = reader->task->has_slider && !reader->task->has_four_bar;
    yk_task_value(reader, fix, own[0], YK_DIM_ANGLE, &function->phase[0]);
    yk_task_value(reader, fix, own[1], output_dimension(function), &function->phase[1]);
    yk_task_value(reader, fix, own[2], YK_DIM_LENGTH, &function->ground);
    yk_task_value(reader, fix, own[3], YK_DIM_LENGTH, &function->travel);
    reader->samples = 5;
    YkWant want = {.dimension = YK_DIM_NUMBER, .subject = {.noun = "value", .part = "samples"}};
    if (samples) yk_load_value(loader, samples, &want, &reader->samples);
    function->evened = yk_task_yes(reader, loader->root, "evened", false);
    if (of && pairs) {
        const YkNode *key = yk_load_key(loader->root, "pairs");
        yk_problem(loader->problems, YK_CODE_RIVAL_KEYS, key->place,
                   "the function is given twice: by `of` and by `pairs`");
    } else if (of) {
        read_formula(reader, of);
    } else if (pairs) {
        read_pairs(reader, pairs);
    } else {
        yk_problem(loader->problems, YK_CODE_MISSING_KEY, loader->root->place, "a function task needs `of` or `pairs`");
        yk_problem_hint(loader->problems, "`of: x^1.5` with `x: [1, 4]`, or `pairs: [[0, 0], [30 deg, 20 deg], ...]`");
    }
}

// --- values

typedef struct Argument {
    const YkModel *sheet;
    double x;
} Argument;

static bool look_up(const void *context, const YkExpr *name, YkJet *jet)
{
    const Argument *argument = context;
    *jet = (YkJet){{0}};
    if (strcmp(name->name, YK_OWN_ARGUMENT) == 0) {
        jet->d[0] = argument->x;
        return true;
    }
    if (strcmp(name->name, "pi") == 0) {
        jet->d[0] = YK_PI;
        return true;
    }
    int32_t index = yk_names_find(&argument->sheet->parameter_names, name->name);
    if (index == YK_NONE) return false;
    jet->d[0] = argument->sheet->parameters[index].value;
    return isfinite(jet->d[0]);
}

bool yk_task_function(const YkTask *task, double x, double *value)
{
    Argument argument = {task->sheet, x};
    YkJet jet;
    const char *why = NULL;
    if (yk_expr_eval(task->function.of, look_up, &argument, &jet, &why)) return false;
    *value = jet.d[0];
    return isfinite(*value);
}

// Chebyshev's spacing of n points over [-1, 1]: where the error of an interpolating polynomial is small throughout.
static double spaced(size_t k, size_t n)
{
    return -yk_cos(YK_PI * (2 * (double)k + 1) / (2 * (double)n));
}

// Puts the function's values at the precision points into angles from the start of the range.
static void take_samples(YkTaskReader *reader)
{
    YkTask *task = reader->task;
    YkFunctionTask *f = &task->function;
    YkModel *sheet = reader->loader->model;
    double at_start, at_end, value;
    task->sheet = sheet;
    bool good = yk_task_function(task, f->range.low, &at_start) && yk_task_function(task, f->range.high, &at_end);
    if (good && !(fabs(at_end - at_start) > 1e-12 * (fabs(at_end) + fabs(at_start)))) {
        yk_problem(reader->loader->problems, YK_CODE_TASK_FUNCTION, f->place,
                   "the function has the same value at both ends of `x`, which gives the output no range");
        return;
    }
    for (size_t k = 0; good && k < f->count; k++) {
        double part = (spaced(k, f->count) + 1) / 2;
        good = yk_task_function(task, f->range.low + part * (f->range.high - f->range.low), &value);
        f->pair[k][0] = part * f->input;
        f->pair[k][1] = good ? (value - at_start) / (at_end - at_start) * f->output : NAN;
    }
    if (!good)
        yk_problem(reader->loader->problems, YK_CODE_TASK_FUNCTION, f->place, "the function has no value in its range");
}

static void check_ranges(YkTaskReader *reader)
{
    YkFunctionTask *f = &reader->task->function;
    YkProblems *problems = reader->loader->problems;
    if (f->range.low == f->range.high)
        yk_problem(problems, YK_CODE_TASK_FUNCTION, f->place, "the range of `x` has no length");
    for (size_t i = 0; i < 2; i++) {
        double range = i == 0 ? f->input : f->output;
        const char *name = i == 0 ? "input" : "output";
        bool is_travel = i == 1 && f->is_slider;
        if (isnan(range) || (is_travel ? range != 0 : fabs(range) > 1e-6 && fabs(range) < 2 * YK_PI)) continue;
        yk_problem(problems, YK_CODE_TASK_FUNCTION, yk_node_get(reader->loader->root, name)->place,
                   is_travel ? "the range of the %s has no length"
                             : "the range of the %s is between 0 and a whole turn, either way",
                   name);
    }
}

// The range begins at the first pair, where the links stand as `fix` says: pairs become what both turn from there.
static void check_pairs(YkTaskReader *reader)
{
    YkFunctionTask *f = &reader->task->function;
    for (size_t k = f->count; k-- > 0;)
        for (size_t i = 0; i < 2; i++) f->pair[k][i] -= f->pair[0][i];
    double turn = f->pair[f->count - 1][0] - f->pair[0][0];
    for (size_t k = 1; k < f->count; k++) {
        double step = f->pair[k][0] - f->pair[k - 1][0];
        if (isnan(step) || (step * turn > 0 && fabs(turn) < 2 * YK_PI)) continue;
        yk_problem(reader->loader->problems, YK_CODE_TASK_FUNCTION, f->place,
                   "the inputs of `pairs` go one way, within a turn: pair %z does not follow pair %z", k + 1, k);
        return;
    }
}

// The sizes of both kinds are free where the output is an angle: four-bars have a ground, slider-cranks a travel.
static void check_sizes(YkTaskReader *reader)
{
    YkTask *task = reader->task;
    const YkFunctionTask *f = &task->function;
    YkProblems *problems = reader->loader->problems;
    const YkNode *fix = yk_node_get(reader->loader->root, "fix");
    if (f->ground.is_given && (f->ground.value <= 0 || f->is_slider))
        yk_problem(problems, YK_CODE_TASK_BOUNDS, fix->place,
                   f->is_slider ? "a slider-crank has no `ground`: its output is a length, which settles its size"
                                : "the length of the ground is positive");
    bool is_used = task->has_slider && task->has_four_bar && f->of;
    if (f->travel.is_given && (!is_used || f->travel.value == 0)) {
        yk_problem(problems, YK_CODE_TASK_BOUNDS, fix->place,
                   "`travel` is the range of a slider's output, not 0, where `output` is the angle of four-bars");
        yk_problem_hint(problems, "for slider-cranks alone `output: 80 mm` gives it");
    }
    if (!task->has_slider || !task->has_four_bar || f->of) return;
    yk_problem(problems, YK_CODE_TASK_MECHANISM, f->place,
               "slider-cranks are left out: the outputs of `pairs` are angles where four-bars are sought");
    yk_problem_hint(problems, "with `mechanisms: [slider-crank]` alone they are lengths");
    task->has_slider = false;
}

// Refuses a start that the points leave no freedom for: five none, four one, which of a slider-crank is the input's.
static void check_starts(YkTaskReader *reader, size_t points)
{
    const YkFunctionTask *f = &reader->task->function;
    const YkNode *fix = yk_node_get(reader->loader->root, "fix");
    size_t given = (size_t)f->phase[0].is_given + (size_t)f->phase[1].is_given;
    bool is_place = f->is_slider && points == 4 && f->phase[1].is_given;
    if (given <= YK_PAIRS_MAX - points && !is_place) return;
    const char *which = f->phase[0].is_given && !is_place ? "input_start" : "output_start";
    yk_problem(reader->loader->problems, YK_CODE_TASK_BOUNDS, yk_node_get(fix, which)->place,
               points == YK_PAIRS_MAX ? "five points leave no start free: `%s` cannot be given"
               : f->is_slider         ? "four points leave the start of the crank free: `%s` cannot be given"
                                      : "four points leave one start free: `%s` cannot be given as well",
               which);
    yk_problem_hint(reader->loader->problems, "leave it out, or meet fewer points");
}

void yk_task_check_function(YkTaskReader *reader)
{
    YkFunctionTask *f = &reader->task->function;
    const YkNode *samples = yk_node_get(reader->loader->root, "samples");
    size_t errors = yk_problems_error_count(reader->loader->problems);
    bool is_count = reader->samples == 3 || reader->samples == 4 || reader->samples == 5;
    if (samples && !isnan(reader->samples) && !is_count)
        yk_problem(reader->loader->problems, YK_CODE_TASK_POSITIONS, samples->place,
                   "a machine meets 3, 4 or 5 points of a function exactly");
    if (f->evened && (!f->of || reader->samples < 5)) {
        yk_problem(reader->loader->problems, YK_CODE_TASK_EVENED, yk_node_get(reader->loader->root, "evened")->place,
                   "errors are evened out between five points of a formula");
        yk_problem_hint(reader->loader->problems,
                        f->of ? "write `samples: 5`" : "give `of` and `x` in place of `pairs`");
    }
    if (f->of) check_ranges(reader);
    if (!f->of && f->count > 0) check_pairs(reader);
    check_sizes(reader);
    size_t points = !f->of ? f->count : is_count ? (size_t)reader->samples : 0;
    if (points >= 3) check_starts(reader, points);
    if (!f->of || !is_count) return;
    f->count = (size_t)reader->samples;
    if (errors == 0 && yk_problems_error_count(reader->loader->problems) == 0) take_samples(reader);
}
