// Section: velocities, block by block: unknown rates from earlier ones, the rates of bodies, influence coefficients.
#include <stdlib.h>
#include "derive/blocks.h"
#include "derive/motion.h"
#include "derive/sections.h"

enum { BLOCK_SHOWN_MAX = 40 };

// Returns row r of a block without its unknowns: - sum of J * (rate or acceleration) over all earlier coordinates.
// Added up at once: sums on the way there would be kept, and in a long loop come to the square of what is wanted.
static const YkPoisson *known_side(YkDerivation *d, const YkDeriveBlock *block, const YkDeriveRow *row,
                                   bool accelerations)
{
    size_t count = 0;
    const YkPoisson **parts = yk_derive_scratch(d, row->count + 1, sizeof *parts), *sum = NULL;
    for (size_t k = 0; parts && k < row->count; k++) {
        const YkDeriveCoordinate *c = &d->coordinates[row->columns[k]];
        const YkPoisson *entry = row->entries[k];
        int32_t of = d->blocks->block_of[row->columns[k]];
        bool is_known = of == YK_NONE || d->blocks->blocks[of].first_column < block->first_column;
        if (!is_known || yk_ring_is_zero(entry)) continue;
        parts[count++] =
            yk_ring_multiply(d->ring, entry, yk_ring_of(d->ring, accelerations ? c->acceleration : c->rate));
    }
    if (parts) sum = yk_ring_negate(d->ring, yk_ring_sum(d->ring, parts, count));
    free((void *)parts);
    return sum;
}

const YkPoisson *yk_derive_gamma(YkDerivation *d, YkDeriveRow *row)
{
    YkRing *ring = d->ring;
    int32_t *accelerations = row->gamma ? NULL : YK_NEW(d->arena, int32_t, row->count + 1);
    if (!accelerations) return row->gamma;
    for (size_t k = 0; k < row->count; k++) accelerations[k] = d->coordinates[row->columns[k]].acceleration;
    const YkPoisson *second = yk_ring_time_derivative(ring, yk_ring_time_derivative(ring, row->value));
    row->gamma = yk_ring_negate(ring, yk_ring_split(ring, second, accelerations, row->count, NULL, 0));
    return row->gamma;
}

// Finds determinant * unknown = over[unknown], for rates or accelerations, from earlier ones. Returns false if the
// block is not solved.
static bool solve_block(YkDerivation *d, const YkDeriveBlock *block, bool accelerations, const YkPoisson **over)
{
    const YkPoisson *right[YK_CRAMER_MAX];
    if (!yk_derive_is_solved(block)) return false;
    for (size_t i = 0; i < block->row_count; i++) {
        YkDeriveRow *row = &d->blocks->rows[d->blocks->row_order[block->first_row + i]];
        right[i] = known_side(d, block, row, accelerations);
        if (accelerations) right[i] = yk_ring_add(d->ring, right[i], yk_derive_gamma(d, row));
    }
    for (size_t k = 0; k < block->column_count; k++) over[k] = yk_derive_cramer(d, block, k, right);
    return true;
}

// Writes the block as a linear system: J_b u' = right side.
static void put_system(YkDerivation *d, YkPage *page, const YkDeriveBlock *block, bool accelerations)
{
    size_t n = block->row_count, m = block->column_count;
    if (n > BLOCK_SHOWN_MAX) {
        yk_page_words(page, "A group of %z equations that are solved together: too many to be written as a matrix.", n);
        return;
    }
    YkLine *line = yk_page_formula(page, yk_derive_block_name(d, block));
    YkShownMatrix *A = yk_line_matrix(page, line, n, m), *x = yk_line_matrix(page, line, m, 1);
    yk_line_sign(page, line, "=");
    YkShownMatrix *b = yk_line_matrix(page, line, n, 1);
    if (!A || !x || !b) return;
    for (size_t k = 0; k < m; k++) {
        const YkDeriveCoordinate *c = &d->coordinates[d->blocks->column_order[block->first_column + k]];
        x->entries[k] = yk_ring_of(d->ring, accelerations ? c->acceleration : c->rate);
    }
    for (size_t i = 0; i < n; i++) {
        YkDeriveRow *row = &d->blocks->rows[d->blocks->row_order[block->first_row + i]];
        for (size_t k = 0; k < m; k++)
            A->entries[m * i + k] = yk_derive_entry(d, row, d->blocks->column_order[block->first_column + k]);
        b->entries[i] = known_side(d, block, row, accelerations);
        if (accelerations) b->entries[i] = yk_ring_add(d->ring, b->entries[i], yk_derive_gamma(d, row));
    }
}

// --- Rates of bodies: sum of B[k] rate_k, over the determinant of the last block among them.

static bool has_own_angle(const YkDerivation *d, int32_t body)
{
    const YkDeriveBody *b = &d->bodies[body];
    if (b->joint == YK_NONE || d->joint_angle[b->joint] == YK_NONE) return false;
    return b->angle != d->coordinates[d->joint_angle[b->joint]].position;
}

// Returns determinant * (a body's rate or acceleration) if this block is the last that it needs; otherwise NULL.
static const YkPoisson *body_over(YkDerivation *d, int32_t body, size_t block, const YkPoisson *const *over,
                                  bool accelerations)
{
    YkRing *ring = d->ring;
    const YkDeriveBlock *last = &d->blocks->blocks[block];
    if (d->blocks->last_of[body] != (int32_t)block) return NULL;
    size_t count = 0;
    const YkPoisson **parts = yk_derive_scratch(d, (size_t)d->most_depth + 1, sizeof *parts), *sum = NULL;
    for (; parts && d->bodies[body].parent != YK_NONE; body = d->bodies[body].parent) {
        int32_t joint = d->bodies[body].joint, c = d->joint_angle[joint];
        if (c == YK_NONE) continue;
        const YkDeriveCoordinate *of = &d->coordinates[c];
        const YkPoisson *share =
            yk_ring_multiply(ring, last->determinant, yk_ring_of(ring, accelerations ? of->acceleration : of->rate));
        for (size_t k = 0; k < last->column_count; k++)
            if (d->blocks->column_order[last->first_column + k] == c) share = over[k];
        bool forwards = d->model->joints[joint].body[1] == body;
        parts[count++] = forwards ? share : yk_ring_negate(ring, share);
    }
    if (parts) sum = yk_ring_sum(ring, parts, count);
    free((void *)parts);
    return sum;
}

