// Places bodies so that distances on the page are as close as possible to distances in the graph, by stress
// majorization (Gansner, Koren & North 2004), starting from a circle in the order of the bodies.
#include "report/graph.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/vec.h"
#include "model/model.h"
#include "picture/drawing/drawing.h"
#include "picture/svg.h"
#include "write/table.h"

enum { BODIES_MAX = 40, ROUNDS = 300, LINKS_MAX = 160 };
static const double step = 150, margin = 90, tall = 30; // px: between neighbours, round the picture, of a box

typedef enum LinkKind { IN_TREE, CLOSING, MESH } LinkKind;
typedef struct Link {
    size_t a, b;
    const char *name;
    LinkKind kind;
    int lane, lanes; // among links between the same two bodies
} Link;

typedef struct Graph {
    const YkMechanism *mech;
    const YkModel *model;
    size_t count;
    Link links[LINKS_MAX];
    size_t link_count;
    double distance[BODIES_MAX][BODIES_MAX];
    YkVec at[BODIES_MAX];
    size_t step_of[BODIES_MAX]; // 1 ...; 0: none
} Graph;

static void link(Graph *graph, int32_t a, int32_t b, const char *name, LinkKind kind)
{
    if (graph->link_count >= LINKS_MAX || a == b) return;
    Link *own = &graph->links[graph->link_count];
    *own = (Link){.a = (size_t)a, .b = (size_t)b, .name = name, .kind = kind};
    for (size_t k = 0; k < graph->link_count; k++) {
        const Link *other = &graph->links[k];
        bool same = (other->a == own->a && other->b == own->b) || (other->a == own->b && other->b == own->a);
        own->lane += same;
    }
    graph->link_count++;
    for (size_t k = 0; k < graph->link_count; k++) {
        Link *other = &graph->links[k];
        bool same = (other->a == own->a && other->b == own->b) || (other->a == own->b && other->b == own->a);
        if (same) other->lanes = own->lane + 1;
    }
}

static bool closes_loop(const YkMechanism *mech, size_t joint)
{
    for (size_t l = 0; l < yk_loop_count(mech); l++)
        if (yk_loop_joint(mech, l) == joint) return true;
    return false;
}

static void gather(Graph *graph)
{
    const YkModel *model = graph->model;
    for (size_t j = 0; j < yk_model_joint_count(model); j++)
        link(graph, (int32_t)yk_model_joint_body(model, j, 0), (int32_t)yk_model_joint_body(model, j, 1),
             model->joints[j].name, closes_loop(graph->mech, j) ? CLOSING : IN_TREE);
    for (size_t k = 0; k < model->gear_count; k++)
        link(graph, model->gears[k].body[0], model->gears[k].body[1], model->gears[k].name, MESH);
    for (size_t k = 0; k < model->belt_count; k++)
        link(graph, model->belts[k].body[0], model->belts[k].body[1], model->belts[k].name, MESH);
    for (size_t k = 0; k < model->rack_count; k++)
        link(graph, model->racks[k].pinion, model->racks[k].rack, model->racks[k].name, MESH);
    for (size_t k = 0; k < model->cam_count; k++)
        link(graph, model->cams[k].cam, model->cams[k].follower, model->cams[k].name, MESH);
    for (size_t b = 0; b < yk_block_count(graph->mech); b++)
        for (size_t i = 0; i < yk_block_info(graph->mech, b).body_count; i++) {
            size_t body = yk_block_body(graph->mech, b, i);
            if (body < graph->count && graph->step_of[body] == 0) graph->step_of[body] = b + 1;
        }
}

// Finds shortest paths between all bodies (Floyd 1962); unconnected bodies are put a little farther apart.
static void measure(Graph *graph)
{
    size_t n = graph->count;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) graph->distance[i][j] = i == j ? 0 : (double)n;
    for (size_t k = 0; k < graph->link_count; k++) {
        const Link *own = &graph->links[k];
        graph->distance[own->a][own->b] = graph->distance[own->b][own->a] = 1;
    }
    for (size_t k = 0; k < n; k++)
        for (size_t i = 0; i < n; i++)
            for (size_t j = 0; j < n; j++)
                graph->distance[i][j] = fmin(graph->distance[i][j], graph->distance[i][k] + graph->distance[k][j]);
}

static void place(Graph *graph)
{
    size_t n = graph->count;
    for (size_t i = 0; i < n; i++) // the ground at the foot of the circle
        graph->at[i] = yk_scale(0.2 * (double)n + 0.5, yk_unit(YK_PI / 2 + 2 * YK_PI * (double)i / (double)n));
    for (int round = 0; round < ROUNDS; round++)
        for (size_t i = 0; i < n; i++) {
            YkVec sum = {0, 0};
            double weights = 0;
            for (size_t j = 0; j < n; j++) {
                if (j == i) continue;
                double d = graph->distance[i][j], w = 1 / (d * d);
                YkVec away = yk_sub(graph->at[i], graph->at[j]);
                double far = fmax(yk_norm(away), 1e-6);
                sum = yk_add(sum, yk_scale(w, yk_add(graph->at[j], yk_scale(d / far, away))));
                weights += w;
            }
            graph->at[i] = yk_scale(1 / weights, sum);
        }
}

