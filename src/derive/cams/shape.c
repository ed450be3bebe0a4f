// Writes the geometry that a cam gets from its law: where the follower stands, pitch curve and contact, pressure angle,
// radius of curvature. The cam's centre is the origin, theta its angle, sigma = +-1 the sense in which it turns
// (design/cams/cam.h has the same in numbers). Sources: Angeles & Lopez-Cajun 1991, ch. 3-4; Norton 2009, ch. 7.
#include <string.h>
#include "derive/cams/cams.h"
#include "derive/relations.h"
#include "design/cams/cam.h"
#include "elementary/elementary.h"

typedef struct Shape {
    YkDerivation *d;
    YkPage *page;
    YkRing *ring;
    const YkCam *cam;
    YkCamShape numbers; // the same in doubles: for signs and for constant angles
    int sigma, swing;
    const YkPoisson *s, *v, *a; // of the law
    const YkPoisson *back;      // e^(-i sigma theta)
    const YkPoisson *base, *roller, *offset, *along, *arm, *pivot;
    const YkPoisson *distance; // of the roller's centre or edge at lift 0: base + roller
} Shape;

static const YkPoisson *plus(const Shape *shape, const YkPoisson *a, const YkPoisson *b)
{
    return yk_ring_add(shape->ring, a, b);
}

static const YkPoisson *minus(const Shape *shape, const YkPoisson *a, const YkPoisson *b)
{
    return yk_ring_subtract(shape->ring, a, b);
}

static const YkPoisson *times(const Shape *shape, const YkPoisson *a, const YkPoisson *b)
{
    return yk_ring_multiply(shape->ring, a, b);
}

static const YkPoisson *with_sign(const Shape *shape, int sign, const YkPoisson *a)
{
    return yk_ring_scale(shape->ring, a, sign, 1);
}

static const YkPoisson *quarter(const Shape *shape, const YkPoisson *a) // i a
{
    return times(shape, yk_ring_i(shape->ring), a);
}

// --- Dimensions

static int32_t enter(const Shape *shape, const char *stem, bool is_angle, bool *is_new)
{
    return yk_derive_cam_symbol(shape->d, shape->cam, stem, is_angle, is_new);
}

// Returns a constant that the file does not give directly.
static const YkPoisson *constant(const Shape *shape, const char *stem, bool is_angle, double value)
{
    bool is_new;
    int32_t symbol = enter(shape, stem, is_angle, &is_new);
    if (is_new) yk_derive_fix(shape->d, symbol, value);
    const YkPoisson *a = yk_ring_of(shape->ring, symbol);
    YkLine *line = yk_page_formula(shape->page, NULL);
    yk_line_element(shape->page, line, a, YK_RING_TEXTBOOK);
    if (line) line->value = a;
    return a;
}

// Returns a dimension under its textbook name, R_b, and writes the file's value; 0 if it is 0.
static const YkPoisson *dimension(const Shape *shape, const char *stem, const YkExpr *expr, double value)
{
    bool is_new;
    if (value == 0) return yk_ring_rational(shape->ring, 0, 1);
    const YkPoisson *given = yk_derive_given(shape->d, expr);
    if (!given) return constant(shape, stem, false, value);
    int32_t symbol = enter(shape, stem, false, &is_new);
    if (is_new && !yk_derive_define(shape->d, symbol, given)) return NULL;
    YkLine *line = yk_page_equation(shape->page, NULL, yk_ring_of(shape->ring, symbol), given, YK_RING_TEXTBOOK);
    if (line) line->value = given;
    return yk_ring_of(shape->ring, symbol);
}

// Returns e^(i angle) of a direction: exact for multiples of 15 degrees, otherwise of a constant angle.
static const YkPoisson *direction(const Shape *shape, const char *stem, YkVec unit)
{
    for (int k = 0; k < 24; k++)
        if (yk_norm(yk_sub(yk_unit(k * YK_PI / 12), unit)) < 1e-12) return yk_ring_turn(shape->ring, k, 12);
    const YkPoisson *angle = constant(shape, stem, true, yk_atan2(unit.y, unit.x));
    return yk_ring_unit(shape->ring, yk_ring_next_symbol(shape->ring, angle, -1));
}

