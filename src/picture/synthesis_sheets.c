// Pictures that a designer picks from: Burmester's curves with their pivots, and the errors of function generators.
#include <math.h>
#include "base/number.h"
#include "picture/axes.h"
#include "picture/svg.h"
#include "synthesis/synthesis.h"

enum { RAYS = 2880, ERRORS_MAX = 6, GAP = 40, CENTRE = 0, CIRCLE = 1 };

static void add_two(YkText *svg, const char *name, double a, double b)
{
    yk_text_format(svg, " data-%s=\"%g %g\"", name, a, b);
}

// Opens a group that states the panel's ranges, in the units of its axes.
static void open_group(const YkPanel *p, const char *name)
{
    yk_text_format(p->svg, "<g class=\"%s\"", name);
    add_two(p->svg, "x", p->low.x, p->high.x);
    add_two(p->svg, "y", p->low.y, p->high.y);
    yk_text_puts(p->svg, ">\n");
}

// --- Burmester's curves

typedef struct Curves {
    const YkSynthesis *s;
    YkPanel panel;
    double unit; // m
} Curves;

static YkVec place(const Curves *c, const YkDyad *dyad, int which)
{
    YkVec at = yk_vec(dyad->fixed[0], dyad->fixed[1]);
    if (which == CIRCLE) at = yk_pose_apply(c->s->task->motion.pose[0], yk_vec(dyad->moving[0], dyad->moving[1]));
    return yk_scale(1 / c->unit, at);
}

static bool is_inside(const Curves *c, YkVec at)
{
    const YkPanel *p = &c->panel;
    return at.x >= p->low.x && at.x <= p->high.x && at.y >= p->low.y && at.y <= p->high.y;
}

// The positions with their extent around them.
static void find_panel(Curves *c)
{
    const YkMotionTask *motion = &c->s->task->motion;
    YkPanel *p = &c->panel;
    p->low = p->high = yk_scale(1 / c->unit, motion->pose[0].at);
    for (size_t k = 1; k < motion->count; k++) {
        YkVec at = yk_scale(1 / c->unit, motion->pose[k].at);
        p->low = yk_vec(fmin(p->low.x, at.x), fmin(p->low.y, at.y));
        p->high = yk_vec(fmax(p->high.x, at.x), fmax(p->high.y, at.y));
    }
    double reach = 1.5 * yk_norm(yk_sub(p->high, p->low));
    if (!(reach > 0)) reach = 1;
    p->low = yk_sub(p->low, yk_vec(reach, reach));
    p->high = yk_add(p->high, yk_vec(reach, reach));
    yk_panel_square(p);
}

static void draw_step(const Curves *c, YkVec from, YkVec to)
{
    const YkVec ends[2] = {from, to};
    for (int e = 0; e < 2; e++) {
        yk_text_puts(c->panel.svg, e == 0 ? "M" : "L");
        yk_svg_number(c->panel.svg, ends[e].x);
        yk_text_puts(c->panel.svg, " ");
        yk_svg_number(c->panel.svg, ends[e].y);
    }
}

static const double far_away = 40, unseen = 2; // px

// Joins the two points of a ray beside which the next one misses the curve: there the curve turns back.
static void draw_turn(const Curves *c, const YkVec *pixel, const bool *is_drawn, size_t count)
{
    if (count == 2 && is_drawn[0] && is_drawn[1] && yk_norm(yk_sub(pixel[1], pixel[0])) < far_away)
        draw_step(c, pixel[0], pixel[1]);
}

// Draws one of the curves: each point of a ray is joined to the nearest one of the ray before, unless that is far away;
// steps too short to be seen are left out.
static void draw_curve(const Curves *c, const YkFourPoses *four, int which, const char *style)
{
    YkVec before[2] = {{0, 0}, {0, 0}};
    bool was_inside[2] = {false, false};
    size_t count_before = 0;
    yk_text_format(c->panel.svg, "<path class=\"%s\" fill=\"none\" %s d=\"", which == CENTRE ? "centres" : "circles",
                   style);
    for (size_t k = 0; k <= RAYS; k++) {
        YkDyad dyad[2];
        YkVec now[2];
        bool inside[2] = {false, false};
        size_t count = yk_four_poses_ray(four, YK_PI * (double)k / RAYS, dyad);
        if (count == 0) draw_turn(c, before, was_inside, count_before);
        for (size_t i = 0; i < count; i++) {
            YkVec at = place(c, &dyad[i], which), from = yk_vec(0, 0);
            double nearest = far_away;
            now[i] = yk_panel_pixel(&c->panel, at);
            inside[i] = is_inside(c, at);
            for (size_t j = 0; j < count_before; j++) {
                double away = yk_norm(yk_sub(now[i], before[j]));
                if (away >= nearest) continue;
                nearest = away;
                from = before[j];
            }
            if (nearest < unseen) now[i] = from;
            if (nearest < unseen || nearest >= far_away || !inside[i]) continue;
            draw_step(c, from, now[i]);
        }
        if (count_before == 0 && k > 0) draw_turn(c, now, inside, count);
        count_before = count;
        for (size_t i = 0; i < count; i++) before[i] = now[i], was_inside[i] = inside[i];
    }
    yk_text_puts(c->panel.svg, "\"/>\n");
}

