// Writes one mesh: the velocity of its pitch point from both sides, as a textbook does with vectors from the centres,
// and the result in numbers of teeth (Willis 1841).
#include "derive/gears/gears.h"

typedef struct Mesh {
    YkDerivation *d;
    YkPage *page;
    const YkTrainNet *net;
    const YkTrainRow *row;
    YkTrainMesh of;
    const YkPoisson *zero; // sum of factor * speed
    const char *point;     // the pitch point's name
} Mesh;

static const YkPoisson *speed(const Mesh *mesh, size_t body)
{
    return yk_derive_speed(mesh->d, body);
}

static bool stands(const YkPoisson *speed)
{
    return yk_ring_is_zero(speed);
}

static const YkPoisson *teeth(const Mesh *mesh, int side)
{
    return mesh->d->train->symbols[mesh->row->terms[side].symbol];
}

static YkLine *new_line(const Mesh *mesh, const char *remark)
{
    YkLine *line = yk_page_formula(mesh->page, remark);
    if (line) line->left = mesh->zero, line->right = NULL;
    return line;
}

// --- Vectors

static void put_vector(const Mesh *mesh, YkLine *line, const char *base, const char *head, const char *tail)
{
    YkText name = {0};
    yk_text_format(&name, "%s/%s", head, tail);
    yk_line_vector(mesh->page, line, base, yk_text_get(&name), NULL);
    mesh->page->failed |= name.failed;
    yk_text_free(&name);
}

// Writes omega x p^{head/tail}, with a sign if something stands before it. Returns whether something stands there now.
static bool put_turning(const Mesh *mesh, YkLine *line, size_t body, const char *head, const char *tail,
                        bool is_negative, bool has_before)
{
    if (stands(speed(mesh, body))) return has_before;
    if (has_before || is_negative) yk_line_sign(mesh->page, line, is_negative ? "-" : "+");
    yk_line_element(mesh->page, line, speed(mesh, body), YK_RING_TEXTBOOK);
    yk_line_sign(mesh->page, line, "x");
    put_vector(mesh, line, "p", head, tail);
    return true;
}

// Writes the velocity of a wheel's centre: along the path from the ground, each vector turning with its body.
static bool put_center(const Mesh *mesh, YkLine *line, size_t body)
{
    YkDerivation *d = mesh->d;
    YkDerivePath path;
    bool any = false;
    if (!yk_derive_path(d, (YkDerivePlace){0, YK_NONE}, (YkDerivePlace){(int32_t)body, YK_NONE}, &path)) return false;
    for (size_t k = 0; k < path.count; k++) {
        const YkDeriveVector *v = &path.vectors[k];
        if (v->is_variable) { // it slides: its rate in the direction of its line
            if (any || v->is_negative) yk_line_sign(mesh->page, line, v->is_negative ? "-" : "+");
            put_vector(mesh, line, "v", v->head, v->tail);
            any = true;
        }
        any = put_turning(mesh, line, (size_t)v->body, v->head, v->tail, v->is_negative, any);
    }
    return any;
}

static const char *center_name(const Mesh *mesh, int side)
{
    return yk_derive_point_name(mesh->d, (int32_t)mesh->of.body[side], YK_NONE);
}

static void put_side(const Mesh *mesh, YkLine *line, int side)
{
    bool any = put_center(mesh, line, mesh->of.body[side]);
    any = put_turning(mesh, line, mesh->of.body[side], mesh->point, center_name(mesh, side), false, any);
    if (!any) yk_line_sign(mesh->page, line, "0");
}

// Writes that v_P is the same on both wheels.
static void put_pitch_velocities(const Mesh *mesh)
{
    YkLine *line = new_line(mesh, NULL);
    yk_line_vector(mesh->page, line, "v", NULL, mesh->point);
    yk_line_sign(mesh->page, line, "=");
    put_side(mesh, line, 0);
    yk_line_sign(mesh->page, line, "=");
    put_side(mesh, line, 1);
}

// --- In numbers of teeth

static void put_product(const Mesh *mesh, YkLine *line, const YkPoisson *first, const YkPoisson *second)
{
    yk_line_factor(mesh->page, line, first);
    yk_line_factor(mesh->page, line, second);
}

