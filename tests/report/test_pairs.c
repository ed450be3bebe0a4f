// Every finding is told of a machine made to have it, with the numbers of a closed form, and is not told of its
// neighbour without it.
#include "report/page.h"

static const double degree = YK_PI / 180;

// Opens the machine of a text and checks that words are among its findings, or are not.
static void check_words(const char *text, const char *words, bool is_told)
{
    Page page = open_text(text, NULL);
    if ((finding(page.report, words) != NULL) == is_told) {
        close_page(&page);
        return;
    }
    for (size_t i = 0; i < yk_report_finding_count(page.report); i++)
        print_error("%s\n", yk_report_finding(page.report, i));
    fail_msg("'%s' is %stold of\n%s", words, is_told ? "not " : "", text);
}

static bool is_look(const YkReportPage *report, const char *words)
{
    for (size_t i = 0; i < report->finding_count; i++)
        if (strstr(report->findings[i].text, words)) return report->findings[i].kind == YK_FINDING_LOOK;
    return false;
}

// --- Structure

#define CHAIN(mass, more)                                                                                              \
    "bodies: {ground: {points: {O: [0, 0]}}, one: {points: {O: [0, 0], A: [1, 0]}" mass "}, "                          \
    "two: {points: {A: [0, 0], B: [1, 0]}" mass "}, three: {points: {B: [0, 0]}" mass "}}\n"                           \
    "joints: {O: {pin: [ground, one], angle: p}, A: {pin: [one, two], angle: q}, B: {pin: [two, three], angle: "       \
    "r}}\n" more
#define HEAVY ", mass: 1, inertia: 1, center: [0.5, 0]"

static void freedom_is_told_with_its_drives_and_loads(void **state)
{
    (void)state;
    const struct {
        const char *text, *words;
    } cases[] = {
        {CHAIN("", "start: {p: 0}\n"), "It has 3 degrees of freedom, none driven."},
        {CHAIN(HEAVY, "start: {p: 0}\n"),
         "It has 3 degrees of freedom, none of them driven: it moves under its loads."},
        {CHAIN("", "drives: {p: 1 rad/s * t}\n"),
         "It has 3 degrees of freedom, 1 of them driven; the others stay at their start."},
        {CHAIN(HEAVY, "drives: {p: 1 rad/s * t}\n"),
         "It has 3 degrees of freedom, 1 of them driven; the others move under the loads."},
        {CHAIN("", "drives: {p: 1 rad/s * t, q: 1 rad/s * t}\n"),
         "It has 3 degrees of freedom, 2 of them driven; the other stays at its start."},
        {CHAIN(HEAVY, "drives: {p: 1 rad/s * t, q: 1 rad/s * t}\n"),
         "It has 3 degrees of freedom, 2 of them driven; the other moves under the loads."},
        {CHAIN("", "drives: {p: 1 rad/s * t, q: 1 rad/s * t, r: 1 rad/s * t}\n"),
         "It has 3 degrees of freedom and as many drives: the motion is determined."},
        {"bodies: {ground: {points: {O: [0, 0], Q: [1, 0]}}, arm: {points: {O: [0, 0], Q: [1, 0]}}}\n"
         "joints: {O: {pin: [ground, arm]}, Q: {pin: [ground, arm]}}\n",
         "It has no degree of freedom: it is a structure and does not move."},
        {"bodies: {ground: {points: {O: [0, 0]}}, arm: {points: {O: [0, 0]}}}\n"
         "joints: {O: {pin: [ground, arm], angle: p}}\ndrives: {p: 1 rad/s * t}\n",
         "It has 1 degree of freedom and as many drives: the motion is determined."},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) check_words(cases[k].text, cases[k].words, true);
    check_words(cases[0].text, "can be assembled in", false); // an open chain: one way alone
}

// --- Ranges and angles

