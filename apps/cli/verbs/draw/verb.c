// yoke draw: the machine as a picture, at one pose or many.
#include <string.h>
#include "answer.h"
#include "certify.h"
#include "picture/convert.h"
#include "picture/movie.h"
#include "range.h"
#include "reach.h"
#include "stop.h"
#include "verbs/draw/polygons.h"
#include "verbs/solve/solve.h"
#include "write/file.h"

enum { POSES_MAX = 1000, TRACE_STEPS = 720 };
static const double full_turn = 6.28318530717958647692;

typedef struct Drawer {
    YkSession *session;
    YkOver over;
    bool has_range; // over.from, over.to are set
    size_t poses;
    size_t *points;      // traced
    size_t centrodes[2]; // the bodies of --centrodes
    YkDrawing *drawing;
} Drawer;

static bool find_points(Drawer *drawer)
{
    const YkWords *trace = &drawer->session->request->trace;
    drawer->points = yk_session_alloc(drawer->session, trace->count + 1, sizeof *drawer->points);
    if (!drawer->points) return yk_session_refuse_for_memory(drawer->session);
    return yk_session_points(drawer->session, trace, drawer->points);
}

// Without --over a path is drawn over the closing range around the present pose.
static void choose_range(Drawer *drawer)
{
    YkState *state = drawer->session->state;
    YkRange ranges[32];
    if (drawer->has_range || yk_input_count(drawer->session->mech) != 1) return;
    size_t coordinate = yk_input_coordinate(drawer->session->mech, 0);
    double now = yk_state_input(state, 0).position;
    size_t count = yk_closing_ranges(state, coordinate, ranges, 32);
    if (count == YK_NOT_FOUND) yk_text_fail(&drawer->session->out);
    for (size_t i = 0; i < count && i < 32 && count != YK_NOT_FOUND; i++) {
        if (now < ranges[i].from - 1e-9 || now > ranges[i].to + 1e-9) continue;
        drawer->over.coordinate = (int)coordinate;
        drawer->over.from = ranges[i].from;
        drawer->over.to = ranges[i].to;
        drawer->has_range = true;
    }
}

// How the poses of a walk through the range are drawn.
typedef struct Walk {
    Drawer *drawer;
    size_t seen, stride, most, added; // every stride-th pose is drawn, faint; up to `most`
    YkStatus status;
} Walk;

static void draw_pose(void *context, const YkState *state)
{
    Walk *walk = context;
    YkDrawing *drawing = walk->drawer->drawing;
    bool is_faint = walk->stride > 0 && walk->seen % walk->stride == 0 && walk->added < walk->most;
    walk->seen++;
    if (walk->status == YK_OK) walk->status = yk_drawing_trace(drawing, state);
    if (!is_faint || walk->status != YK_OK) return;
    walk->status = yk_drawing_pose(drawing, state);
    walk->added++;
}

static double last_limit(const YkSweep *sweep, double fallback)
{
    for (size_t k = yk_sweep_event_count(sweep); k-- > 0;)
        if (yk_sweep_event(sweep, k).kind == YK_EVENT_LIMIT) return yk_sweep_event(sweep, k).at;
    return fallback;
}

static void tell_clipped(Drawer *drawer, double from, double to)
{
    YkSession *session = drawer->session;
    YkText part = {0};
    yk_add_value(session, &part, from, drawer->over.quantity, YK_DIGITS);
    yk_text_puts(&part, " to ");
    yk_add_value(session, &part, to, drawer->over.quantity, YK_DIGITS);
    yk_problem(session->problems, YK_CODE_RANGE_CLIPPED, (YkPlace){0}, "%s can only go from %s: limits lie beyond",
               drawer->over.name ? drawer->over.name : "the range", yk_text_get(&part));
    yk_text_free(&part);
}

