// Does an equation hold with other dimensions, too? Asked of the numeric engine: parameters of the file go a little
// beside their values, in small steps, so that the machine stays assembled as it is.
#include <math.h>
#include <stdlib.h>
#include <yoke/variant.h>
#include "compile/variant.h"
#include "derive/blocks.h"
#include "derive/check_inside.h"
#include "model/redesign.h"
#include "solve/state.h"

enum { STEPS = 8, ATTEMPTS = 4, SHOWN_ONE_BY_ONE = 16 };
static const double BESIDE = 0.12, CLOSED = 1e-7;

typedef struct Trial {
    YkCheck *check; // of the file's machine
    YkCheckVerdict *verdict;
    YkVariant *variant;
    const char **name; // parameters that vary: [count]
    double *own, *target, *value;
    size_t count;
    YkState *state; // of the variant
} Trial;

// --- Which parameters can vary

static void note_name(void *context, const YkExpr *name)
{
    (void)name;
    *(bool *)context = true;
}

static bool is_free(const YkModel *model, size_t parameter)
{
    bool follows = false;
    yk_expr_names(model->parameters[parameter].expr, note_name, &follows);
    return !follows && isfinite(model->parameters[parameter].value);
}

static bool can_vary(const YkMechanism *mech, const char *name)
{
    YkRedesign *redesign = yk_redesign_new(mech->model, &name, 1, NULL);
    yk_redesign_free(redesign);
    return redesign != NULL;
}

// Where what is 0 or cancels in the file is taken to stay so, a variant is no machine of these numbers.
static bool is_faithful(const YkVariant *variant)
{
    return variant && !variant->is_of_file;
}

static bool is_faithful_alone(const YkMechanism *mech, const char *name)
{
    YkVariant *variant = yk_variant_new(mech, &name, 1, NULL);
    bool is = is_faithful(variant);
    yk_variant_free(variant);
    return is;
}

static bool start_variant(Trial *t)
{
    t->variant = t->count > 0 ? yk_variant_new(t->check->d->mech, t->name, t->count, NULL) : NULL;
    if (is_faithful(t->variant)) return true;
    yk_variant_free(t->variant);
    t->variant = NULL;
    return false;
}

static void keep_faithful(Trial *t)
{
    size_t kept = 0;
    for (size_t k = 0; k < t->count; k++)
        if (is_faithful_alone(t->check->d->mech, t->name[k])) t->name[kept++] = t->name[k];
    t->count = kept;
}

static bool is_among(const Trial *t, const char *name)
{
    for (size_t k = 0; k < t->count; k++)
        if (t->name[k] == name) return true;
    return false;
}

static const char *list_names(Trial *t, bool varied)
{
    const YkModel *model = t->check->d->model;
    YkText text = {0};
    for (size_t k = 0; k < model->parameter_count; k++)
        if (is_free(model, k) && is_among(t, model->parameters[k].name) == varied)
            yk_text_format(&text, "%s%s", text.length ? ", " : "", model->parameters[k].name);
    YkArena *arena = t->check->d->arena;
    const char *list = text.length && !text.failed ? yk_arena_copy(arena, yk_text_get(&text), text.length) : NULL;
    yk_text_free(&text);
    return list;
}

// --- A machine

