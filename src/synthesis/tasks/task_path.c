// `synthesis: path`: points that a coupler point is to pass, with or without the input's angles.
#include <math.h>
#include "synthesis/tasks/task.h"

static void read_points(YkTaskReader *reader)
{
    YkLoader *loader = reader->loader;
    YkPathTask *path = &reader->task->path;
    YkWant want = {.dimension = YK_DIM_LENGTH, .subject = {.noun = "point", .owner = "points"}};
    YkExpr *expr[2];
    const YkNode *list = yk_load_require(loader, loader->root, "points", &(YkSubject){.noun = "a path task"});
    if (!list || !yk_load_expect(loader, list, YK_NODE_LIST, &(YkSubject){.noun = "section", .part = "points"})) return;
    path->place = list->place;
    if (list->count < 2 || list->count > YK_PATH_POINTS_MAX) {
        yk_problem(loader->problems, YK_CODE_TASK_POSITIONS, list->place, "a path has 2 to %d points; here are %z",
                   (int)YK_PATH_POINTS_MAX, list->count);
        yk_problem_hint(loader->problems, list->count < 2 ? "a single point leaves everything free: give the points "
                                                            "between which the path runs"
                                                          : "every tenth point gives the same curve");
        return;
    }
    path->point = YK_NEW(loader->arena, YkVec, list->count);
    if (!path->point) return;
    path->count = list->count;
    for (size_t k = 0; k < list->count; k++) {
        path->point[k] = yk_vec(NAN, NAN);
        yk_load_pair(loader, list->items[k], &want, expr, &path->point[k]);
    }
}

static void read_step(YkTaskReader *reader, const YkNode *map)
{
    static const char *const own[] = {"from", "step", NULL}, *const from[] = {"free", NULL};
    size_t found = 0;
    yk_load_check_keys(reader->loader, map, own, &(YkSubject){.noun = "section", .part = "angles"});
    yk_load_require(reader->loader, map, "from", &(YkSubject){.noun = "section", .part = "angles"});
    yk_task_word(reader, map, "from", from, &found);
    yk_task_need(reader, map, "step", YK_DIM_ANGLE, &reader->task->path.step);
    reader->task->path.timing = YK_TIMING_STEP;
}

static void read_angles(YkTaskReader *reader)
{
    YkLoader *loader = reader->loader;
    YkPathTask *path = &reader->task->path;
    YkWant want = {.dimension = YK_DIM_ANGLE, .subject = {.noun = "angle", .owner = "angles"}};
    const YkNode *node = yk_node_get(loader->root, "angles");
    if (!node) return;
    if (node->kind == YK_NODE_MAP) {
        read_step(reader, node);
        return;
    }
    if (!yk_load_expect(loader, node, YK_NODE_LIST, &(YkSubject){.noun = "section", .part = "angles"})) return;
    if (node->count != path->count && path->count > 0) {
        yk_problem(loader->problems, YK_CODE_COMPONENTS, node->place,
                   "`angles` has one angle for each point: here are %z angles for %z points", node->count, path->count);
        return;
    }
    path->angle = YK_NEW(loader->arena, double, node->count);
    path->timing = YK_TIMING_ANGLES;
    for (size_t k = 0; k < node->count && path->angle; k++) {
        path->angle[k] = NAN;
        yk_load_value(loader, node->items[k], &want, &path->angle[k]);
    }
}

// `angles_from: ground`, which asks for angles one by one.
static void read_angles_from(YkTaskReader *reader)
{
    static const char *const words[] = {"x", "ground", NULL};
    YkLoader *loader = reader->loader;
    YkPathTask *path = &reader->task->path;
    size_t found = 0;
    const YkNode *node = yk_node_get(loader->root, "angles_from");
    if (!node || !yk_task_word(reader, loader->root, "angles_from", words, &found)) return;
    path->from_ground = found == 1;
    const YkNode *angles = yk_node_get(loader->root, "angles");
    if (angles && angles->kind != YK_NODE_MAP) return;
    yk_problem(loader->problems, angles ? YK_CODE_RIVAL_KEYS : YK_CODE_MISSING_KEY, node->place,
               angles ? "the first of the `angles` is free: `angles_from` has nothing to count"
                      : "`angles_from` says how `angles` are counted, which are not given");
    yk_problem_hint(loader->problems, "give one angle for each point, as in angles: [30 deg, 60 deg], or leave it out");
}

void yk_task_read_path(YkTaskReader *reader)
{
    static const char *const own[] = {"input_pivot", "output_pivot", "ground_angle", NULL};
    YkLoader *loader = reader->loader;
    YkPathTask *path = &reader->task->path;
    const YkNode *fix = yk_load_section(loader, "fix");
    if (fix) yk_load_check_keys(loader, fix, own, &(YkSubject){.noun = "section", .part = "fix"});
    for (size_t i = 0; i < YK_SIDES; i++) yk_task_point(reader, fix, own[i], &path->pivot[i]);
    yk_task_value(reader, fix, own[2], YK_DIM_ANGLE, &path->ground_angle);
    path->is_closed = yk_task_yes(reader, loader->root, "closed", false);
    read_points(reader);
    read_angles(reader);
    read_angles_from(reader);
}

