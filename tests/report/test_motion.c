// The motion that a report shows: its choice, and that its rows are the engine's.
#include "report/page.h"

static void check_kind(const char *name, YkReportMotionKind kind)
{
    Page page = open_page(name, NULL);
    if (page.report->motion.kind != kind) fail_msg("%s: kind %d", name, (int)page.report->motion.kind);
    if (kind != YK_REPORT_STILL) assert_true(page.report->row_count > 20);
    assert_int_equal(page.report->posed, page.report->row_count);
    close_page(&page);
}

static void every_kind_of_machine_has_its_motion(void **state)
{
    (void)state;
    check_kind("gas-engine", YK_REPORT_TURN);   // one steady drive, turns through
    check_kind("non-grashof", YK_REPORT_RANGE); // one steady drive, limits
    check_kind("five-bar", YK_REPORT_TIME);     // two drives
    check_kind("double-pendulum", YK_REPORT_SIMULATION);
    check_kind("shaking-table", YK_REPORT_SIMULATION); // a drive and a free body
    check_kind("epicyclic", YK_REPORT_TIME);
    check_kind("cep-cam", YK_REPORT_TURN);
}

// A row's values and pose are those that the engine finds at the same input by itself.
static void rows_are_the_engines(void **state)
{
    (void)state;
    Page page = open_page("quick-return", NULL);
    YkReportPage *report = page.report;
    assert_true(yk_state_assemble(page.state) >= 0);
    for (size_t row = 0; row < report->row_count; row += 7) {
        YkMotion motion = yk_state_input(page.state, 0);
        motion.position = report->at[row];
        yk_state_set_input(page.state, 0, motion);
        assert_true(yk_state_solve(page.state) >= 0);
        for (size_t c = 0; c < report->column_count; c++) {
            double own = yk_state_channel(page.state, report->columns[c].channel),
                   shown = yk_report_value(report, row, c);
            if (report->columns[c].channel.quantity == YK_QUANTITY_ANGLE)
                shown += remainder(own - shown, 2 * YK_PI) - (own - shown);
            CHECK_NEAR(shown, own, 1e-8 * (1 + fabs(own)));
        }
        const YkFrame *frames = yk_drawing_frames(report->drawing, row);
        for (size_t p = 0; p < report->model->point_count; p++) {
            YkVec at = yk_frame_apply(frames[report->model->points[p].body], report->model->points[p].at);
            YkPointMotion point = yk_state_point(page.state, p);
            CHECK_NEAR(at.x, point.position[0], 1e-8);
            CHECK_NEAR(at.y, point.position[1], 1e-8);
        }
    }
    close_page(&page);
}

static void a_range_stays_within_the_limits_and_near_them(void **state)
{
    (void)state;
    Page page = open_page("non-grashof", NULL);
    const YkReportMotion *motion = &page.report->motion;
    assert_int_equal(page.report->range_count, 1);
    YkRange range = page.report->ranges[0];
    double low = fmin(motion->from, motion->to), high = fmax(motion->from, motion->to);
    assert_true(low > range.from && high < range.to);
    assert_true(high - low > 0.97 * (range.to - range.from));
    assert_int_equal(page.report->motion_status, YK_OK);
    close_page(&page);
}

// A double rocker whose input has two ranges, apart: the page shows the one in which it stands.
static void of_two_ranges_the_one_of_the_start_is_shown(void **state)
{
    (void)state;
    for (int way = -1; way <= 1; way += 2) {
        char text[900];
        snprintf(text, sizeof text,
                 "bodies: {ground: {points: {O: [0, 0], C: [100 mm, 0]}}, crank: {points: {O: [0, 0], A: [80 mm, 0]}}, "
                 "coupler: {points: {A: [0, 0], B: [20 mm, 0]}}, rocker: {points: {C: [0, 0], B: [90 mm, 0]}}}\n"
                 "joints: {O: {pin: [ground, crank], angle: theta}, A: {pin: [crank, coupler], angle: phi}, "
                 "C: {pin: [ground, rocker], angle: psi}, B: {pin: [coupler, rocker]}}\n"
                 "drives: {theta: %d deg + 1 rad/s * t}\nstart: {phi: 0, psi: %d deg}\n",
                 way * 60, way * 100);
        Page page = open_text(text, NULL);
        const YkReportMotion *motion = &page.report->motion;
        double low = fmin(motion->from, motion->to), high = fmax(motion->from, motion->to), now = way * YK_PI / 3;
        assert_int_equal(motion->kind, YK_REPORT_RANGE);
        assert_int_equal(page.report->range_count, 2);
        assert_true(motion->is_cut && low < now && now < high);
        for (size_t k = 0; k < 2; k++) {
            YkRange range = page.report->ranges[k];
            bool is_own = range.from < now && now < range.to;
            assert_true(is_own ? low > range.from && high < range.to && high - low > 0.97 * (range.to - range.from)
                               : high < range.from || low > range.to);
        }
        CHECK_NEAR(motion->duration, high - low, 1e-12); // at 1 rad/s
        assert_int_equal(page.report->motion_status, YK_OK);
        close_page(&page);
    }
}

