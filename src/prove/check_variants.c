// Machines with other numbers: parameters move a little away from the file's values, in small steps, so that the
// machine keeps its assembly.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/mix.h"
#include "base/problems.h"
#include "compile/variant.h"
#include "derive/blocks.h"
#include "derive/inside.h"
#include "elementary/elementary.h"
#include "model/redesign.h"
#include "prove/check_inside.h"
#include "solve/state.h"

enum { STEPS = 8, WALKED = 300 }; // WALKED: work for each step of solution
static const double BESIDE = 0.12, CLOSED = 1e-7;

// --- Which parameters can vary

static bool is_free(const YkModel *model, size_t parameter)
{
    return !yk_expr_has_names(model->parameters[parameter].expr) && isfinite(model->parameters[parameter].value);
}

// Problems of machines that cannot be made are forgotten, unless memory ran out.
static void forget(YkCheck *check, YkProblems *said)
{
    check->failed |= !said || yk_problems_ran_out(said);
    yk_problems_free(said);
}

static bool can_vary(YkCheck *check, const char *name)
{
    YkProblems *said = yk_problems_new();
    YkRedesign *redesign = said ? yk_redesign_new(check->d->mech->model, &name, 1, said) : NULL;
    yk_redesign_free(redesign);
    forget(check, said);
    return redesign != NULL;
}

// A variant for which a place is assumed to stay 0, or to cancel, is not a machine with these numbers.
static bool is_faithful(const YkVariant *variant)
{
    return variant && !variant->is_of_file;
}

static YkVariant *vary(YkCheck *check, const char *const *names, size_t count)
{
    YkProblems *said = yk_problems_new();
    YkVariant *variant = said ? yk_variant_new(check->d->mech, names, count, said) : NULL;
    forget(check, said);
    return variant;
}

static bool is_faithful_alone(YkCheck *check, const char *name)
{
    YkVariant *variant = vary(check, &name, 1);
    bool is = is_faithful(variant);
    yk_variant_free(variant);
    return is;
}

static YkVariant *new_variant(const YkCheckVariants *v)
{
    YkVariant *variant = v->count > 0 ? vary(v->check, v->name, v->count) : NULL;
    if (is_faithful(variant)) return variant;
    yk_variant_free(variant);
    return NULL;
}

static void keep_faithful(YkCheckVariants *v)
{
    size_t kept = 0;
    for (size_t k = 0; k < v->count; k++)
        if (is_faithful_alone(v->check, v->name[k])) v->name[kept++] = v->name[k];
    v->count = kept;
}

static bool is_among(const YkCheckVariants *v, const char *name)
{
    for (size_t k = 0; k < v->count; k++)
        if (v->name[k] == name) return true;
    return false;
}

const char *yk_check_list_names(const YkCheckVariants *v, YkArena *arena, bool varied)
{
    const YkModel *model = v->check->d->model;
    YkText text = {0};
    for (size_t k = 0; k < model->parameter_count; k++)
        if (is_free(model, k) && is_among(v, model->parameters[k].name) == varied)
            yk_text_format(&text, "%s%s", text.length ? ", " : "", model->parameters[k].name);
    const char *list = text.length || text.failed ? yk_arena_copy(arena, yk_text_get(&text), text.length) : NULL;
    yk_text_free(&text);
    return list;
}

// --- A machine

// Rounds to three digits, so that a user can type it.
static double short_number(double value)
{
    if (value == 0) return 0;
    double digit = yk_pow(10, floor(yk_log10(fabs(value))) - 2);
    return round(value / digit) * digit;
}

static double size_of(const YkCheckVariants *v, const char *name)
{
    const YkModel *model = v->check->d->model;
    int32_t index = yk_names_find(&model->parameter_names, name);
    YkDimension of = model->parameters[index].dimension;
    bool is_length = of.length == 1 && of.mass == 0 && of.time == 0;
    return is_length ? 0.5 * v->check->d->mech->size : 1;
}

static void choose_target(YkCheckVariants *v, double *target)
{
    for (size_t k = 0; k < v->count; k++) {
        double by = v->reach * (2 * yk_mix_unit(&v->seed) - 1), own = v->own[k];
        by += by < 0 ? -0.2 * v->reach : 0.2 * v->reach;
        target[k] = short_number(own != 0 ? own * (1 + by) : size_of(v, v->name[k]) * by);
    }
}

// Moves from the file's machine to that of the target, with the inputs of the start.
static bool walk(const YkCheckVariants *v, YkCheckMachine *m)
{
    yk_state_take(m->state, v->check->start);
    for (int step = 0; step <= STEPS; step++) {
        for (size_t k = 0; k < v->count; k++)
            v->value[k] = step == STEPS ? m->target[k] : v->own[k] + (m->target[k] - v->own[k]) * step / STEPS;
        YkStatus status = yk_variant_set(m->variant, v->value);
        v->check->failed |= status == YK_NO_MEMORY;
        if (!yk_ring_spend(v->check->d->ring, WALKED * (m->state->mech->step_count + 1))) return false;
        if (status < 0 || yk_state_solve(m->state) < 0) return false;
        yk_state_refer(m->state);
    }
    return true;
}

