// Part of the section on Lagrange's equations: why Newton and Euler say the same.
//
// The joints' forces do no work on motions that the joints allow. So the sum over the bodies of (forces - m a) . dv/du
// and (moments - I alpha) dw/du, with u the rate of a coordinate, does not contain the reactions of the tree's joints,
// and is Lagrange's equation. It keeps the forces of joints that close loops: these are the multipliers.
#include "derive/forces/lagrange.h"

enum { SUMS_SHOWN_MAX = 24, PROVED_MAX = 100 };

// Rows in the axes of a turning body change with its angle also by F x (the loop's sum), which is 0 once the loop is
// closed. Returns what that adds to a coordinate's equation.
static const YkPoisson *by_open_loops(const YkDeriveForces *f, int32_t position)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    const YkPoisson *sum = yk_ring_rational(ring, 0, 1);
    const YkPoisson *const *is = yk_derive_multipliers(f)->identities;
    for (size_t k = 0; k < d->loop_count; k++) {
        const YkDeriveLoop *loop = &d->loops[k];
        const YkDeriveBody *axes = &d->bodies[loop->axes];
        if (axes->angle != YK_NONE && axes->angle == position) {
            const YkPoisson *force = yk_ring_add(ring, is[0], yk_ring_multiply(ring, yk_ring_i(ring), is[1]));
            force = yk_ring_multiply(ring, axes->unit, force);
            sum = yk_ring_add(ring, sum, yk_ring_cross(ring, force, loop->path.sum));
        }
        is += loop->angle ? 3 : 2;
    }
    return sum;
}

bool yk_derive_do_methods_agree(const YkDeriveForces *f, size_t coordinate)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    const YkDeriveMultipliers *m = yk_derive_multipliers(f);
    YkRingChange *changes = YK_NEW(d->arena, YkRingChange, m->count + 1);
    if (!changes) return false;
    for (size_t k = 0; k < m->count; k++) changes[k] = (YkRingChange){m->symbols[k], m->identities[k], NULL};
    YkDeriveLagrange sides = yk_derive_lagrange(f, coordinate);
    yk_ring_begin_passing(ring);
    const YkPoisson *lagrange = yk_ring_subtract(ring, sides.left, sides.right);
    if (m->count > 0) lagrange = yk_ring_substitute(ring, lagrange, changes, m->count);
    lagrange = yk_ring_subtract(ring, lagrange, by_open_loops(f, yk_derive_freedom(d, coordinate).position));
    bool agree = yk_derive_is_nothing(f, yk_ring_add(ring, lagrange, yk_derive_projected(f, coordinate)));
    yk_ring_end_passing(ring, NULL);
    return agree;
}

// Returns how a body turns with a coordinate as it is shown: 1, -1 or 0.
static int32_t turning(const YkDeriveForces *f, int32_t body, size_t coordinate, int32_t *B)
{
    const YkDerivation *d = f->d;
    YkDeriveFreedom freedom = yk_derive_freedom(d, coordinate);
    if (freedom.body == YK_NONE) return 0;
    if (!yk_derive_shows_joints(d)) return d->bodies[body].angle == freedom.position;
    yk_derive_combination(d, body, B);
    return B[coordinate];
}

static void put_term(YkPage *page, YkLine *line, const YkPoisson *factor, bool *first, bool is_negative)
{
    if (is_negative || !*first) yk_line_sign(page, line, is_negative ? "-" : "+");
    yk_line_factor(page, line, factor);
    *first = false;
}

static void put_sum(const YkDeriveForces *f, YkPage *page, size_t coordinate, int32_t *B)
{
    YkDerivation *d = f->d;
    int32_t symbol =
        yk_derive_shows_joints(d) ? d->coordinates[coordinate].rate : yk_derive_freedom(d, coordinate).rate;
    const char *rate = yk_ring_symbol_name(d->ring, symbol);
    YkLine *line = yk_page_formula(page, d->coordinates[coordinate].name);
    bool first = true;
    for (size_t b = 1; b < yk_model_body_count(d->model); b++) {
        const YkDeriveMass *m = &f->bodies[b];
        const char *center = yk_derive_center_name(d, (int32_t)b);
        int32_t turn = turning(f, (int32_t)b, coordinate, B);
        if (!yk_ring_is_zero(m->mass) && yk_ring_mentions(d->ring, yk_derive_shown(d, m->velocity), symbol)) {
            put_term(page, line, m->mass, &first, false);
            yk_line_vector(page, line, "a", center, NULL);
            yk_line_sign(page, line, ".");
            yk_line_words(page, line, yk_derive_text(d, "dv(", center, yk_derive_text(d, ")/d(", rate, ")")));
        }
        if (turn == 0 || yk_ring_is_zero(m->inertia)) continue;
        put_term(page, line, m->inertia, &first, turn < 0);
        yk_line_vector(page, line, "alpha", NULL, d->bodies[b].name);
    }
    if (first) yk_line_sign(page, line, "0");
    yk_line_sign(page, line, "=");
    yk_line_words(page, line, "work of the loads and of the loops' joints");
}

// Returns whether a loop has its rows in the axes of a body that turns.
static bool has_turning_axes(const YkDerivation *d)
{
    for (size_t k = 0; k < d->loop_count; k++)
        if (d->bodies[d->loops[k].axes].angle != YK_NONE) return true;
    return false;
}

void yk_derive_put_projection(const YkDeriveForces *f, YkPage *page)
{
    YkDerivation *d = f->d;
    size_t proved = 0;
    int32_t *B = YK_NEW(page->arena, int32_t, d->tree_count + 1);
    if (!B) return;
    yk_page_heading(page, 2, "Newton-Euler, projected");
    yk_page_words(
        page, "Forces of joints do no work on motions that the joints allow: multiplied by the partial velocities and "
              "summed over the bodies, Newton's and Euler's equations lose them and are Lagrange's.");
    if (d->tree_count > PROVED_MAX) {
        yk_page_words(page, "Not proved here: the time for it grows with the square of the %z coordinates.",
                      d->tree_count);
        return;
    }
    for (size_t k = 0; k < d->tree_count && d->tree_count <= SUMS_SHOWN_MAX; k++) put_sum(f, page, k, B);
    for (size_t k = 0; k < d->coordinate_count; k++) proved += yk_derive_do_methods_agree(f, k);
    if (proved == d->coordinate_count)
        yk_page_words(page, "Proved: %sboth are the same, term by term, so both give the same accelerations.",
                      has_turning_axes(d) ? "with the loops closed " : "");
    else
        yk_page_words(page, "Proved for %z of %z coordinates; for the others it could not be proved here.", proved,
                      d->coordinate_count);
}
