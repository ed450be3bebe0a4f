// Section: free bodies. Every body by itself with all that acts on it: forces of other bodies, loads, and inertia
// forces.
#include <string.h>
#include "derive/forces/free_bodies.h"
#include "derive/sections.h"

// " + F_{01}", " - F_{12}": what acts on a body; `first`: without a plus. A load is named by its kind: W, S, D, R, F,
// Q.
static void put_contact(YkPage *page, YkLine *line, const YkDeriveContact *contact, bool first)
{
    if (contact->is_negative || !first) yk_line_sign(page, line, contact->is_negative ? "-" : "+");
    yk_line_vector(page, line, contact->letter, NULL, contact->between);
}

bool yk_derive_put_contacts(const YkDeriveForces *f, YkPage *page, YkLine *line, int32_t body, bool first)
{
    size_t count;
    const int32_t *contacts = yk_derive_contacts_on(f, body, &count);
    for (size_t k = 0; k < count; k++) {
        if (!f->contacts[contacts[k]].letter) continue;
        put_contact(page, line, &f->contacts[contacts[k]], first);
        first = false;
    }
    return first;
}

const char *yk_derive_load_letter(YkDeriveLoadKind kind)
{
    static const char *const letters[] = {"W", "S", "D", "P", "R", "F", "Q", "Q"};
    return letters[kind];
}

void yk_derive_put_load(YkPage *page, YkLine *line, const YkDeriveLoad *load, size_t push, bool first)
{
    if (push == 1 || !first) yk_line_sign(page, line, push == 1 ? "-" : "+");
    yk_line_vector(page, line, yk_derive_load_letter(load->kind), NULL, load->name);
}

// Returns what follows the M of a load's couple: its name and, where another couple has the same name, its letter. The
// effort of a drive keeps the plain name.
const char *yk_derive_couple_name(const YkDeriveForces *f, const YkDeriveLoad *load)
{
    bool is_alone = true;
    for (size_t k = 0; k < f->load_count; k++) {
        const YkDeriveLoad *other = &f->loads[k];
        bool is_couple = other->push_count > 0 && !yk_ring_is_zero(other->push[0].moment);
        is_alone = is_alone && (other == load || !is_couple || strcmp(other->name, load->name) != 0);
    }
    if (is_alone || load->kind == YK_DERIVE_DRIVE) return load->name;
    char letter[2] = {yk_derive_load_letter(load->kind)[0], 0};
    if (load->kind == YK_DERIVE_DRY)
        letter[0] = yk_ring_symbol_name(f->d->ring, load->symbol)[0]; // R friction, S a stop
    return yk_derive_text(f->d, load->name, ",", letter);
}

const char *yk_derive_contact_point(YkDerivation *d, const YkDeriveContact *contact)
{
    int32_t joint = contact->joint;
    if (contact->point) return contact->point;
    bool slides = d->joint_distance[joint] != YK_NONE; // acts where the second body's point is
    int side = slides || d->model->joints[joint].body[1] == contact->push.body;
    YkDerivePlace place = yk_derive_place(d, joint, side);
    return yk_derive_point_name(d, place.body, place.point);
}

const char *yk_derive_load_point(const YkDeriveForces *f, const YkDeriveLoad *load, size_t push)
{
    YkDerivation *d = f->d;
    if (load->joint != YK_NONE) {
        const YkJoint *end = yk_joint_end(d->model, (size_t)load->joint, 1);
        YkDerivePlace place = yk_derive_place(d, (int32_t)(end - d->model->joints), 1);
        return yk_derive_point_name(d, place.body, place.point);
    }
    int32_t body = load->push[push].body;
    for (size_t k = 0; k < d->model->force_count && load->kind == YK_DERIVE_FORCE; k++)
        if (d->model->forces[k].name == load->name) return yk_derive_point_name(d, body, d->model->forces[k].point);
    for (size_t k = 0; k < d->model->spring_count; k++)
        if (d->model->springs[k].name == load->name)
            return yk_derive_point_name(d, body, d->model->springs[k].point[push]);
    return yk_derive_center_name(d, body);
}

// --- One line for each force and couple

static void put_column(YkDerivation *d, YkPage *page, YkLine *line, const YkPoisson *vector)
{
    yk_line_sign(page, line, "=");
    yk_line_column(page, line, vector, yk_derive_shown_by(d));
}

static void put_couple(YkDerivation *d, YkPage *page, YkLine *line, const YkPoisson *moment)
{
    yk_line_sign(page, line, "=");
    yk_line_changed(page, line, moment, yk_derive_shown_by(d));
}

const char *yk_derive_giver(const YkDeriveForces *f, const YkDeriveContact *contact)
{
    const YkDerivation *d = f->d;
    if (contact->by) return contact->by;
    if (contact->junction != YK_NONE) return yk_derive_text(f->d, "the pin ", f->junctions[contact->junction].name, "");
    const int32_t *body = d->model->joints[contact->joint].body;
    return d->model->bodies[body[contact->is_negative ? 1 : 0]].name;
}

