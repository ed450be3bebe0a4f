// Drawings read back: every pin, box, rod, slot, bar, plate, pedestal, rail and name of the examples is where the state
// has its body, to one scale, and nothing else is drawn.
#include "check.h"
#include <stdlib.h>
#include <yoke/yoke.h>
#include "base/text.h"
#include "base/vec.h"
#include "model/model.h"

enum { BODIES = 40, MOST = 900 };

typedef struct Element {
    char tag; // l: line, c: circle, p: polygon, t: text
    const char *text, *end;
    YkVec at[48];
    size_t count;
    double radius, width; // of a circle; of its stroke
    bool is_seen;
} Element;

typedef struct Sheet {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
    YkVec origin[2][BODIES], axis[2][BODIES]; // of the bodies in both poses, m
    Element elements[MOST];
    size_t count;
    double scale, bar, width, height; // px per metre, px
    YkVec zero;                       // where the origin of the ground is, px
} Sheet;

// --- The machine

static void take_frames(Sheet *s, int pose)
{
    for (size_t b = 0; b < s->model->body_count; b++) {
        const YkBody *body = &s->model->bodies[b];
        YkVec axis = yk_vec(cos(yk_state_body(s->state, b).position), sin(yk_state_body(s->state, b).position));
        s->axis[pose][b] = axis;
        s->origin[pose][b] = yk_vec(NAN, NAN);
        if (b == 0) s->origin[pose][b] = yk_vec(0, 0);
        if (b == 0 || body->point_count == 0) continue;
        YkPointMotion point = yk_state_point(s->state, (size_t)body->first_point);
        YkVec own = s->model->points[body->first_point].at;
        s->origin[pose][b] = yk_sub(yk_vec(point.position[0], point.position[1]), yk_mul(axis, own));
    }
}

static YkVec place(const Sheet *s, int pose, int32_t body, YkVec own)
{
    return yk_add(s->origin[pose][body], yk_mul(s->axis[pose][body], own));
}

static YkVec pixel(const Sheet *s, YkVec at)
{
    return yk_vec(s->zero.x + s->scale * at.x, s->zero.y - s->scale * at.y);
}

static YkVec joint_pixel(const Sheet *s, int pose, const YkJoint *joint, int side)
{
    return pixel(s, place(s, pose, joint->body[side], joint->at[side]));
}

static YkVec line_of(const Sheet *s, int pose, const YkJoint *joint) // on the page
{
    return yk_conj(yk_mul(s->axis[pose][joint->body[0]], joint->along));
}

// --- The page

static double attribute(const Element *e, const char *name)
{
    char pattern[32];
    snprintf(pattern, sizeof pattern, " %s=\"", name);
    const char *at = strstr(e->text, pattern);
    return at && at < e->end ? atof(at + strlen(pattern)) : (double)NAN;
}

static bool has(const Element *e, const char *words)
{
    const char *at = strstr(e->text, words);
    return at && at < e->end;
}

static void read_element(Sheet *s, const char *at, char tag)
{
    assert_true(s->count < MOST);
    Element *e = &s->elements[s->count++];
    *e = (Element){.tag = tag, .text = at, .end = strchr(at, '>')};
    e->width = attribute(e, "stroke-width");
    e->radius = attribute(e, "r");
    if (tag == 'l') {
        e->at[e->count++] = yk_vec(attribute(e, "x1"), attribute(e, "y1"));
        e->at[e->count++] = yk_vec(attribute(e, "x2"), attribute(e, "y2"));
    } else if (tag == 'c') {
        e->at[e->count++] = yk_vec(attribute(e, "cx"), attribute(e, "cy"));
    } else if (tag == 't') {
        e->at[e->count++] = yk_vec(attribute(e, "x"), attribute(e, "y"));
    } else {
        char *from = strstr(at, "points=\"") + strlen("points=\"");
        while (*from != '"' && e->count < sizeof e->at / sizeof *e->at) {
            double x = strtod(from, &from), y = strtod(from + 1, &from);
            e->at[e->count++] = yk_vec(x, y);
        }
    }
}

