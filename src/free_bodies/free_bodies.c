// Balances of all bodies: makes the system, solves its parts, and answers for joints.
#include "free_bodies/free_bodies.h"
#include <stdlib.h>
#include <string.h>
#include "free_bodies/inside.h"

static bool allocate(YkFreeBodies *f)
{
    size_t n = f->mech->model->body_count;
    f->arena = yk_arena_new();
    f->reference = f->arena ? YK_NEW(f->arena, YkVec, n) : NULL;
    if (!f->reference) return false;
    for (size_t b = 0; b < n; b++) f->reference[b] = yk_reference_point(f->mech->model, b);
    if (!yk_wrenches_build(f) || !yk_parts_build(f)) return false;
    size_t scratch = 3 * n + f->column_count + 1;
    f->is_prescribed = YK_NEW(f->arena, bool, f->mech->input_count + 1);
    f->load = YK_NEW(f->arena, double, 3 * n);
    f->acceleration = YK_NEW(f->arena, double, 3 * n);
    f->inertia = YK_NEW(f->arena, double, 3 * n);
    f->b = YK_NEW(f->arena, double, scratch);
    f->x = YK_NEW(f->arena, double, scratch);
    f->y = YK_NEW(f->arena, double, scratch);
    return !yk_arena_failed(f->arena);
}

YkFreeBodies *yk_free_bodies_new(const YkMechanism *mech)
{
    YkFreeBodies *f = calloc(1, sizeof *f);
    if (!f) return NULL;
    f->mech = mech;
    f->size = mech->size;
    if (!allocate(f)) {
        yk_free_bodies_free(f);
        return NULL;
    }
    return f;
}

void yk_free_bodies_free(YkFreeBodies *f)
{
    if (!f) return;
    yk_parts_end(f);
    yk_arena_free(f->arena);
    free(f);
}

static void take_loads(YkFreeBodies *f, const YkLoad *loads)
{
    for (size_t b = 1; b < f->mech->model->body_count; b++) {
        f->load[3 * b] = loads[b].force.x;
        f->load[3 * b + 1] = loads[b].force.y;
        f->load[3 * b + 2] = loads[b].moment / f->size;
    }
}

static void take_accelerations(YkFreeBodies *f, const YkSpace *space)
{
    const YkModel *model = f->mech->model;
    for (size_t b = 1; b < model->body_count; b++) {
        if (!model->bodies[b].has_mass) continue;
        YkBodyMotion m = yk_body_motion(f->mech, space, b);
        f->acceleration[3 * b] = m.acceleration.x;
        f->acceleration[3 * b + 1] = m.acceleration.y;
        f->acceleration[3 * b + 2] = m.a * f->size;
    }
}

static void find_inertia(YkFreeBodies *f, const YkBodyPart *part)
{
    for (size_t k = 0; k < part->body_count; k++) {
        size_t at = 3 * (size_t)part->bodies[k];
        const YkBody *b = &f->mech->model->bodies[part->bodies[k]];
        double mass = b->has_mass ? b->mass : 0, inertia = b->has_mass ? b->inertia / (f->size * f->size) : 0;
        f->inertia[at] = mass * f->acceleration[at];
        f->inertia[at + 1] = mass * f->acceleration[at + 1];
        f->inertia[at + 2] = inertia * f->acceleration[at + 2];
    }
}

// The bodies of a part are solved together, so a value in the balance of one that is not a number makes all shares of
// the part not a number.
static bool is_finite(const YkFreeBodies *f, const YkBodyPart *part)
{
    double sum = 0;
    for (size_t k = 0; k < part->column_count; k++) sum += 0 * f->columns[part->columns[k]].share;
    return sum == 0;
}

// Returns, of the statuses of two parts, the failure, or else the one worth attention.
static YkStatus worse(YkStatus a, YkStatus b)
{
    if (a < 0 || b < 0) return a < 0 ? a : b;
    return a > b ? a : b;
}

