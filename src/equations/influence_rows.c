// Turns the elimination into rows that a pose streams through: operations that carry, and bodies by their motion.
#include <stdlib.h>
#include "equations/influence.h"

static YkInfluenceTerm term_of(const YkInfluence *f, const YkGradient *gradient, uint32_t first_index, uint32_t column)
{
    const YkGradientPiece *piece = &f->e->pieces[gradient->first_piece + column];
    return (YkInfluenceTerm){4 * piece->unit, f->e->index[first_index + column] * (int32_t)f->width, piece->v};
}

static void put_operation(YkInfluence *f, size_t p, size_t *freed)
{
    const YkOperation *op = &f->e->operations[p];
    YkInfluenceCarry carry = {.operation = (uint32_t)p, .first_term = (uint32_t)f->term_count};
    if (op->kind == YK_OP_KNOWN) return; // R stays 0
    if (op->kind == YK_OP_FREE) {
        f->input[*freed] = op->input;
        f->unknown[*freed] = f->e->index[op->first_index];
        f->R[(size_t)f->unknown[*freed] * f->width + *freed] = 1; // and stays so
        (*freed)++;
        return;
    }
    if (op->kind == YK_OP_PAIR && op->gradient.is_plain) {
        carry.term_count = op->gradient.columns;
        for (uint32_t k = 0; k < carry.term_count; k++)
            f->terms[f->term_count++] = term_of(f, &op->gradient, op->first_index, k);
    }
    f->carries[f->carry_count++] = carry;
}

// Returns the kind of a body by its gradient: the number of terms of a plain one; 0: any other.
static uint32_t plain_terms(const YkElement *element)
{
    return element->gradient.is_plain && element->gradient.columns <= 2 ? element->gradient.columns : 0;
}

static void put_other(YkInfluence *f, const YkElement *element)
{
    YkOtherBody b = {
        (uint32_t)(element - f->e->elements), element->body, YK_NONE, YK_NONE, element->mass, element->inertia};
    if (element->rotation != YK_NONE) {
        b.turn = 4 * f->e->mech->bodies[element->body].orientation;
        b.rotation = f->e->index[element->first_index + (uint32_t)element->rotation] * (int32_t)f->width;
    }
    f->others[f->other_count++] = b;
}

static void put_body(YkInfluence *f, const YkElement *element)
{
    uint32_t count = plain_terms(element);
    YkInfluenceTerm term[2];
    double about[2];
    for (uint32_t k = 0; k < count; k++) {
        term[k] = term_of(f, &element->gradient, element->first_index, k);
        about[k] = element->mass * yk_dot(term[k].v, term[k].v);
        if (element->rotation == (int32_t)k) about[k] += element->inertia;
    }
    if (count == 1)
        f->pivoted[f->pivoted_count++] =
            (YkPivotedBody){term[0], about[0], element->mass, element->body, element->rotation == 0};
    else if (count == 2)
        f->carried[f->carried_count++] =
            (YkCarriedBody){{term[0], term[1]}, {about[0], about[1]}, element->mass, element->body, element->rotation};
    else
        put_other(f, element);
}

static bool allocate(YkInfluence *f)
{
    const YkElimination *e = f->e;
    size_t most = 1; // most coefficients of any operation
    for (size_t p = 0; p < e->operation_count; p++) {
        size_t count = (size_t)e->operations[p].own * e->operations[p].given;
        if (count > most) most = count;
    }
    YkArena *a = f->arena = yk_arena_new();
    f->carries = yk_arena_alloc(a, e->operation_count + 1, sizeof *f->carries);
    f->terms = yk_arena_alloc(a, e->piece_count + 1, sizeof *f->terms);
    size_t bodies[3] = {0};
    for (size_t k = 0; k < e->element_count; k++) bodies[plain_terms(&e->elements[k])]++;
    f->others = yk_arena_alloc(a, bodies[0] + 1, sizeof *f->others);
    f->pivoted = yk_arena_alloc(a, bodies[1] + 1, sizeof *f->pivoted);
    f->carried = yk_arena_alloc(a, bodies[2] + 1, sizeof *f->carried);
    f->R = yk_arena_alloc(a, e->unknown_count * f->width + 1, sizeof *f->R);
    f->C = yk_arena_alloc(a, most, sizeof *f->C);
    return !yk_arena_failed(a) && yk_coefficients_start(&f->work, e);
}

YkInfluence *yk_influence_new(const YkElimination *e, size_t free_count)
{
    YkInfluence *f = calloc(1, sizeof *f);
    if (!f) return NULL;
    f->e = e;
    f->free_count = free_count;
    f->width = free_count > 2 ? 4 : free_count;
    if (!allocate(f)) {
        yk_influence_free(f);
        return NULL;
    }
    size_t freed = 0;
    for (size_t p = 0; p < e->operation_count; p++) put_operation(f, p, &freed);
    for (size_t k = 0; k < e->element_count; k++) put_body(f, &e->elements[k]);
    return f;
}

void yk_influence_free(YkInfluence *f)
{
    if (!f) return;
    yk_coefficients_end(&f->work);
    yk_arena_free(f->arena);
    free(f);
}