// Reads what is outside the faint poses.
static void read_page(Sheet *s, const char *svg)
{
    s->width = atof(strstr(svg, "width=\"") + strlen("width=\""));
    s->height = atof(strstr(svg, "height=\"") + strlen("height=\""));
    for (const char *at = strchr(svg + 1, '<'); at; at = strchr(at + 1, '<')) {
        if (strncmp(at, "<g opacity", 10) == 0) at = strstr(at, "</g>");
        if (strncmp(at, "<line", 5) == 0) read_element(s, at, 'l');
        if (strncmp(at, "<circle", 7) == 0) read_element(s, at, 'c');
        if (strncmp(at, "<polygon", 8) == 0) read_element(s, at, 'p');
        if (strncmp(at, "<text", 5) == 0) read_element(s, at, 't');
    }
}

// The scale is what takes the state's pins to the drawn ones, which are drawn in the order of the joints.
static void find_scale(Sheet *s)
{
    YkVec drawn[BODIES], real[BODIES];
    size_t drawn_count = 0, real_count = 0, far = 0;
    for (size_t k = 0; k < s->count; k++)
        if (s->elements[k].tag == 'c' && has(&s->elements[k], "fill=\"#ffffff\"")) {
            s->bar = s->elements[k].radius / 0.36;
            drawn[drawn_count++] = s->elements[k].at[0];
            s->elements[k].is_seen = true;
        }
    for (int slots = 0; slots < 2; slots++)
        for (size_t j = 0; j < s->model->joint_count; j++) {
            const YkJoint *joint = &s->model->joints[j];
            if (joint->kind != (slots ? YK_PIN_SLOT : YK_PIN)) continue;
            real[real_count] = place(s, 1, joint->body[1], joint->at[1]);
            if (isnan(real[real_count].x)) real[real_count] = place(s, 1, joint->body[0], joint->at[0]);
            real_count++;
        }
    assert_int_equal(drawn_count, real_count);
    assert_true(drawn_count > 1);
    for (size_t k = 0; k < real_count; k++)
        if (yk_norm(yk_sub(real[k], real[0])) > yk_norm(yk_sub(real[far], real[0]))) far = k;
    s->scale = yk_norm(yk_sub(drawn[far], drawn[0])) / yk_norm(yk_sub(real[far], real[0]));
    s->zero = yk_vec(drawn[0].x - s->scale * real[0].x, drawn[0].y + s->scale * real[0].y);
    for (size_t k = 0; k < real_count; k++) assert_true(yk_norm(yk_sub(drawn[k], pixel(s, real[k]))) < 0.05);
}

static double off_line(YkVec at, YkVec on, YkVec along)
{
    return fabs(yk_cross(along, yk_sub(at, on)));
}

// Finds the next element of this kind that nothing has claimed yet.
static Element *claim(Sheet *s, char tag, const char *words, double width)
{
    for (size_t k = 0; k < s->count; k++) {
        Element *e = &s->elements[k];
        if (e->is_seen || e->tag != tag || !has(e, words) || (width > 0 && fabs(e->width - width) > 0.011)) continue;
        e->is_seen = true;
        return e;
    }
    fail_msg("no %c with %s, %g wide", tag, words, width);
    return NULL;
}

// --- What is fixed

