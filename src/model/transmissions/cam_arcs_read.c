// Reads `arcs:` of a cam, and makes the law of the follower's lift from them once all values are known.
#include <math.h>
#include <string.h>
#include "base/number.h"
#include "model/laws/read.h"
#include "model/transmissions/cam_arcs.h"

static YkExpr *read(YkLoader *loader, const YkCam *cam, const YkNode *map, const char *key, YkDimension dimension,
                    double *target)
{
    YkWant want = {.dimension = dimension, .subject = {.noun = key, .owner = cam->name}};
    return yk_load_key_value(loader, map, key, &want, target);
}

static bool is_word(const YkNode *node, const char *word)
{
    return node && node->kind == YK_NODE_SCALAR && strcmp(node->text, word) == 0;
}

static void read_symmetrical(YkLoader *loader, const YkCam *cam, const YkNode *map, YkCamArcs *arcs)
{
    static const char *const keys[] = {"nose", "lift", "angle", "flank", "from", NULL};
    const YkSubject subject = {.noun = "arcs", .owner = cam->name};
    const YkNode *angle = yk_node_get(map, "angle"), *flank = yk_node_get(map, "flank");
    yk_load_check_keys(loader, map, keys, &subject);
    arcs->is_symmetrical = true;
    bool has_nose = yk_load_require(loader, map, "nose", &subject),
         has_lift = yk_load_require(loader, map, "lift", &subject);
    arcs->is_bad = !has_nose || !has_lift;
    arcs->nose_expr = read(loader, cam, map, "nose", YK_DIM_LENGTH, &arcs->nose);
    arcs->lift_expr = read(loader, cam, map, "lift", YK_DIM_LENGTH, &arcs->lift);
    arcs->from_expr = read(loader, cam, map, "from", YK_DIM_ANGLE, &arcs->from);
    arcs->angle_expr = read(loader, cam, map, "angle", YK_DIM_ANGLE, &arcs->angle);
    arcs->flank_is_line = is_word(flank, "line");
    if (!arcs->flank_is_line) arcs->flank_expr = read(loader, cam, map, "flank", YK_DIM_LENGTH, &arcs->flank);
    if (!angle == !flank) {
        yk_problem(loader->problems, YK_CODE_CAM_ARCS, arcs->place,
                   angle ? "cam %q: `angle` and `flank` determine each other: give one of them"
                         : "cam %q: the arcs need the angle of action or the flank",
                   cam->name);
        yk_problem_hint(loader->problems, "as in {nose: 4 mm, lift: 9 mm, angle: 120 deg}, or with `flank: 80 mm`, or "
                                          "`flank: line`");
        arcs->is_bad = true;
    }
}

static void read_arc(YkLoader *loader, const YkCam *cam, const YkNode *node, YkCamArc *arc, YkCamArcs *arcs)
{
    static const char *const keys[] = {"center", "radius", NULL};
    const YkSubject subject = {.noun = "arc", .owner = cam->name};
    arc->place = node->place;
    arc->is_line = is_word(node, "line");
    if (arc->is_line) return;
    if (!yk_load_expect(loader, node, YK_NODE_MAP, &subject)) {
        yk_problem_hint(loader->problems, "an arc is {center: [x, y], radius: r}, or the word `line`");
        arcs->is_bad = true;
        return;
    }
    yk_load_check_keys(loader, node, keys, &subject);
    const YkNode *center = yk_load_require(loader, node, "center", &subject);
    const YkNode *radius = yk_load_require(loader, node, "radius", &subject);
    YkWant want = {.dimension = YK_DIM_LENGTH, .subject = {.noun = "center", .owner = cam->name}};
    arcs->is_bad |= !center || !radius || !yk_load_pair(loader, center, &want, arc->exprs, &arc->center);
    arc->exprs[2] = read(loader, cam, node, "radius", YK_DIM_LENGTH, &arc->radius);
}

void yk_load_cam_arcs(YkLoader *loader, YkCam *cam, const YkNode *node)
{
    YkCamArcs *arcs = YK_NEW(loader->arena, YkCamArcs, 1);
    if (!arcs) return;
    *arcs = (YkCamArcs){.place = node->place};
    cam->arcs = arcs;
    cam->law = yk_load_make_law(loader, cam->name, cam->place);
    if (node->kind == YK_NODE_MAP) {
        read_symmetrical(loader, cam, node, arcs);
        return;
    }
    arcs->is_bad = !yk_load_expect(loader, node, YK_NODE_LIST, &(YkSubject){.noun = "arcs", .owner = cam->name});
    if (arcs->is_bad || !yk_load_count_fits(loader, node, node->count, "arcs")) return;
    arcs->items = YK_NEW(loader->arena, YkCamArc, node->count + 1);
    if (!arcs->items) return;
    arcs->count = node->count;
    for (size_t i = 0; i < node->count; i++) read_arc(loader, cam, node->items[i], &arcs->items[i], arcs);
    if (node->count > 0) return;
    yk_problem(loader->problems, YK_CODE_CAM_ARCS, node->place, "cam %q has no arcs", cam->name);
    arcs->is_bad = true;
}

static bool is_known(const YkCamArcs *arcs)
{
    bool known = !arcs->is_bad && isfinite(arcs->from + arcs->nose + arcs->lift + arcs->angle + arcs->flank);
    for (size_t i = 0; i < arcs->count; i++)
        known = known && isfinite(arcs->items[i].center.x + arcs->items[i].center.y + arcs->items[i].radius);
    return known;
}

