// `yoke map --over A,B`: the regions of two freedoms in which the number of configurations is constant.
#include <string.h>
#include "picture/convert.h"
#include "ranks.h"
#include "reach.h"
#include "session.h"
#include "stop.h"
#include "verbs/map/map.h"

// --- over a point's x and y

// Returns the point if the names are POINT.x and POINT.y (in this order), or YK_NOT_FOUND.
static size_t point_of(YkSession *session, const char *first, const char *second)
{
    size_t length = strlen(first), point = YK_NOT_FOUND;
    YkText name = {0};
    bool is_pair = length > 2 && strlen(second) == length && strncmp(first, second, length - 1) == 0 &&
                   strcmp(first + length - 2, ".x") == 0 && strcmp(second + length - 2, ".y") == 0;
    if (!is_pair) return YK_NOT_FOUND;
    yk_text_add(&name, first, length - 2);
    if (name.failed) yk_session_run_out(session);
    point = yk_model_find_point(session->model, yk_text_get(&name));
    if (point == YK_NOT_FOUND && !name.failed) {
        yk_session_refuse(session, YK_CODE_NOT_A_POINT, "the machine has no point %q", yk_text_get(&name));
        yk_problem_hint(session->problems, "a point is written body.point, as in `coupler.P.x,coupler.P.y`");
    }
    yk_text_free(&name);
    return point;
}

// Compiles the machine whose point is carried, with the carriage's coordinates and those of --at as inputs.
static YkMechanism *compile_carried(const YkRegionsAnswer *answer)
{
    const YkSession *session = answer->session;
    const char **names = yk_session_alloc(session, 2 + session->hold_count, sizeof *names);
    size_t count = 2;
    if (!names) {
        yk_session_run_out(answer->session);
        return NULL;
    }
    names[0] = YK_MAP_CARRIAGE "x";
    names[1] = YK_MAP_CARRIAGE "y";
    for (size_t h = 0; h < session->hold_count; h++) {
        if (session->holds[h].order != 0) continue;
        size_t coordinate = yk_input_coordinate(session->mech, session->holds[h].input);
        names[count++] = yk_coordinate_info(session->mech, coordinate).name;
    }
    YkCompileOptions options = yk_default_compile_options();
    options.inputs = names;
    options.input_count = count;
    YkMechanism *mech = yk_mechanism_compile(answer->model, &options, session->problems);
    return mech;
}

// Puts the carried machine where the machine itself stands.
static bool stand(YkRegionsAnswer *answer, const double *at)
{
    YkSession *session = answer->session;
    YkState *state = answer->own_state = yk_state_new(answer->own_mech);
    if (!state) yk_session_run_out(session);
    if (!state || yk_state_set_progress(state, yk_stop_progress(session)) < 0 ||
        yk_state_set_time(state, 0, session->problems) < 0)
        return false;
    for (int k = 0; k < 2; k++) {
        answer->coordinate[k] =
            yk_coordinate_find(answer->own_mech, k == 0 ? YK_MAP_CARRIAGE "x" : YK_MAP_CARRIAGE "y");
        YkCoordinateInfo info = yk_coordinate_info(answer->own_mech, answer->coordinate[k]);
        yk_state_hold_input(state, (size_t)info.input, 0, at[k]);
    }
    for (size_t h = 0; h < session->hold_count; h++) {
        size_t coordinate = yk_input_coordinate(session->mech, session->holds[h].input);
        size_t own = yk_coordinate_find(answer->own_mech, yk_coordinate_info(session->mech, coordinate).name);
        int input = own == YK_NOT_FOUND ? -1 : yk_coordinate_info(answer->own_mech, own).input;
        if (session->holds[h].order == 0 && input >= 0)
            yk_state_hold_input(state, (size_t)input, 0, session->holds[h].value);
    }
    return yk_state_set_time(state, 0, session->problems) >= 0 && yk_state_assemble(state) >= 0;
}

