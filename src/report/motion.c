// Chooses the motion of a report: that of the machine's drives, or of its loads, or else the range of its first input.
#include <math.h>
#include "base/vec.h"
#include "report/report.h"

enum {
    TURN_STEPS = 180,
    RANGE_STEPS = 120,
    TIME_STEPS = 240,
    STEPS_MIN = 24,
    POSES_MAX = 12000,
    PERIOD_PARTS = 12,
    TURNS_MOST = 12
};
static const double full_turn = 2 * YK_PI;
static const double time_default = 5, time_least = 1e-3, time_most = 60; // s
static const double pass_default = 5, pass_least = 2.5, pass_most = 15;  // s, on a screen
static const double inset = 0.01; // of a range, at each end that is a limit: rates are unbounded there

static YkCoordinateInfo input_info(const YkReportPage *report, size_t input)
{
    return yk_coordinate_info(report->mech, yk_input_coordinate(report->mech, input));
}

// --- Drives in time

// The motion of an input's drive. If its rate is not constant, the period is that of a harmonic motion with the same
// greatest rate and acceleration, shortened for an angle until it makes few enough turns for the steps of the report.
typedef struct Course {
    bool moves, is_steady;
    double rate, period;
} Course;

// Halves a time until the input makes at most TURNS_MOST turns in it.
static double time_of_few_turns(YkState *scratch, size_t input, double start, double time)
{
    if (yk_state_set_time(scratch, start, NULL) < 0) return time;
    double from = yk_state_input(scratch, input).position;
    for (;; time *= 0.5) {
        if (time <= time_least || yk_state_set_time(scratch, start + time, NULL) < 0) return time;
        if (!(fabs(yk_state_input(scratch, input).position - from) > TURNS_MOST * full_turn)) return time;
    }
}

static Course course_of(YkReportPage *report, YkState *scratch, size_t input)
{
    enum { SAMPLES = 400 };
    Course course = {0};
    if (!input_info(report, input).has_drive) return course;
    double fastest = 0, hardest = 0, start = yk_state_time(report->start);
    yk_state_set_time(scratch, start, NULL);
    course.rate = yk_state_input(scratch, input).velocity;
    course.is_steady = true;
    for (int k = 0; k < SAMPLES; k++) {
        if (yk_state_set_time(scratch, start + 0.0317 * k, NULL) < 0) break;
        YkMotion motion = yk_state_input(scratch, input);
        fastest = fmax(fastest, fabs(motion.velocity));
        hardest = fmax(hardest, fabs(motion.acceleration));
        course.is_steady &= fabs(motion.velocity - course.rate) <= 1e-9 * fabs(course.rate) && motion.acceleration == 0;
    }
    course.moves = fastest > 0;
    course.is_steady &= course.moves;
    if (course.is_steady)
        course.period = input_info(report, input).is_distance ? 0 : full_turn / fabs(course.rate);
    else if (hardest > 0)
        course.period = full_turn * fastest / hardest;
    if (course.period > 0 && !course.is_steady && !input_info(report, input).is_distance)
        course.period = time_of_few_turns(scratch, input, start, fmin(course.period, time_most));
    return course;
}

// Returns a time after which all drives repeat, if their periods are small multiples of one; otherwise the longest.
static double common_period(const double *periods, size_t count)
{
    double longest = 0;
    for (size_t i = 0; i < count; i++) longest = fmax(longest, periods[i]);
    for (int k = 1; k <= PERIOD_PARTS; k++) {
        bool fits = true;
        for (size_t i = 0; i < count; i++) {
            double turns = k * longest / periods[i];
            fits &= fabs(turns - rint(turns)) < 1e-9 * turns;
        }
        if (fits) return k * longest;
    }
    return longest;
}

static double bounded(double time)
{
    return fmin(fmax(time, time_least), time_most);
}

static double time_of_drives(YkReportPage *report, YkState *scratch)
{
    enum { PERIODS_MAX = 16 };
    double periods[PERIODS_MAX];
    size_t count = 0;
    for (size_t i = 0; i < yk_input_count(report->mech) && count < PERIODS_MAX; i++) {
        Course course = course_of(report, scratch, i);
        if (course.period > 0) periods[count++] = course.period;
    }
    return count > 0 ? common_period(periods, count) : 0;
}

// --- Under loads

// Returns the time of a few swings: of a pendulum as long as the machine is large, of its mass on its softest spring,
// or of one turn at the rates of its start and drives.
static double time_of_loads(YkReportPage *report, YkState *scratch)
{
    const YkModel *model = report->model;
    double swing = time_of_drives(report, scratch), size = yk_mechanism_size(report->mech);
    double gravity = yk_norm(model->gravity), mass = yk_model_loads(model).mass;
    if (gravity > 0) swing = fmax(swing, full_turn * sqrt(size / gravity));
    for (size_t k = 0; k < model->spring_count; k++) {
        int32_t along = model->springs[k].coordinate;
        bool is_angle = along != YK_NONE && !model->coordinates[along].is_distance;
        double stiffness = model->springs[k].stiffness * (is_angle ? 1 / (size * size) : 1);
        if (stiffness > 0 && mass > 0) swing = fmax(swing, full_turn * sqrt(mass / stiffness));
    }
    for (size_t i = 0; i < yk_input_count(report->mech) && swing == 0; i++) {
        double rate = fabs(yk_state_input(report->start, i).velocity);
        if (rate > 0) swing = (input_info(report, i).is_distance ? size : full_turn) / rate;
    }
    return swing > 0 ? bounded(3 * swing) : time_default;
}