// Without loads nothing moves by itself: the first of two free inputs goes once round, at no rate.
static void without_loads_the_first_input_is_turned(void **state)
{
    (void)state;
    Page page = open_text("bodies: {ground: {points: {O: [0, 0]}}, one: {points: {O: [0, 0], A: [1, 0]}}, "
                          "two: {points: {A: [0, 0], B: [1, 0]}}}\n"
                          "joints: {O: {pin: [ground, one], angle: p}, A: {pin: [one, two], angle: q}}\n"
                          "start: {p: 0.3, q: 1}\n",
                          NULL);
    const YkReportMotion *motion = &page.report->motion;
    assert_int_equal(motion->kind, YK_REPORT_TURN);
    assert_int_equal(motion->coordinate, yk_coordinate_find(page.mech, "p"));
    CHECK_NEAR(motion->from, 0.3, 1e-15);
    CHECK_NEAR(motion->to - motion->from, 2 * YK_PI, 1e-12);
    CHECK_NEAR(motion->duration, 0, 0);
    close_page(&page);
}

// What has a path moves, and no two of them go together from the start on.
static void paths_are_those_of_points_that_move_apart(void **state)
{
    (void)state;
    static const char *const names[] = {"four-bar", "quick-return", "gas-engine", "hoeken", "peaucellier"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        Page page = open_page(names[n], NULL);
        const YkReportPage *report = page.report;
        assert_true(report->traced_count > 0 && report->traced_shown > 0 &&
                    report->traced_shown <= report->traced_count);
        for (size_t k = 0; k < report->traced_count; k++) {
            YkPointMotion own = yk_state_point(report->start, report->traced[k]);
            assert_true(report->model->points[report->traced[k]].body != 0);
            for (size_t i = 0; i < k; i++) {
                YkPointMotion other = yk_state_point(report->start, report->traced[i]);
                assert_true(hypot(own.position[0] - other.position[0], own.position[1] - other.position[1]) > 1e-9);
            }
        }
        for (size_t i = 0; i < report->model->point_count;
             i++) { // every place of a moving body that is not ground has one
            YkPointMotion own = yk_state_point(report->start, i);
            bool is_known = report->model->points[i].body == 0;
            for (size_t k = 0; k < report->model->point_count + report->traced_count; k++) {
                bool is_point = k < report->model->point_count;
                size_t other = is_point ? k : report->traced[k - report->model->point_count];
                YkPointMotion there = yk_state_point(report->start, other);
                if (is_point && report->model->points[k].body != 0) continue;
                is_known |= hypot(own.position[0] - there.position[0], own.position[1] - there.position[1]) < 1e-9;
            }
            assert_true(is_known || report->traced_count >= 16);
        }
        close_page(&page);
    }
}

