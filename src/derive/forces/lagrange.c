// Section: Lagrange's equations, with multipliers for loops; mass matrix; lumped constants; the link to Newton and
// Euler.
#include "derive/forces/lagrange.h"
#include "derive/printed_code.h"
#include "derive/sections.h"

enum { COORDINATES_SHOWN_MAX = 24, LUMPED_MAX = 12 };

static void put_multipliers(const YkDeriveForces *f, YkPage *page)
{
    YkDerivation *d = f->d;
    const YkDeriveMultipliers *m = yk_derive_multipliers(f);
    if (m->count == 0) return;
    yk_page_heading(page, 2, "Multipliers");
    if (d->loop_count > 0)
        yk_page_words(
            page, "Every scalar equation of a loop has a multiplier, M q'' + h + J^T lambda = Q. It is the force that "
                  "the joint's first body exerts on its second (of an angle: the second on the first).");
    if (d->tie_count > 0)
        yk_page_words(
            page, "Every gear, rack, belt, cam and law has a multiplier%s: minus what it transmits, times its lever.",
            d->loop_count > 0 ? ", too" : ", M q'' + h + J^T lambda = Q");
    for (size_t k = 0; k < m->count; k++) {
        const YkPoisson *lambda = yk_ring_of(d->ring, m->symbols[k]);
        YkLine *line = yk_page_equation(page, yk_derive_row_name(f, k), lambda, yk_derive_shown(d, m->identities[k]),
                                        YK_RING_TEXTBOOK);
        if (line) line->value = lambda;
    }
}

static const char *name_of(const YkDeriveForces *f, size_t coordinate)
{
    YkDerivation *d = f->d;
    if (yk_derive_shows_joints(d) || d->coordinates[coordinate].is_distance) return d->coordinates[coordinate].name;
    return yk_ring_symbol_name(d->ring, yk_derive_freedom(d, coordinate).position);
}

// Writes left = M q'' + h + J^T lambda.
static void put_matrices(const YkDeriveForces *f, YkPage *page, const YkDeriveLagrange *equations)
{
    YkDerivation *d = f->d;
    const YkDeriveMultipliers *m = yk_derive_multipliers(f);
    size_t n = d->tree_count;
    YkLine *mass = yk_page_formula(page, m->count ? "M q'' + h + J^T lambda = Q" : "M q'' + h = Q");
    yk_line_vector(page, mass, "M", NULL, NULL);
    yk_line_sign(page, mass, "=");
    YkShownMatrix *M = yk_line_matrix(page, mass, n, n);
    YkLine *rest = yk_page_formula(page, NULL);
    yk_line_vector(page, rest, "h", NULL, NULL);
    yk_line_sign(page, rest, "=");
    YkShownMatrix *h = yk_line_matrix(page, rest, n, 1);
    if (!M || !h) return;
    M->target = "M", M->build = yk_derive_build_mass;
    h->target = "h", h->build = yk_derive_build_rest;
    M->build_context = h->build_context = (void *)f;
    M->code_remark = "M q'' + h, the coordinates q";
    for (size_t k = 0; k < n; k++)
        M->code_remark = yk_derive_text(d, M->code_remark, k ? ", " : " = ", d->coordinates[k].name);
    int32_t *symbols = YK_NEW(d->arena, int32_t, n + m->count + 1); // accelerations, multipliers
    if (!symbols) return;
    for (size_t k = 0; k < n; k++) symbols[k] = M->column_symbols[k] = yk_derive_shown_acceleration(d, k);
    for (size_t k = 0; k < m->count; k++) symbols[n + k] = m->symbols[k];
    for (size_t i = 0; i < n; i++) {
        M->row_labels[i] = h->row_labels[i] = name_of(f, i);
        h->entries[i] = yk_ring_split(d->ring, equations[i].left, symbols, n + m->count, M->entries + i * n, n);
    }
}

static YkDeriveLagrange *all_equations(const YkDeriveForces *f, YkPage *page)
{
    YkDerivation *d = f->d;
    bool in_joints = yk_derive_shows_joints(d);
    YkDeriveLagrange *equations = YK_NEW(page->arena, YkDeriveLagrange, d->coordinate_count + 1);
    for (size_t k = 0; equations && k < d->coordinate_count; k++)
        equations[k] = in_joints ? yk_derive_lagrange_of(f, k) : yk_derive_lagrange(f, k);
    if (!equations) page->failed = true;
    return equations;
}

bool yk_derive_section_lagrange(YkDerivation *d, YkPage *page)
{
    if (yk_derive_put_depth(d, page)) return true;
    if (d->coordinate_count > YK_DERIVE_TOGETHER_MAX) {
        yk_page_words(
            page,
            "Lagrange's equations of %z coordinates are not written: each contains the energy of all. Ask for "
            "free-bodies and newton-euler, which go from body to body.",
            d->coordinate_count);
        return true;
    }
    const YkDeriveForces *f = yk_derive_forces(d);
    YkDeriveLagrange *equations = f ? all_equations(f, page) : NULL;
    if (!equations) return false;
    yk_page_words(page, "d/dt (dL/dq') - dL/dq = Q for every coordinate q, with dampers and multipliers.");
    yk_derive_put_angles(d, page);
    yk_derive_put_meshes(f, page);
    for (size_t k = 0; k < d->coordinate_count; k++) {
        yk_page_equation(page, name_of(f, k), equations[k].left, equations[k].right, YK_RING_TEXTBOOK);
    }
    put_multipliers(f, page);
    if (d->tree_count <= COORDINATES_SHOWN_MAX) {
        yk_page_heading(page, 2, "Mass matrix");
        put_matrices(f, page, equations);
    }
    if (d->tree_count <= LUMPED_MAX) yk_derive_put_lumps(f, page, equations, d->coordinate_count);
    yk_derive_put_projection(f, page);
    return true;
}
