// Section: loop equations, as sums of named vectors and in x and y.
#include "derive/blocks.h"
#include "derive/relations.h"
#include "derive/sections.h"

static const char *joined(YkPage *page, const char *head, const char *tail)
{
    YkText text = {0};
    yk_text_format(&text, "%s/%s", head, tail);
    const char *copy = yk_arena_copy(page->arena, yk_text_get(&text), text.length);
    page->failed |= !copy;
    yk_text_free(&text);
    return copy ? copy : "";
}

static void put_vector(YkPage *page, YkLine *line, const YkDeriveVector *v, bool first)
{
    if (v->is_negative)
        yk_line_sign(page, line, "-");
    else if (!first)
        yk_line_sign(page, line, "+");
    yk_line_vector(page, line, "p", joined(page, v->head, v->tail), NULL);
}

// Writes p^{A/O1} + ... - p^{...}, sums first.
static void put_path(YkPage *page, YkLine *line, const YkDerivePath *path)
{
    size_t put = 0;
    for (int negative = 0; negative < 2; negative++) // sums first
        for (size_t k = 0; k < path->count; k++)
            if (path->vectors[k].is_negative == (negative == 1)) put_vector(page, line, &path->vectors[k], put++ == 0);
    if (put == 0) yk_line_sign(page, line, "0");
}

// Defines each named vector once: the body in which it is fixed, and its components there.
static void define_vectors(YkDerivation *d, YkPage *page)
{
    YkNames seen = {0};
    for (size_t l = 0; l < d->loop_count; l++)
        for (size_t k = 0; k < d->loops[l].path.count; k++) {
            const YkDeriveVector *v = &d->loops[l].path.vectors[k];
            const char *name = joined(page, v->head, v->tail);
            int32_t other;
            if (!yk_names_add(&seen, name, 1, &other)) page->failed = true;
            if (other != YK_NONE) continue;
            YkLine *line = yk_page_formula(page, d->model->bodies[v->body].name);
            const YkPoisson *value = yk_derive_in_joints(d, v->value);
            yk_line_vector(page, line, "p", name, NULL);
            yk_line_sign(page, line, "=");
            yk_line_column(page, line, value, NULL);
        }
    yk_names_free(&seen);
}

static void put_scalar_rows(YkDerivation *d, YkPage *page, const YkDeriveLoop *loop)
{
    static const char *const remarks[] = {"x", "y"};
    for (int part = 0; part < 2; part++) {
        const YkPoisson *row = part ? yk_ring_imaginary(d->ring, loop->sum) : yk_ring_real(d->ring, loop->sum);
        YkLine *line = yk_page_equation(page, remarks[part], row, NULL, YK_RING_TEXTBOOK);
        if (!line) continue;
        line->over = row;
        line->target = "Phi";
    }
    if (!loop->angle) return;
    YkLine *line = yk_page_equation(page, "angle", loop->angle, NULL, YK_RING_TEXTBOOK);
    if (line) line->over = loop->angle, line->target = "Phi";
}

static void put_loop(YkDerivation *d, YkPage *page, const YkDeriveLoop *loop)
{
    const YkJoint *j = &d->model->joints[loop->joint];
    YkText title = {0};
    yk_text_format(&title, "Loop closed by %s (%s - %s)", j->name, d->model->bodies[j->body[0]].name,
                   d->model->bodies[j->body[1]].name);
    yk_page_heading(page, 2, yk_text_get(&title));
    page->failed |= title.failed;
    yk_text_free(&title);
    YkLine *line = yk_page_formula(page, NULL);
    put_path(page, line, &loop->path);
    yk_line_sign(page, line, "=");
    yk_line_sign(page, line, "0");
    if (loop->axes != 0) yk_page_words(page, "in the axes of %s:", d->model->bodies[loop->axes].name);
    put_scalar_rows(d, page, loop);
}

