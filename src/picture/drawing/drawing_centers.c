// Instant centres on a drawing: where each lies, the lines that meet there, and, in words, those beyond the page.
#include <math.h>
#include <stdlib.h>
#include "picture/drawing/drawing.h"
#include "picture/svg.h"

enum { LINE = 16 };

YkStatus yk_drawing_centers(YkDrawing *drawing, const YkCenters *centers)
{
    if (!drawing) return YK_BAD_ARGUMENT;
    size_t count = yk_centers_count(centers);
    YkCenter *items = calloc(count + 1, sizeof *items);
    bool *shown = calloc(count + 1, sizeof *shown);
    if (!items || !shown) {
        free(items);
        free(shown);
        return YK_NO_MEMORY;
    }
    for (size_t k = 0; k < count; k++) items[k] = yk_centers_at(centers, k);
    free(drawing->centers);
    free(drawing->shows_center);
    drawing->centers = items;
    drawing->shows_center = shown;
    drawing->center_count = count;
    return YK_OK;
}

// Centres no farther from the machine than it is large are shown, and the page is made to hold them.
void yk_drawing_include_centers(YkDrawing *drawing)
{
    YkVec low = drawing->low, high = drawing->high;
    double reach = fmax(high.x - low.x, high.y - low.y);
    for (size_t k = 0; k < drawing->center_count; k++) {
        const YkCenter *c = &drawing->centers[k];
        bool is_near = c->kind == YK_CENTER_POINT && c->at[0] >= low.x - reach && c->at[0] <= high.x + reach &&
                       c->at[1] >= low.y - reach && c->at[1] <= high.y + reach;
        drawing->shows_center[k] = is_near;
        if (!is_near) continue;
        drawing->low = yk_vec(fmin(drawing->low.x, c->at[0]), fmin(drawing->low.y, c->at[1]));
        drawing->high = yk_vec(fmax(drawing->high.x, c->at[0]), fmax(drawing->high.y, c->at[1]));
    }
}

double yk_drawing_notes(const YkDrawing *drawing)
{
    double height = 0;
    for (size_t k = 0; k < drawing->center_count; k++) height += drawing->shows_center[k] ? 0 : LINE;
    return height;
}

static YkVec pixel_of(const YkDrawing *drawing, const YkCenter *c)
{
    return yk_drawing_pixel(drawing, yk_vec(c->at[0], c->at[1]));
}

// The line on which Kennedy's theorem has a centre: through the centres of both bodies with a third one.
static void add_line(YkDrawing *drawing, const YkCenter *c, size_t third)
{
    YkVec ends[3];
    size_t count = 0;
    for (size_t k = 0; k < drawing->center_count; k++) {
        const YkCenter *other = &drawing->centers[k];
        bool has_third = other->body[0] == third || other->body[1] == third;
        size_t rest = other->body[0] == third ? other->body[1] : other->body[0];
        if (drawing->shows_center[k] && has_third && (rest == c->body[0] || rest == c->body[1]) && count < 2)
            ends[count++] = pixel_of(drawing, other);
    }
    ends[count++] = pixel_of(drawing, c);
    for (size_t k = 0; k + 1 < count; k++)
        yk_svg_line(&drawing->svg, ends[k], ends[count - 1],
                    "class=\"kennedy\" stroke=\"#7a3fa0\" stroke-width=\"0.8\" stroke-dasharray=\"5 4\"");
}

static void add_names(const YkDrawing *drawing, const YkCenter *c, YkText *text)
{
    yk_text_format(text, "%s%s/%s", text->length > 0 ? ", " : "", drawing->model->bodies[c->body[0]].name,
                   drawing->model->bodies[c->body[1]].name);
}

// Centres that coincide on the page share one mark and one line of names. A centre at a joint has the joint's name.
static void add_mark(YkDrawing *drawing, size_t index)
{
    YkText names = {0};
    YkVec at = pixel_of(drawing, &drawing->centers[index]);
    bool is_told = false;
    for (size_t k = 0; k < drawing->center_count; k++) {
        if (!drawing->shows_center[k] || yk_norm(yk_sub(at, pixel_of(drawing, &drawing->centers[k]))) > 3) continue;
        is_told |= k < index;
        if (drawing->centers[k].source != YK_CENTER_JOINT) add_names(drawing, &drawing->centers[k], &names);
    }
    if (!is_told) {
        yk_svg_circle(&drawing->svg, at, 4.5,
                      "class=\"center\" fill=\"#fcfcfa\" stroke=\"#7a3fa0\" stroke-width=\"1.6\"");
        bool is_right = at.x > 0.75 * drawing->width; // there the name goes to the left
        if (drawing->options.labels && names.length > 0)
            yk_svg_word(&drawing->svg, yk_add(at, yk_vec(is_right ? -8 : 8, 14)), yk_text_get(&names),
                        is_right ? "fill=\"#7a3fa0\" font-size=\"11\" text-anchor=\"end\""
                                 : "fill=\"#7a3fa0\" font-size=\"11\" text-anchor=\"start\"");
    }
    drawing->svg.failed |= names.failed;
    yk_text_free(&names);
}

static void add_note(YkDrawing *drawing, const YkCenter *c, YkVec at)
{
    YkText text = {0};
    add_names(drawing, c, &text);
    if (c->kind == YK_CENTER_UNDEFINED)
        yk_text_puts(&text, ": they move as one");
    else if (c->kind == YK_CENTER_AT_INFINITY)
        yk_text_format(&text, ": at infinity towards %e deg", c->direction * 180 / YK_PI);
    else
        yk_text_format(&text, ": far away, at x = %e m, y = %e m", c->at[0], c->at[1]);
    yk_svg_word(&drawing->svg, at, yk_text_get(&text), "class=\"center-note\" fill=\"#7a3fa0\" font-size=\"11\"");
    drawing->svg.failed |= text.failed;
    yk_text_free(&text);
}

void yk_drawing_mark_centers(YkDrawing *drawing)
{
    static const double foot = 34; // of the bar that shows the scale, px
    double y = drawing->height - foot - yk_drawing_notes(drawing);
    for (size_t k = 0; k < drawing->center_count; k++) {
        const YkCenter *c = &drawing->centers[k];
        for (size_t i = 0; i < 2 && drawing->shows_center[k] && c->source == YK_CENTER_KENNEDY; i++)
            add_line(drawing, c, c->by[i]);
    }
    for (size_t k = 0; k < drawing->center_count; k++) {
        if (drawing->shows_center[k]) {
            add_mark(drawing, k);
        } else {
            add_note(drawing, &drawing->centers[k], yk_vec(20, y));
            y += LINE;
        }
    }
}