// The peak of a column is its value there, as large as in any row, and no larger one is near it; forwards and back.
static void peaks_are_the_largest_around(void **state)
{
    (void)state;
    static const char *const names[] = {"gas-engine", "quick-return"};
    size_t tried = 0;
    for (int n = 0; n < 4; n++) {
        YkReportOptions options = yk_default_report_options();
        options.has_range = n >= 2;
        options.coordinate = 0;
        options.from = 5;
        options.to = 0.5;
        options.steps = 40;
        Page page = open_page(names[n % 2], &options);
        YkReportPage *report = page.report;
        YkState *at = yk_state_new(page.mech);
        assert_true(yk_state_copy(at, report->start) >= 0);
        for (size_t c = 0; c < report->column_count; c++) {
            const YkReportColumn *column = &report->columns[c];
            if (column->role != YK_ROLE_COORDINATE && column->role != YK_ROLE_TRANSMISSION) continue;
            if (column->role == YK_ROLE_COORDINATE && column->channel.order == 0 && column->of == 0)
                continue; // the input
            bool is_least = column->role == YK_ROLE_TRANSMISSION;
            YkPeak peak = is_least ? yk_report_least(report, c) : yk_report_peak(report, c);
            double low = fmin(report->motion.from, report->motion.to),
                   high = fmax(report->motion.from, report->motion.to);
            double size = 0;
            if (isnan(peak.value)) continue; // no rate is known
            assert_true(peak.at >= low - 1e-12 && peak.at <= high + 1e-12);
            for (size_t row = 0; row < report->row_count; row++) {
                double value = yk_report_value(report, row, c);
                assert_true(is_least ? value >= peak.value : fabs(value) <= fabs(peak.value));
                size = fmax(size, fabs(value));
            }
            for (int off = -1; off <= 1; off++) {
                double place = peak.at + 1e-3 * off;
                if (place < low || place > high || size == 0) continue;
                YkMotion input = yk_state_input(report->start, 0);
                input.position = place;
                yk_state_set_input(at, 0, input);
                assert_true(yk_state_solve(at) >= 0);
                double value = yk_state_channel(at, column->channel);
                if (column->channel.quantity == YK_QUANTITY_ANGLE && !is_least)
                    value += 2 * YK_PI * rint((peak.value - value) / (2 * YK_PI));
                if (off == 0) CHECK_NEAR(value, peak.value, 1e-8 * size);
                if (off != 0)
                    assert_true(is_least ? value > peak.value - 1e-9 * size
                                         : fabs(value) < fabs(peak.value) + 1e-9 * size);
            }
            tried++;
        }
        yk_state_free(at);
        close_page(&page);
    }
    assert_true(tried > 20);
}

static void two_drives_run_until_both_come_round(void **state)
{
    (void)state;
    Page page = open_page("epicyclic", NULL);
    YkState *moved = yk_state_new(page.mech);
    assert_non_null(moved);
    assert_true(yk_state_set_time(moved, page.report->motion.duration, NULL) >= 0);
    for (size_t i = 0; i < yk_input_count(page.mech); i++) {
        double turned = yk_state_input(moved, i).position - yk_state_input(page.state, i).position;
        CHECK_NEAR(remainder(turned, 2 * YK_PI), 0, 1e-9);
    }
    yk_state_free(moved);
    close_page(&page);
}

// A torque spins the crank ever faster: the time that is shown is short enough for its rows.
static void a_simulation_is_not_too_fast_for_its_rows(void **state)
{
    (void)state;
    Page page = open_page("toggle", NULL);
    int column = yk_report_column(page.report, YK_ROLE_COORDINATE, 0, 0);
    assert_true(column >= 0);
    for (size_t row = 1; row < page.report->row_count; row++)
        assert_true(fabs(yk_report_value(page.report, row, (size_t)column) -
                         yk_report_value(page.report, row - 1, (size_t)column)) < 0.36);
    close_page(&page);
}

// A drive that speeds up without end, and has no period: its rows still follow the turns.
static void a_drive_that_speeds_up_is_shown_for_a_few_turns(void **state)
{
    (void)state;
    Page page = open_page("planetary-gear", NULL);
    int column = yk_report_column(page.report, YK_ROLE_COORDINATE, 0, 0);
    assert_int_equal(page.report->motion.kind, YK_REPORT_TIME);
    assert_true(column >= 0 && page.report->row_count > 100);
    for (size_t row = 1; row < page.report->row_count; row++)
        assert_true(fabs(yk_report_value(page.report, row, (size_t)column) -
                         yk_report_value(page.report, row - 1, (size_t)column)) < 0.25 * YK_PI);
    double turned = yk_report_value(page.report, page.report->row_count - 1, (size_t)column) -
                    yk_report_value(page.report, 0, (size_t)column);
    assert_true(turned > 3 * 2 * YK_PI && turned <= 12 * 2 * YK_PI);
    close_page(&page);
}

static void what_is_asked_for_is_shown(void **state)
{
    (void)state;
    YkReportOptions options = yk_default_report_options();
    options.has_range = true;
    options.coordinate = 0;
    options.from = 0.5;
    options.to = 1;
    options.steps = 10;
    Page page = open_page("quick-return", &options);
    assert_int_equal(page.report->motion.kind, YK_REPORT_RANGE);
    assert_int_equal(page.report->row_count, 11);
    CHECK_NEAR(page.report->at[0], 0.5, 0);
    CHECK_NEAR(page.report->at[10], 1, 1e-15);
    close_page(&page);
    options = yk_default_report_options();
    options.duration = 0.25;
    page = open_page("double-pendulum", &options);
    CHECK_NEAR(page.report->at[page.report->row_count - 1], 0.25, 1e-12);
    close_page(&page);
}

