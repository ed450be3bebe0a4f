// Parameters of an existing machine, varied so that it meets goals; each answer is judged on its file.
#include <math.h>
#include <string.h>
#include "base/number.h"
#include "synthesis/machines/machine_fit.h"
#include "synthesis/synthesis.h"
#include <yoke/builder.h>
#include <yoke/move.h>

enum { KEPT = 40 };

typedef struct Search {
    YkSynthesis *s;
    YkMachineFit fit;
    YkMachineTry pool[KEPT]; // that passed, best first
    size_t pooled, most;
    double *numbers; // of a piece
} Search;

// Reads a model. Returns YK_OK, YK_BAD_MODEL or YK_NO_MEMORY.
static YkStatus parse(const char *text, size_t length, const YkLoadOptions *options, YkModel **model)
{
    YkProblems *problems = yk_problems_new();
    YkStatus status = YK_BAD_MODEL;
    *model = problems ? yk_model_parse(text, length, "machine", options, problems) : NULL;
    for (size_t k = 0; problems && k < yk_problems_count(problems); k++)
        if (yk_problems_get(problems, k)->code == YK_CODE_OUT_OF_MEMORY) status = YK_NO_MEMORY;
    yk_problems_free(problems);
    return *model ? YK_OK : problems ? status : YK_NO_MEMORY;
}

// Writes a model's text with its start's pose under `start:`, so that it assembles as the search moved it.
static bool write_start(YkMachineFit *fit, const double *value, const char *source, YkText *text)
{
    const YkModel *model = fit->task->machine.model;
    double at[YK_STARTS_MAX];
    YkOverride start[YK_STARTS_MAX];
    char digits[YK_STARTS_MAX][YK_NUMBER_SIZE + 4];
    if (fit->start_count == 0 || !yk_machine_start(fit, value, at)) return false;
    for (size_t k = 0; k < fit->start_count; k++) {
        const YkCoordinate *c = &model->coordinates[model->starts[fit->start[k]].coordinate];
        size_t length = yk_number_write_digits(at[k], 6, digits[k]);
        memcpy(digits[k] + length, c->is_distance ? " m" : " rad", c->is_distance ? 3 : 5);
        start[k] = (YkOverride){c->name, digits[k]};
    }
    return yk_source_replace(source, "start", start, fit->start_count, text);
}

// Writes the machine's file with these values, in the units that it gives them.
static YkStatus write_model(YkMachineFit *fit, const double *value, YkText *text)
{
    const YkMachineTask *machine = &fit->task->machine;
    YkOverride parameters[YK_FREE_MAX];
    char digits[YK_FREE_MAX][YK_NUMBER_SIZE];
    for (size_t k = 0; k < machine->free_count; k++) {
        double unit = yk_model_parameter_unit(machine->model, machine->name[k]);
        digits[k][yk_number_write_digits(value[k] / unit, 15, digits[k])] = '\0';
        parameters[k] = (YkOverride){machine->name[k], digits[k]};
    }
    YkLoadOptions options = yk_default_load_options();
    options.parameters = parameters;
    options.parameter_count = machine->free_count;
    YkModel *model;
    YkText started = {0};
    YkStatus status = parse(machine->model->source, machine->model->source_length, &options, &model);
    yk_text_clear(text);
    yk_text_puts(text, "# Found by `yoke synthesize` for a task of the kind machine.\n");
    bool is_started = model && write_start(fit, value, yk_model_text(model), &started);
    if (model) yk_text_puts(text, is_started ? yk_text_get(&started) : yk_model_text(model));
    if (started.failed) text->failed = true;
    yk_text_free(&started);
    yk_model_free(model);
    return text->failed ? YK_NO_MEMORY : status;
}

// A machine read back from its file.
typedef struct Standing {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
    YkDynamics *dynamics;
    YkSweep *sweep;
} Standing;

