// Draws a map: a coordinate over the mapped one, and the curves of points beside it.
#include <math.h>
#include <stdlib.h>
#include "map/map.h"
#include "picture/axes.h"
#include "picture/svg.h"

enum { GAP = 40, COLOURS = 8 };

static const char *const colours[COLOURS] = {"#1f5f99", "#b35a12", "#1d7350", "#8a4480",
                                             "#8f7400", "#2b7fa3", "#a93f22", "#554aa0"};

static void add_line(const YkPanel *p, const YkVec *points, size_t count, size_t circuit, bool is_start)
{
    YkText style = {0};
    if (count < 2) return;
    yk_text_format(&style, "fill=\"none\" stroke=\"%s\" stroke-width=\"%s\"", colours[circuit % COLOURS],
                   is_start ? "3" : "1.3");
    yk_svg_polyline(p->svg, points, count, yk_text_get(&style));
    if (style.failed) yk_text_fail(p->svg);
    yk_text_free(&style);
}

// --- a coordinate over the mapped one

typedef struct Axes {
    YkMap *map;
    size_t x, y; // coordinates
    double turn[2], factor[2];
    YkPanel panel;
    YkVec *points;
} Axes;

// Returns a pose as a point of the panel: angles within it, whatever their turns.
static YkVec place(const Axes *a, double x, double y)
{
    YkVec at = yk_vec(x * a->factor[0], y * a->factor[1]);
    if (a->turn[0] > 0) at.x -= a->turn[0] * floor((at.x - a->panel.low.x) / a->turn[0]);
    if (a->turn[1] > 0) at.y -= a->turn[1] * floor((at.y - a->panel.low.y) / a->turn[1]);
    return at;
}

// Draws a branch; where it leaves the panel on one side it comes back on the other.
static void add_branch(const Axes *a, size_t circuit, size_t branch, bool is_start)
{
    YkMapBranch b = yk_map_branch(a->map, circuit, branch);
    size_t count = 0;
    YkVec before = yk_vec(0, 0);
    for (size_t r = 0; r < b.rows; r++) {
        const double *row = yk_map_row(a->map, circuit, branch, r);
        YkVec at = place(a, row[a->x], row[a->y]);
        YkVec half = yk_scale(0.5, yk_sub(a->panel.high, a->panel.low));
        if (count > 0 && (fabs(at.x - before.x) > half.x || fabs(at.y - before.y) > half.y)) {
            add_line(&a->panel, a->points, count, circuit, is_start);
            count = 0;
        }
        a->points[count++] = yk_panel_pixel(&a->panel, at);
        before = at;
    }
    add_line(&a->panel, a->points, count, circuit, is_start);
}

static void add_event(const Axes *a, size_t circuit, size_t k)
{
    YkMapEvent event = yk_map_event(a->map, circuit, k);
    double y = yk_map_event_value(a->map, circuit, k, a->y);
    YkVec at = yk_panel_pixel(&a->panel, place(a, event.at, y));
    const char *style = event.kind == YK_MAP_LIMIT          ? "fill=\"#fff\" stroke=\"#c0392b\" stroke-width=\"2\""
                        : event.kind == YK_MAP_CHANGE_POINT ? "fill=\"#c0392b\" stroke=\"none\""
                                                            : "fill=\"#fff\" stroke=\"#333\" stroke-width=\"2\"";
    yk_svg_circle(a->panel.svg, at, 4, style);
}

// Sets an axis: a whole turn of an angle, or what the values need and a little more.
static void set_axis(Axes *a, int axis, size_t coordinate, double *low, double *high)
{
    bool is_distance = a->map->mech->coordinates[coordinate].is_distance;
    *low = INFINITY, *high = -INFINITY;
    if (!is_distance) {
        double whole = axis == 0 ? a->map->tracer.period : 2 * YK_PI;
        if (!(whole > 0)) whole = 2 * YK_PI;
        *low = -YK_PI * a->factor[axis];
        *high = *low + whole * a->factor[axis];
        a->turn[axis] = whole * a->factor[axis];
        return;
    }
    for (size_t c = 0; c < yk_map_circuit_count(a->map); c++)
        for (size_t b = 0; b < yk_map_circuit(a->map, c).branches; b++)
            for (size_t r = 0; r < yk_map_branch(a->map, c, b).rows; r++) {
                double value = yk_map_row(a->map, c, b, r)[coordinate] * a->factor[axis];
                *low = fmin(*low, value);
                *high = fmax(*high, value);
            }
    double more = 0.05 * (*high - *low) + 1e-3 * a->map->mech->size * a->factor[axis];
    if (!(*low <= *high)) *low = *high = 0;
    *low -= more;
    *high += more;
}