// Walks the range once from the present state, verified as in a sweep; adds the traced points' positions and, at equal
// distances, faint poses. Parts beyond a limit are left out, and reported.
static YkStatus walk_range(Drawer *drawer, YkState *state)
{
    YkSweepOptions options = yk_default_sweep_options();
    double span = drawer->over.to - drawer->over.from;
    bool is_turn = drawer->over.quantity == YK_QUANTITY_ANGLE && span > full_turn - 1e-9 && span < full_turn + 1e-9;
    // Over a turn the last pose is the first.
    size_t gaps = drawer->poses > 1 && !is_turn ? drawer->poses - 1 : drawer->poses;
    Walk walk = {.drawer = drawer, .most = drawer->poses, .stride = gaps > 0 ? (TRACE_STEPS + gaps - 1) / gaps : 0};
    options.coordinate = drawer->over.coordinate;
    options.from = drawer->over.from;
    options.to = drawer->over.to;
    options.steps = gaps > 0 ? walk.stride * gaps : TRACE_STEPS;
    options.visit = draw_pose;
    options.context = &walk;
    YkStatus status = YK_LIMIT;
    for (int attempt = 0; attempt < 2 && status == YK_LIMIT && walk.seen == 0; attempt++) {
        YkSweep *sweep = yk_sweep_run(state, &options, NULL, 0, drawer->session->problems);
        if (!sweep) return YK_NO_MEMORY;
        status = yk_sweep_status(sweep);
        double end = last_limit(sweep, options.from);
        if (walk.seen == 0)
            options.from = end; // FROM is out of reach: starts as near to it as the machine gets
        else
            options.to = status == YK_LIMIT ? end : options.to;
        yk_sweep_free(sweep);
    }
    if (options.from != drawer->over.from || options.to != drawer->over.to)
        tell_clipped(drawer, options.from, options.to);
    return walk.status;
}

static YkStatus gather(Drawer *drawer)
{
    YkSession *session = drawer->session;
    YkStatus status = YK_OK;
    if (session->request->trace.count > 0) choose_range(drawer);
    if (drawer->has_range) {
        YkState *moving = yk_session_new_state(session, session->mech);
        if (!moving) return YK_NO_MEMORY;
        status = yk_state_copy(moving, session->state);
        yk_certify_state(session, moving);
        if (status >= 0) status = walk_range(drawer, moving);
        yk_state_free(moving);
    }
    return status < 0 ? status : yk_drawing_pose(drawer->drawing, session->state);
}

// Adds the instant centres of the pose. Returns false with a problem if there are none.
static bool add_centers(Drawer *drawer)
{
    YkSession *session = drawer->session;
    if (!session->request->centers) return true;
    YkCenters *centers = yk_centers_new(session->state, session->problems);
    bool good = centers && yk_drawing_centers(drawer->drawing, centers) == YK_OK;
    if (centers && !good) yk_session_refuse_for_memory(session);
    yk_centers_free(centers);
    return good;
}

// Finds the bodies of --centrodes: two with a comma between them, or one and the ground.
static bool find_bodies(YkSession *session, size_t body[2])
{
    const char *words = session->request->centrodes, *comma = strchr(words, ',');
    YkText names[2] = {{0}, {0}};
    bool good = true;
    yk_text_puts(&names[0], comma ? "" : "ground");
    if (comma) yk_text_add(&names[0], words, (size_t)(comma - words));
    yk_text_puts(&names[1], comma ? comma + 1 : words);
    for (size_t k = 0; k < 2 && good; k++) {
        body[k] = yk_model_find_body(session->model, yk_text_get(&names[k]));
        if (body[k] != YK_NOT_FOUND) continue;
        good = yk_session_refuse(session, YK_CODE_UNKNOWN_BODY, "the machine has no body %q", yk_text_get(&names[k]));
        yk_problem_hint(session->problems,
                        "--centrodes takes two bodies, as in `crank,rocker`, or one, against the ground");
    }
    session->out.failed |= names[0].failed || names[1].failed;
    for (size_t k = 0; k < 2; k++) yk_text_free(&names[k]);
    return good;
}

static bool add_centrodes(Drawer *drawer)
{
    enum { STEPS = 720 };
    YkSession *session = drawer->session;
    if (!session->request->centrodes) return true;
    YkCentrodes *centrodes =
        yk_centrodes_new(session->state, drawer->centrodes[0], drawer->centrodes[1], STEPS, session->problems);
    bool good = centrodes && yk_drawing_centrodes(drawer->drawing, centrodes) == YK_OK;
    if (centrodes && !good) yk_session_refuse_for_memory(session);
    yk_centrodes_free(centrodes);
    return good;
}

