// Section: instant centres. P_ij moves alike on bodies i and j; the order and the lines by Kennedy's theorem are those
// of design/centers.c at the pose in which the file starts.
#include <yoke/centers.h>
#include <math.h>
#include "derive/forces/free_bodies.h"
#include "derive/sections.h"
#include "solve/state.h"

typedef struct Centers {
    YkDerivation *d;
    YkPage *page;
    YkRing *ring;
    size_t bodies;
    const YkCenters *found;
    const YkCenter **of; // [bodies * bodies], both ways round
} Centers;

// Data for the source of values: the symbols of each pair of bodies, or -1.
typedef struct Symbols {
    size_t bodies;
    int32_t *x, *y; // [bodies * bodies]
} Symbols;

// --- names and values

static const char *pair_name(const Centers *c, const YkCenter *center)
{
    YkText text = {0};
    yk_text_format(&text, c->bodies <= 10 ? "%z%z" : "%z_%z", center->body[0], center->body[1]);
    const char *name = yk_arena_copy(c->d->arena, yk_text_get(&text), text.length);
    c->d->failed |= !name;
    yk_text_free(&text);
    return name ? name : "";
}

static void fill(void *context, const YkState *state, YkDynamics *dynamics, double *values)
{
    const Symbols *symbols = context;
    YkCenters *centers = yk_centers_new(state, NULL);
    (void)dynamics;
    for (size_t k = 0; k < yk_centers_count(centers); k++) {
        YkCenter center = yk_centers_at(centers, k);
        size_t pair = center.body[0] * symbols->bodies + center.body[1];
        bool is_point = center.kind == YK_CENTER_POINT;
        if (symbols->x[pair] < 0) continue;
        values[symbols->x[pair]] = is_point ? center.at[0] : NAN;
        values[symbols->y[pair]] = is_point ? center.at[1] : NAN;
    }
    yk_centers_free(centers);
}

// Makes the symbols P02x and P02y of all centres that are points; at most once.
static const Symbols *enter_symbols(Centers *c)
{
    YkDerivation *d = c->d;
    if (d->centers) return d->centers;
    Symbols *symbols = YK_NEW(d->arena, Symbols, 1);
    size_t pairs = c->bodies * c->bodies;
    if (!symbols) return NULL;
    *symbols = (Symbols){c->bodies, YK_NEW(d->arena, int32_t, pairs), YK_NEW(d->arena, int32_t, pairs)};
    if (!symbols->x || !symbols->y) return NULL;
    for (size_t k = 0; k < pairs; k++) symbols->x[k] = symbols->y[k] = -1;
    for (size_t k = 0; k < yk_centers_count(c->found); k++) {
        YkCenter center = yk_centers_at(c->found, k);
        size_t pair = center.body[0] * c->bodies + center.body[1];
        if (center.kind != YK_CENTER_POINT) continue;
        const char *stem = yk_derive_text(d, "P", pair_name(c, &center), "");
        symbols->x[pair] = yk_derive_symbol(d, yk_derive_text(d, stem, "x", ""), YK_RING_FUNCTION);
        symbols->y[pair] = yk_derive_symbol(d, yk_derive_text(d, stem, "y", ""), YK_RING_FUNCTION);
        if (symbols->x[pair] < 0 || symbols->y[pair] < 0) return NULL;
    }
    d->centers = symbols;
    return yk_derive_add_source(d, fill, symbols) ? symbols : NULL;
}

static const YkPoisson *place_of(Centers *c, const YkCenter *center)
{
    const Symbols *symbols = c->d->centers;
    size_t pair = center->body[0] * c->bodies + center->body[1];
    const YkPoisson *y = yk_ring_of(c->ring, symbols->y[pair]);
    return yk_ring_add(c->ring, yk_ring_of(c->ring, symbols->x[pair]),
                       yk_ring_multiply(c->ring, yk_ring_i(c->ring), y));
}

// Returns the direction across the line of a slide, body form.
static const YkPoisson *across_slide(Centers *c, size_t joint)
{
    const YkDeriveBody *carrier = &c->d->bodies[c->d->model->joints[joint].body[0]];
    const YkPoisson *line = yk_ring_multiply(c->ring, carrier->unit, yk_derive_along(c->d, (int32_t)joint));
    return yk_ring_multiply(c->ring, yk_ring_i(c->ring), line);
}

static const char *body_name(const Centers *c, size_t body)
{
    return c->d->model->bodies[body].name;
}

static void put_point(Centers *c, YkLine *line, const YkCenter *center)
{
    yk_line_vector(c->page, line, "P", NULL, pair_name(c, center));
}

// --- the centres

