// `synthesis: motion`: positions of a body, and pivots that are given.
#include <math.h>
#include <string.h>
#include "synthesis/tasks/task.h"

static void read_position(YkTaskReader *reader, const YkNode *node, YkPose *pose)
{
    static const char *const own[] = {"at", "angle", NULL};
    static const YkSubject subject = {.noun = "position"};
    YkLoader *loader = reader->loader;
    YkWant at = {.dimension = YK_DIM_LENGTH, .subject = {.noun = "point", .part = "at"}};
    YkWant angle = {.dimension = YK_DIM_ANGLE, .subject = {.noun = "value", .part = "angle"}};
    YkExpr *expr[2];
    *pose = (YkPose){.at = {NAN, NAN}, .angle = NAN};
    if (!yk_load_expect(loader, node, YK_NODE_MAP, &subject)) return;
    yk_load_check_keys(loader, node, own, &subject);
    const YkNode *where = yk_load_require(loader, node, "at", &subject);
    const YkNode *turn = yk_load_require(loader, node, "angle", &subject);
    if (where) yk_load_pair(loader, where, &at, expr, &pose->at);
    if (turn) yk_load_value(loader, turn, &angle, &pose->angle);
}

// {position: 2, velocity: [0.2, 0], rate: 1 rad/s}: how the body passes a position, up to a factor.
static void read_rate(YkTaskReader *reader, const YkNode *node, size_t index)
{
    static const char *const own[] = {"position", "velocity", "rate", NULL};
    static const YkSubject subject = {.noun = "rate"};
    YkLoader *loader = reader->loader;
    YkMotionTask *motion = &reader->task->motion;
    YkPose *pose = &motion->pose[motion->count + index];
    YkWant speed = {.dimension = YK_DIM_SPEED, .subject = {.noun = "velocity", .part = "velocity"}};
    YkWant turn = {.dimension = YK_DIM_ANGLE_RATE, .subject = {.noun = "value", .part = "rate"}};
    YkExpr *expr[2];
    *pose = (YkPose){.is_rate = true, .velocity = {NAN, NAN}, .rate = NAN};
    motion->rate_of[index] = YK_NOT_FOUND;
    if (!yk_load_expect(loader, node, YK_NODE_MAP, &subject)) return;
    yk_load_check_keys(loader, node, own, &subject);
    const YkNode *which = yk_load_require(loader, node, "position", &subject);
    const YkNode *velocity = yk_load_require(loader, node, "velocity", &subject);
    const YkNode *rate = yk_load_require(loader, node, "rate", &subject);
    if (velocity) yk_load_pair(loader, velocity, &speed, expr, &pose->velocity);
    if (rate) yk_load_value(loader, rate, &turn, &pose->rate);
    for (size_t k = 0; which && which->kind == YK_NODE_SCALAR && k < motion->count; k++) {
        const char digit[] = {(char)('1' + k), '\0'};
        if (strcmp(which->text, digit) != 0) continue;
        motion->rate_of[index] = k;
        return;
    }
    if (!which) return;
    yk_problem(loader->problems, YK_CODE_TASK_POSITIONS, which->place,
               "`position` is the number of one of the %z positions", motion->count);
    yk_problem_hint(loader->problems, "the first one is position 1");
}

static void read_rates(YkTaskReader *reader)
{
    YkLoader *loader = reader->loader;
    YkMotionTask *motion = &reader->task->motion;
    const YkNode *list = yk_node_get(loader->root, "rates");
    if (!list || !yk_load_expect(loader, list, YK_NODE_LIST, &(YkSubject){.noun = "section", .part = "rates"})) return;
    if (motion->count + list->count > YK_POSES_MAX) {
        yk_problem(loader->problems, YK_CODE_TASK_POSITIONS, list->place,
                   "positions and rates are at most five together; here are %z and %z", motion->count, list->count);
        yk_problem_hint(loader->problems, "each rate counts as a further position");
        return;
    }
    motion->conditions = motion->count + list->count;
    for (size_t k = 0; k < list->count; k++) read_rate(reader, list->items[k], k);
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
    motion->pose = YK_NEW(loader->arena, YkPose, YK_POSES_MAX);
    motion->place = YK_NEW(loader->arena, YkPlace, list->count);
    if (!motion->pose || !motion->place) return;
    motion->count = motion->conditions = list->count;
    for (size_t k = 0; k < list->count; k++) {
        motion->place[k] = list->items[k]->place;
        read_position(reader, list->items[k], &motion->pose[k]);
    }
    read_rates(reader);
}

// Returns whether a rate before this one has the same position.
static bool is_second(const YkMotionTask *motion, size_t rate)
{
    for (size_t k = 0; k < rate; k++)
        if (motion->rate_of[k] == motion->rate_of[rate]) return true;
    return false;
}

