// Findings on forces: efforts of the drives, the largest reaction, the shaking force, the balance of energy.
#include <math.h>
#include "elementary/elementary.h"
#include "report/report.h"

static const double noise = 1e-6; // of a sum over rows: laws of cams are not smooth enough for less

// Forces are unbounded near a dead point or change point, so no largest one can be reported.
static bool passes_singular(const YkReportPage *report)
{
    for (size_t i = 0; report->sweep && i < yk_sweep_event_count(report->sweep); i++) {
        YkEventKind kind = yk_sweep_event(report->sweep, i).kind;
        if (kind == YK_EVENT_CHANGE_POINT || kind == YK_EVENT_SINGULAR) return true;
    }
    return false;
}

static bool swept(const YkReportPage *report)
{
    return report->sweep && report->row_count > 1;
}

// Returns the mean over the motion by the trapezoidal rule: exact to rounding over a whole turn of a smooth machine.
static double mean(const YkReportPage *report, size_t column)
{
    double sum = 0, span = report->at[report->row_count - 1] - report->at[0];
    for (size_t row = 0; row + 1 < report->row_count; row++)
        sum += 0.5 * (yk_report_value(report, row, column) + yk_report_value(report, row + 1, column)) *
               (report->at[row + 1] - report->at[row]);
    return sum / span;
}

static void find_effort(YkReportPage *report, size_t column, YkText *text)
{
    YkCoordinateInfo info = yk_coordinate_info(report->mech, report->columns[column].of);
    if (info.input < 0) return;
    YkQuantity quantity = report->columns[column].channel.quantity;
    YkPeak peak = yk_report_peak(report, column);
    double middle = mean(report, column);
    if (!isfinite(peak.value) || peak.value == 0) return;
    yk_text_format(text, "%s %s takes at most ", info.has_drive ? "The drive of" : "Moving", info.name);
    yk_report_amount(report, text, fabs(peak.value), quantity);
    if (peak.value < 0) yk_text_puts(text, " against its positive sense");
    yk_text_puts(text, " (at ");
    yk_report_amount_at(report, text, peak.at);
    yk_text_puts(text, ")");
    if (isfinite(middle)) {
        yk_text_puts(text, ", on average ");
        yk_report_amount(report, text, fabs(middle) < noise * fabs(peak.value) ? 0 : middle, quantity);
    }
    yk_text_puts(text, ".");
    yk_report_find(report, YK_FINDING_FACT, text);
}

static void find_largest(YkReportPage *report, YkReportRole role, YkText *text)
{
    YkPeak largest = {0, 0};
    size_t of = 0;
    for (size_t c = 0; c < report->column_count; c++) {
        if (report->columns[c].role != role) continue;
        YkPeak peak = yk_report_peak(report, c);
        if (!(fabs(peak.value) > largest.value)) continue;
        largest = (YkPeak){fabs(peak.value), peak.at};
        of = report->columns[c].of;
    }
    if (largest.value == 0) return;
    yk_text_puts(text, report->sweep ? "The largest force in a joint is " : "The largest force in a joint is about ");
    yk_report_amount(report, text, largest.value, YK_QUANTITY_FORCE);
    yk_text_format(text, ", in %s (at ", yk_model_joint_name(report->model, of));
    yk_report_amount_at(report, text, largest.at);
    yk_text_puts(text, ").");
    yk_report_find(report, YK_FINDING_FACT, text);
}

static void find_shaking(YkReportPage *report, YkText *text)
{
    int x = -1, y = -1;
    double largest = 0, at = 0;
    for (size_t c = 0; c < report->column_count; c++) {
        if (report->columns[c].role != YK_ROLE_SHAKING) continue;
        *(report->columns[c].channel.kind == YK_CHANNEL_SHAKING_X ? &x : &y) = (int)c;
    }
    for (size_t row = 0; x >= 0 && y >= 0 && row < report->row_count; row++) {
        double size = yk_hypot(yk_report_value(report, row, (size_t)x), yk_report_value(report, row, (size_t)y));
        if (!(size > largest)) continue;
        largest = size;
        at = report->at[row];
    }
    if (largest == 0) return;
    yk_text_puts(text, "On its frame the machine exerts up to about ");
    yk_report_amount(report, text, largest, YK_QUANTITY_FORCE);
    yk_text_puts(text, " (at ");
    yk_report_amount_at(report, text, at);
    yk_text_puts(text, "), its weight included.");
    yk_report_find(report, YK_FINDING_FACT, text);
}

