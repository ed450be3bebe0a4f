// Draws force polygons, each body's in a cell with its own scale, with the words below.
#include <math.h>
#include "base/escape.h"
#include "design/polygons/force_polygon.h"
#include "model/shown_unit.h"
#include "picture/polygon_sheet.h"
#include "picture/svg.h"

enum { MARGIN = 40, CELL_WIDTH = 400, CELL_HEIGHT = 340, COLUMNS = YK_SHEET_WIDTH / CELL_WIDTH };

static const char *const colours[] = {
    [YK_FORCE_WEIGHT] = "#5b5f66",  [YK_FORCE_LOADS] = "#8a4480",   [YK_FORCE_INERTIA] = "#5b5f66",
    [YK_FORCE_PLANETS] = "#2f6b3a", [YK_FORCE_CONTACT] = "#2f6b3a", [YK_FORCE_REACTION] = "#b3261e",
};
static const char *const classes[] = {
    [YK_FORCE_WEIGHT] = "weight",   [YK_FORCE_LOADS] = "loads",     [YK_FORCE_INERTIA] = "inertia",
    [YK_FORCE_PLANETS] = "planets", [YK_FORCE_CONTACT] = "contact", [YK_FORCE_REACTION] = "reaction",
};

// A body's polygon: its vectors and where they are drawn.
typedef struct Cell {
    const YkForceVector *vector; // [count]
    size_t count;
    YkVec corner, low, high;
    double scale; // px per N; 0: moments alone
} Cell;

static void include(Cell *cell, YkVec at)
{
    cell->low = yk_vec(fmin(cell->low.x, at.x), fmin(cell->low.y, at.y));
    cell->high = yk_vec(fmax(cell->high.x, at.x), fmax(cell->high.y, at.y));
}

static YkVec start_of(const YkForceVector *v)
{
    return yk_vec(v->start[0], v->start[1]);
}
static YkVec end_of(const YkForceVector *v)
{
    return yk_vec(v->start[0] + v->value[0], v->start[1] + v->value[1]);
}

static void fit(Cell *cell)
{
    cell->low = cell->high = yk_vec(0, 0);
    for (size_t k = 0; k < cell->count; k++) include(cell, end_of(&cell->vector[k]));
    double across = cell->high.x - cell->low.x, up = cell->high.y - cell->low.y;
    cell->scale = fmin((CELL_WIDTH - 3 * MARGIN) / across, (CELL_HEIGHT - 3 * MARGIN) / up);
    if (!isfinite(cell->scale)) cell->scale = 0;
}

static YkVec pixel(const Cell *cell, YkVec at)
{
    YkVec middle = yk_scale(0.5, yk_add(cell->low, cell->high));
    return yk_vec(cell->corner.x + 0.5 * CELL_WIDTH + (at.x - middle.x) * cell->scale,
                  cell->corner.y + 0.5 * CELL_HEIGHT - (at.y - middle.y) * cell->scale);
}

static void add_vector(YkText *svg, const Cell *cell, const YkForceVector *v)
{
    YkVec a = pixel(cell, start_of(v)), b = pixel(cell, end_of(v)), middle = yk_scale(0.5, yk_add(a, b));
    YkText style = {0};
    if (yk_norm(yk_sub(b, a)) <= 0.05) return;
    yk_sheet_arrow(svg, a, b, classes[v->part], colours[v->part], v->part == YK_FORCE_INERTIA);
    // Beside the vector, on the side that is away from the middle of the polygon.
    YkVec from = yk_sub(middle, pixel(cell, yk_scale(0.5, yk_add(cell->low, cell->high))));
    yk_text_format(&style, "fill=\"%s\" font-style=\"italic\"%s", colours[v->part],
                   from.x < 0 ? " text-anchor=\"end\"" : "");
    YkVec at = yk_add(middle, yk_vec(from.x < 0 ? -7 : 7, from.y < 0 ? -5 : 12));
    yk_svg_word(svg, at, v->name, yk_text_get(&style));
    svg->failed |= style.failed;
    yk_text_free(&style);
}

static void add_cell(YkText *svg, const YkModel *model, Cell *cell)
{
    const char *name = model->bodies[cell->vector->body].name;
    fit(cell);
    yk_text_puts(svg, "<g data-body=\"");
    yk_escape_xml(svg, name);
    yk_text_format(svg, "\" data-scale=\"%g\">\n", cell->scale);
    for (size_t k = 0; k < cell->count; k++) add_vector(svg, cell, &cell->vector[k]);
    yk_svg_word(svg, yk_add(cell->corner, yk_vec(MARGIN, 28)), name, "font-weight=\"bold\"");
    YkVec foot = yk_add(cell->corner, yk_vec(MARGIN, CELL_HEIGHT - 18));
    double size = 1;
    const char *unit = yk_model_shown_unit(model, YK_QUANTITY_FORCE, &size);
    if (cell->scale > 0)
        yk_sheet_scale(svg, foot, cell->scale * size, 80, unit);
    else
        yk_svg_word(svg, foot, "moments alone", "");
    yk_text_puts(svg, "</g>\n");
}

const char *yk_force_polygons_svg(YkForcePolygons *p)
{
    if (!p) return NULL;
    YkText *svg = &p->svg;
    size_t rows = (p->step_count + COLUMNS - 1) / COLUMNS, index = 0;
    double y = (double)(rows * CELL_HEIGHT) + 26, end = y;
    yk_text_clear(svg);
    for (size_t k = 0; k < p->step_count; k++) end = yk_sheet_words(svg, k, p->step[k], end, false);
    yk_sheet_open(svg, end + 6, "", p->model->name, "force polygons");
    for (size_t k = 0; k < p->vector_count; index++) {
        Cell cell = {.vector = &p->vector[k]};
        while (k < p->vector_count && p->vector[k].body == cell.vector->body) cell.count++, k++;
        cell.corner = yk_vec((double)(index % COLUMNS * CELL_WIDTH), (double)(index / COLUMNS * CELL_HEIGHT));
        add_cell(svg, p->model, &cell);
    }
    for (size_t k = 0; k < p->step_count; k++) y = yk_sheet_words(svg, k, p->step[k], y, true);
    yk_text_puts(svg, "</svg>\n");
    return svg->failed ? NULL : yk_text_get(svg);
}