static YkStatus stand(const YkMachineTask *machine, const char *text, Standing *t)
{
    const char *coordinate = yk_coordinate_info(machine->mech, machine->coordinate).name;
    YkCompileOptions options = yk_default_compile_options();
    options.inputs = &coordinate;
    options.input_count = 1;
    YkStatus status = parse(text, strlen(text), NULL, &t->model);
    if (status < 0) return status;
    t->mech = yk_mechanism_compile(t->model, &options, NULL);
    t->state = t->mech ? yk_state_new(t->mech) : NULL;
    t->dynamics = t->mech ? yk_dynamics_new(t->mech, NULL) : NULL;
    if (!t->state || !t->dynamics) return YK_NO_MEMORY;
    for (size_t i = 0; i < yk_input_count(t->mech); i++)
        yk_dynamics_prescribe(t->dynamics, i, true); // as the batch does
    status = yk_state_set_time(t->state, 0, NULL);
    return status < 0 ? status : yk_state_assemble(t->state);
}

// Drives it through the range.
static YkStatus sweep(const YkMachineTask *machine, Standing *t)
{
    YkSweepOptions options = yk_default_sweep_options();
    YkMotion goal[YK_FREE_MAX];
    size_t inputs = yk_input_count(t->mech);
    if (inputs > YK_FREE_MAX) return YK_BAD_ARGUMENT;
    for (size_t i = 0; i < inputs; i++) goal[i] = yk_state_coordinate(t->state, yk_input_coordinate(t->mech, i));
    goal[0].position = machine->over.low;
    YkStatus status = yk_state_move_to(t->state, goal, NULL, NULL);
    if (status < 0) return status;
    options.coordinate = (int)yk_input_coordinate(t->mech, 0);
    options.from = machine->over.low;
    options.to = machine->over.high;
    options.steps = machine->steps;
    options.dynamics = t->dynamics;
    t->sweep = yk_sweep_run(t->state, &options, machine->channel, machine->channel_count, NULL);
    return t->sweep ? yk_sweep_status(t->sweep) : YK_NO_MEMORY;
}

// The curve of the first point that has points to pass.
static void take_curve(const Search *search, YkVerdict *verdict)
{
    const YkMachineTask *machine = &search->fit.task->machine;
    const YkMachineFit *fit = &search->fit;
    const YkGoal *goal = NULL;
    for (size_t k = 0; k < machine->goal_count && !goal; k++)
        if (machine->goal[k].kind == YK_GOAL_THROUGH) goal = &machine->goal[k];
    size_t stride = (fit->rows + YK_CURVE_ROWS - 1) / YK_CURVE_ROWS;
    for (size_t r = 0; goal && r < fit->rows; r += stride) {
        verdict->curve[2 * verdict->rows] = fit->value[goal->channel[0]][r];
        verdict->curve[2 * verdict->rows++ + 1] = fit->value[goal->channel[1]][r];
    }
}

// Judges a try by its file. Its error becomes what the engine measured.
static YkDefect judge(Search *search, YkMachineTry *try, YkText *text, YkVerdict *verdict)
{
    YkMachineFit *fit = &search->fit;
    const YkMachineTask *machine = &fit->task->machine;
    Standing t = {0};
    YkMachineTry again = *try;
    YkDefect defect = YK_DEFECT_NONE;
    YkStatus status = write_model(fit, try->value, text);
    if (status >= 0) status = stand(machine, yk_text_get(text), &t);
    if (status < 0) defect = YK_DEFECT_ASSEMBLY;
    if (status >= 0 && (status = sweep(machine, &t)) < 0) defect = YK_DEFECT_BRANCH;
    if (defect == YK_DEFECT_NONE) {
        for (size_t r = 0; r < fit->rows; r++)
            for (size_t c = 0; c < machine->channel_count; c++) fit->value[c][r] = yk_sweep_value(t.sweep, r, c);
        yk_machine_judge(fit, fit->value, fit->next_miss, &again);
        double room =
            1e-6 * (fabs(try->error) + yk_mechanism_size(machine->mech) * yk_mechanism_size(machine->mech) * 1e-6);
        if (!(fabs(again.error - try->error) <= room)) defect = YK_DEFECT_ASSEMBLY; // another configuration
        if (defect == YK_DEFECT_NONE && again.lack > 0) defect = YK_DEFECT_REQUIRE;
        if (defect == YK_DEFECT_NONE) take_curve(search, verdict);
    }
    if (status == YK_NO_MEMORY) search->s->failed = true;
    verdict->defect = defect;
    verdict->error = try->error = again.error;
    verdict->worst = try->worst = again.worst;
    yk_sweep_free(t.sweep);
    yk_dynamics_free(t.dynamics);
    yk_state_free(t.state);
    yk_mechanism_free(t.mech);
    yk_model_free(t.model);
    return defect;
}

