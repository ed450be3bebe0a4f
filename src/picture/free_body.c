// Makes free-body drawings: pictures, arrows, names.
#include "picture/free_body.h"
#include <stdlib.h>
#include <string.h>
#include "base/escape.h"
#include "picture/free_body_inside.h"
#include "picture/labels.h"

static const char ink[] = "#1c1e21", force_colour[] = "#b3261e", moment_colour[] = "#6a3d9a", grey[] = "#55585c";

// --- Making

// Sets the values of the pose; every unknown is 1, so that its factor is its direction. The forces that are known say
// which flanks of a mesh push.
static bool set_values(YkFreeBodyDrawings *p, const YkState *state, YkDynamics *dynamics)
{
    const YkDeriveForces *f = p->forces;
    p->values = calloc(yk_ring_symbol_count(p->d->ring) + 1, sizeof *p->values);
    if (!p->values) return false;
    yk_derive_values(p->d, state, dynamics, p->values);
    for (size_t k = 0; k < f->reaction_count; k++) p->values[f->reactions[k]] = 1;
    for (size_t k = 0; k < f->load_count; k++)
        if (f->loads[k].symbol != YK_NONE) p->values[f->loads[k].symbol] = 1;
    yk_ring_complete(p->d->ring, p->values);
    return true;
}

static bool make(YkFreeBodyDrawings *p, const YkState *state, YkDynamics *dynamics)
{
    const YkDrawOptions options = yk_default_draw_options();
    p->arena = yk_arena_new();
    p->forces = yk_derive_forces(p->d);
    p->drawing = yk_drawing_new(p->d->mech, &options);
    if (!p->arena || !p->forces || !p->drawing) return false;
    p->drawing->keeps_followers = true;
    YkStatus status = yk_drawing_pose(p->drawing, state);
    p->is_infinite = status < 0 && status != YK_NO_MEMORY;
    if (status < 0) return false;
    size_t bodies = yk_model_body_count(p->d->model) - 1;
    p->count = bodies + p->forces->junction_count;
    p->pictures = YK_NEW(p->arena, YkFreeBodyDrawing, p->count + 1);
    if (!p->pictures || !set_values(p, state, dynamics)) return false;
    for (size_t k = 0; k < p->count; k++) {
        p->pictures[k].body = k < bodies ? (int32_t)k + 1 : YK_NONE;
        p->pictures[k].junction = k < bodies ? YK_NONE : (int32_t)(k - bodies);
    }
    return yk_free_body_gather(p) && yk_free_body_arrange(p);
}

YkFreeBodyDrawings *yk_free_body_drawings_new(YkDerivation *d, const YkState *state, YkDynamics *dynamics)
{
    YkFreeBodyDrawings *p = calloc(1, sizeof *p);
    if (p) p->d = d;
    if (p && make(p, state, dynamics)) return p;
    // If there is nothing to draw, or no memory, the derivation whose equations they show has failed.
    if (!p || (!p->is_infinite && yk_ring_status(d->ring) == YK_RING_OK)) d->failed = true;
    yk_free_body_drawings_free(p);
    return NULL;
}

void yk_free_body_drawings_free(YkFreeBodyDrawings *p)
{
    if (!p) return;
    yk_drawing_free(p->drawing);
    yk_names_free(&p->spot_names);
    free(p->arrows);
    free(p->values);
    yk_arena_free(p->arena);
    free(p);
}

size_t yk_free_body_drawings_count(const YkFreeBodyDrawings *p)
{
    return p->count;
}

const char *yk_free_body_drawings_title(const YkFreeBodyDrawings *p, size_t picture)
{
    return p->pictures[picture].title;
}

const char *yk_free_body_drawings_stem(const YkFreeBodyDrawings *p, size_t picture)
{
    return p->pictures[picture].stem;
}

// --- Drawing

static void set_style(YkText *style, const char *fill, const char *stroke, double width, const char *more)
{
    yk_text_clear(style);
    yk_text_format(style, "fill=\"%s\" stroke=\"%s\" stroke-width=\"", fill, stroke);
    yk_svg_number(style, width);
    yk_text_format(style, "\"%s", more);
}

// Draws a head at `tip`, pointing along.
static void add_head(YkText *svg, YkVec tip, YkVec along, const char *colour, YkText *style)
{
    YkVec back = yk_sub(tip, yk_scale(10, along)), across = yk_scale(3.6, yk_quarter(along));
    YkVec corners[3] = {tip, yk_add(back, across), yk_sub(back, across)};
    set_style(style, colour, "none", 0, "");
    yk_svg_polygon(svg, corners, 3, yk_text_get(style));
}

static void add_force(YkText *svg, const YkArrow *arrow, YkText *style)
{
    const char *colour = arrow->is_inertia ? grey : force_colour;
    set_style(style, "none", colour, 1.8, arrow->is_inertia ? " stroke-dasharray=\"6 3\"" : "");
    yk_svg_line(svg, arrow->from, yk_sub(arrow->to, yk_scale(8, arrow->along)), yk_text_get(style));
    add_head(svg, arrow->to, arrow->along, colour, style);
}