// --- Lines

static void put_vector(const Shape *shape, const char *name, const YkPoisson *vector)
{
    YkLine *line = yk_page_formula(shape->page, name);
    yk_line_vector(shape->page, line, "c", NULL, NULL);
    yk_line_sign(shape->page, line, "=");
    yk_line_column(shape->page, line, vector, NULL);
}

static void put_quotient(const Shape *shape, const char *remark, const char *left, const YkPoisson *over,
                         const YkPoisson *under)
{
    YkLine *line = yk_page_formula(shape->page, remark);
    int64_t p, q;
    yk_line_words(shape->page, line, left);
    yk_line_sign(shape->page, line, "=");
    if (yk_ring_is_rational(under, &p, &q) && p == 1 && q == 1)
        yk_line_element(shape->page, line, over, YK_RING_TEXTBOOK);
    else
        yk_line_quotient(shape->page, line, over, under);
    if (!line) return;
    line->value = over;
    line->value_under = under;
}

// Returns name, the positive root of `square`.
static const YkPoisson *root(const Shape *shape, const char *stem, const YkPoisson *square)
{
    YkText key = {0}, name = {0};
    yk_text_format(&key, "cam %s %s", shape->cam->name, stem);
    yk_text_format(&name, shape->d->model->cam_count > 1 ? "%s_%s" : "%s", stem, shape->cam->name);
    const YkPoisson *made = yk_derive_once_root(shape->d, yk_text_get(&key), yk_text_get(&name), square);
    yk_text_free(&key);
    yk_text_free(&name);
    YkLine *line = yk_page_equation(shape->page, NULL, yk_ring_power(shape->ring, made, 2), square, YK_RING_TEXTBOOK);
    if (line) line->value = NULL;
    return made;
}

// --- Rollers and edges

// Takes the path C of the roller's centre in the carrier's axes and its derivatives by theta: the pitch curve is
// e^(-i sigma theta) C, its normal sigma i C1 with C1 = C' - i sigma C. `lifts` is the direction of a growing lift.
static void put_roller(const Shape *shape, const YkPoisson *C, const YkPoisson *d1, const YkPoisson *d2,
                       const YkPoisson *lifts)
{
    YkRing *ring = shape->ring;
    const YkPoisson *C1 = minus(shape, d1, with_sign(shape, shape->sigma, quarter(shape, C)));
    const YkPoisson *C2 = minus(shape, minus(shape, d2, with_sign(shape, 2 * shape->sigma, quarter(shape, d1))), C);
    const YkPoisson *normal = with_sign(shape, shape->sigma, quarter(shape, C1));
    bool is_edge = yk_ring_is_zero(shape->roller);
    put_vector(shape, is_edge ? "cam surface, in the cam's axes" : "pitch curve, in the cam's axes",
               times(shape, shape->back, C));
    const YkPoisson *over = yk_ring_cross(ring, lifts, normal);
    put_quotient(shape, "pressure angle", "tan(alpha)", over, yk_ring_dot(ring, lifts, normal));
    const YkPoisson *n = root(shape, "n", yk_ring_dot(ring, C1, C1));
    if (!is_edge)
        put_vector(
            shape, "cam surface",
            times(shape, shape->back, minus(shape, C, yk_ring_divide(ring, times(shape, shape->roller, normal), n))));
    const YkPoisson *bend = with_sign(shape, -shape->sigma, yk_ring_cross(ring, C1, C2));
    put_quotient(shape, is_edge ? "radius of curvature" : "radius of curvature of the pitch curve", "rho",
                 yk_ring_power(ring, n, 3), bend);
    if (!is_edge) yk_page_words(shape->page, "The surface's radius of curvature is rho less the roller's radius.");
}

