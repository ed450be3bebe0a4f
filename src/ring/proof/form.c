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

static const YkForm *combine(YkRing *ring, YkFormKind kind, const YkForm *const *parts, size_t count)
{
    size_t height = 0;
    for (size_t i = 0; i < count; i++) {
        if (!parts[i]) return NULL;
        if (parts[i]->height > height) height = parts[i]->height;
    }
    if (height >= YK_FORM_HEIGHT_MAX) {
        yk_ring_fail(ring, YK_RING_SIZE);
        return NULL;
    }
    YkForm *form = new_form(ring, kind, count);
    if (!form) return NULL;
    form->height = height + 1;
    for (size_t i = 0; i < count; i++) {
        form->parts[i] = parts[i];
        if (parts[i]->least < form->least) form->least = parts[i]->least;
    }
    return form;
}

const YkForm *yk_form_sum(YkRing *ring, const YkForm *const *parts, size_t count)
{
    return combine(ring, YK_FORM_SUM, parts, count);
}

const YkForm *yk_form_product(YkRing *ring, const YkForm *const *parts, size_t count)
{
    return combine(ring, YK_FORM_PRODUCT, parts, count);
}

const YkForm *yk_form_add(YkRing *ring, const YkForm *a, const YkForm *b)
{
    return combine(ring, YK_FORM_SUM, (const YkForm *const[]){a, b}, 2);
}

const YkForm *yk_form_multiply(YkRing *ring, const YkForm *a, const YkForm *b)
{
    return combine(ring, YK_FORM_PRODUCT, (const YkForm *const[]){a, b}, 2);
}

// Returns number * i^turned * a.
static const YkForm *times(YkRing *ring, const YkForm *a, int64_t over, int64_t under, bool turned)
{
    const YkPoisson *number = yk_ring_scale(ring, turned ? yk_ring_i(ring) : ring->one, over, under);
    return yk_form_multiply(ring, yk_form_of(ring, number), a);
}

const YkForm *yk_form_subtract(YkRing *ring, const YkForm *a, const YkForm *b)
{
    return yk_form_add(ring, a, times(ring, b, -1, 1, false));
}

const YkForm *yk_form_divide(YkRing *ring, const YkForm *over, const YkForm *under)
{
    return combine(ring, YK_FORM_QUOTIENT, (const YkForm *const[]){over, under}, 2);
}

const YkForm *yk_form_conjugate(YkRing *ring, const YkForm *a)
{
    return combine(ring, YK_FORM_CONJUGATE, &a, 1);
}

const YkForm *yk_form_real(YkRing *ring, const YkForm *a)
{
    return times(ring, yk_form_add(ring, a, yk_form_conjugate(ring, a)), 1, 2, false);
}

const YkForm *yk_form_imaginary(YkRing *ring, const YkForm *a)
{
    return times(ring, yk_form_subtract(ring, a, yk_form_conjugate(ring, a)), -1, 2, true);
}

YkFormKind yk_form_kind(const YkForm *form)
{
    return form->kind;
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
