// Draws the axes of a map and places what is drawn on them.
#include "picture/axes.h"
#include <math.h>
#include "picture/svg.h"

YkVec yk_panel_pixel(const YkPanel *p, YkVec at)
{
    double x = (at.x - p->low.x) / (p->high.x - p->low.x), y = (at.y - p->low.y) / (p->high.y - p->low.y);
    return yk_vec(p->left + YK_PANEL_SIZE * x, YK_PANEL_TOP + YK_PANEL_SIZE * (1 - y));
}

// Returns a step of 1, 2 or 5 times a power of ten, or of parts of a turn, so that some six fit.
static double step_of(double length, bool is_degrees)
{
    static const double degrees[] = {1, 2, 5, 10, 15, 30, 45, 60, 90, 180, 360, 720, 1440, 3600, 7200};
    double step = 1e-12;
    for (size_t k = 0; is_degrees && k < sizeof degrees / sizeof *degrees; k++)
        if (length / degrees[k] <= 8) return degrees[k];
    while (length / (10 * step) > 1) step *= 10;
    return length / step <= 2 ? step / 5 : length / step <= 5 ? step / 2 : step;
}

void yk_panel_frame(const YkPanel *p, bool is_degrees[2], const char *x_name, const char *y_name)
{
    YkVec corners[4] = {yk_panel_pixel(p, p->low), yk_panel_pixel(p, yk_vec(p->high.x, p->low.y)),
                        yk_panel_pixel(p, p->high), yk_panel_pixel(p, yk_vec(p->low.x, p->high.y))};
    YkText word = {0};
    double dx = step_of(p->high.x - p->low.x, is_degrees[0]), dy = step_of(p->high.y - p->low.y, is_degrees[1]);
    yk_svg_polygon(p->svg, corners, 4, "fill=\"none\" stroke=\"#888\"");
    for (double k = ceil(p->low.x / dx); k * dx <= p->high.x; k++) {
        YkVec at = yk_panel_pixel(p, yk_vec(k * dx, p->low.y));
        yk_svg_line(p->svg, at, yk_vec(at.x, YK_PANEL_TOP), "stroke=\"#ddd\"");
        yk_text_clear(&word);
        yk_text_format(&word, "%e", k == 0 ? 0 : k * dx);
        yk_svg_word(p->svg, yk_vec(at.x, at.y + 16), yk_text_get(&word), "text-anchor=\"middle\" fill=\"#333\"");
    }
    for (double k = ceil(p->low.y / dy); k * dy <= p->high.y; k++) {
        YkVec at = yk_panel_pixel(p, yk_vec(p->low.x, k * dy));
        yk_svg_line(p->svg, at, yk_vec(p->left + YK_PANEL_SIZE, at.y), "stroke=\"#ddd\"");
        yk_text_clear(&word);
        yk_text_format(&word, "%e", k == 0 ? 0 : k * dy);
        yk_svg_word(p->svg, yk_vec(at.x - 6, at.y + 4), yk_text_get(&word), "text-anchor=\"end\" fill=\"#333\"");
    }
    yk_svg_word(p->svg, yk_vec(p->left + YK_PANEL_SIZE / 2.0, YK_PANEL_TOP + YK_PANEL_SIZE + 36), x_name,
                "text-anchor=\"middle\"");
    yk_svg_word(p->svg, yk_vec(p->left, YK_PANEL_TOP - 10), y_name, "text-anchor=\"start\"");
    if (word.failed) yk_text_fail(p->svg);
    yk_text_free(&word);
}

void yk_panel_begin(const YkPanel *p, int width)
{
    int height = YK_PANEL_TOP + YK_PANEL_SIZE + YK_PANEL_BOTTOM;
    yk_text_format(p->svg,
                   "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" "
                   "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%%\" height=\"100%%\" "
                   "fill=\"#fff\"/>\n",
                   width, height, width, height);
}

void yk_panel_square(YkPanel *p)
{
    YkVec size = yk_sub(p->high, p->low), middle = yk_scale(0.5, yk_add(p->low, p->high));
    double half = 0.5 * fmax(size.x, size.y);
    p->low = yk_sub(middle, yk_vec(half, half));
    p->high = yk_add(middle, yk_vec(half, half));
}