static bool carry(YkRegionsAnswer *answer, size_t point)
{
    YkSession *session = answer->session;
    YkPointMotion motion = yk_state_point(session->state, point);
    YkLoadOptions options;
    if (!yk_session_load_options(session, false, &options)) return false;
    answer->model =
        yk_model_carry_point(session->model, point, YK_MAP_CARRIAGE, motion.position, &options, session->problems);
    answer->own_mech = answer->model ? compile_carried(answer) : NULL;
    bool good = answer->own_mech && stand(answer, motion.position);
    if (!good && yk_problems_error_count(session->problems) == 0)
        yk_session_refuse(session, YK_CODE_NO_MAP, "the machine cannot be moved by the point %q",
                          yk_model_point_name(session->model, point));
    answer->mech = answer->own_mech;
    answer->state = answer->own_state;
    return good;
}

// --- over coordinates

static bool find_coordinates(YkRegionsAnswer *answer)
{
    YkSession *session = answer->session;
    answer->mech = session->mech;
    for (int k = 0; k < 2; k++) {
        if (!yk_session_coordinate(session, answer->names[k], &answer->coordinate[k])) return false;
        YkCoordinateInfo info = yk_coordinate_info(session->mech, answer->coordinate[k]);
        answer->names[k] = info.name;
        answer->quantity[k] = yk_quantity_of(info.is_distance, 0);
        for (size_t h = 0; h < session->hold_count; h++)
            if (session->holds[h].order == 0 && (int)session->holds[h].input == info.input)
                return yk_session_refuse(session, YK_CODE_OPTION_REPEATED, "%q is mapped, so --at cannot hold it",
                                         info.name);
    }
    return true;
}

// Takes the two inputs that --at does not hold.
static void take_free_inputs(YkRegionsAnswer *answer)
{
    YkSession *session = answer->session;
    size_t found = 0;
    for (size_t k = 0; k < yk_input_count(session->mech) && found < 2; k++) {
        bool is_held = false;
        for (size_t h = 0; h < session->hold_count; h++)
            is_held |= session->holds[h].input == k && session->holds[h].order == 0;
        if (!is_held)
            answer->names[found++] = yk_coordinate_info(session->mech, yk_input_coordinate(session->mech, k)).name;
    }
}

// --- the answer

static bool draw(const YkRegionsAnswer *answer, const char *path)
{
    YkSession *session = answer->session;
    YkText picture = {0};
    YkRegionsPicture options = {{answer->names[0], answer->names[1]}, {NULL, NULL}, {1, 1}};
    for (int k = 0; k < 2; k++) {
        options.units[k] = yk_unit_of(session, answer->quantity[k]);
        options.scale[k] = yk_shown(session, 1, answer->quantity[k]);
    }
    const char *svg = yk_regions_picture(answer->regions, &options);
    bool good = svg || yk_session_refuse_for_memory(session);
    good = good && yk_convert_svg(svg, yk_file_kind(path), &picture, session->problems) &&
           yk_file_write(path, yk_text_get(&picture), picture.length, session->problems);
    yk_text_free(&picture);
    return good;
}

static bool read_tolerance(YkSession *session, double *tolerance)
{
    const char *text = session->request->tolerance;
    if (!text) return true;
    if (!yk_session_value(session, "--tol", "", text, YK_QUANTITY_NUMBER, tolerance)) return false;
    if (*tolerance >= 1e-4 && *tolerance <= 0.1) return true;
    return yk_session_refuse(session, YK_CODE_OPTION_VALUE,
                             "--tol takes a number from 0.0001 to 0.1 here, a part of the map's extent: %q", text);
}

static bool is_asked_well(YkSession *session)
{
    const YkRequest *request = session->request;
    if (request->trace.count > 0)
        return yk_session_refuse(session, YK_CODE_OPTION_REPEATED,
                                 "a map over two coordinates draws regions, without --trace %q",
                                 request->trace.items[0]);
    if (request->of)
        return yk_session_refuse(session, YK_CODE_OPTION_REPEATED,
                                 "a map over two coordinates draws regions, without --of %q", request->of);
    if (request->reach.count > 0)
        return yk_session_refuse(session, YK_CODE_OPTION_REPEATED,
                                 "--reach %s is answered by a map over one coordinate", request->reach.items[0].name);
    return true;
}

