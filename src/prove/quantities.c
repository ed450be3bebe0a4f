// Quantities in an equation besides the symbols: energies, points, efforts, reactions, by the names of `--of`.
#include <string.h>
#include "prove/quantities.h"
#include "derive/forces/free_bodies.h"

int yk_derive_take_order(const char *name, size_t *length)
{
    int order = 0;
    while (*length > 0 && name[*length - 1] == '\'') --*length, order++;
    if (order > 0) return order;
    static const char *const endings[] = {".rate", ".accel"};
    for (int k = 0; k < 2; k++) {
        size_t size = strlen(endings[k]);
        if (*length <= size || strncmp(name + *length - size, endings[k], size) != 0) continue;
        *length -= size;
        return k + 1;
    }
    return 0;
}

static bool is_word(const char *name, size_t length, const char *word)
{
    return strlen(word) == length && strncmp(name, word, length) == 0;
}

// --- Energies

static const YkPoisson *energy(const YkDeriveForces *f, const char *name, size_t length)
{
    YkDerivation *d = f->d;
    bool is_kinetic = is_word(name, length, "T") || is_word(name, length, "kinetic");
    bool is_potential = is_word(name, length, "V") || is_word(name, length, "potential");
    bool is_sum = is_word(name, length, "energy"), is_lagrangian = is_word(name, length, "L");
    const YkPoisson *T = is_kinetic || is_sum || is_lagrangian ? yk_derive_kinetic_total(f) : NULL;
    const YkPoisson *V = is_potential || is_sum || is_lagrangian ? yk_derive_potential(f) : NULL;
    if (is_sum) return yk_ring_add(d->ring, T, V);
    if (is_lagrangian) return yk_ring_subtract(d->ring, T, V);
    if (T || V) return T ? T : V;
    for (size_t b = 1; b < d->model->body_count && length > 2 && strncmp(name, "T_", 2) == 0; b++)
        if (is_word(name + 2, length - 2, d->bodies[b].name)) return yk_derive_kinetic(f, (int32_t)b);
    for (size_t k = 0; k < f->load_count && length > 2 && strncmp(name, "V_", 2) == 0; k++)
        if (f->loads[k].energy && is_word(name + 2, length - 2, yk_derive_energy_name(f, k))) return f->loads[k].energy;
    return NULL;
}

// --- Angular velocities and accelerations of bodies: omega_lever, alpha_lever

static const YkPoisson *turning(YkDerivation *d, const char *name, size_t length)
{
    bool is_speed = length > 6 && strncmp(name, "omega_", 6) == 0;
    bool is_acceleration = !is_speed && length > 6 && strncmp(name, "alpha_", 6) == 0;
    for (size_t b = 0; b < d->model->body_count && (is_speed || is_acceleration); b++)
        if (is_word(name + 6, length - 6, d->bodies[b].name))
            return is_speed ? d->bodies[b].spin : d->bodies[b].spin_rate;
    return NULL;
}

// --- Points

static const YkPoisson *coordinate_of_point(YkDerivation *d, const char *name, size_t length)
{
    char part = length > 2 && name[length - 2] == '.' ? name[length - 1] : '\0';
    if (part != 'x' && part != 'y') return NULL;
    const char *dot = memchr(name, '.', length - 2);
    for (size_t p = 0; dot && p < d->model->point_count; p++) {
        const YkPoint *point = &d->model->points[p];
        const char *own = dot + 1;
        if (!is_word(name, (size_t)(dot - name), d->model->bodies[point->body].name)) continue;
        if (!is_word(own, length - 2 - (size_t)(own - name), point->name)) continue;
        const YkPoisson *at = yk_derive_position(d, point->body, yk_derive_at(d, (int32_t)p));
        return part == 'x' ? yk_ring_real(d->ring, at) : yk_ring_imaginary(d->ring, at);
    }
    return NULL;
}

const YkPoisson *yk_derive_quantity(YkDerivation *d, const char *name)
{
    size_t length = strlen(name);
    int order = yk_derive_take_order(name, &length);
    const YkPoisson *a = d->most_depth > YK_DERIVE_DEPTH_MAX ? NULL : coordinate_of_point(d, name, length);
    if (!a) a = turning(d, name, length);
    const YkDeriveForces *f = a ? NULL : yk_derive_forces(d);
    if (f && d->most_depth <= YK_DERIVE_DEPTH_MAX) a = energy(f, name, length);
    if (f && !a && order == 0) a = yk_derive_force_quantity(f, name);
    for (; a && order > 0; order--) a = yk_ring_time_derivative(d->ring, a);
    return a;
}
