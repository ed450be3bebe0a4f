// Section: kinetic energy of every body and in total, potential energy, Lagrangian.
#include <string.h>
#include "derive/forces/free_bodies.h"
#include "derive/sections.h"

// Returns 1/2 m v^2 + 1/2 I w^2.
const YkPoisson *yk_derive_kinetic(const YkDeriveForces *f, int32_t body)
{
    YkRing *ring = f->d->ring;
    const YkDeriveMass *m = &f->bodies[body];
    if (f->kinetic[body]) return f->kinetic[body];
    const YkPoisson *spin = f->d->bodies[body].spin;
    yk_ring_begin_passing(ring);
    const YkPoisson *half_mass = yk_ring_scale(ring, m->mass, 1, 2),
                    *half_inertia = yk_ring_scale(ring, m->inertia, 1, 2);
    const YkPoisson *square =
        yk_ring_multiply(ring, yk_ring_conjugate(ring, m->velocity), m->velocity); // real by itself
    const YkPoisson *turning = yk_ring_product(ring, (const YkPoisson *[]){half_inertia, spin, spin}, 3);
    square = yk_ring_multiply(ring, half_mass, square);
    f->kinetic[body] = yk_ring_end_passing(ring, yk_ring_add(ring, square, turning));
    return f->kinetic[body];
}

const YkPoisson *yk_derive_kinetic_total(const YkDeriveForces *f)
{
    YkDerivation *d = f->d;
    if (f->kinetic[0]) return f->kinetic[0]; // the ground's place
    for (size_t b = 1; b < d->model->body_count; b++) yk_derive_kinetic(f, (int32_t)b);
    f->kinetic[0] = yk_ring_sum(d->ring, f->kinetic + 1, d->model->body_count - 1);
    return f->kinetic[0];
}

const YkPoisson *yk_derive_potential(const YkDeriveForces *f)
{
    size_t count = 0;
    if (f->potential[0]) return f->potential[0];
    const YkPoisson **parts = YK_NEW(f->d->arena, const YkPoisson *, f->load_count + 1);
    if (!parts) return NULL;
    for (size_t k = 0; k < f->load_count; k++)
        if (f->loads[k].energy) parts[count++] = f->loads[k].energy;
    f->potential[0] = yk_ring_sum(f->d->ring, parts, count);
    return f->potential[0];
}

// If a body and a spring have one name, V_left is the weight's energy and V_left_spring the spring's.
const char *yk_derive_energy_name(const YkDeriveForces *f, size_t load)
{
    const YkDeriveLoad *own = &f->loads[load];
    bool is_taken = false;
    for (size_t k = 0; k < f->load_count && own->kind == YK_DERIVE_SPRING; k++)
        is_taken |=
            f->loads[k].energy && f->loads[k].kind == YK_DERIVE_GRAVITY && strcmp(f->loads[k].name, own->name) == 0;
    return is_taken ? yk_derive_text(f->d, own->name, "_spring", "") : own->name;
}

static void put_energy(YkPage *page, const char *remark, const char *letter, const char *sub, const YkPoisson *energy,
                       YkRingStyle style)
{
    YkLine *line = yk_page_formula(page, remark);
    yk_line_vector(page, line, letter, NULL, sub);
    yk_line_sign(page, line, "=");
    yk_line_element(page, line, energy, style);
    if (line) line->value = line->over = energy;
}

// The name of a total is also a variable in C.
static void put_total(YkPage *page, const char *letter, const YkPoisson *energy)
{
    put_energy(page, NULL, letter, NULL, energy, YK_RING_BRACKETS);
    if (page->last && page->last->kind == YK_LINE_FORMULA) page->last->target = letter;
}

// Returns whether there are few enough bodies for totals.
static bool is_together(const YkDerivation *d)
{
    return d->model->body_count <= YK_DERIVE_TOGETHER_MAX;
}

