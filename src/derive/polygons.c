// Section: velocity and acceleration polygons, step by step as they are drawn by hand, and the force polygon of every
// body. The order of the construction is that of design/polygons/polygon_plan.c, which fills it with numbers elsewhere.
#include "design/polygons/polygon_plan.h"
#include "derive/forces/free_bodies.h"
#include "derive/sections.h"

typedef struct Writer {
    YkDerivation *d;
    YkPage *page;
    YkRing *ring;
    YkPolygonKind kind;
} Writer;

// --- motions, body form

// Returns the vector from a body's origin to an end. The place under what slides lies where this now is.
static const YkPoisson *arm_of(Writer *w, const YkPolygonEnd *end)
{
    YkDerivation *d = w->d;
    int32_t body = (int32_t)end->body, joint = (int32_t)end->joint;
    const YkPoisson *unit = d->bodies[body].unit;
    if (end->joint == YK_NOT_FOUND) return yk_ring_multiply(w->ring, unit, yk_derive_at(d, (int32_t)end->point));
    int side = d->model->joints[joint].body[1] == body;
    const YkPoisson *arm = yk_ring_multiply(w->ring, unit, yk_derive_at(d, yk_derive_place(d, joint, side).point));
    bool is_under = side == 0 && d->joint_distance[joint] != YK_NONE;
    return is_under ? yk_ring_add(w->ring, arm, yk_derive_slide(d, joint)) : arm;
}

static const YkPoisson *turned(Writer *w, const YkPoisson *rate, const YkPoisson *arm)
{
    return yk_ring_product(w->ring, (const YkPoisson *[]){yk_ring_i(w->ring), rate, arm}, 3);
}

// - omega^2 arm
static const YkPoisson *drawn_in(Writer *w, size_t body, const YkPoisson *arm)
{
    const YkPoisson *square = yk_ring_power(w->ring, w->d->bodies[body].spin, 2);
    return yk_ring_negate(w->ring, yk_ring_multiply(w->ring, square, arm));
}

// Returns the velocity or acceleration of an end: that of its body's origin, and what its turning adds.
static const YkPoisson *motion_of(Writer *w, const YkPolygonEnd *end)
{
    const YkDeriveBody *body = &w->d->bodies[end->body];
    const YkPoisson *arm = arm_of(w, end);
    const YkPoisson *origin = yk_ring_time_derivative(w->ring, yk_derive_origin(w->d, (int32_t)end->body));
    if (w->kind == YK_POLYGON_VELOCITY) return yk_ring_add(w->ring, origin, turned(w, body->spin, arm));
    origin = yk_ring_add(w->ring, yk_ring_time_derivative(w->ring, origin), turned(w, body->spin_rate, arm));
    return yk_ring_add(w->ring, origin, drawn_in(w, end->body, arm));
}

// --- lines

static const char *letter_of(const Writer *w)
{
    return w->kind == YK_POLYGON_VELOCITY ? "v" : "a";
}

static void put_name(Writer *w, YkLine *line, const YkPolygonLink *link, YkPolygonPart part)
{
    static const char *const sub[] = {NULL, "normal", "tangential", "sliding", "Coriolis"};
    const char *name = yk_derive_text(w->d, link->to.image, "/", link->from.image);
    yk_line_vector(w->page, line, letter_of(w), name, w->kind == YK_POLYGON_VELOCITY ? NULL : sub[part]);
}

// One vector with its direction in words and its x and y.
static void put_vector(Writer *w, const YkPolygonLink *link, YkPolygonPart part, const YkPoisson *value)
{
    YkText words = {0};
    yk_polygon_tell_direction(part, w->d->model->bodies[link->body].name, &words);
    YkLine *line = yk_page_formula(w->page, yk_text_get(&words));
    w->page->failed |= words.failed;
    yk_text_free(&words);
    put_name(w, line, link, part);
    yk_line_sign(w->page, line, "=");
    yk_line_column(w->page, line, yk_derive_shown(w->d, value), NULL);
}

static bool is_pole(const YkPolygonEnd *end)
{
    return end->image[0] == 'o' && end->image[1] == 0;
}

// v^b = v^a + v^{b/a}: true because the loops stay closed.
static void put_sum(Writer *w, const YkPolygonLink *link, const YkPolygonPart *parts, size_t count,
                    const YkPoisson *change)
{
    YkLine *line = yk_page_formula(w->page, NULL);
    if (is_pole(&link->to))
        yk_line_sign(w->page, line, "0");
    else
        yk_line_vector(w->page, line, letter_of(w), link->to.image, NULL);
    yk_line_sign(w->page, line, "=");
    if (!is_pole(&link->from)) {
        yk_line_vector(w->page, line, letter_of(w), link->from.image, NULL);
        yk_line_sign(w->page, line, "+");
    }
    for (size_t k = 0; k < count; k++) {
        if (k > 0) yk_line_sign(w->page, line, "+");
        put_name(w, line, link, parts[k]);
    }
    if (!line) return;
    line->left = motion_of(w, &link->to);
    line->right = yk_ring_add(w->ring, motion_of(w, &link->from), change);
    line->value = line->left;
    line->is_vector = true;
}