#define FOUR_BAR(start, coupler, rocker)                                                                               \
    "units: {length: mm, angle: deg}\n"                                                                                \
    "bodies: {ground: {points: {O: [0, 0], C: [100, 0]}}, crank: {points: {O: [0, 0], A: [40, 0]}}, "                  \
    "coupler: {points: {A: [0, 0], B: [" coupler ", 0]}}, rocker: {points: {C: [0, 0], B: [" rocker ", 0]}}}\n"        \
    "joints: {O: {pin: [ground, crank], angle: p}, A: {pin: [crank, coupler], angle: q}, "                             \
    "C: {pin: [ground, rocker], angle: r}, B: {pin: [coupler, rocker]}}\n"                                             \
    "drives: {p: " start " + 1 rad/s * t}\nstart: {q: -20, r: 90}\n"

// Whether it turns does not depend on where it stands, nor does a range's end where a machine stands at it.
static void a_range_is_told_wherever_in_it_the_machine_stands(void **state)
{
    (void)state;
    check_words(FOUR_BAR("60", "120", "80"), "p can turn all the way round.", true);
    check_words(FOUR_BAR("180", "120", "80"), "p can turn all the way round.", true);
    check_words(FOUR_BAR("-180", "120", "80"), "p can turn all the way round.", true);
    check_words(FOUR_BAR("40", "60", "70"), "p can turn all the way round.", false);
    static const char *const starts[] = {"130 mm", "150 mm", "230 mm"};
    for (size_t k = 0; k < 3; k++) {
        char text[900];
        snprintf(text, sizeof text,
                 "units: {length: mm, angle: deg}\n"
                 "bodies: {ground: {points: {O: [0, 0]}}, crank: {points: {O: [0, 0], A: [50, 0]}}, "
                 "rod: {points: {A: [0, 0], B: [180, 0]}}, ram: {points: {B: [0, 0]}}}\n"
                 "joints: {S: {slide: [ground, ram], along: x, distance: s}, O: {pin: [ground, crank], angle: theta}, "
                 "A: {pin: [crank, rod], angle: phi}, B: {pin: [rod, ram]}}\n"
                 "drives: {s: %s + 10 mm/s * t}\nstart: {phi: -75, theta: 60}\n",
                 starts[k]);
        check_words(text, "s goes from 130 mm to 230 mm and no further", true);
    }
}

// The law of cosines for the dyad over the frame less and plus the crank; below 40 deg it is worth a look.
static void a_small_transmission_angle_is_worth_a_look(void **state)
{
    (void)state;
    static const char *const texts[] = {FOUR_BAR("60", "120", "80"), FOUR_BAR("60", "85", "85"),
                                        FOUR_BAR("60", "80", "95")};
    const double lengths[][2] = {{120, 80}, {85, 85}, {80, 95}};
    for (size_t k = 0; k < 3; k++) {
        Page page = open_text(texts[k], NULL);
        double b = lengths[k][0], c = lengths[k][1], least = 180;
        for (int sign = -1; sign <= 1; sign += 2) {
            double reach = 100 + sign * 40, angle = acos((b * b + c * c - reach * reach) / (2 * b * c)) / degree;
            least = fmin(least, fmin(angle, 180 - angle));
        }
        CHECK_NEAR(told(page.report, "The transmission angle at joint B falls to "), least, 1e-4 * least);
        assert_int_equal(is_look(page.report, "The transmission angle"), least < 40);
        assert_int_equal(finding(page.report, "below 40 deg forces grow") != NULL, least < 40);
        close_page(&page);
    }
}