// Returns whether its start is a pose of the machine that the symbols describe.
static bool closes(const YkCheckMachine *m)
{
    const YkDeriveBlocks *blocks = yk_derive_blocks(m->d);
    yk_derive_body_angle(m->d, 0);
    double *values = yk_derive_scratch(m->d, yk_ring_symbol_count(m->d->ring) + 1, sizeof *values);
    bool does = blocks && values;
    if (does) yk_derive_values(m->d, m->state, m->dynamics, values);
    for (size_t r = 0; does && r < blocks->row_count; r++) {
        double size = yk_ring_magnitude(m->d->ring, blocks->rows[r].value, values);
        does = yk_norm(yk_ring_value(m->d->ring, blocks->rows[r].value, values)) <= CLOSED * fmax(size, 1e-9);
    }
    free(values);
    return does;
}

static YkDynamics *dynamics_like(const YkDynamics *own, const YkMechanism *mech)
{
    YkDynamics *dynamics = own ? yk_dynamics_new(mech, NULL) : NULL; // fails only when out of memory
    for (size_t i = 0; dynamics && i < mech->input_count; i++)
        yk_dynamics_prescribe(dynamics, i, yk_dynamics_is_prescribed(own, i));
    return dynamics;
}

// Forgets the machine, but not its variant.
static void clear(YkCheckMachine *m)
{
    yk_check_free_poses(&m->poses);
    yk_derivation_free(m->d);
    yk_dynamics_free(m->dynamics);
    m->d = NULL, m->dynamics = NULL;
    m->is_machine = false;
}

static bool make_room_for(YkCheckVariants *v, YkCheckMachine *m)
{
    if (!m->target) m->target = yk_derive_scratch(v->check->d, v->count + 1, sizeof *m->target);
    if (!m->variant) m->variant = new_variant(v);
    const YkMechanism *mech = m->variant ? yk_variant_mechanism(m->variant) : NULL;
    if (!m->state && mech) m->state = yk_state_new(mech);
    if (!m->here && mech) m->here = yk_state_new(mech);
    v->check->failed |= mech && (!m->state || !m->here);
    return m->target && m->state && m->here;
}

// Assembles the machine of the target.
static void stand(const YkCheckVariants *v, YkCheckMachine *m)
{
    const YkMechanism *mech = yk_variant_mechanism(m->variant);
    if (!walk(v, m)) return;
    m->dynamics = dynamics_like(v->check->dynamics, mech);
    YkProblems *said = yk_problems_new();
    m->d = said ? yk_derivation_new(mech->model, mech, said) : NULL;
    forget(v->check, said);
    if (m->d) yk_ring_set_pace(m->d->ring, &v->check->d->pace);
    v->check->failed |= v->check->dynamics && !m->dynamics;
    m->poses.seed = m->seed;
    m->is_machine = m->d && (m->dynamics || !v->check->dynamics) && closes(m);
    v->check->failed |= m->d && yk_derivation_ran_out(m->d);
}

// --- For all equations

static void free_machine(YkCheckMachine *m)
{
    clear(m);
    yk_state_free(m->state);
    yk_state_free(m->here);
    yk_variant_free(m->variant);
    free(m->target);
}

void yk_check_free_variants(YkCheckVariants *v)
{
    if (!v) return;
    for (size_t k = 0; k < v->machine_count; k++) free_machine(&v->machine[k]);
    free_machine(&v->other);
    free((void *)v->name);
    free(v->own);
    free(v);
}

static void choose_names(YkCheckVariants *v)
{
    const YkModel *model = v->check->d->model;
    for (size_t k = 0; k < model->parameter_count; k++)
        if (is_free(model, k) && can_vary(v->check, model->parameters[k].name))
            v->name[v->count++] = model->parameters[k].name;
}

static YkCheckVariants *begin(YkCheck *check)
{
    enum { SEED = 77 };
    size_t n = check->d->model->parameter_count;
    YkCheckVariants *v = yk_derive_scratch(check->d, 1, sizeof *v);
    if (!v) return NULL;
    *v = (YkCheckVariants){.check = check, .seed = SEED, .reach = BESIDE};
    v->name = (const char **)yk_derive_scratch(check->d, n + 1, sizeof *v->name);
    v->own = yk_derive_scratch(check->d, 2 * n + 1, sizeof *v->own);
    if (!v->name || !v->own) return v;
    v->value = v->own + n;
    choose_names(v);
    v->other.variant = new_variant(v);
    if (!v->other.variant) keep_faithful(v);
    if (!v->other.variant) v->other.variant = new_variant(v);
    for (size_t k = 0; k < v->count; k++) v->own[k] = yk_model_parameter(check->d->model, v->name[k]);
    v->is_started = v->other.variant != NULL;
    return v;
}

YkCheckVariants *yk_check_variants(YkCheck *check)
{
    YkCheckShared *shared = check->shared;
    if (!shared->variants) shared->variants = begin(check);
    if (!shared->variants || !shared->variants->is_started) return NULL;
    shared->variants->check = check;
    return shared->variants;
}

YkCheckMachine *yk_check_machine(YkCheckVariants *v, size_t index)
{
    if (index >= YK_CHECK_MACHINES_TRIED) return NULL;
    while (v->machine_count <= index) {
        YkCheckMachine *m = &v->machine[v->machine_count++];
        if (!make_room_for(v, m)) continue;
        choose_target(v, m->target);
        m->seed = v->seed;
        stand(v, m);
        if (!m->is_machine) v->reach /= 2;
    }
    return &v->machine[index];
}

YkCheckMachine *yk_check_machine_at(YkCheckVariants *v, const double *target, uint64_t seed)
{
    YkCheckMachine *m = &v->other;
    clear(m);
    if (!make_room_for(v, m)) return m;
    memcpy(m->target, target, v->count * sizeof *target);
    m->seed = seed;
    stand(v, m);
    return m;
}
