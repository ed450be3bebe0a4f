// The structure as a picture, read back: every body, joint and mesh is where it has to be, the same every time.
#include "check.h"
#include <stdlib.h>
#include <yoke/yoke.h>
#include "base/vec.h"
#include "model/model.h"
#include "picture/drawing/drawing.h"
#include "report/graph.h"

enum { MOST = 64 };

typedef struct Box {
    YkVec at; // its middle
    double width, height;
} Box;

// A link of the machine, and what is drawn for it: a curve from a by a control point to b.
typedef struct Link {
    size_t a, b;
    const char *name;
    bool closes, is_mesh;
    YkVec bow; // of the control point, off the middle
} Link;

typedef struct Picture {
    const char *svg;
    Box boxes[MOST];
    size_t count;
    Link links[2 * MOST];
    size_t link_count;
} Picture;

static double attribute(const char *element, const char *name)
{
    char pattern[32];
    snprintf(pattern, sizeof pattern, " %s=\"", name);
    const char *at = strstr(element, pattern);
    return at ? atof(at + strlen(pattern)) : (double)NAN;
}

static void read_boxes(Picture *picture)
{
    for (const char *at = strstr(picture->svg, "<rect x="); at; at = strstr(at + 1, "<rect x=")) {
        Box box = {.width = attribute(at, "width"), .height = attribute(at, "height")};
        box.at = yk_vec(attribute(at, "x") + box.width / 2, attribute(at, "y") + box.height / 2);
        picture->boxes[picture->count++] = box;
    }
}

static void add_link(Picture *picture, int32_t a, int32_t b, const char *name, bool closes, bool is_mesh)
{
    if (a == b) return;
    picture->links[picture->link_count++] =
        (Link){.a = (size_t)a, .b = (size_t)b, .name = name, .closes = closes, .is_mesh = is_mesh};
}

static void take_links(Picture *picture, const YkMechanism *mech, const YkModel *model)
{
    for (size_t j = 0; j < model->joint_count; j++) {
        bool closes = false;
        for (size_t l = 0; l < yk_loop_count(mech); l++) closes = closes || yk_loop_joint(mech, l) == j;
        add_link(picture, model->joints[j].body[0], model->joints[j].body[1], model->joints[j].name, closes, false);
    }
    for (size_t k = 0; k < model->gear_count; k++)
        add_link(picture, model->gears[k].body[0], model->gears[k].body[1], model->gears[k].name, false, true);
    for (size_t k = 0; k < model->belt_count; k++)
        add_link(picture, model->belts[k].body[0], model->belts[k].body[1], model->belts[k].name, false, true);
    for (size_t k = 0; k < model->rack_count; k++)
        add_link(picture, model->racks[k].pinion, model->racks[k].rack, model->racks[k].name, false, true);
    for (size_t k = 0; k < model->cam_count; k++)
        add_link(picture, model->cams[k].cam, model->cams[k].follower, model->cams[k].name, false, true);
}

static void check_apart(const Picture *picture)
{
    for (size_t i = 0; i < picture->count; i++)
        for (size_t k = 0; k < i; k++) {
            const Box *one = &picture->boxes[i], *other = &picture->boxes[k];
            bool apart = fabs(one->at.x - other->at.x) > (one->width + other->width) / 2 ||
                         fabs(one->at.y - other->at.y) > one->height;
            if (!apart) fail_msg("boxes %zu and %zu lie on each other", k, i);
        }
}

// The ground is straight below the middle of all, and the boxes stand in the middle of the page.
static void check_page(const Picture *picture)
{
    YkVec middle = {0, 0}, low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    for (size_t i = 0; i < picture->count; i++) {
        YkVec at = picture->boxes[i].at;
        middle = yk_add(middle, yk_scale(1 / (double)picture->count, at));
        low = yk_vec(fmin(low.x, at.x), fmin(low.y, at.y));
        high = yk_vec(fmax(high.x, at.x), fmax(high.y, at.y));
    }
    CHECK_NEAR(picture->boxes[0].at.x, middle.x, 0.05);
    assert_true(picture->boxes[0].at.y > middle.y);
    const char *size = strstr(picture->svg, "viewBox=\"0 0 ");
    assert_non_null(size);
    char *end;
    double width = strtod(size + strlen("viewBox=\"0 0 "), &end), height = strtod(end, NULL);
    CHECK_NEAR(low.x + high.x, width, 0.05);
    CHECK_NEAR(low.y + high.y, height, 0.05);
    CHECK_NEAR(atof(strstr(picture->svg, "max-width:") + strlen("max-width:")), width, 0.01);
    for (size_t i = 0; i < picture->count; i++) {
        const Box *box = &picture->boxes[i];
        assert_true(box->at.x >= box->width / 2 && box->at.x <= width - box->width / 2);
        assert_true(box->at.y >= box->height && box->at.y <= height - box->height);
    }
}

