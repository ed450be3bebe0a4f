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
    for (size_t c = 0; c < page.report->column_count; c++) { // over a whole turn its energy comes back
        if (page.report->columns[c].channel.kind != YK_CHANNEL_ENERGY) continue;
        double first = yk_report_value(page.report, 0, c),
               last = yk_report_value(page.report, page.report->row_count - 1, c);
        CHECK_NEAR(last, first, 1e-6 * fabs(first));
        assert_true(first > 0);
        assert_non_null(finding(page.report, " and returns to its value"));
    }
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

// --- Laws of all findings

// Every finding is a sentence: it begins with a capital letter, a number or a coordinate's name, and says something
// behind each colon.
static void check_sentences(const Page *page)
{
    for (size_t i = 0; i < yk_report_finding_count(page->report); i++) {
        const char *text = yk_report_finding(page->report, i);
        size_t length = strlen(text);
        bool begins = (*text >= 'A' && *text <= 'Z') || (*text >= '0' && *text <= '9');
        for (size_t c = 0; c < yk_coordinate_count(page->mech) && !begins; c++) {
            const char *name = yk_coordinate_info(page->mech, c).name;
            begins = strncmp(text, name, strlen(name)) == 0 && text[strlen(name)] == ' ';
        }
        if (!begins || length < 12 || text[length - 1] != '.' || strpbrk(text, "`\n") || strstr(text, "  ") ||
            strstr(text, ": .") || strstr(text, " .") || strstr(text, "..") || strstr(text, "( "))
            fail_msg("'%s' is no sentence", text);
    }
}

// Over less than a turn it is said of every coordinate that turns round, and of nothing else, that it does.
static size_t check_turning(const Page *page)
{
    const YkReportPage *report = page->report;
    size_t turning = 0;
    bool is_told = report->motion.kind == YK_REPORT_RANGE || report->motion.kind == YK_REPORT_TIME;
    for (size_t c = 0; c < report->column_count; c++) {
        char words[200];
        bool turns = false;
        double low = INFINITY, high = -INFINITY;
        snprintf(words, sizeof words, "%s reverses at ", report->columns[c].name);
        for (size_t row = 0; row < report->row_count; row++) {
            low = fmin(low, yk_report_value(report, row, c));
            high = fmax(high, yk_report_value(report, row, c));
        }
        for (size_t row = 3; row < report->row_count; row++) {
            double before = yk_report_value(report, row - 2, c) - yk_report_value(report, row - 3, c),
                   after = yk_report_value(report, row, c) - yk_report_value(report, row - 1, c);
            turns |= before * after < 0 && fmin(fabs(before), fabs(after)) > 1e-6 * (high - low);
        }
        bool is_own = report->columns[c].role == YK_ROLE_COORDINATE && report->columns[c].channel.order == 0;
        const char *found = finding(report, words);
        if (found && strstr(found, words) != found) found = NULL; // another name that ends alike
        if ((is_told && is_own && turns) != (found != NULL)) fail_msg("%s", words);
        turning += found != NULL;
    }
    return turning;
}

static void findings_are_sentences_on_what_turns_round(void **state)
{
    (void)state;
    static const char *const names[] = {"non-grashof", "rocking-four-bar", "five-bar",        "hoeken",
                                        "excavator",   "elliptic-trammel", "double-pendulum", "geared-five-bar"};
    size_t turning = 0;
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        Page page = open_page(names[k], NULL);
        check_sentences(&page);
        turning += check_turning(&page);
        if (page.report->motion.kind == YK_REPORT_SIMULATION) assert_null(finding(page.report, "The motion ends at t"));
        close_page(&page);
    }
    assert_true(turning > 4);
}

#define PRESS                                                                                                          \
    "bodies:\n  ground: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0], A: [50, 0]}}\n"                           \
    "  rod: {points: {A: [0, 0], B: [180, 0]}}\n  ram: {points: {B: [0, 0]}, mass: 2 kg}\n"                            \
    "joints: {O: {pin: [ground, crank], angle: theta}, A: {pin: [crank, rod], angle: phi}, B: {pin: [rod, ram]}, "     \
    "S: {slide: [ground, ram], along: x, distance: s}}\nstart: {phi: -75 deg, s: 200 mm}\n"                            \
    "units: {length: mm, angle: deg}\n"

// The ram leaves its table of forces on both sides; the first of these is where the motion begins to be beyond it.
static void a_law_that_is_left_is_told_in_plain_words(void **state)
{
    (void)state;
    Page page = open_text(PRESS "drives: {theta: 60 deg + 300 rpm * t}\n"
                                "laws: {cutting: {table: [[150 mm, -100 N], [200 mm, -500 N]]}}\n"
                                "efforts: {s: {law: cutting, of: s}}\n",
                          NULL);
    check_sentences(&page);
    const char *left = finding(page.report, "leaves the range of law cutting, 150 mm to 200 mm");
    assert_non_null(left);
    assert_true(strncmp(left, "The effort of s ", 16) == 0);
    double s = told(page.report, "150 mm to 200 mm: at "), value = told(page.report, "it keeps its end value, ");
    double at = told(page.report, "(first at theta = ") * degree;
    assert_true(s < 150 || s > 200);
    CHECK_NEAR(value, s < 150 ? -100 : -500, 1e-9);
    double own = 50 * cos(at) + sqrt(180 * 180 - pow(50 * sin(at), 2));
    CHECK_NEAR(s, own, 1e-3);
    close_page(&page);
}

// A motion that cannot begin ends at its start, for a reason; one that ends where a force has no value, there.
static void where_a_motion_ends_is_told_with_its_reason(void **state)
{
    (void)state;
    Page page =
        open_text("gravity: [0, -9.81]\nbodies: {ground: {points: {O: [0, 0]}}, arm: {points: {O: [0, 0], A: [1, 0]}, "
                  "mass: 1, center: [0.5, 0]}, bare: {points: {A: [0, 0]}, mass: 1}}\n"
                  "joints: {O: {pin: [ground, arm], angle: p}, A: {pin: [arm, bare], angle: q}}\nstart: {p: 0, q: 0}\n",
                  NULL);
    check_sentences(&page);
    const char *end = finding(page.report, "no inertia resists");
    assert_non_null(end);
    close_page(&page);
    page = open_text("bodies: {ground: {}, block: {mass: 1 kg}}\n"
                     "joints: {S: {slide: [ground, block], along: x, distance: x}}\n"
                     "start: {x: 0, x.rate: 1 m/s}\nforces: {f: {body: block, value: [sqrt(1 - x / 1 m) * 0 N, 0]}}\n",
                     NULL);
    check_sentences(&page);
    CHECK_NEAR(told(page.report, "The motion ends at t = "), 1, 1e-2); // beyond x = 1 m the force has no value
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
        cmocka_unit_test(findings_are_sentences_on_what_turns_round),
        cmocka_unit_test(a_law_that_is_left_is_told_in_plain_words),
        cmocka_unit_test(where_a_motion_ends_is_told_with_its_reason),
        cmocka_unit_test(the_energy_that_a_simulation_keeps_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