static void add_map(Axes *a, const YkMapPicture *options)
{
    bool is_degrees[2] = {a->turn[0] > 300, a->turn[1] > 300};
    YkText x = {0}, y = {0};
    const YkTreeCoordinate *c = a->map->mech->coordinates;
    yk_text_format(&x, "%s [%s]", c[a->x].name, c[a->x].is_distance ? options->length_unit : options->angle_unit);
    yk_text_format(&y, "%s [%s]", c[a->y].name, c[a->y].is_distance ? options->length_unit : options->angle_unit);
    yk_panel_frame(&a->panel, is_degrees, yk_text_get(&x), yk_text_get(&y));
    for (size_t k = yk_map_circuit_count(a->map); k-- > 0;)
        for (size_t b = 0; b < yk_map_circuit(a->map, k).branches; b++)
            add_branch(a, k, b, yk_map_circuit(a->map, k).contains_start);
    for (size_t k = 0; k < yk_map_circuit_count(a->map); k++)
        for (size_t e = 0; e < yk_map_circuit(a->map, k).events; e++) add_event(a, k, e);
    if (x.failed || y.failed) yk_text_fail(a->panel.svg);
    yk_text_free(&x);
    yk_text_free(&y);
}

// --- curves of points

static YkVec point_at(const Axes *a, const YkMapPicture *o, size_t circuit, size_t branch, size_t row, size_t k)
{
    const double *points = yk_map_points(a->map, circuit, branch, row);
    return yk_vec(points[2 * o->points[k]] * o->length, points[2 * o->points[k] + 1] * o->length);
}

static void add_curves(Axes *a, const YkMapPicture *o)
{
    YkVec low = yk_vec(INFINITY, INFINITY), high = yk_vec(-INFINITY, -INFINITY);
    bool is_degrees[2] = {false, false};
    for (int pass = 0; pass < 2; pass++) {
        for (size_t c = yk_map_circuit_count(a->map); c-- > 0;)
            for (size_t b = 0; b < yk_map_circuit(a->map, c).branches; b++)
                for (size_t k = 0; k < o->point_count; k++) {
                    size_t rows = yk_map_branch(a->map, c, b).rows;
                    for (size_t r = 0; r < rows; r++) {
                        YkVec at = point_at(a, o, c, b, r, k);
                        low = pass == 0 ? yk_vec(fmin(low.x, at.x), fmin(low.y, at.y)) : low;
                        high = pass == 0 ? yk_vec(fmax(high.x, at.x), fmax(high.y, at.y)) : high;
                        if (pass == 1) a->points[r] = yk_panel_pixel(&a->panel, at);
                    }
                    if (pass == 1) add_line(&a->panel, a->points, rows, c, yk_map_circuit(a->map, c).contains_start);
                }
        if (pass == 1 || !(low.x <= high.x)) break;
        double half = 0.55 * fmax(fmax(high.x - low.x, high.y - low.y), 1e-9);
        YkVec middle = yk_scale(0.5, yk_add(low, high));
        a->panel.low = yk_sub(middle, yk_vec(half, half));
        a->panel.high = yk_add(middle, yk_vec(half, half));
        YkText x = {0}, y = {0};
        yk_text_format(&x, "x [%s]", o->length_unit);
        yk_text_format(&y, "y [%s]", o->length_unit);
        yk_panel_frame(&a->panel, is_degrees, yk_text_get(&x), yk_text_get(&y));
        if (x.failed || y.failed) yk_text_fail(a->panel.svg);
        yk_text_free(&x);
        yk_text_free(&y);
    }
}

static size_t most_rows(const YkMap *map)
{
    size_t most = 1;
    for (size_t c = 0; c < yk_map_circuit_count(map); c++)
        for (size_t b = 0; b < yk_map_circuit(map, c).branches; b++) {
            size_t rows = yk_map_branch(map, c, b).rows;
            most = rows > most ? rows : most;
        }
    return most;
}

const char *yk_map_picture(YkMap *map, const YkMapPicture *o)
{
    if (!map || !o || o->coordinate >= map->mech->coordinate_count) return NULL;
    for (size_t k = 0; k < o->point_count; k++)
        if (o->points[k] >= map->points) return NULL;
    YkVec *points = malloc(most_rows(map) * sizeof *points);
    if (!points) return NULL;
    Axes a = {.map = map, .x = map->coordinate, .y = o->coordinate, .points = points};
    a.panel = (YkPanel){.svg = &map->picture, .left = YK_PANEL_LEFT};
    a.factor[0] = map->mech->coordinates[a.x].is_distance ? o->length : o->angle;
    a.factor[1] = map->mech->coordinates[a.y].is_distance ? o->length : o->angle;
    set_axis(&a, 0, a.x, &a.panel.low.x, &a.panel.high.x);
    set_axis(&a, 1, a.y, &a.panel.low.y, &a.panel.high.y);
    int width = YK_PANEL_LEFT + YK_PANEL_SIZE + GAP + (o->point_count > 0 ? YK_PANEL_LEFT + YK_PANEL_SIZE : 0);
    yk_text_clear(&map->picture);
    yk_panel_begin(&a.panel, width);
    add_map(&a, o);
    a.panel.left = 2 * YK_PANEL_LEFT + YK_PANEL_SIZE + GAP - 20;
    if (o->point_count > 0) add_curves(&a, o);
    yk_text_puts(&map->picture, "</svg>\n");
    free(points);
    return map->picture.failed ? NULL : yk_text_get(&map->picture);
}