// A four-bar's rocker turns round where crank and coupler lie on one line; the crank is the input. A triangle of three
// bodies on a crank is rigid, so that no swing in it is told.
static void only_what_rocks_has_a_stroke(void **state)
{
    (void)state;
    Page page = open_text(FOUR_BAR("60", "120", "80"), NULL);
    double ends[2];
    for (int k = 0; k < 2; k++) {
        double far = k == 0 ? 120 + 40 : 120 - 40; // from O to B
        ends[k] = 180 - acos((100 * 100 + 80 * 80 - far * far) / (2 * 100 * 80.0)) / degree;
    }
    CHECK_NEAR(told(page.report, "r moves back and forth between "), fmin(ends[0], ends[1]), 5e-3);
    CHECK_NEAR(told(page.report, "a swing of "), fabs(ends[0] - ends[1]), 5e-3);
    assert_null(finding(page.report, "p moves back and forth"));
    double beta[2]; // the crank's angles there
    for (int k = 0; k < 2; k++) {
        double far = k == 0 ? 120 + 40 : 120 - 40, rise = acos((100 * 100 + far * far - 80 * 80) / (2 * 100 * far));
        beta[k] = k == 0 ? rise : rise + YK_PI;
    }
    double way = fabs(beta[1] - beta[0]), ratio = fmax(way, 2 * YK_PI - way) / fmin(way, 2 * YK_PI - way);
    CHECK_NEAR(told(page.report, "the time ratio is "), ratio, 1e-4);
    CHECK_NEAR(told(page.report, "the quick stroke takes "), 1 / ratio, 1e-4);
    close_page(&page);
    check_words("bodies: {ground: {points: {O: [0, 0]}}, one: {points: {O: [0, 0], A: [3, 0], B: [3, 4]}}, "
                "two: {points: {A: [0, 0], C: [5, 0]}}, three: {points: {B: [0, 0], C: [4, 0]}}}\n"
                "joints: {O: {pin: [ground, one], angle: p}, A: {pin: [one, two], angle: q}, "
                "B: {pin: [one, three], angle: r}, C: {pin: [two, three]}}\n"
                "drives: {p: 1 rad/s * t}\nstart: {q: 40 deg, r: -10 deg}\n",
                "moves back and forth", false);
}

// --- Work

#define LIFT(rate, more)                                                                                               \
    "gravity: [0, -10]\nbodies: {ground: {points: {O: [0, 0], G: [0.1, 0]}}, drum: {points: {O: [0, 0]}}, "            \
    "load: {mass: 2 kg}}\njoints: {O: {pin: [ground, drum], angle: p}, "                                               \
    "S: {slide: [ground, load], along: y, from: G, distance: h}}\n"                                                    \
    "racks: {rope: {pinion: drum, rack: load, radius: 0.1}}\ndrives: {p: 0.5 rad + " rate                              \
    " * t}\nstart: {h: 0}\n" more

// A drum of 0.1 m lifts 2 kg by 2 pi 0.1 m in a turn: 4 pi joules, with or without a load of 3 N m against the drum or
// with it. What the drive does and what its energy gains differ by the load's 6 pi.
static void the_work_of_a_turn_is_that_of_weight_and_loads(void **state)
{
    (void)state;
    const struct {
        const char *text;
        double work, gain;
        const char *end;
    } cases[] = {
        {LIFT("1 rad/s", ""), 4 * YK_PI, 4 * YK_PI, "no load takes or gives any."},
        {LIFT("-1 rad/s", ""), -4 * YK_PI, -4 * YK_PI, "no load takes or gives any."},
        {LIFT("1 rad/s", "efforts: {p: -3}\n"), 10 * YK_PI, 4 * YK_PI,
         "loads, dampers and friction take the difference."},
        {LIFT("1 rad/s", "efforts: {p: 3}\n"), -2 * YK_PI, 4 * YK_PI, "loads give the difference."},
        {LIFT("-1 rad/s", "efforts: {p: 3}\n"), 2 * YK_PI, -4 * YK_PI,
         "loads, dampers and friction take the difference."},
        {LIFT("-1 rad/s", "efforts: {p: -3}\n"), -10 * YK_PI, -4 * YK_PI, "loads give the difference."},
        {LIFT("1 rad/s", "efforts: {p: 2}\n"), 0, 4 * YK_PI, "loads give the difference."},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        Page page = open_text(cases[k].text, NULL);
        const YkReportPage *report = page.report;
        bool is_up = cases[k].gain > 0, is_taken = cases[k].work < 0;
        const char *words = is_taken ? "Over one turn the drive takes up " : "Over one turn the drive does ";
        CHECK_NEAR(told(report, words), fabs(cases[k].work), 1e-4 * fabs(cases[k].work));
        const char *text = finding(report, words);
        assert_non_null(strstr(text, cases[k].end));
        assert_non_null(strstr(text, is_up ? " higher than it began" : " lower than it began"));
        CHECK_NEAR(told(report, " and ends "), fabs(cases[k].gain), 1e-4 * fabs(cases[k].gain));
        double low = told(report, "own energy lies between "),
               high = strtod(strstr(strstr(text, "between "), " and ") + 5, NULL);
        CHECK_NEAR(high - low, fabs(cases[k].gain), 2e-4 * fabs(cases[k].gain));
        double torque = fabs(cases[k].work) / (2 * YK_PI); // the same all the way
        if (torque > 0) {
            CHECK_NEAR(told(report, "The drive of p takes at most "), torque, 1e-4 * torque);
            CHECK_NEAR(fabs(told(report, ", on average ")), torque, 1e-4 * torque);
            bool against = finding(report, "against its positive sense") != NULL;
            assert_int_equal(against, (cases[k].work < 0) != (cases[k].gain < 0));
        } else {
            assert_null(finding(report, "takes at most"));
        }
        close_page(&page);
    }
}