// Writes a side's omega N; 0 if it stands still.
static void put_side_in_teeth(const Mesh *mesh, YkLine *line, int side)
{
    const YkPoisson *omega = speed(mesh, mesh->of.body[side]);
    if (stands(omega))
        yk_line_sign(mesh->page, line, "0");
    else
        put_product(mesh, line, omega, teeth(mesh, side));
}

// omega_a N_a = omega_c (N_a + N_b) - omega_b N_b, or with a ring b: omega_b N_b = omega_c (N_b - N_a) + omega_a N_a.
static void put_along_tangent(const Mesh *mesh)
{
    const YkPoisson *c = speed(mesh, mesh->of.carrier);
    bool is_internal = mesh->row->terms[1].sign < 0;
    int first = is_internal ? 1 : 0, last = 1 - first;
    if (stands(c)) return;
    YkLine *line = new_line(mesh, "along the tangent");
    put_side_in_teeth(mesh, line, first);
    yk_line_sign(mesh->page, line, "=");
    yk_line_element(mesh->page, line, c, YK_RING_TEXTBOOK);
    yk_line_sign(mesh->page, line, "(");
    yk_line_element(mesh->page, line, teeth(mesh, first), YK_RING_TEXTBOOK);
    yk_line_sign(mesh->page, line, is_internal ? "-" : "+");
    yk_line_element(mesh->page, line, teeth(mesh, last), YK_RING_TEXTBOOK);
    yk_line_sign(mesh->page, line, ")");
    if (stands(speed(mesh, mesh->of.body[last]))) return;
    yk_line_sign(mesh->page, line, is_internal ? "+" : "-");
    put_side_in_teeth(mesh, line, last);
}

// (omega_a - omega_c) N_a = -(omega_b - omega_c) N_b.
static void put_willis(const Mesh *mesh)
{
    YkRing *ring = mesh->d->ring;
    YkLine *line = new_line(mesh, mesh->of.kind == YK_TRAIN_KIND_BELT ? "the belt's speed" : "Willis");
    const YkPoisson *c = speed(mesh, mesh->of.carrier);
    for (int side = 0; side < 2; side++) {
        const YkPoisson *relative = yk_ring_subtract(ring, speed(mesh, mesh->of.body[side]), c);
        bool is_negative = side == 1 && mesh->row->terms[1].sign > 0;
        if (side == 1) yk_line_sign(mesh->page, line, "=");
        if (yk_ring_is_zero(relative)) {
            yk_line_sign(mesh->page, line, "0");
            continue;
        }
        // for a wheel that stands still, 0 - omega_c: the sign before it
        bool turns_sign = stands(speed(mesh, mesh->of.body[side]));
        if (is_negative != turns_sign) yk_line_sign(mesh->page, line, "-");
        put_product(mesh, line, turns_sign ? c : relative, teeth(mesh, side));
    }
}

// --- Racks

// Writes the rack; both rates are seen from the carrier: d' = +-(omega_pinion - omega_carrier) r.
static void put_rack(const Mesh *mesh)
{
    YkRing *ring = mesh->d->ring;
    const YkRack *rack = &mesh->d->model->racks[mesh->row->index];
    const YkPoisson *relative = yk_ring_subtract(ring, speed(mesh, mesh->of.body[0]), speed(mesh, mesh->of.carrier));
    const YkPoisson *slides = yk_derive_column(mesh->d, mesh->row->terms[mesh->row->count - 1].column);
    yk_page_words(mesh->page, "%s is the pitch point: there the pinion's circle touches the rack.", mesh->point);
    YkLine *line = new_line(mesh, NULL);
    yk_line_vector(mesh->page, line, "v", NULL, mesh->point);
    yk_line_sign(mesh->page, line, "=");
    yk_line_factor(mesh->page, line, relative);
    yk_line_sign(mesh->page, line, "x");
    put_vector(mesh, line, "p", mesh->point, center_name(mesh, 0));
    yk_line_sign(mesh->page, line, "=");
    yk_line_element(mesh->page, line, slides, YK_RING_TEXTBOOK);
    yk_line_vector(mesh->page, line, "e", NULL, mesh->d->model->joints[rack->slide].name);
    line = new_line(mesh, "along the rack");
    yk_line_element(mesh->page, line, slides, YK_RING_TEXTBOOK);
    yk_line_sign(mesh->page, line, "=");
    if (rack->sense < 0) yk_line_sign(mesh->page, line, "-");
    put_product(mesh, line, relative, teeth(mesh, 0));
}

