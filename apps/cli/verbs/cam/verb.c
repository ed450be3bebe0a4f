// yoke cam: motion program, profile and forces of a cam.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/letters.h"
#include "base/names.h"
#include "session.h"
#include "verbs/cam/cam.h"
#include "write/file.h"

enum { STEPS_MAX = 1000000, STEPS = 72, LAW_NAMES_MAX = 32 };
static const YkPlace nowhere = {0};
static const double chord = 1e-5; // m
static const double degree = 0.017453292519943295;

// Finds --cam NAME, or the first cam.
static bool find_cam(YkSession *session, size_t *cam)
{
    const YkModel *model = session->model;
    const char *name = session->request->cam, *names[64];
    size_t count = yk_model_cam_count(model);
    if (count == 0) return yk_session_refuse(session, YK_CODE_NO_CAM, "%q has no `cams:`", session->request->file);
    *cam = name ? yk_model_cam_find(model, name) : 0;
    if (*cam != YK_NOT_FOUND) return true;
    yk_session_refuse(session, YK_CODE_UNKNOWN_CAM, "there is no cam %q", name);
    for (size_t i = 0; i < count && i < 64; i++) names[i] = yk_model_cam_name(model, i);
    const char *nearest = yk_nearest(name, names, count < 64 ? count : 64);
    if (nearest) yk_problem_hint(session->problems, "did you mean `%s`?", nearest);
    return false;
}

// Returns the next word of a list, up to a comma; NULL at the end.
static const char *next_word(YkArena *arena, const char **at)
{
    if (!**at) return NULL;
    size_t length = strcspn(*at, ",");
    const char *word = yk_arena_copy(arena, *at, length);
    *at += length + ((*at)[length] == ',');
    return word;
}

static bool read_limit(YkCamAnswer *answer, const char *word)
{
    YkSession *session = answer->session;
    const char *equals = strchr(word, '=');
    size_t length = equals ? (size_t)(equals - word) : strlen(word);
    bool is_pressure = length == 8 && strncmp(word, "pressure", 8) == 0;
    bool is_curvature = length == 9 && strncmp(word, "curvature", 9) == 0;
    if (!equals || (!is_pressure && !is_curvature))
        return yk_session_refuse(session, YK_CODE_CAM_LIMIT_NAME,
                                 "--limits takes pressure=ANGLE and curvature=LENGTH, not %q", word);
    double *value = is_pressure ? &answer->limits.pressure : &answer->limits.curvature;
    if (!yk_session_value(session, "--limits", is_pressure ? "pressure" : "curvature", equals + 1,
                          is_pressure ? YK_QUANTITY_ANGLE : YK_QUANTITY_LENGTH, value))
        return false;
    if (*value > 0 || (is_curvature && *value == 0)) return true;
    return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "a limit must be greater than zero, not %q", word);
}

static bool read_limits(YkCamAnswer *answer)
{
    const char *at = answer->session->request->limits, *word;
    answer->limits = yk_default_cam_limits(answer->design);
    while (at && (word = next_word(answer->session->request->arena, &at)))
        if (!read_limit(answer, word)) return false;
    return true;
}

static bool refuse_law(YkSession *session, const char *law)
{
    const char *names[LAW_NAMES_MAX];
    size_t count = 0;
    while (count < LAW_NAMES_MAX && (names[count] = yk_cam_law_name(count))) count++;
    yk_session_refuse(session, YK_CODE_CAM_UNKNOWN_LAW, "the library has no law %q", law);
    const char *nearest = yk_nearest(law, names, count);
    if (nearest) yk_problem_hint(session->problems, "did you mean `%s`?", nearest);
    return false;
}

static bool compare(YkCamAnswer *answer)
{
    YkSession *session = answer->session;
    const char *at = session->request->compare, *word;
    while (at && (word = next_word(session->request->arena, &at))) {
        YkCamOther *other = &answer->others[answer->other_count];
        if (answer->other_count == YK_CAM_LAWS_MAX)
            return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--compare takes up to 16 laws%s", "");
        if (yk_cam_law_factors(word, &other->factors) == YK_BAD_ARGUMENT) return refuse_law(session, word);
        other->law = word;
        other->design = yk_cam_design_with(answer->design, word);
        if (!other->design) return yk_session_refuse_for_memory(session);
        other->summary = yk_cam_summary(other->design);
        answer->other_count++;
    }
    return true;
}

