// Findings on motion: ranges, dead points, strokes and their time ratio, transmission angles.
#include <math.h>
#include <yoke/design.h>
#include "report/report.h"

enum { EVENTS_MAX = 6, TURNS_MAX = 4 };
static const double full_turn = 2 * YK_PI, low_transmission = 40 * YK_PI / 180, rocks = 1e-6;

static const char *input_name(const YkReportPage *report)
{
    return yk_coordinate_info(report->mech, yk_input_coordinate(report->mech, 0)).name;
}

// Finds the range that contains the start, and how many others there are.
static void find_range(YkReportPage *report, YkText *text)
{
    if (report->range_count == 0 || report->status < 0) return;
    double now = yk_state_input(report->start, 0).position;
    bool is_distance = yk_coordinate_info(report->mech, yk_input_coordinate(report->mech, 0)).is_distance;
    YkQuantity quantity = is_distance ? YK_QUANTITY_LENGTH : YK_QUANTITY_ANGLE;
    for (size_t k = 0; k < report->range_count; k++) {
        YkRange range = report->ranges[k];
        if (now < range.from - 1e-9 || now > range.to + 1e-9) continue;
        if (!is_distance && range.to - range.from > full_turn - 1e-9) {
            yk_text_format(text, "%s can turn all the way round.", input_name(report));
        } else {
            yk_text_format(text, "%s goes from ", input_name(report));
            yk_report_amount(report, text, range.from, quantity);
            yk_text_puts(text, " to ");
            yk_report_amount(report, text, range.to, quantity);
            yk_text_puts(text, " and no further: the machine does not close beyond.");
        }
        yk_report_find(report, YK_FINDING_FACT, text);
        return;
    }
}

// Finds dead points, change points, and where the sweep had to end.
static void find_events(YkReportPage *report, YkText *text)
{
    size_t told = 0;
    for (size_t i = 0; report->sweep && i < yk_sweep_event_count(report->sweep) && told < EVENTS_MAX; i++) {
        YkEvent event = yk_sweep_event(report->sweep, i);
        if (event.kind == YK_EVENT_EXTREME) continue;
        const char *label = event.block >= 0 ? yk_block_info(report->mech, (size_t)event.block).label : "";
        yk_text_puts(text, event.kind == YK_EVENT_LIMIT          ? "The motion ends at "
                           : event.kind == YK_EVENT_CHANGE_POINT ? "There is a change point at "
                                                                 : "There is a dead point at ");
        yk_report_amount_at(report, text, event.at);
        if (*label) yk_text_format(text, ", where joint %s", label);
        if (*label)
            yk_text_puts(text, event.kind == YK_EVENT_LIMIT          ? " closes no further"
                               : event.kind == YK_EVENT_CHANGE_POINT ? " can change its branch"
                                                                     : " stretches or folds: rates are not determined");
        yk_text_puts(text, ".");
        yk_report_find(report, event.kind == YK_EVENT_LIMIT ? YK_FINDING_FACT : YK_FINDING_LOOK, text);
        told++;
    }
}

// A cam's follower dwells, so its turning points do not show when it moves.
static bool is_follower(const YkReportPage *report, size_t joint)
{
    for (size_t k = 0; k < report->model->cam_count; k++)
        if ((size_t)report->model->cams[k].follower_joint == joint) return true;
    return report->model->follow_count > 0;
}

// Finds the stroke of a coordinate that goes back and forth once in a turn.
static void find_stroke(YkReportPage *report, YkState *state, size_t coordinate, YkText *text)
{
    YkCoordinateInfo info = yk_coordinate_info(report->mech, coordinate);
    int column = yk_report_column(report, YK_ROLE_COORDINATE, coordinate, 0);
    YkStroke stroke;
    if (column < 0 || info.input >= 0 || is_follower(report, info.joint)) return;
    if (yk_state_copy(state, report->start) < 0) return;
    YkQuantity quantity = info.is_distance ? YK_QUANTITY_LENGTH : YK_QUANTITY_ANGLE;
    size_t input = (size_t)yk_coordinate_info(report->mech, (size_t)report->motion.coordinate).input;
    YkStatus status = yk_stroke(state, input, report->columns[column].channel, &stroke);
    yk_report_note(report, status);
    if (status != YK_OK) return;
    if (stroke.high - stroke.low < rocks * (info.is_distance ? yk_mechanism_size(report->mech) : 1)) return;
    yk_text_format(text, "%s moves back and forth between ", info.name);
    yk_report_amount(report, text, stroke.low, quantity);
    yk_text_puts(text, " (at ");
    yk_report_amount_at(report, text, stroke.low_at);
    yk_text_puts(text, ") and ");
    yk_report_amount(report, text, stroke.high, quantity);
    yk_text_puts(text, " (at ");
    yk_report_amount_at(report, text, stroke.high_at);
    yk_text_format(text, "), a %s of ", info.is_distance ? "stroke" : "swing");
    yk_report_amount(report, text, stroke.high - stroke.low, quantity);
    if (stroke.ratio < 1 + 1e-9)
        yk_text_puts(text, "; both strokes take the same time at constant speed.");
    else
        yk_text_format(text, "; the time ratio is %e: the quick stroke takes %e of the slow one's time.",
                       1e-4 * rint(1e4 * stroke.ratio), 1e-4 * rint(1e4 / stroke.ratio));
    yk_report_find(report, YK_FINDING_FACT, text);
}

