// Section: motion programs and cams - every law segment by segment, what is continuous, and the resulting cams.
#include <string.h>
#include "base/number.h"
#include "derive/cams/cams.h"
#include "derive/relations.h"
#include "derive/sections.h"

enum { JUMPS_SHOWN = 12 };

// --- What a law is called

typedef struct Shown { // values of a law that no coordinate follows
    const YkDerivation *d;
    const YkLaw *law;
    const YkPoisson *theta;
    int32_t symbols[YK_DERIVE_ORDERS];
} Shown;

static void fill(void *context, const YkState *state, YkDynamics *dynamics, double *values)
{
    const Shown *shown = context;
    double found[YK_LAW_ORDER + 1];
    (void)state, (void)dynamics;
    yk_law_eval(shown->law, yk_ring_value(shown->d->ring, shown->theta, values).x, found);
    for (int k = 0; k < YK_DERIVE_ORDERS; k++) values[shown->symbols[k]] = found[k];
}

// Returns the argument of a law that gives an effort; NULL if there is none.
static const YkPoisson *effort_argument(YkDerivation *d, size_t index)
{
    for (size_t k = 0; k < d->model->effort_count; k++) {
        const YkStrength *strength = &d->model->efforts[k].strength;
        if (strength->law == (int32_t)index) return yk_derive_given(d, strength->expr);
    }
    return NULL;
}

// Gives the law names of its own: lift, lift_v, lift_a, lift_j over an argument that the file gives, or x.
static void name_alone(YkDeriveLaw *law, size_t index)
{
    static const char *const endings[] = {"", "_v", "_a", "_j"};
    YkDerivation *d = law->d;
    Shown *shown = YK_NEW(d->arena, Shown, 1);
    bool is_new = false;
    if (!shown) return;
    law->theta = effort_argument(d, index);
    if (!law->theta) {
        int32_t x = yk_derive_once(d, "argument", "x", YK_RING_COORDINATE, false, &is_new);
        law->theta = yk_ring_of(d->ring, x);
    }
    *shown = (Shown){.d = d, .law = law->law->law, .theta = law->theta};
    for (int k = 0; k < YK_DERIVE_ORDERS; k++) {
        YkText key = {0}, name = {0};
        yk_text_format(&key, "%s shown %d", law->law->name, k);
        yk_text_format(&name, "%s%s", law->law->name, endings[k]);
        shown->symbols[k] = yk_derive_once(d, yk_text_get(&key), yk_text_get(&name), YK_RING_FUNCTION, false, &is_new);
        law->shown[k] = yk_ring_of(d->ring, shown->symbols[k]);
        yk_text_free(&key);
        yk_text_free(&name);
    }
    if (is_new) yk_derive_add_source(d, fill, shown);
    law->position = law->shown[0];
}

static const YkPoisson *follower_of(const YkDerivation *d, size_t tie)
{
    const YkRelation *of = &d->mech->relations[tie];
    int32_t c = YK_NONE;
    if (of->kind == YK_RELATION_CAM) {
        const YkCam *cam = &d->model->cams[of->index];
        c = cam->oscillates ? d->joint_angle[cam->follower_joint] : d->joint_distance[cam->follower_joint];
    } else {
        const YkCoordinate *follows = &d->model->coordinates[d->model->follows[of->index].coordinate];
        c = follows->is_distance ? d->joint_distance[follows->joint] : d->joint_angle[follows->joint];
    }
    return c == YK_NONE ? NULL : yk_ring_of(d->ring, d->coordinates[c].position);
}

// Names the law as the relations do, if a coordinate follows it.
static void name_law(YkDeriveLaw *law, size_t index)
{
    YkDerivation *d = law->d;
    const YkDeriveRelation *ties = yk_derive_ties(d), *first = NULL;
    size_t followers = 0;
    for (size_t k = 0; ties && k < d->tie_count; k++) {
        if (ties[k].function < 0 || ties[k].law != law->law->law) continue;
        followers++;
        if (first) continue;
        first = &ties[k];
        law->position = follower_of(d, k);
    }
    if (!first) {
        name_alone(law, index);
        return;
    }
    law->theta = yk_ring_of(d->ring, first->variable);
    for (int k = 0; k < YK_DERIVE_ORDERS; k++) law->shown[k] = yk_ring_of(d->ring, first->function + k);
    if (followers > 1 || !law->position) law->position = law->shown[0];
}

// --- Segments

static bool has_formula(const YkLawPart *part)
{
    return part->kind == YK_LAW_POLYNOMIAL ||
           ((part->kind == YK_LAW_RISE || part->kind == YK_LAW_FALL) && !part->is_spline);
}