static bool draw(Drawer *drawer, YkFileKind kind)
{
    if (drawer->session->request->polygon) return yk_draw_polygon(drawer->session, kind);
    YkSession *session = drawer->session;
    YkDrawOptions options = yk_default_draw_options();
    options.labels = !session->request->no_labels;
    options.traced_points = drawer->points;
    options.traced_count = session->request->trace.count;
    drawer->drawing = yk_drawing_new(session->mech, &options);
    YkStatus status = drawer->drawing ? gather(drawer) : YK_NO_MEMORY;
    if (status == YK_OK && (!add_centers(drawer) || !add_centrodes(drawer))) return false;
    const char *svg = status == YK_OK ? yk_drawing_svg(drawer->drawing) : NULL;
    if (!svg) {
        bool is_memory = status == YK_OK || status == YK_NO_MEMORY;
        return yk_session_refuse(session, is_memory ? YK_CODE_OUT_OF_MEMORY : YK_CODE_OUTPUT_FAILED,
                                 is_memory ? "out of memory%s" : "the pose cannot be drawn%s", "");
    }
    return yk_convert_svg(svg, kind, &session->out, session->problems);
}

// Reads the kind of picture; standard output takes SVG.
static bool read_kind(YkSession *session, YkFileKind *kind)
{
    const char *path = session->request->output;
    *kind = path && strcmp(path, "-") != 0 ? yk_file_kind(path) : YK_FILE_SVG;
    const char *movie = session->request->animate;
    if (movie && yk_movie_kind(movie) == YK_MOVIE_OTHER)
        return yk_session_refuse(session, YK_CODE_OUTPUT_KIND, "--animate writes .svg, .gif, .mp4 or .webm, not %q",
                                 movie);
    if (movie && path)
        return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--animate names its own file: leave out -o %s", path);
    if (*kind != YK_FILE_OTHER) return true;
    yk_session_refuse(session, YK_CODE_OUTPUT_KIND, "-o writes .svg, .pdf or .png, not %q", path);
    return false;
}

// --- --animate: the motion as a file that moves

static bool write_movie(Drawer *drawer, YkReportPage *motion, YkMovieKind kind)
{
    YkSession *session = drawer->session;
    YkText movie = {0};
    YkDrawing *drawing = yk_report_drawing(motion);
    bool good = drawing && yk_movie_write(drawing, kind, yk_report_seconds(motion), yk_report_goes_back(motion), &movie,
                                          session->problems);
    good = good && yk_session_has_memory(session) &&
           yk_file_write(session->request->animate, yk_text_get(&movie), movie.length, session->problems);
    if (!drawing) yk_session_refuse(session, YK_CODE_OUTPUT_FAILED, "the motion cannot be drawn%s", "");
    yk_text_free(&movie);
    return good;
}

static bool movie_options(Drawer *drawer, YkMovieKind kind, YkReportOptions *options)
{
    const YkRequest *request = drawer->session->request;
    *options = yk_default_report_options();
    options->pose_rate = yk_movie_rate(kind);
    options->no_labels = request->no_labels;
    options->traced_points = drawer->points;
    options->traced_count = request->trace.count;
    options->has_range = drawer->has_range;
    options->coordinate = drawer->has_range ? drawer->over.coordinate : -1;
    options->from = drawer->over.from;
    options->to = drawer->over.to;
    if (!yk_session_count(drawer->session, "--steps", request->steps, POSES_MAX, 0, &options->steps)) return false;
    if (!request->to) return true;
    if (!yk_session_value(drawer->session, "--to", "", request->to, YK_QUANTITY_TIME, &options->duration)) return false;
    return options->duration > 0 || yk_session_refuse(drawer->session, YK_CODE_OPTION_VALUE,
                                                      "--to %s must be later than the start", request->to);
}