static void draw_positions(const Curves *c)
{
    const YkMotionTask *motion = &c->s->task->motion;
    for (size_t k = 0; k < motion->count; k++) {
        YkVec at = yk_panel_pixel(&c->panel, yk_scale(1 / c->unit, motion->pose[k].at));
        YkVec along = yk_scale(22, yk_conj(yk_unit(motion->pose[k].angle))), across = yk_scale(-0.5, yk_quarter(along));
        char digit[2] = {(char)('1' + k), '\0'};
        yk_svg_line(c->panel.svg, at, yk_add(at, along), "stroke=\"#c0392b\" stroke-width=\"2\"");
        yk_svg_line(c->panel.svg, at, yk_add(at, across), "stroke=\"#c0392b\"");
        yk_svg_word(c->panel.svg, yk_add(at, yk_vec(-4, 14)), digit, "fill=\"#c0392b\" font-size=\"10\"");
    }
}

// The two pivots of a dyad, with its number, that of the answer's list.
static void draw_dyad(const Curves *c, size_t index)
{
    static const char *const name[2] = {"centre", "circle"}, *const fill[2] = {"#1a5276", "#b9770e"};
    const YkDyad *dyad = &c->s->dyads[index];
    YkText style = {0}, number = {0};
    YkVec at[2] = {place(c, dyad, CENTRE), place(c, dyad, CIRCLE)}, pixel[2];
    if (dyad->kind != YK_DYAD_RR || !is_inside(c, at[CENTRE]) || !is_inside(c, at[CIRCLE])) return;
    for (int i = 0; i < 2; i++) pixel[i] = yk_panel_pixel(&c->panel, at[i]);
    yk_text_format(&number, "%z", index + 1);
    yk_svg_line(c->panel.svg, pixel[0], pixel[1], "stroke=\"#bbb\" stroke-width=\"0.7\"");
    for (int i = 0; i < 2; i++) {
        yk_text_clear(&style);
        yk_text_format(&style, "class=\"%s\" fill=\"%s\" data-dyad=\"%z\" data-at=\"%g %g\"", name[i], fill[i],
                       index + 1, at[i].x, at[i].y);
        yk_svg_circle(c->panel.svg, pixel[i], 3, yk_text_get(&style));
    }
    yk_svg_word(c->panel.svg, yk_add(pixel[CENTRE], yk_vec(4, -4)), yk_text_get(&number),
                "font-size=\"9\" fill=\"#1a5276\"");
    if (style.failed || number.failed) yk_text_fail(c->panel.svg);
    yk_text_free(&style);
    yk_text_free(&number);
}

// Four positions have one pair of curves. Five have a pair of the first four and one in which the fifth takes the place
// of the fourth: where both pairs meet are the dyads.
static void draw_burmester(YkSynthesis *s, YkText *svg)
{
    const YkMotionTask *motion = &s->task->motion;
    Curves c = {.s = s, .panel = {.svg = svg, .left = YK_PANEL_LEFT}};
    const char *unit = yk_task_unit(s->task, YK_QUANTITY_LENGTH, &c.unit);
    YkText name[2] = {{0}, {0}};
    bool is_degrees[2] = {false, false};
    find_panel(&c);
    yk_panel_begin(&c.panel, YK_PANEL_LEFT + YK_PANEL_SIZE + GAP);
    yk_text_format(&name[0], "x [%s]: fixed pivots blue, moving pivots at position 1 orange, dyads by number", unit);
    yk_text_format(&name[1], "y [%s]", unit);
    yk_panel_frame(&c.panel, is_degrees, yk_text_get(&name[0]), yk_text_get(&name[1]));
    open_group(&c.panel, "burmester");
    for (size_t last = 3; last < motion->conditions; last++) {
        YkPose pose[4] = {motion->pose[0], motion->pose[1], motion->pose[2], motion->pose[last]};
        bool is_other = last > 3;
        YkFourPoses four;
        yk_four_poses(pose, &four);
        draw_curve(&c, &four, CENTRE, is_other ? "stroke=\"#85c1e9\" stroke-dasharray=\"4 3\"" : "stroke=\"#2471a3\"");
        draw_curve(&c, &four, CIRCLE, is_other ? "stroke=\"#f5cba7\" stroke-dasharray=\"4 3\"" : "stroke=\"#e67e22\"");
    }
    draw_positions(&c);
    for (size_t k = 0; k < s->dyad_count; k++) draw_dyad(&c, k);
    yk_text_puts(svg, "</g>\n</svg>\n");
    for (int i = 0; i < 2; i++) {
        if (name[i].failed) yk_text_fail(svg);
        yk_text_free(&name[i]);
    }
}

