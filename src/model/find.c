// Finds bodies and points by name.
#include <string.h>
#include "model/load.h"

static int32_t find_point(YkLoader *loader, const char *body, const char *name)
{
    yk_text_clear(&loader->text);
    yk_text_puts(&loader->text, body);
    yk_text_add(&loader->text, ".", 1);
    yk_text_puts(&loader->text, name);
    if (loader->text.failed) return YK_NONE;
    return yk_names_find(&loader->model->point_names, yk_text_get(&loader->text));
}

int32_t yk_load_find_point(YkLoader *loader, int32_t body, const char *name)
{
    return find_point(loader, loader->model->bodies[body].name, name);
}

static void report_body(YkLoader *loader, const char *name, YkPlace place)
{
    const YkModel *model = loader->model;
    yk_problem(loader->problems, YK_CODE_UNKNOWN_BODY, place, "there is no body %q", name);
    if (strchr(name, '.')) { // a body's name holds no dot
        yk_problem_hint(loader->problems, "name the body alone; a joint's or a force's point is named with `at:`");
        return;
    }
    yk_load_hint_nearest(loader->problems, name, model->bodies, model->body_count, sizeof *model->bodies);
}

int32_t yk_load_body(YkLoader *loader, const YkNode *node)
{
    if (!yk_load_expect(loader, node, YK_NODE_SCALAR, &(YkSubject){.noun = "name of a body"})) return YK_NONE;
    int32_t body = yk_names_find(&loader->model->body_names, node->text);
    if (body == YK_NONE) report_body(loader, node->text, node->place);
    return body;
}

static void report_point(YkLoader *loader, int32_t body, const char *name, YkPlace place)
{
    const YkModel *model = loader->model;
    const YkBody *owner = &model->bodies[body];
    yk_problem(loader->problems, YK_CODE_UNKNOWN_POINT, place, "%q has no point %q", owner->name, name);
    const YkPoint *first = owner->point_count ? model->points + owner->first_point : NULL;
    yk_load_hint_nearest(loader->problems, name, first, (size_t)owner->point_count, sizeof *first);
}

int32_t yk_load_point(YkLoader *loader, int32_t body, const YkNode *node)
{
    if (!yk_load_expect(loader, node, YK_NODE_SCALAR, &(YkSubject){.noun = "name of a point"})) return YK_NONE;
    int32_t point = yk_load_find_point(loader, body, node->text);
    if (point == YK_NONE) report_point(loader, body, node->text, node->place);
    return point;
}

int32_t yk_load_body_point(YkLoader *loader, const YkNode *node, int32_t *body)
{
    *body = YK_NONE;
    if (!yk_load_expect(loader, node, YK_NODE_SCALAR, &(YkSubject){.noun = "point of a body"})) return YK_NONE;
    const char *dot = strchr(node->text, '.');
    if (!dot) {
        yk_problem(loader->problems, YK_CODE_UNKNOWN_POINT, node->place, "%q is not a point of a body", node->text);
        yk_problem_hint(loader->problems, "write body and point as in `ground.P`");
        return YK_NONE;
    }
    const char *name = yk_arena_copy(loader->arena, node->text, (size_t)(dot - node->text));
    if (!name) return YK_NONE;
    *body = yk_names_find(&loader->model->body_names, name);
    if (*body == YK_NONE) {
        report_body(loader, name, node->place);
        return YK_NONE;
    }
    int32_t point = yk_load_find_point(loader, *body, dot + 1);
    if (point == YK_NONE) report_point(loader, *body, dot + 1, node->place);
    return point;
}
