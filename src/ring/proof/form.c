// The graph of a structured form. Nodes are numbered as they are made, parts before wholes.
#include "ring/proof/form.h"
#include "ring/proof/form_inside.h"

static YkForm *new_form(YkRing *ring, YkFormKind kind, size_t count)
{
    YkForm *form = yk_arena_alloc(ring->arena, 1, sizeof(YkForm) + count * sizeof(YkForm *));
    if (!form) {
        yk_ring_fail(ring, YK_RING_MEMORY);
        return NULL;
    }
    form->kind = kind;
    form->count = count;
    form->number = form->least = ring->form_count++;
    return form;
}

const YkForm *yk_form_of(YkRing *ring, const YkPoisson *a)
{
    YkForm *form = a ? new_form(ring, YK_FORM_ELEMENT, 0) : NULL;
    if (form) form->element = a;
    return form;
}

static const YkForm *combine(YkRing *ring, YkFormKind kind, const YkForm *a, const YkForm *b)
{
    if (!a || !b) return NULL;
    size_t height = a->height > b->height ? a->height : b->height;
    if (height >= YK_FORM_HEIGHT_MAX) {
        yk_ring_fail(ring, YK_RING_SIZE);
        return NULL;
    }
    YkForm *form = new_form(ring, kind, 2);
    if (!form) return NULL;
    form->height = height + 1;
    form->least = a->least < b->least ? a->least : b->least;
    form->parts[0] = a, form->parts[1] = b;
    return form;
}

const YkForm *yk_form_add(YkRing *ring, const YkForm *a, const YkForm *b)
{
    return combine(ring, YK_FORM_SUM, a, b);
}

const YkForm *yk_form_multiply(YkRing *ring, const YkForm *a, const YkForm *b)
{
    return combine(ring, YK_FORM_PRODUCT, a, b);
}

const YkForm *yk_form_subtract(YkRing *ring, const YkForm *a, const YkForm *b)
{
    return yk_form_add(ring, a, yk_form_multiply(ring, yk_form_of(ring, yk_ring_scale(ring, ring->one, -1, 1)), b));
}

const YkForm *yk_form_divide(YkRing *ring, const YkForm *over, const YkForm *under)
{
    return combine(ring, YK_FORM_QUOTIENT, over, under);
}

const YkPoisson *yk_form_element(const YkForm *form)
{
    return form->element;
}

size_t yk_form_part_count(const YkForm *form)
{
    return form->count;
}

const YkForm *yk_form_part(const YkForm *form, size_t index)
{
    return form->parts[index];
}