// Writes the rates or accelerations of the bodies for which this block is the last that they need.
static void put_bodies(YkDerivation *d, YkPage *page, size_t block, const YkPoisson *const *over, bool accelerations)
{
    for (int32_t b = d->blocks->first_body[block]; b != YK_NONE; b = d->blocks->next_body[b]) {
        if (!has_own_angle(d, b)) continue;
        const YkPoisson *sum = body_over(d, b, block, over, accelerations);
        if (!sum) continue;
        int32_t symbol = accelerations ? d->bodies[b].acceleration : d->bodies[b].rate;
        yk_page_solution(page, d->model->bodies[b].name, symbol, sum, d->blocks->blocks[block].determinant);
    }
}

void yk_derive_put_solutions(YkDerivation *d, YkPage *page, bool accelerations)
{
    const YkDeriveBlocks *blocks = d->blocks;
    for (size_t b = 0; b < blocks->block_count; b++) {
        const YkDeriveBlock *block = &blocks->blocks[b];
        const YkPoisson *over[YK_CRAMER_MAX];
        yk_page_heading(page, 2, yk_derive_block_name(d, block));
        if (!solve_block(d, block, accelerations, over)) {
            put_system(d, page, block, accelerations);
            continue;
        }
        for (size_t k = 0; k < block->column_count; k++) {
            const YkDeriveCoordinate *c = &d->coordinates[blocks->column_order[block->first_column + k]];
            yk_page_solution(page, NULL, accelerations ? c->acceleration : c->rate, over[k], block->determinant);
        }
        put_bodies(d, page, b, over, accelerations);
    }
}

// --- Influence coefficients of a machine with one input: unknown' / input', each from those before.

// Enters symbols k_theta2 for theta2' / theta1'; changes[] takes a rate to its coefficient.
static bool enter_coefficients(YkDerivation *d)
{
    YkText name = {0};
    bool well = true;
    const YkDeriveBlocks *blocks = d->blocks;
    d->influence = YK_NEW(d->arena, int32_t, d->coordinate_count + 1);
    if (!d->influence) return false;
    for (size_t k = 0; k < blocks->column_count && well; k++) {
        int32_t c = blocks->column_order[k];
        yk_text_clear(&name);
        yk_text_format(&name, "k_%s", d->coordinates[c].name);
        d->influence[c] = k < blocks->input_count ? -1 : yk_derive_symbol(d, yk_text_get(&name), YK_RING_FUNCTION);
        well = k < blocks->input_count || d->influence[c] >= 0;
    }
    yk_text_free(&name);
    return well;
}

static void fill_coefficients(void *context, const YkState *state, YkDynamics *dynamics, double *values)
{
    YkDerivation *d = context;
    (void)state, (void)dynamics;
    double input = values[d->coordinates[d->blocks->column_order[0]].rate];
    for (size_t k = 1; k < d->blocks->column_count; k++) {
        int32_t c = d->blocks->column_order[k];
        values[d->influence[c]] = input != 0 ? values[d->coordinates[c].rate] / input : 0;
    }
}

static void put_influence(YkDerivation *d, YkPage *page)
{
    const YkDeriveBlocks *blocks = d->blocks;
    if (!d->influence && (!enter_coefficients(d) || !yk_derive_add_source(d, fill_coefficients, d))) return;
    YkRingChange *changes = YK_NEW(page->arena, YkRingChange, blocks->column_count + 1);
    if (!changes) return;
    const YkDeriveCoordinate *input = &d->coordinates[blocks->column_order[0]];
    yk_page_heading(page, 2, "Influence coefficients");
    yk_page_words(page, "k_x stands for x' / %s'.", input->name);
    for (size_t k = 0; k < blocks->column_count; k++) {
        int32_t c = blocks->column_order[k];
        const YkPoisson *value = k == 0 ? yk_ring_rational(d->ring, 1, 1) : yk_ring_of(d->ring, d->influence[c]);
        changes[k] = (YkRingChange){d->coordinates[c].rate, value, NULL};
    }
    YkRingChanges *to_influence = yk_ring_changes(d->ring, changes, blocks->column_count);
    for (size_t b = 0; b < blocks->block_count; b++) {
        const YkDeriveBlock *block = &blocks->blocks[b];
        const YkPoisson *over[YK_CRAMER_MAX];
        if (!solve_block(d, block, false, over)) continue;
        for (size_t k = 0; k < block->column_count; k++) {
            const YkPoisson *sum = yk_ring_change(d->ring, over[k], to_influence);
            yk_page_solution(page, NULL, d->influence[blocks->column_order[block->first_column + k]], sum,
                             block->determinant);
        }
    }
}

bool yk_derive_section_velocity(YkDerivation *d, YkPage *page)
{
    const YkDeriveBlocks *blocks = yk_derive_blocks(d);
    if (!blocks) return false;
    if (blocks->block_count == 0) yk_page_words(page, "No loop ties the rates of the coordinates to each other.");
    yk_derive_put_solutions(d, page, false);
    if (blocks->input_count == 1 && blocks->block_count > 0) put_influence(d, page);
    return true;
}