// For a movie nothing but the poses is gathered, as many as it has frames.
static void a_movie_has_so_many_poses_a_second(void **state)
{
    (void)state;
    static const double rates[] = {20, 0.7}; // a second
    for (int k = 0; k < 2; k++) {
        YkReportOptions options = yk_default_report_options();
        options.pose_rate = rates[k];
        Page page = open_page("gas-engine", &options);
        double seconds = yk_report_seconds(page.report);
        assert_int_equal(page.report->posed, 1 + (size_t)ceil(rates[k] * seconds));
        assert_int_equal(yk_report_finding_count(page.report), 0);
        assert_non_null(yk_report_drawing(page.report));
        close_page(&page);
    }
}

// --- How long

#define ARM(gravity, inertia, more)                                                                                    \
    "gravity: [0, " gravity "]\nbodies: {ground: {points: {O: [0, 0]}}, arm: {points: {O: [0, 0], A: [2, 0]}, "        \
    "mass: 3 kg, center: [2, 0], inertia: " inertia "}}\njoints: {O: {pin: [ground, arm], angle: p}}\n" more
#define BLOCK(more)                                                                                                    \
    "bodies: {ground: {points: {O: [0, 0]}}, block: {mass: 3 kg, points: {P: [0, 0.5 m]}}}\n"                          \
    "joints: {S: {slide: [ground, block], along: x, distance: x}}\n" more

static YkReportMotion motion_of(const char *text, YkReportMotionKind kind)
{
    Page page = open_text(text, NULL);
    YkReportMotion motion = page.report->motion;
    if (motion.kind != kind) fail_msg("kind %d of %s", (int)motion.kind, text);
    if (kind == YK_REPORT_TIME || kind == YK_REPORT_SIMULATION) {
        CHECK_NEAR(motion.to - motion.from, motion.duration, 1e-12);
        CHECK_NEAR(page.report->at[page.report->row_count - 1], motion.to, 1e-12);
    }
    close_page(&page);
    return motion;
}

// Three swings of what swings slowest, by closed forms: on a spring 2 pi sqrt(m/k), under gravity 2 pi sqrt(l/g); three
// turns at the rate of the start, or three lengths of the machine. Without any of them five seconds; at most a minute.
static void a_released_machine_is_shown_for_three_swings(void **state)
{
    (void)state;
    const double swing = 2 * YK_PI;
    const struct {
        const char *text;
        double seconds;
    } cases[] = {
        {BLOCK("springs: {k: {along: x, stiffness: 12 N/m}}\nstart: {x: 0.1}\n"), 3 * swing * sqrt(3 / 12.0)},
        {BLOCK("springs: {k: {along: x, stiffness: 12 N/m}, s: {along: x, stiffness: 6 N/m}}\nstart: {x: 0.1}\n"),
         3 * swing * sqrt(3 / 6.0)},
        {BLOCK("springs: {k: {along: x, stiffness: 6 N/m}, s: {along: x, stiffness: 12 N/m}}\nstart: {x: 0.1}\n"),
         3 * swing * sqrt(3 / 6.0)},
        {BLOCK("springs: {k: {between: [ground.O, block.P], stiffness: 12 N/m}}\nstart: {x: 0.1}\n"),
         3 * swing * sqrt(3 / 12.0)},
        {BLOCK("springs: {k: {along: x, damping: 1 N*s/m}}\nstart: {x: 0, x.rate: 0.1}\n"), 3 * 0.5 / 0.1},
        {BLOCK("springs: {k: {along: x, damping: 1 N*s/m}}\nstart: {x: 0, x.rate: -0.1}\n"), 3 * 0.5 / 0.1},
        {BLOCK("springs: {k: {along: x, stiffness: 1e-4 N/m}}\nstart: {x: 0.1}\n"), 60},
        {BLOCK("start: {x: 0}\n"), 5},
        {ARM("-10", "0", "start: {p: -80 deg}\n"), 3 * swing * sqrt(2 / 10.0)},
        {ARM("0", "0", "springs: {k: {along: p, stiffness: 48 N*m/rad}}\nstart: {p: 20 deg}\n"),
         3 * swing * sqrt(3 * 4 / 48.0)},
        {ARM("-10", "0", "springs: {k: {along: p, stiffness: 48 N*m/rad}}\nstart: {p: 20 deg}\n"),
         3 * swing * fmax(sqrt(3 * 4 / 48.0), sqrt(2 / 10.0))},
        {ARM("0", "1", "start: {p: 0, p.rate: 4 rad/s}\n"), 3 * swing / 4},
        {ARM("0", "1", "start: {p: 0, p.rate: -4 rad/s}\n"), 3 * swing / 4},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        double seconds = motion_of(cases[k].text, YK_REPORT_SIMULATION).duration;
        if (!(fabs(seconds - cases[k].seconds) < 1e-9 * seconds)) fail_msg("%zu: %g s", k, seconds);
    }
}