static size_t count_formulas(const YkModel *model)
{
    size_t count = 0;
    for (size_t l = 0; l < model->law_count; l++)
        for (size_t k = 0; k < model->laws[l].source->part_count; k++)
            count += has_formula(&model->laws[l].source->parts[k]);
    return count;
}

static void write(YkRing *ring, const YkPoisson *a, YkText *text)
{
    if (!a || !yk_ring_write(ring, a, YK_RING_BOOK, YK_RING_TEXTBOOK, text)) yk_text_puts(text, "...");
}

static void put_heading(YkDeriveLaw *law, const YkLawPart *part)
{
    static const char *const names[] = {"polynomial",        "spline", "dwell",   "rise", "fall",
                                        "constant velocity", "table",  "formula", "arc"};
    YkLawSegment segment = yk_law_segment(law->law->law, law->index);
    char from[YK_NUMBER_SIZE], to[YK_NUMBER_SIZE];
    yk_number_write_digits(segment.from, 6, from);
    yk_number_write_digits(segment.to, 6, to);
    YkText text = {0};
    yk_text_format(&text, "%s, segment %z: %s", law->law->name, law->index + 1, names[part->kind]);
    if (part->kind == YK_LAW_RISE || part->kind == YK_LAW_FALL)
        yk_text_format(&text, ", %s", part->is_spline ? "spline" : yk_rise_name(part->rise.law));
    if (part->rise.half != YK_RISE_WHOLE)
        yk_text_puts(&text, part->rise.half == YK_RISE_FIRST_HALF ? ", first half" : ", second half");
    yk_text_format(&text, ", %s from %s to %s", law->theta_name, from, to);
    yk_page_heading(law->page, 2, yk_text_get(&text));
    law->page->failed |= text.failed;
    yk_text_free(&text);
}

static void put_dwell(YkDeriveLaw *law, const YkLawPart *part)
{
    YkText text = {0};
    write(law->d->ring, law->value, &text);
    yk_page_words(law->page, "It stands at %s.", yk_text_get(&text));
    yk_text_free(&text);
    law->at = yk_derive_given(law->d, part->to.expr);
}

// Writes s + v (theta - from).
static void put_velocity(YkDeriveLaw *law, const YkLawPart *part)
{
    YkRing *ring = law->d->ring;
    const YkPoisson *v = yk_derive_given(law->d, part->v.expr), *to = yk_derive_given(law->d, part->to.expr);
    YkDeriveSpan span;
    if (v && to && law->at && law->value && yk_derive_span(law, law->at, to, false, &span)) {
        const YkPoisson *way = yk_ring_multiply(ring, yk_ring_multiply(ring, v, span.beta), span.u);
        for (int order = 0; order < 2; order++) {
            YkLine *line = yk_derive_begin_line(law, order, NULL);
            const YkPoisson *value = order == 0 ? yk_ring_add(ring, law->value, way) : v;
            yk_line_element(law->page, line, value, YK_RING_TEXTBOOK);
            yk_derive_end_line(law, line, order, value, span.u, "");
        }
        law->value = yk_ring_add(ring, law->value, yk_ring_multiply(ring, v, span.length));
    } else {
        law->value = NULL;
    }
    law->at = to;
}

// Writes a formula as the file has it: no other form of it would be exact in general.
static void put_formula(YkDeriveLaw *law, const YkLawPart *part)
{
    yk_page_words(law->page, "The formula of the file: s = %s, where %s is %s. `yoke cam` and `sweep` give its values.",
                  part->written, part->called, law->theta_name);
    law->at = law->value = NULL;
}

// Splines are many polynomials, so only the points that they go through are written.
static void put_spline(YkDeriveLaw *law, const YkLawPart *part)
{
    char degree[YK_NUMBER_SIZE];
    yk_number_write_digits(part->degree.expr ? part->degree.value : 5, 3, degree);
    yk_page_words(law->page, "B-splines of degree %s through %z conditions: `yoke cam` gives its values.", degree,
                  yk_law_segment(law->law->law, law->index).condition_count);
    law->at = law->value = NULL;
}

static void put_segment(YkDeriveLaw *law, const YkLawPart *part)
{
    put_heading(law, part);
    if (part->kind == YK_LAW_POLYNOMIAL)
        yk_derive_put_polynomial(law, part, yk_law_segment(law->law->law, law->index));
    else if (part->kind == YK_LAW_DWELL)
        put_dwell(law, part);
    else if (part->kind == YK_LAW_CONSTANT_VELOCITY)
        put_velocity(law, part);
    else if (part->kind == YK_LAW_FORMULA)
        put_formula(law, part);
    else if (has_formula(part))
        yk_derive_put_rise(law, part);
    else
        put_spline(law, part);
}

