// Creates, checks and frees a derivation.
#include <stdlib.h>
#include "base/problems.h"
#include "derive/gears/gears.h"
#include "derive/inside.h"

static bool has_call(const YkExpr *expr)
{
    if (!expr || expr->kind == YK_EXPR_NUMBER || expr->kind == YK_EXPR_NAME) return false;
    return expr->kind > YK_EXPR_MULTIPLY || has_call(expr->a) || has_call(expr->b);
}

static void enter_expression(YkDerivation *d, const YkExpr *expr)
{
    if (has_call(expr)) yk_derive_given(d, expr);
}

// Enters constants in the file's order, so that their names do not depend on what is derived; one that the ring cannot
// hold fails where it is needed.
static void enter_constants(YkDerivation *d)
{
    const YkModel *model = d->model;
    for (size_t p = 0; p < model->point_count; p++) {
        enter_expression(d, model->points[p].x);
        enter_expression(d, model->points[p].y);
    }
    for (size_t b = 1; b < model->body_count; b++) {
        enter_expression(d, model->bodies[b].center_x);
        enter_expression(d, model->bodies[b].center_y);
        yk_derive_mass(d, (int32_t)b);
        if (!yk_derive_is_rod(&model->bodies[b])) yk_derive_inertia(d, (int32_t)b);
    }
    for (size_t j = 0; j < model->joint_count; j++) {
        yk_derive_turn(d, model->joints[j].along_expr);
        yk_derive_forgive(d);
        yk_derive_turn(d, model->joints[j].turned_expr);
        yk_derive_forgive(d);
    }
}

static bool enter_all(YkDerivation *d)
{
    d->points = YK_NEW(d->arena, const YkPoisson *, d->model->point_count + 1);
    if (!d->points || !yk_derive_enter_parameters(d) || !yk_derive_enter_coordinates(d) || !yk_derive_enter_bodies(d))
        return false;
    enter_constants(d);
    return yk_derivation_is_well(d);
}

YkCode yk_derive_code(YkRingStatus status)
{
    if (status == YK_RING_STOPPED) return YK_CODE_STOPPED;
    return status == YK_RING_MEMORY ? YK_CODE_OUT_OF_MEMORY : YK_CODE_DERIVATION;
}

enum { CHUNK_MIN = 6 << 20, CHUNK_MAX = 1 << 24, CHUNK_PER_BODY = 1 << 13 };

// Makes the ring with one piece of memory that is larger than most derivations need. Pages of it that are never used
// cost nothing. A C library that keeps freed memory in proportion to the largest piece that was freed, as glibc does,
// then serves the next derivation with the same pages; otherwise it gives them back to the system after each one, and
// takes them anew for several times what a derivation costs.
static YkRing *new_ring(const YkModel *model)
{
    YkRing *ring = yk_ring_new();
    size_t most = (CHUNK_MAX - CHUNK_MIN) / CHUNK_PER_BODY, bodies = yk_model_body_count(model);
    if (ring) yk_ring_reserve(ring, CHUNK_MIN + CHUNK_PER_BODY * (bodies < most ? bodies : most));
    return ring;
}

YkDerivation *yk_derivation_new(const YkModel *model, const YkMechanism *mech, YkProblems *problems)
{
    YkDerivation *d = calloc(1, sizeof *d);
    if (d) {
        *d = (YkDerivation){.arena = yk_arena_new(), .model = model, .mech = mech, .ring = new_ring(model)};
        if (d->ring) yk_ring_set_pace(d->ring, &d->pace);
        if (d->arena && d->ring && enter_all(d) && yk_derivation_is_well(d)) return d;
    }
    YkRingStatus why = yk_derivation_fault(d);
    yk_problem(problems, yk_derive_code(why), (YkPlace){0}, "the machine cannot be written in symbols: %s",
               yk_ring_status_text(why));
    yk_derivation_free(d);
    return NULL;
}

void yk_derivation_free(YkDerivation *d)
{
    if (!d) return;
    if (d->forget_checks) d->forget_checks(d);
    yk_derive_train_free(d->train);
    free(d->constants);
    free(d->sources);
    free((void *)d->relations);
    free(d->unknowns);
    yk_text_free(&d->page);
    yk_ring_free(d->ring);
    yk_arena_free(d->arena);
    free(d);
}

void yk_derivation_set_progress(YkDerivation *d, YkProgress progress)
{
    d->progress = progress;
}

bool yk_derivation_begin(YkDerivation *d)
{
    if (!d->pace.is_stopped) yk_pace_begin(&d->pace, d->progress);
    return yk_ring_spend(d->ring, 0);
}

void yk_derivation_end(YkDerivation *d)
{
    d->pace.progress = (YkProgress){0};
}

void *yk_derive_scratch(YkDerivation *d, size_t count, size_t size)
{
    void *memory = calloc(count, size);
    if (!memory) d->failed = true;
    return memory;
}

bool yk_derivation_ran_out(const YkDerivation *d)
{
    return !d || d->failed || yk_arena_failed(d->arena) || yk_ring_status(d->ring) == YK_RING_MEMORY;
}

YkRingStatus yk_derivation_fault(const YkDerivation *d)
{
    if (d && d->pace.is_stopped) return YK_RING_STOPPED;
    YkRingStatus status = d && d->ring ? yk_ring_status(d->ring) : YK_RING_OK;
    return status == YK_RING_OK || yk_derivation_ran_out(d) ? YK_RING_MEMORY : status;
}

bool yk_derivation_is_well(const YkDerivation *d)
{
    return d && !d->failed && !yk_arena_failed(d->arena) && yk_ring_status(d->ring) == YK_RING_OK;
}