// Takes the solution of a part, or clears it if there is none. Returns its status.
static YkStatus settle(YkFreeBodies *f, YkBodyPart *part, YkStatus status)
{
    if ((status == YK_OK || status == YK_REDUNDANT) && !is_finite(f, part)) status = YK_SINGULAR;
    if (status != YK_OK && status != YK_REDUNDANT) yk_part_clear(f, part);
    return status;
}

YkStatus yk_free_bodies_inverse(YkFreeBodies *f, const YkSpace *space, const YkLoad *loads, bool is_regular)
{
    YkStatus status = YK_OK;
    bool is_dead_point = !is_regular && !(space->margin[0] > YK_SINGULAR_MARGIN);
    yk_wrenches_pose(f, space);
    take_loads(f, loads);
    take_accelerations(f, space);
    for (size_t p = 0; p < f->part_count; p++) {
        YkBodyPart *part = &f->parts[p];
        find_inertia(f, part);
        YkStatus own = is_dead_point ? YK_SINGULAR : yk_part_balance(f, part, NULL);
        status = worse(status, settle(f, part, own));
    }
    return status;
}

// Takes a choice of prescribed inputs; the systems of forward dynamics are made for one such choice.
static void take_prescribed(YkFreeBodies *f, const bool *is_prescribed)
{
    size_t n = f->mech->input_count;
    if (f->has_prescribed && (n == 0 || memcmp(f->is_prescribed, is_prescribed, n * sizeof *is_prescribed) == 0))
        return;
    f->has_prescribed = true;
    if (n > 0) memcpy(f->is_prescribed, is_prescribed, n * sizeof *is_prescribed);
    for (size_t p = 0; p < f->part_count; p++) {
        yk_body_system_end(&f->parts[p].motion);
        yk_body_system_end(&f->parts[p].soft);
    }
}

static YkStatus move_part(YkFreeBodies *f, YkBodyPart *part, double *accelerations, int *culprit)
{
    YkStatus status = yk_part_motion(f, part, f->is_prescribed, accelerations, culprit);
    find_inertia(f, part);
    if (status == YK_REDUNDANT) return yk_part_balance(f, part, f->is_prescribed);
    return status;
}

static void clear_accelerations(YkFreeBodies *f, const YkBodyPart *part, double *accelerations)
{
    for (size_t k = 0; k < part->body_count; k++)
        memset(f->acceleration + 3 * (size_t)part->bodies[k], 0, 3 * sizeof *f->acceleration);
    for (size_t k = 0; k < part->column_count; k++) {
        int32_t input = f->columns[part->columns[k]].input;
        if (input != YK_NONE && !f->is_prescribed[input]) accelerations[input] = 0;
    }
}

YkStatus yk_free_bodies_forward(YkFreeBodies *f, const YkSpace *space, const YkLoad *loads, const bool *is_prescribed,
                                double *accelerations, int *culprit)
{
    YkStatus status = YK_OK;
    int none = -1, *guilty = culprit ? culprit : &none;
    *guilty = -1;
    yk_wrenches_pose(f, space);
    take_loads(f, loads);
    take_prescribed(f, is_prescribed);
    for (size_t p = 0; p < f->part_count; p++) {
        YkBodyPart *part = &f->parts[p];
        YkStatus own = settle(f, part, move_part(f, part, accelerations, guilty));
        if (own != YK_OK && own != YK_REDUNDANT) clear_accelerations(f, part, accelerations);
        status = worse(status, own);
    }
    return status;
}

YkJointForce yk_free_bodies_joint(const YkFreeBodies *f, size_t joint)
{
    YkJointForce sum = {.is_determinate = true};
    for (size_t k = f->joint_first[joint]; k < f->joint_first[joint + 1]; k++) {
        const YkWrenchColumn *c = &f->columns[k];
        sum.force = yk_add(sum.force, yk_scale(c->share, c->force));
        if (c->kind == YK_WRENCH_COUPLE) sum.moment += c->share * f->size;
        sum.is_determinate = sum.is_determinate && c->freeness == 0;
    }
    return sum;
}

double yk_free_bodies_effort(const YkFreeBodies *f, size_t input)
{
    const YkWrenchColumn *c = &f->columns[f->input_column[input]];
    return c->kind == YK_WRENCH_LINE ? c->share : c->share * f->size;
}
