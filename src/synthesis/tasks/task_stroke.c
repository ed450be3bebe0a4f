// `synthesis: stroke`: a rocker's swing or a slider's stroke, with its time ratio.
#include <math.h>
#include "synthesis/tasks/task.h"

void yk_task_read_stroke(YkTaskReader *reader)
{
    static const char *const own[] = {"ground", "input", "coupler", "output", NULL};
    YkLoader *loader = reader->loader;
    YkStrokeTask *task = &reader->task->stroke;
    const YkNode *fix = yk_load_section(loader, "fix"), *root = loader->root;
    const YkNode *swing = yk_node_get(root, "swing"), *stroke = yk_node_get(root, "stroke");
    YkGiven *lengths[] = {&task->ground, &task->input, &task->coupler, &task->output};
    if (fix) yk_load_check_keys(loader, fix, own, &(YkSubject){.noun = "section", .part = "fix"});
    for (size_t i = 0; i < 4; i++) yk_task_value(reader, fix, own[i], YK_DIM_LENGTH, lengths[i]);
    task->is_slider = stroke != NULL;
    task->place = (swing ? swing : stroke ? stroke : root)->place;
    task->stroke = task->ratio = NAN;
    if (swing && stroke)
        yk_problem(loader->problems, YK_CODE_RIVAL_KEYS, yk_load_key(root, "stroke")->place,
                   "a rocker has a `swing`, a slider a `stroke`: give one of them");
    else if (swing || stroke)
        yk_task_need(reader, root, swing ? "swing" : "stroke", swing ? YK_DIM_ANGLE : YK_DIM_LENGTH, &task->stroke);
    else
        yk_problem(loader->problems, YK_CODE_MISSING_KEY, root->place, "a stroke task needs `swing` or `stroke`");
    const YkNode *ratio = yk_node_get(root, "time_ratio");
    YkWant want = {.dimension = YK_DIM_NUMBER, .subject = {.noun = "value", .part = "time_ratio"}};
    task->ratio = 1;
    if (ratio) yk_load_value(loader, ratio, &want, &task->ratio);
}

void yk_task_check_stroke(YkTaskReader *reader)
{
    YkStrokeTask *task = &reader->task->stroke;
    YkProblems *problems = reader->loader->problems;
    const YkNode *ratio = yk_node_get(reader->loader->root, "time_ratio"),
                 *fix = yk_node_get(reader->loader->root, "fix");
    const YkGiven *lengths[] = {&task->ground, &task->input, &task->coupler, &task->output};
    size_t given = 0;
    if (ratio && !isnan(task->ratio) && !(task->ratio >= 1 && task->ratio < 3))
        yk_problem(problems, YK_CODE_TASK_FUNCTION, ratio->place, "a time ratio is at least 1 and less than 3 here");
    double most = task->is_slider ? INFINITY : YK_PI;
    if (!isnan(task->stroke) && !(task->stroke > 0 && task->stroke < most))
        yk_problem(problems, YK_CODE_TASK_FUNCTION, task->place,
                   task->is_slider ? "a stroke is longer than 0"
                                   : "a rocker swings by more than 0 and less than half a turn");
    for (size_t i = 0; i < 4; i++) {
        given += lengths[i]->is_given;
        if (lengths[i]->is_given && lengths[i]->value <= 0)
            yk_problem(problems, YK_CODE_TASK_BOUNDS, fix->place, "a given length is positive");
    }
    if (given > 1 || (given == 1 && task->is_slider)) {
        yk_problem(problems, YK_CODE_TASK_BOUNDS, fix->place,
                   task->is_slider ? "the stroke settles the size of a slider-crank: no length can be given"
                                   : "one length settles the size of the machine; here are %z",
                   given);
        yk_problem_hint(problems,
                        "the other lengths follow from the swing, the time ratio and the best transmission angle");
    }
}