// Turns the picture so that the ground is at the bottom, and fits it to the page.
static YkVec settle(Graph *graph)
{
    YkVec middle = {0, 0}, low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    for (size_t i = 0; i < graph->count; i++) middle = yk_add(middle, yk_scale(1 / (double)graph->count, graph->at[i]));
    YkVec down = yk_sub(graph->at[0], middle);
    double length = yk_norm(down);
    YkVec turn = length > 1e-9 ? yk_mul(yk_vec(0, 1), yk_conj(yk_scale(1 / length, down))) : yk_vec(1, 0);
    for (size_t i = 0; i < graph->count; i++) {
        graph->at[i] = yk_scale(step, yk_mul(turn, graph->at[i]));
        low = yk_vec(fmin(low.x, graph->at[i].x), fmin(low.y, graph->at[i].y));
        high = yk_vec(fmax(high.x, graph->at[i].x), fmax(high.y, graph->at[i].y));
    }
    for (size_t i = 0; i < graph->count; i++)
        graph->at[i] = yk_vec(graph->at[i].x - low.x + margin, graph->at[i].y - low.y + 0.6 * margin);
    return yk_vec(high.x - low.x + 2 * margin, high.y - low.y + 1.2 * margin);
}

static void add_path(YkText *svg, YkVec a, YkVec by, YkVec b)
{
    yk_text_puts(svg, "<path d=\"M");
    const double numbers[] = {a.x, a.y, by.x, by.y, b.x, b.y};
    for (int i = 0; i < 6; i++) {
        yk_text_puts(svg, i == 2 ? "Q" : i > 0 ? " " : "");
        yk_svg_number(svg, numbers[i]);
    }
    yk_text_puts(svg, "\"");
}

// Adds a link; links between the same two bodies bend to both sides.
static void add_link(Graph *graph, const Link *own, YkText *svg)
{
    YkVec a = graph->at[own->a], b = graph->at[own->b], along = yk_sub(b, a);
    double length = fmax(yk_norm(along), 1),
           bow = 60 * (own->lane - 0.5 * (own->lanes - 1)) * (own->a < own->b ? 1 : -1);
    YkVec middle = yk_scale(0.5, yk_add(a, b)), out = yk_scale(bow / length, yk_quarter(along));
    YkVec label = yk_add(middle, yk_scale(0.5, out));
    add_path(svg, a, yk_add(middle, out), b);
    yk_text_format(svg, " fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\"%s/>\n",
                   own->kind == MESH ? "#8a4480" : "#55585c",
                   own->kind == CLOSING ? " stroke-dasharray=\"6 4\""
                   : own->kind == MESH  ? " stroke-dasharray=\"1.5 3.5\" stroke-linecap=\"round\""
                                        : "");
    yk_svg_word(svg, yk_vec(label.x, label.y + 4.5), own->name,
                "fill=\"#1c1e21\" font-weight=\"bold\" stroke=\"#fcfcfa\" stroke-width=\"5\" stroke-linejoin=\"round\" "
                "paint-order=\"stroke\"");
}

static void add_box(Graph *graph, size_t body, YkText *svg)
{
    const char *name = graph->model->bodies[body].name;
    double wide = 7.6 * (double)yk_text_columns(name, strlen(name)) + 24;
    YkColour colour = yk_drawing_colour(body);
    YkVec at = graph->at[body];
    const double numbers[] = {at.x - 0.5 * wide, at.y - 0.5 * tall, wide, tall};
    static const char *const names[] = {"x", "y", "width", "height"};
    yk_text_puts(svg, "<rect");
    for (int i = 0; i < 4; i++) {
        yk_text_format(svg, " %s=\"", names[i]);
        yk_svg_number(svg, numbers[i]);
        yk_text_puts(svg, "\"");
    }
    yk_text_format(svg, " rx=\"%d\" fill=\"%s\" stroke=\"%s\" stroke-width=\"1.3\"/>\n", body == 0 ? 2 : 8, colour.fill,
                   colour.edge);
    yk_svg_word(svg, yk_vec(at.x, at.y + 4.5), name, "fill=\"#1c1e21\"");
    if (graph->step_of[body] == 0) return;
    YkText number = {0};
    yk_text_format(&number, "%z", graph->step_of[body]);
    YkVec corner = yk_vec(at.x + 0.5 * wide, at.y - 0.5 * tall);
    yk_svg_circle(svg, corner, 9, "fill=\"#55585c\"");
    yk_svg_word(svg, yk_vec(corner.x, corner.y + 4), yk_text_get(&number), "fill=\"#fff\" font-size=\"11\"");
    svg->failed |= number.failed;
    yk_text_free(&number);
}

bool yk_structure_write(const YkMechanism *mech, YkText *svg)
{
    const YkModel *model = yk_mechanism_model(mech);
    Graph *graph = model->body_count <= BODIES_MAX ? calloc(1, sizeof *graph) : NULL;
    if (!graph && model->body_count <= BODIES_MAX) yk_text_fail(svg);
    if (!graph) return false;
    graph->mech = mech;
    graph->model = model;
    graph->count = yk_model_body_count(model);
    gather(graph);
    measure(graph);
    place(graph);
    YkVec page = settle(graph);
    yk_text_puts(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ");
    yk_svg_number(svg, page.x);
    yk_text_puts(svg, " ");
    yk_svg_number(svg, page.y);
    yk_text_puts(svg, "\" style=\"max-width:");
    yk_svg_number(svg, page.x);
    yk_text_puts(
        svg,
        "px\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" font-size=\"13\" text-anchor=\"middle\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fcfcfa\"/>\n");
    for (size_t k = 0; k < graph->link_count; k++) add_link(graph, &graph->links[k], svg);
    for (size_t b = 0; b < graph->count; b++) add_box(graph, b, svg);
    yk_text_puts(svg, "</svg>\n");
    free(graph);
    return !svg->failed;
}