// A rail or the foot of a pedestal: the ground is hatched along it, on one side, in equal steps.
static void check_hatch(Sheet *s, const Element *foot, YkVec down)
{
    YkVec a = foot->at[0], b = foot->at[1], along = yk_scale(1 / yk_norm(yk_sub(b, a)), yk_sub(b, a)), last = a;
    size_t index = (size_t)(foot - s->elements), count = 0;
    double spacing = fmax(3, 0.6 * s->bar), length = yk_norm(yk_sub(b, a)), step = 0;
    for (Element *e = s->elements + index + 1; e < s->elements + s->count && has(e, "#8a8d91"); e++, count++) {
        YkVec slant = yk_sub(e->at[1], e->at[0]);
        e->is_seen = true;
        assert_true(off_line(e->at[0], a, along) < 0.03);
        CHECK_NEAR(yk_dot(slant, down), 0.75 * spacing, 0.03);
        CHECK_NEAR(yk_dot(slant, along), -0.6 * spacing, 0.03);
        if (count == 1) step = yk_dot(yk_sub(e->at[0], last), along);
        if (count > 0) CHECK_NEAR(yk_dot(yk_sub(e->at[0], last), along), step, 0.03);
        last = e->at[0];
    }
    assert_true(count > 0 && (double)count <= fmax(length / spacing, 1) && (double)count > length / spacing - 1.01);
    CHECK_NEAR(yk_dot(yk_sub(last, a), along), length * (1 - 0.25 / (double)count), 0.05);
}

static void check_pedestal(Sheet *s, YkVec at)
{
    Element *e = claim(s, 'p', "#eeeeea", 0);
    assert_int_equal(e->count, 3);
    assert_true(yk_norm(yk_sub(e->at[0], at)) < 0.03);
    CHECK_NEAR(e->at[1].x + e->at[2].x, 2 * at.x, 0.05);
    CHECK_NEAR(e->at[2].x - e->at[1].x, 2.3 * s->bar, 0.08);
    CHECK_NEAR(e->at[1].y - at.y, 1.7 * s->bar, 0.06);
    CHECK_NEAR(e->at[2].y, e->at[1].y, 0);
    Element *foot = e + 1;
    assert_true(foot->tag == 'l' && has(foot, "#55585c"));
    foot->is_seen = true;
    CHECK_NEAR(foot->at[0].x + foot->at[1].x, 2 * at.x, 0.05);
    CHECK_NEAR(foot->at[1].x - foot->at[0].x, 1.6 * 2.3 * s->bar, 0.1);
    assert_true(foot->at[0].y == e->at[1].y && foot->at[1].y == e->at[1].y);
    check_hatch(s, foot, yk_vec(0, 1));
}

// Two rails beside what slides, as far as it comes in both poses and three bars beyond.
static void check_rails(Sheet *s, const YkJoint *joint)
{
    YkVec along = line_of(s, 0, joint), low = {INFINITY, 0}, high = {-INFINITY, 0}, on = joint_pixel(s, 0, joint, 0);
    for (int pose = 0; pose < 2; pose++) {
        double far = yk_dot(yk_sub(joint_pixel(s, pose, joint, 1), on), along);
        low.x = fmin(low.x, far);
        high.x = fmax(high.x, far);
    }
    double gap = (joint->kind == YK_SLIDE ? 1.02 : 0.5) * s->bar;
    for (int side = -1; side <= 1; side += 2) {
        Element *rail = claim(s, 'l', "#55585c", 1.4);
        YkVec out = yk_scale(side, yk_quarter(along));
        for (int end = 0; end < 2; end++) {
            YkVec off = yk_sub(rail->at[end], on);
            CHECK_NEAR(yk_dot(off, out), gap, 0.05);
            CHECK_NEAR(yk_dot(off, along), end ? high.x + 3 * s->bar : low.x - 3 * s->bar, 0.15);
        }
        check_hatch(s, rail, out);
    }
}

static void check_guides(Sheet *s)
{
    for (size_t j = 0; j < s->model->joint_count; j++) {
        const YkJoint *joint = &s->model->joints[j];
        if ((joint->body[0] != 0 && joint->body[1] != 0) || joint->kind == YK_WELD) continue;
        if (joint->kind == YK_PIN)
            check_pedestal(s, joint_pixel(s, 0, joint, joint->body[1] == 0));
        else if (joint->body[0] == 0)
            check_rails(s, joint);
        else
            check_pedestal(s, joint_pixel(s, 0, joint, 1));
    }
}