// --- Conditions of slides and pin-slots: the distance from the line is zero, and for a slide the angle is fixed.
static void put_constraint(YkDerivation *d, YkPage *page, int32_t joint)
{
    const YkJoint *j = &d->model->joints[joint];
    YkDerivePlace from = yk_derive_place(d, joint, 0), to = yk_derive_place(d, joint, 1);
    const char *head = yk_derive_point_name(d, to.body, to.point),
               *tail = yk_derive_point_name(d, from.body, from.point), *name = joined(page, head, tail);
    YkText words = {0};
    yk_text_format(&words, "%s", j->name);
    YkLine *line = yk_page_formula(page, yk_text_get(&words));
    yk_text_free(&words);
    const YkPoisson *along = yk_ring_multiply(d->ring, d->bodies[j->body[0]].unit, yk_derive_along(d, joint));
    yk_line_vector(page, line, "p", name, NULL);
    yk_line_sign(page, line, "=");
    yk_line_element(page, line, yk_derive_distance(d, joint), YK_RING_TEXTBOOK);
    yk_line_vector(page, line, "e", NULL, j->name);
    yk_line_sign(page, line, ",");
    yk_line_vector(page, line, "e", NULL, j->name);
    yk_line_sign(page, line, "=");
    yk_line_column(page, line, yk_derive_in_joints(d, along), NULL);
    if (line) line->value = yk_derive_in_joints(d, yk_derive_slide(d, joint));
    YkLine *second = yk_page_formula(page, j->name);
    yk_line_vector(page, second, "e", NULL, j->name);
    yk_line_sign(page, second, "x");
    yk_line_vector(page, second, "p", name, NULL);
    yk_line_sign(page, second, "=");
    yk_line_sign(page, second, "0");
    if (yk_part(j->kind)->turns) return;
    yk_page_words(page, "%s turns with %s.", d->model->bodies[j->body[1]].name, d->model->bodies[j->body[0]].name);
}

static void put_constraints(YkDerivation *d, YkPage *page)
{
    bool any = false;
    for (size_t j = 0; j < d->model->joint_count; j++) {
        if (d->joint_distance[j] == YK_NONE || d->model->joints[j].is_free) continue;
        if (!any) yk_page_heading(page, 2, "Slides and slots");
        any = true;
        put_constraint(d, page, (int32_t)j);
    }
}

// --- Conditions of gears and other relations
static void put_ties(YkDerivation *d, YkPage *page)
{
    static const char *const kinds[] = {"gear", "rack", "belt", "cam", "law"};
    if (d->tie_count > 0) yk_page_heading(page, 2, "Gears, belts, racks, cams");
    for (size_t k = 0; k < d->tie_count; k++) {
        const YkDeriveRelation *tie = &d->ties[k];
        YkText remark = {0};
        yk_text_format(&remark, "%s %s", kinds[tie->kind], tie->name);
        YkLine *line = yk_page_equation(page, yk_text_get(&remark), tie->value, NULL, YK_RING_TEXTBOOK);
        if (line) line->over = tie->value, line->target = "Phi";
        yk_text_free(&remark);
        if (tie->function < 0) continue;
        const char *variable = yk_ring_symbol_name(d->ring, tie->variable);
        yk_page_words(page, "%s is a function of %s; _v, _a, _j are its derivatives by %s.",
                      yk_ring_symbol_name(d->ring, tie->function), variable, variable);
    }
}

static void put_drives(YkDerivation *d, YkPage *page)
{
    bool any = false;
    for (size_t k = 0; k < d->tree_count; k++) {
        const YkDeriveCoordinate *c = &d->coordinates[k];
        if (c->drive == YK_NONE) continue;
        if (d->model->drives[c->drive].law != YK_NONE) {
            yk_page_words(page, "%s follows the law %s.", c->name, d->model->laws[d->model->drives[c->drive].law].name);
            continue;
        }
        const YkPoisson *law = yk_derive_expression(d, d->model->drives[c->drive].expr);
        if (!law && yk_ring_status(d->ring) == YK_RING_DIVISOR) yk_ring_clear(d->ring);
        if (!law) continue;
        if (!any) yk_page_heading(page, 2, "Drives");
        any = true;
        const int32_t symbols[] = {c->position, c->rate, c->acceleration};
        for (int order = 0; order < 3 && law; order++) {
            YkLine *line = yk_page_equation(page, NULL, yk_ring_of(d->ring, symbols[order]), law, YK_RING_TEXTBOOK);
            if (line) line->left = NULL; // holds unless the drive is overridden
            law = yk_ring_time_derivative(d->ring, law);
        }
    }
}

bool yk_derive_section_loops(YkDerivation *d, YkPage *page)
{
    if (!yk_derive_loops(d)) return false;
    yk_derive_ties(d);
    if (d->loop_count == 0 && d->tie_count == 0)
        yk_page_words(page, "The machine has no loop: every coordinate is free.");
    if (d->loop_count > 0) yk_page_heading(page, 2, "Vectors");
    define_vectors(d, page);
    for (size_t l = 0; l < d->loop_count; l++) put_loop(d, page, &d->loops[l]);
    put_constraints(d, page);
    put_ties(d, page);
    put_drives(d, page);
    return true;
}
