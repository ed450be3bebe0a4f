// Private functions of the files that write `yoke cam` for people.
#ifndef CLI_CAM_TEXT_H
#define CLI_CAM_TEXT_H
#include "verbs/cam/cam.h"
#include "write/table.h"

void yk_cam_number(YkText *text, double value);
void yk_cam_value(const YkCamAnswer *answer, double of, YkQuantity quantity); // with its unit, to the answer
void yk_cam_at_angle(const YkCamAnswer *answer, double angle);                // " at 30 deg"
void yk_cam_speed(const YkCamAnswer *answer, double speed);                   // "60 rpm (6.28 rad/s)"
void yk_cam_table(YkText *out, YkTable *table);                               // writes and frees it

// text_geometry.c
void yk_cam_add_geometry(const YkCamAnswer *answer, const YkCamSummary *s, const char *title);
void yk_cam_add_base(const YkCamAnswer *answer);
void yk_cam_add_forces(const YkCamAnswer *answer);
// text_tables.c
void yk_cam_add_others(const YkCamAnswer *answer);
void yk_cam_add_rows(const YkCamAnswer *answer);

#endif
