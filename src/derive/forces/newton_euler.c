// Section: Newton-Euler. Equations of every body as vectors and in x, y and moments; the count; the matrix form
// A xi = b.
#include "derive/forces/newton_euler.h"
#include "derive/sections.h"

enum { ROWS_SHOWN_MAX = 24 };

// --- Vector form

static const char *joined(YkDerivation *d, const char *head, const char *tail)
{
    return yk_derive_text(d, head, "/", tail);
}

static void put_zero_if_empty(YkPage *page, YkLine *line, bool is_empty)
{
    if (is_empty) yk_line_sign(page, line, "0");
}

static void put_newton(const YkDeriveForces *f, YkPage *page, int32_t body)
{
    YkDerivation *d = f->d;
    YkLine *line = yk_page_formula(page, NULL);
    bool first = yk_derive_put_contacts(f, page, line, body, true);
    size_t count;
    const int32_t *pushes = yk_derive_pushes_on(f, body, &count);
    for (size_t k = 0; k < count; k++) {
        const YkDeriveLoad *load = &f->loads[pushes[k] / 2];
        if (yk_ring_is_zero(load->push[pushes[k] % 2].force)) continue;
        yk_derive_put_load(page, line, load, (size_t)pushes[k] % 2, first);
        first = false;
    }
    put_zero_if_empty(page, line, first);
    yk_line_sign(page, line, "=");
    put_zero_if_empty(page, line, yk_ring_is_zero(f->bodies[body].mass));
    if (yk_ring_is_zero(f->bodies[body].mass)) return;
    yk_line_factor(page, line, f->bodies[body].mass);
    yk_line_vector(page, line, "a", yk_derive_center_name(d, body), NULL);
}

// Writes " + p^{A/C1} x", which turns a force into its moment.
static void put_arm(const YkDeriveForces *f, YkPage *page, YkLine *line, int32_t body, const char *point, bool negative,
                    bool first)
{
    YkDerivation *d = f->d;
    if (negative || !first) yk_line_sign(page, line, negative ? "-" : "+");
    yk_line_vector(page, line, "p", joined(d, point, yk_derive_center_name(d, body)), NULL);
    yk_line_sign(page, line, "x");
}

static bool has_moment(const YkDerivePush *push)
{
    return !yk_ring_is_zero(push->force) && !yk_ring_is_zero(push->arm);
}

static bool put_contact_moments(const YkDeriveForces *f, YkPage *page, YkLine *line, int32_t body)
{
    bool first = true;
    size_t count;
    const int32_t *contacts = yk_derive_contacts_on(f, body, &count);
    for (size_t k = 0; k < count; k++) {
        const YkDeriveContact *c = &f->contacts[contacts[k]];
        if (has_moment(&c->push)) {
            put_arm(f, page, line, body, yk_derive_contact_point(f->d, c), c->is_negative, first);
            yk_line_vector(page, line, c->letter, NULL, c->between);
            first = false;
        }
        if (!c->moment) continue;
        if (c->is_negative || !first) yk_line_sign(page, line, c->is_negative ? "-" : "+");
        yk_line_vector(page, line, c->moment, NULL, c->between);
        first = false;
    }
    return first;
}

static bool put_load_moments(const YkDeriveForces *f, YkPage *page, YkLine *line, int32_t body, bool first)
{
    size_t count;
    const int32_t *pushes = yk_derive_pushes_on(f, body, &count);
    for (size_t k = 0; k < count; k++) {
        const YkDeriveLoad *load = &f->loads[pushes[k] / 2];
        size_t p = (size_t)pushes[k] % 2;
        const YkDerivePush *push = &load->push[p];
        if (has_moment(push)) {
            put_arm(f, page, line, body, yk_derive_load_point(f, load, p), p == 1, first);
            yk_derive_put_load(page, line, load, 0, true);
            first = false;
        }
        if (yk_ring_is_zero(push->moment)) continue;
        if (p == 1 || !first) yk_line_sign(page, line, p == 1 ? "-" : "+");
        yk_line_vector(page, line, "M", NULL, yk_derive_couple_name(f, load));
        first = false;
    }
    return first;
}

static void put_euler(const YkDeriveForces *f, YkPage *page, int32_t body)
{
    YkDerivation *d = f->d;
    YkLine *line = yk_page_formula(page, NULL);
    bool first = put_load_moments(f, page, line, body, put_contact_moments(f, page, line, body));
    put_zero_if_empty(page, line, first);
    yk_line_sign(page, line, "=");
    bool is_still = yk_ring_is_zero(f->bodies[body].inertia) || yk_ring_is_zero(d->bodies[body].spin_rate);
    put_zero_if_empty(page, line, is_still);
    if (is_still) return;
    yk_line_factor(page, line, f->bodies[body].inertia);
    yk_line_vector(page, line, "alpha", NULL, d->bodies[body].name);
}

