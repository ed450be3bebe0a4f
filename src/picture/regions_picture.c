// Draws a map over two freedoms: regions in colours, and the curves between them.
#include "map/workspace/regions.h"
#include "picture/axes.h"
#include "picture/svg.h"

enum { TONES = 8 };

static const char *const tones[TONES] = {"#dbe9f6", "#bad6eb", "#89bedc", "#539ecd",
                                         "#2b7bba", "#0b559f", "#08306b", "#041a3d"};

// Adds an outline to a path, in pixels.
static void add_outline(YkText *svg, const YkPanel *p, const YkBorder *o, const double *scale)
{
    for (size_t k = 0; k < o->count; k++) {
        YkVec at = yk_panel_pixel(p, yk_vec(o->points[2 * k] * scale[0], o->points[2 * k + 1] * scale[1]));
        yk_text_puts(svg, k == 0 ? "M" : "L");
        yk_svg_number(svg, at.x);
        yk_text_puts(svg, " ");
        yk_svg_number(svg, at.y);
    }
    yk_text_puts(svg, "Z");
}

static int most_of(const YkRegions *r)
{
    int most = 1;
    for (size_t k = 0; k < r->count; k++)
        if (r->parts[k].region.configurations > most) most = r->parts[k].region.configurations;
    return most;
}

static const char *tone_of(int count, int most)
{
    int tone = most <= TONES ? count - 1 : (count - 1) * (TONES - 1) / (most - 1);
    return tones[tone < 0 ? 0 : tone];
}

static void add_regions(const YkRegions *r, const YkPanel *p, const double *scale)
{
    YkText *svg = p->svg;
    for (size_t k = 0; k < r->count; k++) {
        const YkTract *part = &r->parts[k];
        yk_text_format(svg, "<path fill=\"%s\" fill-rule=\"evenodd\" stroke=\"#c0392b\" stroke-width=\"%s\" d=\"",
                       tone_of(part->region.configurations, most_of(r)), part->region.contains_start ? "2" : "1");
        for (size_t o = 0; o < part->outline_count; o++) add_outline(svg, p, &part->outlines[o], scale);
        yk_text_format(svg, "\"><title>%d configurations</title></path>\n", part->region.configurations);
    }
}

// Writes what the colours stand for, beside the panel.
static void add_legend(const YkRegions *r, const YkPanel *p)
{
    YkText word = {0};
    int most = most_of(r), row = 0;
    for (int count = 1; count <= most; count++) {
        bool occurs = false;
        for (size_t k = 0; k < r->count; k++) occurs |= r->parts[k].region.configurations == count;
        if (!occurs) continue;
        double x = p->left + YK_PANEL_SIZE + 16, y = YK_PANEL_TOP + 18.0 * row++;
        YkVec corners[4] = {yk_vec(x, y), yk_vec(x + 14, y), yk_vec(x + 14, y + 14), yk_vec(x, y + 14)};
        yk_text_clear(&word);
        yk_text_format(&word, "fill=\"%s\" stroke=\"#888\"", tone_of(count, most));
        yk_svg_polygon(p->svg, corners, 4, yk_text_get(&word));
        yk_text_clear(&word);
        yk_text_format(&word, "%d", count);
        yk_svg_word(p->svg, yk_vec(x + 20, y + 12), yk_text_get(&word), "fill=\"#333\"");
    }
    if (word.failed) yk_text_fail(p->svg);
    yk_text_free(&word);
}

const char *yk_regions_picture(YkRegions *r, const YkRegionsPicture *o)
{
    if (!r || !o) return NULL;
    YkPanel p = {.svg = &r->picture, .left = YK_PANEL_LEFT};
    bool is_degrees[2];
    YkText name[2] = {{0}, {0}};
    for (int k = 0; k < 2; k++) {
        const YkTreeCoordinate *c = &r->mech->coordinates[r->coordinate[k]];
        yk_text_format(&name[k], "%s [%s]", o->names[k] ? o->names[k] : c->name, o->units[k] ? o->units[k] : "");
        is_degrees[k] = r->field.is_angle[k] && (r->field.high[k] - r->field.low[k]) * o->scale[k] > 300;
    }
    p.low = yk_vec(r->field.low[0] * o->scale[0], r->field.low[1] * o->scale[1]);
    p.high = yk_vec(r->field.high[0] * o->scale[0], r->field.high[1] * o->scale[1]);
    if (!r->field.is_angle[0] && !r->field.is_angle[1]) yk_panel_square(&p); // to scale
    yk_text_clear(&r->picture);
    yk_panel_begin(&p, YK_PANEL_LEFT + YK_PANEL_SIZE + 70);
    yk_panel_frame(&p, is_degrees, yk_text_get(&name[0]), yk_text_get(&name[1]));
    add_regions(r, &p, o->scale);
    add_legend(r, &p);
    yk_svg_circle(p.svg, yk_panel_pixel(&p, yk_vec(r->start[0] * o->scale[0], r->start[1] * o->scale[1])), 4,
                  "fill=\"#fff\" stroke=\"#333\" stroke-width=\"2\"");
    yk_text_puts(p.svg, "</svg>\n");
    if (name[0].failed || name[1].failed) yk_text_fail(p.svg);
    yk_text_free(&name[0]);
    yk_text_free(&name[1]);
    return r->picture.failed ? NULL : yk_text_get(&r->picture);
}