// Every link is drawn from body to body, bowed aside, with its name on its curve; those that close loops are dashed.
static void check_links(Picture *picture)
{
    const char *at = picture->svg;
    for (size_t k = 0; k < picture->link_count; k++) {
        Link *link = &picture->links[k];
        at = strstr(at, "<path d=\"M");
        assert_non_null(at);
        char *from;
        double p[6];
        p[0] = strtod(at + strlen("<path d=\"M"), &from);
        for (int i = 1; i < 6; i++) p[i] = strtod(from + (*from == 'Q'), &from);
        YkVec a = picture->boxes[link->a].at, b = picture->boxes[link->b].at;
        assert_true(yk_norm(yk_sub(yk_vec(p[0], p[1]), a)) < 0.02 && yk_norm(yk_sub(yk_vec(p[4], p[5]), b)) < 0.02);
        link->bow = yk_sub(yk_vec(p[2], p[3]), yk_scale(0.5, yk_add(a, b)));
        CHECK_NEAR(yk_dot(link->bow, yk_sub(b, a)), 0, 0.02 * yk_norm(yk_sub(b, a)));
        const char *end = strchr(at, '>');
        at = strstr(at, "<text");
        const char *dashes = strstr(from, "stroke-dasharray=\"");
        const char *wanted = link->is_mesh ? "1.5 3.5" : link->closes ? "6 4" : "";
        assert_int_equal(dashes && dashes < end, *wanted != '\0');
        if (*wanted) assert_memory_equal(dashes + strlen("stroke-dasharray=\""), wanted, strlen(wanted));
        YkVec curve = yk_add(yk_scale(0.5, yk_add(a, b)), yk_scale(0.5, link->bow));
        CHECK_NEAR(attribute(at, "x"), curve.x, 0.02);
        CHECK_NEAR(attribute(at, "y") - 4.5, curve.y, 0.02); // its foot
        const char *word = strchr(at, '>') + 1;
        assert_memory_equal(word, link->name, strlen(link->name));
        assert_int_equal(word[strlen(link->name)], '<');
    }
    assert_null(strstr(at, "<path"));
}

// Links between the same two bodies bend to both sides alike, so that no two curves are one; a single one is straight.
static void check_bows(const Picture *picture)
{
    for (size_t k = 0; k < picture->link_count; k++) {
        const Link *own = &picture->links[k];
        YkVec sum = {0, 0};
        double least = INFINITY;
        for (size_t i = 0; i < picture->link_count; i++) {
            const Link *other = &picture->links[i];
            if ((other->a != own->a || other->b != own->b) && (other->a != own->b || other->b != own->a)) continue;
            sum = yk_add(sum, other->bow);
            if (i != k) least = fmin(least, yk_norm(yk_sub(other->bow, own->bow)));
        }
        assert_true(yk_norm(sum) < 0.1);
        assert_true(isinf(least) || (least > 50 && least < 70));
    }
}

// Distances on the page are those of the graph as well as they can be: no box is drawn anywhere else by the springs
// between all boxes, as stiff as one over the square of their length in the graph (Kamada & Kawai 1989).
static void check_distances(const Picture *picture)
{
    static double far[MOST][MOST];
    size_t n = picture->count;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) far[i][j] = i == j ? 0 : (double)n;
    for (size_t round = 0; round < n; round++)
        for (size_t k = 0; k < picture->link_count; k++)
            for (size_t i = 0; i < n; i++) {
                size_t a = picture->links[k].a, b = picture->links[k].b;
                far[i][a] = fmin(far[i][a], far[i][b] + 1);
                far[i][b] = fmin(far[i][b], far[i][a] + 1);
            }
    for (size_t i = 0; i < n; i++) {
        YkVec pull = {0, 0};
        double stiff = 0;
        for (size_t j = 0; j < n; j++) {
            if (j == i) continue;
            YkVec apart = yk_sub(picture->boxes[j].at, picture->boxes[i].at);
            double length = yk_norm(apart), k = 1 / (far[i][j] * far[i][j]);
            pull = yk_add(pull, yk_scale(k * (length - 150 * far[i][j]) / length, apart));
            stiff += k;
        }
        assert_true(yk_norm(pull) < 0.3 * stiff); // px
    }
}

