// Decides which columns share a diagram.
#include "report/panels.h"
#include <math.h>

// A panel shows one role in one quantity.
typedef struct Kind {
    YkReportRole role;
    YkQuantity quantity;
    const char *id, *title;
} Kind;

static const Kind kinds[] = {
    {YK_ROLE_COORDINATE, YK_QUANTITY_ANGLE, "angles", "Angles"},
    {YK_ROLE_COORDINATE, YK_QUANTITY_LENGTH, "distances", "Distances"},
    {YK_ROLE_COORDINATE, YK_QUANTITY_ANGLE_RATE, "angular-velocities", "Angular velocities"},
    {YK_ROLE_COORDINATE, YK_QUANTITY_SPEED, "velocities", "Velocities"},
    {YK_ROLE_COORDINATE, YK_QUANTITY_ANGLE_ACCELERATION, "angular-accelerations", "Angular accelerations"},
    {YK_ROLE_COORDINATE, YK_QUANTITY_ACCELERATION, "accelerations", "Accelerations"},
    {YK_ROLE_TRANSMISSION, YK_QUANTITY_ANGLE, "transmission", "Transmission angles"},
    {YK_ROLE_EFFORT, YK_QUANTITY_TORQUE, "torques", "Torques along coordinates"},
    {YK_ROLE_EFFORT, YK_QUANTITY_FORCE, "efforts", "Forces along coordinates"},
    {YK_ROLE_REACTION, YK_QUANTITY_FORCE, "reactions", "Forces in the joints"},
    {YK_ROLE_ENERGY, YK_QUANTITY_ENERGY, "energy", "Energy"},
    {YK_ROLE_SHAKING, YK_QUANTITY_FORCE, "frame", "Force on the frame"},
};

// Returns whether a column has a finite value and is not 0 throughout; others would only fill the page.
static bool is_worth_showing(const YkReportPage *report, size_t column)
{
    for (size_t row = 0; row < report->row_count; row++) {
        double value = yk_report_value(report, row, column);
        if (isfinite(value) && value != 0) return true;
    }
    return false;
}

size_t yk_report_panels(const YkReportPage *report, YkPanel *panels, size_t capacity)
{
    size_t count = 0;
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds && count < capacity && report->row_count > 1; k++) {
        YkPanel *panel = &panels[count];
        *panel = (YkPanel){.id = kinds[k].id, .title = kinds[k].title, .quantity = kinds[k].quantity};
        for (size_t c = 0; c < report->column_count && panel->count < YK_PANEL_COLUMNS_MAX; c++) {
            const YkReportColumn *column = &report->columns[c];
            bool is_axis = column->role == YK_ROLE_COORDINATE && (int)column->of == report->motion.coordinate &&
                           column->channel.order == 0;
            if (column->role == kinds[k].role && column->channel.quantity == kinds[k].quantity && !is_axis &&
                is_worth_showing(report, c))
                panel->columns[panel->count++] = c;
        }
        count += panel->count > 0;
    }
    return count;
}