// A mass m on a circle of radius r at the rate w shakes its frame with m w^2 r, and its weight on top: most at the
// foot of the circle. The pin carries the same.
static void a_turning_mass_shakes_its_frame(void **state)
{
    (void)state;
    Page page = open_text("gravity: [0, -10]\nbodies: {ground: {points: {O: [0, 0]}}, wheel: {points: {O: [0, 0]}, "
                          "mass: 2 kg, center: [0.1, 0], inertia: 1}}\n"
                          "joints: {O: {pin: [ground, wheel], angle: p}}\ndrives: {p: 20 rad/s * t}\n",
                          NULL);
    double most = 2 * 400 * 0.1 + 2 * 10;
    CHECK_NEAR(told(page.report, "On its frame the machine exerts up to about "), most, 1e-4 * most);
    CHECK_NEAR(told(page.report, "The largest force in a joint is "), most, 1e-4 * most);
    CHECK_NEAR(told(page.report, "On its frame the machine exerts up to about 100 N (at p = "), 270, 1e-3);
    CHECK_NEAR(told(page.report, "The drive of p takes at most "), 2, 1e-4); // m g r
    CHECK_NEAR(told(page.report, ", on average "), 0, 0);
    assert_non_null(finding(page.report, " and returns to its value; no load takes or gives any."));
    CHECK_NEAR(told(page.report, "own energy lies between "), 0.5 * (1 + 2 * 0.01) * 400 - 2, 1e-2);
    close_page(&page);
}

// A flywheel of a million times the mass gives back what it takes up as well: rounding is no work.
static void no_rounding_is_told_as_work(void **state)
{
    (void)state;
    check_words("gravity: [0, -10]\nbodies: {ground: {points: {O: [0, 0]}}, wheel: {points: {O: [0, 0]}, "
                "mass: 2e6 kg, center: [0.1, 0.03], inertia: 1e6}}\n"
                "joints: {O: {pin: [ground, wheel], angle: p}}\ndrives: {p: 0.3 + 20 rad/s * t}\n",
                "Over one turn the drive does 0 J of work", true);
}

// A force of 1e-14 N is none of the noise where no other is larger.
static void small_forces_of_small_machines_are_told(void **state)
{
    (void)state;
    Page page = open_text("gravity: [0, -10]\nbodies: {ground: {points: {O: [0, 0]}}, arm: {points: {O: [0, 0]}, "
                          "mass: 1e-15 kg, center: [0, -1], inertia: 1e-15}}\n"
                          "joints: {O: {pin: [ground, arm], angle: p}}\nstart: {p: 0}\n",
                          NULL);
    const char *row = strstr(yk_report_html(page.report, page.problems), "Reactions at the start");
    assert_non_null(row);
    const char *value = strstr(row, "1e-14"), *end = strstr(row, "</table>");
    assert_true(value && value < end);
    close_page(&page);
}

