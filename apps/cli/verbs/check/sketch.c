// yoke check --sketch: what a machine lacks to move, finished or not.
#include <yoke/sketch.h>
#include "session.h"
#include "verbs/check/check.h"

static void add_lack(YkText *out, const YkLack *lack)
{
    yk_text_format(out, "  %s", lack->text);
    if (lack->freedom > 0)
        yk_text_format(out, " (%z degree%s of freedom)", lack->freedom, lack->freedom == 1 ? "" : "s");
    yk_text_format(out, "\n    %s\n", lack->mend);
}

// Those that are optional, or those that are not, below a heading.
static void add_lacks(YkText *out, const YkSketch *sketch, bool optional, const char *heading)
{
    bool is_first = true;
    for (size_t i = 0; i < yk_sketch_lack_count(sketch); i++) {
        YkLack lack = yk_sketch_lack(sketch, i);
        if (lack.is_optional != optional) continue;
        if (is_first) yk_text_format(out, "\n%s\n", heading);
        is_first = false;
        add_lack(out, &lack);
    }
}

static void write_text(YkText *out, const YkSketch *sketch)
{
    const YkModel *model = yk_sketch_model(sketch);
    size_t bodies = yk_model_body_count(model) - 1, joints = yk_sketch_joint_count(sketch);
    int freedom = yk_sketch_freedom(sketch);
    yk_text_format(out, "%s\n  %z bod%s beside the ground, %z joint%s; %d degree%s of freedom\n", yk_model_name(model),
                   bodies, bodies == 1 ? "y" : "ies", joints, joints == 1 ? "" : "s", freedom, freedom == 1 ? "" : "s");
    if (yk_sketch_moves(sketch)) yk_text_puts(out, "  It lacks nothing to move.\n");
    add_lacks(out, sketch, false, "What it lacks to move");
    add_lacks(out, sketch, true, "What could be added");
}

static const char *point_name(const YkModel *model, size_t point)
{
    return point == YK_NOT_FOUND ? NULL : yk_model_point_name(model, point);
}

static void write_lack_json(YkJson *json, const YkSketch *sketch, const YkLack *lack)
{
    const YkModel *model = yk_sketch_model(sketch);
    yk_json_object(json, NULL, YK_JSON_INLINE);
    yk_json_string(json, "kind", yk_lack_kind_name(lack->kind));
    yk_json_bool(json, "optional", lack->is_optional);
    yk_json_integer(json, "freedom", (long long)lack->freedom);
    if (lack->body != YK_NOT_FOUND) yk_json_string(json, "body", yk_model_body_name(model, lack->body));
    if (lack->point != YK_NOT_FOUND) yk_json_string(json, "point", point_name(model, lack->point));
    if (lack->other != YK_NOT_FOUND)
        yk_json_string(json, "other_body", yk_model_body_name(model, yk_model_point_body(model, lack->other)));
    if (lack->coordinate != YK_NOT_FOUND)
        yk_json_string(json, "coordinate", yk_coordinate_info(yk_sketch_mechanism(sketch), lack->coordinate).name);
    yk_json_string(json, "message", lack->text);
    yk_json_string(json, "mend", lack->mend);
    yk_json_string(json, "path", lack->path);
    yk_json_string(json, "value", lack->value);
    yk_json_end(json);
}

static void write_json(YkText *out, const YkSketch *sketch)
{
    YkJson json = {.text = out};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_string(&json, "model", yk_model_name(yk_sketch_model(sketch)));
    yk_json_bool(&json, "moves", yk_sketch_moves(sketch));
    yk_json_integer(&json, "freedom", yk_sketch_freedom(sketch));
    yk_json_list(&json, "lacks", YK_JSON_LINES);
    for (size_t i = 0; i < yk_sketch_lack_count(sketch); i++) {
        YkLack lack = yk_sketch_lack(sketch, i);
        write_lack_json(&json, sketch, &lack);
    }
    yk_json_end(&json);
    yk_json_end(&json);
}

static YkSketch *load(YkSession *session, YkProblems *problems)
{
    YkLoadOptions options;
    if (!yk_session_load_options(session, true, &options)) return NULL;
    return yk_sketch_load(session->request->file, &options, problems);
}

static int answer(YkSession *session, const YkSketch *sketch)
{
    if (session->request->format == YK_FORMAT_CSV) {
        yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--sketch writes text or json, not %q", "csv");
        return YK_EXIT_WRONG;
    }
    if (session->request->format == YK_FORMAT_JSON)
        write_json(&session->out, sketch);
    else
        write_text(&session->out, sketch);
    return yk_session_finish(session, YK_EXIT_DONE);
}

int yk_check_sketch(YkSession *session)
{
    YkProblems *problems = yk_session_has_file(session) ? yk_problems_new() : NULL;
    YkSketch *sketch = problems ? load(session, problems) : NULL;
    if (!sketch && session->request->file && (!problems || yk_problems_error_count(problems) == 0))
        yk_session_refuse_for_memory(session);
    if (problems) yk_tell_problems(session, problems);
    yk_problems_free(problems);
    int exit_code = sketch ? answer(session, sketch) : YK_EXIT_WRONG;
    yk_sketch_free(sketch);
    return exit_code;
}