// --- What moves

// A thin rod from where the line begins to where the other body is on it, and a little beyond.
static void check_rods(Sheet *s, YkPartKind kind)
{
    for (size_t j = 0; j < s->model->joint_count; j++) {
        const YkJoint *joint = &s->model->joints[j];
        if (joint->kind != kind || joint->body[0] == 0) continue;
        Element *rod = claim(s, 'l', "stroke-linecap=\"round\"", fmax(1, 0.35 * s->bar));
        YkVec from = joint_pixel(s, 1, joint, 0), to = joint_pixel(s, 1, joint, 1), along = line_of(s, 1, joint);
        double way = yk_dot(yk_sub(to, from), along);
        assert_true(yk_norm(yk_sub(rod->at[0], from)) < 0.05);
        assert_true(off_line(rod->at[1], from, along) < 0.05);
        CHECK_NEAR(fabs(yk_dot(yk_sub(rod->at[1], to), along)), 2.2 * s->bar, 0.1);
        CHECK_NEAR(fabs(yk_dot(yk_sub(rod->at[1], from), along)), fabs(way) + 2.2 * s->bar, 0.1);
    }
}

// Where a point of a body lies against an outline that turns one way: inside or on it.
static void check_within(const Element *outline, YkVec at)
{
    double turned = 0;
    for (size_t k = 0; k < outline->count; k++)
        turned += yk_cross(outline->at[k], outline->at[(k + 1) % outline->count]);
    for (size_t k = 0; k < outline->count; k++) {
        YkVec a = outline->at[k], edge = yk_sub(outline->at[(k + 1) % outline->count], a);
        double inside = yk_cross(edge, yk_sub(at, a)) / fmax(yk_norm(edge), 1e-9);
        assert_true(turned > 0 ? inside > -0.05 : inside < 0.05);
    }
}

// All places of a body that something names: at most so many, on the page.
static size_t spots_of(const Sheet *s, size_t body, YkVec *spots)
{
    size_t count = 0;
    for (size_t k = 0; k < s->model->point_count; k++)
        if ((size_t)s->model->points[k].body == body)
            spots[count++] = pixel(s, place(s, 1, (int32_t)body, s->model->points[k].at));
    for (size_t j = 0; j < s->model->joint_count; j++)
        for (int side = 0; side < 2; side++)
            if ((size_t)s->model->joints[j].body[side] == body)
                spots[count++] = joint_pixel(s, 1, &s->model->joints[j], side);
    return count;
}

// Bars and plates: twice the same outline, whose corners are places of the body and which contains all of them.
static void check_bodies(Sheet *s)
{
    for (size_t b = 1; b < s->model->body_count; b++) {
        YkVec spots[64];
        size_t count = spots_of(s, b, spots);
        double extent = 0, flat = 0;
        for (size_t i = 0; i < count; i++)
            for (size_t k = 0; k < i; k++) extent = fmax(extent, yk_norm(yk_sub(spots[i], spots[k])));
        if (extent < 0.2) continue;
        YkVec first = spots[0], second = spots[0];
        for (size_t i = 0; i < count; i++)
            if (yk_norm(yk_sub(spots[i], first)) > yk_norm(yk_sub(second, first))) second = spots[i];
        for (size_t i = 0; i < count; i++)
            flat = fmax(flat,
                        off_line(spots[i], first, yk_scale(1 / yk_norm(yk_sub(second, first)), yk_sub(second, first))));
        char tag = flat > 0.1 ? 'p' : 'l';
        const char *words = "stroke-linecap=\"round\"";
        Element *edge = claim(s, tag, words, s->bar),
                *fill = claim(s, tag, words, s->bar - 2 * fmin(1.3, 0.2 * s->bar));
        assert_true(fill == edge + 1 && fill->count == edge->count);
        for (size_t k = 0; k < edge->count; k++) {
            double nearest = INFINITY;
            for (size_t i = 0; i < count; i++) nearest = fmin(nearest, yk_norm(yk_sub(edge->at[k], spots[i])));
            assert_true(nearest < 0.05 && yk_norm(yk_sub(edge->at[k], fill->at[k])) == 0);
        }
        for (size_t i = 0; i < count && tag == 'p'; i++) check_within(edge, spots[i]);
        if (tag == 'l') CHECK_NEAR(yk_norm(yk_sub(edge->at[1], edge->at[0])), extent, 0.05);
    }
}