// --- Scalar form: forces = inertia

static void put_scalar(YkPage *page, const char *remark, const YkPoisson *zero, const YkPoisson *inertia)
{
    yk_page_equation(page, remark, yk_ring_add(page->ring, zero, inertia), inertia, YK_RING_TEXTBOOK);
}

// Writes moments about the point at which a pin of the tree holds the body; the pin's force then has none.
static void put_about_joint(const YkDeriveForces *f, YkPage *page, int32_t body, const YkPoisson *newton,
                            const YkPoisson *euler)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    const YkDeriveMass *m = &f->bodies[body];
    int32_t joint = d->bodies[body].joint;
    int side = d->model->joints[joint].body[1] == body;
    const YkPoisson *arm = yk_derive_joint_arm((YkDeriveForces *)f, joint, side);
    if (d->model->joints[joint].kind != YK_PIN || yk_ring_is_zero(arm)) return;
    YkDerivePlace place = yk_derive_place(d, joint, side);
    const YkPoisson *zero = yk_ring_subtract(ring, euler, yk_ring_cross(ring, arm, newton));
    const YkPoisson *moved = yk_ring_multiply(ring, m->mass, yk_ring_cross(ring, arm, m->acceleration));
    const YkPoisson *inertia =
        yk_ring_subtract(ring, yk_ring_multiply(ring, m->inertia, d->bodies[body].spin_rate), moved);
    const char *about = yk_derive_text(d, "moments about ", yk_derive_point_name(d, body, place.point), "");
    const YkPoisson *left = yk_derive_shown(d, zero), *right = yk_derive_shown(d, inertia);
    put_scalar(page, about, left, right);
}

static void put_body(const YkDeriveForces *f, YkPage *page, int32_t body)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    const YkDeriveMass *m = &f->bodies[body];
    const YkPoisson *newton = yk_derive_newton(f, body), *euler = yk_derive_euler(f, body);
    const YkPoisson *inertia = yk_derive_shown(d, yk_ring_multiply(ring, m->mass, m->acceleration));
    const YkPoisson *forces = yk_derive_shown(d, newton);
    yk_page_heading(page, 2, d->model->bodies[body].name);
    put_newton(f, page, body);
    put_euler(f, page, body);
    yk_derive_put_step(f, page, body);
    const YkPoisson *x = yk_ring_real(ring, forces), *y = yk_ring_imaginary(ring, forces);
    put_scalar(page, "x", x, yk_ring_real(ring, inertia));
    put_scalar(page, "y", y, yk_ring_imaginary(ring, inertia));
    const YkPoisson *turning = yk_ring_multiply(ring, m->inertia, d->bodies[body].spin_rate);
    const char *about = yk_derive_text(d, "moments about ", yk_derive_center_name(d, body), "");
    const YkPoisson *left = yk_derive_shown(d, euler), *right = yk_derive_shown(d, turning);
    put_scalar(page, about, left, right);
    put_about_joint(f, page, body, newton, euler);
    if (f->bodies[body].is_trivial)
        yk_page_words(
            page,
            "All forces on %s meet in one point: its moment balance gives the moment of its guide and no more. "
            "Both are left out of the count.",
            d->model->bodies[body].name);
}

static void put_junctions(const YkDeriveForces *f, YkPage *page)
{
    YkDerivation *d = f->d;
    for (size_t k = 0; k < f->junction_count; k++) {
        const YkPoisson *force = yk_ring_negate(d->ring, f->junctions[k].force);
        yk_page_heading(page, 2, yk_derive_text(d, "Junction ", f->junctions[k].name, ""));
        yk_page_equation(page, "x", yk_ring_real(d->ring, force), NULL, YK_RING_TEXTBOOK);
        yk_page_equation(page, "y", yk_ring_imaginary(d->ring, force), NULL, YK_RING_TEXTBOOK);
    }
}

static void put_closing(const YkDeriveForces *f, YkPage *page)
{
    int count = yk_derive_closing_rows(f);
    if (count > 0)
        yk_page_heading(page, 2,
                        f->d->tie_count > 0 ? "Accelerations: loops stay closed, wheels and cams in touch"
                                            : "Accelerations: the loops stay closed");
    for (int k = 0; k < count; k++) yk_page_equation(page, f->closing_name[k], f->closing[k], NULL, YK_RING_TEXTBOOK);
    page->failed |= count < 0;
}

