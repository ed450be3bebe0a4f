// Draws the profiles of a cam to scale, as SVG and DXF.
#include "picture/cam_picture.h"
#include <stdlib.h>
#include "base/escape.h"
#include "base/number.h"
#include "picture/dxf.h"
#include "picture/svg.h"

static const double mm = 1000; // per metre
enum { MARGIN = 6, DECIMALS = 5 };

static bool add_curve(YkCamPicture *picture, YkCamCurve curve, const char *layer, double tolerance)
{
    YkCamVertex *vertices;
    size_t count;
    YkStatus status = yk_cam_profile(picture->design, curve, tolerance, picture->cutter, &vertices, &count);
    if (status == YK_NO_MEMORY) picture->ran_out = true;
    if (status != YK_OK) return false;
    YkVec *points = malloc((count + 1) * sizeof *points);
    for (size_t i = 0; points && i < count; i++) points[i] = yk_vec(vertices[i].x, vertices[i].y);
    yk_cam_vertices_free(vertices);
    picture->ran_out |= !points;
    if (points) picture->outlines[picture->count++] = (YkCamOutline){layer, points, count};
    return points != NULL;
}

bool yk_cam_picture_take(YkCamPicture *picture, const YkCamDesign *design, double tolerance, double cutter)
{
    YkCamSize size = yk_cam_size(design);
    *picture = (YkCamPicture){.design = design, .cutter = cutter};
    bool good = add_curve(picture, YK_CAM_CURVE_SURFACE, "surface", tolerance);
    if (size.face == YK_CAM_FACE_ROLLER) good = good && add_curve(picture, YK_CAM_CURVE_PITCH, "pitch", tolerance);
    if (size.is_groove) good = good && add_curve(picture, YK_CAM_CURVE_OUTER, "groove", tolerance);
    if (cutter > 0) good = good && add_curve(picture, YK_CAM_CURVE_CUTTER, "cutter", tolerance);
    if (size.is_conjugate) {
        good = good && add_curve(picture, YK_CAM_CURVE_SECOND_SURFACE, "surface-2", tolerance) &&
               add_curve(picture, YK_CAM_CURVE_SECOND_PITCH, "pitch-2", tolerance);
    }
    if (!good) yk_cam_picture_free(picture);
    return good;
}

void yk_cam_picture_free(YkCamPicture *picture)
{
    for (size_t i = 0; i < picture->count; i++) free(picture->outlines[i].points);
    picture->count = 0;
}

// The box around everything drawn.
typedef struct Box {
    YkVec low, high;
} Box;

static void widen(Box *box, YkVec at, double radius)
{
    box->low = yk_vec(fmin(box->low.x, at.x - radius), fmin(box->low.y, at.y - radius));
    box->high = yk_vec(fmax(box->high.x, at.x + radius), fmax(box->high.y, at.y + radius));
}

static Box extent(const YkCamPicture *picture)
{
    YkCamSize size = yk_cam_size(picture->design);
    YkCamPoint p = yk_cam_at(picture->design, 0);
    Box box = {yk_vec(-size.base, -size.base), yk_vec(size.base, size.base)};
    for (size_t i = 0; i < picture->count; i++)
        for (size_t k = 0; k < picture->outlines[i].count; k++) widen(&box, picture->outlines[i].points[k], 0);
    widen(&box, yk_vec(p.pitch[0], p.pitch[1]), size.roller);
    return box;
}

static void add_number(YkText *svg, double value)
{
    char digits[YK_NUMBER_SIZE];
    yk_text_add(svg, digits, yk_number_write_fixed(fabs(value) < 5e-6 ? 0 : value, DECIMALS, digits));
}

static void add_outline(YkText *svg, const YkCamOutline *outline, const char *style)
{
    yk_text_format(svg, "<path id=\"%s\" d=\"", outline->layer);
    for (size_t i = 0; i < outline->count; i++) {
        yk_text_puts(svg, i == 0 ? "M" : "L");
        add_number(svg, mm * outline->points[i].x);
        yk_text_puts(svg, " ");
        add_number(svg, -mm * outline->points[i].y);
    }
    yk_text_format(svg, "Z\" %s/>\n", style);
}

