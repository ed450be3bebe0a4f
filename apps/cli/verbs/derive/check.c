// yoke derive --check: is an equation true of this machine?
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/number.h"
#include "stop.h"
#include "verbs/derive/derive.h"
#include "verbs/derive/input.h"

enum { SHOWN_MAX = 12 }; // coordinates of a pose

typedef struct Checking {
    YkSession *session;
    YkDerivation *derivation;
    YkState *start; // each check starts at the requested pose
    YkJson json;
    bool as_json;
    int exit_code;
} Checking;

// Writes ", theta1' = 3 rad/s" if the equation contains rates; accelerations too if it contains these.
static void add_derivative(Checking *checking, YkText *text, const YkCoordinateInfo *info, double value, int order)
{
    yk_text_format(text, ", %s%s = ", info->name, order == 1 ? "'" : "''");
    yk_add_value(checking->session, text, value, yk_quantity_of(info->is_distance, order), YK_DIGITS);
}

static void add_pose(Checking *checking, YkText *text, const YkCheckShown *shown)
{
    const YkMechanism *mech = checking->session->mech;
    size_t count = shown->positions ? yk_coordinate_count(mech) : 0;
    if (shown->has_time) yk_text_format(text, "t = %e s%s", shown->time, count ? ", " : "");
    for (size_t k = 0; k < count && k < SHOWN_MAX; k++) {
        YkCoordinateInfo info = yk_coordinate_info(mech, k);
        YkMotion motion = shown->positions[k];
        yk_text_format(text, "%s%s = ", k ? ", " : "", info.name);
        yk_add_value(checking->session, text, motion.position, yk_quantity_of(info.is_distance, 0), YK_DIGITS);
        if (shown->order >= 1) add_derivative(checking, text, &info, motion.velocity, 1);
        if (shown->order >= 2) add_derivative(checking, text, &info, motion.acceleration, 2);
    }
    if (count > SHOWN_MAX) yk_text_puts(text, ", ...");
    if (shown->forces) yk_text_format(text, ", %s (SI)", shown->forces);
}

// Writes all digits if six do not show the difference.
static void add_difference(Checking *checking, YkText *text, const YkCheckShown *shown)
{
    bool is_close = fabs(shown->left - shown->right) < 1e-4 * fabs(shown->left);
    char sides[2][YK_NUMBER_SIZE];
    yk_number_write(shown->left, sides[0]);
    yk_number_write(shown->right, sides[1]);
    if (is_close)
        yk_text_format(text, "the left side is %s, the right side %s (SI) at\n  ", sides[0], sides[1]);
    else
        yk_text_format(text, "the left side is %e, the right side %e (SI) at\n  ", shown->left, shown->right);
    add_pose(checking, text, shown);
    yk_text_puts(text, "\n");
}

// Reports the extent of the verdict: the number of poses, and the machines that they belong to.
static void say_true_here(Checking *checking, const YkCheckVerdict *verdict)
{
    YkText *out = &checking->session->out;
    const char *segment = verdict->is_in_segment ? " in the segment that it is about" : "";
    if (verdict->is_too_large) {
        yk_text_format(out, "true at %z poses of this machine, not proved: it is too large for that\n", verdict->poses);
    } else if (verdict->is_false_there) {
        yk_text_format(out,
                       "true only with this file's numbers (at %z poses); with %s (SI) it is false: ", verdict->poses,
                       verdict->shown.machine ? verdict->shown.machine : "others");
        add_difference(checking, out, &verdict->shown);
    } else if (verdict->is_refuted) {
        yk_text_format(out,
                       "true only with this file's numbers (at %z poses): with others it does not hold in general "
                       "(by exact arithmetic; no example was found)\n",
                       verdict->poses);
    } else if (verdict->machines > 0 && verdict->kept) {
        yk_text_format(out,
                       "true at %z poses of this machine%s; other %s could not be tried (with other %s it is true at "
                       "%z poses of %z machines); a proof for all dimensions was not found\n",
                       verdict->poses, segment, verdict->kept, verdict->varied ? verdict->varied : "numbers",
                       verdict->machine_poses, verdict->machines);
    } else if (verdict->machines > 0) {
        yk_text_format(out,
                       "true at %z poses of this machine%s, and at %z poses of %z machines with other %s; a proof for "
                       "all dimensions was not found\n",
                       verdict->poses, segment, verdict->machine_poses, verdict->machines,
                       verdict->varied ? verdict->varied : "dimensions");
    } else {
        yk_text_format(out, "true at %z poses with this file's numbers%s; with others it could not be tried (%s)\n",
                       verdict->poses, segment, "dimensions that the file gives as `parameters:` can be");
    }
}

