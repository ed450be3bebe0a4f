// Findings on what the machine does when it is released.
#include <math.h>
#include <yoke/simulation.h>
#include "report/report.h"

enum { HAPPENINGS_MAX = 6, WORKS_MAX = 8 };
static const double still = 1e-9, stays = 1e-2; // 1/s^2; rad; or of the machine's size

static const char *word_of(YkHappeningKind kind)
{
    static const char *const words[] = {[YK_HAPPENING_STOP] = "hits its stop",
                                        [YK_HAPPENING_RELEASE] = "leaves its stop",
                                        [YK_HAPPENING_STICK] = "comes to stick",
                                        [YK_HAPPENING_SLIP] = "begins to slip",
                                        [YK_HAPPENING_CHANGE_POINT] = "passes a change point",
                                        [YK_HAPPENING_DEAD_POINT] = "passes a dead point",
                                        [YK_HAPPENING_CROSSING] = "crosses a value",
                                        [YK_HAPPENING_LIFT_OFF] = "loses its follower",
                                        [YK_HAPPENING_LANDING] = "meets its follower again",
                                        [YK_HAPPENING_PULL] = "would have to pull its follower",
                                        [YK_HAPPENING_LAW_LEFT] = "leaves the range of its law"};
    return words[kind];
}

static void find_happenings(YkReportPage *report, YkText *text)
{
    size_t count = yk_simulation_happening_count(report->simulation),
           shown = count < HAPPENINGS_MAX ? count : HAPPENINGS_MAX;
    for (size_t k = 0; k < shown; k++) {
        YkHappening h = yk_simulation_happening(report->simulation, k);
        yk_text_puts(text, k == 0 ? "On the way: " : "; ");
        yk_text_format(text, "%s %s at t = ", h.name ? h.name : "the machine", word_of(h.kind));
        yk_report_amount(report, text, h.time, YK_QUANTITY_TIME);
    }
    if (shown == 0) return;
    if (count > shown) yk_text_format(text, "; and %z more", count - shown);
    yk_text_puts(text, ".");
    yk_report_find(report, YK_FINDING_FACT, text);
}

static void find_energy(YkReportPage *report, YkText *text)
{
    YkSimulationSummary summary = yk_simulation_summary(report->simulation);
    double start = summary.energy_start, end = summary.energy_end, off = end - start;
    size_t told = 0;
    for (size_t k = 0; k < yk_simulation_work_count(report->simulation); k++)
        off -= yk_simulation_work(report->simulation, k);
    yk_text_puts(text, "Its energy goes from ");
    yk_report_amount(report, text, fabs(start) > fabs(off) ? start : 0, YK_QUANTITY_ENERGY);
    yk_text_puts(text, " to ");
    yk_report_amount(report, text, fabs(end) > 1.000001 * fabs(off) ? end : 0, YK_QUANTITY_ENERGY); // else noise
    for (size_t k = 0; k < yk_simulation_work_count(report->simulation) && told < WORKS_MAX; k++) {
        double work = yk_simulation_work(report->simulation, k);
        if (work == 0) continue;
        yk_text_format(text, "%s%s does ", told == 0 ? ": " : ", ", yk_simulation_work_name(report->simulation, k));
        yk_report_amount(report, text, work, YK_QUANTITY_ENERGY);
        told++;
    }
    yk_text_puts(text, told > 0 ? " of work." : ".");
    yk_text_puts(text, " Over the whole motion the balance of energy is off by ");
    yk_report_error(text, summary.energy_error);
    yk_text_puts(text, " of the largest energy.");
    yk_report_find(report, YK_FINDING_FACT, text);
}

// Returns whether it is at rest at the start, with nothing that would move it then or later. From an unstable
// equilibrium rounding alone may move it.
static bool rests(const YkReportPage *report)
{
    for (size_t c = 0; c < report->column_count; c++) {
        const YkReportColumn *column = &report->columns[c];
        if (column->role != YK_ROLE_COORDINATE || report->row_count == 0) continue;
        bool is_length = yk_coordinate_info(report->mech, column->of).is_distance;
        double scale = is_length ? yk_mechanism_size(report->mech) : 1, start = yk_report_value(report, 0, c);
        if (column->channel.order == 1 && start != 0) return false;
        if (column->channel.order == 2 && fabs(start) > still * scale) return false;
        for (size_t row = 1; column->channel.order == 0 && row < report->row_count; row++)
            if (fabs(yk_report_value(report, row, c) - start) > stays * scale) return false;
    }
    return report->row_count > 0;
}

void yk_findings_simulation(YkReportPage *report, YkText *text)
{
    if (report->motion.kind != YK_REPORT_SIMULATION) return;
    if (!report->simulation) {
        yk_text_format(text, "It cannot be released: %s.", report->motion_message);
        yk_report_find(report, YK_FINDING_LOOK, text);
        return;
    }
    if (report->motion_status < 0 || report->motion_status == YK_SINGULAR) {
        yk_text_puts(text, "The motion ends at t = ");
        yk_report_amount(report, text, yk_simulation_time(report->simulation), YK_QUANTITY_TIME);
        yk_text_format(text, ": %s.", report->motion_message);
        yk_report_find(report, YK_FINDING_LOOK, text);
    }
    if (rests(report)) {
        yk_text_puts(text, "Released at its start it stays there: it is in equilibrium.");
        yk_report_find(report, YK_FINDING_FACT, text);
        return;
    }
    find_happenings(report, text);
    find_energy(report, text);
}
