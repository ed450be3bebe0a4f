// The findings of a report, against closed forms and other ways to the same number.
#include "report/page.h"

static const double degree = YK_PI / 180;

// examples/gas-engine: a slider-crank without offset.
static void a_stroke_and_its_turning_points_are_told(void **state)
{
    (void)state;
    Page page = open_page("gas-engine", NULL);
    const char *stroke = finding(page.report, "a stroke of ");
    assert_non_null(stroke);
    CHECK_NEAR(told(page.report, "x moves back and forth between "), 100, 1e-9); // 140 - 40 mm
    CHECK_NEAR(told(page.report, "a stroke of "), 80, 1e-9);
    assert_non_null(strstr(stroke, "the same time"));
    close_page(&page);
}

// examples/inverted-slider-crank and others may limp; the offset slider-crank of the textbooks does, by this ratio.
static void a_quick_return_has_its_time_ratio(void **state)
{
    (void)state;
    Page page = open_page("offset-slider-crank", NULL);
    YkStroke stroke;
    assert_true(yk_state_assemble(page.state) >= 0);
    int column = yk_report_column(page.report, YK_ROLE_COORDINATE, (int)yk_coordinate_find(page.mech, "d"), 0);
    assert_true(column >= 0);
    assert_int_equal(yk_stroke(page.state, 0, page.report->columns[column].channel, &stroke), YK_OK);
    double turned = remainder(stroke.high_at - stroke.low_at, 2 * YK_PI),
           slow = fmax(fabs(turned), 2 * YK_PI - fabs(turned));
    CHECK_NEAR(told(page.report, "the time ratio is "), slow / (2 * YK_PI - slow), 1e-4);
    close_page(&page);
}

// A dyad's transmission angle by the law of cosines: examples/four-bar is a crank-rocker, least at one end of the
// ground's line.
static void the_least_transmission_angle_is_told(void **state)
{
    (void)state;
    Page page = open_page("four-bar", NULL);
    YkFourBar bar;
    assert_int_equal(yk_four_bars(page.mech, &bar, 1), 1);
    double least = YK_PI, a = bar.length[1], b = bar.length[2], c = bar.length[3],
           d = bar.length[0]; // frame, input, ...
    for (int sign = -1; sign <= 1; sign += 2) {
        // lengths run round the ring from body 0: which is which does not matter for the pair of coupler and output
        double reach = d + sign * a, cosine = (b * b + c * c - reach * reach) / (2 * b * c);
        double angle = acos(fmax(-1, fmin(1, cosine)));
        least = fmin(least, fmin(angle, YK_PI - angle));
    }
    CHECK_NEAR(told(page.report, "The transmission angle at joint B falls to "), least / degree, 1e-3);
    close_page(&page);
}

static void limits_are_told(void **state)
{
    (void)state;
    Page page = open_page("non-grashof", NULL);
    YkRange ranges[4];
    assert_true(yk_state_assemble(page.state) >= 0);
    assert_int_equal(yk_closing_ranges(page.state, yk_input_coordinate(page.mech, 0), ranges, 4), 1);
    CHECK_NEAR(told(page.report, "theta2 goes from "), ranges[0].from / degree, 1e-2);
    assert_non_null(finding(page.report, "non-Grashof"));
    close_page(&page);
}

// The peak is between two rows; a sweep a hundred times finer finds no larger one.
static void the_peak_effort_is_the_largest_there_is(void **state)
{
    (void)state;
    Page page = open_page("gas-engine", NULL);
    int column = yk_report_column(page.report, YK_ROLE_EFFORT, 0, 0);
    assert_true(column >= 0);
    YkPeak peak = yk_report_peak(page.report, (size_t)column);
    YkDynamics *dynamics = yk_dynamics_new(page.mech, page.problems);
    YkSweepOptions options = yk_default_sweep_options();
    options.coordinate = 0;
    options.from = page.report->motion.from;
    options.to = page.report->motion.to;
    options.steps = 18000;
    options.dynamics = dynamics;
    assert_true(yk_state_assemble(page.state) >= 0);
    YkSweep *sweep = yk_sweep_run(page.state, &options, &page.report->columns[column].channel, 1, page.problems);
    assert_non_null(sweep);
    double largest = 0, sum = 0;
    for (size_t row = 0; row < yk_sweep_row_count(sweep); row++) {
        double value = yk_sweep_value(sweep, row, 0);
        if (fabs(value) > fabs(largest)) largest = value;
        sum += row > 0 ? value : 0;
    }
    CHECK_NEAR(peak.value, largest, 1e-6 * fabs(largest));
    CHECK_NEAR(told(page.report, "The drive of theta takes at most "), fabs(largest), 1e-4 * fabs(largest));
    CHECK_NEAR(fabs(told(page.report, "the drive takes up ")), fabs(sum / 18000 * 2 * YK_PI),
               2e-2 * fabs(sum / 18000 * 6.28));
    yk_sweep_free(sweep);
    yk_dynamics_free(dynamics);
    close_page(&page);
}

static void redundant_constraints_are_noted(void **state)
{
    (void)state;
    Page page = open_page("three-crank-parallelogram", NULL);
    assert_non_null(finding(page.report, "1 constraint repeats others"));
    assert_non_null(finding(page.report, "least in norm"));
    close_page(&page);
}

static void near_a_change_point_no_largest_force_is_told(void **state)
{
    (void)state;
    Page page = open_page("four-bar-at-rest", NULL);
    assert_non_null(finding(page.report, "There is a change point at theta2 = 180 deg"));
    assert_non_null(finding(page.report, "forces are unbounded"));
    assert_null(finding(page.report, "The largest force"));
    close_page(&page);
}

static void what_rests_is_said_to_rest(void **state)
{
    (void)state;
    Page page = open_page("standing-frame", NULL);
    assert_non_null(finding(page.report, "it is in equilibrium"));
    close_page(&page);
}

static void gears_and_cams_speak_for_themselves(void **state)
{
    (void)state;
    Page page = open_page("valve-cam", NULL);
    CHECK_NEAR(told(page.report, "lifts its follower by "), 9, 1e-9);
    assert_null(finding(page.report, "time ratio")); // a follower that dwells has none
    close_page(&page);
    page = open_page("reverted-train", NULL);
    assert_true(yk_report_finding_count(page.report) > 0);
    close_page(&page);
}

static void the_energy_that_a_simulation_keeps_is_told(void **state)
{
    (void)state;
    Page page = open_page("double-pendulum", NULL);
    const char *energy = finding(page.report, "Its energy goes from ");
    assert_non_null(energy);
    assert_true(told(page.report, "the balance of energy is off by ") < 1e-7);
    assert_non_null(strstr(energy, "theta1 does ")); // its motor's work
    close_page(&page);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_stroke_and_its_turning_points_are_told),
        cmocka_unit_test(a_quick_return_has_its_time_ratio),
        cmocka_unit_test(the_least_transmission_angle_is_told),
        cmocka_unit_test(limits_are_told),
        cmocka_unit_test(the_peak_effort_is_the_largest_there_is),
        cmocka_unit_test(redundant_constraints_are_noted),
        cmocka_unit_test(near_a_change_point_no_largest_force_is_told),
        cmocka_unit_test(what_rests_is_said_to_rest),
        cmocka_unit_test(gears_and_cams_speak_for_themselves),
        cmocka_unit_test(the_energy_that_a_simulation_keeps_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