// Slots as far as the pin comes in both poses, half a bar beyond, three strokes thick.
static void check_slots(Sheet *s)
{
    for (size_t j = 0; j < s->model->joint_count; j++) {
        const YkJoint *joint = &s->model->joints[j];
        if (joint->kind != YK_PIN_SLOT || joint->body[0] == 0) continue;
        double low = INFINITY, high = -INFINITY;
        for (int pose = 0; pose < 2; pose++) {
            double far =
                yk_dot(yk_sub(joint_pixel(s, pose, joint, 1), joint_pixel(s, pose, joint, 0)), line_of(s, pose, joint));
            low = fmin(low, far);
            high = fmax(high, far);
        }
        const double widths[] = {1.9 * s->bar, 1.9 * s->bar - fmin(2.6, 0.4 * s->bar), s->bar};
        for (int k = 0; k < 3; k++) {
            Element *e = claim(s, 'l', k < 2 ? "stroke-linecap=\"round\"" : "stroke=\"#ffffff\"", widths[k]);
            for (int end = 0; end < 2; end++) {
                YkVec off = yk_sub(e->at[end], joint_pixel(s, 1, joint, 0)), along = line_of(s, 1, joint);
                CHECK_NEAR(yk_cross(along, off), 0, 0.05);
                CHECK_NEAR(yk_dot(along, off), end ? high + 0.5 * s->bar : low - 0.5 * s->bar, 0.08);
            }
        }
    }
}

// Boxes of what slides along its line, longer than wide; dark squares on welds.
static void check_boxes(Sheet *s)
{
    for (size_t j = 0; j < s->model->joint_count; j++) {
        const YkJoint *joint = &s->model->joints[j];
        if (joint->kind != YK_SLIDE && joint->kind != YK_WELD) continue;
        bool is_weld = joint->kind == YK_WELD;
        Element *e = claim(s, 'p', is_weld ? "fill=\"#2b2d30\"" : "stroke-linejoin=\"round\" stroke-linecap=\"round\"",
                           is_weld ? 0 : fmin(1.3, 0.2 * s->bar));
        YkVec at = joint_pixel(s, 1, joint, 1), along = is_weld ? yk_vec(1, 0) : line_of(s, 1, joint);
        double length = is_weld ? 0.45 : 1.6, across = is_weld ? 0.45 : 0.96;
        assert_int_equal(e->count, 4);
        for (int k = 0; k < 4; k++) {
            CHECK_NEAR(fabs(yk_dot(yk_sub(e->at[k], at), along)), length * s->bar, 0.06);
            CHECK_NEAR(fabs(yk_cross(yk_sub(e->at[k], at), along)), across * s->bar, 0.06);
            assert_true(yk_norm(yk_sub(e->at[k], e->at[(k + 1) % 4])) < 3.3 * s->bar); // in order round the box
        }
    }
}

static void check_points(Sheet *s)
{
    for (size_t k = 0; k < s->model->point_count; k++) {
        const YkPoint *point = &s->model->points[k];
        if (point->body == 0) continue;
        Element *e = claim(s, 'c', "stroke=\"none\"", 0);
        assert_true(yk_norm(yk_sub(e->at[0], pixel(s, place(s, 1, point->body, point->at)))) < 0.05);
        CHECK_NEAR(e->radius, fmax(0.5, 0.2 * s->bar), 0.011);
    }
}