static void say_text(Checking *checking, const char *equation, const YkCheckVerdict *verdict, const char *why)
{
    YkText *out = &checking->session->out;
    yk_text_format(out, "%s\n  ", equation);
    switch (verdict->kind) {
    case YK_CHECK_TRUE:
        yk_text_puts(out, verdict->is_identity ? "true for all dimensions (an identity: it needs no loop)\n"
                          : checking->derivation->model->parameter_count > 0
                              ? "true for all dimensions\n"
                              : "true: proved for this machine, whose dimensions are numbers in the file\n");
        break;
    case YK_CHECK_TRUE_HERE:
        say_true_here(checking, verdict);
        break;
    case YK_CHECK_TRUE_DRIVEN:
        yk_text_format(out,
                       "true as this file's drives move the machine (at %z times); not when inputs move in any "
                       "other way\n",
                       verdict->poses);
        break;
    case YK_CHECK_FALSE:
        yk_text_puts(out, "false: ");
        add_difference(checking, out, &verdict->shown);
        if (verdict->slip) yk_text_format(out, "  %s\n", verdict->slip);
        break;
    case YK_CHECK_UNDECIDED:
        yk_text_puts(out, "undecided: no pose was found that decides it\n");
        break;
    case YK_CHECK_UNREADABLE:
        yk_text_format(out, "not understood%s%s\n", why ? ": " : "", why ? why : "");
        break;
    }
}