// One crank drives six rockers: four of their four-bars are told, and that there are two more.
static void of_many_four_bars_the_first_are_told(void **state)
{
    (void)state;
    for (int count = 4; count <= 6; count++) {
        char text[4000], words[60];
        int n = snprintf(text, sizeof text, "bodies:\n  ground: {points: {O: [0, 0]");
        for (int k = 0; k < count; k++) n += snprintf(text + n, sizeof text - (size_t)n, ", C%d: [%d, 0.1]", k, 10 + k);
        n += snprintf(text + n, sizeof text - (size_t)n, "}}\n  crank: {points: {O: [0, 0]");
        for (int k = 0; k < count; k++) n += snprintf(text + n, sizeof text - (size_t)n, ", A%d: [2, 0]", k);
        n += snprintf(text + n, sizeof text - (size_t)n, "}}\n");
        for (int k = 0; k < count; k++)
            n += snprintf(
                text + n, sizeof text - (size_t)n,
                "  rod%d: {points: {A%d: [0, 0], B%d: [9, 0]}}\n  out%d: {points: {C%d: [0, 0], B%d: [6, 0]}}\n", k, k,
                k, k, k, k);
        n += snprintf(text + n, sizeof text - (size_t)n, "joints:\n  O: {pin: [ground, crank], angle: p}\n");
        for (int k = 0; k < count; k++)
            n += snprintf(text + n, sizeof text - (size_t)n,
                          "  A%d: {pin: [crank, rod%d]}\n  C%d: {pin: [ground, out%d]}\n  B%d: {pin: [rod%d, out%d]}\n",
                          k, k, k, k, k, k, k);
        snprintf(text + n, sizeof text - (size_t)n, "drives: {p: 1 rad + 1 rad/s * t}\n");
        Page page = open_text(text, NULL);
        int told_of = 0;
        for (size_t i = 0; i < yk_report_finding_count(page.report); i++)
            told_of += strstr(yk_report_finding(page.report, i), " are a four-bar, ") != NULL;
        assert_int_equal(told_of, 4);
        snprintf(words, sizeof words, "It contains %d more four-bars.", count - 4);
        assert_int_equal(finding(page.report, words) != NULL, count > 4);
        close_page(&page);
    }
}

// --- Cams

#define CAM(base, roller, speed)                                                                                       \
    "units: {length: mm, angle: deg}\nlaws: {lift: {period: 360, segments: [{rise: {to: 90, by: 20, law: "             \
    "cycloidal}}, "                                                                                                    \
    "{dwell: {to: 180}}, {fall: {to: 270, by: 20, law: cycloidal}}, {dwell: {to: 360}}]}}\n"                           \
    "cams: {c: {cam: shaft, follower: tappet, law: lift, base: " base ", roller: " roller "}}\n"                       \
    "bodies: {shaft: {}, tappet: {mass: 0.2 kg}}\n"                                                                    \
    "joints: {K: {pin: [ground, shaft], angle: theta}, T: {slide: [ground, tappet], along: y, distance: s}}\n"         \
    "springs: {k: {along: s, stiffness: 4 N/mm, length: -10}}\ndrives: {theta: " speed " * t}\n"