static void put_turning(Writer *w, const YkPolygonLink *link)
{
    static const YkPolygonPart velocity[] = {YK_POLYGON_TURNING}, both[] = {YK_POLYGON_NORMAL, YK_POLYGON_TANGENTIAL};
    const YkDeriveBody *body = &w->d->bodies[link->body];
    const YkPoisson *arm = yk_ring_subtract(w->ring, arm_of(w, &link->to), arm_of(w, &link->from));
    if (w->kind == YK_POLYGON_VELOCITY) {
        const YkPoisson *value = turned(w, body->spin, arm);
        put_vector(w, link, YK_POLYGON_TURNING, value);
        put_sum(w, link, velocity, 1, value);
        return;
    }
    const YkPoisson *normal = drawn_in(w, link->body, arm), *across = turned(w, body->spin_rate, arm);
    put_vector(w, link, YK_POLYGON_NORMAL, normal);
    put_vector(w, link, YK_POLYGON_TANGENTIAL, across);
    put_sum(w, link, both, 2, yk_ring_add(w->ring, normal, across));
}

// The second body's point moves along the line of the first; Coriolis' part appears where that line turns.
static void put_sliding(Writer *w, const YkPolygonLink *link)
{
    static const YkPolygonPart parts[] = {YK_POLYGON_CORIOLIS, YK_POLYGON_SLIDING};
    YkDerivation *d = w->d;
    const YkDeriveBody *carrier = &d->bodies[link->body];
    const YkDeriveCoordinate *c = &d->coordinates[d->joint_distance[link->joint]];
    const YkPoisson *line = yk_ring_multiply(w->ring, carrier->unit, yk_derive_along(d, (int32_t)link->joint));
    if (link->from.body != link->body) line = yk_ring_negate(w->ring, line); // from what slides to what lies under it
    bool is_velocity = w->kind == YK_POLYGON_VELOCITY, has_coriolis = !is_velocity && link->body != 0;
    const YkPoisson *along =
        yk_ring_multiply(w->ring, yk_ring_of(w->ring, is_velocity ? c->rate : c->acceleration), line);
    const YkPoisson *across = turned(w, carrier->spin, yk_ring_multiply(w->ring, yk_ring_of(w->ring, c->rate), line));
    const YkPoisson *coriolis = yk_ring_scale(w->ring, across, 2, 1);
    if (has_coriolis) put_vector(w, link, YK_POLYGON_CORIOLIS, coriolis);
    put_vector(w, link, YK_POLYGON_SLIDING, along);
    put_sum(w, link, parts + !has_coriolis, has_coriolis ? 2 : 1,
            has_coriolis ? yk_ring_add(w->ring, coriolis, along) : along);
}

// --- steps

static void put_step(Writer *w, const YkPolygonPlan *plan, size_t index)
{
    const YkPolygonStep *step = &plan->step[index];
    YkText words = {0};
    yk_polygon_tell_step(plan, step, w->kind, &words);
    yk_page_words(w->page, "%z. %s.", index + 1, yk_text_get(&words));
    w->page->failed |= words.failed;
    yk_text_free(&words);
    for (size_t k = 0; k < step->links; k++) {
        const YkPolygonLink *link = &plan->link[step->first + k];
        if (link->joint == YK_NOT_FOUND)
            put_turning(w, link);
        else
            put_sliding(w, link);
    }
}

static void put_motions(YkDerivation *d, YkPage *page, const YkPolygonPlan *plan, YkPolygonKind kind)
{
    Writer w = {d, page, d->ring, kind};
    yk_page_heading(page, 2, kind == YK_POLYGON_VELOCITY ? "Velocity polygon" : "Acceleration polygon");
    for (size_t k = 0; k < plan->step_count; k++) put_step(&w, plan, k);
}

bool yk_derive_section_polygons(YkDerivation *d, YkPage *page)
{
    const char *why = yk_polygon_why_not(d->model);
    if (why) {
        yk_page_words(page, "There is no polygon: %s.", why);
        return true;
    }
    if (yk_derive_put_depth(d, page)) return true;
    const YkPolygonPlan *plan = yk_polygon_plan(d->mech, d->arena);
    if (!plan) return false;
    yk_page_words(page, "The image of a point is the end of its velocity or acceleration, drawn from the pole o, the "
                        "image of the ground. v^(b/a) leads from the image a to the image b.");
    yk_derive_put_angles(d, page);
    put_motions(d, page, plan, YK_POLYGON_VELOCITY);
    put_motions(d, page, plan, YK_POLYGON_ACCELERATION);
    return yk_derive_put_force_polygons(d, page);
}