static void put_kinetic(const YkDeriveForces *f, YkPage *page, const YkPoisson **total)
{
    YkDerivation *d = f->d;
    yk_page_heading(page, 2, "Kinetic energy");
    yk_page_words(page, "T = 1/2 m v^2 + 1/2 I w^2 of every body, v the velocity of its centre of mass, I about it.");
    for (size_t b = 1; b < d->model->body_count; b++) {
        const YkPoisson *energy = yk_derive_kinetic(f, (int32_t)b);
        if (energy && yk_ring_is_zero(energy)) continue;
        put_energy(page, d->model->bodies[b].name, "T", d->bodies[b].name, yk_derive_shown(d, energy),
                   YK_RING_TEXTBOOK);
    }
    if (!is_together(d)) return;
    *total = yk_derive_shown(d, yk_derive_kinetic_total(f));
    put_total(page, "T", *total);
}

void yk_derive_put_lengths(const YkDeriveForces *f, YkPage *page)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    for (size_t k = 0; k < f->length_count; k++) {
        const YkDeriveLength *l = &f->lengths[k];
        if (l->word) continue;
        const YkPoisson *length = yk_ring_of(ring, l->symbol), *square = yk_derive_shown(d, l->square);
        yk_page_equation(page, "length of the spring", yk_ring_power(ring, length, 2), square, YK_RING_TEXTBOOK);
        if (l->rate_symbol == YK_NONE) continue;
        const YkPoisson *rate = yk_ring_multiply(ring, length, yk_ring_of(ring, l->rate_symbol));
        const YkPoisson *is = yk_derive_shown(d, yk_ring_multiply(ring, length, l->rate));
        yk_page_equation(page, "its rate", rate, is, YK_RING_TEXTBOOK);
    }
}

static void put_potential(const YkDeriveForces *f, YkPage *page, const YkPoisson **total)
{
    YkDerivation *d = f->d;
    yk_page_heading(page, 2, "Potential energy");
    yk_derive_put_lengths(f, page);
    for (size_t k = 0; k < f->load_count; k++) {
        const YkDeriveLoad *load = &f->loads[k];
        if (!load->energy || yk_ring_is_zero(load->energy)) continue;
        put_energy(page, load->kind == YK_DERIVE_SPRING ? "spring" : "weight", "V", yk_derive_energy_name(f, k),
                   yk_derive_shown(d, load->energy), YK_RING_TEXTBOOK);
    }
    if (!is_together(d)) return;
    *total = yk_derive_shown(d, yk_derive_potential(f));
    put_total(page, "V", *total);
}

bool yk_derive_section_energy(YkDerivation *d, YkPage *page)
{
    const YkDeriveForces *f = yk_derive_forces(d);
    const YkPoisson *T = NULL, *V = NULL;
    if (!f) return false;
    if (yk_derive_put_depth(d, page)) return true;
    yk_derive_put_angles(d, page);
    put_kinetic(f, page, &T);
    put_potential(f, page, &V);
    if (!is_together(d)) {
        yk_page_words(page,
                      "T and V are the sums of these; for more than %z bodies they are not written as one formula.",
                      (size_t)YK_DERIVE_TOGETHER_MAX);
        return true;
    }
    yk_page_heading(page, 2, "Lagrangian");
    YkLine *line = yk_page_formula(page, NULL);
    if (yk_ring_find(d->ring, "L") < 0) { // otherwise a length of the file has this name
        yk_line_vector(page, line, "L", NULL, NULL);
        yk_line_sign(page, line, "=");
    }
    yk_line_vector(page, line, "T", NULL, NULL);
    yk_line_sign(page, line, "-");
    yk_line_vector(page, line, "V", NULL, NULL);
    yk_line_sign(page, line, "=");
    const YkPoisson *difference = yk_ring_subtract(d->ring, T, V);
    yk_line_element(page, line, difference, YK_RING_BRACKETS);
    if (line) line->value = difference;
    return true;
}