// The centre moves along a line, offset by e from the cam's centre: d0 at lift 0.
static void put_translating(const Shape *shape)
{
    const YkPoisson *d0 = shape->distance, *u = shape->along, *aside = quarter(shape, times(shape, shape->offset, u));
    if (!yk_ring_is_zero(shape->offset)) {
        const YkPoisson *square = times(shape, shape->offset, shape->offset); // first: order is that of terms in print
        d0 = root(shape, "d0", minus(shape, times(shape, d0, d0), square));
    }
    const YkPoisson *C = minus(shape, times(shape, plus(shape, d0, shape->s), u), aside);
    put_roller(shape, C, times(shape, shape->v, u), times(shape, shape->a, u), u);
}

// Returns psi, the angle of the arm or of the face's normal: psi0 at lift 0.
static const YkPoisson *enter_psi(const Shape *shape)
{
    YkDerivation *d = shape->d;
    bool is_new;
    const YkPoisson *psi0 = constant(shape, "psi0", true, shape->numbers.start);
    int32_t psi = enter(shape, "psi", true, &is_new);
    const YkPoisson *meaning = plus(shape, psi0, with_sign(shape, shape->swing, shape->s));
    if (is_new) yk_derive_define(d, psi, meaning);
    YkLine *line = yk_page_equation(shape->page, NULL, yk_ring_of(shape->ring, psi), meaning, YK_RING_TEXTBOOK);
    if (line) line->solved = psi, line->over = meaning;
    return yk_ring_unit(shape->ring, psi);
}

// The centre moves on a circle about the pivot.
static void put_oscillating(const Shape *shape)
{
    const YkPoisson *unit = enter_psi(shape), *arm = times(shape, shape->arm, unit), *across = quarter(shape, arm);
    const YkPoisson *C = plus(shape, shape->pivot, arm), *v = with_sign(shape, shape->swing, shape->v);
    const YkPoisson *d2 = minus(shape, times(shape, with_sign(shape, shape->swing, shape->a), across),
                                times(shape, times(shape, v, v), arm));
    yk_page_words(shape->page, "psi0 is such that the triangle of arm, centres and R_b + R_r closes.");
    put_roller(shape, C, times(shape, v, across), d2, with_sign(shape, shape->swing, quarter(shape, unit)));
}

// --- Flat faces

// The face is a line at distance h with normal e^(i nu): the surface is its envelope, with h as support function.
static void put_flat(const Shape *shape)
{
    const YkPoisson *h = plus(shape, shape->base, shape->s), *u = shape->along;
    const YkPoisson *aside = quarter(shape, times(shape, with_sign(shape, shape->sigma, shape->v), u));
    put_vector(shape, "cam surface, in the cam's axes",
               times(shape, shape->back, minus(shape, times(shape, h, u), aside)));
    const YkPoisson *one = yk_ring_rational(shape->ring, 1, 1);
    put_quotient(shape, "pressure angle", "tan(alpha)", yk_ring_rational(shape->ring, 0, 1), one);
    put_quotient(shape, "radius of curvature", "rho", plus(shape, h, shape->a), one);
    put_quotient(shape, "contact on the face, from the line of motion", "x",
                 minus(shape, with_sign(shape, shape->sigma, shape->v), shape->offset), one);
}

// q = d(nu - sigma theta) / d theta.
static void put_flat_oscillating(const Shape *shape)
{
    YkRing *ring = shape->ring;
    bool is_new;
    const YkPoisson *n = enter_psi(shape), *nu1 = with_sign(shape, shape->swing, shape->v);
    const YkPoisson *nu2 = with_sign(shape, shape->swing, shape->a);
    int32_t symbol = enter(shape, "q", false, &is_new);
    const YkPoisson *turns = minus(shape, nu1, yk_ring_rational(ring, shape->sigma, 1));
    if (is_new) yk_derive_define(shape->d, symbol, turns);
    const YkPoisson *q = yk_ring_of(ring, symbol);
    yk_page_equation(shape->page, "turning of the face against the cam", q, turns, YK_RING_TEXTBOOK);
    const YkPoisson *along = yk_ring_dot(ring, n, shape->pivot), *across = yk_ring_cross(ring, n, shape->pivot);
    const YkPoisson *h = minus(shape, along, shape->offset), *h1 = times(shape, across, nu1);
    const YkPoisson *h2 = minus(shape, times(shape, across, nu2), times(shape, along, times(shape, nu1, nu1)));
    const YkPoisson *slope = yk_ring_divide(ring, h1, q);
    const YkPoisson *contact = times(shape, n, plus(shape, h, quarter(shape, slope)));
    const YkPoisson *moves = with_sign(shape, shape->swing, quarter(shape, minus(shape, contact, shape->pivot)));
    put_vector(shape, "cam surface, in the cam's axes", times(shape, shape->back, contact));
    const YkPoisson *over = yk_ring_cross(ring, moves, n);
    put_quotient(shape, "pressure angle", "tan(alpha)", over, yk_ring_dot(ring, moves, n));
    const YkPoisson *rho = plus(shape, h, yk_ring_divide(ring, h2, times(shape, q, q)));
    rho = minus(shape, rho, yk_ring_divide(ring, times(shape, h1, nu2), yk_ring_power(ring, q, 3)));
    put_quotient(shape, "radius of curvature", "rho", rho, yk_ring_rational(ring, 1, 1));
}

