// Values, angles, speeds and tables of `yoke cam`, as people read them.
#include "base/number.h"
#include "verbs/cam/text.h"
#include "write/table.h"

static const double to_rpm = 9.5492965855137201;

void yk_cam_number(YkText *text, double value)
{
    char digits[YK_NUMBER_SIZE];
    yk_text_add(text, digits, yk_number_write_digits(value, YK_DIGITS, digits));
}

void yk_cam_value(const YkCamAnswer *answer, double of, YkQuantity quantity)
{
    yk_add_value(answer->session, &answer->session->out, of, quantity, YK_DIGITS);
}

void yk_cam_at_angle(const YkCamAnswer *answer, double angle)
{
    yk_text_puts(&answer->session->out, " at ");
    yk_cam_value(answer, angle, YK_QUANTITY_ANGLE);
}

void yk_cam_speed(const YkCamAnswer *answer, double speed)
{
    YkText *out = &answer->session->out;
    yk_cam_number(out, speed * to_rpm);
    yk_text_puts(out, " rpm (");
    yk_cam_value(answer, speed, YK_QUANTITY_ANGLE_RATE);
    yk_text_puts(out, ")");
}

void yk_cam_table(YkText *out, YkTable *table)
{
    yk_table_write(table, 2, out);
    yk_table_free(table);
}