// --- errors of function generators

typedef struct Scale {
    double input, error; // units
    const char *input_name, *error_name;
} Scale;

static void draw_rows(const YkPanel *p, const Scale *u, const double *rows, size_t count, const char *style)
{
    YkVec points[YK_CURVE_ROWS];
    for (size_t r = 0; r < count; r++)
        points[r] = yk_panel_pixel(p, yk_vec(rows[2 * r] / u->input, rows[2 * r + 1] / u->error));
    yk_svg_polyline(p->svg, points, count, style);
}

static void draw_errors_of(const YkFound *found, size_t rank, const Scale *u, YkPanel *p)
{
    bool is_degrees[2] = {false, false};
    double most = found->worst / u->error, last = found->curve[2 * (found->rows - 1)] / u->input;
    YkText name[2] = {{0}, {0}};
    char digits[YK_NUMBER_SIZE];
    if (found->before) most = fmax(most, found->interpolating / u->error);
    p->low = yk_vec(fmin(0, last), -1.1 * most);
    p->high = yk_vec(fmax(0, last), 1.1 * most);
    digits[yk_number_write_digits(found->worst / u->error, 4, digits)] = '\0';
    yk_text_format(&name[0], "input from the start of its range [%s]", u->input_name);
    yk_text_format(&name[1], "%z %s: error of the output [%s], at most %s", rank, yk_design_type(&found->design),
                   u->error_name, digits);
    yk_panel_frame(p, is_degrees, yk_text_get(&name[0]), yk_text_get(&name[1]));
    open_group(p, "errors");
    yk_svg_line(p->svg, yk_panel_pixel(p, yk_vec(p->low.x, 0)), yk_panel_pixel(p, yk_vec(p->high.x, 0)),
                "stroke=\"#555\"");
    if (found->before)
        draw_rows(p, u, found->before, YK_CURVE_ROWS,
                  "class=\"before\" fill=\"none\" stroke=\"#999\" stroke-dasharray=\"5 3\"");
    draw_rows(p, u, found->curve, found->rows, "class=\"error\" fill=\"none\" stroke=\"#c0392b\" stroke-width=\"1.5\"");
    yk_text_puts(p->svg, "</g>\n");
    for (int i = 0; i < 2; i++) {
        if (name[i].failed) yk_text_fail(p->svg);
        yk_text_free(&name[i]);
    }
}

static void draw_errors(YkSynthesis *s, YkText *svg)
{
    size_t count = s->candidates.count < ERRORS_MAX ? s->candidates.count : ERRORS_MAX;
    int step = YK_PANEL_LEFT + YK_PANEL_SIZE + GAP;
    YkPanel panel = {.svg = svg, .left = YK_PANEL_LEFT};
    yk_panel_begin(&panel, (int)count * step);
    for (size_t k = 0; k < count; k++, panel.left += step) {
        const YkFound *found = &s->candidates.items[k];
        Scale u;
        u.input_name = yk_task_unit(s->task, YK_QUANTITY_ANGLE, &u.input);
        u.error_name = yk_task_unit(
            s->task, found->design.kind == YK_DESIGN_SLIDER_CRANK ? YK_QUANTITY_LENGTH : YK_QUANTITY_ANGLE, &u.error);
        if (found->rows > 1) draw_errors_of(found, k + 1, &u, &panel);
    }
    yk_text_puts(svg, "</svg>\n");
}

const char *yk_synthesis_sheet(YkSynthesis *s, YkSynthesisSheet sheet, bool *ran_out)
{
    if (ran_out) *ran_out = false;
    if (!s || (unsigned)sheet > YK_SHEET_ERRORS) return NULL;
    YkText *svg = &s->sheet[sheet];
    bool is_errors = sheet == YK_SHEET_ERRORS;
    bool has_errors = s->task->kind == YK_TASK_FUNCTION && s->task->function.of && s->candidates.count > 0;
    bool has_curves = s->task->kind == YK_TASK_MOTION && s->task->motion.conditions >= 4 && s->dyad_count > 0;
    if (is_errors ? !has_errors : !has_curves) return NULL;
    yk_text_clear(svg);
    if (is_errors)
        draw_errors(s, svg);
    else
        draw_burmester(s, svg);
    if (ran_out) *ran_out = svg->failed;
    return svg->failed ? NULL : yk_text_get(svg);
}