static void add_circle(YkText *svg, YkVec center, double radius, const char *style)
{
    yk_text_puts(svg, "<circle cx=\"");
    add_number(svg, mm * center.x);
    yk_text_puts(svg, "\" cy=\"");
    add_number(svg, -mm * center.y);
    yk_text_puts(svg, "\" r=\"");
    add_number(svg, mm * radius);
    yk_text_format(svg, "\" %s/>\n", style);
}

static void add_line(YkText *svg, YkVec a, YkVec b, const char *style)
{
    const double values[] = {a.x, -a.y, b.x, -b.y};
    static const char *const names[] = {"x1", "y1", "x2", "y2"};
    yk_text_puts(svg, "<line");
    for (int i = 0; i < 4; i++) {
        yk_text_format(svg, " %s=\"", names[i]);
        add_number(svg, mm * values[i]);
        yk_text_puts(svg, "\"");
    }
    yk_text_format(svg, " %s/>\n", style);
}

static void add_cross(YkText *svg, YkVec at, double arm)
{
    static const char style[] = "stroke=\"#333\" stroke-width=\"0.18\"";
    add_line(svg, yk_vec(at.x - arm, at.y), yk_vec(at.x + arm, at.y), style);
    add_line(svg, yk_vec(at.x, at.y - arm), yk_vec(at.x, at.y + arm), style);
}

static const char *style_of(const char *layer)
{
    switch (layer[0]) {
    case 'p': // pitch
        return "fill=\"none\" stroke=\"#1f6fb2\" stroke-width=\"0.25\" stroke-dasharray=\"4 1 0.6 1\"";
    case 'g': // groove
        return "fill=\"none\" stroke=\"#222\" stroke-width=\"0.4\"";
    case 'c': // cutter
        return "fill=\"none\" stroke=\"#d1622b\" stroke-width=\"0.25\" stroke-dasharray=\"1.5 1\"";
    default:
        return "fill=\"#dfe7ee\" fill-opacity=\"0.6\" stroke=\"#222\" stroke-width=\"0.5\"";
    }
}

// Adds the roller, or the face as a line along itself, at cam angle 0.
static void add_follower(const YkCamPicture *picture, YkText *svg)
{
    static const char style[] = "fill=\"none\" stroke=\"#8b4a9c\" stroke-width=\"0.35\"";
    YkCamSize size = yk_cam_size(picture->design);
    YkCamPoint p = yk_cam_at(picture->design, 0);
    YkVec at = yk_vec(p.surface[0], p.surface[1]), along = yk_quarter(yk_vec(p.normal[0], p.normal[1]));
    if (size.face == YK_CAM_FACE_FLAT) {
        YkCamSummary summary = yk_cam_summary(picture->design);
        double half = fmax(summary.reach_high.value - summary.reach_low.value, size.base / 4);
        add_line(svg, yk_sub(at, yk_scale(half, along)), yk_add(at, yk_scale(half, along)), style);
        return;
    }
    YkVec center = yk_vec(p.pitch[0], p.pitch[1]);
    if (size.roller > 0) add_circle(svg, center, size.roller, style);
    add_cross(svg, center, fmax(size.roller / 3, size.base / 40));
}

static void add_words(const YkCamPicture *picture, YkText *svg, YkVec at, double height)
{
    YkCamSize size = yk_cam_size(picture->design);
    YkText words = {0}, style = {0};
    char digits[YK_NUMBER_SIZE];
    yk_number_write_digits(mm * size.base, 6, digits);
    yk_text_format(&words, "%s: base circle R%s mm", size.name, digits);
    if (size.roller > 0) {
        yk_number_write_digits(mm * size.roller, 6, digits);
        yk_text_format(&words, ", roller R%s mm", digits);
    }
    yk_text_puts(&words, size.turn > 0 ? ", turns counterclockwise" : ", turns clockwise");
    yk_number_write_fixed(height, 2, digits);
    yk_text_format(&style, "font-family=\"sans-serif\" font-size=\"%s\" fill=\"#333\"", digits);
    yk_svg_word(svg, at, yk_text_get(&words), yk_text_get(&style));
    yk_text_free(&words);
    yk_text_free(&style);
}