// Reports rates of nothing and second rates, and puts the others where their positions are, whose values are known now.
static void place_rates(YkTaskReader *reader)
{
    YkMotionTask *motion = &reader->task->motion;
    const YkNode *list = yk_node_get(reader->loader->root, "rates");
    for (size_t k = motion->count; k < motion->conditions; k++) {
        YkPose *rate = &motion->pose[k];
        size_t of = motion->rate_of[k - motion->count];
        if (of == YK_NOT_FOUND) continue; // reported
        const YkPose *at = &motion->pose[of];
        rate->at = at->at;
        rate->angle = at->angle;
        if (is_second(motion, k - motion->count)) {
            yk_problem(reader->loader->problems, YK_CODE_TASK_POSITIONS, list->items[k - motion->count]->place,
                       "position %z has a rate already", of + 1);
            yk_problem_hint(reader->loader->problems, "leave one out: the body passes a position in one direction");
        }
        if (yk_norm(rate->velocity) + fabs(rate->rate) != 0) continue; // NaN: reported
        yk_problem(reader->loader->problems, YK_CODE_TASK_POSITIONS, list->items[k - motion->count]->place,
                   "the body does not move at this position: a rate gives the direction of its motion");
        yk_problem_hint(reader->loader->problems, "leave it out, or give a velocity or a rate of turning other than 0");
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

// Reports three or more positions with a common pole: the body then turns about it, and a pin there is the machine.
static void check_pole(YkTaskReader *reader)
{
    const YkMotionTask *motion = &reader->task->motion;
    double size = 0;
    size_t turned = 0;
    for (size_t k = 0; k < motion->count; k++) {
        if (!is_known(motion->pose[k])) return;
        size = fmax(size, yk_norm(yk_sub(motion->pose[k].at, motion->pose[0].at)));
        if (turned == 0 && fabs(yk_sin((motion->pose[k].angle - motion->pose[0].angle) / 2)) > 1e-6) turned = k;
    }
    if (motion->count < 3 || motion->conditions > motion->count || turned == 0) return;
    // (R_k - R_0) z = d_0 - d_k: z is the body's point that position `turned` leaves in place.
    const YkPose *first = &motion->pose[0], *other = &motion->pose[turned];
    YkVec turn = yk_sub(yk_unit(other->angle), yk_unit(first->angle));
    YkVec z = yk_scale(1 / yk_dot(turn, turn), yk_mul(yk_sub(first->at, other->at), yk_conj(turn)));
    YkVec pole = yk_pose_apply(*first, z);
    for (size_t k = 1; k < motion->count; k++)
        if (yk_norm(yk_sub(yk_pose_apply(motion->pose[k], z), pole)) > 1e-9 * (size + yk_norm(z))) return;
    double unit, small = 1e-12 * (size + yk_norm(z));
    if (fabs(pole.x) < small) pole.x = 0;
    if (fabs(pole.y) < small) pole.y = 0;
    const char *name = yk_model_unit(reader->loader->model, YK_QUANTITY_LENGTH, &unit);
    yk_problem(reader->loader->problems, YK_CODE_TASK_SPECIAL, motion->place[0],
               "through these positions the body only turns about one point, (%e, %e) %s", pole.x / unit, pole.y / unit,
               name);
    yk_problem_hint(reader->loader->problems, "a pin there is the whole machine; a four-bar needs other positions");
}

// Reports what leaves no slide: its line, or the pivot of its block, is found, and five positions have none.
static void check_slider(YkTaskReader *reader)
{
    const YkTask *task = reader->task;
    YkProblems *problems = reader->loader->problems;
    const YkNode *mechanisms = yk_node_get(reader->loader->root, "mechanisms");
    if (task->has_four_bar || task->kinds == 0) return;
    if (task->motion.conditions == YK_POSES_MAX) {
        yk_problem(problems, YK_CODE_TASK_POSITIONS, mechanisms->place,
                   "five positions have no slide: a slider-crank takes a body exactly through two to four");
        yk_problem_hint(problems, "leave one position out, or add four-bar");
    } else if (task->motion.pivot[1].is_given) {
        yk_problem(problems, YK_CODE_TASK_BOUNDS, mechanisms->place,
                   "a slider-crank has no output pivot to be given: the line of its slider, or the pivot of its block, "
                   "is found");
        yk_problem_hint(problems, "leave `output_pivot` out, or add four-bar");
    }
}

void yk_task_check_motion(YkTaskReader *reader)
{
    const YkMotionTask *motion = &reader->task->motion;
    const YkNode *fix = yk_node_get(reader->loader->root, "fix");
    place_rates(reader);
    check_different(reader);
    check_turned(reader);
    check_pole(reader);
    check_slider(reader);
    if (motion->conditions < 4 || (!motion->pivot[0].is_given && !motion->pivot[1].is_given)) return;
    yk_problem(reader->loader->problems, YK_CODE_TASK_POSITIONS, fix->place,
               "with %z positions no pivot can be chosen freely: the positions determine them", motion->conditions);
    yk_problem_hint(reader->loader->problems,
                    "leave `fix` out, bound the pivots by `bounds: {pivots: [[x, y], [x, y]]}`, or give "
                    "three positions");
}