// --- The whole

static const YkDeriveRelation *tie_of(YkDerivation *d, size_t cam)
{
    const YkDeriveRelation *ties = yk_derive_ties(d);
    for (size_t k = 0; ties && k < d->tie_count; k++)
        if (d->mech->relations[k].kind == YK_RELATION_CAM && d->mech->relations[k].index == (int32_t)cam)
            return &ties[k];
    return NULL;
}

static void put_heading(const Shape *shape)
{
    YkText text = {0};
    yk_text_format(&text, "%s: cam with %s %s follower", shape->cam->name,
                   shape->cam->oscillates ? "an oscillating" : "a translating", yk_cam_face_name(shape->cam->face));
    yk_page_heading(shape->page, 2, yk_text_get(&text));
    yk_text_free(&text);
}

static void put_dimensions(Shape *shape)
{
    const YkCam *cam = shape->cam;
    shape->base = dimension(shape, "R_b", cam->base_expr, cam->base);
    shape->roller = dimension(shape, "R_r", cam->roller_expr, cam->roller);
    shape->offset = dimension(shape, "e", cam->offset_expr, cam->offset);
    shape->distance = plus(shape, shape->base, shape->roller);
    if (!cam->oscillates) {
        shape->along = direction(shape, "lambda", cam->along);
        return;
    }
    double centers = yk_norm(cam->pivot);
    if (cam->face != YK_CAM_FACE_FLAT) shape->arm = dimension(shape, "l", cam->arm_expr, cam->arm);
    const YkPoisson *gamma = direction(shape, "gamma", yk_scale(1 / centers, cam->pivot));
    shape->pivot = times(shape, dimension(shape, "f", cam->centers_expr, centers), gamma);
}

void yk_derive_put_cam(YkDerivation *d, YkPage *page, size_t index)
{
    const YkDeriveRelation *tie = tie_of(d, index);
    const YkCam *cam = &d->model->cams[index];
    Shape shape = {.d = d, .page = page, .ring = d->ring, .cam = cam, .numbers = yk_cam_shape_of(cam)};
    put_heading(&shape);
    if (!tie || tie->function < 0) {
        yk_page_words(page, "Its angle is not a coordinate: not written here.");
        return;
    }
    shape.sigma = cam->turn > 0 ? 1 : -1;
    shape.swing = cam->swing > 0 ? 1 : -1;
    shape.s = yk_ring_of(d->ring, tie->function);
    shape.v = yk_ring_of(d->ring, tie->function + 1);
    shape.a = yk_ring_of(d->ring, tie->function + 2);
    const YkAngleTerm turned = {tie->variable, -shape.sigma};
    shape.back = yk_ring_exp(d->ring, &turned, 1);
    put_dimensions(&shape);
    if (cam->face == YK_CAM_FACE_FLAT)
        (cam->oscillates ? put_flat_oscillating : put_flat)(&shape);
    else
        (cam->oscillates ? put_oscillating : put_translating)(&shape);
    if (cam->is_conjugate)
        yk_page_words(page, "The second cam of the pair is written the same way, from its own side.");
}
