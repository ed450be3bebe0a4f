// The candidates of a synthesis side by side: each at its first position, with the task and its curve.
#include <math.h>
#include "picture/svg.h"
#include "synthesis/paths/path_chain.h"
#include "synthesis/synthesis.h"
#include "base/number.h"

enum { COLUMNS = 3, CELL = 270, CAPTION = 40, MARGIN = 22, SHOWN_MAX = 60 };

// A cell of the picture: metres to pixels.
typedef struct Cell {
    YkText *svg;
    YkVec middle, origin; // m; px
    double scale;         // px per m
} Cell;

static YkVec pixel(const Cell *cell, YkVec at)
{
    YkVec off = yk_scale(cell->scale, yk_sub(at, cell->middle));
    return yk_vec(cell->origin.x + off.x, cell->origin.y - off.y);
}

static void line(const Cell *cell, YkVec a, YkVec b, const char *style)
{
    yk_svg_line(cell->svg, pixel(cell, a), pixel(cell, b), style);
}

typedef struct Box {
    YkVec low, high;
} Box;

static void include(Box *box, YkVec at)
{
    box->low = yk_vec(fmin(box->low.x, at.x), fmin(box->low.y, at.y));
    box->high = yk_vec(fmax(box->high.x, at.x), fmax(box->high.y, at.y));
}

static Cell cell_for(YkText *svg, const Box *box, YkVec corner)
{
    double size = fmax(fmax(box->high.x - box->low.x, box->high.y - box->low.y), 1e-12);
    YkVec middle = yk_scale(0.5, yk_add(box->low, box->high)), origin = yk_vec(CELL / 2.0, CELL / 2.0);
    return (Cell){svg, middle, yk_add(corner, origin), (CELL - 2 * MARGIN) / size};
}

// An existing machine is shown by the curve of its point alone.
static Cell fit_curve(YkText *svg, const YkSynthesis *s, const YkFound *found, YkVec corner)
{
    const YkMachineTask *machine = &s->task->machine;
    Box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (size_t r = 0; r < found->rows; r++) include(&box, yk_vec(found->curve[2 * r], found->curve[2 * r + 1]));
    for (size_t r = 0; r < s->own_rows; r++) include(&box, yk_vec(s->own[2 * r], s->own[2 * r + 1]));
    for (size_t k = 0; k < machine->goal_count; k++)
        for (size_t i = 0; i < machine->goal[k].count; i++) include(&box, machine->goal[k].point[i]);
    return cell_for(svg, &box, corner);
}

static bool has_dyad(const YkDesign *d)
{
    return yk_bar_size(d->kind) > YK_BAR_PLAIN;
}

static Cell fit(YkText *svg, const YkSynthesis *s, const YkFound *found, YkVec corner)
{
    const YkDesign *d = &found->design;
    const YkMotionTask *motion = &s->task->motion;
    YkDesignPlaces at = yk_design_places(d);
    Box box = {d->pivot[0], d->pivot[0]};
    include(&box, d->pivot[1]);
    include(&box, at.A);
    include(&box, at.B);
    include(&box, at.P);
    if (has_dyad(d)) {
        include(&box, at.C);
        include(&box, at.D);
        include(&box, at.E);
    }
    for (size_t k = 0; k < motion->count; k++) include(&box, motion->pose[k].at);
    for (size_t k = 0; k < s->task->path.count; k++) include(&box, s->task->path.point[k]);
    for (size_t r = 0; r < found->rows && d->has_point; r++)
        include(&box, yk_vec(found->curve[2 * r], found->curve[2 * r + 1]));
    return cell_for(svg, &box, corner);
}

// The task's positions: an origin and the body's x axis.
static void draw_positions(const Cell *cell, const YkMotionTask *motion)
{
    for (size_t k = 0; k < motion->count; k++) {
        YkVec at = motion->pose[k].at, along = yk_scale(22 / cell->scale, yk_unit(motion->pose[k].angle));
        line(cell, at, yk_add(at, along), "stroke=\"#c0392b\" stroke-width=\"2\"");
        line(cell, at, yk_add(at, yk_scale(0.5, yk_quarter(along))), "stroke=\"#c0392b\" stroke-width=\"1\"");
        YkVec name = yk_add(pixel(cell, at), yk_vec(-4, 13));
        char digit[2] = {(char)('1' + k), '\0'};
        yk_svg_word(cell->svg, name, digit, "fill=\"#c0392b\" font-size=\"10\"");
    }
}

static void draw_points(const Cell *cell, const YkVec *point, size_t count)
{
    for (size_t k = 0; k < count; k++) yk_svg_circle(cell->svg, pixel(cell, point[k]), 2.5, "fill=\"#c0392b\"");
}

static void draw_rows(const Cell *cell, const double *curve, size_t rows, const char *style)
{
    YkVec points[YK_CURVE_ROWS];
    for (size_t r = 0; r < rows; r++) points[r] = pixel(cell, yk_vec(curve[2 * r], curve[2 * r + 1]));
    yk_svg_polyline(cell->svg, points, rows, style);
}

