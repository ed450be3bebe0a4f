// Panels: which columns share a diagram.
#ifndef REPORT_PANELS_H
#define REPORT_PANELS_H
#include "report/report.h"

enum { YK_PANEL_COLUMNS_MAX = 16 };
typedef struct YkPanel {
    const char *id, *title;
    YkQuantity quantity;
    size_t columns[YK_PANEL_COLUMNS_MAX]; // of the report
    size_t count;
} YkPanel;

// Finds the panels that have something to show, at most `capacity`; none if there are no rows.
size_t yk_report_panels(const YkReportPage *report, YkPanel *panels, size_t capacity);
enum { YK_PANELS_MAX = 12 };

#endif