static bool is_known(const Search *search, const YkMachineTry *try)
{
    const YkMachineTask *machine = &search->fit.task->machine;
    for (size_t k = 0; k < search->pooled; k++) {
        double apart = 0;
        for (size_t j = 0; j < machine->free_count; j++)
            apart = fmax(apart, fabs(search->pool[k].value[j] - try->value[j]) /
                                    (machine->range[j].high - machine->range[j].low));
        if (apart < 1e-3) return true;
    }
    return false;
}

static void take(Search *search, YkMachineTry *try)
{
    YkSynthesis *s = search->s;
    size_t n = search->fit.task->machine.free_count;
    YkDesign none = {.dyad = {-1, -1}};
    YkVerdict verdict = {.defect = YK_DEFECT_NONE};
    YkText text = {0};
    bool is_full = search->pooled == search->most && !(try->error < search->pool[search->most - 1].error);
    if (is_full || is_known(search, try)) return;
    YkDefect defect = try->lack > 0 ? YK_DEFECT_REQUIRE : judge(search, try, &text, &verdict);
    if (defect != YK_DEFECT_NONE) {
        yk_synthesis_leave(s, &none, defect, &verdict);
    } else {
        YkFound *found = yk_synthesis_keep(s, &none, &text, &verdict, -verdict.error);
        double *value = found ? YK_NEW(s->arena, double, n) : NULL;
        if (value) memcpy(value, try->value, n * sizeof *value);
        if (found) found->value = value;
        size_t k = search->pooled < search->most ? search->pooled++ : search->most - 1;
        for (; k > 0 && try->error < search->pool[k - 1].error; k--) search->pool[k] = search->pool[k - 1];
        search->pool[k] = *try;
    }
    yk_text_free(&text);
}

// Finds the best try of a batch, here or wherever its piece comes from. Returns whether there is any.
static bool find_batch(Search *search, size_t batch, YkMachineTry *best)
{
    double *numbers = search->numbers;
    if (!search->s->options.pieces.get) return yk_machine_batch(&search->fit, search->s->options.seed, batch, best);
    return yk_synthesis_fetch(search->s, batch, numbers) && yk_machine_unpack(search->fit.task, numbers, best);
}

// Keeps the curve of the machine as its file gives it, to be drawn beside those that are found.
static void keep_own(Search *search)
{
    const YkMachineTask *machine = &search->fit.task->machine;
    YkMachineTry own = {.cost = INFINITY};
    YkVerdict verdict = {.rows = 0};
    for (size_t j = 0; j < machine->free_count; j++)
        own.value[j] = yk_model_parameter(machine->model, machine->name[j]);
    if (!yk_machine_measure(&search->fit, search->fit.miss, &own)) return;
    take_curve(search, &verdict);
    double *curve = YK_NEW(search->s->arena, double, 2 * verdict.rows + 1);
    if (!curve) return;
    memcpy(curve, verdict.curve, 2 * verdict.rows * sizeof *curve);
    search->s->own = curve;
    search->s->own_rows = verdict.rows;
}

bool yk_synthesise_machine(YkSynthesis *s, YkProblems *problems)
{
    Search *search = YK_NEW(s->arena, Search, 1);
    double *numbers = YK_NEW(s->arena, double, yk_machine_width(s->task));
    if (!search || !numbers) return true;
    *search = (Search){.s = s, .numbers = numbers};
    size_t best = s->options.best > 0 ? s->options.best : s->task->best;
    search->most = best < KEPT ? best : KEPT;
    bool good = yk_machine_fit_new(s->task, s->arena, &search->fit, problems);
    search->fit.pace = &s->pace;
    if (good) keep_own(search);
    for (size_t k = 0; good && k < YK_MACHINE_BATCHES; k++) {
        YkMachineTry try;
        yk_pace_reach(&s->pace, (double)k / YK_MACHINE_BATCHES);
        if (!yk_synthesis_goes_on(s, yk_machine_batch_work(s->task))) break;
        if (find_batch(search, k, &try)) take(search, &try);
    }
    yk_machine_fit_free(&search->fit);
    return good;
}