static void put_at_joint(Centers *c, const YkCenter *center)
{
    const YkJoint *joint = &c->d->model->joints[center->joint];
    if (center->kind == YK_CENTER_AT_INFINITY) {
        yk_page_words(c->page, "P_%s of %s and %s lies at infinity, in the direction n_%s across the line of %s.",
                      pair_name(c, center), body_name(c, center->body[0]), body_name(c, center->body[1]), joint->name,
                      joint->name);
        return;
    }
    YkDerivePlace place = yk_derive_place(c->d, (int32_t)center->joint, 0);
    const YkPoisson *at = yk_derive_position(c->d, place.body, yk_derive_at(c->d, place.point));
    YkLine *line = yk_page_formula(c->page, yk_derive_text(c->d, "the pin ", joint->name, ""));
    put_point(c, line, center);
    yk_line_sign(c->page, line, "=");
    yk_line_column(c->page, line, yk_derive_shown(c->d, at), NULL);
    if (!line) return;
    line->left = place_of(c, center);
    line->right = at;
}

// Returns whether the place or direction of a centre is known in symbols.
static bool has_symbol(const YkCenter *center)
{
    return center->kind == YK_CENTER_POINT ||
           (center->kind == YK_CENTER_AT_INFINITY && center->source == YK_CENTER_JOINT);
}

// Writes that a centre lies on the line through two others: (P - Q) x (R - Q) = 0, or (P - Q) x e = 0 to one at
// infinity.
static void put_line(Centers *c, const YkCenter *center, size_t by)
{
    const YkCenter *q = c->of[center->body[0] * c->bodies + by], *r = c->of[by * c->bodies + center->body[1]];
    YkPage *page = c->page;
    if (q->kind != YK_CENTER_POINT) {
        const YkCenter *other = q;
        q = r;
        r = other;
    }
    bool is_far = r->kind != YK_CENTER_POINT;
    if (q->kind != YK_CENTER_POINT || !has_symbol(r) || center->kind != YK_CENTER_POINT) {
        yk_page_words(page, "P_%s lies on the line P_%s P_%s.", pair_name(c, center), pair_name(c, q), pair_name(c, r));
        return;
    }
    const YkPoisson *along =
        is_far ? across_slide(c, r->joint) : yk_ring_subtract(c->ring, place_of(c, r), place_of(c, q));
    YkLine *line = yk_page_formula(page, yk_derive_text(c->d, "by ", body_name(c, by), ""));
    yk_line_sign(page, line, "(");
    put_point(c, line, center);
    yk_line_sign(page, line, "-");
    put_point(c, line, q);
    yk_line_sign(page, line, ")");
    yk_line_sign(page, line, "x");
    if (is_far) {
        yk_line_vector(page, line, "n", NULL, c->d->model->joints[r->joint].name);
    } else {
        yk_line_sign(page, line, "(");
        put_point(c, line, r);
        yk_line_sign(page, line, "-");
        put_point(c, line, q);
        yk_line_sign(page, line, ")");
    }
    yk_line_sign(page, line, "=");
    yk_line_sign(page, line, "0");
    if (!line) return;
    line->left = yk_ring_cross(c->ring, yk_ring_subtract(c->ring, place_of(c, center), place_of(c, q)), along);
    line->right = yk_ring_rational(c->ring, 0, 1);
}

static void put_by_kennedy(Centers *c, const YkCenter *center)
{
    const YkPoisson *place = center->kind == YK_CENTER_POINT ? place_of(c, center) : NULL;
    yk_page_words(c->page, "P_%s of %s and %s lies %swhere two lines meet:", pair_name(c, center),
                  body_name(c, center->body[0]), body_name(c, center->body[1]),
                  place ? "" : "at infinity at this pose, ");
    for (size_t k = 0; k < 2; k++) put_line(c, center, center->by[k]);
    if (!place || !c->page->has_numbers) return;
    YkLine *line = yk_page_formula(c->page, NULL);
    put_point(c, line, center);
    yk_line_sign(c->page, line, "=");
    yk_line_column(c->page, line, place, NULL);
}

static void put_center(Centers *c, const YkCenter *center)
{
    if (center->kind == YK_CENTER_UNDEFINED)
        yk_page_words(c->page, "%s and %s move as one: they have no centre.", body_name(c, center->body[0]),
                      body_name(c, center->body[1]));
    else if (center->source == YK_CENTER_JOINT)
        put_at_joint(c, center);
    else if (center->source == YK_CENTER_KENNEDY)
        put_by_kennedy(c, center);
    else
        yk_page_words(c->page,
                      "Kennedy's theorem leads no further: P_%s of %s and %s is the point with the same "
                      "velocity on both.",
                      pair_name(c, center), body_name(c, center->body[0]), body_name(c, center->body[1]));
}

