// Force polygons in symbols: all forces on a body head to tail, the known ones first, closed by its inertia force.
#include "derive/forces/free_bodies.h"
#include "derive/sections.h"

static bool is_known(const YkDeriveLoad *load)
{
    return load->kind != YK_DERIVE_DRIVE;
}

// Writes the loads of a body that are known, or those that are not. Returns whether the line is still empty.
static bool put_loads(const YkDeriveForces *f, YkPage *page, YkLine *line, int32_t body, bool known, bool first)
{
    size_t count;
    const int32_t *pushes = yk_derive_pushes_on(f, body, &count);
    for (size_t k = 0; k < count; k++) {
        const YkDeriveLoad *load = &f->loads[pushes[k] / 2];
        size_t p = (size_t)pushes[k] % 2;
        if (is_known(load) != known || yk_ring_is_zero(load->push[p].force)) continue;
        yk_derive_put_load(page, line, load, p, first);
        first = false;
    }
    return first;
}

static bool put_inertia(const YkDeriveForces *f, YkPage *page, YkLine *line, int32_t body, bool first)
{
    if (yk_ring_is_zero(f->bodies[body].mass)) return first;
    yk_line_sign(page, line, "-");
    yk_line_factor(page, line, f->bodies[body].mass);
    yk_line_vector(page, line, "a", yk_derive_center_name(f->d, body), NULL);
    return false;
}

// Writes W - m a + F_12 - F_23 = 0.
static void put_closing(const YkDeriveForces *f, YkPage *page, int32_t body)
{
    YkRing *ring = f->d->ring;
    YkLine *line = yk_page_formula(page, "the polygon closes");
    bool first = put_inertia(f, page, line, body, put_loads(f, page, line, body, true, true));
    first = put_loads(f, page, line, body, false, yk_derive_put_contacts(f, page, line, body, first));
    if (first) yk_line_sign(page, line, "0");
    yk_line_sign(page, line, "=");
    yk_line_sign(page, line, "0");
    if (!line) return;
    // yk_derive_newton: the forces less mass times acceleration
    line->left = yk_derive_shown(f->d, yk_derive_newton(f, body));
    line->right = yk_ring_rational(ring, 0, 1);
    line->value = line->left;
    line->is_vector = true;
}

// A body on which two forces alone act: its two contacts without moments.
static bool is_two_force(const YkDeriveForces *f, int32_t body, const YkDeriveContact *two[2])
{
    size_t count, loads;
    const int32_t *contacts = yk_derive_contacts_on(f, body, &count);
    yk_derive_pushes_on(f, body, &loads);
    if (count != 2 || loads > 0 || !yk_ring_is_zero(f->bodies[body].mass)) return false;
    if (!yk_ring_is_zero(f->bodies[body].inertia)) return false;
    for (size_t k = 0; k < 2; k++) {
        two[k] = &f->contacts[contacts[k]];
        if (!two[k]->letter || two[k]->moment) return false;
    }
    return true;
}

static void put_body(const YkDeriveForces *f, YkPage *page, int32_t body)
{
    YkDerivation *d = f->d;
    const YkDeriveContact *two[2];
    yk_page_heading(page, 2, yk_derive_text(d, "Force polygon of ", d->model->bodies[body].name, ""));
    if (is_two_force(f, body, two))
        yk_page_words(page,
                      "Two forces alone act on %s, at %s and at %s: they are equal and opposite, along the line "
                      "between these points.",
                      d->model->bodies[body].name, yk_derive_contact_point(d, two[0]),
                      yk_derive_contact_point(d, two[1]));
    yk_derive_put_acting(f, page, body);
    put_closing(f, page, body);
}

bool yk_derive_put_force_polygons(YkDerivation *d, YkPage *page)
{
    const YkDeriveForces *f = yk_derive_forces(d);
    if (!f) return false;
    yk_page_heading(page, 2, "Force polygons");
    yk_page_words(page,
                  "A body's known forces are drawn first, head to tail: loads, and its inertia force. The forces "
                  "of its joints close the polygon. Begin with bodies on which two forces alone act: the line of both "
                  "is known.");
    yk_derive_put_lengths(f, page);
    yk_derive_put_meshes(f, page);
    for (size_t b = 1; b < yk_model_body_count(d->model); b++) put_body(f, page, (int32_t)b);
    return true;
}