// Adds the page: margins on all sides, words at the foot, a white background.
static void add_page(const YkCamPicture *picture, YkText *svg)
{
    Box box = extent(picture);
    double width = mm * (box.high.x - box.low.x) + 2 * MARGIN, words = fmax(width / 40, 2);
    double height = mm * (box.high.y - box.low.y) + 2 * MARGIN + 1.5 * words;
    const double corner[] = {mm * box.low.x - MARGIN, -mm * box.high.y - MARGIN, width, height};
    yk_text_puts(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"");
    add_number(svg, width);
    yk_text_puts(svg, "mm\" height=\"");
    add_number(svg, height);
    yk_text_puts(svg, "mm\" viewBox=\"");
    for (int i = 0; i < 4; i++) {
        if (i > 0) yk_text_puts(svg, " ");
        add_number(svg, corner[i]);
    }
    yk_text_puts(svg, "\">\n<title>");
    yk_escape_xml(svg, yk_cam_size(picture->design).name);
    yk_text_puts(svg, "</title>\n<rect");
    static const char *const names[] = {"x", "y", "width", "height"};
    for (int i = 0; i < 4; i++) {
        yk_text_format(svg, " %s=\"", names[i]);
        add_number(svg, corner[i]);
        yk_text_puts(svg, "\"");
    }
    yk_text_puts(svg, " fill=\"#fff\"/>\n");
    add_words(picture, svg, yk_vec(corner[0] + MARGIN, corner[1] + height - MARGIN / 2), words);
}

void yk_cam_picture_svg(const YkCamPicture *picture, YkText *svg)
{
    YkCamSize size = yk_cam_size(picture->design);
    add_page(picture, svg);
    for (size_t i = 0; i < picture->count; i++)
        add_outline(svg, &picture->outlines[i], style_of(picture->outlines[i].layer));
    add_circle(svg, yk_vec(0, 0), size.base,
               "fill=\"none\" stroke=\"#777\" stroke-width=\"0.25\" stroke-dasharray=\"2 1.2\"");
    add_cross(svg, yk_vec(0, 0), size.base / 12);
    add_follower(picture, svg);
    yk_text_puts(svg, "</svg>\n");
}

static void add_scaled(YkText *dxf, const YkCamOutline *outline)
{
    YkVec *points = malloc((outline->count + 1) * sizeof *points);
    if (!points) {
        dxf->failed = true;
        return;
    }
    for (size_t i = 0; i < outline->count; i++) points[i] = yk_scale(mm, outline->points[i]);
    yk_dxf_outline(dxf, outline->layer, points, outline->count);
    free(points);
}

void yk_cam_picture_dxf(const YkCamPicture *picture, YkText *dxf)
{
    YkCamSize size = yk_cam_size(picture->design);
    const char *layers[YK_CAM_OUTLINES_MAX + 2];
    size_t count = 0;
    for (size_t i = 0; i < picture->count; i++) layers[count++] = picture->outlines[i].layer;
    layers[count++] = "base";
    layers[count++] = "marks";
    yk_dxf_begin(dxf, layers, count);
    for (size_t i = 0; i < picture->count; i++) add_scaled(dxf, &picture->outlines[i]);
    double arm = mm * size.base / 12;
    yk_dxf_circle(dxf, "base", yk_vec(0, 0), mm * size.base);
    yk_dxf_line(dxf, "marks", yk_vec(-arm, 0), yk_vec(arm, 0));
    yk_dxf_line(dxf, "marks", yk_vec(0, -arm), yk_vec(0, arm));
    yk_dxf_end(dxf);
}
