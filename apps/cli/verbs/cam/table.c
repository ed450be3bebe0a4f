// Makes the rows of `yoke cam`, whatever the format.
#include "verbs/cam/cam.h"

static const double full_turn = 6.28318530717958647692;

YkQuantity yk_cam_lift_quantity(const YkCamAnswer *answer)
{
    return answer->size.oscillates ? YK_QUANTITY_ANGLE : YK_QUANTITY_LENGTH;
}

typedef struct Columns {
    YkCamColumn *items;
    size_t count;
} Columns;

static void add(Columns *columns, const char *name, YkQuantity quantity, int order)
{
    columns->items[columns->count++] = (YkCamColumn){name, quantity, order};
}

size_t yk_cam_columns(const YkCamAnswer *answer, YkCamColumn columns[YK_CAM_COLUMNS_MAX])
{
    static const char *const lifts[] = {"s", "v", "a", "j", "p"};
    static const char *const lengths[] = {"pitch_radius", "surface_radius", "x", "y", "pitch.x", "pitch.y"};
    Columns all = {.items = columns};
    add(&all, "angle", YK_QUANTITY_ANGLE, 0);
    for (int k = 0; k < 5; k++) add(&all, lifts[k], yk_cam_lift_quantity(answer), k);
    add(&all, "pressure_angle", YK_QUANTITY_ANGLE, 0);
    for (int i = 0; i < 6; i++) add(&all, lengths[i], YK_QUANTITY_LENGTH, 0);
    if (answer->size.face == YK_CAM_FACE_FLAT) add(&all, "reach", YK_QUANTITY_LENGTH, 0);
    if (answer->size.is_groove) {
        add(&all, "groove.x", YK_QUANTITY_LENGTH, 0);
        add(&all, "groove.y", YK_QUANTITY_LENGTH, 0);
    }
    if (answer->cutter > 0) {
        add(&all, "cutter.x", YK_QUANTITY_LENGTH, 0);
        add(&all, "cutter.y", YK_QUANTITY_LENGTH, 0);
    }
    if (answer->has_forces) {
        add(&all, "contact_force", YK_QUANTITY_FORCE, 0);
        add(&all, "torque", YK_QUANTITY_TORQUE, 0);
    }
    return all.count;
}

void yk_cam_row(const YkCamAnswer *answer, double angle, double values[YK_CAM_COLUMNS_MAX])
{
    YkCamPoint p = yk_cam_at(answer->design, angle);
    size_t n = 0;
    values[n++] = angle;
    for (int k = 0; k < 5; k++) values[n++] = p.lift[k];
    values[n++] = p.pressure_angle;
    values[n++] = p.pitch_radius;
    values[n++] = p.surface_radius;
    for (int i = 0; i < 2; i++) values[n++] = p.surface[i];
    for (int i = 0; i < 2; i++) values[n++] = p.pitch[i];
    if (answer->size.face == YK_CAM_FACE_FLAT) values[n++] = p.reach;
    for (int i = 0; i < 2 && answer->size.is_groove; i++) values[n++] = p.outer[i];
    for (int i = 0; i < 2 && answer->cutter > 0; i++) values[n++] = p.surface[i] + answer->cutter * p.normal[i];
    if (!answer->has_forces) return;
    YkCamForce force = yk_cam_force(answer->design, answer->speed, angle);
    values[n++] = force.contact;
    values[n++] = force.torque;
}

double yk_cam_row_angle(const YkCamAnswer *answer, size_t row)
{
    return full_turn * (double)row / (double)answer->steps;
}

void yk_cam_unit(const YkCamAnswer *answer, const YkCamColumn *column, YkText *unit)
{
    yk_text_puts(unit, yk_unit_of(answer->session, column->quantity));
    if (column->order > 0) yk_text_puts(unit, "/rad");
    if (column->order > 1) yk_text_format(unit, "^%d", column->order);
}