#define TWO(first, second)                                                                                             \
    "bodies: {ground: {points: {O: [0, 0]}}, one: {points: {O: [0, 0], A: [1, 0]}}, two: {points: {A: [0, 0]}}}\n"     \
    "joints: {O: {pin: [ground, one], angle: p}, A: {pin: [one, two], angle: q}}\ndrives: {p: " first ", q: " second   \
    "}\n"

// The least common multiple of the periods of steady drives, if it is at most twelve times the longest; otherwise that
// one. A drive to and fro has its own period, whatever the phase; what stands still has none.
static void drives_are_shown_until_they_come_round(void **state)
{
    (void)state;
    const double turn = 2 * YK_PI;
    const struct {
        const char *text;
        double seconds, margin;
    } cases[] = {
        {TWO("2 rad/s * t", "3 rad/s * t"), turn, 1e-9},
        {TWO("-3 rad/s * t", "2 rad/s * t"), turn, 1e-9},
        {TWO("5 rad/s * t", "15 rad/s * t"), turn / 5, 1e-9},
        {TWO("12 rad/s * t", "13 rad/s * t"), turn, 1e-9},      // twelve times
        {TWO("13 rad/s * t", "14 rad/s * t"), turn / 13, 1e-9}, // thirteen
        {TWO("2 rad/s * t", "1.4142135623731 rad/s * t"), turn / 1.4142135623731, 1e-9},
        {TWO("2 rad/s * t", "30 deg"), turn / 2, 1e-9},
        {TWO("30 deg", "2 rad/s * t"), turn / 2, 1e-9},
        {TWO("0.1 rad/s * t", "0.1 rad/s * t"), 60, 1e-9}, // at most a minute
        {TWO("0.5 rad * sin(4 rad/s * t)", "30 deg"), turn / 4, 1e-3},
        {TWO("0.5 rad * sin(4 rad/s * t + 1)", "30 deg"), turn / 4, 1e-3},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        double seconds = motion_of(cases[k].text, YK_REPORT_TIME).duration;
        if (!(fabs(seconds - cases[k].seconds) < cases[k].margin * seconds)) fail_msg("%zu: %g s", k, seconds);
    }
    double seconds = motion_of(BLOCK("drives: {x: 20 mm * sin(4 rad/s * t)}\n"), YK_REPORT_TIME).duration;
    CHECK_NEAR(seconds, turn / 4, 1e-3 * seconds); // of one drive along a guide, too
}

#define CRANK(length, drive)                                                                                           \
    "units: {length: mm, angle: deg}\nbodies: {ground: {points: {O: [0, 0]}}, crank: {points: {O: [0, 0], A: [50, "    \
    "0]}}, rod: {points: {A: [0, 0], B: [" length ", 0]}}, ram: {points: {B: [0, 0]}}}\n"                              \
    "joints: {O: {pin: [ground, crank], angle: theta}, A: {pin: [crank, rod], angle: phi}, B: {pin: [rod, ram]}, "     \
    "S: {slide: [ground, ram], along: x, distance: s}}\ndrives: {" drive "}\n"