// --- Words

static void check_name(Sheet *s, const char *name, YkVec at)
{
    char words[300];
    snprintf(words, sizeof words, ">%s</text>", name);
    for (size_t k = 0; k < s->count; k++) {
        Element *e = &s->elements[k];
        if (e->is_seen || e->tag != 't' || strncmp(e->end, words, strlen(words)) != 0) continue;
        if (fabs(e->at[0].x - at.x) > 50 + 3.7 * (double)strlen(name) || fabs(e->at[0].y - at.y) > 70) continue;
        e->is_seen = true;
        return;
    }
    fail_msg("%s is not named where it is", name);
}

static void check_words(Sheet *s)
{
    for (size_t j = 0; j < s->model->joint_count; j++)
        check_name(s, s->model->joints[j].name, joint_pixel(s, 1, &s->model->joints[j], 1));
    for (size_t b = 1; b < s->model->body_count; b++) {
        YkVec spots[64], low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
        size_t count = spots_of(s, b, spots);
        for (size_t i = 0; i < count; i++) {
            low = yk_vec(fmin(low.x, spots[i].x), fmin(low.y, spots[i].y));
            high = yk_vec(fmax(high.x, spots[i].x), fmax(high.y, spots[i].y));
        }
        YkVec middle = yk_scale(0.5, yk_add(low, high));
        bool is_bar = count > 0;
        check_name(s, s->model->bodies[b].name, is_bar ? middle : pixel(s, s->origin[1][b]));
    }
}

// The bar is as long as it says, a round number, at most a fifth of the page.
static void check_scale_bar(Sheet *s)
{
    Element *bar = claim(s, 'l', "#55585c", 1.2);
    double length = bar->at[1].x - bar->at[0].x, unit = 1;
    const char *name = yk_model_unit(s->model, YK_QUANTITY_LENGTH, &unit);
    for (int end = 0; end < 2; end++) {
        Element *tick = claim(s, 'l', "#55585c", 1.2);
        CHECK_NEAR(tick->at[0].x, bar->at[end].x, 0);
        CHECK_NEAR(tick->at[1].x, bar->at[end].x, 0);
        CHECK_NEAR(tick->at[0].y + tick->at[1].y, 2 * bar->at[end].y, 1e-9);
        assert_true(fabs(tick->at[1].y - tick->at[0].y) > 4);
    }
    Element *word = claim(s, 't', "font-size=\"12\"", 0);
    char *end;
    double told = strtod(word->end + 1, &end), digit = told / pow(10, floor(log10(told) + 1e-9));
    assert_memory_equal(end + 1, name, strlen(name));
    CHECK_NEAR(told * unit * s->scale, length, 0.02 + 1e-3 * length);
    assert_true(fabs(digit - 1) < 1e-9 || fabs(digit - 2) < 1e-9 || fabs(digit - 5) < 1e-9);
    assert_true(length <= 0.2 * s->width + 0.01 && length > 0.2 * s->width / 2.5 - 0.01);
    assert_true(word->at[0].x > bar->at[1].x && fabs(word->at[0].y - bar->at[0].y) < 6);
    assert_true(bar->at[0].y < s->height - 5 && bar->at[0].y > s->height - 40);
    Element *title = claim(s, 't', "font-size=\"16\"", 0);
    assert_memory_equal(title->end + 1, yk_model_name(s->model), strlen(yk_model_name(s->model)));
}