// A roller larger than the pitch curve's radius is undercut; a follower leaves the cam where its mass times the
// acceleration of a cycloidal fall, -2 pi h / beta^2 at a quarter of it, outdoes the spring.
static void a_cam_is_undercut_or_left_only_if_it_is(void **state)
{
    (void)state;
    check_words(CAM("40", "8", "600 rpm"), "is undercut", false);
    check_words(CAM("5", "150", "600 rpm"), "The cam c is undercut: part of its surface is cut away.", true);
    Page page = open_text(CAM("40", "8", "600 rpm"), NULL);
    CHECK_NEAR(told(page.report, "The cam c lifts its follower by "), 20, 1e-9);
    double beta = YK_PI / 2, least = INFINITY;
    for (double x = 0; x <= 1; x += 1e-5) {
        double s = 0.02 * (x - sin(2 * YK_PI * x) / (2 * YK_PI)),
               a = 0.02 * 2 * YK_PI / (beta * beta) * sin(2 * YK_PI * x);
        if (a < 0) least = fmin(least, sqrt(4000 * (s + 0.01) / (-0.2 * a)));
    }
    double leaves = told(page.report, "The follower of c leaves the cam from ");
    CHECK_NEAR(leaves * (strstr(finding(page.report, "leaves the cam from "), "rpm") ? YK_PI / 30 : degree), least,
               2e-4 * least);
    assert_null(finding(page.report, "at its drive's speed it does"));
    close_page(&page);
    check_words(CAM("40", "8", "6000 rpm"), "on: at its drive's speed it does.", true);
    check_words(CAM("40", "8", "-6000 rpm"), "on: at its drive's speed it does.", true);
    check_words(CAM("40", "8", "0 rpm"), "leaves the cam", false);
}

// --- Gears

#define PAIR(last, teeth)                                                                                              \
    "bodies: {ground: {points: {A: [0, 0], B: [0.2, 0], C: [0.1, 0.2]}}, input: {}, two: {}, " last ": {}}\n"          \
    "joints: {A: {pin: [ground, input], angle: p}, B: {pin: [ground, two]}, C: {pin: [ground, " last "]}}\n"           \
    "gears: {g: {mesh: [input, two], teeth: [17, 34]}, h: {mesh: [two, " last "], teeth: " teeth "}}\n"                \
    "drives: {p: 1 rad/s * t}\n"

// Externally, twice: 34/17 times 51/20 in the sense of the input, if the file says which body is the output.
static void a_train_tells_its_ratio_where_it_has_one(void **state)
{
    (void)state;
    check_words(PAIR("output", "[20, 51]"), "The gear train's ratio of input to output is 51/10 = 5.1.", true);
    check_words(PAIR("output", "[20, 50]"), "The gear train's ratio of input to output is 5.", true);
    check_words(PAIR("other", "[20, 51]"), "ratio", false);
}

// Without a drive all turns are those for one turn of the input; with one they are speeds.
static void turns_are_told_where_no_drive_gives_speeds(void **state)
{
    (void)state;
    char text[1000];
    snprintf(text, sizeof text, "%s", PAIR("output", "[20, 51]"));
    for (int driven = 1; driven >= 0; driven--) {
        if (!driven) strstr(text, "drives:")[0] = '#';
        Page page = open_text(text, NULL);
        const char *html = yk_report_html(page.report, page.problems);
        assert_int_equal(strstr(html, "Speeds, counter-clockwise") != NULL, driven);
        assert_int_equal(strstr(html, "Turns for one turn of the input") != NULL, !driven);
        const char *row = strstr(strstr(html, driven ? "Speeds, counter" : "Turns for one turn"), "output</");
        assert_non_null(row);
        const char *end = strstr(row, "</tr>"), *value = strstr(row, driven ? "1.87241" : "0.196078"); // of 10/51
        assert_true(value && value < end);
        close_page(&page);
    }
}

// Two rows are a motion, however short.
static void what_moves_is_not_at_rest(void **state)
{
    (void)state;
    YkReportOptions options = yk_default_report_options();
    options.steps = 1;
    Page page = open_page("gas-engine", &options);
    assert_int_equal(page.report->row_count, 2);
    assert_null(finding(page.report, "At rest"));
    assert_non_null(finding(page.report, "The largest force in a joint is "));
    close_page(&page);
}

// --- Released

#define BLOCK(more)                                                                                                    \
    "bodies: {ground: {points: {O: [0, 0]}}, block: {mass: 3 kg, points: {P: [0, 0.5 m]}}}\n"                          \
    "joints: {S: {slide: [ground, block], along: x, distance: x}}\n" more

