// `synthesis: motion`: positions of a body, and pivots that are given.
#include <math.h>
#include "synthesis/task.h"

static void read_position(YkTaskReader *reader, const YkNode *node, YkPose *pose)
{
    static const char *const own[] = {"at", "angle", NULL};
    static const YkSubject subject = {.noun = "position"};
    YkLoader *loader = reader->loader;
    YkWant at = {.dimension = YK_DIM_LENGTH, .subject = {.noun = "point", .part = "at"}};
    YkWant angle = {.dimension = YK_DIM_ANGLE, .subject = {.noun = "value", .part = "angle"}};
    YkExpr *expr[2];
    *pose = (YkPose){{NAN, NAN}, NAN};
    if (!yk_load_expect(loader, node, YK_NODE_MAP, &subject)) return;
    yk_load_check_keys(loader, node, own, &subject);
    const YkNode *where = yk_load_require(loader, node, "at", &subject);
    const YkNode *turn = yk_load_require(loader, node, "angle", &subject);
    if (where) yk_load_pair(loader, where, &at, expr, &pose->at);
    if (turn) yk_load_value(loader, turn, &angle, &pose->angle);
}

void yk_task_read_motion(YkTaskReader *reader)
{
    static const char *const own[] = {"input_pivot", "output_pivot", NULL};
    YkLoader *loader = reader->loader;
    YkMotionTask *motion = &reader->task->motion;
    const YkNode *fix = yk_load_section(loader, "fix");
    if (fix) yk_load_check_keys(loader, fix, own, &(YkSubject){.noun = "section", .part = "fix"});
    yk_task_point(reader, fix, own[0], &motion->pivot[0]);
    yk_task_point(reader, fix, own[1], &motion->pivot[1]);
    const YkNode *list = yk_load_require(loader, loader->root, "positions", &(YkSubject){.noun = "a motion task"});
    if (!list || !yk_load_expect(loader, list, YK_NODE_LIST, &(YkSubject){.noun = "section", .part = "positions"}))
        return;
    if (list->count < 2 || list->count > YK_POSES_MAX) {
        yk_problem(loader->problems, YK_CODE_TASK_POSITIONS, list->place,
                   "a four-bar takes a body exactly through two to five positions; here are %z", list->count);
        yk_problem_hint(loader->problems, list->count < 2 ? "give at least two" : "choose the five that matter most");
        return;
    }
    motion->pose = YK_NEW(loader->arena, YkPose, list->count);
    motion->place = YK_NEW(loader->arena, YkPlace, list->count);
    if (!motion->pose || !motion->place) return;
    motion->count = list->count;
    for (size_t k = 0; k < list->count; k++) {
        motion->place[k] = list->items[k]->place;
        read_position(reader, list->items[k], &motion->pose[k]);
    }
}

static bool is_known(YkPose pose)
{
    return isfinite(pose.at.x) && isfinite(pose.at.y) && isfinite(pose.angle);
}

// Reports positions that are given twice.
static void check_different(YkTaskReader *reader)
{
    const YkMotionTask *motion = &reader->task->motion;
    double size = 0;
    for (size_t k = 1; k < motion->count; k++)
        size = fmax(size, yk_norm(yk_sub(motion->pose[k].at, motion->pose[0].at)));
    for (size_t k = 1; k < motion->count; k++)
        for (size_t i = 0; i < k; i++) {
            YkPose a = motion->pose[i], b = motion->pose[k];
            if (!is_known(a) || !is_known(b)) continue;
            bool is_same = yk_norm(yk_sub(a.at, b.at)) <= 1e-9 * size && fabs(yk_sin((a.angle - b.angle) / 2)) < 1e-9;
            if (!is_same) continue;
            yk_problem(reader->loader->problems, YK_CODE_TASK_POSITIONS, motion->place[k],
                       "position %z is the same as position %z", k + 1, i + 1);
            yk_problem_hint(reader->loader->problems, "leave one of them out");
        }
}

// Reports positions between which the body never turns: it then slides, and every dyad has a twin beside it.
static void check_turned(YkTaskReader *reader)
{
    const YkMotionTask *motion = &reader->task->motion;
    double turn = 0;
    for (size_t k = 0; k < motion->count; k++) {
        if (!is_known(motion->pose[k])) return;
        turn = fmax(turn, fabs(yk_sin((motion->pose[k].angle - motion->pose[0].angle) / 2)));
    }
    if (turn > 1e-6 || motion->count == 0) return;
    yk_problem(reader->loader->problems, YK_CODE_TASK_SPECIAL, motion->place[0],
               "the body does not turn between these positions");
    yk_problem_hint(
        reader->loader->problems,
        "a slide or a parallelogram moves a body so; a four-bar takes it through positions that differ in angle");
}

void yk_task_check_motion(YkTaskReader *reader)
{
    const YkMotionTask *motion = &reader->task->motion;
    const YkNode *fix = yk_node_get(reader->loader->root, "fix");
    check_different(reader);
    check_turned(reader);
    if (motion->count < 4 || (!motion->pivot[0].is_given && !motion->pivot[1].is_given)) return;
    yk_problem(reader->loader->problems, YK_CODE_TASK_POSITIONS, fix->place,
               "with %z positions no pivot can be chosen freely: the positions determine them", motion->count);
    yk_problem_hint(reader->loader->problems,
                    "leave `fix` out, bound the pivots by `bounds: {pivots: [[x, y], [x, y]]}`, or give "
                    "three positions");
}
