// Section: accelerations. J q'' = gamma, sliding pairs with their Coriolis terms, then block by block.
#include "derive/motion.h"
#include "derive/sections.h"

enum { ROWS_SHOWN_MAX = 24 };

static void put_gamma(YkDerivation *d, YkPage *page)
{
    const YkDeriveBlocks *blocks = d->blocks;
    YkLine *line = yk_page_formula(page, "J q'' = gamma");
    yk_line_vector(page, line, "gamma", NULL, NULL);
    yk_line_sign(page, line, "=");
    YkShownMatrix *column = yk_line_matrix(page, line, blocks->row_count, 1);
    if (!column) return;
    for (size_t i = 0; i < blocks->row_count; i++)
        column->entries[i] = yk_derive_gamma(d, &blocks->rows[blocks->row_order[i]]);
    column->target = "gamma_";
}

// a(A) = a(A1) + Coriolis + relative; a(A1) = a(origin of the guide, if it moves) + tangential + centripetal.
static void put_sum_of_parts(YkDerivation *d, YkPage *page, int32_t guide, const char *point)
{
    YkText first = {0};
    yk_text_format(&first, "%s1", point);
    YkLine *sum = yk_page_formula(page, NULL);
    yk_line_vector(page, sum, "a", point, NULL);
    yk_line_sign(page, sum, "=");
    yk_line_vector(page, sum, "a", yk_text_get(&first), NULL);
    yk_line_sign(page, sum, "+");
    yk_line_vector(page, sum, "a", NULL, "Coriolis");
    yk_line_sign(page, sum, "+");
    yk_line_vector(page, sum, "a", NULL, "relative");
    sum = yk_page_formula(page, NULL);
    yk_line_vector(page, sum, "a", yk_text_get(&first), NULL);
    yk_line_sign(page, sum, "=");
    if (!yk_ring_is_zero(yk_ring_time_derivative(d->ring, yk_derive_origin(d, guide)))) {
        yk_line_vector(page, sum, "a", yk_derive_point_name(d, guide, YK_NONE), NULL);
        yk_line_sign(page, sum, "+");
    }
    yk_line_vector(page, sum, "a", NULL, "tangential");
    yk_line_sign(page, sum, "+");
    yk_line_vector(page, sum, "a", NULL, "centripetal");
    page->failed |= first.failed;
    yk_text_free(&first);
}

// Writes a body that slides on one that turns: a(point) = a(the place it slides over) + Coriolis + relative.
static void put_sliding(YkDerivation *d, YkPage *page, int32_t joint)
{
    YkRing *ring = d->ring;
    const YkJoint *j = &d->model->joints[joint];
    const YkDeriveCoordinate *c = &d->coordinates[d->joint_distance[joint]];
    const YkDeriveBody *guide = &d->bodies[j->body[0]];
    YkDerivePlace to = yk_derive_place(d, joint, 1), from = yk_derive_place(d, joint, 0);
    const char *point = yk_derive_point_name(d, to.body, to.point), *on = d->model->bodies[j->body[0]].name;
    const YkPoisson *line = yk_derive_in_joints(d, yk_ring_multiply(ring, guide->unit, yk_derive_along(d, joint)));
    const YkPoisson *spin = yk_derive_in_joints(d, guide->spin), *turning = yk_derive_in_joints(d, guide->spin_rate);
    const YkPoisson *quarter = yk_ring_multiply(ring, yk_ring_i(ring), line), *rate = yk_ring_of(ring, c->rate);
    const YkPoisson *slid = yk_derive_slide(d, joint), *at = yk_derive_at(d, from.point);
    const YkPoisson *arm = yk_derive_in_joints(d, yk_ring_add(ring, slid, yk_ring_multiply(ring, guide->unit, at)));
    YkText title = {0};
    yk_text_format(&title, "%s slides on %s (%s)", d->model->bodies[j->body[1]].name, on, j->name);
    yk_page_heading(page, 2, yk_text_get(&title));
    yk_text_free(&title);
    yk_page_words(page, "%s1 is the point of %s that coincides with %s.", point, on, point);
    put_sum_of_parts(d, page, j->body[0], point);
    const YkPoisson *square = yk_ring_power(ring, spin, 2);
    const struct {
        const char *name;
        const YkPoisson *value;
    } parts[] = {
        {"tangential", yk_ring_product(ring, (const YkPoisson *[]){turning, yk_ring_i(ring), arm}, 3)},
        {"centripetal", yk_ring_negate(ring, yk_ring_multiply(ring, square, arm))},
        {"Coriolis", yk_ring_scale(ring, yk_ring_product(ring, (const YkPoisson *[]){spin, rate, quarter}, 3), 2, 1)},
        {"relative", yk_ring_multiply(ring, yk_ring_of(ring, c->acceleration), line)},
    };
    for (size_t k = 0; k < 4; k++) {
        YkLine *part = yk_page_formula(page, NULL);
        yk_line_vector(page, part, "a", NULL, parts[k].name);
        yk_line_sign(page, part, "=");
        yk_line_column(page, part, parts[k].value, NULL);
    }
}

static void put_slidings(YkDerivation *d, YkPage *page)
{
    for (size_t j = 0; j < d->model->joint_count; j++)
        if (d->joint_distance[j] != YK_NONE && d->bodies[d->model->joints[j].body[0]].angle != YK_NONE)
            put_sliding(d, page, (int32_t)j);
}

bool yk_derive_section_acceleration(YkDerivation *d, YkPage *page)
{
    const YkDeriveBlocks *blocks = yk_derive_blocks(d);
    if (!blocks) return false;
    if (blocks->row_count == 0) yk_page_words(page, "No loop ties the accelerations of the coordinates to each other.");
    if (blocks->row_count > 0 && blocks->row_count <= ROWS_SHOWN_MAX) put_gamma(d, page);
    put_slidings(d, page);
    yk_derive_put_solutions(d, page, true);
    return true;
}
