// Shows a refutation: both sides, the highest derivative and the forces in them, the pose.
#include <stdlib.h>
#include "prove/check_inside.h"

// Finds the highest derivatives of coordinates and the names of forces in a form.
static void look_into(YkCheck *check, const YkForm *form, YkCheckShown *shown, bool *is_named)
{
    YkRing *ring = check->d->ring;
    const YkPoisson *a = yk_form_element(form);
    for (size_t k = 0; !a && k < yk_form_part_count(form); k++)
        look_into(check, yk_form_part(form, k), shown, is_named);
    for (int32_t s = a ? yk_ring_next_symbol(ring, a, -1) : -1; s >= 0; s = yk_ring_next_symbol(ring, a, s)) {
        YkRingClass kind = yk_ring_symbol_class(ring, s);
        int order = kind == YK_RING_RATE ? 1 : kind == YK_RING_ACCELERATION ? 2 : 0;
        if (order > shown->order) shown->order = order;
        is_named[s] = true;
    }
}

// Writes "F12x = 3.25, M03 = -0.5": the unknown forces of the equation.
static const char *list_forces(YkCheck *check, YkArena *arena, const bool *is_named)
{
    const YkDerivation *d = check->d;
    YkText text = {0};
    for (size_t k = 0; k < d->unknown_count; k++)
        if (is_named[d->unknowns[k]])
            yk_text_format(&text, "%s%s = %e", text.length ? ", " : "", yk_ring_symbol_name(d->ring, d->unknowns[k]),
                           check->values[d->unknowns[k]]);
    const char *list = text.length || text.failed ? yk_arena_copy(arena, yk_text_get(&text), text.length) : NULL;
    yk_text_free(&text);
    return list;
}

static const YkMotion *list_motions(const YkCheck *check, YkArena *arena)
{
    YkMotion *motions = YK_NEW(arena, YkMotion, check->d->tree_count + 1);
    for (size_t k = 0; motions && k < check->d->tree_count; k++) motions[k] = yk_state_coordinate(check->state, k);
    return motions;
}

void yk_check_show(YkCheck *check, YkArena *arena, YkCheckShown *shown)
{
    YkRing *ring = check->d->ring;
    bool *is_named = yk_derive_scratch(check->d, yk_ring_symbol_count(ring) + 1, sizeof *is_named);
    shown->left = yk_form_value(ring, check->equation.left, check->values).x;
    shown->right = yk_form_value(ring, check->equation.right, check->values).x;
    shown->positions = list_motions(check, arena);
    shown->time = yk_state_time(check->state);
    shown->has_time = check->has_time;
    if (!is_named) return;
    look_into(check, check->equation.left, shown, is_named);
    look_into(check, check->equation.right, shown, is_named);
    shown->forces = list_forces(check, arena, is_named);
    free(is_named);
}
