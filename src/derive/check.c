// The verdict on an equation: identity, proof on the loops, many poses.
#include <stdlib.h>
#include "derive/blocks.h"
#include "derive/check_inside.h"
#include "derive/frame.h"
#include "derive/free_bodies.h"
#include "derive/gears.h"

enum { POSES_MIN = 8 };

static bool is_identity(YkCheck *check)
{
    return yk_form_compare(check->d->ring, check->equation->left, check->equation->right, YK_CHECK_POINTS, 17) ==
           YK_FORM_EQUAL;
}

// --- What a false equation is shown with

// Highest derivatives of coordinates and names of forces that a form speaks of.
static void look_into(YkCheck *check, const YkForm *form, YkCheckVerdict *verdict, bool *is_named)
{
    YkRing *ring = check->d->ring;
    const YkPoisson *a = yk_form_element(form);
    for (size_t k = 0; !a && k < yk_form_part_count(form); k++)
        look_into(check, yk_form_part(form, k), verdict, is_named);
    for (int32_t s = a ? yk_ring_next_symbol(ring, a, -1) : -1; s >= 0; s = yk_ring_next_symbol(ring, a, s)) {
        YkRingClass kind = yk_ring_symbol_class(ring, s);
        int order = kind == YK_RING_RATE ? 1 : kind == YK_RING_ACCELERATION ? 2 : 0;
        if (order > verdict->order) verdict->order = order;
        is_named[s] = true;
    }
}

// "F12x = 3.25, M03 = -0.5": the unknown forces of the equation.
static const char *list_forces(YkCheck *check, const bool *is_named)
{
    const YkDerivation *d = check->d;
    YkText text = {0};
    for (size_t k = 0; k < d->unknown_count; k++)
        if (is_named[d->unknowns[k]])
            yk_text_format(&text, "%s%s = %e", text.length ? ", " : "", yk_ring_symbol_name(d->ring, d->unknowns[k]),
                           check->values[d->unknowns[k]]);
    const char *list = text.length && !text.failed ? yk_arena_copy(d->arena, yk_text_get(&text), text.length) : NULL;
    yk_text_free(&text);
    return list;
}

static void show(YkCheck *check, YkCheckVerdict *verdict)
{
    YkRing *ring = check->d->ring;
    bool *is_named = calloc(yk_ring_symbol_count(ring) + 1, sizeof *is_named);
    yk_check_fill_values(check);
    verdict->left = yk_form_value(ring, check->equation->left, check->values).x;
    verdict->right = yk_form_value(ring, check->equation->right, check->values).x;
    if (!is_named) return;
    look_into(check, check->equation->left, verdict, is_named);
    look_into(check, check->equation->right, verdict, is_named);
    verdict->forces = list_forces(check, is_named);
    free(is_named);
}

static void decide(YkCheck *check, YkCheckVerdict *verdict)
{
    verdict->is_identity = is_identity(check);
    YkProof proof = verdict->is_identity ? YK_PROVED : yk_check_prove(check, check->difference);
    bool differs = !verdict->is_identity && yk_check_differs(check, &verdict->poses);
    if (differs) {
        verdict->kind = proof == YK_PROVED ? YK_CHECK_UNDECIDED : YK_CHECK_FALSE;
        if (verdict->kind == YK_CHECK_UNDECIDED) return;
        verdict->slip = yk_check_slip(check);
        if (!verdict->slip && yk_check_holds_in_drive(check))
            verdict->slip = "it holds as the drives move the machine; here inputs may move in any way";
        show(check, verdict);
    } else if (proof == YK_PROVED) {
        verdict->kind = YK_CHECK_TRUE;
    } else {
        verdict->kind = verdict->poses >= POSES_MIN ? YK_CHECK_TRUE_HERE : YK_CHECK_UNDECIDED;
        verdict->is_for_these_numbers = proof == YK_NO_PROOF;
    }
}

YkCheckVerdict yk_derive_check(YkDerivation *d, YkState *state, YkDynamics *dynamics, const char *text, size_t length,
                               YkPlace place, YkProblems *problems)
{
    YkEquation equation;
    YkCheckVerdict verdict = {.kind = YK_CHECK_UNREADABLE};
    if (!yk_derive_blocks(d) || !yk_derive_enter_forces(d)) {
        yk_problem(problems, YK_CODE_DERIVATION, (YkPlace){0}, "the machine cannot be written in symbols: %s",
                   yk_ring_status_text(yk_ring_status(d->ring)));
        return verdict;
    }
    yk_derive_train(d); // omega1, ...: names of speeds
    yk_derive_enter_names(d);
    if (!yk_equation_read(d, text, length, place, problems, &equation)) return verdict;
    YkCheck check = {.d = d,
                     .state = state,
                     .dynamics = dynamics,
                     .equation = &equation,
                     .text = text,
                     .length = length,
                     .seed = 2024};
    check.difference = yk_form_subtract(d->ring, equation.left, equation.right);
    for (size_t k = 0; k < d->model->parameter_count; k++)
        yk_derive_definition(d, k); // enters all symbols there will be
    yk_derive_body_angle(d, 0);
    check.values = calloc(yk_ring_symbol_count(d->ring) + 64, sizeof *check.values);
    verdict.kind = YK_CHECK_UNDECIDED;
    check.start = yk_state_new(d->mech);
    bool is_ready = check.values && check.difference && check.start && yk_state_copy(check.start, state) >= 0;
    if (is_ready) decide(&check, &verdict);
    yk_check_free_points(&check);
    yk_state_free(check.start);
    free(check.values);
    return verdict;
}
