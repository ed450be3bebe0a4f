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
    YkReportOptions options = yk_default_report_options();
    options.pose_rate = 20;
    Page page = open_page("gas-engine", &options);
    double seconds = yk_report_seconds(page.report);
    assert_int_equal(page.report->posed, 1 + (size_t)ceil(20 * seconds));
    assert_int_equal(yk_report_finding_count(page.report), 0);
    assert_non_null(yk_report_drawing(page.report));
    close_page(&page);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_of_machine_has_its_motion),
        cmocka_unit_test(rows_are_the_engines),
        cmocka_unit_test(a_range_stays_within_the_limits_and_near_them),
        cmocka_unit_test(two_drives_run_until_both_come_round),
        cmocka_unit_test(a_simulation_is_not_too_fast_for_its_rows),
        cmocka_unit_test(a_drive_that_speeds_up_is_shown_for_a_few_turns),
        cmocka_unit_test(what_is_asked_for_is_shown),
        cmocka_unit_test(a_movie_has_so_many_poses_a_second),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