// A force of 3 N on 3 kg does 37.5 J in the five seconds of the page; a damper of 1 N s/m takes 1 - 1/e of 1.5 J in
// 1.5 s; a spring keeps all of it.
static void energy_and_works_are_those_of_the_motion(void **state)
{
    (void)state;
    Page page = open_text(BLOCK("efforts: {x: 3 N}\nstart: {x: 0}\n"), NULL);
    CHECK_NEAR(told(page.report, "Its energy goes from 0 J to "), 37.5, 1e-3);
    CHECK_NEAR(told(page.report, "x does "), 37.5, 1e-3);
    assert_true(told(page.report, "the balance of energy is off by ") < 1e-9);
    assert_null(finding(page.report, "On the way"));
    assert_null(finding(page.report, "in equilibrium"));
    close_page(&page);
    page = open_text(BLOCK("springs: {d: {along: x, damping: 1 N*s/m}}\nstart: {x: 0, x.rate: 1}\n"), NULL);
    CHECK_NEAR(told(page.report, "Its energy goes from 1.5 J to "), 1.5 * exp(-1), 1e-4);
    CHECK_NEAR(told(page.report, "d does "), 1.5 * exp(-1) - 1.5, 1e-4);
    close_page(&page);
    page = open_text(BLOCK("springs: {k: {along: x, stiffness: 12 N/m}}\nstart: {x: 0.5}\n"), NULL);
    CHECK_NEAR(told(page.report, "Its energy goes from "), 1.5, 0);
    assert_non_null(finding(page.report, "1.5 J to 1.5 J. Over")); // and no work is told
    close_page(&page);
}

// At 1 m/s for 1.5 s it goes 1.5 m between stops a and a apart from its start: it hits them at a, 3 a, 5 a ... Six of
// these times are told, and how many more there are.
static void stops_that_are_hit_are_told_with_their_times(void **state)
{
    (void)state;
    static const char *const ends[] = {"0.11", "0.13", "0.16", "2"};
    for (size_t k = 0; k < 4; k++) {
        char text[600], words[40];
        double end = atof(ends[k]);
        int count = 0;
        snprintf(text, sizeof text,
                 BLOCK("stops: {x: {between: [-%s m, %s m], restitution: 1}}\n") "start: {x: 0, x.rate: 1}\n", ends[k],
                 ends[k]);
        Page page = open_text(text, NULL);
        const char *told_at = finding(page.report, "On the way: ");
        assert_int_equal(told_at != NULL, k < 3);
        for (double at = end; at < 1.5; at += 2 * end) {
            if (count < 6) {
                assert_non_null(told_at = strstr(told_at, "hits its stop at t = "));
                told_at += strlen("hits its stop at t = ");
                CHECK_NEAR(strtod(told_at, NULL), at, 1e-4 * at);
            }
            count++;
        }
        snprintf(words, sizeof words, "; and %d more.", count - 6);
        assert_int_equal(finding(page.report, words) != NULL, count > 6);
        if (count <= 6) assert_null(finding(page.report, " more."));
        close_page(&page);
    }
}

// It rests where no force acts and none comes; not at a speed, nor away from its place, nor where a force comes later.
static void only_what_stays_is_said_to_stay(void **state)
{
    (void)state;
    check_words(BLOCK("springs: {k: {along: x, stiffness: 12 N/m}}\nstart: {x: 0}\n"), "it is in equilibrium", true);
    check_words(BLOCK("springs: {k: {along: x, stiffness: 12 N/m}}\nstart: {x: 1e-3}\n"), "it is in equilibrium",
                false);
    check_words(BLOCK("springs: {k: {along: x, stiffness: 12 N/m}}\nstart: {x: 0, x.rate: 1e-3}\n"),
                "it is in equilibrium", false);
    check_words(BLOCK("efforts: {x: \"0.5 N * max(0, t / (1 s) - 1)\"}\nstart: {x: 0}\n"), "it is in equilibrium",
                false);
#define HANGING(start)                                                                                                 \
    "gravity: [0, -10]\nbodies: {ground: {points: {O: [0, 0]}}, arm: {points: {O: [0, 0], A: [1, 0]}, mass: 1, "       \
    "center: [1, 0], inertia: 0.1}}\njoints: {O: {pin: [ground, arm], angle: p}}\nstart: {p: " start "}\n"
    check_words(HANGING("-90 deg"), "it is in equilibrium", true);
    check_words(HANGING("-80 deg"), "it is in equilibrium", false);
    Page page = open_text(HANGING("-90 deg"), NULL);
    assert_null(finding(page.report, "Its energy goes"));
    CHECK_NEAR(told(page.report, "The largest force in a joint is about "), 10, 1e-9);
    close_page(&page);
}