static bool has_free_input(const YkReportPage *report)
{
    for (size_t i = 0; report->dynamics && i < yk_input_count(report->mech); i++)
        if (!yk_dynamics_is_prescribed(report->dynamics, i)) return true;
    return false;
}

// --- One input

static void find_ranges(YkReportPage *report, YkState *scratch)
{
    if (yk_input_count(report->mech) != 1) return;
    if (yk_state_copy(scratch, report->start) < 0) return;
    size_t count =
        yk_closing_ranges(scratch, yk_input_coordinate(report->mech, 0), report->ranges, YK_REPORT_RANGES_MAX);
    report->failed |= count == (size_t)-1;
    if (report->failed) return;
    report->range_count = count < YK_REPORT_RANGES_MAX ? count : YK_REPORT_RANGES_MAX;
}

static bool is_full_turn(YkRange range)
{
    return range.to - range.from > full_turn - 1e-9;
}

// Chooses the range of the first input around the present pose; with several inputs a turn, or as far as it goes.
static void choose_range(YkReportPage *report, Course course)
{
    YkReportMotion *motion = &report->motion;
    double now = yk_state_input(report->start, 0).position, size = yk_mechanism_size(report->mech);
    bool is_distance = input_info(report, 0).is_distance;
    YkRange range = {now - 0.5 * full_turn, now + 0.5 * full_turn};
    if (is_distance) range = (YkRange){now - 0.5 * size, now + 0.5 * size};
    bool is_whole = !is_distance;
    for (size_t k = 0; k < report->range_count; k++) {
        YkRange own = report->ranges[k];
        if (now < own.from - 1e-9 || now > own.to + 1e-9) continue;
        is_whole = !is_distance && is_full_turn(own);
        if (!is_whole) {
            bool is_low = !is_distance || own.from > range.from, is_high = !is_distance || own.to < range.to;
            double step = inset * (own.to - own.from);
            if (is_low) range.from = own.from + step;
            if (is_high) range.to = own.to - step;
            motion->is_cut = is_low || is_high;
        }
    }
    double way = course.moves && course.rate < 0 ? -1 : 1;
    motion->kind = is_whole ? YK_REPORT_TURN : YK_REPORT_RANGE;
    motion->coordinate = (int)yk_input_coordinate(report->mech, 0);
    motion->steps = is_whole ? TURN_STEPS : RANGE_STEPS;
    motion->from = is_whole ? now : way > 0 ? range.from : range.to;
    motion->to = is_whole ? now + way * full_turn : way > 0 ? range.to : range.from;
    if (course.is_steady) motion->duration = fabs((motion->to - motion->from) / course.rate);
}

static void choose(YkReportPage *report, YkState *scratch)
{
    YkReportMotion *motion = &report->motion;
    const YkReportOptions *options = &report->options;
    size_t inputs = yk_input_count(report->mech);
    if (inputs == 0) return;
    if (options->has_range) {
        bool is_turn = options->coordinate >= 0 && fabs(fabs(options->to - options->from) - full_turn) < 1e-9;
        is_turn = is_turn && !yk_coordinate_info(report->mech, (size_t)options->coordinate).is_distance;
        motion->kind = options->coordinate < 0 ? YK_REPORT_TIME : is_turn ? YK_REPORT_TURN : YK_REPORT_RANGE;
        motion->coordinate = options->coordinate;
        motion->from = options->from;
        motion->to = options->to;
        motion->steps = options->coordinate < 0 ? TIME_STEPS : TURN_STEPS;
        if (options->coordinate < 0) motion->duration = fabs(options->to - options->from);
        return;
    }
    find_ranges(report, scratch);
    Course first = course_of(report, scratch, 0);
    double period = time_of_drives(report, scratch);
    if (has_free_input(report)) {
        motion->kind = YK_REPORT_SIMULATION;
        motion->duration = options->duration > 0 ? options->duration : time_of_loads(report, scratch);
    } else if (inputs == 1 && options->duration == 0 && (first.is_steady || !first.moves)) {
        choose_range(report, first);
        return;
    } else if (period > 0 || options->duration > 0) {
        motion->kind = YK_REPORT_TIME;
        motion->duration = options->duration > 0 ? options->duration : bounded(period);
    } else {
        choose_range(report, first);
        return;
    }
    motion->steps = TIME_STEPS;
    motion->from = yk_state_time(report->start);
    motion->to = motion->from + motion->duration;
}

// Returns the real duration, within limits that an eye can follow.
double yk_report_seconds(const YkReportPage *report)
{
    double known = report->motion.duration;
    return known > 0 ? fmin(fmax(known, pass_least), pass_most) : pass_default;
}

bool yk_report_goes_back(const YkReportPage *report)
{
    return report->motion.kind == YK_REPORT_RANGE;
}

void yk_report_choose_motion(YkReportPage *report)
{
    YkState *scratch = yk_report_new_state(report);
    if (!scratch) return;
    choose(report, scratch);
    yk_state_free(scratch);
    size_t most = POSES_MAX / report->model->body_count;
    if (report->motion.steps > most) report->motion.steps = most > STEPS_MIN ? most : STEPS_MIN;
    if (report->options.pose_rate > 0)
        report->motion.steps = (size_t)ceil(yk_report_seconds(report) * report->options.pose_rate);
    if (report->options.steps > 0) report->motion.steps = report->options.steps;
}