// Both poses fill the page between its margins, in one direction at least.
static void check_fit(const Sheet *s)
{
    YkVec low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    for (int pose = 0; pose < 2; pose++)
        for (size_t j = 0; j < s->model->joint_count; j++)
            for (int side = 0; side < 2; side++) {
                YkVec at = joint_pixel(s, pose, &s->model->joints[j], side);
                low = yk_vec(fmin(low.x, at.x), fmin(low.y, at.y));
                high = yk_vec(fmax(high.x, at.x), fmax(high.y, at.y));
            }
    for (size_t k = 0; k < s->model->point_count; k++)
        for (int pose = 0; pose < 2; pose++) {
            const YkPoint *point = &s->model->points[k];
            if (point->body == 0) continue; // the ground has no outline
            YkVec at = pixel(s, place(s, pose, point->body, point->at));
            low = yk_vec(fmin(low.x, at.x), fmin(low.y, at.y));
            high = yk_vec(fmax(high.x, at.x), fmax(high.y, at.y));
        }
    CHECK_NEAR(low.x + high.x, s->width, 0.1);
    CHECK_NEAR(low.y, 64 + 30, 0.1);
    CHECK_NEAR(s->height - high.y, 64 + 26, 0.1);
    assert_true(low.x > 63.9 && (low.x < 64.1 || fabs(high.y - low.y - (1.1 * s->width - 128)) < 0.1));
}

static void check_machine(const char *name, YkModel *model)
{
    static Sheet sheet;
    Sheet *s = &sheet;
    *s = (Sheet){.model = model};
    s->mech = yk_mechanism_compile(s->model, NULL, NULL);
    s->state = yk_state_new(s->mech);
    assert_true(yk_state_set_time(s->state, 0, NULL) >= 0 && yk_state_assemble(s->state) >= 0);
    YkDrawing *drawing = yk_drawing_new(s->mech, NULL);
    for (int pose = 0; pose < 2; pose++) {
        YkMotion input = yk_state_input(s->state, 0);
        input.position +=
            pose * (yk_coordinate_info(s->mech, yk_input_coordinate(s->mech, 0)).is_distance ? 0.01 : 0.2);
        yk_state_set_input(s->state, 0, input);
        assert_true(yk_state_solve(s->state) >= 0);
        take_frames(s, pose);
        assert_int_equal(yk_drawing_pose(drawing, s->state), YK_OK);
    }
    read_page(s, yk_drawing_svg(drawing));
    find_scale(s);
    check_fit(s);
    check_guides(s);
    check_scale_bar(s);
    check_rods(s, YK_SLIDE);
    check_rods(s, YK_PIN_SLOT);
    check_bodies(s);
    check_slots(s);
    check_boxes(s);
    check_points(s);
    check_words(s);
    for (size_t k = 0; k < s->count; k++)
        if (!s->elements[k].is_seen) fail_msg("%s: %.60s is none of its parts", name, s->elements[k].text);
    yk_drawing_free(drawing);
    yk_state_free(s->state);
    yk_mechanism_free(s->mech);
    yk_model_free(s->model);
}

static void every_part_is_drawn_where_it_is(void **state)
{
    (void)state;
    static const char *const names[] = {"four-bar",
                                        "quick-return",
                                        "toggle",
                                        "scotch-yoke",
                                        "elliptic-trammel",
                                        "jansen",
                                        "oscillating-cylinder",
                                        "inverted-slider-crank",
                                        "doubled-guide",
                                        "slider-crank",
                                        "excavator",
                                        "steam-engine"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        char path[500];
        snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, names[k]);
        check_machine(names[k], yk_model_load(path, NULL, NULL));
    }
}

