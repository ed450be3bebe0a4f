// Builds Newton-Euler as a linear system A xi = b.
#include "derive/forces/newton_euler.h"

// Returns whether it is the moment of a guide whose second body has a trivial moment balance.
static bool is_trivial_moment(const YkDeriveForces *f, size_t reaction)
{
    const YkJoint *j = &f->d->model->joints[f->reaction_joint[reaction]];
    return f->reaction_part[reaction] == 'm' && f->bodies[j->body[1]].is_trivial;
}

// Returns the guide's moment of a trivial pair, and its value.
static size_t trivial_moments(const YkDeriveForces *f, YkRingChange *changes)
{
    YkDerivation *d = f->d;
    size_t count = 0;
    for (size_t r = 0; r < f->reaction_count; r++) {
        if (!is_trivial_moment(f, r)) continue;
        const YkPoisson *M = yk_ring_of(d->ring, f->reactions[r]);
        const YkPoisson *rest = yk_derive_euler(f, d->model->joints[f->reaction_joint[r]].body[1]);
        changes[count++] = (YkRingChange){f->reactions[r], yk_ring_subtract(d->ring, M, rest), NULL};
    }
    return count;
}

typedef struct Rows {
    const YkDeriveForces *f;
    YkDeriveSystem *system;
    const YkRingChange *changes;
    size_t change_count;
} Rows;

static void add_row(Rows *rows, const YkPoisson *shown, const char *name, const char *part)
{
    YkDeriveSystem *system = rows->system;
    system->labels[system->row_count] = yk_derive_text(rows->f->d, name, part, "");
    system->zeros[system->row_count++] = shown;
}

static const YkPoisson *without_trivial(const Rows *rows, const YkPoisson *zero)
{
    if (rows->change_count == 0) return zero;
    return yk_ring_substitute(rows->f->d->ring, zero, rows->changes, rows->change_count);
}

static void add_vector_rows(Rows *rows, const YkPoisson *zero, const char *name)
{
    YkRing *ring = rows->f->d->ring;
    const YkPoisson *shown = yk_derive_shown(rows->f->d, zero);
    add_row(rows, yk_ring_real(ring, shown), name, " x");
    add_row(rows, yk_ring_imaginary(ring, shown), name, " y");
}

static bool add_rows(Rows *rows)
{
    const YkDeriveForces *f = rows->f;
    YkDerivation *d = f->d;
    int count = yk_derive_closing_rows(f);
    for (size_t b = 1; b < yk_model_body_count(d->model); b++) {
        add_vector_rows(rows, yk_derive_newton(f, (int32_t)b), d->model->bodies[b].name);
        if (f->bodies[b].is_trivial) continue;
        const YkPoisson *euler = without_trivial(rows, yk_derive_euler(f, (int32_t)b));
        add_row(rows, yk_derive_shown(d, euler), d->model->bodies[b].name, " M");
    }
    for (size_t k = 0; k < f->junction_count; k++) add_vector_rows(rows, f->junctions[k].force, f->junctions[k].name);
    for (int k = 0; k < count; k++) add_row(rows, f->closing[k], f->closing_name[k], " closes");
    return count >= 0;
}

static void add_unknowns(const YkDeriveForces *f, YkDeriveSystem *system)
{
    YkDerivation *d = f->d;
    for (size_t k = 0; k < f->reaction_count; k++)
        if (!is_trivial_moment(f, k)) system->unknowns[system->unknown_count++] = f->reactions[k];
    for (size_t k = 0; k < f->effort_count; k++) system->unknowns[system->unknown_count++] = f->efforts[k];
    size_t e = 0;
    for (size_t k = 0; k < d->tree_count; k++) {
        while (e < f->effort_count && f->effort_coordinate[e] < (int32_t)k) e++; // ascending, both
        bool is_given = e < f->effort_count && f->effort_coordinate[e] == (int32_t)k;
        if (!is_given) system->unknowns[system->unknown_count++] = yk_derive_shown_acceleration(d, k);
    }
}

bool yk_derive_system_size(const YkDeriveForces *f, YkDeriveSystem *system)
{
    YkDerivation *d = f->d;
    size_t unknowns = f->reaction_count + f->effort_count + d->tree_count + 1;
    int closing = yk_derive_closing_rows(f);
    *system = (YkDeriveSystem){.unknowns = YK_NEW(d->arena, int32_t, unknowns)};
    if (closing < 0 || yk_arena_failed(d->arena)) return false;
    add_unknowns(f, system);
    system->row_count = 2 * f->junction_count + (size_t)closing;
    for (size_t b = 1; b < yk_model_body_count(d->model); b++) system->row_count += f->bodies[b].is_trivial ? 2 : 3;
    return true;
}

bool yk_derive_system(const YkDeriveForces *f, YkDeriveSystem *system)
{
    YkDerivation *d = f->d;
    YkRingChange *changes = YK_NEW(d->arena, YkRingChange, d->model->body_count + 1);
    if (!changes || !yk_derive_system_size(f, system)) return false;
    system->zeros = YK_NEW(d->arena, const YkPoisson *, system->row_count + 1);
    system->labels = YK_NEW(d->arena, const char *, system->row_count + 1);
    if (yk_arena_failed(d->arena)) return false;
    system->row_count = 0;
    Rows all = {f, system, changes, trivial_moments(f, changes)};
    return add_rows(&all) && yk_derivation_is_well(d);
}

const YkPoisson *yk_derive_system_row(const YkDeriveForces *f, const YkDeriveSystem *system, size_t row,
                                      const YkPoisson **entries)
{
    size_t count = system->unknown_count;
    const YkPoisson *rest = yk_ring_split(f->d->ring, system->zeros[row], system->unknowns, count, entries, count);
    return yk_ring_negate(f->d->ring, rest);
}