static void draw_curve(const Cell *cell, const YkFound *found)
{
    draw_rows(cell, found->curve, found->rows, "fill=\"none\" stroke=\"#2471a3\" stroke-width=\"1.3\"");
}

static const char *const bar = "stroke=\"#34495e\" stroke-width=\"3\" stroke-linecap=\"round\"";
static const char *const thin = "stroke=\"#5d6d7e\" stroke-width=\"2\"";

static void draw_plate(const Cell *cell, YkVec a, YkVec b, YkVec c)
{
    YkVec corners[3] = {pixel(cell, a), pixel(cell, b), pixel(cell, c)};
    yk_svg_polygon(cell->svg, corners, 3, "fill=\"#aed6f1\" fill-opacity=\"0.5\" stroke=\"#5d6d7e\"");
}

static void draw_joint(const Cell *cell, YkVec at)
{
    yk_svg_circle(cell->svg, pixel(cell, at), 3, "fill=\"#fff\" stroke=\"#34495e\"");
}

// The link with the traced point, the arm, and the plates that reach to them.
static void draw_dyad(const Cell *cell, const YkDesign *d, const YkDesignPlaces *at)
{
    draw_plate(cell, at->C, at->E, at->P);
    line(cell, at->C, at->E, thin);
    line(cell, at->D, at->E, bar);
    if (d->kind == YK_DESIGN_GEARED) return;
    const YkVec end[] = {at->C, at->D};
    YkChainVariant variant = yk_chain_variant(d->kind, d->variant);
    for (size_t k = 0; k < 2; k++) {
        YkChainBody body = k == 0 ? variant.link : variant.arm;
        if (body == YK_CHAIN_INPUT) draw_plate(cell, d->pivot[0], at->A, end[k]);
        if (body == YK_CHAIN_COUPLER) draw_plate(cell, at->A, at->B, end[k]);
        if (body == YK_CHAIN_OUTPUT) draw_plate(cell, d->pivot[1], at->B, end[k]);
    }
}

static void draw_line(const Cell *cell, YkVec at, double angle)
{
    YkVec along = yk_scale(18 / cell->scale, yk_unit(angle));
    line(cell, yk_sub(at, along), yk_add(at, along), "stroke=\"#7f8c8d\" stroke-dasharray=\"4 2\"");
}

static void draw_links(const Cell *cell, const YkDesign *d)
{
    YkDesignPlaces at = yk_design_places(d);
    if (has_dyad(d))
        draw_dyad(cell, d, &at);
    else if (d->has_point)
        draw_plate(cell, at.A, at.B, at.P);
    line(cell, d->pivot[0], at.A, bar);
    if (d->kind != YK_DESIGN_GEARED) line(cell, at.A, at.B, thin);
    if (d->kind == YK_DESIGN_SLIDER_CRANK)
        draw_line(cell, at.B, d->along);
    else if (d->kind == YK_DESIGN_INVERTED)
        draw_line(cell, at.B, d->angle[1]);
    else
        line(cell, d->pivot[1], at.B, bar);
    for (size_t k = 0; k < (d->kind != YK_DESIGN_SLIDER_CRANK ? 2u : 1u); k++) {
        YkVec p = pixel(cell, d->pivot[k]);
        YkVec foot[3] = {p, {p.x - 7, p.y + 11}, {p.x + 7, p.y + 11}};
        yk_svg_polygon(cell->svg, foot, 3, "fill=\"#d5d8dc\" stroke=\"#34495e\"");
        yk_svg_circle(cell->svg, p, 3, "fill=\"#fff\" stroke=\"#34495e\"");
    }
    draw_joint(cell, at.A);
    draw_joint(cell, at.B);
    if (!has_dyad(d)) return;
    draw_joint(cell, at.C);
    draw_joint(cell, at.D);
    draw_joint(cell, at.E);
}

// The error of a function over its range, in the lower part of the cell.
static void draw_error(YkText *svg, const YkFound *found, YkVec corner)
{
    YkVec points[YK_CURVE_ROWS];
    double most = 1e-12, width = CELL - 2 * MARGIN, base = corner.y + CELL - 26;
    double range = found->curve[2 * (found->rows - 1)] - found->curve[0];
    for (size_t r = 0; r < found->rows; r++) most = fmax(most, fabs(found->curve[2 * r + 1]));
    for (size_t r = 0; r < found->rows; r++) {
        double part = range != 0 ? (found->curve[2 * r] - found->curve[0]) / range : 0;
        points[r] = yk_vec(corner.x + MARGIN + part * width, base - 18 * found->curve[2 * r + 1] / most);
    }
    yk_svg_line(svg, yk_vec(corner.x + MARGIN, base), yk_vec(corner.x + MARGIN + width, base), "stroke=\"#bdc3c7\"");
    yk_svg_polyline(svg, points, found->rows, "fill=\"none\" stroke=\"#c0392b\" stroke-width=\"1.2\"");
}