// A turn begins where it stands, a range a hundredth of it inside its limits, and both go the way of the drive.
static void one_input_goes_its_whole_way(void **state)
{
    (void)state;
    const double third = YK_PI / 3;
    for (int way = -1; way <= 1; way++) {
        const char *text = way < 0 ? CRANK("180", "theta: 60 - 2 rad/s * t") "start: {phi: -75, s: 200}\n"
                           : way   ? CRANK("180", "theta: 60 + 2 rad/s * t") "start: {phi: -75, s: 200}\n"
                                   : CRANK("180", "theta: 60") "start: {phi: -75, s: 200}\n";
        YkReportMotion m = motion_of(text, YK_REPORT_TURN);
        CHECK_NEAR(m.from, third, 1e-14);
        CHECK_NEAR(m.to - m.from, (way < 0 ? -1 : 1) * 2 * YK_PI, 1e-12);
        CHECK_NEAR(m.duration, way == 0 ? 0 : YK_PI, 1e-12);
        assert_false(m.is_cut);
        text = way < 0 ? CRANK("180", "s: 200 mm - 8 mm/s * t") "start: {theta: 60, phi: -75}\n"
               : way   ? CRANK("180", "s: 200 mm + 8 mm/s * t") "start: {theta: 60, phi: -75}\n"
                       : CRANK("180", "s: 200 mm") "start: {theta: 60, phi: -75}\n";
        m = motion_of(text, YK_REPORT_RANGE);
        CHECK_NEAR(way < 0 ? m.to : m.from, 0.130 + 0.001, 1e-9); // from 180 - 50 to 180 + 50 mm
        CHECK_NEAR(way < 0 ? m.from : m.to, 0.230 - 0.001, 1e-9);
        CHECK_NEAR(m.duration, way == 0 ? 0 : 0.098 / 0.008, 1e-6);
        assert_true(m.is_cut);
    }
    YkReportMotion m = motion_of(BLOCK("drives: {x: 0.2 m + 0.1 m/s * t}\n"), YK_REPORT_RANGE); // no limits
    CHECK_NEAR(m.from, 0.2 - 0.25, 1e-12);                                                      // half its size
    CHECK_NEAR(m.to, 0.2 + 0.25, 1e-12);
    assert_false(m.is_cut);
}

// A given range is a turn only if it is an angle's whole one; time is a motion of all drives.
static void a_given_range_is_what_it_is(void **state)
{
    (void)state;
    static const char text[] = CRANK("180", "theta: 60 + 2 rad/s * t") "start: {phi: -75, s: 200}\n";
    const struct {
        const char *name;
        double from, to;
        YkReportMotionKind kind;
    } cases[] = {{"theta", 1, 1 + 2 * YK_PI, YK_REPORT_TURN},
                 {"theta", 1, 1 - 2 * YK_PI, YK_REPORT_TURN},
                 {"theta", 1, 1 + YK_PI, YK_REPORT_RANGE},
                 {"theta", 1, 1 + 4 * YK_PI, YK_REPORT_RANGE},
                 {NULL, 0, 3, YK_REPORT_TIME},
                 {NULL, 1, 1 + 2 * YK_PI, YK_REPORT_TIME}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        YkReportOptions options = yk_default_report_options();
        options.has_range = true;
        options.from = cases[k].from;
        options.to = cases[k].to;
        options.coordinate = cases[k].name ? 0 : -1;
        options.steps = 4 + k;
        Page page = open_text(text, &options);
        const YkReportMotion *motion = &page.report->motion;
        assert_int_equal(motion->kind, cases[k].kind);
        CHECK_NEAR(motion->duration, cases[k].name ? 0 : cases[k].to - cases[k].from, 1e-12);
        assert_int_equal(page.report->row_count, 5 + k);
        CHECK_NEAR(page.report->at[4 + k], cases[k].to, 1e-12);
        assert_int_equal(yk_report_goes_back(page.report), cases[k].kind == YK_REPORT_RANGE);
        double seconds = yk_report_seconds(page.report); // as an eye can follow
        CHECK_NEAR(seconds, cases[k].name ? 5 : fmin(fmax(2.5, motion->duration), 15), 0);
        close_page(&page);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_of_machine_has_its_motion),
        cmocka_unit_test(rows_are_the_engines),
        cmocka_unit_test(a_range_stays_within_the_limits_and_near_them),
        cmocka_unit_test(of_two_ranges_the_one_of_the_start_is_shown),
        cmocka_unit_test(without_loads_the_first_input_is_turned),
        cmocka_unit_test(paths_are_those_of_points_that_move_apart),
        cmocka_unit_test(peaks_are_the_largest_around),
        cmocka_unit_test(two_drives_run_until_both_come_round),
        cmocka_unit_test(a_simulation_is_not_too_fast_for_its_rows),
        cmocka_unit_test(a_drive_that_speeds_up_is_shown_for_a_few_turns),
        cmocka_unit_test(what_is_asked_for_is_shown),
        cmocka_unit_test(a_movie_has_so_many_poses_a_second),
        cmocka_unit_test(a_released_machine_is_shown_for_three_swings),
        cmocka_unit_test(drives_are_shown_until_they_come_round),
        cmocka_unit_test(one_input_goes_its_whole_way),
        cmocka_unit_test(a_given_range_is_what_it_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