// A strut that cannot move carries its weight of m g in its pin; without a weight there is nothing to tell.
static void a_structure_tells_what_it_carries(void **state)
{
    (void)state;
#define FRAME(mass)                                                                                                    \
    "gravity: [0, -10]\nbodies: {ground: {points: {O: [0, 0], Q: [2, 0]}}, "                                           \
    "a: {points: {O: [0, 0], T: [1, 1]}" mass "}, b: {points: {Q: [0, 0], T: [-1, 1]}}}\n"                             \
    "joints: {O: {pin: [ground, a]}, Q: {pin: [ground, b]}, T: {pin: [a, b]}}\n"
    Page page = open_text(FRAME(", mass: 3 kg, center: [1, 1]"), NULL); // halved on two bars at 45 deg
    CHECK_NEAR(told(page.report, "At rest the largest force in a joint is "), 30 / sqrt(2), 1e-3);
    close_page(&page);
    check_words(FRAME(""), "At rest", false);
}

#define PLANETS(count)                                                                                                 \
    "bodies: {sun: {}, planet: {}, ring: {}, arm: {points: {P: [44 mm, 0]}}}\n"                                        \
    "joints: {S: {pin: [ground, sun], angle: p}, R: {pin: [ground, ring]}, A: {pin: [ground, arm]}, "                  \
    "P: {pin: [arm, planet]}}\n"                                                                                       \
    "gears: {inner: {mesh: [sun, planet], teeth: [24, 20], module: 2 mm, planets: " count "}, "                        \
    "outer: {mesh: [planet, ring], teeth: [20, 64], module: 2 mm, internal: true}}\ndrives: {p: 1 rad/s * t}\n"

// (24 + 64)/n must be whole; neighbours must be apart.
static void planets_that_do_not_fit_are_noted(void **state)
{
    (void)state;
    check_words(PLANETS("4"), "Mesh inner: ", false);
    check_words(PLANETS("3"), "Mesh inner: 3 planets equally spaced do not fit: (24 + 64)/3 is not whole.", true);
    check_words(PLANETS("8"), "Mesh inner: neighbours of 8 planets touch each other", true);
    check_words(PLANETS("8"), "do not fit", false);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(freedom_is_told_with_its_drives_and_loads),
        cmocka_unit_test(a_range_is_told_wherever_in_it_the_machine_stands),
        cmocka_unit_test(a_small_transmission_angle_is_worth_a_look),
        cmocka_unit_test(only_what_rocks_has_a_stroke),
        cmocka_unit_test(the_work_of_a_turn_is_that_of_weight_and_loads),
        cmocka_unit_test(a_turning_mass_shakes_its_frame),
        cmocka_unit_test(no_rounding_is_told_as_work),
        cmocka_unit_test(small_forces_of_small_machines_are_told),
        cmocka_unit_test(of_many_four_bars_the_first_are_told),
        cmocka_unit_test(a_cam_is_undercut_or_left_only_if_it_is),
        cmocka_unit_test(a_train_tells_its_ratio_where_it_has_one),
        cmocka_unit_test(turns_are_told_where_no_drive_gives_speeds),
        cmocka_unit_test(what_moves_is_not_at_rest),
        cmocka_unit_test(energy_and_works_are_those_of_the_motion),
        cmocka_unit_test(stops_that_are_hit_are_told_with_their_times),
        cmocka_unit_test(only_what_stays_is_said_to_stay),
        cmocka_unit_test(a_structure_tells_what_it_carries),
        cmocka_unit_test(planets_that_do_not_fit_are_noted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