static void add_caption(const YkSynthesis *s, const YkFound *found, size_t rank, YkVec corner, YkText *svg)
{
    YkText text = {0};
    char digits[YK_NUMBER_SIZE];
    yk_number_write_digits(found->transmission[0] * 180 / YK_PI, 3, digits);
    yk_text_format(&text, "%z  %s", rank, yk_design_type(&found->design));
    yk_svg_word(svg, yk_vec(corner.x + MARGIN, corner.y + CELL + 8), yk_text_get(&text),
                "font-size=\"13\" fill=\"#212f3c\"");
    yk_text_clear(&text);
    yk_text_format(&text, "transmission from %s deg", digits);
    if (s->task->kind == YK_TASK_FUNCTION && s->task->function.of) {
        bool is_slider = found->design.kind == YK_DESIGN_SLIDER_CRANK;
        double size = YK_PI / 180;
        const char *unit = is_slider ? yk_task_unit(s->task, YK_QUANTITY_LENGTH, &size) : "deg";
        digits[yk_number_write_digits(found->worst / size, 3, digits)] = '\0';
        yk_text_format(&text, ", error up to %s %s", digits, unit);
    }
    yk_svg_word(svg, yk_vec(corner.x + MARGIN, corner.y + CELL + 24), yk_text_get(&text),
                "font-size=\"11\" fill=\"#5d6d7e\"");
    if (text.failed) yk_text_fail(svg);
    yk_text_free(&text);
}

static void draw_machine_cell(const YkSynthesis *s, size_t index, YkVec corner, YkText *svg)
{
    const YkFound *found = &s->candidates.items[index];
    const YkMachineTask *machine = &s->task->machine;
    YkText caption = {0};
    char digits[YK_NUMBER_SIZE];
    yk_text_format(svg, "<g class=\"candidate\">\n");
    if (found->rows > 0) {
        Cell cell = fit_curve(svg, s, found, corner);
        if (s->own_rows > 0)
            draw_rows(&cell, s->own, s->own_rows,
                      "class=\"before\" fill=\"none\" stroke=\"#aaa\" stroke-dasharray=\"4 3\"");
        draw_curve(&cell, found);
        for (size_t k = 0; k < machine->goal_count; k++)
            draw_points(&cell, machine->goal[k].point, machine->goal[k].count);
    }
    digits[yk_number_write_digits(found->error, 4, digits)] = '\0';
    yk_text_format(&caption, "%z  error %s", index + 1, digits);
    yk_svg_word(svg, yk_vec(corner.x + MARGIN, corner.y + CELL + 8), yk_text_get(&caption),
                "font-size=\"13\" fill=\"#212f3c\"");
    if (caption.failed) yk_text_fail(svg);
    yk_text_free(&caption);
    yk_text_puts(svg, "</g>\n");
}

static void draw_cell(const YkSynthesis *s, size_t index, YkText *svg)
{
    const YkFound *found = &s->candidates.items[index];
    YkVec corner = yk_vec((double)(index % COLUMNS) * CELL, (double)(index / COLUMNS) * (CELL + CAPTION));
    if (s->task->kind == YK_TASK_MACHINE) {
        draw_machine_cell(s, index, corner, svg);
        return;
    }
    Cell cell = fit(svg, s, found, corner);
    bool has_error = s->task->kind == YK_TASK_FUNCTION && s->task->function.of && found->rows > 0;
    yk_text_format(svg, "<g class=\"candidate\">\n");
    if (found->design.has_point && found->rows > 0) draw_curve(&cell, found);
    draw_links(&cell, &found->design);
    draw_positions(&cell, &s->task->motion);
    draw_points(&cell, s->task->path.point, s->task->path.count);
    if (has_error) draw_error(svg, found, corner);
    add_caption(s, found, index + 1, corner, svg);
    yk_text_puts(svg, "</g>\n");
}

const char *yk_synthesis_picture(YkSynthesis *s)
{
    if (!s) return NULL;
    YkText *svg = &s->picture;
    size_t count = s->candidates.count < SHOWN_MAX ? s->candidates.count : SHOWN_MAX;
    size_t columns = count < COLUMNS ? (count > 0 ? count : 1) : COLUMNS, rows = (count + COLUMNS - 1) / COLUMNS;
    size_t width = columns * CELL, height = (rows > 0 ? rows : 1) * (CELL + CAPTION);
    yk_text_clear(svg);
    yk_text_format(svg,
                   "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%z\" height=\"%z\" viewBox=\"0 0 %z %z\" "
                   "font-family=\"sans-serif\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
                   width, height, width, height);
    for (size_t k = 0; k < count; k++) draw_cell(s, k, svg);
    if (count == 0) yk_svg_word(svg, yk_vec(MARGIN, CELL / 2.0), "no machine was found", "font-size=\"14\"");
    yk_text_puts(svg, "</svg>\n");
    return svg->failed ? NULL : yk_text_get(svg);
}