// --- rates

// Writes omega_j (P_ij - P_0j) = omega_i (P_ij - P_0i): the velocity of the point that both bodies share.
static void put_rate(Centers *c, size_t i, size_t j)
{
    const YkCenter *both = c->of[i * c->bodies + j], *own[2] = {c->of[j], c->of[i]};
    size_t body[2] = {j, i};
    if (!both || both->kind != YK_CENTER_POINT) return;
    for (size_t k = 0; k < 2; k++)
        if (!own[k] || own[k]->kind != YK_CENTER_POINT) return;
    YkLine *line = yk_page_formula(c->page, body_name(c, j));
    const YkPoisson *side[2];
    for (size_t k = 0; k < 2; k++) {
        const YkPoisson *spin = c->d->bodies[body[k]].spin, *shown = yk_derive_shown(c->d, spin);
        if (k == 1) yk_line_sign(c->page, line, "=");
        yk_line_factor(c->page, line, shown);
        yk_line_sign(c->page, line, "(");
        put_point(c, line, both);
        yk_line_sign(c->page, line, "-");
        put_point(c, line, own[k]);
        yk_line_sign(c->page, line, ")");
        side[k] = yk_ring_multiply(c->ring, spin, yk_ring_subtract(c->ring, place_of(c, both), place_of(c, own[k])));
    }
    if (!line) return;
    line->left = side[0];
    line->right = side[1];
}

static void put_rates(Centers *c)
{
    const YkDerivation *d = c->d;
    int32_t joint = d->mech->coordinates[yk_input_coordinate(d->mech, 0)].joint;
    size_t input = (size_t)d->model->joints[joint].body[1];
    if (input == 0) input = (size_t)d->model->joints[joint].body[0];
    if (input >= c->bodies) return;
    yk_page_heading(c->page, 2, "Rates by centres");
    yk_page_words(c->page, "P_ij has one velocity, that of %s and that of the other body:", body_name(c, input));
    for (size_t j = 1; j < c->bodies; j++)
        if (j != input) put_rate(c, input, j);
}

// --- the section

static bool put_all(Centers *c)
{
    size_t count = yk_centers_count(c->found);
    YkCenter *center = YK_NEW(c->d->arena, YkCenter, count + 1);
    c->of = YK_NEW(c->d->arena, const YkCenter *, c->bodies * c->bodies);
    if (!center || !c->of || !enter_symbols(c)) return false;
    yk_page_words(c->page,
                  "%z bodies have %z centre%s. Those at joints are known; the centres of three bodies lie on one "
                  "line (Aronhold, Kennedy), so that each of the others is where two lines meet.",
                  c->bodies, count, count == 1 ? "" : "s");
    yk_derive_put_angles(c->d, c->page);
    for (size_t k = 0; k < count; k++) {
        center[k] = yk_centers_at(c->found, k);
        c->of[center[k].body[0] * c->bodies + center[k].body[1]] = &center[k];
        c->of[center[k].body[1] * c->bodies + center[k].body[0]] = &center[k];
        put_center(c, &center[k]);
    }
    put_rates(c);
    return true;
}

// Writes the reason why there are no centres, as a sentence.
static void put_why(YkPage *page, const char *message)
{
    const char first[] = {message[0] >= 'a' && message[0] <= 'z' ? (char)(message[0] - 'a' + 'A') : message[0], '\0'};
    yk_page_words(page, "%s%s.", first, message + 1);
}

bool yk_derive_section_centers(YkDerivation *d, YkPage *page)
{
    YkProblems *problems = yk_problems_new();
    YkState *state = yk_state_new(d->mech);
    bool good = problems && state;
    if (good && yk_derive_put_depth(d, page)) {
        yk_state_free(state);
        yk_problems_free(problems);
        return true;
    }
    YkStatus status = good ? yk_state_set_time(state, 0, NULL) : YK_NO_MEMORY;
    if (status >= 0) status = yk_state_assemble(state);
    YkCenters *found = status >= 0 ? yk_centers_new(state, problems) : NULL;
    Centers c = {.d = d, .page = page, .ring = d->ring, .bodies = yk_model_body_count(d->model), .found = found};
    const YkProblem *why = yk_problems_count(problems) > 0 ? yk_problems_get(problems, 0) : NULL;
    if (found)
        good = put_all(&c);
    else if (status == YK_NO_MEMORY || (why && why->code == YK_CODE_OUT_OF_MEMORY))
        good = false;
    else
        put_why(page, why ? why->message : "the machine cannot be assembled where its file starts it");
    if (!good) d->failed = true;
    yk_centers_free(found);
    yk_state_free(state);
    yk_problems_free(problems);
    return good;
}