// Over less than a turn: how far a coordinate moves, and where it turns round on the way.
static void find_reach(YkReportPage *report, size_t column, YkText *text)
{
    const YkReportColumn *of = &report->columns[column];
    YkQuantity quantity = of->channel.quantity;
    size_t told = 0;
    for (size_t i = 0; i < yk_sweep_event_count(report->sweep); i++) {
        YkEvent event = yk_sweep_event(report->sweep, i);
        if (event.kind != YK_EVENT_EXTREME || event.channel != column || told >= TURNS_MAX) continue;
        yk_text_puts(text, told > 0 ? ", " : "");
        if (told == 0) yk_text_format(text, "%s reverses at ", of->name);
        yk_report_amount(report, text, event.value, quantity);
        yk_text_puts(text, " (");
        yk_report_amount_at(report, text, event.at);
        yk_text_puts(text, ")");
        told++;
    }
    if (told == 0) return;
    yk_text_puts(text, ".");
    yk_report_find(report, YK_FINDING_FACT, text);
}

static void find_reaches(YkReportPage *report, YkText *text)
{
    if (!report->sweep || report->motion.kind == YK_REPORT_TURN) return;
    for (size_t c = 0; c < report->column_count; c++)
        if (report->columns[c].role == YK_ROLE_COORDINATE && report->columns[c].channel.order == 0)
            find_reach(report, c, text);
}

static void find_strokes(YkReportPage *report, YkText *text)
{
    if (report->motion.kind != YK_REPORT_TURN || report->motion_status < 0) return;
    YkState *state = yk_report_new_state(report);
    for (size_t c = 0; state && c < yk_coordinate_count(report->mech); c++) find_stroke(report, state, c, text);
    yk_state_free(state);
}

static bool is_singular(const YkReportPage *report, size_t block)
{
    for (size_t i = 0; i < yk_sweep_event_count(report->sweep); i++) {
        YkEvent event = yk_sweep_event(report->sweep, i);
        if (event.kind != YK_EVENT_EXTREME && event.block == (int)block) return true;
    }
    return false;
}

// Finds the least transmission angle of each dyad over the motion. It is 0 if the motion ends at a limit, which
// is nothing new.
static void find_transmission(YkReportPage *report, YkText *text)
{
    if (!report->sweep || report->motion.is_cut) return;
    for (size_t c = 0; c < report->column_count; c++) {
        if (report->columns[c].role != YK_ROLE_TRANSMISSION || is_singular(report, report->columns[c].of)) continue;
        YkPeak least = yk_report_least(report, c);
        if (!isfinite(least.value)) continue;
        const char *label = yk_block_info(report->mech, report->columns[c].of).label;
        yk_text_format(text, "The transmission angle at joint %s falls to ", label);
        yk_report_amount(report, text, least.value, YK_QUANTITY_ANGLE);
        yk_text_puts(text, " (at ");
        yk_report_amount_at(report, text, least.at);
        yk_text_puts(text,
                     least.value < low_transmission ? "); below 40 deg forces grow and clearances matter." : ").");
        yk_report_find(report, least.value < low_transmission ? YK_FINDING_LOOK : YK_FINDING_FACT, text);
    }
}

void yk_findings_motion(YkReportPage *report, YkText *text)
{
    find_range(report, text);
    find_events(report, text);
    find_strokes(report, text);
    find_reaches(report, text);
    find_transmission(report, text);
}