// --- The fundamental law

// Writes the jumps of s, v and a (fundamental law of cam design; Norton 2009, ch. 2).
static void put_jumps(YkDeriveLaw *law)
{
    static const char *const letters[] = {"s", "v", "a"};
    YkLawJump jumps[JUMPS_SHOWN];
    size_t count = yk_law_jumps(law->law->law, jumps, JUMPS_SHOWN);
    yk_page_heading(law->page, 2, "Continuity");
    yk_page_words(law->page, count == 0
                                 ? "s, v and a are continuous everywhere: the fundamental law of cam design holds."
                                 : "The fundamental law of cam design, continuous s, v and a, does not hold:");
    for (size_t k = 0; k < count && k < JUMPS_SHOWN; k++) {
        char size[YK_NUMBER_SIZE], at[YK_NUMBER_SIZE];
        yk_number_write_digits(jumps[k].size, 6, size);
        yk_number_write_digits(jumps[k].x, 6, at);
        yk_page_words(law->page, "%s jumps by %s at %s = %s (SI)", letters[jumps[k].order], size, law->theta_name, at);
    }
    if (count > JUMPS_SHOWN) yk_page_words(law->page, "... and %z more", count - JUMPS_SHOWN);
}

// --- The whole

static void name_argument(YkDeriveLaw *law)
{
    YkText text = {0};
    write(law->d->ring, law->theta, &text);
    law->theta_name = yk_arena_copy(law->page->arena, yk_text_get(&text), text.length);
    if (!law->theta_name) law->theta_name = "", law->page->failed = true;
    yk_text_free(&text);
}

static void put_names(const YkDeriveLaw *law)
{
    YkText names[YK_DERIVE_ORDERS] = {{0}};
    for (int k = 0; k < YK_DERIVE_ORDERS; k++) write(law->d->ring, law->shown[k], &names[k]);
    yk_page_words(law->page, "%s is s; %s, %s and %s are v, a and j, its derivatives by %s.", yk_text_get(&names[0]),
                  yk_text_get(&names[1]), yk_text_get(&names[2]), yk_text_get(&names[3]), law->theta_name);
    for (int k = 0; k < YK_DERIVE_ORDERS; k++) yk_text_free(&names[k]);
    if (yk_ring_is_same(law->position, law->shown[0])) return;
    yk_page_equation(law->page, NULL, law->position, law->shown[0], YK_RING_TEXTBOOK);
}

static void put_law(YkDerivation *d, YkPage *page, size_t index, size_t *number, size_t formulas)
{
    YkDeriveLaw law = {.d = d, .page = page, .law = &d->model->laws[index]};
    const YkLawSource *source = law.law->source;
    name_law(&law, index);
    name_argument(&law);
    yk_page_heading(page, 2, law.law->name);
    put_names(&law);
    law.at = source->from.expr ? yk_derive_given(d, source->from.expr) : yk_ring_rational(d->ring, 0, 1);
    law.value = yk_ring_rational(d->ring, 0, 1);
    if (source->is_made)
        yk_page_words(page, "It follows from the arcs of the cam's surface: `yoke cam` and `sweep` give its values.");
    if (source->points)
        yk_page_words(page, "A table of %z points: `yoke cam` and `sweep` give its values.", source->point_count);
    for (size_t k = 0; k < source->part_count; k++) {
        YkText ending = {0};
        *number += has_formula(&source->parts[k]) || source->parts[k].kind == YK_LAW_CONSTANT_VELOCITY;
        if (formulas > 1) yk_text_format(&ending, "%z", *number);
        law.index = k;
        law.ending = yk_text_get(&ending);
        put_segment(&law, &source->parts[k]);
        yk_text_free(&ending);
    }
    put_jumps(&law);
}

bool yk_derive_section_cam(YkDerivation *d, YkPage *page)
{
    size_t number = 0, formulas = count_formulas(d->model);
    if (d->model->law_count == 0) yk_page_words(page, "The machine has no `laws:`.");
    for (size_t k = 0; k < d->model->law_count; k++) put_law(d, page, k, &number, formulas);
    for (size_t k = 0; k < d->model->cam_count; k++) yk_derive_put_cam(d, page, k);
    return !page->failed && yk_derivation_is_well(d);
}