// Draws three quarters of a circle, open at its beginning.
static void add_moment(YkText *svg, const YkArrow *arrow, YkText *style)
{
    enum { STEPS = 27 };
    const char *colour = arrow->is_inertia ? grey : moment_colour;
    YkVec points[STEPS + 1];
    for (int i = 0; i <= STEPS; i++) {
        double angle = (arrow->turn > 0 ? -60 + 270.0 * i / STEPS : 240 - 270.0 * i / STEPS) * YK_PI / 180;
        points[i] = yk_add(arrow->at, yk_scale(arrow->radius, yk_conj(yk_unit(angle))));
    }
    set_style(style, "none", colour, 1.8, arrow->is_inertia ? " stroke-dasharray=\"6 3\"" : "");
    yk_svg_polyline(svg, points, STEPS - 1, yk_text_get(style));
    YkVec along = yk_sub(points[STEPS], points[STEPS - 2]);
    add_head(svg, points[STEPS], yk_scale(1 / yk_norm(along), along), colour, style);
}

// Adds "-m1 a^{C1}, inertia": shown when a reader points at the arrow.
static void add_title(YkText *svg, const YkArrow *arrow)
{
    const YkSvgName *name = &arrow->name;
    yk_text_puts(svg, "<title>");
    if (name->sign) yk_text_puts(svg, "-");
    if (name->factor) yk_escape_xml(svg, name->factor);
    yk_escape_xml(svg, strcmp(name->base, "\xce\xb1") == 0 ? "alpha" : name->base);
    if (name->super) yk_text_format(svg, "^{%s}", name->super);
    if (name->sub) yk_text_format(svg, "_%s", name->sub);
    yk_text_puts(svg, ", ");
    yk_escape_xml(svg, arrow->words);
    yk_text_puts(svg, "</title>\n");
}

static void add_arrows(YkFreeBodyDrawings *p, const YkFreeBodyDrawing *picture, YkText *style)
{
    YkText *svg = &p->drawing->svg;
    for (size_t k = 0; k < picture->count; k++) {
        const YkArrow *arrow = &p->arrows[picture->first + k];
        yk_text_puts(svg, "<g>\n");
        add_title(svg, arrow);
        if (arrow->turn == 0)
            add_force(svg, arrow, style);
        else
            add_moment(svg, arrow, style);
        yk_text_puts(svg, "</g>\n");
    }
}

static void add_shape(YkFreeBodyDrawings *p, int32_t body)
{
    YkDrawing *drawing = p->drawing;
    const YkFrame *frames = yk_drawing_frames(drawing, 0);
    const YkModel *model = p->d->model;
    yk_drawing_body_wheels(drawing, frames, body);
    for (int pass = 0; pass < 2; pass++) { // rods and slots below the body, pins and boxes above
        for (size_t j = 0; j < model->joint_count; j++)
            for (int side = 0; side < 2; side++) {
                const YkJoint *joint = &model->joints[j];
                bool is_under = side == 0 && (joint->kind == YK_SLIDE || joint->kind == YK_PIN_SLOT);
                if (joint->body[side] == body && !joint->is_free && is_under == (pass == 0))
                    yk_drawing_joint_on(drawing, frames, joint, side);
            }
        if (pass == 0) yk_drawing_body(drawing, &frames[body], (size_t)body);
    }
}

static void add_spots(YkText *svg, const YkFreeBodyDrawing *picture, YkText *style)
{
    for (size_t k = 0; k < picture->spot_count; k++) {
        YkVec at = picture->spots[k].at;
        if (!picture->spots[k].is_center) {
            set_style(style, ink, "#fcfcfa", 1, "");
            yk_svg_circle(svg, at, 3, yk_text_get(style));
            continue;
        }
        set_style(style, "#fcfcfa", ink, 1.2, "");
        yk_svg_circle(svg, at, 4.5, yk_text_get(style));
        yk_svg_line(svg, yk_vec(at.x - 4.5, at.y), yk_vec(at.x + 4.5, at.y), yk_text_get(style));
        yk_svg_line(svg, yk_vec(at.x, at.y - 4.5), yk_vec(at.x, at.y + 4.5), yk_text_get(style));
    }
}

// --- Names

static void put_name(YkText *svg, YkLabels *labels, const YkSvgName *name, YkBox box, const char *colour, YkText *style)
{
    yk_labels_take(labels, box);
    yk_text_clear(style);
    yk_text_format(style, "fill=\"%s\"", colour);
    yk_svg_name(svg, yk_vec(box.left + 2, box.bottom - 5), name, yk_text_get(style));
}

static void name_arrow(YkText *svg, YkLabels *labels, const YkArrow *arrow, YkText *style)
{
    double width = yk_svg_name_width(&arrow->name), height = 18, at_end, at_middle = INFINITY;
    bool leaves = yk_norm(yk_sub(arrow->from, arrow->at)) < yk_norm(yk_sub(arrow->to, arrow->at));
    YkVec end = leaves ? arrow->to : arrow->from, middle = yk_scale(0.5, yk_add(arrow->from, arrow->to));
    if (arrow->turn != 0) end = arrow->at;
    YkBox box = yk_labels_find(labels, end, arrow->turn != 0 ? arrow->radius + 5 : 3, width, height, &at_end),
          other = box;
    if (arrow->turn == 0) other = yk_labels_find(labels, middle, 4, width, height, &at_middle);
    const char *colour = arrow->is_inertia ? grey : arrow->turn != 0 ? moment_colour : force_colour;
    put_name(svg, labels, &arrow->name, at_end <= at_middle + 3 ? box : other, colour, style);
}