static void add_shown(Checking *checking, const YkCheckShown *shown)
{
    YkJson *json = &checking->json;
    const YkMechanism *mech = checking->session->mech;
    yk_json_number(json, "left", shown->left);
    yk_json_number(json, "right", shown->right);
    yk_json_object(json, "pose", YK_JSON_LINES);
    for (size_t k = 0; shown->positions && k < yk_coordinate_count(mech); k++) {
        yk_json_object(json, yk_coordinate_info(mech, k).name, YK_JSON_INLINE);
        yk_json_number(json, "position", shown->positions[k].position);
        yk_json_number(json, "velocity", shown->positions[k].velocity);
        yk_json_number(json, "acceleration", shown->positions[k].acceleration);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_other_machines(Checking *checking, const YkCheckVerdict *verdict)
{
    YkJson *json = &checking->json;
    yk_json_string(json, "other_dimensions",
                   verdict->is_false_there || verdict->is_refuted ? "false"
                   : verdict->machines > 0                        ? "true at all poses tried"
                                                                  : "not tried");
    yk_json_integer(json, "machines", (long long)verdict->machines);
    yk_json_integer(json, "machine_poses", (long long)verdict->machine_poses);
    if (verdict->varied) yk_json_string(json, "varied", verdict->varied);
    if (!verdict->is_false_there) return;
    yk_json_object(json, "false_at", YK_JSON_LINES);
    if (verdict->shown.machine) yk_json_string(json, "parameters", verdict->shown.machine);
    add_shown(checking, &verdict->shown);
    yk_json_end(json);
}

static void say_json(Checking *checking, const char *equation, const YkCheckVerdict *verdict, const char *why)
{
    YkJson *json = &checking->json;
    yk_json_object(json, NULL, YK_JSON_LINES);
    yk_json_string(json, "equation", equation);
    yk_json_string(json, "verdict", yk_check_kind_name(verdict->kind));
    if (verdict->kind != YK_CHECK_UNREADABLE) {
        yk_json_bool(json, "identity", verdict->is_identity);
        yk_json_integer(json, "poses", (long long)verdict->poses);
    }
    if (verdict->kind == YK_CHECK_UNREADABLE && why) yk_json_string(json, "message", why);
    if (verdict->kind == YK_CHECK_TRUE_HERE) add_other_machines(checking, verdict);
    if (verdict->kind == YK_CHECK_FALSE) {
        add_shown(checking, &verdict->shown);
        if (verdict->slip) yk_json_string(json, "hint", verdict->slip);
    }
    yk_json_end(json);
}

// The place of an equation: an option's value, or a line of standard input.
typedef struct Source {
    const char *name, *text;
    size_t length;
    uint32_t line;
} Source;

static void check_one(Checking *checking, const char *equation, const Source *source)
{
    YkSession *session = checking->session;
    YkProblems *problems = yk_problems_new();
    if (!problems) {
        yk_text_fail(&session->out);
        checking->exit_code = YK_EXIT_WRONG;
        return;
    }
    yk_state_copy(session->state, checking->start);
    yk_problems_set_source(problems, source->name, source->text, source->length);
    YkCheckVerdict verdict = yk_derive_check(checking->derivation, session->state, session->dynamics, equation,
                                             strlen(equation), (YkPlace){source->line, 1, 0}, problems);
    const char *why = yk_problems_count(problems) > 0 ? yk_problems_get(problems, 0)->message : NULL;
    if (checking->as_json)
        say_json(checking, equation, &verdict, why);
    else
        say_text(checking, equation, &verdict, why);
    yk_tell_problems(session, problems);
    yk_problems_free(problems);
    int exit_code = verdict.kind == YK_CHECK_UNREADABLE    ? YK_EXIT_WRONG
                    : verdict.kind <= YK_CHECK_TRUE_DRIVEN ? YK_EXIT_DONE
                                                           : YK_EXIT_NO_ANSWER;
    if (exit_code > checking->exit_code) checking->exit_code = exit_code;
}

static size_t next_equals(const char *text, size_t from)
{
    while (text[from] != '\0' && text[from] != '=') from++;
    return from;
}

// Checks a = b = c, as pages and textbooks write it: every two neighbours are an equation.
static void check_chain(Checking *checking, const char *equation, const Source *source)
{
    size_t start = 0, middle = next_equals(equation, 0);
    size_t behind = middle + strspn(equation + middle, "="), end = next_equals(equation, behind);
    if (equation[end] == '\0') {
        check_one(checking, equation, source);
        return;
    }
    while (equation[middle] != '\0') {
        start += strspn(equation + start, " ");
        size_t length = end - start;
        while (length > 0 && equation[start + length - 1] == ' ') length--;
        const char *pair = yk_arena_copy(checking->derivation->arena, equation + start, length);
        if (!pair) yk_text_fail(&checking->session->out);
        if (!pair) return;
        check_one(checking, pair, &(Source){source->name, pair, strlen(pair), 1});
        start = behind, middle = end;
        behind = middle + strspn(equation + middle, "="), end = next_equals(equation, behind);
    }
}

// Reads equations from standard input, one per line; skips empty lines and those that begin with #.
static void check_lines(Checking *checking)
{
    size_t length = 0;
    char *text = yk_derive_read_input(&length, checking->session->problems);
    if (!text) checking->exit_code = YK_EXIT_WRONG;
    Source source = {.name = "standard input", .text = text, .length = length, .line = 1};
    for (char *line = text, *end = text ? text + length : NULL; line && line < end; source.line++) {
        char *stop = memchr(line, '\n', (size_t)(end - line));
        size_t size = stop ? (size_t)(stop - line) : (size_t)(end - line);
        if (size > 0 && line[size - 1] == '\r') size--;
        const char *copy = yk_arena_copy(checking->derivation->arena, line, size);
        if (!copy) yk_text_fail(&checking->session->out);
        if (copy && copy[strspn(copy, " \t")] != '\0' && *copy != '#') check_chain(checking, copy, &source);
        line = stop ? stop + 1 : end;
    }
    free(text);
}

int yk_derive_checks(YkSession *session, YkDerivation *derivation, bool as_json)
{
    Checking checking = {
        .session = session, .derivation = derivation, .json = {.text = &session->out}, .as_json = as_json};
    const YkWords *checks = &session->request->checks;
    checking.start = yk_session_new_state(session, session->mech);
    if (!checking.start || yk_state_copy(checking.start, session->state) < 0) {
        yk_state_free(checking.start);
        yk_session_refuse_for_memory(session);
        return YK_EXIT_WRONG;
    }
    if (as_json) {
        yk_json_object(&checking.json, NULL, YK_JSON_LINES);
        yk_json_string(&checking.json, "model", yk_model_name(session->model));
        yk_json_list(&checking.json, "checks", YK_JSON_LINES);
    }
    for (size_t k = 0; k < checks->count; k++) {
        if (strcmp(checks->items[k], "-") == 0)
            check_lines(&checking);
        else
            check_chain(&checking, checks->items[k],
                        &(Source){"--check", checks->items[k], strlen(checks->items[k]), 1});
    }
    if (as_json) {
        yk_json_end(&checking.json);
        yk_json_end(&checking.json);
    }
    yk_state_free(checking.start);
    session->ran_out |= yk_derivation_ran_out(derivation);
    return yk_session_finish(session, checking.exit_code);
}