static bool read_length(YkSession *session, const char *option, const char *text, double *value)
{
    if (!text) return true;
    if (!yk_session_value(session, option, "", text, YK_QUANTITY_LENGTH, value)) return false;
    return *value > 0 ||
           yk_session_refuse(session, YK_CODE_OPTION_VALUE, "the length must be greater than zero, not %q", text);
}

static bool check_files(YkSession *session)
{
    const char *plot = session->request->plot, *profile = session->request->profile;
    if (plot && yk_file_kind(plot) == YK_FILE_OTHER)
        return yk_session_refuse(session, YK_CODE_OUTPUT_KIND, "--plot writes .svg, .pdf or .png, not %q", plot);
    if (profile && !yk_has_ending(profile, ".svg") && !yk_has_ending(profile, ".dxf") &&
        !yk_has_ending(profile, ".csv"))
        return yk_session_refuse(session, YK_CODE_OUTPUT_KIND, "--profile writes .svg, .dxf or .csv, not %q", profile);
    return true;
}

static bool read_request(YkCamAnswer *answer)
{
    YkSession *session = answer->session;
    const YkRequest *request = session->request;
    size_t cam, fallback = request->format == YK_FORMAT_TEXT ? 0 : STEPS;
    if (!check_files(session) ||
        !yk_session_count(session, "--steps", request->steps, STEPS_MAX, fallback, &answer->steps))
        return false;
    if (!yk_session_model(session) || !find_cam(session, &cam)) return false;
    answer->design = yk_cam_design_new(session->model, cam);
    if (!answer->design) return yk_session_refuse_for_memory(session);
    answer->size = yk_cam_size(answer->design);
    answer->speed = answer->size.speed;
    answer->tolerance = chord;
    if (request->speed &&
        !yk_session_value(session, "--speed", "", request->speed, YK_QUANTITY_ANGLE_RATE, &answer->speed))
        return false;
    return read_limits(answer) && read_length(session, "--tolerance", request->chord, &answer->tolerance) &&
           read_length(session, "--cutter", request->cutter, &answer->cutter) && compare(answer);
}

static void analyse(YkCamAnswer *answer)
{
    answer->summary = yk_cam_summary(answer->design);
    if (answer->size.is_conjugate) answer->second = yk_cam_conjugate_summary(answer->design);
    answer->stroke_count = yk_cam_strokes(answer->design, answer->strokes, YK_CAM_STROKES_MAX);
    if (answer->stroke_count > YK_CAM_STROKES_MAX) answer->stroke_count = YK_CAM_STROKES_MAX;
    answer->base_status = yk_cam_smallest_base(answer->design, &answer->limits, &answer->base);
    answer->loads = yk_cam_loads(answer->design);
    answer->has_forces = answer->loads.has_mass || answer->loads.has_spring;
    if (answer->has_forces) answer->forces = yk_cam_force_summary(answer->design, answer->speed);
}

static void tell_undercut(const YkCamAnswer *answer, const char *of, const YkCamRange *ranges, size_t count)
{
    YkText words = {0};
    for (size_t i = 0; i < count && i < YK_CAM_RANGES_MAX; i++) {
        if (i > 0) yk_text_puts(&words, ", ");
        yk_add_value(answer->session, &words, ranges[i].from, YK_QUANTITY_ANGLE, YK_DIGITS);
        yk_text_puts(&words, " to ");
        yk_add_value(answer->session, &words, ranges[i].to, YK_QUANTITY_ANGLE, YK_DIGITS);
    }
    if (count > 0)
        yk_problem(answer->session->problems, YK_CODE_CAM_UNDERCUT, nowhere,
                   "cam %q: the %s is undercut at cam angles %s", answer->size.name, of, yk_text_get(&words));
    yk_text_free(&words);
}