// --- values

static void check_points(YkTaskReader *reader)
{
    const YkPathTask *path = &reader->task->path;
    const YkNode *list = yk_node_get(reader->loader->root, "points");
    double size = 0;
    for (size_t k = 0; k < path->count; k++) size = fmax(size, yk_norm(yk_sub(path->point[k], path->point[0])));
    for (size_t k = 1; k < path->count; k++) {
        if (!(yk_norm(yk_sub(path->point[k], path->point[k - 1])) <= 1e-12 * size)) continue;
        yk_problem(reader->loader->problems, YK_CODE_TASK_POSITIONS, list->items[k]->place,
                   "point %z is the same as point %z", k + 1, k);
        yk_problem_hint(reader->loader->problems, "leave one of them out");
    }
}

static void check_angles(YkTaskReader *reader)
{
    const YkPathTask *path = &reader->task->path;
    const YkNode *node = yk_node_get(reader->loader->root, "angles");
    YkProblems *problems = reader->loader->problems;
    if (path->timing == YK_TIMING_STEP && !isnan(path->step) &&
        !(fabs(path->step) > 1e-6 && fabs(path->step) < 2 * YK_PI))
        yk_problem(problems, YK_CODE_TASK_FUNCTION, node->place,
                   "the step of `angles` is longer than 0 and shorter than a turn, either way");
    if (path->timing != YK_TIMING_ANGLES || !path->angle || reader->task->any_order) return;
    for (size_t k = 1; k < path->count; k++) {
        double step = path->angle[k] - path->angle[k - 1], way = path->angle[1] - path->angle[0];
        if (isnan(step) || step * way > 0) continue;
        yk_problem(problems, YK_CODE_TASK_FUNCTION, node->items[k]->place,
                   "angle %z does not go on from angle %z in the sense of the first two", k + 1, k);
        yk_problem_hint(problems, "add a turn of 360 deg where the angles pass it, or write require: {order: false}");
        return;
    }
}

// A ground that is fixed twice.
static void check_fix(YkTaskReader *reader)
{
    const YkPathTask *path = &reader->task->path;
    const YkNode *fix = yk_node_get(reader->loader->root, "fix");
    YkProblems *problems = reader->loader->problems;
    bool has_both = path->pivot[0].is_given && path->pivot[1].is_given;
    if (has_both && yk_norm(yk_sub(path->pivot[1].at, path->pivot[0].at)) == 0)
        yk_problem(problems, YK_CODE_TASK_BOUNDS, fix->place, "both pivots are at the same point");
    YkVec ground = yk_sub(path->pivot[1].at, path->pivot[0].at);
    double off = has_both && path->ground_angle.is_given
                     ? yk_remainder(yk_atan2(ground.y, ground.x) - path->ground_angle.value, 2 * YK_PI)
                     : 0;
    if (fabs(off) > 1e-9) {
        yk_problem(problems, YK_CODE_RIVAL_KEYS, fix->place,
                   "the two pivots give the ground another angle than `ground_angle`");
        yk_problem_hint(problems, "leave `ground_angle` or one of the pivots out");
    }
    if (reader->task->has_slider && path->pivot[1].is_given)
        yk_problem(problems, YK_CODE_TASK_BOUNDS, fix->place,
                   "a slider-crank has no output pivot: `output_pivot` belongs to four-bars alone");
}

// Nine points are met by finitely many four-bars only if nothing else is given.
static void check_nine(YkTaskReader *reader)
{
    enum { NINE = 9 };
    const YkPathTask *path = &reader->task->path;
    size_t given = 2 * (size_t)(path->pivot[0].is_given + path->pivot[1].is_given);
    if (path->ground_angle.is_given && given < 4) given++;
    if (path->count != NINE || path->timing != YK_TIMING_ANY || given == 0 || !reader->task->has_four_bar) return;
    yk_problem(reader->loader->problems, YK_CODE_TASK_NEARLY, yk_node_get(reader->loader->root, "fix")->place,
               "nine points need all nine dimensions of a four-bar, and `fix` leaves %z: the nearest are sought",
               NINE - given);
    yk_problem_hint(reader->loader->problems,
                    "without `fix` all four-bars that pass the nine points are found; %z points may be met with it",
                    NINE - given);
}

void yk_task_check_path(YkTaskReader *reader)
{
    check_points(reader);
    check_angles(reader);
    check_fix(reader);
    check_nine(reader);
}