static void report_apart(YkLoader *loader, const YkCam *cam, const YkCamArc *here, const YkCamArc *next)
{
    char apart[YK_NUMBER_SIZE], radii[YK_NUMBER_SIZE];
    double size = 1;
    const char *unit = yk_model_unit(loader->model, YK_QUANTITY_LENGTH, &size);
    yk_number_write_digits(yk_norm(yk_sub(next->center, here->center)) / size, 9, apart);
    yk_number_write_digits(fabs(next->radius - here->radius) / size, 9, radii);
    yk_problem(loader->problems, YK_CODE_CAM_ARCS, here->place,
               "cam %q: this arc does not touch the next one: the centres are %s %s apart, the radii differ by %s %s",
               cam->name, apart, unit, radii, unit);
    yk_problem_hint(loader->problems, "correct a centre or a radius (in full: expressions help), or put a `line` "
                                      "between them; a hollow has a negative radius");
}

static void report(YkLoader *loader, const YkCam *cam, const YkCamArc *items, size_t count, size_t culprit,
                   YkCamArcsFault fault)
{
    static const char *const words[] = {
        [YK_CAM_ARCS_LINE] = "no line touches both neighbours here",
        [YK_CAM_ARCS_HOLLOW] = "the follower does not fit into this hollow: a roller must be smaller, and a flat face "
                               "cannot enter one",
        [YK_CAM_ARCS_REACH] = "the follower cannot touch the end of this arc",
        [YK_CAM_ARCS_ORDER] = "the follower does not touch every arc in turn: it would rest on two at once",
        [YK_CAM_ARCS_FLANK] = "no flank joins this base circle and this nose"};
    if (fault == YK_CAM_ARCS_APART) {
        report_apart(loader, cam, &items[culprit], &items[(culprit + 1) % count]);
        return;
    }
    bool is_whole = fault == YK_CAM_ARCS_ORDER || fault == YK_CAM_ARCS_FLANK;
    yk_problem(loader->problems, YK_CODE_CAM_ARCS, is_whole ? cam->arcs->place : items[culprit].place, "cam %q: %s",
               cam->name, words[fault]);
}

static bool check_sizes(YkLoader *loader, const YkCam *cam)
{
    const YkCamArcs *arcs = cam->arcs;
    const YkExpr *bad = !arcs->is_symmetrical ? NULL
                        : !(arcs->nose >= 0)  ? arcs->nose_expr
                        : !(arcs->lift > 0)   ? arcs->lift_expr
                                              : NULL;
    if (!bad) return true;
    yk_problem(loader->problems, YK_CODE_CAM_ARCS, bad->place,
               bad == arcs->lift_expr ? "cam %q: the `lift` of its arcs must be greater than zero"
                                      : "cam %q: the radius of the `nose` must not be negative",
               cam->name);
    return false;
}

// Reports where the lift itself jumps: the surface turns so steep there that the follower cannot follow it.
static bool report_jam(YkLoader *loader, const YkCam *cam, const YkModelLaw *law)
{
    enum { JUMPS_MAX = 100 };
    YkLawJump jumps[JUMPS_MAX];
    size_t count = yk_law_jumps(law->law, jumps, JUMPS_MAX);
    for (size_t i = 0; i < count && i < JUMPS_MAX; i++) {
        if (jumps[i].order > 0) continue;
        yk_problem(loader->problems, YK_CODE_CAM_ARCS, cam->arcs->place,
                   "cam %q: the follower jams: near %s the surface would push it straight across its motion", cam->name,
                   yk_load_law_place(loader->model, law, jumps[i].x).text);
        return true;
    }
    return false;
}

static void make_law(YkLoader *loader, const YkCam *cam, const YkCamSurface *surface, size_t count)
{
    YkModelLaw *law = &loader->model->laws[cam->law];
    double from = cam->arcs->from;
    YkLawBuilder *builder = yk_law_builder_new(from, 0);
    YkLawFault fault = builder ? yk_cam_arcs_add(cam, surface, count, from, builder) : YK_LAW_NO_MEMORY;
    if (fault == YK_LAW_OK) fault = yk_law_finish(builder, 2 * YK_PI, loader->arena, &law->law);
    if (fault == YK_LAW_NO_MEMORY)
        loader->failed = true;
    else if (fault != YK_LAW_OK)
        yk_problem(loader->problems, YK_CODE_CAM_ARCS, cam->arcs->place,
                   "cam %q: the follower cannot touch the surface at %s", cam->name,
                   yk_load_law_place(loader->model, law, yk_law_builder_trouble(builder)).text);
    yk_law_builder_free(builder);
    if (law->law && report_jam(loader, cam, law)) return;
    if (law->law) yk_load_law_report_jumps(loader, law);
}

void yk_load_finish_cam_arcs(YkLoader *loader, const YkCam *cam)
{
    YkCamArcs *arcs = cam->arcs;
    YkCamArc four[4];
    const YkCamArc *items = arcs->is_symmetrical ? four : arcs->items;
    size_t count = arcs->is_symmetrical ? 4 : arcs->count, culprit = 0;
    if (cam->law == YK_NONE || !is_known(arcs) || !check_sizes(loader, cam)) return;
    loader->model->laws[cam->law].value = cam->oscillates ? YK_DIM_ANGLE : YK_DIM_LENGTH;
    YkCamSurface *surface = YK_NEW(loader->arena, YkCamSurface, count);
    if (!surface) return;
    YkCamArcsFault fault = arcs->is_symmetrical ? yk_cam_arcs_symmetrical(arcs, cam->base, four) : YK_CAM_ARCS_GOOD;
    if (fault == YK_CAM_ARCS_GOOD) fault = yk_cam_arcs_surface(cam, items, count, surface, &culprit);
    if (fault != YK_CAM_ARCS_GOOD) {
        report(loader, cam, items, count, culprit, fault);
        return;
    }
    if (arcs->is_symmetrical) yk_cam_arcs_turn(cam, surface, count, 0, arcs->from);
    make_law(loader, cam, surface, count);
}