static double uniform(uint64_t *seed) // splitmix64 (Steele et al. 2014), in [-1, 1)
{
    uint64_t z = (*seed += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
}

// To three digits: whoever wants to see it can write it.
static double short_number(double value)
{
    if (value == 0) return 0;
    double digit = pow(10, floor(log10(fabs(value))) - 2);
    return round(value / digit) * digit;
}

static double size_of(const Trial *t, const char *name)
{
    const YkModel *model = t->check->d->model;
    int32_t index = yk_names_find(&model->parameter_names, name);
    YkDimension of = model->parameters[index].dimension;
    bool is_length = of.length == 1 && of.mass == 0 && of.time == 0;
    return is_length ? 0.5 * t->check->d->mech->size : 1;
}

static void choose_target(Trial *t, double reach, uint64_t *seed)
{
    for (size_t k = 0; k < t->count; k++) {
        double by = reach * uniform(seed), own = t->own[k];
        by += by < 0 ? -0.2 * reach : 0.2 * reach;
        t->target[k] = short_number(own != 0 ? own * (1 + by) : size_of(t, t->name[k]) * by);
    }
}

// From the file's machine to that of the target, with the inputs of the start.
static bool walk(Trial *t)
{
    yk_state_take(t->state, t->check->start);
    for (int step = 0; step <= STEPS; step++) {
        for (size_t k = 0; k < t->count; k++)
            t->value[k] = step == STEPS ? t->target[k] : t->own[k] + (t->target[k] - t->own[k]) * step / STEPS;
        if (yk_variant_set(t->variant, t->value) < 0 || yk_state_solve(t->state) < 0) return false;
        yk_state_refer(t->state);
    }
    return true;
}

// Is this pose one of the machine that the symbols describe?
static bool closes(YkCheck *check)
{
    const YkDeriveBlocks *blocks = yk_derive_blocks(check->d);
    yk_check_fill_values(check);
    for (size_t r = 0; blocks && r < blocks->row_count; r++) {
        double size = yk_ring_magnitude(check->d->ring, blocks->rows[r].value, check->values);
        if (yk_norm(yk_ring_value(check->d->ring, blocks->rows[r].value, check->values)) > CLOSED * fmax(size, 1e-9))
            return false;
    }
    return blocks != NULL;
}

static YkDynamics *dynamics_like(const YkDynamics *own, const YkMechanism *mech)
{
    YkDynamics *dynamics = own ? yk_dynamics_new(mech, NULL) : NULL;
    for (size_t i = 0; dynamics && i < mech->input_count; i++)
        yk_dynamics_prescribe(dynamics, i, yk_dynamics_is_prescribed(own, i));
    return dynamics;
}

// Compares both sides at poses of the machine on which the variant stands. shown: where they differ; may be NULL.
typedef struct Outcome {
    bool is_machine, differs;
    size_t poses;
} Outcome;

static Outcome judge_machine(Trial *t, uint64_t seed, YkCheckShown *shown)
{
    Outcome outcome = {0};
    const YkCheck *own = t->check;
    const YkMechanism *mech = yk_variant_mechanism(t->variant);
    YkCheck there = {.text = own->text, .length = own->length, .seed = seed, .state = t->state, .seen = own->seen};
    there.dynamics = dynamics_like(own->dynamics, mech);
    there.d = yk_derivation_new(mech->model, mech, NULL);
    bool is_ready = there.d && (there.dynamics || !own->dynamics) &&
                    yk_check_open(&there, (YkPlace){1, 1, 0}, NULL) == YK_CHECK_OPEN;
    outcome.is_machine = is_ready && closes(&there);
    if (outcome.is_machine) outcome.differs = yk_check_differs(&there, YK_CHECK_MACHINE_POSES, &outcome.poses);
    if (outcome.differs && shown) yk_check_show(&there, own->d->arena, shown);
    yk_check_close(&there);
    yk_derivation_free(there.d);
    yk_dynamics_free(there.dynamics);
    return outcome;
}

// --- One at which it does not hold

// "a = 0.053, b = 0.21": the parameters that are not the file's.
static const char *name_machine(Trial *t)
{
    YkText text = {0};
    for (size_t k = 0; k < t->count; k++)
        if (t->target[k] != t->own[k])
            yk_text_format(&text, "%s%s = %e", text.length ? ", " : "", t->name[k], t->target[k]);
    YkArena *arena = t->check->d->arena;
    const char *words = text.failed ? NULL : yk_arena_copy(arena, yk_text_get(&text), text.length);
    yk_text_free(&text);
    return words;
}

// As few parameters beside the file's as show it.
static void simplify(Trial *t, uint64_t seed)
{
    YkCheckShown shown = {0};
    for (size_t k = 0; k < t->count && t->count <= SHOWN_ONE_BY_ONE; k++) {
        double target = t->target[k];
        t->target[k] = t->own[k];
        Outcome outcome = walk(t) ? judge_machine(t, seed, &shown) : (Outcome){0};
        if (outcome.differs)
            t->verdict->shown = shown;
        else
            t->target[k] = target;
    }
    t->verdict->shown.machine = name_machine(t);
}

static void try_machines(Trial *t)
{
    uint64_t seed = 77;
    double reach = BESIDE;
    for (int attempt = 0; attempt < ATTEMPTS + YK_CHECK_MACHINES; attempt++) {
        if (t->verdict->machines == YK_CHECK_MACHINES || t->verdict->is_false_there) return;
        choose_target(t, reach, &seed);
        Outcome outcome = walk(t) ? judge_machine(t, seed, &t->verdict->shown) : (Outcome){0};
        t->verdict->machines += outcome.is_machine && outcome.poses > 0;
        t->verdict->machine_poses += outcome.poses;
        t->verdict->is_false_there = outcome.differs;
        if (outcome.differs) simplify(t, seed);
        if (!outcome.is_machine) reach /= 2;
    }
}

static bool make_room(Trial *t)
{
    size_t n = t->check->d->model->parameter_count;
    t->name = (const char **)calloc(n + 1, sizeof *t->name);
    t->own = calloc(3 * n + 1, sizeof *t->own);
    if (!t->name || !t->own) return false;
    t->target = t->own + n, t->value = t->target + n;
    return true;
}

static void choose_names(Trial *t)
{
    const YkModel *model = t->check->d->model;
    for (size_t k = 0; k < model->parameter_count; k++)
        if (is_free(model, k) && can_vary(t->check->d->mech, model->parameters[k].name))
            t->name[t->count++] = model->parameters[k].name;
}

void yk_check_machines(YkCheck *check, YkCheckVerdict *verdict)
{
    Trial t = {.check = check, .verdict = verdict};
    if (make_room(&t)) {
        choose_names(&t);
        bool is_started = start_variant(&t);
        if (!is_started) keep_faithful(&t);
        if (!is_started) is_started = start_variant(&t);
        for (size_t k = 0; k < t.count; k++) t.own[k] = yk_model_parameter(check->d->model, t.name[k]);
        if (is_started) t.state = yk_state_new(yk_variant_mechanism(t.variant));
        if (t.state) try_machines(&t);
    }
    if (verdict->machines > 0) verdict->varied = list_names(&t, true), verdict->kept = list_names(&t, false);
    yk_state_free(t.state);
    yk_variant_free(t.variant);
    free((void *)t.name);
    free(t.own);
}