// Makes the map, on all ranks where there are several. Returns false if these cannot work together.
static bool find_regions(YkRegionsAnswer *answer, YkRegionsOptions *options)
{
    YkMapSpread *spread = yk_ranks() ? yk_map_spread(answer, options) : NULL;
    if (yk_ranks() && !spread) return false;
    answer->regions =
        yk_regions_new(answer->state, answer->coordinate[0], answer->coordinate[1], options, answer->session->problems);
    yk_map_gather(spread);
    return true;
}

static int write_answer(YkRegionsAnswer *answer)
{
    YkSession *session = answer->session;
    YkRegionsOptions options = yk_default_regions_options();
    if (!read_tolerance(session, &options.tolerance)) return YK_EXIT_WRONG;
    if (yk_ranks() && yk_ranks_rank() > 0) {
        yk_map_serve(answer);
        return YK_EXIT_DONE; // rank 0 gives the exit code of the run
    }
    if (!find_regions(answer, &options)) return YK_EXIT_WRONG;
    if (!answer->regions) return yk_ran_out(session->problems) ? YK_EXIT_WRONG : YK_EXIT_NO_ANSWER;
    if (session->request->format == YK_FORMAT_JSON)
        yk_map_regions_json(answer);
    else
        yk_map_regions_text(answer);
    int exit_code = yk_session_finish(session, YK_EXIT_DONE);
    const char *plot = session->request->plot;
    return plot && exit_code != YK_EXIT_WRONG && !draw(answer, plot) ? YK_EXIT_WRONG : exit_code;
}

static int answer_regions(YkRegionsAnswer *answer, size_t point)
{
    YkSession *session = answer->session;
    if (point == YK_NOT_FOUND && !find_coordinates(answer)) return YK_EXIT_WRONG;
    if (!yk_map_has_freedoms(session, 2)) return YK_EXIT_NO_ANSWER;
    YkStatus status = yk_session_reach(session, NULL);
    if (status < 0) {
        yk_reach_tell(session, status);
        return yk_status_exit(status);
    }
    answer->quantity[0] = point == YK_NOT_FOUND ? answer->quantity[0] : YK_QUANTITY_LENGTH;
    answer->quantity[1] = point == YK_NOT_FOUND ? answer->quantity[1] : YK_QUANTITY_LENGTH;
    answer->state = session->state;
    if (point != YK_NOT_FOUND && !carry(answer, point))
        return yk_ran_out(session->problems) ? YK_EXIT_WRONG : YK_EXIT_NO_ANSWER;
    return write_answer(answer);
}

int yk_map_regions(YkSession *session, const char *first, const char *second)
{
    YkRegionsAnswer answer = {.session = session, .names = {first, second}};
    size_t point = YK_NOT_FOUND, errors = yk_problems_error_count(session->problems);
    if (!is_asked_well(session)) return YK_EXIT_WRONG;
    if (!first) {
        take_free_inputs(&answer);
    } else if (strlen(first) > 2 && strcmp(first + strlen(first) - 2, ".x") == 0) {
        if (!yk_session_load(session, NULL)) return YK_EXIT_WRONG;
        point = point_of(session, first, second);
        if (yk_problems_error_count(session->problems) > errors) return YK_EXIT_WRONG;
    } else if (!yk_session_load_over(session, first, second)) {
        return YK_EXIT_WRONG;
    }
    if (first && !yk_session_inputs(session)) return YK_EXIT_WRONG;
    int exit_code = answer_regions(&answer, point);
    yk_regions_free(answer.regions);
    yk_state_free(answer.own_state);
    yk_mechanism_free(answer.own_mech);
    yk_model_free(answer.model);
    return exit_code;
}