static void put_contact_lines(const YkDeriveForces *f, YkPage *page, const YkDeriveContact *contact)
{
    YkDerivation *d = f->d;
    const char *giver = yk_derive_giver(f, contact);
    const char *const by[] = {"by ", giver, " at ", yk_derive_contact_point(d, contact)};
    if (contact->letter) {
        YkLine *line = yk_page_formula_of(page, by, 4);
        put_contact(page, line, contact, true);
        put_column(d, page, line, contact->push.force);
    }
    if (!contact->moment) return;
    YkLine *line = yk_page_formula_of(page, by, 4);
    if (contact->is_negative) yk_line_sign(page, line, "-");
    yk_line_vector(page, line, contact->moment, NULL, contact->between);
    put_couple(d, page, line, contact->push.moment);
}

const char *yk_derive_load_word(YkDeriveLoadKind kind)
{
    static const char *const words[] = {"weight",           "spring", "damper", "spring by a law",
                                        "friction or stop", "force",  "effort", "effort of the drive"};
    return words[kind];
}

static void put_load_lines(const YkDeriveForces *f, YkPage *page, const YkDeriveLoad *load, size_t p)
{
    YkDerivation *d = f->d;
    const YkDerivePush *push = &load->push[p];
    const char *const at[] = {yk_derive_load_word(load->kind), " at ", yk_derive_load_point(f, load, p)};
    if (!yk_ring_is_zero(push->force)) {
        YkLine *line = yk_page_formula_of(page, at, 3);
        yk_derive_put_load(page, line, load, p, true);
        put_column(d, page, line, push->force);
    }
    if (yk_ring_is_zero(push->moment)) return;
    YkLine *line = yk_page_formula(page, yk_derive_load_word(load->kind));
    if (p == 1) yk_line_sign(page, line, "-");
    yk_line_vector(page, line, "M", NULL, yk_derive_couple_name(f, load));
    put_couple(d, page, line, push->moment);
}

// Adds - m a at the centre of mass and - I alpha: with them every body is in equilibrium (d'Alembert).
static void put_inertia(const YkDeriveForces *f, YkPage *page, int32_t body)
{
    YkDerivation *d = f->d;
    const YkDeriveMass *m = &f->bodies[body];
    if (!yk_ring_is_zero(m->mass)) {
        YkLine *line = yk_page_formula(page, "inertia");
        yk_line_sign(page, line, "-");
        yk_line_element(page, line, m->mass, YK_RING_TEXTBOOK);
        yk_line_vector(page, line, "a", yk_derive_center_name(d, body), NULL);
        put_column(d, page, line, yk_ring_negate(d->ring, yk_ring_multiply(d->ring, m->mass, m->acceleration)));
    }
    yk_derive_put_step(f, page, body);
    const YkPoisson *couple = yk_ring_multiply(d->ring, m->inertia, d->bodies[body].spin_rate);
    if (!couple || yk_ring_is_zero(couple)) return;
    YkLine *line = yk_page_formula(page, "inertia");
    yk_line_sign(page, line, "-");
    yk_line_factor(page, line, m->inertia);
    yk_line_vector(page, line, "alpha", NULL, d->bodies[body].name);
    put_couple(d, page, line, yk_ring_negate(d->ring, couple));
}

void yk_derive_put_acting(const YkDeriveForces *f, YkPage *page, int32_t body)
{
    size_t count;
    const int32_t *contacts = yk_derive_contacts_on(f, body, &count);
    for (size_t k = 0; k < count; k++) put_contact_lines(f, page, &f->contacts[contacts[k]]);
    const int32_t *pushes = yk_derive_pushes_on(f, body, &count);
    for (size_t k = 0; k < count; k++) put_load_lines(f, page, &f->loads[pushes[k] / 2], (size_t)pushes[k] % 2);
    put_inertia(f, page, body);
}

static void put_body(const YkDeriveForces *f, YkPage *page, int32_t body)
{
    YkText title = {0};
    yk_text_format(&title, "%s, body %d", f->d->model->bodies[body].name, (int)body);
    yk_page_heading(page, 2, yk_text_get(&title));
    page->failed |= title.failed;
    yk_text_free(&title);
    yk_derive_put_acting(f, page, body);
}

static void put_junction(const YkDeriveForces *f, YkPage *page, int32_t junction)
{
    YkDerivation *d = f->d;
    bool first = true;
    yk_page_heading(page, 2, yk_derive_text(d, "Junction ", f->junctions[junction].name, ", a pin without mass"));
    YkLine *line = yk_page_formula(page, NULL);
    for (int32_t k = f->junctions[junction].first_contact; k != YK_NONE; k = f->contacts[k].next) {
        if (!first) yk_line_sign(page, line, "+");
        yk_line_vector(page, line, "F", NULL, f->contacts[k].between);
        first = false;
    }
    yk_line_sign(page, line, "=");
    yk_line_sign(page, line, "0");
}

bool yk_derive_section_free_bodies(YkDerivation *d, YkPage *page)
{
    const YkDeriveForces *f = yk_derive_forces(d);
    if (!f) return false;
    yk_page_words(page,
                  "F_ij is the force by body i on body j, in world axes; N_ij is normal to a guide, M_ij a moment.");
    yk_derive_put_angles(d, page);
    yk_derive_put_lengths(f, page);
    yk_derive_put_meshes(f, page);
    for (size_t b = 1; b < yk_model_body_count(d->model); b++) put_body(f, page, (int32_t)b);
    for (size_t k = 0; k < f->junction_count; k++) put_junction(f, page, (int32_t)k);
    return true;
}