// Finds the work of all inputs' efforts over one turn at a steady rate: the loss in loads and friction, since the
// energy returns to its value.
static void find_work(YkReportPage *report, YkText *text)
{
    if (report->motion.kind != YK_REPORT_TURN || report->motion_status < 0) return;
    int column = yk_report_column(report, YK_ROLE_EFFORT, (size_t)report->motion.coordinate, 0), energy = -1;
    for (size_t c = 0; c < report->column_count; c++)
        if (report->columns[c].channel.kind == YK_CHANNEL_ENERGY) energy = (int)c;
    if (column < 0 || energy < 0) return;
    double work = mean(report, (size_t)column) * (report->motion.to - report->motion.from), low = INFINITY, high = -low;
    for (size_t row = 0; row < report->row_count; row++) {
        low = fmin(low, yk_report_value(report, row, (size_t)energy));
        high = fmax(high, yk_report_value(report, row, (size_t)energy));
    }
    if (!isfinite(work) || !(high >= low)) return;
    double change =
        yk_report_value(report, report->row_count - 1, (size_t)energy) - yk_report_value(report, 0, (size_t)energy);
    double scale = fmax(fabs(high), fmax(high - low, fabs(work)));
    if (fabs(work) < noise * scale) work = 0;
    yk_text_puts(text, work < 0 ? "Over one turn the drive takes up " : "Over one turn the drive does ");
    yk_report_amount(report, text, fabs(work), YK_QUANTITY_ENERGY);
    yk_text_puts(text, " of work; the machine's own energy lies between ");
    yk_report_amount(report, text, low, YK_QUANTITY_ENERGY);
    yk_text_puts(text, " and ");
    yk_report_amount(report, text, high, YK_QUANTITY_ENERGY);
    if (fabs(change) < noise * scale) {
        yk_text_puts(text, " and returns to its value");
    } else {
        yk_text_puts(text, " and ends ");
        yk_report_amount(report, text, fabs(change), YK_QUANTITY_ENERGY);
        yk_text_puts(text, change > 0 ? " higher than it began" : " lower than it began");
    }
    yk_text_puts(text, fabs(work - change) < noise * scale ? "; no load takes or gives any."
                       : work < change                     ? "; loads give the difference."
                                                           : "; loads, dampers and friction take the difference.");
    yk_report_find(report, YK_FINDING_FACT, text);
}

// Says what holds a machine at rest.
static void find_at_rest(YkReportPage *report, YkText *text)
{
    double largest = 0;
    size_t joint = 0;
    for (size_t j = 0; j < yk_model_joint_count(report->model); j++) {
        YkReaction reaction = yk_dynamics_reaction(report->dynamics, j);
        double size = yk_hypot(reaction.force[0], reaction.force[1]);
        if (!(size > largest)) continue;
        largest = size;
        joint = j;
    }
    if (largest == 0) return;
    yk_text_puts(text, "At rest the largest force in a joint is ");
    yk_report_amount(report, text, largest, YK_QUANTITY_FORCE);
    yk_text_format(text, ", in %s.", yk_model_joint_name(report->model, joint));
    yk_report_find(report, YK_FINDING_FACT, text);
}

void yk_findings_forces(YkReportPage *report, YkText *text)
{
    if (!report->dynamics) return;
    if (report->forces_message) {
        yk_text_format(text, "At the start the forces cannot be found: %s.", report->forces_message);
        yk_report_find(report, YK_FINDING_LOOK, text);
    } else if (report->has_forces && report->row_count < 2) {
        find_at_rest(report, text);
    }
    if (report->row_count < 2) return;
    if (passes_singular(report)) {
        yk_text_puts(text, "Near a dead point or a change point forces are unbounded, so no largest values are given.");
        yk_report_find(report, YK_FINDING_LOOK, text);
        return;
    }
    for (size_t c = 0; swept(report) && c < report->column_count; c++)
        if (report->columns[c].role == YK_ROLE_EFFORT) find_effort(report, c, text);
    find_largest(report, YK_ROLE_REACTION, text);
    find_shaking(report, text);
    if (swept(report)) find_work(report, text);
}