// The number at a body's corner is its step in the order of solution.
static void check_steps(const Picture *picture, const YkMechanism *mech)
{
    size_t numbered = 0;
    for (const char *at = strstr(picture->svg, "<circle"); at; at = strstr(at + 1, "<circle")) {
        YkVec corner = {attribute(at, "cx"), attribute(at, "cy")};
        size_t body = 0, step = 0;
        while (body < picture->count &&
               yk_norm(yk_sub(corner, yk_add(picture->boxes[body].at, yk_vec(picture->boxes[body].width / 2,
                                                                             -picture->boxes[body].height / 2)))) >
                   0.05)
            body++;
        assert_true(body < picture->count);
        for (size_t b = yk_block_count(mech); b-- > 0;)
            for (size_t i = 0; i < yk_block_info(mech, b).body_count; i++)
                if (yk_block_body(mech, b, i) == body) step = b + 1;
        const char *word = strstr(at, "<text");
        CHECK_NEAR(attribute(word, "x"), corner.x, 0.02);
        assert_int_equal(atoi(strchr(word, '>') + 1), step);
        numbered++;
    }
    size_t solved = 0;
    for (size_t body = 0; body < picture->count; body++) {
        bool is_solved = false;
        for (size_t b = 0; b < yk_block_count(mech); b++)
            for (size_t i = 0; i < yk_block_info(mech, b).body_count; i++)
                is_solved = is_solved || yk_block_body(mech, b, i) == body;
        solved += is_solved;
    }
    assert_int_equal(numbered, solved);
}

static size_t check_picture(YkModel *model)
{
    YkMechanism *mech = model ? yk_mechanism_compile(model, NULL, NULL) : NULL;
    assert_non_null(mech);
    YkText svg = {0}, again = {0};
    Picture picture = {0};
    assert_true(yk_structure_write(mech, &svg));
    picture.svg = yk_text_get(&svg);
    read_boxes(&picture);
    assert_int_equal(picture.count, model->body_count);
    take_links(&picture, mech, model);
    check_apart(&picture);
    check_page(&picture);
    check_links(&picture);
    check_bows(&picture);
    check_distances(&picture);
    check_steps(&picture, mech);
    assert_true(yk_structure_write(mech, &again));
    assert_string_equal(picture.svg, yk_text_get(&again));
    yk_text_free(&svg);
    yk_text_free(&again);
    yk_mechanism_free(mech);
    yk_model_free(model);
    return picture.link_count;
}

static void pictures_are_readable(void **state)
{
    (void)state;
    static const char *const names[] = {"four-bar",  "quick-return",    "jansen",    "andrews",  "pendulum",
                                        "epicyclic", "geared-five-bar", "valve-cam", "excavator"};
    size_t links = 0;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[500];
        snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, names[i]);
        links += check_picture(yk_model_load(path, NULL, NULL));
    }
    assert_true(links > 40);
}

// A belt and a rack are lines between the bodies that they tie.
static void belts_and_racks_are_drawn(void **state)
{
    (void)state;
    static const char text[] =
        "bodies: {ground: {points: {A: [0, 0], B: [2, 0], G: [2.5, 0]}}, motor: {}, drum: {}, load: {}}\n"
        "joints: {A: {pin: [ground, motor], angle: p}, B: {pin: [ground, drum], angle: q}, "
        "S: {slide: [ground, load], along: y, from: G, distance: h}}\n"
        "belts: {belt: {between: [motor, drum], radii: [0.2, 0.4]}}\n"
        "racks: {rope: {pinion: drum, rack: load, radius: 0.5}}\n";
    assert_int_equal(check_picture(yk_model_parse(text, strlen(text), "test.yaml", NULL, NULL)), 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(pictures_are_readable),
                                       cmocka_unit_test(belts_and_racks_are_drawn)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