static void name_spots(YkText *svg, YkLabels *labels, const YkFreeBodyDrawing *picture, YkText *style)
{
    for (size_t k = 0; k < picture->spot_count; k++) {
        YkSvgName name = {.factor = picture->spots[k].name};
        YkBox box = yk_labels_find(labels, picture->spots[k].at, 7, yk_svg_name_width(&name), 16, NULL);
        put_name(svg, labels, &name, box, ink, style);
    }
}

static void add_names(YkFreeBodyDrawings *p, const YkFreeBodyDrawing *picture, YkText *style)
{
    YkLabels *labels = calloc(1, sizeof *labels);
    if (labels) labels->lines = calloc(yk_free_body_line_count(p, picture) + 1, sizeof *labels->lines);
    if (!labels || !labels->lines) {
        free(labels);
        p->drawing->svg.failed = true;
        return;
    }
    labels->half = 5;
    labels->width = YK_FREE_BODY_WIDTH;
    labels->height = YK_FREE_BODY_HEIGHT;
    labels->line_count = yk_free_body_lines(p, picture, labels->lines);
    yk_labels_take(labels, (YkBox){0, 0, YK_FREE_BODY_WIDTH, 44});
    yk_labels_take(labels, (YkBox){0, YK_FREE_BODY_HEIGHT - 76, 84, YK_FREE_BODY_HEIGHT}); // axes
    yk_labels_take(labels, (YkBox){0, YK_FREE_BODY_HEIGHT - 26, YK_FREE_BODY_WIDTH, YK_FREE_BODY_HEIGHT});
    for (size_t k = 0; k < picture->spot_count; k++) yk_labels_take(labels, yk_box_at(picture->spots[k].at, 12, 12));
    for (size_t k = 0; k < picture->count; k++) {
        const YkArrow *arrow = &p->arrows[picture->first + k];
        if (arrow->turn != 0)
            yk_labels_take(labels, yk_box_at(arrow->at, 2 * arrow->radius + 9, 2 * arrow->radius + 9));
    }
    for (size_t k = 0; k < picture->count; k++)
        name_arrow(&p->drawing->svg, labels, &p->arrows[picture->first + k], style);
    name_spots(&p->drawing->svg, labels, picture, style);
    free(labels->lines);
    free(labels);
}

static void add_axes(YkText *svg, YkText *style)
{
    YkVec origin = yk_vec(30, YK_FREE_BODY_HEIGHT - 38), axes[2] = {{1, 0}, {0, -1}};
    static const char *const names[] = {"x", "y"};
    for (int k = 0; k < 2; k++) {
        YkVec tip = yk_add(origin, yk_scale(30, axes[k]));
        set_style(style, "none", grey, 1.2, "");
        yk_svg_line(svg, origin, yk_sub(tip, yk_scale(6, axes[k])), yk_text_get(style));
        add_head(svg, tip, axes[k], grey, style);
        YkVec at = k == 0 ? yk_vec(tip.x + 4, tip.y + 4) : yk_vec(tip.x + 6, tip.y + 6);
        yk_svg_word(svg, at, names[k], "fill=\"#55585c\" font-style=\"italic\"");
    }
}

static void add_margin(YkText *svg, const YkFreeBodyDrawing *picture)
{
    yk_svg_word(svg, yk_vec(20, 30), picture->title, "fill=\"#1c1e21\" font-size=\"16\" font-weight=\"bold\"");
    yk_svg_word(svg, yk_vec(YK_FREE_BODY_WIDTH - 14, YK_FREE_BODY_HEIGHT - 10),
                "unknown vectors drawn for positive components; dashed: inertia",
                "fill=\"#55585c\" font-size=\"11\" text-anchor=\"end\"");
}

const char *yk_free_body_drawings_svg(YkFreeBodyDrawings *p, size_t picture)
{
    const YkFreeBodyDrawing *of = &p->pictures[picture];
    YkText *svg = &p->drawing->svg, title = {0}, style = {0};
    yk_text_clear(svg);
    yk_free_body_turn_to(p, of);
    yk_text_format(&title, "%s: %s", yk_model_name(p->d->model), of->title);
    yk_drawing_open(p->drawing, yk_text_get(&title));
    if (of->body != YK_NONE) add_shape(p, of->body);
    add_axes(svg, &style);
    add_arrows(p, of, &style);
    add_spots(svg, of, &style);
    add_names(p, of, &style);
    add_margin(svg, of);
    yk_text_puts(svg, "</svg>\n");
    yk_text_free(&title);
    yk_text_free(&style);
    return svg->failed ? NULL : yk_text_get(svg);
}
