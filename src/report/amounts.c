// Amounts in sentences and tables, in the file's units.
#include <string.h>
#include "base/number.h"
#include "base/vec.h"
#include "report/report.h"
#include "write/amount.h"

enum { DIGITS = 5 };

const char *yk_report_axis(const YkReportPage *report)
{
    bool is_sweep = report->motion.kind == YK_REPORT_TURN || report->motion.kind == YK_REPORT_RANGE;
    return is_sweep ? yk_coordinate_info(report->mech, (size_t)report->motion.coordinate).name : "t";
}

YkQuantity yk_report_axis_quantity(const YkReportPage *report)
{
    bool is_sweep = report->motion.kind == YK_REPORT_TURN || report->motion.kind == YK_REPORT_RANGE;
    if (!is_sweep) return YK_QUANTITY_TIME;
    bool is_distance = yk_coordinate_info(report->mech, (size_t)report->motion.coordinate).is_distance;
    return is_distance ? YK_QUANTITY_LENGTH : YK_QUANTITY_ANGLE;
}

// Angles are in degrees if the file has radians, since they are easier to read.
const char *yk_report_unit(const YkReportPage *report, YkQuantity quantity, double *size)
{
    double own = 1;
    const char *unit = yk_model_shown_unit(report->model, quantity, &own);
    bool is_radian = quantity == YK_QUANTITY_ANGLE && strcmp(unit, "rad") == 0;
    if (size) *size = is_radian ? YK_PI / 180 : own;
    return is_radian ? "deg" : unit;
}

double yk_report_in_unit(const YkReportPage *report, double value, YkQuantity quantity)
{
    double own = 1, size = 1;
    yk_model_shown_unit(report->model, quantity, &own);
    yk_report_unit(report, quantity, &size);
    return yk_amount_in_unit(report->model, report->mech, value, quantity) * (own == size ? 1 : own / size);
}

void yk_report_error(YkText *text, double value)
{
    char number[YK_NUMBER_SIZE];
    yk_text_add(text, number, yk_number_write_digits(value, 2, number));
}

void yk_report_amount(const YkReportPage *report, YkText *text, double value, YkQuantity quantity)
{
    char number[YK_NUMBER_SIZE];
    const char *unit = yk_report_unit(report, quantity, NULL);
    yk_text_add(text, number, yk_number_write_digits(yk_report_in_unit(report, value, quantity), DIGITS, number));
    if (*unit) yk_text_format(text, " %s", unit);
}

void yk_report_amount_at(const YkReportPage *report, YkText *text, double at)
{
    yk_text_format(text, "%s = ", yk_report_axis(report));
    yk_report_amount(report, text, at, yk_report_axis_quantity(report));
}