// Warns of a cutter that is larger than a hollow's radius, which it gouges.
static void tell_cutter(const YkCamAnswer *answer)
{
    YkCamExtreme hollow = answer->summary.surface_hollow;
    YkText words = {0};
    if (!(answer->cutter > -hollow.value)) return;
    yk_add_value(answer->session, &words, -hollow.value, YK_QUANTITY_LENGTH, YK_DIGITS);
    yk_text_puts(&words, " at ");
    yk_add_value(answer->session, &words, hollow.angle, YK_QUANTITY_ANGLE, YK_DIGITS);
    yk_problem(answer->session->problems, YK_CODE_CAM_CUTTER, nowhere,
               "cam %q: the cutter is larger than the hollow's radius of %s", answer->size.name, yk_text_get(&words));
    yk_text_free(&words);
}

static void tell(const YkCamAnswer *answer)
{
    const YkCamSummary *s = &answer->summary;
    double most = answer->size.oscillates ? 35 : 30;
    tell_undercut(answer, "surface", s->undercut, s->undercut_count);
    if (answer->size.is_groove)
        tell_undercut(answer, "groove's outer wall", s->outer_undercut, s->outer_undercut_count);
    if (answer->size.is_conjugate)
        tell_undercut(answer, "second cam", answer->second.undercut, answer->second.undercut_count);
    tell_cutter(answer);
    if (fabs(s->pressure.value) > most * degree * (1 + 1e-9))
        yk_problem(answer->session->problems, YK_CODE_CAM_PRESSURE, nowhere,
                   "cam %q: the pressure angle reaches %e deg; books advise at most %d deg", answer->size.name,
                   fabs(s->pressure.value) / degree, (int)most);
    if (answer->base_status == YK_LIMIT)
        yk_problem(answer->session->problems, YK_CODE_CAM_LIMITS, nowhere, "cam %q: no base circle keeps the limits",
                   answer->size.name);
    bool is_held = answer->size.is_groove || answer->size.is_conjugate || !answer->loads.has_spring;
    if (answer->has_forces && !is_held && answer->forces.contact_low.value < 0)
        yk_problem(answer->session->problems, YK_CODE_CAM_PARTS, nowhere,
                   "cam %q: at this speed the follower leaves the cam", answer->size.name);
}

static int write_answer(YkCamAnswer *answer)
{
    YkSession *session = answer->session;
    const YkRequest *request = session->request;
    switch (request->format) {
    case YK_FORMAT_TEXT:
        yk_cam_text(answer);
        break;
    case YK_FORMAT_JSON:
        yk_cam_json(answer);
        break;
    case YK_FORMAT_CSV:
        yk_cam_csv(answer);
        break;
    }
    bool is_undercut = answer->summary.undercut_count > 0 || answer->second.undercut_count > 0;
    bool has_profile = request->profile && !is_undercut && yk_session_has_memory(session);
    // Before the answer: there is none if memory has no room for the profile.
    if (has_profile && !yk_cam_write_profile(answer, request->profile)) return YK_EXIT_WRONG;
    int exit_code = yk_session_finish(session, YK_EXIT_DONE);
    if (request->plot && exit_code == YK_EXIT_DONE && !yk_cam_plot(answer, request->plot)) exit_code = YK_EXIT_WRONG;
    if (!request->profile || !is_undercut || exit_code != YK_EXIT_DONE) return exit_code;
    yk_session_refuse(session, YK_CODE_CAM_NO_PROFILE, "cam %q has no profile: it is undercut", answer->size.name);
    return YK_EXIT_NO_ANSWER;
}

int yk_run_cam(YkSession *session)
{
    YkCamAnswer *answer = calloc(1, sizeof *answer);
    int exit_code = YK_EXIT_WRONG;
    if (!answer) {
        yk_session_refuse_for_memory(session);
        return exit_code;
    }
    answer->session = session;
    if (read_request(answer)) {
        analyse(answer);
        tell(answer);
        exit_code = write_answer(answer);
    }
    for (size_t i = 0; i < answer->other_count; i++) yk_cam_design_free(answer->others[i].design);
    yk_cam_design_free(answer->design);
    free(answer);
    return exit_code;
}
