// The answer of `yoke cam`, and its writers.
#ifndef CLI_CAM_H
#define CLI_CAM_H
#include "answer.h"

enum { YK_CAM_STROKES_MAX = 64, YK_CAM_LAWS_MAX = 16, YK_CAM_COLUMNS_MAX = 24, YK_CAM_JUMPS_MAX = 64 };

typedef struct YkCamOther { // a law instead of the file's
    const char *law;
    YkCamDesign *design;
    YkCamSummary summary;
    YkCamFactors factors;
} YkCamOther;

typedef struct YkCamAnswer {
    YkSession *session;
    YkCamDesign *design;
    YkCamSize size;
    YkCamSummary summary, second; // second: of a conjugate pair
    YkCamStroke strokes[YK_CAM_STROKES_MAX];
    size_t stroke_count;
    YkCamLimits limits;
    YkStatus base_status;
    YkCamBase base;
    double speed; // rad/s; 0: not known
    double tolerance, cutter;
    bool has_forces;
    YkCamLoads loads;
    YkCamForceSummary forces;
    YkCamOther others[YK_CAM_LAWS_MAX];
    size_t other_count;
    size_t steps; // of the table; 0: no table
} YkCamAnswer;

// Makes the rows of the table: names, quantities and values of all columns. Returns the number of columns.
typedef struct YkCamColumn {
    const char *name;
    YkQuantity quantity; // of lifts: that of the lift; see order
    int order;           // derivative to the cam's angle: the unit is divided by rad^order
} YkCamColumn;
size_t yk_cam_columns(const YkCamAnswer *answer, YkCamColumn columns[YK_CAM_COLUMNS_MAX]);
void yk_cam_row(const YkCamAnswer *answer, double angle, double values[YK_CAM_COLUMNS_MAX]);
double yk_cam_row_angle(const YkCamAnswer *answer, size_t row);
YkQuantity yk_cam_lift_quantity(const YkCamAnswer *answer);
// Writes "mm/rad^2", the unit of a column, into `unit`.
void yk_cam_unit(const YkCamAnswer *answer, const YkCamColumn *column, YkText *unit);

void yk_cam_text(const YkCamAnswer *answer);
void yk_cam_json(const YkCamAnswer *answer);
void yk_cam_csv(const YkCamAnswer *answer);
// Plots s, v, a, j and the pressure angle over the cam's angle. Returns false with a problem added.
bool yk_cam_plot(const YkCamAnswer *answer, const char *path);
// Writes the outline to scale. Returns false with a problem added.
bool yk_cam_write_profile(const YkCamAnswer *answer, const char *path);

#endif