// Slots and guides of bodies that move over a place of the ground, which has a pedestal; welds, which have none.
static void guides_may_move_over_the_ground(void **state)
{
    (void)state;
    static const char slot[] = "bodies: {ground: {points: {O: [0, 0], C: [0.3, 0.1], W: [0.1, -0.2]}}, crank: {points: "
                               "{O: [0, 0], A: [0.1, 0]}}, "
                               "rod: {points: {A: [0, 0], E: [0.5, 0]}}, flag: {points: {E: [0, 0], F: [0, 0.1]}}, "
                               "post: {points: {W: [0, 0], X: [0.1, 0]}}}\n"
                               "joints: {O: {pin: [ground, crank], angle: theta}, A: {pin: [crank, rod], angle: phi}, "
                               "C: {pin-slot: [rod, ground], at: C, from: A, along: x}, E: {weld: [rod, flag], at: E}, "
                               "W: {weld: [ground, post], at: W}}\n"
                               "start: {theta: 1, phi: -1}\n";
    static const char guide[] = "bodies: {ground: {points: {G: [0, 0]}}, bar: {points: {S: [0, 0], T: [0.3, 0]}}, "
                                "arm: {points: {T: [0, 0], Z: [0.1, 0]}}}\n"
                                "joints: {S: {slide: [bar, ground], along: x, from: S, to: G, distance: s}, "
                                "T: {pin: [bar, arm], angle: q}, Z: {pin: [arm, tip], at: Z, angle: r}}\n"
                                "start: {s: 0.1}\n";
    YkProblems *problems = yk_problems_new();
    char whole[900];
    snprintf(whole, sizeof whole, "%s", guide);
    char *end = strstr(whole, "}}\njoints");
    char rest[500];
    snprintf(rest, sizeof rest, "%s", end + 1);
    snprintf(end + 1, sizeof whole - (size_t)(end + 1 - whole), ", tip: {points: {Z: [0, 0], Y: [0, 0.1]}}%s", rest);
    const char *const texts[] = {slot, whole};
    for (int k = 0; k < 2; k++) {
        YkModel *model = yk_model_parse(texts[k], strlen(texts[k]), "t.yaml", NULL, problems);
        if (!model) fail_msg("%s", yk_problems_text(problems, 0));
        check_machine("guide", model);
    }
    yk_problems_free(problems);
}

static size_t count_of(const char *text, const char *word)
{
    size_t found = 0;
    for (const char *at = strstr(text, word); at; at = strstr(at + 1, word)) found++;
    return found;
}

// There are names for everything, or, where there are too many, for nothing.
static void all_parts_are_named_or_none(void **state)
{
    (void)state;
    size_t named = 0;
    for (int links = 44; links <= 60; links += 2) {
        YkText text = {0};
        yk_text_puts(&text, "bodies:\n  ground: {points: {J1: [0, 0]}}\n");
        for (int k = 1; k <= links; k++)
            yk_text_format(&text, "  b%d: {points: {J%d: [0, 0], J%d: [1, 0]}}\n", k, k, k + 1);
        yk_text_puts(&text, "joints:\n");
        for (int k = 1; k <= links; k++) {
            yk_text_format(&text, k == 1 ? "  J%d: {pin: [ground" : "  J%d: {pin: [b%d", k, k - 1);
            yk_text_format(&text, ", b%d], angle: q%d}\n", k, k);
        }
        YkModel *model = yk_model_parse(yk_text_get(&text), text.length, "t.yaml", NULL, NULL);
        YkMechanism *mech = yk_mechanism_compile(model, NULL, NULL);
        YkState *pose = yk_state_new(mech);
        assert_true(yk_state_assemble(pose) >= 0);
        YkDrawing *drawing = yk_drawing_new(mech, NULL);
        assert_int_equal(yk_drawing_pose(drawing, pose), YK_OK);
        const char *svg = yk_drawing_svg(drawing);
        size_t joints = count_of(svg, ">J"), bodies = count_of(svg, ">b");
        assert_true(joints == bodies && (joints == 0 || joints == (size_t)links));
        named += joints > 0;
        yk_drawing_free(drawing);
        yk_state_free(pose);
        yk_mechanism_free(mech);
        yk_model_free(model);
        yk_text_free(&text);
    }
    assert_true(named > 0 && named < 9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_part_is_drawn_where_it_is),
                                       cmocka_unit_test(guides_may_move_over_the_ground),
                                       cmocka_unit_test(all_parts_are_named_or_none)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