// --- The count

static void put_count(const YkDeriveForces *f, YkPage *page, bool all_given, const char *title)
{
    YkEquationCount c = yk_derive_count(f, all_given);
    yk_page_words(
        page,
        "%s: %z force + %z moment + %z acceleration = %z equations; %z reactions + %z accelerations + %z efforts "
        "= %z unknowns.",
        title, c.force, c.moment, c.acceleration, c.force + c.moment + c.acceleration, c.unknown_reactions,
        c.unknown_accelerations, c.unknown_efforts, c.unknown_reactions + c.unknown_accelerations + c.unknown_efforts);
}

static void put_unknowns(const YkDeriveForces *f, YkPage *page, const YkDeriveSystem *system)
{
    YkText text = {0};
    for (size_t k = 0; k < system->unknown_count; k++)
        yk_text_format(&text, "%s%s", k ? ", " : "", yk_ring_symbol_name(f->d->ring, system->unknowns[k]));
    yk_page_words(page, "Unknowns: %s.", yk_text_get(&text));
    page->failed |= text.failed;
    yk_text_free(&text);
}

static void put_counts(const YkDeriveForces *f, YkPage *page, const YkDeriveSystem *system)
{
    YkEquationCount given = yk_derive_count(f, true), as_filed = yk_derive_count(f, false);
    yk_page_heading(page, 2, "Count");
    put_count(f, page, true, "Inverse dynamics, all inputs given");
    if (given.unknown_efforts != as_filed.unknown_efforts) put_count(f, page, false, "Forward dynamics");
    put_unknowns(f, page, system);
    size_t unknowns = system->unknown_count, rows = system->row_count;
    if (rows < unknowns)
        yk_page_words(
            page,
            "%z unknowns more than equations: the machine is held more often than it needs, and reactions are "
            "not determined by these equations alone.",
            unknowns - rows);
}

// --- The matrix form

static void fill_matrix(const YkDeriveForces *f, const YkDeriveSystem *system, YkShownMatrix *A, YkShownMatrix *xi,
                        YkShownMatrix *b)
{
    for (size_t i = 0; i < system->row_count; i++) {
        A->row_labels[i] = system->labels[i];
        b->entries[i] = yk_derive_system_row(f, system, i, A->entries + i * system->unknown_count);
    }
    for (size_t k = 0; k < system->unknown_count; k++) {
        xi->entries[k] = yk_ring_of(f->d->ring, system->unknowns[k]);
        A->column_symbols[k] = system->unknowns[k];
    }
}

static void put_system(const YkDeriveForces *f, YkPage *page, const YkDeriveSystem *system)
{
    yk_page_heading(page, 2, "Matrix form");
    YkLine *line = yk_page_formula(page, "A xi = b");
    YkShownMatrix *A = yk_line_matrix(page, line, system->row_count, system->unknown_count);
    YkShownMatrix *xi = yk_line_matrix(page, line, system->unknown_count, 1);
    yk_line_sign(page, line, "=");
    YkShownMatrix *b = yk_line_matrix(page, line, system->row_count, 1);
    if (!A || !xi || !b) return;
    A->target = "A", b->target = "b";
    A->code_remark = "A xi = b, the unknowns xi";
    for (size_t k = 0; k < system->unknown_count; k++)
        A->code_remark = yk_derive_text(f->d, A->code_remark, k ? ", " : " = ",
                                        yk_ring_symbol_name(f->d->ring, system->unknowns[k]));
    fill_matrix(f, system, A, xi, b);
}

bool yk_derive_section_newton_euler(YkDerivation *d, YkPage *page)
{
    const YkDeriveForces *f = yk_derive_forces(d);
    YkDeriveSystem system;
    if (!f) return false;
    yk_derive_put_angles(d, page);
    yk_derive_put_meshes(f, page);
    for (size_t b = 1; b < yk_model_body_count(d->model); b++) put_body(f, page, (int32_t)b);
    put_junctions(f, page);
    put_closing(f, page);
    if (!yk_derive_system_size(f, &system)) return false;
    put_counts(f, page, &system);
    if (system.row_count == 0 || system.row_count > ROWS_SHOWN_MAX) return true;
    if (!yk_derive_system(f, &system)) return false;
    put_system(f, page, &system);
    return true;
}