static int animate(Drawer *drawer)
{
    YkSession *session = drawer->session;
    YkMovieKind kind = yk_movie_kind(session->request->animate);
    YkReportOptions options;
    int exit_code = YK_EXIT_WRONG;
    if (!movie_options(drawer, kind, &options)) return exit_code;
    YkStatus reached = yk_session_reach(session, NULL);
    if (reached < 0) {
        yk_reach_tell(session, reached);
        return yk_status_exit(reached);
    }
    YkReportPage *motion = yk_report_new(session->state, &options, session->problems);
    YkStatus status = motion ? yk_report_status(motion) : YK_NO_MEMORY;
    if (motion) yk_tell_status(session, status, yk_report_message(motion));
    yk_certify_warn(session);
    if (status >= 0) exit_code = write_movie(drawer, motion, kind) ? YK_EXIT_DONE : YK_EXIT_WRONG;
    if (status < 0 && motion) exit_code = yk_status_exit(status);
    yk_report_free(motion);
    return exit_code;
}

static bool prepare(Drawer *drawer)
{
    YkSession *session = drawer->session;
    const YkRequest *request = session->request;
    if (request->poses && !request->over) {
        yk_session_refuse(session, YK_CODE_OPTION_MISSING, "--poses needs --over NAME=FROM:TO%s", "");
        yk_problem_hint(session->problems, "as in --over theta1=0:360deg --poses 12");
        return false;
    }
    if (request->to && !request->animate)
        return yk_session_refuse(session, YK_CODE_OPTION_MISSING, "--to %s needs --animate FILE", request->to);
    if (request->steps && !request->animate)
        return yk_session_refuse(session, YK_CODE_OPTION_MISSING, "--steps %s needs --animate FILE", request->steps);
    YkPolygonKind kind;
    if (!yk_polygon_read(drawer->session, &kind)) return false;
    if (request->animate && (request->polygon || request->centers || request->centrodes))
        return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--animate draws no %s",
                                 request->polygon   ? "polygon"
                                 : request->centers ? "instant centres"
                                                    : "centrodes");
    if (request->polygon && (request->over || request->trace.count > 0 || request->centers || request->centrodes))
        return yk_session_refuse(
            session, YK_CODE_OPTION_VALUE,
            "--polygon is a picture of its own: leave out --over, --trace, --centers and --centrodes%s", "");
    drawer->has_range = request->over != NULL;
    if (request->over && !yk_over_split(session, request->over, &drawer->over)) return false;
    if (!yk_session_count(session, "--poses", request->poses, POSES_MAX, 0, &drawer->poses)) return false;
    const char *swept = request->over && strcmp(drawer->over.name, "t") != 0 ? drawer->over.name : NULL;
    if (!yk_session_load(session, swept) || !yk_session_inputs(session) || !yk_certify_begin(session)) return false;
    if (request->centrodes && !find_bodies(session, drawer->centrodes)) return false;
    if (request->polygon && !yk_session_forces(session, false)) return false; // free inputs accelerate as loads say
    if (yk_wants_force_polygons(session) && !yk_session_has_forces(session)) return false;
    return (!request->over || yk_over_read(session, &drawer->over)) && find_points(drawer);
}

int yk_run_draw(YkSession *session)
{
    Drawer drawer = {.session = session};
    YkFileKind kind = YK_FILE_SVG;
    int exit_code = YK_EXIT_WRONG;
    bool good = read_kind(session, &kind) && prepare(&drawer);
    if (good && session->request->animate) {
        exit_code = animate(&drawer);
    } else if (good) {
        YkStatus status = yk_session_reach(session, NULL);
        yk_reach_tell(session, status);
        exit_code = yk_status_exit(status);
        bool is_drawn = status >= 0 && draw(&drawer, kind);
        yk_certify_warn(session);
        if (is_drawn) exit_code = yk_session_finish(session, exit_code);
        if (status >= 0 && !is_drawn) exit_code = yk_lacks_construction(session) ? YK_EXIT_NO_ANSWER : YK_EXIT_WRONG;
    }
    yk_drawing_free(drawer.drawing);
    return exit_code;
}