// --- The whole

// Writes the radii of the pitch circles: p^{P1/O} = 1/2 mod N1 e.
static void put_radii(const Mesh *mesh)
{
    YkDerivation *d = mesh->d;
    const YkGear *gear = &d->model->gears[mesh->row->index];
    const YkPoisson *half = yk_ring_scale(d->ring, yk_derive_expression(d, gear->module_expr), 1, 2);
    if (!gear->module_expr || !half) {
        yk_page_words(mesh->page,
                      "%s is the pitch point, on the line e of the centres; the radii are in the ratio of the teeth.",
                      mesh->point);
        return;
    }
    yk_page_words(mesh->page,
                  gear->is_internal ? "%s is the pitch point; e points from the centre of %s to that of %s."
                                    : "%s is the pitch point; e points from the centre of %s to that of %s.",
                  mesh->point, d->model->bodies[gear->body[gear->is_internal]].name,
                  d->model->bodies[gear->body[!gear->is_internal]].name);
    for (int side = 0; side < 2; side++) {
        YkLine *line = yk_page_formula(mesh->page, NULL);
        const YkPoisson *radius = yk_ring_multiply(d->ring, half, teeth(mesh, side));
        put_vector(mesh, line, "p", mesh->point, center_name(mesh, side));
        yk_line_sign(mesh->page, line, "=");
        if (side == 1 && !gear->is_internal) yk_line_sign(mesh->page, line, "-");
        yk_line_element(mesh->page, line, radius, YK_RING_TEXTBOOK);
        yk_line_vector(mesh->page, line, "e", NULL, NULL);
    }
}

static void put_heading(const Mesh *mesh)
{
    static const char *const kinds[] = {"gears", "belt", "rack"};
    const YkModel *model = mesh->d->model;
    YkText text = {0};
    const char *kind = mesh->of.kind == YK_TRAIN_KIND_GEARS ? mesh->of.is_internal ? "internal gears" : "external gears"
                       : mesh->of.kind == YK_TRAIN_KIND_BELT ? mesh->of.is_internal ? "open belt" : "crossed belt"
                                                             : kinds[mesh->of.kind];
    yk_text_format(&text, "%s: %s %s and %s on %s", mesh->of.name, kind, model->bodies[mesh->of.body[0]].name,
                   model->bodies[mesh->of.body[1]].name,
                   mesh->of.carrier == 0 ? "the ground" : model->bodies[mesh->of.carrier].name);
    yk_page_heading(mesh->page, 2, yk_text_get(&text));
    mesh->page->failed |= text.failed;
    yk_text_free(&text);
}

void yk_derive_put_mesh(YkDerivation *d, YkPage *page, size_t index)
{
    const YkTrain *train = d->train->train;
    Mesh mesh = {.d = d,
                 .page = page,
                 .net = &train->net,
                 .row = yk_train_mesh_row(&train->net, (int32_t)index),
                 .of = yk_train_mesh(train, index)};
    mesh.zero = yk_derive_row_zero(d, mesh.row);
    bool is_rack = mesh.of.kind == YK_TRAIN_KIND_RACK; // a belt has no pitch point
    mesh.point = mesh.of.kind == YK_TRAIN_KIND_BELT
                     ? NULL
                     : yk_derive_pitch_name(d, (size_t)mesh.row->index + (is_rack ? d->model->gear_count : 0));
    put_heading(&mesh);
    if (is_rack) {
        put_rack(&mesh);
        return;
    }
    if (mesh.of.kind == YK_TRAIN_KIND_GEARS && d->model->gears[mesh.row->index].center_distance > 0) {
        put_radii(&mesh);
        put_pitch_velocities(&mesh);
    } else if (mesh.of.kind == YK_TRAIN_KIND_GEARS) {
        yk_page_words(page,
                      "The file puts both centres on one point, so its geometry has no pitch point; the teeth give:");
    }
    if (mesh.of.kind == YK_TRAIN_KIND_GEARS) put_along_tangent(&mesh);
    put_willis(&mesh);
}
